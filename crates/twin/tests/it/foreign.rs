//! Runs of another simulator: its equations, its control and its integrator are of this file, and nothing of the twin runs here.
//!
//! Two masses on a linear spring, friction as a steep function of the speed, a cascade without sampling, Runge and Kutta's method.

use numeric::Random;
use std::f64::consts::{PI, SQRT_2, TAU};
use twin::Observed;

/// A drive and its load, as plain numbers in SI.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plant {
    /// J_L, T_c, b, T_e, W and φ_0 of the load.
    pub(crate) load_kgm2: f64,
    pub(crate) coulomb_nm: f64,
    pub(crate) viscous_nms: f64,
    pub(crate) external_nm: f64,
    pub(crate) weight_nm: f64,
    pub(crate) angle_rad: f64,
    /// J in front of a transmission with losses, and its factors of torques behind it, driving and driven.
    pub(crate) flange_kgm2: f64,
    pub(crate) losses: [f64; 2],
    /// J_M, torque at the output per ampere rms before and behind the teeth, friction as currents.
    pub(crate) rotor_kgm2: f64,
    pub(crate) motor_nm_a: f64,
    pub(crate) output_nm_a: f64,
    pub(crate) starting_a: f64,
    pub(crate) with_speed_as: f64,
}

/// Properties of the instrument that records the signals.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instrument {
    /// Standard deviations of the noise of torque and current.
    pub(crate) torque_nm: f64,
    pub(crate) current_a: f64,
    /// Steps of the angles of load and motor, the latter over i; speeds are then their differences.
    pub(crate) steps_rad: Option<[f64; 2]>,
    /// Readings of torque and current at zero \[Nm, A\].
    pub(crate) zeros: [f64; 2],
    /// Delays of torque and current, in s.
    pub(crate) late_s: [f64; 2],
}

impl Instrument {
    /// An instrument without steps, zeros and delays.
    pub(crate) const NOISE: Self =
        Self { torque_nm: 0.3, current_a: 0.05, steps_rad: None, zeros: [0.0; 2], late_s: [0.0; 2] };
}

/// A run without noise, with the angle of the motor over i.
pub(crate) struct Course {
    run: Observed,
    motor_rad: Vec<f64>,
    row_s: f64,
}

impl Instrument {
    /// Returns the run as the instrument shows it.
    pub(crate) fn seen(&self, course: &Course, random: &mut Random) -> Observed {
        let mut run = course.run.clone();
        let [of_torque, of_current] = self.zeros;
        run.torque_nm.iter_mut().for_each(|torque| *torque += of_torque + self.torque_nm * random.normal());
        run.current_q_a.iter_mut().for_each(|current| *current += of_current + self.current_a * random.normal());
        if let Some([of_load, of_motor]) = self.steps_rad {
            let stepped =
                |angles: &[f64], step: f64| angles.iter().map(|angle| (angle / step).round() * step).collect();
            // Speeds of a logger that has angles alone: the difference to the row before.
            let speeds = |angles: &[f64]| {
                let pairs = angles.windows(2).map(|pair| (pair[1] - pair[0]) / course.row_s);
                std::iter::once(0.0).chain(pairs).collect::<Vec<f64>>()
            };
            let motor: Vec<f64> = stepped(&course.motor_rad, of_motor);
            run.position_rad = stepped(&course.run.position_rad, of_load);
            run.speed_rad_s = Some(speeds(&run.position_rad));
            run.motor_rad_s = speeds(&motor);
        }
        let late = |column: &mut Vec<f64>, late_s: f64| {
            let rows = (late_s / course.row_s).round() as usize;
            column.splice(..0, vec![column[0]; rows]);
            column.truncate(run.time_s.len());
        };
        late(&mut run.torque_nm, self.late_s[0]);
        late(&mut run.current_q_a, self.late_s[1]);
        run
    }
}

const STIFFNESS: f64 = 2.0e4;
const DAMPING: f64 = 8.0;
/// Rows each millisecond: step of the integrator, and steps between rows.
pub(crate) const EACH_MS: (f64, usize) = (2.5e-4, 4);
/// Eight rows in a millisecond.
pub(crate) const EIGHT_PER_MS: (f64, usize) = (1.25e-4, 1);
/// Speed at which friction has nearly its full value [rad/s].
const STEEP: f64 = 0.004;
const CURRENT_LAG_S: f64 = 5e-4;

/// Current, motor angle and speed, load angle and speed, integral of the speed loop.
type State = [f64; 6];

/// A stroke: begin, distance and duration.
type Stroke = [f64; 3];

/// Position, speed and acceleration that are wanted: inclined sines with pauses.
fn wanted(strokes: &[Stroke], time: f64) -> [f64; 3] {
    let mut from = 0.0;
    for [begin, way, duration] in strokes {
        let u = (time - begin) / duration;
        if u < 0.0 {
            break;
        }
        if u < 1.0 {
            let (sine, cosine) = (TAU * u).sin_cos();
            return [
                from + way * (u - sine / TAU),
                way / duration * (1.0 - cosine),
                way * TAU / (duration * duration) * sine,
            ];
        }
        from += way;
    }
    [from, 0.0, 0.0]
}

impl Plant {
    fn gear_nm(&self, x: &State) -> f64 {
        STIFFNESS * (x[1] - x[3]) + DAMPING * (x[2] - x[4])
    }

    fn derivatives(&self, x: &State, time: f64, strokes: &[Stroke]) -> State {
        let [current, theta, omega_m, q, omega, integral] = *x;
        let gear = self.gear_nm(x);
        let per_peak = self.motor_nm_a / SQRT_2;
        let [position, speed, acceleration] = wanted(strokes, time);
        let total = self.load_kgm2 + self.rotor_kgm2;
        let error = speed + 25.0 * (position - theta) - omega_m;
        let torque = 60.0 * total * error + integral + total * acceleration;
        let teeth = (self.motor_nm_a / self.output_nm_a - 1.0) * gear.abs();
        let own = self.motor_nm_a * self.starting_a + teeth;
        let friction = own * (omega_m / STEEP).tanh() + self.motor_nm_a * self.with_speed_as * omega_m;
        let direction = (omega / STEEP).tanh();
        let load = self.coulomb_nm * direction + self.weight_nm * (q + self.angle_rad).cos() + self.external_nm;
        // gear = b ω + J_f α + φ (J α + load), φ of the side of what is behind the transmission.
        let accelerated = |factor: f64| {
            let factor = 1.0 + (factor - 1.0) * direction.abs();
            (gear - self.viscous_nms * omega - factor * load) / (self.flange_kgm2 + factor * self.load_kgm2)
        };
        let [driving, driven] = self.losses.map(accelerated);
        let drives = (self.load_kgm2 * driving + load) * direction >= 0.0;
        let acceleration = if drives { driving } else { driven };
        [
            (torque / per_peak - current) / CURRENT_LAG_S,
            omega_m,
            (per_peak * current - gear - friction) / self.rotor_kgm2,
            omega,
            acceleration,
            60.0 * total * error / 0.03,
        ]
    }

    /// Returns a run along random strokes without noise, with the step of the integrator and the steps between rows.
    pub(crate) fn run(&self, random: &mut Random, (step_s, per_row): (f64, usize)) -> Course {
        let mut strokes: Vec<Stroke> = Vec::new();
        let mut begin = 0.2;
        for _ in 0..6 {
            let (way, there, back) =
                (0.8 + 1.4 * random.uniform(), 0.6 + 0.6 * random.uniform(), 0.6 + 0.6 * random.uniform());
            strokes.push([begin, way, there]);
            strokes.push([begin + there + 0.1, -way, back]);
            begin += there + back + 0.2;
        }
        let holding = self.external_nm + self.weight_nm * self.angle_rad.cos();
        let current = holding / (self.motor_nm_a / SQRT_2);
        let mut x = [current, holding / STIFFNESS, 0.0, 0.0, 0.0, holding];
        let (mut run, mut speeds, mut motor_rad) = (Observed::default(), Vec::new(), Vec::new());
        let mut time = 0.0;
        let mut step = 0_usize;
        while time < begin {
            if step.is_multiple_of(per_row) {
                run.time_s.push(time);
                run.position_rad.push(x[3]);
                speeds.push(x[4]);
                motor_rad.push(x[1]);
                run.motor_rad_s.push(x[2]);
                run.torque_nm.push(self.gear_nm(&x));
                run.current_q_a.push(x[0]);
            }
            x = self.stepped(&x, time, &strokes, step_s);
            step += 1;
            time = step_s * step as f64;
        }
        run.speed_rad_s = Some(speeds);
        Course { run, motor_rad, row_s: step_s * per_row as f64 }
    }

    /// Returns one step of Runge and Kutta's method of fourth order.
    fn stepped(&self, x: &State, time: f64, strokes: &[Stroke], h: f64) -> State {
        let moved = |slope: &State, by: f64| std::array::from_fn(|k| x[k] + by * slope[k]);
        let a = self.derivatives(x, time, strokes);
        let b = self.derivatives(&moved(&a, 0.5 * h), time + 0.5 * h, strokes);
        let c = self.derivatives(&moved(&b, 0.5 * h), time + 0.5 * h, strokes);
        let d = self.derivatives(&moved(&c, h), time + h, strokes);
        std::array::from_fn(|k| x[k] + h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]))
    }

    /// Draws a load of a kind on a drive whose constants lie about those of the tables.
    pub(crate) fn drawn(kind: &str, tables: &Self, random: &mut Random) -> Self {
        let mut between = |low: f64, high: f64| low + (high - low) * random.uniform();
        let about = 1.0 + 0.05 * between(-1.0, 1.0);
        let drive = Self {
            rotor_kgm2: tables.rotor_kgm2 * (1.0 + 0.025 * between(-1.0, 1.0)),
            motor_nm_a: tables.motor_nm_a * about,
            output_nm_a: tables.output_nm_a * about,
            starting_a: tables.starting_a * between(0.7, 1.3),
            with_speed_as: tables.with_speed_as * between(0.7, 1.3),
            load_kgm2: between(0.5, 1.4),
            coulomb_nm: between(1.0, 4.0),
            viscous_nms: between(0.5, 2.0),
            external_nm: 0.0,
            weight_nm: 0.0,
            angle_rad: 0.0,
            flange_kgm2: tables.flange_kgm2,
            losses: [1.0; 2],
        };
        match kind {
            "flywheel" => drive,
            "lossy belt" | "lossy screw" => {
                let efficiency = between(0.7, 1.0);
                let weight = if kind == "lossy belt" { 0.0 } else { between(3.0, 9.0) };
                Self { losses: [efficiency.recip(), efficiency], external_nm: weight, ..drive }
            }
            "arm" => Self {
                weight_nm: between(4.0, 10.0),
                angle_rad: between(-PI, PI),
                external_nm: between(-2.0, 2.0),
                ..drive
            },
            _ => Self { external_nm: between(2.0, 8.0), coulomb_nm: between(2.0, 5.0), ..drive },
        }
    }
}
