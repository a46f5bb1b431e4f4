"""Recordings beside the file of a project: names that no other project uses, and nothing overwritten."""

# The classes of one package share what is private.
# pyright: reportPrivateUsage=false

from __future__ import annotations

import errno
import filecmp
import os
import pathlib
import shutil
from collections.abc import Mapping
from typing import TYPE_CHECKING

from antrieb._fault import fault

if TYPE_CHECKING:
    from antrieb._axis import BaseAxis, BaseProject, _Source

ENDING = ".toml"


def save(source: BaseAxis | BaseProject, path: str | os.PathLike[str], force: bool = False) -> None:
    """Writes a project file, and beside it the recordings that the project uses.

    Raises:
        AntriebError: The path does not end in `.toml`, or another file lies there or where a recording would be written.
    """
    from antrieb._call import flag

    # Callers without a type checker.
    if not isinstance(path, (str, os.PathLike)):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise TypeError(f"save takes the path of a file, not {type(path).__name__}")
    file = pathlib.Path(path)
    if file.suffix.lower() != ENDING:
        raise fault(f"save: a project file ends in {ENDING}, not {file.name!r}", f'write save("{file.stem or "axis"}{ENDING}")')
    if not file.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), os.fspath(file.parent))
    names = {name: f"{file.stem}-{name}" for name in used(source) if name in source._recordings}
    contents: dict[pathlib.Path, bytes | pathlib.Path] = {}
    for name in used(source):
        goal = file.parent / names.get(name, name)
        content = source._recordings[name] if name in source._recordings else _copied(source, name, goal)
        if content is None:
            continue
        other = contents.setdefault(goal, content)
        if other != content or (goal.exists() and not _is_equal(goal, content)):
            raise fault(
                f"save: {os.fspath(goal)!r} would be overwritten by another recording",
                f"save under another name or in another folder, or remove {goal.name} first",
            )
    # Nothing is written before everything can be.
    text = renamed(source, names).to_toml()
    if not flag("force", force) and file.exists() and not _is_own(source, file) and not _is_equal(file, text.encode()):
        raise fault(f"save: {os.fspath(path)!r} exists and has other content", "save under another name, or with force=True")
    for goal, content in contents.items():
        if goal.exists():
            continue
        goal.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, bytes):
            goal.write_bytes(content)
        else:
            shutil.copyfile(content, goal)
    # The ends of its lines are those of the text.
    file.write_bytes(text.encode())


def _is_own(source: BaseAxis | BaseProject, file: pathlib.Path) -> bool:
    """Returns true for the file from which a project was loaded."""
    return source._text is not None and bool(source._name) and pathlib.Path(source._name).resolve() == file.resolve()


def used(source: BaseAxis | BaseProject) -> list[str]:
    """Returns the files of the recorded segments, once each."""
    from antrieb.sections import Recorded

    return list(dict.fromkeys(each.file for axis in source.axes for each in axis.motion if isinstance(each, Recorded)))


def renamed(source: BaseAxis | BaseProject, names: Mapping[str, str]) -> _Source:
    """Returns the project with other names of its recordings."""
    from antrieb._axis import BaseAxis

    if not names:
        return source
    if isinstance(source, BaseAxis):
        return _axis(source, names)
    recordings = _recordings(source, names)
    made = source._with({"axis": tuple(_axis(each, names) for each in source.axes)})
    return made._of(source._text, source._name, source._folder, recordings)


def _axis(axis: BaseAxis, names: Mapping[str, str]) -> BaseAxis:
    from antrieb.sections import Recorded

    motion = [each.replace(file=names.get(each.file, each.file)) if isinstance(each, Recorded) else each for each in axis.motion]
    made = axis._with({"motion": tuple(motion)})
    return made._of(axis._text, axis._name, axis._folder, _recordings(axis, names))


def _recordings(source: _Source, names: Mapping[str, str]) -> Mapping[str, bytes]:
    return {names.get(name, name): content for name, content in source._recordings.items()}


def _copied(source: _Source, name: str, goal: pathlib.Path) -> pathlib.Path | None:
    """The file of a recording that has to be copied; `None` if the project finds it where it is."""
    origin = pathlib.Path(source._folder, name)
    if pathlib.Path(name).is_absolute() or origin.resolve() == goal.resolve():
        return None
    if not origin.is_file():
        if source._folder and goal.exists():
            raise fault(f"save: the recording {os.fspath(origin)!r} is missing, and {os.fspath(goal)!r} may be another", "save into its folder")
        return None
    if ".." in pathlib.Path(name).parts:
        raise fault(
            f"save: the recording {name!r} lies outside of the folder of the project",
            "save into the folder of the project, or name the recording by its whole path",
        )
    return origin


def _is_equal(goal: pathlib.Path, content: bytes | pathlib.Path) -> bool:
    if not goal.is_file():
        return False
    if isinstance(content, bytes):
        return goal.stat().st_size == len(content) and goal.read_bytes() == content
    return filecmp.cmp(goal, content, shallow=False)
