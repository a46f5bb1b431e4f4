//! The DC link: stated, or fed by a rectifier on the mains.

use crate::comparison::project;
use derivation::Workings;
use provenance::{Grade, Source};
use quantities::unit::{EFFECTIVE_VOLT, ONE, VOLT};
use quantities::{EffectiveVoltage, ElectricPotential, Measure};
use std::f64::consts::{PI, SQRT_2};

/// Voltages of the DC link, and the share of them that the drive can use. Each check uses the edge that is worse for
/// it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Supply {
    /// Share of U_DC/√2 that the drive can provide.
    pub reserve: f64,
    /// Origin of the voltage.
    pub from: SupplyFrom,
}

/// Origin of the DC link voltage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SupplyFrom {
    /// Voltage stated by the project.
    DcLink(ElectricPotential),
    /// An uncontrolled rectifier.
    Mains {
        /// Phases of the mains.
        phases: MainsPhases,
        /// U_mains between two lines.
        nominal: EffectiveVoltage,
        /// d: deviation of the mains voltage as a share of it.
        deviation: f64,
    },
}

/// Phases that feed a rectifier.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MainsPhases {
    /// One phase, between line and neutral: two pulses in a period.
    Single,
    /// Three phases: six pulses.
    Three,
}

/// An edge of the DC link voltage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Edge {
    /// Under load at the lowest mains voltage.
    Low,
    /// Without load at the highest mains voltage.
    High,
}

impl Supply {
    /// Returns U_DC at an edge.
    ///
    /// For a diode bridge: U_DC = (3√2/π) U_mains (1 − d) under load with three phases, the mean of six pulses, (2√2/π)
    /// U_mains (1 − d) with one phase, the mean of two, and √2 U_mains (1 + d) without load, where the capacitor holds
    /// the peak.
    ///
    /// # Symbols
    /// U_mains effective voltage between two lines \[V\], d deviation of the mains \[1\]
    /// # Source
    /// docs/theory/voltage.md
    /// # Valid
    /// An uncontrolled rectifier; the voltage drop in choke, diodes and cables is neglected. With one phase a capacitor
    /// holds more than the mean, which is the least value.
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

    /// Returns the least voltage of the drive at the motor terminals, rms.
    #[must_use]
    pub fn terminal_voltage(&self) -> ElectricPotential {
        ElectricPotential::from_si(self.at(Edge::Low).si() / SQRT_2 * self.reserve)
    }

    /// Returns the least voltage of the DC link.
    #[must_use]
    pub fn least(&self) -> ElectricPotential {
        self.at(Edge::Low)
    }

    /// Returns the DC link voltage without load at nominal mains voltage.
    #[must_use]
    pub fn nominal(&self) -> ElectricPotential {
        match self.from {
            SupplyFrom::DcLink(stated) => stated,
            SupplyFrom::Mains { nominal, .. } => ElectricPotential::from_si(SQRT_2 * nominal.si()),
        }
    }

    /// Returns the largest voltage of the DC link from the supply alone.
    #[must_use]
    pub fn most(&self) -> ElectricPotential {
        self.at(Edge::High)
    }

    /// Returns the key that states the supply.
    pub(crate) const fn key(&self) -> &'static str {
        match self.from {
            SupplyFrom::DcLink(_) => "requirements.supply",
            SupplyFrom::Mains { .. } => "requirements.mains",
        }
    }

    /// Returns the key as a source.
    pub(crate) fn source(&self) -> Source {
        project(self.key())
    }

    /// Returns the grade of the voltage; that of a rectifier is assumed.
    pub(crate) const fn grade(&self) -> Grade {
        match self.from {
            SupplyFrom::DcLink(_) => Grade::Printed,
            SupplyFrom::Mains { .. } => Grade::Assumed,
        }
    }

    /// Records the derivation of U_DC at an edge.
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

    /// Compares with 230 V: peak 325.3 V; mean of two pulses 207.1 V (textbook values: 1.414 and 0.900 of it).
    #[test]
    fn a_rectifier_of_one_phase_gives_the_textbook_values() {
        let volts = |deviation, edge| mains(MainsPhases::Single, 230.0, deviation).at(edge).si();
        assert!((volts(0.0, Edge::High) - 325.27).abs() < 1e-2 && (volts(0.0, Edge::Low) - 207.07).abs() < 1e-2);
        assert!((volts(0.1, Edge::High) - 357.80).abs() < 1e-2 && (volts(0.1, Edge::Low) - 186.37).abs() < 1e-2);
    }

    /// Compares with 400 V ± 10 %: 486 V to 622 V; the peak of 400 V is 565.7 V, the mean of six pulses 540.2 V
    /// (textbook values).
    #[test]
    fn a_rectifier_gives_the_textbook_values() {
        let mains = |deviation| mains(MainsPhases::Three, 400.0, deviation);
        let volts = |deviation, edge| mains(deviation).at(edge).si();
        assert!((volts(0.0, Edge::High) - 565.685).abs() < 1e-3 && (volts(0.0, Edge::Low) - 540.19).abs() < 1e-2);
        assert!((volts(0.1, Edge::High) - 622.25).abs() < 1e-2 && (volts(0.1, Edge::Low) - 486.17).abs() < 1e-2);
        assert!((mains(0.1).terminal_voltage().si() - 486.17 / SQRT_2 * 0.9).abs() < 1e-2);
    }
}
