//! Assumptions about the samples of a recording: noise of a torque, samples that are far apart, single values far beside the others.

use crate::texts::said;
use motion::{OutlyingColumn, OutlyingValues, SparseSamples};
use quantities::unit::{DEGREE, MILLISECOND, NEWTON_METRE, REVOLUTION_PER_MINUTE, SECOND};
use quantities::{Language, Unit, format_significant, with_symbol};

pub(crate) fn torque_noise(deviation_nm: f64, language: Language) -> String {
    let of = |torque: f64| figure(torque, &NEWTON_METRE, language);
    let (noise, peak) = (of(deviation_nm), of(3.5 * deviation_nm));
    said!(language =>
        "the recorded torque has noise of {noise} (standard deviation), which adds up to {peak} to T_peak, and {noise} to T_rms by its square; smoothing = \"…\" reduces it"
        | "das aufgezeichnete Drehmoment hat Rauschen von {noise} (Standardabweichung), das T_peak um bis zu {peak} erhöht und mit {noise} quadratisch in T_rms eingeht; smoothing = \"…\" verringert es"
    )
}

/// Describes values of a recording far beside those before and behind.
pub(crate) fn outliers(found: &OutlyingValues, language: Language) -> String {
    let (column, value) = match found.column {
        OutlyingColumn::Position => {
            (said!(language => "position" | "Position"), figure(found.value, &DEGREE, language))
        }
        OutlyingColumn::Speed => {
            (said!(language => "speed" | "Drehzahl"), figure(found.value, &REVOLUTION_PER_MINUTE, language))
        }
        OutlyingColumn::Torque => {
            (said!(language => "torque" | "Drehmoment"), figure(found.value, &NEWTON_METRE, language))
        }
    };
    let time = figure(found.time_s, &SECOND, language);
    said!(language =>
        "the recorded {column} has values far from those before and after ({}, the farthest {value} at {time} from its beginning); they are used, and a single peak determines the actuator: delete the rows of recording errors"
        | "die Aufzeichnung ({column}) hat Werte weit neben den Werten davor und danach ({}, der äußerste {value} bei {time} ab ihrem Beginn); sie werden verwendet, und eine Spitze entscheidet über den Antrieb: Zeilen mit Aufzeichnungsfehlern löschen",
        found.count
    )
}

/// Describes samples that are too far apart for the acceleration of their motion.
pub(crate) fn sparse(sparse: SparseSamples, language: Language) -> String {
    let interval = figure(sparse.interval_s, &MILLISECOND, language);
    let more = format_significant(100.0 * sparse.share / (1.0 - sparse.share), 2, language);
    said!(language =>
        "the samples of the recording are {interval} apart, too far for its motion: by differences over them the effective acceleration is estimated to be {more} % larger than computed, and so is its torque; record at shorter intervals, or record the speed too"
        | "die Abtastwerte der Aufzeichnung liegen {interval} auseinander, für ihre Bewegung zu weit: die effektive Beschleunigung ist nach Differenzen über mehrere davon schätzungsweise um {more} % größer als gerechnet, ebenso ihr Drehmoment; in kürzeren Abständen aufzeichnen oder die Drehzahl mit aufzeichnen"
    )
}

pub(crate) fn figure(si: f64, unit: &'static Unit, language: Language) -> String {
    with_symbol(&format_significant(unit.from_si(si), 3, language), unit.symbol_in(language))
}
