"""Position, speed and acceleration of a cycle over time, from the definition of each law.

A cycle is a list of pieces. Within a piece the acceleration is smooth. Every law from rest to rest is given by the shape
of its acceleration alone; how far it goes and how fast it gets follows from integrals of the shape.
"""

from dataclasses import dataclass
from math import pi, sqrt

import numpy as np
from numpy.polynomial import Polynomial
from scipy.optimize import brentq

from quantity import dimension, si


# Closing and opening time of a brake, table 38.3 and its like.
CLOSING, OPENING = 0.07, 0.11


class Poly:
    """Acceleration as a polynomial of time."""

    def __init__(self, *coefficients):
        self.acc = Polynomial(coefficients)
        self.gain, self.way = self.acc.integ(1), self.acc.integ(2)

    def scaled(self, height, time):
        """The shape over `time` instead of 1, `height` times as high."""
        return Poly(*[height * c / time**k for k, c in enumerate(self.acc.coef)])


class Sine:
    """Acceleration a sin(w t + p)."""

    def __init__(self, a, w, p):
        self.a, self.w, self.p = a, w, p

    def acc(self, t):
        return self.a * np.sin(self.w * t + self.p)

    def gain(self, t):
        return self.a / self.w * (np.cos(self.p) - np.cos(self.w * t + self.p))

    def way(self, t):
        bend = (np.sin(self.w * t + self.p) - np.sin(self.p)) / self.w
        return self.a / self.w * (t * np.cos(self.p) - bend)

    def scaled(self, height, time):
        return Sine(self.a * height, self.w / time, self.p)


# First half of each law: shares of the whole time with the shape of the acceleration, largest value 1.
# The second half is the mirror of the first, with the other sign.
EIGHTH = Sine(1, 4 * pi, 0)
SHAPES = {
    "trapezoid": [(1 / 3, Poly(1)), (1 / 6, Poly(0))],
    "triangle": [(1 / 2, Poly(1))],
    "polynomial_5": [(1 / 2, Poly(0, 1, -3, 2).scaled(6 * sqrt(3), 1))],
    "simple_sine": [(1 / 2, Sine(1, pi, pi / 2))],
    "inclined_sine": [(1 / 2, Sine(1, 2 * pi, 0))],
    "modified_sine": [(1 / 8, EIGHTH), (3 / 8, Sine(1, 4 * pi / 3, pi / 2))],
    "modified_trapezoid": [(1 / 8, EIGHTH), (1 / 4, Poly(1)), (1 / 8, Sine(1, 4 * pi, pi / 2))],
}


class Mirrored:
    """The second half: the first one backwards in time, with the other sign."""

    def __init__(self, shape, time):
        self.shape, self.time = shape, time

    def acc(self, t):
        return -self.shape.acc(self.time - t)

    def gain(self, t):
        return self.shape.gain(self.time - t) - self.shape.gain(self.time)

    def way(self, t):
        return self.shape.way(self.time) - self.shape.way(self.time - t) - t * self.shape.gain(self.time)

    def scaled(self, height, time):
        return Mirrored(self.shape.scaled(height, time), self.time * time)


def whole(law):
    half = SHAPES[law]
    return half + [(share, Mirrored(shape, share)) for share, shape in reversed(half)]


def constants(law):
    """C_v and C_a: largest speed and acceleration of a law that goes 1 in the time 1."""
    speed, way = 0.0, 0.0
    for share, shape in SHAPES[law]:
        way += speed * share + shape.way(share)
        speed += shape.gain(share)
    return speed / (2 * way), 1 / (2 * way)


@dataclass
class Piece:
    """Smooth stretch of a cycle."""

    begin: float
    time: float
    segment: int
    angle: float
    speed: float
    shape: object
    rest: str = ""
    torque: tuple = (0.0, 0.0)
    bend: float | None = None
    sampled: bool = False
    closing: bool = False

    def state(self, t):
        """Position, speed, acceleration and recorded torque after `t` from the beginning of the piece."""
        acc = self.shape.acc(t) + 0.0 * t
        speed = self.speed + self.shape.gain(t)
        angle = self.angle + self.speed * t + self.shape.way(t)
        if self.bend is not None:  # recorded position: through both samples, with the curvature of the speed
            angle = self.angle + self.bend * t - acc * t * (self.time - t) / 2
        share = t / self.time
        return angle, speed, acc, self.torque[0] * (1 - share) + self.torque[1] * share


def two_of_four(law, given):
    """Signed distance and time of a move from rest to rest."""
    c_v, c_a = constants(law)
    way, time, speed, acc = (given.get(key) for key in ("distance", "time", "speed", "acceleration"))
    sign = np.sign(way if way is not None else speed if speed is not None else 1.0)
    way, speed = [None if x is None else abs(x) for x in (way, speed)]
    if time is None:
        if way is None:
            time = speed * c_a / (acc * c_v)
        else:
            time = c_v * way / speed if acc is None else sqrt(c_a * way / acc)
    if way is None:
        way = speed * time / c_v if speed is not None else acc * time**2 / c_a
    return sign * way, time


def trapezoid(given):
    """Ramp, run and ramp from rest to rest, from three of four."""
    way, time, speed, acc = (given.get(key) for key in ("distance", "time", "speed", "acceleration"))
    sign = np.sign(way if way is not None else speed)
    way, speed = [None if x is None else abs(x) for x in (way, speed)]
    if acc is None:
        ramp = time - way / speed
    elif speed is None:
        # way = acc ramp (time - ramp), the shorter ramp
        ramp = (time - sqrt(time**2 - 4 * way / acc)) / 2
        speed = acc * ramp
    else:
        ramp = speed / acc
    acc = speed / ramp
    return [(ramp, Poly(sign * acc)), (time - 2 * ramp, Poly(0)), (ramp, Poly(-sign * acc))]


def change(begin, end, acc, jerk):
    """A change of speed with bounded acceleration and jerk as times and polynomials of the acceleration."""
    size, sign = abs(end - begin), np.sign(end - begin)
    if size == 0:
        return []
    if jerk is None:
        return [(size / acc, Poly(sign * acc))]
    if size >= acc**2 / jerk:
        up, flat = acc / jerk, size / acc - acc / jerk
    else:
        up, flat = sqrt(size / jerk), 0.0
    top = sign * jerk * up
    parts = [(up, Poly(0, sign * jerk)), (flat, Poly(top)), (up, Poly(top, -sign * jerk))]
    return [part for part in parts if part[0] > 0]


def bounded(way, speed, acc, jerk, begin, end):
    """The shortest move with bounded speed, acceleration and jerk."""

    def parts(peak):
        return change(begin, peak, acc, jerk), change(peak, end, acc, jerk)

    def covered(peak):
        first, second = [sum(time for time, _ in half) for half in parts(peak)]
        return (begin + peak) / 2 * first + (peak + end) / 2 * second

    high, low = max(begin, end), min(begin, end)
    forward = way >= covered(high)
    peak, near = (speed, high) if forward else (-speed, low)
    rest = way - covered(peak)
    if rest * peak < 0:
        peak, rest = brentq(lambda p: covered(p) - way, near, peak, xtol=1e-300, rtol=1e-15), 0.0
    first, second = parts(peak)
    run = [(rest / peak, Poly(0))] if rest != 0 else []
    return first + run + second


def quintic(way, time, begin, end):
    """The polynomial of the fifth degree with given speeds at its ends and no acceleration there."""
    t = time
    rows = [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 2, 0, 0, 0]]
    rows += [[1, 1, 1, 1, 1, 1], [0, 1, 2, 3, 4, 5], [0, 0, 2, 6, 12, 20]]
    c = np.linalg.solve(np.array(rows, float), np.array([0, begin * t, 0, way, end * t, 0]))
    return [(t, Poly(*[c[k] * k * (k - 1) / t**k for k in range(2, 6)]))]


def samples(segment, text):
    """Columns of a recording in SI: time, position or None, speed, torque."""
    head, *rows = text.strip().split("\n")
    names = [name.rstrip("]").split(" [") for name in head.split(",")]
    table = np.array([[float(cell) for cell in row.split(",")] for row in rows])
    columns = {name: [si(f"{float(x)!r} {unit}") for x in table[:, k]] for k, (name, unit) in enumerate(names)}
    unit_of = dict(names)
    return {name: np.array(values) for name, values in columns.items()}, unit_of


def slopes(t, q):
    """Speed at each sample: slope of the parabola through it and its neighbours."""
    h, d = np.diff(t), np.diff(q) / np.diff(t)
    inner = (h[1:] * d[:-1] + h[:-1] * d[1:]) / (h[:-1] + h[1:])
    if d[0] != 0 or d[1] != 0 or d[-1] != 0 or d[-2] != 0:
        raise ValueError("a recording of positions alone shall rest at its ends")
    return np.concatenate([[0.0], inner, [0.0]])


def holders(segments, index):
    """Who holds during a dwell: the motor until the brake has closed (`closing`) and from when it begins to open.

    Between two dwells that the brake holds it stays closed, over the end of the cycle too.
    """
    time, hold = si(segments[index]["time"]), segments[index].get("hold", "motor")
    if hold != "brake":
        return [(time, hold)]

    def braked(place):
        return segments[place % len(segments)].get("hold") == "brake"

    row, first = [index], index
    while braked(row[0] - 1) and len(row) < len(segments):
        row.insert(0, row[0] - 1)
    while braked(row[-1] + 1) and len(row) < len(segments):
        row.append(row[-1] + 1)
    times = [si(segments[place % len(segments)]["time"]) for place in row]
    whole, begin = sum(times), sum(times[: row.index(first)])
    if len(row) == len(segments):
        return [(time, "brake")]
    if whole <= CLOSING + OPENING:
        return [(time, "motor")]
    marks = [begin] + [t for t in (CLOSING, whole - OPENING) if begin < t < begin + time] + [begin + time]
    parts = list(zip(marks[:-1], marks[1:]))

    def holder(middle):
        return "closing" if middle < CLOSING else "brake" if middle <= whole - OPENING else "motor"

    return [(b - a, holder((a + b) / 2)) for a, b in parts]


def pieces(project, files, travel, start):
    """The cycle as pieces; `travel` is the way along the line per angle, None where there is no line."""
    result, now, angle, speed, index = [], 0.0, start, 0.0, 0

    def add(time, shape, **more):
        nonlocal now, angle, speed
        if time <= 0:
            return
        piece = Piece(now, time, index, angle, speed, shape, **more)
        result.append(piece)
        now += time
        angle, speed = (float(x) for x in piece.state(time)[:2])

    def rotary(text):
        return si(text) / travel if travel is not None and dimension(text) == "line" else si(text)

    for index, segment in enumerate(project["motion"]):
        law = segment["law"]
        keys = ("distance", "speed", "acceleration", "jerk", "end_speed")
        given = {key: rotary(segment[key]) for key in keys if key in segment}
        given |= {key: si(segment[key]) for key in ("time", "accelerate", "run", "brake", "pause") if key in segment}
        ending = given.get("end_speed", 0.0)
        if law == "manual":
            v = given["speed"]
            add(given["accelerate"], Poly(v / given["accelerate"]))
            add(given["run"], Poly(0))
            add(given["brake"], Poly(-v / given["brake"]))
            speed = 0.0
            add(given["pause"], Poly(0), rest="motor")
        elif law == "dwell":
            for time, holder in holders(project["motion"], index):
                add(time, Poly(0), rest="motor" if holder == "closing" else holder, closing=holder == "closing")
        elif law == "constant":
            if not result:
                speed = given["speed"]
            time = given["time"] if "time" in given else abs(given["distance"] / speed)
            add(time, Poly(0))
            ending = speed
        elif law == "recorded":
            columns, units = samples(segment, files[segment["file"]])
            t = columns["time"]
            q, w = columns.get("position"), columns.get("speed")
            if travel is not None:
                q = q / travel if q is not None and units["position"].startswith("m") else q
                w = w / travel if w is not None and units["speed"].startswith("m") else w
            if w is None:
                w = slopes(t, q)
            tau = columns["force"] * travel if "force" in columns else columns.get("torque", 0 * t)
            shift = 0.0 if q is None else angle - q[0]
            for k in range(len(t) - 1):
                h = t[k + 1] - t[k]
                speed = w[k]
                bend = None if q is None else (q[k + 1] - q[k]) / h
                if q is not None:
                    angle = q[k] + shift
                rest = "motor" if w[k] == 0 and w[k + 1] == 0 else ""
                add(h, Poly((w[k + 1] - w[k]) / h), bend=bend, torque=(tau[k], tau[k + 1]), rest=rest, sampled=True)
            ending = w[-1]
        elif law == "jerk":
            limits = [abs(given[key]) for key in ("speed", "acceleration", "jerk")]
            for part in bounded(given["distance"], *limits, speed, ending):
                add(*part)
        elif law == "trapezoid" and (speed != 0 or ending != 0 or {"distance", "speed", "acceleration"} <= set(given)):
            limits = [abs(given[key]) for key in ("speed", "acceleration")]
            for part in bounded(given["distance"], *limits, None, speed, ending):
                add(*part)
        elif law == "trapezoid" and len(given) == 3:
            for part in trapezoid(given):
                add(*part)
        elif law == "polynomial_5" and (speed != 0 or ending != 0):
            for part in quintic(given["distance"], given["time"], speed, ending):
                add(*part)
        else:
            way, time = two_of_four(law, given)
            height = constants(law)[1] * way / time**2
            for share, shape in whole(law):
                add(share * time, shape.scaled(height, time))
        speed = ending
    return result
