//! The shape of a law of motion, for its picture in a choice.

use axis::law_sample;
use motion::{Closing, Motion};
use project::SegmentLaw;
use quantities::Measure;

/// Points of a shape: time, position, speed and acceleration, each as a share of its largest value.
pub(crate) type Shape = Vec<[f64; 4]>;

/// Points in one piece.
const PER_PIECE: u32 = 12;

/// Returns the course of a law from rest to rest, each quantity as a share of its largest magnitude; empty for a
/// recording, which has no shape of its own.
#[must_use]
pub fn law_shape(law: SegmentLaw) -> Shape {
    let motion = law_sample(law).and_then(|segment| Motion::new(&[segment], None, Closing::SingleMove).ok());
    motion.map(|motion| shape(&motion)).unwrap_or_default()
}

/// Returns C_v = v_max T/s and C_a = a_max T²/s of a law from rest to rest; `None` if they depend on its values or the
/// law is none of a move.
#[must_use]
pub fn law_peaks(law: SegmentLaw) -> Option<[f64; 2]> {
    use project::choices::Law;
    if law.of_a_move().is_none_or(|own| matches!(own, Law::Jerk | Law::Constant)) {
        return None;
    }
    let motion = Motion::new(&[law_sample(law)?], None, Closing::SingleMove).ok()?;
    let solved = motion.stretches().first()?.solved?;
    let (s, t) = (solved.distance.si().abs(), solved.time.si());
    Some([solved.speed.si() * t / s, solved.acceleration.si() * t * t / s])
}

fn shape(motion: &Motion) -> Shape {
    let mut points = Shape::new();
    for piece in motion.pieces() {
        for part in 0..=PER_PIECE {
            let t = piece.duration_s * f64::from(part) / f64::from(PER_PIECE);
            let state = piece.at(t);
            points.push([piece.start_s + t, state.position_rad, state.speed_rad_s, state.acceleration_rad_s2]);
        }
    }
    for place in 0..4 {
        let of = |point: &[f64; 4]| point.get(place).map_or(0.0, |value| value.abs());
        let largest = points.iter().map(of).fold(0.0, f64::max);
        if largest > 0.0 {
            points.iter_mut().filter_map(|point| point.get_mut(place)).for_each(|value| *value /= largest);
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use project::choices::Law;

    #[test]
    fn every_law_has_a_shape_of_its_own_from_rest_to_rest() {
        let mut seen: Vec<Shape> = Vec::new();
        for law in SegmentLaw::all().filter(|law| *law != SegmentLaw::Recorded) {
            let shape = law_shape(law);
            assert!(shape.len() > usize::try_from(PER_PIECE).unwrap_or(0), "{law:?}");
            assert!(shape.iter().flatten().all(|value| value.is_finite() && value.abs() <= 1.0), "{law:?}");
            // A law that is not decided has the shape of the assumed one.
            assert_eq!(seen.contains(&shape), law == SegmentLaw::Open, "{law:?}");
            let moves = !matches!(law, SegmentLaw::Dwell);
            let last = shape.last().copied().unwrap_or_default();
            assert!((last[0] - 1.0).abs() < 1e-9, "{law:?}");
            assert_eq!((last[1] - 1.0).abs() < 1e-9, moves, "{law:?}");
            if !matches!(law, SegmentLaw::Law(Law::Constant)) {
                assert!(last[2].abs() < 1e-9, "{law:?} ends at rest");
            }
            seen.push(shape);
        }
        assert!(law_shape(SegmentLaw::Recorded).is_empty());
    }

    /// Compares the peak factors with VDI 2143-1.
    #[test]
    fn the_peak_factors_are_the_published_ones() {
        for (law, speed, acceleration) in [
            ("trapezoid", 1.5, 4.5),
            ("triangle", 2.0, 4.0),
            ("polynomial_5", 1.88, 5.77),
            ("modified_sine", 1.76, 5.53),
            ("modified_trapezoid", 2.0, 4.89),
            ("simple_sine", 1.57, 4.93),
            ("inclined_sine", 2.0, std::f64::consts::TAU),
        ] {
            let [v, a] = law_peaks(SegmentLaw::of_id(law).unwrap()).unwrap();
            assert!((v - speed).abs() < 0.006 && (a - acceleration).abs() < 0.006, "{law}: {v} {a}");
        }
        for law in ["dwell", "manual", "jerk", "constant", "recorded", "points"] {
            assert_eq!(law_peaks(SegmentLaw::of_id(law).unwrap()), None, "{law}");
        }
    }
}
