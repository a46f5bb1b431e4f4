//! Tests of tables in every dialect: the same table gives the same rows, a malformed one is refused at its place.

use super::csv::{Broken, Lines};
use super::tests::MOVE;
use super::*;
use crate::list::Unanswered;
use axis::NoFiles;

const KEYS: [(&str, &str); 4] =
    [("load.inertia", "kg m^2"), ("load.friction_torque", "N·m"), ("motion[1].law", ""), ("requirements.brake", "")];

const ROWS: [(f64, f64, &str, bool); 3] =
    [(0.5, 5.25, "trapezoid", true), (1.0, 0.0, "polynomial_5", false), (1250.0, 12.0625, "trapezoid", true)];

/// Notation of a table, an index into the choices of each property.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Dialect {
    separator: char,
    has_commas: bool,
    encoding: usize,
    padding: usize,
    quoting: usize,
    unit: usize,
    notes: usize,
    truth: usize,
    end: &'static str,
}

const PLAIN: Dialect = Dialect {
    separator: ',',
    has_commas: false,
    encoding: 0,
    padding: 0,
    quoting: 0,
    unit: 0,
    notes: 0,
    truth: 0,
    end: "\n",
};

const UNITS: usize = 7;
const TRUTHS: [[&str; 2]; 5] =
    [["true", "false"], ["TRUE", "FALSE"], ["True", "False"], ["WAHR", "FALSCH"], ["Wahr", "Falsch"]];

impl Dialect {
    /// Draws a dialect; decimal commas between commas are quoted.
    fn drawn(mut draw: impl FnMut(usize) -> usize) -> Self {
        let separator = [',', ';', '\t', '|'][draw(4)];
        let has_commas = draw(2) == 1;
        let quoting = if has_commas && separator == ',' { 2 } else { draw(3) };
        Self {
            separator,
            has_commas,
            encoding: draw(5),
            padding: if quoting == 0 { draw(3) } else { draw(2) },
            quoting,
            unit: draw(UNITS),
            notes: draw(4),
            truth: draw(TRUTHS.len()),
            end: ["\n", "\r\n", "\r"][draw(3)],
        }
    }

    fn number(self, value: f64, unit: &str) -> String {
        let text = if self.has_commas { value.to_string().replace('.', ",") } else { value.to_string() };
        if self.unit == 6 { format!("{text} {unit}") } else { text }
    }

    /// Returns the lines of the table as cells: headings, units if they have a line, rows.
    fn cells(self) -> Vec<Vec<String>> {
        let heading = |(key, unit): (&str, &str)| match self.unit {
            _ if unit.is_empty() => key.to_owned(),
            0 => format!("{key} [{unit}]"),
            1 => format!("{key} ({unit})"),
            2 => format!("{key} {{{unit}}}"),
            3 => format!("{key} / {unit}"),
            4 => format!("{key} in {unit}"),
            _ => key.to_owned(),
        };
        let mut lines = vec![KEYS.map(heading).to_vec()];
        if self.unit == 5 {
            lines
                .push(KEYS.map(|(_, unit)| if unit.is_empty() { String::new() } else { format!("[{unit}]") }).to_vec());
        }
        let row = |(inertia, friction, law, brake): (f64, f64, &str, bool)| {
            let truth = TRUTHS[self.truth][usize::from(!brake)];
            let numbers = [(inertia, KEYS[0].1), (friction, KEYS[1].1)].map(|(value, unit)| self.number(value, unit));
            numbers.into_iter().chain([law.to_owned(), truth.to_owned()]).collect()
        };
        lines.extend(ROWS.map(row));
        lines
    }

    /// Returns the bytes of a table of these lines.
    fn written(self, lines: &[Vec<String>]) -> Vec<u8> {
        let separator = self.separator.to_string();
        let cell = |cell: &String| match self.quoting {
            0 => cell.clone(),
            1 if cell.parse::<f64>().is_ok() || cell.contains(',') => cell.clone(),
            _ => format!("\"{cell}\""),
        };
        let mut text = match self.notes {
            1 => format!("sep={separator}{}", self.end),
            2 => format!("# 5 µm; a, b{0}{0}", self.end),
            3 => ["Study of 5 µm", "", "by,me", "12,5;3"].join(self.end) + self.end,
            _ => String::new(),
        };
        for line in lines {
            let cells: Vec<String> = line.iter().map(cell).collect();
            let line = match self.padding {
                1 => format!("{}{separator}{separator}", cells.join(&separator)),
                2 => format!(" {} ", cells.join(&format!(" {separator} "))),
                _ => cells.join(&separator),
            };
            text.push_str(&line);
            text.push_str(self.end);
        }
        if self.padding == 1 {
            text.push_str(&format!("{0}{1}{0}{1}", separator.repeat(5), self.end));
        }
        match self.encoding {
            1 => format!("\u{feff}{text}").into_bytes(),
            2 => "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect(),
            3 => "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(u16::to_be_bytes).collect(),
            4 => text.chars().map(|sign| u8::try_from(u32::from(sign)).unwrap()).collect(),
            _ => text.into_bytes(),
        }
    }
}

/// Returns the values of each row of a table, or its faults.
fn read(bytes: &[u8]) -> Result<Vec<Vec<String>>, TableFaults> {
    let mut lines = Lines::open(bytes).unwrap();
    let headings = lines.headings().to_vec();
    let headings: Vec<MeantHeading> = headings.iter().map(|heading| heading.as_str().into()).collect();
    let options = Options { commas: lines.commas(), ..Options::default() };
    let mut head = Head::of(("axis.toml", MOVE), &NoFiles, &headings, options);
    let (mut parts, mut rows) = (Vec::new(), 0);
    while !head.is_enough() {
        match lines.rows(2) {
            Ok(None) => break,
            Ok(Some(columns)) => {
                let texts = columns
                    .into_iter()
                    .map(|cells| Cells::Texts(cells.into_iter().map(|cell| cell.map(Cow::Owned)).collect()));
                let cells: Vec<Cells<'static>> = texts.collect();
                head.check(&cells, rows);
                rows += cells[0].len() as u64;
                parts.push(cells);
            }
            Err(Broken::Line(fault)) => {
                head.refuse_line(fault, rows);
                rows += 1;
            }
            Err(Broken::Unread(fault)) => panic!("{fault:?}"),
        }
    }
    let sweep = head.ready("", Box::new(NoFiles)).map_err(|why| match why {
        Unanswered::Table { faults, .. } => faults,
        other => panic!("{other:?}"),
    })?;
    let keys: Vec<&str> = sweep.keys().collect();
    assert_eq!(keys, KEYS.map(|(key, _)| key));
    let written = |value: Value<'_>| match value {
        Value::Number(number) => number.to_string(),
        Value::Text(text) => text.to_owned(),
    };
    let row = |cells: &[Cells<'static>], row| sweep.values(cells, row).unwrap().into_iter().map(written).collect();
    Ok(parts.iter().flat_map(|cells| (0..cells[0].len()).map(|place| row(cells, place)).collect::<Vec<_>>()).collect())
}

/// Returns a source of numbers below a bound from a seed.
fn draws() -> impl FnMut(usize) -> usize {
    let mut state = 7_u64;
    move |most| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(state >> 33).unwrap() % most
    }
}

#[test]
fn a_table_has_the_same_rows_in_every_dialect() {
    let expected = read(&PLAIN.written(&PLAIN.cells())).unwrap();
    let row = |(inertia, friction, law, brake): (f64, f64, &str, bool)| {
        vec![inertia.to_string(), friction.to_string(), law.to_owned(), brake.to_string()]
    };
    assert_eq!(expected, ROWS.map(row));
    let mut draw = draws();
    for _ in 0..240 {
        let dialect = Dialect::drawn(&mut draw);
        let bytes = dialect.written(&dialect.cells());
        let found = read(&bytes);
        assert_eq!(found.as_ref().ok(), Some(&expected), "{dialect:?}: {found:?}\n{}", String::from_utf8_lossy(&bytes));
    }
}

/// A fault of one cell, line or heading is the only one, with its heading and row, or the number of its line.
#[test]
fn a_malformed_table_is_refused_at_its_place() {
    type Change = fn(&mut Vec<Vec<String>>, &Dialect);
    // The change, the fault, whether it is that of a line, and the heading of the fault.
    let changes: [(&str, Change, &str, bool, Option<usize>); 9] = [
        ("a cell too few", |lines, _| drop(lines.last_mut().unwrap().pop()), "ragged", true, None),
        ("a cell too many", |lines, _| lines.last_mut().unwrap().push("7".to_owned()), "ragged", true, None),
        ("an open quote", |lines, _| lines.last_mut().unwrap()[3] = "\"true".to_owned(), "open_quote", true, None),
        ("a word", |lines, _| lines.last_mut().unwrap()[0] = "heavy".to_owned(), "not_a_number", false, Some(0)),
        ("thousands", |lines, _| lines.last_mut().unwrap()[1] = "1'234".to_owned(), "not_a_number", false, Some(1)),
        ("an empty cell", |lines, _| lines.last_mut().unwrap()[1] = String::new(), "no_value", false, Some(1)),
        ("another unit", |lines, _| lines.last_mut().unwrap()[1] = "7 mN m".to_owned(), "unit_of_cell", false, Some(1)),
        ("no truth", |lines, _| lines.last_mut().unwrap()[3] = "maybe".to_owned(), "not_a_choice", false, Some(3)),
        (
            "the other decimal sign",
            |lines, dialect| {
                let text = if dialect.has_commas { "7.5" } else { "7,5" };
                lines.last_mut().unwrap()[0] = text.to_owned();
            },
            "decimal_mixed",
            false,
            Some(0),
        ),
    ];
    let mut draw = draws();
    for (name, change, id, is_of_line, column) in changes {
        for _ in 0..24 {
            let dialect = Dialect { padding: 0, ..Dialect::drawn(&mut draw) };
            let is_open = id == "open_quote" && dialect.quoting > 0;
            let is_single = id == "decimal_mixed" && dialect.separator == ',' && dialect.quoting != 2;
            // Numbers without a unit below cells with one are another fault.
            if is_open || is_single || dialect.unit == 6 {
                continue;
            }
            let mut lines = dialect.cells();
            change(&mut lines, &dialect);
            let bytes = dialect.written(&lines);
            let context = format!("{name} {dialect:?}\n{}", String::from_utf8_lossy(&bytes));
            let faults = read(&bytes).unwrap_err().listed;
            let [fault] = faults.as_slice() else { panic!("{context}: {faults:?}") };
            assert_eq!((fault.id, fault.row), (id, Some(2)), "{context}: {fault:?}");
            let above = match dialect.notes {
                1 => 1,
                2 => 2,
                3 => 4,
                _ => 0,
            };
            if is_of_line {
                let line = above + lines.len();
                assert!(fault.message.contains(&format!("line {line}")), "{context}: {fault:?}");
            }
            let heading = column.map_or("", |column| KEYS[column].0);
            assert!(fault.heading.starts_with(heading), "{context}: {fault:?}");
        }
    }
}

#[test]
fn a_heading_that_names_no_key_is_refused_with_what_is_meant() {
    let hint = |heading: &str| -> (&'static str, String) {
        let table = format!("{heading};load.inertia [kg m^2]\n1;2\n");
        let faults = read(table.as_bytes()).unwrap_err().listed;
        let [fault] = faults.as_slice() else { panic!("{heading}: {faults:?}") };
        (fault.id, fault.hint.clone().unwrap_or_default())
    };
    for (heading, id, meant) in [
        ("friction", "unknown_key", "`load.friction_torque`"),
        ("friction [N m]", "unknown_key", "`load.friction_torque`"),
        ("time", "unknown_key", "`motion[1].time`"),
        ("zeit", "unknown_key", "`motion[1].time`"),
        ("angle [deg]", "unknown_key", "`motion[1].distance`"),
        ("ambient", "unknown_key", "`requirements.ambient`"),
        ("Load.Friction_Torque (N m)", "unknown_key", "`load.friction_torque`"),
        ("id", "unknown_key", "load.inertia [kg m^2]"),
        ("row", "unknown_key", "load.inertia [kg m^2]"),
        ("", "no_heading", "index=False"),
    ] {
        let (found, hint) = hint(heading);
        assert!(found == id && hint.contains(meant), "{heading}: {found} {hint}");
    }
}

/// A number without a unit below cells that state theirs has none.
#[test]
fn a_number_without_a_unit_is_refused_below_cells_with_one() {
    let faults = read(b"load.inertia;load.friction_torque [N m]\n1 kg m^2;2\n3;4\n").unwrap_err().listed;
    let [fault] = faults.as_slice() else { panic!("{faults:?}") };
    assert!((fault.id, fault.row) == ("unit_of_cell", Some(1)) && fault.message.contains("load.inertia"), "{fault:?}");
}
