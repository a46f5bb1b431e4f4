//! The report: results as a document to sign, typeset as PDF. It lays out and computes nothing.
//!
//! A face gathers what the workbench answers into a [`Content`], adds what stands on the title page ([`Settings`]) and
//! asks for the [`pdf`]. Same content and settings, same bytes: no clock, no file, no system font is touched.

#[cfg(feature = "pdf")]
mod data;
#[cfg(feature = "pdf")]
mod document;
#[cfg(feature = "pdf")]
mod glyphs;
#[cfg(feature = "pdf")]
mod press;
mod project;
#[cfg(feature = "pdf")]
mod template;

#[cfg(feature = "png")]
pub use press::pages_png;
#[cfg(feature = "pdf")]
pub use press::{overlaps, page_texts, pdf, prepare, right_edges};

pub use project::{Input, inputs};
use quantities::Language;

/// Everything that stands in the report, as data.
#[derive(Clone, Debug)]
pub struct Content {
    /// The language of headings and numbers. The texts within `data` are in the language they were asked in.
    pub language: Language,
    /// One JSON document; every key may be left out or `null`.
    ///
    /// | key | what |
    /// |---|---|
    /// | `check` | the chosen actuator, as `check --json` gives it |
    /// | `sizing` | the ranking, as `size --json --all` gives it |
    /// | `inputs` | the project as written: `key`, `text` and, where known, `label`, `unit`, `tolerance`; see [`inputs`] |
    /// | `assumptions` | texts; without it those of `check`, else of `sizing` |
    /// | `explain` | the derivations, as `explain --json` gives them |
    /// | `derivations` | the same in another form, per check: `check` (its id), `title`, `nodes`: trees of `label`, `formula`, `substituted`, `value`, `unit`, `source`, `grade`, `children` |
    /// | `recordings` | `file`, `samples`, `note` of each recorded motion |
    /// | `hash` | `project`, `catalogue` |
    /// | `bill_of_material` | `item`, `quantity`, `code`, `text`, `source` |
    /// | `wiring` | `connector`, `pin`, `signal`, `colour`, `text`, `source` |
    /// | `screws` | `joint`, `screws`, `circle`, `torque`, `text`, `source` |
    /// | `sources` | `id`, `title` |
    /// | `errata` | `id`, `text`, `source` |
    pub data: serde_json::Value,
    /// Drawn diagrams, in the order in which they shall stand.
    pub figures: Vec<Figure>,
}

/// A drawn diagram.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Its place and name: up to the first `:`, `/` or end one of `mechanism`, `motion`, `demand`, `torque_speed`,
    /// `checks`, `output_bearing`, `gear`, `brake`, `thermal`, `energy`, `feedback`, `screws`, `alternatives`, `wiring`, or
    /// an id of the crate `figures`; any other name puts it behind the parts of chapter 7.
    pub name: String,
    /// SVG, its text in the family Inter.
    pub svg: String,
    /// The line below it.
    pub caption: String,
    /// What it shows, for whoever does not see it.
    pub alternative_text: String,
}

/// What stands on the title page beside the results.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// The date of the document, `2026-11-21`; none is invented, and [`Settings::pdf_a`] needs one.
    pub date: Option<String>,
    /// Revision of the document.
    pub revision: String,
    /// Project, plant or order.
    pub project: String,
    /// Number of the document.
    pub number: String,
    /// Who made it.
    pub author: String,
    /// Company or office.
    pub company: String,
    /// Whether the file is to be kept: PDF/A-2a. Tagged it is in any case.
    pub pdf_a: bool,
}

/// Why there is no report.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// The data do not have the form of the contract.
    #[error("the data of the report have another form than expected: {message}")]
    Data {
        /// What was expected where.
        message: String,
    },
    /// The project file is no TOML.
    #[error("the project cannot be read: {message}")]
    Project {
        /// What is wrong.
        message: String,
    },
    /// The date is no calendar date.
    #[error("`{text}` is not a date")]
    Date {
        /// As given.
        text: String,
    },
    /// A file to be kept states when it was made, and there is no clock here.
    #[error("a file for archiving (PDF/A) needs a date")]
    NoDate,
    /// The typesetting engine refused the document.
    #[error("the report cannot be typeset: {message}")]
    Typesetting {
        /// What the engine said, with the place in the template.
        message: String,
    },
    /// The typesetting engine refused to write the file.
    #[error("the report cannot be written as PDF: {message}")]
    Export {
        /// What the engine said.
        message: String,
    },
    /// A page could not be written as picture.
    #[error("page {page} cannot be written as picture")]
    Picture {
        /// Number of the page, from 1.
        page: usize,
    },
}
