"""Calls of the native part: values become texts for the questions, answers become objects, faults an exception."""

from __future__ import annotations

import json
import keyword
import operator
import os
import re
from collections.abc import Iterable, Mapping, Sequence, Set
from datetime import date, timedelta
from typing import TYPE_CHECKING, Any, Literal

from antrieb import _antrieb, _origin
from antrieb._axis import BaseProject, to_source
from antrieb._decode import decoder
from antrieb._fault import fault
from antrieb._lazy import lazy
from antrieb._plain import is_time, listed, number_of, seconds, shown
from antrieb._plain import text as plain_text
from antrieb._quantity import Q, Quantity, of_pint
from antrieb._source import Handed, ProjectSource, folder_text
from antrieb._trace import HeldFile

if TYPE_CHECKING:
    from antrieb import answers, sections
    from antrieb._lines import Drawn, Line
    from antrieb._record import Rows

    Fault = answers.Fault | answers.CodeFault
    """A fault of a call or of an ordering code."""
else:
    answers = lazy("antrieb.answers")
    sections = lazy("antrieb.sections")

Lang = Literal["en", "de"]
"""The language of texts."""

Path = str | os.PathLike[str]
"""The path of a file or a folder."""

Text = str | os.PathLike[str] | ProjectSource | Sequence[ProjectSource]
"""A project as an `Axis`, a `Project` or a list of axes; or a text, or the path of its file: a `str` of one line is a path,
unless it has a `=` and no file has that name."""

TimeLimit = Quantity | timedelta
"""How long an answer may take: a text such as `60 s`, a quantity, or an interval of `datetime`."""

JSON = "application/json"
SVG = "image/svg+xml"
TEXTS = ("text/", "application/toml")


class AntriebError(ValueError):
    """Why a question has no answer: every fault of the call, with place, expectation and the nearest valid choice."""

    faults: tuple[Fault, ...]
    """Every fault, in the order of the text."""

    nearest: tuple[answers.ListedCode, ...]
    """The nearest codes that can be ordered, where an ordering code is wrong."""

    @property
    def meant(self) -> tuple[str, ...]:
        """The words that are probably meant, of each fault with a nearest valid choice."""
        hints = (re.search(r"[`\"]([^`\"]+)[`\"]\?$", fault.hint or "") for fault in self.faults)
        return tuple(found[1] for found in hints if found)

    def __init__(self, record: dict[str, Any]) -> None:
        record = _arguments(record)
        of = answers.CodeFaults if "nearest" in record else answers.Faults
        found: answers.CodeFaults | answers.Faults = decoder(of)(record)
        self.faults = tuple(found.errors)
        self.nearest = tuple(found.nearest_codes or ())
        self.record = record
        lines = [_line(fault) for fault in self.faults]
        lines.extend(f"  {code.code}" for code in self.nearest)
        super().__init__("\n".join(lines))

    def __reduce__(self) -> tuple[type[AntriebError], tuple[dict[str, Any]]]:
        # What travels between processes is the record.
        return type(self), (self.record,)


def _line(fault: Fault) -> str:
    """A fault as compilers write it: `axis.toml:3:11: message (hint)`."""
    place: list[str] = []
    if isinstance(fault, answers.Fault):
        place.extend(str(each) for each in (fault.file, fault.line, fault.column) if each is not None)
        place.extend(each for each in (fault.option, fault.heading) if each is not None)
        if fault.row is not None:
            place.append(f"row {fault.row}")
    else:
        place.extend(("code", str(fault.position)))
    hint = f" ({fault.hint})" if fault.hint else ""
    return ":".join(place) + (": " if place else "") + fault.message + hint


class Picture:
    """A picture as SVG; a notebook shows it."""

    __slots__ = ("_drawn", "svg")

    svg: str
    """The picture."""

    def __init__(self, svg: str, drawn: Drawn | None = None) -> None:
        self.svg = svg
        self._drawn = drawn

    def arrays(self) -> Rows[Line]:
        """Return what it shows as arrays with labels and units, for Matplotlib: `ax.plot(*line, label=line.name)`.

        The data are asked anew, with the arguments of the call.

        Raises:
            TypeError: Its data are in no answer; the message says where its figures are.
            ValueError: The project has changed since it was drawn.
        """
        from antrieb import _lines

        return _lines.of_picture(self.svg, self._drawn)

    def __eq__(self, other: object) -> bool:
        return self.svg == other.svg if isinstance(other, Picture) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.svg)

    def __reduce__(self) -> tuple[type[Picture], tuple[str, Drawn | None]]:
        return type(self), (self.svg, self._drawn)

    def _repr_svg_(self) -> str:
        return self.svg

    def __str__(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<Picture of {len(self.svg)} bytes>"

    def save(self, path: Path) -> None:
        """Write it to a file that ends in `.svg`.

        Raises:
            AntriebError: The path has another ending; there are no other formats.
        """
        ending: str = os.path.splitext(str(path))[1]
        if ending.lower() != ".svg":
            raise fault(f"save: a picture is SVG and no other format is written; the path ends in .svg, not in {ending or 'nothing'}")
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.svg)


def handed(text: Text, name: str | None, folder: Path | None, others: bool = False) -> Handed:
    """A text with its name, its folder and the recordings that it holds; of a path no text. With others, whose argument is the name,
    the folder may be theirs."""
    which = name if others and name else "text"
    name = name_of("file", name)
    if isinstance(text, str):
        text = plain_text(text, which)
    if isinstance(text, str) and ("\n" in text or not text or ("=" in text and not os.path.exists(text))):
        return text, name or "text", folder_text(folder), {}
    if isinstance(text, (str, os.PathLike)):
        if folder is not None and not others:
            raise TypeError("folder is for a text or an Axis; the recordings of a file lie beside it")
        if name is not None and not others:
            raise TypeError("file is what a text is called in faults; a path has its own name: leave it out")
        return None, os.fspath(text), "", {}
    source = to_source(text, which)
    # Callers without a type checker.
    if source is None:
        raise TypeError(
            f"{which}: a project is an Axis, a list of axes, a text or the path of its file, not {_named(text)}"
        )
    own = source._handed()  # pyright: ignore[reportPrivateUsage]
    return own[0], name or own[1], folder_text(folder) if folder is not None else own[2], own[3]


def name_of(argument: str, name: Any) -> str | None:
    """The name of a text in faults as it is handed over."""
    if name is None:
        return None
    if not isinstance(name, (str, os.PathLike)):
        raise TypeError(f"{argument} is the name of a text in faults, such as 'axis.toml', not {type(name).__name__}")
    return plain_text(os.fsdecode(name), argument)  # pyright: ignore[reportUnknownArgumentType]


def _named(value: object) -> str:
    return "an empty list" if isinstance(value, (list, tuple)) and not value else type(value).__name__  # pyright: ignore[reportUnknownArgumentType]


def argument(option: str) -> str:
    """The argument of Python for an option of the command line: `hours-per-day` is `hours_per_day`, `for` is `for_`."""
    name = option.replace("-", "_")
    return name + "_" if keyword.iskeyword(name) else name


def _own(text: str | None) -> str | None:
    """A text about options as one about arguments; what is quoted stays as it is."""
    if not text or "--" not in text:
        return text
    parts = text.split("`")
    parts[::2] = [re.sub(r"--([a-z][a-z-]*)", lambda found: argument(found[1]), part) for part in parts[::2]]
    return "`".join(parts)


WORD_MOST = 200
"""Characters of a word that a fault quotes whole."""

TEXT_MOST = 4000
"""Characters of a text in a fault."""


def _short(text: str) -> str:
    """A text of a fault whose long words are cut."""
    if len(text) <= WORD_MOST:
        return text
    text = re.sub(rf"\S{{{WORD_MOST},}}", lambda found: f"{found[0][:WORD_SHOWN]}…", text)
    return text if len(text) <= TEXT_MOST else f"{text[:TEXT_MOST]}…"


WORD_SHOWN = 80
"""Characters of a longer word."""


def _arguments(record: dict[str, Any]) -> dict[str, Any]:
    """The record of a fault with the names of Python."""

    def named(given: dict[str, Any]) -> dict[str, Any]:
        fault = {name: _short(value) if isinstance(value, str) else value for name, value in given.items()}
        own = {name: _own(fault[name]) for name in ("message", "hint") if fault.get(name)}
        if fault.get("option"):
            own["option"] = argument(fault["option"])
        return {**fault, **own}

    return {**record, "errors": [named(fault) for fault in record.get("errors", [])]}


def _of_arguments(value: Any) -> Any:
    """The record of an answer whose assumptions and notes name arguments in place of options."""
    found: Any = value
    if isinstance(value, list):
        return [_of_arguments(each) for each in found]
    if not isinstance(value, dict):
        return value
    own: dict[str, Any] = {}
    for key, each in found.items():
        notes: Any = each
        if key == "why" and isinstance(each, str):
            own[key] = _own(each)
        elif key == "notes" and isinstance(each, list):
            own[key] = [_own(note) if isinstance(note, str) else _of_arguments(note) for note in notes]
        else:
            own[key] = _of_arguments(each)
    return own


def placed(error: AntriebError, given: Iterable[tuple[str, str]], folders: Sequence[str] = ()) -> AntriebError:
    """The exception with the argument of each fault that quotes its value and has no place; a file that is held for the call
    has the name of its argument alone."""
    pairs = [(name, value) for name, value in given if value]
    errors: list[dict[str, Any]] = []
    for fault in error.record.get("errors", []):
        if not any(fault.get(place) for place in ("option", "file", "line", "heading", "position")):
            names = [name for name, value in pairs if _quotes(fault["message"], value)]
            line = _LINE.match(fault["message"])
            if not names and (_TRACE.search(fault["message"]) or line):
                names = [name for name, _ in pairs if name == "trace"]
            if names == ["trace"] and line and folders:
                # The first row of arrays is behind the headings of the file that holds them for the call.
                row = f"{'row' if line[1] == 'line' else 'Reihe'} {int(line[2]) - 2}: "
                fault = {**fault, "message": row + fault["message"][line.end() :]}
            fault = {**fault, "option": names[0]} if names else fault
        for folder in folders:
            fault = {key: value.replace(folder, "") if isinstance(value, str) else value for key, value in fault.items()}
        errors.append(fault)
    return AntriebError({**error.record, "errors": errors})


def _quotes(message: str, value: str) -> bool:
    """Returns true if a message is about a value: a sign alone counts between quotes."""
    if len(value) > WORD_MOST:
        return value[: WORD_SHOWN // 2] in message
    found = re.escape(value)
    # A value is no part of a number, such as 10 of 1.00·10⁻⁶.
    return bool(re.search(rf"(?<![\w.,·]){found}(?![\w⁻⁺]|[.,·]\d)" if len(value) > 1 else rf"[\"„“`']{found}[\"“”`']", message))


def of_objects(error: AntriebError, texts: Sequence[Text]) -> AntriebError:
    """The exception of a call about one project of objects, with arguments in place of lines."""
    source = to_source(texts[0]) if len(texts) == 1 else None
    text = None if source is None else source._handed()[0]  # pyright: ignore[reportPrivateUsage]
    # Lines of a file that was loaded are those of the file until something changes.
    if text is None or getattr(source, "_text", None) == text:
        return error
    from antrieb._argument import by_argument

    return by_argument(error, text, source._handed()[3])  # type: ignore[union-attr]  # pyright: ignore


def with_nearest(error: AntriebError) -> AntriebError:
    """The exception of a table with the nearest codes of the first one that is wrong."""
    wrong = next((fault for fault in error.record.get("errors", []) if str(fault.get("id", "")).startswith("code_") and fault.get("heading")), None)
    if wrong is None or "nearest" in error.record:
        return error
    try:
        _antrieb.ask("code parse", [], [("code", str(wrong["message"]).partition(":")[0])], "en", None, None, False)
    except AntriebError as found:
        error.nearest = found.nearest
    return error


_LINE = re.compile(r"(line|Zeile) (\d+): ")
_TRACE = re.compile(r"\b(?:trace|Verlauf)\b")
"""Word of a fault that is about a recorded run."""


def flag(name: str, value: Any) -> bool:
    """A truth value as it is handed over."""
    if isinstance(value, bool):
        return value
    if type(value).__name__ in ("bool", "bool_") and hasattr(value, "item"):
        return bool(value)
    raise TypeError(f"{name} is True or False, not {shown(value)}")


def _written(value: Any, name: str = "") -> str:
    place = f"{argument(name)}: " if name else ""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, date) or getattr(getattr(value, "dtype", None), "kind", "") == "M":
        return _day(value, argument(name) if name else "text")
    if isinstance(value, str):
        if not value.strip() and name != "code":
            raise fault(f"{place}the text is empty", "leave the argument out, or write a value")
        return plain_text(value, argument(name) if name else "text")
    if hasattr(value, "__fspath__"):
        return os.fsdecode(value)
    if isinstance(value, ProjectSource):
        raise TypeError(f"{place}a text is expected, not {type(value).__name__}; the project stands first, as in antrieb.check(axis, code)")
    found = value if isinstance(value, Q) else of_pint(value)
    if found is not None:
        if isinstance(found.value, tuple):
            raise TypeError(f"{place}one quantity is expected, not {len(found)}")
        return found.texts[0]
    if is_time(value):
        found_s = seconds(value, argument(name) if name else "text")[0]
        return _days(found_s, name) if name in INTERVALS else f"{found_s!r} s"
    if isinstance(value, sections.Body):
        return _body_text(value)
    if name == HOURS:
        return repr(number_of(value, argument(name)))
    try:
        # Whole numbers, also those of NumPy.
        return str(operator.index(value))  # pyright: ignore[reportArgumentType]
    except TypeError:
        pass
    raise TypeError(f"{place}a text is expected, not {value!r:.40}; a quantity has its unit, as in \"160 mm\" or antrieb.q(160, \"mm\")")



def _day(value: Any, name: str) -> str:
    """A day as a text; an instant at midnight is its day.

    Raises:
        AntriebError: It has a time of day, or is none.
    """
    if getattr(value, "ndim", 0):
        raise TypeError(f"{name}: one day is expected, such as '2026-03-01', not an array")
    day = str(value.astype("datetime64[D]")) if hasattr(value, "astype") else value.isoformat().partition("T")[0]
    is_midnight = value == value.astype("datetime64[D]") if hasattr(value, "astype") else value.isoformat()[10:19] in ("", "T00:00:00") and not getattr(value, "microsecond", 0) and not getattr(value, "nanosecond", 0)
    if not is_midnight:
        raise fault(f"{name}: a day is expected, not {str(value):.40}", f'write "{day}"' if day != "NaT" else "write one such as 2026-03-01")
    return day


def _body_text(body: sections.Body) -> str:
    """A body as a text: `disc diameter=300mm length=20mm mass=5kg`."""
    fields = dict(body._document())  # pyright: ignore[reportPrivateUsage]
    shape = fields.pop("shape", "")
    return " ".join([shape, *(f"{key}={str(value).replace(' ', '', 1).replace(' ', '*')}" for key, value in fields.items())])


def _days(found_s: float, name: str) -> str:
    """An interval of the calendar as a text.

    Raises:
        AntriebError: It has parts of days.
    """
    days, rest = divmod(found_s, 86400)
    if rest or days < 1:
        raise fault(f"{argument(name)}: whole days are expected, not {found_s!r:.40} s", f'write {argument(name)}="6 months" or a timedelta of days')
    return f"{int(days)} days"


INTERVALS = ("inspect", "storage")
"""Arguments that are intervals of the calendar."""

HOURS = "hours-per-day"
"""Argument whose unit is its name: `8` and `5.5` are hours."""

SEVERAL = frozenset({"body", "change", "check", "code", "key", "signals"})
"""Arguments that may have several values."""

WHOLE = frozenset({"cycles", "days", "samples", "seed", "top"})
"""Arguments that are whole numbers."""


WORDS = frozenset({"author", "company", "customer", "name", "number", "order", "revision", "title"})
"""Arguments that are texts of the user."""


def _text(value: Any, name: str) -> None:
    if value is not None and not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{argument(name)} is a text, not {shown(value)}")


def _whole(value: Any, name: str) -> None:
    if value is None:
        return
    try:
        operator.index(value)
    except TypeError:
        pass
    else:
        if not isinstance(value, bool):
            return
    raise TypeError(f"{name} is a whole number, not {value!r:.40}")


def each_of(value: Any, name: str) -> list[Any]:
    """One value, or those of a list, a tuple, an array or a series; a text is one value."""
    if isinstance(value, (Set, bytes, bytearray, memoryview)):
        own: Any = type(value)  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]
        raise TypeError(f"{argument(name)}: a text or a list of texts is expected, not {own.__name__}")
    is_one = isinstance(value, (str, bytes, Mapping, os.PathLike, Q)) or hasattr(value, "magnitude") or not isinstance(value, Iterable)
    return [value] if is_one else listed(value, argument(name))  # pyright: ignore[reportUnknownArgumentType, reportArgumentType]


def language(lang: Any) -> str:
    """The language as it is handed over; a word that is none is refused with the other faults."""
    if isinstance(lang, str):
        return lang
    raise TypeError(f"lang is 'en' or 'de', not {lang!r:.40}")


def unit_text(name: str, value: TimeLimit | None) -> str | None:
    """A quantity as it is handed over: a text with its unit, a number with one, or an interval of time."""
    if name == "deadline" and value is not None and is_time(value):
        return f"{seconds(value, name)[0]!r} s"
    quantity = value if isinstance(value, Q) else of_pint(value)
    if quantity is not None:
        return _written(quantity, name)
    if isinstance(value, str):
        return plain_text(value, name)
    if value is not None and not isinstance(value, str):  # pyright: ignore[reportUnnecessaryIsInstance]
        example = "60 s" if name == "deadline" else "1 GiB"
        raise TypeError(f"{name} is a text with its unit, such as {example!r}, not {type(value).__name__}")
    return value


def pairs_of(values: Iterable[tuple[str, Any]]) -> list[tuple[str, str]]:
    """Names and texts of arguments, those that are given."""
    found: list[tuple[str, str]] = []
    for name, given in values:
        # An array without a dimension is one value.
        is_scalar = getattr(given, "ndim", None) == 0 and hasattr(given, "__array_interface__")
        # A text of NumPy is a text.
        whole: Any = given
        value: Any = str(whole) if isinstance(given, str) and is_scalar else whole[()] if is_scalar else whole
        if name in WHOLE:
            _whole(value, name)
        if name in WORDS:
            _text(value, name)
        if value is None or value is False:
            continue
        each = each_of(value, name)
        # Without the argument it is an empty tuple.
        if not each and not (name == "check" and value == ()):
            raise fault(f"{argument(name)}: the list is empty", "leave the argument out, or write a value")
        if name not in SEVERAL and (len(each) != 1 or each[0] is not value):
            raise TypeError(f"{argument(name)}: one value is expected, not {type(value).__name__}")
        found.extend((name, _written(one, name)) for one in each)
    return found


def _has_tolerances(answer: Any) -> bool:
    """Returns true if an axis has tolerances; where nothing fits and nothing is near they count as there."""
    judged: list[Any] = [answer] if hasattr(answer, "tolerance") else [*answer.ranking[:1], *([answer.own] if answer.own else [])]
    if not judged:
        if answer.nearest_miss is None:
            return True
        judged = [answer.best.nearest]
    return any(each.tolerance is not None for each in judged)


def ask(
    of: Any,
    command: str,
    texts: tuple[Text, ...],
    pairs: Iterable[tuple[str, Any]],
    lang: Lang,
    *,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> Any:
    """The answer to a question of the list; a record as the type that `of` returns."""
    names = (file,) if len(texts) == 1 else ("old", "new")
    sources = [handed(text, name, folder, len(texts) > 1) for text, name in zip(texts, names, strict=False)]
    lang_id = language(lang)
    pairs_given = list(pairs)
    given = pairs_of([*pairs_given, ("lang", lang)])
    if command != "compare" and len([name for name, _ in given if name == "code"]) > 1:
        raise fault("code: one ordering code is expected, not a list of them", "antrieb.compare(project, codes) takes several")
    by_axes = any(isinstance(text, (BaseProject, list, tuple)) for text in texts) and not dict(pairs_given).get("axis")
    held = [value for _, value in pairs_given if isinstance(value, HeldFile)]
    try:
        media, body = _antrieb.ask(
            command, sources, given, lang_id, unit_text("deadline", deadline), unit_text("memory", memory), by_axes
        )
    except AntriebError as error:
        raise placed(of_objects(error, texts), given, [each.folder for each in held]) from None
    finally:
        for each in held:
            each.end()
    if media == JSON:
        answer = decoder(of())(_of_arguments(json.loads(body)) if b"--" in body else json.loads(body))
        if len(texts) == 1:
            named = {"file": file, "folder": folder_text(folder) or None, "deadline": deadline, "memory": memory}
            _origin.attach(answer, _origin.Origin.of(texts[0], pairs_given, lang, **named))
        drawn = [name for name, value in pairs_given if name in ("samples", "seed") and value is not None]
        if drawn and command in ("size", "check") and not any(map(_has_tolerances, answer.axes)):
            raise fault(
                f"{drawn[0]}: the project has no tolerances, so nothing is sampled",
                'leave it out, or state one, such as mass="30 kg ± 5 %"',
            )
        return answer
    if media == SVG:
        from antrieb._lines import Drawn

        named = {"file": file, "folder": folder_text(folder) or None, "deadline": deadline, "memory": memory}
        kept = {name: value for name, value in named.items() if value is not None}
        text = _origin.absolute(texts[0])
        return Picture(body.decode(), Drawn(command, text, {name: value for name, value in pairs_given if value is not None}, lang, kept))
    if media.startswith(TEXTS):
        return body.decode()
    return body
