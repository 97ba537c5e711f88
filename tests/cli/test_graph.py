# SPDX-License-Identifier: GPL-3.0-or-later
"""sightline graph: the document, its options, its files."""

import re

from program import load, run, without_stats

BOX_EDGES = [[0, 1], [0, 3], [1, 2], [1, 4], [1, 7], [2, 3], [2, 4], [2, 7], [4, 5], [4, 7], [5, 6], [6, 7]]
BOX_VERTICES = [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"], ["3", "0"], ["4", "0"], ["4", "1"], ["3", "1"]]


def test_document(folder):
    assert without_stats(run("graph", "boxes.scene").out) == {
        "sightline": {"version": "0.1.0", "format": 1},
        "kind": "visibility_graph",
        "scene": {"files": ["boxes.scene"], "vertices": 8, "bodies": 2},
        "options": {"arithmetic": "filtered", "collinear": "nearest", "tangent": False},
        "result": {"vertices": BOX_VERTICES, "edges": BOX_EDGES},
    }


def test_text_of_the_document(folder):
    (folder / "triangle.wkt").write_text("POLYGON ((0 0, 0.5 0, 0 -1e-1, 0 0))")
    text = run("graph", "triangle.wkt").out
    text = re.sub(r'"stats": \{.*?\n  \}', '"stats": {}', text, flags=re.DOTALL)
    assert text == """{
  "sightline": {"version": "0.1.0", "format": 1},
  "kind": "visibility_graph",
  "scene": {"files": ["triangle.wkt"], "vertices": 3, "bodies": 1},
  "options": {"arithmetic": "filtered", "collinear": "nearest", "tangent": false},
  "stats": {},
  "result": {
    "vertices": [
      ["0", "0"],
      ["1/2", "0"],
      ["0", "-3602879701896397/36028797018963968"]
    ],
    "edges": [
      [0, 1],
      [0, 2],
      [1, 2]
    ]
  }
}
"""


def test_stats(folder):
    run("graph", "boxes.scene", "-o", "graph.json")
    stats = load("graph.json")["stats"]
    assert list(stats["seconds"]) == ["read", "build", "write"]
    assert all(0 <= s < 60 for s in stats["seconds"].values())
    assert stats["seconds"]["write"] > 0
    assert stats["peak_memory_bytes"] > 1_000_000
    orientation = stats["predicates"]["orientation2"]
    assert orientation["calls"] > 0
    assert orientation["calls"] == sum(orientation[t] for t in ("filter", "interval", "exact", "undecided"))
    assert all(counts["calls"] > 0 for counts in stats["predicates"].values())


def test_collinear_rules(folder):
    (folder / "row.scene").write_text("point 0 0\npoint 1 0\npoint 2 0\n")
    assert run("graph", "row.scene").json["result"]["edges"] == [[0, 1], [1, 2]]
    every = run("graph", "row.scene", "--collinear", "all").json
    assert every["result"]["edges"] == [[0, 1], [0, 2], [1, 2]]
    assert every["options"]["collinear"] == "all"


def test_tangent(folder):
    tangent = run("graph", "boxes.scene", "--tangent").json
    # The crossing bitangents and the common sides stay; what ends in the inside of a front doesn't.
    assert [1, 7] in tangent["result"]["edges"] and [2, 4] in tangent["result"]["edges"]
    assert [1, 2] in tangent["result"]["edges"]
    assert set(map(tuple, tangent["result"]["edges"])) <= set(map(tuple, BOX_EDGES))
    assert tangent["options"]["tangent"] is True


def test_added_points(folder):
    document = run("graph", "boxes.scene", "--add", "2,1/2", "--add=-1,5").json
    assert document["scene"]["vertices"] == 10
    assert document["options"]["add"] == [["2", "1/2"], ["-1", "5"]]
    assert document["result"]["vertices"][8:] == [["2", "1/2"], ["-1", "5"]]
    assert [[u, v] for u, v in document["result"]["edges"] if v == 8] == [[1, 8], [2, 8], [4, 8], [7, 8]]


def test_negative_point_as_a_word_of_its_own(folder):
    assert run("graph", "boxes.scene", "--add", "-1,-5/2").json["options"]["add"] == [["-1", "-5/2"]]


def test_several_files(folder):
    one, two = (folder / "boxes.scene").read_text().splitlines()
    (folder / "a.scene").write_text(one)
    (folder / "b.scene").write_text(two)
    document = run("graph", "a.scene", "b.scene").json
    assert document["scene"]["files"] == ["a.scene", "b.scene"]
    assert document["result"] == {"vertices": BOX_VERTICES, "edges": BOX_EDGES}


def test_standard_streams(folder):
    text = (folder / "boxes.scene").read_text()
    document = run("graph", "-", "-o", "-", stdin=text).json
    assert document["scene"]["files"] == ["-"]
    assert document["result"]["edges"] == BOX_EDGES


def test_world(folder):
    (folder / "room.wkt").write_text("POLYGON ((0 0, 9 0, 9 9, 0 9), (4 4, 5 4, 5 5, 4 5))")
    room = run("graph", "room.wkt", "--world").json
    assert room["scene"]["bodies"] == 1 and room["options"]["world"] is True
    assert [0, 1] in room["result"]["edges"] and [0, 4] in room["result"]["edges"]
    assert run("graph", "room.wkt").json["result"]["edges"] != room["result"]["edges"]


def test_same_bytes(folder):
    run("generate", "dense", 300, "--seed", 3, "-o", "dense.scene")
    texts = []
    for threads in (1, 2, 2):
        run("graph", "dense.scene", "--threads", threads, "-o", "graph.json", "--svg", "graph.svg", "--vtk", "graph.vtp")
        text = (folder / "graph.json").read_text()
        text = re.sub(r'"seconds": .*|"peak_memory_bytes": .*', "", text)
        texts.append((text, (folder / "graph.svg").read_bytes(), (folder / "graph.vtp").read_bytes()))
    assert texts[0] == texts[1] == texts[2]


def test_arithmetics_agree_on_easy_scenes(folder):
    run("generate", "dense", 100, "-o", "dense.scene")
    results = [run("graph", "dense.scene", "--arithmetic", a).json["result"] for a in ("filtered", "exact", "interval", "double")]
    assert all(result == results[0] for result in results)


def test_pictures_without_json(folder):
    finished = run("graph", "boxes.scene", "--svg", "graph.svg")
    assert finished.status == 0 and finished.out == ""
    assert (folder / "graph.svg").read_text().startswith("<svg ")


def test_files_are_all_there_or_none(folder):
    (folder / "closed").mkdir()
    finished = run("graph", "boxes.scene", "-o", "graph.json", "--svg", "/dev/full")
    assert finished.status == 2
    assert finished.err == "sightline: /dev/full: cannot be written (No space left on device); check the disk\n"
    assert sorted(p.name for p in folder.iterdir()) == ["boxes.scene", "closed"]


def test_links_are_followed(folder):
    (folder / "real.json").write_text("old")
    (folder / "link.json").symlink_to("real.json")
    run("graph", "boxes.scene", "-o", "link.json")
    assert (folder / "link.json").is_symlink()
    assert load("real.json")["kind"] == "visibility_graph"


def test_device_as_output(folder):
    assert run("graph", "boxes.scene", "-o", "/dev/null").status == 0


def test_quiet_and_progress(folder):
    assert run("graph", "boxes.scene", "-o", "a.json").err == "graph: 8 vertices, 12 edges\n"
    assert run("graph", "boxes.scene", "-o", "a.json", "--quiet").err == ""
    assert "building the graph [" in run("graph", "boxes.scene", "-o", "a.json", "--progress").err
    assert run("graph", "boxes.scene", "-o", "a.json", "--progress", "--quiet").err == ""
