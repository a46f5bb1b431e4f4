//! Signals whose unit, sign or side differs from the convention of the columns: disagreement of two signals, or of an
//! estimate with the tables.

use super::load::{Share, Shares};
use super::motor::Tabulated;
use super::moves::Followed;
use super::windows::{Strokes, Windows};
use super::{Estimate, Identification, Identified, Observed, Open, Stated};
use super::{scale, sizes};
use mechanism::Extra;
use quantities::identified;
use std::f64::consts::{PI, SQRT_2};

identified! {
    /// Signal of a run.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Column {
        /// Time.
        Time = "time",
        /// Position of the load.
        Position = "position",
        /// Speed of the load.
        Speed = "speed",
        /// Motor speed over i.
        MotorSpeed = "motor_speed",
        /// Torque through the gear.
        Torque = "torque",
        /// i_q.
        Current = "current_q",
    }
}

identified! {
    /// Convention that a signal seems to have.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Misread {
        /// The opposite sign.
        Reversed = "reversed",
        /// Degrees instead of radians.
        Degrees = "degrees",
        /// Revolutions instead of radians.
        Turns = "turns",
        /// Revolutions per minute instead of radians per second.
        PerMinute = "per_minute",
        /// The motor shaft without division by i (a torque: without multiplication).
        MotorShaft = "motor_shaft",
        /// The motor shaft in revolutions per minute.
        MotorShaftPerMinute = "motor_shaft_per_minute",
        /// The shaft behind the stage instead of the output of the actuator.
        BehindStage = "behind_stage",
        /// Milliseconds instead of seconds.
        Milliseconds = "milliseconds",
        /// Minutes instead of seconds.
        Minutes = "minutes",
        /// The rms value instead of the peak value of a phase.
        Rms = "rms",
        /// i_q of a power-invariant transformation, √(3/2) times the peak of a phase.
        PowerInvariant = "power_invariant",
        /// √2 times the peak value of a phase.
        PeakTwice = "peak_twice",
        /// Newton centimetres instead of newton metres.
        NewtonCentimetres = "newton_centimetres",
        /// Newton millimetres (millinewton metres) instead of newton metres.
        NewtonMillimetres = "newton_millimetres",
        /// Kilonewton metres instead of newton metres.
        KilonewtonMetres = "kilonewton_metres",
        /// Pound-force feet instead of newton metres.
        PoundForceFeet = "pound_force_feet",
        /// Pound-force inches instead of newton metres.
        PoundForceInches = "pound_force_inches",
        /// Ounce-force inches instead of newton metres.
        OunceForceInches = "ounce_force_inches",
        /// Kilogram-force metres, or a tenth of newton metres.
        KilogramForceMetres = "kilogram_force_metres",
        /// Kilogram-force centimetres, or ten times newton metres.
        KilogramForceCentimetres = "kilogram_force_centimetres",
        /// Milliamperes instead of amperes.
        Milliamperes = "milliamperes",
        /// Payloads and process torques that the project states are not in the run.
        PayloadMissing = "payload_missing",
        /// The moves of the run carry payloads or process torques that the project does not state.
        PayloadUnstated = "payload_unstated",
        /// The weight acts on the opposite side: the position counts in the opposite direction, or with an offset of
        /// half a turn.
        GravityOpposite = "gravity_opposite",
        /// Absolute values, without the sign of the signal.
        Magnitude = "magnitude",
        /// Negative friction, which would drive the axis.
        NegativeFriction = "negative_friction",
        /// Time stamps that scatter, while no signal shows at which instants the rows were sampled.
        TimeStamps = "time_stamps",
        /// One value over all rows, or over a reversal of the motion.
        Frozen = "frozen",
        /// Values of another column.
        Doubled = "doubled",
        /// Single values far beside those before and behind.
        Outlier = "outlier",
        /// A position that jumps while the motor does not turn.
        Jump = "jump",
        /// Unknown convention.
        Other = "other",
    }
}

/// Sign of another convention of a signal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Doubt {
    /// Signal that disagrees.
    pub column: Column,
    /// Convention that the signal seems to have.
    pub misread: Misread,
    /// Value that causes the doubt: a ratio of two signals or of an estimate and its table value, an angle \[rad\], a
    /// torque \[Nm\], a scatter \[s\].
    pub value: f64,
    /// Ratio that the convention has exactly, if it differs from a measured one.
    pub by_convention: Option<f64>,
}

impl Doubt {
    pub(super) const fn new(column: Column, misread: Misread, value: f64) -> Self {
        Self { column, misread, value, by_convention: None }
    }
}

/// Largest deviation of a ratio of two signals that should be one. A choice.
const AGREE: f64 = 0.1;

/// Largest deviation from a ratio with a known cause. A choice.
const NAMED: f64 = 0.06;

/// Largest deviation of a torque constant from the tables, beyond its interval. A choice: measured joints are within.
const CONSTANT: f64 = 0.15;

/// Largest deviation of a torque constant that the scatter of magnets explains, if a known convention explains it as well.
///
/// # Source
/// simodrive-611a, table 1-2: the voltage constant may be off by 7.5 %
pub(super) const SCATTER: f64 = 0.075;

/// Half intervals by which a torque constant must lie beyond that scatter for a convention. A choice: three standard deviations.
const BEYOND: f64 = 1.5;

/// Smallest angle between the stated and the estimated weight that causes a doubt \[rad\].
const OPPOSITE: f64 = 0.75 * PI;

/// Largest deviation of the estimated weight from the stated one mirrored at the vertical, and the smallest from the stated one, that
/// cause a doubt \[rad\]. A choice.
const MIRRORED: f64 = 0.1;
const APART: f64 = 0.3;

/// Smallest size of a constant torque of the other sign, relative to the stated one, that is this one on the other side. A choice.
const SAME: f64 = 0.5;

/// One rad/s in revolutions per minute.
const PER_MINUTE: f64 = 30.0 / PI;

/// Speed of a time in minutes over that of the position differentiated with it.
const MINUTES: f64 = 1.0 / 60.0;

/// One radian in degrees.
const DEGREES: f64 = 180.0 / PI;

/// Comparison of the signals with each other.
#[derive(Clone, Debug)]
pub(super) struct Signals {
    pub(super) doubts: Vec<Doubt>,
}

impl Signals {
    /// Compares speeds with the position, and the position with the motion that it follows.
    ///
    /// `accelerating` returns the sign of the torque that accelerates in the direction of the position.
    pub(super) fn of(
        run: &Observed,
        strokes: &Strokes,
        followed: Option<&Followed<'_>>,
        stated: &Stated<'_>,
        accelerating: impl Fn() -> Option<f64>,
    ) -> Self {
        let direction = followed.and_then(Followed::direction);
        let followed = followed.filter(|followed| followed.follows());
        let tabulated = Tabulated::of(stated.parameters);
        let ratio = tabulated.as_ref().map_or(f64::NAN, |tabulated| tabulated.ratio);
        let stage = stated.mechanism.stage_ratio();
        let mut doubts = Vec::new();
        if let Some(slope) = followed.map(|followed| followed.slope) {
            // A run may make smaller or larger moves; only ratios with a known cause are doubts.
            let names = [(DEGREES, Misread::Degrees), (0.5 / PI, Misread::Turns), (ratio, Misread::MotorShaft)];
            let named = nearest(slope, &names).or_else(|| nearest(slope, &behind_stage(1.0 / stage)));
            doubts.extend(named.map(|misread| Doubt::new(Column::Position, misread, slope)));
        }
        let against = |signal: &[f64]| {
            let [mut product, mut square] = [0.0; 2];
            for place in strokes.ranges.iter().flat_map(|(range, _)| range.clone()) {
                if let (Some(own), Some(speed)) = (signal.get(place), strokes.speed.get(place)) {
                    product += own * speed;
                    square += speed * speed;
                }
            }
            product / square
        };
        let names = [
            (-1.0, Misread::Reversed),
            (DEGREES, Misread::Degrees),
            (PER_MINUTE, Misread::PerMinute),
            (1e3, Misread::Milliseconds),
            (MINUTES, Misread::Minutes),
        ];
        let of_motor = [
            (ratio, Misread::MotorShaft),
            (-ratio, Misread::MotorShaft),
            (ratio * PER_MINUTE, Misread::MotorShaftPerMinute),
            (-ratio * PER_MINUTE, Misread::MotorShaftPerMinute),
        ];
        let speeds = run.speed_rad_s.as_ref().map(|speed| (Column::Speed, against(speed)));
        let motor = Some((Column::MotorSpeed, against(&run.motor_rad_s)));
        // A position in degrees disagrees with every speed.
        let is_minutes = |factor: f64| (factor - MINUTES).abs() < (factor - 1.0 / DEGREES).abs();
        let of_position = |factor: f64| (factor - 1.0 / DEGREES).abs() < NAMED / DEGREES && !is_minutes(factor);
        let all: Vec<(Column, f64)> = speeds.into_iter().chain(motor).collect();
        if all.iter().any(|(_, value)| of_position(*value)) && doubts.is_empty() {
            let value = all.first().map_or(0.0, |(_, value)| 1.0 / value);
            doubts.push(Doubt::new(Column::Position, Misread::Degrees, value));
        }
        // The motor turns against the position: the motion, else the torque, shows which of both is wrong.
        let is_reversed = |value: f64| (value + 1.0).abs() < AGREE;
        let is_against = all.iter().any(|(column, value)| *column == Column::MotorSpeed && is_reversed(*value));
        let mut all = all;
        if is_against && direction.or_else(accelerating) == Some(-1.0) {
            doubts.push(Doubt::new(Column::Position, Misread::Reversed, -1.0));
            all.iter_mut().for_each(|(_, value)| *value = -*value);
        }
        doubts.extend(sizes::doubts(run, strokes, tabulated.as_ref()));
        for (column, value) in all {
            if (value - 1.0).abs() < AGREE || of_position(value) || !value.is_finite() {
                continue;
            }
            // A motor speed whose ratio is that of degrees may also be on the motor side, which is more likely.
            let own = nearest(value, &names);
            let side = if column == Column::MotorSpeed { nearest(value, &of_motor) } else { None };
            // Behind a stage the position moves by 1/i_s of what the motor moves; a speed of it is that of another shaft.
            let of_stage = match column {
                Column::MotorSpeed => nearest(value, &behind_stage(stage)).map(|misread| (Column::Position, misread)),
                _ => nearest(value, &behind_stage(1.0 / stage)).map(|misread| (column, misread)),
            };
            let found = match (side.or(own), of_stage) {
                (None, Some((column, misread))) => Doubt::new(column, misread, 1.0 / stage),
                (named, _) => Doubt::new(column, named.unwrap_or(Misread::Other), value),
            };
            let is_known = |doubt: &Doubt| doubt.column == found.column && doubt.misread == found.misread;
            if !doubts.iter().any(is_known) {
                doubts.push(found);
            }
        }
        Self { doubts }
    }
}

/// Returns the ratio of a signal behind a stage; none without a stage.
fn behind_stage(ratio: f64) -> Vec<(f64, Misread)> {
    if (ratio.abs() - 1.0).abs() < AGREE { Vec::new() } else { vec![(ratio, Misread::BehindStage)] }
}

/// Returns the convention with a ratio.
fn nearest(value: f64, names: &[(f64, Misread)]) -> Option<Misread> {
    let near = names.iter().filter(|(ratio, _)| (value / ratio - 1.0).abs() < NAMED);
    let off = |(ratio, _): &(f64, Misread)| (value / ratio - 1.0).abs();
    near.min_by(|a, b| off(a).total_cmp(&off(b))).map(|(_, misread)| *misread)
}

/// Returns the convention of the current that a torque constant over that of the table, with its half width, speaks for,
/// and its exact ratio.
fn of_constant(value: f64, half: f64) -> Option<(Misread, Option<f64>)> {
    let names =
        [(SQRT_2, Misread::Rms), (1.0 / SQRT_2, Misread::PeakTwice), ((2.0_f64 / 3.0).sqrt(), Misread::PowerInvariant)];
    let off = (value - 1.0).abs() - half;
    // Every run is tried: three standard deviations, as for the slopes of the scale.
    let beyond = (value - 1.0).abs() - BEYOND * half > SCATTER;
    let near = |(ratio, _): &&(f64, Misread)| (value - ratio).abs() < half;
    let within = names.iter().find(|name| beyond && near(name)).map(|(_, misread)| *misread);
    match nearest(value, &names).or(within) {
        Some(misread) if beyond => {
            let exact = names.iter().find(|(_, own)| *own == misread).map(|(ratio, _)| *ratio);
            Some((misread, exact))
        }
        _ if off > CONSTANT => Some((Misread::Other, None)),
        _ => None,
    }
}

/// Compares the estimates with the physically possible sign, and with project and tables.
pub(super) fn of_estimates(
    stated: &Stated<'_>,
    extras: &[Extra],
    windows: &Windows,
    shares: &Shares,
    direction: Option<f64>,
    found: &mut Identification,
) {
    let of = |of| found.estimates.iter().find(|each| each.of == of).copied();
    let mut doubts = Vec::new();
    let none = Extra::none();
    let plain = stated.mechanism.plain(extras.first().unwrap_or(&none));
    let tabulated = Tabulated::of(stated.parameters);
    if let Some(inertia) = shares.inertia.filter(|share| share.value < -share.half_width) {
        let value = plain.map_or(inertia.value, |plain| inertia.value * plain.inertia_kgm2);
        doubts.push(Doubt::new(Column::Torque, Misread::Reversed, value));
    } else {
        let is_delayed = found.are_lags_estimated[1];
        let scale = tabulated.as_ref().and_then(|tabulated| scale::doubt(windows, tabulated, shares, is_delayed));
        // Angles that are all in degrees agree with each other.
        let degrees = shares.inertia.map(|share| share.value).filter(|value| {
            scale.is_none_or(|doubt| doubt.misread == Misread::Other)
                && nearest(*value, &[(1.0 / DEGREES, Misread::Degrees)]).is_some()
        });
        let of_moves = || Some(Doubt::new(Column::Torque, Misread::PayloadUnstated, shares.unstated_nm?));
        let of_degrees = |value| Doubt::new(Column::Position, Misread::Degrees, value);
        doubts.extend(degrees.map(of_degrees).or(scale).or_else(|| scale::payload(shares)).or_else(of_moves));
    }
    let has_doubt = !doubts.is_empty();
    #[allow(clippy::cast_precision_loss, reason = "counts of windows")]
    let mean = |part: fn(&super::windows::Window) -> f64| {
        windows.all.iter().map(part).sum::<f64>() / (windows.all.len() as f64).max(1.0)
    };
    // Both parts together at the mean speed: one alone may be negative if friction decreases with the speed.
    let (speed, size) = (mean(|window| window.speed.abs()), mean(|window| window.torque.abs()));
    let friction = |start, with_speed, least: f64| {
        let (start, with_speed) = (of(start)?, of(with_speed)?);
        let (value, half) = (start.value + with_speed.value * speed, start.half_width + with_speed.half_width * speed);
        (value < -half - least).then_some(value)
    };
    if !has_doubt && let Some(value) = friction(Identified::Coulomb, Identified::Viscous, 0.02 * size) {
        doubts.push(Doubt::new(Column::Torque, Misread::NegativeFriction, value));
    }
    // Friction that falls with the speed to less than nothing at the mean speed is none.
    let falls = of(Identified::Viscous).filter(|each| each.value * speed < -each.half_width * speed - 0.02 * size);
    if doubts.is_empty()
        && let Some(viscous) = falls
    {
        doubts.push(Doubt::new(Column::Torque, Misread::NegativeFriction, viscous.value * speed));
    }
    if !has_doubt
        && let (Some(weight), Some(angle), Some(plain)) = (of(Identified::Gravity), of(Identified::GravityAngle), plain)
        && plain.weight_nm != 0.0
        && weight.is_known()
    {
        let own = if plain.weight_nm < 0.0 { plain.angle_rad + PI } else { plain.angle_rad };
        let between = (angle.value - own + PI).rem_euclid(2.0 * PI) - PI;
        // A position of the other sign mirrors the angle at the vertical.
        let mirrored = (angle.value + own).rem_euclid(2.0 * PI) - PI;
        let is_mirrored = mirrored.abs() < MIRRORED + angle.half_width && between.abs() - angle.half_width > APART;
        if between.abs() - angle.half_width > OPPOSITE || is_mirrored {
            doubts.push(Doubt::new(Column::Position, Misread::GravityOpposite, between));
        }
    }
    // The angle of a weight shows the side better; a zero of the torque may have any sign.
    let hangs = plain.as_ref().is_some_and(|plain| plain.weight_nm != 0.0);
    let is_opposite = |share: &Share| share.value + share.half_width < -SAME && share.value > -1.0 / SAME;
    let is_zero = |share: &Share| {
        let deviation =
            of(Identified::External).map_or(f64::INFINITY, |each| (each.value * (1.0 - share.value.recip())).abs());
        found.zero.is_some_and(|zero| deviation < zero.most_nm())
    };
    if doubts.is_empty()
        && !hangs
        && shares.constant.as_ref().is_some_and(|share| is_opposite(share) && !is_zero(share))
    {
        doubts.push(Doubt::new(Column::Position, Misread::GravityOpposite, PI));
    }
    // Without a stated torque that depends on the direction, only the motion shows it.
    let depends = |of_one: Identified| of(of_one).is_some_and(|each| each.is_known());
    let is_stated = shares.constant.is_some() || plain.as_ref().is_none_or(|plain| plain.weight_nm != 0.0);
    if doubts.is_empty()
        && direction == Some(-1.0)
        && !is_stated
        && (depends(Identified::External) || depends(Identified::Gravity))
    {
        doubts.push(Doubt::new(Column::Position, Misread::Reversed, -1.0));
    }
    if !has_doubt && let (Some(constant), Some(tabulated)) = (of(Identified::TorqueConstant), &tabulated) {
        let Share { value, half_width: half } =
            tabulated.relative(Share { value: constant.value, half_width: constant.half_width });
        let least = 0.02 * mean(|window| window.current.abs());
        if value < 0.0 {
            doubts.push(Doubt::new(Column::Current, Misread::Reversed, value));
        } else if let Some((misread, by_convention)) = of_constant(value, half) {
            doubts.push(Doubt { column: Column::Current, misread, value, by_convention });
        } else if let Some(value) = friction(Identified::StartingCurrent, Identified::CurrentConstant, least) {
            doubts.push(Doubt::new(Column::Current, Misread::NegativeFriction, value));
        }
    }
    found.doubts = doubts;
    if found.doubts.is_empty() {
        unscaled(tabulated.as_ref(), found);
        for pair in
            [[Identified::Coulomb, Identified::Viscous], [Identified::StartingCurrent, Identified::CurrentConstant]]
        {
            unseparated(pair, speed, found);
        }
    }
}

/// Leaves the values of the motor open if the run does not show the scale of the current by its torque constant.
fn unscaled(tabulated: Option<&Tabulated>, found: &mut Identification) {
    let Some(tabulated) = tabulated else { return };
    let constant = found.estimates.iter().find(|each| each.of == Identified::TorqueConstant);
    let is_sure = constant.is_some_and(|each| {
        scale::excludes_root_two(tabulated.relative(Share { value: each.value, half_width: each.half_width }))
    });
    let of_current = [Identified::TorqueConstant, Identified::StartingCurrent, Identified::CurrentConstant];
    let open: Vec<Identified> =
        found.estimates.iter().map(|each| each.of).filter(|of| of_current.contains(of)).collect();
    if !is_sure {
        found.estimates.retain(|each| !of_current.contains(&each.of));
        found.open.extend(open.into_iter().map(|of| (of, Open::Scale)));
    }
}

/// Leaves a part of a friction open that is negative beyond its interval, and the other one if it would leave its interval were the
/// first zero: then the run shows their sum at the mean speed alone.
fn unseparated([start, with_speed]: [Identified; 2], speed_rad_s: f64, found: &mut Identification) {
    let of = |of| found.estimates.iter().find(|each| each.of == of).copied();
    let parts = [(start, with_speed, speed_rad_s.recip()), (with_speed, start, speed_rad_s)];
    let mut open = Vec::new();
    for (own, other, factor) in parts {
        let Some(own) = of(own).filter(|own| own.value < -own.half_width) else { continue };
        open.push(own.of);
        let is_tied = |other: &Estimate| (own.value * factor).abs() > other.half_width;
        open.extend(of(other).filter(is_tied).map(|other| other.of));
    }
    open.sort_unstable();
    open.dedup();
    found.estimates.retain(|each| !open.contains(&each.of));
    found.open.extend(open.into_iter().map(|of| (of, Open::NotSeparated)));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A part of a friction that is negative beyond its interval opens itself, and the other one only if that rests on it.
    #[test]
    fn a_negative_part_of_a_friction_opens_what_is_tied_to_it() {
        use Identified::{Coulomb, Viscous};
        // T_c and b with their half intervals at a mean speed of 2 rad/s, and what stays known.
        let cases = [
            ([3.0, 0.01], [-1e-4, 5e-5], &[Coulomb][..]),
            ([3.0, 0.01], [-0.004, 0.001], &[Coulomb]),
            ([3.0, 0.01], [-0.05, 0.01], &[]),
            ([3.0, 0.01], [-0.05, 0.06], &[Coulomb, Viscous]),
            ([-0.02, 0.01], [1.5, 0.02], &[Viscous]),
            ([-0.5, 0.1], [1.5, 0.02], &[]),
            ([-0.5, 0.1], [-1.5, 0.02], &[]),
        ];
        for (coulomb, viscous, known) in cases {
            let estimate = |of, [value, half_width]: [f64; 2]| Estimate { of, value, half_width };
            let estimates = vec![estimate(Coulomb, coulomb), estimate(Viscous, viscous)];
            let mut found = Identification { estimates, ..Identification::default() };
            unseparated([Coulomb, Viscous], 2.0, &mut found);
            let stay: Vec<Identified> = found.estimates.iter().map(|each| each.of).collect();
            assert_eq!(stay, known, "{coulomb:?} {viscous:?}");
            assert_eq!(found.open.len() + stay.len(), 2, "{coulomb:?} {viscous:?}: {:?}", found.open);
        }
    }
}
