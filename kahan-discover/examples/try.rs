use kahan_algebra::{lexer, read};
use kahan_discover::{Options, discover};
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let text = std::fs::read_to_string(&args[1]).unwrap();
    let system = read(&lexer::lex(&text).tokens).system;
    let t = std::time::Instant::now();
    let seconds = args.get(2).map_or(60.0, |s| s.parse().unwrap());
    let r = discover(&system, &Options { seconds, ..Options::default() }, &mut |s| {
        eprintln!("{:?} {s}", t.elapsed())
    })
    .unwrap();
    println!(
        "{:?} {} integrals {:?}",
        t.elapsed(),
        r.independent_integrals(),
        r.integrals.iter().map(|f| f.text.len()).collect::<Vec<_>>()
    );
    for f in r.integrals.iter().chain(&r.densities) {
        println!("{}", f.text.chars().take(1500).collect::<String>());
    }
    for b in &r.brackets {
        println!("{b}");
    }
    for b in &r.bases {
        println!("basis {:?} {:?} {:?}", b.monomial_texts(&r.variables), b.integrals, b.proof);
    }
}
