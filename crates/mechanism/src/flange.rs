//! Loads on the output flange: radial and axial force, and tilting moment.

use crate::equations::Equations;
use crate::{Endless, Extra, Mechanism, Output, StageKind, gravity_m_s2};
use quantities::{Angle, Force, Length, Mass, Measure, Torque};

/// Transmission of force by a wheel on the flange.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// A belt wrapped halfway around a pulley, both spans parallel.
    Belt {
        /// F_v: tension of each span at rest.
        tension: Force,
    },
    /// Teeth that mesh with a rack or a gear.
    Mesh {
        /// α_n: pressure angle in the normal section.
        pressure_angle: Angle,
        /// β_z: helix angle, zero for spur teeth.
        helix_angle: Angle,
    },
}

/// Mounting of the load on the flange. Values not stated are not guessed: see [`Mechanism::missing_for_forces`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mounting {
    /// L: axial distance of the centre of mass, or of the centre of pulley, pinion or crank pin, from the flange face,
    /// positive away from the actuator.
    pub overhang: Option<Length>,
    /// L_p: axial distance of the payload's centre of mass from the flange face.
    pub payload_overhang: Option<Length>,
    /// Share of the forces borne by the flange \[1\]; other bearings bear the rest.
    pub share: Option<f64>,
    /// Transmission of force by the wheel.
    pub contact: Option<Contact>,
    /// m_w: mass of parts that turn with the flange but are not included in the mechanism: pulley, pinion, crank.
    pub wheel_mass: Option<Mass>,
    /// β: tilt of the axis from the vertical, for the weight of the wheel and of the roll of a winder; a rotor has a
    /// tilt of its own.
    pub axis_tilt: Option<Angle>,
}

/// Forces of the load on the flange at one instant, in SI.
///
/// In the plane of the flange, the first direction is horizontal, as is the zero of a rotor's angle, and the second is
/// the steepest upwards; the third is along the axis, away from the actuator.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FlangeForces {
    /// F_x, F_y: force in the plane of the flange \[N\].
    pub radial_n: [f64; 2],
    /// F_z: force along the axis \[N\].
    pub axial_n: f64,
    /// M_x, M_y: tilting moment about the centre of the flange face \[Nm\].
    pub moment_nm: [f64; 2],
    /// Amounts without a stated direction, added in the worst case.
    pub aligned: Aligned,
}

/// Amounts that add to those of the vectors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Aligned {
    /// Force in the plane of the flange \[N\].
    pub radial_n: f64,
    /// Force along the axis \[N\].
    pub axial_n: f64,
    /// Σ F L of the radial forces, each with its axial distance from the flange face, positive away from the actuator
    /// \[Nm\].
    pub moment_nm: f64,
    /// Tilting moment of couples, independent of the centre \[Nm\].
    pub couple_nm: f64,
}

impl FlangeForces {
    /// Returns F_r, the radial force \[N\].
    #[must_use]
    pub fn radial(&self) -> f64 {
        let [x, y] = self.radial_n;
        // Force components never approach the limits of floating-point numbers, so the plain root suffices.
        (x * x + y * y).sqrt() + self.aligned.radial_n
    }

    /// Returns F_a, the axial force \[N\].
    #[must_use]
    pub fn axial(&self) -> f64 {
        self.axial_n.abs() + self.aligned.axial_n
    }

    /// Returns M, the tilting moment about a centre behind the flange face \[Nm\].
    ///
    /// M = |M_0 + R e_z × F| + |M_al + R F_al| + M_c
    ///
    /// # Symbols
    /// M_0 moment about the centre of the flange face \[Nm\], R distance of the centre behind it \[m\], F force \[N\],
    /// index al amounts without direction, M_c couples. A force at the distance L has the lever |L + R|, for negative L
    /// too
    /// # Source
    /// docs/theory/flange-loads.md
    #[must_use]
    pub fn moment(&self, offset: Length) -> f64 {
        let (r, [fx, fy], [mx, my]) = (offset.si(), self.radial_n, self.moment_nm);
        let (x, y) = (without_rounding(mx, -r * fy), without_rounding(my, r * fx));
        let Aligned { radial_n, moment_nm, couple_nm, .. } = self.aligned;
        (x * x + y * y).sqrt() + without_rounding(moment_nm, r * radial_n).abs() + couple_nm
    }

    /// Adds a force acting at a point, given by its distances from the axis and from the flange face \[m\].
    pub(crate) fn act(&mut self, [x, y, z]: [f64; 3], [fx, fy, fz]: [f64; 3]) {
        let [rx, ry] = &mut self.radial_n;
        *rx += fx;
        *ry += fy;
        self.axial_n += fz;
        let [mx, my] = &mut self.moment_nm;
        *mx += y * fz - z * fy;
        *my += z * fx - x * fz;
    }

    fn times(mut self, factor: f64) -> Self {
        let aligned = &mut self.aligned;
        let all = self.radial_n.iter_mut().chain(&mut self.moment_nm).chain([&mut self.axial_n]);
        let Aligned { radial_n, axial_n, moment_nm, couple_nm } = aligned;
        all.chain([radial_n, axial_n, moment_nm, couple_nm]).for_each(|v| *v *= factor);
        self
    }
}

/// Data required for the forces of a mechanism on the flange.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FlangeDatum {
    /// Share of a thrust that the flange bears.
    FlangeShare,
    /// Transmission of force by the wheel.
    BeltTension,
}

/// Distances from the flange required for the tilting moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Overhang {
    /// Distance of the mechanism itself; a wheel with a mass always needs it.
    pub(crate) of_mechanism: bool,
    /// Distance of the payload, if a segment carries one.
    pub(crate) of_payload: bool,
}

/// Dependence of the flange loads on the position of the mechanism, at equal speed and acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recurrence {
    /// Independent of the position.
    Constant,
    /// Repeating with each revolution of the mechanism.
    EachRevolution,
    /// Dependent on the position without repetition.
    Never,
}

impl Recurrence {
    /// Returns the recurrence of loads that repeat with each revolution if they depend on the position at all.
    pub(crate) const fn each_revolution_if(depends: bool) -> Self {
        if depends { Self::EachRevolution } else { Self::Constant }
    }

    /// Returns the recurrence of loads that never repeat if they depend on the position at all.
    pub(crate) const fn never_if(depends: bool) -> Self {
        if depends { Self::Never } else { Self::Constant }
    }
}

/// Properties of the load of a mechanism on the flange.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct OnFlange {
    /// Data required for the forces.
    pub(crate) missing: Option<FlangeDatum>,
    /// Distances required in addition for the tilting moment.
    pub(crate) overhang: Overhang,
    /// Dependence of the loads on the position.
    pub(crate) recurrence: Recurrence,
}

/// State of a mechanism on its flange at one instant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instant<'a> {
    pub(crate) output: &'a Output,
    pub(crate) extra: &'a Extra,
    /// Recorded torque \[Nm\].
    pub(crate) recorded_nm: f64,
    pub(crate) mounting: &'a Mounting,
    pub(crate) efficiency_driving: f64,
}

impl Instant<'_> {
    /// Returns the amount of a force before the losses: divided by the efficiency while driving, in full while driven,
    /// because it is not known where the losses occur.
    pub(crate) fn before_losses(&self, force: f64, direction: f64) -> f64 {
        if force * direction > 0.0 { force.abs() / self.efficiency_driving } else { force.abs() }
    }

    /// Returns the torque of the parts moving along a line \[Nm\], with the additions of the segment to the line only.
    pub(crate) fn line_torque(&self, line: &impl Equations) -> f64 {
        let of_line = Extra { mass: self.extra.mass, force: self.extra.force, ..Extra::none() };
        let reduced = line.reduced(self.output.position_rad, &of_line);
        let (omega, alpha) = (self.output.speed_rad_s, self.output.acceleration_rad_s2);
        reduced.inertia * alpha + 0.5 * reduced.slope * omega * omega + reduced.holding + self.recorded_nm
    }
}

/// Returns cos β, with the residue of a rounded right angle set to zero.
pub(crate) fn cosine(angle: Angle) -> f64 {
    let cosine = angle.si().cos();
    if cosine.abs() < 1e-12 { 0.0 } else { cosine }
}

/// Returns sin β, with the residue of a rounded straight angle set to zero.
pub(crate) fn sine(angle: Angle) -> f64 {
    let sine = angle.si().sin();
    if sine.abs() < 1e-12 { 0.0 } else { sine }
}

pub(crate) fn metres(length: Option<Length>) -> f64 {
    length.map_or(0.0, Measure::si)
}

impl Mechanism {
    /// Returns `true` if the masses and forces of the flange load are described; with a stage the torque suffices.
    #[must_use]
    pub fn knows_flange_forces(&self) -> bool {
        self.stage.is_some() || self.kind.equations().on_flange().is_some()
    }

    /// Returns the dependence of the flange loads on the position, at equal speed and acceleration. With a stage the
    /// flange bears the torque of the mechanism.
    #[must_use]
    pub fn flange_recurrence(&self) -> Recurrence {
        if self.stage.is_none() {
            return self.kind.equations().on_flange().map_or(Recurrence::Constant, |on_flange| on_flange.recurrence);
        }
        match self.endless() {
            Endless::EachRevolution => Recurrence::each_revolution_if(self.depends_on_position()),
            Endless::Everywhere | Endless::Never => Recurrence::never_if(self.depends_on_position()),
        }
    }

    /// Returns the key of a datum missing for the forces on the flange; `None` if there is none.
    #[must_use]
    pub fn missing_for_forces(&self, mounting: &Mounting) -> Option<&'static str> {
        if let Some(stage) = &self.stage {
            let diameter = stage.pitch_diameter.is_none().then_some("stage.pitch_diameter");
            let contact = |key| mounting.contact.is_none().then_some(key);
            return match stage.kind {
                StageKind::Coupling => None,
                StageKind::Belt => diameter.or_else(|| contact("bearing.belt_tension")),
                StageKind::Gear => diameter.or_else(|| contact("bearing.pressure_angle")),
            };
        }
        match self.kind.equations().on_flange()?.missing? {
            FlangeDatum::FlangeShare => mounting.share.is_none().then_some("bearing.flange_share"),
            FlangeDatum::BeltTension => mounting.contact.is_none().then_some("bearing.belt_tension"),
        }
    }

    /// Returns the key of a datum missing in addition for the tilting moment; `payload`: a segment carries one.
    #[must_use]
    pub fn missing_for_moment(&self, mounting: &Mounting, payload: bool) -> Option<&'static str> {
        let has_wheel = mounting.wheel_mass.is_some_and(|mass| mass.si() != 0.0);
        let needs = match &self.stage {
            // A coupling transmits no radial force.
            Some(stage) => Overhang { of_mechanism: stage.kind != StageKind::Coupling, of_payload: false },
            None => self.kind.equations().on_flange()?.overhang,
        };
        match (mounting.overhang, mounting.payload_overhang) {
            (None, _) if needs.of_mechanism || has_wheel => Some("bearing.overhang"),
            (_, None) if needs.of_payload && payload => Some("bearing.payload_overhang"),
            (None | Some(_), None | Some(_)) => None,
        }
    }

    /// Returns the forces of the load on the flange at one instant.
    ///
    /// F = Σ m (g − a) of the parts that turn with the flange; the reaction of belt, teeth, thread or rod for the
    /// others
    ///
    /// # Symbols
    /// m mass \[kg\], g acceleration of gravity, a acceleration of the centre of mass [m/s²]; `recorded_nm` is a
    /// recorded torque, which along a line is a force of τ/k and elsewhere a couple about the axis
    /// # Source
    /// docs/theory/flange-loads.md: Newton's second law
    /// # Valid
    /// zero products of inertia about the centre of mass; a missing datum makes its force or lever zero: check
    /// [`Self::missing_for_forces`] and [`Self::missing_for_moment`] before
    #[must_use]
    pub fn flange_forces(&self, output: &Output, extra: &Extra, recorded_nm: f64, mounting: &Mounting) -> FlangeForces {
        let mut forces = match &self.stage {
            Some(_) => self.stage_forces(output, extra, recorded_nm, mounting),
            None => self.kind.equations().forces(&self.instant(output, extra, recorded_nm, mounting)),
        };
        if let (Some(mass), Some(tilt)) = (mounting.wheel_mass, mounting.axis_tilt) {
            let weight = mass.si() * gravity_m_s2();
            let radial = weight * sine(tilt).abs();
            forces.aligned.radial_n += radial;
            forces.aligned.axial_n += weight * cosine(tilt).abs();
            forces.aligned.moment_nm += radial * metres(mounting.overhang);
        }
        match mounting.share {
            Some(share) => forces.times(share),
            None => forces,
        }
    }

    /// Returns forces along the line whose changes of sign cause a kink in those on the flange \[N\]; `None` if there
    /// is no kink.
    #[must_use]
    pub fn flange_switches(&self, output: &Output, extra: &Extra, recorded_nm: f64) -> Option<[f64; 2]> {
        if self.stage.is_some() {
            // With a stage, the losses of the mechanism itself switch with its power.
            let extra = Extra { torque: extra.torque + Torque::from_si(recorded_nm), ..*extra };
            return Some([self.stage_hands_on(output, &extra, 0.0), self.useful_torque(output, &extra)]);
        }
        self.kind.equations().switches(&self.instant(output, extra, recorded_nm, &Mounting::default()))
    }

    pub(crate) const fn instant<'a>(
        &self,
        output: &'a Output,
        extra: &'a Extra,
        recorded_nm: f64,
        mounting: &'a Mounting,
    ) -> Instant<'a> {
        Instant { output, extra, recorded_nm, mounting, efficiency_driving: self.efficiency_driving }
    }

    /// Returns T_2 + J_2 α_2 of the stage, including a recorded torque \[Nm\].
    fn stage_hands_on(&self, output: &Output, extra: &Extra, recorded_nm: f64) -> f64 {
        let Some(stage) = &self.stage else { return 0.0 };
        let behind = stage.behind(output);
        let extra = Extra { torque: extra.torque + Torque::from_si(recorded_nm), ..*extra };
        stage.handed_on(self.own_torque(&behind, &extra), &behind)
    }

    /// Returns the forces of the stage on its wheel on the flange; the mechanism itself has bearings of its own.
    fn stage_forces(&self, output: &Output, extra: &Extra, recorded_nm: f64, mounting: &Mounting) -> FlangeForces {
        let Some(stage) = self.stage.as_ref().filter(|stage| stage.kind != StageKind::Coupling) else {
            return FlangeForces::default();
        };
        let radius = 0.5 * metres(stage.pitch_diameter);
        if radius <= 0.0 {
            return FlangeForces::default();
        }
        let handed_on = self.stage_hands_on(output, extra, recorded_nm);
        wheel_forces(stage.tangential(handed_on, output.direction), radius, mounting)
    }
}

/// Returns the sum of two moments, 0 if they cancel but for their rounding: a force at the centre has no lever.
fn without_rounding(one: f64, other: f64) -> f64 {
    let sum = one + other;
    if sum.abs() <= 4.0 * f64::EPSILON * one.abs() { 0.0 } else { sum }
}

/// Returns the forces of a wheel under a tangential force, at its overhang.
///
/// belt: F_r = 2 F_v + F_t · teeth: F_t, F_s = F_t tan α_n/cos β_z, F_z = F_t tan β_z
///
/// # Symbols
/// F_t tangential force, F_v tension of a span at rest, F_s separating force, F_z thrust \[N\]
/// # Source
/// docs/theory/flange-loads.md
/// # Valid
/// belt: the upper bound over all positions of the slide and all stiffnesses of the spans
pub(crate) fn wheel_forces(tangential: f64, radius_m: f64, mounting: &Mounting) -> FlangeForces {
    let mut forces = FlangeForces::default();
    let place = [0.0, 0.0, metres(mounting.overhang)];
    match mounting.contact {
        Some(Contact::Belt { tension }) => forces.act(place, [2.0 * tension.si() + tangential, 0.0, 0.0]),
        Some(Contact::Mesh { pressure_angle, helix_angle }) => {
            let (helix, thrust) = (helix_angle.si(), tangential * helix_angle.si().tan().abs());
            let separating = tangential * pressure_angle.si().tan() / helix.cos();
            forces.act(place, [tangential, separating, 0.0]);
            // The tilt direction of the thrust depends on the hand of the teeth.
            forces.aligned.axial_n += thrust;
            forces.aligned.couple_nm += thrust * radius_m;
        }
        None => {}
    }
    forces
}

#[cfg(test)]
#[path = "flange_tests.rs"]
mod tests;
