"""Writes the recordings of this folder with tools that have nothing to do with antrieb.

Written with Python 3.11, pandas 3.1.1, polars 2.1.0, pyarrow 26.0.1, numpy 2.4.6; run inside this folder:

    pip install pandas polars pyarrow numpy && python make.py

All hold the same motion, 200 samples at 1 kHz from t = 5 s: the angle 90 (1 - cos(2 pi 5 (t - 5))) deg and the torque
3 + 2 sin(2 pi 5 (t - 5)) Nm. The tests compute it again from this sentence.
"""

import csv
import datetime

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pyarrow.parquet as pq

step = np.arange(200)
phase = 2 * np.pi * 5 * step / 1000
angle = 90 * (1 - np.cos(phase))
torque = 3 + 2 * np.sin(phase)
note = ["run"] * 200

# pandas, snappy: doubles, a text column between them.
pd.DataFrame({"time [ms]": 5000 + step, "note": note, "q [deg]": angle, "tau [Nm]": torque}).to_parquet(
    "pandas_snappy.parquet", compression="snappy", index=False
)

# polars, zstd: a datetime column says its own unit; floats of 32 bits; units of the others from the layout.
pl.DataFrame(
    {
        "timestamp": pl.Series(5_000_000 + 1000 * step).cast(pl.Datetime("us")),
        "q": pl.Series(angle),
        "tau": pl.Series(torque.astype(np.float32)),
    }
).write_parquet("polars_zstd.parquet", compression="zstd")

# pyarrow, gzip, four row groups: units in the metadata of the file.
table = pa.table({"t": 5.0 + step / 1000, "q": angle, "tau": torque})
table = table.replace_schema_metadata({"t.unit": "s", "unit:q": "deg", "tau.unit": "Nm"})
pq.write_table(table, "pyarrow_gzip.parquet", compression="gzip", row_group_size=64)

# pyarrow, a null in row 3 and a list column.
pq.write_table(
    pa.table({"t [s]": [0.0, 0.1, 0.2, 0.3], "q [deg]": [0.0, 1.0, None, 3.0], "x": [[1.0], [2.0], [3.0], [4.0]]}),
    "pyarrow_null.parquet",
    compression="none",
)

# pyarrow, brotli: a compression that is not supported.
pq.write_table(table, "pyarrow_brotli.parquet", compression="brotli")

# pyarrow, lz4, pages of the second version without dictionaries: the other encodings of numbers.
table = pa.table({"t [ms]": 5000 + step, "q [deg]": angle, "tau [Nm]": torque.astype(np.float32)})
encodings = {"t [ms]": "DELTA_BINARY_PACKED", "q [deg]": "BYTE_STREAM_SPLIT", "tau [Nm]": "PLAIN"}
pq.write_table(
    table,
    "pyarrow_lz4_v2.parquet",
    compression="lz4",
    data_page_version="2.0",
    use_dictionary=False,
    column_encoding=encodings,
)

# pyarrow, one row more than is kept: told before a row is read, so that all of them may be zero.
zeros = np.zeros(2**24 + 1)
pq.write_table(pa.table({"t [s]": zeros, "q [deg]": zeros}), "pyarrow_too_many.parquet", compression="zstd", row_group_size=2**25, max_rows_per_page=2**25)

# The csv module in the dialect of Excel, CRLF, and pandas with the German signs and a byte order mark.
with open("python_excel.csv", "w", newline="") as file:
    writer = csv.writer(file)
    writer.writerow(["time", "note", "q", "tau"])
    writer.writerow(["s", "", "deg", "Nm"])
    for k in range(200):
        writer.writerow([5.0 + k / 1000, 'cut "a", run', float(angle[k]), float(torque[k])])
pd.DataFrame({"Zeit [ms]": 5000.0 + step, "Winkel [deg]": angle, "Drehmoment [Nm]": torque}).round(9).to_csv(
    "pandas_german.csv", sep=";", decimal=",", index=False, encoding="utf-8-sig"
)

# Durations: plain integers of Parquet, of which the schema of Arrow beside them says what they are.
for unit, each in (("s", None), ("ms", 10**3), ("us", 10**6), ("ns", 10**9)):
    ticks = [0, 1, 2, 3] if each is None else [int(each * k * 0.005) for k in range(4)]
    held = {"time": pa.array(ticks, pa.duration(unit)), "q [deg]": [0.0, 0.25, 1.5, 2.0], "note": ["a"] * 4}
    pq.write_table(pa.table(held), f"pyarrow_duration_{unit}.parquet", compression="none", use_dictionary=False)
spans = [datetime.timedelta(milliseconds=5 * k) for k in range(4)]
pl.DataFrame({"q [deg]": [0.0, 0.25, 1.5, 2.0], "time": spans}).write_parquet("polars_duration.parquet")
index = pd.to_timedelta([0, 5, 10, 15], unit="ms").rename("time")
pd.DataFrame({"q [deg]": [0.0, 0.25, 1.5, 2.0]}, index=index).to_parquet("pandas_timedelta.parquet")

# Types that hold no numbers or numbers that are not read, each in a torque that is not needed.
plain = {"t [s]": [0.0, 0.1, 0.2, 0.3], "q [deg]": [0.0, 1.0, 1.5, 3.0]}
pl.DataFrame({**plain, "torque [Nm]": pl.Series([None] * 4, dtype=pl.Null)}).write_parquet("polars_nulls.parquet")
pl.DataFrame({**plain, "torque [Nm]": pl.Series([1, 2, 3, 4], dtype=pl.Int128)}).write_parquet("polars_int128.parquet")
half = pa.array(np.array([1.0, 2.0, 3.0, 4.0], dtype=np.float16))
pq.write_table(pa.table({**plain, "torque [Nm]": half}), "pyarrow_float16.parquet", compression="none")
