//! The page from outside: calls of a shell, and its replies.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use quantities::Language;
use questions::list::new::{example, template_kinds};
use shell::{InMemory, get, page, post, whole};

#[test]
fn every_example_is_a_whole_page_in_both_languages() {
    whole(&page(&get("/", "")));
    for kind in template_kinds().filter(|kind| !matches!(*kind, "recording" | "joint")) {
        for (lang, word) in [("en", "Demand"), ("de", "Belastung")] {
            let html = page(&get("/", &format!("new={kind}&lang={lang}")));
            whole(&html);
            assert!(html.contains(word) && html.contains("id=\"plot-cycle\""), "{kind}");
            assert!(!html.contains("undefined") && !html.contains("NaN"), "{kind}");
        }
    }
}

#[test]
fn a_changed_field_changes_text_and_verdict_and_leaves_the_rest() {
    let text = example("belt", "axis.toml", Language::En).unwrap().text;
    let html = page(&post("/work", &[("text", &text), ("path", "mechanism.belt.mass"), ("value", "60 kg")]));
    assert!(
        html.contains("mass = &quot;60 kg&quot;") || html.contains("mass = \"60 kg\""),
        "{}",
        &html[html.len() - 3000..]
    );
    assert!(html.contains("# carriage and gripper") && html.contains("276 actuators evaluated"));
    whole(&html);
    let heavy = page(&post("/work", &[("text", &text), ("path", "mechanism.belt.mass"), ("value", "6000 kg")]));
    assert!(heavy.contains("No actuator in the catalogue fits"));
}

#[test]
fn a_fault_stands_at_its_field_beside_the_last_good_result() {
    let text = example("belt", "axis.toml", Language::En).unwrap().text;
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
    assert!(nothing.contains("No result until the project is complete"));
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
    let text = example("belt", "axis.toml", Language::En).unwrap().text;
    let more = page(&post(
        "/work",
        &[("text", &text), ("do", "table motion[5]\nvalue motion[5].law=dwell\nvalue motion[5].time=1 s")],
    ));
    assert!(more.contains("id=\"f-motion-5--law\"") && !more.contains("aria-invalid"));
    let arm = page(&post("/work", &[("text", &text), ("good", &text), ("do", "instead mechanism.arm\ngone load")]));
    let text = arm.split("id=\"text\"").nth(1).unwrap();
    assert!(arm.contains("id=\"f-mechanism-arm-length\"") && !text.contains("[mechanism.belt]"));
    whole(&arm);
}

#[test]
fn numbers_are_explained_and_actuators_compared() {
    let text = example("belt", "axis.toml", Language::En).unwrap().text;
    let html = page(&post("/explain", &[("text", &text), ("check", "peak_torque")]));
    assert!(html.contains("<mi>T</mi><mtext>peak</mtext>") && html.contains("class=\"formula\""), "{html}");
    assert!(
        html.contains("alttext=\"J\u{202f}out · α + T\u{202f}L\"") && html.contains("page 18 of the manual"),
        "{html}"
    );
    let fields = [("text", text.as_str()), ("mark", "CHA-25A-50-H-C1024"), ("mark", "CHA-32A-50-H-C1024")];
    let compared = page(&post("/compare", &fields));
    assert!(compared.contains("CHA-25A-50-H-C1024") && compared.contains("CHA-32A-50-H-C1024"));
    whole(&compared);
}

#[test]
fn what_is_not_there_is_reported() {
    assert_eq!(get("/nowhere", "").status, 404);
    assert_eq!(get("/assets/../lib.rs", "").status, 404);
    assert_eq!(get("/assets/page.js", "").status, 200);
    assert_eq!(post("/save", &[("text", "format = 1\n"), ("file", "a.toml")]).status, 404, "no folder to save in");
}

#[test]
fn what_is_refused_unasked_is_told_as_that_and_not_as_stopped() {
    let moves = "[[motion]]\nlaw = \"modified_sine\"\ndistance = \"40 deg\"\ntime = \"0.7 s\"\n".repeat(300);
    let ratios = (2..18).map(|ratio| format!("{ratio}.0")).collect::<Vec<_>>().join(", ");
    let text = format!(
        "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[stage]\nkind = \"belt\"\nratios = [{ratios}]\nefficiency = 0.95\n\
         {moves}[requirements]\nsupply = \"560 V\"\nambient = \"30 degC\"\n"
    );
    let html = page(&post("/work", &[("text", &text)]));
    assert!(html.contains("16 stage ratios") && !html.contains("was cancelled"), "{}", &html[..2000.min(html.len())]);
    assert!(!html.contains("id=\"again\""), "the same question would be refused again");
}

/// A field that is emptied to be filled anew stays where it is; once another one is typed in it goes behind its fold.
#[test]
fn a_field_that_is_emptied_does_not_move_away() {
    let text = example("turntable", "axis", Language::En).unwrap().text;
    let at = |path: &str, value: &str| {
        page(&post("/work", &[("text", &text), ("good", &text), ("path", path), ("value", value)]))
    };
    let field = "id=\"f-mechanism-turntable-friction_torque\"";
    assert!(at("mechanism.turntable.friction_torque", "").contains(field));
    let cleared = text.lines().filter(|line| !line.starts_with("friction_torque")).collect::<Vec<_>>().join("\n");
    let other = page(&post("/work", &[("text", &cleared), ("path", "requirements.ambient"), ("value", "31 degC")]));
    assert!(!other.contains(field));
    // Behind a fold it stays there while it gets its first value.
    let filled = |folded: &[(&str, &str)]| {
        let typed = [("text", cleared.as_str()), ("path", "mechanism.turntable.friction_torque"), ("value", "7 N m")];
        page(&post("/work", &[&typed[..], folded].concat()))
    };
    let fold = "id=\"f-mechanism-turntable-m\"";
    let behind = |page: &str| page.find(fold).zip(page.find(field)).is_some_and(|(fold, field)| fold < field);
    assert!(behind(&filled(&[("folded", ""), ("fold", "f-mechanism-turntable-m")])));
    assert!(!behind(&filled(&[("fold", "f-mechanism-turntable-m")])));
}

/// A product of a catalogue file is selected like a code; what is known of ordering codes only says so.
#[test]
fn a_product_of_a_file_is_selected_by_its_name() {
    let folder = InMemory::default();
    let stock = "id;ratio;torque_max [N m];inertia_out [kg m^2]\nA <b> 1;50;70;0,1\nA_b 1;50;80;0,2\n";
    let _ = folder.0.borrow_mut().insert("stock.csv".to_owned(), stock.as_bytes().to_vec());
    let text = example("turntable", "axis", Language::En).unwrap().text;
    let text = text.replacen("format = 1\n", "format = 1\n[catalogue]\nfiles = [\"stock.csv\"]\n", 1);
    let fields = |more: &[(&'static str, &'static str)]| [&[("text", text.as_str()), ("good", &text)], more].concat();
    let html = page(&folder.post("/work", &fields(&[("code", "A <b> 1"), ("list", "rejected")])));
    whole(&html);
    let verdict = html.split("id=\"standing\"").nth(1).unwrap();
    assert!(verdict[..400.min(verdict.len())].contains("A &lt;b&gt; 1"), "{}", &verdict[..400]);
    let tool = page(&folder.post("/tools", &fields(&[("tool", "wiring"), ("about", "A <b> 1")])));
    assert!(tool.contains("product of a catalogue file") && !tool.contains("not known as"), "{tool}");
    // An unknown name leads to the best, as an unknown code does.
    let other = page(&folder.post("/work", &fields(&[("code", "B")])));
    let verdict = other.split("id=\"standing\"").nth(1).unwrap();
    assert!(verdict[..400.min(verdict.len())].contains("CHA-"), "{}", &verdict[..400]);
}
