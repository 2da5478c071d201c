fn main() {
    let text = std::env::args().nth(1).unwrap();
    let lexed = kahan_algebra::lexer::lex(&text);
    let t = std::time::Instant::now();
    let r = kahan_algebra::read(&lexed.tokens);
    eprintln!("{:?}", t.elapsed());
    for d in &r.diagnostics {
        println!("{}", kahan_algebra::render::report(d, &text, &lexed.ranges, "--field"));
    }
    let m = kahan_algebra::kahan::RationalMap::of(&r.system.field);
    let f = kahan_algebra::render::Formulas {
        map: m.as_ref(),
        field: &r.system.field,
        notation: kahan_algebra::render::Notation::Text,
    };
    if std::env::args().nth(2).is_some() {
        println!("{}", kahan_algebra::render::macro_block(&r.system));
        println!("{:#?}\n{:?} {:?}", f.map(), f.determinant(), f.removed_factor());
        for c in &r.system.claims {
            let t = std::time::Instant::now();
            println!(
                "{} {:?} {:?}",
                c.name.text,
                kahan_algebra::prove::prove_by_normal_form(&r.system, c),
                t.elapsed()
            );
        }
    }
}
