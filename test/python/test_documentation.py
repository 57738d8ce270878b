# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The examples of the manual and of the documentation of all functions are run, and everything public is documented.

import contextlib
import doctest
import importlib
import inspect
import io
import os
import re

import pytest

import intrinsic_triangulations as it

MANUAL = os.path.join(os.path.dirname(__file__), "..", "..", "doc", "python.md")
MODULES = ("_elements", "_files", "_geodesics", "_heat", "_laplacian", "_mesh", "_simplification", "_subdivision", "_triangulation", "_vectors", "_writing")


def test_the_examples_of_the_manual():
    """What a line prints is in its comment, up to a colon; all examples are one program."""
    with open(MANUAL, encoding="utf-8") as file:
        examples = re.findall(r"^```python\n(.*?)^```", file.read(), re.MULTILINE | re.DOTALL)
    assert len(examples) >= 5
    program = "".join(examples)
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(program, MANUAL, "exec"), {})
    expected = re.findall(r"^ *print\(.*\) +# (.*)$", program, re.MULTILINE)
    lines = printed.getvalue().splitlines()
    assert len(lines) == len(expected) == len(re.findall(r"^ *print\(", program, re.MULTILINE))
    for line, comment in zip(lines, expected):
        if not comment.startswith("about"):
            assert line == comment.split(":")[0].strip()


@pytest.mark.parametrize("page, number", [("README.md", 4), ("doc/recipes.md", 4)])
def test_the_lines_of_other_pages(page, number):
    """They are about a mesh of V and F."""
    with open(os.path.join(os.path.dirname(MANUAL), "..", page), encoding="utf-8") as file:
        lines = re.findall(r"^ *((?:\w+(?:, \w+)* = )?(?:it|t)\.\w+\(.*?\)) *(?:#.*)?$", file.read(), re.MULTILINE)
    assert len(lines) == number
    exec("\n".join(lines), {"it": it, "V": [[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], "F": [[0, 1, 2], [1, 0, 3]]})


def test_the_version_is_that_of_the_project():
    """CMakeLists.txt is where it is written."""
    with open(os.path.join(os.path.dirname(MANUAL), "..", "CMakeLists.txt"), encoding="utf-8") as file:
        assert re.search(r"^  VERSION (\S+)$", file.read(), re.MULTILINE).group(1) == it.__version__


def test_the_eigenvalues_of_the_manual_are_those_of_the_square():
    with open(MANUAL, encoding="utf-8") as file:
        example = re.search(r"^```python\n(from scipy.*?)^```", file.read(), re.MULTILINE | re.DOTALL).group(1)
    names = {}
    with contextlib.redirect_stdout(io.StringIO()):
        exec("import numpy as np\nimport intrinsic_triangulations as it\n" + example, names)
    assert names["values"] / 9.8696 == pytest.approx([0, 1, 1, 2, 4, 4], abs=0.1)


@pytest.mark.parametrize("name", MODULES)
def test_the_examples_of_functions(name):
    result = doctest.testmod(importlib.import_module("intrinsic_triangulations." + name))
    assert result.failed == 0


def public_objects():
    for name in it.__all__:
        thing = getattr(it, name)
        yield name, thing
        if inspect.isclass(thing):
            own = (cls for cls in thing.__mro__ if cls.__module__.startswith("intrinsic_triangulations."))
            for member, value in (item for cls in own for item in vars(cls).items()):
                if not member.startswith("_") and (callable(value) or isinstance(value, (property, classmethod))):
                    yield f"{name}.{member}", value


@pytest.mark.parametrize("name, thing", public_objects(), ids=lambda x: x if isinstance(x, str) else "")
def test_everything_is_documented(name, thing):
    documentation = inspect.getdoc(thing.__func__ if isinstance(thing, classmethod) else thing)
    assert documentation and len(documentation) > 15
    function = getattr(thing, "__func__", thing)
    if inspect.isfunction(function):
        signature = inspect.signature(function)
        assert signature.return_annotation is not inspect.Signature.empty
        assert all(p.annotation is not inspect.Parameter.empty for p in signature.parameters.values()
                   if p.name not in ("self", "cls"))


def test_the_overview_names_all_functions_and_classes_to_begin_with():
    overview = set(re.findall(r"`(\w+)`", it.__doc__))
    for name in it.__all__:
        thing = getattr(it, name)
        has_another_name = name in ("mesh_laplacian", "cotan_laplacian", "compute_distance", "compute_distance_multisource", "sides_of_curve")
        if inspect.isfunction(thing) and not has_another_name or name.endswith(("Solver", "Tracer", "Distances")) or name == "Triangulation":
            assert name in overview, name


def test_the_examples_are_found():
    found = [doctest.DocTestFinder().find(importlib.import_module("intrinsic_triangulations." + name)) for name in MODULES]
    assert sum(len(test.examples) for tests in found for test in tests) > 15
