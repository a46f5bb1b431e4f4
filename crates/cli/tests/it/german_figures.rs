//! Figures in every answer that is shown in German: decimal comma, and no unit or group of digits that begins a line alone.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::run;

use quantities::Unit;
use questions::list::{ArgumentForm, LIST};
use run::{examples, run};

const CODE: &str = "CHA-25A-50-H-C1024";

/// Questions whose answer is a file or data, without figures for people.
const FILES: [&str; 10] = [
    "report",
    "export",
    "schema",
    "licences",
    "catalogue export",
    "commission --checklist",
    "commission --blank",
    "commission --out",
    "encoder --vcd",
    "upkeep --ical",
];

/// Calls of every other question, each with the tables of the manual that it names by their numbers alone.
fn calls() -> Vec<(&'static str, Vec<String>)> {
    let mut calls: Vec<(&str, Vec<String>)> = Vec::new();
    let mut call = |question: &'static str, arguments: &[&str]| {
        calls.push((question, arguments.iter().map(|each| (*each).to_owned()).collect()));
    };
    for file in &examples() {
        // Their samples are counted elsewhere.
        let few: &[&str] = if file.contains("tolerances") { &["--samples", "20"] } else { &[] };
        call("check", &[&["check", file, "--code", CODE], few].concat());
        call("explain", &["explain", file, "--code", CODE]);
        call("moves", &["moves", file]);
        call("bearing", &["bearing", file]);
    }
    for file in ["examples/tilting-arm.toml", "examples/robot-joint.toml"] {
        call("size", &["size", file, "--top", "3"]);
        call("compare", &["compare", file, "--code", CODE, "--code", "CHA-32A-50-H-C1024"]);
        call("mount --project", &["mount", "CHA-32A-50-H-C1024", "--project", file]);
        call("simulate", &["simulate", file, "--code", CODE, "--scenario", "stall"]);
    }
    for figure in ["torque_speed", "cycle", "utilisation", "torsion", "bearing_load", "candidate_map"] {
        call("plot", &["plot", "examples/tilting-arm.toml", "--code", CODE, "--figure", figure, "--svg", "-"]);
    }
    call("sweep", &["sweep", "examples/tilting-arm.toml", "--vary", "mechanism.arm.mass=5.5,6.5kg"]);
    call("diff", &["diff", "examples/screw-axis.toml", "examples/slider-crank.toml"]);
    call("identify", &["identify", "examples/robot-joint.csv", "examples/tilting-arm.toml", "--code", CODE]);
    call("code parse", &["code", "parse", "CHA-20A-100-H-C1024-B-EC-K-SP"]);
    call("code list", &["code", "list", "CHA-20A-*-H"]);
    call("code complete", &["code", "complete", "CHA-14A-100-N"]);
    for code in ["CHA-20A-100-H-M512P-B-EC-SP", "CHA-14A-50-E-M128S"] {
        call("data", &["data", code]);
        call("wiring", &["wiring", code, "--length", "10.5 m"]);
        call("mount", &["mount", code, "--bore", "K7"]);
        call("upkeep", &["upkeep", code, "--delivered", "2026-03-01", "--hours-per-day", "10.5"]);
        for form in ["sinamics", "cia402", "plain"] {
            call("commission", &["commission", code, "--for", form]);
        }
    }
    call("wiring --check", &["wiring", "CHA-25A-100-H-M512P-B", "--check", "examples/pins.csv"]);
    let record = "examples/commissioning/three-faults.toml";
    call("commission --record", &["commission", "CHA-25A-100-H-M512P-B", "--record", record]);
    call("encoder", &["encoder", "CHA-25A-100-H-M512P", "--angle", "12.5 deg", "--turn", "3"]);
    call("errata", &["errata"]);
    call("catalogue check", &["catalogue", "check", "examples/catalogue/stock.csv"]);
    call("torsion", &["torsion", "CHA-20A-100-H-C1024", "--torque", "60.5 N m"]);
    call("inertia", &["inertia", "disc diameter=200.5mm length=20mm mass=5kg", "point mass=1kg distance=100mm"]);
    call("curve", &["curve", "CHA-20A-100-H-C1024", "--voltage", "220.5 V"]);
    call("battery", &["battery", "--hours-per-day", "10.5"]);
    call("new", &["new", "arm"]);
    call("glossary", &["glossary"]);
    call("units", &["units"]);
    calls
}

/// A default that is stated is the default: no command refuses it, and none answers otherwise. An option that needs another one is
/// refused with that reason.
#[test]
fn a_stated_default_changes_no_answer() {
    let mut seen = std::collections::BTreeSet::new();
    let calls = calls();
    for (question, arguments) in calls.iter().filter(|(question, _)| seen.insert(*question)) {
        let entry = LIST.iter().find(|entry| entry.command == *question).unwrap();
        let is_stated = |name: &str| arguments.iter().any(|word| word.strip_prefix("--") == Some(name));
        let defaults = entry.arguments.iter().filter(|argument| argument.form == ArgumentForm::Option);
        let defaults = defaults.filter(|argument| !is_stated(argument.name));
        let defaults = defaults.filter_map(|argument| Some((argument.name, argument.usual?)));
        let mut defaults: Vec<(&str, &str)> = defaults.collect();
        let plain: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let with = |defaults: &[(&str, &str)]| {
            let stated: Vec<String> =
                defaults.iter().flat_map(|(name, value)| [format!("--{name}"), (*value).to_owned()]).collect();
            run(&plain.iter().copied().chain(stated.iter().map(String::as_str)).collect::<Vec<_>>())
        };
        let refused = with(&defaults);
        let needs_another = |line: &str| {
            let (option, _) = line.strip_prefix("error: --")?.split_once(": the option has no effect without --")?;
            Some(option.to_owned())
        };
        let idle: Vec<String> = refused.err.lines().filter_map(needs_another).collect();
        defaults.retain(|(name, _)| !idle.iter().any(|option| option == name));
        let stated = if idle.is_empty() { refused } else { with(&defaults) };
        let plain = run(&plain);
        assert_eq!((stated.code, stated.out), (plain.code, plain.out), "{question} {defaults:?}: {}", stated.err);
    }
}

/// Number of bytes from which a mark of quotation and the next one do not belong together.
const LONGEST_QUOTATION: usize = 160;

/// Returns a text with its lines as one, without quoted text, values as the project file states them, and lines of a file.
fn flowing(question: &str, text: &str) -> String {
    let is_path =
        |word: &str| word.contains('.') && word.chars().all(|c| c.is_ascii_alphanumeric() || "_.[]".contains(c));
    let is_of_a_file = |line: &str| {
        let (key, is_stated) = line.split_once('=').map_or((line, false), |(key, _)| (key, true));
        let is_key = key.trim().chars().all(|c| c.is_ascii_alphanumeric() || "_.#".contains(c));
        line.trim_start().starts_with(|c: char| c.is_ascii_digit()) && line.contains(" | ")
            || question == "new" && (is_stated && is_key || line.starts_with('['))
            || question == "diff" && line.split_whitespace().next().is_some_and(is_path)
    };
    let lines = text.lines().filter(|line| !is_of_a_file(line)).map(str::trim);
    let mut left = lines.collect::<Vec<_>>().join(" ");
    for (open, close) in [("`", "`"), ("\"", "\""), ("„", "“"), ("‚", "‘")] {
        while let Some(from) = left.find(open) {
            let rest = left.get(from + open.len()..).unwrap_or_default();
            // A mark without its counterpart quotes nothing.
            let length = rest.find(close).filter(|length| *length < LONGEST_QUOTATION).map_or(0, |at| at + close.len());
            left.replace_range(from..from + open.len() + length, "…");
        }
    }
    left
}

/// Words before the number of a table, a section or an equation, and what stands between two of them.
const BEFORE_A_NUMBER: [&str; 15] = [
    "Tabelle",
    "Tabellen",
    "Datentabellen",
    "Gl.",
    "Gleichung",
    "Gleichungen",
    "Abschnitt",
    "Abschn.",
    "Kapitel",
    "Abbildung",
    "Nummer",
    "errata",
    "section",
    "EnDat®",
    "Festigkeitsklasse",
];

/// Returns the words with a decimal point between digits that is none of a number of the manual, an id, a version or a date.
fn points(question: &str, text: &str) -> Vec<String> {
    let text = flowing(question, text);
    let words: Vec<&str> = text.split_whitespace().collect();
    let has_point = |word: &str| {
        let signs: Vec<char> = word.chars().collect();
        signs.windows(3).any(|three| matches!(three, [a, '.', b] if a.is_ascii_digit() && b.is_ascii_digit()))
    };
    let bare = |word: &str| word.trim_matches(|c: char| !c.is_ascii_alphanumeric()).to_owned();
    let is_of_the_manual = |word: &str| {
        let number = bare(word);
        catalogue::tables().iter().any(|table| table.id == number)
            || number.split('.').all(|part| part.len() < 3 && part.chars().all(|c| c.is_ascii_digit()))
                && (2..=3).contains(&number.split('.').count())
    };
    let is_listed = |place: usize| {
        let mut before = words.iter().take(place).rev().skip_while(|word| {
            let is_between = matches!(**word, "und" | "bis" | "oder" | "/");
            is_between || has_point(word) && is_of_the_manual(word)
        });
        before.next().is_some_and(|word| BEFORE_A_NUMBER.contains(&word.trim_start_matches('(')))
    };
    let is_id = |word: &str| {
        let word = bare(word);
        let parts: Vec<&str> = word.split('.').collect();
        let is_date = matches!(parts.as_slice(), [d, m, y] if d.len() == 2 && m.len() == 2 && y.len() == 4);
        is_date
            || word.contains("-") && word.starts_with(|c: char| c.is_ascii_alphabetic())
            || word.contains(".toml")
            || word.contains(".csv")
    };
    // These name tables by their numbers alone.
    let names_tables = matches!(question, "errata" | "data" | "wiring" | "upkeep" | "wiring --check" | "mount");
    let is_table = |word: &str| names_tables && catalogue::tables().iter().any(|table| bare(word) == table.id);
    // Errata name sections and equations by their numbers too; a figure has a unit.
    let has_unit = |place: usize| words.get(place + 1).is_some_and(|next| Unit::of(&bare(next)).is_some());
    let is_place = |place: usize, word: &str| question == "errata" && is_of_the_manual(word) && !has_unit(place);
    // Versions of EnDat.
    let is_version = |word: &str| question == "encoder" && matches!(word, "(2.1)," | "(2.2)");
    let found = words.iter().enumerate().filter(|(place, word)| {
        let is_class = words.get(place + 1) == Some(&"Festigkeitsklasse");
        let is_cited = is_of_the_manual(word) && (is_listed(*place) || is_class);
        has_point(word) && !is_cited && !is_id(word) && !is_table(word) && !is_version(word) && !is_place(*place, word)
    });
    found.map(|(place, word)| format!("{} {word}", words.get(place.saturating_sub(1)).unwrap_or(&""))).collect()
}

/// Returns the ends of lines with a number whose unit or next group of digits begins the next line of the same paragraph.
fn torn(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let pairs = lines.windows(2).filter_map(|pair| {
        let [above, below] = pair else { return None };
        let number = above.split_whitespace().next_back()?.rsplit(['(', '|', '−', '√']).next()?;
        let head = below.split_whitespace().next()?.split(['(', ')', ',', ';', '|']).next()?;
        let is_number = number.starts_with(|c: char| c.is_ascii_digit())
            && number.ends_with(|c: char| c.is_ascii_digit())
            && number.chars().all(|c| c.is_ascii_digit() || c == ',');
        let unit = head.trim_end_matches(['/', '.']);
        let is_unit = unit == "%" || !unit.starts_with(|c: char| c.is_ascii_digit()) && Unit::of(unit).is_some();
        // In a table the cells of a line stand beside each other.
        let is_paragraph = below.starts_with(' ') && !above.trim().contains("   ") && !below.trim().contains("   ");
        (is_paragraph && is_number && is_unit).then(|| format!("{number} / {head}"))
    });
    pairs.collect()
}

#[test]
fn every_question_is_called_or_answers_with_a_file() {
    let calls = calls();
    let called = |command: &str| calls.iter().any(|(question, _)| *question == command);
    let missing: Vec<&str> =
        LIST.iter().map(|entry| entry.command).filter(|command| called(command) == FILES.contains(command)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// Returns the texts of a picture, each in a line of its own.
fn labels(svg: &str) -> String {
    let texts = svg.split('<').filter_map(|part| part.split_once('>')).map(|(_, text)| text);
    texts.filter(|text| !text.trim().is_empty()).collect::<Vec<_>>().join("\n")
}

/// Checks the answers of the questions that are selected.
fn check(is_selected: impl Fn(&str) -> bool) {
    let mut wrong: Vec<String> = Vec::new();
    let mut figures = 0;
    for (question, arguments) in calls().into_iter().filter(|(question, _)| is_selected(question)) {
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).chain(["--lang", "de"]).collect();
        let found = run(&arguments);
        let text = format!("{}\n{}", if question == "plot" { labels(&found.out) } else { found.out }, found.err);
        figures += text.matches(',').count();
        wrong.extend(points(question, &text).into_iter().map(|word| format!("{}: {word}", arguments.join(" "))));
        wrong.extend(torn(&text).into_iter().map(|word| format!("{}: {word} torn", arguments.join(" "))));
    }
    assert!(figures > 500, "{figures}");
    assert!(wrong.is_empty(), "{} wrong: {:#?}", wrong.len(), wrong.iter().take(60).collect::<Vec<_>>());
}

#[test]
fn figures_in_german_derivations_have_a_comma_and_keep_their_units() {
    check(|question| question == "explain");
}

#[test]
fn figures_in_german_answers_have_a_comma_and_keep_their_units() {
    check(|question| question != "explain");
}
