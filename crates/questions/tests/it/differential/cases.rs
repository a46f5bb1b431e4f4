//! The cases of the reference and what the engine answers to them.

use axis::{AxisProject, Files};
use quantities::Measure;
use quantities::unit::{JOULE, WATT};
use questions::check;
use serde_json::Value;
use sizing::{Check, Note};
use std::collections::BTreeMap;
use std::io::Read;
use std::sync::LazyLock;

/// Results by name, in the unit that people read them in.
pub(crate) type Figures = BTreeMap<String, f64>;

/// One project with its actuator and the results of the reference.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    /// Number, mechanism and laws.
    pub(crate) name: String,
    /// Ordering code.
    pub(crate) code: String,
    /// Text of the project file.
    pub(crate) project: String,
    /// Recordings by file name.
    pub(crate) files: BTreeMap<String, String>,
    /// Segments with which the cycle may begin as well.
    pub(crate) rotations: Vec<usize>,
    /// Every direction is given, so that the case can be mirrored.
    pub(crate) mirror: bool,
    /// Values of the reference.
    expect: Value,
    /// Place among the cases.
    index: usize,
}

/// Values of the engine for each case.
static FOUND: LazyLock<Vec<Figures>> = LazyLock::new(|| CASES.iter().map(Case::figures).collect());

/// Recordings kept in memory.
struct Kept<'a>(&'a BTreeMap<String, String>);

impl Files for Kept<'_> {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        let text = self.0.get(name).ok_or(std::io::ErrorKind::NotFound)?;
        Ok(Box::new(std::io::Cursor::new(text.clone().into_bytes())))
    }
}

static REFERENCE: LazyLock<Value> =
    LazyLock::new(|| serde_json::from_str(include_str!("../../../../../validation/differential/cases.json")).unwrap());

/// Every case.
pub(crate) static CASES: LazyLock<Vec<Case>> = LazyLock::new(|| {
    let cases: Vec<Case> = REFERENCE["cases"].as_array().unwrap().iter().enumerate().map(case).collect();
    assert!(cases.len() > 60);
    cases
});

fn case((index, value): (usize, &Value)) -> Case {
    let text = |key: &str| value[key].as_str().unwrap().to_owned();
    let files = value["files"].as_object().unwrap();
    let rotations = value["rotations"].as_array().unwrap();
    Case {
        name: text("name"),
        code: text("code"),
        project: text("project"),
        files: files.iter().map(|(name, file)| (name.clone(), file.as_str().unwrap().to_owned())).collect(),
        rotations: rotations.iter().map(|index| usize::try_from(index.as_u64().unwrap()).unwrap()).collect(),
        mirror: value["mirror"].as_bool().unwrap(),
        expect: value["expect"].clone(),
        index,
    }
}

impl Case {
    /// Returns the case with another project.
    pub(crate) fn with(&self, project: String, files: &BTreeMap<String, String>) -> Self {
        Self { project, files: files.clone(), ..self.clone() }
    }

    /// Values of the reference.
    pub(crate) fn expected(&self, key: &str) -> Option<f64> {
        self.expect.as_object().unwrap().values().find_map(|group| group[key].as_f64())
    }

    /// The project, read.
    pub(crate) fn read(&self) -> AxisProject {
        let read = questions::read_all(&self.project, &Kept(&self.files));
        let mut axes = read.unwrap_or_else(|faults| panic!("{}: {faults:?}\n{}", self.name, self.project));
        axes.pop().unwrap()
    }

    /// Returns `true` if the axis is elsewhere at the end of the cycle.
    pub(crate) fn travels_on(&self) -> bool {
        let project = self.read();
        let moves = questions::moves(&project).moves;
        let courses = || moves.iter().filter_map(|one| one.course);
        let gone: f64 = courses().map(|[distance, ..]| distance).sum();
        gone.abs() > 1e-6 * courses().map(|[distance, ..]| distance.abs()).sum::<f64>()
    }

    /// Returns the values of the engine for the case as the reference has it.
    pub(crate) fn found(&self) -> &'static Figures {
        &FOUND[self.index]
    }

    /// Returns the values of the engine.
    pub(crate) fn figures(&self) -> Figures {
        let project = self.read();
        let code = order_code::parse(&self.code).unwrap().code;
        let judgement = check(&project, &code).unwrap().judgement;
        let demand = judgement.demand.unwrap();
        let mut figures: Figures = judgement.checks.iter().filter_map(of_check).collect();
        let turn = std::f64::consts::TAU / 60.0;
        for (key, value) in [
            ("T_rms", demand.torque_rms.si()),
            ("T_peak", demand.torque_peak.si()),
            ("n_av", demand.speed_mean.si() / turn),
            ("n_peak", demand.speed_peak.si() / turn),
            ("ED", demand.duty_factor * 100.0),
        ] {
            figures.insert(key.to_owned(), value);
        }
        for note in judgement.checks.iter().flat_map(|check| check.notes.iter()) {
            match note {
                Note::EnergyPerCycle { motoring, regenerated, peak } => {
                    figures.insert("motoring".to_owned(), motoring.in_unit(&JOULE));
                    figures.insert("regenerated".to_owned(), regenerated.in_unit(&JOULE));
                    figures.insert("regenerated_peak".to_owned(), peak.in_unit(&WATT));
                }
                Note::Housing(temperature) => {
                    figures.insert("housing".to_owned(), temperature.in_unit(&quantities::unit::DEGREE_CELSIUS));
                }
                _ => {}
            }
        }
        figures
    }
}

fn of_check(check: &Check) -> Option<(String, f64)> {
    Some((check.id.id().to_owned(), check.value?.value()))
}

/// Data of an actuator in which the reference deviates from the catalogue.
pub(crate) fn actuators_that_differ() -> Vec<String> {
    let mut faults = Vec::new();
    for (code, numbers) in REFERENCE["actuators"].as_object().unwrap() {
        let parameters = configurator::parameters(&order_code::parse(code).unwrap().code).unwrap();
        let minute = 60.0 / std::f64::consts::TAU;
        let bearing = &parameters.output_bearing;
        let same: [(&str, f64); 15] = [
            ("i", parameters.ratio.known().unwrap().value),
            ("T_0", parameters.stall_torque.known().unwrap().value.si()),
            ("I_0", parameters.stall_current.known().unwrap().value.si()),
            ("I_NLS", parameters.no_load_starting_current.known().unwrap().value.si()),
            ("K_INL_30", parameters.no_load_current_constant_cold.known().unwrap().value.si() / minute),
            ("K_INL_80", parameters.no_load_current_constant_warm.known().unwrap().value.si() / minute),
            ("k_Tout", parameters.torque_constant_out.known().unwrap().value.si()),
            ("k_TM", parameters.torque_constant_motor.known().unwrap().value.si()),
            ("k_EM", parameters.voltage_constant_motor.known().unwrap().value.si() * 1000.0 / minute),
            ("R_LL", parameters.resistance_ll.known().unwrap().value.si()),
            ("L_LL", parameters.inductance_ll.known().unwrap().value.si()),
            ("J_out", parameters.inertia_out.known().unwrap().value.si()),
            ("d_p", bearing.pitch_diameter.known().unwrap().value.si()),
            ("C", bearing.dynamic_rating.known().unwrap().value.si()),
            ("C_0", bearing.static_rating.known().unwrap().value.si()),
        ];
        for (symbol, value) in same {
            let taken = numbers[symbol].as_f64().unwrap();
            if super::relative(value, taken) > 1e-11 {
                faults.push(format!("{code}: {symbol} {value}, the reference took {taken}"));
            }
        }
    }
    faults
}
