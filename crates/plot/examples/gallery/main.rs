//! Writes one picture of each kind, theme and language into a folder: `cargo run -p plot --example gallery -- FOLDER`.
//! With the feature `png` as pixels too.

#![allow(clippy::print_stdout, reason = "an example tells what it wrote")]

mod sample;

use std::path::Path;

use plot::{Picture, Size, Style, Theme};
use quantities::Language;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("a folder is missing")?;
    let folder = Path::new(&folder);
    std::fs::create_dir_all(folder)?;
    for (theme, theme_name) in [(Theme::Light, "light"), (Theme::Dark, "dark"), (Theme::Css, "css")] {
        for (language, language_name) in [(Language::De, "de"), (Language::En, "en")] {
            for (name, size, draw) in sample::ALL {
                let size = Size::millimetres(size.0, size.1);
                let picture = draw(language, &Style::new(size).theme(theme).language(language).id(name));
                let stem = format!("{name}-{theme_name}-{language_name}");
                std::fs::write(folder.join(format!("{stem}.svg")), picture.svg())?;
                println!("{stem}: {} kB, hidden labels: {}", picture.svg().len() / 1024, picture.hidden_labels().len());
                if theme != Theme::Css {
                    pixels(&picture, &folder.join(format!("{stem}.png")))?;
                }
            }
        }
    }
    Ok(())
}

#[cfg(feature = "png")]
fn pixels(picture: &Picture, path: &Path) -> Result<(), Box<dyn std::error::Error>> {
    std::fs::write(path, picture.png(2.0).ok_or("no pixels")?)?;
    Ok(())
}

#[cfg(not(feature = "png"))]
#[expect(clippy::unnecessary_wraps, reason = "the same signature as with pixels")]
fn pixels(_: &Picture, _: &Path) -> Result<(), Box<dyn std::error::Error>> {
    Ok(())
}
