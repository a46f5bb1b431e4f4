"""Tables of answers for data frames, notebooks and the terminal."""

from __future__ import annotations

from html import escape
from typing import Any

from antrieb._antrieb import Table
from antrieb._record import _library  # pyright: ignore[reportPrivateUsage]

ROWS = 12
COLUMNS = 9


def to_pandas(table: Table) -> Any:
    """The table as a data frame of pandas."""
    pandas = _library("pandas", "to_pandas")
    return pandas.DataFrame(table.to_pydict(), columns=table.column_names)


def to_polars(table: Table) -> Any:
    """The table as a data frame of polars."""
    return _library("polars", "to_polars").DataFrame(table)


def to_dicts(table: Table) -> list[dict[str, Any]]:
    """A dictionary for each row."""
    columns = table.to_pydict()
    return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]


def item(table: Table, key: Any) -> Any:
    """A column by its heading, a row by its place."""
    if isinstance(key, str):
        columns = table.to_pydict()
        if key not in columns:
            raise KeyError(f"no column is called {key!r}; there are {', '.join(columns)}")
        return columns[key]
    at = key.__index__()
    count = len(table)
    if not -count <= at < count:
        raise IndexError(f"there are {count} rows, not {at}")
    return {heading: values[at] for heading, values in table.to_pydict().items()}


def _shown(table: Table) -> tuple[list[str], list[list[str]]]:
    from antrieb._shown import number

    head = table.column_names[:COLUMNS]
    columns = table.first(ROWS)
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
