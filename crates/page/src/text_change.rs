//! Changes of a project as a whole: several values, the times of its motion, its loads.

use crate::call::Call;
use crate::markup::vals;
use project::{edit_values, load_scaled, paced};

/// A change of a project that a button applies.
pub(crate) enum TextChange {
    /// Paths with their new values.
    Values(Vec<(String, String)>),
    /// Factor on the times of the motion.
    Pace(f64),
    /// Factors on the load and on the payloads.
    Load([f64; 2]),
}

impl TextChange {
    /// Returns a text with the change, if the text has a place for it.
    pub(crate) fn applied(&self, text: &str, prefix: &str) -> Option<String> {
        match self {
            Self::Values(values) => edit_values(text, values).ok(),
            Self::Pace(factor) => paced(text, prefix, *factor),
            Self::Load([load, payload]) => load_scaled(text, prefix, *load, *payload),
        }
    }

    /// Returns the fields of the request that applies the change.
    pub(crate) fn fields(&self, prefix: &str) -> String {
        match self {
            Self::Values(values) => {
                let lines: String = values.iter().map(|(path, value)| format!("value {path}={value}\n")).collect();
                vals(&[("do", &lines)])
            }
            Self::Pace(factor) => vals(&[("pace", &factor.to_string()), ("of", prefix)]),
            Self::Load([load, payload]) => vals(&[("load_factors", &format!("{load} {payload}")), ("of", prefix)]),
        }
    }
}

/// Returns the text with the factors of a request on its motion or its load; `None` if the request has none, or if the text
/// has no place for them.
pub(crate) fn scaled(call: &Call<'_>, text: &str) -> Option<String> {
    let prefix = call.field("of")?;
    let change = match (call.field("pace"), call.field("load_factors")) {
        (Some(factor), _) => TextChange::Pace(factor.parse().ok()?),
        (None, factors) => {
            let factors = factors?;
            let (load, payload) = factors.split_once(' ')?;
            TextChange::Load([load.parse().ok()?, payload.parse().ok()?])
        }
    };
    change.applied(text, &prefix)
}
