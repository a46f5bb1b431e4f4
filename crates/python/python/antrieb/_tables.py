"""Tables as they come: each becomes one that hands itself over as Arrow."""

# Values of other libraries have no types until they are looked at.
# pyright: reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

import dataclasses
import datetime
import decimal
import importlib
import math
import os
import re
import uuid
from collections.abc import Collection, Iterable, Mapping, Sequence, Set
from typing import Any, cast

from antrieb._antrieb import Table
from antrieb._arrow import ArrowArray, ArrowStream
from antrieb._fault import fault
from antrieb._plain import aligned, listed, number_of, ordered, refuse_times, text
from antrieb._quantity import Q, columns_of, of_pint

Column = tuple[str, Any]
"""A heading, and a list, a quantity or a column of Arrow."""

TableLike = (
    ArrowStream | ArrowArray | Mapping[str, Any] | Iterable[Mapping[str, Any]] | Any
)
"""A table: a dictionary of columns, a list of dictionaries, records or named tuples, a data frame of pandas or polars (lazy
too), a relation of DuckDB, a structured array of NumPy, or anything that hands itself over as Arrow."""

EMPTY = ("NAType", "NaTType", "MaskedConstant")
"""Types of empty cells, as libraries call them."""

EXAMPLE = "{'load.inertia [kg m^2]': [1.0, 2.0]}"


def arrow(table: Any, name: str = "table") -> ArrowStream | ArrowArray:
    """A table as one of Arrow.

    Raises:
        TypeError: It is no table, or a column of it cannot be read; the message says what to write.
        AntriebError: Its columns have different lengths, or two have one name.
    """
    module = type(table).__module__.partition(".")[0]
    if not isinstance(table, Table) and (module in ("pandas", "polars") or not _is_arrow(table)):
        return cast("ArrowStream", joined(split(table, name), name))
    return cast("ArrowStream | ArrowArray", table)


def _is_arrow(table: Any) -> bool:
    return hasattr(table, "__arrow_c_stream__") or hasattr(table, "__arrow_c_array__")


def split(table: Any, name: str = "table", index: Collection[str] | None = None) -> list[Column]:
    """The columns of a table: their headings, and lists or columns of Arrow.

    Args:
        table: The table.
        name: The argument that it is.
        index: Headings; an index of pandas without a name is a column if they have its title, and not by its labels.

    Raises:
        TypeError: It is no table, or a column of it cannot be read; the message says what to write.
    """
    if table is None or isinstance(table, (str, bytes, int, float, complex)):
        raise TypeError(f"{name}: a table is expected, such as {EXAMPLE}, not {type(table).__name__}{_path_hint(table)}")
    if isinstance(table, Mapping):
        return _listed(cast("Any", table), name)
    module = type(table).__module__.partition(".")[0]
    if module == "pandas":
        return _pandas(table, name, index)
    if module == "polars":
        return _polars(table, name)
    if getattr(getattr(table, "dtype", None), "names", None):
        return _structured(table, name)
    if _is_arrow(table):
        return _of_arrow(table, name)
    if module in ("duckdb", "_duckdb") and hasattr(table, "fetchall"):
        return _relation(table, name)
    if hasattr(table, "dtype"):
        raise TypeError(f"{name}: an array has no headings; write {{'load.inertia [kg m^2]': array}}, or use a structured array")
    if isinstance(table, Iterable):
        return _rows(cast("Any", table), name)
    raise TypeError(f"{name}: a table is expected, such as {EXAMPLE}, not {type(table).__name__}")


def _of_arrow(table: Any, name: str) -> list[Column]:
    library = arrow_library()
    if isinstance(table, Table) and getattr(library, "__name__", "") != "pyarrow":
        return list(table.to_pydict().items())
    if library is None:
        raise TypeError(f"{name}: reading the columns of {type(table).__name__} needs pyarrow or polars; hand over a dictionary of columns")
    try:
        whole = library.DataFrame(table) if library.__name__ == "polars" else library.table(table)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{name}: a table is expected, such as {EXAMPLE}, not {type(table).__name__}: {error}") from None
    if library.__name__ == "polars":
        return [(heading, whole[heading]) for heading in whole.columns]
    return list(zip(whole.column_names, whole.columns, strict=True))


def arrow_library() -> Any:
    """pyarrow or polars, whichever is there."""
    for name in ("pyarrow", "polars"):
        try:
            return importlib.import_module(name)
        except ImportError:
            continue
    return None


def joined(columns: Sequence[Column], name: str = "table") -> Any:
    """The columns as a table of Arrow.

    Raises:
        TypeError: A column is of no kind that can be kept.
        ValueError: The columns have different lengths, or two have one name.
    """
    columns = [_with_unit(heading, values, name) if isinstance(values, Q) else (heading, values) for heading, values in columns]
    _once([heading for heading, _ in columns], name)
    lengths = {heading: len(values) for heading, values in columns}
    if len(set(lengths.values())) > 1:
        shown = ", ".join(f"{heading!r} has {count}" for heading, count in list(lengths.items())[:6])
        raise fault(f"{name}: the columns have different lengths: {shown}", "give each a value for each row")
    if all(isinstance(values, list) and not _is_wide(values) for _, values in columns):
        return Table.from_pydict(dict(columns))
    is_polars = any(type(values).__module__.startswith("polars") for _, values in columns)
    library = importlib.import_module("polars") if is_polars else arrow_library()
    if library is None:
        wide = next(heading for heading, values in columns if _is_wide(values))
        raise TypeError(f"{name}: column {wide!r} has numbers from 2^63 on; give them as texts, or install pyarrow")
    own = {heading: _of_list(values, library) if isinstance(values, list) else values for heading, values in columns}
    return library.DataFrame(own) if library.__name__ == "polars" else library.table(own)


def _with_unit(heading: str, values: Q, name: str) -> Column:
    if "[" in heading:
        raise TypeError(f"{name}: column {heading!r} has a unit already, {values.unit}; write the heading without one")
    return (f"{heading} [{values.unit}]" if values.unit else heading), cells(values)


def cells(values: Q) -> list[Any]:
    """The numbers, `None` where there is none."""
    return [None if value != value else value for value in values.values]


def _of_list(values: list[Any], library: Any) -> Any:
    """A list as a column of the library, of the type that it has in a table without one."""
    if _is_wide(values):
        return library.Series(values, dtype=library.UInt64) if library.__name__ == "polars" else library.array(values, library.uint64())
    table = Table.from_pydict({"": values})
    return library.DataFrame(table)[""] if library.__name__ == "polars" else library.table(table).column(0)


def of_cells(values: list[Any], place: str) -> Q | None:
    """Cells that are quantities in one unit, with `None` among them; else `None`."""
    if {type(value) for value in values} <= {int, float, str, bool, type(None)}:
        return None
    known = [value for value in values if not _is_empty(value)]
    if not any(isinstance(value, Q) or (hasattr(value, "magnitude") and hasattr(value, "units")) for value in known):
        return None
    found = [value if isinstance(value, Q) else of_pint(value, place) for value in known]
    if any(value is None or isinstance(value.value, tuple) for value in found):
        raise TypeError(f"{place} mixes quantities and other values; give all of them with their unit")
    units = sorted({value.unit for value in found if value is not None})
    if len(units) > 1:
        raise TypeError(f"{place} has quantities in {' and '.join(units)}; write all of them in one unit")
    each = iter(found)
    numbers = [None if _is_empty(value) else next(each) for value in values]
    return Q(tuple(math.nan if value is None else value.values[0] for value in numbers), units[0])


def _is_empty(value: Any) -> bool:
    return value is None or type(value).__name__ in EMPTY or (isinstance(value, float) and value != value)


def _is_wide(values: Any) -> bool:
    """Returns true if a list has whole numbers from 2^63 on."""
    return isinstance(values, list) and any(type(value) is int and value >= 1 << 63 for value in values)


def _path_hint(table: Any) -> str:
    return "; a file is read by the library of your choice or by the command `antrieb sweep`" if isinstance(table, str) else ""


def of_columns(columns: Mapping[Any, Any], name: str = "table") -> Any:
    """A table of columns by their headings."""
    return joined(_listed(columns, name), name)


def _listed(columns: Mapping[Any, Any], name: str) -> list[Column]:
    found: list[Column] = []
    for heading, values in _by_labels(columns, name).items():
        found.append((_heading(heading, name), _column(values, heading, name)))
    return found


def _heading(heading: Any, name: str) -> str:
    """A heading as a plain text."""
    if not isinstance(heading, str):
        raise TypeError(f"{name}: a heading is a text such as 'load.inertia [kg m^2]', not {heading!r}")
    return _without_nul(text(heading, f"{name}: a heading"), name)


def _without_nul(heading: str, name: str) -> str:
    """Refuses a heading that no table of Arrow can have.

    Raises:
        AntriebError: It has a character with the number zero.
    """
    if "\0" in heading:
        raise fault(f"{name}: the heading {heading!r:.60} has a character with the number zero", "leave it out")
    return heading


def _by_labels(columns: Mapping[Any, Any], name: str) -> dict[Any, Any]:
    """Columns whose series have their rows in the order of the first one: a series is known by the labels of its rows."""
    first: Any = None
    found: dict[Any, Any] = {}
    for heading, values in columns.items():
        if hasattr(values, "iloc") and getattr(values, "ndim", 1) == 1:
            place = f"{name}: column {heading!r}"
            found[heading] = values if first is None else aligned(values, first[1], place, f"column {first[0]!r}")
            first = first or (heading, values)
        else:
            found[heading] = values
    return found


def _column(given: Any, heading: str, name: str) -> Any:
    values: Any = given
    place = f"{name}: column {heading!r}"
    if isinstance(values, Q) or (hasattr(values, "magnitude") and hasattr(values, "units")):
        return columns_of(values, place) or []
    if values is None or isinstance(values, (str, bytes, bool, int, float, Mapping)) or getattr(values, "ndim", 1) == 0:
        raise TypeError(f"{place} is one value ({values!r}); give a list with a value for each row")
    if getattr(values, "ndim", 1) > 1:
        raise TypeError(f"{place} has {values.ndim} dimensions; give one value for each row")
    module = type(values).__module__.partition(".")[0]
    if module == "pandas" and hasattr(values, "iloc"):
        return _series(values, heading, name)
    if module in ("polars", "pyarrow") and hasattr(values, "__len__"):
        return _of_library(values, heading, name)
    if not hasattr(values, "__iter__"):
        raise TypeError(f"{place} is {type(values).__name__}; give a list with a value for each row")
    ordered(values, place)
    if getattr(getattr(values, "dtype", None), "kind", "") in ("m", "M"):
        return _carried(list(values), place, values)
    convert = getattr(values, "tolist", None) or getattr(values, "to_list", None)
    rows: list[Any] = convert() if convert else listed(values, place)
    quantities = of_cells(rows, place)
    if quantities is not None:
        return quantities
    if any(_is_carried(value) for value in rows):
        decimals = all(value is None or isinstance(value, (decimal.Decimal, int, float)) and not isinstance(value, bool) for value in rows)
        if not decimals or (not any(isinstance(value, float) for value in rows) and arrow_library() is not None):
            return _carried([decimal.Decimal(value) if decimals and isinstance(value, int) else value for value in rows], place, None)
        # Among fractions, and without a library that has them, decimals are fractions.
        rows = [float(value) if isinstance(value, decimal.Decimal) else value for value in rows]
    plain = [_value(value, place, row) for row, value in enumerate(rows)]
    kinds = {"text" if isinstance(value, str) else "bool" if isinstance(value, bool) else "number" for value in plain if value is not None}
    if len(kinds) > 1:
        raise TypeError(f"{place} mixes {' and '.join(sorted(kinds))}; a column has values of one kind")
    if any(type(value) is float for value in plain):
        # A column has one type; a whole number that a float does not have would be another one.
        lost = next((value for value in plain if type(value) is int and abs(value) > 1 << 53), None)
        if lost is not None:
            raise TypeError(f"{place} mixes fractions and {lost}, which would be rounded; give the column as texts")
        return [float(value) if type(value) is int else value for value in plain]
    whole: list[int] = [value for value in plain if type(value) is int]
    if whole and min(whole) < 0 and _is_wide(plain):
        raise TypeError(f"{place} has whole numbers from {min(whole)} to {max(whole)}, which no type holds; give them as texts")
    return plain


CARRIED = (datetime.date, datetime.time, datetime.timedelta, decimal.Decimal, bytes, list, tuple, dict, uuid.UUID, os.PathLike)
"""Types that a column without a key may have; a library of Arrow keeps them."""


def _is_carried(value: Any) -> bool:
    return isinstance(value, CARRIED) and type(value).__name__ not in EMPTY or getattr(getattr(value, "dtype", None), "kind", "") in ("m", "M")


def _kind(value: Any) -> str:
    """The kind of a value of a column, in the plural: values of two kinds would be converted into one."""
    kind = getattr(getattr(value, "dtype", None), "kind", "")
    if kind == "m" or isinstance(value, datetime.timedelta):
        return "intervals"
    if kind == "M":
        return "instants"
    if isinstance(value, datetime.datetime):
        return "instants" if value.tzinfo is None else "instants of a time zone"
    for of, name in ((datetime.date, "days"), (datetime.time, "times of day"), (bytes, "bytes"), (str, "texts"), (bool, "truth values")):
        if isinstance(value, of):
            return name
    if isinstance(value, dict):
        return f"dictionaries of {', '.join(map(str, value)) or 'nothing'}"
    return "lists" if isinstance(value, (list, tuple)) else "numbers"


def _in_one_unit(rows: list[Any]) -> Any:
    """Intervals or instants as an array of NumPy in the finest unit among them, which loses none of them."""
    numpy = importlib.import_module("numpy")
    known = [value for value in rows if value is not None]
    kind = "M" if any(isinstance(value, datetime.datetime) or getattr(getattr(value, "dtype", None), "kind", "") == "M" for value in known) else "m"
    units = {numpy.datetime_data(value.dtype)[0] if hasattr(value, "dtype") else "us" for value in known}
    finest = next(unit for unit in ("as", "fs", "ps", "ns", "us", "ms", "s", "m", "h", "D", "W", "M", "Y", "generic") if unit in units)
    name = f"{kind}8" if finest == "generic" else f"{kind}8[{finest}]"
    return numpy.array(rows, dtype=name)


def _carried(given: list[Any], place: str, values: Any) -> Any:
    """A column that is only repeated, in its type; without a library of Arrow times are texts. An array of times is handed over as it is."""
    kinds = dict.fromkeys(_kind(value) for value in given if not _is_empty(value) and not isinstance(value, (uuid.UUID, os.PathLike)))
    if len(kinds) > 1:
        raise TypeError(f"{place} mixes {' and '.join(kinds)}; a column has values of one kind")
    rows: Any = [None if _is_empty(value) else str(value) if isinstance(value, (uuid.UUID, os.PathLike)) else value for value in given]
    library = arrow_library()
    if library is None:
        if all(value is None or isinstance(value, (str, datetime.date, datetime.time, datetime.timedelta)) for value in rows):
            return [None if value is None else str(value) for value in rows]
        raise TypeError(f"{place}: values of this type are carried by pyarrow or polars, which are not installed; give them as texts")
    if all(value is None or isinstance(value, str) for value in rows):
        return rows
    if values is not None:
        rows = values
    if values is None and any(getattr(getattr(value, "dtype", None), "kind", "") in ("m", "M") for value in rows):
        rows = _in_one_unit(rows)
    try:
        return library.Series(rows) if library.__name__ == "polars" else library.chunked_array([library.array(rows)])
    except (TypeError, ValueError, OverflowError, library.ArrowException if library.__name__ == "pyarrow" else TypeError) as error:
        raise TypeError(f"{place}: its values are of no one type ({error}); give them as texts") from None


AS_LIST = ("Null", "Object", "Int128", "UInt128")
"""Types of polars that Arrow does not have, or that say nothing about the values."""


def _of_library(values: Any, heading: str, name: str) -> Any:
    """A column of polars or of pyarrow as it is; one of no type as a list."""
    if type(values).__module__.startswith("polars"):
        return _column(values.to_list(), heading, name) if str(values.dtype) in AS_LIST else values
    library = importlib.import_module("pyarrow")
    if isinstance(values, library.Array):
        values = library.chunked_array([values])
    return values if isinstance(values, library.ChunkedArray) else _column(values.to_pylist(), heading, name)


def _value(value: Any, place: str, row: int) -> Any:
    if isinstance(value, str):
        return value if type(value) is str and value.isascii() else text(value, f"{place}, row {row}")
    if value is None or isinstance(value, (float, bool)):
        # A number that is none is no value, as in every library of tables.
        return None if isinstance(value, float) and value != value else float(value) if isinstance(value, float) else value
    if isinstance(value, int):
        if not -(1 << 63) <= value < 1 << 64:
            raise TypeError(f"{place}, row {row}: {value} has more than 64 bits; give the column as texts")
        return int(value)
    kind = type(value).__name__
    if kind in EMPTY:
        return None
    if hasattr(value, "magnitude") or hasattr(value, "unit"):
        raise TypeError(f"{place}, row {row}: a quantity among the cells; give the column as antrieb.q([…], unit), or numbers below a heading with the unit")
    refuse_times(value, f"{place}, row {row},")
    if hasattr(value, "item") and getattr(value, "ndim", 1) == 0:
        inner = value.item()
        if type(inner) is type(value):
            # A long double is none of Python; a complex one is no number of a column.
            return _value(number_of(value, f"{place}, row {row}"), place, row)
        return _value(inner, place, row)
    raise TypeError(f"{place}, row {row}: a number, a text or None is expected, not {kind}")


def _rows(rows: Iterable[Any], name: str) -> list[Column]:
    columns: dict[str, list[Any]] = {}
    count = 0
    for number, row in enumerate(_ended(rows, name)):
        fields = _fields(row, name, number)
        for heading in fields:
            if heading not in columns:
                columns[heading] = [None] * number
        for heading, values in columns.items():
            values.append(fields.get(heading))
        count += 1
    if count == 0:
        raise fault(f"{name}: there is no row, and so no heading", f"write one such as {EXAMPLE}")
    return _listed(columns, name)


def _ended(rows: Iterable[Any], name: str) -> list[Any]:
    if isinstance(rows, Set):
        raise TypeError(f"{name} is a {type(rows).__name__}, whose rows have no order; hand over a list")
    return listed(rows, name)


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


def _structured(table: Any, name: str) -> list[Column]:
    if getattr(table, "ndim", 1) != 1:
        raise TypeError(f"{name}: a structured array of {table.ndim} dimensions; take one with a dimension of rows")
    return _listed({heading: table[heading] for heading in table.dtype.names}, name)


def _pandas(table: Any, name: str, index: Collection[str] | None) -> list[Column]:
    if not hasattr(table, "columns"):
        raise TypeError(f"{name}: a {type(table).__name__} of pandas is one column; take series.to_frame('load.inertia [kg m^2]')")
    if getattr(table.columns, "nlevels", 1) > 1:
        raise TypeError(f"{name}: headings of {table.columns.nlevels} levels; join them to one text")
    headings = list(table.columns)
    _once([*headings], name)
    columns = {heading: table[heading] for heading in headings}
    own: dict[Any, Any] = {}
    rows = table.index
    for level in range(rows.nlevels):
        title = rows.names[level]
        unnamed = "index" if rows.nlevels == 1 else f"index_{level}"
        # What the rows are called is carried along, unless they are only counted.
        is_counted = type(rows).__name__ == "RangeIndex" and rows.start == 0 and rows.step == 1
        if title is not None or (not is_counted if index is None else unnamed in index):
            own[title if title is not None else unnamed] = rows.get_level_values(level).to_series()
    _once([*own, *headings], name)
    found: list[Column] = []
    for heading, values in {**own, **columns}.items():
        found.append((_heading(heading, name), _series(values, heading, name)))
    return found


def _series(values: Any, heading: str, name: str) -> Any:
    """A column of pandas with its type where Arrow has it, else as a list."""
    dtype = values.dtype
    kind = getattr(dtype, "kind", "O")
    is_plain = type(dtype).__module__.startswith("numpy") and (kind in "iubmM" or str(dtype) in ("float32", "float64"))
    # What has times without pyarrow is a text.
    of = type(dtype).__name__
    names = ("StringDtype", "CategoricalDtype", "DatetimeTZDtype", "BooleanDtype", "ArrowDtype")
    if is_plain or of in names or re.fullmatch("U?Int(8|16|32|64)Dtype|Float(32|64)Dtype", of):
        library = arrow_library()
        if library is not None and library.__name__ == "pyarrow":
            try:
                column = library.Array.from_pandas(values)
            except library.ArrowException as error:
                raise TypeError(f"{name}: column {heading!r}: {error}") from None
            except OverflowError:
                raise TypeError(f"{name}: column {heading!r} has numbers of more than 64 bits; give the column as texts") from None
            inner = column.type.value_type if library.types.is_dictionary(column.type) else None
            if inner is not None and not library.types.is_string(inner) and not library.types.is_large_string(inner):
                # Categories that are numbers stay numbers in answers.
                column = column.dictionary_decode()
            return library.chunked_array([column]) if isinstance(column, library.Array) else column
    if kind in ("m", "M"):
        return [None if text == "NaT" else text for text in values.astype(str).tolist()]
    if of == "CategoricalDtype":
        values = values.astype(object).tolist()
    return _column(values if isinstance(values, list) else values.tolist() if kind != "O" else list(values), heading, name)


def _polars(table: Any, name: str) -> list[Column]:
    if hasattr(table, "collect"):
        table = table.collect()
    if not hasattr(table, "columns"):
        raise TypeError(f"{name}: a {type(table).__name__} of polars is one column; take series.to_frame('load.inertia [kg m^2]')")
    found: list[Column] = []
    for heading in table.columns:
        _without_nul(heading, name)
        is_listed = str(table[heading].dtype) in AS_LIST
        found.append((heading, _column(table[heading].to_list(), heading, name) if is_listed else table[heading]))
    return found


def _relation(table: Any, name: str) -> list[Column]:
    headings = list(table.columns) if hasattr(table, "columns") else [each[0] for each in table.description]
    _once(headings, name)
    rows = table.fetchall()
    return _listed({heading: [row[at] for row in rows] for at, heading in enumerate(headings)}, name)


def _once(headings: list[Any], name: str) -> None:
    twice = sorted({str(heading) for heading in headings if headings.count(heading) > 1})
    if twice:
        raise fault(f"{name}: two columns are called {', '.join(twice)}", "give each a name of its own")
