//! Comments and names in the examples, which are project files to start from.

use crate::pick;
use crate::texts::said;
use quantities::Language;

/// Returns the translation of an English comment or name of an example; `None` for a text of no example.
#[must_use]
pub fn example_text(english: &str, language: Language) -> Option<&'static str> {
    let (en, de) = EXAMPLE_TEXTS.iter().find(|(en, _)| *en == english)?;
    Some(pick(language, en, de))
}

/// Returns the command that runs an example.
#[must_use]
pub fn how_to_run(file: &str, language: Language) -> String {
    said!(language => "Run: antrieb size {file}" | "Aufruf: antrieb size {file} --lang de")
}

/// Every comment and name of the examples, English and German.
pub const EXAMPLE_TEXTS: &[(&str, &str)] = &[
    // indexing table
    (
        "An indexing table with a horizontal plate: one station forward per cycle.",
        "Ein Rundschalttisch mit waagerechter Platte: taktet je Zyklus um eine Station weiter.",
    ),
    ("\"indexing table\"", "\"Rundschalttisch\""),
    ("referred to the output of the actuator", "auf den Abtrieb des Antriebs bezogen"),
    ("plate with fixtures and parts", "Platte mit Aufnahmen und Werkstücken"),
    ("seals and cable drag; opposes every motion", "Dichtungen und Kabelzug; wirkt jeder Bewegung entgegen"),
    (
        "from rest to rest; several [[motion]] follow each other",
        "von Stillstand zu Stillstand; mehrere [[motion]] folgen aufeinander",
    ),
    (
        "forces on the output flange, constant over the cycle",
        "Kräfte auf den Abtriebsflansch, über den Zyklus konstant",
    ),
    ("weight of plate, fixtures and parts", "Gewicht von Platte, Aufnahmen und Werkstücken"),
    (
        "its centre from the axis, parts on one side only",
        "Abstand des Schwerpunkts von der Drehachse, Werkstücke nur auf einer Seite",
    ),
    ("push of the tool", "Andruck des Werkzeugs"),
    ("above the flange face", "über der Flanschfläche"),
    ("f_w, table 74.2", "f_w, Tabelle 74.2"),
    ("for the cables of the fixtures", "für die Leitungen der Aufnahmen"),
    ("DC link", "Zwischenkreis"),
    // hoist
    (
        "A small hoist on two falls with a counterweight: lift, wait, lower empty.",
        "Ein kleines Hubwerk mit zwei Seilsträngen und Gegengewicht: heben, warten, leer senken.",
    ),
    ("\"hoist\"", "\"Hubwerk\""),
    ("to the middle of the rope", "bis Seilmitte"),
    ("hook block and gripper", "Unterflasche und Greifer"),
    ("drum", "Trommel"),
    ("both falls at position zero", "beide Stränge in Nullposition"),
    ("length of each fall", "Länge jedes Strangs"),
    ("lift, laden", "heben, beladen"),
    ("lower, empty", "senken, leer"),
    // winder
    (
        "A winder that takes up a foil from the core to the full roll.",
        "Ein Wickler, der eine Folie von der Hülse bis zum vollen Wickel aufwickelt.",
    ),
    ("\"winder\"", "\"Wickler\""),
    ("the full roll is changed for a core", "der volle Wickel wird gegen eine Hülse getauscht"),
    ("the radius grows by it with each turn", "Zunahme des Radius je Umdrehung"),
    ("core and shaft", "Hülse und Welle"),
    ("rms values of a phase", "Effektivwerte eines Strangs"),
    ("60 turns from the core to the full roll", "60 Umdrehungen von der Hülse bis zum vollen Wickel"),
    // scissor lift
    (
        "A scissor lift with two stages and a screw at the lower pin: up, wait, down.",
        "Ein Scherenhubtisch mit zwei Scherenpaaren und einer Spindel am unteren Bolzen: heben, warten, senken.",
    ),
    ("\"scissor lift\"", "\"Scherenhubtisch\""),
    ("at position zero", "in Nullposition"),
    ("platform", "Plattform"),
    ("all arms together", "alle Arme zusammen"),
    ("16 turns draw the pins together by 160 mm", "16 Umdrehungen ziehen die Bolzen um 160 mm zusammen"),
    // four-bar
    (
        "A four-bar linkage that swings a gate to and fro while the crank goes round.",
        "Ein Gelenkviereck, das eine Klappe hin und her schwenkt, während die Kurbel umläuft.",
    ),
    ("\"four-bar linkage\"", "\"Gelenkviereck\""),
    ("crank with its disc", "Kurbel mit ihrer Scheibe"),
    ("from the crank pin", "vom Kurbelzapfen"),
    ("from its pivot", "von ihrem Drehpunkt"),
    ("rocker and gate about the pivot", "Schwinge und Klappe um den Drehpunkt"),
    ("the linkage stands upright", "das Gelenkviereck steht senkrecht"),
    // conveyor
    ("A conveyor that moves on by one pitch and waits.", "Ein Förderer, der um eine Teilung weitertaktet und wartet."),
    ("\"conveyor\"", "\"Förderer\""),
    ("belt and goods", "Band und Fördergut"),
    ("all rollers, referred to the driving one", "alle Rollen, auf die Antriebsrolle bezogen"),
    ("one pitch", "eine Teilung"),
    // slider-crank
    (
        "A slider-crank that pushes a slide upwards with each turn.",
        "Eine Schubkurbel, die je Umdrehung einen Schlitten nach oben schiebt.",
    ),
    ("\"slider-crank\"", "\"Schubkurbel\""),
    ("slide with the moving share of the rod", "Schlitten mit oszillierendem Anteil des Pleuels"),
    ("crank with the rotating share of the rod", "Kurbel mit rotierendem Anteil des Pleuels"),
    ("outwards is upwards", "außen ist oben"),
    ("farthest out", "am weitesten außen"),
    // table
    (
        "A load whose inertia and torque are given point by point over one revolution.",
        "Eine Last, deren Trägheit und Drehmoment über eine Umdrehung punktweise gegeben sind.",
    ),
    ("\"load by a table\"", "\"Last aus einer Tabelle\""),
    ("position, moment of inertia, holding torque", "Position, Massenträgheitsmoment, Haltemoment"),
    // turntable
    (
        "A turntable of solid bodies that indexes by 60° with a cam law; the parts sit on a circle.",
        "Ein Drehtisch aus Vollkörpern, der nach einem Bewegungsgesetz um 60° taktet; die Werkstücke sitzen auf einem Kreis.",
    ),
    ("\"turntable\"", "\"Drehtisch\""),
    ("plate of aluminium", "Platte aus Aluminium"),
    ("six fixtures with their parts", "sechs Aufnahmen mit ihren Werkstücken"),
    ("hub of steel", "Nabe aus Stahl"),
    ("seal and cable drag", "Dichtung und Kabelzug"),
    ("weight of table and parts", "Gewicht von Tisch und Werkstücken"),
    ("place of installation: coolant drips", "Aufstellort: tropfendes Kühlmittel"),
    ("where the parts sit", "Position der Werkstücke"),
    // tilting arm
    (
        "A tilting arm with a horizontal axis: it lifts a part, waits at the top, and comes back empty. The brake holds it.",
        "Ein Schwenkarm mit waagerechter Achse: Er hebt ein Werkstück, wartet oben und kehrt leer zurück. Die Bremse hält ihn.",
    ),
    ("\"tilting arm\"", "\"Schwenkarm\""),
    ("about the axis, without the part", "um die Drehachse, ohne Werkstück"),
    ("its centre of mass from the axis", "Abstand seines Schwerpunkts von der Drehachse"),
    ("the part in the gripper", "das Werkstück im Greifer"),
    ("the axis is horizontal: full gravity", "die Achse liegt waagerecht: volle Schwerkraft"),
    ("below the horizontal when the motion begins", "zu Beginn der Bewegung unter der Waagerechten"),
    ("seals and hoses", "Dichtungen und Schläuche"),
    ("up with the part", "mit Werkstück nach oben"),
    ("weight of arm and part, and what the motion adds", "Gewicht von Arm und Werkstück zuzüglich der Massenkräfte"),
    ("held by the brake while the part is taken", "von der Bremse gehalten, während das Werkstück entnommen wird"),
    ("back, empty", "leer zurück"),
    ("the next part is gripped", "das nächste Werkstück wird gegriffen"),
    ("the stated loads are all of them", "die angegebenen Lasten sind alle"),
    (
        "the stated loads are all of them, weight and motion included",
        "die angegebenen Lasten sind alle, mit Gewicht und Bewegung",
    ),
    ("where a segment says nothing else", "wo ein Abschnitt nichts anderes angibt"),
    (
        "absolute, so that it need not search its place after power-off",
        "absolut, damit nach dem Abschalten nicht referenziert werden muss",
    ),
    // screw axis
    (
        "A vertical screw axis, driven without a further gear: press on, retreat. Written along its line.",
        "Eine senkrechte Spindelachse ohne weiteres Getriebe: andrücken, zurückfahren. Angaben entlang der Achse.",
    ),
    ("\"vertical screw axis\"", "\"senkrechte Spindelachse\""),
    ("slide with tool", "Schlitten mit Werkzeug"),
    ("screw and coupling", "Spindel und Kupplung"),
    ("upwards is positive", "aufwärts ist positiv"),
    ("wipers and guides", "Abstreifer und Führungen"),
    ("ball screw", "Kugelgewindetrieb"),
    ("down, fast", "Eilgang nach unten"),
    (
        "pressing: 1.5 kN against the downward tool, so the force is negative",
        "andrücken: 1,5 kN gegen das abwärts fahrende Werkzeug, die Kraft ist also negativ",
    ),
    ("and up again", "und wieder nach oben"),
    // belt axis
    (
        "A horizontal belt axis that carries a part forth and returns empty.",
        "Eine waagerechte Riemenachse, die ein Werkstück transportiert und leer zurückkehrt.",
    ),
    ("\"belt axis\"", "\"Riemenachse\""),
    ("carriage and gripper", "Schlitten und Greifer"),
    ("both pulleys, referred to the driving one", "beide Riemenscheiben, auf die treibende bezogen"),
    ("with the part", "mit Werkstück"),
    (
        "back, empty: any two of distance, time, speed and acceleration",
        "leer zurück: zwei beliebige von distance, time, speed und acceleration",
    ),
    // recording
    (
        "Shoulder of a small robot: position, speed and torque come from a recording.",
        "Schulter eines kleinen Roboters: Position, Drehzahl und Drehmoment aus einer Aufzeichnung.",
    ),
    (
        "The torque is that of the whole arm, with its inertia, gravity and friction, so nothing of the arm is described here.",
        "Das Drehmoment ist das des ganzen Arms mit Trägheit, Schwerkraft und Reibung; der Arm ist hier also nicht beschrieben.",
    ),
    ("\"robot shoulder\"", "\"Roboterschulter\""),
    ("largest at the shoulder, arm stretched, with payload", "größtes an der Schulter, Arm gestreckt, mit Nutzlast"),
    ("arm stretched and level, with payload", "Arm gestreckt und waagerecht, mit Nutzlast"),
    (
        "beside this file; time [s], position [deg], speed [1/min], torque [Nm]",
        "neben dieser Datei; Spalten time [s], position [deg], speed [1/min], torque [Nm]",
    ),
    ("weight of the arm", "Gewicht des Arms"),
    ("cables to the elbow", "Leitungen zum Ellbogen"),
    (
        "Shoulder of an arm with two links, planned motion with inverse dynamics; made by validation/robot-joint",
        "Schulter eines Arms mit zwei Gliedern, geplante Bewegung mit inverser Dynamik",
    ),
];
