//! The axis: load and cycle, prepared once for all candidates.

use actuator::FlangeLoad;
use mechanism::DirectLoad;
use motion::{Cycle, Moments, Segment};
use quantities::{Angle, ElectricPotential, Frequency, ThermodynamicTemperature, Time};

/// Operating condition of the output bearing (table 76.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OperatingCondition {
    /// Normal operation: f_s ≥ 1.5.
    Normal,
    /// Vibration or shock: f_s ≥ 2.
    Shock,
    /// High transmission accuracy: f_s ≥ 3.
    HighAccuracy,
}

impl OperatingCondition {
    /// Lower limit of the static safety.
    ///
    /// # Source   cha-manual table 76.3
    #[must_use]
    pub const fn static_safety_min(self) -> f64 {
        match self {
            Self::Normal => 1.5,
            Self::Shock => 2.0,
            Self::HighAccuracy => 3.0,
        }
    }
}

/// What the output bearing has to bear, and what is asked of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingDuty {
    /// Forces on the flange, constant over the cycle.
    pub load: FlangeLoad,
    /// f_w: load factor of table 74.2.
    pub load_factor: Option<f64>,
    /// Operating condition, for the static safety.
    pub operating_condition: Option<OperatingCondition>,
    /// Life required.
    pub life_min: Option<Time>,
    /// Tilt permitted.
    pub tilt_max: Option<Angle>,
}

/// Load and motion of one axis, with the moments of its cycle.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What is moved.
    pub load: DirectLoad,
    /// How it is moved.
    pub cycle: Cycle,
    /// Ambient temperature, if the user stated one.
    pub ambient: Option<ThermodynamicTemperature>,
    /// Loads on the output bearing, if the user gave any.
    pub bearing: Option<BearingDuty>,
    /// DC link voltage, and the share of U_DC/√2 that the drive can use.
    pub supply: Option<(ElectricPotential, f64)>,
    /// Life required of the gear.
    pub gear_life_min: Option<Time>,
    /// Torsion of the gear permitted.
    pub torsion_max: Option<Angle>,
    /// Least first natural frequency asked for.
    pub natural_frequency_min: Option<Frequency>,
    pub(crate) moments: Moments,
    pub(crate) segments: Vec<Segment>,
}

impl Axis {
    /// Prepares an axis: one pass over the motion.
    #[must_use]
    pub fn new(load: DirectLoad, cycle: Cycle) -> Self {
        let moments = Moments::of(&cycle);
        let segments = cycle.segments().collect();
        Self {
            load,
            cycle,
            ambient: None,
            bearing: None,
            supply: None,
            gear_life_min: None,
            torsion_max: None,
            natural_frequency_min: None,
            moments,
            segments,
        }
    }

    /// The integrals of the cycle.
    #[must_use]
    pub const fn moments(&self) -> &Moments {
        &self.moments
    }
}
