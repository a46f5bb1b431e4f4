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

/// Returns the effect of the first line of a template on its figures.
#[must_use]
pub fn figures_of_a_template(language: Language) -> String {
    said!(language =>
        "Figures that are not changed are listed as assumed; deleting the first line confirms them."
        | "Nicht geänderte Zahlenwerte gelten als angenommen; wer die erste Zeile löscht, bestätigt sie."
    )
}

/// Beginnings of the line of a project file that lists the figures of its template which are stated.
const STATED: [&str; 2] = ["# Stated as in the template: ", "# Angegeben wie in der Vorlage: "];

/// Returns the line of a project file that lists figures of its template which are stated.
#[must_use]
pub fn stated_of_template(paths: &[&str], language: Language) -> String {
    let [en, de] = STATED;
    let begin = said!(language => "{en}" | "{de}");
    format!("{begin}{}", paths.join(", "))
}

/// Returns the paths that a line of a project file lists as [`stated_of_template`] does; `None` for another line.
pub fn paths_stated_of_template(line: &str) -> Option<impl Iterator<Item = &str>> {
    let listed = STATED.iter().find_map(|begin| line.strip_prefix(begin))?;
    Some(listed.split(',').map(str::trim))
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
        "A four-bar linkage that swings a gate to and fro while the crank rotates.",
        "Ein Gelenkviereck, das eine Klappe hin und her schwenkt, während die Kurbel umläuft.",
    ),
    ("\"four-bar linkage\"", "\"Gelenkviereck\""),
    ("crank with its disc", "Kurbel mit ihrer Scheibe"),
    ("from the crank pin", "vom Kurbelzapfen"),
    ("from its pivot", "von ihrem Drehpunkt"),
    ("rocker and gate about the pivot", "Schwinge und Klappe um den Drehpunkt"),
    ("the linkage stands upright", "das Gelenkviereck steht senkrecht"),
    // conveyor
    ("A conveyor that indexes by one pitch and dwells.", "Ein Förderer, der um eine Teilung weitertaktet und wartet."),
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
    // plain files
    (
        "An arm that swings to and fro about a horizontal axis. What is not stated is assumed, and listed with the answer.",
        "Ein Arm, der um eine waagerechte Achse hin und zurück schwenkt. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("\"arm\"", "\"Arm\""),
    (
        "rod, taper or point; or state inertia and centre of mass instead",
        "rod (Stab), taper (spitz zulaufend) oder point (Punktmasse); oder statt dessen Trägheitsmoment und Schwerpunkt angeben",
    ),
    ("from the axis to its end", "von der Drehachse bis zum Ende"),
    (
        "a vertical axis; otherwise horizontal, with the full gravity torque",
        "senkrechte Achse; sonst waagerecht, mit dem vollen Lastmoment der Gewichtskraft",
    ),
    ("above the horizontal when the motion begins", "über der Waagerechten zu Beginn der Bewegung"),
    ("of the payload of a segment, from the axis", "Abstand der Nutzlast eines Abschnitts von der Drehachse"),
    ("there", "hin"),
    (
        "the law is not decided; any two of travel, time, largest speed and acceleration",
        "Gesetz nicht festgelegt; zwei beliebige von Weg, Zeit, größter Geschwindigkeit und Beschleunigung",
    ),
    ("carried on this way only", "nur auf diesem Weg mitgeführt"),
    ("pause", "Pause"),
    ("otherwise the motor holds", "sonst hält der Motor"),
    ("and back", "und zurück"),
    ("what is known of the site and of the drive", "was über Aufstellort und Servoregler bekannt ist"),
    ("voltage of the DC link", "Spannung des Zwischenkreises"),
    ("around the actuator", "Umgebung des Antriebs"),
    ("holds the load without power", "hält die Last stromlos"),
    (
        "A carriage on a toothed belt or a rack, to and fro. What is not stated is assumed, and listed with the answer.",
        "Ein Schlitten an Zahnriemen oder Zahnstange, hin und zurück. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("of the driving pulley or pinion", "der Antriebsscheibe oder des Ritzels"),
    ("carriage with all that it carries", "Schlitten mit allem, was er trägt"),
    ("pulleys, referred to the driving one", "Scheiben, auf die treibende bezogen"),
    ("upwards is positive; otherwise horizontal", "aufwärts ist positiv; sonst waagerecht"),
    ("guides", "Führungen"),
    ("of the belt", "des Riemens"),
    ("in every segment; against the positive direction", "in jedem Abschnitt; entgegen der positiven Richtung"),
    (
        "A conveyor that indexes by one pitch and dwells. What is not stated is assumed, and listed with the answer.",
        "Ein Förderband, das um eine Teilung weiterrückt und wartet. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("of the driving roller", "der Antriebsrolle"),
    ("rollers, referred to the driving one", "Rollen, auf die treibende bezogen"),
    ("of the belt on its bed", "des Bands auf dem Gleitbett"),
    ("of the drive", "des Antriebsstrangs"),
    (
        "A four-bar linkage whose rotating crank swings a rocker. What is not stated is assumed, and listed with the answer.",
        "Ein Gelenkviereck, dessen Kurbel umläuft und eine Schwinge bewegt. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("between the fixed pivots", "zwischen den Gestelldrehpunkten"),
    ("rocker and load about its pivot", "Schwinge und Last um ihren Drehpunkt"),
    ("a lying linkage; otherwise upright", "liegendes Gelenkviereck; sonst stehend"),
    ("of the crank when the motion begins", "der Kurbel zu Beginn der Bewegung"),
    ("at the crank", "an der Kurbel"),
    ("one revolution after the other", "eine Umdrehung nach der anderen"),
    (
        "A hoist that lifts and lowers. What is not stated is assumed, and listed with the answer.",
        "Ein Hubwerk, das hebt und senkt. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("strands that carry the load", "tragende Seilstränge"),
    ("load with hook and lower block", "Last mit Haken und Unterflasche"),
    ("on the other side of the drum", "auf der anderen Seite der Trommel"),
    ("of all falls at position zero", "aller Seilstränge in Nullposition"),
    ("of one sheave", "einer Seilrolle"),
    ("of the drum", "der Trommel"),
    ("in every segment; against the lift", "in jedem Abschnitt; gegen den Hub"),
    ("up", "auf"),
    ("and down", "und ab"),
    (
        "A joint whose motion and torque come from a recording. What is not stated is assumed, and listed with the answer.",
        "Ein Gelenk, dessen Bewegung und Moment aus einer Aufzeichnung stammen. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("\"recorded joint\"", "\"aufgezeichnetes Gelenk\""),
    ("largest at the joint, for inertia ratio and brake", "größtes am Gelenk, für Trägheitsverhältnis und Bremse"),
    ("largest at standstill, for the brake", "größtes im Stillstand, für die Bremse"),
    (
        "A load of known inertia at the output, to and fro. What is not stated is assumed, and listed with the answer.",
        "Eine Last mit bekanntem Trägheitsmoment am Abtrieb, hin und zurück. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("\"load at the output\"", "\"Last am Abtrieb\""),
    ("about the axis of the actuator", "um die Achse des Antriebs"),
    ("opposes every motion", "wirkt jeder Bewegung entgegen"),
    ("against the positive direction", "entgegen der positiven Richtung"),
    (
        "A load of known inertia with the move of the manual: accelerate, run, brake, pause.",
        "Eine Last mit bekanntem Trägheitsmoment und der Bewegung der Anleitung: beschleunigen, fahren, bremsen, Pause.",
    ),
    ("from rest to rest", "von Stillstand zu Stillstand"),
    (
        "A scissor lift with a screw at the lower pin, up and down. What is not stated is assumed, and listed with the answer.",
        "Ein Scherenhubtisch mit einer Spindel am unteren Bolzen, auf und ab. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("between the pins at its ends", "zwischen den Endbolzen"),
    ("travel of the nut per revolution", "Weg der Mutter je Umdrehung"),
    ("above the horizontal at position zero", "über der Waagerechten in Nullposition"),
    ("platform with what stands on it", "Plattform mit allem, was darauf steht"),
    ("pairs of arms one above the other", "Scherenpaare übereinander"),
    ("of all arms", "aller Arme"),
    ("at the screw", "an der Spindel"),
    ("of the screw", "der Spindel"),
    ("stroke of the platform", "Hub der Plattform"),
    ("against the lift", "gegen den Hub"),
    (
        "A slide on a screw, to and fro. What is not stated is assumed, and listed with the answer.",
        "Ein Schlitten am Gewindetrieb, hin und zurück. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("\"screw axis\"", "\"Spindelachse\""),
    ("travel per revolution", "Weg je Umdrehung"),
    ("slide with all that it carries", "Schlitten mit allem, was er trägt"),
    ("upwards is positive; 0 deg is horizontal", "aufwärts ist positiv; 0 deg ist waagerecht"),
    ("guides and wipers", "Führungen und Abstreifer"),
    (
        "A slider-crank that pushes a slide to and fro with each turn. What is not stated is assumed, and listed with the answer.",
        "Eine Schubkurbel, die einen Schlitten mit jeder Umdrehung hin und zurück bewegt. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("radius", "Radius"),
    ("longer than the crank", "länger als die Kurbel"),
    ("outwards is upwards; otherwise horizontal", "auswärts ist aufwärts; sonst waagerecht"),
    ("against the slide on its way outwards", "gegen den Schlitten auf dem Weg nach außen"),
    (
        "A turntable, to and fro. What is not stated is assumed, and listed with the answer.",
        "Ein Drehtisch, hin und zurück. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("seals and cable drag", "Dichtungen und Kabelzug"),
    ("further bodies: a table each", "weitere Körper: je eine Tabelle"),
    ("thickness", "Dicke"),
    (
        "A winder that takes up a web at constant line speed. What is not stated is assumed, and listed with the answer.",
        "Ein Wickler, der eine Bahn mit konstanter Geschwindigkeit aufwickelt. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    (
        "An unwinder that pays out a web against a constant tension. What is not stated is assumed, and listed with the answer.",
        "Ein Abwickler, der eine Bahn gegen konstanten Bahnzug abgibt. Was nicht angegeben ist, wird angenommen und mit dem Ergebnis aufgeführt.",
    ),
    ("\"unwinder\"", "\"Abwickler\""),
    ("the empty core is changed for a full roll", "die leere Hülse wird gegen einen vollen Wickel getauscht"),
    ("the web pulls the roll, its diameter decreases", "die Bahn zieht am Wickel, sein Durchmesser nimmt ab"),
    ("the radius shrinks by it with each turn", "Abnahme des Radius je Umdrehung"),
    (
        "the whole roll: the inertia is highest at the start, the speed at the core",
        "der ganze Wickel: das Massenträgheitsmoment ist am Anfang am größten, die Drehzahl an der Hülse",
    ),
    ("of the web, also at standstill", "der Bahn, auch im Stillstand"),
    ("of the wound material", "des gewickelten Materials"),
    ("otherwise the web is wound up", "sonst wird aufgewickelt"),
    ("bearings", "Lager"),
    (
        "the whole roll: the speed is highest at the core, the inertia at the full roll",
        "der ganze Wickel: an der Hülse ist die Drehzahl am höchsten, am vollen Wickel das Trägheitsmoment",
    ),
    ("of the web", "der Bahn"),
    ("from rest to the line speed", "aus dem Stillstand zur Bahngeschwindigkeit"),
    ("and back to rest", "und zurück in den Stillstand"),
];
