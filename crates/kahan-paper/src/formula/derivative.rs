//! Computes partial derivatives of formulas.

use super::Formula;

/// Returns ∂formula/∂variable, or an error if a derivative is unknown.
pub(super) fn derivative(formula: &Formula, variable: &str) -> Result<Formula, String> {
    if !depends_on(formula, variable) {
        return Ok(Formula::integer(0));
    }
    match formula {
        Formula::Number(_) => Ok(Formula::integer(0)),
        Formula::Name(_) => Ok(Formula::integer(1)),
        Formula::Negation(inner) => Ok(Formula::Negation(Box::new(derivative(inner, variable)?))),
        Formula::Sum(terms) => {
            let mut sum = Vec::new();
            for (negative, term) in terms.iter().filter(|(_, term)| depends_on(term, variable)) {
                sum.push((*negative, derivative(term, variable)?));
            }
            Ok(Formula::Sum(sum))
        }
        Formula::Product(factors) => {
            let mut sum = Vec::new();
            for (index, (divides, factor)) in factors.iter().enumerate() {
                if !depends_on(factor, variable) {
                    continue;
                }
                let mut term = factors.clone();
                let slope = derivative(factor, variable)?;
                if *divides {
                    // The derivative of 1/b is −b′/(b·b), so b becomes a divisor once more.
                    term.push((true, factor.clone()));
                    term.push((false, slope));
                } else {
                    term[index] = (false, slope);
                }
                sum.push((*divides, Formula::Product(term)));
            }
            Ok(Formula::Sum(sum))
        }
        Formula::Power(base, exponent) => {
            if depends_on(exponent, variable) {
                return Err("an exponent depends on the variable of a derivative".to_owned());
            }
            let lowered = Formula::Sum(vec![(false, (**exponent).clone()), (true, Formula::integer(1))]);
            let power = Formula::Power(base.clone(), Box::new(lowered));
            Ok(chain((**exponent).clone().times(power), base, variable)?)
        }
        Formula::Call(name, arguments) => {
            let [inner, rest @ ..] = arguments.as_slice() else { return Err(unknown(name)) };
            if rest.iter().any(|argument| depends_on(argument, variable)) {
                return Err(unknown(name));
            }
            let of = |name: &str| {
                let all = std::iter::once(inner).chain(rest).cloned().collect();
                Formula::call(name, all)
            };
            let outer = match name.as_str() {
                "exp" => of("exp"),
                "log" => Formula::integer(1).over(inner.clone()),
                "sqrt" => Formula::integer(1).over(Formula::integer(2).times(of("sqrt"))),
                "sin" => of("cos"),
                "cos" => Formula::Negation(Box::new(of("sin"))),
                "sinh" => of("cosh"),
                "cosh" => of("sinh"),
                "tanh" => of("sech").raised_to(2),
                "sech" => Formula::Negation(Box::new(of("sech").times(of("tanh")))),
                "gamma" => of("gamma").times(of("digamma")),
                "sn" => of("cn").times(of("dn")),
                "cn" => Formula::Negation(Box::new(of("sn").times(of("dn")))),
                "dn" => {
                    let modulus = rest.first().ok_or_else(|| unknown(name))?;
                    Formula::Negation(Box::new(modulus.clone().raised_to(2).times(of("sn")).times(of("cn"))))
                }
                _ => return Err(unknown(name)),
            };
            chain(outer, inner, variable)
        }
    }
}

/// Returns outer · ∂inner/∂variable, by the chain rule.
fn chain(outer: Formula, inner: &Formula, variable: &str) -> Result<Formula, String> {
    let slope = derivative(inner, variable)?;
    Ok(if slope.is_number(1) { outer } else { outer.times(slope) })
}

fn unknown(name: &str) -> String {
    format!("`{name}` has no derivative here")
}

fn depends_on(formula: &Formula, variable: &str) -> bool {
    match formula {
        Formula::Name(name) => name == variable,
        // The values of these calls depend on all states, and therefore on `variable`.
        Formula::Call(name, _) if matches!(name.as_str(), "next" | "back" | "f" | "A" | "b" | "J") => true,
        _ => formula.parts().into_iter().any(|part| depends_on(part, variable)),
    }
}
