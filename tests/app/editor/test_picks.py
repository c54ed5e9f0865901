"""The surface under the cursor is asked for once a frame: a query on a large mesh is not cheap."""

from __future__ import annotations

import pytest

from app.pointing.picking import Hit, Picker
from app.viewpoint.camera import Ray
from solver.types import FloatArray
from tests.app.person import Person


@pytest.fixture
def queries(monkeypatch: pytest.MonkeyPatch) -> list[Ray]:
    """Every ray that the picker is asked about."""
    asked: list[Ray] = []
    pick = Picker.pick

    def noted(self: Picker, ray: Ray, positions: FloatArray) -> Hit | None:
        asked.append(ray)
        return pick(self, ray, positions)

    monkeypatch.setattr(Picker, "pick", noted)
    return asked


@pytest.mark.parametrize("tool", ["fixed", "handle", "softness"])
def test_hovering_pressing_and_a_dab_pick_once_a_frame(
    bar: Person, queries: list[Ray], tool: str
) -> None:
    bar.use(tool, 1)
    counts = []
    for x, mouse in ((9.8, ""), (10, "pd"), (10.2, "d"), (10.4, "d"), (10.4, "r")):
        queries.clear()
        bar.frame([x, 2, 0], mouse)
        counts.append(len(queries))
        assert bar.editor.cursor is not None
    assert counts == [1, 1, 1, 1, 1]
    assert bar.editor.document.role.any() or bar.editor.document.softness.any()


def test_a_fast_stroke_picks_once_for_each_dab(bar: Person, queries: list[Ray]) -> None:
    bar.use("fixed", 1)
    bar.frame([4, 2, 0], "pd")
    queries.clear()
    bar.frame([8, 2, 0], "d")  # four radii: a dab each half of one
    assert len(queries) in (8, 9)  # rounding may add one
    assert len({ray.direction.tobytes() for ray in queries}) == len(queries)


def test_while_navigating_nothing_is_picked(ready: Person, queries: list[Ray]) -> None:
    ready.use("navigate")
    for _ in ready.hold([[19, 2, 0], [18, 4, 0], [16, 8, 0]]):
        assert not queries


def test_a_drag_picks_nothing_after_its_press(ready: Person, queries: list[Ray]) -> None:
    ready.frame([19, 2, 0])
    assert len(queries) == 1, "the handle under the cursor lights up"
    ready.frame([19, 2, 0], "pd")
    queries.clear()
    for point in ([18, 4, 0], [16, 8, 0]):
        ready.frame(point, "d")
        assert not queries
