//! Every term that the manual explains in its chapter 11.1 is in the glossary and found by the manual's own word.
#![allow(missing_docs, clippy::unwrap_used, reason = "a test fails loudly")]

use installation::commission::ParameterId;
use quantities::Language;
use questions::list::commission::commission;
use questions::list::glossary::glossary;
use questions::list::mount::{MountInputs, mount};
use questions::{answer, read_code};

/// The headings of chapter 11.1 in their order, each with our symbol. One that the print gives twice, for grease and oil or for
/// two kinds of gears, stands once; the three stiffnesses of one heading stand each.
const HEADINGS: [(&str, &str); 66] = [
    ("Abstand R", "R"),
    ("AC-Spannungskonstante", "k_EM"),
    ("Baugröße", "size"),
    ("Bemessungsdrehmoment", "T_rated"),
    ("Bemessungsdrehzahl", "n_rated"),
    ("Bemessungsleistung", "P_N"),
    ("Bemessungsspannung", "U_N"),
    ("Bemessungsstrom", "I_N"),
    ("Bremsenspannung", "U_Br"),
    ("Drehfeldinduktivität", "L_d"),
    ("Drehmomentkonstante (Abtrieb)", "k_Tout"),
    ("Drehmomentkonstante (Motor)", "k_TM"),
    ("Durchschnittsdrehmoment", "T_A"),
    ("Dynamische Axiallast", "F_A_dyn_max"),
    ("Dynamisches Kippmoment", "M_dyn_max"),
    ("Dynamische Radiallast", "F_R_dyn_max"),
    ("Dynamische Tragzahl", "C"),
    ("Elektrische Zeitkonstante", "tau_e"),
    ("Entmagnetisierungsstrom", "I_E"),
    ("Gewicht", "m"),
    ("Haltemoment der Bremse", "T_Br"),
    ("Haltestrom der Bremse", "I_HBr"),
    ("Hohlwellendurchmesser", "d_H"),
    ("Hystereseverlust", "hysteresis_loss"),
    ("Induktivität (L-L)", "L_LL"),
    ("Kippsteifigkeit", "K_B"),
    ("Kollisionsdrehmoment", "T_M"),
    ("Lost Motion", "lost_motion"),
    ("Massenträgheitsmoment J", "J"),
    ("Massenträgheitsmoment J_in", "J_in"),
    ("Massenträgheitsmoment J_out", "J_out"),
    ("Maximale Antriebsdrehzahl", "n_in_max"),
    ("Maximale Drehzahl", "n_max"),
    ("Maximales Drehmoment", "T_max"),
    ("Maximaler Hohlwellendurchmesser", "d_H_max"),
    ("Maximale Leistung", "P_max"),
    ("Maximale stationäre Zwischenkreisspannung", "U_DCmax"),
    ("Maximalstrom", "I_max"),
    ("Mechanische Zeitkonstante", "tau_m"),
    ("Mittlere Antriebsdrehzahl", "n_in_av"),
    ("Motor Bemessungsdrehzahl", "n_N"),
    ("Motorklemmenspannung", "U_M"),
    ("Motor maximale Drehzahl", "n_mot_max"),
    ("Nenndrehmoment", "T_N"),
    ("Nenndrehzahl", "n_N_gear"),
    ("Nominelle Lebensdauer", "L_n"),
    ("Öffnungsstrom der Bremse", "I_OBr"),
    ("Öffnungszeit der Bremse", "t_o"),
    ("Polpaarzahl", "p"),
    ("Schließzeit der Bremse", "t_c"),
    ("Schutzart", "protection_class"),
    ("Spiel", "backlash"),
    ("Statische Tragzahl", "C_0"),
    ("Statisches Kippmoment", "M_0_max"),
    ("Stillstandsdrehmoment", "T_0"),
    ("Stillstandsstrom", "I_0"),
    ("Teilkreisdurchmesser", "d_p"),
    ("Torsionssteifigkeit", "K_1"),
    ("Torsionssteifigkeit", "K_2"),
    ("Torsionssteifigkeit", "K_3"),
    ("Umgebungstemperatur (Betrieb)", "ambient_temperature_operation"),
    ("Untersetzung", "i"),
    ("Übertragungsgenauigkeit", "transmission_accuracy"),
    ("Wiederholbares Spitzendrehmoment", "T_R"),
    ("Wiederholgenauigkeit", "repeatability"),
    ("Widerstand (L-L, 20 °C)", "R_LL"),
];

#[test]
fn every_term_of_the_manual_is_found_by_its_own_word() {
    for (heading, symbol) in HEADINGS {
        let found = glossary(Some(heading), Language::De).unwrap_or_default();
        let known = found.terms.iter().any(|term| term.symbol == symbol)
            || found.symbols.iter().any(|each| each.symbol == symbol);
        assert!(known, "{heading}: no {symbol}");
        assert!(catalogue::glossary().iter().any(|term| term.symbol == symbol), "{heading}: {symbol} is no term");
    }
    let mut headings: Vec<&str> = HEADINGS.iter().map(|(heading, _)| *heading).collect();
    headings.dedup();
    assert_eq!(headings.len(), 64, "the number of headings counted in the print");
}

/// The symbols that answers show beside those of the checks, which the tests of the derivations hold.
#[test]
fn every_symbol_of_an_answer_about_a_code_is_in_the_glossary() {
    let mut symbols: Vec<String> = ParameterId::ALL.iter().map(|id| id.symbol().to_owned()).collect();
    for text in ["CHA-25A-100-H-M512P-B", "CHA-14A-50-E-M128S", "CHA-20A-100-N-D2048", "CHA-32A-50-H-C1024-B-EC"] {
        let Ok(reading) = read_code(text, Language::En) else { continue };
        let code = reading.parsed.code;
        let asked = MountInputs::default();
        if let Some(found) = mount(&code, &asked) {
            let record = serde_json::to_value(answer::mount(&found, &asked, None, Language::En)).unwrap();
            collect(&record, &mut symbols);
        }
        let about = commission(&code).unwrap();
        let form = questions::list::commission::DriveForm::Plain;
        let sheet = answer::commissioning(&about, form, questions::list::commission::usual_ambient(), Language::En);
        collect(&serde_json::to_value(sheet).unwrap(), &mut symbols);
    }
    symbols.sort();
    symbols.dedup();
    assert!(symbols.len() > 50, "{symbols:?}");
    for symbol in symbols {
        let found = glossary(Some(&symbol), Language::En).unwrap_or_default();
        let known = found.terms.iter().any(|term| term.symbol == symbol)
            || found.symbols.iter().any(|each| each.symbol == symbol);
        assert!(known, "{symbol}");
    }
}

/// Every value of a key `symbol`.
fn collect(value: &serde_json::Value, found: &mut Vec<String>) {
    match value {
        serde_json::Value::Object(map) => {
            found.extend(map.get("symbol").and_then(serde_json::Value::as_str).map(str::to_owned));
            map.values().for_each(|value| collect(value, found));
        }
        serde_json::Value::Array(all) => all.iter().for_each(|value| collect(value, found)),
        _ => {}
    }
}
