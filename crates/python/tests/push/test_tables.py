"""Tables as they come, labels of rows, progress, and calls with wrong values: each names the argument and what to write."""

from __future__ import annotations

import array
import asyncio
import collections
import concurrent.futures
import dataclasses
import multiprocessing
import os
import pathlib
import pickle
import signal
import threading
import time
import typing
import unittest

import duckdb
import pyarrow as pa

import antrieb
from antrieb.examples import ARM

INERTIA = "mechanism.arm.inertia [kg m^2]"
TIME = "motion[1].time [s]"
COLUMNS: dict[str, list[typing.Any]] = {"id": ["a", "b", "c"], INERTIA: [0.5, 1.0, 2.0], TIME: [0.8, 1.0, 1.2]}
ROWS = [dict(zip(COLUMNS, row, strict=True)) for row in zip(*COLUMNS.values(), strict=True)]
CODE = "CHA-25A-50-H-C1024"
EXAMPLES = pathlib.Path(__file__).resolve().parents[4] / "examples"


class Kinds(unittest.TestCase):
    """Every kind of table has one answer."""

    def test_every_kind_of_table_is_answered_alike(self) -> None:
        row = collections.namedtuple("row", ["a", "b", "c"])  # type: ignore[misc]  # noqa: PYI024

        @dataclasses.dataclass
        class Task:
            id: str

        expected = antrieb.sweep(ARM, antrieb.Table.from_pydict(COLUMNS))
        whole = pa.table(COLUMNS)
        kinds: dict[str, typing.Any] = {
            "dict": COLUMNS,
            "tuples": {name: tuple(values) for name, values in COLUMNS.items()},
            "arrays": {**COLUMNS, TIME: array.array("d", COLUMNS[TIME])},
            "dicts": ROWS,
            "generator": (each for each in ROWS),
            "pyarrow": whole,
            "chunks": pa.concat_tables([whole.slice(0, 1), whole.slice(1)]),
            "batch": whole.to_batches()[0],
            "dictionary": whole.set_column(0, "id", whole["id"].dictionary_encode()),
            "relation": duckdb.connect().from_arrow(whole),
        }
        for name, table in kinds.items():
            with self.subTest(name):
                found = antrieb.sweep(ARM, table)
                self.assertEqual(found.to_pydict(), expected.to_pydict())
        self.assertEqual(expected["id"], COLUMNS["id"])
        with self.assertRaisesRegex(ValueError, "inertia|unknown|no key|`id`|`a`"):
            antrieb.sweep(ARM, [Task("a")])
        with self.assertRaises(ValueError):
            antrieb.sweep(ARM, [row(1, 2, 3)])

    def test_labels_and_inputs_are_repeated(self) -> None:
        labels = antrieb.sweep(ARM, COLUMNS, check="thermal")
        self.assertEqual(labels["id"], [COLUMNS["id"][row] for row in labels["row"]])
        self.assertNotIn(TIME, labels.column_names)
        inputs = antrieb.sweep(ARM, COLUMNS, inputs=True)
        for name, values in COLUMNS.items():
            self.assertEqual(inputs[name], values)
        sweep = antrieb.Sweep(ARM, COLUMNS, inputs=True)
        self.assertEqual(sweep.carried, list(COLUMNS))
        again = pickle.loads(pickle.dumps(sweep))
        self.assertEqual(again.table(COLUMNS), inputs)
        self.assertEqual(again.batch(ROWS[1:], 1).to_dicts(), inputs.to_dicts()[1:])

    def test_a_number_that_is_none_is_an_empty_cell(self) -> None:
        nan = float("nan")
        kinds: list[typing.Any] = [
            {INERTIA: [1.0, nan]},
            {INERTIA: [1.0, None]},
            [{INERTIA: 1.0}, {INERTIA: nan}],
            [{INERTIA: 1.0, TIME: 1.0}, {TIME: 1.0}],
            pa.table({INERTIA: [1.0, nan]}),
            pa.table({INERTIA: pa.array([1.0, None])}),
        ]
        for table in kinds:
            with self.assertRaises(antrieb.AntriebError) as caught:
                antrieb.sweep(ARM, table)
            fault = caught.exception.faults[0]
            self.assertEqual((fault.id, getattr(fault, "heading"), getattr(fault, "row")), ("no_value", INERTIA, 1))

    def test_tables_are_shown_compared_and_iterated(self) -> None:
        table = antrieb.sweep(ARM, COLUMNS)
        self.assertEqual(table, antrieb.sweep(ARM, ROWS))
        self.assertNotEqual(table, antrieb.sweep(ARM, ROWS[:2]))
        self.assertNotEqual(table, 1)
        self.assertEqual([row["id"] for row in table], COLUMNS["id"])
        self.assertEqual(table[-1]["id"], "c")
        self.assertLessEqual(len(repr(antrieb.sweep(ARM, ROWS * 9)).split("\n")), 20)
        self.assertIn("<table>", table._repr_html_())
        with self.assertRaises(IndexError):
            table[3]
        with self.assertRaisesRegex(KeyError, "utilisation"):
            table["utilization"]

    def test_rows_and_columns_are_those_of_lists(self) -> None:
        library = pa.table({"id": [f"r{at}" for at in range(23)], INERTIA: [0.5] * 23}).to_batches(max_chunksize=5)
        table = antrieb.sweep(ARM, pa.Table.from_batches(library), inputs=True)
        rows = table.to_dicts()
        for at in range(-len(rows), len(rows)):
            self.assertEqual(table[at], rows[at])
        bounds = [None, *range(-25, 26, 5)]
        for begin in bounds:
            for end in bounds:
                for step in (None, -7, -1, 1, 2, 30):
                    self.assertEqual(table[begin:end:step], rows[begin:end:step])
        for heading, values in table.to_pydict().items():
            self.assertEqual(table[heading], values)


def _dates(count: int) -> bytes:
    """A stream of Arrow with a column of dates."""
    sink = pa.BufferOutputStream()
    table = pa.table({"day": pa.array(range(count), pa.int32()).cast(pa.date32())})
    with pa.ipc.new_stream(sink, table.schema) as writer:
        writer.write_table(table)
    return sink.getvalue().to_pybytes()


class Work(unittest.TestCase):
    """Progress, interrupts, threads and processes."""

    def test_the_progress_counts_rows(self) -> None:
        seen: list[tuple[int, int]] = []
        antrieb.sweep(ARM, ROWS * 20, progress=lambda done, every: seen.append((done, every)))
        self.assertEqual(seen[-1], (60, 60))
        self.assertEqual([done for done, _ in seen], sorted(done for done, _ in seen))
        with self.assertRaisesRegex(TypeError, "progress is"):
            antrieb.sweep(ARM, ROWS, progress=typing.cast(typing.Any, "yes"))

    def test_an_exception_of_the_progress_ends_the_work(self) -> None:
        def stop(done: int, every: int) -> None:
            raise LookupError(f"{done} of {every}")

        begin = time.monotonic()
        with self.assertRaisesRegex(LookupError, "of 3000"):
            antrieb.sweep(ARM, ROWS * 1000, progress=stop)
        self.assertLess(time.monotonic() - begin, 10.0)

    @unittest.skipIf(os.name == "nt", "signals of another kind")
    def test_an_interrupt_is_answered_at_once_everywhere(self) -> None:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        tolerant = EXAMPLES / "tolerances.toml"
        # Rows are counted when the table is read, however long that takes.
        is_judging = threading.Event()
        calls: dict[str, typing.Callable[[], object]] = {
            "sweep": lambda: antrieb.sweep(ARM, ROWS * 10_000, progress=lambda *_: is_judging.set()),
            "report": lambda: [antrieb.report(ARM) for _ in range(50)],
            "size": lambda: antrieb.size(tolerant, all=True, samples=1_000_000, deadline="600 s"),
            "simulate": lambda: [antrieb.simulate(ARM, CODE, cycles=20) for _ in range(50)],
        }
        for name, call in calls.items():
            with self.subTest(name):
                at: list[float] = []

                def interrupt(at: list[float] = at, name: str = name) -> None:
                    if name == "sweep":
                        is_judging.wait(60.0)
                    at.append(time.monotonic())
                    os.kill(os.getpid(), signal.SIGINT)

                threading.Timer(0.5, interrupt).start()
                with self.assertRaises(KeyboardInterrupt) as caught:
                    call()
                # 0.2 s is for a machine that does nothing else.
                self.assertLess(time.monotonic() - at[0], 1.0)
                if name == "sweep":
                    self.assertIn("of 30000 rows", "".join(caught.exception.__notes__))

    @unittest.skipIf(os.name == "nt", "signals of another kind")
    def test_a_conversion_checks_for_an_interrupt_every_few_thousand_values(self) -> None:
        count = 400_000
        columns = {"number": [0.5] * count, "text": ["a"] * count, "whole": list(range(count))}
        table = antrieb.Table.from_pydict(columns)
        dates = antrieb.Table.unpacked(_dates(count // 10))
        calls: dict[str, tuple[int, typing.Callable[[], object]]] = {
            "to_pydict": (3 * count, table.to_pydict),
            "column": (count, lambda: table["number"]),
            "dates": (count // 10, dates.to_pydict),
            "from_pydict": (3 * count, lambda: antrieb.Table.from_pydict(columns)),
            "iterated": (count, lambda: antrieb.Table.from_pydict({"number": range(count)})),
        }
        for name, (values, call) in calls.items():
            with self.subTest(name):
                looks: list[None] = []
                before = signal.signal(signal.SIGALRM, lambda *_: looks.append(None))
                try:
                    # More often than the conversion checks.
                    signal.setitimer(signal.ITIMER_REAL, 20e-6, 20e-6)
                    call()
                finally:
                    signal.setitimer(signal.ITIMER_REAL, 0.0)
                    signal.signal(signal.SIGALRM, before)
                self.assertGreater(len(looks), values / 4096 / 4)

        def stop(*_: object) -> None:
            raise KeyboardInterrupt

        before = signal.signal(signal.SIGALRM, stop)
        try:
            signal.setitimer(signal.ITIMER_REAL, 1e-3)
            # No fault of a column.
            with self.assertRaises(KeyboardInterrupt):
                while True:
                    antrieb.Table.from_pydict(columns)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
            signal.signal(signal.SIGALRM, before)

    def test_threads_and_tasks_answer_alike(self) -> None:
        expected = antrieb.sweep(ARM, ROWS)
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            self.assertTrue(all(found == expected for found in pool.map(lambda _: antrieb.sweep(ARM, ROWS), range(8))))

        async def tasks() -> list[antrieb.Table]:
            return list(await asyncio.gather(*(asyncio.to_thread(antrieb.sweep, ARM, ROWS) for _ in range(4))))

        self.assertTrue(all(found == expected for found in asyncio.run(tasks())))

    def test_processes_of_every_kind_answer_alike(self) -> None:
        expected = antrieb.sweep(ARM, ROWS)
        sweep = antrieb.Sweep(ARM, ROWS)
        for method in multiprocessing.get_all_start_methods():
            with self.subTest(method), multiprocessing.get_context(method).Pool(2) as pool:
                self.assertEqual(pool.map_async(sweep.table, [ROWS, COLUMNS]).get(timeout=120), [expected, expected])


if __name__ == "__main__":
    unittest.main()
