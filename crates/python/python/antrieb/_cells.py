"""Cells of Arrow as values of Python's standard library; the native part calls these functions."""

from __future__ import annotations

import datetime
import decimal
import zoneinfo

DAY = datetime.date(1970, 1, 1)
INSTANT = datetime.datetime(1970, 1, 1)


def day(days: int) -> datetime.date:
    """The date of a number of days since 1970."""
    return DAY + datetime.timedelta(days=days)


def _span(ticks: int, per_second: int) -> tuple[datetime.timedelta, int]:
    """An interval to the microsecond, and the nanoseconds below it, which no type of Python has."""
    nanoseconds = ticks * (1_000_000_000 // per_second)
    return datetime.timedelta(microseconds=nanoseconds // 1000), nanoseconds % 1000


def duration(ticks: int, per_second: int) -> datetime.timedelta | str:
    """An interval; one with nanoseconds as a text."""
    whole, rest = _span(ticks, per_second)
    return whole if not rest else f"{ticks} ns"


def time(ticks: int, per_second: int) -> datetime.time | str:
    """A time of the day; one with nanoseconds as a text."""
    whole, rest = _span(ticks, per_second)
    found = (INSTANT + whole).time()
    return found if not rest else f"{found.isoformat('microseconds')}{rest:03}"


def instant(ticks: int, per_second: int, zone: str | None) -> datetime.datetime | str:
    """An instant in its time zone; one with nanoseconds as a text."""
    whole, rest = _span(ticks, per_second)
    found = INSTANT + whole
    if zone is not None:
        found = found.replace(tzinfo=datetime.UTC).astimezone(_zone(zone))
    if not rest:
        return found
    plain = found.replace(tzinfo=None).isoformat(timespec="microseconds")
    offset = found.isoformat()[len(found.replace(tzinfo=None).isoformat()) :]
    return f"{plain}{rest:03}{offset}"


def _zone(name: str) -> datetime.tzinfo:
    """A time zone by its name or its offset."""
    if name[:1] in "+-" and len(name) >= 3:
        hours, _, minutes = name[1:].partition(":") if ":" in name else (name[1:3], "", name[3:])
        offset = datetime.timedelta(hours=int(hours), minutes=int(minutes or 0))
        return datetime.timezone(-offset if name[0] == "-" else offset)
    try:
        return datetime.UTC if name in ("UTC", "Z") else zoneinfo.ZoneInfo(name)
    except (zoneinfo.ZoneInfoNotFoundError, ValueError):
        # Without a database of time zones the instant stays the same one.
        return datetime.UTC


def decimal_of(text: str) -> decimal.Decimal:
    """A decimal number with all its digits."""
    return decimal.Decimal(text)
