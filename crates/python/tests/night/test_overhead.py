"""The way through Python and Arrow: it adds at most 2 % to a sweep of 100 000 rows, and a longer table takes no more memory
for each row."""

from __future__ import annotations

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

BASELINE = pathlib.Path(__file__).resolve().parents[4] / "benches" / "baseline" / "sweep_python.py"
PROJECT = """format = 1
[load]
inertia = "1 kg m^2"
friction_torque = "5 N m"
[[motion]]
law = "trapezoid"
distance = "90 deg"
time = "0.5 s"
[[motion]]
law = "dwell"
time = "1 s"
"""
ROWS = 100_000
RUNS = 3
MOST_PERCENT = 2.0

CALLS = """
import resource, sys
import antrieb
project, rows, rounds = sys.argv[1], 2_000, 10
table = antrieb.Table.from_pydict({"motion[1].time [s]": [0.5 + row / rows for row in range(rows)]})
peaks = []
for _ in range(rounds):
    antrieb.sweep(project, table)
    peaks.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
print(peaks[1], peaks[-1])
"""


class Overhead(unittest.TestCase):
    """Processes of their own, each on one core."""

    def run_in_folder(self, script: list[str]) -> str:
        """What a script prints about the project."""
        with tempfile.TemporaryDirectory() as folder:
            project = pathlib.Path(folder, "axis.toml")
            project.write_text(PROJECT, encoding="utf-8")
            words = [sys.executable, *(str(project) if word == "PROJECT" else word for word in script)]
            found = subprocess.run(words, check=True, capture_output=True, text=True)
        print(found.stdout, end="", flush=True)
        return found.stdout

    def test_python_adds_little_to_a_sweep(self) -> None:
        kernel = os.environ.get("ANTRIEB_KERNEL")
        self.assertTrue(kernel, "ANTRIEB_KERNEL is the path of the example `kernel`, built for release")
        printed = self.run_in_folder([str(BASELINE), str(kernel), "PROJECT", str(ROWS), str(RUNS)])
        found = re.search(r"([+-][\d.]+) %", printed)
        assert found, printed
        self.assertLessEqual(float(found[1]), MOST_PERCENT)

    def test_repeated_sweeps_take_no_more_memory(self) -> None:
        second, last = map(int, self.run_in_folder(["-c", CALLS, "PROJECT"]).split())
        self.assertLess(last - second, 8 << 10)


if __name__ == "__main__":
    unittest.main()
