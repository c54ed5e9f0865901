"""A number typed key after key."""

from __future__ import annotations

from functools import reduce

import pytest

from app.tools.gizmo.number import Number


@pytest.mark.parametrize(
    ("keys", "text", "value"),
    [
        ("", "", None),
        ("90", "90", 90.0),
        ("-.5", "-.5", -0.5),
        ("1.2.5", "1.25", 1.25),
        ("45-", "-45", -45.0),
        ("45--", "45", 45.0),
        ("123\b\b4", "14", 14.0),
        ("-\b", "", None),
        ("7\b-", "-", None),
        (".", ".", None),
        ("5\n", "5", 5.0),
    ],
)
def test_keys_make_a_number(keys: str, text: str, value: float | None) -> None:
    number = reduce(Number.after, keys, Number())
    assert (number.text, number.value) == (text, value)
