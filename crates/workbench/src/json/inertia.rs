//! The inertia of solid bodies as JSON.

use super::in_unit;
use project::{BodyAnswer, InertiaAnswer};
use quantities::Measure;
use quantities::unit::{DEGREE, KILOGRAM, KILOGRAM_SQUARE_METRE, MILLIMETRE, NEWTON_METRE};
use serde_json::{Value, json};

/// Each body with the parts of its inertia, and all together.
#[must_use]
pub fn inertia(answer: &InertiaAnswer) -> Value {
    let total = &answer.total;
    json!({
        "bodies": answer.bodies.iter().map(body).collect::<Vec<_>>(),
        "J": in_unit(total.inertia.si(), &KILOGRAM_SQUARE_METRE),
        "m": in_unit(total.mass.si(), &KILOGRAM),
        "centre": {
            "r": in_unit(total.centre_radius.si(), &MILLIMETRE),
            "angle": in_unit(total.centre_angle.si(), &DEGREE),
        },
        "T_gravity_max": in_unit(total.gravity_torque_max().si(), &NEWTON_METRE),
        "units": { "J": "kgm^2", "m": "kg", "r": "mm", "angle": "deg", "T": "Nm" },
    })
}

fn body(answer: &BodyAnswer) -> Value {
    let parts = &answer.parts;
    json!({
        "shape": answer.shape.name,
        "count": answer.body.count,
        "m": in_unit(parts.mass.si(), &KILOGRAM),
        "r": in_unit(answer.body.distance.si(), &MILLIMETRE),
        "angle": in_unit(answer.body.angle.si(), &DEGREE),
        "J_own": in_unit(parts.own.si(), &KILOGRAM_SQUARE_METRE),
        "J_steiner": in_unit(parts.steiner.si(), &KILOGRAM_SQUARE_METRE),
        "J": in_unit(parts.total.si(), &KILOGRAM_SQUARE_METRE),
    })
}
