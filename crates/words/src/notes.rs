//! Remarks on the checks.

use super::results::{evidence_text, with_unit};
use crate::erratum_place_of;
use crate::texts::said;
use crate::unpadded;
use mechanism::Rope;
use quantities::unit::{
    AMPERE, ARCMINUTE, DEGREE, DEGREE_CELSIUS, HERTZ, HOUR, JOULE, MILLIMETRE, MINUTE, NEWTON_METRE,
    REVOLUTION_PER_MINUTE, SECOND, VOLT, WATT, YEAR,
};
use quantities::{Angle, AngularVelocity, Language, Measure, Time, Torque, format_number, format_significant};
use sizing::{BrakeStop, Budget, Note, ResonanceSpeeds, RopeSlack};

/// Returns a remark on a check as text.
#[must_use]
pub fn note_text(note: &Note, language: Language) -> String {
    let celsius = |si| with_unit(si, &DEGREE_CELSIUS, 3, language);
    match note {
        Note::CycleNotShort { cycle, time_constant } => {
            let cycle = with_unit(cycle.si(), &SECOND, 3, language);
            let tau = with_unit(time_constant.si(), &SECOND, 2, language);
            said!(language =>
                "the cycle of {cycle} is not short compared with the winding time constant of about {tau}: the rms torque alone does not show whether the winding temperature remains permissible"
                | "der Zyklus von {cycle} ist nicht kurz gegenüber der Wicklungszeitkonstante von etwa {tau}: aus dem effektiven Drehmoment allein folgt nicht, ob die Wicklungstemperatur zulässig bleibt"
            )
        }
        Note::BrakingTorqueAssumed => said!(language =>
            "braking and acceleration times differ: eq. 69.2 would take T_3 from the acceleration time; the exact integral is used"
            | "Brems- und Beschleunigungszeit sind verschieden: Gl. 69.2 bildet T_3 aus der Beschleunigungszeit; maßgebend ist das exakte Integral"
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
                "the swivel angle is only {swing}; below {least} there is a risk of fretting corrosion in the bearing; ask the manufacturer"
                | "der Schwenkwinkel beträgt nur {swing}; unter {least} besteht die Gefahr von Reibkorrosion im Lager; beim Hersteller erfragen"
            )
        }
        Note::SmallSwings { count, largest, share, least } => {
            small_swings(*count, [*largest, *least], *share, language)
        }
        Note::RatingOfInterchangeableGear => said!(language =>
            "gear rating taken from an interchangeable gear of another manufacturer with the same T_R; the manual states none; for information only, no actuator is rejected by it"
            | "Getriebewerte eines baugleich einsetzbaren Getriebes eines anderen Herstellers mit gleichem T_R; die Anleitung nennt keine; nur zur Information, kein Antrieb wird dadurch ausgeschlossen"
        ),
        Note::RatingByStrongerGear => said!(language =>
            "gear rating estimated: rated torque of the manufacturer's stronger gear series divided by 1.3; the manual states none"
            | "Getriebewert geschätzt: Nenndrehmoment der stärkeren Getriebebaureihe des Herstellers geteilt durch 1,3; die Anleitung nennt keinen"
        ),
        Note::NotDeratedForAltitude => said!(language =>
            "not derated for the stated altitude; the derating is part of the check installation altitude"
            | "für die angegebene Aufstellhöhe nicht gemindert; die Minderung gehört zum Nachweis Aufstellhöhe"
        ),
        Note::DeratesThisCheckOnly => said!(language =>
            "the derating applies to the continuous torque in this check; continuous torque, winding temperature and overload I²t on their own are evaluated without it, as is the twin"
            | "die Minderung gilt für das Dauerdrehmoment in diesem Nachweis; die Nachweise Dauerdrehmoment, Wicklungstemperatur und Überlast I²t und der Zwilling rechnen ohne sie"
        ),
        Note::Protection { required, printed } => said!(language =>
            "required {required}, stated {printed}, each numeral compared separately; {printed} is achieved only with suitable mating connectors plugged in and undamaged shaft seals"
            | "gefordert {required}, angegeben {printed}, jede Kennziffer für sich verglichen; {printed} wird nur mit geeigneten, gesteckten Gegensteckern und unbeschädigten Wellendichtungen erreicht"
        ),
        Note::LoadsOneAtATime => said!(language =>
            "the permissible loads apply to each load acting alone; for combined loads, bearing life and static safety govern"
            | "die zulässigen Lasten gelten jeweils einzeln; bei kombinierter Belastung sind Lebensdauer und statische Sicherheit maßgebend"
        ),
        Note::AtOneInstant(alone) => {
            let alone = with_unit(alone.si, alone.unit, 3, language);
            said!(language =>
                "the largest radial force, axial force and tilting moment act at different instants and are combined, as the manufacturer does in a sister series; the worst single instant gives {alone}"
                | "größte Radialkraft, größte Axialkraft und größtes Kippmoment wirken zu verschiedenen Zeitpunkten und sind zusammengefasst, wie es der Hersteller bei einer verwandten Baureihe vorsieht; der ungünstigste einzelne Zeitpunkt ergibt {alone}"
            )
        }
        Note::RopeSlack(slack) => rope_slack(slack, language),
        Note::Housing(temperature) => {
            let housing = with_unit(temperature.si(), &DEGREE_CELSIUS, 3, language);
            said!(language =>
                "the housing reaches {housing} in thermal steady state; both are estimates for the plate of table 13.3"
                | "das Gehäuse erreicht im thermischen Beharrungszustand {housing}; beides sind Schätzungen für die Platte nach Tabelle 13.3"
            )
        }
        Note::WarmUp(time) => {
            let time = with_unit(time.si(), &MINUTE, 2, language);
            said!(language =>
                "from cold, the winding reaches its warning threshold of 80 °C after about {time}"
                | "aus kaltem Zustand erreicht die Wicklung ihre Warnschwelle von 80 °C nach etwa {time}"
            )
        }
        Note::EnergyPerCycle { motoring, regenerated, peak } => {
            let joule = |si| with_unit(si, &JOULE, 3, language);
            let (taken, given) = (joule(motoring.si()), joule(regenerated.si()));
            if regenerated.si() == 0.0 {
                return said!(language =>
                    "one cycle consumes {taken} at the motor terminals; no energy is regenerated"
                    | "ein Zyklus nimmt an den Motorklemmen {taken} auf; keine Rückspeisung"
                );
            }
            let peak = with_unit(peak.si(), &WATT, 3, language);
            said!(language =>
                "one cycle consumes {taken} at the motor terminals and regenerates {given}, at {peak} at most"
                | "ein Zyklus nimmt an den Motorklemmen {taken} auf und speist {given} zurück, mit höchstens {peak}"
            )
        }
        Note::Capacitor { energy, capacitance_f } => {
            let energy = with_unit(energy.si(), &JOULE, 3, language);
            let millifarad = format_significant(capacitance_f * 1e3, 3, language);
            said!(language =>
                "up to {energy} are regenerated at a time: instead of a braking resistor, a capacitor bank of {millifarad} mF absorbs this energy within the stated rise of the DC link voltage"
                | "zusammenhängend werden bis zu {energy} zurückgespeist: statt eines Bremswiderstands nimmt eine Kondensatorbatterie von {millifarad} mF diese Energie innerhalb des angegebenen Anstiegs der Zwischenkreisspannung auf"
            )
        }
        Note::TripsAtStallCurrent(current) => {
            let current = with_unit(current.si(), &AMPERE, 3, language);
            said!(language =>
                "a drive whose I²t monitoring is set to I_0 = {current} trips above 1, even where a higher value is permitted: agree on another setting with the manufacturer"
                | "ein Servoregler, dessen I²t-Überwachung auf I_0 = {current} eingestellt ist, löst über 1 aus, auch wo ein höherer Wert zulässig ist: andere Einstellung mit dem Hersteller abstimmen"
            )
        }
        Note::AboveEndOfCurve { speed, end } => {
            let [speed, end] = [speed, end].map(|value| with_unit(value.si(), &REVOLUTION_PER_MINUTE, 4, language));
            said!(language =>
                "the speed of {speed} is above the end of the curve, {end}: no torque is permitted there; the utilisation is that of the speed"
                | "die Drehzahl {speed} liegt über dem Ende der Kennlinie ({end}): dort ist kein Moment zulässig; angegeben ist die Auslastung der Drehzahl"
            )
        }
        Note::NoChopperThreshold { supply, limit } => {
            let volt = |si| with_unit(si, &VOLT, 3, language);
            let (supply, limit) = (volt(supply.si()), volt(limit.si()));
            said!(language =>
                "the supply reaches {supply}: no switch-on threshold of a braking resistor lies between it and U_DCmax = {limit}, so regenerated energy raises the DC link above U_DCmax while braking. The manual permits this for a short time and states no value: ask the manufacturer, lower the supply voltage, or state the rise of a capacitor bank as dc_link_rise"
                | "die Versorgung erreicht {supply}: zwischen ihr und U_DCmax = {limit} liegt keine Einschaltschwelle eines Bremswiderstands, rückgespeiste Energie hebt den Zwischenkreis beim Bremsen über U_DCmax. Die Anleitung lässt das kurzfristig zu und nennt keinen Wert: beim Hersteller nachfragen, die Versorgungsspannung senken oder den Anstieg einer Kondensatorbatterie als dc_link_rise angeben"
            )
        }
        Note::DcLinkRises { to, free } => {
            let volt = |si| with_unit(si, &VOLT, 3, language);
            let (to, free) = (volt(to.si()), volt(free.si()));
            said!(language =>
                "with the stated rise the DC link reaches {to}. U_DCmax is the maximum steady-state voltage and may be exceeded briefly during braking; the permissible amount is not stated: ask the manufacturer, or permit a rise of at most {free}"
                | "mit dem angegebenen Anstieg erreicht der Zwischenkreis {to}. U_DCmax ist die maximale stationäre Spannung und darf im Bremsbetrieb kurzzeitig überschritten werden; das zulässige Maß ist nicht angegeben: beim Hersteller erfragen oder höchstens {free} Anstieg zulassen"
            )
        }
        Note::FrictionTemperatures { cold, settled: Some(settled) } => {
            let (cold, settled) = (celsius(cold.si()), celsius(settled.si()));
            said!(language =>
                "friction evaluated for a cold gear ({cold}) and at steady-state gear temperature ({settled}); the larger current governs"
                | "Reibung für kaltes ({cold}) und für betriebswarmes Getriebe ({settled}) gerechnet; maßgebend ist der größere Strom"
            )
        }
        Note::FrictionTemperatures { cold, settled: None } => {
            let cold = celsius(cold.si());
            said!(language =>
                "friction evaluated for a cold gear ({cold}) and, without a thermal model, at 80 °C; the larger current governs"
                | "Reibung für kaltes Getriebe ({cold}) und, ohne Erwärmungsmodell, für 80 °C gerechnet; maßgebend ist der größere Strom"
            )
        }
        Note::FrictionExtrapolated { low, high } => {
            let factor = |value: f64| format_significant(value, 2, language);
            let (low, high) = (factor(*low), factor(*high));
            said!(language =>
                "no friction is stated below 20 °C: the value is extrapolated; the actual friction may be {low} to {high} times this value"
                | "unter 20 °C ist keine Reibung angegeben: der Wert ist extrapoliert, die tatsächliche Reibung kann das {low}- bis {high}-Fache betragen"
            )
        }
        Note::UntilWarm => said!(language =>
            "the limit is exceeded with a cold gear only: the drive limits the current until the gear is warm"
            | "Grenze nur bei kaltem Getriebe überschritten: bis zur Betriebswärme begrenzt der Servoregler den Strom"
        ),
        Note::LargestCurrentElsewhere { current, time } => {
            let (current, time) =
                (with_unit(current.si(), &AMPERE, 3, language), with_unit(time.si(), &SECOND, 3, language));
            said!(language =>
                "instant of the highest utilisation; the largest current is {current} at t = {time}, where the curve permits more"
                | "Zeitpunkt der höchsten Auslastung; der größte Strom beträgt {current} bei t = {time}, dort lässt die Kennlinie mehr zu"
            )
        }
        Note::CurveAboveLargestCurrent { current } => {
            let current = with_unit(current.si(), &AMPERE, 3, language);
            said!(language =>
                "assumed: the short-time curve of the project requires up to {current}, which contradicts I_max; the lower limit governs"
                | "angenommen: die Kurzzeitkennlinie des Projekts erfordert bis zu {current} und widerspricht damit I_max; maßgebend ist die niedrigere Grenze"
            )
        }
        Note::PermittedByCurve(upper) => {
            let upper = with_unit(upper.si, upper.unit, 3, language);
            said!(language =>
                "above I_max of the table; the published short-time curve permits the torque, which by the estimated friction needs up to {upper}: a drive limited to I_max does not deliver it, ask the manufacturer for the permissible current"
                | "über I_max der Tabelle; die veröffentlichte Kurzzeitkennlinie lässt das Drehmoment zu, das nach der geschätzten Reibung bis zu {upper} erfordert: ein auf I_max begrenzter Servoregler stellt es nicht, zulässigen Strom beim Hersteller erfragen"
            )
        }
        Note::EstimatedUpTo(upper) => {
            let is_temperature = upper.unit.symbol == DEGREE_CELSIUS.symbol;
            let upper = with_unit(upper.si, upper.unit, 3, language);
            if is_temperature {
                return said!(language =>
                    "the permissible temperature is estimated: the limit is the lower edge of an estimate with upper edge {upper}"
                    | "die zulässige Temperatur ist geschätzt: Grenze ist der untere Rand eines Schätzbands mit oberem Rand {upper}"
                );
            }
            said!(language =>
                "no curve is published for this actuator: the limit is the lower edge of an estimate with upper edge {upper}"
                | "für diesen Antrieb ist keine Kennlinie veröffentlicht: Grenze ist der untere Rand eines Schätzbands mit oberem Rand {upper}"
            )
        }
        Note::InsideBand => said!(language =>
            "the value lies within the band of an estimate: ask the manufacturer, or state a curve"
            | "der Wert liegt im Band einer Schätzung: beim Hersteller erfragen oder eine Kennlinie angeben"
        ),
        Note::RiseAbove(ambient) => {
            let ambient = celsius(ambient.si());
            said!(language =>
                "utilisation refers to the temperature rise above {ambient}"
                | "Auslastung bezogen auf die Übertemperatur gegenüber {ambient}"
            )
        }
        Note::HangingLoad => said!(language =>
            "gravity- or tension-loaded axis: the built-in holding brake is not a safety brake; an additional mechanical brake is required to protect persons"
            | "schwerkraft- bzw. zugbelastete Achse: die eingebaute Haltebremse ist keine Sicherheitsbremse; zum Schutz von Personen ist eine zusätzliche mechanische Bremse erforderlich"
        ),
        Note::Sag(angle) => {
            let angle = with_unit(angle.si(), &DEGREE, 2, language);
            said!(language =>
                "if the motor does not hold the load while the brake closes, the load sags by up to {angle}"
                | "hält der Motor die Last beim Schließen der Bremse nicht, sackt sie um bis zu {angle} ab"
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
                        "the permissible number is not stated"
                        | "die zulässige Anzahl ist nicht angegeben"
                    )
                },
                |count| {
                    let count = format_number(count, 0, language);
                    said!(language => "{count} such emergency stops are permitted in total" | "insgesamt zulässig sind {count} solche Notbremsungen")
                },
            );
            said!(language =>
                "from peak speed, the brake alone stops the axis within {angle} and {time} and absorbs {energy}; {count}"
                | "aus der Spitzendrehzahl hält die Bremse allein die Achse innerhalb von {angle} und {time} an und nimmt {energy} auf; {count}"
            )
        }
        Note::BrakeDoesNotStop => said!(language =>
            "the load torque exceeds the holding torque: the brake does not stop the axis"
            | "das Lastmoment übersteigt das Haltemoment: die Bremse bringt die Achse nicht zum Stillstand"
        ),
        Note::NothingHolds => said!(language =>
            "in a dwell in which nothing holds the load (motion.hold = \"free\") it remains at standstill only if the friction exceeds the load torque"
            | "im Stillstand ohne Halten der Last (motion.hold = \"free\") bleibt sie nur stehen, wenn die Reibung das Lastmoment übersteigt"
        ),
        Note::NoBearingLoad => said!(language =>
            "no load on the output bearing: any limit is met"
            | "keine Last am Abtriebslager: jede Grenze ist eingehalten"
        ),
        Note::NothingHoldsWithoutPower => said!(language =>
            "gravity- or tension-loaded axis and actuator without brake: the load is not held when the power is off. Choose an actuator with brake, or secure the load by other means"
            | "schwerkraft- bzw. zugbelastete Achse und Antrieb ohne Bremse: im stromlosen Zustand wird die Last nicht gehalten. Einen Antrieb mit Bremse wählen oder die Last anderweitig sichern"
        ),
        Note::DwellTooShortForBrake { shortest, needed } => {
            let second = |si| with_unit(si, &SECOND, 3, language);
            let (shortest, needed) = (second(shortest.si()), second(needed.si()));
            said!(language =>
                "a dwell of {shortest} is too short for the brake, which takes {needed} to close and open: the motor holds the load throughout the dwell"
                | "ein Stillstand von {shortest} ist zu kurz für die Bremse, die zum Schließen und Öffnen {needed} benötigt: der Motor hält die Last während des gesamten Stillstands"
            )
        }
        Note::BrakeTimesAssumed => said!(language =>
            "opening and closing time of this brake are not stated: while the brake closes and opens, the motor is assumed to hold the load for 70 ms and 110 ms, as stated for the larger sizes"
            | "Öffnungs- und Schließzeit dieser Bremse sind nicht angegeben: angesetzt sind 70 ms und 110 ms Halten durch den Motor beim Schließen und Öffnen, wie für die größeren Baugrößen angegeben"
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
                    "the brake closes {times} per cycle; the permissible number is not stated"
                    | "die Bremse schließt {times} je Zyklus; die zulässige Anzahl ist nicht angegeben"
                );
            };
            let hours = with_unit(lasts.si(), &HOUR, 3, language);
            said!(language =>
                "the brake closes {times} per cycle: the permissible number of brake applications is reached after {hours} of operation"
                | "die Bremse schließt {times} je Zyklus: die zulässige Anzahl der Bremsungen ist nach {hours} Betrieb erreicht"
            )
        }
        Note::NoBrake => said!(language =>
            "the motion requires a holding brake, which this actuator does not have"
            | "die Bewegung erfordert eine Haltebremse, die dieser Antrieb nicht hat"
        ),
        Note::ReferenceLost { turns } if *turns <= 1.0 => said!(language =>
            "endless rotation: the encoder is absolute within one motor turn only, and the absolute reference is lost, since 1/i is not a whole number"
            | "die Achse dreht endlos: der Geber ist nur innerhalb einer Motorumdrehung absolut, der absolute Bezug geht verloren, da 1/i keine ganze Zahl ist"
        ),
        Note::ReferenceLost { turns } => {
            let turns = format_number(*turns, 0, language);
            said!(language =>
                "endless rotation: the absolute reference is lost when the turns counter of the encoder overflows, since {turns}/i is not a whole number"
                | "die Achse dreht endlos: beim Überlauf der Geberumdrehungen geht der absolute Bezug verloren, da {turns}/i keine ganze Zahl ist"
            )
        }
        Note::NeedsReferencing => said!(language =>
            "the position is not absolute over the travel: the axis must be homed after switch-on"
            | "die Position ist über den Weg nicht absolut: nach dem Einschalten muss referenziert werden"
        ),
        Note::BatteryExchange { recommended, latest } => {
            let year = |si| unpadded(YEAR.from_si(si), 2, language);
            let (recommended, latest) = (year(recommended.si()), year(latest.si()));
            said!(language =>
                "the encoder with its battery should be replaced after {recommended} years, and must be replaced at the latest {latest} years after delivery"
                | "der Geber mit Batterie soll nach {recommended} Jahren ersetzt werden (Empfehlung), spätestens {latest} Jahre nach Lieferung"
            )
        }
        Note::ApprovalNeeded => said!(language =>
            "this field of application requires a risk assessment and the manufacturer's approval (section 2.4)"
            | "dieser Anwendungsbereich erfordert eine Risikobeurteilung und die Freigabe des Herstellers (Abschnitt 2.4)"
        ),
        Note::CollisionsPermitted(count) => {
            let count = format_number(count.floor(), 0, language);
            said!(language =>
                "{count} collisions of this duration are permitted at the peak speed"
                | "bei Spitzendrehzahl sind {count} Kollisionen dieser Dauer zulässig"
            )
        }
        Note::WithAnyInertia => said!(language =>
            "J_out of the actuator is not known: this torque is reached with every J_out"
            | "J_out des Antriebs ist nicht bekannt: dieses Drehmoment wird mit jedem J_out erreicht"
        ),
        Note::NoSpeedHeld => said!(language =>
            "no speed of the cycle is constant: passing through a resonance is permitted"
            | "der Zyklus enthält keine konstante Drehzahl; das Durchfahren einer Resonanz ist zulässig"
        ),
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
                "the wave generator excites the load at {held} with locked rotor{free} (three stiffness regions); avoid constant operation at these speeds"
                | "der Wave Generator regt die Last bei blockiertem Rotor bei {held} an{free} (drei Steifigkeitsbereiche); Dauerbetrieb bei diesen Drehzahlen vermeiden"
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
                "a cup-type gear of this size ratchets at {ratchets}{buckles}; for guidance only, the hollow-shaft gear has a different flexspline"
                | "ein Topfgetriebe dieser Baugröße ratscht bei {ratchets}{buckles}; nur zur Orientierung, das Hohlwellengetriebe hat einen anderen Flexspline"
            )
        }
        Note::FreeRotor(frequency) => {
            let frequency = with_unit(frequency.si(), &HERTZ, 3, language);
            said!(language =>
                "value for locked rotor; with free rotor the natural frequency is {frequency}"
                | "Wert bei blockiertem Rotor; bei freiem Rotor beträgt die Eigenfrequenz {frequency}"
            )
        }
        Note::Budget(budget) => {
            let Budget { errors, deviation, is_along_the_line } = &**budget;
            let root = with_unit(errors.root_sum_square().si(), &ARCMINUTE, 3, language);
            let at_lever = deviation.map_or_else(String::new, |deviation| {
                let deviation = with_unit(deviation.si(), &MILLIMETRE, 3, language);
                match is_along_the_line {
                    true => said!(language => ", {deviation} along the line" | ", linear {deviation}"),
                    false => said!(language => ", {deviation} at the lever arm" | ", {deviation} am Hebelarm"),
                }
            });
            let open = match errors.missing.len() {
                0 => String::new(),
                1 => said!(language => "; one contribution is not known" | "; ein Beitrag ist nicht bekannt"),
                count => {
                    said!(language => "; {count} contributions are not known" | "; {count} Beiträge sind nicht bekannt")
                }
            };
            said!(language =>
                "sum of all contributions{at_lever}; root sum square {root}{open}"
                | "Summe aller Beiträge{at_lever}; Wurzel aus der Quadratsumme {root}{open}"
            )
        }
        Note::Erratum(id) => {
            let (place, evidence) = (erratum_place_of(id, language), evidence_text(id, language));
            said!(language => "erratum, {place}: {evidence}" | "Druckfehler, {place}: {evidence}")
        }
    }
}

/// Returns the remark on small swivel motions among larger ones.
pub(super) fn small_swings(count: usize, angles: [Angle; 2], share: f64, language: Language) -> String {
    let [largest, least] = angles.map(|angle| with_unit(angle.si(), &DEGREE, 3, language));
    let share = format_number(share * 100.0, 0, language);
    said!(language =>
        "{count} swivel motions of up to {largest} per cycle, {share} % of the total travel; below {least} there is a risk of fretting corrosion in the bearing; ask the manufacturer"
        | "{count} Schwenkbewegungen bis {largest} je Zyklus, {share} % des gesamten Wegs; unter {least} besteht die Gefahr von Reibkorrosion im Lager; beim Hersteller erfragen"
    )
}

/// Largest number of periods of slack that are named.
const TIMES_NAMED: usize = 4;

/// Returns the periods in which a rope would be slack.
fn rope_slack(RopeSlack { times }: &RopeSlack, language: Language) -> String {
    let seconds = |time: &Time| format_number(time.in_unit(&SECOND), 3, language);
    let of = |wanted: Rope| {
        let own: Vec<_> = times.iter().filter(|(rope, ..)| *rope == wanted).collect();
        let named = own.iter().take(TIMES_NAMED).map(|(_, from, to)| {
            let (from, to) = (seconds(from), seconds(to));
            said!(language => "from {from} s to {to} s" | "von {from} s bis {to} s")
        });
        let mut all = named.collect::<Vec<_>>().join(", ");
        let more = own.len().saturating_sub(TIMES_NAMED);
        if more > 0 {
            all.push_str(&said!(language => " and {more} times more" | " und weitere {more} Mal"));
        }
        (!own.is_empty()).then_some(all)
    };
    let load = of(Rope::Load).map(
        |all| said!(language => "the rope of the load would be slack {all}" | "das Seil der Last wäre schlaff {all}"),
    );
    let counterweight = of(Rope::Counterweight).map(|all| {
        said!(language =>
            "the rope of the counterweight would be slack {all}"
            | "das Seil des Gegengewichts wäre schlaff {all}"
        )
    });
    let all = [load, counterweight].into_iter().flatten().collect::<Vec<_>>().join("; ");
    said!(language =>
        "{all}: a rope cannot push, the results at these instants are not valid"
        | "{all}: ein Seil kann nicht drücken, die Ergebnisse zu diesen Zeitpunkten gelten nicht"
    )
}
