"""Baseline of the bench `twin`: 0.05 s of the drive of validation/twin by motulator 0.5.0, timed without imports.

The same plant: motor, two masses, linear spring and damping, an inverter averaged over a period of 62.5 us, a step of the speed to
0.05 rad/s at the output. The control is motulator's own current vector control with a position sensor, at 16 kHz. Its solver is
RK45 of SciPy with the tolerances that motulator uses (rtol 1e-3).

One JSON object on stdout. Exit code 3: motulator 0.5.0 is missing.
"""

import json
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "validation" / "twin"))
VERSION = "0.5.0"
try:
    from importlib.metadata import version

    import speed_step as drive
    import motulator.drive.control.sm as control
    from motulator.drive import model
    from motulator.drive.utils import SynchronousMachinePars, TwoMassMechanicalSystemPars

    if version("motulator") != VERSION:
        raise ImportError(version("motulator"))
except ImportError as missing:
    print(f"twin_motulator: {missing}; install motulator=={VERSION} for this Python", file=sys.stderr)
    sys.exit(3)

DURATION = drive.PERIODS * drive.tc
# At the shaft of the motor.
share = 1 / drive.ratio**2


def run():
    """Simulates the step once; returns the last speed of the motor over the ratio."""
    machine = SynchronousMachinePars(n_p=int(drive.pairs), R_s=drive.r, L_d=drive.l, L_q=drive.l, psi_f=drive.psi)
    axis = TwoMassMechanicalSystemPars(
        J_M=drive.jm * share, J_L=drive.jl * share, K_S=drive.k1 * share, C_S=drive.damping * share
    )
    plant = model.Drive(
        converter=model.VoltageSourceConverter(u_dc=560),
        machine=model.SynchronousMachine(machine),
        mechanics=model.TwoMassMechanicalSystem(axis),
    )
    reference = control.CurrentReferenceCfg(machine, max_i_s=20, nom_w_m=2000)
    loops = control.CurrentVectorControl(
        machine, reference, T_s=drive.tc, J=(drive.jm + drive.jl) * share, sensorless=False
    )
    loops.ref.w_m = lambda t: drive.pairs * drive.ratio * drive.STEP
    simulation = model.Simulation(plant, loops)
    simulation.simulate(t_stop=DURATION)
    return plant.mechanics.data.w_M[-1] / drive.ratio


if __name__ == "__main__":
    times = []
    for _ in range(3):
        start = time.process_time()
        last = run()
        times.append(time.process_time() - start)
    print(json.dumps({"speed": last, "version": VERSION, "seconds": sorted(times)[1]}))
