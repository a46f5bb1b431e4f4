"""Axes out of arrays: the recorded or planned motion of several joints at once."""

# Values of other libraries and of files have no types until they are looked at; the classes of one package share what is private.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportPrivateUsage=false

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from antrieb._axis import NAME
from antrieb._fault import fault
from antrieb._quantity import Q, unit_of
from antrieb._section import Load

if TYPE_CHECKING:
    from antrieb.sections import Project

Column = tuple[str, str, list[list[float]]]
"""Role, unit, and the numbers of each joint."""


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

    The arrays become recordings that the project holds itself; `Project.save` writes them beside its file.

    Args:
        time: The instants.
        position: Positions at the output, in `position_unit`.
        speed: Speeds at the output, in `speed_unit`; without positions they are integrated.
        torque: Torques at the output with inertia, weight and friction of the joint, in `torque_unit`; without a mechanism.
        names: A name for each joint; `J1`, `J2`, … without it.
        mechanism: The mechanism of all joints, or one for each; `Joint()` without it, whose torque is recorded.
        time_unit: Unit of `time`; `s` without it. An array with a unit of its own has none beside it, here and below.
        position_unit: Unit of `position`, such as `deg`; `rad` without it.
        speed_unit: Unit of `speed`, such as `1/min`; `rad/s` without it.
        torque_unit: Unit of `torque`; `N m` without it.
        fields: What all axes have: keywords of `Axis`, such as `supply="560 V"`, `brake=True`.

    Raises:
        TypeError: An array is no array of numbers, or an argument is missing or contradicts another.
        AntriebError: The shapes of the arrays do not belong together.
    """
    from antrieb.sections import Axis, Joint, Project, Recorded

    stamps_unit, stamps = _rows(time, time_unit, "s", "time", None)
    if stamps and len(stamps[0]) != 1:
        raise fault("time: an array of one dimension is expected", "hand over the instants once, for all joints")
    count = len(stamps)
    given = (
        ("position", position, position_unit, "rad"),
        ("speed", speed, speed_unit, "rad/s"),
        ("torque", torque, torque_unit, "N m"),
    )
    columns: list[Column] = []
    for role, values, unit, plain in given:
        if values is None and unit is not None:
            raise TypeError(f"{role}_unit is the unit of {role}, which is missing")
        if values is not None:
            known, rows = _rows(values, unit, plain, role, count)
            columns.append((role, known, list(map(list, zip(*rows, strict=True)))))
    roles = [role for role, *_ in columns]
    if "position" not in roles and "speed" not in roles:
        raise TypeError("axes_from_arrays takes position or speed")
    widths = {len(joints) for *_, joints in columns}
    if len(widths) > 1:
        shown = ", ".join(f"{role} has {len(joints)}" for role, _, joints in columns)
        raise fault(f"the arrays have columns for different numbers of joints: {shown}", "give each a column for each joint")
    joints = widths.pop()
    if isinstance(names, str):
        raise TypeError(f"names is a list such as [{names!r}], not a text")
    called = _called(names) if names is not None else [f"J{place}" for place in range(1, joints + 1)]
    if len(called) != joints:
        raise fault(f"names: {len(called)} names for {joints} joints", "give a name for each column")
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
    axes: list[Axis] = []
    for place, name in enumerate(called):
        file = f"{NAME.sub('-', name).strip('-') or 'joint'}-{place + 1}.csv"
        heads = [f"time [{stamps_unit}]", *(f"{role} [{unit}]" for role, unit, _ in columns)]
        cells = [[row[0] for row in stamps], *(values[place] for *_, values in columns)]
        content = "\n".join([",".join(heads), *(",".join(map(repr, row)) for row in zip(*cells, strict=True)), ""])
        axis = Axis(name, each[place] or Joint(), [Recorded(file)], **fields)
        axes.append(axis._of(None, "", "", {file: content.encode()}))
    return Project(axes)


def _called(names: Any) -> list[str]:
    """The names of joints as they are handed over."""
    if not isinstance(names, Iterable):
        raise TypeError(f"names is a list of texts, not {type(names).__name__}")
    found: list[str] = []
    for place, name in enumerate(names):
        if not isinstance(name, str) or not name.strip():
            raise TypeError(f"names[{place}] is a text such as 'J{place + 1}', not {name!r:.40}")
        found.append(str(name))
    return found


def _rows(values: Any, unit: Any, plain: str, name: str, count: int | None) -> tuple[str, list[list[float]]]:
    """The unit of an array, and its rows; a single column for an array of one dimension."""
    is_known = isinstance(values, Q) or (hasattr(values, "magnitude") and hasattr(values, "units"))
    if is_known and unit is not None:
        raise TypeError(f"{name} has the unit {unit_of(values.unit if isinstance(values, Q) else values.units)} already; leave out {name}_unit")
    unit = plain if unit is None else unit
    if isinstance(values, Q):
        unit, values = values.unit, list(values.values)
    elif is_known:
        unit, values = unit_of(values.units), values.magnitude
    elif isinstance(values, (str, bytes)):
        raise TypeError(f"{name} is an array of numbers, not a text")
    for method in ("to_numpy", "tolist"):
        values = getattr(values, method, lambda values=values: values)()
    if not isinstance(values, (list, tuple)):
        raise TypeError(f"{name} is an array of numbers, not {type(values).__name__}")
    rows: list[list[Any]] = [list(row) if isinstance(row, (list, tuple)) else [row] for row in values]
    if len({len(row) for row in rows}) > 1:
        raise fault(f"{name}: its rows have different lengths", "hand over an array with a row for each instant")
    if count is not None and len(rows) != count:
        turned = f"; its rows are joints, hand over {name}.T" if rows and len(rows[0]) == count else ""
        raise fault(f"{name} has {len(rows)} rows for {count} instants{turned}", "give a row for each instant")
    if not rows:
        raise fault(f"{name} is empty", "give a row for each instant")
    for place, row in enumerate(rows):
        for value in row:
            if isinstance(value, bool) or not isinstance(value, (int, float)):
                raise TypeError(f"{name}, row {place}: a number is expected, not {value!r}")
            if value != value or value in (float("inf"), float("-inf")):
                raise fault(f"{name}, row {place}, is not finite: {value!r}", "leave out the instants that were not recorded")
    return unit_of(unit), rows
