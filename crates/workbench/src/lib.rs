//! The facade: the project file and every use case as plain data. Every face calls only this.
//!
//! Texts come in English and German ([`Language`]); results come as data ([`Sizing`], [`Candidate`]) and as
//! records ([`answer`]). Nothing here touches a file, the clock, the environment or the terminal.

pub mod answer;
mod ask;
pub mod chapter;
mod chapters;
mod cited;
mod codes;
mod commission;
mod compare;
mod errata;
mod explain;
mod export;
mod fingerprint;
mod flange;
mod glossary;
mod grips;
mod law_shape;
mod licences;
mod limits;
mod mount;
mod moves;
mod patience;
mod plane;
mod preview;
mod question;
mod reading;
mod sheet;
mod sizing_use;
mod subject;
mod templates;
mod together;
mod told;
mod tolerance;
mod torsion;
mod upkeep;
mod wiring;

pub use actuator::{BatteryLife, CurveKind, CurvePoint, PerformanceCurve};
pub use answers::{self, Derivation, Node};
pub use ask::{
    Explanation, Ranking, Request, Response, Verification, ask, explanation, margins, ranking, reserve_unasked,
    reserve_within, scatter, sized, verification,
};
pub use catalogue::{Fact, Signal, Step, Topic};
pub use chapters::{battery, bearing_checks, bearing_of_each_size, curves, read_hours, read_quantity};
pub use chrono::NaiveDate as Date;
pub use codes::{CodeFault, CodeReading, CodeRefusal, completion, explain_code, list_codes, read_code, read_pattern};
pub use commission::{
    Commissioning, DriveForm, Judged, Measured, blank_record, commission, eds, judge, measured, sinamics_script,
    usual_ambient,
};
pub use compare::{CheckChange, CheckRow, Comparison, DatumRow, Difference, compare, difference};
pub use configurator::{Availability, Choice, Uncovered, Unmet, catalogue_actuators, uncovered};
pub use errata::{ErrataFound, ErrataRefusal, errata_about};
pub use explain::{derivation, node_amount, trust};
pub use export::{EXPORT_COLUMNS, export_csv, export_rows};
pub use fingerprint::{catalogue_fingerprint, project_fingerprint};
pub use flange::flange_course;
pub use glossary::{glossary, meaning_of_symbol, meaning_of_word};
pub use grips::{Grip, Grips, grips};
pub use installation::calendar::Interval;
pub use installation::mount::MountAsked;
pub use installation::upkeep::{Planned, Upkeep, UpkeepAsked};
pub use installation::wiring::{
    Connector, Group as SignalGroup, LISTED_BYTES_MAX, ListFault, Role, VoltageDrop, Wiring, voltage_drops, wiring,
};
pub use law_shape::{Shape, law_shape};
pub use licences::licences;
pub use limits::{NeededLimit, limits_needed};
pub use mount::{joint_loads, mount, read_bore};
pub use moves::{Move, Moves, moves};
pub use order_code::{Brake, Field, OrderCode, Size};
pub use patience::Patience;
pub use plane::{Plane, curve_rows, plane, plane_of};
pub use preview::{recording_preview, recording_roles};
pub use project::{
    ALL_CORNERS_MOST, Assumption, BODY_SHAPES, BodyAnswer, BodyShape, Diagnostic, Fault, Files, Grant, Hint,
    InertiaAnswer, Input, InputChange, NoFiles, NoRegularFile, OwnActuator, PROJECT_MAX_BYTES, Project, RatioAnswer,
    Reach, RecordingRead, SegmentLaw, Tolerance, inertia, input_changes, inputs, place,
};
pub use project::{
    About, Edit, EditFault, KEYS, Key, Kind, MEASURED_KEYS, MeasuredKey, Variants, Written, edit, edit_measured,
    example, key_at, measured_key_at, stretch, written,
};
pub use provenance::Grade;
pub use quantities::{self, Language};
pub use question::Question;
pub use reading::{Unread, read, read_all, read_all_watched, schema};
pub use recording::{MEMORY_USUAL, Preview, Role as ColumnRole};
pub use sheet::{Sheet, SheetMarks, SheetNote, SheetRow, SheetSection, sheet, sheet_value_text, uncovered_mark};
pub use sizing::derivation as workings;
pub use sizing::{
    Check, CheckId, Checks, Course, Demand, Direction, Figure, FlangeSample, Part, Reserve, Sample, Verdict,
};
pub use sizing_use::{
    Candidate, CandidateId, Objection, Refusal, Sizing, check, check_own, course, course_rows, course_seen, explain,
    explain_own, reserve_of, size,
};
pub use subject::{candidate_for, candidate_of_tables, names, paired, picked};
pub use templates::{Template, template, template_kinds};
pub use together::{PowerOverCycle, power_over_cycle, sum_of_known};
pub use told::{
    battery_lines, by_importance, demand_figures, dominating, figure_text, objection_text, passing_text, percent,
    reason, recording_text, reserve_lines, sampling_text, share_text, shown, tolerance_heads, tolerance_lines,
    tolerance_rows, torsion_lines, unit_text, worst_text,
};
pub use tolerance::{
    Assessment, Draw, Influence, Place, Quantiles, SAMPLES_MOST, SAMPLES_USUAL, SEED_USUAL, Sampling, Worst, assess,
};
pub use torsion::{TorsionAnswer, TorsionCurve, Twist, read_twist, torsion, torsion_of};
pub use upkeep::{OptionFault, day_of_clock, read_date, read_interval, read_storage, upkeep};
pub use wiring::{CABLE_LENGTH_MAX_M, CROSS_SECTION_MAX_MM2, ListRead, cable_length, cross_section, read_list};

/// The words of the house, and those of a whole candidate.
pub mod text {
    use crate::{Candidate, Language};

    pub use words::*;

    /// Whether a candidate fits, and how many questions about it could not be answered.
    #[must_use]
    pub fn standing_text(candidate: &Candidate<'_>, language: Language) -> String {
        words::standing_text(candidate.fits(), candidate.open_questions(), language)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every condition on every German data sheet is symbols, numbers and German words.
    #[test]
    fn no_english_condition_is_left_on_a_german_data_sheet() {
        let mut seen: Vec<String> = Vec::new();
        // Every feedback and option at one ratio: the conditions of the others are the same.
        for (code, _) in list_codes(None).into_iter().filter(|(code, _)| code.ratio.value() == 100) {
            let Some(sheet) = sheet(code) else { continue };
            for row in sheet.sections.iter().flat_map(|section| &section.rows) {
                let text = text::condition_text(row.cell.place.condition, Language::De);
                if !seen.contains(&text) {
                    seen.push(text);
                }
            }
        }
        assert!(seen.len() > 20, "{seen:?}");
        let english = [
            "no ", "joint", "friction", "grease", "load", "max. no", "above", "part", "with", "and", "side", "turn",
            "ing", "level",
        ];
        for text in &seen {
            assert!(!english.iter().any(|word| text.contains(word)), "{text}");
        }
    }
}
