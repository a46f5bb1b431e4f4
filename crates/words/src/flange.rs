//! Words about the loads on the flange that follow from the mechanism.

use super::either;
use super::results::with_unit;
use project::Assumption;
use quantities::unit::DEGREE;
use quantities::{Angle, Language, Measure, format_number};

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
