//! Storage of the corpora: one file per target, one line per case, its bytes in base64, the lines sorted by these
//! bytes. A change of a corpus is thus a diff of its cases, and the same cases give the same file.
//!
//! libFuzzer reads folders: [`unpack`] creates one, [`pack`] writes its content back to the file.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::listed;
use crate::Error;

/// Writes each case of a corpus to its own file, in a folder emptied before.
///
/// # Errors
/// The corpus or the folder cannot be read or written, or a line is not base64.
pub(super) fn unpack(corpus: &Path, folder: &Path) -> Result<(), Error> {
    let failed = |path: &Path| {
        let path = path.to_path_buf();
        move |source| Error::File { path, source }
    };
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(failed(folder))?;
    }
    fs::create_dir_all(folder).map_err(failed(folder))?;
    let text = if corpus.exists() { fs::read_to_string(corpus).map_err(failed(corpus))? } else { String::new() };
    for (number, line) in (1..).zip(text.lines()) {
        let place = || format!("{}:{number}", corpus.display());
        let case = STANDARD.decode(line).map_err(|error| Error::Word { word: place(), why: error.to_string() })?;
        let path = folder.join(format!("{number:05}"));
        fs::write(&path, case).map_err(failed(&path))?;
    }
    Ok(())
}

/// Writes the cases of a folder as a corpus without duplicates, and returns their number.
///
/// # Errors
/// A case or the corpus cannot be read or written.
pub(super) fn pack(folder: &Path, corpus: &Path) -> Result<usize, Error> {
    let read = |path: &Path| fs::read(path).map_err(|source| Error::File { path: path.to_path_buf(), source });
    let cases: BTreeSet<Vec<u8>> = listed(folder).iter().map(|path| read(path)).collect::<Result<_, _>>()?;
    let text: String = cases.iter().map(|case| STANDARD.encode(case) + "\n").collect();
    fs::write(corpus, text).map_err(|source| Error::File { path: corpus.to_path_buf(), source })?;
    Ok(cases.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_corpus_survives_the_folder() {
        let desk = std::env::temp_dir().join(format!("antrieb-corpus-{}", std::process::id()));
        let (packed, folder) = (desk.join("code.txt"), desk.join("code"));
        fs::create_dir_all(&desk).unwrap();
        let text = "\nAP8=\nYQ==\n";
        fs::write(&packed, text).unwrap();
        unpack(&packed, &folder).unwrap();
        let cases: Vec<Vec<u8>> = listed(&folder).iter().map(|path| fs::read(path).unwrap()).collect();
        assert_eq!(cases, [vec![], vec![0, 255], vec![b'a']]);
        fs::write(folder.join("found"), "a").unwrap();
        assert_eq!(pack(&folder, &packed).unwrap(), 3);
        assert_eq!(fs::read_to_string(&packed).unwrap(), text);
        fs::write(&packed, "no base64").unwrap();
        assert!(unpack(&packed, &folder).unwrap_err().to_string().contains("code.txt:1"));
        fs::remove_dir_all(&desk).unwrap();
    }
}
