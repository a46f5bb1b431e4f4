//! Handles at the ends of the segments in the picture of the cycle, for dragging.

use crate::moves::moves;
use axis::AxisProject;
use project::SegmentLaw;
use quantities::Unit;
use quantities::unit::{DEGREE, MILLIMETRE};

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
}

/// The handles of a motion.
#[derive(Clone, Debug)]
pub struct SegmentHandles {
    /// Unit of the positions: that of the picture.
    pub unit: &'static Unit,
    /// Handles in the order of the segments; segments without a handle are left out.
    pub segment_handles: Vec<SegmentHandle>,
}

/// Returns the handles of a motion: for rest and constant speed in time, for a move from rest to rest in time and
/// distance. A recording cannot be dragged, nor can a move that begins or ends in motion, since it depends on its
/// neighbours.
#[must_use]
pub fn segment_handles(project: &AxisProject) -> SegmentHandles {
    let moves = moves(project);
    let (unit, per_output) = if moves.turns { (&DEGREE, 1.0) } else { (&MILLIMETRE, moves.per_output) };
    let pieces = project.axis.motion.pieces();
    let grip = |(segment, each): (usize, &crate::Move<'_>)| {
        let mut own = pieces.iter().filter(|piece| piece.segment == segment);
        let first = own.next()?;
        let end = own.next_back().unwrap_or(first).end();
        let rests = |speed: f64| speed.abs() < 1e-9;
        let goes = rests(first.speed_rad_s) && rests(end.speed_rad_s);
        if !each.law.stretches() || !goes && each.law != SegmentLaw::Law(project::choices::Law::Constant) {
            return None;
        }
        let shown = |position: f64| unit.from_si(position * per_output);
        let start = quantities::Measure::si(each.start);
        let (from, to) = (shown(first.position_rad), shown(end.position_rad));
        let until = start + quantities::Measure::si(each.duration);
        Some(SegmentHandle { segment, from: (start, from), to: (until, to), goes: goes && from != to })
    };
    SegmentHandles { unit, segment_handles: moves.moves.iter().enumerate().filter_map(grip).collect() }
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
