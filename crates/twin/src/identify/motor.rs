//! Parameters of the motor: current as a function of torque, friction and rotor acceleration.

use super::load::{Share, Shares};
use super::regression::{Fit, Prior, Row, Solve, compared, fit, is_hidden};
use super::windows::{Window, Windows};
use super::{Estimate, Identification, Identified, Open, Zero};
use crate::gear::Spring;
use crate::machine::Machine;
use crate::{Parameters, Switches};
use quantities::Measure;
use std::f64::consts::SQRT_2;

/// Constants of the actuator at the output, from the tables.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tabulated {
    /// J_M: inertia of the rotor \[kgm²\].
    pub(super) rotor_kgm2: f64,
    /// i k_TM: torque constant of the motor [Nm/A].
    pub(super) motor_nm_a: f64,
    /// k_Tout without the no-load friction [Nm/A].
    pub(super) output_nm_a: f64,
    /// Least and largest k_Tout of the tables [Nm/A]: where it is T_0/I_0 as stated, with the no-load friction and without it.
    stated_nm_a: [f64; 2],
    /// i: reduction ratio \[1\].
    pub(super) ratio: f64,
    /// Torsion of the gear.
    spring: Spring,
}

impl Tabulated {
    /// Returns the constants, if the tables have all of them.
    pub(super) fn of(parameters: &Parameters) -> Option<Self> {
        let machine = Machine::of(parameters, Switches::default(), 0).ok()?;
        let motor_nm_a = SQRT_2 * machine.plant.torque_constant;
        let output_nm_a = motor_nm_a / (1.0 + machine.plant.mesh);
        let stated_nm_a = parameters.actuator.torque_constant_out.known().map_or(output_nm_a, |known| known.value.si());
        Some(Self {
            rotor_kgm2: machine.plant.inertia_kgm2,
            motor_nm_a,
            output_nm_a,
            stated_nm_a: [stated_nm_a.min(output_nm_a), stated_nm_a.max(output_nm_a)],
            ratio: machine.ratio,
            spring: machine.plant.spring,
        })
    }
}

impl Tabulated {
    /// Returns a torque constant with half its interval relative to the nearest one that the tables admit.
    pub(super) fn relative(&self, Share { value, half_width }: Share) -> Share {
        let [least, most] = self.stated_nm_a;
        let nearest = value.clamp(least, most);
        Share { value: value / nearest, half_width: half_width / nearest }
    }

    /// Returns by how much the torque constants that the tables admit differ \[1\].
    fn gap(&self) -> f64 {
        let [least, most] = self.stated_nm_a;
        most / least - 1.0
    }
}

/// Relative standard deviation of J_M from the tables: rounding and the share of the flange. A guess.
const ROTOR_SPREAD: f64 = 0.02;

/// Standard deviation of c relative to that of J_M if the current may be sampled in step with the control \[1\].
///
/// The setpoint of the current changes with each period of the speed loop by a part of J_M α; samples at a fixed phase
/// of this period differ from the mean current. Rows every 0.5 ms or 1 ms of the twin yield c smaller by 10.5 %, rows
/// every 62.5 µs or 312.5 µs by less than 0.1 %.
const SAMPLED_SPREAD: f64 = 0.1;

/// Error of c within a run relative to that of J_M if the current may be sampled in step with the control \[1\].
///
/// Rows every 1 ms of a stroke of the twin up to the limit of the speed yield c smaller by 11 % at its begin and by 8 % at its end.
const SAMPLED_WITHIN: f64 = 0.003;

/// Standard deviation of the torque constant of a motor relative to the tables \[1\]. A choice.
///
/// # Source
/// simodrive-611a, table 1-2: the voltage constant may be off by 7.5 %
const MAGNETS: f64 = 0.075;

/// Sampling interval below which a period of the speed loop has several samples \[s\].
const RESOLVED_S: f64 = 2e-4;

/// Smallest relative half interval: over a run of some seconds the temperature changes friction by as much. A choice;
/// the friction of the twin changes by 0.4 % within a run of ten seconds.
const CONSTANT: f64 = 0.005;

/// Smallest number of equations of the motor.
pub(super) const LEAST: usize = 12;

/// Share of the squares of the driven torque above which its own coefficient is estimated.
const DRIVEN: f64 = 1e-4;

/// Standard deviation of d relative to the losses of the teeth in the tables: they lie between none and twice those. A guess.
const TEETH: f64 = 0.5;

/// Share of the sampling interval above which a lag of the motor speed counts, and the smallest lag that does \[s\].
const LAG: f64 = 0.25;
const LAG_LEAST_S: f64 = 1e-4;

/// Smallest ratio F with which further signals give a part of the torque; below it they repeat its noise.
///
/// # Source
/// Staiger and Stock, Econometrica 65 (1997)
const STRONG: f64 = 10.0;

/// Factors by which the signals of a run are larger than those that their columns state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    /// Factor of the torque \[1\].
    pub(super) torque: f64,
    /// Factor of the current \[1\].
    pub(super) current: f64,
}

impl Scale {
    /// Signals as their columns state.
    pub(super) const NONE: Self = Self { torque: 1.0, current: 1.0 };
}

/// Reference of the coefficient c of the rotor's acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tie {
    /// c = J_M (a + d)/2: the scale of the current is open.
    ToTorque,
    /// c = J_M/(i k_TM) of the tables: the scale of the torque is open.
    ToTable,
}

/// Signal from which the motion of the rotor is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum RotorMotion {
    /// The motor speed.
    Motor,
    /// The position of the load: the noise of the motor speed hides the acceleration.
    Load,
}

/// Equations of the motor.
#[derive(Clone, Debug)]
pub(super) struct Equations<'w> {
    windows: Vec<&'w Window>,
    /// The mechanism has losses by the direction of power.
    has_losses: bool,
    step_s: f64,
    current_s: f64,
    /// Mean variances of the noise of driving and driven torque \[N²m²\].
    noise: [f64; 2],
    /// Signal from which Ω and Ω' are taken, and the variances of the noise of Ω' and Ω.
    rotor: (RotorMotion, [f64; 2]),
    tabulated: Option<Tabulated>,
    /// The load drives for a considerable part of the run.
    is_driven: bool,
    /// The run moves in both directions, so that the zero of the current can be estimated.
    has_zero: bool,
    /// A delay of the current has been removed; what is left of it is a column.
    is_delayed: bool,
    /// Lag of the torque that may be left, a column with a prior \[s\].
    torque_error_s: f64,
}

impl<'w> Equations<'w> {
    /// Returns the equations of the windows below the limit of the current; `None` if there are too few.
    pub(super) fn free(
        windows: &'w Windows,
        has_losses: bool,
        tabulated: Option<Tabulated>,
        is_delayed: bool,
    ) -> Option<Self> {
        let free = Self::made(windows, has_losses, tabulated, is_delayed, |window| !window.limited);
        (free.windows.len() >= LEAST).then_some(free)
    }

    /// Returns the equations of all windows if there are too few below the limit: currents beyond every limit are another
    /// unit.
    pub(super) fn of(windows: &'w Windows, has_losses: bool, tabulated: Option<Tabulated>, is_delayed: bool) -> Self {
        let all = || Self::made(windows, has_losses, tabulated, is_delayed, |_| true);
        Self::free(windows, has_losses, tabulated, is_delayed).unwrap_or_else(all)
    }

    fn made(
        all: &'w Windows,
        has_losses: bool,
        tabulated: Option<Tabulated>,
        is_delayed: bool,
        is_taken: impl Fn(&Window) -> bool,
    ) -> Self {
        let windows: Vec<&Window> = all.all.iter().filter(|window| is_taken(window)).collect();
        #[allow(clippy::cast_precision_loss, reason = "counts of windows")]
        let count = (windows.len() as f64).max(1.0);
        let share = |window: &&Window| (window.driving / window.torque).clamp(0.0, 1.0);
        let share = windows.iter().map(share).filter(|share| share.is_finite()).sum::<f64>() / count;
        let squares = |part: fn(&Window) -> f64| windows.iter().map(|window| part(window).powi(2)).sum::<f64>();
        let (driving, driven) = (squares(|window| window.driving), squares(|window| window.torque - window.driving));
        let has_zero = [1.0, -1.0].iter().all(|sign| windows.iter().any(|window| window.sign == *sign));
        let noise = [share * all.torque_noise, (1.0 - share) * all.torque_noise];
        let is_driven = driven > DRIVEN * driving;
        let mut made = Self {
            windows,
            has_losses,
            step_s: all.step_s,
            current_s: all.current_s,
            noise,
            rotor: (RotorMotion::Motor, [0.0; 2]),
            tabulated,
            is_driven,
            has_zero,
            is_delayed,
            torque_error_s: 0.0,
        };
        // The torsion of the gear, by which both differ, is small beside noise that hides the acceleration.
        let accelerations = made.windows.iter().map(|window| window.acceleration.powi(2)).sum::<f64>() / count;
        let is_noisy = all.motor_noise[0] > all.noise[0].max(NOISY * NOISY * accelerations);
        if is_noisy {
            let hides = is_hidden(&made.rows_of_delay(), all.motor_noise[0], 3);
            made.rotor = if hides { (RotorMotion::Load, all.noise) } else { (RotorMotion::Motor, all.motor_noise) };
        }
        made
    }

    /// Returns Ω and Ω' of a window, without the lag of the motor speed \[s\].
    fn rotor(&self, window: &Window, lag: f64) -> [f64; 2] {
        match self.rotor.0 {
            RotorMotion::Motor => [
                window.motor_speed + lag * window.motor_acceleration,
                window.motor_acceleration + lag * window.motor_jerk,
            ],
            RotorMotion::Load => [window.speed, window.acceleration],
        }
    }

    /// Returns the equations with a lag of the torque that may be left \[s\].
    pub(super) fn with_torque_error(self, torque_error_s: f64) -> Self {
        Self { torque_error_s, ..self }
    }

    /// Returns `true` if the rate of the torque is a column.
    fn has_torque_rate(&self) -> bool {
        self.torque_error_s > LAG_LEAST_S && self.tabulated.is_some()
    }

    /// Returns for each direction of motion the share of windows in which the torque drives; `None` without both directions.
    fn driving(&self) -> Option<[f64; 2]> {
        let share = |sign: f64| {
            let own = self.windows.iter().filter(|window| window.sign == sign);
            let [count, driving] = own.fold([0.0; 2], |[count, driving], window| {
                [count + 1.0, driving + (window.driving / window.torque).clamp(0.0, 1.0)]
            });
            (count > 0.0 && driving.is_finite()).then(|| driving / count)
        };
        Some([share(1.0)?, share(-1.0)?])
    }

    /// Returns the place of the zero of the current among the columns.
    fn zero(&self) -> Option<usize> {
        self.has_zero.then_some(4 + usize::from(self.is_driven))
    }

    /// Returns equations without a scale and a tie, whose last column is the rate of the current.
    pub(super) fn rows_of_delay(&self) -> Vec<Row> {
        let lag = self.lag_s(Scale::NONE);
        let row = |window: &&Window| {
            let [speed, acceleration] = self.rotor(window, lag);
            let rest = window.torque - window.driving;
            let mut regressors = vec![window.driving, window.sign, speed, acceleration];
            match regressors.first_mut() {
                Some(all) if !self.is_driven => *all += rest,
                _ => regressors.push(rest),
            }
            regressors.extend(self.has_zero.then_some(1.0));
            regressors.push(window.current_rate);
            Row { regressors, value: window.current, stroke: window.stroke, phase: window.phase }
        };
        self.windows.iter().map(row).collect()
    }

    /// Returns the norm of what c varies within a run because of the instants of the samples \[A\].
    fn error_a(&self) -> f64 {
        let Some(tabulated) = self.tabulated.filter(|_| self.current_s >= RESOLVED_S) else { return 0.0 };
        let square = self.windows.iter().map(|window| window.motor_acceleration.powi(2)).sum::<f64>();
        SAMPLED_WITHIN * tabulated.rotor_kgm2 / tabulated.motor_nm_a * square.sqrt()
    }

    /// Standard deviation of c relative to the tables \[1\].
    fn spread(&self) -> f64 {
        if self.current_s < RESOLVED_S { ROTOR_SPREAD } else { ROTOR_SPREAD.hypot(SAMPLED_SPREAD) }
    }

    /// Returns the lag of the motor speed behind the position of the load \[s\]: the difference of two samples lags by half
    /// their distance, the filter of a drive by its time constant.
    ///
    /// τ = −Σ (Ω − ω − T'/K) α/Σ α²
    ///
    /// # Symbols
    /// T' rate of the torque through the gear \[Nm/s\], K its stiffness from the tables [Nm/rad]
    pub(super) fn lag_s(&self, scale: Scale) -> f64 {
        let spring = self.tabulated.as_ref().map(|tabulated| &tabulated.spring);
        let [product, square] = self.windows.iter().fold([0.0; 2], |[product, square], window| {
            let torque = window.torque / scale.torque;
            let compliance = spring.map_or(0.0, |spring| spring.stiffness_at(spring.angle(torque)).recip());
            let rate = window.torque_rate / scale.torque;
            let behind = window.speed + rate * compliance - window.motor_speed;
            [product + behind * window.acceleration, square + window.acceleration * window.acceleration]
        });
        let lag = product / square;
        if lag.abs() > (LAG * self.step_s).max(LAG_LEAST_S) { lag } else { 0.0 }
    }

    /// Solves I = a T₊ + d T₋ + I_NLS σ + K Ω + c Ω' + I_0 with the signals divided by a scale.
    pub(super) fn fit(&self, solve: Solve, scale: Scale, lag: f64, tie: Tie) -> Option<Fit> {
        let row = |window: &Window, [driving, rest]: [f64; 2]| {
            let [speed, acceleration] = self.rotor(window, lag);
            let [driving, rest] = [driving / scale.torque, rest / scale.torque];
            let mut regressors = vec![driving, window.sign, speed, acceleration];
            let mut value = window.current / scale.current;
            if self.is_driven {
                regressors.push(rest);
            } else if let Some(tabulated) = &self.tabulated {
                // Insufficient for an estimate: the losses of the tables are used.
                value -= rest * (2.0 / tabulated.motor_nm_a - 1.0 / tabulated.output_nm_a);
            }
            if let (Tie::ToTable, Some(tabulated)) = (tie, &self.tabulated) {
                value -= acceleration * tabulated.rotor_kgm2 / tabulated.motor_nm_a;
            }
            regressors.extend(self.has_zero.then_some(1.0));
            regressors.extend(self.is_delayed.then_some(window.current_rate / scale.current));
            regressors.extend(self.has_torque_rate().then_some(window.torque_rate / scale.torque));
            Row { regressors, value, stroke: window.stroke, phase: window.phase }
        };
        let sides = |window: &Window| [window.driving, window.torque - window.driving];
        let rows: Vec<Row> = self.windows.iter().map(|window| row(window, sides(window))).collect();
        let width = rows.first().map_or(0, |row| row.regressors.len());
        let priors = self.tabulated.as_ref().map(|tabulated| self.priors(tabulated, tie, width)).unwrap_or_default();
        let [driving, driven] = self.noise.map(|noise| noise / (scale.torque * scale.torque));
        if is_hidden(&rows, driving, 0) || (self.is_driven && is_hidden(&rows, driven, 4)) {
            let torques = self.instrumented(lag)?;
            let torque = |(window, torque): (&&Window, f64)| {
                let share = driving_share(window);
                row(window, [share * torque, (1.0 - share) * torque])
            };
            let rows: Vec<Row> = self.windows.iter().zip(torques).map(torque).collect();
            return solve(&rows, &[], &priors);
        }
        let [of_acceleration, of_speed] = self.rotor.1;
        let noise = [driving, 0.0, of_speed, of_acceleration, driven];
        let noise = noise.get(..if self.is_driven { 5 } else { 4 }).unwrap_or_default();
        solve(&rows, noise, &priors).or_else(|| Some(solve(&rows, &[], &priors)?.attenuated()))
    }

    /// Returns the torque of each window as the other signals give it \[Nm\].
    ///
    /// T = X c, X = (Ω', σ, Ω, 1) with cos q and sin q, and with losses p X, where these are strong
    ///
    /// # Symbols
    /// p share of the window in which the torque drives
    /// # Source
    /// two-stage least squares: Theil, Repeated least squares applied to complete equation systems (1953); F > 10 of strong
    /// instruments: Staiger and Stock, Instrumental variables regression with weak instruments, Econometrica 65 (1997)
    /// # Valid
    /// the noise of the torque is none of the other signals; what they do not give of the torque says nothing of the motor
    fn instrumented(&self, lag: f64) -> Option<Vec<f64>> {
        let rows = |[hangs, sided]: [bool; 2]| -> Vec<Row> {
            let row = |window: &&Window| {
                let [speed, acceleration] = self.rotor(window, lag);
                let mut regressors = vec![acceleration, window.sign, speed, 1.0];
                if hangs {
                    regressors.extend([window.cosine, window.sine]);
                }
                if sided {
                    let share = driving_share(window);
                    let of_side: Vec<f64> = regressors.iter().map(|value| share * value).collect();
                    regressors.extend(of_side);
                }
                Row { regressors, value: window.torque, stroke: window.stroke, phase: window.phase }
            };
            self.windows.iter().map(row).collect()
        };
        let mut taken = (rows([false; 2]), [false; 2]);
        let mut found = fit(&taken.0, &[], &[])?;
        for more in [[true, false], [false, true]] {
            if more[1] && !self.has_losses {
                continue;
            }
            let parts = [taken.1[0] || more[0], taken.1[1] || more[1]];
            let wider = rows(parts);
            let Some(other) = fit(&wider, &[], &[]) else { continue };
            #[allow(clippy::cast_precision_loss, reason = "a handful")]
            let [width, added] = [other.values.len() as f64, (other.values.len() - found.values.len()) as f64];
            let left = other.square / (other.independent - width).max(1.0);
            if (found.square - other.square) / added > STRONG * left {
                (taken, found) = ((wider, parts), other);
            }
        }
        let value = |row: &Row| row.regressors.iter().zip(&found.values).map(|(a, b)| a * b).sum();
        Some(taken.0.iter().map(value).collect())
    }

    /// Returns what the tables say of the coefficients: c of the rotor, and d of the losses of the teeth.
    fn priors(&self, tabulated: &Tabulated, tie: Tie, width: usize) -> Vec<Prior> {
        let Tabulated { rotor_kgm2, motor_nm_a, output_nm_a, .. } = *tabulated;
        let shares = match (tie, self.is_driven) {
            (Tie::ToTable, _) => [0.0, 0.0],
            (Tie::ToTorque, true) => [0.5, 0.5],
            (Tie::ToTorque, false) => [output_nm_a / motor_nm_a, 0.0],
        };
        let relation = |cells: [(usize, f64); 3], spread| {
            let mut factors = vec![0.0; width];
            for (place, factor) in cells {
                if let Some(cell) = factors.get_mut(place) {
                    *cell += factor;
                }
            }
            Prior { factors, spread }
        };
        let [of_driving, of_driven] = shares.map(|share| share * rotor_kgm2);
        let last = if self.is_driven { 4 } else { 0 };
        let spread =
            if tie == Tie::ToTable { self.spread().hypot(MAGNETS).hypot(tabulated.gap()) } else { self.spread() };
        let rotor = relation([(3, -1.0), (0, of_driving), (last, of_driven)], spread * rotor_kgm2 / motor_nm_a);
        // d/a of the tables, at most one.
        let ratio = 2.0 * output_nm_a / motor_nm_a - 1.0;
        let teeth = relation([(4, 1.0), (0, -ratio), (3, 0.0)], TEETH * (1.0 - ratio) / output_nm_a);
        let has_teeth = self.is_driven && ratio < 1.0;
        // a τ, τ the lag that may be left.
        let lag = relation([(width - 1, 1.0), (0, 0.0), (3, 0.0)], 0.5 * self.torque_error_s / output_nm_a);
        let has_lag = self.has_torque_rate();
        std::iter::once(rotor).chain(has_teeth.then_some(teeth)).chain(has_lag.then_some(lag)).collect()
    }
}

/// Returns the share of a window in which the torque drives.
fn driving_share(window: &Window) -> f64 {
    let share = window.driving / window.torque;
    if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.5 }
}

/// Estimates the parameters of the motor.
///
/// I = a T₊ + d T₋ + I_NLS σ + K Ω + c Ω' + I_0, k_Tout = 1/a, c = J_M (a + d)/2
///
/// # Symbols
/// T₊ torque while it drives the load, T₋ while the load drives, c coefficient of the rotor acceleration, I_0 zero of the
/// current less a times that of the torque
/// # Source
/// docs/theory/twin.md, *Identification*: the losses of the teeth are equal in both directions, so that (a + d)/2 =
/// 1/(i k_TM)
/// # Valid
/// J_M from the tables with a standard deviation of [`ROTOR_SPREAD`], or of [`SAMPLED_SPREAD`]: for a flywheel T is
/// proportional to Ω' except for friction, and the run alone does not separate k_Tout from J_M
pub(super) fn estimate(
    windows: &Windows,
    shares: &Shares,
    parameters: &Parameters,
    is_delayed: bool,
    found: &mut Identification,
) {
    let of = [Identified::TorqueConstant, Identified::StartingCurrent, Identified::CurrentConstant];
    let tabulated = Tabulated::of(parameters);
    found.tabulated_nm_a = tabulated.map(|tabulated| tabulated.output_nm_a);
    let Some(equations) = Equations::free(windows, shares.has_losses, tabulated, is_delayed) else {
        found.open.extend(of.map(|of| (of, Open::AtLimit)));
        return;
    };
    let equations = equations.with_torque_error(shares.torque_error_s);
    let lag = equations.lag_s(Scale::NONE);
    found.motor_lag_s = lag;
    found.rotor = tabulated.map(|tabulated| [tabulated.rotor_kgm2, equations.spread()]);
    let Some(fit) = equations.fit(compared, Scale::NONE, lag, Tie::ToTorque) else {
        found.open.extend(of.map(|of| (of, Open::NotSeparated)));
        return;
    };
    // Where windows are left out, the others rarely cover all speeds and torques.
    let is_limited =
        equations.windows.len() < LIMITED_EACH * windows.all.iter().filter(|window| window.limited).count();
    let separates = |place: usize| {
        if is_limited { fit.is_inflated_within(place, INFLATION_LIMITED) } else { fit.separates(place) }
    };
    let unseparated = if is_limited { Open::AtLimit } else { Open::NotSeparated };
    let free = equations.zero().zip(equations.driving()).filter(|(place, _)| !is_limited || separates(*place));
    let zero = free.and_then(|(place, driving)| zero(&fit, place, driving));
    found.zero = zero.map(|(zero, _)| zero);
    let [of_torque, of_start, of_speed] = of;
    match fit.estimate(0) {
        Some((slope, half)) if half < super::SHARE_MOST * slope.abs() => {
            let value = 1.0 / slope;
            let half_width = (half / (slope * slope)).max(CONSTANT * value.abs());
            found.estimates.push(Estimate { of: of_torque, value, half_width });
        }
        _ => found.open.push((of_torque, Open::Wide)),
    }
    // The prior of c contains that error for the torque constant.
    let of_friction = fit.clone().with_error(equations.error_a());
    for (of, place) in [(of_start, 1), (of_speed, 2)] {
        match of_friction.estimate(place) {
            Some((value, half)) if separates(place) => {
                let of_zero = zero.filter(|_| of == of_start).map_or(0.0, |(_, of_zero)| of_zero);
                let half_width = half + of_zero;
                found.estimates.push(Estimate { of, value, half_width: half_width.max(CONSTANT * value.abs()) });
            }
            _ => found.open.push((of, unseparated)),
        }
    }
}

/// Noise of the acceleration by the motor speed relative to its rms value, above which it counts. A choice: the ripple of a gear,
/// which is no noise, makes 0.4 %.
const NOISY: f64 = 0.006;

/// Number of windows for each at the limit of the current from which on those left out count: a fifth of them. A choice.
const LIMITED_EACH: usize = 4;

/// Largest variance inflation factor of a parameter of the motor if windows at the limit of the current are left out: a
/// condition number of 5. A choice.
const INFLATION_LIMITED: f64 = 25.0;

/// Largest variance inflation factor of the zero; beyond it rounding decides. A choice.
const ZERO_INFLATION: f64 = 1e8;

/// Returns the zero of the current against that of the torque, with the torque that explains it as well, and by how much I_NLS
/// may be off because of that torque \[A\].
///
/// I_0 = −T_0 (s₊ + s₋)/2, δI_NLS = −T_0 (s₊ − s₋)/2, s± = d + (a − d) p±
///
/// # Symbols
/// T_0 zero of the torque, p± share of the windows of a direction in which the torque drives
fn zero(fit: &Fit, place: usize, driving: [f64; 2]) -> Option<(Zero, f64)> {
    let (value, half_width) = fit.estimate(place).filter(|_| fit.is_inflated_within(place, ZERO_INFLATION))?;
    // A slope that the run does not determine leaves the torque of the zero open.
    let (drives, _) = fit.estimate(0).filter(|(slope, half)| *slope > *half)?;
    let driven = if place > 4 { fit.estimate(4)?.0 } else { drives };
    let [forth, back] = driving.map(|share| driven + (drives - driven) * share);
    let slope = Some(0.5 * (forth + back)).filter(|slope| *slope > 0.1 * drives)?;
    let zero = Zero {
        current_q_a: SQRT_2 * value,
        half_width_a: SQRT_2 * half_width,
        torque_nm: -value / slope,
        half_width_nm: half_width / slope,
        is_of_torque: false,
    };
    Some((zero, 0.5 * (forth - back).abs() * zero.most_nm()))
}
