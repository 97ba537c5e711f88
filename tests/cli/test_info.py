# SPDX-License-Identifier: GPL-3.0-or-later
"""sightline info: counts and degeneracies, and general help."""

import pytest
from program import load, run

COMMANDS = ["info", "graph", "view2", "path", "render", "show", "generate", "torture", "check"]


def test_counts(folder):
    (folder / "room.scene").write_text("world\npolygon 0 0, 9 0, 9 9, 0 9\nhole 4 4, 5 4, 5 5, 4 5\n"
                                       "wall 1 1, 2 2, 3 1\npoint 7 7\n")
    run("info", "room.scene", "-o", "info.json")
    document = load("info.json")
    assert document["kind"] == "info"
    result = document["result"]
    assert (result["vertices"], result["points"], result["bodies"]) == (12, 1, 1)
    assert (result["body_edges"], result["world_edges"], result["walls"]) == (4, 4, 2)
    assert result["world"] is True
    assert result["box"] == [["0", "0"], ["9", "9"]]
    assert result["approx_extent"] == 9
    assert result["degenerate"] is False


def test_degeneracies(folder):
    (folder / "touching.scene").write_text("polygon 0 0, 1 0, 1 1, 0 1\npolygon 1 1, 2 1, 2 2, 1 2\n"
                                           "polygon 5 0, 6 0, 7 0, 7 1\nwall 4 4, 6 6\nwall 4 6, 6 4\n")
    run("info", "touching.scene", "-o", "info.json")
    result = load("info.json")["result"]
    assert result["degenerate"] is True
    assert result["degeneracies"]["contacts"] == [{"bodies": [0, 1], "points": 1, "edges": 0}]
    assert result["degeneracies"]["coincident_vertices"] == [[2, 4]]
    assert result["degeneracies"]["straight_vertices"] == [9]
    assert result["degeneracies"]["crossing_walls"] == 1


def test_text_for_people(folder):
    finished = run("info", "boxes.scene")
    assert finished.status == 0 and finished.err == ""
    assert "vertices" in finished.out and "{" not in finished.out


def test_version():
    for arguments in (["--version"], ["graph", "--version"]):
        finished = run(*arguments)
        assert (finished.status, finished.out) == (0, "sightline 0.1.0\n")


@pytest.mark.parametrize("command", COMMANDS)
def test_help_has_an_example(command):
    finished = run(command, "--help")
    assert finished.status == 0 and finished.err == ""
    assert f"Example:\n  sightline {command} " in finished.out
    assert "--limit-seconds" in finished.out


def test_help_lists_the_commands():
    finished = run("--help")
    assert finished.status == 0
    assert all(f"\n  {command} " in finished.out for command in COMMANDS)
