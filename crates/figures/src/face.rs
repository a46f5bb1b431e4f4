//! Mating face of a connector with its pins.

use crate::drawing::{Chart, Drawing, Figure};
use order_code::OrderCode;
use plot::{FaceChart, FacePin, Tone};
use quantities::Language;
use questions::list::wiring::{Connector, SignalGroup};
use std::f64::consts::TAU;
use words::{cell_text, typeset, wiring};

/// Returns the number of pins on each ring, from the outside: a schematic arrangement, since the figures of the manual
/// are lost.
const fn rings(poles: usize) -> &'static [usize] {
    match poles {
        12 => &[9, 3],
        17 => &[11, 5, 1],
        _ => &[],
    }
}

/// Radii of the rings.
const RADII: [f64; 3] = [1.0, 0.52, 0.0];

/// Returns the place of the pin with this index: clockwise from the top, ring by ring.
fn place(index: usize, poles: usize) -> (f64, f64) {
    let all = [poles];
    let known = rings(poles);
    let rings: &[usize] = if known.iter().sum::<usize>() == poles { known } else { &all };
    let mut before = 0;
    for (count, radius) in rings.iter().zip(RADII) {
        if index < before + count {
            #[expect(clippy::cast_precision_loss, reason = "a connector has few pins")]
            let turn = (index - before) as f64 / *count as f64;
            let (sine, cosine) = (TAU * turn).sin_cos();
            return (radius * sine, -radius * cosine);
        }
        before += count;
    }
    (0.0, 0.0)
}

/// Returns the colour of a kind of signal; the numbers distinguish the pins.
const fn tone(group: SignalGroup) -> Tone {
    match group {
        SignalGroup::Phase | SignalGroup::Resolver => Tone::Series(0),
        SignalGroup::Earth | SignalGroup::Shield => Tone::Series(2),
        SignalGroup::Brake | SignalGroup::Supply => Tone::Series(1),
        SignalGroup::Sense | SignalGroup::Commutation => Tone::Series(4),
        SignalGroup::Ptc | SignalGroup::Kty => Tone::Series(3),
        SignalGroup::Incremental | SignalGroup::Reference => Tone::Series(0),
        SignalGroup::Serial => Tone::Series(5),
    }
}

/// Texts in the list of pins next to a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PinTexts {
    /// Signal, wire shared with another pin, colour.
    Full,
    /// Signal only: half the width and no title, for use below a table of the pins that has the colours.
    Signals,
}

/// Draws the mating face of a connector: numbers and signals of its pins. Their places are schematic, as the caption
/// states.
#[must_use]
pub fn mating_face(code: &OrderCode, connector: &Connector, texts: PinTexts, language: Language) -> Drawing {
    let mut chart = FaceChart::default();
    let mut sentences = Vec::new();
    for (index, pin) in connector.pins.iter().enumerate() {
        let mut text = match pin.carries {
            Some(_) => wiring::cell_or_dash(pin.signal, language).to_owned(),
            None => wiring::unconnected(pin.colour.is_some(), language).to_owned(),
        };
        sentences.push(format!("{} {text}", pin.name));
        if texts == PinTexts::Signals {
            text = pin.carries.map_or_else(|| "–".to_owned(), |_| text);
        } else if let Some(other) = &pin.joined {
            text.push(' ');
            text.push_str(&wiring::joined(other, language));
        }
        if let Some(colour) = pin.colour.filter(|_| texts == PinTexts::Full) {
            text.push_str(", ");
            text.push_str(cell_text(colour, language));
        }
        let drawn = FacePin::new(pin.name.as_str(), place(index, connector.pins.len())).text(text.as_str());
        let drawn = drawn.data("pin", &pin.name);
        chart = chart.pin(match pin.carries {
            Some(signal) => drawn.tone(tone(signal.group())),
            None => drawn,
        });
    }
    let description =
        wiring::face_described(&connector.poles, &typeset(connector.thread), &sentences.join(", "), language);
    let note = wiring::schematic(language);
    let of = format!("{}, {code} ({})", wiring::role_name(connector.role, language), typeset(connector.kind.corrected));
    let size = if texts == PinTexts::Full { (135.0, 85.0) } else { (81.0, 60.0) };
    let chart = chart.note(note);
    let named = (note.to_owned(), description);
    let drawing = Drawing::new(Figure::MatingFace, &of, size, named, Chart::Face(chart.clone()), language);
    if texts == PinTexts::Full {
        return drawing;
    }
    // The caption already contains the title.
    let chart = chart.description(&drawing.description);
    Drawing { chart: Chart::Face(chart), ..drawing }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_pins_of_a_face_stand_on_each_other() {
        for poles in [6, 8, 12, 17] {
            let places: Vec<(f64, f64)> = (0..poles).map(|index| place(index, poles)).collect();
            for (index, one) in places.iter().enumerate() {
                for other in places.iter().skip(index + 1) {
                    // Two pins of a radius of 0.125 / 0.725 each.
                    assert!((one.0 - other.0).hypot(one.1 - other.1) > 0.35, "{poles}: {one:?} {other:?}");
                }
            }
        }
    }
}
