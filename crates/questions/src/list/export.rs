//! `export PROJECT`: the results as a workbook or one table; a face writes it.

use super::given::{arguments, count, day, label, some_product, text};
use super::{
    AXIS, Argument, ArgumentKind, Cost, Entry, Gives, Inquiry, OutputFile, PlacedAxis, Reads, Record, Unanswered,
    argument, media,
};
use chrono::NaiveDate;
use configurator::ProductId;
use words::{help, help::values, requests, terminal};

/// Names of the tables, in the order of a workbook.
pub const TABLES: [&str; 7] = ["inputs", "assumptions", "demand", "motion", "candidates", "checks", "course"];

/// Formats, by the extensions of their files.
pub const FORMATS: [&str; 4] = ["json", "csv", "parquet", "xlsx"];

arguments! {
    /// Arguments of `export`: axes, actuator, tables.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own, else the best.
        code: Option<ProductId> = argument::code(help::export_code) => some_product,
        /// One table; without it the workbook.
        table: Option<String> = Argument::option("table", values::name, help::export_table)
            .of(ArgumentKind::Word(|| TABLES.to_vec())) => text,
        /// The format; on the command line the extension of the file.
        format: Option<String> = Argument::option("format", values::format, requests::format)
            .of(ArgumentKind::Word(|| FORMATS.to_vec())) => text,
        /// Number of candidates of the ranking in the tables.
        top: usize = argument::top("20", help::export_top) => count,
        /// The revision for the first sheet.
        revision: Option<String> = Argument::option("revision", values::text, help::export_revision) => label,
        /// The day for the first sheet.
        date: Option<NaiveDate> = Argument::option("date", values::date, help::export_date).of(ArgumentKind::Date) => day,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "export",
    path: "export",
    about: help::export,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::RecordOr(Record::of::<answers::Table>("export --table"), &[media::XLSX, media::CSV, media::PARQUET]),
    writes: &[OutputFile::of("out", &[media::XLSX, media::CSV, media::JSON, media::PARQUET], help::export_out)],
    example: "axis.toml --out axis.xlsx",
    answer: None,
};

impl Args {
    /// Returns the axes to write, each with the place of its text among those of the call: one for a table, all for a workbook.
    ///
    /// # Errors
    /// Faults of the projects, several axes without a name for a table or with a code.
    pub fn axes(&self, inquiry: &Inquiry<'_>) -> Result<Vec<(usize, PlacedAxis)>, Unanswered> {
        let is_table = self.table.is_some();
        Unanswered::unless_right([
            ("revision", is_table && self.revision.is_some(), requests::of_a_workbook_only(inquiry.language)),
            ("date", is_table && self.date.is_some(), requests::of_a_workbook_only(inquiry.language)),
        ])?;
        inquiry.source()?;
        let (mut axes, mut faults) = (Vec::new(), Vec::new());
        for (place, source) in inquiry.sources.iter().enumerate() {
            match inquiry.axes_of(source, self.axis.as_deref()) {
                Ok(found) => axes.extend(found.into_iter().map(|axis| (place, axis))),
                Err(fault) => faults.push(fault),
            }
        }
        if !faults.is_empty() {
            return Err(Unanswered::combined(faults));
        }
        let name = |(_, (_, project)): &(usize, PlacedAxis)| project.name.clone();
        let names = || axes.iter().map(name).collect();
        if axes.len() > 1 && is_table {
            return Err(Unanswered::which_axis(names(), |names| {
                terminal::table_is_of_one_axis(&names, inquiry.language)
            }));
        }
        if axes.len() > 1 && self.code.is_some() {
            return Err(Unanswered::which_axis(names(), |names| {
                terminal::code_is_for_one_axis(&names, inquiry.language)
            }));
        }
        let cost = if self.table.as_deref() == Some("course") { Cost::Course } else { Cost::Workbook };
        inquiry.within(cost, axes.iter().map(|(_, axis)| axis))?;
        Ok(axes)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails loudly")]
mod tests {
    use super::super::{Given, LIST, report};
    use super::*;
    use quantities::Language;

    /// Every argument that is a date by its name in the help is one of the kind, and a day that the calendar does not
    /// have is refused, for the workbook and the report too.
    #[test]
    fn a_date_is_one_of_the_calendar() {
        let name = |each: &&Argument| (each.value)(Language::default()) == values::date(Language::default());
        let dates = LIST.iter().flat_map(|entry| entry.arguments).filter(name);
        let of_kind = dates.clone().filter(|each| matches!(each.kind, ArgumentKind::Date)).count();
        assert!(of_kind >= 4 && of_kind == dates.count(), "{of_kind}");
        let day = |arguments: &[Argument], text: &'static str| {
            Given::of(arguments, [("date".into(), text.into())], Language::default())
        };
        for (text, expected) in [
            ("2026-11-21", Some(Some("2026-11-21"))),
            (" 2024-02-29 ", Some(Some("2024-02-29"))),
            ("", Some(None)),
            ("2025-13-45", None),
            ("2026-02-29", None),
            ("21.11.2026", Some(Some("2026-11-21"))),
            ("yesterday", None),
        ] {
            let of_export = day(Args::ARGUMENTS, text).and_then(|given| Args::read(&given)).map(|found| found.date);
            let of_report = day(report::Args::ARGUMENTS, text).and_then(|given| report::Args::read(&given));
            for found in [of_export, of_report.map(|found| found.date)] {
                let found = found.ok();
                let found = found.map(|date| date.map(|date| date.to_string()));
                assert_eq!(found.as_ref().map(Option::as_deref), expected, "{text}");
            }
        }
    }
}
