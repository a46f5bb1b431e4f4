"""Recorded runs as they come: a path, the text or the bytes of a file, or a table of columns."""

from __future__ import annotations

import csv
import os
import pathlib
import tempfile
from collections.abc import Mapping
from typing import Any

from antrieb._arrow import ArrowArray, ArrowStream
from antrieb._tables import arrow, of_columns

Trace = str | os.PathLike[str] | bytes | ArrowStream | ArrowArray | Mapping[str, Any]
"""A recorded run: the path of its file, a text of several lines, the bytes of a file, or a table with the columns of one."""


class HeldFile:
    """A file for the time of a call; what calls it a file sees its name alone."""

    __slots__ = ("_folder", "path")

    def __init__(self, content: bytes, name: str) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="antrieb-")
        self.path = pathlib.Path(self._folder.name, name)
        self.path.write_bytes(content)

    def __fspath__(self) -> str:
        return os.fspath(self.path)

    def end(self) -> None:
        """Removes the file."""
        self._folder.cleanup()

    @property
    def folder(self) -> str:
        """The folder, with the separator behind it."""
        return os.path.join(self._folder.name, "")


def held(name: str, given: Any) -> Any:
    """A path as it is; a text, bytes or a table as a file for the time of a call."""
    path: Any = given
    if isinstance(given, bytes):
        if not given:
            raise ValueError(f"{name}: the file is empty")
        return HeldFile(given, name)
    if isinstance(given, str):
        return HeldFile(given.encode(), name) if "\n" in given else given
    if isinstance(given, os.PathLike):
        return path
    if not isinstance(given, Mapping) and not hasattr(given, "__arrow_c_stream__") and not hasattr(given, "dtype"):
        raise TypeError(
            f"{name}: the path of a recorded run, its text or bytes, or a table such as {{'time [s]': t, 'position [deg]': q}} "
            f"is expected, not {type(given).__name__}"
        )
    columns = _columns(given, name)
    rows = zip(*columns.values(), strict=True)
    with tempfile.SpooledTemporaryFile(mode="w+", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(["" if value is None else repr(value) if isinstance(value, float) else value for value in row] for row in rows)
        file.seek(0)
        return HeldFile(file.read().encode(), name)


def _columns(given: Any, name: str) -> dict[str, list[Any]]:
    source: Any = given
    if type(source).__module__.startswith("polars"):
        source = source.to_dict(as_series=False)
    elif hasattr(source, "to_pydict"):
        source = source.to_pydict()
    elif not isinstance(given, Mapping):
        table: Any = arrow(source, name)
        source = table.to_pydict()
    columns = of_columns(source, name).to_pydict()
    if not columns or not next(iter(columns.values())):
        raise ValueError(f"{name}: the table has no rows")
    return columns
