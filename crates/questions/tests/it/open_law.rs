//! The law of motion proposed in place of the assumed one.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail")]

use project::SegmentLaw;
use questions::Progress;
use questions::list::size::law_proposal;
use testkit::projects::{Draws, mechanisms};

/// Smoother laws before the others, with their largest speed and acceleration relative to way and time.
const ORDER: [&str; 4] = ["modified_sine", "modified_trapezoid", "trapezoid", "triangle"];

fn text(sections: &str, [there, back]: [&str; 2], distance: f64, time: f64) -> String {
    let moved = |law: &str, distance: f64| {
        format!("[[motion]]\nlaw = \"{law}\"\ndistance = \"{distance} deg\"\ntime = \"{time:.5} s\"\n")
    };
    format!(
        "format = 1\n[axis]\n{sections}{}{}[[motion]]\nlaw = \"dwell\"\ntime = \"0.3 s\"\n",
        moved(there, distance),
        moved(back, -distance)
    )
}

/// The law proposed for every mechanism whose cycle is a little too short, written into the file gives the named actuator
/// with its verdict, and no smoother one an actuator; a law that is stated stays.
#[test]
fn a_proposed_law_fits_as_it_is_written_and_no_smoother_one_does() {
    let (mut proposed, mut none) = (0, 0);
    for drawn in mechanisms(&mut Draws::new(5)) {
        let best = |text: &str| {
            let project = questions::read(text).ok()?;
            questions::size(&project).answer().map(|best| (best.id.to_string(), best.fit()))
        };
        let open = |time: f64| text(&drawn.sections, ["open", "open"], 40.0, time);
        // The shortest time of the assumed law, and one that is shorter by a few per cent.
        let (mut low, mut high) = (0.02, 8.0);
        if best(&open(high)).is_none() || best(&open(low)).is_some() {
            continue;
        }
        for _ in 0..9 {
            let middle = f64::sqrt(low * high);
            if best(&open(middle)).is_some() { high = middle } else { low = middle }
        }
        for time in [low, low * 0.6] {
            let project = questions::read(&open(time)).unwrap();
            let found = law_proposal(&project, &Progress::endless()).unwrap();
            let stated = |law: &str| text(&drawn.sections, [law, law], 40.0, time);
            let fitting: Vec<_> = ORDER.iter().map(|law| (*law, best(&stated(law)))).collect();
            let first = fitting.iter().find_map(|(law, best)| Some((*law, best.clone()?)));
            let Some(found) = found else {
                assert_eq!(first, None, "{}", drawn.key);
                none += 1;
                continue;
            };
            let law = SegmentLaw::Law(found.law).id();
            assert_eq!(first, Some((law, (found.code, found.fit))), "{}", drawn.key);
            assert_eq!(found.paths, ["motion[1].law", "motion[2].law"]);
            proposed += 1;
            // Only the open move takes another law.
            let half = text(&drawn.sections, ["polynomial_5", "open"], 40.0, time);
            let half = law_proposal(&questions::read(&half).unwrap(), &Progress::endless()).unwrap();
            assert!(half.is_none_or(|half| half.paths == ["motion[2].law"]));
            let decided = questions::read(&stated("polynomial_5")).unwrap();
            assert_eq!(law_proposal(&decided, &Progress::endless()), Ok(None));
        }
    }
    assert!(proposed >= 5 && none >= 2, "{proposed} {none}");
}
