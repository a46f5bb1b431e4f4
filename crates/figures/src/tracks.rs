//! Tracks of an encoder around the angle of its shaft.

use crate::drawing::{Chart, Drawing, Figure};
use answers::{EncoderSignal, EncoderState, SignalForm};
use plot::{Dash, Line, Panel, PlaneAxis, Reference, StackedChart, Tone};
use quantities::unit::MICROSECOND;
use quantities::{Language, format_significant};
use words::{capitalised, encoder, terms};

const WIDTH_MM: f64 = 165.0;
/// Height of title and axis of angle, and of a panel.
const FRAME_MM: f64 = 26.0;
const PANEL_MM: f64 = 20.0;

/// Draws the tracks over the angle, those of equal range in one picture; for a resolver, the voltages over time too.
#[must_use]
pub fn encoder_tracks(code: &str, state: &EncoderState, language: Language) -> Vec<Drawing> {
    let mut ranges: Vec<(f64, Vec<(&str, &EncoderSignal)>)> = Vec::new();
    for (name, signal) in &state.signals {
        let Some(range) = signal.curve.as_ref().and_then(|curve| curve.offset_deg.last()).map(|last| last.0) else {
            continue;
        };
        match ranges.iter_mut().find(|(of, _)| *of == range) {
            Some((_, signals)) => signals.push((name, signal)),
            None => ranges.push((range, vec![(name, signal)])),
        }
    }
    ranges.sort_by(|a, b| b.0.total_cmp(&a.0));
    let over_angle = ranges.iter().map(|(range, signals)| tracks(code, state, *range, signals, language));
    over_angle.chain(carrier(code, state, language)).collect()
}

/// Draws tracks over the same range of the angle, one below the other.
fn tracks(
    code: &str,
    state: &EncoderState,
    range: f64,
    signals: &[(&str, &EncoderSignal)],
    language: Language,
) -> Drawing {
    let l = language;
    let number = |value: f64| format_significant(value, 4, l);
    let angle = PlaneAxis::new("φ − φ_0", "°").name(&capitalised(encoder::angle_from_the_shaft(l))).minor_ticks();
    let mut chart = StackedChart::new(angle);
    let mut height = FRAME_MM;
    let mut described = vec![encoder::tracks_described(&number(state.shaft.angle_deg.0), &number(2.0 * range), l)];
    for (tone, (name, signal)) in (0_u8..).zip(signals) {
        let Some(curve) = &signal.curve else { continue };
        let is_level = signal.form == SignalForm::Level;
        let mut points: Vec<(f64, f64)> = Vec::new();
        for (offset, value) in curve.offset_deg.iter().zip(&curve.value) {
            // A digital level changes instantly.
            if let Some((_, before)) = points.last().filter(|_| is_level).copied() {
                points.push((offset.0, before));
            }
            points.push((offset.0, value.0));
        }
        let unit = if signal.unit == "1" { "" } else { signal.unit };
        let panel = Panel::new(PlaneAxis::new(name, unit)).with(Line::new(points).tone(Tone::Series(tone % 4)));
        chart = chart.panel(panel.with(Reference::vertical(0.0).dash(Dash::Dashed)));
        height += PANEL_MM;
        if let Some(value) = signal.value {
            described.push(format!("{name}: {} {unit}.", number(value.0)));
        }
    }
    let texts = (encoder::tracks_caption(&number(2.0 * range), l), described.join(" "));
    Drawing::new(Figure::EncoderTracks, code, (WIDTH_MM, height), texts, Chart::Stacked(chart), l)
}

/// Draws the voltages of a resolver over two periods of its excitation.
fn carrier(code: &str, state: &EncoderState, language: Language) -> Option<Drawing> {
    let l = language;
    let found = state.carrier.as_ref()?;
    let time = PlaneAxis::new("t", MICROSECOND.symbol).name(&capitalised(terms::time(l))).minor_ticks();
    let line = |volts: &[answers::Number], tone: u8, label: &str| {
        let points = found.time_us.iter().zip(volts).map(|(time, volts)| (time.0, volts.0));
        Line::new(points).tone(Tone::Series(tone)).label(label)
    };
    let panel = Panel::new(PlaneAxis::new("U", "V"))
        .with(line(&found.excitation_v, 2, encoder::excitation(l)))
        .with(line(&found.sine_v, 0, encoder::sine_winding(l)))
        .with(line(&found.cosine_v, 1, encoder::cosine_winding(l)));
    let described = encoder::carrier_described(&format_significant(found.frequency_khz.0, 3, l), l);
    let (size, texts) = ((WIDTH_MM, FRAME_MM + 3.0 * PANEL_MM), (encoder::carrier_caption(l).to_owned(), described));
    let chart = Chart::Stacked(StackedChart::new(time).panel(panel));
    Some(Drawing::new(Figure::EncoderTracks, code, size, texts, chart, l))
}

#[cfg(test)]
mod tests {
    use super::*;
    use questions::Progress;
    use questions::list::{Given, Inquiry, encoder};

    /// Compares the drawn tracks with the answer, for every encoder.
    #[test]
    fn every_track_that_follows_the_angle_is_drawn() {
        for (code, pictures, lines) in [
            ("CHA-25A-100-H-C1024", 2, 5),
            ("CHA-25A-100-H-M512P", 1, 2),
            ("CHA-17A-100-H-RES", 2, 5),
            ("CHA-17A-100-H-M128S", 1, 2),
            ("CHA-14A-100-N-D2048", 2, 6),
        ] {
            let pairs = [("code", code), ("angle", "30 deg")];
            let Ok(given) = Given::of(
                encoder::ENTRY.arguments,
                pairs.map(|(name, value)| (name.into(), value.into())),
                Language::De,
            ) else {
                panic!("{code}")
            };
            let progress = Progress::endless();
            let inquiry = Inquiry {
                given,
                sources: vec![],
                catalogue: questions::embedded_catalogue(),
                days_since_1970: None,
                progress: &progress,
                refuses_long: true,
                by_axes: false,
                language: Language::De,
            };
            let Ok(found) = encoder::found(&inquiry) else { panic!("{code}") };
            let drawn = encoder_tracks(code, &found.motor, Language::De);
            // Each block of curves has one column for the angle.
            let blocks = drawn.iter().map(|each| each.curves(Language::De));
            let heads = |text: String| -> usize {
                text.split("\n\n").filter_map(|block| Some(block.lines().next()?.split('\t').count() - 1)).sum()
            };
            let count: usize = blocks.map(heads).sum();
            assert_eq!((drawn.len(), count), (pictures, lines), "{code}");
        }
    }
}
