//! Rule: a crate depends on lower layers only.

use std::path::Path;

use cargo_metadata::{Dependency, DependencyKind};

use super::Violation;
use super::manifest::Members;
use super::tree::Tree;

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
const ROOMS: [(&str, Room); 42] = [
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
    ("axis", Room::Layer(4)),
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

/// Roles of the layers, from the lowest.
const ROLES: [&str; 12] = [
    "basics",
    "subjects",
    "models",
    "engine",
    "interchange",
    "language",
    "use cases",
    "documents",
    "faces",
    "hosts",
    "command line",
    "Python",
];

/// Document whose table has a row for each layer, with its role and its crates.
const FILE: &str = "ARCHITECTURE.md";

/// Crates that their own layer may depend on.
const SERVE_THEIR_LAYER: [&str; 3] = ["derivation", "motion", "project"];

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

/// Checks that the table of the document has the same layers, roles and crates as the table of the rule.
pub(super) fn document(root: &Path) -> Vec<Violation> {
    let Some(text) = Tree::read(root).text(FILE) else { return Vec::new() };
    let rows: Vec<Vec<&str>> =
        text.lines().filter_map(|line| Some(line.strip_prefix("| ")?.split(" | ").map(str::trim).collect())).collect();
    let tell = |message| Violation { path: FILE.to_owned(), line: 1, rule: "layers", message };
    let mut findings = Vec::new();
    for (layer, role) in (0_u8..).zip(ROLES) {
        let own = ROOMS.iter().filter(|(_, room)| *room == Room::Layer(layer)).map(|(name, _)| *name);
        let mut own: Vec<&str> = own.collect();
        own.sort_unstable();
        let number = layer.to_string();
        let row = rows.iter().find(|row| row.first() == Some(&number.as_str()));
        let mut named: Vec<&str> =
            row.and_then(|row| row.get(2)).map_or_else(Vec::new, |cell| cell.split('`').skip(1).step_by(2).collect());
        named.sort_unstable();
        if row.and_then(|row| row.get(1)) != Some(&role) || named != own {
            findings
                .push(tell(format!("the table has no row `| {layer} | {role} |` with the crates {}", own.join(", "))));
        }
    }
    findings
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
                .then(|| format!("`{name}` ({}) may not use `{on}` ({}): only lower layers", named(own), named(other)))
        }
        (Room::DevOnly | Room::Outside, _) => None,
    }
}

/// Returns a layer with its role.
fn named(layer: u8) -> String {
    let role = ROLES.get(usize::from(layer)).copied().unwrap_or_default();
    format!("layer {layer}, {role}")
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
            [
                "it/Cargo.toml:6: layers: `motion` (layer 1, subjects) may not use `sizing` (layer 3, engine): only lower layers"
            ]
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

    #[test]
    fn the_document_has_every_layer_with_its_role_and_its_crates() {
        let row = |layer: u8, change: fn(String) -> String| {
            let own = ROOMS.iter().filter(|(_, room)| *room == Room::Layer(layer)).map(|(name, _)| format!("`{name}`"));
            let own: Vec<String> = own.collect();
            change(format!("| {layer} | {} | {} | text |\n", ROLES[usize::from(layer)], own.join(" · ")))
        };
        let found = |change: fn(String) -> String| {
            let table: String = (0..12).map(|layer| row(layer, if layer == 3 { change } else { |row| row })).collect();
            document(Scratch::new(&[(FILE, table.as_str())]).root()).len()
        };
        assert_eq!(found(|row| row), 0);
        assert_eq!(found(|row| row.replace("engine", "machine")), 1);
        assert_eq!(found(|row| row.replace(" · `twin`", "")), 1);
        assert_eq!(found(|row| row.replace("`twin`", "`twin` · `motion`")), 1);
        assert_eq!(found(|_| String::new()), 1);
    }
}
