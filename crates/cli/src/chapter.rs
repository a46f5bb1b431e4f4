//! `curve`, `bearing`, `battery`, `new`: chapters that are answered alone.

use crate::answer::Answer;
use crate::code::parse_for_use;
use crate::fault::{option_fault, path_text, quantity, simple};
use crate::plot;
use crate::save::save;
use crate::subject::{Part, axes_of, refuse, together};
use crate::table::{Align, Table};
use clap::ArgMatches;
use std::path::{Path, PathBuf};
use workbench::answers::{Bearings, FilesWritten};
use workbench::quantities::unit::{NEWTON_METRE, REVOLUTION_PER_MINUTE, VOLT};
use workbench::quantities::{ElectricPotential, Measure, Time, Torque, format_significant};
use workbench::text::{check_title, curve_title, grade_word, source_text, terminal, terms, verdict_word};
use workbench::{Candidate, Language, Question, Size, Verdict, answer};

/// `antrieb curve CODE`
pub(crate) fn curve(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let text = matches.get_one::<String>("code").map_or("", String::as_str);
    let (reading, talk) = match parse_for_use(text, as_json, language) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    let voltage = match quantity::<ElectricPotential>(matches, "voltage", as_json, language) {
        Ok(voltage) => voltage,
        Err(answer) => return answer,
    };
    if plot::is_asked(matches)
        && let Err(answer) = plot::destination(matches, &[], as_json, language)
    {
        return answer;
    }
    let code = reading.parsed.code;
    let Some(Ok(curves)) = workbench::curves(&code, voltage) else {
        return refuse(&workbench::Refusal::NoData, as_json, language);
    };
    if plot::is_asked(matches) {
        let Some(Ok(plane)) = workbench::plane_of(&code, voltage) else {
            return refuse(&workbench::Refusal::NoData, as_json, language);
        };
        let answer = plot::put(&figures::curves(&code, &plane, language), matches, &[], as_json, language);
        return Answer { talk: talk + &answer.talk, ..answer };
    }
    if as_json {
        return Answer { talk, ..Answer::record(&answer::curves(&code, &curves, language)) };
    }
    let mut out = format!("{code}\n");
    for curve in &curves {
        let volts = curve.voltage.map_or_else(String::new, |voltage| {
            format!(", {} {}", format_significant(voltage.in_unit(&VOLT), 3, language), VOLT.symbol)
        });
        out.push_str(&format!(
            "\n{}{volts}: {}, {}\n",
            curve_title(&curve.kind, language),
            grade_word(curve.grade, language),
            source_text(&curve.source, language)
        ));
        let (speed, torque, upper) = ("n min⁻¹", "T Nm", terminal::up_to_nm(language));
        let mut table = Table::new([(speed, Align::Right), (torque, Align::Right), (upper, Align::Right)]);
        let shown = |value: f64| format_significant(value, 4, language);
        let newton_metres =
            |torque: Option<Torque>| torque.map_or_else(|| "–".into(), |torque| shown(torque.in_unit(&NEWTON_METRE)));
        for (speed, torque, upper) in workbench::curve_rows(curve) {
            table.row([shown(speed.in_unit(&REVOLUTION_PER_MINUTE)), newton_metres(torque), newton_metres(upper)]);
        }
        out.push_str(&table.render());
    }
    Answer { talk, ..Answer::data(out) }
}

/// `antrieb bearing PROJECT`
pub(crate) fn bearing(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let projects = match axes_of(Question::Other, matches, as_json, language) {
        Ok(projects) => projects,
        Err(answer) => return answer,
    };
    let answers = projects.iter().map(|project| bearing_of(project, as_json, language));
    together(answers.collect(), as_json)
}

fn bearing_of(project: &workbench::Project, as_json: bool, language: Language) -> Result<Part<Bearings>, Answer> {
    let sizes = workbench::bearing_of_each_size(project);
    let failing = |candidate: &workbench::Candidate<'_>| {
        workbench::bearing_checks(candidate).any(|check| check.verdict == Verdict::Fail)
    };
    let fits = sizes.iter().any(|(_, candidate)| !failing(candidate));
    if sizes.iter().all(|(_, candidate)| workbench::bearing_checks(candidate).next().is_none()) {
        let what = terms::no_flange_loads(language);
        return Err(simple(what, as_json, language));
    }
    Ok(Part::of(as_json, fits, || answer::bearings(&sizes, language), || bearing_text(&sizes, language)))
}

fn bearing_text(sizes: &[(Size, Candidate<'_>)], language: Language) -> String {
    let mut table = Table::new([
        (terminal::size(language), Align::Left),
        (terms::check(language), Align::Left),
        (terms::verdict(language), Align::Left),
        (terms::value(language), Align::Right),
        (terms::limit(language), Align::Right),
        (terms::unit(language), Align::Left),
        (terms::utilisation_short(language), Align::Right),
    ]);
    let figure = |figure: Option<workbench::Figure>| {
        figure.map_or_else(|| "–".into(), |figure| format_significant(figure.value(), 4, language))
    };
    for (size, candidate) in sizes {
        for check in workbench::bearing_checks(candidate) {
            let unit =
                check.value.map_or("", |figure| if figure.unit.symbol == "1" { "–" } else { figure.unit.symbol });
            table.row([
                size.to_string(),
                check_title(check.id, language),
                verdict_word(check.verdict, language),
                figure(check.value),
                figure(check.limit),
                unit.to_owned(),
                check.utilisation.map_or_else(|| "–".into(), |share| format_significant(share * 100.0, 3, language)),
            ]);
        }
    }
    table.render()
}

/// `antrieb battery`
pub(crate) fn battery(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let hours = matches.get_one::<String>("hours-per-day").map_or("", String::as_str);
    let operation = match workbench::read_hours(hours, language) {
        Ok(time) => time,
        Err(error) => return option_fault("hours-per-day", error, as_json, language),
    };
    let storage = match quantity::<Time>(matches, "storage", as_json, language) {
        Ok(storage) => storage.unwrap_or_else(|| Time::from_si(0.0)),
        Err(answer) => return answer,
    };
    let battery = match workbench::battery(operation, storage, language) {
        Ok(battery) => battery,
        Err(message) => return option_fault("hours-per-day", (message, None), as_json, language),
    };
    if as_json {
        return Answer::record(&answer::battery(&battery));
    }
    let lines = workbench::battery_lines(&battery, language);
    Answer::data(lines.into_iter().flat_map(|line| [line, String::from("\n")]).collect())
}

/// `antrieb new KIND`
pub(crate) fn template(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let kind = matches.get_one::<String>("kind").map_or("", String::as_str);
    let out = matches.get_one::<PathBuf>("out").filter(|path| path.as_os_str() != "-");
    let name =
        out.and_then(|path| path.file_name()).map_or_else(|| USUAL_NAME.to_owned(), |name| path_text(Path::new(name)));
    let Some(template) = workbench::template(kind, &name, language) else { return Answer::none() };
    let Some(out) = out else {
        let mut answer = Answer::data(template.text);
        if let Some((recording, _)) = template.recording {
            answer.talk = format!("{}\n", terminal::recording_not_written(&recording, &kind, language));
        }
        return answer;
    };
    let beside = template.recording.map(|(name, text)| (out.with_file_name(name), text));
    let mut files: Vec<(&Path, &[u8])> = vec![(out, template.text.as_bytes())];
    files.extend(beside.iter().map(|(path, text)| (path.as_path(), text.as_bytes())));
    if let Err(fault) = save(&files, &[], matches.get_flag("force")) {
        return fault.answer(as_json, language);
    }
    let paths: Vec<String> = files.iter().map(|(path, _)| path_text(path)).collect();
    if as_json {
        return Answer::record(&FilesWritten { files: paths });
    }
    Answer::data(format!("{}\n", paths.join("\n")))
}

/// What the header of a project on standard output calls its file.
const USUAL_NAME: &str = "axis.toml";
