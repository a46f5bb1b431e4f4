//! Words about implausible values of catalogue files.

use crate::pick;
use crate::texts::{said, texts};
use axis::{PlausibilityFinding, PlausibilityRuleId};
use quantities::{Language, format_significant};

texts! {
    plausible(count) =
        "1 product, no finding" | "1 Produkt, kein Befund",
        "{count} products, no finding" | "{count} Produkte, kein Befund";
    implausible(findings, products) =
        "1 finding in {products} products" | "1 Befund an {products} Produkten",
        "{findings} findings in {products} products" | "{findings} Befunde an {products} Produkten";
    proposals = "Proposed cells (nothing is written)" | "Vorgeschlagene Zellen (nichts wird geschrieben)";
    no_proposals =
        "No single other unit resolves a finding" | "Keine einzelne andere Einheit löst einen Befund auf";
    place = "place" | "Stelle";
    actuator = "actuator" | "Antrieb";
    key = "key" | "Schlüssel";
    old_cell = "as written" | "bisher";
    new_cell = "proposed" | "Vorschlag";
    resolves = "resolves" | "löst auf";
    heading = "heading" | "Spaltenkopf";
    one_of_several = "either this or another cell of the product" | "entweder diese oder eine andere Zelle des Produkts";
}

/// Returns the description of a finding.
#[must_use]
pub fn plausibility_text(finding: &PlausibilityFinding, language: Language) -> String {
    let number = |value: f64| format_significant(value, 3, language);
    let unit = if finding.unit.is_empty() { String::new() } else { format!(" {}", finding.unit) };
    let ratio = finding.ratio.unwrap_or_default();
    let formula = finding.formula;
    let other = finding
        .other
        .as_ref()
        .map(|(product, line)| said!(language => "{product} (line {line})" | "{product} (Zeile {line})"));
    match (finding.rule, other) {
        (PlausibilityRuleId::SameName, other) => {
            let other = other.unwrap_or_default();
            said!(language =>
                "the name differs from {other} in case and separators only"
                | "der Name unterscheidet sich von {other} nur in Groß- und Kleinschreibung und Trennzeichen"
            )
        }
        (PlausibilityRuleId::Neighbours, _) => {
            let times = number(if ratio < 1.0 { 1.0 / ratio } else { ratio });
            if ratio < 1.0 {
                said!(language =>
                    "{formula} is 1/{times} of the value expected from the other products of the series"
                    | "{formula} ist 1/{times} des Werts, der nach den anderen Produkten der Baureihe zu erwarten ist"
                )
            } else {
                said!(language =>
                    "{formula} is {times} times the value expected from the other products of the series"
                    | "{formula} ist das {times}fache des Werts, der nach den anderen Produkten der Baureihe zu erwarten ist"
                )
            }
        }
        (_, other) => {
            let value = number(ratio);
            let (low, high) = finding.window.unwrap_or_default();
            let [low, high] = [low, high].map(|end| bound(end, language));
            let of_motor = other.map(|other| {
                said!(language => "; J from {other} with the same motor" | "; J von {other} mit gleichem Motor")
            });
            let of_motor = of_motor.unwrap_or_default();
            said!(language =>
                "{formula} = {value}{unit}, plausible from {low} to {high}{unit}{of_motor}"
                | "{formula} = {value}{unit}, plausibel von {low} bis {high}{unit}{of_motor}"
            )
        }
    }
}

/// Returns the end of a window with as many digits as it has, at most three.
fn bound(value: f64, language: Language) -> String {
    let digits = (1..3).find(|digits| rounded(value, *digits) == value).unwrap_or(3);
    format_significant(value, digits, language)
}

fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value)
}

/// Returns the reason of a rule: why the values contradict each other, and the usual cause.
#[must_use]
pub const fn plausibility_reason(rule: PlausibilityRuleId, language: Language) -> &'static str {
    let (en, de) = match rule {
        PlausibilityRuleId::VoltageConstant => (
            "in SI, k_TM of a motor with sinusoidal current is √3·k_EM, less saturation and heat; usual causes: peak instead of rms (√2), phase instead of line to line (√3)",
            "in SI ist k_TM eines Motors mit Sinusstrom √3·k_EM, vermindert um Sättigung und Erwärmung; übliche Ursachen: Scheitel- statt Effektivwert (√2), Strang statt Leiter-Leiter (√3)",
        ),
        PlausibilityRuleId::GearEfficiency => (
            "k_Tout is i·k_TM times the efficiency of the gear, which is below 1 (5 % for constants of two digits)",
            "k_Tout ist i·k_TM mal Wirkungsgrad des Getriebes, und der liegt unter 1 (5 % für Konstanten mit zwei Stellen)",
        ),
        PlausibilityRuleId::VoltageConstantOfOutput => (
            "in SI, k_Tout is i·√3·k_EM times the efficiency of the gear, less saturation and heat; usual causes: peak instead of rms (√2), phase instead of line to line (√3), output and motor side confused",
            "in SI ist k_Tout gleich i·√3·k_EM mal Wirkungsgrad des Getriebes, vermindert um Sättigung und Erwärmung; übliche Ursachen: Scheitel- statt Effektivwert (√2), Strang statt Leiter-Leiter (√3), Abtriebs- und Motorseite verwechselt",
        ),
        PlausibilityRuleId::StallTorqueOfCurrent => (
            "T_0 is the torque of I_0, less the part of the current that overcomes friction",
            "T_0 ist das Drehmoment von I_0, vermindert um den Stromanteil gegen die Reibung",
        ),
        PlausibilityRuleId::LargestTorqueOfCurrent => (
            "T_max is the torque of I_max, less friction and saturation; above it only by the friction that brakes",
            "T_max ist das Drehmoment von I_max, vermindert um Reibung und Sättigung; darüber nur um die mitbremsende Reibung",
        ),
        PlausibilityRuleId::StallTorqueBelowLargest => (
            "the continuous torque does not exceed the maximum torque, and the maximum torque is rarely more than ten times as large",
            "das Dauerdrehmoment übersteigt das maximale Drehmoment nicht, und dieses ist selten mehr als zehnmal so groß",
        ),
        PlausibilityRuleId::StallCurrentBelowLargest => (
            "the continuous current does not exceed the maximum current, and the maximum current is rarely more than ten times as large",
            "der Dauerstrom übersteigt den Maximalstrom nicht, und dieser ist selten mehr als zehnmal so groß",
        ),
        PlausibilityRuleId::SpeedOfMotor => (
            "n_max is that of the output, n_mot,max that of the motor: they differ by the ratio, and by a limit of the gear",
            "n_max gilt am Abtrieb, n_mot,max am Motor: sie unterscheiden sich um die Untersetzung und um eine Grenze des Getriebes",
        ),
        PlausibilityRuleId::RatedSpeedBelowLargest => (
            "the rated speed of the motor does not exceed its maximum speed",
            "die Bemessungsdrehzahl des Motors übersteigt seine maximale Drehzahl nicht",
        ),
        PlausibilityRuleId::BackEmf | PlausibilityRuleId::BackEmfAtOutputSpeed => (
            "at maximum speed the peak of the induced voltage is near the DC link voltage: above it the motor needs field weakening; usual causes: V per 1000 min⁻¹ and V s/rad confused, output and motor speed confused",
            "bei maximaler Drehzahl liegt der Scheitelwert der induzierten Spannung nahe der Zwischenkreisspannung: darüber erfordert der Motor Feldschwächung; übliche Ursachen: V je 1000 min⁻¹ und V s/rad verwechselt, Abtriebs- und Motordrehzahl verwechselt",
        ),
        PlausibilityRuleId::CopperLoss => (
            "a body of this mass dissipates the copper loss of I_0: 0.03 m² of surface per kg^(2/3), 10 W/(m² K) in still air and up to ten times as much through plate or coolant, 10 K to 100 K",
            "die Kupferverluste von I_0 gibt ein Körper dieser Masse ab: 0,03 m² Oberfläche je kg^(2/3), 10 W/(m² K) in ruhender Luft und bis zum Zehnfachen über Platte oder Kühlmittel, 10 K bis 100 K",
        ),
        PlausibilityRuleId::NoLoadCurrent => (
            "the no-load current at maximum speed is a part of I_0; usual cause: per 1/min and per rad/s confused",
            "der Leerlaufstrom bei maximaler Drehzahl ist ein Teil von I_0; übliche Ursache: je 1/min und je rad/s verwechselt",
        ),
        PlausibilityRuleId::NoLoadWarmBelowCold => {
            ("warm grease causes less friction than cold grease", "warmes Fett verursacht weniger Reibung als kaltes")
        }
        PlausibilityRuleId::ElectricalTimeConstant => (
            "the electrical time constant of servo motors is between 0.1 ms and 40 ms; usual causes: mH and H confused, phase and line to line mixed",
            "die elektrische Zeitkonstante von Servomotoren liegt zwischen 0,1 ms und 40 ms; übliche Ursachen: mH und H verwechselt, Strang und Leiter-Leiter gemischt",
        ),
        PlausibilityRuleId::LargestTorqueOfGear => (
            "the repeated peak torque does not exceed the momentary peak torque of the gear",
            "das wiederholte Spitzendrehmoment übersteigt das Kollisionsdrehmoment des Getriebes nicht",
        ),
        PlausibilityRuleId::MeanTorqueOfGear => (
            "the permissible mean torque does not exceed the momentary peak torque of the gear",
            "das zulässige mittlere Drehmoment übersteigt das Kollisionsdrehmoment des Getriebes nicht",
        ),
        PlausibilityRuleId::RatedTorqueOfGear => (
            "the rated torque does not exceed the momentary peak torque of the gear",
            "das Bemessungsdrehmoment übersteigt das Kollisionsdrehmoment des Getriebes nicht",
        ),
        PlausibilityRuleId::TwistAtFirstTorque => (
            "gears twist by 0.05 mrad to 20 mrad (0.2 to 70 arcmin) in the first region of stiffness; usual cause: Nm/arcmin and Nm/rad confused",
            "Getriebe verdrehen sich im ersten Steifigkeitsbereich um 0,05 mrad bis 20 mrad (0,2 bis 70 arcmin); übliche Ursache: Nm/arcmin und Nm/rad verwechselt",
        ),
        PlausibilityRuleId::FirstStiffness | PlausibilityRuleId::SecondStiffness => (
            "the torsional stiffness grows with the torque from region to region",
            "die Torsionssteifigkeit wächst mit dem Drehmoment von Bereich zu Bereich",
        ),
        PlausibilityRuleId::BearingRatings => (
            "dynamic and static load rating of an output bearing are of one magnitude; usual cause: N and kN confused",
            "dynamische und statische Tragzahl eines Abtriebslagers liegen in einer Größenordnung; übliche Ursache: N und kN verwechselt",
        ),
        PlausibilityRuleId::TiltingMoment => (
            "the permissible tilting moment is a part of load rating times pitch diameter; usual cause: mm and m, N and kN confused",
            "das zulässige Kippmoment ist ein Teil von Tragzahl mal Teilkreisdurchmesser; übliche Ursache: mm und m, N und kN verwechselt",
        ),
        PlausibilityRuleId::BrakeTorque => (
            "the torque of the holding brake applies at the output; usual cause: stated at the motor",
            "das Drehmoment der Haltebremse gilt am Abtrieb; übliche Ursache: am Motor angegeben",
        ),
        PlausibilityRuleId::HollowShaft => {
            ("the bore lies within the output bearing", "die Bohrung liegt innerhalb des Abtriebslagers")
        }
        PlausibilityRuleId::Density => (
            "mass and length describe one body; usual causes: g and kg, mm and cm, lb and kg confused",
            "Masse und Länge beschreiben einen Körper; übliche Ursachen: g und kg, mm und cm, lb und kg verwechselt",
        ),
        PlausibilityRuleId::SameMotor => (
            "J_out is J·i², with the same J for products with the same motor (equal k_TM and R_LL); encoder, brake and gear change it by less than a factor of 3",
            "J_out ist J·i², mit gleichem J für Produkte mit gleichem Motor (k_TM und R_LL gleich); Geber, Bremse und Getriebe ändern es um weniger als den Faktor 3",
        ),
        PlausibilityRuleId::Neighbours => (
            "within a series a value follows a power law in size and ratio; usual causes: a power of ten, g cm² and kg cm², N cm and Nm, lb and kg confused",
            "in einer Baureihe folgt ein Wert einem Potenzgesetz über Baugröße und Untersetzung; übliche Ursachen: eine Zehnerpotenz, g cm² und kg cm², N cm und Nm, lb und kg verwechselt",
        ),
        PlausibilityRuleId::SameName => (
            "names of one manufacturer that differ only in writing name one product, or one of them has a typing error",
            "Namen eines Herstellers, die sich nur in der Schreibweise unterscheiden, nennen dasselbe Produkt, oder einer enthält einen Tippfehler",
        ),
    };
    pick(language, en, de)
}
