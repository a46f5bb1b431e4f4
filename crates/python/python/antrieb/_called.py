"""Functions whose refused calls say what to write: arguments by place, names that are none, arguments that are missing."""

from __future__ import annotations

import difflib
import functools
import inspect
import re
from collections.abc import Callable, Mapping
from typing import Any, ParamSpec, TypeVar

from antrieb._plain import shown

GENERAL = ("lang", "axis", "file", "folder", "deadline", "memory", "progress", "theme", "width", "height", "format")
"""Arguments of most questions, which a value without a name is rarely meant for."""

NAMED_MOST = 4
"""Arguments that a refusal proposes."""

P = ParamSpec("P")
T = TypeVar("T")


def called(function: Callable[P, T]) -> Callable[P, T]:
    """Return a function that refuses a call of another form by the names of its arguments."""

    @functools.wraps(function)
    def inner(*places: P.args, **given: P.kwargs) -> T:
        try:
            return function(*places, **given)
        except TypeError as error:
            trace = error.__traceback__
            if trace is None or trace.tb_next is not None:
                raise
            # The interpreter refused the call itself.
            why = refused(function, places, given)
        raise TypeError(why)

    return inner


def refused(function: Callable[..., Any], places: tuple[Any, ...], given: Mapping[str, Any]) -> str:
    """Return why a call does not fit a function, and what to write."""
    name = function.__qualname__.removesuffix(".__init__")
    parameters = list(inspect.signature(function).parameters.values())
    if parameters and parameters[0].name == "self":
        parameters, places = parameters[1:], places[1:]
    has_any = any(each.kind is each.VAR_KEYWORD for each in parameters)
    first = [each for each in parameters if each.kind is each.POSITIONAL_OR_KEYWORD]
    known = [each.name for each in parameters if each.kind in (each.POSITIONAL_OR_KEYWORD, each.KEYWORD_ONLY)]
    for each in given:
        if each not in known and not has_any:
            near = difflib.get_close_matches(each, known, 1)
            hint = f"did you mean {near[0]!r}?" if near else f"it has {', '.join(known)}"
            return f"{name} has no argument {each!r}; {hint}"
    if len(places) > len(first):
        value = places[len(first)]
        named = [each.name for each in parameters if each.kind is each.KEYWORD_ONLY]
        special = [each for each in named if each not in GENERAL] or named or ["…"]
        own = "lang" if isinstance(value, str) and value in ("en", "de") else "=…, ".join(special[:NAMED_MOST])
        taken = ", ".join(each.name for each in first) or "nothing"
        return f"{name} takes {taken} by place; {shown(value)} has no name; write it as in {own}=…"
    twice = [each.name for each in first[: len(places)] if each.name in given]
    if twice:
        return f"{name} has {twice[0]} twice, by place and by name"
    missing = [each for each in first[len(places) :] if each.default is each.empty and each.name not in given]
    missing += [each for each in parameters if each.kind is each.KEYWORD_ONLY and each.default is each.empty and each.name not in given]
    if not missing:
        return f"{name} does not take these arguments; it has {', '.join(known)}"
    words = re.findall(r"Literal\[([^\]]*)\]", str(missing[0].annotation))
    hint = f"; it is one of {words[0]}" if words else ""
    return f"{name} takes {' and '.join(each.name for each in missing)}, which {'is' if len(missing) == 1 else 'are'} missing{hint}"
