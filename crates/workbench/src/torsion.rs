//! The torsion of a gear under a torque, alone.

use crate::sizing_use::Candidate;
use actuator::Torsion;
use order_code::OrderCode;
use project::Project;
use quantities::{Angle, Language, QuantityError, Torque, parse_as};

/// The torsion of one code's gear under a torque.
#[derive(Clone, Copy, Debug)]
pub struct TorsionAnswer {
    /// The curve: T_1, T_2, K_1, K_2, K_3.
    pub curve: Torsion,
    /// The torque.
    pub torque: Torque,
    /// The angle.
    pub angle: Angle,
    /// Stiffness region of the torque: 1, 2 or 3.
    pub region: u8,
}

/// Reads a torque such as `60 N m`.
///
/// # Errors
/// What is wrong with the text, in a language.
pub fn read_torque(text: &str, language: Language) -> Result<Torque, (String, Option<String>)> {
    parse_as(text).map_err(|error: QuantityError| {
        (words::quantity_fault(&error, language), words::quantity_hint(&error, language))
    })
}

/// The torsion of a code's gear under a torque; `None` where the stiffness is not printed.
///
/// # Source   cha-manual eq. 73.1 to 73.4, tables 54.3 and 54.4
#[must_use]
pub fn torsion(code: &OrderCode, torque: Torque) -> Option<TorsionAnswer> {
    use quantities::Measure;
    let curve = configurator::parameters(code)?.gear.torsion()?;
    let size = torque.si().abs();
    let region = if size <= curve.torque_1.si() {
        1
    } else if size <= curve.torque_2.si() {
        2
    } else {
        3
    };
    Some(TorsionAnswer { curve, torque, angle: curve.angle(torque), region })
}

/// The torsion curve of a gear with the point at which an axis works.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorsionCurve {
    /// The curve: T_1, T_2, K_1, K_2, K_3.
    pub curve: Torsion,
    /// Largest torque on the gear.
    pub torque: Torque,
    /// Torsion under it.
    pub angle: Angle,
}

impl TorsionCurve {
    /// The corners of the curve from `−end` to `end`.
    #[must_use]
    pub fn points(&self, end: Torque) -> Vec<(Torque, Angle)> {
        use quantities::Measure;
        let (one, two, end) = (self.curve.torque_1.si(), self.curve.torque_2.si(), end.si().abs());
        let corners = [-end, -two, -one, 0.0, one, two, end];
        let inside = corners.into_iter().filter(|torque| torque.abs() <= end).map(Torque::from_si);
        inside.map(|torque| (torque, self.curve.angle(torque))).collect()
    }
}

/// The torsion curve of a candidate's gear and its working point; `None` where the stiffness is not known.
///
/// # Source   cha-manual eq. 73.1 to 73.3; the torque is that of the torsion check, without the actuator's own inertia
#[must_use]
pub fn torsion_of(project: &Project, candidate: &Candidate<'_>) -> Option<TorsionCurve> {
    let curve = candidate.parameters.gear.torsion()?;
    let torque = project.axis.moments().load_peak;
    Some(TorsionCurve { curve, torque, angle: curve.angle(torque) })
}
