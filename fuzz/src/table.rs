//! Tables of many axes, as `sweep` reads them: CSV of any dialect and Parquet; an answer for each row, or the faults.

use crate::recorded::{Columns, GeneratedColumn, as_table, encoded};
use crate::text::{any_edits, mutate};
use arbitrary::{Result, Unstructured};
use axis::Files;
use quantities::Language;
use questions::Progress;
use questions::sweep::csv::{Broken, Lines};
use questions::sweep::{Cells, Options, Sweep, TableFaults};
use std::borrow::Cow;
use std::io::Read;

const AXIS: &str = "format = 1\n[load]\ninertia = \"0.5 kg m^2\"\nfriction_torque = \"1 N m\"\n[[motion]]\n\
    law = \"modified_sine\"\ndistance = \"90 deg\"\ntime = \"0.8 s\"\n[requirements]\nsupply = \"560 V\"\n";

/// Headings that are keys of the project, and such as are none.
const HEADINGS: [&str; 10] = [
    "load.inertia",
    "load.inertia [kg m^2]",
    "load.friction_torque [N m]",
    "motion[1].time [s]",
    "motion[1].distance",
    "motion[0].time",
    "requirements.supply [V]",
    "code",
    "motion[1].law",
    "",
];

/// Rows that are read at once, and most that are judged.
const ROWS: usize = 12;

/// A table as a file.
pub fn run(data: &[u8]) {
    if let Ok(bytes) = made(&mut Unstructured::new(data)) {
        hold(&bytes);
    }
}

/// The file.
pub fn shown(data: &[u8]) -> String {
    made(&mut Unstructured::new(data)).map(|bytes| bytes.escape_ascii().to_string()).unwrap_or_default()
}

/// No file beside it.
struct Nothing;

impl Files for Nothing {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn Read>> {
        Err(std::io::ErrorKind::NotFound.into())
    }
}

/// Rows are read in parts as long as each other, and those of the first part have an answer each.
pub(crate) fn hold(bytes: &[u8]) {
    as_table(bytes.to_vec());
    let Ok(mut lines) = Lines::open(bytes) else { return };
    let headings: Vec<String> = lines.headings().to_vec();
    let options = Options { commas: lines.commas(), ..Options::default() };
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut sweep = Sweep::new(("axis.toml", AXIS), Box::new(Nothing), &headings, options)
        .map_err(|why| assert!(!why.faults(None, Language::En).errors.is_empty(), "a refusal has its reason"))
        .ok();
    loop {
        let columns = match lines.rows(ROWS) {
            Ok(Some(columns)) => columns,
            Ok(None) | Err(Broken::Unread(_)) => break,
            Err(fault @ Broken::Line(_)) => {
                assert!(!fault.text(Language::De).is_empty());
                continue;
            }
        };
        let rows = columns.first().map_or(0, Vec::len);
        assert!(columns.len() == headings.len() && columns.iter().all(|column| column.len() == rows), "rows are whole");
        assert!(rows <= ROWS, "{rows}");
        // One part is judged; the others are read.
        let Some(sweep) = sweep.take() else { continue };
        let texts =
            |column: Vec<Option<String>>| Cells::Texts(column.into_iter().map(|cell| cell.map(Cow::Owned)).collect());
        let cells: Vec<Cells<'_>> = columns.into_iter().map(texts).collect();
        let mut faults = TableFaults::default();
        sweep.check(&cells, 1, &mut faults);
        if faults.is_empty() && !cells.is_empty() {
            let answers = sweep.judge(&cells, &Progress::endless());
            assert!(answers.is_ok_and(|answers| answers.len() == rows), "an answer for each row");
        }
    }
}

/// A table under any headings, in any dialect; odd cells now and then.
pub(crate) fn made(u: &mut Unstructured<'_>) -> Result<Vec<u8>> {
    let count = u.int_in_range(0..=ROWS as u32)?;
    let width = u.int_in_range(1..=4_usize)?;
    let mut columns = Vec::new();
    for _ in 0..width {
        let name = *u.choose(&HEADINGS)?;
        let base = *u.choose(&[0.5, 2.0, 560.0, 0.0, -1.0, 1e12, 1e-9])?;
        let values = (0..count).map(|row| base * (1.0 + 0.1 * f64::from(row))).collect();
        columns.push(GeneratedColumn { name, unit: "", values });
    }
    let mut columns = Columns { columns };
    columns.spoil(u)?;
    Ok(match u.int_in_range(0..=7)? {
        0 | 1 => columns.parquet(u)?,
        2 => encoded(&columns.csv(u)?, u)?,
        3 | 4 => {
            let edits = any_edits(u, 6)?;
            mutate(&columns.csv(u)?, &edits).into_bytes()
        }
        5 => u.bytes(u.len())?.to_vec(),
        _ => columns.csv(u)?.into_bytes(),
    })
}
