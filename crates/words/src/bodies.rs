//! Words about solid bodies.

use crate::pick;
use crate::texts::said;
use mechanism::BodyError;
use project::{BodyKind, BodyShape};
use quantities::unit::{KILOGRAM, KILOGRAM_PER_CUBIC_METRE, MILLIMETRE};
use quantities::{Language, Measure, Unit, format_significant, with_symbol};

/// Returns the name of the shape of a body.
#[must_use]
pub const fn shape_title(shape: &BodyShape, language: Language) -> &'static str {
    let (en, de) = match shape.kind {
        BodyKind::Cylinder => ("cylinder", "Zylinder"),
        BodyKind::Disc => ("disc", "Scheibe"),
        BodyKind::Tube => ("tube", "Rohr"),
        BodyKind::Box => ("box", "Quader"),
        BodyKind::Cone => ("cone", "Kegel"),
        BodyKind::Sphere => ("sphere", "Kugel"),
        BodyKind::Point => ("point", "Punktmasse"),
        BodyKind::Rod => ("rod", "Stab"),
    };
    pick(language, en, de)
}

/// Returns the fault of an impossible body, in one sentence.
pub(super) fn fault(error: &BodyError, language: Language) -> String {
    let positive = |key: &str, si: f64, unit: &Unit, or_zero: bool| {
        let value = with_symbol(&format_significant(unit.from_si(si), 4, language), unit.symbol_in(language));
        if or_zero {
            said!(language =>
                "`{key}` must not be negative: {value}"
                | "`{key}` darf nicht negativ sein: {value}"
            )
        } else {
            said!(language =>
                "`{key}` must be greater than zero: {value}"
                | "`{key}` muss größer als null sein: {value}"
            )
        }
    };
    match error {
        BodyError::DimensionOutOfRange { field, value } => positive(field, value.si(), &MILLIMETRE, *field == "inner"),
        BodyError::DimensionMissing { field } => said!(language =>
            "`{field}` is missing: required for a mass from `density` and for a body across the axis"
            | "es fehlt `{field}`: erforderlich für eine Masse aus `density` und für einen Körper quer zur Achse"
        ),
        BodyError::InnerNotBelowOuter { .. } => said!(language =>
            "`inner` must be smaller than `outer`"
            | "`inner` muss kleiner als `outer` sein"
        ),
        BodyError::NoMass => said!(language =>
            "neither `mass` nor `density` is given"
            | "weder `mass` noch `density` angegeben"
        ),
        BodyError::MassAndDensity { .. } => said!(language =>
            "`mass` and `density` are both given; state only one of them"
            | "`mass` und `density` sind beide angegeben; nur eines davon angeben"
        ),
        BodyError::NoVolume => said!(language =>
            "this shape has no volume; `density` cannot give a mass"
            | "diese Form hat kein Volumen; aus `density` ergibt sich keine Masse"
        ),
        BodyError::MassOutOfRange { mass } => positive("mass", mass.si(), &KILOGRAM, false),
        BodyError::DensityOutOfRange { density } => positive("density", density.si(), &KILOGRAM_PER_CUBIC_METRE, false),
        BodyError::DistanceOutOfRange { distance } => positive("distance", distance.si(), &MILLIMETRE, true),
        BodyError::NoPiece => said!(language => "`count` must be at least 1" | "`count` muss mindestens 1 sein"),
        BodyError::AngleNotFinite => said!(language =>
            "`angle` is not a finite number"
            | "`angle` ist keine endliche Zahl"
        ),
        BodyError::BeyondNumbers => said!(language =>
            "the moment of inertia exceeds the numerical range"
            | "das Massenträgheitsmoment liegt außerhalb des Zahlenbereichs"
        ),
    }
}
