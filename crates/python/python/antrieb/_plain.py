"""Values of other libraries as plain ones of Python: times with their unit, numbers, texts, columns with their labels."""

# Values of other libraries have no types until they are looked at.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false

from __future__ import annotations

import datetime
import math
import operator
import re
from collections.abc import Mapping, Set
from fractions import Fraction
from typing import Any

from antrieb._fault import fault

CURE = "a number of seconds, such as series.dt.total_seconds(), or the array in the unit that is meant"
"""What is written in place of times."""

_NO_TIMES = frozenset({int, float, str, bool, bytes, dict, type(None)})

_TICKS = {"W": Fraction(604800), "D": Fraction(86400), "h": Fraction(3600), "m": Fraction(60), "s": Fraction(1)}
_TICKS.update({sign + "s": Fraction(1, 1000**power) for power, sign in enumerate(("m", "u", "n", "p", "f", "a"), 1)})
_TICKS.update({"μs": _TICKS["us"], "µs": _TICKS["us"]})


def is_time(value: Any) -> bool:
    """Returns true for times, dates and intervals of any library: one, an array, a series, or a list of them."""
    if type(value) in _NO_TIMES:
        return False
    if isinstance(value, (datetime.date, datetime.time, datetime.timedelta)):
        return True
    if isinstance(value, (list, tuple)) and {type(each) for each in value} <= _NO_TIMES:
        return False
    kind = getattr(value, "dtype", None)
    if kind is not None and getattr(kind, "kind", "") in ("m", "M"):
        return True
    written = str(kind if kind is not None else getattr(value, "type", ""))
    if re.match(r"(Duration|Datetime|Date|Time)\b|(duration|timestamp|time32|time64)\[|date(32|64)\b|period\[", written):
        return True
    if isinstance(value, (list, tuple)) or (kind is not None and getattr(kind, "kind", "") == "O" and hasattr(value, "__len__")):
        return any(is_time(each) for each in value) if len(value) else False
    return False


def refuse_times(value: Any, name: str, cure: str = CURE) -> None:
    """Refuses times where a number is expected.

    Raises:
        TypeError: It is a time, an interval, or an array of them.
    """
    if is_time(value):
        raise TypeError(f"{name} holds times ({_type_of(value)}), where numbers are expected; hand over {cure}")


def _type_of(value: Any) -> str:
    kind = getattr(value, "dtype", None) or getattr(value, "type", None)
    return str(kind) if kind is not None and str(kind) != "object" else type(value).__name__


def seconds(value: Any, name: str, instants: bool = False, unit: Fraction = Fraction(1)) -> list[float]:
    """Returns intervals in seconds, or in a unit of so many, each correctly rounded; instants, where they are permitted, since
    the first of them.

    Raises:
        TypeError: It holds no times, times of several kinds, or a unit without a length, such as a month.
        AntriebError: One is empty.
    """
    kinds: set[str] = set()
    found: list[Fraction] = []
    for place, (kind, each) in enumerate(_each(value, name)):
        if each is None:
            raise fault(f"{name}, row {place}, is empty", "leave out the rows without a time")
        kinds.add(kind)
        found.append(each)
    if len(kinds) > 1:
        raise TypeError(f"{name} mixes {' and '.join(sorted(kinds))}; hand over one of them")
    if kinds == {"instants"}:
        if not instants:
            raise TypeError(f"{name} holds instants, where intervals are expected; subtract the first: times - times[0]")
        found = [each - found[0] for each in found]
    return [float(each / unit) for each in found]


def _each(value: Any, name: str) -> list[tuple[str, Fraction | None]]:
    """Each time as an exact number of seconds, and whether it is an interval or an instant."""
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        raise TypeError(f"{name} holds times with a second unit, {value.units}; hand over its magnitude, or numbers")
    module = type(value).__module__.partition(".")[0]
    if module == "polars":
        kind = str(value.dtype)
        unit = found[1] if (found := re.search(r"time_unit='(\w+)'", kind)) else None
        if unit is None:
            return [_one(each, name) for each in value.to_list()]
        own = "intervals" if kind.startswith("Duration") else "instants"
        return [(own, None if each is None else each * _TICKS[unit]) for each in value.to_physical().to_list()]
    if module == "pyarrow":
        found = re.match(r"(duration|timestamp)\[(\w+)", str(value.type))
        if found is None:
            return [_one(each, name) for each in (value.to_pylist() if hasattr(value, "to_pylist") else [value.as_py()])]
        own = "intervals" if found[1] == "duration" else "instants"
        listed = value.cast("int64")
        listed = listed.to_pylist() if hasattr(listed, "to_pylist") else [listed.as_py()]
        return [(own, None if each is None else each * _TICKS[found[2]]) for each in listed]
    if module == "pandas" and hasattr(value, "dtype"):
        if getattr(value.dtype, "tz", None) is not None or str(value.dtype).startswith("timestamp"):
            value = value.dt.tz_convert("UTC").dt.tz_localize(None) if hasattr(value, "dt") and getattr(value.dt, "tz", None) is not None else value
            value = value.tz_convert("UTC").tz_localize(None) if hasattr(value, "tz_convert") and getattr(value, "tz", None) is not None else value
        value = value.to_numpy()
    dtype: Any = getattr(value, "dtype", None)
    if dtype is not None and getattr(dtype, "kind", "") in ("m", "M"):
        if getattr(value, "ndim", 0) > 1:
            if value.ndim > 2 or 1 not in value.shape:
                raise TypeError(f"{name}: an array of one dimension is expected")
            value = value.reshape(-1)
        own = "intervals" if dtype.kind == "m" else "instants"
        tick = _tick(str(dtype), name)
        # NaT is the smallest whole number.
        listed = value.astype("int64").tolist()
        return [(own, None if each == -(1 << 63) else each * tick) for each in (listed if isinstance(listed, list) else [listed])]
    if isinstance(value, (list, tuple)) or (dtype is not None and hasattr(value, "tolist")):
        return [_one(each, name) for each in value]
    return [_one(value, name)]


def _tick(kind: str, name: str) -> Fraction:
    found = re.search(r"\[(\d*)(\w+)\]", kind)
    if found is None or found[2] not in _TICKS:
        unit = "no unit" if found is None or found[2] == "generic" else f"the unit {found[2]!r}, which has no fixed length"
        raise TypeError(f"{name} has times in {unit}; hand over {CURE}")
    return int(found[1] or 1) * _TICKS[found[2]]


def _one(value: Any, name: str) -> tuple[str, Fraction | None]:
    """One time as an exact number of seconds."""
    if value is None or type(value).__name__ in ("NaTType", "NAType", "MaskedConstant"):
        return "intervals", None
    if hasattr(value, "asm8"):
        # Those of pandas are more exact than what they come from.
        own = value.tz_convert("UTC").tz_localize(None) if getattr(value, "tzinfo", None) is not None else value
        value = own.asm8
    if getattr(getattr(value, "dtype", None), "kind", "") in ("m", "M"):
        return _each(value, name)[0]
    if isinstance(value, datetime.timedelta):
        return "intervals", Fraction(value // datetime.timedelta(microseconds=1), 1_000_000)
    if isinstance(value, datetime.datetime):
        beginning = datetime.datetime(1970, 1, 1, tzinfo=None if value.tzinfo is None else datetime.UTC)
        return "instants", Fraction((value - beginning) // datetime.timedelta(microseconds=1), 1_000_000)
    raise TypeError(f"{name}: a time is expected, not {type(value).__name__}; hand over {CURE}")


def is_scalar(value: Any) -> bool:
    """Returns true for a single value of another library; a container of one value is none."""
    return hasattr(value, "item") and getattr(value, "ndim", 1 if hasattr(value, "__len__") else 0) == 0


def number_of(value: Any, name: str) -> float:
    """Returns a number of any library as an `int` or a `float` of Python.

    Raises:
        TypeError: It is none; times, truth values and complex numbers are none.
        AntriebError: It is too large.
    """
    if type(value) is float:
        return value
    refuse_times(value, name)
    if type(value).__name__ == "MaskedConstant":
        raise TypeError(f"{name} is masked: it has no value")
    if is_scalar(value):
        value = value.item()
    elif hasattr(value, "as_py") and not hasattr(value, "__len__"):
        value = value.as_py()
    # A complex long double is none of Python.
    is_complex = getattr(getattr(value, "dtype", None), "kind", "") == "c"
    if is_complex or isinstance(value, (bool, str, bytes, bytearray, complex, type, list, tuple)) or value is None or hasattr(value, "__len__"):
        raise TypeError(f"{name}: a number is expected, not {shown(value)}")
    if isinstance(value, int):
        number: Any = int(value)
    elif hasattr(value, "__float__"):
        return float(value)
    elif hasattr(value, "__index__"):
        number = value.__index__()
    else:
        raise TypeError(f"{name}: a number is expected, not {shown(value)}")
    try:
        float(number)
    except OverflowError:
        raise fault(f"{name}: the number has more digits than any quantity", "numbers reach to 1.8e308") from None
    return number  # type: ignore[no-any-return]


def shown(value: Any) -> str:
    """A value in a message."""
    return f"{value!r:.40}" if isinstance(value, (str, bool, int, float, complex)) or value is None else type(value).__name__


def text(value: str, name: str) -> str:
    """Returns a text as a plain `str`; of a member of an enumeration its value.

    Raises:
        AntriebError: It has half of a character, which no file can hold.
    """
    plain = str.__str__(value)
    try:
        plain.encode()
    except UnicodeEncodeError as error:
        sign = ascii(plain[error.start])[1:-1]
        raise fault(f"{name}: the text has {sign}, which is half of a character", "decode it anew, without surrogates") from None
    return plain


def ordered(value: Any, name: str) -> Any:
    """Returns a collection whose entries have an order.

    Raises:
        TypeError: It is a set, a mapping, or bytes.
    """
    if isinstance(value, Set) and not isinstance(value, Mapping):
        raise TypeError(f"{name} is a {type(value).__name__}, whose entries have no order; hand over a list")
    if isinstance(value, Mapping):
        raise TypeError(f"{name} is a mapping; hand over a list of numbers, such as list(values.values())")
    if isinstance(value, (bytes, bytearray, memoryview)):
        raise TypeError(f"{name}: numbers are expected, not {type(value).__name__}")
    return value


def labels(value: Any, which: str) -> list[Any] | None:
    """Returns the labels of the `columns` or of the `index` of a table; `None` where they only count from zero."""
    own = getattr(value, which, None)
    if own is None or callable(own):
        return None
    if type(own).__name__ == "RangeIndex" and own.start == 0 and own.step == 1:
        return None
    found = list(own)
    return None if not found else found


def aligned(values: Any, first: Any, name: str, other: str) -> Any:
    """Returns a series or a frame with its rows in the order of another one, by their labels.

    Raises:
        AntriebError: The labels are not the same, or one stands twice.
    """
    own, wanted = values.index, first.index
    if own.equals(wanted):
        return values
    if len(own) == len(wanted) and own.is_unique and set(own) == set(wanted):
        return values.loc[wanted]
    raise fault(
        f"{name} and {other} have rows with different labels",
        "give both the same index; values.to_numpy() is taken by place",
    )


LISTED_MOST = 1_000_000
"""Values that an iterator without a length may have."""


def listed(value: Any, name: str) -> list[Any]:
    """Returns the values of an iterable as a list.

    Raises:
        TypeError: It is no iterable with an order.
        AntriebError: It has no length and no end.
    """
    ordered(value, name)
    if not hasattr(value, "__iter__") and not hasattr(value, "__getitem__"):
        raise TypeError(f"{name}: values in an order are expected, such as a list, not {shown(value)}")
    if hasattr(value, "__len__") or operator.length_hint(value):
        return list(value)
    found: list[Any] = []
    for each in value:
        found.append(each)
        if len(found) > LISTED_MOST:
            raise fault(f"{name} is an iterator of more than {LISTED_MOST} values", "hand over a list or an array")
    return found


def is_finite(value: float) -> bool:
    """Returns true for a number that is neither infinite nor none."""
    return math.isfinite(value)
