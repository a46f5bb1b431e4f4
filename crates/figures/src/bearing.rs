//! Loads on the output bearing over the cycle.

use crate::cycle::{inside, segments, time_axis};
use crate::drawing::{Chart, Drawing, Figure};
use crate::fault::NoFigure;
use crate::labels::{amount, listed, percent, subject};
use crate::utilisation::sign;
use axis::AxisProject;
use plot::{Bar, BarChart, Dash, Label, Line, Panel, PlaneAxis, Reference, StackedChart, Tone};
use quantities::unit::{NEWTON, NEWTON_METRE};
use quantities::{Language, Measure, Unit};
use questions::list::bearing::bearing_checks;
use questions::{Amount, Candidate, Check, CheckId, Direction, FlangeSample};
use words::{capitalised, pictures};

type Load = fn(&FlangeSample) -> Option<f64>;

/// Draws radial force, axial force and tilting moment on the output bearing over the cycle, or between two instants
/// \[s\] of it.
///
/// # Errors
/// [`NoFigure::NoFlangeLoads`], [`NoFigure::FlangeLoadsOpen`]
pub fn bearing_load(
    project: &AxisProject,
    candidate: &Candidate<'_>,
    window: Option<(f64, f64)>,
    language: Language,
) -> Result<Drawing, NoFigure> {
    let window = window.and_then(|window| inside(window, project));
    let course = questions::flange_course(project, candidate).ok_or_else(|| {
        let missing = bearing_checks(candidate).find_map(|check| check.missing);
        missing.map_or(NoFigure::NoFlangeLoads, NoFigure::FlangeLoadsOpen)
    })?;
    let kinds: [(PlaneAxis, &'static Unit, CheckId, &'static str, Load, &'static str); 3] = [
        (
            PlaneAxis::new("F_r", NEWTON.symbol).name(pictures::radial_force(language)),
            &NEWTON,
            CheckId::BearingRadial,
            "F_R,dyn(max)",
            |load| Some(load.radial.si()),
            pictures::the_radial_force(language),
        ),
        (
            PlaneAxis::new("F_a", NEWTON.symbol).name(pictures::axial_force(language)),
            &NEWTON,
            CheckId::BearingAxial,
            "F_A,dyn(max)",
            |load| Some(load.axial.si()),
            pictures::the_axial_force(language),
        ),
        (
            PlaneAxis::new("M", NEWTON_METRE.symbol).name(pictures::tilting_moment(language)),
            &NEWTON_METRE,
            CheckId::BearingTiltingMoment,
            "M_dyn(max)",
            |load| Some(load.moment?.si()),
            pictures::the_tilting_moment(language),
        ),
    ];
    let loads: Vec<Found<'_>> = kinds
        .into_iter()
        .filter_map(|(axis, unit, id, symbol, of, name)| {
            let values: Vec<(f64, f64)> = course.iter().filter_map(|load| Some((load.time.si(), of(load)?))).collect();
            let least = values.iter().map(|(_, value)| *value).fold(f64::INFINITY, f64::min);
            let largest = values.iter().map(|(_, value)| *value).fold(f64::NEG_INFINITY, f64::max);
            let check = candidate.judgement.checks.iter().find(|check| check.id == id)?;
            let at_rest = candidate.judgement.checks.iter().find(|check| check.id == CheckId::BearingStaticMoment);
            let at_rest = at_rest.filter(|_| id == CheckId::BearingTiltingMoment).and_then(|check| check.limit);
            (!values.is_empty()).then_some(Found { axis, unit, check, symbol, name, values, least, largest, at_rest })
        })
        .collect();
    let sentence: Vec<String> = loads.iter().map(|load| load.sentence(language)).collect();
    let description = format!("{}.", capitalised(&listed(&sentence, language)));
    let of = subject(candidate, &project.name);
    let about = pictures::bearing_load_caption(language);
    if loads.iter().all(Found::is_constant) {
        let constant = pictures::each_load_is_constant(language);
        let axis = PlaneAxis::new("", "%").name(pictures::utilisation_of_the_limit(language));
        let chart = loads.iter().fold(BarChart::new(axis), |chart, load| chart.bar(load.bar(language)));
        let texts = (format!("{constant} {about}"), description);
        return Ok(Drawing::new(Figure::BearingLoad, &of, (165.0, 55.0), texts, Chart::Bars(chart), language));
    }
    let mut chart = StackedChart::new(time_axis(window, language));
    for (from, to, name) in segments(project, language) {
        chart = chart.segment(from, to, name);
    }
    for load in loads {
        chart = chart.panel(load.panel(language));
    }
    let texts = (about.to_owned(), description);
    Ok(Drawing::new(Figure::BearingLoad, &of, (165.0, 115.0), texts, Chart::Stacked(chart), language))
}

/// One load over the cycle, with its check.
struct Found<'a> {
    axis: PlaneAxis,
    unit: &'static Unit,
    check: &'a Check,
    symbol: &'static str,
    name: &'static str,
    /// Instant and value in SI.
    values: Vec<(f64, f64)>,
    least: f64,
    largest: f64,
    /// Limit of the gear at rest.
    at_rest: Option<Amount>,
}

impl Found<'_> {
    fn is_constant(&self) -> bool {
        self.largest - self.least <= 1e-9 * self.largest.abs().max(self.least.abs())
    }

    fn limit(&self, language: Language) -> Option<String> {
        self.check.limit.map(|limit| amount(limit.si, limit.unit, language))
    }

    /// Returns the largest load while the gear turns, to which the limit applies.
    fn turning(&self) -> f64 {
        self.check.value.map_or(self.largest, |value| value.si)
    }

    /// Returns `true` if the load is larger at rest than while the gear turns.
    fn rests_heavier(&self) -> bool {
        !Direction::AtMost.keeps(self.largest, self.turning())
    }

    fn sentence(&self, language: Language) -> String {
        let (name, shown) = (self.name, amount(self.turning(), self.unit, language));
        let value = match self.limit(language) {
            Some(limit) => pictures::value_of_limit(&shown, &limit, language),
            None => shown,
        };
        if self.rests_heavier() {
            pictures::load_rests(&name, &amount(self.largest, self.unit, language), &value, language)
        } else if self.is_constant() {
            pictures::load_is_constant(&name, &value, language)
        } else {
            pictures::load_reaches(&name, &value, language)
        }
    }

    /// Returns the load against its limit as a bar, for a load that is constant.
    fn bar(&self, language: Language) -> Bar {
        let name = self.axis.quantity();
        let (value, limit) = (amount(self.turning(), self.unit, language), self.limit(language));
        let numbers = limit.map_or_else(|| value.clone(), |limit| format!("{value} / {limit}"));
        let bar = Bar::new(name, sign(self.check.verdict)).data("check", self.check.id.id());
        match self.check.utilisation {
            Some(share) => bar.percent(share * 100.0).text(format!("{} · {numbers}", percent(share, language))),
            None => bar.text(numbers),
        }
    }

    fn panel(self, language: Language) -> Panel {
        let rests_heavier = self.rests_heavier();
        let (shown, limit) = (amount(self.largest, self.unit, language), self.limit(language));
        let label =
            if self.is_constant() { pictures::constant(&shown, language) } else { pictures::at_most(&shown, language) };
        let points = self.values.iter().map(|(time, value)| (*time, self.unit.from_si(*value)));
        let line = Line::new(points).tone(Tone::Trace).label(label);
        let mut panel = Panel::new(self.axis);
        if let (Some(limit), Some(text)) = (self.check.limit, limit) {
            panel = panel.with(
                Reference::horizontal(limit.value())
                    .tone(Tone::Continuous)
                    .dash(Dash::Dashed)
                    .label(Label::symbol(self.symbol).text(&format!(" = {text}"))),
            );
        }
        if let Some(limit) = self.at_rest.filter(|_| rests_heavier) {
            let text = amount(limit.si, limit.unit, language);
            let label = Label::symbol("M_0(max)").text(&format!(" = {text}"));
            panel =
                panel.with(Reference::horizontal(limit.value()).tone(Tone::Continuous).dash(Dash::Dashed).label(label));
        }
        panel.with(line)
    }
}
