"""Parts of the package that are loaded when they are first used, so that `import antrieb` is quick."""

from __future__ import annotations

import importlib
from typing import Any


class Lazy:
    """A module of the package, loaded with the first use of one of its names."""

    __slots__ = ("_name",)

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, name: str) -> Any:
        # The import system has locks of its own: several threads may be the first.
        return getattr(importlib.import_module(self._name), name)


def lazy(name: str) -> Any:
    """Return a module of the package that is loaded when it is used."""
    return Lazy(name)
