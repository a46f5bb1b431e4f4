//! Recordings as CSV and Parquet: any file gives a recording or faults, and a recording can be judged.

mod columns;
mod table;

use crate::PAST_THE_GATE;
use crate::project::read;
use crate::text::{any_edits, mutate, one_in, rest};
use arbitrary::{Result, Unstructured};
pub(crate) use columns::{Columns, GeneratedColumn, edit_bytes};
pub(crate) use table::encoded;

use axis::AxisDiagnostic;
use axis::{AxisProject, Files};
use questions::{answer, check, course, moves};
use recording::{Bytes, Damage, Fault as RecordingFault, Memory, Table, TableValues};
use std::io::Read;
use std::sync::atomic::Ordering;

const LOAD: &str = "[load]\ninertia = \"0.5 kg m^2\"\nfriction_torque = \"1 N m\"\n";
const ARM: &str = "[mechanism.arm]\ninertia = \"0.5 kg m^2\"\nmass = \"6 kg\"\ncentre_distance = \"0.3 m\"\n\
                   axis_tilt = \"90 deg\"\nstart_angle = \"20 deg\"\nefficiency = 0.9\n";
const JOINT: &str = "[mechanism.joint]\ninertia = \"1 kg m^2\"\n";
const SCREW: &str = "[mechanism.screw]\nlead = \"10 mm\"\nmass = \"8 kg\"\n";

/// Additional keys of a segment with a recording.
const SAID: [&str; 10] = [
    "",
    "standstill = \"0.01 1/min\"\n",
    "smoothing = \"0.05 s\"\n",
    "gaps = \"allow\"\n",
    "from = \"0.1 s\"\nto = \"0.6 s\"\n",
    "[motion.units]\ntime = \"ms\"\n",
    "[motion.units]\nposition = \"rad\"\nspeed = \"rad/s\"\n",
    "[motion.columns]\nposition = \"q\"\n",
    "[motion.columns]\ntime = \"t\"\nspeed = \"none\"\n",
    "smoothing = \"3 s\"\nstandstill = \"1 rad/s\"\ngaps = \"allow\"\n",
];

/// File access that has a single file.
struct Only<'t>(&'t [u8]);

impl Files for Only<'_> {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(std::io::Cursor::new(self.0.to_vec())))
    }
}

/// Tests CSV as written by loggers, in some cases with edits; or any bytes.
pub fn csv(data: &[u8]) {
    if let Ok((project, bytes)) = made_csv(&mut Unstructured::new(data)) {
        hold(&project, &bytes, |_| false);
    }
}

/// Tests Parquet as written by the library, in some cases with changed bytes; or any bytes.
pub fn parquet(data: &[u8]) {
    if let Ok((project, bytes)) = made_parquet(&mut Unstructured::new(data)) {
        hold(&project, &bytes, is_past_the_footer);
        by_name(bytes.clone());
        as_table(bytes);
    }
}

/// Tests a table of many axes: rows or a refusal, and each part has the same number of rows in all columns.
pub(crate) fn as_table(bytes: Vec<u8>) {
    const ROWS: usize = 1000;
    const PARTS_MOST: usize = 20;
    let Ok(mut table) = Table::open(Box::new(Bytes::from(bytes)), Memory::default()) else { return };
    let columns = table.columns().len();
    for _ in 0..PARTS_MOST {
        let Ok(Some(part)) = table.next(ROWS) else { return };
        assert_eq!(part.len(), columns, "a column for each heading");
        let lengths: Vec<usize> = part.iter().map(length).collect();
        assert!(lengths.iter().all(|length| (1..=ROWS).contains(length) && Some(length) == lengths.first()));
    }
    let _ = table.skip(1 << 20);
}

fn length(values: &TableValues) -> usize {
    match values {
        TableValues::Floats(values) => values.len(),
        TableValues::Integers(values) => values.len(),
        TableValues::Unsigned(values) => values.len(),
        TableValues::Texts(values) => values.len(),
        TableValues::Truths(values) => values.len(),
        TableValues::Other(count) => *count,
    }
}

/// Tests columns read by name, as for the identification of a recorded run: all of the same length and finite, or
/// faults.
fn by_name(bytes: Vec<u8>) {
    const NAMES: [&str; 9] =
        ["time", "t", "Zeit", "timestamp", "position [deg]", "q [rad]", "speed [rad/s]", "torque [Nm]", "note"];
    let memory = &mut Memory::default();
    match recording::read_columns(&Bytes::from(bytes), &NAMES, memory) {
        Ok(columns) => {
            assert_eq!(columns.len(), NAMES.len());
            let there: Vec<_> = columns.iter().flatten().collect();
            assert!(there.iter().zip(there.iter().skip(1)).all(|(a, b)| a.len() == b.len()), "columns of one length");
            assert!(there.iter().all(|values| values.iter().all(|value| value.is_finite())), "finite numbers");
            let bytes: usize = there.iter().map(|values| 8 * values.len()).sum();
            assert!(recording::MEMORY_USUAL - memory.left() >= bytes as u64, "memory is counted before it is taken");
        }
        Err(faults) => assert!(!faults.is_empty(), "a refusal has its reason"),
    }
}

/// Returns the project and the file of a CSV case.
pub fn shown_csv(data: &[u8]) -> String {
    made_csv(&mut Unstructured::new(data))
        .map(|(project, bytes)| format!("{project}---\n{}", String::from_utf8_lossy(&bytes)))
        .unwrap_or_default()
}

/// Returns the project and the bytes of a Parquet case.
pub fn shown_parquet(data: &[u8]) -> String {
    made_parquet(&mut Unstructured::new(data))
        .map(|(project, bytes)| format!("{project}---\n{}", bytes.escape_ascii()))
        .unwrap_or_default()
}

/// A recording with a project that names it, in a file of its own or to be packed.
pub(crate) fn made(u: &mut Unstructured<'_>, name: &str) -> Result<(String, Vec<u8>)> {
    let project = project(u, name)?;
    let columns = Columns::any(u)?;
    let bytes = if u.ratio(1, 4)? { columns.parquet(u)? } else { columns.csv(u)?.into_bytes() };
    Ok((project, bytes))
}

/// A recording in any packing: what is read is judged.
pub(crate) fn hold_recording(project: &str, bytes: &[u8]) {
    hold(project, bytes, |_| false);
}

fn made_csv(u: &mut Unstructured<'_>) -> Result<(String, Vec<u8>)> {
    let project = project(u, "run.csv")?;
    let bytes = match u.int_in_range(0..=9)? {
        0 => rest(u).into_bytes(),
        1..=3 => {
            let edits = any_edits(u, 5)?;
            let text = Columns::any(u)?.csv(u)?;
            mutate(&text, &edits).into_bytes()
        }
        4 => {
            let text = Columns::any(u)?.csv(u)?;
            table::encoded(&text, u)?
        }
        _ => Columns::any(u)?.csv(u)?.into_bytes(),
    };
    Ok((project, bytes))
}

fn made_parquet(u: &mut Unstructured<'_>) -> Result<(String, Vec<u8>)> {
    let project = project(u, "run.parquet")?;
    let bytes = match u.int_in_range(0..=9)? {
        // The bytes are the file: the engine's changes lie between the magic bytes at both ends.
        0 => u.bytes(u.len())?.to_vec(),
        // The bytes are the footer of a file without columns.
        1 => table::with_footer(u.bytes(u.len())?),
        2..=5 => {
            let edits: Vec<(u16, u8)> = any_edits(u, 6)?;
            let bytes = Columns::any(u)?.parquet(u)?;
            edit_bytes(bytes, &edits)
        }
        _ => Columns::any(u)?.parquet(u)?,
    };
    Ok((project, bytes))
}

fn project(u: &mut Unstructured<'_>, file: &str) -> Result<String> {
    let load = u.choose(&[LOAD, ARM, JOINT, SCREW])?;
    let said = if u.ratio(1, 2)? { *u.choose(&SAID)? } else { "" };
    Ok(format!(
        "format = 1\n[axis]\nsingle_move = true\n{load}[[motion]]\nlaw = \"recorded\"\nfile = \"{file}\"\n{said}\
         [requirements]\nsupply = \"560 V\"\n"
    ))
}

/// Returns `true` if the faults of a file were found after its footer, or there are none.
fn is_past_the_footer(faults: &[AxisDiagnostic]) -> bool {
    let at_the_footer = |fault: &RecordingFault| match fault {
        RecordingFault::ParquetUnreadable { reason } => {
            matches!(reason, Damage::NoParquet | Damage::Encrypted | Damage::Footer)
        }
        RecordingFault::Beyond { .. } => true,
        _ => false,
    };
    faults.iter().all(|fault| match &fault.fault {
        axis::AxisFault::Recording { fault, .. } => !at_the_footer(fault),
        axis::AxisFault::Recorded { .. } => true,
        _ => false,
    })
}

/// Checks that a recording can be shown and judged, in half of the cases; one actuator is enough, the target `axis`
/// covers the others. Counts the cases for which `past` reports that they passed the gate.
fn hold(text: &str, file: &[u8], past: fn(&[AxisDiagnostic]) -> bool) {
    let read_it = || {
        let read = questions::read_all(text, &Only(file));
        // CSV has no gate, so its cases are not counted.
        if past(read.as_ref().err().map_or(&[], Vec::as_slice)) {
            PAST_THE_GATE.fetch_add(1, Ordering::Relaxed);
        }
        read
    };
    let Some(projects) = read(text, read_it) else { return };
    if one_in(2, file) {
        projects.iter().for_each(words_all);
    }
}

fn words_all(project: &AxisProject) {
    for language in [quantities::Language::En, quantities::Language::De] {
        let _ = answer::motion(&moves(project), None, language);
    }
    let Ok(parsed) = order_code::parse("CHA-25A-100-H-C1024") else { return };
    let Ok(candidate) = check(project, &parsed.code) else { return };
    crate::axis::verdict::candidate(&candidate);
    let samples = course(project, &candidate);
    drop(samples);
}
