//! Lines that begin with `#`: rows, headings and comments.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use recording::{Fault, Layout, Recording, Records, read_csv};

fn read(text: &str) -> Result<Recording, Vec<Fault>> {
    read_csv(text.as_bytes(), &Layout::default())
}

/// Rows whose first cell begins with `#` are rows, wherever they stand; every other line with the sign is a comment and counted.
#[test]
fn a_marked_row_is_a_row_and_a_comment_is_counted() {
    arbtest::arbtest(|u| {
        let delimiter = [";", ",", "\t", "|"][u.int_in_range(0..=3_usize)?];
        let count = u.int_in_range(3..=400_u64)?;
        let (mut text, mut comments) = (String::new(), 0);
        for _ in 0..u.int_in_range(0..=2_u8)? {
            text.push_str("# logger 4\n");
        }
        text.push_str(&["Name", "t [s]", "q [deg]"].join(delimiter));
        text.push('\n');
        if u.arbitrary()? {
            text.push_str(&["", "s", "deg"].join(delimiter));
            text.push('\n');
        }
        for k in 0..count {
            if u.ratio(1, 8)? {
                // Few cells, or as many without a number.
                text.push_str(if u.arbitrary()? { "# pause\n" } else { "#a;b,c\td|e\n" });
                comments += 1;
            }
            let name = if u.ratio(2, 3)? { format!("#{k}") } else { format!("Lauf {k}") };
            text.push_str(&[name, format!("{:.1}", 0.1 * k as f64), format!("{k}")].join(delimiter));
            text.push('\n');
        }
        let found = read(&text).unwrap_or_else(|faults| panic!("{faults:?}\n{text}"));
        assert_eq!((found.time_s.len() as u64, found.comments), (count, comments), "{text}");
        let mut records = Records::open_below(text.as_bytes(), |cell| cell.starts_with("q ")).unwrap();
        let mut rows = 0;
        while records.advance().unwrap() {
            rows += 1;
        }
        assert!(rows == count || rows == count + 1, "{rows} {count} with the row of units\n{text}");
        assert_eq!(records.comments(), comments, "{text}");
        Ok(())
    });
}

/// A heading in a comment directly above the rows, below lines about the file too, with units in a comment or in a line.
#[test]
fn a_marked_heading_stands_above_the_rows() {
    let rows: String = (0..40).map(|k| format!("{:.3},{:.4}\n", 0.01 * f64::from(k), 0.5 * f64::from(k))).collect();
    for head in [
        "# t [s],q [deg]\n",
        "Logger 5\n# t [s],q [deg]\n",
        "Logger,Halle\n# t [s],q [deg]\n",
        "# run 7\n# t,q\n# s,deg\n",
        "# t,q\ns,deg\n",
        "t,q\n# in seconds\ns,deg\n",
        "#t [s],q [deg]\n\n",
    ] {
        let found = read(&format!("{head}{rows}")).unwrap_or_else(|faults| panic!("{head}: {faults:?}"));
        assert_eq!(found.time_s.len(), 40, "{head}");
        let positions = &found.course.position.unwrap().values;
        assert!((positions[39] - 19.5_f64.to_radians()).abs() < 1e-12, "{head}");
    }
    let table = "# study 7\n# load.inertia;load.friction\n0,5;1\n1,5;2\n";
    let mut records = Records::open_below(table.as_bytes(), |cell| cell.starts_with("load.")).unwrap();
    assert_eq!(records.headings(), ["load.inertia", "load.friction"]);
    assert!(records.advance().unwrap() && records.text() == "0,5;1");
}

/// A row of which a sign makes a comment is not dropped: it would be missed in the motion.
#[test]
fn a_row_turned_into_a_comment_is_reported() {
    let rows: String =
        (0..40).map(|k| format!("{}{:.2},{k}\n", if k == 30 { "# " } else { "" }, 0.01 * f64::from(k))).collect();
    let faults = read(&format!("t [s],q [deg]\n{rows}")).unwrap_err();
    let text = Some(String::from("# 0.30"));
    assert!(matches!(faults.as_slice(), [Fault::ValueUnreadable { text: found, .. }] if *found == text), "{faults:?}");
}
