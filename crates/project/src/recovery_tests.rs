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

/// A heading that cannot be read takes its keys with it: the message says so, and no key is reported as unknown or missing.
#[test]
fn a_faulty_heading_says_that_it_may_hide_faults() {
    let lines: Vec<&str> = FAULTY.lines().collect();
    for (index, line) in lines.iter().enumerate().filter(|(_, line)| line.starts_with('[')) {
        for damaged in [line.trim_end_matches(']').to_owned(), line.replacen('[', "", 1)] {
            let mut all = lines.clone();
            all[index] = &damaged;
            let (found, syntax, hides) = faults(&(all.join("\n") + "\n"));
            if syntax > 0 && line.len() - damaged.len() == 1 && damaged.starts_with('[') {
                assert!(hides, "{damaged}");
                let invented = found.iter().filter(|(_, fault)| fault.contains("Unknown") || fault.contains("Missing"));
                assert_eq!(invented.count(), 0, "{damaged}: {found:#?}");
            }
        }
    }
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

/// The recovery of a large file takes no longer than some parses of it.
#[test]
fn a_large_file_of_faulty_lines_is_read_in_bounded_time() {
    let text = "format = 1\n[load]\n".to_owned() + &"inertia\n".repeat(20_000);
    let start = std::time::Instant::now();
    assert!(!read(&text).unwrap().report.into_faults().is_empty());
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
}
