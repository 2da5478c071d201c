use kahan_algebra::{lexer, rational::Rational, read};
use kahan_discover::{Options, discover};
use std::time::Instant;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let system = read(&lexer::lex(&args[1]).tokens).system;
    let eps = args.get(2).and_then(|e| Rational::parse(e));
    let t = Instant::now();
    let seconds = args.get(3).and_then(|s| s.parse().ok()).unwrap_or(30.0);
    match discover(&system, &Options { eps, seconds, ..Options::default() }, &mut |s| {
        eprintln!("  {:?} {s}", t.elapsed())
    }) {
        Err(e) => println!("{e}"),
        Ok(r) => {
            println!("{:?} {:?}", r.degrees, r.hilbert.as_ref().map(|h| &h.values));
            for f in r.integrals.iter().chain(&r.densities) {
                println!("{}", f.text.chars().take(400).collect::<String>());
            }
            for s in &r.sentences {
                println!("- {}", s.chars().take(400).collect::<String>());
            }
            println!("{:?}", t.elapsed());
        }
    }
}
