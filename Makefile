# `make run` starts the program, `make test` runs every check; both first set up what they lack.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.NOTPARALLEL:

PORT ?= 8000
BIN := .venv/bin
# The newest Python that will do; `make run PYTHON=/path/to/python3.12` chooses another.
PYTHON ?= $(firstword $(foreach name,python3 python3.13 python3.12 python3.11,\
	$(shell $(name) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo $(name))))

NODE_IS_NEW := const [a, b] = process.versions.node.split("."); process.exitCode = a > 20 || (a == 20 && b >= 19) ? 0 : 1

# Stamps: a step runs again only when what it was made from is newer.
INSTALLED := .venv/.installed
COMPILED := .venv/.compiled
INSTALLED_FOR_TESTS := .venv/.installed-for-tests
NODE_MODULES := node_modules/.package-lock.json
SCANS := web/public/rooms/scans/scan-living-room.json
PAGE := web/dist/index.html
PAGE_SOURCES := $(shell find web/src web/public web/*.html -type f -not -path '*/scans/*' 2>/dev/null) \
	package.json vite.config.ts tsconfig.json

.PHONY: help
help:  ## show this list
	@sed -nE 's/^([a-z]+):.*## (.*)/  make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 18

.PHONY: run
run: $(INSTALLED) $(PAGE) $(COMPILED)  ## start SceneGen on http://localhost:8000 (PORT=9000, for phones: LAN=1)
	@exec $(BIN)/scenegen serve --port $(PORT) $(if $(LAN),--lan)

.PHONY: page
page: $(PAGE)  ## build the page into web/dist

.PHONY: knowledge
knowledge: $(INSTALLED)  ## learn the knowledge that ships again, from DATA="one.jsonl.gz two.jsonl.gz"
	@[ -n "$(DATA)" ] || { \
		echo 'Name the files of rooms: make knowledge DATA="one.jsonl.gz two.jsonl.gz"' >&2; exit 1; }
	$(BIN)/scenegen learn $(DATA) --out scenegen_core/knowledge/default.npz

.PHONY: test
test: $(INSTALLED_FOR_TESTS) $(PAGE) browser  ## format, lint, types, unit and browser tests
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	npm run --silent lint
	$(BIN)/mypy
	npm run --silent check
	npm run --silent test
	$(BIN)/python -m server.typescript --check
	$(BIN)/pytest

.PHONY: bench
bench: $(INSTALLED_FOR_TESTS) $(PAGE) browser  ## measure how fast it is; results in benchmarks/results
	@for what in placing limits following dragging serving; do \
	    PYTHONPATH=. $(BIN)/python benchmarks/$$what.py > benchmarks/results/$$what.md || exit 1; \
	    cat benchmarks/results/$$what.md; \
	done

.PHONY: browser
browser: $(INSTALLED_FOR_TESTS)
	@if command -v chromium chromium-browser google-chrome >/dev/null; then :; \
	elif [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
		apt-get -qq update && DEBIAN_FRONTEND=noninteractive \
		apt-get -qq install -y --no-install-recommends chromium; \
	else $(BIN)/playwright install chromium; fi

# What only the machine can give, asked for before anything is set up.
.PHONY: tools
tools:
	@[ -n "$(PYTHON)" ] || { \
		echo 'SceneGen needs Python 3.11 or newer; install it and run make again.' >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { \
		echo 'Python cannot make a virtual environment here; install it (Debian, Ubuntu:' \
		'apt-get install python3-venv) and run make again.' >&2; exit 1; }
	@node -e '$(NODE_IS_NEW)' 2>/dev/null && command -v npm >/dev/null || { \
		echo 'SceneGen needs Node 20.19 or newer with npm to build its page; install it' \
		'(https://nodejs.org) and run make again.' >&2; exit 1; }

.venv/bin/pip: | tools
	$(PYTHON) -m venv .venv

$(INSTALLED): pyproject.toml | .venv/bin/pip
	$(BIN)/pip install --quiet --disable-pip-version-check --editable .
	@touch $@

$(INSTALLED_FOR_TESTS): pyproject.toml | .venv/bin/pip
	$(BIN)/pip install --quiet --disable-pip-version-check --editable '.[test]'
	@touch $@ $(INSTALLED)

# The first answer compiles the loops over poses and keeps them on disk: nobody should wait for that.
$(COMPILED): $(shell grep -rl 'njit\|@compiled' scenegen_core --include=*.py) | $(INSTALLED)
	@echo 'Compiling the loops over poses, once ...'
	@$(BIN)/scenegen place web/public/rooms/living-room.json --add Sofa >/dev/null
	@touch $@

$(NODE_MODULES): package.json package-lock.json | tools
	npm ci --no-audit --no-fund
	@touch $@

$(SCANS): scenegen_core/datasets/quest.py scenegen_core/datasets/labels/quest.csv $(NODE_MODULES) \
		| $(INSTALLED)
	$(BIN)/python -m scenegen_core.datasets.quest node_modules/@iwer/sem/captures $(@D)
	@touch $@

$(PAGE): $(PAGE_SOURCES) $(NODE_MODULES) $(SCANS)
	npm run --silent build
	@touch $@
