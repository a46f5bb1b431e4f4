//! What the load does to the flange that carries it: forces across and along the axis, and the moment that tilts it.

use crate::{Extra, Kind, Linear, LinearKind, Mechanism, Output, Rotor, SliderCrank, StageKind, gravity_m_s2};
use quantities::{Angle, Force, Length, Mass, Measure, Torque};

/// How a wheel on the flange hands its force on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// A belt wrapped half round a pulley, both spans parallel.
    Belt {
        /// F_v: tension of each span at rest.
        tension: Force,
    },
    /// Teeth that mesh with a rack or a wheel.
    Mesh {
        /// α_n: pressure angle in the normal section.
        pressure_angle: Angle,
        /// β_z: helix angle, zero for spur teeth.
        helix_angle: Angle,
    },
}

/// How the load sits on the flange. What is not stated is never guessed: see [`Mechanism::missing_for_forces`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mounting {
    /// L: distance of the centre of mass, or of the middle of pulley, pinion or crank pin, from the flange face along
    /// the axis, away from the actuator.
    pub overhang: Option<Length>,
    /// L_p: the same of the payload.
    pub payload_overhang: Option<Length>,
    /// Share of the forces that reaches the flange; the rest is carried by other bearings.
    pub share: Option<f64>,
    /// How a wheel hands its force on.
    pub contact: Option<Contact>,
    /// m_w: mass of what turns with the flange and is not part of the mechanism's masses: pulley, pinion, crank.
    pub wheel_mass: Option<Mass>,
    /// β: tilt of the axis from the vertical, for the weight of the wheel; a rotor has its own.
    pub axis_tilt: Option<Angle>,
}

/// Forces of the load on the flange at one instant, in SI.
///
/// The plane of the flange has its first direction level, as the angle of a rotor counts from there, and its second the
/// steepest upwards; the third direction is that of the axis, away from the actuator.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FlangeForces {
    /// F_x, F_y: force in the plane of the flange \[N\].
    pub radial_n: [f64; 2],
    /// F_z: force along the axis \[N\].
    pub axial_n: f64,
    /// M_x, M_y: tilting moment about the centre of the flange face \[Nm\].
    pub moment_nm: [f64; 2],
    /// What has no stated direction, as amounts that add at their worst.
    pub aligned: Aligned,
}

/// Amounts that add to those of the vectors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Aligned {
    /// Force in the plane of the flange \[N\].
    pub radial_n: f64,
    /// Force along the axis \[N\].
    pub axial_n: f64,
    /// Tilting moment about the centre of the flange face \[Nm\].
    pub moment_nm: f64,
}

impl FlangeForces {
    /// F_r: radial force \[N\].
    #[must_use]
    pub fn radial(&self) -> f64 {
        let [x, y] = self.radial_n;
        // No component of any force comes near the ends of the numbers, so the plain root serves.
        (x * x + y * y).sqrt() + self.aligned.radial_n
    }

    /// F_a: axial force \[N\].
    #[must_use]
    pub fn axial(&self) -> f64 {
        self.axial_n.abs() + self.aligned.axial_n
    }

    /// M: tilting moment about a centre that lies behind the flange face \[Nm\].
    ///
    /// M = |M_0 + R e_z × F| + M_al + R F_al
    ///
    /// # Symbols  M_0 moment about the centre of the flange face \[Nm\], R distance of the centre behind it \[m\], F force
    /// \[N\], index al amounts without direction
    /// # Source   docs/theory/flange-loads.md
    #[must_use]
    pub fn moment(&self, offset: Length) -> f64 {
        let (r, [fx, fy], [mx, my]) = (offset.si(), self.radial_n, self.moment_nm);
        let (x, y) = (mx - r * fy, my + r * fx);
        (x * x + y * y).sqrt() + self.aligned.moment_nm + r * self.aligned.radial_n
    }

    /// Adds a force that acts at a point: its distances from the axis and from the flange face \[m\].
    fn act(&mut self, [x, y, z]: [f64; 3], [fx, fy, fz]: [f64; 3]) {
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
        all.chain([&mut aligned.radial_n, &mut aligned.axial_n, &mut aligned.moment_nm]).for_each(|v| *v *= factor);
        self
    }
}

/// cos β without what the rounded angle leaves of a right one.
fn cosine(angle: Angle) -> f64 {
    let cosine = angle.si().cos();
    if cosine.abs() < 1e-12 { 0.0 } else { cosine }
}

/// sin β without what the rounded angle leaves of a straight one.
fn sine(angle: Angle) -> f64 {
    let sine = angle.si().sin();
    if sine.abs() < 1e-12 { 0.0 } else { sine }
}

fn metres(length: Option<Length>) -> f64 {
    length.map_or(0.0, Measure::si)
}

impl Mechanism {
    /// Whether the mechanism describes the masses and forces from which loads on the flange follow.
    #[must_use]
    pub const fn knows_flange_forces(&self, described: bool) -> bool {
        match &self.kind {
            // Behind a stage the torque suffices.
            _ if self.stage.is_some() => true,
            // A load given by its inertia alone has a weight and a centre of mass that nobody stated.
            Kind::Rotor(_) => described,
            Kind::Linear(_) | Kind::SliderCrank(_) => true,
            Kind::Table(_) | Kind::Joint(_) => false,
        }
    }

    /// The key of what is missing before the forces on the flange are known; `None` where nothing is.
    #[must_use]
    pub fn missing_for_forces(&self, mounting: &Mounting) -> Option<&'static str> {
        if let Some(stage) = &self.stage {
            return match stage.kind {
                StageKind::Coupling => None,
                _ if stage.pitch_diameter.is_none() => Some("stage.pitch_diameter"),
                StageKind::Belt if mounting.contact.is_none() => Some("bearing.belt_tension"),
                StageKind::Gear if mounting.contact.is_none() => Some("bearing.pressure_angle"),
                _ => None,
            };
        }
        match &self.kind {
            Kind::Linear(Linear { kind: LinearKind::Screw, .. }) if mounting.share.is_none() => {
                Some("bearing.flange_share")
            }
            Kind::Linear(Linear { kind: LinearKind::Belt | LinearKind::Conveyor, .. })
                if mounting.contact.is_none() =>
            {
                Some("bearing.belt_tension")
            }
            _ => None,
        }
    }

    /// The key of what is missing before the tilting moment is known besides; `payload`: some segment carries one.
    #[must_use]
    pub fn missing_for_moment(&self, mounting: &Mounting, payload: bool) -> Option<&'static str> {
        let weightless = mounting.wheel_mass.is_none_or(|mass| mass.si() == 0.0);
        let needs_overhang = match &self.kind {
            // A coupling hands on no force across the axis.
            _ if self.stage.is_some() => {
                !self.stage.is_some_and(|stage| stage.kind == StageKind::Coupling) || !weightless
            }
            Kind::Rotor(rotor) => rotor.mass.si() > 0.0,
            // The thrust of a screw runs along the axis.
            Kind::Linear(linear) => linear.kind != LinearKind::Screw || !weightless,
            _ => true,
        };
        let carries = matches!(&self.kind, Kind::Rotor(_)) && self.stage.is_none() && payload;
        match (mounting.overhang, mounting.payload_overhang) {
            (None, _) if needs_overhang => Some("bearing.overhang"),
            (_, None) if carries => Some("bearing.payload_overhang"),
            _ => None,
        }
    }

    /// The forces of the load on the flange at one instant.
    ///
    /// F = Σ m (g − a) of what turns with the flange; the reaction of belt, teeth, thread or rod of what does not
    ///
    /// # Symbols  m mass \[kg\], g acceleration of gravity, a acceleration of the centre of mass [m/s²]; `recorded_nm` is a
    /// recorded torque, which along a line is a force of τ/k and elsewhere a couple about the axis
    /// # Source   docs/theory/flange-loads.md: Newton's second law
    /// # Valid    products of inertia about the centre of mass zero; where a datum is missing its force or lever counts as
    /// zero: ask [`Self::missing_for_forces`] and [`Self::missing_for_moment`] before
    #[must_use]
    pub fn flange_forces(&self, output: &Output, extra: &Extra, recorded_nm: f64, mounting: &Mounting) -> FlangeForces {
        let mut forces = match &self.kind {
            _ if self.stage.is_some() => self.stage_forces(output, extra, recorded_nm, mounting),
            Kind::Rotor(rotor) => rotor_forces(rotor, output, extra, mounting),
            Kind::Linear(linear) => self.linear_forces(linear, output, extra, recorded_nm, mounting),
            Kind::SliderCrank(crank) => self.crank_forces(crank, output, extra, mounting),
            Kind::Table(_) | Kind::Joint(_) => FlangeForces::default(),
        };
        if let (Some(mass), Some(tilt)) = (mounting.wheel_mass, mounting.axis_tilt) {
            let weight = mass.si() * gravity_m_s2();
            let radial = weight * sine(tilt).abs();
            forces.aligned.radial_n += radial;
            forces.aligned.axial_n += weight * cosine(tilt).abs();
            forces.aligned.moment_nm += radial * metres(mounting.overhang).abs();
        }
        match mounting.share {
            Some(share) => forces.times(share),
            None => forces,
        }
    }

    /// Forces along the line whose changes of sign bend those on the flange \[N\].
    #[must_use]
    pub fn flange_switches(&self, output: &Output, extra: &Extra, recorded_nm: f64) -> [f64; 2] {
        match &self.kind {
            // Behind the stage the losses of the mechanism itself switch with its power.
            _ if self.stage.is_some() => {
                let extra = Extra { torque: extra.torque + Torque::from_si(recorded_nm), ..*extra };
                [self.stage_hands_on(output, &extra, 0.0), self.useful_torque(output, &extra)]
            }
            Kind::Linear(linear) => line_forces(linear, output, extra, recorded_nm),
            Kind::SliderCrank(crank) => [rod_force(crank, output, extra).0, 0.0],
            _ => [0.0; 2],
        }
    }

    /// A force on the near side of the losses, as an amount: what drives is divided by the efficiency, what is driven
    /// counts in full, since where along the way its losses arise is not known.
    fn before_losses(&self, force: f64, direction: f64) -> f64 {
        if force * direction > 0.0 { force.abs() / self.efficiency_driving } else { force.abs() }
    }

    /// T_2 + J_2 α_2 of the stage, with a recorded torque \[Nm\].
    fn stage_hands_on(&self, output: &Output, extra: &Extra, recorded_nm: f64) -> f64 {
        let Some(stage) = &self.stage else { return 0.0 };
        let behind = stage.behind(output);
        let extra = Extra { torque: extra.torque + Torque::from_si(recorded_nm), ..*extra };
        stage.handed_on(self.own_torque(&behind, &extra), &behind)
    }

    /// What the wheel on the flange bears of the stage; the mechanism itself rests on bearings of its own.
    fn stage_forces(&self, output: &Output, extra: &Extra, recorded_nm: f64, mounting: &Mounting) -> FlangeForces {
        let Some(stage) = self.stage.as_ref().filter(|stage| stage.kind != StageKind::Coupling) else {
            return FlangeForces::default();
        };
        let radius = 0.5 * metres(stage.pitch_diameter);
        if radius <= 0.0 {
            return FlangeForces::default();
        }
        let handed_on = self.stage_hands_on(output, extra, recorded_nm);
        // While the mechanism drives, where along the way the losses arise is not known: they count as no help.
        let torque = stage.taken(handed_on, output.direction).abs().max((handed_on / stage.ratio).abs());
        wheel_forces(torque / radius, radius, mounting)
    }

    fn linear_forces(
        &self,
        linear: &Linear,
        output: &Output,
        extra: &Extra,
        recorded_nm: f64,
        mounting: &Mounting,
    ) -> FlangeForces {
        let [without, with] = line_forces(linear, output, extra, recorded_nm);
        if linear.kind == LinearKind::Screw {
            return FlangeForces { axial_n: without, ..FlangeForces::default() };
        }
        // How much of the turning inertia sits behind the belt is not known; the pull is largest at one of the ends.
        let amount = |force: f64| self.before_losses(force, output.direction);
        wheel_forces(amount(without).max(amount(with)), linear.travel_m_per_rad, mounting)
    }

    fn crank_forces(&self, crank: &SliderCrank, output: &Output, extra: &Extra, mounting: &Mounting) -> FlangeForces {
        let (force, slope) = rod_force(crank, output, extra);
        // Outward travel has the sign of x' ω.
        let sense = crank_slope(crank, output.position_rad) * output.direction;
        let amount = self.before_losses(force, sense);
        let mut forces = FlangeForces::default();
        // Amount and line of the rod's force: its own sign turns both components.
        forces.act([0.0, 0.0, metres(mounting.overhang)], [-amount, amount * slope, 0.0]);
        forces
    }
}

/// Forces of a wheel under a tangential force, at its overhang.
///
/// belt: F_r = 2 F_v + F_t · teeth: F_t, F_s = F_t tan α_n/cos β_z, F_z = F_t tan β_z
///
/// # Symbols  F_t tangential force, F_v tension of a span at rest, F_s separating force, F_z thrust \[N\]
/// # Source   docs/theory/flange-loads.md
/// # Valid    belt: the upper bound over all places of the slide and all stiffnesses of the spans
fn wheel_forces(tangential: f64, radius_m: f64, mounting: &Mounting) -> FlangeForces {
    let mut forces = FlangeForces::default();
    let place = [0.0, 0.0, metres(mounting.overhang)];
    match mounting.contact {
        Some(Contact::Belt { tension }) => forces.act(place, [2.0 * tension.si() + tangential, 0.0, 0.0]),
        Some(Contact::Mesh { pressure_angle, helix_angle }) => {
            let (helix, thrust) = (helix_angle.si(), tangential * helix_angle.si().tan().abs());
            let separating = tangential * pressure_angle.si().tan() / helix.cos();
            forces.act(place, [tangential, separating, 0.0]);
            // The hand of the teeth says to which side the thrust tilts.
            forces.aligned.axial_n += thrust;
            forces.aligned.moment_nm += thrust * radius_m;
        }
        None => {}
    }
    forces
}

/// m (g − a) of the rotor and of its payload.
fn rotor_forces(rotor: &Rotor, output: &Output, extra: &Extra, mounting: &Mounting) -> FlangeForces {
    let (sin, cos) = (output.position_rad + rotor.angle.si()).sin_cos();
    let (omega, alpha) = (output.speed_rad_s, output.acceleration_rad_s2);
    let (across, along) = (gravity_m_s2() * sine(rotor.tilt), gravity_m_s2() * cosine(rotor.tilt));
    let mut forces = FlangeForces::default();
    for (mass, radius, overhang) in
        [(rotor.mass, rotor.radius, mounting.overhang), (extra.mass, rotor.payload_radius, mounting.payload_overhang)]
    {
        let (m, r) = (mass.si(), radius.si());
        if m == 0.0 {
            continue;
        }
        let (centrifugal, tangential) = (omega * omega * r, alpha * r);
        let force = [
            m * (centrifugal * cos + tangential * sin),
            m * (centrifugal * sin - tangential * cos - across),
            -m * along,
        ];
        forces.act([r * cos, r * sin, metres(overhang)], force);
    }
    forces
}

/// Force that the wheel or the thread gives to what moves along the line \[N\], without and with the share of the turning
/// inertia that may sit behind it.
fn line_forces(linear: &Linear, output: &Output, extra: &Extra, recorded_nm: f64) -> [f64; 2] {
    let (k, alpha) = (linear.travel_m_per_rad, output.acceleration_rad_s2);
    // What turns with the wheel, and couples about its axis, are no force along the line.
    let line = Linear { inertia: quantities::MomentOfInertia::from_si(0.0), ..*linear };
    let of_line = Extra { mass: extra.mass, force: extra.force, ..Extra::none() };
    let reduced = line.reduced(&of_line);
    let without = (reduced.inertia * alpha + reduced.holding + reduced.coulomb * output.direction + recorded_nm) / k;
    [without, without + linear.inertia.si() * alpha / k]
}

/// x' of a slider-crank [m/rad].
fn crank_slope(crank: &SliderCrank, position_rad: f64) -> f64 {
    let (r, l) = (crank.crank.si(), crank.rod.si());
    let (sine, cosine) = (position_rad + crank.angle.si()).sin_cos();
    -r * sine - r * r * sine * cosine / (l * l - r * r * sine * sine).sqrt()
}

/// Force that the rod gives to the slider along its line \[N\], and tan ψ of the rod's angle.
///
/// F = (m + m_p)(x' α + x'' ω² + g sin γ) + F_p, sin ψ = (r/l) sin q
fn rod_force(crank: &SliderCrank, output: &Output, extra: &Extra) -> (f64, f64) {
    let (r, l) = (crank.crank.si(), crank.rod.si());
    let (sine, cosine) = (output.position_rad + crank.angle.si()).sin_cos();
    let root = (l * l - r * r * sine * sine).sqrt();
    let root_slope = -r * r * sine * cosine / root;
    let first = -r * sine + root_slope;
    let second = -r * cosine + (-r * r * (cosine * cosine - sine * sine) - root_slope * root_slope) / root;
    let acceleration = first * output.acceleration_rad_s2 + second * output.speed_rad_s * output.speed_rad_s;
    let mass = crank.mass.si() + extra.mass.si();
    let force = mass * (acceleration + gravity_m_s2() * crank.inclination.si().sin()) + extra.force.si();
    (force, r * sine / root)
}

#[cfg(test)]
#[path = "flange_tests.rs"]
mod tests;
