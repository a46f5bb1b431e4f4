//! Words by which people name what the program names otherwise, in both languages.

use quantities::Language;

/// Other words for the commands: German ones, and those of other programs.
pub const COMMANDS: &[(&str, &str)] = &[
    ("abweichungen", "errata"),
    ("anbau", "mount"),
    ("anschluss", "wiring"),
    ("auslegen", "size"),
    ("auslegung", "size"),
    ("batterie", "battery"),
    ("bericht", "report"),
    ("bestellbezeichnung", "code"),
    ("bewegung", "moves"),
    ("catalog", "catalogue"),
    ("datasheet", "data"),
    ("datenblatt", "data"),
    ("diagramm", "plot"),
    ("einheiten", "units"),
    ("einstellungen", "commission"),
    ("encode", "encoder"),
    ("exportieren", "export"),
    ("geber", "encoder"),
    ("glossar", "glossary"),
    ("herleiten", "explain"),
    ("herleitung", "explain"),
    ("hilfe", "help"),
    ("identifizieren", "identify"),
    ("inbetriebnahme", "commission"),
    ("katalog", "catalogue"),
    ("kennlinie", "curve"),
    ("kennlinien", "curve"),
    ("lager", "bearing"),
    ("licenses", "licences"),
    ("lizenzen", "licences"),
    ("maintenance", "upkeep"),
    ("montage", "mount"),
    ("motion", "moves"),
    ("nachweis", "check"),
    ("nachweise", "check"),
    ("neu", "new"),
    ("pruefen", "check"),
    ("prüfen", "check"),
    ("select", "size"),
    ("server", "serve"),
    ("sim", "simulate"),
    ("simulation", "simulate"),
    ("simulieren", "simulate"),
    ("traegheitsmoment", "inertia"),
    ("trägheitsmoment", "inertia"),
    ("unterschiede", "diff"),
    ("variieren", "sweep"),
    ("verdrahtung", "wiring"),
    ("vergleich", "compare"),
    ("vergleichen", "compare"),
    ("vorlage", "new"),
    ("wartung", "upkeep"),
    ("zeichnen", "plot"),
];

/// Other words for options, each with those that it may stand for; the first that the command has is meant.
pub const OPTIONS: &[(&str, &[&str])] = &[
    ("actuator", &["code"]),
    ("antrieb", &["code"]),
    ("change", &["set"]),
    ("drive", &["for"]),
    ("factor", &["scale"]),
    ("language", &["lang"]),
    ("limit", &["top", "deadline"]),
    ("load", &["scale"]),
    ("max-time", &["deadline"]),
    ("multiply", &["scale"]),
    ("n", &["top"]),
    ("number-of", &["top"]),
    ("output", &["out"]),
    ("overwrite", &["force"]),
    ("param", &["set"]),
    ("parameter", &["set"]),
    ("part", &["code"]),
    ("pdf", &["out"]),
    ("picture", &["figure"]),
    ("product", &["code"]),
    ("replace", &["set"]),
    ("sprache", &["lang"]),
    ("timeout", &["deadline"]),
    ("value", &["set"]),
    ("with", &["set"]),
];

/// Words by which people name a kind, in both languages, each with the kind; the file begins with a line that says what
/// it describes.
#[rustfmt::skip] // one line per kind
pub const KINDS: &[(&str, &[&str])] = &[
    ("load", &["inertia", "flywheel", "direct", "last", "schwungmasse", "schwungrad"]),
    ("turntable", &["disc", "disk", "rotary table", "round table", "drum", "scheibe", "drehtisch", "rundtisch", "trommel"]),
    ("arm", &["lever", "pendulum", "swing arm", "tilting arm", "hebel", "pendel", "schwenkarm", "kipparm"]),
    ("screw", &["ball screw", "spindle", "lead screw", "z axis", "vertical axis", "gewindetrieb", "kugelgewindetrieb", "hubachse", "z achse"]),
    ("belt", &["toothed belt", "timing belt", "rack", "rack and pinion", "gantry", "linear axis", "x axis", "zahnriemen", "riemen", "zahnstange", "portal", "linearachse", "x achse"]),
    ("conveyor", &["roller", "conveyor belt", "förderband", "rollenförderer", "walze"]),
    ("slider_crank", &["crank", "press", "kurbel", "schubkurbel"]),
    ("hoist", &["lift", "winch", "crane", "hubwerk", "winde", "kran", "aufzug"]),
    ("winder", &["roll", "unwinder", "rewinder", "reel", "wickler", "abwickler", "haspel", "rolle"]),
    ("scissor_lift", &["lifting table", "scissor", "hubtisch", "scherenhubtisch"]),
    ("four_bar", &["linkage", "four bar linkage", "gelenkviereck", "koppelgetriebe"]),
    ("joint", &["robot", "robot joint", "roboter", "gelenk", "robotergelenk"]),
    ("recording", &["trace", "log", "csv", "aufzeichnung", "messung"]),
    ("sweep", &["grid", "variation", "raster"]),
];

/// Returns the language of a word: its identifier or its name, in any case.
#[must_use]
pub fn language_of(word: &str) -> Option<Language> {
    match word.to_lowercase().as_str() {
        "de" | "deutsch" | "german" => Some(Language::De),
        "en" | "englisch" | "english" => Some(Language::En),
        _ => None,
    }
}
