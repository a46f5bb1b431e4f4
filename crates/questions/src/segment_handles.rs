//! Handles at the ends of the segments in the picture of the cycle, for dragging.

use crate::moves::moves;
use axis::AxisProject;
use project::SegmentLaw;
use quantities::Unit;
use quantities::unit::{DEGREE, METRE_PER_SECOND, MILLIMETRE, REVOLUTION_PER_MINUTE};

/// The end of a segment in the picture of the position over time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SegmentHandle {
    /// Index of the segment, from zero.
    pub segment: usize,
    /// Instant \[s\] and position of the beginning, in the unit of the handles.
    pub from: (f64, f64),
    /// Instant \[s\] and position of the end, in the unit of the handles.
    pub to: (f64, f64),
    /// `true` if the distance can be dragged; otherwise only the time.
    pub goes: bool,
    /// Instant \[s\] and value of the largest speed of a move from rest to rest, in the unit of the speeds.
    pub peak: Option<(f64, f64)>,
}

/// The handles of a motion.
#[derive(Clone, Debug)]
pub struct SegmentHandles {
    /// Unit of the positions: that of the picture.
    pub unit: &'static Unit,
    /// Unit of the speeds: that of the picture.
    pub speed_unit: &'static Unit,
    /// Handles in the order of the segments; segments without a handle are left out.
    pub segment_handles: Vec<SegmentHandle>,
}

/// Returns the handles of a motion: for rest and constant speed in time, for a move from rest to rest in time and
/// distance. A recording cannot be dragged, nor can a move that begins or ends in motion, since it depends on its
/// neighbours.
#[must_use]
pub fn segment_handles(project: &AxisProject) -> SegmentHandles {
    let moves = moves(project);
    let (unit, speed_unit, per_output) = if moves.turns {
        (&DEGREE, &REVOLUTION_PER_MINUTE, 1.0)
    } else {
        (&MILLIMETRE, &METRE_PER_SECOND, moves.per_output)
    };
    let pieces = project.axis.motion.pieces();
    let grip = |(segment, each): (usize, &crate::Move<'_>)| {
        // The pieces are in the order of their segments.
        let [from, to] = [segment, segment + 1].map(|next| pieces.partition_point(|piece| piece.segment < next));
        let own = pieces.get(from..to)?;
        let first = own.first()?;
        let end = own.last()?.end();
        let rests = |speed: f64| speed.abs() < 1e-9;
        let goes = rests(first.speed_rad_s) && rests(end.speed_rad_s);
        if !each.law.stretches() || !goes && each.law != SegmentLaw::Law(project::choices::Law::Constant) {
            return None;
        }
        let shown = |position: f64| unit.from_si(position * per_output);
        let start = quantities::Measure::si(each.start);
        let (from, to) = (shown(first.position_rad), shown(end.position_rad));
        let until = start + quantities::Measure::si(each.duration);
        let goes = goes && from != to;
        let peak = goes.then(|| peak(own.iter())).map(|(time, speed)| (time, speed_unit.from_si(speed * per_output)));
        Some(SegmentHandle { segment, from: (start, from), to: (until, to), goes, peak })
    };
    SegmentHandles { unit, speed_unit, segment_handles: moves.moves.iter().enumerate().filter_map(grip).collect() }
}

/// Number of parts of a piece in which its largest speed is sought.
const PARTS: u32 = 48;

/// Returns the instant \[s\] and the value [rad/s] of the largest speed of pieces; of a plateau the middle.
fn peak<'p>(pieces: impl Iterator<Item = &'p motion::Piece>) -> (f64, f64) {
    let of = |piece: &'p motion::Piece| {
        (0..=PARTS)
            .map(move |part| piece.duration_s * f64::from(part) / f64::from(PARTS))
            .map(|t| (piece.start_s + t, piece.at(t).speed_rad_s))
    };
    let all: Vec<(f64, f64)> = pieces.flat_map(of).collect();
    let most = all.iter().map(|(_, speed)| speed.abs()).fold(0.0, f64::max);
    let mut plateau = all.iter().filter(|(_, speed)| speed.abs() >= most * (1.0 - 1e-9));
    let Some(first) = plateau.next() else { return (0.0, 0.0) };
    let last = plateau.next_back().unwrap_or(first);
    (f64::midpoint(first.0, last.0), first.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(motion: &str) -> SegmentHandles {
        let text = format!("format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1 kg m^2\"\n{motion}");
        segment_handles(&crate::read(&text).unwrap())
    }

    #[test]
    fn ends_stand_where_the_segments_end() {
        let found = found(
            "[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\ntime = \"0.5 s\"\n[[motion]]\nlaw = \"dwell\"\n\
             time = \"1 s\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"-30 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.4 s\"\n\
             brake = \"0.1 s\"\npause = \"0.2 s\"\n",
        );
        assert_eq!(found.unit.symbol, "°");
        let ends: Vec<_> = found.segment_handles.iter().map(|grip| (grip.segment, grip.to, grip.goes)).collect();
        let expected = [(0, (0.5, 90.0), true), (1, (1.5, 90.0), false), (2, (2.3, 0.0), true)];
        assert_eq!(ends.len(), 3);
        for ((segment, to, goes), wanted) in ends.into_iter().zip(expected) {
            assert_eq!((segment, goes), (wanted.0, wanted.2));
            assert!((to.0 - wanted.1.0).abs() < 1e-9 && (to.1 - wanted.1.1).abs() < 1e-6, "{to:?}");
        }
    }

    #[test]
    fn the_peak_of_a_move_is_in_the_middle_of_its_fastest_part() {
        let found = found(
            "[[motion]]\nlaw = \"trapezoid\"\ndistance = \"-90 deg\"\ntime = \"0.6 s\"\n[[motion]]\nlaw = \"dwell\"\n\
             time = \"1 s\"\n",
        );
        let peaks: Vec<_> = found.segment_handles.iter().map(|handle| handle.peak).collect();
        // Thirds: 1.5 times the mean speed of 25 1/min.
        let (time, speed) = peaks[0].unwrap();
        assert!((time - 0.3).abs() < 1e-9 && (speed + 37.5).abs() < 1e-9, "{time} {speed}");
        assert_eq!((peaks.len(), peaks[1], found.speed_unit.ascii), (2, None, "1/min"));
    }

    #[test]
    fn what_hangs_on_its_neighbours_is_not_pulled() {
        let found = found(
            "[[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\nspeed = \"20 1/min\"\nacceleration = \"30 rad/s^2\"\n\
             end_speed = \"20 1/min\"\n[[motion]]\nlaw = \"constant\"\nspeed = \"20 1/min\"\ntime = \"1 s\"\n[[motion]]\n\
             law = \"trapezoid\"\ndistance = \"90 deg\"\nspeed = \"20 1/min\"\nacceleration = \"30 rad/s^2\"\n\
             end_speed = \"0 1/min\"\n",
        );
        assert_eq!(
            found.segment_handles.iter().map(|grip| (grip.segment, grip.goes)).collect::<Vec<_>>(),
            [(1, false)]
        );
    }
}
