//! What is ordered and how it is screwed on, as rows of tables.

use crate::sizing_use::{Candidate, CandidateId};
use actuator::ScrewJoint;
use order_code::Field;
use provenance::Datum;
use quantities::unit::{MILLIMETRE, NEWTON_METRE};
use quantities::{Language, Measure, Unit, format_significant};
use serde_json::{Value, json};
use words::{describe_token, either, source_text};

/// Both joints: number and size of the screws, circle, tightening torque and what the joint transmits.
#[must_use]
pub fn screws(candidate: &Candidate<'_>, language: Language) -> Value {
    let joints = [
        (either(language, "load", "Last"), &candidate.parameters.screw_joint_load),
        (either(language, "housing", "Gehäuse"), &candidate.parameters.screw_joint_housing),
    ];
    joints.into_iter().map(|(name, joint)| row(&name, joint, language)).collect()
}

/// The actuator and the screws of both joints, as far as the tables name them: `item`, `quantity`, `code`, `text`,
/// `source`.
#[must_use]
pub fn bill_of_material(candidate: &Candidate<'_>, language: Language) -> Value {
    let mut rows = Vec::new();
    let mut add = |quantity: String, code: String, text: String, source: Option<String>| {
        let item = (rows.len() + 1).to_string();
        rows.push(json!({ "item": item, "quantity": quantity, "code": code, "text": text, "source": source }));
    };
    let parts = match &candidate.id {
        CandidateId::Code(code) => [Field::Size, Field::Ratio, Field::Winding, Field::Feedback]
            .into_iter()
            .chain(
                [Field::Brake, Field::Option1, Field::Option2].into_iter().filter(|field| code.token(*field).is_some()),
            )
            .map(|field| describe_token(code, field, language))
            .collect::<Vec<_>>()
            .join("; "),
        CandidateId::Own(_) => either(language, "own actuator", "eigener Antrieb"),
    };
    let series = either(language, "servo actuator with hollow shaft", "Servoantrieb mit Hohlwelle");
    add("1".into(), candidate.id.to_string(), format!("{series}; {parts}"), None);
    let joints = [
        (either(language, "screws between flange and load", "Schrauben zwischen Flansch und Last"), true),
        (either(language, "screws between housing and machine", "Schrauben zwischen Gehäuse und Maschine"), false),
    ];
    for (text, load) in joints {
        let parameters = candidate.parameters;
        let joint = if load { &parameters.screw_joint_load } else { &parameters.screw_joint_housing };
        let (Some(count), Some(size)) = (joint.count.known(), joint.size.known()) else { continue };
        let class = joint.grade.known().map_or_else(String::new, |class| format!(", {}", class.value));
        let length = either(language, "length after the part that is joined", "Länge nach dem verschraubten Teil");
        let source = source_text(&count.source, language);
        add(format!("{:.0}", count.value), format!("{}{class}", size.value), format!("{text}; {length}"), Some(source));
    }
    Value::Array(rows)
}

fn row(name: &str, joint: &ScrewJoint, language: Language) -> Value {
    fn shown<Q: Measure>(datum: &Datum<Q>, unit: &Unit, language: Language) -> String {
        // A printed figure in no more digits than it has.
        let number = |value: f64| {
            let text = format_significant(unit.from_si(value), 4, language);
            let point = if language == Language::De { ',' } else { '.' };
            let short = if text.contains(point) { text.trim_end_matches('0').trim_end_matches(point) } else { &text };
            short.to_owned()
        };
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
