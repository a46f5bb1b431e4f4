//! The report of the examples, of poor records and of hostile ones.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test that cannot panic cannot fail")]

use crate::samples;

use answers::{Block, Chapter, Check, Column, Hazard, Item, Picture, ScrewJoint, Task};
use quantities::Language;
use report::{Content, Diagram, DiagramPlace, Fault, Settings};
use samples::{SAMPLES, Sample, content, full, made, named, settings};

/// Letters and digits only: line breaks, indices and narrow spaces are a matter of setting.
fn letters(text: &str) -> String {
    text.chars().filter(|sign| sign.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

fn pages_of(content: &Content, settings: &Settings) -> String {
    report::page_texts(content, settings).unwrap().concat()
}

/// A report with few checks, without pictures: enough for the parts of every page, and quick to typeset.
fn short() -> Content {
    let text = "format = 1\n[axis]\nname = \"short\"\n[load]\ninertia = \"1.3 kg m^2\"\nfriction_torque = \"5 N m\"\n\
        [[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\n\
        pause = \"1 s\"\n";
    let mut content = made(text, Some("CHA-25A-100-H-C1024-B"), Language::En, false);
    let dossier = &mut content.axes[0].dossier;
    dossier.judgement.candidate.checks.truncate(4);
    dossier.explained.truncate(2);
    dossier.sizing.ranking.truncate(2);
    content
}

fn checks(content: &Content) -> impl Iterator<Item = &Check> {
    content.axes.iter().flat_map(|axis| &axis.dossier.judgement.candidate.checks)
}

/// One test for each sample: what is typeset once is looked at for everything.
macro_rules! samples {
    ($($test:ident: $index:literal;)*) => {
        $(
            #[test]
            fn $test() {
                let sample = SAMPLES[$index];
                let content = content(sample);
                every_sample_says_all_that_its_records_say(sample, &content);
                every_number_of_a_check_stands_in_the_report_as_it_is_in_the_answer(sample, &content);
                one_axis_takes_nine_pages_at_most_and_leaves_none_half_empty(sample, &content);
                open_points_are_counted_once_and_for_all(sample, &content);
                no_text_stands_upon_another(sample, &content);
            }
        )*

        #[test]
        fn every_sample_has_its_test() {
            assert_eq!([$($index),*].len(), SAMPLES.len());
        }
    };
}

samples! {
    an_axis_that_fits: 0;
    an_axis_that_does_not_fit: 1;
    a_recorded_axis: 2;
    a_linear_axis: 3;
    a_turntable: 4;
    an_axis_with_tolerances: 5;
    two_axes: 6;
    an_axis_with_a_stage: 7;
}

fn every_sample_says_all_that_its_records_say(sample: Sample, content: &Content) {
    let brief = letters(&pages_of(content, &settings()));
    let whole = letters(&pages_of(content, &full()));
    let name = sample.name;
    let says = |text: &str, part: &str| {
        let part = words::without_keys(part, content.language);
        let found = letters(&part);
        // A footnote may go on in the next column or on the next page.
        let is_in_two = || {
            let mut breaks = found.char_indices().map(|(place, _)| found.split_at(place));
            breaks.any(|(first, rest)| text.contains(first) && text.contains(rest))
        };
        assert!(text.contains(&found) || is_in_two(), "{name}: {part}");
    };
    for axis in &content.axes {
        let dossier = &axis.dossier;
        says(&brief, &dossier.judgement.axis);
        says(&brief, dossier.judgement.candidate.called());
        let assumed = dossier.judgement.assumptions.iter().map(|each| &each.why);
        for text in assumed.chain(&dossier.judgement.candidate.objections) {
            says(&brief, text);
        }
        for value in dossier.inputs.iter().flat_map(|table| &table.values) {
            // The bodies of a turntable stand in a table of their own, under one heading.
            if !value.name.starts_with("bodies[") {
                says(&brief, if value.label.is_empty() { &value.name } else { &value.label });
            }
            says(&brief, &value.text);
            says(&brief, value.tolerance.as_deref().unwrap_or_default());
        }
        for missing in &dossier.missing {
            let shown = dossier
                .judgement
                .candidate
                .checks
                .iter()
                .any(|check| *check.id == *missing.check && check.value.is_some());
            // What has no limit is listed without the key of it.
            let has_no_limit =
                ["no limit stated", "keine Grenze angegeben"].iter().any(|no| missing.text.starts_with(no));
            says(&brief, if shown || has_no_limit { "" } else { &missing.text });
        }
        for document in &dossier.documents {
            for part in [&document.short, &document.title, &document.edition, &document.publisher] {
                says(&brief, part);
            }
        }
        for erratum in &dossier.errata {
            // By its place: the reader of a document does not know the ids of the data.
            says(&brief, &words::erratum_place_of(&erratum.erratum.id, content.language));
            says(&brief, &erratum.erratum.evidence);
            assert!(!brief.contains(&letters(&erratum.erratum.id)), "{name}: {}", erratum.erratum.id);
        }
        for item in &dossier.bill_of_material {
            says(&brief, &item.code);
        }
        for part in [&dossier.fingerprints.project, &dossier.fingerprints.catalogue, &dossier.fingerprints.program] {
            says(&brief, part);
        }
        for rejected in &dossier.sizing.rejected {
            says(&whole, &rejected.code);
        }
        for source in dossier.explained.iter().flat_map(|each| &each.check.sources) {
            says(&whole, source);
        }
        for figure in &axis.figures {
            says(&brief, &figure.caption);
        }
    }
    for check in checks(content) {
        says(&brief, &check.title);
        for note in &check.notes {
            says(&brief, note);
        }
    }
    for part in ["AX-4711-02", "E. Example"] {
        says(&brief, part);
    }
}

/// Without spaces of any width, which stand between number, unit and groups of digits.
fn dense(text: &str) -> String {
    text.chars().filter(|sign| !sign.is_whitespace()).collect()
}

/// A figure as a reader of that language finds it: four digits, no zeros at the end.
fn printed(value: f64, language: Language) -> String {
    let text = quantities::format_significant(value, 4, language);
    let point = if language == Language::De { ',' } else { '.' };
    let (mantissa, power) = text.split_at(text.find('·').unwrap_or(text.len()));
    let short =
        if mantissa.contains(point) { mantissa.trim_end_matches('0').trim_end_matches(point) } else { mantissa };
    dense(&format!("{short}{power}"))
}

fn every_number_of_a_check_stands_in_the_report_as_it_is_in_the_answer(sample: Sample, content: &Content) {
    let text = dense(&pages_of(content, &settings()));
    let mut numbers = 0;
    for check in checks(content) {
        let unit = match check.unit {
            None | Some("1") => "",
            Some("deg") => "°",
            Some(unit) => quantities::Unit::of(unit).map_or(unit, |unit| unit.symbol_in(sample.language)),
        };
        for value in [check.value, check.limit].into_iter().flatten() {
            // A life above a million hours is no statement of its digits.
            let figure = match unit {
                "h" if value.0 > 1e6 => ">10⁶h".to_owned(),
                _ => format!("{}{unit}", printed(value.0, sample.language)),
            };
            assert!(text.contains(&dense(&figure)), "{}, {}: {figure}", sample.name, check.title);
            numbers += 1;
        }
        // What is no margin has no share in the report.
        let is_margin = check.margin || matches!(*check.verdict, answers::Verdict::Fail | answers::Verdict::Advice);
        if let Some(share) =
            check.utilisation.filter(|_| is_margin).and_then(|share| share.written()).filter(|share| *share >= 0.0005)
        {
            let percent = dense(&format!("{}%", quantities::format_number(share * 100.0, 1, sample.language)));
            assert!(text.contains(&percent), "{}, {}: {percent}", sample.name, check.title);
        }
    }
    assert!(numbers > 30, "{}: {numbers}", sample.name);
}

fn one_axis_takes_nine_pages_at_most_and_leaves_none_half_empty(sample: Sample, content: &Content) {
    let pages = report::page_fills(content, &settings()).unwrap();
    let most = if content.axes.len() == 1 { 9 } else { 1 + 9 * content.axes.len() };
    assert!(pages.len() <= most, "{}: {} pages, {pages:.0?}", sample.name, pages.len());
    // The last page ends where it ends, and so does that of an axis before the next.
    let within = pages.iter().rev().skip(1).rev();
    let poor = within.filter(|filled| **filled < 420.0).count();
    assert!(poor < content.axes.len(), "{}: {pages:.0?}", sample.name);
}

fn open_points_are_counted_once_and_for_all(sample: Sample, content: &Content) {
    let cover = letters(&report::page_texts(content, &settings()).unwrap()[0]);
    for axis in content.axes.iter().filter(|_| content.axes.len() == 1) {
        let candidate = &axis.dossier.judgement.candidate;
        let (open, de) = (candidate.open_questions, sample.language == Language::De);
        let words = match (open, de) {
            (0, _) => continue,
            (1, true) => "Nachweis konnte nicht geführt werden",
            (1, false) => "check could not be made",
            (_, true) => "Nachweise konnten nicht geführt werden",
            (_, false) => "checks could not be made",
        };
        assert!(cover.contains(&letters(&format!("{open} {words}"))), "{}: {open}", sample.name);
        let may = candidate
            .checks
            .iter()
            .filter(|check| check.is_open && check.value.is_none() && !check.id.is_recommendation());
        // Those with a rating of another gear rule out by a limit of the manufacturer alone, on the cover as in the list.
        let (by_own_limit, may): (Vec<&Check>, Vec<&Check>) = may.partition(|check| check.id.may_be_rated_elsewhere());
        let words = if de {
            ["Den Antrieb ausschließen können", "Nur bei Angabe des Herstellers"]
        } else {
            ["The following may rule out the actuator", "Only if the manufacturer states a limit"]
        };
        for (those, words) in [(may, words[0]), (by_own_limit, words[1])] {
            assert_eq!(cover.contains(&letters(words)), !those.is_empty(), "{}: {words}", sample.name);
            let behind = cover.split(&letters(words)).nth(1).unwrap_or_default();
            for check in those {
                assert!(behind.contains(&letters(&check.title)), "{}: {}", sample.name, check.title);
            }
        }
    }
}

#[test]
fn the_language_is_that_of_headings_and_numbers() {
    let mut content = content(named("indexing-table-en"));
    let pages = pages_of(&content, &settings());
    assert!(pages.contains("Sizing report") && pages.contains("2026-11-21"));
    let value = checks(&content).find_map(|check| check.value.map(|value| printed(value.0, Language::En))).unwrap();
    assert!(value.contains('.') && pages.contains(&value), "{value}");
    content.language = Language::De;
    let pages = pages_of(&content, &settings());
    assert!(pages.contains("Auslegungsbericht") && pages.contains("21.11.2026"));
    assert!(pages.contains(&value.replace('.', ",")) && !pages.contains(&value));
}

fn no_text_stands_upon_another(sample: Sample, content: &Content) {
    let mut content = content.clone();
    let source =
        Some("Tabelle 79.1, transmissible_torque_load (entfettete Fuge, Reibungszahl 0,15), i = 100".to_owned());
    let joint = ScrewJoint {
        joint: "Gehäuse".to_owned(),
        screws: "12 × M3, 12.9".to_owned(),
        circle: "80 mm".to_owned(),
        torque: "2,3 Nm".to_owned(),
        text: "überträgt 158 Nm, trocken".to_owned(),
        source: source.clone(),
    };
    let item = Item {
        item: "1".to_owned(),
        quantity: "12".to_owned(),
        code: "CHA-17A-100-H-M128S-B-EC-K".to_owned(),
        text: "Schrauben zwischen Gehäuse und Maschine; Länge nach dem verschraubten Teil".to_owned(),
        source,
    };
    content.axes[0].dossier.screws = vec![joint; 2];
    content.axes[0].dossier.bill_of_material = vec![item; 2];
    let found = report::overlaps(&content, &full()).unwrap();
    assert!(found.is_empty(), "{}: {found:#?}", sample.name);
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let content = content(named("two-axes-en"));
    let first = report::pdf(&content, &settings()).unwrap();
    let second = report::pdf(&content, &settings()).unwrap();
    assert!(first == second, "two runs differ");
    let has = |part: &str| first.windows(part.len()).any(|window| window == part.as_bytes());
    assert!(first.starts_with(b"%PDF-1.7"));
    for part in ["pdfaid:part", "pdfaid:conformance", "MarkInfo", "StructTreeRoot", "/Lang"] {
        assert!(has(part), "{part}");
    }
}

#[test]
fn what_is_missing_leaves_no_heading_without_content() {
    let mut content = short();
    let dossier = &mut content.axes[0].dossier;
    dossier.judgement.candidate.checks.retain(|check| check.value.is_some());
    for check in &mut dossier.judgement.candidate.checks {
        check.notes.clear();
    }
    dossier.judgement.candidate.open_questions = 0;
    dossier.judgement.candidate.demand = None;
    dossier.judgement.assumptions.clear();
    dossier.sizing.ranking.clear();
    dossier.sizing.rejected.clear();
    dossier.rejections.clear();
    dossier.screws.clear();
    dossier.errata.clear();
    dossier.data_sheet.clear();
    let pages = letters(&pages_of(&content, &Settings::default()));
    let gone = [
        "Not stated in the project",
        "Torque-speed plane",
        "Tolerances",
        "Remarks",
        "Not checked",
        "Suitable actuators",
        "Rejected actuators with the smallest excess",
        "Reasons for rejection",
        "Errata taken into account",
        "Demands on the output shaft",
        "Appendix",
    ];
    for heading in gone {
        assert!(!pages.contains(&letters(heading)), "{heading}");
    }
    assert!(pages.contains(&letters("Parts list")));
    assert!(report::pdf(&content, &Settings::default()).unwrap().starts_with(b"%PDF"));
}

#[test]
fn every_mechanism_has_its_drawing() {
    for id in questions::MechanismId::ALL {
        let mut content = short();
        content.axes[0].dossier.mechanism.sketch.svg =
            id.drawing(&questions::MechanismValues::none()).picture(|_| true);
        let text = letters(&pages_of(&content, &settings()));
        assert!(text.contains(&letters("Schematic, not to scale")), "{id:?}");
    }
}

#[test]
fn a_linear_axis_is_reported_along_its_line_and_a_turntable_by_its_bodies() {
    let screw = dense(&pages_of(&content(named("screw-axis-de")), &settings()));
    let travel = content(named("screw-axis-de")).axes[0].dossier.mechanism.travel_mm_per_rev.unwrap();
    assert!((travel.0 - 40.0).abs() < 1e-9, "{travel:?}");
    // 60 mm/s at a lead of 40 mm are 90 turns per minute.
    assert!(screw.contains("90min⁻¹") && screw.contains("60mm/s") && screw.contains("Linear"));
    let table = content(named("turntable-en"));
    let bodies = table.axes[0].dossier.mechanism.bodies.clone().unwrap();
    let text = dense(&pages_of(&table, &settings()));
    for value in [bodies.inertia.0, bodies.mass.0] {
        assert!(text.contains(&printed(value, Language::En)), "{value}");
    }
    assert!(text.contains("420mm") && !text.contains("diameter=420mm"), "a body in words");
}

/// Angles at the mechanism have the travel of the mechanism, those at the output that of the actuator.
#[test]
fn angles_behind_a_stage_are_converted_by_the_travel_of_the_mechanism() {
    let mut content = content(named("screw-axis-de"));
    let checks = &content.axes[0].dossier.judgement.candidate.checks;
    let value_of = |id| checks.iter().find(|check| *check.id == id).unwrap().value.unwrap().0;
    let (torsion, speed) = (value_of(answers::CheckId::Torsion), value_of(answers::CheckId::PeakSpeed));
    let along = |arcmin: f64, travel_mm: f64| {
        let way_mm = arcmin / 21_600.0 * travel_mm;
        let (value, unit) = if way_mm < 0.01 { (way_mm * 1e3, "µm") } else { (way_mm, "mm") };
        format!("{}{unit}", printed(value, Language::De))
    };
    let text = dense(&pages_of(&content, &settings()));
    assert!(text.contains(&along(torsion, 40.0)), "without a stage");
    // A stage of 2.5 between an actuator and a screw of 100 mm.
    content.axes[0].dossier.mechanism.own_travel_mm_per_rev = Some(answers::Number(100.0));
    let text = dense(&pages_of(&content, &settings()));
    assert!(text.contains(&along(torsion, 100.0)) && !text.contains(&along(torsion, 40.0)), "behind a stage");
    assert!(text.contains(&format!("{}mm/s", printed(speed * 40.0 / 60.0, Language::De))), "at the output");
}

#[test]
fn several_axes_have_a_summary_and_a_part_each() {
    let content = content(named("two-axes-en"));
    let pages = report::page_texts(&content, &settings()).unwrap();
    for axis in &content.axes {
        let judgement = &axis.dossier.judgement;
        for part in [judgement.axis.as_str(), judgement.candidate.called()] {
            assert!(letters(&pages[0]).contains(&letters(part)), "{part}");
        }
    }
    let all = letters(&pages.concat());
    assert_eq!(all.matches(&letters("Parts list and screws")).count(), 2);
    let none = Content { language: Language::En, axes: Vec::new() };
    assert!(matches!(report::pdf(&none, &settings()), Err(Fault::NoAxis)));
}

#[test]
fn hostile_texts_stay_data() {
    let names = [
        "#let x = 1; #panic(\"no\")".to_owned(),
        "= heading *bold* _em_ $x$ @ref <label> // comment".to_owned(),
        "\\ \\u{41} \"quotes\" 'single' `code`".to_owned(),
        "W".repeat(200),
        "a_b ".repeat(50),
        "شفت محور مجوف".to_owned(),
        "ציר חלול".to_owned(),
        "中空轴 🤖 \u{0}\u{7}\n\r\t\u{202e}\u{feff}".to_owned(),
    ];
    let clean = short();
    for name in names {
        let mut content = clean.clone();
        let dossier = &mut content.axes[0].dossier;
        dossier.judgement.axis.clone_from(&name);
        dossier.judgement.candidate.code = Some(name.clone());
        dossier.judgement.candidate.objections = vec![name.clone()];
        let check = &mut dossier.judgement.candidate.checks[0];
        check.title.clone_from(&name);
        check.notes = vec![name.clone()];
        for table in &mut dossier.inputs {
            table.title.clone_from(&name);
            table.values[0].text.clone_from(&name);
            table.values[0].label.clone_from(&name);
        }
        dossier.sizing.rejected[0].code.clone_from(&name);
        dossier.rejections[0].reason.clone_from(&name);
        dossier.rejections[0].codes[0].clone_from(&name);
        let settings = Settings {
            project: name.clone(),
            revision: name.clone(),
            author: name.clone(),
            number: name.clone(),
            ..full()
        };
        report::pdf(&content, &settings).unwrap_or_else(|fault| panic!("{name:?}: {fault:?}"));
        let text = pages_of(&content, &settings);
        if name.is_ascii() {
            assert!(letters(&text).contains(&letters(&name)), "{name}");
        }
    }
}

#[test]
fn a_chapter_that_comes_laid_out_stands_whole_and_within_its_page() {
    let mut content = short();
    let long = "Verschraubungsdrehmomentgrenzwert".repeat(3);
    let hazard =
        |level, word, text: &str| Hazard { level, word, text: text.to_owned(), source: "cha-manual 2.1".to_owned() };
    let mut chapter = Chapter::new("Wiring of a code");
    chapter.section("Motor connector");
    chapter.text("#panic() *not* markup $x$ 12 Nm");
    chapter.points(vec!["a point".to_owned(), long.clone()]);
    chapter.steps(vec!["the first step".to_owned(), "the second step".to_owned()]);
    let columns = vec![Column::text("pin"), Column::numbers("value"), Column::wide("meaning")];
    chapter.grid(
        columns,
        (1..60).map(|pin| vec![pin.to_string(), "0.5".to_owned(), format!("row {pin} {long}")]).collect(),
    );
    chapter.hazards(vec![hazard("danger", "DANGER", "live parts"), hazard("", "", "a plain statement")]);
    let svg =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><circle cx='4' cy='4' r='3'/></svg>".to_owned();
    let picture = |caption: &str| Picture {
        svg: svg.clone(),
        caption: caption.to_owned(),
        alternative_text: "a face".to_owned(),
    };
    chapter.blocks.extend(["one face", "another face"].map(|caption| Block::Picture(picture(caption))));
    chapter.tasks(vec![Task {
        what: hazard("warning", "WARNING", "look at the brake"),
        expected: "24 V".to_owned(),
        unit: Some("V".to_owned()),
    }]);
    content.axes[0].chapters = vec![chapter, Chapter::new("a second chapter")];
    report::pdf(&content, &settings()).unwrap();
    let text = letters(&pages_of(&content, &settings()));
    for wanted in [
        "Wiring of a code",
        "#panic() *not* markup $x$ 12 Nm",
        "a point",
        "the second step",
        "row 59",
        "DANGER",
        "live parts",
        "a plain statement",
        "one face",
        "another face",
        "WARNING",
        "look at the brake",
        "24 V",
        "a second chapter",
    ] {
        assert!(text.contains(&letters(wanted)), "{wanted}");
    }
    for (page, right) in report::right_edges(&content, &settings()).unwrap().into_iter().enumerate() {
        assert!(right < 595.3, "page {}: {right}", page + 1);
    }
}

#[test]
fn no_text_leaves_the_page() {
    let mut content = short();
    let long = "Verschraubungsdrehmomentgrenzwert".repeat(8);
    let dossier = &mut content.axes[0].dossier;
    dossier.judgement.axis.clone_from(&long);
    let check = &mut dossier.judgement.candidate.checks[0];
    check.title.clone_from(&long);
    check.notes = vec![long.clone()];
    check.sources = vec![long.clone()];
    for table in &mut dossier.inputs {
        table.title.clone_from(&long);
        table.values[0].label.clone_from(&long);
        table.values[0].text.clone_from(&long);
    }
    let settings = Settings { project: long.clone(), author: long.clone(), ..full() };
    // Where a long word ends a line nothing is put into it that would be copied out with it.
    let text = pages_of(&content, &settings);
    let unseen = ['\u{ad}', '\u{200b}', '\u{200c}', '\u{200d}', '\u{2060}', '\u{feff}'];
    assert!(!text.contains(unseen), "a sign that is not seen");
    assert!(text.split_whitespace().collect::<String>().contains(&long), "the word is there whole");
    for (page, right) in report::right_edges(&content, &settings).unwrap().into_iter().enumerate() {
        assert!(right < 595.3, "page {}: {right}", page + 1);
    }
}

#[test]
fn what_cannot_be_set_is_a_fault() {
    let content = short();
    let undated = Settings { pdf_a: true, ..Settings::default() };
    assert!(matches!(report::pdf(&content, &undated), Err(Fault::NoDate)));
    let mut broken = content.clone();
    broken.axes[0].figures = vec![Diagram {
        place: DiagramPlace::Motion,
        svgs: vec!["<svg".to_owned()],
        caption: String::new(),
        alternative_text: String::new(),
    }];
    assert!(matches!(report::pdf(&broken, &settings()), Err(Fault::Typesetting { .. })));
}

/// The lift of the review: with a lead of 20 mm nothing fits, with another it would.
#[test]
fn another_gearing_is_proposed_where_nothing_fits() {
    let lift = "format = 1\n[mechanism.screw]\nlead = \"20 mm\"\nmass = \"60 kg\"\ninclination = \"90 deg\"\n\
        [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"300 mm\"\ntime = \"2 s\"\n[[motion]]\nlaw = \"polynomial_5\"\n\
        distance = \"-300 mm\"\ntime = \"2 s\"\n";
    for (language, words) in [(Language::En, "Another value"), (Language::De, "Anderer Wert")] {
        let content = made(lift, None, language, false);
        let proposed = content.axes[0].dossier.sizing.would_fit_with.clone();
        assert_eq!(proposed.len(), 2, "{proposed:?}");
        let text = letters(&pages_of(&content, &settings()));
        assert!(text.contains(&letters(words)), "{text}");
        assert!(proposed.iter().all(|found| text.contains(&letters(&found.code))), "{text}");
    }
}

/// A limit of zero is stated in words where nothing holds the load or no torque is available.
#[test]
fn a_limit_of_zero_is_stated_in_words() {
    let arm = |hold: &str, speed: &str| {
        format!(
            "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1.3 kg m^2\"\nexternal_torque = \"20 N m\"\n\
             [[motion]]\nlaw = \"trapezoid\"\ndistance = \"900 deg\"\nspeed = \"{speed}\"\nacceleration = \"30 rad/s^2\"\n\
             [[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\nhold = \"{hold}\"\n"
        )
    };
    let cases = [
        (arm("brake", "10 1/min"), "CHA-25A-100-H-C1024", ["no holding torque", "kein Haltemoment"]),
        (arm("free", "10 1/min"), "CHA-25A-100-H-C1024", ["no holding torque", "kein Haltemoment"]),
        (
            arm("motor", "200 1/min"),
            "CHA-25A-100-H-C1024",
            ["no torque at this speed", "kein Drehmoment bei dieser Drehzahl"],
        ),
    ];
    for (text, code, words) in cases {
        for (content, words) in
            samples::made_in(&text, Some(code), &[Language::En, Language::De], false).iter().zip(words)
        {
            let of_zero = checks(content).filter(|check| check.limit.is_some_and(|limit| limit.0 == 0.0));
            assert!(of_zero.count() > 0, "{text}");
            let pages = dense(&pages_of(content, &settings()));
            assert!(pages.contains(&dense(words)), "{words}");
            let none =
                |found: &str| pages.match_indices(found).any(|(at, _)| pages[at + found.len()..].starts_with("0Nm"));
            assert!(!none(">") && !none("≤"), "{words}: {pages}");
        }
    }
}
