//! Nearest valid names of an invalid one.

use crate::Hint;
use crate::bodies::BodySection;
use crate::key::{Key, Kind};
use crate::read::{WORD_SHOWN, shortened};
use crate::section::Section;
use quantities::Dimension;
use toml::de::DeTable;

/// Other names of keys: those of other programs, and German ones, each with the keys that it may name, the usual one first.
const OTHER_NAMES: [(&str, &[&str]); 94] = [
    ("angle", &["distance"]),
    ("stroke", &["distance"]),
    ("travel", &["distance"]),
    ("weg", &["distance"]),
    ("winkel", &["distance"]),
    ("hub", &["distance"]),
    ("schaltwinkel", &["distance"]),
    ("duration", &["time"]),
    ("zeit", &["time"]),
    ("dauer", &["time"]),
    ("schaltzeit", &["time"]),
    ("velocity", &["speed"]),
    ("drehzahl", &["speed"]),
    ("geschwindigkeit", &["speed"]),
    ("beschleunigung", &["acceleration"]),
    ("ruck", &["jerk"]),
    ("weight", &["mass"]),
    ("masse", &["mass"]),
    ("gewicht", &["mass"]),
    ("last", &["mass", "payload", "inertia"]),
    ("load", &["mass", "payload", "inertia"]),
    ("moving_mass", &["mass"]),
    ("vel", &["speed"]),
    ("rpm", &["speed"]),
    ("accel", &["acceleration"]),
    ("cycle_time", &["cycle"]),
    ("nutzlast", &["payload"]),
    ("zuladung", &["payload"]),
    ("voltage", &["supply"]),
    ("spannung", &["supply"]),
    ("zwischenkreisspannung", &["supply"]),
    ("traegheitsmoment", &["inertia"]),
    ("massentraegheitsmoment", &["inertia"]),
    ("reibmoment", &["friction_torque"]),
    ("reibung", &["friction_torque", "friction_force", "friction_coefficient"]),
    ("reibkraft", &["friction_force"]),
    ("reibungszahl", &["friction_coefficient"]),
    ("durchmesser", &["diameter", "drum_diameter", "pulley_diameter", "roller_diameter"]),
    ("trommeldurchmesser", &["drum_diameter"]),
    ("laenge", &["length"]),
    ("steigung", &["lead"]),
    ("wirkungsgrad", &["efficiency"]),
    ("uebersetzung", &["ratio"]),
    ("neigung", &["inclination"]),
    ("gegengewicht", &["counterweight"]),
    ("prozesskraft", &["process_force"]),
    ("prozessmoment", &["process_torque"]),
    ("bremse", &["brake"]),
    ("geber", &["feedback"]),
    ("hohlwelle", &["hollow_shaft_min"]),
    ("umgebung", &["ambient"]),
    ("umgebungstemperatur", &["ambient"]),
    ("temperature", &["ambient"]),
    ("bewegungsgesetz", &["law"]),
    ("taktzeit", &["cycle"]),
    ("zyklus", &["cycle"]),
    ("zykluszeit", &["cycle"]),
    ("hoehe", &["height", "altitude"]),
    ("breite", &["width"]),
    ("dichte", &["density"]),
    ("untersetzung", &["ratio"]),
    ("getriebe", &["ratio"]),
    ("zwischengetriebe", &["ratio"]),
    ("zwischenstufe", &["ratio"]),
    ("gear", &["ratio"]),
    ("gearbox", &["ratio"]),
    ("intermediate_gear", &["ratio"]),
    ("gear_ratio", &["ratio"]),
    ("seilmasse", &["rope_mass"]),
    ("rope", &["rope_mass"]),
    ("seilstraenge", &["falls"]),
    ("straenge", &["falls"]),
    ("strands", &["falls"]),
    ("drum", &["drum_diameter"]),
    ("pulley", &["pulley_diameter"]),
    ("riemenscheibe", &["pulley_diameter"]),
    ("ritzel", &["pulley_diameter"]),
    ("pinion", &["pulley_diameter"]),
    ("walze", &["roller_diameter"]),
    ("walzendurchmesser", &["roller_diameter"]),
    ("bahnzug", &["tension"]),
    ("zugkraft", &["tension"]),
    ("bahngeschwindigkeit", &["speed"]),
    ("dicke", &["thickness"]),
    ("huelse", &["core_diameter"]),
    ("core", &["core_diameter"]),
    ("spindelsteigung", &["lead"]),
    ("pitch", &["lead"]),
    ("reibwert", &["friction_coefficient"]),
    ("friction", &["friction_torque", "friction_force", "friction_coefficient"]),
    ("hubhoehe", &["distance"]),
    ("armlaenge", &["arm_length", "length"]),
    ("traegheit", &["inertia"]),
    ("haltebremse", &["brake"]),
];

/// Other words for values with a fixed set of words, and the words that they may stand for.
const OTHER_VALUES: &[(&str, &[&str])] = &[
    ("sinus", &["modified_sine", "simple_sine", "inclined_sine"]),
    ("sinoide", &["modified_sine", "simple_sine", "inclined_sine"]),
    ("sine", &["modified_sine", "simple_sine", "inclined_sine"]),
    ("cosine", &["simple_sine"]),
    ("kosinus", &["simple_sine"]),
    ("harmonic", &["simple_sine"]),
    ("einfache_sinuslinie", &["simple_sine"]),
    ("modifizierte_sinuslinie", &["modified_sine"]),
    ("geneigte_sinuslinie", &["inclined_sine"]),
    ("bestehorn", &["inclined_sine"]),
    ("bestehornsinoide", &["inclined_sine"]),
    ("cycloid", &["inclined_sine"]),
    ("cycloidal", &["inclined_sine"]),
    ("zykloide", &["inclined_sine"]),
    ("modifiziertes_trapez", &["modified_trapezoid"]),
    ("trapez", &["trapezoid"]),
    ("trapezoidal", &["trapezoid"]),
    ("dreieck", &["triangle"]),
    ("triangular", &["triangle"]),
    ("bang_bang", &["triangle"]),
    ("parabel", &["parabola", "triangle"]),
    ("s_curve", &["jerk"]),
    ("scurve", &["jerk"]),
    ("s_kurve", &["jerk"]),
    ("ruckbegrenzt", &["jerk"]),
    ("jerk_limited", &["jerk"]),
    ("quintic", &["polynomial_5"]),
    ("poly5", &["polynomial_5"]),
    ("polynom_5", &["polynomial_5"]),
    ("3_4_5", &["polynomial_5"]),
    ("konstant", &["constant"]),
    ("linear", &["constant"]),
    ("rast", &["dwell"]),
    ("stillstand", &["dwell"]),
    ("pause", &["dwell"]),
    ("wait", &["dwell"]),
    ("offen", &["open"]),
    ("bremse", &["brake"]),
    ("frei", &["free"]),
];

/// Letters of names as [`OTHER_NAMES`] writes them: umlauts by two letters.
const LETTERS: [(char, &str); 4] = [('\u{e4}', "ae"), ('\u{f6}', "oe"), ('\u{fc}', "ue"), ('\u{df}', "ss")];

/// Returns the keys that another name, in lower case, may stand for.
#[must_use]
pub fn other_names(written: &str) -> &'static [&'static str] {
    let plain = plain_letters(written);
    OTHER_NAMES.iter().find(|(name, _)| *name == plain).map_or(&[], |(_, names)| names)
}

/// Returns a text with umlauts by two letters.
fn plain_letters(text: &str) -> String {
    LETTERS.iter().fold(text.to_owned(), |text, (letter, plain)| text.replace(*letter, plain))
}

/// Returns those of the valid words that another word for a value may stand for.
fn other_values<'v>(written: &str, valid: &[&'v str]) -> Vec<&'v str> {
    let plain = plain_letters(&written.trim().to_lowercase()).replace([' ', '-'], "_");
    let meant = OTHER_VALUES.iter().find(|(word, _)| *word == plain).map_or(&[][..], |(_, meant)| meant);
    meant.iter().filter_map(|word| valid.iter().find(|valid| *valid == word)).copied().collect()
}

/// Names for the number of stations of a table that turns on by one station.
const STATIONS: [&str; 6] = ["stations", "station", "positions", "stationen", "teilung", "nester"];

/// Returns the distance from one station to the next, for a name and a number of stations.
#[must_use]
pub fn distance_of_stations(name: &str, number: &str) -> Option<String> {
    let count = number.parse::<u16>().ok().filter(|count| *count > 1)?;
    let degrees = 360.0 / f64::from(count);
    STATIONS.contains(&&*name.to_lowercase()).then(|| format!("{degrees} deg"))
}

/// Returns the key that an unknown one stands for: by another name, or as the value of a key such as `dwell` of `law`.
pub(crate) fn meant(written: &str, keys: &'static [Key]) -> Option<Hint> {
    let written = written.to_lowercase();
    if let Some(name) = other_names(&written).iter().find(|name| keys.iter().any(|key| key.name == **name)) {
        return Some(Hint::DidYouMean((*name).to_owned()));
    }
    let has = |key: &&Key| matches!(key.kind, Kind::OneOf(words) if words.contains(&written.as_str()));
    keys.iter().find(has).map(|key| Hint::DidYouMean(format!("{} = \"{written}\"", key.name)))
}

/// Returns the keys of a table for a quantity of the kind of a value; `None` if the value is no quantity with its unit or the
/// table has none or more than a handful.
pub(crate) fn of_the_quantity(value: &str, keys: &'static [Key]) -> Option<Hint> {
    const MOST: usize = 6;
    let mut found: Option<(Dimension, Vec<&'static str>)> = None;
    for key in keys {
        let dimensions = match key.kind {
            Kind::Quantity(dimension, _) => [Some(dimension), None],
            Kind::Along(turning, line, _) => [Some(turning), Some(line)],
            _ => [None, None],
        };
        if let Some(dimension) = dimensions.into_iter().flatten().find(|each| quantities::parse(*each, value).is_ok()) {
            found.get_or_insert((dimension, Vec::new())).1.push(key.name);
        }
    }
    let (dimension, keys) = found?;
    (keys.len() <= MOST).then_some(Hint::KeysOfQuantity { dimension, keys })
}

/// Mechanism that is a table of points, and the one that other programs call a table.
const POINTS: &str = "table";
const TURNTABLE: &str = "turntable";

/// Returns the mechanism that has a key where the stated one does not: the only one with most of the keys of the table. The
/// keys of a body in a table of points mean a turntable.
fn in_another_mechanism(written: &str, (table, path): (&DeTable<'_>, &str)) -> Option<Hint> {
    let (_, stated) = path.split_once("mechanism.")?;
    let names: Vec<&str> = table.iter().map(|(name, _)| &**name.get_ref()).collect();
    if stated == POINTS
        && let Some(key) = BodySection::KEYS.iter().find(|key| key.name == written)
    {
        return Some(Hint::KeyOfTable { key: key.name, table: format!("[[mechanism.{TURNTABLE}.body]]") });
    }
    let mechanisms = crate::root::KEYS.iter().find(|key| key.name == "mechanism")?.kind.keys(false);
    let others = mechanisms.iter().filter(|each| each.name != stated).filter_map(|each| {
        let keys = each.kind.keys(false);
        let key = keys.iter().find(|key| key.name == written)?.name;
        Some((keys.iter().filter(|key| names.contains(&key.name)).count(), key, each.name))
    });
    let mut others: Vec<_> = others.collect();
    others.sort_by_key(|(count, ..)| std::cmp::Reverse(*count));
    match others.as_slice() {
        [(most, key, name), rest @ ..] if rest.first().is_none_or(|(count, ..)| count < most) => {
            Some(Hint::KeyOfTable { key, table: format!("[mechanism.{name}]") })
        }
        _ => None,
    }
}

/// Returns the table of an axis that has a key, if only one has it; of a mechanism first another one.
pub(crate) fn in_another_table(written: &str, within: (&DeTable<'_>, &str)) -> Option<Hint> {
    if let Some(hint) = in_another_mechanism(written, within) {
        return Some(hint);
    }
    let named = |keys: &'static [Key]| keys.iter().find(|key| key.name == written).map(|key| key.name);
    let mut found = crate::root::KEYS.iter().filter_map(|table| {
        let is_list = matches!(table.kind, Kind::Variants(_));
        let heading = if is_list { format!("[[{}]]", table.name) } else { format!("[{}]", table.name) };
        let heading = match table.kind {
            Kind::Variants(variants) => match variants.only_kind_with(written) {
                Some(line) => format!("{heading} {line}"),
                None => heading,
            },
            _ => heading,
        };
        Some(Hint::KeyOfTable { key: named(table.kind.keys(true))?, table: heading })
    });
    found.next().filter(|_| found.next().is_none())
}

/// Returns the keys of the kind that a table states, `law = "trapezoid"`; `None` for a table without kinds, and for an unknown one.
pub(crate) fn of_the_kind(table: &DeTable<'_>, keys: &'static [Key]) -> Option<Hint> {
    let of_table = crate::root::KEYS.iter().find_map(|key| match key.kind {
        Kind::Variants(variants) if std::ptr::eq(variants.keys, keys) => Some(variants),
        _ => None,
    })?;
    let (_, stated) = table.iter().find(|(name, _)| *name.get_ref() == of_table.by)?;
    Some(Hint::valid(&of_table.keys_of(stated.get_ref().as_str()?)?))
}

/// Iterates over the digits of a name.
fn digits(name: &str) -> impl Iterator<Item = char> {
    name.chars().filter(char::is_ascii_digit)
}

/// Returns "did you mean …", or the whole list if no name is near.
#[must_use]
pub fn nearest(written: &str, valid: &[&str]) -> Hint {
    let written = shortened(written, WORD_SHOWN);
    let meant = other_values(&written, valid);
    if !meant.is_empty() {
        return Hint::instead(&meant);
    }
    // An abbreviated or extended word is nearer than its number of letters suggests.
    let akin = valid
        .iter()
        .find(|name| written.len() >= 3 && (name.starts_with(written.as_str()) || written.starts_with(**name)));
    if let Some(name) = akin {
        return Hint::DidYouMean((*name).to_owned());
    }
    let near = valid
        .iter()
        .map(|name| (strsim::damerau_levenshtein(&written.to_lowercase(), &name.to_lowercase()), *name))
        .min()
        .filter(|(distance, name)| *distance * 2 <= name.chars().count())
        // Another number is another value and no slip of letters: IP70 is not IP00.
        .filter(|(_, name)| digits(name).eq(digits(&written)));
    match near {
        Some((_, name)) => Hint::DidYouMean(name.to_owned()),
        None => Hint::valid(valid),
    }
}

#[cfg(test)]
mod tests {
    use crate::{Diagnostic, Fault, Hint, SegmentLaw, read, value::WordChoice};

    fn found(text: &str) -> Vec<Diagnostic> {
        read(text).unwrap().report.into_faults()
    }

    /// Requires that the words of the trade for a law lead to it, however few letters they share with its name.
    #[test]
    fn another_word_for_a_law_leads_to_it() {
        let hint = |law: &str| {
            let text = format!(
                "format = 1\n[mechanism.arm]\nmass = \"5 kg\"\nlength = \"1 m\"\n[[motion]]\nlaw = \"{law}\"\n"
            );
            found(&text)
                .into_iter()
                .find(|fault| matches!(fault.fault, Fault::NotAChoice { .. }))
                .and_then(|fault| fault.hint)
        };
        let one = |word: &str| Some(Hint::DidYouMean(word.to_owned()));
        let sines = Some(Hint::valid(&["modified_sine", "simple_sine", "inclined_sine"]));
        for law in ["sinus", "Sine", "Sinoide"] {
            assert_eq!(hint(law), sines, "{law}");
        }
        let words = [
            ("Geneigte Sinuslinie", "inclined_sine"),
            ("Bestehorn", "inclined_sine"),
            ("cycloidal", "inclined_sine"),
            ("S-Kurve", "jerk"),
            ("ruckbegrenzt", "jerk"),
            ("quintic", "polynomial_5"),
            ("Trapez", "trapezoid"),
            ("Rast", "dwell"),
            ("linear", "constant"),
        ];
        for (law, meant) in words {
            assert_eq!(hint(law), one(meant), "{law}");
        }
        for (word, meant) in super::OTHER_VALUES {
            let is_known = |each: &&str| SegmentLaw::WORDS.contains(each) || ["brake", "free"].contains(each);
            assert!(meant.iter().all(is_known), "{word}");
        }
    }

    /// Requires that keys of a body in a table of points lead to a turntable, and those of another mechanism to it.
    #[test]
    fn a_key_of_another_mechanism_leads_to_it() {
        let hints = |section: &str| {
            let text = format!("format = 1\n{section}\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n");
            found(&text).into_iter().filter_map(|fault| fault.hint).collect::<Vec<_>>()
        };
        let table = hints("[mechanism.table]\ndiameter = \"600 mm\"\nmass = \"60 kg\"");
        for key in ["diameter", "mass"] {
            let body = Hint::KeyOfTable { key, table: "[[mechanism.turntable.body]]".to_owned() };
            assert!(table.contains(&body), "{table:?}");
        }
        let hoist =
            hints("[mechanism.screw]\nlead = \"20 mm\"\nmass = \"60 kg\"\ncounterweight = \"50 kg\"\nfalls = 2");
        let is_hoist = |hint: &Hint| matches!(hint, Hint::KeyOfTable { table, .. } if table == "[mechanism.hoist]");
        assert!(hoist.iter().any(is_hoist), "{hoist:?}");
    }

    /// Requires that other names of a key, and the word of a law in the place of `law`, lead to the intended key.
    #[test]
    fn an_unknown_key_leads_to_what_is_meant() {
        let hints = |line: &str| {
            let text = format!("format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\n{line}\n");
            let faults = found(&text);
            faults.into_iter().filter_map(|fault| fault.hint).collect::<Vec<_>>()
        };
        let meant = |name: &str| Hint::DidYouMean(name.to_owned());
        assert!(hints("angle = \"90 deg\"").contains(&meant("distance")));
        assert!(hints("Drehzahl = \"40 1/min\"").contains(&meant("speed")));
        let of_dwell = hints("dwell = \"1 s\"");
        assert!(of_dwell.contains(&meant("law = \"dwell\"")), "{of_dwell:?}");
        let is_list = |hint: &Hint| matches!(hint, Hint::ValidAre(words) if words.iter().any(|word| word == "dwell"));
        assert!(of_dwell.iter().any(is_list), "{of_dwell:?}");
        // A key of another table is named with it.
        let text = "format = 1\n[mechanism.hoist]\npayload = \"5 kg\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";
        let faults = found(text);
        let motion = Hint::KeyOfTable { key: "payload", table: "[[motion]]".to_owned() };
        assert!(faults.iter().any(|fault| fault.hint.as_ref() == Some(&motion)), "{faults:?}");
        // One that has nothing to do with this mechanism leads to the keys of the mechanism for such a quantity first.
        let text = "format = 1\n[mechanism.arm]\nreach = \"500 mm\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";
        let faults = found(text);
        let keys = vec!["length", "width", "centre_distance", "payload_distance"];
        let lengths = Hint::KeysOfQuantity { dimension: quantities::Dimension::Length, keys };
        assert!(faults.iter().any(|fault| fault.hint.as_ref() == Some(&lengths)), "{faults:?}");
        // A name without a meaning in this table is still in the list.
        assert!(hints("voltage = \"560 V\"").iter().all(|hint| !matches!(hint, Hint::DidYouMean(_))));
    }

    /// An unknown key with a length, mass or inertia, in every mechanism and in the load, leads to the keys of that section
    /// for it, before another section that has a key of the name.
    #[test]
    fn an_unknown_key_leads_to_its_own_section_first() {
        let table = |name: &str| crate::root::KEYS.iter().find(|key| key.name == name).unwrap();
        let mechanisms = table("mechanism").kind.keys(false).iter().map(|key| (format!("mechanism.{}", key.name), key));
        let mut tried = 0;
        for (path, section) in mechanisms.chain([("load".to_owned(), table("load"))]) {
            let keys = section.kind.keys(false);
            for (name, value) in [("length", "500 mm"), ("mass", "5 kg"), ("inertia_out", "2 kg m^2")] {
                let own = super::of_the_quantity(value, keys);
                let has = |key: &crate::Key| strsim::damerau_levenshtein(key.name, name) * 2 <= key.name.len();
                let is_near = |key: &crate::Key| key.name.starts_with(name) || name.starts_with(key.name) || has(key);
                let Some(own) = own.filter(|_| !keys.iter().any(is_near)) else { continue };
                let text = format!("format = 1\n[{path}]\n{name} = \"{value}\"\n");
                let faults = found(&text);
                assert!(faults.iter().any(|fault| fault.hint.as_ref() == Some(&own)), "{path}.{name}: {faults:?}");
                tried += 1;
            }
        }
        assert!(tried >= 8, "{tried}");
    }
}
