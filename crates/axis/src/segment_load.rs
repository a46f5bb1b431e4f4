//! Loads of the segments as they act: those that a segment states, together with the constant ones of the mechanism.

use crate::axis_project::AxisProject;
use mechanism::Extra;
use project::sections::{Fields, Segment};
use quantities::unit::{KILOGRAM, KILOGRAM_SQUARE_METRE, NEWTON, NEWTON_METRE};
use quantities::{Measure, Unit};

/// A load that a segment may state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SegmentLoadKey {
    /// Mass in addition to those of the mechanism.
    Payload,
    /// Moment of inertia in addition to that of the mechanism.
    PayloadInertia,
    /// Process force along the line: that of the mechanism plus that of the segment.
    ProcessForce,
    /// Torque against the positive direction: the external torque of the mechanism plus the process torque of the
    /// segment.
    ExternalTorque,
}

impl SegmentLoadKey {
    /// The loads in the order of their keys.
    pub const ALL: [Self; 4] = [Self::Payload, Self::PayloadInertia, Self::ProcessForce, Self::ExternalTorque];

    /// Returns its identifier in data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Payload => "payload",
            Self::PayloadInertia => "payload_inertia",
            Self::ProcessForce => "process_force",
            Self::ExternalTorque => "external_torque",
        }
    }

    /// Returns the key of a segment that states it.
    const fn key(self) -> &'static str {
        match self {
            Self::ExternalTorque => "process_torque",
            Self::Payload | Self::PayloadInertia | Self::ProcessForce => self.id(),
        }
    }

    /// Returns the unit in which it is shown.
    #[must_use]
    pub const fn unit(self) -> &'static Unit {
        match self {
            Self::Payload => &KILOGRAM,
            Self::PayloadInertia => &KILOGRAM_SQUARE_METRE,
            Self::ProcessForce => &NEWTON,
            Self::ExternalTorque => &NEWTON_METRE,
        }
    }

    /// Returns the acting value, in SI, of what a segment adds and the external torque of the mechanism.
    fn acting(self, extra: &Extra, external_nm: f64) -> f64 {
        match self {
            Self::Payload => extra.mass.si(),
            Self::PayloadInertia => extra.inertia.si(),
            // The force of the mechanism is part of what each segment adds.
            Self::ProcessForce => extra.force.si(),
            Self::ExternalTorque => extra.torque.si() + external_nm,
        }
    }
}

impl AxisProject {
    /// Returns the loads that at least one segment states, in the order of their keys.
    #[must_use]
    pub fn segment_loads(&self) -> Vec<SegmentLoadKey> {
        let states = |load: SegmentLoadKey| {
            move |segment: &Segment| segment.field(load.key()).is_some_and(|field| field.is_given())
        };
        SegmentLoadKey::ALL.into_iter().filter(|load| self.root.segments().iter().any(states(*load))).collect()
    }

    /// Returns the value of a load that acts in a segment, counted from zero, in SI.
    #[must_use]
    pub fn acting_load(&self, load: SegmentLoadKey, segment: usize) -> Option<f64> {
        let external_nm = self.axis.mechanism.friction.external.si();
        self.axis.extras.get(segment).map(|extra| load.acting(extra, external_nm))
    }
}
