"""How deeply JSON is nested.

Python copies and writes it by calls within calls, which end at some hundred levels, and reads more
of them in one version than in another.
"""

from __future__ import annotations

from typing import Any

DEEPEST = 100


def is_deep(root: Any) -> bool:
    """Whether more than DEEPEST lists and objects lie inside each other.

    >>> is_deep([[1], {"a": [2]}])
    False
    """
    level = [root] if isinstance(root, dict | list) else []
    for _ in range(DEEPEST):
        inside = (entry.values() if isinstance(entry, dict) else entry for entry in level)
        level = [child for some in inside for child in some if isinstance(child, dict | list)]
        if not level:
            return False
    return True
