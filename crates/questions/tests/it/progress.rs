//! Work can be cancelled, and too expensive work is refused before it begins.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use axis::{AxisProject, NoFiles};
use questions::{Draw, Progress, Refusal, Unread, embedded_catalogue};

/// An arm that swings many times, each time otherwise, so that no move stands for another.
fn long(count: u32) -> AxisProject {
    questions::read(&swings(count)).unwrap_or_else(|faults| panic!("{faults:#?}"))
}

fn swings(count: u32) -> String {
    let moves: String = (0..count)
        .map(|k| {
            let angle = (40.0 + 0.01 * f64::from(k / 2)) * if k % 2 == 0 { 1.0 } else { -1.0 };
            format!("[[motion]]\nlaw = \"modified_sine\"\ndistance = \"{angle} deg\"\ntime = \"0.7 s\"\n")
        })
        .collect();
    format!(
        "format = 1\n[mechanism.arm]\ninertia = \"0.5 kg m^2 ± 5 %\"\nmass = \"2 kg\"\ncentre_distance = \"200 mm\"\n\
         axis_tilt = \"90 deg\"\nstart_angle = \"0 deg\"\n{moves}"
    )
}

fn code() -> questions::ProductId {
    questions::read_code("CHA-25A-100-H-C1024", quantities::Language::En).unwrap().parsed.code.into()
}

#[test]
fn what_is_cancelled_before_it_begins_does_nothing() {
    let project = long(300);
    let progress = Progress::limited();
    progress.cancel();
    assert_eq!(questions::list::size::ranking(&project, 10, Draw::default(), &progress).unwrap_err(), Refusal::Stopped);
    let one = questions::list::check::verification(&project, Some(&code()), Draw::default(), &progress);
    assert_eq!(one.unwrap_err(), Refusal::Stopped);
    assert!((2..=20).contains(&progress.progress().0), "a step or two of each thread: {:?}", progress.progress());
}

#[test]
fn work_is_cancelled_from_elsewhere() {
    let project = long(300);
    let progress = Progress::endless();
    std::thread::scope(|scope| {
        let worker =
            scope.spawn(|| questions::list::check::verification(&project, Some(&code()), Draw::default(), &progress));
        while progress.progress().0 < 3 {
            std::thread::yield_now();
        }
        progress.cancel();
        assert_eq!(worker.join().unwrap().unwrap_err(), Refusal::Stopped);
    });
}

/// The best of several ratios of a stage is sought while the project is read.
#[test]
fn the_choice_among_ratios_is_cancelled_too() {
    let text = format!("{}\n[stage]\nkind = \"belt\"\nratios = [1, 1.5, 2, 2.5, 3]\n", swings(2));
    let read = |progress: &Progress| questions::read_all_watched(&text, &NoFiles, embedded_catalogue(), progress);
    let progress = Progress::endless();
    let chosen = read(&progress).unwrap();
    assert_eq!((chosen.len(), chosen[0].ratios.len()), (1, 5));
    let (steps, _) = progress.progress();
    assert_eq!(steps, 5 * 276, "the catalogue for each ratio");
    let progress = Progress::limited();
    progress.cancel();
    assert_eq!(read(&progress).unwrap_err(), Unread::Refused(Refusal::Stopped));
    assert!((1..=50).contains(&progress.progress().0), "a step or two of each thread, and no other ratio");
    // A fault of the file is reported all the same.
    let wrong = text.replace("0.7 s", "0.7 m");
    assert!(matches!(
        questions::read_all_watched(&wrong, &NoFiles, embedded_catalogue(), &progress),
        Err(Unread::Faults(_))
    ));
}

#[test]
fn samples_that_cost_too_much_are_refused_where_no_time_is_named() {
    let project = long(100);
    let draw = Draw { samples: Some(1_000_000), seed: 1 };
    let unlimited = Progress::endless();
    let Err(Refusal::TooManySamples { asked, most }) =
        questions::list::check::verification(&project, Some(&code()), draw, &unlimited)
    else {
        panic!("a million samples of a hundred moves")
    };
    assert!(asked == 1_000_000 && (100..1_000_000).contains(&most), "{most}");
    // Within a time it is the time that ends it.
    let limited = Progress::limited();
    limited.cancel();
    assert_eq!(
        questions::list::check::verification(&project, Some(&code()), draw, &limited).unwrap_err(),
        Refusal::Stopped
    );
}

#[test]
fn fewer_samples_are_usual_where_each_costs_more() {
    let of = |project: &AxisProject| Draw::default().sampling(project, 1, false).unwrap().samples;
    let (few, many) = (of(&long(60)), of(&long(2)));
    assert!(few < many && many <= questions::SAMPLES_USUAL && few >= 100, "{few} {many}");
}
