"""Sweeps: any Arrow table in, an Arrow table out, with the verdicts and digits of `size`."""

from __future__ import annotations

import itertools
import math
import pathlib
import pickle
import random
import re
import signal
import tempfile
import threading
import time
import typing
import unittest

import duckdb
import pyarrow as pa
import pyarrow.parquet

import antrieb
from antrieb import distributed
from antrieb import examples

ARM = examples.ARM.to_toml()

INERTIA = "mechanism.arm.inertia [kg m^2]"
PAYLOAD = "motion[1].payload [kg]"
TIME = "motion[1].time [s]"


def columns(rows: int, seed: int) -> dict[str, list[float]]:
    """Random axes, the same for a seed."""
    chance = random.Random(seed)
    return {
        INERTIA: [round(chance.uniform(0.1, 2.0), 3) for _ in range(rows)],
        PAYLOAD: [round(chance.uniform(0.0, 12.0), 2) for _ in range(rows)],
        TIME: [round(chance.uniform(0.5, 2.0), 2) for _ in range(rows)],
    }


class Sweeps(unittest.TestCase):
    """The function and the object."""

    def test_verdicts_are_those_of_size(self) -> None:
        given = columns(12, 7)
        best = antrieb.sweep(ARM, antrieb.Table.from_pydict(given)).to_pydict()
        for row in range(12):
            project = (
                ARM.replace("0.55 kg m^2", f"{given[INERTIA][row]} kg m^2")
                .replace("2.5 kg", f"{given[PAYLOAD][row]} kg")
                .replace('"1.2 s"', f'"{given[TIME][row]} s"', 1)
            )
            (sizing,) = antrieb.size(project, top=1).axes
            with self.subTest(row):
                self.assertEqual(best["fit"][row], sizing.fit)
                self.assertEqual(best["fit_if_estimate"][row], sizing.fit_if_estimate)
                self.assertEqual(best["code"][row], sizing.answer)
                first = sizing.ranking[0] if sizing.ranking else None
                if sizing.answer and first and first.utilisation is not None:
                    self.assertEqual(float(f"{best['utilisation'][row]:.11e}"), first.utilisation)
                    self.assertEqual(best["tightest"][row], first.tightest)

    def test_every_kind_of_table_is_taken_and_handed_over(self) -> None:
        given = columns(16, 3)
        own = antrieb.Table.from_pydict(given)
        whole = pa.table(own)
        self.assertEqual(whole.to_pydict(), given)
        expected = antrieb.sweep(ARM, own).to_pydict()
        parts = pa.Table.from_batches(whole.to_batches(max_chunksize=7))
        tables = {
            "pyarrow": whole,
            "in parts": parts,
            "a batch": whole.combine_chunks().to_batches()[0],
            "a reader": pa.RecordBatchReader.from_batches(whole.schema, whole.to_batches()),
            "of texts": pa.table({name: [str(each) for each in values] for name, values in given.items()}),
            "duckdb": duckdb.connect().from_arrow(whole).to_arrow_table(),
        }
        for name, table in tables.items():
            with self.subTest(name):
                found = antrieb.sweep(ARM, table)
                self.assertEqual(found.to_pydict(), expected)
                self.assertEqual(pa.table(found).to_pydict(), expected)
                self.assertEqual(pa.schema(found).names, found.column_names)

    def test_a_part_is_the_same_as_in_the_whole(self) -> None:
        table = pa.table(antrieb.Table.from_pydict(columns(18, 5)))
        whole = pa.table(antrieb.sweep(ARM, table))
        prepared = antrieb.Sweep(ARM, table.schema)
        self.assertEqual(prepared.answers.column_names, whole.column_names)
        for first in range(0, 18, 8):
            part = table.slice(first, 8)
            self.assertTrue(pa.table(prepared.batch(part, first)).equals(whole.slice(first, 8).combine_chunks()))

    def test_every_actuator_and_the_front(self) -> None:
        table = antrieb.Table.from_pydict(columns(2, 1))
        every = antrieb.sweep(ARM, table, check=["peak_torque"])
        self.assertIn("peak_torque.verdict", every.column_names)
        self.assertEqual(len(every), 2 * 276)
        front = antrieb.sweep(ARM, table, front=True)
        self.assertIn("mass [kg]", front.column_names)

    def test_answers_beyond_the_memory_are_refused_before_the_work(self) -> None:
        checks = ["peak_torque", "thermal"]
        own = pa.table(antrieb.Table.from_pydict(columns(2, 1)))
        prepared = antrieb.Sweep(ARM, own.schema, check=checks, memory="1 MiB")
        most = prepared.rows_most
        self.assertGreater(most, 2)
        # 512 times the memory, and less than a row of the smaller one more.
        self.assertIn(antrieb.Sweep(ARM, own.schema, check=checks).rows_most, range(512 * most, 512 * (most + 1)))
        within, beyond = (antrieb.Table.from_pydict(columns(rows, 1)) for rows in (most, 400 * most))
        self.assertEqual(len(prepared.table(within)), most * 276)
        self.assertEqual(len(prepared.batch(within, 5)), most * 276)
        asked = (
            lambda: antrieb.sweep(ARM, beyond, check=checks, memory="1 MiB"),
            lambda: prepared.table(beyond),
            lambda: prepared.batch(beyond, 0),
        )
        begin = time.monotonic()
        for ask in asked:
            with self.assertRaisesRegex(antrieb.AntriebError, f"{400 * most} rows.*1 MiB.*at most {most} rows"):
                ask()
        self.assertLess(time.monotonic() - begin, 5.0)

    def test_a_part_of_a_cluster_is_answered_as_the_memory_allows(self) -> None:
        rows = 9
        table = pa.table(antrieb.Table.from_pydict(columns(rows, 4)))
        with tempfile.TemporaryDirectory() as folder:
            spec = distributed.specified(ARM, folder, check="peak_torque")
            makes = lambda first, count: table.slice(first, count)  # noqa: E731
            (part,) = distributed.parts(makes, rows=rows)
            real = antrieb.Sweep.rows_most
            try:
                antrieb.Sweep.rows_most = property(lambda self: 4)  # type: ignore[assignment, method-assign]
                summary = distributed.judge(spec, part, makes)
            finally:
                antrieb.Sweep.rows_most = real  # type: ignore[method-assign]
            found = pyarrow.parquet.read_table(part.path(folder))
            whole = pa.table(antrieb.sweep(ARM, table, check="peak_torque"))
            self.assertTrue(found.replace_schema_metadata(None).combine_chunks().equals(whole.combine_chunks()))
            self.assertEqual((summary["rows"], summary["failed"], summary["found"]), (rows, 0, False))
            self.assertEqual(summary["fitting"], sum(whole.column("fits").to_pylist()))
            self.assertEqual(distributed.judge(spec, part, makes), {**summary, "found": True})

    def test_a_row_that_cannot_be_judged_says_why(self) -> None:
        found = antrieb.sweep(ARM, antrieb.Table.from_pydict({TIME: [1.0, -1.0, 1.0]})).to_pydict()
        self.assertIsNone(found["error"][0])
        self.assertIsNotNone(found["error"][1])
        self.assertEqual(found["code"][0], found["code"][2])

    def test_an_empty_table_has_no_answers(self) -> None:
        empty = antrieb.sweep(ARM, pa.table({TIME: pa.array([], pa.float64())}))
        self.assertEqual(len(empty), 0)
        self.assertEqual(empty.column_names[0], "row")

    def test_every_fault_of_a_table_has_its_heading_and_row(self) -> None:
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.sweep(ARM, antrieb.Table.from_pydict({"motion[1].tyme [s]": [1.0], "motion[1].payload": [1.0]}))
        headings = [getattr(fault, "heading", None) for fault in caught.exception.faults]
        # The last one says that no row below was read, since no heading is a key.
        self.assertEqual(headings, ["motion[1].tyme [s]", "motion[1].payload", None])
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.sweep(ARM, pa.table({TIME: [1.0, None], PAYLOAD: ["heavy", "1"]}))
        places = [(getattr(fault, "heading", None), getattr(fault, "row", None)) for fault in caught.exception.faults]
        self.assertEqual(sorted(places, key=str), [(PAYLOAD, 0), (TIME, 1)])
        with self.assertRaises(antrieb.AntriebError):
            antrieb.sweep(ARM, pa.table({"code": ["CHA-20B-100-H-C1024"]}))
        # Cells below headings that are read are looked at beside wrong headings and a wrong project.
        wrong = pa.table({"motion[1].tyme [s]": [None, 1.0], TIME: [1.0, None], "code": ["CHA-99", "CHA-25A-50-H-C1024"]})
        for project, more in ((ARM, []), (ARM.replace("6 kg", "6 m"), ["unit_of_another_quantity"])):
            with self.assertRaises(antrieb.AntriebError) as caught:
                antrieb.sweep(project, wrong)
            found = [(getattr(fault, "heading", None), getattr(fault, "row", None)) for fault in caught.exception.faults]
            expected = [(None, None)] * len(more) + [("motion[1].tyme [s]", None), (TIME, 1), ("code", 0)]
            self.assertEqual(found, expected)
            self.assertEqual([getattr(fault, "id", None) for fault in caught.exception.faults][: len(more)], more)
        prepared = antrieb.Sweep(ARM, pa.table({TIME: [1.0]}).schema)
        with self.assertRaises(antrieb.AntriebError):
            prepared.table(pa.table({TIME: [1.0, None]}))
        with self.assertRaises(antrieb.AntriebError):
            antrieb.sweep(ARM, antrieb.Table.from_pydict({TIME: [1.0]}), check=["peak_torqe"])  # type: ignore[list-item]

    def test_a_folder_belongs_to_its_tasks_and_recordings(self) -> None:
        samples = "".join(f"{step / 50:.2f},{45 - 45 * math.cos(math.pi * step / 50):.6f}\n" for step in range(101))
        recorded = (
            'format = 1\n[load]\ninertia = "1 kg m^2"\nfriction_torque = "5 N m"\n'
            '[[motion]]\nlaw = "recorded"\nfile = "turn.csv"\n'
        )
        with tempfile.TemporaryDirectory() as folder:
            here = pathlib.Path(folder)
            turn, tasks = here / "turn.csv", here / "tasks.parquet"
            turn.write_text(f"time [s],position [deg]\n{samples}", encoding="utf-8")
            pyarrow.parquet.write_table(pa.table({"load.inertia [kg m^2]": [1.0, 2.0]}), tasks)
            (here / "axis.toml").write_text(recorded, encoding="utf-8")
            spec = distributed.specified(here / "axis.toml", here / "out")
            all_parts = list(distributed.parts(tasks))
            distributed.ready(spec, all_parts)
            distributed.ready(spec, all_parts)
            before = turn.read_bytes()
            turn.write_text(f"time [s],position [deg]\n{samples.replace('90.0', '89.0')}", encoding="utf-8")
            with self.assertRaisesRegex(ValueError, "recordings"):
                distributed.ready(spec, all_parts)
            turn.write_bytes(before)
            distributed.ready(spec, all_parts)
            pyarrow.parquet.write_table(pa.table({"load.inertia [kg m^2]": [1.0, 3.0]}), tasks)
            with self.assertRaisesRegex(ValueError, "tasks"):
                distributed.ready(spec, all_parts)

    def test_later_tables_are_read_by_their_headings(self) -> None:
        given: dict[str, list[typing.Any]] = {"id": ["a", "b"], PAYLOAD: [1.0, 5.0], TIME: [0.9, 1.1]}
        expected = antrieb.sweep(ARM, given)
        sweep = antrieb.Sweep(ARM, given)
        for order in itertools.permutations(given):
            own = {heading: given[heading] for heading in order}
            for table in (own, antrieb.Table.from_pydict(own), pa.table(own), pa.table(own).to_batches()[0]):
                with self.subTest(f"{order} {type(table)}"):
                    self.assertEqual(sweep.table(table), expected)
                    self.assertEqual(sweep.batch(table), expected)
                    self.assertEqual(pickle.loads(pickle.dumps(sweep)).table(table), expected)
        short = {"id": ["a", "b"], "motion.1.payload": antrieb.q([1, 5], "kg"), "motion.1.time": ["0.9 s", "1.1 s"]}
        self.assertEqual(sweep.table(short), expected)
        other = {heading: values for heading, values in given.items() if heading != PAYLOAD}
        wrong: dict[str, dict[str, list[typing.Any]]] = {
            r"'motion\[1\].payload \[g\]'.*'motion\[1\].payload \[kg\]'": {**other, "motion[1].payload [g]": [1.0, 5.0]},
            "'banana'": {**other, "banana": [1.0, 5.0]},
            r"'motion\[1\].payload \[kg\]'.*missing": other,
            "'size' is none": {**given, "size": ["x", "y"]},
            r"'motion\[1\].time \[s\]'.*missing": {},
            "'id'.*Int64.*Utf8": {**given, "id": [1, 2]},
        }
        for message, table in wrong.items():
            for ask in (sweep.table, sweep.batch, lambda table: sweep.table(pa.table(table))):
                with self.subTest(message), self.assertRaisesRegex(antrieb.AntriebError, message):
                    ask(table)

    def test_headings_have_one_form_in_every_kind_of_table(self) -> None:
        axis = antrieb.Axis(
            "tilt",
            antrieb.Arm(mass="30 kg", length="1.2 m"),
            [antrieb.Move("modified_sine", distance="90 deg", time="0.8 s", payload="5 kg"), antrieb.Return(time="0.6 s")],
            supply="560 V",
        )
        short: dict[str, list[typing.Any]] = {
            "motion.1.payload [kg]": [1.0, 5.0],
            "motion.1.distance [deg]": [60.0, 80.0],
            "supply [V]": [560.0, 48.0],
            "mechanism.mass [kg]": [20.0, 30.0],
            "brake": ["true", "false"],
        }
        expected = antrieb.sweep(axis, short)
        self.assertNotIn("brake", expected.column_names)
        self.assertEqual(len(set(expected["utilisation"])), 2)
        rows = [dict(zip(short, row, strict=True)) for row in zip(*short.values(), strict=True)]
        own = pa.table(short)
        tables: list[typing.Any] = [
            rows, own, own.to_batches()[0], own.to_reader(), antrieb.Table.from_pydict(short), duckdb.connect().from_arrow(own),
        ]
        for table in tables:
            with self.subTest(type(table)):
                self.assertEqual(antrieb.sweep(axis, table), expected)
        for table in (short, rows, own, own.schema):
            self.assertEqual(antrieb.Sweep(axis, table).table(rows), expected)

    def test_a_grid_repeats_the_keys(self) -> None:
        found = antrieb.sweep(ARM, {"motion.1.payload": antrieb.q([1, 5], "kg"), "motion.1.time": ["0.9 s", "1.1 s"]}, grid=True)
        self.assertEqual(found[PAYLOAD], [1.0, 1.0, 5.0, 5.0])
        self.assertEqual(found[TIME], [0.9, 1.1, 0.9, 1.1])
        for wrong in ("no", 1, None):
            with self.assertRaisesRegex(TypeError, "grid"):
                antrieb.sweep(ARM, {TIME: [1.0]}, grid=wrong)  # type: ignore[arg-type]

    def test_whole_numbers_are_kept_or_refused(self) -> None:
        for kept in ([1 << 63, 1], [(1 << 64) - 1, None], [(1 << 53) + 1, None], [-(1 << 63), 1]):
            for table in ({TIME: [1.0, 1.0], "id": kept}, [{TIME: 1.0, "id": each} for each in kept]):
                self.assertEqual(antrieb.sweep(ARM, table)["id"], kept)
        for lost in ([1 << 64, 1], [1 << 63, -1], [(1 << 53) + 1, 0.5], [-(1 << 63) - 1]):
            with self.subTest(str(lost)), self.assertRaisesRegex(TypeError, "'id'.*texts"):
                antrieb.sweep(ARM, {TIME: [1.0] * len(lost), "id": lost})

    def test_a_label_that_may_be_a_key_is_refused_with_a_name_for_it(self) -> None:
        for title in ("name", "mass", "time [s]", "payload", "inertia", "duration"):
            for ask in (antrieb.sweep, antrieb.Sweep):
                with self.subTest(title), self.assertRaises(antrieb.AntriebError) as caught:
                    ask(ARM, {TIME: [1.0], title: ["a"]})
                found = re.search('call the column "(.*)"', str(caught.exception))
                assert found
                self.assertEqual(antrieb.sweep(ARM, {TIME: [1.0], found[1]: ["a"]})[found[1]], ["a"])

    def test_rows_are_taken_by_slices(self) -> None:
        table = antrieb.sweep(ARM, {TIME: [1.0, 1.1, 1.2]})
        self.assertEqual([row["row"] for row in table[1:]], [1, 2])
        with self.assertRaisesRegex(TypeError, "heading"):
            table[1.5]

    def test_what_is_no_table_is_refused(self) -> None:
        for wrong in ([1.0], pa.array([1.0]), None):
            with self.subTest(type(wrong)), self.assertRaises(TypeError):
                antrieb.sweep(ARM, wrong)  # type: ignore[arg-type]
        # Columns by their keys are a table; this one has no such key.
        with self.assertRaises(antrieb.AntriebError):
            antrieb.sweep(ARM, {"a": [1.0]})
        with self.assertRaises(ValueError):
            antrieb.Table.from_pydict({"a": [1.0], "b": []})

    def test_an_interrupt_ends_a_sweep(self) -> None:
        # A shell starts what runs in the background with interrupts ignored.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        table = antrieb.Table.from_pydict(columns(20_000, 2))
        threading.Timer(0.5, signal.raise_signal, [signal.SIGINT]).start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            antrieb.sweep(ARM, table)
        self.assertLess(time.monotonic() - begin, 30.0)


if __name__ == "__main__":
    unittest.main()
