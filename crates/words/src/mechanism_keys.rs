//! Words for the mechanisms and their keys.

use crate::pick;
use project::names::{
    ArmName, BeltName, ConveyorName, FourBarName, HoistName, JointName, MechanismName, MechanismsName, ScissorLiftName,
    ScrewName, SliderCrankName, TableName, TurntableName, WinderName,
};
use quantities::Language;

/// Returns the description of a mechanism.
#[rustfmt::skip] // one line per mechanism and language
pub(crate) const fn mechanism_text(name: MechanismsName, language: Language) -> &'static str {
    let (en, de) = match name {
        MechanismsName::turntable => ("turntable or drum of solid bodies", "Drehtisch oder Trommel aus Vollkörpern"),
        MechanismsName::arm => ("unbalanced arm", "unausgewuchteter Arm"),
        MechanismsName::screw => ("screw with slide", "Gewindetrieb mit Schlitten"),
        MechanismsName::belt => ("belt, or rack and pinion, with slide", "Zahnriemen oder Zahnstange mit Schlitten"),
        MechanismsName::conveyor => (
            "conveyor belt or roller, running endlessly",
            "Förderband oder Rolle, endlos laufend",
        ),
        MechanismsName::slider_crank => ("crank, rod and slider", "Schubkurbel"),
        MechanismsName::joint => (
            "robot joint, torque recorded together with the motion",
            "Robotergelenk, Moment zusammen mit der Bewegung aufgezeichnet",
        ),
        MechanismsName::hoist => ("hoist: drum, rope and load", "Hubwerk: Trommel, Seil und Last"),
        MechanismsName::winder => ("winder: roll with increasing or decreasing diameter", "Wickler mit zu- oder abnehmendem Wickeldurchmesser"),
        MechanismsName::scissor_lift => ("scissor lift with a screw", "Scherenhubtisch mit Spindel"),
        MechanismsName::four_bar => ("four-bar linkage: crank, coupler and rocker", "Gelenkviereck: Kurbel, Koppel und Schwinge"),
        MechanismsName::table => (
            "moment of inertia and torque as a function of position",
            "Massenträgheitsmoment und Moment über der Position",
        ),
    };
    pick(language, en, de)
}

/// Returns the purpose of a key of a mechanism.
#[rustfmt::skip] // one line per key and language
pub(crate) const fn mechanism_key_text(name: MechanismName, language: Language) -> &'static str {
    let (en, de) = match name {
        MechanismName::Turntable(TurntableName::body) => (
            "solid bodies as tables; or bodies",
            "Vollkörper als Tabellen; oder bodies",
        ),
        MechanismName::Turntable(TurntableName::bodies) => (
            "solid bodies as texts, one each, with shape and dimensions",
            "Vollkörper als Texte, je einer mit Form und Maßen",
        ),
        MechanismName::Turntable(TurntableName::axis_tilt) => (
            "tilt of the rotation axis from the vertical; default: vertical",
            "Neigung der Drehachse gegen die Senkrechte; ohne Angabe senkrecht",
        ),
        MechanismName::Turntable(TurntableName::start_angle) => (
            "position at the beginning of the motion; default: zero",
            "Position zu Beginn der Bewegung; ohne Angabe null",
        ),
        MechanismName::Turntable(TurntableName::payload_distance) => (
            "distance of the payload of a segment from the axis",
            "Abstand der Nutzlast eines Abschnitts von der Drehachse",
        ),
        MechanismName::Arm(ArmName::payload_distance) => (
            "distance of the payload of a segment from the axis; default: the length of the arm, if it is stated",
            "Abstand der Nutzlast eines Abschnitts von der Drehachse; ohne Angabe die Länge des Arms, wenn sie angegeben ist",
        ),
        MechanismName::Arm(ArmName::shape) => (
            "shape of the arm; inertia and centre of mass follow from it and need not be stated; default with a length: rod",
            "Form des Arms; daraus folgen Trägheitsmoment und Schwerpunkt, die dann nicht anzugeben sind; ohne Angabe bei angegebener Länge ein Stab",
        ),
        MechanismName::Arm(ArmName::length) => (
            "length of the arm from the axis to its end",
            "Länge des Arms von der Drehachse bis zum Ende",
        ),
        MechanismName::Arm(ArmName::width) => (
            "width of a bar, across the arm in the plane of rotation",
            "Breite eines Balkens, quer zum Arm in der Drehebene",
        ),
        MechanismName::Arm(ArmName::inertia) => (
            "moment of inertia of the arm about the axis, without payload",
            "Massenträgheitsmoment des Arms um die Drehachse, ohne Nutzlast",
        ),
        MechanismName::Arm(ArmName::mass) => ("mass of the arm", "Masse des Arms"),
        MechanismName::Arm(ArmName::centre_distance) => (
            "distance of the arm's centre of mass from the axis",
            "Abstand des Schwerpunkts des Arms von der Drehachse",
        ),
        MechanismName::Arm(ArmName::axis_tilt) => (
            "tilt of the rotation axis from the vertical; default: 90 deg, a horizontal axis",
            "Neigung der Drehachse gegen die Senkrechte; ohne Angabe 90 deg, waagerechte Achse",
        ),
        MechanismName::Screw(ScrewName::lead) => ("travel per revolution", "Steigung, Weg je Umdrehung"),
        MechanismName::Belt(BeltName::pulley_diameter) => (
            "pitch diameter of the driving pulley or pinion",
            "Wirkdurchmesser der Antriebsscheibe oder des Ritzels",
        ),
        MechanismName::Conveyor(ConveyorName::roller_diameter) => ("diameter of the driving roller", "Durchmesser der Antriebsrolle"),
        MechanismName::SliderCrank(SliderCrankName::crank) => ("crank radius", "Kurbelradius"),
        MechanismName::SliderCrank(SliderCrankName::rod) => ("rod length, longer than the crank", "Pleuellänge, größer als der Kurbelradius"),
        MechanismName::Table(TableName::points) => (
            "position, moment of inertia, holding torque; linear interpolation between the points",
            "Position, Massenträgheitsmoment, Haltemoment; lineare Interpolation zwischen den Punkten",
        ),
        MechanismName::Hoist(HoistName::drum_diameter) => ("drum diameter to the rope centre", "Trommeldurchmesser bis Seilmitte"),
        MechanismName::Hoist(HoistName::falls) => ("number of rope falls carrying the load", "Anzahl der tragenden Seilstränge"),
        MechanismName::Hoist(HoistName::mass) => ("load with hook and lower block", "Last mit Haken und Unterflasche"),
        MechanismName::Hoist(HoistName::inertia) => ("moment of inertia of the drum and the parts rotating with it", "Massenträgheitsmoment der Trommel mit umlaufenden Teilen"),
        MechanismName::Hoist(HoistName::rope_mass) => ("mass of all falls at position zero; default: neglected", "Masse aller Seilstränge in Nullposition; ohne Angabe vernachlässigt"),
        MechanismName::Hoist(HoistName::hanging) => ("length of each fall at position zero", "Länge jedes Seilstrangs in Nullposition"),
        MechanismName::Hoist(HoistName::sheave_efficiency) => ("efficiency of one sheave", "Wirkungsgrad einer Seilrolle"),
        MechanismName::Winder(WinderName::winding) => ("winding or unwinding of the web with positive rotation", "Auf- oder Abwickeln der Bahn bei positiver Drehung"),
        MechanismName::Winder(WinderName::core_diameter) => ("outer diameter of the core", "Außendurchmesser der Hülse"),
        MechanismName::Winder(WinderName::full_diameter) => ("diameter of the full roll", "Durchmesser des vollen Wickels"),
        MechanismName::Winder(WinderName::start_diameter) => ("diameter at position zero; default: the core when winding, the full roll when unwinding", "Durchmesser in Nullposition; ohne Angabe beim Aufwickeln die Hülse, beim Abwickeln der volle Wickel"),
        MechanismName::Winder(WinderName::thickness) => ("thickness of the web; change of the radius per turn", "Dicke der Bahn; Radiusänderung je Umdrehung"),
        MechanismName::Winder(WinderName::width) => ("width of the web", "Breite der Bahn"),
        MechanismName::Winder(WinderName::density) => ("density of the wound material", "Dichte des gewickelten Materials"),
        MechanismName::Winder(WinderName::tension) => ("web tension, also at standstill", "Bahnzug, auch im Stillstand"),
        MechanismName::Winder(WinderName::inertia) => ("moment of inertia of core and shaft", "Massenträgheitsmoment von Hülse und Welle"),
        MechanismName::ScissorLift(ScissorLiftName::stages) => ("number of scissor stages; default: one", "Anzahl der Scherenpaare übereinander; ohne Angabe eins"),
        MechanismName::ScissorLift(ScissorLiftName::arm_length) => ("length of an arm between the pins at its ends", "Länge eines Arms zwischen den Endbolzen"),
        MechanismName::ScissorLift(ScissorLiftName::lead) => ("lead of the screw: travel of the nut per revolution towards the fixed pin", "Steigung der Spindel: Weg der Mutter je Umdrehung zum festen Bolzen hin"),
        MechanismName::ScissorLift(ScissorLiftName::arm_angle) => ("angle of the arms above the horizontal at position zero", "Winkel der Arme über der Waagerechten in Nullposition"),
        MechanismName::ScissorLift(ScissorLiftName::mass) => ("platform with its permanent load", "Plattform mit ständiger Auflast"),
        MechanismName::ScissorLift(ScissorLiftName::arm_mass) => ("total mass of all arms; default: neglected", "Gesamtmasse aller Arme; ohne Angabe vernachlässigt"),
        MechanismName::ScissorLift(ScissorLiftName::inertia) => ("moment of inertia of screw and coupling", "Massenträgheitsmoment von Spindel und Kupplung"),
        MechanismName::FourBar(FourBarName::ground) => ("distance between the two fixed pivots", "Abstand der beiden Gestelldrehpunkte"),
        MechanismName::FourBar(FourBarName::crank) => ("length of the crank", "Länge der Kurbel"),
        MechanismName::FourBar(FourBarName::coupler) => ("length of the coupler", "Länge der Koppel"),
        MechanismName::FourBar(FourBarName::rocker) => ("length of the rocker", "Länge der Schwinge"),
        MechanismName::FourBar(FourBarName::crossed) => ("true: coupler and rocker crossed", "true: Koppel und Schwinge überkreuzt"),
        MechanismName::FourBar(FourBarName::inertia) => ("moment of inertia of the crank and the parts rotating with it", "Massenträgheitsmoment der Kurbel mit umlaufenden Teilen"),
        MechanismName::FourBar(FourBarName::coupler_mass) => ("mass of the coupler", "Masse der Koppel"),
        MechanismName::FourBar(FourBarName::coupler_centre) => ("distance of the coupler's centre of mass from the crank pin", "Abstand des Schwerpunkts der Koppel vom Kurbelzapfen"),
        MechanismName::FourBar(FourBarName::coupler_inertia) => ("moment of inertia of the coupler about its centre of mass", "Massenträgheitsmoment der Koppel um ihren Schwerpunkt"),
        MechanismName::FourBar(FourBarName::rocker_mass) => ("mass of the rocker, for its weight", "Masse der Schwinge, für ihr Gewicht"),
        MechanismName::FourBar(FourBarName::rocker_centre) => ("distance of the rocker's centre of mass from its pivot", "Abstand des Schwerpunkts der Schwinge vom Drehpunkt"),
        MechanismName::FourBar(FourBarName::rocker_inertia) => ("moment of inertia of the rocker and its load about its pivot", "Massenträgheitsmoment von Schwinge und Last um den Drehpunkt"),
        MechanismName::FourBar(FourBarName::rocker_torque) => ("torque on the rocker against its positive direction", "Moment an der Schwinge entgegen ihrer positiven Richtung"),
        MechanismName::FourBar(FourBarName::axis_tilt) => ("tilt of the axes from the vertical; default: 90 deg, an upright linkage", "Neigung der Achsen gegen die Senkrechte; ohne Angabe 90 deg, stehendes Gelenkviereck"),
        MechanismName::FourBar(FourBarName::inclination) => ("angle of the fixed link above the horizontal, from crank to rocker", "Winkel des Gestells über der Waagerechten, von der Kurbel zur Schwinge"),
        MechanismName::Joint(JointName::inertia) => (
            "largest moment of inertia at the joint, for inertia ratio, natural frequency and brake; already included in the recorded torque",
            "größtes Massenträgheitsmoment am Gelenk, für Trägheitsverhältnis, Eigenfrequenz und Bremse; im aufgezeichneten Moment bereits enthalten",
        ),
        MechanismName::Joint(JointName::holding_torque) => (
            "largest holding torque of the arm at standstill, for the brake",
            "größtes Haltemoment des Arms im Stillstand, für die Bremse",
        ),
    };
    pick(language, en, de)
}
