//! Every check of every example is explained, and every formula gives the number beside it.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail")]

use crate::catalogue_actuators;
use answers::Node;
use axis::{AxisProject, Files};
use provenance::{CellRef, Source};
use quantities::Language;
use questions::list::explain::derivation;
use questions::{Check, explain};
use sizing::derivation::{Finding, How, Part, evaluate};
use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;
use std::path::PathBuf;
use testkit::projects::{Draws, LAWS, mechanisms, moved};

fn examples() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

struct ProjectFiles;

impl Files for ProjectFiles {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(std::fs::File::open(examples().join(name))?))
    }
}

/// Every example, and one with all requirements.
fn projects() -> Vec<AxisProject> {
    let mut names: Vec<PathBuf> = std::fs::read_dir(examples()).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.sort();
    let mut found = Vec::new();
    for path in names.iter().filter(|path| path.extension().is_some_and(|kind| kind == "toml")) {
        let text = std::fs::read_to_string(path).unwrap();
        found.extend(questions::read_all(&text, &ProjectFiles).unwrap());
    }
    let asked = std::fs::read_to_string(examples().join("tilting-arm.toml")).unwrap();
    let (head, _) = asked.split_once("[requirements]").unwrap();
    let everything = format!(
        "{head}[requirements]\nbrake = true\nsupply = \"560 V\"\nambient = \"35 degC\"\nlever_arm = \"500 mm\"\n\
         deviation_max = \"2 mm\"\nabsolute = true\nresolution_max = \"10 arcsec\"\noperation_per_day = \"8 h\"\n\
         battery_life_min = \"5 a\"\ncollision_torque = \"40 N m\"\ncollision_time = \"0.1 s\"\ncollisions = 20\n\
         gear_life_min = \"20000 h\"\nbearing_life_min = \"20000 h\"\ntorsion_max = \"5 arcmin\"\n\
         natural_frequency_min = \"3 Hz\"\ntilt_angle_max = \"1 arcmin\"\nstop_angle_max = \"90 deg\"\n\
         emergency_stops = 20\nholding_safety = 1.5\nregeneration_power_max = \"50 W\"\ndc_link_rise = \"60 V\"\n\
         special_application = \"medical\"\n"
    );
    found.push(questions::read(&everything).unwrap());
    // The brake holds often and over a long life, the link rises above its limit, nothing is carried.
    let often = "format = 1\n[mechanism.arm]\ninertia = \"1 kg m^2\"\nmass = \"10 kg\"\ncentre_distance = \"0.1 m\"\n\
        axis_tilt = \"90 deg\"\nstart_angle = \"0 deg\"\n\
        [[motion]]\nlaw = \"jerk\"\ndistance = \"360 deg\"\nspeed = \"20 1/min\"\nacceleration = \"20 rad/s^2\"\njerk = \"400 rad/s^3\"\n\
        [[motion]]\nlaw = \"dwell\"\ntime = \"50 ms\"\nhold = \"brake\"\n\
        [requirements]\nbrake = true\nsupply = \"560 V\"\ndc_link_rise = \"200 V\"\nservice_life = \"90000 h\"\n\
        collision_torque = \"900 N m\"\n";
    found.push(questions::read(often).unwrap());
    let idle = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n\
        [[motion]]\nlaw = \"constant\"\nspeed = \"10 1/min\"\ntime = \"1 s\"\n";
    found.push(questions::read(idle).unwrap());
    found
}

/// Returns the errors in the workings of a check; differences below `rounding` times 10⁻⁹ are those of sums that cancel.
fn faults(check: &Check, rounding: f64) -> Vec<String> {
    let mut faults = Vec::new();
    let steps = &check.workings;
    for (part, figure) in [(Part::Value, check.value), (Part::Limit, check.limit)] {
        let marked: Vec<f64> = steps.iter().filter(|step| step.part == part).map(|step| step.si).collect();
        match (figure, marked.as_slice()) {
            (None, _) => {}
            (Some(figure), [only]) if (only - figure.si).abs() <= 1e-9 * figure.si.abs() => {}
            (Some(figure), found) => faults.push(format!("{part:?} {} stands as {found:?}", figure.si)),
        }
    }
    for (index, step) in steps.iter().enumerate() {
        if !step.si.is_finite() {
            faults.push(format!("{} is {}", step.symbol, step.si));
        }
        match evaluate(steps, index) {
            None => {}
            Some(Ok(value)) if (value - step.value()).abs() <= 1e-9 * (rounding + step.value().abs()) => {}
            Some(found) => {
                let How::Formula { text, .. } = &step.how else { continue };
                faults.push(format!("{} = {text} gives {found:?}, not {}", step.symbol, step.value()));
            }
        }
    }
    // Everything that is noted leads to value or limit.
    let mut used = vec![false; steps.len()];
    for (index, step) in steps.iter().enumerate().rev() {
        if step.part != Part::Step || used[index] {
            used[index] = true;
            step.operands().iter().for_each(|operand| used[*operand] = true);
        }
    }
    for (step, used) in steps.iter().zip(used) {
        if !used {
            faults.push(format!("{} leads nowhere", step.symbol));
        }
    }
    faults
}

#[test]
fn every_check_is_explained_and_every_formula_gives_its_number() {
    let mut found: BTreeMap<&str, String> = BTreeMap::new();
    let mut checks = 0;
    for project in projects() {
        for (code, _) in catalogue_actuators().step_by(5) {
            let Ok(candidate) = explain(&project, code) else { continue };
            for check in &candidate.judgement.checks {
                checks += 1;
                let mut faults = faults(check, 1e-6);
                faults.extend(sentences(check));
                if !faults.is_empty() {
                    let place = format!("{code}, {}: {}", project.name, faults.join("; "));
                    found.entry(check.id.id()).or_insert(place);
                }
            }
        }
    }
    assert!(checks > 10_000, "{checks}");
    assert!(found.is_empty(), "{found:#?}");
}

/// Returns the steps of a derivation.
fn steps<'n>(node: &'n Node, all: &mut Vec<&'n Node>) {
    all.push(node);
    node.operands.iter().for_each(|operand| steps(operand, all));
}

/// Values of a derivation that a sentence describes instead of a law, each with the reason.
const SENTENCES: [(&str, &[Finding]); 9] = [
    (
        "the state of the motion at an instant, or the position at which the path is searched, is where a law begins",
        &[
            Finding::AccelerationAt,
            Finding::SpeedAt,
            Finding::AngularVelocityAt,
            Finding::DirectionAt,
            Finding::PositionAt,
            Finding::RecordedTorqueAt,
            Finding::PositionOfLargestHolding,
            Finding::PositionOfLargestInertia,
            Finding::PositionOfLeastInertia,
            Finding::SpeedNearResonance,
        ],
    ),
    (
        "the largest of loads that the file states for each segment is a value of the file",
        &[
            Finding::SegmentOfLargestMoment,
            Finding::EverySegmentInMotion,
            Finding::LargestOverSegments,
            Finding::LargestAtRest,
        ],
    ),
    (
        "a published curve is read at one speed",
        &[
            Finding::ContinuousCurve,
            Finding::ShortTimeCurve,
            Finding::CurrentOfCurve,
            Finding::CurvesOverModel,
            Finding::OverloadPermitted,
        ],
    ),
    ("the edge of an estimated band is a constant of the model", &[Finding::EdgeOfBand, Finding::LowerEdgeOfBand]),
    (
        "the temperature of the gear is the solution of the heat balance, in which it occurs on both sides",
        &[
            Finding::GearAsHousing,
            Finding::GearCold,
            Finding::GearSettled,
            Finding::StateCold,
            Finding::StateSettled,
            Finding::StateWarmest,
            Finding::LawOfFriction,
        ],
    ),
    ("the largest current within a voltage is the root of the voltage equation", &[Finding::CurrentWithinVoltage]),
    (
        "the response of a lag to the whole cycle has no closed form",
        &[Finding::WindingRise, Finding::OverloadLag, Finding::TimeAboveContinuous],
    ),
    (
        "a value that is zero by its meaning has no law",
        &[Finding::NotKnown, Finding::TiltBehindStage, Finding::SpeedBeyondCurve],
    ),
    (
        "a count, or a life by the table of the battery",
        &[Finding::Brakings, Finding::BatteryLife, Finding::TensionOfWeight],
    ),
];

/// Symbols of values that a model states by themselves: instants, constants, estimates of the data, and zero without a brake.
const STATED: [&str; 10] = ["t", "t_0", "z_q", "d_min", "N", "N_out", "r", "U_M", "T_N", "T_Br"];

/// Returns the values of a check that are described by a sentence without a reason.
fn sentences(check: &Check) -> Vec<String> {
    let [_, (_, of_the_file), ..] = SENTENCES;
    let is_listed = |what: &Finding| SENTENCES.iter().any(|(_, listed)| listed.contains(what));
    let of = |step: &sizing::derivation::Step| {
        let How::Found { what, .. } = &step.how else { return None };
        let has_source = !of_the_file.contains(what) || matches!(step.source, Source::Project { .. });
        let has_law = what.formula().is_some() || (is_listed(what) && has_source);
        (!has_law).then(|| format!("{} {what:?}", step.symbol))
    };
    // A value of a model that is stated without one is an instant, a time or a limit of the model.
    let is_stated = |step: &&sizing::derivation::Step| {
        step.how == How::Given && matches!(step.source, Source::Model { .. }) && !STATED.contains(&step.symbol)
    };
    let stated =
        check.workings.iter().filter(is_stated).map(|step| format!("{} stated by {}", step.symbol, step.source));
    check.workings.iter().filter_map(of).chain(stated).collect()
}

/// Every mechanism, alone and behind a stage, under every law of motion: each check has its derivation or the stated reason
/// why it has none, and no value is a sentence without a law, except those with a listed reason.
#[test]
fn every_check_of_every_drawn_mechanism_is_derived_or_has_its_reason() {
    let requirements = "brake = true\nsupply = \"560 V\"\nambient = \"35 degC\"\nlever_arm = \"500 mm\"\n\
        deviation_max = \"2 mm\"\ntorsion_max = \"5 arcmin\"\ngear_life_min = \"20000 h\"\nbearing_life_min = \"20000 h\"\n\
        natural_frequency_min = \"3 Hz\"\ntilt_angle_max = \"1 arcmin\"\nstop_angle_max = \"90 deg\"\n";
    let mut draws = Draws::new(5);
    let (mut mechanisms_seen, mut by_law, mut of_flange) = (BTreeSet::new(), 0, 0);
    let mut found: BTreeMap<String, String> = BTreeMap::new();
    for seed in [1, 2] {
        for drawn in mechanisms(&mut Draws::new(seed)) {
            let law = draws.one_of(&LAWS);
            let distance = draws.within(0.1, 1.0) * drawn.stroke_deg.min(720.0);
            let time = draws.within(0.5, 2.0);
            let motion = moved(law, distance, time)
                + "[[motion]]\nlaw = \"dwell\"\ntime = \"0.3 s\"\n"
                + &moved(law, -distance, time);
            let bearing = draws.one_of(&[
                "load_factor = 1.2\n",
                "load_factor = 1.2\nradial_force = \"80 N\"\nradial_distance = \"20 mm\"\n",
            ]);
            let text = |requirements: &str| {
                let text = drawn.project(&motion, if drawn.bearing.is_some() { bearing } else { "" }, requirements);
                text.replace("single_move = true\n", "")
            };
            // Along a line there is no lever arm.
            let read = questions::read(&text(requirements))
                .or_else(|_| questions::read(&text(&requirements.replace("lever_arm = \"500 mm\"\n", ""))));
            let project = read.unwrap_or_else(|why| panic!("{}\n{why:?}", text(requirements)));
            for (code, _) in catalogue_actuators().step_by(97) {
                let Ok(candidate) = explain(&project, code) else { continue };
                for check in &candidate.judgement.checks {
                    let place = || format!("{} of {code} with {}, {law}", check.id.id(), drawn.key);
                    let faults = faults(check, 1e-3);
                    if !faults.is_empty() {
                        found
                            .entry(format!("{}: {}", check.id.id(), drawn.key))
                            .or_insert_with(|| format!("{}: {faults:?}", place()));
                    }
                    let explained = derivation(check, Language::De);
                    let is_explained = check.value.is_none() || explained.value.is_some();
                    let has_reason = check.missing.is_some() || explained.value.is_some() || !check.notes.is_empty();
                    assert!(is_explained && has_reason, "{}: no derivation and no reason", place());
                    let mut all = Vec::new();
                    explained.value.iter().chain(&explained.limit).for_each(|node| steps(node, &mut all));
                    for node in all.into_iter().filter(|node| !node.repeated) {
                        assert!(!node.term.is_empty(), "{}: {} has no word", place(), node.symbol);
                        by_law += i32::from(node.symbol == "T_L");
                        of_flange += i32::from(drawn.bearing.is_some() && matches!(node.symbol.as_str(), "F_r" | "M"));
                        mechanisms_seen.insert(drawn.key);
                    }
                    let sentences = sentences(check);
                    assert!(sentences.is_empty(), "{}: {sentences:?}", place());
                }
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
    assert!(mechanisms_seen.len() >= 12 && by_law > 500 && of_flange > 500, "{mechanisms_seen:?} {by_law} {of_flange}");
}

/// Checks of the largest current show the current with cold and with warm gear, of which the larger one governs, whatever the
/// verdict is; where the warm gear alone decides, its current is that compared with the limit.
#[test]
fn the_current_of_both_states_of_the_gear_is_derived() {
    let (mut failed, mut passed) = (0, 0);
    for project in projects() {
        for (code, _) in catalogue_actuators().step_by(13) {
            let Ok(candidate) = explain(&project, code) else { continue };
            for check in candidate.judgement.checks.iter().filter(|check| check.id.id() == "peak_current") {
                let Some(value) = derivation(check, Language::En).value else { continue };
                let mut all = Vec::new();
                steps(&value, &mut all);
                let of = |symbol: &str| all.iter().find(|node| node.symbol == symbol).map(|node| node.value.0.abs());
                let (Some(cold), Some(warm)) = (of("I_cold"), of("I_warm")) else {
                    panic!("{code}, {}: one state only", project.name)
                };
                assert!((cold.max(warm) - value.value.0).abs() <= 1e-9 * value.value.0, "{code}: {cold} {warm}");
                let constants =
                    all.iter().filter(|node| matches!(node.symbol.as_str(), "k_Tout" | "theta_g" | "K")).count();
                assert!(constants >= 5, "{code}: {constants}");
                let is_failed = check.verdict == sizing::Verdict::Fail;
                (failed, passed) = (failed + i32::from(is_failed), passed + i32::from(!is_failed));
            }
        }
    }
    assert!(failed > 20 && passed > 20, "{failed} {passed}");
}

/// The cold gear exceeds the limit while accelerating, where the warm one is within it; friction helps while braking, so that
/// the warm gear exceeds it there: the verdict is that of the settled cycle, whose current is derived at its own instant.
#[test]
fn a_current_that_the_settled_cycle_exceeds_elsewhere_is_derived_there() {
    let project = |brake: &str| {
        let text = format!(
            "format = 1\n[load]\ninertia = \"10 kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"20 1/min\"\n\
             accelerate = \"0.2 s\"\nrun = \"0.2 s\"\nbrake = \"{brake}\"\npause = \"0.3 s\"\n\
             [requirements]\nambient = \"0 degC\"\n"
        );
        questions::read(&text).unwrap()
    };
    let is_meant = |code: &&order_code::OrderCode| code.to_string().starts_with("CHA-25A-100-H");
    let code = catalogue_actuators().map(|(code, _)| code).find(is_meant).unwrap();
    for (brake, verdict, instants) in [("0.151 s", sizing::Verdict::Fail, 2), ("0.2 s", sizing::Verdict::Advice, 1)] {
        let project = project(brake);
        let candidate = explain(&project, code).unwrap();
        let check = candidate.judgement.checks.iter().find(|check| check.id.id() == "peak_current").unwrap();
        assert_eq!(check.verdict, verdict, "{brake}");
        assert_eq!(faults(check, 1e-6), Vec::<String>::new());
        let of = |symbol: &str| check.workings.iter().rfind(|step| step.symbol == symbol).unwrap().si.abs();
        let limit = check.limit.unwrap().si;
        assert!(of("I_cold") > limit, "{brake}");
        assert_eq!(of("I_warm") > limit, verdict == sizing::Verdict::Fail, "{brake}: {} {limit}", of("I_warm"));
        assert_eq!(check.workings.iter().filter(|step| step.symbol == "t").count(), instants, "{brake}");
    }
}

/// The cells that derivations cite are in the catalogue.
#[test]
fn every_cell_that_is_cited_exists() {
    let exists = |place: &CellRef| {
        let cells = catalogue::table(place.table).map(catalogue::ManualTable::cells).unwrap_or_default();
        cells.iter().any(|cell| {
            let there = &cell.place;
            let rest = (place.condition, place.drive, place.ratio);
            place.document == there.document
                && place.symbol == there.symbol
                && [(rest.0, there.condition), (rest.1, there.drive), (rest.2, there.ratio)]
                    .iter()
                    .all(|(cited, printed)| cited.is_empty() || cited == printed)
        })
    };
    let (mut missing, mut cited) = (Vec::new(), 0);
    for project in projects() {
        for (code, _) in catalogue_actuators().step_by(7) {
            let Ok(candidate) = explain(&project, code) else { continue };
            for check in &candidate.judgement.checks {
                let steps = check.workings.iter().map(|step| (&step.source, step.symbol));
                let both = [&check.value_source, &check.limit_source].into_iter().flatten();
                for (source, symbol) in steps.chain(both.map(|source| (source, check.id.id()))) {
                    let (Source::Cell(place) | Source::Published(place)) = source else { continue };
                    cited += 1;
                    // The ratios are the heads of the columns of table 12.1.
                    let head = place.table == "12.1" && place.symbol == "i";
                    if !head && !exists(place) {
                        missing.push(format!("{} {symbol}: {source}", check.id.id()));
                    }
                }
            }
        }
    }
    missing.sort();
    missing.dedup();
    assert!(cited > 1000, "{cited}");
    assert!(missing.is_empty(), "{missing:#?}");
}

/// Searched and integrated quantities have German texts too, and every symbol that is no printed cell has its word.
#[test]
fn every_step_has_its_words_in_both_languages() {
    let mut english: Vec<String> = Vec::new();
    let mut wordless: Vec<String> = Vec::new();
    let mut raw: Vec<String> = Vec::new();
    for project in projects() {
        for (code, _) in catalogue_actuators().step_by(17) {
            let Ok(candidate) = explain(&project, code) else { continue };
            for check in &candidate.judgement.checks {
                let explained = derivation(check, Language::De);
                for root in [&explained.value, &explained.limit].into_iter().flatten() {
                    look(root, &mut english, &mut wordless);
                    look_for_raw_names(root, &mut raw);
                }
            }
        }
    }
    assert!(english.is_empty(), "still English in German: {english:#?}");
    assert!(wordless.is_empty(), "symbols without a word: {wordless:?}");
    assert!(raw.is_empty(), "names of figures instead of symbols: {raw:?}");
}

/// One symbol with two meanings has that of its place.
#[test]
fn a_symbol_means_what_it_is_where_it_stands() {
    let mut terms: BTreeMap<(String, &str), Vec<(String, String)>> = BTreeMap::new();
    for project in projects() {
        for (code, _) in catalogue_actuators().step_by(29) {
            let Ok(candidate) = explain(&project, code) else { continue };
            for check in &candidate.judgement.checks {
                let explained = derivation(check, Language::En);
                for root in [&explained.value, &explained.limit].into_iter().flatten() {
                    collect(root, check.id.id(), &mut terms);
                }
            }
        }
    }
    let meaning = |symbol: &str, unit: &str, check: &str| {
        let found = terms.get(&(symbol.to_owned(), unit)).into_iter().flatten().find(|(id, _)| id == check);
        found.map_or_else(String::new, |(_, term)| term.clone())
    };
    for (symbol, unit, check, expected) in [
        ("P_0", "W", "thermal", "permissible loss at standstill"),
        ("P_0", "N", "bearing_static", "static equivalent load"),
        ("phi", "arcmin", "torsion", "torsion angle of the gear"),
        ("phi", "rad", "mean_speed", "angle travelled over the cycle"),
        ("resolution", "arcsec", "error_budget", "resolution of the encoder at the motor"),
        ("T_1", "Nm", "torsion", "limit torque between stiffness regions 1 and 2"),
        ("T_1", "Nm", "peak_torque", "torque while accelerating"),
        ("R", "m", "bearing_static", "offset of the bearing centre from the output flange"),
        ("R", "ohm", "voltage", "resistance of a phase, hot"),
    ] {
        assert_eq!(meaning(symbol, unit, check), expected, "{symbol} in {unit}, {check}");
    }
}

fn collect(node: &Node, check: &str, terms: &mut BTreeMap<(String, &'static str), Vec<(String, String)>>) {
    let found = terms.entry((node.symbol.clone(), node.unit)).or_default();
    if !found.iter().any(|(id, term)| id == check && *term == node.term) {
        found.push((check.to_owned(), node.term.clone()));
    }
    node.operands.iter().for_each(|operand| collect(operand, check, terms));
}

/// A figure's name in code (`transmission_accuracy`, `dtheta`) is no symbol.
fn look_for_raw_names(node: &Node, raw: &mut Vec<String>) {
    let shown = words::symbol_shown(&node.symbol);
    let texts = [Some(&shown), node.formula.as_ref(), node.figures.as_ref()];
    for word in texts.into_iter().flatten().flat_map(|text| text.split(|c: char| !c.is_alphanumeric() && c != '_')) {
        let head = word.split('_').next().unwrap_or_default();
        let spelled = ["alpha", "dtheta", "gamma", "omega", "phi", "psi", "rho", "sigma", "tau", "theta"];
        let is_name = word.contains('_') && head.is_ascii() && head.len() > 3;
        if (is_name || spelled.contains(&head)) && !raw.contains(&word.to_owned()) {
            raw.push(word.to_owned());
        }
    }
    node.operands.iter().for_each(|operand| look_for_raw_names(operand, raw));
}

const ENGLISH: [&str; 14] = [
    "the ", "over", "over ", " of ", "largest", "load", " at ", " is ", "mean", "for ", "with", "where", "between",
    "life",
];

fn look(node: &Node, english: &mut Vec<String>, wordless: &mut Vec<String>) {
    if let Some(formula) = &node.formula
        && node.figures.is_none()
        && ENGLISH.iter().any(|word| formula.contains(word))
        && !english.contains(formula)
    {
        english.push(formula.clone());
    }
    if node.term.is_empty() && !wordless.contains(&node.symbol) {
        wordless.push(node.symbol.clone());
    }
    node.operands.iter().for_each(|operand| look(operand, english, wordless));
}
