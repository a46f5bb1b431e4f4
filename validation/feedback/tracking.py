"""Step and ramp response of the tracking loop of the AD2S1205, by scipy.signal: written to tracking.csv, which
crates/feedback/tests/it/other_hands.rs reads.

    pip install scipy==1.17.1 numpy==2.4.6
    python tracking.py > tracking.csv

G(z) = k1 k2 I(z)^2 C(z) of the data sheet, rev. A, "Circuit Dynamics"; closed H = G/(1 + G), linear.
"""

import numpy as np
import scipy
from scipy import signal

ONE = np.longdouble(1)
K = 18 * ONE / 25 * 18e6 * 2 * np.pi
A, B, C = 4095 * ONE / 4096, 4085 * ONE / 4096, ONE / 4_096_000
numerator = K * C**2 * np.array([1, -A, 0, 0], dtype=np.longdouble)
denominator = np.array([1, -2 - B, 1 + 2 * B, -B], dtype=np.longdouble)
closed = denominator + numerator
# Three poles lie near one: in double precision the coefficients alone cost five digits, hence longdouble (80 bit).
# The powers are those of 1/z; both polynomials have the same length, so lfilter takes them as they are.
COUNT = 40_000
step = np.full(COUNT, 1e-4, dtype=np.longdouble)
ramp = 5 * np.arange(1, COUNT + 1, dtype=np.longdouble) * C  # rad, 5 rad/s
# The same by the equivalent continuous loop: Ka (1 + t1 s)/(s^2 (1 + t2 s)).
ka = K * (1 - A) / (1 - B)
t1, t2 = ((1 + x) / (2 / C * (1 - x)) for x in (A, B))
omega = 2 * np.pi * np.logspace(2, 4, 20_001)
w, h = signal.freqs(np.float64(ka) * np.array([t1, 1], dtype=float), np.array([t2, 1, ka * t1, ka], dtype=float), omega)
bandwidth = w[np.argmax(np.abs(h) < np.sqrt(0.5))] / 2 / np.pi
wz, hz = signal.freqz(numerator.astype(float), closed.astype(float), worN=omega, fs=float(2 * np.pi / C))
bandwidth_z = wz[np.argmax(np.abs(hz) < np.sqrt(0.5))] / 2 / np.pi
print(f"# scipy {scipy.__version__}, numpy {np.__version__}; step of 1e-4 rad, ramp of 5 rad/s")
print(f"# Ka {ka:.6e} 1/s2, t1 {t1:.6e} s, t2 {t2:.6e} s, bandwidth {bandwidth:.1f} Hz, of H(z) {bandwidth_z:.1f} Hz")
print("n,step_rad,ramp_rad")
steps, ramps = (signal.lfilter(numerator, closed, x) for x in (step, ramp))
for n in [*range(0, 20), *range(20, 400, 20), *range(400, COUNT, 400)]:
    print(f"{n + 1},{steps[n]:.17e},{ramps[n]:.17e}")
