//! Swings of the axis by rainflow counting: small ones keep the rolling elements of the bearing away from the
//! lubricant, independent of larger motion at other times.

use crate::axis::Axis;
use motion::Motion;
use quantities::unit::DEGREE;
use quantities::{Angle, Measure};

/// Share of the angle travelled from which small swings are reported.
const SHARE_REPORTED: f64 = 0.1;

/// Number per cycle from which small swings are reported.
const COUNT_REPORTED: usize = 2;

/// Range below which swings within a recording count as settling and noise \[deg\].
const NOISE_DEG: f64 = 0.1;

/// Swings of one cycle of the motion below the least one that its bearing bears without fretting.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct SmallSwings {
    /// Number of swings, each back and forth.
    pub(crate) count: usize,
    /// Largest of them.
    pub(crate) largest: Angle,
    /// Their share of the angle travelled.
    pub(crate) share: f64,
}

impl SmallSwings {
    /// Returns the swings of an axis below `least`.
    pub(crate) fn of(axis: &Axis, least: Angle) -> Self {
        let mut found = Self::default();
        let (mut largest, mut travelled) = (0.0_f64, 0.0);
        for &range in axis.swing_ranges() {
            if range < least.si() {
                found.count += 1;
                largest = largest.max(range);
                travelled += 2.0 * range;
            }
        }
        let all = axis.moments().angle_travelled.si();
        Self { largest: Angle::from_si(largest), share: if all > 0.0 { travelled / all } else { 0.0 }, ..found }
    }

    /// Returns `true` if they are to be reported.
    pub(crate) fn are_reported(&self) -> bool {
        self.count >= COUNT_REPORTED || self.share >= SHARE_REPORTED
    }
}

/// Returns the ranges of all closed swings of one cycle of the motion \[rad\].
pub(crate) fn swing_ranges(motion: &Motion) -> Vec<f64> {
    ranges(&turning_points(motion), motion.net().si())
}

/// Returns the positions at which one cycle of the motion reverses, with its beginning and its end.
fn turning_points(motion: &Motion) -> Vec<f64> {
    let mut turns = Turns::default();
    let mut recordings = motion.recordings().iter().peekable();
    let noise = DEGREE.to_si(NOISE_DEG);
    let recorded = |placed: &motion::Placed, turns: &mut Turns| {
        let positions = placed.recorded.position_rad();
        positions.iter().for_each(|position| turns.pass(position + placed.offset_rad, noise));
    };
    for piece in motion.pieces() {
        while let Some(placed) = recordings.next_if(|placed| placed.start_s < piece.start_s) {
            recorded(placed, &mut turns);
        }
        turns.pass(piece.position_rad, 0.0);
        for t in piece.reversals() {
            turns.pass(piece.at(t).position_rad, 0.0);
        }
        turns.pass(piece.end().position_rad, 0.0);
    }
    for placed in recordings {
        recorded(placed, &mut turns);
    }
    turns.points
}

/// Consecutive positions, reduced to those at which the axis reverses.
#[derive(Debug, Default)]
struct Turns {
    points: Vec<f64>,
}

impl Turns {
    /// Adds the next position; one that goes back by no more than `noise` is no turning point.
    fn pass(&mut self, position: f64, noise: f64) {
        match self.points.as_mut_slice() {
            [] => self.points.push(position),
            [only] => {
                if (position - *only).abs() > noise.max(ROUNDING) {
                    self.points.push(position);
                }
            }
            [.., before, last] => {
                let (forth, step) = (*last - *before, position - *last);
                if forth * step >= 0.0 {
                    *last = position;
                } else if step.abs() > noise.max(ROUNDING) {
                    self.points.push(position);
                }
            }
        }
    }
}

/// Rounding error of a position that returns to its start \[rad\].
const ROUNDING: f64 = 1e-9;

/// Returns the ranges of all closed swings of a motion that repeats, each back and forth.
///
/// # Source
/// ASTM E1049, rainflow counting of a repeating history
/// # Valid
/// `net`: increment of the position by each repetition; a motion that rotates endlessly never closes its largest swing
fn ranges(points: &[f64], net: f64) -> Vec<f64> {
    let mut open: Vec<f64> = Vec::with_capacity(points.len());
    let mut closed = Vec::new();
    // Swings left open by the first run are closed by the second, as in every later one.
    for run in [0.0, 1.0] {
        closed.clear();
        for point in points {
            let point = point + run * net;
            turn(&mut open, point);
            while let [.., a, b, c, d] = open.as_slice() {
                let (before, inner, after) = ((b - a).abs(), (c - b).abs(), (d - c).abs());
                if inner > before || inner > after {
                    break;
                }
                closed.push(inner);
                let last = *d;
                open.truncate(open.len() - 3);
                turn(&mut open, last);
            }
        }
    }
    closed
}

/// Adds a point to a history of turning points: one in the same direction replaces the last.
fn turn(history: &mut Vec<f64>, point: f64) {
    match history.as_mut_slice() {
        [.., before, last] if (*last - *before) * (point - *last) >= 0.0 => *last = point,
        [last] if (point - *last).abs() <= ROUNDING => {}
        _ => history.push(point),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mechanism::Mechanism;
    use motion::{Closing, Given, Law, SegmentSpec};
    use quantities::{MomentOfInertia, Time, Torque};

    fn sorted(mut ranges: Vec<f64>) -> Vec<f64> {
        ranges.sort_by(f64::total_cmp);
        ranges
    }

    /// Compares with the history of ASTM E1049-85, figures 6 and 7: repeated, it has the ranges 3, 4, 7 and 9, once
    /// each.
    #[test]
    fn the_history_of_the_standard() {
        let history = [-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0];
        assert_eq!(sorted(ranges(&history, 0.0)), [3.0, 4.0, 7.0, 9.0]);
        // From wherever it begins.
        for start in 0..history.len() - 1 {
            let mut turned: Vec<f64> = history[..8].to_vec();
            turned.rotate_left(start);
            assert_eq!(sorted(ranges(&turned, 0.0)), [3.0, 4.0, 7.0, 9.0], "{start}");
        }
    }

    /// Compares twice the ranges with the distance over a closed cycle.
    #[test]
    fn all_swings_together_are_the_way() {
        let mut state = 7_u64;
        let mut history = vec![0.0];
        for _ in 0..500 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            history.push(f64::from(u32::try_from(state >> 32).unwrap()) / 1e9);
        }
        history.push(0.0);
        let way: f64 = history.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
        let swings: f64 = ranges(&history, 0.0).iter().map(|range| 2.0 * range).sum();
        assert!((way - swings).abs() < 1e-9 * way, "{way} {swings}");
    }

    #[test]
    fn what_turns_on_swings_only_where_it_comes_back() {
        // 60° forth, 2° back, repeated.
        assert_eq!(sorted(ranges(&[0.0, 60.0, 58.0], 58.0)), [2.0]);
        assert!(ranges(&[0.0, 60.0], 60.0).is_empty());
    }

    fn axis(moves_deg: &[f64]) -> Axis {
        let segments: Vec<SegmentSpec> = moves_deg
            .iter()
            .map(|distance| {
                let given = Given {
                    distance: Some(Angle::new_in(*distance, &DEGREE)),
                    time: Some(Time::from_si(0.5)),
                    ..Given::default()
                };
                SegmentSpec::Move(Law::Triangle, given)
            })
            .collect();
        let motion = Motion::new(&segments, None, Closing::Position).unwrap();
        Axis::new(Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(0.0)), motion, Vec::new())
    }

    /// 90° and then two hundred swings of 2°: 800° of 980° are small.
    #[test]
    fn many_small_swings_beside_a_large_one_are_reported() {
        let mut moves = vec![90.0];
        moves.extend([-2.0, 2.0].repeat(200));
        moves.push(-90.0);
        let small = |moves: &[f64]| SmallSwings::of(&axis(moves), Angle::new_in(5.0, &DEGREE));
        let found = small(&moves);
        assert_eq!(found.count, 200);
        assert!((found.largest.in_unit(&DEGREE) - 2.0).abs() < 1e-6);
        assert!((found.share - 800.0 / 980.0).abs() < 1e-6 && found.are_reported());
        assert!(!small(&[90.0, -2.0, 2.0, -90.0]).are_reported(), "one small swing in 184°");
        assert!(!small(&[90.0, -90.0]).are_reported());
        assert!(small(&[4.0, -4.0]).are_reported());
        assert!(!small(&[5.0, -5.0]).are_reported(), "the manual warns below 5°");
    }
}
