//! The facade: the project file and every use case as plain data. Every face calls only this.
//!
//! Texts come in English and German ([`Language`]); results come as data ([`Sizing`], [`Candidate`]) and as JSON
//! values ([`json`]). Nothing here touches a file, the clock, the environment or the terminal.

mod chapters;
mod codes;
mod compare;
mod diagnostic;
mod explain;
mod export;
mod fingerprint;
mod flange;
mod glossary;
mod inertia;
pub mod json;
mod limits;
mod moves;
mod plane;
mod project;
mod sheet;
mod sizing_use;
mod templates;
pub mod text;
mod tolerance;
mod torsion;

pub use actuator::{CurveKind, CurvePoint, PerformanceCurve};
pub use chapters::{battery, bearing_checks, bearing_of_each_size, curves, read_quantity};
pub use codes::{CodeFault, CodeReading, completion, explain_code, list_codes, read_code, read_pattern};
pub use compare::{CheckChange, CheckRow, Comparison, DatumRow, Difference, compare, difference};
pub use configurator::{Availability, Choice, Unmet};
pub use diagnostic::{Diagnostic, place};
pub use explain::{Explanation, Node, explanation, trust};
pub use export::{EXPORT_COLUMNS, export_rows};
pub use fingerprint::{catalogue_fingerprint, project_fingerprint};
pub use flange::flange_course;
pub use glossary::glossary;
pub use inertia::{BODY_SHAPES, BodyAnswer, BodyShape, InertiaAnswer, inertia};
pub use limits::{NeededLimit, limits_needed};
pub use moves::{Move, Moves, SegmentLaw, moves};
pub use order_code::{Field, OrderCode};
pub use plane::{Plane, curve_rows, plane, plane_of};
pub use project::{
    ALL_CORNERS_MOST, Assumption, Files, Input, InputChange, NoFiles, OwnActuator, PROJECT_MAX_BYTES, Project,
    RatioAnswer, RecordingRead, Tolerance, input_changes, inputs, schema,
};
pub use provenance::Grade;
pub use quantities::{self, Language};
pub use sheet::{Sheet, SheetRow, SheetSection, sheet};
pub use sizing::derivation;
pub use sizing::{Check, CheckId, Course, Demand, Direction, Figure, FlangeSample, Part, Reserve, Sample, Verdict};
pub use sizing_use::{
    Candidate, CandidateId, Objection, Refusal, Sizing, catalogue_actuators, check, check_own, course, explain,
    explain_own, reserve_of, size,
};
pub use templates::{Template, template, template_kinds};
pub use tolerance::{
    Assessment, Influence, Place, Quantiles, SAMPLES_MOST, SAMPLES_USUAL, SEED_USUAL, Sampling, Worst, assess,
};
pub use torsion::{TorsionAnswer, TorsionCurve, read_torque, torsion, torsion_of};

#[cfg(test)]
mod tests {
    use super::*;

    /// Every condition on every German data sheet is symbols, numbers and German words.
    #[test]
    fn no_english_condition_is_left_on_a_german_data_sheet() {
        let mut seen: Vec<String> = Vec::new();
        for (code, _) in list_codes(None) {
            let Some(sheet) = sheet(code) else { continue };
            for row in sheet.sections.iter().flat_map(|section| &section.rows) {
                let text = text::condition_text(row.cell.place.condition, Language::De);
                if !seen.contains(&text) {
                    seen.push(text);
                }
            }
        }
        assert!(seen.len() > 20, "{seen:?}");
        let english = ["no ", "load", "max. no", "above", "part", "with", "and", "side", "turn", "ing", "level"];
        for text in &seen {
            assert!(!english.iter().any(|word| text.contains(word)), "{text}");
        }
    }
}
