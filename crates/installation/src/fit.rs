//! Fits of the pilots: limit deviations of a pilot and of the bore on it, and the clearance between them.

use catalogue::Cell;
use order_code::OrderCode;
use provenance::{Datum, Grade, Source, Sourced};
use quantities::unit::MILLIMETRE;
use quantities::{Length, Measure, QuantityError, Unit, identified, parse_as};

identified! {
    /// Side of the actuator with a joint.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Side {
        /// Output flange, which bears the load.
        Load = "load",
        /// Housing, which is mounted on the machine.
        Housing = "housing",
    }
}

/// Limit deviations from a nominal size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviations {
    /// Upper limit deviation: ES of a bore, es of a shaft.
    pub upper: Length,
    /// Lower limit deviation: EI of a bore, ei of a shaft.
    pub lower: Length,
}

/// The requested bore on a pilot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bore {
    /// A tolerance zone of ISO 286: `H7`.
    Zone(&'static str),
    /// Limit deviations stated by the user.
    Limits(Deviations),
}

identified! {
    /// Kind of fit in ISO 286-1.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum FitKind {
        /// Clearance fit: zero clearance at the limit, never interference.
        Clearance = "clearance",
        /// Transition fit: clearance or interference, depending on the actual sizes.
        Transition = "transition",
        /// Interference fit: never clearance.
        Interference = "interference",
    }
}

/// A pilot with the bore on it.
#[derive(Clone, Debug, PartialEq)]
pub struct PilotFit {
    /// Side of the pilot.
    pub side: Side,
    /// Nominal diameter from the manual.
    pub nominal: Sourced<Length>,
    /// Tolerance zone of the pilot from the manual: `h7`.
    pub pilot_zone: &'static str,
    /// Limit deviations of the pilot.
    pub pilot: Sourced<Deviations>,
    /// Zone that the manual recommends for the bore.
    pub recommended: Sourced<&'static str>,
    /// Requested or recommended bore.
    pub bore: Bore,
    /// Limit deviations of the bore.
    pub bore_deviations: Deviations,
    /// Source of the deviations; `None` if they are given by the caller.
    pub bore_source: Option<Source>,
    /// Smallest clearance; negative for interference.
    pub clearance_min: Length,
    /// Largest clearance.
    pub clearance_max: Length,
    /// Kind of fit.
    pub kind: FitKind,
}

/// Faults of a requested bore.
#[derive(Clone, Debug, PartialEq)]
pub enum BoreFault {
    /// The text is neither a tolerance zone of the table nor limit deviations.
    UnknownZone {
        /// Text of the bore.
        written: String,
        /// Zones of the table.
        known: Vec<&'static str>,
    },
    /// A limit deviation is no length.
    NoLength(QuantityError),
    /// The upper limit deviation is below the lower one.
    UpsideDown {
        /// Upper limit deviation as stated.
        upper: Length,
        /// Lower limit deviation as stated.
        lower: Length,
    },
    /// A limit deviation is too large for a fit, probably because of a wrong unit.
    TooLarge {
        /// Deviation as stated.
        deviation: Length,
        /// Largest accepted deviation.
        most: Length,
    },
}

/// Largest accepted limit deviation \[mm\]: ten times IT8 at 255 mm.
const DEVIATION_MOST_MM: f64 = 1.0;

/// Length below which a clearance counts as zero \[m\]: unit conversions round far below a nanometre.
const NOTHING_M: f64 = 1e-12;

/// Parses a bore: a zone such as `H7`, limit deviations such as `+0.012/-0.003 mm`, or `±0.01 mm`.
///
/// # Errors
/// [`BoreFault`] if the text is neither.
pub fn read_bore(text: &str) -> Result<Bore, BoreFault> {
    let text = text.trim();
    let length = |text: &str| parse_as::<Length>(text).map_err(BoreFault::NoLength);
    let deviations = if let Some(half) = text.strip_prefix('±') {
        let half = length(half)?;
        Deviations { upper: half, lower: -half }
    } else if let Some((upper, lower)) = text.split_once('/') {
        let unit = lower.trim().trim_start_matches(|sign: char| sign.is_ascii_digit() || "+-−. ".contains(sign));
        // The unit is stated once for both, or with each.
        let upper = if upper.contains(|sign: char| sign.is_alphabetic()) {
            upper.to_owned()
        } else {
            format!("{upper} {unit}")
        };
        Deviations { upper: length(&upper)?, lower: length(lower)? }
    } else {
        let known = bore_zones();
        return match known.iter().find(|zone| zone.eq_ignore_ascii_case(text)) {
            // h7 is a shaft: upper and lower case differ.
            Some(zone) if text.starts_with(|letter: char| letter.is_ascii_uppercase()) => Ok(Bore::Zone(zone)),
            _ => Err(BoreFault::UnknownZone { written: text.to_owned(), known }),
        };
    };
    let most = Length::new_in(DEVIATION_MOST_MM, &MILLIMETRE);
    if let Some(deviation) =
        [deviations.upper, deviations.lower].into_iter().find(|deviation| deviation.si().abs() > most.si() + NOTHING_M)
    {
        return Err(BoreFault::TooLarge { deviation, most });
    }
    if deviations.upper.si() < deviations.lower.si() {
        return Err(BoreFault::UpsideDown { upper: deviations.upper, lower: deviations.lower });
    }
    Ok(Bore::Limits(deviations))
}

fn iso_cells() -> &'static [Cell] {
    catalogue::table_cells("iso286")
}

/// Returns zone and range of a cell of the ISO table: `H7, 50 ... 80 mm`.
fn zone_of(cell: &'static Cell) -> Option<(&'static str, f64, f64)> {
    let (zone, range) = cell.place.condition.split_once(", ")?;
    let (over, to) = range.strip_suffix(" mm")?.split_once(" ... ")?;
    Some((zone, over.parse().ok()?, to.parse().ok()?))
}

/// Returns the tolerance zones of bores in the order of the table.
#[must_use]
pub fn bore_zones() -> Vec<&'static str> {
    let mut zones: Vec<&'static str> = Vec::new();
    for cell in iso_cells().iter().filter(|cell| cell.place.symbol == "deviation_upper") {
        if let Some((zone, ..)) = zone_of(cell)
            && zone.starts_with(|letter: char| letter.is_ascii_uppercase())
            && !zones.contains(&zone)
        {
            zones.push(zone);
        }
    }
    zones
}

/// Returns the limit deviations of a tolerance zone at a nominal size; not stated outside the table.
///
/// # Source
/// ISO 286-2, data/published/iso286.toml
/// # Valid
/// nominal sizes over 30 up to and including 315 mm
#[must_use]
pub fn deviations(zone: &str, nominal: Length) -> Datum<Deviations> {
    let size = nominal.in_unit(&MILLIMETRE);
    let find = |symbol: &str| {
        iso_cells().iter().filter(|cell| cell.place.symbol == symbol).find(|cell| {
            zone_of(cell).is_some_and(|(of, over, to)| of == zone && size > over + 1e-9 && size <= to + 1e-9)
        })
    };
    let value = |cell: &'static Cell| {
        let unit = Unit::of(cell.unit)?;
        Some(Length::from_si(unit.to_si(cell.value.number()?)))
    };
    let found = find("deviation_upper").zip(find("deviation_lower"));
    let read = found.and_then(|(upper, lower)| {
        let deviations = Deviations { upper: value(upper)?, lower: value(lower)? };
        Some(Sourced {
            value: deviations,
            source: Source::Published(&upper.place),
            grade: Grade::Published,
            errata: upper.errata,
        })
    });
    Datum::of(read)
}

/// Returns the smallest and the largest clearance between a bore and the pilot in it.
///
/// s_min = EI − es, s_max = ES − ei
///
/// # Symbols
/// ES, EI upper and lower limit deviation of the bore, es, ei of the pilot
/// # Source
/// ISO 286-1
/// # Valid
/// round parts within their limits at 20 °C; interference is a negative clearance
#[must_use]
pub fn clearance(bore: &Deviations, pilot: &Deviations) -> (Length, Length) {
    (bore.lower - pilot.upper, bore.upper - pilot.lower)
}

/// Returns the kind of fit from its extreme clearances.
#[must_use]
pub fn fit_kind(clearance_min: Length, clearance_max: Length) -> FitKind {
    if clearance_min.si() >= -NOTHING_M {
        FitKind::Clearance
    } else if clearance_max.si() <= NOTHING_M {
        FitKind::Interference
    } else {
        FitKind::Transition
    }
}

/// Returns the pilot of a side with the requested bore, or with that recommended by the manual.
///
/// # Source
/// cha-manual table 77.1
#[must_use]
pub fn fit(code: &OrderCode, side: Side, bore: Option<Bore>) -> Option<PilotFit> {
    let (symbol, zone_symbol) = match side {
        Side::Load => ("fit_inner_ring", "fit_inner_ring_zone"),
        Side::Housing => ("fit_housing", "fit_housing_zone"),
    };
    let cell = catalogue::size_cell(code.size, code.ratio, symbol)?;
    let (nominal, pilot_zone) = cell.corrected.split_once(' ')?;
    let unit = Unit::of_dimension(Length::DIMENSION, cell.unit)?;
    let nominal = cell.sourced(Length::from_si(unit.to_si(quantities::parse_german(nominal)?)));
    let zone = catalogue::table_cell(cell.place.table, zone_symbol)?;
    let recommended = zone.sourced(zone.corrected);
    let pilot = deviations(pilot_zone, nominal.value).known()?.clone();
    let bore = bore.unwrap_or(Bore::Zone(recommended.value));
    let (bore_deviations, bore_source) = match bore {
        Bore::Zone(zone) => match deviations(zone, nominal.value) {
            Datum::Known(found) => (found.value, Some(found.source)),
            _ => return None,
        },
        Bore::Limits(limits) => (limits, None),
    };
    let (clearance_min, clearance_max) = clearance(&bore_deviations, &pilot.value);
    Some(PilotFit {
        side,
        nominal,
        pilot_zone,
        pilot,
        recommended,
        bore,
        bore_deviations,
        bore_source,
        clearance_min,
        clearance_max,
        kind: fit_kind(clearance_min, clearance_max),
    })
}
