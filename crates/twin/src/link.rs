//! DC link: supply through a rectifier, capacitor, braking resistor.

/// Constants of a DC link.
///
/// ½ C (U⁺² − U²) = (P_s − P − P_b) Δt with all currents at the mean voltage of the step
///
/// # Symbols
/// P_s power of the supply, never negative \[W\], P power of the inverter, P_b power of the braking resistor
/// # Source
/// docs/theory/twin.md
/// # Valid
/// rectifier as a voltage source with a resistance; switching of the braking resistor with hysteresis
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkModel {
    pub(crate) capacity_f: f64,
    pub(crate) supply_v: f64,
    pub(crate) supply_ohm: f64,
    pub(crate) brake_ohm: f64,
    pub(crate) chopper_v: [f64; 2],
}

/// State of the DC link with its energies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link {
    pub(crate) voltage_v: f64,
    pub(crate) chopping: bool,
    /// Energy from the supply, before its resistance \[J\].
    pub(crate) supplied_j: f64,
    /// Heat in the resistance of the supply \[J\].
    pub(crate) rectifier_j: f64,
    /// Heat in the braking resistor \[J\].
    pub(crate) brake_j: f64,
}

impl Link {
    /// Sets the energies to zero; voltage and braking resistor keep their state.
    pub(crate) const fn forget(&mut self) {
        (self.supplied_j, self.rectifier_j, self.brake_j) = (0.0, 0.0, 0.0);
    }
}

impl LinkModel {
    pub(crate) fn start(&self) -> Link {
        Link { voltage_v: self.supply_v, chopping: false, supplied_j: 0.0, rectifier_j: 0.0, brake_j: 0.0 }
    }

    /// Advances a step with the energy taken by the inverter \[J\]; `supply` is a share of the nominal voltage, zero
    /// without mains.
    #[inline]
    pub(crate) fn step(&self, link: &mut Link, taken_j: f64, supply: f64, step_s: f64) {
        let [off, on] = self.chopper_v;
        link.chopping = link.voltage_v > if link.chopping { off } else { on };
        let (supply_v, before) = (supply * self.supply_v, link.voltage_v);
        // The mean m of both ends solves (2 m − U)² = U² + 2 Δt/C ((U_s − m) m/R_s − m²/R_b − P); without supply
        // current if m ≥ U_s.
        let share = 2.0 * step_s / self.capacity_f;
        let burns = if link.chopping { share / self.brake_ohm } else { 0.0 };
        let feeds = share / self.supply_ohm;
        let solved = |feeds: f64| {
            let (square, linear) = (4.0 + feeds + burns, 4.0 * before + feeds * supply_v);
            let root = (linear * linear - 4.0 * square * share * taken_j / step_s).max(0.0).sqrt();
            (0.5 * (linear + root) / square).max(0.5 * before)
        };
        let fed = solved(feeds);
        let mean = if fed < supply_v { fed } else { solved(0.0) };
        let current = ((supply_v - mean) / self.supply_ohm).max(0.0);
        let burnt = if link.chopping { mean * mean / self.brake_ohm } else { 0.0 };
        link.voltage_v = (2.0 * mean - before).max(0.0);
        link.supplied_j += current * supply_v * step_s;
        link.rectifier_j += current * (supply_v - mean) * step_s;
        link.brake_j += burnt * step_s;
    }

    /// Returns the energy in the capacitor \[J\].
    #[cfg(test)]
    pub(crate) fn energy(&self, link: &Link) -> f64 {
        0.5 * self.capacity_f * link.voltage_v * link.voltage_v
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODEL: LinkModel =
        LinkModel { capacity_f: 470e-6, supply_v: 560.0, supply_ohm: 1.0, brake_ohm: 82.0, chopper_v: [627.2, 644.0] };

    /// Input energy equals output and stored energy; the braking resistor keeps the voltage below its threshold.
    #[test]
    fn energy_is_kept_and_the_brake_resistor_bounds_the_voltage() {
        let mut link = MODEL.start();
        let (start, step) = (MODEL.energy(&link), 62.5e-6);
        let mut taken = 0.0;
        let mut highest = 0.0_f64;
        for k in 0..40_000 {
            let power = if k < 16_000 { 900.0 } else { -1500.0 };
            taken += power * step;
            MODEL.step(&mut link, power * step, 1.0, step);
            highest = highest.max(link.voltage_v);
        }
        let balance = link.supplied_j - link.rectifier_j - link.brake_j - taken - (MODEL.energy(&link) - start);
        assert!(balance.abs() < 1e-9 * (link.supplied_j + link.brake_j), "{balance}");
        assert!(highest > 640.0 && highest < 650.0, "{highest}");
    }

    /// Under 900 W the supply voltage drops by R I: 560 − 1.612 V.
    #[test]
    fn a_steady_load_drops_over_the_resistance() {
        let mut link = MODEL.start();
        for _ in 0..10_000 {
            MODEL.step(&mut link, 900.0 * 62.5e-6, 1.0, 62.5e-6);
        }
        let current = 900.0 / link.voltage_v;
        assert!((560.0 - current - link.voltage_v).abs() < 1e-9, "{}", link.voltage_v);
    }
}
