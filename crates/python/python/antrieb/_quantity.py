"""Quantities: a text with its unit, a number or an array with a stated unit, a quantity of pint."""

# Values of other libraries and of files have no types until they are looked at; the classes of one package share what is private.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportPrivateUsage=false

from __future__ import annotations

import math
import operator
import re
from collections.abc import Iterator, Sequence
from decimal import Decimal
from typing import Any, Protocol, SupportsFloat

from antrieb._fault import fault


class PintQuantity(Protocol):
    """A quantity of pint, or of a library alike: a number and its unit."""

    @property
    def magnitude(self) -> Any:
        """The number, or an array of them."""
        ...

    @property
    def units(self) -> Any:
        """The unit of all of them."""
        ...


class Q:
    """Numbers with a unit; `antrieb.q` makes them."""

    __slots__ = ("unit", "value")

    value: float | tuple[float, ...]
    """The number, or the numbers of an array of one dimension."""

    unit: str
    """Their unit as a project file has it."""

    def __init__(self, value: float | tuple[float, ...], unit: str) -> None:
        object.__setattr__(self, "value", value)
        object.__setattr__(self, "unit", unit)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("a quantity does not change; antrieb.q makes another")

    def __reduce__(self) -> tuple[Any, ...]:
        return Q, (self.value, self.unit)

    def __eq__(self, other: object) -> bool:
        return (self.value, self.unit) == (other.value, other.unit) if isinstance(other, Q) else NotImplemented

    def __hash__(self) -> int:
        return hash((self.value, self.unit))

    def __len__(self) -> int:
        return len(self.values)

    def __iter__(self) -> Iterator[Q]:
        return (Q(value, self.unit) for value in self.values)

    def __getitem__(self, place: int) -> Q:
        return Q(self.values[place], self.unit)

    def __repr__(self) -> str:
        if isinstance(self.value, tuple) and len(self.value) > SHOWN:
            first = ", ".join(map(_number, self.value[:SHOWN]))
            return f"<q([{first}, …], {self.unit!r}) of {len(self.value)} numbers>"
        shown = f"[{', '.join(map(_number, self.value))}]" if isinstance(self.value, tuple) else _number(self.value)
        return f"q({shown}, {self.unit!r})"

    def __str__(self) -> str:
        return ", ".join(self.texts)

    @property
    def values(self) -> tuple[float, ...]:
        """The numbers, also of a single one."""
        return self.value if isinstance(self.value, tuple) else (self.value,)

    @property
    def texts(self) -> list[str]:
        """Each as a project file has it: `30 kg`."""
        return [f"{_number(value)} {self.unit}".rstrip() for value in self.values]


Quantity = str | Q | PintQuantity
"""A quantity: a text with its unit (`"30 kg"`), `antrieb.q(30, "kg")`, or a quantity of pint."""

SHOWN = 6
"""Numbers of an array that its `repr` shows."""

_FUNNY = {"turn": "rev", "revolutions_per_minute": "rpm", "°": "deg", "Δ°C": "K", "delta_degC": "K", "%": "%"}
"""Units as pint writes them, where a project file writes them otherwise."""


def q(value: Any, unit: Any) -> Q:
    """Returns a number or an array with its unit: `q(30, "kg")`, `q(np.linspace(0, 10, 50), "kg")`.

    Args:
        value: A number, or an array, a series or a list of numbers.
        unit: Their unit as a project file has it (`kg m^2`, `1/min`; `antrieb units` lists them all), or a unit of pint;
            `""` for ratios.
    """
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        raise TypeError("q: the value has a unit already; hand it over as it is")
    numbers = _numbers(value, "q")
    return Q(numbers, unit_of(unit))


def unit_of(unit: Any) -> str:
    """Returns a unit as a project file has it."""
    if isinstance(unit, str):
        return unit.strip()
    if hasattr(unit, "dimensionality"):
        return _of_pint(unit)
    raise TypeError(f'unit is a text such as "kg", not {type(unit).__name__}')


def _numbers(value: Any, name: str) -> float | tuple[float, ...]:
    """A number, or those of an array of one dimension."""
    if isinstance(value, (str, bytes)) or value is None or isinstance(value, bool):
        raise TypeError(f"{name}: numbers are expected, not {type(value).__name__}")
    if hasattr(value, "mask") and bool(getattr(value.mask, "any", lambda: value.mask)()):
        raise TypeError(f"{name}: the array has masked values")
    if hasattr(value, "tolist"):
        value = value.tolist()
    elif hasattr(value, "to_list"):
        value = value.to_list()
    if isinstance(value, (list, tuple, range)) or (hasattr(value, "__iter__") and hasattr(value, "__len__")):
        return tuple(_one(each, name) for each in value)
    return _one(value, name)


def _one(value: Any, name: str) -> float:
    if hasattr(value, "item"):
        value = value.item()
    if isinstance(value, (list, tuple)):
        raise TypeError(f"{name}: an array of one dimension is expected")
    if isinstance(value, (bool, str, bytes, complex)) or value is None:
        raise TypeError(f"{name}: numbers are expected, not {type(value).__name__}")
    try:
        return operator.index(value)
    except TypeError:
        pass
    if not isinstance(value, SupportsFloat):
        raise TypeError(f"{name}: numbers are expected, not {type(value).__name__}")
    return float(value)


def _number(value: float) -> str:
    return repr(value)


def _of_pint(unit: Any) -> str:
    """Returns a unit of pint as a project file has it: a product of names with an explicit sign."""
    text = format(unit, "~C")
    if text in _FUNNY:
        return _FUNNY[text]
    if text == "dimensionless":
        return ""
    parts = re.split(r"([*/]+|\(|\)|[0-9.-]+)", text.replace(" ", ""))
    return "".join(_FUNNY.get(part, "^" if part == "**" else part) for part in parts)


def of_pint(value: Any) -> Q | None:
    """Returns a quantity of pint as numbers with their unit; `None` for anything else."""
    if isinstance(value, Q) or not (hasattr(value, "magnitude") and hasattr(value, "units")):
        return None
    return Q(_numbers(value.magnitude, "magnitude"), _of_pint(value.units))


_PLAIN = re.compile(r"\s*([+\-−]?(?:\d+\.?\d*|\.\d+)(?:[eE][+\-−]?\d+)?)\s*(.*?)\s*", re.DOTALL)
_LATEX = ((r"\ ", " "), (r"\cdot", "*"), (r"\mathrm", ""), (r"\frac{1}", "1/"), ("\\[", ""), ("\\]", ""), ("$", ""))


def split(text: str) -> tuple[Decimal, str] | None:
    """Returns number and unit of a text; `None` for a text that is no plain quantity."""
    found = _PLAIN.fullmatch(text)
    if not found or "±" in text or "+/-" in text:
        return None
    return Decimal(found[1].replace("−", "-")), found[2]


def text_of(value: Any, name: str, example: str) -> str:
    """Returns a quantity as a project file has it.

    Raises:
        TypeError: It is none, or several; the message names the argument and what to write.
        AntriebError: It is not finite.
    """
    if isinstance(value, str):
        if "\\" in value:
            for latex, plain in _LATEX:
                value = value.replace(latex, plain)
            value = value.replace("{", "").replace("}", "")
        return str(value)
    found = value if isinstance(value, Q) else of_pint(value)
    if found is None:
        raise TypeError(_expected(value, name, example))
    if isinstance(found.value, tuple):
        raise TypeError(f"{name} is one quantity such as {example!r}, not {len(found)}; antrieb.sweep takes several")
    if not math.isfinite(found.value):
        raise fault(f"{name} is not finite: {found.value!r}", f'write {name.rsplit(".", 1)[-1]}="{example}"')
    return found.texts[0]


def _expected(value: Any, name: str, example: str) -> str:
    unit = split(example)
    last = name.rsplit(".", 1)[-1]
    if isinstance(value, float):
        # NumPy writes the type of its numbers too.
        value = float(value)
    if unit and isinstance(value, (int, float)) and not isinstance(value, bool):
        written = f'{last}="{value!r} {unit[1]}"'
        return f"{name}: {value!r} has no unit; write {written}, or {last}=antrieb.q({value!r}, \"{unit[1]}\")"
    item = getattr(value, "item", None)
    if unit and item is not None and getattr(value, "ndim", 0) == 0:
        return _expected(item(), name, example)
    return f'{name} is a quantity with its unit, such as {last}="{example}", not {type(value).__name__}'


def columns_of(value: Any, name: str) -> Q | None:
    """Returns an array with a unit, or texts of quantities in one unit, as numbers with their unit; else `None`."""
    found = value if isinstance(value, Q) else of_pint(value)
    if found is not None:
        return found
    texts: Sequence[Any] = [value] if isinstance(value, str) else list(value)
    parts = [split(each) for each in texts if isinstance(each, str)]
    known = [part for part in parts if part is not None]
    if not texts or len(known) != len(texts):
        return None
    units = sorted({unit for _, unit in known})
    if len(units) > 1:
        raise fault(f"{name}: its texts are in {' and '.join(units)}", "write all of them in one unit")
    return Q(tuple(float(number) for number, _ in known), known[0][1])
