//! Temperatures of winding and housing: a linear chain of two nodes to the ambient air.

use quantities::{Measure, Power, ThermodynamicTemperature, Time};

/// Temperatures of the two nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Temperatures {
    /// Temperature of the winding.
    pub winding: ThermodynamicTemperature,
    /// Temperature of the housing.
    pub housing: ThermodynamicTemperature,
}

/// Losses at one instant, or their mean, by place of origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Losses {
    /// Copper loss, in the winding \[W\].
    pub copper_w: f64,
    /// Friction of motor and gear, in the housing \[W\].
    pub friction_w: f64,
}

/// Contributions of the modes of the network to a temperature \[K/W\], the fast mode first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gains {
    /// Contributions per copper loss.
    pub copper: [f64; 2],
    /// Contributions per friction loss.
    pub friction: [f64; 2],
}

/// Heat flows at an instant, and the resulting rates of both temperatures.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HeatFlows {
    /// Heat flow from the winding to the housing \[W\].
    pub winding_to_housing_w: f64,
    /// Heat flow from the housing to the ambient air \[W\].
    pub housing_to_ambient_w: f64,
    /// ϑ_w': rate of the winding temperature \[K/s\].
    pub winding_k_per_s: f64,
    /// ϑ_h': rate of the housing temperature \[K/s\].
    pub housing_k_per_s: f64,
}

/// Thermal network of winding and housing.
///
/// C_w ϑ_w' = P_cu − (ϑ_w − ϑ_h)/R_wh, C_h ϑ_h' = P_f + (ϑ_w − ϑ_h)/R_wh − (ϑ_h − ϑ_a)/R_ha
///
/// # Symbols
/// ϑ_w, ϑ_h, ϑ_a temperatures of winding, housing and ambient air, P_cu copper loss, P_f friction \[W\],
/// R_wh, R_ha thermal resistances \[K/W\], C_w = τ_w/R_wh, C_h = τ_h/R_ha heat capacities \[J/K\]
/// # Source
/// docs/theory/thermal.md
/// # Valid
/// mounted on the plate of table 13.3; constant resistances
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Network {
    /// R_wh, R_ha \[K/W\]
    resistance_k_per_w: [f64; 2],
    /// C_w, C_h \[J/K\]
    capacity_j_per_k: [f64; 2],
    /// Time constants of the two modes \[s\], the fast one first.
    tau_s: [f64; 2],
    winding: Gains,
    housing: Gains,
}

impl Network {
    /// Creates a network with these resistances and the time constants τ_w = R_wh C_w, τ_h = R_ha C_h.
    #[must_use]
    pub fn new([r_wh, r_ha]: [f64; 2], [tau_w, tau_h]: [Time; 2]) -> Self {
        let (tau_w, tau_h) = (tau_w.si(), tau_h.si());
        let (c_w, c_h) = (tau_w / r_wh, tau_h / r_ha);
        // w' = P/C_w − a (w − h), h' = c (w − h) − d h
        let (a, c, d) = (1.0 / tau_w, 1.0 / (r_wh * c_h), 1.0 / tau_h);
        let half = (a + c + d) / 2.0;
        let quick = -half - (half * half - a * d).sqrt();
        // The product of both is a d; the quotient avoids cancellation in the slow one.
        let slow = a * d / quick;
        let tau_s = [-1.0 / quick, -1.0 / slow];
        let [tau_quick, tau_slow] = tau_s;
        let gains =
            |residue: &dyn Fn(f64, f64) -> f64| [residue(quick, slow) * tau_quick, residue(slow, quick) * tau_slow];
        // The network is reciprocal: heating the housing affects the winding as heating the winding affects the
        // housing.
        let across = gains(&|own, other| c / (c_w * (own - other)));
        Self {
            resistance_k_per_w: [r_wh, r_ha],
            capacity_j_per_k: [c_w, c_h],
            tau_s,
            winding: Gains { copper: gains(&|own, other| (own + c + d) / (c_w * (own - other))), friction: across },
            housing: Gains { copper: across, friction: gains(&|own, other| (own + a) / (c_h * (own - other))) },
        }
    }

    /// Returns R_wh and R_ha \[K/W\].
    #[must_use]
    pub const fn resistances_k_per_w(&self) -> [f64; 2] {
        self.resistance_k_per_w
    }

    /// Returns the heat flows at an instant, and the resulting rates of the temperatures.
    ///
    /// # Source
    /// docs/theory/thermal.md; the equations of [`Network`]
    #[must_use]
    pub fn flows(&self, state: &Temperatures, losses: Losses, ambient: ThermodynamicTemperature) -> HeatFlows {
        let ([r_wh, r_ha], [c_w, c_h]) = (self.resistance_k_per_w, self.capacity_j_per_k);
        let (winding, housing) = (state.winding.si(), state.housing.si());
        let winding_to_housing_w = (winding - housing) / r_wh;
        let housing_to_ambient_w = (housing - ambient.si()) / r_ha;
        HeatFlows {
            winding_to_housing_w,
            housing_to_ambient_w,
            winding_k_per_s: (losses.copper_w - winding_to_housing_w) / c_w,
            housing_k_per_s: (losses.friction_w + winding_to_housing_w - housing_to_ambient_w) / c_h,
        }
    }

    /// Returns the time constants of the two modes, the fast one first.
    #[must_use]
    pub fn time_constants(&self) -> [Time; 2] {
        self.tau_s.map(Time::from_si)
    }

    /// Returns the contributions of the modes to the temperature of the winding.
    #[must_use]
    pub const fn winding(&self) -> Gains {
        self.winding
    }

    /// Returns the contributions of the modes to the temperature of the housing.
    #[must_use]
    pub const fn housing(&self) -> Gains {
        self.housing
    }

    /// Returns the steady temperatures under constant losses.
    ///
    /// ϑ_h = ϑ_a + (P_cu + P_f) R_ha, ϑ_w = ϑ_h + P_cu R_wh
    ///
    /// # Source
    /// docs/theory/thermal.md
    #[must_use]
    pub fn steady(&self, losses: Losses, ambient: ThermodynamicTemperature) -> Temperatures {
        let [r_wh, r_ha] = self.resistance_k_per_w;
        let housing = ambient.si() + (losses.copper_w + losses.friction_w) * r_ha;
        Temperatures {
            winding: ThermodynamicTemperature::from_si(housing + losses.copper_w * r_wh),
            housing: ThermodynamicTemperature::from_si(housing),
        }
    }

    /// Returns the rise of the winding per watt of copper loss and of friction at the end of each operation of an
    /// intermittent duty in steady periodic state \[K/W\].
    ///
    /// Σ_k G_k (1 − e^(−ED T_c/τ_k))/(1 − e^(−T_c/τ_k)); for ED = 1 the resistances R_wh + R_ha and R_ha
    ///
    /// # Symbols
    /// ED duty factor, T_c cycle \[s\]
    /// # Source
    /// docs/theory/thermal.md
    /// # Valid
    /// 0 < ED ≤ 1, T_c > 0; rest without loss
    #[must_use]
    pub fn intermittent(&self, duty: f64, cycle: Time) -> (f64, f64) {
        let share = self.tau_s.map(|tau| (-duty * cycle.si() / tau).exp_m1() / (-cycle.si() / tau).exp_m1());
        let sum = |gains: [f64; 2]| gains.iter().zip(share).map(|(gain, share)| gain * share).sum();
        (sum(self.winding.copper), sum(self.winding.friction))
    }

    /// Returns the time from ambient temperature until the winding reaches a threshold under constant losses; `None` if
    /// it never does.
    ///
    /// ϑ_w(t) = ϑ_a + Σ_k (G_cu,k P_cu + G_f,k P_f)(1 − e^(−t/τ_k)), rising
    ///
    /// # Source
    /// docs/theory/thermal.md
    #[must_use]
    pub fn warm_up_time(
        &self,
        losses: Losses,
        ambient: ThermodynamicTemperature,
        threshold: ThermodynamicTemperature,
    ) -> Option<Time> {
        let wanted = threshold.si() - ambient.si();
        if wanted <= 0.0 {
            return Some(Time::from_si(0.0));
        }
        let rise = |k: usize| {
            let of = |gains: [f64; 2]| gains.get(k).copied().unwrap_or(0.0);
            losses.copper_w * of(self.winding.copper) + losses.friction_w * of(self.winding.friction)
        };
        let ([quick, slow], [tau_quick, tau_slow]) = ([rise(0), rise(1)], self.tau_s);
        // Written with the distance from the steady state, which avoids cancellation near the end.
        let left_at_end = quick + slow - wanted;
        if left_at_end.is_nan() || left_at_end <= 0.0 {
            return None;
        }
        let left = |t: f64| quick * (-t / tau_quick).exp() + slow * (-t / tau_slow).exp();
        let mut high = tau_slow;
        while left(high) > left_at_end {
            high *= 2.0;
            if high > 1e6 * tau_slow {
                return None;
            }
        }
        let above = |t: f64| left(t) - left_at_end;
        Some(Time::from_si(numeric::root(above, (0.0, above(0.0)), (high, above(high)), 0.0)))
    }

    /// Returns the temperatures at the start of each piece of a periodic cycle of constant losses.
    ///
    /// Each mode is a first-order lag whose steady periodic state is a closed form.
    ///
    /// # Symbols
    /// pieces: duration and losses, constant on each piece
    /// # Source
    /// docs/theory/thermal.md
    #[must_use]
    pub fn course(&self, pieces: &[(Time, Losses)], ambient: ThermodynamicTemperature) -> Vec<Temperatures> {
        let lags = |pick: fn(&Losses) -> f64| {
            let plain: Vec<(f64, f64)> =
                pieces.iter().map(|(duration, losses)| (duration.si(), pick(losses))).collect();
            self.tau_s.map(|tau| crate::overload::periodic_lag(&plain, tau))
        };
        let ([cu_quick, cu_slow], [f_quick, f_slow]) = (lags(|l| l.copper_w), lags(|l| l.friction_w));
        let states = cu_quick.into_iter().zip(cu_slow).zip(f_quick.into_iter().zip(f_slow));
        states
            .map(|(copper, friction)| {
                let rise = |gains: &Gains| {
                    let ([a, b], [c, d]) = (gains.copper, gains.friction);
                    let sum = a * copper.0 + b * copper.1 + c * friction.0 + d * friction.1;
                    ThermodynamicTemperature::from_si(ambient.si() + sum)
                };
                Temperatures { winding: rise(&self.winding), housing: rise(&self.housing) }
            })
            .collect()
    }
}

/// Sum of the losses.
impl Losses {
    /// Returns the sum of both losses.
    #[must_use]
    pub fn total(&self) -> Power {
        Power::from_si(self.copper_w + self.friction_w)
    }
}

#[cfg(test)]
#[path = "temperature_tests.rs"]
mod tests;
