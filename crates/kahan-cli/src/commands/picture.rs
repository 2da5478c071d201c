//! `kahan picture`: orbits, orbit diagrams and heights as pictures. Here is what is asked and what
//! is answered; each kind of picture is a module.

mod axes;
mod heights;
mod orbits;
mod over;
mod portrait;
mod starts;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_draw::{Drawing, Mark, Sheet};
use serde_json::json;

use super::look::{Look, file, format};
use crate::printing::{Answer, Refusal, Sink};
use crate::reading::{Source, number, seconds, whole};
use orbits::Pace;

/// Draws orbits, what they tend to over a parameter, or heights.
///
/// Orbits are those of doubles, heights those of exact orbits. Three variables or more are drawn in
/// space, the first three of them where --axes names no others; near points are larger. An orbit
/// ends at a pole and where doubles overflow. The axes leave out points that lie far from nearly
/// all others, unless --window says where they end; what is left out is counted.
///
/// A section (--plane) shows where orbits cross it with growing formula, refined as `kahan section`
/// does it. An orbit diagram (--over) starts anew at each value, and shows the first of --axes as
/// it is after the transient. Heights are drawn so that growth like a power of n is a straight
/// line; where it is exponential, exponential growth is.
///
/// An SVG is light or dark as its viewer is, and text is legible at the width of a telephone. PNG
/// is for builds with the feature `png`.
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
    #[arg(long, value_name = "K", value_parser = count)]
    starts: Option<usize>,

    /// How far a random start is from --at, in each coordinate.
    #[arg(long, value_name = "R", default_value = "1/10")]
    radius: String,

    /// The seed that random starts follow.
    #[arg(long, value_name = "S", default_value = "1")]
    seed: u64,

    /// The number of steps of each orbit.
    #[arg(long, value_name = "N", value_parser = steps)]
    steps: u64,

    /// The file, F.svg or F.png, which appears when it is complete.
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
    #[arg(long, value_name = "N", default_value = "1000", value_parser = steps)]
    transient: u64,

    /// Joins the points of an orbit by lines.
    #[arg(long)]
    lines: bool,

    /// Where an axis begins and ends: NAME=LOW:HIGH; once for each.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    window: Vec<String>,

    #[command(flatten)]
    look: Look,

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
  kahan picture e4 --eps 1/5 --at 7/3,11/13,23/47 --steps 3000 --out e4.svg
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

/// The most points of a picture.
const MOST_POINTS: u64 = 10_000_000;
/// The most points that lines join.
const MOST_JOINED: u64 = 100_000;

fn count(text: &str) -> Result<usize, String> {
    whole(text, 1, 100_000)
}

fn steps(text: &str) -> Result<u64, String> {
    whole(text, 0, u64::MAX)
}

/// What a picture is about, and how it is to look.
struct Subject<'a> {
    asked: &'a Picture,
    name: String,
    system: System,
    source: Source,
    sheet: Sheet,
}

/// A picture, and what there is to say of it.
pub(super) struct Drawn {
    pub(super) drawing: Drawing,
    /// How many points there are.
    pub(super) points: usize,
    /// How many of these its axes do not show.
    outside: usize,
    /// What is seen of each orbit of a portrait or a section.
    pub(super) visits: Vec<Visits>,
    pub(super) notes: Vec<String>,
}

/// What is seen of an orbit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Visits {
    /// How many points it has in the picture.
    pub(super) points: usize,
    /// At how many places these are that can be told apart.
    pub(super) places: usize,
}

impl Picture {
    /// Writes the file; the answer says what is in it.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let kind = self.kind()?;
        let format = format(&self.out)?;
        let sink = Sink::file(&self.out, "--out")?;
        let (name, drawn) = self.drawn()?;
        let file = file(&drawn.drawing, format, &self.look.sheet())?;
        let bytes = file.len();
        sink.put(file)?;
        Ok(self.answer(&name, kind, &drawn, bytes))
    }

    /// The picture of the system that is named.
    pub(super) fn drawn(&self) -> Result<(String, Drawn), Refusal> {
        let kind = self.kind()?;
        let block = self.source.required_block()?;
        let system = block.system()?;
        let name = block.name(&system);
        let subject =
            Subject { asked: self, name, system, source: self.source.clone(), sheet: self.look.sheet() };
        let drawn = match kind {
            Kind::Portrait | Kind::Section => subject.portrait()?,
            Kind::OrbitsOver => subject.orbits_over()?,
            Kind::Heights => subject.heights()?,
        };
        Ok((subject.name, drawn))
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

    fn answer(&self, system: &str, kind: Kind, drawn: &Drawn, bytes: usize) -> Answer {
        let Drawn { drawing, points, outside, notes, .. } = drawn;
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

impl Subject<'_> {
    fn variables(&self) -> &[String] {
        &self.system.field.symbols.states
    }

    /// The values of the parameters; `fixed` is given from elsewhere.
    fn parameters(&self, fixed: Option<(&str, &Rational)>) -> Result<Vec<Rational>, Refusal> {
        let source = match fixed {
            Some((name, value)) => &self.source.clone().with_parameter(name, value),
            None => &self.source,
        };
        source.parameter_values(&self.system, &self.name)
    }

    fn eps(&self) -> Result<Rational, Refusal> {
        let eps = self.asked.eps.as_deref();
        number(
            eps.ok_or_else(|| Refusal::new("which eps? give half the time step, as in --eps 1/10"))?,
            "--eps",
        )
    }

    /// How many points there will be; refused where these are too many.
    fn points(&self, orbits: usize) -> Result<u64, Refusal> {
        let points = (orbits as u64).saturating_mul(self.asked.steps.saturating_add(1));
        let (most, way_out) = if self.asked.lines {
            (MOST_JOINED, "leave --lines out")
        } else {
            (MOST_POINTS, "draw fewer orbits")
        };
        if points > most {
            return Err(Refusal::new(format!(
                "--steps: {orbits} orbits of {} steps are more than the {most} points that a picture holds; take fewer steps, or {way_out}",
                self.asked.steps
            )));
        }
        Ok(points)
    }

    /// Marks that leave so many points apart.
    fn mark(&self, points: u64) -> Mark {
        match points {
            _ if self.asked.lines => Mark::Line,
            0..=400 => Mark::Dots,
            401..=20_000 => Mark::Points,
            _ => Mark::Fine,
        }
    }

    fn pace(&self, steps: u64) -> Pace {
        Pace::new(steps, self.asked.seconds)
    }
}
