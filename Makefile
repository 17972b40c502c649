# `make` alone lists the targets. Everything is built by cargo; nothing else is needed.

# Plain tests and the tests that need more (the network, a run of every study) share the test profile, so that
# `make test`, `make fresh` and `make licences` build once.

.PHONY: help figures test lint fresh licences schema

help: ## this list
	@sed -n 's/^\([a-z]*\):.*## /  make \1|/p' Makefile | awk -F'|' '{ printf "%-16s %s\n", $$1, $$2 }'

figures: ## run every study in studies/, write tables and pictures to figures/
	cargo run --release --locked -- run

# The tests come last, so that their summary ends the output.
test: ## hold the studies to their checks, run all tests
	cargo run --locked -- check
	cargo test --locked

lint: ## formatting, clippy and documentation without warnings
	cargo fmt --check
	cargo clippy --locked --all-targets -- -D warnings
	RUSTDOCFLAGS="-D warnings" cargo doc --locked --no-deps

fresh: ## compare committed tables, pictures and schema with what is written now
	cargo test --locked --test fresh -- --ignored

licences: ## hold the licences of all dependencies to the list allowed
	cargo test --locked --test licences -- --ignored

# Built first: a build that fails must not leave an empty schema behind.
schema: ## write schema/study.json, which editors read
	cargo build --release --locked
	mkdir -p schema
	cargo run --release --locked --quiet -- schema > schema/study.json
