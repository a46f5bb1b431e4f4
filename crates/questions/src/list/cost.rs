//! Cost of an answer, by its question: known before the work begins.

use super::size::ASSESSED_MOST;
use crate::sizing_use::Refusal;
use crate::tolerance::{Draw, work};
use axis::AxisProject;
use sizing::{INSTANTS_MOST, Operation};

/// Question about the axes of a project, as far as the cost depends on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cost {
    /// The catalogue ranked.
    Ranking {
        /// Number of candidates reported in full.
        complete: usize,
        /// Sampling of the tolerances of the best candidates.
        draw: Draw,
    },
    /// One actuator judged.
    Check {
        /// Sampling of the tolerances.
        draw: Draw,
    },
    /// A report.
    Report,
    /// A workbook, or a table other than the time course.
    Workbook,
    /// The time course as a table.
    Course,
    /// Any other answer.
    Other,
}

impl Cost {
    /// Returns the approximate time limit of an answer on one core \[s\], if the call states none.
    const fn seconds(self) -> usize {
        match self {
            Self::Ranking { .. } | Self::Check { .. } => 5,
            Self::Report | Self::Workbook | Self::Course | Self::Other => 10,
        }
    }

    /// Returns the number of samples of recordings that all axes together may have within this time, in the measure of
    /// [`sizing::Axis::samples`].
    #[must_use]
    pub const fn samples(self) -> usize {
        match self {
            // A workbook lists the candidates with every check.
            Self::Workbook => 1 << 20,
            Self::Ranking { .. } | Self::Check { .. } | Self::Report | Self::Course => 1 << 21,
            Self::Other => 1 << 22,
        }
    }

    /// Returns the number of axes with the shortest cycles that are answered within this time: the record of each takes
    /// time and memory.
    #[allow(clippy::cast_precision_loss, reason = "the catalogue has no more")]
    fn axes(self) -> f64 {
        match self {
            Self::Report => 50.0,
            Self::Ranking { complete, .. } => 500.0 / (1.0 + complete.min(300) as f64 / 60.0),
            Self::Check { .. } | Self::Workbook | Self::Course | Self::Other => 500.0,
        }
    }

    /// Returns the share of this time that an axis takes.
    #[allow(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    fn share(self, project: &AxisProject) -> f64 {
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
        let shown = project.axis.motion.stretches().len() as f64 / self.segments();
        1.0 / self.axes() + samples as f64 / self.samples() as f64 + nodes / instants + shown + besides
    }

    /// Returns the approximate upper limit of the time of a row of a sweep over the catalogue on one core \[s\], with the values
    /// that the project states.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    pub fn seconds_of_row(project: &AxisProject) -> f64 {
        /// Time of a row of the shortest cycles \[s\], and of reading one whose ratio of the stage is chosen anew.
        const LEAST: (f64, f64) = (1e-4, 5e-3);
        let ranking = Self::Ranking { complete: 0, draw: Draw::default() };
        let judged = (ranking.share(project) - 1.0 / ranking.axes()) * ranking.seconds() as f64 + LEAST.0;
        match project.ratios.len() {
            0 => judged,
            ratios => LEAST.1 + (ratios + 1) as f64 * (judged + LEAST.1),
        }
    }

    /// Returns the approximate upper limits of an answer about an axis on one core: time \[s\], and memory of the
    /// process \[byte\].
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    pub fn predicted(self, project: &AxisProject) -> (f64, f64) {
        /// Bytes of a sample with its position, speed and acceleration, and of an instant.
        const BYTES: (f64, f64) = (128.0, 512.0);
        let [recorded, _] = project.axis.samples();
        let nodes = project.axis.instants().saturating_sub(recorded);
        let [process, row] = self.bytes();
        let rows = project.axis.motion.stretches().len() as f64;
        let bytes = process + row * rows + BYTES.0 * recorded as f64 + BYTES.1 * nodes as f64;
        (self.share(project) * self.seconds() as f64, bytes)
    }

    /// Returns the memory of the process itself with its fonts and tables, and that of a segment of the motion in the
    /// document \[byte\].
    const fn bytes(self) -> [f64; 2] {
        match self {
            Self::Report => [110e6, 0.4e6],
            Self::Workbook => [40e6, 0.15e6],
            Self::Ranking { .. } | Self::Check { .. } | Self::Course | Self::Other => [40e6, 0.0],
        }
    }

    /// Returns the number of segments that an answer shows within its time.
    const fn segments(self) -> f64 {
        match self {
            Self::Report => 2000.0,
            Self::Workbook => 4000.0,
            Self::Ranking { .. } | Self::Check { .. } | Self::Course | Self::Other => f64::INFINITY,
        }
    }

    /// Checks that the catalogue can be judged in this time for each of several ratios of a stage, of which the axis
    /// has one.
    ///
    /// # Errors
    /// [`Refusal::TooManyRatios`]
    pub(crate) fn is_quick_for(self, project: &AxisProject, ratios: usize) -> Result<(), Refusal> {
        #[allow(clippy::cast_precision_loss, reason = "at most sixteen")]
        let share = self.share(project) * ratios as f64;
        if share > 1.0 { Err(Refusal::TooManyRatios { ratios, seconds: self.seconds() }) } else { Ok(()) }
    }

    /// Checks that an answer about some axes stays within the usual time.
    ///
    /// # Errors
    /// [`Refusal::TooLong`] for recordings, [`Refusal::TooManyAxes`] for several axes that take longer together. The
    /// remaining size of a single axis is limited when it is read.
    #[allow(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "counts far below 2^52"
    )]
    pub fn is_quick<'p>(self, projects: impl IntoIterator<Item = &'p AxisProject> + Clone) -> Result<(), Refusal> {
        let (most, seconds) = (self.samples(), self.seconds());
        let each = projects.clone().into_iter().map(|project| project.axis.samples());
        let [samples, cost] = each.fold([0; 2], |[samples, cost], [a, b]| [samples + a, cost + b]);
        if cost > most {
            // The limit for loads of this kind.
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

/// Returns the instants of an axis without its recordings, with a share of those of the loads on its flange: these cost
/// less, since only actuators with another bearing evaluate them again.
#[allow(clippy::cast_precision_loss, reason = "a count far below 2^52")]
fn instants_of(project: &AxisProject) -> f64 {
    const ON_THE_FLANGE: f64 = 1.0 / 64.0;
    let [recorded, _] = project.axis.samples();
    let [on_flange, _] = project.axis.flange_instants();
    project.axis.instants().saturating_sub(recorded) as f64 + ON_THE_FLANGE * on_flange
}

#[cfg(test)]
mod tests {
    use super::*;

    fn project(inertia: &str, segments: usize) -> AxisProject {
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
        let of = |question: Cost, project: &AxisProject, count: usize| {
            question.is_quick(std::iter::repeat_n(project, count))
        };
        for (question, most) in [(ranking, 400), (Cost::Report, 48), (Cost::Other, 480)] {
            assert_eq!(of(question, &few, most), Ok(()), "{question:?}");
            let refused = of(question, &few, most + 60);
            assert!(matches!(refused, Err(Refusal::TooManyAxes { axes, .. }) if axes == most + 60), "{question:?}");
        }
        let all = Cost::Ranking { complete: usize::MAX, draw };
        assert!(of(all, &few, 20).is_ok() && of(all, &few, 100).is_err());
        // A long cycle and a tolerance have a cost above zero.
        let (long, uncertain) = (project("1 kg m^2", 4000), project("1 kg m^2 ± 5 %", 1));
        assert!(of(ranking, &long, 2).is_ok() && of(ranking, &long, 20).is_err());
        assert!(of(ranking, &uncertain, 4).is_ok() && of(ranking, &uncertain, 40).is_err());
        assert!(of(Cost::Check { draw }, &uncertain, 40).is_ok());
        let many = Draw { samples: Some(100_000), ..draw };
        assert!(of(Cost::Check { draw: many }, &uncertain, 1).is_ok());
        assert!(of(Cost::Check { draw: many }, &uncertain, 40).is_err());
    }
}
