//! The torque-speed plane: limits in four quadrants, the cycle, its mean and its peaks.

use crate::drawing::{Chart, Drawing, Figure};
use crate::labels::{amount, listed, percent, subject};
use axis::AxisProject;
use plot::{Area, Dash, Hatch, Item, Label, Line, Markers, Note, PlaneAxis, Reference, Shape, Tone, Width, XyChart};
use quantities::unit::{NEWTON_METRE, REVOLUTION_PER_MINUTE, SECOND, VOLT};
use quantities::{AngularVelocity, Language, Measure, Torque, Unit, format_number, format_significant};
use questions::{Candidate, CheckId, Course, CurveKind, CurvePoint, PerformanceCurve, Plane, ProductId, Sample};
use words::{minutes, pictures, terms};

const SIZE_MM: (f64, f64) = (165.0, 125.0);

/// Speed \[1/min\] and torque \[Nm\].
type Point = (f64, f64);

/// Draws the limits at the voltage of the project's supply, the cycle within them, its mean point and its peaks.
#[must_use]
pub fn torque_speed(project: &AxisProject, candidate: &Candidate<'_>, language: Language) -> Drawing {
    let plane = questions::plane(project, candidate).ok();
    let course = questions::course_seen(project, candidate, None);
    let mut chart = empty(language);
    if let Some(plane) = &plane {
        chart = with_limits(chart, plane, language);
    }
    if !plane.as_ref().is_some_and(has_short_time) {
        chart = with_known(chart, candidate, language);
    }
    chart = chart.with(
        Line::new(course.samples.iter().map(|sample| at(sample.speed_rad_s, sample.torque_nm)))
            .tone(Tone::Trace)
            .label(terms::cycle(language))
            .class("cycle"),
    );
    let mut sentences = vec![say_cycle(&course, language)];
    if let Some(demand) = &candidate.judgement.demand {
        let mean = at(demand.speed_mean.si(), demand.torque_rms.si());
        let peaks = peaks(demand, &course);
        let name = Label::from(format!("{}: ", pictures::mean(language)));
        let name = value_of(name, "n_av", &speed(demand.speed_mean, language)).text(", ");
        let name = value_of(name, "T_rms", &torque(demand.torque_rms, language));
        chart = chart.with(Markers::new([mean]).shape(Shape::Diamond).label(name).class("mean")).with(Note::new(
            mean.0,
            mean.1,
            Label::symbol("T_rms"),
        ));
        let name = Label::from(format!("{}: ", pictures::peaks(language)));
        let name = value_of(name, "T_peak", &torque(demand.torque_peak, language)).text(", ");
        let name = value_of(name, "n_peak", &speed(demand.speed_peak, language));
        let points = peaks.iter().map(|(point, _)| *point);
        chart = chart.with(Markers::new(points).shape(Shape::Circle).hollow().label(name).class("peaks"));
        for (point, label) in peaks {
            chart = chart.with(Note::new(point.0, point.1, label));
        }
        sentences.push(say_demand(demand, language));
    }
    sentences.extend(say_limits(candidate, language));
    let caption = match &plane {
        Some(plane) if has_short_time(plane) => caption(plane, language),
        Some(plane) => {
            let frame = pictures::short_time_limit_known_in_part(language);
            format!("{} {frame}", caption(plane, language))
        }
        None => caption_of_known(candidate, language),
    };
    let (of, texts) = (subject(candidate, &project.name), (caption, sentences.join(" ")));
    Drawing::new(Figure::TorqueSpeed, &of, SIZE_MM, texts, Chart::Xy(chart), language)
}

/// Draws the limits of a code alone.
#[must_use]
pub fn curves(id: &ProductId, plane: &Plane, language: Language) -> Drawing {
    let chart = with_limits(empty(language), plane, language);
    let kinds: Vec<String> = plane
        .curves
        .iter()
        .filter_map(|curve| {
            let points = points_of(&curve.points);
            let (first, end) = (curve.points.first()?, points.last()?);
            Some(pictures::limit_from_to(
                &curve_name(curve, language),
                &torque(first.torque, language),
                &speed(AngularVelocity::new_in(end.0, &REVOLUTION_PER_MINUTE), language),
                language,
            ))
        })
        .collect();
    let description = pictures::limits_described(&id, &listed(&kinds, language), language);
    let texts = (caption(plane, language), description);
    Drawing::new(Figure::TorqueSpeed, &id.to_string(), SIZE_MM, texts, Chart::Xy(chart), language)
}

fn empty(language: Language) -> XyChart {
    XyChart::new(
        PlaneAxis::new("n", REVOLUTION_PER_MINUTE.symbol).name(pictures::output_speed(language)).minor_ticks(),
        PlaneAxis::new("T", NEWTON_METRE.symbol).name(pictures::output_torque(language)).minor_ticks(),
    )
    .four_quadrant()
}

fn at(speed_rad_s: f64, torque_nm: f64) -> Point {
    (REVOLUTION_PER_MINUTE.from_si(speed_rad_s), NEWTON_METRE.from_si(torque_nm))
}

fn torque(torque: Torque, language: Language) -> String {
    amount(torque.si(), &NEWTON_METRE, language)
}

fn speed(speed: AngularVelocity, language: Language) -> String {
    amount(speed.si(), &REVOLUTION_PER_MINUTE, language)
}

fn value_of(label: Label, symbol: &str, value: &str) -> Label {
    label.and_symbol(symbol).text(&format!(" = {value}"))
}

/// Returns the points of a limit up to the speed at which it reaches zero.
fn points_of(points: &[CurvePoint]) -> Vec<Point> {
    let end = points.iter().position(|point| point.torque.si() <= 0.0).map_or(points.len(), |index| index + 1);
    points.iter().take(end).map(|point| at(point.speed.si(), point.torque.si())).collect()
}

/// Returns a limit by magnitude, mirrored into all four quadrants.
fn mirrored(limit: &[Point]) -> Vec<Point> {
    around(limit, limit)
}

/// Returns a limit around all four quadrants: `driving` for motor operation, `braking` for generator operation.
fn around(driving: &[Point], braking: &[Point]) -> Vec<Point> {
    let drive = driving.iter().copied();
    let brake = braking.iter().rev().map(|(n, t)| (*n, -t));
    let back = driving.iter().map(|(n, t)| (-n, -t));
    let brake_back = braking.iter().rev().map(|(n, t)| (-n, *t));
    drive.chain(brake).chain(back).chain(brake_back).collect()
}

/// Returns a limit in the two quadrants of motor operation.
fn driving(limit: &[Point]) -> [Vec<Point>; 2] {
    [limit.to_vec(), limit.iter().map(|(n, t)| (-n, -t)).collect()]
}

fn curve_name(curve: &PerformanceCurve, language: Language) -> String {
    match curve.kind {
        CurveKind::Continuous => pictures::continuous_limit(language).to_owned(),
        CurveKind::S3 { duty, .. } => format!("S3 {} %", format_number(duty.si() * 100.0, 0, language)),
        CurveKind::ShortTime => pictures::short_time_limit(language).to_owned(),
    }
}

fn with_limits(mut chart: XyChart, plane: &Plane, language: Language) -> XyChart {
    let band = |of: &str| pictures::band_of_an_estimate(&of, language);
    let braking = plane.braking.map(|(end, torque)| {
        let (end, torque) = at(end.si(), torque.si());
        [(0.0, torque), (end, torque), (end, 0.0)]
    });
    for curve in &plane.curves {
        let points = points_of(&curve.points);
        // Equal edges leave no band to see, and none to explain.
        let upper = curve.upper.as_deref().map(points_of).filter(|upper| *upper != points);
        let name = curve_name(curve, language);
        let line = |points: Vec<Point>| Line::new(points).label(name.as_str());
        match curve.kind {
            CurveKind::Continuous => {
                if let Some(upper) = upper {
                    let area = Area::between(mirrored(&points), mirrored(&upper)).tone(Tone::Continuous);
                    chart = chart.with(area.hatch(Hatch::Rising).label(band(&name)).class("band"));
                }
                let line = line(mirrored(&points)).closed().tone(Tone::Continuous).width(Width::Strong);
                chart = chart.with(line.class("continuous"));
            }
            CurveKind::S3 { duty, .. } => {
                let dash = if duty.si() < 0.4 { Dash::Dotted } else { Dash::DashDotted };
                let line = line(mirrored(&points)).closed().tone(Tone::Series(3)).dash(dash);
                chart = chart.with(line.class("s3"));
            }
            CurveKind::ShortTime => {
                if let Some(upper) = upper {
                    for (lower, upper) in driving(&points).into_iter().zip(driving(&upper)) {
                        let area = Area::between(lower, upper).tone(Tone::ShortTime).hatch(Hatch::Falling);
                        chart = chart.with(area.label(band(&name)).class("band"));
                    }
                }
                let whole = braking.map_or_else(|| mirrored(&points), |braking| around(&points, &braking));
                let line = Line::new(whole).label(with_voltage(&name, curve, language)).closed().tone(Tone::ShortTime);
                chart = chart.with(line.class("short-time"));
            }
        }
    }
    // Curves of one voltage look alike, those of another do not.
    let mut voltages: Vec<Option<f64>> = Vec::new();
    for curve in &plane.sagged {
        let points = points_of(&curve.points);
        let voltage = curve.voltage.map(|volts| volts.si());
        let place = voltages.iter().position(|known| *known == voltage).unwrap_or_else(|| {
            voltages.push(voltage);
            voltages.len() - 1
        });
        let dash = if place.is_multiple_of(2) { Dash::Dotted } else { Dash::DashDotted };
        for part in driving(&points) {
            let line = Line::new(part).tone(Tone::ShortTime).width(Width::Thin).dash(dash);
            let name = with_voltage(pictures::the_same_at_less_voltage(language), curve, language);
            chart = chart.with(line.label(name).class("short-time-sagged"));
        }
    }
    chart
}

/// Returns the name of a limit with its voltage, for the legend: at the curve it would cover hatching and other limits.
fn with_voltage(name: &str, curve: &PerformanceCurve, language: Language) -> String {
    match curve.voltage {
        Some(volts) => {
            format!("{name} ({} {})", format_number(VOLT.from_si(volts.si()), 0, language), VOLT.symbol)
        }
        None => name.to_owned(),
    }
}

/// Returns the largest torque and the largest speed, each at its instant with its symbol; one point if they coincide.
fn peaks(demand: &questions::Demand, course: &Course) -> Vec<(Point, Label)> {
    let mut found: Vec<(Point, Label)> = Vec::new();
    let torque = |sample: &Sample| sample.torque_nm.abs();
    if let Some(sample) = sample_at(course, demand.torque_peak_at.si(), torque) {
        let peak = demand.torque_peak.si().copysign(sample.torque_nm);
        found.push((at(sample.speed_rad_s, peak), Label::symbol("T_peak")));
    }
    if let Some(sample) = sample_at(course, demand.speed_peak_at.si(), torque) {
        let point = at(demand.speed_peak.si().copysign(sample.speed_rad_s), sample.torque_nm);
        match found.as_mut_slice() {
            [(first, label)] if are_close(*first, point) => *label = label.clone().text(", ").and_symbol("n_peak"),
            _ => found.push((point, Label::symbol("n_peak"))),
        }
    }
    found
}

fn are_close(a: Point, b: Point) -> bool {
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-6 * a.abs().max(b.abs());
    close(a.0, b.0) && close(a.1, b.1)
}

/// Returns the sample at an instant; of several, the one with the largest value of `of`.
fn sample_at(course: &Course, time_s: f64, of: impl Fn(&Sample) -> f64) -> Option<&Sample> {
    let distance = |sample: &Sample| (sample.time_s - time_s).abs();
    let least = course.samples.iter().map(distance).fold(f64::INFINITY, f64::min);
    let same = least + 1e-9 * course.duration_s;
    course.samples.iter().filter(|sample| distance(sample) <= same).max_by(|a, b| of(a).total_cmp(&of(b)))
}

fn say_cycle(course: &Course, language: Language) -> String {
    let duration = amount(course.duration_s, &SECOND, language);
    pictures::plane_described(&duration, language)
}

fn say_demand(demand: &questions::Demand, language: Language) -> String {
    let (peak, fast) = (torque(demand.torque_peak, language), speed(demand.speed_peak, language));
    let (rms, mean) = (torque(demand.torque_rms, language), speed(demand.speed_mean, language));
    let when = amount(demand.torque_peak_at.si(), &SECOND, language);
    pictures::demand_described(&peak, &when, &fast, &rms, &mean, language)
}

fn say_limits(candidate: &Candidate<'_>, language: Language) -> Vec<String> {
    let limit = |id: CheckId| {
        let check = candidate.judgement.checks.iter().find(|check| check.id == id)?;
        check.limit.map(|limit| amount(limit.si, limit.unit, language))
    };
    let mut parts = Vec::new();
    if let Some(limit) = limit(CheckId::ContinuousTorque) {
        parts.push(pictures::continuous_limit_at_mean_speed(&limit, language));
    }
    if let Some(limit) = limit(CheckId::PeakTorque) {
        parts.push(pictures::at_most_for_a_short_time(&limit, language));
    }
    if let Some(limit) = limit(CheckId::PeakSpeed) {
        parts.push(pictures::at_most(&limit, language));
    }
    if parts.is_empty() {
        return Vec::new();
    }
    let head = pictures::limits(language);
    vec![format!("{head}: {}.", listed(&parts, language))]
}

fn has_short_time(plane: &Plane) -> bool {
    plane.curves.iter().any(|curve| curve.kind == CurveKind::ShortTime)
}

/// Returns the known ones of largest torque and largest speed, for an actuator whose curves cannot be drawn.
fn known(candidate: &Candidate<'_>) -> [Option<(f64, &'static str, String)>; 2] {
    // A check that lacks another datum has no limit: the largest torque is then that of the data.
    let of = |id: CheckId, stated: Option<f64>, unit: &'static Unit, symbol: &'static str| {
        let check = candidate.judgement.checks.iter().find(|check| check.id == id);
        let limit = check.and_then(|check| check.limit).map(|limit| limit.si).or(stated).filter(|si| *si > 0.0)?;
        Some((unit.from_si(limit), symbol, id.id().to_owned()))
    };
    let stated = candidate.parameters.torque_max.known().map(|known| known.value.si());
    [
        of(CheckId::PeakTorque, stated, &NEWTON_METRE, "T_max"),
        of(CheckId::PeakSpeed, None, &REVOLUTION_PER_MINUTE, "n_max"),
    ]
}

/// Adds the known limits: a frame if both are known, else a line across the plane.
fn with_known(mut chart: XyChart, candidate: &Candidate<'_>, language: Language) -> XyChart {
    let [torque, speed] = known(candidate);
    let number = |value: f64, unit: &str| format!(" = {} {unit}", format_significant(value, 4, language));
    if let (Some((torque, ..)), Some((speed, ..))) = (&torque, &speed) {
        let frame = [(*speed, *torque), (*speed, -torque), (-speed, -torque), (-speed, *torque)];
        let line = Line::new(frame).closed().tone(Tone::ShortTime);
        let name = pictures::largest_torque_and_speed(language);
        chart = chart.with(line.label(name).class("known-limits"));
    }
    let (both, mut marks) = (torque.is_some() && speed.is_some(), Vec::new());
    let mut mark = |known, unit: &Unit, corner: fn(f64) -> Point, line: fn(f64) -> Reference| {
        let Some((value, symbol, check)): Option<(f64, _, String)> = known else { return };
        let label = Label::symbol(symbol).text(&number(value, unit.symbol_in(language)));
        for (value, label) in [(value, label), (-value, Label::default())] {
            let (x, y) = corner(value);
            if !both {
                let line = line(value).tone(Tone::ShortTime).dash(Dash::Dashed).label(label).data("check", &check);
                marks.push(Item::from(line));
            } else if !label.is_empty() {
                marks.push(Item::from(Note::new(x, y, label).tone(Tone::ShortTime).data("check", &check)));
            }
        }
    };
    mark(torque, &NEWTON_METRE, |torque| (0.0, torque), Reference::horizontal);
    mark(speed, &REVOLUTION_PER_MINUTE, |speed| (speed, 0.0), Reference::vertical);
    chart.with_all(marks)
}

fn caption_of_known(candidate: &Candidate<'_>, language: Language) -> String {
    let parts = match known(candidate) {
        [Some(_), Some(_)] => pictures::only_torque_and_speed_known(language),
        [Some(_), None] => pictures::only_torque_known(language),
        [None, Some(_)] => pictures::only_speed_known(language),
        [None, None] => pictures::no_limit_known(language),
    };
    parts.to_owned()
}

fn caption(plane: &Plane, language: Language) -> String {
    let mut parts = vec![pictures::quadrants_and_colours(language)];
    // The curves state their voltages; the shares are those of the terminal voltage.
    let full = plane.curves.iter().find_map(|curve| curve.voltage);
    let shares: Vec<String> =
        plane.sagged.iter().filter_map(|curve| Some(percent(curve.voltage?.si() / full?.si(), language))).collect();
    let cycle = plane.curves.iter().find_map(|curve| match curve.kind {
        CurveKind::S3 { cycle, .. } => Some(cycle),
        CurveKind::Continuous | CurveKind::ShortTime => None,
    });
    let intermittent = cycle.map(|cycle| pictures::s3_explained(&minutes(cycle, language), language));
    parts.extend(intermittent.as_deref());
    if plane.curves.iter().any(|curve| curve.upper.as_ref().is_some_and(|upper| *upper != curve.points)) {
        parts.push(pictures::hatching_explained(language));
    }
    if plane.braking.is_some() {
        parts.push(pictures::braking_explained(language));
    }
    if plane.curves.iter().all(|curve| curve.voltage.is_none()) {
        parts.push(pictures::no_voltage_limit(language));
    } else {
        parts.push(pictures::volts_explained(language));
    }
    let sagged = (!shares.is_empty()).then(|| pictures::sagged_explained(&listed(&shares, language), language));
    parts.extend(sagged.as_deref());
    parts.join(" ")
}
