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
from load import Load
from motion import pieces
from projects import SEED, projects
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


def torsion(actuator, torque):
    """Eq. 73.1 to 73.4 in arcmin: each region adds its share."""
    first = min(torque, actuator["T_1"])
    second = min(max(torque - actuator["T_1"], 0), actuator["T_2"] - actuator["T_1"])
    third = max(torque - actuator["T_2"], 0)
    return (first / actuator["K_1"] + second / actuator["K_2"] + third / actuator["K_3"]) * 180 * 60 / pi


def bearing(project, actuator, parts, time):
    """Eq. 74.1 to 76.4 with the loads of each segment, moments averaged as the forces."""
    common = project["bearing"]
    loads = []
    for segment in project["motion"]:
        given = segment.get("bearing", common)
        f_r, l_r, f_a, l_a = (
            si(given[key]) if key in given else 0.0
            for key in ("radial_force", "radial_distance", "axial_force", "axial_distance")
        )
        loads.append((f_r, f_a, f_r * (l_r + actuator["R"]), f_a * l_a))
    travelled = np.zeros(len(loads))
    for p in parts:
        travelled[p.piece.segment] += p.integral(np.abs(p.speed))
    power = {"C": 10 / 3, "F": 3.0}[actuator["bearing"]]
    f_r, f_a, m_r, m_a = [
        float((np.sum(travelled * np.array(column) ** power) / np.sum(travelled)) ** (1 / power)) for column in zip(*loads)
    ]
    radial = f_r + 2 * (m_r + m_a) / actuator["d_p"]
    x, y = (1.0, 0.45) if f_a <= 1.5 * radial else (0.67, 0.67)
    n_av = float(np.sum(travelled)) / (2 * pi) / time * 60
    equivalent = common["load_factor"] * (x * radial + y * f_a)
    moments = [m_1 + m_2 for _, _, m_1, m_2 in loads]
    static = [f_r + 2 * m / actuator["d_p"] + 0.44 * f_a for (f_r, f_a, _, _), m in zip(loads, moments)]
    return {
        "bearing_axial": max(load[1] for load in loads),
        "bearing_radial": max(load[0] for load in loads),
        "bearing_tilting_moment": max(moments),
        "bearing_life": 1e6 / (60 * n_av) * (actuator["C"] / equivalent) ** power,
        "bearing_static": actuator["C_0"] / max(static),
        "tilt_angle": max(moments) / actuator["K_B"],
    }


def results(text, files, actuator):
    project = tomllib.loads(text)
    load = Load(project)
    cycle = pieces(project, files, load.travel, load.start)
    time = cycle[-1].begin + cycle[-1].time
    parts = stretches(cycle, load)
    found = {"demand": demand(parts, time, actuator["J_out"])}
    found["demand"]["torsion"] = torsion(actuator, found["demand"].pop("load_peak"))
    if "bearing" in project:
        found["bearing"] = bearing(project, actuator, parts, time)
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
    for name, code, text, rotations in specials():
        print(name, file=sys.stderr)
        found = digits(full(text, {}, code))
        more = {"name": name, "code": code, "project": text, "files": {}, "rotations": rotations, "mirror": True}
        cases.append(more | {"expect": found})
    versions = {"python": platform.python_version(), "numpy": np.__version__, "scipy": scipy.__version__}
    head = {"made_by": "validation/differential/reference.py", "versions": versions, "seed": SEED, "actuators": actuators}
    lines = ",\n".join(json.dumps(case, ensure_ascii=False) for case in cases)
    text = json.dumps(head, ensure_ascii=False, indent=1)[:-2] + ',\n "cases": [\n' + lines + "\n]}\n"
    (HERE / "cases.json").write_text(text)


if __name__ == "__main__":
    main()
