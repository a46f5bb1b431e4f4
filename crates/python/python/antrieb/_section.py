"""Sections of a project as objects that do not change: what the generated classes have in common."""

# Values of other libraries and of files have no types until they are looked at; the classes of one package share what is private.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportPrivateUsage=false

from __future__ import annotations

import difflib
import json
import math
import operator
import os
import re
import typing
from collections.abc import Callable, Iterable, Mapping
from decimal import Decimal
from typing import Any, ClassVar, NamedTuple, Self

from antrieb import _antrieb
from antrieb._fault import fault, faults, no_choice
from antrieb._plain import is_scalar, listed, number_of, refuse_times, text
from antrieb._quantity import Converted, Q, of_pint, split, text_of
from antrieb._toml import value_text as _value

Document = dict[str, Any]
"""A table of a project file."""


class Kind(NamedTuple):
    """What a key holds."""

    of: str
    example: str = ""
    other: str = ""
    words: tuple[str, ...] = ()
    columns: int = 0
    table: str = ""
    of_key: str = ""


def _is_like_example(value: Any, example: str | None) -> bool:
    """Returns true if a text has a unit of the quantity of an example."""
    from antrieb import _antrieb
    from antrieb._quantity import split
    from antrieb._trace import quantities

    parts = [split(each) for each in (value, example) if isinstance(each, str)]
    units = [part[1] for part in parts if part is not None and part[1]]
    if len(units) != 2:
        return False
    return any(all(_antrieb.unit_in_si(each.quantity, unit) is not None for unit in units) for each in quantities())


class Section:
    """A section: its fields are the keys that are given, as they are written; a key that is not given is `None`.

    It does not change; `replace` makes another. Sections are equal if their files are; a `Return` equals no `Move`, as it follows the moves before it.
    """

    __slots__ = ("_values",)

    _KEYS: ClassVar[Mapping[str, Kind]] = {}
    _PLACES: ClassVar[tuple[str, ...]] = ()
    _NEEDED: ClassVar[tuple[str, ...]] = ()
    _TABLE: ClassVar[str] = ""

    _values: dict[str, Any]

    def __new__(cls, *places: Any, **given: Any) -> Self:
        for name in given:
            if name not in cls._KEYS:
                near = difflib.get_close_matches(name, cls._KEYS, 1)
                hint = f"did you mean {near[0]!r}?" if near else f"it has {', '.join(cls._KEYS)}"
                if cls.__name__ == "Recorded" and name in ("time", "position", "speed", "torque", "t", "q"):
                    hint = "arrays become axes by antrieb.axes_from_arrays(time, position, torque=…)"
                raise TypeError(f"{cls.__name__} has no keyword {name!r}; {hint}")
        if len(places) > len(cls._PLACES):
            value = places[len(cls._PLACES)]
            others = [name for name in cls._KEYS if name not in cls._PLACES]
            fitting = [name for name in others if _is_like_example(value, cls._KEYS[name].example)]
            raise TypeError(f"{cls.__name__}: {value!r} has no name; write it as in {'=…, '.join((fitting or others)[:4])}=…")
        return super().__new__(cls)

    def _begin(self, **given: Any) -> None:
        for name in self._NEEDED:
            if name in given and given[name] is None:
                example = self._KEYS[name].example
                hint = f', such as {name}="{example}"' if self._KEYS[name].of == "quantity" else ""
                raise TypeError(f"{type(self).__name__}.{name} is required{hint}; it is None")
        values: dict[str, Any] = {}
        for name, value in given.items():
            if value is None:
                continue
            kind = self._KEYS[name]
            where = f"{type(self).__name__}.{name}"
            if kind.of == "alias":
                if given.get(kind.of_key) is not None:
                    raise TypeError(f"{where} is another name of {kind.of_key}: give one of them")
                name, kind = kind.of_key, self._KEYS[kind.of_key]
            values[name] = _stored(kind, value, where)
        self._check(values)
        values = {name: str(value) if isinstance(value, Converted) else value for name, value in values.items()}
        order = list(self._KEYS)
        object.__setattr__(self, "_values", dict(sorted(values.items(), key=lambda item: order.index(item[0]))))

    def _check(self, values: dict[str, Any]) -> None:
        """Checks the values alone; one whose unit is unknown is replaced by its conversion.

        Raises:
            AntriebError: Every value that no project may have.
        """
        simple = {name: _written(value) for name, value in values.items() if self._KEYS[name].of in _SIMPLE}
        for head, names in self._heads(simple):
            lines = {place: name for place, name in enumerate(names, head.count("\n") + 1)}
            lines_text = head + "".join(f"{_key(name)} = {_value(simple[name])}\n" for name in names)
            found = _antrieb.value_faults(lines_text, "en") if names else []
            converted = {name: values[name].other for name in names if isinstance(values[name], Converted)}
            again = {name: other for name, other in converted.items() if name in {lines.get(line) for line, *_ in found} and other != values[name]}
            if again:
                # A unit of another library that no project file has.
                values.update(again)
                return self._check(values)
            if found:
                own = type(self).__name__
                raise faults([(_about(own, lines.get(line, ""), message), hint) for line, message, hint in found])

    def _heads(self, values: Mapping[str, Any]) -> list[tuple[str, list[str]]]:
        """The head of the table that has values, and their names."""
        first, _, rest = self._TABLE.partition(".")
        one = "[[{}]]\n" if first in ("motion", "curve") else "[{}]\n"
        head = "format = 1\n" + (one.format(first) if first in ("motion", "curve") or not rest else "")
        if rest:
            head += ("[[{}]]\n" if rest.endswith("body") else "[{}]\n").format(self._TABLE)
        return [(head, list(values))]

    def __getattr__(self, name: str) -> Any:
        kind = type(self)._KEYS.get(name)
        if kind is None or name.startswith("_"):
            raise AttributeError(f"{type(self).__name__} has no field {name!r}")
        return self._values.get(kind.of_key or name)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__} does not change; .replace({name}=…) makes another")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{type(self).__name__} does not change; .replace({name}=None) makes another")

    def __dir__(self) -> Iterable[str]:
        return [*super().__dir__(), *self._KEYS]

    def __eq__(self, other: object) -> bool:
        return self._document() == other._document() if isinstance(other, Section) and self._is_like(other) else NotImplemented

    def _is_like(self, other: Section) -> bool:
        return type(self) is type(other)

    def __hash__(self) -> int:
        return hash(repr(self._document()))

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        return _unpickled, (type(self), self._state())

    def _state(self) -> dict[str, Any]:
        return {"_values": self._values}

    def __repr__(self) -> str:
        places = [repr(_shown(self._values.get(name))) for name in self._PLACES]
        while places and places[-1] == "None":
            places.pop()
        taken = self._PLACES[: len(places)]
        named = [f"{name}={_shown(value)!r}" for name, value in self._values.items() if name not in taken]
        return f"{type(self).__name__}({', '.join(places + named)})"

    def _repr_html_(self) -> str:
        from antrieb import _shown

        return _shown.html_of_section(type(self).__name__, self._document())

    def replace(self, changes: Mapping[str, Any] | None = None, /, **fields: Any) -> Self:
        """Returns another with these fields; `None` takes one away.

        Args:
            changes: Fields by their path, such as `{"motion.1.payload": "8 kg"}`; entries count from one.
            fields: Fields by their name.
        """
        if changes is not None and not isinstance(changes, Mapping):  # pyright: ignore[reportUnnecessaryIsInstance]
            raise TypeError(f'changes: fields by their path are expected, such as {{"motion.1.payload": "8 kg"}}, not {_called(changes)}')
        found, paths = self, dict[str, str]()
        for path, value in [*(changes or {}).items(), *fields.items()]:
            steps = _steps(path)
            own = ".".join(str(step) for step in (steps[1:] if steps[0] == "requirements" else steps))
            if own in paths:
                raise fault(f"{path}: the field is changed twice, also as {paths[own]}", "give it one value")
            paths[own] = path
            found = found._replaced(steps, path, value)
        return found

    def _replaced(self, steps: list[str | int], path: str, value: Any) -> Self:
        name, *rest = steps
        if not isinstance(name, str) or name not in self._KEYS:
            raise unknown(path, str(name), self)
        kind = self._KEYS[name]
        name = kind.of_key or name
        if rest:
            value = _inside(self._values.get(name), rest, path, value)
        return self._with({name: value})

    def _with(self, values: Mapping[str, Any]) -> Self:
        """Another with these values of its fields."""
        made = type(self).__new__(type(self))
        made._begin(**{**self._values, **values})
        return made

    def _document(self) -> Document:
        """The table of the file."""
        return {_key(name): _written(value) for name, value in self._values.items()}

    @classmethod
    def _read(cls, document: Document, path: str) -> Self:
        """A section from its table.

        Raises:
            Unread: A key is unknown, or its value is of another kind.
        """
        made = cls.__new__(cls)
        values: dict[str, Any] = {}
        names = {_key(name): name for name, kind in cls._KEYS.items() if kind.of != "alias"}
        for key, value in document.items():
            if key not in names:
                raise Unread(f"{path}.{key}")
            values[names[key]] = _of_file(cls._KEYS[names[key]], value, f"{path}.{key}")
        made._begin(**values)
        return made


class Load(Section):
    """What moves at the output: a load, or a mechanism with its load."""

    __slots__ = ()


class Mechanism(Load):
    """A mechanism between output and load."""

    __slots__ = ()


class Segment(Section):
    """A segment of the motion."""

    __slots__ = ()

    _LAW: ClassVar[str] = ""

    def _heads(self, values: Mapping[str, Any]) -> list[tuple[str, list[str]]]:
        ((head, names),) = super()._heads(values)
        return [(head + (f'law = "{self._LAW}"\n' if self._LAW else ""), names)]

    def _document(self) -> Document:
        own = super()._document()
        return {"law": self._LAW, **own} if self._LAW else own

    def _resolved(self, before: tuple[Segment, ...]) -> Segment:
        """The segment as the file has it, behind these."""
        return self

    @classmethod
    def _read(cls, document: Document, path: str) -> Self:
        return super()._read({key: value for key, value in document.items() if not (cls._LAW and key == "law")}, path)


class ReturnMove(Segment):
    """A move back to where the motion began."""

    __slots__ = ()

    def _resolved(self, before: tuple[Segment, ...]) -> Segment:
        from antrieb.sections import Move

        total, unit = distance_of(before, "Return")
        laws = [segment.law for segment in before if isinstance(segment, Move)]
        given = {"law": laws[-1] if laws else None, **self._values}
        if given["law"] is None:
            raise fault("Return: no move stands before it", 'write Move("modified_sine", distance="-90 deg", …)')
        if total == 0:
            raise fault("Return: the moves before it end where the motion began", "leave it out")
        made = Move.__new__(Move)
        made._begin(**given, distance=f"{_decimal(-total)} {unit}")
        return made


def distance_of(segments: Iterable[Segment], name: str) -> tuple[Decimal, str]:
    """Returns the sum of the distances of segments, and their unit."""
    total, units = Decimal(0), dict[str, None]()
    for place, segment in enumerate(segments, 1):
        document = segment._document()
        if document["law"] == "dwell":
            continue
        found = split(str(document.get("distance", "")))
        if found is None:
            raise fault(
                f"{name}: segment {place} before it states no plain distance", 'write the way back as Move(…, distance="-90 deg")'
            )
        total += found[0]
        units[found[1]] = None
    if len(units) > 1:
        raise fault(
            f"{name}: the moves before it state distances in {' and '.join(units)}", "write them in one unit, or the way back as a Move"
        )
    return total, next(iter(units), "")


ENTRIES_SHOWN = 20
"""Entries of a list that a `repr` shows."""


class Unread(Exception):
    """A value of a file that is none of its key."""


def unknown(path: str, name: str, of: Section) -> Exception:
    """Returns the fault of a path without a key."""
    choice = no_choice(path, name, [key for key, kind in of._KEYS.items() if kind.of != "alias"])
    return fault(f'{path}: {type(of).__name__} has no key "{name}"', choice.faults[0].hint)


def _unpickled(of: type[Section], state: dict[str, Any]) -> Section:
    made = of.__new__(of)
    for name, value in state.items():
        object.__setattr__(made, name, value)
    return made


def _key(name: str) -> str:
    """The name of a keyword in the file."""
    return name.rstrip("_")


def _shown(value: Any) -> Any:
    """A value in a `repr`: tuples of entries as the lists that are written; of many the first and the last."""
    if not isinstance(value, tuple):
        return value
    return list(value) if len(value) <= ENTRIES_SHOWN else [*value[:2], ..., value[-1]]


def _written(value: Any) -> Any:
    if isinstance(value, Section):
        return value._document()
    return [_written(each) for each in value] if isinstance(value, tuple) else value


def _decimal(number: Decimal) -> str:
    text = format(number, "f")
    return text.rstrip("0").rstrip(".") if "." in text else text


_PATH = re.compile(r"[^.\[\]\d][^.\[\]]*(?:\.(?:0|[1-9][0-9]*)|\[(?:0|[1-9][0-9]*)\]|\.[^.\[\]\d][^.\[\]]*)*")
"""A path: names, and numbers of entries without zeros in front."""


def _steps(path: str) -> list[str | int]:
    """The parts of a path: `motion.1.payload` and `motion[1].payload` alike."""
    written = text(str(path), "key")
    if _PATH.fullmatch(written) is None:
        raise fault(f"{path}: this is no path of a key", 'write it as in "motion[1].payload" or "motion.1.payload"')
    parts = written.replace("[", ".").replace("]", "").split(".")
    if any(part.isdigit() and int(part) == 0 for part in parts):
        counted = ".".join(str(int(part) + 1) if part.isdigit() else part for part in parts)
        raise fault(f"{path}: entries are counted from one", f'did you mean "{counted}"?')
    return [int(part) if part.isdigit() else part for part in parts]


def _inside(value: Any, rest: list[str | int], path: str, new: Any) -> Any:
    """A value with a change inside of it."""
    step, *more = rest
    if isinstance(value, tuple):
        if not isinstance(step, int):
            raise fault(f"{path}: the entry is missing", f'write its number from 1 to {len(value)} before "{step}"')
        if step > len(value):
            raise fault(f"{path}: there are {len(value)} entries")
        entry = _inside(value[step - 1], more, path, new) if more else new
        return (*value[: step - 1], entry, *value[step:]) if entry is not None else (*value[: step - 1], *value[step:])
    if isinstance(value, Section):
        return value._replaced(rest, path, new)
    raise fault(f"{path}: there is no such section in it", "give the section as a whole")


def _stored(kind: Kind, value: Any, where: str) -> Any:
    """Returns a value of a keyword as it is kept.

    Raises:
        TypeError: It is of another kind.
        AntriebError: It is none of the words, or not finite.
    """
    return _STORED[kind.of](kind, value, where)


def _quantity(kind: Kind, value: Any, where: str) -> str:
    return text_of(value, where, kind.example, kind.other)


def _as_number(_: Kind, value: Any, where: str) -> float:
    refuse_times(value, where)
    if is_scalar(value):
        value = value.item()
    found = value if isinstance(value, Q) else of_pint(value)
    if found is not None and found.unit == "" and not isinstance(found.value, tuple):
        value = found.value
    if isinstance(value, bool) or not isinstance(value, (int, float, Decimal)):
        raise TypeError(f"{where} is a number, not {_called(value)}{_share_hint(value, where)}")
    number = number_of(value, where)
    if not math.isfinite(number):
        raise fault(f"{where} is not finite: {number!r}")
    return number


def _share_hint(value: Any, where: str) -> str:
    """What is written for a share in percent."""
    found = split(value) if isinstance(value, str) else None
    if found is None or found[1] not in ("", "%", "percent"):
        return ""
    last = where.rsplit(".", 1)[-1]
    return f"; write {last}={_decimal(found[0] / 100 if found[1] else found[0])}"


def _integer(_: Kind, value: Any, where: str) -> int:
    if isinstance(value, bool):
        raise TypeError(f"{where} is a whole number, not {value}")
    refuse_times(value, where)
    if is_scalar(value):
        value = value.item()
    try:
        return int(operator.index(value))
    except TypeError:
        raise TypeError(f"{where} is a whole number, not {_called(value)}") from None


def _bool(_: Kind, value: Any, where: str) -> bool:
    if is_scalar(value):
        value = value.item()
    if not isinstance(value, bool):
        raise TypeError(f"{where} is True or False, not {_called(value)}")
    return value


def _text(_: Kind, value: Any, where: str) -> str:
    if isinstance(value, os.PathLike):
        return text(os.fsdecode(value), where)  # pyright: ignore[reportUnknownArgumentType]
    if not isinstance(value, str):
        raise TypeError(f"{where} is a text, not {_called(value)}")
    return text(value, where)


def _word(kind: Kind, value: Any, where: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{where} is one of {', '.join(map(repr, kind.words))}, not {_called(value)}")
    plain = text(value, where)
    if plain not in kind.words:
        raise no_choice(where, plain, kind.words)
    return plain


def _entries(value: Any, where: str, example: str) -> list[Any]:
    refuse_times(value, where, example)
    quantity = None if isinstance(value, Q) else of_pint(value)
    if quantity is not None and quantity.unit == "":
        # Numbers of pint, which a scalar one has no list of.
        value = quantity.value
    elif not isinstance(value, Q) and hasattr(value, "tolist") and not hasattr(value, "magnitude"):
        value = value.tolist()
    if isinstance(value, (str, bytes, Mapping, Section)) or not isinstance(value, Iterable):
        raise TypeError(f"{where} is a list such as {example}, not {_called(value)}")
    return listed(value, where)


def _words(kind: Kind, value: Any, where: str) -> tuple[str, ...]:
    each = [value] if isinstance(value, str) else _entries(value, where, repr(list(kind.words[:2])))
    return tuple(_word(kind, word, where) for word in each)


def _numbers(kind: Kind, value: Any, where: str) -> tuple[float, ...]:
    return tuple(_as_number(kind, each, where) for each in _entries(value, where, "[1.0, 2.5]"))


def _texts(kind: Kind, value: Any, where: str) -> tuple[str, ...]:
    of_bodies = '["cylinder diameter=300mm length=20mm density=7850kg/m^3"]'
    example = of_bodies if where.endswith(("bodies", "body")) else f"[{value!r:.40}]" if isinstance(value, str) else '["…"]'
    return tuple(_text(kind, each, where) for each in _entries(value, where, example))


def _rows(kind: Kind, value: Any, where: str) -> tuple[tuple[str, ...], ...]:
    rows: list[list[str]] = json.loads(kind.example)
    example = repr([tuple(row) for row in rows[:2]])
    found: list[tuple[str, ...]] = []
    for place, row in enumerate(_entries(value, where, example), 1):
        cells = _entries(row, f"{where}, row {place},", example)
        if len(cells) != kind.columns:
            raise TypeError(f"{where}, row {place}, has {len(cells)} cells instead of {kind.columns}; write {example}")
        columns = enumerate(zip(cells, rows[0], strict=True), 1)
        found.append(tuple(text_of(cell, f"{where}[{place}][{column}]", like, None) for column, (cell, like) in columns))
    return tuple(found)


def _class(name: str) -> type[Section]:
    from antrieb import sections

    found: type[Section] = Segment if name == "Segment" else getattr(sections, name)
    return found


def _table(kind: Kind, value: Any, where: str) -> Section:
    of = _class(kind.table)
    if not isinstance(value, of):
        example = "Move" if of is Segment else of.__name__
        raise TypeError(f"{where} is {_article(of.__name__)} such as antrieb.{example}(…), not {_called(value)}")
    return value


def _tables(kind: Kind, value: Any, where: str) -> tuple[Section, ...]:
    each = [value] if isinstance(value, Section) else _entries(value, where, f"[antrieb.{'Move' if kind.table == 'Segment' else kind.table}(…)]")
    return tuple(_table(kind, one, f"{where}[{place}]") for place, one in enumerate(each, 1))


def _load(_: Kind, value: Any, where: str) -> Load:
    if not isinstance(value, Load):
        raise TypeError(f"{where} is a load or a mechanism such as antrieb.Arm(…), not {_called(value)}")
    return value


_SIMPLE = ("quantity", "number", "numbers", "integer", "text", "word", "rows", "texts")
"""Kinds whose values are checked alone; sections inside are checked when they are made."""


def _about(own: str, name: str, message: str) -> str:
    """A fault of a value with the name of its argument in place of its path."""
    where = f"{own}.{name}"
    path = re.match(r"`[^`]*`: ?", message)
    return f"{where}: {message[path.end() :] if path else message}"


_STORED: dict[str, Callable[[Kind, Any, str], Any]] = {
    "quantity": _quantity,
    "number": _as_number,
    "integer": _integer,
    "bool": _bool,
    "text": _text,
    "word": _word,
    "words": _words,
    "numbers": _numbers,
    "texts": _texts,
    "rows": _rows,
    "table": _table,
    "tables": _tables,
    "mechanism": _load,
}


def _called(value: Any) -> str:
    if type(value).__name__ == "MaskedConstant":
        return "a masked value"
    return f"{value!r:.60}" if isinstance(value, (str, int, float)) else type(value).__name__


def _article(name: str) -> str:
    return f"an {name}" if name[0] in "AEIOU" else f"a {name}"


_FILE_TYPES: dict[str, tuple[type, ...]] = {
    "quantity": (str,),
    "number": (int, float),
    "integer": (int,),
    "bool": (bool,),
    "text": (str,),
    "word": (str,),
    "words": (list,),
    "numbers": (list,),
    "texts": (list,),
    "rows": (list,),
    "table": (dict,),
    "tables": (list,),
}


def _of_file(kind: Kind, value: Any, path: str) -> Any:
    """A value of a file for its keyword."""
    if not isinstance(value, _FILE_TYPES[kind.of]) or (isinstance(value, bool) and kind.of != "bool"):
        raise Unread(path)
    # Checked above.
    value = typing.cast(Any, value)
    if kind.of == "table":
        return _class(kind.table)._read(value, path)
    if kind.of == "tables":
        if not all(isinstance(each, dict) for each in value):
            raise Unread(path)
        return tuple(_class(kind.table)._read(each, f"{path}[{place}]") for place, each in enumerate(value, 1))
    return value
