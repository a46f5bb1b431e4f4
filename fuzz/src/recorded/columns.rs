//! A recorded motion and its representation in a file.

use arbitrary::{Result, Unstructured};

/// Samples of a motion that begins and ends at rest: (1 − cos) back and forth, with a torque.
pub(crate) struct Columns {
    /// Columns with their values, time first.
    pub(crate) columns: Vec<GeneratedColumn>,
}

pub(crate) struct GeneratedColumn {
    pub(crate) name: &'static str,
    pub(crate) unit: &'static str,
    pub(crate) values: Vec<f64>,
}

impl Columns {
    /// Generates any selection of columns with any number of samples.
    pub(crate) fn any(u: &mut Unstructured<'_>) -> Result<Self> {
        let count = u.int_in_range(2..=120_u16)?;
        let duration = *u.choose(&[1.0, 0.1, 4.0, 60.0])?;
        let reach = *u.choose(&[1.0, 0.05, 6.0, 0.0])?;
        let times: Vec<f64> = (0..count).map(|index| f64::from(index) / f64::from(count - 1)).collect();
        let turn = std::f64::consts::TAU;
        let position: Vec<f64> = times.iter().map(|t| 0.5 * reach * (1.0 - (turn * t).cos())).collect();
        let speed: Vec<f64> = times.iter().map(|t| 0.5 * reach * turn / duration * (turn * t).sin()).collect();
        let torque: Vec<f64> = times.iter().map(|t| 8.0 * (turn * t).cos() + 1.0).collect();
        let (time_unit, time_factor) = *u.choose(&[("s", 1.0), ("ms", 1e3), ("us", 1e6), ("ns", 1e9)])?;
        let scaled = |values: &[f64], factor: f64| values.iter().map(|value| value * factor).collect::<Vec<f64>>();
        let time = times.iter().map(|t| t * duration * time_factor).collect();
        let mut columns = vec![GeneratedColumn {
            name: u.choose(&["time", "t", "Zeit", "timestamp"])?,
            unit: time_unit,
            values: time,
        }];
        if u.ratio(4, 5)? {
            let (unit, factor) =
                *u.choose(&[("deg", 57.295_779_513), ("rad", 1.0), ("mm", 1e3), ("rev", 0.159_154_943)])?;
            let name = *u.choose(&["position", "q", "Winkel", "angle"])?;
            columns.push(GeneratedColumn { name, unit, values: scaled(&position, factor) });
        }
        if u.ratio(1, 2)? {
            let (unit, factor) = *u.choose(&[("1/min", 9.549_296_586), ("rad/s", 1.0), ("m/s", 1.0)])?;
            columns.push(GeneratedColumn {
                name: u.choose(&["speed", "n", "Drehzahl"])?,
                unit,
                values: scaled(&speed, factor),
            });
        }
        if u.ratio(1, 2)? {
            let (unit, factor) = *u.choose(&[("Nm", 1.0), ("N m", 1.0), ("N", 1.0)])?;
            columns.push(GeneratedColumn {
                name: u.choose(&["torque", "M", "Moment"])?,
                unit,
                values: scaled(&torque, factor),
            });
        }
        if u.ratio(1, 4)? {
            columns.push(GeneratedColumn { name: "note", unit: "", values: times });
        }
        let mut found = Self { columns };
        found.spoil(u)?;
        Ok(found)
    }

    /// Makes one sample irregular in a quarter of the cases: missing, doubled, out of range, out of order.
    pub(crate) fn spoil(&mut self, u: &mut Unstructured<'_>) -> Result<()> {
        let count = self.columns.first().map_or(0, |column| column.values.len());
        if count > 0 && u.ratio(1, 4)? {
            let odd = *u.choose(&[f64::NAN, f64::INFINITY, 1e300, -1e9, 0.0, 1e-300])?;
            let (column, row) = (u.choose_index(self.columns.len())?, u.choose_index(count)?);
            let slot = self.columns.get_mut(column).and_then(|column| column.values.get_mut(row));
            slot.into_iter().for_each(|slot| *slot = odd);
        }
        Ok(())
    }

    /// Writes CSV with any separator, decimal sign, place of the units, quotes and line ending.
    pub(crate) fn csv(&self, u: &mut Unstructured<'_>) -> Result<String> {
        let (separator, decimal) = *u.choose(&[(",", '.'), (";", ','), ("\t", '.'), ("\t", ','), (";", '.')])?;
        let end = *u.choose(&["\n", "\r\n"])?;
        let quoted = u.ratio(1, 8)?;
        let digits = u.int_in_range(0..=12_u8)?;
        let mut text =
            String::from(*u.choose(&["", "", "", "\u{feff}", "# logger\n", "# logger 3\n# rate 1 kHz\n"])?);
        let cell = |text: String| if quoted { format!("\"{text}\"") } else { text };
        let place = u.int_in_range(0..=3)?;
        let join = |cells: Vec<String>| cells.join(separator) + end;
        let titled = self.columns.iter().map(|column| match (place, column.unit) {
            (_, "") | (1 | 3, _) => column.name.to_owned(),
            (2, unit) => format!("{} ({unit})", column.name),
            (_, unit) => format!("{} [{unit}]", column.name),
        });
        text.push_str(&join(titled.map(cell).collect()));
        if place == 1 {
            text.push_str(&join(self.columns.iter().map(|column| cell(column.unit.to_owned())).collect()));
        }
        let rows = self.columns.iter().map(|column| column.values.len()).min().unwrap_or(0);
        for row in 0..rows {
            let number = |column: &GeneratedColumn| {
                let value = column.values.get(row).copied().unwrap_or_default();
                let text =
                    if digits > 9 { format!("{value:e}") } else { format!("{value:.*}", usize::from(digits) + 3) };
                cell(text.replace('.', &decimal.to_string()))
            };
            text.push_str(&join(self.columns.iter().map(number).collect()));
        }
        Ok(text)
    }
}

/// Changes bytes between the magic bytes at both ends: each edit is a place and an operation.
///
/// A place is counted from the end, where the footer is, in half of the edits.
pub(crate) fn edit_bytes(mut bytes: Vec<u8>, edits: &[(u16, u8)]) -> Vec<u8> {
    for (place, choice) in edits {
        let room = bytes.len().saturating_sub(8).max(1);
        let place = usize::from(*place);
        let at = if choice % 2 == 0 { 4 + place % room } else { bytes.len().saturating_sub(9 + place % room.min(600)) };
        match choice / 2 % 6 {
            0 if at < bytes.len() => {
                bytes.remove(at);
            }
            1 => bytes.insert(at.min(bytes.len()), *choice),
            2 => bytes.get_mut(at).into_iter().for_each(|byte| *byte = byte.wrapping_add(1)),
            3 => bytes.get_mut(at).into_iter().for_each(|byte| *byte ^= 1 << (choice / 16 % 8)),
            4 => bytes.get_mut(at).into_iter().for_each(|byte| *byte = 0xFF),
            _ => bytes.get_mut(at).into_iter().for_each(|byte| *byte = 0),
        }
    }
    bytes
}
