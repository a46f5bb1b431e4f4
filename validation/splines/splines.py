"""Cam tables through splines of another hand: the values of `crates/motion/tests/reference_points.rs`.

Run with Python 3 and SciPy; the values typed into the test came from SciPy 1.17.1 (the script prints the version it runs with).
"""

import numpy
import scipy
from scipy.interpolate import CubicSpline, make_interp_spline

TIME = numpy.array([0.0, 0.1, 0.25, 0.3, 0.55, 0.7])
POSITION = numpy.array([0.0, 0.2, 1.1, 1.0, -0.4, 0.0])
LOOKED = numpy.array([0.0, 0.07, 0.2, 0.28, 0.41, 0.66, 0.7])

FIRST, LAST = (0.5, -3.0), (-1.5, 8.0)
REST = [(1, 0.0), (2, 0.0)]
FREE = [(3, 0.0), (4, 0.0)]

SPLINES = {
    "cubic rest": CubicSpline(TIME, POSITION, bc_type="clamped"),
    "cubic natural": CubicSpline(TIME, POSITION, bc_type="natural"),
    "cubic periodic": CubicSpline(TIME, POSITION, bc_type="periodic"),
    "cubic stated": CubicSpline(TIME, POSITION, bc_type=((1, FIRST[0]), (1, LAST[0]))),
    "quintic rest": make_interp_spline(TIME, POSITION, k=5, bc_type=(REST, REST)),
    "quintic natural": make_interp_spline(TIME, POSITION, k=5, bc_type=(FREE, FREE)),
    "quintic periodic": make_interp_spline(TIME, POSITION, k=5, bc_type="periodic"),
    "quintic stated": make_interp_spline(
        TIME, POSITION, k=5, bc_type=([(1, FIRST[0]), (2, FIRST[1])], [(1, LAST[0]), (2, LAST[1])])
    ),
}

print("SciPy", scipy.__version__)
for name, spline in SPLINES.items():
    print(name)
    for t in LOOKED:
        values = [float(spline(t, nu)) for nu in range(3)]
        print(f"    [{t}, " + ", ".join(f"{value:.12g}" for value in values) + "],")
