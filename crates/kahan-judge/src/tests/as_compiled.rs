//! Compiles random fields with extreme coefficients as a user does, and tests their steps by exact
//! arithmetic.
//!
//! `cargo test --release -p kahan-judge --lib as_compiled -- --ignored --nocapture` builds and runs
//! a crate. `KAHAN_ODD=A,B,C` asks for A fields of up to eight variables, B larger fields and C
//! chains. With `KAHAN_ODD=0,200,100` the test takes two hours. `KAHAN_ODD_TRIALS` sets the number
//! of trials of each field. `KAHAN_ODD_NAMED=Chain74` selects one field.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::{env, fs};

use kahan_algebra::check::Checked;
use kahan_algebra::lexer::lex;
use kahan_algebra::read_unproved;
use kahan_core::Dd;
use kahan_runtime::threads::for_each;

use super::compiled::Compiled;
use super::drawn::{Drawn, odd, odd_chain, odd_of_many};
use crate::random_fields::odd::OddField;
use crate::tally::{BrokenPromises, Cell, Tally};

const SEED: u64 = 1;
const IN_ONE_CRATE: usize = 50;

struct Tried {
    field: Drawn,
    judged: Compiled,
    trials: u64,
}

impl Tried {
    fn of(drawn: Drawn, trials: u64) -> Self {
        let (name, block) = (&drawn.field.name, drawn.field.block());
        let judged = match (read_unproved(&lex(&block).tokens), drawn.sites) {
            (Checked::Family(family), Some(sites)) => Compiled::of_chain(name, &family, sites),
            (Checked::System(system), None) => Compiled::new(name, &system),
            _ => panic!("{block}"),
        };
        Self { field: drawn, judged, trials }
    }

    fn count(&self) -> u64 {
        Compiled::count(self.trials)
    }

    /// Writes the module of a field: the field's block, and a function that makes every step.
    fn module(&self) -> String {
        let Drawn { field: OddField { name, parameters, .. }, of_sites, sites, variables } = &self.field;
        let (parameters, site_parameters) = parameters.split_at(parameters.len() - of_sites);
        let mut given: Vec<String> =
            parameters.iter().enumerate().map(|(k, name)| format!("{name}: p[{k}]")).collect();
        let sites_own = site_parameters.iter().enumerate().map(|(k, name)| {
            let sites = sites.expect("a chain has sites");
            let from = parameters.len() + k * sites;
            format!("{name}: p[{from}..{}].to_vec()", from + sites)
        });
        given.extend(sites_own);
        let value =
            if given.is_empty() { name.clone() } else { format!("{name} {{ {} }}", given.join(", ")) };
        let numbers = parameters.len() + site_parameters.len() * sites.unwrap_or(0);
        let tried = match sites {
            Some(sites) => format!(
                "let mut next: Vec<T> = input.take({});
                 let eps = input.take(1)[0];
                 // A map that does not exist makes no step.
                 let tried = {value}.at(eps, {sites}).ok().and_then(|mut map| map.try_step(&mut next).ok());
                 output.put(tried.map(|()| next));",
                variables * sites
            ),
            None => format!(
                "let x: Vec<T> = input.take({variables});
                 let x = SVector::<T, {variables}>::from_fn(|i, _| x[i]);
                 let eps = input.take(1)[0];
                 output.put({value}.try_step(&x, eps).ok().map(|next| next.iter().copied().collect()));"
            ),
        };
        format!(
            "mod {module} {{
             use kahan_core::prelude::*;
             kahan! {{ {block} }}
             pub fn tries<T: crate::Number>(input: &mut crate::Input, output: &mut crate::Output) {{
                 for _ in 0..{count} {{
                     let p: Vec<T> = input.take({numbers});
                     let _ = &p;
                     {tried}
                 }}
             }} }}\n",
            module = name.to_lowercase(),
            block = self.field.field.block(),
            count = self.count(),
        )
    }
}

/// The part of the generated crate that is equal for all fields.
const FRAME: &str = "
#![allow(unused_imports, clippy::all)]
use kahan_core::prelude::*;
use kahan_core::LatticeScalar;

pub trait Number: Pivot + LatticeScalar + Copy {
    const WORDS: usize;
    fn of(words: &[u64]) -> Self;
    fn words(self, to: &mut Vec<u64>);
}

impl Number for f32 {
    const WORDS: usize = 1;
    fn of(words: &[u64]) -> Self { f32::from_bits(words[0] as u32) }
    fn words(self, to: &mut Vec<u64>) { to.push(self.to_bits().into()); }
}

impl Number for f64 {
    const WORDS: usize = 1;
    fn of(words: &[u64]) -> Self { f64::from_bits(words[0]) }
    fn words(self, to: &mut Vec<u64>) { to.push(self.to_bits()); }
}

impl Number for Dd {
    const WORDS: usize = 2;
    fn of(words: &[u64]) -> Self { Dd::new(f64::from_bits(words[0]), f64::from_bits(words[1])) }
    fn words(self, to: &mut Vec<u64>) { to.extend([self.high().to_bits(), self.low().to_bits()]); }
}

pub struct Input { words: Vec<u64>, at: usize }

impl Input {
    fn take<T: Number>(&mut self, count: usize) -> Vec<T> {
        let from = self.at;
        self.at += count * T::WORDS;
        self.words[from..self.at].chunks(T::WORDS).map(T::of).collect()
    }
}

pub struct Output(Vec<u64>);

impl Output {
    fn put<T: Number>(&mut self, next: Option<Vec<T>>) {
        self.0.push(u64::from(next.is_some()));
        next.into_iter().flatten().for_each(|number| number.words(&mut self.0));
    }
}

fn main() {
    let [field, input, output] = [1, 2, 3].map(|k| std::env::args().nth(k).unwrap());
    let words = std::fs::read(input).unwrap();
    let words = words.chunks(8).map(|word| u64::from_le_bytes(word.try_into().unwrap())).collect();
    let (mut from, mut to) = (Input { words, at: 0 }, Output(Vec::new()));
    tries(&field, &mut from, &mut to);
    assert_eq!(from.at, from.words.len());
    std::fs::write(output, to.0.into_iter().flat_map(u64::to_le_bytes).collect::<Vec<u8>>()).unwrap();
}
";

fn program(fields: &[Tried]) -> String {
    let mut text = FRAME.to_owned();
    let mut arms = String::new();
    for tried in fields {
        text += &tried.module();
        let name = &tried.field.field.name;
        let module = name.to_lowercase();
        let calls = ["f32", "f64", "Dd"].map(|number| format!("{module}::tries::<{number}>(from, to);"));
        writeln!(arms, "        {name:?} => {{ {} }}", calls.concat()).expect("a text takes more");
    }
    text + &format!(
        "fn tries(field: &str, from: &mut Input, to: &mut Output) {{
            match field {{\n{arms}        _ => panic!(\"no field is named {{field}}\") }}
        }}\n"
    )
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Builds the crate as a user does, and returns the path of its program. The generated code is
/// compiled with `opt-level = 1`, which changes no results and saves minutes.
fn build(fields: &[Tried]) -> PathBuf {
    let folder = root().join("target").join("compiled_extremes");
    fs::create_dir_all(folder.join("src")).expect("a folder can be made");
    let manifest = format!(
        "[package]\nname = \"odd-fields\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[dependencies]\nkahan-core = {{ path = {:?} }}\n\n\
         [workspace]\n\n[profile.release]\nopt-level = 1\n\n\
         [profile.release.package.\"*\"]\nopt-level = 3\n",
        root().join("kahan-core")
    );
    fs::write(folder.join("Cargo.toml"), manifest).expect("a file can be written");
    fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).expect("the workspace has a lock file");
    fs::write(folder.join("src/main.rs"), program(fields)).expect("a file can be written");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--release", "--offline", "--quiet"]).current_dir(&folder);
    cargo.env("CARGO_TARGET_DIR", folder.join("target")).env_remove("RUSTFLAGS");
    assert!(cargo.status().expect("cargo runs").success(), "the crate of the fields does not compile");
    folder.join("target/release/odd-fields")
}

impl Tried {
    fn inputs(&self) -> Vec<u8> {
        let Self { judged, trials, .. } = self;
        let all = [judged.inputs::<f32>(*trials, SEED), judged.inputs::<f64>(*trials, SEED)].concat();
        all.into_iter().chain(judged.inputs::<Dd>(*trials, SEED)).flat_map(u64::to_le_bytes).collect()
    }

    fn judge(&self, mut results: &[u64]) -> Tally {
        let (Self { judged, trials, .. }, mut tally) = (self, Tally::default());
        judged.judge::<f32>(*trials, SEED, &mut results, &mut tally);
        judged.judge::<f64>(*trials, SEED, &mut results, &mut tally);
        judged.judge::<Dd>(*trials, SEED, &mut results, &mut tally);
        assert!(results.is_empty(), "the program wrote a result for each trial");
        tally
    }

    fn tally(&self, program: &Path) -> Tally {
        let name = &self.field.field.name;
        let [from, to] = ["inputs", "results"].map(|end| program.with_file_name(format!("{name}.{end}")));
        fs::write(&from, self.inputs()).expect("a file can be written");
        let status = Command::new(program).arg(name).args([&from, &to]).status().expect("the program runs");
        assert!(status.success(), "a step that promises panics: {}", self.field.field.block());
        let results = fs::read(&to).expect("the program wrote its results");
        [from, to].into_iter().for_each(|file| fs::remove_file(file).expect("what was written can go"));
        let word = |bytes: &[u8]| u64::from_le_bytes(bytes.try_into().expect("eight bytes"));
        self.judge(&results.chunks(8).map(word).collect::<Vec<u64>>())
    }
}

fn try_all(fields: &[Tried]) -> Tally {
    let program = build(fields);
    let all = Mutex::new(Tally::default());
    for_each(fields.len(), None, &|k| {
        let (field, tally) = (&fields[k].field.field, fields[k].tally(&program));
        println!("{} is judged", field.name);
        for BrokenPromises { silently_wrong, unjustified, first, .. } in tally.broken.values() {
            println!(
                "  {silently_wrong} silently wrong, {unjustified} flagged without right: {}",
                field.block()
            );
            println!("  {}", first.text);
        }
        all.lock().expect("no thread panics in here").add(tally);
    });
    all.into_inner().expect("no thread panics in here")
}

#[test]
#[ignore = "compiles a crate of sixty fields in three numbers"]
fn compiled_fields_of_odd_tempers_keep_their_promise() {
    let counts = env::var("KAHAN_ODD").unwrap_or_else(|_| "40,12,8".to_owned());
    let counts: Vec<usize> = counts.split(',').map(|count| count.parse().expect("a number")).collect();
    let &[plain, many, chains] = counts.as_slice() else { panic!("KAHAN_ODD is three numbers") };
    let trials = env::var("KAHAN_ODD_TRIALS").map_or(300, |trials| trials.parse().expect("a number"));
    let fields = (0..plain).map(|k| odd(SEED, k));
    let fields = fields.chain((0..many).map(|k| odd_of_many(SEED, k)));
    let fields = fields.chain((0..chains).map(|k| odd_chain(SEED, k)));
    let own = |k| if k % 20 == 19 { 10 * trials } else { trials };
    let named = env::var("KAHAN_ODD_NAMED").ok();
    let is_asked = |drawn: &Drawn| named.as_ref().is_none_or(|name| drawn.field.name == *name);
    let fields = fields.enumerate().filter(|(_, field)| is_asked(field));
    let fields: Vec<Tried> = fields.map(|(k, field)| Tried::of(field, own(k))).collect();
    assert!(!fields.is_empty(), "no field is asked for");
    let mut tally = Tally::default();
    for part in fields.chunks(IN_ONE_CRATE) {
        tally.add(try_all(part));
    }
    let sum = |of: fn(&Cell) -> u64| tally.cells.values().map(of).sum::<u64>();
    let drawn = 3 * fields.iter().map(Tried::count).sum::<u64>();
    let (judged, flagged) = (sum(|cell| cell.trials), sum(|cell| cell.flagged));
    let (wrong, unjustified) = (sum(|cell| cell.silently_wrong), sum(|cell| cell.unjustified));
    println!("{} fields, {drawn} trials drawn, {judged} judged, {flagged} flagged", fields.len());
    println!("{wrong} silently wrong, {unjustified} flagged without right");
    assert_eq!((drawn, wrong, unjustified), (judged, 0, 0));
}
