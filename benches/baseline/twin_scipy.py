"""Baseline of the bench `twin`: the speed step of validation/twin, 0.05 s, by LSODA of SciPy with rtol 1e-6, timed without imports.

One JSON object on stdout. Exit code 3: SciPy is missing.
"""

import json
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "validation" / "twin"))
try:
    import speed_step
except ImportError:
    print("twin_scipy: SciPy is missing; install the package scipy for this Python", file=sys.stderr)
    sys.exit(3)

times = []
for _ in range(3):
    start = time.process_time()
    speed_step.run(1e-6, 1e-9, lambda *row: None)
    times.append(time.process_time() - start)
print(json.dumps({"seconds": sorted(times)[1]}))
