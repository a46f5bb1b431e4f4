//! Voltage drop on the wires of brake and encoder supply.

use catalogue::{Cell, SeriesData, Value};
use order_code::{Brake, FeedbackKind, OrderCode};
use provenance::{CellRef, Datum, Source, Sourced};
use quantities::{Area, ElectricCurrent, ElectricPotential, ElectricalResistivity, Length, Measure, identified};

/// Temperature of a warm wire \[°C\]: limit of PVC insulation in continuous operation (IEC 60364-5-52); assumed.
const HOT_DEGC: f64 = 70.0;

/// Reference temperature of the resistivity \[°C\].
const REFERENCE_DEGC: f64 = 20.0;

identified! {
    /// A circuit with a voltage drop.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Circuit {
        /// Holding brake while it opens.
        Brake = "brake",
        /// Supply of the motor feedback.
        Feedback = "feedback_supply",
        /// Supply of the encoder at the output.
        OutputEncoder = "output_encoder_supply",
    }
}

/// Verdict on the voltage at the load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DropVerdict {
    /// Sufficient even with a warm wire.
    Pass,
    /// Insufficient with a warm wire.
    Fail,
    /// No cross-section was stated.
    NoCrossSection,
    /// The manual states no tolerance.
    NoTolerance,
    /// The manual states only the holding current of the brake.
    NoOpeningCurrent,
    /// The manual states a range instead of the nominal supply voltage.
    NoNominal,
}

/// Voltage drop of one circuit.
#[derive(Clone, Debug)]
pub struct VoltageDrop {
    /// Circuit of the wires.
    pub circuit: Circuit,
    /// Current of the circuit.
    pub current: Sourced<ElectricCurrent>,
    /// Cell that states the voltages.
    pub supply: &'static Cell,
    /// Voltage of the source, if stated.
    pub nominal: Option<ElectricPotential>,
    /// Lowest voltage at the load, if stated.
    pub least: Option<ElectricPotential>,
    /// Voltage drop on both wires at 20 °C and with a warm wire; `None` without a cross-section.
    pub loss: Option<[ElectricPotential; 2]>,
    /// Smallest cross-section required with a warm wire; `None` if no limit is stated.
    pub cross_section_min: Option<Area>,
    /// Verdict on the voltage at the load.
    pub verdict: DropVerdict,
    /// The connector has sense lines, with which a drive can compensate for the voltage drop.
    pub sense: bool,
    /// Resistivity with its source.
    pub resistivity: Sourced<ElectricalResistivity>,
}

/// Returns the resistivity of copper at a temperature.
///
/// ρ = ρ_20 (1 + α_20 (ϑ − 20 °C))
///
/// # Source
/// iec-60028, table copper-wire
fn resistivity(degrees_celsius: f64) -> Option<Sourced<ElectricalResistivity>> {
    let cell = |symbol: &str| catalogue::table_cell("copper-wire", symbol);
    let Datum::Known(at_20) = catalogue::datum_of::<ElectricalResistivity>(cell("rho_Cu")?) else { return None };
    let alpha = cell("alpha_Cu")?.value.number()?;
    let warmer = at_20.value.si() * (1.0 + alpha * (degrees_celsius - REFERENCE_DEGC));
    let source = match at_20.source {
        Source::Cell(place) => Source::Published(place),
        other => other,
    };
    Some(Sourced { value: Measure::from_si(warmer), source, grade: provenance::Grade::Published, errata: &[] })
}

/// Returns the voltage drop on both wires of a circuit.
///
/// ΔU = 2 ρ L I / A
///
/// # Symbols
/// ρ resistivity [Ω m], L length of the cable \[m\], I current \[A\], A cross-section of one wire \[m²\]
fn loss(rho: ElectricalResistivity, length: Length, current: ElectricCurrent, section: Area) -> ElectricPotential {
    Measure::from_si(2.0 * rho.si() * length.si() * current.si() / section.si())
}

/// Returns the voltage drops of the circuits of a code on a cable, compared with the tolerance of the supply in the
/// manual.
///
/// # Source
/// currents and voltages: the brake table of the drive, tables 57.1 to 61.1 and 68.1
/// # Valid
/// DC in copper wires of equal cross-section; the source holds the nominal voltage. The excitation of the resolver is
/// an AC voltage: only the ohmic part is returned.
#[must_use]
pub fn voltage_drops(code: &OrderCode, length: Length, section: Option<Area>) -> Vec<VoltageDrop> {
    let mut found = Vec::new();
    found.extend(brake(code, length, section));
    let sense = match code.feedback.kind() {
        Some(FeedbackKind::SineIncremental | FeedbackKind::EndatMultiturn | FeedbackKind::SsiMultiturn) => true,
        Some(FeedbackKind::Resolver | FeedbackKind::SquareIncremental) | None => false,
    };
    let series = SeriesData::of(code.series());
    let table = series.feedback_tables.get(code.feedback.place());
    found.extend(table.and_then(|table| encoder(Circuit::Feedback, table, length, section, sense)));
    if code.has_output_encoder() {
        found.extend(encoder(Circuit::OutputEncoder, series.output_encoder, length, section, true));
    }
    found
}

/// Evaluates the brake, whose current is largest while it opens; if the manual states only the holding current, the
/// voltage drop is reported without a verdict.
fn brake(code: &OrderCode, length: Length, section: Option<Area>) -> Option<VoltageDrop> {
    let drive = catalogue::drive(code.size, code.winding, code.feedback).filter(|_| code.brake == Brake::With)?;
    let supply = drive.cell("U_Br", "", code.feedback, code.ratio)?;
    match drive.datum("I_OBr", "", code.feedback, code.ratio) {
        Datum::Known(opening) => judged(Circuit::Brake, supply, opening, length, section, false),
        _ => match drive.datum("I_HBr", "", code.feedback, code.ratio) {
            Datum::Known(holding) => judged(Circuit::Brake, supply, holding, length, section, false)
                .map(|drop| VoltageDrop { verdict: DropVerdict::NoOpeningCurrent, cross_section_min: None, ..drop }),
            _ => None,
        },
    }
}

fn encoder(circuit: Circuit, table: &str, length: Length, section: Option<Area>, sense: bool) -> Option<VoltageDrop> {
    let cell = |symbol: &str| catalogue::table_cell(table, symbol);
    let supply = cell("U_b")?;
    let current = match cell("I_b") {
        Some(cell) => match catalogue::datum_of(cell) {
            Datum::Known(current) => current,
            _ => return None,
        },
        // If a power is stated, the current is largest at the lowest voltage.
        None => {
            let power = cell("P_b")?;
            let Value::Range { low, .. } = supply.value else { return None };
            let amperes = power.value.number()? / low;
            let place: &'static CellRef = &power.place;
            let grade = provenance::Grade::Computed;
            Sourced { value: Measure::from_si(amperes), source: Source::Cell(place), grade, errata: power.errata }
        }
    };
    judged(circuit, supply, current, length, section, sense)
}

fn judged(
    circuit: Circuit,
    supply: &'static Cell,
    current: Sourced<ElectricCurrent>,
    length: Length,
    section: Option<Area>,
    sense: bool,
) -> Option<VoltageDrop> {
    let (cold, warm) = (resistivity(REFERENCE_DEGC)?, resistivity(HOT_DEGC)?);
    let volts = ElectricPotential::from_si;
    let (nominal, least) = match supply.value {
        Value::Tolerance { nominal, plus_minus_percent } => {
            (Some(volts(nominal)), Some(volts(nominal * (1.0 - plus_minus_percent / 100.0))))
        }
        Value::Range { low, .. } => (None, Some(volts(low))),
        Value::Number(nominal) => (Some(volts(nominal)), None),
        _ => (None, None),
    };
    let spare = nominal.zip(least).map(|(nominal, least)| nominal - least);
    let cross_section_min =
        spare.map(|spare| Area::from_si(2.0 * warm.value.si() * length.si() * current.value.si() / spare.si()));
    let loss = section
        .map(|section| [&cold, &warm].map(|resistivity| loss(resistivity.value, length, current.value, section)));
    let verdict = match (loss, spare) {
        (_, None) if least.is_none() => DropVerdict::NoTolerance,
        (_, None) => DropVerdict::NoNominal,
        (None, Some(_)) => DropVerdict::NoCrossSection,
        (Some([_, warm]), Some(spare)) if warm <= spare => DropVerdict::Pass,
        _ => DropVerdict::Fail,
    };
    Some(VoltageDrop {
        circuit,
        current,
        supply,
        nominal,
        least,
        loss,
        cross_section_min,
        verdict,
        sense,
        resistivity: cold,
    })
}
