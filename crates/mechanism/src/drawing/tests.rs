use super::{Drawing, DrawingPart, MechanismValues, Moving, Placement, SheetPoint, Step};
use crate::MechanismId;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Returns figures of real machines, some far from the neutral proportions.
fn stated(id: MechanismId) -> Vec<MechanismValues> {
    let of =
        |figures: &[(&str, f64)]| figures.iter().fold(MechanismValues::none(), |all, (key, si)| all.with(key, *si));
    let mut found = vec![MechanismValues::none()];
    found.extend(match id {
        MechanismId::Load | MechanismId::Joint | MechanismId::Table => vec![of(&[("start_angle", 0.7)])],
        MechanismId::Turntable => vec![of(&[("axis_tilt", 0.5)]), of(&[("axis_tilt", FRAC_PI_2), ("overhang", 0.08)])],
        MechanismId::Arm => vec![
            of(&[
                ("centre_distance", 0.2),
                ("payload_distance", 0.5),
                ("start_angle", FRAC_PI_2),
                ("axis_tilt", FRAC_PI_2),
            ]),
            of(&[("centre_distance", 0.6), ("payload_distance", 0.1), ("start_angle", -0.8), ("axis_tilt", 0.3)]),
            of(&[("centre_distance", 0.0), ("start_angle", 3.0)]).over(3.0, 4.6),
        ],
        MechanismId::Screw => vec![
            of(&[("lead", 0.005), ("inclination", FRAC_PI_2)]).over(0.0, 300.0),
            of(&[("lead", 0.04), ("inclination", -FRAC_PI_2), ("overhang", 0.12)]).over(-20.0, 0.0),
            of(&[("lead", 0.02), ("inclination", 0.5)]),
        ],
        MechanismId::Belt => vec![
            of(&[("pulley_diameter", 0.06), ("inclination", 0.4)]).over(0.0, 60.0),
            of(&[("pulley_diameter", 0.3), ("inclination", FRAC_PI_2)]).over(0.0, 2.0),
        ],
        MechanismId::Conveyor => vec![of(&[("roller_diameter", 0.1), ("inclination", 0.3)]).over(0.0, 100.0)],
        MechanismId::SliderCrank => vec![
            of(&[("crank", 0.05), ("rod", 0.06)]),
            of(&[("crank", 0.02), ("rod", 0.4), ("inclination", FRAC_PI_2), ("start_angle", 0.0)]),
            of(&[("crank", 0.05), ("rod", 0.2), ("inclination", 0.6), ("start_angle", 2.0)]).over(2.0, 9.0),
        ],
        MechanismId::Hoist => vec![
            of(&[("drum_diameter", 0.32), ("falls", 4.0), ("hanging", 6.0)]).over(0.0, 100.0),
            of(&[("drum_diameter", 0.2), ("falls", 1.0)]).over(0.0, 30.0),
            of(&[("drum_diameter", 0.2), ("falls", 2.0)]).over(-20.0, 10.0),
        ],
        MechanismId::Winder => vec![
            of(&[
                ("core_diameter", 0.09),
                ("full_diameter", 0.4),
                ("start_diameter", 0.09),
                ("thickness", 0.002),
                ("winding", 1.0),
            ]),
            of(&[
                ("core_diameter", 0.2),
                ("full_diameter", 0.25),
                ("start_diameter", 0.25),
                ("thickness", 0.0002),
                ("winding", -1.0),
            ]),
        ],
        MechanismId::ScissorLift => vec![
            of(&[("stages", 1.0), ("arm_length", 0.8), ("lead", 0.005), ("arm_angle", 0.9)]),
            of(&[("stages", 4.0), ("arm_length", 1.2), ("lead", 0.01), ("arm_angle", 0.2)]).over(0.0, 250.0),
            of(&[("stages", 9.0), ("arm_length", 1.2), ("lead", 0.01), ("arm_angle", 1.2)]),
        ],
        MechanismId::FourBar => vec![
            of(&[("ground", 0.4), ("crank", 0.1), ("coupler", 0.35), ("rocker", 0.3), ("start_angle", 0.0)]),
            of(&[
                ("ground", 0.3),
                ("crank", 0.08),
                ("coupler", 0.3),
                ("rocker", 0.2),
                ("crossed", 1.0),
                ("inclination", 0.5),
            ]),
            of(&[("ground", 0.1), ("crank", 0.3), ("coupler", 0.25), ("rocker", 0.28), ("overhang", 0.03)]),
            of(&[("ground", 9.0), ("crank", 0.1), ("coupler", 0.35), ("rocker", 0.3)]),
        ],
    });
    found
}

fn all() -> impl Iterator<Item = (MechanismId, MechanismValues, Drawing)> {
    MechanismId::ALL.iter().flat_map(|id| {
        stated(*id).into_iter().map(|figures| {
            let drawing = id.drawing(&figures);
            (*id, figures, drawing)
        })
    })
}

/// The call-outs are on the sheet, do not overlap, and show each key once.
#[test]
fn the_call_outs_keep_apart() {
    let leaning = MechanismId::ALL.iter().flat_map(|id| {
        [0.0, 0.3, 0.8, 1.2, 1.57, -0.6, -1.57].map(|angle| {
            let figures = MechanismValues::none().with("inclination", angle);
            (*id, figures.clone(), id.drawing(&figures))
        })
    });
    for (id, figures, drawing) in all().chain(leaning) {
        for (index, one) in drawing.call_outs.iter().enumerate() {
            let inside = |[x, y]: SheetPoint| x >= 4.0 && y >= 4.0 && x <= drawing.size[0] && y <= drawing.size[1];
            assert!(inside(one.at) && inside(one.label), "{id:?}: {} {figures:?}", one.key);
            for other in drawing.call_outs.iter().skip(index + 1) {
                assert_ne!(one.key, other.key, "{id:?}");
                let [dx, dy] = [one.label[0] - other.label[0], one.label[1] - other.label[1]];
                assert!(dx.abs() >= 15.0 || dy.abs() >= 13.0, "{id:?}: {} {} {figures:?}", one.key, other.key);
            }
        }
    }
}

/// The pictures are written to a folder for inspection if an environment variable names one.
#[test]
fn every_mechanism_has_a_picture() {
    for (place, (id, figures, drawing)) in all().enumerate() {
        let picture = drawing.picture(|_| true);
        assert!(picture.matches("<text").count() >= drawing.call_outs.len() && !picture.contains("NaN"), "{id:?}");
        assert!(drawing.size[0] < 640.0 && drawing.size[1] < 640.0, "{id:?} {figures:?}: {:?}", drawing.size);
        if let Ok(folder) = std::env::var("SKETCHES") {
            std::fs::write(format!("{folder}/{place:02}-{}.svg", id.key()), picture).unwrap();
        }
    }
}

/// A drawing without figures is neutral and has the size of the sheet.
#[test]
fn a_drawing_without_figures_fills_the_sheet() {
    for id in MechanismId::ALL {
        let [width, height] = id.drawing(&MechanismValues::none()).size;
        assert!((380.0..=392.0).contains(&width) && (190.0..=250.0).contains(&height), "{id:?}: {width} {height}");
    }
}

/// At the initial position the moving groups are where they are drawn.
#[test]
fn at_the_beginning_everything_stands_as_in_the_still_drawing() {
    for (id, figures, drawing) in all() {
        assert!(!drawing.moving.is_empty(), "{id:?}");
        for (group, moving) in drawing.moving.iter().enumerate() {
            let found = moving.at(figures.start_rad());
            let near = |[x, y]: SheetPoint, [a, b]: SheetPoint| (x - a).hypot(y - b) < 0.35;
            for at in [[0.0, 0.0], [300.0, 0.0], [0.0, 200.0]] {
                let still = [moving.about[0] + at[0] - 100.0, moving.about[1] + at[1] - 100.0];
                let now = moving.point(found, still);
                assert!(near(now, still), "{id:?} {group} {figures:?}: {now:?} {still:?}");
            }
        }
    }
}

/// Every group is drawn once, and each call-out of a group points to an existing one.
#[test]
fn every_group_is_in_the_picture() {
    for (id, _, drawing) in all() {
        let drawn = drawing.movable_svg();
        for group in 0..drawing.moving.len() {
            assert_eq!(drawn.matches(&format!("<g data-group='{group}'>")).count(), 1, "{id:?}");
        }
        assert!(drawing.call_outs.iter().all(|it| it.group.is_none_or(|group| group < drawing.moving.len())), "{id:?}");
        // The stand-alone picture has the same parts without the groups.
        assert!(!drawing.svg().contains("<g"), "{id:?}");
    }
}

/// A thinned table reproduces the equations by linear interpolation between its rows.
#[test]
fn a_table_is_as_good_as_its_equations() {
    let place = |angle: f64| Placement {
        turn_rad: angle,
        shift: [90.0 * angle.cos(), 60.0 * (2.0 * angle).sin()],
        stretch: [1.0, 1.0],
    };
    let moving = Moving::of(&super::GroupAngles::round(0.3), [10.0, 20.0], place);
    assert!(moving.rows.len() < 150, "{}", moving.rows.len());
    for step in -400..400_i32 {
        let angle = f64::from(step) * 0.031;
        let (found, exact) = (moving.at(angle), place(angle));
        assert!((found.turn_rad - exact.turn_rad).abs() < 0.002, "{angle}");
        let [dx, dy] = [found.shift[0] - exact.shift[0], found.shift[1] - exact.shift[1]];
        assert!(dx.hypot(dy) < 0.4, "{angle}: {dx} {dy}");
    }
}

fn group<'d>(drawing: &'d Drawing, key: &str) -> (usize, &'d Moving) {
    let call_out = drawing.call_outs.iter().find(|it| it.key == key).unwrap();
    let index = call_out.group.unwrap();
    (index, &drawing.moving[index])
}

/// Returns the centres of the holes of a group in drawing order.
fn pins(drawing: &Drawing, group: usize) -> Vec<SheetPoint> {
    let of = |part: &DrawingPart| match part {
        DrawingPart::Circle(super::Look::Hole, at, _) => Some(*at),
        _ => None,
    };
    drawing
        .parts
        .iter()
        .find_map(|part| match part {
            DrawingPart::Group(index, parts) if *index == group => Some(parts.iter().filter_map(of).collect()),
            _ => None,
        })
        .unwrap()
}

fn apart([ax, ay]: SheetPoint, [bx, by]: SheetPoint) -> f64 {
    (ax - bx).hypot(ay - by)
}

/// Crank, coupler and rocker stay connected at every angle: the closed loop of the equations on the sheet.
#[test]
fn the_links_of_a_four_bar_linkage_hold_together() {
    for figures in stated(MechanismId::FourBar) {
        let drawing = MechanismId::FourBar.drawing(&figures);
        let [(a, crank), (b, coupler), (c, rocker)] = ["crank", "coupler", "rocker"].map(|key| group(&drawing, key));
        let [crank_pins, coupler_pins, rocker_pins] = [a, b, c].map(|index| pins(&drawing, index));
        for step in 0..720 {
            let angle = f64::from(step) * TAU / 360.0;
            let at = |moving: &Moving, pin: SheetPoint| moving.point(moving.at(angle), pin);
            let loose = [
                apart(at(crank, crank_pins[1]), at(coupler, coupler_pins[0])),
                apart(at(coupler, coupler_pins[1]), at(rocker, rocker_pins[1])),
                apart(at(rocker, rocker_pins[0]), rocker_pins[0]),
            ];
            assert!(loose.iter().all(|each| *each < 0.8), "{angle} {figures:?}: {loose:?}");
        }
    }
}

/// The slider is at r cos q + √(l² − r² sin² q), and the rod stays connected at both ends.
#[test]
fn the_rod_of_a_slider_crank_holds_on_to_both_ends() {
    for figures in stated(MechanismId::SliderCrank) {
        let drawing = MechanismId::SliderCrank.drawing(&figures);
        let [(a, crank), (b, rod), (_, slider)] = ["crank", "rod", "mass"].map(|key| group(&drawing, key));
        let (crank_pins, rod_pins) = (pins(&drawing, a), pins(&drawing, b));
        let start = figures.start_rad();
        let lean = figures.of("start_angle").unwrap_or(0.936);
        let (r, l) = (apart(crank_pins[0], crank_pins[1]), apart(rod_pins[0], rod_pins[1]));
        let place = |angle: f64| r * angle.cos() + (l * l - r * r * angle.sin() * angle.sin()).sqrt();
        for step in 0..360 {
            let angle = start + f64::from(step) * TAU / 180.0;
            let at = |moving: &Moving, pin: SheetPoint| moving.point(moving.at(angle), pin);
            assert!(apart(at(crank, crank_pins[1]), at(rod, rod_pins[0])) < 0.8, "{angle} {figures:?}");
            let out = at(slider, rod_pins[1]);
            assert!(apart(at(rod, rod_pins[1]), out) < 0.8, "{angle} {figures:?}");
            let far = apart(out, crank_pins[0]);
            assert!((far - place(angle - start + lean)).abs() < 0.5, "{angle} {figures:?}: {far}");
        }
    }
}

/// The arms of a lift stay connected to each other, to the nut and to the platform: b = L cos θ_0 − k q, w = √(L² −
/// b²).
#[test]
fn the_arms_of_a_lift_stay_pinned() {
    for figures in stated(MechanismId::ScissorLift) {
        let drawing = MechanismId::ScissorLift.drawing(&figures);
        let (lower, arm) = group(&drawing, "arm_length");
        let (_, platform) = group(&drawing, "mass");
        let stages = figures.count("stages", 2, 4);
        let ends = pins(&drawing, lower);
        let long = apart(ends[0], ends[1]);
        let theta = figures.of("arm_angle").unwrap_or(0.24);
        let (l, k) = (figures.of("arm_length").unwrap_or(1.2), figures.of("lead").unwrap_or(0.01) / TAU);
        for step in 0..40 {
            let q = f64::from(step) / 40.0 * 0.98 * l * theta.cos() / k;
            let b = l * theta.cos() - k * q;
            let wide = b / l * long;
            let high = (l * l - b * b).sqrt() / l * long;
            let [foot, head] = [0, 1].map(|end| arm.point(arm.at(q), ends[end]));
            assert!((head[0] - foot[0] - wide).abs() < 1.0, "{q} {figures:?}: {} {wide}", head[0] - foot[0]);
            assert!((foot[1] - head[1] - high).abs() < 1.0, "{q} {figures:?}");
            assert!((foot[1] - ends[0][1]).abs() < 0.7, "{q}: the lower end stays on the screw");
            let risen = -platform.at(q).shift[1];
            let expected = f64::from(stages) * (high - (l * theta.sin()) / l * long);
            assert!((risen - expected).abs() < 1.5, "{q} {figures:?}: {risen} {expected}");
        }
    }
}

/// A slide moves by the rolled length of the wheel, a thread by one lead per turn, where the drawing is to scale.
#[test]
fn what_goes_along_a_line_goes_in_proportion_to_the_angle() {
    let figures = MechanismValues::none().with("pulley_diameter", 0.2).over(0.0, 3.0);
    let drawing = MechanismId::Belt.drawing(&figures);
    let (_, slide) = group(&drawing, "mass");
    let [dx, dy] = slide.at(1.0).shift;
    assert!(dx > 0.0 && dy == 0.0);
    let wheel = drawing.parts.iter().find_map(|part| match part {
        DrawingPart::Circle(super::Look::Housing, _, radius) => Some(*radius),
        _ => None,
    });
    assert!((wheel.unwrap() - dx).abs() < 0.1, "{wheel:?} {dx}");
    let figures = MechanismValues::none().with("lead", 0.01);
    let drawing = MechanismId::Screw.drawing(&figures);
    let shifts = ["mass", "lead"].map(|key| group(&drawing, key).1.at(0.5 * TAU).shift[0]);
    assert!((shifts[0] - 8.0).abs() < 0.01 && (shifts[1] - 8.0).abs() < 0.01, "{shifts:?}");
}

/// A vertical line is drawn vertical: a slide moves up if the positive direction does.
#[test]
fn vertical_is_vertical() {
    for id in [MechanismId::Screw, MechanismId::Belt, MechanismId::Conveyor, MechanismId::SliderCrank] {
        for (angle, sign) in [(FRAC_PI_2, -1.0), (-FRAC_PI_2, 1.0), (0.5, -0.5_f64.sin())] {
            let drawing = id.drawing(&MechanismValues::none().with("inclination", angle).with("start_angle", -1.0));
            let (_, moving) = group(&drawing, "mass");
            let [dx, dy] = moving.at(-0.5).shift;
            let far = dx.hypot(dy);
            assert!(far > 0.1 && (dy / far - sign).abs() < 0.02, "{id:?} {angle}: {dx} {dy}");
            assert!(drawing.svg().contains(">g</text>"), "{id:?}: gravity is shown");
        }
        assert!(!id.drawing(&MechanismValues::none()).svg().contains(">g</text>"));
    }
}

/// Rope and load of a hoist stay connected, and the motion stops at its upper limit.
#[test]
fn a_rope_ends_at_its_load() {
    for figures in stated(MechanismId::Hoist) {
        let drawing = MechanismId::Hoist.drawing(&figures);
        let [(_, rope), (_, load)] = ["rope_mass", "mass"].map(|key| group(&drawing, key));
        let end = load.about[1];
        for step in 0..20 {
            let q = f64::from(step) * 5.0;
            let now = rope.point(rope.at(q), [rope.about[0], end])[1];
            assert!((now - end - load.at(q).shift[1]).abs() < 0.2, "{q} {figures:?}: {now}");
            assert!(now >= rope.about[1] + 17.0, "{q}: the block stays below the drum");
        }
    }
}

/// The web meets the roll at its top, at the radius given by the equations.
#[test]
fn a_web_meets_its_roll() {
    for figures in stated(MechanismId::Winder) {
        let drawing = MechanismId::Winder.drawing(&figures);
        let (_, roll) = group(&drawing, "start_diameter");
        let web = drawing.moving.iter().find(|it| it.about != roll.about).unwrap();
        let Some(DrawingPart::Group(_, parts)) =
            drawing.parts.iter().find(|part| matches!(part, DrawingPart::Group(2, _)))
        else {
            panic!("{figures:?}")
        };
        let Some(DrawingPart::Path(_, steps)) = parts.first() else { panic!("{figures:?}") };
        let [Step::Move(_), Step::Line(end)] = steps.as_slice() else { panic!("{steps:?}") };
        let (first, last) = (roll.rows[0].0, roll.rows[roll.rows.len() - 1].0);
        for step in 0..=20 {
            let q = first + f64::from(step) / 20.0 * (last - first);
            let top = roll.point(roll.at(q), [roll.about[0], end[1]]);
            assert!(apart(web.point(web.at(q), *end), top) < 1.2, "{q} {figures:?}");
        }
    }
}
