//! The options for the look of a picture, which several commands share.

use std::path::Path;

use clap::Args;
use kahan_draw::{Canvas, Drawing, DrawingFileError, Format, Theme};
use serde_json::json;

use super::command_line::CommandLine;
use crate::printing::{OutputStream, UsageError, is_table};
use crate::reading::one_of;

const SCREEN_THEMES: [Theme; 3] = [Theme::Viewer, Theme::Light, Theme::Dark];

fn screen(theme: Theme) -> &'static str {
    match theme {
        Theme::Light => "light",
        Theme::Dark => "dark",
        Theme::Viewer | Theme::Paper => "viewer",
    }
}

/// The size, theme and paper of a picture.
#[derive(Args, Clone, Debug, Default, PartialEq)]
pub(crate) struct ImageOptions {
    /// Width and height in pixels; with --paper, 300 pixels are an inch.
    #[arg(long, value_name = "WxH", value_parser = pixels)]
    size: Option<(u32, u32)>,

    /// light, dark, or viewer (follows the viewer's setting).
    #[arg(long, value_parser = one_of(&SCREEN_THEMES, |theme| screen(theme).into()), default_value = "viewer", hide_possible_values = true)]
    theme: Theme,

    /// Draw for print: thin black lines on white, one text column wide.
    #[arg(long, conflicts_with = "theme")]
    paper: bool,
}

/// Parses WIDTHxHEIGHT. Fails if one side is more than four times the other.
fn pixels(text: &str) -> Result<(u32, u32), String> {
    let sides = text.split_once(['x', 'X', '×']);
    let side = |text: &str| text.trim().parse().ok().filter(|side| (16..=8192).contains(side));
    let size: Option<(u32, u32)> = sides.and_then(|(width, height)| Some((side(width)?, side(height)?)));
    size.filter(|(width, height)| width.max(height) <= &(4 * width.min(height))).ok_or_else(|| {
        "write WIDTHxHEIGHT in pixels, as 960x720: each from 16 to 8192, the one at most four times the other".to_owned()
    })
}

impl ImageOptions {
    /// Appends the options that produce this canvas.
    pub(super) fn options(&self, line: CommandLine) -> CommandLine {
        let size = self.size.map(|(width, height)| format!("{width}x{height}"));
        let said = json!({ "size": size, "theme": screen(self.theme), "paper": self.paper });
        line.with_changed_options::<Self>(&said)
    }

    /// Returns the canvas. By default it is as large as `usual`, or with --paper as a text column.
    pub(super) fn sheet(&self, mut usual: Canvas) -> Canvas {
        let theme = if self.paper { Theme::Paper } else { self.theme };
        match self.size {
            None if self.paper => Canvas::new(Canvas::COLUMN, theme),
            None => {
                usual.theme = theme;
                usual
            }
            Some(pixels) => Canvas::new(pixels, theme),
        }
    }
}

pub(super) fn usual() -> Canvas {
    Canvas::new((960, 720), Theme::Viewer)
}

pub(super) struct OutFile {
    sink: OutputStream,
    format: Option<Format>,
}

impl OutFile {
    pub(super) fn picture(path: &Path) -> Result<Self, UsageError> {
        let format = Some(format(path)?);
        Ok(OutFile { sink: OutputStream::file(path, "--out")?, format })
    }

    /// Opens a file for a table or a picture, according to the file's extension.
    pub(super) fn picture_or_table(path: &Path) -> Result<Self, UsageError> {
        if is_table(path) {
            return Ok(OutFile { sink: OutputStream::file(path, "--out")?, format: None });
        }
        Self::picture(path)
    }

    /// Writes the picture or the table. Returns the number of bytes.
    pub(super) fn put(self, drawing: &Drawing, table: impl FnOnce() -> String) -> Result<usize, UsageError> {
        let file = match self.format {
            Some(format) => drawing.file(format).map_err(|why| UsageError::new(format!("--out: {why}")))?,
            None => table().into_bytes(),
        };
        let bytes = file.len();
        self.sink.put(file)?;
        Ok(bytes)
    }
}

/// Returns the format of a picture. Fails if this build cannot write it.
fn format(out: &Path) -> Result<Format, UsageError> {
    Format::of(out).map_err(|why| match why {
        DrawingFileError::NotBuilt(format) => UsageError::new(format!(
            "--out: this build of the command writes no {format}, whose renderer takes long to build; name a file that ends in .svg, or \
             build it from the sources with `cargo build --release -p kahan-cli --features {}`",
            format.feature()
        )),
        _ => UsageError::new(format!(
            "--out: the name of the file, {}, tells its format: it ends in .svg, .png or .pdf",
            out.display()
        )),
    })
}
