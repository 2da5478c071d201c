//! The command `kahan picture`, which draws orbits, sections, orbit diagrams and heights.

pub(crate) mod request;
pub(crate) mod starts;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use kahan_algebra::rational::Rational;
use kahan_draw::picture::Picture as Drawing;
use kahan_study::{Diagram, Direction, Section, Study};
use serde_json::json;

use super::command_line::CommandLine;
use super::image_options::{ImageOptions, OutFile};
use super::section::section;
use crate::printing::{Answer, UsageError};
use crate::reading::{Source, StepLength, Stepping, number, over, point, seconds, whole};
use request::{NotedPicture, PictureContent, PictureRequest};
use starts::{StartSpec, StartSpread};

/// Draws orbits, sections, orbit diagrams or heights.
///
/// Orbits are computed in f64, heights from exact orbits. With three or more variables, the picture
/// shows the first three in space, or those that --axes names; near points are drawn larger. An
/// orbit ends at a pole or an overflow. The axes leave out points that lie far from nearly all
/// others; a note counts these. --window sets the ends of an axis.
///
/// A section (--plane) shows where orbits cross the surface on which a formula vanishes, with the
/// formula growing, as in `kahan section`. An orbit diagram (--over) starts at the initial point
/// for each value, and shows the first of --axes after the transient: at each step, or with --plane
/// or --maxima at the crossings. Heights that grow like a power of n are drawn over log n, and
/// those that grow exponentially over n: in both cases the curve is nearly a straight line.
///
/// An SVG follows the light or dark setting of its viewer, and its text is legible at the width of
/// a telephone. PNG and PDF need a build with the features `png` and `pdf`.
#[derive(Args, Debug)]
#[command(help_template = HELP_TEMPLATE, after_help = "\
Examples:
  kahan picture lv --eps 1/7 --at 1/4,1..1,1 --starts 6 --steps 2000 --out lv.svg")]
pub(crate) struct Picture {
    #[command(flatten)]
    source: Source,

    #[command(flatten)]
    step: StepLength,

    /// An initial point, or with --starts the ends of a line, A..B; repeatable.
    ///
    /// A file F.csv or F.npy may contain an initial point in each row. The option may be left out
    /// if the equations give initial values.
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    at: Vec<String>,

    /// The number of initial points per --at: along its line, or random around it.
    ///
    /// Without this option, each --at is one initial point. Random points differ from --at by at
    /// most --radius in each coordinate, and are drawn by --seed.
    #[arg(long, value_name = "K", value_parser = whole(1, MOST_STARTS))]
    starts: Option<usize>,

    /// The largest distance of random starts, per coordinate.
    #[arg(long, value_name = "R", default_value = "1/10")]
    radius: String,

    /// The seed of the random starts.
    #[arg(long, value_name = "S", default_value = "1")]
    seed: u64,

    /// The number of steps of each orbit; for a section, the largest number.
    #[arg(long, value_name = "N", value_parser = whole(0, u64::MAX), required_unless_present_any = ["crossings", "plane", "maxima"])]
    steps: Option<u64>,

    /// The output file: F.svg, F.png or F.pdf.
    #[arg(long, value_name = "F")]
    out: PathBuf,

    /// portrait, heights, section (--plane or --maxima), or orbits-over (--over).
    #[arg(long, value_enum, hide_possible_values = true)]
    kind: Option<Kind>,

    /// Two or three variables, integrals, formulas or t: x,y or t,H or t,x^2+y^2.
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    axes: Vec<String>,

    /// The formula that vanishes on a section, as in z - 27.
    #[arg(long, value_name = "EXPR", allow_hyphen_values = true)]
    plane: Option<String>,

    /// A parameter or eps, and its range: NAME=FROM:TO:+STEP.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    over: Option<String>,

    /// With --over: the number of steps before the shown ones.
    #[arg(long, value_name = "N", default_value = "1000", value_parser = whole(0, u64::MAX), requires = "over")]
    transient: u64,

    /// The section of the maxima of variable X, instead of --plane.
    #[arg(long, value_name = "X", conflicts_with = "plane")]
    maxima: Option<String>,

    /// The number of crossings of each orbit of a section; 100 without --steps.
    #[arg(long, value_name = "K", value_parser = whole(1, u64::MAX))]
    crossings: Option<u64>,

    /// With --over: begin each orbit at the last point of the one before it.
    #[arg(long, requires = "over")]
    carry: bool,

    #[command(flatten)]
    stepping: Stepping,

    /// Join the points of an orbit by lines.
    #[arg(long)]
    lines: bool,

    /// The ends of an axis: NAME=LOW:HIGH; repeat it for each axis.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    window: Vec<String>,

    #[command(flatten)]
    look: ImageOptions,

    /// Stop after S seconds and draw the points so far.
    #[arg(long, value_name = "S", default_value = "60", value_parser = seconds)]
    seconds: f64,

    /// Print one JSON object that describes the file.
    #[arg(long)]
    json: bool,
}

const HELP_TEMPLATE: &str =
    "{about-with-newline}{usage-heading} {usage}\nOptions:\n{positionals}\n{options}{after-help}";

/// The kinds of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// Orbits in the plane or in space.
    Portrait,
    /// Growth of the heights of an exact orbit.
    Heights,
    /// Crossings of a plane, or of a level of any function.
    Section,
    /// Limits of orbits, over a parameter or eps.
    OrbitsOver,
}

const MOST_STARTS: usize = 100_000;
const USUAL_CROSSINGS: u64 = 100;

impl Picture {
    pub(super) fn read_question(&self) -> Result<(Study, PictureRequest), UsageError> {
        let kind = self.kind()?;
        let study = self.source.proved(self.at.first().map(String::as_str))?;
        let what = match kind {
            Kind::Portrait => PictureContent::Portrait,
            Kind::Section => {
                let (plane, direction, crossings) = self.section(&study)?.unwrap_or_default();
                let asked = Section::new(Rational::zero(), Vec::new(), 0, plane);
                PictureContent::Section(Box::new(Section {
                    steps: self.steps,
                    direction,
                    crossings,
                    ..asked
                }))
            }
            Kind::OrbitsOver => {
                let axis = over(self.over.as_deref().unwrap_or_default())?;
                self.source.leaves_free(std::slice::from_ref(&axis), &self.step)?;
                let section = self.section(&study)?;
                let plane = section.as_ref().map(|(plane, ..)| plane.clone());
                let (_, direction, crossings) = section.unwrap_or_default();
                let asked = Diagram::new(None, Vec::new(), axis, 0);
                PictureContent::Over(Box::new(Diagram {
                    plane,
                    direction,
                    transient: self.transient,
                    steps: self.steps,
                    crossings,
                    carry: self.carry,
                    ..asked
                }))
            }
            Kind::Heights if self.starts.is_some() || !self.axes.is_empty() => {
                return Err(UsageError::new(
                    "--kind heights shows all variables of one orbit; leave --starts and --axes out",
                ));
            }
            Kind::Heights if self.stepping.reembed => {
                return Err(UsageError::new(
                    "--kind heights is of exact orbits, and --reembed projects steps in f64; leave --reembed out",
                ));
            }
            Kind::Heights => PictureContent::Heights,
        };
        let radius = number(&self.radius, "--radius")?;
        let spread = StartSpread { count: self.starts, radius, seed: self.seed };
        let at = self.at.iter().map(|at| StartSpec::read(at, &spread, &study));
        let own = self.at.is_empty().then(|| Ok(vec![StartSpec::Point(point(None, &study)?)]));
        let shown = PictureRequest {
            what,
            eps: self.step.half()?,
            at: at.chain(own).collect::<Result<Vec<_>, UsageError>>()?.concat(),
            spread,
            steps: self.steps.unwrap_or_default(),
            axes: self.axes.iter().map(|name| name.trim().to_owned()).collect(),
            windows: self.window.iter().map(|window| read_window(window)).collect::<Result<_, _>>()?,
            lines: self.lines,
            reembed: self.stepping.reembed,
            seconds: self.seconds,
            look: self.look.clone(),
            out: self.out.clone(),
        };
        let names = shown.names(&study)?;
        if let Some((name, _)) = shown.windows.iter().find(|(name, _)| !names.contains(name)) {
            let known = names.join(", ");
            return Err(UsageError::new(format!(
                "--window: the picture has no axis `{name}`; it has {known}"
            )));
        }
        Ok((study, shown))
    }

    /// Appends the options for this picture that differ from the defaults.
    pub(super) fn options(asked: &PictureRequest, line: CommandLine) -> CommandLine {
        let PictureRequest {
            what,
            eps,
            at,
            spread,
            steps,
            axes,
            windows,
            lines,
            reembed,
            seconds,
            look,
            out,
        } = asked;
        let (kind, over) = match what {
            PictureContent::Portrait | PictureContent::Section(_) => (None, None),
            PictureContent::Heights => (Some("heights"), None),
            PictureContent::Over(asked) => (None, Some(asked)),
        };
        let (plane, direction, steps, crossings) = match what {
            PictureContent::Section(asked) => {
                (Some(&asked.plane), Some(asked.direction), asked.steps, asked.crossings)
            }
            PictureContent::Over(asked) => {
                (asked.plane.as_ref(), Some(asked.direction), asked.steps, asked.crossings)
            }
            PictureContent::Portrait | PictureContent::Heights => (None, None, Some(*steps), None),
        };
        let windows = windows.iter().map(|(name, [low, high])| format!("{name}={low}:{high}"));
        let line = line.with_changed_options::<Self>(&json!({
            "eps": eps.as_ref().map(Rational::to_string), "at": at.iter().map(StartSpec::to_string).collect::<Vec<_>>(),
            "starts": spread.count, "radius": spread.radius.to_string(), "seed": spread.seed, "plane": plane,
            "over": over.map(|asked| json!({(asked.over.name.clone()): asked.over.range})), "kind": kind, "axes": axes,
            "transient": over.map(|asked| asked.transient), "direction": direction.map(Direction::name),
            "crossings": crossings, "carry": over.is_some_and(|asked| asked.carry),
            "steps": steps, "window": windows.collect::<Vec<_>>(), "lines": lines, "reembed": reembed, "seconds": seconds,
        }));
        look.options(line).with("--out", out.display())
    }

    /// Writes the file, and returns a description of its contents.
    pub(crate) fn run(&self) -> Result<Answer, UsageError> {
        let kind = self.kind()?;
        let out = OutFile::picture(&self.out)?;
        let (study, shown) = self.read_question()?;
        let drawn = shown.drawn(&study)?;
        let bytes = out.put(&drawn.picture.drawing, String::new)?;
        Ok(self.answer(study.name(), kind, &drawn, bytes))
    }

    /// Returns the requested section: formula, direction and number of crossings.
    fn section(&self, study: &Study) -> Result<Option<(String, Direction, Option<u64>)>, UsageError> {
        let (plane, maxima) = (self.plane.as_deref(), self.maxima.as_deref());
        if plane.or(maxima).is_none() {
            return Ok(None);
        }
        let (plane, direction) = section(study, plane, maxima, Direction::default())?;
        let usual = self.steps.is_none().then_some(USUAL_CROSSINGS);
        Ok(Some((plane, direction, self.crossings.or(usual))))
    }

    fn kind(&self) -> Result<Kind, UsageError> {
        let section = self.plane.as_ref().or(self.maxima.as_ref());
        Err(UsageError::new(match (self.kind, section, &self.over) {
            (None | Some(Kind::Section), Some(_), None) => return Ok(Kind::Section),
            (Some(_), Some(_), None) => {
                "--plane and --maxima make a section; leave them out, or leave --kind out"
            }
            (_, None, _) if self.crossings.is_some() => {
                "--crossings counts the crossings of a section; add --plane EXPR or --maxima X, or give --steps N"
            }
            (None | Some(Kind::OrbitsOver), _, Some(_)) => return Ok(Kind::OrbitsOver),
            (Some(_), _, Some(_)) => "--over makes an orbit diagram; leave it out, or leave --kind out",
            (Some(Kind::OrbitsOver), None, None) => {
                "--kind orbits-over: over what? give a range to a parameter or to eps, as in --over eps=1/10:1:+1/400"
            }
            (Some(Kind::Section), None, None) => {
                "--kind section: where? give what vanishes there, as in --plane 'z - 27'"
            }
            (kind, None, None) => return Ok(kind.unwrap_or(Kind::Portrait)),
        }))
    }

    fn answer(&self, system: &str, kind: Kind, drawn: &NotedPicture, bytes: usize) -> Answer {
        let NotedPicture { picture: Drawing { drawing, points, outside, .. }, notes } = drawn;
        let file = self.out.display().to_string();
        if self.json {
            let kind = kind.to_possible_value().map(|value| value.get_name().to_owned());
            return Answer::json(&json!({
                "system": system, "kind": kind, "out": file, "bytes": bytes, "shows": drawing.description,
                "points": points, "outside": outside, "notes": notes,
            }));
        }
        let mut lines = vec![format!("{file} written: {points} points, {} kB", bytes.div_ceil(1000))];
        let outside = (*outside > 0)
            .then(|| format!("{outside} of the points lie outside of the axes; --window moves their ends"));
        lines.extend(notes.iter().cloned().chain(outside).map(|note| format!("note: {note}")));
        Answer::text(lines.join("\n") + "\n")
    }
}

/// Reads NAME=LOW:HIGH, the ends of an axis.
fn read_window(window: &str) -> Result<(String, [Rational; 2]), UsageError> {
    let (name, range) = window.split_once('=').unwrap_or((window, ""));
    let wrong = format!("--window: `{window}` is not NAME=LOW:HIGH with LOW below HIGH, as in {name}=-2:2");
    let (low, high) = range.split_once(':').ok_or_else(|| UsageError::new(&wrong))?;
    let ends = [number(low, "--window")?, number(high, "--window")?];
    let [from, to] = ends.each_ref().map(Rational::to_f64);
    if from.is_finite() && to.is_finite() && from < to {
        Ok((name.trim().to_owned(), ends))
    } else {
        Err(UsageError::new(wrong))
    }
}
