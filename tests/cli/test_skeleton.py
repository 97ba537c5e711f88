# SPDX-License-Identifier: GPL-3.0-or-later
"""sightline skeleton: the document, parts of it, pictures, the check, limits and bad input."""

import json
from fractions import Fraction

import pytest

from program import load, run, without_stats

BOX = """OFF
8 6 0
{0} {1} {2}
{3} {1} {2}
{3} {4} {2}
{0} {4} {2}
{0} {1} {5}
{3} {1} {5}
{3} {4} {5}
{0} {4} {5}
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
"""


@pytest.fixture
def meshes(folder):
    """A cube, a box beside it, five triangles one above the other, the middle one large, and six random bodies."""
    (folder / "cube.off").write_text(BOX.format(0, 0, 0, 1, 1, 1))
    (folder / "box.off").write_text(BOX.format(3, 1, -1, 5, 4, 2))
    (folder / "sheets.off").write_text(
        "OFF\n15 5 0\n0 0 7\n4 0 7\n0 4 7\n1 0 5\n4 1 5\n1 5 5\n-90 -90 3\n99 -90 3\n0 99 3\n"
        "0 1 0\n4 0 0\n2 4 0\n1 0 -2\n4 2 -2\n1 5 -2\n"
        "3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n3 12 13 14\n")
    (folder / "six.off").write_text(run("generate", "polytopes", "6", "--seed", "1").out)
    return folder


def value(number):
    if isinstance(number, str):
        return float(Fraction(number))
    a, b, c = (Fraction(number[key]) for key in "abc")
    assert b in (1, -1) and c > 0
    return float(a) + float(b) * float(c) ** 0.5


def test_document_of_a_cube(meshes):
    document = without_stats(run("skeleton", "cube.off").out)
    result = document.pop("result")
    assert document == {
        "sightline": {"version": "0.1.0", "format": 1},
        "kind": "visibility_skeleton",
        "scene": {"files": ["cube.off"], "vertices": 8, "bodies": 1},
        "options": {"arithmetic": "filtered"},
    }
    assert len(result["nodes"]) == 24 and len(result["arcs"]) == 48
    assert result["nodes"][0] == {
        "type": "VV",
        "support": {"vertices": [0, 1], "edges": []},
        "plucker": ["1", "0", "0", "0", "0", "0"],
        "along": [],
        "ends": [None, None],
        "faces": [0, 2],
        "root": None,
    }
    for arc in result["arcs"]:
        assert arc["type"] == "Fv"
        assert arc["nodes"][0] < arc["nodes"][1]
        (v,) = arc["generators"]["vertices"]
        ((a, b),) = arc["generators"]["edges"]
        assert arc["support"]["vertices"] == [v] and [a, b] in arc["support"]["edges"]
        for n in arc["nodes"]:
            assert v in result["nodes"][n]["support"]["vertices"]


def test_lines_meet_their_support(meshes):
    document = run("skeleton", "six.off").json
    points = [tuple(map(float, line.split()))
              for line in (meshes / "six.off").read_text().split("\n")[2:]]
    kinds = {node["type"] for node in document["result"]["nodes"]}
    assert kinds == {"VV", "FvE", "VEE", "FF"} or "EEEE" in kinds
    for node in document["result"]["nodes"]:
        line = [value(x) for x in node["plucker"]]
        assert next(x for x in line if x != 0) == 1
        d, m = line[:3], line[3:]
        scale = max(map(abs, m)) + 1
        for v in node["support"]["vertices"]:
            p = points[v]
            cross = (p[1] * d[2] - p[2] * d[1], p[2] * d[0] - p[0] * d[2],
                     p[0] * d[1] - p[1] * d[0])
            assert max(abs(x - y) for x, y in zip(cross, m)) < 1e-6 * scale


def test_ends_name_input_faces_and_sides(meshes):
    result = run("skeleton", "sheets.off", "--sheets").json["result"]
    ends = [end for node in result["nodes"] for end in node["ends"] if end is not None]
    faces = [face for end in ends for face in end]
    assert 2 in faces, "lines over the upper two end at the upper side of the large one"
    assert {"back": 2} in faces, "lines over the lower two at its lower side"
    assert all(face in range(5) or face["back"] in range(5) for face in faces)


def test_one_face_of_a_triangulated_cube(meshes):
    """Coplanar triangles are one face, named by the first; the skeleton is that of the quads."""
    quads = run("skeleton", "cube.off").json["result"]
    lines = (meshes / "cube.off").read_text().splitlines()
    triangles = []
    for face in lines[10:]:
        _, a, b, c, d = face.split()
        triangles += [f"3 {a} {b} {c}", f"3 {a} {c} {d}"]
    (meshes / "fine.off").write_text("\n".join(["OFF", "8 12 0"] + lines[2:10] + triangles))
    fine = run("skeleton", "fine.off").json["result"]
    assert {face % 2 for node in fine["nodes"] for face in node["faces"]} == {0}
    for node in fine["nodes"]:
        node["faces"] = [face // 2 for face in node["faces"]]
    assert fine == quads


def test_arcs_of_one_type(meshes):
    whole = run("skeleton", "cube.off", "box.off").json["result"]
    only = run("skeleton", "cube.off", "box.off", "--arcs-only", "EEE").json["result"]
    assert only["nodes"] == whole["nodes"]
    assert only["arcs"] == [arc for arc in whole["arcs"] if arc["type"] == "EEE"]


def test_arcs_between_two_faces(meshes):
    whole = run("skeleton", "six.off").json["result"]
    f, g = next((arc["ends"][0][0], arc["ends"][1][0]) for arc in whole["arcs"]
                if None not in arc["ends"])
    ends = [json.dumps(arc["ends"]) for arc in whole["arcs"] if None not in arc["ends"] and
            ((f in arc["ends"][0] and g in arc["ends"][1]) or
             (g in arc["ends"][0] and f in arc["ends"][1]))]
    pair = run("skeleton", "six.off", "--pair", f"{g},{f}").json["result"]
    assert sorted(json.dumps(arc["ends"]) for arc in pair["arcs"]) == sorted(ends)
    assert {n for arc in pair["arcs"] for n in arc["nodes"]} == set(range(len(pair["nodes"])))


def test_threads_and_arithmetic_change_nothing(meshes):
    one = without_stats(run("skeleton", "six.off", "--threads", "1").out)
    two = without_stats(run("skeleton", "six.off", "--threads", "2").out)
    exact = without_stats(run("skeleton", "six.off", "--arithmetic", "exact").out)
    assert one == two
    assert one["result"] == exact["result"]


def test_stats_count_predicates(meshes):
    predicates = run("skeleton", "cube.off").json["stats"]["predicates"]
    for name in ("line_form3", "curve_parameter3"):
        counts = predicates[name]
        assert counts["calls"] == counts["filter"] + counts["interval"] + counts["exact"] > 0


def test_check(meshes):
    run_ = run("skeleton", "cube.off", "box.off", "--check", "--check-paths", "300")
    assert run_.status == 0
    line = run_.out.strip().splitlines()[-1]
    assert line.startswith("check: ") and " families of lines, " in line
    assert 250 < int(line.split()[1]) <= 300 and int(line.split()[5]) > 100
    assert line.endswith(" crossings matched, 0 missing, 0 false")
    again = run("skeleton", "cube.off", "box.off", "--check", "--check-paths", "300", "--seed", "2")
    assert again.out != run_.out and again.status == 0


def test_check_with_wrong_arithmetic_fails_or_passes_honestly(meshes):
    """What plain doubles make of a lattice has wrong arcs; the check, which is exact, says so."""
    (meshes / "grid.off").write_text(run("generate", "grid3-rotated", "2", "2", "1").out)
    wrong = run("skeleton", "grid.off", "--arithmetic", "double", "--check")
    counts = wrong.out.strip().splitlines()[-1].split()
    missing, false = int(counts[-4]), int(counts[-2])
    assert (wrong.status == 1) == (missing + false > 0)
    assert missing + false > 0


def test_pictures(meshes):
    done = run("skeleton", "cube.off", "--vtk", "skeleton.vtm", "-o", "skeleton.json")
    assert done.status == 0, done.err
    assert "arcs_Fv" in (meshes / "skeleton.vtm").read_text().replace(" ", "_")
    assert load(meshes / "skeleton.json")["kind"] == "visibility_skeleton"


def test_limits(meshes):
    (meshes / "grid.off").write_text(run("generate", "grid3", "5", "5", "5").out)
    stopped = run("skeleton", "grid.off", "--limit-seconds", "0.3", "-o", "out.json")
    assert stopped.status == 1
    assert "limit reached" in stopped.err and "building the skeleton" in stopped.err
    assert not (meshes / "out.json").exists()


def test_reference_agrees_and_notices_changes(meshes):
    assert run("skeleton", "cube.off", "box.off", "-o", "right.json").status == 0
    right = run("check", "right.json", "cube.off", "box.off")
    assert right.status == 0, right.out + right.err
    assert right.out.count(" 0 false, 0 missed") == 2
    document = load(meshes / "right.json")
    del document["result"]["arcs"][17]
    (meshes / "fewer.json").write_text(json.dumps(document))
    fewer = run("check", "fewer.json", "cube.off", "box.off")
    assert fewer.status == 1 and fewer.out.strip().endswith("0 false, 1 missed")
    document["result"]["nodes"][3]["ends"] = [None, [2]]
    (meshes / "wrong.json").write_text(json.dumps(document))
    wrong = run("check", "wrong.json", "cube.off", "box.off", "-o", "finding.json")
    assert wrong.status == 1
    finding = load(meshes / "finding.json")["result"]
    assert not finding["equal"] and finding["false_nodes"] == finding["missed_nodes"] == 1
    assert run("skeleton", "cube.off", "--arcs-only", "EV", "-o", "part.json").status == 0
    assert run("check", "part.json", "cube.off").status == 2


def test_reference_agrees_on_sheets(meshes):
    assert run("skeleton", "sheets.off", "--sheets", "-o", "sheets.json").status == 0
    finding = run("check", "sheets.json", "sheets.off")
    assert finding.status == 0, finding.out + finding.err


def test_torture_in_space(meshes):
    table = run("torture", "--space", "--family", "tetrahedra 3", "--family", "grid3-rotated 2 1 1",
                "-o", "torture.json")
    assert table.status == 0, table.out + table.err
    assert "2 skeletons compared with exact arithmetic (seed 1): filtered wrong on 0" in table.out
    rows = load(meshes / "torture.json")["result"]["rows"]
    assert [row["family"] for row in rows] == ["tetrahedra 3", "grid3-rotated 2 1 1"]
    for row in rows:
        assert row["nodes"] > 0 and row["arcs"] > row["nodes"]
        assert sum(row["filtered"][key] for key in ("false_nodes", "missed_nodes", "false_arcs", "missed_arcs")) == 0
    doubles = rows[1]["double"]
    assert doubles["crashed"] or doubles["false_nodes"] + doubles["missed_nodes"] > 0
    assert run("torture", "--space", "--family", "grid3 0").status == 2
    assert run("torture", "--space", "cube.off").status == 2


@pytest.mark.parametrize("arguments, what", [
    (("--pair", "0"), "write F,G"),
    (("--pair", "0,99"), "there is no face 99"),
    (("--pair", "0;6"), "write F,G"),
    (("--check", "--pair", "0,1"), "whole skeleton"),
    (("--arcs-only", "VV"), "--arcs-only"),
])
def test_bad_arguments(meshes, arguments, what):
    refused = run("skeleton", "cube.off", *arguments)
    assert refused.status == 2
    assert what in refused.err and refused.err.count("\n") == 1
    assert refused.out == ""
