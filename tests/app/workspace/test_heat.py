"""Heat maps: what the surface on screen differs in from its rest shape."""

from __future__ import annotations

import numpy as np
import pytest

from app.editor import commands as c
from app.model.handles import FREE
from app.workspace import heat
from app.workspace.color_maps import MAPS, diverging, rising
from tests.app.person import Person

HEAT = [name for name, shown in MAPS.items() if shown.measure]
PATH = [[19, 2, 0], [17, 4, 0], [15, 7, 0], [12, 9, 0]]


def test_the_scales_are_light_in_the_middle_and_saturate_beyond_their_ends() -> None:
    colors = diverging([-9.0, 0.0, 0.5, 1.0, 9.0])
    np.testing.assert_array_equal(colors[0], colors[1])
    np.testing.assert_array_equal(colors[3], colors[4])
    assert np.ptp(colors[2]) < 0.02  # grey
    np.testing.assert_allclose(rising([0.0])[0], colors[2])
    lightness = rising(np.linspace(0, 1, 50)) @ [0.2126, 0.7152, 0.0722]
    assert (np.diff(lightness) < 0).all()


@pytest.mark.parametrize("name", HEAT)
def test_a_heat_map_is_grey_at_rest_and_coloured_when_folded(ready: Person, name: str) -> None:
    ready.do(c.SetMap(name))
    editor = ready.editor
    grey = rising([0.0])[0]
    np.testing.assert_allclose(editor.colors, np.tile(grey, (len(editor.colors), 1)))
    assert editor.heat.rms == 0
    ready.stroke(*PATH)
    editor.settle()
    assert editor.heat.rms > 0
    assert np.abs(editor.colors - grey).max() > 0.2
    held = editor.document.role != FREE
    inside = held & ~np.isin(np.arange(len(held)), border(ready))
    np.testing.assert_allclose(editor.heat.values[inside], 0, atol=1e-6)
    ready.do(c.ResetPose())
    np.testing.assert_allclose(editor.colors, np.tile(grey, (len(editor.colors), 1)))


def border(person: Person) -> np.ndarray:
    """The vertices beside a free one, and those beside these: bends reach one triangle further."""
    edges, near = person.editor.neighbours.edges, person.editor.document.role == FREE
    for _ in range(2):
        near[edges[near[edges].any(axis=1)].ravel()] = True
    return np.flatnonzero(near)


@pytest.mark.parametrize("name", HEAT)
def test_colours_are_computed_again_only_when_they_may_have_changed(
    ready: Person, name: str
) -> None:
    editor = ready.editor
    ready.do(c.SetMap(name))
    version = editor.colors_version
    ready.frame([10, 2, 0])
    ready.do(c.SetMap(name), c.SetBrush(value=0.3))
    assert editor.colors_version == version
    seen = {version}
    for _ in ready.hold(PATH):
        seen.add(editor.colors_version)
    assert len(seen) == len(PATH)  # live: the press moves nothing
    ready.frame(PATH[-1], "r")
    ready.do(c.SetMap("roles"))
    version = editor.colors_version
    ready.do(c.ResetPose())
    assert editor.colors_version == version


def test_a_measure_that_is_slow_waits_for_the_end_of_the_drag(
    ready: Person, monkeypatch: pytest.MonkeyPatch
) -> None:
    ready.do(c.SetMap("strain"))
    monkeypatch.setattr(heat, "FRAME_BUDGET", -1.0)
    editor = ready.editor
    version = editor.colors_version
    for _ in ready.hold(PATH):
        assert editor.colors_version == version
    ready.frame(PATH[-1], "r")
    assert editor.colors_version != version
    assert editor.heat.rms > 0


def test_a_heat_map_stays_while_dragging_and_makes_way_for_painting(ready: Person) -> None:
    ready.do(c.SetTool("navigate"), c.SetMap("area"))
    ready.do(c.SetTool("drag"))
    assert ready.editor.map == "area"
    ready.do(c.SetTool("softness"))
    assert ready.editor.map == "softness"
    ready.do(c.SetTool("drag"))
    assert ready.editor.map == "roles"


def test_a_legend_says_what_its_ends_mean() -> None:
    texts = {
        name: (shown.scale.text(shown.scale.low), shown.scale.text(shown.scale.high))
        for name, shown in MAPS.items()
        if shown.scale is not None
    }
    assert texts == {
        "softness": ("0", "1"),
        "strain": ("-25 %", "25 %"),
        "dihedral": ("0°", "45°"),
        "area": ("-50 %", "50 %"),
    }
