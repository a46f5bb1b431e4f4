//! `catalogue check`: implausible values of catalogue files, and proposed cells.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::table::{Align, TextTable, paragraph};
use answers::{CatalogueFigure, CatalogueProposal, CheckedCatalogue};
use clap::Command;
use quantities::Language;
use questions::list::{Inquiry, Unanswered, catalogue_check};
use std::fmt::Write as _;
use words::{help, plausibility};

/// `antrieb catalogue check FILE…`
pub(crate) fn check(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let record = catalogue_check::found(inquiry)?;
    let proposes = call.flag("fix-units");
    let files: Vec<String> = record.files.iter().map(|file| file_text(file, proposes, language)).collect();
    Ok(CommandAnswer::data(files.join("\n")).fits(record.plausible))
}

/// Adds the exit status to the help.
pub(crate) fn options(command: Command, language: Language) -> Command {
    command.after_help(help::catalogue_check_exit(language))
}

fn file_text(file: &CheckedCatalogue, proposes: bool, language: Language) -> String {
    let counted = if file.findings.is_empty() {
        plausibility::plausible(file.products, language)
    } else {
        plausibility::implausible(file.findings.len(), &file.products, language)
    };
    let mut out = format!("{}: {counted}\n", file.file);
    for finding in &file.findings {
        let figures: Vec<String> = finding.figures.iter().map(figure).collect();
        let figures = if figures.is_empty() { String::new() } else { format!(" ({})", figures.join("; ")) };
        let head = format!("{}:{}:{}: {}: {}", file.file, finding.line, finding.column, finding.product, finding.id);
        let _ = write!(out, "\n{head}\n");
        out.push_str(&paragraph("  ", &format!("{}{figures}", finding.message)));
        out.push_str(&paragraph("  ", finding.reason));
    }
    if proposes && !file.findings.is_empty() {
        let _ = write!(out, "\n{}\n", proposals(&file.proposals, language));
    }
    out
}

fn figure(figure: &CatalogueFigure) -> String {
    let name = if figure.symbol.is_empty() { figure.key } else { figure.symbol };
    format!("{name} {}, {}:{}", figure.written, figure.line, figure.column)
}

fn proposals(all: &[CatalogueProposal], language: Language) -> String {
    let l = language;
    if all.is_empty() {
        return plausibility::no_proposals(l).to_owned();
    }
    let mut table = TextTable::new([
        (plausibility::place(l), Align::Right),
        (plausibility::actuator(l), Align::Left),
        (plausibility::key(l), Align::Left),
        (plausibility::old_cell(l), Align::Left),
        (plausibility::new_cell(l), Align::Left),
        (plausibility::resolves(l), Align::Left),
    ]);
    for proposal in all {
        let of = if proposal.alternative { " *" } else { "" };
        table.row([
            format!("{}:{}", proposal.line, proposal.column),
            proposal.product.clone().unwrap_or_else(|| plausibility::heading(l).to_owned()),
            proposal.key.to_owned(),
            proposal.old.clone(),
            proposal.new.clone(),
            format!("{}{of}", proposal.resolves.join(", ")),
        ]);
    }
    let note = if all.iter().any(|proposal| proposal.alternative) {
        format!("* {}\n", plausibility::one_of_several(l))
    } else {
        String::new()
    };
    format!("{}\n{}{note}", plausibility::proposals(l), table.render())
}
