"""Records of answers: shown in a few lines, found by code or id, handed over as dictionaries and data frames."""

from __future__ import annotations

import dataclasses
import difflib
import importlib
import operator
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, Generic, SupportsIndex, TypeVar, overload

if TYPE_CHECKING:
    from antrieb._lines import Line
    from antrieb.answers import Explained

T = TypeVar("T")

NAMES = ("id", "code", "name", "axis", "key", "symbol", "file")
"""Fields by which a record of a list is found, in this order."""


DERIVED = {"Rejection": ("verdict", "tightest")}
"""Properties that data frames have beside the fields of the JSON, so that all entries of `candidates` have the same columns."""


INSTEAD = {("Rejection", "checks"): "of an actuator that does not fit the answer has `check`, which excludes it; antrieb.check(project, code).axes[0].checks has all"}
"""Where the values are that a record of a list lacks and others of it have."""


class Record:
    """An answer, or a part of one: its fields are those of the JSON of the command line."""

    __slots__ = ("_kept", "_origin")

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            hint = INSTEAD.get((type(self).__name__, name), "it has " + ", ".join(_names(type(self))))
            raise AttributeError(f"{type(self).__name__} has no field {name!r}; {hint}")

    def to_dict(self) -> dict[str, Any]:
        """Return the fields as dictionaries and lists, by the names of Python."""
        return {name: _plain(getattr(self, name)) for name in _names(type(self))}

    def to_dicts(self) -> list[dict[str, Any]]:
        """Return the entries over which the answer iterates as dictionaries.

        Raises:
            TypeError: It has no entries, or several lists of them.
        """
        return Rows(_entries(self, "to_dicts")).to_dicts()

    def to_pandas(self) -> Any:
        """Return a data frame of pandas, a row for each entry over which the answer iterates.

        Entries that are lists themselves have a row for each of theirs: the pins of the connectors, the values of the
        sections, the points of the curves; those of several axes have the axis in front.

        Raises:
            TypeError: It has no entries, or several lists of them.
        """
        return _library("pandas", "to_pandas").DataFrame(_frame(self, "to_pandas"))

    def to_polars(self) -> Any:
        """Return a data frame of polars with the rows of `to_pandas`.

        Raises:
            TypeError: It has no entries, or several lists of them.
        """
        return _library("polars", "to_polars").DataFrame(_frame(self, "to_polars"), strict=False)

    def arrays(self) -> Rows[Line]:
        """Return what a picture of the answer shows as arrays with labels and units; see `antrieb.Line`.

        A table with a course has each quantity over time, `curve` its curves, `torsion` the curve of the gear, and `check`
        the utilisations as bars.

        Raises:
            TypeError: No picture shows it.
        """
        from antrieb import _lines

        return _lines.of_answer(self)

    def __repr__(self) -> str:
        from antrieb import _shown

        return _shown.text(self)

    def __str__(self) -> str:
        from antrieb import _shown

        return _shown.full(self)

    def _repr_html_(self) -> str:
        from antrieb import _shown

        return _shown.html(self)

    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]:
        fields = tuple(getattr(self, name) for name in _names(type(self)))
        return _again, (type(self), fields, getattr(self, "_origin", None))


class Explainable(Record):
    """A check of an answer, which knows the call that it comes from."""

    __slots__ = ()

    def explain(self, *, deadline: str | None = None) -> Explained:
        """Return the derivation of its value and its limit; a notebook shows it as formulas.

        Raises:
            ValueError: The check was not made by a call, or its project has changed since.
        """
        from antrieb import _origin

        return _origin.explained(self, deadline)


def place_of(key: Any, expected: str) -> int:
    """The number of an entry.

    Raises:
        TypeError: The key is no whole number.
    """
    try:
        if not isinstance(key, bool):
            return operator.index(key)
        raise TypeError
    except TypeError:
        raise TypeError(f"{expected} is expected, not {type(key).__name__}") from None


class Tabular(Record):
    """A table of an answer: its rows by place, its columns by name."""

    __slots__ = ()

    def __iter__(self) -> Iterator[dict[str, Any]]:
        own: Any = self
        return iter(own.rows)

    def __getitem__(self, key: int | str, /) -> Any:
        own: Any = self
        place: Any = key
        if isinstance(place, slice):
            return own.rows[place]
        if not isinstance(key, str):
            return own.rows[place_of(key, "a row by its number, or a column by its name")]
        if own.columns._named(key) is not None:
            return [row[key] for row in own.rows]
        raise KeyError(key)


class Rows(list[T], Generic[T]):
    """A list of records, found by place, or by code, id or name: `checks["thermal"]`."""

    __slots__ = ()

    @overload
    def __getitem__(self, key: SupportsIndex, /) -> T: ...

    @overload
    def __getitem__(self, key: slice, /) -> Rows[T]: ...

    @overload
    def __getitem__(self, key: str, /) -> T: ...

    def __getitem__(self, key: SupportsIndex | slice | str, /) -> T | Rows[T]:
        if isinstance(key, str):
            return self._named(key)
        if isinstance(key, slice):
            return Rows(super().__getitem__(key))
        place = place_of(key, "an entry by its number, or by its code, id or name")
        try:
            return super().__getitem__(place)
        except IndexError:
            raise IndexError(f"there are {len(self)} entries, the first at 0, and none at {place}") from None

    def __contains__(self, item: object, /) -> bool:
        return any(item in _names_of(each) for each in self) if isinstance(item, str) else super().__contains__(item)

    def _named(self, key: str) -> T:
        found = [each for each in self if key in _names_of(each)]
        if len(found) == 1:
            return found[0]
        if found:
            raise KeyError(f"{key!r} is the name of {len(found)} entries; take them by place or from a loop")
        from antrieb import _origin

        if shown := _origin.unlisted(self, key):
            raise KeyError(shown)
        known = [name for each in self for name in _names_of(each)]
        near = difflib.get_close_matches(key, known, 3)
        hint = f"; did you mean {' or '.join(map(repr, near))}?" if near else f"; there are {len(self)} entries"
        raise KeyError(f"no entry is called {key!r}{hint}")

    def keys(self) -> list[str]:
        """Return the names of the entries: codes, ids or names."""
        return [names[0] if (names := _names_of(each)) else "" for each in self]

    def to_dicts(self) -> list[dict[str, Any]]:
        """Return the records as dictionaries."""
        return [each.to_dict() if isinstance(each, Record) else _plain(each) for each in self]

    def to_pandas(self) -> Any:
        """Return a data frame of pandas, a row for each record: its plain fields, and those of records in it as `demand.T_rms`."""
        return _library("pandas", "to_pandas").DataFrame(_columns(_rows(self)))

    def to_polars(self) -> Any:
        """Return a data frame of polars, a row for each record: its plain fields, and those of records in it as `demand.T_rms`."""
        return _library("polars", "to_polars").DataFrame(_columns(_rows(self)), strict=False)

    def _columns(self) -> dict[str, list[Any]]:
        return _columns([_flat(each) for each in self])

    def __repr__(self) -> str:
        from antrieb import _shown

        return _shown.text_of_rows(self)

    def _repr_html_(self) -> str:
        from antrieb import _shown

        return _shown.html_of_rows(self)


class Named(dict[str, T], Generic[T]):
    """Records by their names, shown as a table."""

    __slots__ = ()

    def __repr__(self) -> str:
        from antrieb import _shown

        return _shown.text_of_fields(self)

    def _repr_html_(self) -> str:
        from antrieb import _shown

        return _shown.html_of_fields(self)


def _again(of: type[Record], fields: Iterable[Any], origin: Any) -> Record:
    """A record out of what `__reduce__` hands over."""
    record = of(**dict(zip(_names(of), fields, strict=True)))
    if origin is not None:
        object.__setattr__(record, "_origin", origin)
    return record


def _names(of: Any) -> list[str]:
    return [each.name for each in dataclasses.fields(of)]


def _names_of(record: Any) -> list[str]:
    found = (getattr(record, name, None) for name in NAMES)
    return [name for name in found if isinstance(name, str)][:2]


def _plain(given: Any) -> Any:
    value: Any = given
    if isinstance(given, Record):
        return given.to_dict()
    if isinstance(given, list):
        return [_plain(each) for each in value]
    if isinstance(given, dict):
        return {name: _plain(each) for name, each in value.items()}
    return value


def _flat(record: Any, above: str = "") -> dict[str, Any]:
    """The plain fields of a record, and those of the records in it; lists of texts joined, lists of records left out."""
    if not isinstance(record, Record):
        return {above.rstrip(".") or "value": record}
    found: dict[str, Any] = {}
    for name in [*_names(type(record)), *DERIVED.get(type(record).__name__, ())]:
        value: Any = getattr(record, name)
        values: Any = value
        if isinstance(value, Record):
            found.update(_flat(value, f"{above}{name}."))
        elif isinstance(value, list):
            if not any(isinstance(each, (Record, list)) for each in values):
                found[above + name] = "; ".join(map(str, values)) or None
        elif not isinstance(value, dict):
            found[above + name] = value
    return found


INSIDE = {"BearingOfSize": "checks", "Connector": "pins", "EncoderWord": "fields", "Measured": "units", "SheetSection": "values", "CommissionList": "entries"}
"""Lists that hold what the entries of a list are about."""


def _columns(rows: list[dict[str, Any]]) -> dict[str, list[Any]]:
    names = dict.fromkeys(name for row in rows for name in row)
    return {name: [row.get(name) for row in rows] for name in names}


def _rows(entries: Iterable[Any]) -> list[dict[str, Any]]:
    """The rows of a data frame: one for each entry, or one for each of what the entries hold."""
    rows: list[dict[str, Any]] = []
    for each in entries:
        given: Any = each
        own: dict[str, Any] = given if isinstance(each, dict) else _of_line(each) if type(each).__name__ == "Line" else _flat(each)
        inside = _inside(each)
        rows.extend({**own, **part} for part in inside or [{}])
    return rows


def _of_line(line: Any) -> dict[str, Any]:
    """The fields of a line beside its points."""
    return {name: getattr(line, name) for name in _names(type(line)) if name not in ("x", "y")}


def _inside(record: Any) -> list[dict[str, Any]]:
    """What an entry holds, with the name of its list in front."""
    if type(record).__name__ == "Line":
        return [{"x": x, "y": y} for x, y in zip(record.x, record.y, strict=True)]
    if type(record).__name__ == "Curve":
        edges: list[tuple[str, list[Any]]] = [("value", record.points), ("upper", record.upper or [])]
        return [{"edge": edge, "n": point[0], "T": point[1]} for edge, points in edges for point in points]
    field = INSIDE.get(type(record).__name__, "")
    parts: list[Any] = getattr(record, field, None) or []
    return [_flat(part, f"{field}.") for part in parts]


def _entries(record: Any, method: str) -> list[Any]:
    """The entries over which a record iterates."""
    of: Any = type(record)  # pyright: ignore[reportUnknownVariableType]
    if hasattr(of, "__iter__"):
        return list(record)
    lists = [name for name in _names(type(record)) if isinstance(getattr(record, name), Rows)]
    name = type(record).__name__
    if lists:
        raise TypeError(f"{name} has several lists; write .{lists[0]}.{method}(); there are {', '.join(lists)}")
    raise TypeError(f"{name} is one record without a list; to_dict() returns its fields")


def _frame(record: Any, method: str) -> dict[str, list[Any]]:
    """The columns of a data frame of a record."""
    entries = _entries(record, method)
    if not type(record).__name__.startswith("AxesOf"):
        return _columns(_rows_of(record, entries))
    rows: list[dict[str, Any]] = []
    for each in entries:
        rows.extend({"axis": each.axis, **row} for row in _rows_of(each, _entries(each, method)))
    return _columns(rows)


def _rows_of(record: Any, entries: list[Any]) -> list[dict[str, Any]]:
    """The rows of a record; of a comparison one for each check of each actuator."""
    if type(record).__name__ == "Line":
        return [{record.x_label: x, record.y_label: y} for x, y in zip(record.x, record.y, strict=True)]
    if type(record).__name__ == "Grid":
        cells = [(x, y, z) for y, row in zip(record.y, record.z, strict=True) for x, z in zip(record.x, row, strict=True)]
        return [{record.x_label: x, record.y_label: y, record.z_label: z} for x, y, z in cells]
    if type(record).__name__ != "Comparison":
        return _rows(entries)
    return [
        {**_flat(row), "code": head.code, **_flat(answer, "answers.")}
        for row in entries
        for head, answer in zip(record.candidates, row.answers, strict=True)
        if answer is not None
    ]


def _library(name: str, method: str) -> Any:
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        if error.name != name:
            raise
        raise ModuleNotFoundError(f"{method}() needs {name}: pip install {name}; to_dicts() needs nothing", name=name) from None
