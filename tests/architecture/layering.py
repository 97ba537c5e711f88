#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the #includes of a source tree with what its sightline_module() lines allow.

Usage: layering.py ROOT. Prints one line a violation and ends with status 1 when there is any.

Also checked: third-party headers only where they may stand, no tolerances, few namespaces, licence lines.
"""

import re
import sys
from pathlib import Path

MODULE = re.compile(r"^\s*sightline_module\((\w+)([^)]*)\)", re.MULTILINE)
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"', re.DOTALL)
TOLERANCE = re.compile(r"\b\w*(?:epsilon|tolerance)\w*\b|\beps\b|\b\w+_eps\b", re.IGNORECASE)
NAMESPACE = re.compile(r"^\s*(?:inline\s+)?namespace\s+([\w:]+)\s*(?:\{|$)", re.MULTILINE)

KEYWORDS = {"DEPS", "PUBLIC", "PRIVATE", "TEST_DEPS"}
NAMESPACES = {"sightline", "reference", "families", "viz", "detail", "std", "rc"}
# Who may use a library that must not spread: the endings of file names below lib/.
HEAVY = {
    "CGAL": ("_cgal.cpp",),
    "boost": ("_boost.cpp", "_cgal.cpp"),
    "vtk": ("_vtk.cpp",),
    "pybind11": (),
}
EXCEPTIONS = {"lib/arith/interval_cgal.hpp": {"CGAL"}}
# Folders below lib/ that are programs, not modules: they may use every module.
PROGRAMS = {"cli", "python"}


def modules(cmake_lists):
    """Modules in order of declaration, each with what it names after DEPS."""
    found = {}
    for name, rest in MODULE.findall(cmake_lists):
        keyword, deps = None, []
        for word in rest.split():
            if word in KEYWORDS:
                keyword = word
            elif keyword == "DEPS":
                deps.append(word)
        found[name] = deps
    return found


def closure(deps):
    """For each module, all that it may include, itself too; and complaints about the order."""
    allowed, complaints = {}, []
    for name, direct in deps.items():
        allowed[name] = {name}
        for dep in direct:
            if dep in allowed:
                allowed[name] |= allowed[dep]
            else:
                complaints.append(f"CMakeLists.txt: {name} depends on {dep}, which does not stand above it")
    return allowed, complaints


def library(header):
    """Which of the heavy libraries a header belongs to, or None."""
    first = header.split("/")[0]
    if first in HEAVY:
        return first
    return "vtk" if header.startswith("vtk") else None


def without_comments(text):
    return COMMENT_OR_STRING.sub(lambda match: "\n" * match.group().count("\n"), text)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def check_public_include(path, header):
    """A public header may include the standard library, gmp.h, tl/expected.hpp and our own."""
    if header.startswith("sightline/") or header in ("gmp.h", "tl/expected.hpp"):
        return None
    if path.name == "boost_graph.hpp" and header.startswith("boost/"):
        return None
    if re.fullmatch(r"[a-z_]+", header):
        return None
    return f"public header includes {header}"


def check_private_include(relative, header):
    which = library(header)
    if which is None or which in EXCEPTIONS.get(relative, ()):
        return None
    if which == "pybind11" and relative.startswith("lib/python/"):
        return None
    if relative.endswith(HEAVY[which]):
        return None
    return f"includes {header}: allowed only in files named {' or '.join('*' + e for e in HEAVY[which]) or 'lib/python/*'}"


def check_layer(module, header, allowed):
    """A module may include its own headers, public or private, and those of the modules below it."""
    parts = header.removeprefix("sightline/").split("/")
    if len(parts) < 2 or parts[0] not in allowed:
        return None
    if parts[0] in allowed[module]:
        return None
    return f"{module} includes {header}, but CMakeLists.txt does not name {parts[0]} among its DEPS"


def check_file(root, path, allowed):
    relative = path.relative_to(root).as_posix()
    text = path.read_text(encoding="utf-8")
    public = relative.startswith("include/")
    below = path.relative_to(root / ("include/sightline" if public else "lib")).parts
    module = below[0] if len(below) > 1 else None
    if module and module not in allowed and module not in PROGRAMS:
        yield 1, f"folder {module} is no sightline_module"
        return
    for match in INCLUDE.finditer(text):
        header, line = match.group(2), line_of(text, match.start(1))
        complaint = check_public_include(path, header) if public else check_private_include(relative, header)
        if not complaint and module in allowed:
            complaint = check_layer(module, header, allowed)
        if complaint:
            yield line, complaint
    code = without_comments(text)
    for match in TOLERANCE.finditer(code):
        # The unit roundoff in an error bound is no tolerance.
        if not public and (match.group() == "DBL_EPSILON" or code[: match.start()].endswith(">::")):
            continue
        yield line_of(code, match.start()), f"tolerance by name: {match.group()}"
    for match in NAMESPACE.finditer(code):
        for name in match.group(1).split("::"):
            # Boost.Graph finds the functions of a view by their arguments, some of which only boost knows.
            if name == "boost" and path.name == "boost_graph.hpp":
                continue
            if name not in NAMESPACES:
                yield line_of(code, match.start(1)), f"namespace {name} is not one of ours"
    if "SPDX-License-Identifier: GPL-3.0-or-later" not in text.split("\n", 1)[0]:
        yield 1, "first line is not the licence identifier"


def violations(root):
    root = Path(root)
    allowed, complaints = closure(modules((root / "CMakeLists.txt").read_text(encoding="utf-8")))
    yield from complaints
    for folder in ("include/sightline", "lib"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".hpp", ".cpp", ".h"):
                for line, complaint in check_file(root, path, allowed):
                    yield f"{path.relative_to(root)}:{line}: {complaint}"


def main(arguments):
    if len(arguments) != 1:
        print(__doc__.split("\n\n")[1], file=sys.stderr)
        return 2
    found = list(violations(arguments[0]))
    print("\n".join(found) if found else "layering: every include is allowed")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
