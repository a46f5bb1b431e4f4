"""Faults of arguments that are found before a question is put."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from antrieb._call import AntriebError


def fault(message: str, hint: str | None = None) -> AntriebError:
    """Returns the exception with one fault."""
    from antrieb._call import AntriebError

    return AntriebError({"errors": [{"message": message, "hint": hint}]})


def faults(found: Sequence[tuple[str, str | None]]) -> AntriebError:
    """Returns the exception with several faults."""
    from antrieb._call import AntriebError

    return AntriebError({"errors": [{"message": message, "hint": hint} for message, hint in found]})


def no_choice(name: str, value: str, words: Sequence[str]) -> AntriebError:
    """Returns the exception for a word that is none of these."""
    near = difflib.get_close_matches(value, words, 1)
    hint = f'did you mean "{near[0]}"?' if near else "valid are " + ", ".join(f'"{word}"' for word in words)
    return fault(f'{name}: "{value}" is no choice', hint)
