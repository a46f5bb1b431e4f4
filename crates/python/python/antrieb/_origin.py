"""Origin of an answer: the call that it comes from, so that a check can be explained."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from antrieb._record import Record

if TYPE_CHECKING:
    from antrieb._nearest import NothingFits
    from antrieb.answers import Explained, Explanations, Judgement, Ranked, Sizing


@dataclasses.dataclass(frozen=True, slots=True)
class Origin:
    """The arguments of a call about a project."""

    text: Any
    given: Mapping[str, Any]
    code: str | None = None
    axis: str | None = None
    drawn: Mapping[str, Any] = dataclasses.field(default_factory=dict[str, Any])
    is_one_of_several: bool = False

    @classmethod
    def of(cls, text: Any, pairs: Any, lang: str, **named: Any) -> Origin:
        """The origin of the answers of a call; a path keeps its meaning in another folder."""
        pairs = [(name, value) for name, value in pairs if value is not None]
        given = {name: value for name, value in pairs if name == "axis"}
        given.update({name: value for name, value in named.items() if value is not None})
        return cls(absolute(text), {**given, "lang": lang}, drawn={name: value for name, value in pairs if name in ("samples", "seed")})

    @property
    def of_axis(self) -> dict[str, Any]:
        """The arguments of a question about the axis alone, with what was drawn."""
        own = {"axis": self.axis} if "axis" in self.given or self.is_one_of_several else {}
        return {**self.given, **own, **self.drawn}


def absolute(text: Any) -> Any:
    """A path that keeps its meaning in another folder; another project as it is."""
    path: Any = text
    if isinstance(text, (str, os.PathLike)) and os.path.exists(path):
        return os.path.abspath(path)
    return path


def attach(answer: Any, origin: Origin) -> None:
    """Attach the origin to a record and the records in it that are shown or explained."""
    if not isinstance(answer, Record):
        return
    if type(answer).__name__.startswith("AxesOf"):
        several: Any = getattr(answer, "axes")  # noqa: B009
        origin = dataclasses.replace(origin, is_one_of_several=len(several) > 1)
    code = getattr(answer, "code", None) or origin.code
    axis = getattr(answer, "axis", None) or origin.axis
    if (code, axis) != (origin.code, origin.axis):
        origin = dataclasses.replace(origin, code=code, axis=axis)
    object.__setattr__(answer, "_origin", origin)
    for name in ("axes", "ranking", "own", "checks"):
        # A record of one axis has itself as its axes.
        if name == "axes" and not type(answer).__name__.startswith("AxesOf"):
            continue
        part: Any = getattr(answer, name, None)
        parts: Any = [part] if isinstance(part, Record) else part or []
        for each in parts:
            attach(each, origin)


def language(record: Any) -> str:
    """The language of a record; English where it is not known."""
    origin = getattr(record, "_origin", None)
    return str(origin.given["lang"]) if isinstance(origin, Origin) else "en"


def judged_nearest(sizing: Sizing | NothingFits) -> Judgement:
    """The actuator with the smallest excess, judged by the question `check` of its project."""
    from antrieb import questions

    origin = getattr(sizing, "_origin", None)
    if sizing.nearest_miss is None or not isinstance(origin, Origin):
        raise LookupError(f"{sizing.axis}: nothing fits; candidates lists every actuator with the reason")
    ask: Any = questions.check
    axes: list[Judgement] = ask(origin.text, sizing.nearest_miss, **origin.of_axis).axes
    for answer in axes:
        if answer.axis == sizing.axis:
            return answer
    raise ValueError("the project has changed since this answer; repeat the question")


def whole_ranking(sizing: Sizing) -> list[Ranked]:
    """Every fitting actuator of a sizing, by the question `size` of its project."""
    from antrieb import questions

    origin = getattr(sizing, "_origin", None)
    if not isinstance(origin, Origin):
        raise ValueError(f"{sizing.axis}: the answer has {len(sizing.ranking)} of {sizing.fitting} fitting actuators, and no project to ask for the others")
    ask: Any = questions.size
    axes: list[Sizing] = ask(origin.text, top=max(1, sizing.fitting), **origin.of_axis).axes
    known = [each.code for each in sizing.ranking]
    for answer in axes:
        if answer.axis == sizing.axis and answer.fitting == sizing.fitting and [each.code for each in answer.ranking[: len(known)]] == known:
            return [*sizing.ranking, *answer.ranking[len(known) :]]
    raise ValueError("the project has changed since this answer; repeat the question")


def explained(check: Any, deadline: str | None) -> Explained:
    """The derivation of a check by the question `explain` of its project."""
    from antrieb import questions

    origin = getattr(check, "_origin", None)
    if not isinstance(origin, Origin):
        raise ValueError("the check is not part of an answer about a project; write antrieb.explain(project, code, check=…)")
    given = {name: value for name, value in origin.given.items() if name != "axis"}
    if deadline is not None:
        given["deadline"] = deadline
    of_axis = {"axis": origin.axis} if "axis" in origin.given or origin.is_one_of_several else {}
    ask: Any = questions.explain
    axes: list[Explanations] = ask(origin.text, origin.code, check=check.id, **of_axis, **given).axes
    for answer in axes:
        if len(axes) > 1 and answer.axis != origin.axis:
            continue
        for each in answer.checks:
            if each.id == check.id and (each.value, each.limit) == (check.value, check.limit):
                attach(each, dataclasses.replace(origin))
                return each
    raise ValueError(f"the project has changed since this answer: {check.id} has other figures now; repeat the question")


def unlisted(rows: Any, code: str) -> str | None:
    """Returns why an actuator is not among those of a sizing; `None` for other lists, and for what is no ordering code."""
    from antrieb import questions
    from antrieb._call import AntriebError

    ranked = [each for each in rows if type(each).__name__ == "Ranked"]
    origin = getattr(ranked[0], "_origin", None) if ranked else None
    if not isinstance(origin, Origin):
        return None
    ask: Any = questions.check
    try:
        answer: Any = ask(origin.text, code, **origin.of_axis)
    except (AntriebError, OSError):
        return None
    judged: Any = next((each for each in answer.axes if each.axis == origin.axis), None)
    if judged is None:
        return None
    if judged.verdict != "does_not_fit":
        return f"{code!r} fits, but only {len(ranked)} are shown; top=… shows more, antrieb.check(project, {code!r}) judges it"
    return f"{code!r} does not fit; `candidates` has it with the reason, antrieb.check(project, {code!r}) judges it"
