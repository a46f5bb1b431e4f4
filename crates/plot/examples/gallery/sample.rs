//! Sample data of the kind that the charts are for; none of it is of a product.

use std::f64::consts::PI;

use plot::{
    Area, Axis, Dash, Hatch, Label, Line, Markers, Note, Picture, Reference, Shape, Style, Tone, Width, XyChart,
};
use quantities::Language;

/// Draws one sample.
pub(crate) type Draw = fn(Language, &Style) -> Picture;

/// Name, size in mm and drawing of every sample.
pub(crate) const ALL: &[(&str, (f64, f64), Draw)] =
    &[("plane", (165.0, 115.0), plane), ("torsion", (120.0, 80.0), torsion)];

const fn say(language: Language, en: &'static str, de: &'static str) -> &'static str {
    match language {
        Language::En => en,
        Language::De => de,
    }
}

fn mirrored(limit: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let upper = limit.iter().copied();
    let right = limit.iter().rev().map(|(n, t)| (*n, -t));
    let lower = limit.iter().map(|(n, t)| (-n, -t));
    let left = limit.iter().rev().map(|(n, t)| (-n, *t));
    upper.chain(right).chain(lower).chain(left).collect()
}

fn plane(language: Language, style: &Style) -> Picture {
    let short = |v: f64| vec![(0.0, 57.0), (62.0 * v, 57.0), (104.0 * v, 8.0), (112.0 * v, 0.0)];
    let cycle: Vec<(f64, f64)> = (0..400)
        .map(|i| {
            let phase = f64::from(i) / 400.0 * 2.0 * PI;
            (
                55.0 * phase.sin() + 9.0 * (3.0 * phase).sin(),
                24.0 * phase.cos() + 9.0 * phase.sin() + 4.0 * (5.0 * phase).cos(),
            )
        })
        .collect();
    let mut chart = XyChart::new(
        Axis::new("n_out", "min⁻¹").name(say(language, "Output speed", "Abtriebsdrehzahl")).minor_ticks(),
        Axis::new("T_out", "Nm").name(say(language, "Output torque", "Abtriebsdrehmoment")).minor_ticks(),
    )
    .title(say(
        language,
        "Torque–speed plane, size 25, ratio 100",
        "Drehmoment-Drehzahl-Ebene, Größe 25, Übersetzung 100",
    ))
    .description(say(language, "Limits at three voltages and the cycle", "Grenzen bei drei Spannungen und der Zyklus"))
    .four_quadrant()
    .with(
        Area::between(mirrored(&short(0.93)), mirrored(&short(1.06)))
            .tone(Tone::ShortTime)
            .hatch(Hatch::Rising)
            .label(say(language, "band of the estimate", "Band der Schätzung")),
    );
    for (v, width) in [(1.0, Width::Normal), (0.8, Width::Thin), (0.6, Width::Thin)] {
        let line = Line::new(mirrored(&short(v))).tone(Tone::ShortTime).width(width);
        chart = chart.with(line.label(say(language, "short-time limit", "Kurzzeitgrenze")));
        let text = format!(
            "{} V",
            if v == 1.0 {
                "680"
            } else if v == 0.8 {
                "560"
            } else {
                "400"
            }
        );
        chart = chart.with(Note::new(62.0 * v, 57.0, text.as_str()).tone(Tone::ShortTime));
    }
    let continuous = vec![(0.0, 31.0), (45.0, 28.0), (80.0, 21.0), (92.0, 8.0), (92.0, 0.0)];
    chart
        .with(Line::new(mirrored(&continuous)).tone(Tone::Continuous).width(Width::Strong).label(say(
            language,
            "continuous limit",
            "Dauergrenze",
        )))
        .with(Line::new(cycle).closed().label(say(language, "cycle", "Zyklus")).width(Width::Normal))
        .with(
            Markers::new([(38.0, 18.4)])
                .shape(Shape::Diamond)
                .label(Label::symbol("T_rms").text(", ").and_symbol("n_av")),
        )
        .with(Markers::new([(-12.0, 31.5), (12.0, -31.0)]).hollow().label(say(language, "peaks", "Spitzen")))
        .with(Note::new(-12.0, 31.5, Label::symbol("T_max").text(say(language, " = 31.50 Nm", " = 31,50 Nm"))))
        .with(Note::new(38.0, 18.4, say(language, "mean point", "Mittelpunkt")))
        .render(style)
}

fn torsion(language: Language, style: &Style) -> Picture {
    let curve = |t: f64| {
        let (k1, k2, k3) = (8.1, 13.0, 16.0);
        let a = t.abs();
        let angle = a.min(3.9) / k1 + (a.min(12.0) - 3.9).max(0.0) / k2 + (a - 12.0).max(0.0) / k3;
        angle * t.signum() * 3.4
    };
    let points = (-200..=200).map(|i| f64::from(i) * 0.15).map(|t| (t, curve(t)));
    XyChart::new(
        Axis::new("T", "Nm").name(say(language, "Torque", "Drehmoment")),
        Axis::new("φ", "arcmin").name(say(language, "Torsion", "Verdrehung")),
    )
    .title(say(language, "Torsion of the gear", "Torsion des Getriebes"))
    .with(
        Area::between(
            (-200..=200).map(|i| f64::from(i) * 0.15).map(|t| (t, curve(t) * 0.8)),
            (-200..=200).map(|i| f64::from(i) * 0.15).map(|t| (t, curve(t) * 1.2)),
        )
        .hatch(Hatch::Rising)
        .label("±20 %"),
    )
    .with(Line::new(points).tone(Tone::Series(0)).label(say(language, "torsion", "Verdrehung")))
    .with(Reference::vertical(3.9).label(Label::symbol("T_1")).dash(Dash::Dotted))
    .with(Reference::vertical(12.0).label(Label::symbol("T_2")).dash(Dash::Dotted))
    .with(Markers::new([(18.5, curve(18.5))]).tone(Tone::Trace).label(say(language, "working point", "Arbeitspunkt")))
    .with(Note::new(18.5, curve(18.5), say(language, "18.50 Nm → 5.10′", "18,50 Nm → 5,10′")))
    .render(style)
}
