//! Sizes of the letters on the pages of a document, in the text and in the diagrams.

use crate::press::{forget, typeset};
use crate::{Content, Fault, Settings};
use typst::layout::{Frame, FrameItem};
use typst::visualize::ImageKind;

/// A run of text with the size of its letters.
#[derive(Clone, Debug, PartialEq)]
pub struct Letter {
    /// Number of the page, from 1.
    pub page: usize,
    /// Size on the page \[pt\].
    pub size_pt: f64,
    /// The text; for a diagram the line of its SVG.
    pub text: String,
}

/// Lists every run of text with the size of its letters on the page, those within diagrams included.
///
/// # Errors
/// As [`crate::pdf`].
#[doc(hidden)]
pub fn letters(content: &Content, settings: &Settings) -> Result<Vec<Letter>, Fault> {
    let document = typeset(content, settings)?;
    let mut found = Vec::new();
    for (index, page) in document.pages().iter().enumerate() {
        collect(&page.frame, 1.0, index + 1, &mut found);
    }
    forget();
    Ok(found)
}

fn collect(frame: &Frame, scale: f64, page: usize, found: &mut Vec<Letter>) {
    for (_, item) in frame.items() {
        match item {
            FrameItem::Group(group) => {
                let (x, y) = (group.transform.sx.get(), group.transform.sy.get());
                // Rotated text has its size in the other two terms.
                let (kx, ky) = (group.transform.kx.get(), group.transform.ky.get());
                collect(&group.frame, scale * x.hypot(ky).min(y.hypot(kx)), page, found);
            }
            FrameItem::Text(run) => {
                found.push(Letter { page, size_pt: run.size.to_pt() * scale, text: run.text.to_string() })
            }
            FrameItem::Image(image, size, _) => {
                if let ImageKind::Svg(svg) = image.kind() {
                    let text = String::from_utf8_lossy(svg.data());
                    let scale = scale * (size.x.to_pt() / viewed(&text).0).min(size.y.to_pt() / viewed(&text).1);
                    found.extend(of_svg(&text).map(|(size, text)| Letter { page, size_pt: size * scale, text }));
                }
            }
            _ => {}
        }
    }
}

/// Returns width and height of the coordinates of an SVG.
fn viewed(svg: &str) -> (f64, f64) {
    let sizes = svg.split("viewBox=").nth(1).and_then(|rest| rest.split(['"', '\'']).nth(1)).unwrap_or_default();
    let mut sizes = sizes.split_whitespace().skip(2).filter_map(|size| size.parse().ok());
    (sizes.next().unwrap_or(f64::NAN), sizes.next().unwrap_or(f64::NAN))
}

/// Iterates over the sizes of letters that an SVG states, in its coordinates, each with the text that follows.
fn of_svg(svg: &str) -> impl Iterator<Item = (f64, String)> {
    svg.match_indices("font-size").filter_map(|(at, key)| {
        let rest = svg.get(at + key.len()..)?.trim_start_matches(['=', ':', '"', '\'', ' ']);
        let digits: String = rest.chars().take_while(|sign| sign.is_ascii_digit() || *sign == '.').collect();
        Some((digits.parse().ok()?, rest.chars().take(80).collect()))
    })
}
