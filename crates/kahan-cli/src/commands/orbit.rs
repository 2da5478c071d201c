//! The command `kahan orbit`, which prints the points of an orbit while the orbit is computed.

mod over;
mod rows;

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::PossibleValue;
use kahan_algebra::rational::Rational;
use kahan_study::numbers::ScalarKind;
use kahan_study::{MOST_VARIABLES, Method, Orbit as Question, RowSchedule, StoredColumn, Study};
use serde_json::json;

use super::command_line::QuestionCommand;
use crate::printing::{Answer, Npy, OutputStream, UsageError};
use crate::reading::{Rounding, Start, Stepping, Transient, one_of, order, scalar, whole};

/// Prints an orbit of a system's map as CSV: step n, time t = 2 eps n, variables, integrals.
///
/// If --at is a file with several rows, each row is an initial point. The table lists one orbit
/// after the other, and its first column `start` holds the number of the row, from 0. --over
/// computes an orbit for each initial point and each value; the value stands in a column of its
/// own. An orbit that ends early does not end the others.
///
/// The integrals are the field's claims without the condition `when`, and those whose condition the
/// parameters and eps fulfil. A cell is empty where an integral is undefined or overflows. Floats
/// have enough digits to be read back exactly (dd: 32), and the steps agree bit for bit with those
/// of the Rust library. Parameters are inserted after the map is reduced to lowest terms.
///
/// At a pole (det A = 0), or where floats overflow, the orbit ends: the rows so far are printed, a
/// message names the step, and the exit status is 1. With --projective the orbit continues through
/// the pole. A negative eps steps back in time.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan orbit e6 --eps 0.05 --at 1,2,3 --steps 1000 --order 8 --scalar dd
  kahan orbit e3 --eps 1/2 --at 3/7,11/13,23/47 --steps 8 --scalar exact
  kahan orbit e7 --param xi=19/17 --eps 1/2 --at 3/7,1,.5 --steps 1e5 --every 100 --out e7.csv
  kahan orbit --field 'xdot = y; ydot = 6*x^2 - a;' --over a=1:2:5 --dt 0.02 --at 0,1 --steps 100
  kahan orbit --field 'for i in open { x[i]dot = x[i+1]; }' --sites 9 --start x=i --eps 1 --steps 9")]
// `--eps` is optional, because --over may give ε.
#[command(mut_group("step", |step| step.required(false)))]
pub(crate) struct Orbit {
    #[command(flatten)]
    start: Start,

    /// Initial values of a chain: F.npy, F.csv or formulas in the site i.
    ///
    /// The chain may have any number of sites. Give a formula for each array, as in 'x = 1 +
    /// 1/2*cos(2*pi*i/n)', separated by `;`. Formulas may use i (0 to n - 1), n, pi, the parameters
    /// of the chain, and functions such as sin, cos, tanh, sech, exp and sqrt. A file has a row per
    /// site and a column per array. Values of --param may be formulas or files as well. For more
    /// than 200 variables, the rows show the range of each array.
    #[arg(id = "begin", long = "start", value_name = "S", conflicts_with_all = ["at", "reembed", "fused"], requires = "sites")]
    begin: Option<String>,

    /// One orbit for each value of a parameter, eps or variable: NAME=FROM:TO:N.
    ///
    /// If it is repeated, all combinations of values are computed, and the last range changes
    /// fastest.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, conflicts_with = "begin")]
    over: Vec<String>,

    /// The number of steps; 0 prints the initial point only.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(0, MAX_STEPS))]
    steps: u64,

    #[command(flatten)]
    before: Transient,

    /// The number type.
    #[arg(long, value_parser = scalar(), default_value = "f64")]
    scalar: ScalarKind,

    /// The order of the method.
    ///
    /// Order 2 is Kahan's map. Orders 4, 6 and 8 are compositions of 5, 9 and 17 of its steps, in
    /// floats only. They do not preserve integrals that depend on eps. Their columns therefore show
    /// the integrals of the flow (the claims at eps = 0), which oscillate.
    #[arg(long, value_name = "P", default_value = "2", value_parser = order())]
    order: u32,

    /// The method.
    ///
    /// Each step advances the time by 2 eps. The other methods serve for comparison with Kahan's
    /// map. `euler` and `rk4` are explicit methods. `flow` is the exact solution, by Taylor series
    /// in double-double arithmetic, for up to 8 variables. For all three, the integrals are those
    /// of the flow (the claims at eps = 0).
    #[arg(long, value_name = "M", value_parser = one_of(&Method::ALL, |of| PossibleValue::new(of.name()).help(of.meaning())), default_value = "kahan")]
    method: Method,

    /// Continue through poles, by points at infinity.
    ///
    /// The orbit is computed in projective space, and also continues where the map sends a whole
    /// curve to one point. An infinite coordinate is written as inf, and as null in JSON. At such a
    /// point, coordinates that are not infinite have no value: they are left empty or null, and so
    /// are integrals. Near poles, floats are computed with hundreds of digits, so that no accuracy
    /// is lost. The orbit ends where the limit depends on the direction of approach. Up to 8
    /// variables.
    #[arg(long, conflicts_with_all = ["begin", "reembed", "fused"])]
    projective: bool,

    #[command(flatten)]
    stepping: Stepping,

    #[command(flatten)]
    rounding: Rounding,

    /// Print only every K-th point: n = 0, K, 2K, ….
    #[arg(long, value_name = "K", default_value = "1", allow_hyphen_values = true, value_parser = whole(1, MAX_STEPS))]
    every: u64,

    /// Write the table to F.csv, or the states of a chain to F.npy.
    ///
    /// The file appears when it is complete. F.npy needs --start. Its array has a row per point,
    /// with the sites, or the sites and the arrays, as further dimensions. The table is then
    /// printed as well.
    #[arg(long, value_name = "F")]
    out: Option<PathBuf>,

    /// Print one JSON object: exact numbers as strings p/q, floats as numbers.
    ///
    /// Numbers of dd have 32 digits. With --out, the rows are in the file only. `note` warns if the
    /// steps do not resolve fast components at half of 16 sampled points.
    ///
    /// `runs_as` tells whether floats were computed by machine code or by an interpreter. The
    /// interpreter runs on processors without support, and for very large fields.
    #[arg(long)]
    json: bool,
}

/// The largest number of steps. Tables store step numbers as `i64`.
const MAX_STEPS: u64 = i64::MAX as u64;

impl QuestionCommand for Orbit {
    type Question = Question;

    fn read_question(&self) -> Result<(Study, Question), UsageError> {
        let (study, at, eps) = self.start.study()?;
        Ok((self.stepped(&study)?, self.question(eps, at)))
    }

    fn run(&self) -> Result<Answer, UsageError> {
        if let Some(start) = &self.begin {
            return self.chain(start);
        }
        if self.out.as_deref().is_some_and(is_array) {
            return Err(UsageError::new(
                "--out F.npy is for the states of a chain, with --start; write --out F.csv",
            ));
        }
        if !self.over.is_empty() {
            return self.over();
        }
        let (study, starts, eps) = self.start.starts()?;
        let asked: Vec<Question> = starts.into_iter().map(|at| self.question(eps.clone(), at)).collect();
        let study = asked[0].study(&self.stepped(&study)?)?;
        // All orbits are checked before rows are written, so that no partial table is left.
        let begun = asked.iter().map(|asked| asked.begin(&study)).collect::<Result<Vec<_>, _>>()?;
        let head = json!(begun[0].head);
        let (names, has_places) = (["start".to_owned()], begun.len() > 1);
        let place = |start: usize| {
            has_places.then(|| StoredColumn::Integer(vec![start as i64])).into_iter().collect()
        };
        let orbits = begun.into_iter().enumerate().map(|(start, orbit)| (place(start), orbit));
        let names = if has_places { &names[..] } else { &[] };
        self.write(head, names, orbits, |orbit, table, watch| Ok(orbit.rows(0..u64::MAX, table, watch)))
    }
}

impl Orbit {
    /// Returns the field, with fused steps if --fused is given.
    fn stepped(&self, study: &Study) -> Result<Study, UsageError> {
        let fused = self.rounding.fused;
        if fused && (self.method != Method::Kahan || self.scalar == ScalarKind::Exact) {
            return Err(UsageError::new(
                "--fused is for steps of Kahan's map in floats: leave --method and --scalar exact out",
            ));
        }
        Ok(study.fusing(fused)?)
    }

    fn question(&self, eps: Rational, at: Vec<Rational>) -> Question {
        let Orbit { before, steps, every, scalar, order, method, projective, stepping, .. } = *self;
        let (transient, reembed) = (before.transient, stepping.reembed);
        Question { eps, at, transient, steps, every, scalar, order, method, projective, reembed }
    }

    fn chain(&self, start: &str) -> Result<Answer, UsageError> {
        let has_numbers = self.scalar != ScalarKind::F64 || self.order != 2;
        if has_numbers || self.method != Method::Kahan {
            let what = if has_numbers { " in f64: leave --scalar and --order" } else { ": leave --method" };
            return Err(UsageError::new(format!(
                "--start is for chains, which are stepped by Kahan's map{what} out"
            )));
        }
        let array = self.out.as_deref().filter(|path| is_array(path));
        let has_table_file = self.out.is_some() && array.is_none();
        let most_names = if has_table_file { usize::MAX } else { MOST_VARIABLES };
        let mut chain = self.start.chain(start, most_names)?;
        let arrays = chain.lattice.arrays().len();
        let sizes = if arrays == 1 { vec![chain.sites] } else { vec![chain.sites, arrays] };
        let array =
            array.map(|path| Npy::new(OutputStream::file(path, "--out")?, sizes).map_err(UsageError::from));
        let mut array = array.transpose()?;
        let paces = RowSchedule::new(self.before.transient, self.steps, self.every);
        let paces = paces.expect("--every is 1 or more");
        let head = chain.head(paces);
        self.write(json!(head), &[], [(Vec::new(), &mut chain)].into_iter(), |chain, table, watch| {
            // The array must be complete, even if the reader of the table closes the pipe.
            table.continue_without_reader(array.is_some());
            let mut written = Ok(());
            let see = &mut |state: &[f64]| {
                written = array.as_mut().map_or(Ok(()), |array| array.row(state));
                if written.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            };
            let end = chain.rows(paces, 0..u64::MAX, table, see, watch);
            written?;
            array.take().map_or(Ok(()), Npy::finish)?;
            Ok(end)
        })
    }
}

fn is_array(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == "npy")
}
