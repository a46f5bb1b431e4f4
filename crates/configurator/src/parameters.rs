//! Parameters of the actuator of an ordering code.

use crate::cells::{by_size, number_of, quantity_of};
use crate::family;
use crate::parts;
use actuator::{
    Accuracy, BearingType, Curve, CurvePoint, Drivetrain, Environment, Gear, Heat, OutputBearing, Parameters,
    ScrewJoint,
};
use catalogue::{Cell, Drive, ManualTable, SeriesData, winding_data};
use order_code::{Brake, OrderCode, Winding};
use provenance::{CellRef, Datum, Grade, Source, Sourced};
use quantities::unit::{DEGREE_CELSIUS, NEWTON_METRE, PERCENT, REVOLUTION_PER_MINUTE};
use quantities::{AngularVelocity, ElectricCurrent, Measure, Ratio, ThermodynamicTemperature, Torque};
use std::sync::{Arc, LazyLock};

/// Location of the reduction ratios of each series.
static RATIOS: LazyLock<Vec<CellRef>> = LazyLock::new(|| family::places("i", |data| data.matrix));

/// Returns the data of the manual on the actuator of a code; `None` if it has none.
#[must_use]
pub fn parameters(code: &OrderCode) -> Option<Parameters> {
    let drive = catalogue::drive(code.size, code.winding, code.feedback)?;
    Some(with_drivetrain(code, drive, Arc::new(drivetrain(drive, code, OfGear::of(code)))))
}

/// Returns [`parameters`], with the data of another code that the differing fields do not affect: brake and options do
/// not affect the drivetrain, winding and feedback do not affect the gear.
pub(crate) fn parameters_beside(code: &OrderCode, other: Option<(&OrderCode, &Parameters)>) -> Option<Parameters> {
    let Some((other, known)) = other.filter(|(other, _)| (other.size, other.ratio) == (code.size, code.ratio)) else {
        return parameters(code);
    };
    let drive = catalogue::drive(code.size, code.winding, code.feedback)?;
    let of_one_motor = (other.winding, other.feedback) == (code.winding, code.feedback);
    let drivetrain = match of_one_motor {
        true => Arc::clone(&known.drivetrain),
        false => Arc::new(drivetrain(drive, code, OfGear::from(&*known.drivetrain))),
    };
    Some(with_drivetrain(code, drive, drivetrain))
}

/// Data of a drivetrain that depend on size and ratio alone.
struct OfGear {
    gear: Gear,
    output_bearing: OutputBearing,
    accuracy: Accuracy,
    screw_joint_load: ScrewJoint,
    screw_joint_housing: ScrewJoint,
    continuous_curve: Datum<Curve>,
    s3_curves: [Datum<Curve>; 2],
    short_time_curve: Datum<Curve>,
}

impl OfGear {
    fn of(code: &OrderCode) -> Self {
        let curve = |which| published_curve(code, which);
        Self {
            gear: gear(code),
            output_bearing: output_bearing(code),
            accuracy: parts::accuracy(code),
            screw_joint_load: parts::screw_joint(code, "load"),
            screw_joint_housing: parts::screw_joint(code, "housing"),
            continuous_curve: curve("continuous"),
            s3_curves: [curve("s3_50"), curve("s3_25")],
            short_time_curve: curve("maximum"),
        }
    }
}

impl From<&Drivetrain> for OfGear {
    fn from(known: &Drivetrain) -> Self {
        Self {
            gear: known.gear.clone(),
            output_bearing: known.output_bearing.clone(),
            accuracy: known.accuracy.clone(),
            screw_joint_load: known.screw_joint_load.clone(),
            screw_joint_housing: known.screw_joint_housing.clone(),
            continuous_curve: known.continuous_curve.clone(),
            s3_curves: known.s3_curves.clone(),
            short_time_curve: known.short_time_curve.clone(),
        }
    }
}

fn with_drivetrain(code: &OrderCode, drive: &Drive, drivetrain: Arc<Drivetrain>) -> Parameters {
    let (feedback, ratio) = (code.feedback, code.ratio);
    let braked = code.brake == Brake::With;
    let pick = |without: &'static str, with: &'static str| if braked { with } else { without };
    Parameters {
        drivetrain,
        inertia_out: drive.datum(pick("J_out", "J_out_brake"), "", feedback, ratio),
        mass: drive.datum(pick("m", "m_brake"), "", feedback, ratio),
        length: drive.datum(pick("L", "L_brake"), "", feedback, ratio),
        brake: parts::brake(drive, code),
        feedback: parts::feedback(code),
        ptc_response: family::ptc_response(code),
        without_kty: !catalogue::leads_out_kty(code),
        feedback_out: parts::feedback_out(code),
    }
}

/// Returns the data of the manual on the drivetrain of a code.
fn drivetrain(drive: &Drive, code: &OrderCode, of_gear: OfGear) -> Drivetrain {
    let (feedback, ratio) = (code.feedback, code.ratio);
    let winding = winding_data(code.winding);
    let starting = winding.map_or("", |data| data.starting_current);
    let [cold, warm] = no_load_cells(drive, code);
    Drivetrain {
        ratio: RATIOS.get(code.series().place()).map_or(Datum::NotPrinted, |place| {
            Datum::Known(Sourced {
                value: f64::from(ratio.value()),
                source: Source::Cell(place),
                grade: Grade::Printed,
                errata: &[],
            })
        }),
        torque_max: drive.datum("T_max", "", feedback, ratio),
        speed_max: drive.datum("n_max", "", feedback, ratio),
        speed_motor_max: drive.datum("n_mot_max", "", feedback, ratio),
        speed_motor_rated: drive.datum("n_N", "", feedback, ratio),
        current_max: drive.datum("I_max", "", feedback, ratio),
        current_demagnetisation: drive.datum("I_E", "", feedback, ratio),
        stall_torque: drive.datum("T_0", "", feedback, ratio),
        inertia_ratio_recommended: family::inertia_ratio_recommended(code.series()),
        stall_current: drive.datum("I_0", "", feedback, ratio),
        stall_current_motor: largest_stall_current(drive, code),
        stall_current_includes_friction: winding.is_none_or(|data| data.stall_current_includes_friction),
        no_load_starting_current: drive.datum("I_NLS", starting, feedback, ratio),
        no_load_current_constant_cold: quantity_of(cold),
        no_load_current_constant_warm: quantity_of(warm),
        no_load_temperatures: temperatures(cold, warm),
        friction_printed_from: family::quantity(code.series(), "", "friction_printed_from"),
        friction_cold_growth: family::cold_growth(code.series()),
        torque_constant_out: drive.datum("k_Tout", "", feedback, ratio),
        torque_constant_motor: drive.datum("k_TM", "", feedback, ratio),
        voltage_constant_motor: drive.datum("k_EM", "20 degC", feedback, ratio),
        resistance_ll: drive.datum("R_LL", "20 degC", feedback, ratio),
        inductance_ll: drive.datum("L_LL", "", feedback, ratio),
        pole_pairs: number_of(drive.cell("p", "", feedback, ratio)),
        hollow_shaft: drive.datum("d_H", "", feedback, ratio),
        dc_link_max: drive.datum("U_DCmax", "", feedback, ratio),
        terminal_voltage_min: terminal_voltage_min(drive, code),
        ambient_range: ambient_range(code.winding),
        environment: environment(code.winding),
        continuous_curve: of_gear.continuous_curve,
        gear: of_gear.gear,
        output_bearing: of_gear.output_bearing,
        s3_curves: of_gear.s3_curves,
        short_time_curve: of_gear.short_time_curve,
        heat: heat(drive, code),
        accuracy: of_gear.accuracy,
        screw_joint_load: of_gear.screw_joint_load,
        screw_joint_housing: of_gear.screw_joint_housing,
    }
}

/// Returns the cells of K_INL of a code at the lowest and the highest temperature that the manual lists.
fn no_load_cells(drive: &Drive, code: &OrderCode) -> [Option<&'static Cell>; 2] {
    let mut cells: Vec<_> =
        drive.cells_of("K_INL", code.feedback, code.ratio).filter(|cell| temperature_of(cell).is_some()).collect();
    let celsius = |cell: &Cell| temperature_of(cell).map_or(0.0, Measure::si);
    cells.sort_by(|a, b| celsius(a).total_cmp(&celsius(b)));
    let cold = cells.first().copied();
    [cold, cells.last().copied().filter(|_| cells.len() > 1)]
}

/// Returns the temperature at which a cell holds, from a condition such as `30 degC`.
fn temperature_of(cell: &Cell) -> Option<ThermodynamicTemperature> {
    let celsius = cell.place.condition.strip_suffix(" degC")?.parse().ok()?;
    Some(ThermodynamicTemperature::new_in(celsius, &DEGREE_CELSIUS))
}

/// Returns the temperatures of two cells, citing the first.
fn temperatures(cold: Option<&'static Cell>, warm: Option<&'static Cell>) -> Datum<[ThermodynamicTemperature; 2]> {
    let (Some(cell), Some(cold)) = (cold, cold.and_then(temperature_of)) else { return Datum::NotPrinted };
    let warm = warm.and_then(temperature_of).unwrap_or(cold);
    let source = Source::Cell(&cell.place);
    Datum::Known(Sourced { value: [cold, warm], source, grade: Grade::Printed, errata: &[] })
}

/// Returns the largest I_0 over the ratios of a drive: the motor and therefore its thermal limit are the same at every
/// ratio, while the gear may limit T_0, and with it I_0, at the higher ones.
fn largest_stall_current(drive: &Drive, code: &OrderCode) -> Datum<ElectricCurrent> {
    let mut largest: Datum<ElectricCurrent> = Datum::NotPrinted;
    for &ratio in drive.ratios() {
        let here: Datum<ElectricCurrent> = drive.datum("I_0", "", code.feedback, ratio);
        if let Some(current) = here.known()
            && largest.known().is_none_or(|known| current.value.si() > known.value.si())
        {
            largest = here;
        }
    }
    largest
}

/// Returns the calibration of the heat model for a drive: that of its winding, or that of its size where all windings
/// share it.
fn heat(drive: &Drive, code: &OrderCode) -> Heat {
    let series = code.series();
    let number = |symbol| family::number(series, drive.name, symbol);
    let time = |symbol| family::quantity(series, drive.name, symbol);
    let loss_band = family::band(series, drive.name, "loss_band_low", "loss_band_high");
    let ambient_reference = ambient_range(code.winding).map(|range| range.map(|(_, highest)| highest));
    Heat {
        gear_band: number("s3_gear_band"),
        ambient_reference,
        winding_warning: family::winding_threshold(series, "warning"),
        winding_shutdown: family::winding_threshold(series, "shutdown"),
        housing_share: number("housing_share"),
        stall_loss_factor: number("stall_loss_factor"),
        loss_band,
        intermittent_cycle: time("s3_cycle"),
        intermittent_band_high: number("s3_band_high"),
        winding_time_constant: time("tau_w"),
        housing_time_constant: time("tau_h"),
    }
}

/// Returns the lower end of the terminal voltage range of the manual, from a cell such as `220 ... 430`.
fn terminal_voltage_min(drive: &Drive, code: &OrderCode) -> Datum<quantities::ElectricPotential> {
    match drive.cell("U_M", "", code.feedback, code.ratio).map(|cell| (cell, cell.value)) {
        Some((cell, catalogue::Value::Range { low, .. })) => {
            Datum::Known(cell.sourced(quantities::ElectricPotential::from_si(low)))
        }
        _ => Datum::NotPrinted,
    }
}

/// Returns the permitted ambient temperature in operation, from the table of general data of the winding.
fn ambient_range(winding: Winding) -> Datum<(ThermodynamicTemperature, ThermodynamicTemperature)> {
    let cell =
        winding_data(winding).and_then(|data| catalogue::table_cell(data.general, "ambient_temperature_operation"));
    match cell.map(|cell| (cell, cell.value)) {
        Some((cell, catalogue::Value::Range { low, high })) => {
            let celsius = |value| ThermodynamicTemperature::new_in(value, &DEGREE_CELSIUS);
            Datum::Known(cell.sourced((celsius(low), celsius(high))))
        }
        _ => Datum::NotPrinted,
    }
}

/// Returns the data about the place of installation in the table of general data of the winding.
fn environment(winding: Winding) -> Environment {
    let cell = |symbol| winding_data(winding).and_then(|data| catalogue::table_cell(data.general, symbol));
    let humidity = cell("relative_humidity").and_then(|cell| match cell.value {
        catalogue::Value::Range { low, high } => {
            Some(cell.sourced((Ratio::new_in(low, &PERCENT), Ratio::new_in(high, &PERCENT))))
        }
        _ => None,
    });
    let protection =
        cell("protection_class").and_then(|cell| Some(cell.sourced(actuator::Protection::read(cell.corrected)?)));
    Environment {
        altitude_max: quantity_of(cell("altitude")),
        protection: Datum::of(protection),
        humidity: Datum::of(humidity),
        vibration_max: quantity_of(cell("vibration_resistance")),
        shock_max: quantity_of(cell("shock_resistance")),
    }
}

/// Returns the gear data of tables 54.3 and 54.4, the published ratings where they exist, and the estimated rated torque.
fn gear(code: &OrderCode) -> Gear {
    let data = SeriesData::of(code.series());
    // Ratings of the interchangeable gear with equal T_R, from another manufacturer's catalogue.
    let rating = |symbol| published("gear-ratings", symbol, code, code.ratio.as_str());
    // Input speeds of the same gear, published once for all ratios.
    let input_speed = |symbol| published("gear-input-speeds", symbol, code, "");
    Gear {
        torque_1: by_size(code, "T_1"),
        torque_2: by_size(code, "T_2"),
        stiffness: [by_size(code, "K_1"), by_size(code, "K_2"), by_size(code, "K_3")],
        rated_torque: rated_by_the_stronger(code),
        average_torque_max: rating("T_A"),
        collision_torque_max: rating("T_M"),
        collision_cycles: of_the_life(code, "collision_cycles", None, number_of),
        nominal_life: of_the_life(code, "L_n", Some(data.gear_series), quantity_of),
        life_reference_speed: of_the_life(code, "n_N_gear", None, quantity_of),
        life_ratio: of_the_life(code, "life_ratio_50_10", None, number_of),
        rated_life: Datum::NotPrinted,
        ratcheting_torque: published("ratcheting-torque", "T_ratchet", code, code.ratio.as_str()),
        buckling_torque: published("ratcheting-torque", "T_buckle", code, ""),
        input_speed_max: input_speed("n_in_max"),
        input_speed_mean_max: input_speed("n_in_av"),
    }
}

/// Rated torque of the gear, estimated from the stronger series of the same maker at every size and ratio. The page of another
/// maker that states one for sizes 14 to 32 is not read: a life below the required one rejects, and must not rest on it.
///
/// T_N = T_N,stronger / 1.3
///
/// # Symbols
/// T_N rated torque \[Nm\]; T_N,stronger that of the stronger series of the same size and ratio \[Nm\]
/// # Source
/// docs/theory/gear.md; table gear-ratings-stronger and the calibration `stronger_gear_factor`
/// # Valid
/// Sizes and ratios of that table; the repeated peak torques of both series, both of the maker, are in the same ratio
/// within the printed digits.
fn rated_by_the_stronger(code: &OrderCode) -> Datum<Torque> {
    let stronger: Datum<Torque> = published("gear-ratings-stronger", "T_N", code, code.ratio.as_str());
    match (stronger, family::number(code.series(), "", "stronger_gear_factor")) {
        (Datum::Known(stronger), Datum::Known(factor)) => Datum::Known(Sourced {
            value: Torque::from_si(stronger.value.si() / factor.value),
            source: Source::Model { name: "gear" },
            grade: stronger.grade.worst(factor.grade),
            errata: stronger.errata,
        }),
        _ => Datum::NotPrinted,
    }
}

/// Returns a constant of the life of the wave-generator bearing from another manufacturer's catalogue, for all gears or
/// for the gear series of the actuators.
fn of_the_life<T>(
    code: &OrderCode,
    symbol: &str,
    series: Option<&str>,
    value: impl Fn(Option<&'static Cell>) -> Datum<T>,
) -> Datum<T> {
    let cells = catalogue::table_cells(SeriesData::of(code.series()).gear_life);
    let is_of = |condition: &str| series.is_none_or(|series| condition.contains(series));
    let found = cells.iter().find(|cell| cell.place.symbol == symbol && is_of(cell.place.condition));
    family::published_as(Grade::Published, value(found))
}

/// Returns a value from a table of another manufacturer that lists data by size.
fn published<Q: Measure>(table: &str, symbol: &str, code: &OrderCode, ratio: &str) -> Datum<Q> {
    let head = format!("{}-{}", code.series().as_str(), code.size);
    let cell = catalogue::table_cells(table)
        .iter()
        .find(|cell| cell.place.symbol == symbol && cell.place.drive == head && cell.place.ratio == ratio);
    family::published_as(Grade::Published, quantity_of(cell))
}

/// Returns the data of table 55.1 on the output bearing of a size.
fn output_bearing(code: &OrderCode) -> OutputBearing {
    let kind = catalogue::size_cell(code.size, code.ratio, "bearing_type").and_then(|cell| {
        let value = match cell.corrected {
            "C" => BearingType::CrossedRoller,
            "F" => BearingType::FourPoint,
            _ => return None,
        };
        Some(cell.sourced(value))
    });
    OutputBearing {
        kind: Datum::of(kind),
        pitch_diameter: by_size(code, "d_p"),
        offset: by_size(code, "R"),
        dynamic_rating: by_size(code, "C"),
        static_rating: by_size(code, "C_0"),
        tilting_moment_max: by_size(code, "M_dyn_max"),
        static_moment_max: by_size(code, "M_0_max"),
        static_safety_min: family::static_safety_min(code),
        axial_max: by_size(code, "F_A_dyn_max"),
        radial_max: by_size(code, "F_R_dyn_max"),
        tilting_stiffness: by_size(code, "K_B"),
        swing_min: family::swing_min(code.series()),
    }
}

/// Parses corner points written as `(0;32)(25;31)(70;20)`: speed \[1/min\] and torque \[Nm\].
#[must_use]
pub fn published_curve_points(text: &str) -> Option<Vec<(f64, f64)>> {
    let inner = text.trim().strip_prefix('(')?.strip_suffix(')')?;
    inner
        .split(")(")
        .map(|point| {
            let (speed, torque) = point.split_once(';')?;
            Some((quantities::parse_german(speed.trim())?, quantities::parse_german(torque.trim())?))
        })
        .collect()
}

/// Returns a published curve (`continuous`, `s3_50`, `s3_25`, `maximum`), for the sizes and ratios that have one.
fn published_curve(code: &OrderCode, which: &str) -> Datum<Curve> {
    let tables = SeriesData::of(code.series()).curves;
    if tables.is_empty() {
        return Datum::NotPrinted;
    }
    let head = format!("{}-{}", code.series().as_str(), code.size);
    let is_it = |cell: &&Cell| {
        let place = &cell.place;
        place.condition == which && place.ratio == code.ratio.as_str() && place.drive == head
    };
    let cell = tables.iter().filter_map(|table| catalogue::table(table)).flat_map(ManualTable::cells).find(is_it);
    let point = |(speed, torque)| CurvePoint {
        speed: AngularVelocity::new_in(speed, &REVOLUTION_PER_MINUTE),
        torque: Torque::new_in(torque, &NEWTON_METRE),
    };
    let curve = cell.and_then(|cell| {
        let points = published_curve_points(cell.corrected)?.into_iter().map(point).collect();
        Some(cell.sourced(Curve::new(points).ok()?))
    });
    family::published_as(Grade::Published, Datum::of(curve))
}
