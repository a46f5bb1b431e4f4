//! Rows in the wrong order: each is refused with its reason and what to do.

#![allow(clippy::unwrap_used, reason = "a failed expectation is a failed test")]

use recording::{Fault, FileRow, Layout, Remedy, Stamp, read_csv};

/// Returns a file with these times in milliseconds.
fn file(times: impl IntoIterator<Item = u32>) -> String {
    times.into_iter().fold(String::from("t [ms],q [deg]\n"), |text, t| format!("{text}{t},{}\n", f64::from(t) * 0.01))
}

/// Returns the remedy for the faults of a file.
fn remedy(text: &str) -> Option<Remedy> {
    let faults = read_csv(text.as_bytes(), &Layout::default()).unwrap_err();
    faults.iter().find_map(|fault| match fault {
        Fault::Advised { remedy, .. } => Some(*remedy),
        _ => None,
    })
}

#[test]
fn a_wrong_order_is_refused_with_its_reason() {
    for rows in [20_u32, 300, 20_000] {
        let times = || (0..rows).map(|k| 2 * k);
        assert_eq!(remedy(&file(times().rev())), Some(Remedy::Reverse), "{rows}");
        let twice = FileRow::Line(u64::from(rows) + 2);
        assert_eq!(remedy(&file(times().chain(times()))), Some(Remedy::KeepOne { at: twice }), "{rows}");
        for at in [0, 1, 7, rows as usize - 2] {
            let mut exchanged: Vec<u32> = times().collect();
            exchanged.swap(at, at + 1);
            let lines = [at as u64 + 2, at as u64 + 3].map(FileRow::Line);
            assert_eq!(remedy(&file(exchanged)), Some(Remedy::Exchange { rows: lines }), "{rows} {at}");
            let mut repeated: Vec<u32> = times().collect();
            repeated.insert(at, repeated[at]);
            assert_eq!(remedy(&file(repeated)), Some(Remedy::DeleteRepeated), "{rows} {at}");
        }
        // The memory of a logger that overwrites its oldest rows.
        let mut ring: Vec<u32> = times().collect();
        ring.rotate_left(5);
        assert_eq!(remedy(&file(ring)), Some(Remedy::Sort), "{rows}");
        let mut sorted_badly: Vec<u32> = times().collect();
        sorted_badly.rotate_left(5);
        sorted_badly.swap(1, 9);
        assert_eq!(remedy(&file(sorted_badly)), Some(Remedy::Sort), "{rows}");
    }
}

/// A clock that is set back, by an hour or by a little, is refused with the seconds to add.
#[test]
fn a_clock_set_back_is_no_disorder() {
    for rows in [20_u32, 300, 5000] {
        for at in [rows / 4, rows / 2, rows - 3] {
            let line = FileRow::Line(u64::from(at) + 2);
            let stamp = |k: u32, hour: u32| {
                let second = 10 * k;
                format!("2025-10-26T{:02}:{:02}:{:02}", hour + second / 3600, second / 60 % 60, second % 60)
            };
            let row = |k: u32| format!("{},{}\n", stamp(k, if k < at { 2 } else { 1 }), f64::from(k) * 0.1);
            let text = format!("t,q [deg]\n{}", (0..rows).map(row).collect::<String>());
            let found = remedy(&text);
            let is_by = |by: Stamp, seconds: f64| (by.unit.to_si(by.value) - seconds).abs() < 1e-9;
            assert!(
                matches!(found, Some(Remedy::SetBack { at, by }) if at == line && is_by(by, 3600.0)),
                "{rows} {at}: {found:?}"
            );
            let a_little = (0..rows).map(|k| if k < at { 2 * k + 100 } else { 2 * k + 89 });
            let found = remedy(&file(a_little));
            assert!(
                matches!(found, Some(Remedy::SetBack { at, by }) if at == line && is_by(by, 0.011)),
                "{rows} {at}: {found:?}"
            );
        }
    }
}

/// Rounded stamps are refused with the key that reads them, and read with it.
#[test]
fn equal_times_are_read_as_even_ones() {
    for rows in [20_u32, 300, 20_000] {
        let text = file((0..rows).map(|k| 2 * k / 5));
        assert_eq!(remedy(&text), Some(Remedy::EvenStamps), "{rows}");
        let layout = Layout { even_stamps: true, ..Layout::default() };
        let found = read_csv(text.as_bytes(), &layout).unwrap();
        assert_eq!(found.time_s.len(), rows as usize);
        let backwards = read_csv(file((0..rows).rev()).as_bytes(), &layout).unwrap_err();
        assert!(matches!(backwards.first(), Some(Fault::Advised { remedy: Remedy::Reverse, .. })));
    }
}
