# SPDX-License-Identifier: GPL-3.0-or-later
"""What README.md shows is what happens: its examples run, in its order, in one folder; its links lead somewhere."""

import json
import os
import pathlib
import re
import subprocess
import sys

import pytest

from examples import dialogue, example

ROOT = pathlib.Path(os.environ["SIGHTLINE_SOURCE_DIR"])
PROGRAM = pathlib.Path(os.environ["SIGHTLINE_PROGRAM"])
README = (ROOT / "README.md").read_text()
PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "experiments/README.md", "notebooks/README.md",
         *sorted(str(page.relative_to(ROOT)) for page in (ROOT / "docs").rglob("*.md"))]


def run(command, folder, **options):
    """Everything that the command prints; it must succeed."""
    path = f"{PROGRAM.parent}:{os.environ['PATH']}"
    done = subprocess.run(command, cwd=folder, env=os.environ | {"PATH": path}, text=True, timeout=120,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, **options)
    assert done.returncode == 0, done.stdout
    return done.stdout


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The folder of the command-line example, and what each of its commands printed."""
    place = tmp_path_factory.mktemp("readme")
    return place, [run(["bash", "-c", command], place) for command, _ in dialogue(README)]


def test_the_commands_print_what_is_shown(folder):
    steps = dialogue(README)
    assert len(steps) >= 5
    for (command, shown), printed in zip(steps, folder[1], strict=True):
        assert printed == shown, command
    assert "</svg>" in (folder[0] / "picture.svg").read_text()


def test_the_cpp_example_prints_what_is_shown(folder):
    code, shown = example(README, "cpp")
    built = pathlib.Path(os.environ["SIGHTLINE_README_EXAMPLE"])
    assert built.with_name("readme_example.cpp").read_text() == code
    assert run([built], folder[0]) == shown


def test_the_python_example_prints_what_is_shown(folder):
    if not (pathlib.Path(os.environ["SIGHTLINE_BUILD_DIR"]) / "python/sightline").is_dir():
        pytest.skip("built without the Python module")
    code, shown = example(README, "python")
    assert run([sys.executable, "-c", code], folder[0]) == shown


def test_the_numbers_under_the_picture_are_those_of_the_map(tmp_path):
    (caption,) = [line for line in README.splitlines() if "is made by `make demo`" in line]
    for options, words in (([], "visibility graph of {} edges"), (["--tangent"], "its {} tangent edges")):
        out = tmp_path / "graph.json"
        run([PROGRAM, "graph", ROOT / "experiments/aegean/aegean.geojson", "--world", *options, "-o", out],
            tmp_path)
        graph = json.loads(out.read_text())
        assert f"{graph['scene']['vertices']:,} vertices of coastline" in caption
        assert words.format(f"{len(graph['result']['edges']):,}") in caption


def test_the_readme_is_short():
    assert len(README.splitlines()) <= 150


def anchor(heading):
    """As the web sites make it: lower case, punctuation dropped, hyphens for spaces."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


@pytest.mark.parametrize("page", PAGES)
def test_links_lead_somewhere(page):
    text = re.sub(r"^```.*?^```$", "", (ROOT / page).read_text(), flags=re.MULTILINE | re.DOTALL)
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"[a-z]+:", target):
            continue
        file, _, part = target.partition("#")
        where = (ROOT / page).parent / file if file else ROOT / page
        assert where.exists(), target
        if part:
            headings = re.findall(r"^#+ (.+)$", where.read_text(), flags=re.MULTILINE)
            assert part in map(anchor, headings), target


def test_every_cited_paper_is_in_the_bibliography():
    known = set(re.findall(r"^@\w+\{(\w+),", (ROOT / "docs/references.bib").read_text(), flags=re.MULTILINE))
    cited = set()
    for folder in ("include", "lib", "tests", "experiments"):
        for source in (ROOT / folder).rglob("*.?pp"):
            cited |= set(re.findall(r"\\cite (\w+)", source.read_text()))
    in_glossary = (ROOT / "docs/glossary.md").read_text()
    cited |= set(re.findall(r"`(\w+_(?:19|20)\d\d\w*)`", in_glossary))
    assert len(cited) >= 10
    assert cited <= known
