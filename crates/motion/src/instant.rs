//! State of a motion at an instant.

use crate::chain::Motion;
use crate::piece::State;
use crate::placed::Placed;
use quantities::{Measure, Time};

/// Share of the duration by which an instant may lie before the beginning of a piece that begins with it: rounding only.
const SAME_INSTANT: f64 = 1e-12;

impl Motion {
    /// Returns the state at an instant from the start of the cycle; before it the initial, behind it the final state. An instant at
    /// which the acceleration jumps has that behind the jump.
    #[must_use]
    pub fn at(&self, instant: Time) -> State {
        let t = instant.si();
        let near = SAME_INSTANT * self.duration().si();
        let begun = |start_s: f64| start_s <= t + near;
        let (pieces, recordings) = (self.pieces(), self.recordings());
        let piece = pieces.partition_point(|piece| begun(piece.start_s)).saturating_sub(1);
        let placed = recordings.partition_point(|placed| begun(placed.start_s)).checked_sub(1);
        let placed = placed.and_then(|place| recordings.get(place));
        match (pieces.get(piece), placed) {
            (Some(piece), Some(placed)) if placed.start_s < piece.start_s && begun(piece.start_s) => {
                of_piece(piece, t, near)
            }
            (_, Some(placed)) => of_recording(placed, t - placed.start_s, near),
            (Some(piece), None) if begun(piece.start_s) || recordings.is_empty() => of_piece(piece, t, near),
            (_, None) => recordings.first().map_or_else(State::default, |first| of_recording(first, 0.0, near)),
        }
    }
}

fn of_piece(piece: &crate::piece::Piece, t: f64, near: f64) -> State {
    let t = t - piece.start_s;
    if t >= piece.duration_s - near { piece.end() } else { piece.at(t.max(0.0)) }
}

/// Returns the state at a time from the first sample: the speed linear between two samples.
fn of_recording(placed: &Placed, t: f64, near: f64) -> State {
    let after = placed.recorded.time_s().partition_point(|sample| sample * placed.stretch <= t + near);
    let index = after.saturating_sub(1).min(placed.intervals().saturating_sub(1));
    let Some(interval) = placed.interval(index) else { return State::default() };
    let share = ((placed.start_s + t - interval.start_s) / interval.duration_s).clamp(0.0, 1.0);
    let (position_rad, speed_rad_s, _) = interval.at(share);
    State { position_rad, speed_rad_s, acceleration_rad_s2: interval.acceleration_rad_s2() }
}
