//! `code parse|list|complete`.

use crate::answer::{Answer, written};
use crate::fault::report;
use crate::table::{Align, Table, paragraph};
use clap::ArgMatches;
use std::fmt::Write as _;
use workbench::answer::{code_faults, code_reading, code_told, completion, listed};
use workbench::text::{describe_field, describe_uncovered, terminal, terms};
use workbench::{CodeReading, CodeRefusal, Language, uncovered};

pub(crate) fn dispatch(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    match matches.subcommand() {
        Some(("parse", found)) => parse(&read_argument(found), as_json, language),
        Some(("list", found)) => list(found, as_json, language),
        Some(("complete", found)) => complete(&read_argument(found), as_json, language),
        _ => Answer::none(),
    }
}

/// The words of a code argument joined: `code parse cha 20a 100 h c1024` needs no quotes.
pub(crate) fn read_argument(matches: &ArgMatches) -> String {
    matches.get_many::<String>("code").into_iter().flatten().cloned().collect::<Vec<_>>().join(" ")
}

/// Reads a code that a command is about, with a remark if it was not written canonically.
pub(crate) fn parse_for_use(text: &str, as_json: bool, language: Language) -> Result<(CodeReading, String), Answer> {
    match workbench::read_code(text, language) {
        Ok(reading) => {
            let note = understood(&reading, language);
            Ok((reading, note))
        }
        Err(refusal) => Err(refused(text, &refusal, as_json, language)),
    }
}

fn understood(reading: &CodeReading, language: Language) -> String {
    if reading.parsed.is_canonical() {
        return String::new();
    }
    format!("{}\n", terminal::understood_as(&reading.parsed.code, language))
}

/// Why a text is no code, with the nearest that are.
pub(crate) fn refused(text: &str, refusal: &CodeRefusal, as_json: bool, language: Language) -> Answer {
    let faults = code_told(text, refusal);
    let name = terminal::code(language);
    let mut answer = report(name, text, &faults, false, language);
    if !refusal.nearest.is_empty() {
        let asked = terms::on_request(language);
        let names: Vec<String> = refusal
            .nearest
            .iter()
            .map(|(code, found)| if found.is_available() { code.to_string() } else { format!("{code} ({asked})") })
            .collect();
        let word = terminal::nearest_valid_codes(language);
        let _ = writeln!(answer.talk, "{word}: {}", names.join(", "));
    }
    if as_json {
        answer.data = written(&code_faults(text, refusal, language));
    }
    answer
}

fn parse(text: &str, as_json: bool, language: Language) -> Answer {
    let (reading, talk) = match parse_for_use(text, as_json, language) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    if as_json {
        return Answer { talk, ..Answer::record(&code_reading(&reading, language)) };
    }
    let mut data = format!("{}\n", reading.parsed.code);
    let state = if reading.availability.is_available() {
        terminal::available(language).to_owned()
    } else {
        let fields: Vec<&str> =
            reading.availability.on_request.iter().map(|field| describe_field(*field, language)).collect();
        format!("{}: {}", terms::on_request(language), fields.join(", "))
    };
    let _ = writeln!(data, "{state}\n");
    let (field, token, meaning) = (terminal::field(language), terminal::token(language), terminal::meaning(language));
    let mut table = Table::new([(field, Align::Left), (token, Align::Left), (meaning, Align::Left)]);
    for (each, token, meaning) in workbench::explain_code(&reading.parsed.code, language) {
        let token = if token.is_empty() { "–".to_owned() } else { token };
        table.row([describe_field(each, language).to_owned(), token, meaning]);
    }
    data.push_str(&table.render());
    for (index, what) in uncovered(&reading.parsed.code).into_iter().enumerate() {
        if index == 0 {
            data.push('\n');
        }
        data.push_str(&paragraph("", describe_uncovered(what, language)));
    }
    Answer { talk, ..Answer::data(data) }
}

fn list(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let text = matches.get_one::<String>("pattern");
    let pattern = match text.map(|text| workbench::read_pattern(text, language)).transpose() {
        Ok(pattern) => pattern,
        Err(refusal) => return refused(text.map_or("", String::as_str), &refusal, as_json, language),
    };
    let only_available = matches.get_flag("available");
    let codes: Vec<_> = workbench::list_codes(pattern.as_ref())
        .into_iter()
        .filter(|(_, found)| !only_available || found.is_available())
        .collect();
    if as_json {
        return Answer::record(&listed(&codes, language)).fits(!codes.is_empty());
    }
    let mut data = String::new();
    for (code, found) in &codes {
        let state = if found.is_available() { String::new() } else { format!("	{}", terms::on_request(language)) };
        let _ = writeln!(data, "{code}{state}");
    }
    let available = codes.iter().filter(|(_, found)| found.is_available()).count();
    let talk = terminal::codes_counted(&codes.len(), &available, &(codes.len() - available), language)
        + "
";
    Answer { talk, ..Answer::data(data) }.fits(!codes.is_empty())
}

fn complete(text: &str, as_json: bool, language: Language) -> Answer {
    let pattern = match workbench::read_pattern(text, language) {
        Ok(pattern) => pattern,
        Err(refusal) => return refused(text, &refusal, as_json, language),
    };
    let codes = workbench::list_codes(Some(&pattern));
    if as_json {
        return Answer::record(&completion(&pattern, &codes, language));
    }
    let choices = workbench::completion(&pattern, language);
    let (field, may) = (terminal::field(language), terminal::may_be(language));
    let (none, request) = (terminal::nothing(language), terms::on_request(language));
    let mut table = Table::new([(field, Align::Left), (may, Align::Left)]);
    for (_, name, found) in &choices {
        let tokens: Vec<String> = found
            .iter()
            .map(|choice| {
                let token = if choice.token.is_empty() { none } else { choice.token };
                if choice.available { token.to_owned() } else { format!("{token} ○") }
            })
            .collect();
        table.row([(*name).to_owned(), tokens.join(", ")]);
    }
    let mut data = table.render();
    data.push('\n');
    for (code, found) in &codes {
        let state = if found.is_available() { String::new() } else { format!("\t{request}") };
        let _ = writeln!(data, "{code}{state}");
    }
    let talk = terminal::codes(codes.len(), language)
        + "
";
    Answer { talk, ..Answer::data(data) }.fits(!codes.is_empty())
}
