//! A drawing within a page, or as a file of its own.

use std::fmt;
use std::path::Path;

use maud::{Markup, PreEscaped, html};

use super::palette::{Paint, Theme, style};

/// What was drawn, with what it shows in words.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// What is seen, for those who do not see it.
    pub description: String,
    /// Width and height of the view box.
    pub(super) size: (f64, f64),
    pub(super) body: Markup,
}

/// What a file of a picture holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Lines and words.
    Svg,
    /// Pixels.
    Png,
}

/// The paper of a picture that is a file of its own.
#[derive(Clone, Copy, Debug)]
pub struct Sheet {
    /// Width and height in pixels.
    pub pixels: (u32, u32),
    /// A file of pixels is light where this is [`Theme::Viewer`].
    pub theme: Theme,
}

impl Drawing {
    /// For a page of [`document`](crate::document::document), which has the style of drawings.
    #[must_use]
    pub fn inline(&self) -> Markup {
        let (width, height) = self.size;
        html! {
            svg viewBox=(format!("0 0 {width} {height}")) role="img" aria-label=(self.description) { (self.body) }
        }
    }

    /// The file as SVG, with its own style.
    #[must_use]
    pub fn svg(&self, sheet: &Sheet) -> String {
        let (width, height) = self.size;
        let (css, paper) = (style(sheet.theme), Paint::PAPER);
        let svg = html! {
            svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width=(sheet.pixels.0) height=(sheet.pixels.1)
                viewBox=(format!("0 0 {width} {height}")) font-family="system-ui,sans-serif" role="img" aria-label=(self.description) {
                style { (PreEscaped(css)) }
                rect.(paper.class()) width="100%" height="100%" fill=(paper.fill()) {}
                (self.body)
            }
        };
        svg.into_string() + "\n"
    }

    /// The file in a format.
    ///
    /// # Errors
    /// Where this build has no renderer for it, or that one fails.
    pub fn file(&self, format: Format, sheet: &Sheet) -> Result<Vec<u8>, NoFile> {
        match format {
            Format::Svg => Ok(self.svg(sheet).into_bytes()),
            Format::Png => self.png(sheet),
        }
    }

    #[cfg(feature = "png")]
    fn png(&self, sheet: &Sheet) -> Result<Vec<u8>, NoFile> {
        let theme = if sheet.theme == Theme::Viewer { Theme::Light } else { sheet.theme };
        super::raster::png(&self.svg(&Sheet { theme, ..*sheet }), sheet.pixels)
    }

    #[cfg(not(feature = "png"))]
    fn png(&self, _: &Sheet) -> Result<Vec<u8>, NoFile> {
        Err(NoFile::NotBuilt(Format::Png))
    }
}

/// Why there is no file of a drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoFile {
    /// The ending of the file's name is that of no format.
    Ending,
    /// This build has no renderer for the format.
    NotBuilt(Format),
    /// The renderer cannot draw it, and says why.
    Renderer(String),
}

impl fmt::Display for NoFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ending => f.write_str("the name of a picture tells its format: it ends in .svg or .png"),
            Self::NotBuilt(_) => f.write_str(
                "this build writes no PNG, whose renderer takes long to build; write SVG, or build it with the feature `png`",
            ),
            Self::Renderer(why) => write!(f, "the picture cannot be drawn as PNG: {why}"),
        }
    }
}

impl std::error::Error for NoFile {}

impl Format {
    /// By the ending of the file's name.
    ///
    /// # Errors
    /// Where the ending is that of no format, or of one that this build cannot write.
    pub fn of(path: &Path) -> Result<Self, NoFile> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("svg") => Ok(Format::Svg),
            Some("png") if cfg!(feature = "png") => Ok(Format::Png),
            Some("png") => Err(NoFile::NotBuilt(Format::Png)),
            _ => Err(NoFile::Ending),
        }
    }
}

impl Sheet {
    /// The view box of these proportions in which text is large enough on a telephone.
    #[must_use]
    pub fn view_box(&self) -> (f64, f64) {
        const WIDTH: f64 = 480.0;
        const LEAST_HEIGHT: f64 = 260.0;
        let (width, height) = (f64::from(self.pixels.0), f64::from(self.pixels.1));
        let scale = (WIDTH / width).max(LEAST_HEIGHT / height);
        (scale * width, scale * height)
    }
}
