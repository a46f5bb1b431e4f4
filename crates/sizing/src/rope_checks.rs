//! Ropes that hold a load: tension over the cycle, and the instants at which they would be slack.

use crate::axis::Axis;
use crate::check::{Amount, Check, CheckId, Direction, Verdict};
use crate::comparison::unjudged;
use crate::flange::output;
use crate::list::Outcome;
use crate::notes::{Note, Notes, RopeSlack};
use actuator::Drivetrain;
use derivation::{Finding, Workings};
use mechanism::{Extra, Output, Rope};
use numeric::{First, lobatto, roots};
use provenance::{Grade, Missing, Source};
use quantities::unit::NEWTON;
use quantities::{Force, Measure, Time};

const MODEL: Source = Source::Model { name: "mechanisms" };

/// Tension of the ropes of a mechanism over the cycle.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RopeCourse {
    /// Instant at which the motion takes the largest share of the static load off the rope.
    worst: Instant,
    /// Times with a slack rope, of each rope in their order.
    slack: Vec<(Rope, Time, Time)>,
}

/// Tension of a rope at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Instant {
    at_s: f64,
    tension_n: f64,
    /// Tension of the weight alone, in the same position at rest \[N\].
    weight_n: f64,
}

impl Instant {
    /// Returns the force that motion and process take off the rope \[N\].
    fn taken_n(&self) -> f64 {
        self.weight_n - self.tension_n
    }

    /// Returns the share of the weight that is taken off; above one the rope is slack.
    fn share(&self) -> f64 {
        if self.weight_n > 0.0 {
            self.taken_n() / self.weight_n
        } else if self.is_slack() {
            f64::INFINITY
        } else {
            0.0
        }
    }

    /// Returns `true` if the rope would have to push.
    fn is_slack(&self) -> bool {
        !Direction::AtMost.keeps(self.taken_n(), self.weight_n)
    }
}

/// Number of evaluated panels of a piece, and of the nodes of each.
const PANELS: u32 = 8;
const NODES: usize = 16;

impl Axis {
    /// Returns the number of instants at which the tension of the ropes is computed in one walk over the cycle; zero
    /// without a rope.
    #[must_use]
    pub fn rope_instants(&self) -> f64 {
        if !self.mechanism.has_rope() {
            return 0.0;
        }
        let recorded: usize = self.motion.recordings().iter().map(motion::Placed::intervals).sum();
        (self.motion.pieces().len() * PANELS as usize * NODES + 2 * recorded) as f64
    }
}

impl RopeCourse {
    /// Evaluates the ropes of an axis; `None` without any.
    pub(crate) fn of(axis: &Axis) -> Option<Self> {
        let (mut worst, mut slack) = (First::above(f64::NEG_INFINITY, None), Vec::new());
        for rope in Rope::ALL {
            let mut found = OfRope { axis, rope, worst, slack: Vec::new() };
            found.pieces();
            found.recordings();
            worst = found.worst;
            slack.extend(found.slack.into_iter().map(|(from, to)| (rope, Time::from_si(from), Time::from_si(to))));
        }
        worst.place().map(|worst| Self { worst, slack })
    }
}

/// Course of one rope while it is computed.
struct OfRope<'a> {
    axis: &'a Axis,
    rope: Rope,
    worst: First<Option<Instant>>,
    slack: Vec<(f64, f64)>,
}

impl OfRope<'_> {
    fn instant(&self, segment: usize, at_s: f64, output: &Output, recorded_nm: f64) -> Option<Instant> {
        let none = Extra::none();
        let extra = self.axis.extras.get(segment).unwrap_or(&none);
        let tension =
            |output: &Output, recorded_nm| self.axis.mechanism.rope_tension(self.rope, output, extra, recorded_nm);
        let still = Output { speed_rad_s: 0.0, acceleration_rad_s2: 0.0, direction: 0.0, ..*output };
        let laden = Extra { force: Force::from_si(0.0), ..*extra };
        let weight_n = self.axis.mechanism.rope_tension(self.rope, &still, &laden, 0.0)?;
        Some(Instant { at_s, tension_n: tension(output, recorded_nm)?, weight_n })
    }

    fn see(&mut self, instant: Instant) {
        self.worst.see(instant.share(), instant.at_s, Some(instant));
    }

    /// Records a time with a slack rope; adjacent times are joined.
    fn add(&mut self, from: f64, to: f64) {
        let near = 1e-9 * self.axis.moments.duration.si().max(f64::MIN_POSITIVE);
        match self.slack.last_mut() {
            Some((_, end)) if (from - *end).abs() <= near => *end = to,
            _ => self.slack.push((from, to)),
        }
    }

    fn pieces(&mut self) {
        for piece in self.axis.motion.pieces() {
            // The sign of a computed speed would be that of its rounding at the ends of a move.
            let runs = piece.runs();
            let at = |t: f64| {
                let state = output(piece, t, runs.direction(t));
                self.instant(piece.segment, piece.start_s + t, &state, 0.0)
            };
            let tension = |t: f64| at(t).map_or(0.0, |instant| instant.tension_n);
            let mut cuts = if piece.is_rest() { Vec::new() } else { roots(tension, piece.duration_s) };
            let panels = (0..PANELS).map(f64::from).flat_map(|panel| {
                lobatto(NODES).iter().map(move |(u, _)| (panel + u) / f64::from(PANELS) * piece.duration_s)
            });
            let extremes = piece.jerk_roots();
            let seen: Vec<Instant> = panels.chain(extremes).filter_map(at).collect();
            cuts.push(piece.duration_s);
            let mut from = 0.0;
            let mut slack = Vec::new();
            for to in cuts {
                if at(0.5 * (from + to)).is_some_and(|instant| instant.is_slack()) {
                    slack.push((piece.start_s + from, piece.start_s + to));
                }
                from = to;
            }
            seen.into_iter().for_each(|instant| self.see(instant));
            slack.into_iter().for_each(|(from, to)| self.add(from, to));
        }
    }

    fn recordings(&mut self) {
        for placed in self.axis.motion.recordings() {
            for interval in (0..placed.intervals()).filter_map(|index| placed.interval(index)) {
                let mut slack = [f64::INFINITY, f64::NEG_INFINITY];
                let [before, after] = interval.speed_rad_s;
                let ends = [0.0, 1.0].map(|share| {
                    let (position_rad, speed_rad_s, recorded) = interval.at(share);
                    let moving = if speed_rad_s == 0.0 { before + after } else { speed_rad_s };
                    let state = Output {
                        position_rad,
                        speed_rad_s,
                        acceleration_rad_s2: interval.acceleration_rad_s2(),
                        direction: if moving == 0.0 { 0.0 } else { moving.signum() },
                    };
                    let at_s = interval.start_s + share * interval.duration_s;
                    self.instant(placed.segment, at_s, &state, recorded)
                });
                let [Some(first), Some(last)] = ends else { return };
                for (instant, other) in [(first, last), (last, first)] {
                    self.see(instant);
                    if !instant.is_slack() {
                        continue;
                    }
                    // Within an interval the tension is assumed to be linear.
                    let end = if other.is_slack() {
                        other.at_s
                    } else {
                        instant.at_s
                            + (other.at_s - instant.at_s) * instant.tension_n / (instant.tension_n - other.tension_n)
                    };
                    slack = [slack[0].min(instant.at_s).min(end), slack[1].max(instant.at_s).max(end)];
                }
                if slack[1] > slack[0] {
                    self.add(slack[0], slack[1]);
                }
            }
        }
    }
}

/// Checks that the force taken off a rope by motion and process is at most the weight on it, S ≥ 0: a rope pulls and
/// cannot push. Beyond, the model of the axis does not hold.
pub(crate) fn tension(axis: &Axis, _: &Drivetrain, work: &mut Workings) -> Outcome {
    let id = CheckId::RopeTension;
    let course = axis.rope_course().ok_or(Missing { symbol: "S" })?;
    let worst = course.worst;
    work.found("S", &NEWTON, worst.tension_n, Finding::LeastTension, &MODEL, Grade::Computed);
    work.found("S_w", &NEWTON, worst.weight_n, Finding::TensionOfWeight, &MODEL, Grade::Computed);
    work.formula("S_off", &NEWTON, worst.taken_n(), "S_w - S", &MODEL);
    work.value("S_off");
    work.limit("S_w");
    let notes = if course.slack.is_empty() {
        Notes::NONE
    } else {
        Note::RopeSlack(Box::new(RopeSlack { times: course.slack.clone() })).into()
    };
    let share = worst.share();
    Ok(Check {
        verdict: if course.slack.is_empty() && !worst.is_slack() { Verdict::Pass } else { Verdict::Fail },
        value: Some(Amount { si: worst.taken_n(), unit: &NEWTON }),
        limit: Some(Amount { si: worst.weight_n, unit: &NEWTON }),
        utilisation: (share.is_finite() && share > 0.0).then_some(if worst.is_slack() {
            share
        } else {
            share.min(1.0)
        }),
        at: Some(Time::from_si(worst.at_s)),
        grade: Some(Grade::Computed),
        value_source: Some(MODEL),
        limit_source: Some(MODEL),
        notes,
        ..unjudged(id)
    })
}
