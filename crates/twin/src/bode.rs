//! Frequency responses of the loops: exact linear transfer functions, including sampling, hold and delay.

use crate::control::{CURRENT_RATE_HZ, Gains, POSITION_EVERY, SPEED_EVERY};
use crate::control_loop::Loop;
use crate::load::Local;
use crate::plant::Plant;
use crate::setup::{Fault, Setup};
use crate::twin::Twin;
use std::f64::consts::{PI, TAU};
use std::ops::{Add, Div, Mul, Sub};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Complex {
    pub(crate) re: f64,
    pub(crate) im: f64,
}

impl Complex {
    pub(crate) const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    /// Returns e^(jφ).
    pub(crate) fn unit(phi: f64) -> Self {
        Self::new(phi.cos(), phi.sin())
    }

    pub(crate) fn size(self) -> f64 {
        self.re.hypot(self.im)
    }

    pub(crate) fn angle(self) -> f64 {
        self.im.atan2(self.re)
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)
    }
}

impl Mul<f64> for Complex {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }
}

impl Div for Complex {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let square = other.re * other.re + other.im * other.im;
        Self::new(
            (self.re * other.re + self.im * other.im) / square,
            (self.im * other.re - self.re * other.im) / square,
        )
    }
}

const ONE: Complex = Complex::new(1.0, 0.0);

impl Loop {
    /// Returns the sampling period \[s\].
    fn period_s(self) -> f64 {
        #[allow(clippy::cast_precision_loss, reason = "small counts")]
        let every = match self {
            Self::Current => 1.0,
            Self::Speed => SPEED_EVERY as f64,
            Self::Position => POSITION_EVERY as f64,
        };
        every / CURRENT_RATE_HZ
    }
}

/// A point of a frequency response.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Frequency \[Hz\].
    pub frequency_hz: f64,
    /// Magnitude of the open loop \[1\].
    pub open: f64,
    /// Continuous phase of the open loop \[rad\].
    pub open_phase_rad: f64,
    /// Magnitude of the closed loop \[1\].
    pub closed: f64,
    /// Continuous phase of the closed loop \[rad\].
    pub closed_phase_rad: f64,
}

/// Stability margins of a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margins {
    /// Highest frequency at which the open loop has magnitude one \[Hz\]; `None` if there is none.
    pub crossover_hz: Option<f64>,
    /// Phase margin: smallest distance of the phase from −180° at magnitude one \[rad\].
    pub phase_rad: Option<f64>,
    /// Gain margin: factor on the gain at the stability limit \[1\].
    pub gain: Option<f64>,
    /// Bandwidth: highest frequency up to which the closed loop follows within 3 dB \[Hz\].
    pub bandwidth_hz: Option<f64>,
    /// The closed loop is stable by Nyquist's criterion.
    pub stable: bool,
}

/// A loop with its frequency response and its margins.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopResponse {
    /// Kind of loop.
    pub of: Loop,
    /// Frequency response in order of frequency.
    pub points: Vec<Response>,
    /// Stability margins.
    pub margins: Margins,
}

/// Drive linearised at its initial state: no limits, no dry friction, no hysteresis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Linear<'a> {
    plant: &'a Plant,
    load: &'a Local,
    gains: Gains,
    delay: bool,
    /// The position is measured at the load.
    at_output: bool,
    /// Stiffness at the initial twist [Nm/rad].
    stiffness: f64,
}

impl Linear<'_> {
    /// Returns the transfer function of the hold of a sample: (1 − e^(−sT))/(sT).
    fn hold(s: Complex, period: f64) -> Complex {
        (ONE - Complex::unit(-s.im * period)) / (s * period)
    }

    /// Returns the transfer function of a slow sample read several times by a faster loop: (1 − e^(−sT))/(n (1 −
    /// e^(−sT/n))).
    fn repeated(s: Complex, slow: Loop, quick: Loop) -> Complex {
        let (slow, quick) = (slow.period_s(), quick.period_s());
        (ONE - Complex::unit(-s.im * slow)) / (ONE - Complex::unit(-s.im * quick)) * (quick / slow)
    }

    /// Returns the transfer function of a sampled PI controller: K (1 + (T/T_n) z/(z − 1)).
    fn pi(s: Complex, gain: f64, time: f64, period: f64) -> Complex {
        let z = Complex::unit(s.im * period);
        (ONE + z / (z - ONE) * (period / time)) * gain
    }

    /// Returns the spring of the gear and the load on it: Z = D + K/s, Z_L' = J_L s + b_L + k_L/s + Z.
    fn spring_and_load(&self, s: Complex) -> [Complex; 2] {
        let spring = Complex::new(self.plant.damping_nms, 0.0) + Complex::new(self.stiffness, 0.0) / s;
        let load = s * self.load.inertia_kgm2
            + Complex::new(self.load.viscous_nms, 0.0)
            + Complex::new(self.load.slope_nm, 0.0) / s
            + spring;
        [spring, load]
    }

    /// Returns the motor speed per torque, for rotor and load on the spring of the gear.
    ///
    /// Ω/T = Z_L'/((J_M s + b + Z) Z_L' − Z²)
    pub(crate) fn mechanics(&self, s: Complex) -> Complex {
        let [spring, load] = self.spring_and_load(s);
        let rotor = s * self.plant.inertia_kgm2 + Complex::new(self.plant.viscous_nms, 0.0) + spring;
        load / (rotor * load - spring * spring)
    }

    /// Returns the load speed per motor speed: Z/Z_L'.
    fn through_the_gear(&self, s: Complex) -> Complex {
        let [spring, load] = self.spring_and_load(s);
        spring / load
    }

    fn current_open(&self, s: Complex) -> Complex {
        let period = Loop::Current.period_s();
        let delay = if self.delay { Complex::unit(-s.im * period) } else { ONE };
        let winding = ONE / (s * self.plant.inductance_h + Complex::new(self.plant.resistance_ohm, 0.0));
        Self::pi(s, self.gains.current_p, self.gains.current_time_s, period) * delay * Self::hold(s, period) * winding
    }

    /// Returns the forward path from the speed setpoint to the motor speed, and the feedback path.
    fn speed_path(&self, s: Complex) -> [Complex; 2] {
        let period = Loop::Speed.period_s();
        let current = self.current_open(s);
        let current = current / (ONE + current);
        let controller = Self::pi(s, self.gains.speed_p, self.gains.speed_time_s, period);
        let forth = controller * Self::repeated(s, Loop::Speed, Loop::Current) * current * self.mechanics(s);
        // The speed is the filtered difference of two angles.
        let share = period / (period + self.gains.speed_filter_s);
        let filter = Complex::new(share, 0.0) / (ONE - Complex::unit(-s.im * period) * (1.0 - share));
        [forth, Self::hold(s, period) * filter]
    }

    /// Returns the open loop, and the closed loop from its setpoint to the controlled variable.
    pub(crate) fn both(&self, of: Loop, s: Complex) -> [Complex; 2] {
        match of {
            Loop::Current => {
                let open = self.current_open(s);
                [open, open / (ONE + open)]
            }
            Loop::Speed => {
                let [forth, back] = self.speed_path(s);
                [forth * back, forth / (ONE + forth * back)]
            }
            Loop::Position => {
                let [_, speed] = self.both(Loop::Speed, s);
                let seen = if self.at_output { self.through_the_gear(s) } else { ONE };
                let open = Self::repeated(s, Loop::Position, Loop::Speed) * speed * seen / s * self.gains.position_p;
                [open, open / (ONE + open)]
            }
        }
    }

    fn response(&self, of: Loop) -> LoopResponse {
        let most = 0.5 / of.period_s();
        let (least, steps) = (0.1_f64, 1200);
        let mut points: Vec<Response> = Vec::with_capacity(steps + 1);
        for step in 0..=steps {
            #[allow(clippy::cast_precision_loss, reason = "a thousand")]
            let frequency_hz = least * (0.999 * most / least).powf(step as f64 / steps as f64);
            let [open, closed] = self.both(of, Complex::new(0.0, TAU * frequency_hz));
            let follow =
                |phase: f64, last: Option<f64>| last.map_or(phase, |last| phase - TAU * ((phase - last) / TAU).round());
            let last = points.last();
            points.push(Response {
                frequency_hz,
                open: open.size(),
                // The open loops begin with integrators: phases between −π and −3π/2 continue those of −π and below.
                open_phase_rad: follow(open.angle(), last.map(|last| last.open_phase_rad).or(Some(-0.75 * PI))),
                closed: closed.size(),
                closed_phase_rad: follow(closed.angle(), last.map(|last| last.closed_phase_rad)),
            });
        }
        let margins = margins(&points);
        LoopResponse { of, points, margins }
    }
}

fn margins(points: &[Response]) -> Margins {
    let mut found = Margins { crossover_hz: None, phase_rad: None, gain: None, bandwidth_hz: None, stable: true };
    let mut turns = 0_i32;
    for pair in points.windows(2) {
        let [a, b] = pair else { continue };
        // Linear interpolation over the logarithm of the frequency.
        let between = |u: f64, from: f64, to: f64| from + u * (to - from);
        let at = |u: f64| a.frequency_hz * (b.frequency_hz / a.frequency_hz).powf(u);
        let (la, lb) = (a.open.ln(), b.open.ln());
        if la * lb <= 0.0 && la != lb {
            let u = la / (la - lb);
            let phase = PI + between(u, a.open_phase_rad, b.open_phase_rad);
            found.crossover_hz = Some(at(u));
            if found.phase_rad.is_none_or(|least| phase.abs() < least.abs()) {
                found.phase_rad = Some(phase);
            }
        }
        let place = |phase: f64| (phase + PI) / TAU;
        let (pa, pb) = (place(a.open_phase_rad), place(b.open_phase_rad));
        if pa.floor() != pb.floor() {
            let border = pa.max(pb).floor();
            let u = (border - pa) / (pb - pa);
            let size = between(u, la, lb).exp();
            if size > 1.0 {
                turns += if pb < pa { -1 } else { 1 };
            } else {
                let gain = 1.0 / size;
                found.gain = Some(found.gain.map_or(gain, |least: f64| least.min(gain)));
            }
        }
        let limit = 0.5_f64.sqrt();
        if a.closed >= limit && b.closed < limit {
            found.bandwidth_hz = Some(at((a.closed - limit) / (a.closed - b.closed)));
        }
    }
    found.stable = turns == 0;
    found
}

impl LoopResponse {
    /// Computes the loops of a setup at its initial state, the innermost first.
    ///
    /// # Source
    /// docs/theory/twin.md
    /// # Valid
    /// linear: no limits, no dry friction, no hysteresis, stiffness of the torsion region at the start; without
    /// aliasing from above half the sampling rate
    /// # Errors
    /// [`Fault`] of [`Twin::new`]
    pub fn of(setup: &Setup<'_>) -> Result<Vec<Self>, Fault> {
        let twin = Twin::new(setup)?;
        let linear = linear(&twin, setup);
        Ok(Loop::ALL.map(|of| linear.response(of)).into())
    }
}

/// Returns the linearised drive of a run at its initial state.
pub(crate) fn linear<'a>(twin: &'a Twin<'_>, setup: &Setup<'_>) -> Linear<'a> {
    let (plant, load) = twin.linear();
    let (delay, at_output) = (setup.switches.delay, setup.loop_at_output);
    Linear {
        plant,
        load,
        gains: *twin.gains(),
        delay,
        at_output,
        stiffness: plant.spring.stiffness_at(twin.state.twist_rad),
    }
}

#[cfg(test)]
#[path = "bode_tests.rs"]
mod tests;
