//! The load of an axis, or a mechanism with its load, as the file states it.

use crate::assumption::Assumption;
use crate::fault::{AxisFault, AxisReport};
use mechanism::{Geometry, MechanismKind};
use project::KeyDefault;
use project::sections::{
    Bearing, BodySection, Fields, Friction, Losses, ProcessForce, StartAngle, Stated, StatedField, group,
};

use quantities::{Angle, Dimension, Force};

/// Part that loads the flange.
pub(crate) enum OnFlange<'s> {
    /// Bodies that turn with the flange; the tilt of its axis.
    Bodies(&'s Stated<Angle>),
    /// A pulley, pinion or crank.
    Wheel,
    /// The roll of a winder, whose weight acts along the axis or across it.
    Roll,
    /// The shaft of a mechanism with bearings of its own, whose share of the forces must be stated.
    Shaft,
}

/// Dimensions of the quantities of a load that turns with the output, of which each of several actuators carries a share.
pub(crate) const TURNED: &[Dimension] =
    &[Dimension::Mass, Dimension::MomentOfInertia, Dimension::Torque, Dimension::ViscousFriction, Dimension::Force];

/// A load, or a mechanism with its load, as the file states it.
pub(crate) trait Driven: Fields {
    /// Builds the mechanism; `None` after a fault or if a value is missing.
    fn kind(&self, report: &mut AxisReport<'_>) -> Option<MechanismKind>;

    /// Returns the keys from which its inertia follows.
    fn inertia(&self) -> Vec<&dyn StatedField> {
        self.field("inertia").into_iter().collect()
    }

    /// Returns the friction at the output.
    fn friction(&self) -> Option<&Friction> {
        group(self)
    }

    /// Returns the efficiencies.
    fn losses(&self) -> Option<&Losses> {
        group(self)
    }

    /// Returns `true` if a default has no effect on the result and is not listed.
    fn is_without_effect(&self, _default: KeyDefault) -> bool {
        false
    }

    /// Returns assumptions of its own; `carries` if a segment has a payload.
    fn assumptions(&self, _carries: bool) -> Vec<Assumption> {
        Vec::new()
    }

    /// Returns the force of the process along the line of the load, if there is such a line.
    fn process_force(&self) -> Option<&Stated<Force>> {
        group(self).map(|it: &ProcessForce| &it.process_force)
    }

    /// Returns `true` if a payload moves with the load.
    fn carries(&self) -> bool {
        self.process_force().is_some()
    }

    /// Returns the position at which the motion begins.
    fn start_angle(&self) -> Option<&Stated<Angle>> {
        group(self).map(|it: &StartAngle| &it.start_angle)
    }

    /// Returns the key from which the linear travel per turn follows, if that is constant.
    fn travel(&self) -> Option<&dyn StatedField> {
        None
    }

    /// Returns the key from which the travel of the load per turn follows, if it is a single one.
    fn gearing(&self) -> Option<&dyn StatedField> {
        self.travel()
    }

    /// Returns the dimensions of its quantities of which each of several actuators that drive it together carries a share;
    /// empty if it has a single drive. Along a line each actuator has its own screw, pulley or drum, whose inertia and
    /// friction it drives alone.
    fn shared(&self) -> &'static [Dimension] {
        if self.travel().is_some() { &[Dimension::Mass, Dimension::Force] } else { &[] }
    }

    /// Returns its solid bodies; `None` for other loads.
    fn bodies(&self) -> Option<&[BodySection]> {
        None
    }

    /// Returns `true` if its torque is recorded with the motion, including friction and losses.
    fn torque_is_recorded(&self) -> bool {
        false
    }

    /// Returns the part that loads the flange; `None` if no loads follow.
    fn on_flange(&self) -> Option<OnFlange<'_>> {
        None
    }

    /// Returns the keys of `[bearing]` from which its loads on the flange follow.
    fn flange_keys<'b>(&self, bearing: &'b Bearing) -> Vec<&'b dyn StatedField> {
        match self.on_flange() {
            Some(OnFlange::Bodies(_)) => vec![&bearing.overhang, &bearing.payload_overhang, &bearing.flange_share],
            Some(OnFlange::Wheel | OnFlange::Roll | OnFlange::Shaft) => {
                vec![&bearing.overhang, &bearing.flange_share, &bearing.wheel_mass, &bearing.axis_tilt]
            }
            None => Vec::new(),
        }
    }
}

/// Reports every fault of the lengths and angles of a mechanism.
pub(crate) fn sound(section: &impl Fields, faults: Vec<Geometry>, report: &mut AxisReport<'_>) -> Option<()> {
    let is_sound = faults.is_empty();
    for fault in faults {
        let span = section.field(fault.key()).map_or_else(|| section.head().span.clone(), StatedField::span);
        report.fault(span, AxisFault::Geometry(fault), None);
    }
    is_sound.then_some(())
}
