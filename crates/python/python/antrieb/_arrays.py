"""Axes out of arrays: the recorded or planned motion of several joints at once."""

# Values of other libraries and of files have no types until they are looked at; the classes of one package share what is private.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportPrivateUsage=false

from __future__ import annotations

import dataclasses
import difflib
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from antrieb import _antrieb
from antrieb._axis import NAME
from antrieb._called import called as refusing
from antrieb._fault import fault
from antrieb._plain import aligned, is_time, labels, listed, number_of, ordered, refuse_times, seconds, text
from antrieb._quantity import Q, unit_of
from antrieb._section import Load

if TYPE_CHECKING:
    from antrieb.sections import Project

OWN = ("time", "position", "speed", "torque", "names", "mechanism", "time_unit", "position_unit", "speed_unit", "torque_unit")
"""Arguments beside the keywords of an axis."""


@dataclasses.dataclass(frozen=True, slots=True)
class Column:
    """One argument: a row for each instant, a number for each joint."""

    role: str
    unit: str
    rows: list[list[float]]
    labels: list[str] | None = None
    """Headings of the joints, where the argument is a table."""


@refusing
def axes_from_arrays(
    time: Any,
    position: Any = None,
    *,
    speed: Any = None,
    torque: Any = None,
    names: Sequence[str] | None = None,
    mechanism: Load | Sequence[Load] | None = None,
    time_unit: Any = None,
    position_unit: Any = None,
    speed_unit: Any = None,
    torque_unit: Any = None,
    **fields: Any,
) -> Project:
    """Returns the axes of a machine from arrays: a row for each instant, a column for each joint.

    Tables with headings are matched by them, and series with labels of rows by those, never by place.

    The arrays become recordings that the project holds itself; `Project.save` writes them beside its file.

    Args:
        time: The instants; those with a unit of their own (`timedelta64`, `datetime64`, `Duration`) as they are, instants of a
            calendar counted from the first.
        position: Positions at the output, in `position_unit`.
        speed: Speeds at the output, in `speed_unit`; without positions they are integrated.
        torque: Torques at the output with inertia, weight and friction of the joint, in `torque_unit`; without a mechanism.
        names: A name for each joint; without it the headings of a table, else `J1`, `J2`, …
        mechanism: The mechanism of all joints, or one for each; `Joint()` without it, whose torque is recorded.
        time_unit: Unit of `time`; `s` without it. An array with a unit of its own has none beside it, here and below.
        position_unit: Unit of `position`, such as `deg`; `rad` without it.
        speed_unit: Unit of `speed`, such as `1/min`; `rad/s` without it.
        torque_unit: Unit of `torque`; `N m` without it.
        fields: What all axes have: keywords of `Axis`, such as `supply="560 V"`, `brake=True`.

    Raises:
        TypeError: An array is no array of numbers, or an argument is missing or contradicts another.
        AntriebError: The shapes, the headings or the labels of the arrays do not belong together, the instants do not rise, or
            a unit measures something else. Rows are counted from 0, as in Python.
    """
    from antrieb.sections import Axis, Joint, Project, Recorded

    for field in fields:
        if field not in Axis._KEYS:
            known = [*OWN, *Axis._KEYS]
            near = difflib.get_close_matches(field, known, 1)
            hint = f"did you mean {near[0]!r}?" if near else f"its own are {', '.join(OWN)}; the others are those of Axis"
            raise TypeError(f"axes_from_arrays has no argument {field!r}; {hint}")
    labelled = _aligned({"time": time, "position": position, "speed": speed, "torque": torque})
    stamps = _column(labelled["time"], time_unit, "s", "time", None)
    if len(stamps.rows[0]) != 1:
        raise fault("time: an array of one dimension is expected", "hand over the instants once, for all joints")
    count = len(stamps.rows)
    units = {"position": (position_unit, "rad"), "speed": (speed_unit, "rad/s"), "torque": (torque_unit, "N m")}
    columns: list[Column] = []
    for role, (unit, plain) in units.items():
        if labelled[role] is None and unit is not None:
            raise TypeError(f"{role}_unit is the unit of {role}, which is missing")
        if labelled[role] is not None:
            columns.append(_column(labelled[role], unit, plain, role, count))
    roles = [each.role for each in columns]
    if "position" not in roles and "speed" not in roles:
        raise TypeError("axes_from_arrays takes position or speed")
    widths = {len(each.rows[0]) for each in columns}
    if len(widths) > 1:
        shown = ", ".join(f"{each.role} has {len(each.rows[0])}" for each in columns)
        raise fault(f"the arrays have columns for different numbers of joints: {shown}", "give each a column for each joint")
    joints = widths.pop()
    _rising(stamps)
    if isinstance(names, str):
        raise TypeError(f"names is a list such as [{names!r}], not a text")
    titles = _titles(columns)
    called = _called(names) if names is not None else titles or [f"J{place}" for place in range(1, joints + 1)]
    if len(called) != joints:
        raise fault(f"names: {len(called)} names for {joints} joints", "give a name for each column")
    _mechanisms(mechanism)
    each: list[Any] = list(mechanism) if isinstance(mechanism, (list, tuple)) else [mechanism] * joints
    if len(each) != joints:
        raise fault(f"mechanism: {len(each)} mechanisms for {joints} joints", "give one for each column, or one for all")
    if torque is None and any(one is None or isinstance(one, Joint) for one in each):
        raise TypeError("axes_from_arrays takes torque, or for each joint a mechanism such as antrieb.Arm(…) from which it follows")
    twice = [one for one in each if one is not None and not isinstance(one, Joint)]
    if torque is not None and twice:
        raise TypeError(
            "torque is that of the whole joint, with inertia, weight and friction; "
            f"mechanism={type(twice[0]).__name__}(…) would count them a second time: leave out one of them"
        )
    if len(set(called)) != len(called):
        raise fault("names: two joints have the same name", "name each joint once")
    # Names that are the headings choose by them; other names rename in the order of the first table.
    order = called if titles is not None and set(called) == set(titles) else titles
    columns = [_ordered(each, order) for each in columns]
    for column in columns:
        _measured(column, each)
    _measured(stamps, [])
    axes: list[Axis] = []
    for place, name in enumerate(called):
        file = f"{NAME.sub('-', name).strip('-') or 'joint'}-{place + 1}.csv"
        heads = [f"{column.role} [{column.unit}]" for column in (stamps, *columns)]
        cells = [[row[0] for row in stamps.rows], *([row[place] for row in column.rows] for column in columns)]
        content = "\n".join([",".join(heads), *(",".join(map(repr, row)) for row in zip(*cells, strict=True)), ""])
        axis = Axis(name, each[place] or Joint(), [Recorded(file)], **fields)
        axes.append(axis._of(None, "", "", {file: content.encode()}))
    return Project(axes)


def _aligned(given: dict[str, Any]) -> dict[str, Any]:
    """The arguments with their rows in the order of the first one whose rows have labels."""
    found: dict[str, Any] = {}
    first: str | None = None
    for name, value in given.items():
        if not hasattr(value, "iloc"):
            found[name] = value
        elif first is None:
            first, found[name] = name, value
        else:
            found[name] = aligned(value, given[first], name, first)
    return found


def _titles(columns: list[Column]) -> list[str] | None:
    """The headings of the joints: those of the first table; the others have the same.

    Raises:
        AntriebError: Two tables have different headings.
    """
    tables = [each for each in columns if each.labels is not None]
    if not tables:
        return None
    first = tables[0]
    for each in tables[1:]:
        if set(each.labels or ()) != set(first.labels or ()):
            raise fault(
                f"{first.role} has the columns {', '.join(first.labels or ())}, {each.role} has {', '.join(each.labels or ())}",
                "give both the same headings; values.to_numpy() is taken by place",
            )
    return first.labels


def _ordered(column: Column, titles: list[str] | None) -> Column:
    """A column of the joints in the order of these headings; one without headings as it is."""
    if column.labels is None or titles is None or column.labels == titles:
        return column
    places = [column.labels.index(title) for title in titles]
    return dataclasses.replace(column, rows=[[row[place] for place in places] for row in column.rows], labels=titles)


SAMPLES_LEAST = 3
"""Instants that a recording has at least."""


def _rising(stamps: Column) -> None:
    """Refuses instants that do not rise, and too few of them.

    Raises:
        AntriebError: They are none of a recording.
    """
    values = [row[0] for row in stamps.rows]
    if len(values) < SAMPLES_LEAST:
        raise fault(f"time has {len(values)} instants; a recording has {SAMPLES_LEAST} at least", "give a row for each instant")
    wrong = [place for place in range(1, len(values)) if values[place] <= values[place - 1]]
    if not wrong:
        return
    place, unit = wrong[0], stamps.unit
    shown = f"time[{place}] is {values[place]!r} {unit} behind {values[place - 1]!r} {unit}"
    more = f", and {len(wrong) - 1} more do not rise" if len(wrong) > 1 else ""
    hint = "reverse all arrays, as in time[::-1]" if len(wrong) == len(values) - 1 and values[0] > values[-1] else "leave out the rows that stand twice, and sort them by time"
    raise fault(f"time does not rise: {shown}{more}", hint)


MEASURES = {
    "time": ("time",),
    "position": ("angle", "length"),
    "speed": ("rotational speed", "speed"),
    "torque": ("torque", "force"),
}
"""Quantities that a role may have; the second along a line, behind a mechanism that turns it."""


def _measured(column: Column, mechanisms: list[Any]) -> None:
    """Refuses a unit that is none of the argument.

    Raises:
        AntriebError: It is unknown, or measures something else.
    """
    from antrieb._trace import quantities
    from antrieb.sections import Joint

    permitted = MEASURES[column.role]
    is_turning = any(each is None or isinstance(each, Joint) for each in mechanisms)
    wanted = permitted[:1] if is_turning else permitted
    if any(_antrieb.unit_in_si(quantity, column.unit) is not None for quantity in wanted):
        return
    units = {each.quantity: ", ".join(one.unit for one in each.units) for each in quantities()}
    hint = "; ".join(f"{quantity}: {units[quantity]}" for quantity in wanted if quantity in units)
    known = next((each for each in units if _antrieb.unit_in_si(each, column.unit) is not None), None)
    if known is None:
        raise fault(f"{column.role}_unit: {column.unit!r:.40} is no unit that is known", hint)
    along = "; along a line only behind a mechanism such as antrieb.Screw(…)" if known in permitted else ""
    raise fault(f"{column.role}_unit: {column.unit!r:.40} is a unit of {known}{along}", hint)


def _called(names: Any) -> list[str]:
    """The names of joints as they are handed over."""
    if not isinstance(names, Iterable) or hasattr(names, "magnitude"):
        raise TypeError(f"names is a list of texts, not {type(names).__name__}")
    found: list[str] = []
    for place, name in enumerate(listed(names, "names")):
        if not isinstance(name, str) or not name.strip():
            raise TypeError(f"names[{place}] is a text such as 'J{place + 1}', not {name!r:.40}")
        found.append(text(name, f"names[{place}]"))
    return found


def _column(given: Any, unit: Any, plain: str, name: str, count: int | None) -> Column:
    """An argument as rows of numbers, with its unit and the headings of a table."""
    values: Any = given
    is_known = isinstance(values, Q) or (hasattr(values, "magnitude") and hasattr(values, "units"))
    if is_known and unit is not None:
        raise TypeError(f"{name} has the unit {unit_of(values.unit if isinstance(values, Q) else values.units)} already; leave out {name}_unit")
    own = unit_of(plain if unit is None else unit, f"{name}_unit")
    titles: list[str] | None = None
    if isinstance(values, Q):
        own, values = values.unit, list(values.values)
    elif is_known:
        own, values = unit_of(values.units), values.magnitude
        refuse_times(values, name)
    elif isinstance(values, (str, bytes)):
        raise TypeError(f"{name} is an array of numbers, not a text")
    elif is_time(values) and name == "time":
        if unit is not None:
            raise TypeError(f"{name} has a unit already; leave out {name}_unit")
        own, values = "s", seconds(values, name, instants=True)
    else:
        titles, values = _headed(values, name)
        titles, stated = _units_of_headings(titles, values, name)
        if stated is not None and unit is not None and stated != own:
            raise TypeError(f"{name} has the unit {stated} in its headings already; leave out {name}_unit")
        own = stated or own
    rows = _rows(values, name)
    if count is not None and len(rows) != count:
        turned = f"; its rows are joints, hand over {name}.T" if rows and len(rows[0]) == count else ""
        raise fault(f"{name} has {len(rows)} rows for {count} instants{turned}", "give a row for each instant")
    return Column(name, own, rows, titles)


_HEADING = re.compile(r"(.*?)\s*(?:\[([^\[\]]*)\]|\(([^()]*)\))\s*")
"""A name, and a unit in brackets behind it."""


def _units_of_headings(titles: list[str] | None, values: Any, name: str) -> tuple[list[str] | None, str | None]:
    """The headings without their units, and the unit that all of them state; of a series its name is the heading.

    Raises:
        AntriebError: The headings state different units, or some of them none.
    """
    label = getattr(values, "name", None) if titles is None else None
    heads = [label] if titles is None and isinstance(label, str) else titles or []
    parts = [_HEADING.fullmatch(head) for head in heads]
    found = [part[2] or part[3] if part is not None and _is_unit(part[2] or part[3] or "") else None for part in parts]
    # What square brackets hold is meant as a unit; unknown it would be that of the argument.
    unknown = next((head for head, part, unit in zip(heads, parts, found, strict=True) if unit is None and part is not None and _is_meant(part[2])), None)
    if unknown is not None:
        raise fault(f"{name}: the unit of the column {unknown!r} is not known", "write one that `antrieb units` lists, or leave it out of the heading")
    units = list(dict.fromkeys(found))
    if units in ([], [None]):
        return titles, None
    if len(units) > 1:
        shown = ", ".join(f"{head!r}" for head in heads[:6])
        raise fault(f"{name}: its columns are not all in one unit: {shown}", "convert them into one unit, and write it into each heading or into none")
    return (None if titles is None else [part[1] if part is not None else head for part, head in zip(parts, titles, strict=True)]), units[0]


def _is_meant(inside: str | None) -> bool:
    """Returns true if square brackets hold more than an index."""
    return inside is not None and not inside.strip().isdigit() and bool(inside.strip())


def _is_unit(text: str) -> bool:
    from antrieb._trace import quantities

    return bool(text.strip()) and not text.strip().isdigit() and any(_antrieb.unit_in_si(each.quantity, text.strip()) is not None for each in quantities())


def _mechanisms(given: Any) -> None:
    """Refuses what is no mechanism."""
    for one in given if isinstance(given, (list, tuple)) else [given]:
        if one is not None and not isinstance(one, Load):
            raise TypeError(f"mechanism: antrieb.Arm(…) or another mechanism is expected, or one for each joint, not {type(one).__name__}")


def _headed(values: Any, name: str) -> tuple[list[str] | None, Any]:
    """The headings of a table, and what it holds; of an array none."""
    if isinstance(values, Mapping):
        columns = dict(values)
        rows = [list(row) for row in zip(*(listed(each, f"{name}[{key!r}]") for key, each in columns.items()), strict=True)]
        return _texts(list(columns), name), rows
    names = getattr(getattr(values, "dtype", None), "names", None)
    if names:
        return _texts(list(names), name), values
    if getattr(getattr(values, "columns", None), "nlevels", 1) > 1:
        raise TypeError(f"{name}: headings of {values.columns.nlevels} levels; join them to one text")
    titles = labels(values, "column_names" if hasattr(values, "column_names") else "columns") if hasattr(values, "columns") else None
    if hasattr(values, "to_pydict"):
        return _headed(values.to_pydict(), name)
    return (None if titles is None else _texts(titles, name)), values


def _texts(titles: list[Any], name: str) -> list[str]:
    found = [text(each if isinstance(each, str) else str(each), f"{name}: a heading") for each in titles]
    if len(set(found)) < len(found):
        raise fault(f"{name}: two columns have the same heading", "name each joint once")
    return found


def _rows(given: Any, name: str) -> list[list[float]]:
    """The rows of an array; a single column for an array of one dimension."""
    values: Any = given
    ordered(values, name)
    mask = getattr(values, "mask", None)
    if mask is not None and not callable(mask) and bool(getattr(mask, "any", lambda: mask)()):
        raise TypeError(f"{name}: the array has masked values")
    for method in ("to_numpy", "tolist", "to_pylist"):
        refuse_times(values, name)
        values = getattr(values, method, lambda values=values: values)()
    if not isinstance(values, (list, tuple)):
        if not hasattr(values, "__iter__"):
            raise TypeError(f"{name} is an array of numbers, not {type(values).__name__}")
        values = listed(values, name)
    rows = [_row(each, f"{name}[{place}]") for place, each in enumerate(values)]
    if not rows:
        raise fault(f"{name} is empty", "give a row for each instant")
    if len({len(row) for row in rows}) > 1:
        raise fault(f"{name}: its rows have different lengths", "hand over an array with a row for each instant")
    return rows


def _row(given: Any, place: str) -> list[float]:
    """The numbers of one instant."""
    value: Any = given
    if hasattr(value, "tolist") and not isinstance(value, (int, float)):
        refuse_times(value, place)
        value = value.tolist()
    if not isinstance(value, (list, tuple)):
        return [_finite(value, place)]
    return [_finite(each, f"{place}[{joint}]") for joint, each in enumerate(value)]


def _finite(value: Any, place: str) -> float:
    number = float(number_of(value, place))
    if not math.isfinite(number):
        raise fault(f"{place} is not finite: {number!r}", "leave out the instants that were not recorded")
    return number
