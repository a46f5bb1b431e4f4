//! A run: control, plant, DC link and supervision, period by period.

mod commanded;
mod driving;
mod reading;
mod sample;
mod start;
mod supervision;
mod worst;

use crate::control::{
    Bounds, CURRENT_RATE_HZ, Control, Demand, Gains, Measured, POSITION_EVERY, POSITION_PERIOD_S, SPEED_EVERY,
};
use crate::drive::{BrakeState, Limits, Phase};
use crate::gear::Anchor;
use crate::link::{Link, LinkModel};
use crate::load::{LoadModel, Local};
use crate::machine::Machine;
use crate::parameters::Parameter;
use crate::plant::{Energies, Given, Plant, Sliding, State, Stop, Variables};
use crate::scenario::{Event, EventKind, Part, ScenarioId};
use crate::setpoint::{Course, SetPoint};
use crate::setup::{Fault, STEP_MOST, SUBSTEPS_MOST, Setup, Supply};
use crate::summary::{Gathered, Summary};
use actuator::{Losses, Temperatures};
use numeric::Random;
use quantities::{Measure, ThermodynamicTemperature};
use std::f64::consts::{SQRT_2, TAU};

use commanded::Commanded;
pub use commanded::Reading;
use reading::Encoder;
pub use sample::Sample;
pub use worst::{
    EndOverrun, EventEffect, INSTANTS_MOST, MotionDirection, WorstInstant, WorstOf, search_periods, worst_instant,
};

/// Duration of a period of the current loop \[s\].
pub(crate) const PERIOD_S: f64 = 1.0 / CURRENT_RATE_HZ;

/// Periods between two updates of temperatures and supervision: 1 ms.
const SLOW_EVERY: u64 = 16;

/// Duration of the run after the end of the motion \[s\].
const AFTER_S: f64 = 0.5;

/// Further duration of a run whose axis has not come to rest after an event, at most \[s\].
const LONGER_S: f64 = 2.0;

/// Periods by which such a run continues at once: 10 ms.
const LONGER_BY: u64 = 160;

/// Share to which the supply drops, and the duration of the drop \[s\].
const SAG: (f64, f64) = (0.6, 0.2);

/// A run of the simulation.
#[derive(Clone, Debug)]
pub struct Twin<'a> {
    setup: Setup<'a>,
    machine: Machine,
    plant: Plant,
    pub(crate) state: State,
    load: LoadModel<'a>,
    local: Local,
    anchor: Anchor,
    stop: Option<Stop>,
    course: Course<'a>,
    point: SetPoint,
    /// Motor angle minus setpoint at the start \[rad\].
    offset_rad: f64,
    control: Control,
    limits: Limits,
    phase: Phase,
    brake: BrakeState,
    link_model: LinkModel,
    pub(crate) link: Link,
    /// DC link at the highest voltage of the supply, under equal power; `None` if the supply has a single voltage.
    link_high: Option<(LinkModel, Link)>,
    supply_share: f64,
    temperatures: Temperatures,
    sensor_k: f64,
    ptc_k: f64,
    overload: f64,
    encoder: Encoder,
    random: Random,
    voltage: [f64; 2],
    tick: u64,
    /// Temperatures and I²t switch the drive off.
    heat_trips: bool,
    /// Periods of the run-up before the time 0; zero after it.
    run_up: u64,
    end_tick: u64,
    /// Latest end of a run whose axis has not yet come to rest.
    latest_tick: u64,
    happens_s: Option<f64>,
    happened: bool,
    slow: Slow,
    gathered: Gathered,
    events: Vec<Event>,
    stored_at_start_j: f64,
    /// Heat in the coil of the open brake so far \[J\].
    coil_j: f64,
    ambient_k: f64,
    /// Commands of a caller; `None` if the run follows the motion of the project.
    commanded: Option<Commanded>,
}

/// Sums for the next update of the temperatures.
#[derive(Clone, Copy, Debug, Default)]
struct Slow {
    copper_j: f64,
    heat_j: f64,
    square_a2_s: f64,
}

impl<'a> Twin<'a> {
    /// Creates a run in its initial state.
    ///
    /// # Errors
    /// [`Fault`]: data are missing or contradictory, or the step is too long.
    pub fn new(setup: &Setup<'a>) -> Result<Self, Fault> {
        Self::started(setup, true)
    }

    /// Creates a run whose heat trips nothing, for the mean losses of a repeated cycle at any temperature.
    pub(crate) fn untripped(setup: &Setup<'a>) -> Result<Self, Fault> {
        Self::started(setup, false)
    }

    fn started(setup: &Setup<'a>, heat_trips: bool) -> Result<Self, Fault> {
        let mut twin = Self::build(*setup, None)?;
        twin.heat_trips = heat_trips;
        // A brake that does not open holds the axis from the beginning.
        if twin.course.begins_in_motion && setup.scenario.id != ScenarioId::BrakeStuck {
            twin.run_up();
        }
        if setup.scenario.id == ScenarioId::BatteryLoss {
            twin.lose_turns();
        }
        Ok(twin)
    }

    fn build(setup: Setup<'a>, commanded: Option<Commanded>) -> Result<Self, Fault> {
        if setup.substeps == 0 || setup.substeps > SUBSTEPS_MOST {
            return Err(Fault::OutOfRange("substeps"));
        }
        let Supply { least_v, nominal_v, most_v } = setup.supply;
        for (key, value) in [
            ("supply", least_v),
            ("supply", nominal_v),
            ("supply", most_v),
            ("ambient", setup.ambient_k),
            ("modulation", setup.modulation),
        ] {
            if !(value.is_finite() && value > 0.0) {
                return Err(Fault::OutOfRange(key));
            }
        }
        if most_v < least_v {
            return Err(Fault::OutOfRange("supply"));
        }
        if let Some((lower, upper)) = setup.parameters.reversed() {
            return Err(Fault::Above { lower, upper });
        }
        if matches!(setup.mechanism.kind, mechanism::MechanismKind::Joint(_)) {
            return Err(Fault::RecordedTorque);
        }
        let is_wrong = |each: &Parameter| {
            let value = each.value.as_ref().map_or(0.0, |value| value.value);
            !value.is_finite() || (value < 0.0 && !each.has_a_sign())
        };
        if let Some(Parameter { key, .. }) = setup.parameters.list().iter().find(|each| is_wrong(each)) {
            return Err(Fault::OutOfRange(key));
        }
        let machine = Machine::of(setup.parameters, setup.switches, setup.seed)?;
        let cycles_s = setup.motion.duration().si() * f64::from(setup.scenario.cycles.max(1));
        // The limits allow for the rounding of a part that ends with the motion.
        let is_within = |part: &Part| {
            part.from_s >= 0.0 && part.for_s >= PERIOD_S && part.from_s + part.for_s <= cycles_s * (1.0 + 1e-9)
        };
        if !setup.part.as_ref().is_none_or(is_within) {
            return Err(Fault::OutOfRange("part"));
        }
        let course = Course::of(setup.motion, setup.scenario.cycles, setup.part);
        let model = &setup.parameters.model;
        let ambient_k = start::ambient(&setup);
        let scenario = setup.scenario.id;
        if setup.loop_at_output && machine.feedback_out_rad.is_none() {
            return Err(Fault::NoOutputEncoder);
        }
        match scenario {
            ScenarioId::BrakeStuck | ScenarioId::HangingLoad if machine.brake.is_none() => return Err(Fault::NoBrake),
            ScenarioId::BatteryLoss if !setup.parameters.actuator.feedback.buffered_by_battery => {
                return Err(Fault::NoBattery);
            }
            ScenarioId::EncoderFailure | ScenarioId::BatteryLoss => reading::can_fail(&setup)?,
            _ => {}
        }
        let start = course.at(0.0);
        let [position, _, _] = start.state;
        let load = LoadModel::of(setup.mechanism, setup.extras, machine.flange_kgm2, &setup.parameters.load)
            .map_err(Fault::NotOfThisLoad)?;
        let local = load.linearised(start.segment, position, 0.0, 0.0).ok_or(Fault::NoInertia)?;
        if local.inertia_kgm2.is_nan() || local.inertia_kgm2 <= 0.0 {
            return Err(Fault::NoInertia);
        }
        let mut plant = machine.plant;
        let temperatures =
            setup.start_k.filter(|_| !matches!(scenario, ScenarioId::ColdGrease)).unwrap_or([ambient_k; 2]);
        let [winding, housing] = temperatures;
        machine.warm(&mut plant, winding, housing);
        let has_stop = commanded.is_some() || matches!(scenario, ScenarioId::BlockedLoad | ScenarioId::Collision);
        let stop_nm = if has_stop { model.stop_stiffness.value } else { 0.0 };
        let stiff = |substeps: u32| {
            let h = PERIOD_S / f64::from(substeps);
            plant.stiffness(local.inertia_kgm2, stop_nm, machine.speed_max, h)
        };
        if stiff(setup.substeps) > STEP_MOST {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count")]
            let substeps = (stiff(1) / STEP_MOST).ceil().min(f64::from(u32::MAX)) as u32;
            return Err(Fault::StepTooLong { substeps });
        }
        let holding = local.middle_nm;
        let twist = plant.spring.angle(holding);
        // e depends weakly on the angle itself: a few iterations suffice.
        let mut theta = position + twist;
        for _ in 0..6 {
            theta = position + twist + plant.kinematic.map_or(0.0, |error| error.at(theta));
        }
        let closed = start.braked.is_some();
        let brake = BrakeState::new(machine.brake, closed, scenario == ScenarioId::BrakeStuck);
        plant.brake_nm = brake.torque_nm();
        let standard = Gains::standard(
            &plant,
            local.inertia_kgm2,
            plant.spring.stiffness_at(twist),
            setup.switches.delay,
            setup.loop_at_output,
        );
        let gains = setup.gains.unwrap_or(standard);
        let control = Control::at_rest(gains, &plant, setup.switches.delay, theta, holding);
        let resting = brake.closed && start.braked.is_some();
        let pulses = !resting;
        let free = |held: f64| if held > 0.0 { 0.0 } else { 1.0 };
        let mut state = State {
            x: Variables {
                current_d: 0.0,
                current_q: if pulses { control.current_wanted } else { 0.0 },
                motor_rad: theta,
                motor_rad_s: 0.0,
                load_rad: position,
                load_rad_s: 0.0,
            },
            force: [0.0; crate::gear::ELEMENTS],
            sliding: Sliding {
                motor: free(plant.friction_nm + plant.brake_nm + plant.mesh),
                load: free(local.coulomb_nm),
            },
            energies: Energies::default(),
            slipped_rad: 0.0,
            turning: 0.0,
            pull: 0.0,
            gear_nm: holding,
            twist_rad: 0.0,
            acceleration_rad_s2: 0.0,
            pulses,
        };
        plant.place(&mut state);
        let chopper = [model.chopper_off.value, model.chopper_on.value].map(|share| share * most_v);
        let link_model = LinkModel {
            capacity_f: 2.0 * model.link_energy.value / (nominal_v * nominal_v),
            supply_v: least_v,
            supply_ohm: model.supply_resistance.value.max(1e-4),
            brake_ohm: model.brake_resistor.value.max(1e-3),
            chopper_v: chopper,
        };
        let steepest = course.steepest_rad_s2();
        let torque_ramp =
            plant.torque_constant * SQRT_2 * machine.current_max_a / (plant.inertia_kgm2 + local.inertia_kgm2) / 2.0;
        let limits = setup.limits.unwrap_or(Limits {
            following_rad: None,
            link_v: [0.7 * least_v, start::link_most(&setup)],
            ramp_rad_s2: if steepest > 0.0 { steepest.min(torque_ramp) } else { torque_ramp },
            reaction: setup.scenario.reaction,
        });
        let after = match scenario {
            ScenarioId::Cycle | ScenarioId::HotAmbient | ScenarioId::ColdGrease => 0.0,
            _ => AFTER_S,
        };
        let end_s = course.duration_s() + after;
        let happens_s = start::happens(&setup, &course)?;
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "bounded by the caller's count of the work"
        )]
        let [end_tick, latest_tick] = {
            let longer_s = if scenario.has_instant() { LONGER_S } else { 0.0 };
            [end_s, end_s + longer_s].map(|time| (time * CURRENT_RATE_HZ).round() as u64)
        };
        let mut random = Random::new(setup.seed ^ 0x5eed);
        let phases = [(); 2].map(|()| TAU * random.uniform());
        let [accuracy_rad, step_rad] = machine.feedback_rad;
        let encoder = Encoder { accuracy_rad, step_rad, phases, failing: None, lost_rad: 0.0 };
        let phase = if resting { Phase::Resting } else { Phase::Running };
        let mut twin = Self {
            stored_at_start_j: plant.stored(&state),
            offset_rad: theta - position,
            control,
            limits,
            phase,
            brake,
            link: link_model.start(),
            link_high: (most_v > least_v).then(|| {
                let model = LinkModel { supply_v: most_v, ..link_model };
                (model, model.start())
            }),
            link_model,
            supply_share: 1.0,
            temperatures: Temperatures {
                winding: ThermodynamicTemperature::from_si(winding),
                housing: ThermodynamicTemperature::from_si(housing),
            },
            sensor_k: winding,
            ptc_k: winding,
            overload: 0.0,
            encoder,
            random,
            voltage: [0.0; 2],
            tick: 0,
            heat_trips: true,
            run_up: 0,
            end_tick,
            latest_tick,
            happens_s,
            happened: false,
            slow: Slow::default(),
            gathered: Gathered::new(setup.settled_rad),
            events: Vec::new(),
            point: start,
            setup,
            machine,
            plant,
            state,
            load,
            local,
            anchor: plant.kinematic.map_or(Anchor::none(), |error| error.anchor(theta)),
            stop: None,
            course,
            coil_j: 0.0,
            ambient_k,
            commanded,
        };
        // The initial angle of the drive is the measured one.
        let measured = twin.angle();
        twin.offset_rad = twin.position_seen(measured) - position;
        twin.control = Control::at_rest(gains, &twin.plant, setup.switches.delay, measured, holding);
        Ok(twin)
    }

    /// Returns the gains in use.
    #[must_use]
    pub const fn gains(&self) -> &Gains {
        &self.control.gains
    }

    /// Returns the limits of the supervision.
    #[must_use]
    pub const fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Returns the symbols of unknown data, whose part of the model is omitted.
    #[must_use]
    pub fn left_out(&self) -> &[&'static str] {
        &self.machine.left_out
    }

    /// Returns the constants and the load at the start, for the linear responses.
    pub(crate) const fn linear(&self) -> (&Plant, &Local) {
        (&self.plant, &self.local)
    }

    /// Returns the number of periods of the current loop from start to end.
    #[must_use]
    pub const fn periods(&self) -> u64 {
        self.end_tick
    }

    /// Returns the number of solver steps from start to end, the work of the run.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.end_tick * u64::from(self.setup.substeps)
    }

    /// Changes the speed setpoint.
    #[cfg(test)]
    pub(crate) const fn want_speed(&mut self, speed: f64) {
        self.setup.speed_step = Some(speed);
    }

    /// Returns the simulated time \[s\]; negative during the run-up.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "far below 2^53")]
    pub fn time_s(&self) -> f64 {
        (self.tick as f64 - self.run_up as f64) * PERIOD_S
    }

    /// Returns `true` if the end is reached.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        self.tick >= self.end_tick
    }

    /// Advances by some periods, at most to the end.
    pub fn advance(&mut self, periods: u64) {
        for _ in 0..periods {
            if self.is_over() {
                break;
            }
            self.period();
        }
    }

    fn note(&mut self, kind: EventKind) {
        let repeats = matches!(kind, EventKind::Limited | EventKind::BrakeResistor | EventKind::WindingWarning);
        if repeats && self.events.iter().any(|event| event.kind == kind) {
            return;
        }
        // The list is limited: a cycle may close its brake a thousand times.
        if self.events.len() < EVENTS_MOST {
            self.events.push(Event { time_s: self.time_s(), kind });
        }
    }

    /// Returns the position measured for the position loop \[rad\]: the angle of the motor, or that of the encoder at
    /// the output.
    fn position_seen(&self, motor_rad: f64) -> f64 {
        let Some([accuracy, step]) = self.machine.feedback_out_rad.filter(|_| self.setup.loop_at_output) else {
            return motor_rad;
        };
        let position = self.state.x.load_rad;
        if !self.setup.switches.noise {
            return position;
        }
        let [a, b] = self.encoder.phases;
        let error = accuracy * (0.6 * (position + a).sin() + 0.4 * (2.0 * position + b).sin());
        if step > 0.0 { ((position + error) / step).round() * step } else { position + error }
    }

    fn period(&mut self) {
        let time = self.time_s();
        if self.tick.is_multiple_of(POSITION_EVERY) {
            // After a stop the setpoint and the segment with its payload remain.
            if matches!(self.phase, Phase::Running | Phase::Resting) {
                self.point = self.course.at(time);
            }
            self.manage(time);
            let [position, ..] = self.point.state;
            match self.phase {
                Phase::Running | Phase::Resting => {
                    self.gathered.update(time, &self.point.state, self.state.x.load_rad);
                }
                Phase::Commanded(Demand::Position(wanted)) => self.point.state = wanted,
                Phase::Commanded(Demand::Speed(wanted)) => self.point.state = [self.state.x.load_rad, wanted, 0.0],
                // The setpoint of the stop goes on along the ramp.
                Phase::Ramp(speed) => {
                    let way = speed * POSITION_PERIOD_S;
                    self.point.state = [position + way, speed, -self.limits.ramp_rad_s2.copysign(speed)];
                }
                Phase::Holding(_) | Phase::Off => self.point.state = [position, 0.0, 0.0],
            }
        }
        if self.encoder.failing.is_some() {
            self.read(time);
        }
        self.voltage = if self.state.pulses { self.controlled() } else { [0.0; 2] };
        let Variables { motor_rad, motor_rad_s, load_rad, load_rad_s, .. } = self.state.x;
        if let Some(local) =
            self.load.linearised(self.point.segment, load_rad, load_rad_s, self.state.acceleration_rad_s2)
        {
            self.local = local;
        }
        if let Some(error) = &self.plant.kinematic
            && !(self.anchor.is_near(motor_rad) && self.anchor.is_near(motor_rad + motor_rad_s * PERIOD_S))
        {
            self.anchor = error.anchor_ahead(motor_rad, motor_rad_s, 32.0 * PERIOD_S);
        }
        let before = self.state.energies;
        let given = Given { voltage: self.voltage, load: &self.local, stop: self.stop.as_ref(), anchor: &self.anchor };
        self.plant.steps(&mut self.state, &given, self.setup.substeps, PERIOD_S / f64::from(self.setup.substeps));
        let after = &self.state.energies;
        let taken_j = after.terminal_j - before.terminal_j;
        self.link_model.step(&mut self.link, taken_j, self.supply_share, PERIOD_S);
        if let Some((model, link)) = &mut self.link_high {
            model.step(link, taken_j, self.supply_share, PERIOD_S);
        }
        let copper = after.copper_j - before.copper_j;
        self.slow.copper_j += copper;
        self.slow.heat_j += after.heat() - before.heat();
        let Variables { current_d, current_q, .. } = self.state.x;
        let square = 0.5 * (current_d * current_d + current_q * current_q);
        self.slow.square_a2_s += square * PERIOD_S;
        let link_v = [self.link.voltage_v, self.highest_link().voltage_v];
        self.gathered.each(square, self.state.gear_nm, motor_rad_s, link_v);
        self.tick += 1;
        if self.tick.is_multiple_of(SLOW_EVERY) {
            self.supervise();
        }
        if self.tick == self.end_tick && self.runs_out() {
            self.end_tick = (self.end_tick + LONGER_BY).min(self.latest_tick);
        }
    }

    /// Returns the DC link at the highest voltage of the supply.
    pub(crate) fn highest_link(&self) -> &Link {
        self.link_high.as_ref().map_or(&self.link, |(_, link)| link)
    }

    /// Returns the voltage of the control in this period.
    fn controlled(&mut self) -> [f64; 2] {
        let Variables { current_d, current_q, .. } = self.state.x;
        let [mut i_d, mut i_q] = self.seen_by_the_drive([current_d, current_q]);
        let noise = self.setup.parameters.model.current_noise.value;
        if self.setup.switches.noise && noise > 0.0 {
            i_d += noise * self.random.normal();
            i_q += noise * self.random.normal();
        }
        // Measured only for the speed and position loops.
        let angle_rad = if self.tick.is_multiple_of(SPEED_EVERY) { self.angle() } else { 0.0 };
        let position_rad =
            if self.tick.is_multiple_of(POSITION_EVERY) { self.position_seen(angle_rad) } else { angle_rad };
        let measured = Measured { current: [i_d, i_q], angle_rad, position_rad };
        let demand = match (self.phase, self.setup.speed_step) {
            (Phase::Ramp(speed), _) => Demand::Speed(speed),
            (Phase::Holding(_), _) => Demand::Speed(0.0),
            (Phase::Commanded(Demand::Speed(speed)), _) | (_, Some(speed)) => Demand::Speed(speed),
            (_, None) => {
                let [position, speed, acceleration] = self.point.state;
                Demand::Position([position + self.offset_rad, speed, acceleration])
            }
        };
        let most_a = self.commanded.as_ref().and_then(|commanded| commanded.current_most_a);
        let bounds = if self.setup.switches.limits {
            Bounds {
                current_a: SQRT_2
                    * most_a.map_or(self.machine.current_max_a, |most| most.min(self.machine.current_max_a)),
                voltage_v: self.setup.modulation * self.link.voltage_v / 3.0_f64.sqrt(),
                speed: self.machine.speed_max,
            }
        } else {
            Bounds { current_a: f64::INFINITY, voltage_v: f64::INFINITY, speed: f64::INFINITY }
        };
        let voltage = self.control.period(self.tick, &measured, || demand, &bounds);
        if self.control.limited {
            self.note(EventKind::Limited);
        }
        self.given_by_the_drive(voltage)
    }

    /// Returns the events so far.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// Returns the mean losses so far.
    pub(crate) fn losses(&self) -> Losses {
        let (energies, time) = (&self.state.energies, self.time_s().max(PERIOD_S));
        Losses { copper_w: energies.copper_j / time, friction_w: (energies.heat() + self.coil_j) / time }
    }

    /// Returns the results so far.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let stored = self.plant.stored(&self.state) - self.stored_at_start_j;
        let energies = self.state.energies;
        let summary = self.gathered.summary(
            &energies,
            energies.unaccounted(stored),
            [&self.link, self.highest_link()],
            self.time_s(),
            self.brake.closings,
            self.happens_s,
        );
        let ends = self.course.ends_rad().filter(|_| summary.stop_rad.is_some());
        let Some([lower, upper]) = ends else { return summary };
        let [lowest, highest] = self.gathered.reached_rad();
        let beyond_rad = [lower - lowest, highest - upper].map(|beyond| Some(beyond).filter(|beyond| *beyond > 0.0));
        Summary { beyond_rad, ..summary }
    }
}

/// Largest number of stored events.
const EVENTS_MOST: usize = 1000;
