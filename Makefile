# Two commands need nothing but Python 3.11 or later with pip: `make demo` and `make test`.
# They install uv (pinned) in .uv/ and the locked dependencies in .venv/, once; later runs need no network.

.DEFAULT_GOAL := help
SHELL := /bin/sh
UV_VERSION := 0.13.9
UV := .uv/$(UV_VERSION)
INSTALLED := .venv/.installed
RUN := .venv/bin/python -m

SUITABLE := import sys, pip; sys.exit(sys.version_info < (3, 11))
PYTHON ?= $(shell for p in python3.11 python3 python3.12 python3.13 python; do \
	$$p -c '$(SUITABLE)' >/dev/null 2>&1 && { echo $$p; break; }; done)

# The environment is this folder's own, whatever the caller's shell has activated.
unexport VIRTUAL_ENV UV_PROJECT_ENVIRONMENT UV_PROJECT PYTHONPATH PYTHONHOME
# Where Python may not keep what it has compiled, every process compiles all of its libraries anew.
unexport PYTHONDONTWRITEBYTECODE
export UV_PYTHON_DOWNLOADS := never
export UV_NO_PROGRESS := 1
export UV_SYSTEM_CERTS ?= $(if $(wildcard /etc/ssl/certs/*),true,false)
export PIP_USER := 0
export PIP_REQUIRE_VIRTUALENV := 0
export PIP_DISABLE_PIP_VERSION_CHECK := 1
export PIP_ROOT_USER_ACTION := ignore

# Caches of uv, Numba and Matplotlib live in the home folder; an account without one gets one here.
ifeq ($(shell test -d "$$HOME" && test -w "$$HOME" && echo yes),)
export HOME := $(CURDIR)/.home
endif

.PHONY: help install demo test browser test-slow chaos lint format client generated verify article bench bench-programme bench-rolland screenshots serve clean

help:  ## list the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / {printf "  make %-16s %s\n", $$1, $$2}' Makefile

install: $(INSTALLED)  ## install the locked dependencies in .venv/

demo: $(INSTALLED)  ## serve, run a small study over HTTP, print and draw its peaks
	@$(RUN) examples.demo

test: lint browser  ## lint, types and every test that is not slow
	@$(RUN) pytest -m "not slow" -n 3 --dist loadfile --no-loadscope-reorder

browser: $(INSTALLED)
	@$(RUN) tests.web.browser

test-slow: $(INSTALLED)  ## the proofs that take long
	@$(RUN) pytest -m slow

CHAOS_SEEDS ?= 1 2 3 4
CHAOS_FAULTS ?= 75

chaos: $(INSTALLED)  ## break the service hundreds of times on each database, and write docs/reliability.md
	@rm -rf chaos
	@for database in sqlite postgresql $$(test $$(id -u) = 0 && echo hosts); do for seed in $(CHAOS_SEEDS); do \
		$(RUN) tests.chaos run chaos/$$database-$$seed.jsonl --database $$database --seed $$seed --faults $(CHAOS_FAULTS); done; done
	@for control in no-tokens no-expiry; do \
		$(RUN) tests.chaos run chaos/$$control.jsonl --database postgresql --faults 20 --control $$control; done
	@$(RUN) tests.chaos report chaos/*.jsonl --out docs/reliability.md

lint: $(INSTALLED)  ## ruff, mypy and the import contracts
	@$(RUN) ruff check
	@$(RUN) ruff format --check
	@$(RUN) mypy
	@.venv/bin/lint-imports

format: $(INSTALLED)  ## let ruff format and fix what it can
	@$(RUN) ruff format
	@$(RUN) ruff check --fix

client: $(INSTALLED)  ## write openapi.json, generate the client from it, and build its wheel in dist/
	@.venv/bin/tracksweep openapi > openapi.json.new && mv openapi.json.new openapi.json
	@$(MAKE) --no-print-directory generated
	@cd client && ../.venv/bin/python -m hatchling build -t wheel -d ../dist

GENERATED := client/tracksweep_client/generated

generated: $(INSTALLED)
	@rm -rf $(GENERATED)
	@PATH="$(CURDIR)/.venv/bin:$$PATH" openapi-python-client generate --path openapi.json --config client/generator.yaml \
		--meta none --output-path $(GENERATED) --fail-on-warning

verify: $(INSTALLED)  ## check the physics and write docs/verification.md
	@.venv/bin/tracksweep verify

article: $(INSTALLED)  ## compute the article's studies by a service, and write docs/article.md
	@.venv/bin/tracksweep article

bench: $(INSTALLED)  ## time the solver and the service, and write benchmarks/README.md
	@$(RUN) benchmarks

bench-programme: $(INSTALLED)  ## time the article's whole programme, which takes long
	@$(RUN) benchmarks.programme
	@$(RUN) benchmarks.report

bench-rolland: $(INSTALLED) .venv-rolland/.installed  ## time beside rolland, which needs Python 3.12 and is installed for it
	@$(RUN) benchmarks.rolland_peer .venv-rolland/bin/python
	@$(RUN) benchmarks.report

screenshots: $(INSTALLED) browser  ## look at the page in a browser, and write docs/screenshots
	@$(RUN) tests.web.screenshots

serve: $(INSTALLED)  ## run the whole service on the folder data/
	@.venv/bin/tracksweep serve

clean:  ## remove what was installed and generated; data/ stays
	rm -rf .uv .venv .venv-rolland .browsers .home demo .hypothesis .import_linter_cache .mypy_cache .pytest_cache .ruff_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

$(UV)/bin/uv:
	@test -n "$(PYTHON)" || { echo "Python 3.11 or later with pip is needed; name one by make PYTHON=..." >&2; exit 1; }
	@echo "Installing uv $(UV_VERSION) in $(UV) ..."
	@$(PYTHON) -m pip install --quiet --upgrade --target $(UV) uv==$(UV_VERSION)

$(INSTALLED): pyproject.toml uv.lock | $(UV)/bin/uv
	@echo "Installing the locked dependencies in .venv ..."
	@$(UV)/bin/uv sync --frozen --quiet --python "$$($(PYTHON) -c 'import sys; print(sys.executable)')"
	@touch $@

PYTHON312 ?= python3.12

.venv-rolland/.installed: | $(UV)/bin/uv
	@$(PYTHON312) -c 'import sys; sys.exit(sys.version_info[:2] != (3, 12))' >/dev/null 2>&1 || \
		{ echo "rolland needs Python 3.12; name one by make bench-rolland PYTHON312=..." >&2; exit 1; }
	@$(UV)/bin/uv venv --quiet --clear --python "$$($(PYTHON312) -c 'import sys; print(sys.executable)')" .venv-rolland
	@$(UV)/bin/uv pip install --quiet --python .venv-rolland rolland==26.8
	@touch $@
