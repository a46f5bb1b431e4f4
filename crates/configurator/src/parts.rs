//! Parts of an actuator other than motor and gear: brake, feedback, accuracy, bolted joints.

use crate::cells::{by_size, feedback_cell, number_of, quantity_of};
use crate::family::battery_of;
use actuator::{Accuracy, Brake, Feedback, FeedbackSide, ScrewJoint};
use catalogue::{Cell, Drive};
use order_code::{Brake as BrakeOrdered, FeedbackKind, OrderCode, Series};
use provenance::{Datum, Grade, Sourced};
use quantities::{Angle, Measure};
use std::borrow::Cow;
use std::sync::LazyLock;

/// Returns the data of tables `*.2` and `*.3` of a drive on its brake.
pub(crate) fn brake(drive: &Drive, code: &OrderCode) -> Brake {
    if code.brake == BrakeOrdered::Without {
        return Brake::absent();
    }
    let (feedback, ratio) = (code.feedback, code.ratio);
    Brake {
        holding_torque: drive.datum("T_Br", "", feedback, ratio),
        voltage: drive.datum("U_Br", "", feedback, ratio),
        opening_current: drive.datum("I_OBr", "", feedback, ratio),
        holding_current: drive.datum("I_HBr", "", feedback, ratio),
        opening_time: drive.datum("t_o", "", feedback, ratio),
        closing_time: drive.datum("t_c", "", feedback, ratio),
        brakings_max: number_of(drive.cell("N_brakings", "n = 0", feedback, ratio)),
        emergency_max: number_of(drive.cell("N_emergency", "", feedback, ratio)),
    }
}

/// Returns a full turn divided by a number of steps.
fn step_of(cell: Option<&'static Cell>) -> Datum<Angle> {
    number_of(cell).map(|steps| {
        let grade = steps.grade.worst(Grade::Computed);
        Sourced { grade, ..steps.map(|steps| Angle::from_si(std::f64::consts::TAU / steps)) }
    })
}

/// Turns a datum whose row is absent into one that does not apply.
fn if_printed<T>(datum: Datum<T>) -> Datum<T> {
    match datum {
        Datum::NotPrinted => Datum::NotApplicable,
        datum => datum,
    }
}

/// Returns the data of the manual on the motor feedback, looked up once for all codes.
pub(crate) fn feedback(code: &OrderCode) -> Feedback {
    static ALL: LazyLock<Vec<(order_code::Feedback, Feedback)>> = LazyLock::new(|| {
        let ordered = Series::all().flat_map(order_code::Feedback::all);
        ordered.map(|ordered| (ordered, printed_feedback(ordered))).collect()
    });
    let known = ALL.iter().find(|(ordered, _)| *ordered == code.feedback);
    known.map_or_else(Feedback::default, |(_, feedback)| feedback.clone())
}

fn printed_feedback(ordered: order_code::Feedback) -> Feedback {
    let cell = |symbol| feedback_cell(ordered.series(), ordered.as_str(), symbol);
    let value = |symbol| quantity_of(cell(symbol));
    Feedback {
        side: FeedbackSide::Motor,
        resolution: step_of(cell("resolution_motor_inc")),
        resolution_absolute: if_printed(step_of(cell("positions_per_turn"))),
        accuracy: quantity_of(cell("accuracy")),
        turns_absolute: if_printed(number_of(cell("turns"))),
        // The resolvers of the catalogue have one pole pair (table 58.2), so that the angle is unique within one turn.
        single_turn_absolute: match ordered.kind() {
            Some(FeedbackKind::EndatMultiturn | FeedbackKind::SsiMultiturn | FeedbackKind::Resolver) => true,
            Some(FeedbackKind::SineIncremental | FeedbackKind::SquareIncremental) | None => false,
        },
        buffered_by_battery: cell("turns_memory").is_some(),
        battery: if cell("turns_memory").is_some() { battery_of(ordered) } else { Datum::NotApplicable },
        exchange_interval: if_printed(value("encoder_exchange_interval")),
    }
}

/// Returns the data of table 68.1 on the encoder at the output, if the code has one.
pub(crate) fn feedback_out(code: &OrderCode) -> Feedback {
    let absent = Feedback::absent(FeedbackSide::Output);
    let Some(option) = code.option_1 else { return absent };
    let cell = |symbol| feedback_cell(code.series(), option.as_str(), symbol);
    Feedback {
        // The manual lists the resolution at the output directly, rounded; it has no row for the steps of this encoder.
        resolution: quantity_of(cell("resolution_out")),
        resolution_absolute: step_of(cell("positions_per_turn")),
        accuracy: quantity_of(cell("accuracy")),
        single_turn_absolute: true,
        ..absent
    }
}

/// Returns the data of tables 54.1 and 54.2 on the accuracy of the gear.
pub(crate) fn accuracy(code: &OrderCode) -> Accuracy {
    Accuracy {
        transmission_accuracy: by_size(code, "transmission_accuracy"),
        repeatability: by_size(code, "repeatability"),
        hysteresis_loss: by_size(code, "hysteresis_loss"),
        lost_motion: by_size(code, "lost_motion"),
    }
}

/// Returns the data of table 79.1 on the bolt circle of a side, `load` or `housing`.
pub(crate) fn screw_joint(code: &OrderCode, side: &str) -> ScrewJoint {
    let cell = |row: &str| catalogue::size_cell(code.size, code.ratio, &format!("{row}_{side}"));
    let text = |row| {
        let cell = cell(row).filter(|cell| !cell.corrected.is_empty() && cell.corrected != "-");
        Datum::of(cell.map(|cell| cell.sourced(Cow::Borrowed(cell.corrected))))
    };
    ScrewJoint {
        count: number_of(cell("screw_count")),
        size: text("screw_size"),
        grade: text("screw_grade"),
        bolt_circle: quantity_of(cell("bolt_circle")),
        tightening_torque: quantity_of(cell("tightening_torque")),
        transmissible_torque: quantity_of(cell("transmissible_torque")),
    }
}

#[cfg(test)]
#[path = "parts_tests.rs"]
mod tests;
