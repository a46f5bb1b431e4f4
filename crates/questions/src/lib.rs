//! The facade: every question with its answer ([`list`]), and the types with which a face lays out an answer.
//!
//! Results are available as data ([`Sizing`], [`Candidate`]) and as records ([`answer`]), their sentences as [`texts`]
//! in English and German. Items of one question alone are in its module of [`list`]. Nothing here accesses a file, the
//! clock, the environment or the terminal.

pub mod answer;
mod budget;
mod candidate;
mod catalogue_reserve;
mod catalogue_template;
pub mod chapter;
mod chapters;
mod closed;
mod codes;
mod commission;
mod compare;
pub mod drive;
mod eds;
mod errata;
mod explain;
mod export;
mod fingerprint;
mod flange;
mod gearing_proposals;
mod glossary;
mod incoming;
mod input_keys;
mod law_shape;
mod limits;
pub mod list;
mod mount;
mod moves;
mod plane;
mod preview;
mod progress;
mod proposals;
mod reading;
mod recorded_template;
mod segment_handles;
mod setpoints;
mod sheet;
mod signal;
mod simulate;
mod sizing_use;
mod subject;
mod supply_power;
pub mod sweep;
mod templates;
pub mod texts;
mod tolerance;
mod torsion;
mod upkeep;
mod wiring;

// Reading: projects, codes, quantities; progress and cancellation; the actuator of an answer.
pub use axis::Catalogue;
pub use budget::{AngularError, AngularErrors, angular_errors};
pub use chapters::read_quantity;
pub use closed::{OpenCycle, closed, is_open_cycle};
pub use codes::{CodeRefusal, read_code, read_product};
pub use fingerprint::{catalogue_fingerprint, file_products, project_fingerprint};
pub use installation::upkeep::has_battery;
pub use progress::Progress;
pub use reading::{
    Unread, embedded_catalogue, read, read_all, read_all_watched, read_all_with, read_with, with_catalogue_files,
};
pub use subject::candidate_for;

// Judgement of an axis.
pub use configurator::{Product, ProductId, Unmet};
pub use limits::limits_needed;
pub use signal::{SIGNALS, Signal, TIME};
pub use simulate::Simulated;
pub use sizing::{Amount, Check, CheckId, Demand, Direction, Fit, Part, Reserve, Verdict};
pub use sizing_use::{
    Candidate, Objection, Reason, Refusal, Rejected, Sizing, check, check_own, explain, explain_own, reserve_of, size,
};
pub use tolerance::{Assessment, Draw, SAMPLES_MOST, SAMPLES_USUAL, Sampling, assess};

// Data of pictures.
pub use actuator::{CurveKind, CurvePoint, PerformanceCurve};
pub use flange::flange_course;
pub use gearing_proposals::{GEARING_INSTANTS_MOST, GearingProposal};
pub use incoming::{
    ColumnOutliers, ExaminedRecording, FilesWithIncoming, IncomingFile, SmoothingEffect, smoothing_effects, window_text,
};
pub use law_shape::{law_peaks, law_shape};
pub use mechanism::MechanismId;
pub use mechanism::drawing::{Drawing, MechanismValues};
pub use mechanism::{Orientation as BodyOrientation, SolidShape};
pub use motion::Spurious;
pub use moves::{Move, Moves, moves};
pub use plane::{Plane, curve_rows, plane, plane_of};
pub use preview::{recording_preview, recording_roles};
pub use proposals::Proposals;
pub use recording::{
    Along, ColumnSpec, FILE_BYTES_MAX, Layout, MEMORY_USUAL, PREVIEW_COLUMNS_MAX, Preview, PreviewColumn,
    Role as ColumnRole,
};
pub use segment_handles::segment_handles;
pub use setpoints::{NoSetpoints, SETPOINTS_MOST, Setpoints, setpoints};
pub use sizing::{Course, FlangeSample, Sample};
pub use sizing_use::{course, course_rows, course_seen};
pub use supply_power::{power_over_cycle, sum_of_known};
pub use torsion::{TorsionCurve, torsion_of};
pub use twin::{EventKind as TwinEvent, PeriodCourse, Sample as TwinSample};

#[cfg(test)]
mod tests {
    use crate::list::code_list::list_codes;
    use crate::sheet::sheet;
    use quantities::Language;

    /// Every condition on every German data sheet consists of symbols, numbers and German words.
    #[test]
    fn no_english_condition_is_left_on_a_german_data_sheet() {
        let mut seen: Vec<String> = Vec::new();
        // Every feedback and option at one ratio: the conditions of the others are the same.
        for (code, _) in list_codes(None).into_iter().filter(|(code, _)| code.ratio.value() == 100) {
            let Some(sheet) = sheet(code) else { continue };
            for row in sheet.sections.iter().flat_map(|section| &section.rows) {
                let text = words::condition_text(row.cell.place.condition, Language::De);
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
