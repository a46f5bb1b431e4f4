//! A segment of the motion as a line of a table: its law, its distance and its time.

use crate::form::{AT_ONCE, Followed, RowContent};
use crate::laws;
use crate::markup::{id, tolerance_of, vals};
use crate::sentences::worded;
use crate::value;
use maud::{Markup, html};
use project::{Key, Kind, Variants};
use quantities::{Angle, Language, Measure, format_significant, parse_as};
use std::f64::consts::TAU;
use words::{about_text, capitalised, page, short_label, views};

/// Keys of the cells behind the law.
pub(crate) const CELLS: [&str; 2] = ["distance", "time"];

/// Number of turns of the output in a segment from which it is remarked: at 10 000 1/min it lasts for ten minutes.
const TURNS_MANY: f64 = 1e5;

/// Returns the turns of a distance that are remarked, because they are more likely a slip than a motion.
fn many_turns(distance: &str) -> Option<f64> {
    let (nominal, _) = tolerance_of(distance);
    let turns = parse_as::<Angle>(nominal).ok()?.si().abs() / TAU;
    (turns > TURNS_MANY).then_some(turns)
}

/// Returns the headings of the table.
pub(crate) fn heads(language: Language) -> Markup {
    let l = language;
    html! {
        div.segment-line.heads aria-hidden="true" { span { "#" } span { (views::law(l)) } span { (views::distance(l)) } span { (views::time(l)) } }
        p.unseen id="paste-about" { (views::paste_about(l)) }
    }
}

impl RowContent<'_> {
    /// Returns the line of a segment: law, distance and time; an empty cell shows the computed value.
    pub(crate) fn segment_line(
        &self,
        variants: &Variants,
        path: &str,
        place: usize,
        (needed, may): (&[&str], &[&str]),
        solved: Option<&Followed>,
    ) -> Markup {
        let l = self.language;
        let ghost = |name: &str| solved?.value(name);
        let key = |name: &str| variants.keys.iter().find(|key| key.name == name);
        let law = format!("{path}.{}", variants.by);
        let chosen = self.value(&law).unwrap_or_default();
        let is_key = |name: &str| needed.contains(&name) || may.contains(&name);
        html! {
            div.segment-line data-row=(place) {
                span.place { (place) }
                @if let Some(Key { kind: Kind::OneOf(words), .. }) = key(variants.by) {
                    span data-path=(law) { label.unseen for=(id(&law)) { (views::cell_of_segment(&views::law(l), &place, l)) } (self.choice(&id(&law), variants.by, &law, chosen, words, self.is_wrong(&law), &format!("{}-x", id(&law)))) }
                }
                @for (column, name) in (1_usize..).zip(CELLS) {
                    @let at = format!("{path}.{name}");
                    @let stated = self.value(&at);
                    @match key(name).filter(|_| is_key(name) || stated.is_some()) {
                        Some(key) => (self.cell(key, &at, (place, column), stated.unwrap_or_default(), ghost(name))),
                        None => span.follows title=(views::follows_about(l)) { @if let Some(follows) = ghost(name) { "= " (value::with_mark(follows, l)) } },
                    }
                }
            }
            @for name in [variants.by].into_iter().chain(CELLS) { (self.faults_of_cell(&format!("{path}.{name}"))) }
            @if let Some(turns) = self.value(&format!("{path}.distance")).and_then(many_turns) {
                p.small.advice.long-way { (views::long_way(&format_significant(turns, 3, l), l)) }
            }
        }
    }

    fn cell(&self, key: &Key, path: &str, (row, column): (usize, usize), stated: &str, ghost: Option<&str>) -> Markup {
        let l = self.language;
        let id = id(path);
        let (nominal, band) = tolerance_of(stated);
        let unit = value::unit_of(key, if nominal.is_empty() { ghost.unwrap_or_default() } else { nominal });
        let label = views::cell_of_segment(&capitalised(&short_label(about_text(key.about, l))), &row, l);
        let placeholder = ghost.filter(|_| nominal.is_empty()).map(|ghost| format!("= {}", value::with_mark(ghost, l)));
        let wrong = self.is_wrong(path);
        html! {
            span data-path=(path) {
                input id=(id) name="value" type="text" value=(value::with_mark(nominal, l)) placeholder=[placeholder] autocomplete="off" spellcheck="false"
                    data-cell=(column) data-row=(row) aria-label=(label) aria-invalid=[wrong.then_some("true")] aria-describedby=(if wrong { format!("{id}-x") } else { String::from("paste-about") })
                    hx-post="/work" hx-trigger=(AT_ONCE) hx-vals=(vals(&[("path", path), ("unit", unit), ("kept", band)]));
            }
        }
    }

    fn is_wrong(&self, path: &str) -> bool {
        self.held.faults.at(path).next().is_some()
    }

    /// Returns the faults of a cell below its line.
    fn faults_of_cell(&self, path: &str) -> Markup {
        html! { @if self.is_wrong(path) {
            div.fault id={ (id(path)) "-x" } {
                @for (_, fault) in self.held.faults.at(path) {
                    p { (worded(&fault.message, fault.hint.as_deref(), self.language)) }
                }
            }
        } }
    }

    /// Returns the tolerances of the stated cells; `None` without one.
    pub(crate) fn bands_of_line(&self, path: &str) -> Option<Markup> {
        let l = self.language;
        let stated: Vec<(String, &str, String)> = CELLS
            .into_iter()
            .filter_map(|name| {
                let at = format!("{path}.{name}");
                let about = about_text(project::key_at(&at)?.about, l);
                Some((at.clone(), self.value(&at)?, capitalised(&short_label(about))))
            })
            .collect();
        (!stated.is_empty()).then(|| {
            html! { @for (at, value, label) in &stated {
                div.row { label for={ (id(at)) "-pm" } { (page::tolerance_of(label, l)) } (self.band(&id(at), at, label, value)) }
            } }
        })
    }

    /// Returns the fold with the pictures of the laws.
    pub(crate) fn law_pictures(&self, path: &str, chosen: &str) -> Markup {
        let at = id(&format!("{path}.law"));
        self.fold(&format!("{at}-laws"), page::choose_by_picture(self.language), false, "laws", || {
            laws::menu(&at, laws::words(), chosen, self.language)
        })
    }

    /// Returns the buttons that move, reverse, duplicate and remove an entry.
    pub(crate) fn entry_tools(&self, path: &str, name: &str, place: usize, count: usize) -> Markup {
        let l = self.language;
        let list = path.rsplit_once('[').map_or(path, |(list, _)| list);
        html! {
            div.tools {
                @if place < count {
                    button.small type="button" aria-label=(page::move_down(&name, l)) title=(page::move_down(&name, l))
                        hx-post="/work" hx-vals=(vals(&[("do", &format!("down {path}"))])) { "↓" }
                }
                @if place > 1 {
                    @let above = format!("down {list}[{}]", place - 1);
                    button.small type="button" aria-label=(page::move_up(&name, l)) title=(page::move_up(&name, l))
                        hx-post="/work" hx-vals=(vals(&[("do", &above)])) { "↑" }
                }
                @if let Some(back) = self.reversed(path) {
                    button.small type="button" aria-label=(page::reverse(&name, l)) title=(page::reverse(&name, l))
                        hx-post="/work" hx-vals=(vals(&[("do", &back)])) { "⇄" }
                }
                button.small type="button" aria-label=(page::once_more(&name, l)) title=(page::once_more(&name, l))
                    hx-post="/work" hx-vals=(vals(&[("do", &format!("twice {path}"))])) { svg width="14" height="14" viewBox="0 0 14 14" aria-hidden="true" { path d="M4.5 4.5V1.5H12.5V9.5H9.5M1.5 4.5H9.5V12.5H1.5z" {} } }
                button.small type="button" aria-label=(page::remove(&name, l)) title=(page::remove(&name, l))
                    hx-post="/work" hx-vals=(vals(&[("do", &format!("gone {path}"))])) { "×" }
            }
        }
    }

    /// Returns the change that reverses a segment: the opposite sign of its distance or, if it states no distance, of
    /// its speed.
    fn reversed(&self, path: &str) -> Option<String> {
        let key = ["distance", "speed"].into_iter().find(|key| self.value(&format!("{path}.{key}")).is_some())?;
        let value = self.value(&format!("{path}.{key}"))?.trim();
        let back = value.strip_prefix('-').map_or_else(|| format!("-{}", value.trim_start_matches('+')), str::to_owned);
        Some(format!("value {path}.{key}={}", back.trim()))
    }

    /// Returns the changes that close a cycle.
    pub(crate) fn closings(&self, path: &str, can_close: bool) -> Markup {
        let l = self.language;
        let prefix = path.split("motion").next().unwrap_or_default();
        let axis = if prefix.is_empty() { "axis." } else { prefix };
        html! { div.cycle-open {
            @if can_close { button type="button" id="way-back" hx-post="/work" hx-vals=(vals(&[("do", &format!("close {prefix}"))])) { (views::way_back_follows(l)) } }
            button type="button" id="single-move" hx-post="/work" hx-vals=(vals(&[("do", &format!("value {axis}single_move=true"))])) { (views::single_move(l)) }
        } }
    }
}
