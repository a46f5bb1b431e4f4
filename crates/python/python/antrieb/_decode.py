"""JSON as the typed objects of `antrieb.answers`."""

from __future__ import annotations

import dataclasses
import functools
import keyword
import types
import typing
from collections.abc import Callable
from typing import Any, Literal

from antrieb._record import Named, Record, Rows

Decoder = Callable[[Any], Any]


def _as_it_is(value: Any) -> Any:
    return value


@functools.cache
def decoder(of: Any) -> Decoder:
    """The function that makes a value of a type out of JSON."""
    origin = typing.get_origin(of)
    if dataclasses.is_dataclass(of) and isinstance(of, type):
        return _record(of)
    if origin is list:
        return _list(typing.get_args(of)[0])
    if origin is Rows:
        return _rows(typing.get_args(of)[0])
    if origin is dict:
        return _map(typing.get_args(of)[1])
    if origin is typing.Union or isinstance(of, types.UnionType):
        return _union(typing.get_args(of))
    if origin is Literal or of in (str, int, float, bool, object, None, type(None)):
        return _as_it_is
    raise TypeError(f"no decoder for {of!r}")


def _list(of: Any) -> Decoder:
    # A type may hold itself, so its decoder is made when it is first needed.
    def decode(values: list[Any]) -> list[Any]:
        each = decoder(of)
        if each is _as_it_is:
            return values
        made: list[Any] = [each(value) for value in values]
        # Shown as a table, also where the answer is a list and no record.
        return Rows(made) if made and all(isinstance(one, Record) for one in made) else made

    return decode


def _rows(of: Any) -> Decoder:
    def decode(values: list[Any]) -> Rows[Any]:
        each = decoder(of)
        return Rows(each(value) for value in values)

    return decode


def _map(of: Any) -> Decoder:
    def decode(values: dict[str, Any]) -> dict[str, Any]:
        each = decoder(of)
        if each is _as_it_is:
            return values
        made = {name: each(value) for name, value in values.items()}
        # Shown as a table, as a list of records is.
        return Named(made) if made and all(isinstance(one, Record) for one in made.values()) else made

    return decode


def _union(kinds: tuple[Any, ...]) -> Decoder:
    records: list[Any] = [kind for kind in kinds if dataclasses.is_dataclass(kind)]
    lists: list[Any] = [kind for kind in kinds if typing.get_origin(kind) in (list, Rows)]
    if not records and not lists:
        return _as_it_is

    def decode(value: Any) -> Any:
        if lists and _is(value, list):
            return decoder(lists[0])(value)
        if records and _is(value, dict):
            fields: dict[str, Any] = value
            fitting = [record for record in records if _needed(record) <= fields.keys()]
            # Of several the one that knows the most of the fields.
            chosen = max(fitting or records, key=lambda record: len(_fields(record).keys() & fields.keys()))
            return decoder(chosen)(value)
        return value

    return decode


def _is(value: Any, of: type) -> bool:
    return isinstance(value, of)


def _key(name: str) -> str:
    """The name of a field in JSON: a word that Python keeps for itself has a line behind it."""
    plain = name.removesuffix("_")
    return plain if keyword.iskeyword(plain) else name


@functools.cache
def _needed(of: Any) -> frozenset[str]:
    missing = dataclasses.MISSING
    return frozenset(_key(each.name) for each in dataclasses.fields(of) if each.default is missing)


@functools.cache
def _fields(of: Any) -> dict[str, tuple[str, Any]]:
    hints = typing.get_type_hints(of)
    return {_key(each.name): (each.name, hints[each.name]) for each in dataclasses.fields(of)}


def _record(of: type) -> Decoder:
    @functools.cache
    def decoders() -> dict[str, tuple[str, Decoder]]:
        return {key: (name, decoder(hint)) for key, (name, hint) in _fields(of).items()}

    def decode(value: dict[str, Any]) -> Any:
        known = decoders()
        fields: dict[str, Any] = {}
        for key, part in value.items():
            name, each = known[key]
            fields[name] = part if each is _as_it_is else each(part)
        return of(**fields)

    return decode
