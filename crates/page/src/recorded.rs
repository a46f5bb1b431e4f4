//! A recording in the form: role and unit of each column, and the first rows of the file.

use crate::form::{Followed, RowContent};
use crate::markup::{id, vals};
use maud::{Markup, html};
use quantities::Language;
use questions::{ColumnRole, Preview, recording_preview, recording_roles};
use words::{capitalised, page, role_text};

/// The keys shown here instead of as rows.
pub(crate) const KEYS: [&str; 2] = ["columns", "units"];

/// The word of the project file for a role that no column has.
const NO_COLUMN: &str = "none";

/// Returns the first rows of a recording as a table.
pub(crate) fn rows(preview: &Preview, language: Language) -> Markup {
    html! {
        div.wide tabindex="0" role="region" aria-label=(page::first_rows(language)) {
            table {
                thead { tr { @for column in &preview.columns { th scope="col" { (column.heading) } } } }
                tbody { @for row in &preview.rows { tr { @for cell in row { td { (cell) } } } } }
            }
        }
    }
}

/// Returns the recognised columns with their alternatives, and the first rows of the file below them.
pub(crate) fn columns(form: &RowContent<'_>, path: &str, solved: Option<&Followed>) -> Markup {
    let file = form.value(&format!("{path}.file")).unwrap_or_default();
    let preview = recording_preview(file, form.files);
    let columns = preview.as_ref().map(|found| found.columns.as_slice()).unwrap_or_default();
    let headings: Vec<String> = columns.iter().map(|column| column.heading.clone()).collect();
    html! {
        @if let Some(read) = solved.and_then(|solved| solved.recording.as_ref()) { p.small { (read) } }
        div.recorded id={ (id(path)) "-columns" } {
            @for (name, role, units) in recording_roles() {
                @let read = solved.and_then(|solved| solved.columns.iter().find(|(of, ..)| *of == role));
                (role_row(form, path, (name, role), &headings, &units, read))
            }
        }
        @if let Some(preview) = &preview { (first_rows(path, preview, form)) }
    }
}

fn role_row(
    form: &RowContent<'_>,
    path: &str,
    (name, role): (&str, ColumnRole),
    headings: &[String],
    units: &[&str],
    read: Option<&(ColumnRole, String, &'static str)>,
) -> Markup {
    let l = form.language;
    let [column, unit] = KEYS.map(|table| format!("{path}.{table}.{name}"));
    let stated = form.value(&column).unwrap_or_default();
    let stated_unit = form.value(&unit).unwrap_or_default();
    let what = capitalised(&role_text(role, l));
    // A column recognised without an entry is named in the first option.
    let found = read.filter(|_| stated.is_empty()).map(|(_, name, _)| name.as_str());
    let found_unit = read.filter(|_| stated_unit.is_empty()).map(|(.., unit)| *unit);
    let is_wrong = |path: &str| (!form.fault_at(path).0.is_empty()).then_some("true");
    let other = !stated.is_empty() && stated != NO_COLUMN && !headings.iter().any(|heading| heading == stated);
    html! {
        div.row data-path=(column) {
            span id={ (id(&column)) "-l" } { (what) }
            span.two {
                select id=(id(&column)) name="value" data-chosen=(stated) aria-labelledby={ (id(&column)) "-l" }
                    aria-invalid=[is_wrong(&column)] aria-describedby={ (id(&column)) "-x" }
                    hx-post="/work" hx-trigger="change" hx-vals=(vals(&[("path", &column)])) {
                    option value="" selected[stated.is_empty()] { (page::recognised(&found.unwrap_or("–"), l)) }
                    @for heading in headings { option value=(heading) selected[heading == stated] { (heading) } }
                    @if other { option value=(stated) selected { (stated) } }
                    option value=(NO_COLUMN) selected[stated == NO_COLUMN] { (page::no_column(l)) }
                }
                select id=(id(&unit)) name="value" data-chosen=(stated_unit) aria-label=(page::unit_of(&what, l))
                    aria-invalid=[is_wrong(&unit)] aria-describedby={ (id(&unit)) "-x" }
                    hx-post="/work" hx-trigger="change" hx-vals=(vals(&[("path", &unit)])) {
                    option value="" selected[stated_unit.is_empty()] { (page::recognised(&found_unit.unwrap_or("–"), l)) }
                    @for each in units { option value=(each) selected[*each == stated_unit] { (each) } }
                    @if !stated_unit.is_empty() && !units.contains(&stated_unit) { option value=(stated_unit) selected { (stated_unit) } }
                }
            }
            @for path in [&column, &unit] { div id={ (id(path)) "-x" } { (form.fault_at(path)) } }
        }
    }
}

fn first_rows(path: &str, preview: &Preview, form: &RowContent<'_>) -> Markup {
    let l = form.language;
    html! {
        details id={ (id(path)) "-rows" } {
            summary { (page::first_rows(l)) }
            (rows(preview, l))
        }
    }
}
