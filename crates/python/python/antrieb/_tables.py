"""Tables as they come: each becomes one that hands itself over as Arrow."""

from __future__ import annotations

import dataclasses
import datetime
import decimal
from collections.abc import Iterable, Mapping
from typing import Any, cast

from antrieb._antrieb import Table
from antrieb._arrow import ArrowArray, ArrowStream

TableLike = (
    ArrowStream | ArrowArray | Mapping[str, Any] | Iterable[Mapping[str, Any]] | Any
)
"""A table: a dictionary of columns, a list of dictionaries, records or named tuples, a data frame of pandas or polars (lazy
too), a relation of DuckDB, a structured array of NumPy, or anything that hands itself over as Arrow."""

EXAMPLE = "{'load.inertia [kg m^2]': [1.0, 2.0]}"


def arrow(table: Any, name: str = "table") -> ArrowStream | ArrowArray:
    """A table as one of Arrow.

    Raises:
        TypeError: It is no table, or a column of it cannot be read; the message says what to write.
        ValueError: Its columns have different lengths, or two have one name.
    """
    if isinstance(table, Table):
        return table
    if table is None or isinstance(table, (str, bytes, int, float, complex)):
        raise TypeError(f"{name}: a table is expected, such as {EXAMPLE}, not {type(table).__name__}{_path_hint(table)}")
    if isinstance(table, Mapping):
        return of_columns(cast("Any", table), name)
    module = type(table).__module__.partition(".")[0]
    if module == "pandas":
        return _pandas(table, name)
    if module == "polars":
        return _polars(table, name)
    if module in ("duckdb", "_duckdb") and hasattr(table, "fetchall"):
        return _relation(table, name)
    if getattr(getattr(table, "dtype", None), "names", None):
        return _structured(table, name)
    if hasattr(table, "__arrow_c_stream__") or hasattr(table, "__arrow_c_array__"):
        return cast("ArrowStream | ArrowArray", table)
    if hasattr(table, "dtype"):
        raise TypeError(f"{name}: an array has no headings; write {{'load.inertia [kg m^2]': array}}, or use a structured array")
    if isinstance(table, Iterable):
        return _rows(cast("Any", table), name)
    raise TypeError(f"{name}: a table is expected, such as {EXAMPLE}, not {type(table).__name__}")


def _path_hint(table: Any) -> str:
    return "; a file is read by the library of your choice or by the command `antrieb sweep`" if isinstance(table, str) else ""


def of_columns(columns: Mapping[Any, Any], name: str = "table") -> Table:
    """A table of columns by their headings."""
    found: dict[str, list[Any]] = {}
    for heading, values in columns.items():
        if not isinstance(heading, str):
            raise TypeError(f"{name}: a heading is a text such as 'load.inertia [kg m^2]', not {heading!r}")
        found[heading] = _column(values, heading, name)
    lengths = {heading: len(values) for heading, values in found.items()}
    if len(set(lengths.values())) > 1:
        shown = ", ".join(f"{heading!r} has {count}" for heading, count in list(lengths.items())[:6])
        raise ValueError(f"{name}: the columns have different lengths: {shown}")
    return Table.from_pydict(found)


def _column(given: Any, heading: str, name: str) -> list[Any]:
    values: Any = given
    place = f"{name}: column {heading!r}"
    if values is None or isinstance(values, (str, bytes, bool, int, float, Mapping)) or getattr(values, "ndim", 1) == 0:
        raise TypeError(f"{place} is one value ({values!r}); give a list with a value for each row")
    if getattr(values, "ndim", 1) > 1:
        raise TypeError(f"{place} has {values.ndim} dimensions; give one value for each row")
    if not hasattr(values, "__iter__"):
        raise TypeError(f"{place} is {type(values).__name__}; give a list with a value for each row")
    if hasattr(values, "dtype") and getattr(values.dtype, "kind", "") in "mM":
        raise TypeError(f"{place} holds times; give them as texts, or as numbers in a unit")
    convert = getattr(values, "tolist", None) or getattr(values, "to_list", None)
    listed: list[Any] = convert() if convert else list(values)
    plain = [_value(value, place, row) for row, value in enumerate(listed)]
    kinds = {"text" if isinstance(value, str) else "bool" if isinstance(value, bool) else "number" for value in plain if value is not None}
    if len(kinds) > 1:
        raise TypeError(f"{place} mixes {' and '.join(sorted(kinds))}; a column has values of one kind")
    return plain


def _value(value: Any, place: str, row: int) -> Any:
    if value is None or isinstance(value, (float, str, bool)):
        # A number that is none is no value, as in every library of tables.
        return None if isinstance(value, float) and value != value else value
    if isinstance(value, int):
        if abs(value) >= 1 << 63:
            return float(value)
        return value
    kind = type(value).__name__
    if kind in ("NAType", "NaTType", "MaskedConstant"):
        return None
    if isinstance(value, decimal.Decimal):
        return float(value)
    if isinstance(value, (datetime.date, datetime.time, datetime.timedelta)):
        return str(value)
    if hasattr(value, "item") and getattr(value, "ndim", 1) == 0:
        return _value(value.item(), place, row)
    if hasattr(value, "magnitude") or hasattr(value, "unit"):
        raise TypeError(f"{place}, row {row}: a quantity among the cells; give the column as antrieb.q([…], unit), or numbers below a heading with the unit")
    raise TypeError(f"{place}, row {row}: a number, a text or None is expected, not {kind}")


def _rows(rows: Iterable[Any], name: str) -> Table:
    columns: dict[str, list[Any]] = {}
    count = 0
    for number, row in enumerate(rows):
        fields = _fields(row, name, number)
        for heading in fields:
            if heading not in columns:
                columns[heading] = [None] * number
        for heading, values in columns.items():
            values.append(fields.get(heading))
        count += 1
    if count == 0:
        raise ValueError(f"{name}: there is no row, and so no heading")
    return of_columns(columns, name)


def _fields(given: Any, name: str, number: int) -> Mapping[Any, Any]:
    row: Any = given
    if isinstance(given, Mapping):
        return cast("Mapping[Any, Any]", row)
    if dataclasses.is_dataclass(given) and not isinstance(given, type):
        return {each.name: getattr(row, each.name) for each in dataclasses.fields(row)}
    if hasattr(row, "_asdict"):
        return cast("Mapping[Any, Any]", row._asdict())
    names = getattr(getattr(row, "dtype", None), "names", None)
    if names:
        return {heading: row[heading] for heading in names}
    raise TypeError(f"{name}: row {number} is {type(row).__name__}; write each row as a dictionary, {{'load.inertia [kg m^2]': 1.0}}")


def _structured(table: Any, name: str) -> Table:
    if getattr(table, "ndim", 1) != 1:
        raise TypeError(f"{name}: a structured array of {table.ndim} dimensions; take one with a dimension of rows")
    return of_columns({heading: table[heading] for heading in table.dtype.names}, name)


def _pandas(table: Any, name: str) -> ArrowStream | ArrowArray:
    if not hasattr(table, "columns"):
        raise TypeError(f"{name}: a {type(table).__name__} of pandas is one column; take series.to_frame('load.inertia [kg m^2]')")
    if getattr(table.columns, "nlevels", 1) > 1:
        raise TypeError(f"{name}: headings of {table.columns.nlevels} levels; join them to one text")
    headings = list(table.columns)
    _once([*headings], name)
    columns = {heading: table[heading] for heading in headings}
    index = table.index
    if type(index).__name__ != "RangeIndex" or index.name is not None:
        # What the rows are called is carried along.
        own: dict[Any, Any] = {}
        for level in range(index.nlevels):
            title = index.names[level]
            title = title if title is not None else "index" if index.nlevels == 1 else f"index_{level}"
            own[title] = [_label(each) for each in index.get_level_values(level)]
        _once([*own, *headings], name)
        columns = {**own, **columns}
    return of_columns({heading: _series(values) for heading, values in columns.items()}, name)


def _label(value: Any) -> Any:
    return value if value is None or isinstance(value, (str, int, float)) else str(value)


def _series(values: Any) -> Any:
    if not hasattr(values, "dtype"):
        return values
    if getattr(values.dtype, "kind", "") in "mM":
        return [None if text == "NaT" else text for text in values.astype(str).tolist()]
    return values.astype(object).tolist() if type(values.dtype).__name__ == "CategoricalDtype" else values


def _polars(table: Any, name: str) -> ArrowStream | ArrowArray:
    if hasattr(table, "collect"):
        table = table.collect()
    if not hasattr(table, "columns"):
        raise TypeError(f"{name}: a {type(table).__name__} of polars is one column; take series.to_frame('load.inertia [kg m^2]')")
    if any(str(kind) in ("Null", "Object") or str(kind).startswith(("List", "Array", "Struct")) for kind in table.dtypes):
        return of_columns({heading: table[heading].to_list() for heading in table.columns}, name)
    return cast("ArrowStream", table)


def _relation(table: Any, name: str) -> ArrowStream | ArrowArray:
    if hasattr(table, "__arrow_c_stream__"):
        return cast("ArrowStream", table)
    headings = list(table.columns) if hasattr(table, "columns") else [each[0] for each in table.description]
    _once(headings, name)
    rows = table.fetchall()
    return of_columns({heading: [row[at] for row in rows] for at, heading in enumerate(headings)}, name)


def _once(headings: list[Any], name: str) -> None:
    twice = sorted({str(heading) for heading in headings if headings.count(heading) > 1})
    if twice:
        raise ValueError(f"{name}: two columns are called {', '.join(twice)}")
