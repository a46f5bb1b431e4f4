//! Real answers of the tool, with their projects, as reports. Shared by the tests and the example that draws pages.

#![allow(dead_code, missing_docs, unreachable_pub, reason = "two users, each with a part of it")]
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a sample that cannot be read shall fail")]

use report::{Content, Figure, Settings};
use serde_json::{Value, json};

/// Name, answers of the tool, project, language.
pub const SAMPLES: [(&str, &str, &str, quantities::Language); 4] = [
    (
        "indexing-table-en",
        include_str!("../data/indexing-table-en.json"),
        include_str!("../../../../examples/indexing-table.toml"),
        quantities::Language::En,
    ),
    (
        "indexing-table-fails-en",
        include_str!("../data/indexing-table-fails-en.json"),
        include_str!("../../../../examples/indexing-table.toml"),
        quantities::Language::En,
    ),
    (
        "robot-joint-de",
        include_str!("../data/robot-joint-de.json"),
        include_str!("../../../../examples/robot-joint.toml"),
        quantities::Language::De,
    ),
    (
        "screw-axis-de",
        include_str!("../data/screw-axis-de.json"),
        include_str!("../../../../examples/screw-axis.toml"),
        quantities::Language::De,
    ),
];

/// A diagram of the width and family of the real ones.
fn figure(name: &str, caption: &str) -> Figure {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 640 300' font-family='Inter' font-size='12'>\
        <rect x='60' y='16' width='560' height='236' fill='none' stroke='#444'/>\
        <path d='M60 252 L180 60 L420 60 L620 252' fill='none' stroke='#a2222b' stroke-width='2'/>\
        <path d='M60 200 H620' stroke='#1f4e9c' stroke-width='2' stroke-dasharray='6 4'/>\
        <text x='340' y='285' text-anchor='middle'>n / min⁻¹</text><text x='14' y='30'>T / Nm</text></svg>";
    Figure {
        name: name.to_owned(),
        svg: svg.to_owned(),
        caption: caption.to_owned(),
        alternative_text: format!("placeholder of {name}"),
    }
}

pub fn content(answers: &str, project: &str, language: quantities::Language) -> Content {
    let mut data: Value = serde_json::from_str(answers).unwrap();
    data["inputs"] = json!(report::inputs(project).unwrap());
    data["hash"] = json!({
        "project": "3f1c0b7a54d2e98811c6a7705be3f2d49a6b8e0c71d5f3a2947be86d10c2f5ab",
        "catalogue": "9be2770c41aa5d3e8f60b12c4d97e3a85f0c6d21b7e4a9380d5c6f1e2b3a4978",
    });
    let figures = vec![
        figure("motion:speed", "Angle, speed and acceleration over one cycle"),
        figure("torque_speed", "Torque-speed plane with T_max and n_max: continuous, short-time, cycle"),
        figure("thermal", "Winding and housing over one cycle"),
    ];
    Content { language, data, figures }
}

pub fn settings() -> Settings {
    Settings {
        date: Some("2026-11-21".to_owned()),
        revision: "B".to_owned(),
        project: "Assembly line 4".to_owned(),
        number: "AX-4711-02".to_owned(),
        author: "E. Example".to_owned(),
        company: "Example Engineering".to_owned(),
        pdf_a: true,
    }
}

/// Every mechanism with the keys its drawing can call out.
pub const MECHANISMS: [(&str, &[&str]); 9] = [
    ("load", &["inertia", "friction_torque", "viscous_friction", "external_torque"]),
    (
        "turntable",
        &["bodies[1].mass", "payload_distance", "friction_torque", "axis_tilt", "start_angle", "external_torque"],
    ),
    (
        "arm",
        &[
            "inertia",
            "mass",
            "centre_distance",
            "payload_distance",
            "start_angle",
            "friction_torque",
            "external_torque",
        ],
    ),
    ("screw", &["lead", "mass", "inertia", "friction_force", "process_force", "inclination", "efficiency"]),
    ("belt", &["pulley_diameter", "mass", "inertia", "friction_force", "process_force", "inclination"]),
    ("conveyor", &["roller_diameter", "mass", "inertia", "friction_force", "process_force"]),
    ("slider_crank", &["crank", "rod", "mass", "inertia", "start_angle", "process_force"]),
    ("joint", &["inertia", "holding_torque"]),
    ("table", &["points[1].position", "start_angle", "friction_torque"]),
];

/// A report of nothing but a mechanism.
pub fn mechanism(kind: &str, keys: &[&str], language: quantities::Language) -> Content {
    let prefix = if kind == "load" { "load".to_owned() } else { format!("mechanism.{kind}") };
    let inputs: Vec<Value> =
        keys.iter().map(|key| json!({ "key": format!("{prefix}.{key}"), "text": "1.5 kg" })).collect();
    Content { language, data: json!({ "inputs": inputs }), figures: Vec::new() }
}
