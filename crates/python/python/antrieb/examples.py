"""Four examples: `python -m antrieb.examples [FOLDER]` runs them and writes their pictures into the folder.

1. One axis: what fits, the checks of one actuator, the torque-speed plane.
2. A sweep over payload and cycle time as a heat map.
3. The six joints of a small robot in one project.
4. DuckDB over the result of the sweep, where it is installed.

Nothing but antrieb is needed. The figures of machine and robot are assumed.
"""

from __future__ import annotations

import importlib
import importlib.util
import pathlib
import sys
from typing import Any, NamedTuple

import antrieb
from antrieb._heat import Axis, drawn

ARM = antrieb.Axis(
    "loading arm",
    antrieb.Arm(
        inertia="0.55 kg m^2",
        mass="6 kg",
        centre_distance="220 mm",
        payload_distance="450 mm",
        axis_tilt="90 deg",
        start_angle="-20 deg",
        friction_torque="1.5 N m",
    ),
    [
        antrieb.Move("modified_sine", distance="100 deg", time="1.2 s", payload="2.5 kg"),
        antrieb.Return(time="1.2 s"),
        antrieb.Dwell("0.5 s", hold="motor"),
    ],
    bearing=antrieb.Bearing(overhang="60 mm"),
    supply="560 V",
    ambient="30 degC",
)


def library(name: str) -> Any:
    """What may be installed beside antrieb."""
    return importlib.import_module(name)


def one_axis(folder: pathlib.Path) -> None:
    """Size an axis, look at the checks of the best, draw its torque-speed plane."""
    (sizing,) = antrieb.size(ARM, top=3).axes
    print(f"{sizing.axis}: {sizing.answer or 'nothing'} fits; {sizing.fitting} of {sizing.judged} actuators do")
    for each in sizing.ranking:
        share = "" if each.utilisation is None else f"{100 * each.utilisation:5.1f} %"
        print(f"  {each.code:24} {share} {each.tightest}")
    (judged,) = antrieb.check(ARM, sizing.answer).axes
    for check in judged.checks:
        if check.verdict in ("fail", "advice") or check.id == judged.tightest:
            print(f"  {check.title}: {check.value} of {check.limit} {check.unit} ({check.verdict}; {check.source})")
    antrieb.plot(ARM, "torque_speed", sizing.answer).save(folder / "torque-speed.svg")


def payload_and_time(payloads: list[float], times: list[float]) -> antrieb.Table:
    """Every payload with every time of a move, there and back: one row each."""
    pairs = [(payload, time) for payload in payloads for time in times]
    time = antrieb.q([time for _, time in pairs], "s")
    load = antrieb.q([payload for payload, _ in pairs], "kg")
    return antrieb.sweep(ARM, {"motion.1.payload": load, "motion.1.time": time, "motion.2.time": time})


def heat_map(folder: pathlib.Path) -> antrieb.Table:
    """How many actuators fit over payload and time of a move, and of which size the best is."""
    payloads = [0.25 * step for step in range(25)]
    times = [0.4 + 0.05 * step for step in range(25)]
    best = payload_and_time(payloads, times)
    columns = best.to_pydict()
    # What fits if an estimate holds counts too.
    fit: list[int] = [sum(both) for both in zip(columns["fit"], columns["fit_if_estimate"], strict=True)]
    sizes: list[str] = [code[:7] if code else "" for code in columns["code"]]
    print(f"{len(best)} axes judged: the best is of one of {len({*sizes} - {''})} sizes; nothing fits {fit.count(0)} of them")
    ends = [(start, start + len(times)) for start in range(0, len(fit), len(times))]
    counts, names = [fit[start:end] for start, end in ends], [sizes[start:end] for start, end in ends]
    for lang, words in WORDS.items():
        x, y = Axis(label=words.time, values=times), Axis(label=words.payload, values=payloads)
        picture = drawn(words.title, x, y, counts, names, legend=words.legend, none=words.none, comma=lang == "de")
        picture.save(folder / f"heat-map-{lang}.svg")
    return best


class Words(NamedTuple):
    """What stands in the heat map."""

    title: str
    time: str
    payload: str
    legend: str
    none: str


WORDS = {
    "en": Words(
        "Loading arm: how many actuators fit, and the size of the best",
        "time of a move in s",
        "payload in kg",
        "actuators\nthat fit",
        "none fits",
    ),
    "de": Words(
        "Ladearm: Anzahl geeigneter Antriebe und Baugröße des besten",
        "Zeit einer Bewegung in s",
        "Nutzlast in kg",
        "geeignete\nAntriebe",
        "keiner",
    ),
}


PAYLOAD_KG = 3.0
GRAVITY_M_S2 = 9.81
# Joint: mass of all behind it in kg, distance of its centre from the axis in m, reach of the tool from the axis in m, angle
# of a move in deg, its time in s, whether gravity acts about it.
JOINTS: list[tuple[str, float, float, float, float, float, bool]] = [
    ("J1 base", 26.0, 0.22, 0.75, 120, 0.9, False),
    ("J2 shoulder", 19.0, 0.24, 0.70, 70, 0.8, True),
    ("J3 elbow", 9.0, 0.14, 0.42, 90, 0.7, True),
    ("J4 roll", 5.0, 0.03, 0.10, 180, 0.7, False),
    ("J5 wrist", 2.6, 0.06, 0.16, 100, 0.6, True),
    ("J6 flange", 0.8, 0.02, 0.05, 180, 0.6, False),
]


def joint(name: str, mass: float, centre: float, reach: float, angle: float, time: float, weighs: bool) -> antrieb.Axis:
    """One joint as an axis: there, back, and a pause; the payload at the reach of the tool."""
    own = mass * centre**2 * 1.3
    carried = antrieb.q(PAYLOAD_KG, "kg") if weighs else None
    load = antrieb.Load(inertia=f"{own + PAYLOAD_KG * reach**2:.4f} kg m^2", friction_torque="1 N m")
    arm = antrieb.Arm(
        inertia=f"{own:.4f} kg m^2",
        mass=antrieb.q(mass, "kg"),
        centre_distance=antrieb.q(centre, "m"),
        payload_distance=antrieb.q(reach, "m"),
        axis_tilt="90 deg",
        start_angle="0 deg",
    )
    motion = [
        antrieb.Move("modified_sine", distance=antrieb.q(angle, "deg"), time=antrieb.q(time, "s"), payload=carried),
        antrieb.Return(time=antrieb.q(time, "s"), payload=carried),
        antrieb.Dwell("0.6 s", hold="motor"),
    ]
    bearing = antrieb.Bearing(overhang="50 mm") if weighs else None
    mechanism = arm if weighs else load
    return antrieb.Axis(name, mechanism, motion, bearing=bearing, supply="560 V", ambient="30 degC", brake=True)


def robot() -> None:
    """Size the six joints of a robot at once."""
    sizing = antrieb.size([joint(*each) for each in JOINTS], top=1)
    mass = 0.0
    for each in sizing.axes:
        best = each.ranking[0] if each.ranking else None
        mass += best.mass_kg if best and best.mass_kg else 0.0
        share = f"{100 * best.utilisation:5.1f} %" if best and best.utilisation is not None else ""
        print(f"  {each.axis:12} {each.answer or 'nothing fits':24} {share} {best.tightest if best else ''}")
    print(f"  six actuators weigh {mass:.1f} kg")


def by_duckdb(best: antrieb.Table) -> None:
    """Which code serves how many of the axes: SQL over the Arrow table as it is."""
    if not importlib.util.find_spec("duckdb"):
        print("duckdb is not installed")
        return
    database = library("duckdb").connect()
    database.register("best", best)
    found = database.sql(
        "select code, count(*) as axes, max(utilisation) as most from best "
        "where code is not null group by code order by axes desc limit 5"
    )
    for code, axes, most in found.fetchall():
        print(f"  {code:24} {axes:4} axes, {100 * most:5.1f} % at most")


def main() -> int:
    """Run all of them."""
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "antrieb-examples")
    folder.mkdir(parents=True, exist_ok=True)
    print("1. one axis")
    one_axis(folder)
    print("2. payload and cycle time")
    best = heat_map(folder)
    print("3. six joints of a robot")
    robot()
    print("4. DuckDB over the result")
    by_duckdb(best)
    print(f"pictures: {folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
