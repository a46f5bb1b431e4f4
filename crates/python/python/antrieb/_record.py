"""Records of answers: shown in a few lines, found by code or id, handed over as dictionaries and data frames."""

from __future__ import annotations

import dataclasses
import difflib
import importlib
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, Generic, SupportsIndex, TypeVar, overload

if TYPE_CHECKING:
    from antrieb.answers import Explained

T = TypeVar("T")

NAMES = ("id", "code", "name", "axis", "key", "symbol", "file")
"""Fields by which a record of a list is found, in this order."""


DERIVED: dict[str, dict[str, Callable[[Any], Any]]] = {
    "Rejection": {"verdict": lambda rejected: "does_not_fit", "tightest": lambda rejected: rejected.check},
}
"""Fields that records have beside those of the JSON, so that a loop reads all entries of `candidates` alike."""


class Record:
    """An answer, or a part of one: its fields are those of the JSON of the command line."""

    __slots__ = ("_origin",)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            made = DERIVED.get(type(self).__name__, {}).get(name)
            if made is None:
                raise AttributeError(f"{type(self).__name__} has no field {name!r}; it has {', '.join(_names(type(self)))}")
            return made(self)

    def to_dict(self) -> dict[str, Any]:
        """Return the fields as dictionaries and lists, by the names of Python."""
        return {name: _plain(getattr(self, name)) for name in _names(type(self))}

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
        return super().__getitem__(key)

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
        return _library("pandas", "to_pandas").DataFrame(self._columns())

    def to_polars(self) -> Any:
        """Return a data frame of polars, a row for each record: its plain fields, and those of records in it as `demand.T_rms`."""
        return _library("polars", "to_polars").DataFrame(self._columns(), strict=False)

    def _columns(self) -> dict[str, list[Any]]:
        rows = [_flat(each) for each in self]
        names = dict.fromkeys(name for row in rows for name in row)
        return {name: [row.get(name) for row in rows] for name in names}

    def __repr__(self) -> str:
        from antrieb import _shown

        return _shown.text_of_rows(self)

    def _repr_html_(self) -> str:
        from antrieb import _shown

        return _shown.html_of_rows(self)


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
    for name in [*_names(type(record)), *DERIVED.get(type(record).__name__, {})]:
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


def _library(name: str, method: str) -> Any:
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        if error.name != name:
            raise
        raise ModuleNotFoundError(f"{method}() needs {name}: pip install {name}; to_dicts() needs nothing", name=name) from None
