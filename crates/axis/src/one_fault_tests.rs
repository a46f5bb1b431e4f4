use crate::{AxisProject, NoCatalogue, NoFiles};
use project::{KEYS, Key, Kind, example};
use std::collections::BTreeSet;

/// Projects without a fault that state the keys of every mechanism.
const EXAMPLES: [&str; 18] = [
    include_str!("../../../examples/belt-axis.toml"),
    include_str!("../../../examples/cam-motion.toml"),
    include_str!("../../../examples/cam-table.toml"),
    include_str!("../../../examples/conveyor.toml"),
    include_str!("../../../examples/four-bar.toml"),
    include_str!("../../../examples/hoist.toml"),
    include_str!("../../../examples/indexing-table.toml"),
    include_str!("../../../examples/scissor-lift.toml"),
    include_str!("../../../examples/screw-axis.toml"),
    include_str!("../../../examples/slewing-arm.toml"),
    include_str!("../../../examples/slider-crank.toml"),
    include_str!("../../../examples/stage-axis.toml"),
    include_str!("../../../examples/tilting-arm.toml"),
    include_str!("../../../examples/tolerances.toml"),
    include_str!("../../../examples/turntable.toml"),
    include_str!("../../../examples/two-axes.toml"),
    include_str!("../../../examples/two-way-shuttle.toml"),
    include_str!("../../../examples/winder.toml"),
];

/// Motions for the generated projects.
const MOTIONS: [&str; 4] = [
    "[[motion]]\nlaw = \"manual\"\nspeed = \"4 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\n\
     pause = \"1 s\"\n",
    "[[motion]]\nlaw = \"jerk\"\ndistance = \"10 deg\"\nspeed = \"4 1/min\"\nacceleration = \"20 rad/s^2\"\n\
     jerk = \"2000 rad/s^3\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\nhold = \"motor\"\n\
     [[motion]]\nlaw = \"trapezoid\"\ndistance = \"-10 deg\"\nacceleration = \"20 rad/s^2\"\n",
    "[[motion]]\nlaw = \"points\"\nspline = \"quintic\"\nends = \"stated\"\nmaster_speed = \"40 1/min\"\n\
     start_speed = \"1 1/min\"\nend_speed = \"1 1/min\"\nstart_acceleration = \"1 rad/s^2\"\n\
     end_acceleration = \"1 rad/s^2\"\npoints = [\n[\"0 deg\", \"0 deg\"],\n[\"90 deg\", \"9 deg\"],\n[\"180 deg\", \"0 deg\"],\n]\n",
    "[[motion]]\nlaw = \"points\"\nspline = \"cubic\"\nends = \"rest\"\n\
     points = [\n[\"0 s\", \"0 deg\"],\n[\"0.4 s\", \"9 deg\"],\n[\"1 s\", \"0 deg\"],\n]\n",
];

/// Appends a table with an example of each of its keys.
fn append(text: &mut String, heading: &str, keys: &[Key], skipped: &[&str]) {
    text.push_str(&format!("[{heading}]\n"));
    let is_value = |key: &&Key| {
        !matches!(key.kind, Kind::Table(_) | Kind::Variants(_) | Kind::OneOrMany(..)) && !skipped.contains(&key.name)
    };
    for key in keys.iter().filter(is_value) {
        text.push_str(&example(key).unwrap());
        text.push('\n');
    }
}

fn table(name: &str) -> &'static [Key] {
    KEYS.iter().find(|key| key.name == name).unwrap().kind.keys(false)
}

/// Returns projects that state every key of every mechanism, beside those of all other tables.
fn generated() -> Vec<String> {
    let mut all = Vec::new();
    for (index, mechanism) in table("mechanism").iter().enumerate() {
        let mut text = "format = 1\n".to_owned();
        append(&mut text, &format!("mechanism.{}", mechanism.name), mechanism.kind.keys(false), &["body"]);
        text.push_str(MOTIONS[index % MOTIONS.len()]);
        // A belt and teeth exclude each other.
        let skipped: &[&str] = if index % 2 == 0 { &["belt_tension"] } else { &["pressure_angle", "helix_angle"] };
        append(&mut text, "bearing", table("bearing"), skipped);
        if index % 3 > 0 {
            append(&mut text, "stage", table("stage"), &["ratios"]);
        }
        let mains: &[&str] = if index % 2 == 0 { &["mains", "mains_phases", "mains_deviation"] } else { &["supply"] };
        append(&mut text, "requirements", table("requirements"), mains);
        if index % 4 == 0 {
            append(&mut text, "drive", table("drive"), &[]);
            append(&mut text, "actuator", table("actuator"), &[]);
            append(&mut text, "twin", table("twin"), &[]);
        }
        if index % 3 == 0 {
            for (kind, pattern) in [("continuous", "CHA-25A-50-*"), ("peak", "CHA-20A-*")] {
                text.push_str(&format!("[[curve]]\nkind = \"{kind}\"\ncode = \"{pattern}\"\nsource = \"own\"\n"));
                text.push_str("points = [\n[\"0 1/min\", \"10 N m\"],\n[\"9 1/min\", \"5 N m\"],\n]\n");
            }
        }
        all.push(text);
    }
    all
}

/// Returns the faults by identifier, with their lines.
fn faults(text: &str) -> BTreeSet<(usize, &'static str)> {
    let found = AxisProject::read_all(text, &NoFiles, &NoCatalogue::shared(), &|_, _| None);
    found.err().unwrap_or_default().into_iter().map(|each| (each.line, each.fault.id())).collect()
}

/// A key that stands in the file with a fault counts as stated for every other fault: one damaged value is one fault.
#[test]
fn one_damaged_value_is_one_fault() {
    let (mut tried, mut wrong) = (0, Vec::new());
    let examples = EXAMPLES.iter().map(|text| (*text).to_owned());
    for (file, text) in examples.chain(generated()).enumerate() {
        let sound = faults(&text);
        let lines: Vec<&str> = text.lines().collect();
        for (index, line) in lines.iter().enumerate() {
            let code = line.split('#').next().unwrap_or_default().trim_end();
            let damaged = match (code.split_once(" = "), code.starts_with("[\"")) {
                (Some((_, "[")), _) => continue,
                (Some((key, value)), _) => {
                    let other = if value.starts_with('"') { "\"1 xq\"" } else { "\"x\"" };
                    [
                        format!("{key} = {other}"),
                        format!("{key} = "),
                        key.to_owned(),
                        format!("{key} = {value} x"),
                        format!("{key} = 1979-05-27"),
                    ]
                }
                (None, true) => [
                    code.replacen('"', "\"x", 1),
                    code.replacen(']', "", 1),
                    code.replacen('"', "", 1),
                    format!("{code} 1"),
                    code.replacen("deg", "dog", 1),
                ],
                (None, false) => continue,
            };
            // Every line with one of the ways to damage it.
            let way = (index + file) % damaged.len();
            for damaged in damaged.iter().skip(way).take(1).filter(|damaged| *damaged != code) {
                let mut all = lines.clone();
                all[index] = damaged;
                let found = faults(&(all.join("\n") + "\n"));
                let new: Vec<&(usize, &str)> = found.difference(&sound).collect();
                tried += 1;
                // A free text may be anything.
                let is_text = new.is_empty() && damaged.contains("\"1 xq\"");
                let is_one = new.len() == 1 && new[0].0 == index + 1;
                if !is_text && !is_one {
                    let table = lines.iter().find(|line| line.starts_with("[mech") || line.starts_with("[load"));
                    wrong.push(format!("{damaged:?} at line {} of {table:?}: {new:?}", index + 1));
                }
            }
        }
    }
    assert!(tried > 1500, "{tried}");
    assert!(wrong.is_empty(), "{} of {tried}\n{}", wrong.len(), wrong.join("\n"));
}

/// Collects the words of each key that is a choice, wherever it stands.
fn choices(keys: &'static [Key], found: &mut Vec<(&'static str, &'static [&'static str])>) {
    for key in keys {
        if let Kind::OneOf(words) = key.kind {
            found.push((key.name, words));
        }
        choices(key.kind.keys(false), found);
    }
}

/// A word that is none of a key that decides which others are needed is one fault: until it is known, no other key is missing
/// or out of place. The words are at any distance from the valid ones.
#[test]
fn an_unknown_choice_is_one_fault() {
    let mut known = Vec::new();
    choices(KEYS, &mut known);
    let (mut tried, mut wrong, mut seen) = (0, Vec::new(), BTreeSet::new());
    for text in EXAMPLES.iter().map(|text| (*text).to_owned()).chain(generated()) {
        let sound = faults(&text);
        let lines: Vec<&str> = text.lines().collect();
        for (index, line) in lines.iter().enumerate() {
            let code = line.split('#').next().unwrap_or_default().trim_end();
            let Some((key, value)) = code.split_once(" = ") else { continue };
            let word = value.trim_matches('"');
            let Some((name, words)) = known.iter().find(|(name, words)| *name == key && words.contains(&word)) else {
                continue;
            };
            // Every choice of every table once, with all words.
            let table = lines[..index].iter().rev().find(|line| line.starts_with('[')).copied().unwrap_or_default();
            if !seen.insert((table.to_owned(), *name, word.to_owned())) {
                continue;
            }
            let bent = words.iter().flat_map(|word| {
                let (first, rest) = word.split_at(1);
                let middle = word.len() / 2;
                [format!("{word}{first}"), rest.to_owned(), word[..middle].to_owned(), format!("{first}x{rest}")]
            });
            let other = ["sinus", "none", "x", "cam", "linear", "spline", "continual"].map(str::to_owned);
            for written in bent.chain(other).filter(|written| !words.contains(&written.as_str())) {
                let damaged = format!("{key} = \"{written}\"");
                let mut all = lines.clone();
                all[index] = &damaged;
                let found = faults(&(all.join("\n") + "\n"));
                let new: Vec<&(usize, &str)> = found.difference(&sound).collect();
                tried += 1;
                // A synonym of a choice is none of the listed words and no fault.
                if !(new.is_empty() || new.len() == 1 && new[0].0 == index + 1) {
                    wrong.push(format!("{table} {damaged}: {new:?}"));
                }
            }
        }
    }
    assert!(tried > 1000 && seen.len() > 30, "{tried} of {}", seen.len());
    assert!(wrong.is_empty(), "{} of {tried}\n{}", wrong.len(), wrong.join("\n"));
}
