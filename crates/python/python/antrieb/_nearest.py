"""What a sizing has beyond its record: the best where there is none, and the actuators beyond the requested number."""

# The classes of one package share what is private.
# pyright: reportPrivateUsage=false

from __future__ import annotations

import dataclasses
from html import escape
from typing import TYPE_CHECKING

from antrieb import _origin
from antrieb._record import Record, Rows

if TYPE_CHECKING:
    from antrieb.answers import Check, Judgement, Ranked, Rejection, Sizing


@dataclasses.dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class NothingFits(Record):
    """Place of the best actuator of an axis that none fits; it is false, and has no code."""

    axis: str
    """Name of the axis."""
    nearest_miss: str | None
    """Ordering code of the actuator with the smallest excess; `None` if no actuator is of the right class."""
    verdict: str = "does_not_fit"
    """Verdict on the axis."""
    code: None = None
    """No ordering code: none fits."""

    @classmethod
    def of(cls, sizing: Sizing) -> NothingFits:
        """Return that of a sizing."""
        found = cls(axis=sizing.axis, nearest_miss=sizing.nearest_miss)
        origin = getattr(sizing, "_origin", None)
        if origin is not None:
            object.__setattr__(found, "_origin", origin)
        return found

    def __bool__(self) -> bool:
        return False

    @property
    def nearest(self) -> Judgement:
        """The actuator with the smallest excess, as `check` judges it.

        Raises:
            LookupError: No actuator meets the requirements and is of the right class.
        """
        return _origin.judged_nearest(self)

    @property
    def checks(self) -> Rows[Check]:
        """The checks of the actuator with the smallest excess; `nearest` is the whole judgement."""
        return self.nearest.checks

    def __repr__(self) -> str:
        if self.nearest_miss is None:
            return f"<{self.axis}: nothing fits; candidates has each actuator with the reason>"
        return f"<{self.axis}: nothing fits; nearest is {self.nearest_miss}, which exceeds its limits least>"

    def __str__(self) -> str:
        return repr(self)

    def _repr_html_(self) -> str:
        return f'<div class="antrieb"><p>{escape(repr(self).strip("<>"))}</p></div>'


def judged(sizing: Sizing) -> Rows[Ranked | Rejection]:
    """Return every actuator that was judged; those beyond the requested number are asked once."""
    if len(sizing.ranking) >= sizing.fitting:
        return Rows([*sizing.ranking, *sizing.rejected])
    kept = getattr(sizing, "_kept", None)
    if kept is None:
        kept = _origin.whole_ranking(sizing)
        object.__setattr__(sizing, "_kept", kept)
    return Rows([*kept, *sizing.rejected])


def of_key(sizing: Sizing, key: int | str) -> Ranked | Rejection:
    """Return an actuator by place or by code; one that is in the answer is not asked anew."""
    if isinstance(key, str):
        ranked = next((each for each in sizing.ranking if each.code == key), None)
        found = ranked or next((each for each in sizing.rejected if each.code == key), None)
        if found is not None:
            return found
    return sizing.candidates[key]
