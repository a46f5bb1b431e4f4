//! Style and scripts. The third-party script is listed with version and licence in THIRD-PARTY.md.

use crate::call::Reply;

macro_rules! files {
    ($($name:literal)*) => { [$(($name, include_str!(concat!("../assets/", $name)))),*] };
}

/// Files of the page by their names below `/assets/`.
pub const ASSETS: [(&str, &str); 18] = files![
    "page.css" "enter.js" "page.js" "panes.js" "cursor.js" "across.js" "table.js" "runs.js" "plots.js" "sketch.js" "theory.js" "print.js" "waiting.js" "folder.js" "tools.js" "door.js" "begin.js"
    "htmx.min.js"
];

/// Typefaces of the page, those of report and pictures, by the names of their files below `/assets/`: one for text, one for formulas. The engine
/// in the browser does not hold them: there they are files beside the engine.
#[cfg(not(target_arch = "wasm32"))]
pub const FONTS: [(&str, &[u8]); 4] = [
    ("inter-regular.ttf", include_bytes!("../../plot/fonts/Inter-Regular.ttf")),
    ("inter-italic.ttf", include_bytes!("../../plot/fonts/Inter-Italic.ttf")),
    ("inter-semibold.ttf", include_bytes!("../../plot/fonts/Inter-SemiBold.ttf")),
    ("antrieb-math.woff2", include_bytes!("../fonts/antrieb-math.woff2")),
];

/// Returns a file of the page.
pub(crate) fn asset(name: &str) -> Reply {
    #[cfg(not(target_arch = "wasm32"))]
    if let Some((_, font)) = FONTS.iter().find(|(of, _)| *of == name) {
        let media = if name.ends_with(".woff2") { "font/woff2" } else { "font/ttf" };
        return Reply::of(200, media, *font);
    }
    let Some((_, text)) = ASSETS.iter().find(|(of, _)| *of == name) else { return Reply::text(404, "") };
    let media = if name.ends_with(".css") { "text/css; charset=utf-8" } else { "text/javascript; charset=utf-8" };
    Reply::of(200, media, without_comments(name, text))
}

/// Returns a style or script of the page without its lines of comments, which are for those who read the source.
fn without_comments(name: &str, text: &str) -> String {
    if name.ends_with(".min.js") {
        return text.to_owned();
    }
    let is_comment = |line: &str| {
        let line = line.trim();
        if name.ends_with(".css") {
            line.starts_with("/*") && line.find("*/") == Some(line.len() - 2)
        } else {
            line.starts_with("//")
        }
    };
    text.lines().filter(|line| !is_comment(line)).flat_map(|line| [line, "\n"]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares the third-party script with the published htmx 4.0.1 (`dist/htmx.min.js`), byte by byte.
    #[test]
    fn the_script_of_others_is_as_it_was_published() {
        let sum = blake3::hash(&asset("htmx.min.js").body).to_hex();
        assert_eq!(sum.as_str(), "2b78dc2b44f6117680c5863fb5dd9a261c2a769feace82c358a295fe735c83e4");
    }

    #[test]
    fn every_file_is_there() {
        assert!(ASSETS.iter().all(|(name, _)| asset(name).status == 200));
        let style = asset("page.css");
        let style = String::from_utf8_lossy(&style.body);
        for (name, _) in FONTS {
            let ending = name.rsplit_once('.').map_or(name, |(_, ending)| ending);
            assert_eq!((asset(name).status, asset(name).media), (200, format!("font/{ending}").as_str()));
            assert!(style.contains(&format!("url(\"{name}\")")), "{name}");
        }
    }

    /// Only whole lines of comments are left out.
    #[test]
    fn comments_stay_in_the_source() {
        let script = "// A.\nconst a = 'x'; // B\n  // C.\nb('//');\n";
        assert_eq!(without_comments("a.js", script), "const a = 'x'; // B\nb('//');\n");
        let style = "/* A. */\na { b: c; } /* B */\n/* C. */ d { e: f; } /* G */\n";
        assert_eq!(without_comments("a.css", style), "a { b: c; } /* B */\n/* C. */ d { e: f; } /* G */\n");
        for (name, text) in ASSETS {
            let (sent, written) = (asset(name).body.len(), text.len());
            assert!(sent <= written && 2 * sent > written, "{name}");
        }
    }

    /// Limits the compressed size of the scripts, for slow connections.
    #[test]
    fn the_page_stays_light() {
        let packed = |file: &str| {
            let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
            std::io::Write::write_all(&mut packer, file.as_bytes())
                .and_then(|()| packer.finish())
                .map_or(0, |bytes| bytes.len())
        };
        let scripts = ASSETS.iter().filter(|(name, _)| name.ends_with(".js"));
        let weight: usize = scripts.map(|(_, text)| packed(text)).sum();
        assert!((20_000..60_000).contains(&weight), "{weight}");
    }
}
