//! Arguments of a wrong size give errors with advice; no number causes a panic.

use kahan_core::Composition;
use kahan_runtime::{ClaimError, DimensionError, Field, MachineFloat, ParameterError};

use super::support::{catalog, number};

#[test]
fn mistakes_of_a_text_come_with_their_line() {
    let why = Field::parse("xdot = x*y;\nydot = sin(x) + x*y*z;").unwrap_err();
    assert_eq!(why.mistakes().len(), 1, "{why}");
    let text = why.to_string();
    for part in ["error: ", " --> field:2:8\n", "2 | ydot = sin(x) + x*y*z;\n", "  |        ^"] {
        assert!(text.contains(part), "{text}");
    }
    let false_claim = Field::parse("xdot = x*y; ydot = x;\nintegral H = x + y;").unwrap_err().to_string();
    assert!(false_claim.contains("2 | integral H = x + y;\n  |          ^"), "{false_claim}");
    let many: String = (0..12).map(|i| format!("x{i}dot = sin(x{i});\n")).collect();
    let many = Field::parse(&many).unwrap_err();
    assert_eq!(many.mistakes().len(), 12);
    assert!(many.to_string().ends_with("error: 4 more mistakes are not shown\n"), "{many}");
    assert!(text.contains("\nhelp: "), "{text}");
    assert_eq!(why.without_help().to_string(), text[..text.find("help: ").expect("a help text")]);
}

#[test]
fn parameters_that_do_not_fit_are_told() {
    let field = Field::parse("xdot = alpha*x*y/(beta - 1); ydot = x - gamma;").unwrap();
    let told = |values: &[(&str, f64)]| field.with(values.iter().copied()).unwrap_err().to_string();
    let fits = [("alpha", 1.0), ("beta", 2.0), ("gamma", 3.0)];
    assert!(field.with(fits).is_ok());
    assert_eq!(told(&[("alpa", 1.0)]), "the field has no parameter `alpa`; did you mean `alpha`?");
    assert_eq!(
        told(&[("x", 1.0)]),
        "the field has no parameter `x`; give a value for `alpha`, `beta`, `gamma`"
    );
    assert_eq!(
        told(&[("beta", 1.0)]),
        "the field needs a value for each of its parameters: add one for `alpha`, `gamma`"
    );
    assert_eq!(told(&[fits[0], fits[0]]), "the parameter `alpha` is given twice; leave one of them out");
    for value in [f64::NAN, f64::INFINITY] {
        assert_eq!(
            told(&[("alpha", value)]),
            "the value of the parameter `alpha` is not a finite number; give one that is"
        );
    }
    assert_eq!(
        told(&[fits[0], ("beta", 1.0), fits[2]]),
        "the field divides by zero at alpha = 1, beta = 1, gamma = 3; choose other values"
    );
    let none = Field::parse("xdot = x;").unwrap();
    assert_eq!(
        none.with([("a", 1)]).unwrap_err().to_string(),
        "the field has no parameter `a`: it has none, so leave it out"
    );
    assert_eq!(field.map().unwrap_err(), ParameterError::Missing(field.parameters().to_vec()));
}

#[test]
fn slices_that_do_not_fit_are_told() {
    let map = catalog("e9").with([("xi", 0.5)]).unwrap();
    let at = map.at(0.1);
    let told = |result: Result<(), DimensionError>| result.unwrap_err().to_string();
    let (mut two, mut three, mut nine) = ([1.0; 2], [1.0; 3], [0.0; 9]);
    let short = "the state has 2 entries; give 3, one a variable";
    assert_eq!(told(at.step(&two, &mut three)), short);
    assert_eq!(told(at.advance(&mut two, 1)), short);
    assert_eq!(told(at.field(&two, &mut three)), short);
    assert_eq!(told(at.jacobian(&two, &mut nine)), short);
    assert_eq!(told(at.matrix(&three, &mut two)), "there is room for 2 entries of the result; make it 9");
    assert_eq!(told(at.step(&three, &mut [0.0])), "there is room for 1 entry of the result; make it 3");
    assert_eq!(
        told(at.advance_with_carry(&mut three, &mut two, 1)),
        "the carry has 2 entries; give 3, one a variable"
    );
    assert!(matches!(at.density(&two), Err(ClaimError::Dimension(error)) if error.found() == 2));
    assert_eq!(
        at.bracket("R", &three, &mut nine).unwrap_err().to_string(),
        "the field claims no bracket `R`; write `bracket R { … }` in its text"
    );
    assert_eq!(
        catalog("e6").map().unwrap().at(0.1).bracket("R", &three, &mut nine).unwrap_err().to_string(),
        "the field claims no bracket `R`; it has P, Q"
    );
    assert_eq!(
        Field::parse("xdot = x;").unwrap().map().unwrap().at(0.1).density(&[1.0]),
        Err(ClaimError::NoDensity)
    );
    let narrow = map.as_kahan_map::<f64, 2>().unwrap_err();
    assert_eq!((narrow.found(), narrow.expected()), (2, 3));
    assert!(map.as_kahan_map::<f64, 3>().is_ok() && map.as_kahan_map::<f64, 8>().is_ok());
}

#[test]
fn columns_that_do_not_fit_are_told() {
    let at = catalog("e9").with([("xi", 0.5)]).unwrap().at(0.1);
    let told = |lengths: &[usize], eps: &[f64], parameters: &[&[f64]]| {
        let mut columns: Vec<Vec<f64>> = lengths.iter().map(|length| vec![0.5; *length]).collect();
        let mut columns: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        at.advance_columns(&mut columns, eps, parameters, 1).map_err(|error| error.to_string())
    };
    let refused = |why: &str| Err(why.to_owned());
    assert_eq!(told(&[4, 4], &[], &[]), refused("the columns are 2; give 3, one a variable"));
    assert_eq!(
        told(&[4, 4, 5], &[], &[]),
        refused("the column of `z` has 5 entries; give 4, as in the first")
    );
    assert_eq!(
        told(&[4; 3], &[0.1; 3], &[]),
        refused("eps has 3 entries; give none, one, or 4, one a trajectory")
    );
    assert_eq!(
        told(&[4; 3], &[], &[&[1.0], &[1.0]]),
        refused("the parameters are 2; give none, or 1 lists, one a parameter")
    );
    for values in [&[][..], &[1.0; 2]] {
        let entries = values.len();
        let why = format!("the parameter `xi` has {entries} entries; give one, or 4, one a trajectory");
        assert_eq!(told(&[4; 3], &[], &[values]), refused(&why));
    }
    assert_eq!(told(&[4; 3], &[0.1; 4], &[&[1.0; 4]]), Ok(()));
    assert_eq!(told(&[0; 3], &[], &[&[]]), Ok(()));
}

fn no_number_panics<T: MachineFloat>(text: &str) {
    let field = Field::parse(text).unwrap();
    let n = field.variables().len();
    let infinite = T::one() / T::zero();
    let extremes = [infinite * T::zero(), infinite, -infinite];
    let values: Vec<T> =
        extremes.into_iter().chain([T::zero(), -T::zero(), T::one(), number(1e-30)]).collect();
    let map = field.map().unwrap();
    for (&eps, &x) in values.iter().flat_map(|eps| values.iter().map(move |x| (eps, x))) {
        for composition in [Composition::KAHAN, Composition::SUZUKI_4] {
            let at = map.at(eps).composed(composition);
            let (mut state, mut carry, mut next) = (vec![x; n], vec![x; n], vec![x; n]);
            state[0] = T::one();
            let mut entries = vec![x; n * n];
            at.step(&state, &mut next).unwrap();
            at.jacobian(&state, &mut entries).unwrap();
            at.matrix(&state, &mut entries).unwrap();
            at.advance(&mut next, 3).unwrap();
            at.advance_with_carry(&mut state, &mut carry, 3).unwrap();
            let mut columns = vec![vec![x; 9]; n];
            let mut columns: Vec<&mut [T]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
            at.advance_columns(&mut columns, &values.repeat(9)[..9], &[], 2).unwrap();
        }
    }
}

#[test]
fn no_number_is_a_panic() {
    for text in
        ["xdot = x*y; ydot = 1 - x^2;", "xdot = 3/7*x^2;", &super::large::dense(9).replace(['a', 'b'], "1")]
    {
        no_number_panics::<f64>(text);
        no_number_panics::<f32>(text);
    }
}
