//! Assignment of columns to roles, and their units.

use crate::collected::FaultCollector;
use crate::factor::factor_in;
use crate::faults::{Fault, NearColumn, excerpt};
use crate::layout::{Layout, Role};
use crate::limits::NAMES_MAX;
use crate::names::{Named, Sureness, axis_of, before_nanoseconds, before_seconds, is_share};
use crate::series::{Along, ColumnRead, KnownBy};
use quantities::{Unit, seen};

/// Heading of a column.
#[derive(Clone, Debug)]
pub(crate) struct Heading {
    /// Text as written.
    pub(crate) written: String,
    /// Name and unit, if the unit is marked as one.
    pub(crate) named: Named,
    /// Text of the column in the line below the heading, which may be a row of units.
    pub(crate) below: Option<String>,
    /// The first row has a clock time in the column.
    pub(crate) is_clock: bool,
}

/// Symbol of a torque that names a column only together with a unit.
const TORQUE: &str = "T";

impl Heading {
    pub(crate) fn new(written: &str) -> Self {
        let written = written.trim();
        Self { written: written.to_owned(), named: Named::with_share(written), below: None, is_clock: false }
    }

    /// Matches the usual names of a role, also with a unit after an underscore, which may otherwise be part of the
    /// name.
    fn by_usual_name(&self, role: Role) -> Option<Pick> {
        let pick =
            |reading: &Named| Some(Pick { index: 0, sureness: reading.sureness(role)?, unit: reading.unit.clone() });
        let is_usual = |bare: &str| Named { bare: bare.to_owned(), unit: None }.sureness(role).is_some();
        // T alone may be a time or a temperature; its unit says that it is a torque.
        let is_torque = || role == Role::Torque && self.named.bare == TORQUE && self.has_unit_of(role);
        pick(&self.named).or_else(|| pick(&self.named.for_role(role, is_usual)?)).or_else(|| {
            is_torque().then(|| Pick { index: 0, sureness: Sureness::Measured, unit: self.named.unit.clone() })
        })
    }

    /// Returns `true` if the name or the row of units states a unit of the role.
    fn has_unit_of(&self, role: Role) -> bool {
        let of_role = |unit: &String| role.dimensions().iter().any(|of| Unit::of_dimension(*of, unit).is_some());
        [&self.named.unit, &self.below].into_iter().flatten().any(of_role)
            || self.named.for_role(role, |_| true).is_some()
    }

    /// Returns `true` if the name or the row of units states a unit of another quantity than the role's, or a share of it.
    fn has_unit_of_another(&self, role: Role) -> bool {
        let is_unit = |unit: &String| is_share(unit) || Unit::of(unit.trim_matches(['[', ']', '(', ')'])).is_some();
        [&self.named.unit, &self.below].into_iter().flatten().any(is_unit) && !self.has_unit_of(role)
    }

    /// Matches a name given in a layout, with or without its unit.
    fn is_named(&self, name: &str, role: Role) -> Option<Pick> {
        let same = |one: &str| one == name || one.to_lowercase() == name.to_lowercase();
        let with_unit = self.named.for_role(role, |bare| same(bare) || same(&self.written));
        let reading =
            with_unit.or_else(|| (same(&self.named.bare) || same(&self.written)).then(|| self.named.clone()))?;
        let exact = self.written == name || reading.bare == name;
        Some(Pick { index: 0, unit: reading.unit, sureness: if exact { Sureness::Plain } else { Sureness::Measured } })
    }
}

/// A column chosen for a role.
#[derive(Clone, Debug)]
pub(crate) struct Pick {
    pub(crate) index: usize,
    /// Unit stated in the name.
    pub(crate) unit: Option<String>,
    sureness: Sureness,
}

/// The columns chosen, in the order of [`Role::ALL`].
pub(crate) type Picks = [Option<Pick>; 4];

/// Additional columns of time.
#[derive(Clone, Debug, Default)]
pub(crate) struct MoreTime {
    /// Index of the column of nanoseconds that add to a column of whole seconds.
    pub(crate) nanoseconds: Option<usize>,
    /// Indices of columns with the same name, one next to each channel; they must hold the same times.
    pub(crate) twins: Vec<usize>,
}

/// Finds the column of every role; reports missing and ambiguous ones.
pub(crate) fn pick(headings: &[Heading], layout: &Layout, faults: &mut FaultCollector) -> (Picks, MoreTime) {
    let mut picks: Picks = [const { None }; 4];
    let mut more = MoreTime::default();
    let mut failed = [false; 4];
    // One more name than is shown indicates that there are more.
    let names = || headings.iter().take(NAMES_MAX + 1).map(|heading| excerpt(&heading.written)).collect::<Vec<_>>();
    // Columns named in the layout are assigned first and are not available for other roles.
    let mut taken: Vec<(usize, Role)> = Vec::new();
    for ((role, slot), failed) in Role::ALL.into_iter().zip(&mut picks).zip(&mut failed) {
        let spec = layout.column(role);
        let Some(name) = spec.name.as_deref().map(str::trim).filter(|_| !spec.unused) else { continue };
        *failed = true;
        let mut found = surest(headings, &[], |heading| heading.is_named(name, role));
        if found.is_empty() {
            found.extend(numbered(headings, name));
        }
        more.keep_first(role, headings, &mut found);
        match found.as_slice() {
            [] => faults.push(Fault::ColumnUnknown {
                role,
                name: excerpt(name),
                nearest: nearest(headings, name),
                headers: names(),
            }),
            [one] => {
                if let Some((_, other)) = taken.iter().find(|(index, _)| *index == one.index) {
                    faults.push(Fault::ColumnTwice { column: excerpt(name), roles: [*other, role] });
                } else {
                    taken.push((one.index, role));
                    *slot = Some(one.clone());
                    *failed = false;
                }
            }
            several => faults.push(ambiguous(role, headings, several)),
        }
    }
    for ((role, slot), failed) in Role::ALL.into_iter().zip(&mut picks).zip(&mut failed) {
        if layout.column(role).unused || slot.is_some() || *failed {
            continue;
        }
        // A column with a unit of another quantity is chosen only where there is no other: names that differ in case only (t in s,
        // T in Nm) are distinguished by their units, and a torque in Nm stands before one in percent.
        let by_unit = |heading: &Heading| heading.by_usual_name(role).filter(|_| !heading.has_unit_of_another(role));
        let mut found = surest(headings, &taken, by_unit);
        if found.is_empty() {
            found = surest(headings, &taken, |heading| heading.by_usual_name(role));
        }
        if role == Role::Time && found.is_empty() {
            found.extend(seconds(headings));
        }
        if role != Role::Time {
            found.extend(repeated(headings, &found));
        }
        more.keep_first(role, headings, &mut found);
        match found.as_slice() {
            [] => {}
            [one] => *slot = Some(one.clone()),
            several => {
                *failed = true;
                faults.push(ambiguous(role, headings, several));
            }
        }
    }
    if let Some(fault) = several_axes(headings, &picks, &taken) {
        faults.push(fault);
    }
    let [time, ..] = &picks;
    more.nanoseconds = time.as_ref().and_then(|time| nanoseconds(headings, time.index));
    let [time_failed, position_failed, speed_failed, _] = failed;
    let missing = |role: Role| picks.iter().zip(Role::ALL).any(|(pick, of)| of == role && pick.is_none());
    let near = |roles: &[Role]| {
        let used = |index: usize| picks.iter().flatten().any(|pick| pick.index == index);
        let mut found: Vec<NearColumn> = Vec::new();
        for near in roles.iter().filter_map(|role| proposed(headings, *role, used)) {
            // One column cannot have two roles.
            if found.iter().all(|other| other.column != near.column) {
                found.push(near);
            }
        }
        found
    };
    if missing(Role::Time) && !time_failed {
        faults.push(Fault::TimeMissing { headers: names(), near: near(&[Role::Time]) });
    }
    if missing(Role::Position) && missing(Role::Speed) && !position_failed && !speed_failed {
        faults.push(Fault::CourseMissing { headers: names(), near: near(&[Role::Position, Role::Speed]) });
    }
    let has_course = !missing(Role::Position) || !missing(Role::Speed);
    for (role, failed) in Role::ALL.into_iter().zip(failed) {
        let spec = layout.column(role);
        let is_stated = spec.unit.is_some() && !spec.unused && role != Role::Time;
        // Read without it, the motion would be that of another column.
        if is_stated && has_course && missing(role) && !failed {
            faults.push(Fault::UnitWithoutColumn { role, headers: names(), near: near(&[role]) });
        }
    }
    (picks, more)
}

/// Returns the fault of columns of different axes that were chosen by their usual names: `axis1.pos` and `axis2.tau`.
pub(crate) fn several_axes(headings: &[Heading], picks: &Picks, taken: &[(usize, Role)]) -> Option<Fault> {
    let chosen: Vec<(Role, &Heading)> = Role::ALL
        .into_iter()
        .zip(picks)
        .filter(|(role, _)| *role != Role::Time)
        .filter_map(|(role, pick)| Some((role, headings.get(pick.as_ref()?.index)?)))
        .collect();
    let is_named = |role: Role| taken.iter().any(|(_, other)| *other == role);
    let axes: Vec<Option<(String, String)>> = chosen.iter().map(|(_, heading)| axis_of(&heading.named.bare)).collect();
    let differ = axes.iter().enumerate().any(|(place, one)| {
        let rest = axes.iter().skip(place + 1).flatten();
        one.as_ref().is_some_and(|(word, index)| rest.into_iter().any(|(other, of)| word == other && index != of))
    });
    // What a layout names is meant so.
    let is_stated = chosen.iter().filter(|(role, _)| !is_named(*role)).count() == 0;
    (differ && !is_stated).then(|| Fault::SeveralAxes {
        columns: chosen
            .iter()
            .map(|(role, heading)| (*role, writable(headings, heading).unwrap_or_else(|| excerpt(&heading.written))))
            .collect(),
    })
}

impl MoreTime {
    /// Keeps the first of several columns of time with one name; the others are compared with it while reading.
    fn keep_first(&mut self, role: Role, headings: &[Heading], found: &mut Vec<Pick>) {
        let named = |pick: &Pick| headings.get(pick.index).map(|heading| heading.written.to_lowercase());
        let first = found.first().and_then(named);
        if role == Role::Time && found.len() > 1 && found.iter().all(|pick| named(pick) == first) {
            self.twins = found.drain(1..).map(|pick| pick.index).collect();
        }
    }
}

/// Returns the columns that a data frame renamed because their headings equal that of the only chosen one: pandas writes
/// `q [deg].1`, polars `q [deg]_duplicated_0`.
fn repeated(headings: &[Heading], found: &[Pick]) -> Vec<Pick> {
    let [one] = found else { return Vec::new() };
    let Some(chosen) = headings.get(one.index) else { return Vec::new() };
    let is_repeated = |heading: &Heading| {
        let behind = heading.written.strip_prefix(chosen.written.as_str());
        let number = behind.and_then(|rest| rest.strip_prefix('.').or_else(|| rest.strip_prefix("_duplicated_")));
        number.is_some_and(|number| !number.is_empty() && number.bytes().all(|digit| digit.is_ascii_digit()))
    };
    let all = headings.iter().enumerate().filter(|(_, heading)| is_repeated(heading));
    all.map(|(index, _)| Pick { index, ..one.clone() }).collect()
}

/// Returns the column with the number given in a layout, `#3`.
fn numbered(headings: &[Heading], name: &str) -> Option<Pick> {
    let index = name.strip_prefix('#')?.parse::<usize>().ok()?.checked_sub(1)?;
    let heading = headings.get(index)?;
    Some(Pick { index, unit: heading.named.unit.clone(), sureness: Sureness::Plain })
}

/// Returns the only column of whole seconds with a column of nanoseconds next to it.
fn seconds(headings: &[Heading]) -> Option<Pick> {
    let mut found = (0..headings.len()).filter(|index| nanoseconds(headings, *index).is_some());
    let index = found.next().filter(|_| found.next().is_none())?;
    Some(Pick { index, unit: None, sureness: Sureness::Plain })
}

/// Returns the index of the column of nanoseconds that belongs to one of whole seconds.
fn nanoseconds(headings: &[Heading], seconds: usize) -> Option<usize> {
    let before = before_seconds(&headings.get(seconds)?.written)?;
    headings.iter().position(|heading| before_nanoseconds(&heading.written) == Some(before))
}

fn ambiguous(role: Role, headings: &[Heading], picks: &[Pick]) -> Fault {
    let numbers = picks.iter().take(NAMES_MAX + 1).map(|pick| pick.index + 1).collect();
    Fault::Ambiguous { role, columns: chosen_names(headings, picks), numbers }
}

/// Returns the headings that are not used, without those that the layout leaves out by `none`; a reader could assume that
/// they are.
pub(crate) fn unused(headings: &[Heading], layout: &Layout, used: &[usize]) -> Vec<String> {
    let is_left_out = |heading: &Heading| {
        let mut usual = Role::ALL.into_iter().filter(|role| heading.by_usual_name(*role).is_some()).peekable();
        usual.peek().is_some() && usual.all(|role| layout.column(role).unused)
    };
    let free = headings.iter().enumerate().filter(|(index, _)| !used.contains(index)).map(|(_, heading)| heading);
    free.filter(|heading| !heading.written.is_empty() && !is_left_out(heading))
        .take(PROPOSED_FROM)
        .map(|heading| excerpt(&heading.written))
        .collect()
}

/// Returns the columns with the surest match, among those without a role.
fn surest(headings: &[Heading], taken: &[(usize, Role)], pick: impl Fn(&Heading) -> Option<Pick>) -> Vec<Pick> {
    let free = headings.iter().enumerate().filter(|(index, _)| taken.iter().all(|(other, _)| other != index));
    let mut found: Vec<Pick> = free.filter_map(|(index, heading)| Some(Pick { index, ..pick(heading)? })).collect();
    let best = found.iter().map(|pick| pick.sureness).min();
    found.retain(|pick| Some(pick.sureness) == best);
    found
}

/// Returns the index that a data frame writes as a column, without a heading in a text and with an invented one in Parquet,
/// with its name in a layout, and `true` if its type states the unit.
fn index_column(headings: &[Heading]) -> Option<(usize, String, bool)> {
    let invented = |(index, heading): (usize, &Heading)| {
        let inner = heading.written.strip_prefix("__index_level_")?.strip_suffix("__")?;
        inner.bytes().all(|byte| byte.is_ascii_digit()).then(|| (index, heading.written.clone(), true))
    };
    let first = headings.first().filter(|heading| heading.written.trim().is_empty() && headings.len() > 1);
    let nameless = || first.map(|heading| (0, "#1".to_owned(), heading.is_clock));
    headings.iter().take(PROPOSED_FROM).enumerate().find_map(invented).or_else(nameless)
}

/// Returns the column that probably has a role: the only one with a unit of the role, else the one whose name contains
/// or is closest to one of its names.
fn proposed(headings: &[Heading], role: Role, is_used: impl Fn(usize) -> bool) -> Option<NearColumn> {
    let free = || {
        headings
            .iter()
            .take(PROPOSED_FROM)
            .enumerate()
            .filter(|(index, _)| !is_used(*index))
            .map(|(_, heading)| heading)
    };
    let has_unit = |heading: &&Heading| heading.has_unit_of(role);
    let with_unit: Vec<&Heading> = free().filter(has_unit).collect();
    let by_name = || {
        // Short names are close to any name.
        let names = || role.names().iter().filter(|name| name.len() >= 3);
        let distance = |heading: &Heading| {
            let small = heading.named.bare.to_lowercase();
            let to = |name: &&str| if small.contains(*name) { 1 } else { strsim::damerau_levenshtein(&small, name) };
            names().map(|name| (to(name), name.len())).filter(|(distance, length)| *distance <= length / 3).min()
        };
        let near = free()
            .filter(|heading| heading.written.len() <= LONGEST)
            .filter_map(|heading| Some((distance(heading)?, heading)));
        near.min_by_key(|(distance, _)| *distance).map(|(_, heading)| heading)
    };
    let of_clock: Vec<&Heading> = free().filter(|heading| role == Role::Time && heading.is_clock).collect();
    let found = match (with_unit.as_slice(), of_clock.as_slice()) {
        ([one], _) | (_, [one]) => *one,
        _ => match index_column(headings).filter(|(index, ..)| role == Role::Time && !is_used(*index)) {
            Some((_, column, has_unit)) => return Some(NearColumn { role, column, has_unit }),
            None => by_name()?,
        },
    };
    let has_unit = has_unit(&found) || role == Role::Time && found.is_clock;
    Some(NearColumn { role, column: writable(headings, found)?, has_unit })
}

/// Number of leading columns that are searched for a proposal.
const PROPOSED_FROM: usize = 256;

/// Maximum length of a name in spelling comparisons: longer names are not typing errors, and the distance costs the
/// product of both lengths.
const LONGEST: usize = 64;

fn chosen_names(headings: &[Heading], picks: &[Pick]) -> Vec<String> {
    let chosen = picks.iter().take(NAMES_MAX + 1).filter_map(|pick| headings.get(pick.index));
    chosen.filter_map(|heading| whole_name(heading).or_else(|| number(headings, heading))).collect()
}

/// Returns the name of a column closest to one that does not exist.
fn nearest(headings: &[Heading], name: &str) -> Option<String> {
    if name.len() > LONGEST {
        return None;
    }
    let wanted = name.to_lowercase();
    let length = wanted.chars().count();
    headings
        .iter()
        .filter(|heading| heading.written.len() <= LONGEST && !heading.named.bare.is_empty())
        .map(|heading| {
            let to = |known: &str| strsim::damerau_levenshtein(&wanted, &known.to_lowercase());
            (to(&heading.named.bare).min(to(&heading.written)), heading)
        })
        .filter(|(distance, _)| *distance <= 1 + length / 3 && *distance < length)
        .min_by_key(|(distance, _)| *distance)
        .and_then(|(_, heading)| writable(headings, heading))
}

/// Returns the name of a column as it can be written in a layout: a shortened or empty name and one of several columns
/// names no column, its number does.
pub(crate) fn writable(headings: &[Heading], heading: &Heading) -> Option<String> {
    let name = heading.written.to_lowercase();
    let is_same = |other: &&Heading| [&other.written, &other.named.bare].iter().any(|text| text.to_lowercase() == name);
    let is_only = || headings.iter().filter(is_same).take(2).count() == 1;
    let whole = whole_name(heading).filter(|name| !name.is_empty() && is_only());
    whole.or_else(|| number(headings, heading))
}

/// Returns the name of a column; `None` if it would be shortened.
fn whole_name(heading: &Heading) -> Option<String> {
    let shown = excerpt(&heading.written);
    (shown == heading.written).then_some(shown)
}

/// Returns the number of a column, `#3`.
fn number(headings: &[Heading], heading: &Heading) -> Option<String> {
    let place = headings.iter().position(|other| std::ptr::eq(other, heading))?;
    Some(format!("#{}", place + 1))
}

/// A statement of a unit, as text or resolved.
#[derive(Clone, Debug)]
pub(crate) enum Said {
    Text(String),
    Unit(&'static Unit),
}

/// Determines the unit of a column from all statements about it; reports missing, unknown and contradictory ones. A text
/// that is no unit does not count where the layout states one: brackets also hold other words, `V(pos)`.
pub(crate) fn decide(
    role: Role,
    heading: &Heading,
    said: impl IntoIterator<Item = (KnownBy, Said)>,
    faults: &mut FaultCollector,
) -> Option<ColumnRead> {
    let column = excerpt(&heading.written);
    let mut decided: Option<(&'static Unit, KnownBy)> = None;
    let mut sound = true;
    if let Some(text) = factor_in(&heading.named.bare) {
        faults.push(Fault::UnitScaled { column: column.clone(), text: excerpt(text) });
        sound = false;
    }
    let said: Vec<(KnownBy, Said)> = said.into_iter().collect();
    let is_stated = said.iter().any(|(by, _)| *by == KnownBy::Layout);
    for (by, said) in said {
        let unit = match said {
            Said::Unit(unit) => unit,
            Said::Text(text) => {
                let known = role.dimensions().iter().find_map(|dimension| Unit::of_dimension(*dimension, &text));
                match known.or_else(|| Unit::of(&text)) {
                    Some(unit) => unit,
                    None if is_stated && !is_scaled(&text) => continue,
                    None if is_stated => {
                        faults.push(Fault::UnitScaled { column: column.clone(), text: excerpt(&text) });
                        sound = false;
                        continue;
                    }
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

/// Returns `true` if a text has a factor beside a unit, or is a share: `0.001 deg`, `Nm/10`, `% rated`. A unit that is stated
/// elsewhere does not say the factor.
fn is_scaled(text: &str) -> bool {
    let is_unit = |text: &str| Unit::of(text.trim()).is_some();
    let of_number = |sign: char| sign.is_ascii_digit() || "+-.,eE/^*·× ".contains(sign);
    let (factor, unit) = text.split_at(text.find(|sign| !of_number(sign)).unwrap_or(text.len()));
    // `1/s` is a unit, though none that is known.
    let is_factor = factor.contains(|sign: char| sign.is_ascii_digit()) && factor.trim() != "1/";
    let is_number = |text: &str| text.trim().replace(',', ".").parse::<f64>().is_ok();
    let behind = text.split_once(['*', '/', '·', '×']);
    is_share(text)
        || is_factor && is_unit(unit)
        || behind.is_some_and(|(unit, factor)| is_unit(unit) && is_number(factor))
}

/// Returns the unit of a role that was probably meant; `None` if units of two dimensions are possible.
fn nearest_unit(role: Role, text: &str) -> Option<&'static Unit> {
    let mut found = role.dimensions().iter().filter_map(|dimension| Unit::nearest(*dimension, text));
    found.next().filter(|_| found.next().is_none())
}

/// Reports position and speed of different kinds, one rotary and one linear.
pub(crate) fn check_course(columns: &[ColumnRead], faults: &mut FaultCollector) {
    let of = |role: Role| columns.iter().find(|column| column.role == role).map(|column| column.unit);
    if let (Some(position), Some(speed)) = (of(Role::Position), of(Role::Speed))
        && Along::of(position) != Along::of(speed)
    {
        faults.push(Fault::CourseMixed { position: position.dimension, speed: speed.dimension });
    }
}

/// Returns the columns of a heading that holds units alone, a unit of time among them, each with the role that its unit
/// permits and its number; `None` if a column has a name or the layout names one.
pub(crate) fn units_alone(headings: &[Heading], layout: &Layout) -> Option<Vec<(Role, usize, &'static Unit)>> {
    if Role::ALL.into_iter().any(|role| layout.column(role).name.is_some()) {
        return None;
    }
    let unit = |heading: &Heading| {
        let text = heading.written.trim();
        let inner =
            [('[', ']'), ('(', ')')].iter().find_map(|(open, end)| text.strip_prefix(*open)?.strip_suffix(*end));
        let text = inner.unwrap_or(text).trim();
        let of_role = |role: Role| {
            let unit = role.dimensions().iter().find_map(|dimension| Unit::of_dimension(*dimension, text));
            unit.map(|unit| (role, unit))
        };
        Role::ALL.into_iter().find_map(of_role)
    };
    let columns = headings.iter().zip(1_usize..).map(|(heading, number)| {
        let (role, unit) = unit(heading)?;
        Some((role, number, unit))
    });
    let columns: Vec<_> = columns.collect::<Option<_>>()?;
    columns.iter().any(|(role, ..)| *role == Role::Time).then_some(columns)
}
