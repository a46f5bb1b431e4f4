//! Inputs of the project, and the labels of the sketch of the mechanism.

use super::ends::{Ends, is_listed};
use super::shown::{Formatter, tied};
use answers::{Dossier, InputTable, Sketch};
use serde::Serialize;

/// One table of the project file.
#[derive(Serialize)]
pub(super) struct Group {
    title: String,
    rows: Vec<InputRow>,
}

/// Inputs stated in the project.
#[derive(Serialize)]
pub(super) struct Inputs {
    groups: Vec<Group>,
    /// Number of tables left out.
    left_out: usize,
}

#[derive(Serialize)]
pub(super) struct InputRow {
    name: String,
    label: String,
    text: String,
    tolerance: String,
}

fn row(input: &answers::Input) -> InputRow {
    InputRow {
        name: input.name.clone(),
        label: input.label.clone(),
        text: tied(&input.text),
        tolerance: input.tolerance.as_deref().map(tied).unwrap_or_default(),
    }
}

/// Returns the inputs by table, in the order of the file, without those of the mechanism, which are listed beside its
/// sketch; of many segments the first and the last.
pub(super) fn groups(tables: &[InputTable]) -> Inputs {
    let others = tables.iter().filter(|table| !table.of_mechanism);
    let segments = tables.iter().filter_map(segment_of).max().unwrap_or(0);
    let (listed, left_out): (Vec<&InputTable>, Vec<&InputTable>) =
        others.partition(|table| segment_of(table).is_none_or(|number| is_listed(number - 1, segments)));
    let group =
        |table: &&InputTable| Group { title: table.title.clone(), rows: table.values.iter().map(row).collect() };
    Inputs { groups: listed.iter().map(group).collect(), left_out: left_out.len() }
}

/// Returns the number, from 1, of the segment that a table describes.
fn segment_of(table: &InputTable) -> Option<usize> {
    let (number, _) = table.key.strip_prefix("motion[")?.split_once(']')?;
    number.parse().ok().filter(|number| *number > 0)
}

/// Mechanism driven by the output flange.
#[derive(Serialize)]
pub(super) struct MechanismData {
    title: String,
    sketch: Sketch,
    /// Width at which it is placed.
    sketch_width_mm: f64,
    /// Way along the line for one turn of the actuator.
    travel: String,
    data: Ends<InputRow>,
    bodies: Ends<Body>,
    /// Total moment of inertia of the bodies.
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

impl MechanismData {
    pub(super) fn build(dossier: &Dossier, shown: &Formatter) -> Self {
        let found = &dossier.mechanism;
        let mut rows: Vec<InputRow> =
            dossier.inputs.iter().filter(|table| table.of_mechanism).flat_map(|table| &table.values).map(row).collect();
        let mut bodies = Ends::default();
        if let Some(inertia) = &found.bodies {
            // Each body is a row of its own table, in the terms of the project.
            let (texts, others): (Vec<InputRow>, Vec<InputRow>) =
                rows.into_iter().partition(|row| row.name.starts_with("bodies["));
            rows = others;
            let mut texts = texts.into_iter().map(|row| row.text);
            let rows = inertia.bodies.iter().map(|body| Body {
                shape: body.shape,
                count: body.count,
                mass: shown.number(body.mass),
                distance: shown.number(body.distance),
                own: shown.number(body.own),
                steiner: shown.number(body.steiner),
                total: shown.number(body.total),
                text: texts.next().unwrap_or_default(),
            });
            bodies = Ends::of(rows, None);
        }
        let [lying, upright] = SKETCH_MM;
        let width_mm = if found.sketch.is_upright { upright } else { lying };
        Self {
            title: found.title.clone(),
            sketch: Sketch { svg: lettered(&found.sketch.svg, width_mm), ..found.sketch.clone() },
            sketch_width_mm: width_mm,
            travel: found.travel_mm_per_rev.map(|travel| shown.figure(travel, "mm")).unwrap_or_default(),
            data: Ends::of(rows.into_iter(), None),
            bodies,
            inertia: found.bodies.as_ref().map(|it| shown.figure(it.inertia, "kgm^2")).unwrap_or_default(),
            mass: found.bodies.as_ref().map(|it| shown.figure(it.mass, "kg")).unwrap_or_default(),
        }
    }
}

/// Widths at which a sketch is placed \[mm\]: beside its data, an upright one narrower.
const SKETCH_MM: [f64; 2] = [76.0, 36.0];

/// Smallest letter of a sketch on the page \[pt\].
const LEAST_PT: f64 = 7.05;

/// The sketch with letters, indices included, that can be read at a width \[mm\]: those of a large one are drawn larger.
fn lettered(svg: &str, width_mm: f64) -> String {
    let view = svg.split("viewBox=").nth(1).and_then(|rest| rest.split(['"', '\'']).nth(1)).unwrap_or_default();
    let Some(drawn) = view.split_whitespace().nth(2).and_then(|width| width.parse::<f64>().ok()) else {
        return svg.to_owned();
    };
    let least = LEAST_PT * drawn / (width_mm * 72.0 / 25.4);
    let letters = least.max(14.0);
    let index = least.max(13.7);
    svg.replace("font-size:14px", &format!("font-size:{letters:.2}px"))
        .replace("font-size='13.7'", &format!("font-size='{index:.2}'"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_many_segments_the_first_and_the_last_are_listed_with_what_belongs_to_them() {
        let table = |key: &str| InputTable {
            key: key.to_owned(),
            title: key.to_owned(),
            of_mechanism: key == "mechanism.arm",
            values: Vec::new(),
        };
        let segments = (1..=1000).flat_map(|number| [format!("motion[{number}]"), format!("motion[{number}].bearing")]);
        let keys =
            ["".to_owned(), "mechanism.arm".to_owned()].into_iter().chain(segments).chain(["bearing".to_owned()]);
        let tables: Vec<InputTable> = keys.map(|key| table(&key)).collect();
        let found = groups(&tables);
        assert_eq!((found.groups.len(), found.left_out), (2 + 400, 1600));
        let titles: Vec<&str> = found.groups.iter().map(|group| group.title.as_str()).collect();
        assert!(titles.contains(&"motion[150].bearing") && titles.contains(&"motion[951]"));
        assert!(!titles.contains(&"motion[151]") && !titles.contains(&"motion[950].bearing"));
        assert_eq!(groups(&tables[..300]).left_out, 0);
    }
}
