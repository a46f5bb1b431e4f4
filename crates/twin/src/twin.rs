//! The run: control, plant, DC link and supervision, period by period.

use crate::control::{Bounds, CURRENT_RATE_HZ, Control, Demand, Gains, Measured, POSITION_EVERY, SPEED_EVERY};
use crate::drive::{BrakeState, Limits, Phase};
use crate::gear::Anchor;
use crate::link::{Link, LinkModel};
use crate::load::{LoadModel, Local};
use crate::machine::Machine;
use crate::noise::Random;
use crate::parameters::Parameter;
use crate::plant::{Energies, Given, Plant, State, Stop};
use crate::scenario::{Event, EventKind, Reaction, ScenarioId};
use crate::setpoint::{Course, SetPoint};
use crate::setup::{Fault, STEP_MOST, SUBSTEPS_MOST, Setup};
use crate::summary::{Gathered, Summary};
use actuator::{Losses, Temperatures, overload_slope};
use quantities::{ElectricCurrent, Measure, Ratio, ThermodynamicTemperature, Time};
use std::f64::consts::{SQRT_2, TAU};

/// Duration of a period of the current loop \[s\].
pub(crate) const PERIOD_S: f64 = 1.0 / CURRENT_RATE_HZ;

/// Periods between two looks at temperatures and supervision: 1 ms.
const SLOW_EVERY: u64 = 16;

/// After the motion the run goes on for so long \[s\].
const AFTER_S: f64 = 0.5;

/// The drive notices a frozen angle after so long \[s\]. A guess.
const NOTICED_S: f64 = 2e-3;

/// The supply drops to this share and returns after this time \[s\].
const SAG: (f64, f64) = (0.6, 0.2);

/// One instant of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// \[s\]
    pub time_s: f64,
    /// Set-point of the position \[rad\], and its speed [rad/s].
    pub wanted_rad: f64,
    /// Speed of the set-point [rad/s].
    pub wanted_rad_s: f64,
    /// Position of the load \[rad\].
    pub position_rad: f64,
    /// Speed of the load [rad/s].
    pub speed_rad_s: f64,
    /// Acceleration of the load [rad/s²].
    pub acceleration_rad_s2: f64,
    /// Angle of the motor over i \[rad\].
    pub motor_rad: f64,
    /// Speed of the motor over i [rad/s].
    pub motor_rad_s: f64,
    /// Torque through the gear \[Nm\].
    pub torque_nm: f64,
    /// i_q \[A\], peak of a phase.
    pub current_q_a: f64,
    /// i_d \[A\].
    pub current_d_a: f64,
    /// u_q \[V\], peak of a phase.
    pub voltage_q_v: f64,
    /// u_d \[V\].
    pub voltage_d_v: f64,
    /// DC link \[V\].
    pub link_v: f64,
    /// Winding \[K\].
    pub winding_k: f64,
    /// Housing \[K\].
    pub housing_k: f64,
    /// What the sensor of the winding shows \[K\].
    pub sensor_k: f64,
    /// State of the overload supervision; it trips above one.
    pub overload: f64,
    /// Following error at the load \[rad\].
    pub following_rad: f64,
    /// Whether the brake is closed.
    pub braked: bool,
}

/// The state of the feedback.
#[derive(Clone, Copy, Debug)]
struct Encoder {
    accuracy_rad: f64,
    step_rad: f64,
    phases: [f64; 2],
    frozen_rad: Option<f64>,
}

/// A run.
#[derive(Clone, Debug)]
pub struct Twin<'a> {
    setup: Setup<'a>,
    machine: Machine,
    plant: Plant,
    pub(crate) state: State,
    load: LoadModel<'a>,
    local: Local,
    stop: Option<Stop>,
    course: Course<'a>,
    point: SetPoint,
    /// Angle of the motor minus set-point at the start \[rad\].
    offset_rad: f64,
    control: Control,
    limits: Limits,
    phase: Phase,
    brake: BrakeState,
    link_model: LinkModel,
    pub(crate) link: Link,
    supply_share: f64,
    temperatures: Temperatures,
    sensor_k: f64,
    overload: f64,
    encoder: Encoder,
    random: Random,
    voltage: [f64; 2],
    tick: u64,
    end_tick: u64,
    happens_s: Option<f64>,
    happened: bool,
    slow: Slow,
    gathered: Gathered,
    events: Vec<Event>,
    stored_at_start_j: f64,
    /// Heat of the coil of the open brake so far \[J\].
    coil_j: f64,
    ambient_k: f64,
}

/// What is summed up for the next slow look.
#[derive(Clone, Copy, Debug, Default)]
struct Slow {
    copper_j: f64,
    heat_j: f64,
    square_a2_s: f64,
}

impl<'a> Twin<'a> {
    /// A run that stands at its start.
    ///
    /// # Errors
    /// [`Fault`]: what is missing, contradicts itself, or cannot be computed with this step.
    pub fn new(setup: &Setup<'a>) -> Result<Self, Fault> {
        let setup = *setup;
        if setup.substeps == 0 || setup.substeps > SUBSTEPS_MOST {
            return Err(Fault::OutOfRange("substeps"));
        }
        for (key, value) in [("supply", setup.supply_v), ("ambient", setup.ambient_k), ("modulation", setup.modulation)]
        {
            if !(value.is_finite() && value > 0.0) {
                return Err(Fault::OutOfRange(key));
            }
        }
        if matches!(setup.mechanism.kind, mechanism::Kind::Joint(_)) {
            return Err(Fault::RecordedTorque);
        }
        if let Some(Parameter { key, .. }) = setup
            .parameters
            .list()
            .iter()
            .find(|each| each.value.as_ref().is_some_and(|value| !value.value.is_finite() || value.value < 0.0))
        {
            return Err(Fault::OutOfRange(key));
        }
        let machine = Machine::of(setup.parameters, setup.switches, setup.seed)?;
        let course = Course::of(setup.motion, setup.scenario.cycles);
        let model = &setup.parameters.model;
        let ambient_k = ambient(&setup);
        let scenario = setup.scenario.id;
        match scenario {
            ScenarioId::BrakeStuck | ScenarioId::HangingLoad if machine.brake.is_none() => return Err(Fault::NoBrake),
            ScenarioId::BatteryLoss if !setup.parameters.actuator.feedback.buffered_by_battery => {
                return Err(Fault::NoBattery);
            }
            _ => {}
        }
        let start = course.at(0.0);
        let [position, _, _] = start.state;
        let load = LoadModel::of(setup.mechanism, setup.extras, machine.flange_kgm2);
        let local = load.near(start.segment, position, 0.0, 0.0).ok_or(Fault::NoInertia)?;
        if local.inertia_kgm2.is_nan() || local.inertia_kgm2 <= 0.0 {
            return Err(Fault::NoInertia);
        }
        let mut plant = machine.plant;
        let temperatures =
            setup.start_k.filter(|_| !matches!(scenario, ScenarioId::ColdGrease)).unwrap_or([ambient_k; 2]);
        let [winding, housing] = temperatures;
        machine.warm(&mut plant, winding, housing);
        let has_stop = matches!(scenario, ScenarioId::BlockedLoad | ScenarioId::Collision);
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
        // e hangs on the angle itself by little: a few steps suffice.
        let mut theta = position + twist;
        for _ in 0..6 {
            theta = position + twist + plant.kinematic.map_or(0.0, |error| error.at(theta).0);
        }
        let closed = start.braked.is_some() || matches!(scenario, ScenarioId::BatteryLoss);
        let brake = BrakeState::new(machine.brake, closed, scenario == ScenarioId::BrakeStuck);
        plant.brake_nm = brake.torque_nm();
        let usual = Gains::usual(&plant, local.inertia_kgm2, plant.spring.stiffness_at(twist), setup.switches.delay);
        let gains = setup.gains.unwrap_or(usual);
        let control = Control::at_rest(gains, &plant, setup.switches.delay, theta, holding);
        let resting = brake.closed && start.braked.is_some();
        let pulses = !resting && scenario != ScenarioId::BatteryLoss;
        let free = |held: f64| if held > 0.0 { 0.0 } else { 1.0 };
        let mut state = State {
            x: [0.0, if pulses { control.current_wanted } else { 0.0 }, theta, 0.0, position, 0.0],
            force: [0.0; crate::gear::ELEMENTS],
            sliding: [free(plant.friction_nm + plant.brake_nm + plant.mesh), free(local.coulomb_nm)],
            energies: Energies::default(),
            slipped_rad: 0.0,
            error: (0.0, 0.0),
            gear_nm: holding,
            twist_rad: 0.0,
            acceleration_rad_s2: 0.0,
            pulses,
        };
        plant.place(&mut state);
        let chopper = [model.chopper_off.value, model.chopper_on.value].map(|share| share * setup.supply_v);
        let link_model = LinkModel {
            capacity_f: 2.0 * model.link_energy.value / (560.0 * 560.0),
            supply_v: setup.supply_v,
            supply_ohm: model.supply_resistance.value.max(1e-3),
            brake_ohm: model.brake_resistor.value.max(1e-3),
            chopper_v: chopper,
        };
        let fastest = setup.motion.pieces().iter().map(|piece| piece.polynomial[0].abs()).fold(0.0, f64::max);
        let torque_ramp =
            plant.torque_constant * SQRT_2 * machine.current_max_a / (plant.inertia_kgm2 + local.inertia_kgm2) / 2.0;
        let limits = setup.limits.unwrap_or(Limits {
            following_rad: None,
            link_v: [0.7 * setup.supply_v, link_most(&setup)],
            ramp_rad_s2: if fastest > 0.0 { fastest.min(torque_ramp) } else { torque_ramp },
            reaction: setup.scenario.reaction,
        });
        let after = match scenario {
            ScenarioId::Cycle | ScenarioId::HotAmbient | ScenarioId::ColdGrease => 0.0,
            _ => AFTER_S,
        };
        let end_s = course.duration_s() + after;
        let happens_s = happens(&setup, &course)?;
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "bounded by the caller's count of the work"
        )]
        let end_tick = (end_s * CURRENT_RATE_HZ).round() as u64;
        let mut random = Random::new(setup.seed ^ 0x5eed);
        let phases = [(); 2].map(|()| TAU * random.uniform());
        let [accuracy_rad, step_rad] = machine.feedback_rad;
        let encoder = Encoder { accuracy_rad, step_rad, phases, frozen_rad: None };
        let phase = if scenario == ScenarioId::BatteryLoss {
            Phase::Off
        } else if resting {
            Phase::Resting
        } else {
            Phase::Running
        };
        let mut twin = Self {
            stored_at_start_j: plant.stored(&state),
            offset_rad: theta - position,
            control,
            limits,
            phase,
            brake,
            link: link_model.start(),
            link_model,
            supply_share: 1.0,
            temperatures: Temperatures {
                winding: ThermodynamicTemperature::from_si(winding),
                housing: ThermodynamicTemperature::from_si(housing),
            },
            sensor_k: winding,
            overload: 0.0,
            encoder,
            random,
            voltage: [0.0; 2],
            tick: 0,
            end_tick,
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
            stop: None,
            course,
            coil_j: 0.0,
            ambient_k,
        };
        if scenario == ScenarioId::BatteryLoss {
            twin.note(EventKind::NoPosition);
        }
        // The angle at which the drive starts is the one that it measures.
        let measured = twin.angle();
        twin.offset_rad += measured - twin.state.x[2];
        twin.control = Control::at_rest(gains, &twin.plant, setup.switches.delay, measured, holding);
        Ok(twin)
    }

    /// The gains in use.
    #[must_use]
    pub const fn gains(&self) -> &Gains {
        &self.control.gains
    }

    /// What is supervised.
    #[must_use]
    pub const fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Data that are not known, so that a part of the model is left out.
    #[must_use]
    pub fn left_out(&self) -> &[&'static str] {
        &self.machine.left_out
    }

    /// The constants and the load at the start, for the linear responses.
    pub(crate) const fn linear(&self) -> (&Plant, &Local) {
        (&self.plant, &self.local)
    }

    /// Periods of the current loop from start to end.
    #[must_use]
    pub const fn periods(&self) -> u64 {
        self.end_tick
    }

    /// Steps of the solver from start to end: the work of the run.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.end_tick * u64::from(self.setup.substeps)
    }

    /// Another wanted speed from now on.
    #[cfg(test)]
    pub(crate) const fn want_speed(&mut self, speed: f64) {
        self.setup.speed_step = Some(speed);
    }

    /// The time reached \[s\].
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "far below 2^53")]
    pub fn time_s(&self) -> f64 {
        self.tick as f64 * PERIOD_S
    }

    /// Whether the end is reached.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        self.tick >= self.end_tick
    }

    /// Goes on for some periods, at most to the end.
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
        // A cycle that closes its brake a thousand times needs no list of it.
        if self.events.len() < EVENTS_MOST {
            self.events.push(Event { time_s: self.time_s(), kind });
        }
    }

    /// The measured angle of the motor, over i \[rad\].
    fn angle(&self) -> f64 {
        let theta = self.state.x[2];
        if let Some(frozen) = self.encoder.frozen_rad {
            return frozen;
        }
        if !self.setup.switches.noise {
            return theta;
        }
        let [a, b] = self.encoder.phases;
        let alpha = self.machine.ratio * theta;
        // Two lines a turn of the motor whose sum stays within the printed accuracy.
        let error = self.encoder.accuracy_rad * (0.6 * (alpha + a).sin() + 0.4 * (2.0 * alpha + b).sin());
        let measured = theta + error;
        if self.encoder.step_rad > 0.0 {
            (measured / self.encoder.step_rad).round() * self.encoder.step_rad
        } else {
            measured
        }
    }

    fn period(&mut self) {
        let time = self.time_s();
        if self.tick.is_multiple_of(POSITION_EVERY) {
            // After a stop the set-point stands, and what the axis carries stays.
            if matches!(self.phase, Phase::Running | Phase::Resting) {
                self.point = self.course.at(time);
            }
            self.manage(time);
            if matches!(self.phase, Phase::Running | Phase::Resting) {
                self.gathered.look(time, &self.point.state, self.state.x[4]);
            } else {
                let [position, ..] = self.point.state;
                self.point.state = [position, 0.0, 0.0];
            }
        }
        self.voltage = if self.state.pulses { self.controlled() } else { [0.0; 2] };
        let [_, _, theta, omega, position, speed] = self.state.x;
        if let Some(local) = self.load.near(self.point.segment, position, speed, self.state.acceleration_rad_s2) {
            self.local = local;
        }
        let anchor: Option<Anchor> = self.plant.kinematic.map(|error| error.anchor(theta));
        let before = self.state.energies;
        let given =
            Given { voltage: self.voltage, load: &self.local, stop: self.stop.as_ref(), anchor: anchor.as_ref() };
        let h = PERIOD_S / f64::from(self.setup.substeps);
        for _ in 0..self.setup.substeps {
            self.plant.step(&mut self.state, &given, h);
        }
        let after = &self.state.energies;
        self.link_model.step(&mut self.link, after.terminal_j - before.terminal_j, self.supply_share, PERIOD_S);
        let copper = after.copper_j - before.copper_j;
        self.slow.copper_j += copper;
        self.slow.heat_j += after.heat() - before.heat();
        let [i_d, i_q, ..] = self.state.x;
        let square = 0.5 * (i_d * i_d + i_q * i_q);
        self.slow.square_a2_s += square * PERIOD_S;
        self.gathered.each(square, self.state.gear_nm, omega, self.link.voltage_v, self.time_s());
        self.tick += 1;
        if self.tick.is_multiple_of(SLOW_EVERY) {
            self.supervise();
        }
    }

    /// The voltage that the control puts out in this period.
    fn controlled(&mut self) -> [f64; 2] {
        let [mut i_d, mut i_q, ..] = self.state.x;
        let noise = self.setup.parameters.model.current_noise.value;
        if self.setup.switches.noise && noise > 0.0 {
            i_d += noise * self.random.normal();
            i_q += noise * self.random.normal();
        }
        let measured = Measured {
            current: [i_d, i_q],
            // The loops of speed and position alone look at it.
            angle_rad: if self.tick.is_multiple_of(SPEED_EVERY) { self.angle() } else { 0.0 },
        };
        let demand = match (self.phase, self.setup.speed_step) {
            (Phase::Ramp(speed), _) => Demand::Speed(speed),
            (Phase::Holding(_), _) => Demand::Speed(0.0),
            (_, Some(speed)) => Demand::Speed(speed),
            (_, None) => {
                let [position, speed, acceleration] = self.point.state;
                Demand::Position([position + self.offset_rad, speed, acceleration])
            }
        };
        let bounds = if self.setup.switches.limits {
            Bounds {
                current_a: SQRT_2 * self.machine.current_max_a,
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
        voltage
    }

    /// Scenario, brake and states of the drive, at the rate of the position loop.
    fn manage(&mut self, time: f64) {
        if !self.happened && self.happens_s.is_some_and(|at| time >= at) {
            self.happened = true;
            self.happen();
        }
        if self.brake.follow(time) {
            self.plant.brake_nm = self.brake.torque_nm();
            let moving = self.state.x[3].abs() > 1e-3 * self.machine.speed_max;
            let kind = match (self.brake.closed, moving) {
                (true, true) => EventKind::BrakeClosedMoving,
                (true, false) => EventKind::BrakeClosed,
                (false, _) => EventKind::BrakeOpen,
            };
            if self.brake.closed {
                let [rest, moved] = &mut self.brake.closings;
                *(if moving { moved } else { rest }) += 1;
                self.state.slipped_rad = 0.0;
                // What is at rest and held sticks.
                if !moving && self.state.x[3] == 0.0 {
                    self.state.sliding[0] = 0.0;
                }
            }
            self.note(kind);
        }
        if self.brake.closed && self.state.slipped_rad > 1e-6 && !self.has(EventKind::BrakeSlips) {
            self.note(EventKind::BrakeSlips);
        }
        match self.phase {
            Phase::Running => self.run(time),
            Phase::Resting => {
                let [opening, _] = self.brake.delays();
                let goes_on = self.point.braked.is_none_or(|[_, left]| left <= opening + 2.0 * PERIOD_S);
                if goes_on {
                    self.brake.command(true, time);
                    self.restart();
                    self.phase = Phase::Running;
                }
            }
            Phase::Ramp(speed) => {
                let least = self.limits.ramp_rad_s2 * PERIOD_S * 8.0;
                let next = if speed.abs() <= least { 0.0 } else { speed - least.copysign(speed) };
                let stands = next == 0.0 && self.control.speed.abs() < 5e-3 * self.machine.speed_max;
                self.phase = if stands { Phase::Holding(time) } else { Phase::Ramp(next) };
                if stands {
                    self.note(EventKind::AtRest);
                    if self.brake.command(false, time) {
                        self.note(EventKind::BrakeCloses);
                    }
                }
            }
            Phase::Holding(since) => {
                let held = if self.brake.exists() { self.brake.closed } else { time - since > 0.1 };
                if held {
                    self.switch_off();
                }
            }
            Phase::Off => {}
        }
        let rests = self.state.x[3].abs() < 1e-4 * self.machine.speed_max
            && self.state.x[5].abs() < 1e-3 * self.machine.speed_max;
        if self.phase == Phase::Off && rests && self.happened && !self.has(EventKind::AtRest) {
            self.note(EventKind::AtRest);
        }
        self.gathered.stop(time, self.happened, rests, self.state.x[4]);
    }

    /// The brake within the cycle.
    fn run(&mut self, time: f64) {
        let [opening, closing] = self.brake.delays();
        if let Some([since, left]) = self.point.braked
            && self.brake.exists()
            && since + left > opening + closing
            && left > opening
        {
            if self.brake.command(false, time) {
                self.note(EventKind::BrakeCloses);
            }
            if self.brake.closed {
                self.phase = Phase::Resting;
                self.plant.block(&mut self.state);
            }
        } else if !self.brake.stuck {
            self.brake.command(true, time);
        }
    }

    fn restart(&mut self) {
        let holding = self.control.integral_nm;
        let gains = self.control.gains;
        let angle = self.angle();
        self.control = Control::at_rest(gains, &self.plant, self.setup.switches.delay, angle, holding);
        self.state.pulses = true;
    }

    fn switch_off(&mut self) {
        if self.state.pulses {
            self.plant.block(&mut self.state);
            self.note(EventKind::PulsesOff);
        }
        self.phase = Phase::Off;
    }

    fn has(&self, kind: EventKind) -> bool {
        self.events.iter().any(|event| event.kind == kind)
    }

    /// Ends the motion.
    fn react(&mut self, reaction: Reaction) {
        let time = self.time_s();
        match reaction {
            Reaction::Ramp if self.state.pulses => {
                self.note(EventKind::Ramp);
                self.phase = Phase::Ramp(self.control.speed);
            }
            Reaction::Ramp | Reaction::Brake => {
                self.switch_off();
                if self.brake.command(false, time) {
                    self.note(EventKind::BrakeCloses);
                }
            }
            Reaction::Coast => self.switch_off(),
        }
    }

    /// A fault that the drive notices itself.
    fn fault(&mut self, kind: EventKind, reaction: Reaction) {
        if !self.has(kind) {
            self.note(kind);
        }
        if matches!(self.phase, Phase::Running | Phase::Resting) {
            self.react(reaction);
        }
    }

    fn happen(&mut self) {
        self.note(EventKind::Scenario);
        let reaction = self.setup.scenario.reaction;
        let stop = |side: f64| Stop {
            at_rad: self.state.x[4],
            side,
            stiffness_nm: self.setup.parameters.model.stop_stiffness.value,
            damping_nms: 0.1 * (self.setup.parameters.model.stop_stiffness.value * self.local.inertia_kgm2).sqrt(),
        };
        match self.setup.scenario.id {
            ScenarioId::EmergencyStop => self.react(reaction),
            ScenarioId::PowerFailure => {
                self.supply_share = 0.0;
                self.react(Reaction::Brake);
            }
            ScenarioId::HangingLoad => self.react(Reaction::Brake),
            ScenarioId::BlockedLoad => self.stop = Some(stop(0.0)),
            ScenarioId::Collision => self.stop = Some(stop(self.state.x[5].signum())),
            ScenarioId::EncoderFailure => self.encoder.frozen_rad = Some(self.angle()),
            ScenarioId::LinkSag => self.supply_share = SAG.0,
            ScenarioId::Cycle
            | ScenarioId::BrakeStuck
            | ScenarioId::BatteryLoss
            | ScenarioId::HotAmbient
            | ScenarioId::ColdGrease => {}
        }
    }

    /// Temperatures, supervision, and what follows the temperatures, once a millisecond.
    fn supervise(&mut self) {
        #[allow(clippy::cast_precision_loss, reason = "sixteen")]
        let step = SLOW_EVERY as f64 * PERIOD_S;
        let mut slow = std::mem::take(&mut self.slow);
        let coil = self.machine.brake.filter(|_| !self.brake.closed).map_or(0.0, |brake| brake.coil_w * step);
        slow.heat_j += coil;
        self.coil_j += coil;
        if let Some(heat) = self.machine.heat {
            self.temperatures =
                warmed(&self.temperatures, &heat, slow.copper_j / step, slow.heat_j / step, self.ambient_k, step);
            let (winding, housing) = (self.temperatures.winding.si(), self.temperatures.housing.si());
            self.machine.warm(&mut self.plant, winding, housing);
            let lag = self.setup.parameters.model.sensor_lag.value.max(step);
            self.sensor_k += (winding - self.sensor_k) * step / lag;
            if let Some(stall) = self.machine.stall_current_a {
                let current = ElectricCurrent::from_si((slow.square_a2_s / step).sqrt());
                let slope = |state: f64| {
                    let time_constant: Time = heat.winding_time_constant();
                    overload_slope(Ratio::from_si(state), current, ElectricCurrent::from_si(stall), time_constant)
                };
                // Heun's rule, as the temperatures.
                let first = slope(self.overload);
                self.overload += 0.5 * step * (first + slope(self.overload + step * first));
            }
            self.gathered.warm(winding, housing, self.overload);
        }
        if self.link.chopping {
            self.note(EventKind::BrakeResistor);
        }
        let [i_d, i_q, ..] = self.state.x;
        let current = (0.5 * (i_d * i_d + i_q * i_q)).sqrt();
        if self.machine.demagnetisation_a.is_some_and(|limit| current >= limit) && !self.has(EventKind::Demagnetisation)
        {
            self.note(EventKind::Demagnetisation);
        }
        let collision = self.setup.parameters.actuator.gear.collision_torque_max.known();
        if collision.is_some_and(|limit| self.gathered.torque_nm() > limit.value.si())
            && !self.has(EventKind::CollisionTorque)
        {
            self.note(EventKind::CollisionTorque);
        }
        if self.state.x.iter().any(|value| !value.is_finite())
            || self.state.x[3].abs() > 20.0 * self.machine.speed_max
            || self.state.twist_rad.abs() > 1.0
        {
            self.note(EventKind::Diverged);
            self.end_tick = self.tick;
        }
        self.notice();
    }

    /// What the drive notices by itself.
    fn notice(&mut self) {
        let time = self.time_s();
        if self.setup.scenario.id == ScenarioId::LinkSag && self.happens_s.is_some_and(|at| time > at + SAG.1) {
            self.supply_share = 1.0;
        }
        let shutdown = self.setup.parameters.actuator.heat.winding_shutdown.known().map(|known| known.value.si());
        let warning = self.setup.parameters.actuator.heat.winding_warning.known().map(|known| known.value.si());
        if warning.is_some_and(|limit| self.sensor_k > limit) {
            self.note(EventKind::WindingWarning);
        }
        if self.encoder.frozen_rad.is_some() && self.happens_s.is_some_and(|at| time > at + NOTICED_S) {
            let reaction = if self.brake.exists() { Reaction::Brake } else { Reaction::Coast };
            self.fault(EventKind::NoPosition, reaction);
        }
        if !self.setup.switches.limits {
            return;
        }
        let reaction = self.limits.reaction;
        if shutdown.is_some_and(|limit| self.sensor_k > limit) {
            self.fault(EventKind::WindingShutdown, reaction);
        }
        if self.overload > 1.0 {
            self.fault(EventKind::Overload, reaction);
        }
        if self.phase == Phase::Running
            && self.limits.following_rad.is_some_and(|limit| self.control.following_rad.abs() > limit)
        {
            self.fault(EventKind::FollowingError, reaction);
        }
        let [low, high] = self.limits.link_v;
        let without_drive = if self.brake.exists() { Reaction::Brake } else { Reaction::Coast };
        if self.link.voltage_v < low && self.state.pulses {
            self.fault(EventKind::LinkLow, without_drive);
        }
        if self.link.voltage_v > high {
            self.fault(EventKind::LinkHigh, without_drive);
        }
        if self.state.x[3].abs() > 1.1 * self.machine.speed_max && !self.has(EventKind::Overspeed) {
            self.fault(EventKind::Overspeed, without_drive);
        }
    }

    /// The state now.
    #[must_use]
    pub fn sample(&self) -> Sample {
        let [i_d, i_q, theta, omega, position, speed] = self.state.x;
        let [wanted, wanted_speed, _] = self.point.state;
        let [u_d, u_q] = self.voltage;
        Sample {
            time_s: self.time_s(),
            wanted_rad: wanted,
            wanted_rad_s: wanted_speed,
            position_rad: position,
            speed_rad_s: speed,
            acceleration_rad_s2: self.state.acceleration_rad_s2,
            motor_rad: theta,
            motor_rad_s: omega,
            torque_nm: self.state.gear_nm,
            current_q_a: i_q,
            current_d_a: i_d,
            voltage_q_v: u_q,
            voltage_d_v: u_d,
            link_v: self.link.voltage_v,
            winding_k: self.temperatures.winding.si(),
            housing_k: self.temperatures.housing.si(),
            sensor_k: self.sensor_k,
            overload: self.overload,
            following_rad: wanted - position,
            braked: self.brake.closed,
        }
    }

    /// What happened so far.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// Mean losses up to now.
    pub(crate) fn losses(&self) -> Losses {
        let (energies, time) = (&self.state.energies, self.time_s().max(PERIOD_S));
        Losses { copper_w: energies.copper_j / time, friction_w: (energies.heat() + self.coil_j) / time }
    }

    /// The run in figures, up to now.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let stored = self.plant.stored(&self.state) - self.stored_at_start_j;
        let energies = self.state.energies;
        self.gathered.summary(
            &energies,
            energies.unaccounted(stored),
            &self.link,
            self.time_s(),
            self.brake.closings,
            self.happens_s,
        )
    }
}

/// So many events are kept at most.
const EVENTS_MOST: usize = 1000;

/// The air of a scenario \[K\].
fn ambient(setup: &Setup<'_>) -> f64 {
    let range = setup.parameters.actuator.ambient_range.known().map(|known| known.value);
    match (setup.scenario.id, range) {
        (ScenarioId::HotAmbient, Some((_, warmest))) => warmest.si().max(setup.ambient_k),
        (ScenarioId::ColdGrease, Some((coldest, _))) => coldest.si().min(setup.ambient_k),
        _ => setup.ambient_k,
    }
}

/// The largest voltage of the DC link: that of the actuator.
fn link_most(setup: &Setup<'_>) -> f64 {
    let known = setup.parameters.actuator.dc_link_max.known().map(|known| known.value.si());
    known.unwrap_or(1.25 * setup.supply_v).max(1.05 * setup.supply_v)
}

/// When the scenario takes place.
fn happens(setup: &Setup<'_>, course: &Course<'_>) -> Result<Option<f64>, Fault> {
    let usual = match setup.scenario.id {
        ScenarioId::Cycle
        | ScenarioId::BrakeStuck
        | ScenarioId::BatteryLoss
        | ScenarioId::HotAmbient
        | ScenarioId::ColdGrease => return Ok(None),
        ScenarioId::HangingLoad => 0.0,
        ScenarioId::EmergencyStop
        | ScenarioId::PowerFailure
        | ScenarioId::BlockedLoad
        | ScenarioId::EncoderFailure
        | ScenarioId::LinkSag
        | ScenarioId::Collision => course.fastest_s(),
    };
    let at = setup.scenario.at_s.unwrap_or(usual);
    if !at.is_finite() || at < 0.0 {
        return Err(Fault::OutOfRange("at"));
    }
    let end_s = course.duration_s();
    if at >= end_s {
        return Err(Fault::AfterTheEnd { end_s });
    }
    let speed = course.at(at).state[1].abs();
    match setup.scenario.id {
        ScenarioId::HangingLoad if speed > 1e-9 => Err(Fault::NotAtRest),
        ScenarioId::Collision if speed < 1e-9 => Err(Fault::AtRest),
        _ => Ok(Some(at)),
    }
}

/// The thermal network one step on under constant losses, by Heun's rule.
pub(crate) fn warmed(
    from: &Temperatures,
    heat: &actuator::HeatModel,
    copper_w: f64,
    friction_w: f64,
    ambient_k: f64,
    step: f64,
) -> Temperatures {
    let (network, losses) = (heat.network(), Losses { copper_w, friction_w });
    let ambient = ThermodynamicTemperature::from_si(ambient_k);
    let moved = |winding: f64, housing: f64| Temperatures {
        winding: ThermodynamicTemperature::from_si(from.winding.si() + winding),
        housing: ThermodynamicTemperature::from_si(from.housing.si() + housing),
    };
    let first = network.flows(from, losses, ambient);
    let second = network.flows(&moved(step * first.winding_k_per_s, step * first.housing_k_per_s), losses, ambient);
    moved(
        0.5 * step * (first.winding_k_per_s + second.winding_k_per_s),
        0.5 * step * (first.housing_k_per_s + second.housing_k_per_s),
    )
}
