"""The recording of examples/robot-joint.csv: the shoulder of a planar arm with two links in the vertical plane.

    python3 validation/robot-joint/robot_joint.py > examples/robot-joint.csv

Both joints follow polynomials of the fifth degree between five poses, from rest to rest, with a rest after each. The
torque of the shoulder is that of Lagrange's equations (Spong, Robot Modeling and Control, planar elbow manipulator),
with a payload that is carried from the second pose to the fourth, and Coulomb and viscous friction of the arm's own
bearing. Standard library only.
"""

from math import cos, degrees, pi, radians, sin

G = 9.80665
L1, LC1, M1, I1 = 0.35, 0.16, 3.8, 0.045  # upper arm: length, centre, mass, inertia about the centre
L2, LC2, M2, I2 = 0.30, 0.14, 2.1, 0.018  # forearm with hand
PAYLOAD = 1.2
COULOMB, VISCOUS = 0.8, 0.15
POSES = [(35, 60), (75, -20), (120, -45), (60, 30), (20, 95), (35, 60)]
TIMES = [0.55, 0.60, 0.70, 0.50, 0.45]
REST = 0.12
STEP = 0.004


def quintic(u):
    return 10 * u**3 - 15 * u**4 + 6 * u**5, 30 * u**2 - 60 * u**3 + 30 * u**4, 60 * u - 180 * u**2 + 120 * u**3


def state(t):
    """Positions, speeds and accelerations of both joints, and the payload."""
    start = 0.0
    for index, time in enumerate(TIMES):
        carried = PAYLOAD if 1 <= index <= 2 else 0.0
        a, b = POSES[index], POSES[index + 1]
        if t <= start + time:
            s, v, c = quintic((t - start) / time)
            d = [radians(y - x) for x, y in zip(a, b)]
            return [radians(x) + s * w for x, w in zip(a, d)], [v * w / time for w in d], [c * w / time**2 for w in d], carried
        start += time
        if t <= start + REST:
            carried = PAYLOAD if 0 <= index <= 1 else 0.0
            return [radians(x) for x in b], [0.0, 0.0], [0.0, 0.0], carried
        start += REST
    return [radians(x) for x in POSES[-1]], [0.0, 0.0], [0.0, 0.0], 0.0


def torque(q, v, a, payload):
    """Torque that the shoulder's actuator gives to the arm."""
    m2 = M2 + payload
    lc2 = (M2 * LC2 + payload * L2) / m2
    i2 = I2 + M2 * (LC2 - lc2) ** 2 + payload * (L2 - lc2) ** 2
    h = L1 * lc2 * m2
    d11 = M1 * LC1**2 + m2 * (L1**2 + lc2**2 + 2 * L1 * lc2 * cos(q[1])) + I1 + i2
    d12 = m2 * (lc2**2 + L1 * lc2 * cos(q[1])) + i2
    coriolis = -h * sin(q[1]) * (2 * v[0] * v[1] + v[1] ** 2)
    gravity = (M1 * LC1 + m2 * L1) * G * cos(q[0]) + m2 * lc2 * G * cos(q[0] + q[1])
    sign = (v[0] > 0) - (v[0] < 0)
    return d11 * a[0] + d12 * a[1] + coriolis + gravity + COULOMB * sign + VISCOUS * v[0]


def main():
    whole = sum(TIMES) + REST * len(TIMES)
    print("# Shoulder of an arm with two links, planned motion with inverse dynamics; made by validation/robot-joint")
    print("time [s],position [deg],speed [1/min],torque [Nm]")
    for k in range(round(whole / STEP) + 1):
        t = k * STEP
        q, v, a, payload = state(t)
        print(f"{t:.3f},{degrees(q[0]):.5f},{v[0] * 30 / pi:.5f},{torque(q, v, a, payload):.4f}")


if __name__ == "__main__":
    main()
