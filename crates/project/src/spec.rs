//! The project file, key by key: one description from which the reader, its messages and the JSON Schema come.

use crate::bodies::{BODY_SHARED, BOX, BodyShape, CONE, CYLINDER, DISC, POINT, ROD, SPHERE, TUBE};
use crate::{Expected, Range};
use quantities::Dimension;

/// What may stand behind a key.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    /// A number with its unit, written as text.
    Quantity(Dimension, Range),
    /// A number with a unit of one of two dimensions: of the rotation, or of the line of a linear mechanism.
    Along(Dimension, Dimension, Range),
    /// A plain number within bounds.
    Number(f64, f64),
    /// A list of plain numbers within bounds, and how many at most.
    Numbers(f64, f64, usize),
    /// A whole number within bounds.
    Integer(i64, i64),
    /// `true` or `false`.
    Bool,
    /// Free text of bounded length.
    Text,
    /// One of these words.
    OneOf(&'static [&'static str]),
    /// A list of these words.
    ListOf(&'static [&'static str]),
    /// Rows of quantities, `[["0 1/min", "32 N m"], …]`.
    Rows(&'static [Dimension]),
    /// A table.
    Table(&'static [Key]),
    /// A table, or an array of tables with more in them.
    OneOrMany(&'static [Key], &'static [Key]),
    /// Solid bodies, one text each.
    Bodies,
    /// An array of tables, each of one of several kinds.
    Variants(&'static Variants),
}

impl Kind {
    /// What may stand there, for a fault.
    pub(crate) const fn expected(&self) -> Expected {
        match *self {
            Self::Quantity(dimension, _) => Expected::Quantity(dimension),
            Self::Along(turning, line, _) => Expected::Along(turning, line),
            Self::Number(..) => Expected::Number,
            Self::Numbers(..) => Expected::Numbers,
            Self::Integer(..) => Expected::Integer,
            Self::Bool => Expected::Bool,
            Self::Text => Expected::Text,
            Self::OneOf(words) => Expected::OneOf(words),
            Self::ListOf(words) => Expected::ListOf(words),
            Self::Rows(_) => Expected::Rows,
            Self::Table(_) | Self::OneOrMany(..) => Expected::Table,
            Self::Bodies => Expected::Bodies,
            Self::Variants(_) => Expected::Tables,
        }
    }
}

/// Tables of several kinds that share a description: one key says which kind it is, and so which others belong.
#[derive(Debug)]
pub(crate) struct Variants {
    pub(crate) keys: &'static [Key],
    /// The key that names the kind.
    pub(crate) by: &'static str,
    /// Name, keys that must be there, keys that may be there besides those of every kind.
    pub(crate) kinds: &'static [(&'static str, &'static [&'static str], &'static [&'static str])],
    /// Keys that every kind may have.
    pub(crate) shared: &'static [&'static str],
}

/// One key of the project file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Key {
    pub(crate) name: &'static str,
    pub(crate) kind: Kind,
    pub(crate) required: bool,
    pub(crate) en: &'static str,
    pub(crate) de: &'static str,
}

const fn key(name: &'static str, kind: Kind, required: bool, en: &'static str, de: &'static str) -> Key {
    Key { name, kind, required, en, de }
}

const fn quantity(name: &'static str, d: Dimension, range: Range, en: &'static str, de: &'static str) -> Key {
    key(name, Kind::Quantity(d, range), false, en, de)
}

const fn along(name: &'static str, d: [Dimension; 2], range: Range, en: &'static str, de: &'static str) -> Key {
    let [turning, line] = d;
    key(name, Kind::Along(turning, line, range), false, en, de)
}

const fn needed(name: &'static str, d: Dimension, range: Range, en: &'static str, de: &'static str) -> Key {
    key(name, Kind::Quantity(d, range), true, en, de)
}

/// The format of the project file that this version reads.
pub(crate) const FORMAT: i64 = 1;

/// Feedback systems in the spelling of the ordering code.
pub(crate) const FEEDBACKS: &[&str] = &["C1024", "M512P", "RES", "D2048", "M128S"];

/// Fields of application of section 2.4.
pub(crate) const APPLICATIONS: &[&str] = &[
    "aerospace",
    "explosive_atmosphere",
    "nuclear",
    "vacuum",
    "household",
    "medical",
    "human_contact",
    "lifting_of_persons",
    "amusement",
];

/// The root of the project file.
#[rustfmt::skip] // one line per key
pub(crate) const ROOT: &[Key] = &[
    key("format", Kind::Integer(FORMAT, FORMAT), true, "version of the file format, 1", "Version des Dateiformats, 1"),
    key("axis", Kind::OneOrMany(AXIS, AXES), false, "the axis; or [[axis]], several axes with load, motion and all else inside", "die Achse; oder [[axis]], mehrere Achsen mit Last, Bewegung und allem anderen darin"),
    key("load", Kind::Table(LOAD), false, "what is moved, referred to the output; or [mechanism.…]", "was bewegt wird, auf den Abtrieb bezogen; oder [mechanism.…]"),
    key("mechanism", Kind::Table(MECHANISM), false, "what lies between output and load; one of its tables", "was zwischen Abtrieb und Last liegt; eine seiner Tabellen"),
    key("stage", Kind::Table(STAGE), false, "belt, gear or coupling between actuator and mechanism", "Riemen, Getriebestufe oder Kupplung zwischen Antrieb und Mechanismus"),
    key("motion", Kind::Variants(&MOTIONS), false, "the moves of one cycle, in order", "die Bewegungen eines Zyklus, der Reihe nach"),
    key("bearing", Kind::Table(BEARING), false, "loads on the output flange", "Lasten am Abtriebsflansch"),
    key("requirements", Kind::Table(REQUIREMENTS), false, "what the actuator must have", "was der Antrieb haben muss"),
    key("actuator", Kind::Table(ACTUATOR), false, "an actuator that the catalogue lacks", "ein Antrieb, der nicht im Katalog steht"),
    key("curve", Kind::Variants(&CURVES), false, "measured or digitised curves of the torque-speed plane; they win over the catalogue's", "gemessene oder digitalisierte Kennlinien; sie gehen denen des Katalogs vor"),
];

/// Curves of the user for actuators of the catalogue.
#[rustfmt::skip] // one line per kind
static CURVES: Variants = Variants {
    keys: CURVE,
    by: "kind",
    kinds: &[
        ("continuous", &["code", "points", "source"], &[]),
        ("s3_50", &["code", "points", "source"], &[]),
        ("s3_25", &["code", "points", "source"], &[]),
        ("short_time", &["code", "points", "source"], &[]),
    ],
    shared: &[],
};

#[rustfmt::skip] // one line per key
const CURVE: &[Key] = &[
    key("kind", Kind::OneOf(&["continuous", "s3_50", "s3_25", "short_time"]), true, "what the curve limits", "was die Kennlinie begrenzt"),
    key("code", Kind::Text, false, "codes it holds for; * stands for any field: CHA-25A-100-*", "Codes, für die sie gilt; * steht für jedes Feld: CHA-25A-100-*"),
    key("points", Kind::Rows(&[Dimension::AngularVelocity, Dimension::Torque]), false, "corner points from standstill, speed and torque at the output", "Eckpunkte ab Stillstand, Drehzahl und Drehmoment am Abtrieb"),
    key("source", Kind::Text, false, "where the curve is from", "woher die Kennlinie ist"),
];

#[rustfmt::skip] // one line per key
const AXIS: &[Key] = &[
    key("name", Kind::Text, false, "name of the axis", "Name der Achse"),
    key("single_move", Kind::Bool, false, "true: the motion is one move and need not come back", "true: die Bewegung ist einmalig und muss nicht zurückkehren"),
];

/// One of several axes: what stands at the root for a single one.
#[rustfmt::skip] // one line per key
const AXES: &[Key] = &[
    key("name", Kind::Text, true, "name of the axis", "Name der Achse"),
    key("single_move", Kind::Bool, false, "true: the motion is one move and need not come back", "true: die Bewegung ist einmalig und muss nicht zurückkehren"),
    key("load", Kind::Table(LOAD), false, "what is moved, referred to the output; or [mechanism.…]", "was bewegt wird, auf den Abtrieb bezogen; oder [mechanism.…]"),
    key("mechanism", Kind::Table(MECHANISM), false, "what lies between output and load; one of its tables", "was zwischen Abtrieb und Last liegt; eine seiner Tabellen"),
    key("stage", Kind::Table(STAGE), false, "belt, gear or coupling between actuator and mechanism", "Riemen, Getriebestufe oder Kupplung zwischen Antrieb und Mechanismus"),
    key("motion", Kind::Variants(&MOTIONS), false, "the moves of one cycle, in order", "die Bewegungen eines Zyklus, der Reihe nach"),
    key("bearing", Kind::Table(BEARING), false, "loads on the output flange", "Lasten am Abtriebsflansch"),
    key("requirements", Kind::Table(REQUIREMENTS), false, "what the actuator must have", "was der Antrieb haben muss"),
    key("actuator", Kind::Table(ACTUATOR), false, "an actuator that the catalogue lacks", "ein Antrieb, der nicht im Katalog steht"),
];

#[rustfmt::skip] // one line per key
const LOAD: &[Key] = &[
    needed("inertia", Dimension::MomentOfInertia, Range::NotNegative, "J_L, moment of inertia of the load at the output", "J_L, Massenträgheitsmoment der Last am Abtrieb"),
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE,
];

#[rustfmt::skip] // one line per key
const FRICTION_TORQUE: Key = quantity("friction_torque", Dimension::Torque, Range::NotNegative, "T_L, friction torque at the output; opposes every motion", "T_L, Reibmoment am Abtrieb; wirkt jeder Bewegung entgegen");
#[rustfmt::skip] // one line per key
const VISCOUS_FRICTION: Key = quantity("viscous_friction", Dimension::ViscousFriction, Range::NotNegative, "friction at the output in proportion to the speed", "drehzahlproportionale Reibung am Abtrieb");
#[rustfmt::skip] // one line per key
const EXTERNAL_TORQUE: Key = quantity("external_torque", Dimension::Torque, Range::Any, "constant torque at the output against the positive direction; does not reverse", "konstantes Moment am Abtrieb gegen die positive Richtung; kehrt nicht um");
#[rustfmt::skip] // one line per key
const EFFICIENCY: Key = key("efficiency", Kind::Number(0.01, 1.0), false, "efficiency while the actuator drives the load", "Wirkungsgrad, wenn der Antrieb die Last treibt");
#[rustfmt::skip] // one line per key
const EFFICIENCY_BACK: Key = key("efficiency_back", Kind::Number(0.0, 1.0), false, "efficiency while the load drives the actuator", "Wirkungsgrad, wenn die Last den Antrieb treibt");
#[rustfmt::skip] // one line per key
const MASS: Key = needed("mass", Dimension::Mass, Range::NotNegative, "moved mass", "bewegte Masse");
#[rustfmt::skip] // one line per key
const TURNING_INERTIA: Key = quantity("inertia", Dimension::MomentOfInertia, Range::NotNegative, "moment of inertia of what turns with the output", "Massenträgheitsmoment dessen, was sich mit dem Abtrieb dreht");
#[rustfmt::skip] // one line per key
const INCLINATION: Key = quantity("inclination", Dimension::Angle, Range::Any, "positive direction above the horizontal; 90 deg is upwards; horizontal without it", "positive Richtung über der Waagerechten; 90 deg ist aufwärts; ohne Angabe waagerecht");
#[rustfmt::skip] // one line per key
const COUNTERWEIGHT: Key = quantity("counterweight", Dimension::Mass, Range::NotNegative, "counterweight that moves with the slide", "mitbewegtes Gegengewicht");
#[rustfmt::skip] // one line per key
const FRICTION_FORCE: Key = quantity("friction_force", Dimension::Force, Range::NotNegative, "friction force of seals and guides", "Reibkraft von Dichtungen und Führungen");
#[rustfmt::skip] // one line per key
const FRICTION_COEFFICIENT: Key = key("friction_coefficient", Kind::Number(0.0, 10.0), false, "friction coefficient of the guide", "Reibzahl der Führung");
#[rustfmt::skip] // one line per key
const PROCESS_FORCE: Key = quantity("process_force", Dimension::Force, Range::Any, "process force along the line, against the positive direction; does not reverse", "Prozesskraft längs der Führung, gegen die positive Richtung; kehrt nicht um");
#[rustfmt::skip] // one line per key
const START_ANGLE: Key = needed("start_angle", Dimension::Angle, Range::Any, "position in which the motion begins", "Stellung, in der die Bewegung beginnt");

#[rustfmt::skip] // one line per key
const MECHANISM: &[Key] = &[
    key("turntable", Kind::Table(TURNTABLE), false, "turntable or drum of solid bodies", "Drehtisch oder Trommel aus Vollkörpern"),
    key("arm", Kind::Table(ARM), false, "unbalanced arm", "unausgewuchteter Arm"),
    key("screw", Kind::Table(SCREW), false, "screw with slide", "Gewindetrieb mit Schlitten"),
    key("belt", Kind::Table(BELT), false, "belt, or rack and pinion, with slide", "Zahnriemen oder Zahnstange mit Schlitten"),
    key("conveyor", Kind::Table(CONVEYOR), false, "conveyor or roller that runs endlessly", "endlos laufendes Förderband oder Walze"),
    key("slider_crank", Kind::Table(SLIDER_CRANK), false, "crank, rod and slider", "Schubkurbel"),
    key("joint", Kind::Table(JOINT), false, "joint of a robot, its torque recorded with the motion", "Robotergelenk, dessen Moment mit der Bewegung aufgezeichnet ist"),
    key("table", Kind::Table(TABLE), false, "inertia and torque over the position", "Massenträgheitsmoment und Moment über der Stellung"),
];

#[rustfmt::skip] // one line per key
const STAGE: &[Key] = &[
    key("kind", Kind::OneOf(&["belt", "gear", "coupling"]), true, "what the stage is", "Art der Stufe"),
    key("ratio", Kind::Number(0.01, 1000.0), false, "i_s, turns of the actuator's output per turn of the mechanism", "i_s, Umdrehungen des Antriebs je Umdrehung des Mechanismus"),
    key("ratios", Kind::Numbers(0.01, 1000.0, crate::stage::RATIOS_MOST), false, "several ratios, of which the best is found", "mehrere Übersetzungen, aus denen die beste gesucht wird"),
    key("efficiency", Kind::Number(0.01, 1.0), false, "efficiency while the actuator drives", "Wirkungsgrad, wenn der Antrieb treibt"),
    key("efficiency_back", Kind::Number(0.0, 1.0), false, "efficiency while the mechanism drives", "Wirkungsgrad, wenn der Mechanismus treibt"),
    quantity("inertia_driving", Dimension::MomentOfInertia, Range::NotNegative, "J_1, moment of inertia of what turns with the actuator", "J_1, Massenträgheitsmoment dessen, was sich mit dem Antrieb dreht"),
    quantity("inertia_driven", Dimension::MomentOfInertia, Range::NotNegative, "J_2, moment of inertia of what turns with the mechanism", "J_2, Massenträgheitsmoment dessen, was sich mit dem Mechanismus dreht"),
    quantity("stiffness", Dimension::TorsionalStiffness, Range::Positive, "K_s, torsional stiffness of the stage on the side of the mechanism", "K_s, Torsionssteifigkeit der Stufe auf der Seite des Mechanismus"),
    quantity("backlash", Dimension::Angle, Range::NotNegative, "backlash on the side of the mechanism", "Spiel auf der Seite des Mechanismus"),
    quantity("pitch_diameter", Dimension::Length, Range::Positive, "pitch diameter of pulley or wheel on the actuator", "Wirkdurchmesser von Scheibe oder Rad am Antrieb"),
];

/// Solid bodies by their shapes.
static BODIES: Variants = Variants {
    keys: BODY,
    by: "shape",
    kinds: &[
        of_shape(CYLINDER),
        of_shape(DISC),
        of_shape(TUBE),
        of_shape(BOX),
        of_shape(CONE),
        of_shape(SPHERE),
        of_shape(POINT),
        of_shape(ROD),
    ],
    shared: BODY_SHARED,
};

/// What a shape needs and what it may have besides.
const fn of_shape(shape: BodyShape) -> (&'static str, &'static [&'static str], &'static [&'static str]) {
    (shape.name, shape.dimensions, if shape.may_lie { &["axis"] } else { &[] })
}

/// A solid body, in a table of the project file and in one line of text alike.
#[rustfmt::skip] // one line per key
pub(crate) const BODY: &[Key] = &[
    key("shape", Kind::OneOf(&["cylinder", "disc", "tube", "box", "cone", "sphere", "point", "rod"]), true, "shape of the body", "Form des Körpers"),
    quantity("diameter", Dimension::Length, Range::Positive, "diameter of cylinder, disc, cone (at its base) or sphere", "Durchmesser von Zylinder, Scheibe, Kegel (unten) oder Kugel"),
    quantity("length", Dimension::Length, Range::Positive, "length along the body's own axis", "Länge in Richtung der eigenen Achse"),
    quantity("outer", Dimension::Length, Range::Positive, "outer diameter of a tube", "Außendurchmesser eines Rohrs"),
    quantity("inner", Dimension::Length, Range::NotNegative, "inner diameter of a tube", "Innendurchmesser eines Rohrs"),
    quantity("a", Dimension::Length, Range::Positive, "first side of a box, across the axis of rotation", "erste Seite eines Quaders, quer zur Drehachse"),
    quantity("b", Dimension::Length, Range::Positive, "second side of a box, across the axis of rotation", "zweite Seite eines Quaders, quer zur Drehachse"),
    quantity("height", Dimension::Length, Range::Positive, "height of box or cone along the axis of rotation", "Höhe von Quader oder Kegel in Richtung der Drehachse"),
    key("axis", Kind::OneOf(&["parallel", "perpendicular"]), false, "how cylinder, disc or tube lies to the axis of rotation; parallel without it", "wie Zylinder, Scheibe oder Rohr zur Drehachse liegt; ohne Angabe parallel"),
    quantity("mass", Dimension::Mass, Range::Positive, "mass of one piece; or density", "Masse eines Stücks; oder density"),
    quantity("density", Dimension::MassDensity, Range::Positive, "density; or mass", "Dichte; oder mass"),
    quantity("distance", Dimension::Length, Range::NotNegative, "distance of the centre of mass from the axis of rotation; zero without it", "Abstand des Schwerpunkts von der Drehachse; ohne Angabe null"),
    quantity("angle", Dimension::Angle, Range::Any, "direction of the centre of mass in the plane of rotation; zero without it", "Richtung des Schwerpunkts in der Drehebene; ohne Angabe null"),
    key("count", Kind::Integer(1, u32::MAX as i64), false, "equal pieces, evenly spaced on the circle; one without it", "gleiche Stücke, gleichmäßig auf dem Kreis; ohne Angabe eines"),
];

#[rustfmt::skip] // one line per key
const TURNTABLE: &[Key] = &[
    key("body", Kind::Variants(&BODIES), false, "its solid bodies, each a table; or bodies", "seine Vollkörper, je eine Tabelle; oder bodies"),
    key("bodies", Kind::Bodies, false, "the same, each in one line as for antrieb inertia", "dasselbe, je Körper eine Zeile wie bei antrieb inertia"),
    quantity("axis_tilt", Dimension::Angle, Range::Any, "tilt of the rotation axis from the vertical; vertical without it", "Neigung der Drehachse gegen die Senkrechte; ohne Angabe senkrecht"),
    quantity("start_angle", Dimension::Angle, Range::Any, "position in which the motion begins; zero without it", "Stellung, in der die Bewegung beginnt; ohne Angabe null"),
    quantity("payload_distance", Dimension::Length, Range::NotNegative, "distance of the payload of a segment from the axis", "Abstand der Nutzlast eines Abschnitts von der Drehachse"),
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const ARM: &[Key] = &[
    needed("inertia", Dimension::MomentOfInertia, Range::NotNegative, "moment of inertia of the arm about the axis, without payload", "Massenträgheitsmoment des Arms um die Drehachse, ohne Nutzlast"),
    needed("mass", Dimension::Mass, Range::NotNegative, "mass of the arm", "Masse des Arms"),
    needed("centre_distance", Dimension::Length, Range::NotNegative, "distance of its centre of mass from the axis", "Abstand seines Schwerpunkts von der Drehachse"),
    quantity("payload_distance", Dimension::Length, Range::NotNegative, "distance of the payload of a segment from the axis", "Abstand der Nutzlast eines Abschnitts von der Drehachse"),
    needed("axis_tilt", Dimension::Angle, Range::Any, "tilt of the rotation axis from the vertical; 90 deg for a horizontal axis", "Neigung der Drehachse gegen die Senkrechte; 90 deg bei waagerechter Achse"),
    START_ANGLE, FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const SCREW: &[Key] = &[
    needed("lead", Dimension::Length, Range::Positive, "travel per revolution", "Steigung, Weg je Umdrehung"),
    MASS, TURNING_INERTIA, INCLINATION, COUNTERWEIGHT, FRICTION_FORCE, FRICTION_COEFFICIENT, PROCESS_FORCE,
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const BELT: &[Key] = &[
    needed("pulley_diameter", Dimension::Length, Range::Positive, "pitch diameter of the driving pulley or pinion", "Wirkdurchmesser der Antriebsscheibe oder des Ritzels"),
    MASS, TURNING_INERTIA, INCLINATION, COUNTERWEIGHT, FRICTION_FORCE, FRICTION_COEFFICIENT, PROCESS_FORCE,
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const CONVEYOR: &[Key] = &[
    needed("roller_diameter", Dimension::Length, Range::Positive, "diameter of the driving roller", "Durchmesser der Antriebswalze"),
    MASS, TURNING_INERTIA, INCLINATION, FRICTION_FORCE, FRICTION_COEFFICIENT, PROCESS_FORCE,
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const SLIDER_CRANK: &[Key] = &[
    needed("crank", Dimension::Length, Range::Positive, "crank radius", "Kurbelradius"),
    needed("rod", Dimension::Length, Range::Positive, "rod length, longer than the crank", "Pleuellänge, größer als der Kurbelradius"),
    MASS, TURNING_INERTIA, INCLINATION, START_ANGLE, PROCESS_FORCE,
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const TABLE: &[Key] = &[
    key("points", Kind::Rows(&[Dimension::Angle, Dimension::MomentOfInertia, Dimension::Torque]), true, "position, moment of inertia, holding torque; straight between the points", "Stellung, Massenträgheitsmoment, Haltemoment; gerade zwischen den Punkten"),
    START_ANGLE, FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const JOINT: &[Key] = &[
    quantity("inertia", Dimension::MomentOfInertia, Range::Positive, "largest moment of inertia that the joint feels, for the ratio of inertias, the natural frequency and the brake; it is in the recorded torque already", "größtes Massenträgheitsmoment am Gelenk, für Trägheitsverhältnis, Eigenfrequenz und Bremse; im aufgezeichneten Moment steckt es schon"),
    quantity("holding_torque", Dimension::Torque, Range::NotNegative, "largest torque that holds the arm at rest, for the brake", "größtes Moment, das den Arm im Stillstand hält, für die Bremse"),
];

/// Names of the columns of a recording; `none` where a name must not be taken for a role.
#[rustfmt::skip] // one line per key
const COLUMNS: &[Key] = &[
    key("time", Kind::Text, false, "name of the column of time", "Name der Zeitspalte"),
    key("position", Kind::Text, false, "name of the column of position; none: there is none", "Name der Lagespalte; none: es gibt keine"),
    key("speed", Kind::Text, false, "name of the column of speed; none: there is none", "Name der Drehzahl- oder Geschwindigkeitsspalte; none: es gibt keine"),
    key("torque", Kind::Text, false, "name of the column of torque or force; none: there is none", "Name der Momenten- oder Kraftspalte; none: es gibt keine"),
];

#[rustfmt::skip] // one line per key
const UNITS: &[Key] = &[
    key("time", Kind::Text, false, "unit of time, if the file does not say it", "Einheit der Zeit, wenn die Datei sie nicht nennt"),
    key("position", Kind::Text, false, "unit of position, if the file does not say it", "Einheit der Lage, wenn die Datei sie nicht nennt"),
    key("speed", Kind::Text, false, "unit of speed, if the file does not say it", "Einheit der Drehzahl, wenn die Datei sie nicht nennt"),
    key("torque", Kind::Text, false, "unit of torque or force, if the file does not say it", "Einheit des Moments oder der Kraft, wenn die Datei sie nicht nennt"),
];

/// The laws of motion with the keys that each needs and those it may have.
#[rustfmt::skip] // one line per law
static MOTIONS: Variants = Variants {
    keys: MOTION,
    by: "law",
    kinds: &[
        ("manual", &["speed", "accelerate", "run", "brake", "pause"], &[]),
        ("trapezoid", &[], &["distance", "time", "speed", "acceleration", "end_speed"]),
        ("triangle", &[], &["distance", "time", "speed", "acceleration"]),
        ("jerk", &["distance", "speed", "acceleration", "jerk"], &["end_speed"]),
        ("polynomial_5", &[], &["distance", "time", "speed", "acceleration", "end_speed"]),
        ("modified_sine", &[], &["distance", "time", "speed", "acceleration"]),
        ("modified_trapezoid", &[], &["distance", "time", "speed", "acceleration"]),
        ("simple_sine", &[], &["distance", "time", "speed", "acceleration"]),
        ("inclined_sine", &[], &["distance", "time", "speed", "acceleration"]),
        ("parabola", &[], &["distance", "time", "speed", "acceleration"]),
        ("constant", &["speed"], &["time", "distance"]),
        ("dwell", &["time"], &["hold"]),
        ("recorded", &["file"], &["columns", "units", "from", "to", "smoothing", "standstill", "gaps"]),
    ],
    shared: &["payload", "payload_inertia", "process_force", "process_torque", "bearing"],
};

#[rustfmt::skip] // one line per law
const LAWS: &[&str] = &[
    "manual", "trapezoid", "triangle", "jerk", "polynomial_5", "modified_sine", "modified_trapezoid", "simple_sine",
    "inclined_sine", "parabola", "constant", "dwell", "recorded",
];

#[rustfmt::skip] // one line per key
const MOTION: &[Key] = &[
    key("law", Kind::OneOf(LAWS), true, "law of the motion", "Bewegungsgesetz"),
    along("speed", [Dimension::AngularVelocity, Dimension::Velocity], Range::Any, "largest speed, at the output or along the line; negative for the way back", "größte Drehzahl am Abtrieb oder Geschwindigkeit längs der Führung; negativ für den Rückweg"),
    quantity("accelerate", Dimension::Time, Range::NotNegative, "t_1, time of acceleration from rest", "t_1, Beschleunigungszeit aus dem Stillstand"),
    quantity("run", Dimension::Time, Range::NotNegative, "t_2, time at constant speed", "t_2, Zeit mit konstanter Drehzahl"),
    quantity("brake", Dimension::Time, Range::NotNegative, "t_3, time of braking to rest", "t_3, Bremszeit bis zum Stillstand"),
    quantity("pause", Dimension::Time, Range::NotNegative, "t_p, rest after the move", "t_p, Stillstand nach der Bewegung"),
    along("distance", [Dimension::Angle, Dimension::Length], Range::Any, "travel, negative backwards", "Weg, rückwärts negativ"),
    quantity("time", Dimension::Time, Range::NotNegative, "duration of the segment", "Dauer des Abschnitts"),
    along("acceleration", [Dimension::AngularAcceleration, Dimension::Acceleration], Range::Positive, "largest acceleration and deceleration", "größte Beschleunigung und Verzögerung"),
    along("jerk", [Dimension::AngularJerk, Dimension::Jerk], Range::Positive, "largest jerk", "größter Ruck"),
    along("end_speed", [Dimension::AngularVelocity, Dimension::Velocity], Range::Any, "speed at the end of the segment; rest without it", "Geschwindigkeit am Ende des Abschnitts; ohne Angabe Stillstand"),
    key("hold", Kind::OneOf(&["motor", "brake", "free"]), false, "what holds the load at rest; the motor without it", "was die Last im Stillstand hält; ohne Angabe der Motor"),
    key("file", Kind::Text, false, "CSV or Parquet file with the recording, beside the project file", "CSV- oder Parquet-Datei mit der Aufzeichnung, neben der Projektdatei"),
    key("columns", Kind::Table(COLUMNS), false, "names of its columns, where they are not the usual ones", "Namen ihrer Spalten, wo es nicht die üblichen sind"),
    key("units", Kind::Table(UNITS), false, "units of its columns, where the file does not say them", "Einheiten ihrer Spalten, wo die Datei sie nicht nennt"),
    quantity("from", Dimension::Time, Range::Any, "samples before are left out, in the time of the file", "frühere Abtastwerte entfallen, in der Zeit der Datei"),
    quantity("to", Dimension::Time, Range::Any, "samples after are left out, in the time of the file", "spätere Abtastwerte entfallen, in der Zeit der Datei"),
    quantity("smoothing", Dimension::Time, Range::Positive, "width of the window of a moving parabola; nothing is smoothed without it", "Fensterbreite einer gleitenden Parabel; ohne Angabe wird nichts geglättet"),
    along("standstill", [Dimension::AngularVelocity, Dimension::Velocity], Range::Positive, "speeds below this count as standstill", "kleinere Drehzahlen gelten als Stillstand"),
    key("gaps", Kind::OneOf(&["allow"]), false, "allow: long gaps between samples are meant", "allow: lange Lücken zwischen Abtastwerten sind gewollt"),
    quantity("payload", Dimension::Mass, Range::NotNegative, "mass carried in this segment", "in diesem Abschnitt mitgeführte Masse"),
    quantity("payload_inertia", Dimension::MomentOfInertia, Range::NotNegative, "moment of inertia at the output carried in this segment", "in diesem Abschnitt mitgeführtes Massenträgheitsmoment am Abtrieb"),
    quantity("process_force", Dimension::Force, Range::Any, "process force along the line in this segment, against the positive direction", "Prozesskraft längs der Führung in diesem Abschnitt, gegen die positive Richtung"),
    quantity("process_torque", Dimension::Torque, Range::Any, "process torque at the output in this segment, against the positive direction", "Prozessmoment am Abtrieb in diesem Abschnitt, gegen die positive Richtung"),
    key("bearing", Kind::Table(SEGMENT_BEARING), false, "loads on the output flange in this segment, instead of [bearing]", "Lasten am Abtriebsflansch in diesem Abschnitt, anstelle von [bearing]"),
];

#[rustfmt::skip] // one line per key
const SEGMENT_BEARING: &[Key] = &[RADIAL_FORCE, RADIAL_DISTANCE, AXIAL_FORCE, AXIAL_DISTANCE];
#[rustfmt::skip] // one line per key
const RADIAL_FORCE: Key = quantity("radial_force", Dimension::Force, Range::NotNegative, "F_r, radial force on the flange", "F_r, Radialkraft am Flansch");
#[rustfmt::skip] // one line per key
const RADIAL_DISTANCE: Key = quantity("radial_distance", Dimension::Length, Range::NotNegative, "L_r, distance of the radial force from the flange face", "L_r, Abstand der Radialkraft von der Flanschfläche");
#[rustfmt::skip] // one line per key
const AXIAL_FORCE: Key = quantity("axial_force", Dimension::Force, Range::NotNegative, "F_a, axial force on the flange", "F_a, Axialkraft am Flansch");
#[rustfmt::skip] // one line per key
const AXIAL_DISTANCE: Key = quantity("axial_distance", Dimension::Length, Range::NotNegative, "L_a, distance of the axial force from the axis", "L_a, Abstand der Axialkraft von der Drehachse");

#[rustfmt::skip] // one line per key
const BEARING: &[Key] = &[
    RADIAL_FORCE, RADIAL_DISTANCE, AXIAL_FORCE, AXIAL_DISTANCE,
    key("load_factor", Kind::Number(1.0, 3.0), false, "f_w, load factor of table 74.2", "f_w, Betriebsfaktor nach Tabelle 74.2"),
    key("operating_condition", Kind::OneOf(&["normal", "shock", "high_accuracy"]), false, "operating condition of table 76.3", "Betriebsbedingung nach Tabelle 76.3"),
    key("mechanism", Kind::OneOf(&["add", "replace", "ignore"]), false, "loads that follow from the mechanism: they add to the stated ones, are replaced by those of a segment, or do not count; they do not count without it", "Lasten, die aus dem Mechanismus folgen: sie kommen zu den angegebenen hinzu, werden von denen eines Abschnitts ersetzt oder zählen nicht; ohne Angabe zählen sie nicht"),
    quantity("overhang", Dimension::Length, Range::Any, "L, distance of the centre of mass, or of the middle of pulley, pinion or crank pin, from the flange face", "L, Abstand des Schwerpunkts oder der Mitte von Scheibe, Ritzel oder Kurbelzapfen von der Flanschfläche"),
    quantity("payload_overhang", Dimension::Length, Range::Any, "distance of the payload of a segment from the flange face", "Abstand der Nutzlast eines Abschnitts von der Flanschfläche"),
    key("flange_share", Kind::Number(0.0, 1.0), false, "share of the mechanism's forces that reaches the flange; other bearings carry the rest", "Anteil der Kräfte des Mechanismus, der den Flansch erreicht; den Rest tragen andere Lager"),
    quantity("belt_tension", Dimension::Force, Range::NotNegative, "F_v, tension of each span of the belt at rest", "F_v, Trumkraft des Riemens im Stillstand, je Trum"),
    quantity("pressure_angle", Dimension::Angle, Range::Positive, "pressure angle of pinion and rack in the normal section", "Eingriffswinkel von Ritzel und Zahnstange im Normalschnitt"),
    quantity("helix_angle", Dimension::Angle, Range::NotNegative, "helix angle of the teeth; spur teeth without it", "Schrägungswinkel der Verzahnung; ohne Angabe Geradverzahnung"),
    quantity("wheel_mass", Dimension::Mass, Range::NotNegative, "mass of pulley, pinion or crank on the flange", "Masse von Scheibe, Ritzel oder Kurbel am Flansch"),
    quantity("axis_tilt", Dimension::Angle, Range::Any, "tilt of the rotation axis from the vertical, for the weight of the wheel", "Neigung der Drehachse gegen die Senkrechte, für das Gewicht des Rads"),
];

#[rustfmt::skip] // one line per key
const REQUIREMENTS: &[Key] = &[
    key("feedback", Kind::ListOf(FEEDBACKS), false, "permitted motor feedback systems", "zulässige Motorfeedbacksysteme"),
    key("brake", Kind::Bool, false, "with (true) or without (false) holding brake", "mit (true) oder ohne (false) Haltebremse"),
    quantity("hollow_shaft_min", Dimension::Length, Range::NotNegative, "smallest bore of the hollow shaft", "kleinster Hohlwellendurchmesser"),
    quantity("length_max", Dimension::Length, Range::Positive, "largest length of the actuator", "größte Länge des Antriebs"),
    quantity("mass_max", Dimension::Mass, Range::Positive, "largest mass of the actuator", "größte Masse des Antriebs"),
    quantity("supply", Dimension::Voltage, Range::Positive, "DC link voltage", "Zwischenkreisspannung"),
    key("modulation_reserve", Kind::Number(0.5, 1.0), false, "share of U_DC/√2 that the drive can give as fundamental", "Anteil von U_DC/√2, den der Regler als Grundwelle stellen kann"),
    quantity("ambient", Dimension::Temperature, Range::Any, "ambient temperature in operation", "Umgebungstemperatur im Betrieb"),
    quantity("bearing_life_min", Dimension::Time, Range::Positive, "life required of the output bearing", "geforderte Lebensdauer des Abtriebslagers"),
    quantity("gear_life_min", Dimension::Time, Range::Positive, "life required of the wave-generator bearing", "geforderte Lebensdauer des Wave-Generator-Lagers"),
    quantity("torsion_max", Dimension::Angle, Range::Positive, "torsion of the gear permitted under the largest torque", "zulässiger Torsionswinkel des Getriebes unter dem größten Drehmoment"),
    quantity("natural_frequency_min", Dimension::Frequency, Range::Positive, "least first natural frequency with blocked motor", "kleinste erste Eigenfrequenz bei blockiertem Motor"),
    quantity("tilt_angle_max", Dimension::Angle, Range::Positive, "tilt of the flange permitted under the tilting moment", "zulässiger Kippwinkel des Flansches unter dem Kippmoment"),
    quantity("angle_error_max", Dimension::Angle, Range::Positive, "sum of all angular errors permitted at the output", "zulässige Summe aller Winkelfehler am Abtrieb"),
    quantity("lever_arm", Dimension::Length, Range::Positive, "distance from the axis at which the error is looked at", "Abstand von der Drehachse, in dem der Fehler betrachtet wird"),
    quantity("deviation_max", Dimension::Length, Range::Positive, "deviation permitted at the lever arm", "zulässige Abweichung am Hebelarm"),
    quantity("resolution_max", Dimension::Angle, Range::Positive, "largest step of the position at the output", "größter Schritt der Lage am Abtrieb"),
    key("absolute", Kind::Bool, false, "whether the position must be absolute over the whole travel", "ob die Lage über den ganzen Weg absolut sein muss"),
    quantity("stop_angle_max", Dimension::Angle, Range::Positive, "angle permitted for a stop by the brake alone", "zulässiger Winkel eines Halts allein durch die Bremse"),
    key("emergency_stops", Kind::Integer(0, 1_000_000), false, "number of stops by the brake alone", "Zahl der Nothalte allein durch die Bremse"),
    key("holding_safety", Kind::Number(1.0, 100.0), false, "factor by which the brake must hold more than the load asks; 1 without it", "Faktor, um den die Bremse mehr halten muss, als die Last verlangt; ohne Angabe 1"),
    quantity("service_life", Dimension::Time, Range::Positive, "operating time over the life of the axis, for the number of brakings", "Betriebszeit über die Lebensdauer der Achse, für die Zahl der Bremsungen"),
    quantity("regeneration_power_max", Dimension::Power, Range::Positive, "mean power that supply or brake resistor take back", "mittlere Leistung, die Netz oder Bremswiderstand aufnehmen"),
    quantity("operation_per_day", Dimension::Time, Range::NotNegative, "operation per day, for the battery of M128S", "Betrieb je Tag, für die Batterie von M128S"),
    quantity("storage", Dimension::Time, Range::NotNegative, "storage before operation, for the battery of M128S", "Lagerung vor dem Betrieb, für die Batterie von M128S"),
    quantity("battery_life_min", Dimension::Time, Range::Positive, "life required of the battery", "geforderte Lebensdauer der Batterie"),
    quantity("collision_torque", Dimension::Torque, Range::Positive, "largest torque of a collision at the output", "größtes Moment einer Kollision am Abtrieb"),
    quantity("collision_time", Dimension::Time, Range::Positive, "duration of a collision", "Dauer einer Kollision"),
    key("collisions", Kind::Integer(0, 1_000_000), false, "number of collisions over the life of the axis", "Zahl der Kollisionen über die Lebensdauer der Achse"),
    key("position_loop", Kind::OneOf(&["motor", "output"]), false, "encoder that closes the position loop; output needs option EC; the motor feedback without it", "Geber, über den der Lageregler schließt; output braucht Option EC; ohne Angabe das Motorfeedback"),
    quantity("dc_link_rise", Dimension::Voltage, Range::Positive, "rise of the DC link voltage for which a capacitor bank is sized", "Anstieg der Zwischenkreisspannung, für den eine Kondensatorbatterie bemessen wird"),
    key("special_application", Kind::OneOf(APPLICATIONS), false, "field of application that needs the maker's approval (section 2.4)", "Anwendungsbereich, der die Freigabe des Herstellers braucht (Abschnitt 2.4)"),
    key("option_1", Kind::OneOf(&["EC"]), false, "sensor option", "Option 1 (Sensor)"),
    key("option_2", Kind::OneOf(&["K", "R", "S"]), false, "cable and connector option", "Option 2 (Kabel/Stecker)"),
];

#[rustfmt::skip] // one line per key
const ACTUATOR: &[Key] = &[
    key("name", Kind::Text, true, "name of the actuator", "Name des Antriebs"),
    key("ratio", Kind::Number(1.0, 10_000.0), false, "i, reduction ratio", "i, Untersetzung"),
    quantity("torque_max", Dimension::Torque, Range::Positive, "T_max", "T_max"),
    quantity("speed_max", Dimension::AngularVelocity, Range::Positive, "n_max at the output", "n_max am Abtrieb"),
    quantity("speed_motor_max", Dimension::AngularVelocity, Range::Positive, "largest motor speed", "maximale Motordrehzahl"),
    quantity("speed_motor_rated", Dimension::AngularVelocity, Range::Positive, "n_N, rated motor speed", "n_N, Motor-Bemessungsdrehzahl"),
    quantity("inertia_out", Dimension::MomentOfInertia, Range::NotNegative, "J_out, own moment of inertia at the output", "J_out, eigenes Massenträgheitsmoment am Abtrieb"),
    quantity("stall_torque", Dimension::Torque, Range::Positive, "T_0", "T_0"),
    quantity("stall_current", Dimension::Current, Range::Positive, "I_0", "I_0"),
    quantity("current_max", Dimension::Current, Range::Positive, "I_max", "I_max"),
    quantity("current_demagnetisation", Dimension::Current, Range::Positive, "I_E", "I_E"),
    quantity("no_load_starting_current", Dimension::Current, Range::NotNegative, "I_NLS", "I_NLS"),
    quantity("no_load_current_constant_30", Dimension::NoLoadCurrentConstant, Range::NotNegative, "K_INL at 30 °C, per output speed", "K_INL bei 30 °C, je Abtriebsdrehzahl"),
    quantity("no_load_current_constant_80", Dimension::NoLoadCurrentConstant, Range::NotNegative, "K_INL at 80 °C, per output speed", "K_INL bei 80 °C, je Abtriebsdrehzahl"),
    quantity("torque_constant_out", Dimension::TorqueConstant, Range::Positive, "k_Tout", "k_Tout"),
    quantity("torque_constant_motor", Dimension::TorqueConstant, Range::Positive, "k_TM", "k_TM"),
    quantity("voltage_constant_motor", Dimension::VoltageConstant, Range::Positive, "k_EM, line to line, rms", "k_EM, Leiter-Leiter, effektiv"),
    quantity("resistance_ll", Dimension::Resistance, Range::Positive, "R_LL at 20 °C", "R_LL bei 20 °C"),
    quantity("winding_temperature_max", Dimension::Temperature, Range::Any, "largest temperature of the winding, at which the voltage is checked; 90 °C is assumed without it", "größte Temperatur der Wicklung, bei der die Spannung geprüft wird; ohne Angabe werden 90 °C angenommen"),
    quantity("inductance_ll", Dimension::Inductance, Range::Positive, "L_LL", "L_LL"),
    key("pole_pairs", Kind::Integer(1, 100), false, "p", "p"),
    quantity("mass", Dimension::Mass, Range::Positive, "m", "m"),
    quantity("length", Dimension::Length, Range::Positive, "L", "L"),
    quantity("hollow_shaft", Dimension::Length, Range::NotNegative, "d_H", "d_H"),
    quantity("dc_link_max", Dimension::Voltage, Range::Positive, "U_DCmax", "U_DCmax"),
    quantity("terminal_voltage_min", Dimension::Voltage, Range::Positive, "U_M from which the performance holds", "U_M, ab der die Leistungsdaten gelten"),
    key("short_time_curve", Kind::Rows(&[Dimension::AngularVelocity, Dimension::Torque]), false, "short-time curve by its corner points, from standstill", "Kurzzeitkennlinie durch ihre Eckpunkte, ab Stillstand"),
    key("continuous_curve", Kind::Rows(&[Dimension::AngularVelocity, Dimension::Torque]), false, "continuous-duty curve by its corner points, from standstill", "Dauerbetriebskennlinie durch ihre Eckpunkte, ab Stillstand"),
];
