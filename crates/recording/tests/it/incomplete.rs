//! Recordings with rows that lack values and with lines that are no rows.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use quantities::{Measure, Time};
use recording::{ColumnSpec, Fault, Layout, Remedy, Role, read_csv};

/// Number of samples, 2 ms apart.
const COUNT: usize = 400;

/// A recording whose rows are replaced where `replaced` returns other cells behind the time.
fn text(heading: &str, replaced: impl Fn(usize) -> Option<String>) -> String {
    let values =
        |k: usize| (1..heading.split(';').count()).map(|_| format!("{:.6}", 1e-3 * k as f64)).collect::<Vec<_>>();
    let row = |k: usize| format!("{:.3};{}\n", 2e-3 * k as f64, replaced(k).unwrap_or_else(|| values(k).join(";")));
    std::iter::once(format!("{heading}\n")).chain((0..COUNT).map(row)).collect()
}

fn remedies(text: &str) -> Vec<Remedy> {
    let faults = read_csv(text.as_bytes(), &Layout::default()).unwrap_err();
    let remedy = |fault: &Fault| match fault {
        Fault::Advised { remedy, .. } => Some(*remedy),
        _ => None,
    };
    faults.iter().filter_map(remedy).collect()
}

/// The window of a remedy, which must read the recording.
fn read_within(text: &str, remedy: Remedy) -> usize {
    let Remedy::Within { from, to } = remedy else { panic!("{remedy:?}") };
    let si = |stamp: Option<recording::Stamp>| stamp.map(|stamp| Time::from_si(stamp.unit.to_si(stamp.value)));
    let layout = Layout { from: si(from), to: si(to), ..Layout::default() };
    read_csv(text.as_bytes(), &layout).unwrap().time_s.len()
}

/// Every word of a logger for a missing value, at the beginning, at the end, at both and between, in each column.
#[test]
fn missing_values_come_with_what_can_be_read() {
    for word in ["", "NaN", "nan", "OVL", "Overflow", "-----", "null", "#NV", "+OL", "x", "inf"] {
        for (ends, is_lacking) in [
            ((3, 0), (|k| k < 3) as fn(usize) -> bool),
            ((0, 5), |k| k >= COUNT - 5),
            ((3, 5), |k| !(3..COUNT - 5).contains(&k)),
            ((0, 0), |k| k % 2 == 1),
            ((0, 0), |k| k == 7),
        ] {
            let context = format!("{word:?} {ends:?}");
            // The only column of the course.
            let one = text("t [s];q [deg]", |k| is_lacking(k).then(|| word.to_owned()));
            let found = remedies(&one);
            assert!(!found.is_empty(), "{context}");
            match ends {
                (0, 0) => assert!(found.iter().all(|remedy| *remedy == Remedy::Delete), "{context}: {found:?}"),
                (lead, tail) => assert_eq!(read_within(&one, found[0]), COUNT - lead - tail, "{context}"),
            }
            // A course has two columns, and a torque is not needed.
            for (role, heading, layout) in [
                (Role::Speed, "t [s];q [deg];n [1/min]", 0),
                (Role::Position, "t [s];n [1/min];q [deg]", 1),
                (Role::Torque, "t [s];q [deg];M [Nm]", 2),
            ] {
                let two = text(heading, |k| is_lacking(k).then(|| format!("1;{word}")));
                let found = remedies(&two);
                assert!(found.iter().all(|remedy| *remedy == Remedy::Without(role)), "{context}: {found:?}");
                let unused = ColumnSpec { unused: true, ..ColumnSpec::default() };
                let none = Layout::default();
                let layout = match layout {
                    0 => Layout { speed: unused, ..none },
                    1 => Layout { position: unused, ..none },
                    _ => Layout { torque: unused, ..none },
                };
                assert!(!found.is_empty() && read_csv(two.as_bytes(), &layout).is_ok(), "{context} {role:?}");
            }
        }
    }
}

/// Lines below the last row are named, and read over once the end is stated as the fault says it.
#[test]
fn a_footer_is_read_over_once_the_end_is_stated() {
    for footer in ["[Statistics]\nNmbOfSamples 400\n", "Max;;31\nMin;;-2\nMean;;\n", "0.80", "\"open;1;2\n", "EOF;x\n"]
    {
        for heading in ["t [s];q [deg];n [1/min]", "t [ms];q [deg];n [1/min]"] {
            let text = format!("{}{footer}", text(heading, |_| None));
            let faults = read_csv(text.as_bytes(), &Layout::default()).unwrap_err();
            let Fault::BelowRows { count, last, .. } = faults[0] else { panic!("{footer}: {faults:?}") };
            assert_eq!(count, footer.lines().count() as u64, "{footer}");
            let to = Some(Time::from_si(last.unit.to_si(last.value)));
            let recording = read_csv(text.as_bytes(), &Layout { to, ..Layout::default() }).unwrap();
            assert_eq!(recording.time_s.len(), COUNT, "{footer}");
            // Before the end of the window such a line remains a fault.
            let to = Some(Time::from_si(2.0 * last.unit.to_si(last.value)));
            assert!(read_csv(text.as_bytes(), &Layout { to, ..Layout::default() }).is_err(), "{footer}");
        }
    }
    // A line among rows is none below them.
    let between = text("t [s];q [deg]", |_| None).replacen("0.010;", "x;1;2\n0.010;", 1);
    let faults = read_csv(between.as_bytes(), &Layout::default()).unwrap_err();
    assert!(matches!(faults.as_slice(), [Fault::Ragged { .. }]), "{faults:?}");
}
