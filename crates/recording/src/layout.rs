//! Statements of the user about a file, and the roles of its columns.

use quantities::{Dimension, Time, Unit};

/// Statements of the user about the columns, all optional.
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
    /// Start of the window, in the time of the file; earlier samples are left out.
    pub from: Option<Time>,
    /// End of the window, in the time of the file; later samples are left out.
    pub to: Option<Time>,
    /// Accepts an interval longer than [`GAP_FACTOR`](crate::GAP_FACTOR) median intervals.
    pub allow_gaps: bool,
    /// Accepts equal times, since evenly spaced ones replace them.
    pub even_stamps: bool,
}

impl Layout {
    /// Returns the statements about the column of a role.
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

impl Layout {
    /// Returns the indices of the columns if all are named by their numbers, with the time and a course among them; empty
    /// otherwise.
    pub(crate) fn numbered(&self) -> Vec<usize> {
        let named = || Role::ALL.into_iter().map(|role| (role, self.column(role))).filter(|(_, column)| !column.unused);
        let index = |name: &String| name.trim().strip_prefix('#')?.parse::<usize>().ok()?.checked_sub(1);
        let is_named = |role: Role| named().any(|(of, column)| of == role && column.name.is_some());
        let indices: Option<Vec<usize>> = named().filter_map(|(_, column)| column.name.as_ref()).map(index).collect();
        let is_whole = is_named(Role::Time) && (is_named(Role::Position) || is_named(Role::Speed));
        indices.filter(|_| is_whole).unwrap_or_default()
    }
}

/// Statements of the user about one column.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ColumnSpec {
    /// Name, with or without the unit that follows it, or number, `#3`; `None` searches the usual names.
    pub name: Option<String>,
    /// Unit, if the file does not state it.
    pub unit: Option<&'static Unit>,
    /// No column has this role, even if a name suggests it: `m` may be a mode instead of a moment.
    pub unused: bool,
}

/// Role of a column.
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
    /// The roles in the order of the output.
    pub const ALL: [Self; 4] = [Self::Time, Self::Position, Self::Speed, Self::Torque];

    /// Returns the names by which a column is recognised, in lower case.
    #[must_use]
    pub const fn names(self) -> &'static [&'static str] {
        match self {
            Self::Time => &["time", "t", "zeit", "timestamp", "zeitstempel", "uhrzeit", "epoch", "datetime", "x_value"],
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
                "drehwinkel",
                "winkellage",
                "winkelposition",
                "φ",
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
                "winkelgeschwindigkeit",
                "ω",
            ],
            Self::Torque => &[
                "torque",
                "tau",
                "m",
                "moment",
                "drehmoment",
                "force",
                "f",
                "kraft",
                "effort",
                "loadtorque",
                "lastmoment",
                "lastdrehmoment",
            ],
        }
    }

    /// Returns the permitted dimensions of the unit: rotary first, then linear.
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
