//! A turntable or drum of solid bodies.

use super::parts::{Friction, Losses};
use super::{Driven, MechanismName, OnFlange};
use crate::Assumption;
use crate::about::About;
use crate::bodies::{BodySection, fields};
use crate::read::Reader;
use crate::section::{Fields, Section, section};
use crate::stated::{StatedField, Stated};
use crate::value::{BodyLines, Tables};
use crate::{Fault, Hint};
use mechanism::{Body, BodyError, MechanismKind, Rotor, RotorKind};
use quantities::{Angle, Measure, Length};
use std::ops::Range;

section! {
    /// Solid bodies that turn with the output.
    Turntable, TurntableName of About::Mechanism, MechanismName::Turntable {
        body: Tables<BodySection>;
        bodies: BodyLines;
        axis_tilt: Angle => noted(Assumption::AxisVertical);
        start_angle: Angle;
        payload_distance: Length => not_negative;
        ..friction: Friction;
        ..losses: Losses;
    }
}

impl Turntable {
    /// Returns `true` if the bodies can be determined; otherwise reports the fault.
    fn knows_bodies(&self, reader: &mut Reader<'_>) -> bool {
        if self.bodies.is_written() && self.body.is_written() {
            reader.fault(self.bodies.span(), Fault::BodiesTwice, None);
            return false;
        }
        let some = self.bodies.is_given() || self.body.get().is_some_and(|all| !all.0.is_empty());
        // A refused value has been reported already.
        if !some && self.is_whole() && !reader.is_damaged() {
            let fault = Fault::MissingKey { path: self.body.path(), list: true };
            let hint = Hint::Example(format!("[[{}]] shape = \"disc\"", self.body.path()));
            reader.fault(self.head().start(), fault, Some(hint));
        }
        some
    }

    /// Returns the place of a fault of a body; if the faulty value is not written, that of its shape.
    fn place(&self, index: usize, error: &BodyError) -> Range<usize> {
        match self.body.get().and_then(|all| all.0.get(index)) {
            Some(body) => {
                let named = fields(error, body).into_iter().find(|field| field.is_given());
                named.map_or_else(|| body.shape.span(), StatedField::span)
            }
            // The bodies as written are valid; with other values within their tolerances they may not be.
            None => self.bodies.span(),
        }
    }
}

impl Driven for Turntable {
    fn kind(&self, reader: &mut Reader<'_>) -> Option<MechanismKind> {
        if !self.knows_bodies(reader) {
            return None;
        }
        let bodies: Vec<Body> = self.bodies()?.iter().map(BodySection::body).collect::<Option<_>>()?;
        let bodies = match mechanism::inertia(&bodies) {
            Ok(total) => total,
            Err(errors) => {
                for each in errors {
                    reader.fault(self.place(each.body, &each.error), Fault::Body(each.error), None);
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
        let lines = self.bodies.get().map(|all| all.0.as_slice());
        lines.or_else(|| self.body.get().map(|all| all.0.as_slice()))
    }

    fn carries(&self) -> bool {
        self.payload_distance.is_written() && self.payload_distance.value().is_none_or(|distance| distance.si() > 0.0)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Bodies(&self.axis_tilt))
    }
}
