//! Layout of a recording as a segment states it: columns, units and window.

use crate::fault::{AxisFault, AxisReport};
use project::sections::{Gaps, Section, Segment, Stated, StatedField, TimeStamps};
use project::{Fault, Hint, shortened};
use quantities::Unit;
use recording::{ColumnSpec, Layout, Role};

/// Longest excerpt of a unit in a fault, in characters.
const UNIT_SHOWN: usize = 40;

/// Word in `columns` for a role that no column has.
const NO_COLUMN: &str = "none";

/// Returns the layout that a segment states; reports units that are not known.
pub(crate) fn layout(segment: &Segment, report: &mut AxisReport<'_>) -> Layout {
    let (columns, units) = (segment.columns.get(), segment.units.get());
    let mut column = |name: Option<&Stated<String>>, unit: Option<&Stated<String>>, role: Role| {
        let name = name.and_then(Stated::get);
        let unit = unit.and_then(|stated| {
            let written = stated.get()?;
            let found = role.dimensions().iter().find_map(|dimension| Unit::of_dimension(*dimension, written));
            if found.is_none() {
                let units = role.dimensions().iter().flat_map(|dimension| dimension.units());
                let known: Vec<&str> = units.map(|unit| unit.ascii).collect();
                let fault = Fault::UnknownUnit { written: shortened(written, UNIT_SHOWN) };
                report.fault(stated.span(), fault, Some(Hint::valid(&known)));
            }
            found
        });
        ColumnSpec {
            name: name.filter(|name| *name != NO_COLUMN).cloned(),
            unit,
            unused: name.is_some_and(|name| name == NO_COLUMN),
        }
    };
    let time = column(columns.map(|all| &all.time), units.map(|all| &all.time), Role::Time);
    let position = column(columns.map(|all| &all.position), units.map(|all| &all.position), Role::Position);
    let speed = column(columns.map(|all| &all.speed), units.map(|all| &all.speed), Role::Speed);
    let torque = column(columns.map(|all| &all.torque), units.map(|all| &all.torque), Role::Torque);
    let (from, to) = (segment.from.value(), segment.to.value());
    let allow_gaps = segment.gaps.value() == Some(Gaps::Allow);
    let even_stamps = segment.time_stamps.value() == Some(TimeStamps::Even);
    Layout { time, position, speed, torque, from, to, allow_gaps, even_stamps }
}

/// Returns `true` if no value of the layout of a recording was refused.
pub(crate) fn has_layout(segment: &Segment) -> bool {
    let window: [&dyn StatedField; 4] = [&segment.from, &segment.to, &segment.gaps, &segment.time_stamps];
    let tables: [&dyn StatedField; 2] = [&segment.columns, &segment.units];
    let is_whole = |field: &dyn StatedField| field.is_given() || !field.is_written();
    window.into_iter().chain(tables).all(is_whole)
        && segment.columns.get().is_none_or(Section::is_whole)
        && segment.units.get().is_none_or(Section::is_whole)
}

/// Returns `true` if another layout may read the file without the fault.
pub(crate) fn depends_on_layout(fault: &AxisFault) -> bool {
    use recording::Fault as Of;
    match fault {
        AxisFault::Recording { fault, .. } => !matches!(
            fault,
            Of::ReadFailed { .. }
                | Of::NoHeader
                | Of::LineTooLong { .. }
                | Of::QuoteOpen { .. }
                | Of::Ragged { .. }
                | Of::CommasTwice { .. }
                | Of::ColumnUnknown { .. }
                | Of::NoTable
                | Of::SpacesOnly
                | Of::NotText
                | Of::HeadingMissing { .. }
                | Of::Foreign { .. }
                | Of::Stopped
                | Of::WindowReversed { .. }
                | Of::Beyond { .. }
                | Of::ParquetUnreadable { .. }
        ),
        _ => false,
    }
}
