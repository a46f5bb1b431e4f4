//! A requested tool: its subject, its fields as typed, and its address.

use super::field::{MARK, ToolField};
use crate::call::{Call, Shell, query};
use figures::Theme;
use maud::{Markup, html};
use project::{Written, written};
use quantities::{Language, Measure, format_significant};
use questions::{ProductId, Progress, check, read_all_watched, read_code};
use std::borrow::Cow;
use words::page;

/// A requested tool.
pub(super) struct Scene<'c> {
    pub(super) call: &'c Call<'c>,
    pub(super) shell: &'c dyn Shell,
    pub(super) progress: &'c Progress,
    pub(super) language: Language,
    pub(super) theme: Theme,
    /// Name in requests.
    pub(super) tool: &'static str,
    /// The code, or the text in its place.
    pub(super) about: String,
    /// The fields are filled in, by the user or by a link.
    pub(super) is_filled: bool,
    /// The tool is shown in a view of the work frame, about the actuator that is shown there.
    pub(super) is_in_view: bool,
}

/// Place of a tool in a view of the work frame, in requests.
pub(super) const IN_VIEW: &str = "view";

impl<'c> Scene<'c> {
    pub(super) fn of(call: &'c Call<'c>, tool: &'static str, shell: &'c dyn Shell, progress: &'c Progress) -> Self {
        let about = call.field("about").or_else(|| call.field("code")).map(Cow::into_owned).unwrap_or_default();
        Self {
            call,
            shell,
            progress,
            language: call.language(),
            theme: call.theme(),
            tool,
            about,
            is_filled: call.field("asked").is_some_and(|inquiry| inquiry == tool),
            is_in_view: call.field("within").is_some_and(|place| place == IN_VIEW),
        }
    }

    /// Returns `true` if it is about a product of a catalogue file that the shown project names.
    pub(super) fn is_about_a_product_of_a_file(&self) -> bool {
        if read_code(&self.about, self.language).is_ok() {
            return false;
        }
        let text = self.call.field("text").unwrap_or_default();
        let place: usize = self.call.field("axis").and_then(|axis| axis.parse().ok()).unwrap_or(0);
        let axes = read_all_watched(&text, self.shell.files(), self.shell.catalogue(), self.progress);
        let id = ProductId::named(self.about.trim());
        axes.ok().and_then(|axes| Some(axes.get(place)?.catalogue().product(&id).is_some())).unwrap_or_default()
    }

    /// Returns the entry of a field of the tool; several texts have a line each.
    pub(super) fn typed(&self, name: &str) -> Option<String> {
        if !self.is_filled {
            return None;
        }
        Some(self.call.all(&format!("{MARK}{name}")).collect::<Vec<_>>().join("\n"))
    }

    /// Returns the axis of the shown project if it has several.
    pub(super) fn axis(&self) -> Option<String> {
        let place: usize = self.call.field("axis")?.parse().ok()?;
        let text = self.call.field("text")?;
        let axes = read_all_watched(&text, self.shell.files(), self.shell.catalogue(), self.progress)
            .ok()
            .filter(|axes| axes.len() > 1)?;
        axes.get(place).map(|axis| axis.name.clone())
    }

    /// Returns the peak torque of the shown axis with the actuator of the tool, as an entry of a field.
    pub(super) fn torque_peak(&self) -> Option<String> {
        let text = self.call.field("text").filter(|text| !text.is_empty())?;
        let place: usize = self.call.field("axis").and_then(|axis| axis.parse().ok()).unwrap_or(0);
        let axes = read_all_watched(&text, self.shell.files(), self.shell.catalogue(), self.progress).ok()?;
        let code = read_code(&self.about, self.language).ok()?.parsed.code;
        let candidate = check(axes.get(place)?, &code).ok()?;
        let peak = format_significant(candidate.judgement.demand.as_ref()?.torque_peak.si(), 4, self.language);
        Some(format!("{peak} N m"))
    }

    /// Returns the values at and below a path of the shown axis, with the rest of their paths.
    pub(super) fn below_axis(&self, path: &str) -> Vec<(String, String)> {
        let all = written(&self.call.field("text").unwrap_or_default()).unwrap_or_default();
        let place: usize = self.call.field("axis").and_then(|axis| axis.parse().ok()).unwrap_or(0);
        let is_of_several = all.iter().any(|key| key.path == "axis[1]");
        let path = if is_of_several { format!("axis[{}].{path}", place + 1) } else { path.to_owned() };
        let stated = |key: Written| Some((key.path.strip_prefix(&path)?.to_owned(), key.value?));
        all.into_iter().filter_map(stated).collect()
    }

    /// Returns the value at a path of the shown axis.
    pub(super) fn of_axis(&self, path: &str) -> Option<String> {
        self.below_axis(path).into_iter().find(|(rest, _)| rest.is_empty()).map(|(_, value)| value)
    }

    /// Returns an address that opens the tool with these fields.
    pub(super) fn address(&self, fields: &[(&str, &str)]) -> String {
        let plain = |(name, value): (&str, _)| (name.to_owned(), value);
        let own = [("tool", self.tool), ("asked", self.tool), ("about", self.about.as_str())].map(plain);
        let typed = fields.iter().map(|(name, value)| (format!("{MARK}{name}"), *value));
        format!("/?{}", query(own.into_iter().chain(typed).chain([plain(("lang", self.language.id()))])))
    }

    pub(super) fn link(&self, fields: &[(&str, &str)]) -> Markup {
        html! { @if !self.is_in_view { p.small { a id="tool-link" href=(self.address(fields)) { (page::link_to_tool(self.language)) } } } }
    }
}

/// Last question that had an answer.
pub(super) const GOOD: &str = "good";

pub(super) fn fields_of(fields: &[ToolField], language: Language) -> Markup {
    html! { div.rows { @for field in fields { (field.shown(language)) } } }
}
