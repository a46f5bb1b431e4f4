//! Remarks on the checks of heat, brake, feedback and accuracy.

use super::either;
use super::results::with_unit;
use quantities::unit::{
    ARCMINUTE, DEGREE, DEGREE_CELSIUS, JOULE, MILLIMETRE, MINUTE, REVOLUTION_PER_MINUTE, SECOND, WATT, YEAR,
};
use quantities::{Language, Measure, format_number, format_significant};
use sizing::Note;

/// Heat and energy.
pub(super) fn heat(note: &Note, language: Language) -> String {
    match note {
        Note::Housing(temperature) => {
            let housing = with_unit(temperature.si(), &DEGREE_CELSIUS, 3, language);
            either(
                language,
                format!(
                    "the housing reaches {housing} in the steady cycle; both are estimates for the plate of table 13.3"
                ),
                format!(
                    "das Gehäuse erreicht im Beharrungszustand {housing}; beides sind Schätzungen für die Platte nach Tabelle 13.3"
                ),
            )
        }
        Note::WarmUp(Some(time)) => {
            let time = with_unit(time.si(), &MINUTE, 2, language);
            either(
                language,
                format!("from cold the winding reaches its warning threshold of 80 °C after about {time}"),
                format!("aus dem Kalten erreicht die Wicklung ihre Warnschwelle von 80 °C nach etwa {time}"),
            )
        }
        Note::EnergyPerCycle { motoring, regenerated, peak } => {
            let joule = |si| with_unit(si, &JOULE, 3, language);
            let (taken, given) = (joule(motoring.si()), joule(regenerated.si()));
            if regenerated.si() == 0.0 {
                return either(
                    language,
                    format!("one cycle takes {taken} at the motor terminals and gives nothing back"),
                    format!("ein Zyklus nimmt an den Motorklemmen {taken} auf und gibt nichts zurück"),
                );
            }
            let peak = with_unit(peak.si(), &WATT, 3, language);
            either(
                language,
                format!("one cycle takes {taken} at the motor terminals and gives {given} back, {peak} at most"),
                format!("ein Zyklus nimmt an den Motorklemmen {taken} auf und gibt {given} zurück, höchstens {peak}"),
            )
        }
        Note::Capacitor { energy, capacitance_f } => {
            let energy = with_unit(energy.si(), &JOULE, 3, language);
            let millifarad = format_significant(capacitance_f * 1e3, 3, language);
            either(
                language,
                format!(
                    "at a stretch {energy} come back: instead of a brake resistor a capacitor bank of {millifarad} mF holds them within the stated rise of the DC link voltage"
                ),
                format!(
                    "am Stück kommen {energy} zurück: statt eines Bremswiderstands nimmt sie eine Kondensatorbatterie von {millifarad} mF im angegebenen Anstieg der Zwischenkreisspannung auf"
                ),
            )
        }
        _ => String::new(),
    }
}

/// Estimates: friction at which temperature, edges of a band.
pub(super) fn estimate(note: &Note, language: Language) -> String {
    let celsius = |si| with_unit(si, &DEGREE_CELSIUS, 3, language);
    match note {
        Note::FrictionTemperatures { cold, settled: Some(settled) } => {
            let (cold, settled) = (celsius(cold.si()), celsius(settled.si()));
            either(
                language,
                format!(
                    "friction counts with a cold gear ({cold}) and with one as warm as the cycle makes it ({settled}); the larger current decides"
                ),
                format!(
                    "die Reibung zählt mit kaltem Getriebe ({cold}) und mit einem so warmen, wie der Zyklus es macht ({settled}); der größere Strom entscheidet"
                ),
            )
        }
        Note::FrictionTemperatures { cold, settled: None } => {
            let cold = celsius(cold.si());
            either(
                language,
                format!(
                    "friction counts with a cold gear ({cold}) and with one of 80 °C, for want of a heat model; the larger current decides"
                ),
                format!(
                    "die Reibung zählt mit kaltem Getriebe ({cold}) und, mangels Wärmemodell, mit einem von 80 °C; der größere Strom entscheidet"
                ),
            )
        }
        Note::FrictionExtrapolated { low, high } => {
            let factor = |value: f64| format_significant(value, 2, language);
            let (low, high) = (factor(*low), factor(*high));
            either(
                language,
                format!(
                    "below 20 °C no friction is printed: it is extrapolated and may be {low} to {high} times what is counted"
                ),
                format!(
                    "unter 20 °C ist keine Reibung angegeben: sie ist extrapoliert und kann das {low}- bis {high}-Fache des Gerechneten sein"
                ),
            )
        }
        Note::UntilWarm => either(
            language,
            "only the cold gear asks for more than the limit: until it is warm the drive will limit the current",
            "nur das kalte Getriebe verlangt mehr als die Grenze: bis es warm ist, wird der Regler den Strom begrenzen",
        ),
        Note::EstimatedUpTo(upper) => {
            let upper = with_unit(upper.si, upper.unit, 3, language);
            either(
                language,
                format!(
                    "no curve is published for this actuator: the limit is the lower edge of an estimate that reaches up to {upper}"
                ),
                format!(
                    "für diesen Antrieb ist keine Kennlinie veröffentlicht: die Grenze ist der untere Rand einer Schätzung, die bis {upper} reicht"
                ),
            )
        }
        Note::InsideBand => either(
            language,
            "the value lies inside the band of an estimate: ask the maker, or give a curve",
            "der Wert liegt im Band einer Schätzung: beim Hersteller fragen oder eine Kennlinie angeben",
        ),
        Note::RiseAbove(ambient) => {
            let ambient = celsius(ambient.si());
            either(
                language,
                format!("the utilisation is that of the rise above {ambient}"),
                format!("die Auslastung ist die der Erwärmung über {ambient}"),
            )
        }
        _ => String::new(),
    }
}

/// The brake.
pub(super) fn brake(note: &Note, language: Language) -> String {
    match note {
        Note::HangingLoad => either(
            language,
            "the load hangs: a built-in holding brake is no safety brake; persons under it need a further, mechanical one",
            "hängende Last: eine eingebaute Haltebremse ist nicht funktional sicher; zum Schutz von Personen ist eine weitere, mechanische Bremse nötig",
        ),
        Note::Sag(angle) => {
            let angle = with_unit(angle.si(), &DEGREE, 2, language);
            either(
                language,
                format!("while the brake closes and nothing else holds, the load sags by up to {angle}"),
                format!("während die Bremse schließt und nichts sonst hält, sackt die Last bis zu {angle} ab"),
            )
        }
        Note::BrakeStop { angle, time, energy, permitted } => {
            let (angle, time) =
                (with_unit(angle.si(), &DEGREE, 3, language), with_unit(time.si(), &SECOND, 2, language));
            let energy = with_unit(energy.si(), &JOULE, 3, language);
            let count = permitted.map_or_else(
                || {
                    either(
                        language,
                        "how many are permitted is not printed",
                        "wie viele zulässig sind, ist nicht gedruckt",
                    )
                },
                |count| {
                    let count = format_number(count, 0, language);
                    either(
                        language,
                        format!("{count} are permitted in all"),
                        format!("insgesamt zulässig sind {count}"),
                    )
                },
            );
            either(
                language,
                format!(
                    "from the peak speed the brake alone stops the axis within {angle} and {time}, with {energy}; {count}"
                ),
                format!(
                    "aus der Spitzendrehzahl hält die Bremse allein die Achse in {angle} und {time} an, mit {energy}; {count}"
                ),
            )
        }
        Note::BrakeDoesNotStop => either(
            language,
            "the load drives harder than the brake holds: it does not stop the axis",
            "die Last treibt stärker, als die Bremse hält: sie bringt die Achse nicht zum Stehen",
        ),
        Note::NothingHolds => either(
            language,
            "in a dwell with hold = \"free\" the load stays only where friction is at least what moves it",
            "im Stillstand mit hold = \"free\" bleibt die Last nur, wo die Reibung mindestens so groß ist wie das, was sie bewegt",
        ),
        Note::NoBrake => either(
            language,
            "the motion is held by a brake, which this actuator does not have",
            "die Bewegung wird von einer Bremse gehalten, die dieser Antrieb nicht hat",
        ),
        _ => String::new(),
    }
}

/// Feedback, accuracy, application.
pub(super) fn rest(note: &Note, language: Language) -> String {
    match note {
        Note::ReferenceLost => either(
            language,
            "the axis turns on and on: where the encoder's turns overflow its absolute reference is lost, since 4096/i is no whole number",
            "die Achse dreht endlos: beim Überlauf der Geberumdrehungen geht der absolute Bezug verloren, da 4096/i keine ganze Zahl ist",
        ),
        Note::NeedsReferencing => either(
            language,
            "the position is not absolute over the travel: it must be searched after switching on",
            "die Lage ist über den Weg nicht absolut: nach dem Einschalten muss referenziert werden",
        ),
        Note::BatteryExchange { recommended, latest } => {
            let year = |si| with_unit(si, &YEAR, 2, language);
            let (recommended, latest) = (year(recommended.si()), year(latest.si()));
            either(
                language,
                format!(
                    "the encoder with its battery should be exchanged after {recommended}, at the latest {latest} after delivery"
                ),
                format!(
                    "der Geber mit seiner Batterie ist nach {recommended} zu tauschen (empfohlen), spätestens {latest} nach Lieferung"
                ),
            )
        }
        Note::ApprovalNeeded => either(
            language,
            "this field of application needs a risk assessment and the maker's approval (section 2.4)",
            "dieser Anwendungsbereich braucht eine Risikobewertung und die Freigabe des Herstellers (Abschnitt 2.4)",
        ),
        Note::CollisionsPermitted(count) => {
            let count = format_number(count.floor(), 0, language);
            either(
                language,
                format!("{count} collisions of this duration are permitted at the peak speed"),
                format!("bei Spitzendrehzahl sind {count} Kollisionen dieser Dauer zulässig"),
            )
        }
        Note::ResonanceSpeeds(speeds) => {
            let shown: Vec<String> =
                speeds.iter().map(|speed| with_unit(speed.si(), &REVOLUTION_PER_MINUTE, 3, language)).collect();
            let shown = shown.join(", ");
            either(
                language,
                format!(
                    "the wave generator excites the load at {shown} (three regions of stiffness); do not dwell there"
                ),
                format!(
                    "der Wave Generator regt die Last bei {shown} an (drei Steifigkeitsbereiche); dort nicht verweilen"
                ),
            )
        }
        Note::Budget { root_sum_square, deviation, missing } => {
            let root = with_unit(root_sum_square.si(), &ARCMINUTE, 3, language);
            let at_lever = deviation.map_or_else(String::new, |deviation| {
                let deviation = with_unit(deviation.si(), &MILLIMETRE, 3, language);
                either(language, format!(", {deviation} at the lever arm"), format!(", {deviation} am Hebelarm"))
            });
            let open = match missing {
                0 => String::new(),
                count => either(
                    language,
                    format!("; {count} contributions are not known"),
                    format!("; {count} Beiträge sind nicht bekannt"),
                ),
            };
            either(
                language,
                format!("sum of all contributions{at_lever}; root of their squares {root}{open}"),
                format!("Summe aller Beiträge{at_lever}; Wurzel der Quadratsumme {root}{open}"),
            )
        }
        _ => String::new(),
    }
}
