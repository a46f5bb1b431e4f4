"""Sweeps: many axes at once, an Arrow table in and an Arrow table out."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from antrieb import _antrieb
from antrieb._antrieb import Table
from antrieb._arrow import ArrowArray, ArrowSchema, ArrowStream
from antrieb._axis import to_source
from antrieb._call import AntriebError, Lang, Path, Text, TimeLimit, flag, handed, language, of_objects, pairs_of, unit_text, with_nearest
from antrieb._called import called
from antrieb._columns import keyed, matched
from antrieb._fault import fault
from antrieb._progress import Progress, observed
from antrieb._tables import TableLike

if TYPE_CHECKING:
    from antrieb import answers

__all__ = ["ArrowArray", "ArrowSchema", "ArrowStream", "Sweep", "Table", "TableLike", "sweep"]


class Sweep:
    """A sweep over tables of the same columns: project and headings are read once, tables are judged one after the other.

    Args:
        text: The project as text, or the path of its file.
        schema: The columns: a schema, or a table that has them. A heading is a key of the project with its unit,
            `load.inertia [kg m^2]`, `motion[1].time [s]`; `code` judges each row for one ordering code.
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        check: Checks whose verdicts are wanted: every actuator is answered, not only the best.
        front: The actuators that no other beats in mass, length and reserve; without `check`.
        inputs: The answers repeat the columns of the table; without it those that are no keys, such as `id`.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        memory: Limit of the memory for the recordings, and for the answers of a call, such as `1 GiB`; 512 MiB without it.

    Raises:
        AntriebError: Every fault of the project and of the headings.
    """

    __slots__ = ("_empty", "_source", "_sweep")

    @called
    def __init__(
        self,
        text: Text,
        schema: ArrowSchema | TableLike,
        *,
        lang: Lang = "en",
        axis: str | None = None,
        check: answers.CheckId | Sequence[answers.CheckId] = (),
        front: bool = False,
        inputs: bool = False,
        file: str | None = None,
        folder: Path | None = None,
        memory: str | None = None,
    ) -> None:
        options = _options(axis, check, front, lang)
        self._source = to_source(text)
        columns = keyed(schema, self._source, name="schema")
        given = handed(text, file, folder), columns, options, lang, unit_text("memory", memory), flag("inputs", inputs)
        try:
            self._sweep = _antrieb.Sweep(*given)
        except AntriebError as error:
            raise with_nearest(of_objects(error, (text,))) from None
        self._empty = self._sweep.made_of[1]

    def __reduce__(self) -> tuple[Callable[..., Sweep], tuple[Any, ...]]:
        # What travels between processes is what it was made of, with the text of the project as it was read.
        return _again, (type(self), self._source, *self._sweep.made_of)

    def __copy__(self) -> Sweep:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Sweep:
        return self

    @property
    def keys(self) -> list[str]:
        """The keys of the columns, entries of lists counted from one."""
        return self._sweep.keys

    @property
    def carried(self) -> list[str]:
        """The columns of a table that the answers repeat."""
        return self._sweep.carried

    @property
    def recordings(self) -> list[str]:
        """The recordings that the project names."""
        return self._sweep.recordings

    @property
    def rows_most(self) -> int:
        """The largest number of rows whose answers a call returns: as many as `memory` holds, a line for each actuator."""
        return self._sweep.rows_most

    @property
    def answers(self) -> Table:
        """The columns of the answers, as an empty table."""
        return self._sweep.answers

    def table(self, table: TableLike, *, deadline: TimeLimit | None = None, progress: Progress = False) -> Table:
        """The answers of all rows; `AntriebError` with every fault of the cells, and for more rows than `rows_most`, before any row is judged.

        Columns are those of the headings in any order; one that is missing, too many or in another unit is refused.
        """
        rows = self._rows(table, "table")
        with observed(progress, "en") as observer:
            try:
                return self._sweep.table(rows, unit_text("deadline", deadline), observer)
            except AntriebError as error:
                raise with_nearest(self._typed(error, "table")) from None

    def batch(self, batch: TableLike, first_row: int = 0) -> Table:
        """The answers of a part of a table, at most `rows_most` rows, whose first row has this number; a fault of a cell is in the column `error`."""
        rows = self._rows(batch, "batch")
        try:
            first_row = operator.index(first_row)
        except TypeError:
            raise TypeError(f"first_row: a whole number from 0 is expected, not {type(first_row).__name__}") from None
        if not 0 <= first_row < 1 << 63:
            raise fault(f"first_row: a whole number from 0 to 2^63 is expected, not {first_row}")
        try:
            return self._sweep.batch(rows, first_row)
        except AntriebError as error:
            raise self._typed(error, "batch") from None

    def _rows(self, table: TableLike, name: str) -> Any:
        return matched(table, self._source, self._empty, self._sweep.carried, name)

    def _typed(self, error: AntriebError, name: str) -> AntriebError:
        """The exception; columns of another type than before are named."""
        found = re.search(r"expected (\w+).* but found (.+) at column index (\d+)$", str(error))
        if found is None:
            return error
        heading = self._sweep.answers.column_names[int(found[3])]
        return fault(f"{name}: column {heading!r} has values of type {found[2]}; the sweep was prepared for {found[1]}")


def unpacked(stream: bytes) -> Table:
    """A table that comes from another process."""
    return Table.unpacked(stream)


def _again(of: type[Sweep], source: Any, *made_of: Any) -> Sweep:
    """A sweep made anew in another process."""
    sweep = of.__new__(of)
    sweep._source = source  # pyright: ignore[reportPrivateUsage]
    sweep._sweep = _antrieb.Sweep(*made_of)  # pyright: ignore[reportPrivateUsage]
    sweep._empty = sweep._sweep.made_of[1]  # pyright: ignore[reportPrivateUsage]
    return sweep


def _options(
    axis: str | None, check: answers.CheckId | Sequence[answers.CheckId], front: bool, lang: Lang
) -> list[tuple[str, str]]:
    return pairs_of([("axis", axis), ("check", check), ("front", flag("front", front)), ("lang", language(lang))])


@called
def sweep(
    text: Text,
    table: TableLike,
    *,
    grid: bool = False,
    lang: Lang = "en",
    axis: str | None = None,
    check: answers.CheckId | Sequence[answers.CheckId] = (),
    front: bool = False,
    inputs: bool = False,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
    progress: Progress = False,
) -> Table:
    """Judge many axes: a project, and a table whose columns are keys of it.

    Each row is the project with the values of the row. Verdicts and digits are those of `size`.

    Args:
        text: The project as text, or the path of its file.
        table: A dictionary of columns, a list of dictionaries, a data frame of pandas or polars, a relation of DuckDB, a structured
            array of NumPy, or any table of Arrow. A heading is a key of the project with its unit, `load.inertia [kg m^2]`,
            `motion[1].time [s]`, `requirements.ambient [degC]`; words of the project such as `motion[1].law` have none; `code`
            judges each row for one ordering code. Columns that are no keys, such as `id`, are repeated in the answer.
            Or columns by their keys, their values with a unit: `{"motion.1.payload": antrieb.q([1, 2], "kg")}`; entries count
            from one.
        grid: Judge every combination of the values of the columns, the last column fastest; the answers repeat them.
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        check: Checks whose verdicts are wanted: every actuator is answered, not only the best.
        front: The actuators that no other beats in mass, length and reserve; without `check`.
        inputs: The answers repeat the columns of the table; without it those that are no keys, such as `id`.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`.
        memory: Limit of the memory for the recordings, and for the answers of a call, such as `1 GiB`; 512 MiB without it.
        progress: `True` for a line on the terminal with rows, rate and time left, a function that is called with the number of
            judged rows and of all rows, or the class of a bar such as `tqdm.tqdm`.

    Returns:
        An Arrow table, a row for each row: `row` (from 0), `fit` (how many actuators fit within every limit),
        `fit_if_estimate` (how many others if an estimate holds), `code` (the best of both), `utilisation` (of its governing
        check, 1 is the limit), `tightest` (that check), `error` (why the row could not be judged). With `check` and `front` a row for each actuator.

    Raises:
        AntriebError: Every fault of the project, of the headings and of the cells, each with its place; a table whose answers
            exceed `memory`, before any row is judged.
    """
    if flag("grid", grid) and not isinstance(table, Mapping):
        raise TypeError('grid=True takes columns by their keys, such as {"motion.1.payload": antrieb.q([1, 2], "kg")}')
    options = _options(axis, check, front, lang)
    rows = keyed(table, to_source(text), grid)
    # The rows of a grid are known by their values alone.
    is_repeated = flag("inputs", inputs) or grid
    project, limit, until = handed(text, file, folder), unit_text("memory", memory), unit_text("deadline", deadline)
    with observed(progress, lang) as observer:
        try:
            return _antrieb.Sweep.whole(project, rows, options, lang, limit, is_repeated, until, observer)
        except AntriebError as error:
            raise with_nearest(of_objects(error, (text,))) from None
