"""The native part of antrieb; what is public of it is in `antrieb`."""

from collections.abc import Mapping, Sequence
from typing import Any, final

from antrieb._arrow import ArrowArray, ArrowSchema, ArrowStream

__all__ = ["VERSION", "Sweep", "Table", "ask", "forked", "run"]

VERSION: str

@final
class Table:
    """A table of Arrow: what reads Arrow takes it as it is."""

    @staticmethod
    def from_pydict(columns: Mapping[str, Sequence[float | None] | Sequence[str | None]]) -> Table: ...
    @property
    def column_names(self) -> list[str]: ...
    def to_pydict(self) -> dict[str, list[Any]]: ...
    @staticmethod
    def unpacked(bytes: bytes) -> Table: ...
    def __copy__(self) -> Table: ...
    def __deepcopy__(self, memo: Any) -> Table: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __len__(self) -> int: ...
    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any: ...
    def __arrow_c_schema__(self) -> Any: ...

@final
class Sweep:
    """A sweep over tables of the same columns: the project is read once."""

    def __new__(
        cls,
        handed: tuple[str | None, str, str],
        schema: ArrowStream | ArrowArray | ArrowSchema,
        pairs: Sequence[tuple[str, str]],
        lang: str,
        memory: str | None,
    ) -> Sweep: ...
    @staticmethod
    def whole(
        handed: tuple[str | None, str, str],
        table: ArrowStream | ArrowArray,
        pairs: Sequence[tuple[str, str]],
        lang: str,
        memory: str | None,
        deadline: str | None,
    ) -> Table: ...
    @property
    def keys(self) -> list[str]: ...
    @property
    def recordings(self) -> list[str]: ...
    @property
    def made_of(self) -> tuple[tuple[str | None, str, str], Table, list[tuple[str, str]], str, str | None]: ...
    @property
    def answers(self) -> Table: ...
    def table(self, table: ArrowStream | ArrowArray, deadline: str | None) -> Table: ...
    def batch(self, batch: ArrowStream | ArrowArray, first_row: int) -> Table: ...

def ask(
    command: str,
    texts: Sequence[tuple[str | None, str, str]],
    pairs: Sequence[tuple[str, str]],
    lang: str,
    deadline: str | None,
    memory: str | None,
) -> tuple[str, bytes]: ...
def forked() -> None: ...
def run(call: Sequence[str]) -> int: ...
