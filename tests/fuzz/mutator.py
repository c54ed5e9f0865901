"""Damages files as no person would: bytes, tokens and the values of JSON."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from random import Random
from typing import Any

EXTREME = (
    *("0", "-1", "1", "-0", "1e308", "-1e308", "1e-320", "1e400", "nan", "inf", "-inf", "1e60"),
    *("1e-60", "1e18", "4294967295", "2147483648", "-2147483649", "9223372036854775808"),
    *("9" * 400, "0x10", "1_0", "1e", ".", "٣", "true", "null", '""', "[]", "{}"),
)
CONTROL = (b"\0", b"\x1b[2J", b"\r", b"\n", b"\x0b", b"\x85", b"\xff\xfe", b"\xe2\x80\xa8", b"\\\n")
NUMBER = re.compile(rb"[-+]?\d[\d.eE+-]*")
LARGEST = 200_000  # bytes: what is damaged stays small
VALUES: tuple[Any, ...] = (
    *(None, True, -1, 0, 0.5, 10**30, 1e308, -1e308, 1e-320, float("nan"), float("inf")),
    *("", "x", "\n\x1b[2J", [], {}, [[]], [0], 2**31, 2**63, [None], "../" * 9, "data:,"),
)


def damaged(random: Random, data: bytes) -> bytes:
    """The bytes with one to four of MUTATIONS done to them."""
    for _ in range(random.choice((1, 1, 1, 2, 4))):
        data = random.choice(MUTATIONS)(random, data)[:LARGEST]
    return data


def damaged_json(random: Random, data: bytes) -> bytes:
    """JSON with one to three of its values replaced, doubled, nested or taken out; or bytes."""
    if random.random() < 0.3:
        return damaged(random, data)
    tree = json.loads(data)
    for _ in range(random.choice((1, 1, 2, 3))):
        _change_value(random, tree)
    text = json.dumps(tree)
    return _double_key(random, text).encode() if random.random() < 0.1 else text.encode()


def _change_value(random: Random, tree: Any) -> None:
    holders = [node for node in _containers(tree) if node]
    if not holders:
        return
    holder = random.choice(holders)
    key = random.choice(list(holder) if isinstance(holder, dict) else range(len(holder)))
    act = random.randrange(5)
    if act == 0:
        del holder[key]
    elif act == 1 and isinstance(holder, list):
        holder.extend([holder[key]] * random.choice((1, 2, 100)))
    elif act == 2:
        for _ in range(random.choice((1, 2, 100))):
            holder[key] = [holder[key]]
    elif act == 3 and isinstance(holder[key], int | float):
        holder[key] += random.choice((-1, 1, 1e-9, 1e9))
    else:
        holder[key] = random.choice(VALUES)


def _containers(tree: Any) -> list[Any]:
    if not isinstance(tree, dict | list):
        return []
    inside = tree.values() if isinstance(tree, dict) else tree
    return [tree, *(node for value in inside for node in _containers(value))]


def _double_key(random: Random, text: str) -> str:
    keys = list(re.finditer(r'"\w+": ', text))
    if not keys:
        return text
    key = random.choice(keys)
    return f"{text[: key.start()]}{key[0]}1, {text[key.start() :]}"


def _span(random: Random, data: bytes) -> tuple[int, int]:
    """The ends of a part, most often a short one."""
    start = random.randrange(len(data) + 1)
    return start, min(len(data), start + random.choice((1, 2, 4, 16, 200)))


def _cut(random: Random, data: bytes) -> bytes:
    return data[: random.randrange(len(data) + 1)]


def _remove(random: Random, data: bytes) -> bytes:
    a, b = _span(random, data)
    return data[:a] + data[b:]


def _repeat(random: Random, data: bytes) -> bytes:
    a, b = _span(random, data)
    return data[:b] + data[a:b] * random.choice((1, 2, 50)) + data[b:]


def _flip(random: Random, data: bytes) -> bytes:
    changed = bytearray(data)
    for _ in range(random.choice((1, 1, 3, 10)) if data else 0):
        changed[random.randrange(len(data))] ^= 1 << random.randrange(8)
    return bytes(changed)


def _word(random: Random, data: bytes) -> bytes:
    """Four bytes as a number of a binary file might be."""
    a = random.randrange(len(data) + 1)
    words = (
        b"\0" * 4,
        b"\xff" * 4,
        b"\0\0\x80\x7f",
        b"\0\0\xc0\x7f",
        b"\xff\xff\x7f\x7f",
        b"\1\0\0\0",
    )
    return data[:a] + random.choice(words) + data[a + 4 :]


def _insert(random: Random, data: bytes) -> bytes:
    a = random.randrange(len(data) + 1)
    return data[:a] + random.choice(CONTROL) + data[a:]


def _number(random: Random, data: bytes) -> bytes:
    found = list(NUMBER.finditer(data))
    if not found:
        return _flip(random, data)
    a, b = random.choice(found).span()
    return data[:a] + random.choice(EXTREME).encode() + data[b:]


def _swap_lines(random: Random, data: bytes) -> bytes:
    lines = data.split(b"\n")
    i, j = random.randrange(len(lines)), random.randrange(len(lines))
    lines[i], lines[j] = lines[j], lines[i]
    return b"\n".join(lines)


def _swap_words(random: Random, data: bytes) -> bytes:
    words = re.split(rb"(\s+)", data)
    i, j = random.randrange(len(words)), random.randrange(len(words))
    words[i], words[j] = words[j], words[i]
    return b"".join(words)


MUTATIONS: tuple[Callable[[Random, bytes], bytes], ...] = (
    *(_cut, _remove, _repeat, _flip, _word, _insert, _number, _number, _swap_lines, _swap_words),
)
