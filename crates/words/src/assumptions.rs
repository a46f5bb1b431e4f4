//! What is assumed where the project states nothing.

use crate::pick;
use motion::Spline;
use project::Assumption;
use quantities::Language;

/// A default that the user did not confirm.
#[must_use]
pub fn assumption_text(assumption: Assumption, language: Language) -> String {
    let (en, de) = match assumption {
        Assumption::SplineThroughPoints(Spline::Cubic) => (
            "a cubic spline goes through the points of the cam table: the acceleration is continuous there (C²), the jerk steps; at the ends the acceleration may step",
            "durch die Punkte der Kurventabelle geht ein kubischer Spline: die Beschleunigung ist dort stetig (C²), der Ruck springt; an den Enden kann die Beschleunigung springen",
        ),
        Assumption::SplineThroughPoints(Spline::Quintic) => (
            "a spline of the fifth degree goes through the points of the cam table: jerk and its derivative are continuous there (C⁴); at the ends the jerk may step",
            "durch die Punkte der Kurventabelle geht ein Spline fünften Grades: der Ruck und seine Ableitung sind dort stetig (C⁴); an den Enden kann der Ruck springen",
        ),
        Assumption::NoFriction => {
            ("no friction torque given: 0 Nm assumed", "kein Reibmoment angegeben: 0 Nm angenommen")
        }
        Assumption::AmbientWithinRange => (
            "no ambient temperature given: 0 °C to 40 °C assumed, the range that the maker's data hold for",
            "keine Umgebungstemperatur angegeben: 0 °C bis 40 °C angenommen, dafür gelten die Herstellerangaben",
        ),
        Assumption::CoolingPlate => (
            "mounted on the aluminium plate of table 13.3: continuous data hold for it only",
            "auf der Aluminiumplatte nach Tabelle 13.3 montiert: nur dafür gelten die Dauerdaten",
        ),
        Assumption::ModulationReserve => (
            "the drive gives 90 % of U_DC/√2 at the motor terminals (requirements.modulation_reserve)",
            "der Regler stellt 90 % von U_DC/√2 an den Motorklemmen (requirements.modulation_reserve)",
        ),
        Assumption::NoSupply => (
            "no voltage given (requirements.supply for the DC link, or requirements.mains): the terminal voltage is not checked",
            "keine Spannung angegeben (requirements.supply für den Zwischenkreis oder requirements.mains): die Klemmenspannung ist nicht geprüft",
        ),
        Assumption::Rectifier => (
            "the DC link is that of a three-phase rectifier without control: 1.35 times the lowest mains under load, √2 times the highest without load",
            "der Zwischenkreis ist der eines ungesteuerten Drehstromgleichrichters: unter Last das 1,35-fache der niedrigsten, ohne Last das √2-fache der höchsten Netzspannung",
        ),
        Assumption::RectifierAndDeviation => (
            "the mains vary by ± 10 % (requirements.mains_deviation), and the DC link is that of a three-phase rectifier without control: 1.35 times the lowest mains under load, √2 times the highest without load",
            "das Netz schwankt um ± 10 % (requirements.mains_deviation), und der Zwischenkreis ist der eines ungesteuerten Drehstromgleichrichters: unter Last das 1,35-fache der niedrigsten, ohne Last das √2-fache der höchsten Netzspannung",
        ),
        Assumption::SinglePhaseRectifier => (
            "the DC link is that of a single-phase rectifier without control: 0.90 times the lowest mains under load, the mean of its pulses; a capacitor keeps it higher (state that voltage as requirements.supply), √2 times the highest without load",
            "der Zwischenkreis ist der eines ungesteuerten Einphasengleichrichters: unter Last das 0,90-fache der niedrigsten Netzspannung, der Mittelwert der Pulse; ein Kondensator hält sie höher (dann als requirements.supply angeben), ohne Last das √2-fache der höchsten",
        ),
        Assumption::SinglePhaseRectifierAndDeviation => (
            "the mains vary by ± 10 % (requirements.mains_deviation), and the DC link is that of a single-phase rectifier without control: 0.90 times the lowest mains under load, the mean of its pulses; a capacitor keeps it higher (state that voltage as requirements.supply), √2 times the highest without load",
            "das Netz schwankt um ± 10 % (requirements.mains_deviation), und der Zwischenkreis ist der eines ungesteuerten Einphasengleichrichters: unter Last das 0,90-fache der niedrigsten Netzspannung, der Mittelwert der Pulse; ein Kondensator hält sie höher (dann als requirements.supply angeben), ohne Last das √2-fache der höchsten",
        ),
        Assumption::OwnStallCurrentIncludesFriction => (
            "I_0 of the own actuator taken to include its no-load starting current I_NLS",
            "I_0 des eigenen Antriebs enthält annahmegemäß den lastfreien Anlaufstrom I_NLS",
        ),
        Assumption::NoFlangeLoads => (
            "no loads on the flange are known ([bearing]): the output bearing is not checked",
            "keine Lasten am Flansch bekannt ([bearing]): das Abtriebslager ist nicht geprüft",
        ),
        Assumption::FlangeMomentsAligned => (
            "radial and axial moment on the flange taken in the same direction",
            "Momente aus Radial- und Axialkraft am Flansch gleichgerichtet angesetzt",
        ),
        Assumption::NoLosses => (
            "no efficiency of the mechanism given: 1 assumed",
            "kein Wirkungsgrad der Mechanik angegeben: 1 angenommen",
        ),
        Assumption::LossesDoNotHelp => (
            "no efficiency_back given: while the load drives, the losses do not help to brake",
            "kein efficiency_back angegeben: treibt die Last, so helfen die Verluste nicht beim Bremsen",
        ),
        Assumption::TrapezoidThirds => (
            "a trapezoid given by two quantities accelerates, runs and brakes for a third of its time each",
            "ein Trapez aus zwei Angaben beschleunigt, fährt und bremst je ein Drittel seiner Zeit",
        ),
        Assumption::SingleMoveRepeats => (
            "the single move is judged as if it followed itself without a pause: which is on the safe side for the rms torque",
            "die einmalige Bewegung ist beurteilt, als folgte sie sich ohne Pause: für das effektive Drehmoment ist das die sichere Seite",
        ),
        Assumption::OrdinaryApplication => (
            "no field of application that needs the maker's approval (section 2.4)",
            "kein Anwendungsbereich, der die Freigabe des Herstellers braucht (Abschnitt 2.4)",
        ),
        Assumption::UniformTolerances => (
            "each quantity with a tolerance uniform within its band, independent of the others",
            "jede Größe mit Toleranz in ihrem Band gleichverteilt, unabhängig von den anderen",
        ),
        Assumption::MotorHolds => {
            ("in a dwell without hold the motor carries the load", "im Stillstand ohne hold trägt der Motor die Last")
        }
        Assumption::RecordedTorqueAdds => (
            "the recorded torque is a process torque; it is added to the torque of inertia, gravity and friction of the mechanism",
            "das aufgezeichnete Moment ist ein Prozessmoment; Trägheit, Gewicht und Reibung des Mechanismus kommen hinzu",
        ),
        Assumption::RecordedPositionDifferentiated => (
            "speed and acceleration are differences of the recorded position, not smoothed: noise in it raises the torque",
            "Drehzahl und Beschleunigung sind Differenzen der aufgezeichneten Lage, ungeglättet: ihr Rauschen erhöht das Moment",
        ),
        Assumption::FlangeLoadsConstant => (
            "the stated loads on the flange are all of them, constant over the cycle, radial and axial moment in the same direction; those of the mechanism do not count besides (mechanism = \"add\" adds them)",
            "die angegebenen Lasten am Flansch sind alle, über den Zyklus konstant, Momente aus Radial- und Axialkraft gleichgerichtet; die des Mechanismus zählen nicht dazu (mechanism = \"add\" nimmt sie auf)",
        ),
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
        Assumption::StageNoLosses => (
            "no efficiency of the stage given: 1 assumed",
            "kein Wirkungsgrad der Zwischenstufe angegeben: 1 angenommen",
        ),
        Assumption::StageLossesDoNotHelp => (
            "no stage.efficiency_back given: while the mechanism drives, the losses of the stage do not help to brake",
            "kein stage.efficiency_back angegeben: treibt der Mechanismus, so helfen die Verluste der Stufe nicht beim Bremsen",
        ),
        Assumption::StageWithoutInertia => (
            "no inertia of the stage given: 0 kgm² assumed",
            "keine Massenträgheit der Stufe angegeben: 0 kgm² angenommen",
        ),
        Assumption::StageRigid => {
            ("no stage.stiffness given: the stage is rigid", "kein stage.stiffness angegeben: die Stufe ist starr")
        }
        Assumption::StageNoBacklash => (
            "no stage.backlash given: the stage has no backlash",
            "kein stage.backlash angegeben: die Stufe hat kein Spiel",
        ),
        Assumption::StageRatioChosen => (
            "of stage.ratios the one with the best actuator of the catalogue",
            "aus stage.ratios diejenige mit dem besten Antrieb des Katalogs",
        ),
        Assumption::MechanismOnOwnBearings => (
            "with a stage the mechanism rests on bearings of its own: the flange bears the stage only",
            "mit einer Zwischenstufe ruht der Mechanismus auf eigenen Lagern: der Flansch trägt nur die Stufe",
        ),
    };
    pick(language, en, de).to_owned()
}
