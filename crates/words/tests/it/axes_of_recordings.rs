//! Faults of the axes of a recording.

use crate::marks::x;
use quantities::unit::SECOND;
use quantities::{Angle, Measure};
use recording::{Along, Fault, FileRow, Role, Stamp};

/// Returns a fault of each kind.
pub(super) fn of_axes() -> Vec<Fault> {
    let undecided = |count| Fault::StepUndecided {
        at: FileRow::Line(3),
        time: Stamp { value: 0.25, unit: &SECOND },
        step: Angle::from_si(x(3.2)),
        count,
    };
    let jump = |along, has_speed| {
        let (at, count) = (FileRow::Row(3), if has_speed { 1 } else { 2 });
        Fault::PositionJumps { at, column: "name".to_owned(), size: x(12.5), along, has_speed, count }
    };
    let columns = vec![(Role::Position, "axis1.pos".to_owned()), (Role::Torque, "axis2.tau".to_owned())];
    let scale = ["0.01".to_owned(), "0".to_owned()];
    vec![
        undecided(1),
        undecided(7),
        jump(Along::Turning, true),
        jump(Along::Line, false),
        Fault::SeveralAxes { columns },
        Fault::ScaleUnknown { column: "ActPos".to_owned(), scale },
    ]
}
