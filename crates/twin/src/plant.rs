//! Motor, gear and load as equations of motion, and the step of the solver.

use crate::gear::{Anchor, ELEMENTS, Hysteresis, KinematicError, Spring};
use crate::load::Local;

/// The constants of the equations; those that follow the temperature are set anew every millisecond.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plant {
    /// R of a phase at the temperature of the winding \[Ω\].
    pub(crate) resistance_ohm: f64,
    /// L of a phase \[H\].
    pub(crate) inductance_h: f64,
    /// ψ, peak of a phase \[Vs\].
    pub(crate) flux_vs: f64,
    /// p i: electrical angle per angle of the output.
    pub(crate) electrical: f64,
    /// k_TM i/√2: torque at the output per i_q [Nm/A].
    pub(crate) torque_constant: f64,
    /// J of what turns with the wave generator, at the output \[kgm²\].
    pub(crate) inertia_kgm2: f64,
    /// Friction of motor and gear that does not depend on the speed \[Nm\], its breakaway value as a multiple, and its
    /// viscous part [Nm s/rad].
    pub(crate) friction_nm: f64,
    pub(crate) breakaway: f64,
    pub(crate) viscous_nms: f64,
    /// Friction of the teeth per torque: 1/η − 1.
    pub(crate) mesh: f64,
    /// Torque of the closed brake \[Nm\]; zero when it is open.
    pub(crate) brake_nm: f64,
    pub(crate) spring: Spring,
    pub(crate) hysteresis: Hysteresis,
    /// Damping of the twist [Nm s/rad].
    pub(crate) damping_nms: f64,
    pub(crate) kinematic: Option<KinematicError>,
}

/// Where energy went since the start \[J\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// From the inverter to the motor.
    pub terminal_j: f64,
    /// Heat of the winding.
    pub copper_j: f64,
    /// No-load friction of motor and gear.
    pub friction_j: f64,
    /// Friction of the teeth under torque.
    pub mesh_j: f64,
    /// Heat of the brake.
    pub brake_j: f64,
    /// Damping of the gear.
    pub damping_j: f64,
    /// Hysteresis of the gear.
    pub hysteresis_j: f64,
    /// Given to the load at the flange.
    pub flange_j: f64,
    /// Difference of the printed k_TM and k_EM: work that the voltage shows and the torque does not.
    pub constants_j: f64,
    /// Of the terminal energy the part that came back, as a positive number.
    pub regenerated_j: f64,
}

/// State of the plant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct State {
    /// i_d, i_q \[A\], θ \[rad\], Ω [rad/s], q \[rad\], ω [rad/s]; θ and Ω are those of the motor over i.
    pub(crate) x: [f64; 6],
    /// Forces of the hysteresis \[Nm\].
    pub(crate) force: [f64; ELEMENTS],
    /// Direction of sliding at the motor and in the load; 0 sticks.
    pub(crate) sliding: [f64; 2],
    pub(crate) energies: Energies,
    /// Angle that the closed brake has slipped \[rad\].
    pub(crate) slipped_rad: f64,
    /// Error of the transmission at θ and its slope.
    pub(crate) error: (f64, f64),
    /// Torque through the gear at the start of the last step \[Nm\], its twist \[rad\] and the acceleration of the load.
    pub(crate) gear_nm: f64,
    pub(crate) twist_rad: f64,
    pub(crate) acceleration_rad_s2: f64,
    /// Whether the inverter switches; without pulses no current flows.
    pub(crate) pulses: bool,
}

/// A stop that the load meets, elastic.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stop {
    pub(crate) at_rad: f64,
    /// Held to both sides, or only against motion in the positive direction (+1) or the negative (−1).
    pub(crate) side: f64,
    pub(crate) stiffness_nm: f64,
    pub(crate) damping_nms: f64,
}

impl Stop {
    /// Torque that it takes \[Nm\].
    #[inline]
    fn torque(&self, position: f64, speed: f64) -> f64 {
        let way = position - self.at_rad;
        if self.side != 0.0 && way * self.side <= 0.0 {
            return 0.0;
        }
        let torque = self.stiffness_nm * way + self.damping_nms * speed;
        if self.side != 0.0 && torque * self.side < 0.0 { 0.0 } else { torque }
    }
}

/// What does not change within a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Given<'a> {
    /// u_d, u_q \[V\].
    pub(crate) voltage: [f64; 2],
    pub(crate) load: &'a Local,
    pub(crate) stop: Option<&'a Stop>,
    pub(crate) anchor: Option<&'a Anchor>,
}

/// Reciprocals of L, J_M and J_L.
#[derive(Clone, Copy)]
struct Over {
    inductance: f64,
    inertia: f64,
    load: f64,
}

/// Slopes of the state and powers of the accounts at one stage.
#[derive(Clone, Copy)]
struct Flow {
    slope: [f64; 6],
    /// i_d, i_q, i², i_q Ω, Ω², σ Ω|T|, φ'², T ω: what the accounts are made of.
    power: [f64; 8],
}

impl Plant {
    /// Error of the transmission and its slope.
    #[inline]
    fn error(&self, anchor: Option<&Anchor>, theta: f64) -> (f64, f64) {
        match (&self.kinematic, anchor) {
            (_, Some(anchor)) => anchor.at(theta),
            (Some(error), None) => error.at(theta),
            (None, None) => (0.0, 0.0),
        }
    }

    /// Sets error and twist of a state whose angles were set.
    pub(crate) fn place(&self, state: &mut State) {
        state.error = self.error(None, state.x[2]);
        state.twist_rad = state.x[2] - state.x[4] - state.error.0;
    }

    /// What friction may hold at the motor under a torque of the gear \[Nm\].
    #[inline]
    fn held(&self, gear_nm: f64) -> f64 {
        self.friction_nm + self.brake_nm + self.mesh * gear_nm.abs()
    }

    /// The equations.
    ///
    /// L i_d' = u_d − R i_d + ω_e L i_q, L i_q' = u_q − R i_q − ω_e (L i_d + ψ), ω_e = p i Ω;
    /// J_M Ω' = k i_q − (1 − e') T − b Ω − σ (T_s + T_Br + (1/η − 1)|T|); J_L ω' = T − T_L;
    /// T = T_K(φ) + Σ F_j + D φ', φ = θ − q − e(θ)
    ///
    /// # Source
    /// docs/theory/twin.md
    #[inline(always)]
    fn flow(&self, x: &[f64; 6], error: (f64, f64), state: &State, given: &Given<'_>, over: &Over) -> Flow {
        let [i_d, i_q, theta, omega, q, speed] = *x;
        let [u_d, u_q] = given.voltage;
        let (r, l) = (self.resistance_ohm, self.inductance_h);
        let electric = self.electrical * omega;
        let di_d = (u_d - r * i_d + electric * l * i_q) * over.inductance;
        let di_q = (u_q - r * i_q - electric * (l * i_d + self.flux_vs)) * over.inductance;
        let (error, error_slope) = error;
        let phi = theta - q - error;
        let passed = 1.0 - error_slope;
        let rate = omega * passed - speed;
        let twisted = self.spring.torque(phi) + self.hysteresis.torque(&state.force, phi - state.twist_rad);
        let damping = self.damping_nms * rate;
        let gear = twisted + damping;
        let motor = self.torque_constant * i_q;
        let [sliding, load_sliding] = state.sliding;
        let viscous = self.viscous_nms * omega;
        let mesh = self.mesh * gear.abs();
        let acceleration = if sliding == 0.0 {
            0.0
        } else {
            (motor - viscous - gear * passed - sliding * (self.friction_nm + self.brake_nm + mesh)) * over.inertia
        };
        let contact = given.stop.map_or(0.0, |stop| stop.torque(q, speed));
        let load = if load_sliding == 0.0 {
            0.0
        } else {
            (gear - given.load.torque(q, speed) - contact - load_sliding * given.load.coulomb_nm) * over.load
        };
        Flow {
            slope: [di_d, di_q, omega, acceleration, speed, load],
            power: [
                i_d,
                i_q,
                i_d * i_d + i_q * i_q,
                i_q * omega,
                omega * omega,
                sliding * omega * gear.abs(),
                rate * rate,
                gear * speed,
            ],
        }
    }

    /// Whether what sticks begins to slide, from the torques at the start of a step.
    fn let_go(&self, state: &mut State, given: &Given<'_>) {
        let [_, i_q, theta, _, q, speed] = state.x;
        let (error, error_slope) = state.error;
        let phi = theta - q - error;
        let gear = self.spring.torque(phi) + self.hysteresis.torque(&state.force, phi - state.twist_rad)
            - self.damping_nms * speed;
        if state.sliding[0] == 0.0 {
            let driving = self.torque_constant * i_q - gear * (1.0 - error_slope);
            let held = self.friction_nm * self.breakaway + self.brake_nm + self.mesh * gear.abs();
            if driving.abs() > held {
                state.sliding[0] = driving.signum();
            }
        }
        if state.sliding[1] == 0.0 {
            let contact = given.stop.map_or(0.0, |stop| stop.torque(q, 0.0));
            let driving = gear - given.load.torque(q, 0.0) - contact;
            if driving.abs() > given.load.coulomb_nm {
                state.sliding[1] = driving.signum();
            }
        }
    }

    /// One step of the classic Runge-Kutta method of fourth order; the accounts are integrated with it. Dry friction holds a body
    /// exactly: it is at rest from the step in which its speed changes sign until the torque exceeds what friction holds.
    #[inline]
    pub(crate) fn step(&self, state: &mut State, given: &Given<'_>, h: f64) {
        if state.sliding[0] == 0.0 || state.sliding[1] == 0.0 {
            self.let_go(state, given);
        }
        let start = state.x;
        // Without pulses no current flows.
        let inductance = if state.pulses { 1.0 / self.inductance_h } else { 0.0 };
        let over = Over { inductance, inertia: 1.0 / self.inertia_kgm2, load: 1.0 / given.load.inertia_kgm2 };
        let at = |x: &[f64; 6]| self.flow(x, self.error(given.anchor, x[2]), state, given, &over);
        let ahead = |flow: &Flow, h: f64| -> [f64; 6] {
            let mut x = start;
            for (x, slope) in x.iter_mut().zip(&flow.slope) {
                *x += h * slope;
            }
            x
        };
        let a = self.flow(&start, state.error, state, given, &over);
        let b = at(&ahead(&a, 0.5 * h));
        let c = at(&ahead(&b, 0.5 * h));
        let d = at(&ahead(&c, h));
        let sixth = h / 6.0;
        let mean = |[a, b, c, d]: [f64; 4]| sixth * (a + 2.0 * (b + c) + d);
        for ((x, (a, b)), (c, d)) in
            state.x.iter_mut().zip(a.slope.iter().zip(&b.slope)).zip(c.slope.iter().zip(&d.slope))
        {
            *x += mean([*a, *b, *c, *d]);
        }
        let mut worked = [0.0; 8];
        for ((work, (a, b)), (c, d)) in
            worked.iter_mut().zip(a.power.iter().zip(&b.power)).zip(c.power.iter().zip(&d.power))
        {
            *work = mean([*a, *b, *c, *d]);
        }
        let [charge_d, charge_q, square, turned, fast, rubbed, sheared, given_on] = worked;
        let [u_d, u_q] = given.voltage;
        // Dry friction of constant torque: its work is that torque times the way.
        let slid = state.sliding[0] * (state.x[2] - start[2]);
        let terminal = 1.5 * (u_d * charge_d + u_q * charge_q);
        let energies = &mut state.energies;
        energies.terminal_j += terminal;
        energies.regenerated_j += (-terminal).max(0.0);
        energies.copper_j += 1.5 * self.resistance_ohm * square;
        energies.friction_j += self.viscous_nms * fast + self.friction_nm * slid;
        energies.mesh_j += self.mesh * rubbed;
        energies.brake_j += self.brake_nm * slid;
        energies.damping_j += self.damping_nms * sheared;
        energies.flange_j += given_on;
        energies.constants_j += (1.5 * self.flux_vs * self.electrical - self.torque_constant) * turned;
        state.acceleration_rad_s2 = a.slope[5];
        self.settle(state, given, start);
    }

    /// After a step: hysteresis, and bodies that came to rest.
    #[inline]
    fn settle(&self, state: &mut State, given: &Given<'_>, start: [f64; 6]) {
        state.error = self.error(given.anchor, state.x[2]);
        let phi = state.x[2] - state.x[4] - state.error.0;
        state.energies.hysteresis_j += self.hysteresis.advance(&mut state.force, phi - state.twist_rad);
        state.twist_rad = phi;
        let [_, _, theta, omega, _, speed] = state.x;
        if self.brake_nm > 0.0 {
            state.slipped_rad += (theta - start[2]).abs();
        }
        state.gear_nm = self.spring.torque(phi)
            + self.hysteresis.torque(&state.force, 0.0)
            + self.damping_nms * (omega * (1.0 - state.error.1) - speed);
        if omega * state.sliding[0] < 0.0 {
            if self.held(state.gear_nm) > 0.0 {
                state.energies.friction_j += 0.5 * self.inertia_kgm2 * omega * omega;
                state.x[3] = 0.0;
                state.sliding[0] = 0.0;
            } else {
                state.sliding[0] = -state.sliding[0];
            }
        }
        if speed * state.sliding[1] < 0.0 {
            if given.load.coulomb_nm > 0.0 {
                state.x[5] = 0.0;
                state.sliding[1] = 0.0;
            } else {
                state.sliding[1] = -state.sliding[1];
            }
        }
    }

    /// The inverter stops: the energy of the windings returns through its diodes at once.
    pub(crate) fn block(&self, state: &mut State) {
        let stored = self.magnetic(state);
        state.energies.terminal_j -= stored;
        state.energies.regenerated_j += stored;
        state.x[0] = 0.0;
        state.x[1] = 0.0;
        state.pulses = false;
    }

    fn magnetic(&self, state: &State) -> f64 {
        let [i_d, i_q, ..] = state.x;
        0.75 * self.inductance_h * (i_d * i_d + i_q * i_q)
    }

    /// Energy that windings, rotor and gear hold \[J\].
    pub(crate) fn stored(&self, state: &State) -> f64 {
        let omega = state.x[3];
        self.magnetic(state)
            + 0.5 * self.inertia_kgm2 * omega * omega
            + self.spring.energy(state.twist_rad)
            + self.hysteresis.energy(&state.force)
    }

    /// The largest product of a step and an eigenvalue of the equations: what a step must keep below about one.
    pub(crate) fn stiffness(&self, load_kgm2: f64, stop_nm: f64, speed_max: f64, h: f64) -> f64 {
        let spring = self.spring.stiffest() + self.hysteresis.stiffness.iter().sum::<f64>();
        let swing = (spring / self.inertia_kgm2 + (spring + stop_nm) / load_kgm2).sqrt();
        let electric = self.resistance_ohm / self.inductance_h;
        h * swing.max(electric).max(self.electrical * speed_max)
    }
}

impl Energies {
    /// What came from the terminals and is neither lost, nor given to the load, nor stored: the error of the balance.
    pub(crate) fn unaccounted(&self, stored_j: f64) -> f64 {
        self.terminal_j
            - self.copper_j
            - self.friction_j
            - self.mesh_j
            - self.brake_j
            - self.damping_j
            - self.hysteresis_j
            - self.flange_j
            - self.constants_j
            - stored_j
    }

    /// Energy that went through the motor, both ways.
    pub(crate) fn throughput(&self) -> f64 {
        self.terminal_j + 2.0 * self.regenerated_j
    }
}

impl Energies {
    /// Heat in the housing: all losses but that of the copper.
    pub(crate) fn heat(&self) -> f64 {
        self.friction_j + self.mesh_j + self.brake_j + self.damping_j + self.hysteresis_j
    }
}
