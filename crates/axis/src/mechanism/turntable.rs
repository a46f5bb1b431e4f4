//! A turntable or drum of solid bodies.

use crate::fault::{AxisFault, AxisReport};
use crate::bodies::{body, body_fields};
use crate::driven::{Driven, OnFlange};
use mechanism::{Body, BodyError, MechanismKind, Rotor, RotorKind};
use project::sections::{BodySection, Fields, Section, Stated, StatedField, Turntable};
use project::{Fault, Hint};
use quantities::{Angle, Measure};
use std::ops::Range;

/// Returns `true` if the bodies can be determined; otherwise reports the fault.
fn knows_bodies(table: &Turntable, report: &mut AxisReport<'_>) -> bool {
    if table.bodies.is_written() && table.body.is_written() {
        report.fault(table.bodies.span(), Fault::BodiesTwice, None);
        return false;
    }
    let some = table.bodies.is_given() || table.body.get().is_some_and(|all| !all.0.is_empty());
    // A refused value has been reported already.
    if !some && table.is_whole() && !report.is_damaged() {
        let fault = Fault::MissingKey { path: table.body.path(), list: true };
        let hint = Hint::Example(format!("[[{}]] shape = \"disc\"", table.body.path()));
        report.fault(table.head().start(), fault, Some(hint));
    }
    some
}

/// Returns the place of a fault of a body; if the faulty value is not written, that of its shape.
fn place(table: &Turntable, index: usize, error: &BodyError) -> Range<usize> {
    match table.body.get().and_then(|all| all.0.get(index)) {
        Some(body) => {
            let named = body_fields(error, body).into_iter().find(|field| field.is_given());
            named.map_or_else(|| body.shape.span(), StatedField::span)
        }
        // The bodies as written are valid; with other values within their tolerances they may not be.
        None => table.bodies.span(),
    }
}

impl Driven for Turntable {
    fn kind(&self, report: &mut AxisReport<'_>) -> Option<MechanismKind> {
        if !knows_bodies(self, report) {
            return None;
        }
        let bodies: Vec<Body> = self.bodies()?.iter().map(body).collect::<Option<_>>()?;
        let bodies = match mechanism::inertia(&bodies) {
            Ok(total) => total,
            Err(errors) => {
                for each in errors {
                    report.fault(place(self, each.body, &each.error), AxisFault::Body(each.error), None);
                }
                return None;
            }
        };
        Some(MechanismKind::Rotor(Rotor {
            kind: RotorKind::Turntable,
            inertia: bodies.inertia,
            mass: bodies.mass,
            radius: bodies.centre_radius,
            payload_radius: self.payload_distance.or_zero(),
            angle: bodies.centre_angle,
            tilt: self.axis_tilt.or_zero(),
        }))
    }

    fn inertia(&self) -> Vec<&dyn StatedField> {
        vec![&self.bodies, &self.body]
    }

    fn start_angle(&self) -> Option<&Stated<Angle>> {
        Some(&self.start_angle)
    }

    fn bodies(&self) -> Option<&[BodySection]> {
        let lines = self.bodies.get().map(|all| all.bodies.as_slice());
        lines.or_else(|| self.body.get().map(|all| all.0.as_slice()))
    }

    fn carries(&self) -> bool {
        self.payload_distance.is_written() && self.payload_distance.value().is_none_or(|distance| distance.si() > 0.0)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Bodies(&self.axis_tilt))
    }
}
