//! The project as it was written, and what of it the sketch calls out.

use super::shown::{Shown, tied};
use answers::{Dossier, InputTable, MechanismKind};
use serde::Serialize;

/// One table of the project file.
#[derive(Serialize)]
pub(super) struct Group {
    title: String,
    rows: Vec<Row>,
}

#[derive(Serialize)]
pub(super) struct Row {
    name: String,
    label: String,
    text: String,
    tolerance: String,
}

fn row(input: &answers::Input) -> Row {
    Row {
        name: input.name.clone(),
        label: input.label.clone(),
        text: tied(&input.text),
        tolerance: input.tolerance.as_deref().map(tied).unwrap_or_default(),
    }
}

/// The inputs by table, in the order of the file, without those of the mechanism, which stand beside its sketch.
pub(super) fn groups(tables: &[InputTable]) -> Vec<Group> {
    let others = tables.iter().filter(|table| !table.of_mechanism);
    others.map(|table| Group { title: table.title.clone(), rows: table.values.iter().map(row).collect() }).collect()
}

/// What hangs on the flange.
#[derive(Serialize)]
pub(super) struct Mechanism {
    kind: MechanismKind,
    /// Whether its line is nearer to the vertical than to the horizontal.
    upright: bool,
    /// Way along the line for one turn of the actuator.
    travel: String,
    rows: Vec<Row>,
    bodies: Vec<Body>,
    /// Of all bodies together.
    inertia: String,
    mass: String,
}

#[derive(Serialize)]
struct Body {
    shape: &'static str,
    count: u32,
    mass: String,
    distance: String,
    own: String,
    steiner: String,
    total: String,
    text: String,
}

impl Mechanism {
    pub(super) fn build(dossier: &Dossier, shown: &Shown) -> Self {
        let found = &dossier.mechanism;
        let mut rows: Vec<Row> =
            dossier.inputs.iter().filter(|table| table.of_mechanism).flat_map(|table| &table.values).map(row).collect();
        let mut bodies = Vec::new();
        if let Some(inertia) = &found.bodies {
            // Each body stands as a row of its own table, in the words of the project.
            let (texts, others): (Vec<Row>, Vec<Row>) =
                rows.into_iter().partition(|row| row.name.starts_with("bodies["));
            rows = others;
            let mut texts = texts.into_iter().map(|row| row.text);
            bodies = inertia
                .bodies
                .iter()
                .map(|body| Body {
                    shape: body.shape,
                    count: body.count,
                    mass: shown.number(body.mass),
                    distance: shown.number(body.distance),
                    own: shown.number(body.own),
                    steiner: shown.number(body.steiner),
                    total: shown.number(body.total),
                    text: texts.next().unwrap_or_default(),
                })
                .collect();
        }
        Self {
            kind: found.kind,
            upright: found.inclination_deg.is_some_and(|angle| (angle.0.abs() % 180.0 - 90.0).abs() < 45.0),
            travel: found.travel_mm_per_rev.map(|travel| shown.figure(travel, "mm")).unwrap_or_default(),
            rows,
            bodies,
            inertia: found.bodies.as_ref().map(|it| shown.figure(it.inertia, "kgm^2")).unwrap_or_default(),
            mass: found.bodies.as_ref().map(|it| shown.figure(it.mass, "kg")).unwrap_or_default(),
        }
    }
}
