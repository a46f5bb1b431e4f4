//! What the page is about at an instant: a project's text, and what of it is looked at.
//!
//! A shell keeps none of it. Every request carries it, and every answer gives it back.

use crate::call::Call;
use crate::form::tolerance_of;
use crate::value::{in_unit, stated, with_point};
use figures::{By, MapPoint, Theme, nearest};
use order_code::OrderCode;
use project::{Diagnostic, Edit, Files, Key, Kind, Project, Written, edit, key_at, stretch, written};
use quantities::Language;
use questions::list::simulate::ScenarioId;
use questions::{CandidateId, Draw, Patience, Refusal, SAMPLES_MOST, Sizing, Unread, read_all_watched, read_code};
use std::borrow::Cow;
use words::{Worded, worded};

/// The state as a request carries it, with what was changed by it.
pub(crate) struct State {
    /// The project's text.
    pub(crate) text: String,
    /// The last text without faults; empty before there was one.
    pub(crate) good: String,
    /// Which axis is shown, from zero.
    pub(crate) axis: usize,
    /// Whether all axes are shown together.
    pub(crate) all_axes: bool,
    /// From when to when the pictures over time show the cycle, in seconds; the whole without it.
    pub(crate) window: Option<(f64, f64)>,
    /// A place in the map of candidates: the actuator that is nearest to it is to be looked at.
    near: Option<MapPoint>,
    /// What stands before the paths of the axis: `axis[2].` where there are several, else nothing.
    pub(crate) prefix: String,
    /// The actuator that is looked at; without one the best.
    pub(crate) code: Option<OrderCode>,
    /// The actuators marked to be compared.
    pub(crate) marked: Vec<OrderCode>,
    pub(crate) language: Language,
    pub(crate) theme: Theme,
    /// The project file in the folder.
    pub(crate) file: String,
    /// The version that was opened, and the name of its file.
    pub(crate) known: String,
    /// What the ranking is narrowed to.
    pub(crate) filter: Filter,
    /// How many samples of the tolerances are judged; as many as some seconds allow without it.
    pub(crate) samples: Option<usize>,
    /// Whether pictures that take long may come after the numbers.
    pub(crate) is_brief: bool,
    /// What the middle pane shows.
    pub(crate) view: View,
    /// What happens in the simulation; what the project states without it.
    pub(crate) scenario: Option<ScenarioId>,
    /// What the right pane shows.
    pub(crate) list: List,
    /// The column by which the ranking is sorted, where it is not the order of the ranking itself.
    pub(crate) sort: Sort,
    /// Whether the actuator that is looked at shows its checks.
    pub(crate) unfolded: bool,
    /// The folds of the form that are open although nothing is stated in them, by their ids.
    pub(crate) folds: Vec<String>,
    /// The path of the field that is typed in, and whether it stands behind a fold: it stays where it is.
    pub(crate) typed_at: Option<(String, bool)>,
    /// Width and height that the pictures of the middle pane may take \[px\].
    pub(crate) room: (f64, f64),
}

/// The tabs of the middle pane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum View {
    #[default]
    Cycle,
    TorqueSpeed,
    Heat,
    Energy,
    Bearing,
    ErrorBudget,
    Simulation,
}

impl View {
    pub(crate) const ALL: [Self; 7] =
        [Self::Cycle, Self::TorqueSpeed, Self::Heat, Self::Energy, Self::Bearing, Self::ErrorBudget, Self::Simulation];

    pub(crate) const fn id(self) -> &'static str {
        match self {
            Self::Cycle => "cycle",
            Self::TorqueSpeed => "torque_speed",
            Self::Heat => "heat",
            Self::Energy => "energy",
            Self::Bearing => "bearing",
            Self::ErrorBudget => "error_budget",
            Self::Simulation => "simulation",
        }
    }
}

/// The tabs of the right pane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum List {
    #[default]
    Ranking,
    Rejected,
    Map,
}

impl List {
    pub(crate) const ALL: [Self; 3] = [Self::Ranking, Self::Rejected, Self::Map];

    pub(crate) const fn id(self) -> &'static str {
        match self {
            Self::Ranking => "ranking",
            Self::Rejected => "rejected",
            Self::Map => "map",
        }
    }
}

/// The columns by which the ranking can be sorted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Sort {
    #[default]
    Rank,
    Utilisation,
    Mass,
    Length,
    Bore,
}

impl Sort {
    pub(crate) const ALL: [Self; 5] = [Self::Rank, Self::Utilisation, Self::Mass, Self::Length, Self::Bore];

    pub(crate) const fn id(self) -> &'static str {
        match self {
            Self::Rank => "rank",
            Self::Utilisation => "utilisation",
            Self::Mass => "mass",
            Self::Length => "length",
            Self::Bore => "bore",
        }
    }
}

/// What an identifier stands for; the usual one where it stands for none.
fn chosen<T: Copy + Default>(all: impl IntoIterator<Item = T>, id: fn(T) -> &'static str, wanted: &str) -> T {
    all.into_iter().find(|each| id(*each) == wanted).unwrap_or_default()
}

/// So many folds of the form are open at most.
const FOLDS_MOST: usize = 200;

/// The size of the pictures before the page has said how large its middle pane is \[px\].
const ROOM: (f64, f64) = (560.0, 470.0);

/// The sides that a picture may have \[px\].
const SIDES: [std::ops::RangeInclusive<f64>; 2] = [280.0..=3000.0, 260.0..=2400.0];

/// The size that the page requests, within what a picture can be.
fn room(width: &str, height: &str) -> (f64, f64) {
    let [wide, high] = SIDES;
    let side = |typed: &str, sides: std::ops::RangeInclusive<f64>, usual: f64| {
        typed
            .parse::<f64>()
            .ok()
            .filter(|side| side.is_finite())
            .map_or(usual, |side| side.clamp(*sides.start(), *sides.end()))
    };
    (side(width, wide, ROOM.0), side(height, high, ROOM.1))
}

/// What the ranking is narrowed to; figures as they were typed.
#[derive(Default)]
pub(crate) struct Filter {
    pub(crate) size: String,
    pub(crate) feedback: String,
    pub(crate) brake: String,
    pub(crate) bore_mm: String,
    pub(crate) length_mm: String,
    pub(crate) mass_kg: String,
    pub(crate) voltage_v: String,
}

/// The project as it could be read.
pub(crate) struct Held {
    /// Its axes; those of the last good text where the text has faults.
    pub(crate) projects: Vec<Project>,
    /// Every fault of the text, with the path that it is shown at.
    pub(crate) faults: Vec<(Option<String>, Worded)>,
    /// Whether the projects are those of an older text.
    pub(crate) is_old: bool,
    /// Every key of the text; of the last good one where it is no TOML.
    pub(crate) written: Vec<Written>,
    /// Whether the text is TOML, so that something in it has a place.
    pub(crate) has_places: bool,
    /// Why the work ended before it was done, or was not begun.
    pub(crate) refused: Option<Refusal>,
}

impl State {
    /// The state that a request carries.
    pub(crate) fn of(call: &Call<'_>) -> Self {
        let field = |name: &str| call.field(name).map(Cow::into_owned).unwrap_or_default();
        let code = |text: &str| read_code(text, call.language()).ok().map(|reading| reading.parsed.code);
        let mut state = Self {
            text: field("text").replace("\r\n", "\n"),
            good: field("good").replace("\r\n", "\n"),
            axis: field("axis").parse().unwrap_or(0),
            all_axes: field("axis") == ALL_AXES,
            window: window(&field("from"), &field("until")),
            near: MapPoint::read(&field("near")),
            prefix: String::new(),
            code: code(&field("code")),
            marked: call.all("mark").filter_map(|text| code(&text)).take(MARKED_MOST).collect(),
            language: call.language(),
            theme: call.theme(),
            file: field("file"),
            known: field("known"),
            filter: Filter {
                size: field("f_size"),
                feedback: field("f_feedback"),
                brake: field("f_brake"),
                bore_mm: field("f_bore"),
                length_mm: field("f_length"),
                mass_kg: field("f_mass"),
                voltage_v: field("f_voltage"),
            },
            is_brief: call.path == "/work",
            view: chosen(View::ALL, View::id, &field("view")),
            scenario: ScenarioId::of(&field("scenario")),
            list: chosen(List::ALL, List::id, &field("list")),
            sort: chosen(Sort::ALL, Sort::id, &field("sort")),
            unfolded: field("unfolded") == "true",
            folds: call.all("fold").map(Cow::into_owned).take(FOLDS_MOST).collect(),
            typed_at: call.field("path").map(|path| (path.into_owned(), call.field("folded").is_some())),
            room: room(&field("width"), &field("height")),
            samples: field("samples").trim().parse().ok().filter(|samples| (1..=SAMPLES_MOST).contains(samples)),
        };
        state.change(call);
        state
    }

    /// How tolerances are sampled.
    pub(crate) fn draw(&self) -> Draw {
        Draw { samples: self.samples, ..Draw::default() }
    }

    /// The actuator that was pointed at in the map, where one was.
    pub(crate) fn choose_nearest(&mut self, sizing: &Sizing<'_>) {
        let found = self.near.and_then(|place| nearest(sizing, By::Mass, place));
        if let Some(CandidateId::Code(code)) = found {
            self.code = Some(*code);
        }
    }

    /// Carries out what the request changes, in its order; what has no place in the text changes nothing.
    fn change(&mut self, call: &Call<'_>) {
        let language = self.language;
        let text = &mut self.text;
        let mut apply = |path: &str, change: Edit<'_>| {
            if let Ok(changed) = edit(text, path, change) {
                *text = changed;
            }
        };
        let asked: Vec<_> = call.all("do").collect();
        for value in asked.iter().flat_map(|value| value.lines()) {
            let (what, path) = value.split_once(' ').unwrap_or((value, ""));
            match what {
                "table" => apply(path, Edit::Table),
                "gone" => apply(path, Edit::Gone),
                "instead" => apply(path, Edit::Instead),
                "down" => apply(path, Edit::Down),
                "twice" => apply(path, Edit::Twice),
                "value" => {
                    let (path, value) = path.split_once('=').unwrap_or((path, ""));
                    apply(path, Edit::Value(value));
                }
                _ => {}
            }
        }
        if let (Some(path), Some(value)) = (call.field("path"), call.field("value")) {
            let value = match call.field("unit") {
                Some(unit) => stated(&value, &unit, language),
                None if key_at(&path).is_some_and(|key| matches!(key.kind, Kind::Number(..))) => {
                    with_point(&value, language)
                }
                None => value.into_owned(),
            };
            // The tolerance has a field of its own.
            let kept = call
                .field("kept")
                .filter(|kept| !kept.is_empty() && !value.is_empty() && tolerance_of(&value).1.is_empty());
            let value = kept.map_or_else(|| value.clone(), |kept| format!("{value} ± {kept}"));
            apply(&path, Edit::Value(&value));
        }
        if let (Some(path), Some(unit), Some(was)) = (call.field("path"), call.field("in_unit"), call.field("was"))
            && !was.is_empty()
        {
            apply(&path, Edit::Value(&in_unit(&was, &unit)));
        }
        if let (Some(path), Some(nominal), Some(band)) = (call.field("path"), call.field("nominal"), call.field("band"))
        {
            let (value, _) = tolerance_of(&nominal);
            let band = band.trim().trim_start_matches('±').trim_start();
            let value = if band.is_empty() { value.to_owned() } else { format!("{value} ± {band}") };
            apply(&path, Edit::Value(&value));
        }
        if let (Some(path), Some(pulled)) = (call.field("path"), call.field("pulled"))
            && let Some(changed) = stretched(&self.text, &path, &pulled)
        {
            self.text = changed;
        }
    }

    /// Reads the project; what cannot be read leaves the last good one.
    pub(crate) fn hold(&mut self, files: &dyn Files, patience: &Patience) -> Held {
        let held = self.read(files, patience);
        self.axis = self.axis.min(held.projects.len().saturating_sub(1));
        if held.written.iter().any(|key| key.path == "axis[1]") {
            self.prefix = format!("axis[{}].", self.axis + 1);
        }
        held
    }

    fn read(&mut self, files: &dyn Files, patience: &Patience) -> Held {
        let keys = written(&self.text);
        let has_places = keys.is_some();
        match read_all_watched(&self.text, files, patience) {
            Ok(projects) => {
                self.good.clone_from(&self.text);
                let written = keys.unwrap_or_default();
                Held { projects, faults: Vec::new(), is_old: false, written, has_places, refused: None }
            }
            Err(Unread::Refused(refusal)) => Held {
                projects: Vec::new(),
                faults: Vec::new(),
                is_old: true,
                written: keys.unwrap_or_default(),
                has_places,
                refused: Some(refusal),
            },
            Err(Unread::Faults(found)) => {
                let keys_there = keys.as_deref().unwrap_or_default();
                let faults = placed(&found, (&self.text, keys_there), project::key_at, self.language);
                let written = keys.or_else(|| written(&self.good)).unwrap_or_default();
                let (projects, refused) = match read_all_watched(&self.good, files, patience) {
                    Ok(projects) => (projects, None),
                    Err(Unread::Refused(refusal)) => (Vec::new(), Some(refusal)),
                    Err(Unread::Faults(_)) => (Vec::new(), None),
                };
                Held { projects, faults, is_old: true, written, has_places, refused }
            }
        }
    }
}

/// The text with a segment that takes another time and goes another way: `pulled` has time and way as they are to be, then as
/// they are in the picture. Where the way is to stay, both are the same.
fn stretched(text: &str, path: &str, pulled: &str) -> Option<String> {
    let mut numbers = pulled.split(' ').map(|number| number.parse::<f64>().ok());
    let mut next = || numbers.next().flatten();
    let (time, way, time_was, way_was) = (next()?, next()?, next()?, next()?);
    let share = |to_be: f64, was: f64| if to_be == was { 1.0 } else { to_be / was };
    stretch(text, path, share(time, time_was), share(way, way_was)).ok()
}

/// What stands for all axes in place of one.
pub(crate) const ALL_AXES: &str = "all";

/// A window of time, where both of its ends are one.
fn window(from: &str, until: &str) -> Option<(f64, f64)> {
    let (from, until): (f64, f64) = (from.parse().ok()?, until.parse().ok()?);
    (from.is_finite() && until.is_finite() && from >= 0.0 && from < until).then_some((from, until))
}

/// The most actuators that stand side by side.
pub(crate) const MARKED_MOST: usize = 5;

/// Every fault with the path that it belongs to: the one that it names, else that of the smallest value around it, else that
/// of the key that it stands at. What the file does not have belongs to the table around it.
pub(crate) fn placed(
    faults: &[Diagnostic],
    (text, written): (&str, &[Written]),
    key_at: fn(&str) -> Option<&'static Key>,
    language: Language,
) -> Vec<(Option<String>, Worded)> {
    use project::Fault;
    let path = |fault: &Diagnostic| -> Option<String> {
        if let Fault::MissingKey { path, .. } = &fault.fault {
            return Some(path.clone());
        }
        let around = |key: &&Written| {
            key.span.start < fault.span.end.max(fault.span.start + 1) && fault.span.start < key.span.end
        };
        let inside = written.iter().filter(around).min_by_key(|key| key.span.len());
        // A key stands on the line of its value, before it.
        let between = |key: &Written| text.get(fault.span.end..key.span.start);
        let on_line = |key: &&Written| key.value.is_some() && between(key).is_some_and(|text| !text.contains('\n'));
        let found = inside.or_else(|| written.iter().filter(on_line).min_by_key(|key| key.span.start));
        let found = found.map(|key| known(&key.path, key_at));
        if !matches!(fault.fault, Fault::NoMechanism) {
            return found;
        }
        // Nothing stands there yet: it belongs where it would stand, in its axis.
        let axis = found.filter(|path| path.starts_with("axis["));
        let axis = axis.and_then(|path| Some(path.split_once(']')?.0.to_owned()));
        Some(axis.map_or_else(|| String::from("mechanism"), |axis| format!("{axis}].mechanism")))
    };
    worded(faults, language).into_iter().zip(faults).map(|(worded, fault)| (path(fault), worded)).collect()
}

/// The path, or that of the nearest table around it that a file has.
fn known(path: &str, key_at: fn(&str) -> Option<&'static Key>) -> String {
    let mut path = path;
    while key_at(path).is_none()
        && let Some((above, _)) = path.rsplit_once('.')
    {
        path = above;
    }
    path.to_owned()
}
