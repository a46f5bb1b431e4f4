//! `[mechanism.arm]`: an unbalanced arm; the equations are those of a [`crate::Rotor`].

use crate::drawing::{Drawing, GroupAngles, Look, MechanismValues, Placement, polar};
use quantities::{Length, Mass, Measure, MomentOfInertia};
use std::f64::consts::FRAC_PI_2;

/// Distribution of the mass of an arm along its length, from the axis of rotation outwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArmShape {
    /// Slender, with the mass evenly distributed.
    Rod,
    /// Rectangular, with the mass evenly distributed over length and width; the axis is in the middle of one end.
    Bar,
    /// Slender, tapering to a point: the mass per length falls linearly to zero.
    Taper,
    /// The whole mass at the end.
    Point,
}

impl ArmShape {
    /// The shapes.
    pub const ALL: [Self; 4] = [Self::Rod, Self::Bar, Self::Taper, Self::Point];

    /// Returns the distance of the centre of mass from the axis as a share of the length \[1\].
    #[must_use]
    pub const fn centre(self) -> f64 {
        match self {
            Self::Rod | Self::Bar => 0.5,
            Self::Taper => 1.0 / 3.0,
            Self::Point => 1.0,
        }
    }

    /// Returns the moment of inertia about the axis and the distance of the centre of mass from it.
    ///
    /// rod J = m l²/3, s = l/2; bar J = m (l²/3 + b²/12), s = l/2; taper J = m l²/6, s = l/3; point J = m l², s = l
    ///
    /// # Symbols
    /// m mass, l length from the axis to the end, b width across the arm in the plane of rotation
    /// # Source
    /// docs/theory/mechanisms.md: ∫ x dm and ∫ x² dm of the distribution, theorem of Steiner
    /// # Valid
    /// rigid arm whose end is on the axis; slender except for the bar
    #[must_use]
    pub fn spread(self, mass: Mass, length: Length, width: Length) -> (MomentOfInertia, Length) {
        let (m, l, b) = (mass.si(), length.si(), width.si());
        let inertia = match self {
            Self::Rod => m * l * l / 3.0,
            Self::Bar => m * (l * l / 3.0 + b * b / 12.0),
            Self::Taper => m * l * l / 6.0,
            Self::Point => m * l * l,
        };
        (MomentOfInertia::from_si(inertia), Length::from_si(self.centre() * l))
    }

    /// Returns J and s as formulas of the derivation.
    pub(crate) const fn laws(self) -> [&'static str; 2] {
        match self {
            Self::Rod => ["m*l_a^2/3", "l_a/2"],
            Self::Bar => ["m*(l_a^2/3 + b_a^2/12)", "l_a/2"],
            Self::Taper => ["m*l_a^2/6", "l_a/3"],
            Self::Point => ["m*l_a^2", "l_a"],
        }
    }
}

/// An arm that is described by its shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmBody {
    /// Distribution of the mass.
    pub shape: ArmShape,
    /// l: length from the axis to the end.
    pub length: Length,
    /// b: width of a bar.
    pub width: Length,
}

/// The longer of both distances on the sheet.
const REACH: f64 = 215.0;

/// Angle of the drawn arm if no angle is stated \[rad\].
const NEUTRAL_RAD: f64 = 0.27;

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let axis = [92.0, 112.0];
    let start = figures.start_rad();
    let lean = figures.of("start_angle").unwrap_or(NEUTRAL_RAD);
    let [centre, payload] = distances(figures);
    let along = |distance: f64, aside: f64| polar(polar(axis, distance, lean), aside, lean + FRAC_PI_2);
    let end = centre.max(payload) + 8.0;
    let half = |distance: f64| 18.0 - 9.0 * distance / end;
    let weight = along(centre, 0.0);
    // The weight has no effect about a vertical axis.
    let share = figures.of("axis_tilt").map_or(1.0, |tilt| tilt.sin().abs());
    // A shape takes the place of inertia and centre of mass.
    let is_shaped = figures.length("length").is_some();
    let at_the_end = along(payload, 0.0);
    let mut drawing =
        Drawing::new().line(Look::Axis, [40.0, 112.0], [230.0, 112.0]).face(axis, 38.0).turns(start, axis, 1.0, |it| {
            it.outline(
                Look::Body,
                &[along(-6.0, 18.0), along(end, half(end)), along(end, -half(end)), along(-6.0, -18.0)],
            )
            .leaning_rect(Look::Body, along(payload, 0.0), [26.0, 28.0], lean)
            .circle(Look::Hole, axis, 8.0)
            .centre(weight)
            .line(Look::Thin, along(0.0, 0.0), along(0.0, -72.0))
            .line(Look::Thin, along(centre, -10.0), along(centre, -52.0))
            .line(Look::Thin, along(payload, -16.0), along(payload, -72.0))
            .dimension(along(0.0, -48.0), along(centre, -48.0))
            .dimension(along(0.0, -68.0), along(payload, -68.0))
            .calls("mass", "m", along(centre, 4.0), along(centre, 46.0))
        });
    let over = [along(0.4 * centre, -48.0), along(0.4 * centre, -36.0)];
    let far = [along(0.8 * payload, -68.0), along(0.8 * payload, -52.0)];
    // The call-outs of mass and inertia stand apart: that of a shaped arm between its centre and the payload.
    let at_j = match (is_shaped, (centre - 64.0).abs() < 34.0) {
        (true, _) => 0.5 * (centre + payload),
        (false, true) if centre + 60.0 < payload => centre + 40.0,
        (false, true) => centre - 40.0,
        (false, false) => 64.0,
    };
    let inside = [along(at_j, 10.0), along(at_j, 46.0)];
    drawing = if is_shaped {
        drawing.calls("length", "l", far[0], far[1]).calls("shape", "J", inside[0], inside[1]).calls(
            "payload_distance",
            "r_p",
            at_the_end,
            along(payload, 40.0),
        )
    } else {
        drawing.calls("inertia", "J", inside[0], inside[1]).calls("centre_distance", "s", over[0], over[1]).calls(
            "payload_distance",
            "r_p",
            far[0],
            far[1],
        )
    };
    if share > 0.05 {
        // The weight moves with the centre of mass and always points downwards.
        drawing = drawing.moves(
            &GroupAngles::round(start),
            weight,
            |angle| {
                let [x, y] = polar(axis, centre, lean + angle - start);
                Placement::shifted([x - weight[0], y - weight[1]])
            },
            |it| it.arrow([weight[0], weight[1] + 10.0], [weight[0], weight[1] + 12.0 + 30.0 * share]),
        );
    }
    // On the other side of the horizontal line, and beyond the call-out of the mass.
    let beyond = if lean > 0.0 { -0.35 } else { (lean + 46.0_f64.atan2(centre) + 0.5).max(0.35) };
    if lean.abs() > 0.05 {
        drawing = drawing.sweep(Look::Arrow, axis, 56.0, [0.0, lean]);
    }
    drawing
        .calls("start_angle", "φ_0", polar(axis, 56.0, 0.5 * lean), polar(axis, 76.0, beyond))
        .calls("friction_torque", "T_L", [66.0, 86.0], [34.0, 52.0])
        .calls("viscous_friction", "d", [62.0, 134.0], [26.0, 152.0])
        .calls("external_torque", "T_x", [86.0, 75.0], [64.0, 30.0])
        .calls("axis_tilt", "β", [64.0, 112.0], [24.0, 100.0])
}

/// Returns the distances of centre of mass and payload on the sheet, to scale.
fn distances(figures: &MechanismValues) -> [f64; 2] {
    let (shape, length) = (figures.of("shape").unwrap_or(0.5), figures.length("length"));
    let centre = figures.of("centre_distance").or(length.map(|length| shape * length));
    let payload = figures.length("payload_distance").or(length);
    let longest = centre.unwrap_or(0.0).max(payload.unwrap_or(0.0));
    let on_sheet = |metres: f64| (REACH * metres / longest).max(0.0);
    match (centre, payload) {
        (Some(centre), Some(payload)) if longest > 0.0 => [on_sheet(centre), on_sheet(payload).max(52.0)],
        _ => [0.53 * REACH, REACH],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Inertia and centre of mass of every shape are those of the integrals of its mass over a grid of its area.
    #[test]
    fn the_spread_of_a_shape_is_that_of_a_direct_integral() {
        for (m, l, b) in [(5.0, 0.6, 0.08), (0.3, 2.0, 0.5), (40.0, 0.2, 0.2)] {
            for shape in ArmShape::ALL {
                let width = if shape == ArmShape::Bar { b } else { 0.0 };
                let found = shape.spread(Mass::from_si(m), Length::from_si(l), Length::from_si(width));
                let cells = 400_u32;
                let middle = |k: u32| (f64::from(k) + 0.5) / f64::from(cells);
                let (mut mass, mut first, mut second) = (0.0, 0.0, 0.0);
                for k in 0..cells {
                    let x = middle(k);
                    let share = match shape {
                        ArmShape::Rod | ArmShape::Bar => 1.0,
                        ArmShape::Taper => 1.0 - x,
                        ArmShape::Point => f64::from(u8::from(k + 1 == cells)),
                    };
                    let x = if shape == ArmShape::Point { 1.0 } else { x };
                    for across in 0..40 {
                        let y = width * ((f64::from(across) + 0.5) / 40.0 - 0.5);
                        mass += share;
                        first += share * x * l;
                        second += share * (x * l * x * l + y * y);
                    }
                }
                let (inertia, centre) = (m * second / mass, first / mass);
                assert!((found.0.si() / inertia - 1.0).abs() < 5e-4, "{shape:?} {inertia}");
                assert!((found.1.si() / centre - 1.0).abs() < 5e-4, "{shape:?} {centre}");
            }
        }
    }
}
