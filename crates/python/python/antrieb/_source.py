"""Projects that are no text: what the questions take beside texts and paths."""

from __future__ import annotations

from collections.abc import Mapping

Handed = tuple[str | None, str, str, Mapping[str, bytes]]
"""A text with its name, its folder and the recordings that it holds; of a path no text."""


class ProjectSource:
    """A project as objects: an `Axis`, or a `Project` with several."""

    __slots__ = ()

    def _handed(self) -> Handed:
        """The text of its file for a question."""
        raise NotImplementedError
