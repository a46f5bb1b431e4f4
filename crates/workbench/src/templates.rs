//! Project files to begin with, commented in either language.

use quantities::Language;

/// A kind of project file and the example that it is taken from.
struct Kind {
    name: &'static str,
    text: &'static str,
    /// A recording that the project names.
    recording: Option<(&'static str, &'static str)>,
}

static KINDS: [Kind; 6] = [
    Kind { name: "manual", text: include_str!("../../../examples/indexing-table.toml"), recording: None },
    Kind { name: "table", text: include_str!("../../../examples/turntable.toml"), recording: None },
    Kind { name: "arm", text: include_str!("../../../examples/tilting-arm.toml"), recording: None },
    Kind { name: "screw", text: include_str!("../../../examples/screw-axis.toml"), recording: None },
    Kind { name: "belt", text: include_str!("../../../examples/belt-axis.toml"), recording: None },
    Kind {
        name: "recording",
        text: include_str!("../../../examples/robot-joint.toml"),
        recording: Some(("robot-joint.csv", include_str!("../../../examples/robot-joint.csv"))),
    },
];

/// The kinds of project files to begin with.
pub fn template_kinds() -> impl Iterator<Item = &'static str> {
    KINDS.iter().map(|kind| kind.name)
}

/// A project file to begin with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Template {
    /// The project file.
    pub text: String,
    /// The recording that it names: the file beside it, and what stands in it.
    pub recording: Option<(String, String)>,
}

/// A project file of a kind, with comments in a language, for a file of a name; `None` if there is no such kind.
#[must_use]
pub fn template(kind: &str, file: &str, language: Language) -> Option<Template> {
    let kind = KINDS.iter().find(|each| each.name == kind)?;
    let stem = file.strip_suffix(".toml").unwrap_or(file);
    let beside = format!("{stem}.csv");
    let recording = kind.recording.map(|(_, text)| (beside.clone(), recording_in(text, language)));
    let mut text = String::with_capacity(kind.text.len());
    for line in kind.text.lines() {
        if line.starts_with("# Run: antrieb") {
            continue;
        }
        if line == "format = 1" {
            text.push_str(&match language {
                Language::En => format!("# Run: antrieb size {file}\n"),
                Language::De => format!("# Aufruf: antrieb size {file} --lang de\n"),
            });
        }
        let line = match kind.recording {
            Some((name, _)) => line.replace(name, &beside),
            None => line.to_owned(),
        };
        text.push_str(&match language {
            Language::En => line,
            Language::De => german(&line),
        });
        text.push('\n');
    }
    Some(Template { text, recording })
}

fn recording_in(text: &str, language: Language) -> String {
    match (language, text.split_once('\n')) {
        (Language::De, Some((head, rest))) => format!("{}\n{rest}", german(head)),
        _ => text.to_owned(),
    }
}

/// A line with its comment, or its name, in German.
fn german(line: &str) -> String {
    if let Some((_, de)) = GERMAN.iter().find(|(en, _)| line.strip_prefix("name = ").is_some_and(|name| name == *en)) {
        return format!("name = {de}");
    }
    let Some((before, comment)) = line.split_once("# ") else { return line.to_owned() };
    let told = GERMAN.iter().find(|(en, _)| *en == comment).map_or(comment, |(_, de)| de);
    format!("{before}# {told}")
}

/// Comments and names of the examples, English and German.
const GERMAN: &[(&str, &str)] = &[
    // indexing table
    (
        "An indexing table with a horizontal plate: one station forward per cycle.",
        "Ein Rundschalttisch mit waagrechter Platte: je Zyklus eine Station weiter.",
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
    // turntable
    (
        "A turntable of solid bodies that indexes by 60° with a cam law; the parts sit on a circle.",
        "Ein Drehtisch aus Körpern, der nach einem Bewegungsgesetz um 60° schaltet; die Werkstücke sitzen auf einem Kreis.",
    ),
    ("\"turntable\"", "\"Drehtisch\""),
    ("plate of aluminium", "Platte aus Aluminium"),
    ("six fixtures with their parts", "sechs Aufnahmen mit ihren Werkstücken"),
    ("hub of steel", "Nabe aus Stahl"),
    ("seal and cable drag", "Dichtung und Kabelzug"),
    ("weight of table and parts", "Gewicht von Tisch und Werkstücken"),
    ("where the parts sit", "wo die Werkstücke sitzen"),
    // tilting arm
    (
        "A tilting arm with a horizontal axis: it lifts a part, waits at the top, and comes back empty. The brake holds it.",
        "Ein Schwenkarm mit waagrechter Achse: Er hebt ein Werkstück, wartet oben und kommt leer zurück. Die Bremse hält ihn.",
    ),
    ("\"tilting arm\"", "\"Schwenkarm\""),
    ("about the axis, without the part", "um die Drehachse, ohne Werkstück"),
    ("its centre of mass from the axis", "Abstand seines Schwerpunkts von der Drehachse"),
    ("the part in the gripper", "das Werkstück im Greifer"),
    ("the axis is horizontal: full gravity", "die Achse liegt waagrecht: volle Schwerkraft"),
    ("below the horizontal when the motion begins", "zu Beginn unter der Waagrechten"),
    ("seals and hoses", "Dichtungen und Schläuche"),
    ("up with the part", "mit Werkstück nach oben"),
    (
        "weight of arm and part, and what the motion adds",
        "Gewicht von Arm und Werkstück und was die Bewegung hinzufügt",
    ),
    ("held by the brake while the part is taken", "von der Bremse gehalten, während das Werkstück entnommen wird"),
    ("back, empty", "leer zurück"),
    ("the next part is gripped", "das nächste Werkstück wird gegriffen"),
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
    ("down, fast", "schnell nach unten"),
    (
        "pressing: 1.5 kN against the downward tool, so the force is negative",
        "andrücken: 1,5 kN gegen das abwärts fahrende Werkzeug, die Kraft ist also negativ",
    ),
    ("and up again", "und wieder nach oben"),
    // belt axis
    (
        "A horizontal belt axis that carries a part forth and returns empty.",
        "Eine waagrechte Riemenachse, die ein Werkstück hinbringt und leer zurückkehrt.",
    ),
    ("\"belt axis\"", "\"Riemenachse\""),
    ("carriage and gripper", "Schlitten und Greifer"),
    ("both pulleys, referred to the driving one", "beide Scheiben, auf die treibende bezogen"),
    ("with the part", "mit Werkstück"),
    (
        "back, empty: any two of distance, time, speed and acceleration",
        "leer zurück: zwei beliebige von distance, time, speed und acceleration",
    ),
    // recording
    (
        "Shoulder of a small robot: position, speed and torque come from a recording.",
        "Schulter eines kleinen Roboters: Lage, Drehzahl und Drehmoment kommen aus einer Aufzeichnung.",
    ),
    (
        "The torque is that of the whole arm, with its inertia, gravity and friction, so nothing of the arm is described here.",
        "Das Drehmoment ist das des ganzen Arms mit Trägheit, Schwerkraft und Reibung; der Arm ist hier also nicht beschrieben.",
    ),
    ("\"robot shoulder\"", "\"Roboterschulter\""),
    ("largest at the shoulder, arm stretched, with payload", "größtes an der Schulter, Arm gestreckt, mit Nutzlast"),
    ("arm stretched and level, with payload", "Arm gestreckt und waagrecht, mit Nutzlast"),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NoFiles;

    #[test]
    fn every_template_is_commented_in_german_too() {
        for kind in template_kinds() {
            let (en, de) = (
                template(kind, "axis.toml", Language::En).unwrap(),
                template(kind, "axis.toml", Language::De).unwrap(),
            );
            assert_eq!(en.text.lines().count(), de.text.lines().count());
            for (english, german) in en.text.lines().zip(de.text.lines()) {
                let told = |line: &str| line.split_once("# ").map(|(_, comment)| comment.to_owned());
                let (a, b) = (told(english), told(german));
                assert_eq!(a.is_some(), b.is_some(), "{english}");
                let symbols = a.as_deref().is_none_or(|comment| comment.len() < 4);
                assert!(symbols || a != b, "{kind}: still English: {english}");
                assert!(!english.starts_with("name = ") || english != german, "{kind}: still English: {english}");
            }
        }
    }

    #[test]
    fn a_template_names_its_own_file_and_is_a_project() {
        for kind in template_kinds() {
            for language in [Language::En, Language::De] {
                let found = template(kind, "my axis.toml", language).unwrap();
                assert!(
                    found.text.contains("antrieb size my axis.toml") && !found.text.contains("examples/"),
                    "{kind}"
                );
                assert_eq!(found.recording.is_some(), kind == "recording");
                match &found.recording {
                    None => assert!(crate::read_all(&found.text, &NoFiles).is_ok(), "{kind}"),
                    Some((name, text)) => {
                        assert!(found.text.contains("file = \"my axis.csv\"") && name == "my axis.csv");
                        assert!(text.lines().count() > 100);
                    }
                }
            }
        }
    }
}
