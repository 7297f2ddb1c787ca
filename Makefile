# The entry point of the project. `make help` lists the targets.

build_folder := build
jobs := $(shell nproc 2>/dev/null || echo 2)
scene := examples/portrait.svg
equal_scenes := 1-1000
targets := sfumato sfumato_library sfumato_c
fuzz_seconds := 60

.DEFAULT_GOAL := help
.PHONY: help demo build test check check-all soak leaks docs kills check-slurm sanitize fuzz fuzz-merge bench wasm hostile-growth \
  hostile-sanitized equal equal-by-clang viewer editor editor-tests python npm npm-bundlers deb reproducible clean

help:
	@echo 'make demo    install what the build needs, build, draw $(scene)'
	@echo 'make build   the command, $(build_folder)/sfumato, and the library for cmake --install'
	@echo 'make test    the quick tests: one or two minutes after the build'
	@echo 'make check   the quick tests and the style; run it before you submit a change'
	@echo 'make check-all   the slow tests, WebAssembly, browsers, Python, npm, outside programs'
	@echo 'make soak    the native tests with all their random cases: hours'
	@echo 'make leaks   import 10,000 random shapes: no opacity leaks out of them; a minute'
	@echo 'make docs    the API reference: build/docs/html/index.html'
	@echo 'make kills   write outputs while 1,000 kill -9 interrupt them'
	@echo 'make check-slurm   tiles and frames with Slurm and GNU parallel on this machine'
	@echo 'make sanitize  the unit tests under AddressSanitizer, UBSan and ThreadSanitizer'
	@echo 'make fuzz    each fuzz target for fuzz_seconds=$(fuzz_seconds) (fuzz/README.md)'
	@echo 'make bench   measure and renew the tables of docs/benchmarks.md: ten minutes'
	@echo 'make hostile-growth   time and memory of hostile inputs, doubled twice'
	@echo 'make hostile-sanitized   all hostile inputs under AddressSanitizer and UBSan'
	@echo 'make equal   random scenes $(equal_scenes): the same bits for all thread counts and instruction sets'
	@echo 'make equal-by-clang   the library built by clang gives the same bits as the one built by g++'
	@echo 'make wasm    the library for WebAssembly: build-wasm/sfumato.wasm'
	@echo 'make viewer  bundle the scripts, shaders and styles of web/viewer into web/viewer/dist'
	@echo 'make editor  draw in a browser: $(build_folder)/editor/ and $(build_folder)/editor.html'
	@echo 'make editor-tests   the editor in Chromium: all user actions, and the inputs of the fuzzers; its core in Firefox'
	@echo 'make python  the wheel, $(build_folder)/python/, tested after installation'
	@echo 'make npm     the npm package, $(build_folder)/npm/sfumato-*.tgz, tested after installation'
	@echo 'make npm-bundlers   tests it with Vite 5 to 7, Rollup, Next.js and jsdom; needs the npm registry'
	@echo 'make deb     the Debian packages, $(build_folder)/debian/*.deb, tested in a clean Debian'
	@echo 'make reproducible  check that two builds in two folders give the same bytes'
	@echo 'make clean   remove what was built'

build:
	@scripts/setup build cache
	@cmake --preset release -DSFUMATO_TESTS=OFF -DSFUMATO_BENCH=OFF -DSFUMATO_WERROR=OFF \
	  --log-level=WARNING >/dev/null
	@cmake --build $(build_folder) --parallel $(jobs) --target $(targets)

demo: targets := sfumato
demo: build
	@$(build_folder)/sfumato render $(scene) -o $(build_folder)/demo.png --scale 2
	@$(build_folder)/sfumato render $(scene) -o $(build_folder)/demo.html
	@echo 'The picture is $(build_folder)/demo.png'
	@echo 'To zoom into it, open $(build_folder)/demo.html in a browser'

test:
	@scripts/setup build cache check
	@cmake --preset release -DSFUMATO_TESTS=ON -DSFUMATO_BENCH=OFF -DSFUMATO_WERROR=OFF \
	  --log-level=WARNING >/dev/null
	@cmake --build $(build_folder) --parallel $(jobs) --target sfumato sfumato_quick_tests
	@ctest --test-dir $(build_folder) --label-exclude slow --exclude-regex '_NOT_BUILT$$' --parallel $(jobs) \
	  --progress --output-on-failure --no-tests=error

check:
	@scripts/check

check-all:
	@scripts/check-all

soak:
	@scripts/setup build cache check viewers
	@cmake --preset release -DSFUMATO_TESTS=ON -DSFUMATO_WERROR=OFF --log-level=WARNING >/dev/null
	@cmake --build $(build_folder) --parallel $(jobs)
	@SFUMATO_SOAK=1 ctest --test-dir $(build_folder) --timeout 7200 --parallel $(jobs) --progress \
	  --output-on-failure --no-tests=error

leaks:
	@scripts/setup build cache check
	@cmake --preset release -DSFUMATO_TESTS=ON -DSFUMATO_WERROR=OFF --log-level=WARNING >/dev/null
	@cmake --build $(build_folder) --parallel $(jobs) --target test_import
	@SFUMATO_SOAK=1 $(build_folder)/tests/test_import --gtest_filter=Leaks.no_random_shape_has_any

docs:
	@scripts/setup docs
	@scripts/make-docs
	@echo 'The reference is build/docs/html/index.html'

kills:
	@scripts/setup build cache check
	@cmake --preset release -DSFUMATO_TESTS=ON --log-level=WARNING >/dev/null
	@cmake --build $(build_folder) --parallel $(jobs) --target test_cli
	@SFUMATO_KILLS=1000 $(build_folder)/tests/test_cli --gtest_filter='*Kill*'

check-slurm:
	@scripts/setup build cache slurm
	@cmake --preset release -DSFUMATO_TESTS=OFF -DSFUMATO_WERROR=OFF --log-level=WARNING >/dev/null
	@cmake --build $(build_folder) --parallel $(jobs) --target sfumato
	@scripts/check-slurm $(build_folder)/sfumato

sanitize:
	@scripts/sanitize

fuzz:
	@scripts/fuzz --seconds $(fuzz_seconds)

fuzz-merge:
	@scripts/fuzz --seconds $(fuzz_seconds) --grow

bench:
	@scripts/setup build cache bench
	@cmake --preset release -DSFUMATO_TESTS=OFF -DSFUMATO_BENCH=ON \
	  -DSFUMATO_WERROR=OFF --log-level=WARNING >/dev/null
	@cmake --build $(build_folder) --parallel $(jobs) --target sfumato sfumato_bench
	@bench/report

wasm:
	@scripts/setup wasm cache
	@scripts/build-wasm build-wasm

viewer:
	@scripts/build-viewer

editor:
	@scripts/build-editor
	@echo 'To draw, open $(build_folder)/editor.html in a browser; $(build_folder)/editor/ is a site of static files'

hostile-growth:
	@scripts/setup build cache check
	@cmake --preset release -DSFUMATO_TESTS=ON -DSFUMATO_WERROR=OFF --log-level=WARNING >/dev/null
	@cmake --build $(build_folder) --parallel $(jobs) --target hostile
	@$(build_folder)/tests/hostile --growth

hostile-sanitized:
	@scripts/setup build cache check sanitize
	@cmake --preset asan -DSFUMATO_TESTS=ON --log-level=WARNING >/dev/null
	@cmake --build build-asan --parallel $(jobs) --target hostile
	@ASAN_OPTIONS=quarantine_size_mb=8 build-asan/tests/hostile --jobs $(jobs)

equal:
	@scripts/setup build cache check
	@cmake --preset release -DSFUMATO_TESTS=ON -DSFUMATO_WERROR=OFF --log-level=WARNING >/dev/null
	@cmake --build $(build_folder) --parallel $(jobs) --target equal_scenes
	@$(build_folder)/tests/equal_scenes hashes few $(equal_scenes)

equal-by-clang:
	@scripts/setup build cache check clang
	@cmake --preset release -DSFUMATO_TESTS=ON -DSFUMATO_WERROR=OFF --log-level=WARNING >/dev/null
	@cmake --preset release -B $(build_folder)/clang -DCMAKE_CXX_COMPILER=clang++-19 \
	  -DCMAKE_C_COMPILER=clang-19 -DSFUMATO_TESTS=ON --log-level=WARNING >/dev/null
	@cmake --build $(build_folder) --parallel $(jobs) --target equal_scenes
	@cmake --build $(build_folder)/clang --parallel $(jobs) --target equal_scenes sfumato
	@tests/equal/same-lists $(build_folder)/tests/equal_scenes $(build_folder)/clang/tests/equal_scenes \
	  $(equal_scenes)

editor-tests: build editor
	@scripts/setup viewers
	@scripts/setup firefox || true
	@SFUMATO="$(CURDIR)/$(build_folder)/sfumato" node tests/editor/e2e/run.mjs $(build_folder)
	@SFUMATO="$(CURDIR)/$(build_folder)/sfumato" node tests/editor/e2e/firefox.mjs $(build_folder)

python: build
	@scripts/setup python
	@scripts/check-python $(build_folder) $(build_folder)

npm:
	@scripts/setup wasm npm cache
	@scripts/build-wasm build-wasm
	@scripts/check-npm $(build_folder) build-wasm

npm-bundlers: npm
	@node bindings/npm/tests/bundlers/run.mjs $(build_folder)/npm/sfumato-*.tgz $(build_folder)/npm/bundlers

deb:
	@packaging/debian/build --out $(build_folder)/debian

reproducible:
	@scripts/setup build cache
	@scripts/check-reproducible --jobs $(jobs)

clean:
	rm -rf $(build_folder) build-wasm build-check build-all build-clang build-python build-asan build-tsan build-fuzz
