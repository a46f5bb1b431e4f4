//! Answers of the twin about a project in a text.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test that cannot panic cannot fail")]

use axis::NoFiles;
use quantities::Language;
use questions::Progress;
use questions::list::{Given, Inquiry, ReferencedText, Unanswered, simulate};
use std::borrow::Cow;

/// Returns the answer of `simulate` as JSON, and whether the actuator fits.
///
/// # Errors
/// Faults of options and project.
pub(crate) fn simulated(text: &str, options: &[(&str, &str)]) -> Result<(serde_json::Value, bool), Unanswered> {
    let pairs = options.iter().map(|(name, value)| (Cow::Borrowed(*name), Cow::Borrowed(*value)));
    let given = Given::of(simulate::Args::ARGUMENTS, pairs, Language::En)?;
    let progress = Progress::endless();
    let inquiry = Inquiry {
        given,
        sources: vec![ReferencedText {
            name: "axis.toml".to_owned(),
            bytes: Cow::Borrowed(text.as_bytes()),
            files: &NoFiles,
        }],
        catalogue: questions::embedded_catalogue(),
        days_since_1970: None,
        progress: &progress,
        refuses_long: true,
        by_axes: false,
        language: Language::En,
    };
    let answer = simulate::record(&simulate::Args::read(&inquiry.given)?, &inquiry)?;
    Ok((serde_json::from_str(&answer.text).unwrap(), answer.fits))
}
