//! Words about facts that a source states in prose.

use crate::texts::said;
use crate::{document_short, pick};
use catalogue::{Fact, Signal, Step};
use quantities::Language;

/// Returns the text of a fact.
#[must_use]
pub const fn fact_text(fact: &Fact, language: Language) -> &'static str {
    pick(language, fact.en, fact.de)
}

/// Returns the place of a fact in its document: `CHA manual section 9.4`.
#[must_use]
pub fn fact_source(fact: &Fact, language: Language) -> String {
    let (document, section) = (document_short(fact.document, language), fact.section);
    said!(language => "{document} section {section}" | "{document} Abschnitt {section}")
}

/// Returns the signal word according to ISO 3864-2 and ANSI Z535.6.
#[must_use]
pub const fn signal_word(signal: Signal, language: Language) -> &'static str {
    let (en, de) = match signal {
        Signal::Danger => ("DANGER", "GEFAHR"),
        Signal::Warning => ("WARNING", "WARNUNG"),
        Signal::Caution => ("CAUTION", "VORSICHT"),
        Signal::Notice => ("NOTICE", "HINWEIS"),
        Signal::Info => ("INFO", "INFO"),
    };
    pick(language, en, de)
}

/// Returns the step at which a fact matters, as the heading of a checklist.
#[must_use]
pub const fn step_title(step: Step, language: Language) -> &'static str {
    let (en, de) = match step {
        Step::Transport => ("transport and storage", "Transport und Lagerung"),
        Step::Mounting => ("mounting", "Montage"),
        Step::Wiring => ("wiring", "Verdrahtung"),
        Step::BeforePower => ("before the power is switched on", "vor dem Einschalten"),
        Step::FirstMotion => ("first motion", "erste Bewegung"),
        Step::AfterADay => ("after one day of operation", "nach einem Betriebstag"),
        Step::InService => ("in service", "im Betrieb"),
        Step::Shutdown => ("shutting down and maintenance", "Stillsetzen und Wartung"),
        Step::Disposal => ("taking out of service", "Außerbetriebnahme"),
    };
    pick(language, en, de)
}
