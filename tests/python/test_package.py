# SPDX-License-Identifier: GPL-3.0-or-later
"""The package as a whole: documentation, stubs, examples."""

import ast
import doctest
import inspect
import os
import pathlib
import re

import sightline
from sightline import _core

STUB = pathlib.Path(os.environ["SIGHTLINE_SOURCE_DIR"]) / "lib/python/sightline/_core.pyi"


def members(owner):
    return {name for name in vars(owner) if not name.startswith("__")}


def test_the_stub_names_what_the_module_has():
    body = ast.parse(STUB.read_text()).body
    functions = {node.name for node in body if isinstance(node, ast.FunctionDef)}
    classes = {node.name: node for node in body if isinstance(node, ast.ClassDef)}
    assert functions | set(classes) == members(_core)
    for name, node in classes.items():
        stubbed = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
        assert {s for s in stubbed if not s.startswith("__")} == members(getattr(_core, name)), name


def test_the_stub_names_the_arguments_of_functions():
    for node in ast.parse(STUB.read_text()).body:
        if isinstance(node, ast.FunctionDef):
            names = [a.arg for a in node.args.args + node.args.kwonlyargs]
            signature = getattr(_core, node.name).__doc__.splitlines()[0]
            assert re.findall(r"(\w+): ", signature) == names, node.name


def test_everything_public_is_documented():
    for name in sightline.__all__:
        thing = getattr(sightline, name)
        assert inspect.getdoc(thing), name
        if inspect.isclass(thing) and thing.__module__ == "sightline._core":
            for member, value in vars(thing).items():
                if callable(value) and not member.startswith("_"):
                    assert len(value.__doc__.splitlines()) > 1, f"{name}.{member}"


def test_the_example_of_the_package_is_true():
    result = doctest.testmod(sightline)
    assert result.attempted >= 3 and result.failed == 0


def test_it_has_the_version_of_the_project():
    text = (STUB.parents[3] / "CMakeLists.txt").read_text()
    assert sightline.__version__ == re.search(r"project\(\s*sightline\s+VERSION\s+(\S+)", text)[1]
