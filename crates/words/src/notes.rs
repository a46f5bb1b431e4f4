//! Remarks on the checks.

use super::results::{evidence_text, with_unit};
use crate::texts::said;
use quantities::unit::{
    ARCMINUTE, DEGREE, DEGREE_CELSIUS, HERTZ, HOUR, JOULE, MILLIMETRE, MINUTE, NEWTON_METRE, REVOLUTION_PER_MINUTE,
    SECOND, VOLT, WATT, YEAR,
};
use quantities::{Angle, AngularVelocity, Language, Measure, Torque, format_number, format_significant};
use sizing::{BrakeStop, Budget, Note, ResonanceSpeeds};

/// A remark on a check.
#[must_use]
pub fn note_text(note: &Note, language: Language) -> String {
    let celsius = |si| with_unit(si, &DEGREE_CELSIUS, 3, language);
    match note {
        Note::CycleNotShort { cycle, time_constant } => {
            let cycle = with_unit(cycle.si(), &SECOND, 3, language);
            let tau = with_unit(time_constant.si(), &SECOND, 2, language);
            said!(language =>
                "the cycle of {cycle} is not short against the winding's time constant of about {tau}: the rms torque alone does not show whether the winding stays cool enough"
                | "der Zyklus von {cycle} ist nicht kurz gegen die Wicklungszeitkonstante von etwa {tau}: aus dem effektiven Drehmoment allein folgt nicht, ob die Wicklung kühl genug bleibt"
            )
        }
        Note::BrakingTorqueAssumed => said!(language =>
            "braking and accelerating times differ: eq. 69.2 would take T_3 from the accelerating time; the exact integral decides"
            | "Brems- und Beschleunigungszeit sind verschieden: Gl. 69.2 nähme T_3 aus der Beschleunigungszeit; es entscheidet das exakte Integral"
        ),
        Note::RecommendationForHighDynamics { factor } => {
            let factor = format_number(*factor, usize::from(factor.fract() != 0.0), language);
            said!(language =>
                "J_L ≤ {factor} J_out is a recommendation for highly dynamic duty, not a limit"
                | "J_L ≤ {factor} J_out ist eine Empfehlung für hochdynamischen Betrieb, keine Grenze"
            )
        }
        Note::SwingTooSmall { swing, least } => {
            let least = with_unit(least.si(), &DEGREE, 3, language);
            let swing = with_unit(swing.si(), &DEGREE, 3, language);
            said!(language =>
                "the axis swings by {swing} only; below {least} the bearing may fret, ask the maker"
                | "die Achse schwenkt nur um {swing}; unter {least} droht Reibkorrosion, beim Hersteller fragen"
            )
        }
        Note::SmallSwings { count, largest, share, least } => {
            small_swings(*count, [*largest, *least], *share, language)
        }
        Note::RatingOfInterchangeableGear => said!(language =>
            "the gear's rating is that of another maker's interchangeable gear with the same T_R; the manual states none"
            | "die Getriebewerte sind die eines austauschbaren Getriebes eines anderen Herstellers mit gleichem T_R; die Anleitung nennt keine"
        ),
        Note::LoadsOneAtATime => said!(language =>
            "the permissible forces hold one at a time; for several together life and static safety decide"
            | "die zulässigen Kräfte gelten je für sich; bei mehreren zugleich entscheiden Lebensdauer und statische Sicherheit"
        ),
        Note::Housing(temperature) => {
            let housing = with_unit(temperature.si(), &DEGREE_CELSIUS, 3, language);
            said!(language =>
                "the housing reaches {housing} in the steady cycle; both are estimates for the plate of table 13.3"
                | "das Gehäuse erreicht im Beharrungszustand {housing}; beides sind Schätzungen für die Platte nach Tabelle 13.3"
            )
        }
        Note::WarmUp(time) => {
            let time = with_unit(time.si(), &MINUTE, 2, language);
            said!(language =>
                "from cold the winding reaches its warning threshold of 80 °C after about {time}"
                | "aus dem Kalten erreicht die Wicklung ihre Warnschwelle von 80 °C nach etwa {time}"
            )
        }
        Note::EnergyPerCycle { motoring, regenerated, peak } => {
            let joule = |si| with_unit(si, &JOULE, 3, language);
            let (taken, given) = (joule(motoring.si()), joule(regenerated.si()));
            if regenerated.si() == 0.0 {
                return said!(language =>
                    "one cycle takes {taken} at the motor terminals and gives nothing back"
                    | "ein Zyklus nimmt an den Motorklemmen {taken} auf und gibt nichts zurück"
                );
            }
            let peak = with_unit(peak.si(), &WATT, 3, language);
            said!(language =>
                "one cycle takes {taken} at the motor terminals and gives {given} back, {peak} at most"
                | "ein Zyklus nimmt an den Motorklemmen {taken} auf und gibt {given} zurück, höchstens {peak}"
            )
        }
        Note::Capacitor { energy, capacitance_f } => {
            let energy = with_unit(energy.si(), &JOULE, 3, language);
            let millifarad = format_significant(capacitance_f * 1e3, 3, language);
            said!(language =>
                "at a stretch {energy} come back: instead of a brake resistor a capacitor bank of {millifarad} mF holds them within the stated rise of the DC link voltage"
                | "am Stück kommen {energy} zurück: statt eines Bremswiderstands nimmt sie eine Kondensatorbatterie von {millifarad} mF im angegebenen Anstieg der Zwischenkreisspannung auf"
            )
        }
        Note::DcLinkRises { to, free } => {
            let volt = |si| with_unit(si, &VOLT, 3, language);
            let (to, free) = (volt(to.si()), volt(free.si()));
            said!(language =>
                "with the stated rise the DC link reaches {to}. U_DCmax is the largest stationary voltage and may be exceeded for a short time while braking; by how much is not stated: ask the maker, or permit a rise of {free} at most"
                | "mit dem angegebenen Anstieg erreicht der Zwischenkreis {to}. U_DCmax ist die größte stationäre Spannung und darf im Bremsbetrieb kurzfristig überschritten werden; um wie viel, ist nicht angegeben: beim Hersteller fragen oder höchstens {free} Anstieg zulassen"
            )
        }
        Note::FrictionTemperatures { cold, settled: Some(settled) } => {
            let (cold, settled) = (celsius(cold.si()), celsius(settled.si()));
            said!(language =>
                "friction counts with a cold gear ({cold}) and with one as warm as the cycle makes it ({settled}); the larger current decides"
                | "die Reibung zählt mit kaltem Getriebe ({cold}) und mit einem so warmen, wie der Zyklus es macht ({settled}); der größere Strom entscheidet"
            )
        }
        Note::FrictionTemperatures { cold, settled: None } => {
            let cold = celsius(cold.si());
            said!(language =>
                "friction is calculated for a cold gear ({cold}) and, without a heat model, for a gear of 80 °C; the larger current counts"
                | "Reibung gerechnet mit kaltem Getriebe ({cold}) und, ohne Wärmemodell, mit 80 °C; der größere Strom ist maßgebend"
            )
        }
        Note::FrictionExtrapolated { low, high } => {
            let factor = |value: f64| format_significant(value, 2, language);
            let (low, high) = (factor(*low), factor(*high));
            said!(language =>
                "below 20 °C no friction is stated: it is extrapolated and may be {low} to {high} times what is counted"
                | "unter 20 °C ist keine Reibung angegeben: sie ist extrapoliert und kann das {low}- bis {high}-Fache des Gerechneten sein"
            )
        }
        Note::UntilWarm => said!(language =>
            "only the cold gear exceeds the limit: until it is warm the drive limits the current"
            | "nur mit kaltem Getriebe überschritten: bis es warm ist, begrenzt der Regler den Strom"
        ),
        Note::EstimatedUpTo(upper) => {
            let upper = with_unit(upper.si, upper.unit, 3, language);
            said!(language =>
                "no curve is published for this actuator: the limit is the lower edge of an estimate that reaches up to {upper}"
                | "für diesen Antrieb ist keine Kennlinie veröffentlicht: die Grenze ist der untere Rand einer Schätzung, die bis {upper} reicht"
            )
        }
        Note::InsideBand => said!(language =>
            "the value lies inside the band of an estimate: ask the maker, or give a curve"
            | "der Wert liegt im Band einer Schätzung: beim Hersteller fragen oder eine Kennlinie angeben"
        ),
        Note::RiseAbove(ambient) => {
            let ambient = celsius(ambient.si());
            said!(language =>
                "the utilisation is that of the rise above {ambient}"
                | "die Auslastung ist die der Erwärmung über {ambient}"
            )
        }
        Note::HangingLoad => said!(language =>
            "the load hangs: a built-in holding brake is not a safety brake; persons under it need a further, mechanical one"
            | "hängende Last: eine eingebaute Haltebremse ist nicht funktional sicher; zum Schutz von Personen ist eine weitere, mechanische Bremse nötig"
        ),
        Note::Sag(angle) => {
            let angle = with_unit(angle.si(), &DEGREE, 2, language);
            said!(language =>
                "while the brake closes and nothing else holds, the load sags by up to {angle}"
                | "während die Bremse schließt und nichts sonst hält, sackt die Last bis zu {angle} ab"
            )
        }
        Note::BrakeStop(stop) => {
            let BrakeStop { angle, time, energy, permitted } = &**stop;
            let (angle, time) =
                (with_unit(angle.si(), &DEGREE, 3, language), with_unit(time.si(), &SECOND, 2, language));
            let energy = with_unit(energy.si(), &JOULE, 3, language);
            let count = permitted.map_or_else(
                || {
                    said!(language =>
                        "the maker does not state how many are permitted"
                        | "wie viele zulässig sind, ist nicht angegeben"
                    )
                },
                |count| {
                    let count = format_number(count, 0, language);
                    said!(language => "{count} are permitted in all" | "insgesamt zulässig sind {count}")
                },
            );
            said!(language =>
                "from the peak speed the brake alone stops the axis within {angle} and {time}, with {energy}; {count}"
                | "aus der Spitzendrehzahl hält die Bremse allein die Achse in {angle} und {time} an, mit {energy}; {count}"
            )
        }
        Note::BrakeDoesNotStop => said!(language =>
            "the load drives harder than the brake holds: it does not stop the axis"
            | "die Last treibt stärker, als die Bremse hält: sie bringt die Achse nicht zum Stehen"
        ),
        Note::NothingHolds => said!(language =>
            "in a dwell with hold = \"free\" the load stays only where friction is at least what moves it"
            | "im Stillstand mit hold = \"free\" bleibt die Last nur, wo die Reibung mindestens so groß ist wie das, was sie bewegt"
        ),
        Note::NothingHoldsWithoutPower => said!(language =>
            "the load hangs and this actuator has no brake: without power nothing holds the load. Choose one with brake, or hold the load by other means"
            | "hängende Last, und dieser Antrieb hat keine Bremse: stromlos hält nichts die Last. Einen Antrieb mit Bremse wählen oder die Last anders halten"
        ),
        Note::DwellTooShortForBrake { shortest, needed } => {
            let second = |si| with_unit(si, &SECOND, 3, language);
            let (shortest, needed) = (second(shortest.si()), second(needed.si()));
            said!(language =>
                "a dwell of {shortest} is too short for the brake, which takes {needed} to close and to open: the motor holds the load for all of it"
                | "ein Stillstand von {shortest} ist zu kurz für die Bremse, die zum Schließen und Öffnen {needed} braucht: der Motor hält die Last die ganze Zeit"
            )
        }
        Note::BrakeTimesAssumed => said!(language =>
            "opening and closing time of this brake are not stated: while it closes and opens the motor holds the load for 70 ms and 110 ms, as stated for the larger sizes"
            | "Öffnungs- und Schließzeit dieser Bremse sind nicht angegeben: beim Schließen und Öffnen hält der Motor die Last 70 ms und 110 ms lang, wie für die größeren Baugrößen angegeben"
        ),
        Note::BrakingsLast { each_cycle, lasts } => {
            let times = match (format_number(*each_cycle, 0, language), language) {
                (count, Language::En) if count == "1" => "once".to_owned(),
                (count, Language::En) => format!("{count} times"),
                (count, Language::De) if count == "1" => "einmal".to_owned(),
                (count, Language::De) => format!("{count}-mal"),
            };
            let Some(lasts) = lasts else {
                return said!(language =>
                    "the brake closes {times} per cycle; how often it may is not stated"
                    | "die Bremse schließt {times} je Zyklus; wie oft sie es darf, ist nicht angegeben"
                );
            };
            let hours = with_unit(lasts.si(), &HOUR, 3, language);
            said!(language =>
                "the brake closes {times} per cycle: the permitted number of brakings lasts {hours} of operation"
                | "die Bremse schließt {times} je Zyklus: die zulässige Zahl der Bremsungen reicht für {hours} Betrieb"
            )
        }
        Note::NoBrake => said!(language =>
            "the motion is held by a brake, which this actuator does not have"
            | "die Bewegung wird von einer Bremse gehalten, die dieser Antrieb nicht hat"
        ),
        Note::ReferenceLost { turns } if *turns <= 1.0 => said!(language =>
            "the axis turns endlessly: the encoder is absolute within one turn of the motor only, and the absolute reference is lost, since 1/i is not a whole number"
            | "die Achse dreht endlos: der Geber ist nur innerhalb einer Motorumdrehung absolut, der absolute Bezug geht verloren, da 1/i keine ganze Zahl ist"
        ),
        Note::ReferenceLost { turns } => {
            let turns = format_number(*turns, 0, language);
            said!(language =>
                "the axis turns endlessly: where the encoder's turns overflow its absolute reference is lost, since {turns}/i is not a whole number"
                | "die Achse dreht endlos: beim Überlauf der Geberumdrehungen geht der absolute Bezug verloren, da {turns}/i keine ganze Zahl ist"
            )
        }
        Note::NeedsReferencing => said!(language =>
            "the position is not absolute over the travel: it must be referenced after switching on"
            | "die Lage ist über den Weg nicht absolut: nach dem Einschalten muss referenziert werden"
        ),
        Note::BatteryExchange { recommended, latest } => {
            let year = |si| with_unit(si, &YEAR, 2, language);
            let (recommended, latest) = (year(recommended.si()), year(latest.si()));
            said!(language =>
                "the encoder with its battery should be exchanged after {recommended}, at the latest {latest} after delivery"
                | "der Geber mit seiner Batterie ist nach {recommended} zu tauschen (empfohlen), spätestens {latest} nach Lieferung"
            )
        }
        Note::ApprovalNeeded => said!(language =>
            "this field of application needs a risk assessment and the maker's approval (section 2.4)"
            | "dieser Anwendungsbereich braucht eine Risikobewertung und die Freigabe des Herstellers (Abschnitt 2.4)"
        ),
        Note::CollisionsPermitted(count) => {
            let count = format_number(count.floor(), 0, language);
            said!(language =>
                "{count} collisions of this duration are permitted at the peak speed"
                | "bei Spitzendrehzahl sind {count} Kollisionen dieser Dauer zulässig"
            )
        }
        Note::ResonanceSpeeds(speeds) => {
            let ResonanceSpeeds { blocked, free } = &**speeds;
            let shown = |speeds: &[(AngularVelocity, AngularVelocity); 3]| {
                let number =
                    |speed: AngularVelocity| format_significant(REVOLUTION_PER_MINUTE.from_si(speed.si()), 3, language);
                let each = speeds.iter().map(|(low, high)| match (number(*low), number(*high)) {
                    (low, high) if low == high => low,
                    (low, high) => format!("{low}…{high}"),
                });
                let each = each.collect::<Vec<_>>().join(said!(language => ", " | "; ").as_str());
                format!("{each} {}", REVOLUTION_PER_MINUTE.symbol)
            };
            let held = shown(blocked);
            let free = free.as_ref().map_or_else(String::new, |free| {
                let free = shown(free);
                said!(language => ", with a free rotor at {free}" | ", bei freiem Rotor bei {free}")
            });
            said!(language =>
                "the wave generator excites the load at {held} with the rotor held{free} (three regions of stiffness); do not dwell there"
                | "der Wave Generator regt die Last bei festgehaltenem Rotor bei {held} an{free} (drei Steifigkeitsbereiche); dort nicht verweilen"
            )
        }
        Note::Ratcheting { ratcheting, buckling } => {
            let torque = |torque: &Torque| with_unit(torque.si(), &NEWTON_METRE, 3, language);
            let ratchets = torque(ratcheting);
            let buckles = buckling.as_ref().map_or_else(String::new, |buckling| {
                let buckles = torque(buckling);
                said!(language => ", its flexspline buckles at {buckles}" | ", sein Flexspline beult bei {buckles}")
            });
            said!(language =>
                "a cup-type gear of this size ratchets at {ratchets}{buckles}; for orientation, the hollow-shaft gear has another flexspline"
                | "ein Topfgetriebe dieser Baugröße ratscht bei {ratchets}{buckles}; nur zur Orientierung, das Hohlwellengetriebe hat einen anderen Flexspline"
            )
        }
        Note::FreeRotor(frequency) => {
            let frequency = with_unit(frequency.si(), &HERTZ, 3, language);
            said!(language =>
                "that is with the rotor held; a free rotor and the load swing against each other at {frequency}"
                | "das gilt bei festgehaltenem Rotor; freier Rotor und Last schwingen mit {frequency} gegeneinander"
            )
        }
        Note::Budget(budget) => {
            let Budget { root_sum_square, deviation, missing } = &**budget;
            let root = with_unit(root_sum_square.si(), &ARCMINUTE, 3, language);
            let at_lever = deviation.map_or_else(String::new, |deviation| {
                let deviation = with_unit(deviation.si(), &MILLIMETRE, 3, language);
                said!(language => ", {deviation} at the lever arm" | ", {deviation} am Hebelarm")
            });
            let open = match missing {
                0 => String::new(),
                1 => said!(language => "; one contribution is not known" | "; ein Beitrag ist nicht bekannt"),
                count => {
                    said!(language => "; {count} contributions are not known" | "; {count} Beiträge sind nicht bekannt")
                }
            };
            said!(language =>
                "sum of all contributions{at_lever}; root of their squares {root}{open}"
                | "Summe aller Beiträge{at_lever}; Wurzel der Quadratsumme {root}{open}"
            )
        }
        Note::Erratum(id) => {
            let evidence = evidence_text(id, language);
            said!(language => "erratum {id}: {evidence}" | "Druckfehler {id}: {evidence}")
        }
    }
}

/// The remark on small swings among larger ones.
pub(super) fn small_swings(count: usize, angles: [Angle; 2], share: f64, language: Language) -> String {
    let [largest, least] = angles.map(|angle| with_unit(angle.si(), &DEGREE, 3, language));
    let share = format_number(share * 100.0, 0, language);
    said!(language =>
        "{count} swings of up to {largest} in each cycle, {share} % of all travel; below {least} the bearing may fret, ask the maker"
        | "{count} Schwenkungen bis {largest} je Zyklus, {share} % des gesamten Wegs; unter {least} droht Reibkorrosion, beim Hersteller fragen"
    )
}
