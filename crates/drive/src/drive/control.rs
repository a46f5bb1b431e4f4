//! Controlword, statusword and the transitions between states.

use super::{Drive, Ending, SetpointCourse};
use crate::course::SetpointLine;
use crate::mode::Mode;
use crate::state::{Command, State, transition};

/// Bits of the controlword.
const NEW_SET_POINT: u16 = 1 << 4;
const IMMEDIATE: u16 = 1 << 5;
const RELATIVE: u16 = 1 << 6;
const RESET: u16 = 1 << 7;
const HALT: u16 = 1 << 8;

impl Drive<'_> {
    /// Processes a written controlword.
    pub(super) fn take_control(&mut self, value: i64) {
        let new = u16::try_from(value).unwrap_or(0);
        let rising = new & !self.control;
        if (new ^ self.control) & HALT != 0 {
            // Bit 10 changes its meaning between target reached and at rest.
            (self.is_reached, self.within_s) = (false, 0.0);
        }
        self.control = new;
        if rising & RESET != 0 {
            self.reset_fault();
        }
        self.obey();
        if self.mode == Mode::ProfilePosition && self.state == State::OperationEnabled && self.ending.is_none() {
            if rising & NEW_SET_POINT != 0 {
                self.take_set_point();
            } else if new & NEW_SET_POINT == 0 && self.waiting.is_none() {
                self.acknowledged = false;
            }
        }
    }

    /// Returns `true` if the controller halts the axis.
    pub(crate) const fn is_halted(&self) -> bool {
        self.control & HALT != 0
    }

    /// Executes the command of the controlword while it causes transitions: 0Fh causes two from the state ready to
    /// switch on.
    pub(super) fn obey(&mut self) {
        for _ in 0..2 {
            let command = Command::of(self.control);
            let Some(found) = transition(self.state, command) else { return };
            if !self.pass(found.number, found.to) {
                return;
            }
        }
    }

    /// Executes a transition; returns `true` if the state changed.
    fn pass(&mut self, number: u8, to: State) -> bool {
        let option = |index| self.dictionary.number(index, 0);
        match number {
            3 if !self.reading().link_ready => return false,
            4 => self.enable(),
            // A stop in progress continues, unless a faster one is commanded.
            5 | 8 if self.ending.is_some() => return false,
            5 | 8 if option(if number == 5 { 0x605C } else { 0x605B }) == 1 => {
                self.ending = Some(Ending { rate: self.rate(0x6084), then: Some(to), stands: false });
                return false;
            }
            5 | 8 | 9 | 12 => self.disable(to),
            11 => match option(0x605A) {
                0 => self.disable(State::SwitchOnDisabled),
                code => {
                    let rate = self.rate(if matches!(code, 1 | 5) { 0x6084 } else { 0x6085 });
                    let then = (code < 5).then_some(State::SwitchOnDisabled);
                    self.ending = Some(Ending { rate, then, stands: false });
                    (self.is_reached, self.within_s) = (false, 0.0);
                    self.state = to;
                }
            },
            // Only from a quick stop that holds the axis.
            16 if option(0x605A) < 5 => return false,
            16 => {
                (self.ending, self.course, self.waiting) = (None, SetpointCourse::Hold, None);
                self.state = to;
            }
            _ => self.state = to,
        }
        true
    }

    /// Switches the torque on, opens the brake and sets the setpoint to the position of the axis.
    fn enable(&mut self) {
        self.twin.switch_on();
        self.twin.command_brake(true);
        let position = self.reading().position_rad;
        (self.demand, self.target_rad) = ([position, 0.0, 0.0], position);
        (self.course, self.waiting, self.acknowledged) = (SetpointCourse::Hold, None, false);
        (self.is_reached, self.was_halted, self.beyond_s) = (false, false, 0.0);
        self.state = State::OperationEnabled;
    }

    /// Ends a stop that has come to rest: the brake closes, then the state changes.
    pub(super) fn end(&mut self) {
        let Some(ending) = self.ending else { return };
        let reading = self.reading();
        let [fastest, _] = self.twin.most();
        let [_, wanted, _] = self.demand;
        if !ending.stands && (wanted != 0.0 || reading.speed_rad_s.abs() > 5e-3 * fastest) {
            return;
        }
        let Some(then) = ending.then else { return };
        if !ending.stands {
            self.twin.command_brake(false);
            self.ending = Some(Ending { stands: true, ..ending });
        }
        if !self.twin.has_brake() || reading.braked {
            self.disable(then);
        }
    }

    /// Accepts a setpoint of profile position: at once, or at the end of the move.
    fn take_set_point(&mut self) {
        let is_immediate = self.control & IMMEDIATE != 0;
        let moves = matches!(self.course, SetpointCourse::Move(_));
        if self.acknowledged && !is_immediate || (moves && !is_immediate && self.waiting.is_some()) {
            return;
        }
        let written = self.dictionary.number(0x607A, 0);
        let target = if self.control & RELATIVE == 0 {
            self.scale.angle(written)
        } else {
            self.target_rad + self.scale.way(written)
        };
        let target = self.within_limits(target);
        (self.target_rad, self.acknowledged, self.is_reached) = (target, true, false);
        if moves && !is_immediate {
            self.waiting = Some(target);
        } else {
            self.waiting = None;
            self.begin_move(target);
        }
    }

    /// Processes a written target position: in the cyclic mode it is the setpoint of the next period.
    pub(super) fn take_position(&mut self, value: i64) {
        let follows = self.state == State::OperationEnabled && self.ending.is_none() && !self.is_halted();
        if self.mode != Mode::CyclicPosition || !follows || self.is_held() {
            return;
        }
        let to = self.within_limits(self.scale.angle(value));
        let [from, speed, _] = self.demand;
        self.course = SetpointCourse::Line(SetpointLine::new(from, speed, to, self.period_s()));
    }

    /// Changes the mode: setpoints of the old mode are dropped, and a move is stopped along its ramp.
    pub(super) fn take_mode(&mut self, mode: Mode) {
        if mode == self.mode {
            return;
        }
        self.mode = mode;
        (self.course, self.waiting, self.acknowledged) = (SetpointCourse::Hold, None, false);
        (self.is_reached, self.was_halted, self.within_s, self.is_at_limit) = (false, false, 0.0, false);
        let [position, speed, _] = self.demand;
        self.target_rad = position;
        if mode == Mode::CyclicPosition {
            self.demand = [position, speed, 0.0];
        }
    }

    /// Returns the statusword.
    ///
    /// Bits 10 to 13 depend on the mode. Bit 10: target reached; at a halt, and at a quick stop that holds (605Ah 5 and
    /// 6), the axis is at rest. Bit 11: current or voltage at a limit, or a target limited by 607Dh, 607Fh or 6080h.
    ///
    /// # Source
    /// cia-402
    pub(crate) fn status_word(&self) -> u16 {
        let reading = self.reading();
        let bit = |number: u8, is_set: bool| u16::from(is_set) << number;
        let enabled = self.state == State::OperationEnabled;
        let follows = enabled && self.ending.is_none() && !self.is_halted() && !self.is_held();
        let (twelve, thirteen) = match self.mode {
            Mode::None => (false, false),
            Mode::ProfilePosition => (self.acknowledged, enabled && self.is_beyond()),
            Mode::ProfileVelocity => {
                let threshold = self.scale.plain_rad(self.dictionary.number(0x606F, 0));
                (reading.speed_rad_s.abs() <= threshold, false)
            }
            Mode::CyclicPosition => (follows, enabled && self.is_beyond()),
        };
        let at_limit = enabled
            && match self.mode {
                Mode::None => false,
                Mode::ProfilePosition | Mode::CyclicPosition => self.is_at_limit,
                Mode::ProfileVelocity => self.is_target_speed_cut(),
            };
        self.state.bits()
            | bit(4, reading.link_ready)
            | bit(7, self.warns())
            | bit(9, true)
            | bit(10, self.is_reached)
            | bit(11, reading.limited || at_limit)
            | bit(12, twelve)
            | bit(13, thirteen)
    }
}
