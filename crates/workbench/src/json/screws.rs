//! The screw joints of an actuator as rows of a table.

use crate::sizing_use::Candidate;
use crate::text::{either, source_text};
use actuator::ScrewJoint;
use provenance::Datum;
use quantities::unit::{MILLIMETRE, NEWTON_METRE};
use quantities::{Language, Measure, Unit, format_significant};
use serde_json::{Value, json};

/// Both joints: number and size of the screws, circle, tightening torque and what the joint transmits.
#[must_use]
pub fn screws(candidate: &Candidate<'_>, language: Language) -> Value {
    let joints = [
        (either(language, "load", "Last"), &candidate.parameters.screw_joint_load),
        (either(language, "housing", "Gehäuse"), &candidate.parameters.screw_joint_housing),
    ];
    joints.into_iter().map(|(name, joint)| row(&name, joint, language)).collect()
}

fn row(name: &str, joint: &ScrewJoint, language: Language) -> Value {
    fn shown<Q: Measure>(datum: &Datum<Q>, unit: &Unit, language: Language) -> String {
        let number = |value: f64| format_significant(unit.from_si(value), 4, language);
        datum.known().map_or_else(|| "–".to_owned(), |known| format!("{} {}", number(known.value.si()), unit.symbol))
    }
    let count = joint.count.known().map_or_else(String::new, |count| format!("{:.0} × ", count.value));
    let size = joint.size.known().map_or("–", |size| size.value.as_ref());
    let class = joint.grade.known().map_or_else(String::new, |class| format!(", {}", class.value));
    let transmitted = shown(&joint.transmissible_torque, &NEWTON_METRE, language);
    let source = joint.transmissible_torque.known().map(|known| source_text(&known.source, language));
    json!({
        "joint": name,
        "screws": format!("{count}{size}{class}"),
        "circle": shown(&joint.bolt_circle, &MILLIMETRE, language),
        "torque": shown(&joint.tightening_torque, &NEWTON_METRE, language),
        "text": either(language, format!("transmits {transmitted}, dry"), format!("überträgt {transmitted}, trocken")),
        "source": source,
    })
}
