//! Keys of the recordings that a project file refers to.

use crate::about::About;
use crate::section::section;
use crate::value::choices;

/// Permission of gaps between the samples of a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gaps {
    /// They are read over.
    Allow,
}

/// Use of recorded values that are held over several rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HeldValues {
    /// Values in between are interpolated.
    Interpolate,
}

/// Use of the time stamps of a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeStamps {
    /// Rows follow each other at even intervals.
    Even,
}

choices! {
    Gaps { Allow = "allow" }
    HeldValues { Interpolate = "interpolate" }
    TimeStamps { Even = "even" }
}

section! {
    /// Names of the columns of a recording; `none` where a name must not be taken for a role.
    Columns, ColumnsName of About::Columns {
        time: String;
        position: String;
        speed: String;
        torque: String;
    }
}

section! {
    /// Units of the columns of a recording.
    Units, UnitsName of About::Units {
        time: String => example("ms");
        position: String => example("deg");
        speed: String => example("1/min");
        torque: String => example("N m");
    }
}

section! {
    /// Ratios between the shaft at which a quantity is recorded and the output: 1 at the output, negative where it turns
    /// the other way. A position in counts has so many of them for each revolution of the output.
    Ratios, RatiosName of About::Ratios {
        position: f64 => within(-1e10, 1e10), example("80");
        speed: f64 => within(-1e10, 1e10), example("80");
        torque: f64 => within(-1e4, 1e4), example("80");
    }
}
