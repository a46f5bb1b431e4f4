//! The report: results as a document to sign, typeset as PDF. It lays out and computes nothing.
//!
//! A face collects the answers in a [`Content`], adds the data of the title page ([`Settings`]) and
//! requests the PDF. Same content and settings, same bytes: no clock, file or system font is used.

#[cfg(feature = "document")]
mod document;
#[cfg(feature = "pdf")]
mod form;
#[cfg(feature = "pdf")]
mod glyphs;
#[cfg(feature = "pdf")]
mod letters;
#[cfg(feature = "pdf")]
mod press;
#[cfg(feature = "pdf")]
mod template;

#[cfg(feature = "pdf")]
pub use letters::{Letter, letters};
#[cfg(feature = "png")]
pub use press::pages_png;
#[cfg(feature = "pdf")]
pub use press::{
    checklist_pdf, checklist_texts, overlaps, page_fills, page_texts, pdf, prepare, right_edges, warnings,
};

use answers::{Chapter, Dossier};
use chrono::NaiveDate;
use quantities::Language;
use serde::Serialize;
use words::terminal;

/// Returns the input of the template: every number formatted for the language, every list in its order.
///
/// # Errors
/// [`Fault::NoAxis`]; [`Fault::Typesetting`] if the input is no JSON, which is a defect.
#[cfg(feature = "document")]
pub fn document(content: &Content, settings: &Settings) -> Result<serde_json::Value, Fault> {
    let document = document::ReportDocument::build(content, settings)?;
    let value = serde_json::to_value(&document).map_err(|fault| Fault::Typesetting { message: fault.to_string() })?;
    Ok(in_words(value, content.language))
}

/// Members of the document that the template uses as identifiers, or that are texts of the user.
#[cfg(feature = "document")]
const AS_THEY_ARE: [&str; 8] = ["head", "name", "key", "file", "files", "id", "place", "svg"];

/// Returns the document with the keys of the project file replaced by words: readers of the report do not know the
/// file.
#[cfg(feature = "document")]
fn in_words(value: serde_json::Value, language: Language) -> serde_json::Value {
    use serde_json::Value;
    match value {
        Value::String(text) => Value::String(words::without_keys(&text, language).into_owned()),
        Value::Array(items) => items.into_iter().map(|item| in_words(item, language)).collect(),
        Value::Object(members) => {
            let spelled = |(key, value): (String, Value)| {
                let value = if AS_THEY_ARE.contains(&key.as_str()) { value } else { in_words(value, language) };
                (key, value)
            };
            members.into_iter().map(spelled).collect()
        }
        other => other,
    }
}

/// Content of the report as data.
#[derive(Clone, Debug)]
pub struct Content {
    /// Language of headings and numbers. The texts within the dossiers are in the language of their request.
    pub language: Language,
    /// The axes in the order of the project; at least one.
    pub axes: Vec<AxisContent>,
}

/// Content of the report for one axis.
#[derive(Clone, Debug)]
pub struct AxisContent {
    /// Answers about the axis.
    pub dossier: Dossier,
    /// Kind of the chosen actuator, as text.
    pub actuator_kind: String,
    /// Diagrams, in the order of the report.
    pub figures: Vec<Diagram>,
    /// Chapters for building and running the machine; empty unless requested.
    pub chapters: Vec<Chapter>,
}

/// The part of a report in which a diagram stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum DiagramPlace {
    /// The motion over the cycle.
    Motion,
    /// The plane of torque and speed.
    TorqueSpeed,
    /// The loads on the output bearing, beside the checks.
    OutputBearing,
    /// The torsion of the gear, beside the checks.
    Gear,
    /// Effect of the tolerances.
    Tolerances,
    /// The other actuators.
    Alternatives,
}

/// Width of the text on a page \[mm\]. A diagram of this width is placed without scaling, so that its letters keep
/// their size.
const TEXT_WIDTH_MM: f64 = 168.0;

/// Width of one of two diagrams side by side \[mm\].
const HALF_WIDTH_MM: f64 = 81.0;

impl DiagramPlace {
    /// Sizes at which the diagram is drawn \[mm\], the highest first; `height` is the height that suits its content.
    ///
    /// A page that has little room left takes a lower drawing, never a scaled one.
    #[must_use]
    pub fn sizes_mm(self, height: f64) -> Vec<(f64, f64)> {
        let heights: &[f64] = match self {
            Self::Motion => &[188.0, 172.0, 158.0, 146.0, 128.0, 110.0],
            Self::TorqueSpeed => &[116.0, 104.0, 91.0],
            // Side by side, of one height.
            Self::OutputBearing | Self::Gear => &[62.0],
            Self::Tolerances => &[88.0, 74.0, 61.0],
            Self::Alternatives => &[78.0, 70.0, 61.0, 53.0],
        };
        let own = heights.first().is_none_or(|highest| height < *highest).then_some(height);
        let lower = heights.iter().copied().filter(|lower| *lower < height);
        let width = match self {
            Self::OutputBearing | Self::Gear => HALF_WIDTH_MM,
            _ => TEXT_WIDTH_MM,
        };
        own.into_iter().chain(lower).map(|height| (width, height)).collect()
    }
}

/// A drawn diagram.
#[derive(Clone, Debug)]
pub struct Diagram {
    /// Place of the diagram in the report.
    pub place: DiagramPlace,
    /// The diagram as SVG at each of [`DiagramPlace::sizes_mm`], its text in the family Inter.
    pub svgs: Vec<String>,
    /// The line below it.
    pub caption: String,
    /// Description of the picture, for screen readers.
    pub alternative_text: String,
}

/// Data of the title page besides the results, and the extent of the report.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// The date of the document; none is invented, and [`Settings::pdf_a`] needs one.
    pub date: Option<NaiveDate>,
    /// Revision of the document.
    pub revision: String,
    /// Project, plant or order.
    pub project: String,
    /// Number of the document.
    pub number: String,
    /// Author of the document.
    pub author: String,
    /// Company or office.
    pub company: String,
    /// Customer.
    pub customer: String,
    /// Number of the order.
    pub order: String,
    /// List of changes, the latest last.
    pub changes: Vec<Change>,
    /// Output as archive file, PDF/A-2a; the file is tagged in either case.
    pub pdf_a: bool,
    /// Appendices with every derivation, the sources of every figure and every rejected code.
    pub full: bool,
    /// Values in place of those of the project file, stated for this report alone.
    pub altered: Vec<String>,
}

/// A line of the list of changes.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Change {
    /// Revision with the change.
    pub revision: String,
    /// Day of the change, in the spelling of the user.
    pub date: String,
    /// Author of the change; empty where not stated.
    pub author: String,
    /// Content of the change.
    pub text: String,
}

/// Reasons for which there is no report.
#[derive(Debug)]
pub enum Fault {
    /// The report has no axis.
    NoAxis,
    /// An archive file requires the date of its creation, and this crate reads no clock.
    NoDate,
    /// The typesetting engine refused the document.
    Typesetting {
        /// Message of the engine, with the place in the template.
        message: String,
    },
    /// The typesetting engine refused to write the file.
    Export {
        /// Message of the engine.
        message: String,
    },
    /// A page could not be drawn as a picture.
    Picture {
        /// Number of the page, from 1.
        page: usize,
    },
}

impl Fault {
    /// Returns the fault as a sentence.
    #[must_use]
    pub fn message(&self, language: Language) -> String {
        match self {
            Self::NoAxis => terminal::report_without_axis(language).to_owned(),
            Self::NoDate => terminal::archive_needs_a_date(language).to_owned(),
            Self::Typesetting { message } => terminal::report_not_typeset(message, language),
            Self::Export { message } => terminal::report_not_written(message, language),
            Self::Picture { page } => terminal::page_not_drawn(page, language),
        }
    }
}
