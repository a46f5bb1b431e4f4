//! Assumptions that only the computed motion shows.

use crate::assumption::{Assumption, Overrun};
use mechanism::Extra;
use quantities::Measure;
use sizing::Axis;

/// Adds moves that come back, recordings and cam tables that do not move, the noise at rest and the slow motion in the recordings of an axis, keys that do not do what they are stated
/// for, and the apparent accelerations due to the resolution of the recordings.
pub(crate) fn assumptions(axis: &Axis, found: &mut Vec<Assumption>) {
    let nothing = Extra::none();
    let mut put = |each: Assumption| {
        if !found.contains(&each) {
            found.push(each);
        }
    };
    for (index, stretch) in axis.motion.stretches().iter().enumerate() {
        if let (Some(plain), Some(solved)) = (stretch.overrun, stretch.solved) {
            put(Assumption::Overruns(Overrun {
                segment: index + 1,
                stated_rad: solved.distance.si(),
                plain_rad: plain.si(),
                travel_m_per_rad: axis.mechanism.travel_m_per_rad(),
            }));
        }
        // A move of a law covers a distance; a cam table may state one position alone.
        if stretch.solved.is_some_and(|solved| solved.speed.si() == 0.0) {
            put(Assumption::Motionless(index + 1, 0.0));
        }
    }
    for placed in axis.motion.recordings() {
        if !placed.recorded.turns() {
            put(Assumption::Motionless(placed.segment + 1, placed.recorded.hidden_rad_s()));
        }
        if let Some(noise) = placed.recorded.rest_noise() {
            put(Assumption::RecordedRest(noise));
        }
        if let Some(slow) = placed.recorded.slow_motion() {
            put(Assumption::RecordedSlow(slow));
        }
        if let Some(alternating) = placed.recorded.alternating() {
            put(Assumption::RecordedAlternating(alternating));
        }
        if placed.recorded.torque_noise_nm() > 0.0 {
            put(Assumption::RecordedTorqueNoise(placed.recorded.torque_noise_nm()));
        }
        if let Some(sparse) = placed.recorded.sparse() {
            put(Assumption::RecordedSparse(sparse));
        }
        for outliers in placed.recorded.outliers() {
            put(Assumption::RecordedOutliers(*outliers));
        }
        for remark in placed.recorded.remarks() {
            put(Assumption::RecordedKey(*remark));
        }
        if let Some(made_up) = placed.recorded.made_up() {
            let extra = axis.extras.get(placed.segment).unwrap_or(&nothing);
            let (first, _) = placed.recorded.ends_rad();
            // The samples are those of the mechanism; the inertia is that at the output, before a stage.
            let at_output = made_up.acceleration_rad_s2 * axis.mechanism.stage_ratio().abs();
            let torque_nm = axis.mechanism.inertia(first + placed.offset_rad, extra).si() * at_output;
            put(Assumption::RecordedSteps(made_up, torque_nm));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::assumption::Assumption;
    use crate::{AxisProject, Files, NoCatalogue};
    use std::io::{Cursor, Read, Result};

    /// One file under every name.
    struct One(String);

    impl Files for One {
        fn open(&self, _: &str) -> Result<Box<dyn Read>> {
            Ok(Box::new(Cursor::new(self.0.clone().into_bytes())))
        }
    }

    /// Segments without motion of a project with this first segment and this file.
    fn motionless(segment: &str, file: String) -> Vec<(usize, f64)> {
        let text = format!(
            "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1 kg m^2\"\n\
             [[motion]]\n{segment}\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n"
        );
        let read = AxisProject::read_all(&text, &One(file), &NoCatalogue::shared(), &|_, _| None)
            .unwrap_or_else(|faults| panic!("{faults:?}"));
        let found = read.iter().flat_map(|axis| axis.assumptions.clone());
        let of = |each| if let Assumption::Motionless(segment, hidden) = each { Some((segment, hidden)) } else { None };
        found.filter_map(of).collect()
    }

    /// A recording or a cam table with one position, or with speeds of zero, is listed; a motion, however slow, is not.
    #[test]
    fn a_segment_that_does_not_move_is_listed() {
        let moved = [vec![], vec![(1, 0.0)]];
        for samples in [3_u32, 4, 50, 400] {
            for place in [0.0, 12.3, -700.001] {
                for (column, step) in [("q [deg]", 0.01), ("q [deg]", 0.0), ("n [1/min]", 0.01), ("n [1/min]", 0.0)] {
                    if step > 0.0 && samples < 20 {
                        continue; // too few for a start from rest
                    }
                    // A swing to the other side and back between two rests.
                    let row = |k: u32| {
                        let share = (f64::from(k) / f64::from(samples - 1)).mul_add(2.0, -0.5).clamp(0.0, 1.0);
                        let way = (std::f64::consts::PI * share).sin().powi(3);
                        let from = if column.starts_with('q') { place } else { 0.0 };
                        format!("{},{},1\n", 0.01 * f64::from(k), from + step * way)
                    };
                    let file = format!("t [s],{column},M [Nm]\n{}", (0..samples).map(row).collect::<String>());
                    let found = motionless("law = \"recorded\"\nfile = \"a.csv\"", file);
                    assert_eq!(found, moved[usize::from(step == 0.0)], "{samples} {place} {column} {step}");
                }
            }
        }
        for (last, is_still) in [("0 deg", true), ("1 deg", false)] {
            let points = "[\"0 s\", \"0 deg\"], [\"1 s\", \"0 deg\"]";
            let cam = format!(
                "law = \"points\"\nspline = \"cubic\"\nends = \"rest\"\npoints = [{points}, [\"2 s\", \"{last}\"]]"
            );
            assert_eq!(motionless(&cam, String::new()), moved[usize::from(is_still)], "{cam}");
        }
    }

    #[test]
    fn a_standstill_above_all_speeds_is_listed_with_the_largest() {
        let row = |k: u32| format!("{},{}\n", 0.01 * f64::from(k), (0.05 * f64::from(k)).sin().powi(2));
        let file = format!("t [s],n [1/min]\n{}", (0..=63).map(row).collect::<String>());
        for (standstill, is_still) in [("0.9 1/min", false), ("1.1 1/min", true), ("100 1/min", true)] {
            let segment = format!("law = \"recorded\"\nfile = \"a.csv\"\nstandstill = \"{standstill}\"");
            let found = motionless(&segment, file.clone());
            assert_eq!(found.len(), usize::from(is_still), "{standstill}: {found:?}");
            let largest = std::f64::consts::TAU / 60.0;
            assert!(found.iter().all(|(_, hidden)| (hidden / largest - 1.0).abs() < 1e-3), "{standstill}: {found:?}");
        }
    }
}
