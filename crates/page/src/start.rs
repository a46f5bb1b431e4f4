//! The start page: a mechanism, at most six values, a first answer.

use crate::call::{Call, Shell};
use crate::placed::placed;
use crate::sketch;
use crate::value::{self, stated, taken};
use maud::{Markup, html};
use project::{Edit, Kind, edit, key_at, written};
use quantities::{Dimension, Language, Measure, Unit, format_significant};
use questions::list::new::{example, plain_text};
use questions::list::size::sized;
use questions::{MechanismId, Progress, Rejected, read_all_watched};
use std::sync::LazyLock;
use words::{about_text, capitalised, hyphenated, incoming, key_word, page, short_label, terminal};

/// A way to begin: the plain project of a mechanism, and the keys that define the machine.
pub(crate) struct Begin {
    pub(crate) mechanism: Option<&'static str>,
    /// The plain project with the values of its template.
    text: String,
    /// Rows of the form: the paths of the keys under one label.
    pub(crate) asked: &'static [&'static [&'static str]],
    /// Another way to describe the same mechanism, if there is one.
    other: Option<usize>,
    /// The way has a tile of its own.
    has_tile: bool,
}

/// Largest number of rows to fill in.
#[cfg(test)]
const ASKED_MOST: usize = 6;

const DISTANCE: &[&str] = &["motion[1].distance"];
const TIME: &[&str] = &["motion[1].time"];
const PAUSE: &[&str] = &["motion[2].time"];
const SPEED: &[&str] = &["motion[1].speed"];

/// The keys that define each mechanism in the words of its user, with its motion.
#[rustfmt::skip] // one line per mechanism
const ASKED: &[(MechanismId, &[&[&str]])] = &[
    (MechanismId::Load, &[&["load.inertia"], DISTANCE, TIME, PAUSE]),
    (MechanismId::Turntable, &[&["mechanism.turntable.body[1].diameter"], &["mechanism.turntable.body[1].length"], &["mechanism.turntable.body[1].mass"], DISTANCE, TIME, PAUSE]),
    (MechanismId::Arm, &[&["mechanism.arm.length"], &["mechanism.arm.shape"], &["mechanism.arm.mass"], DISTANCE, TIME, PAUSE]),
    (MechanismId::Screw, &[&["mechanism.screw.lead"], &["mechanism.screw.mass"], &["mechanism.screw.inclination"], DISTANCE, TIME, PAUSE]),
    (MechanismId::Belt, &[&["mechanism.belt.pulley_diameter"], &["mechanism.belt.mass"], DISTANCE, TIME, PAUSE]),
    (MechanismId::Conveyor, &[&["mechanism.conveyor.roller_diameter"], &["mechanism.conveyor.mass"], DISTANCE, TIME, PAUSE]),
    (MechanismId::SliderCrank, &[&["mechanism.slider_crank.crank"], &["mechanism.slider_crank.rod"], &["mechanism.slider_crank.mass"], SPEED]),
    (MechanismId::Hoist, &[&["mechanism.hoist.mass"], &["mechanism.hoist.drum_diameter"], &["mechanism.hoist.falls"], DISTANCE, TIME, PAUSE]),
    (MechanismId::Winder, &[&["mechanism.winder.tension"], &["mechanism.winder.width"], &["mechanism.winder.thickness"], &["mechanism.winder.density"], SPEED, &["mechanism.winder.core_diameter", "mechanism.winder.full_diameter"]]),
    (MechanismId::ScissorLift, &[&["mechanism.scissor_lift.mass"], &["mechanism.scissor_lift.arm_length"], &["mechanism.scissor_lift.arm_angle"], &["mechanism.scissor_lift.lead"], DISTANCE, TIME]),
    (MechanismId::FourBar, &[&["mechanism.four_bar.ground"], &["mechanism.four_bar.crank"], &["mechanism.four_bar.coupler"], &["mechanism.four_bar.rocker"], &["mechanism.four_bar.rocker_inertia"], SPEED]),
];

/// The keys of an arm whose inertia is known, with usual values.
const ARM_BY_INERTIA: &[&[&str]] =
    &[&["mechanism.arm.inertia"], &["mechanism.arm.mass"], &["mechanism.arm.centre_distance"], DISTANCE, TIME, PAUSE];

/// The ways to begin: each mechanism that needs neither a recording nor rows of points; then the ways without a tile.
pub(crate) static BEGINS: LazyLock<Vec<Begin>> = LazyLock::new(|| {
    let mut all: Vec<Begin> = ASKED.iter().filter_map(|(id, asked)| Begin::of(*id, asked)).collect();
    let arm = all.iter().position(|begin| begin.mechanism == Some(MechanismId::Arm.key()));
    if let Some((arm, place)) = arm.zip(Some(all.len()))
        && let Some(by_inertia) = all.get(arm).and_then(|begin| begin.by_inertia(arm))
    {
        all.push(by_inertia);
        if let Some(begin) = all.get_mut(arm) {
            begin.other = Some(place);
        }
    }
    all
});

/// A path of the form, the path that repeats its value, and `true` for the opposite sign.
type Repeated = (&'static str, &'static str, bool);

/// The way back, and the second pause.
const WITH_PAUSES: &[Repeated] = &[
    ("motion[1].distance", "motion[3].distance", true),
    ("motion[1].time", "motion[3].time", false),
    ("motion[2].time", "motion[4].time", false),
];

/// The way back without a pause before it.
const WITHOUT_PAUSES: &[Repeated] =
    &[("motion[1].distance", "motion[2].distance", true), ("motion[1].time", "motion[2].time", false)];

impl Begin {
    fn of(id: MechanismId, asked: &'static [&'static [&'static str]]) -> Option<Self> {
        let plain = plain_text(id)?;
        let kept = plain.lines().filter(|line| !line.starts_with("# "));
        let text = kept.fold(String::new(), |mut text, line| {
            text.push_str(line.split_once(" #").map_or(line, |(stated, _)| stated.trim_end()));
            text.push('\n');
            text
        });
        let text = edit(&text, "axis.name", Edit::Gone).ok()?;
        // A table without keys says nothing.
        let text = edit(&text, "requirements", Edit::Gone).ok()?;
        let mechanism = (id != MechanismId::Load).then(|| id.key());
        Some(Self { mechanism, text, asked, other: None, has_tile: true })
    }

    /// Returns the way to begin with an arm whose inertia is known.
    fn by_inertia(&self, arm: usize) -> Option<Self> {
        let mut text = self.text.clone();
        for path in ["mechanism.arm.shape", "mechanism.arm.length"] {
            text = edit(&text, path, Edit::Gone).ok()?;
        }
        for (path, value) in [("mechanism.arm.inertia", "0.4 kg m^2"), ("mechanism.arm.centre_distance", "250 mm")] {
            text = edit(&text, path, Edit::Value(value)).ok()?;
        }
        Some(Self { text, asked: ARM_BY_INERTIA, other: Some(arm), has_tile: false, mechanism: self.mechanism })
    }

    /// Returns `true` if the travel of its mechanism per turn is constant.
    pub(crate) fn has_travel(&self) -> bool {
        let read = questions::read(&self.text(|_| None, true));
        self.mechanism.is_some() && read.is_ok_and(|project| project.axis.mechanism.travel_m_per_rad().is_some())
    }

    /// Iterates over the paths of the keys to fill in.
    fn paths(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.asked.iter().flat_map(|row| row.iter().copied())
    }

    /// Iterates over the values that its segments repeat.
    fn repeated(&self) -> impl Iterator<Item = Repeated> + '_ {
        let has_pauses = self.paths().any(|path| PAUSE.contains(&path));
        let all = if has_pauses { WITH_PAUSES } else { WITHOUT_PAUSES };
        all.iter().copied().filter(|(_, place, _)| !self.of_template(place).is_empty())
    }

    /// Returns the value of the template at a path.
    fn of_template(&self, path: &str) -> String {
        let stated = written(&self.text).unwrap_or_default();
        stated.into_iter().find(|key| key.path == path).and_then(|key| key.value).unwrap_or_default()
    }

    /// Returns the project file with the typed values. A key without one is not stated, unless `usual` keeps that of the
    /// template.
    pub(crate) fn text(&self, typed: impl Fn(&str) -> Option<String>, usual: bool) -> String {
        let mut text = self.text.clone();
        for path in self.paths() {
            let value = typed(path).filter(|value| !value.trim().is_empty());
            if usual && value.is_none() {
                continue;
            }
            let value = value.unwrap_or_default();
            let repeated = self.repeated().filter(|(of, ..)| *of == path);
            let places = repeated.map(|(_, place, is_back)| (place, is_back));
            for (place, is_back) in std::iter::once((path, false)).chain(places) {
                let value = if is_back { reversed(&value) } else { value.clone() };
                text = edit(&text, place, Edit::Value(&value)).unwrap_or(text);
            }
        }
        text
    }
}

/// Returns a value with the opposite sign.
fn reversed(value: &str) -> String {
    let value = value.trim();
    match value.strip_prefix('-') {
        Some(positive) => positive.trim_start().to_owned(),
        None if value.is_empty() => String::new(),
        None => format!("-{}", value.trim_start_matches('+').trim_start()),
    }
}

/// Returns the title of a mechanism.
pub(crate) fn title(mechanism: Option<&str>, language: Language) -> String {
    let Some(name) = mechanism else { return page::load_at_the_output(language).to_owned() };
    key_at(&format!("mechanism.{name}")).map(|key| capitalised(about_text(key.about, language))).unwrap_or_default()
}

/// Returns the ways to begin, as drawings.
pub(crate) fn tiles(language: Language) -> Markup {
    html! {
        ul.tiles { @for (place, begin) in BEGINS.iter().enumerate().filter(|(_, begin)| begin.has_tile) {
            @let title = title(begin.mechanism, language);
            li { button.tile type="button" data-kind=(begin.mechanism.unwrap_or("load")) hx-get={ "/begin?kind=" (place) "&lang=" (language.id()) } hx-target="#begin" hx-swap="innerHTML" hx-include="unset" {
                span.sketch aria-hidden="true" { (sketch::still(begin.mechanism)) }
                span { (hyphenated(&title)) }
            } }
        }
            li { button.tile type="button" id="tile-recording" data-recording="" title=(incoming::tile_about(language)) {
                span.sketch aria-hidden="true" { (sketch::recording()) }
                span { (hyphenated(incoming::tile(language))) }
            } }
        }
    }
}

/// Returns the mechanisms as drawings that state the load of an axis; `is_line`: those with a constant travel per turn.
pub(crate) fn choices(prefix: &str, is_line: bool, language: Language) -> Markup {
    let all = BEGINS.iter().filter(|begin| begin.has_tile && (!is_line || begin.has_travel()));
    html! {
        ul.tiles { @for begin in all {
            @let change = begin.mechanism.map_or_else(|| format!("table {prefix}load"), |name| format!("instead {prefix}mechanism.{name}"));
            li { button.tile type="button" hx-post="/work" hx-vals=(crate::markup::vals(&[("do", &change)])) {
                span.sketch aria-hidden="true" { (sketch::still(begin.mechanism)) }
                span { (hyphenated(&title(begin.mechanism, language))) }
            } }
        } }
    }
}

/// Returns the ways to begin as drawings that lead to a further axis of the project.
pub(crate) fn further(language: Language) -> Markup {
    let l = language;
    let inside = html! {
        p { (page::new_axis_about(l)) }
        div id="begin" aria-live="polite" {}
        ul.tiles { @for (place, begin) in BEGINS.iter().enumerate().filter(|(_, begin)| begin.has_tile) {
            @let title = title(begin.mechanism, l);
            li { button.tile type="button" id={ "further-" (place) } hx-get={ "/begin?further=&kind=" (place) "&lang=" (l.id()) } hx-target="#begin" hx-swap="innerHTML" hx-include="unset" {
                span.sketch aria-hidden="true" { (sketch::still(begin.mechanism)) }
                span { (hyphenated(&title)) }
            } }
        } }
    };
    crate::markup::drawer(page::new_axis(l), &inside, l)
}

/// Returns the project of a further axis with the typed values, if the request adds one.
pub(crate) fn further_text(call: &Call<'_>) -> Option<String> {
    let place = call.field("further")?.parse::<usize>().ok()?;
    Some(typed(BEGINS.get(place)?, call))
}

/// Returns the few values of a way to begin, next to a drawing that follows them.
pub(crate) fn asked(place: usize, is_further: bool, language: Language) -> Markup {
    let Some(begin) = BEGINS.get(place) else { return html! {} };
    let l = language;
    let adds = |value: &'static str| is_further.then_some(value);
    let further = if is_further { "further=&" } else { "" };
    html! {
        form.begin-form.rows method="get" action="/" aria-labelledby="begin-title" data-shuts=[adds("")]
            hx-post=[adds("/work")] hx-target=[adds("#work")] hx-swap=[adds("outerMorph")] {
            h3 id="begin-title" tabindex="-1" { (title(begin.mechanism, l)) }
            span.sketch id="begin-sketch" { (drawing(begin, &begin.text(|_| None, true), l)) }
            p.small { (page::asked_values(l)) }
            @for row in begin.asked { (asked_row(begin, row, l)) }
            input type="hidden" name=(if is_further { "further" } else { "begin" }) value=(place);
            input type="hidden" name="lang" value=(l.id());
            button.primary type="submit" { @if is_further { (page::new_axis(l)) } @else { (page::first_answer(l)) } }
            @if let Some(other) = begin.other {
                " " button.link type="button" hx-get={ "/begin?" (further) "kind=" (other) "&lang=" (l.id()) } hx-target="#begin" hx-swap="innerHTML" hx-include="unset" {
                    @if begin.has_tile { (page::inertia_is_known(l)) } @else { (page::inertia_from_shape(l)) }
                }
            }
        }
    }
}

/// Name of the field with the unit of a row.
fn unit_name(path: &str) -> String {
    format!("unit.{path}")
}

/// Returns the label of a row.
fn asked_label(begin: &Begin, row: &[&str], language: Language) -> String {
    let Some(path) = row.first() else { return String::new() };
    match *path {
        "mechanism.winder.core_diameter" => return page::core_and_full(language).to_owned(),
        "motion[1].speed" if begin.mechanism == Some(MechanismId::Winder.key()) => {
            return page::line_speed(language).to_owned();
        }
        "motion[1].distance" if begin.mechanism == Some(MechanismId::ScissorLift.key()) => {
            return page::stroke_of_platform(language).to_owned();
        }
        // The body of a turntable is a disc until it is changed.
        "mechanism.turntable.body[1].diameter" => return page::diameter_of_the_disc(language).to_owned(),
        "motion[1].speed" => return page::speed_of_crank(language).to_owned(),
        "motion[1].time" => return page::duration_of(language).to_owned(),
        "motion[2].time" => return page::pause_of(language).to_owned(),
        _ => {}
    }
    key_at(path).map(|key| capitalised(&short_label(about_text(key.about, language)))).unwrap_or_default()
}

/// Returns one row of the form: its fields, then the unit beside them.
fn asked_row(begin: &Begin, row: &[&str], language: Language) -> Markup {
    row_of(begin, row, None, language)
}

/// Returns one row of another form with its stated values, without a drawing that follows it.
pub(crate) fn value_row(begin: &Begin, row: &[&str], stated: &dyn Fn(&str) -> String, language: Language) -> Markup {
    row_of(begin, row, Some(stated), language)
}

fn row_of(begin: &Begin, row: &[&str], stated: Option<&dyn Fn(&str) -> String>, language: Language) -> Markup {
    let l = language;
    let Some((path, key)) = row.first().and_then(|path| Some((*path, key_at(path)?))) else { return html! {} };
    let label = asked_label(begin, row, l);
    let usual = begin.of_template(path);
    let unit = usual.split_once(' ').and_then(|(_, unit)| Unit::of(unit));
    // A quantity may have fewer units than its dimension: the lead of a screw is no number of yards.
    let dimension = match key.kind {
        Kind::Quantity(dimension, _) => Some(dimension),
        _ => unit.map(|unit| unit.dimension),
    };
    let units: Vec<&Unit> = dimension.map(Dimension::units).unwrap_or_default().iter().collect();
    let is_alone = stated.is_some();
    let follows = |trigger: &'static str| (!is_alone).then_some(trigger);
    let drawn = || follows("/begin/drawing");
    let chosen = |path: &str| stated.map(|stated| stated(path)).unwrap_or_default();
    // A value in one of the units shows its number alone.
    let parts = |value: &str| {
        let (number, unit) = value.split_once(' ')?;
        let unit = units.iter().find(|each| each.ascii == unit)?;
        Some((number.to_owned(), unit.ascii))
    };
    let own_unit = parts(&chosen(path)).map(|(_, unit)| unit).or_else(|| unit.map(|unit| unit.ascii));
    let shown = |path: &str| {
        let value = chosen(path);
        let number = parts(&value).filter(|(_, unit)| Some(*unit) == own_unit).map(|(number, _)| number);
        is_alone.then(|| value::with_mark(&number.unwrap_or(value), l))
    };
    html! {
        div.row {
            label for=(crate::markup::id(path)) {
                (label)
                @for symbol in row.iter().filter_map(|path| crate::sketch::symbol_of(path)) { " " i { (crate::chapters::symbol(symbol)) } }
            }
            span.quantity {
                @for (number, path) in row.iter().enumerate() {
                    @let id = crate::markup::id(path);
                    @let own = (number > 0).then(|| capitalised(&short_label(key_at(path).map(|key| about_text(key.about, l)).unwrap_or_default())));
                    @if let Kind::OneOf(words) = key.kind {
                        select id=(id) name=(path) required aria-describedby=[follows_row(is_alone, row)] hx-get=[drawn()] hx-trigger=[follows("change")] hx-target=[follows("#begin-sketch")] hx-swap=[follows("innerHTML")] hx-include=[follows("closest form")] {
                            option value="" { (page::choose(l)) }
                            // A bar has a width too, which is not among the few values.
                            @for word in words.iter().filter(|word| **word != "bar") { option value=(word) { (key_word(key.name, word, l).unwrap_or_else(|| (*word).to_owned().into())) } }
                        }
                    } @else {
                        @if number > 0 { span.unit { "–" } }
                        input id=(id) name=(path) type="text" inputmode="decimal" required placeholder=(page::for_example(&number_of(begin, path, l), l)) aria-label=[own] aria-describedby=[follows_row(is_alone, row)]
                            autocomplete="off" spellcheck="false" value=[shown(path)]
                            hx-get=[drawn()] hx-trigger=[follows("input changed delay:100ms, change")] hx-target=[follows("#begin-sketch")] hx-swap=[follows("innerHTML")] hx-include=[follows("closest form")];
                    }
                }
                @if units.len() > 1 {
                    select name=(unit_name(path)) aria-label=(page::unit_of(&label, l)) title=(page::unit_of(&label, l)) hx-get=[drawn()] hx-trigger=[follows("change")] hx-target=[follows("#begin-sketch")] hx-swap=[follows("innerHTML")] hx-include=[follows("closest form")] {
                        @for each in &units { option value=(each.ascii) selected[Some(each.ascii) == own_unit] { (each.symbol) } }
                    }
                } @else if let Some(only) = unit { span.unit { (only.symbol) } input type="hidden" name=(unit_name(path)) value=(only.ascii); }
            }
            @if !is_alone { div.fault id=(fault_id(row)) role="status" {} }
        }
    }
}

/// Returns the number of the template at a path, with the decimal mark of the language.
fn number_of(begin: &Begin, path: &str, language: Language) -> String {
    let usual = begin.of_template(path);
    value::with_mark(usual.split_once(' ').map_or(usual.as_str(), |(number, _)| number), language)
}

/// Returns the typed value of a key, with the unit of its row.
pub(crate) fn typed_value(begin: &Begin, path: &str, call: &Call<'_>) -> Option<String> {
    let (typed, l) = (call.field(path)?, call.language());
    let row = begin.asked.iter().find(|row| row.contains(&path))?;
    let unit = row.first().and_then(|first| call.field(&unit_name(first))).unwrap_or_default();
    let is_word = key_at(path).is_some_and(|key| matches!(key.kind, Kind::OneOf(_)));
    Some(match (is_word, unit.is_empty()) {
        (true, _) => typed.into_owned(),
        (false, true) => taken(&typed, l),
        (false, false) => stated(&typed, &unit, l),
    })
}

/// Returns the text of a way to begin with the typed values.
pub(crate) fn typed(begin: &Begin, call: &Call<'_>) -> String {
    begin.text(|path| typed_value(begin, path, call), false)
}

/// Returns the drawing of a way to begin with the typed values, and the faults of these values.
pub(crate) fn drawing_of(call: &Call<'_>) -> Markup {
    let Some(begin) = BEGINS.get(call.begin()) else { return html! {} };
    let (l, text) = (call.language(), begin.text(|path| typed_value(begin, path, call), true));
    html! {
        (drawing(begin, &text, l))
        @for (row, fault) in begin.asked.iter().zip(faults(begin, &text, l)) {
            template hx type="partial" hx-target={ "#" (fault_id(row)) } hx-swap="innerHTML" {
                @if let Some(fault) = fault { p { (fault) } }
            }
        }
    }
}

/// Returns the identifier of the place of a row's fault, if the row has one.
fn follows_row(is_alone: bool, row: &[&str]) -> Option<String> {
    (!is_alone).then(|| fault_id(row))
}

/// Returns the identifier of the place of a row's fault.
fn fault_id(row: &[&str]) -> String {
    format!("{}-x", crate::markup::id(row.first().copied().unwrap_or_default()))
}

/// Returns the fault of each row that is filled in.
fn faults(begin: &Begin, text: &str, language: Language) -> Vec<Option<Markup>> {
    let stated = written(text).unwrap_or_default();
    let found = questions::read(text).err().unwrap_or_default();
    let found = placed(&found, (text, &stated), key_at, language);
    let of_row = |row: &&'static [&'static str]| {
        let path = row.iter().find(|path| found.iter().any(|(at, _)| at.as_deref() == Some(**path)))?;
        let (_, fault) = found.iter().find(|(at, _)| at.as_deref() == Some(*path))?;
        Some(crate::sentences::worded(&fault.message, fault.hint.as_deref(), language))
    };
    begin.asked.iter().map(of_row).collect()
}

/// Returns the drawing to the scale of a text; invalid values are left out.
fn drawing(begin: &Begin, text: &str, language: Language) -> Markup {
    let of = begin.mechanism.map_or_else(|| "load".to_owned(), |name| format!("mechanism.{name}"));
    let stated = written(text).unwrap_or_default();
    let figures = stated.iter().filter_map(|key| Some((key.path.as_str(), key.value.as_deref()?)));
    let project = questions::read(text).ok();
    let it = sketch::SketchContent {
        mechanism: begin.mechanism,
        figures: axis::drawn_figures(figures, &of),
        of: &of,
        title: &title(begin.mechanism, language),
        project: project.as_ref(),
    };
    sketch::shown(&it, language)
}

/// Returns the result of an example, for its card.
pub(crate) fn example_verdict(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Markup {
    let l = call.language();
    let kind = call.field("kind").unwrap_or_default();
    let Some(found) = example(&kind, crate::head::USUAL_NAME, l).filter(|found| found.recording.is_none()) else {
        return html! {};
    };
    let Ok(projects) = read_all_watched(&found.text, shell.files(), shell.catalogue(), progress) else {
        return html! {};
    };
    let Some((project, sizing)) =
        projects.first().and_then(|project| Some((project, sized(project, 0, Rejected::None, progress).ok()?)))
    else {
        return html! {};
    };
    let cycle = format_significant(project.axis.motion.duration().si(), 3, l);
    html! {
        @match sizing.answer() {
            Some(best) => span class=(crate::shown::class(best)) { (best.id) },
            None => span.fail { (capitalised(terminal::no_actuator_fits(l))) },
        }
        " " span { (page::cycle_of(&cycle, l)) }
    }
}

/// Returns the mechanism of a project's text.
pub(crate) fn mechanism_of(text: &str) -> Option<String> {
    project::written(text)?
        .iter()
        .find_map(|key| key.path.strip_prefix("mechanism.")?.split('.').next().map(str::to_owned))
}

/// Returns the first line of an example: its description.
pub(crate) fn about<'t>(text: &'t str, kind: &'t str) -> &'t str {
    text.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or(kind)
}

#[cfg(test)]
#[path = "start_tests.rs"]
mod tests;
