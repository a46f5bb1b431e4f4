//! Runs by the equations of the test itself, in which the speed of the motor is measured with noise, or nothing is.

use super::*;

/// A flywheel with friction on an actuator, by its equations: the torque through the gear, and the current of the motor.
///
/// T = J α + T_c sgn ω + b ω, I = (T + J_M α)/k + I_NLS sgn ω + K ω
struct Planted {
    code: &'static str,
    torque_constant: f64,
    starting: f64,
    per_speed: f64,
}

const INERTIA: f64 = 2.4;
const COULOMB: f64 = 6.0;
const VISCOUS: f64 = 3.0;

impl Planted {
    /// Returns a run of twelve seconds of three superposed swings, a row each millisecond, and the inertia of the rotor.
    fn run(&self, noise_of: [f64; 4], seed: u64) -> Observed {
        let [position, motor, torque, current] = noise_of;
        let mut state = seed.wrapping_mul(0xd134_2543_de82_ef95) ^ 0xf1e1d;
        let tabulated = parameters(self.code).actuator;
        let rotor = tabulated.inertia_out.known().unwrap().value.si();
        let rotor = rotor * ROTOR_SHARE;
        let mut run = Observed::default();
        for k in 0..12_000_u32 {
            let time = f64::from(k) * 1e-3;
            let swings = [(0.5, 0.4, 0.0), (0.2, 1.1, 1.0), (0.06, 1.9, 2.0)];
            let [mut q, mut w, mut a] = [0.0; 3];
            for (size, hertz, phase) in swings {
                let pace = std::f64::consts::TAU * hertz;
                let (sine, cosine) = (pace * time + phase).sin_cos();
                q += size * sine;
                w += size * pace * cosine;
                a -= size * pace * pace * sine;
            }
            let load = INERTIA * a + COULOMB * w.signum() + VISCOUS * w;
            let rms = (load + rotor * a) / self.torque_constant + self.starting * w.signum() + self.per_speed * w;
            let mut with = |value: f64, size: f64| value + size * noise(&mut state);
            run.time_s.push(time);
            run.position_rad.push(with(q, position));
            run.motor_rad_s.push(with(w, motor));
            run.torque_nm.push(with(load, torque));
            run.current_q_a.push(with(std::f64::consts::SQRT_2 * rms, current));
        }
        run
    }
}

/// Share of the rotor in the inertia of the tables, which has a flange too.
const ROTOR_SHARE: f64 = 0.98;

/// Planted values lie in their intervals whatever the noise of the motor speed; without any noise too, where torque and
/// acceleration of a flywheel say the same and only the tables separate them.
#[test]
fn noise_of_the_motor_speed_leaves_planted_values_in_their_intervals() {
    let of = [("CHA-40A-50-H-C1024", 0.98), ("CHA-25A-100-H-C1024", 0.97)].map(|(code, share)| {
        let tables = parameters(code).actuator;
        Planted {
            code,
            torque_constant: share * tables.torque_constant_out.known().unwrap().value.si(),
            starting: tables.no_load_starting_current.known().unwrap().value.si(),
            per_speed: 0.12,
        }
    });
    let friction = Friction {
        coulomb: Torque::from_si(COULOMB),
        viscous: ViscousFriction::from_si(VISCOUS),
        external: Torque::from_si(0.0),
    };
    let wheel = Mechanism { friction, ..super::super::load(INERTIA, 0.0) };
    let motion = moves(&EXCITING);
    for planted in &of {
        let parameters = parameters(planted.code);
        let (mut outside, mut all) = (Vec::new(), 0);
        for motor in [0.0, 3e-3, 6e-3, 0.01, 0.05] {
            for seed in 0..4 {
                let noises = if motor == 0.0 && seed == 0 { [0.0; 4] } else { [1e-5, motor, 0.3, 0.02] };
                let run = planted.run(noises, seed);
                let stated = Stated { parameters: &parameters, mechanism: &wheel, motion: &motion, extras: &none() };
                let run = identify(&run, &stated).unwrap();
                assert_eq!(run.doubts, [], "{} {motor}", planted.code);
                let values = [
                    (Identified::TorqueConstant, planted.torque_constant),
                    (Identified::StartingCurrent, planted.starting),
                    (Identified::CurrentConstant, planted.per_speed),
                    (Identified::LoadInertia, INERTIA),
                    (Identified::Coulomb, COULOMB),
                    (Identified::Viscous, VISCOUS),
                ];
                for (of, value) in values {
                    let Some(estimate) = found(&run.estimates, of) else { continue };
                    all += 1;
                    if (estimate.value - value).abs() > estimate.half_width {
                        outside.push((motor, seed, of, value, estimate));
                    }
                }
            }
        }
        assert!(all >= 80 && outside.len() * 20 <= all, "{}: {} of {all}: {outside:?}", planted.code, outside.len());
    }
}
