//! Curves, torsion, bearing, battery and inertia as records.

use super::check::{assumptions, check};
use crate::sizing_use::Candidate;
use crate::torsion::TorsionAnswer;
use actuator::{BatteryLife, CurvePoint, PerformanceCurve};
use answers::{
    Battery, BearingOfSize, Bearings, Body, Centre, Curve, CurveKind, Curves, Id, Inertia, Number, TorqueExceeded,
    Torsion, Units,
};
use axis::{AxisProject, BodyAnswer, InertiaAnswer};
use configurator::ProductId;
use provenance::Datum;
use quantities::unit::{
    ARCMINUTE, DEGREE, HOUR, KILOGRAM, KILOGRAM_SQUARE_METRE, MILLIMETRE, NEWTON_METRE, NEWTON_METRE_PER_RADIAN,
    PERCENT, RADIAN, REVOLUTION_PER_MINUTE, VOLT, YEAR,
};
use quantities::{Angle, Language, Measure};
use words::{curve_title, equation_text, source_text};

fn points(points: &[CurvePoint]) -> Vec<[Number; 2]> {
    let point = |point: &CurvePoint| {
        [Number::in_unit(point.speed.si(), &REVOLUTION_PER_MINUTE), Number::in_unit(point.torque.si(), &NEWTON_METRE)]
    };
    points.iter().map(point).collect()
}

/// Returns the curves of the torque-speed plane.
#[must_use]
pub fn curves(id: &ProductId, curves: &[PerformanceCurve], language: Language) -> Curves {
    let curve = |curve: &PerformanceCurve| {
        let (kind, duty) = match curve.kind {
            actuator::CurveKind::Continuous => (CurveKind::Continuous, None),
            actuator::CurveKind::S3 { duty, .. } => (CurveKind::S3, Some(Number(duty.si() * 100.0))),
            actuator::CurveKind::ShortTime => (CurveKind::ShortTime, None),
        };
        Curve {
            kind,
            duty,
            title: curve_title(&curve.kind, language),
            voltage: curve.voltage.map(|voltage| Number::in_unit(voltage.si(), &VOLT)),
            points: points(&curve.points),
            upper: curve.upper.as_deref().map(points),
            grade: Id(curve.grade),
            source: source_text(&curve.source, language),
        }
    };
    let units = [("n", &REVOLUTION_PER_MINUTE), ("T", &NEWTON_METRE), ("U", &VOLT), ("ED", &PERCENT)];
    Curves { code: id.to_string(), units: Units::of(&units), curves: curves.iter().map(curve).collect() }
}

/// Returns the torsion of a gear under a torque.
#[must_use]
pub fn torsion(id: &ProductId, answer: &TorsionAnswer, language: Language) -> Torsion {
    let minutes = |angle: &Datum<Angle>| angle.known().map(|known| Number::in_unit(known.value.si(), &ARCMINUTE));
    Torsion {
        code: id.to_string(),
        torque: Number::in_unit(answer.torque.si(), &NEWTON_METRE),
        angle_rad: Number::in_unit(answer.angle.si(), &RADIAN),
        angle_arcmin: Number::in_unit(answer.angle.si(), &ARCMINUTE),
        region: answer.region,
        torque_1: Number::in_unit(answer.curve.torque_1.si(), &NEWTON_METRE),
        torque_2: Number::in_unit(answer.curve.torque_2.si(), &NEWTON_METRE),
        stiffness: answer.curve.stiffness.map(|k| Number::in_unit(k.si(), &NEWTON_METRE_PER_RADIAN)),
        hysteresis_loss: minutes(&answer.hysteresis_loss),
        lost_motion: minutes(&answer.lost_motion),
        exceeds: answer
            .exceeded()
            .map(|(symbol, limit)| TorqueExceeded {
                symbol,
                limit: Number::in_unit(limit.value.si(), &NEWTON_METRE),
                grade: Id(limit.grade),
                source: source_text(&limit.source, language),
                errata: limit.errata.to_vec(),
            })
            .collect(),
        units: Units::of(&[
            ("T", &NEWTON_METRE),
            ("K", &NEWTON_METRE_PER_RADIAN),
            ("hysteresis_loss", &ARCMINUTE),
            ("lost_motion", &ARCMINUTE),
        ]),
        source: equation_text("73.1 – 73.4", language),
    }
}

/// Returns the checks of the output bearing of each size.
#[must_use]
pub fn bearings(sizes: &[Candidate<'_>], project: &AxisProject, language: Language) -> Bearings {
    let one = |candidate: &Candidate<'_>| BearingOfSize {
        size: candidate.product.size_name().to_owned(),
        fits: crate::chapters::bearing_checks(candidate).all(|check| check.verdict != sizing::Verdict::Fail),
        checks: crate::chapters::bearing_checks(candidate).map(|each| check(each, language)).collect(),
    };
    Bearings { sizes: sizes.iter().map(one).collect(), assumptions: assumptions(project, language) }
}

/// Returns the life of the battery.
#[must_use]
pub fn battery(battery: &BatteryLife) -> Battery {
    Battery {
        hours_per_day: Number::in_unit(battery.per_day.si(), &HOUR),
        storage: Number::in_unit(battery.storage.si(), &YEAR),
        life: Number::in_unit(battery.life.value.si(), &YEAR),
        exchange_recommended: Number::in_unit(battery.exchange_recommended.si(), &YEAR),
        exchange_latest: Number::in_unit(battery.exchange_latest.si(), &YEAR),
        capped: battery.capped,
        unit: YEAR.json,
        grade: Id(battery.life.grade),
        source: battery.life.source.to_string(),
    }
}

/// Returns the bodies with the parts of their inertia, and the total.
#[must_use]
pub fn inertia(answer: &InertiaAnswer) -> Inertia {
    let total = &answer.total;
    let units =
        [("J", &KILOGRAM_SQUARE_METRE), ("m", &KILOGRAM), ("r", &MILLIMETRE), ("angle", &DEGREE), ("T", &NEWTON_METRE)];
    Inertia {
        bodies: answer.bodies.iter().map(body).collect(),
        inertia: Number::in_unit(total.inertia.si(), &KILOGRAM_SQUARE_METRE),
        mass: Number::in_unit(total.mass.si(), &KILOGRAM),
        centre: Centre {
            radius: Number::in_unit(total.centre_radius.si(), &MILLIMETRE),
            angle: Number::in_unit(total.centre_angle.si(), &DEGREE),
        },
        gravity_torque: Number::in_unit(total.gravity_torque_max().si(), &NEWTON_METRE),
        units: Units::of(&units),
    }
}

fn body(answer: &BodyAnswer) -> Body {
    let parts = &answer.parts;
    Body {
        shape: answer.shape.name,
        count: answer.body.count,
        mass: Number::in_unit(parts.mass.si(), &KILOGRAM),
        distance: Number::in_unit(answer.body.distance.si(), &MILLIMETRE),
        angle: Number::in_unit(answer.body.angle.si(), &DEGREE),
        own: Number::in_unit(parts.own.si(), &KILOGRAM_SQUARE_METRE),
        steiner: Number::in_unit(parts.steiner.si(), &KILOGRAM_SQUARE_METRE),
        total: Number::in_unit(parts.total.si(), &KILOGRAM_SQUARE_METRE),
    }
}
