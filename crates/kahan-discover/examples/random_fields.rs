//! Proves findings of `discover` for random fields a second time, by expansion over ℚ. Findings
//! that are too long are proved modulo primes.
//!
//! The second proof shares neither primes nor random points with `discover`.
//! `cargo run --release -p kahan-discover --example random_fields -- --help`

#[path = "literature/clock.rs"]
mod clock;

use std::process::ExitCode;

use clap::Parser;
use clock::Clock;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::prove::prove_by_normal_form;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::{lexer, read, read_unproved};
use kahan_discover::{Options, discover};

/// Proves the findings of `discover` for random fields a second time, by expansion over ℚ.
///
/// The fields have two to four variables, few terms and small whole coefficients; one field in
/// three has parameters. One third of the fields have random terms, one third are Lotka-Volterra
/// fields, and one third are a constant antisymmetric matrix times the gradient of a cubic. The
/// exit status is 1 if a finding is false.
#[derive(Parser, Debug)]
#[command(after_help = "\
Examples:
  cargo run --release -p kahan-discover --example random_fields
  cargo run --release -p kahan-discover --example random_fields -- --fields 100 --seconds 2 --seed 7")]
struct Arguments {
    /// The number of fields.
    #[arg(long, value_name = "N", default_value_t = 2000)]
    fields: u64,

    /// The time limit for the search in each field, in seconds.
    #[arg(long, value_name = "S", default_value_t = 0.3)]
    seconds: f64,

    /// The seed of the random fields.
    #[arg(long, value_name = "SEED", default_value_t = 1)]
    seed: u64,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    assert!(
        proved_again("xdot = y; ydot = -x;", "integral H = x^2 - y^2;").is_none(),
        "a false claim is found out"
    );
    let mut random = SplitMix64::new(arguments.seed);
    let [mut without_map, mut with_findings, mut expanded, mut modular, mut untrue] = [0; 5];
    for index in 0..arguments.fields {
        let field = field(index, &mut random);
        let system = read(&lexer::lex(&field).tokens).system().expect("a field is read");
        let clock = Clock::start();
        let options = Options { seconds: arguments.seconds, ..Options::default() };
        without_map += u64::from(discover(&system, &options, &clock).is_err());
        let (_, findings) = clock.stop();
        with_findings += u64::from(!findings.is_empty());
        let mut block = field.clone();
        for (_, finding) in findings {
            let before = if finding.kind == ClaimKind::Drift { &block } else { &field };
            match proved_again(before, &finding.text) {
                Some(Proved::ByExpansion) => expanded += 1,
                Some(Proved::ModuloPrimes) => modular += 1,
                None => {
                    untrue += 1;
                    println!("FALSE: {field} {finding}");
                }
            }
            if matches!(finding.kind, ClaimKind::Integral | ClaimKind::Drift) {
                block = format!("{block} {}", finding.text);
            }
        }
        if (index + 1) % 100 == 0 {
            eprintln!("{} fields, {} findings, {untrue} false", index + 1, expanded + modular + untrue);
        }
    }
    println!("{} fields, of which {without_map} have no map", arguments.fields);
    println!("{} findings of {with_findings} fields", expanded + modular + untrue);
    println!("{expanded} proved by expansion over the rationals");
    println!("{modular} too long to be expanded, proved modulo other primes and at other points");
    println!("{untrue} false");
    if untrue == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

enum Proved {
    ByExpansion,
    ModuloPrimes,
}

/// Proves a claim by expansion, or modulo primes if the expansion has too many terms. Returns
/// `None` if the claim is false.
fn proved_again(before: &str, claim: &str) -> Option<Proved> {
    let block = format!("{before} {claim}");
    let system = read_unproved(&lexer::lex(&block).tokens).system().ok()?;
    match prove_by_normal_form(&system, system.claims.last()?) {
        Some(holds) => holds.then_some(Proved::ByExpansion),
        // This text differs from that in `discover`, so `read` uses other primes and points.
        None => read(&lexer::lex(&block).tokens).system().ok().map(|_| Proved::ModuloPrimes),
    }
}

const STATES: [&str; 4] = ["x", "y", "z", "w"];
const PARAMETERS: [&str; 2] = ["a", "b"];

#[derive(Clone)]
struct Term {
    coefficient: i64,
    parameter: Option<&'static str>,
    powers: [i64; 4],
}

impl Term {
    fn draw(n: u64, factors: usize, has_parameters: bool, random: &mut SplitMix64) -> Self {
        let sizes = [-3, -2, -1, -1, 1, 1, 2, 3];
        let parameter = has_parameters && random.below(3) == 0;
        let mut powers = [0; 4];
        for _ in 0..factors {
            let state = random.below(n + 1) as usize;
            if state < n as usize {
                powers[state] += 1;
            }
        }
        Term {
            coefficient: sizes[random.below(8) as usize],
            parameter: parameter.then(|| PARAMETERS[random.below(2) as usize]),
            powers,
        }
    }

    fn derivative(&self, state: usize, factor: i64) -> Self {
        let mut term = self.clone();
        term.coefficient *= factor * self.powers[state];
        term.powers[state] -= 1;
        term
    }

    fn text(&self) -> String {
        let powers = (0..4).flat_map(|state| (0..self.powers[state]).map(move |_| STATES[state]));
        let names = self.parameter.into_iter().chain(powers);
        names.fold(format!("({})", self.coefficient), |text, name| format!("{text}*{name}"))
    }
}

fn field(index: u64, random: &mut SplitMix64) -> String {
    let n = 2 + index % 3;
    let has_parameters = random.below(3) == 0;
    let terms = |count: u64, factors: usize, random: &mut SplitMix64| -> Vec<Term> {
        (0..1 + random.below(count)).map(|_| Term::draw(n, factors, has_parameters, random)).collect()
    };
    let states = 0..n as usize;
    let components: Vec<Vec<Term>> = match index / 3 % 3 {
        0 => states.map(|_| terms(3, 2, random)).collect(),
        1 => {
            let with_state = |state: usize, mut term: Term| {
                term.powers[state] += 1;
                term
            };
            let row = |state| terms(3, 1, random).into_iter().map(|term| with_state(state, term)).collect();
            states.map(row).collect()
        }
        _ => {
            let energy = terms(4, 3, random);
            let mut matrix = [[0; 4]; 4];
            for (row, column) in states.clone().flat_map(|row| (0..row).map(move |column| (row, column))) {
                let entry = random.below(4) as i64 - 1;
                (matrix[row][column], matrix[column][row]) = (entry, -entry);
            }
            let row = |row: usize| {
                let column = |column: usize| {
                    energy.iter().map(move |term| term.derivative(column, matrix[row][column]))
                };
                states.clone().flat_map(column).filter(|term| term.coefficient != 0).collect()
            };
            states.clone().map(row).collect()
        }
    };
    let component = |(terms, state): (&Vec<Term>, &str)| {
        let terms: Vec<String> = terms.iter().map(Term::text).collect();
        let sum = if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") };
        format!("{state}dot = {sum};")
    };
    components.iter().zip(STATES).map(component).collect::<Vec<_>>().join(" ")
}
