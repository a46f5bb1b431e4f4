//! Strain wave gear: torsion, natural frequency, mean torque, life of the wave-generator bearing.

use derivation::Workings;
use provenance::{Datum, Missing, Source, Sourced};
use quantities::unit::{HOUR, REVOLUTION_PER_MINUTE};
use quantities::{
    Angle, AngularVelocity, Frequency, Measure, MomentOfInertia, Time, Torque, TorqueConstant, TorsionalStiffness,
};

/// Data of the gear.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gear {
    /// T_1: end of the first stiffness region.
    pub torque_1: Datum<Torque>,
    /// T_2: end of the second stiffness region.
    pub torque_2: Datum<Torque>,
    /// K_1, K_2, K_3: torsional stiffness of the three regions.
    pub stiffness: [Datum<TorsionalStiffness>; 3],
    /// T_N: rated torque, used as the reference of the life equation only.
    pub rated_torque: Datum<Torque>,
    /// T_A: limit of the cubic mean torque.
    pub average_torque_max: Datum<Torque>,
    /// T_M: limit of the momentary peak torque, in a collision or an emergency stop.
    pub collision_torque_max: Datum<Torque>,
    /// N_0: permitted load cycles of a tooth under the torque of a collision \[1\].
    pub collision_cycles: Datum<f64>,
    /// L_n: nominal life of the wave-generator bearing, reached by half of the gears at T_N and n_N.
    pub nominal_life: Datum<Time>,
    /// n_N: input speed of the nominal life.
    pub life_reference_speed: Datum<AngularVelocity>,
    /// L_50/L_10: ratio of both lives \[1\].
    pub life_ratio: Datum<f64>,
    /// L_10N: life reached by 90 % of the gears at T_N and n_N, where a data sheet states it instead of L_n.
    pub rated_life: Datum<Time>,
    /// Ratcheting torque of a cup-type gear of equal size; for orientation only.
    pub ratcheting_torque: Datum<Torque>,
    /// Buckling torque of the flexspline of a cup-type gear of equal size; for orientation only.
    pub buckling_torque: Datum<Torque>,
    /// n_in,max: largest input speed of the gear.
    pub input_speed_max: Datum<AngularVelocity>,
    /// n_in,av: limit of the mean input speed of the gear.
    pub input_speed_mean_max: Datum<AngularVelocity>,
}

impl Gear {
    /// Returns the torsion curve, if all five values are known.
    #[must_use]
    pub fn torsion(&self) -> Option<Torsion> {
        let [k1, k2, k3] = &self.stiffness;
        Some(Torsion {
            torque_1: self.torque_1.known()?.value,
            torque_2: self.torque_2.known()?.value,
            stiffness: [k1.known()?.value, k2.known()?.value, k3.known()?.value],
        })
    }
}

/// Torsion curve of a gear with blocked input: three linear regions, odd in the torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torsion {
    /// T_1: end of the first region.
    pub torque_1: Torque,
    /// T_2: end of the second region.
    pub torque_2: Torque,
    /// K_1, K_2, K_3: stiffness of the three regions.
    pub stiffness: [TorsionalStiffness; 3],
}

impl Torsion {
    /// Returns the torsion angle of a torque.
    ///
    /// φ = T/K_1 up to T_1, then φ_1 + (T − T_1)/K_2 up to T_2, then φ_2 + (T − T_2)/K_3; odd in T
    ///
    /// # Source
    /// cha-manual eq. 73.1, 73.2, 73.3
    /// # Valid
    /// mean values of many gears, blocked wave generator
    #[must_use]
    pub fn angle(&self, torque: Torque) -> Angle {
        let [k1, k2, k3] = self.stiffness.map(Measure::si);
        let (t1, t2, t) = (self.torque_1.si(), self.torque_2.si(), torque.si().abs());
        let angle = t.min(t1) / k1 + (t.min(t2) - t1).max(0.0) / k2 + (t - t2).max(0.0) / k3;
        Angle::from_si(angle.copysign(torque.si()))
    }

    /// Returns the torque that twists the gear by an angle: the inverse of [`Torsion::angle`].
    #[must_use]
    pub fn torque(&self, angle: Angle) -> Torque {
        let [k1, k2, k3] = self.stiffness.map(Measure::si);
        let (phi1, phi2) = (self.angle(self.torque_1).si(), self.angle(self.torque_2).si());
        let phi = angle.si().abs();
        let torque = phi.min(phi1) * k1 + (phi.min(phi2) - phi1).max(0.0) * k2 + (phi - phi2).max(0.0) * k3;
        Torque::from_si(torque.copysign(angle.si()))
    }
}

/// Returns the first natural frequency of a load on the gear with blocked motor.
///
/// f = (1/2π) √(K / J_L)
///
/// # Symbols
/// K torsional stiffness of a region [Nm/rad], J_L inertia of the load \[kgm²\]
/// # Source
/// docs/theory/gear.md, the oscillator of one mass and one spring
/// # Valid
/// J_L > 0; no damping
#[must_use]
pub fn natural_frequency(stiffness: TorsionalStiffness, inertia: MomentOfInertia) -> Frequency {
    Frequency::from_si((stiffness.si() / inertia.si()).sqrt() / std::f64::consts::TAU)
}

/// Returns the first natural frequency of a load and a free rotor oscillating against each other on the gear.
///
/// f = (1/2π) √(K (J_L + J_R)/(J_L J_R))
///
/// # Symbols
/// K torsional stiffness of a region [Nm/rad], J_L inertia of the load, J_R inertia of the rotor at the output, J_out
/// of the tables \[kgm²\]
/// # Source
/// docs/theory/gear.md, the oscillator of two masses and one spring
/// # Valid
/// J_L > 0, J_R > 0; no damping; J_R → ∞ is the blocked rotor of [`natural_frequency`]
#[must_use]
pub fn natural_frequency_free(
    stiffness: TorsionalStiffness,
    load: MomentOfInertia,
    rotor: MomentOfInertia,
) -> Frequency {
    let compliant = 1.0 / load.si() + 1.0 / rotor.si();
    Frequency::from_si((stiffness.si() * compliant).sqrt() / std::f64::consts::TAU)
}

/// Returns the cubic mean torque of a cycle from the angle travelled under each torque.
///
/// T_av = (Σ |T_j|³ |n_j| t_j / Σ |n_j| t_j)^(1/3)
///
/// # Source
/// csd-2a-engineering-data, selection of the gear; T_av ≤ T_A
/// # Valid
/// torque constant over each part of the motion; zero without motion
#[must_use]
pub fn cubic_mean_torque(parts: impl Iterator<Item = (Torque, Angle)>) -> Torque {
    let (mut cubes, mut travelled) = (0.0, 0.0);
    for (torque, angle) in parts {
        cubes += torque.si().abs().powi(3) * angle.si().abs();
        travelled += angle.si().abs();
    }
    Torque::from_si(if travelled > 0.0 { (cubes / travelled).cbrt() } else { 0.0 })
}

/// Law of the life of the wave-generator bearing.
///
/// L_50 = L_n (n_N / n_in,av) (T_N / T_av)³, L_10 = L_50 / r; or L_10 = L_10N (n_N / n_in,av) (T_N / T_av)³
///
/// # Symbols
/// n_in,av mean input speed, T_N rated torque, T_av cubic mean torque, L_n, L_10N, n_N and r see [`Gear`]
/// # Source
/// csd-2a-engineering-data
/// # Valid
/// n_in,av > 0 and T_av > 0
#[derive(Clone, Debug)]
pub struct LifeLaw {
    /// L_n, or L_10N.
    nominal: Sourced<Time>,
    reference_speed: Sourced<AngularVelocity>,
    /// L_50/L_10 if the nominal life is the one reached by half of the gears; `None` if it is L_10N.
    ratio: Option<Sourced<f64>>,
}

impl LifeLaw {
    /// Creates the law of a gear: by L_10N if it is known, else by L_n and r.
    ///
    /// # Errors
    /// [`Missing`] with the first unknown constant.
    pub fn of(gear: &Gear) -> Result<Self, Missing> {
        let (nominal, ratio) = match gear.rated_life.known() {
            Some(rated) => (rated, None),
            None => (gear.nominal_life.require("L_n")?, Some(gear.life_ratio.require("life_ratio_50_10")?.clone())),
        };
        let reference_speed = gear.life_reference_speed.require("n_N_gear")?.clone();
        Ok(Self { nominal: nominal.clone(), reference_speed, ratio })
    }

    /// Returns the nominal life scaled to a speed and a torque.
    fn scaled(&self, rated: Torque, mean: Torque, speed_in_mean: AngularVelocity) -> Time {
        let speed_rpm = speed_in_mean.si().abs() * 60.0 / std::f64::consts::TAU;
        let (nominal, reference) =
            (self.nominal.value.in_unit(&HOUR), self.reference_speed.value.in_unit(&REVOLUTION_PER_MINUTE));
        let hours = nominal * reference / speed_rpm * (rated.si() / mean.si()).powi(3);
        Time::from_si(hours * 3600.0)
    }

    /// Returns the life reached by 90 % of the gears.
    #[must_use]
    pub fn l10(&self, rated: Torque, mean: Torque, speed_in_mean: AngularVelocity) -> Time {
        let ratio = self.ratio.as_ref().map_or(1.0, |ratio| ratio.value);
        Time::from_si(self.scaled(rated, mean, speed_in_mean).si() / ratio)
    }

    /// Returns [`LifeLaw::l10`] with its derivation; the result is `L_10`, computed from `T_N`, `T_av` and `n_in`,
    /// which the caller has recorded.
    #[must_use]
    pub fn l10_with(&self, rated: Torque, mean: Torque, speed_in_mean: AngularVelocity, work: &mut Workings) -> Time {
        let life = self.l10(rated, mean, speed_in_mean);
        if work.is_on() {
            let source = Source::Model { name: "gear" };
            work.given(if self.ratio.is_some() { "L_n" } else { "L_10N" }, &HOUR, &self.nominal);
            work.given("n_N_gear", &REVOLUTION_PER_MINUTE, &self.reference_speed);
            if let Some(ratio) = &self.ratio {
                work.given_number("r_L", ratio);
                let half = self.scaled(rated, mean, speed_in_mean);
                work.formula("L_50", &HOUR, half.si(), "L_n*n_N_gear/n_in*(T_N/T_av)^3", &source);
                work.formula("L_10", &HOUR, life.si(), "L_50/r_L", &source);
            } else {
                work.formula("L_10", &HOUR, life.si(), "L_10N*n_N_gear/n_in*(T_N/T_av)^3", &source);
            }
        }
        life
    }
}

/// Returns the permitted number of collisions.
///
/// N = N_0 / (2 n i t / 60), at most N_0
///
/// # Symbols
/// N_0 load cycles of a tooth under such a torque, see [`Gear::collision_cycles`], n output speed during the collision
/// [1/min], i ratio, t duration of one collision \[s\]
/// # Source
/// csd-2a-engineering-data, momentary peak torque
/// # Valid
/// T ≤ T_M; N_0 also for a collision without motion
#[must_use]
pub fn collision_count_max(cycles: f64, speed_out: AngularVelocity, ratio: f64, duration: Time) -> f64 {
    let turns_in = speed_out.si().abs() * ratio * duration.si() / std::f64::consts::TAU;
    // The wave generator has two lobes, so that each turn loads a tooth twice.
    (cycles / (2.0 * turns_in)).min(cycles)
}

/// Returns the output speed at which the wave generator excites a natural frequency.
///
/// 2 i n / 60 = f
///
/// # Symbols
/// n output speed [1/min], i ratio, f natural frequency \[Hz\]
/// # Source
/// docs/theory/gear.md; the two lobes of the wave generator excite twice per turn
/// # Valid
/// i > 0
#[must_use]
pub fn resonance_speed(frequency: Frequency, ratio: f64) -> AngularVelocity {
    AngularVelocity::from_si(std::f64::consts::PI * frequency.si() / ratio)
}

/// Returns the motor current per torque while the load drives, relative to that while driving \[1\]: η (2 − 1/η) = 2η −
/// 1.
///
/// The gear loses the same share of the torque in both directions: driving T_mot i = T/η, driven T_mot i = T (2 − 1/η).
///
/// # Symbols
/// η = k_Tout/(i k_TM), at most one: a rounded k_TM may yield more
/// # Source
/// docs/theory/energy.md; loss proportional to the torque
/// # Valid
/// η ≥ ½; below that the gear is self-locking and no power returns
#[must_use]
pub fn driven_share(out: TorqueConstant, motor: TorqueConstant, ratio: f64) -> f64 {
    let efficiency = (out.si() / (ratio * motor.si())).min(1.0);
    (2.0 * efficiency - 1.0).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::unit::{ARCMINUTE, HOUR, REVOLUTION_PER_MINUTE};

    /// CanisDrive-32A-100 of the manual's example.
    fn torsion() -> Torsion {
        Torsion {
            torque_1: Torque::from_si(29.0),
            torque_2: Torque::from_si(108.0),
            stiffness: [6.7e4, 1.1e5, 1.2e5].map(TorsionalStiffness::from_si),
        }
    }

    /// cha-manual, example of section 7.2: 60 Nm, 7.15e-4 rad, in the manual 2.5 arcmin.
    #[test]
    fn the_worked_example_of_the_torsion() {
        let angle = torsion().angle(Torque::from_si(60.0));
        assert!((angle.si() - 7.15e-4).abs() < 0.005e-4);
        assert!((angle.in_unit(&ARCMINUTE) - 2.46).abs() < 0.005);
    }

    #[test]
    fn the_curve_is_continuous_odd_and_rising_and_its_inverse_undoes_it() {
        let curve = torsion();
        for border in [29.0, 108.0] {
            let below = curve.angle(Torque::from_si(border * (1.0 - 1e-12))).si();
            let above = curve.angle(Torque::from_si(border * (1.0 + 1e-12))).si();
            assert!((below - above).abs() < 1e-12);
        }
        let mut last = f64::NEG_INFINITY;
        for step in -400..=400 {
            let torque = Torque::from_si(f64::from(step));
            let angle = curve.angle(torque);
            assert!(angle.si() > last);
            assert!((curve.torque(angle).si() - torque.si()).abs() < 1e-9);
            assert!((curve.angle(Torque::from_si(-torque.si())).si() + angle.si()).abs() < 1e-15);
            last = angle.si();
        }
    }

    #[test]
    fn a_stiff_gear_does_not_oscillate_slowly() {
        let f = |k, j| natural_frequency(TorsionalStiffness::from_si(k), MomentOfInertia::from_si(j)).si();
        assert!((f(4.0 * std::f64::consts::PI.powi(2), 1.0) - 1.0).abs() < 1e-12);
        assert!((f(4e4, 1.0) / f(1e4, 1.0) - 2.0).abs() < 1e-12);
    }

    /// Two equal masses oscillate about the centre of the spring, each on twice its stiffness: √2 times the blocked
    /// frequency. A rotor of very large inertia acts as blocked; the frequency does not change if load and rotor are
    /// exchanged.
    #[test]
    fn a_free_rotor_swings_against_the_load() {
        let free = |k, j, r| {
            let inertia = MomentOfInertia::from_si;
            natural_frequency_free(TorsionalStiffness::from_si(k), inertia(j), inertia(r)).si()
        };
        let blocked = |k, j| natural_frequency(TorsionalStiffness::from_si(k), MomentOfInertia::from_si(j)).si();
        assert!((free(1e4, 1.3, 1.3) / blocked(1e4, 1.3) - 2.0_f64.sqrt()).abs() < 1e-14);
        assert!((free(1e4, 1.3, 1e12) / blocked(1e4, 1.3) - 1.0).abs() < 1e-12);
        assert!((free(1e4, 1.3, 0.4) - free(1e4, 0.4, 1.3)).abs() < 1e-12);
        // Newton's equations, stepped: K = 4e4, J_L = 1, J_R = 0.25, released with the spring twisted by 1 rad.
        let (k, j, r, h) = (4e4_f64, 1.0, 0.25, 1e-7);
        let (mut a, mut b, mut va, mut vb, mut t) = (0.2, -0.8, 0.0, 0.0, 0.0);
        // The spring is relaxed after a quarter of a period.
        while a - b > 0.0 {
            let torque = k * (a - b);
            va -= torque / j * h;
            vb += torque / r * h;
            a += va * h;
            b += vb * h;
            t += h;
        }
        assert!((4.0 * t * free(k, j, r) - 1.0).abs() < 1e-4, "{t}");
    }

    /// Selection example of the gear catalogues: 400 Nm at 7, 320 at 14, 200 at 7 1/min for 0.3, 3.0, 0.4 s: 319.74 Nm,
    /// 319 in the catalogue.
    #[test]
    fn the_mean_torque_of_the_catalogue_example() {
        let parts = [(400.0, 7.0 * 0.3), (320.0, 14.0 * 3.0), (200.0, 7.0 * 0.4)];
        let mean = cubic_mean_torque(parts.into_iter().map(|(t, a)| (Torque::from_si(t), Angle::from_si(a))));
        assert!((mean.si() - 319.74).abs() < 0.005, "{}", mean.si());
        assert!(cubic_mean_torque(std::iter::empty()).si().abs() < 1e-15);
    }

    /// L_n = 35 000 h at 2000 1/min, L_50/L_10 = 5.
    fn law() -> LifeLaw {
        fn known<T>(value: T) -> Sourced<T> {
            let source = Source::Model { name: "gear" };
            Sourced { value, source, grade: provenance::Grade::Published, errata: &[] }
        }
        LifeLaw {
            nominal: known(Time::new_in(35_000.0, &HOUR)),
            reference_speed: known(AngularVelocity::new_in(2000.0, &REVOLUTION_PER_MINUTE)),
            ratio: Some(known(5.0)),
        }
    }

    /// At rated torque and reference speed the gear reaches L_n/5 = 7000 h; at twice the torque an eighth of it.
    #[test]
    fn the_life_at_the_reference_point() {
        let speed = AngularVelocity::new_in(2000.0, &REVOLUTION_PER_MINUTE);
        let life = |mean| law().l10(Torque::from_si(25.0), Torque::from_si(mean), speed).in_unit(&HOUR);
        assert!((life(25.0) - 7000.0).abs() < 1e-6);
        assert!((life(50.0) - 875.0).abs() < 1e-6);
    }

    /// 5 1/min at the output, i = 100, 0.15 s: 10⁴ / (2 · 5 · 100 · 0.15 / 60) = 4000; never more than 10⁴.
    #[test]
    fn the_number_of_collisions_by_hand() {
        let speed = |n| AngularVelocity::new_in(n, &REVOLUTION_PER_MINUTE);
        let count = |n, t| collision_count_max(1e4, speed(n), 100.0, Time::from_si(t));
        assert!((count(5.0, 0.15) - 4000.0).abs() < 1e-9);
        assert!((count(-5.0, 0.15) - 4000.0).abs() < 1e-9);
        assert_eq!(count(0.0, 0.15), 1e4);
        assert_eq!(count(0.1, 0.01), 1e4);
    }

    /// 2 · 100 · 6 / 60 = 20 Hz.
    #[test]
    fn the_wave_generator_pushes_twice_a_turn() {
        let speed = resonance_speed(Frequency::from_si(20.0), 100.0);
        assert!((speed.in_unit(&REVOLUTION_PER_MINUTE) - 6.0).abs() < 1e-9);
    }

    #[test]
    fn half_of_the_gears_live_five_times_as_long() {
        let speed = AngularVelocity::new_in(2000.0, &REVOLUTION_PER_MINUTE);
        let rated = Torque::from_si(25.0);
        assert!((law().scaled(rated, rated, speed).in_unit(&HOUR) - 35_000.0).abs() < 1e-6);
    }
}
