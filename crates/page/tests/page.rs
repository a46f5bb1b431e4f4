//! The page from outside: what a shell sends in, what it gets.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use page::{Call, Entry, Folder, Method, Reply, SaveFault, Shell, respond};
use std::cell::RefCell;
use std::collections::BTreeMap;
use workbench::{Files, Language, NoFiles, Patience, template, template_kinds};

struct Alone;

impl Shell for Alone {
    fn files(&self) -> &dyn Files {
        &NoFiles
    }

    fn version(&self, bytes: &[u8]) -> String {
        bytes.len().to_string()
    }
}

fn form(fields: &[(&str, &str)]) -> String {
    let one = |(key, value): &(&str, &str)| {
        let code = |text: &str| text.bytes().map(|byte| format!("%{byte:02x}")).collect::<String>();
        format!("{}={}", code(key), code(value))
    };
    fields.iter().map(one).collect::<Vec<_>>().join("&")
}

fn post(path: &str, fields: &[(&str, &str)]) -> Reply {
    let body = form(fields);
    let media = Some("application/x-www-form-urlencoded");
    let call = Call { method: Method::Post, path, query: "", media, body: body.as_bytes(), language: Language::En };
    respond(&call, &Alone, &Patience::endless())
}

fn get(path: &str, query: &str) -> Reply {
    let call = Call { method: Method::Get, path, query, media: None, body: &[], language: Language::En };
    respond(&call, &Alone, &Patience::endless())
}

fn page(reply: &Reply) -> String {
    assert_eq!(reply.status, 200);
    String::from_utf8(reply.body.clone()).unwrap()
}

/// The tags of a page are closed in order, no identifier stands twice, and every attribute is quoted.
fn whole(html: &str) {
    const VOID: [&str; 6] = ["input", "meta", "link", "br", "hr", "img"];
    let mut open: Vec<&str> = Vec::new();
    let mut ids: BTreeMap<&str, usize> = BTreeMap::new();
    let mut rest = html;
    while let Some(at) = rest.find('<') {
        let tag = &rest[at + 1..];
        let end = tag.find('>').unwrap_or_else(|| panic!("no end: {}", &tag[..tag.len().min(80)]));
        let (inside, behind) = (&tag[..end], &tag[end + 1..]);
        rest = behind;
        if inside.starts_with('!') {
            continue;
        }
        if let Some(name) = inside.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "{}", &rest[..rest.len().min(120)]);
            continue;
        }
        let name = inside.split([' ', '/', '\n']).next().unwrap_or_default();
        if let Some(id) = inside.split(" id=\"").nth(1).and_then(|id| id.split('"').next()) {
            *ids.entry(id).or_default() += 1;
        }
        assert_eq!(inside.matches('"').count() % 2, 0, "{inside}");
        if !VOID.contains(&name) && !inside.ends_with('/') {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{open:?}");
    let twice: Vec<_> = ids.iter().filter(|(_, count)| **count > 1).collect();
    assert!(twice.is_empty(), "{twice:?}");
}

#[test]
fn every_example_is_a_whole_page_in_both_languages() {
    whole(&page(&get("/", "")));
    for kind in template_kinds().filter(|kind| *kind != "recording") {
        for (lang, word) in [("en", "What it demands"), ("de", "Was es verlangt")] {
            let html = page(&get("/", &format!("new={kind}&lang={lang}")));
            whole(&html);
            assert!(html.contains(word) && html.contains("id=\"plot-cycle\""), "{kind}");
            assert!(!html.contains("undefined") && !html.contains("NaN"), "{kind}");
        }
    }
}

#[test]
fn a_changed_field_changes_text_and_verdict_and_leaves_the_rest() {
    let text = template("belt", "axis.toml", Language::En).unwrap().text;
    let html = page(&post("/work", &[("text", &text), ("path", "mechanism.belt.mass"), ("value", "60 kg")]));
    assert!(
        html.contains("mass = &quot;60 kg&quot;") || html.contains("mass = \"60 kg\""),
        "{}",
        &html[html.len() - 3000..]
    );
    assert!(html.contains("# carriage and gripper") && html.contains("276 actuators judged"));
    whole(&html);
    let heavy = page(&post("/work", &[("text", &text), ("path", "mechanism.belt.mass"), ("value", "6000 kg")]));
    assert!(heavy.contains("No actuator of the catalogue fits"));
}

#[test]
fn a_fault_stands_at_its_field_beside_the_last_good_result() {
    let text = template("belt", "axis.toml", Language::En).unwrap().text;
    let fields = [("text", text.as_str()), ("good", text.as_str()), ("path", "mechanism.belt.mass"), ("value", "60")];
    let html = page(&post("/work", &fields));
    whole(&html);
    let row = html.split("data-path=\"mechanism.belt.mass\"").nth(1).unwrap();
    let row = &row[..row.find("data-path=").unwrap()];
    assert!(row.contains("aria-invalid=\"true\"") && row.contains("the unit is missing"), "{row}");
    assert!(html.contains("belongs to the last project without faults") && html.contains("id=\"plot-cycle\""));
    let broken = page(&post("/work", &[("text", "format = = 1"), ("good", &text)]));
    assert!(broken.contains("<fieldset id=\"fields\" disabled"), "what has no place cannot be changed");
    let nothing = page(&post("/work", &[("text", "format = 1\n")]));
    assert!(nothing.contains("No result before the project is whole"));
    whole(&nothing);
}

#[test]
fn hostile_texts_are_shown_and_do_nothing() {
    let text = "format = 1\n[axis]\nname = \"</textarea><script>alert(1)</script>\"\n[load]\ninertia = \"<b>\"\n";
    let html = page(&post("/work", &[("text", text)]));
    assert!(!html.contains("<script>alert") && !html.contains("<b>"), "{html}");
    whole(&html);
    for path in ["", "..", "motion[99999]", "axis[3].x", "<x>", "motion[1].bearing.radial_force.x"] {
        let html = page(&post("/work", &[("text", text), ("path", path), ("value", "1")]));
        whole(&html);
    }
}

#[test]
fn segments_come_and_go_and_a_mechanism_is_changed() {
    let text = template("belt", "axis.toml", Language::En).unwrap().text;
    let more = page(&post(
        "/work",
        &[("text", &text), ("do", "table motion[5]\nvalue motion[5].law=dwell\nvalue motion[5].time=1 s")],
    ));
    assert!(more.contains("id=\"f-motion-5--law\"") && !more.contains("aria-invalid"));
    let arm = page(&post("/work", &[("text", &text), ("good", &text), ("do", "instead mechanism.arm\ngone load")]));
    let text = arm.split("id=\"text\"").nth(1).unwrap();
    assert!(arm.contains("id=\"f-mechanism-arm-centre_distance\"") && !text.contains("[mechanism.belt]"));
    whole(&arm);
}

#[test]
fn numbers_are_explained_and_actuators_compared() {
    let text = template("belt", "axis.toml", Language::En).unwrap().text;
    let told = page(&post("/explain", &[("text", &text), ("check", "peak_torque")]));
    assert!(told.contains("T<sub>peak</sub>") && told.contains("class=\"formula\""), "{told}");
    let fields = [("text", text.as_str()), ("mark", "CHA-25A-50-H-C1024"), ("mark", "CHA-32A-50-H-C1024")];
    let compared = page(&post("/compare", &fields));
    assert!(compared.contains("CHA-25A-50-H-C1024") && compared.contains("CHA-32A-50-H-C1024"));
    whole(&compared);
}

#[test]
fn tools_answer_for_a_whole_code_a_part_of_one_and_none() {
    for tool in ["code", "data", "wiring", "mount", "commission", "upkeep", "errata", "glossary"] {
        for about in ["CHA-25A-100-H-M512P-B", "CHA-25A", "CHA-25A-100-H-X9", ""] {
            for lang in ["en", "de"] {
                let html = page(&post(
                    "/tools",
                    &[("tool", tool), ("about", about), ("lang", lang), ("delivered", "2026-03-01")],
                ));
                whole(&html);
                assert!(html.len() > 1500, "{tool} {about}: {html}");
            }
        }
    }
}

#[test]
fn what_is_not_there_is_told() {
    assert_eq!(get("/nowhere", "").status, 404);
    assert_eq!(get("/assets/../lib.rs", "").status, 404);
    assert_eq!(get("/assets/page.js", "").status, 200);
    assert_eq!(post("/save", &[("text", "format = 1\n"), ("file", "a.toml")]).status, 404, "no folder to save in");
}

/// A folder in memory that keeps to what a folder promises.
#[derive(Default)]
struct InMemory(RefCell<BTreeMap<String, Vec<u8>>>);

impl Folder for InMemory {
    fn list(&self) -> std::io::Result<Vec<Entry>> {
        Ok(self.0.borrow().keys().map(|name| Entry { name: name.clone(), modified_s: 0 }).collect())
    }

    fn read(&self, name: &str) -> std::io::Result<Vec<u8>> {
        self.0.borrow().get(name).cloned().ok_or_else(|| std::io::ErrorKind::NotFound.into())
    }

    fn save(&self, name: &str, text: &[u8], known: Option<&str>) -> Result<(), SaveFault> {
        let there = self.0.borrow().get(name).map(|bytes| self.version(bytes));
        if there.as_deref() != known {
            return Err(SaveFault::Changed);
        }
        let _ = self.0.borrow_mut().insert(name.to_owned(), text.to_vec());
        Ok(())
    }

    fn keep(&self, _: &str, _: &[u8]) -> Result<String, SaveFault> {
        Err(SaveFault::Name)
    }
}

impl Shell for InMemory {
    fn files(&self) -> &dyn Files {
        &NoFiles
    }

    fn folder(&self) -> Option<&dyn Folder> {
        Some(self)
    }

    fn version(&self, bytes: &[u8]) -> String {
        format!("{bytes:x?}").replace(' ', "")
    }
}

#[test]
fn a_version_belongs_to_the_name_that_was_opened() {
    let folder = InMemory::default();
    let save = |file: &str, text: &str, known: &str| {
        let body = form(&[("text", text), ("file", file), ("known", known)]);
        let media = Some("application/x-www-form-urlencoded");
        let call = Call {
            method: Method::Post,
            path: "/save",
            query: "",
            media,
            body: body.as_bytes(),
            language: Language::En,
        };
        let reply = respond(&call, &folder, &Patience::endless());
        let known = reply.headers.iter().find(|(name, _)| *name == "x-version").map(|(_, value)| value.clone());
        (reply.status, known.map(|version| format!("{version} {file}")).unwrap_or_default())
    };
    let (status, known) = save("a.toml", "format = 1\n", "");
    assert_eq!(status, 200);
    assert_eq!(save("a.toml", "format = 1 # x\n", "").0, 409, "another version stands there");
    assert_eq!(save("b.toml", "format = 1\n", &known).0, 200, "under another name it is a new file");
    assert_eq!(save("b.toml", "format = 1 # y\n", &known).0, 409, "the name is taken by now");
    let (status, newer) = save("a.toml", "format = 1 # z\n", &known);
    assert_eq!(status, 200);
    assert_eq!(save("a.toml", "format = 1\n", &known).0, 409);
    assert_eq!(save("a.toml", "format = 1\n", &newer).0, 200);
}

#[test]
fn a_file_that_is_no_text_is_not_opened() {
    let folder = InMemory::default();
    let _ = folder.0.borrow_mut().insert(String::from("latin.toml"), b"# M\xfcller\nformat = 1\n".to_vec());
    let call = Call {
        method: Method::Get,
        path: "/",
        query: "open=latin.toml",
        media: None,
        body: &[],
        language: Language::En,
    };
    assert_eq!(respond(&call, &folder, &Patience::endless()).status, 422);
}
