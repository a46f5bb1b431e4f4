//! Curves that the user measured or digitised, for actuators of the catalogue.

use crate::about::About;
use crate::key::Variants;
use crate::read::Reader;
use crate::section::{OfKinds, Section, names, section};
use crate::stated::{Stated, StatedField};
use crate::value::{Rows, WordChoice, choices};
use crate::{Catalogue, Fault};
use actuator::{Battery, Curve, CurvePoint, Parameters};
use configurator::{Product, ProductId};
use order_code::{OrderCode, Pattern};
use provenance::{Datum, Grade, Source, Sourced};
use sizing::BrakeTimes;
use std::sync::{Arc, OnceLock};

/// Example of a curve.
pub(crate) const CURVE: &str = "[[\"0 1/min\", \"32 N m\"], [\"40 1/min\", \"25 N m\"]]";

section! {
    /// A curve of the user for actuators of the catalogue.
    CurveSection, CurveName of About::Curve {
        kind: Limit => needed;
        code: String => example("CHA-25A-100-*");
        points: Rows<CurvePoint> => example(CURVE);
        source: String;
    }
}

impl OfKinds for CurveSection {
    const VARIANTS: &'static Variants =
        &Variants { keys: Self::KEYS, by: "kind", kinds: &[of(0), of(1), of(2), of(3)], shared: &[] };
}

/// Returns the required and the optional keys of a curve.
#[allow(clippy::indexing_slicing, reason = "read while compiling: an index out of bounds does not compile")]
const fn of(kind: usize) -> (&'static str, &'static [&'static str], &'static [&'static str]) {
    (Limit::WORDS[kind], names!(CurveSection: code points source), &[])
}

/// Limit that a curve states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Limit {
    Continuous,
    Half,
    Quarter,
    ShortTime,
}

choices! {
    Limit { Continuous = "continuous", Half = "s3_50", Quarter = "s3_25", ShortTime = "short_time" }
}

/// The catalogue with the user's curves instead of its own, created on first use: reading a project, drawing its cycle
/// and comparing its texts do not need it.
#[derive(Clone, Debug)]
struct OwnCatalogue {
    catalogue: Arc<dyn Catalogue>,
    curves: Vec<UserCurve>,
    plain: OnceLock<Vec<Product>>,
    output_encoder: OnceLock<Vec<Product>>,
}

impl OwnCatalogue {
    fn changed(&self, output_encoder: bool) -> Vec<Product> {
        let mut products = self.catalogue.products(output_encoder).to_vec();
        for Product { id, parameters, .. } in &mut products {
            let curves = self.curves.iter().filter(|curve| id.is_allowed_by(&curve.pattern));
            curves.for_each(|curve| curve.apply(parameters));
        }
        products
    }
}

impl Catalogue for OwnCatalogue {
    fn products(&self, output_encoder: bool) -> &[Product] {
        let made = if output_encoder { &self.output_encoder } else { &self.plain };
        made.get_or_init(|| self.changed(output_encoder))
    }

    fn product(&self, id: &ProductId) -> Option<&Product> {
        let known = self.catalogue.product(id)?;
        let has_encoder = id.order_code().is_some_and(OrderCode::has_output_encoder);
        self.products(has_encoder).iter().find(|product| product.id == known.id)
    }

    fn brake_times(&self) -> Option<BrakeTimes> {
        self.catalogue.brake_times()
    }

    fn battery(&self) -> Datum<Battery> {
        self.catalogue.battery()
    }

    fn own_actuator(&self) -> Parameters {
        self.catalogue.own_actuator()
    }
}

/// A curve with the codes for which it holds.
#[derive(Clone, Debug)]
struct UserCurve {
    /// Number in the file, from one.
    index: usize,
    pattern: Pattern,
    kind: Limit,
    curve: Curve,
    source: String,
}

impl UserCurve {
    /// Replaces the curve of the catalogue.
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
            Limit::Continuous => &mut drivetrain.continuous_curve,
            Limit::Half => half,
            Limit::Quarter => quarter,
            Limit::ShortTime => &mut drivetrain.short_time_curve,
        };
        *place = known;
    }
}

/// Reads the catalogue with the curves of a project file, if it has any; faults are reported.
pub(crate) fn read(
    sections: &[CurveSection],
    catalogue: &Arc<dyn Catalogue>,
    reader: &mut Reader<'_>,
) -> Option<Arc<dyn Catalogue>> {
    let mut found = Vec::new();
    for (index, section) in sections.iter().enumerate().filter(|(_, section)| section.is_whole()) {
        let (Some(kind), Some(code)) = (section.kind.value(), section.code.get()) else { continue };
        let pattern = match Pattern::parse(code) {
            Ok(pattern) => pattern,
            Err(errors) => {
                for error in errors.iter() {
                    reader.fault(section.code.span(), Fault::Code(error.clone()), None);
                }
                continue;
            }
        };
        if !catalogue.products(false).iter().any(|product| product.id.is_allowed_by(&pattern)) {
            reader.fault(section.code.span(), Fault::NoSuchCode { written: code.clone() }, None);
            continue;
        }
        let source = section.source.get().cloned().unwrap_or_default();
        if let Some(curve) = curve(&section.points, reader) {
            found.push(UserCurve { index: index + 1, pattern, kind, curve, source });
        }
    }
    if found.is_empty() {
        return None;
    }
    let catalogue = Arc::clone(catalogue);
    Some(Arc::new(OwnCatalogue { catalogue, curves: found, plain: OnceLock::new(), output_encoder: OnceLock::new() }))
}

/// Builds a curve from its corner points.
pub(crate) fn curve(points: &Stated<Rows<CurvePoint>>, reader: &mut Reader<'_>) -> Option<Curve> {
    match Curve::new(points.get()?.values()) {
        Ok(curve) => Some(curve),
        Err(fault) => {
            reader.fault(points.span(), Fault::Curve(fault), None);
            None
        }
    }
}
