//! Words about the loads on the flange that follow from the mechanism.

use super::either;
use super::results::with_unit;
use crate::project::Assumption;
use quantities::unit::DEGREE;
use quantities::{Angle, Language, Measure, format_number};

pub(crate) fn no_loads(language: Language) -> String {
    either(
        language,
        "no loads on the flange follow from this load: its masses and their places are not described",
        "aus dieser Last folgen keine Flanschlasten: ihre Massen und deren Lage sind nicht beschrieben",
    )
}

pub(crate) fn mechanisms_with_loads(language: Language) -> String {
    either(
        language,
        "loads follow from turntable, arm, screw, belt, conveyor and slider_crank",
        "Lasten folgen aus turntable, arm, screw, belt, conveyor und slider_crank",
    )
}

pub(crate) fn replaces_everything(key: &str, language: Language) -> String {
    either(
        language,
        format!(
            "`bearing.{key}` would replace the loads of the mechanism in every segment; write mechanism = \"ignore\" or \"add\""
        ),
        format!(
            "`bearing.{key}` würde die Lasten des Mechanismus in jedem Abschnitt ersetzen; mechanism = \"ignore\" oder \"add\" schreiben"
        ),
    )
}

pub(crate) fn belt_or_teeth(language: Language) -> String {
    either(
        language,
        "`belt_tension` is of a belt, `pressure_angle` of teeth: one of them",
        "`belt_tension` gehört zu einem Riemen, `pressure_angle` zu einer Verzahnung: eines von beiden",
    )
}

pub(crate) fn tooth_angle(key: &str, most_deg: f64, language: Language) -> String {
    let most = format_number(most_deg, 0, language);
    either(
        language,
        format!("`bearing.{key}` must be at most {most}°"),
        format!("`bearing.{key}` darf höchstens {most}° sein"),
    )
}

/// The remark on small swings among larger ones.
pub(super) fn small_swings(count: usize, largest: Angle, share: f64, language: Language) -> String {
    let largest = with_unit(largest.si(), &DEGREE, 3, language);
    let share = format_number(share * 100.0, 0, language);
    either(
        language,
        format!(
            "{count} swings of up to {largest} in each cycle, {share} % of all travel; below 5° the bearing may fret, ask the maker"
        ),
        format!(
            "{count} Schwenkungen bis {largest} je Zyklus, {share} % des gesamten Wegs; unter 5° droht Reibkorrosion, beim Hersteller fragen"
        ),
    )
}

/// What is taken for granted about loads that follow from the mechanism: English, German.
pub(super) const fn assumed(assumption: Assumption) -> (&'static str, &'static str) {
    match assumption {
        Assumption::FlangeLoadsOfMechanism => (
            "loads on the flange follow from masses, motion and process forces of the mechanism at every instant",
            "Lasten am Flansch folgen in jedem Augenblick aus Massen, Bewegung und Prozesskräften des Mechanismus",
        ),
        Assumption::FlangeLoadsAddUp => (
            "loads stated for the flange add to those of the mechanism at their worst: all in the same direction",
            "angegebene Flanschlasten kommen zu denen des Mechanismus im ungünstigsten Fall hinzu: alle gleichgerichtet",
        ),
        Assumption::FlangeBearsAll => (
            "no bearing.flange_share given: the flange bears the loads of the mechanism alone",
            "kein bearing.flange_share angegeben: der Flansch trägt die Lasten des Mechanismus allein",
        ),
        Assumption::FlangeBodiesFlat => (
            "the masses on the flange are balanced about their own planes (no products of inertia)",
            "die Massen am Flansch sind in ihren eigenen Ebenen ausgewuchtet (keine Deviationsmomente)",
        ),
        Assumption::FlangeUpwards => {
            ("no axis_tilt given: the flange looks upwards", "kein axis_tilt angegeben: der Flansch zeigt nach oben")
        }
        Assumption::PayloadInertiaWeightless => (
            "payload_inertia has no weight that loads the flange",
            "payload_inertia hat kein Gewicht, das den Flansch belastet",
        ),
        Assumption::WheelWeightless => (
            "no bearing.wheel_mass given: what turns with the flange itself weighs nothing",
            "kein bearing.wheel_mass angegeben: was sich mit dem Flansch selbst dreht, wiegt nichts",
        ),
        Assumption::SpurTeeth => ("no helix_angle given: spur teeth", "kein helix_angle angegeben: Geradverzahnung"),
        _ => ("", ""),
    }
}
