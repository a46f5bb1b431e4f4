//! `identify TRACE PROJECT`: load, friction and torque constant from a recorded run.

use super::given::{arguments, some_code_among, text};
use super::{
    AXIS, Answer, Argument, ArgumentKind, Asked, Cost, Entry, Form, Gives, Reads, Record, Unanswered, argument,
};
use crate::sizing_use::{Candidate, check_one, known_si};
use answers::Number;
use mechanism::{Extra, Mechanism, MechanismKind};
use order_code::OrderCode;
use project::Project;
use quantities::unit::{
    AMPERE, AMPERE_SECOND_PER_RADIAN, DEGREE, KILOGRAM_SQUARE_METRE, NEWTON_METRE, NEWTON_METRE_PER_AMPERE,
    NEWTON_METRE_SECOND_PER_RADIAN,
};
use quantities::{Language, Measure, Unit, seen};
use recording::{Bytes, Memory};
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::SQRT_2;
use std::io::Read as _;
use twin::{Estimate, Identified, IdentifyFault, Observed, identify};
use words::{Word, help, help::values, recording_text, simulation};

arguments! {
    /// Which axis, which actuator, which run.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own.
        code: Option<OrderCode> = argument::code(help::check_code) => some_code_among,
        /// The recorded run.
        trace: Option<String> = Argument::option("trace", values::file, help::identify_trace).of(ArgumentKind::File).form(Form::Bare).required() => text,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "identify",
    path: "identify",
    about: help::identify,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<Identification>("identify")),
    writes: &[],
    example: "run.csv axis.toml --code CHA-25A-50-H-C1024",
    answer: Some(|asked| Ok(Answer::record(&found(asked)?))),
};

/// What a recorded run says of load and motor.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Identification {
    /// Name of the axis.
    pub axis: String,
    /// Ordering code, or the name of the project's own actuator.
    pub code: String,
    /// Rows of the run.
    pub samples: usize,
    /// The estimates.
    pub estimates: Vec<Identified95>,
    /// Lines of the project file with the measured values of actuator and load.
    pub overrides: String,
    /// What the estimate rests on, in words.
    pub notes: Vec<String>,
}

/// An estimate with its interval.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Identified95 {
    /// Identifier.
    pub id: &'static str,
    /// In words.
    pub title: String,
    /// The value.
    pub value: Number,
    /// Half the interval that holds the true value in 95 of 100 runs.
    pub half_width: Number,
    /// Its unit.
    pub unit: &'static str,
    /// What project or table say; `null` where they say nothing.
    pub stated: Option<Number>,
}

/// So many bytes of a run are read at most.
const TRACE_MOST: u64 = 256 << 20;

/// The columns that are read, as `simulate --trace` heads them.
const COLUMNS: [&str; 7] =
    ["time_s", "position_rad", "speed_rad_s", "acceleration_rad_s2", "motor_speed_rad_s", "torque_nm", "current_q_a"];

/// The estimates from a run.
///
/// # Errors
/// Faults of the project and of the run.
pub fn found(asked: &Asked<'_>) -> Result<Identification, Unanswered> {
    let args = Args::read(&asked.given)?;
    let language = asked.language;
    let (_, project) = asked.axis(args.axis.as_deref(), Cost::Other)?;
    let candidate = check_one(&project, args.code.as_ref())?;
    let name = args.trace.unwrap_or_default();
    let mut bytes = Vec::new();
    let source = asked.source()?;
    let read = source.files.open(&name).and_then(|file| file.take(TRACE_MOST + 1).read_to_end(&mut bytes));
    read.map_err(|_| Unanswered::message(simulation::no_such_trace(&seen(&name), language)))?;
    if bytes.len() as u64 > TRACE_MOST {
        return Err(Unanswered::message(simulation::trace_too_large(&seen(&name), &(TRACE_MOST >> 20), language)));
    }
    let memory = source.files.grant().memory;
    let read = if bytes.starts_with(b"PAR1") { of_parquet(bytes, memory, language) } else { of_csv(&bytes, language) };
    let run = observed(read, language)
        .map_err(|faults| Unanswered::together(faults.into_iter().map(Unanswered::message).collect()))?;
    let limit = candidate.parameters.current_max.known().map(|known| SQRT_2 * known.value.si());
    let twin::Identification { estimates, at_limit } = identify(&run, limit).map_err(|why| {
        Unanswered::message(match why {
            IdentifyFault::Uneven | IdentifyFault::TooFew => simulation::trace_too_short(language),
            IdentifyFault::NotExcited => simulation::trace_not_excited(language),
        })
    })?;
    let rows = estimates.iter().map(|estimate| row(estimate, &project, &candidate, language));
    let mechanism = &project.axis.mechanism;
    let taken = |of| is_replaced(of, mechanism);
    let mut notes = vec![simulation::one_direction(language).to_owned()];
    if at_limit > 0 {
        notes.push(simulation::at_the_limit(&at_limit, language));
    }
    if estimates.iter().all(|each| each.of != Identified::TorqueConstant) {
        notes.push(simulation::motor_not_estimated(language).to_owned());
    }
    if !taken(Identified::Gravity) {
        notes.push(simulation::load_not_replaced(language).to_owned());
    }
    Ok(Identification {
        axis: project.name.clone(),
        code: candidate.id.to_string(),
        samples: run.time_s.len(),
        estimates: rows.collect(),
        overrides: overrides(&estimates, taken),
        notes,
    })
}

/// So many faults of a run are reported.
const FAULTS_MOST: usize = 20;

/// The columns of a run that are there, and what is wrong in them.
type Read = ([Option<Vec<f64>>; 7], Vec<String>);

/// What `identify` of the twin takes, where every column is there.
fn observed((columns, mut faults): Read, language: Language) -> Result<Observed, Vec<String>> {
    let there = COLUMNS.iter().zip(&columns);
    let lacking: Vec<&str> = there.filter(|(_, column)| column.is_none()).map(|(name, _)| *name).collect();
    if !lacking.is_empty() {
        faults.insert(0, simulation::trace_lacks(&lacking.join(", "), language));
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let [time_s, position_rad, speed_rad_s, acceleration_rad_s2, motor_rad_s, torque_nm, current_q_a] =
        columns.map(Option::unwrap_or_default);
    Ok(Observed { time_s, position_rad, speed_rad_s, acceleration_rad_s2, motor_rad_s, torque_nm, current_q_a })
}

fn of_parquet(bytes: Vec<u8>, memory: u64, language: Language) -> Read {
    match recording::read_columns(&Bytes::from(bytes), &COLUMNS, &mut Memory::new(memory)) {
        Ok(found) => {
            let mut found = found.into_iter();
            (COLUMNS.map(|_| found.next().flatten()), Vec::new())
        }
        // What is missing besides is not known of a file that cannot be read.
        Err(faults) => {
            let faults = faults.iter().map(|fault| recording_text(fault, language)).collect();
            (COLUMNS.map(|_| Some(Vec::new())), faults)
        }
    }
}

fn of_csv(bytes: &[u8], language: Language) -> Read {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let heads: Vec<&str> = lines.next().unwrap_or_default().trim_start_matches('\u{feff}').split(',').collect();
    let places = COLUMNS.map(|column| heads.iter().position(|head| head.trim() == column));
    let mut faults = Vec::new();
    let mut columns = places.map(|place| place.map(|_| Vec::new()));
    for (line, text) in (2_usize..).zip(lines).filter(|(_, text)| !text.trim().is_empty()) {
        let cells: Vec<&str> = text.split(',').collect();
        for ((column, place), name) in columns.iter_mut().zip(places).zip(COLUMNS) {
            let (Some(column), Some(place)) = (column, place) else { continue };
            let value = cells.get(place).and_then(|cell| cell.trim().parse::<f64>().ok());
            match value.filter(|value| value.is_finite()) {
                Some(value) => column.push(value),
                None if faults.len() < FAULTS_MOST => {
                    faults.push(simulation::trace_not_a_number(&line, &name, language));
                }
                None => {}
            }
        }
    }
    (columns, faults)
}

fn title_and_unit(of: Identified) -> (Word, &'static Unit) {
    match of {
        Identified::LoadInertia => (simulation::load_inertia, &KILOGRAM_SQUARE_METRE),
        Identified::Coulomb => (simulation::coulomb, &NEWTON_METRE),
        Identified::Viscous => (simulation::viscous, &NEWTON_METRE_SECOND_PER_RADIAN),
        Identified::Gravity => (simulation::gravity, &NEWTON_METRE),
        Identified::GravityAngle => (simulation::gravity_angle, &DEGREE),
        Identified::External => (simulation::external, &NEWTON_METRE),
        Identified::TorqueConstant => (simulation::torque_constant_out, &NEWTON_METRE_PER_AMPERE),
        Identified::StartingCurrent => (simulation::no_load_starting_current, &AMPERE),
        Identified::CurrentConstant => (simulation::no_load_current_constant, &AMPERE_SECOND_PER_RADIAN),
    }
}

fn row(estimate: &Estimate, project: &Project, candidate: &Candidate<'_>, language: Language) -> Identified95 {
    let (title, unit) = title_and_unit(estimate.of);
    let number = |si: f64| Number::in_unit(si, unit);
    Identified95 {
        id: estimate.of.id(),
        title: title(language).to_owned(),
        value: number(estimate.value),
        half_width: number(estimate.half_width),
        unit: unit.json,
        stated: stated(estimate.of, project, candidate).map(number),
    }
}

/// What project and tables say.
fn stated(of: Identified, project: &Project, candidate: &Candidate<'_>) -> Option<f64> {
    let (actuator, mechanism) = (candidate.parameters, &project.axis.mechanism);
    let none = Extra::none();
    let extra = project.axis.extras.first().unwrap_or(&none);
    let plain = mechanism.plain(extra);
    match of {
        Identified::LoadInertia => {
            matches!(mechanism.kind, MechanismKind::Rotor(_) | MechanismKind::Linear(_)).then(|| {
                let share = twin::Model::default().flange_inertia_share.value;
                mechanism.inertia(0.0, extra).si() + share * known_si(&actuator.inertia_out).unwrap_or(0.0)
            })
        }
        Identified::Coulomb => plain.map(|plain| plain.coulomb_nm),
        Identified::Viscous => plain.map(|plain| plain.viscous_nms),
        Identified::Gravity => plain.map(|plain| plain.weight_nm.abs()),
        Identified::GravityAngle => plain.filter(|plain| plain.weight_nm != 0.0).map(|plain| plain.angle_rad),
        Identified::External => plain.map(|plain| plain.constant_nm),
        Identified::TorqueConstant => known_si(&actuator.torque_constant_out),
        Identified::StartingCurrent => known_si(&actuator.no_load_starting_current),
        Identified::CurrentConstant => known_si(&actuator.no_load_current_constant_cold),
    }
}

/// Whether a measured value can stand in the place of what the mechanism says.
fn is_replaced(of: Identified, mechanism: &Mechanism) -> bool {
    let is_plain = mechanism.plain(&Extra::none()).is_some();
    match of {
        Identified::LoadInertia => is_plain || mechanism.travel_m_per_rad().is_some(),
        Identified::Gravity | Identified::GravityAngle | Identified::External => is_plain,
        Identified::Coulomb
        | Identified::Viscous
        | Identified::TorqueConstant
        | Identified::StartingCurrent
        | Identified::CurrentConstant => true,
    }
}

/// The key of `[twin.measured]`; `None` where a run alone does not say the value, as of a constant that follows the temperature.
const fn key(of: Identified) -> Option<&'static str> {
    Some(match of {
        Identified::LoadInertia => "load_inertia",
        Identified::Coulomb => "load_coulomb",
        Identified::Viscous => "load_viscous",
        Identified::Gravity => "load_gravity",
        Identified::GravityAngle => "load_gravity_angle",
        Identified::External => "load_external",
        Identified::TorqueConstant => "torque_constant_out",
        Identified::StartingCurrent => "no_load_starting_current",
        Identified::CurrentConstant => return None,
    })
}

/// Lines of a project file: of each estimate that is not lost in its own interval.
fn overrides(estimates: &[Estimate], taken: impl Fn(Identified) -> bool) -> String {
    let mut lines = String::from("[twin.measured]\n");
    for estimate in estimates.iter().filter(|each| taken(each.of)) {
        let has_a_sign = matches!(estimate.of, Identified::External | Identified::GravityAngle);
        let Some(key) = key(estimate.of).filter(|_| has_a_sign || estimate.value > 0.0) else { continue };
        let (_, unit) = title_and_unit(estimate.of);
        // A weight or a friction within its interval of nothing is nothing, and so is said.
        let is_lost = estimate.value.abs() <= estimate.half_width && estimate.of != Identified::GravityAngle;
        let si = if is_lost { 0.0 } else { estimate.value };
        if is_lost && matches!(estimate.of, Identified::LoadInertia | Identified::TorqueConstant) {
            continue;
        }
        let value = Number::in_unit(si, unit).written().unwrap_or(si);
        // Five digits, of a small value too; what is a billionth of a unit is nothing.
        let value = if value.abs() < 1e-9 { 0.0 } else { format!("{value:.4e}").parse().unwrap_or(value) };
        lines.push_str(&format!("{key} = \"{value} {}\"\n", unit.ascii));
    }
    lines
}
