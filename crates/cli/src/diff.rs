//! `diff`: what another revision of a project does to an actuator.

use crate::answer::Answer;
use crate::code::parse_for_use;
use crate::compare::{names, shown, verdict};
use crate::fault::{Source, simple};
use crate::subject::{Part, in_reach, picked, refuse, together};
use crate::table::{Align, Table, labelled};
use crate::waiting::patience;
use clap::ArgMatches;
use std::fmt::Write as _;
use std::path::PathBuf;
use workbench::quantities::format_number;
use workbench::text::{check_title, terminal, terms, verdict_word};
use workbench::{
    CandidateId, Check, CheckChange, Difference, InputChange, Language, OrderCode, Project, Question, answer, answers,
};
use workbench::{figure_text, percent};

/// An axis with its place in its file.
type Axis = (usize, Project);

/// `antrieb diff OLD NEW`
pub(crate) fn diff(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    answer(matches, as_json, language).unwrap_or_else(|fault| fault)
}

fn answer(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Answer, Answer> {
    let mut talk = String::new();
    let code = match matches.get_one::<String>("code") {
        None => None,
        Some(text) => {
            let (reading, note) = parse_for_use(text, as_json, language)?;
            talk = note;
            Some(reading.parsed.code)
        }
    };
    let read = |which: &str| -> Result<(Source, Vec<Axis>), Answer> {
        let path = matches.get_one::<PathBuf>(which).cloned().unwrap_or_default();
        let source = Source::read(&path, matches, as_json, language)?;
        let axes = picked(source.projects(as_json, language)?, matches, as_json, language)?;
        Ok((source, axes))
    };
    let ((old_file, old), (new_file, new)) = (read("old")?, read("new")?);
    in_reach(Question::Other, old.iter().chain(&new).map(|(_, project)| project), as_json, language)?;
    let pairs = workbench::paired(&old, &new);
    let told = |axis: &Axis, file: &Source, paired: bool| {
        let (name, file) = (&axis.1.name, &file.name);
        (!paired).then(|| format!("{}\n", terminal::axis_is_only_in(&name, &file, language)))
    };
    for (index, axis) in old.iter().enumerate() {
        talk.extend(told(axis, &old_file, pairs.iter().any(|pair| pair.0 == index)));
    }
    for (index, axis) in new.iter().enumerate() {
        talk.extend(told(axis, &new_file, pairs.iter().any(|pair| pair.1 == index)));
    }
    if pairs.is_empty() {
        let what = terminal::no_common_axis(language);
        let mut fault = simple(what, as_json, language);
        fault.talk = talk + &fault.talk;
        return Err(fault);
    }
    let mut answers = Vec::new();
    for (before, after) in pairs {
        let (Some(before), Some(after)) = (old.get(before), new.get(after)) else { continue };
        let inputs = workbench::input_changes((&old_file.text, before.0), (&new_file.text, after.0));
        answers.push(axis(&before.1, &after.1, &inputs, code.as_ref(), as_json, language));
    }
    let mut answer = together(answers, as_json);
    answer.talk = talk + &answer.talk;
    Ok(answer)
}

fn axis(
    old: &Project,
    new: &Project,
    inputs: &[InputChange],
    code: Option<&OrderCode>,
    as_json: bool,
    language: Language,
) -> Result<Part<answers::Difference>, Answer> {
    let found =
        workbench::difference(old, new, code, patience()).map_err(|refusal| refuse(&refusal, as_json, language))?;
    let record = || answer::difference(&found, inputs, &new.name, language);
    Ok(Part::of(as_json, found.after.fits(), record, || text(&found, &new.name, inputs, language)))
}

fn text(found: &Difference<'_>, name: &str, inputs: &[InputChange], language: Language) -> String {
    let mut out = String::new();
    let head = if name.is_empty() { String::new() } else { format!("{name}: ") };
    let (before, after) = (verdict(&found.before, language), verdict(&found.after, language));
    let share = |share: f64| percent(share.is_finite().then_some(share), language);
    let _ = writeln!(
        out,
        "{head}{} {before} ({} %) → {after} ({} %)",
        found.after.id,
        share(found.before.standing.utilisation),
        share(found.after.standing.utilisation),
    );
    let none = terminal::none_fits(language);
    let best = |id: &Option<CandidateId>| id.as_ref().map_or_else(|| none.to_owned(), ToString::to_string);
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
    let mut table = Table::new([
        (terminal::input(language), Align::Left),
        (terminal::before(language), Align::Left),
        (terminal::after(language), Align::Left),
    ]);
    let written = |text: &Option<String>| text.clone().unwrap_or_else(|| "–".to_owned());
    for change in inputs {
        table.push(vec![change.path.clone(), written(&change.old), written(&change.new)]);
    }
    format!("{}\n", table.render())
}

fn demand(found: &Difference<'_>, language: Language) -> String {
    let rows: Vec<_> = found.demand.iter().filter(|row| !row.is_same()).collect();
    if rows.is_empty() {
        return format!("{}\n\n", terminal::same_demand(language));
    }
    let mut table = Table::new([
        (terms::demand(language), Align::Left),
        (terms::unit(language), Align::Left),
        (terminal::before(language), Align::Right),
        (terminal::after(language), Align::Right),
    ]);
    for row in rows {
        let mut cells = names(row, language).to_vec();
        cells.extend(row.values.iter().map(|value| shown(*value, language)));
        table.push(cells);
    }
    format!("{}\n", table.render())
}

fn checks(changes: &[CheckChange], language: Language) -> String {
    let (same, other): (Vec<&CheckChange>, Vec<&CheckChange>) = changes.iter().partition(|change| change.is_same());
    let mut out = String::new();
    if !other.is_empty() {
        let (before, after) = (terminal::before(language), terminal::after(language));
        let [before_percent, after_percent] = [before, after].map(|word| format!("{word} %"));
        let mut table = Table::new([
            (terms::check(language), Align::Left),
            (terms::verdict(language), Align::Left),
            (before, Align::Right),
            (after, Align::Right),
            (terms::unit(language), Align::Left),
            (&before_percent, Align::Right),
            (&after_percent, Align::Right),
            (terminal::change(language), Align::Right),
        ]);
        for change in other {
            table.push(changed(change, language));
        }
        out.push_str(&table.render());
    }
    if !same.is_empty() {
        let titles: Vec<String> = same.iter().map(|change| check_title(change.id, language)).collect();
        out.push_str(&labelled(terminal::unchanged(language), &titles.join(" · ")));
    }
    out
}

/// The cells of a check that is not the same.
fn changed(change: &CheckChange, language: Language) -> Vec<String> {
    let none = || "–".to_owned();
    let word = |check: &Option<Check>| check.as_ref().map_or_else(none, |check| verdict_word(check.verdict, language));
    let value = |check: &Option<Check>| figure_text(check.as_ref().and_then(|check| check.value), language);
    let share = |check: &Option<Check>| percent(check.as_ref().and_then(|check| check.utilisation), language);
    let (before, after) = (word(&change.before), word(&change.after));
    let unit = [&change.after, &change.before].into_iter().flatten().find_map(|check| check.value.or(check.limit));
    let by = change.change().map_or_else(none, |by| {
        format!("{}{}", if by > 0.0 { "+" } else { "" }, format_number(by * 100.0, 1, language))
    });
    vec![
        check_title(change.id, language),
        if before == after { after } else { format!("{before} → {after}") },
        value(&change.before),
        value(&change.after),
        unit.map_or("–", |figure| if figure.unit.symbol == "1" { "–" } else { figure.unit.symbol }).to_owned(),
        share(&change.before),
        share(&change.after),
        by,
    ]
}
