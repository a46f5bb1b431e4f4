//! Faults of the axes of a recording.

use quantities::unit::SECOND;
use quantities::{Angle, Measure};
use recording::{Fault, FileRow, Role, Stamp};

/// Returns a fault of each kind.
pub(super) fn of_axes() -> Vec<Fault> {
    let undecided = |count| Fault::StepUndecided {
        at: FileRow::Line(3),
        time: Stamp { value: 0.25, unit: &SECOND },
        step: Angle::from_si(3.2),
        count,
    };
    let columns = vec![(Role::Position, "axis1.pos".to_owned()), (Role::Torque, "axis2.tau".to_owned())];
    let scale = ["0.01".to_owned(), "0".to_owned()];
    vec![
        undecided(1),
        undecided(7),
        Fault::SeveralAxes { columns },
        Fault::ScaleUnknown { column: "ActPos".to_owned(), scale },
    ]
}
