# SPDX-License-Identifier: GPL-3.0-or-later
"""sightline path: shortest paths, and the lack of one."""

import math
from fractions import Fraction

from program import load, run, without_stats


def test_document(folder):
    document = without_stats(run("path", "boxes.scene", "--from", "-1,1/2", "--to", "2,1/2").out)
    length = document["result"].pop("length")
    assert document == {
        "sightline": {"version": "0.1.0", "format": 1},
        "kind": "shortest_path",
        "scene": {"files": ["boxes.scene"], "vertices": 8, "bodies": 2},
        "options": {"arithmetic": "filtered", "from": ["-1", "1/2"], "to": ["2", "1/2"]},
        "result": {"points": [["-1", "1/2"], ["0", "0"], ["1", "0"], ["2", "1/2"]], "vertices": [0, 1]},
    }
    lower, upper = Fraction(length["lower"]), Fraction(length["upper"])
    assert lower <= Fraction(length["approx_value"]) <= upper
    # 1 + 2 √(5/4): squared, the bounds enclose it.
    assert (lower - 1) ** 2 <= 5 <= (upper - 1) ** 2
    assert math.isclose(float(lower), float(upper), rel_tol=1e-12)


def test_straight_path(folder):
    result = run("path", "boxes.scene", "--from", "0,2", "--to", "3,6").json["result"]
    assert result["points"] == [["0", "2"], ["3", "6"]] and result["vertices"] == []
    assert Fraction(result["length"]["lower"]) <= 5 <= Fraction(result["length"]["upper"])


def test_unreachable_writes_its_document(folder):
    (folder / "cell.scene").write_text("wall 0 0, 4 0, 4 4, 0 4, 0 0\n")
    finished = run("path", "cell.scene", "--from", "1,1", "--to", "9,9", "-o", "path.json")
    assert finished.status == 1
    assert finished.err.startswith("sightline: ") and finished.err.count("\n") == 1
    assert load("path.json")["result"] == {"unreachable": True}


def test_end_inside_a_body(folder):
    finished = run("path", "boxes.scene", "--from", "1/2,1/2", "--to", "9,9", "-o", "path.json")
    assert finished.status == 1 and "lies inside body" in finished.err
    assert not (folder / "path.json").exists()


def test_pictures(folder):
    finished = run("path", "boxes.scene", "--from", "-1,1/2", "--to", "2,1/2", "--svg", "path.svg")
    assert finished.status == 0 and finished.err.startswith("path: length 3.23606797")
    assert "<svg" in (folder / "path.svg").read_text()
