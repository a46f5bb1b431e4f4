//! Properties of every picture: XML, finite, within its frame, no overlapping text, deterministic.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail loudly too")]

use arbtest::arbitrary::{Result, Unstructured};
use plot::{
    Area, Bar, BarChart, Dash, Hatch, Label, Line, Markers, Note, Panel, Picture, PlaneAxis, Reference, Shape, Size,
    StackedChart, Style, Theme, Tone, Verdict, Width, XyChart,
};
use quantities::Language;

fn number(u: &mut Unstructured<'_>) -> Result<f64> {
    const ODD: [f64; 12] = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::MAX,
        f64::MIN,
        f64::MIN_POSITIVE,
        5e-324,
        -0.0,
        1e-9,
        1e9,
        1e150,
        -1e290,
    ];
    Ok(match u.int_in_range(0..=5)? {
        0 => *u.choose(&ODD)?,
        1 => u.arbitrary()?,
        2 => 0.0,
        _ => f64::from(u.arbitrary::<i16>()?) / 32.0,
    })
}

fn points(u: &mut Unstructured<'_>) -> Result<Vec<(f64, f64)>> {
    let count = u.int_in_range(0..=12)?;
    (0..count).map(|_| Ok((number(u)?, number(u)?))).collect()
}

fn text(u: &mut Unstructured<'_>) -> Result<String> {
    const ODD: [&str; 9] = [
        "",
        "n_max",
        "<script>&\"'",
        "]]>\u{0}\u{7}\n\u{ffff}",
        "a very long label that no plot of any size has room for, whatever it may say about its curve",
        "Über-Größe · min⁻¹",
        "日本語",
        "_",
        " ",
    ];
    Ok((*u.choose(&ODD)?).to_owned())
}

fn label(u: &mut Unstructured<'_>) -> Result<Label> {
    Ok(if u.arbitrary()? { Label::from(text(u)?) } else { Label::symbol(&text(u)?).text(&text(u)?) })
}

fn tone(u: &mut Unstructured<'_>) -> Result<Tone> {
    Ok(*u.choose(&[Tone::Continuous, Tone::ShortTime, Tone::Trace, Tone::Muted, Tone::Series(1), Tone::Series(250)])?)
}

fn axis(u: &mut Unstructured<'_>) -> Result<PlaneAxis> {
    let mut axis = PlaneAxis::new(&text(u)?, &text(u)?).name(&text(u)?);
    if u.arbitrary()? {
        axis = axis.without_zero();
    }
    if u.arbitrary()? {
        axis = axis.minor_ticks();
    }
    if u.arbitrary()? {
        axis = axis.tight();
    }
    if u.int_in_range(0..=3)? == 0 {
        axis = axis.range(number(u)?, number(u)?);
    }
    Ok(axis)
}

fn item(u: &mut Unstructured<'_>) -> Result<plot::Item> {
    Ok(match u.int_in_range(0..=5)? {
        0 => {
            let mut line =
                Line::new(points(u)?).label(label(u)?).tone(tone(u)?).class(&text(u)?).data(&text(u)?, &text(u)?);
            line = if u.arbitrary()? { line.closed() } else { line };
            line = if u.arbitrary()? { line } else { line.dash(Dash::Dotted).width(Width::Strong) };
            line.into()
        }
        1 => {
            let area = Area::between(points(u)?, points(u)?).label(label(u)?).tone(tone(u)?).tooltip(&text(u)?);
            if u.arbitrary()? { area.hatch(Hatch::Crossed).into() } else { area.into() }
        }
        2 => {
            let points = points(u)?;
            let names = points.iter().map(|_| label(u)).collect::<Result<Vec<_>>>()?;
            let shape = *u.choose(&[Shape::Circle, Shape::Diamond, Shape::Cross, Shape::Square, Shape::Triangle])?;
            Markers::new(points).names(names).label(label(u)?).shape(shape).hollow().into()
        }
        3 => Reference::horizontal(number(u)?).label(label(u)?).tone(tone(u)?).into(),
        4 => Reference::vertical(number(u)?).label(label(u)?).into(),
        _ => Note::new(number(u)?, number(u)?, label(u)?).into(),
    })
}

fn items(u: &mut Unstructured<'_>) -> Result<Vec<plot::Item>> {
    let count = u.int_in_range(0..=6)?;
    (0..count).map(|_| item(u)).collect()
}

fn style(u: &mut Unstructured<'_>) -> Result<Style> {
    let size = match u.int_in_range(0..=3)? {
        0 => Size::pixels(number(u)?, number(u)?),
        1 => Size::millimetres(160.0, 100.0),
        _ => Size::pixels(f64::from(u.int_in_range(1_u16..=1200)?), f64::from(u.int_in_range(1_u16..=900)?)),
    };
    let theme = *u.choose(&[Theme::Light, Theme::Dark, Theme::Css])?;
    let language = if u.arbitrary()? { Language::De } else { Language::En };
    Ok(Style::new(size).theme(theme).language(language).id(&text(u)?))
}

fn holds(picture: &Picture) {
    let svg = picture.svg();
    let document = roxmltree::Document::parse(svg).unwrap_or_else(|error| panic!("{error}\n{svg}"));
    for node in document.descendants().filter(roxmltree::Node::is_element) {
        for attribute in node.attributes() {
            let free = matches!(attribute.name(), "class" | "id" | "font-family" | "stroke" | "fill" | "role")
                || attribute.name().starts_with("data-")
                || attribute.name().starts_with("aria-");
            let value = attribute.value();
            let numbers = value.replace("userSpaceOnUse", "");
            assert!(free || !(numbers.contains("NaN") || numbers.contains("inf")), "{}={value}", attribute.name());
        }
        for name in ["data-x-min", "data-x-max", "data-y-min", "data-y-max", "data-x", "data-y"] {
            let value = node.attribute(name).map(|value| value.parse::<f64>().unwrap());
            assert!(value.is_none_or(f64::is_finite), "{name}");
        }
        if let Some(size) = node.attribute("font-size") {
            assert!(size.parse::<f64>().unwrap() >= 9.33, "text below 7 pt: {size}");
        }
    }
    let (width, height) = picture.pixels();
    for (index, text) in picture.texts().iter().enumerate() {
        let area = &text.area;
        assert!(
            area.left >= -0.01 && area.right <= width + 0.01 && area.top >= -0.01 && area.bottom <= height + 0.01,
            "{text:?} leaves {width} × {height}"
        );
        for other in picture.texts().iter().skip(index + 1) {
            assert!(!area.overlaps(&other.area), "{text:?}\n{other:?}\n{svg}");
        }
    }
}

#[test]
fn planes_hold_whatever_is_drawn() {
    arbtest::arbtest(|u| {
        let mut chart = XyChart::new(axis(u)?, axis(u)?).title(label(u)?).description(&text(u)?);
        chart = if u.arbitrary()? { chart.four_quadrant() } else { chart };
        let style = style(u)?;
        chart = chart.with_all(items(u)?);
        let picture = chart.render(&style);
        holds(&picture);
        assert_eq!(picture, chart.render(&style));
        Ok(())
    });
}

#[test]
fn stacks_hold_whatever_is_drawn() {
    arbtest::arbtest(|u| {
        let mut chart = StackedChart::new(axis(u)?).title(label(u)?);
        for _ in 0..u.int_in_range(0..=4)? {
            chart = chart.segment(number(u)?, number(u)?, label(u)?);
        }
        for _ in 0..u.int_in_range(0..=5)? {
            let mut panel = Panel::new(axis(u)?);
            for item in items(u)? {
                panel = panel.with(item);
            }
            chart = chart.panel(panel);
        }
        let style = style(u)?;
        let picture = chart.render(&style);
        holds(&picture);
        assert_eq!(picture, chart.render(&style));
        Ok(())
    });
}

#[test]
fn bars_hold_whatever_is_drawn() {
    arbtest::arbtest(|u| {
        let mut chart = BarChart::new(axis(u)?).title(label(u)?);
        for _ in 0..u.int_in_range(0..=25)? {
            let verdict = *u.choose(&[Verdict::Pass, Verdict::Advice, Verdict::Fail, Verdict::NotChecked])?;
            let bar = Bar::new(label(u)?, verdict).text(label(u)?).class(&text(u)?);
            chart = match u.int_in_range(0..=4)? {
                0 => chart.bar(bar).explain(verdict, label(u)?),
                _ => chart.bar(bar.percent(number(u)?)),
            };
        }
        let style = style(u)?;
        let picture = chart.render(&style);
        holds(&picture);
        assert_eq!(picture, chart.render(&style));
        Ok(())
    });
}

#[test]
fn maps_hold_whatever_is_drawn() {
    arbtest::arbtest(|u| {
        let mut chart = XyChart::map(axis(u)?, axis(u)?).title(label(u)?);
        for _ in 0..u.int_in_range(0..=3)? {
            let named = points(u)?.into_iter().map(|(x, y)| Ok((x, y, label(u)?))).collect::<Result<Vec<_>>>()?;
            chart = chart.class(label(u)?, tone(u)?, named);
        }
        holds(&chart.render(&style(u)?));
        Ok(())
    });
}

#[test]
fn data_at_the_edges_of_numbers_are_drawn() {
    let style = Style::new(Size::pixels(500.0, 300.0));
    let series: [&[(f64, f64)]; 8] = [
        &[],
        &[(3.0, 4.0)],
        &[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)],
        &[(5.0, 7.0), (5.0, 7.0)],
        &[(1e-9, 1e9), (2e-9, -1e9)],
        &[(1e9, 1e-9), (1.000_000_001e9, 2e-9)],
        &[(-1e290, -1e290), (1e290, 1e290)],
        &[(5e-324, 5e-324), (0.0, 0.0)],
    ];
    for points in series {
        for (x, y) in [
            (PlaneAxis::new("x", "m"), PlaneAxis::new("y", "m")),
            (PlaneAxis::new("x", "m").without_zero(), PlaneAxis::new("y", "m").without_zero()),
        ] {
            let picture = XyChart::new(x, y).with(Line::new(points.iter().copied())).render(&style);
            holds(&picture);
            assert_eq!(picture.hidden_labels(), [""; 0], "{points:?}");
            assert!(picture.texts().len() >= 6, "{points:?} {:?}", picture.texts());
        }
    }
}

#[test]
fn points_that_are_no_numbers_are_counted_and_leave_a_gap() {
    let points = [(0.0, 1.0), (1.0, f64::NAN), (2.0, 3.0), (3.0, 4.0), (f64::INFINITY, 1.0)];
    let picture = XyChart::new(PlaneAxis::new("t", "s"), PlaneAxis::new("T", "Nm"))
        .with(Line::new(points).label("x"))
        .render(&Style::new(Size::pixels(400.0, 300.0)));
    assert_eq!(picture.dropped(), 2);
    assert!(picture.svg().contains("<g class=\"line\" data-label=\"x\" data-dropped=\"2\">"));
    holds(&picture);
}

#[test]
fn a_title_of_the_caller_is_text_and_nothing_else() {
    let picture = XyChart::new(PlaneAxis::new("<b>", "\"&"), PlaneAxis::new("y", "m/s"))
        .title("</title><script>alert(1)</script>")
        .with(Markers::new([(1.0, 2.0)]).class("a\" onload=\"x").data("on click", "\"><x>").label("<i>"))
        .render(&Style::new(Size::pixels(400.0, 300.0)));
    let document = roxmltree::Document::parse(picture.svg()).unwrap();
    assert!(document.descendants().all(|node| !matches!(node.tag_name().name(), "script" | "b" | "i" | "x")));
    assert!(document.descendants().all(|node| node.attribute("onload").is_none()));
    let marked = document.descendants().find(|node| node.attribute("data-on-click").is_some()).unwrap();
    assert_eq!(marked.attribute("data-on-click"), Some("\"><x>"));
}

#[test]
fn a_million_points_are_a_small_picture_with_every_peak() {
    let points = (0..1_000_000_u32).map(|i| (f64::from(i), if i == 777_777 { 50.0 } else { f64::from(i % 7) }));
    let picture = XyChart::new(PlaneAxis::new("t", "s"), PlaneAxis::new("T", "Nm").range(0.0, 100.0))
        .with(Line::new(points))
        .render(&Style::new(Size::pixels(600.0, 400.0)));
    assert!(picture.svg().len() < 120_000, "{}", picture.svg().len());
    let document = roxmltree::Document::parse(picture.svg()).unwrap();
    let plane = document.descendants().find(|node| node.attribute("class") == Some("plane")).unwrap();
    let edge = |name: &str| plane.attribute(name).unwrap().parse::<f64>().unwrap();
    let line = document.descendants().find(|node| node.attribute("class") == Some("line")).unwrap();
    let path = line.first_element_child().unwrap().attribute("d").unwrap();
    let heights =
        path.split(['M', 'L']).filter_map(|point| point.split_once(' ')).map(|(_, y)| y.parse::<f64>().unwrap());
    let peak = heights.reduce(f64::min).unwrap();
    assert!((peak - f64::midpoint(edge("data-top"), edge("data-bottom"))).abs() < 0.02, "{peak}");
}

#[cfg(feature = "png")]
#[test]
fn pixels_have_the_size_asked_for() {
    let picture = XyChart::new(PlaneAxis::new("t", "s"), PlaneAxis::new("T", "Nm"))
        .with(Line::new([(0.0, 1.0), (2.0, 3.0)]))
        .render(&Style::new(Size::pixels(400.0, 300.0)));
    let png = picture.png(2.0).unwrap();
    assert_eq!(png.get(1..4), Some(b"PNG".as_slice()));
    assert_eq!(png.get(16..24), Some([0, 0, 3, 32, 0, 0, 2, 88].as_slice()));
    assert!(picture.png(0.0).is_none() && picture.png(f64::NAN).is_none() && picture.png(1e9).is_none());
}
