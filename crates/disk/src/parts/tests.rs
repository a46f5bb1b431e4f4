use super::*;
use std::fs;

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn parts_are_kept_for_their_mark_and_removed_with_the_folder() {
    let beside = tempfile::tempdir().unwrap();
    let path = beside.path().join("out.csv.parts");
    let mut parts = Parts::open(&path).unwrap();
    assert_eq!(parts.mark(), "");
    parts.begin("one").unwrap();
    parts.write(0, b"first").unwrap();
    parts.write(0, b"again").unwrap();
    assert!(parts.has(0).unwrap() && !parts.has(1).unwrap() && parts.is_marked().unwrap());
    drop(parts);
    let mut parts = Parts::open(&path).unwrap();
    assert_eq!(parts.mark(), "one");
    let mut read = String::new();
    parts.part(0).unwrap().read_to_string(&mut read).unwrap();
    assert_eq!(read, "again");
    parts.begin("two").unwrap();
    assert!(!parts.has(0).unwrap());
    parts.write(1, b"x").unwrap();
    parts.remove();
    assert_eq!(names(beside.path()), [""; 0]);
}

#[test]
fn an_open_folder_is_refused_to_a_second_run() {
    let beside = tempfile::tempdir().unwrap();
    let path = beside.path().join("out.csv.parts");
    let first = Parts::open(&path).unwrap();
    assert!(matches!(Parts::open(&path), Err(PartsTrouble::Busy)));
    drop(first);
    assert!(Parts::open(&path).is_ok());
}

/// Simultaneous runs: each has the folder alone, and none finds it half created or half removed.
#[test]
fn runs_that_come_and_go_never_take_the_folder_for_a_strangers() {
    let beside = tempfile::tempdir().unwrap();
    let path = beside.path().join("out.csv.parts");
    let inside = std::sync::atomic::AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                for round in 0..60 {
                    match Parts::open(&path) {
                        Ok(mut parts) => {
                            assert_eq!(inside.fetch_add(1, std::sync::atomic::Ordering::SeqCst), 0, "two are inside");
                            parts.begin("x").unwrap();
                            parts.write(round, b"y").unwrap();
                            assert!(parts.is_marked().unwrap());
                            inside.fetch_sub(1, std::sync::atomic::Ordering::SeqCst);
                            parts.remove();
                        }
                        Err(PartsTrouble::Busy) => {}
                        Err(other) => panic!("{other:?}"),
                    }
                }
            });
        }
    });
    assert_eq!(names(beside.path()), [""; 0]);
}

/// An object with the name of the folder that is not from this program stays unchanged, to the last byte.
#[test]
fn what_is_foreign_is_refused_and_stays() {
    let beside = tempfile::tempdir().unwrap();
    let here = beside.path();
    let own = here.join("own");
    fs::create_dir(&own).unwrap();
    fs::write(own.join("thesis.txt"), "years").unwrap();
    fs::write(own.join(MARK), "a file of a user\n").unwrap();
    fs::create_dir(here.join("empty")).unwrap();
    fs::write(here.join("file"), "text").unwrap();
    for name in ["own", "empty", "file"] {
        assert!(matches!(Parts::open(&here.join(name)), Err(PartsTrouble::Foreign)), "{name}");
    }
    assert_eq!(names(&own), [MARK, "thesis.txt"]);
    assert_eq!(names(here), ["empty", "file", "own"]);
}

/// A file put into the folder by a user survives the removal of the parts.
#[test]
fn a_file_of_another_hand_in_the_folder_stays() {
    let beside = tempfile::tempdir().unwrap();
    let path = beside.path().join("out.csv.parts");
    let mut parts = Parts::open(&path).unwrap();
    parts.begin("x").unwrap();
    parts.write(0, b"y").unwrap();
    for name in ["notes.txt", "part-7.parquet", "part-0000000a.parquet", "sweep.bak"] {
        fs::write(path.join(name), "mine").unwrap();
    }
    fs::create_dir(path.join("deeper")).unwrap();
    parts.begin("z").unwrap();
    parts.remove();
    assert_eq!(names(&path), ["deeper", "notes.txt", "part-0000000a.parquet", "part-7.parquet", "sweep.bak"]);
    assert!(matches!(Parts::open(&path), Err(PartsTrouble::Foreign)));
}

#[cfg(unix)]
#[test]
fn no_link_is_followed_and_none_is_replaced() {
    use std::os::unix::fs::symlink;
    let beside = tempfile::tempdir().unwrap();
    let here = beside.path();
    let precious = here.join("precious.txt");
    fs::write(&precious, "years").unwrap();
    fs::create_dir(here.join("target")).unwrap();
    symlink(here.join("target"), here.join("link.parts")).unwrap();
    assert!(matches!(Parts::open(&here.join("link.parts")), Err(PartsTrouble::Foreign)));
    let path = here.join("out.csv.parts");
    for name in ["part-00000000.parquet.unfinished", "part-00000000.parquet", MARK, "sweep.unfinished", LOCK] {
        let mut parts = Parts::open(&path).unwrap();
        parts.begin("x").unwrap();
        drop(fs::remove_file(path.join(name)));
        symlink(&precious, path.join(name)).unwrap();
        let begun = parts.begin("y");
        let put = parts.write(0, b"z");
        assert!(begun.is_err() || put.is_err() || name == LOCK, "{name}");
        parts.remove();
        assert_eq!(fs::read_to_string(&precious).unwrap(), "years", "{name}");
        assert!(path.join(name).is_symlink(), "{name}");
        assert!(Parts::open(&path).is_err(), "{name}");
        fs::remove_dir_all(&path).unwrap();
    }
}

/// Another user renames the folder and puts a link in its place.
#[cfg(unix)]
#[test]
fn a_folder_that_is_exchanged_leads_nowhere_else() {
    use std::os::unix::fs::symlink;
    let beside = tempfile::tempdir().unwrap();
    let here = beside.path();
    let path = here.join("out.csv.parts");
    let mut parts = Parts::open(&path).unwrap();
    parts.begin("x").unwrap();
    let target = here.join("target");
    fs::create_dir(&target).unwrap();
    fs::write(target.join("part-00000000.parquet"), "years").unwrap();
    fs::write(target.join(MARK), written("x")).unwrap();
    fs::rename(&path, here.join("away")).unwrap();
    symlink(&target, &path).unwrap();
    parts.write(0, b"z").unwrap();
    assert!(!parts.is_marked().unwrap(), "what is at the path is not what was opened");
    parts.remove();
    assert_eq!(names(&target), ["part-00000000.parquet", MARK]);
    assert_eq!(names(&here.join("away")), [""; 0]);
}

#[cfg(unix)]
#[test]
fn the_folder_is_closed_to_others() {
    use std::os::unix::fs::PermissionsExt;
    let beside = tempfile::tempdir().unwrap();
    let path = beside.path().join("out.csv.parts");
    let mode = |path: &Path| path.metadata().unwrap().permissions().mode() & 0o777;
    drop(Parts::open(&path).unwrap());
    assert_eq!(mode(&path), 0o700);
    fs::set_permissions(&path, fs::Permissions::from_mode(0o777)).unwrap();
    drop(Parts::open(&path).unwrap());
    assert_eq!(mode(&path), 0o700);
    assert_eq!(mode(&path.join(MARK)), 0o600);
}

#[cfg(unix)]
#[test]
fn a_folder_that_a_killed_run_did_not_place_is_removed_later() {
    let beside = tempfile::tempdir().unwrap();
    let old = std::time::SystemTime::now() - std::time::Duration::from_secs(100);
    let temporary = [temporary::name(), temporary::name()].map(|name| beside.path().join(name));
    for path in &temporary {
        Dir::make(path).unwrap();
        write_whole(&Dir::open(path).unwrap(), MARK, written("").as_bytes()).unwrap();
    }
    fs::write(temporary[1].join("mine.txt"), "mine").unwrap();
    for path in &temporary {
        File::open(path).unwrap().set_modified(old).unwrap();
    }
    crate::left::clear(beside.path());
    assert!(!temporary[0].exists() && temporary[1].join("mine.txt").exists());
}

/// A file with the name of a part but without its checksum is of another hand: it is neither removed nor replaced.
#[test]
fn a_part_without_its_checksum_stays() {
    let beside = tempfile::tempdir().unwrap();
    let path = beside.path().join("best.csv.parts");
    let mut parts = Parts::open(&path).unwrap();
    parts.begin("run 1").unwrap();
    parts.write(0, b"first").unwrap();
    for index in [1, 99_999_999] {
        fs::write(path.join(name(index)), "").unwrap();
        assert!(!parts.holds(index).unwrap());
        assert!(matches!(parts.write(index, b"x"), Err(PartsTrouble::ForeignFile(found)) if found == name(index)));
    }
    parts.begin("run 2").unwrap();
    parts.write(0, b"first").unwrap();
    parts.remove();
    assert_eq!(names(&path), [name(1), name(99_999_999)]);
}

/// A part of another length than its checksum states is not read: a sparse file of 30 GB takes no time.
#[test]
fn a_part_of_another_length_is_not_read() {
    let beside = tempfile::tempdir().unwrap();
    let path = beside.path().join("best.csv.parts");
    let mut parts = Parts::open(&path).unwrap();
    parts.begin("run 1").unwrap();
    parts.write(0, b"first").unwrap();
    let file = fs::File::options().write(true).open(path.join(name(0))).unwrap();
    file.set_len(30 << 30).unwrap();
    let begun = std::time::Instant::now();
    assert!(!parts.holds(0).unwrap());
    assert!(begun.elapsed() < Duration::from_secs(1), "{:?}", begun.elapsed());
    parts.write(0, b"first").unwrap();
    assert!(parts.holds(0).unwrap());
}

/// A part that is damaged, exchanged with another, or of another run is not one of this run.
#[test]
fn a_part_is_held_as_it_was_written() {
    let beside = tempfile::tempdir().unwrap();
    let path = beside.path().join("best.csv.parts");
    let mut parts = Parts::open(&path).unwrap();
    parts.begin("run 1").unwrap();
    parts.write(0, b"first").unwrap();
    parts.write(1, b"other").unwrap();
    assert!(parts.holds(0).unwrap() && parts.holds(1).unwrap() && !parts.holds(2).unwrap());
    let file = |index: u64| path.join(name(index));
    let sum = |index: u64| path.join(sum_name(index));
    for wrong in [&b"firs"[..], b"", b"First", b"first "] {
        fs::write(file(0), wrong).unwrap();
        assert!(!parts.holds(0).unwrap(), "{wrong:?}");
    }
    fs::write(file(0), "first").unwrap();
    assert!(parts.holds(0).unwrap());
    // Exchanged with their checksums.
    for [a, b] in [[file(0), file(1)], [sum(0), sum(1)]] {
        let away = path.join("away");
        fs::rename(&a, &away).unwrap();
        fs::rename(&b, &a).unwrap();
        fs::rename(&away, &b).unwrap();
    }
    assert!(!parts.holds(0).unwrap() && !parts.holds(1).unwrap());
    parts.write(0, b"first").unwrap();
    for wrong in ["", "no checksum", &"f".repeat(64), &"x".repeat(1000)] {
        fs::write(sum(0), wrong).unwrap();
        assert!(!parts.holds(0).unwrap(), "{wrong}");
    }
    parts.write(0, b"first").unwrap();
    let of_the_first_run = [file(0), sum(0)].map(|path| fs::read(path).unwrap());
    parts.begin("run 2").unwrap();
    assert!(!parts.holds(0).unwrap());
    for (path, bytes) in [file(0), sum(0)].iter().zip(&of_the_first_run) {
        fs::write(path, bytes).unwrap();
    }
    assert!(!parts.holds(0).unwrap());
    parts.write(0, b"first").unwrap();
    assert!(parts.holds(0).unwrap());
    parts.remove();
    assert_eq!(names(beside.path()), [""; 0]);
}
