//! Selection of motion laws by their pictures: position, speed and acceleration of each, drawn once for the page.

use maud::{Markup, html};
use project::{Kind, SegmentLaw, key_at};
use quantities::{Language, format_number};
use questions::{law_peaks, law_shape};
use words::{law_text, page, views};

/// Width of the drawing, and height of each of the three curves, in units of the drawing.
const WIDTH: f64 = 48.0;
const HEIGHT: f64 = 16.0;
const GAP: f64 = 3.0;

/// Returns the laws by their names in the project file; `parabola` is another name of the triangle.
fn laws(words: &[&'static str]) -> impl Iterator<Item = (&'static str, SegmentLaw)> {
    words.iter().filter_map(|word| Some((*word, SegmentLaw::of_id(word).filter(|law| law.id() == *word)?)))
}

/// Returns the names of the laws in the project file.
pub(crate) fn words() -> &'static [&'static str] {
    match key_at("motion[1].law").map(|key| key.kind) {
        Some(Kind::OneOf(words)) => words,
        _ => &[],
    }
}

/// Returns the name of a law in the menu of all laws.
pub(crate) fn name(law: SegmentLaw, language: Language) -> &'static str {
    if law == SegmentLaw::Manual { page::trapezoid_with_pause(language) } else { law_text(law, language) }
}

/// Returns the drawings of all laws, referenced by [`menu`].
pub(crate) fn symbols(words: &[&'static str]) -> Markup {
    let height = 3.0 * HEIGHT + 2.0 * GAP;
    html! {
        svg.hidden width="0" height="0" aria-hidden="true" {
            @for (word, law) in laws(words) {
                symbol id={ "law-" (word) } viewBox={ "-2 -2 " (WIDTH + 4.0) " " (height + 4.0) } {
                    @for place in 1..4_u8 {
                        @let (zero, path) = curve(law, place);
                        path.axis d={ "M0 " (zero) "H" (WIDTH) } {}
                        path class={ "of-" (place) } d=(path) {}
                    }
                }
            }
        }
    }
}

/// Returns the height of the zero line, and one of the curves: 1 position, 2 speed, 3 acceleration.
fn curve(law: SegmentLaw, place: u8) -> (f64, String) {
    let top = f64::from(place - 1) * (HEIGHT + GAP);
    // Position and speed are above zero, acceleration on both sides.
    let (zero, unit) = if place == 3 { (top + HEIGHT / 2.0, HEIGHT / 2.0) } else { (top + HEIGHT, HEIGHT) };
    let shape = law_shape(law);
    if shape.is_empty() {
        return (zero, recorded(place, zero, unit));
    }
    let mut path = String::new();
    for point in &shape {
        let (Some(time), Some(value)) = (point.first(), point.get(usize::from(place))) else { continue };
        let sign = if path.is_empty() { 'M' } else { 'L' };
        path.push_str(&format!("{sign}{:.1} {:.1}", time * WIDTH, zero - value * unit));
    }
    (zero, path)
}

/// Returns the drawing of a recording, which has no shape of its own: measured points.
fn recorded(place: u8, zero: f64, unit: f64) -> String {
    const VALUES: [[f64; 7]; 3] = [
        [0.0, 0.1, 0.45, 0.6, 0.9, 0.8, 1.0],
        [0.0, 0.7, 1.0, 0.4, 0.8, 0.3, 0.0],
        [0.2, 0.9, -0.6, 0.5, -0.8, 0.4, -0.2],
    ];
    let values = VALUES.get(usize::from(place - 1)).copied().unwrap_or_default();
    let point = |(x, value): (f64, f64)| format!("M{:.1} {:.1}h2v2h-2z", x * 7.5, zero - value * unit - 1.0);
    (0_u8..).map(f64::from).zip(values).map(point).collect()
}

/// Returns the laws as a group of pictures of which one is selected; `id` is that of the plain selection list, which
/// takes the value selected here.
pub(crate) fn menu(id: &str, words: &[&'static str], chosen: &str, language: Language) -> Markup {
    html! {
        div data-law=(id) {
            fieldset {
                legend.small { (page::law_pictures_about(language)) }
                @for (word, law) in laws(words) {
                    label.law {
                        input type="radio" id={ (id) "-" (word) } name={ "law-of-" (id) } value=(word) checked[word == chosen] data-checked=(word == chosen);
                        svg width="52" height="58" aria-hidden="true" { use href={ "#law-" (word) } {} }
                        span { (name(law, language)) }
                        @if let Some([speed, acceleration]) = law_peaks(law) {
                            span.small title=(views::peaks_about(language)) { "C" sub { "v" } " " (format_number(speed, 2, language)) br; "C" sub { "a" } " " (format_number(acceleration, 2, language)) }
                        }
                    }
                }
            }
        }
    }
}
