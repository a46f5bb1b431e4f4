//! An axis made of its sections: checked first, then combined.

use crate::assumption::{Assumption, unstated};
use crate::catalogue::Catalogue;
use crate::fault::AxisReport;
use crate::mechanism::{self, driven};
use crate::source::AxisSource;
use crate::{computed, flange, motion, order, own, requirements, stage};
use ::mechanism::{Extra, Mechanism};
use ::motion::Motion;
use configurator::{Product, Requirements};
use project::sections::{RequirementsSection, Section, StatedField};
use project::{Fault, Hint};
use sizing::{Axis, BearingDuty, BrakeTimes};

/// Returns the defaults that were used.
pub(crate) fn assumptions(root: &AxisSource, axis: &Axis, offers_series: bool, toleranced: bool) -> Vec<Assumption> {
    let mut found = Vec::new();
    let driven = driven(&root.parts);
    if let Some(driven) = driven {
        mechanism::assumptions(driven, &mut found);
    }
    motion::assumptions(root, driven, &mut found);
    computed::assumptions(axis, &mut found);
    let absent = RequirementsSection::absent(root.head());
    let required = root.parts.requirements.get().unwrap_or(&absent);
    found.extend(unstated(&required.ambient));
    found.extend(requirements::conditions_note(required));
    found.extend(offers_series.then_some(Assumption::CoolingPlate));
    if root.parts.actuator.get().is_some_and(|own| own.values.stall_current.is_given()) {
        found.push(Assumption::OwnStallCurrentIncludesFriction);
    }
    found.extend(order::unusual(&root.parts));
    found.extend(requirements::link_notes(required));
    if let Some(stage) = root.parts.stage.get() {
        stage::assumptions(stage, axis.mechanism.stage_ratio(), &mut found);
    }
    flange::assumptions(root, &mut found);
    found.extend(unstated(&required.special_application));
    found.extend(toleranced.then_some(Assumption::UniformTolerances));
    let left_out = required.leave_out.get().map_or(&[][..], |words| words.0.as_slice());
    found.retain(|each| each.left_out().is_none_or(|word| !left_out.contains(&word)));
    found
}

/// Returns the requirements on the choice of an actuator.
pub(crate) fn requirements(root: &AxisSource) -> Requirements {
    root.parts.requirements.get().map_or_else(Requirements::default, requirements::build)
}

/// Checked parts of an axis before they are combined.
pub(crate) struct Draft {
    pub(crate) mechanism: Mechanism,
    pub(crate) motion: Motion,
    extras: Vec<Extra>,
    pub(crate) bearing: BearingDuty,
    brake_times: Option<BrakeTimes>,
}

/// Prepares an axis and reports all of its faults; [`finish`] only computes.
pub(crate) fn prepare(root: &AxisSource, catalogue: &dyn Catalogue, report: &mut AxisReport<'_>) -> Option<Draft> {
    if !root.parts.motion.is_written() && !report.is_damaged() {
        let hint = Hint::Example("[[motion]]".to_owned());
        let fault = Fault::MissingKey { path: root.parts.motion.name().to_owned(), list: true };
        report.fault(root.head().start(), fault, Some(hint));
    }
    flange::stated(root, report);
    order::check(&root.parts, report);
    if let Some(required) = root.parts.requirements.get() {
        requirements::battery(required, catalogue, report);
        requirements::offer(required, catalogue, report);
        let has_line = driven(&root.parts).is_none_or(|driven| driven.travel().is_some());
        requirements::check(required, has_line, report);
    }
    let stage = root.parts.stage.get().and_then(|stage| stage::build(stage, report));
    let Some(load) = mechanism::load(root, report) else {
        motion::without_load(root, report);
        return None;
    };
    // The file states the motion of the mechanism; the following values are those of the actuator's output.
    let mechanism = Mechanism { stage, ..load.mechanism.clone() };
    let bearing = flange::duty(root, &mechanism, report);
    let (motion, extras) = motion::motion(root, &load, report)?;
    let motion = motion.geared(mechanism.stage_ratio());
    Some(Draft { mechanism, motion, extras, bearing, brake_times: catalogue.brake_times() })
}

/// Combines load, motion and requirements.
pub(crate) fn finish(root: &AxisSource, draft: Draft) -> Axis {
    let uses = root.recordings().find_map(|read| read.uses.as_ref());
    let surveys = uses.map(|uses| uses.surveys()).unwrap_or_default();
    let mut axis = Axis::surveyed(draft.mechanism, draft.motion, draft.extras, draft.brake_times, &surveys);
    if let Some(uses) = uses {
        uses.keep_surveys(axis.surveys());
    }
    if let Some(required) = root.parts.requirements.get() {
        requirements::apply(required, &mut axis);
    }
    if let Some(drive) = root.parts.drive.get() {
        requirements::apply_drive(drive, &mut axis);
    }
    axis.bearing = Some(draft.bearing);
    axis
}

/// Builds the actuator of the user, if the file describes one.
pub(crate) fn build_actuator(
    root: &AxisSource,
    catalogue: &dyn Catalogue,
    report: &mut AxisReport<'_>,
) -> Option<Product> {
    own::build(root.parts.actuator.get()?, catalogue.own_actuator(), report)
}
