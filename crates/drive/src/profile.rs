//! Setpoints generated in each mode of operation.

use crate::course::{Move, MoveLimits, ramped};
use crate::drive::{Drive, HALF_MS_S, SetpointCourse};
use crate::mode::Mode;
use crate::state::State;

impl Drive<'_> {
    /// Returns `true` if the brake still holds the axis.
    pub(crate) fn is_held(&self) -> bool {
        self.twin.has_brake() && self.reading().braked
    }

    /// Returns the limits of a move.
    fn bounds(&self) -> MoveLimits {
        MoveLimits {
            speed: self.fastest(self.scale.plain_rad(self.dictionary.number(0x6081, 0))).max(1e-9),
            acceleration: self.rate(0x6083),
            deceleration: self.rate(0x6084),
        }
    }

    /// Returns a speed limited by 607Fh, 6080h and the actuator [rad/s].
    fn fastest(&self, speed: f64) -> f64 {
        let [permitted, _] = self.twin.most();
        let profile = self.scale.plain_rad(self.dictionary.number(0x607F, 0));
        let motor = self.scale.motor_rad(self.dictionary.number(0x6080, 0));
        speed.min(profile).min(motor).min(permitted)
    }

    /// Returns `true` if the target velocity 60FFh exceeds the limit.
    pub(crate) fn is_target_speed_cut(&self) -> bool {
        let written = self.scale.speed_rad(self.dictionary.number(0x60FF, 0)).abs();
        // The limits are rounded to one unit.
        written > self.fastest(written) + self.scale.plain_rad(1)
    }

    /// Returns a position limited by 607Dh \[rad\]; unlimited unless the lower limit is below the upper one.
    pub(crate) fn within_limits(&mut self, rad: f64) -> f64 {
        let [one, other] = [1, 2].map(|sub| self.dictionary.number(0x607D, sub));
        let whole = [i64::from(i32::MIN), i64::from(i32::MAX)];
        self.is_at_limit = false;
        if one >= other || [one, other] == whole {
            return rad;
        }
        let [a, b] = [one, other].map(|limit| self.scale.angle(limit));
        let within = rad.clamp(a.min(b), a.max(b));
        self.is_at_limit = within != rad;
        within
    }

    /// Returns the period of the cyclic mode \[s\]: value · 10^index.
    pub(crate) fn period_s(&self) -> f64 {
        let value = u8::try_from(self.dictionary.number(0x60C2, 1)).unwrap_or(1);
        let index = i32::try_from(self.dictionary.number(0x60C2, 2)).unwrap_or(-3);
        (f64::from(value) * 10_f64.powi(index)).max(HALF_MS_S)
    }

    /// Begins a move from the present setpoint.
    pub(crate) fn begin_move(&mut self, target: f64) {
        let [from, speed, _] = self.demand;
        self.course = SetpointCourse::Move(Move::new(from, speed, target, &self.bounds()));
        self.within_s = 0.0;
    }

    /// Determines the setpoint of the next step.
    pub(crate) fn follow(&mut self) {
        let reading = self.reading();
        if !reading.pulses {
            self.demand = [reading.position_rad, 0.0, 0.0];
            return;
        }
        if self.mode == Mode::ProfileVelocity {
            // The position setpoint follows the axis, so that another mode starts at its present position.
            let [_, speed, _] = self.demand;
            self.demand = [reading.position_rad, speed, 0.0];
        }
        let stop = self.ending.map(|ending| ending.rate).or_else(|| self.halted());
        if let Some(rate) = stop {
            self.brake_along(rate);
        } else if self.is_held() || self.state != State::OperationEnabled {
            self.brake_along(self.rate(0x6085));
        } else {
            self.drive_on();
        }
        self.judge();
    }

    /// Returns the deceleration of a halt [rad/s²], if the controller has set it.
    fn halted(&mut self) -> Option<f64> {
        if self.is_halted() && self.state == State::OperationEnabled {
            self.was_halted = true;
            let option = self.dictionary.number(0x605D, 0);
            return Some(self.rate(if option == 1 { 0x6084 } else { 0x6085 }));
        }
        if std::mem::take(&mut self.was_halted) {
            match self.course {
                SetpointCourse::Move(course) => self.begin_move(course.end),
                SetpointCourse::Line(_) | SetpointCourse::Hold => self.course = SetpointCourse::Hold,
            }
        }
        None
    }

    /// Reduces the speed of the setpoint at a deceleration [rad/s²].
    fn brake_along(&mut self, rate: f64) {
        let [position, speed, _] = self.demand;
        let bounds = MoveLimits { speed: 0.0, acceleration: rate, deceleration: rate };
        let next = ramped(speed, 0.0, &bounds, HALF_MS_S);
        self.demand = [
            position + 0.5 * (speed + next) * HALF_MS_S,
            next,
            if next == 0.0 { 0.0 } else { (next - speed) / HALF_MS_S },
        ];
    }

    /// Determines the setpoint of the present mode.
    fn drive_on(&mut self) {
        match (self.mode, &mut self.course) {
            (Mode::ProfileVelocity, _) => {
                let [position, speed, _] = self.demand;
                let written = self.scale.speed_rad(self.dictionary.number(0x60FF, 0));
                let wanted = self.fastest(written.abs()).copysign(written);
                let next = ramped(speed, wanted, &self.bounds(), HALF_MS_S);
                self.demand = [position, next, (next - speed) / HALF_MS_S];
            }
            (_, SetpointCourse::Move(course)) => {
                let (wanted, is_over) = course.step(HALF_MS_S);
                self.demand = wanted;
                if is_over {
                    self.course = SetpointCourse::Hold;
                    if let Some(target) = self.waiting.take() {
                        self.begin_move(target);
                        self.acknowledged = self.control & 1 << 4 != 0;
                    }
                }
            }
            (_, SetpointCourse::Line(line)) => {
                let (wanted, is_over) = line.step(HALF_MS_S);
                self.demand = wanted;
                if is_over {
                    self.course = SetpointCourse::Hold;
                }
            }
            (_, SetpointCourse::Hold) => {
                let rate = self.rate(0x6084);
                self.brake_along(rate);
            }
        }
    }

    /// Determines whether the target is reached: the axis has been inside the target window for the window time or, at
    /// a halt and at a quick stop that holds, is at rest. A stop that ends without torque never reaches the target.
    fn judge(&mut self) {
        let reading = self.reading();
        let [_, wanted, _] = self.demand;
        let number = |index| self.dictionary.number(index, 0);
        let threshold = self.scale.plain_rad(number(0x606F));
        let stands = wanted == 0.0 && reading.speed_rad_s.abs() <= threshold;
        let holds = self.state == State::QuickStopActive && self.ending.is_some_and(|ending| ending.then.is_none());
        let (is_within, time) = if holds {
            (stands, 0)
        } else if self.state != State::OperationEnabled || self.ending.is_some() {
            (false, 0)
        } else if self.is_halted() {
            (stands, 0)
        } else {
            match self.mode {
                Mode::None | Mode::CyclicPosition => (false, 0),
                Mode::ProfilePosition => {
                    let window = self.scale.plain_rad(number(0x6067));
                    let rests = matches!(self.course, SetpointCourse::Hold);
                    let off = (self.target_rad - reading.position_rad).abs();
                    (rests && off <= window, number(0x6068))
                }
                Mode::ProfileVelocity => {
                    let target = self.scale.speed_rad(number(0x60FF));
                    let window = self.scale.plain_rad(number(0x606D));
                    ((target - reading.speed_rad_s).abs() <= window, number(0x606E))
                }
            }
        };
        self.within_s = if is_within { self.within_s + HALF_MS_S } else { 0.0 };
        #[allow(clippy::cast_precision_loss, reason = "16 bit")]
        let longest = time as f64 / 1000.0;
        self.is_reached = is_within && self.within_s >= longest;
    }
}
