//! Layouts of the questions on the terminal: an entry for each question that is not shown as its record.

use crate::call::Show;
use crate::command::own;
use crate::{
    catalogue_check, chapter, code, commission, compare, data, diff, encoder, errata, explain, export, glossary,
    inertia, judge, licences, mount, moves, plot, report, simulate, sweep, upkeep, wiring,
};
use clap::Command;
use quantities::Language;
use questions::list::{self, Entry};

/// Layout of the answer to a question on the terminal, and the options of its command in addition to the arguments of
/// the question.
pub(crate) struct Layout {
    entry: &'static Entry,
    pub(crate) show: Show,
    pub(crate) own: fn(Command, Language) -> Command,
}

const LAYOUTS: &[Layout] = &[
    shown(&list::size::ENTRY, judge::size).with(own::size),
    shown(&list::check::ENTRY, judge::check),
    shown(&list::sweep::ENTRY, sweep::sweep).with(own::sweep),
    shown(&list::simulate::ENTRY, simulate::simulate).with(own::simulate),
    shown(&list::identify::ENTRY, simulate::identify),
    shown(&list::report::ENTRY, report::report).with(own::report),
    shown(&list::explain::ENTRY, explain::explain),
    shown(&list::compare::ENTRY, compare::compare),
    shown(&list::diff::ENTRY, diff::diff),
    shown(&list::export::ENTRY, export::export).with(own::export),
    shown(&list::code_parse::ENTRY, code::parse),
    shown(&list::code_list::ENTRY, code::list),
    shown(&list::code_complete::ENTRY, code::complete),
    shown(&list::data::ENTRY, data::sheet).with(own::data),
    shown(&list::wiring::ENTRY, wiring::wiring).with(own::wiring),
    shown(&list::wiring_check::ENTRY, wiring::check),
    shown(&list::encoder::ENTRY, encoder::encoder),
    shown(&list::errata::ENTRY, errata::errata),
    shown(&list::catalogue::ENTRY, data::catalogue).with(own::catalogue),
    shown(&list::catalogue_check::ENTRY, catalogue_check::check).with(catalogue_check::options),
    shown(&list::curve::ENTRY, chapter::curve).with(own::picture),
    shown(&list::plot::ENTRY, plot::plot).with(own::plot),
    shown(&list::bearing::ENTRY, chapter::bearing),
    shown(&list::moves::ENTRY, moves::moves),
    shown(&list::battery::ENTRY, chapter::battery),
    shown(&list::mount::ENTRY, mount::alone),
    shown(&list::mount_project::ENTRY, mount::under_project),
    shown(&list::upkeep::ENTRY, upkeep::upkeep),
    shown(&list::new::ENTRY, chapter::template).with(own::new),
    shown(&list::commission::ENTRY, commission::commission).with(own::commission),
    shown(&list::commission_record::ENTRY, commission::recorded),
    shown(&list::torsion::ENTRY, data::torsion),
    shown(&list::inertia::ENTRY, inertia::inertia).with(own::shapes),
    shown(&list::glossary::ENTRY, glossary::glossary),
    shown(&list::units::ENTRY, glossary::units),
    shown(&list::licences::ENTRY, licences::licences),
];

const fn shown(entry: &'static Entry, show: Show) -> Layout {
    Layout { entry, show, own: own::nothing }
}

impl Layout {
    const fn with(self, own: fn(Command, Language) -> Command) -> Self {
        Self { own, ..self }
    }

    /// Returns the layout of a question.
    pub(crate) fn of(entry: &Entry) -> Option<&'static Self> {
        LAYOUTS.iter().find(|layout| layout.entry.command == entry.command)
    }
}
