//! Which column is what, and in which unit.

use crate::faults::{Fault, Faults, excerpt};
use crate::layout::{Layout, Role};
use crate::limits::NAMES_MAX;
use crate::series::{Along, ColumnRead, KnownBy};
use quantities::{Dimension, Unit, seen};

/// A column as the file names it.
#[derive(Clone, Debug)]
pub(crate) struct Heading {
    /// As written.
    pub(crate) written: String,
    /// Without the unit.
    pub(crate) bare: String,
    /// The unit, if the name carries one.
    pub(crate) unit: Option<String>,
}

impl Heading {
    /// Takes the unit off a name: `q [deg]`, `q (deg)`, `n / 1/min`, `n in 1/min`, and `q/deg` where what follows is a
    /// unit. No other spelling is a unit: `t_s` is a name.
    pub(crate) fn new(written: &str) -> Self {
        let written = written.trim();
        let (bare, unit) = match split(written) {
            Some((bare, unit)) => (bare.trim_end(), Some(unit.trim().to_owned())),
            None => (written, None),
        };
        Self { written: written.to_owned(), bare: bare.to_owned(), unit }
    }

    fn is_named(&self, name: &str) -> bool {
        self.written == name || self.bare == name
    }

    fn is_named_like(&self, name: &str) -> bool {
        self.written.to_lowercase() == name.to_lowercase() || self.bare.to_lowercase() == name.to_lowercase()
    }
}

fn split(written: &str) -> Option<(&str, &str)> {
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some((bare, unit)) = written.strip_suffix(close).and_then(|inner| inner.split_once(open))
            && !bare.is_empty()
        {
            // `n / (1/min)` is a fraction in brackets, not a name that ends with a stroke.
            return Some((bare.trim_end().strip_suffix('/').unwrap_or(bare), unit));
        }
    }
    if let Some(parts) = [" / ", " in "].iter().find_map(|by| written.split_once(by)) {
        return Some(parts);
    }
    written.split_once('/').filter(|(bare, unit)| !bare.is_empty() && Unit::of(unit).is_some())
}

/// The column of every role, in the order of [`Role::ALL`].
pub(crate) type Picks = [Option<usize>; 4];

/// Finds the column of every role. Missing and ambiguous ones are reported.
pub(crate) fn pick(headings: &[Heading], layout: &Layout, faults: &mut Faults) -> Picks {
    let mut picks: Picks = [None; 4];
    let mut failed = [false; 4];
    // One more than is shown says that there are more.
    let names = || headings.iter().take(NAMES_MAX + 1).map(|heading| excerpt(&heading.written)).collect::<Vec<_>>();
    // What the layout names is found first: such a column is not free for another role.
    let mut taken: Vec<(usize, Role)> = Vec::new();
    for ((role, slot), failed) in Role::ALL.into_iter().zip(&mut picks).zip(&mut failed) {
        let spec = layout.column(role);
        let Some(name) = spec.name.as_deref().map(str::trim).filter(|_| !spec.unused) else { continue };
        let mut found = indices(headings, |heading| heading.is_named(name));
        if found.is_empty() {
            found = indices(headings, |heading| heading.is_named_like(name));
        }
        *failed = true;
        match found.as_slice() {
            [] => faults.push(Fault::ColumnUnknown {
                role,
                name: excerpt(name),
                nearest: nearest(headings, name),
                headers: names(),
            }),
            [one] => {
                if let Some((_, other)) = taken.iter().find(|(index, _)| index == one) {
                    faults.push(Fault::ColumnTwice { column: excerpt(name), roles: [*other, role] });
                } else {
                    taken.push((*one, role));
                    *slot = Some(*one);
                    *failed = false;
                }
            }
            several => faults.push(Fault::Ambiguous { role, columns: chosen_names(headings, several) }),
        }
    }
    for ((role, slot), failed) in Role::ALL.into_iter().zip(&mut picks).zip(&mut failed) {
        if layout.column(role).unused || slot.is_some() || *failed {
            continue;
        }
        let mut found =
            indices(headings, |heading| role.names().iter().any(|name| heading.bare.to_lowercase() == **name));
        found.retain(|index| taken.iter().all(|(other, _)| other != index));
        match found.as_slice() {
            [] => {}
            [one] => *slot = Some(*one),
            several => {
                *failed = true;
                faults.push(Fault::Ambiguous { role, columns: chosen_names(headings, several) });
            }
        }
    }
    let [time, position, speed, _] = picks;
    let [time_failed, position_failed, speed_failed, _] = failed;
    if time.is_none() && !time_failed {
        faults.push(Fault::TimeMissing { headers: names() });
    }
    if position.is_none() && speed.is_none() && !position_failed && !speed_failed {
        faults.push(Fault::CourseMissing { headers: names() });
    }
    picks
}

fn indices(headings: &[Heading], matches: impl Fn(&Heading) -> bool) -> Vec<usize> {
    headings.iter().enumerate().filter(|(_, heading)| matches(heading)).map(|(index, _)| index).collect()
}

fn chosen_names(headings: &[Heading], indices: &[usize]) -> Vec<String> {
    let chosen = indices.iter().take(NAMES_MAX + 1).filter_map(|index| headings.get(*index));
    chosen.map(|heading| excerpt(&heading.written)).collect()
}

/// The column whose name is nearest to one that does not exist.
fn nearest(headings: &[Heading], name: &str) -> Option<String> {
    // Longer names are not typing errors; the distance costs the product of both lengths.
    const LONGEST: usize = 64;
    if name.len() > LONGEST {
        return None;
    }
    let wanted = name.to_lowercase();
    let length = wanted.chars().count();
    headings
        .iter()
        .filter(|heading| heading.written.len() <= LONGEST && !heading.bare.is_empty())
        .map(|heading| {
            let to = |known: &str| strsim::damerau_levenshtein(&wanted, &known.to_lowercase());
            (to(&heading.bare).min(to(&heading.written)), heading)
        })
        .filter(|(distance, _)| *distance <= 1 + length / 3 && *distance < length)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, heading)| excerpt(&heading.written))
}

/// A statement of a unit.
#[derive(Clone, Debug)]
pub(crate) enum Said {
    Text(String),
    Unit(&'static Unit),
}

/// The unit of a column out of everything that is said about it.
pub(crate) fn decide(
    role: Role,
    heading: &Heading,
    said: Vec<(KnownBy, Said)>,
    faults: &mut Faults,
) -> Option<ColumnRead> {
    let column = excerpt(&heading.written);
    let mut decided: Option<(&'static Unit, KnownBy)> = None;
    let mut sound = true;
    for (by, said) in said {
        let unit = match said {
            Said::Unit(unit) => unit,
            Said::Text(text) => {
                let known = role.dimensions().iter().find_map(|dimension| Unit::of_dimension(*dimension, &text));
                match known.or_else(|| Unit::of(&text)) {
                    Some(unit) => unit,
                    None => {
                        let nearest = nearest_unit(role, &text);
                        let (column, text) = (column.clone(), excerpt(&text));
                        faults.push(Fault::UnitUnknown { role, column, text, by, nearest });
                        sound = false;
                        continue;
                    }
                }
            }
        };
        if !role.dimensions().contains(&unit.dimension) {
            faults.push(Fault::UnitWrong { role, column: column.clone(), unit, by });
            sound = false;
            continue;
        }
        match decided {
            None => decided = Some((unit, by)),
            Some((first, _)) if first == unit => {}
            Some((first, first_by)) => {
                faults.push(Fault::UnitContradiction {
                    column: column.clone(),
                    units: [first, unit],
                    by: [first_by, by],
                });
                sound = false;
            }
        }
    }
    match decided {
        Some((unit, known_by)) if sound => {
            Some(ColumnRead { role, name: seen(&heading.written).into_owned(), unit, known_by })
        }
        None if sound => {
            faults.push(Fault::UnitMissing { role, column });
            None
        }
        _ => None,
    }
}

/// The unit of a role whose spelling is nearest.
fn nearest_unit(role: Role, text: &str) -> Option<&'static Unit> {
    let distance = |unit: &Unit| unit.spellings().map(|known| strsim::damerau_levenshtein(text, known)).min();
    role.dimensions().iter().filter_map(|dimension| Unit::nearest(*dimension, text)).min_by_key(|unit| distance(unit))
}

/// Position and speed must be of the same kind.
pub(crate) fn check_course(columns: &[ColumnRead], faults: &mut Faults) {
    let of = |role: Role| columns.iter().find(|column| column.role == role).map(|column| column.unit);
    if let (Some(position), Some(speed)) = (of(Role::Position), of(Role::Speed))
        && Along::of(position) != Along::of(speed)
    {
        let (position, speed): (Dimension, Dimension) = (position.dimension, speed.dimension);
        faults.push(Fault::CourseMixed { position, speed });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_carries_its_unit_in_these_ways_only() {
        for (written, bare, unit) in [
            ("time [s]", "time", Some("s")),
            ("q(deg)", "q", Some("deg")),
            ("n / 1/min", "n", Some("1/min")),
            ("n / (1/min)", "n", Some("1/min")),
            ("n [1/min]", "n", Some("1/min")),
            ("n in 1/min", "n", Some("1/min")),
            ("t/s", "t", Some("s")),
            ("v/vmax", "v/vmax", None),
            ("t_s", "t_s", None),
            ("(deg)", "(deg)", None),
            ("M", "M", None),
        ] {
            let heading = Heading::new(written);
            assert_eq!((heading.bare.as_str(), heading.unit.as_deref()), (bare, unit), "{written}");
        }
    }
}
