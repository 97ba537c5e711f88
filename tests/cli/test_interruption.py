# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C and limits: nothing half-written, and nothing that passes for complete."""

import os
import signal

import pytest
from program import load, read_until, run, start


def names(folder):
    return sorted(p.name for p in folder.iterdir())


@pytest.mark.parametrize("which", [signal.SIGINT, signal.SIGTERM])
def test_while_reading(folder, which):
    # It waits for more input for ever.
    process = start("graph", "-", "-o", "graph.json", "--progress")
    read_until(process.stderr, b"reading")
    process.send_signal(which)
    out, _ = process.communicate()
    assert (process.returncode, out) == (130, b"")
    assert names(folder) == ["boxes.scene"]


def test_while_computing(folder):
    run("generate", "sparse", 20000, "-o", "sparse.scene")
    process = start("graph", "sparse.scene", "--arithmetic", "exact", "-o", "graph.json", "--progress")
    read_until(process.stderr, b"building the graph")
    process.send_signal(signal.SIGINT)
    process.communicate()
    assert process.returncode == 130
    assert names(folder) == ["boxes.scene", "sparse.scene"]


def test_while_writing(folder):
    """The first picture stands under its temporary name while the second is stuck in a full pipe."""
    run("generate", "dense", 1000, "-o", "dense.scene")
    os.mkfifo("pipe.vtp")
    process = start("graph", "dense.scene", "-o", "graph.json", "--svg", "graph.svg", "--vtk", "pipe.vtp")
    with open("pipe.vtp", "rb") as pipe:
        assert pipe.read(1) == b"<"
        assert any(name.startswith(".graph") and name.endswith(".svg") for name in names(folder))
        process.send_signal(signal.SIGINT)
        process.communicate()
    assert process.returncode == 130
    assert names(folder) == ["boxes.scene", "dense.scene", "pipe.vtp"]


def test_an_old_file_survives(folder):
    (folder / "graph.json").write_text("old")
    process = start("graph", "-", "-o", "graph.json", "--progress")
    read_until(process.stderr, b"reading")
    process.send_signal(signal.SIGINT)
    process.communicate()
    assert (folder / "graph.json").read_text() == "old"


def test_limit_on_time(folder):
    process = start("graph", "-", "-o", "graph.json", "--limit-seconds", "0.05")
    read_until(process.stderr, b"sightline: limit reached: more than 0.05 s (--limit-seconds) while reading, 0 % done; "
                               b"nothing is written; raise the limit\n")
    process.wait()
    assert process.returncode == 1
    process.stdin.close()
    assert names(folder) == ["boxes.scene"]


def test_limit_on_memory(folder):
    finished = run("generate", "packed", 3_000_000, "--limit-memory", "40M", "-o", "packed.scene")
    assert finished.status == 1
    assert finished.err.startswith("sightline: limit reached: more than 40 MB of memory (--limit-memory) while ")
    assert finished.err.endswith("nothing is written; raise the limit\n")
    assert names(folder) == ["boxes.scene"]


def test_partial_results_say_so(folder):
    count = 60_000
    (folder / "points.txt").write_text("2,5\n" * count)
    finished = run("view2", "boxes.scene", "--from-file", "points.txt", "--limit-seconds", "0.3", "--partial",
                   "-o", "view.json")
    if finished.status == 0:
        assert len(load("view.json")["result"]["polygons"]) == count
        return
    assert finished.status == 1 and finished.err.startswith("sightline: limit reached: more than 0.3 s")
    if (folder / "view.json").exists():
        document = load("view.json")
        assert document["complete"] is False
        assert 0 < len(document["result"]["polygons"]) < count


def test_broken_pipe(folder):
    run("generate", "dense", 1000, "-o", "dense.scene")
    process = start("graph", "dense.scene", "--quiet")
    process.stdout.close()
    error = process.stderr.read()
    assert process.wait() == 2
    assert error == b"sightline: standard output: cannot be written (Broken pipe); check the disk\n"
