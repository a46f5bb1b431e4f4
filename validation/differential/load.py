"""Torque that each mechanism asks at the output, from Newton's law on its moving masses."""

import re
from math import cos, hypot, pi, sin, sqrt

import numpy as np

from linkages import LINKAGES
from quantity import si

G = 9.80665


def body(text):
    """Inertia about the axis, mass and the two coordinates of the centre of one kind of body, all its pieces together."""
    shape, *pairs = text.split(" ")
    raw = dict(pair.split("=") for pair in pairs)

    def value(key, default=0.0):
        if key not in raw:
            return default
        return si(" ".join(re.fullmatch(r"([-+.0-9]+)(.*)", raw[key]).groups()))

    count = int(raw.get("count", "1"))
    if shape == "disc":
        d, length = value("diameter"), value("length")
        volume, per_mass = pi / 4 * d**2 * length, d**2 / 8
    elif shape == "tube":
        o, i, length = value("outer"), value("inner"), value("length")
        volume, per_mass = pi / 4 * (o**2 - i**2) * length, (o**2 + i**2) / 8
    elif shape == "box":
        a, b, h = value("a"), value("b"), value("height")
        volume, per_mass = a * b * h, (a**2 + b**2) / 12
    elif shape == "sphere":
        d = value("diameter")
        volume, per_mass = pi / 6 * d**3, d**2 / 10
    else:
        volume, per_mass = 0.0, 0.0
    mass = value("mass") if "mass" in raw else value("density") * volume
    r, phi = value("distance"), value("angle")
    places = [(r * cos(phi + 2 * pi * k / count), r * sin(phi + 2 * pi * k / count)) for k in range(count)]
    inertia = sum(mass * (per_mass + x * x + y * y) for x, y in places)
    return inertia, mass * count, sum(mass * x for x, _ in places), sum(mass * y for _, y in places)


class Load:
    """What lies between the output and the load. `useful` is the torque without losses at the output."""

    travel = None

    def __init__(self, project):
        self.segments = project["motion"]
        if "load" in project:
            self.kind, self.key = "load", project["load"]
        else:
            ((self.kind, self.key),) = project["mechanism"].items()
        self.start = self.get("start_angle")
        self.coulomb, self.viscous = self.get("friction_torque"), self.get("viscous_friction")
        self.external = self.get("external_torque")
        self.eta = self.key.get("efficiency", 1.0)
        self.eta_back = self.key.get("efficiency_back", 1.0)
        self.turns_with_position = self.kind in ("turntable", "arm", "slider_crank", "four_bar")
        self.arm, self.mass, self.phase = 0.0, 0.0, 0.0
        getattr(self, f"prepare_{self.kind}", lambda: None)()
        self.linkage = LINKAGES[self.kind](self) if self.kind in LINKAGES else None
        stage = project.get("stage", {})
        self.ratio = stage.get("ratio", 1.0)
        self.stage_eta, self.stage_back = stage.get("efficiency", 1.0), stage.get("efficiency_back", 1.0)
        self.driving = si(stage.get("inertia_driving", "0 kg m^2"))
        self.driven = si(stage.get("inertia_driven", "0 kg m^2"))

    def get(self, key, default=0.0):
        return si(self.key[key]) if key in self.key else default

    def extra(self, segment, key):
        table = self.segments[segment]
        return si(table[key]) if key in table else 0.0

    def prepare_screw(self):
        self.travel = self.get("lead") / (2 * pi)

    def prepare_belt(self):
        self.travel = self.get("pulley_diameter") / 2

    def prepare_conveyor(self):
        self.travel = self.get("roller_diameter") / 2

    def prepare_hoist(self):
        falls, sheave = self.key.get("falls", 1), self.key.get("sheave_efficiency", 1.0)
        self.travel = self.get("drum_diameter") / 2 / falls
        # The pull of each fall is that of the one before, less the loss of a sheave.
        self.reeving = sum(sheave**k for k in range(falls)) / falls

    def prepare_turntable(self):
        found = [sum(values) for values in zip(*[body(text) for text in self.key["bodies"]])]
        self.inertia, self.mass, x, y = found
        self.arm = hypot(x, y) / self.mass if hypot(x, y) > 1e-12 * self.mass else 0.0
        self.phase = np.arctan2(y, x) if self.arm > 0 else 0.0

    def prepare_arm(self):
        self.inertia, self.mass, self.arm, self.phase = self.get("inertia"), self.get("mass"), self.get("centre_distance"), 0.0

    def prepare_table(self):
        rows = [[si(cell) for cell in row] for row in self.key["points"]]
        self.at, self.inertias, self.holding = (np.array(column) for column in zip(*rows))
        span = self.at[-1] - self.at[0]
        ends = self.inertias[0] == self.inertias[-1] and self.holding[0] == self.holding[-1]
        self.periodic = abs(span - 2 * pi) < 1e-9 and ends

    def table_angle(self, q):
        return self.at[0] + np.mod(q - self.at[0], 2 * pi) if self.periodic else q

    def corners(self, low, high):
        """Positions between which the load is smooth."""
        if self.kind != "table":
            return []
        if not self.periodic:
            return list(self.at)
        turns = range(int(np.floor((low - self.at[-1]) / (2 * pi))), int(np.ceil((high - self.at[0]) / (2 * pi))) + 1)
        return [point + 2 * pi * turn for turn in turns for point in self.at]

    def sheaves(self, ropes, a, sign):
        """Losses of both reevings: one rope is lifted while the other is lowered; no help while the ropes drive."""
        if sign == 0:
            return 0.0
        balance = self.get("counterweight") * (G - self.travel * a) * self.travel
        lifted, lowered = (ropes + balance, balance) if sign > 0 else (balance, ropes + balance)
        opposing = lifted / self.reeving - lowered * self.reeving
        opposing = np.where(opposing < 0, opposing / self.reeving, opposing)
        return sign * (opposing - (lifted - lowered))

    def useful(self, segment, q, w, a, sign, recorded):
        """Torque without losses; `sign` is the direction of motion, 0 at rest."""
        inertia = self.extra(segment, "payload_inertia")
        torque = self.external + self.extra(segment, "process_torque") + recorded
        payload = self.extra(segment, "payload")
        force = self.get("process_force") + self.extra(segment, "process_force")
        if self.kind == "load":
            torque = torque + self.get("inertia") * a
        elif self.linkage is not None:
            own = self.linkage.torque(q, w, a, payload, force)
            torque = torque + own
            if self.kind == "hoist":
                torque = torque + self.sheaves(own - self.get("inertia") * a, a, sign)
        elif self.kind in ("arm", "turntable"):
            r = self.get("payload_distance", None)
            reach = payload * r if r is not None else 0.0
            tilt = sin(self.get("axis_tilt"))
            # Position counts from the start angle; the centre of mass of the bodies has a direction of its own.
            weight = self.mass * self.arm * np.cos(q + self.phase) + reach * np.cos(q + self.phase)
            torque = torque + (self.inertia + (reach * r if r is not None else 0.0)) * a + G * tilt * weight
        elif self.travel is not None:
            k, slope = self.travel, self.get("inclination")
            mass, counter = self.get("mass") + payload, self.get("counterweight")
            along = (mass + counter) * k * a + (mass - counter) * G * sin(slope) + force
            rub = self.get("friction_force") + self.key.get("friction_coefficient", 0.0) * mass * G * abs(cos(slope))
            torque = torque + self.get("inertia") * a + k * (along + sign * rub)
        elif self.kind == "slider_crank":
            r, rod, mass = self.get("crank"), self.get("rod"), self.get("mass") + payload
            w_ = np.sqrt(rod**2 - (r * np.sin(q)) ** 2)
            # Speed and acceleration of the slider: the rod has constant length.
            gain = -r * np.sin(q) * (1 + r * np.cos(q) / w_)
            bend = -r * np.cos(q) - r**2 * (np.cos(q) ** 2 - np.sin(q) ** 2) / w_ - (r**2 * np.sin(q) * np.cos(q)) ** 2 / w_**3
            slider = gain * a + bend * w**2
            torque = torque + self.get("inertia") * a + gain * (mass * (slider + G * sin(self.get("inclination"))) + force)
        elif self.kind == "table":
            x = self.table_angle(q)
            j = np.interp(x, self.at, self.inertias)
            middle = self.table_angle(np.mean(q))
            k = int(np.clip(np.searchsorted(self.at, middle) - 1, 0, len(self.at) - 2))
            inside = self.at[0] <= middle <= self.at[-1]
            slope = (self.inertias[k + 1] - self.inertias[k]) / (self.at[k + 1] - self.at[k]) if inside else 0.0
            torque = torque + j * a + slope * w**2 / 2 + np.interp(x, self.at, self.holding)
        return torque + inertia * a

    def holding_torque(self, rest, useful):
        """At rest the motor holds, or the brake does, or nothing; losses do not help."""
        return useful / self.ratio if rest == "motor" else 0.0 * useful

    def handed_on(self, useful, w, a, sign):
        """What the stage hands on to the mechanism; speeds and accelerations are those of the mechanism."""
        return self.moving(useful, w, sign) + self.driven * a

    def at_output(self, handed_on, a, sign):
        """Torque at the output of the actuator: what the stage takes, and its wheel there."""
        back = handed_on * sign < 0
        taken = np.where(back, handed_on * self.stage_back, handed_on / self.stage_eta) / self.ratio
        return taken + self.driving * self.ratio * a

    def moving(self, useful, w, sign):
        """Torque at the output in motion, with the efficiency by the direction of the power and friction."""
        driven = useful * sign < 0
        return np.where(driven, useful * self.eta_back, useful / self.eta) + self.coulomb * sign + self.viscous * w
