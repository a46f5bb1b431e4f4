//! Curves that the user measured or digitised, for actuators of the catalogue.

use crate::catalogue::Catalogue;
use crate::fault::{AxisFault, AxisReport};
use actuator::{Battery, Curve, CurveFault, CurvePoint, Parameters};
use configurator::{Product, ProductId};
use order_code::{OrderCode, Pattern};
use project::Fault;
use project::sections::{CurveLimit, CurveRow, CurveSection, Rows, Section, Stated, StatedField};
use provenance::{Datum, Grade, Source, Sourced};
use quantities::{AngularVelocity, Measure, Torque};
use sizing::BrakeTimes;
use std::sync::{Arc, OnceLock};

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

    fn offers_series(&self) -> bool {
        self.catalogue.offers_series()
    }

    fn has_files(&self) -> bool {
        self.catalogue.has_files()
    }

    fn names(&self) -> Vec<String> {
        self.catalogue.names()
    }
}

/// A curve with the codes for which it holds.
#[derive(Clone, Debug)]
struct UserCurve {
    /// Number in the file, from one.
    index: usize,
    pattern: Pattern,
    kind: CurveLimit,
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
            CurveLimit::Continuous => &mut drivetrain.continuous_curve,
            CurveLimit::Half => half,
            CurveLimit::Quarter => quarter,
            CurveLimit::ShortTime => &mut drivetrain.short_time_curve,
        };
        *place = known;
    }
}

/// Reads the catalogue with the curves of a project file, if it has any; faults are reported.
pub(crate) fn read(
    sections: &[CurveSection],
    catalogue: &Arc<dyn Catalogue>,
    report: &mut AxisReport<'_>,
) -> Option<Arc<dyn Catalogue>> {
    let mut found = Vec::new();
    for (index, section) in sections.iter().enumerate().filter(|(_, section)| section.is_whole()) {
        let (Some(kind), Some(code)) = (section.kind.value(), section.code.get()) else { continue };
        let pattern = match Pattern::parse(code) {
            Ok(pattern) => pattern,
            Err(errors) => {
                for error in errors.iter() {
                    report.fault(section.code.span(), Fault::Code(error.clone()), None);
                }
                continue;
            }
        };
        if !catalogue.products(false).iter().any(|product| product.id.is_allowed_by(&pattern)) {
            report.fault(section.code.span(), Fault::NoSuchCode { written: code.clone() }, None);
            continue;
        }
        let source = section.source.get().cloned().unwrap_or_default();
        if let Some(curve) = curve(&section.points, report) {
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
pub(crate) fn curve(points: &Stated<Rows<CurveRow>>, report: &mut AxisReport<'_>) -> Option<Curve> {
    let rows = points.get()?;
    match Curve::new(rows.values().iter().map(corner).collect()) {
        Ok(curve) => rows.is_whole.then_some(curve),
        // A faulty row is one of the points, and may be the first.
        Err(CurveFault::TooFewPoints | CurveFault::DoesNotStartAtZero) if !rows.is_whole => None,
        Err(fault) => {
            report.fault(points.span(), AxisFault::Curve(fault), None);
            None
        }
    }
}

fn corner(row: &CurveRow) -> CurvePoint {
    let [speed, torque] = row.si();
    CurvePoint { speed: AngularVelocity::from_si(speed), torque: Torque::from_si(torque) }
}
