//! The command `kahan page`, which writes a page of figures about a field.

mod figures;
mod lifted;

use std::path::PathBuf;

use clap::Args;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::block_lines;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::System;
use kahan_draw::document::{PageCreation, colophon, document, readable};
use kahan_study::{Answer as Found, Lift, ShownOrbit, Study, Systems};
use kahan_systems::entry::Entry;
use maud::{Markup, html};

use super::atlas::IndexFile;
use super::command_line::CommandLine;
use crate::printing::{Answer, ProgressDisplay, UsageError, joined};
use crate::reading::{Block, Source, StepLength, point, seconds};
use figures::{AnsweredQuestion, Field, Subject, command};

/// Writes an HTML page about a field: formulas, findings with proofs, figures, settings.
///
/// The page is DIR/index.html. It shows the field, A, b, the map and its Jacobian; the findings of
/// `kahan discover`; singularities, and the heights of an exact orbit; orbits, a section, Lyapunov
/// exponents, a stability chart; and the cheapest settings of `kahan trade`. Below each figure
/// stands the command that reproduces it. Without --eps and --at, eps is chosen by the rates of the
/// field, and the initial point so that its orbit stays bounded. Formulas and findings use the
/// values of --param. Other parameters of a catalog system are generic there, and have the
/// catalog's values in the figures. A field of your own needs a value for each parameter.
///
/// The page of a lifted field begins with the original equations, the new variables, and the
/// relations with the error of each along the orbit. Without an initial point, the lift is chosen
/// along an orbit that the page selects.
///
/// The page needs neither a network nor scripts. It replaces an older page once it is complete. If
/// a part cannot be made, it is left out, and the page says why.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan page e6 --out e6 --seconds 5
  kahan page --field 'xdot = y; ydot = 6*x^2 - a;' --param a=1 --seconds 5 --out weierstrass
  kahan page --lift --field 'xdot = v; vdot = -sin(x);' --seconds 5 --out pendulum
  kahan page lorenz --eps 1/500 --at 1,1,1 --seconds 5 --out lorenz")]
#[command(mut_arg("eps", |eps| eps.help("Half the time step of the figures (dt = 2 eps); chosen if not given")))]
pub(crate) struct Page {
    #[command(flatten)]
    source: Source,

    #[command(flatten)]
    step: StepLength,

    /// The initial point of the figures, separated by commas; chosen if not given.
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    at: Option<String>,

    /// The approximate time limit, in seconds.
    #[arg(long, value_name = "S", default_value = "40", allow_hyphen_values = true, value_parser = seconds)]
    seconds: f64,

    /// The folder for index.html, created if missing.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

impl Page {
    pub(crate) fn run(&self) -> Result<Answer, UsageError> {
        let index = IndexFile::begin(&self.out)?;
        let block = self.source.required_block()?;
        let at = self.at.as_deref();
        let (source, begun) = self.with_chosen_start(&block)?;
        let read = |source: &Source| -> Result<Field, UsageError> {
            Ok(Field { words: source.arguments(&begun), study: source.study_of_block(&begun, at)? })
        };
        let generic = read(&source)?;
        generic.study.proved()?;
        let valued = read(&with_values(&source, &begun, &generic.study))?;
        let (study, shown) = (&valued.study, self.shown(&valued.study)?);
        let seconds = self.seconds;
        let variables = study.shown();
        let subject =
            Subject { valued: &valued, kept: &valued, generic: &generic, variables, shown: &shown, seconds };
        let chapters = chapters(&subject, block.text());
        let text = written(&subject, block.entry, &chapters, &self.line(&block), &index.creation());
        index.put(&text, "", 2)
    }

    fn shown(&self, study: &Study) -> Result<ShownOrbit, UsageError> {
        let eps = self.step.half()?;
        let at = self.at.as_deref().map(|at| point(Some(at), study)).transpose()?;
        Ok(study.shown_orbit(eps.as_ref(), at.as_deref())?)
    }

    fn line(&self, block: &Block) -> CommandLine {
        let line = CommandLine::new("page", &self.source.arguments(block));
        let line = self.step.given().into_iter().fold(line, |line, (option, text)| line.with(option, text));
        let line = line.with_some("--at", self.at.as_ref());
        line.with("--seconds", self.seconds).with("--out", self.out.display())
    }
}

/// Fills in missing parameter values from the text or from the catalog.
fn with_values(source: &Source, block: &Block, study: &Study) -> Source {
    let of_catalog = block.entry.map_or(&[][..], |entry| entry.parameters);
    let of_catalog = |k: usize| of_catalog.get(k).map(|(above, below)| Rational::new(*above, *below));
    let values = study.valued().into_iter().enumerate();
    let values = values.map(|(k, own)| own.or_else(|| of_catalog(k)));
    let missing = study.parameters().iter().zip(values).zip(study.given());
    let missing = missing.filter(|(_, given)| given.is_none());
    missing.fold(source.clone(), |source, ((name, value), _)| match value {
        Some(value) => source.with_parameter(name, &value),
        None => source,
    })
}

struct Chapter {
    id: &'static str,
    title: &'static str,
    body: Markup,
}

/// Computes all chapters in order. For a lifted field, `written` is the original text.
fn chapters(subject: &Subject<'_>, written: &str) -> Vec<Chapter> {
    let (generic, valued) = (subject.generic.study.system(), &subject.valued.study);
    let progress = ProgressDisplay::stages();
    let mut chapters = Vec::new();
    let mut chapter = |id, title, make: &dyn Fn() -> Markup| {
        progress.show_stage(title);
        chapters.push(Chapter { id, title, body: make() });
    };
    if valued.lift().is_some_and(|lift| lift.order() > 0) {
        chapter("lift", "The lift", &|| subject.lift(written));
    }
    chapter("formulas", "Formulas", &|| subject.formulas());
    progress.show_stage("What the map preserves");
    let search = subject.search();
    chapter("found", "What the map preserves", &|| search.html());
    let claims_some = generic.accessors(ClaimKind::Integral).next().is_some();
    let found = if claims_some { None } else { with_integrals(&search, &valued.fixed()) };
    let subject = &Subject { kept: found.as_ref().unwrap_or(subject.kept), ..*subject };
    chapter("growth", "Singularities and heights", &|| subject.growth());
    chapter("orbits", "Orbits", &|| subject.orbits());
    chapter("dynamics", "Exponents and rotation", &|| subject.dynamics());
    chapter("stability", "Stability", &|| subject.chart());
    chapter("settings", "The cheapest settings", &|| subject.settings());
    chapters
}

fn written(
    subject: &Subject<'_>,
    entry: Option<&Entry>,
    chapters: &[Chapter],
    again: &CommandLine,
    making: &PageCreation,
) -> String {
    let study = &subject.valued.study;
    let header = study.system().header.as_ref().map(|_| study.name());
    let name = entry.map(|entry| entry.name).or(header).unwrap_or("A field");
    let title = format!("{name} and its Kahan map");
    let body = html! {
        header {
            h1 { (title) }
            (introduction(subject))
            (command(again))
        }
        nav aria-label="Contents" {
            h2 { "Contents" }
            ol { @for chapter in chapters { li { a href=(format!("#{}", chapter.id)) { (chapter.title) } } } }
        }
        main {
            @for chapter in chapters { section id=(chapter.id) { h2 { (chapter.title) } (chapter.body) } }
        }
        (colophon(making, &html! { code { (again) } }))
    };
    document(&title, ("formulas", "the formulas"), &body)
}

fn introduction(subject: &Subject<'_>) -> Markup {
    let (study, shown) = (&subject.valued.study, subject.shown);
    let values = study.fixed();
    let values = joined(values.iter().map(|(name, value)| format!("{name} = {value}")), ", ");
    html! {
        @if let Some(title) = study.title() { p.lead { (readable(title)) } }
        p.lead {
            @match study.lift().map_or(0, Lift::order) {
                0 => "Kahan’s method turns this quadratic differential equation into a rational map that can be run forwards and ",
                1 => "With one new variable this differential equation is quadratic, and Kahan’s method turns it into a rational map that can be run forwards and ",
                order => { "With " (order) " new variables this differential equation is quadratic, and Kahan’s method turns it into a rational map that can be run forwards and " },
            }
            "backwards. All that stands here was computed from the equations when the page was written, and under each figure "
            "stands the command that makes it again."
        }
        p {
            "The figures are at ε = " (shown.eps) ", half the time step, and begin at (" (joined(&shown.start, ", ")) ")"
            @if !values.is_empty() { ", with " (values) }
            "."
            @if !shown.stays { " This orbit does not stay: it reaches a pole or grows beyond a thousand times its first size." }
        }
    }
}

/// Returns the field with the discovered integrals, if they are few and short enough.
fn with_integrals(found: &AnsweredQuestion, values: &[(String, Rational)]) -> Option<Field> {
    const LONGEST: usize = 800;

    let Ok(Found::Discover(found)) = &found.answer else { return None };
    let claimed = &found.readable();
    let claims = claimed.claims.iter().filter(|claim| claim.kind == ClaimKind::Integral);
    let claimed = System { claims: claims.cloned().collect(), ..claimed.clone() };
    let names = claimed.field.symbols.parameters.iter().enumerate();
    let values = names.filter_map(|(k, name)| {
        let (_, value) = values.iter().find(|(known, _)| known == name)?;
        Some((k, value.clone()))
    });
    let at_values = claimed.specialise(&values.collect::<Vec<_>>())?;
    let text = joined(block_lines(&at_values).iter().flat_map(|line| line.split_whitespace()), " ");
    let has_integrals = at_values.accessors(ClaimKind::Integral).next().is_some();
    if !has_integrals || text.len() > LONGEST {
        return None;
    }
    let study = kahan_study::Subject::text(&text).study(&Systems).ok()?;
    Some(Field { words: vec!["--field".to_owned(), text], study })
}
