//! The page without a server: the engine as WebAssembly, and a folder that any static file host can serve.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed};

/// Compilation target of the engine: WebAssembly with the few functions of WASI instead of an operating system.
const TARGET: &str = "wasm32-wasip1";

/// Maximum size of the engine as fetched by a browser, packed with brotli \[bytes\].
const ENGINE_MOST: usize = 5 << 18;

/// Returns the path of the folder.
pub(crate) fn folder(root: &Path) -> Result<PathBuf, Error> {
    Ok(Workspace::ask(root)?.target.join("site"))
}

/// Builds the folder and prints its size.
///
/// # Errors
/// The target of the compiler cannot be installed, something does not build, or the engine exceeds its maximum size.
pub fn run(root: &Path) -> Result<(), Error> {
    target_ready(root)?;
    let target = Workspace::ask(root)?.target;
    let built = |name: &str, features: &[&str]| -> Result<PathBuf, Error> {
        let library = ["rustc", "--locked", "--quiet", "--package", "site", "--lib", "--crate-type", "cdylib"];
        must_succeed(cargo(root, &library).args(["--profile", "engine", "--target", TARGET]).args(features))?;
        let made = target.join(TARGET).join("engine");
        let (from, to) = (made.join("site.wasm"), made.join(name));
        fs::copy(&from, &to).map_err(|source| Error::File { path: from, source })?;
        Ok(to)
    };
    let engine = built("engine.wasm", &["--no-default-features"])?;
    let interface = built("interface.wasm", &[])?;
    let folder = folder(root)?;
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|source| Error::File { path: folder.clone(), source })?;
    }
    let mut write = cargo(root, &["run", "--quiet", "--package", "site", "--"]);
    must_succeed(write.arg(&engine).arg(&interface).arg(root.join("THIRD-PARTY.md")).arg(&folder))?;
    println!("site: {}", folder.display());
    let length = |path: &Path| -> Result<usize, Error> {
        let bytes = fs::read(path).map_err(|source| Error::File { path: path.to_path_buf(), source })?;
        let packed = packed(&bytes);
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        println!("site: {name} of {} kB, {} kB packed with brotli", bytes.len() / 1000, packed / 1000);
        Ok(packed)
    };
    // The larger one is fetched only for a download.
    length(&interface)?;
    let packed = length(&engine)?;
    if packed > ENGINE_MOST { Err(Error::Heavy { bytes: packed, most: ENGINE_MOST }) } else { Ok(()) }
}

/// Returns the size of bytes packed with the strongest compression of a host.
fn packed(bytes: &[u8]) -> usize {
    let mut counter = Counter(0);
    let parameters = brotli::enc::BrotliEncoderParams { quality: 11, lgwin: 24, ..Default::default() };
    // Reading from memory and counting do not fail.
    let _ = brotli::BrotliCompress(&mut &*bytes, &mut counter, &parameters);
    counter.0
}

struct Counter(usize);

impl std::io::Write for Counter {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0 += bytes.len();
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// Installs the target of the compiler with rustup if it is missing.
fn target_ready(root: &Path) -> Result<(), Error> {
    if has_target(root) {
        return Ok(());
    }
    eprintln!("site: installing the target {TARGET} …");
    // rustup has printed its errors; the target may also have come with the compiler.
    must_succeed(Command::new("rustup").args(["target", "add", TARGET]).current_dir(root)).ok();
    if has_target(root) { Ok(()) } else { Err(Error::NoTarget { target: TARGET }) }
}

fn has_target(root: &Path) -> bool {
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let mut command = Command::new(compiler);
    let length = command.args(["--print", "target-libdir", "--target", TARGET]).current_dir(root).output();
    length.is_ok_and(|length| Path::new(String::from_utf8_lossy(&length.stdout).trim()).is_dir())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requires a fixed seed for random numbers drawn while building: two builds of the engine are the same bytes.
    #[test]
    fn numbers_drawn_while_building_have_a_seed() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let draws = fs::read_to_string(root.join("Cargo.lock")).unwrap().contains("name = \"const-random-macro\"");
        let settings: toml::Table = fs::read_to_string(root.join(".cargo/config.toml")).unwrap().parse().unwrap();
        let seed = settings.get("env").and_then(|env| env.get("CONST_RANDOM_SEED")).and_then(toml::Value::as_str);
        assert_eq!(seed.is_some(), draws, "the seed goes with the crate that draws");
    }

    #[test]
    fn what_repeats_is_packed() {
        assert!(packed(&[7; 100_000]) < 100);
        assert!(packed(b"") < 10);
    }
}
