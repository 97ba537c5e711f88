# SPDX-License-Identifier: GPL-3.0-or-later
"""sightline view3: views of scenes of space."""

import pytest
from program import run

CUBE = """OFF
8 6 0
0 0 0
2 0 0
2 2 0
0 2 0
0 0 2
2 0 2
2 2 2
0 2 2
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
"""


@pytest.fixture
def cube(folder):
    (folder / "cube.off").write_text(CUBE)
    return folder


def test_a_cube_from_a_point(cube):
    document = run("view3", "cube.off", "--from", "5,6.5,15/2").json
    assert document["kind"] == "view"
    seen = document["result"]
    assert seen["from"] == ["5", "13/2", "15/2"]
    assert [f["face"] for f in seen["faces"]] == [1, 3, 4]
    assert all(len(f["area_rings"]) == 1 and len(f["area_rings"][0]) == 4 for f in seen["faces"])
    assert seen["vertices"] == [1, 2, 3, 4, 5, 6, 7]
    assert len(seen["edges"]) == 9
    assert all(e["parameters"] == ["0", "1"] for e in seen["edges"])
    assert seen["t_junctions"] == []


def test_along_a_direction(cube):
    seen = run("view3", "cube.off", "--direction", "0,0,-1").json["result"]
    assert seen["direction"] == ["0", "0", "-1"]
    assert [f["face"] for f in seen["faces"]] == [1]
    assert [n["vertices"] for n in seen["nodes"]] == [[0, 4], [1, 5], [2, 6], [3, 7]]


def test_t_junctions_have_exact_points(cube):
    box = "OFF\n8 6 0\n" + "\n".join(
        f"{x} {y} {z}" for x, y, z in [(-1, 5, 1), (1, 5, 1), (1, 6, 1), (-1, 6, 1),
                                       (-1, 5, 4), (1, 5, 4), (1, 6, 4), (-1, 6, 4)])
    (cube / "box.off").write_text(box + "\n" + "\n".join(CUBE.splitlines()[10:]) + "\n")
    seen = run("view3", "cube.off", "box.off", "--from", "1/3,-8,1/5").json["result"]
    assert len(seen["t_junctions"]) == 3
    for junction in seen["t_junctions"]:
        assert max(junction["front"]) < 8 <= min(junction["back"])
        assert len(seen["nodes"][junction["node"]]["edges"]) == 2


def test_a_cone(cube):
    seen = run("view3", "cube.off", "--from", "1,1,9", "--cone", "1,1,2", "--cone", "3,1,2",
               "--cone", "3,3,2", "--cone", "1,3,2").json["result"]
    assert seen["vertices"] == [6]
    assert [f["face"] for f in seen["faces"]] == [1]


@pytest.mark.parametrize("arguments, status, message", [
    (["--from", "1,1,1"], 1, "inside body 0"),
    (["--from", "1,1"], 2, "is no triple of numbers"),
    ([], 2, "give --from X,Y,Z or --direction X,Y,Z"),
    (["--direction", "0,0,0"], 2, "the direction is zero"),
    (["--from", "1,1,9", "--cone", "1,1,2", "--cone", "3,1,2"], 2, "no convex polygon"),
])
def test_questions_without_an_answer(cube, arguments, status, message):
    result = run("view3", "cube.off", *arguments)
    assert result.status == status
    assert message in result.err
    assert result.err.count("\n") == 1, result.err


def test_every_arithmetic_gives_the_same_bytes_but_for_counts(cube):
    views = [run("view3", "cube.off", "--from", "5,6,7", "--arithmetic", a).json["result"]
             for a in ("filtered", "exact", "double")]
    assert views[0] == views[1] == views[2]
