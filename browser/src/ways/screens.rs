//! Appearance of the page: twelve states in both languages, compared with small reviewed screenshots.
//!
//! Small differences of font or smoothing are ignored; a block of the page that moved, vanished or changed its colour
//! is reported. With `ANTRIEB_RENEW_SCREENS` set the small screenshots are written anew. The large ones are always
//! written to `target/screens` for review.

use crate::stage::OpenPage;
use crate::tab::{Worded, expect, key};
use std::fs;
use std::path::{Path, PathBuf};

/// Width and height of a small screenshot.
const SMALL: (usize, usize) = (240, 150);

/// Side of a compared block, in small pixels.
const BLOCK: usize = 10;

/// Difference of the mean of a block's pixels above which the block differs, of 255.
const DIFFERS: f64 = 26.0;

/// Permitted share of differing blocks.
const SHARE: f64 = 0.06;

struct State {
    name: &'static str,
    /// Query that opens the state.
    at: &'static str,
    /// Elements clicked afterwards in order, and the element that appears at last.
    press: &'static [&'static str],
    there: &'static str,
    size: (u32, u32),
}

const WIDE: (u32, u32) = (1440, 900);
const PHONE: (u32, u32) = (390, 844);

const fn state(name: &'static str, at: &'static str, press: &'static [&'static str], there: &'static str) -> State {
    State { name, at, press, there, size: WIDE }
}

const STATES: [State; 12] = [
    state("start", "", &[], "#start-title"),
    state("begin", "", &[".tiles li:nth-child(4) .tile"], "#begin form"),
    state("screw", "new=screw", &[], "#plot-cycle"),
    state("checks", "new=belt", &["tbody[aria-current] button.fold"], "#checks"),
    state(
        "explained",
        "new=belt",
        &["tbody[aria-current] button.fold", "#check-peak_torque button.plain"],
        "#detail .formula",
    ),
    state("torque-speed", "new=turntable", &["#view-torque_speed"], "#plot-torque-speed"),
    state("heat-dark", "new=arm", &["#theme", "#view-heat"], "#plot-heat"),
    state("bearing", "new=arm", &["#view-bearing"], "#plot-bearing-load"),
    state("why-not", "new=belt", &["#list-rejected"], "table.rejected"),
    state("map", "new=belt", &["#list-map"], "#plot-map"),
    State { size: PHONE, ..state("phone", "new=arm", &[], "figure.sketch") },
    State { size: (1440, 1400), ..state("components", "gallery", &[], "#g-fields") },
];

/// Compares every state with its small screenshot.
pub(crate) fn as_they_were(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    let (small, large) = (folder("browser/screens"), folder("target/screens"));
    fs::create_dir_all(&large).map_err(|error| error.to_string())?;
    let renew = std::env::var_os("ANTRIEB_RENEW_SCREENS").is_some();
    let mut wrong = Vec::new();
    for language in ["en", "de"] {
        for state in &STATES {
            tab.sized(state.size.0, state.size.1, 1.0)?;
            if state.at == "gallery" {
                tab.open(&stage.shell.at(&format!("lang={language}")).replace("/?", "/gallery?"))?;
            } else if state.at.is_empty() {
                stage.start(language)?;
            } else {
                tab.open(&stage.shell.at(&format!("{}&lang={language}", state.at)))?;
                stage.ready()?;
            }
            for press in state.press {
                tab.click(press)?;
                settled(stage)?;
            }
            tab.there(state.there)?;
            if state.press.is_empty() && state.at.starts_with("new") && state.size == WIDE {
                tab.keys(&key::ESCAPE.to_string())?;
            }
            settled(stage)?;
            let name = format!("{}-{language}.png", state.name);
            let png = tab.picture()?;
            // The next state must not inherit the theme of this one.
            tab.run("localStorage.removeItem('antrieb-theme');", Vec::new())?;
            fs::write(large.join(&name), &png).map_err(|error| error.to_string())?;
            let seen = shrunk(&png)?;
            let path = small.join(&name);
            if renew {
                fs::create_dir_all(&small).map_err(|error| error.to_string())?;
                fs::write(&path, packed(&seen)?).map_err(|error| error.to_string())?;
                continue;
            }
            let kept =
                fs::read(&path).map_err(|error| format!("{}: {error}", path.display())).and_then(|png| shrunk(&png))?;
            let share = differing(&seen, &kept);
            if share > SHARE {
                wrong.push(format!("{name}: {:.0} % of the page differ", 100.0 * share));
            }
        }
    }
    expect(wrong.is_empty(), || wrong.join("; "))
}

/// Waits until no request is pending and the picture fills its pane.
fn settled(stage: &OpenPage<'_>) -> Worded {
    let quiet = "(() => { const figure = document.querySelector('#demands figure.plot'); const frame = figure?.querySelector('.frame'); \
        return !document.querySelector('.htmx-request') && (!frame || frame.clientWidth === 0 || Math.abs(frame.clientWidth - figure.dataset.width) < 8); })()";
    stage.tab.until(quiet)?;
    // The cards of the examples are filled one after the other.
    stage.tab.until("[...document.querySelectorAll('.card .small')].every((each) => each.textContent !== '')")?;
    std::thread::sleep(std::time::Duration::from_millis(250));
    stage.tab.until(quiet)
}

fn folder(below: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or_else(|| Path::new(".")).join(below)
}

/// A screenshot as the mean value of each small pixel and channel.
struct Small {
    pixels: Vec<[f64; 3]>,
}

fn shrunk(png: &[u8]) -> Worded<Small> {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(png));
    decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::STRIP_16);
    let mut reader = decoder.read_info().map_err(|error| error.to_string())?;
    let mut bytes = vec![0; reader.output_buffer_size().ok_or("a picture too large")?];
    let info = reader.next_frame(&mut bytes).map_err(|error| error.to_string())?;
    let channels = info.color_type.samples();
    let (wide, high) = (info.width as usize, info.height as usize);
    let mut pixels = Vec::with_capacity(SMALL.0 * SMALL.1);
    for row in 0..SMALL.1 {
        for column in 0..SMALL.0 {
            let span = |place: usize, of: usize, all: usize| {
                place * all / of..((place + 1) * all / of).max(place * all / of + 1)
            };
            let (mut sum, mut count) = ([0.0; 3], 0.0);
            for y in span(row, SMALL.1, high) {
                for x in span(column, SMALL.0, wide) {
                    let at = (y * wide + x) * channels;
                    for (channel, sum) in sum.iter_mut().enumerate() {
                        *sum += f64::from(bytes.get(at + channel.min(channels - 1)).copied().unwrap_or_default());
                    }
                    count += 1.0;
                }
            }
            pixels.push(sum.map(|sum| sum / count));
        }
    }
    Ok(Small { pixels })
}

fn packed(small: &Small) -> Worded<Vec<u8>> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, SMALL.0 as u32, SMALL.1 as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "means of bytes")]
    let bytes: Vec<u8> = small.pixels.iter().flatten().map(|value| value.round() as u8).collect();
    let mut writer = encoder.write_header().map_err(|error| error.to_string())?;
    writer.write_image_data(&bytes).map_err(|error| error.to_string())?;
    writer.finish().map_err(|error| error.to_string())?;
    Ok(out)
}

/// Returns the share of blocks whose means differ.
fn differing(a: &Small, b: &Small) -> f64 {
    let mean = |small: &Small, left: usize, top: usize| -> [f64; 3] {
        let mut sum = [0.0; 3];
        for row in top..top + BLOCK {
            for column in left..left + BLOCK {
                let pixel = small.pixels.get(row * SMALL.0 + column).copied().unwrap_or_default();
                for (sum, value) in sum.iter_mut().zip(pixel) {
                    *sum += value;
                }
            }
        }
        sum.map(|sum| sum / (BLOCK * BLOCK) as f64)
    };
    let (mut differ, mut all) = (0.0, 0.0);
    for top in (0..SMALL.1).step_by(BLOCK) {
        for left in (0..SMALL.0).step_by(BLOCK) {
            let (one, other) = (mean(a, left, top), mean(b, left, top));
            if one.iter().zip(other).any(|(one, other)| (one - other).abs() > DIFFERS) {
                differ += 1.0;
            }
            all += 1.0;
        }
    }
    differ / all
}
