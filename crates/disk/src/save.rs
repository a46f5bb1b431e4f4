//! Writing of files: completely or not at all, at the given path only.

use crate::unfinished::Unfinished;
use crate::{left, path_text, temporary};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};
use words::SaveTrouble;

/// A file that could not be written.
#[derive(Debug)]
pub struct Unwritten {
    /// Path as given.
    pub path: PathBuf,
    /// Reason.
    pub trouble: SaveTrouble,
}

/// Destination of a file.
struct Destination<'p> {
    /// Path as given by the user.
    asked: &'p Path,
    target: PathBuf,
    exists: bool,
}

impl Destination<'_> {
    /// Renames the written file to its destination.
    fn keep(&self, file: NamedTempFile, force: bool) -> Result<(), Unwritten> {
        let kept = if force { file.persist(&self.target) } else { file.persist_noclobber(&self.target) };
        kept.map(drop).map_err(|fault| {
            let exists = fault.error.kind() == ErrorKind::AlreadyExists;
            unwritten(self.asked, if exists { SaveTrouble::Exists } else { system(&fault.error) })
        })
    }
}

/// Writes files, each next to its destination first and then renamed. Nothing is renamed before all are written. An
/// existing file is kept unless `force` is set, and an input is never replaced. A replaced file keeps its mode and
/// owner.
///
/// A signal that ends the program also removes unfinished files, if [`crate::end_on_signals`] is active.
///
/// # Errors
/// The first file that cannot be written, with the reason.
pub fn save(files: &[(&Path, &[u8])], inputs: &[PathBuf], force: bool) -> Result<(), Unwritten> {
    let places = places(files.iter().map(|(path, _)| *path), inputs, force)?;
    places.iter().filter_map(|place| place.target.parent()).for_each(left::clear);
    let unfinished = Unfinished;
    let mut staged: Vec<(NamedTempFile, &Destination<'_>)> = Vec::new();
    for (place, (_, bytes)) in places.iter().zip(files) {
        let file = stage(place, bytes, &unfinished).map_err(|error| unwritten(place.asked, system(&error)))?;
        staged.push((file, place));
    }
    // From here on nothing interrupts: all files are the new ones, or none.
    let renaming = unfinished.hold();
    for (file, place) in staged {
        place.keep(file, force)?;
    }
    drop(renaming);
    Ok(())
}

/// Writes one file like [`save`], but piece by piece, for content too large for the memory.
///
/// # Errors
/// The reason why the file cannot be written; errors returned by `write`.
pub fn save_by<E>(
    path: &Path,
    inputs: &[PathBuf],
    force: bool,
    write: impl FnOnce(&mut std::fs::File) -> Result<(), E>,
) -> Result<(), Unsaved<E>> {
    let places = places(std::iter::once(path), inputs, force).map_err(Unsaved::Unwritten)?;
    let Some(place) = places.first() else { return Ok(()) };
    place.target.parent().into_iter().for_each(left::clear);
    let unfinished = Unfinished;
    let failed = |error: &std::io::Error| Unsaved::Unwritten(unwritten(place.asked, system(error)));
    let mut file = begin(place, &unfinished).map_err(|error| failed(&error))?;
    write(file.as_file_mut()).map_err(Unsaved::Other)?;
    finish(place, &file, &unfinished).map_err(|error| failed(&error))?;
    let renaming = unfinished.hold();
    place.keep(file, force).map_err(Unsaved::Unwritten)?;
    drop(renaming);
    Ok(())
}

/// Reason why a file is not written.
#[derive(Debug)]
pub enum Unsaved<E> {
    /// The file cannot be written.
    Unwritten(Unwritten),
    /// The content could not be produced.
    Other(E),
}

/// Checks if files can be written, before the work for them begins.
///
/// # Errors
/// The first file that cannot be written, with the reason.
pub fn ready(files: &[&Path], inputs: &[PathBuf], force: bool) -> Result<(), Unwritten> {
    places(files.iter().copied(), inputs, force).map(drop)
}

fn unwritten(path: &Path, trouble: SaveTrouble) -> Unwritten {
    Unwritten { path: path.to_owned(), trouble }
}

/// Converts an error of the system. Its text may contain the name of the temporary file, so only the kind is reported.
fn system(error: &std::io::Error) -> SaveTrouble {
    match error.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => SaveTrouble::NoFolder,
        kind => SaveTrouble::System((&std::io::Error::from(kind)).into()),
    }
}

/// Determines the destination of each file before anything is written.
fn places<'p>(
    paths: impl Iterator<Item = &'p Path>,
    inputs: &[PathBuf],
    force: bool,
) -> Result<Vec<Destination<'p>>, Unwritten> {
    let mut places: Vec<Destination<'p>> = Vec::new();
    for asked in paths {
        let place = place(asked, force).map_err(|trouble| unwritten(asked, trouble))?;
        let is = |other: &Path| other == place.target || is_same_file(other, &place.target);
        if inputs.iter().any(|input| input.canonicalize().is_ok_and(|input| is(&input))) {
            return Err(unwritten(asked, SaveTrouble::IsInput));
        }
        if places.iter().any(|other| is(&other.target)) {
            return Err(unwritten(asked, SaveTrouble::Twice));
        }
        if place.exists && !force {
            return Err(unwritten(asked, SaveTrouble::Exists));
        }
        places.push(place);
    }
    Ok(places)
}

/// Returns `true` if two paths are one file. Neither is opened: a pipe would block.
#[cfg(unix)]
fn is_same_file(one: &Path, other: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |path: &Path| path.metadata().ok().map(|about| (about.dev(), about.ino()));
    identity(one).is_some_and(|found| Some(found) == identity(other))
}

#[cfg(not(unix))]
fn is_same_file(one: &Path, other: &Path) -> bool {
    same_file::is_same_file(one, other).unwrap_or(false)
}

fn place(asked: &Path, force: bool) -> Result<Destination<'_>, SaveTrouble> {
    if asked.as_os_str() == "-" {
        return Err(SaveTrouble::NotToStdout);
    }
    let folder = match asked.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let folder = folder.canonicalize().map_err(|error| system(&error))?;
    let Some(name) = asked.file_name() else { return Err(system(&ErrorKind::IsADirectory.into())) };
    let plain = folder.join(name);
    let Ok(own) = plain.symlink_metadata() else { return Ok(Destination { asked, target: plain, exists: false }) };
    // What a link points to need not be what this program wrote, wherever it lies.
    if own.is_symlink() {
        return Err(SaveTrouble::IsLink {
            target: plain.read_link().map_or_else(|_| String::new(), |to| path_text(&to)),
        });
    }
    if own.is_dir() {
        return Err(system(&ErrorKind::IsADirectory.into()));
    }
    if !own.is_file() {
        return Err(SaveTrouble::NoRegularFile);
    }
    // The mode is checked, not the system: it permits the superuser to write files that he protected himself.
    if force && own.permissions().readonly() {
        return Err(SaveTrouble::WriteProtected);
    }
    Ok(Destination { asked, target: plain, exists: true })
}

fn stage(place: &Destination<'_>, bytes: &[u8], unfinished: &Unfinished) -> std::io::Result<NamedTempFile> {
    let mut file = begin(place, unfinished)?;
    file.write_all(bytes)?;
    finish(place, &file, unfinished)?;
    Ok(file)
}

/// Creates a file next to its destination that no other user may read before it is complete. It is locked while this
/// program writes it.
fn begin(place: &Destination<'_>, unfinished: &Unfinished) -> std::io::Result<NamedTempFile> {
    let folder = place.target.parent().unwrap_or(Path::new("."));
    let file = unfinished.made(|| temporary(folder, |_| {}))?;
    #[cfg(unix)]
    // On a file system without locks the age of a file alone identifies leftovers.
    drop(file.as_file().try_lock());
    Ok(file)
}

/// Creates a file with a new temporary name.
fn temporary(folder: &Path, with: impl Fn(&mut Builder<'_, '_>)) -> std::io::Result<NamedTempFile> {
    loop {
        let name = temporary::name();
        let mut builder = Builder::new();
        builder.prefix(&name).rand_bytes(0);
        with(&mut builder);
        match builder.tempfile_in(folder) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            made => return made,
        }
    }
}

/// Writes a file to disk with the mode of its destination.
fn finish(place: &Destination<'_>, file: &NamedTempFile, unfinished: &Unfinished) -> std::io::Result<()> {
    if place.exists {
        keep(file.as_file(), &place.target)?;
    } else {
        as_any_other(place, file.as_file(), unfinished)?;
    }
    file.as_file().sync_all()
}

/// Sets the mode of any other new file in the folder, subject to the user's mask, as found on a file created for this
/// purpose.
#[cfg(unix)]
fn as_any_other(place: &Destination<'_>, file: &std::fs::File, unfinished: &Unfinished) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    let folder = place.target.parent().unwrap_or(Path::new("."));
    let waiting = unfinished.hold();
    let other = temporary(folder, |builder| {
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    })?;
    let mode = other.as_file().metadata()?.permissions().mode() & 0o666;
    drop(other);
    drop(waiting);
    file.set_permissions(std::fs::Permissions::from_mode(mode))
}

#[cfg(not(unix))]
fn as_any_other(_: &Destination<'_>, _: &std::fs::File, _: &Unfinished) -> std::io::Result<()> {
    Ok(())
}

/// Sets the mode of the replaced file, and its owner if the system permits.
#[cfg(unix)]
fn keep(file: &std::fs::File, replaced: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::{MetadataExt, fchown};
    let about = replaced.metadata()?;
    let ours = file.metadata()?;
    if (about.uid(), about.gid()) != (ours.uid(), ours.gid()) {
        // Without the right to change the owner the file keeps its own; the mode is set anyway.
        let _ = fchown(file, Some(about.uid()), Some(about.gid()));
    }
    file.set_permissions(about.permissions())
}

#[cfg(not(unix))]
fn keep(file: &std::fs::File, replaced: &Path) -> std::io::Result<()> {
    file.set_permissions(replaced.metadata()?.permissions())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_and_nothing_else_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.svg");
        for text in ["one", "two"] {
            save(&[(&path, text.as_bytes())], &[], true).unwrap();
            assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
        }
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn of_two_files_none_is_written_if_one_cannot_be() {
        let folder = tempfile::tempdir().unwrap();
        let (good, bad) = (folder.path().join("a.svg"), folder.path().join("none/a.png"));
        let fault = save(&[(&good, b"x"), (&bad, b"y")], &[], true).unwrap_err();
        assert_eq!((fault.path, fault.trouble), (bad, SaveTrouble::NoFolder));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    /// A link is neither followed nor replaced, wherever it points.
    #[cfg(unix)]
    #[test]
    fn a_link_is_not_written() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("thesis.md");
        std::fs::write(&target, "a year of work").unwrap();
        for (name, to) in [("a.csv", "thesis.md"), ("b.csv", "nothing.md"), ("c.csv", "/dev/null")] {
            let link = folder.path().join(name);
            symlink(to, &link).unwrap();
            for force in [false, true] {
                let fault = save(&[(&link, b"x")], &[], force).unwrap_err();
                assert_eq!((fault.path, fault.trouble), (link.clone(), SaveTrouble::IsLink { target: to.to_owned() }));
            }
            assert!(link.is_symlink());
        }
        assert_eq!(std::fs::read_to_string(&target).unwrap(), "a year of work");
    }

    /// A partly written file is readable by its owner only; a complete one has the mode of any other new file, or of
    /// the one it replaces.
    #[cfg(unix)]
    #[test]
    fn others_may_read_a_file_when_it_is_whole() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let mode = |path: &Path| path.metadata().unwrap().permissions().mode() & 0o777;
        let plain = folder.path().join("plain");
        std::fs::write(&plain, "x").unwrap();
        let (new, replaced) = (folder.path().join("new.csv"), folder.path().join("replaced.csv"));
        std::fs::write(&replaced, "old").unwrap();
        std::fs::set_permissions(&replaced, std::fs::Permissions::from_mode(0o664)).unwrap();
        for path in [&new, &replaced] {
            save_by::<()>(path, &[], true, |file| {
                file.write_all(b"half").unwrap();
                let hidden = std::fs::read_dir(folder.path()).unwrap().flatten();
                let hidden: Vec<_> =
                    hidden.filter(|entry| entry.file_name().to_string_lossy().starts_with('.')).collect();
                assert_eq!(hidden.len(), 1);
                assert_eq!(mode(&hidden[0].path()), 0o600);
                Ok(())
            })
            .unwrap();
        }
        assert_eq!((mode(&new), mode(&replaced)), (mode(&plain), 0o664));
    }
}
