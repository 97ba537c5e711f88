# SPDX-License-Identifier: GPL-3.0-or-later
# The two commands of a visitor, on a bare Debian 12: `make demo` and `make test`. Presets do the rest (CONTRIBUTING.md).
.PHONY: build demo test packages configure format format-check clean
JOBS ?= $(shell nproc)

build: configure
	cmake --build --preset ci -j $(JOBS)

demo: build
	experiments/aegean/demo.sh

test: build
	ctest --preset release

packages:
	@cmake/install_packages.sh

configure: packages
	cmake --preset release

SOURCES = $(shell git ls-files '*.cpp' '*.hpp')
CLANG_FORMAT ?= $(firstword $(shell command -v clang-format-19 clang-format))

format:
	$(CLANG_FORMAT) -i $(SOURCES)

format-check:
	$(CLANG_FORMAT) --dry-run --Werror $(SOURCES)

clean:
	rm -rf build
