//! Sample data typical of the charts; none of it belongs to a product.

use std::f64::consts::PI;

use plot::{
    Area, Bar, BarChart, Dash, Hatch, Label, Line, Markers, Note, Panel, Picture, PlaneAxis, Reference, Shape,
    StackedChart, Style, Tone, Verdict, Width, XyChart,
};
use quantities::{Language, format_number};

/// Draws one sample.
pub(crate) type Draw = fn(Language, &Style) -> Picture;

/// Name, size in mm and drawing of every sample.
pub(crate) const ALL: &[(&str, (f64, f64), Draw)] = &[
    ("plane", (165.0, 115.0), plane),
    ("stacked", (165.0, 190.0), stacked),
    ("bars", (165.0, 130.0), bars),
    ("map", (165.0, 110.0), map),
    ("torsion", (120.0, 80.0), torsion),
];

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
        PlaneAxis::new("n_out", "min⁻¹").name(say(language, "Output speed", "Abtriebsdrehzahl")).minor_ticks(),
        PlaneAxis::new("T_out", "Nm").name(say(language, "Output torque", "Abtriebsdrehmoment")).minor_ticks(),
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
        PlaneAxis::new("T", "Nm").name(say(language, "Torque", "Drehmoment")),
        PlaneAxis::new("φ", "arcmin").name(say(language, "Torsion", "Verdrehung")),
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

fn stacked(language: Language, style: &Style) -> Picture {
    let times = || (0..=4000).map(|i| f64::from(i) * 5e-4);
    let speed = |t: f64| match t {
        t if t < 0.4 => 40.0 * (1.0 - (PI * t / 0.4).cos()) / 2.0,
        t if t < 0.9 => 40.0,
        t if t < 1.3 => 40.0 * (1.0 + (PI * (t - 0.9) / 0.4).cos()) / 2.0,
        _ => 0.0,
    };
    let acceleration = move |t: f64| (speed(t + 5e-4) - speed(t - 5e-4)) / 1e-3 * 2.0 * PI / 60.0;
    let torque = move |t: f64| 1.3 * acceleration(t) + if speed(t) > 0.0 { 6.0 } else { 2.0 };
    let current = move |t: f64| torque(t) / 11.4 + 0.02 * (t * 900.0).sin();
    let angle: Vec<(f64, f64)> = times()
        .scan(0.0, |sum, t| {
            *sum += speed(t) * 5e-4 * 6.0;
            Some((t, *sum))
        })
        .collect();
    StackedChart::new(PlaneAxis::new("t", "s").name(say(language, "Time", "Zeit")).minor_ticks())
        .title(say(language, "Cycle of the turntable", "Zyklus des Drehtisches"))
        .segment(0.0, 0.4, say(language, "accelerate", "Beschleunigen"))
        .segment(0.4, 0.9, say(language, "constant speed", "Konstante Drehzahl"))
        .segment(0.9, 1.3, say(language, "brake", "Bremsen"))
        .segment(1.3, 2.0, say(language, "dwell, held by the motor", "Stillstand, vom Motor gehalten"))
        .panel(
            Panel::new(PlaneAxis::new("φ", "°").name(say(language, "Angle", "Winkel")))
                .with(Line::new(angle).tone(Tone::Trace)),
        )
        .panel(
            Panel::new(PlaneAxis::new("n_out", "min⁻¹").name(say(language, "Speed", "Drehzahl")))
                .with(Line::new(times().map(|t| (t, speed(t)))))
                .with(
                    Reference::horizontal(52.0)
                        .tone(Tone::ShortTime)
                        .dash(Dash::Dashed)
                        .label(Label::symbol("n_max").text(say(language, " = 52.00 min⁻¹", " = 52,00 min⁻¹"))),
                ),
        )
        .panel(
            Panel::new(PlaneAxis::new("T_out", "Nm").name(say(language, "Torque", "Drehmoment")))
                .with(Line::new(times().map(|t| (t, torque(t)))).label(say(language, "demand", "Bedarf")))
                .with(Line::new(times().map(|t| (t, torque(t) * 0.8 + 3.0))).tone(Tone::Series(1)).label(say(
                    language,
                    "of the load",
                    "der Last",
                )))
                .with(Reference::horizontal(27.0).tone(Tone::Continuous).dash(Dash::Solid).label(say(
                    language,
                    "continuous",
                    "dauernd",
                ))),
        )
        .panel(
            Panel::new(PlaneAxis::new("I", "A").name(say(language, "Current", "Strom")))
                .with(Line::new(times().map(|t| (t, current(t)))).tone(Tone::Series(0))),
        )
        .panel(
            Panel::new(
                PlaneAxis::new("ϑ_w", "°C")
                    .name(say(language, "Winding temperature", "Wicklungstemperatur"))
                    .without_zero(),
            )
            .with(
                Line::new(times().map(|t| (t, 70.0 + 4.0 * (1.0 - (-t).exp()) + 0.6 * (t * 5.0).sin())))
                    .tone(Tone::Series(5)),
            )
            .with(Reference::horizontal(82.0).tone(Tone::Continuous).label(say(language, "limit", "Grenze"))),
        )
        .render(style)
}

fn bars(language: Language, style: &Style) -> Picture {
    use Verdict::{Advice, Fail, NotChecked, Pass};
    const ROWS: &[(&str, &str, Verdict, f64)] = &[
        ("Peak torque", "Spitzendrehmoment", Pass, 62.4),
        ("Peak speed", "Spitzendrehzahl", Pass, 77.03),
        ("Mean speed", "Mittlere Drehzahl", Pass, 41.2),
        ("Continuous torque", "Dauerdrehmoment", Advice, 96.8),
        ("Peak current", "Spitzenstrom", Pass, 58.31),
        ("Demagnetisation", "Entmagnetisierung", Pass, 33.0),
        ("Terminal voltage", "Klemmenspannung", Fail, 112.45),
        ("Winding temperature", "Wicklungstemperatur", Pass, 84.9),
        ("Regeneration", "Rückspeisung", NotChecked, 0.0),
        ("Inertia ratio", "Trägheitsverhältnis", Fail, 640.2),
        ("Ambient temperature", "Umgebungstemperatur", Pass, 62.5),
        ("Average torque", "Durchschnittsdrehmoment", Pass, 71.0),
        ("Momentary peak torque (emergency stop, collision)", "Kollisionsdrehmoment (Not-Halt, Anprall)", Pass, 22.8),
        ("Mean input speed", "Mittlere Antriebsdrehzahl", Pass, 68.6),
        ("Life of the wave generator", "Lebensdauer des Wave Generators", Advice, 91.0),
        ("Torsion", "Verdrehung", NotChecked, 0.0),
        ("Axial load", "Axiallast", Pass, 12.5),
        ("Radial load", "Radiallast", Pass, 0.0),
        ("Tilting moment", "Kippmoment", Pass, 48.77),
        ("Static safety", "Statische Sicherheit", Pass, 39.1),
        ("Life L10", "Lebensdauer L10", Pass, 8.2),
        ("Screw joint", "Schraubverbindung", NotChecked, 0.0),
    ];
    let mut chart = BarChart::new(PlaneAxis::new("", "%").name(say(language, "Utilisation", "Auslastung"))).title(say(
        language,
        "Checks",
        "Nachweise",
    ));
    for (en, de, verdict, percent) in ROWS {
        let label = say(language, en, de);
        if *verdict == NotChecked {
            chart = chart.bar(Bar::new(label, NotChecked).text(say(language, "not checked", "nicht geprüft")));
        } else {
            let text = format!("{} %", format_number(*percent, 2, language));
            chart = chart.bar(Bar::new(label, *verdict).percent(*percent).text(text));
        }
    }
    chart
        .explain(Pass, say(language, "pass", "erfüllt"))
        .explain(Advice, say(language, "advice", "Hinweis"))
        .explain(Fail, say(language, "fail", "nicht erfüllt"))
        .explain(NotChecked, say(language, "not checked", "nicht geprüft"))
        .render(style)
}

fn map(language: Language, style: &Style) -> Picture {
    // A linear congruential generator scatters the points the same way every time.
    let mut state = 7_u32;
    let mut next = move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 24)
    };
    let sizes = [14, 17, 20, 25, 32, 40, 50, 58];
    let points: Vec<(f64, f64, String)> = [30, 50, 80, 100, 120]
        .into_iter()
        .flat_map(|ratio| sizes.map(|size| (size, ratio)))
        .map(|(size, ratio)| {
            let mass = f64::from(size).powf(1.7) / 60.0 * (0.9 + 0.2 * next());
            let load = 3400.0 / f64::from(size).powf(1.35) / f64::from(ratio).powf(0.3) * (0.7 + 0.6 * next()) * 4.0;
            (mass, load, format!("{size}A-{ratio}"))
        })
        .collect();
    let of = |from: f64, to: f64| points.iter().filter(move |p| p.1 >= from && p.1 < to).cloned().collect::<Vec<_>>();
    XyChart::map(
        PlaneAxis::new("m", "kg").name(say(language, "Mass", "Masse")),
        PlaneAxis::new("", "%").name(say(language, "Highest utilisation", "Höchste Auslastung")),
    )
    .title(say(language, "Candidates", "Kandidaten"))
    .class(say(language, "fits", "geeignet"), Tone::Series(0), of(0.0, 80.0))
    .class(say(language, "fits, with advice", "geeignet, mit Hinweis"), Tone::Series(4), of(80.0, 100.0))
    .class(say(language, "does not fit", "nicht geeignet"), Tone::Series(1), of(100.0, 1e9))
    .with(Reference::horizontal(100.0).tone(Tone::Continuous).dash(Dash::Solid))
    .render(style)
}
