//! Signals and words of the encoders of a code.

use super::parts::{grid, hazards, plain, significant};
use answers::{Chapter, Column, DecodedWord, Encoder, EncoderPin, EncoderSignal, EncoderState, SignalForm, WordFault};
use installation::wiring::Role;
use quantities::Language;
use words::{ERRATUM_MARK, capitalised, encoder, evidence_text, grade_word, marked, report};

/// Returns the signals and words of a code.
#[must_use]
pub fn encoder(record: &Encoder, language: Language) -> Chapter {
    let mut chapter = Chapter::new(encoder::title(&record.code, language));
    for state in std::iter::once(&record.motor).chain(&record.output_encoder) {
        of_state(&mut chapter, state, record.seed.is_some(), language);
    }
    if let Some(decoded) = &record.decoded {
        of_word(&mut chapter, decoded, language);
    }
    if !record.notes.is_empty() {
        chapter.section(capitalised(encoder::notes(language)));
        chapter.points(record.notes.clone());
    }
    if !record.errata.is_empty() {
        let states = std::iter::once(&record.motor).chain(&record.output_encoder);
        let marks: Vec<&str> =
            states.flat_map(|state| state.signals.values()).flat_map(|signal| &signal.errata).copied().collect();
        let erratum = |id: &&'static str| {
            let mark = if marks.contains(id) { format!("{ERRATUM_MARK} ") } else { String::new() };
            format!("{mark}{id}: {}", evidence_text(id, language))
        };
        chapter.section(report::c_errata(language));
        chapter.points(record.errata.iter().map(erratum).collect());
    }
    chapter.section(capitalised(encoder::assumptions(language)));
    let graded =
        |found: &answers::EncoderAssumption| format!("{} ({})", found.text, grade_word(*found.grade, language));
    chapter.points(record.assumptions.iter().map(graded).collect());
    chapter.hazards(hazards(&record.rules, language));
    chapter
}

fn of_state(chapter: &mut Chapter, state: &EncoderState, is_seeded: bool, language: Language) {
    let name = match *state.connector {
        Role::Motor | Role::Feedback => encoder::motor_feedback(language),
        Role::OutputEncoder => encoder::output_encoder(language),
    };
    let kind = state.type_printed.map_or_else(String::new, |kind| format!(", {kind}"));
    chapter.section(capitalised(&format!("{name}{kind}")));
    let shaft = &state.shaft;
    let angle = significant(Some(shaft.angle_deg), 7, language);
    chapter.text(encoder::shaft(&shaft.turns, &angle, &plain(Some(shaft.speed_per_min), language), language));
    if let (true, Some(accuracy)) = (is_seeded, shaft.accuracy_arcsec) {
        let seen = significant(Some(shaft.seen_deg), 7, language);
        chapter.text(encoder::seen(&seen, &plain(Some(accuracy), language), language));
    }
    let signals: Vec<_> = state.signals.iter().collect();
    let pin = |pin: &EncoderPin| format!("{} ({})", pin.pin, pin.signal);
    grid(
        chapter,
        &signals,
        &[
            (Column::text(encoder::signal(language)), &|(name, _)| (**name).to_owned()),
            (Column::text(encoder::pins(language)), &|(_, signal)| {
                signal.pins.iter().map(pin).collect::<Vec<_>>().join(", ")
            }),
            (Column::text(encoder::value(language)), &|(_, signal)| marked(shown(signal, language), &signal.errata)),
            (Column::text(encoder::periods(language)), &|(_, signal)| {
                signal.periods_per_turn.map_or_else(String::new, |periods| periods.to_string())
            }),
            (Column::wide(encoder::meaning(language)), &|(_, signal)| signal.meaning.clone()),
        ],
    );
    if state.words.is_empty() {
        chapter.text(encoder::no_words(language));
    }
    for word in &state.words {
        chapter.text(format!("{}: {}", word.title, word.bits));
        grid(
            chapter,
            &word.fields,
            &[
                (Column::text(encoder::field(language)), &|field| field.title.to_owned()),
                (Column::text(encoder::bits(language)), &|field| field.bits.clone()),
                (Column::numbers(encoder::value(language)), &|field| field.value.to_string()),
            ],
        );
    }
}

/// Formats the value of a signal.
fn shown(signal: &EncoderSignal, language: Language) -> String {
    let Some(value) = signal.value else { return String::new() };
    let number = significant(Some(value), 4, language);
    match signal.form {
        SignalForm::Voltage => format!("{number} V"),
        SignalForm::PeakVoltage => format!("{number} V {}", encoder::at_peak(language)),
        SignalForm::Level if value.0 > 0.5 => encoder::high(language).to_owned(),
        SignalForm::Level => encoder::low(language).to_owned(),
        SignalForm::Share => format!("{number} {}", encoder::of_amplitude(language)),
        SignalForm::Other => String::new(),
    }
}

fn of_word(chapter: &mut Chapter, decoded: &DecodedWord, language: Language) {
    chapter.section(capitalised(&encoder::decoded(&decoded.bits, language)));
    if let Some(title) = &decoded.title {
        chapter.text(title.clone());
    }
    if let Some(angle) = decoded.angle_deg {
        let turns = decoded.turns.map_or_else(|| String::from("–"), |turns| turns.to_string());
        chapter.text(encoder::decoded_position(&turns, &significant(Some(angle), 7, language), language));
    }
    let fault = |fault: &WordFault| match &fault.hint {
        Some(hint) => format!("{}; {hint}", fault.message),
        None => fault.message.clone(),
    };
    if decoded.valid {
        chapter.text(encoder::word_is_right(language));
    } else {
        chapter.points(decoded.faults.iter().map(fault).collect());
    }
}
