//! Products of catalogue files: read from TOML and CSV, judged beside the series in the program.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::written_product::{Stated, toml, written};
use axis::{AxisProject, Files};
use configurator::ProductId;
use quantities::{Language, Measure};
use questions::{Fit, Progress, Rejected, check, check_own, embedded_catalogue, read_all, size};
use std::collections::BTreeMap;
use std::io::{ErrorKind, Read};

const HEAD: &str = "format = 1\n[load]\ninertia = \"1.3 kg m^2\"\nfriction_torque = \"5 N m\"\n\
    [[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n\
    [bearing]\nradial_force = \"900 N\"\nradial_distance = \"80 mm\"\n[requirements]\nambient = \"30 degC\"\n";

/// Files in memory.
pub(crate) struct Memory(pub(crate) BTreeMap<&'static str, String>);

impl Files for Memory {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        let text = self.0.get(name).ok_or(ErrorKind::NotFound)?.clone();
        Ok(Box::new(std::io::Cursor::new(text.into_bytes())))
    }
}

fn project(use_of_files: &str, files: &[(&'static str, String)]) -> Result<AxisProject, Vec<axis::AxisDiagnostic>> {
    let text = format!("{HEAD}[catalogue]\n{use_of_files}");
    let mut read = read_all(&text, &Memory(files.iter().cloned().collect()))?;
    Ok(read.remove(0))
}

fn messages(found: Result<AxisProject, Vec<axis::AxisDiagnostic>>) -> Vec<String> {
    let faults = found.err().unwrap_or_default();
    words::worded(&faults, Language::En).into_iter().map(|fault| fault.message).collect()
}

/// Returns every product of the catalogue as a row of a file, with the mass.
fn products() -> Vec<(String, Vec<Stated>)> {
    let all = embedded_catalogue().products(false).iter();
    let one = |(index, product): (usize, &configurator::Product)| {
        let mut stated = written(&product.parameters);
        let mass = product.parameters.mass.known().map(|mass| format!("{:?}", mass.value.si()));
        stated.push(("mass", mass, "kg"));
        (format!("P{index}"), stated)
    };
    all.enumerate().map(one).collect()
}

fn as_toml(products: &[(String, Vec<Stated>)]) -> String {
    let head = "[catalogue]\nmaker = \"Example\"\nseries = \"P\"\nsource = \"invented\"\n".to_owned();
    let one = |(id, stated): &(String, Vec<Stated>)| format!("[[actuator]]\nid = \"{id}\"\n{}", toml(stated));
    head + &products.iter().map(one).collect::<String>()
}

fn as_csv(products: &[(String, Vec<Stated>)], (sign, decimal): (char, char)) -> String {
    let heading = |(key, _, unit): &Stated| if unit.is_empty() { (*key).to_owned() } else { format!("{key} [{unit}]") };
    let sign = sign.to_string();
    let headings: Vec<String> = products[0].1.iter().map(heading).collect();
    let mut text = format!("maker{sign}id{sign}{}\n", headings.join(&sign));
    for (id, stated) in products {
        let cells: Vec<String> = stated
            .iter()
            .map(|(_, value, _)| value.clone().unwrap_or_default())
            .map(|cell| if cell.parse::<f64>().is_ok() { cell.replace('.', &decimal.to_string()) } else { cell })
            .collect();
        text.push_str(&format!("Example{sign}{id}{sign}{}\n", cells.join(&sign)));
    }
    text
}

/// A product of a file is judged as the same data in the project itself, in TOML and in CSV of each dialect; it is named with its
/// maker, and its values name file, line and key.
#[test]
fn a_product_of_a_file_is_judged_as_the_same_data_in_the_project() {
    let products = products();
    let files = [
        ("all.toml", as_toml(&products)),
        ("all.csv", as_csv(&products, (',', '.'))),
        ("german.csv", as_csv(&products, (';', ','))),
        ("tabs.csv", as_csv(&products, ('\t', '.'))),
    ];
    let own: Vec<Vec<Numbers>> = products
        .iter()
        .map(|(_, stated)| {
            let text = format!("{HEAD}[actuator]\nname = \"x\"\n{}", toml(stated));
            numbers(&check_own(&questions::read(&text).unwrap()).unwrap())
        })
        .collect();
    for (name, _) in &files {
        let project = project(&format!("files = [\"{name}\"]\ncha = false\n"), &files).unwrap_or_else(|faults| {
            panic!("{name}: {:?}", words::worded(&faults, Language::En).iter().take(5).collect::<Vec<_>>())
        });
        let sizing = size(&project);
        assert_eq!(sizing.candidates.len(), products.len(), "{name}");
        for ((id, _), expected) in products.iter().zip(&own) {
            let found = check(&project, &ProductId::named(id)).unwrap();
            assert_eq!(&numbers(&found), expected, "{name} {id}");
            assert_eq!(found.product.manufacturer.as_deref(), Some("Example"), "{name} {id}");
        }
        let torque = sizing.candidates[0].parameters.torque_max.known().unwrap();
        let source = words::source_text(&torque.source, Language::En);
        assert!(source.starts_with(&format!("{name}:")) && source.contains("torque_max"), "{source}");
    }
}

/// A check with its verdict, its value and its limit.
type Numbers = (String, Option<f64>, Option<f64>);

fn numbers(candidate: &questions::Candidate<'_>) -> Vec<Numbers> {
    let of = |check: &sizing::Check| {
        (
            format!("{:?} {:?}", check.id, check.verdict),
            check.value.map(|value| value.si),
            check.limit.map(|limit| limit.si),
        )
    };
    candidate.judgement.checks.iter().map(of).collect()
}

/// The series in the program competes with the products of files; the lighter one is preferred, and the answer of the series
/// alone does not change.
#[test]
fn products_of_files_compete_with_the_series_by_mass() {
    let products = products();
    let files = [("all.toml", as_toml(&products))];
    let alone = questions::read(HEAD).unwrap();
    let alone = size(&alone);
    let project = project("files = [\"all.toml\"]\n", &files).unwrap();
    let both = size(&project);
    assert_eq!(both.candidates.len(), 2 * products.len());
    assert!(both.by_mass && !alone.by_mass);
    let mass = |candidate: &questions::Candidate<'_>| candidate.parameters.mass.known().unwrap().value.si();
    let certain: Vec<_> = both.fitting().iter().filter(|candidate| candidate.fit() == Fit::Fits).collect();
    for pair in certain.windows(2).filter(|pair| pair[0].standing.holds == pair[1].standing.holds) {
        let [first, second] = [pair[0], pair[1]].map(|candidate| candidate.product.states_its_limits());
        // Those of the file state no continuous curve: they stand behind the others.
        assert!(first || !second);
        assert!(first != second || mass(pair[0]) <= mass(pair[1]) + 1e-3);
    }
    let of_the_series = |sizing: &questions::Sizing<'_>| {
        let codes = sizing.fitting().iter().filter(|candidate| candidate.id.order_code().is_some());
        let mut codes: Vec<String> = codes.map(|candidate| candidate.id.to_string()).collect();
        codes.sort();
        codes
    };
    assert_eq!(of_the_series(&both), of_the_series(&alone));
}

#[test]
fn faults_of_a_file_name_file_line_and_column() {
    let csv = "id;torque_max [N m];ratio;speed_max;colour;mass [m];torque_max [N m]\nA;12;50;30;red;3;1\nB;x;0,5;30;;;\nA;-1;50;;;;\n;1;2;;;;\nC;1\n";
    let toml = "[[actuator]]\nid = \"D\"\ntorque_max = 12\n[[actuator]]\nid = \"D\"\nratoi = 3\n[[actuator]]\nid = \"CHA-20A-100-H-C1024\"\n";
    let files = [("a.csv", csv.to_owned()), ("b.toml", toml.to_owned()), ("empty.toml", String::new())];
    let found =
        messages(project("files = [\"a.csv\", \"b.toml\", \"empty.toml\", \"none.csv\", \"../up.toml\"]\n", &files));
    for expected in [
        "a.csv, line 1, column 27: ",
        "a.csv, line 1, column 37: unknown key `colour`",
        "a.csv, line 1, column 44: ",
        "a.csv, line 1, column 53: ",
        "a.csv, line 3, column 3: ",
        "a.csv, line 3, column 5: ",
        "a.csv, line 4, column 1: A is named in line 2 already",
        "a.csv, line 4, column 3: ",
        "a.csv, line 5, column 1: `actuator[4].id` is missing",
        "a.csv, line 6, column 1: ",
        "b.toml, line 3, column 14: ",
        "b.toml, line 5, column 6: D is named in line 2 already",
        "b.toml, line 6, column 1: unknown key `actuator[2].ratoi`",
        "b.toml, line 8, column 6: CHA-20A-100-H-C1024 is an ordering code",
        "empty.toml, line 1, column 1: the catalogue file has no products",
    ] {
        assert!(found.iter().any(|message| message.starts_with(expected)), "{expected}\n{}", found.join("\n"));
    }
    assert_eq!(found.len(), 17, "{}", found.join("\n"));
}

#[test]
fn nothing_offered_is_a_fault() {
    let found = messages(project("cha = false\n", &[]));
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(messages(project("cha = true\n", &[])).is_empty());
}

/// A cell of a file that changes a product changes the fingerprint, and no project without files has another one.
#[test]
fn the_fingerprint_covers_the_products_of_files() {
    let rows = |speed: &str| format!("id;ratio;torque_max [N m];speed_max [1/min]\nA;100;28;{speed}\nB;50;20;80\n");
    let of = |head: &str, files: &[(&'static str, String)]| {
        questions::catalogue_fingerprint(&**project(head, files).unwrap().catalogue())
    };
    let own = questions::catalogue_fingerprint(&**questions::read(HEAD).unwrap().catalogue());
    assert_eq!(own, questions::catalogue_fingerprint(&**embedded_catalogue()));
    let mut found = vec![own];
    for head in ["files = [\"a.csv\"]\ncha = false\n", "files = [\"a.csv\"]\n"] {
        for speed in ["60", "61"] {
            found.push(of(head, &[("a.csv", rows(speed))]));
        }
    }
    // The products are the same with and without the series, which the project states.
    assert_eq!((&found[1], &found[2]), (&found[3], &found[4]));
    found.truncate(3);
    found.sort();
    found.dedup();
    assert_eq!(found.len(), 3, "{found:?}");
}

/// A product of which little is stated: no figure stands for a check that could not be made.
#[test]
fn what_could_not_be_checked_is_no_reserve() {
    let file =
        "maker;id;source;ratio;speed_max [1/min];price\nM GmbH;A;list 4;100;60;on request\nM GmbH;B;list 5;100;;\n";
    let files = [("a.csv", file.to_owned())];
    let project = project("files = [\"a.csv\"]\ncha = false\n", &files).unwrap();
    let sizing = size(&project);
    let of = |id: &str| sizing.candidates.iter().find(|each| each.id.to_string() == id).unwrap();
    let (fast, unknown) = (of("A"), of("B"));
    assert!(fast.utilisation().is_some() && unknown.utilisation().is_none());
    for language in Language::ALL {
        let plate = words::assumption_text(axis::Assumption::CoolingPlate, language);
        let reserve = questions::reserve_of(&project, fast);
        let lines = questions::texts::reserve_lines(&reserve, fast, language);
        assert!(lines.iter().any(|(head, _)| *head == words::terms::not_checked(language)), "{lines:?}");
        let dossier = questions::answer::dossier(
            &project,
            &sizing,
            fast,
            (&reserve, None, &questions::Proposals::default()),
            (HEAD, 0, "antrieb"),
            language,
        );
        assert!(dossier.judgement.reserve.not_checked.is_some_and(|found| found.checks.len() > 3));
        assert!(dossier.judgement.assumptions.iter().all(|each| each.why != plate));
        let cited: Vec<&str> = dossier.documents.iter().map(|each| each.title.as_str()).collect();
        assert!(cited.first() == Some(&"list 4"), "{cited:?}");
        let item = &dossier.bill_of_material[0].text;
        assert!(item.ends_with("; M GmbH"), "{item}");
    }
}

/// A price with two readings is a fault of its cell; a text without an amount is none.
#[test]
fn a_price_with_two_readings_is_a_fault() {
    for (price, is_fault) in
        [("1.180 EUR", true), ("1,180 EUR", true), ("1180", true), ("1180 EUR", false), ("on request", false)]
    {
        let file = format!("id;ratio;torque_max [N m];price\nA;100;28;{price}\n");
        let found = messages(project("files = [\"a.csv\"]\n", &[("a.csv", file)]));
        assert_eq!(found.len(), usize::from(is_fault), "{price}: {found:?}");
    }
}

/// However many actuators are listed, and however far the rejected ones are judged: order, numbers and the named actuator are the same,
/// also for products without some of their data or without any.
#[test]
fn the_length_of_the_list_changes_no_number() {
    let mut state = 7_u64;
    let mut is_kept = |of: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % 8 < of
    };
    // From none of the data to all of them.
    let thinned: Vec<(String, Vec<Stated>)> = products()
        .into_iter()
        .enumerate()
        .map(|(index, (id, stated))| {
            let share = index as u64 % 9;
            let kept = stated.into_iter().map(|(key, value, unit)| (key, value.filter(|_| is_kept(share)), unit));
            (id, kept.collect())
        })
        .collect();
    let files = [("thin.toml", as_toml(&thinned))];
    let mut unevaluated = 0;
    for with_series in ["cha = false\n", ""] {
        let project = project(&format!("files = [\"thin.toml\"]\n{with_series}"), &files).unwrap();
        let full = size(&project);
        unevaluated += full.not_evaluated();
        for top in [0, 1, 3, 10] {
            for rejected in [Rejected::None, Rejected::Nearest, Rejected::Reasons, Rejected::All] {
                let found = questions::list::size::sized(&project, top, rejected, &Progress::endless()).unwrap();
                let case = format!("{with_series} {top} {rejected:?}");
                let said = |sizing: &questions::Sizing<'_>| {
                    (sizing.counts(), sizing.not_evaluated(), questions::texts::fitting_text(sizing, Language::En))
                };
                assert_eq!(said(&found), said(&full), "{case}");
                let fitting = |sizing: &questions::Sizing<'_>| -> Vec<String> {
                    let text = |each: &questions::Candidate<'_>| questions::texts::verdict_of(each, Language::En);
                    sizing.fitting().iter().map(|each| format!("{} {}", each.id, text(each))).collect()
                };
                assert_eq!(fitting(&found), fitting(&full), "{case}");
                if rejected != Rejected::None {
                    let named = |sizing: &questions::Sizing<'_>| sizing.named().map(|each| each.id.clone());
                    assert_eq!(named(&found), named(&full), "{case}");
                }
            }
        }
    }
    assert!(unevaluated > 10, "{unevaluated}");
}
