//! THIRD-PARTY.md: third-party work in the program, its licences, and the texts that must accompany it.
//!
//! Generated from cargo's metadata on the dependencies of `antrieb` and of the Python package on the systems of
//! `deny.toml`, and from the files in these crates. `cargo deny` checks the permitted licences; here one is chosen if
//! several are offered.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use cargo_metadata::{CargoOpt, DependencyKind, Metadata, Package, PackageId, TargetKind};
use spdx::{Expression, LicenseReq, Licensee, ParseMode};

use crate::Error;
use crate::cargo::metadata;

const FILE: &str = "THIRD-PARTY.md";
/// The program, and the Python package, which consists of the program and its Python binding.
const ROOT_PACKAGES: [&str; 2] = ["antrieb", "python"];

/// Feature of the Python package that enables part of its dependencies.
const FEATURE: &str = "python/extension";

const SYSTEMS: [&str; 4] =
    ["x86_64-unknown-linux-gnu", "aarch64-unknown-linux-gnu", "aarch64-apple-darwin", "x86_64-pc-windows-msvc"];

/// Accepted licences in order of preference: those that require one text and the notices first.
const TAKEN: [&str; 7] = ["Apache-2.0", "MIT", "Unicode-3.0", "BSD-3-Clause", "BSD-2-Clause", "Zlib", "CC0-1.0"];

/// Licences of works that crates embed or link besides their own source: package, file in it, description.
const EMBEDDED: [(&str, &str, &str); 1] = [("zstd-sys", "zstd/LICENSE", "the C library of zstd")];

/// Licences of embedded works whose text is in a file of this repository, for one version of the crate: package,
/// version, file, description.
const LISTED: [(&str, &str, &str, &str); 1] = [(
    "two-face",
    "0.4.5",
    "third-party/two-face.md",
    "the definitions for highlighting source text, which the typesetting engine embeds",
)];

/// Third-party files in this repository: licence, description.
const HERE: [(&str, &str); 3] = [
    ("crates/plot/fonts/OFL.txt", "Inter, the font of the pictures"),
    ("crates/page/fonts/GUST-FONT-LICENSE.txt", "Antrieb Math, the font of the formulas in the web workbench"),
    ("crates/page/assets/htmx-LICENSE.txt", "htmx 4.0.1, a script of the web workbench"),
];

/// Rewrites THIRD-PARTY.md.
///
/// # Errors
/// Cargo returns no metadata, a licence is not accepted, or a file cannot be read or written.
pub fn run(root: &Path) -> Result<(), Error> {
    let path = root.join(FILE);
    fs::write(&path, text(root)?).map_err(|source| Error::File { path, source })
}

/// Compares THIRD-PARTY.md with the lock file.
pub(crate) fn check(root: &Path) -> Result<(), Error> {
    let wanted = text(root)?;
    let there = read(&root.join(FILE))?;
    let differs = |(line, (there, wanted)): (usize, (&str, &str))| (there != wanted).then_some(line);
    let line = (1..).zip(there.lines().zip(wanted.lines())).find_map(differs);
    match line {
        Some(line) => Err(Error::Stale { file: FILE, line, command: "cargo xtask notices" }),
        None if there.len() != wanted.len() => {
            let line = there.lines().count().min(wanted.lines().count()) + 1;
            Err(Error::Stale { file: FILE, line, command: "cargo xtask notices" })
        }
        None => Ok(()),
    }
}

fn text(root: &Path) -> Result<String, Error> {
    let platforms: Vec<String> =
        SYSTEMS.iter().flat_map(|system| ["--filter-platform".to_owned(), (*system).to_owned()]).collect();
    let metadata_found = metadata(root, |command| {
        command.features(CargoOpt::SomeFeatures(vec![FEATURE.to_owned()])).other_options(platforms)
    })?;
    let mut taken = TAKEN.iter().filter_map(|name| Licensee::parse(name).ok()).collect::<Vec<_>>();
    taken.dedup();
    let mut crates = Vec::new();
    for package in linked(&metadata_found) {
        let licences = elected(package, &taken)?;
        crates.push((package, licences));
    }
    let mut out = String::from(HEAD);
    list(&mut out, &crates);
    out.push_str("\n## What is embedded besides source\n");
    for (file, what) in HERE {
        quote(&mut out, &format!("{what} (`{file}`)"), &read(&root.join(file))?);
    }
    for (package, _) in &crates {
        embedded(&mut out, root, package)?;
    }
    out.push_str("\n## Notices\n");
    for (package, _) in &crates {
        for (name, notice) in files(package, |name| name.starts_with("notice"))? {
            quote(&mut out, &format!("{} {}: {name}", package.name, package.version), &notice);
        }
    }
    out.push_str("\n## Licences\n");
    texts(&mut out, &crates)?;
    Ok(out)
}

const HEAD: &str = "# Third parties\n\nantrieb itself is under the [MIT licence](LICENSE). The program is built with the work of others: \
the crates below, with the licence that is taken where they offer several, fonts and data. This file is made by \
`cargo xtask notices` from the lock file; whoever passes a built program on passes this file on with it.\n\n\
Without the typesetting engine (`--no-default-features`) a part of them is in the program; the list is that of the whole, with what the package for Python adds.\n";

/// Returns the crates whose code is in the program, by name: normal dependencies, no macros, no build scripts, no test
/// dependencies.
fn linked(metadata_found: &Metadata) -> Vec<&Package> {
    let packages: BTreeMap<&PackageId, &Package> =
        metadata_found.packages.iter().map(|package| (&package.id, package)).collect();
    let nodes = metadata_found.resolve.iter().flat_map(|resolve| &resolve.nodes);
    let nodes: BTreeMap<&PackageId, _> = nodes.map(|node| (&node.id, node)).collect();
    let mut seen: BTreeSet<&PackageId> = BTreeSet::new();
    let mut open: Vec<&PackageId> = metadata_found
        .packages
        .iter()
        .filter(|package| ROOT_PACKAGES.contains(&package.name.as_str()))
        .map(|package| &package.id)
        .collect();
    while let Some(id) = open.pop() {
        let Some(package) = packages.get(id) else { continue };
        let at_build = package.targets.iter().any(|target| target.kind.contains(&TargetKind::ProcMacro));
        if at_build || !seen.insert(id) {
            continue;
        }
        for dependency in nodes.get(id).iter().flat_map(|node| &node.deps) {
            if dependency.dep_kinds.iter().any(|kind| kind.kind == DependencyKind::Normal) {
                open.push(&dependency.pkg);
            }
        }
    }
    let mut linked: Vec<&Package> = seen.iter().filter_map(|id| packages.get(id).copied()).collect();
    linked.retain(|package| package.source.is_some());
    linked.sort_by(|a, b| a.name.cmp(&b.name).then_with(|| a.version.cmp(&b.version)));
    linked
}

/// Returns the licences chosen from those that a crate offers.
fn elected(package: &Package, taken: &[Licensee]) -> Result<Vec<LicenseReq>, Error> {
    let offered = package.license.clone().unwrap_or_default();
    let none = || Error::Licence { package: package.name.to_string(), offered: offered.clone() };
    let expression = Expression::parse_mode(&offered, ParseMode::LAX).map_err(|_| none())?;
    let mut licences = expression.minimized_requirements(taken).map_err(|_| none())?;
    licences.sort();
    Ok(licences)
}

fn list(out: &mut String, crates: &[(&Package, Vec<LicenseReq>)]) {
    let mut by_licence: BTreeMap<String, Vec<&Package>> = BTreeMap::new();
    for (package, licences) in crates {
        let names: Vec<String> = licences.iter().map(ToString::to_string).collect();
        by_licence.entry(names.join(" and ")).or_default().push(package);
    }
    for (licence, packages) in by_licence {
        let _ = write!(out, "\n## Crates under {licence}\n\n");
        for package in packages {
            let _ = write!(out, "- {} {}", package.name, package.version);
            if let Some(home) = package.repository.as_ref().or(package.homepage.as_ref()) {
                let _ = write!(out, ", <{home}>");
            }
            out.push('\n');
        }
    }
}

fn embedded(out: &mut String, root: &Path, package: &Package) -> Result<(), Error> {
    for (_, file, what) in EMBEDDED.iter().filter(|(name, ..)| package.name == *name) {
        quote(out, &format!("{what} (`{}`)", package.name), &read(&folder(package).join(file))?);
    }
    for (_, version, file, what) in LISTED.iter().filter(|(name, ..)| package.name == *name) {
        let listing = read(&root.join(file))?;
        if package.version.to_string() != *version || !listing.contains(version) {
            return Err(Error::Stale { file, line: 1, command: "the listing that the crate itself makes" });
        }
        let _ = write!(out, "\n### {what} (`{}`)\n\nListed in [{file}]({file}), a part of this file.\n", package.name);
    }
    Ok(())
}

/// Crates by the line that names their copyright holder.
type Holders = BTreeMap<String, BTreeSet<String>>;

/// Appends every licence text once, with the copyright lines of all crates that include it.
fn texts(out: &mut String, crates: &[(&Package, Vec<LicenseReq>)]) -> Result<(), Error> {
    for name in TAKEN {
        let mut bodies: BTreeMap<String, (String, Holders)> = BTreeMap::new();
        let mut used = false;
        for (package, licences) in crates {
            if !licences.iter().any(|licence| licence.to_string() == name) {
                continue;
            }
            used = true;
            if name == "Apache-2.0" {
                continue;
            }
            let own = own_text(package, name)?;
            let own =
                own.unwrap_or_else(|| format!("Copyright (c) {}\n\n{}", package.authors.join(", "), standard(name)));
            let (holders, body) = parted(&own);
            let entry = bodies.entry(key(&body)).or_insert_with(|| (body, Holders::new()));
            for holder in holders {
                entry.1.entry(holder).or_default().insert(package.name.to_string());
            }
        }
        if name == "Apache-2.0" && used {
            quote(out, name, standard(name));
        }
        for (body, holders) in bodies.into_values() {
            let of = |(holder, names): (&String, &BTreeSet<String>)| {
                let names: Vec<&str> = names.iter().map(String::as_str).collect();
                format!("{holder} ({})\n", names.join(", "))
            };
            let holders: String = holders.iter().map(of).collect();
            quote(out, name, &format!("{holders}\n{body}"));
        }
    }
    Ok(())
}

fn standard(name: &str) -> &'static str {
    spdx::license_id(name).map_or("", |id| id.text())
}

/// Returns the file of a crate that holds the text of one licence.
fn own_text(package: &Package, licence: &str) -> Result<Option<String>, Error> {
    let hint = licence.split('-').next().unwrap_or(licence).to_lowercase();
    let named = files(package, |name| name.contains(&hint))?.into_iter().next();
    let plain = |name: &str| {
        let stem = name.split('.').next().unwrap_or(name);
        matches!(stem, "license" | "licence" | "copying")
    };
    let found = match named {
        Some(found) => Some(found),
        None => files(package, plain)?.into_iter().next(),
    };
    Ok(found.map(|(_, text)| text))
}

/// Returns the licence files at the top level of a crate, by name.
fn files(package: &Package, wanted: impl Fn(&str) -> bool) -> Result<Vec<(String, String)>, Error> {
    let folder = folder(package);
    let file = |source| Error::File { path: folder.to_path_buf(), source };
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).map_err(file)? {
        let entry = entry.map_err(file)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let lower = name.to_lowercase();
        let speaks = ["licen", "copying", "notice"].iter().any(|start| lower.starts_with(start));
        if speaks && wanted(&lower) && entry.file_type().map_err(file)?.is_file() {
            found.push((name, read(&entry.path())?));
        }
    }
    found.sort();
    Ok(found)
}

fn folder(package: &Package) -> &Path {
    let manifest = package.manifest_path.as_std_path();
    manifest.parent().unwrap_or(manifest)
}

fn read(path: &Path) -> Result<String, Error> {
    let bytes = fs::read(path).map_err(|source| Error::File { path: path.to_path_buf(), source })?;
    Ok(String::from_utf8_lossy(&bytes).replace("\r\n", "\n"))
}

/// Splits a text into the copyright lines at its top and the remainder without its title.
fn parted(text: &str) -> (Vec<String>, String) {
    let (mut holders, mut body) = (Vec::new(), Vec::new());
    let mut above = true;
    for line in text.trim_start_matches('\u{feff}').lines() {
        let plain = line.trim();
        let lower = plain.to_lowercase();
        let holder = lower.starts_with("copyright") || lower.starts_with("(c)") || lower.starts_with('©');
        let title =
            lower.len() < 40 && (lower.contains("license") || lower.ends_with("notice")) && !lower.contains(':');
        if above && holder && !title {
            holders.push(plain.to_owned());
        } else if !(above && (plain.is_empty() || title)) {
            above = false;
            body.push(line.trim_end());
        }
    }
    (holders, body.join("\n"))
}

/// Returns the key by which texts are compared: letters and digits.
fn key(body: &str) -> String {
    body.chars().filter(|letter| letter.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// Appends a text verbatim, in a fence that it does not close.
fn quote(out: &mut String, title: &str, text: &str) {
    let text: Vec<&str> = text.trim().lines().map(str::trim_end).collect();
    let _ = write!(out, "\n### {title}\n\n~~~~text\n{}\n~~~~\n", text.join("\n"));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_text_of_two_holders_is_one() {
        let first =
            "The MIT License (MIT)\n\nCopyright (c) 2020 A\nCopyright (c) 2021 B\n\nPermission is hereby\ngranted.\n";
        let second = "Copyright (c) 2019 C\r\n\r\nPermission is hereby granted.";
        let ((a, first), (b, second)) = (parted(first), parted(second));
        assert_eq!(a, ["Copyright (c) 2020 A", "Copyright (c) 2021 B"]);
        assert_eq!(b, ["Copyright (c) 2019 C"]);
        assert_eq!(key(&first), key(&second));
        assert_ne!(key(&first), key("Redistribution is granted."));
    }

    #[test]
    fn every_licence_taken_has_a_text() {
        for name in TAKEN {
            assert!(standard(name).len() > 200, "{name}");
            assert!(Licensee::parse(name).is_ok(), "{name}");
        }
    }
}
