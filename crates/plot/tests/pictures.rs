//! Snapshots: a picture changes only when someone wants it to.

use plot::{Area, Bar, BarChart, Hatch, Line, Note, PlaneAxis, Size, Style, Theme, Tone, Verdict, XyChart};
use quantities::Language;

#[test]
fn a_plane_in_german() {
    let limit = [(0.0, 9.5), (3000.0, 9.5), (4500.0, 0.0)];
    let picture =
        XyChart::new(PlaneAxis::new("n", "min⁻¹").name("Drehzahl"), PlaneAxis::new("T", "Nm").name("Drehmoment"))
            .title("Grenzen")
            .description("Dauergrenze mit Band")
            .with(Area::between(limit, limit.map(|(n, t)| (n * 1.1, t))).hatch(Hatch::Rising).label("Band"))
            .with(Line::new(limit).tone(Tone::Continuous).label("Dauergrenze").class("limit").data("id", "S1"))
            .with(Note::new(3000.0, 9.5, "9,50 Nm"))
            .render(&Style::new(Size::millimetres(100.0, 70.0)).language(Language::De));
    insta::assert_snapshot!(picture.svg());
}

#[test]
fn bars_in_css() {
    let picture = BarChart::new(PlaneAxis::new("", "%").name("Utilisation"))
        .title("Checks")
        .bar(Bar::new("Peak torque", Verdict::Pass).percent(62.4).text("62.40 %"))
        .bar(Bar::new("Inertia ratio", Verdict::Fail).percent(640.0).text("640.00 %"))
        .bar(Bar::new("Regeneration", Verdict::NotChecked).text("not checked"))
        .render(&Style::new(Size::pixels(420.0, 120.0)).theme(Theme::Css));
    insta::assert_snapshot!(picture.svg());
}

#[test]
fn decimals_follow_the_language() {
    let chart = XyChart::map(PlaneAxis::new("m", "kg"), PlaneAxis::new("P", "W")).class(
        "one",
        Tone::Trace,
        [(1.2, 2.4e6, "A")],
    );
    let texts = |language| {
        let picture = chart.render(&Style::new(Size::pixels(400.0, 300.0)).language(language));
        picture.texts().iter().map(|text| text.text.clone()).collect::<Vec<_>>()
    };
    let (german, english) = (texts(Language::De), texts(Language::En));
    assert!(german.contains(&"0,5".to_owned()) && !german.iter().any(|text| text.contains('.')), "{german:?}");
    assert!(english.contains(&"0.5".to_owned()) && !english.iter().any(|text| text.contains(',')), "{english:?}");
    assert!(german.contains(&"P / 10⁶ W".to_owned()));
}
