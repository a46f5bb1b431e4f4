//! Keys of which one cannot exceed another: rated and largest, continuous and peak, lowest and highest values.

use crate::assumption::Assumption;
use crate::fault::AxisReport;
use actuator::CurvePoint;
use project::Fault;
use project::sections::{ActuatorValues, Fields, Parts};
use quantities::Measure;

/// Keys of a section of which the value of the first is at most that of the second.
type KeyOrder = (&'static str, &'static str);

const REQUIREMENTS: [KeyOrder; 1] = [("humidity_min", "humidity_max")];

const DRIVE: [KeyOrder; 1] = [("current_continuous", "current_peak")];

/// Both values of a pair are limits of one part: a permitted current that demagnetises the motor, or one that does not
/// overcome the friction of the unit, describes no actuator.
const ACTUATOR: [KeyOrder; 5] = [
    ("current_max", "current_demagnetisation"),
    ("no_load_starting_current", "current_max"),
    ("gear_speed_mean_max", "gear_speed_max"),
    ("torque_1", "torque_2"),
    ("ambient_min", "ambient_max"),
];

/// Pairs of an own actuator whose order is usual but no law, with the remark on the other order: T_0, I_0 and n_N are limits
/// of the motor by its heat, T_max, I_max and n_mot,max those of the unit, which the gear sets too. With a motor that is
/// large for its gear, the former may exceed the latter; every check compares with its own limit, and the lower one decides.
const UNUSUAL: [(KeyOrder, Assumption); 3] = [
    (("stall_torque", "torque_max"), Assumption::OwnStallTorqueAboveLargest),
    (("stall_current", "current_max"), Assumption::OwnStallCurrentAboveLargest),
    (("speed_motor_rated", "speed_motor_max"), Assumption::OwnRatedSpeedAboveLargest),
];

const MEASURED: [KeyOrder; 2] = [("gear_torque_1", "gear_torque_2"), ("chopper_off", "chopper_on")];

/// Returns the remarks on pairs of the own actuator in an unusual order.
pub(crate) fn unusual(parts: &Parts) -> impl Iterator<Item = Assumption> + '_ {
    let own = parts.actuator.get();
    UNUSUAL.iter().filter_map(move |((lower, upper), remark)| {
        let [low, high] = [lower, upper].map(|name| own?.field(name)?.si());
        (low? > high?).then_some(*remark)
    })
}

/// Reports the pairs of an axis that are stated in the wrong order, at the key of the lower value.
pub(crate) fn check(parts: &Parts, report: &mut AxisReport<'_>) {
    let mut of = |section: Option<&dyn Fields>, orders: &[KeyOrder]| {
        if let Some(section) = section {
            check_orders(section, orders, report);
        }
    };
    of(parts.requirements.get().map(|section| section as _), &REQUIREMENTS);
    of(parts.drive.get().map(|section| section as _), &DRIVE);
    of(parts.actuator.get().map(|section| section as _), &ACTUATOR);
    let measured = parts.twin.get().and_then(|twin| twin.measured.get());
    of(measured.map(|section| section as _), &MEASURED);
}

/// Reports the pairs of an actuator that are stated in the wrong order.
pub(crate) fn check_actuator(values: &ActuatorValues, report: &mut AxisReport<'_>) {
    check_orders(values, &ACTUATOR, report);
}

fn check_orders(section: &dyn Fields, orders: &[KeyOrder], report: &mut AxisReport<'_>) {
    let fields = section.fields();
    let field = |name: &str| fields.iter().find(|field| field.name() == name);
    for (lower, upper) in orders {
        let [Some(low), Some(high)] = [lower, upper].map(|name| field(name)) else { continue };
        if let (Some(least), Some(most)) = (low.si(), high.si())
            && least > most
        {
            report.fault(low.span(), Fault::WrongOrder { lower: low.name(), upper: high.name() }, None);
        }
    }
}

/// Returns `true` if a continuous limit is above a short-time one at a speed that both have, by more than rounding.
///
/// Between the corner points both are straight, so that the corners of both decide.
pub(crate) fn is_above(continuous: &actuator::Curve, short_time: &actuator::Curve) -> bool {
    let last = |curve: &actuator::Curve| curve.points().last().map_or(0.0, |point| point.speed.si());
    let common = last(continuous).min(last(short_time));
    let corners = continuous.points().iter().chain(short_time.points());
    let speeds = corners.map(|CurvePoint { speed, .. }| *speed).filter(|speed| speed.si() <= common);
    speeds.into_iter().any(|speed| {
        let [low, high] = [continuous, short_time].map(|curve| curve.at_most_to_its_end(speed).si());
        low > high * (1.0 + 1e-9)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fault::AxisFault;
    use crate::{AxisProject, NoCatalogue};
    use project::{KEYS, Key, Kind};

    /// Sections with their orders, keys that they need, and units of the values.
    const SECTIONS: [(&str, &[KeyOrder], &str); 4] = [
        ("requirements", &REQUIREMENTS, ""),
        ("drive", &DRIVE, ""),
        ("actuator", &ACTUATOR, "name = \"own\"\n"),
        ("twin.measured", &MEASURED, ""),
    ];

    fn faults(section: &str, lines: &str) -> Vec<(AxisFault, String)> {
        let text = format!(
            "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n[{section}]\n{lines}"
        );
        let read = AxisProject::read(&text, &NoCatalogue::shared(), &|_, _| None).err().unwrap_or_default();
        read.into_iter().map(|each| (each.fault, text.get(each.span).unwrap_or_default().to_owned())).collect()
    }

    #[test]
    fn a_value_above_its_largest_is_refused_at_its_key() {
        for (section, orders, head) in SECTIONS {
            for (lower, upper) in orders {
                let unit = if lower.contains("current") {
                    " A"
                } else if lower.contains("torque") {
                    " N m"
                } else if lower.contains("speed") {
                    " 1/min"
                } else if lower.contains("ambient") {
                    " degC"
                } else {
                    ""
                };
                let text = |value: f64| if unit.is_empty() { value.to_string() } else { format!("\"{value}{unit}\"") };
                // Shares and thresholds have a range of their own.
                let base = if lower.contains("humidity") { 0.25 } else { 1.25 };
                for (low, high, is_wrong) in
                    [(1.0, 1.0, false), (1.0, 1.2, false), (1.2, 1.0, true), (1.0001, 1.0, true)]
                {
                    let lines = format!("{head}{lower} = {}\n{upper} = {}\n", text(base * low), text(base * high));
                    let expected = is_wrong.then(|| (Fault::WrongOrder { lower, upper }.into(), text(base * low)));
                    assert_eq!(faults(section, &lines), Vec::from_iter(expected), "{lines}");
                    // One of them alone has no order.
                    assert_eq!(faults(section, &format!("{head}{lower} = {}\n", text(base * low))), []);
                }
            }
        }
    }

    #[test]
    fn a_continuous_curve_above_the_short_time_one_is_refused() {
        for (continuous, short_time, is_wrong) in [
            ([(0.0, 10.0), (40.0, 6.0)], [(0.0, 20.0), (40.0, 12.0)], false),
            ([(0.0, 10.0), (40.0, 6.0)], [(0.0, 10.0), (40.0, 6.0)], false),
            ([(0.0, 10.0), (60.0, 6.0)], [(0.0, 20.0), (40.0, 12.0)], false),
            ([(0.0, 21.0), (40.0, 6.0)], [(0.0, 20.0), (40.0, 12.0)], true),
            ([(0.0, 10.0), (40.0, 6.0)], [(0.0, 20.0), (40.0, 5.0)], true),
            ([(0.0, 10.0), (60.0, 9.0)], [(0.0, 20.0), (40.0, 5.0)], true),
        ] {
            let of = |points: [(f64, f64); 2]| {
                points.map(|(speed, torque)| format!("[\"{speed} 1/min\", \"{torque} N m\"]")).join(", ")
            };
            let lines = format!(
                "name = \"own\"\ncontinuous_curve = [{}]\nshort_time_curve = [{}]\n",
                of(continuous),
                of(short_time)
            );
            let found: Vec<AxisFault> = faults("actuator", &lines).into_iter().map(|(fault, _)| fault).collect();
            let expected = Fault::WrongOrder { lower: "continuous_curve", upper: "short_time_curve" }.into();
            assert_eq!(found, Vec::from_iter(is_wrong.then_some(expected)), "{lines}");
        }
    }

    /// A motor that is large for its gear: the unusual order is accepted and named, the usual one has no remark.
    #[test]
    fn a_limit_of_the_motor_above_that_of_the_unit_is_remarked_on() {
        for ((lower, upper), remark) in UNUSUAL {
            let unit = match lower {
                "stall_torque" => "N m",
                "stall_current" => "A",
                _ => "1/min",
            };
            for (low, high) in [(1.0, 1.0), (30.0, 31.0), (31.0, 30.0), (30.01, 30.0)] {
                let text = format!(
                    "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n[actuator]\n\
                     name = \"own\"\n{lower} = \"{low} {unit}\"\n{upper} = \"{high} {unit}\"\n"
                );
                let project = AxisProject::read(&text, &NoCatalogue::shared(), &|_, _| None).unwrap();
                assert_eq!(project.assumptions.contains(&remark), low > high, "{text}");
            }
        }
    }

    /// Two keys of one section whose names end as those of a lower and an upper value have an order here.
    #[test]
    fn keys_with_an_order_by_their_names_have_one() {
        const ENDS: [(&str, &str); 7] = [
            ("_min", "_max"),
            ("_rated", "_max"),
            ("_continuous", "_peak"),
            ("_continuous", "_max"),
            ("_rated", "_peak"),
            ("_off", "_on"),
            ("_low", "_high"),
        ];
        let mut listed: Vec<KeyOrder> = SECTIONS.iter().flat_map(|(_, orders, _)| orders.iter().copied()).collect();
        listed.extend(UNUSUAL.iter().map(|(order, _)| *order));
        fn walk(keys: &[Key], found: &mut Vec<(&'static str, &'static str)>) {
            for low in keys {
                for (lower, upper) in ENDS {
                    let Some(stem) = low.name.strip_suffix(lower) else { continue };
                    let high = keys.iter().find(|key| key.name == format!("{stem}{upper}"));
                    found.extend(high.map(|high| (low.name, high.name)));
                }
                match low.kind {
                    Kind::Table(inner) => walk(inner, found),
                    Kind::OneOrMany(one, several) => [one, several].into_iter().for_each(|inner| walk(inner, found)),
                    Kind::Variants(of) => walk(of.keys, found),
                    _ => {}
                }
            }
        }
        let mut found = Vec::new();
        walk(KEYS, &mut found);
        assert!(found.len() >= 4, "{found:?}");
        let missing: Vec<_> = found.into_iter().filter(|order| !listed.contains(order)).collect();
        assert!(missing.is_empty(), "{missing:?}");
    }
}
