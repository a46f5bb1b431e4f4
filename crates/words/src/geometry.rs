//! Words for faults in the lengths and angles of a mechanism.

use crate::pick;
use mechanism::Geometry;
use quantities::Language;

/// Returns the fault with the keys concerned.
pub(crate) const fn geometry(fault: Geometry, language: Language) -> &'static str {
    let (en, de) = match fault {
        Geometry::RopeWithoutLength => (
            "`rope_mass` requires `hanging`, the length of each fall at position zero",
            "`rope_mass` erfordert `hanging`, die Länge jedes Strangs in Nullposition",
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
            "`arm_angle` must be at least 1°: near 0° no screw force can lift the load",
            "`arm_angle` muss mindestens 1° sein: nahe 0° kann keine Spindelkraft die Last heben",
        ),
        Geometry::Upright => (
            "`arm_angle` must be less than 90°, where the arms stand upright",
            "`arm_angle` muss kleiner als 90° sein; dort stehen die Arme senkrecht",
        ),
        Geometry::NotAssembled => (
            "one link is as long as the other three together: the linkage cannot be assembled",
            "ein Glied ist so lang wie die anderen drei zusammen: das Gelenkviereck lässt sich nicht schließen",
        ),
        Geometry::TooShort => (
            "the crank cannot rotate fully: crank + ground must be less than coupler + rocker",
            "die Kurbel ist nicht umlauffähig: crank + ground muss kleiner als coupler + rocker sein",
        ),
        Geometry::TooUnequal => (
            "the crank cannot rotate fully: ground and crank must differ by more than coupler and rocker",
            "die Kurbel ist nicht umlauffähig: ground und crank müssen sich um mehr unterscheiden als coupler und rocker",
        ),
    };
    pick(language, en, de)
}
