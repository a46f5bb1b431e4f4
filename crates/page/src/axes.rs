//! Summary of the axes of a project: the actuator of each, its verdict, and the totals.

use crate::checks::verdict_class;
use crate::markup::vals;
use crate::shown::chosen;
use crate::state::{PageState, ReadProject};
use axis::AxisProject;
use figures::{Drawing, Size, Style};
use maud::{Markup, PreEscaped, html};
use quantities::unit::{KILOGRAM, WATT};
use quantities::{Measure, format_number};
use questions::list::size::sized;
use questions::texts::{demand_figures, percent, reason, standing_text};
use questions::{Candidate, Progress, Refusal, Rejected, course_seen, power_over_cycle, sum_of_known};
use words::{capitalised, page, terms, title_of_check};

/// Width of the picture of the powers \[px\].
const WIDTH: f64 = 1000.0;

/// Row of an axis in the summary.
struct Row {
    class: &'static str,
    code: String,
    standing: String,
    tightest: String,
    utilisation: String,
    figures: Vec<(&'static str, String, &'static str)>,
    mass_kg: Option<f64>,
    taken_w: Option<f64>,
    returned_w: Option<f64>,
}

/// Returns the summary of all axes.
///
/// # Errors
/// When the work was cancelled or ran out of time.
pub(crate) fn summary(state: &PageState, held: &ReadProject, progress: &Progress) -> Result<Markup, Refusal> {
    let l = state.language;
    let mut rows: Vec<(&AxisProject, Option<Row>)> = Vec::new();
    let mut courses = Vec::new();
    for project in &held.projects {
        let sizing = sized(project, 0, Rejected::Nearest, progress)?;
        let found = chosen(project, sizing.named());
        courses.extend(found.as_ref().map(|found| (project.name.as_str(), course_seen(project, found, None))));
        rows.push((project, found.map(|candidate| row(state, project, &candidate))));
    }
    let figures = rows.iter().find_map(|(_, row)| row.as_ref()).map(|row| row.figures.as_slice()).unwrap_or_default();
    let of = |get: fn(&Row) -> Option<f64>| -> Vec<Option<f64>> {
        rows.iter().map(|(_, row)| row.as_ref().and_then(get)).collect()
    };
    let [mass, taken, returned] =
        [of(|row| row.mass_kg), of(|row| row.taken_w), of(|row| row.returned_w)].map(|all| sum_of_known(&all));
    let number = |value: Option<f64>, digits: usize| {
        value.map_or_else(|| "–".to_owned(), |value| format_number(value, digits, l))
    };
    let sum = |(value, known): (f64, usize), digits: usize| {
        html! {
            strong { (number((known > 0).then_some(value), digits)) }
            @if known < rows.len() { br; span.small { (page::sum_of_known(&known, &rows.len(), l)) } }
        }
    };
    Ok(html! {
        section id="together" aria-labelledby="together-title" class=[held.is_old.then_some("old")] {
            h2 id="together-title" { (page::axes_together(l)) }
            (crate::markup::stopped(&html! {}))
            @if held.is_old { p.advice role="status" { (page::result_is_old(l)) } }
            p.small { (page::axes_about(l)) }
            div.wide tabindex="0" role="region" aria-labelledby="together-title" {
                table {
                    thead { tr {
                        @for head in [terms::axis(l), terms::ordering_code(l), terms::verdict(l), terms::check(l)] { th scope="col" { (capitalised(head)) } }
                        th.number scope="col" { (capitalised(terms::utilisation_short(l))) }
                        @for (symbol, _, unit) in figures { th.number scope="col" { (crate::chapters::symbol(symbol)) " / " (unit) } }
                        th.number scope="col" { (capitalised(terms::mass(l))) " / " (KILOGRAM.symbol) }
                        th.number scope="col" { (capitalised(page::power_taken(l))) " / " (WATT.symbol) }
                        th.number scope="col" { (capitalised(page::power_returned(l))) " / " (WATT.symbol) }
                    } }
                    tbody { @for (place, (project, row)) in rows.iter().enumerate() { tr {
                        th scope="row" { button.plain type="button" hx-post="/work" hx-vals=(vals(&[("axis", &place.to_string()), ("code", "")])) { (project.name) } }
                        @if let Some(row) = row {
                            td.code { (row.code) } td class=(row.class) { (row.standing) } td { (row.tightest) } td.number { (row.utilisation) }
                            @for (_, value, _) in &row.figures { td.number { (value) } }
                            td.number { (number(row.mass_kg, 2)) } td.number { (number(row.taken_w, 0)) } td.number { (number(row.returned_w, 0)) }
                        }
                    } } }
                    tfoot { tr {
                        th scope="row" { (capitalised(page::sum(l))) }
                        td colspan=(4 + figures.len()) {}
                        td.number { (sum(mass, 2)) } td.number { (sum(taken, 0)) } td.number { (sum(returned, 0)) }
                    } }
                }
            }
            @if let Some(drawing) = figures::power_of_axes(&courses, l) { (power(&drawing, state)) }
        }
    })
}

/// Returns the picture of the power of each axis.
fn power(drawing: &Drawing, state: &PageState) -> Markup {
    let (width, height) = drawing.size_mm;
    let style = Style::new(Size::pixels(WIDTH, WIDTH * height / width));
    let style = style.theme(state.theme).language(state.language).id("power-of-axes");
    html! {
        figure.plot id="power-of-axes" {
            (PreEscaped(drawing.render(&style).into_svg()))
            figcaption { (drawing.caption) }
        }
    }
}

fn row(state: &PageState, project: &AxisProject, candidate: &Candidate<'_>) -> Row {
    let l = state.language;
    let verdict = candidate.marked_as();
    let tightest = candidate.governing();
    let power = power_over_cycle(project, candidate);
    let figures = candidate.judgement.demand.as_ref().map(|demand| demand_figures(demand, l).to_vec());
    let standing = standing_text(candidate, l);
    Row {
        class: verdict_class(verdict),
        code: candidate.id.to_string(),
        standing: if candidate.fits() { standing } else { format!("{standing}; {}", reason(candidate, l)) },
        tightest: tightest.map(|check| capitalised(&title_of_check(check, l))).unwrap_or_default(),
        utilisation: percent(tightest.and_then(|check| check.utilisation), l),
        figures: figures.unwrap_or_default(),
        mass_kg: candidate.parameters.mass.known().map(|mass| KILOGRAM.from_si(mass.value.si())),
        taken_w: power.map(|power| power.taken_w),
        returned_w: power.map(|power| power.returned_w),
    }
}
