"""Sweeps that outlast a machine: parts of a table judged by the workers of a Ray cluster, each part a Parquet file.

>>> from antrieb import distributed
>>> distributed.sweep("axis.toml", tasks, "out", rows=1_000_000_000)          # a function makes the tasks from their ids
>>> distributed.sweep("axis.toml", ["tasks-0.parquet", "tasks-1.parquet"], "out")   # or they are read from files

Nothing travels to a worker but the number of its part, nothing comes back but a summary. A worker that is lost is tried again
elsewhere, a part that is finished is never judged twice, and a call with the same folder goes on where an earlier one ended, if project, options,
task files and recordings are still the same; a function that makes tasks must make the same ones.
The folder lies where every worker sees it. Needs `ray` and `pyarrow`: `pip install "antrieb[distributed]"`. `parts` and `judge`
are the same without Ray, for any other engine; `docs/guide/clusters.md` has recipes for Dask and Spark.
"""

from __future__ import annotations

import collections
import dataclasses
import functools
import hashlib
import importlib
import json
import os
import pathlib
import time
import uuid
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

from antrieb import Sweep, __version__, answers
from antrieb._arrow import ArrowArray, ArrowStream
from antrieb._call import Lang, Path, Text, each_of, handed
from antrieb._fault import fault

Makes = Callable[[int, int], ArrowStream | ArrowArray]
"""Makes the tasks of a part from the id of its first and their number: the same table for the same ids."""

Tasks = Makes | Path | Sequence[Path]
"""A function that makes tasks, or the Parquet files that hold them."""


def _library(name: str) -> Any:
    # Loaded where it is needed: antrieb itself needs none.
    return importlib.import_module(name)


_SUMMARY = b"antrieb.summary"
_MANIFEST = "_sweep.json"
_REASONS_MOST = 20


@dataclasses.dataclass(frozen=True, kw_only=True)
class Spec:
    """What is the same for all parts of a sweep."""

    text: str
    """The text of the project."""
    name: str
    """What it is called in faults."""
    folder: str
    """Where its recordings lie, on every worker."""
    out: str
    """The folder of the parts."""
    lang: Lang = "en"
    """The language of the reasons."""
    axis: str | None = None
    """The axis of a project with several."""
    check: tuple[answers.CheckId, ...] = ()
    """Checks whose verdicts are wanted of every actuator."""
    front: bool = False
    """The actuators that no other beats."""


@dataclasses.dataclass(frozen=True, kw_only=True)
class Part:
    """A part of the tasks: rows that follow each other."""

    first: int
    """The number of its first row in the whole."""
    count: int
    """How many rows it has."""
    file: str | None = None
    """The Parquet file that holds them; of none they are made."""
    groups: tuple[int, int] = (0, 0)
    """Its row groups: the first, and the one behind the last."""

    def path(self, out: str) -> pathlib.Path:
        """The file of its answers."""
        return pathlib.Path(out) / f"part-{self.first:012d}.parquet"


@dataclasses.dataclass(kw_only=True)
class Summary:
    """What came of a sweep."""

    rows: int = 0
    """Rows answered."""
    found: int = 0
    """Of these in parts that were finished already: by an earlier call, or by a worker that was lost after it."""
    fitting: int = 0
    """Rows for which an actuator fits; with `check` and `front`: rows of the answer that fit."""
    failed: int = 0
    """Rows that could not be judged."""
    reasons: dict[str, int] = dataclasses.field(default_factory=dict[str, int])
    """Why, the most frequent reasons, with how many rows each."""
    parts: int = 0
    """Parts answered."""
    seconds: float = 0.0
    """How long this call took."""

    def add(self, part: dict[str, Any]) -> None:
        """Adds the summary of a part."""
        self.parts += 1
        self.rows += part["rows"]
        self.found += part["rows"] if part["found"] else 0
        self.fitting += part["fitting"]
        self.failed += part["failed"]
        reasons = collections.Counter(self.reasons)
        reasons.update(part["reasons"])
        self.reasons = dict(reasons.most_common(_REASONS_MOST))


def parts(tasks: Tasks, *, rows: int | None = None, part_rows: int = 100_000) -> Iterator[Part]:
    """The parts of the tasks, in their order.

    Args:
        tasks: A function that makes them, or the Parquet files that hold them.
        rows: How many a function makes.
        part_rows: Rows of a part; of files whole row groups, at least one.
    """
    if part_rows < 1:
        raise ValueError("part_rows is at least 1")
    if callable(tasks):
        if rows is None or rows < 0:
            raise ValueError("rows says how many tasks the function makes")
        for first in range(0, rows, part_rows):
            yield Part(first=first, count=min(part_rows, rows - first))
        return
    if rows is not None:
        raise ValueError("files say themselves how many rows they have")
    parquet = _library("pyarrow.parquet")
    first = 0
    for file in _files(tasks):
        metadata = parquet.ParquetFile(file).metadata
        begin, count = 0, 0
        for group in range(metadata.num_row_groups):
            of_group: int = metadata.row_group(group).num_rows
            if count and count + of_group > part_rows:
                yield Part(first=first, count=count, file=file, groups=(begin, group))
                first, begin, count = first + count, group, 0
            count += of_group
        if count:
            yield Part(first=first, count=count, file=file, groups=(begin, metadata.num_row_groups))
            first += count


def _files(tasks: Path | Sequence[Path]) -> list[str]:
    several = [tasks] if isinstance(tasks, (str, os.PathLike)) else list(tasks)
    return [os.path.abspath(os.fspath(each)) for each in several]


def specified(
    text: Text,
    out: Path,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    check: answers.CheckId | Sequence[answers.CheckId] = (),
    front: bool = False,
    file: str | None = None,
    folder: Path | None = None,
) -> Spec:
    """What is the same for all parts, with the text of the project in it."""
    written, name, beside, recordings = handed(text, file, folder)
    if recordings:
        raise fault(f"{name}: its recordings are in no file that a worker reads", "save the project where every worker sees it, and hand over its path")
    if written is None:
        path = pathlib.Path(name)
        written, beside = path.read_text(encoding="utf-8"), os.fspath(path.parent)
    return Spec(
        text=written,
        name=name,
        folder=os.path.abspath(beside or "."),
        out=os.path.abspath(os.fspath(out)),
        lang=lang,
        axis=axis,
        check=tuple(each_of(check, "check")),
        front=front,
    )


@functools.lru_cache(maxsize=4)
def _prepared(spec: Spec, schema: Any) -> Sweep:
    # A file of one line would be taken for its path.
    text = spec.text if "\n" in spec.text else spec.text + "\n"
    return Sweep(
        text,
        schema,
        lang=spec.lang,
        axis=spec.axis,
        check=spec.check,
        front=spec.front,
        file=spec.name,
        folder=spec.folder,
    )


def _read(part: Part, tasks: Makes | None) -> Any:
    if part.file is not None:
        return _library("pyarrow.parquet").ParquetFile(part.file).read_row_groups(list(range(*part.groups)))
    if tasks is None:
        raise ValueError("a part without a file is made by a function")
    table = _library("pyarrow").table(tasks(part.first, part.count))
    if table.num_rows != part.count:
        raise ValueError(f"{part.count} tasks are expected from {part.first} on, {table.num_rows} were made")
    return table


def judge(spec: Spec, part: Part, tasks: Makes | None = None) -> dict[str, Any]:
    """Judge a part and write its answers, unless they are there already; gives its summary.

    Whole or not at all: the file has its name only when it is finished, whatever ends the work before.
    """
    arrow, parquet = _library("pyarrow"), _library("pyarrow.parquet")
    path = part.path(spec.out)
    if path.exists():
        found = parquet.read_metadata(path).metadata[_SUMMARY]
        return {**json.loads(found), "found": True}
    table = _read(part, tasks)
    prepared = _prepared(spec, table.schema)
    fitting, reasons = 0, collections.Counter[str]()
    half = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
    try:
        with parquet.ParquetWriter(half, arrow.schema(prepared.answers), compression="zstd") as writer:
            # As many rows at a time as the memory holds answers of.
            for first in range(0, part.count, prepared.rows_most):
                rows = table.slice(first, prepared.rows_most).combine_chunks()
                answered = arrow.table(prepared.batch(rows, part.first + first))
                writer.write_table(answered)
                fitting += _fitting(answered)
                reasons.update(_reasons(answered))
            summary = _summary(part.count, fitting, reasons)
            writer.add_key_value_metadata({_SUMMARY: json.dumps(summary).encode()})
        os.replace(half, path)
    finally:
        half.unlink(missing_ok=True)
    return {**summary, "found": False}


def _reasons(answered: Any) -> dict[str, int]:
    counts = _library("pyarrow.compute").value_counts(answered.column("error").drop_null()).to_pylist()
    return {each["values"]: each["counts"] for each in counts}


def _fitting(answered: Any) -> int:
    is_fit = "fits" if "fits" in answered.column_names else "code"
    column = answered.column(is_fit)
    if is_fit == "code":
        return int(len(column) - column.null_count)
    return int(_library("pyarrow.compute").sum(column).as_py() or 0)


def _summary(rows: int, fitting: int, reasons: dict[str, int]) -> dict[str, Any]:
    by_number = sorted(reasons.items(), key=lambda each: (-each[1], each[0]))
    return {
        "rows": rows,
        "fitting": fitting,
        "failed": sum(reasons.values()),
        "reasons": dict(by_number[:_REASONS_MOST]),
    }


def _sum(files: Iterable[str]) -> str:
    """The sum over names and contents of files."""
    whole = hashlib.sha256()
    for file in files:
        of_file = "missing"
        if os.path.exists(file):
            with open(file, "rb") as opened:
                of_file = hashlib.file_digest(opened, "sha256").hexdigest()
        whole.update(f"{file}\n{of_file}\n".encode())
    return whole.hexdigest()


def _manifest(spec: Spec, all_parts: Sequence[Part], recordings: Sequence[str]) -> dict[str, Any]:
    """What a folder is of: parts of another sweep are not mixed with it."""
    described = [[part.first, part.count, part.file, list(part.groups)] for part in all_parts]
    return {
        "antrieb": __version__,
        "project": hashlib.sha256(spec.text.encode()).hexdigest(),
        "axis": spec.axis,
        "lang": spec.lang,
        "check": list(spec.check),
        "front": spec.front,
        "rows": sum(part.count for part in all_parts),
        "parts": hashlib.sha256(json.dumps(described).encode()).hexdigest(),
        "tasks": _sum(sorted({part.file for part in all_parts if part.file is not None})),
        "recordings": _sum(os.path.join(spec.folder, name) for name in recordings),
    }


def ready(spec: Spec, all_parts: Sequence[Part], tasks: Makes | None = None) -> None:
    """Make the folder ready, and find the faults of project and headings before any part is judged.

    Raises:
        AntriebError: Every fault of the project and of the headings.
        ValueError: The folder holds parts of another sweep.
    """
    out = pathlib.Path(spec.out)
    out.mkdir(parents=True, exist_ok=True)
    recordings: list[str] = []
    if all_parts:
        first = all_parts[0]
        one = first if first.file is not None else dataclasses.replace(first, count=1)
        recordings = _prepared(spec, _schema(one, tasks)).recordings
    manifest, path = _manifest(spec, all_parts, recordings), out / _MANIFEST
    if path.exists():
        there = json.loads(path.read_text(encoding="utf-8"))
        changed = sorted(key for key in manifest if there.get(key) != manifest[key])
        if changed:
            raise ValueError(f"{out} holds parts of another sweep: {', '.join(changed)} differ")
        return
    half = out / f".{_MANIFEST}.{uuid.uuid4().hex}"
    half.write_text(json.dumps(manifest, indent=2) + "\n", encoding="utf-8")
    os.replace(half, path)


def _schema(part: Part, tasks: Makes | None) -> Any:
    if part.file is not None:
        return _library("pyarrow.parquet").read_schema(part.file)
    return _read(part, tasks).schema


def _on_one_core(spec: Spec, part: Part, tasks: Makes | None) -> dict[str, Any]:
    """A part in a worker that has one core: its rows follow each other."""
    # Read when the first rows of the process are judged.
    os.environ.setdefault("RAYON_NUM_THREADS", "1")
    return judge(spec, part, tasks)


def sweep(
    text: Text,
    tasks: Tasks,
    out: Path,
    *,
    lang: Lang = "en",
    rows: int | None = None,
    part_rows: int = 100_000,
    axis: str | None = None,
    check: answers.CheckId | Sequence[answers.CheckId] = (),
    front: bool = False,
    file: str | None = None,
    folder: Path | None = None,
    address: str | None = None,
    window: int | None = None,
    retries: int = 5,
    progress: Callable[[Summary, int], None] | None = None,
) -> Summary:
    """Judge a table in parts on a Ray cluster, or on all cores of this machine; resumes what an earlier call left.

    Args:
        text: The project as text, or the path of its file.
        tasks: A function that makes the tasks of a part from the id of its first and their number, or the Parquet files that
            hold them. Headings are those of `antrieb.sweep`.
        out: The folder of the answers, one Parquet file for each part; on a cluster where every worker sees it.
        lang: Language of the reasons: `en` or `de`.
        rows: How many tasks a function makes.
        part_rows: Rows of a part: some seconds of work for one core.
        axis: Only this axis of a project with several.
        check: Checks whose verdicts are wanted, as in `antrieb.sweep`.
        front: The actuators that no other beats, as in `antrieb.sweep`.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie, on every worker; without it the current folder.
        address: The Ray cluster (`auto` for the one this runs in); without it a running one, else this machine.
        window: How many parts are under way at once; without it four for each core.
        retries: How often a part is tried again whose worker was lost.
        progress: Called after each part with the summary so far and the number of parts.

    Returns:
        A summary: rows, how many fit, why rows failed.

    Raises:
        AntriebError: Every fault of the project and of the headings, before any part is judged.
        ValueError: The folder holds parts of another sweep.
    """
    # It would report its use to its makers.
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    engine = _library("ray")
    begin = time.monotonic()
    spec = specified(text, out, lang=lang, axis=axis, check=check, front=front, file=file, folder=folder)
    makes = tasks if callable(tasks) else None
    all_parts = list(parts(tasks, rows=rows, part_rows=part_rows))
    ready(spec, all_parts, makes)
    summary = Summary()
    if not engine.is_initialized():
        engine.init(address=address, include_dashboard=False, log_to_driver=False)
    most = window or 4 * max(1, int(engine.cluster_resources().get("CPU", 1)))
    remote = engine.remote(num_cpus=1, max_retries=retries)(_on_one_core)
    # Once for all parts: the function and the project travel to each node only once.
    shared, made_by = engine.put(spec), engine.put(makes)
    waiting = iter(all_parts)
    pending: list[Any] = []
    while True:
        for part in waiting:
            pending.append(remote.remote(shared, part, made_by))
            if len(pending) >= most:
                break
        if not pending:
            break
        done, pending = engine.wait(pending, num_returns=1)
        summary.add(engine.get(done[0]))
        if progress is not None:
            progress(summary, len(all_parts))
    summary.seconds = time.monotonic() - begin
    return summary
