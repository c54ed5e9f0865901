"""A number as it is typed, key after key."""

from __future__ import annotations

from dataclasses import dataclass, replace

from app.viewpoint.events import BACKSPACE

LONGEST = 16  # digits and a point: more than a number of the machine tells apart


@dataclass(frozen=True)
class Number:
    """digits: with at most one point, before the sign. A minus typed anywhere turns the sign."""

    digits: str = ""
    negative: bool = False

    def after(self, key: str) -> Number:
        """With one more key: a digit, ".", "-" or BACKSPACE; others change nothing."""
        if key == "-":
            return replace(self, negative=not self.negative)
        if key == BACKSPACE:
            return replace(self, digits=self.digits[:-1]) if self.digits else Number()
        if len(self.digits) >= LONGEST:
            return self
        if key.isdecimal() or (key == "." and "." not in self.digits):
            return replace(self, digits=self.digits + key)
        return self

    @property
    def text(self) -> str:
        """As typed."""
        return "-" * self.negative + self.digits

    @property
    def value(self) -> float | None:
        """None as long as there is no digit."""
        return float(self.text) if any(c.isdecimal() for c in self.digits) else None
