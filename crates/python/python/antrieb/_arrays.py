"""Axes out of arrays: the recorded or planned motion of several joints at once."""

# Values of other libraries and of files have no types until they are looked at; the classes of one package share what is private.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportPrivateUsage=false

from __future__ import annotations

from collections.abc import Sequence
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
    time_unit: Any = "s",
    position_unit: Any = "rad",
    speed_unit: Any = "rad/s",
    torque_unit: Any = "N m",
    **fields: Any,
) -> Project:
    """Returns the axes of a machine from arrays: a row for each instant, a column for each joint.

    The arrays become recordings that the project holds itself; `Project.save` writes them beside its file.

    Args:
        time: The instants.
        position: Positions at the output, in `position_unit`.
        speed: Speeds at the output, in `speed_unit`; without positions they are integrated.
        torque: Torques at the output with inertia, weight and friction of the joint, in `torque_unit`.
        names: A name for each joint; `J1`, `J2`, … without it.
        mechanism: The mechanism of all joints, or one for each; `Joint()` without it, whose torque is recorded.
        time_unit: Unit of `time`.
        position_unit: Unit of `position`, `deg` for one.
        speed_unit: Unit of `speed`, `1/min` for one.
        torque_unit: Unit of `torque`.
        fields: What all axes have: keywords of `Axis`, such as `supply="560 V"`, `brake=True`.

    Raises:
        TypeError: An array is no array of numbers, or an argument is missing.
        AntriebError: The shapes of the arrays do not belong together.
    """
    from antrieb.sections import Axis, Joint, Project, Recorded

    stamps_unit, stamps = _rows(time, time_unit, "time", None)
    if stamps and len(stamps[0]) != 1:
        raise fault("time: an array of one dimension is expected", "hand over the instants once, for all joints")
    count = len(stamps)
    given = (
        ("position", position, position_unit),
        ("speed", speed, speed_unit),
        ("torque", torque, torque_unit),
    )
    columns: list[Column] = []
    for role, values, unit in given:
        if values is not None:
            known, rows = _rows(values, unit, role, count)
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
    called = [str(name) for name in names] if names is not None else [f"J{place}" for place in range(1, joints + 1)]
    if len(called) != joints:
        raise fault(f"names: {len(called)} names for {joints} joints", "give a name for each column")
    each: list[Any] = list(mechanism) if isinstance(mechanism, (list, tuple)) else [mechanism] * joints
    if len(each) != joints:
        raise fault(f"mechanism: {len(each)} mechanisms for {joints} joints", "give one for each column, or one for all")
    if torque is None and any(one is None or isinstance(one, Joint) for one in each):
        raise TypeError("axes_from_arrays takes torque, or for each joint a mechanism such as antrieb.Arm(…) from which it follows")
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


def _rows(values: Any, unit: Any, name: str, count: int | None) -> tuple[str, list[list[float]]]:
    """The unit of an array, and its rows; a single column for an array of one dimension."""
    if isinstance(values, Q):
        unit, values = values.unit, list(values.values)
    elif of_unit := getattr(values, "units", None):
        unit, values = unit_of(of_unit), values.magnitude
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
