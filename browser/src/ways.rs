//! The test scenarios.

mod axes;
mod begin;
mod door;
mod files;
mod form;
mod frame;
mod looks;
mod neighbour;
mod pictures;
mod same;
mod screens;
mod times;
mod typed;

use crate::make::Make;
use crate::shell::Shell;
use crate::stage::OpenPage;
use crate::tab::Worded;

/// One scenario.
pub(crate) struct Way {
    pub(crate) name: &'static str,
    shells: Shells,
    makes: Makes,
    /// `true` if it runs at night only: it takes long, or compares times, which depend on the load of the machine.
    pub(crate) is_long: bool,
    pub(crate) go: fn(&OpenPage<'_>) -> Worded,
}

/// Browsers in which a scenario runs.
#[derive(Clone, Copy)]
enum Makes {
    Any,
    /// The scenario needs a function of Chromium's driver, or compares screenshots taken with it.
    Chromium,
}

/// Shells with which a scenario runs.
#[derive(Clone, Copy)]
enum Shells {
    Both,
    Server,
    Site,
}

impl Way {
    const fn both(name: &'static str, go: fn(&OpenPage<'_>) -> Worded) -> Self {
        Self { name, shells: Shells::Both, makes: Makes::Any, is_long: false, go }
    }

    const fn server(name: &'static str, go: fn(&OpenPage<'_>) -> Worded) -> Self {
        Self { name, shells: Shells::Server, makes: Makes::Any, is_long: false, go }
    }

    const fn site(name: &'static str, go: fn(&OpenPage<'_>) -> Worded) -> Self {
        Self { name, shells: Shells::Site, makes: Makes::Any, is_long: false, go }
    }

    /// Restricts the scenario to Chromium.
    const fn in_chromium(self) -> Self {
        Self { makes: Makes::Chromium, ..self }
    }

    /// Leaves the scenario to the night.
    const fn at_night(self) -> Self {
        Self { is_long: true, ..self }
    }

    /// Returns `true` if the scenario runs with a shell in a browser of this make.
    pub(crate) fn concerns(&self, shell: &Shell, make: Make) -> bool {
        let is_able = match self.makes {
            Makes::Any => true,
            Makes::Chromium => make == Make::Chromium,
        };
        is_able
            && match self.shells {
                Shells::Both => true,
                Shells::Server => matches!(shell, Shell::Server { .. }),
                Shells::Site => matches!(shell, Shell::Site { .. }),
            }
    }
}

/// The scenarios, by name.
pub(crate) const ALL: &[Way] = &[
    Way::server("another-port", neighbour::a_server_at_another_port_gets_no_token),
    Way::both("begin-with-figures", begin::with_figures),
    Way::both("typed-and-judged", typed::typed_and_judged).in_chromium(),
    Way::both("assumptions", typed::assumptions),
    Way::both("begin-with-an-example", begin::with_an_example),
    Way::both("begin-with-a-file", begin::with_a_file),
    Way::both("begin-with-a-link", begin::with_a_link),
    Way::both("change-a-value", form::a_value_changes_the_verdict),
    Way::both("a-fault-at-its-field", form::a_fault_stands_at_its_field),
    Way::both("undo-and-redo", form::undo_and_redo),
    Way::both("explain-a-number", form::a_number_is_explained),
    Way::both("language-and-dark", form::language_and_dark),
    Way::both("compare", form::compare),
    Way::both("keyboard", form::by_keyboard),
    Way::both("pull-an-end", pictures::an_end_is_pulled),
    Way::both("pull-by-keys", pictures::an_end_is_pulled_by_keys),
    Way::both("values-at-the-cursor", pictures::values_at_the_cursor),
    Way::both("across-a-plane", pictures::across_a_plane),
    Way::both("cycle-stays-closed", pictures::a_cycle_stays_closed),
    Way::both("paste-segments", pictures::rows_are_pasted),
    Way::both("two-runs", pictures::two_runs).at_night(),
    Way::both("narrow-the-time", pictures::the_time_is_narrowed),
    Way::both("tolerance", pictures::a_tolerance),
    Way::both("tools-of-the-actuator", pictures::the_tools_know_the_actuator),
    Way::both("calculator", pictures::a_calculator),
    Way::both("save-and-open", files::save_and_open),
    Way::both("two-tabs", files::two_tabs).at_night(),
    Way::both("drafts-of-two-tabs", files::drafts_of_two_tabs).at_night(),
    Way::both("paste-a-recording", files::paste_a_recording),
    Way::both("recording-through-the-door", door::recording_through_the_door).at_night(),
    Way::both("recording-along-a-line", door::recording_along_a_line),
    Way::both("hostile-recordings", door::hostile_recordings),
    Way::both("inertia-fills-its-field", axes::inertia_fills_its_field),
    Way::both("a-further-axis", axes::a_further_axis),
    Way::both("names-of-downloads", axes::names_of_downloads),
    Way::both("download", files::download),
    Way::server("report", files::report),
    Way::site("no-report", files::no_report),
    Way::site("reload", files::reload),
    Way::site("no-network", files::no_network).in_chromium(),
    Way::site("opened-as-a-file", files::opened_as_a_file),
    Way::site("forget", files::forget),
    Way::both("in-sight", frame::in_sight),
    Way::both("narrow", frame::narrow),
    Way::both("border", frame::a_border_is_moved),
    Way::both("palette", frame::the_palette_finds),
    Way::both("numbers-and-units", frame::numbers_and_units),
    Way::both("link-of-a-tile", frame::a_link_of_a_tile),
    Way::server("unsaved-work", frame::unsaved_work_stays),
    Way::both("drafts", frame::drafts_of_new_axes),
    Way::server("no-answer", frame::no_answer).in_chromium(),
    Way::both("names-of-files", frame::names_of_files),
    Way::both("versions", frame::versions),
    Way::both("curves", frame::curves),
    Way::both("faults-and-proposals", frame::faults_and_proposals),
    Way::both("twin", frame::the_twin),
    Way::both("actions", frame::actions_to_an_answer),
    Way::server("screens", screens::as_they_were).in_chromium().at_night(),
    Way::both("widths", looks::widths),
    Way::both("paper", looks::on_paper).in_chromium(),
    Way::both("first-page", looks::first_page),
    Way::both("accessibility", looks::accessibility),
    Way::both("phone", looks::a_phone),
    Way::both("theory", looks::a_chapter),
    Way::site("same-answers", same::same_answers),
    Way::both("times", times::times).at_night(),
    Way::server("times-of-a-long-recording", times::a_long_recording).at_night(),
    Way::both("times-of-a-table", times::times_of_a_table).at_night(),
];
