//! Pictures as pixels, from the SVG text.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};

use crate::font::{FONT_FAMILY, font_files};
use crate::picture::Picture;

impl Picture {
    /// Largest number of pixels of a picture: four bytes each, and the same again while the file is written.
    pub const PIXELS_MAX: u64 = 48_000_000;

    /// Returns the picture as a PNG file with `scale` pixels per CSS pixel (2 is about 190 dpi).
    ///
    /// Draws with the fonts of the crate only. `None` if the picture has more than [`Self::PIXELS_MAX`] pixels or the
    /// scale is not positive. CSS variables are not resolved: use a light or dark theme.
    #[must_use]
    pub fn png(&self, scale: f64) -> Option<Vec<u8>> {
        let mut fonts = Database::new();
        for bytes in font_files() {
            fonts.load_font_data(bytes.to_vec());
        }
        let options = Options { fontdb: Arc::new(fonts), font_family: FONT_FAMILY.to_owned(), ..Options::default() };
        let tree = Tree::from_str(&self.svg, &options).ok()?;
        let (width, height) = (side(self.width * scale)?, side(self.height * scale)?);
        if u64::from(width) * u64::from(height) > Self::PIXELS_MAX {
            return None;
        }
        let mut pixels = Pixmap::new(width, height)?;
        // Scaled to whole pixels: a partial one at an edge would be visible as a line.
        #[expect(clippy::cast_precision_loss, reason = "a side has few digits")]
        let (x, y) = (width as f32 / tree.size().width(), height as f32 / tree.size().height());
        resvg::render(&tree, Transform::from_scale(x, y), &mut pixels.as_mut());
        pixels.encode_png().ok()
    }
}

/// Longest side of a picture in pixels.
const SIDE_MAX: f64 = 16_000.0;

fn side(pixels: f64) -> Option<u32> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the bounds just asked for")]
    (1.0..=SIDE_MAX).contains(&pixels).then_some(pixels.ceil() as u32)
}
