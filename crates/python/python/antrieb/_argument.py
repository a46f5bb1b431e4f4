"""Arguments of objects at the places of faults: the text of a project of objects is not that of the user."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from antrieb._call import AntriebError

_HEAD = re.compile(r"\s*(\[\[?)\s*([A-Za-z0-9_.]+)\s*\]")
_KEY = re.compile(r"\s*([A-Za-z0-9_.]+)\s*=")


def path_at(text: str, line: int) -> str:
    """The path of the key, else of the table, at a line counted from one: `motion[2].time`."""
    table, key = "", ""
    counts: dict[str, int] = {}
    for each in text.split("\n")[:line]:
        if head := _HEAD.match(each):
            name = head[2]
            if head[1] == "[[":
                counts[name] = counts.get(name, 0) + 1
                # Entries of the tables below count anew.
                counts = {other: count for other, count in counts.items() if not other.startswith(f"{name}.")}
            table, key = _counted(name, counts), ""
        elif found := _KEY.match(each):
            key = found[1]
    return ".".join(part for part in (table, key) if part)


def _counted(name: str, counts: dict[str, int]) -> str:
    parts = name.split(".")
    heads = [".".join(parts[: at + 1]) for at in range(len(parts))]
    return ".".join(f"{part}[{counts[head]}]" if head in counts else part for part, head in zip(parts, heads, strict=True))


def named(path: str) -> str:
    """The argument for a key: `supply` for `requirements.supply`, `Arm.mass` for `mechanism.arm.mass`."""
    from antrieb import sections

    axis, inside = "", path
    if found := re.match(r"(axis\[\d+\])\.?(.*)", path):
        axis, inside = f"{found[1]}.", found[2]
    parts = inside.split(".")
    if parts[0] in ("axis", "requirements"):
        parts = parts[1:]
    elif parts[0] == "mechanism":
        parts = parts[1:]
    if parts and (own := _class(parts[0], sections)):
        parts[0] = own
    return (axis + ".".join(parts)).rstrip(".") or path


def _class(name: str, sections: Any) -> str:
    """The class of a section; empty for a field and for an entry of a list."""
    own = "".join(part.capitalize() for part in name.split("_"))
    return own if own in sections.__all__ else ""


ARGUMENTS = (
    (r'regardless of the file, units = \{ (\w+) = "…" \} states it in the project', r"\1_unit=… states it"),
    (r'unabhängig von der Datei gibt units = \{ (\w+) = "…" \} sie im Projekt an', r"\1_unit=… gibt sie an"),
    (r'columns\.(\w+) = "none"', r"\1=None"),
    (r'choose the window, from = "…" and to = "…", state standstill = "…", or ', "hand over the rows of one cycle, or "),
    (r'das Fenster wählen, from = "…" und to = "…", standstill = "…" oder ', "die Reihen eines Zyklus übergeben oder "),
    (r"(?:state |unter \[axis\] )?single_move = true(?: under \[axis\])?", "single_move=True"),
    (r"`axis\.single_move`", "`single_move=True`"),
    (r" ?\(recorded_ratio\)", ""),
)
"""Keys of a project file in faults of recordings, and the arguments in their place."""


def of_recordings(fault: dict[str, Any], names: Iterable[str]) -> dict[str, Any]:
    """The fault of a recording that is in no file: rows of the arrays in place of lines, arguments in place of keys."""
    message = str(fault.get("message", ""))
    for name in names:
        if message.startswith(f"{name}: "):
            # The first row is behind the headings.
            rows = re.sub(r"\b(?:line|Zeile) (\d+)", lambda found: f"{'row' if found[0][0] == 'l' else 'Reihe'} {int(found[1]) - 2}", message)
            fault = {**fault, "message": rows.removeprefix(f"{name}: ")}
    for key in ("message", "hint"):
        for pattern, own in ARGUMENTS:
            if fault.get(key):
                fault = {**fault, key: re.sub(pattern, own, fault[key])}
    return fault


def by_argument(error: AntriebError, text: str, recordings: Iterable[str] = ()) -> AntriebError:
    """The exception with the argument of each fault in place of its line in a text that no user has seen."""
    names = list(recordings)
    errors: list[dict[str, Any]] = []
    for fault in error.record.get("errors", []):
        line = fault.get("line")
        if str(fault.get("id", "")).startswith("code_") and fault.get("file") and line:
            # A place in an ordering code is none in the text of the project.
            fault = {**{name: value for name, value in fault.items() if name not in ("file", "line", "column")}, "option": "code"}
        elif line and not fault.get("option"):
            rest = {name: value for name, value in fault.items() if name not in ("line", "column")}
            fault = {**rest, "option": named(path_at(text, line))}
        errors.append(of_recordings(fault, names) if names else fault)
    return type(error)({**error.record, "errors": errors})
