//! The set-points that a drive makes itself: a move with trapezoidal speed, a ramp of the speed, an interpolation.

/// Where the axis shall be at an instant: position \[rad\], speed [rad/s], acceleration [rad/s²].
pub(crate) type Wanted = [f64; 3];

/// Bounds of a move: speed [rad/s], acceleration and deceleration [rad/s²], all positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) speed: f64,
    pub(crate) acceleration: f64,
    pub(crate) deceleration: f64,
}

/// A part of constant acceleration.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Part {
    duration_s: f64,
    from: f64,
    speed: f64,
    acceleration: f64,
}

/// A move to a position from any state, at rest at its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Move {
    parts: [Part; 5],
    pub(crate) end: f64,
    /// Time since its beginning \[s\].
    time_s: f64,
}

impl Move {
    /// The quickest move with trapezoidal speed: first back within the bounds or to rest where the target lies behind.
    pub(crate) fn new(from: f64, speed: f64, to: f64, bounds: &Bounds) -> Self {
        let mut made = Self { parts: [Part::default(); 5], end: to, time_s: 0.0 };
        let mut places = made.parts.iter_mut();
        let (mut at, mut now) = (from, speed);
        let mut add = |at: &mut f64, now: &mut f64, next: f64, rate: f64| {
            let duration_s = (next - *now).abs() / rate;
            let acceleration = if next > *now { rate } else { -rate };
            if let Some(place) = places.next() {
                *place = Part { duration_s, from: *at, speed: *now, acceleration };
            }
            *at += 0.5 * (*now + next) * duration_s;
            *now = next;
        };
        let stop = |now: f64| 0.5 * now * now / bounds.deceleration;
        let way = to - at;
        if now != 0.0 && (way * now <= 0.0 || stop(now) > way.abs()) {
            add(&mut at, &mut now, 0.0, bounds.deceleration);
        } else if now.abs() > bounds.speed {
            let within = bounds.speed.copysign(now);
            add(&mut at, &mut now, within, bounds.deceleration);
        }
        let way = to - at;
        let side = if way < 0.0 { -1.0 } else { 1.0 };
        // v² (1/a + 1/d) = 2 s + v_0²/a: the speed that is reached without a part of constant speed.
        let (a, d) = (bounds.acceleration, bounds.deceleration);
        let highest = ((2.0 * way.abs() + now * now / a) / (1.0 / a + 1.0 / d)).max(0.0).sqrt();
        let top = highest.min(bounds.speed).max(now.abs());
        add(&mut at, &mut now, side * top, a);
        let rest = ((to - at).abs() - stop(top)).max(0.0);
        let cruise = if top > 0.0 { rest / top } else { 0.0 };
        if let Some(place) = made.parts.iter_mut().skip(2).find(|part| part.duration_s == 0.0) {
            let (from, speed) = (at, now);
            *place = Part { duration_s: cruise, from, speed, acceleration: 0.0 };
        }
        let from = at + side * rest;
        if let Some(last) = made.parts.last_mut() {
            *last = Part { duration_s: top / d, from, speed: side * top, acceleration: -side * d };
        }
        made
    }

    /// Duration \[s\].
    #[cfg(test)]
    pub(crate) fn duration_s(&self) -> f64 {
        self.parts.iter().map(|part| part.duration_s).sum()
    }

    /// Goes on; the state, and whether the end is reached.
    pub(crate) fn step(&mut self, step_s: f64) -> (Wanted, bool) {
        self.time_s += step_s;
        let mut time = self.time_s;
        for part in &self.parts {
            if time < part.duration_s {
                let speed = part.speed + part.acceleration * time;
                return ([part.from + 0.5 * (part.speed + speed) * time, speed, part.acceleration], false);
            }
            time -= part.duration_s;
        }
        ([self.end, 0.0, 0.0], true)
    }
}

/// A speed on its way to another: what it is after a step.
pub(crate) fn ramped(now: f64, wanted: f64, bounds: &Bounds, step_s: f64) -> f64 {
    let faster = wanted.abs() > now.abs() && wanted * now >= 0.0;
    let most = step_s * if faster { bounds.acceleration } else { bounds.deceleration };
    if (wanted - now).abs() <= most { wanted } else { now + most.copysign(wanted - now) }
}

/// A line from the position of now to a set-point, for the time of one period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Line {
    from: f64,
    to: f64,
    speed_before: f64,
    period_s: f64,
    time_s: f64,
}

impl Line {
    pub(crate) const fn new(from: f64, speed_before: f64, to: f64, period_s: f64) -> Self {
        Self { from, to, speed_before, period_s, time_s: 0.0 }
    }

    /// Goes on; behind its end the set-point stands. The change of speed at its start counts as an acceleration over the period.
    pub(crate) fn step(&mut self, step_s: f64) -> (Wanted, bool) {
        self.time_s += step_s;
        let speed = (self.to - self.from) / self.period_s;
        if self.time_s > self.period_s + 1e-9 {
            return ([self.to, 0.0, 0.0], true);
        }
        let share = (self.time_s / self.period_s).min(1.0);
        let acceleration = (speed - self.speed_before) / self.period_s;
        ([self.from + share * (self.to - self.from), speed, acceleration], false)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may fail")]
mod tests {
    use super::*;

    const BOUNDS: Bounds = Bounds { speed: 2.0, acceleration: 4.0, deceleration: 8.0 };

    /// Position and speed have no jump, bounds are kept, the end is the target at rest.
    fn followed(from: f64, speed: f64, to: f64) -> f64 {
        let mut course = Move::new(from, speed, to, &BOUNDS);
        let (step, mut before) = (1e-4, [from, speed, 0.0]);
        let duration = course.duration_s();
        let mut time = 0.0;
        loop {
            let (now, over) = course.step(step);
            let [position, velocity, _] = now;
            assert!((position - before[0] - 0.5 * step * (velocity + before[1])).abs() < 1e-6, "{from} {speed} {to}");
            assert!((velocity - before[1]).abs() < 8.0 * step + 1e-9, "{from} {speed} {to} at {time}");
            assert!(velocity.abs() <= 2.0_f64.max(speed.abs()) + 1e-9);
            before = now;
            time += step;
            if over {
                break;
            }
        }
        assert_eq!(before, [to, 0.0, 0.0]);
        assert!((time - duration).abs() <= 2.0 * step);
        duration
    }

    /// 10 rad: 0.5 s up, 0.25 s down, 9.25 rad at 2 rad/s; 0.3 rad: triangle with v² = 0.6/(1/4 + 1/8).
    #[test]
    fn a_move_is_a_trapezoid_or_a_triangle() {
        assert!((followed(0.0, 0.0, 10.0) - 5.375).abs() < 1e-9);
        let top = 1.6_f64.sqrt();
        assert!((followed(1.0, 0.0, 0.7) - top * 0.375).abs() < 1e-9);
        assert_eq!(Move::new(1.0, 0.0, 1.0, &BOUNDS).duration_s(), 0.0);
    }

    #[test]
    fn a_move_begins_in_any_state() {
        for speed in [-3.0, -2.0, -0.5, 0.0, 0.4, 1.9, 2.0, 3.5] {
            for to in [-4.0, -0.3, -1e-6, 0.0, 0.02, 0.2, 0.5, 7.0] {
                followed(0.0, speed, to);
            }
        }
    }

    #[test]
    fn a_speed_is_ramped_with_its_bounds() {
        let step = |now, wanted| ramped(now, wanted, &BOUNDS, 0.1);
        assert_eq!((step(0.0, 2.0), step(1.9, 2.0)), (0.4, 2.0));
        assert_eq!((step(2.0, 0.0), step(2.0, -1.0)), (1.2, 1.2));
        assert!((step(-0.3, -2.0) + 0.7).abs() < 1e-12);
    }

    #[test]
    fn a_line_ends_at_its_set_point_and_stands() {
        let mut line = Line::new(1.0, 0.0, 2.0, 0.01);
        assert_eq!(line.step(0.005), ([1.5, 100.0, 10_000.0], false));
        assert!(!line.step(0.005).1);
        assert_eq!(line.step(0.005), ([2.0, 0.0, 0.0], true));
    }
}
