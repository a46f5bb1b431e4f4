"""Axes and projects as objects: from text to objects, and back with the comments of the text."""

# Values of other libraries and of files have no types until they are looked at; the classes of one package share what is private.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportPrivateUsage=false

from __future__ import annotations

import os
import pathlib
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Self

from antrieb import _antrieb
from antrieb._called import called
from antrieb._fault import fault
from antrieb._plain import text as plain_text
from antrieb._record import place_of
from antrieb._section import Document, Load, ReturnMove, Section, Segment, Unread, _class, _of_file, _steps, _written
from antrieb._source import Handed, ProjectSource, folder_text
from antrieb._toml import changes, rendered

if TYPE_CHECKING:
    from antrieb.sections import Axis, Project


class _Source(Section, ProjectSource):
    """Objects with the text that they come from, and the recordings that they hold."""

    __slots__ = ("_folder", "_name", "_recordings", "_text")

    _text: str | None
    """The text that they come from."""

    _name: str
    """What a fault calls it."""

    _folder: str
    """Where its recordings lie."""

    _recordings: Mapping[str, bytes]
    """Recordings that are in no file."""

    def _begin(self, **given: Any) -> None:
        super()._begin(**given)
        self._of(None, "", "", {})

    def _of(self, text: str | None, name: str, folder: str, recordings: Mapping[str, bytes]) -> Self:
        for field, value in (("_text", text), ("_name", name), ("_folder", folder), ("_recordings", recordings)):
            object.__setattr__(self, field, value)
        return self

    def _with(self, values: Mapping[str, Any]) -> Self:
        return super()._with(values)._of(self._text, self._name, self._folder, self._recordings)

    def _state(self) -> dict[str, Any]:
        names = ("_values", "_text", "_name", "_folder", "_recordings")
        return {name: getattr(self, name) for name in names}

    def _is_like(self, other: Section) -> bool:
        return isinstance(other, _Source) and self._recordings == other._recordings and self._returns() == other._returns()

    def _returns(self) -> list[list[int]]:
        """The places of the returns in each axis: a written way back is a fixed distance, that of a return is not."""
        return [[place for place, each in enumerate(axis.motion) if isinstance(each, ReturnMove)] for axis in self.axes]

    def __hash__(self) -> int:
        return hash(repr((self._document(), self._returns())))

    def __repr__(self) -> str:
        text = super().__repr__()
        for axis in self._values.get("axis") or ():
            text = text.replace(repr(axis), Section.__repr__(axis))
        if not self._recordings:
            return text
        # As Python it would look for files; a comment says that there are none.
        shown = ", ".join(list(self._recordings)[:3]) + (", …" if len(self._recordings) > 3 else "")
        return f"{text}  # with recordings that are in no file: {shown}; save writes them"

    def to_toml(self) -> str:
        """Returns the text of the project file.

        Where the objects come from a text, it is that text with what has changed: comments and order are kept.
        """
        document = self._document()
        if self._text is None:
            return rendered(document)
        before = _without_empty(tomllib.loads(self._text))
        if before == document:
            return self._text
        text = _antrieb.edited(self._text, list(changes(before, document)))
        # An edit that is not exactly the change is none.
        return text if text is not None and _without_empty(tomllib.loads(text)) == document else rendered(document)

    def save(self, path: str | os.PathLike[str], *, force: bool = False) -> None:
        """Writes the project file, and beside it its recordings: those that are in no file, named after the project
        (`robot-J1-1.csv`), and those of another folder.

        Args:
            path: The file, which ends in `.toml`.
            force: Overwrite a project file with other content; that from which the project was loaded is overwritten without it.

        Raises:
            AntriebError: The path has another ending, or a file with other content lies there, or where a recording would be
                written.
        """
        from antrieb import _recordings

        _recordings.save(self, path, force)  # type: ignore[arg-type]

    def _handed(self) -> Handed:
        return self.to_toml(), self._name or "project", self._folder, self._recordings

    def __str__(self) -> str:
        return self.to_toml()


class BaseAxis(_Source):
    """What the generated class of an axis has beside its keywords."""

    __slots__ = ()

    _REQUIREMENTS: ClassVar[tuple[str, ...]] = ()

    if TYPE_CHECKING:
        name: str | None
        mechanism: Load
        motion: tuple[Segment, ...]

    @property
    def axes(self) -> tuple[Axis, ...]:
        """It as the only axis, as a project has several."""
        return (self,)  # type: ignore[return-value]

    def _begin(self, **given: Any) -> None:
        if given.get("mechanism") is None:
            raise TypeError(f"{type(self).__name__} takes a load or a mechanism, such as antrieb.Arm(…)")
        if isinstance(given.get("name"), Load):
            raise TypeError('the name comes first: Axis("tilt", Arm(…), [Move(…), …]); None leaves it out')
        super()._begin(**given)

    def _heads(self, values: Mapping[str, Any]) -> list[tuple[str, list[str]]]:
        own = [name for name in values if name not in self._REQUIREMENTS]
        required = [name for name in values if name in self._REQUIREMENTS]
        return [("format = 1\n[axis]\n", own), ("format = 1\n[requirements]\n", required)]

    def _parts(self) -> Document:
        """The tables of the axis, each motion as the file has it."""
        found: Document = {}
        required: Document = {}
        for name, value in self._values.items():
            if name in ("name", "single_move", "curve", "catalogue"):
                continue
            if name == "mechanism":
                table, _, own = value._TABLE.partition(".")
                found[table] = {own: value._document()} if own else value._document()
            elif name == "motion":
                whole: tuple[Segment, ...] = ()
                for segment in value:
                    whole = (*whole, segment._resolved(whole))
                found["motion"] = [segment._document() for segment in whole]
            elif name in self._REQUIREMENTS:
                required[name] = _written(value)
            else:
                found[name] = value._document()
        return {**found, **({"requirements": required} if required else {})}

    def _named(self) -> Document:
        return {name: self._values[name] for name in ("name", "single_move") if name in self._values}

    def _document(self) -> Document:
        head = self._named()
        return {"format": 1, **({"axis": head} if head else {}), **self._parts(), **_shared(self._values)}

    def _replaced(self, steps: list[str | int], path: str, value: Any) -> Self:
        first, *rest = steps
        if first == "axis":
            return self._replaced(rest, path, value)
        if first == "requirements" and rest:
            return self._replaced(rest, path, value)
        table, _, own = self.mechanism._TABLE.partition(".")
        if first == "load" and table != "load":
            last = joined(rest)
            is_there = bool(rest) and rest[-1] in self.mechanism._KEYS
            hint = f'did you mean "{table}.{own}.{last}"?' if is_there else f"its keys begin with {table}.{own}"
            raise fault(f"{path}: the axis has [{table}.{own}] and no [load]", hint)
        if first == "mechanism" and len(rest) > 1 and rest[0] == own:
            rest = rest[1:]
        return super()._replaced(["mechanism" if first == "load" else first, *rest], path, value)

    def _path(self, path: str) -> str:
        """A path as the file has it: `motion[1].payload`, `requirements.supply`."""
        first, *rest = _steps(path)
        if first in self._REQUIREMENTS:
            first, rest = "requirements", [first, *rest]
        table, _, own = self.mechanism._TABLE.partition(".")
        if first == "mechanism" and not (len(rest) > 1 and rest[0] != own and _is_mechanism(str(rest[0]))):
            inner = rest[1:] if len(rest) > 1 and rest[0] == own else rest
            first, rest = table, [*([own] if own else []), *inner]
        return joined([first, *rest])

    def _handed(self) -> Handed:
        text, _, folder, recordings = super()._handed()
        return text, self._name or self.name or "axis", folder, recordings

    @classmethod
    def _of_document(cls, document: Document, path: str) -> Self:
        """An axis from the tables of its file."""
        inside = document.get("mechanism", {})
        required = document.get("requirements", {})
        motion = document.get("motion")
        if not isinstance(inside, dict) or not isinstance(required, dict) or not isinstance(motion, list):
            raise Unread(f"{path}motion")
        if len(inside) + ("load" in document) != 1:
            raise Unread(f"{path}mechanism")
        apart = ("load", "mechanism", "requirements", "motion")
        own = {key: value for key, value in document.items() if key not in apart}
        if any((key in cls._REQUIREMENTS) != (tables is required) for tables in (own, required) for key in tables):
            raise Unread(f"{path}requirements")
        values: dict[str, Any] = {}
        for key, value in {**own, **required}.items():
            if key not in cls._KEYS:
                raise Unread(f"{path}{key}")
            values[key] = _of_file(cls._KEYS[key], value, f"{path}{key}")
        segments = tuple(_segment(each, f"{path}motion[{place}]") for place, each in enumerate(motion, 1))
        made = cls.__new__(cls)
        made._begin(mechanism=_mechanism(document, path), motion=segments, **values)
        return made


def _shared(values: Mapping[str, Any]) -> Document:
    """What the axes of a project share: the user's curves and the catalogue files."""
    return {name: _written(values[name]) for name in ("curve", "catalogue") if name in values}


class BaseProject(_Source):
    """What the generated class of a project has beside its keywords."""

    __slots__ = ()

    if TYPE_CHECKING:
        axis: tuple[Axis, ...]

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The axes."""
        return self.axis

    def _begin(self, **given: Any) -> None:
        if given.get("axis") is None:
            raise TypeError('Project takes axes, such as [antrieb.Axis("lift", …), antrieb.Axis("swivel", …)]')
        super()._begin(**given)
        recordings: dict[str, bytes] = {}
        names: set[str | None] = set()
        for axis in self.axis:
            if axis.curve:
                raise fault(f"axis {axis.name!r}: curves belong to the project", "give them to Project(…, curve=[…])")
            if axis.catalogue:
                raise fault(f"axis {axis.name!r}: catalogue files belong to the project", "give them to Project(…, catalogue=…)")
            if axis.name is None or axis.name in names:
                raise fault(f"Project.axis: {'an axis has no name' if axis.name is None else f'two axes are named {axis.name!r}'}",
                            'name each: Axis("tilt", …)')
            names.add(axis.name)
            if any(recordings.get(name, content) != content for name, content in axis._recordings.items()):
                raise fault(f"axis {axis.name!r}: another axis has a recording of the same name")
            recordings.update(axis._recordings)
        folders = {axis._folder for axis in self.axis}
        if len(folders) > 1:
            raise fault("Project.axis: the axes come from several folders", "save them into one")
        if not self.axis:
            raise TypeError("Project takes one axis at least")
        self._of(None, "", folders.pop(), recordings)

    def _with(self, values: Mapping[str, Any]) -> Self:
        made = super(_Source, self)._with(values)
        recordings = {**self._recordings, **made._recordings}
        return made._of(self._text, self._name, self._folder or made._folder, recordings)

    def _document(self) -> Document:
        axes = [{**axis._named(), **axis._parts()} for axis in self.axis]
        return {"format": 1, "axis": axes, **_shared(self._values)}

    def __iter__(self) -> Iterator[Axis]:
        return iter(self.axis)

    def __len__(self) -> int:
        return len(self.axis)

    def __getitem__(self, which: int | str) -> Axis:
        """An axis by its place from 0, as in a list, or by its name."""
        if isinstance(which, str):
            for axis in self.axis:
                if axis.name == which:
                    return axis
            raise KeyError(f"no axis is named {which!r}; there are {', '.join(str(axis.name) for axis in self.axis)}")
        if isinstance(which, slice):  # pyright: ignore[reportUnnecessaryIsInstance]
            return self.axis[which]
        try:
            return self.axis[place_of(which, "an axis by its place from 0, or by its name")]
        except IndexError:
            raise IndexError(f"there are {len(self.axis)} axes, the first at 0, and none at {which}") from None


def _without_empty(document: Document) -> Document:
    """A document without tables that state nothing: an axis keeps none of its requirements without values."""
    found = {key: value for key, value in document.items() if value != {} or key not in ("requirements", "axis")}
    several = found.get("axis")
    if isinstance(several, list):
        found["axis"] = [_without_empty(each) for each in several]
    return found


def _is_mechanism(name: str) -> bool:
    """Returns true for the table of a mechanism: `arm` of `[mechanism.arm]`."""
    from antrieb import sections

    return any(isinstance(of, type) and issubclass(of, Load) and of._TABLE == f"mechanism.{name}" for of in vars(sections).values())


def joined(steps: Iterable[str | int]) -> str:
    """Returns the parts of a path as the file has it: `motion[1].payload`."""
    out = ""
    for step in steps:
        out += f"[{step}]" if isinstance(step, int) else f".{step}"
    return out.lstrip(".")


def _mechanism(document: Document, path: str) -> Load:
    from antrieb import sections

    for of in vars(sections).values():
        if isinstance(of, type) and issubclass(of, Load) and of._KEYS:
            table, _, own = of._TABLE.partition(".")
            if table in document and (not own or own in document[table]):
                value = document[table][own] if own else document[table]
                if not isinstance(value, dict):
                    break
                return of._read(value, f"{path}{of._TABLE}")
    raise Unread(f"{path}mechanism")


def _segment(document: Any, path: str) -> Segment:
    from antrieb import sections

    if not isinstance(document, dict):
        raise Unread(path)
    law = document.get("law")
    for of in vars(sections).values():
        if isinstance(of, type) and issubclass(of, Segment) and of is not sections.Return and of._KEYS:
            kind = of._KEYS.get("law")
            if law == of._LAW or (kind is not None and law in kind.words):
                return of._read(document, path)
    raise Unread(f"{path}.law")


@called
def loads(text: str, *, name: str | None = None, folder: str | os.PathLike[str] | None = None) -> Axis | Project:
    """Returns the project of a text as objects: an `Axis`, or a `Project` where the text has `[[axis]]`.

    Args:
        text: The text of a project file.
        name: What a fault calls it.
        folder: Where the recordings lie that it names; without it the current folder.

    Raises:
        AntriebError: Every fault of the text, with its place.
    """
    from antrieb.questions import moves
    from antrieb.sections import Axis, Project

    # Callers without a type checker.
    if not isinstance(text, str):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise TypeError(f"loads takes the text of a project file, not {type(text).__name__}; load takes its path")
    from antrieb._call import name_of

    title, beside = name_of("name", name) or "text", folder_text(folder)
    text = plain_text(text, "text")
    try:
        document = tomllib.loads(text.removeprefix("\ufeff"))
        if document.pop("format", None) != 1:
            raise Unread("format")
        several = document.get("axis")
        if isinstance(several, list):
            if document.keys() - {"axis", "curve", "catalogue"}:
                raise Unread("axis")
            axes = [Axis._of_document(dict(each), f"axis[{place}].")._of(None, "", beside, {}) for place, each in enumerate(several, 1)]
            curve = [_class("Curve")._read(each, f"curve[{place}]") for place, each in enumerate(document.get("curve", []), 1)]
            files = _class("CatalogueFiles")._read(document["catalogue"], "catalogue") if "catalogue" in document else None
            made: Axis | Project = Project(axes, curve=curve or None, catalogue=files)  # type: ignore[arg-type]
        else:
            head = document.pop("axis", {})
            if not isinstance(head, dict) or head.keys() - {"name", "single_move"}:
                raise Unread("axis")
            made = Axis._of_document({**document, **head}, "")
    except (tomllib.TOMLDecodeError, Unread, TypeError, AttributeError, KeyError, ValueError) as found:
        # The reader of the engine states every fault with its place and the nearest name.
        moves(text if "\n" in text else text + "\n", file=title, folder=folder)
        if isinstance(found, ValueError) and not isinstance(found, tomllib.TOMLDecodeError):
            raise
        raise fault(f"{title}: {found} cannot be read as objects", "hand over the text itself") from None
    return made._of(text, name or "", beside, made._recordings)


@called
def load(path: str | os.PathLike[str]) -> Axis | Project:
    """Returns the project of a file as objects: an `Axis`, or a `Project` where the file has `[[axis]]`.

    Raises:
        AntriebError: Every fault of the file, with its place.
        OSError: The file cannot be read.
    """
    # Callers without a type checker.
    if not isinstance(path, (str, os.PathLike)):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise TypeError(f"load takes the path of a project file, not {type(path).__name__}; loads takes its text")
    from antrieb.questions import moves

    if "\0" in os.fsdecode(path):
        raise fault(f"path: {os.fsdecode(path)!r:.60} has a character with the number zero", "leave it out")
    file = pathlib.Path(path)
    # Files that an editor of Windows wrote.
    try:
        text = file.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError:
        # The reader of the engine states the place of the wrong byte.
        moves(path)
        raise
    return loads(text, name=os.fspath(path), folder=file.parent)


def to_source(of: Any, name: str = "text") -> ProjectSource | None:
    """Returns what a question takes as a project: an axis, a project, or several axes; `None` for a text or a path. In faults it is
    the argument of this name."""
    if isinstance(of, ProjectSource):
        return of
    each: list[Any] = list(of) if isinstance(of, (list, tuple)) else []
    for place, one in enumerate(each, 1):
        if not isinstance(one, BaseAxis):
            raise TypeError(f"{name}: a list of axes has axes only; entry {place} is {type(one).__name__}")
    if each:
        from antrieb.sections import Project

        only: ProjectSource = each[0]
        return Project(each) if len(each) > 1 else only
    return None


NAME = re.compile(r"[^A-Za-z0-9_-]+")
"""Signs of a name that no file should have."""
