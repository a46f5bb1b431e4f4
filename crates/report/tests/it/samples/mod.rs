//! Reports of the examples of this repository, made with the workbench of today. Shared by the tests and the example that
//! draws pages.

#![allow(dead_code, missing_docs, unreachable_pub, reason = "two users, each with a part of it")]
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a sample that cannot be made shall fail")]

pub mod read;

use axis::AxisProject;
use figures::{By, Style, Theme};
use quantities::Language;
use questions::{Candidate, Sampling, Sizing};
use report::{AxisContent, Content, Diagram, DiagramPlace, Settings};
use std::io::Read;

/// A project to report on.
#[derive(Clone, Copy)]
pub struct Sample {
    pub name: &'static str,
    pub text: &'static str,
    /// The actuator; without it the best of the catalogue.
    pub code: Option<&'static str>,
    pub language: Language,
}

macro_rules! sample {
    ($name:literal, $file:literal, $code:expr, $language:ident) => {
        Sample {
            name: $name,
            text: include_str!(concat!("../../../../../examples/", $file, ".toml")),
            code: $code,
            language: Language::$language,
        }
    };
}

pub const SAMPLES: [Sample; 8] = [
    sample!("indexing-table-en", "indexing-table", None, En),
    sample!("indexing-table-fails-de", "indexing-table", Some("CHA-14A-30-E-D2048"), De),
    sample!("robot-joint-de", "robot-joint", None, De),
    sample!("screw-axis-de", "screw-axis", None, De),
    sample!("turntable-en", "turntable", None, En),
    sample!("tolerances-de", "tolerances", None, De),
    sample!("two-axes-en", "two-axes", None, En),
    sample!("stage-axis-de", "stage-axis", None, De),
];

pub fn named(name: &str) -> Sample {
    SAMPLES.into_iter().find(|sample| sample.name == name).unwrap()
}

/// The recordings of the examples.
struct Recordings;

impl axis::Files for Recordings {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(std::fs::File::open(
            concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples").to_owned() + "/" + name,
        )?))
    }
}

pub fn content(sample: Sample) -> Content {
    made(sample.text, sample.code, sample.language, true)
}

/// The report of a project, with its pictures or without.
pub fn made(text: &str, code: Option<&str>, language: Language, pictures: bool) -> Content {
    made_in(text, code, &[language], pictures).remove(0)
}

/// The report of a project in several languages, all of one judgement.
pub fn made_in(text: &str, code: Option<&str>, languages: &[Language], pictures: bool) -> Vec<Content> {
    let projects = questions::read_all(text, &Recordings).unwrap();
    let mut contents: Vec<Content> =
        languages.iter().map(|language| Content { language: *language, axes: Vec::new() }).collect();
    for (place, project) in projects.iter().enumerate() {
        let ranked = questions::size(project);
        let code = code.map_or_else(|| ranked.candidates[0].id.to_string(), str::to_owned);
        let code = questions::read_product(&code, |_| true, Language::En).unwrap();
        let chosen = questions::check(project, &code).unwrap();
        let reserve = questions::reserve_of(project, &chosen);
        let assessed = questions::assess(project, &[&chosen], Sampling::default());
        let progress = questions::Progress::endless();
        let proposals = if ranked.fits() {
            questions::Proposals::default()
        } else {
            questions::Proposals::of(project, &progress).unwrap()
        };
        for content in &mut contents {
            let language = content.language;
            let (text, program) = ((text, place, "antrieb 0.1.0"), (&reserve, assessed.first(), &proposals));
            let dossier = questions::answer::dossier(project, &ranked, &chosen, program, text, language);
            let figures = if pictures { figures_of(project, &ranked, &chosen, language) } else { Vec::new() };
            let actuator_kind = questions::answer::actuator_kind(&chosen, language).to_owned();
            content.axes.push(AxisContent { dossier, actuator_kind, figures, chapters: Vec::new() });
        }
    }
    contents
}

fn figures_of(project: &AxisProject, ranked: &Sizing<'_>, chosen: &Candidate<'_>, language: Language) -> Vec<Diagram> {
    let kinds = [
        (DiagramPlace::Motion, figures::Figure::Cycle),
        (DiagramPlace::TorqueSpeed, figures::Figure::TorqueSpeed),
        (DiagramPlace::OutputBearing, figures::Figure::BearingLoad),
        (DiagramPlace::Gear, figures::Figure::Torsion),
    ];
    let drawn = kinds.iter().filter_map(|(place, kind)| {
        Some((*place, figures::draw(*kind, project, chosen, By::Mass, &questions::Progress::endless(), language).ok()?))
    });
    let map = figures::has_points(ranked, By::Mass)
        .then(|| figures::candidate_map(ranked, By::Mass, Some(&chosen.id), language));
    drawn
        .chain(map.map(|map| (DiagramPlace::Alternatives, map)))
        .enumerate()
        .map(|(index, (place, drawing))| {
            let drawn = |(width, height)| {
                let size = figures::Size::millimetres(width, height);
                let style = Style::new(size).theme(Theme::Light).language(language).id(&format!("f{index}"));
                drawing.render(&style).into_svg()
            };
            Diagram {
                place,
                svgs: place.sizes_mm(drawing.size_mm.1).into_iter().map(drawn).collect(),
                caption: drawing.caption.clone(),
                alternative_text: drawing.description.clone(),
            }
        })
        .collect()
}

pub fn settings() -> Settings {
    Settings {
        date: chrono::NaiveDate::from_ymd_opt(2026, 11, 21),
        revision: "B".to_owned(),
        project: "Assembly line 4".to_owned(),
        number: "AX-4711-02".to_owned(),
        author: "E. Example".to_owned(),
        company: "Example Engineering".to_owned(),
        customer: "Example Machines".to_owned(),
        order: "4711/26".to_owned(),
        changes: vec![report::Change {
            revision: "B".to_owned(),
            date: "2026-11-21".to_owned(),
            author: String::new(),
            text: "longer stroke".to_owned(),
        }],
        pdf_a: true,
        full: false,
        altered: Vec::new(),
    }
}

/// With all appendices.
pub fn full() -> Settings {
    Settings { full: true, ..settings() }
}
