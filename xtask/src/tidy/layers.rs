//! Rule: a crate depends on lower layers only.

use std::path::Path;

use cargo_metadata::{Dependency, DependencyKind};

use super::Violation;
use super::manifest::Members;

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Room {
    /// Part of the product; may depend on lower layers.
    Layer(u8),
    /// Used by build scripts and tests; depends on layer 0 only.
    BuildOnly,
    /// Used by tests only.
    DevOnly,
    /// Uses the product from outside.
    Outside,
}

/// Every crate of the workspace by package name. A new crate is entered here first.
const ROOMS: [(&str, Room); 41] = [
    ("numeric", Room::Layer(0)),
    ("quantities", Room::Layer(0)),
    ("provenance", Room::Layer(0)),
    ("series-files", Room::BuildOnly),
    ("order-code", Room::Layer(0)),
    ("catalogue", Room::Layer(1)),
    ("derivation", Room::Layer(1)),
    ("motion", Room::Layer(1)),
    ("mechanism", Room::Layer(1)),
    ("actuator", Room::Layer(1)),
    ("plot", Room::Layer(1)),
    ("excerpt", Room::Layer(1)),
    ("configurator", Room::Layer(2)),
    ("trace", Room::Layer(2)),
    ("recording", Room::Layer(2)),
    ("feedback", Room::Layer(2)),
    ("sizing", Room::Layer(3)),
    ("twin", Room::Layer(3)),
    ("installation", Room::Layer(3)),
    ("drive", Room::Layer(4)),
    ("project", Room::Layer(4)),
    ("answers", Room::Layer(4)),
    ("words", Room::Layer(5)),
    ("questions", Room::Layer(6)),
    ("figures", Room::Layer(7)),
    ("report", Room::Layer(7)),
    ("tables", Room::Layer(7)),
    ("sweep-io", Room::Layer(7)),
    ("disk", Room::Layer(8)),
    ("page", Room::Layer(8)),
    ("server", Room::Layer(9)),
    ("site", Room::Layer(9)),
    ("antrieb", Room::Layer(10)),
    ("antrieb-quick", Room::Layer(10)),
    ("python", Room::Layer(11)),
    ("testkit", Room::DevOnly),
    ("xtask", Room::Outside),
    ("benches", Room::Outside),
    ("browser", Room::Outside),
    ("fuzz", Room::Outside),
    ("validation", Room::Outside),
];

/// Crates that their own layer may depend on.
const SERVE_THEIR_LAYER: [&str; 2] = ["derivation", "motion"];

fn room(name: &str) -> Option<Room> {
    ROOMS.iter().find(|(known, _)| *known == name).map(|(_, room)| *room)
}

/// Returns the layer of a crate that is part of the product.
pub(crate) fn layer(name: &str) -> Option<u8> {
    match room(name) {
        Some(Room::Layer(layer)) => Some(layer),
        _ => None,
    }
}

pub(super) fn rule(root: &Path) -> Vec<Violation> {
    let members = Members::read(root);
    let mut findings = members.findings;
    for member in &members.list {
        let name = member.package.name.as_str();
        let mut tell = |line, message| {
            findings.push(Violation { path: member.manifest.clone(), line, rule: "layers", message });
        };
        match room(name) {
            None => tell(1, format!("crate `{name}` has no layer: enter it in xtask/src/tidy/layers.rs")),
            Some(from) => {
                for dependency in &member.package.dependencies {
                    if let Some(message) = objection(name, from, dependency) {
                        tell(member.line_of(dependency), message);
                    }
                }
            }
        }
    }
    findings
}

fn objection(name: &str, from: Room, dependency: &Dependency) -> Option<String> {
    if dependency.kind == DependencyKind::Development {
        return None;
    }
    let on = dependency.name.as_str();
    match (from, room(on)?) {
        // A crate that uses the product from outside is not part of it, and may be a test itself.
        (Room::Layer(_) | Room::DevOnly, Room::DevOnly) => Some(format!("`{on}` may only be a dev-dependency")),
        (Room::Layer(_), Room::BuildOnly) => {
            (dependency.kind != DependencyKind::Build).then(|| format!("`{on}` may only be a build-dependency"))
        }
        (Room::BuildOnly, Room::Layer(0)) => None,
        (Room::BuildOnly, _) => Some(format!("`{name}` is built from layer 0 and may not use `{on}`")),
        (Room::Layer(_), Room::Outside) => Some(format!("`{name}` is part of the product and may not use `{on}`")),
        (Room::Layer(own), Room::Layer(other)) => {
            let served = SERVE_THEIR_LAYER.contains(&on) && !SERVE_THEIR_LAYER.contains(&name) && own == other;
            (other >= own && !served)
                .then(|| format!("`{name}` (layer {own}) may not use `{on}` (layer {other}): only lower layers"))
        }
        (Room::DevOnly | Room::Outside, _) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    const TOP: &str =
        "[workspace]\nmembers = [\"it\"]\n[workspace.dependencies]\nsz = { package = \"sizing\", version = \"1\" }\n";

    fn findings_of(name: &str, rest: &str) -> Vec<String> {
        let manifest = format!("[package]\nname = \"{name}\"\n{rest}");
        let scratch = Scratch::new(&[("Cargo.toml", TOP), ("it/Cargo.toml", &manifest), ("it/src/lib.rs", "")]);
        rule(scratch.root()).iter().map(Violation::to_string).collect()
    }

    #[test]
    fn lower_layers_and_foreign_crates_are_fine() {
        assert!(
            findings_of(
                "sizing",
                "[dependencies]\nmotion = \"1\"\ntoml = \"1\"\n[dev-dependencies]\ntestkit = \"1\"\nquestions = \"1\"\n"
            )
            .is_empty()
        );
        assert!(findings_of("actuator", "[dependencies]\nmotion = \"1\"\n").is_empty());
        assert!(findings_of("benches", "[dependencies]\nquestions = \"1\"\n").is_empty());
    }

    #[test]
    fn a_layer_that_looks_up_or_sideways_is_found() {
        assert_eq!(
            findings_of("motion", "\n[dependencies]\nquantities = \"1\"\nsizing = \"1\"\n"),
            ["it/Cargo.toml:6: layers: `motion` (layer 1) may not use `sizing` (layer 3): only lower layers"]
        );
        assert_eq!(findings_of("actuator", "[dependencies]\ncatalogue = \"1\"\n").len(), 1);
        assert_eq!(findings_of("order-code", "[dependencies]\nquantities = \"1\"\n").len(), 1);
    }

    #[test]
    fn no_disguise_helps() {
        assert_eq!(findings_of("catalogue", "[build-dependencies]\nsizing = \"1\"\n").len(), 1);
        assert_eq!(findings_of("catalogue", "[dependencies]\nsz.workspace = true\n").len(), 1);
        assert_eq!(findings_of("catalogue", "[dependencies]\nx = { package = \"twin\", version = \"1\" }\n").len(), 1);
        assert_eq!(findings_of("catalogue", "[target.'cfg(unix)'.dependencies]\nsizing = \"1\"\n").len(), 1);
    }

    #[test]
    fn testkit_serves_tests_only_and_outside_is_outside() {
        assert_eq!(
            findings_of("sizing", "[dependencies]\ntestkit = \"1\"\n"),
            ["it/Cargo.toml:4: layers: `testkit` may only be a dev-dependency"]
        );
        assert!(findings_of("fuzz", "[dependencies]\ntestkit = \"1\"\n").is_empty());
        assert_eq!(findings_of("antrieb", "[dependencies]\nxtask = \"0\"\n").len(), 1);
    }

    #[test]
    fn a_crate_without_a_layer_is_found() {
        let findings_of = findings_of("utils", "");
        assert!(findings_of.iter().any(|text| text.contains("crate `utils` has no layer")), "{findings_of:?}");
    }
}
