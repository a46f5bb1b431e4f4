"""Columns of a sweep by the keys of a project: `{"motion.1.payload": q([1, 2], "kg")}`."""

# Values of other libraries and of files have no types until they are looked at; the classes of one package share what is private.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportPrivateUsage=false

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Collection, Mapping
from decimal import Decimal
from typing import Any

from antrieb import _axis
from antrieb._antrieb import Table
from antrieb._axis import BaseAxis, BaseProject
from antrieb._fault import fault, faults
from antrieb._plain import is_time, seconds, text
from antrieb._quantity import Q, columns_of, unit_of_time
from antrieb._quantity import split as split_text
from antrieb._section import ReturnMove, _steps, distance_of
from antrieb._source import ProjectSource
from antrieb._tables import Column, _is_empty, arrow_library, cells, joined, split

ROWS_MOST = 100_000_000
"""Rows that a grid may have."""


ROOTS = ("axis", "load", "mechanism", "motion", "requirements", "actuator")
"""Beginnings of keys that are no fields of an axis."""


def is_of_project(key: str) -> bool:
    """Returns true for a key that a project may have; any other column is a label."""
    from antrieb.sections import Axis

    first = key.partition(" [")[0].replace("[", ".").partition(".")[0]
    return first in Axis._KEYS or first in ROOTS


def heading(key: str, source: ProjectSource | None, unit: str | None = None) -> str:
    """Returns the heading of a column: `motion.1.payload` and its unit as `motion[1].payload [kg]`."""
    from antrieb.sections import Axis

    name, own = parted(key)
    first = name.replace("[", ".").partition(".")[0]
    if not is_of_project(name):
        # A label, or a key that no project has: its dots count no entries.
        return f"{key} [{unit}]" if unit else key
    if isinstance(source, BaseAxis):
        path = source._path(name)
    else:
        steps = _steps(name)
        path = _axis.joined(["requirements", *steps] if first in Axis._REQUIREMENTS else steps)
    path = _without_alias(path)
    if own and unit:
        raise fault(f"{key}: the column has a unit already, {unit}", f'write the key as "{name}"')
    return f"{path} [{unit}]" if unit else path + own


_UNIT = re.compile(r"(.*?)(\s*\(.*\)\s*|\s+/\s+\S+)")
"""Name of a heading, and its unit in round brackets or behind a stroke."""


def parted(key: str) -> tuple[str, str]:
    """Returns the name of a heading, and its unit as it is written: `ambient_degC` is `ambient` and `_degC`."""
    name, bracket, rest = key.partition(" [")
    if bracket:
        return name, f" [{rest}"
    match = _UNIT.fullmatch(key)
    if match is not None and is_of_project(match[1]):
        return match[1], match[2]
    # The unit behind an underscore: the name without it is a key, and the whole is none.
    name, line, unit = key.rpartition("_")
    is_key = bool(name) and is_of_project(name) and not _is_field(key)
    return (name, line + unit) if is_key else (key, "")


def _is_field(key: str) -> bool:
    """Returns true if the last name of a path is that of a field of some section."""
    from antrieb import sections

    last = key.rpartition(".")[2]
    of_classes = (getattr(each, "_KEYS", {}) for each in vars(sections).values() if isinstance(each, type))
    return any(last in keys for keys in of_classes)


def _without_alias(path: str) -> str:
    """The path of the key that another name stands for: `mechanism.arm.angle` is `mechanism.arm.start_angle`."""
    from antrieb import sections

    parts = path.split(".")
    if len(parts) == 3 and parts[0] == "mechanism":
        of: Any = getattr(sections, "".join(part.capitalize() for part in parts[1].split("_")), None)
        kind = getattr(of, "_KEYS", {}).get(parts[2])
        if kind is not None and kind.of == "alias":
            parts[2] = kind.of_key
    return ".".join(parts)


def columns(table: Any, source: ProjectSource | None = None, grid: bool = False, name: str = "table", index: Collection[str] | None = None) -> list[Column]:
    """Returns the columns of any table by their headings; with `grid` a row for each combination, the last key fastest.

    Args:
        table: The table.
        source: The project, where it is of objects.
        grid: Every combination of the values of the columns.
        name: The argument that the table is.
        index: Headings; an index of pandas without a name is a column if they have its title.

    Raises:
        AntriebError: The columns have different lengths, a key stands twice, or counts from zero.
        TypeError: A value is none that a column can have.
    """
    if isinstance(table, Mapping):
        table = {key: _one_text(key, value, name) if isinstance(value, str) else value for key, value in table.items()}
    found: dict[str, Any] = {}
    for key, given in split(table, name, index):
        values: Any = given
        unit: str | None = None
        is_key = is_of_project(key) and "." in heading(key, source)
        if (is_key or _time_word(key) in TIMES) and is_time(given):
            values = _times(given, key, name)
        elif is_key and " [" not in key:
            values = _quantities(given, key)
        if isinstance(values, Q):
            unit = values.unit or None
            values = cells(values)
        head = heading(key, source, unit)
        if head in found:
            raise fault(f"{key}: the key stands twice", "give all its values in one column")
        found[head] = values
    if grid:
        count = 1
        for each in found.values():
            count *= len(each)
        if count > ROWS_MOST:
            raise fault(f"grid: {count} rows are more than {ROWS_MOST}", "take fewer values")
        rows = list(itertools.product(*map(_plain, found.values())))
        kept = {head: isinstance(values, list) for head, values in found.items()}
        found = {head: [row[place] for row in rows] for place, head in enumerate(found)}
        # A column that was not a list has a type of its own.
        found = {head: values if kept[head] else dict(split({head: values}, name))[head] for head, values in found.items()}
    lengths = {head: len(each) for head, each in found.items()}
    if len(set(lengths.values())) > 1:
        shown = ", ".join(f"{head} has {count}" for head, count in lengths.items())
        raise fault(f"the columns have different lengths: {shown}", "grid=True takes every combination")
    if isinstance(source, BaseAxis):
        found.update(_ways_back(found, source))
    elif isinstance(source, BaseProject):
        _refuse_ways_back(found, source, name)
    return list(found.items())


TIMES = ("time", "zeit", "dauer", "duration", "schaltzeit", "cycle", "cycle_time", "zyklus", "zykluszeit", "taktzeit", "pause")
"""Words for times of a project."""


def _time_word(key: str) -> str:
    """The word of a heading without its unit, in small letters: `time_s` and `Time [s]` are `time`."""
    name = key.partition(" [")[0].strip().lower()
    word, _, unit = name.rpartition("_")
    return word if word in TIMES and unit in ("s", "ms", "us", "min", "h") else name


def _one_text(key: Any, value: str, name: str) -> list[str]:
    """A text as the only value of its column; a number alone is none, as it is none without quotes."""
    found = split_text(value)
    if found is not None and not found[1] and "[" in str(key):
        raise TypeError(f"{name}: column {key!r} is one value ({value!r}); give a list with a value for each row")
    return [text(value, f"{name}: column {key!r}")]


def _times(values: Any, key: str, name: str) -> Any:
    """Intervals as numbers in the unit of the heading, else in seconds."""
    place = f"{name}: column {key!r}"
    unit = parted(key)[1].strip(" []()/_") or key.lower().strip().removeprefix(_time_word(key)).strip(" []_")
    if not unit:
        return Q(tuple(seconds(values, place)), "s")
    return seconds(values, place, unit=unit_of_time(unit, place))


def _quantities(values: Any, key: str) -> Any:
    """Texts of quantities in one unit as numbers with their unit, also with empty cells among them; other values as they are."""
    texts = values
    if not isinstance(values, (list, Q)):
        kind = str(getattr(values, "dtype", getattr(values, "type", ""))).lower()
        texts = _plain(values) if kind in TEXTS or kind.startswith(CATEGORIES) else []
    if not isinstance(texts, list):
        return values
    known = [each for each in texts if not _is_empty(each)]
    band = next((each for each in known if isinstance(each, str) and ("±" in each or "+/-" in each)), None)
    if band is not None:
        raise fault(f"{key}: {band!r:.40} has a tolerance, and the values of a sweep have none", "state the tolerance in the project, and judge it with size or check")
    found = columns_of(known, key) if known and all(isinstance(each, str) for each in known) else None
    if found is None or len(known) == len(texts):
        return found or values
    numbers = iter(found.values)
    return Q(tuple(math.nan if _is_empty(each) else next(numbers) for each in texts), found.unit)


TEXTS = ("str", "string", "large_string", "string_view")
"""Types of texts, as the libraries write them."""

CATEGORIES = ("category", "categorical", "enum", "dictionary<values=string", "dictionary<values=large_string")
"""Beginnings of the types of texts of which each stands once."""


def _plain(values: Any) -> list[Any]:
    """The values of a column of any library."""
    if isinstance(values, list):
        return values
    found: list[Any] = values.to_pylist() if hasattr(values, "to_pylist") else values.to_list()
    return found


def keyed(table: Any, source: ProjectSource | None, grid: bool = False, name: str = "table") -> Any:
    """Returns any table as one of Arrow whose headings are those of the project file."""
    if _is_schema(table):
        library = arrow_library()
        if library is None or library.__name__ != "pyarrow":
            return table
        table = library.schema(table).empty_table()
    if _is_ready(table, source):
        return table
    return joined(columns(table, source, grid, name), name)


def _is_schema(table: Any) -> bool:
    return hasattr(table, "__arrow_c_schema__") and not hasattr(table, "__arrow_c_stream__") and not hasattr(table, "__arrow_c_array__")


def _is_ready(table: Any, source: ProjectSource | None) -> bool:
    """Returns true if a table is read as it is: its columns are called as in the file, or no library can rename them."""
    if has_ways_back(source):
        return False
    if isinstance(table, Table):
        names = table.column_names
        return not isinstance(source, BaseAxis) and all("[" in key or heading(key, source) == key for key in names if "." in key)
    return type(table).__module__.partition(".")[0] not in ("pandas", "polars") and hasattr(table, "__arrow_c_stream__") and arrow_library() is None


def matched(table: Any, source: ProjectSource | None, empty: Table, carried: Collection[str], name: str) -> Any:
    """Returns a table with the columns of an empty one in their order, those that are carried in their types.

    Raises:
        AntriebError: A column is missing, in another unit, or one too many; every one is named.
    """
    headings = empty.column_names
    found = dict(columns(table, source, False, name, headings))
    units = {head.partition(" [")[0]: head for head in found if head not in headings}
    wrong: list[tuple[str, str | None]] = []
    for head in headings:
        other = units.pop(head.partition(" [")[0], None) if head not in found else None
        if other is not None:
            wrong.append((f"{name}: column {other!r} is not the column {head!r} of the sweep", f"give its values below {head!r}"))
        elif head not in found:
            wrong.append((f"{name}: column {head!r} of the sweep is missing", None))
    extra = [(f"{name}: column {head!r} is none of the sweep", "prepare the sweep with it, or leave it out") for head in units.values()]
    if wrong or extra:
        raise faults([*wrong, *extra])
    rows = joined([(head, found[head]) for head in headings], name)
    library = arrow_library()
    if library is None or library.__name__ != "pyarrow" or not carried:
        return rows
    whole = library.table(rows)
    for place, field in enumerate(library.schema(empty)):
        own = whole.schema.field(place).type
        is_alike = _is_text(own, library) and _is_text(field.type, library) or library.types.is_integer(own) and library.types.is_integer(field.type)
        if field.name in carried and own != field.type and is_alike:
            try:
                whole = whole.set_column(place, field.name, whole.column(place).cast(field.type))
            except (library.ArrowException, ValueError) as error:
                raise fault(f"{name}: column {field.name!r}: {error}", f"the sweep was prepared for {field.type}") from None
    return whole


def _is_text(kind: Any, library: Any) -> bool:
    inner = kind.value_type if library.types.is_dictionary(kind) else kind
    return str(inner) in ("string", "large_string", "string_view")


_OF_MOVE = re.compile(
    r"(?P<axis>axis\[\d+\]\.)?motion\[(?P<place>\d+)\]\.(?P<key>distance|law)"
    r"(?:\s*[\[(]\s*(?P<bracket>[^\])]*?)\s*[\])]|\s*/\s*(?P<slash>\S+)|_(?P<underscore>\w+))?\s*"
)
"""Heading of the distance or the law of a move, with its unit in every spelling of recordings."""


def _of_moves(found: Mapping[str, Any], key: str) -> dict[int, tuple[str, str]]:
    """The columns of a key of the moves: their headings and units, by the places of the moves."""
    out: dict[int, tuple[str, str]] = {}
    for head in found:
        match = _OF_MOVE.fullmatch(head)
        if match is not None and match["key"] == key and match["axis"] is None:
            out[int(match["place"])] = (head, match["bracket"] or match["slash"] or match["underscore"] or "")
    return out


def has_ways_back(source: ProjectSource | None) -> bool:
    """Returns true if an axis of objects has a way back, which follows from what stands before it."""
    axes = getattr(source, "axes", ())
    return any(isinstance(segment, ReturnMove) for axis in axes for segment in axis.motion)


def _refuse_ways_back(found: Mapping[str, Any], project: BaseProject, name: str) -> None:
    """Refuses what a way back of a project would have to follow: only the sweep of an axis has it."""
    if not has_ways_back(project):
        return
    for head in found:
        match = _OF_MOVE.fullmatch(head)
        if match is not None:
            raise fault(
                f"{name}: column {head!r} changes a move before a Return, which a sweep of a whole project does not follow",
                f'sweep the axis, such as antrieb.sweep(project["{project.axes[0]._named().get("name", "")}"], …), or write the way back as a Move',
            )


def _ways_back(found: Mapping[str, Any], axis: BaseAxis) -> dict[str, list[Any]]:
    """The distances and laws of the ways back where those of moves before them are swept."""
    distances, laws = _of_moves(found, "distance"), _of_moves(found, "law")
    out: dict[str, list[Any]] = {}
    # The laws of the last move, where they are swept: a way back without a law has that of the move before it.
    swept: list[Any] | None = None
    for place, segment in enumerate(axis.motion, 1):
        is_back = isinstance(segment, ReturnMove)
        if place in laws:
            swept = _plain(found[laws[place][0]])
        elif is_back and segment._values.get("law") is None:
            if swept is not None:
                out[f"motion[{place}].law"] = swept
        elif is_back or isinstance(segment, _moves()):
            swept = None
        if not is_back:
            continue
        if place in distances or not any(before < place for before in distances):
            continue
        parts: list[list[Any] | Decimal] = []
        units: set[str] = set()
        for before in range(1, place):
            own = axis.motion[before - 1]
            if before in distances:
                head, unit = distances[before]
                parts.append(_plain(found[head]))
            elif isinstance(own, ReturnMove):
                # The way back to the beginning ends where it began.
                parts.clear()
                units.clear()
                continue
            else:
                number, unit = distance_of([own], "Return")
                if not unit:
                    continue
                parts.append(number)
            units.add(unit)
        if len(units) > 1:
            raise fault(f"motion[{place}]: the distances before the way back are in {' and '.join(sorted(units))}", "sweep them in one unit")
        if units:
            rows = range(len(next(iter(found.values()))))
            unit = units.pop()
            out[f"motion[{place}].distance [{unit}]" if unit else f"motion[{place}].distance"] = [_back(parts, row) for row in rows]
    return out


def _moves() -> type:
    from antrieb.sections import Move

    return Move


def _back(parts: list[list[Any] | Decimal], row: int) -> float | None:
    """The distance of a way back in a row; `None` where one before it is no number, which is a fault of its own."""
    try:
        numbers = [part if isinstance(part, Decimal) else Decimal(str(part[row])) for part in parts]
    except ArithmeticError:
        return None
    return float(-sum(numbers, Decimal(0)))
