//! Checks of current and voltage.

mod of_curve;

use crate::axis::Axis;
use crate::check::{CheckId, Verdict};
use crate::comparison::{Asking, Comparison, cite};
use crate::electrics::Electrics;
use crate::list::{Case, Outcome};
use crate::notes::{Note, Notes};
use crate::supply::Edge;
use crate::workings;
use actuator::{
    CurvePoint, FrictionAt, HeatModel, LossMeans, Losses, MotorCurrent, MotorVoltage, OperatingPoint, Parameters,
    Settled,
};
use derivation::{Finding, Workings};
use numeric::at_most;
use of_curve::{OfCurve, within_the_curve};
use provenance::{Datum, Grade, Missing, Source, Sourced};
use quantities::unit::{
    AMPERE, AMPERE_PER_REVOLUTION_PER_MINUTE, DEGREE_CELSIUS, NEWTON_METRE_PER_AMPERE, ONE, REVOLUTION_PER_MINUTE, VOLT,
};
use quantities::{AngularVelocity, ElectricCurrent, Measure, Power, Time, Torque};
use std::cell::OnceCell;
use trace::{Convex, Extent, Form, Node, Sought};

/// Weights that select ω from (α, T_L, σ, ω).
pub(crate) const SPEED: [f64; 4] = [0.0, 0.0, 0.0, 1.0];

/// Motor current at every instant in the two limiting states of the gear: at the ambient temperature when the cycle
/// begins, and at the temperature that results from the losses of the repeated cycle.
///
/// I = T/k_Tout + σ (I_s + K |n|), a weighted sum of (α, T_L, σ, ω) in either state
pub(crate) struct Currents<'e> {
    pub(crate) inertia: f64,
    motor: &'e MotorCurrent,
    /// Friction at the ambient temperature.
    cold: &'e FrictionAt,
    /// Friction in the settled cycle.
    pub(crate) warm: FrictionAt,
    /// Heat model and its settled state; without one the warm state is the warmest for which the manual states values.
    heat: Result<(&'e HeatModel, Settled), Missing>,
    pub(crate) grade: Grade,
    /// Remark on the friction, and the errata of the inputs.
    pub(crate) notes: Notes,
    /// Instant of the largest current, found on first use.
    peak: OnceCell<Node>,
}

impl<'e> Currents<'e> {
    pub(crate) fn of(axis: &Axis, actuator: &Parameters, electrics: &'e Electrics) -> Result<Self, Missing> {
        let inertia = actuator.inertia_out.require("J_out")?;
        let law = electrics.current.as_ref().map_err(|missing| *missing)?;
        let (own, constant) = (inertia.value.si(), law.torque_constant);
        let heat = electrics.heat.as_ref().map_err(|missing| *missing).map(|model| {
            let further = coil_loss(axis, actuator);
            let ambient = axis.ambient.unwrap_or_else(|| model.ambient_reference());
            let settled = model.settle(&loss_means(axis, [own / constant, 1.0 / constant, 0.0, 0.0]), further, ambient);
            (model, settled)
        });
        let settled = heat.as_ref().ok().map(|(_, settled)| settled);
        let band =
            Note::FrictionTemperatures { cold: law.cold.temperature, settled: settled.map(|settled| settled.housing) };
        let mut notes = match law.cold_band {
            Some((low, high)) => Notes::from([band, Note::FrictionExtrapolated { low, high }]),
            None => band.into(),
        };
        cite(&mut notes, inertia.errata);
        cite(&mut notes, law.errata);
        Ok(Self {
            inertia: own,
            motor: &law.motor,
            cold: &law.cold,
            warm: settled.map_or(law.warmest, |settled| settled.friction),
            heat,
            grade: Grade::Computed.worst(inertia.grade).worst(law.grade),
            notes,
            peak: OnceCell::new(),
        })
    }

    /// Returns the heat model with the settled state of the cycle.
    pub(crate) fn heat(&self) -> Result<(&HeatModel, &Settled), Missing> {
        match &self.heat {
            Ok((model, settled)) => Ok((model, settled)),
            Err(missing) => Err(*missing),
        }
    }

    /// Returns the friction of a gear at the ambient temperature.
    pub(crate) const fn cold(&self) -> &FrictionAt {
        self.cold
    }

    /// Returns the current as a weighted sum of (α, T_L, σ, ω) for a friction.
    fn weights(&self, friction: &FrictionAt) -> [f64; 4] {
        self.motor.weights(self.inertia, friction)
    }

    /// Returns the current in the settled cycle as a weighted sum of (α, T_L, σ, ω).
    pub(crate) fn settled_weights(&self) -> [f64; 4] {
        self.weights(&self.warm)
    }

    /// Returns the operating point at an instant, with the torque of the own inertia.
    pub(crate) fn point(&self, node: &Node) -> OperatingPoint {
        OperatingPoint {
            torque_nm: self.inertia * node.acceleration_rad_s2 + node.load_nm,
            speed_rad_s: node.speed_rad_s,
            direction: node.direction,
        }
    }

    /// Returns the current in the settled cycle at an instant \[A\].
    pub(crate) fn at(&self, node: &Node) -> f64 {
        self.in_state(node, &self.warm)
    }

    fn in_state(&self, node: &Node, friction: &FrictionAt) -> f64 {
        self.motor.at(&self.point(node), friction)
    }

    /// Returns the friction of the state with the larger current at an instant.
    pub(crate) fn larger(&self, node: &Node) -> &FrictionAt {
        let torque = self.point(node).torque_nm;
        // Friction helps while braking: less friction requires more current.
        let driving = self.in_state(node, self.cold).abs() >= self.in_state(node, &self.warm).abs();
        if driving || torque == 0.0 { self.cold } else { &self.warm }
    }

    /// Returns the larger current of the two states at an instant, signed \[A\].
    pub(crate) fn extreme(&self, node: &Node) -> f64 {
        self.in_state(node, self.larger(node))
    }

    /// Returns the instant of the largest current in either state.
    pub(crate) fn peak(&self, axis: &Axis) -> Node {
        let bound = |extent: &Extent| self.bound(extent);
        *self.peak.get_or_init(|| axis.trace.largest(&Convex(bound, |node: &Node| self.extreme(node).abs())).1)
    }

    /// Returns the largest magnitude of the current over the cycle with the cold gear and in the settled cycle \[A\], each with
    /// its instant.
    pub(crate) fn peaks(&self, axis: &Axis) -> [(f64, Node); 2] {
        [self.cold, &self.warm].map(|friction| {
            let bound = |extent: &Extent| {
                let (low, high) = extent.range(self.weights(friction));
                high.max(-low)
            };
            axis.trace.largest(&Convex(bound, |node: &Node| self.in_state(node, friction).abs()))
        })
    }

    /// Returns the currents at an instant with the cold gear and in the settled cycle \[A\].
    pub(crate) fn in_both_states(&self, node: &Node) -> [f64; 2] {
        [self.cold, &self.warm].map(|friction| self.in_state(node, friction))
    }

    /// Returns both losses at an instant of the settled cycle, if there is a heat model.
    pub(crate) fn losses(&self, node: &Node) -> Option<Losses> {
        let (model, _) = self.heat().ok()?;
        Some(model.losses().at(&self.point(node), self.at(node), &self.warm))
    }

    /// Returns the friction loss as a form, for a voltage per friction current and output speed: k i (I_NLS σ + K ω) ω.
    pub(crate) fn friction_form(&self, friction_vs: f64) -> Form {
        Form::product([0.0, 0.0, self.warm.starting.si(), self.warm.constant.si()], SPEED).scale(friction_vs)
    }

    /// Returns bounds of the currents of a block in either state.
    fn range(&self, extent: &Extent) -> (f64, f64) {
        let of = |friction| extent.range(self.weights(friction));
        let (cold, warm) = (of(self.cold), of(&self.warm));
        (cold.0.min(warm.0), cold.1.max(warm.1))
    }

    /// Returns an upper bound of the current of a block of nodes in either state. Friction has the sign of the torque:
    /// a driving load reduces the current.
    pub(crate) fn bound(&self, extent: &Extent) -> f64 {
        let (low, high) = self.range(extent);
        high.max(-low)
    }

    /// Records the derivation of the current at an instant in one of the states; the result is `I`.
    pub(crate) fn explain(
        &self,
        node: &Node,
        friction: &FrictionAt,
        (axis, actuator): (&Axis, &Parameters),
        work: &mut Workings,
    ) {
        if !work.is_on() {
            return;
        }
        self.explain_point(node, (axis, actuator), work);
        let what = if friction == self.cold { Finding::GearCold } else { Finding::GearSettled };
        self.explain_state("I", node, (friction, what), work);
    }

    /// Records the derivation of the largest current `I_peak` at an instant: that of the cold gear beside that of the settled
    /// cycle, of which the larger one governs; that of the settled cycle at another instant, if it is decisive there.
    pub(crate) fn explain_peak(
        &self,
        node: &Node,
        settled: Option<&Node>,
        of: (&Axis, &Parameters),
        work: &mut Workings,
    ) {
        if !work.is_on() {
            return;
        }
        let source = Source::Model { name: "current" };
        let current = self.extreme(node).abs();
        let [cold, warm] = self.in_both_states(node).map(f64::abs);
        // Without torque the friction of the cold gear is the larger one by its definition.
        if cold.max(warm) > current {
            self.explain(node, self.larger(node), of, work);
            work.formula("I_peak", &AMPERE, current, "abs(I)", &source);
            return;
        }
        let state = if self.heat.is_ok() { Finding::StateSettled } else { Finding::StateWarmest };
        // A larger current than that of the check cannot decide it: with a curve the limits differ from instant to instant.
        let elsewhere = settled.filter(|other| self.at(other).abs() <= current);
        if let Some(other) = elsewhere {
            self.explain_point(other, of, work);
            self.explain_state("I_warm", other, (&self.warm, state), work);
        }
        self.explain_point(node, of, work);
        self.explain_state("I_cold", node, (self.cold, Finding::StateCold), work);
        if elsewhere.is_none() {
            self.explain_state("I_warm", node, (&self.warm, state), work);
        }
        work.formula("I_peak", &AMPERE, current, "max(abs(I_cold), abs(I_warm))", &source);
    }

    /// Records torque, torque constant, speed and direction at an instant.
    fn explain_point(&self, node: &Node, (axis, actuator): (&Axis, &Parameters), work: &mut Workings) {
        workings::torque_at(axis, node, actuator, work);
        work.known("k_Tout", &NEWTON_METRE_PER_AMPERE, &actuator.torque_constant_out);
        work.found("n", &REVOLUTION_PER_MINUTE, node.speed_rad_s, Finding::SpeedAt, &workings::DEMAND, Grade::Computed);
        work.found("sigma", &ONE, node.direction, Finding::DirectionAt, &workings::DEMAND, Grade::Computed);
    }

    /// Records the friction of a state and the current in it.
    fn explain_state(
        &self,
        symbol: &'static str,
        node: &Node,
        (friction, what): (&FrictionAt, Finding),
        work: &mut Workings,
    ) {
        let source = Source::Model { name: "current" };
        explain_friction_of(friction, what, work);
        let text = "T/k_Tout + sigma*(I_s + K*abs(n))";
        work.formula(symbol, &AMPERE, self.in_state(node, friction), text, &source);
    }

    /// Records the derivation of the current `I_perm` of the continuous torque `T_cont` at the mean speed `n_av`, with the
    /// friction of the settled cycle.
    pub(crate) fn explain_permitted(
        &self,
        (torque, speed): (Torque, AngularVelocity),
        (model, actuator): (&HeatModel, &Parameters),
        work: &mut Workings,
    ) {
        work.known("k_Tout", &NEWTON_METRE_PER_AMPERE, &actuator.torque_constant_out);
        explain_friction_of(&self.warm, Finding::StateSettled, work);
        let current = model.current(torque, speed, &self.warm).si();
        let source = Source::Model { name: "current" };
        work.estimate("I_perm", &AMPERE, current, "T_cont/k_Tout + I_s + K*abs(n_av)", &source);
    }
}

/// Records the friction current of a state of the gear: temperature, counted starting current, and viscous constant.
fn explain_friction_of(friction: &FrictionAt, state: Finding, work: &mut Workings) {
    let source = Source::Model { name: "current" };
    work.found("theta_g", &DEGREE_CELSIUS, friction.temperature.si(), state, &source, Grade::Estimated);
    let what = Finding::LawOfFriction;
    work.found("I_s", &AMPERE, friction.counted.si(), what, &source, Grade::Estimated);
    let constant = friction.constant.si();
    work.found("K", &AMPERE_PER_REVOLUTION_PER_MINUTE, constant, what, &source, Grade::Estimated);
}

/// Returns the mean heat of the brake's coil; zero without a brake or if its current is unknown.
pub(crate) fn coil_loss(axis: &Axis, actuator: &Parameters) -> Power {
    match (actuator.brake.voltage.known(), actuator.brake.holding_current.known()) {
        (Some(voltage), Some(current)) => actuator::coil_power(voltage.value, current.value, axis.brake_open_share()),
        _ => Power::from_si(0.0),
    }
}

/// Returns the means of the products of torque current, direction and speed over the cycle.
fn loss_means(axis: &Axis, torque_current: [f64; 4]) -> LossMeans {
    let duration = axis.moments.duration.si();
    let gram = axis.trace.gram();
    let direction = [0.0, 0.0, 1.0, 0.0];
    let mean = |a, b| gram.product(a, b) / duration;
    LossMeans {
        torque_current_square: gram.square(torque_current) / duration,
        torque_current_direction: mean(torque_current, direction),
        torque_current_speed: mean(torque_current, SPEED),
        moving: gram.moving() / duration,
        speed_magnitude: gram.travelled() / duration,
        speed_square: gram.square(SPEED) / duration,
    }
}

/// The motor's terminal voltage \[V\], the larger of both states: while braking the larger current does not imply the
/// larger voltage, because it lowers the voltage needed against the induced one.
struct Terminal<'a> {
    motor: &'a MotorVoltage,
    currents: &'a Currents<'a>,
}

impl Terminal<'_> {
    fn at(&self, node: &Node, friction: &FrictionAt) -> f64 {
        let current = ElectricCurrent::from_si(self.currents.in_state(node, friction));
        self.motor.at(AngularVelocity::from_si(node.speed_rad_s), current).si()
    }

    /// Returns the larger value of the cold-gear and the warm-gear state.
    #[inline]
    fn larger(&self, of: impl Fn(&FrictionAt) -> f64) -> f64 {
        of(self.currents.cold).max(of(&self.currents.warm))
    }
}

impl Sought for Terminal<'_> {
    /// Bounds the voltage at the corners: it is convex in current and in speed separately, so that it is largest there.
    fn bound(&self, extent: &Extent) -> f64 {
        let ((low, high), (back, forth)) = (self.currents.range(extent), extent.speeds_rad_s);
        let at = |speed: f64, current: f64| {
            self.motor.at(AngularVelocity::from_si(speed), ElectricCurrent::from_si(current)).si()
        };
        at(back, low).max(at(back, high)).max(at(forth, low)).max(at(forth, high))
    }

    fn value(&self, node: &Node) -> f64 {
        self.larger(|friction| self.at(node, friction))
    }

    fn on_line(&self, a: &Node, b: &Node) -> f64 {
        self.larger(|friction| {
            let end = |node: &Node| {
                let current = ElectricCurrent::from_si(self.currents.in_state(node, friction));
                (AngularVelocity::from_si(node.speed_rad_s), current)
            };
            self.motor.bound_on_line([end(a), end(b)]).si()
        })
    }
}

/// Number of corners above which a bound uses only the least permissible current.
const FEW: usize = 8;

/// Ratio of |I| to the permissible current at an instant: the limit of the manual or, with a published curve, the
/// current of its torque at that speed if that is larger.
///
/// While the direction is constant, |I| is convex along a straight line and the current of a straight piece of the
/// curve is linear: the ratio is largest at an end of the piece.
struct Overcurrent<'a> {
    currents: &'a Currents<'a>,
    printed: f64,
    curve: Option<OfCurve<'a>>,
    /// States to be checked.
    states: &'a [&'a FrictionAt],
    /// Speeds at which the limit has a corner.
    corners: Vec<f64>,
}

impl<'a> Overcurrent<'a> {
    fn of(currents: &'a Currents<'a>, printed: f64, curve: Option<OfCurve<'a>>, states: &'a [&'a FrictionAt]) -> Self {
        let corners = curve.map(|of| of.corners(currents.motor, printed, states)).unwrap_or_default();
        Self { currents, printed, curve, states, corners }
    }

    /// Returns the permissible current at the speed of an instant \[A\].
    fn permitted(&self, node: &Node, friction: &FrictionAt) -> f64 {
        self.permitted_at(node.speed_rad_s, friction)
    }

    fn permitted_at(&self, speed: f64, friction: &FrictionAt) -> f64 {
        let Some(of) = &self.curve else { return self.printed };
        let speed = AngularVelocity::from_si(speed);
        let (torque, running) = (of.curve.at(speed).si(), friction.current(speed).si());
        self.printed.max(of.current(self.currents.motor, torque, running))
    }

    /// Returns the least permissible current at any speed between two, in either state \[A\].
    fn least(&self, of: &OfCurve<'_>, slower: f64, faster: f64) -> f64 {
        let [slower, faster] = [slower, faster].map(AngularVelocity::from_si);
        let torque = of.curve.least_between(slower, faster).si();
        let running = |friction: &&FrictionAt| friction.current(slower).si().min(friction.current(faster).si());
        let running = self.states.iter().map(running).fold(f64::INFINITY, f64::min);
        self.printed.max(of.current(self.currents.motor, torque, running))
    }

    /// Returns the state with the larger value at an instant.
    fn state(&self, node: &Node) -> &'a FrictionAt {
        match *self.states {
            [only] => only,
            _ => self.currents.larger(node),
        }
    }

    fn ratio(&self, node: &Node, friction: &FrictionAt) -> f64 {
        self.currents.in_state(node, friction).abs() / self.permitted(node, friction)
    }
}

impl Sought for Overcurrent<'_> {
    /// Returns the current of the largest torque over the permissible one, both linear in |ω| between the corners:
    /// largest at a corner or at the slowest or the fastest instant.
    fn bound(&self, extent: &Extent) -> f64 {
        let (back, forth) = extent.speeds_rad_s;
        let slowest = back.max(-forth).max(0.0);
        let fastest = extent.speed_rad_s;
        let first = self.corners.partition_point(|corner| *corner <= slowest);
        let end = self.corners.partition_point(|corner| *corner < fastest).max(first);
        let within = self.corners.get(first..end).unwrap_or_default();
        // Of many corners the least permissible current at any of them is used.
        let (within, least) = match &self.curve {
            Some(curve) if within.len() > FEW => (&[][..], Some(self.least(curve, slowest, fastest))),
            _ => (within, None),
        };
        let speeds = || within.iter().copied().chain([slowest, fastest]);
        let of = |friction: &&FrictionAt| {
            let [acceleration, load, direction, speed] = self.currents.weights(friction);
            let (low, high) = extent.range([acceleration, load, direction, 0.0]);
            let ratio = |n: f64| {
                let forwards = if forth > 0.0 { (high + speed * n).max(-low - speed * n) } else { 0.0 };
                let backwards = if back < 0.0 { (high - speed * n).max(speed * n - low) } else { 0.0 };
                let still = if slowest == 0.0 { high.max(-low) } else { 0.0 };
                forwards.max(backwards).max(still) / least.unwrap_or_else(|| self.permitted_at(n, friction))
            };
            speeds().map(ratio).fold(0.0, f64::max)
        };
        self.states.iter().map(of).fold(0.0, f64::max)
    }

    fn value(&self, node: &Node) -> f64 {
        self.ratio(node, self.state(node))
    }

    fn on_line(&self, a: &Node, b: &Node) -> f64 {
        let ends = |friction: &&FrictionAt| self.ratio(a, friction).max(self.ratio(b, friction));
        self.states.iter().map(ends).fold(0.0, f64::max)
    }

    fn corners(&self) -> &[f64] {
        &self.corners
    }
}

/// Checks U ≤ (U_DC/√2) · reserve: the motor's terminal voltage at every instant of the cycle, winding hot.
pub(crate) fn voltage(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let Case { axis, actuator, electrics, currents, .. } = *case;
    let id = CheckId::Voltage;
    let supply = axis.supply.ok_or(Missing { symbol: "requirements.supply" })?;
    let motor = electrics.voltage.as_ref().map_err(|missing| *missing)?;
    let currents = currents.map_err(|missing| *missing)?;
    let terminal = Terminal { motor, currents };
    let (worst, at) = axis.trace.largest(&terminal);
    let (cold, warm) = (currents.cold, &currents.warm);
    let friction = if terminal.at(&at, cold) >= terminal.at(&at, warm) { cold } else { warm };
    currents.explain(&at, friction, (axis, actuator), work);
    let current = ElectricCurrent::from_si(currents.in_state(&at, friction));
    motor.explain(actuator, AngularVelocity::from_si(at.speed_rad_s), current, work);
    let model = Source::Model { name: "voltage" };
    let limit = supply.terminal_voltage().si();
    if work.is_on() {
        work.formula("U", &VOLT, worst, "U_LL", &model);
        work.value("U");
        supply.explain(Edge::Low, work);
        work.stated("m", &ONE, supply.reserve, "requirements.modulation_reserve");
        work.formula("U_M", &VOLT, limit, "U_DC/sqrt(2)*m", &model);
        work.limit("U_M");
    }
    Ok(Comparison {
        id,
        unit: &VOLT,
        value: worst,
        value_source: Source::Model { name: "voltage" },
        at: Some(Time::from_si(at.time_s)),
        limit,
        limit_source: &supply.source(),
        grade: motor.grade.worst(currents.grade).worst(supply.grade()),
        errata: &[],
        notes: currents.notes.clone(),
    }
    .answer(Verdict::Fail))
}

/// Checks I_peak ≤ I_max.
///
/// Both states are checked: a current that exceeds I_max with the cold gear only is advice, because the drive limits
/// the current until the gear is warm. With a published short-time curve, a current above I_max up to that of the curve, of
/// T_max and of I_E is advice: both are statements of the manufacturer, and by the estimated friction they contradict each
/// other. Above it the check fails. Of a curve or an I_max of the project the lower limit governs.
pub(crate) fn peak_current(case: &Case<'_>, work: &mut Workings) -> Outcome {
    current_check(case, (CheckId::PeakCurrent, "I_max", case.actuator.current_max.require("I_max")?), work)
}

/// Checks I_peak ≤ I_E, at which demagnetisation begins, in both states.
pub(crate) fn demagnetisation(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let limit = case.actuator.current_demagnetisation.require("I_E")?;
    current_check(case, (CheckId::Demagnetisation, "I_E", limit), work)
}

fn current_check(
    case: &Case<'_>,
    (id, symbol, limit): (CheckId, &'static str, &Sourced<ElectricCurrent>),
    work: &mut Workings,
) -> Outcome {
    let Case { axis, actuator, currents, .. } = *case;
    let currents = currents.map_err(|missing| *missing)?;
    let is_of_peak = id == CheckId::PeakCurrent;
    let terminal = axis.terminal_voltage();
    let curve = actuator.curve_above_current_max(terminal).filter(|_| is_of_peak);
    let printed = limit.value.si();
    let si = |datum: &Datum<ElectricCurrent>| datum.known().map_or(f64::INFINITY, |known| known.value.si());
    let published = curve.map(|curve| OfCurve {
        curve: &curve.value,
        torque_max: actuator.torque_max.known().map_or(f64::INFINITY, |known| known.value.si()),
        current_most: si(&actuator.current_demagnetisation),
    });
    let both = [currents.cold, &currents.warm];
    let over = Overcurrent::of(currents, printed, published, &both);
    let node = if curve.is_some() { axis.trace.largest(&over).1 } else { currents.peak(axis) };
    let (current, most) = (currents.extreme(&node).abs(), over.permitted(&node, currents.larger(&node)));
    if curve.is_some() && at_most(current, most) {
        return Ok(within_the_curve(case, currents, (limit, current / most), work));
    }
    // An excess in the settled cycle does not disappear by warming up.
    let settled = || axis.trace.largest(&Overcurrent::of(currents, printed, published, &[&currents.warm]));
    // Mostly the instant of the largest current decides; otherwise the others are evaluated.
    let is_within_here = || at_most(over.ratio(&node, &currents.warm), 1.0);
    let may_be_cold_only = || is_within_here() && at_most(settled().0, 1.0);
    let by_cold_only = is_of_peak && !at_most(current, most) && currents.heat.is_ok() && may_be_cold_only();
    let source = Source::Model { name: "current" };
    if work.is_on() {
        let elsewhere = (!at_most(current, most) && is_within_here()).then(settled);
        let elsewhere = elsewhere.filter(|(ratio, _)| !at_most(*ratio, 1.0)).map(|(_, node)| node);
        currents.explain_peak(&node, elsewhere.as_ref(), (axis, actuator), work);
    }
    work.value("I_peak");
    work.given(symbol, &AMPERE, limit);
    let limit_source = match curve.filter(|_| most > printed) {
        Some(curve) => {
            let what = Finding::CurrentOfCurve;
            work.found("I_perm", &AMPERE, most, what, &curve.source, curve.grade);
            work.limit("I_perm");
            &curve.source
        }
        None => {
            work.limit(symbol);
            &limit.source
        }
    };
    let mut notes = currents.notes.clone();
    if by_cold_only {
        notes.push(Note::UntilWarm);
    }
    if curve.is_some() {
        // The limits differ from instant to instant.
        let largest = currents.peak(axis);
        let most = currents.extreme(&largest).abs();
        if !at_most(most, current) {
            notes.push(Note::LargestCurrentElsewhere {
                current: ElectricCurrent::from_si(most),
                time: Time::from_si(largest.time_s),
            });
        }
    } else if is_of_peak && let Some(own) = actuator.at_voltage(&actuator.short_time_curve, terminal) {
        // A curve of the project may contradict I_max.
        let torque_max = actuator.torque_max.known().map_or(f64::INFINITY, |known| known.value.si());
        let of_curve = |point: &CurvePoint| {
            let torque = point.torque.si().min(torque_max);
            currents.motor.of_torque(torque) + currents.warm.current(point.speed).si()
        };
        let most = own.value.points().iter().map(of_curve).fold(0.0, f64::max);
        if !at_most(most, printed) {
            notes.push(Note::CurveAboveLargestCurrent { current: ElectricCurrent::from_si(most) });
        }
    }
    Ok(Comparison {
        id,
        unit: &AMPERE,
        value: current,
        value_source: source,
        at: Some(Time::from_si(node.time_s)),
        limit: most,
        limit_source,
        grade: currents.grade.worst(limit.grade),
        errata: limit.errata,
        notes,
    }
    .answer(if by_cold_only { Verdict::Advice } else { Verdict::Fail }))
}
