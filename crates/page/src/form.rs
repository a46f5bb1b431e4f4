//! The left column: the motion and the load. Every row is a key of the project file, from the description that the
//! reader uses.

use crate::call::Shell;
use crate::markup::{id, kept, tolerance_of, vals};
use crate::parts::part;
use crate::state::{PageState, ReadProject};
use crate::{laws, recorded, segment_line, sketch, value};
use axis::{AxisProject, Files, drawn_figures};
use maud::{Markup, html};
use project::{Key, Kind, SegmentLaw, Variants, key_at};
use quantities::{Dimension, Language, format_significant};
use questions::texts::recording_text;
use questions::{Candidate, ColumnRole, moves};
use words::{about_text, capitalised, key_word, page, short_label, table_of_project, terms};

/// Data for drawing a row.
pub(crate) struct RowContent<'f> {
    pub(crate) held: &'f ReadProject,
    pub(crate) language: Language,
    /// `axis[2].` if the project has several axes, else empty.
    prefix: &'f str,
    /// Computed values of each segment.
    solved: Vec<Followed>,
    pub(crate) files: &'f dyn Files,
    /// The axis as it was last read; source of the distance of its motion.
    project: Option<&'f AxisProject>,
    /// Keys that checks lack, each with the number of these checks.
    needed: Vec<(&'static str, usize)>,
    /// Open folds in which nothing is stated.
    folds: &'f [String],
    /// Path of the field that has the focus, and whether it is in a fold.
    typed_at: Option<(&'f str, bool)>,
}

/// Number of bytes of the longest symbol with which a label begins.
const SYMBOL_MOST: usize = 8;

/// Computed values of a segment of the motion.
#[derive(Default)]
pub(crate) struct Followed {
    /// Distance, speed, acceleration and time, by key.
    values: Vec<(&'static str, String)>,
    /// Summary of its recording.
    pub(crate) recording: Option<String>,
    /// Roles of its columns, with their headings and units.
    pub(crate) columns: Vec<(ColumnRole, String, &'static str)>,
}

impl Followed {
    /// Returns the computed value of a key.
    pub(crate) fn value(&self, name: &str) -> Option<&str> {
        self.values.iter().find(|(of, _)| *of == name).map(|(_, value)| value.as_str())
    }
}

/// Returns the column.
pub(crate) fn column(
    state: &PageState,
    held: &ReadProject,
    candidate: Option<&Candidate<'_>>,
    shell: &dyn Shell,
) -> Markup {
    let (language, prefix, solved) = (state.language, state.prefix.as_str(), solved(state, held));
    let form = RowContent {
        held,
        language,
        prefix,
        solved,
        files: shell.files(),
        project: held.projects.get(state.axis),
        needed: candidate.map(Candidate::keys_to_state).unwrap_or_default(),
        folds: &state.folds,
        typed_at: state.typed_at.as_ref().map(|(path, folded)| (path.as_str(), *folded)),
    };
    let l = state.language;
    let fields = html! {
        fieldset id="fields" disabled[!held.has_places] {
            (form.name())
            (form.mechanism())
            @for name in ["motion", "stage", "bearing", "requirements", "drive", "twin", "curve", "actuator"] { (form.root(name)) }
        }
    };
    // While the text has a fault, the strip stays that of the last result, so that the fields keep their place.
    let strip = held.projects.get(state.axis);
    let strip =
        html! { @if let Some(project) = strip { (crate::assumed::assumptions(project, &held.written, prefix, l)) } };
    html! {
        section.pane id="moves" aria-labelledby="moves-title" {
            h2.unseen id="moves-title" { (page::what_moves(l)) }
            div.views role="tablist" aria-label=(page::what_moves(l)) {
                @for (name, title) in [("form", page::what_moves(l)), ("text", page::text_of_the_file(l))] {
                    button type="button" role="tab" id={ "left-" (name) } data-left=(name) aria-controls={ "left-pane-" (name) } { (title) }
                }
            }
            div id="left-pane-form" role="tabpanel" aria-labelledby="left-form" { (strip) (fields) }
            div id="left-pane-text" role="tabpanel" aria-labelledby="left-text" { (text(state)) }
        }
    }
}

/// Returns the editor of the text of the project file.
fn text(state: &PageState) -> Markup {
    let l = state.language;
    html! {
        label.small for="text" { (page::text_about(l)) }
        textarea id="text" name="text" form="state" rows="24" spellcheck="false" hx-post="/work" hx-trigger="input changed delay:200ms, change" { (kept(&state.text)) }
    }
}

/// Subject of a key of a mechanism.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Group {
    Geometry,
    Masses,
    Forces,
}

impl Group {
    /// Returns the group of a key by its dimension; a key without one, e.g. an efficiency, belongs to forces and
    /// losses.
    fn of(key: &Key) -> Self {
        match value::dimensions(key).first() {
            Some(Dimension::Length | Dimension::Lead | Dimension::Angle) => Self::Geometry,
            Some(Dimension::Mass | Dimension::MomentOfInertia | Dimension::MassDensity) => Self::Masses,
            None if matches!(key.kind, Kind::Bodies) => Self::Masses,
            None if matches!(key.kind, Kind::OneOf(_) | Kind::Integer(..)) => Self::Geometry,
            _ => Self::Forces,
        }
    }
}

/// Returns the computed values of each segment of the motion.
fn solved(state: &PageState, held: &ReadProject) -> Vec<Followed> {
    let Some(project) = held.projects.get(state.axis) else { return Vec::new() };
    if held.is_old {
        return Vec::new();
    }
    let found = moves(project);
    let shown = |value: f64| format_significant(value, 4, state.language);
    let [distance, speed, acceleration] = found.units;
    let of_move = |each: &questions::Move<'_>| {
        let seconds = quantities::Measure::si(each.duration);
        let mut values = vec![("time", format!("{} s", shown(seconds)))];
        if let Some([d, v, a]) = each.course {
            values.push(("distance", format!("{} {}", shown(distance.from_si(d)), distance.symbol)));
            values.push(("speed", format!("{} {}", shown(speed.from_si(v)), speed.symbol)));
            values.push(("acceleration", format!("{} {}", shown(acceleration.from_si(a)), acceleration.symbol)));
        }
        let read = each.recording.iter().flat_map(|read| &read.recording.columns);
        let columns = read.map(|column| (column.role, column.name.clone(), column.unit.symbol)).collect();
        Followed { values, recording: each.recording.map(|read| recording_text(read, state.language)), columns }
    };
    found.moves.iter().map(of_move).collect()
}

/// Number of entries of a list that are shown or folded together: a page with thousands would be too large for a browser.
const GROUP: usize = 100;

/// Trigger of a field: sent after each key press, unless another follows at once.
pub(crate) const AT_ONCE: &str = "input changed delay:15ms, change";

impl RowContent<'_> {
    pub(crate) fn value(&self, path: &str) -> Option<&str> {
        self.held.written.at(path).next()?.value.as_deref()
    }

    /// Returns `true` if the row of a path is above the fold: a value is stated at it or below it. The field with the
    /// focus stays at its place, when it is emptied as well as when it gets its first value in a fold.
    fn is_first(&self, path: &str) -> bool {
        let within =
            |typed: &str| typed.strip_prefix(path).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
        match self.typed_at.filter(|(typed, _)| within(typed)) {
            Some((typed, folded)) if typed == path => !folded,
            Some(_) => true,
            None => self.held.written.is_there(path),
        }
    }

    /// Returns the number of entries of a list.
    fn count(&self, path: &str) -> usize {
        (1..).take_while(|place| self.held.written.is_there(&format!("{path}[{place}]"))).count()
    }

    fn name(&self) -> Markup {
        let Some(Kind::OneOrMany(one, _)) = key_at("axis").map(|key| key.kind) else { return html! {} };
        let path = if self.prefix.is_empty() { "axis" } else { self.prefix.trim_end_matches('.') };
        html! { div.rows { @for key in one { (self.row(key, &format!("{path}.{}", key.name), None)) } } }
    }

    /// Returns the mechanism: its kind, its drawing, its rows.
    fn mechanism(&self) -> Markup {
        let l = self.language;
        let keys = |name: &str| match key_at(name).map(|key| key.kind) {
            Some(Kind::Table(keys)) => keys,
            _ => &[],
        };
        let path = format!("{}mechanism", self.prefix);
        let kinds = keys("mechanism");
        let chosen = kinds.iter().find(|kind| self.held.written.is_there(&format!("{path}.{}", kind.name)));
        let load = format!("{}load", self.prefix);
        let take = |name: &str| format!("instead {path}.{name}\ngone {load}");
        let (title, of, rows) = match chosen {
            Some(kind) => match kind.kind {
                Kind::Table(rows) => (about_text(kind.about, l), format!("{path}.{}", kind.name), rows),
                _ => ("", String::new(), keys("")),
            },
            None => (page::load_at_the_output(l), load.clone(), keys("load")),
        };
        html! {
            fieldset id="mechanism" {
                legend { (page::mechanism(l)) }
                div.row {
                    label.unseen for="kind" { (page::what_it_is(l)) }
                    select id="kind" name="do" data-chosen=(chosen.map_or_else(|| format!("gone {path}"), |kind| take(kind.name))) hx-post="/work" hx-trigger="change" {
                        option value=(format!("gone {path}")) selected[chosen.is_none()] { (page::load_at_the_output(l)) }
                        @for kind in kinds {
                            option value=(take(kind.name)) selected[chosen.is_some_and(|chosen| chosen.name == kind.name)] {
                                (capitalised(about_text(kind.about, l)))
                            }
                        }
                    }
                }
                (self.load_faults(&path, &load, chosen.map(|kind| format!("{path}.{}", kind.name)).as_deref()))
                (part(html! { figure.sketch id="sketch" { (sketch::shown(&sketch::SketchContent {
                    mechanism: chosen.map(|kind| kind.name),
                    figures: drawn_figures(self.held.written.iter().filter_map(|key| Some((key.path.as_str(), key.value.as_deref()?))), &of),
                    of: &of,
                    title,
                    project: self.project,
                }, l)) } }))
                (self.rows(rows, &of))
            }
        }
    }

    /// Returns a table or list of the root.
    fn root(&self, name: &str) -> Markup {
        let Some(key) = key_at(name) else { return html! {} };
        part(self.table(key, &format!("{}{name}", self.prefix)))
    }

    fn table(&self, key: &Key, path: &str) -> Markup {
        let l = self.language;
        let title = capitalised(table_of_project(key.name, l).unwrap_or_else(|| about_text(key.about, l)));
        match key.kind {
            Kind::Table(keys) => self.fold(&format!("{}-t", id(path)), &title, self.is_first(path), "", || {
                html! {
                    (self.fault_at(path))
                    (self.rows(keys, path))
                }
            }),
            Kind::Variants(variants) => self.list(key, variants, path, &title),
            _ => html! {},
        }
    }

    /// Returns a fold; its content is sent when it is opened, because most of a form is never viewed.
    pub(crate) fn fold(
        &self,
        id: &str,
        title: &str,
        is_open: bool,
        class: &str,
        inside: impl Fn() -> Markup,
    ) -> Markup {
        let is_shown = is_open || self.folds.iter().any(|open| open == id);
        html! {
            details id=(id) class=[(!class.is_empty()).then_some(class)] open[is_open] {
                @if is_shown { summary { (title) } (inside()) }
                @else { summary hx-post="/work" hx-vals=(vals(&[("fold", id)])) { (title) } }
            }
        }
    }

    /// Returns the rows of a table: required and stated keys first, the others in a fold.
    fn rows(&self, keys: &[Key], path: &str) -> Markup {
        let has_fault = |path: &str| self.held.faults.at(path).next().is_some();
        let first = |key: &&Key| {
            let path = format!("{path}.{}", key.name);
            key.required || self.is_first(&path) || has_fault(&path)
        };
        let (shown, folded): (Vec<&Key>, Vec<&Key>) = keys.iter().partition(first);
        // A short table needs no fold.
        let all = folded.len() <= 4;
        html! {
            (self.grouped(keys.iter().filter(|key| all || first(key)).collect(), path))
            @if !all && !folded.is_empty() {
                (self.fold(&format!("{}-m", id(path)), &page::further(folded.len(), self.language), shown.is_empty(), "more", || self.grouped(folded.clone(), path)))
            }
        }
    }

    /// Returns rows; those of a mechanism under the headings geometry, masses, forces and losses.
    fn grouped(&self, keys: Vec<&Key>, path: &str) -> Markup {
        let l = self.language;
        let of_load =
            path.strip_prefix(self.prefix).is_some_and(|path| path.starts_with("mechanism.") || path == "load");
        let groups = [
            (Group::Geometry, page::group_geometry(l)),
            (Group::Masses, page::group_masses(l)),
            (Group::Forces, page::group_forces(l)),
        ];
        let of = |group: Group| keys.iter().filter(move |key| Group::of(key) == group);
        let row = |key: &Key| self.any(key, &format!("{path}.{}", key.name), None);
        html! {
            @if of_load && groups.iter().filter(|(group, _)| of(*group).next().is_some()).count() > 1 {
                @for (group, title) in groups {
                    @if of(group).next().is_some() { div.group { h4 { (title) } div.rows { @for key in of(group) { (row(key)) } } } }
                }
            } @else { div.rows { @for key in &keys { (row(key)) } } }
        }
    }

    fn any(&self, key: &Key, path: &str, placeholder: Option<&str>) -> Markup {
        match key.kind {
            Kind::Table(_) | Kind::Variants(_) => self.table(key, path),
            _ => self.row(key, path, placeholder),
        }
    }

    /// Returns the entries of a list, each of one of several kinds.
    fn list(&self, key: &Key, variants: &Variants, path: &str, title: &str) -> Markup {
        let l = self.language;
        let count = self.count(path);
        let is_motion = key.name == "motion";
        let fresh = variants.kinds.first().map_or("", |(name, ..)| *name);
        let fresh = if is_motion { "trapezoid" } else { fresh };
        let add = format!("{path}[{}]", count + 1);
        let kind = format!("value {add}.{}={fresh}", variants.by);
        html! {
            details id={ (id(path)) "-t" } open[count > 0 || key.required || is_motion] {
                summary { @if is_motion { (capitalised(terms::motion(l))) } @else { (title) } }
                (self.fault_at(path))
                @if is_motion && count > 0 { (segment_line::heads(l)) }
                @for first in (1..=count).step_by(GROUP) { (self.group(variants, path, first, count)) }
                @if count == 0 { ol.entries {} }
                button type="button" id={ (id(path)) "-add" }
                    hx-post="/work" hx-vals=(do_all(&[&format!("table {add}"), &kind])) {
                    @if is_motion { (page::add_segment(l)) } @else { (page::add_entry(l)) }
                }
                @if is_motion {
                    " " button type="button" id={ (id(path)) "-recording" } data-recording=(add) data-count=(count) { (page::add_recording(l)) }
                    p.small { (page::recording_about(l)) }
                }
            }
        }
    }

    /// Returns a group of entries. Groups between the first and the last are folded, apart from that in which the user types
    /// and the first one with a fault.
    fn group(&self, variants: &Variants, path: &str, first: usize, count: usize) -> Markup {
        let last = (first + GROUP - 1).min(count);
        let entries = || {
            html! { ol.entries { @for place in first..=last {
                (part(self.entry(variants, &format!("{path}[{place}]"), place, count)))
            } } }
        };
        let place = |at: &str| at.strip_prefix(path)?.strip_prefix('[')?.split_once(']')?.0.parse::<usize>().ok();
        let is_ours = |at: Option<usize>| at.is_some_and(|at| (first..=last).contains(&at));
        let is_wrong = || is_ours(self.held.faults.listed(path).filter_map(|fault| place(fault.0.as_deref()?)).min());
        if first == 1 || last == count {
            return entries();
        }
        let is_open = is_ours(self.typed_at.and_then(|(typed, _)| place(typed))) || is_wrong();
        self.fold(
            &format!("{}-g{first}", id(path)),
            &page::segments(&first, &last, self.language),
            is_open,
            "",
            entries,
        )
    }

    fn entry(&self, variants: &Variants, path: &str, place: usize, count: usize) -> Markup {
        let l = self.language;
        let kind = self.value(&format!("{path}.{}", variants.by)).unwrap_or_default();
        let (needed, may): (&[&str], &[&str]) =
            variants.kinds.iter().find(|(name, ..)| *name == kind).map_or((&[], &[]), |(_, needed, may)| (needed, may));
        let key = |name: &str| variants.keys.iter().find(|key| key.name == name);
        let of_motion = path.strip_prefix(self.prefix).is_some_and(|path| path.starts_with("motion["));
        let solved = self.solved.get(place - 1).filter(|_| of_motion);
        let ghost = |name: &str| solved?.value(name);
        let own = [variants.by].into_iter().chain(needed.iter().copied()).chain(may.iter().copied());
        let shared: Vec<&Key> = variants.shared.iter().filter_map(|name| key(name)).collect();
        let stated = |key: &&Key| self.is_first(&format!("{path}.{}", key.name));
        // Keys that do not belong to the kind stay visible, with their fault.
        let stray: Vec<&Key> = variants
            .keys
            .iter()
            .filter(|key| stated(key))
            .filter(|key| key.name != variants.by && !needed.contains(&key.name) && !may.contains(&key.name))
            .filter(|key| !variants.shared.contains(&key.name))
            .collect();
        let name = page::segment(&place, l);
        let in_line: &[&str] = if of_motion { &segment_line::CELLS } else { &[] };
        let is_in_line = |name: &str| in_line.contains(&name) || of_motion && name == variants.by;
        // Of a segment, a key without a value that another one may take the place of is folded.
        let is_folded = |name: &str| of_motion && may.contains(&name) && !self.is_first(&format!("{path}.{name}"));
        let own: Vec<&str> = own.filter(|name| !recorded::KEYS.contains(name) && !is_in_line(name)).collect();
        html! {
            li.entry id={ (id(path)) "-e" } aria-label=(name) {
                @if of_motion {
                    (self.segment_line(variants, path, place, (needed, may), solved))
                }
                div.rows {
                    @for name in own.iter().filter(|name| !is_folded(name)) {
                        @if let Some(key) = key(name) { (self.any(key, &format!("{path}.{name}"), ghost(name))) }
                    }
                    @for key in stray.iter().filter(|key| !is_in_line(key.name)) { (self.any(key, &format!("{path}.{}", key.name), None)) }
                    @for key in shared.iter().filter(|key| stated(key)) { (self.any(key, &format!("{path}.{}", key.name), None)) }
                }
                (self.fault_at(path))
                @if kind == "recorded" { (recorded::columns(self, path, solved)) }
                @let folded: Vec<&&Key> = shared.iter().filter(|key| !stated(key)).collect();
                @let others: Vec<&str> = own.iter().copied().filter(|name| is_folded(name)).collect();
                @let bands = of_motion.then(|| self.bands_of_line(path)).flatten();
                div.entry-foot {
                    @if of_motion && !kind.is_empty() { (self.law_pictures(path, kind)) }
                    @if !folded.is_empty() || !others.is_empty() {
                        (self.fold(&format!("{}-m", id(path)), &page::further(folded.len() + others.len(), l), false, "more", || html! {
                            div.rows {
                                @for name in &others { @if let Some(key) = key(name) { (self.any(key, &format!("{path}.{name}"), ghost(name))) } }
                                @if let Some(bands) = &bands { (bands) }
                                @for key in &folded { (self.any(key, &format!("{path}.{}", key.name), None)) }
                            }
                        }))
                    }
                    (self.entry_tools(path, &name, place, count))
                }
            }
        }
    }

    /// Returns the faults of the load as a whole, and those of a second load.
    fn load_faults(&self, mechanism: &str, load: &str, chosen: Option<&str>) -> Markup {
        let others = |path: &str| path.rsplit_once('.').is_some_and(|(above, _)| above == mechanism);
        let is_ours = |path: &str| path == mechanism || path == load || others(path) || Some(path) == chosen;
        html! { @for (_, fault) in self.held.faults.iter().filter(|(at, _)| at.as_deref().is_some_and(is_ours)) {
            p.fault { (crate::sentences::worded(&fault.message, fault.hint.as_deref(), self.language)) }
        } }
    }

    /// Returns the fault of a table as a whole.
    pub(crate) fn fault_at(&self, path: &str) -> Markup {
        html! { @for (_, fault) in self.held.faults.at(path) {
            @match &self.held.open_cycle {
                Some((at, can_close)) if at == path => {
                    p.fault { (crate::sentences::worded(&fault.message, None, self.language)) }
                    (self.closings(path, *can_close))
                }
                _ => p.fault { (crate::sentences::worded(&fault.message, fault.hint.as_deref(), self.language)) },
            }
        } }
    }

    /// Returns the row of one key: its name, its field, its fault.
    pub(crate) fn row(&self, key: &Key, path: &str, placeholder: Option<&str>) -> Markup {
        let l = self.language;
        let about = about_text(key.about, l);
        let label = capitalised(&short_label(about));
        let id = id(path);
        // A label that begins with its symbol has it already.
        let symbol = sketch::symbol_of(path.strip_prefix(self.prefix).unwrap_or(path));
        let has_symbol =
            about.split_once(", ").is_some_and(|(head, _)| head.len() <= SYMBOL_MOST && !head.contains(' '));
        let symbol = symbol.filter(|_| !has_symbol);
        let value = self.value(path).unwrap_or_default();
        let faults: Vec<_> = self.held.faults.at_or_listed(path).collect();
        let described = format!("{id}-x");
        let wrong = !faults.is_empty();
        let ghost = match placeholder {
            Some(solved) if value.is_empty() => Some(page::follows(&solved, l)),
            // A text is free.
            _ => value::sample(key)
                .filter(|sample| sample != "…")
                .map(|sample| page::for_example(&value::said(&sample, l), l)),
        };
        part(html! {
            div.row id={ (id) "-r" } data-path=(path) {
                label for=(id) title=(about) { (crate::markup::label(&label)) @if let Some(symbol) = symbol { " " i { (crate::chapters::symbol(symbol)) } } }
                @match key.kind {
                    Kind::Bool => (self.choice(&id, key.name, path, value, &["true", "false"], wrong, &described)),
                    Kind::OneOf(words) => (self.choice(&id, key.name, path, value, words, wrong, &described)),
                    Kind::ListOf(words) => (self.marks(&id, key, path, value, words)),
                    Kind::Rows(_) | Kind::Bodies => {
                        textarea id=(id) name="value" rows="4" spellcheck="false" placeholder=[ghost.as_ref()]
                            aria-invalid=[wrong.then_some("true")] aria-describedby=[wrong.then_some(&described)]
                            hx-post="/work" hx-trigger="input changed delay:120ms, change" hx-vals=(vals(&[("path", path)])) { (value) }
                    },
                    Kind::Quantity(..) | Kind::Along(..) => (value::field(key, (&id, path, &label), value, placeholder.filter(|_| value.is_empty()), (wrong, &described), AT_ONCE, l)),
                    Kind::Number(..) | Kind::Numbers(..) | Kind::Integer(..) | Kind::Text | Kind::Texts | Kind::Table(_) | Kind::OneOrMany(..) | Kind::Variants(_) => {
                        input id=(id) name="value" type="text" value=(value::number(key, value, l)) placeholder=[ghost.as_ref()] autocomplete="off" spellcheck="false"
                            aria-invalid=[wrong.then_some("true")] aria-describedby=[wrong.then_some(&described)]
                            hx-post="/work" hx-trigger=(AT_ONCE) hx-vals=(vals(&[("path", path)]));
                    },
                }
                @if value::dimensions(key).contains(&Dimension::MomentOfInertia) && !path.contains("actuator.") {
                    button.small.from-bodies type="button" id={ (id) "-b" } title=(page::bodies_of(&label, l)) aria-label=(page::bodies_of(&label, l))
                        hx-post="/tools" hx-target="#detail" hx-swap="innerHTML" hx-vals=(vals(&[("tool", "inertia"), ("into", path)])) { "Σ" }
                }
                @if let (Kind::Quantity(..) | Kind::Along(..), false) = (key.kind, value.is_empty()) {
                    (self.band(&id, path, &label, value))
                }
                @if let Some((_, count)) = self.needed.iter().find(|(key, _)| path.strip_prefix(self.prefix) == Some(key)) { p.small.needed { (page::checks_wait(*count, l)) } }
                @if wrong {
                    div.fault id=(described) {
                        @for (_, fault) in &faults { p { (crate::sentences::worded(&fault.message, fault.hint.as_deref(), self.language)) } }
                    }
                }
            }
        })
    }

    /// Returns the tolerance of a value: a field behind a button, open if a tolerance is stated.
    pub(crate) fn band(&self, id: &str, path: &str, label: &str, value: &str) -> Markup {
        let l = self.language;
        let (_, stated) = tolerance_of(value);
        html! {
            details.band id={ (id) "-band" } open[!stated.is_empty()] {
                summary title=(page::tolerance_of(&label, l)) aria-label=(page::tolerance_of(&label, l)) { "±" }
                input id={ (id) "-pm" } name="band" type="text" value=(stated) size="8" aria-label=(page::tolerance_of(&label, l))
                    placeholder=(page::for_example(&"5 %", l)) autocomplete="off" spellcheck="false"
                    hx-post="/work" hx-trigger="input changed delay:120ms, change" hx-vals=(vals(&[("path", path), ("nominal", value)]));
            }
        }
    }

    #[allow(clippy::too_many_arguments, reason = "what an element of HTML has")]
    pub(crate) fn choice(
        &self,
        id: &str,
        key: &str,
        path: &str,
        value: &str,
        words: &[&str],
        wrong: bool,
        described: &str,
    ) -> Markup {
        let l = self.language;
        let shown = |word: &str| match (key, SegmentLaw::of_id(word)) {
            ("law", Some(law)) => laws::name(law, l).into(),
            _ => key_word(key, word, l).unwrap_or_else(|| word.to_owned().into()),
        };
        let unknown = !value.is_empty() && !words.contains(&value);
        html! {
            select id=(id) name="value" data-chosen=(value) aria-invalid=[wrong.then_some("true")]
                aria-describedby=[wrong.then_some(described)]
                hx-post="/work" hx-trigger="change" hx-vals=(vals(&[("path", path)])) {
                // Of a key that its table requires, no value is none of the choices.
                @if value.is_empty() || !key_at(path).is_some_and(|key| key.required) { option value="" selected[value.is_empty()] { (page::not_stated(l)) } }
                @if unknown { option value=(value) selected { (value) } }
                // A law with two names is offered once, by the name that the file has.
                @let is_other_name = |word: &str| key == "law" && word != value && SegmentLaw::of_id(word).is_some_and(|law| law.id() != word);
                @for word in words.iter().filter(|word| !is_other_name(word)) { option value=(word) selected[*word == value] { (shown(word)) } }
            }
        }
    }

    /// Returns words of which several can be selected, each with the list that its selection would give.
    fn marks(&self, id: &str, key: &Key, path: &str, value: &str, words: &[&str]) -> Markup {
        let chosen: Vec<&str> = value.split(',').map(str::trim).filter(|word| !word.is_empty()).collect();
        let without = |word: &str| -> String {
            let kept = |other: &&&str| {
                if chosen.contains(&word) { **other != word } else { chosen.contains(*other) || **other == word }
            };
            words.iter().filter(kept).copied().collect::<Vec<_>>().join(", ")
        };
        html! {
            span.marks id=(id) role="group" aria-label=(capitalised(&short_label(about_text(key.about, self.language)))) {
                @for word in words {
                    label {
                        input type="checkbox" id={ (id) "-" (word) } checked[chosen.contains(word)]
                            data-checked=(chosen.contains(word))
                            hx-post="/work" hx-trigger="change" hx-vals=(vals(&[("path", path), ("value", &without(word))]));
                        (key_word(key.name, word, self.language).unwrap_or_else(|| (*word).to_owned().into()))
                    }
                }
            }
        }
    }
}

/// Joins several changes into one request.
fn do_all(changes: &[&str]) -> String {
    vals(&[("do", &changes.join("\n"))])
}
