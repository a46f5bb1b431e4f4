//! The actuator of an answer where nothing fits: every answer names the same actuator and says how it came to it; a load case of a bolted joint holds only
//! if it holds with the tilting moment too.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail")]

use answers::{Block, Verdict};
use quantities::Language;
use questions::list::mount::MountInputs;
use questions::list::size::{self, sized};
use questions::{Progress, Rejected};
use words::{mounting, terms, verdict_word};

/// Requirements that exclude every actuator: by the place of installation, and by a bore that none has.
const EXCLUDING: [&str; 2] = ["humidity_max = 0.85", "hollow_shaft_min = \"200 mm\""];

#[test]
fn where_each_is_excluded_every_answer_names_the_same() {
    for requirement in EXCLUDING {
        let text = format!(
            "format = 1\n[load]\ninertia = \"1.3 kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\n\
             accelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n[requirements]\n{requirement}\n"
        );
        let project = questions::read(&text).unwrap();
        let found =
            size::ranking(&project, 3, questions::Draw { samples: None, seed: 1 }, &Progress::endless()).unwrap();
        let record = found.record(Language::En);
        let named = record.nearest_miss.clone();
        assert!(record.answer.is_none() && named.is_some(), "{requirement}: {:?}", record.nearest_miss);
        let ranked = || Ok(std::borrow::Cow::Owned(sized(&project, 1, Rejected::Nearest, &Progress::endless())?));
        let about = questions::candidate_for(&project, None, ranked).unwrap();
        assert_eq!(Some(about.id.to_string()), named, "{requirement}");
        let how = about.how_named(Language::En).unwrap();
        assert!(how.contains("smallest excess") && !how.contains("best"), "{how}");
    }
}

#[test]
fn a_joint_that_slips_with_the_tilting_moment_does_not_hold() {
    let (mut beyond, language) = (0, Language::En);
    for (code, _) in crate::catalogue_actuators().step_by(7) {
        let inputs = MountInputs::default();
        let Some(found) = questions::list::mount::mount(code, &inputs) else { continue };
        let chapter = questions::chapter::mount(&questions::answer::mount(&found, &inputs, None, language), language);
        for block in chapter.blocks {
            let Block::Grid(grid) = block else { continue };
            let place = |head: &str| grid.columns.iter().position(|column| column.head == head);
            let (verdict, both) = (place(terms::verdict(language)), place(mounting::with_moment_percent(language)));
            let (Some(verdict), Some(both)) = (verdict, both) else { continue };
            for row in &grid.rows {
                if row[both].parse::<f64>().is_ok_and(|percent| percent > 100.0) {
                    beyond += 1;
                    assert_ne!(row[verdict], verdict_word(Verdict::Pass, language), "{code}: {row:?}");
                }
            }
        }
    }
    assert!(beyond > 3, "{beyond}");
}
