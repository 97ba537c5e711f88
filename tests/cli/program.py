# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program as a user would."""

import json
import os
import subprocess
from pathlib import Path

PROGRAM = os.environ["SIGHTLINE_PROGRAM"]
SOURCE = Path(os.environ["SIGHTLINE_SOURCE_DIR"])

TWO_BOXES = "polygon 0 0, 1 0, 1 1, 0 1\npolygon 3 0, 4 0, 4 1, 3 1\n"


class Run:
    """What a finished run left: status, what it said, and its JSON when it wrote that."""

    def __init__(self, finished):
        self.status = finished.returncode
        self.out = finished.stdout
        self.err = finished.stderr

    @property
    def json(self):
        return json.loads(self.out)


def run(*arguments, stdin="", cwd=None):
    """Runs `sightline ARGUMENTS…` to its end."""
    command = [PROGRAM, *map(str, arguments)]
    return Run(subprocess.run(command, input=stdin, capture_output=True, text=True, cwd=cwd,
                              timeout=240))


def start(*arguments, cwd=None):
    """Starts `sightline ARGUMENTS…` with pipes to all its streams."""
    return subprocess.Popen([PROGRAM, *map(str, arguments)], stdin=subprocess.PIPE,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=cwd)


def read_until(stream, word):
    """Reads a binary stream until a word has come by, or it ends."""
    seen = b""
    while word not in seen:
        byte = stream.read(1)
        if not byte:
            raise AssertionError(f"ended without {word!r}: {seen!r}")
        seen += byte
    return seen


def load(path):
    return json.loads(Path(path).read_text())


def without_stats(text):
    """The document without what may differ from run to run."""
    document = json.loads(text)
    del document["stats"]
    return document
