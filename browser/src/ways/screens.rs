//! Appearance of the page: the states of the gallery in both languages, compared with reviewed screenshots of full size.
//!
//! A pixel of another smoothing is ignored; text or a line that moved, vanished or changed its colour is reported. With
//! `ANTRIEB_RENEW_SCREENS` set the screenshots are written anew. What was seen is always written to `target/screens` for review.

use crate::stage::OpenPage;
use crate::tab::{Worded, expect};
use page::{GalleryState, STATES};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

const WIDE: (u32, u32) = (1440, 900);
const PHONE: (u32, u32) = (375, 812);

/// Number of colours of a stored screenshot.
const COLOURS: usize = 48;

/// Difference in a channel above which a pixel differs, of 255; smoothing of letters by another version of the browser is below it.
const DIFFERS: u8 = 72;

/// Distance at which a pixel may have its counterpart.
const NEAR: usize = 1;

/// Permitted share of differing pixels.
const SHARE: f64 = 0.002;

/// Largest number of bytes of all stored screenshots.
const BYTES_MOST: usize = 4_000_000;

/// Opens a state of the gallery and waits until it is complete.
pub(crate) fn opened(stage: &OpenPage<'_>, state: &GalleryState, more: &str) -> Worded {
    let (width, height) = if state.is_narrow { PHONE } else { WIDE };
    stage.tab.sized(width, height, 1.0)?;
    stage.tab.open(&stage.shell.at(&format!("{}{more}", state.query)))?;
    stage.listens()?;
    if state.query.starts_with("new=") && !state.name.starts_with("fault") {
        stage.ready()?;
    }
    stage.tab.there(state.there)?;
    // No field has the focus, whose cursor blinks.
    stage.tab.run("document.activeElement?.blur();", Vec::new())?;
    settled(stage)
}

/// Compares every state with its screenshot.
pub(crate) fn as_they_were(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    let (kept, seen) = (folder("browser/screens"), folder("target/screens"));
    fs::create_dir_all(&seen).map_err(|error| error.to_string())?;
    let renew = std::env::var_os("ANTRIEB_RENEW_SCREENS").is_some();
    if renew {
        // Screenshots of states that are gone.
        let _ = fs::remove_dir_all(&kept);
        fs::create_dir_all(&kept).map_err(|error| error.to_string())?;
    }
    let mut wrong = Vec::new();
    let mut bytes = 0;
    for language in ["en", "de"] {
        for state in &STATES {
            opened(stage, state, &format!("&lang={language}"))?;
            let name = format!("{}-{language}.png", state.name);
            let png = tab.picture()?;
            fs::write(seen.join(&name), &png).map_err(|error| error.to_string())?;
            let now = Screen::read(&png)?;
            let path = kept.join(&name);
            if renew {
                fs::write(&path, now.packed()?).map_err(|error| error.to_string())?;
            }
            let stored = fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            bytes += stored.len();
            let share = now.differing(&Screen::read(&stored)?);
            if share > SHARE {
                wrong.push(format!("{name}: {:.2} % of the pixels differ", 100.0 * share));
            }
        }
    }
    expect(bytes <= BYTES_MOST, || format!("the screenshots have {bytes} bytes"))?;
    expect(wrong.is_empty(), || wrong.join("; "))
}

/// Waits until no request is pending and the picture fills its pane.
fn settled(stage: &OpenPage<'_>) -> Worded {
    let quiet = "(() => { const figure = document.querySelector('#demands figure.plot'); const frame = figure?.querySelector('.frame'); \
        return !document.querySelector('.htmx-request') && document.fonts.status === 'loaded' \
        && (!frame || frame.clientWidth === 0 || Math.abs(frame.clientWidth - figure.dataset.width) < 8); })()";
    stage.tab.until(quiet)?;
    // The cards of the examples are filled one after the other.
    stage.tab.until("[...document.querySelectorAll('.card .small')].every((each) => each.textContent !== '')")?;
    std::thread::sleep(std::time::Duration::from_millis(250));
    stage.tab.until(quiet)
}

fn folder(below: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or_else(|| Path::new(".")).join(below)
}

type Pixel = [u8; 3];

/// A screenshot as its pixels, row by row.
struct Screen {
    width: usize,
    height: usize,
    pixels: Vec<Pixel>,
}

/// Returns the largest difference in a channel.
fn distance(a: Pixel, b: Pixel) -> u8 {
    a.iter().zip(b).map(|(a, b)| a.abs_diff(b)).max().unwrap_or_default()
}

impl Screen {
    fn read(png: &[u8]) -> Worded<Self> {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(png));
        decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::STRIP_16);
        let mut reader = decoder.read_info().map_err(|error| error.to_string())?;
        let mut bytes = vec![0; reader.output_buffer_size().ok_or("a picture too large")?];
        let info = reader.next_frame(&mut bytes).map_err(|error| error.to_string())?;
        let channels = info.color_type.samples();
        let pixel =
            |at: &[u8]| [0, 1, 2].map(|channel: usize| at.get(channel.min(channels - 1)).copied().unwrap_or_default());
        let pixels = bytes.chunks_exact(channels).map(pixel).collect();
        Ok(Self { width: info.width as usize, height: info.height as usize, pixels })
    }

    /// Returns the colours that stand for all: each next one is that with the largest product of pixels and squared distance to the
    /// nearest one before it, so that a rare signal colour is kept beside the greys of smoothed letters.
    fn palette(&self) -> Vec<Pixel> {
        let mut counts: BTreeMap<Pixel, (u64, Pixel)> = BTreeMap::new();
        for pixel in &self.pixels {
            let (count, _) = counts.entry(pixel.map(|channel| channel >> 3)).or_insert((0, *pixel));
            *count += 1;
        }
        let mut open: Vec<(u64, Pixel, u64)> =
            counts.into_values().map(|(count, pixel)| (count, pixel, u64::MAX)).collect();
        let mut found = Vec::new();
        while found.len() < COLOURS {
            let weight = |(count, _, distance): &(u64, Pixel, u64)| u128::from(*count) * u128::from(*distance);
            let Some((_, next, _)) = open.iter().max_by_key(|each| weight(each)).filter(|each| each.2 > 0).copied()
            else {
                break;
            };
            found.push(next);
            for (_, pixel, nearest) in &mut open {
                *nearest = (*nearest).min(u64::from(distance(*pixel, next)).pow(2));
            }
        }
        found
    }

    /// Returns the screenshot with few colours as PNG.
    fn packed(&self) -> Worded<Vec<u8>> {
        let palette = self.palette();
        let mut known: BTreeMap<Pixel, u8> = BTreeMap::new();
        let mut nearest = |pixel: Pixel| {
            *known.entry(pixel).or_insert_with(|| {
                let best = palette.iter().enumerate().min_by_key(|(_, colour)| distance(pixel, **colour));
                best.and_then(|(place, _)| u8::try_from(place).ok()).unwrap_or_default()
            })
        };
        let indices: Vec<u8> = self.pixels.iter().map(|pixel| nearest(*pixel)).collect();
        let mut out = Vec::new();
        let mut encoder = png::Encoder::new(&mut out, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_palette(palette.concat());
        encoder.set_compression(png::Compression::High);
        encoder.set_filter(png::Filter::NoFilter);
        let mut writer = encoder.write_header().map_err(|error| error.to_string())?;
        writer.write_image_data(&indices).map_err(|error| error.to_string())?;
        writer.finish().map_err(|error| error.to_string())?;
        Ok(out)
    }

    /// Returns the share of pixels without a counterpart in the other screenshot; one of another size differs as a whole.
    fn differing(&self, other: &Self) -> f64 {
        if (self.width, self.height) != (other.width, other.height) {
            return 1.0;
        }
        let at =
            |screen: &Self, x: usize, y: usize| screen.pixels.get(y * screen.width + x).copied().unwrap_or_default();
        let has = |screen: &Self, pixel: Pixel, x: usize, y: usize| {
            let rows = y.saturating_sub(NEAR)..=(y + NEAR).min(screen.height - 1);
            rows.into_iter().any(|y| {
                let columns = x.saturating_sub(NEAR)..=(x + NEAR).min(screen.width - 1);
                columns.into_iter().any(|x| distance(at(screen, x, y), pixel) <= DIFFERS)
            })
        };
        let is_other = |place: usize| {
            let (x, y) = (place % self.width, place / self.width);
            let (a, b) = (at(self, x, y), at(other, x, y));
            distance(a, b) > DIFFERS && !(has(other, a, x, y) && has(self, b, x, y))
        };
        (0..self.pixels.len()).filter(|place| is_other(*place)).count() as f64 / self.pixels.len().max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns a white screen with a black bar at a column.
    fn bar(column: usize) -> Screen {
        let pixels =
            (0..100 * 50).map(|place| if (column..column + 3).contains(&(place % 100)) { [0; 3] } else { [255; 3] });
        Screen { width: 100, height: 50, pixels: pixels.collect() }
    }

    #[test]
    fn a_pixel_of_smoothing_is_no_difference_and_a_moved_bar_is_one() {
        assert_eq!(bar(10).differing(&bar(10)), 0.0);
        assert_eq!(bar(10).differing(&bar(11)), 0.0);
        assert!(bar(10).differing(&bar(16)) > SHARE);
        let stored = Screen::read(&bar(10).packed().unwrap_or_default());
        assert_eq!(stored.map(|stored| stored.differing(&bar(10))).ok(), Some(0.0));
    }
}
