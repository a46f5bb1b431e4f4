//! Writes the folder of the page without a server; `cargo xtask site` builds the engine and calls it.

use std::io::{Error, ErrorKind, Result};
use std::path::{Path, PathBuf};

/// `site ENGINE INTERFACE NOTICES FOLDER`
fn main() -> Result<()> {
    let words: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [engine, interface, notices, folder] = &words[..] else { return Err(Error::from(ErrorKind::InvalidInput)) };
    let engines = [std::fs::read(engine)?, std::fs::read(interface)?];
    for (name, bytes) in site::files(engines.each_ref().map(Vec::as_slice), &std::fs::read_to_string(notices)?)? {
        let path: &Path = &folder.join(name);
        std::fs::create_dir_all(path.parent().unwrap_or(folder))?;
        std::fs::write(path, bytes)?;
    }
    Ok(())
}
