//! Choices about a recording: the use of each column, its unit and its ratio, smoothing, and the meaning of its torque.

use super::line::LineMechanism;
use crate::call::Call;
use crate::value::{stated, taken};
use quantities::{Dimension, Language, Time, Unit, parse_as};
use questions::{ColumnRole, ColumnSpec, Layout, PREVIEW_COLUMNS_MAX, Preview, recording_roles};
use words::incoming;

/// Meaning of a recorded torque.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TorqueUse {
    /// The whole load of the axis.
    Whole,
    /// A process torque, added to the load of the project.
    Process,
    /// The column is not used.
    Unused,
}

impl TorqueUse {
    pub(super) const ALL: [Self; 3] = [Self::Whole, Self::Process, Self::Unused];

    pub(super) const fn id(self) -> &'static str {
        match self {
            Self::Whole => "whole",
            Self::Process => "process",
            Self::Unused => "unused",
        }
    }
}

/// Use of a column.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct ColumnChoice {
    /// Chosen role; `None` if the column is not used.
    pub(super) role: Option<ColumnRole>,
    /// Chosen unit as in a project file; empty for that of the file.
    pub(super) unit: String,
    /// Typed ratio to the output, with a decimal point; empty for a column of the output.
    pub(super) ratio: String,
}

/// Word of a form for a column that is not used.
pub(super) const NO_ROLE: &str = "none";

/// Word of a form for a window of another width.
pub(super) const OTHER_WINDOW: &str = "other";

/// Choices of the form; those not made yet are as the file is recognised.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Choices {
    pub(super) preview: Option<Preview>,
    /// Use of each column of the preview.
    pub(super) columns: Vec<ColumnChoice>,
    /// Window of smoothing as in a project file.
    pub(super) smoothing: Option<String>,
    /// Typed window, in the language of the page.
    pub(super) other_window: String,
    /// The window is the typed one.
    pub(super) is_other_window: bool,
    pub(super) torque: Option<TorqueUse>,
    /// The recording is added behind the motion of the axis instead of replacing it.
    pub(super) is_added: bool,
    pub(super) runs_once: bool,
    pub(super) interpolates: bool,
    pub(super) is_evenly_spaced: bool,
    /// Moment of inertia of the load as in a project file; empty if it is not stated here.
    pub(super) inertia: String,
    /// Mechanism that turns a motion along a line into one of the output, where the axis has none.
    pub(super) line: Option<LineMechanism>,
}

/// Returns the word of a role in a project file.
pub(super) fn role_id(role: ColumnRole) -> &'static str {
    recording_roles().into_iter().find(|(_, of, _)| *of == role).map_or("", |(name, ..)| name)
}

/// Returns the unit of a role with this spelling.
fn unit_of(role: ColumnRole, spelling: &str) -> Option<&'static Unit> {
    role.dimensions().iter().find_map(|dimension| Unit::of_dimension(*dimension, spelling))
}

impl Choices {
    pub(super) fn of(call: &Call<'_>, preview: Option<Preview>) -> Self {
        let l = call.language();
        let field = |name: &str| call.field(name).map(|value| value.trim().to_owned()).unwrap_or_default();
        let recognised = preview.as_ref().map(|preview| preview.columns.as_slice()).unwrap_or_default();
        let column = |(index, column): (usize, &questions::PreviewColumn)| {
            let role = match call.field(&format!("role_{index}")) {
                Some(word) => ColumnRole::ALL.into_iter().find(|role| role_id(*role) == word),
                None => column.role,
            };
            let unit = field(&format!("unit_{index}"));
            // A unit of the role that the column had before is none of the new one.
            let unit = role.and_then(|role| unit_of(role, &unit)).map_or("", |unit| unit.ascii).to_owned();
            ColumnChoice { role, unit, ratio: taken(&field(&format!("ratio_{index}")), l) }
        };
        let mut columns: Vec<ColumnChoice> =
            recognised.iter().enumerate().take(PREVIEW_COLUMNS_MAX).map(column).collect();
        // A role has one column: the one that received it last.
        let changed = field("changed");
        let last = changed.strip_prefix("role_").and_then(|index| index.parse::<usize>().ok());
        if let Some((last, role)) = last.and_then(|last| Some((last, columns.get(last)?.role?))) {
            for (_, other) in columns.iter_mut().enumerate().filter(|(index, _)| *index != last) {
                other.role = other.role.filter(|of| *of != role);
            }
        }
        let typed = field("window");
        let window = field("smoothing");
        let is_other_window = window == OTHER_WINDOW;
        let smoothing = if is_other_window { stated(&typed, "ms", l) } else { window };
        Self {
            preview,
            columns,
            smoothing: Some(smoothing).filter(|window| !window.is_empty()),
            other_window: typed,
            is_other_window,
            torque: TorqueUse::ALL.into_iter().find(|each| each.id() == field("torque")),
            is_added: field("place") == "added",
            runs_once: field("once") == "true",
            interpolates: field("held") == "true",
            is_evenly_spaced: field("even") == "true",
            inertia: stated(&field("inertia"), "kg m^2", l),
            line: None,
        }
    }

    /// Returns the index of the column with a role.
    fn column(&self, role: ColumnRole) -> Option<usize> {
        self.columns.iter().position(|column| column.role == Some(role))
    }

    /// Returns `true` if the used position or speed is one along a line, by its chosen unit or that of the file.
    pub(super) fn is_along_a_line(&self) -> bool {
        let recognised = self.preview.as_ref().map(|preview| preview.columns.as_slice()).unwrap_or_default();
        self.columns.iter().zip(recognised).any(|(choice, column)| {
            let Some(role @ (ColumnRole::Position | ColumnRole::Speed)) = choice.role else { return false };
            let unit = if choice.unit.is_empty() { column.unit.as_deref() } else { Some(choice.unit.as_str()) };
            let unit = unit.and_then(|unit| unit_of(role, unit));
            unit.is_some_and(|unit| matches!(unit.dimension, Dimension::Length | Dimension::Velocity))
        })
    }

    /// Returns `true` if the questions about torque and mechanism have an answer.
    pub(super) fn is_answered(&self) -> bool {
        (self.torque.is_some() || !self.has_torque()) && self.line.as_ref().is_none_or(LineMechanism::is_stated)
    }

    /// Returns the request to answer the first open question.
    pub(super) fn waits_for(&self, language: Language) -> &'static str {
        if self.has_torque() && self.torque.is_none() {
            incoming::answer_first(language)
        } else {
            incoming::state_mechanism(language)
        }
    }

    /// Returns `true` if a column holds a torque or a force.
    pub(super) fn has_torque(&self) -> bool {
        self.column(ColumnRole::Torque).is_some()
    }

    /// Returns the stated window of smoothing.
    pub(super) fn window(&self) -> Option<Time> {
        parse_as::<Time>(self.smoothing.as_deref()?).ok()
    }

    /// Returns the chosen column of a role, if it differs from the recognised one: its name, or `None` for no column.
    fn stated_column(&self, role: ColumnRole) -> Option<Option<&str>> {
        let recognised = &self.preview.as_ref()?.columns;
        let found = recognised.iter().position(|column| column.role == Some(role));
        let chosen = self.column(role).filter(|_| role != ColumnRole::Torque || self.torque != Some(TorqueUse::Unused));
        (chosen != found).then(|| chosen.and_then(|index| Some(recognised.get(index)?.name.as_str())))
    }

    /// Returns the column of a role if it is used.
    fn used(&self, role: ColumnRole) -> Option<&ColumnChoice> {
        let is_used = role != ColumnRole::Torque || self.torque != Some(TorqueUse::Unused);
        self.columns.get(self.column(role)?).filter(|_| is_used)
    }

    /// Returns the keys of the segment with their values.
    pub(super) fn keys(&self) -> Vec<(String, String)> {
        let mut keys = Vec::new();
        for role in ColumnRole::ALL {
            let id = role_id(role);
            if let Some(name) = self.stated_column(role) {
                keys.push((format!("columns.{id}"), name.unwrap_or("none").to_owned()));
            }
            let Some(used) = self.used(role) else { continue };
            if !used.unit.is_empty() {
                keys.push((format!("units.{id}"), used.unit.clone()));
            }
            if !used.ratio.is_empty() && role != ColumnRole::Time {
                keys.push((format!("recorded_ratio.{id}"), used.ratio.clone()));
            }
        }
        if self.interpolates {
            keys.push(("held_values".to_owned(), "interpolate".to_owned()));
        }
        if self.is_evenly_spaced {
            keys.push(("time_stamps".to_owned(), "even".to_owned()));
        }
        keys
    }

    /// Returns the statements about the columns, as the keys state them.
    pub(super) fn layout(&self) -> Layout {
        let spec = |role: ColumnRole| {
            let stated = self.stated_column(role);
            ColumnSpec {
                name: stated.flatten().map(str::to_owned),
                unit: self.used(role).and_then(|used| unit_of(role, &used.unit)),
                unused: stated == Some(None),
            }
        };
        Layout {
            time: spec(ColumnRole::Time),
            position: spec(ColumnRole::Position),
            speed: spec(ColumnRole::Speed),
            torque: spec(ColumnRole::Torque),
            even_stamps: self.is_evenly_spaced,
            ..Layout::default()
        }
    }

    /// Returns the ratios of position, speed and torque to the output; 1 where none is stated.
    pub(super) fn ratios(&self) -> [f64; 3] {
        [ColumnRole::Position, ColumnRole::Speed, ColumnRole::Torque].map(|role| {
            let ratio = self.used(role).and_then(|used| used.ratio.parse::<f64>().ok());
            ratio.filter(|ratio| ratio.is_finite() && *ratio != 0.0).unwrap_or(1.0)
        })
    }
}
