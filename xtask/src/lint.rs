//! Steps of `ci` done by cargo: format, lints, documentation, the release build.

use std::path::Path;

use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed};
use crate::tidy::layers::layer;

/// Highest layer that receives files, clock and other resources from its caller.
const HANDED_IN_MAX: u8 = 6;
/// The only crate of the faces that creates, replaces and removes files.
const WRITES_FILES: &str = "disk";
/// Highest layer without threads.
const ONE_THREAD_MAX: u8 = 1;

pub(crate) fn fmt(root: &Path) -> Result<(), Error> {
    must_succeed(&mut cargo(root, &["fmt", "--all", "--check", "--", "--color=never"]))
}

/// Runs the lints of the workspace, then the bans of each layer.
///
/// clippy uses one `clippy.toml` for a crate including its tests and build script; so the bans of the layers are in
/// files of their own that apply to the libraries only.
pub(crate) fn clippy(root: &Path) -> Result<(), Error> {
    must_succeed(&mut cargo(root, &["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"]))?;
    // The Python module; no Python is needed to check it.
    let module =
        ["clippy", "--quiet", "--package", "python", "--features", "extension", "--no-deps", "--", "-D", "warnings"];
    must_succeed(cargo(root, &module).env("PYO3_NO_PYTHON", "1"))?;
    let workspace = Workspace::ask(root)?;
    // Returns `true` if a ban holds for a crate with this name and layer.
    type Covers = fn(&str, u8) -> bool;
    let bans: [(&str, Covers); 3] = [
        ("outside-world", |_, layer| layer <= HANDED_IN_MAX),
        ("threads", |_, layer| layer <= ONE_THREAD_MAX),
        ("own-files", |name, layer| layer > HANDED_IN_MAX && name != WRITES_FILES),
    ];
    for (bans, are_put_to) in bans {
        let names = workspace.packages.iter().map(|package| package.name.as_str());
        let mut command = cargo(root, &["clippy", "--quiet", "--lib", "--no-deps"]);
        for name in names.filter(|name| layer(name).is_some_and(|layer| are_put_to(name, layer))) {
            command.args(["--package", name]);
        }
        command.args(["--", "-D", "clippy::disallowed_types", "-D", "clippy::disallowed_methods"]);
        must_succeed(command.env("CLIPPY_CONF_DIR", root.join("xtask").join("clippy").join(bans)))?;
    }
    Ok(())
}

pub(crate) fn doc(root: &Path) -> Result<(), Error> {
    let mut command = cargo(root, &["doc", "--workspace", "--no-deps"]);
    must_succeed(command.env("RUSTDOCFLAGS", "-Dwarnings"))
}

pub(crate) fn release(root: &Path) -> Result<(), Error> {
    must_succeed(&mut cargo(root, &["build", "--release", "--package", "antrieb"]))
}

#[cfg(test)]
mod tests {
    use std::process::Command;

    /// Returns the output of clippy for one line of a library under the bans of a folder.
    fn printed(bans: &str, line: &str) -> String {
        let root = crate::root();
        let folder = std::env::temp_dir().join(format!("antrieb-bans-{}-{bans}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let source = folder.join("it.rs");
        std::fs::write(&source, format!("#![allow(dead_code)]\n{line}\n")).unwrap();
        let output = Command::new("clippy-driver")
            .args(["--edition", "2024", "--crate-type", "lib", "--emit", "metadata", "--out-dir"])
            .args([&folder, &source])
            .args(["-D", "clippy::disallowed_types", "-D", "clippy::disallowed_methods"])
            .env("CLIPPY_CONF_DIR", root.join("xtask/clippy").join(bans))
            .output()
            .unwrap();
        std::fs::remove_dir_all(&folder).unwrap();
        String::from_utf8_lossy(&output.stderr).into_owned()
    }

    #[test]
    fn a_face_that_writes_or_removes_a_file_itself_is_found_and_one_that_reads_is_not() {
        for (line, what) in [
            ("fn f() { let _ = std::fs::write(\"x\", \"\"); }", "method `std::fs::write`"),
            ("fn f() { let _ = std::fs::remove_dir_all(\"x\"); }", "method `std::fs::remove_dir_all`"),
            ("fn f() { let _ = std::fs::remove_file(\"x\"); }", "method `std::fs::remove_file`"),
            ("fn f() { let _ = std::fs::rename(\"x\", \"y\"); }", "method `std::fs::rename`"),
            ("use std::fs::File; fn f() { let _ = File::create(\"x\"); }", "method `std::fs::File::create`"),
            ("fn f(_: &std::fs::OpenOptions) {}", "type `std::fs::OpenOptions`"),
        ] {
            let said = printed("own-files", line);
            assert!(said.contains(what), "{line}: {said}");
        }
        assert_eq!(printed("own-files", "fn f() { let _ = (std::fs::File::open(\"x\"), std::fs::read(\"y\")); }"), "");
    }

    #[test]
    fn what_reaches_out_is_found_and_a_scope_is_not() {
        for (line, what) in [
            ("fn f() { let _ = std::fs::read(\"x\"); }", "method `std::fs::read`"),
            ("fn f(p: &std::path::Path) -> bool { p.exists() }", "method `std::path::Path::exists`"),
            ("fn f() { let _ = std::env::var(\"A\"); }", "method `std::env::var`"),
            ("fn f() { std::thread::spawn(|| ()); }", "method `std::thread::spawn`"),
            ("use std::time as t; fn f(_: t::Instant) {}", "type `std::time::Instant`"),
            ("fn f(_: std::collections::HashMap<u8, u8>) {}", "type `std::collections::HashMap`"),
        ] {
            let printed = printed("outside-world", line);
            assert!(printed.contains(&format!("disallowed {what}")), "{line}: {printed}");
        }
        let fine =
            "const A: &str = env!(\"PATH\"); fn f() { std::thread::scope(|_| ()); } fn g(_: std::time::Duration) {}";
        assert_eq!(printed("outside-world", fine), "");
    }

    #[test]
    fn the_lowest_layers_have_no_threads() {
        let printed = printed("threads", "fn f() { std::thread::scope(|_| ()); }");
        assert!(printed.contains("disallowed method `std::thread::scope`"), "{printed}");
    }
}
