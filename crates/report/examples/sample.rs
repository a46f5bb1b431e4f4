//! Writes every sample as PDF and its pages as PNG into a folder:
//! `cargo run -p report --features png --example sample -- FOLDER [NAME [full]]`; a NAME that is no sample is the path of a
//! project without recordings, and NAME:de and NAME:en select the language.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stdout,
    clippy::indexing_slicing,
    unreachable_pub,
    reason = "a tool for whoever works on the template"
)]

#[path = "../tests/it/samples/mod.rs"]
mod samples;

use quantities::Language;
use report::Content;
use std::time::Instant;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let folder = std::path::PathBuf::from(arguments.next().expect("a folder"));
    let only = arguments.next();
    let full = arguments.next().is_some_and(|word| word == "full");
    std::fs::create_dir_all(&folder).expect("a folder that can be made");
    let mut reports: Vec<(String, Content)> = Vec::new();
    for sample in samples::SAMPLES {
        if only.as_ref().is_none_or(|only| only == sample.name) {
            reports.push((sample.name.to_owned(), samples::content(sample)));
        }
    }
    if let (Some(path), true) = (&only, reports.is_empty()) {
        let (path, language) = match path.rsplit_once(':') {
            Some((path, "de")) => (path, Language::De),
            Some((path, _)) => (path, Language::En),
            None => (path.as_str(), Language::En),
        };
        let name = std::path::Path::new(path).file_stem().unwrap().to_string_lossy().into_owned();
        let text = std::fs::read_to_string(path).unwrap();
        reports.push((name, samples::made(&text, None, language, true)));
    }
    let settings = if full { samples::full() } else { samples::settings() };
    for (name, content) in reports {
        let begin = Instant::now();
        let bytes = report::pdf(&content, &settings).unwrap();
        println!("{name}: {} ms, {} kB", begin.elapsed().as_millis(), bytes.len() / 1000);
        std::fs::write(folder.join(format!("{name}.pdf")), bytes).unwrap();
        for (index, page) in report::pages_png(&content, &settings, 1.4).unwrap().iter().enumerate() {
            std::fs::write(folder.join(format!("{name}-{:02}.png", index + 1)), page).unwrap();
        }
    }
}
