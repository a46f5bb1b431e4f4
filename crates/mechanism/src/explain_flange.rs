//! Derivation of the loads on the flange at one instant.

use crate::equations::Equations;
use crate::explain::{At, Steps, Sum, key, stage_efficiency, stage_ratio};
use crate::flange::{Instant, cosine, metres, sine};
use crate::{
    Contact, Extra, FlangeForces, Linear, LinearKind, Mechanism, MechanismKind, Mounting, Rotor, RotorKind, Stage,
    StageKind, Winder,
};
use derivation::{Finding, Workings};
use provenance::{Grade, Source, Sourced};
use quantities::unit::{KILOGRAM, METRE, NEWTON, NEWTON_METRE, ONE, RADIAN, RADIAN_PER_SECOND_SQUARED, SECOND};
use quantities::{Length, Mass, Measure};

/// Model of the loads on the flange.
const MODEL: Source = Source::Model { name: "flange-loads" };

/// One of the loads on the flange.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlangeLoadKind {
    /// F_r
    Radial,
    /// F_a
    Axial,
    /// M about a centre behind the flange face.
    Moment,
}

/// Position of a load relative to the bearing.
#[derive(Clone, Copy)]
struct Place<'a> {
    mounting: &'a Mounting,
    /// Offset of the bearing's centre, for the moment.
    offset: Option<&'a Sourced<Length>>,
}

impl Place<'_> {
    /// Records the lever of a force at the overhang and returns the moment of the force.
    fn moment_of(&self, force: &str, steps: &mut Steps<'_>) -> String {
        let overhang = metres(self.mounting.overhang);
        steps.work.figure("L_0", &METRE, overhang, &key("bearing.overhang"), Grade::Printed);
        self.centre(steps);
        format!("abs(L_0 + R)*{force}")
    }

    /// Records the offset of the bearing's centre, `R`.
    fn centre(&self, steps: &mut Steps<'_>) {
        if let Some(offset) = self.offset {
            steps.work.given("R", &METRE, offset);
        }
    }
}

impl Mechanism {
    /// Records the parts of a load on the flange at an instant and returns the formula of their sum, without stated loads; for
    /// the moment with the offset of the bearing's centre.
    pub fn explain_flange(
        &self,
        kind: FlangeLoadKind,
        at: &At,
        (mounting, offset): (&Mounting, Option<&Sourced<Length>>),
        work: &mut Workings,
    ) -> String {
        let mut steps = Steps::of(self.id(), at.segment, work);
        let place = Place { mounting, offset };
        let terms = match &self.stage {
            Some(stage) => self.explain_stage_wheel(kind, at, stage, place, &mut steps),
            None => self.explain_forces(kind, at, place, &mut steps),
        };
        let terms = explain_wheel_weight(kind, terms, place, &mut steps);
        match mounting.share.filter(|_| !terms.is_empty()) {
            Some(share) => {
                steps.work.figure("w_F", &ONE, share, &key("bearing.flange_share"), Grade::Printed);
                format!("w_F*{}", terms.factor())
            }
            None => terms.text(),
        }
    }

    /// Records the load of the mechanism itself and returns its terms.
    fn explain_forces(&self, kind: FlangeLoadKind, at: &At, place: Place<'_>, steps: &mut Steps<'_>) -> Sum {
        let instant = self.instant(&at.output, &at.extra, at.recorded_nm, place.mounting);
        let is_axial = kind == FlangeLoadKind::Axial;
        match &self.kind {
            MechanismKind::Rotor(rotor) if rotor.kind != RotorKind::Load => {
                return rotor.explain_flange(kind, at, place, steps);
            }
            MechanismKind::Linear(linear) if linear.kind != LinearKind::Screw => {
                return self.explain_pulley(kind, linear, (at, &instant), place, steps);
            }
            MechanismKind::Linear(_) | MechanismKind::ScissorLift(_) => {
                if !is_axial {
                    return Sum::default();
                }
                self.record_time(at, steps);
                let (line, _) = self.explain_line(at, steps);
                let thrust = self.kind.equations().forces(&instant).axial_n;
                steps.work.formula("F_l", &NEWTON, thrust, format!("{}/k", line.factor()), &MODEL);
                return Sum::of("abs(F_l)");
            }
            MechanismKind::Rotor(_) | MechanismKind::Table(_) | MechanismKind::Joint(_) => return Sum::default(),
            MechanismKind::Winder(winder) if is_axial => {
                let Some(tilt) = place.mounting.axis_tilt.filter(|tilt| cosine(*tilt) != 0.0) else {
                    return Sum::default();
                };
                self.record_time(at, steps);
                let weight = winder.explain_weight(at.output.position_rad, steps);
                steps.work.figure("beta", &RADIAN, tilt.si(), &key("bearing.axis_tilt"), Grade::Printed);
                return Sum::of(format!("{weight}*abs(cos(beta))"));
            }
            _ if is_axial => return Sum::default(),
            MechanismKind::SliderCrank(_)
            | MechanismKind::FourBar(_)
            | MechanismKind::Hoist(_)
            | MechanismKind::Winder(_) => {}
        }
        self.record_time(at, steps);
        let forces = self.kind.equations().forces(&instant);
        let text = self.explain_force_across(&instant, at, steps);
        steps.work.formula("F_q", &NEWTON, forces.radial(), text, &MODEL);
        match kind {
            FlangeLoadKind::Moment => Sum::of(place.moment_of("F_q", steps)),
            _ => Sum::of("F_q"),
        }
    }

    /// Records the parts of the force across the axis of a mechanism that acts at one point, and returns its formula.
    fn explain_force_across(&self, instant: &Instant<'_>, at: &At, steps: &mut Steps<'_>) -> String {
        let direction = at.output.direction;
        let lossy = |force: f64, direction: f64| self.efficiency_driving != 1.0 && force * direction > 0.0;
        match &self.kind {
            MechanismKind::SliderCrank(crank) => {
                let (force, inward) = crank.rod(instant);
                crank.explain_rod((&at.output, &at.extra), force, steps);
                let losses = self.losses(lossy(force, inward * direction), steps);
                format!("abs(F_l){losses}*l/sqrt(l^2 - r_c^2*sin(q)^2)")
            }
            MechanismKind::FourBar(linkage) => {
                linkage.explain_pin(&at.output, steps);
                let losses = self.losses(linkage.pin_losses(instant) != 1.0, steps);
                format!("sqrt(F_px^2 + F_py^2){losses}")
            }
            MechanismKind::Hoist(hoist) => {
                let torques = self.explain_ropes_at(hoist, at, steps);
                let radius = 0.5 * hoist.drum_diameter.si();
                let recorded = at.recorded_nm != 0.0;
                if recorded {
                    steps.found("tau", &NEWTON_METRE, at.recorded_nm, Finding::RecordedTorqueAt);
                }
                let pulls = [(torques[0] + at.recorded_nm) / radius, torques[1] / radius];
                let load = format!("2*{}/D", Sum::of("T_f1").and(recorded, "tau").factor());
                steps.work.formula("F_f1", &NEWTON, pulls[0], load, &MODEL);
                let balanced = hoist.counterweight.si() != 0.0;
                if balanced {
                    steps.work.formula("F_f2", &NEWTON, pulls[1], "2*T_f2/D", &MODEL);
                }
                let [load, counterweight] = hoist.explain_sheaves(["F_f1", "F_f2"], pulls, direction, steps);
                let losses = self.losses(lossy(pulls[0], direction), steps);
                Sum::of(format!("abs({load}){losses}")).and(balanced, format!("abs({counterweight})")).text()
            }
            MechanismKind::Winder(winder) => {
                let mut weight = winder.explain_weight(at.output.position_rad, steps);
                if let Some(tilt) = instant.mounting.axis_tilt {
                    steps.work.figure("beta", &RADIAN, tilt.si(), &key("bearing.axis_tilt"), Grade::Printed);
                    weight.push_str("*abs(sin(beta))");
                }
                steps.own("F_w", &NEWTON, winder.tension.si(), "tension");
                format!("{weight} + abs(F_w)")
            }
            MechanismKind::Rotor(_)
            | MechanismKind::Linear(_)
            | MechanismKind::Table(_)
            | MechanismKind::Joint(_)
            | MechanismKind::ScissorLift(_) => Sum::default().text(),
        }
    }

    /// Returns the division by the efficiency, which it records, or nothing without losses.
    fn losses(&self, is_lossy: bool, steps: &mut Steps<'_>) -> &'static str {
        if is_lossy {
            self.explain_efficiency(steps);
            "/eta_1"
        } else {
            ""
        }
    }

    /// Records the force at the circumference of a pulley or pinion and returns the terms of its load.
    fn explain_pulley(
        &self,
        kind: FlangeLoadKind,
        linear: &Linear,
        (at, instant): (&At, &Instant<'_>),
        place: Place<'_>,
        steps: &mut Steps<'_>,
    ) -> Sum {
        if !acts(kind, place.mounting.contact) {
            return Sum::default();
        }
        self.record_time(at, steps);
        let [without, with] = linear.pulls(instant);
        let (line, has_payload_inertia) = self.explain_line(at, steps);
        steps.work.formula("F_l", &NEWTON, without, format!("{}/k", line.factor()), &MODEL);
        let lossy = |force: f64| self.efficiency_driving != 1.0 && force * at.output.direction > 0.0;
        let mut amounts = vec![format!("abs(F_l){}", self.losses(lossy(without), steps))];
        if linear.inertia.si() + at.extra.inertia.si() != 0.0 {
            let turning = Sum::of("J_0").and(has_payload_inertia, "J_p").factor();
            steps.work.formula("F_i", &NEWTON, with, format!("F_l + {turning}*alpha/k"), &MODEL);
            amounts.push(format!("abs(F_i){}", self.losses(lossy(with), steps)));
        }
        let text = if amounts.len() > 1 { format!("max({})", amounts.join(", ")) } else { amounts.concat() };
        let tangential = linear.tangential(instant);
        steps.work.formula("F_t", &NEWTON, tangential, text, &MODEL);
        explain_wheel(kind, tangential, "k", place, steps)
    }

    /// Records the force at the circumference of the wheel of a stage and returns the terms of its load.
    fn explain_stage_wheel(
        &self,
        kind: FlangeLoadKind,
        at: &At,
        stage: &Stage,
        place: Place<'_>,
        steps: &mut Steps<'_>,
    ) -> Sum {
        let diameter = metres(stage.pitch_diameter);
        if stage.kind == StageKind::Coupling || diameter <= 0.0 || !acts(kind, place.mounting.contact) {
            return Sum::default();
        }
        self.record_time(at, steps);
        let (unit, alpha) = (&RADIAN_PER_SECOND_SQUARED, at.output.acceleration_rad_s2);
        steps.found("alpha", unit, alpha, Finding::AccelerationAt);
        let handed_on = self.explain_behind(at, stage, steps);
        steps.work.formula("T_t", &NEWTON_METRE, handed_on, "T_M + J_2*alpha_2", &MODEL);
        stage_ratio(stage, steps.work);
        steps.work.figure("d_1", &METRE, diameter, &key("stage.pitch_diameter"), Grade::Printed);
        let text = if handed_on * at.output.direction > 0.0 && stage.efficiency_driving != 1.0 {
            stage_efficiency(stage, steps.work);
            "2*abs(T_t)/(i_s*eta_s1*d_1)"
        } else {
            "2*abs(T_t)/(i_s*d_1)"
        };
        let tangential = stage.tangential(handed_on, at.output.direction);
        steps.work.formula("F_t", &NEWTON, tangential, text, &MODEL);
        explain_wheel(kind, tangential, "d_1/2", place, steps)
    }

    /// Records the instant.
    fn record_time(&self, at: &At, steps: &mut Steps<'_>) {
        steps.work.figure("t", &SECOND, at.time_s, &MODEL, Grade::Computed);
    }
}

/// Returns `true` if a wheel with this transmission of force has a load of a kind.
fn acts(kind: FlangeLoadKind, contact: Option<Contact>) -> bool {
    match contact {
        None => false,
        Some(Contact::Belt { .. }) => kind != FlangeLoadKind::Axial,
        Some(Contact::Mesh { .. }) => true,
    }
}

/// Records the load of a wheel under its recorded tangential force `F_t` and returns its terms.
fn explain_wheel(
    kind: FlangeLoadKind,
    tangential_n: f64,
    radius: &str,
    place: Place<'_>,
    steps: &mut Steps<'_>,
) -> Sum {
    let (across, text, thrust) = match place.mounting.contact {
        Some(Contact::Belt { tension }) => {
            steps.work.figure("F_v", &NEWTON, tension.si(), &key("bearing.belt_tension"), Grade::Printed);
            (2.0 * tension.si() + tangential_n, "2*F_v + F_t", false)
        }
        Some(Contact::Mesh { pressure_angle, helix_angle }) => {
            let (pressure, helix) = (pressure_angle.si(), helix_angle.si());
            steps.work.figure("beta_z", &RADIAN, helix, &key("bearing.helix_angle"), Grade::Printed);
            if kind != FlangeLoadKind::Axial {
                steps.work.figure("alpha_n", &RADIAN, pressure, &key("bearing.pressure_angle"), Grade::Printed);
            }
            let across = tangential_n * (1.0 + (pressure.tan() / helix.cos()).powi(2)).sqrt();
            (across, "F_t*sqrt(1 + (tan(alpha_n)/cos(beta_z))^2)", true)
        }
        None => return Sum::default(),
    };
    if kind == FlangeLoadKind::Axial {
        return Sum::of("F_t*abs(tan(beta_z))");
    }
    steps.work.formula("F_q", &NEWTON, across, text, &MODEL);
    match kind {
        FlangeLoadKind::Moment => {
            Sum::of(place.moment_of("F_q", steps)).and(thrust, format!("F_t*abs(tan(beta_z))*{radius}"))
        }
        _ => Sum::of("F_q"),
    }
}

/// Adds the load by the weight of a wheel on the flange to the terms of a load.
fn explain_wheel_weight(kind: FlangeLoadKind, terms: Sum, place: Place<'_>, steps: &mut Steps<'_>) -> Sum {
    let Some((mass, tilt)) = place.mounting.wheel_mass.zip(place.mounting.axis_tilt) else { return terms };
    if mass.si() == 0.0 {
        return terms;
    }
    steps.work.figure("m_w", &KILOGRAM, mass.si(), &key("bearing.wheel_mass"), Grade::Printed);
    steps.work.figure("beta", &RADIAN, tilt.si(), &key("bearing.axis_tilt"), Grade::Printed);
    let across = "9.80665*m_w*abs(sin(beta))";
    match kind {
        FlangeLoadKind::Radial => terms.and(true, across),
        FlangeLoadKind::Axial => terms.and(true, "9.80665*m_w*abs(cos(beta))"),
        FlangeLoadKind::Moment => {
            let moment = place.moment_of(across, steps);
            terms.and(true, moment)
        }
    }
}

impl Winder {
    /// Records the roll at a position and returns the formula of its weight.
    fn explain_weight(&self, position_rad: f64, steps: &mut Steps<'_>) -> String {
        steps.place(position_rad, Finding::PositionAt);
        self.explain_roll(position_rad, steps);
        self.explain_web(steps);
        "9.80665*pi*rho*b_w*(r_w^2 - (D_k/2)^2)".to_owned()
    }
}

impl Rotor {
    /// Records m (g − a) of the rotor and of its payload, and their moments, and returns the terms of a load.
    fn explain_flange(&self, kind: FlangeLoadKind, at: &At, place: Place<'_>, steps: &mut Steps<'_>) -> Sum {
        let payload = at.extra.mass.si() != 0.0;
        let (is_level, is_upright) = (cosine(self.tilt) == 0.0, sine(self.tilt) == 0.0);
        let own = Extra::none();
        let of = |rotor: &Self, extra: &Extra| {
            rotor.forces(&Instant {
                output: &at.output,
                extra,
                recorded_nm: 0.0,
                mounting: place.mounting,
                efficiency_driving: 1.0,
            })
        };
        let forces = of(self, &at.extra);
        if kind == FlangeLoadKind::Axial {
            if is_level {
                return Sum::default();
            }
            self.explain_masses(payload, false, at, steps);
            self.explain_weight(payload, forces.axial_n, steps);
            return Sum::of("abs(F_z)");
        }
        self.explain_masses(payload, true, at, steps);
        steps.work.figure("t", &SECOND, at.time_s, &MODEL, Grade::Computed);
        steps.motion(&at.output, true, false);
        steps.found("q", &RADIAN, at.output.position_rad, Finding::PositionAt);
        let turned = self.angle.si() != 0.0;
        if turned {
            steps.found("phi_0", &RADIAN, self.angle.si(), Finding::AngleOfBodies);
        }
        let angle = at.output.position_rad + self.angle.si();
        let text = Sum::of("q").and(turned, "phi_0").text();
        steps.work.formula("q_m", &RADIAN, angle, text, &MODEL);
        if !is_upright {
            steps.own("beta", &RADIAN, self.tilt.si(), "axis_tilt");
        }
        let weightless = Self { mass: Mass::from_si(0.0), ..*self };
        let bodies: &[(&str, &str, [&'static str; 2], FlangeForces)] = &if payload {
            vec![
                ("m", "r_0", ["F_x1", "F_y1"], of(self, &own)),
                ("m_p", "r_p", ["F_x2", "F_y2"], of(&weightless, &at.extra)),
            ]
        } else {
            vec![("m", "r_0", ["F_x", "F_y"], forces)]
        };
        for (mass, radius, [x, y], forces) in bodies {
            let [fx, fy] = forces.radial_n;
            let text = format!("{mass}*{radius}*(omega^2*cos(q_m) + alpha*sin(q_m))");
            steps.work.formula(x, &NEWTON, fx, text, &MODEL);
            let across = format!("{radius}*(omega^2*sin(q_m) - alpha*cos(q_m))");
            let text =
                if is_upright { format!("{mass}*{across}") } else { format!("{mass}*({across} - 9.80665*sin(beta))") };
            steps.work.formula(y, &NEWTON, fy, text, &MODEL);
        }
        if kind == FlangeLoadKind::Radial {
            let text = if payload { "sqrt((F_x1 + F_x2)^2 + (F_y1 + F_y2)^2)" } else { "sqrt(F_x^2 + F_y^2)" };
            return Sum::of(text);
        }
        let overhang = metres(place.mounting.overhang);
        steps.work.figure("L_0", &METRE, overhang, &key("bearing.overhang"), Grade::Printed);
        if payload {
            let overhang = metres(place.mounting.payload_overhang);
            steps.work.figure("L_p", &METRE, overhang, &key("bearing.payload_overhang"), Grade::Printed);
        }
        place.centre(steps);
        if !is_level {
            self.explain_weight(payload, forces.axial_n, steps);
        }
        let r = place.offset.map_or(0.0, |offset| offset.value.si());
        let ([fx, fy], [mx, my]) = (forces.radial_n, forces.moment_nm);
        let lever = if payload { "(m*r_0 + m_p*r_p)/(m + m_p)" } else { "r_0" };
        let levers: &[(&str, [&str; 2])] =
            if payload { &[("L_0", ["F_x1", "F_y1"]), ("L_p", ["F_x2", "F_y2"])] } else { &[("L_0", ["F_x", "F_y"])] };
        let about_x = Sum::default().and(!is_level, format!("{lever}*sin(q_m)*F_z"));
        let about_x = levers.iter().fold(about_x, |sum, (arm, [_, y])| sum.less(true, format!("({arm} + R)*{y}")));
        let about_y =
            levers.iter().fold(Sum::default(), |sum, (arm, [x, _])| sum.and(true, format!("({arm} + R)*{x}")));
        let about_y = about_y.less(!is_level, format!("{lever}*cos(q_m)*F_z"));
        steps.work.formula("M_x", &NEWTON_METRE, mx - r * fy, about_x.text(), &MODEL);
        steps.work.formula("M_y", &NEWTON_METRE, my + r * fx, about_y.text(), &MODEL);
        Sum::of("sqrt(M_x^2 + M_y^2)")
    }

    /// Records the masses of rotor and payload, and the distances of their centres.
    fn explain_masses(&self, payload: bool, has_distance: bool, at: &At, steps: &mut Steps<'_>) {
        self.explain_mass(has_distance, steps);
        if payload {
            steps.of_segment("m_p", &KILOGRAM, at.extra.mass.si(), "payload");
        }
        if payload && has_distance {
            steps.own("r_p", &METRE, self.payload_radius.si(), "payload_distance");
        }
    }

    /// Records the weight along the axis, `F_z`.
    fn explain_weight(&self, payload: bool, weight_n: f64, steps: &mut Steps<'_>) {
        steps.own("beta", &RADIAN, self.tilt.si(), "axis_tilt");
        let mass = Sum::of("m").and(payload, "m_p").factor();
        steps.work.formula("F_z", &NEWTON, weight_n, format!("-9.80665*{mass}*cos(beta)"), &MODEL);
    }
}
