//! The folder of the page: opening, saving, changes by others.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use page::Reply;
use shell::{InMemory, page, whole};

fn version(reply: &Reply) -> Option<&str> {
    reply.headers.iter().find(|(name, _)| *name == "x-version").map(|(_, value)| value.as_str())
}

fn save(folder: &InMemory, file: &str, text: &str, known: &str) -> (u16, String) {
    let reply = folder.post("/save", &[("text", text), ("file", file), ("known", known)]);
    (reply.status, version(&reply).map(|version| format!("{version} {file}")).unwrap_or_default())
}

#[test]
fn a_version_belongs_to_the_name_that_was_opened() {
    let folder = InMemory::default();
    let save = |file: &str, text: &str, known: &str| save(&folder, file, text, known);
    let (status, known) = save("a.toml", "format = 1\n", "");
    assert_eq!(status, 200);
    assert_eq!(save("a.toml", "format = 1 # x\n", "").0, 409, "differs from the one opened here stands there");
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
    assert_eq!(folder.get("/", "open=latin.toml").status, 422);
    assert_eq!(folder.get("/text", "file=latin.toml").status, 422);
}

/// Decodes the value of a form field.
fn decoded(value: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = value.bytes();
    while let Some(byte) = rest.next() {
        bytes.push(match byte {
            b'+' => b' ',
            b'%' => {
                let digits = [rest.next().unwrap(), rest.next().unwrap()];
                u8::from_str_radix(std::str::from_utf8(&digits).unwrap(), 16).unwrap()
            }
            byte => byte,
        });
    }
    String::from_utf8(bytes).unwrap()
}

/// Decodes a percent-encoded text, as `decodeURIComponent` does.
fn percent_decoded(text: &str) -> String {
    decoded(&text.replace('+', "%2B").replace(' ', "+"))
}

/// Two tabs on one file: the second to save gets a message and both choices; no text is lost.
#[test]
fn what_another_has_saved_is_noticed_and_asked_about() {
    let folder = InMemory::default();
    let (_, first) = save(&folder, "a.toml", "format = 1 # first\n", "");
    let watch = |known: &str| folder.get("/watch", &format!("known={}", known.replace(' ', "+")));
    assert_eq!(watch(&first).status, 204, "nobody else was there");
    assert_eq!(watch("").status, 204, "nothing was opened");
    let (_, second) = save(&folder, "a.toml", "format = 1 # second\n", &first);
    assert_eq!(watch(&first).status, 200, "another has saved");
    // Both changed the same line, in which no value can be joined: the page asks.
    let merge = [("known", &*first), ("base", "format = 1 # first\n"), ("text", "format = 2 # mine\n")];
    let asked = String::from_utf8(folder.post("/merge", &merge).body).unwrap();
    let html = decoded(asked.strip_prefix("notice=").unwrap_or_else(|| panic!("no question: {asked}")));
    whole(&html);
    assert!(html.contains("differs from the one opened here") && html.contains("data-disk=\"load\""), "{html}");
    assert!(html.contains(&format!("data-disk=\"mine\" data-known=\"{second}\"")), "{html}");
    // Loads it: its text, and its version from then on.
    let text = folder.get("/text", "file=a.toml");
    assert_eq!(text.body, b"format = 1 # second\n");
    assert_eq!(version(&text).map(|version| format!("{version} a.toml")).as_deref(), Some(second.as_str()));
    // Keeps one's own version: the next save is based on the reported version.
    assert_eq!(save(&folder, "a.toml", "format = 1 # mine\n", &first).0, 409);
    assert_eq!(save(&folder, "a.toml", "format = 1 # mine\n", &second).0, 200);
    let _ = folder.0.borrow_mut().remove("a.toml");
    let gone = page(&watch(&second));
    assert!(gone.contains("data-known=\"\"") && !gone.contains("data-disk=\"load\""), "{gone}");
    assert_eq!(save(&folder, "a.toml", "format = 1 # mine\n", "").0, 200, "written anew");
}

/// A header holds ASCII; the page decodes the name, so that the next save goes to the same file.
#[test]
fn a_name_with_any_letters_comes_back_as_it_is_on_disk() {
    let folder = InMemory::default();
    for name in ["Hubwerk Süd.toml", "軸.toml", "100 %.toml", "plain.toml"] {
        let reply = folder.post("/save", &[("text", "format = 1\n"), ("file", name), ("known", "")]);
        assert_eq!(reply.status, 200, "{name}");
        let sent = &reply.headers.iter().find(|(header, _)| *header == "x-file").unwrap().1;
        assert!(sent.is_ascii(), "{sent}");
        let written = folder.0.borrow().keys().next().cloned().unwrap();
        assert_eq!(percent_decoded(sent), written);
        folder.0.borrow_mut().clear();
    }
}

/// A new axis under the name of a file that was not opened: a free name comes first, replacing is a choice of its own.
#[test]
fn a_new_axis_does_not_replace_the_file_of_another() {
    let folder = InMemory::default();
    let (_, other) = save(&folder, "axis.toml", "format = 1 # other\n", "");
    let _ = save(&folder, "axis-2.toml", "format = 1 # second\n", "");
    assert_eq!(save(&folder, "axis.toml", "format = 1 # new\n", "").0, 409);
    let merge = [("known", " axis.toml"), ("base", ""), ("text", "format = 1 # new\n")];
    let asked = String::from_utf8(folder.post("/merge", &merge).body).unwrap();
    let html = decoded(asked.strip_prefix("notice=").unwrap_or_else(|| panic!("no question: {asked}")));
    whole(&html);
    assert!(html.contains("data-disk=\"as\" data-name=\"axis-3.toml\""), "{html}");
    assert!(html.contains(&format!("data-disk=\"over\" data-known=\"{other}\"")), "{html}");
    assert!(!html.contains("data-disk=\"mine\""), "{html}");
}

#[test]
fn an_example_brings_its_recording_and_leaves_that_of_others() {
    let folder = InMemory::default();
    let html = page(&folder.post("/example", &[("kind", "recording")]));
    whole(&html);
    assert!(html.contains("file = \"axis.csv\"") && html.contains("id=\"plot-cycle\""));
    let again = page(&folder.post("/example", &[("kind", "recording")]));
    assert!(again.contains("file = \"2-axis.csv\"") && again.contains("id=\"plot-cycle\""));
    let start = page(&folder.get("/", ""));
    assert!(start.contains("action=\"/example?kind=recording"), "a link does not write into the folder");
}

#[test]
fn the_files_of_the_folder_are_listed_with_their_day() {
    let folder = InMemory::default();
    let _ = save(&folder, "a&b.toml", "format = 1\n", "");
    for html in [page(&folder.get("/files", "")), page(&folder.get("/", ""))] {
        whole(&html);
        assert!(html.contains("/?open=a%26b.toml&amp;lang=en") && html.contains("2026-03-01"), "{html}");
    }
}

#[test]
fn a_record_of_measured_values_opens_in_its_tool() {
    let folder = InMemory::default();
    let text = "format = 1\n[winding]\ntemperature = \"20 degC\"\nresistance_ll = \"3.7 ohm\"\n";
    let _ = save(&folder, "CHA-25A-100-H-M512P-B-measured.toml", text, "");
    let html = page(&folder.get("/", "open=CHA-25A-100-H-M512P-B-measured.toml"));
    whole(&html);
    assert!(html.contains("id=\"t-winding.resistance_ll\"") && html.contains("value=\"3.7 ohm\""), "{html}");
    assert!(!html.contains("id=\"standing\""));
}
