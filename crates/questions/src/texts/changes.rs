//! Changes with which an actuator fits where none does, in a line each.

use crate::catalogue_reserve::CatalogueReach;
use crate::gearing_proposals::GearingProposal;
use crate::proposals::LawProposal;
use project::SegmentLaw;
use quantities::{Language, format_significant, with_symbol};
use sizing::AxisChange;
use words::{proviso_text, terminal, unpadded};

/// Describes a value with which an actuator fits: its name and key, or a stage to add, with the code.
#[must_use]
pub fn mend_text(mend: &GearingProposal, language: Language) -> String {
    let value = || unpadded(mend.unit.from_si(mend.si), 5, language);
    let what = if mend.adds_stage() {
        words::stage_by_its_keys(mend.unit.from_si(mend.si), mend.changes_flange_loads, language)
    } else {
        let name = words::purpose_of(&mend.path, language);
        format!("{name} {} ({})", with_symbol(&value(), mend.unit.symbol_in(language)), mend.path)
    };
    match proviso_text(mend.proviso.estimate, mend.proviso.rating, language) {
        Some(proviso) => format!("{what}: {}, {proviso}", mend.code),
        None => format!("{what}: {}", mend.code),
    }
}

/// Describes a change of load or cycle time with which an actuator fits, with its code.
#[must_use]
pub fn reach_text(reach: &CatalogueReach, language: Language) -> String {
    let value = format_significant(reach.value, 4, language);
    let what = match reach.change {
        AxisChange::Payload => terminal::payload_factor(&value, language),
        AxisChange::Load => terminal::load_factor(&value, language),
        AxisChange::CycleTime => terminal::cycle_time(&value, language),
    };
    match proviso_text(reach.proviso.estimate, reach.proviso.rating, language) {
        Some(proviso) => format!("{what}: {}, {proviso}", reach.code),
        None => format!("{what}: {}", reach.code),
    }
}

/// Number of keys up to which a proposal writes them into the call.
const KEYS_IN_A_CALL: usize = 4;

/// Describes a law in place of the open ones with which an actuator fits, with the options of a call or the value in the
/// file.
#[must_use]
pub fn law_text(proposal: &LawProposal, language: Language) -> String {
    let law = SegmentLaw::Law(proposal.law);
    let is_short =
        proposal.paths.len() <= KEYS_IN_A_CALL && proposal.paths.iter().all(|path| path.starts_with("motion["));
    let call = || {
        let options = proposal.paths.iter().map(|path| {
            let key = path.replace('[', ".").replace(']', "");
            format!("--set {key}={}", law.id())
        });
        options.collect::<Vec<_>>().join(" ")
    };
    let how = if is_short { call() } else { format!("law = \"{}\"", law.id()) };
    let what = format!("{} ({how})", words::law_text(law, language));
    match proviso_text(proposal.proviso.estimate, proposal.proviso.rating, language) {
        Some(proviso) => format!("{what}: {}, {proviso}", proposal.code),
        None => format!("{what}: {}", proposal.code),
    }
}
