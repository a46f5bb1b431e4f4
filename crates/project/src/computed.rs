//! Assumptions that only the computed motion shows.

use crate::Assumption;
use mechanism::Extra;
use quantities::Measure;
use sizing::Axis;

/// A move in which the axis comes back, because its distance is shorter than its change of speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overrun {
    /// Number of the segment, from 1.
    pub segment: usize,
    /// Distance of the move \[rad\], signed.
    pub stated_rad: f64,
    /// Distance of the plain change of speed \[rad\], signed.
    pub plain_rad: f64,
    /// Travel per angle of a linear mechanism [m/rad].
    pub travel_m_per_rad: Option<f64>,
}

/// Adds moves that come back, the noise at rest in the recordings of an axis, keys that do not do what they are stated
/// for, and the apparent accelerations due to the resolution of the recordings.
pub(crate) fn assumptions(axis: &Axis, found: &mut Vec<Assumption>) {
    let nothing = Extra::none();
    let mut put = |each: Assumption| {
        if !found.contains(&each) {
            found.push(each);
        }
    };
    for (index, stretch) in axis.motion.stretches().iter().enumerate() {
        if let (Some(plain), Some(solved)) = (stretch.overrun, stretch.solved) {
            put(Assumption::Overruns(Overrun {
                segment: index + 1,
                stated_rad: solved.distance.si(),
                plain_rad: plain.si(),
                travel_m_per_rad: axis.mechanism.travel_m_per_rad(),
            }));
        }
    }
    for placed in axis.motion.recordings() {
        if let Some(noise) = placed.recorded.rest_noise() {
            put(Assumption::RecordedRest(noise));
        }
        if let Some(alternating) = placed.recorded.alternating() {
            put(Assumption::RecordedAlternating(alternating));
        }
        for remark in placed.recorded.remarks() {
            put(Assumption::RecordedKey(*remark));
        }
        if let Some(made_up) = placed.recorded.made_up() {
            let extra = axis.extras.get(placed.segment).unwrap_or(&nothing);
            let (first, _) = placed.recorded.ends_rad();
            // The samples are those of the mechanism; the inertia is that at the output, before a stage.
            let at_output = made_up.acceleration_rad_s2 * axis.mechanism.stage_ratio().abs();
            let torque_nm = axis.mechanism.inertia(first + placed.offset_rad, extra).si() * at_output;
            put(Assumption::RecordedSteps(made_up, torque_nm));
        }
    }
}
