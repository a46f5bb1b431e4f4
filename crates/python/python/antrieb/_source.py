"""Projects that are no text: what the questions take beside texts and paths."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

Handed = tuple[str | None, str, str, Mapping[str, bytes]]
"""A text with its name, its folder and the recordings that it holds; of a path no text."""


def folder_text(folder: Any) -> str:
    """Returns a folder as it is handed over; empty without one.

    Raises:
        TypeError: It is no path.
        NotADirectoryError: There is no such folder.
    """
    if folder is None:
        return ""
    if not isinstance(folder, (str, os.PathLike)):
        raise TypeError(f"folder is the path of a folder, not {type(folder).__name__}")
    path: str = os.fsdecode(folder)  # pyright: ignore[reportUnknownArgumentType]
    if path and not os.path.isdir(path):
        raise NotADirectoryError(f"folder: there is no folder {path!r}; it is where the recordings of a text lie")
    # A folder keeps its meaning when the working folder changes, and in another process.
    return os.path.abspath(path) if path else path


class ProjectSource:
    """A project as objects: an `Axis`, or a `Project` with several."""

    __slots__ = ()

    def _handed(self) -> Handed:
        """The text of its file for a question."""
        raise NotImplementedError
