//! Loads of a segment are added to those of the mechanism, and shown as they act.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use answers::Number;
use quantities::{Language, Measure, MomentOfInertia};

/// Mechanisms with a process force, and the mass of the load as a key.
const LINES: [(&str, &str); 5] = [
    ("screw", "lead = \"20 mm\"\nfriction_force = \"30 N\"\nmass"),
    ("belt", "pulley_diameter = \"60 mm\"\nfriction_force = \"30 N\"\nmass"),
    ("conveyor", "roller_diameter = \"60 mm\"\nfriction_force = \"30 N\"\nmass"),
    ("hoist", "drum_diameter = \"80 mm\"\nmass"),
    ("slider_crank", "crank = \"60 mm\"\nrod = \"200 mm\"\nstart_angle = \"30 deg\"\nmass"),
];

/// A cycle of two moves; `of_mechanism`: mass \[kg\], force \[N\], external torque \[Nm\]; `of_segments`: the same of each.
fn project(line: (&str, &str), of_mechanism: [f64; 3], of_segments: Option<[[f64; 3]; 2]>) -> axis::AxisProject {
    let (name, keys) = line;
    let [mass, force, torque] = of_mechanism;
    let mut text = format!(
        "format = 1\n[mechanism.{name}]\n{keys} = \"{mass} kg\"\nprocess_force = \"{force} N\"\n\
         external_torque = \"{torque} N m\"\n"
    );
    for (index, distance) in [90, -90].into_iter().enumerate() {
        text += &format!("[[motion]]\nlaw = \"trapezoid\"\ndistance = \"{distance} deg\"\ntime = \"1 s\"\n");
        if let Some([mass, force, torque]) = of_segments.map(|all| all[index]) {
            text +=
                &format!("payload = \"{mass} kg\"\nprocess_force = \"{force} N\"\nprocess_torque = \"{torque} N m\"\n");
        }
    }
    questions::read(&text).unwrap()
}

#[test]
fn loads_of_segments_are_added_and_shown_as_they_act() {
    for line in LINES {
        for [mass, force, torque] in [[3.0, 0.0, 0.0], [0.0, 500.0, 1.5], [2.0, -120.0, -0.5]] {
            let (own, both) = ([20.0, 1000.0, 2.0], [20.0 + mass, 1000.0 + force, 2.0 + torque]);
            let [split, whole] = [project(line, own, Some([[mass, force, torque]; 2])), project(line, both, None)];
            let demand = |project: &axis::AxisProject| {
                let demand = project.axis.demand(MomentOfInertia::from_si(0.02));
                [demand.torque_rms.si(), demand.torque_peak.si()]
            };
            for (split, whole) in demand(&split).into_iter().zip(demand(&whole)) {
                assert!((split - whole).abs() < 1e-9 * whole.abs(), "{} {split} {whole}", line.0);
            }
            let answer = questions::answer::motion(&questions::moves(&split), None, Language::En);
            for segment in &answer.segments {
                assert_eq!(
                    [segment.payload, segment.process_force, segment.external_torque],
                    [mass, both[1], both[2]].map(|value| Some(Number(value))),
                    "{}",
                    line.0
                );
                assert_eq!(segment.payload_inertia, None);
            }
            assert_eq!(answer.units.unit("process_force"), Some("N"));
            let answer = questions::answer::motion(&questions::moves(&whole), None, Language::En);
            assert!(answer.segments.iter().all(|segment| segment.process_force.is_none()), "nothing is stated");
        }
    }
}
