//! Output bearing: tilting moment, life, static safety and tilt (section 7.3).

use provenance::Datum;
use quantities::{Angle, AngularVelocity, Force, Length, Measure, TiltingStiffness, Time, Torque};

/// Type of the output bearing (table 55.1, footnote 1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BearingType {
    /// `C`: crossed roller bearing.
    CrossedRoller,
    /// `F`: four-point contact ball bearing.
    FourPoint,
}

impl BearingType {
    /// Returns B, the life exponent: 10/3 for rollers and 3 for balls.
    ///
    /// # Source
    /// cha-manual table 74.5
    #[must_use]
    pub fn life_exponent(self) -> f64 {
        match self {
            Self::CrossedRoller => 10.0 / 3.0,
            Self::FourPoint => 3.0,
        }
    }
}

/// Data of an output bearing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OutputBearing {
    /// Type of the bearing.
    pub kind: Datum<BearingType>,
    /// d_p: pitch circle diameter.
    pub pitch_diameter: Datum<Length>,
    /// R: offset of the bearing centre from the flange face.
    pub offset: Datum<Length>,
    /// C: dynamic load rating.
    pub dynamic_rating: Datum<Force>,
    /// C_0: static load rating.
    pub static_rating: Datum<Force>,
    /// M_dyn(max): permissible tilting moment of a turning gear, limited by the tilt that the gear permits, not by the
    /// life.
    pub tilting_moment_max: Datum<Torque>,
    /// M_0(max): permissible tilting moment of a gear at rest, without other loads.
    pub static_moment_max: Datum<Torque>,
    /// f_s on which M_0(max) is based: lower limit of the static safety of this size \[1\].
    pub static_safety_min: Datum<f64>,
    /// F_A,dyn(max): permissible dynamic axial load, without other loads.
    pub axial_max: Datum<Force>,
    /// F_R,dyn(max): permissible dynamic radial load, without other loads.
    pub radial_max: Datum<Force>,
    /// K_B: tilting stiffness, mean value.
    pub tilting_stiffness: Datum<TiltingStiffness>,
    /// Swing angle below which the bearing may fret for lack of lubrication.
    pub swing_min: Datum<Angle>,
}

/// Forces on the output flange, constant over the cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlangeLoad {
    /// F_r: radial force.
    pub radial_force: Force,
    /// L_r: distance of the radial force from the flange face, along the axis.
    pub radial_distance: Length,
    /// F_a: axial force.
    pub axial_force: Force,
    /// L_a: distance of the axial force from the axis.
    pub axial_distance: Length,
}

/// Returns the tilting moment on the output bearing.
///
/// M = F_r (L_r + R) + F_a L_a
///
/// # Symbols
/// R offset of the bearing centre from the flange face \[m\] (table 55.1); the other symbols see [`FlangeLoad`]
/// # Source
/// FHA manual of the same manufacturer, selection of the output bearing; R of cha-manual table 55.1
/// # Valid
/// both moments in the same direction, the worst case
#[must_use]
pub fn tilting_moment(load: &FlangeLoad, offset: Length) -> Torque {
    let radial = load.radial_force.si() * (load.radial_distance.si() + offset.si());
    Torque::from_si(radial + load.axial_force.si() * load.axial_distance.si())
}

/// Returns the mean of a load over a cycle, weighted with the angle travelled under it.
///
/// F_av = (Σ |n_k| t_k F_k^B / Σ |n_k| t_k)^(1/B)
///
/// # Symbols
/// n_k speed [1/min], t_k duration \[s\], F_k force \[N\] or moment \[Nm\], B life exponent
/// # Source
/// cha-manual eq. 75.2 (erratum text-7.3.1-n_av for the weight) and 75.3
/// # Valid
/// positive travel; zero without any
#[must_use]
pub fn mean_load(parts: impl Iterator<Item = (f64, Angle)>, exponent: f64) -> f64 {
    let (mut powers, mut travelled, mut largest) = (0.0, 0.0, 0.0_f64);
    let mut equal = true;
    for (load, angle) in parts {
        let weight = angle.si().abs();
        if weight > 0.0 {
            equal &= travelled == 0.0 || load == largest;
            largest = largest.max(load);
            powers += weight * load.powf(exponent);
            travelled += weight;
        }
    }
    // A constant load is its own mean to the last bit.
    if travelled <= 0.0 {
        0.0
    } else if equal {
        largest
    } else {
        (powers / travelled).powf(1.0 / exponent)
    }
}

/// Returns the dynamic equivalent load.
///
/// P_c = x (F_r + 2M/d_p) + y F_a; x = 1, y = 0.45 if F_a / (F_r + 2M/d_p) ≤ 1.5, else x = y = 0.67
///
/// # Source
/// cha-manual eq. 75.1, table 75.4
#[must_use]
pub fn dynamic_equivalent_load(load: &FlangeLoad, moment: Torque, pitch_diameter: Length) -> Force {
    let (x, y, _) = dynamic_load_factors(load, moment, pitch_diameter);
    Force::from_si(x * radial_load(load, moment, pitch_diameter) + y * load.axial_force.si())
}

/// Returns x and y of the dynamic equivalent load, and `true` if F_a / (F_r + 2M/d_p) ≤ 1.5.
///
/// # Source
/// cha-manual table 75.4
#[must_use]
pub fn dynamic_load_factors(load: &FlangeLoad, moment: Torque, pitch_diameter: Length) -> (f64, f64, bool) {
    if load.axial_force.si() <= 1.5 * radial_load(load, moment, pitch_diameter) {
        (1.0, 0.45, true)
    } else {
        (0.67, 0.67, false)
    }
}

/// Returns F_r + 2M/d_p \[N\].
fn radial_load(load: &FlangeLoad, moment: Torque, pitch_diameter: Length) -> f64 {
    load.radial_force.si() + 2.0 * moment.si() / pitch_diameter.si()
}

/// Returns the life L_10 of the output bearing.
///
/// L_10 = 10⁶ / (60 n_av) · (C / (f_w P_c))^B
///
/// A pure oscillation by an angle φ, n_1 times per minute there and back, travels n_1 φ/180° revolutions per minute;
/// with this mean speed eq. 74.3 is the same equation, so that one formula serves both.
///
/// # Symbols
/// n_av mean speed [1/min], C dynamic load rating \[N\], P_c equivalent load \[N\], f_w load factor (table 74.2), B life exponent
/// # Source
/// cha-manual eq. 74.1 and 74.3
/// # Valid
/// n_av > 0 and P_c > 0; oscillations below [`OutputBearing::swing_min`] may cause fretting and are not covered
#[must_use]
pub fn bearing_life(
    dynamic_rating: Force,
    equivalent_load: Force,
    load_factor: f64,
    exponent: f64,
    speed_mean: AngularVelocity,
) -> Time {
    let ratio = dynamic_rating.si() / (load_factor * equivalent_load.si());
    // 10⁶ revolutions, 2π rad each, at the mean speed in rad/s.
    Time::from_si(1e6 * std::f64::consts::TAU / speed_mean.si().abs() * ratio.powf(exponent))
}

/// Returns the static safety of the output bearing.
///
/// f_s = C_0 / P_0, P_0 = F_r + 2M/d_p + 0.44 F_a
///
/// # Source
/// cha-manual eq. 76.1 with x_0 = 1, y_0 = 0.44
/// # Valid
/// P_0 > 0
#[must_use]
pub fn static_safety(static_rating: Force, load: &FlangeLoad, moment: Torque, pitch_diameter: Length) -> f64 {
    static_rating.si() / (radial_load(load, moment, pitch_diameter) + 0.44 * load.axial_force.si())
}

/// Returns the static equivalent tilting moment: the pure tilting moment that loads the bearing at rest as much as
/// forces and moment together.
///
/// M_eq = M + d_p/2 · (F_r + 0.44 F_a)
///
/// # Symbols
/// M tilting moment \[Nm\], d_p pitch circle diameter \[m\], F_r radial and F_a axial force \[N\]
/// # Source
/// cha-manual eq. 76.1 and 76.2: P_0 d_p/2, so that f_s = C_0/P_0 = M_0/M_eq times the f_s of M_0
/// # Valid
/// gear at rest
#[must_use]
pub fn static_equivalent_moment(load: &FlangeLoad, moment: Torque, pitch_diameter: Length) -> Torque {
    let forces = load.radial_force.si() + 0.44 * load.axial_force.si();
    Torque::from_si(moment.si() + 0.5 * pitch_diameter.si() * forces)
}

/// Returns the tilt of the output flange.
///
/// γ = M / K_B
///
/// # Source
/// cha-manual eq. 76.4
#[must_use]
pub fn tilt_angle(moment: Torque, stiffness: TiltingStiffness) -> Angle {
    Angle::from_si(moment.si() / stiffness.si())
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::unit::{ARCMINUTE, HOUR, NEWTON_METRE_PER_ARCMINUTE, REVOLUTION_PER_MINUTE};

    fn load(radial: f64, l_r: f64, axial: f64, l_a: f64) -> FlangeLoad {
        FlangeLoad {
            radial_force: Force::from_si(radial),
            radial_distance: Length::from_si(l_r),
            axial_force: Force::from_si(axial),
            axial_distance: Length::from_si(l_a),
        }
    }

    /// CHA-25A by hand (d_p 0.088, R 0.018, C 30000, B 10/3): F_r 500 N at 50 mm, F_a 200 N at 30 mm.
    /// M = 500·0.068 + 200·0.03 = 40 Nm; P_c = 500 + 80/0.088 + 90 = 1499.09 N;
    /// (30000/(1.2·1499.09))^(10/3) = 16.6769^(3.3333) = 11850; L = 1e6/(60·15)·11850 = 1.3166e7 h.
    #[test]
    fn a_bearing_by_hand() {
        let load = load(500.0, 0.050, 200.0, 0.030);
        let moment = tilting_moment(&load, Length::from_si(0.018));
        assert!((moment.si() - 40.0).abs() < 1e-12);
        let equivalent = dynamic_equivalent_load(&load, moment, Length::from_si(0.088));
        assert!((equivalent.si() - 1_499.090_909).abs() < 1e-5);
        let speed = AngularVelocity::new_in(15.0, &REVOLUTION_PER_MINUTE);
        let life = bearing_life(Force::from_si(30_000.0), equivalent, 1.2, 10.0 / 3.0, speed);
        assert!((life.in_unit(&HOUR) / 1.3166e7 - 1.0).abs() < 1e-3, "{}", life.in_unit(&HOUR));
        let safety = static_safety(Force::from_si(45_000.0), &load, moment, Length::from_si(0.088));
        assert!((safety - 45_000.0 / (500.0 + 909.090_909 + 88.0)).abs() < 1e-6);
        let resting = static_equivalent_moment(&load, moment, Length::from_si(0.088));
        assert!((resting.si() - (40.0 + 0.044 * (500.0 + 88.0))).abs() < 1e-9, "{resting:?}");
        assert!((45_000.0 * 0.044 / resting.si() - safety).abs() < 1e-9, "eq. 76.1 and 76.2 are one");
        let tilt = tilt_angle(moment, TiltingStiffness::new_in(114.0, &NEWTON_METRE_PER_ARCMINUTE));
        assert!((tilt.in_unit(&ARCMINUTE) - 40.0 / 114.0).abs() < 1e-9);
    }

    /// 1000 N over 1 rad, 500 N over 3 rad, B = 3: ((1e9 + 3·1.25e8)/4)^(1/3) = 700.5098 N.
    #[test]
    fn the_mean_load_weighs_with_the_travel() {
        let mean = |parts: &[(f64, f64)], b| mean_load(parts.iter().map(|(f, a)| (*f, Angle::from_si(*a))), b);
        assert!((mean(&[(1000.0, 1.0), (500.0, -3.0)], 3.0) - 700.5098).abs() < 1e-3);
        assert_eq!(mean(&[(123.4, 1.0), (123.4, 7.0)], 10.0 / 3.0), 123.4);
        assert_eq!(mean(&[(1000.0, 0.0)], 3.0), 0.0, "a load at rest does not wear");
    }

    #[test]
    fn the_load_factors_change_at_one_and_a_half() {
        let at = |axial| {
            dynamic_equivalent_load(&load(1000.0, 0.0, axial, 0.0), Torque::from_si(0.0), Length::from_si(0.1)).si()
        };
        assert!((at(1500.0) - (1000.0 + 0.45 * 1500.0)).abs() < 1e-9);
        assert!((at(1501.0) - 0.67 * 2501.0).abs() < 1e-9);
    }

    #[test]
    fn life_falls_with_load_shock_and_speed() {
        let life = |p: f64, f_w: f64, n: f64| {
            bearing_life(Force::from_si(1e4), Force::from_si(p), f_w, 3.0, AngularVelocity::from_si(n)).si()
        };
        for step in 1..20 {
            let x = f64::from(step);
            assert!(life(100.0 * x, 1.2, 1.0) > life(100.0 * (x + 1.0), 1.2, 1.0));
            assert!(life(500.0, 1.0 + 0.1 * x, 1.0) > life(500.0, 1.1 + 0.1 * x, 1.0));
            assert!(life(500.0, 1.2, 0.1 * x) > life(500.0, 1.2, 0.1 * (x + 1.0)));
        }
    }

    /// Eq. 74.3 for an oscillation of φ = 60°, 10 times per minute, compared with eq. 74.1 at its mean speed.
    #[test]
    fn swinging_is_turning_at_the_mean_speed() {
        let (swings_per_min, swing_deg) = (10.0, 60.0);
        let ratio: f64 = 30_000.0 / (1.2 * 1500.0);
        let by_74_3 = 1e6 / (60.0 * swings_per_min) * 180.0 / swing_deg * ratio.powf(10.0 / 3.0);
        let speed = AngularVelocity::new_in(swings_per_min * 2.0 * swing_deg / 360.0, &REVOLUTION_PER_MINUTE);
        let life = bearing_life(Force::from_si(30_000.0), Force::from_si(1500.0), 1.2, 10.0 / 3.0, speed);
        assert!((life.in_unit(&HOUR) / by_74_3 - 1.0).abs() < 1e-12);
    }
}
