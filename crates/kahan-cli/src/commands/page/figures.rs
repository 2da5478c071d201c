//! The figures of a page: drawings and tables of answers, each with its command line.

use kahan_algebra::rational::Rational;
use kahan_discover::orbits::hilbert::default_degree;
use kahan_draw::Drawing;
use kahan_draw::answer;
use kahan_draw::picture::{Chart, OrbitExtent, PictureOptions, chart};
use kahan_study::trade::Trade;
use kahan_study::{
    Answer, Axis, ColourColumn, Discover, Observe, Over, Poles, Question, Range, Show, ShowForm, ShownOrbit,
    Study, StudyError,
};
use maud::{Markup, html};

use super::super::command_line::CommandLine;
use super::super::image_options::usual as picture_sheet;
use super::super::picture::Picture;
use super::super::picture::request::{NotedPicture, PictureContent, PictureRequest};
use super::super::picture::starts::{StartSpec, StartSpread};
use crate::printing::{ProgressDisplay, UsageError};

pub(super) struct Field {
    pub(super) words: Vec<String>,
    pub(super) study: Study,
}

pub(super) struct AnsweredQuestion {
    line: CommandLine,
    pub(super) answer: Result<Answer, StudyError>,
}

impl AnsweredQuestion {
    pub(super) fn of(field: &Field, question: Question) -> Self {
        let answer = field.study.ask(&question, &ProgressDisplay::stages());
        AnsweredQuestion { line: CommandLine::asking(&field.words, &question), answer }
    }

    /// Returns the HTML of the answer or of the error message, followed by the command line.
    pub(super) fn html(&self) -> Markup {
        html! {
            @match &self.answer {
                Ok(answer) => (answer::html(answer).expect("pages ask what they show")),
                Err(why) => p.missing { "Left out: " (UsageError::from(why.clone()).message()) },
            }
            (command(&self.line))
        }
    }
}

/// The field and the orbit that the figures show.
pub(super) struct Subject<'a> {
    pub(super) valued: &'a Field,
    /// The field with all parameter values, and with discovered integrals if the user claims none.
    pub(super) kept: &'a Field,
    /// The field with only the values that the user gave.
    pub(super) generic: &'a Field,
    pub(super) variables: &'a [String],
    pub(super) shown: &'a ShownOrbit,
    /// The time for the whole page, in seconds.
    pub(super) seconds: f64,
}

const SECONDS: f64 = 10.0;
const STARTS: usize = 5;
const SEARCH_SHARE: f64 = 0.35;
const POLES_SHARE: f64 = 0.1;
const HEIGHTS_SHARE: f64 = 0.06;
const TRADE_SHARE: f64 = 0.25;

impl Subject<'_> {
    fn one_orbit(&self, steps: u64) -> PictureRequest {
        let ShownOrbit { eps, start, .. } = self.shown;
        PictureRequest::portrait(eps.clone(), vec![StartSpec::Point(start.clone())], steps)
    }

    /// Returns the fraction `share` of the available seconds, rounded to tenths.
    pub(super) fn share(&self, share: f64) -> f64 {
        (10.0 * share * self.seconds).round().max(1.0) / 10.0
    }

    pub(super) fn formulas(&self) -> Markup {
        let asked = Show { form: ShowForm::Latex, jacobian: false };
        AnsweredQuestion::of(self.generic, Question::Show(asked)).html()
    }

    pub(super) fn search(&self) -> AnsweredQuestion {
        // With a fixed degree, the findings do not depend on the speed of the machine.
        let degree = Some(default_degree(self.generic.study.variables().len()));
        let asked = Discover { degree, seconds: self.share(SEARCH_SHARE), ..Discover::default() };
        AnsweredQuestion::of(self.generic, Question::Discover(asked))
    }

    pub(super) fn growth(&self) -> Markup {
        let poles = Poles { seconds: self.share(POLES_SHARE), ..Poles::default() };
        let heights = PictureRequest {
            what: PictureContent::Heights,
            seconds: self.share(HEIGHTS_SHARE),
            ..self.one_orbit(400)
        };
        html! {
            (AnsweredQuestion::of(self.generic, Question::Poles(poles)).html())
            (self.picture("heights", "Heights of an exact orbit", &heights, |_| html! {
                "The logarithmic height of a fraction is about 2.3 times the number of its digits. Heights that grow like a power "
                "of n are drawn over log n, and those that grow exponentially over n: either way they come near a straight line."
            }))
        }
    }

    pub(super) fn orbits(&self) -> Markup {
        let portrait = self.many_orbits(if self.variables.len() == 1 { 200 } else { 4000 });
        let first = &self.variables[0];
        let time =
            PictureRequest { axes: vec!["t".to_owned(), first.clone()], lines: true, ..self.one_orbit(400) };
        html! {
            (self.picture("portrait", "Orbits", &portrait, |_| html! { "Orbits from " (STARTS) " first points." }))
            (self.picture("time", &format!("{first} over time"), &time, |_| html! { "The first orbit; a step takes the time 2ε." }))
            @if self.variables.len() > 2 {
                @let plane = self.plane();
                @let steps = self.crossing_steps();
                @let section = PictureRequest { what: PictureContent::section(&plane, steps), ..self.many_orbits(steps) };
                (self.picture("section", "A section", &section, |visits| html! {
                    "Where the orbits cross " code { (plane) " = 0" } " upwards. " (crossings(visits, self.variables.len()))
                }))
            }
        }
    }

    pub(super) fn dynamics(&self) -> Markup {
        let asked = Observe::new(self.shown.eps.clone(), self.shown.start.clone(), self.steps());
        AnsweredQuestion::of(self.kept, Question::Observe(asked)).html()
    }

    pub(super) fn chart(&self) -> Markup {
        let cells = self.cells();
        let ShownOrbit { eps, start, .. } = self.shown;
        let second = match self.variables {
            [_] => ("eps", [0.0, 2.0 * eps.to_f64()]),
            variables => (&*variables[1], self.range(1)),
        };
        // The first range of a chart varies fastest, but in `Over` the last axis does.
        let axes = [second, (&*self.variables[0], self.range(0))].map(|(name, [low, high])| {
            let range = Range::read(&format!("{}:{}:/{cells}", decimal(low), decimal(high)));
            let range = range.expect("printed numbers make a range");
            Axis { name: name.to_owned(), range }.into()
        });
        let shade = ColourColumn::named("fli").expect("an observable");
        let observe = Observe::new(eps.clone(), start.clone(), 1000);
        let observe = Question::Observe(Observe { observe: vec![shade.observable], ..observe });
        let asked = Over::new(observe, axes.into());
        let found = asked.ask(&self.valued.study, &ProgressDisplay::new((cells * cells) as u64, "orbits"));
        let drawn = found.map(|found| {
            let words = html! {
                "Each cell is an orbit of its own. The fast Lyapunov indicator grows like log n where motion is regular, and like n "
                "where it is chaotic; a cell is empty where its orbit leaves the range of doubles."
            };
            (chart(&Chart::of(&asked, &found, &shade), &PictureOptions::on(picture_sheet())).drawing, Vec::new(), words)
        });
        let line = CommandLine::asking(&self.valued.words, &Question::Over(asked));
        figure("chart", "A chart of stability", &line, drawn.map_err(UsageError::from))
    }

    /// Returns the cheapest settings of `kahan trade` for a horizon of `STEPS` steps.
    pub(super) fn settings(&self) -> Markup {
        const STEPS: f64 = 400.0;
        let horizon = Rational::parse(&decimal(2.0 * self.shown.eps.to_f64() * STEPS));
        let asked = Trade::new(self.shown.start.clone(), horizon.expect("a printed number is one"));
        let asked = Trade { seconds: self.share(TRADE_SHARE), ..asked };
        let asked = AnsweredQuestion::of(self.kept, Question::Trade(asked));
        AnsweredQuestion { line: asked.line.with("--out", "trade.svg"), ..asked }.html()
    }

    fn picture(
        &self,
        id: &str,
        title: &str,
        asked: &PictureRequest,
        words: impl Fn(&[OrbitExtent]) -> Markup,
    ) -> Markup {
        let drawn = asked.drawn(&self.valued.study).and_then(|NotedPicture { picture, notes }| {
            if picture.points == 0 {
                return Err(UsageError::new("there is nothing to be seen: no orbit comes there."));
            }
            Ok((picture.drawing, notes, words(&picture.visits)))
        });
        let asked = PictureRequest { out: format!("{id}.svg").into(), ..asked.clone() };
        let line = Picture::options(&asked, CommandLine::new("picture", &self.valued.words));
        figure(id, title, &line, drawn)
    }

    /// Returns the number of steps for Lyapunov exponents. More variables mean fewer, to save time.
    fn steps(&self) -> u64 {
        let variables = self.variables.len() as u64;
        if variables <= 4 { 20_000 } else { (320_000 / (variables * variables)).max(1000) }
    }

    fn crossing_steps(&self) -> u64 {
        let many = (4.0 / self.variables.len() as f64).min(1.0);
        (5000.0 * many * self.seconds.min(60.0)).max(1000.0) as u64
    }

    fn cells(&self) -> usize {
        let many = (4.0 / self.variables.len() as f64).min(1.0);
        (20.0 * many * self.seconds.min(60.0).sqrt()).max(8.0) as usize
    }

    /// Asks for orbits from points between the initial point and the middle of its orbit.
    fn many_orbits(&self, steps: u64) -> PictureRequest {
        let ShownOrbit { eps, start, extremes, .. } = self.shown;
        let nearer = start.iter().zip(extremes).map(|(start, [low, high])| {
            let (start, middle) = (start.to_f64(), 0.5 * (low + high));
            let near = rounded_to_unit(start + 0.6 * (middle - start), high - low);
            Rational::parse(&near).expect("a printed number is one")
        });
        let at = vec![StartSpec::Line(start.clone(), nearer.collect())];
        let spread = StartSpread { count: Some(STARTS), ..StartSpread::default() };
        PictureRequest { spread, seconds: SECONDS, ..PictureRequest::portrait(eps.clone(), at, steps) }
    }

    /// Returns the formula of a plane through the middle of the range of one variable. This is the
    /// third, or the one with the longest range if the third is nearly constant.
    fn plane(&self) -> String {
        const MOVES: f64 = 1e-3;

        let lengths: Vec<f64> = self.shown.extremes.iter().map(|[low, high]| high - low).collect();
        let longest = (0..lengths.len()).max_by(|&i, &j| lengths[i].total_cmp(&lengths[j])).unwrap_or(2);
        let k = if lengths[2] > MOVES * lengths[longest] { 2 } else { longest };
        let [low, high] = self.shown.extremes[k];
        let (name, middle) = (&self.variables[k], rounded_to_unit(0.5 * (low + high), high - low));
        match middle.strip_prefix('-') {
            Some(size) => format!("{name} + {size}"),
            None if middle == "0" => name.clone(),
            None => format!("{name} - {middle}"),
        }
    }

    /// Returns the range of a variable along the shown orbit, extended by a tenth at both ends.
    fn range(&self, k: usize) -> [f64; 2] {
        let [low, high] = self.shown.extremes[k];
        let room = 0.1 * (high - low).max(0.1 * high.abs().max(low.abs())).max(1e-2 * self.shown.size);
        [low - room, high + room]
    }
}

/// A drawing with notes and an explanation, or the reason why nothing could be drawn.
pub(super) type Figure = Result<(Drawing, Vec<String>, Markup), UsageError>;

pub(super) fn figure(id: &str, title: &str, line: &CommandLine, drawn: Figure) -> Markup {
    html! {
        figure.single id=(id) {
            h3 { (title) }
            @match drawn {
                Ok((drawing, notes, words)) => {
                    div.drawings { (drawing.inline()) }
                    figcaption {
                        p { (words) }
                        @for note in notes { p.data { "Note: " (note) "." } }
                    }
                },
                Err(refusal) => p.missing { "Left out: " (refusal.message()) },
            }
            (command(line))
        }
    }
}

pub(super) fn command(line: &CommandLine) -> Markup {
    html! { pre.command tabindex="0" { code { (line) } } }
}

/// Explains by the numbers of crossings whether a section shows curves or areas.
fn crossings(orbits: &[OrbitExtent], variables: usize) -> Markup {
    const PATTERN: usize = 40;
    /// An orbit counts as periodic if it has this many crossings for each distinct place.
    const PERIODIC_VISITS: usize = 10;

    let of =
        |chosen: fn(&OrbitExtent) -> bool| orbits.iter().filter(|visits| chosen(visits)).collect::<Vec<_>>();
    let none = of(|visits| visits.points == 0).len();
    let seldom = of(|visits| (1..PATTERN).contains(&visits.points)).len();
    let again =
        of(|visits| visits.points >= PATTERN && visits.points >= PERIODIC_VISITS * visits.places.max(1));
    let again: Vec<_> = again.into_iter().filter(|visits| visits.places <= PATTERN / 2).collect();
    let most = again.iter().map(|visits| visits.places).max().unwrap_or_default();
    let many = orbits.len() - none - seldom - again.len();
    let said = |count: usize, one: &str, several: &str| {
        if count == 1 { format!("1 orbit {one}") } else { format!("{count} orbits {several}") }
    };
    html! {
        @if many > 0 {
            (said(many, "crosses", "cross")) " at many places: an orbit on a surface draws curves; a chaotic one fills an "
            "area, or where volumes shrink, a set that may look like pieces of curves. "
            @if variables > 3 { "What is shown is a projection to two variables, in which tori of more dimensions are areas, too. " }
        }
        @if !again.is_empty() {
            (said(again.len(), "comes back", "come back")) " to "
            @if most == 1 { "the same place" } @else { "the same places, " (most) " at most," }
            " again and again, as an orbit on a closed curve does. "
        }
        @if seldom > 0 { (said(seldom, "crosses", "cross")) " fewer than " (PATTERN) " times, too seldom to show a pattern. " }
        @if none > 0 { (said(none, "does not cross it.", "do not cross it.")) }
    }
}

fn rounded_to_unit(value: f64, length: f64) -> String {
    let unit = libm::exp10(libm::log10(length / 100.0).floor());
    let rounded = if unit > 0.0 { (value / unit).round() * unit } else { value };
    decimal(rounded)
}

/// Formats a number with three digits: 12.3, -0.05, 400.
fn decimal(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().expect("a printed float is one");
    if rounded == 0.0 { "0".to_owned() } else { rounded.to_string() }
}
