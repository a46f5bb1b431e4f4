//! Recorded runs, as they are identified: columns in CSV of any dialect and in Parquet; estimates or faults.

use crate::recorded::{Columns, GeneratedColumn, edit_bytes, encoded};
use crate::text::{any_edits, mutate};
use arbitrary::{Result, Unstructured};
use axis::Files;
use quantities::Language;
use questions::Progress;
use questions::list::{Given, Inquiry, ReferencedText, identify};
use std::borrow::Cow;
use std::io::Read;

const AXIS: &str = "format = 1\n[mechanism.arm]\ninertia = \"2 kg m^2\"\nmass = \"5 kg\"\ncentre_distance = \"200 mm\"\n\
    axis_tilt = \"90 deg\"\nstart_angle = \"20 deg\"\nfriction_torque = \"1.5 N m\"\n[[motion]]\nlaw = \"modified_sine\"\n\
    distance = \"90 deg\"\ntime = \"0.9 s\"\n[[motion]]\nlaw = \"modified_sine\"\ndistance = \"-90 deg\"\ntime = \"0.7 s\"\n\
    [requirements]\nsupply = \"560 V\"\n";

/// A run as a file.
pub fn run(data: &[u8]) {
    if let Ok(bytes) = made(&mut Unstructured::new(data)) {
        hold(&bytes);
    }
}

/// The file.
pub fn shown(data: &[u8]) -> String {
    made(&mut Unstructured::new(data)).map(|bytes| bytes.escape_ascii().to_string()).unwrap_or_default()
}

/// The one file that there is.
struct Only<'t>(&'t [u8]);

impl Files for Only<'_> {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(std::io::Cursor::new(self.0.to_vec())))
    }
}

/// Checks that each identified value is a number with a width and that a refusal has its reasons.
pub(crate) fn hold(bytes: &[u8]) {
    let (progress, files) = (Progress::endless(), Only(bytes));
    let pairs = [("code", "CHA-25A-50-H-C1024"), ("trace", "run.csv")];
    let pairs = pairs.into_iter().map(|(name, value)| (Cow::Borrowed(name), Cow::Borrowed(value)));
    let given = Given::of(identify::Args::ARGUMENTS, pairs, Language::En);
    assert!(given.is_ok(), "the arguments are right");
    let Ok(given) = given else { return };
    let inquiry = Inquiry {
        given,
        sources: vec![ReferencedText {
            name: "axis.toml".to_owned(),
            bytes: Cow::Borrowed(AXIS.as_bytes()),
            files: &files,
        }],
        catalogue: questions::embedded_catalogue(),
        days_since_1970: None,
        progress: &progress,
        refuses_long: true,
        by_axes: false,
        language: Language::En,
    };
    match identify::found(&inquiry) {
        Ok(found) => {
            assert!(found.samples > 0, "{found:?}");
            for each in &found.estimates {
                let (value, half) = (each.value.written(), each.half_width.written());
                assert!(value.is_some_and(f64::is_finite) && half.is_some_and(|half| half >= 0.0), "{each:?}");
            }
            assert!(found.doubts.is_empty() || found.overrides.is_empty(), "{found:?}");
        }
        Err(why) => {
            let faults = why.faults(None, Language::En).errors;
            assert!(!faults.is_empty() && faults.iter().all(|fault| !fault.message.is_empty()), "{faults:?}");
        }
    }
}

/// A run to and fro with what it takes, in any format; odd cells now and then.
pub(crate) fn made(u: &mut Unstructured<'_>) -> Result<Vec<u8>> {
    let count = u.int_in_range(2..=400_u32)?;
    let step = *u.choose(&[1e-3, 4e-3, 0.0, 1e-2])?;
    let reach = *u.choose(&[1.57, 0.02, 0.0, 30.0])?;
    let side = *u.choose(&[1.0, 1.0, -1.0, 50.0])?;
    let last = f64::from(count - 1) * step;
    let turn = std::f64::consts::TAU * f64::from(u.int_in_range(1..=3_u8)?) / last.max(1e-3);
    let column = |name: &'static str, of: &dyn Fn(f64) -> f64| {
        let noise = |k: u32| f64::from(k.wrapping_mul(2_654_435_761) >> 16) * 1e-9;
        let values =
            (0..count).map(|k| of(f64::from(k) * step) + if name == "time_s" { 0.0 } else { noise(k) }).collect();
        GeneratedColumn { name, unit: "", values }
    };
    let position = |t: f64| 0.5 * reach * (1.0 - (turn * t).cos());
    let speed = |t: f64| 0.5 * reach * turn * (turn * t).sin();
    let torque =
        |t: f64| 0.5 * reach * turn * turn * (turn * t).cos() * 2.2 + 1.5 * speed(t).signum() + 9.8 * position(t).sin();
    let mut columns = vec![
        column("time_s", &|t| t),
        column("position_rad", &position),
        column("speed_rad_s", &speed),
        column("motor_speed_rad_s", &|t| speed(t) * side),
        column("torque_nm", &torque),
        column("current_q_a", &|t| torque(t) / 9.0),
    ];
    if u.ratio(1, 4)? {
        let _ = columns.remove(u.choose_index(columns.len())?);
    }
    let mut columns = Columns { columns };
    columns.spoil(u)?;
    Ok(match u.int_in_range(0..=7)? {
        0 | 1 => columns.parquet(u)?,
        2 => edit_bytes(columns.parquet(u)?, &any_edits(u, 6)?),
        3 => {
            let edits = any_edits(u, 6)?;
            mutate(&columns.csv(u)?, &edits).into_bytes()
        }
        4 => encoded(&columns.csv(u)?, u)?,
        5 => u.bytes(u.len())?.to_vec(),
        _ => columns.csv(u)?.into_bytes(),
    })
}
