"""Torque of hoist, winder, scissor lift and four-bar at single states, by another way than the engine's.

The engine has closed forms of J(q), J'(q) and the weight. Here positions of the parts alone are written down; energies
come from them by numerical differentiation in 50 digits, the torque from Lagrange's equation by numerical
differentiation of the energies, the four-bar's loop from Newton's iteration. The winder's mass is not fixed: its torque
comes from the change of the angular momentum of roll and web between two instants.

    python3 validation/mechanisms/mechanisms.py

prints the values that stand in `crates/mechanism/src/new_tests.rs`.
"""

import mpmath as mp

mp.mp.dps = 50
G = mp.mpf("9.80665")
STATES = [(mp.mpf(q), mp.mpf(w), mp.mpf(a)) for q, w, a in [("0.4", "3", "-7"), ("2.1", "-5", "11"), ("4.9", "2.5", "4")]]


def lagrange(kinetic, potential, q, w, a):
    """d/dt ∂T/∂ω − ∂T/∂q + ∂V/∂q along q(t) = q + w t + a t²/2."""
    momentum = lambda t: mp.diff(lambda rate: kinetic(q + w * t + a * t * t / 2, rate), w + a * t)
    return mp.diff(momentum, 0) - mp.diff(lambda x: kinetic(x, w), q) + mp.diff(potential, q)


def speed(position, q, w):
    """Velocity of a point that is a function of q."""
    return [mp.diff(lambda x, k=k: position(x)[k], q) * w for k in range(2)]


def hoist(falls, q, w, a):
    radius, hanging, drum, load, counter, rope = mp.mpf("0.15"), mp.mpf(6), mp.mpf("0.8"), 400, 150, mp.mpf("5.4")
    rho = rope / (falls * hanging)
    lift = lambda x: radius * x / falls
    wound = radius * 10  # rope already on the drum: any amount, its share is taken off the drum's inertia
    total = falls * hanging + wound

    def height(sigma, x):
        """Height of a particle of the rope, from its fixed end; on the drum the length wound."""
        length = hanging - lift(x)
        if sigma > falls * length:
            return None
        fall = int(mp.floor(sigma / length))
        rest = sigma - fall * length
        from_top = (fall % 2 == 0) if falls % 2 == 0 else (fall % 2 == 1)
        return -rest if from_top else -length + rest

    def pieces(x):
        length = hanging - lift(x)
        return [(k * length, (k + 1) * length) for k in range(falls)]

    def kinetic(x, rate):
        sum_ = (drum - rho * wound * radius**2) * rate**2 / 2 + (load + counter) * (mp.diff(lift, x) * rate) ** 2 / 2
        for low, high in pieces(x):
            middle = (low + high) / 2  # one speed along each fall
            step = mp.mpf(10) ** -20
            slope = (height(middle, x + step) - height(middle, x - step)) / (2 * step)
            sum_ += rho * (high - low) * (slope * rate) ** 2 / 2
        on_drum = total - falls * (hanging - lift(x))
        return sum_ + rho * on_drum * (radius * rate) ** 2 / 2

    def potential(x):
        length = hanging - lift(x)
        return G * ((load - counter) * lift(x) + falls * rho * length * (-length / 2))

    return lagrange(kinetic, potential, q, w, a)


def winder(sign, q, w, a):
    core, start, s, b, rho, tension, inertia = (
        mp.mpf(v) for v in ("0.05", "0.16", "0.004", "0.6", "900", "120", "0.02")
    )
    radius = lambda x: start + sign * s * x / (2 * mp.pi)
    # Rings of the roll, each with its own moment.
    roll = lambda x: inertia + mp.quad(lambda r: 2 * mp.pi * rho * b * r**3, [core, radius(x)])
    state = lambda t: (q + w * t + a * t * t / 2, w + a * t)
    momentum = lambda t: roll(state(t)[0]) * state(t)[1]
    # Mass that comes in per second at the speed of the surface; s is that of a turn of radius r.
    r = radius(q)
    inflow = sign * rho * b * s * (w * r) * (w * r) * r
    # Thickness s adds π((r + s/2)² − …)/turn = 2π r s of area per turn, which is r s per radian.
    return mp.diff(momentum, 0) - inflow + sign * tension * r


def scissor(stages, q, w, a):
    length, lead, theta, load, arms, screw = mp.mpf("1.2"), mp.mpf("0.9"), mp.radians(25), 180, 90, mp.mpf("0.003")
    k = lead / (2 * mp.pi)
    base = lambda x: length * mp.cos(theta) - k * x
    stage = lambda x: mp.sqrt(length**2 - base(x) ** 2)
    each = mp.mpf(arms) / (2 * stages)

    def ends():
        for i in range(stages):
            yield (lambda x, i=i: (base(x), i * stage(x))), (lambda x, i=i: (mp.mpf(0), (i + 1) * stage(x)))
            yield (lambda x, i=i: (mp.mpf(0), i * stage(x))), (lambda x, i=i: (base(x), (i + 1) * stage(x)))

    def kinetic(x, rate):
        sum_ = screw * rate**2 / 2 + load * (mp.diff(lambda y: stages * stage(y), x) * rate) ** 2 / 2
        for low, high in ends():
            u, v = speed(low, x, rate), speed(high, x, rate)
            # Even rod: m/6 (u² + u·v + v²)
            sum_ += each / 6 * sum(p * p + p * r + r * r for p, r in zip(u, v))
        return sum_

    def potential(x):
        return G * (load * stages * stage(x) + sum(each * (low(x)[1] + high(x)[1]) / 2 for low, high in ends()))

    return lagrange(kinetic, potential, q, w, a)


def four_bar(crossed, q, w, a):
    g, r, c, l = (mp.mpf(v) for v in ("0.4", "0.1", "0.35", "0.25"))
    crank, mc, s, jc, mr, sr, jr, torque = (mp.mpf(v) for v in ("0.02", "2.5", "0.15", "0.03", "3", "0.12", "0.08", "6"))
    gamma, tilt = mp.radians(20), mp.radians(70)

    def solved(x):
        """Angles of coupler and rocker by Newton's iteration along the branch."""
        close = lambda beta, psi: (
            r * mp.cos(x) + c * mp.cos(beta) - g - l * mp.cos(psi),
            r * mp.sin(x) + c * mp.sin(beta) - l * mp.sin(psi),
        )
        return mp.findroot(close, (mp.mpf("-0.7"), mp.mpf("-1.7")) if crossed else (mp.mpf("0.5"), mp.mpf("1.5")))

    centre = lambda x: (r * mp.cos(x) + s * mp.cos(solved(x)[0]), r * mp.sin(x) + s * mp.sin(solved(x)[0]))
    # Central differences of the solved positions; 50 digits leave 30 of a second derivative.
    step = mp.mpf(10) ** -12

    def rate_of(f, x):
        return (f(x - 2 * step) - 8 * f(x - step) + 8 * f(x + step) - f(x + 2 * step)) / (12 * step)

    def inertia(x):
        vx, vy = rate_of(lambda y: centre(y)[0], x), rate_of(lambda y: centre(y)[1], x)
        beta, psi = rate_of(lambda y: solved(y)[0], x), rate_of(lambda y: solved(y)[1], x)
        return crank + mc * (vx**2 + vy**2) + jc * beta**2 + jr * psi**2

    def potential(x):
        beta, psi = solved(x)
        up = lambda px, py: px * mp.sin(gamma) + py * mp.cos(gamma)
        rocker = up(g + sr * mp.cos(psi), sr * mp.sin(psi))
        return G * mp.sin(tilt) * (mc * up(*centre(x)) + mr * rocker) + torque * psi

    return inertia(q) * a + rate_of(inertia, q) * w**2 / 2 + rate_of(potential, q)


if __name__ == "__main__":
    print(f"mpmath {mp.__version__}")
    for name, of, variants in [
        ("hoist", hoist, (1, 2, 3, 4)),
        ("winder", winder, (1, -1)),
        ("scissor", scissor, (1, 3)),
        ("four_bar", four_bar, (False, True)),
    ]:
        for variant in variants:
            print(name, variant, [mp.nstr(of(variant, *state), 15) for state in STATES])
