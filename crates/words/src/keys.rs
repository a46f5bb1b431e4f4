//! Words of the keys of the project file.

use crate::mechanism_keys::{mechanism_key_text, mechanism_text};
use crate::pick;
use crate::texts::said;
use crate::twin_keys::{replaced_key_text, twin_key_text};
use project::names::{
    ActuatorName, AxisName, BearingName, BodyName, ColumnsName, CounterweightName, CurveName, DriveName,
    FlangeLoadsName, FrictionName, GuideName, LoadName, LossesName, OneOfSeveralName, PartsName, ProcessForceName,
    RequirementsName, RootName, SegmentName, SlideName, StageName, StartAngleName, UnitsName,
};
use project::{About, Key};
use quantities::Language;

/// What a key of the project file is for, and what its declaration says of a file that does not state it.
#[must_use]
pub fn key_text(key: &Key, language: Language) -> String {
    let about = about_text(key.about, language);
    let assumed = if key.note.is_some() {
        said!(language => ", listed as assumed" | ", als angenommen genannt")
    } else {
        "".into()
    };
    let Some(default) = key.default.map(|default| default()) else { return format!("{about}{assumed}") };
    let is_number = default.parse::<f64>().is_ok();
    let mark = language.decimal_mark().to_string();
    let default = if is_number { default.replace('.', &mark) } else { default };
    said!(language => "{about}; {default} without it{assumed}" | "{about}; ohne Angabe {default}{assumed}")
}

/// What a key of the project file is for.
#[must_use]
#[rustfmt::skip] // one line per key and language
pub const fn about_text(about: About, language: Language) -> &'static str {
    let (en, de) = match about {
        About::Mechanisms(name) => return mechanism_text(name, language),
        About::Twin(name) => return twin_key_text(name, language),
        About::Replaced(name) => return replaced_key_text(name, language),
        About::Mechanism(name) => return mechanism_key_text(name, language),
        About::Measured(key) => return super::measured_key_text(key, language),
        About::Root(RootName::format) => ("version of the file format, 1", "Version des Dateiformats, 1"),
        About::Root(RootName::axis) => (
            "the axis; or [[axis]], several axes with load, motion and all else inside",
            "die Achse; oder [[axis]], mehrere Achsen mit Last, Bewegung und allem anderen darin",
        ),
        About::Parts(PartsName::load) => (
            "what is moved, referred to the output; or [mechanism.…]",
            "was bewegt wird, auf den Abtrieb bezogen; oder [mechanism.…]",
        ),
        About::Parts(PartsName::mechanism) => (
            "what lies between output and load; one of its tables",
            "was zwischen Abtrieb und Last liegt; eine seiner Tabellen",
        ),
        About::Parts(PartsName::stage) => (
            "belt, gear or coupling between actuator and mechanism",
            "Riemen, Getriebestufe oder Kupplung zwischen Antrieb und Mechanismus",
        ),
        About::Parts(PartsName::motion) => ("the moves of one cycle, in order", "die Bewegungen eines Zyklus, der Reihe nach"),
        About::Parts(PartsName::twin) => ("what the simulation is to do", "was die Simulation tun soll"),
        About::Parts(PartsName::bearing) => ("loads on the output flange", "Lasten am Abtriebsflansch"),
        About::Parts(PartsName::requirements) => ("what the actuator must have", "was der Antrieb haben muss"),
        About::Parts(PartsName::drive) => ("the drive that supplies the motor", "der Regler, der den Motor speist"),
        About::Drive(DriveName::current_continuous) => (
            "continuous current of the drive, rms of a phase",
            "Dauerstrom des Reglers, Effektivwert je Phase",
        ),
        About::Drive(DriveName::current_peak) => (
            "peak current of the drive, rms of a phase",
            "Spitzenstrom des Reglers, Effektivwert je Phase",
        ),
        About::Drive(DriveName::peak_time) => (
            "longest time above the continuous current; not limited without it",
            "längste Zeit über dem Dauerstrom; ohne Angabe nicht begrenzt",
        ),
        About::Parts(PartsName::actuator) => ("an actuator that the catalogue lacks", "ein Antrieb, der nicht im Katalog steht"),
        About::Root(RootName::curve) => (
            "measured or digitised curves of the torque-speed plane; they win over the catalogue's",
            "gemessene oder digitalisierte Kennlinien; sie gehen denen des Katalogs vor",
        ),
        About::Curve(CurveName::kind) => ("what the curve limits", "was die Kennlinie begrenzt"),
        About::Curve(CurveName::code) => (
            "codes it holds for; * stands for any field: CHA-25A-100-*",
            "Codes, für die sie gilt; * steht für jedes Feld: CHA-25A-100-*",
        ),
        About::Curve(CurveName::points) => (
            "corner points from standstill, speed and torque at the output",
            "Eckpunkte ab Stillstand, Drehzahl und Drehmoment am Abtrieb",
        ),
        About::Curve(CurveName::source) => ("where the curve is from", "woher die Kennlinie ist"),
        About::Axis(AxisName::name) | About::OneOfSeveral(OneOfSeveralName::name) => ("name of the axis", "Name der Achse"),
        About::Axis(AxisName::single_move) | About::OneOfSeveral(OneOfSeveralName::single_move) => (
            "true: the motion is one move and need not come back",
            "true: die Bewegung ist einmalig und muss nicht zurückkehren",
        ),
        About::Load(LoadName::inertia) => (
            "J_L, moment of inertia of the load at the output",
            "J_L, Massenträgheitsmoment der Last am Abtrieb",
        ),
        About::Friction(FrictionName::friction_torque) => (
            "T_L, friction torque at the output; opposes every motion; zero where no friction is stated",
            "T_L, Reibmoment am Abtrieb; wirkt jeder Bewegung entgegen; null, wo keine Reibung angegeben ist",
        ),
        About::Friction(FrictionName::viscous_friction) => (
            "friction at the output in proportion to the speed",
            "drehzahlproportionale Reibung am Abtrieb",
        ),
        About::Friction(FrictionName::external_torque) => (
            "constant torque at the output against the positive direction; does not reverse",
            "konstantes Moment am Abtrieb gegen die positive Richtung; kehrt nicht um",
        ),
        About::Losses(LossesName::efficiency) => (
            "efficiency while the actuator drives the load",
            "Wirkungsgrad, wenn der Antrieb die Last treibt",
        ),
        About::Losses(LossesName::efficiency_back) => (
            "efficiency while the load drives the actuator",
            "Wirkungsgrad, wenn die Last den Antrieb treibt",
        ),
        About::Slide(SlideName::mass) => ("moved mass", "bewegte Masse"),
        About::Slide(SlideName::inertia) => (
            "moment of inertia of what turns with the output",
            "Massenträgheitsmoment dessen, was sich mit dem Abtrieb dreht",
        ),
        About::Slide(SlideName::inclination) => (
            "positive direction above the horizontal; 90 deg is upwards; horizontal without it",
            "positive Richtung über der Waagerechten; 90 deg ist aufwärts; ohne Angabe waagerecht",
        ),
        About::Counterweight(CounterweightName::counterweight) => ("counterweight; it moves along and takes its weight off the load", "Gegengewicht; es bewegt sich mit und entlastet um sein Gewicht"),
        About::Guide(GuideName::friction_force) => ("friction force of seals and guides", "Reibkraft von Dichtungen und Führungen"),
        About::Guide(GuideName::friction_coefficient) => ("friction coefficient of the guide", "Reibzahl der Führung"),
        About::ProcessForce(ProcessForceName::process_force) => (
            "process force along the line, against the positive direction; does not reverse",
            "Prozesskraft längs der Führung, gegen die positive Richtung; kehrt nicht um",
        ),
        About::StartAngle(StartAngleName::start_angle) => ("position in which the motion begins", "Stellung, in der die Bewegung beginnt"),
        About::Stage(StageName::kind) => ("what the stage is", "Art der Stufe"),
        About::Stage(StageName::ratio) => (
            "i_s, turns of the actuator's output per turn of the mechanism; a coupling has 1 without it",
            "i_s, Umdrehungen des Antriebs je Umdrehung des Mechanismus; eine Kupplung hat ohne Angabe 1",
        ),
        About::Stage(StageName::ratios) => (
            "several ratios, of which the best is found",
            "mehrere Übersetzungen, aus denen die beste gesucht wird",
        ),
        About::Stage(StageName::efficiency) => ("efficiency while the actuator drives", "Wirkungsgrad, wenn der Antrieb treibt"),
        About::Stage(StageName::efficiency_back) => (
            "efficiency while the mechanism drives",
            "Wirkungsgrad, wenn der Mechanismus treibt",
        ),
        About::Stage(StageName::inertia_driving) => (
            "J_1, moment of inertia of what turns with the actuator",
            "J_1, Massenträgheitsmoment dessen, was sich mit dem Antrieb dreht",
        ),
        About::Stage(StageName::inertia_driven) => (
            "J_2, moment of inertia of what turns with the mechanism; zero where neither J_1 nor J_2 is stated",
            "J_2, Massenträgheitsmoment dessen, was sich mit dem Mechanismus dreht; null, wo weder J_1 noch J_2 angegeben ist",
        ),
        About::Stage(StageName::stiffness) => (
            "K_s, torsional stiffness of the stage on the side of the mechanism; rigid without it",
            "K_s, Torsionssteifigkeit der Stufe auf der Seite des Mechanismus; ohne Angabe starr",
        ),
        About::Stage(StageName::backlash) => ("backlash on the side of the mechanism; none without it", "Spiel auf der Seite des Mechanismus; ohne Angabe keines"),
        About::Stage(StageName::pitch_diameter) => (
            "pitch diameter of pulley or wheel on the actuator",
            "Wirkdurchmesser von Scheibe oder Rad am Antrieb",
        ),
        About::Body(BodyName::shape) => ("shape of the body", "Form des Körpers"),
        About::Body(BodyName::diameter) => (
            "diameter of cylinder, disc, cone (at its base) or sphere",
            "Durchmesser von Zylinder, Scheibe, Kegel (unten) oder Kugel",
        ),
        About::Body(BodyName::length) => ("length along the body's own axis", "Länge in Richtung der eigenen Achse"),
        About::Body(BodyName::outer) => ("outer diameter of a tube", "Außendurchmesser eines Rohrs"),
        About::Body(BodyName::inner) => ("inner diameter of a tube", "Innendurchmesser eines Rohrs"),
        About::Body(BodyName::a) => (
            "first side of a box, across the axis of rotation",
            "erste Seite eines Quaders, quer zur Drehachse",
        ),
        About::Body(BodyName::b) => (
            "second side of a box, across the axis of rotation",
            "zweite Seite eines Quaders, quer zur Drehachse",
        ),
        About::Body(BodyName::height) => (
            "height of box or cone along the axis of rotation",
            "Höhe von Quader oder Kegel in Richtung der Drehachse",
        ),
        About::Body(BodyName::axis) => (
            "how cylinder, disc or tube lies to the axis of rotation; parallel without it",
            "wie Zylinder, Scheibe oder Rohr zur Drehachse liegt; ohne Angabe parallel",
        ),
        About::Body(BodyName::mass) => ("mass of one piece; or density", "Masse eines Stücks; oder density"),
        About::Body(BodyName::density) => ("density; or mass", "Dichte; oder mass"),
        About::Body(BodyName::distance) => (
            "distance of the centre of mass from the axis of rotation; zero without it",
            "Abstand des Schwerpunkts von der Drehachse; ohne Angabe null",
        ),
        About::Body(BodyName::angle) => (
            "direction of the centre of mass in the plane of rotation; zero without it",
            "Richtung des Schwerpunkts in der Drehebene; ohne Angabe null",
        ),
        About::Body(BodyName::count) => (
            "equal pieces, evenly spaced on the circle",
            "gleiche Stücke, gleichmäßig auf dem Kreis",
        ),
        About::Columns(ColumnsName::time) => ("name of the column of time", "Name der Zeitspalte"),
        About::Columns(ColumnsName::position) => (
            "name of the column of position; none: there is none",
            "Name der Lagespalte; none: es gibt keine",
        ),
        About::Columns(ColumnsName::speed) => (
            "name of the column of speed; none: there is none",
            "Name der Drehzahl- oder Geschwindigkeitsspalte; none: es gibt keine",
        ),
        About::Columns(ColumnsName::torque) => (
            "name of the column of torque or force; none: there is none",
            "Name der Momenten- oder Kraftspalte; none: es gibt keine",
        ),
        About::Units(UnitsName::time) => (
            "unit of time, if the file does not say it",
            "Einheit der Zeit, wenn die Datei sie nicht nennt",
        ),
        About::Units(UnitsName::position) => (
            "unit of position, if the file does not say it",
            "Einheit der Lage, wenn die Datei sie nicht nennt",
        ),
        About::Units(UnitsName::speed) => (
            "unit of speed, if the file does not say it",
            "Einheit der Drehzahl, wenn die Datei sie nicht nennt",
        ),
        About::Units(UnitsName::torque) => (
            "unit of torque or force, if the file does not say it",
            "Einheit des Moments oder der Kraft, wenn die Datei sie nicht nennt",
        ),
        About::Segment(SegmentName::law) => ("law of the motion", "Bewegungsgesetz"),
        About::Segment(SegmentName::speed) => (
            "largest speed, at the output or along the line; negative for the way back",
            "größte Drehzahl am Abtrieb oder Geschwindigkeit längs der Führung; negativ für den Rückweg",
        ),
        About::Segment(SegmentName::accelerate) => (
            "t_1, time of acceleration from rest",
            "t_1, Beschleunigungszeit aus dem Stillstand",
        ),
        About::Segment(SegmentName::run) => ("t_2, time at constant speed", "t_2, Zeit mit konstanter Drehzahl"),
        About::Segment(SegmentName::brake) => ("t_3, time of braking to rest", "t_3, Bremszeit bis zum Stillstand"),
        About::Segment(SegmentName::pause) => ("t_p, rest after the move", "t_p, Stillstand nach der Bewegung"),
        About::Segment(SegmentName::distance) => ("travel, negative backwards", "Weg, rückwärts negativ"),
        About::Segment(SegmentName::time) => ("duration of the segment", "Dauer des Abschnitts"),
        About::Segment(SegmentName::acceleration) => (
            "largest acceleration and deceleration",
            "größte Beschleunigung und Verzögerung",
        ),
        About::Segment(SegmentName::jerk) => ("largest jerk", "größter Ruck"),
        About::Segment(SegmentName::end_speed) => (
            "speed at the end of the segment; rest without it",
            "Geschwindigkeit am Ende des Abschnitts; ohne Angabe Stillstand",
        ),
        About::Segment(SegmentName::hold) => (
            "what holds the load at rest",
            "was die Last im Stillstand hält",
        ),
        About::Segment(SegmentName::file) => (
            "CSV or Parquet file with the recording, beside the project file",
            "CSV- oder Parquet-Datei mit der Aufzeichnung, neben der Projektdatei",
        ),
        About::Segment(SegmentName::columns) => (
            "names of its columns, where they are not the usual ones",
            "Namen ihrer Spalten, wo es nicht die üblichen sind",
        ),
        About::Segment(SegmentName::units) => (
            "units of its columns, where the file does not say them",
            "Einheiten ihrer Spalten, wo die Datei sie nicht nennt",
        ),
        About::Segment(SegmentName::from) => (
            "samples before are left out, in the time of the file",
            "frühere Abtastwerte entfallen, in der Zeit der Datei",
        ),
        About::Segment(SegmentName::to) => (
            "samples after are left out, in the time of the file",
            "spätere Abtastwerte entfallen, in der Zeit der Datei",
        ),
        About::Segment(SegmentName::smoothing) => (
            "width of the window of a moving parabola; nothing is smoothed without it",
            "Fensterbreite einer gleitenden Parabel; ohne Angabe wird nichts geglättet",
        ),
        About::Segment(SegmentName::standstill) => (
            "speeds below this count as standstill",
            "kleinere Drehzahlen gelten als Stillstand",
        ),
        About::Segment(SegmentName::gaps) => (
            "allow: long gaps between samples are meant",
            "allow: lange Lücken zwischen Abtastwerten sind gewollt",
        ),
        About::Segment(SegmentName::payload) => ("mass carried in this segment", "in diesem Abschnitt mitgeführte Masse"),
        About::Segment(SegmentName::payload_inertia) => (
            "moment of inertia at the output carried in this segment",
            "in diesem Abschnitt mitgeführtes Massenträgheitsmoment am Abtrieb",
        ),
        About::Segment(SegmentName::process_force) => (
            "process force along the line in this segment, against the positive direction",
            "Prozesskraft längs der Führung in diesem Abschnitt, gegen die positive Richtung",
        ),
        About::Segment(SegmentName::process_torque) => (
            "process torque at the output in this segment, against the positive direction",
            "Prozessmoment am Abtrieb in diesem Abschnitt, gegen die positive Richtung",
        ),
        About::Segment(SegmentName::bearing) => (
            "loads on the output flange in this segment, instead of [bearing]",
            "Lasten am Abtriebsflansch in diesem Abschnitt, anstelle von [bearing]",
        ),
        About::Segment(SegmentName::points) => (
            "points of a cam table: instant or angle of the master, position; from the position of the axis on",
            "Punkte einer Kurventabelle: Zeitpunkt oder Winkel des Leitantriebs, Stellung; von der Stellung der Achse an",
        ),
        About::Segment(SegmentName::master_speed) => (
            "constant speed of the master, where the points are stated over its angle",
            "konstante Drehzahl des Leitantriebs, wenn die Punkte über seinem Winkel angegeben sind",
        ),
        About::Segment(SegmentName::spline) => (
            "spline between the points: third degree, continuous acceleration; fifth degree, continuous jerk",
            "Spline zwischen den Punkten: dritten Grades, stetige Beschleunigung; fünften Grades, stetiger Ruck",
        ),
        About::Segment(SegmentName::ends) => (
            "what holds at the first and the last point: rest, free of constraints (natural), the same at both (periodic), or as stated",
            "was am ersten und am letzten Punkt gilt: Stillstand, frei (natural), an beiden gleich (periodic) oder wie angegeben",
        ),
        About::Segment(SegmentName::start_speed) => ("speed at the first point", "Drehzahl am ersten Punkt"),
        About::Segment(SegmentName::start_acceleration) => (
            "acceleration at the first point, of the fifth degree",
            "Beschleunigung am ersten Punkt, beim fünften Grad",
        ),
        About::Segment(SegmentName::end_acceleration) => (
            "acceleration at the last point, of the fifth degree",
            "Beschleunigung am letzten Punkt, beim fünften Grad",
        ),
        About::FlangeLoads(FlangeLoadsName::radial_force) => ("F_r, radial force on the flange", "F_r, Radialkraft am Flansch"),
        About::FlangeLoads(FlangeLoadsName::radial_distance) => (
            "L_r, distance of the radial force from the flange face",
            "L_r, Abstand der Radialkraft von der Flanschfläche",
        ),
        About::FlangeLoads(FlangeLoadsName::axial_force) => ("F_a, axial force on the flange", "F_a, Axialkraft am Flansch"),
        About::FlangeLoads(FlangeLoadsName::axial_distance) => (
            "L_a, distance of the axial force from the axis",
            "L_a, Abstand der Axialkraft von der Drehachse",
        ),
        About::Bearing(BearingName::load_factor) => ("f_w, load factor of table 74.2; the life of the output bearing is not checked without it", "f_w, Betriebsfaktor nach Tabelle 74.2; ohne Angabe wird die Lebensdauer des Abtriebslagers nicht geprüft"),
        About::Bearing(BearingName::operating_condition) => (
            "operating condition of table 76.3; the static safety is shown and not judged without it",
            "Betriebsbedingung nach Tabelle 76.3; ohne Angabe wird die statische Sicherheit gezeigt und nicht beurteilt",
        ),
        About::Bearing(BearingName::mechanism) => (
            "loads that follow from the mechanism: they add to the stated ones, are replaced by those of a segment, or do not count; they do not count without it",
            "Lasten, die aus dem Mechanismus folgen: sie kommen zu den angegebenen hinzu, werden von denen eines Abschnitts ersetzt oder zählen nicht; ohne Angabe zählen sie nicht",
        ),
        About::Bearing(BearingName::overhang) => (
            "L, distance of the centre of mass, or of the middle of pulley, pinion or crank pin, from the flange face",
            "L, Abstand des Schwerpunkts oder der Mitte von Scheibe, Ritzel oder Kurbelzapfen von der Flanschfläche",
        ),
        About::Bearing(BearingName::payload_overhang) => (
            "distance of the payload of a segment from the flange face",
            "Abstand der Nutzlast eines Abschnitts von der Flanschfläche",
        ),
        About::Bearing(BearingName::flange_share) => (
            "share of the mechanism's forces that reaches the flange; other bearings carry the rest; needed for a screw, elsewhere 1 without it",
            "Anteil der Kräfte des Mechanismus, der den Flansch erreicht; den Rest tragen andere Lager; beim Gewindetrieb nötig, sonst ohne Angabe 1",
        ),
        About::Bearing(BearingName::belt_tension) => (
            "F_v, tension of each span of the belt at rest",
            "F_v, Trumkraft des Riemens im Stillstand, je Trum",
        ),
        About::Bearing(BearingName::pressure_angle) => (
            "pressure angle of pinion and rack in the normal section",
            "Eingriffswinkel von Ritzel und Zahnstange im Normalschnitt",
        ),
        About::Bearing(BearingName::helix_angle) => (
            "helix angle of the teeth; spur teeth without it",
            "Schrägungswinkel der Verzahnung; ohne Angabe Geradverzahnung",
        ),
        About::Bearing(BearingName::wheel_mass) => (
            "mass of pulley, pinion or crank on the flange; weightless without it",
            "Masse von Scheibe, Ritzel oder Kurbel am Flansch; ohne Angabe gewichtslos",
        ),
        About::Bearing(BearingName::axis_tilt) => (
            "tilt of the rotation axis from the vertical, for the weight of the wheel",
            "Neigung der Drehachse gegen die Senkrechte, für das Gewicht des Rads",
        ),
        About::Requirements(RequirementsName::feedback) => ("permitted motor feedback systems; any without it", "zulässige Motorfeedbacksysteme; ohne Angabe jedes"),
        About::Requirements(RequirementsName::brake) => (
            "with (true) or without (false) holding brake; either without it",
            "mit (true) oder ohne (false) Haltebremse; ohne Angabe beides",
        ),
        About::Requirements(RequirementsName::hollow_shaft_min) => ("smallest bore of the hollow shaft", "kleinster Hohlwellendurchmesser"),
        About::Requirements(RequirementsName::length_max) => ("largest length of the actuator", "größte Länge des Antriebs"),
        About::Requirements(RequirementsName::mass_max) => ("largest mass of the actuator", "größte Masse des Antriebs"),
        About::Requirements(RequirementsName::supply) => ("DC link voltage; the terminal voltage is not checked without it", "Zwischenkreisspannung; ohne Angabe ist die Klemmenspannung nicht geprüft"),
        About::Requirements(RequirementsName::mains) => (
            "mains in place of the DC link, effective between two lines; the edge that is worse for it counts in each check",
            "Netz anstelle des Zwischenkreises, effektiv zwischen zwei Leitern; in jedem Nachweis zählt der ungünstigere Rand",
        ),
        About::Requirements(RequirementsName::mains_phases) => (
            "phases of the mains; three without it",
            "Phasen des Netzes; ohne Angabe drei",
        ),
        About::Requirements(RequirementsName::mains_deviation) => (
            "share by which the mains vary in both directions",
            "Anteil, um den das Netz nach beiden Seiten schwankt",
        ),
        About::Requirements(RequirementsName::modulation_reserve) => (
            "share of U_DC/√2 that the drive can give as fundamental",
            "Anteil von U_DC/√2, den der Regler als Grundwelle stellen kann",
        ),
        About::Requirements(RequirementsName::ambient) => ("ambient temperature in operation; the range of the maker's data without it", "Umgebungstemperatur im Betrieb; ohne Angabe der Bereich der Herstellerangaben"),
        About::Requirements(RequirementsName::bearing_life_min) => (
            "life required of the output bearing",
            "geforderte Lebensdauer des Abtriebslagers",
        ),
        About::Requirements(RequirementsName::gear_life_min) => (
            "life required of the wave-generator bearing",
            "geforderte Lebensdauer des Wave-Generator-Lagers",
        ),
        About::Requirements(RequirementsName::torsion_max) => (
            "torsion of the gear permitted under the largest torque",
            "zulässiger Torsionswinkel des Getriebes unter dem größten Drehmoment",
        ),
        About::Requirements(RequirementsName::natural_frequency_min) => (
            "least first natural frequency with blocked motor",
            "kleinste erste Eigenfrequenz bei blockiertem Motor",
        ),
        About::Requirements(RequirementsName::tilt_angle_max) => (
            "tilt of the flange permitted under the tilting moment",
            "zulässiger Kippwinkel des Flansches unter dem Kippmoment",
        ),
        About::Requirements(RequirementsName::angle_error_max) => (
            "sum of all angular errors permitted at the output",
            "zulässige Summe aller Winkelfehler am Abtrieb",
        ),
        About::Requirements(RequirementsName::lever_arm) => (
            "distance from the axis at which the error is looked at",
            "Abstand von der Drehachse, in dem der Fehler betrachtet wird",
        ),
        About::Requirements(RequirementsName::deviation_max) => (
            "deviation permitted at the lever arm",
            "zulässige Abweichung am Hebelarm",
        ),
        About::Requirements(RequirementsName::resolution_max) => (
            "largest step of the position at the output",
            "größter Schritt der Lage am Abtrieb",
        ),
        About::Requirements(RequirementsName::absolute) => (
            "whether the position must be absolute over the whole travel",
            "ob die Lage über den ganzen Weg absolut sein muss",
        ),
        About::Requirements(RequirementsName::stop_angle_max) => (
            "angle permitted for a stop by the brake alone",
            "zulässiger Winkel eines Halts allein durch die Bremse",
        ),
        About::Requirements(RequirementsName::emergency_stops) => (
            "number of stops by the brake alone",
            "Zahl der Nothalte allein durch die Bremse",
        ),
        About::Requirements(RequirementsName::holding_safety) => (
            "factor by which the brake must hold more than the load asks; 1 without it",
            "Faktor, um den die Bremse mehr halten muss, als die Last verlangt; ohne Angabe 1",
        ),
        About::Requirements(RequirementsName::service_life) => (
            "operating time over the life of the axis, for the number of brakings",
            "Betriebszeit über die Lebensdauer der Achse, für die Zahl der Bremsungen",
        ),
        About::Requirements(RequirementsName::regeneration_power_max) => (
            "mean power that supply or brake resistor take back",
            "mittlere Leistung, die Netz oder Bremswiderstand aufnehmen",
        ),
        About::Requirements(RequirementsName::operation_per_day) => (
            "operation per day, for the battery of the encoder",
            "Betrieb je Tag, für die Batterie des Gebers",
        ),
        About::Requirements(RequirementsName::storage) => (
            "storage before operation, for the battery of the encoder; none without it",
            "Lagerung vor dem Betrieb, für die Batterie des Gebers; ohne Angabe keine",
        ),
        About::Requirements(RequirementsName::battery_life_min) => ("life required of the battery", "geforderte Lebensdauer der Batterie"),
        About::Requirements(RequirementsName::collision_torque) => (
            "largest torque of a collision at the output",
            "größtes Moment einer Kollision am Abtrieb",
        ),
        About::Requirements(RequirementsName::collision_time) => ("duration of a collision", "Dauer einer Kollision"),
        About::Requirements(RequirementsName::collisions) => (
            "number of collisions over the life of the axis",
            "Zahl der Kollisionen über die Lebensdauer der Achse",
        ),
        About::Requirements(RequirementsName::position_loop) => (
            "encoder that closes the position loop; output needs option EC; the motor feedback without it",
            "Geber, über den der Lageregler schließt; output braucht Option EC; ohne Angabe das Motorfeedback",
        ),
        About::Requirements(RequirementsName::dc_link_rise) => (
            "rise of the DC link voltage for which a capacitor bank is sized",
            "Anstieg der Zwischenkreisspannung, für den eine Kondensatorbatterie bemessen wird",
        ),
        About::Requirements(RequirementsName::special_application) => (
            "field of application that needs the maker's approval (section 2.4); an ordinary one without it",
            "Anwendungsbereich, der die Freigabe des Herstellers braucht (Abschnitt 2.4); ohne Angabe ein gewöhnlicher",
        ),
        About::Requirements(RequirementsName::option_1) => ("sensor option", "Option 1 (Sensor)"),
        About::Requirements(RequirementsName::option_2) => ("cable and connector option", "Option 2 (Kabel/Stecker)"),
        About::Actuator(ActuatorName::name) => ("name of the actuator", "Name des Antriebs"),
        About::Actuator(ActuatorName::ratio) => ("i, reduction ratio", "i, Untersetzung"),
        About::Actuator(ActuatorName::torque_max) => ("T_max", "T_max"),
        About::Actuator(ActuatorName::speed_max) => ("n_max at the output", "n_max am Abtrieb"),
        About::Actuator(ActuatorName::speed_motor_max) => ("largest motor speed", "maximale Motordrehzahl"),
        About::Actuator(ActuatorName::speed_motor_rated) => ("n_N, rated motor speed", "n_N, Motor-Bemessungsdrehzahl"),
        About::Actuator(ActuatorName::inertia_out) => (
            "J_out, own moment of inertia at the output",
            "J_out, eigenes Massenträgheitsmoment am Abtrieb",
        ),
        About::Actuator(ActuatorName::stall_torque) => ("T_0", "T_0"),
        About::Actuator(ActuatorName::stall_current) => ("I_0", "I_0"),
        About::Actuator(ActuatorName::current_max) => ("I_max", "I_max"),
        About::Actuator(ActuatorName::current_demagnetisation) => ("I_E", "I_E"),
        About::Actuator(ActuatorName::no_load_starting_current) => ("I_NLS", "I_NLS"),
        About::Actuator(ActuatorName::no_load_current_constant_30) => (
            "K_INL at 30 °C, per output speed",
            "K_INL bei 30 °C, je Abtriebsdrehzahl",
        ),
        About::Actuator(ActuatorName::no_load_current_constant_80) => (
            "K_INL at 80 °C, per output speed",
            "K_INL bei 80 °C, je Abtriebsdrehzahl",
        ),
        About::Actuator(ActuatorName::torque_constant_out) => ("k_Tout", "k_Tout"),
        About::Actuator(ActuatorName::torque_constant_motor) => ("k_TM", "k_TM"),
        About::Actuator(ActuatorName::voltage_constant_motor) => ("k_EM, line to line, rms", "k_EM, Leiter-Leiter, effektiv"),
        About::Actuator(ActuatorName::resistance_ll) => ("R_LL at 20 °C", "R_LL bei 20 °C"),
        About::Actuator(ActuatorName::winding_temperature_max) => (
            "largest temperature of the winding, at which the voltage is checked; the shutdown threshold of the catalogue is assumed without it",
            "größte Temperatur der Wicklung, bei der die Spannung geprüft wird; ohne Angabe wird die Abschaltschwelle des Katalogs angenommen",
        ),
        About::Actuator(ActuatorName::inductance_ll) => ("L_LL", "L_LL"),
        About::Actuator(ActuatorName::pole_pairs) => ("p", "p"),
        About::Actuator(ActuatorName::mass) => ("m", "m"),
        About::Actuator(ActuatorName::length) => ("L", "L"),
        About::Actuator(ActuatorName::hollow_shaft) => ("d_H", "d_H"),
        About::Actuator(ActuatorName::dc_link_max) => ("U_DCmax", "U_DCmax"),
        About::Actuator(ActuatorName::terminal_voltage_min) => (
            "U_M from which the performance holds",
            "U_M, ab der die Leistungsdaten gelten",
        ),
        About::Actuator(ActuatorName::short_time_curve) => (
            "short-time curve by its corner points, from standstill",
            "Kurzzeitkennlinie durch ihre Eckpunkte, ab Stillstand",
        ),
        About::Actuator(ActuatorName::continuous_curve) => (
            "continuous-duty curve by its corner points, from standstill",
            "Dauerbetriebskennlinie durch ihre Eckpunkte, ab Stillstand",
        ),
    };
    pick(language, en, de)
}
