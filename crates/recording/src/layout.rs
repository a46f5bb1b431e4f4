//! What the user says about a file, and the roles of its columns.

use quantities::{Dimension, Time, Unit};

/// What the user says about the columns; everything is optional.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// The column of time.
    pub time: ColumnSpec,
    /// The column of position, an angle or a length.
    pub position: ColumnSpec,
    /// The column of speed, rotational or along a line.
    pub speed: ColumnSpec,
    /// The column of torque or force.
    pub torque: ColumnSpec,
    /// Samples before are left out; in the time of the file.
    pub from: Option<Time>,
    /// Samples after are left out; in the time of the file.
    pub to: Option<Time>,
    /// Whether an interval longer than [`GAP_FACTOR`](crate::GAP_FACTOR) median intervals is accepted.
    pub allow_gaps: bool,
}

impl Layout {
    /// What is said about the column of a role.
    #[must_use]
    pub const fn column(&self, role: Role) -> &ColumnSpec {
        match role {
            Role::Time => &self.time,
            Role::Position => &self.position,
            Role::Speed => &self.speed,
            Role::Torque => &self.torque,
        }
    }
}

/// What the user says about one column.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ColumnSpec {
    /// Its name, with or without the unit that stands behind it, or its number, `#3`; otherwise it is recognised by the usual names.
    pub name: Option<String>,
    /// Its unit, if the file does not say it.
    pub unit: Option<&'static Unit>,
    /// No column has this role, whatever the names say: `m` may be a mode and no moment.
    pub unused: bool,
}

/// What a column is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// Time of the sample.
    Time,
    /// Position, an angle or a length.
    Position,
    /// Speed, rotational or along a line.
    Speed,
    /// Torque or force.
    Torque,
}

impl Role {
    /// Every role, in the order of the output.
    pub const ALL: [Self; 4] = [Self::Time, Self::Position, Self::Speed, Self::Torque];

    /// Names by which a column is recognised, in lower case.
    #[must_use]
    pub const fn names(self) -> &'static [&'static str] {
        match self {
            Self::Time => &["time", "t", "zeit", "timestamp"],
            Self::Position => &[
                "position",
                "pos",
                "angle",
                "q",
                "phi",
                "winkel",
                "lage",
                "stellung",
                "weg",
                "x",
                "angularposition",
                "linearposition",
            ],
            Self::Speed => &[
                "speed",
                "velocity",
                "vel",
                "n",
                "v",
                "omega",
                "qd",
                "dq",
                "drehzahl",
                "geschwindigkeit",
                "velo",
                "angularvelocity",
                "linearvelocity",
                "angularspeed",
            ],
            Self::Torque => {
                &["torque", "tau", "m", "moment", "drehmoment", "force", "f", "kraft", "effort", "loadtorque"]
            }
        }
    }

    /// What its unit may measure: turning first, then along a line.
    #[must_use]
    pub const fn dimensions(self) -> &'static [Dimension] {
        match self {
            Self::Time => &[Dimension::Time],
            Self::Position => &[Dimension::Angle, Dimension::Length],
            Self::Speed => &[Dimension::AngularVelocity, Dimension::Velocity],
            Self::Torque => &[Dimension::Torque, Dimension::Force],
        }
    }
}
