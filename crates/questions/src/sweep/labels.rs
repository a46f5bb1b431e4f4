//! Columns of a table that are no keys: they identify its rows and are carried into the answer.
#![allow(clippy::result_large_err, reason = "a fault is found once for a table, not for each of its rows")]

use super::meant::MeantHeading;
use super::{CODE, CellFault};
use project::{HeadingMeant, headings_meant, is_label, written};
use quantities::{Language, seen};
use words::sweeps;

/// Name of a first column without a heading, as spreadsheets and data frames write the numbers of their rows.
const INDEX: &str = "index";

/// Columns of the answer to the best product of each row, in their order.
pub const BEST_COLUMNS: [&str; 7] = ["row", "fit", CODE, "utilisation", "tightest", "error", "fit_if_estimate"];

/// Column of the ratio of a stage that is chosen among several, in an answer.
pub const STAGE_RATIO: &str = "stage_ratio";

/// Columns of a table by their places.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TableColumns {
    /// Places of the keys, of the codes, and of headings that are refused.
    pub keys: Vec<usize>,
    /// Places and names of the columns that are carried.
    pub carried: Vec<(usize, String)>,
}

impl TableColumns {
    /// Separates the columns of a table by their headings. A table without any key has no columns to carry: its headings are
    /// read as keys. Of an earlier answer, which has its columns in their order, only the inputs are read again.
    #[must_use]
    pub fn of(headings: &[&str]) -> Self {
        let mut found = Self::default();
        let is_answer = headings.len() > BEST_COLUMNS.len()
            && headings.iter().zip(BEST_COLUMNS).all(|(heading, own)| heading.trim() == own);
        for (place, heading) in headings.iter().enumerate() {
            let name = heading.trim();
            if is_answer && (place < BEST_COLUMNS.len() || name == STAGE_RATIO) {
                continue;
            }
            if name.is_empty() && place == 0 {
                found.carried.push((place, INDEX.to_owned()));
            } else if name != CODE && is_label(name) {
                found.carried.push((place, name.to_owned()));
            } else {
                found.keys.push(place);
            }
        }
        if found.keys.is_empty() {
            return Self { keys: (0..headings.len()).collect(), carried: Vec::new() };
        }
        found
    }

    /// Returns the headings of the keys as a project means them, from its text: a word that stands for the key of every move has a
    /// column for each of them.
    pub fn as_meant(&mut self, headings: &[&str], text: &str, axis: Option<&str>) -> Vec<MeantHeading> {
        let all = written(text).unwrap_or_default();
        let value = |path: &str| all.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref());
        let is_there = |place: &usize| all.iter().any(|each| each.path == format!("axis[{place}]"));
        let named =
            (1..).take_while(is_there).find(|place| axis.is_some() && value(&format!("axis[{place}].name")) == axis);
        let prefix = named.map(|place| format!("axis[{place}].")).unwrap_or_default();
        let keys = self.keys.iter().filter_map(|place| Some((*place, *headings.get(*place)?)));
        let meant = keys.flat_map(|(place, heading)| {
            let with_written = move |meant: HeadingMeant| {
                let HeadingMeant { heading: meant, is_opposite } = meant;
                (place, MeantHeading { written: heading.to_owned(), meant, is_opposite })
            };
            headings_meant(&all, &prefix, heading).into_iter().map(with_written)
        });
        let (places, meant) = meant.unzip();
        self.keys = places;
        meant
    }

    /// Returns the faults of carried columns whose names the answer has already.
    pub fn faults<'f>(&'f self, answers: &'f [&str], language: Language) -> impl Iterator<Item = CellFault> + 'f {
        let names = move |at: usize| self.carried.iter().take(at).map(|(_, name)| name.as_str());
        self.carried.iter().enumerate().filter_map(move |(at, (_, name))| {
            let is_taken = answers.contains(&name.as_str()) || names(at).any(|other| other == name);
            is_taken.then(|| CellFault {
                heading: seen(name).into_owned(),
                row: None,
                id: "column_twice",
                message: sweeps::column_of_the_answer(&seen(name), language),
                hint: Some(sweeps::rename_it(language).to_owned()),
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_carried_and_what_may_be_a_key_is_not() {
        let labels = [
            "id",
            "ID",
            "joint",
            "machine",
            "station",
            "part_no",
            "trial",
            "case",
            "robot",
            "Unnamed: 0",
            "customer",
            "serial",
            "Maschine Nr.",
            "Achse",
            "variant",
            "line",
            "uuid",
            "__index_level_0__",
            "serial_s",
            "joint_deg",
            "part m",
        ];
        for label in labels {
            let found = TableColumns::of(&["load.inertia [kg m^2]", label]);
            assert_eq!((found.keys, found.carried), (vec![0], vec![(1, label.to_owned())]), "{label}");
        }
        for meant in [
            "inertia",
            "Inertia",
            "inertja",
            "load inertia",
            "load_inertia",
            "payload",
            "payload [kg]",
            "ambient",
            "friction",
            "motion[1].tim [s]",
            "load.x",
            "code",
            "duration",
            "stroke",
            "overhang",
            "time_s",
            "payload_kg",
            "mass_kg",
            "supply_V",
            "ambient_degC",
            "inertia_kg_m2",
            "motion[1].time_s",
        ] {
            let found = TableColumns::of(&["load.mass [kg]", meant]);
            assert_eq!(found.keys, [0, 1], "{meant}");
        }
        let found = TableColumns::of(&["", "load.inertia [kg m^2]"]);
        assert_eq!(found.carried, [(0, "index".to_owned())]);
        assert_eq!(TableColumns::of(&["id", "joint"]).keys, [0, 1]);
    }

    #[test]
    fn a_name_of_the_answer_is_refused() {
        let found = TableColumns::of(&["load.inertia [kg m^2]", "row", "id", "id "]);
        let faults: Vec<String> = found.faults(&["row", "fit"], Language::En).map(|fault| fault.heading).collect();
        assert_eq!(faults, ["row", "id"]);
    }

    /// An answer with its inputs is a table of these inputs; one without any has no key, and its columns are refused.
    #[test]
    fn of_an_answer_the_inputs_are_read_again() {
        let with =
            |more: &[&'static str]| -> Vec<&'static str> { BEST_COLUMNS.into_iter().chain(more.to_vec()).collect() };
        let found = TableColumns::of(&with(&["load.inertia [kg m^2]", "station", STAGE_RATIO]));
        assert_eq!((found.keys, found.carried), (vec![7], vec![(8, "station".to_owned())]));
        let bare = TableColumns::of(&with(&[]));
        assert_eq!(bare.keys.len() + bare.carried.len(), BEST_COLUMNS.len());
        assert!(!bare.keys.is_empty() && bare.faults(&BEST_COLUMNS, Language::En).count() > 0, "{bare:?}");
        // In another order the columns are those of the user.
        let mut others = with(&["load.inertia [kg m^2]"]);
        others.swap(0, 1);
        assert_eq!(TableColumns::of(&others).carried.len(), BEST_COLUMNS.len() - 1);
    }
}
