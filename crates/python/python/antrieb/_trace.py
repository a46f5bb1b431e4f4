"""Recorded runs as they come: a path, the text or the bytes of a file, or a table of columns."""

from __future__ import annotations

import csv
import dataclasses
import functools
import math
import os
import pathlib
import re
import tempfile
from collections.abc import Mapping
from typing import Any

from antrieb import _antrieb
from antrieb._arrow import ArrowArray, ArrowStream
from antrieb._fault import fault
from antrieb._plain import is_time, refuse_times, seconds
from antrieb._quantity import Q, of_pint
from antrieb._tables import arrow, of_cells, of_columns, split

Trace = str | os.PathLike[str] | bytes | ArrowStream | ArrowArray | Mapping[str, Any]
"""A recorded run: the path of its file, a text of several lines, the bytes of a file, or a table with the columns of one:
`time_s`, `position_rad`, `motor_speed_rad_s`, `torque_nm`, `current_q_a` and, if it was measured, `speed_rad_s`. Arrays in other
units have them in the heading, `"position [deg]"`, or are quantities: `{"time": q(t, "ms")}`."""

COLUMNS = {
    "time": ("time_s", "time"),
    "position": ("position_rad", "angle"),
    "speed": ("speed_rad_s", "rotational speed"),
    "motor_speed": ("motor_speed_rad_s", "rotational speed"),
    "torque": ("torque_nm", "torque"),
    "current_q": ("current_q_a", "electric current"),
}
"""Columns by their names without a unit, and the quantities that they hold."""

EXAMPLE = (
    "{'time [s]': t, 'position [deg]': q, 'motor_speed [1/min]': n, 'torque [N m]': m, 'current_q [A]': i}"
)


class HeldFile:
    """A file for the time of a call; what calls it a file sees its name alone."""

    __slots__ = ("_folder", "path")

    def __init__(self, content: bytes, name: str) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="antrieb-")
        self.path = pathlib.Path(self._folder.name, name)
        self.path.write_bytes(content)

    def __fspath__(self) -> str:
        return os.fspath(self.path)

    def end(self) -> None:
        """Removes the file."""
        self._folder.cleanup()

    @property
    def folder(self) -> str:
        """The folder, with the separator behind it."""
        return os.path.join(self._folder.name, "")


def held(name: str, given: Any) -> Any:
    """A path as it is; a text, bytes or a table as a file for the time of a call."""
    path: Any = given
    if hasattr(given, "read") and not hasattr(given, "columns"):
        # An open file, as `io.BytesIO` is one.
        return held(name, given.read())
    if isinstance(given, (bytes, bytearray, memoryview)):
        content = bytes(path)
        if not content:
            raise fault(f"{name}: the file is empty")
        return HeldFile(content, name)
    if isinstance(given, str):
        return HeldFile(given.encode(), name) if "\n" in given else given
    if isinstance(given, os.PathLike):
        return path
    if not _is_table(given):
        raise TypeError(f"{name}: the path of a recorded run, its text or bytes, or a table such as {EXAMPLE} is expected, not {type(given).__name__}")
    columns = _columns(given, name)
    rows = zip(*columns.values(), strict=True)
    with tempfile.SpooledTemporaryFile(mode="w+", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(["" if value is None else repr(value) if isinstance(value, float) else value for value in row] for row in rows)
        file.seek(0)
        return HeldFile(file.read().encode(), name)


def _is_table(given: Any) -> bool:
    """Returns true if the columns have headings."""
    if isinstance(given, (list, tuple)):
        rows: Any = given  # pyright: ignore[reportUnknownVariableType]
        return bool(rows) and (isinstance(rows[0], Mapping) or dataclasses.is_dataclass(rows[0]) or hasattr(rows[0], "_asdict"))
    if hasattr(given, "dtype"):
        return bool(getattr(given.dtype, "names", None))
    return isinstance(given, Mapping) or hasattr(given, "__arrow_c_stream__") or hasattr(given, "collect") or _is_relation(given)


def _is_relation(given: Any) -> bool:
    """Returns true for a relation of DuckDB."""
    return type(given).__module__.partition(".")[0] in ("duckdb", "_duckdb") and hasattr(given, "fetchall")


def _columns(given: Any, name: str) -> dict[str, list[Any]]:
    source: Any = given.collect() if hasattr(given, "collect") and not hasattr(given, "to_dict") else given
    if _is_relation(source):
        source = {heading: values.to_pylist() if hasattr(values, "to_pylist") else list(values) for heading, values in split(source, name)}
    if type(source).__module__.startswith("polars"):
        source = source.to_dict(as_series=False)
    elif hasattr(source, "to_pydict"):
        source = source.to_pydict()
    elif hasattr(source, "read_all"):
        source = source.read_all().to_pydict()
    elif not isinstance(given, Mapping):
        table: Any = arrow(source, name)
        source = table.to_pydict()
    plain: dict[Any, Any] = {}
    factors: dict[Any, float] = {}
    headings: dict[Any, Any] = {}
    for heading, given_values in source.items():
        values: Any = given_values
        if is_time(values):
            if not str(heading).strip().lower().startswith("time"):
                refuse_times(values, f"{name}: column {heading!r}")
            values = Q(tuple(seconds(values, f"{name}: column {heading!r}", instants=True)), "s")
        quantities = of_cells(list(values), f"{name}: column {heading!r}") if type(values) in (list, tuple) else None
        if quantities is not None:
            values = quantities
        own, cells, factor = _of_unit(heading, values, name)
        if own in plain:
            raise fault(f"{name}: two columns are {own!r}")
        plain[own], factors[own], headings[own] = cells, factor, heading
    columns: dict[str, list[Any]] = of_columns(plain, name).to_pydict()
    for heading, cells in columns.items():
        if factors[heading] != 1.0:
            columns[heading] = [_times(value, factors[heading], f"{name}: column {heading!r}, row {row}") for row, value in enumerate(cells)]
    if not columns or not next(iter(columns.values())):
        raise fault(f"{name}: the table has no rows", f"write one such as {EXAMPLE}")
    read = {column for column, _ in COLUMNS.values()}
    for heading, cells in columns.items():
        wrong = next((row for row, value in enumerate(cells) if isinstance(value, bool) or isinstance(value, str) and not _is_number(value)), None)
        if heading in read and wrong is not None:
            raise fault(f"{name}: column {headings[heading]!r}, row {wrong}: a number is expected, not {cells[wrong]!r:.40}")
        empty = [row for row, value in enumerate(cells) if value is None or (isinstance(value, float) and not math.isfinite(value))]
        if heading in read and empty:
            more = f" and {len(empty) - 1} more" if len(empty) > 1 else ""
            raise fault(f"{name}: column {headings[heading]!r} has no number in row {empty[0]}{more}", "leave out the instants that were not recorded")
    return columns


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _of_unit(heading: Any, values: Any, name: str) -> tuple[Any, Any, float]:
    """The heading of a trace file for a column in any unit, its cells, and the factor of their unit."""
    given = values if isinstance(values, Q) else of_pint(values)
    parts = re.fullmatch(r"\s*(.*?)\s*\[([^\]]*)\]\s*", heading) if isinstance(heading, str) else None
    if given is not None and parts:
        raise TypeError(f"{name}: column {heading!r} is a quantity, which has a unit already; write {parts[1]!r}")
    unit = given.unit if given is not None else parts[2] if parts else None
    if unit is None:
        return heading, values, 1.0
    base = re.sub(r"\s+", "_", (parts[1] if parts else str(heading)).strip().lower())
    found = next((found for role, found in COLUMNS.items() if base in (role, found[0])), None)
    if found is None:
        if given is None:
            return heading, values, 1.0
        raise TypeError(f"{name}: {heading!r} is no column of a trace; with units they are {', '.join(COLUMNS)}")
    column, quantity = found
    cells = list(given.values) if given is not None else values
    return column, cells, _factor(unit, quantity, f"{name}: column {heading!r}")


def _factor(unit: str, quantity: str, place: str) -> float:
    """The factor of a unit to that of the trace file, which is that of SI."""
    # The spellings are those of the files: `N·m`, `m*N`, `degree`.
    found = _antrieb.unit_in_si(quantity, unit.strip())
    if found is not None:
        return found
    known = ", ".join(each.unit for each in units_of(quantity))
    raise fault(f"{place}: {unit!r} is no unit of {quantity}", f"units: {known}")


@functools.cache
def quantities() -> list[Any]:
    """The quantities with their units."""
    from antrieb.questions import units

    return list(units().quantities)


def units_of(quantity: str) -> list[Any]:
    """The units of a quantity."""
    return next(list(each.units) for each in quantities() if each.quantity == quantity)


def _times(value: Any, factor: float, place: str) -> float | None:
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise fault(f"{place}: a number is expected, not {value!r:.40}")
    return value * factor
