//! The report of real answers, of poor ones and of hostile ones.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test that cannot panic cannot fail")]

mod samples;

use quantities::Language;
use report::{Content, Fault, Figure, Settings};
use serde_json::{Value, json};

/// Letters and digits only: line breaks, indices and narrow spaces are a matter of setting.
fn letters(text: &str) -> String {
    text.chars().filter(|sign| sign.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

fn text_of(content: &Content) -> String {
    letters(&report::page_texts(content, &samples::settings()).unwrap().concat())
}

fn bare(data: Value) -> Content {
    Content { language: Language::En, data, figures: Vec::new() }
}

fn sample(name: &str) -> Content {
    let (_, answers, project, language) = samples::SAMPLES.into_iter().find(|sample| sample.0 == name).unwrap();
    samples::content(answers, project, language)
}

/// A sample with few checks and nothing else: enough for what every page has, and quick to set.
fn short(name: &str) -> Value {
    let mut data = sample(name).data;
    let check = data["check"].take();
    let mut short = json!({ "check": check, "inputs": data["inputs"] });
    short["check"]["checks"].as_array_mut().unwrap().truncate(3);
    short
}

#[test]
fn every_sample_says_all_that_its_data_say() {
    for (name, answers, project, language) in samples::SAMPLES {
        let content = samples::content(answers, project, language);
        let text = text_of(&content);
        let says = |part: &str| assert!(text.contains(&letters(part)), "{name}: {part}");
        let check = &content.data["check"];
        says(check["code"].as_str().unwrap());
        for each in check["checks"].as_array().unwrap() {
            says(each["title"].as_str().unwrap());
            if each["verdict"] == "not_checked" {
                says(each["missing"].as_str().unwrap());
            }
            for note in each["notes"].as_array().unwrap() {
                says(note.as_str().unwrap());
            }
            for source in each["source"].as_str().unwrap_or_default().split("; ") {
                says(source);
            }
        }
        for assumption in check["assumptions"].as_array().unwrap() {
            says(assumption.as_str().unwrap());
        }
        for rejected in content.data["sizing"]["rejected"].as_array().unwrap() {
            says(rejected["code"].as_str().unwrap());
        }
        for input in report::inputs(project).unwrap() {
            says(input.key.rsplit('.').next().unwrap());
        }
        if name == "indexing-table-en" {
            says("32A-C1024-I_0-50 T_0/k_Tout");
        }
        for figure in &content.figures {
            says(&figure.caption);
        }
        for part in ["AX-4711-02", "E. Example", content.data["hash"]["project"].as_str().unwrap()] {
            says(part);
        }
    }
}

/// Without spaces of any width, which stand between number, unit and groups of digits.
fn dense(text: &str) -> String {
    text.chars().filter(|sign| !sign.is_whitespace()).collect()
}

/// A figure of the JSON as a reader of that language finds it: four digits, no zeros at the end.
fn printed(value: f64, language: Language) -> String {
    let text = quantities::format_significant(value, 4, language);
    let point = if language == Language::De { ',' } else { '.' };
    let (mantissa, power) = text.split_at(text.find('·').unwrap_or(text.len()));
    let short =
        if mantissa.contains(point) { mantissa.trim_end_matches('0').trim_end_matches(point) } else { mantissa };
    dense(&format!("{short}{power}"))
}

#[test]
fn every_number_of_a_check_stands_in_the_report_as_it_is_in_the_answer() {
    for (name, answers, project, language) in samples::SAMPLES {
        let content = samples::content(answers, project, language);
        let text = dense(&report::page_texts(&content, &samples::settings()).unwrap().concat());
        let mut numbers = 0;
        for check in content.data["check"]["checks"].as_array().unwrap() {
            let unit = match check["unit"].as_str() {
                None | Some("1") => "",
                Some("deg") => "°",
                Some(unit) => quantities::Unit::of(unit).map_or(unit, |unit| unit.symbol),
            };
            for key in ["value", "limit"] {
                let Some(value) = check[key].as_f64() else { continue };
                let figure = format!("{}{unit}", printed(value, language));
                assert!(text.contains(&dense(&figure)), "{name}, {} {key}: {figure}", check["id"]);
                numbers += 1;
            }
            if let Some(share) = check["utilisation"].as_f64().filter(|share| *share * 100.0 >= 0.05) {
                let percent = dense(&format!("{}%", quantities::format_number(share * 100.0, 1, language)));
                assert!(text.contains(&percent), "{name}, {}: {percent}", check["id"]);
            }
        }
        assert!(numbers > 30, "{name}: {numbers}");
    }
}

#[test]
fn the_language_is_that_of_headings_and_numbers() {
    let mut content = sample("indexing-table-en");
    let pages = report::page_texts(&content, &samples::settings()).unwrap().concat();
    assert!(pages.contains("Sizing report") && pages.contains("110.6"));
    content.language = Language::De;
    let pages = report::page_texts(&content, &samples::settings()).unwrap().concat();
    assert!(pages.contains("Auslegungsbericht") && pages.contains("110,6") && pages.contains("21.11.2026"));
    assert!(!pages.contains("110.6"));
}

#[test]
fn no_text_stands_upon_another() {
    for (name, answers, project, language) in samples::SAMPLES {
        let mut content = samples::content(answers, project, language);
        let source = "Tabelle 79.1, transmissible_torque_load (entfettete Fuge, Reibungszahl 0,15), i = 100";
        let text = "Schrauben zwischen Gehäuse und Maschine; Länge nach dem verschraubten Teil";
        let row = json!({ "joint": "Gehäuse", "screws": "12 × M3, 12.9", "circle": "80 mm", "torque": "2,3 Nm",
            "text": "überträgt 158 Nm, trocken", "source": source });
        content.data["screws"] = json!([row, row]);
        let item = json!({ "item": "1", "quantity": "12", "code": "CHA-17A-100-H-M128S-B-EC-K", "text": text, "source": source });
        content.data["bill_of_material"] = json!([item, item]);
        let pin = json!({ "connector": "X1", "pin": "12", "signal": "U_REF", "colour": "weiß-grün", "text": text, "source": source });
        content.data["wiring"] = json!([pin]);
        let found = report::overlaps(&content, &samples::settings()).unwrap();
        assert!(found.is_empty(), "{name}: {found:#?}");
    }
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let content = sample("screw-axis-de");
    let first = report::pdf(&content, &samples::settings()).unwrap();
    let second = report::pdf(&content, &samples::settings()).unwrap();
    assert!(first == second, "two runs differ");
    let has = |part: &str| first.windows(part.len()).any(|window| window == part.as_bytes());
    assert!(first.starts_with(b"%PDF-1.7"));
    for part in ["pdfaid:part", "pdfaid:conformance", "MarkInfo", "StructTreeRoot", "/Lang"] {
        assert!(has(part), "{part}");
    }
}

#[test]
fn what_is_missing_leaves_a_report_without_it() {
    let date = Some("2026-11-21".to_owned());
    let settings = Settings { date, pdf_a: true, ..Settings::default() };
    for data in [Value::Null, json!({}), json!({ "check": null, "sizing": null, "inputs": [] })] {
        let bytes = report::pdf(&bare(data), &settings).unwrap();
        assert!(bytes.starts_with(b"%PDF"));
    }
    let plain = report::pdf(&bare(json!({})), &Settings::default()).unwrap();
    assert!(plain.starts_with(b"%PDF"));
}

#[test]
fn each_part_of_the_data_may_be_left_out() {
    let whole = sample("indexing-table-fails-en");
    for key in ["check", "sizing", "explain"] {
        let mut content = whole.clone();
        content.data.as_object_mut().unwrap().remove(key);
        content.figures.clear();
        assert!(!report::page_texts(&content, &samples::settings()).unwrap().is_empty(), "{key}");
    }
}

#[test]
fn every_mechanism_has_its_drawing() {
    for (kind, keys) in samples::MECHANISMS {
        let text = text_of(&samples::mechanism(kind, keys, Language::En));
        assert!(text.contains(&letters("Principle, not to scale")), "{kind}");
    }
    let text = text_of(&samples::mechanism("ferris_wheel", &["gondolas"], Language::De));
    assert!(text.contains("gondolas") && !text.contains(&letters("Prinzipskizze")));
}

#[test]
fn what_the_later_chapters_bring_is_set() {
    let text = text_of(&bare(json!({
        "bill_of_material": [{ "item": "1", "quantity": "2", "code": "CHA-X", "text": "cable", "source": "table 90.1" }],
        "wiring": [{ "connector": "X1", "pin": "7", "signal": "sine plus", "colour": "green" }],
        "screws": [{ "joint": "load side", "screws": "8 × M5", "torque": "9 Nm" }],
        "errata": [{ "id": "25A-M512P-m", "text": "4.9 kg should read 5.9 kg" }],
        "sources": [{ "id": "cha-manual", "title": "Project planning manual" }],
        "recordings": [{ "file": "run.csv", "samples": 12, "note": "two columns" }],
    })));
    for part in ["CHA-X", "sine plus", "8 × M5", "should read", "planning manual", "run.csv"] {
        assert!(text.contains(&letters(part)), "{part}");
    }
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
    for name in names {
        let mut data = short("indexing-table-en");
        data["check"]["axis"] = json!(name);
        data["check"]["code"] = json!(name);
        data["check"]["objections"] = json!([name]);
        data["check"]["checks"][0]["title"] = json!(name);
        data["check"]["checks"][0]["notes"] = json!([name]);
        data["inputs"][1]["text"] = json!(name);
        data["inputs"][1]["key"] = json!(name);
        data["sizing"] = json!({ "rejected": [{ "code": name, "objections": [name] }] });
        let settings = Settings {
            project: name.clone(),
            revision: name.clone(),
            author: name.clone(),
            number: name.clone(),
            ..samples::settings()
        };
        let content = bare(data);
        report::pdf(&content, &settings).unwrap_or_else(|fault| panic!("{name:?}: {fault}"));
        let text = report::page_texts(&content, &settings).unwrap().concat();
        if name.is_ascii() {
            assert!(letters(&text).contains(&letters(&name)), "{name}");
        }
    }
}

#[test]
fn no_text_leaves_the_page() {
    let mut content = bare(short("indexing-table-fails-en"));
    let long = "Verschraubungsdrehmomentgrenzwert".repeat(8);
    content.data["check"]["axis"] = json!(long);
    content.data["check"]["checks"][0]["title"] = json!(long);
    content.data["check"]["checks"][0]["notes"] = json!([long]);
    content.data["check"]["checks"][0]["source"] = json!(long);
    content.data["inputs"][2]["key"] = json!(format!("load.{long}"));
    content.data["inputs"][2]["text"] = json!(long);
    let settings = Settings { project: long.clone(), author: long.clone(), ..samples::settings() };
    for (page, right) in report::right_edges(&content, &settings).unwrap().into_iter().enumerate() {
        assert!(right < 595.3, "page {}: {right}", page + 1);
    }
}

#[test]
fn what_cannot_be_set_is_a_fault() {
    let wrong = bare(json!({ "check": { "checks": "none" } }));
    assert!(matches!(report::pdf(&wrong, &samples::settings()), Err(Fault::Data { .. })));
    let no_date = Settings { date: Some("yesterday".to_owned()), ..samples::settings() };
    assert!(matches!(report::pdf(&bare(json!({})), &no_date), Err(Fault::Date { .. })));
    let undated = Settings { pdf_a: true, ..Settings::default() };
    assert!(matches!(report::pdf(&bare(json!({})), &undated), Err(Fault::NoDate)));
    let figure = Figure {
        name: "motion".to_owned(),
        svg: "<svg".to_owned(),
        caption: String::new(),
        alternative_text: String::new(),
    };
    let broken = Content { figures: vec![figure], ..bare(json!({})) };
    assert!(matches!(report::pdf(&broken, &samples::settings()), Err(Fault::Typesetting { .. })));
    assert!(matches!(report::inputs("a = ["), Err(Fault::Project { .. })));
}

#[test]
fn inputs_stand_in_the_order_of_the_file_as_written() {
    let inputs =
        report::inputs("b = \"1.30 kg m^2\"\na = 2.50\n[[motion]]\nlaw = \"dwell\"\n[[motion]]\nz = [1, 2]\n").unwrap();
    let found: Vec<(&str, &str)> = inputs.iter().map(|input| (input.key.as_str(), input.text.as_str())).collect();
    assert_eq!(found, [("b", "1.30 kg m^2"), ("a", "2.50"), ("motion[1].law", "dwell"), ("motion[2].z", "[1, 2]")]);
}
