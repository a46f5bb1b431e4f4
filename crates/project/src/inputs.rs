//! Every key of a project file with its value.

use crate::read::Reader;
use crate::root::Root;
use quantities::Unit;
use quantities::unit::PERCENT;
use std::collections::BTreeMap;
use std::ops::Range as Span;

/// One value of a project file.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Key: `load.inertia`, `motion[2].speed`, `mechanism.table.points[1][3]`, `axis[1].requirements.supply`.
    pub path: String,
    /// Value as written, without quotes.
    pub written: String,
    /// Number in its unit as written; `None` for other values.
    pub amount: Option<(f64, &'static Unit)>,
    /// Half-width of its tolerance, in the same unit.
    pub half_width: Option<f64>,
    /// Place in the file, in bytes.
    pub span: Span<usize>,
}

impl Input {
    /// Returns `true` if another value is equal, as `"0.1 s"` and `"100 ms"` are.
    fn says_the_same(&self, other: &Self) -> bool {
        let si = |input: &Self| {
            let (value, unit) = input.amount?;
            let half = input.half_width.map_or(0.0, |half| unit.to_si(value + half) - unit.to_si(value));
            Some((unit.to_si(value), half, unit.dimension))
        };
        match (si(self), si(other)) {
            (Some((a, half_a, of_a)), Some((b, half_b, of_b))) => {
                let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * a.abs().max(b.abs());
                // A half-width is a difference: it is as exact as the values from which it is computed.
                let half = (half_a - half_b).abs() <= 1e-12 * a.abs().max(half_a.abs()).max(half_b.abs());
                of_a == of_b && near(a, b) && half
            }
            _ => self.written == other.written,
        }
    }
}

/// Returns every value of a project file in the order of the file, without those that the reader refuses.
///
/// Files that the project refers to are included by their names.
#[must_use]
pub fn inputs(text: &str) -> Vec<Input> {
    let mut reader = Reader::new(text);
    reader.inputs = Some(Vec::new());
    let _: Root = reader.read();
    let mut found = std::mem::take(&mut reader.inputs).unwrap_or_default();
    for tolerance in &reader.tolerances {
        let Some(input) = found.iter_mut().find(|input| input.path == tolerance.path) else { continue };
        let unit = input.amount.map_or(tolerance.unit, |(_, unit)| unit);
        let of = |si: f64| unit.from_si(si);
        input.half_width = Some(of(tolerance.nominal + tolerance.half_width) - of(tolerance.nominal));
    }
    found.sort_by_key(|input| (input.span.start, input.span.end));
    found
}

/// A value that differs between two project files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputChange {
    /// Key.
    pub path: String,
    /// Value in the first file as written; `None` if it is missing there.
    pub old: Option<String>,
    /// Value in the second file as written; `None` if it is missing there.
    pub new: Option<String>,
}

/// Returns the values that differ between two project files, in the order of the second; removed ones come last.
///
/// Values are compared by meaning: another spelling of an equal quantity is no change. Of several axes one of each file
/// is compared, with its keys as if it were the only one.
#[must_use]
pub fn input_changes(old: (&str, usize), new: (&str, usize)) -> Vec<InputChange> {
    let of_axis = |(text, axis): (&str, usize)| -> Vec<Input> {
        let own = format!("axis[{}].", axis + 1);
        let path = |path: &str| match path.strip_prefix(own.as_str()) {
            None if path.starts_with("axis[") => None,
            inside => Some(inside.unwrap_or(path).to_owned()),
        };
        inputs(text).into_iter().filter_map(|input| Some(Input { path: path(&input.path)?, ..input })).collect()
    };
    let (old, new) = (of_axis(old), of_axis(new));
    let by_path = |inputs: &[Input]| -> BTreeMap<String, Input> {
        inputs.iter().map(|input| (input.path.clone(), input.clone())).collect()
    };
    let (before, after) = (by_path(&old), by_path(&new));
    let mut changes: Vec<InputChange> = new
        .iter()
        .filter(|input| !before.get(&input.path).is_some_and(|old| old.says_the_same(input)))
        .map(|input| InputChange {
            path: input.path.clone(),
            old: before.get(&input.path).map(|old| old.written.clone()),
            new: Some(input.written.clone()),
        })
        .collect();
    let gone = old.into_iter().filter(|input| !after.contains_key(&input.path));
    changes.extend(gone.map(|input| InputChange { path: input.path, old: Some(input.written), new: None }));
    changes
}

impl Reader<'_> {
    /// Records a value if requested.
    pub(crate) fn input(&mut self, path: &str, span: &Span<usize>, amount: Option<(f64, &'static Unit)>) {
        let text = self.text();
        let Some(inputs) = &mut self.inputs else { return };
        let raw = text.get(span.clone()).unwrap_or_default();
        let written = ["\"\"\"", "'''", "\"", "'"]
            .iter()
            .find_map(|quote| raw.strip_prefix(quote)?.strip_suffix(quote))
            .unwrap_or(raw)
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ");
        let amount = amount.map(|(value, unit)| in_percent(&written).unwrap_or((value, unit)));
        inputs.push(Input { path: path.to_owned(), written, amount, half_width: None, span: span.clone() });
    }
}

/// Returns the number of a ratio that is written in percent.
fn in_percent(written: &str) -> Option<(f64, &'static Unit)> {
    let end = written.find(|sign: char| !matches!(sign, '0'..='9' | '.' | '-' | '+'))?;
    let (number, rest) = written.split_at(end);
    rest.trim_start().starts_with(PERCENT.symbol).then_some(())?;
    Some((number.parse().ok()?, &PERCENT))
}

#[cfg(test)]
mod tests {
    use super::*;

    const OLD: &str = "format = 1\n[load]\ninertia = \"1.3 kg m^2 ± 10 %\"\nfriction_torque = \"5 N m\"\n\
        [[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\n\
        pause = \"1 s\"\n[requirements]\nfeedback = [\"C1024\",\n  \"M512P\"]\nambient = \"20 degC ± 5 K\"\n";

    #[test]
    fn every_value_is_reported_with_path_number_unit_and_tolerance() {
        let found = inputs(OLD);
        let listed: Vec<(&str, &str)> =
            found.iter().map(|input| (input.path.as_str(), input.written.as_str())).take(4).collect();
        assert_eq!(
            listed,
            [
                ("format", "1"),
                ("load.inertia", "1.3 kg m^2 ± 10 %"),
                ("load.friction_torque", "5 N m"),
                ("motion[1].law", "manual")
            ]
        );
        let of = |path: &str| found.iter().find(|input| input.path == path).unwrap();
        let (value, unit) = of("motion[1].speed").amount.unwrap();
        assert_eq!((value, unit.json), (40.0, "1/min"));
        assert!((of("load.inertia").half_width.unwrap() - 0.13).abs() < 1e-12);
        assert!((of("requirements.ambient").half_width.unwrap() - 5.0).abs() < 1e-9);
        assert_eq!(of("requirements.feedback").written, "[\"C1024\", \"M512P\"]");
        assert_eq!(of("requirements.feedback").amount, None);
    }

    /// A ratio is a number in its unit as written: in percent where it is written in percent.
    #[test]
    fn a_ratio_keeps_the_percent_in_which_it_is_written() {
        let of = |written: &str| {
            let text = format!("{OLD}humidity_max = {written}\n");
            let found = inputs(&text).into_iter().find(|input| input.path == "requirements.humidity_max").unwrap();
            found.amount.map(|(value, unit)| (value, unit.symbol))
        };
        for percent in [1.0, 7.0, 29.0, 57.5, 75.0, 100.0] {
            assert_eq!(of(&format!("\"{percent} %\"")), Some((percent, "%")), "{percent}");
        }
        assert_eq!(of("\"75%\""), Some((75.0, "%")));
        assert_eq!(of("0.75"), Some((0.75, "1")));
        let [one, other] = ["0.75", "\"75 %\""].map(|written| format!("{OLD}humidity_max = {written}\n"));
        assert_eq!(input_changes((&one, 0), (&other, 0)), []);
    }

    #[test]
    fn rows_and_bodies_are_reported_one_by_one() {
        let text = "[mechanism.table]\npoints = [[\"0 deg\", \"1 N m\"], [\"9 deg\", \"2 N m ± 1 N m\"]]\n\
            [mechanism.turntable]\nbodies = [\"point mass=1kg distance=1m\"]\n";
        let found = inputs(text);
        let paths: Vec<&str> = found.iter().map(|input| input.path.as_str()).collect();
        assert!(paths.contains(&"mechanism.turntable.bodies[1]"), "{paths:?}");
        let body = found.iter().find(|input| input.path == "mechanism.turntable.bodies[1]").unwrap();
        assert_eq!((body.written.as_str(), body.amount), ("point mass=1kg distance=1m", None));
    }

    #[test]
    fn axes_are_compared_by_themselves_wherever_they_stand() {
        let one = "[[axis]]\nname = \"a\"\n[axis.load]\ninertia = \"1 kg m^2\"\n";
        let two = "[[axis]]\nname = \"b\"\n[axis.load]\ninertia = \"2 kg m^2\"\n";
        let (before, after) = (format!("format = 1\n{one}{two}"), format!("format = 1\n{two}{one}"));
        assert_eq!(input_changes((&before, 0), (&after, 1)), []);
        let changes = input_changes((&before, 0), (&after, 0));
        assert_eq!(changes.iter().map(|change| change.path.as_str()).collect::<Vec<_>>(), ["name", "load.inertia"]);
    }

    #[test]
    fn another_spelling_of_the_same_is_no_change() {
        let new = OLD.replace("accelerate = \"0.1 s\"", "accelerate = \"100 ms\"");
        assert_eq!(input_changes((OLD, 0), (&new, 0)), []);
        let new = OLD.replace("± 10 %", "").replace("5 N m", "6 N m").replace("pause = \"1 s\"\n", "");
        let listed: Vec<_> = input_changes((OLD, 0), (&new, 0)).into_iter().map(|c| (c.path, c.old, c.new)).collect();
        let some = |text: &str| Some(text.to_owned());
        assert_eq!(
            listed,
            [
                ("load.inertia".to_owned(), some("1.3 kg m^2 ± 10 %"), some("1.3 kg m^2")),
                ("load.friction_torque".to_owned(), some("5 N m"), some("6 N m")),
                ("motion[1].pause".to_owned(), some("1 s"), None),
            ]
        );
    }
}
