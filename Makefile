# certet: everything a user or a contributor runs.
#
#   make demo             set up, build, and mesh a brain atlas into build/demo
#   make test             set up and check everything: proofs, audit, extraction, build, tests
#
#   make deps             install the Debian packages (asks nothing; needs root or sudo)
#   make proofs           replay all proofs from clean
#   make audit            statements, assumptions, leftovers, coqchk, and the C++ tables
#   make check-extracted  re-extract the OCaml reference and compare
#   make build            the library and the command, build/bin/certet
#   make bench            the figures of the README, into build/bench
#   make mutation         single defects seeded into the core, and how many the tests catch
#   make soak             10,000 random domains, meshed and verified

SHELL := /bin/bash
.DELETE_ON_ERROR:
.PHONY: demo test deps proofs audit check-extracted build bench mutation soak certified-tables clean
.NOTPARALLEL:

JOBS ?= $(shell nproc)
BUILD := build

PACKAGES := \
  g++ cmake ninja-build make git \
  coq ocaml-nox ocaml-findlib \
  libtbb-dev libinsighttoolkit5-dev libmuparser-dev \
  libcli11-dev nlohmann-json3-dev libfmt-dev \
  zlib1g-dev libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev \
  python3 python3-numpy python3-meshio python3-matplotlib \
  mricron-data

deps:
	@missing=$$(for p in $(PACKAGES); do \
	    dpkg-query -W -f '$${Status}' $$p 2>/dev/null | grep -q 'ok installed' || echo $$p; done); \
	if [ -n "$$missing" ]; then \
	  sudo=; [ "$$(id -u)" = 0 ] || sudo=sudo; \
	  export DEBIAN_FRONTEND=noninteractive; \
	  $$sudo apt-get update -q && \
	  $$sudo -E apt-get install -q -y --no-install-recommends $$missing; \
	fi

build: deps
	cmake -S . -B $(BUILD) -G Ninja
	cmake --build $(BUILD) -j $(JOBS)

proofs: deps
	$(MAKE) -C coq clean
	$(MAKE) -C coq -j $(JOBS)

coq/Certificate.vo: | deps
	$(MAKE) -C coq -j $(JOBS)

audit: coq/Certificate.vo certified-tables
	$(MAKE) -C coq audit

# The tables that the C++ engine runs on, proved equal to the certified
# functions; with planted defects that the proof must refuse.
certified-tables: coq/Certificate.vo build
	tests/certified_tables/certify $(BUILD)/bin/dump_tables coq $(BUILD)/certified_tables --self-test

check-extracted: coq/Certificate.vo
	$(MAKE) -C coq check-extracted

test: proofs build audit check-extracted
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS)

ATLAS := /usr/share/mricron/templates/aal.nii.gz
demo: build
	mkdir -p $(BUILD)/demo
	$(BUILD)/bin/certet mesh $(ATLAS) --cuts midpoint -o $(BUILD)/demo/brain.vtu
	$(BUILD)/bin/certet check $(BUILD)/demo/brain.vtu

# Debian's Python has Debian's matplotlib; another one may come first in PATH.
PYTHON := $(firstword $(wildcard /usr/bin/python3) python3)
# LARGE=1 sends 300 million tetrahedra to a file of 8 GB, instead of 30 million.
LARGE ?=
bench: build
	mkdir -p $(BUILD)/bench
	$(MAKE) -s -C extracted BUILD=$(abspath $(BUILD))/bench/reference
	$(PYTHON) -B cpp/bench/report.py $(BUILD) $(if $(LARGE),--large)

# Some 25 minutes; results in build/mutation.
mutation: build
	$(PYTHON) -B tests/mutation/mutate.py $(BUILD)

# Some minutes; results in build/soak.
soak: build
	mkdir -p $(BUILD)/soak
	$(BUILD)/bin/certet_soak --count 10000 --report $(BUILD)/soak/soak

clean:
	$(MAKE) -C coq clean
	rm -rf $(BUILD)
