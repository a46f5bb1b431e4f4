//! An unbalanced arm.

use super::parts::level;
use crate::choices;
use crate::driven::{Driven, OnFlange, TURNED};
use crate::fault::AxisReport;
use mechanism::{ArmBody, MechanismKind, Rotor, RotorKind};
use project::choices::ArmShape;
use project::sections::{Arm, Fields, Section, StatedField, Written};
use project::{Fault, Hint, example};
use quantities::{Angle, Dimension, Length, Measure, MomentOfInertia};

/// Description, moment of inertia of an arm about its axis, and distance of its centre of mass from it.
type Spread = (RotorKind, MomentOfInertia, Length);

/// Reports a key that is missing at the start of the section.
fn missing(arm: &Arm, field: &dyn StatedField, report: &mut AxisReport<'_>) {
    if field.is_written() || report.is_damaged() {
        return;
    }
    let key = Arm::KEYS.iter().find(|key| key.name == field.name());
    let fault = Fault::MissingKey { path: field.path(), list: false };
    report.fault(arm.head().start(), fault, key.and_then(example).map(Hint::Example));
}

/// Returns the spread of the mass: that of a shape, or as stated.
fn spread(arm: &Arm, report: &mut AxisReport<'_>) -> Option<Spread> {
    let of_shape: [&dyn StatedField; 3] = [&arm.shape, &arm.length, &arm.width];
    let stated: [&dyn StatedField; 2] = [&arm.inertia, &arm.centre_distance];
    // An arm of which nothing is stated is described by its shape.
    if !of_shape.iter().any(|field| field.is_written()) && stated.iter().any(|field| field.is_written()) {
        stated.iter().for_each(|field| missing(arm, *field, report));
        return Some((RotorKind::Arm, arm.inertia.value()?, arm.centre_distance.value()?));
    }
    missing(arm, &arm.shape, report);
    missing(arm, &arm.length, report);
    let shape = arm.shape.value();
    let mut foreign = |field: &dyn StatedField| {
        if field.is_given()
            && let Some(shape) = shape
        {
            let fault = Fault::KeyOfAnotherKind { path: field.path(), by: arm.shape.name(), kind: shape.written() };
            report.fault(field.span(), fault, None);
        }
    };
    stated.iter().for_each(|field| foreign(*field));
    let is_bar = shape == Some(ArmShape::Bar);
    if is_bar {
        missing(arm, &arm.width, report);
    } else {
        foreign(&arm.width);
    }
    let is_contrary = stated.iter().any(|field| field.is_written()) || !is_bar && arm.width.is_written();
    let width = if is_bar { arm.width.value()? } else { Length::from_si(0.0) };
    let body = ArmBody { shape: choices::arm_shape(shape?), length: arm.length.value()?, width };
    let (inertia, radius) = body.shape.spread(arm.mass.value()?, body.length, width);
    (!is_contrary).then_some((RotorKind::Shaped(body), inertia, radius))
}

impl Driven for Arm {
    fn kind(&self, report: &mut AxisReport<'_>) -> Option<MechanismKind> {
        let (kind, inertia, radius) = spread(self, report)?;
        Some(MechanismKind::Rotor(Rotor {
            kind,
            inertia,
            mass: self.mass.value()?,
            radius,
            payload_radius: self.payload_distance.or_zero(),
            angle: Angle::from_si(0.0),
            tilt: level(&self.axis_tilt)?,
        }))
    }

    fn inertia(&self) -> Vec<&dyn StatedField> {
        vec![&self.inertia, &self.mass, &self.length, &self.width]
    }

    fn carries(&self) -> bool {
        self.payload_distance.is_written() && self.payload_distance.value().is_none_or(|distance| distance.si() > 0.0)
    }

    fn shared(&self) -> &'static [Dimension] {
        TURNED
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Bodies(&self.axis_tilt))
    }
}
