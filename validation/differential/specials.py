"""Projects written by hand: what has been wrong once, and what chance rarely draws."""

LOADS = """
[requirements]
supply = "560 V"
ambient = "25 degC"
"""


def motion(*segments):
    def lines(keys):
        return "".join(f'{key} = "{value}"\n' for key, value in keys.items())

    return "".join("\n[[motion]]\n" + lines(segment) for segment in segments)


REST = {"law": "dwell", "time": "0.8 s", "hold": "motor"}

SPECIALS = {
    "torque near zero where a move ends": (
        "CHA-14A-50-E-RES",
        '\n[load]\ninertia = "0.001 kg m^2"\nfriction_torque = "5 N m"\nexternal_torque = "-20 N m"\n'
        + motion(
            {"law": "modified_sine", "distance": "-45 deg", "time": "0.8 s", "process_torque": "20 N m"},
            {
                "law": "jerk",
                "distance": "45 deg",
                "speed": "16.2 1/min",
                "acceleration": "1.35 rad/s^2",
                "jerk": "1650 rad/s^3",
            },
        ),
        [1],
    ),
    "peak inside a phase of jerk, strong viscous friction": (
        "CHA-20A-30-H-C1024",
        '\n[load]\ninertia = "1.18 kg m^2"\nviscous_friction = "16.127 N m s/rad"\n'
        + motion(
            *(
                {
                    "law": "jerk",
                    "distance": f"{sign}1 rad",
                    "speed": "10 rad/s",
                    "acceleration": "10 rad/s^2",
                    "jerk": "60 rad/s^3",
                }
                for sign in ("", "-")
            ),
            REST,
        ),
        [1, 2],
    ),
    "arm, many revolutions in one segment": (
        "CHA-20A-30-H-C1024",
        '\n[mechanism.arm]\ninertia = "0.05 kg m^2"\nmass = "3 kg"\ncentre_distance = "110 mm"\naxis_tilt = "90 deg"\n'
        'start_angle = "-30 deg"\nfriction_torque = "0.7 N m"\nefficiency = 0.9\nefficiency_back = 0.7\n'
        + motion(
            {"law": "trapezoid", "distance": "72000 deg", "speed": "100 1/min", "acceleration": "20 rad/s^2"},
            REST,
            {"law": "polynomial_5", "distance": "-7200 deg", "time": "30 s"},
        ),
        [1, 2],
    ),
    "slider-crank, many revolutions in one segment": (
        "CHA-20A-30-H-C1024",
        '\n[mechanism.slider_crank]\ncrank = "60 mm"\nrod = "150 mm"\nmass = "6 kg"\nstart_angle = "10 deg"\n'
        'inertia = "0.01 kg m^2"\nprocess_force = "30 N"\nfriction_torque = "0.7 N m"\n'
        + motion({"law": "trapezoid", "distance": "36000 deg", "speed": "90 1/min", "acceleration": "20 rad/s^2"}, REST),
        [1],
    ),
    "constant speed without end": (
        "CHA-32A-50-H-C1024",
        '\n[load]\ninertia = "0.5 kg m^2"\nfriction_torque = "12 N m"\n'
        + motion(
            {"law": "constant", "speed": "35 1/min", "time": "40 s", "process_torque": "25 N m"},
            {"law": "constant", "speed": "35 1/min", "time": "20 s"},
        ),
        [],
    ),
    "minutes of work and minutes of rest": (
        "CHA-25A-50-H-C1024",
        '\n[load]\ninertia = "0.5 kg m^2"\nfriction_torque = "62 N m"\n'
        + motion(
            {"law": "trapezoid", "distance": "10000 deg", "speed": "20 1/min", "acceleration": "5 rad/s^2"},
            {"law": "dwell", "time": "7 min", "hold": "free"},
        ),
        [1],
    ),
    "held by the brake": (
        "CHA-58A-160-H-C1024-B",
        '\n[mechanism.belt]\npulley_diameter = "200 mm"\nmass = "300 kg"\ninclination = "90 deg"\n'
        'friction_coefficient = 0.01\nefficiency = 0.95\nefficiency_back = 0.9\n'
        + motion(
            {"law": "jerk", "distance": "1.5 m", "speed": "9 m/min", "acceleration": "0.5 m/s^2", "jerk": "4 m/s^3"},
            {"law": "dwell", "time": "30 s", "hold": "brake"},
            {"law": "modified_sine", "distance": "-1500 mm", "time": "12 s", "payload": "200 kg"},
            {"law": "dwell", "time": "5 s", "hold": "brake"},
        ),
        [1, 3],
    ),
}


def specials():
    """Name, code, text, and the segments with which the cycle may begin as well."""
    for name, (code, text, rotations) in SPECIALS.items():
        needs = LOADS.replace("560 V", "48 V") if "-E-" in code else LOADS
        yield name, code, "format = 1\n" + text + needs, rotations
