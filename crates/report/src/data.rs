//! The data as they arrive, the JSON of the tool. Every key may be missing.

use crate::Fault;
use crate::project::Input;
use serde::Deserialize;
use serde_json::Value;

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Data {
    pub(crate) check: Option<Judged>,
    pub(crate) sizing: Option<Sizing>,
    pub(crate) inputs: Vec<Input>,
    pub(crate) assumptions: Vec<String>,
    pub(crate) explain: Explain,
    pub(crate) derivations: Vec<Derivation>,
    pub(crate) recordings: Vec<Recording>,
    pub(crate) hash: Hash,
    pub(crate) bill_of_material: Vec<Item>,
    pub(crate) wiring: Vec<Connection>,
    pub(crate) screws: Vec<Screws>,
    pub(crate) sources: Vec<Titled>,
    pub(crate) errata: Vec<Erratum>,
}

impl Data {
    pub(crate) fn read(value: &Value) -> Result<Self, Fault> {
        if value.is_null() {
            return Ok(Self::default());
        }
        let mut data: Self =
            serde_json::from_value(without_nulls(value)).map_err(|fault| Fault::Data { message: fault.to_string() })?;
        for each in std::mem::take(&mut data.explain.checks) {
            let nodes = [each.derivation.value, each.derivation.limit].into_iter().flatten().collect();
            data.derivations.push(Derivation { check: each.id, title: each.title, nodes });
        }
        Ok(data)
    }
}

/// `null` means that there is no such value, as if the key were left out.
fn without_nulls(value: &Value) -> Value {
    match value {
        Value::Object(map) => map
            .iter()
            .filter(|(_, value)| !value.is_null())
            .map(|(key, value)| (key.clone(), without_nulls(value)))
            .collect(),
        Value::Array(items) => items.iter().map(without_nulls).collect(),
        other => other.clone(),
    }
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Judged {
    pub(crate) code: String,
    pub(crate) name: String,
    pub(crate) verdict: String,
    pub(crate) utilisation: Option<f64>,
    pub(crate) tightest: String,
    pub(crate) mass_kg: Option<f64>,
    pub(crate) on_request: Vec<String>,
    pub(crate) open_questions: usize,
    pub(crate) demand: Option<Demand>,
    pub(crate) checks: Vec<Check>,
    pub(crate) objections: Vec<String>,
    pub(crate) axis: String,
    pub(crate) motion: Motion,
    pub(crate) reserve: Option<Reserve>,
    pub(crate) assumptions: Vec<String>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Check {
    pub(crate) id: String,
    pub(crate) title: String,
    pub(crate) verdict: String,
    pub(crate) value: Option<f64>,
    pub(crate) limit: Option<f64>,
    pub(crate) unit: String,
    pub(crate) direction: String,
    pub(crate) part: String,
    pub(crate) utilisation: Option<f64>,
    pub(crate) margin: bool,
    pub(crate) at: Option<f64>,
    pub(crate) grade: String,
    pub(crate) source: String,
    pub(crate) missing: String,
    pub(crate) notes: Vec<String>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
#[allow(non_snake_case, reason = "the symbols of the JSON")]
pub(crate) struct Demand {
    pub(crate) mode: String,
    pub(crate) T_rms: Option<f64>,
    pub(crate) T_peak: Option<f64>,
    pub(crate) n_av: Option<f64>,
    pub(crate) n_peak: Option<f64>,
    pub(crate) ED: Option<f64>,
    pub(crate) T_1: Option<f64>,
    pub(crate) T_2: Option<f64>,
    pub(crate) T_3: Option<f64>,
    pub(crate) moves: Vec<Demand>,
    pub(crate) governing_move: Option<usize>,
    pub(crate) integral: Option<Box<Demand>>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Motion {
    pub(crate) units: MotionUnits,
    pub(crate) segments: Vec<Segment>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct MotionUnits {
    pub(crate) time: String,
    pub(crate) distance: String,
    pub(crate) speed: String,
    pub(crate) acceleration: String,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Segment {
    pub(crate) name: String,
    pub(crate) start: Option<f64>,
    pub(crate) duration: Option<f64>,
    pub(crate) distance: Option<f64>,
    pub(crate) speed: Option<f64>,
    pub(crate) acceleration: Option<f64>,
    pub(crate) recording: Option<Recording>,
}

#[derive(Clone, Default, Deserialize)]
#[serde(default)]
pub(crate) struct Recording {
    pub(crate) file: String,
    pub(crate) samples: Option<u64>,
    pub(crate) note: String,
    pub(crate) columns: Vec<Column>,
}

#[derive(Clone, Default, Deserialize)]
#[serde(default)]
pub(crate) struct Column {
    pub(crate) name: String,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Reserve {
    pub(crate) load_factor: Option<f64>,
    pub(crate) payload_factor: Option<f64>,
    pub(crate) cycle_time: Option<f64>,
    pub(crate) ambient: Option<f64>,
    pub(crate) limits: Option<Vec<NeededLimit>>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct NeededLimit {
    pub(crate) key: String,
    pub(crate) value: f64,
    pub(crate) unit: String,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Sizing {
    pub(crate) axis: String,
    pub(crate) answer: String,
    pub(crate) judged: Option<u64>,
    pub(crate) fitting: Option<u64>,
    pub(crate) rule: String,
    pub(crate) ranking: Vec<Judged>,
    pub(crate) rejected: Vec<Rejected>,
    pub(crate) assumptions: Vec<String>,
    pub(crate) motion: Motion,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Rejected {
    pub(crate) code: String,
    pub(crate) check: String,
    pub(crate) value: Option<f64>,
    pub(crate) limit: Option<f64>,
    pub(crate) unit: String,
    pub(crate) utilisation: Option<f64>,
    pub(crate) failing: Vec<String>,
    pub(crate) objections: Vec<String>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Derivation {
    pub(crate) check: String,
    pub(crate) title: String,
    pub(crate) nodes: Vec<Node>,
}

/// A figure and how it came about; the aliases are the names of `explain --json`.
#[derive(Clone, Default, Deserialize)]
#[serde(default)]
pub(crate) struct Node {
    #[serde(alias = "symbol")]
    pub(crate) label: String,
    pub(crate) term: String,
    pub(crate) formula: String,
    #[serde(alias = "figures")]
    pub(crate) substituted: String,
    pub(crate) value: Option<f64>,
    pub(crate) unit: String,
    pub(crate) source: String,
    pub(crate) grade: String,
    pub(crate) repeated: bool,
    pub(crate) errata: Vec<NodeErratum>,
    #[serde(alias = "operands")]
    pub(crate) children: Vec<Node>,
}

#[derive(Clone, Default, Deserialize)]
#[serde(default)]
pub(crate) struct NodeErratum {
    pub(crate) id: String,
    pub(crate) evidence: String,
}

/// The answer of `explain`.
#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Explain {
    pub(crate) checks: Vec<Explained>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Explained {
    pub(crate) id: String,
    pub(crate) title: String,
    pub(crate) derivation: Sides,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Sides {
    pub(crate) value: Option<Node>,
    pub(crate) limit: Option<Node>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct Hash {
    pub(crate) project: String,
    pub(crate) catalogue: String,
}

#[derive(Default, Deserialize, serde::Serialize)]
#[serde(default)]
pub(crate) struct Item {
    pub(crate) item: String,
    pub(crate) quantity: String,
    pub(crate) code: String,
    pub(crate) text: String,
    pub(crate) source: String,
}

#[derive(Default, Deserialize, serde::Serialize)]
#[serde(default)]
pub(crate) struct Connection {
    pub(crate) connector: String,
    pub(crate) pin: String,
    pub(crate) signal: String,
    pub(crate) colour: String,
    pub(crate) text: String,
    pub(crate) source: String,
}

#[derive(Default, Deserialize, serde::Serialize)]
#[serde(default)]
pub(crate) struct Screws {
    pub(crate) joint: String,
    pub(crate) screws: String,
    pub(crate) circle: String,
    pub(crate) torque: String,
    pub(crate) text: String,
    pub(crate) source: String,
}

#[derive(Default, Deserialize, serde::Serialize)]
#[serde(default)]
pub(crate) struct Titled {
    pub(crate) id: String,
    pub(crate) title: String,
}

#[derive(Default, Deserialize, serde::Serialize)]
#[serde(default)]
pub(crate) struct Erratum {
    pub(crate) id: String,
    pub(crate) text: String,
    pub(crate) source: String,
}
