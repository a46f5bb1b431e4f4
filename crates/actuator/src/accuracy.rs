//! Accuracy of the gear.

use provenance::Datum;
use quantities::Angle;

/// Accuracy data of the gear, at the output.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Accuracy {
    /// Transmission accuracy: sum of the largest deviations in both directions over one turn, unloaded.
    pub transmission_accuracy: Datum<Angle>,
    /// Repeatability: half the spread of approaches from one side.
    pub repeatability: Datum<Angle>,
    /// Hysteresis loss: width of the torsion curve at zero torque after full torque in both directions.
    pub hysteresis_loss: Datum<Angle>,
    /// Lost motion: width of the torsion curve at a few per cent of the rated torque.
    pub lost_motion: Datum<Angle>,
}
