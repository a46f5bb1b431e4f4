//! The state of the page: a project's text, and the selected views of it.
//!
//! A shell stores none of it. Every request carries it, and every answer returns it.

use crate::by_path::ByPath;
use crate::call::{Call, Shell};
use crate::markup::tolerance_of;
use crate::pasted::{Cell, pasted};
use crate::placed::placed;
use crate::value::{in_unit, stated, taken};
use axis::AxisProject;
use figures::{By, MapPoint, Theme, nearest};
use project::{Edit, Kind, Written, edit, key_at, stretch, with_axis, written};
use quantities::Language;
use questions::list::simulate::ScenarioId;
use questions::{
    Draw, OpenCycle, ProductId, Progress, Refusal, SAMPLES_MOST, Sizing, Unread, closed, is_open_cycle,
    read_all_watched, read_product,
};
use std::borrow::Cow;
use words::{Worded, page};

/// State as a request carries it, with the changes of that request.
pub(crate) struct PageState {
    /// Text of the project.
    pub(crate) text: String,
    /// Last text without faults; empty before the first one.
    pub(crate) good: String,
    /// Index of the shown axis, from zero.
    pub(crate) axis: usize,
    /// Shows the summary of all axes.
    pub(crate) all_axes: bool,
    /// Time window of the pictures over time \[s\]; `None` for the whole cycle.
    pub(crate) window: Option<(f64, f64)>,
    /// Range of each panel in the kept run of the simulation, which the picture of the next run contains.
    pub(crate) kept_ranges: Vec<(f64, f64)>,
    /// Part of the motion that is simulated, as typed: its beginning and its duration; `None` for the whole.
    pub(crate) part: Option<[String; 2]>,
    /// Point in the map of candidates; the nearest actuator is to be selected.
    near: Option<MapPoint>,
    /// Prefix of the paths of the axis: `axis[2].` if the project has several axes, else empty.
    pub(crate) prefix: String,
    /// The selected actuator; `None` for the best one.
    pub(crate) code: Option<ProductId>,
    /// Actuators marked for the comparison.
    pub(crate) marked: Vec<ProductId>,
    pub(crate) language: Language,
    pub(crate) theme: Theme,
    /// Name of the project file in the folder.
    pub(crate) file: String,
    /// Version that was opened, and the name of its file.
    pub(crate) known: String,
    /// Filter of the ranking.
    pub(crate) filter: Filter,
    /// Number of judged samples of the tolerances; `None` for as many as fit into a few seconds.
    pub(crate) samples: Option<usize>,
    /// Allows pictures that take long to follow after the numbers.
    pub(crate) is_brief: bool,
    /// View in the middle pane.
    pub(crate) view: View,
    /// Scenario of the simulation; `None` for that of the project.
    pub(crate) scenario: Option<ScenarioId>,
    /// List in the right pane.
    pub(crate) list: List,
    /// Column by which the ranking is sorted; by default its own order.
    pub(crate) sort: Sort,
    /// Shows the checks of the selected actuator.
    pub(crate) unfolded: bool,
    /// Identifiers of the open folds in which nothing is stated.
    pub(crate) folds: Vec<String>,
    /// Path of the field that has the focus, and whether it is in a fold; it stays at its place.
    pub(crate) typed_at: Option<(String, bool)>,
    /// Way to begin whose values are shown on the start page, by its place.
    pub(crate) begin: usize,
    /// Largest width and height of the pictures in the middle pane \[px\].
    pub(crate) room: (f64, f64),
    /// Motion of which the request changes something.
    moved: Option<Moved>,
}

/// Change of a motion.
struct Moved {
    /// `axis[2].` in a file with several axes, else empty.
    prefix: String,
    /// Index of the edited segment, from zero; `None` if any segment may follow.
    segment: Option<usize>,
}

impl Moved {
    /// Returns the change of a path within a segment.
    fn of(path: &str) -> Option<Self> {
        let (prefix, rest) = path.split_at(path.find("motion[").filter(|at| *at == 0 || path.starts_with("axis["))?);
        let number: usize = rest.strip_prefix("motion[")?.split_once(']')?.0.parse().ok()?;
        Some(Self { prefix: prefix.to_owned(), segment: Some(number.checked_sub(1)?) })
    }
}

/// Tabs of the middle pane.
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
    DataSheet,
    Wiring,
    Mounting,
    Commissioning,
    Encoder,
    Maintenance,
}

impl View {
    pub(crate) const ALL: [Self; 13] = [
        Self::Cycle,
        Self::TorqueSpeed,
        Self::Heat,
        Self::Energy,
        Self::Bearing,
        Self::ErrorBudget,
        Self::Simulation,
        Self::DataSheet,
        Self::Wiring,
        Self::Mounting,
        Self::Commissioning,
        Self::Encoder,
        Self::Maintenance,
    ];

    /// Returns the tool that a view about the actuator shows.
    pub(crate) const fn tool(self) -> Option<&'static str> {
        match self {
            Self::DataSheet => Some("data"),
            Self::Wiring => Some("wiring"),
            Self::Mounting => Some("mount"),
            Self::Commissioning => Some("commission"),
            Self::Encoder => Some("encoder"),
            Self::Maintenance => Some("upkeep"),
            Self::Cycle
            | Self::TorqueSpeed
            | Self::Heat
            | Self::Energy
            | Self::Bearing
            | Self::ErrorBudget
            | Self::Simulation => None,
        }
    }

    pub(crate) const fn id(self) -> &'static str {
        match self {
            Self::Cycle => "cycle",
            Self::TorqueSpeed => "torque_speed",
            Self::Heat => "heat",
            Self::Energy => "energy",
            Self::Bearing => "bearing",
            Self::ErrorBudget => "error_budget",
            Self::Simulation => "simulation",
            Self::DataSheet => "data_sheet",
            Self::Wiring => "wiring",
            Self::Mounting => "mounting",
            Self::Commissioning => "commissioning",
            Self::Encoder => "encoder",
            Self::Maintenance => "maintenance",
        }
    }
}

/// Tabs of the right pane.
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

/// Columns by which the ranking can be sorted.
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

/// Returns the value of an identifier; the default for an unknown one.
fn chosen<T: Copy + Default>(all: impl IntoIterator<Item = T>, id: fn(T) -> &'static str, wanted: &str) -> T {
    all.into_iter().find(|each| id(*each) == wanted).unwrap_or_default()
}

/// Largest number of open folds.
const FOLDS_MOST: usize = 200;

/// Size of the pictures before the page has reported that of its middle pane \[px\].
const ROOM: (f64, f64) = (560.0, 470.0);

/// Permissible width and height of a picture \[px\].
const SIDES: [std::ops::RangeInclusive<f64>; 2] = [280.0..=3000.0, 260.0..=2400.0];

/// Returns the size that the page requests, limited to that of a picture.
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

/// Filter of the ranking; figures as typed.
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

/// The project as far as it could be read.
pub(crate) struct ReadProject {
    /// Axes; those of the last good text if the text has faults.
    pub(crate) projects: Vec<AxisProject>,
    /// Faults of the text, each with the path at which it is shown.
    pub(crate) faults: ByPath<(Option<String>, Worded)>,
    /// The axes are those of an older text.
    pub(crate) is_old: bool,
    /// Keys of the text; of the last good one if the text is no TOML.
    pub(crate) written: ByPath<Written>,
    /// The text is TOML, so that its values have positions.
    pub(crate) has_places: bool,
    /// Reason why the work was stopped or not begun.
    pub(crate) refused: Option<Refusal>,
    /// Path of the motion that does not come back to its position, and `true` if a way back can follow.
    pub(crate) open_cycle: Option<(String, bool)>,
}

/// Returns the identity of a product: an ordering code, else the name of a product of a catalogue file; `None` for an empty
/// text.
pub(crate) fn product_id(text: &str, language: Language) -> Option<ProductId> {
    read_product(text, |_| true, language).ok()
}

impl PageState {
    /// Reads the state of a request.
    pub(crate) fn of(call: &Call<'_>) -> Self {
        let field = |name: &str| call.field(name).map(Cow::into_owned).unwrap_or_default();
        let number = |name: &str| taken(&field(name), call.language());
        let code = |text: &str| product_id(text, call.language());
        let mut state = Self {
            text: field("text").replace("\r\n", "\n"),
            good: field("good").replace("\r\n", "\n"),
            axis: field("axis").parse().unwrap_or(0),
            all_axes: field("axis") == ALL_AXES,
            window: window(&field("from"), &field("until")),
            kept_ranges: ranges(&field("run_ranges")),
            part: (field("run_part") == "true").then(|| [field("run_from"), field("run_for")]),
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
                bore_mm: number("f_bore"),
                length_mm: number("f_length"),
                mass_kg: number("f_mass"),
                voltage_v: number("f_voltage"),
            },
            is_brief: call.path == "/work",
            view: chosen(View::ALL, View::id, &field("view")),
            scenario: ScenarioId::of(&field("scenario")),
            list: chosen(List::ALL, List::id, &field("list")),
            sort: chosen(Sort::ALL, Sort::id, &field("sort")),
            unfolded: field("unfolded") == "true",
            folds: call.all("fold").map(Cow::into_owned).take(FOLDS_MOST).collect(),
            typed_at: call.field("path").map(|path| (path.into_owned(), call.field("folded").is_some())),
            begin: call.begin(),
            room: room(&field("width"), &field("height")),
            samples: number("samples").trim().parse().ok().filter(|samples| (1..=SAMPLES_MOST).contains(samples)),
            moved: None,
        };
        // The changes of an example are made to its text ([`Self::take`]).
        if call.field("new").is_none() {
            state.change(call);
        }
        state
    }

    /// Returns the sampling of the tolerances.
    pub(crate) fn draw(&self) -> Draw {
        Draw { samples: self.samples, ..Draw::default() }
    }

    /// Replaces an empty text by that of an example, with the changes of the request.
    pub(crate) fn take(&mut self, example: String, call: &Call<'_>) {
        self.text = example;
        self.change(call);
    }

    /// Selects the actuator nearest to the point in the map, if one was pointed at.
    pub(crate) fn choose_nearest(&mut self, sizing: &Sizing<'_>) {
        let found = self.near.and_then(|place| nearest(sizing, By::Mass, place));
        if let Some(id) = found {
            self.code = Some(id.clone());
        }
    }

    /// Carries out the changes of the request in their order; a change without a place in the text is ignored.
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
                "close" => self.moved = Some(Moved { prefix: path.to_owned(), segment: None }),
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
                None if key_at(&path).is_some_and(|key| matches!(key.kind, Kind::Number(..) | Kind::Integer(..))) => {
                    taken(&value, language)
                }
                None => value.into_owned(),
            };
            // The tolerance has its own field.
            let kept = call
                .field("kept")
                .filter(|kept| !kept.is_empty() && !value.is_empty() && tolerance_of(&value).1.is_empty());
            let value = kept.map_or_else(|| value.clone(), |kept| format!("{value} ± {kept}"));
            apply(&path, Edit::Value(&value));
            self.moved = Moved::of(&path);
        }
        if let (Some(path), Some(unit), Some(was)) = (call.field("path"), call.field("in_unit"), call.field("was"))
            && !was.is_empty()
        {
            apply(&path, Edit::Value(&in_unit(&was, &unit)));
        }
        if let (Some(path), Some(nominal), Some(band)) = (call.field("path"), call.field("nominal"), call.field("band"))
        {
            let (value, _) = tolerance_of(&nominal);
            let band = taken(band.trim().trim_start_matches('±').trim_start(), language);
            let value = if band.is_empty() { value.to_owned() } else { format!("{value} ± {band}") };
            apply(&path, Edit::Value(&value));
        }
        if let Some(changed) = crate::text_change::scaled(call, &self.text) {
            self.text = changed;
        }
        if let (Some(rows), Some(into)) = (call.field("rows"), call.field("into"))
            && let Some(changed) = pasted_into(&self.text, &into, &rows, language)
        {
            self.text = changed;
        }
        if let (Some(path), Some(pulled)) = (call.field("path"), call.field("pulled"))
            && let Some(changed) = stretched(&self.text, &path, &pulled)
        {
            self.text = changed;
            self.moved = Moved::of(&path);
        }
    }

    /// Adds an axis behind those of the project, from the text of a project with one, and shows it.
    pub(crate) fn add_axis(&mut self, further: &str) {
        let keys = written(&self.text).unwrap_or_default();
        let names: Vec<&str> = keys
            .iter()
            .filter(|key| key.path.ends_with(".name") && key.path.starts_with("axis"))
            .filter_map(|key| key.value.as_deref())
            .collect();
        let count = keys.iter().filter(|key| {
            key.value.is_none() && key.path.starts_with("axis[") && key.path.ends_with(']') && !key.path.contains('.')
        });
        let first = page::axis_number(&1, self.language);
        let mut free = (count.count().max(1) + 1..).map(|number| page::axis_number(&number, self.language));
        let Some(name) = free.find(|name| *name != first && !names.contains(&name.as_str())) else { return };
        if let Ok(changed) = with_axis(&self.text, &first, further, &name) {
            self.text = changed;
            self.all_axes = false;
            // Reading limits it to the last one.
            self.axis = usize::MAX;
            self.code = None;
            self.window = None;
        }
    }

    /// Reads the project; a text with faults leaves the last good one.
    pub(crate) fn hold(&mut self, shell: &dyn Shell, progress: &Progress) -> ReadProject {
        let before = self.good.clone();
        let mut held = self.read(shell, progress);
        if let Some((path, can_close)) = &mut held.open_cycle {
            let prefix = path.split("motion").next().unwrap_or_default();
            let follows = |edited: Option<usize>| {
                let (files, catalogue, text) = (shell.files(), shell.catalogue(), self.text.as_str());
                let open = OpenCycle { text, before: &before, prefix, edited, files, catalogue };
                closed(&open, progress)
            };
            let moved = self.moved.as_ref().filter(|moved| moved.prefix == prefix);
            match moved.and_then(|moved| follows(moved.segment)) {
                Some(text) => {
                    self.text = text;
                    held = self.read(shell, progress);
                }
                None => *can_close = follows(None).is_some(),
            }
        }
        self.axis = self.axis.min(held.projects.len().saturating_sub(1));
        if held.written.at("axis[1]").next().is_some() {
            self.prefix = format!("axis[{}].", self.axis + 1);
        }
        held
    }

    /// Reads the text as it is.
    fn read(&mut self, shell: &dyn Shell, progress: &Progress) -> ReadProject {
        let keys = written(&self.text);
        let has_places = keys.is_some();
        let stopped = |keys: Option<Vec<Written>>| ReadProject {
            projects: Vec::new(),
            faults: Vec::new().into(),
            is_old: true,
            written: keys.unwrap_or_default().into(),
            has_places,
            refused: Some(Refusal::Stopped),
            open_cycle: None,
        };
        // A text of some megabytes takes a while.
        if progress.is_over() {
            return stopped(keys);
        }
        match read_all_watched(&self.text, shell.files(), shell.catalogue(), progress) {
            Ok(projects) => {
                self.good.clone_from(&self.text);
                let written = keys.unwrap_or_default().into();
                ReadProject {
                    projects,
                    faults: Vec::new().into(),
                    is_old: false,
                    written,
                    has_places,
                    refused: None,
                    open_cycle: None,
                }
            }
            Err(Unread::Refused(refusal)) => ReadProject { refused: Some(refusal), ..stopped(keys) },
            Err(Unread::Faults(_)) if progress.is_over() => stopped(keys),
            Err(Unread::Faults(found)) => {
                let keys_there = keys.as_deref().unwrap_or_default();
                let faults = placed(&found, (&self.text, keys_there), project::key_at, self.language);
                let is_open = found.iter().position(is_open_cycle);
                let open_cycle = is_open.and_then(|at| Some((faults.get(at)?.0.clone()?, false)));
                let written = keys.or_else(|| written(&self.good)).unwrap_or_default().into();
                let (projects, refused) = match read_all_watched(&self.good, shell.files(), shell.catalogue(), progress)
                {
                    Ok(projects) => (projects, None),
                    Err(Unread::Refused(refusal)) => (Vec::new(), Some(refusal)),
                    Err(Unread::Faults(_)) => (Vec::new(), None),
                };
                ReadProject { projects, faults: faults.into(), is_old: true, written, has_places, refused, open_cycle }
            }
        }
    }
}

/// Returns the text with another time and distance of a segment: `pulled` has the new time and distance, then those of
/// the picture. If the distance stays, its two values are equal.
fn stretched(text: &str, path: &str, pulled: &str) -> Option<String> {
    let mut numbers = pulled.split(' ').map(|number| number.parse::<f64>().ok());
    let mut next = || numbers.next().flatten();
    let (time, way, time_was, way_was) = (next()?, next()?, next()?, next()?);
    let share = |to_be: f64, was: f64| if to_be == was { 1.0 } else { to_be / was };
    stretch(text, path, share(time, time_was), share(way, way_was)).ok()
}

/// Returns the text with pasted rows; `into`: path of the list, row and column of the cell.
fn pasted_into(text: &str, into: &str, rows: &str, language: Language) -> Option<String> {
    let mut parts = into.split(' ');
    let (list, row, column) = (parts.next()?, parts.next()?.parse().ok()?, parts.next()?.parse().ok()?);
    pasted(text, &Cell { list, row, column }, rows, language)
}

/// Value of `axis` that selects the summary of all axes.
pub(crate) const ALL_AXES: &str = "all";

/// Returns a time window if both of its ends are numbers.
fn window(from: &str, until: &str) -> Option<(f64, f64)> {
    let (from, until): (f64, f64) = (from.parse().ok()?, until.parse().ok()?);
    (from.is_finite() && until.is_finite() && from >= 0.0 && from < until).then_some((from, until))
}

/// Returns the ranges of a list such as `0 12.5,-3 4`.
fn ranges(text: &str) -> Vec<(f64, f64)> {
    let range = |text: &str| {
        let (from, to) = text.split_once(' ')?;
        Some((from.parse().ok()?, to.parse().ok()?))
    };
    text.split(',').map_while(range).take(RANGES_MOST).collect()
}

/// Largest number of panels with a kept range.
const RANGES_MOST: usize = 16;

/// Largest number of compared actuators.
pub(crate) const MARKED_MOST: usize = 5;
