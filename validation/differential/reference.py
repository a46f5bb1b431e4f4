"""Reference results of random projects by dense sampling, written apart from the engine.

    python3 validation/differential/reference.py

makes cases.json anew: the projects of projects.py (fixed seed), the numbers of their actuators (actuators.json) and what
this script finds for them. It needs Python 3.11 and NumPy, SciPy; their versions stand in cases.json. The equations are
those of docs/theory; none is taken from the program. Rates: 4001 instants a piece in search of whatever switches, 600
panels of five Gauss points in each stretch between.
"""

import json
import platform
import sys
import tomllib
from math import pi
from pathlib import Path

import numpy as np
import scipy

import drive
from flange import Flange
from further import further
from load import Load
from motion import pieces
from projects import SEED, bearable, projects
from quantity import si
from sampling import stretches
from specials import specials

HERE = Path(__file__).parent


def demand(parts, time, j_out):
    torques = [j_out * p.acc + p.load for p in parts]
    mean = lambda values: sum(p.integral(v) for p, v in zip(parts, values)) / time  # noqa: E731
    cubes = [np.abs(p.load) ** 3 * np.abs(p.speed) for p in parts]
    speed = mean([np.abs(p.speed) for p in parts])
    return {
        "T_rms": mean([t**2 for t in torques]) ** 0.5,
        "T_peak": max(float(np.max(np.abs(t))) for t in torques),
        "n_av": speed * 30 / pi,
        "n_peak": max(float(np.max(np.abs(p.speed))) for p in parts) * 30 / pi,
        "ED": 100 * mean([np.full_like(p.speed, p.sign**2) for p in parts]),
        "gear_mean_torque": (mean(cubes) / speed) ** (1 / 3),
        "load_peak": max(float(np.max(np.abs(p.load))) for p in parts),
    }


def torsion(project, actuator, torque):
    """Eq. 73.1 to 73.4 in arcmin: each region adds its share. Behind a stage at the mechanism."""
    first = min(torque, actuator["T_1"])
    second = min(max(torque - actuator["T_1"], 0), actuator["T_2"] - actuator["T_1"])
    third = max(torque - actuator["T_2"], 0)
    gear = first / actuator["K_1"] + second / actuator["K_2"] + third / actuator["K_3"]
    stage = project.get("stage", {})
    ratio = stage.get("ratio", 1.0)
    more = ratio * torque / si(stage["stiffness"]) if "stiffness" in stage else 0.0
    return (gear / ratio + more) * 180 * 60 / pi


def stated(project):
    """F_r, F_a and both parts of the moment that each segment states, and whether the mechanism counts there."""
    common, kind = project["bearing"], project["bearing"].get("mechanism", "ignore")
    for segment in project["motion"]:
        given = segment.get("bearing", common)
        f_r, l_r, f_a, l_a = (
            si(given[key]) if key in given else 0.0
            for key in ("radial_force", "radial_distance", "axial_force", "axial_distance")
        )
        counts = kind == "add" or (kind == "replace" and "bearing" not in segment)
        yield f_r, f_a, f_r * l_r, f_a * l_a, counts


def bearing(project, actuator, cycle, load, time):
    """Eq. 74.1 to 76.4 with the loads of every instant; the moment that acts is averaged as the forces."""
    common, offset = project["bearing"], actuator["R"]
    flange = Flange(project, load, offset)
    derived = common.get("mechanism", "ignore") != "ignore"
    parts = stretches(cycle, load, switches=flange.switches if derived else None)
    loads = list(stated(project))
    power = {"C": 10 / 3, "F": 3.0}[actuator["bearing"]]
    # The largest while the gear turns, and while it rests.
    sums, turning, resting, travelled = np.zeros(3), np.zeros(3), None, 0.0
    for p in parts:
        f_r, f_a, l_r, l_a, counts = loads[p.piece.segment]
        stated_r, stated_a = l_r + f_r * offset, l_a
        forces = [np.zeros_like(p.speed)] * 3
        if counts:
            q, w, acc, recorded = p.mechanism
            # At rest losses do not help: the stage hands on what it holds.
            eta = 1.0 if p.sign == 0 else load.stage_eta
            taken = (p.useful / load.ratio / eta, p.useful / load.ratio)
            driven = p.useful * p.sign < 0
            handed_on = np.where(driven, taken[1] * load.stage_back, taken[0]), taken[1]
            forces = flange.at(p.piece.segment, q, w, acc, p.sign, recorded, handed_on)
        radial, axial, moment = forces
        whole = radial + f_r, axial + f_a, moment + stated_r + stated_a
        largest = [float(np.max(x)) for x in whole]
        if p.sign == 0:
            resting = np.maximum(largest if resting is None else resting, largest)
        else:
            turning = np.maximum(turning, largest)
        weight = np.abs(p.speed)
        travelled += p.integral(weight)
        sums += [p.integral(weight * (x + 0 * weight) ** power) for x in whole]
    f_r, f_a, moment = (sums / travelled) ** (1 / power)
    radial = f_r + 2 * moment / actuator["d_p"]
    x, y = (1.0, 0.45) if f_a <= 1.5 * radial else (0.67, 0.67)
    n_av = travelled / (2 * pi) / time * 60
    equivalent = common["load_factor"] * (x * radial + y * f_a)
    # The largest of the cycle, each by itself.
    most = turning if resting is None else np.maximum(turning, resting)
    static = most[0] + 2 * most[2] / actuator["d_p"] + 0.44 * most[1]
    at_rest = {}
    if resting is not None:
        pure = resting[2] + actuator["d_p"] / 2 * (resting[0] + 0.44 * resting[1])
        at_rest = {"bearing_static_moment": pure}
    return at_rest | {
        "bearing_axial": turning[1],
        "bearing_radial": turning[0],
        "bearing_tilting_moment": turning[2],
        "bearing_life": 1e6 / (60 * n_av) * (actuator["C"] / equivalent) ** power,
        "bearing_static": actuator["C_0"] / static,
        "tilt_angle": most[2] / actuator["K_B"],
    }


def results(text, files, actuator):
    project = tomllib.loads(text)
    load = Load(project)
    cycle = pieces(project, files, load.travel, load.start)
    time = cycle[-1].begin + cycle[-1].time
    parts = stretches(cycle, load)
    found = {"demand": demand(parts, time, actuator["J_out"])}
    found["demand"]["torsion"] = torsion(project, actuator, found["demand"].pop("load_peak"))
    if "load_factor" in project.get("bearing", {}):
        found["bearing"] = bearing(project, actuator, cycle, load, time)
    ambient = si(project["requirements"]["ambient"])
    found["drive"], best = drive.judge(actuator, cycle, load, time, ambient)
    found["energy"] = drive.energy(best, cycle, load, time)
    return found


def digits(value):
    if isinstance(value, dict):
        return {key: digits(one) for key, one in value.items()}
    return float(f"{value:.12g}")


def main():
    actuators = json.loads((HERE / "actuators.json").read_text())
    cases = []

    def quick(text, files, code):
        project = tomllib.loads(text)
        load = Load(project)
        cycle = pieces(project, files, load.travel, load.start)
        parts = stretches(cycle, load, rates=(101, 8))
        return demand(parts, cycle[-1].begin + cycle[-1].time, actuators[code]["J_out"])

    def full(text, files, code):
        return results(text, files, actuators[code])

    for case in projects(actuators, quick, full):
        print(case["name"], file=sys.stderr)
        case["expect"] = digits(case["expect"])
        cases.append(case)
    def suits(text, files, code):
        return bearable(quick(text, files, code), actuators[code])

    for case in further(actuators, np.random.default_rng(SEED + 1), suits, full):
        print(case["name"], file=sys.stderr)
        case["expect"] = digits(case["expect"])
        cases.append(case)
    for name, code, text, rotations, mirror in specials():
        print(name, file=sys.stderr)
        found = digits(full(text, {}, code))
        more = {"name": name, "code": code, "project": text, "files": {}, "rotations": rotations, "mirror": mirror}
        cases.append(more | {"expect": found})
    versions = {"python": platform.python_version(), "numpy": np.__version__, "scipy": scipy.__version__}
    head = {"made_by": "validation/differential/reference.py", "versions": versions, "seed": SEED, "actuators": actuators}
    lines = ",\n".join(json.dumps(case, ensure_ascii=False) for case in cases)
    text = json.dumps(head, ensure_ascii=False, indent=1)[:-2] + ',\n "cases": [\n' + lines + "\n]}\n"
    (HERE / "cases.json").write_text(text)


if __name__ == "__main__":
    main()
