"""The libraries of tables: each hands over its tables, and takes the answers, without another between."""

from __future__ import annotations

import unittest
from typing import Any

import duckdb
import numpy as np
import pandas as pd
import pint
import polars as pl
import pyarrow as pa

import antrieb
from antrieb import examples

ARM = examples.ARM.to_toml()

COLUMNS = {"motion[1].payload [kg]": [0.5, 2.0, 4.0, 9.0], "motion[1].time [s]": [0.6, 0.8, 1.0, 1.2]}


class Libraries(unittest.TestCase):
    """In and out."""

    def test_each_gives_and_takes_a_table(self) -> None:
        expected = antrieb.sweep(ARM, antrieb.Table.from_pydict(COLUMNS)).to_pydict()
        given = {
            "pyarrow": pa.table(COLUMNS),
            "polars": pl.DataFrame(COLUMNS),
            "pandas": pd.DataFrame(COLUMNS),
            "duckdb": duckdb.connect().from_df(pd.DataFrame(COLUMNS)),
        }
        for name, table in given.items():
            with self.subTest(name):
                found = antrieb.sweep(ARM, table)
                self.assertEqual(found.to_pydict(), expected)
                self.assertEqual(pa.table(found).to_pydict(), expected)
                self.assertEqual(pl.DataFrame(found).to_dict(as_series=False), expected)
                taken = pd.DataFrame.from_arrow(found)
                self.assertEqual(taken["code"].tolist(), expected["code"])
                answered = duckdb.connect().from_arrow(found).fetchall()
                self.assertEqual([row[2] for row in answered], expected["code"])

    def test_labels_and_empty_cells_are_those_of_every_library(self) -> None:
        inertia, columns = "mechanism.arm.inertia [kg m^2]", {"id": ["a", "b", "c", "d"], **COLUMNS}
        expected = antrieb.sweep(ARM, columns)
        frame, own = pd.DataFrame(columns), pl.DataFrame(columns)
        kinds = {
            "arrays": {name: np.array(values) for name, values in columns.items()},
            "series": {name: pd.Series(values) for name, values in columns.items()},
            "structured": np.rec.fromrecords(list(zip(*columns.values(), strict=True)), names=list(columns)),
            "index": frame.set_index("id"),
            "nullable": frame.convert_dtypes(),
            "category": frame.astype({"id": "category"}),
            "lazy": own.lazy(),
            "polars category": own.with_columns(pl.col("id").cast(pl.Categorical)),
        }
        for name, table in kinds.items():
            with self.subTest(name):
                self.assertEqual(antrieb.sweep(ARM, table).to_pydict(), expected.to_pydict())
        self.assertEqual(expected.to_pandas()["id"].tolist(), columns["id"])
        self.assertEqual(expected.to_polars()["id"].to_list(), columns["id"])
        empty = [
            pd.DataFrame({inertia: [1.0, np.nan]}),
            pd.DataFrame({inertia: [1.0, pd.NA]}),
            pl.DataFrame({inertia: [1.0, float("nan")]}),
            pl.DataFrame({inertia: [1.0, None]}),
            pl.DataFrame({inertia: pl.Series([None, None])}),
            {inertia: np.array([1.0, np.nan])},
            {inertia: np.ma.masked_array([1.0, 2.0], [False, True])},
        ]
        for table in empty:
            with self.assertRaises(antrieb.AntriebError) as caught:
                antrieb.sweep(ARM, table)
            self.assertEqual({fault.id for fault in caught.exception.faults}, {"no_value"})

    def test_labels_keep_their_types_and_their_index(self) -> None:
        time = "motion[1].time [s]"
        frame = pd.DataFrame(
            {
                time: [1.0, 1.1, 1.2, 1.3],
                "unsigned": np.array([2**64 - 1, 1, 2, 3], np.uint64),
                "small": np.array([1, 2, 3, 4], np.int8),
                "holes": pd.array([2**53 + 1, None, 1, 2], dtype="Int64"),
                "seen at": pd.to_datetime(["2020-01-01", None, "2021-01-01", "2022-01-01"]),
                "after": pd.to_timedelta([1, 2, 3, 4], unit="s"),
                "colour": pd.Categorical(["a", "b", "a", "b"]),
            }
        )
        found = antrieb.sweep(ARM, frame).to_pandas()
        self.assertNotIn("index", found)
        for title in frame.columns[1:]:
            with self.subTest(title):
                self.assertEqual(str(found[title].dtype).partition("[")[0], str(frame[title].dtype).partition("[")[0])
                same = found[title].isna() & frame[title].isna() | (found[title].astype(object) == frame[title].astype(object))
                self.assertTrue(same.fillna(True).all())
        parts = {
            "filter": frame[frame[time] > 1.1],
            "tail": frame.tail(2),
            "step": frame.iloc[::2],
            "reverse": frame.iloc[::-1],
        }
        sweep = antrieb.Sweep(ARM, frame)
        for name, part in parts.items():
            with self.subTest(name):
                self.assertEqual(antrieb.sweep(ARM, part)["index"], part.index.tolist())
                self.assertEqual(sweep.table(part)["unsigned"], part["unsigned"].tolist())

    def test_texts_of_quantities_are_read_from_categories(self) -> None:
        key, texts = "motion[1].time", ["0.8 s", "1.0 s", "0.8 s"]
        expected = antrieb.sweep(ARM, {f"{key} [s]": [0.8, 1.0, 0.8]})["utilisation"]
        given: dict[str, Any] = {
            "pandas": pd.DataFrame({key: pd.Categorical(texts)}),
            "polars": pl.DataFrame({key: pl.Series(texts, dtype=pl.Categorical)}),
            "polars enum": pl.DataFrame({key: pl.Series(texts, dtype=pl.Enum(["0.8 s", "1.0 s"]))}),
            "polars lazy": pl.LazyFrame({key: pl.Series(texts, dtype=pl.Categorical)}),
            "pyarrow": pa.table({key: pa.array(texts).dictionary_encode()}),
        }
        for name, table in given.items():
            with self.subTest(name):
                self.assertEqual(antrieb.sweep(ARM, table)["utilisation"], expected)

    def test_quantities_of_pint_are_read_or_refused(self) -> None:
        of = pint.UnitRegistry().Quantity
        key, heading = "motion.1.payload", "motion[1].payload [kg]"
        expected = antrieb.sweep(ARM, {heading: [1.0, 5.0]})
        scalars = [of(1.0, "kg"), of(5000.0, "g")]
        tables: list[Any] = [
            {key: scalars},
            [{key: each} for each in scalars],
            pd.DataFrame({key: scalars}),
            pl.DataFrame({key: pl.Series(scalars, dtype=pl.Object)}),
            {key: of(np.array([1.0, 5.0]), "kg")},
        ]
        for table in tables:
            with self.subTest(type(table)):
                self.assertEqual(antrieb.sweep(ARM, table), expected)
        refused: dict[str, Any] = {
            "30 degC": {"ambient": of(np.array([30.0]), "delta_degC")},
            "count": {key: of(np.array([1.0]), "count*kg")},
            "kg and lb": {key: [of(1.0, "kg"), of(1.0, "lb")]},
            "payload": {key: [of(1.0, "kg"), 1.0]},
            "unit is missing": {"motion.1.distance": of(np.array([0.5]), "dimensionless")},
        }
        for message, table in refused.items():
            with self.subTest(message), self.assertRaisesRegex((TypeError, ValueError), message):
                antrieb.sweep(ARM, table)
        for unit in ("dimensionless", "percent", "count", "count*degree"):
            with self.subTest(unit), self.assertRaisesRegex(antrieb.AntriebError, "Move.distance"):
                antrieb.Move("modified_sine", distance=of(0.5, unit), time="1 s")
        with self.assertRaisesRegex(antrieb.AntriebError, "Axis.ambient.*30 degC"):
            antrieb.Axis("tilt", examples.ARM.mechanism, examples.ARM.motion, ambient=of(30.0, "delta_degC"))
        times, angles = [of(0.0, "s"), of(1.0, "s")], [of(0.0, "deg"), of(1.0, "deg")]
        for trace in ({"time": times, "position": angles}, [{"time": at, "position": q} for at, q in zip(times, angles, strict=True)]):
            with self.assertRaisesRegex(antrieb.AntriebError, "trace: the trace lacks columns.*torque"):
                antrieb.identify(trace, ARM, "CHA-25A-50-H-C1024")
        with self.assertRaisesRegex((TypeError, ValueError), "one unit"):
            antrieb.identify({"position": [of(1.0, "deg"), of(1.0, "rad")]}, ARM, "CHA-25A-50-H-C1024")

    def test_answers_are_data_frames(self) -> None:
        (sizing,) = antrieb.size(ARM, all=True).axes
        codes = [each.code for each in sizing.candidates]
        self.assertEqual(sizing.candidates.to_pandas()["code"].tolist(), codes)
        self.assertEqual(sizing.candidates.to_polars()["code"].to_list(), codes)
        self.assertEqual(sizing.best.checks.to_pandas()["id"].tolist(), [check.id for check in sizing.best.checks])


if __name__ == "__main__":
    unittest.main()
