"""A project as the text of its file."""

# Values of other libraries and of files have no types until they are looked at; the classes of one package share what is private.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportPrivateUsage=false

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any


def rendered(document: dict[str, Any]) -> str:
    """Returns a document as TOML: the values of a table, then the tables inside of it."""
    return "\n".join(_table(document, "")).strip("\n") + "\n"


def _table(table: dict[str, Any], path: str) -> Iterator[str]:
    inner = {key: value for key, value in table.items() if _is_table(value)}
    for key, value in table.items():
        if key not in inner:
            yield f"{key} = {value_text(value)}"
    for key, value in inner.items():
        below = f"{path}.{key}" if path else key
        for each in value if isinstance(value, list) else [value]:
            has_head = isinstance(value, list) or not each or not all(_is_table(part) for part in each.values())
            if has_head:
                yield ""
                yield f"[[{below}]]" if isinstance(value, list) else f"[{below}]"
            yield from _table(each, below)


def _is_table(value: Any) -> bool:
    return isinstance(value, dict) or (isinstance(value, list) and bool(value) and all(isinstance(each, dict) for each in value))


def value_text(value: Any) -> str:
    """Returns a value as TOML."""
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        return f"[{', '.join(map(value_text, value))}]"
    return repr(value)


Change = tuple[str, str, str]
"""Path, value as typed, and what is there then: a `value`, a `table` or nothing (`gone`)."""


def changes(before: dict[str, Any], after: dict[str, Any], path: str = "") -> Iterator[Change]:
    """Iterates over the changes that make one document of the other."""
    for key in before.keys() - after.keys():
        yield from _gone(f"{path}{key}", before[key])
    for key, value in after.items():
        own, old = f"{path}{key}", before.get(key)
        if value == old:
            continue
        if isinstance(value, dict):
            if not isinstance(old, dict):
                yield own, "", "table"
            yield from changes(old if isinstance(old, dict) else {}, value, f"{own}.")
        elif _is_table(value):
            entries: list[dict[str, Any]] = old if isinstance(old, list) and _is_table(old) else []
            for place in range(len(entries), len(value), -1):
                yield f"{own}[{place}]", "", "gone"
            for place, each in enumerate(value, 1):
                if place > len(entries):
                    yield f"{own}[{place}]", "", "table"
                yield from changes(entries[place - 1] if place <= len(entries) else {}, each, f"{own}[{place}].")
        else:
            yield own, _typed(value), "value"


def _gone(path: str, value: Any) -> Iterator[Change]:
    if _is_table(value) and isinstance(value, list):
        for place in range(len(value), 0, -1):
            yield f"{path}[{place}]", "", "gone"
    else:
        yield path, "", "gone"


def _typed(value: Any) -> str:
    """A value as it is typed into a field."""
    if isinstance(value, list):
        is_rows = any(isinstance(each, list) for each in value)
        if is_rows:
            return "\n".join("; ".join(map(str, row)) for row in value)
        return ("\n" if any("=" in str(each) for each in value) else ", ").join(map(str, value))
    return value_text(value) if not isinstance(value, str) else value
