# SPDX-License-Identifier: GPL-3.0-or-later
"""sightline view2: views of points."""

import pytest
from program import load, run, without_stats

ROOM = "world\npolygon 0 0, 4 0, 4 4, 0 4\nhole 1 1, 2 1, 2 2, 1 2\n"


@pytest.fixture
def room(folder):
    (folder / "room.scene").write_text(ROOM)
    return folder


def test_document(room):
    assert without_stats(run("view2", "room.scene", "--from", "3,3").out) == {
        "sightline": {"version": "0.1.0", "format": 1},
        "kind": "visibility_polygon",
        "scene": {"files": ["room.scene"], "vertices": 8, "bodies": 1},
        "options": {"arithmetic": "filtered", "with_needles": False},
        "result": {
            "from": ["3", "3"],
            "ring": [["0", "3/2"], ["1", "2"], ["2", "2"], ["2", "1"], ["3/2", "0"],
                     ["4", "0"], ["4", "4"], ["0", "4"]],
            "needles": [],
        },
    }


def test_fractions_and_decimals_are_exact(room):
    seen = run("view2", "room.scene", "--from", "0.1,1/3").json["result"]
    assert seen["from"] == ["1/10", "1/3"]


def test_directions_at_infinity(folder):
    seen = run("view2", "boxes.scene", "--from", "2,5").json["result"]
    assert {"direction": ["0", "1"]} in seen["ring"] or any(isinstance(p, dict) for p in seen["ring"])


def test_several_points(room):
    document = run("view2", "room.scene", "--from", "3,3", "--from", "1/2,1/2").json
    polygons = document["result"]["polygons"]
    assert [p["from"] for p in polygons] == [["3", "3"], ["1/2", "1/2"]]
    assert polygons[0] == run("view2", "room.scene", "--from", "3,3").json["result"]


def test_points_from_a_file(room):
    (room / "points.txt").write_text("# viewpoints\n3,3\n\n 0.5 , 1/2 # near the corner\n")
    document = run("view2", "room.scene", "--from-file", "points.txt", "-o", "view.json")
    assert document.err == "view2: 2 views\n"
    assert [p["from"] for p in load("view.json")["result"]["polygons"]] == [["3", "3"], ["1/2", "1/2"]]
    from_stdin = run("view2", "room.scene", "--from-file", "-", stdin="3,3\n").json
    assert len(from_stdin["result"]["polygons"]) == 1


def test_clip(folder):
    document = run("view2", "boxes.scene", "--from", "2,1/2", "--clip", "-1,-1,5,2").json
    ring = document["result"]["ring"]
    assert document["options"]["clip"] == [["-1", "-1"], ["5", "2"]]
    assert ring == [["1", "0"], ["1", "-1"], ["3", "-1"], ["3", "0"], ["3", "1"], ["3", "2"], ["1", "2"], ["1", "1"]] or \
        all(not isinstance(p, dict) for p in ring)


def test_needles(folder):
    # Two boxes that touch in a corner leave a pinhole, through which one looks along a line.
    (folder / "pinhole.scene").write_text("world\npolygon -9 -9, 9 -9, 9 9, -9 9\n"
                                          "hole -2 0, 0 0, 0 2, -2 2\nhole 0 -2, 2 -2, 2 0, 0 0\n")
    plain = run("view2", "pinhole.scene", "--from", "-1,-1").json["result"]
    full = run("view2", "pinhole.scene", "--from", "-1,-1", "--with-needles").json["result"]
    assert plain["needles"] == []
    assert plain["ring"] == full["ring"]
    assert full["needles"] == [[["0", "0"], ["9", "9"]]]


def test_no_answer_inside_a_body(room):
    finished = run("view2", "room.scene", "--from", "3/2,3/2", "-o", "view.json")
    assert finished.status == 1
    assert finished.err.startswith("sightline: --from 3/2,3/2: ") and finished.err.count("\n") == 1
    assert "body" in finished.err and not (room / "view.json").exists()


def test_threads_do_not_matter(room):
    run("generate", "dense", 200, "-o", "dense.scene")
    points = "".join(f"{100 * i},{70 * i}\n" for i in range(2, 60))
    (room / "points.txt").write_text(points)
    runs = [run("view2", "dense.scene", "--from-file", "points.txt", "--threads", t) for t in (1, 2)]
    if runs[0].status == 0:
        assert runs[0].json["result"] == runs[1].json["result"]
    else:
        assert runs[0].err == runs[1].err


def test_picture(room):
    assert run("view2", "room.scene", "--from", "3,3", "--svg", "view.svg", "--vtk", "view.vtp").status == 0
    assert "<svg" in (room / "view.svg").read_text() and "PolyData" in (room / "view.vtp").read_text()
