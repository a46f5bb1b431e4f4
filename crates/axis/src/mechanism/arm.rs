//! An unbalanced arm.

use super::parts::level;
use crate::assumption::Assumption;
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

/// Returns `true` if a rod is assumed: its length is stated, and nothing else of its shape.
fn is_rod(arm: &Arm) -> bool {
    let others: [&dyn StatedField; 4] = [&arm.shape, &arm.width, &arm.inertia, &arm.centre_distance];
    arm.length.is_written() && !others.iter().any(|field| field.is_written())
}

/// Returns `true` if the payload is assumed at the end of the arm: its length is stated, and no distance.
fn is_at_the_end(arm: &Arm) -> bool {
    arm.length.is_given() && !arm.payload_distance.is_written()
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
    if !is_rod(arm) {
        missing(arm, &arm.shape, report);
    }
    missing(arm, &arm.length, report);
    let shape = if is_rod(arm) { Some(ArmShape::Rod) } else { arm.shape.value() };
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
            payload_radius: if is_at_the_end(self) { &self.length } else { &self.payload_distance }.or_zero(),
            angle: Angle::from_si(0.0),
            tilt: level(&self.axis_tilt)?,
        }))
    }

    fn inertia(&self) -> Vec<&dyn StatedField> {
        vec![&self.inertia, &self.mass, &self.length, &self.width]
    }

    fn carries(&self) -> bool {
        let is_stated = self.payload_distance.is_written();
        is_at_the_end(self)
            || is_stated && self.payload_distance.value().is_none_or(|distance| distance.si() > 0.0)
    }

    fn assumptions(&self, carries: bool) -> Vec<Assumption> {
        let rod = is_rod(self).then_some(Assumption::ArmIsRod);
        let payload = (carries && is_at_the_end(self)).then_some(Assumption::PayloadAtArmEnd);
        rod.into_iter().chain(payload).collect()
    }

    fn shared(&self) -> &'static [Dimension] {
        TURNED
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Bodies(&self.axis_tilt))
    }
}

#[cfg(test)]
mod tests {
    use crate::assumption::Assumption;
    use crate::fault::AxisDiagnostic;
    use crate::{AxisProject, NoCatalogue};

    fn read(arm: &str, payload: &str) -> Result<AxisProject, Vec<AxisDiagnostic>> {
        let motion = |way: &str, payload: &str| {
            format!("[[motion]]\nlaw = \"modified_sine\"\ndistance = \"{way}90 deg\"\ntime = \"1 s\"\n{payload}")
        };
        let text =
            format!("format = 1\n[mechanism.arm]\nmass = \"6 kg\"\n{arm}{}{}", motion("", payload), motion("-", ""));
        AxisProject::read(&text, &NoCatalogue::shared(), &|_, _| None)
    }

    /// An arm of which only the length is stated is a rod that carries the payload at its end; both are listed, and stating
    /// them changes nothing.
    #[test]
    fn a_length_alone_is_a_rod_with_the_payload_at_its_end() {
        for millimetres in [80, 450, 1200] {
            let length = format!("length = \"{millimetres} mm\"\n");
            let stated = format!("{length}shape = \"rod\"\npayload_distance = \"{millimetres} mm\"\n");
            for payload in ["payload = \"2 kg\"\n", ""] {
                let (assumed, same) = (read(&length, payload).unwrap(), read(&stated, payload).unwrap());
                assert_eq!(assumed.axis.mechanism.kind, same.axis.mechanism.kind, "{length}");
                let found: Vec<_> = assumed.assumed().into_iter().filter(|each| is_own(each.assumption)).collect();
                let values: Vec<_> = found.iter().filter_map(|each| each.value.clone()).collect();
                let end = format!("{millimetres} mm");
                let expected: &[&str] = if payload.is_empty() { &["rod"] } else { &["rod", &end] };
                assert_eq!(values, expected, "{length}{payload}");
                assert!(!same.assumptions.iter().any(|each| is_own(*each)), "{stated}");
            }
        }
    }

    fn is_own(assumption: Assumption) -> bool {
        matches!(assumption, Assumption::ArmIsRod | Assumption::PayloadAtArmEnd)
    }

    #[test]
    fn an_arm_that_is_described_partially_is_refused() {
        for arm in [
            "",
            "shape = \"rod\"\n",
            "length = \"1 m\"\nwidth = \"80 mm\"\n",
            "length = \"1 m\"\ninertia = \"1 kg m^2\"\n",
            "length = \"1 m\"\ncentre_distance = \"0.3 m\"\n",
            "inertia = \"1 kg m^2\"\n",
        ] {
            assert!(read(arm, "").is_err(), "{arm}");
        }
        // Described by its inertia it has no end.
        let arm = "inertia = \"1 kg m^2\"\ncentre_distance = \"0.3 m\"\n";
        assert!(read(arm, "").is_ok() && read(arm, "payload = \"2 kg\"\n").is_err());
    }
}
