from __future__ import annotations

import numpy as np

from app.editor import commands as c
from app.model.handles import FIRST_HANDLE, FIXED, FREE
from app.workspace.color_maps import FIXED_COLOR, FREE_COLOR, HANDLE_COLORS, viridis
from tests.app.person import Person


def test_viridis_runs_from_dark_purple_through_teal_to_yellow() -> None:
    expected = [(0.267, 0.005, 0.329), (0.128, 0.565, 0.551), (0.993, 0.906, 0.144)]
    np.testing.assert_allclose(viridis([0.0, 0.5, 1.0]), expected, atol=0.005)
    lightness = viridis(np.linspace(0, 1, 200)) @ [0.2126, 0.7152, 0.0722]
    assert (np.diff(lightness) > 0).all()


def test_each_role_has_its_colour_and_keeps_it(ready: Person) -> None:
    ready.do(c.AddHandle("other"))
    ready.use("handle", 1)
    ready.stroke([10, 2, 0])
    role, colors = ready.editor.document.role, ready.editor.colors
    seen = [np.unique(colors[role == r], axis=0) for r in (FREE, FIXED, FIRST_HANDLE, 3)]
    assert [len(rows) for rows in seen] == [1, 1, 1, 1]
    assert len({rows.tobytes() for rows in seen}) == 4
    np.testing.assert_allclose(seen[2][0], [0.993, 0.906, 0.144])
    ready.do(c.ActivateHandle(ready.editor.document.handles[0].key))
    np.testing.assert_array_equal(ready.editor.colors, colors)


def test_handles_are_told_from_what_is_held_by_their_lightness_too() -> None:
    weights = [0.2126, 0.7152, 0.0722]
    dark = max(color @ weights for color in (FREE_COLOR, FIXED_COLOR))
    assert (HANDLE_COLORS @ weights).min() > dark + 0.03
    assert len(np.unique(HANDLE_COLORS, axis=0)) == len(HANDLE_COLORS)


def test_the_softness_map_shows_softness(bar: Person) -> None:
    bar.use("softness", 3)
    bar.stroke([10, 2, 0])
    assert bar.editor.map == "softness"
    np.testing.assert_array_equal(bar.editor.colors, viridis(bar.editor.document.softness))
