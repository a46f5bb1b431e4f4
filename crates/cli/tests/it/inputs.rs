//! No file that a call reads is written, with `--force` either: each command that writes files, with each kind of file that it reads.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run;

use questions::list::LIST;
use run::root;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Question, arguments before the option of the file, the option, endings of the file, and the files that the call reads. In an
/// argument, `{x}` is the name of an input of that kind.
type WritingCall = (&'static str, &'static str, &'static str, &'static [&'static str], &'static [Kind]);

/// Commands that write a file.
const CALLS: [WritingCall; 20] = [
    ("plot", "plot {project} --figure cycle --catalogue {catalogue}", "svg", &["svg"], &OF_PROJECT),
    ("plot", "plot {project} --figure cycle --catalogue {catalogue}", "png", &["png"], &OF_PROJECT),
    ("report", "report {project} --catalogue {catalogue}", "out", &["pdf"], &OF_PROJECT),
    ("size", "size {project} --catalogue {catalogue}", "report", &["pdf"], &OF_PROJECT),
    ("export", "export {project} --table candidates --catalogue {catalogue}", "out", &["csv", "parquet"], &OF_PROJECT),
    ("moves", "moves {project} --every 2ms --catalogue {catalogue}", "out", &["csv", "parquet"], &OF_PROJECT),
    ("simulate", "simulate {project} --catalogue {catalogue}", "out", &["csv", "parquet"], &OF_PROJECT),
    ("simulate", "simulate {project} --catalogue {catalogue}", "svg", &["svg"], &OF_PROJECT),
    ("simulate", "simulate {project} --catalogue {catalogue}", "png", &["png"], &OF_PROJECT),
    ("sweep", "sweep {project} --table {table} --catalogue {catalogue}", "out", &["csv"], &OF_SWEEP),
    ("curve", "curve CHA-25A-50-H-C1024", "svg", &["svg"], &[]),
    ("curve", "curve CHA-25A-50-H-C1024", "png", &["png"], &[]),
    ("wiring", "wiring CHA-25A-50-H-C1024", "svg", &["svg"], &[]),
    ("wiring", "wiring CHA-25A-50-H-C1024", "png", &["png"], &[]),
    ("encoder --vcd", "encoder CHA-25A-50-H-C1024", "vcd", &["vcd"], &[]),
    ("upkeep --ical", "upkeep CHA-25A-50-H-C1024 --delivered 2026-01-01", "ical", &["ics"], &[]),
    ("new", "new recording --from {recording}", "out", &["csv", "toml"], &[Kind::Recording]),
    ("commission --out", "commission CHA-25A-50-H-C1024 --for sinamics", "out", &["txt"], &[]),
    ("commission --blank", "commission CHA-25A-50-H-C1024", "blank", &["toml"], &[]),
    ("commission --checklist", "commission CHA-25A-50-H-C1024", "checklist", &["pdf"], &[]),
];

/// A file that a call reads.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Project,
    /// Recording that the project names, in a folder beside its own.
    Recording,
    /// Catalogue file that the project names.
    Stock,
    /// Catalogue file of the call.
    Catalogue,
    Table,
    /// Recording that a cell of the table names.
    OfTable,
}

const OF_PROJECT: [Kind; 4] = [Kind::Project, Kind::Recording, Kind::Stock, Kind::Catalogue];
const OF_SWEEP: [Kind; 6] = [Kind::Project, Kind::Recording, Kind::Stock, Kind::Catalogue, Kind::Table, Kind::OfTable];

impl Kind {
    /// Name of the file; the one that is also the destination has the ending of that.
    fn name(self, destination: Self, ending: &str) -> String {
        let (stem, own) = match self {
            Self::Project => ("axis", "toml"),
            Self::Recording => ("runs/run", "csv"),
            Self::Stock => ("stock", "csv"),
            Self::Catalogue => ("further", "csv"),
            Self::Table => ("table", "csv"),
            Self::OfTable => ("runs/other", "csv"),
        };
        format!("{stem}.{}", if self == destination { ending } else { own })
    }
}

/// Writes the inputs of a call and returns their names.
fn inputs(folder: &Path, of: Kind, ending: &str) -> Vec<String> {
    let names = OF_SWEEP.map(|kind| kind.name(of, ending));
    let [project, recording, stock, further, table, other] = names.each_ref();
    let example = |name: &str| fs::read_to_string(root().join("examples").join(name)).unwrap();
    fs::create_dir(folder.join("runs")).unwrap();
    let text = example("robot-joint.toml").replace("robot-joint.csv", recording);
    fs::write(folder.join(project), format!("{text}\n[catalogue]\nfiles = [\"{stock}\"]\n")).unwrap();
    for name in [recording, other] {
        fs::write(folder.join(name), example("robot-joint.csv")).unwrap();
    }
    let products = example("catalogue/stock.csv");
    fs::write(folder.join(stock), &products).unwrap();
    fs::write(folder.join(further), products.replace("RD-", "RE-")).unwrap();
    fs::write(folder.join(table), format!("motion[1].file\n{recording}\n{other}\n")).unwrap();
    names.to_vec()
}

#[test]
fn no_command_writes_a_file_that_it_reads() {
    for (question, call, option, endings, kinds) in CALLS {
        for (ending, kind) in endings.iter().flat_map(|ending| kinds.iter().map(move |kind| (ending, *kind))) {
            let folder = tempfile::tempdir().unwrap();
            let names = inputs(folder.path(), kind, ending);
            let [project, recording, _, further, table, _] = &names[..] else { unreachable!() };
            let words = call.replace("{project}", project).replace("{recording}", recording);
            let words = words.replace("{catalogue}", further).replace("{table}", table);
            let of = OF_SWEEP.iter().position(|each| *each == kind).unwrap();
            let contents = || names.iter().map(|name| fs::read(folder.path().join(name)).unwrap()).collect::<Vec<_>>();
            let before = contents();
            let written = format!("--{option}");
            let output = Command::new(env!("CARGO_BIN_EXE_antrieb"))
                .args(words.split(' '))
                .args([written.as_str(), names[of].as_str(), "--force"])
                .current_dir(folder.path())
                .env_remove("ANTRIEB_LANG")
                .output()
                .unwrap();
            let err = String::from_utf8_lossy(&output.stderr);
            assert!(contents() == before, "{question}: {words} {written} {} has replaced an input: {err}", names[of]);
            assert_eq!(output.status.code(), Some(2), "{words} {written} {}: {err}", names[of]);
            // A project with the ending of a table is refused as one.
            let is_told = kind == Kind::Project && ["csv", "parquet"].contains(ending);
            assert!(is_told || err.contains("this call reads the file"), "{words} {written} {}: {err}", names[of]);
        }
    }
}

/// Every command that writes a file is in the list above, unless it reads none.
#[test]
fn every_command_that_writes_files_is_called() {
    let called: BTreeSet<(&str, &str)> = CALLS.iter().map(|(question, _, option, ..)| (*question, *option)).collect();
    let all = LIST.iter().flat_map(|entry| entry.writes.iter().map(|file| (entry.command, file.option)));
    let missing: Vec<_> = all.filter(|each| !called.contains(each)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
