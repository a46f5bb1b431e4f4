"""What hands over tables of Arrow: the PyCapsule interface, which pyarrow, polars, pandas, DuckDB and others have."""

from __future__ import annotations

from typing import Any, Protocol


class ArrowStream(Protocol):
    """Anything that hands over a stream of Arrow: tables of pyarrow, polars, pandas, DuckDB, and `antrieb.Table`."""

    def __arrow_c_stream__(self, requested_schema: Any = None, /) -> Any:
        """A capsule of the name `arrow_array_stream`."""
        ...


class ArrowArray(Protocol):
    """Anything that hands over an array of Arrow: a record batch of pyarrow."""

    def __arrow_c_array__(self, requested_schema: Any = None, /) -> tuple[Any, Any]:
        """Capsules of the names `arrow_schema` and `arrow_array`."""
        ...


class ArrowSchema(Protocol):
    """Anything that has columns: a schema of pyarrow."""

    def __arrow_c_schema__(self) -> Any:
        """A capsule of the name `arrow_schema`."""
        ...
