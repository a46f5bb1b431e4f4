//! `identify TRACE PROJECT`: load, friction and torque constant from a recorded run.

mod headings;
mod reading;

use super::given::{arguments, some_product_among, text};
use super::{
    AXIS, Answer, Argument, ArgumentForm, ArgumentKind, Cost, Entry, Gives, Inquiry, Reads, Record, Unanswered,
    argument,
};
use crate::simulate::replaced;
use crate::sizing_use::{check_one, known_si};
use actuator::Parameters;
use answers::Number;
use axis::AxisProject;
use configurator::ProductId;
use mechanism::{Extra, Mechanism, MechanismKind, Plain};
use quantities::unit::{
    AMPERE, AMPERE_SECOND_PER_RADIAN, DEGREE, KILOGRAM_SQUARE_METRE, MILLISECOND, NEWTON_METRE,
    NEWTON_METRE_PER_AMPERE, NEWTON_METRE_SECOND_PER_RADIAN,
};
use quantities::{Language, Measure, Unit, format_significant};
use schemars::JsonSchema;
use serde::Serialize;
use sizing::StepObserver;
use twin::{
    Column as Signal, Delay, Doubt, Estimate, HeldColumn, Identified, Misread, Open, Stated, Zero, identify_while,
};
use words::{Word, help, help::values, identification, simulation};

arguments! {
    /// Arguments of `identify`: axis, actuator, recorded run.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own.
        code: Option<ProductId> = argument::code(help::check_code) => some_product_among,
        /// The recorded run.
        trace: Option<String> = Argument::option("trace", values::file, help::identify_trace).of(ArgumentKind::File).form(ArgumentForm::Bare).required() => text,
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
    answer: Some(|inquiry| {
        let found = found(inquiry)?;
        Ok(Answer::record(&found).fits(found.doubts.is_empty()))
    }),
};

/// Parameters of load and motor estimated from a recorded run.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Identification {
    /// Name of the axis.
    pub axis: String,
    /// Ordering code, or the name of the project's own actuator.
    pub code: String,
    /// Rows of the run.
    pub samples: usize,
    /// Estimates that the run separates from each other.
    pub estimates: Vec<Identified95>,
    /// Parameters without an estimate.
    pub open: Vec<LeftOpen>,
    /// Zeros, delays and filters of the signals, which the estimates take into account.
    pub signals: Vec<SignalDatum>,
    /// Signals that seem to have another unit, sign or side than their columns; while there are any, the estimates are not those of the
    /// axis, `overrides` is empty, and the exit status is 1.
    pub doubts: Vec<Doubted>,
    /// Lines of the project file with the measured values of actuator and load.
    pub overrides: String,
    /// Method, assumptions and what is left out, in words.
    pub notes: Vec<String>,
}

/// A parameter that a run does not determine.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LeftOpen {
    /// Identifier.
    pub id: &'static str,
    /// Title.
    pub title: String,
    /// Reason, in words.
    pub reason: String,
}

/// A zero, a delay or a filter of a signal of the run.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SignalDatum {
    /// Identifier.
    pub id: &'static str,
    /// Heading of the column.
    pub column: &'static str,
    /// Title.
    pub title: String,
    /// The value.
    pub value: Number,
    /// Half the interval that holds the true value in 95 of 100 runs.
    pub half_width: Number,
    /// Unit of the value.
    pub unit: &'static str,
    /// The value is apart from zero.
    pub significant: bool,
}

/// A signal that does not fit its column.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Doubted {
    /// Identifier of the convention that the signal seems to have.
    pub id: &'static str,
    /// Heading of the column.
    pub column: &'static str,
    /// Observation and advice, in words.
    pub text: String,
}

/// An estimate with its interval.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Identified95 {
    /// Identifier.
    pub id: &'static str,
    /// Title.
    pub title: String,
    /// The value.
    pub value: Number,
    /// Half the interval that holds the true value in 95 of 100 runs.
    pub half_width: Number,
    /// Unit of the value.
    pub unit: &'static str,
    /// Value of project or table; `null` where they have none.
    pub stated: Option<Number>,
    /// The interval is apart from zero, and narrow enough for a line of the project.
    pub known: bool,
}

/// Returns the estimates from a run.
///
/// # Errors
/// Faults of the project and of the run.
pub fn found(inquiry: &Inquiry<'_>) -> Result<Identification, Unanswered> {
    let args = Args::read(&inquiry.given)?;
    let language = inquiry.language;
    let (_, project) = inquiry.axis(args.axis.as_deref(), Cost::Other)?;
    let candidate = check_one(&project, args.code.as_ref())?;
    let reading::RecordedRun { observed, lines, taken } = reading::run(inquiry, &args.trace.unwrap_or_default())?;
    let samples = observed.time_s.len();
    let parameters = replaced(&project, twin::Parameters::of(candidate.parameters));
    let axis = &project.axis;
    let stated =
        Stated { parameters: &parameters, mechanism: &axis.mechanism, motion: &axis.motion, extras: &axis.extras };
    let goes_on = || inquiry.progress.step().is_ok();
    let found = identify_while(observed, &stated, &goes_on).map_err(|why| reading::refused(&lines, &why, language))?;
    // An external torque may contain the zero of the torque.
    let is_known = |each: &Estimate| {
        each.is_known() && (each.of != Identified::External || !found.zero.is_some_and(|zero| zero.is_significant()))
    };
    let shown = |estimate: &Estimate| {
        let row = row(estimate, &project, &parameters.actuator, found.tabulated_nm_a, language);
        Identified95 { known: is_known(estimate), ..row }
    };
    let overrides = if found.doubts.is_empty() {
        // With an offset the angle of the weight is that of the recorded position, not that of the mechanism.
        let has_line = |each: &Estimate| each.of != Identified::GravityAngle || offset(&found).is_none();
        let known: Vec<Estimate> =
            found.estimates.iter().filter(|each| is_known(each) && has_line(each)).copied().collect();
        overrides(&known, |of| is_replaced(of, &axis.mechanism))
    } else {
        String::new()
    };
    Ok(Identification {
        axis: project.name.clone(),
        code: candidate.id.to_string(),
        samples,
        estimates: found.estimates.iter().map(shown).collect(),
        open: found.open.iter().map(|(of, open)| left_open(*of, *open, language)).collect(),
        signals: signals(&found, language),
        doubts: found.doubts.iter().map(|doubt| doubted(doubt, language)).collect(),
        overrides,
        notes: taken.into_iter().chain(notes(&found, &axis.mechanism, &axis.extras, language)).collect(),
    })
}

/// Returns the assumptions, omissions and validity of the estimates.
fn notes(found: &twin::Identification, mechanism: &Mechanism, extras: &[Extra], language: Language) -> Vec<String> {
    let number = |value: f64, digits| format_significant(value, digits, language);
    let mut notes = Vec::new();
    if !found.doubts.is_empty() {
        notes.push(identification::no_lines(language).to_owned());
    }
    let interval = number(found.scatter.map_or(found.row_s, |scatter| scatter.interval_s) * 1e3, 4);
    if let Some(scatter) = found.scatter {
        notes.push(identification::stamps_scatter(&number(scatter.scatter_s * 1e3, 2), &interval, language));
    }
    for HeldColumn { column, period_s } in &found.held {
        let heading = identification::column_heading(*column);
        notes.push(identification::held_values(&heading, &number(period_s * 1e3, 3), &interval, language));
    }
    if found.windows == 0 {
        return notes;
    }
    notes.push(identification::method(&found.windows, &number(found.window_s * 1e3, 3), language));
    if found.doubts.is_empty() {
        notes.push(identification::scale_of_the_torque(language).to_owned());
        if let Some([share, half]) =
            found.payload.filter(|[share, half]| (share - 1.0).abs() > PAYLOAD_OFF.max(1.5 * half))
        {
            notes.push(identification::payloads_off(&number(share, 3), &number(half, 1), language));
        }
    }
    if let Some(correlation) = found.other_motion {
        notes.push(identification::follows_no_cycle(&number(correlation, 3), language));
    }
    if let Some([offset, half]) = offset(found) {
        let [offset, half] = [(offset, 3), (half, 1)].map(|(angle, digits)| number(angle.to_degrees(), digits));
        notes.push(identification::position_offset(&offset, &half, language));
    }
    if !found.both_ways {
        notes.push(identification::one_way(language).to_owned());
    }
    if let Some(shift) = found.shift_s {
        let shown = number(shift.abs(), 4);
        notes.push(if shift < 0.0 {
            identification::of_the_first_move_later(&shown, language)
        } else {
            identification::of_the_first_move(&shown, language)
        });
    }
    if let Some(step) = found.position_step_rad {
        notes.push(identification::position_steps(&number(step.to_degrees(), 3), language));
    }
    if let Some([inertia, spread]) = found.rotor {
        notes.push(identification::assumed_rotor(&number(inertia, 4), &number(spread * 100.0, 2), language));
        if spread > ROTOR_ALONE {
            let of_current = found.held.iter().find(|held| held.column == Signal::Current);
            let every = of_current.map_or(found.row_s, |held| held.period_s);
            notes.push(identification::in_step(&number(every * 1e3, 3), language));
        }
    }
    if found.motor_lag_s != 0.0 {
        notes.push(identification::motor_lags(&number(found.motor_lag_s * 1e3, 2), language));
    }
    let delays = [(Signal::Torque, found.torque_delay), (Signal::Current, found.current_delay)];
    for (signal, Delay { s, half_width_s }) in delays.into_iter().filter_map(|(signal, delay)| Some((signal, delay?))) {
        let (column, half) = (identification::column_heading(signal), number(half_width_s * 1e3, 2));
        let lag = number(s.abs() * 1e3, 3);
        notes.push(if s > 0.0 {
            identification::signal_lags(&column, &lag, &half, language)
        } else {
            identification::signal_leads(&column, &lag, &half, language)
        });
    }
    let filters = [(Signal::Torque, found.torque_filter), (Signal::Current, found.current_filter)];
    for (signal, Delay { s, half_width_s }) in
        filters.into_iter().filter_map(|(signal, filter)| Some((signal, filter?)))
    {
        let (column, half) = (identification::column_heading(signal), number(half_width_s * 1e3, 2));
        notes.push(identification::signal_filtered(&column, &number(s * 1e3, 3), &half, language));
    }
    let has_external = found.estimates.iter().any(|each| each.of == Identified::External);
    if let Some(zero) = found.zero.filter(Zero::is_significant) {
        let [current, half] = [zero.current_q_a, zero.half_width_a].map(|value| number(value, 2));
        let torque = number(zero.torque_nm, 2);
        notes.push(if zero.is_of_torque {
            identification::zero_of_torque(&torque, &current, language)
        } else {
            identification::zero_of_current(&current, &half, &torque, language)
        });
    } else if let Some(zero) = found.zero.filter(|_| found.doubts.is_empty() && has_external) {
        notes.push(identification::zero_in_the_interval(&number(zero.most_nm(), 2), language));
    }
    if found.at_limit > 0 {
        notes.push(identification::windows_at_the_limit(&found.at_limit, language));
    }
    let none = Extra::none();
    if mechanism.plain(extras.first().unwrap_or(&none)).is_none() {
        notes.push(identification::friction_of_the_stated_load(language).to_owned());
    }
    notes
}

/// Returns the offset of the position against the mechanism, with half its interval, if the run shows one \[rad\].
fn offset(found: &twin::Identification) -> Option<[f64; 2]> {
    found.offset_rad.filter(|[offset, half]| offset.abs() > OFFSET * half)
}

/// Smallest offset of the position relative to half its interval that counts: three standard deviations. A choice.
const OFFSET: f64 = 1.5;

/// Smallest deviation of the payloads of the run from the stated ones that is reported. A choice.
const PAYLOAD_OFF: f64 = 0.03;

/// Standard deviation of the rotor's inertia above which the sampling of the current is part of it, as a share.
const ROTOR_ALONE: f64 = 0.05;

fn left_open(of: Identified, open: Open, language: Language) -> LeftOpen {
    let (title, _) = title_and_unit(of);
    LeftOpen { id: of.id(), title: title(language).to_owned(), reason: identification::open_reason(open, language) }
}

/// Returns zeros, delays and filters of the signals.
fn signals(found: &twin::Identification, language: Language) -> Vec<SignalDatum> {
    let datum =
        |id, signal, title: Word, [value, half_width]: [f64; 2], unit: &'static Unit, significant| SignalDatum {
            id,
            column: identification::column_heading(signal),
            title: title(language).to_owned(),
            value: Number::in_unit(value, unit),
            half_width: Number::in_unit(half_width, unit),
            unit: unit.json,
            significant,
        };
    let zero = found.zero.map(|zero| {
        let values = [zero.current_q_a, zero.half_width_a];
        let title = identification::current_zero;
        datum("current_zero", Signal::Current, title, values, &AMPERE, zero.is_significant())
    });
    let delays = [
        ("torque_delay", Signal::Torque, identification::torque_delay as Word, found.torque_delay),
        ("current_delay", Signal::Current, identification::current_delay, found.current_delay),
        ("torque_filter", Signal::Torque, identification::torque_filter, found.torque_filter),
        ("current_filter", Signal::Current, identification::current_filter, found.current_filter),
    ];
    let delays = delays.into_iter().filter_map(|(id, signal, title, delay)| {
        let Delay { s, half_width_s } = delay?;
        Some(datum(id, signal, title, [s, half_width_s], &MILLISECOND, true))
    });
    zero.into_iter().chain(delays).collect()
}

/// Returns the doubt with its value in the unit of the sentence.
fn doubted(doubt: &Doubt, language: Language) -> Doubted {
    let Doubt { column, misread, value, by_convention } = *doubt;
    // An instant finds its row.
    let digits = if matches!(misread, Misread::Outlier | Misread::Jump) { 6 } else { 3 };
    let number = |value: f64| format_significant(value, digits, language);
    let shown = number(match misread {
        Misread::GravityOpposite => value.to_degrees(),
        Misread::TimeStamps => MILLISECOND.from_si(value),
        _ => value,
    });
    // A factor that the run does not measure is that of the convention.
    let is_measured = by_convention.is_none_or(|exact| exact != value);
    let shown = if is_measured { shown } else { identification::about(&shown, language) };
    let mut text = identification::doubt(column, misread, &shown, language);
    if let Some(exact) = by_convention.filter(|_| is_measured) {
        text.push(' ');
        text.push_str(&identification::factor_of_convention(&number(exact), language));
    }
    Doubted { id: misread.id(), column: identification::column_heading(column), text }
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

fn row(
    estimate: &Estimate,
    project: &AxisProject,
    actuator: &Parameters,
    tabulated_nm_a: Option<f64>,
    language: Language,
) -> Identified95 {
    let (title, unit) = title_and_unit(estimate.of);
    let number = |si: f64| Number::in_unit(si, unit);
    Identified95 {
        id: estimate.of.id(),
        title: title(language).to_owned(),
        value: number(estimate.value),
        half_width: number(estimate.half_width),
        unit: unit.json,
        stated: stated(estimate.of, project, actuator, tabulated_nm_a).map(number),
        known: estimate.is_known(),
    }
}

/// Returns the value that project or tables state.
fn stated(of: Identified, project: &AxisProject, actuator: &Parameters, tabulated_nm_a: Option<f64>) -> Option<f64> {
    let mechanism = &project.axis.mechanism;
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
        Identified::GravityAngle => plain.filter(|plain| plain.weight_nm != 0.0).map(|plain| weight_angle(&plain)),
        Identified::External => plain.map(|plain| plain.constant_nm),
        Identified::TorqueConstant => tabulated_nm_a.or_else(|| known_si(&actuator.torque_constant_out)),
        Identified::StartingCurrent => known_si(&actuator.no_load_starting_current),
        Identified::CurrentConstant => known_si(&actuator.no_load_current_constant_cold),
    }
}

/// Returns the angle of a weight of positive magnitude, within half a turn to both sides \[rad\].
fn weight_angle(plain: &Plain) -> f64 {
    let (sine, cosine) = plain.angle_rad.sin_cos();
    (plain.weight_nm.signum() * sine).atan2(plain.weight_nm.signum() * cosine)
}

/// Returns `true` if a measured value can replace the value of the mechanism.
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

/// Returns the key of `[twin.measured]`; `None` if a run alone does not determine the value, as for a constant that
/// depends on the temperature.
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

/// Returns lines of a project file: one for each estimate that the run determines, none for those it leaves open.
fn overrides(estimates: &[Estimate], taken: impl Fn(Identified) -> bool) -> String {
    let known = |of: Identified| estimates.iter().any(|each| each.of == of && each.is_known());
    let mut lines = String::new();
    for estimate in estimates.iter().filter(|each| taken(each.of) && each.is_known()) {
        // The angle of a weight has no meaning without the weight.
        let is_alone = estimate.of == Identified::GravityAngle && !known(Identified::Gravity);
        let Some(key) = key(estimate.of).filter(|_| !is_alone) else { continue };
        let (_, unit) = title_and_unit(estimate.of);
        let value = Number::in_unit(estimate.value, unit).written().unwrap_or(estimate.value);
        // Five significant digits, for small values too.
        let value: f64 = format!("{value:.4e}").parse().unwrap_or(value);
        lines.push_str(&format!("{key} = \"{value} {}\"\n", unit.ascii));
    }
    if lines.is_empty() { lines } else { format!("[twin.measured]\n{lines}") }
}
