"""A cycle under its load as dense samples, cut wherever something switches.

Each smooth stretch between two cuts is divided into equal panels with five Gauss points each; peaks are looked for at all
points and at the ends of the panels. Cuts: ends of pieces, reversals, corners of a table, zeros of the useful torque and
of further signals that the caller names.
"""

from dataclasses import dataclass

import numpy as np

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(5)
GRID = 4001
PANELS = 600


@dataclass
class Stretch:
    """Samples of one smooth stretch; rows are panels, columns are begin, the Gauss points, end."""

    piece: object
    begin: float
    width: float
    sign: float
    speed: np.ndarray
    acc: np.ndarray
    load: np.ndarray
    useful: np.ndarray
    mechanism: tuple

    def integral(self, value):
        return float(np.sum(value[:, 1:-1] * WEIGHTS) * self.width / 2)


def crossings(function, begin, end, grid=GRID):
    """Instants at which a smooth function of time changes its sign, within (begin, end)."""
    t = np.linspace(begin, end, grid)
    values = function(t)
    floor = 1e-11 * np.max(np.abs(values), initial=0.0)
    signs = np.where(np.abs(values) <= floor, 0, np.sign(values))
    known = np.flatnonzero(signs)
    turns = np.flatnonzero(signs[known[:-1]] != signs[known[1:]])
    low, high, sign = t[known[turns]], t[known[turns + 1]], signs[known[turns]]
    if len(low) == 0:
        return []
    for _ in range(80):
        middle = (low + high) / 2
        same = function(middle) * sign > 0
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return list((low + high) / 2)


def split(intervals, cuts_of):
    """Each interval cut at the instants that `cuts_of` finds in it."""
    result = []
    for begin, end in intervals:
        least = 1e-12 * max(abs(begin), abs(end), end - begin)
        marks = [begin] + sorted(t for t in cuts_of(begin, end) if begin + least < t < end - least) + [end]
        result += [(a, b) for a, b in zip(marks[:-1], marks[1:]) if b > a]
    return result


def stretches(pieces, load, signals=(), rates=(GRID, PANELS), switches=None):
    """Every stretch of the cycle in order of time.

    `signals`: functions of (speed, acc, load, sign) at the output, to be cut at zeros. `switches`: a function of
    (segment, angle, speed, acc, sign, recorded) at the mechanism that gives several such signals.
    """
    result = []
    for piece in pieces:
        # Intervals of a recording are many and short.
        grid, panels = (201, min(20, rates[1])) if piece.sampled else rates
        revolutions = np.ptp(piece.state(np.linspace(0, piece.time, 101))[0]) / (2 * np.pi)
        if load.turns_with_position and revolutions > 10:
            grid, panels = (int(x * revolutions / 10) for x in (grid, panels))

        def speed_at(t, piece=piece):
            return piece.state(t)[1]

        def share(least, whole, a, b, piece=piece):
            return max(least, int(whole * (b - a) / piece.time))

        rest = piece.rest != ""
        parts = [(0.0, piece.time)]
        if not rest:
            parts = split(parts, lambda a, b: crossings(speed_at, a, b, grid))

        def corner_cuts(a, b, piece=piece):
            ends = piece.state(np.linspace(a, b, 101))[0]
            corners = load.corners(ends.min(), ends.max())
            found = [crossings(lambda t, c=c: piece.state(t)[0] - c, a, b, grid) for c in corners]
            return [t for some in found for t in some]

        parts = split(parts, corner_cuts)
        for begin, end in parts:
            sign = 0.0 if rest else float(np.sign(speed_at(np.array([(begin + end) / 2]))[0]))

            def useful(t, piece=piece, sign=sign):
                q, w, a, recorded = piece.state(t)
                return load.useful(piece.segment, q, w, a, sign, recorded)

            def handed_on(t, piece=piece, sign=sign, useful=useful):
                _, w, a, _ = piece.state(t)
                return load.handed_on(useful(t), w, a, sign)

            def torque(t, piece=piece, sign=sign, handed_on=handed_on):
                return load.at_output(handed_on(t), piece.state(t)[2], sign)

            cut = [(begin, end)]
            if not rest:
                cut = split(cut, lambda a, b: crossings(useful, a, b, share(201, grid, a, b)))
                cut = split(cut, lambda a, b: crossings(handed_on, a, b, share(201, grid, a, b)))
                cut = split(cut, lambda a, b: crossings(torque, a, b, share(201, grid, a, b)))
                count = 0 if switches is None else len(switches(piece.segment, *piece.state(np.zeros(1))[:3], sign, 0.0))
                for which in range(count):

                    def switch(t, piece=piece, sign=sign, which=which):
                        q, w, a, recorded = piece.state(t)
                        return switches(piece.segment, q, w, a, sign, recorded)[which] + 0 * t

                    cut = split(cut, lambda a, b, switch=switch: crossings(switch, a, b, share(201, grid, a, b)))
                for signal in signals:

                    def value(t, piece=piece, sign=sign, torque=torque, signal=signal):
                        _, w, a, _ = piece.state(t)
                        return signal(load.ratio * w, load.ratio * a, torque(t), sign)

                    cut = split(cut, lambda a, b, value=value: crossings(value, a, b, share(201, grid, a, b)))
            for a, b in cut:
                count = share(20, panels, a, b)
                edges = np.linspace(a, b, count + 1)
                middle, half = (edges[1:] + edges[:-1]) / 2, (b - a) / (2 * count)
                inner = middle[:, None] + half * POINTS
                t = np.concatenate([edges[:-1, None], inner, edges[1:, None]], axis=1)
                # The ends are looked at from inside, where the table's slope is that of this stretch.
                q, w, acc, recorded = piece.state(t)
                ask = useful(t.ravel()).reshape(t.shape)
                if rest:
                    acc, w, given = 0 * acc, 0 * w, load.holding_torque(piece.rest, ask)
                else:
                    ask = load.handed_on(ask, w, acc, sign)
                    given = load.at_output(ask, acc, sign)
                speed, acceleration, here = load.ratio * w, load.ratio * acc, (q, w, acc, recorded)
                width = (b - a) / count
                result.append(Stretch(piece, piece.begin + a, width, sign, speed, acceleration, given, ask, here))
    return result
