"""Current, losses, temperature, voltage and power of an actuator over the samples of a cycle."""

from math import pi, sqrt

import numpy as np

from sampling import WEIGHTS, stretches

COPPER = 3.93e-3  # per kelvin, from 20 degC
RPM = 2 * pi / 60


class Friction:
    """No-load friction at a temperature of the gear, as currents."""

    def __init__(self, actuator, temperature):
        at_30, at_80 = actuator["K_INL_30"] / RPM, actuator["K_INL_80"] / RPM
        growth = np.log(at_30 / at_80) / 50.0
        self.constant = at_80 * np.exp(growth * (80.0 - min(temperature, 80.0)))
        # Below 20 degC what is printed there grows like the other part.
        self.starting = actuator["I_NLS"] * np.exp(growth * max(20.0 - temperature, 0.0))
        # The k_Tout of the 48 V windings holds it already.
        self.counted = self.starting if actuator["stall_counts_I_NLS"] else 0.0


class Drive:
    """One actuator with its gear at one temperature."""

    def __init__(self, actuator, temperature):
        self.data, self.rubbing = actuator, Friction(actuator, temperature)

    def torque(self, speed, acc, load, sign):
        return self.data["J_out"] * acc + load

    def current(self, speed, acc, load, sign):
        friction = self.rubbing.counted + self.rubbing.constant * np.abs(speed)
        return self.torque(speed, acc, load, sign) / self.data["k_Tout"] + sign * friction

    def power(self, speed, acc, load, sign):
        """At the terminals, winding at 20 degC. Driven by the load the gear loses the same share of the torque as driving."""
        data, torque = self.data, self.torque(speed, acc, load, sign)
        efficiency = min(data["k_Tout"] / (data["i"] * data["k_TM"]), 1.0)
        passed = np.where(torque * sign < 0, max(2 - 1 / efficiency, 0.0), 1 / efficiency)
        forward = torque / data["k_Tout"] * efficiency * passed
        current = forward + sign * (self.rubbing.counted + self.rubbing.constant * np.abs(speed))
        return 1.5 * data["R_LL"] * current**2 + data["k_TM"] * current * data["i"] * speed

    def copper(self, current):
        return 1.5 * self.data["R_LL"] * (1 + COPPER * 60) * current**2

    def friction(self, speed, sign):
        lost = (self.rubbing.starting + self.rubbing.constant * np.abs(speed)) * self.data["k_TM"] * self.data["i"]
        return lost * np.abs(speed)

    def voltage(self, speed, current):
        """Line to line, fundamental, rms; vectors of the rotor's frame, peak values of a phase, winding at 90 degC."""
        data = self.data
        electric = data["p"] * data["i"] * speed
        flux = data["k_EM"] * 60 / (1000 * 2 * pi) * sqrt(2 / 3) / data["p"]
        i_q = sqrt(2) * current
        across = -electric * data["L_LL"] / 2 * i_q
        along = data["R_LL"] / 2 * (1 + COPPER * 70) * i_q + electric * flux
        return np.sqrt(1.5 * (across**2 + along**2))


def first_order(parts, values, tau):
    """Largest value of y' = (u - y)/tau in the steady cycle, at the ends of panels."""
    steps = []
    for part, value in zip(parts, values):
        h = part.width
        lag = np.exp(-h / tau)
        late = np.exp(-(h / 2) * (1 - np.polynomial.legendre.leggauss(5)[0]) / tau)
        fed = value[:, 1:-1] @ (WEIGHTS * late) * h / (2 * tau)
        steps += [(lag, x) for x in fed]
    gain, y = 1.0, 0.0
    for lag, x in steps:
        gain, y = gain * lag, y * lag + x
    y = y / (1 - gain)
    most = y
    for lag, x in steps:
        y = y * lag + x
        most = max(most, y)
    return most


class Network:
    """Winding and housing: C_w x' = P_w - (x - y)/R_wh, C_h y' = P_h + (x - y)/R_wh - y/R_ha, above ambient."""

    def __init__(self, actuator):
        stall = actuator["stall_loss_factor"] * 1.5 * actuator["R_LL"] * (1 + COPPER * 60) * actuator["I_0m"] ** 2
        whole = 40.0 / stall
        self.r_ha = actuator["w"] * whole
        self.r_wh = whole - self.r_ha
        self.c_w, self.c_h = actuator["tau_w"] / self.r_wh, actuator["tau_h"] / self.r_ha
        rows = [[-1 / (self.r_wh * self.c_w), 1 / (self.r_wh * self.c_w)]]
        rows += [[1 / (self.r_wh * self.c_h), -1 / (self.r_wh * self.c_h) - 1 / (self.r_ha * self.c_h)]]
        self.values, self.vectors = np.linalg.eig(np.array(rows))
        self.inverse = np.linalg.inv(self.vectors)

    def exp(self, time):
        return (self.vectors * np.exp(self.values * time)) @ self.inverse

    def cycle(self, parts, copper, friction):
        """Largest rise of winding and of housing in the steady cycle."""
        nodes = np.polynomial.legendre.leggauss(5)[0]
        steps, whole, state = [], np.eye(2), np.zeros(2)
        for part, p_w, p_h in zip(parts, copper, friction):
            h = part.width
            over = self.exp(h)
            fed = np.zeros((len(p_w), 2))
            for k, (x, weight) in enumerate(zip(nodes, WEIGHTS)):
                source = np.stack([p_w[:, k + 1] / self.c_w, p_h[:, k + 1] / self.c_h], axis=1)
                fed += weight * h / 2 * source @ self.exp(h * (1 - x) / 2).T
            steps.append((over, fed))
        for over, fed in steps:
            for row in fed:
                state = over @ state + row
            whole = np.linalg.matrix_power(over, len(fed)) @ whole
        state = np.linalg.solve(np.eye(2) - whole, state)
        most = state.copy()
        for over, fed in steps:
            for row in fed:
                state = over @ state + row
                most = np.maximum(most, state)
        return most


def coil(actuator, pieces, time):
    """Mean heat of the brake's coil: without current from the beginning of a dwell that the brake holds until it opens."""
    held = sum(piece.time for piece in pieces if piece.rest == "brake" or piece.closing)
    return actuator.get("U_Br", 0.0) * actuator.get("I_HBr", 0.0) * (1 - held / time)


def judge(actuator, pieces, load, time, ambient):
    """Peak current, overload, temperatures and voltage; the gear as warm as the housing, or as cold as the air, at most 30 degC."""
    network = Network(actuator)
    parts = stretches(pieces, load)
    beside = coil(actuator, pieces, time)

    def currents_of(drive):
        # Held by the brake or by nothing the motor has no current.
        off = [p.sign == 0 and p.piece.rest != "motor" for p in parts]
        currents = [drive.current(p.speed, p.acc, p.load, p.sign) for p in parts]
        return [0 * c if no else c for c, no in zip(currents, off)]

    def losses(drive):
        return [drive.copper(c) for c in currents_of(drive)], [drive.friction(p.speed, p.sign) for p in parts]

    def mean(values):
        return sum(p.integral(v) for p, v in zip(parts, values)) / time

    def housing_with(temperature):
        copper, friction = losses(Drive(actuator, temperature))
        return ambient + network.r_ha * (mean(copper) + mean(friction) + beside)

    # The housing found falls as the one assumed rises: one crossing.
    low, high = ambient, housing_with(ambient)
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if housing_with(middle) > middle else (low, middle)
    housing = (low + high) / 2
    warm, cold = Drive(actuator, housing), Drive(actuator, min(ambient, 30.0))
    copper, friction = losses(warm)
    winding, _ = network.cycle(parts, copper, friction)
    squares = [(c / actuator["I_0"]) ** 2 for c in currents_of(warm)]
    both = [(p, c) for drive in (warm, cold) for p, c in zip(parts, currents_of(drive))]
    found = {
        "housing": housing,
        "demagnetisation": max(float(np.max(np.abs(c))) for _, c in both),
        "overload_i2t": first_order(parts, squares, actuator["tau_w"]),
        "voltage": max(float(np.max(warm.voltage(p.speed, c))) for p, c in both),
    }
    if not actuator["curves_published"]:
        # Published curves scale the temperature, and choose the instant at which the current is told.
        found |= {"peak_current": found["demagnetisation"], "thermal": ambient + winding + beside * network.r_ha}
    return found, warm


def energy(drive, pieces, load, time):
    """Energy taken and given back at the terminals in one cycle, and the largest power given back."""
    motoring = regenerated = most = 0.0
    for part in stretches(pieces, load, [drive.torque, drive.power]):
        if part.sign == 0 and part.piece.rest != "motor":
            continue
        power = drive.power(part.speed, part.acc, part.load, part.sign)
        taken = part.integral(power)
        motoring, regenerated = motoring + max(taken, 0.0), regenerated + max(-taken, 0.0)
        most = max(most, float(np.max(-power)))
    return {"motoring": motoring, "regenerated": regenerated, "regenerated_peak": max(most, 0.0), "regeneration": regenerated / time}
