//! Every answer about an axis takes its products from the catalogue that is handed in, by whatever they are named.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail")]

use actuator::{Battery, Parameters};
use axis::{AxisProject, Files, NoFiles};
use provenance::Datum;
use quantities::Language;
use questions::list::{check, compare, explain, size};
use questions::sweep::{Cells, Judged, Options, Sweep};
use questions::{Candidate, Catalogue, CheckId, Draw, Fit, Product, ProductId, Progress, Refusal, answer};
use sizing::{Amount, BrakeTimes, Verdict};
use std::borrow::Cow;
use std::sync::Arc;

/// Products of the embedded catalogue under names of their own, as a file of another manufacturer states them.
#[derive(Debug)]
struct Named(Vec<Product>);

impl Named {
    /// Renames every `step`th product, and keeps the others if `with_codes`.
    fn every(step: usize, with_codes: bool) -> Arc<dyn Catalogue> {
        let renamed = embedded().iter().step_by(step).map(|product| {
            let id = ProductId::named(&format!("motor {}", product.id));
            Product { id, manufacturer: Some("another".into()), series: None, ..product.clone() }
        });
        let kept = embedded().iter().filter(|_| with_codes).cloned();
        Arc::new(Self(kept.chain(renamed).collect()))
    }
}

impl Catalogue for Named {
    fn products(&self, output_encoder: bool) -> &[Product] {
        if output_encoder { &[] } else { &self.0 }
    }

    fn product(&self, id: &ProductId) -> Option<&Product> {
        self.0.iter().find(|product| product.id == *id)
    }

    fn brake_times(&self) -> Option<BrakeTimes> {
        questions::embedded_catalogue().brake_times()
    }

    fn battery(&self) -> Datum<Battery> {
        questions::embedded_catalogue().battery()
    }

    fn own_actuator(&self) -> Parameters {
        questions::embedded_catalogue().own_actuator()
    }
}

fn embedded() -> &'static [Product] {
    questions::embedded_catalogue().products(false)
}

const TEXTS: [&str; 4] = [
    include_str!("../../../../examples/hoist.toml"),
    include_str!("../../../../examples/tilting-arm.toml"),
    include_str!("../../../../examples/tolerances.toml"),
    include_str!("../../../../examples/two-way-shuttle.toml"),
];

fn read(text: &str, catalogue: &Arc<dyn Catalogue>) -> AxisProject {
    questions::read_all_with(text, &NoFiles as &dyn Files, catalogue).unwrap().swap_remove(0)
}

/// Verdict, value and limit of a check.
type Said = (CheckId, Verdict, Option<Amount>, Option<Amount>);

/// Statements about a candidate.
fn said(candidate: &Candidate<'_>) -> (Fit, Vec<Said>) {
    let of = |check: &sizing::Check| (check.id, check.verdict, check.value, check.limit);
    (candidate.fit(), candidate.judgement.checks.iter().map(of).collect())
}

/// A product with a name is judged as the code with the same data, and the ranking has the order of the codes.
#[test]
fn a_product_with_a_name_is_judged_as_a_code() {
    let catalogue = Named::every(17, false);
    for text in TEXTS {
        let (named, coded) = (read(text, &catalogue), read(text, questions::embedded_catalogue()));
        let (of_names, of_codes) = (questions::size(&named), questions::size(&coded));
        let renamed = |candidate: &Candidate<'_>| ProductId::named(&format!("motor {}", candidate.id));
        let is_there = |candidate: &&Candidate<'_>| catalogue.product(&renamed(candidate)).is_some();
        let expected: Vec<_> =
            of_codes.candidates.iter().filter(is_there).map(|each| (renamed(each), said(each))).collect();
        let found: Vec<_> = of_names.candidates.iter().map(|each| (each.id.clone(), said(each))).collect();
        assert_eq!(found.len(), embedded().len().div_ceil(17));
        assert_eq!(found, expected);
        let best = of_names.named().unwrap();
        assert_eq!(said(&questions::check(&named, &best.id).unwrap()), said(best));
        let code = order_code::parse("CHA-25A-50-H-C1024").unwrap().code;
        assert!(matches!(questions::check(&named, &code), Err(Refusal::NoData)), "no code is offered");
    }
}

/// Names stand beside codes in every record: ranking, check, derivation, comparison, report.
#[test]
fn a_product_with_a_name_stands_beside_the_codes() {
    let catalogue = Named::every(31, true);
    let progress = Progress::endless();
    let draw = Draw { samples: Some(5), ..Draw::default() };
    for text in TEXTS {
        let project = read(text, &catalogue);
        let ranking = size::ranking(&project, 400, draw, &progress).unwrap();
        let sizing = &ranking.sizing;
        let names: Vec<&Candidate<'_>> =
            sizing.candidates.iter().filter(|each| each.id.order_code().is_none()).collect();
        assert_eq!(names.len(), embedded().len().div_ceil(31));
        // Equal standings keep the order of the catalogue: a name comes behind its code.
        for name in &names {
            let text = name.id.to_string();
            let place = |id: &str| sizing.candidates.iter().position(|each| each.id.to_string() == id);
            let (own, code) = (place(&text).unwrap(), place(text.trim_start_matches("motor ")).unwrap());
            assert!(own > code && said(&sizing.candidates[code]) == said(name), "{text}");
        }
        let name = names[0];
        let written = serde_json::to_value(ranking.record(Language::En)).unwrap();
        let lists = ["ranking", "rejected"].map(|list| written[list].to_string());
        assert!(lists.iter().any(|list| list.contains(&format!("\"code\":\"{}\"", name.id))), "{}", name.id);
        let found = check::verification(&project, Some(&name.id), draw, &progress).unwrap();
        assert_eq!(serde_json::to_value(found.record(Language::De)).unwrap()["code"], name.id.to_string());
        assert!(!explain::explanation(&project, Some(&name.id), None, &progress).unwrap().checks().is_empty());
        let pair = [name.id.clone(), sizing.candidates[0].id.clone()];
        assert_eq!(compare::compare(&project, &pair, &progress).unwrap().candidates.len(), 2);
        let written = (text, 0, "antrieb of the tests");
        let dossier = answer::dossier(
            &project,
            sizing,
            name,
            (&found.reserve, None, &questions::Proposals::default()),
            written,
            Language::De,
        );
        assert!(serde_json::to_string(&dossier).unwrap().contains(&name.id.to_string()));
    }
}

/// The rows of a sweep are answered from the catalogue of its options, also by the screen that many rows share.
#[test]
fn a_sweep_takes_its_products_from_its_catalogue() {
    let text = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"20 1/min\"\n\
                accelerate = \"0.2 s\"\nrun = \"0.5 s\"\nbrake = \"0.2 s\"\npause = \"0.5 s\"\n";
    let inertias: Vec<String> = (1..40_u32).map(|each| (0.05 * f64::from(each * each)).to_string()).collect();
    let mut fitting = 0;
    for (step, with_codes) in [(1, false), (23, false), (11, true)] {
        let catalogue = Named::every(step, with_codes);
        let options = Options { catalogue: Arc::clone(&catalogue), ..Options::default() };
        let made = Sweep::new(("axis.toml", text), Box::new(NoFiles), &["load.inertia [kg m^2]"], options);
        let Ok(sweep) = made else { panic!("the table is read") };
        let cells = inertias.iter().map(|each| Some(Cow::Borrowed(each.as_str()))).collect();
        let found = sweep.judge(&[Cells::Texts(cells)], &Progress::endless()).unwrap();
        for (inertia, answer) in inertias.iter().zip(found) {
            let row = text.replace("1 kg m^2", &format!("{inertia} kg m^2"));
            let project = read(&row, &catalogue);
            let best = questions::size(&project).answer().map(|answer| answer.id.clone());
            let Ok(Judged::Best(judged)) = answer else { panic!("{inertia}") };
            assert_eq!(judged.code, best, "{inertia}");
            fitting += usize::from(best.is_some());
        }
    }
    assert!(fitting > 20, "{fitting}");
}
