//! Makes PNG and PDF files from SVG. An embedded font makes files equal on every machine.

use std::sync::Arc;

use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};

use super::DrawingFileError;

/// The part of DejaVu Sans that names and numbers need.
const FONT: &[u8] = include_bytes!("DejaVuSans.ttf");

fn read(svg: &str) -> Result<Tree, DrawingFileError> {
    let mut fonts = Database::new();
    fonts.load_font_data(FONT.to_vec());
    fonts.set_sans_serif_family("DejaVu Sans");
    let options =
        Options { font_family: "DejaVu Sans".to_owned(), fontdb: Arc::new(fonts), ..Options::default() };
    Tree::from_str(svg, &options).map_err(|error| DrawingFileError::Renderer(error.to_string()))
}

#[cfg(feature = "png")]
pub(super) fn png(svg: &str, (width, height): (u32, u32)) -> Result<Vec<u8>, DrawingFileError> {
    use resvg::tiny_skia::{Pixmap, Transform};

    let tree = read(svg)?;
    let failed = |why: &dyn ToString| DrawingFileError::Renderer(why.to_string());
    let mut pixels =
        Pixmap::new(width, height).ok_or_else(|| failed(&format!("{width}x{height} is no size")))?;
    let scale = |pixels: u32, units: f32| pixels as f32 / units;
    let transform =
        Transform::from_scale(scale(width, tree.size().width()), scale(height, tree.size().height()));
    resvg::render(&tree, transform, &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| failed(&error))
}

/// Renders a PDF page whose text can be searched.
#[cfg(feature = "pdf")]
pub(super) fn pdf(svg: &str) -> Result<Vec<u8>, DrawingFileError> {
    use krilla::{Document, geom::Size, page::PageSettings};
    use krilla_svg::{SurfaceExt, SvgSettings};

    /// The number of points (1/72 inch) in a CSS pixel (1/96 inch).
    const POINTS_PER_PIXEL: f32 = 0.75;

    let tree = read(svg)?;
    let (width, height) = (POINTS_PER_PIXEL * tree.size().width(), POINTS_PER_PIXEL * tree.size().height());
    let size = Size::from_wh(width, height).zip(PageSettings::from_wh(width, height));
    let (size, page) =
        size.ok_or_else(|| DrawingFileError::Renderer(format!("{width}x{height} is no size")))?;
    let mut document = Document::new();
    let mut page = document.start_page_with(page);
    let mut surface = page.surface();
    surface.draw_svg(&tree, size, SvgSettings::default());
    surface.finish();
    page.finish();
    document.finish().map_err(|error| DrawingFileError::Renderer(format!("{error:?}")))
}

#[cfg(test)]
mod tests {
    use super::super::{Canvas, Drawing, Mark, Plot, Series, Theme};

    fn drawing(pixels: (u32, u32), theme: Theme) -> Drawing {
        let line = Series::new("xₙ", 1, Mark::Line, vec![(0.0, 0.0), (1.0, 1.0)]);
        let plot = Plot::around("a line", ["ε", "x"], vec![line]);
        Plot { sheet: Canvas::new(pixels, theme), ..plot }.drawing()
    }

    #[cfg(feature = "png")]
    #[test]
    fn pixels_have_the_size_and_the_colours_that_were_asked_for() {
        use resvg::tiny_skia::Pixmap;

        for (theme, paper, curve) in [
            (Theme::Viewer, (0xfd, 0xfc, 0xf9), (0x43, 0x5b, 0xc6)),
            (Theme::Dark, (0x14, 0x17, 0x1b), (0x2d, 0x8b, 0xb9)),
            (Theme::Paper, (0xff, 0xff, 0xff), (0x43, 0x5b, 0xc6)),
        ] {
            let png = drawing((900, 600), theme).file(super::super::Format::Png).expect("a picture");
            let pixels = Pixmap::decode_png(&png).expect("a PNG");
            assert_eq!((pixels.width(), pixels.height()), (900, 600));
            let colours: Vec<(u8, u8, u8)> =
                pixels.pixels().iter().map(|pixel| (pixel.red(), pixel.green(), pixel.blue())).collect();
            assert_eq!(colours[0], paper);
            assert!(colours.iter().filter(|colour| **colour == curve).count() > 400, "the line");
            // Left of the vertical axis, only letters differ from the paper.
            let margin = colours.chunks(900).flat_map(|row| &row[..105]).filter(|colour| **colour != paper);
            assert!(margin.count() > 100, "letters");
        }
    }

    #[cfg(feature = "pdf")]
    #[test]
    fn a_page_for_print_has_the_size_of_a_column_and_a_font_within() {
        let file = drawing(Canvas::COLUMN, Theme::Paper).file(super::super::Format::Pdf).expect("a page");
        let text = String::from_utf8_lossy(&file);
        assert!(text.starts_with("%PDF-") && text.contains("MediaBox[0 0 243.8"));
        assert!(text.contains("DejaVuSans") && text.contains("/FontFile"));
    }
}
