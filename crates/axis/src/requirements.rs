//! Requirements on the actuator, and the drive that supplies it.

use crate::assumption::{Assumption, unstated};
use crate::catalogue::Catalogue;
use crate::choices;
use crate::fault::{AxisFault, AxisReport};
use actuator::{BatteryFault, Protection};
use configurator::{Price, Requirements, is_maker};
use project::choices::MainsPhases;
use project::sections::{DriveSection, PositionLoop, RequirementsSection, Section, StatedField};
use project::{Fault, Hint, example};
use sizing::{Axis, AxisRequirements, Supply, SupplyFrom};

/// Returns the requirements on the choice of an actuator.
pub(crate) fn build(section: &RequirementsSection) -> Requirements {
    Requirements {
        feedback: section.feedback.get().map(|all| all.0.clone()).unwrap_or_default(),
        brake: section.brake.value(),
        hollow_shaft_min: section.hollow_shaft_min.value(),
        length_max: section.length_max.value(),
        mass_max: section.mass_max.value(),
        makers: section
            .makers
            .get()
            .map(|all| all.0.iter().map(|(name, _)| name.clone()).collect())
            .unwrap_or_default(),
        price_max: section.price_max.get().and_then(|price| Price::read(price)),
        lead_time_max: section.lead_time_max.value(),
        supply: link(section).map(|supply| supply.least()),
    }
}

/// Returns the DC link.
fn link(section: &RequirementsSection) -> Option<Supply> {
    let (phases, deviation) = (phases(section), section.mains_deviation());
    let of_mains = |nominal| SupplyFrom::Mains { phases: choices::mains_phases(phases), nominal, deviation };
    let from = section.supply.value().map(SupplyFrom::DcLink).or_else(|| section.mains.value().map(of_mains))?;
    Some(Supply { reserve: section.modulation_reserve(), from })
}

fn phases(section: &RequirementsSection) -> MainsPhases {
    section.mains_phases.value().unwrap_or(MainsPhases::Three)
}

/// Returns the assumption about conditions of use that are not stated.
pub(crate) fn conditions_note(section: &RequirementsSection) -> Option<Assumption> {
    let has_humidity = section.humidity_min.is_given() || section.humidity_max.is_given();
    let accelerations = section.vibration.is_given() && section.shock.is_given();
    let is_complete = section.altitude.is_given()
        && section.protection.is_given()
        && has_humidity
        && accelerations
        && section.mounting.is_given();
    (!is_complete).then_some(Assumption::ConditionsWithinRange)
}

/// Returns the assumptions about the DC link.
pub(crate) fn link_notes(section: &RequirementsSection) -> Vec<Assumption> {
    if !section.mains.is_given() {
        return unstated(&section.supply).or_else(|| unstated(&section.modulation_reserve)).into_iter().collect();
    }
    let rectifier = match (phases(section), section.mains_deviation.is_given()) {
        (MainsPhases::Three, true) => Assumption::Rectifier,
        (MainsPhases::Three, false) => Assumption::RectifierAndDeviation,
        (MainsPhases::Single, true) => Assumption::SinglePhaseRectifier,
        (MainsPhases::Single, false) => Assumption::SinglePhaseRectifierAndDeviation,
    };
    std::iter::once(rectifier).chain(unstated(&section.modulation_reserve)).collect()
}

/// Reports contradictions, and keys without effect; `has_line`: the mechanism moves along a line in proportion to its
/// angle.
pub(crate) fn check(section: &RequirementsSection, has_line: bool, report: &mut AxisReport<'_>) {
    if section.supply.is_given() && section.mains.is_given() {
        report.fault(section.mains.span(), Fault::SupplyAndMains, None);
    }
    let pairs: [(&dyn StatedField, &dyn StatedField); 6] = [
        (&section.deviation_max, &section.lever_arm),
        (&section.altitude_derating, &section.altitude),
        (&section.collision_time, &section.collision_torque),
        (&section.collisions, &section.collision_torque),
        (&section.mains_phases, &section.mains),
        (&section.mains_deviation, &section.mains),
    ];
    // Along a line the deviation is that of the travel: a lever arm would give another one.
    if has_line && section.lever_arm.is_given() {
        report.fault(section.lever_arm.span(), Fault::WithoutEffect { key: section.lever_arm.name() }, None);
    }
    for (field, needs) in pairs {
        // Along a line the travel per angle takes the place of the lever arm.
        let is_known = has_line && needs.name() == section.lever_arm.name();
        if field.is_given() && !needs.is_written() && !is_known {
            let key = RequirementsSection::KEYS.iter().find(|key| key.name == needs.name());
            let fault = Fault::OnlyBeside { key: field.name(), needs: needs.name() };
            report.fault(field.span(), fault, key.and_then(example).map(Hint::Example));
        }
    }
}

/// Sets the limits of the checks.
pub(crate) fn apply(section: &RequirementsSection, axis: &mut Axis) {
    axis.ambient = section.ambient.value();
    axis.supply = link(section);
    axis.asked = AxisRequirements {
        gear_life_min: section.gear_life_min.value(),
        torsion_max: section.torsion_max.value(),
        natural_frequency_min: section.natural_frequency_min.value(),
        angle_error_max: section.angle_error_max.value(),
        lever_arm: section.lever_arm.value(),
        deviation_max: section.deviation_max.value(),
        stop_angle_max: section.stop_angle_max.value(),
        emergency_stops: section.emergency_stops.value().map(f64::from),
        holding_safety: section.holding_safety.value(),
        service_life: section.service_life.value(),
        regeneration_power_max: section.regeneration_power_max.value(),
        absolute: section.absolute.value(),
        resolution_max: section.resolution_max.value(),
        operation_per_day: section.operation_per_day.value(),
        storage: section.storage.value(),
        battery_life_min: section.battery_life_min.value(),
        collision_torque: section.collision_torque.value(),
        collision_time: section.collision_time.value(),
        collisions: section.collisions.value().map(f64::from),
        loop_at_output: section.position_loop.value() == Some(PositionLoop::Output),
        dc_link_rise: section.dc_link_rise.value(),
        altitude: section.altitude.value(),
        altitude_derating: section.altitude_derating.value(),
        protection: section.protection.value().and_then(|degree| Protection::read(degree.code())),
        humidity_min: section.humidity_min.value(),
        humidity_max: section.humidity_max.value(),
        vibration: section.vibration.value(),
        shock: section.shock.value(),
        mounting: section.mounting.value().map(choices::mounting_position),
        special_application: section.special_application.value().map(choices::special_application),
        ..AxisRequirements::default()
    };
}

/// Reports a price without amount or currency, and manufacturers that the catalogue does not have.
pub(crate) fn offer(section: &RequirementsSection, catalogue: &dyn Catalogue, report: &mut AxisReport<'_>) {
    if section.price_max.get().is_some_and(|price| Price::read(price).is_none()) {
        report.fault(section.price_max.span(), AxisFault::NoPrice, None);
    }
    let Some(stated) = section.makers.get() else { return };
    let mut makers: Vec<String> = Vec::new();
    for maker in catalogue.products(false).iter().filter_map(|product| product.manufacturer.as_deref()) {
        if !makers.iter().any(|known| known == maker) {
            makers.push(maker.to_owned());
        }
    }
    for (name, span) in &stated.0 {
        if !makers.iter().any(|maker| is_maker(maker, name)) {
            let fault = AxisFault::UnknownMaker { name: name.clone(), makers: makers.clone() };
            report.fault(span.clone(), fault, None);
        }
    }
}

/// Reports an operation for which the life of the battery is unknown.
pub(crate) fn battery(section: &RequirementsSection, catalogue: &dyn Catalogue, report: &mut AxisReport<'_>) {
    let Some(operation) = section.operation_per_day.value() else { return };
    let battery = catalogue.battery();
    let Some(model) = battery.known() else { return };
    if let Err(fault) = model.value.life(operation, section.storage.or_zero()) {
        let operation = matches!(fault, BatteryFault::OperationOutOfRange { .. });
        let span = if operation { section.operation_per_day.span() } else { section.storage.span() };
        report.fault(span, AxisFault::Battery(fault), None);
    }
}

/// Sets the data of the drive for its check.
pub(crate) fn apply_drive(section: &DriveSection, axis: &mut Axis) {
    axis.asked.drive_current_continuous = section.current_continuous.value();
    axis.asked.drive_current_peak = section.current_peak.value();
    axis.asked.drive_peak_time = section.peak_time.value();
}
