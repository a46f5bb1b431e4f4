//! Load of an axis: the keys of that which the machine moves for its purpose.

use crate::edit::{Written, key_at};
use crate::key::Kind;
use crate::scaled::{bodies_scaled, multiplied};
use quantities::Dimension;

/// Keys of the load of each mechanism. Counterweights, ropes, pulleys, arms of a lift, couplers and cores are parts of the
/// mechanism. The first key of a group decides if there is such a load; the others are the moments of inertia of the same body.
pub const LOADS: [(&str, &[&str]); 13] = [
    ("load", &["inertia"]),
    ("mechanism.turntable", &["body", "bodies"]),
    ("mechanism.arm", &["mass", "inertia"]),
    ("mechanism.screw", &["mass"]),
    ("mechanism.belt", &["mass"]),
    ("mechanism.conveyor", &["mass"]),
    ("mechanism.slider_crank", &["mass"]),
    ("mechanism.joint", &[]),
    ("mechanism.table", &[]),
    ("mechanism.hoist", &["mass"]),
    ("mechanism.winder", &["density"]),
    ("mechanism.scissor_lift", &["mass"]),
    ("mechanism.four_bar", &["rocker_mass", "rocker_inertia"]),
];

/// One load of an axis: a body, or all payloads of its motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Load {
    /// Paths of the keys with their stated values.
    pub stated: Vec<(String, String)>,
    /// The payloads of the moves.
    pub is_payload: bool,
}

impl Load {
    /// Returns the keys with their values multiplied by a factor; `None` for a value that is no quantity.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Option<Vec<(String, String)>> {
        let value = |(path, stated): &(String, String)| {
            let is_lines = path.ends_with(".bodies");
            let value = if is_lines { bodies_scaled(stated, factor) } else { multiplied(stated, factor) };
            Some((path.clone(), value?))
        };
        self.stated.iter().map(value).collect()
    }

    /// Returns the paths of the masses of the load.
    pub fn masses(&self) -> impl Iterator<Item = &str> {
        let is_mass =
            |path: &&str| key_at(path).is_some_and(|key| matches!(key.kind, Kind::Quantity(Dimension::Mass, _)));
        self.stated.iter().map(|(path, _)| path.as_str()).filter(is_mass)
    }
}

/// Keys of the mechanisms that carry a payload: along a line, or at a lever arm.
const OF_PAYLOADS: [&str; 2] = ["process_force", "payload_distance"];

/// Returns `true` if the mechanism of an axis may carry a payload; `prefix` stands before the keys of the axis.
#[must_use]
pub fn takes_payload(all: &[Written], prefix: &str) -> bool {
    let tables = all.iter().filter_map(|each| each.path.strip_prefix(prefix)?.strip_prefix("mechanism."));
    let has = |table: &str, key: &&str| key_at(&format!("mechanism.{table}.{key}")).is_some();
    tables.filter(|table| !table.contains(['.', '['])).any(|table| OF_PAYLOADS.iter().any(|key| has(table, key)))
}

/// Returns the loads of an axis that are not zero; `prefix` stands before the keys of the axis. A mechanism whose torques are
/// recorded or stated over the position has none.
#[must_use]
pub fn loads(all: &[Written], prefix: &str) -> Vec<Load> {
    let of = |is_wanted: &dyn Fn(&str) -> bool| -> Vec<(String, String)> {
        let inside = |each: &&Written| each.path.strip_prefix(prefix).is_some_and(is_wanted);
        all.iter().filter(inside).filter_map(|each| Some((each.path.clone(), each.value.clone()?))).collect()
    };
    let mut found = Vec::new();
    for (table, keys) in LOADS {
        if table == "mechanism.turntable" {
            let bodies = of(&|path| path.starts_with("mechanism.turntable.body[") && ends_with_mass(path));
            found.extend(bodies.into_iter().map(|body| vec![body]));
            let lines = of(&|path| path == "mechanism.turntable.bodies");
            // Several bodies in one list are several loads.
            for (path, value) in lines {
                found.extend(
                    value.lines().filter(|line| !line.trim().is_empty()).map(|_| vec![(path.clone(), value.clone())]),
                );
            }
        } else {
            found.push(of(&|path| {
                path.strip_prefix(table).and_then(|rest| rest.strip_prefix('.')).is_some_and(|key| keys.contains(&key))
            }));
        }
    }
    let mut loads: Vec<Load> = found.into_iter().map(|stated| Load { stated, is_payload: false }).collect();
    let payload =
        of(&|path| path.starts_with("motion[") && (path.ends_with("].payload") || path.ends_with("].payload_inertia")));
    loads.push(Load { stated: payload, is_payload: true });
    loads.retain(|load| load.stated.iter().any(|(path, value)| path.ends_with(".bodies") || !is_zero(value)));
    loads
}

fn ends_with_mass(path: &str) -> bool {
    path.ends_with("].mass") || path.ends_with("].density")
}

/// Returns `true` if a quantity is zero, with any unit.
fn is_zero(value: &str) -> bool {
    multiplied(value, 2.0) == multiplied(value, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::written;
    use crate::root::KEYS;

    #[test]
    fn every_mechanism_has_an_entry_and_its_keys_exist() {
        let mechanisms = KEYS.iter().find(|key| key.name == "mechanism").unwrap().kind.keys(false);
        for mechanism in mechanisms {
            let path = format!("mechanism.{}", mechanism.name);
            assert_eq!(LOADS.iter().filter(|(table, _)| *table == path).count(), 1, "{path}");
        }
        assert_eq!(LOADS.len(), mechanisms.len() + 1);
        for (table, keys) in LOADS {
            assert!(keys.iter().all(|key| key_at(&format!("{table}.{key}")).is_some()), "{table}");
        }
    }

    #[test]
    fn bodies_and_payloads_are_several_loads_and_zero_is_none() {
        let count = |text: &str| loads(&written(text).unwrap(), "").len();
        let body = "[[mechanism.turntable.body]]\nshape = \"disc\"\nmass = \"3 kg\"\n";
        let lines = |lines: &str| format!("[mechanism.turntable]\nbodies = [{lines}]\n");
        let payload = "[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\npayload = \"3 kg\"\n";
        assert_eq!(count(body), 1);
        assert_eq!(count(&body.repeat(3)), 3);
        assert_eq!(count(&format!("{body}{payload}{payload}")), 2);
        assert_eq!(count(&lines("\"disc diameter=1m mass=2kg\"")), 1);
        assert_eq!(count(&lines("\"disc diameter=1m mass=2kg\", \"point mass=1kg distance=1m\"")), 2);
        assert_eq!(count(&format!("[mechanism.arm]\nmass = \"0 kg\"\n{payload}")), 1);
        assert_eq!(count("[mechanism.arm]\nmass = \"0 kg\"\n"), 0);
        let arm = "[mechanism.arm]\nmass = \"2 kg ± 5 %\"\ninertia = \"4 kg m^2\"\npayload_distance = \"1 m\"\n";
        let [arm] = &loads(&written(arm).unwrap(), "")[..] else { panic!("one load") };
        let value = |path: &str, value: &str| (path.to_owned(), value.to_owned());
        let expected = [value("mechanism.arm.mass", "3 kg ± 5 %"), value("mechanism.arm.inertia", "6 kg m^2")];
        assert_eq!(arm.scaled(1.5).unwrap(), expected);
        assert_eq!(arm.masses().collect::<Vec<_>>(), ["mechanism.arm.mass"]);
    }
}
