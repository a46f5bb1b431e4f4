//! Words of what is wrong with the lengths and angles of a mechanism.

use mechanism::Geometry;
use quantities::Language;

/// What is wrong, with the keys it is about.
pub(crate) const fn geometry(fault: Geometry, language: Language) -> &'static str {
    let (en, de) = match fault {
        Geometry::RopeWithoutLength => (
            "`rope_mass` needs `hanging`, the length of each fall at position zero",
            "`rope_mass` braucht `hanging`, die Länge jedes Strangs in Position null",
        ),
        Geometry::FullBelowCore => (
            "`full_diameter` must be larger than `core_diameter`",
            "`full_diameter` muss größer als `core_diameter` sein",
        ),
        Geometry::StartBelowCore => (
            "`start_diameter` must be at least `core_diameter`",
            "`start_diameter` muss mindestens `core_diameter` sein",
        ),
        Geometry::StartAboveFull => {
            ("`start_diameter` must be at most `full_diameter`", "`start_diameter` darf höchstens `full_diameter` sein")
        }
        Geometry::Flat => (
            "`arm_angle` must be at least 1°: near 0° the screw lifts nothing with any force",
            "`arm_angle` muss mindestens 1° sein: nahe 0° hebt die Spindel mit keiner Kraft",
        ),
        Geometry::Upright => (
            "`arm_angle` must be less than 90°, where the arms stand upright",
            "`arm_angle` muss kleiner als 90° sein; dort stehen die Arme senkrecht",
        ),
    };
    match language {
        Language::En => en,
        Language::De => de,
    }
}
