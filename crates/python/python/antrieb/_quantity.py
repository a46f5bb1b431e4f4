"""Quantities: a text with its unit, a number or an array with a stated unit, a quantity of pint."""

# Values of other libraries and of files have no types until they are looked at; the classes of one package share what is private.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportPrivateUsage=false

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from html import escape
from typing import Any, Protocol

from antrieb._called import called
from antrieb._fault import fault
from antrieb._plain import is_scalar, is_time, listed, number_of, ordered, refuse_times, seconds, text


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
        object.__setattr__(self, "value", tuple(map(_exact, value)) if isinstance(value, tuple) else _exact(value))
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

    def _repr_html_(self) -> str:
        first = ", ".join(map(_number, self.values[:SHOWN]))
        more = f", … ({len(self)})" if len(self) > SHOWN else ""
        return f"<span>{escape(f'{first}{more} {self.unit}'.rstrip())}</span>"

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

_UNITS = {
    "turn": "rev",
    "revolutions_per_minute": "rpm",
    "°": "deg",
    "g_0": "g",
    "A*min": "A/(1/min)",
}
"""Units as pint writes them, where a project file writes them otherwise."""

_DIFFERENCES = ("Δ°C", "delta_degC", "Δ°F", "delta_degF")
"""Units of differences of temperatures, as pint writes them."""

_WORDS = {
    "kilogram": "kg",
    "arcminute": "arcmin",
    "arcsecond": "arcsec",
    "degree_Celsius": "degC",
    "kelvin": "K",
    "revolutions_per_minute": "rpm",
    "turn": "rev",
    "gram": "g",
    "pound": "lb",
    "force_pound": "lbf",
    "standard_gravity": "g",
    "radian": "rad",
    "degree": "deg",
    "second": "s",
    "minute": "min",
    "hour": "h",
    "meter": "m",
    "millimeter": "mm",
}
_PREFIXES = {"": "", "milli": "m", "micro": "u", "kilo": "k", "mega": "M"}
_SYMBOLS = {"ampere": "A", "volt": "V", "ohm": "ohm", "watt": "W", "joule": "J", "hertz": "Hz", "henry": "H", "newton": "N"}
_WORDS.update({prefix + word: short + sign for word, sign in _SYMBOLS.items() for prefix, short in _PREFIXES.items()})
_WORD = re.compile(r"[A-Za-z_]{3,}")


@called
def q(value: Any, unit: Any) -> Q:
    """Returns a number or an array with its unit: `q(30, "kg")`, `q(np.linspace(0, 10, 50), "kg")`.

    Args:
        value: A number, or an array, a series or a list of numbers.
        unit: Their unit as a project file has it (`kg m^2`, `1/min`; `antrieb units` lists them all), or a unit of pint;
            `""` for ratios.

    Raises:
        TypeError: It is no number. Intervals of time (`timedelta64`, `Duration`) become numbers in a unit of time, and are
            refused with any other.
    """
    if isinstance(value, Q) or (hasattr(value, "magnitude") and hasattr(value, "units")):
        raise TypeError("value: the quantity has a unit already; hand it over as it is")
    own = unit_of(unit)
    if is_time(value):
        found = seconds(value, "value", unit=unit_of_time(own, "value"))
        return Q(tuple(found) if _is_several(value) else found[0], own)
    return Q(_numbers(value, "value"), own)


def _is_several(value: Any) -> bool:
    """Returns true for an array, a series or a list; times of one instant have no length."""
    return hasattr(value, "__len__") and getattr(value, "ndim", 1) > 0


def unit_of_time(unit: str, name: str) -> Fraction:
    """How many seconds a unit is.

    Raises:
        TypeError: It is none of time.
    """
    found = _seconds_of(unit)
    if found is not None:
        return found
    raise TypeError(f"{name}: times have a unit of time, not {unit!r}; write \"s\", or hand over numbers")


def unit_of(unit: Any, name: str = "unit") -> str:
    """Returns a unit as a project file has it."""
    if isinstance(unit, str):
        return text(unit, name).strip()
    if hasattr(unit, "dimensionality"):
        return _of_pint(unit)
    raise TypeError(f'{name} is a text such as "kg", not {type(unit).__name__}')


def _seconds_of(unit: str) -> Fraction | None:
    """How many seconds a unit is; `None` for one of another quantity."""
    from antrieb._trace import units_of

    found = (Fraction(repr(each.si)) for each in units_of("time") if unit in (each.unit, each.symbol, each.json, *each.also))
    return next(found, None)


def _numbers(value: Any, name: str) -> float | tuple[float, ...]:
    """A number, or those of an array of one dimension."""
    if isinstance(value, (str, bytes)) or value is None or isinstance(value, bool):
        raise TypeError(f"{name}: numbers are expected, not {type(value).__name__}")
    ordered(value, name)
    if isinstance(value, Mapping) or hasattr(value, "columns") or hasattr(value, "column_names"):
        # Their iteration yields headings, which may be numbers.
        raise TypeError(f"{name}: numbers are expected, not a table ({type(value).__name__}); hand over one column, such as table['mass']")
    refuse_times(value, name)
    # Of a masked array; that of a series is a method.
    mask = getattr(value, "mask", None)
    if mask is not None and not callable(mask) and bool(getattr(mask, "any", lambda: mask)()):
        raise TypeError(f"{name}: the array has masked values")
    if hasattr(value, "tolist"):
        value = value.tolist()
    elif hasattr(value, "to_list"):
        value = value.to_list()
    elif hasattr(value, "to_pylist"):
        value = value.to_pylist()
    if hasattr(value, "__iter__"):
        return tuple(_one(each, name) for each in listed(value, name))
    return _one(value, name)


def _one(value: Any, name: str) -> float:
    if isinstance(value, (list, tuple)) or getattr(value, "ndim", 0) > 0:
        raise TypeError(f"{name}: an array of one dimension is expected; axes_from_arrays takes one of two with its unit apart, position_unit='deg'")
    return number_of(value, name)


def _exact(value: float) -> float:
    """A number as one of Python: those of NumPy write their type too."""
    return value if type(value) in (int, float) else number_of(value, "q")


def _number(value: float) -> str:
    return repr(value)


def _of_pint(unit: Any, name: str = "q") -> str:
    """Returns a unit of pint as a project file has it: a product of names with an explicit sign.

    Raises:
        AntriebError: It is that of a difference of temperatures.
    """
    written = format(unit, "~C").replace(" ", "")
    if written in _DIFFERENCES:
        # In kelvin it would be another temperature.
        raise fault(f"{name}: {written} is a difference of temperatures", 'write a temperature, such as "30 degC"')
    if written in _UNITS:
        return _UNITS[written]
    if written == "dimensionless":
        return ""
    parts = re.split(r"([*/]+|\(|\)|[0-9.-]+)", written)
    return "".join("K" if part in _DIFFERENCES else _UNITS.get(part, "^" if part == "**" else part) for part in parts)


def of_pint(value: Any, name: str = "q") -> Q | None:
    """Returns a quantity of pint as numbers with their unit; `None` for anything else."""
    if isinstance(value, Q) or not (hasattr(value, "magnitude") and hasattr(value, "units")):
        return None
    _counted(value, name)
    _turning(value, name)
    unit, numbers = _of_pint(value.units, name), _numbers(value.magnitude, name)
    if unit == "g" and "gram" in format(value.units, "C"):
        # As an acceleration the sign would be that of gravity.
        return Q(tuple(map(_thousandth, numbers)) if isinstance(numbers, tuple) else _thousandth(numbers), "kg")
    return Q(numbers, unit)


def _counted(value: Any, name: str) -> None:
    """Refuses a product with a unit of counting: pint takes 2 count·kg for 2 kg.

    Raises:
        AntriebError: It is one.
    """
    parts = re.findall(r"[A-Za-z_%]+", format(value.units, "C"))
    found = [part for part in parts if part in _COUNTS]
    if found and len(parts) > 1:
        raise fault(f"{name}: {value.units} has the unit {found[0]}, which is none of a project", "write it without")


def _turning(value: Any, name: str) -> None:
    """Refuses a rate per minute without an angle: to pint 1/min is a radian per minute, in a project file a revolution.

    Raises:
        AntriebError: It is one, alone or below a current, a voltage or a torque.
    """
    written = format(value.units, "C").replace(" ", "")
    is_rate = written == "1/minute" or ("minute" in written and "/minute" not in written and re.search(r"ampere|volt|newton", written))
    if is_rate and not _ANGLES.search(written):
        raise fault(
            f"{name}: {value.units} has no angle: to pint it is per radian, in a project file per revolution, a factor of 2 pi",
            "write the angle, as in ureg.rpm or ureg.radian/ureg.second, or the quantity as a text",
        )


_COUNTS = ("count", "percent", "ppm", "permille", "dimensionless", "bit", "byte", "particle", "mole")
_RATIOS = ("", "dimensionless", "count", "percent", "%", "ppm", "permille")


def _thousandth(number: float) -> float:
    return float(Decimal(repr(number)) / 1000) if math.isfinite(number) else number


class Converted(str):
    """A quantity of pint in its own unit, and in that of the example if no project file has its own."""

    __slots__ = ("other",)

    other: str


_OF_PINT = {"g": "g_0", "1/min": "rpm", "V/1000 1/min": "V/rpm", "A/(1/min)": "A/rpm"}
"""Units of examples as pint reads them."""

_ANGLES = re.compile(r"radian|degree|turn|revolution|arc|rpm")


def _converted(value: Any, found: Q, name: str, examples: Sequence[str]) -> str:
    """Returns a quantity of pint as a text.

    Raises:
        AntriebError: It measures something else.
    """
    text = Converted(found.texts[0])
    text.other = str(text)
    registry = getattr(value, "_REGISTRY", None)
    if registry is None or not hasattr(value, "is_compatible_with"):
        return text
    for example in examples:
        known = example.split(" ", 1)[1]
        try:
            of = registry.parse_units(_OF_PINT.get(known, known).replace(" ", "*"))
            fits = value.is_compatible_with(of)
        except Exception:
            # A registry of the user that lacks the unit.
            return text
        if fits and known != "%" and format(value.units, "C").replace(" ", "") in _RATIOS:
            # To pint an angle is a ratio.
            continue
        if fits and "1/min" in known and not _ANGLES.search(format(value.units, "C")):
            # 1/s of pint may mean revolutions or radians; only what a project file reads is taken.
            return text
        if fits:
            number = float(value.to(of).magnitude)
            text.other = f"{_number(number * 1000 if known.startswith('V/1000') else number)} {known}"
            return text
    raise fault(f"{name}: {text} does not have a unit as {' or '.join(examples)} has", f'write {name.rsplit(".", 1)[-1]}="{examples[0]}"')


_PLAIN = re.compile(r"\s*([+\-−]?(?:\d+\.?\d*|\.\d+)(?:[eE][+\-−]?\d+)?)\s*(.*?)\s*", re.DOTALL)
_LATEX = (
    (r"\\mathrm\{([^{}]*)\}", r"\1"),
    (r"\^\{([^{}]*)\}", r"^\1"),
    (r"\\cdot", "*"),
    (r"\\_", "_"),
    (r"\\[ ,;]|~", " "),
    (r"\\[\[\]]|\$", ""),
)
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_EXPONENT = re.compile(r"(?<=\d) *(?:×|\\times) *10 *(?:\^\{([+-]?\d+)\}|<sup>([+-]?\d+)</sup>|([⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+))")
_SIUNITX = re.compile(r"\\(?:SI|qty)(?:\[[^\]]*\])?\{([^{}]*)\}\{((?:[^{}]|\{[^{}]*\})*)\}")
_MACRO = re.compile(r"\\([A-Za-z_]+)(?:\{([^{}]*)\})?")
_POWERS = {"square": 2, "cubic": 3, "squared": 2, "cubed": 3}
_PREFIX_WORDS = ("quecto", "pico", "nano", "micro", "milli", "centi", "deci", "deca", "hecto", "kilo", "mega", "giga", "tera")
_FRACTION = re.compile(r"\\frac\{([^{}]*)\}\{([^{}]*)\}")
_HTML = re.compile(r"<sup>([^<]*)</sup>")


def _plain(text: str) -> str:
    """Returns a text that pint wrote, in any of its formats, as a project file has it."""
    text = _EXPONENT.sub(lambda found: "e" + str(found[1] or found[2] or found[3]).translate(_SUPERSCRIPTS), text)
    if written := _SIUNITX.fullmatch(text.strip()):
        text = f"{written[1]} {_of_siunitx(written[2])}"
    if "\\" in text:
        for latex, plain in _LATEX:
            text = re.sub(latex, plain, text)
        text = _FRACTION.sub(lambda found: f"{found[1]}/{found[2].replace('*', '/')}", text)
    text = _HTML.sub(r"^\1", text)
    found = _PLAIN.fullmatch(text)
    if found is None:
        return text
    unit = _WORD.sub(lambda word: _WORDS.get(word[0], word[0]), found[2])
    unit = "1/" + unit.removeprefix("/").lstrip() if unit.startswith("/") else unit
    if re.fullmatch(r"A[ *·]+min", unit):
        unit = "A/(1/min)"
    return text if unit == found[2] else f"{found[1]} {unit}"


def _of_siunitx(macros: str) -> str:
    """Returns the unit of macros of siunitx: `\\kilo\\gram\\meter\\squared` is `kg m^2`."""
    above: list[str] = []
    below: list[str] = []
    prefix, is_below, power, last_is_below = "", False, 0, False
    for macro, inside in _MACRO.findall(macros):
        if macro == "per":
            is_below = True
        elif macro in ("square", "cubic"):
            power = _POWERS[macro]
        elif macro in _PREFIX_WORDS:
            prefix = macro
        elif macro in _POWERS or macro == "tothe":
            side = below if last_is_below else above
            side[-1:] = [f"{each}^{inside or _POWERS[macro]}" for each in side[-1:]]
        else:
            word = str(_WORDS.get(prefix + macro) or prefix + macro)
            (below if is_below else above).append(word + (f"^{power}" if power else ""))
            last_is_below, prefix, is_below, power = is_below, "", False, 0
    return "/".join([" ".join(above) or "1", *below]) if below else " ".join(above)


def split(text: str) -> tuple[Decimal, str] | None:
    """Returns number and unit of a text; `None` for a text that is no plain quantity."""
    found = _PLAIN.fullmatch(text)
    if not found or "±" in text or "+/-" in text:
        return None
    return Decimal(found[1].replace("−", "-")), found[2]


def text_of(value: Any, name: str, example: str, other: str | None = "") -> str:
    """Returns a quantity as a project file has it; `other` is an example of the second quantity that is permitted, `None` if any is.

    Raises:
        TypeError: It is none, or several; the message names the argument and what to write.
        AntriebError: It is not finite, or measures something else.
    """
    if isinstance(value, str):
        return _plain(text(value, name))
    if is_time(value):
        last = name.rsplit(".", 1)[-1]
        known = split(example)
        if known is None or _seconds_of(known[1]) is None:
            raise TypeError(f'{name}: a time ({type(value).__name__}) is given; write {last}="{example}"')
        if _is_several(value):
            raise TypeError(f"{name} is one time such as {example!r}; antrieb.sweep takes several")
        return f"{_number(seconds(value, name)[0])} s"
    found = value if isinstance(value, Q) else of_pint(value, name)
    if found is None:
        raise TypeError(_expected(value, name, example))
    if isinstance(found.value, tuple):
        raise TypeError(f"{name} is one quantity such as {example!r}, not {len(found)}; antrieb.sweep takes several")
    if not math.isfinite(found.value):
        raise fault(f"{name} is not finite: {found.value!r}", f'write {name.rsplit(".", 1)[-1]}="{example}"')
    if isinstance(value, Q) or other is None:
        return found.texts[0]
    return _converted(value, found, name, [each for each in (example, other) if each])


def _expected(value: Any, name: str, example: str) -> str:
    unit = split(example)
    last = name.rsplit(".", 1)[-1]
    if type(value).__name__ == "MaskedConstant":
        return f"{name} is masked: it has no value"
    if isinstance(value, float):
        # NumPy writes the type of its numbers too.
        value = float(value)
    if unit and isinstance(value, (int, float)) and not isinstance(value, bool):
        other = _other_unit(unit[1])
        if other is not None:
            # One of them alone would be copied, and be wrong by their factor.
            either = " or ".join(f'{last}="{value!r} {each}"' for each in (unit[1], other))
            return f"{name}: {value!r} has no unit; write {either}, whichever it is in, or {last}=antrieb.q({value!r}, unit)"
        written = f'{last}="{value!r} {unit[1]}"'
        return f"{name}: {value!r} has no unit; write {written}, or {last}=antrieb.q({value!r}, \"{unit[1]}\")"
    item = getattr(value, "item", None)
    if unit and item is not None and is_scalar(value) and not isinstance(item(), type(value)):
        return _expected(item(), name, example)
    return f'{name} is a quantity with its unit, such as {last}="{example}", not {type(value).__name__}'


def _other_unit(unit: str) -> str | None:
    """The unit of SI that measures the same, where it is another."""
    from antrieb._trace import quantities

    for each in quantities():
        if any(unit in (one.unit, one.symbol, one.json, *one.also) for one in each.units):
            own = next((one.unit for one in each.units if each.si_unit in (one.unit, one.symbol, one.json)), each.si_unit)
            return None if own == unit else str(own)
    return None


def columns_of(value: Any, name: str) -> Q | None:
    """Returns an array with a unit, or texts of quantities in one unit, as numbers with their unit; else `None`."""
    found = value if isinstance(value, Q) else of_pint(value, name)
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
