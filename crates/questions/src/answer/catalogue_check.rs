//! Plausibility of a catalogue file as a record.

use answers::{CatalogueFigure, CatalogueFinding, CatalogueProposal, CheckedCatalogue, Number, OtherProduct};
use axis::{CatalogueCheck, ComparedFigure, PlausibilityFinding, UnitProposal};
use quantities::{Language, seen};
use words::plausibility::{plausibility_reason, plausibility_text};

/// Returns the record of a check.
#[must_use]
pub fn checked_catalogue(file: &str, check: &CatalogueCheck, language: Language) -> CheckedCatalogue {
    CheckedCatalogue {
        file: file.to_owned(),
        products: check.names.len(),
        findings: check.findings.iter().map(|each| finding(each, language)).collect(),
        proposals: check.proposals.iter().map(proposal).collect(),
    }
}

fn shown(text: &str) -> String {
    seen(text).into_owned()
}

fn finding(finding: &PlausibilityFinding, language: Language) -> CatalogueFinding {
    let other = |(product, line): &(String, usize)| OtherProduct { product: shown(product), line: *line };
    CatalogueFinding {
        id: finding.rule.id(),
        product: shown(&finding.product),
        line: finding.line,
        column: finding.column,
        formula: finding.formula,
        value: finding.ratio.map(Number),
        low: finding.window.map(|(low, _)| Number(low)),
        high: finding.window.map(|(_, high)| Number(high)),
        unit: finding.unit,
        figures: finding.figures.iter().map(figure).collect(),
        other: finding.other.as_ref().map(other),
        message: shown(&plausibility_text(finding, language)),
        reason: plausibility_reason(finding.rule, language),
    }
}

fn figure(figure: &ComparedFigure) -> CatalogueFigure {
    let (symbol, key, line, column) = (figure.symbol, figure.key, figure.line, figure.column);
    CatalogueFigure { symbol, key, written: shown(&figure.written), line, column }
}

fn proposal(proposal: &UnitProposal) -> CatalogueProposal {
    CatalogueProposal {
        product: proposal.product.as_deref().map(shown),
        key: proposal.key,
        line: proposal.line,
        column: proposal.column,
        old: shown(&proposal.old),
        new: shown(&proposal.new),
        meant: shown(&proposal.meant),
        resolves: proposal.resolves.iter().map(|rule| rule.id()).collect(),
        alternative: proposal.is_one_of_several,
    }
}
