"""The memory of a sweep of files: it does not grow with the table."""

from __future__ import annotations

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import pyarrow as pa
import pyarrow.parquet as pq

from antrieb import examples

ARM = examples.ARM.to_toml()

MOST_BYTES = 500 << 20
PART = 50_000
# A row with a code costs the checks of one actuator.
CODES = ["CHA-25A-50-H-C1024", "CHA-32A-100-H-C1024", "CHA-20A-100-H-C1024"]


def written(path: pathlib.Path, rows: int) -> None:
    """A table of tasks, a part at a time."""
    writer: pq.ParquetWriter | None = None
    for first in range(0, rows, PART):
        ids = range(first, min(first + PART, rows))
        part = pa.table(
            {
                "motion[1].payload [kg]": [(each * 7919 % 1000) / 80 for each in ids],
                "motion[1].time [s]": [0.5 + (each * 104729 % 997) / 997 for each in ids],
                "code": [CODES[each % len(CODES)] for each in ids],
            }
        )
        writer = writer or pq.ParquetWriter(path, part.schema)
        writer.write_table(part)
    if writer:
        writer.close()


class Memory(unittest.TestCase):
    """The command in a process of its own."""

    def peak(self, folder: pathlib.Path, rows: int) -> int:
        """Bytes that the command takes at most for a table of so many rows."""
        tasks, best = folder / f"tasks-{rows}.parquet", folder / f"best-{rows}.parquet"
        written(tasks, rows)
        project = folder / "arm.toml"
        project.write_text(ARM, encoding="utf-8")
        words = ["sweep", str(project), "--table", str(tasks), "--out", str(best)]
        # Opened for writing alone: `subprocess.DEVNULL` is open for both and taken for an output that was closed.
        with open(os.devnull, "w", encoding="utf-8") as null:
            process = subprocess.Popen([sys.executable, "-m", "antrieb", *words], stdout=null)
            _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        self.assertEqual(pq.read_metadata(best).num_rows, rows)
        print(f"{rows} rows: {usage.ru_maxrss / 1024:.0f} MB, {usage.ru_utime + usage.ru_stime:.1f} s of processor time", flush=True)
        return usage.ru_maxrss * 1024

    def test_a_long_table_takes_the_memory_of_a_short_one(self) -> None:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            short, long = self.peak(folder, 100_000), self.peak(folder, 1_000_000)
            self.assertLess(long, MOST_BYTES)
            # Ten times the rows: what grows with them would be more than this.
            self.assertLess(long - short, 64 << 20)


if __name__ == "__main__":
    unittest.main()
