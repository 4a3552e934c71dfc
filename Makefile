# certet: everything a user or a contributor runs.
#
#   make demo             set up, build, and mesh a brain atlas into build/demo, with a page
#                         and a picture of it
#   make test             set up and check everything: proofs, audit, extraction, build, tests
#
#   make deps             install the Debian packages of all targets (asks nothing; needs root
#                         or sudo); each target installs its own anyway
#   make proofs           replay all proofs from clean
#   make audit            statements, definitions, assumptions, leftovers, coqchk, and the C++ tables
#   make audit-selftest   attacks on the proofs and on the audit, each of which it must refuse
#   make check-extracted  re-extract the OCaml reference and compare
#   make conformance      write the conformance kit anew, from the certified functions
#   make build            the library and the command, build/bin/certet
#   make bench            the figures of the README, into build/bench
#   make profile          where the time of a run goes, by stage and by function: of RUN="mesh a.nii
#                         -o a.vtu", or of a torus; by perf, or where that is not allowed by callgrind
#   make install          cmake --install, to PREFIX (/usr/local)
#   make package          the Debian packages certet and libcertet-dev, into build/package
#
#   make repeatability    the same meshes from gcc and clang, -O0 and -O3, with and without oneTBB
#   make checksums        write the table of checksums anew, after a change of what they are
#   make tidy             clang-tidy over all sources (.clang-tidy says what it looks for)
#   make sanitize         the tests under the address and undefined-behaviour sanitizers
#   make leaks            the tests under the leak sanitizer
#   make tsan             the engine's tests under the thread sanitizer
#   make valgrind         the bridge to OCaml under valgrind
#   make mutation         single defects seeded into the core, and how many the tests catch
#   make soak             10,000 random domains, thin images, fields of signs, domains of several labels
#                         and graded ones each, meshed and verified
#   make fuzz             libFuzzer against every reader and the core, FUZZ_SECONDS (60) each
#   make fuzz-memory      what it learnt, again under valgrind: memory that nobody wrote

SHELL := /bin/bash
.DELETE_ON_ERROR:
.PHONY: demo test proofs audit audit-selftest check-extracted conformance build bench profile certified-tables \
  deps build-deps demo-deps proof-deps test-deps bench-deps configured everything clean \
  install package repeatability checksums tidy sanitize leaks tsan valgrind mutation soak fuzz fuzz-memory
.NOTPARALLEL:

JOBS ?= $(shell nproc)
BUILD := build

# What each target needs, by name; each installs its own.
COMMAND_PACKAGES := \
  g++ cmake ninja-build make git \
  libtbb-dev libinsighttoolkit5-dev libtiff-dev libmuparser-dev libboost-dev \
  libassimp-dev libopenvdb-dev libblosc-dev libimath-dev zlib1g-dev libhdf5-dev libpng-dev libjs-three \
  libcli11-dev nlohmann-json3-dev libfmt-dev
BUILD_PACKAGES := $(COMMAND_PACKAGES) pybind11-dev python3-dev python3-numpy
DEMO_PACKAGES := $(COMMAND_PACKAGES) mricron-data
PROOF_PACKAGES := make coq ocaml-nox ocaml-findlib
TEST_PACKAGES := \
  $(BUILD_PACKAGES) $(DEMO_PACKAGES) $(PROOF_PACKAGES) \
  libgtest-dev libgmock-dev librapidcheck-dev \
  python3 python3-meshio python3-gmsh python3-vtk9 python3-tifffile python3-pydicom \
  python3-nibabel python3-h5py mypy python3-tqdm python3-nbclient python3-ipykernel calculix-ccx freefem++ python3-getfem tetgen \
  chromium chromium-driver python3-selenium \
  clang libclang-rt-14-dev valgrind dpkg-dev mandoc groff pkg-config
# CGAL, by python3-pygalmesh, is GPL: a program of its own that is compared with, linked to nothing.
BENCH_PACKAGES := $(TEST_PACKAGES) libbenchmark-dev python3-matplotlib python3-pygalmesh
PACKAGES := $(sort $(BENCH_PACKAGES) clang-tidy)

# $(call install,PACKAGES) installs those that are missing.
define install
@missing=$$(for p in $(sort $(1)); do \
    dpkg-query -W -f '$${Status}' $$p 2>/dev/null | grep -q 'ok installed' || echo $$p; done); \
if [ -n "$$missing" ]; then \
  sudo=; [ "$$(id -u)" = 0 ] || sudo="sudo -E"; \
  export DEBIAN_FRONTEND=noninteractive; \
  $$sudo apt-get update -q && \
  $$sudo apt-get install -q -y --no-install-recommends $$missing; \
fi
endef

deps:
	$(call install,$(PACKAGES))
build-deps:
	$(call install,$(BUILD_PACKAGES))
demo-deps:
	$(call install,$(DEMO_PACKAGES))
proof-deps:
	$(call install,$(PROOF_PACKAGES))
test-deps:
	$(call install,$(TEST_PACKAGES))
bench-deps:
	$(call install,$(BENCH_PACKAGES))

# The product alone: a folder that is configured for the tests too stays so.
CONFIGURE := cmake -S . -B $(BUILD) -G Ninja -DCERTET_WERROR=ON -DCERTET_UNITY=ON
configured:
	$(CONFIGURE) $(if $(wildcard $(BUILD)/CMakeCache.txt),,-DCERTET_TESTS=OFF -DCERTET_BENCH=OFF)

build: build-deps configured
	cmake --build $(BUILD) -j $(JOBS) --target product

# The product, its tests and its benchmarks.
everything: test-deps
	$(CONFIGURE) -DCERTET_TESTS=ON -DCERTET_BENCH=ON
	cmake --build $(BUILD) -j $(JOBS)

proofs: proof-deps
	$(MAKE) -C coq clean
	$(MAKE) -C coq -j $(JOBS)

coq/Certificate.vo: | proof-deps
	$(MAKE) -C coq -j $(JOBS)

audit: coq/Certificate.vo certified-tables
	$(MAKE) -C coq audit
	coq/audit/audit --read tests/certified_tables CertetTables

audit-selftest: coq/Certificate.vo
	$(MAKE) -C coq audit-selftest

# The tables that the C++ engine runs on, proved equal to the certified
# functions; with a defect in every entry that the proof must refuse.
certified-tables: coq/Certificate.vo everything
	tests/certified_tables/certify $(BUILD)/bin/dump_tables coq $(BUILD)/certified_tables --self-test

check-extracted: coq/Certificate.vo
	$(MAKE) -C coq check-extracted

conformance: proof-deps
	$(MAKE) -C extracted conformance

test: proofs everything audit audit-selftest check-extracted
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS)

ATLAS := /usr/share/mricron/templates/aal.nii.gz
demo: demo-deps configured
	cmake --build $(BUILD) -j $(JOBS) --target certet_command
	mkdir -p $(BUILD)/demo
	$(BUILD)/bin/certet mesh $(ATLAS) -o $(BUILD)/demo/brain.vtu \
	  --json $(BUILD)/demo/brain.json
	$(BUILD)/bin/certet check $(BUILD)/demo/brain.vtu
	$(BUILD)/bin/certet report $(BUILD)/demo/brain.vtu --run $(BUILD)/demo/brain.json \
	  -o $(BUILD)/demo/brain.html
	$(BUILD)/bin/certet picture $(BUILD)/demo/brain.vtu -o $(BUILD)/demo/brain.png

# Debian's Python has Debian's matplotlib; another one may come first in PATH.
PYTHON := $(firstword $(wildcard /usr/bin/python3) python3)
# LARGE=1 sends 300 million tetrahedra to a file of 8 GB, instead of 30 million.
LARGE ?=
bench: bench-deps everything
	mkdir -p $(BUILD)/bench
	$(MAKE) -s -C extracted BUILD=$(abspath $(BUILD))/bench/reference
	$(PYTHON) -B cpp/bench/report.py $(BUILD) $(if $(LARGE),--large)

RUN ?=
profile: build
	$(call install,valgrind)
	$(PYTHON) -B cpp/bench/profile.py $(BUILD) $(RUN)

PREFIX ?= /usr/local
install: build
	cmake --install $(BUILD) --prefix $(PREFIX)

package: build
	cd $(BUILD) && cpack -G DEB -B package

repeatability: test-deps
	tests/repeatability/variants --build $(BUILD)/repeatability

checksums: everything
	$(BUILD)/bin/certet_checksums > $(BUILD)/checksums.txt
	cp $(BUILD)/checksums.txt tests/repeatability/checksums.txt

# Our own sources alone, as clang compiles them.
tidy: deps
	cmake --preset clang
	cmake --build --preset clang -j $(JOBS)
	run-clang-tidy -quiet -p build-clang -j $(JOBS) '$(CURDIR)/(cpp|bridge|tests)/.*\.cpp$$'

sanitize leaks tsan: deps
	cmake --preset $@
	cmake --build --preset $@ -j $(JOBS)
	ctest --preset $@ -j $(JOBS)

# OCaml scans its stack and heap as it pleases; leaks are its own to keep.
valgrind: deps
	cmake --preset valgrind
	cmake --build --preset valgrind -j $(JOBS)
	OCAMLRUNPARAM=b valgrind --error-exitcode=1 --leak-check=no --undef-value-errors=yes \
	  --suppressions=tests/differential/valgrind.supp \
	  build-valgrind/bin/certet_differential_test --gtest_filter='Bridge*'

# Some 25 minutes on two cores; results in build/mutation.
mutation: everything
	$(PYTHON) -B tests/mutation/mutate.py $(BUILD)

# Some minutes; results in build/soak; the count and the seed may be given.
SOAK_COUNT ?= 10000
SOAK_SEED ?=
soak: everything
	mkdir -p $(BUILD)/soak
	$(BUILD)/bin/certet_soak --count $(SOAK_COUNT) $(if $(SOAK_SEED),--seed $(SOAK_SEED)) --report $(BUILD)/soak/soak
	$(BUILD)/bin/certet_thin_soak --images $(SOAK_COUNT) --fields $(SOAK_COUNT) $(if $(SOAK_SEED),--seed $(SOAK_SEED)) --report $(BUILD)/soak/thin.md
	$(BUILD)/bin/certet_thin_soak --method key --images $(SOAK_COUNT) --fields $(SOAK_COUNT) $(if $(SOAK_SEED),--seed $(SOAK_SEED)) --report $(BUILD)/soak/key.md
	$(BUILD)/bin/certet_label_soak --count $(SOAK_COUNT) $(if $(SOAK_SEED),--seed $(SOAK_SEED)) --report $(BUILD)/soak/labels.md
	$(BUILD)/bin/certet_graded_soak --count $(SOAK_COUNT) $(if $(SOAK_SEED),--seed $(SOAK_SEED)) --report $(BUILD)/soak/graded.md

# A minute for each target; findings in build-fuzz/findings, the seed may be given.
FUZZ_SECONDS ?= 60
FUZZ_SEED ?=
fuzz: deps
	cmake --preset fuzz
	cmake --build --preset fuzz -j $(JOBS)
	PYTHON=$(PYTHON) tests/fuzz/run build-fuzz $(FUZZ_SECONDS) $(FUZZ_SEED)

# By the readers of make test, for valgrind and the sanitizers do not go together.
fuzz-memory: test-deps
	$(CONFIGURE) -DCERTET_TESTS=ON
	cmake --build $(BUILD) -j $(JOBS) --target certet_fuzz_regression
	tests/fuzz/replay $(BUILD) build-fuzz

clean:
	$(MAKE) -C coq clean
	rm -rf $(BUILD)
