"""Columns of a sweep by the keys of a project: `{"motion.1.payload": q([1, 2], "kg")}`."""

# Values of other libraries and of files have no types until they are looked at; the classes of one package share what is private.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportPrivateUsage=false

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping
from decimal import Decimal
from typing import Any

from antrieb._axis import BaseAxis, joined
from antrieb._fault import fault
from antrieb._quantity import columns_of
from antrieb._section import ReturnMove, _steps, distance_of
from antrieb._source import ProjectSource

ROWS_MOST = 100_000_000
"""Rows that a grid may have."""


def heading(key: str, source: ProjectSource | None, unit: str | None = None) -> str:
    """Returns the heading of a column: `motion.1.payload` and its unit as `motion[1].payload [kg]`."""
    from antrieb.sections import Axis

    name, bracket, rest = key.partition(" [")
    if isinstance(source, BaseAxis):
        path = source._path(name)
    else:
        first, *inner = _steps(name)
        path = joined(["requirements", first, *inner] if first in Axis._REQUIREMENTS else [first, *inner])
    if bracket:
        if unit:
            raise fault(f"{key}: the column has a unit already, {unit}", f'write the key as "{name}"')
        return f"{path} [{rest}"
    return f"{path} [{unit}]" if unit else path


def columns(values: Mapping[str, Any], source: ProjectSource | None = None, grid: bool = False) -> dict[str, list[Any]]:
    """Returns the columns of a table by their headings; with `grid` a row for each combination, the last key fastest.

    Raises:
        AntriebError: The columns have different lengths, a key stands twice, or counts from zero.
        TypeError: A value is none that a column can have.
    """
    found: dict[str, list[Any]] = {}
    for key, value in values.items():
        # Callers without a type checker.
        if not isinstance(key, str):  # pyright: ignore[reportUnnecessaryIsInstance]
            raise TypeError(f"a key of a table is a text such as 'motion.1.payload', not {type(key).__name__}")
        if value is None or isinstance(value, (bool, Mapping)):
            raise TypeError(f"{key}: a list or an array is expected, not {type(value).__name__}")
        if not isinstance(value, (str, Iterable)) and not hasattr(value, "magnitude"):
            example = f'antrieb.q([{value!r}], "kg")'
            raise TypeError(f"{key}: a list or an array is expected, such as {example}, not {value!r}")
        numbers = columns_of(value, key)
        if numbers is not None:
            head, cells = heading(key, source, numbers.unit or None), list[Any](numbers.values)
        else:
            of: Any = value
            listed: Any = of.tolist() if hasattr(of, "tolist") else of
            head, cells = heading(key, source), [listed] if isinstance(listed, str) else list(listed)
        if head in found:
            raise fault(f"{key}: the key stands twice", "give all its values in one column")
        found[head] = cells
    if grid:
        count = 1
        for cells in found.values():
            count *= len(cells)
        if count > ROWS_MOST:
            raise fault(f"grid: {count} rows are more than {ROWS_MOST}", "take fewer values")
        rows = list(itertools.product(*found.values()))
        found = {head: [row[place] for row in rows] for place, head in enumerate(found)}
    lengths = {head: len(cells) for head, cells in found.items()}
    if len(set(lengths.values())) > 1:
        shown = ", ".join(f"{head} has {count}" for head, count in lengths.items())
        raise fault(f"the columns have different lengths: {shown}", "grid=True takes every combination")
    if isinstance(source, BaseAxis):
        found.update(_ways_back(found, source))
    return found


def _ways_back(found: Mapping[str, list[Any]], axis: BaseAxis) -> dict[str, list[Any]]:
    """The distances of the ways back where distances before them are swept."""
    swept: dict[int, tuple[str, list[Any]]] = {}
    for head, cells in found.items():
        name, _, unit = head.partition(" [")
        steps = _steps(name)
        if len(steps) == 3 and steps[0] == "motion" and steps[2] == "distance" and isinstance(steps[1], int):
            swept[steps[1]] = (unit.rstrip("]"), cells)
    out: dict[str, list[Any]] = {}
    for place, segment in enumerate(axis.motion, 1):
        if not isinstance(segment, ReturnMove) or not any(before < place for before in swept):
            continue
        rows: list[float] = []
        units: set[str] = set()
        for row in range(len(next(iter(found.values())))):
            total = Decimal(0)
            for before in range(1, place):
                own = axis.motion[before - 1]
                if before in swept:
                    unit, cells = swept[before]
                    number = Decimal(repr(cells[row]))
                elif isinstance(own, ReturnMove):
                    # The way back to the beginning ends where it began.
                    total = Decimal(0)
                    continue
                else:
                    number, unit = distance_of([own], "Return")
                    if not unit:
                        continue
                total += number
                units.add(unit)
            rows.append(float(-total))
        if len(units) > 1:
            raise fault(f"motion[{place}]: the distances before the way back are in {' and '.join(sorted(units))}", "sweep them in one unit")
        out[f"motion[{place}].distance [{units.pop()}]"] = rows
    return out

