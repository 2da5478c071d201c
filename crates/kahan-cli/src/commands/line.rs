//! Calls of the command, as one types them: what a page shows under a figure is what made it.

use std::fmt;

use clap::{Args, Command, FromArgMatches};
use kahan_algebra::rational::Rational;
use kahan_study::trade::Trade;
use kahan_study::{Discover, Evaluate, Heights, Observe, Periodic, Poles, Question, Scan, Section};

use crate::printing::Refusal;

/// A call of one of the commands.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    command: &'static str,
    words: Vec<String>,
}

impl Line {
    /// A command with the words that name a system.
    pub(crate) fn new(command: &'static str, system: &[String]) -> Self {
        Line { command, words: system.to_vec() }
    }

    /// The call that asks a question about the system that these words name; what is as usual is
    /// left out.
    pub(crate) fn asking(system: &[String], question: &Question) -> Self {
        let point = |at: &[Rational]| at.iter().map(ToString::to_string).collect::<Vec<_>>().join(",");
        match question {
            Question::Evaluate(asked) => {
                let Evaluate { eps, at, scalar } = asked;
                let usual = Evaluate::new(eps.clone(), at.clone());
                let line = Line::new("eval", system).with("--eps", eps).with("--at", point(at));
                line.unless(*scalar == usual.scalar, "--scalar", scalar.name())
            }
            Question::Observe(Observe { eps, at, steps, order, every, escape }) => {
                let usual = Observe::new(eps.clone(), at.clone(), *steps);
                let line = Line::new("dynamics", system).with("--eps", eps).with("--at", point(at));
                let line = line.with("--steps", steps).unless(*order == usual.order, "--order", order);
                let line = line.unless(*every == usual.every, "--every", every);
                line.unless(*escape == usual.escape, "--escape", escape)
            }
            Question::Section(Section { eps, at, steps, plane, side, points }) => {
                let usual = Section::new(eps.clone(), at.clone(), *steps, plane.clone());
                let line = Line::new("section", system).with("--eps", eps).with("--at", point(at));
                let line = line.with("--plane", plane).with("--steps", steps);
                let line = line.unless(*side == usual.side, "--direction", side.name());
                line.unless(*points == usual.points, "--points", points)
            }
            Question::Periodic(Periodic { eps, at, period, over }) => {
                let line = Line::new("periodic", system).with_some("--eps", eps.as_ref());
                let line = line.with("--at", point(at)).unless(*period == 1, "--period", period);
                line.with_some("--over", over.as_ref().map(|axis| format!("{}={}", axis.name, axis.range)))
            }
            Question::Heights(Heights { eps, at, steps, max_digits, seconds }) => {
                let usual = Heights::new(eps.clone(), at.clone(), *steps);
                let line = Line::new("heights", system).with("--eps", eps).with("--at", point(at));
                let line = line.with("--steps", steps);
                let line = line.unless(*max_digits == usual.max_digits, "--max-digits", max_digits);
                line.unless(*seconds == usual.seconds, "--seconds", format!("{seconds:?}"))
            }
            Question::Poles(Poles { eps, steps, seconds }) => {
                let usual = Poles::default();
                let line = Line::new("poles", system).with_some("--eps", eps.as_ref());
                let line = line.unless(*steps == usual.steps, "--steps", steps);
                line.unless(*seconds == usual.seconds, "--seconds", format!("{seconds:?}"))
            }
            Question::Discover(Discover { eps, degree, seconds }) => {
                let line = Line::new("discover", system).with_some("--eps", eps.as_ref());
                let line = line.with_some("--degree", degree.as_ref());
                line.unless(*seconds == Discover::default().seconds, "--seconds", format!("{seconds:?}"))
            }
            Question::Scan(Scan { eps, axes, degree, seconds }) => {
                let line = Line::new("scan", system).with_some("--eps", eps.as_ref());
                let line = axes.iter().fold(line, |line, axis| match axis.name.as_str() {
                    "eps" => line.with("--eps", &axis.range),
                    name => line.with("--param", format!("{name}={}", axis.range)),
                });
                let line = line.with_some("--degree", degree.as_ref());
                line.unless(*seconds == Scan::new(Vec::new()).seconds, "--seconds", format!("{seconds:?}"))
            }
            Question::Trade(Trade { at, horizon, need, tolerance, seconds }) => {
                let usual = Trade::new(at.clone(), horizon.clone());
                let line = Line::new("trade", system).with("--at", point(at)).with("--horizon", horizon);
                let line = line.unless(*need == usual.need, "--need", "integrals");
                let line = line.unless(*tolerance == usual.tolerance, "--tolerance", tolerance);
                line.unless(*seconds == usual.seconds, "--seconds", format!("{seconds:?}"))
            }
        }
    }

    /// With one more option.
    pub(crate) fn with(mut self, option: &str, value: impl ToString) -> Self {
        self.words.extend([option.to_owned(), value.to_string()]);
        self
    }

    /// With one more option where it has a value.
    fn with_some(self, option: &str, value: Option<impl ToString>) -> Self {
        value.into_iter().fold(self, |line, value| line.with(option, value))
    }

    /// With one more option unless it is as usual.
    fn unless(self, is_usual: bool, option: &str, value: impl ToString) -> Self {
        if is_usual { self } else { self.with(option, value) }
    }

    /// With a flag.
    pub(crate) fn with_flag(mut self, flag: &str) -> Self {
        self.words.push(flag.to_owned());
        self
    }

    /// What the command makes of these words.
    pub(crate) fn read<A: Args + FromArgMatches>(&self) -> Result<A, Refusal> {
        let command = A::augment_args(Command::new(self.command).no_binary_name(true));
        let matches = command.try_get_matches_from(&self.words);
        let read = matches.and_then(|matches| A::from_arg_matches(&matches));
        read.map_err(|error| Refusal::new(error.to_string().trim_start_matches("error: ")))
    }
}

impl fmt::Display for Line {
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
    use super::super::{discover, dynamics, eval, heights, periodic, poles, scan, section, trade};
    use super::*;
    use kahan_core::Need;
    use kahan_study::numbers::ScalarKind;
    use kahan_study::{Axis, Range, Side};

    #[test]
    fn a_call_that_is_read_back_asks_the_same() {
        let rational = Rational::new;
        let lv = ["lv".to_owned()];
        let call = |question: &Question| Line::asking(&lv, question);
        let (eps, at) = (rational(-1, 10), vec![rational(-1, 2), rational(5, 3)]);

        let plain = Evaluate::new(eps.clone(), at.clone());
        for asked in [Evaluate { scalar: ScalarKind::Dd, ..plain.clone() }, plain] {
            let line = call(&Question::Evaluate(asked.clone()));
            let read: eval::Eval = line.read().expect("a call");
            assert_eq!(read.asked().expect("a question").1, asked, "{line}");
        }
        let plain = Observe::new(eps.clone(), at.clone(), 1000);
        for asked in [Observe { order: 8, every: 3, escape: 12.5, ..plain.clone() }, plain] {
            let line = call(&Question::Observe(asked.clone()));
            let read: dynamics::Dynamics = line.read().expect("a call");
            assert_eq!(read.asked().expect("a question").1, asked, "{line}");
        }
        let plain = Section::new(eps.clone(), at.clone(), 50, "x - 1");
        for asked in [Section { side: Side::Both, points: 7, ..plain.clone() }, plain] {
            let line = call(&Question::Section(asked.clone()));
            let read: section::Section = line.read().expect("a call");
            assert_eq!(read.asked().expect("a question").1, asked, "{line}");
        }
        let plain = Heights::new(eps.clone(), at.clone(), 17);
        for asked in [Heights { max_digits: 99, seconds: 0.5, ..plain.clone() }, plain] {
            let line = call(&Question::Heights(asked.clone()));
            let read: heights::Heights = line.read().expect("a call");
            assert_eq!(read.asked().expect("a question").1, asked, "{line}");
        }
        for asked in [Poles { eps: Some(eps.clone()), steps: 6, seconds: 5.0 }, Poles::default()] {
            let line = call(&Question::Poles(asked.clone()));
            let read: poles::Poles = line.read().expect("a call");
            assert_eq!(read.asked().expect("a question").1, asked, "{line}");
        }
        let fixed = Discover { eps: Some(eps), degree: Some(4), seconds: 2.5 };
        for asked in [fixed, Discover::default()] {
            let line = call(&Question::Discover(asked.clone()));
            let read: discover::Discover = line.read().expect("a call");
            assert_eq!(read.asked().expect("a question").1, asked, "{line}");
        }
        let through = |name: &str, range: &str| Axis {
            name: name.to_owned(),
            range: Range::read(range).expect("a range"),
        };
        let plain = Periodic::new(rational(1, 10), at.clone());
        let along =
            Periodic { eps: None, period: 3, over: Some(through("eps", "1:-1:+-1/40")), ..plain.clone() };
        for asked in [along, plain] {
            let line = call(&Question::Periodic(asked.clone()));
            let read: periodic::Periodic = line.read().expect("a call");
            assert_eq!(read.asked().expect("a question").1, asked, "{line}");
        }
        let plain = Scan::new(vec![through("eps", "-2:2:+1/4")]);
        for asked in [Scan { degree: Some(3), seconds: 2.0, ..plain.clone() }, plain] {
            let line = call(&Question::Scan(asked.clone()));
            let read: scan::Scan = line.read().expect("a call");
            assert_eq!(read.asked().expect("a question").1, asked, "{line}");
        }
        let plain = Trade::new(at, rational(25, 2));
        let other =
            Trade { need: Need::Integrals, tolerance: rational(1, 1000), seconds: 1.0, ..plain.clone() };
        for asked in [other, plain] {
            let line = call(&Question::Trade(asked.clone()));
            let read: trade::Trade = line.read().expect("a call");
            assert_eq!(read.asked().expect("a question").1, asked, "{line}");
        }
    }
}
