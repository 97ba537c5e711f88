# SPDX-License-Identifier: GPL-3.0-or-later
import pytest

from program import TWO_BOXES


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """An empty folder that the program runs in, with a scene of two boxes in it."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "boxes.scene").write_text(TWO_BOXES)
    return tmp_path
