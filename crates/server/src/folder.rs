//! The working folder: project files by name, and the recordings that they name; no access outside of it.

use axis::{Catalogue, Files, Grant, Reach};
use disk::{KeepingFiles, Links, ProjectFiles, Unwritten, read_file};
use page::{
    FileEntry, Folder, Press, SaveFault, Shell, WritesChecklist, WritesReport, is_project_name, recording_names,
};
use project::PROJECT_MAX_BYTES;
use questions::Progress;
use std::collections::BTreeMap;
use std::io::{Error, ErrorKind, Result};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, SystemTime, UNIX_EPOCH};
use words::SaveTrouble;

/// Largest number of listed project files.
const LISTED_MOST: usize = 1000;

/// Largest number of entries of a folder that are read.
const LOOKED_AT_MOST: usize = 20_000;

/// Seconds of a day.
const DAY_S: u64 = 86_400;

/// Resources of this machine for the page.
pub(crate) struct Workplace {
    files: KeepingFiles,
    time: Duration,
    press: Option<Press>,
    /// Lock for one save at a time: between the comparison with the old version and the new file, no other save of this
    /// server intervenes.
    saving: Mutex<()>,
    /// Running works with a name, at most as many as admitted requests.
    works: Mutex<BTreeMap<String, Arc<Progress>>>,
}

/// Largest number of bytes of the name of a work.
const WORK_NAME_MOST: usize = 64;

impl Workplace {
    /// Creates the resources of a folder, with limits of memory for the recordings of a project and of time for an
    /// answer.
    pub(crate) fn new(folder: PathBuf, memory: u64, time: Duration, press: Option<Press>) -> Self {
        let grant = Grant { memory, reach: Reach::Folder };
        Self {
            files: KeepingFiles::new(ProjectFiles { folder, links: Links::Inside, grant }),
            time,
            press,
            saving: Mutex::new(()),
            works: Mutex::default(),
        }
    }

    /// Registers a running work under a name; returns `false` if the name is invalid or belongs to another running
    /// work.
    pub(crate) fn begun(&self, name: &str, progress: &Arc<Progress>) -> bool {
        let is_name = (1..=WORK_NAME_MOST).contains(&name.len())
            && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'-');
        let mut works = self.works.lock().unwrap_or_else(PoisonError::into_inner);
        let is_free = is_name && !works.contains_key(name);
        if is_free {
            let _ = works.insert(name.to_owned(), Arc::clone(progress));
        }
        is_free
    }

    /// Removes a work that has ended.
    pub(crate) fn ended(&self, name: &str) {
        let _ = self.works.lock().unwrap_or_else(PoisonError::into_inner).remove(name);
    }

    fn work(&self, name: &str) -> Option<Arc<Progress>> {
        self.works.lock().unwrap_or_else(PoisonError::into_inner).get(name).cloned()
    }
}

impl Shell for Workplace {
    fn files(&self) -> &dyn Files {
        &self.files
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn folder(&self) -> Option<&dyn Folder> {
        Some(self)
    }

    fn time_limit(&self) -> Option<Duration> {
        Some(self.time)
    }

    fn progress(&self, work: &str) -> Option<(usize, Option<usize>)> {
        Some(self.work(work)?.progress())
    }

    fn cancel(&self, work: &str) -> bool {
        self.work(work).is_some_and(|progress| {
            progress.cancel();
            true
        })
    }

    fn days_since_1970(&self) -> Option<u64> {
        Some(SystemTime::now().duration_since(UNIX_EPOCH).ok()?.as_secs() / DAY_S)
    }

    fn report(&self) -> Option<WritesReport> {
        Some(self.press?.report)
    }

    fn checklist(&self) -> Option<WritesChecklist> {
        Some(self.press?.checklist)
    }

    fn version(&self, bytes: &[u8]) -> String {
        blake3::hash(bytes).to_hex().to_string()
    }
}

impl Folder for Workplace {
    fn list(&self) -> Result<Vec<FileEntry>> {
        let mut found = Vec::new();
        for entry in std::fs::read_dir(&self.files.files.folder)?.take(LOOKED_AT_MOST).flatten() {
            let Ok(name) = entry.file_name().into_string() else { continue };
            if !is_project_name(&name) {
                continue;
            }
            let Ok(about) = self.files.files.regular(&name).and_then(|path| path.metadata()) else { continue };
            let modified = about.modified().ok().and_then(|time| time.duration_since(UNIX_EPOCH).ok());
            found.push(FileEntry { name, modified_s: modified.map_or(0, |time| time.as_secs()) });
        }
        found.sort_by(|a, b| b.modified_s.cmp(&a.modified_s).then_with(|| a.name.cmp(&b.name)));
        found.truncate(LISTED_MOST);
        Ok(found)
    }

    fn read(&self, name: &str) -> Result<Vec<u8>> {
        if !is_project_name(name) {
            return Err(ErrorKind::NotFound.into());
        }
        let bytes = read_file(&self.files.files.regular(name)?, PROJECT_MAX_BYTES)?;
        if bytes.len() > PROJECT_MAX_BYTES { Err(ErrorKind::FileTooLarge.into()) } else { Ok(bytes) }
    }

    fn save(&self, name: &str, text: &[u8], known: Option<&str>) -> std::result::Result<(), SaveFault> {
        if !is_project_name(name) {
            return Err(SaveFault::Name);
        }
        if text.len() > PROJECT_MAX_BYTES {
            return Err(SaveFault::Disk(ErrorKind::FileTooLarge.into()));
        }
        let _alone = self.saving.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = known {
            let is_known = match self.read(name) {
                Ok(there) => blake3::hash(&there).to_hex().as_str() == known,
                Err(error) if error.kind() == ErrorKind::NotFound => false,
                Err(error) => return Err(SaveFault::Disk(error)),
            };
            if !is_known {
                return Err(SaveFault::Changed);
            }
        }
        let path = self.files.files.folder.join(name);
        // A file without a known version must be a new one.
        disk::save(&[(&path, text)], &[], known.is_some()).map_err(why)
    }

    fn keep(&self, name: &str, bytes: &[u8]) -> std::result::Result<String, SaveFault> {
        let names = recording_names(name).ok_or(SaveFault::Name)?;
        let _alone = self.saving.lock().unwrap_or_else(PoisonError::into_inner);
        for name in names {
            let path = self.files.files.folder.join(&name);
            match disk::save(&[(&path, bytes)], &[], false).map_err(why) {
                Ok(()) => return Ok(name),
                // An identical recording is not written again.
                Err(SaveFault::Changed) => {
                    let there = self.files.files.regular(&name).and_then(|path| read_file(&path, bytes.len()));
                    let there = there.map_err(SaveFault::Disk)?;
                    if there == bytes {
                        return Ok(name);
                    }
                }
                Err(fault) => return Err(fault),
            }
        }
        Err(SaveFault::Disk(ErrorKind::AlreadyExists.into()))
    }
}

fn why(unwritten: Unwritten) -> SaveFault {
    match unwritten.trouble {
        SaveTrouble::Exists => SaveFault::Changed,
        SaveTrouble::WriteProtected => SaveFault::Disk(ErrorKind::PermissionDenied.into()),
        SaveTrouble::NoFolder => SaveFault::Disk(ErrorKind::NotFound.into()),
        SaveTrouble::System(trouble) => SaveFault::Disk(Error::from(trouble.kind)),
        _ => SaveFault::Name,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn workplace(folder: &std::path::Path) -> Workplace {
        Workplace::new(folder.to_owned(), 1 << 20, Duration::from_secs(1), None)
    }

    fn version(text: &[u8]) -> String {
        blake3::hash(text).to_hex().to_string()
    }

    #[test]
    fn a_recording_is_kept_and_another_of_its_name_beside_it() {
        let folder = tempfile::tempdir().unwrap();
        let place = workplace(folder.path());
        let kept = |name: &str, bytes: &[u8]| place.keep(name, bytes).ok();
        assert_eq!(kept("run.csv", b"a").as_deref(), Some("run.csv"));
        assert_eq!(kept("run.csv", b"a").as_deref(), Some("run.csv"));
        assert_eq!(kept("run.csv", b"b").as_deref(), Some("run-2.csv"));
        assert_eq!(std::fs::read(folder.path().join("run.csv")).unwrap(), b"a");
        for name in ["", "run", ".csv", "../run.csv", "a/b.csv", "run.toml", ".hidden.csv", "a\\b.csv", "\u{202e}.csv"]
        {
            assert!(matches!(place.keep(name, b"x"), Err(SaveFault::Name)), "{name}");
        }
    }

    #[test]
    fn a_version_that_is_not_there_any_more_is_left_as_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let place = workplace(folder.path());
        place.save("axis.toml", b"one", None).unwrap();
        assert!(matches!(place.save("axis.toml", b"two", None), Err(SaveFault::Changed)));
        place.save("axis.toml", b"two", Some(&version(b"one"))).unwrap();
        assert!(matches!(place.save("axis.toml", b"three", Some(&version(b"one"))), Err(SaveFault::Changed)));
        assert!(matches!(place.save("new.toml", b"x", Some(&version(b"x"))), Err(SaveFault::Changed)));
        assert_eq!(place.read("axis.toml").unwrap(), b"two");
        let names: Vec<String> = place.list().unwrap().into_iter().map(|entry| entry.name).collect();
        assert_eq!(names, ["axis.toml"]);
    }

    /// Two users have opened the same version: one saves, the other receives a message.
    #[test]
    fn of_two_who_save_one_gets_the_conflict() {
        let folder = tempfile::tempdir().unwrap();
        let place = workplace(folder.path());
        for round in 0..50_u8 {
            let name = format!("{round}.toml");
            place.save(&name, b"old", None).unwrap();
            let saved = std::thread::scope(|scope| {
                let saves = [b"left ", b"right"].map(|text| {
                    let (place, name) = (&place, &name);
                    scope.spawn(move || place.save(name, text, Some(&version(b"old"))).is_ok())
                });
                saves.map(|save| save.join().unwrap())
            });
            assert_eq!(saved.iter().filter(|saved| **saved).count(), 1, "{saved:?}");
            let expected: &[u8] = if saved[0] { b"left " } else { b"right" };
            assert_eq!(place.read(&name).unwrap(), expected);
        }
    }

    #[test]
    fn names_stay_in_the_folder() {
        for name in ["axis.toml", "Achse 1.toml", "größe.toml", "a.b.toml"] {
            assert!(is_project_name(name), "{name}");
        }
        let long = "x".repeat(300) + ".toml";
        for name in [
            "",
            ".toml",
            "axis",
            "axis.txt",
            "../axis.toml",
            "/axis.toml",
            "a/b.toml",
            "a\\b.toml",
            "c:axis.toml",
            ".hidden.toml",
            "axis\0.toml",
            "a\n.toml",
            "\u{202e}a.toml",
            "axis.toml/",
            "axis.TOML",
            &long,
        ] {
            assert!(!is_project_name(name), "{name:?}");
            let folder = tempfile::tempdir().unwrap();
            let place = workplace(folder.path());
            assert!(matches!(place.save(name, b"x", None), Err(SaveFault::Name)), "{name:?}");
            assert_eq!(place.read(name).unwrap_err().kind(), ErrorKind::NotFound, "{name:?}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn links_that_lead_away_pipes_and_devices_are_no_project_files() {
        use std::os::unix::fs::symlink;
        let (folder, away) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        let place = workplace(folder.path());
        std::fs::write(away.path().join("far.toml"), "secret").unwrap();
        symlink(away.path().join("far.toml"), folder.path().join("link.toml")).unwrap();
        symlink("/dev/zero", folder.path().join("zero.toml")).unwrap();
        symlink("nothing", folder.path().join("none.toml")).unwrap();
        std::fs::create_dir(folder.path().join("folder.toml")).unwrap();
        let pipe = folder.path().join("pipe.toml");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        for name in ["link.toml", "zero.toml", "none.toml", "folder.toml", "pipe.toml"] {
            assert!(place.read(name).is_err(), "{name}");
            assert!(place.save(name, b"x", None).is_err(), "{name}");
            assert!(place.save(name, b"x", Some(&version(b"secret"))).is_err(), "{name}");
        }
        assert!(place.list().unwrap().is_empty());
        assert_eq!(std::fs::read(away.path().join("far.toml")).unwrap(), b"secret");
    }

    /// Environment variable that makes this program save until it is killed; it holds the size of the text.
    const SAVER: &str = "ANTRIEB_TEST_SAVES_IN";

    /// Returns a text long enough that writing it takes a measurable time.
    fn text(sign: u8) -> Vec<u8> {
        vec![sign; 200_000]
    }

    /// The second process of the test below, which saves from the version that it finds; without its variable it does
    /// nothing.
    #[test]
    fn saves_until_it_is_killed() {
        let Some(folder) = std::env::var_os(SAVER) else { return };
        let place = workplace(std::path::Path::new(&folder));
        let mut there = place.read("axis.toml").unwrap();
        let first = there.first().copied().unwrap();
        for sign in (b'a'..=b'z').cycle().skip_while(|sign| *sign != first).skip(1) {
            place.save("axis.toml", &text(sign), Some(&version(&there))).unwrap();
            there = text(sign);
        }
    }

    /// Simulates a thousand power failures during a save: two at a time, each with its own folder.
    #[cfg(unix)]
    #[test]
    fn a_thousand_kills_in_the_midst_of_saves_leave_whole_files() {
        const KILLS: usize = 1000;
        const AT_ONCE: usize = 4;
        std::thread::scope(|scope| {
            for turn in 0..AT_ONCE {
                scope.spawn(move || kill(KILLS / AT_ONCE, turn));
            }
        });
    }

    /// Returns the number of the file; every save creates a new one.
    #[cfg(unix)]
    fn number(folder: &std::path::Path) -> u64 {
        use std::os::unix::fs::MetadataExt;
        std::fs::metadata(folder.join("axis.toml")).unwrap().ino()
    }

    #[cfg(unix)]
    fn kill(kills: usize, turn: usize) {
        let folder = tempfile::tempdir().unwrap();
        let place = workplace(folder.path());
        place.save("axis.toml", &text(b'a'), None).unwrap();
        for round in 0..kills {
            let before = number(folder.path());
            let mut child = std::process::Command::new(std::env::current_exe().unwrap())
                .args(["folder::tests::saves_until_it_is_killed", "--exact"])
                .env(SAVER, folder.path())
                .stdout(std::process::Stdio::null())
                .stderr(std::process::Stdio::null())
                .spawn()
                .unwrap();
            // The process now saves repeatedly: each is killed at a different moment of that.
            while number(folder.path()) == before && child.try_wait().unwrap().is_none() {
                std::thread::sleep(Duration::from_millis(1));
            }
            std::thread::sleep(Duration::from_micros(((round * 7 + turn * 3) % 23) as u64 * 150));
            assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
            child.kill().unwrap();
            child.wait().unwrap();
            let found = place.read("axis.toml").unwrap();
            let sign = found[0];
            assert!(found == text(sign), "a file of {} bytes", found.len());
        }
        // The next save removes the unfinished files of the killed processes.
        let last = place.read("axis.toml").unwrap();
        place.save("axis.toml", b"end", Some(&version(&last))).unwrap();
        assert_eq!(place.read("axis.toml").unwrap(), b"end");
    }
}
