//! Measured values of a commissioning, typed and judged at once: the record that the command line reads.

use super::code::incomplete;
use super::field::{MARK, ToolField, Trouble};
use super::scene::{GOOD, Scene};
use crate::checks::verdict_class;
use crate::markup::vals;
use crate::placed::placed;
use maud::{Markup, html};
use project::{About, Edit, Key, Kind, MEASURED_KEYS, MeasuredKey, Written, edit_measured, measured_key_at, written};
use quantities::{Language, Unit};
use questions::list::commission::{Commissioning, DriveForm, commission, usual_ambient};
use questions::list::commission_record::{judge, measured};
use questions::{answer, chapter, read_code};
use words::{
    Worded, capitalised, commission as commissioning, measured_key_text, measured_label, page, terminal, terms,
    verdict_word,
};

/// Field of the text of the record, which is not one of its keys.
const TEXT: &str = "text";
const WAS: &str = "was";
const DO: &str = "do";
const FILE: &str = "file";
const KNOWN: &str = "known";
const OPEN: &str = "open";

/// Table that may occur several times in a record.
const SEVERAL: &str = "no_load";

pub(super) fn shown(scene: &Scene<'_>) -> Markup {
    let l = scene.language;
    let code = match read_code(&scene.about, l) {
        Ok(reading) => reading.parsed.code,
        Err(fault) => return html! { (kept(scene)) div id="tool-answer" { (incomplete(&scene.about, &fault, l)) } },
    };
    let Some(about) = commission(&code) else { return html! { p.unchecked { (terminal::no_data(l)) } } };
    let (text, file, known) = state(scene, &about);
    let read = measured(&text);
    let keys = written(&text);
    let good = if read.is_ok() { text.clone() } else { scene.typed(GOOD).unwrap_or_default() };
    let faults: Vec<(Option<String>, Worded)> = match &read {
        Ok(_) => Vec::new(),
        Err(found) => placed(found, (&text, keys.as_deref().unwrap_or_default()), measured_key_at, l),
    };
    let sheet = answer::commissioning(&about, DriveForm::Plain, usual_ambient(), l);
    let form = Form {
        about: &about,
        sheet: &sheet,
        written: keys.as_deref().unwrap_or_default(),
        faults: &faults,
        language: l,
    };
    let judged = read.as_ref().ok().cloned().or_else(|| measured(&good).ok());
    html! {
        input type="hidden" name={ (MARK) (GOOD) } value=(good);
        input type="hidden" name={ (MARK) (WAS) } value=(text);
        input type="hidden" id="record-known" name={ (MARK) (KNOWN) } value=(known);
        p.downloads {
            label.inline { span { (page::save_as(l)) } input id="record-file" name={ (MARK) (FILE) } type="text" size="26" value=(file); }
            @let is_kept = scene.shell.folder().is_some();
            @if is_kept { button.primary type="button" data-record="save" { (page::save(l)) } " " }
            button class=[(!is_kept).then_some("primary")] type="button" data-record="download" { (page::record_file(l)) } " "
            button type="button" data-record="open" { (page::open(l)) }
        }
        p id="record-status" role="status" hx-morph-skip="" {}
        (records(scene))
        @for (path, fault) in &faults { @if !form.has_field(path.as_deref()) {
            p.fault { (page::at_line(&fault.line, &fault.column, l)) ": " (crate::sentences::worded(&fault.message, fault.hint.as_deref(), l)) }
        } }
        fieldset id="record-fields" disabled[keys.is_none()] {
            @for key in MEASURED_KEYS { (form.table(key)) }
        }
        details id="record-pane" {
            summary { (page::record_as_text(l)) }
            textarea id="record-text" name={ (MARK) (TEXT) } rows="12" spellcheck="false" aria-label=(page::record_as_text(l)) { "\n" (text) }
        }
        div id="tool-answer" aria-live="polite" class=[read.is_err().then_some("old")] {
            @if let Some(found) = judged {
                @if read.is_err() { p.advice { (page::answer_is_old(l)) } }
                (judgement(&answer::recorded(&about, &judge(&about, &found), l), l))
            }
        }
    }
}

/// Returns the entries, kept while there is no code for them.
fn kept(scene: &Scene<'_>) -> Markup {
    html! { @for name in [TEXT, WAS, FILE, KNOWN, GOOD] { input type="hidden" name={ (MARK) (name) } value=(scene.typed(name).unwrap_or_default()); } }
}

/// Returns the text with the changes, the name of its file and the version that was opened.
fn state(scene: &Scene<'_>, about: &Commissioning) -> (String, String, String) {
    let typed = |name: &str| scene.typed(name).unwrap_or_default().replace("\r\n", "\n");
    let (mut text, was, file, known) = (typed(TEXT), typed(WAS), typed(FILE), typed(KNOWN));
    let opened = typed(OPEN);
    if text.trim().is_empty()
        && let Some(Ok(bytes)) = scene.shell.folder().filter(|_| !opened.is_empty()).map(|folder| folder.read(&opened))
        && let Ok(found) = std::str::from_utf8(&bytes)
    {
        let known = format!("{} {opened}", scene.shell.version(&bytes));
        return (found.to_owned(), opened, known);
    }
    if text.trim().is_empty() {
        let title = capitalised(&commissioning::title(&about.code, scene.language));
        text = format!("# {title}\nformat = 1\n");
    } else if text == was {
        // If the text itself is unchanged, the values of the fields are written into it.
        text = with_fields(text, scene);
    }
    let file = if file.trim().is_empty() { format!("{}-measured.toml", about.code) } else { file };
    (text, file, known)
}

fn with_fields(mut text: String, scene: &Scene<'_>) -> String {
    let there = written(&text).unwrap_or_default();
    let stands = |path: &str| there.iter().find(|key| key.path == path).and_then(|key| key.value.clone());
    let fields: Vec<(String, String)> = scene
        .call
        .fields()
        .filter_map(|(key, value)| Some((key.strip_prefix(MARK)?.to_owned(), value.trim().to_owned())))
        .filter(|(path, _)| path.contains('.'))
        .collect();
    for (path, value) in fields {
        if stands(&path).unwrap_or_default() != value {
            text = edit_measured(&text, &path, Edit::Value(&value)).unwrap_or(text);
        }
    }
    let asked = scene.typed(DO).unwrap_or_default();
    match asked.split_once(' ') {
        Some(("add", path)) => edit_measured(&text, path, Edit::Table).unwrap_or(text),
        Some(("gone", path)) => edit_measured(&text, path, Edit::Gone).unwrap_or(text),
        _ => text,
    }
}

/// Largest number of files of the folder that are read.
const LOOKED_INTO: usize = 40;

/// Returns the records in the folder, the latest first.
fn records(scene: &Scene<'_>) -> Markup {
    let l = scene.language;
    let Some(folder) = scene.shell.folder() else { return html! {} };
    let is_record = |name: &str| {
        let bytes = folder.read(name).unwrap_or_default();
        std::str::from_utf8(&bytes).is_ok_and(|text| measured(text).is_ok())
    };
    let all = folder.list().unwrap_or_default();
    let found: Vec<String> =
        all.into_iter().take(LOOKED_INTO).map(|entry| entry.name).filter(|name| is_record(name)).collect();
    html! { @if !found.is_empty() {
        details id="record-files" { summary { (page::folder(l)) } ul.plain { @for name in &found {
            li { a href=(scene.address(&[(OPEN, name)])) { (name) } }
        } } }
    } }
}

/// Data for drawing the fields of a record.
struct Form<'f> {
    about: &'f Commissioning,
    /// Checklists of the code at the default temperature.
    sheet: &'f answers::Commissioning,
    written: &'f [Written],
    faults: &'f [(Option<String>, Worded)],
    language: Language,
}

impl Form<'_> {
    /// Returns the paths of a table: several if the record has several.
    fn paths(&self, key: &Key) -> Vec<String> {
        if key.name != SEVERAL {
            return vec![key.name.to_owned()];
        }
        let there = |path: &String| self.written.iter().any(|key| key.path == *path);
        let alone = Some(key.name.to_owned()).filter(there);
        alone.into_iter().chain((1..).map(|place| format!("{SEVERAL}[{place}]")).take_while(there)).collect()
    }

    fn has_field(&self, path: Option<&str>) -> bool {
        let Some(path) = path else { return false };
        MEASURED_KEYS.iter().any(|key| match key.kind {
            Kind::Table(keys) | Kind::OneOrMany(_, keys) => self.paths(key).iter().any(|table| {
                self.is_shown(key) && (path == table || keys.iter().any(|key| path == format!("{table}.{}", key.name)))
            }),
            _ => false,
        })
    }

    /// Returns `true` if the code has the subject of a table, or the record states it.
    fn is_shown(&self, key: &Key) -> bool {
        key.name != "brake" || self.about.has_brake() || self.written.iter().any(|there| there.path == key.name)
    }

    fn table(&self, key: &Key) -> Markup {
        let l = self.language;
        let (Kind::Table(keys) | Kind::OneOrMany(_, keys)) = key.kind else { return html! {} };
        if !self.is_shown(key) {
            return html! {};
        }
        let About::Measured(purpose) = key.about else { return html! {} };
        let paths = self.paths(key);
        html! {
            fieldset id={ "record-" (key.name) } {
                legend { (capitalised(measured_label(purpose, l))) }
                p.small { (measured_key_text(purpose, l)) }
                @for path in &paths {
                    @for (_, fault) in self.faults.iter().filter(|(at, _)| at.as_deref() == Some(path)) { (trouble(fault).shown(self.language)) }
                    div.rows { @for key in keys { (self.row(key, path)) } }
                    @if key.name == SEVERAL {
                        button.small type="button" aria-label=(page::remove(&path, l)) hx-post="/tools" hx-target="#tool" hx-select="#tool" hx-swap="outerMorph"
                            hx-include="#state, [form=state]" hx-vals=(vals(&[("t_do", &format!("gone {path}"))])) { "×" }
                    }
                }
                @if key.name == SEVERAL {
                    @let next = format!("add {SEVERAL}[{}]", paths.len() + 1);
                    button type="button" hx-post="/tools" hx-target="#tool" hx-select="#tool" hx-swap="outerMorph"
                        hx-include="#state, [form=state]" hx-vals=(vals(&[("t_do", &next)])) { (page::add_entry(l)) }
                }
            }
        }
    }

    fn row(&self, key: &Key, table: &str) -> Markup {
        let l = self.language;
        let About::Measured(purpose) = key.about else { return html! {} };
        if key.name == "ptc" && !self.about.has_ptc() && self.value(&format!("{table}.{}", key.name)).is_none() {
            return html! {};
        }
        let path = format!("{table}.{}", key.name);
        let mut field = ToolField::of_key(&path, &capitalised(measured_label(purpose, l)), key, l);
        field.remark = Some(self.remark(purpose));
        field.value = self.value(&path).unwrap_or_default().to_owned();
        field.troubles = self
            .faults
            .iter()
            .filter(|(at, _)| at.as_deref() == Some(&path))
            .map(|(_, fault)| trouble(fault))
            .collect();
        field.shown(l)
    }

    /// Returns the purpose of a field, and the expected value of the checklist.
    fn remark(&self, purpose: MeasuredKey) -> String {
        let l = self.language;
        let about = measured_key_text(purpose, l);
        let id = axis::measurand(purpose).map(|what| what.id());
        let entries = || self.sheet.lists.iter().flat_map(|list| &list.entries);
        match entries().find(|entry| entry.field && Some(entry.id) == id) {
            Some(entry) => {
                let unit = entry.unit.and_then(Unit::of).map_or("", |unit| unit.symbol_in(l));
                format!("{about}; {}: {} {unit}", entry.text, entry.shown)
            }
            None => about.to_owned(),
        }
    }

    fn value(&self, path: &str) -> Option<&str> {
        self.written.iter().find(|key| key.path == path)?.value.as_deref()
    }
}

fn trouble(fault: &Worded) -> Trouble {
    Trouble { field: None, message: fault.message.clone(), hint: fault.hint.clone() }
}

fn judgement(found: &answers::Recorded, language: Language) -> Markup {
    let l = language;
    let heads = [
        commissioning::measured(l),
        terms::verdict(l),
        terms::value(l),
        commissioning::expected(l),
        terms::unit(l),
        terms::remark(l),
    ];
    html! {
        h3 { (capitalised(commissioning::record_summary(&found.off, &found.not_checked, l).as_str())) }
        div.wide tabindex="0" { table.checks {
            thead { tr { @for head in heads { th scope="col" { (crate::tip::of_word(head, l)) } } } }
            tbody { @for line in chapter::recorded(found, l) { tr class=(verdict_class(line.verdict)) {
                th scope="row" { (line.name) }
                td { span.verdict { (verdict_word(line.verdict, l)) } }
                td.number { (line.value) } td.number { (line.expected) } td { (line.unit) }
                td.small { (line.remark) @if let Some(cause) = &line.cause { br; strong { (cause) } } }
            } } }
        } }
        @for erratum in chapter::marked_errata(&found.errata, l) { p.small { (erratum) } }
    }
}
