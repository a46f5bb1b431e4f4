//! Every state of the page in both languages shows words: no key of the project file, no identifier of the program.
//!
//! Exceptions: program text and the text of the file (`code`, `textarea`), names of files, and the citation keys of the errata, by which
//! the report and `antrieb errata` name them too.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::faults::cases;
use crate::shell;

use page::theory_files;
use quantities::Language;
use questions::CheckId;
use questions::list::errata::errata_about;
use questions::list::new::{example, template, template_kinds};
use shell::{InMemory, form};
use std::collections::{BTreeMap, BTreeSet};
use testkit::visible::{VisibleText, visible_texts};

const VIEWS: [&str; 6] = ["torque_speed", "heat", "energy", "bearing", "error_budget", "simulation"];

const TOOLS: [&str; 15] = [
    "code",
    "data",
    "curve",
    "torsion",
    "bearing",
    "inertia",
    "battery",
    "encoder",
    "wiring",
    "mount",
    "commission",
    "record",
    "upkeep",
    "errata",
    "glossary",
];

/// A state of the page: path, query, fields of its form.
type Request = (&'static str, String, Vec<(&'static str, String)>);

/// Returns the states of a project. All checks and lists are visited for one kind of mechanism, the other kinds where they differ: form,
/// cycle, loads on the flange, derivation of the torque, proposals.
fn of_project(text: &str, language: Language, is_first: bool) -> Vec<Request> {
    let of = |path: &'static str, more: &[(&'static str, &str)]| {
        let mut fields = vec![("text", text.to_owned()), ("lang", language.id().to_owned())];
        fields.extend(more.iter().map(|(name, value)| (*name, (*value).to_owned())));
        (path, String::new(), fields)
    };
    let explained = |check: &CheckId| of("/explain", &[("check", check.id()), ("code", "CHA-25A-100-H-C1024")]);
    let mut found = vec![
        of("/work", &[("unfolded", "true")]),
        of("/work", &[("view", "bearing"), ("list", "rejected")]),
        of("/explain", &[("check", "torque_speed_trace"), ("code", "CHA-25A-100-H-C1024")]),
        of("/explain", &[("check", "bearing_tilting_moment"), ("code", "CHA-25A-100-H-C1024")]),
        of("/would-fit", &[]),
    ];
    if is_first {
        found.extend(VIEWS.map(|view| of("/work", &[("view", view)])));
        found.extend(CheckId::ALL.iter().map(explained));
        found.push(of("/work", &[("list", "map")]));
        found.push(of("/compare", &[("mark", "CHA-25A-100-H-C1024"), ("mark", "CHA-20A-50-H-M128S-B")]));
        found.push(of("/tolerances", &[("samples", "8")]));
        found.push(of("/versions", &[]));
        found.push(of("/paper", &[]));
    }
    found
}

/// Returns the states without a project.
fn others(language: Language) -> Vec<Request> {
    let l = language.id();
    let get = |path: &'static str, query: &str| (path, format!("lang={l}{query}"), Vec::new());
    let tool = |name: &str, about: &str| {
        let fields = [("tool", name), ("asked", name), ("about", about), ("lang", l)];
        ("/tools", String::new(), fields.map(|(field, value)| (field, value.to_owned())).to_vec())
    };
    let mut found: Vec<Request> = ["/", "/gallery", "/keys", "/files"].map(|path| get(path, "")).to_vec();
    found.extend((0..11).map(|place| get("/begin", &format!("&kind={place}"))));
    // Each letter, and the words of which the keys consist.
    let words = ('a'..='z')
        .map(String::from)
        .chain(["kenn", "curve", "reib", "torque", "mass", "twin", "stage", "t_"].map(String::from));
    found.extend(words.map(|word| get("/find", &format!("&q={word}"))));
    for name in TOOLS {
        found.extend(
            ["CHA-25A-100-H-M512P-B", "CHA-14A-50-N-D2048", "CHA-25A-100-H-X9", ""].map(|about| tool(name, about)),
        );
    }
    found
}

fn is_part(sign: char) -> bool {
    sign.is_alphanumeric() || matches!(sign, '_' | '.' | '-' | '/' | ':' | '[' | ']')
}

/// Words of developers: the opening of an example, an option of the command line, a quotation mark of Markdown.
const DEVELOPERS: [&str; 9] = ["e.g.", "z. B. ", "z.B.", "zd-shf", "`", " --", "::", "NaN", "degC"];

/// Returns the choices of a German page that show their value in the file instead of words.
fn choices_without_words(html: &str) -> Vec<String> {
    let options = html.split("<option value=\"").skip(1).filter_map(|rest| {
        let (value, rest) = rest.split_once('"')?;
        let shown = rest.split_once('>')?.1.split('<').next()?;
        Some((value, shown))
    });
    let is_word = |value: &str| {
        value.len() > 2
            && value != "normal"
            && quantities::Unit::of(value).is_none()
            && value.chars().all(|sign| sign.is_ascii_lowercase() || sign == '_')
    };
    // A wrong word of the file stays in its field.
    let is_wrong = |value: &str| html.contains(&format!("<option value=\"{value}\" selected>"));
    options
        .filter(|(value, shown)| value == shown && is_word(value) && !is_wrong(value))
        .map(|(value, _)| value.to_owned())
        .collect()
}

/// Keys of the project file that are no German words, nor headings of a recording.
const ENGLISH_KEYS: [&str; 9] =
    ["standstill", "gaps", "speed", "distance", "acceleration", "jerk", "smoothing", "columns", "from"];

/// Returns lines and tables of the project file in a text, and in a German one its keys.
fn file_syntax(own: &str, is_german: bool) -> Vec<String> {
    let mut found = Vec::new();
    for (at, _) in own.match_indices(" = ") {
        let behind = own.get(at + 3..).unwrap_or_default();
        let is_value = ["\"", "{", "true", "false"].iter().any(|begin| behind.starts_with(begin));
        if is_value {
            found.push(own.get(at.saturating_sub(12)..).unwrap_or(own).chars().take(24).collect());
        }
    }
    if is_german {
        let words: Vec<&str> = own.split(|sign: char| !is_part(sign)).collect();
        // A line of a body is typed as it is quoted: `distance=80mm`, with the keys that are listed.
        let is_of_body = |key: &str| own.contains(&format!("{key}=")) || own.contains("mass, density, distance");
        let is_key = |key: &&&str| words.contains(*key) && !is_of_body(key);
        found.extend(ENGLISH_KEYS.iter().filter(is_key).map(|key| (*key).to_owned()));
    }
    found
}

/// Returns the identifiers in a text.
fn identifiers(text: &VisibleText, known: &BTreeSet<String>, is_german: bool) -> Vec<String> {
    let mut found: Vec<String> = file_syntax(&text.words, is_german);
    for word in text.words.split(|sign: char| !is_part(sign)) {
        let word = word.trim_matches(|sign: char| !sign.is_alphanumeric());
        let letters: Vec<char> = word.chars().collect();
        let is_joined = letters.windows(3).any(|at| at[1] == '_' && at[0].is_alphanumeric() && at[2].is_alphanumeric());
        let is_path =
            letters.windows(4).any(|at| at[1] == '.' && [0, 2, 3].iter().all(|place| at[*place].is_ascii_lowercase()));
        let is_file = [".toml", ".csv", ".parquet", ".pdf"].iter().any(|ending| word.ends_with(ending));
        if (is_joined || is_path) && !is_file && !known.contains(word) {
            found.push(word.to_owned());
        }
    }
    // What the user typed is quoted as it was typed.
    let own: String = text.words.split(['"', '„', '“', '”']).step_by(2).collect();
    let quotes = DEVELOPERS.iter().filter(|sign| own.contains(**sign));
    found.extend(quotes.map(|sign| (*sign).to_owned()));
    found
}

/// Returns the identifiers on pages with a place of each; `html` reads the page of a request.
fn found_in(requests: &[Request], files: &[(&str, &[u8])]) -> BTreeMap<(String, String), String> {
    let errata: BTreeSet<String> = errata_about(None, Language::En)
        .map_or_else(|_| Vec::new(), |found| found.errata)
        .iter()
        .map(|erratum| erratum.id.to_owned())
        .collect();
    let mut found = BTreeMap::new();
    for (path, query, fields) in requests {
        let folder = InMemory::default();
        folder.0.borrow_mut().extend(files.iter().map(|(name, content)| ((*name).to_owned(), content.to_vec())));
        let fields: Vec<(&str, &str)> = fields.iter().map(|(name, value)| (*name, value.as_str())).collect();
        let reply = if fields.is_empty() { folder.get(path, query) } else { folder.post(path, &fields) };
        let html = String::from_utf8_lossy(&reply.body).into_owned();
        assert_eq!(reply.status, 200, "{path} {query}: {html}");
        let is_german =
            fields.iter().any(|(name, value)| *name == "lang" && *value == "de") || query.contains("lang=de");
        for value in if is_german { choices_without_words(&html) } else { Vec::new() } {
            let _ = found.entry((value, "option".to_owned())).or_insert_with(|| format!("{path} {query}"));
        }
        // The glossary has both languages side by side.
        let is_one_language = !fields.iter().any(|(name, value)| *name == "tool" && *value == "glossary");
        for text in visible_texts(&html, &["file"]) {
            for word in identifiers(&text, &errata, is_german && is_one_language) {
                let cut: String = text.words.chars().take(160).collect();
                let state: String =
                    form(&fields.iter().copied().filter(|(name, _)| *name != "text").collect::<Vec<_>>());
                let _ = found.entry((word, text.place.clone())).or_insert(format!("{path} {query} {state}: {cut}"));
            }
        }
    }
    found
}

fn expect_none(requests: &[Request]) {
    expect_none_with(requests, &[]);
}

/// Requires words on the pages of requests in a folder with files.
fn expect_none_with(requests: &[Request], files: &[(&str, &[u8])]) {
    let found = found_in(requests, files);
    let lines: Vec<String> = found.iter().map(|((word, place), at)| format!("@{word} | {place} | {at}")).collect();
    assert!(lines.is_empty(), "{} identifiers\n{}", lines.len(), lines.join("\n"));
}

fn projects(language: Language, is_first: bool) -> Vec<Request> {
    let kinds = template_kinds().enumerate();
    let texts = kinds.filter_map(|(place, kind)| {
        let found = example(kind, "axis.toml", language).filter(|found| found.recording.is_none())?;
        Some((place, found.text))
    });
    texts
        .filter(|(place, _)| (*place == 0) == is_first)
        .flat_map(|(_, text)| of_project(&text, language, is_first))
        .collect()
}

/// Returns the plain project of each kind, which assumes the most.
fn plain(language: Language) -> Vec<Request> {
    let texts = template_kinds().filter_map(|kind| template(kind, "axis.toml", language));
    let texts = texts.filter(|found| found.recording.is_none()).map(|found| found.text);
    texts.map(|text| ("/work", String::new(), vec![("text", text), ("lang", language.id().to_owned())])).collect()
}

#[test]
fn plain_projects_show_words() {
    for language in Language::ALL {
        expect_none(&plain(language));
    }
}

#[test]
fn a_project_shows_words_in_english() {
    expect_none(&projects(Language::En, true));
}

#[test]
fn a_project_shows_words_in_german() {
    expect_none(&projects(Language::De, true));
}

#[test]
fn every_mechanism_shows_words_in_english() {
    expect_none(&projects(Language::En, false));
}

#[test]
fn every_mechanism_shows_words_in_german() {
    expect_none(&projects(Language::De, false));
}

#[test]
fn start_palette_and_tools_show_words() {
    for language in Language::ALL {
        expect_none(&others(language));
    }
}

#[test]
fn faults_show_words() {
    for language in Language::ALL {
        let of = |(_, text, _): &(&str, String, _)| -> Request {
            ("/work", String::new(), vec![("text", text.clone()), ("lang", language.id().to_owned())])
        };
        expect_none(&cases().iter().map(of).collect::<Vec<_>>());
    }
}

/// Contents of recordings that cannot be read, or only with a remark, one for each advice.
fn recordings() -> Vec<String> {
    let rows = |heading: &str, times: &[f64]| {
        let rows: String =
            times.iter().enumerate().map(|(at, time)| format!("{time},{}\n", (at as f64 * 0.1).sin())).collect();
        format!("{heading}\n{rows}")
    };
    let even: Vec<f64> = (0..400).map(|at| f64::from(at) * 0.002).collect();
    let scattered: Vec<f64> = (0..400).map(|at| f64::from(at) * 0.002 + f64::from(at * 7 % 5) * 1e-4).collect();
    let mut gap = even.clone();
    gap.iter_mut().skip(200).for_each(|time| *time += 1.0);
    let steps = |step: f64| {
        let row = |at: u32| {
            format!("{:.4},{:.4}\n", f64::from(at) * 0.001, step * (40.0 * (f64::from(at) * 0.01).sin() / step).round())
        };
        (0..800).map(row).fold(String::from("t [s],q [deg]\n"), |all, row| all + &row)
    };
    let held = (0..800)
        .map(|at: u32| format!("{:.4},{:.5}\n", f64::from(at) * 0.001, 40.0 * (f64::from(at / 10) * 0.1).sin()));
    vec![
        rows("t [s],q [deg]", &even),
        rows("t [s],q [deg]", &scattered),
        rows("t [s],q [deg]", &gap),
        rows("t [s],q [deg]", &[4.0, 3.0, 2.0, 1.0]),
        rows("t [s],q [deg]", &[1.0, 2.0, 3.0, 1.0, 2.0, 3.0]),
        rows("t [s],q [deg]", &[0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0]),
        rows("t,q", &even),
        rows("a [s],b [deg]", &even),
        rows("t [s],x", &even),
        rows("t [s],q [furlong]", &even),
        rows("0,1", &even),
        rows("s,deg", &even),
        steps(0.5),
        held.fold(String::from("t [s],q [deg]\n"), |all, row| all + &row),
        format!("{}[Statistics]\nMax;2\n", rows("t [s],q [deg]", &even)),
        String::from("t [s],q [deg],p [deg]\n0,1,1\n1,2,2\n2,3,3\n"),
        String::from("t [s],q [deg],n [1/min]\n0,0,0\n1,1,900\n2,0,5\n3,8,2\n"),
        String::from("t [s],q [deg]\n0,350\n0.1,355\n0.2,0\n0.3,5\n"),
        String::from("t [s],t [s],q [deg]\n0,0,1\n1,1.5,2\n2,3,3\n"),
    ]
}

/// Texts about a recording show words: in the list of faults, at the fields, among the assumptions, and in the preview of a file.
#[test]
fn recordings_show_words() {
    let keys = [
        "",
        "standstill = \"5 1/min\"\n",
        "time_stamps = \"even\"\n",
        "held_values = \"interpolate\"\n",
        "gaps = \"allow\"\n",
        "from = \"0.1 s\"\nto = \"0.05 s\"\n",
    ];
    for content in recordings() {
        let mut requests = Vec::new();
        for language in Language::ALL {
            for (key, single) in keys.iter().map(|key| (key, true)).chain([(&"", false)]) {
                let text = format!(
                    "format = 1\n[axis]\nsingle_move = {single}\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"recorded\"\nfile = \"run.csv\"\n{key}"
                );
                requests.push(("/work", String::new(), vec![("text", text), ("lang", language.id().to_owned())]));
            }
        }
        expect_none_with(&requests, &[("run.csv", content.as_bytes())]);
    }
}

#[test]
fn chapters_of_the_theory_show_words() {
    let chapters: Vec<String> =
        theory_files().filter(|file| file.ends_with(".html")).map(|file| format!("/{file}")).collect();
    let chapters = chapters
        .iter()
        .map(|path| -> Request { (Box::leak(path.clone().into_boxed_str()), String::new(), Vec::new()) });
    expect_none(&chapters.collect::<Vec<_>>());
}

/// Requires one main action in each state of the gallery: the way on from it. A drawer has its own, the others stand behind it.
#[test]
fn each_state_has_at_most_one_main_action() {
    for state in &page::STATES {
        let html = String::from_utf8_lossy(&InMemory::default().get("/", state.query).body).into_owned();
        let (page, drawer) = html.split_once("<aside id=\"detail\"").unwrap();
        let main = |part: &str| {
            part.split('<')
                .filter(|tag| {
                    tag.split("class=\"").nth(1).is_some_and(|class| {
                        class.split('"').next().unwrap_or_default().split(' ').any(|class| class == "primary")
                    })
                })
                .count()
        };
        // Where nothing fits, the change that lets an actuator fit comes with the proposals; a fault leads to its field.
        let expected = usize::from(!["start", "nothing-fits", "fault"].contains(&state.name));
        assert_eq!(main(page), expected, "{}", state.name);
        assert!(main(drawer) <= 1, "{}", state.name);
    }
}
