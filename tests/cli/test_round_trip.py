# SPDX-License-Identifier: GPL-3.0-or-later
"""generate → info → graph → check, render, and what check finds."""

import json
import re

import pytest
from program import load, run

LINES = run("generate", "--list").out.splitlines()
FAMILIES = [line.split()[0] for line in LINES if " 3D: " not in line]
FAMILIES3 = [line.split()[0] for line in LINES if " 3D: " in line]
FORMATS = ["scene", "wkt", "geojson"]


def test_list_of_families():
    lines = run("generate", "--list").out.splitlines()
    names = [line.split()[0] for line in lines]
    assert len(FAMILIES) >= 25 and len(FAMILIES3) >= 25 and names == sorted(names)
    assert any(line.startswith("dense [N=1000] ") for line in lines)


@pytest.mark.parametrize("family", FAMILIES)
def test_every_family_is_valid(folder, family):
    assert run("generate", family, "-o", "scene.scene").status == 0
    assert run("info", "scene.scene", "-o", "info.json").status == 0


def read_off(path):
    """Vertices and faces of an OFF file, which says their numbers."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    assert lines[0] == "OFF"
    counts = [int(word) for word in lines[1].split()]
    assert len(lines) == 2 + counts[0] + counts[1]
    vertices = [tuple(map(float, line.split())) for line in lines[2:2 + counts[0]]]
    faces = [list(map(int, line.split())) for line in lines[2 + counts[0]:]]
    assert all(face[0] == len(face) - 1 and max(face[1:]) < len(vertices) for face in faces)
    return vertices, [face[1:] for face in faces]


@pytest.mark.parametrize("family", FAMILIES3)
def test_every_family_of_3d_scenes_is_written(folder, family):
    finished = run("generate", family, "-o", "scene.off")
    assert finished.status == 0
    vertices, faces = read_off(folder / "scene.off")
    assert faces and sorted({v for face in faces for v in face}) == list(range(len(vertices)))
    bodies = folder / "scene-bodies.off"
    world = "# world" in (folder / "scene.off").read_text()
    assert bodies.exists() == world == ("scene.off scene-bodies.off --world" in finished.err)
    if world:
        assert read_off(bodies)[1]


def test_3d_scene_on_standard_output():
    out = run("generate", "room", 600, "--seed", 3).out
    assert out.startswith("OFF\n# world: the first 6 faces bound the free world\n800 600 0\n0 0 0\n")
    sheets = run("generate", "triangles", 2, "--seed", 3)
    assert sheets.out.startswith("OFF\n# sheets: surfaces of zero thickness\n6 2 0\n")
    assert "sheets: read it with --sheets" in sheets.err


def test_generated_room_is_the_same_every_time(folder):
    for name in ("one", "two"):
        assert run("generate", "room", 120, 1, 1, "--seed", 9, "-o", f"{name}.off").status == 0
    for ending in (".off", "-bodies.off"):
        assert (folder / f"one{ending}").read_text() == (folder / f"two{ending}").read_text()


@pytest.mark.parametrize("ending", FORMATS)
def test_from_generate_to_check(folder, ending):
    scene = f"city.{ending}"
    assert run("generate", "dense", 60, "--seed", 5, "-o", scene).status == 0
    world = ["--world"] if ending == "wkt" else []
    assert run("info", scene, *world, "-o", "info.json").status == 0
    assert run("graph", scene, *world, "--collinear", "all", "-o", "graph.json").status == 0
    assert load("info.json")["result"]["vertices"] == load("graph.json")["scene"]["vertices"] == 64
    # check takes --world from the result
    finished = run("check", "graph.json", scene)
    assert finished.status == 0
    edges = sum(len(row) for row in rows_of(load("graph.json")))
    assert finished.out == f"graph.json: 64 of 64 rows with {edges} edges: 0 false, 0 missed\n"


def rows_of(document):
    rows = [[] for _ in document["result"]["vertices"]]
    for u, v in document["result"]["edges"]:
        rows[u].append(v)
        rows[v].append(u)
    return rows


def test_formats_hold_the_same_scene(folder):
    for ending in FORMATS:
        run("generate", "floor-plan", 5, 5, "-o", f"plan.{ending}")
        world = ["--world"] if ending == "wkt" else []
        run("graph", f"plan.{ending}", *world, "-o", f"{ending}.json")
    results = [load(f"{ending}.json")["result"] for ending in FORMATS]
    assert results[0] == results[1] == results[2]


def test_seeds(folder):
    texts = {seed: run("generate", "dense", 50, "--seed", seed).out for seed in (1, 2)}
    assert texts[1] != texts[2]
    assert run("generate", "dense", 50).out == texts[1]


def test_a_world_in_wkt_says_so(folder):
    assert "read it with --world" in run("generate", "dense", 20, "-o", "dense.wkt").err
    assert "--world" not in run("generate", "dense", 20, "-o", "dense.scene").err


def test_check_finds_false_and_missed_edges(folder):
    run("graph", "boxes.scene", "-o", "graph.json")
    document = load("graph.json")
    document["result"]["edges"].remove([1, 7])
    document["result"]["edges"].append([0, 6])
    (folder / "wrong.json").write_text(json.dumps(document))
    finished = run("check", "wrong.json", "boxes.scene", "-o", "check.json")
    assert finished.status == 1
    result = load("check.json")["result"]
    assert result["equal"] is False
    # Each is seen from both of its ends.
    assert (result["false"], result["missed"]) == (2, 2)
    assert result["false_edges"] == [[0, 6], [0, 6]] and result["missed_edges"] == [[1, 7], [1, 7]]


def test_check_by_sample(folder):
    run("generate", "grid", 4, 4, "-o", "grid.scene")
    run("graph", "grid.scene", "-o", "graph.json")
    finished = run("check", "graph.json", "grid.scene", "--sample", 5)
    assert finished.status == 0 and finished.out.startswith("graph.json: 5 of 64 rows with ")


def test_check_with_added_points(folder):
    run("graph", "boxes.scene", "--add", "2,5", "--tangent", "-o", "graph.json")
    assert run("check", "graph.json", "boxes.scene").status == 0


def test_check_of_views(folder):
    run("view2", "boxes.scene", "--from", "2,1/2", "--from", "7/3,-1", "--with-needles", "-o", "view.json")
    assert run("check", "view.json", "boxes.scene").out == "view.json: 2 of 2 views: 0 differ\n"
    document = load("view.json")
    document["result"]["polygons"][1]["ring"].pop()
    (folder / "wrong.json").write_text(json.dumps(document))
    finished = run("check", "wrong.json", "boxes.scene")
    assert (finished.status, finished.out) == (1, "wrong.json: 2 of 2 views: 1 differ\n")


def test_check_of_paths(folder):
    run("path", "boxes.scene", "--from", "-1,1/2", "--to", "2,1/2", "-o", "path.json")
    assert run("check", "path.json", "boxes.scene").status == 0
    document = load("path.json")
    document["result"]["points"] = [["-1", "1/2"], ["2", "1/2"]]
    (folder / "wrong.json").write_text(json.dumps(document))
    finished = run("check", "wrong.json", "boxes.scene")
    assert (finished.status, finished.out) == (1, "wrong.json: path with 2 points: 1 legs blocked, not the shortest\n")


def test_check_refuses_another_scene(folder):
    run("graph", "boxes.scene", "-o", "graph.json")
    (folder / "moved.scene").write_text("polygon 0 0, 1 0, 1 1, 0 1\npolygon 3 0, 5 0, 5 1, 3 1\n")
    finished = run("check", "graph.json", "moved.scene")
    assert (finished.status, finished.err) == (2, "sightline: graph.json: vertex 5 is not that of the scene; "
                                                  "name the files that it was made from\n")


def test_render_of_results(folder):
    run("graph", "boxes.scene", "--add", "2,3", "-o", "graph.json")
    run("view2", "boxes.scene", "--from", "2,1/2", "-o", "view.json")
    run("path", "boxes.scene", "--from", "-1,1/2", "--to", "2,1/2", "-o", "path.json")
    finished = run("render", "boxes.scene", "graph.json", "view.json", "path.json", "--title", "Two boxes",
                   "-o", "all.svg", "--vtk", "all.vtp")
    assert (finished.status, finished.out, finished.err) == (0, "", "")
    svg = (folder / "all.svg").read_text()
    assert "Two boxes" in svg
    plain = run("render", "boxes.scene", "--svg", "plain.svg")
    assert plain.status == 0 and len((folder / "plain.svg").read_text()) < len(svg)


def test_render_draws_what_graph_draws(folder):
    run("graph", "boxes.scene", "-o", "graph.json", "--vtk", "one.vtp")
    run("render", "boxes.scene", "graph.json", "--vtk", "two.vtp")
    assert (folder / "one.vtp").read_bytes() == (folder / "two.vtp").read_bytes()


def test_torture(folder):
    finished = run("torture", "--family", "grid", "--family", "chain", "--sample", 4, "-o", "torture.json")
    assert finished.status == 0
    rows = load("torture.json")["result"]["rows"]
    assert {row["family"] for row in rows} == {"grid", "chain"}
    assert {row["transform"] for row in rows} >= {"as it is", "rotated 30°", "times 0.1", "nudged", "permuted"}
    compared = [row for row in rows if row["valid"]]
    assert len(compared) >= 8
    assert all(row["rows"] == 4 and not row["filtered"]["crashed"] for row in compared)
    assert all(row["filtered"]["false"] == row["filtered"]["missed"] == 0 for row in compared)
    assert all(row["filtered"]["filter"] > 0 for row in compared)
    assert "filtered wrong on 0;" in finished.out.splitlines()[-1] + finished.out.splitlines()[-2]


def test_torture_of_files(folder):
    run("generate", "floor-plan", 4, 4, "-o", "plan.wkt")
    finished = run("torture", "plan.wkt", "--world", "-o", "torture.json", "--sample", 1000)
    assert finished.status == 0
    rows = load("torture.json")["result"]["rows"]
    assert {row["file"] for row in rows} == {"plan.wkt"}
    # Every row of the graph is compared: as many as there are vertices.
    assert all(row["rows"] == row["vertices"] > 0 for row in rows if row["valid"])
    assert sum(row["filtered"]["exact"] for row in rows if row["valid"]) > 0


def test_repair(folder):
    (folder / "overlap.scene").write_text("polygon 0 0, 2 0, 2 2, 0 2\npolygon 1 1, 3 1, 3 3, 1 3\n")
    assert run("graph", "overlap.scene").status == 2
    finished = run("graph", "overlap.scene", "--repair", "-o", "graph.json")
    assert finished.status == 0 and finished.err.startswith("repair: ")
    document = load("graph.json")
    assert document["scene"]["bodies"] == 1 and document["options"]["repair"] is True
    run("info", "overlap.scene", "--repair", "-o", "info.json")
    assert len(load("info.json")["result"]["repairs"]) == 1
    assert run("check", "graph.json", "overlap.scene").status == 0


def test_the_whole_battery(folder):
    finished = run("torture", "--sample", 4)
    assert finished.status == 0
    counts = re.search(r"(\d+) scenes compared .* filtered wrong on 0; double wrong on (\d+),", finished.out)
    # It bites: doubles fail where filtered arithmetic does not.
    assert int(counts[1]) > 300 and int(counts[2]) > 10


def test_png(folder):
    finished = run("render", "boxes.scene", "--png", "boxes.png")
    if "built without VTK" in finished.err:
        assert finished.status == 2
        assert run("show", "boxes.scene").err == ("sightline: this program was built without VTK; write --svg with "
                                                  "render instead\n")
        return
    assert finished.status == 0, finished.err
    assert (folder / "boxes.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")
    assert sorted(p.name for p in folder.iterdir()) == ["boxes.png", "boxes.scene"]
