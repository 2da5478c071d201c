//! `kahan picture`: orbits, orbit diagrams and heights as pictures. Here is how they are asked for;
//! [`shown`] asks and draws.

pub(crate) mod shown;
pub(crate) mod starts;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use kahan_algebra::rational::Rational;
use kahan_draw::picture::Picture as Drawing;
use kahan_study::{Spacing, Study};
use serde_json::json;

use super::line::Line;
use super::look::{SheetOptions, file, format};
use crate::printing::{Answer, Refusal, Sink};
use crate::reading::{Source, number, over, seconds, whole};
use shown::{Drawn, Shown, What};
use starts::{At, Spread};

/// Draws orbits, what they tend to over a parameter, or heights.
///
/// Orbits are those of doubles, heights those of exact orbits. Three variables or more are drawn in
/// space, the first three of them where --axes names no others; near points are larger. An orbit
/// ends at a pole and where doubles overflow. The axes leave out points that lie far from nearly
/// all others, unless --window says where they end; what is left out is counted.
///
/// A section (--plane) shows where orbits cross it with growing formula, refined as `kahan section`
/// does it. An orbit diagram (--over) starts anew at each value, and shows the first of --axes as
/// it is after the transient. Heights that grow like a power of n are drawn over log n, and those
/// that grow exponentially over n: either way they come near a straight line.
///
/// An SVG is light or dark as its viewer is, and text is legible at the width of a telephone;
/// --paper draws for print. PNG and PDF are for builds with the features `png` and `pdf`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Picture {
    #[command(flatten)]
    source: Source,

    /// Half the time step: 1/2, -0.25, 1e-3.
    #[arg(long, value_name = "E", allow_hyphen_values = true, required_unless_present = "over")]
    eps: Option<String>,

    /// A first point, or the ends of a line, A..B, with --starts; once for each.
    ///
    /// Or a file of first points, F.csv or F.npy, that has a row for each.
    #[arg(long, value_name = "X", allow_hyphen_values = true, required = true)]
    at: Vec<String>,

    /// So many first points for each --at: along its line, or random ones around it.
    ///
    /// Random ones are at most --radius away in each coordinate, and follow --seed.
    #[arg(long, value_name = "K", value_parser = whole(1, 100_000_usize))]
    starts: Option<usize>,

    /// How far a random start is from --at, in each coordinate.
    #[arg(long, value_name = "R", default_value = "1/10")]
    radius: String,

    /// The seed that random starts follow.
    #[arg(long, value_name = "S", default_value = "1")]
    seed: u64,

    /// The number of steps of each orbit.
    #[arg(long, value_name = "N", value_parser = whole(0, u64::MAX))]
    steps: u64,

    /// The file, F.svg, F.png or F.pdf, which appears when it is complete.
    #[arg(long, value_name = "F")]
    out: PathBuf,

    /// portrait, heights, section (by --plane), or orbits-over (by --over).
    #[arg(long, value_enum, hide_possible_values = true)]
    kind: Option<Kind>,

    /// Two or three of the variables and t: x,y or x,y,z or t,x.
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    axes: Vec<String>,

    /// What vanishes on a section: z - 27.
    #[arg(long, value_name = "EXPR", allow_hyphen_values = true)]
    plane: Option<String>,

    /// A parameter, or eps, that goes through a range: NAME=FROM:TO:+STEP.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    over: Option<String>,

    /// Steps of an orbit diagram before what it shows.
    #[arg(long, value_name = "N", default_value = "1000", value_parser = whole(0, u64::MAX))]
    transient: u64,

    /// Joins the points of an orbit by lines.
    #[arg(long)]
    lines: bool,

    /// Where an axis begins and ends: NAME=LOW:HIGH; once for each.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    window: Vec<String>,

    #[command(flatten)]
    look: SheetOptions,

    /// The time that it may take; then it shows what there is.
    #[arg(long, value_name = "S", default_value = "60", value_parser = seconds)]
    seconds: f64,

    /// Print one JSON object that says what the file shows.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  kahan picture lv --eps 1/7 --at 1/4,1..1,1 --starts 6 --steps 2000 --out lv.svg
  kahan picture volterra --eps 1/50 --at 1,2,3 --plane x-y --steps 9999 --out section.svg
  kahan picture lv --over eps=1/10:1:+1/400 --at 1/2,1 --axes x --steps 100 --out over.svg
  kahan picture e3 --eps 1/2 --at 3/7,1,1/2 --steps 60 --kind heights --out heights.svg";

/// The kinds of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// Orbits in the plane or in space.
    Portrait,
    /// How the heights of an exact orbit grow.
    Heights,
    /// Where orbits cross a plane, or the level of any function.
    Section,
    /// What orbits tend to, over a parameter or eps.
    OrbitsOver,
}

impl Picture {
    /// What is drawn, and of which field.
    pub(super) fn asked(&self) -> Result<(Study, Shown), Refusal> {
        let kind = self.kind()?;
        let study = self.source.study()?;
        // A false claim is told before a number that is missing.
        study.proved()?;
        let what = match kind {
            Kind::Portrait => What::Portrait,
            Kind::Section => What::Section(self.plane.clone().unwrap_or_default()),
            Kind::OrbitsOver => self.over()?,
            Kind::Heights if self.starts.is_some() || !self.axes.is_empty() => {
                return Err(Refusal::new(
                    "--kind heights shows all variables of one orbit; leave --starts and --axes out",
                ));
            }
            Kind::Heights => What::Heights,
        };
        let radius = number(&self.radius, "--radius")?;
        let spread = Spread { count: self.starts, radius, seed: self.seed };
        let at = self.at.iter().map(|at| At::read(at, &spread, study.variables()));
        let shown = Shown {
            what,
            eps: self.eps.as_deref().map(|eps| number(eps, "--eps")).transpose()?,
            at: at.collect::<Result<Vec<_>, _>>()?.concat(),
            spread,
            steps: self.steps,
            axes: self.axes.iter().map(|name| name.trim().to_owned()).collect(),
            windows: self.window.iter().map(|window| read_window(window)).collect::<Result<_, _>>()?,
            lines: self.lines,
            seconds: self.seconds,
            look: self.look.clone(),
            out: self.out.clone(),
        };
        let names = shown.names(&study)?;
        if let Some((name, _)) = shown.windows.iter().find(|(name, _)| !names.contains(name)) {
            return Err(Refusal::new(format!(
                "--window: the picture has no axis `{name}`; it has {}",
                names.join(", ")
            )));
        }
        Ok((study, shown))
    }

    /// The call that draws this of the system that these words name; what is as usual is left out.
    pub(super) fn call(system: &[String], asked: &Shown) -> Line {
        let line = Line::new("picture", system);
        let Shown { what, eps, at, spread, steps, axes, windows, lines, seconds, look, out } = asked;
        let usual = Spread::default();
        let line = line.with_some("--eps", eps.as_ref());
        let line = at.iter().fold(line, |line, at| line.with("--at", at));
        let line = line.with_some("--starts", spread.count);
        let line = line.unless(spread.radius == usual.radius, "--radius", &spread.radius);
        let line = line.unless(spread.seed == usual.seed, "--seed", spread.seed);
        let line = match what {
            What::Portrait => line,
            What::Section(plane) => line.with("--plane", plane),
            What::Over(axis, transient) => line
                .with("--over", format!("{}={}", axis.name, axis.range))
                .unless(*transient == 1000, "--transient", transient),
            What::Heights => line.with("--kind", "heights"),
        };
        let line = line.unless(axes.is_empty(), "--axes", axes.join(","));
        let line = line.with("--steps", steps);
        let line = windows
            .iter()
            .fold(line, |line, (name, [low, high])| line.with("--window", format!("{name}={low}:{high}")));
        let line = if *lines { line.with_flag("--lines") } else { line };
        let line = look.options(line.unless(*seconds == 60.0, "--seconds", format!("{seconds:?}")));
        line.with("--out", out.display())
    }

    /// Writes the file; the answer says what is in it.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let kind = self.kind()?;
        let format = format(&self.out)?;
        let sink = Sink::file(&self.out, "--out")?;
        let (study, shown) = self.asked()?;
        let drawn = shown.drawn(&study)?;
        let file = file(&drawn.picture.drawing, format)?;
        let bytes = file.len();
        sink.put(file)?;
        Ok(self.answer(study.name(), kind, &drawn, bytes))
    }

    fn kind(&self) -> Result<Kind, Refusal> {
        let implied = match (&self.plane, &self.over) {
            (Some(_), Some(_)) => {
                return Err(Refusal::new(
                    "--plane is for a section and --over for an orbit diagram; leave one out",
                ));
            }
            (Some(_), None) => Some(Kind::Section),
            (None, Some(_)) => Some(Kind::OrbitsOver),
            (None, None) => None,
        };
        match (self.kind, implied) {
            (Some(Kind::OrbitsOver), None) => Err(Refusal::new(
                "--kind orbits-over: over what? give a range to a parameter or to eps, as in --over eps=1/10:1:+1/400",
            )),
            (Some(Kind::Section), None) => {
                Err(Refusal::new("--kind section: where? give what vanishes there, as in --plane 'z - 27'"))
            }
            (Some(kind), Some(implied)) if kind != implied => {
                let (option, made) = match implied {
                    Kind::Section => ("--plane", "a section"),
                    _ => ("--over", "an orbit diagram"),
                };
                Err(Refusal::new(format!("{option} makes {made}; leave it out, or leave --kind out")))
            }
            (kind, implied) => Ok(implied.or(kind).unwrap_or(Kind::Portrait)),
        }
    }

    /// What goes through values, and the steps before what is shown.
    fn over(&self) -> Result<What, Refusal> {
        // So many steps were one value more.
        let axis = over(self.over.as_deref().unwrap_or_default(), |steps| Spacing::Count(steps + 1))?;
        self.source.leaves_free(std::slice::from_ref(&axis), self.eps.as_ref())?;
        Ok(What::Over(axis, self.transient))
    }

    fn answer(&self, system: &str, kind: Kind, drawn: &Drawn, bytes: usize) -> Answer {
        let Drawn { picture: Drawing { drawing, points, outside, .. }, notes } = drawn;
        let file = self.out.display().to_string();
        if self.json {
            let kind = kind.to_possible_value().map(|value| value.get_name().to_owned());
            return Answer::json(&json!({
                "system": system, "kind": kind, "out": file, "bytes": bytes, "shows": drawing.description,
                "points": points, "outside": outside, "notes": notes,
            }));
        }
        let mut lines = vec![format!("{file} written: {points} points, {} kB", bytes.div_ceil(1000))];
        lines.extend(notes.iter().map(|note| format!("note: {note}")));
        if *outside > 0 {
            lines.push(format!(
                "note: {outside} of the points lie outside of the axes; --window moves their ends"
            ));
        }
        Answer::text(lines.join("\n") + "\n")
    }
}

/// Reads NAME=LOW:HIGH.
fn read_window(window: &str) -> Result<(String, [Rational; 2]), Refusal> {
    let (name, range) = window.split_once('=').unwrap_or((window, ""));
    let wrong = || {
        Refusal::new(format!(
            "--window: `{window}` is not NAME=LOW:HIGH with LOW below HIGH, as in {name}=-2:2"
        ))
    };
    let (low, high) = range.split_once(':').ok_or_else(wrong)?;
    let (low, high) = (number(low, "--window")?, number(high, "--window")?);
    let [from, to] = [&low, &high].map(Rational::to_f64);
    if !(from.is_finite() && to.is_finite() && from < to) {
        return Err(wrong());
    }
    Ok((name.trim().to_owned(), [low, high]))
}
