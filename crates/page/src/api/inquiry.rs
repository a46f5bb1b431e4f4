//! A request as a question: the values of its query and the texts of its body.

use super::misdirected;
use crate::{Call, Reply, Shell};
use quantities::{Language, seen};
use questions::Progress;
use questions::list::{Entry, Given, Inquiry, Reads, ReferencedText, Unanswered, media};
use serde::Deserialize;
use std::borrow::Cow;
use words::requests;

/// Default name of the body in faults: the name of standard input on the command line.
const USUAL_NAME: &str = "stdin";

/// Reads the question of a request.
///
/// # Errors
/// Every fault of the query; a body without the two texts that the question reads.
pub(crate) fn read_inquiry<'a>(
    entry: &Entry,
    call: &Call<'a>,
    shell: &'a dyn Shell,
    progress: &'a Progress,
) -> Result<Inquiry<'a>, Unanswered> {
    let language = call.query_language();
    let given = Given::of(&super::parameters(entry), call.query_fields(), language)?;
    let source = |name: String, bytes| ReferencedText { name, bytes, files: shell.files() };
    let sources: Vec<ReferencedText<'_>> = match entry.reads {
        Reads::Nothing => Vec::new(),
        Reads::Project | Reads::Pins | Reads::Measured => {
            let name = given.file()?.unwrap_or_else(|| USUAL_NAME.to_owned());
            vec![source(name, Cow::Borrowed(call.body))]
        }
        Reads::TwoProjects => {
            let Two { old, new } = two_texts(call.body, language)?;
            [("old", old), ("new", new)]
                .map(|(name, text)| source(name.to_owned(), Cow::Owned(text.into_bytes())))
                .into()
        }
    };
    let days_since_1970 = shell.days_since_1970();
    let catalogue = shell.catalogue();
    let given = given.naming_products(sources.iter().any(ReferencedText::may_name_products));
    Ok(Inquiry { given, sources, catalogue, days_since_1970, progress, refuses_long: false, by_axes: false, language })
}

/// The two texts of a JSON body.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Two {
    old: String,
    new: String,
}

fn two_texts(body: &[u8], language: Language) -> Result<Two, Unanswered> {
    serde_json::from_slice(body)
        .map_err(|error| Unanswered::message(requests::no_two_projects(&error.line(), &error.column(), language)))
}

/// Media types of a text: its own, none, and the defaults of clients.
const TEXTS: [&str; 6] = [
    "application/toml",
    "text/plain",
    "text/csv",
    "text/toml",
    "application/octet-stream",
    "application/x-www-form-urlencoded",
];

/// Returns the reply to a body of a media type that the question does not read.
pub(super) fn wrong_media(reads: Reads, call: &Call<'_>, language: Language) -> Option<Reply> {
    let sent = call.media.filter(|sent| !sent.trim().is_empty())?;
    let plain = sent.split(';').next().unwrap_or_default().trim().to_ascii_lowercase();
    let valid: &[&str] = match reads {
        Reads::Nothing => return None,
        Reads::Project | Reads::Pins | Reads::Measured => &TEXTS,
        Reads::TwoProjects => &[media::JSON, "application/x-www-form-urlencoded"],
    };
    if valid.contains(&plain.as_str()) {
        return None;
    }
    let wanted = valid.first().copied().unwrap_or_default();
    Some(misdirected(415, &requests::wrong_media(&seen(sent), &wanted, language), None))
}
