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

/// Columns of one axis, chosen by their names, belong together; those of different axes are refused with the line to write.
#[test]
fn columns_of_different_axes_are_not_combined() {
    let rows = "0,1,2\n1,2,3\n2,3,4\n";
    for [position, torque] in [
        ["axis1.pos [deg]", "axis2.tau [Nm]"],
        ["Achse_X.Ist-Lage [deg]", "Achse_Y.Moment [Nm]"],
        ["joint_1/position [rad]", "joint_2/effort [Nm]"],
        ["q1 [deg]", "tau2 [Nm]"],
        ["Axis[1].ActPos [deg]", "Axis[2].ActTorque [Nm]"],
    ] {
        let faults = read(&format!("t [s],{position},{torque}\n{rows}")).unwrap_err();
        assert!(
            matches!(&faults[..], [Fault::SeveralAxes { columns }] if columns.len() == 2),
            "{position}: {faults:?}"
        );
        let same = torque.replace('2', "1").replace("_Y", "_X");
        assert!(read(&format!("t [s],{position},{same}\n{rows}")).is_ok(), "{same}");
        assert!(read(&format!("t [s],{position},torque [Nm]\n{rows}")).is_ok(), "{position}");
    }
}

/// The list of properties of a scope does not state if the values contain the scale of a channel.
#[test]
fn a_scale_of_a_scope_is_refused() {
    let text = |scale: &str| {
        format!(
            "Name\tYT Scope Project\n\nName\tActPos\tName\tActVelo\nSymbolComment\t\tSymbolComment\t\n\
             Data-Type\tREAL64\tData-Type\tREAL64\nSampleTime[ms]\t2\tSampleTime[ms]\t2\n\
             Offset\t0\tOffset\t0\nScaleFactor\t{scale}\tScaleFactor\t1\nUnit\t° (Angle)\tUnit\t°/s (None)\n\n\
             0\t0\t0\t0\n2\t0\t2\t0\n4\t0\t4\t0\n6\t0\t6\t0\n"
        )
    };
    let faults = read(&text("0,01")).unwrap_err();
    assert!(matches!(&faults[..], [Fault::ScaleUnknown { scale, .. }] if scale[0] == "0,01"), "{faults:?}");
    let plain = read(&text("1"));
    assert!(plain.is_ok(), "{plain:?}");
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
