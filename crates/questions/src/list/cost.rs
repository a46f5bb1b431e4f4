//! What an answer costs, by its question: known before the work for it begins.

use super::size::ASSESSED_MOST;
use crate::sizing_use::Refusal;
use crate::tolerance::{Draw, work};
use project::Project;
use sizing::{INSTANTS_MOST, Operation};

/// What is asked about the axes of a project, as far as its cost depends on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cost {
    /// The catalogue ranked.
    Ranking {
        /// How many are reported in full.
        complete: usize,
        /// How the tolerances of the best of them are judged.
        draw: Draw,
    },
    /// One actuator judged.
    Check {
        /// How its tolerances are.
        draw: Draw,
    },
    /// A report.
    Report,
    /// A workbook, or a table other than the time course.
    Workbook,
    /// The time course as a table.
    Course,
    /// Anything else.
    Other,
}

impl Cost {
    /// How long an answer takes at most, about, on one core, where the call states no time limit \[s\].
    const fn seconds(self) -> usize {
        match self {
            Self::Ranking { .. } | Self::Check { .. } => 5,
            Self::Report | Self::Workbook | Self::Course | Self::Other => 10,
        }
    }

    /// The samples of recordings that are looked at within it, of all axes together, in the measure of [`sizing::Axis::samples`].
    #[must_use]
    pub const fn samples(self) -> usize {
        match self {
            // A workbook has the candidates by every check.
            Self::Workbook => 1 << 20,
            Self::Ranking { .. } | Self::Check { .. } | Self::Report | Self::Course => 1 << 21,
            Self::Other => 1 << 22,
        }
    }

    /// So many axes with cycles of no length are answered within it: the record of each takes time and memory.
    #[allow(clippy::cast_precision_loss, reason = "the catalogue has no more")]
    fn axes(self) -> f64 {
        match self {
            Self::Report => 50.0,
            Self::Ranking { complete, .. } => 500.0 / (1.0 + complete.min(300) as f64 / 60.0),
            Self::Check { .. } | Self::Workbook | Self::Course | Self::Other => 500.0,
        }
    }

    /// The share of that time which an axis takes.
    #[allow(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    fn share(self, project: &Project) -> f64 {
        /// Instants of the walk by segments in a report that take its time: below a microsecond each, for one actuator.
        const WALKED: f64 = 1e7;
        let [_, samples] = project.axis.samples();
        let nodes = instants_of(project);
        let (instants, besides) = match self {
            Self::Ranking { complete, draw } => {
                (INSTANTS_MOST, work::share(project, complete.min(ASSESSED_MOST), draw))
            }
            Self::Check { draw } => (INSTANTS_MOST, work::share(project, 1, draw)),
            Self::Report => {
                let walked = Operation::instants_of_laws(&project.axis) as f64 / WALKED;
                (INSTANTS_MOST, walked + work::share(project, 1, Draw::default()))
            }
            Self::Workbook | Self::Course | Self::Other => (2.0 * INSTANTS_MOST, 0.0),
        };
        1.0 / self.axes() + samples as f64 / self.samples() as f64 + nodes / instants + besides
    }

    /// What an answer about an axis takes at most, about, on one core: seconds, and bytes of the process.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    pub fn predicted(self, project: &Project) -> (f64, f64) {
        /// Of the process itself, of a sample with its position, speed and acceleration, and of an instant.
        const BYTES: (f64, f64, f64) = (40e6, 128.0, 512.0);
        let [recorded, _] = project.axis.samples();
        let nodes = project.axis.instants().saturating_sub(recorded);
        let bytes = BYTES.0 + BYTES.1 * recorded as f64 + BYTES.2 * nodes as f64;
        (self.share(project) * self.seconds() as f64, bytes)
    }

    /// Whether the catalogue is judged in that time for each of several ratios of a stage, of which the axis has one.
    ///
    /// # Errors
    /// [`Refusal::TooManyRatios`]
    pub(crate) fn is_quick_for(self, project: &Project, ratios: usize) -> Result<(), Refusal> {
        #[allow(clippy::cast_precision_loss, reason = "at most sixteen")]
        let share = self.share(project) * ratios as f64;
        if share > 1.0 { Err(Refusal::TooManyRatios { ratios, seconds: self.seconds() }) } else { Ok(()) }
    }

    /// Whether an answer about some axes stays within the usual time.
    ///
    /// # Errors
    /// [`Refusal::TooLong`] for recordings, [`Refusal::TooManyAxes`] for several axes that take longer together. What a single
    /// axis is besides its recordings is bounded where it is read.
    #[allow(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "counts far below 2^52"
    )]
    pub fn is_quick<'p>(self, projects: impl IntoIterator<Item = &'p Project> + Clone) -> Result<(), Refusal> {
        let (most, seconds) = (self.samples(), self.seconds());
        let each = projects.clone().into_iter().map(|project| project.axis.samples());
        let [samples, cost] = each.fold([0; 2], |[samples, cost], [a, b]| [samples + a, cost + b]);
        if cost > most {
            // For loads such as these.
            let most = (most as f64 * samples as f64 / cost as f64) as usize;
            return Err(Refusal::TooLong { samples, most, seconds });
        }
        let shares: Vec<f64> = projects.into_iter().map(|project| self.share(project)).collect();
        let axes = shares.len();
        if axes > 1 && shares.iter().sum::<f64>() > 1.0 {
            return Err(Refusal::TooManyAxes { axes, seconds });
        }
        Ok(())
    }
}

/// The instants of an axis without its recordings, with those of the loads on its flange: an instant there costs less, since of all
/// actuators only those with another bearing look at it again.
#[allow(clippy::cast_precision_loss, reason = "a count far below 2^52")]
fn instants_of(project: &Project) -> f64 {
    const ON_THE_FLANGE: f64 = 1.0 / 64.0;
    let [recorded, _] = project.axis.samples();
    let [on_flange, _] = project.axis.flange_instants();
    project.axis.instants().saturating_sub(recorded) as f64 + ON_THE_FLANGE * on_flange
}

#[cfg(test)]
mod tests {
    use super::*;

    fn project(inertia: &str, segments: usize) -> Project {
        let segment = "[[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\n\
            brake = \"0.1 s\"\npause = \"1 s\"\n";
        let text = format!("format = 1\n[load]\ninertia = \"{inertia}\"\n{}", segment.repeat(segments));
        crate::read(&text).unwrap()
    }

    #[test]
    fn several_axes_are_counted_together() {
        let draw = Draw::default();
        let ranking = Cost::Ranking { complete: 10, draw };
        let few = project("1 kg m^2", 1);
        let of =
            |question: Cost, project: &Project, count: usize| question.is_quick(std::iter::repeat_n(project, count));
        for (question, most) in [(ranking, 400), (Cost::Report, 48), (Cost::Other, 480)] {
            assert_eq!(of(question, &few, most), Ok(()), "{question:?}");
            let refused = of(question, &few, most + 60);
            assert!(matches!(refused, Err(Refusal::TooManyAxes { axes, .. }) if axes == most + 60), "{question:?}");
        }
        let all = Cost::Ranking { complete: usize::MAX, draw };
        assert!(of(all, &few, 20).is_ok() && of(all, &few, 100).is_err());
        // A long cycle and a tolerance cost more than nothing.
        let (long, uncertain) = (project("1 kg m^2", 4000), project("1 kg m^2 ± 5 %", 1));
        assert!(of(ranking, &long, 2).is_ok() && of(ranking, &long, 20).is_err());
        assert!(of(ranking, &uncertain, 4).is_ok() && of(ranking, &uncertain, 40).is_err());
        assert!(of(Cost::Check { draw }, &uncertain, 40).is_ok());
        let many = Draw { samples: Some(100_000), ..draw };
        assert!(of(Cost::Check { draw: many }, &uncertain, 1).is_ok());
        assert!(of(Cost::Check { draw: many }, &uncertain, 40).is_err());
    }
}
