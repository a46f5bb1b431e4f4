use super::*;
use axis::NoFiles;
use project::Counted;
use recording::Commas;

pub(super) const MOVE: &str = "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\n\
    law = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"0.5 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";

fn sweep(text: &str, headings: &[&str]) -> Result<Sweep, TableFaults> {
    Sweep::new(("axis.toml", text), Box::new(NoFiles), headings, Options::default()).map_err(|why| match why {
        Unanswered::Table { faults, .. } => faults,
        other => panic!("{other:?}"),
    })
}

fn numbers(cells: &[f64]) -> Cells<'static> {
    Cells::Numbers(cells.iter().copied().map(Some).collect())
}

fn best(answer: &Answer) -> Best {
    match answer {
        Ok(Judged::Best(best)) => best.clone(),
        other => panic!("{other:?}"),
    }
}

/// Returns the answer of `size` for a project.
fn sized(text: &str) -> Result<Best, String> {
    let project = crate::read(text).map_err(|faults| {
        let each = words::worded(&faults, Language::default()).into_iter().map(|fault| fault.message);
        each.collect::<Vec<_>>().join("; ")
    })?;
    let sizing = crate::size(&project);
    let finite = |utilisation: f64| utilisation.is_finite().then_some(utilisation);
    let [fit, fit_if_estimate] = sizing.counts().map(|count| u32::try_from(count).unwrap());
    let governing = |candidate: &crate::Candidate<'_>| candidate.governing().map(|check| check.id);
    // Codes that a requirement excludes are judged in no row.
    let is_permitted = |candidate: &&crate::Candidate<'_>| candidate.objections.is_empty();
    let stage_ratio = (!project.ratios.is_empty()).then(|| project.axis.mechanism.stage_ratio());
    let found = match (sizing.answer(), sizing.nearest_miss().filter(is_permitted)) {
        (Some(answer), _) => Best {
            fit,
            fit_if_estimate,
            code: Some(answer.id.clone()),
            utilisation: finite(answer.standing.utilisation),
            tightest: governing(answer),
            stage_ratio,
        },
        (None, Some(miss)) => Best {
            fit,
            fit_if_estimate,
            code: None,
            utilisation: finite(miss.standing.utilisation),
            tightest: governing(miss),
            stage_ratio,
        },
        (None, None) => Best { fit, fit_if_estimate, code: None, utilisation: None, tightest: None, stage_ratio },
    };
    Ok(found)
}

#[test]
fn a_row_is_answered_as_the_project_with_its_values() {
    let sweep = sweep(MOVE, &["load.inertia [kg m^2]", "motion[1].time [ms]"]).unwrap();
    let found = sweep
        .judge(&[numbers(&[1.0, 0.1, 400.0, -1.0]), numbers(&[500.0, 200.0, 100.0, 100.0])], &Progress::endless())
        .unwrap();
    for (answer, (inertia, time)) in found.iter().zip([("1", "500"), ("0.1", "200"), ("400", "100")]) {
        let text = MOVE.replace("1 kg m^2", &format!("{inertia} kg m^2")).replace("0.5 s", &format!("{time} ms"));
        assert_eq!(best(answer), sized(&text).unwrap());
    }
    assert_eq!(found[3], Err("`load.inertia` must not be negative: \"-1 kg m^2\"".to_owned()));
    assert!(best(&found[0]).fits() && best(&found[2]).code.is_none());
}

/// A row whose place of installation excludes every code names the check that excludes, and its utilisation if it has
/// one; with a load that is too heavy besides, too.
#[test]
fn a_row_names_the_check_of_the_place_that_excludes_every_code() {
    let places = [
        ("protection = \"IP67\"\n", CheckId::Protection),
        ("ambient = \"70 degC\"\n", CheckId::Ambient),
        ("humidity_min = 0.4\nhumidity_max = 0.99\n", CheckId::Humidity),
        ("humidity_min = 0.05\nhumidity_max = 0.7\n", CheckId::HumidityMin),
        ("vibration = \"90 m/s^2\"\n", CheckId::Vibration),
        ("shock = \"900 m/s^2\"\n", CheckId::Shock),
    ];
    for (place, check) in places {
        let text = format!("{MOVE}[requirements]\n{place}");
        let sweep = sweep(&text, &["load.inertia [kg m^2]"]).unwrap();
        let found = sweep.judge(&[numbers(&[1.0, 400.0])], &Progress::endless()).unwrap();
        for (answer, inertia) in found.iter().zip(["1", "400"]) {
            let found = best(answer);
            assert_eq!(found, sized(&text.replace("1 kg m^2", &format!("{inertia} kg m^2"))).unwrap(), "{place}");
            // A load that exceeds another limit further is governed by that one, as in every answer about the code.
            let is_light = inertia == "1";
            assert!(!found.fits() && (found.tightest == Some(check) || !is_light), "{place}: {found:?}");
        }
    }
}

/// A key that can have no meaning beside those of the project is refused once, by its heading, and not in every row; a value that
/// is impossible stays a matter of its row, and where words are swept too, so does the key.
#[test]
fn a_key_without_a_meaning_is_refused_once() {
    let table = include_str!("../../../../examples/turntable.toml");
    let refused = |headings: &[&str], cells: &[Cells<'_>]| {
        let mut faults = TableFaults::default();
        sweep(table, headings).unwrap().check(cells, 0, &mut faults);
        faults.listed.iter().map(|fault| (fault.heading.clone(), fault.row, fault.id)).collect::<Vec<_>>()
    };
    let load = ("load.inertia [kg m^2]".to_owned(), None, "too_many_mechanisms");
    assert_eq!(refused(&["load.inertia [kg m^2]"], &[numbers(&[1.0, 2.0])]), std::slice::from_ref(&load));
    let two = ["requirements.ambient [°C]", "load.inertia [kg m^2]"];
    assert_eq!(refused(&two, &[numbers(&[20.0, 30.0]), numbers(&[1.0, 2.0])]), [load]);
    assert_eq!(refused(&["requirements.ambient [°C]"], &[numbers(&[20.0, 30.0])]), []);
}

/// A row with a seeded value for every quantity and number of a project, near the stated one, gives the result of
/// `size` for the text with these values. Every example is used, and thus every mechanism.
#[test]
fn every_example_with_seeded_values_is_answered_as_by_size() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let mut state = 11_u64;
    let mut share = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (mut judged, mut fitting, mut failing, mut impossible) = (0, 0, 0, 0);
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    for path in files.iter().filter(|path| path.extension().is_some_and(|end| end == "toml")) {
        let text = std::fs::read_to_string(path).unwrap();
        let Ok(project) = crate::read(&text) else { continue };
        if project.is_of_several() {
            continue;
        }
        let inputs: Vec<project::Input> = project::inputs(&text)
            .into_iter()
            .filter(|input| input.amount.is_some_and(|(value, _)| value != 0.0) && !input.path.starts_with("actuator"))
            .filter(|input| {
                !input.path.starts_with("twin")
                    && Heading::read(&heading(input), Counted::FromOne, None).is_ok_and(|heading| heading.is_number())
            })
            .collect();
        let headings: Vec<String> = inputs.iter().map(heading).collect();
        let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
        let sweep = sweep(&text, &headings).unwrap_or_else(|faults| panic!("{}: {faults:?}", path.display()));
        for row in 0..ROWS {
            // From nearly unchanged to distant values.
            let spread = [0.02, 0.2, 1.0, 2.5][row % 4];
            let values: Vec<f64> =
                inputs.iter().map(|input| input.amount.unwrap().0 * (spread * (2.0 * share() - 1.0)).exp()).collect();
            let cells: Vec<Cells<'_>> = values.iter().map(|value| numbers(&[*value])).collect();
            let found = sweep.judge(&cells, &Progress::endless()).unwrap().remove(0);
            let mut with_them = text.clone();
            for (input, value) in inputs.iter().zip(&values) {
                let written = Heading::read(&heading(input), Counted::FromOne, None).unwrap().written(*value);
                with_them = edit(&with_them, &input.path, Edit::Value(&written)).unwrap();
            }
            let context = format!("{} {headings:?} {values:?}", path.display());
            judged += 1;
            match sized(&with_them) {
                Ok(expected) => {
                    assert_eq!(best(&found), expected, "{context}");
                    *(if expected.fits() { &mut fitting } else { &mut failing }) += 1;
                }
                Err(why) => {
                    impossible += 1;
                    assert!(found.is_err(), "{context}: {why}");
                }
            }
        }
    }
    assert!(
        fitting > judged / 5 && failing > judged / 20 && impossible > 0,
        "{judged} {fitting} {failing} {impossible}"
    );
}

/// A table is checked up to a number of faults, which its last sentence states; cells behind them are not looked at.
#[test]
fn a_table_that_is_wrong_throughout_is_not_checked_to_its_end() {
    let sweep = sweep(MOVE, &["load.inertia [kg m^2]", "motion[1].time [ms]"]).unwrap();
    let texts = |count: usize, text: &'static str| Cells::Texts(vec![Some(text.into()); count]);
    let last = |faults: &TableFaults| {
        crate::answer::table_faults("t.csv", faults, Language::default()).errors.last().unwrap().message.clone()
    };
    let mut faults = TableFaults::default();
    sweep.check(&[texts(5_000, "x"), texts(5_000, "1")], 0, &mut faults);
    assert_eq!((faults.listed.len(), faults.more, faults.is_enough()), (50, 4_950, false));
    assert_eq!(last(&faults), "and 4950 more faults");
    for first_row in [5_000, 45_000] {
        sweep.check(&[texts(40_000, "1"), texts(40_000, "")], first_row, &mut faults);
        assert_eq!((faults.more, faults.is_enough()), (10_000, true));
    }
    assert_eq!(last(&faults), "and 10000 more faults; the rest of the table was not checked");
}

/// Rows of each example.
const ROWS: usize = 16;

fn heading(input: &project::Input) -> String {
    let (_, unit) = input.amount.unwrap();
    if unit.ascii.is_empty() || unit.ascii == "1" {
        input.path.clone()
    } else {
        format!("{} [{}]", input.path, unit.ascii)
    }
}

/// Numbers in which a point may separate thousands are refused, unless another cell shows that it is decimal.
#[test]
fn thousands_in_a_table_are_refused() {
    let found = |rows: &[[&'static str; 2]], commas: Commas| {
        let options = Options { commas, ..Options::default() };
        let headings = ["load.inertia [kg cm^2]", "motion[1].time [ms]"];
        let mut head = Head::of(("axis.toml", MOVE), &NoFiles, &headings.map(MeantHeading::from), options);
        let column = |place: usize| Cells::Texts(rows.iter().map(|row| Some(row[place].into())).collect());
        head.check(&[column(0), column(1)], 0);
        match head.ready("t.csv", Box::new(NoFiles)) {
            Ok(_) => Vec::new(),
            Err(Unanswered::Table { faults, .. }) => faults.listed,
            Err(other) => panic!("{other:?}"),
        }
    };
    for rows in
        [[["5.000", "500"], ["10.000", "500"]], [["998", "500"], ["1.002", "500"]], [["998", "500"], ["1,002", "500"]]]
    {
        let faults = found(&rows, Commas::Any);
        let row = u64::from(rows[0][0] == "998");
        assert!(
            matches!(faults.as_slice(), [fault] if fault.id == "thousands_possible" && fault.row == Some(row)),
            "{faults:?}"
        );
    }
    for rows in [
        [["5.000", "500.5"], ["10.000", "500"]],
        [["0.998", "500"], ["1.002", "500"]],
        [["1,125", "500"], ["1,375", "500"]],
    ] {
        assert_eq!(found(&rows, Commas::Any), []);
    }
    // Where commas separate cells a point is decimal, and a quoted comma may be either.
    assert_eq!(found(&[["998", "500"], ["1.002", "500"]], Commas::None), []);
    for (rows, commas) in
        [([["2,000", "500"], ["3,000", "500"]], Commas::Quoted), ([["2,000", "500"], ["2,500", "500"]], Commas::None)]
    {
        let faults = found(&rows, commas);
        assert!(faults.iter().all(|fault| fault.id == "thousands_possible") && !faults.is_empty(), "{faults:?}");
    }
    assert_eq!(found(&[["2,000", "500"], ["0,5", "500"]], Commas::Quoted), []);
}
