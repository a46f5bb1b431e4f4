//! Writes every sample as PDF and its pages as PNG into a folder:
//! `cargo run -p report --features png --example sample -- FOLDER [NAME [FIGURES]]`, where FIGURES is a folder of SVG
//! files named by their id.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stdout,
    clippy::indexing_slicing,
    unreachable_pub,
    reason = "a tool for whoever works on the template"
)]

#[path = "../tests/samples/mod.rs"]
mod samples;

use std::time::Instant;

fn drawn(folder: &str) -> Vec<report::Figure> {
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let figure = |path: &std::path::PathBuf| report::Figure {
        name: path.file_stem().unwrap().to_string_lossy().into_owned(),
        svg: std::fs::read_to_string(path).unwrap(),
        caption: path.file_name().unwrap().to_string_lossy().into_owned(),
        alternative_text: String::new(),
    };
    paths.iter().map(figure).collect()
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let folder = std::path::PathBuf::from(arguments.next().expect("a folder"));
    let only = arguments.next();
    let figures = arguments.next().map(|folder| drawn(&folder));
    std::fs::create_dir_all(&folder).expect("a folder that can be made");
    for (name, answers, project, language) in samples::SAMPLES {
        if only.as_ref().is_some_and(|only| only != name) {
            continue;
        }
        let mut content = samples::content(answers, project, language);
        if let Some(figures) = &figures {
            content.figures.clone_from(figures);
        }
        let begin = Instant::now();
        let bytes = report::pdf(&content, &samples::settings()).unwrap();
        println!("{name}: {} ms, {} kB", begin.elapsed().as_millis(), bytes.len() / 1000);
        std::fs::write(folder.join(format!("{name}.pdf")), bytes).unwrap();
        for (index, page) in report::pages_png(&content, &samples::settings(), 1.4).unwrap().iter().enumerate() {
            std::fs::write(folder.join(format!("{name}-{:02}.png", index + 1)), page).unwrap();
        }
    }
    if only.is_none_or(|only| only == "mechanisms") {
        for (kind, keys) in samples::MECHANISMS {
            let content = samples::mechanism(kind, keys, quantities::Language::De);
            let pages = report::pages_png(&content, &samples::settings(), 1.0).unwrap();
            std::fs::write(folder.join(format!("mechanism-{kind}.png")), &pages[1]).unwrap();
        }
    }
}
