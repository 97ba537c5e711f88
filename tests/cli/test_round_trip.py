# SPDX-License-Identifier: GPL-3.0-or-later
"""generate → info → graph → check, render, and what check finds."""

import json
import re

import pytest
from program import load, run

FAMILIES = [line.split()[0] for line in run("generate", "--list").out.splitlines()]
FORMATS = ["scene", "wkt", "geojson"]


def test_list_of_families():
    lines = run("generate", "--list").out.splitlines()
    assert len(lines) >= 25 and FAMILIES == sorted(FAMILIES)
    assert any(line.startswith("dense [N=1000] ") for line in lines)


@pytest.mark.parametrize("family", FAMILIES)
def test_every_family_is_valid(folder, family):
    assert run("generate", family, "-o", "scene.scene").status == 0
    assert run("info", "scene.scene", "-o", "info.json").status == 0


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
