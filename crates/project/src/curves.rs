//! Curves that the user measured or digitised, for actuators of the catalogue.

use crate::Fault;
use crate::read::Reader;
use crate::section::Section;
use actuator::{Curve, CurvePoint, Parameters};
use configurator::{actuators, catalogue_actuators};
use order_code::{Option1, OrderCode, Pattern};
use provenance::{Datum, Grade, Source, Sourced};
use quantities::{AngularVelocity, Measure, Torque};
use std::sync::{Arc, OnceLock};

/// What a curve limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Continuous,
    Half,
    Quarter,
    ShortTime,
}

/// The catalogue with the user's curves in the place of its own, made when it is first asked for: to read a project, to
/// draw its cycle or to compare its texts takes none.
#[derive(Clone, Debug)]
pub struct OwnCatalogue {
    curves: Vec<UserCurve>,
    plain: OnceLock<Vec<(OrderCode, Parameters)>>,
    output_encoder: OnceLock<Vec<(OrderCode, Parameters)>>,
}

impl OwnCatalogue {
    /// Its actuators, with or without the encoder at the output.
    #[must_use]
    pub fn actuators(&self, output_encoder: bool) -> &[(OrderCode, Parameters)] {
        let (made, option_1) =
            if output_encoder { (&self.output_encoder, Some(Option1::EC)) } else { (&self.plain, None) };
        made.get_or_init(|| self.changed(option_1))
    }

    fn changed(&self, option_1: Option<Option1>) -> Vec<(OrderCode, Parameters)> {
        let mut actuators = actuators(option_1).to_vec();
        for (code, parameters) in &mut actuators {
            self.curves.iter().filter(|curve| curve.pattern.matches(code)).for_each(|curve| curve.apply(parameters));
        }
        actuators
    }
}

/// A curve with the codes that it holds for.
#[derive(Clone, Debug)]
struct UserCurve {
    /// Its number in the file, from one.
    index: usize,
    pattern: Pattern,
    kind: Kind,
    curve: Curve,
    source: String,
}

impl UserCurve {
    /// Puts the curve in the place of the catalogue's.
    fn apply(&self, parameters: &mut Parameters) {
        let known = Datum::Known(Sourced {
            value: self.curve.clone(),
            source: Source::Project { key: format!("curve[{}].points, {}", self.index, self.source).into() },
            grade: Grade::Published,
            errata: &[],
        });
        let drivetrain = Arc::make_mut(&mut parameters.drivetrain);
        let [half, quarter] = &mut drivetrain.s3_curves;
        let place = match self.kind {
            Kind::Continuous => &mut drivetrain.continuous_curve,
            Kind::Half => half,
            Kind::Quarter => quarter,
            Kind::ShortTime => &mut drivetrain.short_time_curve,
        };
        *place = known;
    }
}

/// The catalogue with the curves of a project file; faults are told.
pub(crate) fn read(root: &Section, reader: &mut Reader<'_>) -> Option<Arc<OwnCatalogue>> {
    let mut found = Vec::new();
    for (index, section) in root.tables("curve").iter().enumerate().filter(|(_, section)| section.is_whole()) {
        let kind = match section.text("kind") {
            Some("continuous") => Kind::Continuous,
            Some("s3_50") => Kind::Half,
            Some("s3_25") => Kind::Quarter,
            _ => Kind::ShortTime,
        };
        let Some(code) = section.text("code") else { continue };
        let pattern = match Pattern::parse(code) {
            Ok(pattern) => pattern,
            Err(errors) => {
                for error in errors.iter() {
                    reader.fault(section.span_of("code"), Fault::Code(error.clone()), None);
                }
                continue;
            }
        };
        if !catalogue_actuators().iter().any(|(code, _)| pattern.matches(code)) {
            reader.fault(section.span_of("code"), Fault::NoSuchCode { written: code.to_owned() }, None);
            continue;
        }
        let source = section.text("source").unwrap_or_default().to_owned();
        if let Some(curve) = curve(section, "points", reader) {
            found.push(UserCurve { index: index + 1, pattern, kind, curve, source });
        }
    }
    (!found.is_empty())
        .then(|| Arc::new(OwnCatalogue { curves: found, plain: OnceLock::new(), output_encoder: OnceLock::new() }))
}

/// A curve by its corner points.
pub(crate) fn curve(section: &Section, key: &str, reader: &mut Reader<'_>) -> Option<Curve> {
    section.get(key)?;
    let points = section.rows(key).iter().filter_map(|row| match row.as_slice() {
        [speed, torque] => {
            Some(CurvePoint { speed: AngularVelocity::from_si(*speed), torque: Torque::from_si(*torque) })
        }
        _ => None,
    });
    match Curve::new(points.collect()) {
        Ok(curve) => Some(curve),
        Err(fault) => {
            reader.fault(section.span_of(key), Fault::Curve(fault), None);
            None
        }
    }
}
