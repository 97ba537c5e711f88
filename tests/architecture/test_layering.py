# SPDX-License-Identifier: GPL-3.0-or-later
"""layering.py accepts this repository, and refuses a tree for each rule that it breaks."""

import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"
MODULES = """
sightline_module(arith  DEPS        PUBLIC GMP::gmp PRIVATE CGAL::CGAL)
sightline_module(geom   DEPS arith)
sightline_module(scene  DEPS geom   PRIVATE fmt::fmt TEST_DEPS viz)
sightline_module(viz    DEPS scene)
"""
CLEAN = {
    "CMakeLists.txt": MODULES,
    "include/sightline/arith/sign.hpp": "#include <gmp.h>\n#include <compare>\n",
    "include/sightline/geom/point.hpp": "#include <sightline/arith/sign.hpp>\n",
    "include/sightline/scene/result.hpp": "#include <tl/expected.hpp>\n// no tolerance, no epsilon\n",
    "include/sightline/scene/boost_graph.hpp": "#include <boost/graph/graph_traits.hpp>\n",
    "lib/arith/interval_cgal.hpp": "#include <CGAL/Interval_nt.h>\n",
    "lib/geom/predicates.cpp": '#include "arith/interval_cgal.hpp"\n#include "sightline/geom/point.hpp"\n'
    "const double u = std::numeric_limits<double>::epsilon(), v = DBL_EPSILON / 2;\n",
    "lib/scene/union_cgal.cpp": "#include <CGAL/Arrangement_2.h>\n#include <fmt/format.h>\nnamespace {}\n",
    "lib/scene/text.cpp": '#include <fmt/format.h>\nnamespace sightline::detail {}\nauto s = "epsilon";\n',
    "lib/viz/render_vtk.cpp": "#include <vtkRenderer.h>\n",
    "lib/cli/main.cpp": '#include "sightline/viz/svg.hpp"\n#include <CLI/CLI.hpp>\n',
    "lib/python/module.cpp": "#include <pybind11/pybind11.h>\n",
}


def run(root):
    return subprocess.run(
        [sys.executable, str(HERE / "layering.py"), str(root)], capture_output=True, text=True, check=False
    )


def write(root, files):
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text if path.suffix == ".txt" else SPDX + text, encoding="utf-8")


def test_this_repository_keeps_its_layers():
    got = run(HERE.parents[1])
    assert got.returncode == 0, got.stdout + got.stderr


def test_a_clean_tree_passes(tmp_path):
    write(tmp_path, CLEAN)
    got = run(tmp_path)
    assert got.returncode == 0, got.stdout + got.stderr


VIOLATIONS = {
    "upward include of a public header": ("include/sightline/geom/bad.hpp", "#include <sightline/scene/result.hpp>\n"),
    "upward include of a source": ("lib/arith/bad.cpp", '#include "sightline/geom/point.hpp"\n'),
    "upward include of a private header": ("lib/geom/bad.cpp", '#include "scene/text.hpp"\n'),
    "CGAL in a public header": ("include/sightline/geom/bad.hpp", "#include <CGAL/enum.h>\n"),
    "Boost in a public header": ("include/sightline/geom/bad.hpp", "#include <boost/variant.hpp>\n"),
    "VTK in a public header": ("include/sightline/viz/bad.hpp", "#include <vtkRenderer.h>\n"),
    "fmt in a public header": ("include/sightline/viz/bad.hpp", "#include <fmt/format.h>\n"),
    "TBB in a public header": ("include/sightline/scene/bad.hpp", "#include <tbb/parallel_for.h>\n"),
    "CGAL in a plain source": ("lib/scene/bad.cpp", "#include <CGAL/Arrangement_2.h>\n"),
    "CGAL in a private header": ("lib/scene/bad_cgal.hpp", "#include <CGAL/Arrangement_2.h>\n"),
    "Boost in a plain source": ("lib/scene/bad.cpp", "#include <boost/graph/astar_search.hpp>\n"),
    "VTK in a plain source": ("lib/viz/bad.cpp", "#  include <vtkRenderer.h>\n"),
    "VTK in a CGAL source": ("lib/viz/bad_cgal.cpp", "#include <vtkRenderer.h>\n"),
    "pybind11 outside the Python module": ("lib/cli/bad.cpp", "#include <pybind11/pybind11.h>\n"),
    "CGAL in the program": ("lib/cli/bad.cpp", "#include <CGAL/enum.h>\n"),
    "tolerance in a header": ("include/sightline/geom/bad.hpp", "inline constexpr double kEpsilon = 1;\n"),
    "limits in a header": ("include/sightline/geom/bad.hpp", "double u = std::numeric_limits<double>::epsilon();\n"),
    "unit roundoff in a header": ("include/sightline/geom/bad.hpp", "inline constexpr double u = DBL_EPSILON;\n"),
    "tolerance in a source": ("lib/geom/bad.cpp", "bool near(double a, double tolerance);\n"),
    "eps in a source": ("lib/geom/bad.cpp", "bool near(double a, double eps);\n"),
    "foreign namespace": ("lib/geom/bad.cpp", "namespace sightline::utils {\n}\n"),
    "folder without a module": ("lib/extra/bad.cpp", "int x;\n"),
}


@pytest.mark.parametrize("name", VIOLATIONS)
def test_a_violation_fails_and_is_named(name, tmp_path):
    path, text = VIOLATIONS[name]
    write(tmp_path, CLEAN | {path: text})
    got = run(tmp_path)
    assert got.returncode == 1
    assert got.stdout.startswith(f"{path}:")
    assert got.stdout.count("\n") == 1


def test_a_module_must_stand_below_what_it_uses(tmp_path):
    write(tmp_path, CLEAN | {"CMakeLists.txt": MODULES.replace("arith  DEPS ", "arith  DEPS scene")})
    got = run(tmp_path)
    assert got.returncode == 1
    assert "arith depends on scene" in got.stdout


def test_the_licence_line_is_required(tmp_path):
    write(tmp_path, CLEAN)
    (tmp_path / "lib/geom/bad.cpp").write_text("int x;\n", encoding="utf-8")
    got = run(tmp_path)
    assert got.returncode == 1
    assert "lib/geom/bad.cpp:1: first line is not the licence identifier" in got.stdout
