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

# Their position zero is a place of the mechanism: such a cycle begins nowhere else, and its mirror image is another machine.
LINKAGES = {
    "hoist on three falls with rope and counterweight": (
        "CHA-32A-100-H-M512P",
        '\n[mechanism.hoist]\ndrum_diameter = "300 mm"\nfalls = 3\nmass = "150 kg"\ncounterweight = "40 kg"\n'
        'rope_mass = "9 kg"\nhanging = "5 m"\ninertia = "0.8 kg m^2"\nsheave_efficiency = 0.97\nefficiency = 0.93\n'
        'efficiency_back = 0.8\nfriction_torque = "3 N m"\n'
        + motion(
            {"law": "polynomial_5", "distance": "2.5 m", "time": "30 s", "payload": "120 kg", "process_force": "80 N"},
            REST,
            {"law": "jerk", "distance": "-2500 mm", "speed": "0.12 m/s", "acceleration": "0.1 m/s^2", "jerk": "0.4 m/s^3"},
            REST,
        ),
    ),
    "hoist on one fall, driven by the load": (
        "CHA-25A-50-H-C1024",
        '\n[mechanism.hoist]\ndrum_diameter = "160 mm"\nmass = "30 kg"\nrope_mass = "2 kg"\nhanging = "4 m"\n'
        'inertia = "0.02 kg m^2"\nefficiency_back = 0.9\nviscous_friction = "0.2 N m s/rad"\n'
        + motion(
            {"law": "trapezoid", "distance": "3 m", "speed": "0.6 m/s", "acceleration": "1.5 m/s^2"},
            REST,
            {"law": "modified_sine", "distance": "-3 m", "time": "7 s", "process_torque": "2 N m"},
        ),
    ),
    "winder, up and off again": (
        "CHA-32A-100-H-M512P",
        '\n[mechanism.winder]\nwinding = "up"\ncore_diameter = "90 mm"\nfull_diameter = "500 mm"\nstart_diameter = "100 mm"\n'
        'thickness = "6 mm"\nwidth = "600 mm"\ndensity = "900 kg/m^3"\ntension = "150 N"\ninertia = "0.05 kg m^2"\n'
        'friction_torque = "2 N m"\nefficiency = 0.95\nefficiency_back = 0.9\n'
        + motion(
            {"law": "trapezoid", "distance": "10800 deg", "speed": "40 1/min", "acceleration": "3 rad/s^2"},
            REST,
            {"law": "polynomial_5", "distance": "-10800 deg", "time": "100 s", "process_torque": "5 N m"},
        ),
    ),
    "winder, off from the full roll": (
        "CHA-40A-80-H-C1024",
        '\n[mechanism.winder]\nwinding = "off"\ncore_diameter = "150 mm"\nfull_diameter = "700 mm"\nstart_diameter = "700 mm"\n'
        'thickness = "10 mm"\nwidth = "400 mm"\ndensity = "700 kg/m^3"\ntension = "250 N"\nfriction_torque = "5 N m"\n'
        + motion(
            {"law": "jerk", "distance": "7200 deg", "speed": "25 1/min", "acceleration": "1 rad/s^2", "jerk": "4 rad/s^3"},
            REST,
            {"law": "jerk", "distance": "-7200 deg", "speed": "25 1/min", "acceleration": "1 rad/s^2", "jerk": "4 rad/s^3"},
        ),
    ),
    "scissor lift with two stages": (
        "CHA-20A-30-H-C1024",
        '\n[mechanism.scissor_lift]\nstages = 2\narm_length = "900 mm"\nlead = "10 mm"\narm_angle = "15 deg"\nmass = "80 kg"\n'
        'arm_mass = "30 kg"\ninertia = "0.002 kg m^2"\nefficiency = 0.85\nefficiency_back = 0.5\nfriction_torque = "0.5 N m"\n'
        + motion(
            {"law": "polynomial_5", "distance": "7200 deg", "time": "20 s", "payload": "40 kg"},
            REST,
            {"law": "trapezoid", "distance": "-7200 deg", "speed": "80 1/min", "acceleration": "8 rad/s^2"},
            REST,
        ),
    ),
    "scissor lift with heavy arms, quick": (
        "CHA-25A-50-H-C1024",
        '\n[mechanism.scissor_lift]\nstages = 3\narm_length = "600 mm"\nlead = "40 mm"\narm_angle = "25 deg"\nmass = "10 kg"\n'
        'arm_mass = "36 kg"\ninertia = "0.004 kg m^2"\nefficiency = 0.9\n'
        + motion(
            {"law": "modified_sine", "distance": "1800 deg", "time": "3.5 s", "process_force": "100 N"},
            REST,
            {"law": "polynomial_5", "distance": "-1800 deg", "time": "4 s"},
        ),
    ),
    "four-bar linkage, many revolutions": (
        "CHA-32A-50-H-C1024",
        '\n[mechanism.four_bar]\nground = "400 mm"\ncrank = "100 mm"\ncoupler = "350 mm"\nrocker = "250 mm"\n'
        'inertia = "0.02 kg m^2"\ncoupler_mass = "2.5 kg"\ncoupler_centre = "150 mm"\ncoupler_inertia = "0.03 kg m^2"\n'
        'rocker_mass = "3 kg"\nrocker_centre = "120 mm"\nrocker_inertia = "0.4 kg m^2"\nrocker_torque = "6 N m"\n'
        'axis_tilt = "70 deg"\ninclination = "20 deg"\nstart_angle = "15 deg"\nfriction_torque = "1 N m"\n'
        + motion({"law": "trapezoid", "distance": "3600 deg", "speed": "50 1/min", "acceleration": "10 rad/s^2"}, REST),
    ),
    "four-bar linkage, crossed, to and fro": (
        "CHA-25A-160-H-C1024",
        '\n[mechanism.four_bar]\nground = "400 mm"\ncrank = "100 mm"\ncoupler = "350 mm"\nrocker = "250 mm"\ncrossed = true\n'
        'coupler_mass = "4 kg"\ncoupler_centre = "175 mm"\ncoupler_inertia = "0.05 kg m^2"\nrocker_mass = "5 kg"\n'
        'rocker_centre = "125 mm"\nrocker_inertia = "0.6 kg m^2"\naxis_tilt = "90 deg"\nstart_angle = "-40 deg"\n'
        'efficiency = 0.9\nefficiency_back = 0.8\nviscous_friction = "0.5 N m s/rad"\n'
        + motion(
            {"law": "polynomial_5", "distance": "200 deg", "time": "3 s", "process_torque": "4 N m"},
            REST,
            {"law": "modified_sine", "distance": "-200 deg", "time": "2.5 s"},
        ),
    ),
}


def specials():
    """Name, code, text, the segments with which the cycle may begin as well, and whether its mirror image is known."""
    cases = [(name, *case, True) for name, case in SPECIALS.items()]
    for name, code, text, rotations, mirror in cases + [(name, *case, [], False) for name, case in LINKAGES.items()]:
        needs = LOADS.replace("560 V", "48 V") if "-E-" in code else LOADS
        yield name, code, "format = 1\n" + text + needs, rotations, mirror
