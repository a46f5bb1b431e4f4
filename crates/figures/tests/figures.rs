//! Every figure of every example: a complete picture, with points at the places of the checks.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use axis::{AxisProject, Files};
use figures::{By, Drawing, Figure, NoFigure, Picture, Size, Style, draw};
use quantities::unit::{ARCMINUTE, NEWTON_METRE, REVOLUTION_PER_MINUTE};
use quantities::{Language, Measure};
use questions::{Candidate, CheckId, Progress};
use roxmltree::{Document, Node};
use std::path::PathBuf;
use testkit::readers::letters_of;

const LANGUAGES: [Language; 2] = [Language::En, Language::De];

struct ExampleFiles;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

impl Files for ExampleFiles {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        Ok(Box::new(std::fs::File::open(folder().join(name))?))
    }
}

fn examples() -> Vec<AxisProject> {
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    assert!(paths.len() >= 10);
    let read = |path: &PathBuf| questions::read_all(&std::fs::read_to_string(path).unwrap(), &ExampleFiles).unwrap();
    paths.iter().flat_map(read).collect()
}

/// Returns the best candidate of the catalogue, judged with every check, and that of the project.
fn candidates(project: &AxisProject) -> Vec<Candidate<'_>> {
    let best = questions::size(project).candidates.swap_remove(0);
    let code = best.id;
    let best = questions::check(project, &code).unwrap();
    std::iter::once(best).chain(questions::check_own(project).ok()).collect()
}

/// Smallest letter of a picture at its own size \[pt\].
const LEAST_PT: f64 = 7.0;

/// Draws a picture at its own size and asserts that its letters can be read.
fn picture(drawing: &Drawing, language: Language) -> Picture {
    let picture = drawing.render(&Style::new(drawing.size()).language(language).id(drawing.figure.id()));
    let small: Vec<_> = letters_of(picture.svg()).into_iter().filter(|(size, _)| *size < LEAST_PT - 0.01).collect();
    assert!(small.is_empty(), "{}: {small:?}", drawing.figure.id());
    picture
}

fn example(name: &str) -> AxisProject {
    let text = std::fs::read_to_string(folder().join(name)).unwrap();
    questions::read_all(&text, &ExampleFiles).unwrap().swap_remove(0)
}

/// Returns the points of the markers of a class.
fn points(document: &Document<'_>, class: &str) -> Vec<(f64, f64)> {
    let has = |node: &Node<'_, '_>, class: &str| {
        node.attribute("class").is_some_and(|classes| classes.split(' ').any(|known| known == class))
    };
    let group = document.descendants().find(|node| has(node, class)).unwrap_or_else(|| panic!("no {class}"));
    let number = |node: &Node<'_, '_>, key: &str| node.attribute(key)?.parse::<f64>().ok();
    group.descendants().filter_map(|node| Some((number(&node, "data-x")?, number(&node, "data-y")?))).collect()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}

#[test]
fn every_figure_of_every_example_is_whole() {
    for project in examples() {
        for candidate in candidates(&project) {
            for figure in Figure::ALL {
                for language in LANGUAGES {
                    let what = format!("{} {} {}", project.name, candidate.id, figure.id());
                    let drawing = match draw(figure, &project, &candidate, By::Mass, &Progress::endless(), language) {
                        Ok(drawing) => drawing,
                        Err(NoFigure::NoFlangeLoads | NoFigure::FlangeLoadsOpen(_)) => {
                            assert!(
                                figure == Figure::BearingLoad && project.axis.flange_course(None).is_empty(),
                                "{what}"
                            );
                            continue;
                        }
                        Err(fault) => {
                            assert_eq!((figure, fault), (Figure::Torsion, NoFigure::NoStiffness), "{what}");
                            continue;
                        }
                    };
                    let picture = picture(&drawing, language);
                    assert_eq!(picture.dropped(), 0, "{what}");
                    assert!(!picture.svg().contains("NaN") && !picture.svg().contains("inf\""), "{what}");
                    let document = Document::parse(picture.svg()).unwrap();
                    let text = |tag: &str| {
                        let found = document.descendants().find(|node| node.has_tag_name(tag));
                        found.and_then(|node| node.text()).unwrap_or_default().to_owned()
                    };
                    assert_eq!(text("title"), drawing.title, "{what}");
                    assert_eq!(text("desc"), drawing.description, "{what}");
                    assert!(drawing.description.contains(|c: char| c.is_ascii_digit()), "{what}: no number stated");
                    assert!(drawing.caption.ends_with('.') && drawing.description.ends_with('.'), "{what}");
                    if figure != Figure::CandidateMap {
                        assert!(picture.hidden_labels().is_empty(), "{what}: {:?}", picture.hidden_labels());
                    }
                    let narrow = Style::new(Size::millimetres(80.0, 110.0)).language(language);
                    let narrow = drawing.render(&narrow);
                    if figure != Figure::CandidateMap {
                        let hidden = narrow.hidden_labels();
                        // A segment too short for its number has no label.
                        let segment = |label: &String| label.starts_with(|c: char| c.is_ascii_digit());
                        assert!(hidden.iter().all(segment), "{what} at 80 mm: {hidden:?}");
                    }
                    for text in narrow.texts() {
                        assert!(!text.text.contains('…'), "{what} at 80 mm: {}", text.text);
                    }
                    let texts = picture.texts();
                    for (index, one) in texts.iter().enumerate() {
                        let other = texts.iter().skip(index + 1).find(|other| one.area.overlaps(&other.area));
                        assert!(other.is_none(), "{what}: {one:?} {other:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn mean_and_peaks_stand_where_the_checks_say() {
    for project in examples() {
        for candidate in candidates(&project) {
            let drawing = figures::torque_speed(&project, &candidate, Language::En);
            let picture = picture(&drawing, Language::En);
            let document = Document::parse(picture.svg()).unwrap();
            let Some(demand) = &candidate.judgement.demand else { continue };
            let value = |id: CheckId| {
                let check = candidate.judgement.checks.iter().find(|check| check.id == id);
                check.and_then(|check| check.value).map(|value| value.si)
            };
            let [mean] = points(&document, "mean")[..] else { panic!("one mean point") };
            let what = format!("{} {}", project.name, candidate.id);
            assert!(close(mean.0, REVOLUTION_PER_MINUTE.from_si(demand.speed_mean.si())), "{what}");
            assert!(close(mean.1, NEWTON_METRE.from_si(demand.torque_rms.si())), "{what}");
            if let Some(speed) = value(CheckId::MeanSpeed) {
                assert!(close(mean.0, REVOLUTION_PER_MINUTE.from_si(speed)), "{what}");
            }
            let peaks = points(&document, "peaks");
            let torque = peaks.iter().map(|point| point.1.abs()).fold(0.0, f64::max);
            let speed = peaks.iter().map(|point| point.0.abs()).fold(0.0, f64::max);
            assert!(close(torque, NEWTON_METRE.from_si(value(CheckId::PeakTorque).unwrap())), "{what}: {torque}");
            assert!(close(speed, REVOLUTION_PER_MINUTE.from_si(value(CheckId::PeakSpeed).unwrap())), "{what}: {speed}");
            // The marked peaks lie on the trace, up to the difference between two of its samples.
            let course = questions::course(&project, &candidate);
            for (n, t) in peaks {
                let near = course.samples.iter().any(|sample| {
                    (REVOLUTION_PER_MINUTE.from_si(sample.speed_rad_s) - n).abs() <= 0.02 * speed
                        && (sample.torque_nm - t).abs() <= 0.02 * torque
                });
                assert!(near, "{what}: ({n}, {t})");
            }
        }
    }
}

#[test]
fn the_working_point_of_the_torsion_is_that_of_the_check() {
    let project = example("indexing-table.toml");
    let candidate = candidates(&project).swap_remove(0);
    let picture = picture(&figures::torsion(&project, &candidate, Language::De).unwrap(), Language::De);
    let [point] = points(&Document::parse(picture.svg()).unwrap(), "working-point")[..] else { panic!("one point") };
    let check = candidate.judgement.checks.iter().find(|check| check.id == CheckId::Torsion).unwrap();
    assert!(close(point.1, ARCMINUTE.from_si(check.value.unwrap().si)));
}

#[test]
fn bars_have_the_utilisation_of_the_checks() {
    let project = example("tilting-arm.toml");
    let candidate = candidates(&project).swap_remove(0);
    let picture = picture(&figures::utilisation(&candidate, Language::En), Language::En);
    let document = Document::parse(picture.svg()).unwrap();
    let bars: Vec<Node<'_, '_>> =
        document.descendants().filter(|node| node.attribute("data-check").is_some()).collect();
    assert_eq!(bars.len(), candidate.judgement.checks.len());
    for check in &candidate.judgement.checks {
        let bar = bars.iter().find(|bar| bar.attribute("data-check") == Some(check.id.id())).unwrap();
        let shown: Option<f64> = bar.attribute("data-utilisation").and_then(|share| share.parse().ok());
        let compared = match check.verdict {
            questions::Verdict::NotChecked => false,
            questions::Verdict::Pass => check.id.has_margin(),
            questions::Verdict::Advice | questions::Verdict::Fail => true,
        };
        assert_eq!(shown, check.utilisation.filter(|_| compared), "{}", check.id.id());
    }
    // The DC link, 560 of 680 V, is a class that is met.
    assert!(!picture.texts().iter().any(|text| text.text.contains("82.4 %")));
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let project = example("screw-axis.toml");
    let candidate = candidates(&project).swap_remove(0);
    for figure in Figure::ALL {
        let svg = || {
            draw(figure, &project, &candidate, By::Length, &Progress::endless(), Language::De)
                .map(|found| picture(&found, Language::De))
        };
        assert_eq!(svg(), svg());
    }
}

#[test]
fn a_map_tells_every_candidate_or_counts_it() {
    let project = example("tilting-arm.toml");
    let sizing = questions::size(&project);
    for by in [By::Mass, By::Length] {
        let drawing = figures::candidate_map(&sizing, by, None, Language::En);
        let picture = picture(&drawing, Language::En);
        let document = Document::parse(picture.svg()).unwrap();
        let shown = document.descendants().filter(|node| node.attribute("class") == Some("marker")).count();
        let left_out: usize = drawing.caption.split_whitespace().find_map(|word| word.parse().ok()).unwrap();
        assert_eq!(shown + left_out, sizing.candidates.len(), "{}", drawing.caption);
    }
}

#[test]
fn a_map_on_which_nothing_finds_a_place_says_so() {
    let text = std::fs::read_to_string(folder().join("indexing-table.toml")).unwrap();
    let text = text.replace("speed = \"40 1/min\"", "speed = \"40000 1/min\"");
    let project = questions::read_all(&text, &ExampleFiles).unwrap().swap_remove(0);
    let sizing = questions::size(&project);
    for (language, words) in [(Language::En, "No candidate"), (Language::De, "Kein Kandidat")] {
        let drawing = figures::candidate_map(&sizing, By::Mass, None, language);
        let picture = picture(&drawing, language);
        assert!(picture.texts().iter().any(|text| text.text.starts_with(words)), "{:?}", picture.texts());
        assert!(!drawing.description.contains('∞'), "{}", drawing.description);
    }
}

#[test]
fn what_is_known_of_an_own_actuator_is_drawn() {
    let project = example("manual-example.toml");
    let own = questions::check_own(&project).unwrap();
    let picture = picture(&figures::torque_speed(&project, &own, Language::En), Language::En);
    let texts: Vec<&str> = picture.texts().iter().map(|text| text.text.as_str()).collect();
    assert!(texts.contains(&"T_max = 127.0 Nm") && texts.contains(&"n_max = 112.0 min⁻¹"), "{texts:?}");
    assert!(picture.svg().contains("known-limits"));
}

#[test]
fn loads_on_the_bearing_are_drawn_with_their_limits_or_named_as_constant() {
    let constant = example("robot-joint.toml");
    let candidate = candidates(&constant).swap_remove(0);
    let drawing =
        draw(Figure::BearingLoad, &constant, &candidate, By::Mass, &Progress::endless(), Language::En).unwrap();
    assert!(drawing.caption.contains("constant") && drawing.description.contains("constant at 110.0 N"));
    let varying = example("slewing-arm.toml");
    let candidate = candidates(&varying).swap_remove(0);
    let drawing =
        draw(Figure::BearingLoad, &varying, &candidate, By::Mass, &Progress::endless(), Language::En).unwrap();
    let picture = picture(&drawing, Language::En);
    for symbol in ["F_R,dyn(max) = ", "F_A,dyn(max) = ", "M_dyn(max) = "] {
        assert!(picture.texts().iter().any(|text| text.text.starts_with(symbol)), "{symbol}");
    }
}

#[test]
fn the_limits_of_a_code_need_no_project() {
    let code = questions::read_code("CHA-20A-100-H-C1024", Language::En).unwrap().parsed.code.into();
    let product = questions::embedded_catalogue().product(&code).unwrap();
    let volts = questions::read_quantity("120 V", Language::En).unwrap();
    for terminal in [None, Some(volts)] {
        let plane = questions::plane_of(product, terminal).unwrap();
        for language in LANGUAGES {
            let picture = picture(&figures::curves(&code, &plane, language), language);
            assert_eq!(picture.dropped(), 0);
            assert!(Document::parse(picture.svg()).is_ok());
            assert_eq!(picture.svg().contains("120 V"), terminal.is_some());
        }
    }
}

#[test]
fn mating_faces_have_letters_to_read() {
    for text in ["CHA-14A-50-E-M128S", "CHA-25A-100-H-M512P-B-EC", "CHA-58A-100-H-C1024-B-EC"] {
        let code = questions::read_code(text, Language::En).unwrap().parsed.code;
        let found = questions::list::wiring::wiring(&code).unwrap();
        for connector in found.connectors.iter().filter(|connector| !connector.pins.is_empty()) {
            for language in LANGUAGES {
                let drawing = figures::mating_face(&code, connector, figures::PinTexts::Signals, language);
                assert!(!picture(&drawing, language).texts().is_empty(), "{text}");
            }
        }
    }
}

#[test]
fn a_simulation_and_its_control_loops_have_letters_to_read() {
    let text = std::fs::read_to_string(folder().join("slewing-arm.toml")).unwrap();
    let text = if text.contains("[twin]") { text } else { text + "\n[twin]\nscenario = \"cycle\"\n" };
    let project = questions::read_all(&text, &ExampleFiles).unwrap().swap_remove(0);
    let candidate = candidates(&project).swap_remove(0);
    let code = candidate.id;
    for language in LANGUAGES {
        let run = questions::list::simulate::of_the_project(&project, Some(&code), &Progress::endless(), language);
        let run = run.unwrap().unwrap();
        for drawing in [figures::simulation(&run, None, &[], language), figures::control_loops(&run, language)] {
            assert!(!picture(&drawing, language).texts().is_empty());
        }
    }
}

/// Compares the hatchings of the legend with those of the bands that have an area, for every example.
#[test]
fn the_legend_of_the_plane_explains_the_bands_that_are_drawn() {
    let mut bands = 0;
    for project in examples() {
        for candidate in candidates(&project) {
            let drawing = figures::torque_speed(&project, &candidate, Language::En);
            let svg = picture(&drawing, Language::En).into_svg();
            let document = Document::parse(&svg).unwrap();
            let of_class = |name: &'static str| {
                document.descendants().filter(move |node| node.attribute("class").is_some_and(|class| class == name))
            };
            let hatch = |node: Node<'_, '_>| {
                let mut fills = node.descendants().filter_map(|inside| inside.attribute("fill")?.strip_prefix("url("));
                fills.next().map(str::to_owned)
            };
            let drawn: std::collections::BTreeSet<String> = of_class("area band").filter_map(hatch).collect();
            let legend = of_class("legend").flat_map(|legend| legend.descendants().collect::<Vec<_>>());
            let explained: std::collections::BTreeSet<String> =
                legend.filter_map(|node| Some(node.attribute("fill")?.strip_prefix("url(")?.to_owned())).collect();
            assert_eq!(drawn, explained, "{} {}", project.name, candidate.id);
            bands += drawn.len();
            for area in of_class("area band") {
                let path = area.descendants().find_map(|node| node.attribute("d")).unwrap_or_default();
                let (mut ys, mut xs) = (Vec::new(), Vec::new());
                for pair in path.split(['M', 'L', 'Z']).filter(|pair| !pair.trim().is_empty()) {
                    let (x, y) = pair.trim().split_once(' ').unwrap();
                    xs.push(x.parse::<f64>().unwrap());
                    ys.push(y.parse::<f64>().unwrap());
                }
                let mut twice = 0.0;
                for place in 0..xs.len() {
                    let next = (place + 1) % xs.len();
                    twice += xs[place] * ys[next] - xs[next] * ys[place];
                }
                assert!(twice.abs() > 1.0, "{} {}: an empty band, {path}", project.name, candidate.id);
            }
        }
    }
    assert!(bands > 5, "{bands}");
}
