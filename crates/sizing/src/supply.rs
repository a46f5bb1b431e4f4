//! The DC link: stated, or behind a rectifier at the mains.

use crate::comparison::project;
use derivation::Workings;
use provenance::{Grade, Source};
use quantities::unit::{EFFECTIVE_VOLT, ONE, VOLT};
use quantities::{EffectiveVoltage, ElectricPotential, Measure};
use std::f64::consts::{PI, SQRT_2};

/// The voltages that the DC link has, and how much of it the drive can use. Each check takes the edge that is worse for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Supply {
    /// Share of U_DC/√2 that the drive can give.
    pub reserve: f64,
    /// What it follows from.
    pub from: SupplyFrom,
}

/// What the DC link follows from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SupplyFrom {
    /// The project states it.
    DcLink(ElectricPotential),
    /// A rectifier without control.
    Mains {
        /// What feeds it.
        phases: MainsPhases,
        /// U_mains between two lines.
        nominal: EffectiveVoltage,
        /// d: by this share of it the mains vary.
        deviation: f64,
    },
}

/// What feeds a rectifier.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MainsPhases {
    /// One phase, between line and neutral: two pulses in a period.
    Single,
    /// Three phases: six pulses.
    Three,
}

/// An edge of the DC link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Edge {
    /// Under load at the lowest mains.
    Low,
    /// Without load at the highest mains.
    High,
}

impl Supply {
    /// U_DC at an edge.
    ///
    /// Of a bridge of diodes: U_DC = (3√2/π) U_mains (1 − d) under load of three phases, the mean of six pulses,
    /// (2√2/π) U_mains (1 − d) of one phase, the mean of two, and √2 U_mains (1 + d) without load, where the capacitor holds
    /// the peak.
    ///
    /// # Symbols
    /// U_mains effective voltage between two lines \[V\], d deviation of the mains \[1\]
    /// # Source
    /// docs/theory/voltage.md
    /// # Valid
    /// A rectifier without control; the fall of voltage in choke, diodes and cables is not counted. Of one phase a
    /// capacitor holds more than the mean, which is the least.
    pub(crate) fn at(&self, edge: Edge) -> ElectricPotential {
        match (self.from, edge) {
            (SupplyFrom::DcLink(stated), _) => stated,
            (SupplyFrom::Mains { phases, nominal, deviation }, Edge::Low) => {
                let mean = match phases {
                    MainsPhases::Single => 2.0 * SQRT_2 / PI,
                    MainsPhases::Three => 3.0 * SQRT_2 / PI,
                };
                ElectricPotential::from_si(mean * nominal.si() * (1.0 - deviation))
            }
            (SupplyFrom::Mains { nominal, deviation, .. }, Edge::High) => {
                ElectricPotential::from_si(SQRT_2 * nominal.si() * (1.0 + deviation))
            }
        }
    }

    /// What the drive gives at the motor terminals at least, rms.
    #[must_use]
    pub fn terminal_voltage(&self) -> ElectricPotential {
        ElectricPotential::from_si(self.at(Edge::Low).si() / SQRT_2 * self.reserve)
    }

    /// The least voltage of the DC link.
    #[must_use]
    pub fn least(&self) -> ElectricPotential {
        self.at(Edge::Low)
    }

    /// The DC link without load at nominal mains.
    #[must_use]
    pub fn nominal(&self) -> ElectricPotential {
        match self.from {
            SupplyFrom::DcLink(stated) => stated,
            SupplyFrom::Mains { nominal, .. } => ElectricPotential::from_si(SQRT_2 * nominal.si()),
        }
    }

    /// The largest voltage of the DC link that the supply alone gives.
    #[must_use]
    pub fn most(&self) -> ElectricPotential {
        self.at(Edge::High)
    }

    /// The key that it follows from.
    pub(crate) const fn key(&self) -> &'static str {
        match self.from {
            SupplyFrom::DcLink(_) => "requirements.supply",
            SupplyFrom::Mains { .. } => "requirements.mains",
        }
    }

    /// The same as a source.
    pub(crate) fn source(&self) -> Source {
        project(self.key())
    }

    /// That of the rectifier is assumed.
    pub(crate) const fn grade(&self) -> Grade {
        match self.from {
            SupplyFrom::DcLink(_) => Grade::Printed,
            SupplyFrom::Mains { .. } => Grade::Assumed,
        }
    }

    /// U_DC at an edge, derived.
    pub(crate) fn explain(&self, edge: Edge, work: &mut Workings) {
        let found = self.at(edge).si();
        match self.from {
            SupplyFrom::DcLink(_) => work.figure("U_DC", &VOLT, found, &self.source(), Grade::Printed),
            SupplyFrom::Mains { phases, nominal, deviation } => {
                let by = project("requirements.mains_deviation");
                work.figure("U_mains", &EFFECTIVE_VOLT, nominal.si(), &self.source(), Grade::Printed);
                work.figure("d_U", &ONE, deviation, &by, Grade::Assumed);
                let text = match (edge, phases) {
                    (Edge::Low, MainsPhases::Single) => "2*sqrt(2)/pi*U_mains*(1 - d_U)",
                    (Edge::Low, MainsPhases::Three) => "3*sqrt(2)/pi*U_mains*(1 - d_U)",
                    (Edge::High, _) => "sqrt(2)*U_mains*(1 + d_U)",
                };
                work.formula("U_DC", &VOLT, found, text, &Source::Model { name: "voltage" });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mains(phases: MainsPhases, nominal: f64, deviation: f64) -> Supply {
        let nominal = EffectiveVoltage::from_si(nominal);
        Supply { reserve: 0.9, from: SupplyFrom::Mains { phases, nominal, deviation } }
    }

    /// 230 V: peak 325.3 V; mean of two pulses 207.1 V (textbook values: 1.414 and 0.900 of it).
    #[test]
    fn a_rectifier_of_one_phase_gives_the_textbook_values() {
        let volts = |deviation, edge| mains(MainsPhases::Single, 230.0, deviation).at(edge).si();
        assert!((volts(0.0, Edge::High) - 325.27).abs() < 1e-2 && (volts(0.0, Edge::Low) - 207.07).abs() < 1e-2);
        assert!((volts(0.1, Edge::High) - 357.80).abs() < 1e-2 && (volts(0.1, Edge::Low) - 186.37).abs() < 1e-2);
    }

    /// 400 V ± 10 %: 486 V to 622 V; the peak of 400 V is 565.7 V, the mean of six pulses 540.2 V (textbook values).
    #[test]
    fn a_rectifier_gives_the_textbook_values() {
        let mains = |deviation| mains(MainsPhases::Three, 400.0, deviation);
        let volts = |deviation, edge| mains(deviation).at(edge).si();
        assert!((volts(0.0, Edge::High) - 565.685).abs() < 1e-3 && (volts(0.0, Edge::Low) - 540.19).abs() < 1e-2);
        assert!((volts(0.1, Edge::High) - 622.25).abs() < 1e-2 && (volts(0.1, Edge::Low) - 486.17).abs() < 1e-2);
        assert!((mains(0.1).terminal_voltage().si() - 486.17 / SQRT_2 * 0.9).abs() < 1e-2);
    }
}
