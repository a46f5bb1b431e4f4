//! Headers of tools whose tables have no line of headings of their own: TwinCAT Scope lists the properties of each channel line by
//! line, LabVIEW writes one header for the file and one for the table.

use crate::cells::{delimiter, split};
use crate::clock::is_clock;
use crate::faults::{Fault, excerpt};
use crate::number::Decimals;
use quantities::Unit;
use std::ops::Range;

/// First line of a LabVIEW measurement file.
const LABVIEW: &[u8] = b"LabVIEW Measurement";
/// Line at the end of each of its two headers.
const HEADER_END: &[u8] = b"***End_of_Header***";

/// Headers seen at the beginning of a file.
#[derive(Debug, Default)]
pub(crate) struct Headers {
    /// Headers of LabVIEW that are still to end.
    labview: u8,
    is_scope: bool,
}

impl Headers {
    /// Records a line; returns `true` if the table begins behind it, or later.
    pub(crate) fn end_with(&mut self, line: &[u8], is_first: bool) -> bool {
        if is_first && line.trim_ascii_start().starts_with(LABVIEW) {
            self.labview = 2;
        }
        self.is_scope |= [b"SymbolComment".as_slice(), b"Data-Type", b"SymbolName"]
            .iter()
            .any(|property| line.strip_prefix(*property).is_some_and(|rest| rest.starts_with(&[delimiter(line)])));
        let ends = line.trim_ascii().starts_with(HEADER_END);
        if ends {
            self.labview = self.labview.saturating_sub(1);
        }
        ends
    }

    /// Returns `true` if the line of headings can be searched in the usual way.
    pub(crate) const fn are_over(&self) -> bool {
        self.labview == 0 && !self.is_scope
    }

    /// Returns the fault of a channel of a scope with a scale or an offset: an option of the export, which the file does not state, applies
    /// them to the values (Beckhoff Infosys, TE13xx, *Export in csv*, *Scale values before export*).
    pub(crate) fn scale(&self, seen: &[(u64, Vec<u8>)]) -> Option<Fault> {
        let rows = || seen.iter().filter(|_| self.is_scope).filter_map(|(_, line)| split(line, delimiter(line)));
        let of = |name: &str| rows().find(|cells| cells.first().is_some_and(|cell| cell.eq_ignore_ascii_case(name)));
        let (scales, offsets) = (of("ScaleFactor"), of("Offset"));
        let names = of("Name").or_else(|| of("SymbolName"));
        let number = |text: &str| text.replacen(',', ".", 1).parse::<f64>().ok();
        let places = scales.as_ref().or(offsets.as_ref())?.len();
        let at = |cells: &Option<Vec<String>>, place: usize| cells.as_ref().and_then(|cells| cells.get(place)).cloned();
        (0..places).find_map(|place| {
            let (scale, offset) = (at(&scales, place), at(&offsets, place));
            let is = |text: &Option<String>, neutral: f64| {
                text.as_deref().and_then(number).is_none_or(|value| (value - neutral).abs() < f64::EPSILON)
            };
            (!is(&scale, 1.0) || !is(&offset, 0.0)).then(|| Fault::ScaleUnknown {
                column: excerpt(&at(&names, place).unwrap_or_default()),
                scale: [
                    excerpt(&scale.unwrap_or_else(|| "1".to_owned())),
                    excerpt(&offset.unwrap_or_else(|| "0".to_owned())),
                ],
            })
        })
    }

    /// Returns the headings made from the properties of the channels of a scope: index of the first row, number of the line of the
    /// names, headings and delimiter.
    pub(crate) fn scope(&self, seen: &[(u64, Vec<u8>)]) -> Option<(usize, u64, Vec<u8>, u8)> {
        let (last, (_, row)) = seen.iter().enumerate().next_back().filter(|_| self.is_scope)?;
        let sign = delimiter(row);
        let is_value = |cell: &String| Decimals::is_number(cell) || is_clock(cell);
        let row = split(row, sign)?;
        if row.len() < 2 || !row.iter().all(is_value) {
            return None;
        }
        let properties: Vec<(u64, Vec<String>)> = seen
            .iter()
            .filter_map(|(number, line)| Some((*number, split(line, sign)?)))
            .filter(|(_, cells)| cells.len() == row.len())
            .collect();
        let of = |name: &str| properties.iter().rev().find(|(_, cells)| cells.first().is_some_and(|cell| cell == name));
        // The name of a property stands above each column of time: one beside each channel, or one for all channels of a sampling.
        let times = |cells: &[String]| -> Vec<usize> {
            let first = cells.first();
            cells.iter().enumerate().filter(|(_, cell)| Some(*cell) == first).map(|(place, _)| place).collect()
        };
        let (number, names) = of("Name")?;
        let of_time = times(names);
        let units = of("Unit").map(|(_, cells)| cells.as_slice()).unwrap_or_default();
        if !units.is_empty() && times(units) != of_time {
            return None;
        }
        let time = match (row.first().is_some_and(|cell| is_file_time(cell)), of("SampleTime[ms]")) {
            (true, _) => "Time [FILETIME]",
            (false, Some(_)) => "Time [ms]",
            (false, None) => "Time",
        };
        let mut headings = Vec::new();
        for (place, name) in names.iter().enumerate() {
            if of_time.contains(&place) {
                headings.push(time.to_owned());
                continue;
            }
            // `° (Angle)`, or `(None)`.
            let unit =
                units.get(place).and_then(|unit| unit.split(" (").next()).filter(|unit| Unit::of(unit).is_some());
            headings.push(unit.map_or_else(|| name.clone(), |unit| format!("{name} [{unit}]")));
        }
        let separator = char::from(sign).to_string();
        Some((last, *number, headings.join(&separator).into_bytes(), sign))
    }
}

/// Returns `true` if a cell is a time of Windows in the years 1970 to 2099: hundreds of nanoseconds since 1601-01-01.
fn is_file_time(cell: &str) -> bool {
    const YEARS: Range<i64> = 116_444_736_000_000_000..157_469_184_000_000_000;
    cell.parse().is_ok_and(|time| YEARS.contains(&time))
}
