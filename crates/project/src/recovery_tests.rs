use crate::{Fault, read};
use std::collections::BTreeSet;

/// A file with a fault in every table.
const FAULTY: &str = "format = 1\n\
    [mechanism.arm]\n\
    inertia = \"1 kg\"\n\
    mass = \"10 kg\"\n\
    mas = \"1 kg\"\n\
    centre_distance = \"0.1 m\"\n\
    axis_tilt = \"90 deg\"\n\
    \n\
    [[motion]]\n\
    law = \"trapezoid\"\n\
    distance = \"360 deg\"\n\
    speed = \"20 Nm\"\n\
    acceleration = \"20 rad/s^2\"\n\
    points = 3\n\
    [[motion]]\n\
    time = \"50 ms\"\n\
    [requirements]\n\
    brake = true\n\
    supply = 560\n\
    collision_torque = \"900 N m\"\n\
    unknown = 5\n\
    [bearing]\n\
    load_factor = 9999\n";

/// A way to damage a line, with its name.
type Damage = (&'static str, fn(&str) -> String);

/// Returns the faults with their lines, without those of the syntax, and the number of these.
fn faults(text: &str) -> (BTreeSet<(usize, String)>, usize, bool) {
    let all = read(text).unwrap().report.into_faults();
    let (mut found, mut syntax, mut hides) = (BTreeSet::new(), 0, false);
    for each in all {
        match each.fault {
            Fault::Syntax { hides: some, .. } => {
                syntax += 1;
                hides |= some;
            }
            fault => {
                found.insert((each.line, format!("{fault:?}")));
            }
        }
    }
    (found, syntax, hides)
}

/// Every way to damage a line leaves the faults of all other lines, and says so where it cannot.
#[test]
fn a_faulty_line_hides_no_fault_of_another() {
    let (whole, none, _) = faults(FAULTY);
    assert!(whole.len() >= 8 && none == 0, "{whole:#?}");
    let lines: Vec<&str> = FAULTY.lines().collect();
    let damages: [Damage; 11] = [
        ("open quote", |line| line.trim_end_matches('"').to_owned()),
        ("no quotes", |line| line.replace('"', "")),
        ("no value", |line| line.split('=').next().unwrap_or_default().trim().to_owned()),
        ("no value behind the sign", |line| format!("{} =", line.split('=').next().unwrap_or_default())),
        ("no sign", |line| line.replacen('=', "", 1)),
        ("two signs", |line| line.replacen('=', "= =", 1)),
        ("colon", |line| line.replacen(" =", ":", 1)),
        ("open list", |line| line.replacen("= ", "= [", 1)),
        ("open table", |line| line.replacen("= ", "= { a = ", 1)),
        ("open text", |line| line.replacen("= ", "= \"\"\"", 1)),
        ("rest of the line", |line| format!("{line} 5")),
    ];
    let mut tried = 0;
    for (index, line) in lines.iter().enumerate().filter(|(_, line)| line.contains('=')) {
        for (name, damage) in damages {
            let damaged = damage(line);
            let mut all = lines.clone();
            all[index] = &damaged;
            let text = all.join("\n") + "\n";
            let (found, syntax, hides) = faults(&text);
            if damaged == *line || syntax == 0 {
                continue;
            }
            tried += 1;
            assert!(!hides, "{name} in {line:?}");
            // Without the law of a segment it is open which keys belong to it.
            let of_law = |fault: &str| line.starts_with("law") && fault.contains("AnotherKind");
            let others = |all: &BTreeSet<(usize, String)>| -> BTreeSet<(usize, String)> {
                all.iter().filter(|(at, fault)| *at != index + 1 && !of_law(fault)).cloned().collect()
            };
            let (expected, found) = (others(&whole), others(&found));
            let missing: Vec<_> = expected.difference(&found).collect();
            let additional: Vec<_> = found.difference(&expected).collect();
            assert!(missing.is_empty() && additional.is_empty(), "{name} in {line:?}: {missing:#?} {additional:#?}");
        }
    }
    assert!(tried > 120, "{tried}");
}

/// A damaged heading is read as it is meant: one fault of its own, and the faults of all other lines.
#[test]
fn a_damaged_heading_is_read_as_it_is_meant() {
    let (whole, ..) = faults(FAULTY);
    let lines: Vec<&str> = FAULTY.lines().collect();
    let mut tried = 0;
    for (index, line) in lines.iter().enumerate().filter(|(_, line)| line.starts_with('[')) {
        let name = line.trim_matches(['[', ']']);
        let half = name.len() - 2;
        let damaged = [
            line[..line.len() - 1].to_owned(),
            line.trim_end_matches(']').to_owned(),
            line.trim_start_matches('[').to_owned(),
            line[1..].to_owned(),
            name.to_owned(),
            format!("{name}:"),
            line.replace(name, &format!("{name}.")),
            line.replace(name, &format!(".{name}")),
            line.replace(name, &format!("{} {}", &name[..half], &name[half..])),
            line.replace('.', " ") + "]",
            format!("{line} x"),
            line.replace('[', "{").replace(']', "}"),
            line.trim_end_matches(']').replace(name, &name.replacen('a', "aa", 1)),
        ];
        for damaged in damaged {
            let mut all = lines.clone();
            all[index] = &damaged;
            let (found, syntax, hides) = faults(&(all.join("\n") + "\n"));
            if syntax == 0 {
                // `[motion]` and `[[bearing]]` are valid alone.
                continue;
            }
            tried += 1;
            assert_eq!((syntax, hides), (1, false), "{damaged}");
            assert_eq!(found, whole, "{damaged}");
        }
    }
    assert!(tried > 50, "{tried}");
}

/// A heading of no table says that it may hide faults, and none is invented.
#[test]
fn an_unknown_damaged_heading_says_that_it_may_hide_faults() {
    for damaged in ["[xyzzy", "[[]]", "[]", "[[42]", "[.]"] {
        let text = FAULTY.replace("[requirements]", damaged);
        let (found, syntax, hides) = faults(&text);
        assert!(syntax == 1 && hides, "{damaged}: {syntax} {hides}");
        let known = [5, 21];
        let is_invented = |fault: &str| fault.contains("Unknown") || fault.contains("Missing");
        let invented = found.iter().filter(|(line, fault)| !known.contains(line) && is_invented(fault));
        assert_eq!(invented.count(), 0, "{damaged}: {found:#?}");
    }
}

/// A file with faults around and within a list of several lines.
const LISTED: &str = "format = 1\n\
    [load]\n\
    inertia = \"1 xyz\"\n\
    [[motion]]\n\
    law = \"points\"\n\
    points = [\n\
    \x20 [\"0 s\", \"0 deg\"],\n\
    \x20 [\"0.5 s\", \"30 dog\"],\n\
    \x20 # the end\n\
    \x20 [\"1 s\", \"0 deg\"],\n\
    ]\n\
    spline = \"cubic\"\n\
    ends = \"restt\"\n\
    [[motion]]\n\
    law = \"dwell\"\n\
    time = \"1 qs\"\n\
    [requirements]\n\
    supplyy = \"560 V\"\n";

/// A single sign that is missing or doubled in a list of several lines is one fault, at its line or where the list opens; the
/// faults of all other lines are those of the file.
#[test]
fn a_damaged_list_is_one_fault_and_invents_none() {
    let (whole, ..) = faults(LISTED);
    assert_eq!(whole.len(), 5, "{whole:#?}");
    let list = 6..=11;
    let mut tried = 0;
    for (at, sign) in LISTED.char_indices().filter(|(_, sign)| matches!(sign, '[' | ']' | '"' | ',')) {
        let line = LISTED[..at].matches('\n').count() + 1;
        if !list.contains(&line) {
            continue;
        }
        for damaged in
            [[&LISTED[..at], &LISTED[at + 1..]].concat(), [&LISTED[..at], &sign.to_string(), &LISTED[at..]].concat()]
        {
            let all = read(&damaged).unwrap().report.into_faults();
            let of_syntax = |each: &&crate::Diagnostic| matches!(each.fault, Fault::Syntax { .. });
            let Some(found) = all.iter().find(of_syntax) else { continue };
            tried += 1;
            assert_eq!(all.iter().filter(of_syntax).count(), 1, "{damaged}: {all:#?}");
            assert!(found.line == line || found.line == 6, "{damaged}: {all:#?}");
            let rest: BTreeSet<(usize, String)> = all
                .iter()
                .filter(|each| !of_syntax(each))
                .map(|each| (each.line, format!("{:?}", each.fault)))
                .collect();
            let hides = matches!(found.fault, Fault::Syntax { hides: true, .. });
            let expected = whole.iter().filter(|(at, _)| *at != found.line && !(hides && list.contains(at)));
            assert_eq!(rest, expected.cloned().collect(), "{damaged}");
        }
    }
    assert!(tried > 30, "{tried}");
}

/// A list that is not closed at the end of the table hides nothing, whatever follows.
#[test]
fn an_open_list_ends_before_the_next_key_or_heading() {
    for (from, to) in [
        ("]\nspline", "spline"),
        ("]\nspline = \"cubic\"\nends = \"restt\"\n", ""),
        (",\n]\nspline", "\nspline"),
        ("],\n]\nspline", ",\n]\nspline"),
    ] {
        let damaged = LISTED.replacen(from, to, 1);
        assert_ne!(damaged, LISTED);
        let (found, syntax, hides) = faults(&damaged);
        assert_eq!((syntax, hides), (1, false), "{damaged}: {found:#?}");
        let has = |what: &str| found.iter().any(|(_, fault)| fault.contains(what));
        assert!(has("xyz") && has("dog") && has("qs") && has("supplyy"), "{damaged}: {found:#?}");
        assert_eq!(found.len(), whole_without_keys(to), "{damaged}: {found:#?}");
    }
}

/// Returns the number of faults of the list without its last keys, which are missing then.
fn whole_without_keys(rest: &str) -> usize {
    if rest.is_empty() { 6 } else { 5 }
}

/// A key or heading with an invisible character has one fault, which names it; its value is read.
#[test]
fn an_invisible_character_is_named_once() {
    let (whole, ..) = faults(FAULTY);
    let mut tried = 0;
    for sign in ['\u{200b}', '\u{feff}', '\u{a0}', '\u{c}', '\u{ad}', '\u{3000}', '\u{202e}'] {
        for (index, line) in FAULTY.lines().enumerate().filter(|(_, line)| !line.is_empty()) {
            let end = line.find(" =").unwrap_or(line.len());
            let quoted = line.split_once(" =").map(|(key, value)| format!("\"{key}{sign}\" ={value}"));
            let inside = (!sign.is_whitespace()).then(|| format!("{}{sign}{}", &line[..3], &line[3..]));
            let around = [format!("{sign}{line}"), format!("{}{sign}{}", &line[..end], &line[end..])];
            for damaged in around.into_iter().chain(inside).chain(quoted) {
                // At the start of a file it is a mark; an unknown key has its fault already.
                let is_mark = index == 0 && damaged.starts_with('\u{feff}');
                if is_mark || line.starts_with("mas ") || line.starts_with("unk") {
                    continue;
                }
                let mut all: Vec<&str> = FAULTY.lines().collect();
                all[index] = &damaged;
                let (mut found, syntax, _) = faults(&(all.join("\n") + "\n"));
                let named = (index + 1, format!("{:?}", Fault::InvisibleCharacter { sign }));
                assert!(syntax == 0 && found.remove(&named), "{damaged:?}: {found:#?}");
                assert_eq!(found, whole, "{damaged:?}");
                tried += 1;
            }
        }
    }
    assert!(tried > 300, "{tried}");
}

/// The faults that are listed are the first ones by line, whatever their kind.
#[test]
fn the_first_faults_by_line_are_listed() {
    for end in [format!("a = {}", "[".repeat(60)), "abc\n".repeat(80), "unk = 1\n".repeat(80)] {
        let all = read(&format!("{FAULTY}{end}")).unwrap().report.into_faults();
        let found: BTreeSet<(usize, String)> =
            all.iter().map(|each| (each.line, format!("{:?}", each.fault))).collect();
        let (whole, ..) = faults(FAULTY);
        assert!(whole.is_subset(&found), "{end}: {all:#?}");
        assert!(all.iter().zip(all.iter().skip(1)).all(|(a, b)| a.line <= b.line), "{all:#?}");
    }
}

/// A file whose lines end with carriage returns alone has one fault more, and all lines are read.
#[test]
fn carriage_returns_alone_are_one_fault() {
    let (whole, ..) = faults(FAULTY);
    assert_eq!(faults(&FAULTY.replace('\n', "\r")), (whole.clone(), 1, false));
    assert_eq!(faults(&FAULTY.replace('\n', "\r\n")), (whole.clone(), 0, false));
    assert_eq!(faults(&FAULTY.replacen("\n[[", "\r[[", 1)), (whole, 1, false));
}

/// Two and three faulty lines are each reported.
#[test]
fn several_faulty_lines_are_all_reported() {
    let lines: Vec<&str> = FAULTY.lines().collect();
    let keys: Vec<usize> = (0..lines.len()).filter(|index| lines[*index].contains("= \"")).collect();
    for (a, b) in keys.iter().flat_map(|a| keys.iter().filter(move |b| *b > a).map(move |b| (*a, *b))) {
        let (open, bare) = (lines[a].trim_end_matches('"'), lines[b].split('=').next().unwrap().trim());
        let mut all = lines.clone();
        (all[a], all[b]) = (open, bare);
        let text = all.join("\n") + "\n";
        let (_, syntax, hides) = faults(&text);
        assert_eq!((syntax, hides), (2, false), "{open:?} and {bare:?}");
    }
}

/// The work of a recovery grows with the size of the file alone, and the report says where reading stopped.
#[test]
fn the_work_grows_with_the_size_of_the_file() {
    let lines = [
        "=",
        "[",
        "a=b",
        "a",
        "a=[",
        "a={",
        "a=[[",
        "a={b=[",
        "]",
        "}",
        "[[a",
        "a=\"\"\"",
        "a='''",
        "a=[\"\"\"",
        "\"",
        "a=[\n[1",
        "[1,",
        "a=[{b=1,",
        "\u{200b}a=1",
        "\u{a0}",
        "a=1,",
        "{",
        "a b",
        "[load",
        "[load]",
        ".",
        "a.b=[",
        "\r",
        "a=[1,\n]",
        "a=[1]\n]",
    ];
    for line in lines {
        for end in ["\n", "\n\n"] {
            let text = format!("{line}{end}").repeat(3000);
            let recovery = super::Recovery::of(&text, &|path: &[String]| crate::key::keys_at(crate::KEYS, path));
            assert!(recovery.work <= 6 * text.len() + 4000, "{line:?}: {} of {}", recovery.work, text.len());
            let all = read(&text).unwrap().report.into_faults();
            let says = all.iter().any(|each| matches!(each.fault, Fault::ReadingStopped { .. }));
            assert_eq!(says, recovery.stopped.is_some(), "{line:?}");
            assert!(all.len() <= 52, "{line:?}");
        }
    }
}
