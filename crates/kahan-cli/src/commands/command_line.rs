//! Command lines that reproduce answers; pages show them under each figure.

use std::fmt;

use clap::{ArgAction, Args, FromArgMatches};
use kahan_study::Study;
use kahan_study::numbers::number;
use serde::Serialize;
use serde_json::{Value, json};

use crate::printing::{Answer, UsageError};

/// A command whose arguments can be converted to its `Question` for `kahan-study`, and back.
pub(crate) trait QuestionCommand: Args + FromArgMatches {
    type Question: PartialEq + Serialize;

    fn read_question(&self) -> Result<(Study, Self::Question), UsageError>;

    /// Appends the options of a question that differ from the defaults.
    fn options(asked: &Self::Question, line: CommandLine) -> CommandLine {
        line.with_changed_options::<Self>(asked)
    }

    fn run(&self) -> Result<Answer, UsageError>;
}

#[derive(Clone, Debug)]
pub(crate) struct CommandLine {
    command: &'static str,
    words: Vec<String>,
}

impl CommandLine {
    pub(crate) fn new(command: &'static str, system: &[String]) -> Self {
        CommandLine { command, words: system.to_vec() }
    }

    /// Appends the options of the command `A` that differ from their defaults. Each field of
    /// `asked` must have the name of its option.
    pub(crate) fn with_changed_options<A: Args>(self, asked: &impl Serialize) -> Self {
        let command = A::augment_args(clap::Command::new(self.command));
        let fields = json!(asked);
        let said = fields.as_object().into_iter().flatten().filter_map(|(name, value)| {
            let argument = command.get_arguments().find(|argument| argument.get_id() == name)?;
            let usual: Vec<&str> =
                argument.get_default_values().iter().filter_map(|of| of.to_str()).collect();
            let takes_all = argument.get_value_delimiter().is_some();
            let is_repeated = matches!(argument.get_action(), ArgAction::Append) && !takes_all;
            let values = match value {
                Value::Array(list) if is_repeated => list.clone(),
                Value::Object(axes) => {
                    axes.iter().map(|(name, range)| json!(format!("{name}={}", option_text(range)))).collect()
                }
                value => vec![value.clone()],
            };
            let option = format!("--{}", argument.get_long()?);
            Some(values.into_iter().map(move |value| (option.clone(), usual.join(","), value)))
        });
        said.flatten().fold(self, |line, (option, usual, value)| match value {
            Value::Null | Value::Bool(false) => line,
            Value::Bool(true) => line.with_flag(&option),
            value => {
                let value = option_text(&value);
                let is_usual =
                    value == usual || number(&value).is_ok_and(|value| number(&usual) == Ok(value));
                if is_usual { line } else { line.with(&option, value) }
            }
        })
    }

    pub(crate) fn with(mut self, option: &str, value: impl ToString) -> Self {
        self.words.extend([option.to_owned(), value.to_string()]);
        self
    }

    pub(crate) fn with_some(self, option: &str, value: Option<impl ToString>) -> Self {
        value.into_iter().fold(self, |line, value| line.with(option, value))
    }

    pub(crate) fn with_flag(mut self, flag: &str) -> Self {
        self.words.push(flag.to_owned());
        self
    }
}

fn option_text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Array(list) => list.iter().map(option_text).collect::<Vec<_>>().join(","),
        other => other.to_string(),
    }
}

impl fmt::Display for CommandLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "kahan {}", self.command)?;
        for word in &self.words {
            let is_plain = |c: char| c.is_ascii_alphanumeric() || "_-+./:=,".contains(c);
            if !word.is_empty() && word.chars().all(is_plain) {
                write!(f, " {word}")?;
            } else {
                write!(f, " '{}'", word.replace('\'', r"'\''"))?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::commands::picture::request::{PictureContent, PictureRequest};
    use crate::commands::picture::starts::{StartSpec, StartSpread};
    use crate::commands::{
        chart::Chart, discover::Discover, dynamics::Dynamics, eval::Eval, heights::Heights, orbit::Orbit,
        periodic::Periodic, picture::Picture, poles::Poles, scan::Scan, section::Section, show::Show,
        trade::Trade, verify::Verify,
    };
    use kahan_algebra::rational::Rational;
    use kahan_dynamics::Need;
    use kahan_study::numbers::ScalarKind;
    use kahan_study::trade;
    use kahan_study::{
        self as study, Axis, Evaluate, Method, Observable, Observe, Question, Range, ShowForm,
    };

    fn read<A: Args + FromArgMatches>(line: &CommandLine) -> A {
        let command = A::augment_args(clap::Command::new(line.command).no_binary_name(true));
        let matches = command.try_get_matches_from(&line.words);
        matches.and_then(|matches| A::from_arg_matches(&matches)).expect("a call")
    }

    /// Checks that the command line of each question parses to that question.
    fn reads_back<C: QuestionCommand>(questions: impl IntoIterator<Item = C::Question>) {
        for asked in questions {
            let line = C::options(&asked, CommandLine::new("", &["lv".to_owned()]));
            let read: C = read(&line);
            assert!(read.read_question().expect("a question").1 == asked, "{line}");
        }
    }

    #[test]
    fn a_call_that_is_read_back_asks_the_same() {
        let rational = Rational::new;
        let (eps, at) = (rational(-1, 10), vec![rational(-1, 2), rational(5, 3)]);
        let through = |name: &str, range: &str| Axis {
            name: name.to_owned(),
            range: Range::read(range).expect("a range"),
        };

        let forms = [ShowForm::Text, ShowForm::Latex, ShowForm::Sympy, ShowForm::Kahan, ShowForm::Plan];
        reads_back::<Show>(forms.map(|form| study::Show { form, jacobian: form == ShowForm::Latex }));
        let plain = Evaluate::new(eps.clone(), at.clone());
        reads_back::<Eval>([Evaluate { scalar: ScalarKind::Dd, ..plain.clone() }, plain]);
        let plain = study::Orbit::new(eps.clone(), at.clone(), 99);
        let (every, scalar, method) = (7, ScalarKind::F32, Method::Rk4);
        reads_back::<Orbit>([
            study::Orbit { every, scalar, method, ..plain.clone() },
            study::Orbit { order: 4, projective: true, transient: 5, ..plain.clone() },
            study::Orbit { order: 8, reembed: true, ..plain.clone() },
            plain,
        ]);
        let plain = Observe::new(eps.clone(), at.clone(), 1000);
        let of = vec![Observable::Last, Observable::Fli];
        reads_back::<Dynamics>([
            Observe {
                order: 8,
                renormalize: 3,
                spectrum: Some(2),
                transient: 11,
                escape: Some(12.5),
                reembed: true,
                observe: of,
                ..plain.clone()
            },
            plain.clone(),
        ]);
        let of = vec![Observable::Escape];
        let asked =
            Observe { observe: of, escape: Some(12.5), transient: 9, eps: rational(1, 1), ..plain.clone() };
        let axes = ["x", "eps"].map(|name| through(name, "1:-1:+-1/40").into()).to_vec();
        let two = study::Over::new(Question::Observe(asked), axes.clone());
        let plain = Observe { observe: vec![Observable::Sali], ..plain };
        reads_back::<Chart>([two, study::Over::new(Question::Observe(plain), axes[..1].to_vec())]);
        let plain = study::Section::new(eps.clone(), at.clone(), 50, "x - 1");
        reads_back::<Section>([
            study::Section {
                direction: kahan_study::Direction::Both,
                crossings: Some(7),
                transient: 3,
                order: 4,
                reembed: true,
                ..plain.clone()
            },
            study::Section {
                eps: None,
                over: ["x", "eps"].map(|name| through(name, "1:2:3").into()).to_vec(),
                carry: true,
                ..plain.clone()
            },
            plain,
        ]);
        reads_back::<Verify>([false, true].map(|mutate| study::Verify { mutate }));
        let plain = study::Heights::new(eps.clone(), at.clone(), 17);
        reads_back::<Heights>([study::Heights { digits: 99, seconds: 0.5, ..plain.clone() }, plain]);
        let other = study::Poles { eps: Some(eps.clone()), steps: 6, seconds: 5.0 };
        reads_back::<Poles>([other, study::Poles::default()]);
        let other = study::Discover { eps: Some(eps), degree: Some(4), seconds: 2.5 };
        reads_back::<Discover>([other, study::Discover::default()]);
        let plain = study::Periodic::new(rational(1, 10), at.clone());
        let over = Some(through("eps", "1:-1:+-1/40"));
        let free = study::Periodic {
            free: Some(study::FreeUnknown::Eps),
            transient: 9,
            period: 300,
            ..plain.clone()
        };
        let along = study::Periodic { eps: None, period: 3, over, ..plain.clone() };
        reads_back::<Periodic>([along, free, plain]);
        let plain = study::Scan::new(vec![through("eps", "-2:2:+1/4")]);
        reads_back::<Scan>([study::Scan { degree: Some(3), seconds: 2.0, ..plain.clone() }, plain]);
        let plain = trade::Trade::new(at.clone(), rational(25, 2));
        let (need, tolerance) = (Need::Integrals, rational(1, 1000));
        reads_back::<Trade>([trade::Trade { need, tolerance, seconds: 1.0, ..plain.clone() }, plain]);

        let plain = PictureRequest::portrait(rational(1, 10), vec![StartSpec::Point(at.clone())], 9);
        let spread = StartSpread { count: Some(3), radius: rational(1, 7), seed: 5 };
        let line =
            vec![StartSpec::Line(at.clone(), vec![rational(1, 1), rational(2, 1)]), StartSpec::Point(at)];
        let windows = vec![("y".to_owned(), [rational(-1, 2), rational(7, 1)])];
        let axes = vec!["t".to_owned(), "y".to_owned()];
        let section =
            PictureRequest { what: PictureContent::section("x - y", 9), seconds: 2.5, ..plain.clone() };
        let counted = study::Section::new(Rational::zero(), Vec::new(), 0, "x - y");
        let counted = study::Section { steps: None, crossings: Some(7), ..counted };
        let counted =
            PictureRequest { what: PictureContent::Section(Box::new(counted)), steps: 0, ..plain.clone() };
        let heights = PictureRequest { what: PictureContent::Heights, ..plain.clone() };
        let diagram = study::Diagram::new(None, Vec::new(), through("eps", "1/10:1:+1/40"), 9);
        let diagram = study::Diagram { transient: 77, ..diagram };
        let of = |diagram: &study::Diagram| PictureRequest {
            what: PictureContent::Over(Box::new(diagram.clone())),
            eps: None,
            steps: diagram.steps.unwrap_or_default(),
            ..plain.clone()
        };
        let over = of(&diagram);
        let plane = Some("x - y".to_owned());
        let crossed = study::Diagram { plane, crossings: Some(5), steps: None, carry: true, ..diagram };
        let crossed = of(&crossed);
        let rich =
            PictureRequest { at: line, spread, axes, windows, lines: true, reembed: true, ..plain.clone() };
        for asked in [section, counted, heights, over, crossed, rich, plain] {
            let line = Picture::options(&asked, CommandLine::new("", &["lv".to_owned()]));
            let read: Picture = read(&line);
            assert!(read.read_question().expect("a picture").1 == asked, "{line}");
        }
    }
}
