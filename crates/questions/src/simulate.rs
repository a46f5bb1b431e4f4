//! A run of the digital twin of an axis with an actuator.

mod steps;

pub use steps::RunChange;
pub(crate) use steps::{StepLimit, TooManySteps, Work};

use crate::progress::Progress;
use crate::sizing_use::{Candidate, Refusal};
use crate::subject::stated_or_best;
use actuator::{Parameters as Actuator, natural_frequency, natural_frequency_free};
use axis::AxisProject;
use configurator::ProductId;
use installation::wiring::Role;
use mechanism::Extra;
use order_code::OrderCode;
use quantities::{ElectricPotential, Frequency, Measure, MomentOfInertia};
use sizing::{CheckId, RunCase, RunCheck, RunCheckId, StepObserver as _, Verdict};
use twin::{
    Averaged, Event, EventKind, Failed, Fault, Gains, LoopResponse, Operation, Parameters, Part, PeriodCourse, Sample,
    Scenario, ScenarioId, Setup, Summary, Supply, Twin, WorstInstant,
};
use words::{Word, simulation};

/// Largest number of rows of a course: about two hundred bytes each.
pub(crate) const ROWS_MOST: u64 = 1_000_000;

/// Default of the largest voltage of a DC link \[V\].
const SUPPLY_USUAL_V: f64 = 560.0;

/// Periods of the current loop between two polls of the caller: 64 ms of the run.
const AT_ONCE: u64 = 1024;

/// Data of a run besides the project.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Wanted {
    pub(crate) scenario: Scenario,
    pub(crate) seed: u64,
    /// Time between two rows of the course \[s\].
    pub(crate) every_s: Option<f64>,
    /// Operation over days, by the mean losses of the cycle.
    pub(crate) operation: Option<Operation>,
    /// Part of the motion instead of its cycles.
    pub(crate) part: Option<Part>,
}

/// Reasons why nothing is simulated.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NotRun {
    /// The actuator is not judged.
    Refused(Refusal),
    /// The twin cannot run.
    Fault(Fault),
    /// The number of steps exceeds the limit.
    Steps(TooManySteps),
    /// The number of rows exceeds the limit.
    Rows(u64),
}

impl From<Refusal> for NotRun {
    fn from(refusal: Refusal) -> Self {
        Self::Refused(refusal)
    }
}

impl From<TooManySteps> for NotRun {
    fn from(fault: TooManySteps) -> Self {
        Self::Steps(fault)
    }
}

impl From<Fault> for NotRun {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

/// A run with the data for its comparison.
#[derive(Clone, Debug)]
pub struct Simulated<'p> {
    /// The axis.
    pub project: &'p AxisProject,
    /// The actuator, judged.
    pub candidate: Candidate<'p>,
    /// Scenario of the run.
    pub scenario: Scenario,
    /// Part of the motion that was run; `None` for all cycles.
    pub part: Option<Part>,
    /// Seed of phases and noise.
    pub seed: u64,
    /// The run in figures.
    pub summary: Summary,
    /// Choice of the instant of the event; `None` if it is stated or the scenario has none.
    pub worst: Option<WorstInstant>,
    /// Events of the run.
    pub events: Vec<Event>,
    /// Failure of the feedback.
    pub failed: Option<Failed>,
    /// Course, if requested.
    pub course: Vec<Sample>,
    /// Control loops.
    pub loops: Vec<LoopResponse>,
    /// The gains in use.
    pub gains: Gains,
    /// `true` if the project states gains.
    pub gains_stated: bool,
    /// Every parameter.
    pub parameters: Parameters,
    /// Symbols of data that the manual does not state.
    pub left_out: Vec<&'static str>,
    /// Number of solver steps.
    pub steps: u64,
    /// Length of a step \[s\].
    pub step_s: f64,
    /// Ambient temperature \[K\].
    pub ambient_k: f64,
    /// Temperatures of winding and housing at the start \[K\].
    pub start_k: [f64; 2],
    /// Assumed voltage of the DC link \[V\]; `None` if the project states it.
    pub supply_assumed_v: Option<f64>,
    /// Simulated supply.
    pub supply: Supply,
    /// Operation over days, if requested and if the actuator has a thermal model.
    pub averaged: Option<(Operation, Averaged)>,
    /// Resonance frequencies with blocked and with free motor.
    pub resonance: Option<[Frequency; 2]>,
}

/// Runs a part of the twin that polls for cancellation by the caller.
fn watched<T>(
    progress: &Progress,
    run: impl FnOnce(&mut dyn FnMut() -> bool) -> Result<T, Fault>,
) -> Result<T, NotRun> {
    let mut stopped = false;
    let found = run(&mut || {
        stopped = progress.step().is_err();
        !stopped
    })?;
    if stopped { Err(Refusal::Stopped.into()) } else { Ok(found) }
}

/// Simulates the actuator.
pub(crate) fn simulate<'p>(
    project: &'p AxisProject,
    id: Option<&ProductId>,
    wanted: Wanted,
    limit: StepLimit,
    progress: &Progress,
) -> Result<Simulated<'p>, NotRun> {
    let candidate = stated_or_best(project, id, progress)?;
    let id = Some(&candidate.id);
    let ready = Ready::of(project, &candidate);
    let (ambient_k, assumed_v) = (ready.ambient_k, ready.assumed_v);
    let encoder = id.and_then(ProductId::order_code).and_then(encoder_of);
    let Wanted { scenario, seed, part, .. } = wanted;
    let mut setup = Setup { scenario, seed, part, encoder: encoder.as_ref(), ..ready.setup() };
    let (gains, gains_stated) = ready.controlled(&mut setup)?;
    let loops = LoopResponse::of(&setup)?;
    // An unstable inner loop makes the outer ones unstable.
    if let Some(LoopResponse { of, margins, .. }) = loops.iter().find(|each| gains_stated && !each.margins.stable) {
        return Err(Fault::Unstable { of: *of, limit: margins.gain }.into());
    }
    let twin = Twin::new(&setup)?;
    let is_warm = wanted.scenario.starts_warm();
    let work = match part {
        // Its temperatures at the start are those of the sizing.
        Some(_) => Work::of_part(&scenario),
        None => Work::of_axis(project, &scenario, wanted.operation.is_some()),
    };
    let work = work.with_run(twin.steps());
    Work::within(&[work], limit)?;
    let rows_every = wanted.every_s.map(|every| (every * twin::CURRENT_RATE_HZ).round().max(1.0));
    if let Some(every) = rows_every {
        #[allow(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "counts"
        )]
        let rows = (twin.periods() as f64 / every) as u64;
        if rows > ROWS_MOST {
            return Err(NotRun::Rows(rows));
        }
    }
    let start_k = match part {
        _ if !is_warm => None,
        Some(part) => steady_at(project, &candidate, part.from_s),
        None => watched(progress, |goes_on| twin::settled(&setup, goes_on))?,
    };
    let averaged = match wanted.operation {
        Some(operation) => {
            let found = watched(progress, |goes_on| twin::averaged(&setup, operation, goes_on))?;
            found.map(|found| (operation, found))
        }
        None => None,
    };
    setup.start_k = start_k;
    let searched = work.search_periods(limit);
    let worst = watched(progress, |goes_on| twin::worst_instant(&setup, searched, goes_on))?;
    if let Some(first) = worst.as_ref().and_then(|worst| worst.directions.first()) {
        setup.scenario.at_s = Some(first.at_s);
    }
    let mut twin = Twin::new(&setup)?;
    let start = twin.sample();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked above")]
    let chunk = rows_every.map_or(AT_ONCE, |every| every as u64);
    let mut course = Vec::new();
    let mut since_poll = 0;
    if wanted.every_s.is_some() {
        course.push(start);
    }
    while !twin.is_over() {
        if since_poll >= AT_ONCE {
            progress.step().map_err(Refusal::from)?;
            since_poll = 0;
        }
        twin.advance(chunk);
        since_poll += chunk;
        if wanted.every_s.is_some() {
            course.push(twin.sample());
        }
    }
    let resonance = resonance(
        &ready.parameters.actuator,
        project.axis.mechanism.inertia(start.position_rad, ready.extras().first().unwrap_or(&ready.none)),
    );
    Ok(Simulated {
        project,
        candidate,
        scenario,
        part,
        seed,
        summary: twin.summary(),
        worst,
        events: twin.events().to_vec(),
        failed: twin.failed(),
        course,
        loops,
        gains,
        gains_stated,
        left_out: twin.left_out().to_vec(),
        steps: twin.steps(),
        step_s: 1.0 / (twin::CURRENT_RATE_HZ * f64::from(setup.substeps)),
        ambient_k,
        start_k: [start.winding_k, start.housing_k],
        supply_assumed_v: project.axis.supply.is_none().then_some(assumed_v),
        supply: ready.supply,
        averaged,
        resonance,
        parameters: ready.parameters,
    })
}

/// Returns the temperatures of winding and housing in the steady cycle at an instant, as the check on the winding computes
/// them \[K\]; `None` if the actuator has no heat model.
fn steady_at(project: &AxisProject, candidate: &Candidate<'_>, at_s: f64) -> Option<[f64; 2]> {
    let course = crate::sizing_use::course(project, candidate);
    let behind = course.samples.partition_point(|sample| sample.time_s <= at_s);
    let last = course.samples.get(behind.saturating_sub(1))?;
    let next = course.samples.get(behind).unwrap_or(last);
    let long = next.time_s - last.time_s;
    let share = if long > 0.0 { (at_s - last.time_s) / long } else { 0.0 };
    let between = |a: f64, b: f64| a + share * (b - a);
    let winding_k = between(last.winding_k?, next.winding_k?);
    let housing_k = last.housing_k.zip(next.housing_k).map_or(winding_k, |(a, b)| between(a, b));
    Some([winding_k, housing_k])
}

/// Returns the signals of the motor encoder of a code.
pub(crate) fn encoder_of(code: &OrderCode) -> Option<feedback::Encoder> {
    let fitted = installation::encoder::encoders(code)?;
    fitted.into_iter().find(|each| each.role == Role::Feedback).map(|each| each.encoder)
}

/// Inputs of a twin of an axis with an actuator.
pub(crate) struct Ready<'p> {
    project: &'p AxisProject,
    pub(crate) parameters: Parameters,
    assumed_v: f64,
    supply: Supply,
    ambient_k: f64,
    none: Extra,
}

impl<'p> Ready<'p> {
    pub(crate) fn of(project: &'p AxisProject, candidate: &Candidate<'_>) -> Self {
        let dc_link_max = candidate.parameters.dc_link_max.known().map_or(SUPPLY_USUAL_V, |known| known.value.si());
        let assumed_v = SUPPLY_USUAL_V.min(dc_link_max);
        let supply = project.axis.supply.as_ref().map_or(Supply::of(assumed_v), |supply| Supply {
            least_v: supply.least().si(),
            nominal_v: supply.nominal().si(),
            most_v: supply.most().si(),
        });
        let parameters = parameters(project, candidate.parameters, &supply);
        let heat = actuator::HeatModel::of(&parameters.actuator).ok();
        let reference = heat.map(|heat| heat.ambient_reference());
        Self {
            project,
            ambient_k: project.axis.ambient.or(reference).map_or(313.15, Measure::si),
            parameters,
            assumed_v,
            supply,
            none: Extra::none(),
        }
    }

    fn extras(&self) -> &[Extra] {
        let extras = &self.project.axis.extras;
        if extras.is_empty() { std::slice::from_ref(&self.none) } else { extras }
    }

    /// Returns the setup with the gains of the tuning rule.
    pub(crate) fn setup(&self) -> Setup<'_> {
        let axis = &self.project.axis;
        Setup {
            switches: self.project.twin.switches,
            supply: self.supply,
            modulation: axis.supply.as_ref().map_or(1.0, |supply| supply.reserve),
            ambient_k: self.ambient_k,
            loop_at_output: self.project.axis.asked.loop_at_output,
            ..Setup::of(&self.parameters, &axis.mechanism, &axis.motion, self.extras())
        }
    }

    /// Sets gains and limits as stated by the project; returns the gains, and `true` if the project states any.
    pub(crate) fn controlled(&self, setup: &mut Setup<'_>) -> Result<(Gains, bool), Fault> {
        let twin = &self.project.twin;
        let usual = Twin::new(setup)?;
        let gains = twin.gains(*usual.gains());
        setup.gains = Some(gains);
        setup.limits = Some(twin.limits(*usual.limits()));
        Ok((gains, gains != *usual.gains()))
    }
}

/// Returns the parameters of an actuator, with the values that the project replaces.
fn parameters(project: &AxisProject, actuator: &Actuator, supply: &Supply) -> Parameters {
    replaced(project, Parameters::on_supply(actuator, supply))
}

/// Returns the parameters with the measured values of the project in their place.
pub(crate) fn replaced(project: &AxisProject, mut parameters: Parameters) -> Parameters {
    project.twin.replace(&mut parameters);
    parameters
}

/// Computes the natural frequencies with the second stiffness of the gear: with blocked and with free motor.
fn resonance(actuator: &Actuator, load: MomentOfInertia) -> Option<[Frequency; 2]> {
    let stiffness = actuator.gear.stiffness.get(1)?.known()?.value;
    let rotor = actuator.inertia_out.known()?.value;
    (load.si() > 0.0).then(|| [natural_frequency(stiffness, load), natural_frequency_free(stiffness, load, rotor)])
}

/// Function that returns a figure of a run in SI.
pub(crate) type Shown = fn(&Summary) -> f64;

/// Checks of the sizing that the twin reproduces, each with its value in SI and the reason for a difference.
pub(crate) const COMPARED: [(CheckId, Shown, Word); 6] = [
    (CheckId::PeakTorque, |summary| summary.torque_peak_nm, simulation::why_torque),
    (CheckId::PeakSpeed, |summary| summary.speed_peak_rad_s, simulation::why_speed),
    (CheckId::PeakCurrent, |summary| summary.current_peak_a, simulation::why_current),
    (CheckId::Thermal, |summary| summary.winding_peak_k, simulation::why_thermal),
    (CheckId::OverloadI2t, |summary| summary.overload_peak, simulation::why_overload),
    (CheckId::Regeneration, |s| s.energies.regenerated_j / s.time_s, simulation::why_regeneration),
];

/// Events that are faults of the drive.
const FAULTS: [EventKind; 9] = [
    EventKind::Overload,
    EventKind::WindingShutdown,
    EventKind::PtcResponse,
    EventKind::FollowingError,
    EventKind::LinkLow,
    EventKind::LinkHigh,
    EventKind::NoPosition,
    EventKind::Overspeed,
    EventKind::Diverged,
];

impl Simulated<'_> {
    /// Returns the temperatures over the first and the last day of operation; `None` if no days are requested or the
    /// actuator has no thermal model.
    #[must_use]
    pub fn days(&self) -> Option<&[PeriodCourse]> {
        self.averaged.as_ref().map(|(_, found)| found.courses.as_slice())
    }

    /// Returns `true` if the scenario is a cycle that must be completed.
    fn runs_through(&self) -> bool {
        matches!(self.scenario.id, ScenarioId::Cycle | ScenarioId::HotAmbient | ScenarioId::ColdGrease)
    }

    /// Returns the time between two rows of the course \[s\]: a whole number of periods of the current loop.
    #[must_use]
    pub fn every_s(&self) -> f64 {
        self.course.get(1).map_or(0.0, |row| row.time_s)
    }

    /// Returns the figure of a check; `None` if the scenario has none.
    fn figure(&self, id: RunCheckId) -> Option<f64> {
        let summary = &self.summary;
        match id {
            RunCheckId::CurrentPeak => Some(summary.current_peak_a),
            RunCheckId::TorquePeak => Some(summary.torque_peak_nm),
            RunCheckId::SpeedPeak => Some(summary.speed_peak_rad_s),
            RunCheckId::WindingPeak => Some(summary.winding_peak_k),
            RunCheckId::Overload => Some(summary.overload_peak),
            RunCheckId::LinkHigh => Some(summary.link_v[1]),
            RunCheckId::StopAngle => summary.stop_rad,
            #[allow(clippy::cast_precision_loss, reason = "a handful")]
            RunCheckId::DriveFaults => self
                .runs_through()
                .then(|| self.events.iter().filter(|event| FAULTS.contains(&event.kind)).count() as f64),
        }
    }

    /// Returns the checks of the run.
    pub(crate) fn checks(&self) -> Vec<RunCheck> {
        let case = RunCase {
            actuator: &self.parameters.actuator,
            is_cycle: self.runs_through(),
            is_limited: self.project.twin.switches.limits,
            has_chopper_room: self.supply_within(),
            stop_angle_max: self.project.axis.asked.stop_angle_max,
        };
        RunCheckId::ALL.into_iter().filter_map(|id| Some(id.compare(self.figure(id)?, &case))).collect()
    }

    /// Returns `true` if a braking resistor can keep the DC link between supply and U_DCmax; `None` if the supply is
    /// above U_DCmax or U_DCmax is not known.
    pub(crate) fn supply_within(&self) -> Option<bool> {
        let most = ElectricPotential::from_si(self.supply.most_v);
        let limit = self.parameters.actuator.dc_link_max.known()?.value;
        (most.si() <= limit.si()).then(|| actuator::chopper_thresholds(most, Some(limit)).is_some())
    }

    /// Returns `true` if no limit is exceeded.
    #[must_use]
    pub fn fits(&self) -> bool {
        self.checks().iter().all(|each| each.verdict != Verdict::Fail)
    }
}
