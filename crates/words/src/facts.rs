//! Words about facts that a source states in prose.

use crate::texts::said;
use crate::{document_short, pick};
use catalogue::{Fact, LifeStep, SignalWord};
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
pub const fn signal_word(signal: SignalWord, language: Language) -> &'static str {
    let (en, de) = match signal {
        SignalWord::Danger => ("DANGER", "GEFAHR"),
        SignalWord::Warning => ("WARNING", "WARNUNG"),
        SignalWord::Caution => ("CAUTION", "VORSICHT"),
        SignalWord::Notice => ("NOTICE", "HINWEIS"),
        SignalWord::Info => ("INFO", "INFO"),
    };
    pick(language, en, de)
}

/// Returns the step at which a fact matters, as the heading of a checklist.
#[must_use]
pub const fn step_title(step: LifeStep, language: Language) -> &'static str {
    let (en, de) = match step {
        LifeStep::Transport => ("transport and storage", "Transport und Lagerung"),
        LifeStep::Mounting => ("mounting", "Montage"),
        LifeStep::Wiring => ("wiring", "Verdrahtung"),
        LifeStep::BeforePower => ("before the power is switched on", "vor dem Einschalten"),
        LifeStep::FirstMotion => ("first motion", "erste Bewegung"),
        LifeStep::AfterADay => ("after one day of operation", "nach einem Betriebstag"),
        LifeStep::InService => ("in operation", "im Betrieb"),
        LifeStep::Shutdown => ("shutting down and maintenance", "Stillsetzen und Wartung"),
        LifeStep::Disposal => ("taking out of service", "Außerbetriebnahme"),
    };
    pick(language, en, de)
}
