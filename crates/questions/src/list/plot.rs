//! `plot PROJECT`: a picture of an axis with an actuator; a face draws it.

use super::given::{arguments, some, some_product, text, word};
use super::{AXIS, Argument, ArgumentKind, Cost, Entry, Gives, Inquiry, PICTURE, Reads, Unanswered, argument, media};
use crate::chapters::read_quantity;
use crate::sizing_use::{Candidate, Rejected};
use crate::subject::candidate_for;
use axis::AxisProject;
use configurator::ProductId;
use quantities::Length;
use std::borrow::Cow;
use words::{help, help::values, requests};

/// Pictures of a project, by their identifiers.
pub const FIGURES: [&str; 6] = ["torque_speed", "cycle", "utilisation", "torsion", "bearing_load", "candidate_map"];

/// Colours of a picture.
pub const THEME: Argument = Argument::option("theme", values::theme, help::theme)
    .of(ArgumentKind::Word(|| vec!["light", "dark"]))
    .usually("light");
/// Width of a picture.
pub const WIDTH: Argument = Argument::option("width", values::length, help::width);
/// Height of a picture.
pub const HEIGHT: Argument = Argument::option("height", values::length, help::height);

/// The only picture with an abscissa to choose.
pub const MAP: &str = "candidate_map";

arguments! {
    /// Arguments of `plot`: axis, actuator, picture and its layout.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own, else the best.
        code: Option<ProductId> = argument::code(help::own_or_best_code) => some_product,
        /// The picture.
        figure: Option<String> = Argument::option("figure", values::figure, requests::figure)
            .of(ArgumentKind::Word(|| FIGURES.to_vec())).required() => text,
        /// `true` if the map of the candidates is laid out by length, not by mass.
        by: Option<bool> = Argument::option("by", values::what, help::plot_by)
            .of(ArgumentKind::Word(|| vec!["mass", "length"])).usually("mass") => word(|by| Some(by == "length")),
        /// Dark colours.
        theme: Option<bool> = THEME => word(|theme| Some(theme == "dark")),
        /// Width of the picture.
        width: Option<Length> = WIDTH => some(read_quantity),
        /// Height of the picture.
        height: Option<Length> = HEIGHT => some(read_quantity),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "plot",
    path: "plot",
    about: help::plot,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Media(&[media::SVG]),
    writes: &PICTURE,
    example: "axis.toml --figure torque_speed --svg plane.svg",
    answer: None,
};

impl Args {
    /// Returns the actuator to draw.
    ///
    /// # Errors
    /// The reason why it cannot be judged.
    pub fn candidate<'p>(&self, project: &'p AxisProject, inquiry: &Inquiry<'_>) -> Result<Candidate<'p>, Unanswered> {
        let sizing = || super::size::sized(project, 0, Rejected::Nearest, inquiry.progress).map(Cow::Owned);
        Ok(candidate_for(project, self.code.as_ref(), sizing)?)
    }

    /// Returns the axis to draw.
    ///
    /// # Errors
    /// Faults of the project, several axes without a name.
    pub fn drawn(&self, inquiry: &Inquiry<'_>) -> Result<AxisProject, Unanswered> {
        inquiry.axis(self.axis.as_deref(), Cost::Other).map(|(_, project)| project)
    }
}
