"""Speed step of the linear drive, integrated by LSODA; the controller samples, the plant between two samples is continuous.

CHA-20A-100-H with a load of 1.3 kg m^2, no friction, hysteresis, kinematic error, delay or limit. Constants from tables 26.1 and 54.3 of the
manual; gains by the rule of docs/theory/twin.md. Uses no code of the engine. Writes speed_step.csv.
"""
import sys
from math import pi, sqrt

import numpy
import scipy
from scipy.integrate import solve_ivp

# tables 26.1 and 54.3
ratio, pairs = 100.0, 5.0
r_ll, l_ll = 5.9, 8.0e-3
k_tm, k_em = 0.36, 23 / (1000 * 2 * pi / 60)
j_out = 1.12
t1, t2, k1, k2, k3 = 7.0, 25.0, 16e3, 25e3, 29e3
load = 1.3
# assumptions of the model: share of the flange, damping of the gear
share, zeta = 0.02, 0.03

r, l = r_ll / 2, l_ll / 2
psi = k_em * sqrt(2 / 3) / pairs
electrical = pairs * ratio
kt = k_tm * ratio / sqrt(2)
jm, jl = j_out * (1 - share), load + share * j_out
damping = 2 * zeta * sqrt(k2 * j_out)
p1 = t1 / k1
p2 = p1 + (t2 - t1) / k2

# gains
tc, ts = 1 / 16000, 4 / 16000
sigma = 0.5 * tc
cp, cn = l / (2 * sigma), l / r
total = 2 * sigma + ts
sp, sn = jm / (2 * total), 4 * total * (jm + jl) / jm


def spring(phi):
    a = abs(phi)
    t = k1 * a if a <= p1 else t1 + k2 * (a - p1) if a <= p2 else t2 + k3 * (a - p2)
    return t if phi >= 0 else -t


def slopes(_, x, ud, uq):
    i_d, i_q, theta, omega, q, w = x
    we = electrical * omega
    gear = spring(theta - q) + damping * (omega - w)
    return [
        (ud - r * i_d + we * l * i_q) / l,
        (uq - r * i_q - we * (l * i_d + psi)) / l,
        omega,
        (kt * i_q - gear) / jm,
        w,
        gear / jl,
    ]


STEP, PERIODS = 0.05, 800


def run(rtol, atol, row):
    """Integrates from sample to sample; `row` takes time, i_q, i_d and both speeds every eighth of them."""
    x = numpy.zeros(6)
    int_d = int_q = int_n = last = speed = wanted = 0.0
    for k in range(PERIODS):
        if k % 8 == 0:
            row(k * tc, x[1], x[0], x[3], x[5])
        if k % 4 == 0:
            speed, last = (x[2] - last) / ts, x[2]
            error = STEP - speed
            int_n += sp * error * ts / sn
            wanted = (sp * error + int_n) / kt
        we = electrical * speed
        ed, eq = -x[0], wanted - x[1]
        int_d += cp * tc / cn * ed
        int_q += cp * tc / cn * eq
        ud = cp * ed + int_d - we * l * x[1]
        uq = cp * eq + int_q + we * (l * x[0] + psi)
        done = solve_ivp(slopes, (0, tc), x, method="LSODA", rtol=rtol, atol=atol, args=(ud, uq))
        assert done.success
        x = done.y[:, -1]


if __name__ == "__main__":
    versions = f"scipy {scipy.__version__}, numpy {numpy.__version__}, Python {sys.version.split()[0]}"
    print(f"# {versions}; LSODA, rtol 1e-10, atol 1e-13")
    print("time_s,current_q_a,current_d_a,motor_rad_s,speed_rad_s")
    run(1e-10, 1e-13, lambda t, *row: print(f"{t:.7f}," + ",".join(f"{value:.12e}" for value in row)))
