"""The tables of the window against those of the editor; needs the graphics library, no screen."""

from __future__ import annotations

import pytest

from app.tools.table import TOOLS

options = pytest.importorskip("app.window.panel.tool_options", exc_type=ImportError)
shortcuts = pytest.importorskip("app.window.shortcuts", exc_type=ImportError)


def test_every_option_of_a_tool_has_a_row_and_every_row_a_tool() -> None:
    named = {name for tool in TOOLS.values() for name in tool.options}
    assert named == set(options.OPTIONS)


def test_no_two_shortcuts_are_one_chord() -> None:
    chords = [(row.key, row.ctrl, row.shift) for row in shortcuts.SHORTCUTS]
    assert len(set(chords)) == len(chords)
    labels = [row.keys for row in shortcuts.SHORTCUTS]
    assert len(set(labels)) == len(labels)
    assert {tool.key for tool in TOOLS.values()} <= set(labels)
