//! `wiring`: connectors, pins and cables, and a list of pins compared with them.

use crate::answer::Answer;
use crate::code::{parse_for_use, read_argument};
use crate::facts::facts_text;
use crate::fault::{option_fault, path_text, read_bytes_within, report, simple, unreadable};
use crate::plot;
use crate::subject::refuse;
use crate::table::{Align, Table, hanging, labelled, paragraph};
use clap::ArgMatches;
use std::fmt::Write as _;
use std::path::PathBuf;
use workbench::answers::{Connector, ConnectorExit, NoteBy, Number, VoltageDrops, WiringCheck};
use workbench::quantities::{Area, Length, format_number, format_significant};
use workbench::text::{capitalised, evidence_text, file_trouble, terminal, terms, verdict_word, wiring};
use workbench::{LISTED_BYTES_MAX, Language, Role, answer};

/// `antrieb wiring CODE`
pub(crate) fn wiring(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let (reading, talk) = match parse_for_use(&read_argument(matches), as_json, language) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    let Some(found) = workbench::wiring(&reading.parsed.code) else {
        return refuse(&workbench::Refusal::NoData, as_json, language);
    };
    let cable = match cable(matches, as_json, language) {
        Ok(cable) => cable,
        Err(answer) => return answer,
    };
    let answer = match matches.get_one::<PathBuf>("check") {
        Some(_) if plot::is_asked(matches) => return simple(wiring::check_or_draw(language), as_json, language),
        Some(path) => check(&found, path, as_json, language),
        None if plot::is_asked(matches) => draw(&found, matches, as_json, language),
        None => {
            let record = answer::wiring(&found, cable, language);
            if as_json { Answer::record(&record) } else { Answer::data(wiring_text(&record, language)) }
        }
    };
    Answer { talk: talk + &answer.talk, ..answer }
}

/// Length and cross-section of a cable, where they are given.
fn cable(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Option<(Length, Option<Area>)>, Answer> {
    let text = |option: &str| matches.get_one::<String>(option).map(String::as_str);
    let fault = |option: &'static str| move |fault| option_fault(option, fault, as_json, language);
    let Some(length) = text("length") else { return Ok(None) };
    let length = workbench::cable_length(length, language).map_err(fault("length"))?;
    let section = text("cross-section").map(|text| workbench::cross_section(text, language)).transpose();
    Ok(Some((length, section.map_err(fault("cross-section"))?)))
}

fn draw(wiring: &workbench::Wiring, matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let wanted = matches.get_one::<String>("connector").map_or(Role::Feedback.id(), String::as_str);
    let Some(connector) = wiring.connectors.iter().find(|connector| connector.role.id() == wanted) else {
        let roles: Vec<&str> = wiring.connectors.iter().map(|connector| connector.role.id()).collect();
        let what = wiring::no_such_connector(&wiring.code, &roles.join(", "), language);
        return option_fault("connector", (what, None), as_json, language);
    };
    if connector.pins.is_empty() {
        return simple(wiring::no_pins_to_draw(language), as_json, language);
    }
    if let Err(answer) = plot::destination(matches, &[], as_json, language) {
        return answer;
    }
    plot::put(&figures::mating_face(&wiring.code, connector, language), matches, &[], as_json, language)
}

fn check(wiring: &workbench::Wiring, path: &std::path::Path, as_json: bool, language: Language) -> Answer {
    let name = if path.as_os_str() == "-" { "stdin".to_owned() } else { path_text(path) };
    let bytes = match read_bytes_within(path, LISTED_BYTES_MAX) {
        Ok(bytes) if bytes.len() > LISTED_BYTES_MAX => {
            let what = wiring::pin_list_too_large(&LISTED_BYTES_MAX, language);
            return unreadable(&name, &what, as_json, language);
        }
        Ok(bytes) => bytes,
        Err(error) => return unreadable(&name, &file_trouble(&error, language), as_json, language),
    };
    let read = match workbench::read_list(wiring, &bytes) {
        Ok(read) => read,
        Err(error) => return unreadable(&name, &file_trouble(&error, language), as_json, language),
    };
    let Ok(comparison) = &read.outcome else {
        return report(&name, &read.text, &read.told(language), as_json, language);
    };
    let record = answer::wiring_check(wiring, comparison, language);
    let agrees = record.agrees;
    let answer = if as_json { Answer::record(&record) } else { Answer::data(check_text(&record, &name, language)) };
    answer.fits(agrees)
}

fn check_text(record: &WiringCheck, name: &str, language: Language) -> String {
    let mut out = format!("{}, {name}\n", record.code);
    let counted = if record.agreeing == record.rows {
        wiring::agrees(&record.rows, language)
    } else {
        wiring::differs(&record.agreeing, &record.rows, language)
    };
    let _ = writeln!(out, "{counted}");
    if record.findings.is_empty() {
        return out;
    }
    out.push('\n');
    let mut table = Table::new([
        (wiring::line(language), Align::Right),
        (wiring::severity(language), Align::Left),
        (wiring::connector(language), Align::Left),
        (wiring::pin(language), Align::Left),
        (wiring::finding(language), Align::Left),
    ]);
    for finding in &record.findings {
        table.row([
            finding.line.map_or_else(|| "–".into(), |line| line.to_string()),
            wiring::severity_word(*finding.severity, language).to_owned(),
            finding.connector.id().to_owned(),
            finding.pin.clone().unwrap_or_else(|| "–".into()),
            format!("{}; {}", finding.message, finding.action),
        ]);
    }
    out.push_str(&table.render());
    out
}

fn heading(out: &mut String, text: &str) {
    let _ = write!(out, "\n{}", hanging("", &capitalised(text)));
}

fn wiring_text(record: &workbench::answers::Wiring, language: Language) -> String {
    let mut out = format!("{}\n", record.code);
    for connector in &record.connectors {
        connector_text(&mut out, connector, language);
    }
    heading(&mut out, wiring::cables(language));
    if record.cables.is_empty() {
        let _ = writeln!(out, "{}", wiring::no_cables(language));
    } else {
        let mut table = Table::new([
            (wiring::material_number(language), Align::Left),
            (wiring::length(language), Align::Right),
            (wiring::connects(language), Align::Left),
            (wiring::goes_to(language), Align::Left),
            (terminal::table(language), Align::Left),
        ]);
        for cable in &record.cables {
            let length = cable.length_m.map(|length| format!("{} m", format_number(length.0, 0, language)));
            table.row([
                cable.material_number.to_owned(),
                length.or(cable.length_code.map(str::to_owned)).unwrap_or_else(|| "–".into()),
                wiring::cable_role(*cable.role, language).to_owned(),
                cable.goal.clone(),
                cable.table.to_owned(),
            ]);
        }
        out.push_str(&table.render());
    }
    if let Some(drops) = &record.voltage_drop {
        drops_text(&mut out, drops, language);
    }
    heading(&mut out, wiring::not_available(language));
    for absent in &record.not_available {
        let text = format!("{} ({} {})", absent.text, terminal::table(language), absent.table);
        out.push_str(&hanging("  ", &text));
    }
    heading(&mut out, terms::remarks(language));
    for note in &record.notes {
        let by = if note.by == NoteBy::Antrieb { "antrieb: " } else { "" };
        let table = note.table.map(|table| format!(" ({} {table})", terminal::table(language)));
        out.push_str(&hanging("  ", &format!("{by}{}{}", note.text, table.unwrap_or_default())));
    }
    heading(&mut out, wiring::rules(language));
    out.push_str(&facts_text(&record.rules, language));
    if !record.errata.is_empty() {
        out.push('\n');
    }
    for id in &record.errata {
        out.push_str(&paragraph(&format!("* {id}: "), evidence_text(id, language)));
    }
    out
}

fn connector_text(out: &mut String, connector: &Connector, language: Language) {
    let exit = connector.exit.map(|exit| match exit {
        ConnectorExit::Cable => wiring::at_the_end_of_a_cable(language),
        ConnectorExit::Housing => wiring::in_the_housing(language),
    });
    let exit = exit.map(|exit| format!(", {exit}")).unwrap_or_default();
    let [kind, pins] = connector.tables;
    let table = terminal::table(language);
    let name = wiring::role_name(*connector.role, language);
    heading(out, &format!("{name}: {}{exit} ({table} {kind}, {table} {pins})", connector.kind));
    let mut mating = connector
        .material_number
        .map(|number| wiring::mating_coupling(&number, language))
        .into_iter()
        .collect::<Vec<_>>();
    mating.extend(connector.outer_diameter.map(|value| wiring::outer_diameter(&value, language)));
    mating.extend(connector.length.map(|value| wiring::length_of_coupling(&value, language)));
    if !mating.is_empty() {
        out.push_str(&paragraph("", &mating.join(", ")));
    }
    if connector.pins.is_empty() {
        return;
    }
    let coloured = connector.pins.iter().any(|pin| pin.colour.is_some());
    let mut columns =
        vec![(wiring::pin(language).to_owned(), Align::Left), (wiring::signal(language).to_owned(), Align::Left)];
    if coloured {
        columns.push((wiring::colour(language).to_owned(), Align::Left));
    }
    columns.push((terminal::meaning(language).to_owned(), Align::Left));
    let mut rows = Table::of(columns);
    for pin in &connector.pins {
        let name = pin.joined_with.as_ref().map_or_else(|| pin.pin.clone(), |other| format!("{} ({other})", pin.pin));
        let mut row = vec![name, pin.signal.to_owned()];
        if coloured {
            row.push(pin.colour.unwrap_or("–").to_owned());
        }
        row.push(pin.meaning.clone());
        rows.push(row);
    }
    out.push_str(&rows.render());
    for colour in &connector.ambiguous {
        let text = wiring::same_colour(&colour.colour, &colour.pins.join(", "), language);
        out.push_str(&labelled(terminal::note(language), &text));
    }
}

fn number(value: Number, language: Language) -> String {
    format_significant(value.0, 3, language)
}

fn drops_text(out: &mut String, drops: &VoltageDrops, language: Language) {
    heading(out, &wiring::voltage_drop(&number(drops.length_m, language), language));
    let mut table = Table::new([
        (wiring::circuit(language), Align::Left),
        ("A", Align::Right),
        (wiring::nominal_v(language), Align::Right),
        (wiring::least_v(language), Align::Right),
        (wiring::at_20_degc(language), Align::Right),
        (wiring::at_70_degc(language), Align::Right),
        (wiring::least_mm2(language), Align::Right),
        (terms::verdict(language), Align::Left),
    ]);
    let shown = |value: Option<Number>| value.map_or_else(|| "–".into(), |value| number(value, language));
    for circuit in &drops.circuits {
        let mut verdict = verdict_word(*circuit.verdict, language);
        if !circuit.reason.is_empty() {
            let _ = write!(verdict, ": {}", circuit.reason);
        }
        if circuit.sense_lines {
            let _ = write!(verdict, "; {}", wiring::sense_makes_up(language));
        }
        table.row([
            circuit.name.to_owned(),
            number(circuit.current_a, language),
            shown(circuit.nominal_v),
            shown(circuit.least_v),
            shown(circuit.loss_20_degc_v),
            shown(circuit.loss_70_degc_v),
            shown(circuit.cross_section_min_mm2),
            verdict,
        ]);
    }
    out.push_str(&table.render());
    out.push_str(&labelled(terms::assumptions(language), drops.assumptions));
    out.push_str(&labelled(terms::source(language), &drops.resistivity_source));
}
