//! Faults of the input with file, line, column and the faulty text underlined.

pub(crate) mod memory;

use crate::answer::CommandAnswer;
use crate::table::width;
use crate::waiting::waited_s;
pub(crate) use disk::path_text;
use order_code::OrderCode;
use quantities::{Language, seen};
use questions::CodeRefusal;
use questions::answer::{code_worded, refusal_text};
use questions::list::Unanswered;
use questions::list::code_list::Availability;
use std::path::Path;
use words::{Worded, terminal, terms};

/// Reads at most one byte more than a file may have, so that a large file or an endless stream is not read to
/// its end.
pub(crate) fn read_bytes(path: &Path, most: usize) -> std::io::Result<Vec<u8>> {
    if path.as_os_str() == "-" { disk::read_within(std::io::stdin().lock(), most) } else { disk::read_file(path, most) }
}

/// Returns the answer to a faulty call: the faults, underlined in their texts, and as a record if JSON is requested.
pub(crate) fn unanswered(why: &Unanswered, as_json: bool, language: Language) -> CommandAnswer {
    let mut said: Vec<String> = Vec::new();
    add_messages(why, &mut said, language);
    if is_about_text(why) {
        said.push(closing(why.faults(waited_s(), language).errors.len(), language));
    }
    let data = if as_json { why.record(waited_s(), language) } else { String::new() };
    CommandAnswer { data, talk: said.concat(), code: 2, ..CommandAnswer::none() }
}

/// Returns `true` if faults of a text are among the reasons.
fn is_about_text(why: &Unanswered) -> bool {
    match why {
        Unanswered::Text { .. } => true,
        Unanswered::Together(all) => all.iter().any(is_about_text),
        Unanswered::Code { .. }
        | Unanswered::Table { .. }
        | Unanswered::File { .. }
        | Unanswered::Option { .. }
        | Unanswered::Message(_)
        | Unanswered::WhichAxis { .. }
        | Unanswered::Usage(_)
        | Unanswered::Refused(..) => false,
    }
}

/// Adds the message of each reason, without repetition.
fn add_messages(why: &Unanswered, said: &mut Vec<String>, language: Language) {
    let error = terminal::error(language);
    let text = match why {
        // In records, a body has one name in both languages.
        Unanswered::Text { name, text, faults } if name == "body" => {
            report(terms::body(language), text, faults, language)
        }
        Unanswered::Text { name, text, faults } => report(name, text, faults, language),
        Unanswered::Code { text, refusal, .. } => {
            let faults = code_worded(text, refusal);
            let found = report(terminal::code(language), text, &faults, language);
            found + &closing(faults.len(), language) + &nearest(refusal, language)
        }
        Unanswered::Table { .. } => {
            let faults = why.faults(waited_s(), language).errors;
            faults.iter().map(|fault| in_table(fault, language)).collect()
        }
        Unanswered::File { name, message, .. } => format!("{error}: {}: {}\n", seen(name), seen(message)),
        Unanswered::Option { name, fault: (message, hint) } => {
            format!("{error}: --{name}: {}\n{}", seen(message), hinted(hint.as_deref()))
        }
        Unanswered::Message((message, hint)) => format!("{error}: {}\n{}", seen(message), hinted(hint.as_deref())),
        Unanswered::WhichAxis { message, .. } => format!("{error}: {}\n", seen(message)),
        Unanswered::Usage(errors) => errors
            .iter()
            .map(|fault| format!("{error}: {}\n{}", seen(&fault.message), hinted(fault.hint.as_deref())))
            .collect(),
        Unanswered::Refused(refusal, code) => {
            let what = refusal_text(refusal, waited_s(), language);
            let code = code.as_ref().map_or_else(String::new, |code| format!("{code}\n"));
            format!("{error}: {}\n{code}", seen(&what))
        }
        Unanswered::Together(all) => return all.iter().for_each(|one| add_messages(one, said, language)),
    };
    if !said.contains(&text) {
        said.push(text);
    }
}

/// Returns a hint on lines of its own.
fn hinted(hint: Option<&str>) -> String {
    hint.into_iter().flat_map(str::lines).map(|line| format!("  {}\n", seen(line))).collect()
}

/// Returns a fault of a table with its file, heading and row.
fn in_table(fault: &answers::Fault, language: Language) -> String {
    let row = fault.row.map(|row| words::sweeps::row(&row, language));
    let place: Vec<String> = fault.file.iter().chain(&fault.heading).cloned().chain(row).collect();
    let place = if place.is_empty() { String::new() } else { format!("{}: ", place.join(", ")) };
    let error = terminal::error(language);
    format!("{error}: {}{}\n{}", seen(&place), seen(&fault.message), hinted(fault.hint.as_deref()))
}

/// Returns the codes nearest to an invalid one.
fn nearest(refusal: &CodeRefusal, language: Language) -> String {
    if refusal.nearest.is_empty() {
        return String::new();
    }
    let request = terms::on_request(language);
    let name = |each: &&(OrderCode, Availability)| {
        let (code, found) = *each;
        if found.is_available() { code.to_string() } else { format!("{code} ({request})") }
    };
    let names: Vec<String> = refusal.nearest.iter().map(name).collect();
    format!("{}: {}\n", terminal::nearest_valid_codes(language), names.join(", "))
}

/// Returns every fault of a text, underlined.
fn report(file: &str, text: &str, faults: &[Worded], language: Language) -> String {
    let mut talk = String::new();
    let (error, help) = (terminal::error(language), terminal::help(language));
    let style = excerpt::Style { file: &seen(file), error, help, width: width() };
    for fault in faults {
        let hint = fault.hint.as_deref().map(seen);
        let of_text = excerpt::Fault {
            span: fault.span.clone(),
            line: fault.line,
            column: fault.column,
            message: &seen(&fault.message),
            hint: hint.as_deref(),
        };
        talk.push_str(&excerpt::show(text, &of_text, &style));
        talk.push('\n');
    }
    talk
}

/// Returns the last line of the messages: the number of faults, and that nothing was calculated.
fn closing(faults: usize, language: Language) -> String {
    let counted = match faults {
        51.. => terminal::more_than_fifty_errors(language).to_owned(),
        count => terminal::errors(count, language),
    };
    format!("antrieb: {counted}; {}\n", terminal::nothing_was_calculated(language))
}
