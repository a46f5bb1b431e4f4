//! Pictures of docs/theory and docs/theorie on heat: computed curves together with all published points.
//!
//! `cargo run -p configurator --example heat_pictures -- docs`

use actuator::{HeatModel, Parameters};
use order_code::parse;
use plot::{Area, Label, Line, Markers, Note, PlaneAxis, Reference, Shape, Size, Style, Theme, Tone, XyChart};
use quantities::unit::REVOLUTION_PER_MINUTE;
use quantities::{AngularVelocity, Language, Measure, Time};
use std::path::Path;

type Fault = Box<dyn std::error::Error>;

fn main() -> Result<(), Fault> {
    let docs = std::env::args().nth(1).ok_or("a folder is missing")?;
    for (language, theory) in [(Language::En, "theory"), (Language::De, "theorie")] {
        let folder = Path::new(&docs).join(theory).join("pictures");
        std::fs::create_dir_all(&folder)?;
        let draw = |name: &str, height: f64, chart: XyChart| {
            let style = Style::new(Size::millimetres(165.0, height)).theme(Theme::Light).language(language).id(name);
            std::fs::write(folder.join(format!("{name}.svg")), chart.render(&style).svg())
        };
        let words = Words { language };
        draw("continuous-20A", 110.0, continuous(words)?)?;
        draw("heat-shares", 95.0, shares(words)?)?;
    }
    Ok(())
}

/// Words of the pictures in one language.
#[derive(Clone, Copy)]
struct Words {
    language: Language,
}

impl Words {
    fn of(self, english: &'static str, german: &'static str) -> &'static str {
        match self.language {
            Language::En => english,
            Language::De => german,
        }
    }
}

fn parameters(code: &str) -> Result<Parameters, Fault> {
    let code = parse(code).map_err(|_| "no code")?.code;
    configurator::parameters(&code).ok_or_else(|| "no data".into())
}

const RATIOS: [u16; 4] = [30, 50, 80, 120];

/// Returns the chart of the estimated band and the published curve of each ratio.
fn continuous(words: Words) -> Result<XyChart, Fault> {
    let mut chart = XyChart::new(
        PlaneAxis::new("n", "min⁻¹").name(words.of("Output speed", "Abtriebsdrehzahl")).minor_ticks(),
        PlaneAxis::new("T", "Nm").name(words.of("Continuous torque", "Dauerdrehmoment")).minor_ticks(),
    )
    .description(words.of(
        "Estimated band of the continuous torque of CHA-20A for four ratios, with the published corner points",
        "Geschätztes Band des Dauerdrehmoments von CHA-20A für vier Untersetzungen, mit den veröffentlichten Eckpunkten",
    ));
    for (index, ratio) in RATIOS.into_iter().enumerate() {
        let p = parameters(&format!("CHA-20A-{ratio}-H-C1024"))?;
        let end = actuator::speed_rated_out(&p).map_err(|_| "n_N")?.value.si();
        let stall = p.stall_torque.known().map_or(f64::INFINITY, |stall| stall.value.si());
        let (mut low, mut high) = (Vec::new(), Vec::new());
        for part in 0..=60 {
            let speed = AngularVelocity::from_si(end * f64::from(part) / 60.0);
            let limit = actuator::estimated_continuous_torque(&p, speed).map_err(|_| "estimate")?;
            let n = speed.in_unit(&REVOLUTION_PER_MINUTE);
            low.push((n, limit.limit.value.si()));
            high.push((n, limit.upper.si()));
        }
        let curve = p.continuous_curve.known().ok_or("curve")?;
        let points: Vec<(f64, f64)> = curve
            .value
            .points()
            .iter()
            .map(|point| (point.speed.in_unit(&REVOLUTION_PER_MINUTE), point.torque.si().min(stall)))
            .collect();
        let (mut area, mut line) = (Area::between(low.clone(), high.clone()), Line::new(points.clone()));
        let mut markers = Markers::new(points.clone()).shape(Shape::Circle);
        if index == 0 {
            area = area.label(words.of("band of the estimate", "Band der Schätzung"));
            line = line.label(words.of("published", "veröffentlicht"));
            markers = markers.label(words.of("corner points, at most T₀", "Eckpunkte, höchstens T₀"));
        }
        chart = chart.with(area.tone(Tone::Continuous)).with(line.tone(Tone::Trace)).with(markers);
        if let Some(last) = points.last() {
            chart = chart.with(Note::new(last.0, last.1, Label::from(format!("i = {ratio}").as_str())));
        }
    }
    Ok(chart)
}

/// Returns the chart of the ratio of modelled to permissible temperature rise at each published point, by frame size;
/// points of the related series as in the reference test.
fn shares(words: Words) -> Result<XyChart, Fault> {
    let mut own = Vec::new();
    for (offset, ratio) in [-0.9, -0.3, 0.3, 0.9].into_iter().zip(RATIOS) {
        let p = parameters(&format!("CHA-20A-{ratio}-H-C1024"))?;
        let model = HeatModel::of(&p).map_err(|_| "heat")?;
        let stall = p.stall_torque.known().map_or(f64::INFINITY, |stall| stall.value.si());
        let end = actuator::speed_rated_out(&p).map_err(|_| "n_N")?.value.si();
        for point in p.continuous_curve.known().ok_or("curve")?.value.points() {
            let (speed, torque) = (point.speed.si().min(end), point.torque.si().min(stall));
            if speed > 0.0 {
                let (speed, torque) = (AngularVelocity::from_si(speed), quantities::Torque::from_si(torque));
                own.push((20.0 + offset, model.rise_share(torque, speed, 1.0, Time::from_si(60.0)).0));
            }
        }
    }
    // docs/theory/thermal.md, table of the cross-validation; checked by reference_sister_series.
    let sisters = [
        (13.4, 1.20),
        (14.0, 0.94),
        (14.6, 0.71),
        (17.0, 1.27),
        (24.7, 1.06),
        (25.3, 1.03),
        (31.4, 1.00),
        (32.0, 0.98),
        (32.6, 0.94),
        (39.4, 1.08),
        (40.0, 1.01),
        (40.6, 1.03),
    ];
    let gear = [(17.6, 0.91), (18.2, 0.55), (25.9, 0.83)];
    let chart = XyChart::new(
        PlaneAxis::new("s", "").name(words.of("Frame size", "Baugröße")).range(12.0, 42.0),
        PlaneAxis::new("x", "")
            .name(words.of("Rise of the winding over 40 K", "Übertemperatur der Wicklung durch 40 K"))
            .range(0.4, 1.4)
            .minor_ticks(),
    )
    .description(words.of(
        "Share of the permitted rise that the model finds at every published continuous point, by frame size",
        "Anteil der zulässigen Übertemperatur nach dem Modell an jedem veröffentlichten Dauerpunkt, nach Baugröße",
    ))
    .with(
        Markers::new(own)
            .shape(Shape::Circle)
            .tone(Tone::Continuous)
            .label(words.of("CHA-20A, calibrated here", "CHA-20A, hier kalibriert")),
    )
    .with(Markers::new(sisters).shape(Shape::Diamond).tone(Tone::Trace).label(
        words.of("FHA-C and FHA-C mini, not used in the fit", "FHA-C und FHA-C mini, nicht zur Anpassung verwendet"),
    ))
    .with(
        Markers::new(gear)
            .shape(Shape::Cross)
            .tone(Tone::Muted)
            .label(words.of("limited by the gear", "durch das Getriebe begrenzt")),
    )
    .with(Reference::horizontal(1.0).label(words.of("just permitted", "gerade zulässig")))
    .with(Reference::horizontal(0.85).label(words.of("lower edge", "unterer Rand")))
    .with(Reference::horizontal(1.15).label(words.of("upper edge of 20A to 40A", "oberer Rand von 20A bis 40A")));
    Ok(chart)
}
