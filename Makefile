# `make` alone lists the targets. Everything is built by cargo; nothing else is needed.

# Tests run in a build that stops at an overflow. What computes all studies runs the release build, which is compiled once, without what
# only tests need.

built = $(or $(CARGO_TARGET_DIR),target)
debug = $(built)/debug
released = SLIPGAP_PROGRAM=$(abspath $(built))/release/slipgap
# Where `make fresh` and `make test` run all studies. `make test` does not compute again what `make figures` has computed.
fresh = $(built)/tmp/fresh

.PHONY: help figures report test lint fresh licences schema bench guard peers speed maps mutants fuzz torture slurm-test slurm-long recipes python-test wheel

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## /  make \1|/p' Makefile | awk -F'|' '{ printf "%-18s %s\n", $$1, $$2 }'

figures: ## run every study in studies/, judge the claims, write tables, pictures and claims.md to figures/
	cargo run --release --locked -- run
	cargo run --release --locked -- claims

report: ## one page about all studies, figures/report.html: tables to sort and filter, figures with values on hover
	cargo run --release --locked -- report

# The tests come last, so that their summary ends the output. `--workspace` builds no more, but all with the same features of the
# crates below, so that the library is compiled once for all tests and for the Python package.
test: ## check results and verdicts against recorded values, run all tests
	cargo build --release --locked
	cargo build --locked --workspace --examples
	mkdir -p $(fresh) && cp -R figures/. $(fresh)
	$(released) cargo test --locked --workspace --test shipped -- --ignored --test-threads 1
	for example in one_case sweep figure own_metric; do $(debug)/examples/$$example > target/$$example.txt || exit 1; done
	cargo test --locked --workspace

# All packages at once, so that each crate is checked once. As an extension, the Python package is checked without Python, too.
lint: ## formatting, clippy and documentation without warnings
	cargo fmt --all --check
	PYO3_BUILD_EXTENSION_MODULE=1 cargo clippy --locked --workspace --all-targets -- -D warnings
	RUSTDOCFLAGS="-D warnings" cargo doc --locked --no-deps

fresh: ## compare committed tables, pictures and schema with what is written now
	cargo build --release --locked
	$(released) cargo test --locked --workspace --test fresh -- --ignored

licences: ## check that the licences of all dependencies are in the list allowed
	cargo test --locked --workspace --test licences -- --ignored

bench: ## measure sweeps, expansion and store; not part of CI, since no test measures time
	cargo bench --locked --bench kernel --bench expansion --bench store --bench explain

guard: ## compare the instruction counts of sweeps with recorded ones (needs valgrind), and test the gain of lanes
	cargo build --release --locked
	cargo run --release --locked --quiet --package slipgap-guard

# OpenSees needs the system's BLAS and LAPACK (Debian: libblas3, liblapack3).
peers: ## the same sweeps, girders with contacts and large models by slipgap and other programs, in tables
	benches/peers/run

# With PROGRAM=path, the times of another build beside it.
speed: ## whole runs beside loops by numba, written to docs/performance.md with the name of the machine
	benches/peers/run speed $(PROGRAM)

maps: ## the sensitivity maps with a thousand cases along each axis, in docs/maps/
	cargo run --release --locked -- run docs/maps/*.json --out target/maps
	for map in target/maps/*/*.png; do cp $$map docs/maps/$$(basename $$(dirname $$map))-$$(basename $$map); done

# A short form is among the tests. SLIPGAP_FUZZ_SECONDS sets how long (300), SLIPGAP_FUZZ_SEED repeats a run.
fuzz: ## read, list, solve and draw random and randomly changed studies, for minutes
	cargo test --locked --test fuzz -- --ignored --nocapture

# Random kills, kills and errors at every system call (with strace), full disks, damaged stores, processes together,
# 1 to 16 threads. Minutes, and not part of CI, which runs the short forms; TORTURE=10 takes ten times as long.
torture: ## kill and disturb runs in many ways, and check that the next run gives the same bytes
	cargo test --locked --test torture -- --ignored --nocapture --test-threads 2

# The daemons run in a temporary folder with free ports; nothing is written elsewhere. Debian: apt-get install
# --no-install-recommends slurm-wlm munge. Without them the test says that it did not run.
slurm-test: ## shards as a Slurm array on four virtual nodes: killed, requeued, preempted and cancelled tasks, then the merge
	cargo test --locked --workspace --test slurm -- --ignored --nocapture killed_

# Ten minutes on two cores and 2 GB of disk, and not part of CI. docs/clusters.md has what it printed.
slurm-long: ## 10^7 cases in a hundred shards on the virtual nodes, many of them killed: nothing is lost (needs Slurm)
	cargo build --release --locked
	$(released) cargo test --locked --workspace --test slurm -- --ignored --nocapture ten_million

# The engines that PyPI has are installed into a folder of their own; GNU parallel is in Debian (parallel). Nextflow is in neither.
recipes_env = target/recipes
recipes: ## the recipes of docs/clusters.md with GNU parallel, HyperQueue, Snakemake, Dask (and Nextflow, if it is installed)
	$(recipes_env)/bin/python -c "import snakemake, distributed, hyperqueue" 2> /dev/null || { $(PYTHON) -m venv $(recipes_env) && $(recipes_env)/bin/pip install --quiet snakemake "dask[distributed]" hyperqueue; } \
	  || echo "no packages to be had: only engines that are installed are tried"
	PATH="$(CURDIR)/$(recipes_env)/bin:$$PATH" cargo test --locked --workspace --test recipes -- --ignored --nocapture

# Days on two cores for all parts (tests/mutants.md has the number of changes of each), and not part of CI. `make mutants PART=batch`
# changes one part, and `make mutants PART=study ONLY=axis_rule` those of its lines as `cargo mutants --list` names them that match a
# pattern. What survives is explained in tests/mutants.md; lists of what was caught and missed are in target/mutants/PART/.
PART = numbers structures events problem batch run study figures claims recommend
ONLY = .
motion = crates/motion/src
system = crates/system/src
changed_numbers = -f 'crates/contact/src/**' -f '$(motion)/**' -f '$(system)/**' -f 'crates/problem/src/metrics/**' -e '$(motion)/exact/events/**' \
  -e '$(motion)/solve/structure/**' -e '$(system)/system/structure/**' -e '$(system)/system/loads/**'
noticed_numbers = --test numbers
changed_structures = -f '$(motion)/solve/structure/**' -f '$(system)/system/structure/**' -f '$(system)/system/loads/**'
noticed_structures = --test numbers
changed_events = -f '$(motion)/exact/events/**'
noticed_events = --test numbers
changed_problem = -f 'crates/problem/src/problem/**'
noticed_problem = --test numbers --test studies
changed_run = -f 'src/run/**'
noticed_run = --test command_line
changed_batch = -f 'src/batch/**' -f 'crates/statistics/src/**' -f 'src/compare/**'
noticed_batch = --test command_line
changed_study = -f 'crates/study/src/**' -e 'crates/study/src/describe/**'
noticed_study = --test studies --test command_line
changed_figures = -f 'crates/figures/src/**' -f 'crates/drawing/src/**'
noticed_figures = --test report
changed_claims = -f 'validation/src/**' -f src/checks.rs
noticed_claims = --test command_line --test studies
changed_recommend = -f 'crates/recommend/src/**'
noticed_recommend = --test recommend
# As arguments of cargo, so that no other tests are compiled after each change.
changes = cargo mutants --workspace --test-workspace=true --output target/mutants/$(1) $(changed_$(1)) --re '$(ONLY)' $(addprefix --cargo-arg=,--lib $(noticed_$(1)))

# 2: something survived, 3: something ran into its time limit; the next part all the same.
mutants: ## change the code of every part in every small way; a test must fail for each change
	cargo mutants --version || cargo install --locked cargo-mutants
	mkdir -p $(PART:%=target/mutants/%)
	@set -x; $(foreach part,$(PART),$(call changes,$(part)) || test $$? -le 3 || exit 1;)

# Built first: a build that fails must not leave an empty schema behind.
schema: ## write schema/study.json, which editors read, and docs/study-files*.md
	cargo build --release --locked
	mkdir -p schema
	cargo run --release --locked --quiet -- schema > schema/study.json
	cargo run --release --locked --quiet -- schema --markdown > docs/study-files.md
	for problem in friction-oscillator bar-impact structure; do \
	  cargo run --release --locked --quiet -- schema --markdown $$problem > docs/study-files-$$problem.md || exit 1; done

PYTHON = python3
python_env = target/python
python_tools = pytest mypy numpy pandas polars pyarrow xarray duckdb scipy joblib matplotlib tqdm nbclient nbformat ipykernel jsonschema

# The extension is built for development, as `maturin develop` does, but with the library that the other tests have compiled.
# SLIPGAP_ALL_STUDIES=1 compares all shipped studies with the program, not a part of them.
python-test: ## the Python package: its functions, types, notebooks, and the same bytes as the program
	$(python_env)/bin/python -c "import pytest, xarray, joblib" 2> /dev/null || { $(PYTHON) -m venv $(python_env) && $(python_env)/bin/pip install --quiet $(python_tools); }
	$(python_env)/bin/pip install --quiet openseespy || echo "no openseespy: the export of its models is not tested"
	PYO3_BUILD_EXTENSION_MODULE=1 cargo build --locked --workspace --lib --bins --tests
	cp $(debug)/lib_slipgap.so python/slipgap/_slipgap.abi3.so
	echo $(CURDIR)/python > $$($(python_env)/bin/python -c "import sysconfig; print(sysconfig.get_path('purelib'))")/slipgap.pth
	$(python_env)/bin/pytest --quiet python/tests

# The oldest C library that the wheel works with is that of manylinux 2.17. The linker of Zig, which comes from PyPI, knows it. The
# program and the extension have the same linker and the same packages, so that cargo compiles once what both need.
wheel_env = target/wheel
wheel_target = x86_64-unknown-linux-gnu
wheel_options = --release --locked --target $(wheel_target)
wheel: export CARGO_TARGET_X86_64_UNKNOWN_LINUX_GNU_LINKER = $(CURDIR)/$(wheel_env)/linker
wheel: ## a Python wheel for Linux with the program in it, in target/wheels, tested in a fresh environment
	test -x $(wheel_env)/bin/maturin || { $(PYTHON) -m venv $(wheel_env) && $(wheel_env)/bin/pip install --quiet maturin ziglang; }
	printf '#!/bin/sh\nexec maturin zig cc -- -target x86_64-linux-gnu.2.17 "$$@"\n' > $(wheel_env)/linker && chmod +x $(wheel_env)/linker
	. $(wheel_env)/bin/activate && cargo build $(wheel_options) --package slipgap --package slipgap-python --bin slipgap
	mkdir -p python/slipgap._slipgap.data/scripts && cp target/$(wheel_target)/release/slipgap python/slipgap._slipgap.data/scripts/
	rm -rf target/wheels
	. $(wheel_env)/bin/activate && cd python && maturin build $(wheel_options) --compatibility manylinux2014 --out ../target/wheels
	rm -rf python/slipgap._slipgap.data target/wheel-test
	$(PYTHON) -m venv target/wheel-test && target/wheel-test/bin/pip install --quiet target/wheels/*.whl
	target/wheel-test/bin/python python/tests/wheel.py
