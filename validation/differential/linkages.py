"""Torque of hoist, winder, scissor lift and four-bar linkage from the positions of their parts alone.

Energies follow from the positions by central differences of the fourth order, the torque from Lagrange's equation by
differences of the energies; the loop of the linkage is closed by Newton's iteration and differentiated by Fourier series. The winder's mass is not fixed: its
torque is the change of its angular momentum less that of the web that comes in.
"""

from math import cos, pi, sin

import numpy as np
from scipy.interpolate import CubicSpline

G = 9.80665


def slope(function, q, step):
    """f'(q), error of the order step⁴."""
    near, far = function(q + step) - function(q - step), function(q + 2 * step) - function(q - 2 * step)
    return (8 * near - far) / (12 * step)


class Linkage:
    """`load` gives the keys of the project in SI by `get`; `payload` and `force` are those of the segment."""

    def __init__(self, load):
        self.get, self.key = load.get, load.key

    def torque(self, q, w, a, payload, force):
        """J a + J'/2 w² + V'."""
        inertia = lambda x: self.get("inertia") + self.moving(x, payload)  # noqa: E731
        weight = slope(lambda x: self.potential(x, payload, force), q, self.coarse)
        return inertia(q) * a + slope(inertia, q, self.coarse) * w**2 / 2 + weight


class Hoist(Linkage):
    fine, coarse = 0.05, 0.05

    def lift(self, x):
        return self.get("drum_diameter") / 2 * x / self.key.get("falls", 1)

    def rope(self, x):
        """Kilograms per metre, and length of a fall."""
        falls, hanging = self.key.get("falls", 1), self.get("hanging")
        return (self.get("rope_mass") / (falls * hanging) if hanging else 0.0), hanging - self.lift(x)

    def moving(self, x, payload):
        falls, radius = self.key.get("falls", 1), self.get("drum_diameter") / 2
        rho, length = self.rope(x)
        found = (self.get("mass") + payload + self.get("counterweight")) * slope(self.lift, x, self.fine) ** 2
        for fall in range(falls):
            # A particle σ from the fixed end of the rope: where the fall begins at the top it hangs σ − k ℓ below it, else
            # that much above the hook.
            from_top = fall % 2 == falls % 2
            height = (lambda y, k=fall: k * self.rope(y)[1]) if from_top else (lambda y, k=fall: -(k + 1) * self.rope(y)[1])
            found = found + rho * length * slope(height, x, self.fine) ** 2
        # Rope wound since position zero.
        return found + rho * falls * self.lift(x) * radius**2

    def potential(self, x, payload, force):
        rho, length = self.rope(x)
        weight = G * (self.get("mass") + payload - self.get("counterweight")) + force
        return weight * self.lift(x) - G * self.key.get("falls", 1) * rho * length**2 / 2


class Winder(Linkage):
    coarse = 0.05
    nodes, weights = np.polynomial.legendre.leggauss(4)

    def torque(self, q, w, a, payload, force):
        sign = 1 if self.key["winding"] == "up" else -1
        thickness, layer = self.get("thickness"), self.get("density") * self.get("width")
        radius = lambda x: self.get("start_diameter") / 2 + sign * thickness * x / (2 * pi)  # noqa: E731

        def inertia(x):
            """Rings from the core to the surface."""
            core = self.get("core_diameter") / 2
            half = (radius(x) - core) / 2
            rings = sum(weight * (core + half * (1 + node)) ** 3 for node, weight in zip(self.nodes, self.weights))
            return self.get("inertia") + 2 * pi * layer * half * rings

        r = radius(q)
        # Kilograms that come in per second, at the speed of the surface.
        comes_in = sign * layer * thickness * r * w
        change = inertia(q) * a + slope(inertia, q, self.coarse) * w**2
        return change - comes_in * (w * r) * r + sign * self.get("tension") * r


class ScissorLift(Linkage):
    fine, coarse = 0.02, 0.05

    def ends(self, x):
        """Both ends of every arm."""
        length, stages = self.get("arm_length"), self.key["stages"]
        base = length * cos(self.get("arm_angle")) - self.get("lead") / (2 * pi) * x
        high = np.sqrt(length**2 - base**2)
        for i in range(stages):
            yield (base, i * high), (0 * base, (i + 1) * high)
            yield (0 * base, i * high), (base, (i + 1) * high)

    def top(self, x):
        return list(self.ends(x))[-1][1][1]

    def moving(self, x, payload):
        each = self.get("arm_mass") / (2 * self.key["stages"])
        found = (self.get("mass") + payload) * slope(self.top, x, self.fine) ** 2
        for arm in range(2 * self.key["stages"]):
            for axis in range(2):
                u, v = (slope(lambda y, e=end: list(self.ends(y))[arm][e][axis], x, self.fine) for end in range(2))
                # An even rod: m/6 (u² + u·v + v²), twice the energy.
                found = found + each / 3 * (u * u + u * v + v * v)
        return found

    def potential(self, x, payload, force):
        each = self.get("arm_mass") / (2 * self.key["stages"])
        arms = sum(each * (low[1] + high[1]) / 2 for low, high in self.ends(x))
        return (G * (self.get("mass") + payload) + force) * self.top(x) + G * arms


class FourBar(Linkage):
    """Positions on an even grid of one revolution, differentiated by their Fourier series."""

    GRID = 4096

    def __init__(self, load):
        super().__init__(load)
        x = 2 * pi * np.arange(self.GRID) / self.GRID
        g, r, c, l = (self.get(key) for key in ("ground", "crank", "coupler", "rocker"))
        # Newton's iteration from a guess on the branch that the linkage is assembled in.
        crossed = self.key.get("crossed", False)
        beta, psi = np.full_like(x, -0.7 if crossed else 0.5), np.full_like(x, -1.7 if crossed else 1.5)
        for _ in range(200):
            e = r * np.cos(x) + c * np.cos(beta) - g - l * np.cos(psi)
            f = r * np.sin(x) + c * np.sin(beta) - l * np.sin(psi)
            across = c * l * np.sin(beta - psi)
            step = np.stack([l * (np.cos(psi) * e + np.sin(psi) * f), c * (np.cos(beta) * e + np.sin(beta) * f)]) / across
            step = np.clip(step, -0.1, 0.1)
            beta, psi = beta + step[0], psi + step[1]
        if max(np.abs(e).max(), np.abs(f).max()) > 1e-13:
            raise SystemExit("the loop of the linkage does not close")
        s, reach = self.get("coupler_centre"), self.get("rocker_centre")
        centre = [r * np.cos(x) + s * np.cos(beta), r * np.sin(x) + s * np.sin(beta)]
        inertia = self.get("inertia") + self.get("coupler_mass") * sum(self.rate(p) ** 2 for p in centre)
        inertia += self.get("coupler_inertia") * self.rate(beta) ** 2 + self.get("rocker_inertia") * self.rate(psi) ** 2
        gamma = self.get("inclination")
        height = lambda u, v: u * sin(gamma) + v * cos(gamma)  # noqa: E731
        rocker = height(g + reach * np.cos(psi), reach * np.sin(psi))
        weights = self.get("coupler_mass") * height(*centre) + self.get("rocker_mass") * rocker
        potential = G * sin(self.get("axis_tilt")) * weights + self.get("rocker_torque") * psi
        ends = np.append(x, 2 * pi)
        tables = inertia, self.rate(inertia), self.rate(potential)
        self.tables = [CubicSpline(ends, np.append(t, t[0]), bc_type="periodic") for t in tables]

    def rate(self, values):
        waves = 1j * np.fft.rfftfreq(self.GRID, 1 / self.GRID)
        waves[-1] = 0
        return np.fft.irfft(waves * np.fft.rfft(values), self.GRID)

    def torque(self, q, w, a, payload, force):
        inertia, bend, weight = (table(q) for table in self.tables)
        return inertia * a + bend * w**2 / 2 + weight


LINKAGES = {"hoist": Hoist, "winder": Winder, "scissor_lift": ScissorLift, "four_bar": FourBar}
