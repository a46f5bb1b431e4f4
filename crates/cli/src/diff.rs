//! `diff`: effect of another revision of a project on an actuator.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::compare::{names, shown};
use crate::table::{Align, TextTable, labelled};
use project::InputChange;
use quantities::{Language, format_number};
use questions::list::diff::{CheckChange, Difference, revisions};
use questions::list::{Inquiry, Unanswered};
use questions::texts::{ValuesInRow, margin_share, percent, verdict_of, verdict_text};
use questions::{Candidate, Check, ProductId, answer};
use std::fmt::Write as _;
use words::{check_title, terminal, terms};

/// `antrieb diff OLD NEW`
pub(crate) fn diff(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let found = revisions(inquiry)?;
    let texts =
        found.each(inquiry, |name, changed, inputs| (text(changed, name, inputs, language), changed.after.fits()))?;
    Ok(CommandAnswer { talk: found.unpaired(inquiry), ..CommandAnswer::of_axes(texts) })
}

fn text(found: &Difference<'_>, name: &str, inputs: &[InputChange], language: Language) -> String {
    let mut out = String::new();
    let head = if name.is_empty() { String::new() } else { format!("{name}: ") };
    let (before, after) = (verdict_of(&found.before, language), verdict_of(&found.after, language));
    let share = |of: &Candidate<'_>| percent(of.utilisation().filter(|share| share.is_finite()), language);
    let _ = writeln!(
        out,
        "{head}{} {before} ({} %) → {after} ({} %)",
        found.after.id,
        share(&found.before),
        share(&found.after),
    );
    let none = terminal::none_fits(language);
    let best = |id: &Option<ProductId>| id.as_ref().map_or_else(|| none.to_owned(), ToString::to_string);
    let word = terminal::best_of_the_catalogue(language);
    let (first, second) = (best(&found.best_before), best(&found.best_after));
    let _ = if first == second {
        writeln!(out, "{word}: {first}, {}", terminal::as_before(language))
    } else {
        writeln!(out, "{word}: {first} → {second}")
    };
    out.push('\n');
    out.push_str(&changed_inputs(inputs, language));
    out.push_str(&demand(found, language));
    out.push_str(&checks(&found.checks, language));
    for objection in answer::objections(&found.after, language) {
        out.push_str(&labelled(terms::requirement_not_met(language), &objection));
    }
    out
}

fn changed_inputs(inputs: &[InputChange], language: Language) -> String {
    if inputs.is_empty() {
        return format!("{}\n\n", terminal::no_input_changed(language));
    }
    let mut table = TextTable::new([
        (terminal::input(language), Align::Left),
        (terminal::before(language), Align::Left),
        (terminal::after(language), Align::Left),
    ]);
    let written = |text: &Option<String>| text.clone().unwrap_or_else(|| "–".to_owned());
    for change in inputs {
        table.row([change.path.clone(), written(&change.old), written(&change.new)]);
    }
    format!("{}\n", table.render())
}

fn demand(found: &Difference<'_>, language: Language) -> String {
    if found.demand.iter().all(|row| row.values.iter().all(Option::is_none)) {
        return format!("{}\n\n", terminal::demand_not_known(language));
    }
    let rows: Vec<_> = found.demand.iter().filter(|row| !row.is_same()).collect();
    if rows.is_empty() {
        return format!("{}\n\n", terminal::same_demand(language));
    }
    let mut table = TextTable::new([
        (terms::demand(language), Align::Left),
        (terms::unit(language), Align::Left),
        (terminal::before(language), Align::Right),
        (terminal::after(language), Align::Right),
    ]);
    for row in rows {
        let mut cells = names(row, language).to_vec();
        cells.extend(row.values.iter().map(|value| shown(*value, language)));
        table.row(cells);
    }
    format!("{}\n", table.render())
}

fn checks(changes: &[CheckChange], language: Language) -> String {
    let (same, other): (Vec<&CheckChange>, Vec<&CheckChange>) = changes.iter().partition(|change| change.is_same());
    let mut out = String::new();
    if !other.is_empty() {
        let (before, after) = (terminal::before(language), terminal::after(language));
        let [before_percent, after_percent] = [before, after].map(|word| format!("{word} %"));
        let mut table = TextTable::new([
            (terms::check(language), Align::Left),
            (terms::verdict(language), Align::Left),
            (before, Align::Right),
            (after, Align::Right),
            (terms::unit(language), Align::Left),
            (before_percent.as_str(), Align::Right),
            (after_percent.as_str(), Align::Right),
            (terminal::change(language), Align::Right),
        ]);
        for change in other {
            table.row(changed(change, language));
        }
        out.push_str(&table.render());
    }
    if !same.is_empty() {
        let titles: Vec<String> = same.iter().map(|change| check_title(change.id, language)).collect();
        out.push_str(&labelled(terminal::unchanged(language), &titles.join(" · ")));
    }
    out
}

/// Returns the cells of a changed check.
fn changed(change: &CheckChange, language: Language) -> [String; 8] {
    let none = || "–".to_owned();
    let word = |check: &Option<Check>| check.as_ref().map_or_else(none, |check| verdict_text(check, language));
    let values = ValuesInRow::of([change.before.as_ref(), change.after.as_ref()]);
    let value = |check: &Option<Check>| check.as_ref().map_or_else(none, |check| values.value(check, language));
    let share = |check: &Option<Check>| percent(check.as_ref().and_then(margin_share), language);
    let (before, after) = (word(&change.before), word(&change.after));
    let by = change.change().map_or_else(none, |by| {
        format!("{}{}", if by > 0.0 { "+" } else { "" }, format_number(by * 100.0, 1, language))
    });
    [
        check_title(change.id, language),
        if before == after { after } else { format!("{before} → {after}") },
        value(&change.before),
        value(&change.after),
        values.unit(language).to_owned(),
        share(&change.before),
        share(&change.after),
        by,
    ]
}
