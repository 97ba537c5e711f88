# SPDX-License-Identifier: GPL-3.0-or-later
"""sightline render: scenes of space."""

import json
import shutil

import pytest
from program import run

CUBE = """OFF
8 6 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
"""
SHEET = "OFF\n3 1 0\n3 0 0\n4 0 0\n3 1 1\n3 0 1 2\n"


@pytest.fixture
def cube(folder):
    (folder / "cube.off").write_text(CUBE)
    (folder / "sheet.off").write_text(SHEET)
    return folder


def size(path):
    """Width and height of a PNG file."""
    head = path.read_bytes()[:24]
    assert head[:8] == b"\x89PNG\r\n\x1a\n"
    return int.from_bytes(head[16:20], "big"), int.from_bytes(head[20:24], "big")


@pytest.mark.skipif(shutil.which("Xvfb") is None, reason="no Xvfb")
def test_png(cube):
    isometric = run("render", "cube.off", "--png", "a.png")
    assert (isometric.status, isometric.err) == (0, "")
    assert size(cube / "a.png")[0] == 1200
    # Written with a leading minus, and with fractions.
    from_below = run("render", "cube.off", "--png", "b.png", "--look-from=-1/2,2,-1.5", "--see-through")
    assert (from_below.status, from_below.err) == (0, "")
    assert (cube / "a.png").read_bytes() != (cube / "b.png").read_bytes()


def test_vtp_has_solids_and_sheets(cube):
    assert run("render", "cube.off", "--sheet", "sheet.off", "-o", "a.vtp").status == 0
    text = (cube / "a.vtp").read_text()
    # 12 triangles of the cube and one of the sheet; 12 and 3 edges.
    assert 'NumberOfPoints="11" NumberOfVerts="0" NumberOfLines="15"' in text
    assert 'NumberOfPolys="13"' in text


def test_vtm_is_an_index_and_a_file_a_layer(cube):
    before = {p.name for p in cube.iterdir()}
    assert run("render", "cube.off", "-o", "a.vtm").status == 0
    assert {p.name for p in cube.iterdir()} - before == {"a.vtm", "a_0_faces.vtp", "a_1_edges.vtp"}
    assert 'file="a_1_edges.vtp"' in (cube / "a.vtm").read_text()
    assert 'NumberOfLines="12"' in (cube / "a_1_edges.vtp").read_text()


def test_svg_is_refused(cube):
    answer = run("render", "cube.off", "--svg", "a.svg")
    assert answer.status == 2
    assert "a.svg: SVG knows no depth" in answer.err
    assert not (cube / "a.svg").exists()


@pytest.mark.parametrize("text", ["1,2", "1,2,3,4", "0,0,0", "a,b,c", "1,2,", ",,", "1;2;3", "1e999,0,0"])
def test_directions_must_be_directions(cube, text):
    answer = run("render", "cube.off", "-o", "a.vtp", f"--look-from={text}")
    assert answer.status == 2
    assert f"--look-from: '{text}' is no direction" in answer.err
    assert answer.err.count("\n") == 1
    assert not (cube / "a.vtp").exists()


def node(*vertices):
    return {"type": "VV", "support": {"vertices": list(vertices), "edges": []}, "plucker": None,
            "along": [], "ends": [None, None], "faces": [], "root": None}


def skeleton(edge=(5, 6), nodes=(0, 1), kind="Fv"):
    """Part of the cube's: the lines of the top through a corner, between an edge and a diagonal."""
    arc = {"type": kind, "support": {"vertices": [4], "edges": [list(edge)]},
           "ends": [None, None], "nodes": list(nodes)}
    return json.dumps({"sightline": {"version": "0.1.0", "format": 1}, "kind": "visibility_skeleton",
                       "scene": {"files": ["cube.off"], "vertices": 8, "bodies": 1}, "options": {},
                       "result": {"nodes": [node(4, 5), node(4, 6)], "arcs": [arc]}})


def test_skeleton_has_a_block_a_type(cube):
    (cube / "part.json").write_text(skeleton())
    answer = run("render", "part.json", "cube.off", "-o", "a.vtm")
    assert (answer.status, answer.err) == (0, "")
    written = sorted(p.name for p in cube.glob("a_*.vtp"))
    assert written == ["a_0_faces.vtp", "a_1_arcs_Fv.vtp", "a_2_outlines_Fv.vtp", "a_3_edges.vtp",
                       "a_4_nodes_VV.vtp"]
    assert 'NumberOfLines="2"' in (cube / "a_4_nodes_VV.vtp").read_text()


@pytest.mark.parametrize("chosen, arcs", [("Fv", 1), ("0", 1), ("EV,0", 1), ("EEE", 0)])
def test_arcs_are_chosen_by_type_and_number(cube, chosen, arcs):
    (cube / "part.json").write_text(skeleton())
    assert run("render", "part.json", "cube.off", "-o", "a.vtm", "--arcs", chosen).status == 0
    assert len(list(cube.glob("a_*arcs_Fv.vtp"))) == arcs


@pytest.mark.parametrize("chosen", ["1", "VV", "-1", "0x0", "0,,0"])
def test_arcs_that_are_none(cube, chosen):
    (cube / "part.json").write_text(skeleton())
    answer = run("render", "part.json", "cube.off", "-o", "a.vtm", f"--arcs={chosen}")
    assert answer.status == 2
    assert answer.err.count("\n") == 1
    assert "one of the 1 arcs" in answer.err


@pytest.mark.parametrize("text, complaint", [
    (skeleton(edge=(0, 6)), "names edge [0,6], which this scene does not have"),
    (skeleton(nodes=(0, 2)), "names a node that is not in the list"),
    (skeleton(kind="XY"), "names the type 'XY'"),
    (skeleton().replace('"support"', '"supports"'), "is no skeleton as sightline writes it"),
])
def test_skeletons_of_other_scenes_are_refused(cube, text, complaint):
    (cube / "part.json").write_text(text)
    answer = run("render", "part.json", "cube.off", "-o", "a.vtp")
    assert answer.status == 2
    assert answer.err.startswith("sightline: part.json: ") or "part.json: " in answer.err
    assert complaint in answer.err
    assert not (cube / "a.vtp").exists()


def test_results_of_the_plane_do_not_fit(cube):
    (cube / "plane.scene").write_text("polygon 0 0, 1 0, 0 1\n")
    assert run("graph", "plane.scene", "-o", "graph.json").status == 0
    answer = run("render", "cube.off", "graph.json", "-o", "a.vtp")
    assert answer.status == 2
    assert "visibility_graph" in answer.err
