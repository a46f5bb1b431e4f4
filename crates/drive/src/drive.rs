//! The drive: objects and state machine over the twin.

mod control;

use crate::abort::Abort;
use crate::course::{Line, Move, Wanted};
use crate::dictionary::{Address, DISTURBANCES, Dictionary, ERRORS_MOST, Entry, Value, entries};
use crate::pdo;
use crate::profile::Mode;
use crate::scale::{Scale, bounded};
use crate::state::State;
use crate::trouble::Trouble;
use installation::commission::cia402::Object;
use twin::{Demand, EventKind, Fault, POSITION_EVERY, Reading, ScenarioId, Setup, Twin};

/// The time of a step \[s\]: a period of the position loop.
pub const HALF_MS_S: f64 = 0.5e-3;

/// What a drive is beside its twin.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// Its number on the bus, 1 to 127.
    pub node: u8,
    /// Its name.
    pub name: String,
    /// The seed of its phases and noise, which is its serial number.
    pub seed: u32,
    /// The objects that the commissioning of its code states.
    pub objects: Vec<Object>,
    /// Whether its feedback keeps its turns by a battery.
    pub has_battery: bool,
    /// Whether the KTY of its winding is led out, so that a drive can read it.
    pub has_kty: bool,
}

/// What a drive was commanded to end with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ending {
    /// Deceleration [rad/s²].
    pub(crate) rate: f64,
    /// The state behind it, without torque; `None`: the axis is held.
    pub(crate) then: Option<State>,
    /// Whether it stands and the brake is closing.
    pub(crate) stands: bool,
}

/// Which set-points the drive makes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Course {
    /// It stands.
    Hold,
    /// A move to a position.
    Move(Move),
    /// A line to the set-point of the controller.
    Line(Line),
}

/// A virtual drive.
#[derive(Clone, Debug)]
pub struct Drive<'a> {
    pub(crate) twin: Twin<'a>,
    pub(crate) dictionary: Dictionary,
    pub(crate) scale: Scale,
    has_battery: bool,
    pub(crate) state: State,
    pub(crate) control: u16,
    pub(crate) ending: Option<Ending>,
    pub(crate) mode: Mode,
    pub(crate) demand: Wanted,
    pub(crate) course: Course,
    /// A set-point that waits until the move ends.
    pub(crate) waiting: Option<f64>,
    pub(crate) acknowledged: bool,
    /// The last set-point of a move \[rad\].
    pub(crate) target_rad: f64,
    pub(crate) was_halted: bool,
    pub(crate) is_reached: bool,
    pub(crate) is_at_limit: bool,
    /// Time beyond the window of the following error, and within that of the target \[s\].
    pub(crate) beyond_s: f64,
    pub(crate) within_s: f64,
    pub(crate) trouble: Option<Trouble>,
    errors: Vec<u32>,
    emergencies: Vec<(u16, u8)>,
    ticks: u64,
}

impl<'a> Drive<'a> {
    /// A drive that begins.
    ///
    /// # Errors
    /// Why the twin cannot run.
    pub fn new(setup: &Setup<'a>, given: &Given) -> Result<Self, Fault> {
        let twin = Twin::commanded(setup)?;
        let mut scale = Scale::new(given);
        let dictionary = Dictionary::new(entries(given, &scale, twin.most(), twin.limits().ramp_rad_s2));
        scale.follow(&dictionary);
        let mut drive = Self {
            twin,
            dictionary,
            scale,
            has_battery: given.has_battery,
            state: State::NotReadyToSwitchOn,
            control: 0,
            ending: None,
            mode: Mode::None,
            demand: [0.0; 3],
            course: Course::Hold,
            waiting: None,
            acknowledged: false,
            target_rad: 0.0,
            was_halted: false,
            is_reached: false,
            is_at_limit: false,
            beyond_s: 0.0,
            within_s: 0.0,
            trouble: None,
            errors: Vec::new(),
            emergencies: Vec::new(),
            ticks: 0,
        };
        let position = drive.reading().position_rad;
        (drive.demand, drive.target_rad) = ([position, 0.0, 0.0], position);
        drive.limit_current();
        Ok(drive)
    }

    /// Its state.
    #[must_use]
    pub const fn state(&self) -> State {
        self.state
    }

    /// The fault that it has.
    #[must_use]
    pub const fn trouble(&self) -> Option<Trouble> {
        self.trouble
    }

    /// What it measures.
    #[must_use]
    pub fn reading(&self) -> Reading {
        self.twin.reading()
    }

    /// The twin.
    #[must_use]
    pub const fn twin(&self) -> &Twin<'a> {
        &self.twin
    }

    /// Every object with its value at the start.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.dictionary.entries()
    }

    /// Steps since the start.
    #[must_use]
    pub const fn ticks(&self) -> u64 {
        self.ticks
    }

    /// Time since the start \[s\].
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "far below 2^53")]
    pub fn time_s(&self) -> f64 {
        self.ticks as f64 * HALF_MS_S
    }

    /// Emergency messages since the last call: error code and error register.
    pub fn take_emergencies(&mut self) -> Vec<(u16, u8)> {
        std::mem::take(&mut self.emergencies)
    }

    /// The drive begins again, and the axis stays where it is: objects of the communication, or all of them.
    pub fn restart(&mut self, everything: bool) {
        self.dictionary.restart(0x1000, 0x1FFF);
        if everything {
            self.disable(State::NotReadyToSwitchOn);
            self.dictionary.restart(0x2000, u16::MAX);
            self.scale.follow(&self.dictionary);
            self.twin.disturb(ScenarioId::Cycle);
            self.limit_current();
            self.take_mode(Mode::None);
            (self.control, self.trouble) = (0, None);
            self.errors.clear();
            self.emergencies.clear();
        }
    }

    /// Goes on by steps of half a millisecond.
    pub fn advance(&mut self, steps: u64) {
        for _ in 0..steps {
            self.tick();
        }
    }

    fn tick(&mut self) {
        self.ticks += 1;
        if self.state == State::NotReadyToSwitchOn {
            self.state = State::SwitchOnDisabled;
        }
        self.obey();
        // The twin follows the set-point of this instant, and then set-point and axis are those of the next.
        let demand = self.demanded();
        self.twin.demand(demand);
        self.twin.advance(POSITION_EVERY);
        self.follow();
        self.supervise();
        self.end();
    }

    /// Reads an object.
    ///
    /// # Errors
    /// No such object.
    pub fn read(&self, at: Address) -> Result<Value, Abort> {
        let entry = self.dictionary.entry(at)?;
        if let Some(live) = self.live(at) {
            let [least, most] = entry.data_type.range();
            return Ok(Value::Number(live.clamp(least, most)));
        }
        Ok(self.dictionary.stored(at).cloned().unwrap_or(Value::Number(0)))
    }

    /// An object that the drive itself changes.
    fn live(&self, at: Address) -> Option<i64> {
        let reading = self.reading();
        let [position, speed, _] = self.demand;
        let rated_a = self.rated_a();
        let flag = i64::from;
        let plain = |value: f64| bounded(value, i64::from(i32::MIN), i64::from(u32::MAX));
        Some(match (at.index, at.sub) {
            (0x1001, 0) => self.trouble.map_or(0, |trouble| i64::from(trouble.register())),
            (0x1003, 0) => i64::try_from(self.errors.len()).unwrap_or(0),
            (0x1003, place) => i64::from(self.errors.get(usize::from(place) - 1).copied().unwrap_or(0)),
            (0x2000, 0) => i64::try_from(self.ticks / 2).unwrap_or(i64::MAX) & i64::from(u32::MAX),
            (0x2001, 0) => plain(10.0 * (reading.sensor_k? - 273.15)),
            (0x2002, 0) => plain(1000.0 * reading.overload),
            (0x2003, 0) => flag(reading.braked),
            (0x603F, 0) => self.trouble.map_or(0, |trouble| i64::from(trouble.code())),
            (0x6041, 0) => i64::from(self.status_word()),
            (0x6061, 0) => self.mode.number(),
            (0x6062, 0) => self.scale.position(position),
            (0x6064, 0) => self.scale.position(reading.position_rad),
            (0x606B, 0) => self.scale.speed(speed),
            (0x606C, 0) => self.scale.speed(reading.speed_rad_s),
            // The torque is taken as proportional to the current, both over their stall values.
            (0x6077 | 0x6078, 0) => plain(1000.0 * self.sign() * reading.current_a / rated_a),
            (0x6079, 0) => plain(1000.0 * reading.link_v),
            (0x60F4, 0) => self.scale.difference(self.following_rad()),
            _ => return None,
        })
    }

    /// The sign of a torque that drives towards rising positions.
    fn sign(&self) -> f64 {
        if self.scale.way(1) < 0.0 { -1.0 } else { 1.0 }
    }

    /// Writes a number into an object.
    ///
    /// # Errors
    /// Why it is not taken; then nothing has changed.
    pub fn write(&mut self, at: Address, value: i64) -> Result<(), Abort> {
        self.dictionary.check(at, value)?;
        match (at.index, at.sub) {
            (0x6060, 0) if Mode::of(value).is_none() => return Err(Abort::Value),
            // Stops at the limits of current and voltage are not simulated.
            (0x605A, 0) if matches!(value, 3 | 4) => return Err(Abort::Value),
            (0x608F | 0x6091 | 0x6092 | 0x607E, _) if self.state.has_torque() => return Err(Abort::State),
            (0x2010, 0) if disturbance(value) == ScenarioId::BatteryLoss && !self.has_battery => {
                return Err(Abort::Value);
            }
            (0x2010, 0) if disturbance(value) == ScenarioId::EncoderFailure && !self.twin.can_fail() => {
                return Err(Abort::Value);
            }
            // What fails with the battery is the supply of the drive's electronics.
            (0x2010, 0) if disturbance(value) == ScenarioId::BatteryLoss && self.state.has_torque() => {
                return Err(Abort::State);
            }
            (0x1400..=0x1403 | 0x1600..=0x1603 | 0x1800..=0x1803 | 0x1A00..=0x1A03, _) => {
                pdo::check(&self.dictionary, at, value)?;
            }
            _ => {}
        }
        self.dictionary.store(at.index, at.sub, value);
        match at.index {
            0x1003 => self.errors.clear(),
            0x2010 => self.disturb(disturbance(value)),
            0x6040 => self.take_control(value),
            0x6060 => self.take_mode(Mode::of(value).unwrap_or_default()),
            0x6072 | 0x6073 | 0x6075 => self.limit_current(),
            0x607A => self.take_position(value),
            0x607E | 0x608F | 0x6091 | 0x6092 => self.scale.follow(&self.dictionary),
            _ => {}
        }
        Ok(())
    }

    /// What happens to the axis. A lost battery is no fault that the drive sees: the encoder reports a valid word whose turns are
    /// wrong (cha-manual section 6.22); they begin at zero, as in `feedback`.
    fn disturb(&mut self, what: ScenarioId) {
        self.twin.disturb(what);
        if what == ScenarioId::BatteryLoss {
            self.scale.lose_turns(self.reading().position_rad);
        }
    }

    #[allow(clippy::cast_precision_loss, reason = "32 bit")]
    pub(crate) fn rated_a(&self) -> f64 {
        self.dictionary.number(0x6075, 0).max(1) as f64 / 1000.0
    }

    #[allow(clippy::cast_precision_loss, reason = "16 bit")]
    fn limit_current(&mut self) {
        let share = self.dictionary.number(0x6072, 0).min(self.dictionary.number(0x6073, 0)) as f64 / 1000.0;
        self.twin.limit_current(share * self.rated_a());
    }

    /// What the supervision found, and the following error.
    fn supervise(&mut self) {
        let found = self.twin.present().iter().find_map(|event| Trouble::of(*event, &self.twin));
        if let Some(trouble) = found {
            self.raise(trouble);
        }
        if self.twin.is_over() {
            self.raise(Trouble::Diverged);
        }
        let window = self.dictionary.number(0x6065, 0);
        let follows = self.state == State::OperationEnabled && self.mode.is_position();
        if follows && window != i64::from(u32::MAX) && self.is_beyond() {
            self.beyond_s += HALF_MS_S;
            #[allow(clippy::cast_precision_loss, reason = "16 bit")]
            let longest = self.dictionary.number(0x6066, 0) as f64 / 1000.0;
            if self.beyond_s > longest + 1e-9 {
                self.raise(Trouble::Following);
            }
        } else {
            self.beyond_s = 0.0;
        }
    }

    /// Whether the following error is beyond its window.
    pub(crate) fn is_beyond(&self) -> bool {
        let window = self.scale.plain_rad(self.dictionary.number(0x6065, 0));
        self.following_rad().abs() > window
    }

    /// Set-point less position of the same instant \[rad\]; zero where no position is followed.
    fn following_rad(&self) -> f64 {
        let reading = self.reading();
        let [position, ..] = self.demand;
        if reading.pulses && self.mode != Mode::ProfileVelocity { position - reading.position_rad } else { 0.0 }
    }

    /// A fault: 13, and 14 where the axis is not braked.
    pub fn raise(&mut self, trouble: Trouble) {
        match self.state {
            State::Fault => return,
            State::FaultReactionActive => {
                if !trouble.can_ramp() {
                    self.disable(State::Fault);
                }
                return;
            }
            State::NotReadyToSwitchOn
            | State::SwitchOnDisabled
            | State::ReadyToSwitchOn
            | State::SwitchedOn
            | State::OperationEnabled
            | State::QuickStopActive => {}
        }
        self.trouble = Some(trouble);
        self.errors.insert(0, u32::from(trouble.code()));
        self.errors.truncate(usize::from(ERRORS_MOST));
        self.emergencies.push((trouble.code(), trouble.register()));
        let option = self.dictionary.number(0x605E, 0);
        if self.state.has_torque() && trouble.can_ramp() && option != 0 {
            self.state = State::FaultReactionActive;
            let rate = self.rate(if option == 1 { 0x6084 } else { 0x6085 });
            self.ending = Some(Ending { rate, then: Some(State::Fault), stands: false });
        } else {
            self.disable(State::Fault);
        }
    }

    /// Resets a fault whose cause is gone: 15.
    pub(crate) fn reset_fault(&mut self) {
        let remains =
            self.twin.present().iter().any(|event| Trouble::of(*event, &self.twin).is_some()) || self.twin.is_over();
        if self.state == State::Fault && !remains {
            self.trouble = None;
            self.emergencies.push((0, 0));
            self.state = State::SwitchOnDisabled;
        }
    }

    /// No torque from now on; the brake closes.
    pub(crate) fn disable(&mut self, to: State) {
        self.twin.switch_pulses_off();
        self.twin.command_brake(false);
        self.ending = None;
        self.course = Course::Hold;
        (self.waiting, self.acknowledged) = (None, false);
        (self.is_reached, self.within_s, self.is_at_limit) = (false, 0.0, false);
        self.state = to;
    }

    /// Warnings that the twin reports.
    pub(crate) fn warns(&self) -> bool {
        self.twin.present().contains(&EventKind::WindingWarning)
    }

    /// A deceleration of the objects [rad/s²].
    pub(crate) fn rate(&self, index: u16) -> f64 {
        self.scale.plain_rad(self.dictionary.number(index, 0)).max(1e-6)
    }

    /// The demand of the next step of the twin.
    fn demanded(&self) -> Demand {
        let [_, speed, _] = self.demand;
        if self.mode == Mode::ProfileVelocity { Demand::Speed(speed) } else { Demand::Position(self.demand) }
    }
}

/// The disturbance of a number in 2010h.
fn disturbance(value: i64) -> ScenarioId {
    const ALL: [ScenarioId; DISTURBANCES as usize] = [
        ScenarioId::Cycle,
        ScenarioId::BlockedLoad,
        ScenarioId::Collision,
        ScenarioId::EncoderFailure,
        ScenarioId::BatteryLoss,
        ScenarioId::PowerFailure,
        ScenarioId::LinkSag,
        ScenarioId::BrakeStuck,
    ];
    usize::try_from(value).ok().and_then(|place| ALL.get(place)).copied().unwrap_or_default()
}
