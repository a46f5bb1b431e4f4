//! Words for the keys of the project file.

use crate::actuator_keys::actuator_key_text;
use crate::mechanism_keys::{mechanism_key_text, mechanism_text};
use crate::pick;
use crate::recorded_keys::{column_text, ratio_text, unit_text};
use crate::texts::said;
use crate::twin_keys::{replaced_key_text, twin_key_text};
use project::names::{
    ActuatorEntryName, ActuatorName, AxisName, BearingName, BodyName, CatalogueFileName, CatalogueHeadName,
    CatalogueName, CounterweightName, CurveName, DriveName, FlangeLoadsName, FrictionName, GuideName, LoadName,
    LossesName, OneOfSeveralName, PartsName, ProcessForceName, RequirementsName, RootName, SegmentName, SlideName,
    StageName, StartAngleName,
};
use project::{About, Key};
use quantities::Language;

/// Returns the description of a key of the project file, with its default or assumption.
#[must_use]
pub fn key_text(key: &Key, language: Language) -> String {
    let about = about_text(key.about, language);
    let is_assumed = key.note.is_some();
    let assumed =
        if is_assumed { said!(language => ", listed as assumed" | ", als Annahme ausgewiesen") } else { "".into() };
    let Some(default) = key.default.map(|default| default()) else {
        // What concerns the author of the file stands after a semicolon: a label ends there.
        let tail = said!(language => "; if not stated, listed as assumed" | "; ohne Angabe als Annahme ausgewiesen");
        return if is_assumed && !about.contains(';') { format!("{about}{tail}") } else { format!("{about}{assumed}") };
    };
    let is_number = default.parse::<f64>().is_ok();
    let mark = language.decimal_mark().to_string();
    let default = if is_number { default.replace('.', &mark) } else { default };
    said!(language => "{about}; default {default}{assumed}" | "{about}; ohne Angabe {default}{assumed}")
}

/// Returns the purpose of a key of the project file.
#[must_use]
#[rustfmt::skip] // one line per key and language
pub const fn about_text(about: About, language: Language) -> &'static str {
    let (en, de) = match about {
        About::Mechanisms(name) => return mechanism_text(name, language),
        About::ActuatorValue(key) => return actuator_key_text(key, language),
        About::Actuator(ActuatorName::name) => ("name of the actuator", "Name des Antriebs"),
        About::Root(RootName::catalogue) => (
            "products of other manufacturers, evaluated together with the built-in series",
            "Produkte anderer Hersteller, zusammen mit der mitgelieferten Baureihe bewertet",
        ),
        About::Catalogue(CatalogueName::files) => (
            "catalogue files in TOML or CSV, relative to the project",
            "Katalogdateien in TOML oder CSV, relativ zum Projekt",
        ),
        About::Catalogue(CatalogueName::cha) => (
            "built-in series included",
            "mitgelieferte Baureihe berücksichtigt",
        ),
        About::CatalogueFile(CatalogueFileName::catalogue) => (
            "statements that apply to all products of the file",
            "Angaben, die für alle Produkte der Datei gelten",
        ),
        About::CatalogueFile(CatalogueFileName::actuator) => (
            "actuators with gear, one table each",
            "Antriebe mit Getriebe, je eine Tabelle",
        ),
        About::CatalogueHead(CatalogueHeadName::maker) | About::ActuatorEntry(ActuatorEntryName::maker) => ("manufacturer", "Hersteller"),
        About::CatalogueHead(CatalogueHeadName::series) | About::ActuatorEntry(ActuatorEntryName::series) => ("series", "Baureihe"),
        About::CatalogueHead(CatalogueHeadName::source) | About::ActuatorEntry(ActuatorEntryName::source) => (
            "document from which the data are taken",
            "Dokument, aus dem die Daten stammen",
        ),
        About::CatalogueHead(CatalogueHeadName::date) => ("date of the data", "Stand der Daten"),
        About::ActuatorEntry(ActuatorEntryName::id) => (
            "name of the product, as it is ordered",
            "Name des Produkts, wie es bestellt wird",
        ),
        About::ActuatorEntry(ActuatorEntryName::price) => ("price with its currency", "Preis mit Währung"),
        About::ActuatorEntry(ActuatorEntryName::lead_time) => ("time of delivery", "Lieferzeit"),
        About::Twin(name) => return twin_key_text(name, language),
        About::Replaced(name) => return replaced_key_text(name, language),
        About::Mechanism(name) => return mechanism_key_text(name, language),
        About::Measured(key) => return super::measured_key_text(key, language),
        About::Root(RootName::format) => ("version of the file format, 1", "Version des Dateiformats, 1"),
        About::Root(RootName::axis) => (
            "the axis; or [[axis]] for several axes, each with its load, motion and all other tables",
            "die Achse; oder [[axis]] für mehrere Achsen, jede mit Last, Bewegung und allen weiteren Tabellen",
        ),
        About::Parts(PartsName::load) => (
            "moved load, referred to the output; or [mechanism.…]",
            "bewegte Last, auf den Abtrieb bezogen; oder [mechanism.…]",
        ),
        About::Parts(PartsName::mechanism) => (
            "mechanism between output and load; one of its tables",
            "Mechanik zwischen Abtrieb und Last; eine ihrer Tabellen",
        ),
        About::Parts(PartsName::stage) => (
            "belt, gear or coupling between actuator and mechanism",
            "Riemen, Getriebestufe oder Kupplung zwischen Antrieb und Mechanik",
        ),
        About::Parts(PartsName::motion) => ("the moves of one cycle, in order", "Bewegungen eines Zyklus in ihrer Reihenfolge"),
        About::Parts(PartsName::twin) => ("settings of the simulation", "Vorgaben für die Simulation"),
        About::Parts(PartsName::bearing) => ("loads on the output flange", "Lasten am Abtriebsflansch"),
        About::Parts(PartsName::requirements) => ("requirements on the actuator", "Anforderungen an den Antrieb"),
        About::Parts(PartsName::drive) => ("the drive that supplies the motor", "Servoregler, der den Motor speist"),
        About::Drive(DriveName::current_continuous) => (
            "continuous current of the drive, rms per phase",
            "Dauerstrom des Servoreglers, Effektivwert je Phase",
        ),
        About::Drive(DriveName::current_peak) => (
            "peak current of the drive, rms per phase",
            "Spitzenstrom des Servoreglers, Effektivwert je Phase",
        ),
        About::Drive(DriveName::peak_time) => (
            "longest permissible time above the continuous current; default: not limited",
            "längste zulässige Zeit über dem Dauerstrom; ohne Angabe nicht begrenzt",
        ),
        About::Parts(PartsName::actuator) => ("an actuator not contained in the catalogue", "ein Antrieb, der nicht im Katalog enthalten ist"),
        About::Root(RootName::curve) => (
            "measured or digitised torque-speed curves; they take precedence over those of the catalogue",
            "gemessene oder digitalisierte Kennlinien; sie haben Vorrang vor denen des Katalogs",
        ),
        About::Curve(CurveName::kind) => ("type of limit", "Art der Grenze"),
        About::Curve(CurveName::code) => (
            "ordering codes for which the curve is valid; * stands for any field: CHA-25A-100-*",
            "Bestellbezeichnungen, für die die Kennlinie gilt; * steht für jedes Feld: CHA-25A-100-*",
        ),
        About::Curve(CurveName::points) => (
            "corner points from standstill, speed and torque at the output",
            "Eckpunkte ab Stillstand, Drehzahl und Drehmoment am Abtrieb",
        ),
        About::Curve(CurveName::source) => ("source of the curve", "Quelle der Kennlinie"),
        About::Axis(AxisName::name) | About::OneOfSeveral(OneOfSeveralName::name) => ("name of the axis", "Name der Achse"),
        About::Axis(AxisName::single_move) | About::OneOfSeveral(OneOfSeveralName::single_move) => (
            "true: the motion is a single move and does not have to return",
            "true: einmalige Bewegung ohne Rückkehr",
        ),
        About::Load(LoadName::inertia) => (
            "J_L, moment of inertia of the load at the output",
            "J_L, Massenträgheitsmoment der Last am Abtrieb",
        ),
        About::Friction(FrictionName::friction_torque) => (
            "T_L, friction torque at the output; opposes every motion; zero if no friction is stated",
            "T_L, Reibmoment am Abtrieb; wirkt jeder Bewegung entgegen; null, wenn keine Reibung angegeben ist",
        ),
        About::Friction(FrictionName::viscous_friction) => (
            "viscous friction at the output, proportional to the speed",
            "viskose Reibung am Abtrieb, proportional zur Drehzahl",
        ),
        About::Friction(FrictionName::external_torque) => (
            "constant torque at the output against the positive direction; does not change sign with the motion",
            "konstantes Moment am Abtrieb entgegen der positiven Richtung; unabhängig von der Bewegungsrichtung",
        ),
        About::Losses(LossesName::efficiency) => (
            "efficiency while the actuator drives the load",
            "Wirkungsgrad bei treibendem Antrieb",
        ),
        About::Losses(LossesName::efficiency_back) => (
            "efficiency while the load drives the actuator",
            "Wirkungsgrad bei treibender Last",
        ),
        About::Slide(SlideName::mass) => ("moved mass", "bewegte Masse"),
        About::Slide(SlideName::inertia) => (
            "moment of inertia of the parts rotating with the output",
            "Massenträgheitsmoment der mit dem Abtrieb umlaufenden Teile",
        ),
        About::Slide(SlideName::inclination) => (
            "angle of the positive direction above the horizontal; 90 deg is upwards; default: horizontal",
            "Winkel der positiven Richtung über der Waagerechten; 90 deg ist aufwärts; ohne Angabe waagerecht",
        ),
        About::Counterweight(CounterweightName::counterweight) => ("counterweight; moves with the load and reduces it by its weight; on a hoist with as many falls as the load", "Gegengewicht; bewegt sich mit und entlastet um sein Gewicht; am Hubwerk mit gleich vielen Seilsträngen wie die Last"),
        About::Guide(GuideName::friction_force) => ("friction force of seals and guides", "Reibungskraft von Dichtungen und Führungen"),
        About::Guide(GuideName::friction_coefficient) => ("friction coefficient of the guide", "Reibungszahl der Führung"),
        About::ProcessForce(ProcessForceName::process_force) => (
            "process force along the guide, against the positive direction; does not change sign with the motion",
            "Prozesskraft längs der Führung, entgegen der positiven Richtung; unabhängig von der Bewegungsrichtung",
        ),
        About::StartAngle(StartAngleName::start_angle) => ("position at the beginning of the motion; default: zero", "Position zu Beginn der Bewegung; ohne Angabe null"),
        About::Stage(StageName::kind) => ("type of the stage", "Art der Stufe"),
        About::Stage(StageName::ratio) => (
            "i_s, turns of the actuator output per turn of the mechanism; default for a coupling: 1",
            "i_s, Umdrehungen des Antriebs je Umdrehung der Mechanik; bei einer Kupplung ohne Angabe 1",
        ),
        About::Stage(StageName::ratios) => (
            "several ratios from which the best is selected",
            "mehrere Übersetzungen, aus denen die beste ausgewählt wird",
        ),
        About::Stage(StageName::efficiency) => ("efficiency while the actuator drives", "Wirkungsgrad bei treibendem Antrieb"),
        About::Stage(StageName::efficiency_back) => (
            "efficiency while the mechanism drives",
            "Wirkungsgrad bei treibender Mechanik",
        ),
        About::Stage(StageName::inertia_driving) => (
            "J_1, moment of inertia of the parts rotating with the actuator",
            "J_1, Massenträgheitsmoment der mit dem Antrieb umlaufenden Teile",
        ),
        About::Stage(StageName::inertia_driven) => (
            "J_2, moment of inertia of the parts rotating with the mechanism; zero if neither J_1 nor J_2 is stated",
            "J_2, Massenträgheitsmoment der mit der Mechanik umlaufenden Teile; null, wenn weder J_1 noch J_2 angegeben ist",
        ),
        About::Stage(StageName::stiffness) => (
            "K_s, torsional stiffness of the stage on the mechanism side; default: rigid",
            "K_s, Torsionssteifigkeit der Stufe auf der Seite der Mechanik; ohne Angabe starr",
        ),
        About::Stage(StageName::backlash) => ("backlash on the mechanism side; default: none", "Spiel auf der Seite der Mechanik; ohne Angabe keines"),
        About::Stage(StageName::pitch_diameter) => (
            "pitch diameter of the pulley or gear wheel on the actuator",
            "Wirkdurchmesser der Scheibe oder Teilkreisdurchmesser des Rads am Antrieb",
        ),
        About::Body(BodyName::shape) => ("shape of the body", "Form des Körpers"),
        About::Body(BodyName::diameter) => (
            "diameter of a round body: cylinder, disc, cone (base) or sphere",
            "Durchmesser eines runden Körpers: Zylinder, Scheibe, Kegel (unten) oder Kugel",
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
            "orientation of a round body to the axis of rotation: cylinder, disc or tube; default: parallel",
            "Ausrichtung eines runden Körpers zur Drehachse: Zylinder, Scheibe oder Rohr; ohne Angabe parallel",
        ),
        About::Body(BodyName::mass) => ("mass of one body; or density", "Masse eines Körpers; oder density"),
        About::Body(BodyName::density) => ("density; or mass", "Dichte; oder mass"),
        About::Body(BodyName::distance) => (
            "distance of the centre of mass from the axis of rotation; default: zero",
            "Abstand des Schwerpunkts von der Drehachse; ohne Angabe null",
        ),
        About::Body(BodyName::angle) => (
            "direction of the centre of mass in the plane of rotation; default: zero",
            "Richtung des Schwerpunkts in der Drehebene; ohne Angabe null",
        ),
        About::Body(BodyName::count) => (
            "number of equal bodies, evenly spaced on the circle",
            "Anzahl gleicher Körper, gleichmäßig auf dem Kreis verteilt",
        ),
        About::Columns(key) => return column_text(key, language),
        About::Units(key) => return unit_text(key, language),
        About::Ratios(key) => return ratio_text(key, language),
        About::Segment(SegmentName::recorded_ratio) => (
            "ratio of the recorded gear, for quantities recorded at the motor",
            "Übersetzung des aufgezeichneten Getriebes, für motorseitig aufgezeichnete Größen",
        ),
        About::Segment(SegmentName::law) => ("motion law", "Bewegungsgesetz"),
        About::Segment(SegmentName::speed) => (
            "maximum speed; at the output or along the guide, negative for the return move",
            "Höchstgeschwindigkeit; Drehzahl am Abtrieb oder Geschwindigkeit längs der Führung, negativ für den Rückweg",
        ),
        About::Segment(SegmentName::accelerate) => (
            "t_1, acceleration time from standstill",
            "t_1, Beschleunigungszeit aus dem Stillstand",
        ),
        About::Segment(SegmentName::run) => ("t_2, time at constant speed", "t_2, Konstantfahrzeit"),
        About::Segment(SegmentName::brake) => ("t_3, braking time to standstill", "t_3, Bremszeit bis zum Stillstand"),
        About::Segment(SegmentName::pause) => ("t_p, pause after the move", "t_p, Pause nach der Bewegung"),
        About::Segment(SegmentName::distance) => ("travel; negative for the reverse direction", "Weg; rückwärts negativ"),
        About::Segment(SegmentName::time) => ("duration of the segment", "Dauer des Abschnitts"),
        About::Segment(SegmentName::acceleration) => (
            "maximum acceleration and deceleration",
            "maximale Beschleunigung und Verzögerung",
        ),
        About::Segment(SegmentName::jerk) => ("maximum jerk", "maximaler Ruck"),
        About::Segment(SegmentName::end_speed) => (
            "speed at the end of the segment; default: standstill",
            "Drehzahl oder Geschwindigkeit am Ende des Abschnitts; ohne Angabe Stillstand",
        ),
        About::Segment(SegmentName::cycle) => (
            "cycle time up to which this dwell lasts, in place of its duration",
            "Zykluszeit, bis zu der diese Rast dauert, anstelle ihrer Dauer",
        ),
        About::Segment(SegmentName::hold) => (
            "means of holding the load at standstill",
            "Halten der Last im Stillstand",
        ),
        About::Segment(SegmentName::file) => (
            "CSV or Parquet file with the recording, beside the project file",
            "CSV- oder Parquet-Datei mit der Aufzeichnung, neben der Projektdatei",
        ),
        About::Segment(SegmentName::columns) => (
            "names of its columns, if they differ from the default names",
            "Namen ihrer Spalten, falls von den Vorgaben abweichend",
        ),
        About::Segment(SegmentName::units) => (
            "units of its columns, if not stated in the file",
            "Einheiten ihrer Spalten, wenn nicht in der Datei angegeben",
        ),
        About::Segment(SegmentName::from) => (
            "start of the window in the time of the file; earlier samples are omitted",
            "Beginn des Fensters in der Zeit der Datei; frühere Abtastwerte entfallen",
        ),
        About::Segment(SegmentName::to) => (
            "end of the window in the time of the file; later samples are omitted",
            "Ende des Fensters in der Zeit der Datei; spätere Abtastwerte entfallen",
        ),
        About::Segment(SegmentName::smoothing) => (
            "window width of a moving parabola; default: no smoothing",
            "Fensterbreite einer gleitenden Parabel; ohne Angabe keine Glättung",
        ),
        About::Segment(SegmentName::standstill) => (
            "speeds below this value are treated as standstill",
            "kleinere Drehzahlen gelten als Stillstand",
        ),
        About::Segment(SegmentName::gaps) => (
            "allow: long gaps between samples are intended",
            "allow: lange Lücken zwischen Abtastwerten sind gewollt",
        ),
        About::Segment(SegmentName::held_values) => (
            "interpolate: of values held over several rows one for each update is used; default: every row as it stands",
            "interpolate: von Werten, die über mehrere Zeilen gehalten sind, zählt einer je Aktualisierung; ohne Angabe jede Zeile, wie sie dasteht",
        ),
        About::Segment(SegmentName::time_stamps) => (
            "even: the rows are evenly spaced, their time stamps scatter about it; default: the time stamps as they stand",
            "even: die Zeilen haben gleichen Abstand, um den die Zeitstempel streuen; ohne Angabe die Zeitstempel, wie sie dastehen",
        ),
        About::Segment(SegmentName::payload) => (
            "payload in this segment; added to the masses of the mechanism",
            "Nutzlast in diesem Abschnitt; wird zu den Massen der Mechanik addiert",
        ),
        About::Segment(SegmentName::payload_inertia) => (
            "moment of inertia of the payload at the output in this segment; added to that of the mechanism",
            "Massenträgheitsmoment der Nutzlast am Abtrieb in diesem Abschnitt; wird zu dem der Mechanik addiert",
        ),
        About::Segment(SegmentName::process_force) => (
            "additional process force in this segment; along the guide, against the positive direction, added to the process force of the mechanism",
            "zusätzliche Prozesskraft in diesem Abschnitt; längs der Führung entgegen der positiven Richtung, wird zur Prozesskraft der Mechanik addiert",
        ),
        About::Segment(SegmentName::process_torque) => (
            "additional process torque in this segment; at the output, against the positive direction, added to external_torque",
            "zusätzliches Prozessmoment in diesem Abschnitt; am Abtrieb entgegen der positiven Richtung, wird zu external_torque addiert",
        ),
        About::Segment(SegmentName::bearing) => (
            "loads on the output flange in this segment; they replace all loads of [bearing], those not stated here are zero",
            "Lasten am Abtriebsflansch in diesem Abschnitt; sie ersetzen alle Lasten aus [bearing], nicht angegebene sind null",
        ),
        About::Segment(SegmentName::points) => (
            "points of a cam table: time or master angle, position; relative to the current position of the axis",
            "Punkte einer Kurventabelle: Zeit oder Winkel des Leitantriebs, Position; bezogen auf die aktuelle Position der Achse",
        ),
        About::Segment(SegmentName::master_speed) => (
            "constant speed of the master, if the points are stated over its angle",
            "konstante Drehzahl des Leitantriebs, wenn die Punkte über seinem Winkel angegeben sind",
        ),
        About::Segment(SegmentName::spline) => (
            "spline between the points: third degree, continuous acceleration; fifth degree, continuous jerk",
            "Spline zwischen den Punkten: dritten Grades, stetige Beschleunigung; fünften Grades, stetiger Ruck",
        ),
        About::Segment(SegmentName::ends) => (
            "boundary conditions at the first and last point: standstill, unconstrained (natural), equal at both (periodic), or as stated",
            "Randbedingungen am ersten und letzten Punkt: Stillstand, frei (natural), an beiden gleich (periodic) oder wie angegeben",
        ),
        About::Segment(SegmentName::start_speed) => ("speed at the first point", "Drehzahl am ersten Punkt"),
        About::Segment(SegmentName::start_acceleration) => (
            "acceleration at the first point, for the fifth degree",
            "Beschleunigung am ersten Punkt, beim fünften Grad",
        ),
        About::Segment(SegmentName::end_acceleration) => (
            "acceleration at the last point, for the fifth degree",
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
        About::Bearing(BearingName::load_factor) => ("f_w, load factor of table 74.2; without it, the life of the output bearing is not checked", "f_w, Betriebsfaktor nach Tabelle 74.2; ohne Angabe wird die Lebensdauer des Abtriebslagers nicht geprüft"),
        About::Bearing(BearingName::operating_condition) => (
            "operating condition of table 76.3; without it, the static safety is shown but not checked",
            "Betriebsbedingung nach Tabelle 76.3; ohne Angabe wird die statische Sicherheit gezeigt, aber nicht geprüft",
        ),
        About::Bearing(BearingName::mechanism) => (
            "loads resulting from the mechanism: added to the stated ones, replaced by those of a segment, or ignored; required beside stated loads, default without these: added",
            "Lasten aus der Mechanik: zu den angegebenen addiert, durch die eines Abschnitts ersetzt oder nicht berücksichtigt; neben angegebenen Lasten erforderlich, ohne solche wirken sie",
        ),
        About::Bearing(BearingName::overhang) => (
            "L, distance of the centre of mass or of the wheel centre from the flange face; wheel: pulley, pinion or crank pin",
            "L, Abstand des Schwerpunkts oder der Radmitte von der Flanschfläche; Rad: Scheibe, Ritzel oder Kurbelzapfen",
        ),
        About::Bearing(BearingName::payload_overhang) => (
            "distance of the payload of a segment from the flange face",
            "Abstand der Nutzlast eines Abschnitts von der Flanschfläche",
        ),
        About::Bearing(BearingName::flange_share) => (
            "share of the mechanism forces acting on the flange; other bearings carry the rest; required for a screw, otherwise default 1",
            "Anteil der Kräfte der Mechanik am Flansch; den Rest nehmen andere Lager auf; beim Gewindetrieb erforderlich, sonst ohne Angabe 1",
        ),
        About::Bearing(BearingName::belt_tension) => (
            "F_v, static tension of each belt span",
            "F_v, statische Trumkraft des Riemens",
        ),
        About::Bearing(BearingName::pressure_angle) => (
            "pressure angle of pinion and rack in the normal section",
            "Eingriffswinkel von Ritzel und Zahnstange im Normalschnitt",
        ),
        About::Bearing(BearingName::helix_angle) => (
            "helix angle of the teeth; default: spur teeth",
            "Schrägungswinkel der Verzahnung; ohne Angabe Geradverzahnung",
        ),
        About::Bearing(BearingName::wheel_mass) => (
            "mass of the wheel on the flange: pulley, pinion or crank; default: massless",
            "Masse des Rads am Flansch: Scheibe, Ritzel oder Kurbel; ohne Angabe masselos",
        ),
        About::Bearing(BearingName::axis_tilt) => (
            "tilt of the rotation axis from the vertical, for the weight of the wheel and of the roll of a winder; winder, default: 90 deg, a horizontal axis",
            "Neigung der Drehachse gegen die Senkrechte, für das Gewicht des Rads und des Wickels; beim Wickler ohne Angabe 90 deg, waagerechte Achse",
        ),
        About::Requirements(RequirementsName::feedback) => ("permitted motor encoders; default: any", "zulässige Motorgeber; ohne Angabe alle"),
        About::Requirements(RequirementsName::brake) => (
            "holding brake; true: required, false: excluded; default: either",
            "Haltebremse; true: gefordert, false: ausgeschlossen; ohne Angabe beides",
        ),
        About::Requirements(RequirementsName::hollow_shaft_min) => ("minimum hollow shaft bore diameter", "minimaler Hohlwellendurchmesser"),
        About::Requirements(RequirementsName::length_max) => ("maximum length of the actuator", "maximale Baulänge des Antriebs"),
        About::Requirements(RequirementsName::mass_max) => ("maximum mass of the actuator", "maximale Masse des Antriebs"),
        About::Requirements(RequirementsName::makers) => (
            "permitted manufacturers, each by its name or the first words of it; default: any",
            "zulässige Hersteller, jeder mit seinem Namen oder dessen ersten Wörtern; ohne Angabe alle",
        ),
        About::Requirements(RequirementsName::price_max) => (
            "maximum price with its currency; compared with the prices of catalogue files",
            "höchster Preis mit Währung; verglichen mit den Preisen der Katalogdateien",
        ),
        About::Requirements(RequirementsName::lead_time_max) => (
            "maximum lead time; compared with those of catalogue files",
            "längste Lieferzeit; verglichen mit denen der Katalogdateien",
        ),
        About::Requirements(RequirementsName::supply) => ("DC link voltage; without it, the terminal voltage is not checked", "Zwischenkreisspannung; ohne Angabe wird die Klemmenspannung nicht geprüft"),
        About::Requirements(RequirementsName::mains) => (
            "mains voltage, line to line, rms; instead of the DC link voltage; each check uses the less favourable limit",
            "Netzspannung, Leiter-Leiter, effektiv; anstelle der Zwischenkreisspannung; in jedem Nachweis gilt der ungünstigere Grenzwert",
        ),
        About::Requirements(RequirementsName::mains_phases) => (
            "number of mains phases; default: three",
            "Phasenzahl des Netzes; ohne Angabe drei",
        ),
        About::Requirements(RequirementsName::mains_deviation) => (
            "relative deviation of the mains voltage in both directions",
            "relative Abweichung der Netzspannung nach beiden Seiten",
        ),
        About::Requirements(RequirementsName::modulation_reserve) => (
            "share of U_DC/√2 that the drive can provide as fundamental",
            "Anteil von U_DC/√2, den der Servoregler als Grundwelle bereitstellen kann",
        ),
        About::Requirements(RequirementsName::ambient) => ("ambient temperature in operation; default: the range of the manufacturer's data", "Umgebungstemperatur im Betrieb; ohne Angabe der Bereich der Herstellerangaben"),
        About::Requirements(RequirementsName::altitude) => (
            "altitude of the place of installation above sea level",
            "Aufstellhöhe über Normalnull",
        ),
        About::Requirements(RequirementsName::altitude_derating) => (
            "share of the continuous torque that is available at this altitude, as confirmed by the manufacturer; the manual states none",
            "bei dieser Aufstellhöhe verfügbarer Anteil des Dauerdrehmoments nach Angabe des Herstellers; die Anleitung nennt keinen",
        ),
        About::Requirements(RequirementsName::protection) => (
            "required degree of protection (EN 60034-5)",
            "geforderte Schutzart (EN 60034-5)",
        ),
        About::Requirements(RequirementsName::humidity_min) => (
            "lowest relative humidity at the place of installation, without condensation",
            "niedrigste relative Luftfeuchte am Aufstellort, ohne Betauung",
        ),
        About::Requirements(RequirementsName::humidity_max) => (
            "highest relative humidity at the place of installation, without condensation",
            "höchste relative Luftfeuchte am Aufstellort, ohne Betauung",
        ),
        About::Requirements(RequirementsName::vibration) => (
            "vibration at the place of installation, peak value of the acceleration",
            "Vibration am Aufstellort, Scheitelwert der Beschleunigung",
        ),
        About::Requirements(RequirementsName::shock) => (
            "largest shock at the place of installation, peak value of the acceleration",
            "größter Schock am Aufstellort, Scheitelwert der Beschleunigung",
        ),
        About::Requirements(RequirementsName::mounting) => (
            "mounting position of the actuator; the manual states no permissible positions",
            "Einbaulage des Antriebs; die Anleitung nennt keine zulässigen Einbaulagen",
        ),
        About::Requirements(RequirementsName::bearing_life_min) => (
            "required life of the output bearing",
            "geforderte Lebensdauer des Abtriebslagers",
        ),
        About::Requirements(RequirementsName::gear_life_min) => (
            "required life of the wave generator bearing",
            "geforderte Lebensdauer des Wave-Generator-Lagers",
        ),
        About::Requirements(RequirementsName::torsion_max) => (
            "permissible torsion angle of gear and stage under the largest torque, with a stage at the mechanism",
            "zulässiger Torsionswinkel von Getriebe und Zwischenstufe unter dem größten Drehmoment, mit Zwischenstufe an der Mechanik",
        ),
        About::Requirements(RequirementsName::natural_frequency_min) => (
            "minimum first natural frequency with locked motor",
            "minimale erste Eigenfrequenz bei blockiertem Motor",
        ),
        About::Requirements(RequirementsName::tilt_angle_max) => (
            "permissible tilt of the flange under the tilting moment",
            "zulässiger Kippwinkel des Flansches unter dem Kippmoment",
        ),
        About::Requirements(RequirementsName::angle_error_max) => (
            "permissible sum of all angular errors at the output, with a stage at the mechanism",
            "zulässige Summe aller Winkelfehler am Abtrieb, mit Zwischenstufe an der Mechanik",
        ),
        About::Requirements(RequirementsName::lever_arm) => (
            "lever arm: distance from the axis at which the deviation is evaluated",
            "Hebelarm: Abstand von der Drehachse, in dem die Abweichung bewertet wird",
        ),
        About::Requirements(RequirementsName::deviation_max) => (
            "permissible deviation at the lever arm, or along the line of a linear mechanism",
            "zulässige Abweichung am Hebelarm oder längs der Führung einer linearen Mechanik",
        ),
        About::Requirements(RequirementsName::resolution_max) => (
            "largest permissible position step at the output",
            "größter zulässiger Positionsschritt am Abtrieb",
        ),
        About::Requirements(RequirementsName::absolute) => (
            "true: the position must be absolute over the whole travel",
            "true: die Position muss über den ganzen Weg absolut sein",
        ),
        About::Requirements(RequirementsName::stop_angle_max) => (
            "permissible angle of a stop by the brake alone",
            "zulässiger Anhaltewinkel allein durch die Bremse",
        ),
        About::Requirements(RequirementsName::emergency_stops) => (
            "number of stops by the brake alone",
            "Anzahl der Not-Halte allein durch die Bremse",
        ),
        About::Requirements(RequirementsName::holding_safety) => (
            "required ratio of brake holding torque to load torque; default 1",
            "geforderte Sicherheit des Haltemoments gegenüber dem Lastmoment; ohne Angabe 1",
        ),
        About::Requirements(RequirementsName::service_life) => (
            "operating time over the life of the axis, for the number of brake applications",
            "Betriebszeit über die Lebensdauer der Achse, für die Anzahl der Bremsungen",
        ),
        About::Requirements(RequirementsName::regeneration_power_max) => (
            "mean power that the supply or the braking resistor can absorb",
            "von Netz oder Bremswiderstand aufnehmbare mittlere Leistung",
        ),
        About::Requirements(RequirementsName::operation_per_day) => (
            "operation per day, for the encoder battery",
            "Betrieb je Tag, für die Geberbatterie",
        ),
        About::Requirements(RequirementsName::storage) => (
            "storage before operation, for the encoder battery; default: none",
            "Lagerung vor dem Betrieb, für die Geberbatterie; ohne Angabe keine",
        ),
        About::Requirements(RequirementsName::battery_life_min) => ("required battery life", "geforderte Lebensdauer der Batterie"),
        About::Requirements(RequirementsName::collision_torque) => (
            "largest torque of a collision at the output",
            "größtes Moment einer Kollision am Abtrieb",
        ),
        About::Requirements(RequirementsName::collision_time) => ("duration of a collision", "Dauer einer Kollision"),
        About::Requirements(RequirementsName::collisions) => (
            "number of collisions over the life of the axis",
            "Anzahl der Kollisionen über die Lebensdauer der Achse",
        ),
        About::Requirements(RequirementsName::position_loop) => (
            "encoder through which the position loop is closed; output requires option EC; default: the motor encoder",
            "Geber des Lageregelkreises; output erfordert Option EC; ohne Angabe der Motorgeber",
        ),
        About::Requirements(RequirementsName::dc_link_rise) => (
            "permissible rise of the DC link voltage for sizing a capacitor bank",
            "zulässiger Anstieg der Zwischenkreisspannung zur Bemessung einer Kondensatorbatterie",
        ),
        About::Requirements(RequirementsName::special_application) => (
            "field of application that requires the manufacturer's approval (section 2.4); default: none",
            "Anwendungsbereich, der die Freigabe des Herstellers erfordert (Abschnitt 2.4); ohne Angabe keiner",
        ),
        About::Requirements(RequirementsName::leave_out) => (
            "data left out knowingly: what depends on them is not checked",
            "bewusst weggelassene Angaben: was davon abhängt, wird nicht geprüft",
        ),
        About::Requirements(RequirementsName::option_1) => ("sensor option", "Option 1 (Sensor)"),
        About::Requirements(RequirementsName::option_2) => ("option 2 (cable, connector)", "Option 2 (Leitung, Stecker)"),
    };
    pick(language, en, de)
}
