"""Baseline of the benches: the catalogue judged for one axis, as an engineer would write it with NumPy.

    antrieb catalogue export --format json > catalogue.json
    python3 benches/baseline/sizing_numpy.py catalogue.json
    python3 benches/baseline/sizing_numpy.py catalogue.json --moves 100
    python3 benches/baseline/sizing_numpy.py catalogue.json --recorded 10000
    python3 benches/baseline/sizing_numpy.py catalogue.json --sampled 1e-3

By default the ramps of the cycle are vectors over the whole catalogue; with --sampled the cycle is sampled in time and
one actuator follows the other, with the checks that look at every instant too: trace, heat, overload, energy.

The axis is that of examples/indexing-table.toml. Only the judging is timed: reading the catalogue and making the
arrays is not. One answer is one JSON object on stdout. Exit code 3: NumPy is missing.

Left out against antrieb: the instants, sources and remarks of every figure, the ranking, and the safe values that
errata give for some output bearings (d_p of 17A, permissible forces of larger ones): the export holds what is printed
or corrected, not what checks use.
"""

import argparse
import json
import sys
import time

try:
    import numpy as np
except ImportError:
    print("sizing_numpy: NumPy is missing; install the package numpy for this Python", file=sys.stderr)
    sys.exit(3)

RPM = 2.0 * np.pi / 60.0
ARCMIN = np.pi / 10800.0
# Units of the export and what one of them is in SI.
UNITS = {
    "": 1.0, "Nm": 1.0, "min^-1": RPM, "A": 1.0, "10^-3 A/min^-1": 1e-3 / RPM, "Nm/A": 1.0, "kgm^2": 1.0,
    "V": 1.0, "V/1000 min^-1": 1.0 / (1000.0 * RPM), "ohm": 1.0, "mH": 1e-3, "10^3 Nm/rad": 1e3,
    "Nm/arcmin": 1.0 / ARCMIN, "m": 1.0, "mm": 1e-3, "N": 1.0, "kg": 1.0,
}
RATIOS = (30, 50, 80, 100, 120, 160)
# Symbols of a drive's tables, with their condition; the 48 V windings have one I_NLS inside the operating range.
BY_DRIVE = {
    "T_max": "", "n_mot_max": "", "n_N": "", "I_max": "", "I_E": "", "T_0": "", "I_0": "", "k_Tout": "", "k_TM": "",
    "k_EM": "20 degC", "R_LL": "20 degC", "L_LL": "", "p": "", "d_H": "", "U_DCmax": "",
}
BY_SIZE = ("T_1", "T_2", "K_1", "K_2", "K_3", "d_p", "R", "C", "C_0", "M_dyn_max", "F_A_dyn_max", "F_R_dyn_max", "K_B")
COPPER = 3.93e-3  # per kelvin at 20 degC
FRICTION_SHARE = 0.58  # docs/theory/continuous-torque.md
BAND = 0.15


def covers(entry, ratio):
    """Whether the ratio of a cell (`30`, `> 50`, empty for all) is that of an actuator."""
    if entry.startswith(">"):
        return ratio > int(entry[1:])
    return entry in ("", str(ratio))


class Catalogue:
    """The available actuators, a column of SI values per symbol; NaN where nothing is printed."""

    def __init__(self, rows):
        self.cells = {}
        for row in rows:
            for drive in row["drive"].split(" / "):
                self.cells.setdefault((drive, row["symbol"], row["condition"]), []).append(row)
        offered = {(row["feedback"], row["condition"][-1]) for row in rows if row["symbol"] == "motor_connector"}
        drives = {row["drive"] for row in rows if row["symbol"] == "T_max" and row["drive"].startswith("CHA-")}
        self.codes, columns = [], {}
        for drive in sorted(drives):
            size = drive[4:7]
            feedbacks = sorted({row["feedback"] for row in self.cells[(drive, "J_out", "")]})
            windings = "HN" if drive.endswith("H/N") else "E" if drive.endswith("-E") else "H"
            for winding in windings:
                for feedback in feedbacks:
                    if (feedback, winding) not in offered or not self.available(size, feedback, winding):
                        continue
                    for ratio in RATIOS:
                        if self.printed(size, f"ratio={ratio}") == "●":
                            for brake in (False, True):
                                name = f"CHA-{size}-{ratio}-{winding}-{feedback}" + ("-B" if brake else "")
                                self.codes.append(name)
                                for symbol, value in self.actuator(drive, size, winding, feedback, ratio, brake):
                                    columns.setdefault(symbol, []).append(value)
        for symbol, values in columns.items():
            setattr(self, symbol, np.array(values, dtype=float))

    def __len__(self):
        return len(self.codes)

    def printed(self, size, condition):
        return next((row["printed"] for row in self.cells.get((f"CHA-{size}", "availability", condition), [])), "-")

    def available(self, size, feedback, winding):
        return all(self.printed(size, c) == "●" for c in (f"feedback={feedback}", f"winding={winding}"))

    def find(self, drive, symbol, condition, feedback, ratio):
        for row in self.cells.get((drive, symbol, condition), []):
            if row["feedback"] in ("", feedback) and covers(row["ratio"], ratio):
                if isinstance(row["value"], float):
                    return row["value"] * UNITS[row["unit"]]
        return float("nan")

    def actuator(self, drive, size, winding, feedback, ratio, brake):
        head = f"CHA-{size}"
        for symbol, condition in BY_DRIVE.items():
            yield symbol, self.find(drive, symbol, condition, feedback, ratio)
        yield "i", ratio
        yield "I_NLS", self.find(drive, "I_NLS", "20 degC" if winding == "E" else "", feedback, ratio)
        yield "K_cold", self.find(drive, "K_INL", "30 degC", feedback, ratio)
        yield "K_warm", self.find(drive, "K_INL", "80 degC", feedback, ratio)
        yield "J_out", self.find(drive, "J_out_brake" if brake else "J_out", "", feedback, ratio)
        stall = [self.find(drive, "I_0", "", feedback, each) for each in RATIOS]
        yield "I_0_motor", np.nanmax(stall)
        yield "stall_has_friction", winding != "E"
        for symbol in BY_SIZE:
            yield symbol, self.find(head, symbol, "", feedback, ratio)
        yield "T_A", self.find(head, "T_A", "", feedback, ratio)
        yield "T_N", self.find(head, "T_N", "", feedback, ratio)
        kind = self.cells[(head, "bearing_type", "")][0]["value"]
        yield "exponent", 10.0 / 3.0 if kind == "C" else 3.0
        curve = [row for row in self.cells.get((head, "curve_T_n", "continuous"), []) if row["ratio"] == str(ratio)]
        points = [(float("nan"), float("nan"))]
        if curve:
            text = curve[0]["value"].strip("()").replace(",", ".")
            points = [tuple(float(part) for part in point.split(";")) for point in text.split(")(")]
        points += [points[-1]] * (3 - len(points))
        yield "curve_n", [speed * RPM for speed, _ in points]
        yield "curve_T", [torque for _, torque in points]


class Axis:
    """examples/indexing-table.toml: load, cycle, forces on the bearing, requirements. SI."""

    J_L, T_L = 1.3, 5.0
    axial, axial_distance, radial, radial_distance, load_factor = 250.0, 0.04, 80.0, 0.06, 1.2
    safety_min, life_min, hollow_min = 1.5, 30000.0 * 3600.0, 0.018
    supply, reserve = 560.0, 0.9

    def __init__(self, moves):
        speed, t1, t2, t3, pause = (np.full(moves, value) for value in (40.0 * RPM, 0.1, 0.1, 0.1, 1.0))
        zero = np.zeros(moves)
        # Ramps in their order: accelerate, run, brake, rest.
        self.n0 = np.stack([zero, speed, speed, zero], axis=1).ravel()
        self.n1 = np.stack([speed, speed, zero, zero], axis=1).ravel()
        self.duration = np.stack([t1, t2, t3, pause], axis=1).ravel()
        self.sign = np.sign(self.n0 + self.n1)
        self.alpha = (self.n1 - self.n0) / self.duration
        self.whole = self.duration.sum()


def currents(cat, torque, sign, speed):
    """Motor current with friction; the colder constant where friction opposes the torque (docs/theory/current.md)."""
    constant = np.where(torque * sign < 0.0, cat.K_warm[:, None], cat.K_cold[:, None])
    friction = cat.I_NLS[:, None] + constant * np.abs(speed)
    return torque / cat.k_Tout[:, None] + sign * friction


def voltage(cat, n0, i0, n1, i1):
    """Largest terminal voltage over each ramp, winding at 90 degC (docs/theory/voltage.md)."""
    pairs = (cat.p * cat.i)[:, None]
    resistance = (cat.R_LL / 2.0 * (1.0 + COPPER * 70.0))[:, None]
    inductance = (cat.L_LL / 2.0)[:, None]
    flux = (cat.k_EM * np.sqrt(2.0 / 3.0) / cat.p)[:, None]

    def parts(n, i):
        return -pairs * n * inductance * np.sqrt(2.0) * i, resistance * np.sqrt(2.0) * i + pairs * n * flux

    d0, q0 = parts(n0, i0)
    d1, q1 = parts(n1, i1)
    ends = np.sqrt(1.5 * np.maximum(d0**2 + q0**2, d1**2 + q1**2))
    # u_d is a parabola over the ramp; where its vertex lies inside, the largest u_d and u_q are taken together.
    dn, di = n1 - n0, i1 - i0
    with np.errstate(divide="ignore", invalid="ignore"):
        s = -(n0 * di + i0 * dn) / (2.0 * dn * di)
    inside = (s >= 0.0) & (s <= 1.0)
    s = np.where(inside, s, 0.0)
    dv, qv = parts(n0 + s * dn, i0 + s * di)
    u_d = np.maximum.reduce([np.abs(d0), np.abs(d1), np.abs(dv)])
    u_q = np.maximum.reduce([np.abs(q0), np.abs(q1), np.abs(qv)])
    return np.where(inside, np.maximum(ends, np.sqrt(1.5 * (u_d**2 + u_q**2))), ends).max(axis=1)


def continuous_torque(cat, speed):
    """Published curve where there is one, else the lower edge of the estimate (docs/theory/continuous-torque.md)."""
    resistance = cat.R_LL * (1.0 + COPPER * 60.0)
    friction = cat.I_NLS + cat.K_warm * speed
    square = cat.I_0_motor**2 - FRICTION_SHARE * friction * cat.k_TM * speed * cat.i / (1.5 * resistance)
    counted = np.where(cat.stall_has_friction > 0.0, friction, friction - cat.I_NLS)
    share = speed * cat.i / cat.n_N
    centre = np.clip(cat.k_Tout * (np.sqrt(np.maximum(square, 0.0)) - counted), 0.0, cat.T_0)
    estimate = np.where((share > 1.0) | (square <= 0.0), 0.0, centre) * (1.0 - BAND * np.minimum(share, 1.0))
    (a, b, c), (ta, tb, tc) = cat.curve_n.T, cat.curve_T.T
    with np.errstate(divide="ignore", invalid="ignore"):
        first = ta + (tb - ta) * (speed - a) / (b - a)
        second = tb + (tc - tb) * (speed - b) / (c - b)
    published = np.select([speed <= b, speed <= c], [first, second], 0.0)
    return np.where(np.isnan(a), estimate, np.minimum(published, cat.T_0))


def judge(cat, axis):
    """Every check of every actuator; a check without its datum is NaN and does not reject."""
    inertia = axis.J_L + cat.J_out[:, None]
    torque = inertia * axis.alpha + axis.T_L * axis.sign
    t_rms = np.sqrt((torque**2 * axis.duration).sum(axis=1) / axis.whole)
    t_peak = np.abs(torque).max(axis=1)
    angle = 0.5 * np.abs(axis.n0 + axis.n1) * axis.duration
    n_av = angle.sum() / axis.whole
    n_peak = max(np.abs(axis.n0).max(), np.abs(axis.n1).max())
    duty = axis.duration[axis.sign != 0.0].sum() / axis.whole

    i0, i1 = currents(cat, torque, axis.sign, axis.n0), currents(cat, torque, axis.sign, axis.n1)
    i_peak = np.maximum(np.abs(i0), np.abs(i1)).max(axis=1)
    volts = voltage(cat, axis.n0, i0, axis.n1, i1)
    limit = continuous_torque(cat, n_av)

    # The gear carries the torque of the load alone.
    load = np.abs(axis.J_L * axis.alpha + axis.T_L * axis.sign)
    t_mean = np.cbrt((load**3 * angle).sum() / angle.sum())
    gear_life = 35000.0 / 5.0 * (2000.0 * RPM / (n_av * cat.i)) * (cat.T_N / t_mean) ** 3
    peak = load.max()
    torsion = (
        np.minimum(peak, cat.T_1) / cat.K_1
        + np.maximum(np.minimum(peak, cat.T_2) - cat.T_1, 0.0) / cat.K_2
        + np.maximum(peak - cat.T_2, 0.0) / cat.K_3
    )
    frequency = np.sqrt(cat.K_1 / axis.J_L) / (2.0 * np.pi)

    moment = axis.radial * (axis.radial_distance + cat.R) + axis.axial * axis.axial_distance
    radial = axis.radial + 2.0 * moment / cat.d_p
    small = axis.axial <= 1.5 * radial
    equivalent = np.where(small, radial + 0.45 * axis.axial, 0.67 * (radial + axis.axial))
    life = 1e6 * 2.0 * np.pi / n_av * (cat.C / (axis.load_factor * equivalent)) ** cat.exponent
    safety = cat.C_0 / (radial + 0.44 * axis.axial)
    tilt = moment / cat.K_B

    fails = {
        "peak_torque": t_peak > cat.T_max,
        "peak_speed": n_peak > cat.n_mot_max / cat.i,
        "mean_speed": n_av > cat.n_N / cat.i,
        "continuous_torque": t_rms > limit,
        "peak_current": i_peak > cat.I_max,
        "demagnetisation": i_peak > cat.I_E,
        "voltage": volts > axis.supply / np.sqrt(2.0) * axis.reserve,
        "gear_mean_torque": t_mean > cat.T_A,
        "bearing_axial": axis.axial > cat.F_A_dyn_max,
        "bearing_radial": axis.radial > cat.F_R_dyn_max,
        "bearing_tilting_moment": moment > cat.M_dyn_max,
        "bearing_life": life < axis.life_min,
        "bearing_static": safety < axis.safety_min,
        "hollow_shaft": cat.d_H < axis.hollow_min,
        "supply": axis.supply > cat.U_DCmax,
    }
    shown = {
        "t_rms": t_rms, "t_peak": t_peak, "n_av": n_av, "n_peak": n_peak, "ED": duty, "i_peak": i_peak,
        "voltage": volts, "continuous": limit, "inertia_ratio": axis.J_L / cat.J_out, "gear_life": gear_life,
        "torsion": torsion, "natural_frequency": frequency, "bearing_life": life, "static_safety": safety,
        "tilt": tilt,
    }
    return ~np.logical_or.reduce(list(fails.values())), shown, fails


def sampled(axis, step):
    """The cycle at equal steps: time, speed, acceleration, direction; steps are placed in the middle of their interval."""
    t = (np.arange(round(axis.whole / step)) + 0.5) * step
    start = np.concatenate([[0.0], np.cumsum(axis.duration)])
    ramp = np.searchsorted(start, t, side="right") - 1
    into = (t - start[ramp]) / axis.duration[ramp]
    return t, axis.n0[ramp] + into * (axis.n1 - axis.n0)[ramp], axis.alpha[ramp], axis.sign[ramp]


def lag(values, step, tau):
    """Largest value of a first-order lag in the steady cycle."""
    t = np.arange(1, len(values) + 1) * step
    gathered = np.cumsum(values * np.exp((t - t[-1]) / tau)) * step / tau * np.exp((t[-1] - t) / tau)
    start = gathered[-1] / (1.0 - np.exp(-t[-1] / tau))
    return (gathered + start * np.exp(-t / tau)).max()


def judge_sampled(cat, axis, step):
    """Every check over the sampled cycle, one actuator after the other, each a vector operation over time."""
    t, speed, alpha, sign = sampled(axis, step)
    magnitude = np.abs(speed)
    n_av, n_peak = magnitude.mean(), magnitude.max()
    limits = continuous_torque(cat, n_av)
    hot = cat.R_LL / 2.0 * (1.0 + COPPER * 70.0)
    warm = cat.R_LL * (1.0 + COPPER * 60.0)
    flux = cat.k_EM * np.sqrt(2.0 / 3.0) / cat.p
    available = axis.supply / np.sqrt(2.0) * axis.reserve
    load = np.abs(axis.J_L * alpha + axis.T_L * sign)
    t_mean = np.cbrt((load**3 * magnitude).sum() / magnitude.sum())
    moment = axis.radial * (axis.radial_distance + cat.R) + axis.axial * axis.axial_distance
    fit, out = np.zeros(len(cat), dtype=bool), np.empty((len(cat), 8))
    for k in range(len(cat)):
        torque = (axis.J_L + cat.J_out[k]) * alpha + axis.T_L * sign
        t_rms, t_peak = np.sqrt((torque**2).mean()), np.abs(torque).max()
        constant = np.where(torque * sign < 0.0, cat.K_warm[k], cat.K_cold[k])
        friction = cat.I_NLS[k] + constant * magnitude
        current = torque / cat.k_Tout[k] + sign * friction
        i_peak = np.abs(current).max()
        # Voltage at every instant, and the short-time torque at the speed of every instant.
        omega, i_q = cat.p[k] * cat.i[k] * speed, np.sqrt(2.0) * current
        reactance = omega * cat.L_LL[k] / 2.0
        volts = np.sqrt(1.5 * ((reactance * i_q) ** 2 + (hot[k] * i_q + omega * flux[k]) ** 2)).max()
        emf, square = np.abs(omega) * flux[k], reactance**2 + hot[k] ** 2
        root = np.sqrt(np.maximum((hot[k] * emf) ** 2 - square * (emf**2 - available**2 / 1.5), 0.0))
        i_u = (root - hot[k] * emf) / square / np.sqrt(2.0)
        short = cat.k_Tout[k] * (np.minimum(i_u, cat.I_max[k]) - cat.I_NLS[k] - cat.K_cold[k] * magnitude)
        short = np.where(torque * sign < 0.0, cat.T_max[k], np.clip(short, 0.0, cat.T_max[k]))
        trace = (np.abs(torque) / np.maximum(short, 1e-9)).max()
        # Heat, overload and energy.
        heat = 1.5 * warm[k] * current**2 + FRICTION_SHARE * friction * cat.k_TM[k] * cat.i[k] * magnitude
        rise = 40.0 * heat.mean() / (1.5 * warm[k] * cat.I_0_motor[k] ** 2)
        ripple = lag(heat, step, 60.0)
        overload = lag((current / cat.I_0[k]) ** 2, step, 60.0)
        power = 1.5 * cat.R_LL[k] * current**2 + cat.k_TM[k] * cat.i[k] * current * speed
        back = -np.minimum(power, 0.0).mean()
        # What does not change over the cycle.
        radial = axis.radial + 2.0 * moment[k] / cat.d_p[k]
        small = axis.axial <= 1.5 * radial
        equivalent = radial + 0.45 * axis.axial if small else 0.67 * (radial + axis.axial)
        life = 1e6 * 2.0 * np.pi / n_av * (cat.C[k] / (axis.load_factor * equivalent)) ** cat.exponent[k]
        fails = (
            t_peak > cat.T_max[k], n_peak > cat.n_mot_max[k] / cat.i[k], n_av > cat.n_N[k] / cat.i[k],
            t_rms > limits[k], i_peak > cat.I_max[k], i_peak > cat.I_E[k], volts > available, trace > 1.0,
            rise > 50.0, overload > 1.0, t_mean > cat.T_A[k], axis.axial > cat.F_A_dyn_max[k],
            axis.radial > cat.F_R_dyn_max[k], moment[k] > cat.M_dyn_max[k], life < axis.life_min,
            cat.C_0[k] / (radial + 0.44 * axis.axial) < axis.safety_min, cat.d_H[k] < axis.hollow_min,
            axis.supply > cat.U_DCmax[k],
        )
        fit[k] = not any(fails)
        out[k] = t_rms, t_peak, i_peak, volts, trace, ripple, overload, back
    return fit, out


def recording(samples):
    """A recorded speed at 1 kHz: two oscillations with a dead band, so that the axis rests at every reversal."""
    t = np.arange(samples) * 1e-3
    speed = 4.0 * np.sin(2.0 * np.pi * 0.7 * t) + 0.8 * np.sin(2.0 * np.pi * 2.3 * t)
    return t, np.sign(speed) * np.maximum(np.abs(speed) - 0.2, 0.0)


def judge_recorded(cat, axis, t, speed):
    """Demand of a recorded motion: one pass of vector operations per actuator."""
    alpha, sign, magnitude = np.gradient(speed, t), np.sign(speed), np.abs(speed)
    whole, step = t[-1] - t[0], np.diff(t)

    def mean(y):
        return (0.5 * (y[1:] + y[:-1]) * step).sum() / whole

    n_av, n_peak = mean(magnitude), magnitude.max()
    out = np.empty((len(cat), 4))
    for k in range(len(cat)):
        torque = (axis.J_L + cat.J_out[k]) * alpha + axis.T_L * sign
        constant = np.where(torque * sign < 0.0, cat.K_warm[k], cat.K_cold[k])
        current = torque / cat.k_Tout[k] + sign * (cat.I_NLS[k] + constant * magnitude)
        out[k] = np.sqrt(mean(torque**2)), np.abs(torque).max(), n_av, np.abs(current).max()
    return out, n_peak


def measure(runs, call):
    """Seconds of one call: the smallest of five medians, as benches/src/lib.rs does."""
    best = float("inf")
    for _ in range(5):
        series = []
        for _ in range(runs):
            start = time.perf_counter()
            call()
            series.append(time.perf_counter() - start)
        best = min(best, sorted(series)[len(series) // 2])
    return best


def main():
    parser = argparse.ArgumentParser(description="The catalogue judged for one axis with NumPy.")
    parser.add_argument("catalogue", help="antrieb catalogue export --format json; - reads standard input")
    parser.add_argument("--moves", type=int, default=1, help="moves of the cycle")
    parser.add_argument("--recorded", type=int, metavar="N", help="a recorded motion of N samples instead")
    parser.add_argument("--sampled", type=float, metavar="STEP", help="the cycle sampled at this step in seconds instead")
    parser.add_argument("--runs", type=int, help="calls per series")
    parser.add_argument("--figures", action="store_true", help="also every figure of every actuator")
    options = parser.parse_args()
    if options.moves < 1 or (options.recorded or 3) < 3 or (options.runs or 1) < 1:
        parser.error("--moves and --runs from 1, --recorded from 3")
    if options.catalogue == "-":
        rows = json.load(sys.stdin)
    else:
        with open(options.catalogue, encoding="utf-8") as file:
            rows = json.load(file)
    cat, axis = Catalogue(rows), Axis(options.moves)
    if options.recorded:
        t, speed = recording(options.recorded)
        out, n_peak = judge_recorded(cat, axis, t, speed)
        seconds = measure(options.runs or 3, lambda: judge_recorded(cat, axis, t, speed))
        answer = {
            "actuators": len(cat), "samples": options.recorded, "seconds": seconds, "numpy": np.__version__,
            "t_rms": out[:5, 0].tolist(), "t_peak": out[:5, 1].tolist(), "i_peak": out[:5, 3].tolist(),
            "n_av": out[0, 2] / RPM, "n_peak": n_peak / RPM,
        }
    elif options.sampled:
        fit, out = judge_sampled(cat, axis, options.sampled)
        seconds = measure(options.runs or 3, lambda: judge_sampled(cat, axis, options.sampled))
        answer = {
            "actuators": len(cat), "step": options.sampled, "fit": int(fit.sum()), "seconds": seconds,
            "numpy": np.__version__, "t_rms": out[:5, 0].tolist(), "back": out[:5, 7].tolist(),
        }
    else:
        fit, shown, fails = judge(cat, axis)
        seconds = measure(options.runs or (300 if options.moves < 100 else 20), lambda: judge(cat, axis))
        answer = {
            "actuators": len(cat), "moves": options.moves, "fit": int(fit.sum()), "seconds": seconds,
            "numpy": np.__version__, "t_rms": shown["t_rms"][:5].tolist(),
        }
        if options.figures:
            figures = {name: np.broadcast_to(value, len(cat)) for name, value in shown.items()}
            answer["figures"] = {
                code: {name: None if np.isnan(values[k]) else float(values[k]) for name, values in figures.items()}
                | {"fits": bool(fit[k]), "fails": [name for name, value in fails.items()
                                                   if np.broadcast_to(value, len(cat))[k]]}
                for k, code in enumerate(cat.codes)
            }
    json.dump(answer, sys.stdout)
    print()


if __name__ == "__main__":
    main()
