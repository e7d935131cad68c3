# The menu of the project: installs what is missing (Debian), lets CMake and Ninja do the work. `make help` lists it: a target's
# group, its time on two cores and what it does stand after its ##, in this order, parted by |.
SHELL := /bin/sh
JOBS ?= $(shell nproc)
# A compiler takes up to 1.5 GB: no more of them than there is memory for.
COMPILERS ?= $(shell awk -v cores=$(JOBS) '/^MemAvailable/ { fit = int($$2 / 1500000) } \
  END { print (fit == "" || fit > cores ? cores : fit < 1 ? 1 : fit) }' /proc/meminfo 2>/dev/null || nproc)
SOURCES = $(shell git ls-files '*.cpp' '*.hpp')

# What a bare Debian 12 needs beside make. OpenBLAS takes the place of the plain BLAS under CHOLMOD: scenes in which
# cracks grow under contact are twice as fast with it.
PACKAGES = g++ cmake ninja-build libboost-dev libcgal-dev libcli11-dev libeigen3-dev libfmt-dev libgsl-dev libgtest-dev \
           libhdf5-dev libmuparser-dev libopenblas0-serial libssl-dev libsuitesparse-dev nlohmann-json3-dev \
           libpugixml-dev libspdlog-dev libtbb-dev libtbbmalloc2 libyaml-cpp-dev zlib1g-dev

.PHONY: help build install uninstall deb debug run test test-web docs cases index verification board gallery fronts validate bench bare sanitize fuzz format tidy clean packages
.DEFAULT_GOAL := help

help: ## use | | this list
	@for group in use cases care; do echo "$$group"; \
	  awk -F ':.*## | *[|] *' -v group=$$group \
	    '/^[a-z-]+:.*## / && $$2 == group { printf "  make %-12s %-10s %s\n", $$1, $$3, $$4 }' Makefile; done
	@echo "Times are those of two cores. The first of run, test, build and the cases also compiles: 8 min the program, 4 min the tests; long: over 20 min."

# Builds the program alone: the tests can wait.
run: packages ## use | 1 s | builds the program, reruns a sliding block, prints its error and draws it in out/sliding_block.svg
	cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
	cmake --build build --parallel $(COMPILERS) --target keyblock
	@mkdir -p out
	build/keyblock compare legacy_cases/sliding_block/a30_p20 --picture out/sliding_block.svg --force
	@echo "picture: out/sliding_block.svg"

test: build ## use | 6 min | builds everything and runs all tests
	ctest --test-dir build --output-on-failure -j $(JOBS)
	@awk '/: Skipped$$/ { getline; print "skipped: " $$0 }' build/Testing/Temporary/LastTest.log | sort | uniq -c

test-web: packages ## use | 2 min | tests the page of a run and the window in headless Chromium; needs node from 20.19 on and npm
	@$(call install_missing,chromium)
	cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
	cmake --build build --parallel $(COMPILERS) --target keyblock
	cd page && npm ci && npm run check && npm test && KEYBLOCK=$(CURDIR)/build/keyblock npm run test-page

cases: build ## cases | 1 min | reruns all cases in both profiles and compares them with their expected values
	build/keyblock compare legacy_cases

index: build ## cases | 1 min | reruns all cases and rewrites the table of legacy_cases/README.md
	@$(call install_missing,python3)
	python3 legacy_cases/index.py build/keyblock

verification: build ## cases | 5 min | reruns all cases, slow ones too, and rewrites the verification manual, docs/verification
	@$(call install_missing,python3)
	python3 docs/make_verification.py build/keyblock

board: ## cases | 1 s | writes out/board.html: all cases with pictures, values and errors, then cost of accuracy and speed
	@$(call install_missing,python3)
	@mkdir -p out
	python3 docs/make_board.py out/board.html

gallery: packages ## cases | 10 s | runs a dozen scenes of the repository: pictures in out/gallery/index.html
	@$(call install_missing,python3)
	cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
	cmake --build build --parallel $(COMPILERS) --target keyblock
	python3 docs/make_gallery.py build/keyblock out/gallery

# Whole tables and pictures; processor time, so that what else runs disturbs little.
FRONTS = legacy_cases/fronts
fronts: packages ## cases | 20 min | measures error against computing time in five cases: tables and pictures in legacy_cases/fronts
	cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
	cmake --build build --parallel $(COMPILERS) --target keyblock
	@mkdir -p out
	$(call front,sliding_block,legacy_cases/sliding_block/a30_p20 --repeat 3)
	$(call front,arch,legacy_cases/masonry_arch/quake_thin_falls --against finest --finest 16 --repeat 3)
	$(call front,cantilever,legacy_cases/cantilever/blocks_16x4 --vary basis$(comma)enforcement$(comma)penalty)
	$(call front,cook,legacy_cases/cook_membrane/coarse --repeat 3)
	$(call front,slope,$(FRONTS)/slope.json --vary step --limit 100)
	build/keyblock tradeoff legacy_cases/masonry_arch/quake_thin_falls --map --against finest --finest 16 \
	  --picture $(FRONTS)/arch_map.svg --force >$(FRONTS)/arch_map.txt

comma = ,
front = build/keyblock tradeoff $(2) --picture $(FRONTS)/$(1).svg --force >$(FRONTS)/$(1).txt

# Many runs use Slurm, GNU parallel and Dask if they are installed (Debian: slurmctld slurmd slurm-client munge, parallel,
# python3-distributed); they are not installed here, because Debian starts their services at once.
validate: build ## cases | long | longer checks: slow cases too, cutting against GEOS, random and extreme scenes
	@$(call install_missing,libgeos-dev valgrind calculix-ccx)
	build/keyblock compare --all legacy_cases
	cmake -S . -B build -G Ninja
	cmake --build build --target keyblock_validate -- -k 0

bench: packages ## cases | long | measures the time of a step from 100 to 100,000 blocks, also beside Box2D; numbers in build/bench.json
	@$(call install_missing,libbox2d-dev)
	cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
	cmake --build build --target keyblock_bench

build: packages ## use | 12 min | compiles the program build/keyblock and its tests
	cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
	cmake --build build --parallel $(COMPILERS)

# The program runs on x86-64 processors since about 2013 (KEYBLOCK_ARCH); root's paths are /usr/local, others may say PREFIX=$$HOME/.local.
PREFIX ?= /usr/local
install: packages ## use | 1 s | puts program, library, header, man page and completion below PREFIX=/usr/local (DESTDIR before it)
	cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
	cmake --build build --parallel $(COMPILERS) --target keyblock keyblock_library keyblock_pages
	cmake --install build --prefix "$(PREFIX)"
	cp build/install_manifest.txt build/installed.txt
	[ -n "$(DESTDIR)" ] || [ "$$(id -u)" != 0 ] || ldconfig

INSTALLED ?= build/installed.txt
uninstall: ## use | 1 s | removes what `make install` put there last
	xargs -d '\n' -I {} rm -f "$(DESTDIR){}" <"$(INSTALLED)"

# For any machine of this architecture, not for this one alone.
deb: packages ## use | 16 min | makes Debian packages of what `make install` puts there and of the Python package, in build-deb
	@$(call install_missing,dpkg-dev file)
	cmake -S . -B build-deb -G Ninja -DCMAKE_BUILD_TYPE=Release
	cmake --build build-deb --parallel $(COMPILERS) --target keyblock keyblock_library keyblock_pages $$(cmake --build build-deb --target help | grep -o '^keyblock_python\b')
	cd build-deb && cpack -G DEB

# Debian's packages alone; a warning fails.
docs: ## use | 20 s | builds the site of all pages in out/site (index.html leads to docs/site/index.html)
	@$(call install_missing,python3-sphinx python3-myst-parser furo libjs-katex)
	/usr/bin/sphinx-build -q -W --keep-going -b html -c docs/site . out/site
	printf '<meta http-equiv="refresh" content="0; url=docs/site/index.html">\n' >out/site/index.html

debug: packages ## care | long | compiles with assertions and debug information in build-debug, each file by itself
	cmake -S . -B build-debug -G Ninja -DCMAKE_BUILD_TYPE=Debug -DKEYBLOCK_BATCHES=OFF
	cmake --build build-debug --parallel $(COMPILERS)

# Root alone can; the first run makes the system with debootstrap, later ones copy it. Its last lines are the exit codes and times.
bare: ## care | 50 min | runs the two commands of the README on a clone in a minimal Debian, in build-bare
	tests/bare.sh 'apt-get update && apt-get install -y make && make run' 'apt-get update && apt-get install -y make && make test'

# Debug keeps the assertions; -O1 because unoptimised Eigen is ten times slower.
sanitize: packages ## care | long | compiles with sanitizers in build-sanitize, runs three steps of every case and all tests
	cmake -S . -B build-sanitize -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O2 -g1" -DKEYBLOCK_SANITIZE=ON
	cmake --build build-sanitize --parallel $(COMPILERS)
	tests/few_steps.sh build-sanitize/keyblock $(JOBS)
	ctest --test-dir build-sanitize --output-on-failure -j $(JOBS)

# What a reader has met so far stays in build-fuzz/fuzz, and is where its next run starts.
SECONDS ?= 600
fuzz: packages ## care | 75 min | feeds every reader of a file format random input, for SECONDS=600 each, in build-fuzz
	@$(call install_missing,clang libclang-rt-14-dev)
	CC=clang CXX=clang++ cmake -S . -B build-fuzz -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1" -DKEYBLOCK_FUZZ=ON
	cmake --build build-fuzz --parallel $(COMPILERS) --target fuzz_reader
	tests/fuzz/fuzz.sh build-fuzz/tests/fuzz/fuzz_reader build-fuzz/fuzz $(SECONDS) $(JOBS)

format: ## care | 1 min | lays out all sources by .clang-format
	@$(call install_missing,clang-format)
	clang-format -i $(SOURCES)

tidy: packages ## care | long | checks all sources with clang-tidy, by .clang-tidy
	@$(call install_missing,clang-tidy)
	cmake -S . -B build-tidy -G Ninja -DCMAKE_BUILD_TYPE=Release -DKEYBLOCK_BATCHES=OFF
	clang-tidy --quiet -p build-tidy $(filter %.cpp,$(SOURCES))

clean: ## care | 1 s | removes everything built, and out
	rm -rf build build-bare build-debug build-sanitize build-fuzz build-tidy out

packages:
	@$(call install_missing,$(PACKAGES))

# Installs those of the named Debian packages that are missing: silent and without network when none is. The package
# lists are fetched only if installing without that fails.
define install_missing
command -v dpkg-query >/dev/null || { \
  echo "not a Debian system; going on, but these Debian packages (or their like) are needed: $(1)"; exit 0; }; \
missing=""; \
for name in $(1); do \
  case "$$(dpkg-query -W -f='$${Status}' "$$name" 2>/dev/null)" in *" installed") ;; *) missing="$$missing $$name";; esac; \
done; \
if [ -z "$$missing" ]; then exit 0; fi; \
echo "installing:$$missing"; \
if [ "$$(id -u)" = 0 ]; then as_root="env"; \
elif command -v sudo >/dev/null; then as_root="sudo"; \
else echo "cannot install without root or sudo; please install:$$missing"; exit 1; fi; \
get="$$as_root DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends install"; \
$$get $$missing >/dev/null 2>&1 || { $$as_root apt-get -qq update && $$get $$missing >/dev/null; }
endef
