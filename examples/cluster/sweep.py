"""A sweep on the cluster that this runs in: `python sweep.py --out FOLDER`, by job submission or on one machine.

Each task is made from its number alone: payload, reach and time of a move on a grid of a thousand steps each, so that a whole
sweep has 10⁹ tasks. The folder lies where every worker sees it; the same call again goes on where it ended.
"""

from __future__ import annotations

import argparse
import pathlib
import sys

import numpy as np
import pyarrow as pa
from antrieb import distributed

STEPS = 1000


def tasks(first: int, count: int) -> pa.Table:
    """The tasks of a part."""
    number = np.arange(first, first + count, dtype=np.int64)
    payload, reach, time = number % STEPS, number // STEPS % STEPS, number // STEPS**2 % STEPS
    return pa.table(
        {
            "motion[1].payload [kg]": payload * (10.0 / STEPS),
            "mechanism.arm.payload_distance [mm]": 200.0 + reach * (500.0 / STEPS),
            "motion[1].time [s]": 0.5 + time * (1.5 / STEPS),
        }
    )


def reported(summary: distributed.Summary, parts: int) -> None:
    """A line now and then."""
    if summary.parts % max(1, parts // 100) == 0:
        print(f"{summary.parts} of {parts} parts, {summary.rows} rows, {summary.failed} failed", flush=True)


def main() -> int:
    """Run it."""
    words = argparse.ArgumentParser(description=__doc__)
    words.add_argument("--out", required=True, help="the folder of the answers")
    words.add_argument("--rows", type=int, default=STEPS**3, help="how many tasks (10⁹)")
    words.add_argument("--part-rows", type=int, default=100_000, help="rows of a part (100000)")
    words.add_argument("--address", default=None, help="the cluster; auto for the one that this runs in")
    asked = words.parse_args()
    project = pathlib.Path(__file__).with_name("axis.toml")
    summary = distributed.sweep(
        project,
        tasks,
        asked.out,
        rows=asked.rows,
        part_rows=asked.part_rows,
        address=asked.address,
        progress=reported,
    )
    print(f"{summary.rows} rows in {summary.seconds:.1f} s, {summary.found} of them found finished")
    print(f"an actuator fits {summary.fitting}; {summary.failed} could not be judged")
    for reason, rows in summary.reasons.items():
        print(f"  {rows:8} {reason}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
