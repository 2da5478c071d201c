//! Compares findings of `discover` with published results, one row for each case.
//!
//! `cargo run --release -p kahan-discover --example literature -- --help`

mod case;
mod clock;
mod outcome;

use std::path::PathBuf;
use std::process::ExitCode;

use case::Case;
use clap::Parser;
use outcome::Outcome;

const CASES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/literature/cases.jsonl");

/// Compares the findings of `discover` with published results, case by case.
///
/// A case is a JSON object on a line of its own, with `name`, `source` and `field`. `params` fixes
/// parameters. `known` holds the published facts. The findings must equal `independent_integrals`
/// and `growth`. They must include all `bracket_ranks`, and at least as many `densities` and
/// `drifts`. The search must end within `seconds`. `shortest` lists claims in their shortest known
/// form: each is proved, and at least as many claims of each kind must be found. `limit` names the
/// reason why a known fact is out of reach. `comment` is ignored.
///
/// A row shows the numbers of independent and of printed integrals, the growth of degrees, the
/// numbers of densities and drifts, and the ranks of the brackets. Then follow two times in
/// seconds: until the last finding, and of the whole search. The last entry is the length of the
/// printed claims divided by that of `shortest`, both without spaces and names. The exit status is
/// 1 if a case disagrees.
#[derive(Parser, Debug)]
#[command(after_help = "\
Examples:
  cargo run --release -p kahan-discover --example literature
  cargo run --release -p kahan-discover --example literature -- --only weierstrass --only e6
  cargo run --release -p kahan-discover --example literature -- --seconds 10 cases.jsonl")]
struct Arguments {
    /// The file of cases. The default is `examples/literature/cases.jsonl` in this crate.
    #[arg(default_value = CASES, hide_default_value = true)]
    file: PathBuf,

    /// The time limit for the search in each case, in seconds.
    #[arg(long, value_name = "S", default_value_t = 60.0)]
    seconds: f64,

    /// Compare only the case of this name; may be repeated.
    #[arg(long, value_name = "NAME")]
    only: Vec<String>,

    /// Print the claims that are found.
    #[arg(long)]
    found: bool,
}

fn main() -> ExitCode {
    match compared(&Arguments::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

/// Prints a row per case. Returns whether every case agrees with known facts or has a `limit`.
fn compared(arguments: &Arguments) -> Result<bool, String> {
    let path = arguments.file.display();
    let text = std::fs::read_to_string(&arguments.file).map_err(|error| format!("{path}: {error}"))?;
    let lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    let cases = lines.map(|(row, line)| Case::read(line).map_err(|why| format!("{path}:{}: {why}", row + 1)));
    let mut cases = cases.collect::<Result<Vec<Case>, String>>()?;
    if let Some(name) = arguments.only.iter().find(|name| cases.iter().all(|case| case.name != **name)) {
        return Err(format!("no case of {path} is called `{name}`"));
    }
    cases.retain(|case| arguments.only.is_empty() || arguments.only.contains(&case.name));
    println!("{}", Outcome::HEAD);
    let [mut agree, mut limited, mut disagree] = [0; 3];
    let (mut ratios, mut with_shortest) = (Vec::new(), 0);
    for case in &cases {
        let outcome = Outcome::of(case, arguments.seconds);
        println!("{outcome}");
        if arguments.found {
            outcome.printed.iter().for_each(|claim| println!("    {claim}"));
        }
        match (outcome.differences.is_empty(), &case.limit) {
            (true, _) => agree += 1,
            (false, Some(_)) => limited += 1,
            (false, None) => disagree += 1,
        }
        with_shortest += usize::from(!case.shortest.is_empty());
        ratios.extend(outcome.ratio);
    }
    println!("\n{} cases: {agree} agree, {limited} have a known limit, {disagree} disagree", cases.len());
    if with_shortest > 0 {
        ratios.resize(with_shortest, f64::INFINITY);
        ratios.sort_unstable_by(f64::total_cmp);
        let median = (ratios[(with_shortest - 1) / 2] + ratios[with_shortest / 2]) / 2.0;
        println!("printed/shortest: median {median:.2} of {with_shortest} cases");
    }
    Ok(disagree == 0)
}
