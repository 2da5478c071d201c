//! `kahan orbit`: the points of an orbit with their integrals, row by row. Rows are written at
//! once, so memory does not grow with the length of the orbit.

mod over;
mod rows;

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::PossibleValue;
use kahan_algebra::rational::Rational;
use kahan_study::numbers::ScalarKind;
use kahan_study::{Kept, MOST_VARIABLES, Method, Orbit as Question, Paces, Study};
use serde_json::json;

use super::line::Asking;
use crate::printing::{Answer, Npy, Refusal, Sink};
use crate::reading::{Start, Stepping, Transient, one_of, order, scalar, whole};

/// Prints an orbit of a system's map as CSV: n, t = 2 eps n, variables, integrals.
///
/// Where --at is a file of several rows, each is the first point of an orbit: the table has orbit
/// after orbit, and a first column `start` says which, 0, 1, and so on. With --over each start has
/// an orbit for each value, which stands in a column behind it. An orbit that ends early ends
/// alone.
///
/// The integrals are those of the block without `when`, and those `when` what holds for the orbit.
/// A cell is empty where an integral is undefined, or beyond the range of the scalar. Floats are
/// written so that they read back exactly, dd with 32 digits, and the steps are those of the
/// compiled library, bit for bit; parameters are put in after the map is reduced. At a pole (det A
/// = 0), or where floats overflow, the orbit ends: the rows up to there are kept, the place is
/// reported, and the exit status is 1; with --projective it goes on. A negative eps steps back.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan orbit e6 --eps 0.05 --at 1,2,3 --steps 1000 --order 8 --scalar dd
  kahan orbit e3 --eps 1/2 --at 3/7,11/13,23/47 --steps 8 --scalar exact
  kahan orbit e7 --param xi=19/17 --eps 1/2 --at 3/7,1,.5 --steps 1e5 --every 100 --out e7.csv
  kahan orbit --field 'xdot = y; ydot = 6*x^2 - a;' --over a=1:2:5 --dt 0.02 --at 0,1 --steps 100
  kahan orbit --field 'for i in open { x[i]dot = x[i+1]; }' --sites 9 --start x=i --eps 1 --steps 9")]
// --over may give ε.
#[command(mut_group("step", |step| step.required(false)))]
pub(crate) struct Orbit {
    #[command(flatten)]
    start: Start,

    /// How a chain of --sites begins: F.npy, F.csv or formulas of the site i.
    ///
    /// The number of sites may be any. A formula for each array, as in 'x = 1 + 1/2*cos(2*pi*i/n)',
    /// several separated by `;`: there are i from 0 to n - 1, pi, the parameters of the chain, and
    /// sin, cos, tanh, sech, exp, sqrt and more. A file has a row a site, a column an array. Values
    /// of --param may then be formulas or files, too. Beyond 200 variables the rows show the range
    /// of each array.
    #[arg(id = "begin", long = "start", value_name = "S", conflicts_with_all = ["at", "reembed"], requires = "sites")]
    begin: Option<String>,

    /// An orbit for each value of a parameter, eps or coordinate, NAME=FROM:TO:N.
    ///
    /// May be repeated: all combinations are followed, the last range running fastest.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, conflicts_with = "begin")]
    over: Vec<String>,

    /// The number of steps; 0 prints the first point.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(0, MOST))]
    steps: u64,

    #[command(flatten)]
    before: Transient,

    /// The kind of number.
    #[arg(long, value_parser = scalar(), default_value = "f64")]
    scalar: ScalarKind,

    /// The order of the method.
    ///
    /// Order 2 is Kahan's map; orders 4, 6 and 8, over floats only, compose 5, 9 and 17 steps of it
    /// into one. A composition keeps no integral that depends on eps, so the columns are those of
    /// the flow, the claims at eps = 0, which then oscillate about a value.
    #[arg(long, value_name = "P", default_value = "2", value_parser = order())]
    order: u32,

    /// What a step is; each takes the time 2 eps.
    ///
    /// Other methods are there to compare Kahan's map with. `euler` and `rk4` are explicit steps on
    /// the field. `flow` is the solution, by Taylor series in double-double, up to 8 variables. The
    /// integrals of all three are those of the flow, the claims at eps = 0.
    #[arg(long, value_name = "M", value_parser = one_of(&Method::ALL, |of| PossibleValue::new(of.name()).help(of.meaning())), default_value = "kahan")]
    method: Method,

    /// Go on at poles, through points at infinity.
    ///
    /// It goes on, too, where the map brings a whole curve to one point: the orbit is that of the
    /// iterates as rational maps of projective space. An infinite
    /// coordinate is written as inf, and in JSON as null. A coordinate beside it that is not
    /// infinite has no value of its own there, and is empty or null, as integrals are. Near poles
    /// floats are computed in hundreds of digits, so that the way back loses none. The orbit ends
    /// where the map has no value whatever the direction. Up to 8 variables.
    #[arg(long, conflicts_with_all = ["begin", "reembed"])]
    projective: bool,

    #[command(flatten)]
    stepping: Stepping,

    /// Print every K-th point only: n = 0, K, 2K, ….
    #[arg(long, value_name = "K", default_value = "1", allow_hyphen_values = true, value_parser = whole(1, MOST))]
    every: u64,

    /// Write the table to F.csv, or to F.npy the states of a chain.
    ///
    /// The file appears when it is complete. With --start, F.npy gets an array that has a row a
    /// point, of the sites, or of the sites and the arrays; the table is printed all the same.
    #[arg(long, value_name = "F")]
    out: Option<PathBuf>,

    /// Print one JSON object; exact numbers are strings p/q, floats are numbers.
    ///
    /// Numbers of dd have 32 digits. With --out the rows are in the file only. `note` says that
    /// steps do not resolve fast components, where that is so at half of 16 points of the orbit.
    ///
    /// `runs_as` tells whether floats ran as machine code or
    /// were interpreted, as on other processors and in fields too large for a straight line.
    #[arg(long)]
    json: bool,
}

/// Rows count steps in an `i64`.
const MOST: u64 = i64::MAX as u64;

impl Asking for Orbit {
    type Question = Question;

    fn asked(&self) -> Result<(Study, Question), Refusal> {
        let (study, at, eps) = self.start.study()?;
        Ok((study, self.question(eps, at)))
    }

    fn run(&self) -> Result<Answer, Refusal> {
        if let Some(start) = &self.begin {
            return self.chain(start);
        }
        if self.out.as_deref().is_some_and(is_array) {
            return Err(Refusal::new(
                "--out F.npy is for the states of a chain, with --start; write --out F.csv",
            ));
        }
        if !self.over.is_empty() {
            return self.over();
        }
        let (study, starts, eps) = self.start.starts()?;
        let asked: Vec<Question> = starts.into_iter().map(|at| self.question(eps.clone(), at)).collect();
        let study = asked[0].study(&study)?;
        // Begin all orbits before the first row is written, as one of them may be refused.
        let begun = asked.iter().map(|asked| asked.begin(&study)).collect::<Result<Vec<_>, _>>()?;
        let head = json!(begun[0].head);
        let (names, has_places) = (["start".to_owned()], begun.len() > 1);
        let place =
            |start: usize| has_places.then(|| Kept::Integer(vec![start as i64])).into_iter().collect();
        let orbits = begun.into_iter().enumerate().map(|(start, orbit)| (place(start), orbit));
        let names = if has_places { &names[..] } else { &[] };
        self.write(head, names, orbits, |orbit, table, watch| Ok(orbit.rows(0..u64::MAX, table, watch)))
    }
}

impl Orbit {
    fn question(&self, eps: Rational, at: Vec<Rational>) -> Question {
        let Orbit { before, steps, every, scalar, order, method, projective, stepping, .. } = *self;
        let (transient, reembed) = (before.transient, stepping.reembed);
        Question { eps, at, transient, steps, every, scalar, order, method, projective, reembed }
    }

    fn chain(&self, start: &str) -> Result<Answer, Refusal> {
        let has_numbers = self.scalar != ScalarKind::F64 || self.order != 2;
        if has_numbers || self.method != Method::Kahan {
            let what = if has_numbers { " in f64: leave --scalar and --order" } else { ": leave --method" };
            return Err(Refusal::new(format!(
                "--start is for chains, which are stepped by Kahan's map{what} out"
            )));
        }
        let array = self.out.as_deref().filter(|path| is_array(path));
        let has_table_file = self.out.is_some() && array.is_none();
        let most_names = if has_table_file { usize::MAX } else { MOST_VARIABLES };
        let mut chain = self.start.chain(start, most_names)?;
        let arrays = chain.lattice.arrays().len();
        let sizes = if arrays == 1 { vec![chain.sites] } else { vec![chain.sites, arrays] };
        let array = array.map(|path| Npy::new(Sink::file(path, "--out")?, sizes).map_err(Refusal::from));
        let mut array = array.transpose()?;
        let paces = Paces::new(self.before.transient, self.steps, self.every);
        let paces = paces.expect("--every is 1 or more");
        let head = chain.head(paces);
        self.write(json!(head), &[], [(Vec::new(), &mut chain)].into_iter(), |chain, table, watch| {
            // The file must be complete even if the reader of the table has gone.
            table.outlive_reader(array.is_some());
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
