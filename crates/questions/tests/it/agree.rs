//! One truth: every answer about an actuator names the same failing checks, the same governing check and the same nearest miss, and
//! what it proposes fits as it is shown. Every example with seeded values is taken, so every mechanism.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail")]

use axis::{AxisProject, NoFiles};
use project::{Counted, Edit, Heading, Input, edit, inputs};
use quantities::{Language, Measure, ThermodynamicTemperature};
use questions::list::size::{gearing_proposals, sized};
use questions::sweep::{Cells, Judged, Options, Sweep};
use questions::{Candidate, Check, Fit, ProductId, Progress, Rejected, Sizing, Verdict, check};
use sizing::{CheckId, Note, RankKey};

/// Seeded values of each example.
const ROWS: usize = 5;

/// Seeded numbers from zero to one.
struct Chance(u64);

impl Chance {
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The values of a project that may be others.
fn varied(text: &str) -> Vec<Input> {
    let is_number = |input: &Input| {
        // Ways stay as they are, so that a cycle still ends where it begins.
        let is_way = input.path.starts_with("motion") && input.path.ends_with("distance");
        let is_other = is_way || ["actuator", "twin"].iter().any(|table| input.path.starts_with(table));
        !is_other && Heading::read(&heading(input), Counted::FromOne, None).is_ok_and(|heading| heading.is_number())
    };
    let counted = inputs(text).into_iter().filter(|input| input.amount.is_some_and(|(value, _)| value != 0.0));
    counted.filter(is_number).collect()
}

/// Returns the numbers `keys` of a text that differs in amounts alone, without reading their headings again: for a value
/// that is no heading the nearest one is searched, which costs more than the answers.
fn varied_again(text: &str, keys: &[Input]) -> Vec<Input> {
    let is_one = |input: &Input| keys.iter().any(|key| key.path == input.path);
    inputs(text).into_iter().filter(is_one).collect()
}

/// Returns `true` for a mass or a moment of inertia.
fn is_mass(input: &Input) -> bool {
    input.amount.is_some_and(|(_, unit)| unit.ascii.starts_with("kg"))
}

fn heading(input: &Input) -> String {
    let (_, unit) = input.amount.unwrap();
    if unit.ascii.is_empty() || unit.ascii == "1" {
        input.path.clone()
    } else {
        format!("{} [{}]", input.path, unit.ascii)
    }
}

/// A text with other values at some of its keys.
fn with(text: &str, values: &[(&Input, f64)]) -> String {
    values.iter().fold(text.to_owned(), |text, (input, value)| {
        let written = Heading::read(&heading(input), Counted::FromOne, None).unwrap().written(*value);
        edit(&text, &input.path, Edit::Value(&written)).unwrap()
    })
}

/// Examples with seeded values from near to far and with heavier loads, as far as there is such an axis.
fn texts() -> Vec<String> {
    axes().into_iter().map(|(text, _)| text).collect()
}

/// These texts with their values that may be others.
fn axes() -> Vec<(String, Vec<Input>)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let mut chance = Chance(5);
    let mut found = Vec::new();
    for path in files.iter().filter(|path| path.extension().is_some_and(|end| end == "toml")) {
        let text = std::fs::read_to_string(path).unwrap();
        let Ok(project) = questions::read(&text) else { continue };
        // A tolerance is no value of its own, and of several ratios one is chosen anew for each value.
        if project.is_of_several() || !project.tolerances.is_empty() || !project.ratios.is_empty() {
            continue;
        }
        let keys = varied(&text);
        for row in 0..ROWS {
            let (spread, heavier) = [(0.02, 1.0), (0.1, 4.0), (0.3, 1.0), (0.05, 12.0), (0.6, 2.0)][row % 5];
            let other = |key: &Input, share: f64| {
                let factor = if is_mass(key) { heavier } else { 1.0 };
                key.amount.unwrap().0 * factor * (spread * (2.0 * share - 1.0)).exp()
            };
            let values: Vec<(&Input, f64)> = keys.iter().map(|key| (key, other(key, chance.share()))).collect();
            let text = with(&text, &values);
            if questions::read(&text).is_ok() {
                let again = varied_again(&text, &keys);
                found.push((text, again));
            }
        }
    }
    assert!(found.len() > 30, "{} axes", found.len());
    found
}

fn failing(candidate: &Candidate<'_>) -> Vec<CheckId> {
    let checks = candidate.judgement.checks.iter().filter(|check| check.verdict == Verdict::Fail);
    checks.map(|check| check.id).collect()
}

/// Statements about a candidate.
fn said(candidate: &Candidate<'_>) -> (Fit, Vec<CheckId>, Option<CheckId>, u64) {
    let governing = candidate.governing().map(|check| check.id);
    (candidate.fit(), failing(candidate), governing, candidate.standing.utilisation.to_bits())
}

fn code(candidate: &Candidate<'_>) -> order_code::OrderCode {
    *candidate.id.order_code().unwrap()
}

/// The nearest miss by judging every rejected one in full.
fn nearest(project: &AxisProject, sizing: &Sizing<'_>) -> Option<ProductId> {
    let of_the_place = |check: &Check| check.verdict == Verdict::Fail && check.id.is_of_the_place();
    let full = || sizing.rejected().iter().filter_map(|each| check(project, &code(each)).ok());
    let first = |of: &dyn Fn(&Candidate<'_>) -> bool| {
        let found = full().filter(|each| each.objections.is_empty() && of(each));
        found.min_by_key(|each| (RankKey::of(&each.standing), catalogue_place(each))).map(|each| each.id)
    };
    let near = first(&|each| !each.judgement.checks.iter().any(of_the_place));
    // Where each is excluded by the place, the first of these; by a requirement, the one that misses the fewest.
    let fewest = || sizing.rejected().iter().min_by_key(|each| each.objections.len() + failing(each).len());
    let excluded = || first(&|_| true).or_else(|| fewest().map(|each| each.id.clone()));
    near.or_else(|| excluded().filter(|_| sizing.fitting().is_empty()))
}

fn catalogue_place(candidate: &Candidate<'_>) -> usize {
    let code = code(candidate);
    let bare = order_code::OrderCode { option_1: None, option_2: None, ..code };
    crate::catalogue_actuators().position(|(known, _)| *known == bare).unwrap()
}

#[test]
fn every_answer_says_the_same_of_a_code() {
    let (mut rejected, mut inside, mut nothing_fits, mut left_out) = (0, 0, 0, 0);
    for (place, text) in texts().iter().enumerate() {
        let project = questions::read(text).unwrap();
        let sizing = questions::size(&project);
        for each in sizing.candidates.iter().skip(place % 7).step_by(7) {
            // Options that the project requires may break a rule; then only the ranking judges it.
            let Ok(alone) = check(&project, &code(each)) else { continue };
            assert_eq!(said(each), said(&alone), "{}\n{text}", each.id);
            rejected += usize::from(!each.fits());
            inside += usize::from(each.fit() == Fit::FitsIfEstimate);
        }
        let by_reasons = sized(&project, 3, Rejected::Reasons, &Progress::endless()).unwrap();
        let by_reasons_counts = (by_reasons.counts(), by_reasons.not_evaluated());
        let by_reasons = by_reasons.candidates;
        assert_eq!(by_reasons.len(), sizing.candidates.len());
        for (some, each) in by_reasons.iter().zip(&sizing.candidates) {
            assert_eq!((&some.id, said(some)), (&each.id, said(each)), "{text}");
            let governing = |each: &Candidate<'_>| each.governing().map(|check| format!("{check:?}"));
            assert_eq!(governing(some), governing(each), "{}\n{text}", each.id);
            left_out += each.judgement.checks.len() - some.judgement.checks.len();
        }
        assert_eq!(by_reasons_counts, (sizing.counts(), sizing.not_evaluated()), "{text}");
        let [fit, fit_if_estimate] = sizing.counts();
        let of = |fit: Fit| sizing.candidates.iter().filter(|each| each.fit() == fit).count();
        assert_eq!([fit, fit_if_estimate], [of(Fit::Fits), of(Fit::FitsIfEstimate)]);
        let reasons = questions::texts::rejections(&sizing, quantities::Language::En);
        let counted: usize = reasons.iter().map(|reason| reason.candidates.len()).sum();
        assert_eq!(counted, sizing.rejected().len(), "{text}");
        // The row of a sweep about the same code, and the nearest miss wherever it is named.
        let sweep = Sweep::new(("axis.toml", text), Box::new(NoFiles), &["code"], Options::default());
        let sweep = sweep.unwrap_or_else(|why| panic!("{why:?}"));
        let named: Vec<Option<std::borrow::Cow<'_, str>>> =
            sizing.candidates.iter().step_by(40).map(|each| Some(each.id.to_string().into())).collect();
        let rows = sweep.judge(&[Cells::Texts(named)], &Progress::endless()).unwrap();
        for (row, each) in rows.iter().zip(sizing.candidates.iter().step_by(40)) {
            let Ok(Judged::Best(row)) = row else { continue };
            let governing = each.governing().map(|check| check.id);
            let utilisation = Some(each.standing.utilisation).filter(|share| share.is_finite());
            let counts = [row.fit, row.fit_if_estimate].map(|count| count == 1);
            assert_eq!((row.tightest, row.utilisation), (governing, utilisation), "{}\n{text}", each.id);
            let fits = [Fit::Fits, Fit::FitsIfEstimate].map(|fit| each.fit() == fit);
            assert_eq!(counts, fits, "{}\n{text}", each.id);
        }
        let found = sizing.nearest_miss().map(|miss| miss.id.clone());
        assert_eq!(found, nearest(&project, &sizing), "{text}");
        if sizing.fitting().is_empty() {
            nothing_fits += 1;
            let quick = sized(&project, 0, Rejected::Nearest, &Progress::endless()).unwrap();
            assert_eq!(quick.nearest_miss().map(|miss| miss.id.clone()), found, "{text}");
            let named = |sizing: &Sizing<'_>| sizing.named().map(|each| each.id.clone());
            assert_eq!(named(&quick), named(&sizing), "{text}");
        }
    }
    assert!(rejected > 500 && inside > 2 && nothing_fits > 5, "{rejected} {inside} {nothing_fits}");
    assert!(left_out > 500, "{left_out} checks");
}

/// A rating of another manufacturer's gear rejects nothing, in any check of any code, and a code whose only overrun it is fits
/// if the estimate holds.
#[test]
fn no_rejection_rests_on_another_makers_page() {
    let is_of_another = |source: &provenance::Source| match source {
        provenance::Source::Published(cell) => {
            let document = catalogue::documents().iter().find(|document| document.id == cell.document);
            document.is_none_or(|document| !document.publisher.starts_with("Harmonic Drive"))
        }
        _ => false,
    };
    let (mut beyond, mut saved) = (0, 0);
    for (place, text) in texts().into_iter().enumerate().step_by(2) {
        // Lives and collisions are required too, so that every check with such a limit is made.
        let keys = "gear_life_min = \"20000 h\"\ncollision_torque = \"60 N m\"\n";
        let stated = if text.contains("gear_life_min") || text.contains("collision_torque") {
            text.clone()
        } else if text.contains("[requirements]\n") {
            text.replacen("[requirements]\n", &format!("[requirements]\n{keys}"), 1)
        } else {
            format!("{text}\n[requirements]\n{keys}")
        };
        let project = questions::read(&stated).unwrap_or_else(|why| panic!("{why:?}\n{stated}"));
        let sizing = questions::size(&project);
        for each in sizing.candidates.iter().skip(place % 9).step_by(9) {
            let Ok(alone) = check(&project, &code(each)) else { continue };
            for check in &alone.judgement.checks {
                let is_named = check.notes.contains(&Note::RatingOfInterchangeableGear);
                let rests = is_named || check.limit_source.as_ref().is_some_and(is_of_another);
                if rests && check.utilisation.is_some_and(|share| share > 1.0) {
                    assert_eq!(check.verdict, Verdict::Advice, "{:?} of {}\n{stated}", check.id, each.id);
                    beyond += 1;
                }
            }
            saved += usize::from(alone.judgement.fit() == Fit::FitsIfEstimate);
            assert_eq!(said(each).0, said(&alone).0, "{}\n{stated}", each.id);
        }
    }
    assert!(beyond > 100 && saved > 5, "{beyond} {saved}");
}

/// The governing check is the first that is listed, and its utilisation that of the actuator.
#[test]
fn the_governing_check_leads_the_list() {
    for text in texts().iter().step_by(3) {
        let project = questions::read(text).unwrap();
        let sizing = questions::size(&project);
        for each in sizing.candidates.iter().step_by(23) {
            let Ok(alone) = check(&project, &code(each)) else { continue };
            let listed = questions::texts::by_importance(&alone.judgement.checks);
            let Some(governing) = alone.governing() else { continue };
            let first = listed.iter().find(|check| check.verdict == governing.verdict).map(|check| check.id);
            assert_eq!(first, Some(governing.id), "{text}");
            assert_eq!(listed.len(), alone.judgement.checks.len());
            let share = governing.utilisation.unwrap_or(f64::INFINITY);
            assert_eq!(share.to_bits(), alone.standing.utilisation.to_bits(), "{text}");
        }
    }
}

/// Another value of the gearing as it is printed, typed into the project: the named code is the answer, and with the next value towards
/// the stated one nothing fits.
#[test]
fn a_proposed_gearing_fits_as_it_is_printed() {
    let (mut seen, mut stages) = (0, 0);
    for text in &texts() {
        let project = questions::read(text).unwrap();
        for mend in gearing_proposals(&project, &Progress::endless()).unwrap() {
            let value = mend.unit.from_si(mend.si);
            let scale = 10_f64.powf(2.0 - value.abs().log10().floor());
            let digits = value * scale;
            let has_three = (digits - digits.round()).abs() < 1e-6;
            let stated = if mend.adds_stage() { 1.0 } else { stated_si(&project, &mend.path) };
            let towards = if mend.si > stated { -1.0 } else { 1.0 };
            if mend.adds_stage() {
                // A stage without losses and inertia; what it weighs on the flange is not known, so that checks of the flange
                // cannot be made: what they exclude now is not proposed.
                let staged = project.with_stage(value).unwrap();
                let id = questions::read_code(&mend.code, Language::En).unwrap().parsed.code;
                let [now, then] = [&project, &staged].map(|project| check(project, &id).unwrap());
                assert_eq!(then.fit(), mend.fit, "{mend:?}\n{text}");
                for id in failing(&now) {
                    let verdict = then.judgement.checks.of(id).map(|check| check.verdict);
                    assert_ne!(verdict, Some(Verdict::NotChecked), "{id:?} of {mend:?}\n{text}");
                }
                stages += 1;
                continue;
            }
            let sized_with = |number: f64| {
                let written = if mend.unit.ascii == "1" {
                    mend.path.clone()
                } else {
                    format!("{} [{}]", mend.path, mend.unit.ascii)
                };
                let heading = Heading::read(&written, Counted::FromOne, None).unwrap();
                let project =
                    questions::read(&edit(text, &mend.path, Edit::Value(&heading.written(number))).unwrap()).ok()?;
                questions::size(&project).answer().map(|best| (best.id.to_string(), best.fit()))
            };
            assert_eq!(sized_with(value), Some((mend.code.clone(), mend.fit)), "{mend:?}\n{text}");
            // A counterweight is inside its range, not at its end.
            if has_three && !mend.path.ends_with("counterweight") {
                let next = (digits.round() + towards) / scale;
                if (mend.unit.to_si(next) - stated) * towards < 0.0 {
                    assert_eq!(sized_with(next), None, "{next} is nearer than {mend:?}\n{text}");
                }
            }
            seen += 1;
        }
    }
    assert!(seen + stages > 4 && seen > 0 && stages > 0, "{seen} proposals, {stages} stages");
}

/// A stage in front of a load whose bearing life is too short is no remedy: the loads behind it are not known.
#[test]
fn a_stage_is_no_remedy_for_a_check_that_it_leaves_open() {
    let text = "format = 1\n[axis]\nsingle_move = true\n[mechanism.conveyor]\nroller_diameter = \"150 mm\"\nmass = \"37 kg\"\n\
                friction_coefficient = 0.027\n[[motion]]\nlaw = \"constant\"\nspeed = \"-4.3 rad/s\"\ntime = \"4.2 s\"\n\
                [bearing]\nload_factor = 1.2\noverhang = \"102 mm\"\nbelt_tension = \"343 N\"\n\
                [requirements]\nsupply = \"48 V\"\nbearing_life_min = \"9000000 h\"\n";
    let project = questions::read(text).unwrap_or_else(|why| panic!("{why:?}"));
    let sizing = questions::size(&project);
    let by_life = sizing.candidates.iter().filter(|each| failing(each) == [CheckId::BearingLife]).count();
    assert!(!sizing.fits() && by_life > 0, "{by_life} {}", sizing.fitting().len());
    let proposed = gearing_proposals(&project, &Progress::endless()).unwrap();
    assert!(proposed.iter().all(|proposal| !proposal.adds_stage()), "{proposed:?}");
}

fn stated_si(project: &AxisProject, path: &str) -> f64 {
    let counterweight = project.counterweight().map(|(stated, _)| stated);
    let mut all = project.gearings().into_iter().chain(counterweight);
    all.find(|gearing| gearing.path == path).map(|gearing| gearing.si).unwrap()
}

/// Masses and inertias times the printed factor, and all times of the motion times that of the cycle, typed into the project: the code
/// fits, and with one step of the last digit more it does not.
#[test]
fn a_reserve_fits_as_it_is_printed() {
    let (mut loads, mut paces, mut alone) = (0, 0, 0);
    for (text, keys) in &axes() {
        let project = questions::read(text).unwrap();
        let sizing = questions::size(&project);
        let near = sizing.answer().or_else(|| sizing.nearest_miss());
        let Some(named) = near.and_then(|near| check(&project, &code(near)).ok()) else { continue };
        let reserve = questions::reserve_of(&project, &named);
        let fit_with = |factor: f64, of: &dyn Fn(&Input) -> bool| {
            let values: Vec<(&Input, f64)> =
                keys.iter().filter(|key| of(key)).map(|key| (key, key.amount.unwrap().0 * factor)).collect();
            let project = questions::read(&with(text, &values)).ok()?;
            let found = check(&project, &code(&named)).ok()?;
            let beyond = found.inside_bands();
            let ratings = beyond.iter().filter(|check| check.is_of_another_gear()).count();
            Some((found.judgement.fit(), beyond.len() > ratings, ratings > 0))
        };
        // What of the load is no key with a mass, such as a density of a web by its thickness, is not typed here.
        if let Some(reach) = reserve.load_factor.filter(|_| !text.contains("[mechanism.table]")) {
            let step = 10_f64.powf(reach.value.log10().floor() - 3.0);
            let expected = (reach.fit, reach.proviso.estimate, reach.proviso.rating);
            assert_eq!(fit_with(reach.value, &is_mass), Some(expected), "× {} of {}\n{text}", reach.value, named.id);
            let lines = questions::texts::reserve_lines(&reserve, &named, Language::En);
            let line = lines.iter().flat_map(|(_, parts)| parts).find(|part| part.contains("masses")).unwrap();
            assert_eq!(line.contains("if the estimate holds"), expected.1, "{line}");
            assert_eq!(line.contains("gear rating of another manufacturer"), expected.2, "{line}");
            alone += usize::from(expected.2 && !expected.1);
            let beyond = fit_with(reach.value + step, &is_mass).map(|found| found.0);
            assert_eq!(beyond, Some(Fit::DoesNotFit), "× {} + {step} of {}\n{text}", reach.value, named.id);
            loads += 1;
        }
        let is_timed = |key: &Input| {
            key.path.starts_with("motion")
                && key.amount.is_some_and(|(_, unit)| unit.ascii == "s" || unit.ascii == "ms")
        };
        let only_times = !["speed", "acceleration", "jerk", "file"]
            .iter()
            .any(|key| inputs(text).iter().any(|input| input.path.starts_with("motion") && input.path.ends_with(key)));
        if let Some(reach) = reserve.cycle_time.filter(|_| only_times) {
            let (cycle, now) = (reach.value.si(), project.axis.motion.duration().si());
            let step = 10_f64.powf(cycle.log10().floor() - 3.0);
            let with = |cycle: f64| fit_with(cycle / now, &is_timed);
            let expected = (reach.fit, reach.proviso.estimate, reach.proviso.rating);
            assert_eq!(with(cycle), Some(expected), "{cycle} s of {}\n{text}", named.id);
            assert_eq!(
                with(cycle - step).map(|found| found.0),
                Some(Fit::DoesNotFit),
                "{cycle} s − {step} of {}\n{text}",
                named.id
            );
            paces += 1;
        }
    }
    assert!(loads > 15 && paces > 8 && alone > 0, "{loads} loads, {paces} paces, {alone} by a rating alone");
}

/// The counting line names the conditions of the candidates that it counts: an estimate, a gear rating of another
/// manufacturer, or both; the legend of the checks does so for one candidate.
#[test]
fn the_counting_line_names_what_the_counted_rest_on() {
    let (mut estimates, mut ratings) = (0, 0);
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples")).unwrap() {
        let text = std::fs::read_to_string(entry.unwrap().path()).unwrap_or_default();
        let Ok(project) = questions::read(&text) else { continue };
        let sizing = questions::size(&project);
        let found: Vec<sizing::Proviso> =
            sizing.fitting().iter().map(|candidate| candidate.judgement.proviso()).collect();
        let (estimate, rating) = (found.iter().any(|it| it.estimate), found.iter().any(|it| it.rating));
        let line = questions::texts::fitting_text(&sizing, quantities::Language::En);
        assert_eq!(line.contains("an estimate holds"), estimate, "{line}");
        assert_eq!(line.contains("gear rating of another manufacturer"), rating, "{line}");
        let line = questions::texts::fitting_text(&sizing, quantities::Language::De);
        assert_eq!(line.contains("Getriebegrenze eines anderen Herstellers"), rating, "{line}");
        estimates += usize::from(estimate);
        ratings += usize::from(rating);
    }
    assert!(estimates > 5 && ratings > 0, "{estimates} {ratings}");
}

/// At the ends of the stated ambient temperatures an actuator fits, beyond them it does not; they contain the present one
/// where it fits, and exclude it where it does not.
#[test]
fn the_stated_ambient_temperatures_are_those_at_which_an_actuator_fits() {
    let (mut within, mut without, mut lower) = (0, 0, 0);
    for (place, text) in texts().iter().enumerate() {
        let mut project = questions::read(text).unwrap();
        let ambient = ThermodynamicTemperature::from_si(273.15 + [35.0, 5.0, 28.0][place % 3]);
        project.axis.ambient = Some(ambient);
        let sizing = questions::size(&project);
        let rejected = sizing.rejected().iter().filter(|each| each.objections.is_empty());
        for each in sizing.fitting().iter().take(3).chain(rejected.take(9)) {
            let Ok(named) = check(&project, &code(each)) else { continue };
            let reserve = questions::reserve_of(&project, &named);
            let fits_at = |kelvin: f64| {
                let mut other = project.clone();
                other.axis.ambient = Some(ThermodynamicTemperature::from_si(kelvin));
                check(&other, &code(each)).unwrap().judgement.checks.iter().all(|check| check.verdict != Verdict::Fail)
            };
            let [least, most] = [reserve.ambient_least, reserve.ambient].map(|end| end.map(|end| end.value.si()));
            if least.is_none() && most.is_none() {
                continue;
            }
            for (end, beyond) in [(least, -0.06), (most, 0.06)] {
                let Some(end) = end else { continue };
                assert!(fits_at(end), "{} at {end} K\n{text}", each.id);
                assert!(!fits_at(end + beyond), "{} beyond {end} K\n{text}", each.id);
            }
            let here = ambient.si();
            let contains = least.is_none_or(|least| least <= here) && most.is_none_or(|most| here <= most);
            assert_eq!(contains, fits_at(here), "{} {least:?} {most:?}\n{text}", each.id);
            if contains {
                within += 1
            } else {
                without += 1
            }
            lower += usize::from(least.is_some_and(|least| least > 273.2));
        }
    }
    assert!(within > 10 && without > 2, "{within} {without} {lower}");
}
