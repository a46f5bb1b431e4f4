"""Quantities of a project file in SI: "40 1/min" is 4.18879 rad/s."""

from math import pi

TURN = 2 * pi
UNITS = {
    "kg m^2": 1, "kg cm^2": 1e-4,
    "N m": 1, "N cm": 1e-2,
    "1/min": TURN / 60, "rad/s": 1, "deg/s": TURN / 360,
    "rad/s^2": 1, "deg/s^2": TURN / 360,
    "rad/s^3": 1,
    "N m s/rad": 1,
    "m/s": 1, "mm/s": 1e-3, "m/min": 1 / 60,
    "m/s^2": 1,
    "m/s^3": 1,
    "s": 1, "ms": 1e-3, "min": 60, "h": 3600,
    "mm": 1e-3, "m": 1,
    "kg": 1, "g": 1e-3, "kg/m^3": 1, "kg/dm^3": 1e3,
    "N": 1, "kN": 1e3,
    "deg": TURN / 360, "rad": 1,
    "V": 1, "A": 1, "ohm": 1, "mH": 1e-3, "W": 1,
    "N m/A": 1,
    "N m/rad": 1,
    "V/1000 1/min": 60 / (1000 * TURN),
    "A/(1/min)": 60 / TURN,
}  # fmt: skip


def si(text):
    """Value in SI of a text with number and unit; temperatures in degrees Celsius."""
    number, unit = text.split(" ", 1)
    return float(number) if unit == "degC" else float(number) * UNITS[unit]


def dimension(text):
    """`line` for a quantity along a line, `turn` for one of rotation."""
    return "line" if text.split(" ", 1)[1].startswith("m") else "turn"
