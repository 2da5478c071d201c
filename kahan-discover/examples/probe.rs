use std::time::{Duration, Instant};
use kahan_algebra::{lexer, read, prime_field::SplitMix64, rational::Rational};
use kahan_discover::{claims::Claims, hilbert::*, integrals, darboux, setting::Setting, space::tidy};
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let system = read(&lexer::lex(&args[1]).tokens).system;
    let eps = args.get(2).and_then(|e| Rational::parse(e));
    let setting = Setting::new(&system.field, eps.clone());
    let mut r = SplitMix64::new(3);
    let deadline = Instant::now() + Duration::from_secs(60);
    let t = Instant::now();
    let h = Hilbert::of(&setting, default_degree(setting.dimension()), &mut r, deadline).unwrap();
    println!("{:?} {:?}", h, t.elapsed());
    let t = Instant::now();
    let claims = Claims::new(&system, &[], eps.as_ref());
    let found = integrals::integrals(&setting, &claims, &h, &mut r, deadline);
    println!("{:?}", t.elapsed());
    for f in &found { println!("{}", f.text); }
    let t = Instant::now();
    let mut factors = vec![];
    for f in &found { for p in [&f.numerator, &f.denominator] { let q = tidy(&system.field.symbols, p); if !factors.contains(&q) && q.as_constant().is_none() { factors.push(q); } } }
    if let Some(m) = darboux::measure(&setting, &factors, if setting.dimension() > 4 {4} else {6}, &mut r, deadline) {
        println!("{:?}", claims.density(&system.field.symbols, None, &m.factors).filter(|f| f.text.len() < 1500).map(|f| f.text));
    }
    println!("{:?}", t.elapsed());
}
