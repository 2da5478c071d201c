//! Requests for pictures, and the answers to these requests.

use std::path::PathBuf;

use kahan_algebra::rational::Rational;
use kahan_draw::answer;
use kahan_draw::picture::{self, Coordinate, Picture, PictureOptions, Trace};
use kahan_runtime::heights::Stop;
use kahan_study::{Diagram, End, Heights, Orbit, Plane, Question, Section, Study, StudyError};

use super::super::image_options::{ImageOptions, usual};
use super::starts::{StartSpec, StartSpread};
use crate::printing::{ProgressDisplay, UsageError};

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PictureRequest {
    pub(crate) what: PictureContent,
    /// Half the time step; `None` if ε is an axis.
    pub(crate) eps: Option<Rational>,
    pub(crate) at: Vec<StartSpec>,
    pub(crate) spread: StartSpread,
    pub(crate) steps: u64,
    /// The names of the axes (variables, formulas or t); empty for the default.
    pub(crate) axes: Vec<String>,
    pub(crate) windows: Vec<(String, [Rational; 2])>,
    pub(crate) lines: bool,
    /// Whether each step of a lifted field is projected onto the relations between its variables.
    pub(crate) reembed: bool,
    pub(crate) seconds: f64,
    pub(crate) look: ImageOptions,
    pub(crate) out: PathBuf,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum PictureContent {
    /// Orbits in the plane or in space.
    Portrait,
    /// Crossings of orbits with a section. [`PictureRequest`] gives ε and the initial points.
    Section(Box<Section>),
    /// An orbit diagram. [`PictureRequest`] contains the initial points and the number of steps.
    Over(Box<Diagram>),
    /// The growth of the heights of an exact orbit.
    Heights,
}

impl PictureContent {
    /// Asks for the points at which the formula `plane` vanishes and increases.
    pub(crate) fn section(plane: &str, steps: u64) -> Self {
        PictureContent::Section(Box::new(Section::new(Rational::zero(), Vec::new(), steps, plane)))
    }
}

pub(crate) struct NotedPicture {
    pub(crate) picture: Picture,
    pub(crate) notes: Vec<String>,
}

const MOST_POINTS: u64 = 10_000_000;
const MOST_JOINED: u64 = 100_000;

impl PictureRequest {
    /// Asks for orbits from these points, with default settings.
    pub(crate) fn portrait(eps: Rational, at: Vec<StartSpec>, steps: u64) -> Self {
        PictureRequest {
            what: PictureContent::Portrait,
            eps: Some(eps),
            at,
            spread: StartSpread::default(),
            steps,
            axes: Vec::new(),
            windows: Vec::new(),
            lines: false,
            reembed: false,
            seconds: 60.0,
            look: ImageOptions::default(),
            out: PathBuf::from("portrait.svg"),
        }
    }

    pub(crate) fn of_diagram(asked: &Diagram) -> Self {
        let (eps, axes) = (asked.eps.clone(), asked.variable.iter().cloned().collect());
        let at = vec![StartSpec::Point(asked.at.clone())];
        let portrait = PictureRequest::portrait(Rational::zero(), at, asked.steps.unwrap_or_default());
        let out = PathBuf::from("diagram.svg");
        let plain = Diagram { eps: None, at: Vec::new(), variable: None, reembed: false, ..asked.clone() };
        let (what, reembed) = (PictureContent::Over(Box::new(plain)), asked.reembed);
        PictureRequest { what, eps, axes, reembed, out, ..portrait }
    }

    pub(crate) fn drawn(&self, study: &Study) -> Result<NotedPicture, UsageError> {
        let windows = self.windows.iter();
        let windows = windows.map(|(name, ends)| (name.clone(), ends.each_ref().map(Rational::to_f64)));
        let look =
            PictureOptions { sheet: self.look.sheet(usual()), windows: windows.collect(), lines: self.lines };
        match &self.what {
            PictureContent::Portrait => self.orbits(study, None, &look),
            PictureContent::Section(asked) => self.orbits(study, Some(asked), &look),
            PictureContent::Over(asked) => self.over(study, asked, &look),
            PictureContent::Heights => self.heights(study, &look),
        }
    }

    fn eps(&self) -> Result<Rational, UsageError> {
        let eps = self.eps.clone();
        eps.ok_or_else(|| {
            UsageError::new("which step? add --eps E, half the time step, as in --eps 1/10, or --dt T")
        })
    }

    /// Returns the axes; by default, the first variables of the field.
    fn axes(&self, study: &Study) -> Result<Vec<Coordinate>, UsageError> {
        let variables = study.shown().len();
        Ok(match (&self.what, &self.axes[..]) {
            (PictureContent::Heights, _) => Vec::new(),
            (PictureContent::Over(..), []) => vec![Coordinate::Variable(0)],
            (PictureContent::Over(..), [name]) => match self.axis(name, study)? {
                variable @ Coordinate::Variable(_) => vec![variable],
                other => {
                    let name = other.name(study.shown());
                    return Err(UsageError::new(format!(
                        "--axes: an orbit diagram shows a variable, and {name} is none"
                    )));
                }
            },
            (PictureContent::Over(..), _) => {
                return Err(UsageError::new(
                    "--axes: an orbit diagram has one variable upwards, as in --axes x",
                ));
            }
            (PictureContent::Section(asked), []) if variables > 2 => {
                let plane = Plane::of(study.system(), &study.values()?, &self.eps()?, &asked.plane)?;
                let others = (0..variables).filter(|k| Some(*k) != plane.last_variable());
                others.take(2).map(Coordinate::Variable).collect()
            }
            (_, []) if variables == 1 => vec![Coordinate::Time, Coordinate::Variable(0)],
            (_, []) => (0..variables.min(3)).map(Coordinate::Variable).collect(),
            (_, names @ ([_, _] | [_, _, _])) => {
                names.iter().map(|name| self.axis(name, study)).collect::<Result<_, _>>()?
            }
            (_, names) => {
                return Err(UsageError::new(format!(
                    "--axes: a portrait has two axes or three, as in --axes x,y, and {} given",
                    names.len()
                )));
            }
        })
    }

    /// Parses an axis: the name of a variable, `t` for the time, or a formula.
    fn axis(&self, name: &str, study: &Study) -> Result<Coordinate, UsageError> {
        if let Some(index) = study.shown().iter().position(|known| known == name) {
            return Ok(Coordinate::Variable(index));
        }
        if name == "t" {
            return Ok(Coordinate::Time);
        }
        let integrals = study.field().integrals();
        let names = [study.variables(), integrals].concat();
        let is_name = name.chars().all(|one| one.is_alphanumeric() || one == '_');
        if is_name && !names.iter().any(|known| known == name) {
            return Err(UsageError::new(format!(
                "--axes: `{name}` is no variable or integral of {}: it has {}; t is the time, and formulas of them \
                 are drawn, too",
                study.name(),
                names.join(", ")
            )));
        }
        let formula = study.formula(&self.eps()?, "axes", name)?;
        let place = formula.last_variable().unwrap_or_default();
        if matches!(self.what, PictureContent::Section(_)) && place >= study.variables().len() {
            return Err(UsageError::new(format!(
                "--axes: a section shows variables and formulas of them, and {name} has an integral"
            )));
        }
        Ok(Coordinate::Formula { text: name.to_owned(), formula, time: study.time_place() })
    }

    pub(super) fn names(&self, study: &Study) -> Result<Vec<String>, UsageError> {
        let axes = self.axes(study)?;
        let axes = axes.iter().map(|axis| axis.name(study.shown()).to_owned());
        Ok(match &self.what {
            PictureContent::Over(asked) => [asked.over.name.clone()].into_iter().chain(axes).collect(),
            _ => axes.collect(),
        })
    }

    /// Refuses more points than a picture may hold.
    fn check_points(&self, orbits: usize, steps: u64) -> Result<(), UsageError> {
        let points = (orbits as u64).saturating_mul(steps.saturating_add(1));
        let (most, way_out) =
            if self.lines { (MOST_JOINED, "leave --lines out") } else { (MOST_POINTS, "draw fewer orbits") };
        if points <= most {
            return Ok(());
        }
        Err(UsageError::new(format!(
            "--steps: {orbits} orbits of {steps} steps are more than the {most} points that a picture holds; take fewer steps, or {way_out}"
        )))
    }

    /// Calls `ask` for each initial point until time is up. Also returns whether it is up.
    fn ask_each<A>(
        &self,
        starts: &[Vec<Rational>],
        steps: u64,
        ask: impl Fn(Vec<Rational>, &ProgressDisplay) -> Result<A, StudyError>,
    ) -> Result<(Vec<A>, bool), UsageError> {
        let prompt =
            ProgressDisplay::new((starts.len() as u64).saturating_mul(steps), "steps").within(self.seconds);
        let mut found = Vec::new();
        for at in starts {
            // The first point is tried even if time is up, so that its error is reported.
            if prompt.is_over() && !found.is_empty() {
                break;
            }
            found.push(ask(at.clone(), &prompt)?);
            prompt.show_steps(steps);
        }
        Ok((found, prompt.is_over()))
    }

    /// Draws orbits, or their crossings with a section.
    fn orbits(
        &self,
        study: &Study,
        section: Option<&Section>,
        look: &PictureOptions,
    ) -> Result<NotedPicture, UsageError> {
        // Given axes may name new variables of a lift, so the study then shows all variables.
        let study = &if self.axes.is_empty() { study.clone() } else { study.showing_all() };
        let (axes, eps, starts) = (self.axes(study)?, self.eps()?, self.spread.starts(&self.at));
        self.check_points(starts.len(), section.and_then(|asked| asked.crossings).unwrap_or(self.steps))?;
        let (traced, is_over) = self.ask_each(&starts, self.steps, |at, prompt| {
            let Some(section) = section else {
                let mut trace = Trace::new(&axes);
                let asked = Orbit { reembed: self.reembed, ..Orbit::new(eps.clone(), at, self.steps) };
                let end = study.rows(&Question::Orbit(asked), 0..u64::MAX, &mut trace, prompt)?;
                return Ok((trace, end == End::Complete, 0));
            };
            let asked = Section { eps: Some(eps.clone()), at, reembed: self.reembed, ..section.clone() };
            let mut trace = Trace::new(&axes);
            let found = asked.find(study, &mut trace, prompt)?;
            let has_all = section.crossings == Some(found[0].crossings);
            Ok((trace, has_all || found[0].end == End::Complete, found[0].jumps))
        })?;
        let ended = traced.iter().filter(|(_, is_complete, _)| !is_complete).count();
        let jumps = traced.iter().map(|(.., jumps)| jumps).sum();
        let is_cut = is_over && (traced.len() < starts.len() || ended > 0);
        let plane = section.map(|asked| &asked.plane[..]);
        let seen = plane.map_or("Orbits".to_owned(), |plane| format!("The section {plane} = 0 of orbits"));
        let against = self.names(study)?.join(" and ");
        let described = format!("{seen} of {} at eps = {eps}, {against} against each other", study.name());
        let traces = traced.into_iter().map(|(trace, ..)| trace).collect();
        let picture = picture::portrait(described, study.shown(), traces, look);
        let mut notes = notes(starts.len(), ended, is_cut);
        notes.extend(answer::jumps(plane.unwrap_or_default(), jumps));
        Ok(NotedPicture { picture, notes })
    }

    fn over(
        &self,
        study: &Study,
        asked: &Diagram,
        look: &PictureOptions,
    ) -> Result<NotedPicture, UsageError> {
        let (starts, range) = (self.spread.starts(&self.at), &asked.over.range);
        let values = range.count();
        let points = asked.crossings.filter(|_| asked.plane.is_some()).unwrap_or(self.steps);
        self.check_points(starts.len() * values, points)?;
        let each = asked.transient.saturating_add(self.steps);
        let steps = each.saturating_mul(values as u64);
        let variable = self.names(study)?.pop();
        let (found, _) = self.ask_each(&starts, steps, |at, prompt| {
            let (eps, variable, reembed) = (self.eps.clone(), variable.clone(), self.reembed);
            Diagram { eps, at, variable, reembed, ..asked.clone() }.ask(study, prompt)
        })?;
        let is_cut = found.len() < starts.len() || found.iter().any(|found| found.stopped);
        let ended = found.iter().map(|found| found.ended).sum();
        let picture = picture::diagram(&found, range, asked.transient, look);
        Ok(NotedPicture { picture, notes: notes(starts.len() * values, ended, is_cut) })
    }

    fn heights(&self, study: &Study, look: &PictureOptions) -> Result<NotedPicture, UsageError> {
        let (eps, starts) = (self.eps()?, self.spread.starts(&self.at));
        let [at] = &starts[..] else {
            return Err(UsageError::new("--kind heights follows one orbit; give one --at"));
        };
        let asked = Heights::new(eps.clone(), at.clone(), self.steps);
        let asked = Heights { seconds: self.seconds, ..asked };
        let found = asked.ask(study, &ProgressDisplay::new(self.steps, "steps"))?;
        let mut notes = vec![format!("growth is {}", found.survey.growth)];
        notes.extend(found.survey.stopped.map(|stop| {
            let why = match stop {
                Stop::Pole => "the map has a pole there",
                Stop::Digits => "the next point would have more than a million digits",
                Stop::Seconds => "time ran out",
            };
            format!("the orbit ends after {} of {} steps: {why}", found.steps(), self.steps)
        }));
        Ok(NotedPicture { picture: picture::heights(&found, &eps, look), notes })
    }
}

/// Describes the orbits that ended early, or were left out for lack of time.
fn notes(orbits: usize, ended: usize, is_cut: bool) -> Vec<String> {
    if is_cut {
        let cut = "time ran out, and the picture shows the points so far; increase --seconds to draw all";
        return vec![cut.to_owned()];
    }
    let ended = (ended > 0)
        .then(|| format!("{ended} of {orbits} orbits end early, at a pole or beyond the range of doubles"));
    ended.into_iter().collect()
}
