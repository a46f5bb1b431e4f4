"""The libraries of tables: each hands over its tables, and takes the answers, without another between."""

from __future__ import annotations

import unittest

import duckdb
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


if __name__ == "__main__":
    unittest.main()
