//! Torque of the load at a sequence of states.

use crate::equations::Reduced;
use crate::rotor::Laden;
use crate::{Extra, Mechanism, MechanismKind, Output};

/// Torque of a mechanism at one state of the output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadTorque {
    /// Torque required by the load beyond the transmission, see [`Mechanism::useful_torque`] \[Nm\].
    pub useful_nm: f64,
    /// Torque of ropes over sheaves with losses, see [`Mechanism::has_lossy_sheaves`]; zero for others \[Nm\].
    pub ropes_nm: f64,
    /// Torque that the output must apply, see [`Mechanism::torque`] \[Nm\].
    pub torque_nm: f64,
    /// Torque transmitted by a stage, see [`Mechanism::stage_torque`] \[Nm\].
    pub stage_nm: f64,
}

/// A mechanism in one motion segment, with the constants of the segment computed once.
#[derive(Clone, Copy, Debug)]
pub struct Loading<'m> {
    mechanism: &'m Mechanism,
    extra: &'m Extra,
    /// Constants of a rotor; the other kinds have none worth caching.
    laden: Option<Laden>,
}

impl Mechanism {
    /// Returns the mechanism in a segment with its additions to the load.
    #[must_use]
    pub fn loading<'m>(&'m self, extra: &'m Extra) -> Loading<'m> {
        let laden = if let MechanismKind::Rotor(rotor) = &self.kind { Some(rotor.laden(extra)) } else { None };
        Loading { mechanism: self, extra, laden }
    }
}

impl Loading<'_> {
    /// Returns the torque at a state of the output.
    #[must_use]
    pub fn at(&self, output: &Output) -> LoadTorque {
        let (mechanism, stage) = (self.mechanism, self.mechanism.gearing());
        let behind = stage.map_or(*output, |stage| stage.behind(output));
        let reduced = self.reduced(behind.position_rad);
        let (useful, ropes) = mechanism.useful(&reduced, &behind, self.extra);
        let own = mechanism.passed(useful, &behind);
        LoadTorque {
            useful_nm: useful,
            ropes_nm: ropes,
            torque_nm: stage.map_or(own, |stage| stage.torque(own, &behind, output)),
            stage_nm: stage.map_or(0.0, |stage| stage.handed_on(own, &behind)),
        }
    }

    fn reduced(&self, position_rad: f64) -> Reduced {
        match &self.laden {
            Some(laden) => laden.reduced(position_rad),
            None => self.mechanism.kind.reduced(position_rad, self.extra),
        }
    }
}
