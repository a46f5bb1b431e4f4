"""The libraries of tables: each hands over its tables, and takes the answers, without another between."""

from __future__ import annotations

import unittest

import duckdb
import numpy as np
import pandas as pd
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

    def test_answers_are_data_frames(self) -> None:
        (sizing,) = antrieb.size(ARM, all=True).axes
        codes = [each.code for each in sizing.candidates]
        self.assertEqual(sizing.candidates.to_pandas()["code"].tolist(), codes)
        self.assertEqual(sizing.candidates.to_polars()["code"].to_list(), codes)
        self.assertEqual(sizing.best.checks.to_pandas()["id"].tolist(), [check.id for check in sizing.best.checks])


if __name__ == "__main__":
    unittest.main()
