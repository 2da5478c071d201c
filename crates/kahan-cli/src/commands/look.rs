//! How a picture is to look: the arguments that all commands share which draw one.

use std::path::Path;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use kahan_draw::{Drawing, Format, NoFile, Sheet, Theme};

use crate::printing::Refusal;

/// How a picture is to look.
#[derive(Args, Debug)]
pub(super) struct Look {
    /// Width and height in pixels.
    #[arg(long, value_name = "WxH", default_value = "960x720", value_parser = pixels)]
    size: (u32, u32),

    /// light, dark, or as the viewer has it.
    #[arg(long, value_parser = theme(), default_value = "viewer", hide_possible_values = true)]
    theme: Theme,
}

/// Reads the name of a theme.
fn theme() -> impl TypedValueParser<Value = Theme> {
    PossibleValuesParser::new(Theme::ALL.map(Theme::name)).map(|name| {
        let theme = Theme::ALL.into_iter().find(|theme| theme.name() == name);
        theme.expect("clap takes no other names")
    })
}

/// Width and height, in the proportions that axes have room in.
fn pixels(text: &str) -> Result<(u32, u32), String> {
    let sides = text.split_once(['x', 'X', '×']);
    let side = |text: &str| text.trim().parse().ok().filter(|side| (16..=8192).contains(side));
    let size: Option<(u32, u32)> = sides.and_then(|(width, height)| Some((side(width)?, side(height)?)));
    size.filter(|(width, height)| width.max(height) <= &(4 * width.min(height))).ok_or_else(|| {
        "write WIDTHxHEIGHT in pixels, as 960x720: each from 16 to 8192, the one at most four times the other".to_owned()
    })
}

impl Look {
    pub(super) fn sheet(&self) -> Sheet {
        Sheet { pixels: self.size, theme: self.theme }
    }
}

/// The format of the picture that `--out` names; refused where this build cannot write it.
pub(super) fn format(out: &Path) -> Result<Format, Refusal> {
    Format::of(out).map_err(|why| match why {
        NoFile::NotBuilt(_) => Refusal::new(NO_PNG),
        _ => Refusal::new(format!(
            "--out: the name of the file, {}, tells its format: it ends in .svg or .png",
            out.display()
        )),
    })
}

const NO_PNG: &str = "--out: this build of the command writes no PNG, whose renderer takes long to build; name a file that ends in \
                      .svg, or build it with `cargo build --release -p kahan-cli --features png`";

/// The file of a drawing.
pub(super) fn file(drawing: &Drawing, format: Format, sheet: &Sheet) -> Result<Vec<u8>, Refusal> {
    drawing.file(format, sheet).map_err(|why| Refusal::new(format!("--out: {why}")))
}
