"""Forces that weight, motion and process of a mechanism bring to the flange: m (g - a) of what turns with it, and the
reaction of belt, teeth, thread or rod of what does not."""

from math import cos, sin, tan

import numpy as np

from load import G
from quantity import si


class Flange:
    """How the load sits on the flange. `at` gives F_r, F_a and M about the centre of the bearing, `offset` behind the face."""

    def __init__(self, project, load, offset):
        self.keys, self.load, self.offset = project["bearing"], load, offset
        self.share = self.keys.get("flange_share", 1.0)
        self.lever = self.get("overhang") + offset
        self.stage = project.get("stage")

    def get(self, key, default=0.0):
        return si(self.keys[key]) if key in self.keys else default

    def line(self, segment, w, a, sign, recorded):
        """Force along the line, without and with the inertia that may turn behind the belt."""
        load = self.load
        payload, k = load.extra(segment, "payload"), load.travel
        mass, counter, slope = load.get("mass") + payload, load.get("counterweight"), load.get("inclination")
        rub = load.get("friction_force") + load.key.get("friction_coefficient", 0.0) * mass * G * abs(cos(slope))
        push = load.get("process_force") + load.extra(segment, "process_force") + recorded / k
        force = (mass + counter) * k * a + (mass - counter) * G * sin(slope) + push + rub * sign
        # Where the inertia of a segment's payload turns is known no better than that of the mechanism.
        turning = load.get("inertia") + load.extra(segment, "payload_inertia")
        return force, force + turning * a / k

    def rod(self, segment, q, w, a):
        """Force of the rod along the line of the slider, its slope, and the travel of the slider per angle."""
        load = self.load
        r, length = load.get("crank"), load.get("rod")
        psi = np.arcsin(r / length * np.sin(q))
        gain = -r * np.sin(q) - r * np.cos(q) * np.tan(psi)
        # psi' from length cos(psi) psi' = r cos(q)
        psi_1 = r * np.cos(q) / (length * np.cos(psi))
        bend = -r * np.cos(q) + r * np.sin(q) * np.tan(psi) - r * np.cos(q) / np.cos(psi) ** 2 * psi_1
        mass = load.get("mass") + load.extra(segment, "payload")
        force = mass * (gain * a + bend * w**2 + G * sin(load.get("inclination")))
        force = force + load.get("process_force") + load.extra(segment, "process_force")
        return force, np.tan(psi), gain

    def switches(self, segment, q, w, a, sign, recorded):
        """What bends the forces where it changes its sign."""
        if self.stage is not None:
            return []
        if self.load.travel is not None:
            return list(self.line(segment, w, a, sign, recorded))
        if self.load.kind == "slider_crank":
            force, _, gain = self.rod(segment, q, w, a)
            return [force, gain]
        return []

    def lossy(self, force, sign):
        """An amount of force before the losses, which count only while the actuator drives."""
        return np.where(force * sign > 0, np.abs(force) / self.load.eta, np.abs(force))

    def wheel(self, pull, radius):
        """Pull of a belt or force of teeth at its overhang."""
        if "belt_tension" in self.keys:
            radial = 2 * self.get("belt_tension") + pull
            return radial, 0.0 * pull, radial * abs(self.lever)
        helix = self.get("helix_angle")
        radial = pull * np.sqrt(1 + (tan(self.get("pressure_angle")) / cos(helix)) ** 2)
        thrust = pull * abs(tan(helix))
        return radial, thrust, radial * abs(self.lever) + thrust * radius

    def turning(self, segment, q, w, a):
        """Bodies on the flange, each a mass on a circle."""
        load, tilt = self.load, self.load.get("axis_tilt")
        theta = q + load.phase
        bodies = [(load.mass, load.arm, self.lever)]
        reach = load.get("payload_distance", None)
        if reach is not None:
            bodies.append((load.extra(segment, "payload"), reach, self.get("payload_overhang") + self.offset))
        total, moment = np.zeros((3, *np.shape(q))), np.zeros((2, *np.shape(q)))
        for mass, r, lever in bodies:
            # Acceleration towards the axis and along the circle.
            acc_x = -(w**2) * r * np.cos(theta) - a * r * np.sin(theta)
            acc_y = -(w**2) * r * np.sin(theta) + a * r * np.cos(theta)
            force = mass * np.stack([-acc_x, -G * sin(tilt) - acc_y, -G * cos(tilt) + 0 * q])
            total += force
            x, y = r * np.cos(theta), r * np.sin(theta)
            moment += np.stack([y * force[2] - lever * force[1], lever * force[0] - x * force[2]])
        return np.hypot(total[0], total[1]), np.abs(total[2]), np.hypot(moment[0], moment[1])

    def at(self, segment, q, w, a, sign, recorded, handed_on):
        """`handed_on`: torque before and after the losses of a stage, where there is one."""
        load = self.load
        if self.stage is not None:
            if self.stage["kind"] == "coupling":
                found = [0.0 * q] * 3
            else:
                radius = si(self.stage["pitch_diameter"]) / 2
                found = self.wheel(np.maximum(*(np.abs(t) for t in handed_on)) / radius, radius)
        elif load.kind in ("arm", "turntable"):
            found = self.turning(segment, q, w, a)
        elif load.kind == "slider_crank":
            force, slope, gain = self.rod(segment, q, w, a)
            pin = self.lossy(force, np.sign(gain) * sign) * np.sqrt(1 + slope**2)
            found = pin, 0.0 * pin, pin * abs(self.lever)
        else:
            without, within = self.line(segment, w, a, sign, recorded)
            if load.kind == "screw":
                found = 0.0 * q, np.abs(without) + 0.0 * q, 0.0 * q
            else:
                found = self.wheel(np.maximum(self.lossy(without, sign), self.lossy(within, sign)), load.travel)
        if "wheel_mass" in self.keys:
            weight, tilt = self.get("wheel_mass") * G, self.get("axis_tilt")
            across = weight * abs(sin(tilt))
            more = across, weight * abs(cos(tilt)), across * abs(self.lever)
            found = [x + y for x, y in zip(found, more)]
        return [self.share * x for x in found]
