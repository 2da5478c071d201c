//! A drawing within a page, or as a file of its own.

use std::path::Path;

use maud::{Markup, PreEscaped, html};

use super::palette::{Paint, Theme, style};
use crate::printing::Refusal;

/// What was drawn, with what it shows in words.
#[derive(Clone, Debug)]
pub(crate) struct Drawing {
    /// What is seen, for those who do not see it.
    pub(crate) description: String,
    /// Width and height of the view box.
    pub(super) size: (f64, f64),
    pub(super) body: Markup,
}

/// What a file of a picture holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// Lines and words.
    Svg,
    /// Pixels.
    Png,
}

/// The paper of a picture that is a file of its own.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sheet {
    /// Width and height in pixels.
    pub(crate) pixels: (u32, u32),
    /// A file of pixels is light where this is [`Theme::Viewer`].
    pub(crate) theme: Theme,
}

impl Drawing {
    /// For a page that has the [`style`] of drawings.
    pub(crate) fn inline(&self) -> Markup {
        let (width, height) = self.size;
        html! {
            svg viewBox=(format!("0 0 {width} {height}")) role="img" aria-label=(self.description) { (self.body) }
        }
    }

    /// The file as SVG, with its own style.
    pub(crate) fn svg(&self, sheet: &Sheet) -> String {
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
    pub(crate) fn file(&self, format: Format, sheet: &Sheet) -> Result<Vec<u8>, Refusal> {
        match format {
            Format::Svg => Ok(self.svg(sheet).into_bytes()),
            Format::Png => self.png(sheet),
        }
    }

    #[cfg(feature = "png")]
    fn png(&self, sheet: &Sheet) -> Result<Vec<u8>, Refusal> {
        let theme = if sheet.theme == Theme::Viewer { Theme::Light } else { sheet.theme };
        super::raster::png(&self.svg(&Sheet { theme, ..*sheet }), sheet.pixels)
    }

    #[cfg(not(feature = "png"))]
    fn png(&self, _: &Sheet) -> Result<Vec<u8>, Refusal> {
        Err(Refusal::new(NO_PNG))
    }
}

/// Why there is no file of pixels, and what to do.
const NO_PNG: &str = "--out: this build of the command writes no PNG, whose renderer takes long to build; name a file that ends in \
                      .svg, or build it with `cargo build --release -p kahan-cli --features png`";

impl Format {
    /// By the ending of the file's name; what this build cannot write is refused.
    pub(crate) fn of(path: &Path) -> Result<Self, Refusal> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("svg") => Ok(Format::Svg),
            Some("png") if cfg!(feature = "png") => Ok(Format::Png),
            Some("png") => Err(Refusal::new(NO_PNG)),
            _ => Err(Refusal::new(format!(
                "--out: the name of the file, {}, tells its format: it ends in .svg or .png",
                path.display()
            ))),
        }
    }
}

impl Sheet {
    /// The view box of these proportions in which text is large enough on a telephone.
    pub(crate) fn view_box(&self) -> (f64, f64) {
        const WIDTH: f64 = 480.0;
        const LEAST_HEIGHT: f64 = 260.0;
        let (width, height) = (f64::from(self.pixels.0), f64::from(self.pixels.1));
        let scale = (WIDTH / width).max(LEAST_HEIGHT / height);
        (scale * width, scale * height)
    }
}
