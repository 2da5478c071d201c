//! A drawing within a page, or as a file.

use std::fmt;
use std::path::Path;

use maud::{Markup, PreEscaped, html};

use super::palette::{Paint, Theme, style};

/// A finished drawing with its description.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// The description for screen readers.
    pub description: String,
    pub(super) sheet: Canvas,
    pub(super) body: Markup,
}

/// A file format of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Vector graphics.
    Svg,
    /// Pixels.
    Png,
    /// Vector graphics on a page for print.
    Pdf,
}

/// The size and colours of a drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Canvas {
    pixels: (u32, u32),
    pub(super) view_box: (f64, f64),
    /// The colours. PNG and PDF files of [`Theme::Viewer`] are light.
    pub theme: Theme,
}

impl Drawing {
    /// Returns the SVG for a [`document`](crate::document::document), which supplies the style
    /// sheet.
    #[must_use]
    pub fn inline(&self) -> Markup {
        let (width, height) = self.sheet.view_box;
        html! {
            svg viewBox=(format!("0 0 {width} {height}")) role="img" aria-label=(self.description) { (self.body) }
        }
    }

    /// Returns an SVG file that contains its own style sheet.
    #[must_use]
    pub fn svg(&self) -> String {
        let Canvas { view_box: (width, height), theme, .. } = self.sheet;
        let (css, paper) = (style(theme), Paint::PAPER);
        let [across, upwards] = self.sheet.lengths();
        // On paper, the fonts are those that printers have, or replace by fonts of equal widths.
        let fonts =
            if theme == Theme::Paper { "Helvetica, Arial, sans-serif" } else { "system-ui,sans-serif" };
        let svg = html! {
            svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width=(across) height=(upwards)
                viewBox=(format!("0 0 {width} {height}")) font-family=(fonts) role="img" aria-label=(self.description) {
                @if !css.is_empty() { style { (PreEscaped(css)) } }
                rect.(paper.class()) width="100%" height="100%" fill=(paper.fill(theme)) {}
                @if theme == Theme::Paper { g stroke-width=(theme.line(1.0)) { (self.body) } } @else { (self.body) }
            }
        };
        svg.into_string() + "\n"
    }

    /// Renders a file. Fails if this build cannot write the format, or if the renderer fails.
    pub fn file(&self, format: Format) -> Result<Vec<u8>, DrawingFileError> {
        match format {
            Format::Svg => Ok(self.svg().into_bytes()),
            #[cfg(feature = "png")]
            Format::Png => super::render::png(&self.svg(), self.sheet.pixels),
            #[cfg(feature = "pdf")]
            Format::Pdf => super::render::pdf(&self.svg()),
            #[cfg(not(all(feature = "png", feature = "pdf")))]
            other => Err(DrawingFileError::NotBuilt(other)),
        }
    }
}

/// The reason why a drawing cannot become a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DrawingFileError {
    /// No format has the extension of the file name.
    Ending,
    /// This build has no renderer for the format.
    NotBuilt(Format),
    /// The renderer failed with this message.
    Renderer(String),
}

impl fmt::Display for DrawingFileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ending => {
                f.write_str("the name of a picture tells its format: it ends in .svg, .png or .pdf")
            }
            Self::NotBuilt(format) => write!(
                f,
                "this build writes no {format}, whose renderer takes long to build; write SVG, or build it with the feature `{}`",
                format.feature()
            ),
            Self::Renderer(why) => write!(f, "the picture cannot be rendered: {why}"),
        }
    }
}

impl std::error::Error for DrawingFileError {}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Format::Svg => "SVG",
            Format::Png => "PNG",
            Format::Pdf => "PDF",
        })
    }
}

impl Format {
    /// Returns the format for the extension of a file. Fails if no format has this extension, or if
    /// this build cannot write the format.
    pub fn of(path: &Path) -> Result<Self, DrawingFileError> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        let format = [Format::Svg, Format::Png, Format::Pdf];
        let format = format.into_iter().find(|format| ending.as_deref() == Some(format.feature()));
        match format.ok_or(DrawingFileError::Ending)? {
            Format::Png if !cfg!(feature = "png") => Err(DrawingFileError::NotBuilt(Format::Png)),
            Format::Pdf if !cfg!(feature = "pdf") => Err(DrawingFileError::NotBuilt(Format::Pdf)),
            format => Ok(format),
        }
    }

    /// Returns the file extension. The crate feature for the format has the same name.
    #[must_use]
    pub fn feature(self) -> &'static str {
        match self {
            Format::Svg => "svg",
            Format::Png => "png",
            Format::Pdf => "pdf",
        }
    }
}

impl Canvas {
    const PIXELS_PER_INCH: f64 = 300.0;
    /// The width and height in pixels of a picture that fills a printed column of 86 mm.
    pub const COLUMN: (u32, u32) = (1016, 762);

    /// Makes the canvas of a file. For screens, the text is large enough to be read on telephones.
    /// For print, 300 pixels are one inch.
    #[must_use]
    pub fn new(pixels: (u32, u32), theme: Theme) -> Self {
        let (width, height) = (f64::from(pixels.0), f64::from(pixels.1));
        let (scale, least) = match theme {
            Theme::Paper => (100.0 / Canvas::PIXELS_PER_INCH, (240.0, 180.0)),
            _ => (480.0 / width, (480.0, 260.0)),
        };
        let scale = scale.max(least.0 / width).max(least.1 / height);
        Canvas { pixels, view_box: (scale * width, scale * height), theme }
    }

    /// Makes the canvas of a drawing within a page. Each unit of its view box is one pixel.
    #[must_use]
    pub fn page(width: u32, height: u32) -> Self {
        Canvas {
            pixels: (width, height),
            view_box: (f64::from(width), f64::from(height)),
            theme: Theme::Viewer,
        }
    }

    /// Returns the width and height of an SVG file, in millimetres for print and else in pixels.
    fn lengths(&self) -> [String; 2] {
        const MILLIMETRES_PER_INCH: f64 = 25.4;
        [self.pixels.0, self.pixels.1].map(|pixels| match self.theme {
            Theme::Paper => {
                format!("{:.2}mm", f64::from(pixels) / Canvas::PIXELS_PER_INCH * MILLIMETRES_PER_INCH)
            }
            _ => pixels.to_string(),
        })
    }
}
