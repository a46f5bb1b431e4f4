//! Words by which people name what the program names otherwise, in both languages.

mod choices;

pub use choices::{CHOICES, choice};
use quantities::Language;

/// Other words for the commands: German ones, and those of other programs.
pub const COMMANDS: &[(&str, &str)] = &[
    ("abweichungen", "errata"),
    ("akku", "battery"),
    ("anbau", "mount"),
    ("anschluss", "wiring"),
    ("arbeitsmappe", "export"),
    ("auslegen", "size"),
    ("auslegung", "size"),
    ("auswaehlen", "size"),
    ("auswahl", "size"),
    ("auswertung", "identify"),
    ("auswählen", "size"),
    ("batterie", "battery"),
    ("belegung", "wiring"),
    ("berechnen", "size"),
    ("bericht", "report"),
    ("bestellbezeichnung", "code"),
    ("bewegung", "moves"),
    ("bewerten", "check"),
    ("cable", "wiring"),
    ("cables", "wiring"),
    ("calc", "size"),
    ("calculate", "size"),
    ("catalog", "catalogue"),
    ("chart", "plot"),
    ("choose", "size"),
    ("connector", "wiring"),
    ("connectors", "wiring"),
    ("convert", "units"),
    ("create", "new"),
    ("datasheet", "data"),
    ("datenblatt", "data"),
    ("definition", "glossary"),
    ("diagramm", "plot"),
    ("dimensionieren", "size"),
    ("draw", "plot"),
    ("drehgeber", "encoder"),
    ("drehmomentkennlinie", "curve"),
    ("drucken", "report"),
    ("edit", "serve"),
    ("einheiten", "units"),
    ("einstellungen", "commission"),
    ("encode", "encoder"),
    ("erklaeren", "explain"),
    ("erkläre", "explain"),
    ("erklären", "explain"),
    ("erwaermung", "simulate"),
    ("erwärmung", "simulate"),
    ("excel", "export"),
    ("exportieren", "export"),
    ("geber", "encoder"),
    ("gegenüberstellung", "compare"),
    ("glossar", "glossary"),
    ("graph", "plot"),
    ("gui", "serve"),
    ("heat", "simulate"),
    ("heating", "simulate"),
    ("herleiten", "explain"),
    ("herleitung", "explain"),
    ("hilfe", "help"),
    ("hitze", "simulate"),
    ("identification", "identify"),
    ("identifikation", "identify"),
    ("identifizieren", "identify"),
    ("import", "new"),
    ("importieren", "new"),
    ("inbetriebnahme", "commission"),
    ("inertias", "inertia"),
    ("init", "new"),
    ("kabel", "wiring"),
    ("kabelplan", "wiring"),
    ("katalog", "catalogue"),
    ("kennlinie", "curve"),
    ("kennlinien", "curve"),
    ("klemmenplan", "wiring"),
    ("lager", "bearing"),
    ("leitung", "wiring"),
    ("leitungen", "wiring"),
    ("licenses", "licences"),
    ("lizenzen", "licences"),
    ("maintenance", "upkeep"),
    ("map", "sweep"),
    ("mappe", "export"),
    ("messschrieb", "identify"),
    ("montage", "mount"),
    ("montageanleitung", "mount"),
    ("motion", "moves"),
    ("nachweis", "check"),
    ("nachweise", "check"),
    ("neu", "new"),
    ("notaus", "simulate"),
    ("parameter", "commission"),
    ("pdf", "report"),
    ("pinbelegung", "wiring"),
    ("pinout", "wiring"),
    ("pins", "wiring"),
    ("plug", "wiring"),
    ("pruefen", "check"),
    ("prüfe", "check"),
    ("prüfen", "check"),
    ("pufferbatterie", "battery"),
    ("rank", "size"),
    ("rechne", "size"),
    ("recommend", "size"),
    ("run", "simulate"),
    ("select", "size"),
    ("server", "serve"),
    ("sim", "simulate"),
    ("simulation", "simulate"),
    ("simulieren", "simulate"),
    ("sizing", "size"),
    ("solve", "size"),
    ("spec", "data"),
    ("specs", "data"),
    ("spreadsheet", "export"),
    ("stecker", "wiring"),
    ("steifigkeit", "torsion"),
    ("stückliste", "data"),
    ("temperatur", "simulate"),
    ("temperature", "simulate"),
    ("temperaturen", "simulate"),
    ("temperatures", "simulate"),
    ("template", "new"),
    ("term", "glossary"),
    ("thermik", "simulate"),
    ("torsional-stiffness", "torsion"),
    ("traegheit", "inertia"),
    ("traegheitsmoment", "inertia"),
    ("trägheit", "inertia"),
    ("trägheitsmoment", "inertia"),
    ("ui", "serve"),
    ("unterschiede", "diff"),
    ("validate", "check"),
    ("variieren", "sweep"),
    ("verdrahtung", "wiring"),
    ("vergleich", "compare"),
    ("vergleiche", "compare"),
    ("vergleichen", "compare"),
    ("verify", "check"),
    ("view", "report"),
    ("vorlage", "new"),
    ("waerme", "simulate"),
    ("wartung", "upkeep"),
    ("wartungsplan", "upkeep"),
    ("warum", "explain"),
    ("web", "serve"),
    ("why", "explain"),
    ("workbook", "export"),
    ("wähle", "size"),
    ("wärme", "simulate"),
    ("xlsx", "export"),
    ("zeichnen", "plot"),
];

/// Returns a word in small letters, with umlauts by two letters: `WÄRME` and `Waerme` are the same word.
#[must_use]
pub fn folded(word: &str) -> String {
    let small = word.to_lowercase();
    if small.is_ascii() {
        return small;
    }
    [('ä', "ae"), ('ö', "oe"), ('ü', "ue"), ('ß', "ss")]
        .iter()
        .fold(small, |text, (sign, plain)| text.replace(*sign, plain))
}

/// Returns the command that another word stands for.
#[must_use]
pub fn command(word: &str) -> Option<&'static str> {
    let word = folded(word);
    COMMANDS.iter().find(|(other, _)| folded(other) == word).map(|(_, name)| *name)
}

/// Words that may name several commands, each with those that it may mean.
const SEVERAL: &[(&str, &[&str])] = &[
    ("display", &["data", "plot", "report"]),
    ("find", &["size", "code list", "glossary"]),
    ("info", &["data", "explain", "errata"]),
    ("liste", &["code list", "catalogue export", "units"]),
    ("list", &["code list", "catalogue export", "units"]),
    ("ls", &["code list", "catalogue export", "units"]),
    ("open", &["serve", "size"]),
    ("print", &["report", "data"]),
    ("show", &["data", "plot", "report"]),
    ("start", &["serve", "new"]),
    ("test", &["check", "simulate"]),
    ("zeigen", &["data", "plot", "report"]),
    ("öffnen", &["serve", "size"]),
];

/// Returns the commands that a word may mean, if these are several; empty for another word.
#[must_use]
pub fn commands_meant(word: &str) -> &'static [&'static str] {
    let word = folded(word);
    SEVERAL.iter().find(|(other, _)| folded(other) == word).map_or(&[], |(_, commands)| commands)
}

/// Words of [`COMMANDS`] that are not German, or are words of both languages.
const NOT_GERMAN: &[&str] = &[
    "cable",
    "cables",
    "calc",
    "calculate",
    "catalog",
    "chart",
    "choose",
    "connector",
    "connectors",
    "convert",
    "create",
    "datasheet",
    "definition",
    "draw",
    "edit",
    "encode",
    "excel",
    "graph",
    "gui",
    "heat",
    "heating",
    "identification",
    "import",
    "inertias",
    "init",
    "licenses",
    "maintenance",
    "map",
    "motion",
    "parameter",
    "pdf",
    "pinout",
    "pins",
    "plug",
    "rank",
    "recommend",
    "run",
    "select",
    "server",
    "sim",
    "simulation",
    "sizing",
    "solve",
    "spec",
    "specs",
    "spreadsheet",
    "temperature",
    "temperatures",
    "template",
    "term",
    "torsional-stiffness",
    "ui",
    "validate",
    "verify",
    "view",
    "web",
    "why",
    "workbook",
    "xlsx",
];

/// Returns `true` if a word names a command in German only.
#[must_use]
pub fn is_german_command(word: &str) -> bool {
    let word = folded(word);
    COMMANDS.iter().any(|(other, _)| folded(other) == word) && !NOT_GERMAN.contains(&&*word)
}

/// Other words for options, each with those that it may stand for; the first that the command has is meant.
pub const OPTIONS: &[(&str, &[&str])] = &[
    ("actuator", &["code"]),
    ("change", &["set"]),
    ("duration", &["hours-per-day"]),
    ("factor", &["scale"]),
    ("interval", &["every"]),
    ("limit", &["top", "deadline"]),
    ("max-time", &["deadline"]),
    ("multiply", &["scale"]),
    ("n", &["top"]),
    ("number-of", &["top"]),
    ("param", &["set"]),
    ("parameter", &["set"]),
    ("part", &["code"]),
    ("pdf", &["out"]),
    ("period", &["every"]),
    ("picture", &["figure"]),
    ("product", &["code"]),
    ("replace", &["set"]),
    ("shift", &["hours-per-day"]),
    ("shifts", &["hours-per-day"]),
    ("step", &["every"]),
    ("value", &["set"]),
    ("with", &["set"]),
];

/// Names of options in German and as other programs spell them, each with the option that takes the same values; the first
/// that the command has is meant.
pub const TWIN_OPTIONS: &[(&str, &[&str])] = &[
    ("abtastzeit", &["every"]),
    ("achse", &["axis"]),
    ("alle", &["all"]),
    ("anschluss", &["connector"]),
    ("antrieb", &["code"]),
    ("ausgabe", &["out"]),
    ("bestellbezeichnung", &["code"]),
    ("bild", &["figure"]),
    ("breite", &["width"]),
    ("controller", &["for"]),
    ("datum", &["date"]),
    ("drehmoment", &["torque"]),
    ("drehzahl", &["speed"]),
    ("drive", &["for"]),
    ("ersetzen", &["force"]),
    ("für", &["for"]),
    ("geliefert", &["delivered"]),
    ("hilfe", &["help"]),
    ("hours", &["hours-per-day"]),
    ("höhe", &["height"]),
    ("katalog", &["catalogue"]),
    ("kunde", &["customer"]),
    ("language", &["lang"]),
    ("lieferung", &["delivered"]),
    ("länge", &["length"]),
    ("nachweis", &["check"]),
    ("output", &["out"]),
    ("overwrite", &["force"]),
    ("projekt", &["project"]),
    ("prüfliste", &["checklist"]),
    ("regler", &["for"]),
    ("schicht", &["hours-per-day"]),
    ("schichten", &["hours-per-day"]),
    ("servoregler", &["for"]),
    ("setzen", &["set"]),
    ("skalieren", &["scale"]),
    ("spannung", &["voltage"]),
    ("speicher", &["memory"]),
    ("sprache", &["lang"]),
    ("stichproben", &["samples"]),
    ("szenario", &["scenario"]),
    ("tabelle", &["table"]),
    ("takt", &["every"]),
    ("timeout", &["deadline"]),
    ("umrichter", &["for"]),
    ("verfasser", &["author"]),
    ("winkel", &["angle"]),
    ("zeitgrenze", &["deadline"]),
    ("überschreiben", &["force"]),
];

/// Words by which people name a kind, in both languages, each with the kind; the file begins with a line that says what
/// it describes.
#[rustfmt::skip] // one line per kind
pub const KINDS: &[(&str, &[&str])] = &[
    ("load", &["inertia", "flywheel", "direct", "direct drive", "last", "direktantrieb", "schwungmasse", "schwungrad"]),
    ("turntable", &["disc", "disk", "rotary table", "round table", "drum", "indexing table", "index table", "turning table", "rotating table", "dial", "dial plate", "wheel", "rad", "teller", "scheibe", "drehtisch", "rundtisch", "rundschalttisch", "schalttisch", "trommel"]),
    ("arm", &["lever", "pendulum", "swing arm", "tilting arm", "tilt", "tilter", "swivel", "hebel", "pendel", "schwenkarm", "kipparm", "schwenkachse", "schwenkeinheit", "schwenker"]),
    ("screw", &["ball screw", "spindle", "lead screw", "z axis", "vertical axis", "gewindetrieb", "kugelgewinde", "kugelgewindetrieb", "kugelumlaufspindel", "schraube", "spindel", "gewindespindel", "spindelachse", "hubachse", "z achse"]),
    ("belt", &["toothed belt", "timing belt", "rack", "rack and pinion", "gantry", "linear axis", "linear", "slide", "carriage", "x axis", "y axis", "zahnriemen", "riemen", "riemenachse", "zahnstange", "portal", "linearachse", "schlitten", "wagen", "x achse", "y achse"]),
    ("conveyor", &["roller", "conveyor belt", "roller conveyor", "förderer", "förderband", "bandförderer", "rollenförderer", "transportband", "walze"]),
    ("slider_crank", &["crank", "press", "kurbel", "presse", "kurbelpresse", "schubkurbel"]),
    ("hoist", &["lift", "winch", "crane", "rope", "rope drum", "hubwerk", "winde", "seil", "seilwinde", "seiltrommel", "hubtrommel", "kran", "aufzug"]),
    ("winder", &["roll", "rewinder", "reel", "wickler", "aufwickler", "aufwickelachse", "haspel", "rolle"]),
    ("unwinder", &["uncoiler", "unreeler", "unwind", "abwickler", "abwickelachse", "abroller", "abhaspel"]),
    ("scissor_lift", &["lifting table", "scissor", "hubtisch", "scherenhubtisch"]),
    ("four_bar", &["linkage", "four bar linkage", "gelenkviereck", "koppelgetriebe", "viergelenk"]),
    ("joint", &["robot", "robot joint", "robot axis", "delta", "delta robot", "scara", "roboter", "gelenk", "robotergelenk"]),
    ("recording", &["trace", "log", "csv", "aufzeichnung", "messung", "messdaten"]),
    ("catalogue", &["catalog", "stock list", "data sheet", "katalog", "lagerliste", "datenblatt"]),
    ("sweep", &["grid", "variation", "raster"]),
];

/// Drives and interfaces by their names, each with the form of its values.
pub const DRIVES: &[(&str, &[&str])] = &[
    ("sinamics", &["siemens", "s120", "s210", "sinamics s120", "sinamics s210", "starter", "startdrive", "tia"]),
    ("cia402", &["cia 402", "ds402", "dsp402", "canopen", "ethercat", "coe", "cia"]),
    ("plain", &["text", "neutral", "list", "liste", "other", "allgemein"]),
];

/// Options without a value that state a key of the project.
const FLAGS: &[(&str, (&str, &str))] = &[
    ("horizontal", ("inclination", "0deg")),
    ("senkrecht", ("inclination", "90deg")),
    ("upright", ("inclination", "90deg")),
    ("vertical", ("inclination", "90deg")),
    ("vertikal", ("inclination", "90deg")),
    ("waage", ("inclination", "0deg")),
    ("waagerecht", ("inclination", "0deg")),
    ("waagrecht", ("inclination", "0deg")),
];

/// Returns the key of a project that an option without a value states, and its value.
#[must_use]
pub fn flag(word: &str) -> Option<(&'static str, &'static str)> {
    let word = word.to_lowercase();
    FLAGS.iter().find(|(name, _)| *name == word).map(|(_, meant)| *meant)
}

/// Words for the duration of a run.
#[must_use]
pub fn is_duration(word: &str) -> bool {
    ["duration", "time", "runtime", "for", "dauer", "zeit", "laufzeit"].contains(&&*word.to_lowercase())
}

/// Returns `true` if a word names the reduction ratio of an actuator.
#[must_use]
pub fn is_ratio(word: &str) -> bool {
    let word = folded(word);
    ["ratio", "ratios", "gear-ratio", "gear_ratio", "gear", "reduction", "reduction-ratio", "reduction_ratio", "i"]
        .into_iter()
        .chain(["untersetzung", "übersetzung", "untersetzungen", "übersetzungen", "getriebe"])
        .any(|name| folded(name) == word)
}

/// Returns `true` if a word names the holding brake.
#[must_use]
pub fn is_brake(word: &str) -> bool {
    ["brake", "brakes", "holding-brake", "bremse", "bremsen", "haltebremse"].contains(&&*word.to_lowercase())
}

/// Returns `true` if a word stands before a property: `code list with brake`.
#[must_use]
pub fn is_with(word: &str) -> bool {
    ["with", "mit", "having", "a", "einer"].contains(&&*word.to_lowercase())
}

/// Words for the day of the call.
#[must_use]
pub fn is_today(word: &str) -> bool {
    ["today", "now", "heute", "jetzt"].contains(&&*word.to_lowercase())
}

/// Returns the value of an option of a simulation or of a picture that another word stands for, without its option.
#[must_use]
pub fn value(word: &str) -> Option<&'static str> {
    choice("scenario", word)
}

/// Words of bodies by which people name shapes and dimensions, each with that of the program.
const BODY_WORDS: &[(&str, &str)] = &[
    ("außen", "outer"),
    ("aussen", "outer"),
    ("außendurchmesser", "outer"),
    ("bohrung", "inner"),
    ("bore", "inner"),
    ("breite", "b"),
    ("d", "diameter"),
    ("da", "outer"),
    ("di", "inner"),
    ("dia", "diameter"),
    ("dichte", "density"),
    ("dicke", "thickness"),
    ("durchmesser", "diameter"),
    ("flange", "tube"),
    ("flansch", "tube"),
    ("h", "height"),
    ("hole", "inner"),
    ("hohlzylinder", "tube"),
    ("höhe", "height"),
    ("id", "inner"),
    ("innen", "inner"),
    ("innendurchmesser", "inner"),
    ("kegel", "cone"),
    ("kugel", "sphere"),
    ("l", "length"),
    ("länge", "length"),
    ("m", "mass"),
    ("masse", "mass"),
    ("od", "outer"),
    ("pipe", "tube"),
    ("punkt", "point"),
    ("punktmasse", "point"),
    ("plate", "box"),
    ("platte", "box"),
    ("quader", "box"),
    ("rho", "density"),
    ("ring", "tube"),
    ("rohr", "tube"),
    ("scheibe", "disc"),
    ("shaft", "cylinder"),
    ("stab", "rod"),
    ("t", "thickness"),
    ("thick", "thickness"),
    ("vollzylinder", "cylinder"),
    ("welle", "cylinder"),
    ("zylinder", "cylinder"),
    ("ρ", "density"),
];

/// Returns the shape or the dimension of a body that another word stands for.
#[must_use]
pub fn body_word(word: &str) -> Option<&'static str> {
    let word = folded(word);
    BODY_WORDS.iter().find(|(other, _)| folded(other) == word).map(|(_, name)| *name)
}

/// Usual densities of materials, as round values of material tables (Dubbel, table of densities at 20 °C).
#[rustfmt::skip] // one line per material
const MATERIALS: &[(&str, &[&str])] = &[
    ("7850kg/m^3", &["steel", "stahl"]),
    ("7900kg/m^3", &["stainless", "inox", "edelstahl"]),
    ("7200kg/m^3", &["iron", "guss", "grauguss", "gusseisen"]),
    ("2700kg/m^3", &["aluminium", "aluminum", "alu"]),
    ("8500kg/m^3", &["brass", "messing"]),
    ("8800kg/m^3", &["bronze"]),
    ("8960kg/m^3", &["copper", "kupfer"]),
    ("4500kg/m^3", &["titanium", "titan"]),
    ("1410kg/m^3", &["pom"]),
    ("1140kg/m^3", &["pa", "pa6", "nylon"]),
];

/// Returns the density of a material, as a body states it.
#[must_use]
pub fn density(material: &str) -> Option<&'static str> {
    let material = material.to_lowercase();
    MATERIALS.iter().find(|(_, names)| names.contains(&&*material)).map(|(density, _)| *density)
}

/// Returns `true` if a word names the dwells between the moves.
#[must_use]
pub fn is_pause(word: &str) -> bool {
    ["pause", "dwell", "rest", "wait", "stillstand", "rast", "wartezeit"].contains(&&*word.to_lowercase())
}

/// Returns `true` if a word names the setpoints of a motion.
#[must_use]
pub fn is_setpoints(word: &str) -> bool {
    const NAMES: [&str; 11] = [
        "setpoint",
        "setpoints",
        "motion",
        "trajectory",
        "profile",
        "cam",
        "sollwert",
        "sollwerte",
        "bewegung",
        "trajektorie",
        "kurvenscheibe",
    ];
    NAMES.contains(&&*word.to_lowercase().replace(['-', '_'], ""))
}

/// Returns `true` if numbers usually have decimal commas in a language.
#[must_use]
pub const fn has_decimal_commas(language: Language) -> bool {
    matches!(language, Language::De)
}

/// Words for the quantities that a call may scale.
const SCALED: &[(&str, &[&str])] = &[
    ("load", &["last", "lasten"]),
    ("payload", &["nutzlast", "zuladung"]),
    ("time", &["zeit", "zeiten", "times"]),
    ("distance", &["weg", "wege", "winkel", "hub", "travel", "stroke"]),
];

/// Returns the name of a quantity that a call may scale; its word on the command line if there is none.
#[must_use]
pub fn scaled_name(word: &str, language: Language) -> &str {
    match word {
        "load" => crate::records::load(language),
        "payload" => crate::terms::payload(language),
        "time" => crate::terms::time(language),
        "distance" => crate::terms::distance(language),
        _ => word,
    }
}

/// Returns the quantity that a call may scale, by another word for it.
#[must_use]
pub fn scaled(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    let is_meant = |(name, words): &&(&str, &[&str])| *name == word || words.contains(&&*word);
    SCALED.iter().find(is_meant).map(|(name, _)| *name)
}

/// Returns the language of a word: its identifier or its name, in any case.
#[must_use]
pub fn language_of(word: &str) -> Option<Language> {
    let word = word.to_lowercase();
    // `de_DE.UTF-8` is a locale.
    match word.split(['_', '-', '.']).next().unwrap_or_default() {
        "de" | "deutsch" | "german" => Some(Language::De),
        "en" | "englisch" | "english" => Some(Language::En),
        _ => None,
    }
}
