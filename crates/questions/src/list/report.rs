//! `report PROJECT`: the results as a PDF to sign; a face typesets it.

use super::given::{Given, arguments, bounded, day, flag, label, some_product, text};
use super::{
    AXIS, Argument, ArgumentKind, Cost, Entry, Gives, Inquiry, OutputFile, PlacedAxis, Reads, Unanswered, argument,
    media,
};

use crate::upkeep::read_date;
use chrono::NaiveDate;
use configurator::ProductId;
use words::{help, help::values, terminal};

const DATE: Argument = Argument::option("date", values::date, help::date).of(ArgumentKind::Date);
const REVISION: Argument = Argument::option("revision", values::text, help::revision);
const TITLE: Argument = Argument::option("title", values::text, help::title);
const NUMBER: Argument = Argument::option("number", values::text, help::number);
const AUTHOR: Argument = Argument::option("author", values::text, help::author);
const COMPANY: Argument = Argument::option("company", values::text, help::company);
const CUSTOMER: Argument = Argument::option("customer", values::text, help::customer);
const ORDER: Argument = Argument::option("order", values::text, help::order);
const CHANGE: Argument = Argument::option("change", values::change, help::change).repeated();
const ARCHIVE: Argument = Argument::flag("archive", help::archive);

/// The fields of the title page, of every report.
pub const TITLE_PAGE: [Argument; 10] =
    [DATE, REVISION, TITLE, NUMBER, AUTHOR, COMPANY, CUSTOMER, ORDER, CHANGE, ARCHIVE];

/// A line of the list of changes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// Revision that it led to.
    pub revision: String,
    /// Day: a calendar date, or words such as "week 47".
    pub date: String,
    /// Author of the change; empty where not stated.
    pub author: String,
    /// Content of the change.
    pub text: String,
}

arguments! {
    /// Arguments of `report`: axes, actuator, chapters.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own, else the best.
        code: Option<ProductId> = argument::code(help::own_or_best_code) => some_product,
        /// Includes the derivations.
        full: bool = Argument::flag("full", help::report_full) => flag,
        /// Includes wiring, mounting and commissioning.
        installation: bool = Argument::flag("installation", help::report_installation) => flag,
        /// The day of the document.
        date: Option<NaiveDate> = DATE => day,
        /// Revision of the document.
        revision: Option<String> = REVISION => label,
        /// Project, plant or order.
        title: Option<String> = TITLE => label,
        /// Number of the document.
        number: Option<String> = NUMBER => label,
        /// Author.
        author: Option<String> = AUTHOR => label,
        /// Company or office.
        company: Option<String> = COMPANY => label,
        /// Customer.
        customer: Option<String> = CUSTOMER => label,
        /// Number of the order.
        order: Option<String> = ORDER => label,
        /// The list of changes.
        changes: Vec<Change> = CHANGE => changes,
        /// The file is written as PDF/A.
        archive: bool = ARCHIVE => flag,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "report",
    path: "report",
    about: help::report,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Media(&[media::PDF]),
    writes: &[OutputFile::of("out", &[media::PDF], help::report_out)],
    example: "axis.toml --out axis.pdf",
    answer: None,
};

impl Args {
    /// Returns the axes of the report.
    ///
    /// # Errors
    /// Faults of the project, a code for several axes.
    pub fn axes(&self, inquiry: &Inquiry<'_>) -> Result<Vec<PlacedAxis>, Unanswered> {
        let axes = inquiry.axes(self.axis.as_deref(), Cost::Report)?;
        if axes.len() > 1 && self.code.is_some() {
            let names = axes.iter().map(|(_, project)| project.name.clone()).collect();
            let sentence = |names: &str| terminal::code_is_for_one_axis(&names, inquiry.language);
            return Err(Unanswered::which_axis(names, sentence));
        }
        Ok(axes)
    }
}

/// Largest number of lines in the list of changes: some five pages.
const CHANGES_MOST: usize = 200;

/// Reads the lines of the list of changes: revision, day, author if stated, and content, between semicolons.
fn changes(given: &Given, argument: &Argument) -> Result<Vec<Change>, Unanswered> {
    let count = given.all(argument.name).count();
    if count > CHANGES_MOST {
        let fault = (terminal::too_many_changes(&count, &CHANGES_MOST, given.language()), None);
        return Err(Unanswered::option(argument.name, fault));
    }
    given.all(argument.name).map(|line| change(&bounded(argument.name, line, given.language())?, given)).collect()
}

fn change(line: &str, given: &Given) -> Result<Change, Unanswered> {
    let parts: Vec<String> = line.splitn(4, ';').map(|part| part.trim().to_owned()).collect();
    let change = match <[String; 4]>::try_from(parts) {
        Ok([revision, date, author, text]) => Change { revision, date, author, text },
        Err(parts) => match <[String; 3]>::try_from(parts) {
            Ok([revision, date, text]) => Change { revision, date, author: String::new(), text },
            Err(_) => {
                let fault = (terminal::not_a_change(&line, given.language()), None);
                return Err(Unanswered::option(CHANGE.name, fault));
            }
        },
    };
    if resembles_date(&change.date) {
        let _ = read_date(&change.date, given.language()).map_err(|fault| Unanswered::option(CHANGE.name, fault))?;
    }
    Ok(change)
}

/// Returns `true` if a text has the digits and separators of a date and no words.
fn resembles_date(text: &str) -> bool {
    text.bytes().any(|byte| byte.is_ascii_digit())
        && text.chars().all(|each| each.is_ascii_digit() || each.is_whitespace() || "-./".contains(each))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails loudly")]
mod tests {
    use super::*;
    use quantities::Language;

    fn read(pairs: &[(&'static str, &'static str)]) -> Result<Args, Unanswered> {
        let pairs = pairs.iter().map(|(name, value)| ((*name).into(), (*value).into()));
        Args::read(&Given::of(Args::ARGUMENTS, pairs, Language::default())?)
    }

    #[test]
    fn the_title_page_is_read_for_every_face() {
        let found = read(&[
            ("customer", "Example\u{202e} Machines"),
            ("order", "4711/26"),
            ("change", "B; 2026-11-21; E. Example; longer stroke; see 4"),
            ("change", "C;2026-11-22;heavier load"),
            ("archive", "true"),
        ])
        .unwrap();
        assert_eq!(
            (found.customer.as_deref(), found.order.as_deref()),
            (Some("Example\\u{202e} Machines"), Some("4711/26"))
        );
        let [first, second] = &found.changes[..] else { panic!("{found:?}") };
        assert_eq!((first.author.as_str(), first.text.as_str()), ("E. Example", "longer stroke; see 4"));
        assert_eq!((second.author.as_str(), second.text.as_str()), ("", "heavier load"));
        assert!(found.archive && !found.full);
        assert!(read(&[("change", "B; longer stroke")]).is_err());
        let changes = |count| vec![("change", "C;2026-11-22;heavier load"); count];
        assert!(read(&changes(CHANGES_MOST)).is_ok());
        let why = read(&changes(CHANGES_MOST + 1)).unwrap_err().faults(None, Language::default()).errors;
        assert!(why[0].message.contains("201") && why[0].message.contains("200"), "{why:?}");
    }

    /// A day of digits is one of the calendar; words in its place stay as they are, and so does a missing day.
    #[test]
    fn a_day_of_digits_is_one_of_the_calendar() {
        for (day, is_one) in [
            ("2026-11-21", true),
            ("2024-02-29", true),
            ("week 47, 2026", true),
            ("KW 47", true),
            ("", true),
            ("2025-13-45", false),
            ("2026-02-29", false),
            ("11/21/2026", false),
            ("2026", false),
        ] {
            let line: &'static str = format!("B; {day}; E. Example; longer stroke").leak();
            let found = read(&[("change", line)]);
            assert_eq!(found.is_ok(), is_one, "{day}: {found:?}");
            assert!(found.is_ok_and(|found| found.changes[0].date == day) == is_one, "{day}");
        }
    }

    #[test]
    fn every_field_of_the_title_page_is_an_argument_of_the_report() {
        for field in TITLE_PAGE {
            assert!(Args::ARGUMENTS.iter().any(|argument| argument.name == field.name), "{}", field.name);
        }
    }
}
