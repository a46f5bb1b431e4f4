//! Proposals where no actuator fits: another gearing, another law of motion where none is decided.

use crate::gearing_proposals::{GearingProposal, RankedAxis, gearing_proposals, is_long};
use crate::progress::Progress;
use crate::sizing_use::Refusal;
use axis::{Assumption, AxisProject};
use project::choices::Law;
use sizing::{Fit, Proviso};

/// A law of motion in place of the assumed one with which an actuator fits.
#[derive(Clone, Debug, PartialEq)]
pub struct LawProposal {
    /// The law, of every move whose law is open.
    pub law: Law,
    /// Paths of their keys in the file.
    pub paths: Vec<String>,
    /// Best actuator with this law.
    pub code: String,
    /// Verdict on the actuator.
    pub fit: Fit,
    /// Conditions of this verdict.
    pub proviso: Proviso,
}

/// Proposals where no actuator fits.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Proposals {
    /// Values of the gearing and of a counterweight.
    pub gearings: Vec<GearingProposal>,
    /// Law of motion.
    pub law: Option<LawProposal>,
}

impl Proposals {
    /// Searches both.
    ///
    /// # Errors
    /// [`Refusal::Stopped`] if the search was cancelled.
    pub fn of(project: &AxisProject, progress: &Progress) -> Result<Self, Refusal> {
        Ok(Self { gearings: gearing_proposals(project, progress)?, law: law_proposal(project, progress)? })
    }
}

/// Laws that are proposed in place of the assumed one, the smoother first: without a jump of the acceleration, with one.
/// Only these have a smaller peak of the speed or the acceleration for the same way and time.
const LAWS: [Law; 4] = [Law::ModifiedSine, Law::ModifiedTrapezoid, Law::Trapezoid, Law::Triangle];

/// Returns the smoothest law in place of every one that is open with which an actuator of the catalogue fits; `None` if one
/// fits already, if no law is open, or if no law suffices.
///
/// # Errors
/// [`Refusal::Stopped`] if the search was cancelled.
pub fn law_proposal(project: &AxisProject, progress: &Progress) -> Result<Option<LawProposal>, Refusal> {
    if !project.assumptions.contains(&Assumption::LawOpen) || is_long(project) {
        return Ok(None);
    }
    if RankedAxis::of(project, progress)?.best.is_some() {
        return Ok(None);
    }
    for law in LAWS {
        let Some((changed, paths)) = project.with_open_laws(law) else { continue };
        if let Some((code, fit, proviso)) = RankedAxis::of(&changed, progress)?.best {
            return Ok(Some(LawProposal { law, paths, code, fit, proviso }));
        }
    }
    Ok(None)
}
