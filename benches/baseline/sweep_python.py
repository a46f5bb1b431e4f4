"""What the way through Python and Arrow adds to a sweep: python sweep_python.py KERNEL PROJECT ROWS [RUNS]

KERNEL is the example `kernel` of the crate `python`, which judges the same rows without Python. Both run in turn, each on one core
(RAYON_NUM_THREADS=1); the least user time of some runs counts, which neighbours disturb the least. PROJECT has a load and a move of
which the time is stated.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import time

os.environ["RAYON_NUM_THREADS"] = "1"

import antrieb  # noqa: E402


def table(rows: int) -> antrieb.Table:
    """The rows of the kernel."""
    return antrieb.Table.from_pydict(
        {
            "load.inertia [kg m^2]": [0.05 + row % 1000 / 200.0 for row in range(rows)],
            "motion[1].time [s]": [0.5 + (row // 1000) % 1000 / 666.0 for row in range(rows)],
        }
    )


def kernel(program: str, project: str, rows: int) -> float:
    """User time of the kernel alone, its start included."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, project, str(rows)], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime


def main() -> None:
    """Measure and print."""
    program, project, rows = sys.argv[1], sys.argv[2], int(sys.argv[3])
    runs = int(sys.argv[4]) if len(sys.argv) > 4 else 3
    given = table(rows)
    antrieb.sweep(project, table(10))
    alone, through = [], []
    for _ in range(runs):
        alone.append(kernel(program, project, rows))
        begin = resource.getrusage(resource.RUSAGE_SELF).ru_utime
        antrieb.sweep(project, given)
        through.append(resource.getrusage(resource.RUSAGE_SELF).ru_utime - begin)
    least, most = min(alone), min(through)
    print(f"{rows} rows: kernel {least:.3f} s, through Python {most:.3f} s: {100 * (most / least - 1):+.2f} %")
    one = table(1)
    begin = time.process_time()
    for _ in range(200):
        antrieb.sweep(project, one)
    print(f"a call of one row: {1e6 * (time.process_time() - begin) / 200:.0f} µs")


if __name__ == "__main__":
    main()
