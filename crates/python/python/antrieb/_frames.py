"""Tables of answers for data frames, notebooks and the terminal."""

from __future__ import annotations

import math
from html import escape
from types import NoneType
from typing import Any

from antrieb._antrieb import Table
from antrieb._lines import Grid
from antrieb._record import _library, place_of  # pyright: ignore[reportPrivateUsage]
from antrieb._tables import arrow_library

ROWS = 12
COLUMNS = 9


def to_pandas(table: Table) -> Any:
    """The table as a data frame of pandas."""
    pandas = _library("pandas", "to_pandas")
    columns = table.to_pydict()
    library: Any = arrow_library()
    typed: dict[str, Any] = {}
    if getattr(library, "__name__", "") == "pyarrow":
        typed = dict(zip(table.column_names, library.table(table).columns, strict=True))
    found: dict[str, Any] = {}
    for heading, values in columns.items():
        kind: Any = typed[heading].type if heading in typed else None
        known = [value for value in values if value is not None]
        if {type(value) for value in known} == {int}:
            # A whole number stays one beside empty cells.
            name = "uint64" if max(known) >= 1 << 63 else "int64"
            if kind is not None and library.types.is_integer(kind):
                name = str(kind)
            if None in values:
                found[heading] = pandas.array(values, dtype=name.replace("int", "Int").replace("uI", "UI"))
            else:
                found[heading] = _library("numpy", "to_pandas").array(values, dtype=name)
        elif kind is not None and (library.types.is_temporal(kind) or library.types.is_dictionary(kind)):
            found[heading] = typed[heading].to_pandas()
        else:
            found[heading] = values
    return pandas.DataFrame(found, columns=table.column_names)


def to_polars(table: Table) -> Any:
    """The table as a data frame of polars."""
    return _library("polars", "to_polars").DataFrame(table)


def to_dicts(table: Table) -> list[dict[str, Any]]:
    """A dictionary for each row."""
    return _dicts(table.to_pydict())


def _dicts(columns: dict[str, list[Any]]) -> list[dict[str, Any]]:
    return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]


def item(table: Table, key: Any) -> Any:
    """A column by its heading, a row by its place."""
    if isinstance(key, str):
        column = table.column(key)
        if column is None:
            raise KeyError(f"no column is called {key!r}; there are {', '.join(table.column_names)}")
        return column
    if isinstance(key, slice):
        chosen = range(len(table))[key]
        least = min(chosen, default=0)
        rows = _dicts(table.rows(least, max(chosen, default=-1) + 1 - least))
        return [rows[at - least] for at in chosen]
    at = place_of(key, "a column by its heading, a row by its number, or rows as table[0:2]")
    count = len(table)
    if not -count <= at < count:
        raise IndexError(f"there are {count} rows, not {at}")
    return {heading: values[0] for heading, values in table.rows(at % count, 1).items()}


ANSWERED = frozenset(
    {"row", "fit", "fit_if_estimate", "code", "utilisation", "tightest", "error", "verdict", "fits", "errata", "mass [kg]", "length [mm]", "stage_ratio"}
)
"""Columns of the answers of a sweep; the others are repeated from its table."""


def arrays(table: Table, value: str, x: str | None, y: str | None) -> Grid:
    """The values of a column over two columns of the table that was swept.

    Raises:
        KeyError: There is no such column.
        TypeError: More or fewer than two columns vary, or a pair of values has several rows.
    """
    columns = table.to_pydict()
    for name in (value, x, y):
        if name is not None and name not in columns:
            raise KeyError(f"no column is called {name!r}; there are {', '.join(columns)}")
    own = [name for name in columns if name not in ANSWERED and not name.endswith((".verdict", ".utilisation"))]
    varied = [name for name in own if len(set(map(_distinct, columns[name]))) > 1 and name not in (x, y, value)]
    names = [name for name in (x, y) if name is not None]
    if len(names) + len(varied) < 2 or (len(varied) + len(names) > 2 and len(names) < 2):
        there = f"there are {', '.join(own)}" if own else "the sweep repeats them with grid=True or inputs=True"
        raise TypeError(f"arrays: two columns whose values vary are wanted, x='…' and y='…'; {there}")
    rest = iter(varied)
    x = next(rest) if x is None else x
    y = next(rest) if y is None else y
    for name in (x, y):
        if any(type(value) in (list, dict) for value in columns[name]):
            raise TypeError(f"arrays: column {name!r} holds lists or structures, which are no axis of a picture")
    xs, ys = ([*dict.fromkeys(columns[name])] for name in (x, y))
    places = {pair: at for at, pair in enumerate(zip(columns[x], columns[y], strict=True))}
    if len(places) < len(table):
        raise TypeError(f"arrays: a pair of {x} and {y} has several rows; filter the table, or sweep without check and front")
    absent = math.nan if all(isinstance(each, (int, float, NoneType)) for each in columns[value]) else None

    def cell(pair: tuple[Any, Any]) -> Any:
        at = places.get(pair)
        found = None if at is None else columns[value][at]
        return absent if found is None else found

    return Grid(name=value, x=xs, y=ys, z=[[cell((one, other)) for one in xs] for other in ys], x_label=x, y_label=y, z_label=value)


def _distinct(value: Any) -> Any:
    """A value that can be compared with others: lists and structures by their text."""
    return repr(value) if type(value) in (list, dict) else value


def _shown(table: Table) -> tuple[list[str], list[list[str]]]:
    from antrieb._shown import number

    head = table.column_names[:COLUMNS]
    columns = table.rows(0, ROWS)
    rows = [[_cell(columns[heading][at], number) for heading in head] for at in range(min(ROWS, len(table)))]
    return head + (["…"] if len(table.column_names) > COLUMNS else []), [
        row + (["…"] if len(table.column_names) > COLUMNS else []) for row in rows
    ]


def _cell(value: Any, number: Any) -> str:
    text = "" if value is None else number(value, "en") if isinstance(value, float) else str(value)
    return text if len(text) <= 40 else text[:39] + "…"


def text(table: Table) -> str:
    """The first rows in at most 20 lines."""
    from antrieb import _shown as shown

    title = f"Table of {len(table)} rows, {len(table.column_names)} columns"
    if not table.column_names:
        return title
    head, rows = _shown(table)
    lines = [title, *shown.table(head, rows, [False] * len(head))]
    if len(table) > ROWS:
        lines.append(f"… {len(table) - ROWS}")
    return "\n".join(lines)


def html(table: Table) -> str:
    """The first rows in a notebook."""
    head, rows = _shown(table)

    def of(tag: str, row: list[str]) -> str:
        return "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in row)

    body = "".join(f"<tr>{of('td', row)}</tr>" for row in rows)
    return (
        f'<div class="antrieb"><p>{len(table)} × {len(table.column_names)}</p><table><thead><tr>{of("th", head)}</tr></thead>'
        f"<tbody>{body}</tbody></table></div>"
    )
