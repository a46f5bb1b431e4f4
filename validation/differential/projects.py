"""Random projects: every mechanism, every law, friction, efficiency, payload, process, loads on the flange.

A cycle is made of blocks that come back to where they began. Speeds, torques and times suit an actuator that is drawn
first; what asks more than it can give is drawn again.
"""

from math import pi

import numpy as np

from load import G
from motion import constants

SEED = 20261121
TURNING = ("load", "turntable", "arm", "slider_crank", "table")
ALONG = ("screw", "belt", "conveyor")
NORMALISED = ("trapezoid", "triangle", "polynomial_5", "modified_sine", "modified_trapezoid", "simple_sine", "inclined_sine")
LAWS = NORMALISED + ("manual", "jerk", "through", "recorded")
CASES_EACH = 9


def short(value, digits=4):
    """A number with few digits, as a person writes it."""
    text = f"{value:.{digits}g}"
    return repr(float(text)) if "e" in text else text


class Author:
    """Writes one project."""

    def __init__(self, rng, kind, data):
        self.rng, self.kind, self.data = rng, kind, data
        self.top = data["n_mot_max"] / data["i"] * pi / 30
        self.stall, self.most = data["T_0"], data["T_max"]
        self.files, self.k, self.segments, self.boundaries = {}, None, [], []
        self.start, self.recorded_position, self.mirror = 0.0, False, True

    def between(self, low, high):
        return float(self.rng.uniform(low, high))

    def chance(self, share):
        return self.rng.random() < share

    def pick(self, *choices):
        return choices[int(self.rng.integers(len(choices)))]

    # What is moved.

    def mechanism(self):
        text, own = self.draw_mechanism(), self.data["J_out"]
        losses = {}
        if self.kind != "joint":
            if self.chance(0.7):
                losses["friction_torque"] = f"{short(self.between(0.01, 0.1) * self.stall)} N m"
            if self.chance(0.5):
                losses["viscous_friction"] = f"{short(self.between(0.02, 0.15) * self.stall / self.top)} N m s/rad"
            if self.chance(0.3):
                losses["external_torque"] = f"{short(self.between(-0.15, 0.15) * self.stall)} N m"
        if self.kind not in ("joint", "load") and self.chance(0.6):
            losses["efficiency"] = float(short(self.between(0.6, 0.97)))
            if self.chance(0.6):
                losses["efficiency_back"] = float(short(self.between(0, 0.95)))
        self.inertia += own
        return text | losses

    def draw_mechanism(self):
        own, stall = self.data["J_out"], self.stall
        self.inertia = own * self.between(0.1, 3)
        if self.kind == "load":
            return {"inertia": f"{short(self.inertia)} kg m^2"}
        if self.kind == "joint":
            return {"inertia": f"{short(self.inertia)} kg m^2", "holding_torque": f"{short(stall / 2)} N m"}
        if self.kind == "arm":
            mass, reach = self.draw_weight()
            self.start = self.between(-180, 180)
            self.inertia = mass * reach**2 * self.between(1.05, 1.4)
            return {
                "inertia": f"{short(self.inertia)} kg m^2",
                "mass": f"{short(mass)} kg",
                "centre_distance": f"{short(reach * 1000)} mm",
                "axis_tilt": f"{short(self.between(5, 90))} deg",
                "start_angle": self.start_text(),
                "payload_distance": f"{short(reach * 1500)} mm",
            }
        if self.kind == "turntable":
            # A plate, clamps spaced evenly on it, and one box that unbalances it.
            diameter = (32 * own * self.between(0.3, 1.5) / (pi * 7850 * 0.02)) ** 0.25
            height = short(20 * self.between(0.7, 1.3))
            edge = 0.4 * diameter
            lump = min(0.3 * stall / (G * edge), own / edge**2) * self.between(0.2, 1)
            self.inertia = 7850 * pi / 32 * diameter**4 * float(height) / 1000 + 2 * lump * edge**2
            bodies = [f"disc diameter={short(diameter * 1000)}mm length={height}mm density=7850kg/m^3"]
            clamps = f"box a=30mm b=20mm height=25mm mass={short(lump / 4)}kg distance={short(edge * 1000)}mm count=4"
            bodies.append(clamps)
            result = {"bodies": bodies}
            if self.chance(0.8):
                angle = short(self.between(-170, 170))
                bodies.append(f"sphere diameter=40mm mass={short(lump)}kg distance={short(edge * 1000)}mm angle={angle}deg")
                self.start = self.between(-180, 180)
                result |= {"axis_tilt": f"{short(self.between(10, 90))} deg", "start_angle": self.start_text()}
            if self.chance(0.5):
                result["payload_distance"] = f"{short(edge * 900)} mm"
            return result
        if self.kind == "slider_crank":
            crank = self.between(0.03, 0.15)
            rod = crank * self.between(1.6, 5)
            mass = min(0.5 * stall / (G * crank), own / crank**2) * self.between(0.2, 1)
            self.start = self.between(-180, 180)
            wheel = own * self.between(0.05, 0.5)
            self.inertia = wheel + mass * crank**2
            return {
                "crank": f"{short(crank * 1000)} mm",
                "rod": f"{short(rod * 1000)} mm",
                "mass": f"{short(mass)} kg",
                "start_angle": self.start_text(),
                "inertia": f"{short(wheel)} kg m^2",
                "inclination": f"{short(self.between(-90, 90))} deg",
                "process_force": f"{short(self.between(-0.2, 0.3) * stall / crank)} N",
            }
        if self.kind == "table":
            return self.draw_table()
        return self.draw_line()

    def draw_weight(self):
        reach = self.between(0.1, 0.5)
        return min(0.6 * self.stall / (G * reach), 2 * self.data["J_out"] / reach**2) * self.between(0.3, 1), reach

    def start_text(self):
        self.start = float(short(self.start))
        return f"{short(self.start)} deg"

    def draw_table(self):
        points = int(self.rng.integers(4, 8))
        low, high = (0.0, 360.0) if self.chance(0.5) else (-170.0, 170.0)
        places = np.linspace(low, high, points)
        places[1:-1] += self.rng.uniform(-0.3, 0.3, points - 2) * (high - low) / points
        inertias = self.data["J_out"] * self.rng.uniform(0.2, 2.5, points)
        torques = self.stall * self.rng.uniform(-0.5, 0.5, points)
        if high == 360:
            inertias[-1], torques[-1] = inertias[0], torques[0]
        self.start = self.between(low + 10, low + 50)
        self.inertia = float(inertias.max())
        rows = [[f"{short(p)} deg", f"{short(j)} kg m^2", f"{short(t)} N m"] for p, j, t in zip(places, inertias, torques)]
        return {"points": rows, "start_angle": self.start_text()}

    def draw_line(self):
        own, stall = self.data["J_out"], self.stall
        if self.kind == "screw":
            lead = self.pick(5, 10, 16, 20, 25, 40)
            key, size, self.k = "lead", lead, lead / 1000 / (2 * pi)
        else:
            size = float(short(self.between(50, 200)))
            key, self.k = "pulley_diameter" if self.kind == "belt" else "roller_diameter", size / 2000
        mass = min(0.6 * stall / (G * self.k), 2 * own / self.k**2) * self.between(0.1, 1)
        wheel = own * self.between(0.01, 0.2)
        self.inertia = wheel + mass * self.k**2
        slope = self.pick(None, 90, -90, self.between(-80, 80))
        result = {key: f"{size} mm", "mass": f"{short(mass)} kg", "inertia": f"{short(wheel)} kg m^2"}
        if slope is not None:
            result["inclination"] = f"{short(slope)} deg"
            if self.kind != "conveyor" and self.chance(0.4):
                result["counterweight"] = f"{short(mass * self.between(0.3, 1.1))} kg"
        if self.chance(0.6):
            result["friction_force"] = f"{short(self.between(0.01, 0.1) * stall / self.k)} N"
        if self.chance(0.6):
            result["friction_coefficient"] = float(short(self.between(0.005, 0.1)))
        if self.chance(0.3):
            result["process_force"] = f"{short(self.between(-0.2, 0.2) * stall / self.k)} N"
        return result

    # How it is moved.

    def way(self, angle):
        """A distance of the output, as angle or, on a line, sometimes as length."""
        if self.k is not None and self.lines:
            return f"{short(angle * self.k * 1000, 5)} mm"
        return f"{short(angle * 180 / pi, 5)} deg"

    def pace(self, speed):
        return f"{short(speed * self.k)} m/s" if self.k is not None and self.lines else f"{short(speed * 30 / pi)} 1/min"

    def push(self, acc):
        return f"{short(acc * self.k)} m/s^2" if self.k is not None and self.lines else f"{short(acc)} rad/s^2"

    def jerk(self, jerk):
        return f"{short(jerk * self.k)} m/s^3" if self.k is not None and self.lines else f"{short(jerk)} rad/s^3"

    def draw_move(self, law):
        """Largest speed, acceleration and way of a move of the law."""
        speed, acc = self.between(0.2, 0.85) * self.top, self.between(0.08, 0.35) * self.most / self.inertia
        c_v, c_a = constants(law if law in NORMALISED else "trapezoid")
        angle = speed**2 * c_a / (c_v**2 * acc) * self.between(0.4, 1.5)
        if self.kind in ("table", "arm", "slider_crank", "turntable") and self.chance(0.8):
            angle = min(angle, self.between(0.3, 4.5))
        if self.kind == "table":
            angle = min(angle, 4.6)
        time = max(c_v * angle / speed, (c_a * angle / acc) ** 0.5)
        return angle, time, acc

    def there_and_back(self, law):
        angle, time, acc = self.draw_move(law)
        back = law if law in ("manual", "through") else self.pick(*NORMALISED, "jerk", law)
        if law == "manual":
            speed = self.pace(angle / time * 1.5)
            ramps = [short(self.between(0.2, 0.5) * time) for _ in range(3)]
            pauses = [short(self.between(0, 1)) for _ in range(2)]
            for sign, pause in zip(("", "-"), pauses):
                times = dict(zip(("accelerate", "run", "brake", "pause"), [f"{x} s" for x in (*ramps, pause)]))
                self.segments.append({"law": law, "speed": sign + speed} | times)
        elif law == "through":
            self.through(angle, time, 1)
            self.pause()
            self.through(angle, time, -1)
        else:
            self.one(law, angle, time, 1)
            self.pause()
            self.one(back, angle, time * self.between(1, 1.4), -1)

    def one(self, law, angle, time, sign):
        minus = "-" if sign < 0 else ""
        segment = {"law": law, "distance": minus + self.way(angle)}
        ramp = self.between(0.15, 0.4)
        if law == "jerk":
            speed = angle / (time * (1 - ramp))
            acc = speed / (ramp * time)
            jerk = acc / (self.between(0.1, 0.8) * ramp * time)
            segment |= {"speed": self.pace(speed), "acceleration": self.push(acc), "jerk": self.jerk(jerk)}
        elif law == "trapezoid" and self.chance(0.8):
            speed = angle / (time * (1 - ramp))
            more = {"time": f"{short(time, 5)} s", "speed": self.pace(speed), "acceleration": self.push(speed / (ramp * time))}
            left_out = self.pick("time", "speed", "acceleration")
            segment |= {key: value for key, value in more.items() if key != left_out}
        else:
            c_v, c_a = constants(law)
            more = {"time": f"{short(time, 5)} s", "speed": self.pace(c_v * angle / time)}
            more["acceleration"] = self.push(c_a * angle / time**2)
            key = self.pick("time", "speed", "acceleration")
            segment[key] = more[key]
        self.segments.append(segment)

    def through(self, angle, time, sign):
        """Into motion, on at constant speed, and to rest; the way back is the mirror."""
        if sign > 0:
            speed = 1.2 * angle / time
            acc, share = speed / (0.3 * time), self.between(1.05, 2)
            law = self.pick("trapezoid", "jerk", "polynomial_5")
            pace, into = self.pace(speed), self.way(speed * 0.15 * time * share)
            first = {"law": law, "distance": into, "end_speed": pace}
            if law == "polynomial_5":
                first["time"] = f"{short(self.between(0.2, 0.5) * time)} s"
            else:
                first |= {"speed": self.pace(1.3 * speed), "acceleration": self.push(acc)}
            if law == "jerk":
                first["jerk"] = self.jerk(acc / (0.1 * time))
            run = {"law": "constant", "speed": pace, "time": f"{short(self.between(0.1, 0.4) * time)} s"}
            last = {key: value for key, value in first.items() if key != "end_speed"}
            self.template = [first, run, last]
        for segment in self.template:
            turned = {key: f"-{value}" for key, value in segment.items() if key == "distance" or key == "end_speed"}
            if segment["law"] == "constant":
                turned["speed"] = f"-{segment['speed']}"
            self.segments.append(segment | (turned if sign < 0 else {}))

    def recorded(self):
        """A swing with its rests as samples, in one of the forms that a recording has."""
        angle, time, _ = self.draw_move("polynomial_5")
        count = int(self.rng.integers(24, 48))
        form = self.pick("position,speed", "speed", "position")
        if self.kind == "joint":
            form = "position,speed"
        t = np.linspace(0, 2.2 * time, count)
        u = np.clip((t - 0.1 * time) / (2 * time), 0, 1)
        shape = np.sin(2 * pi * u) ** 3 if self.chance(0.3) else np.sin(pi * u) ** 4
        slope = np.gradient(shape, t)
        slope[u <= 0], slope[u >= 1] = 0, 0
        # Three samples of rest at both ends.
        for places in (slice(0, 3), slice(-3, None)):
            slope[places], shape[places] = 0, 0
        angle = min(angle, 0.8 * self.top / max(np.abs(slope).max(), 1e-9))
        line = self.k is not None and self.lines
        factor, units = (self.k, ("mm", "m/s")) if line else (1.0, ("deg", "1/min"))
        scale = (1000 * factor, factor) if line else (180 / pi, 30 / pi)
        columns, names = [t], ["time [s]"]
        if "position" in form:
            columns.append(np.array([0 if s == 0 else angle * s * scale[0] for s in shape]) + self.start)
            names.append(f"position [{units[0]}]")
            self.recorded_position = True
        if "speed" in form:
            columns.append(angle * slope * scale[1])
            names.append(f"speed [{units[1]}]")
        if self.kind == "joint" or self.chance(0.4):
            size = self.between(0.1, 0.4) * self.stall
            torque = size * np.cos(2 * pi * t / time) + 0.2 * size * np.sin(7 * t / time)
            if self.kind == "joint":
                torque = torque + self.inertia * np.gradient(angle * slope, t)
            names.append("force [N]" if line else "torque [N m]")
            columns.append(torque / self.k if line else torque)
        # Speeds alone must come back to where they began.
        rows = np.round(np.stack(columns, axis=1), 4)
        if form == "speed":
            rows[:, 1] = self.closed(rows[:, 0], rows[:, 1])
        name = f"log{len(self.files)}.csv"
        lines = [",".join(names)] + [",".join(f"{x + 0.0:.10g}" for x in row) for row in rows]
        self.files[name] = "\n".join(lines) + "\n"
        self.segments.append({"law": "recorded", "file": name})

    @staticmethod
    def closed(t, speed):
        """Speeds whose integral is zero to the last digits: the moving ones are shifted a little."""
        inner = speed != 0
        for _ in range(4):
            gone = np.sum(np.diff(t) * (speed[1:] + speed[:-1]) / 2)
            weight = np.sum(np.diff(t) * (inner[1:] + 0.0 + inner[:-1]) / 2)
            speed = np.where(inner, speed - gone / weight, speed)
        return speed

    def pause(self):
        if self.kind != "joint" and self.chance(0.75):
            time = self.between(15, 120) if self.slow and self.chance(0.5) else self.between(0.1, 2)
            hold = self.pick("motor", "motor", "free")
            if self.data["brake"]:
                hold = self.pick("motor", "brake")
                time += 1
            self.segments.append({"law": "dwell", "time": f"{short(time)} s", "hold": hold})

    def dress(self):
        """Payload, process and loads on the flange of some segments."""
        for segment in self.segments:
            if self.kind != "joint":
                if self.chance(0.3):
                    segment["payload_inertia"] = f"{short(self.between(0, 0.3) * self.inertia)} kg m^2"
                if self.chance(0.3):
                    segment["process_torque"] = f"{short(self.between(-0.15, 0.15) * self.stall)} N m"
            if self.weighs and self.chance(0.4):
                segment["payload"] = f"{short(self.between(0.05, 0.3) * self.weighs)} kg"
            if self.k is not None and self.chance(0.25):
                segment["process_force"] = f"{short(self.between(-0.15, 0.15) * self.stall / self.k)} N"
            if self.flange and self.chance(0.4):
                segment["bearing"] = self.forces()

    def forces(self):
        pitch = self.data["d_p"]
        radial = {"radial_force": f"{short(self.between(50, 800))} N"}
        radial["radial_distance"] = f"{short(self.between(0, 1500) * pitch)} mm"
        axial = {"axial_force": f"{short(self.between(50, 1500))} N"}
        axial["axial_distance"] = f"{short(self.between(0, 1000) * pitch)} mm"
        return self.pick(radial | axial, radial, axial)

    def project(self, laws):
        self.lines, self.slow, self.flange = self.chance(0.6), self.chance(0.3), self.chance(0.7)
        moved = self.mechanism()
        mass = moved.get("mass")
        self.weighs = float(mass.split(" ")[0]) if mass else 0.0
        if self.kind == "turntable" and "payload_distance" in moved:
            self.weighs = 0.2 * self.inertia / (float(moved["payload_distance"].split(" ")[0]) / 1000) ** 2
        for law in laws:
            self.boundaries.append(len(self.segments))
            if law == "recorded":
                self.recorded()
            else:
                self.there_and_back(law)
            self.pause()
        if self.kind in ("load", "conveyor") and not self.recorded_position and self.chance(0.5):
            # These need not come back.
            self.boundaries.append(len(self.segments))
            angle, time, _ = self.draw_move("triangle")
            law = self.pick(*NORMALISED)
            c_v, c_a = constants(law)
            given = {"time": f"{short(time)} s", "acceleration": self.push(c_a * angle / time**2)}
            given["speed"] = self.pace(c_v * angle / time)
            left_out = self.pick(*given)
            # Time and acceleration tell no direction.
            self.mirror = left_out != "speed"
            self.segments.append({"law": law} | {key: value for key, value in given.items() if key != left_out})
        self.dress()
        needs = {"supply": "48 V" if self.data["U_DCmax"] == 48 else "560 V"}
        needs["ambient"] = f"{short(self.between(2, 40), 3)} degC"
        parts = {"load" if self.kind == "load" else f"mechanism.{self.kind}": moved}
        text = "format = 1\n" + "".join(table(f"[{name}]", keys) for name, keys in parts.items())
        for segment in self.segments:
            forces = segment.pop("bearing", None)
            text += table("[[motion]]", segment) + (table("[motion.bearing]", forces) if forces else "")
            if forces:
                segment["bearing"] = forces
        if self.flange:
            more = {"load_factor": float(short(self.between(1, 2), 3)), "operating_condition": "normal"}
            # Beside loads of its own the file says that the stated ones are all of them.
            own = {} if self.kind in ("load", "table", "joint") else {"mechanism": "ignore"}
            text += table("[bearing]", own | self.forces() | more)
        return text + table("[requirements]", needs)

    def rotations(self):
        """Segments with which the cycle may begin as well: those that begin at rest, and where they begin at the output."""
        if self.recorded_position:
            return self.boundaries[1:2]
        moving, result = False, []
        for index, segment in enumerate(self.segments):
            if not moving and index > 0:
                result.append(index)
            moving = "end_speed" in segment or (segment["law"] == "constant" and moving)
        return result[:: max(1, len(result) // 2)][:2]


def table(head, keys):
    def shown(value):
        if isinstance(value, str):
            return f'"{value}"'
        if isinstance(value, list):
            return "[" + ", ".join(shown(item) for item in value) + "]"
        return repr(value)

    return "\n" + head + "\n" + "".join(f"{key} = {shown(value)}\n" for key, value in keys.items())


def bearable(quick, data):
    """What the actuator can give, with some room for warmth."""
    speed = data["n_mot_max"] / data["i"]
    return quick["T_peak"] < data["T_max"] and quick["n_peak"] < speed and quick["T_rms"] < 0.9 * data["T_0"]


def projects(actuators, quick, results):
    """Each case with its expected results."""
    rng = np.random.default_rng(SEED)
    codes = list(actuators)
    number = 0
    for kind in (*TURNING, *ALONG, "joint"):
        laws = ["recorded"] if kind == "joint" else list(LAWS)
        count = 5 if kind == "joint" else CASES_EACH
        for turn in range(count):
            chosen = [laws[(2 * turn + k) % len(laws)] for k in range(1 if turn % 3 == 2 or kind == "joint" else 2)]
            for _ in range(200):
                code = codes[int(rng.integers(len(codes)))]
                data = actuators[code] | {"brake": code.endswith("-B")}
                author = Author(rng, kind, data)
                text = author.project(chosen)
                if bearable(quick(text, author.files, code), data):
                    break
            else:
                raise SystemExit(f"no bearable project for {kind}")
            number += 1
            yield {
                "name": f"{number:02} {kind}: {', '.join(chosen)}",
                "code": code,
                "project": text,
                "files": author.files,
                "rotations": author.rotations(),
                "mirror": author.mirror,
                "expect": results(text, author.files, code),
            }
