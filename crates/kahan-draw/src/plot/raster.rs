//! A drawing as pixels: the SVG of the same drawing, rendered.
//!
//! Letters come from a font of our own, so that a picture is the same on every machine, also where
//! there are no fonts.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};

use super::NoFile;

/// The part of DejaVu Sans that names and numbers need.
const FONT: &[u8] = include_bytes!("DejaVuSans.ttf");

/// The PNG of a drawing that fills so many pixels.
pub(super) fn png(svg: &str, (width, height): (u32, u32)) -> Result<Vec<u8>, NoFile> {
    let mut fonts = Database::new();
    fonts.load_font_data(FONT.to_vec());
    fonts.set_sans_serif_family("DejaVu Sans");
    let options =
        Options { font_family: "DejaVu Sans".to_owned(), fontdb: Arc::new(fonts), ..Options::default() };
    let tree = Tree::from_str(svg, &options).map_err(|error| NoFile::Renderer(error.to_string()))?;
    let mut pixels =
        Pixmap::new(width, height).ok_or_else(|| NoFile::Renderer(format!("{width}x{height} is no size")))?;
    let scale = |pixels: u32, units: f32| pixels as f32 / units;
    let transform =
        Transform::from_scale(scale(width, tree.size().width()), scale(height, tree.size().height()));
    resvg::render(&tree, transform, &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| NoFile::Renderer(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::super::{Mark, Plot, Series, Sheet, Theme};
    use resvg::tiny_skia::Pixmap;

    #[test]
    fn pixels_have_the_size_and_the_colours_that_were_asked_for() {
        let line = Series::new("xₙ", 1, Mark::Line, vec![(0.0, 0.0), (1.0, 1.0)]);
        let plot = Plot::around("a line", ["ε", "x"], vec![line]);
        for (theme, paper, curve) in [
            (Theme::Light, (0xfd, 0xfc, 0xf9), (0x1f, 0x76, 0xbf)),
            (Theme::Dark, (0x14, 0x17, 0x1b), (0x2d, 0x8c, 0xb5)),
        ] {
            let sheet = Sheet { pixels: (600, 400), theme };
            let png = plot.drawing().file(super::super::Format::Png, &sheet).expect("a picture");
            let pixels = Pixmap::decode_png(&png).expect("a PNG");
            assert_eq!((pixels.width(), pixels.height()), (600, 400));
            let colours: Vec<(u8, u8, u8)> =
                pixels.pixels().iter().map(|pixel| (pixel.red(), pixel.green(), pixel.blue())).collect();
            assert_eq!(colours[0], paper);
            assert!(colours.iter().filter(|colour| **colour == curve).count() > 400, "the line");
            // Left of the axis stand letters only.
            let margin = colours.chunks(600).flat_map(|row| &row[..70]).filter(|colour| **colour != paper);
            assert!(margin.count() > 100, "letters");
        }
    }
}
