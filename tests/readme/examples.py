# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of README.md: a block of code, and the block of text after it, which is what it prints.

As a program, `examples.py README.md LANGUAGE FILE` writes the code of that language into FILE.
"""

import pathlib
import re
import sys


def blocks(markdown):
    """(language, text) of every fenced block, in order."""
    return re.findall(r"^```(\w+)\n(.*?)^```$", markdown, flags=re.MULTILINE | re.DOTALL)


def example(markdown, language):
    """The one block of that language, and the output that the block after it shows."""
    all_blocks = blocks(markdown)
    (place,) = [i for i, block in enumerate(all_blocks) if block[0] == language]
    following, output = all_blocks[place + 1]
    assert following == "text", f"no output is shown after the {language} example"
    return all_blocks[place][1], output


def dialogue(markdown):
    """(command, output) of every line that begins with $ in the console blocks."""
    steps = []
    for language, text in blocks(markdown):
        if language != "console":
            continue
        for line in text.splitlines(keepends=True):
            if line.startswith("$ "):
                steps.append([line[2:].rstrip("\n"), ""])
            else:
                steps[-1][1] += line
    return [tuple(step) for step in steps]


if __name__ == "__main__":
    readme, wanted, out = sys.argv[1:]
    pathlib.Path(out).write_text(example(pathlib.Path(readme).read_text(), wanted)[0])
