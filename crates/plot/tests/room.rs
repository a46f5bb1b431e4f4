//! Omissions in small pictures: never a symbol, a unit, a legend entry or the label of a limit.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail loudly too")]

use plot::{
    Bar, BarChart, Line, Markers, Panel, Picture, PlaneAxis, Reference, Shape, Size, StackedChart, Style, Tone,
    Verdict, XyChart,
};

fn narrow() -> Style {
    Style::new(Size::millimetres(60.0, 90.0))
}

fn texts(picture: &Picture) -> Vec<String> {
    picture.texts().iter().map(|text| text.text.clone()).collect()
}

/// Returns the ends of every vertical dashed line: the borders of segments.
fn borders(picture: &Picture) -> Vec<(f64, f64, f64)> {
    let document = roxmltree::Document::parse(picture.svg()).unwrap();
    let lines = document.descendants().filter(|node| node.attribute("stroke-dasharray") == Some("3 2"));
    let read = |d: &str| {
        let numbers: Vec<f64> = d.split(['M', 'L', ' ']).filter_map(|part| part.parse().ok()).collect();
        let [x, top, _, bottom] = numbers[..] else { panic!("{d}") };
        (x, top, bottom)
    };
    lines.filter_map(|node| node.attribute("d")).map(read).collect()
}

fn many_segments(title: &str) -> StackedChart {
    let segments = (0..40_u8).map(f64::from);
    segments.fold(StackedChart::new(PlaneAxis::new("t", "s")).title(title), |chart, at| {
        chart.segment(at, at + 1.0, format!("{at}"))
    })
}

#[test]
fn no_border_of_a_segment_crosses_the_label_of_an_event() {
    let mut chart = many_segments("Cycle");
    for event in [3.5, 9.5] {
        let course = Line::new([(0.0, 0.0), (20.0, 8.0), (40.0, 1.0)]);
        chart = chart.panel(
            Panel::new(PlaneAxis::new("T", "Nm"))
                .with(course)
                .with(Reference::vertical(event).label(format!("stop after {event} s"))),
        );
    }
    let picture = chart.render(&Style::new(Size::millimetres(120.0, 90.0)));
    assert!(picture.hidden_labels().iter().all(|label| !label.contains("stop")), "{:?}", picture.hidden_labels());
    let labels: Vec<_> = picture.texts().iter().filter(|text| text.text.contains("stop")).collect();
    assert_eq!(labels.len(), 2);
    let found = borders(&picture);
    assert!(found.len() > 2 * 39, "{}", found.len());
    for (x, top, bottom) in found {
        for label in &labels {
            let area = label.area;
            let crosses = area.left < x && x < area.right && top < area.bottom && area.top < bottom;
            assert!(!crosses, "{x} {top} {bottom} through {area:?}");
        }
    }
}

/// A low panel has no room between its curves for a text.
#[test]
fn the_label_of_a_limit_stands_above_the_panel() {
    let limits = [3.0, 9.0];
    for height in [60.0, 90.0, 200.0] {
        let chart = limits.into_iter().fold(many_segments("Cycle"), |chart, limit| {
            let course = Line::new([(0.0, -8.0), (20.0, 8.0), (40.0, -8.0)]);
            let reference = Reference::horizontal(limit).label(format!("T_max = {limit} Nm"));
            chart.panel(Panel::new(PlaneAxis::new("T", "Nm")).with(course).with(reference))
        });
        let picture = chart.render(&Style::new(Size::millimetres(120.0, height)));
        assert!(picture.hidden_labels().iter().all(|label| !label.contains("T_max")), "{:?}", picture.hidden_labels());
        let labels: Vec<_> = picture.texts().iter().filter(|text| text.text.contains("T_max")).collect();
        assert_eq!(labels.len(), 2);
        // A border ends two pixels above its panel.
        let mut panels: Vec<(f64, f64)> = borders(&picture).iter().map(|(_, top, end)| (top + 2.0, *end)).collect();
        panels.sort_by(|a, b| a.0.total_cmp(&b.0));
        panels.dedup();
        assert_eq!(panels.len(), 2, "{panels:?}");
        for label in labels {
            let within = panels.iter().any(|(top, bottom)| label.area.top < *bottom && *top < label.area.bottom);
            assert!(!within, "{height} mm: {label:?} {panels:?}");
        }
    }
}

/// Borders a few pixels apart would cover the curves; in a window of time they come back.
#[test]
fn segments_too_narrow_to_be_told_apart_have_no_borders() {
    let chart = |count: u32, end: f64| {
        let axis = PlaneAxis::new("t", "s").range(0.0, end);
        let segments =
            (0..count).map(f64::from).fold(StackedChart::new(axis), |chart, at| chart.segment(at, at + 1.0, "x"));
        let course = Line::new([(0.0, 0.0), (end, 8.0)]);
        segments.panel(Panel::new(PlaneAxis::new("T", "Nm")).with(course))
    };
    let drawn = |count, end| borders(&chart(count, end).render(&Style::new(Size::millimetres(120.0, 90.0)))).len();
    assert_eq!(drawn(50, 50.0), 49);
    assert_eq!(drawn(5000, 5000.0), 0);
    assert_eq!(drawn(5000, 50.0), 49);
}

/// A scale with a single number has no unit of length.
#[test]
fn every_scale_has_two_numbers_however_low_its_panel() {
    for (low, high) in [(-20.2, 20.2), (-190.4, 190.4), (30.2, 81.7), (-0.1, 120.7), (-21_600.0, 0.0), (0.4, 1.46)] {
        for height in [30.0, 60.0, 120.0] {
            let fixed =
                Panel::new(PlaneAxis::new("T", "Nm").range(low, high)).with(Line::new([(0.0, low), (9.0, high)]));
            let free = Panel::new(PlaneAxis::new("T", "Nm")).with(Line::new([(0.0, low), (9.0, high)]));
            for panel in [fixed, free] {
                let picture = StackedChart::new(PlaneAxis::new("t", "s"))
                    .panel(panel)
                    .render(&Style::new(Size::millimetres(120.0, height)));
                let document = roxmltree::Document::parse(picture.svg()).unwrap();
                let axis = document.descendants().find(|node| node.attribute("class") == Some("axis y")).unwrap();
                let numbers = axis.descendants().filter(|node| node.has_tag_name("text")).count();
                assert!(numbers >= 2, "{low} to {high}, {height} mm: {numbers}");
            }
        }
    }
}

/// An axis that goes on to the next round number may be twice as long as its data.
#[test]
fn a_low_panel_is_filled_by_its_curve() {
    for high in [0.536, 5.1, 21_600.0, 2300.0, 11.0] {
        let panel = Panel::new(PlaneAxis::new("φ", "°")).with(Line::new([(0.0, 0.0), (9.0, high)]));
        let chart = StackedChart::new(PlaneAxis::new("t", "s")).panel(panel);
        let picture = chart.render(&Style::new(Size::millimetres(120.0, 30.0)));
        let document = roxmltree::Document::parse(picture.svg()).unwrap();
        let top = document.descendants().find_map(|node| node.attribute("data-y-max")?.parse::<f64>().ok());
        let top = top.unwrap();
        assert!(top >= high && top <= high / 0.55, "{high}: {top}");
    }
}

#[test]
fn a_narrow_stack_keeps_titles_and_every_entry_of_its_legend() {
    let line = |label: &str| Line::new([(0.0, 1.0), (1.0, 2.0)]).label(label);
    let chart = StackedChart::new(PlaneAxis::new("t", "s").name("Time since the beginning of the cycle"))
        .title("A title that is longer than one line of the picture has room for")
        .panel(
            Panel::new(PlaneAxis::new("ϑ", "°C").name("Temperature of the parts of the motor"))
                .with(line("winding"))
                .with(line("housing"))
                .with(line("a mounting plate with a long name")),
        );
    let picture = chart.render(&narrow());
    assert_eq!(picture.hidden_labels(), [""; 0]);
    let all = texts(&picture).join(" ");
    for part in ["ϑ / °C", "t / s", "winding", "housing", "has room for"] {
        assert!(all.contains(part), "{part}: {all}");
    }
    assert!(all.replace(' ', "").contains("amountingplatewithalongname") && !all.contains('…'), "{all}");
}

#[test]
fn a_narrow_plane_breaks_its_legend_and_cuts_nothing() {
    let picture = XyChart::new(PlaneAxis::new("n", "min⁻¹").name("Speed at the output"), PlaneAxis::new("T", "Nm"))
        .with(Markers::new([(1.0, 2.0)]).label("mean: n_av = 12.34 min⁻¹, T_rms = 123.4 Nm, of the whole cycle"))
        .render(&narrow());
    let all = texts(&picture).join(" ");
    assert!(all.contains("of the whole cycle") && !all.contains('…'), "{all}");
    assert_eq!(picture.hidden_labels(), [""; 0]);
}

#[test]
fn narrow_bars_have_whole_labels_and_numbers() {
    let bar = |name: &str| Bar::new(name, Verdict::Fail).percent(130.0).text("130.0 % · 39.03 / ≤ 30.02 min⁻¹");
    let picture = BarChart::new(PlaneAxis::new("", "%").name("Utilisation"))
        .bar(bar("Mean input speed of the gear"))
        .bar(bar("A check whose name alone is longer than the picture is wide, which is rare"))
        .explain(Verdict::Fail, "not met")
        .render(&narrow());
    let all = texts(&picture).join(" ");
    assert!(all.contains("30.02 min⁻¹") && all.contains("which is rare") && !all.contains('…'), "{all}");
    assert_eq!(picture.hidden_labels(), [""; 0]);
}

#[test]
fn a_text_is_as_wide_as_laid_out_whatever_face_draws_it() {
    let picture = XyChart::new(PlaneAxis::new("n", "min⁻¹").name("Speed"), PlaneAxis::new("T_rms", "Nm"))
        .title("Limits")
        .with(Line::new([(0.0, 1.0), (1.0, 2.0)]).label("continuous limit"))
        .render(&Style::new(Size::millimetres(120.0, 80.0)));
    let document = roxmltree::Document::parse(picture.svg()).unwrap();
    let mut held = 0;
    for node in document.descendants().filter(|node| node.has_tag_name("text") || node.has_tag_name("tspan")) {
        let own = node.children().find(roxmltree::Node::is_text).and_then(|child| child.text());
        let Some(own) = own.filter(|text| text.chars().count() > 3) else { continue };
        assert!(node.attribute("textLength").is_some(), "{own}");
        held += 1;
    }
    assert!(held >= 4, "{held}");
    // A run of a label stands at a place of its own.
    assert!(document.descendants().filter(|node| node.has_tag_name("tspan")).all(|node| node.has_attribute("x")));
}

#[test]
fn a_map_without_a_point_says_so() {
    let map = XyChart::map(PlaneAxis::new("m", "kg"), PlaneAxis::new("", "%"))
        .class("fits", Tone::Series(2), Vec::<(f64, f64, &str)>::new())
        .with(Reference::horizontal(0.0))
        .nothing("No candidate can be shown.");
    let picture = map.render(&narrow());
    assert_eq!(texts(&picture).join(" "), "No candidate can be shown.");
    assert!(!picture.svg().contains("class=\"axis"));
    let shown = map.class("misses", Tone::Series(1), [(1.0, 2.0, "A")]).render(&narrow());
    assert!(shown.svg().contains("class=\"axis") && !shown.svg().contains("No candidate"));
}

#[test]
fn a_ring_leaves_the_marker_within_to_be_seen() {
    let picture = XyChart::new(PlaneAxis::new("m", "kg"), PlaneAxis::new("", "%"))
        .with(Markers::new([(1.0, 1.0)]).shape(Shape::Ring).class("ring"))
        .render(&narrow());
    let document = roxmltree::Document::parse(picture.svg()).unwrap();
    let ring = document.descendants().find(|node| node.attribute("class") == Some("markers ring")).unwrap();
    let path = ring.descendants().find(|node| node.has_tag_name("path")).unwrap();
    assert_eq!(path.attribute("fill"), Some("none"));
}
