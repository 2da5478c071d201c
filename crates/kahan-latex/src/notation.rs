//! The LaTeX notation, for example `\frac{1}{2}x^{2}`.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Precedence};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::syntax::Factor;

use crate::expression;
use crate::name::latex_name;

/// The notation of LaTeX in math mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Latex;

impl Notation for Latex {
    /// Writes a name with Greek letters and indices, for example `\mu_{1}` or `x_{\mathrm{max}}`.
    fn name(&self, name: &str) -> String {
        latex_name(name)
    }

    fn image(&self, name: &str) -> String {
        format!("\\widetilde{{{}}}", self.name(name))
    }

    fn entry(&self, row: &str, column: &str) -> String {
        format!("\\{{{},{}\\}}", self.name(row), self.name(column))
    }

    fn number(&self, value: &Rational) -> String {
        if value.is_integer() {
            return value.to_string();
        }
        let sign = if value.is_negative() { "-" } else { "" };
        format!("{sign}\\frac{{{}}}{{{}}}", value.numerator().magnitude(), value.denominator())
    }

    fn power(&self, base: &str, exponent: i64) -> String {
        if exponent == 1 { base.to_owned() } else { format!("{base}^{{{exponent}}}") }
    }

    fn raised(&self, base: &str, exponent: &str) -> String {
        format!("{base}^{{{exponent}}}")
    }

    fn call(&self, function: &str, argument: &str) -> String {
        match function {
            "sqrt" => format!("\\sqrt{{{argument}}}"),
            "cbrt" => format!("\\sqrt[3]{{{argument}}}"),
            "" => format!("\\left({argument}\\right)"),
            name => format!("\\operatorname{{{name}}}\\left({argument}\\right)"),
        }
    }

    /// Writes a product, with dots before numbers after the first factor and thin spaces around
    /// words.
    fn product(&self, factors: &[String]) -> String {
        let mut text = String::new();
        let mut before = "";
        for factor in factors {
            text.push_str(if before.is_empty() {
                ""
            } else if factor.starts_with(|c: char| c.is_ascii_digit()) {
                " \\cdot "
            } else if is_word(before) || is_word(factor) {
                "\\, "
            } else {
                " "
            });
            text.push_str(factor);
            before = factor;
        }
        text
    }

    fn quotient(&self, above: &str, below: &str) -> String {
        format!("\\frac{{{above}}}{{{below}}}")
    }

    /// Writes a quotient with integer coefficients, such as −xy/(2a) for (−½ x y)/a.
    fn fraction(&self, symbols: &Symbols, above: &Polynomial, below: &Polynomial) -> String {
        // A content may be negative. Dividing by its absolute value keeps the signs of all terms.
        let (numerator, denominator) = (above.content().abs(), below.content().abs());
        let Some(factor) = numerator.checked_div(&denominator) else {
            return self.polynomial(symbols, above);
        };
        let is_negative = above.terms().all(|(_, coefficient)| coefficient.is_negative());
        let whole = |part: &Polynomial, content: &Rational, times: Rational| {
            times.checked_div(content).map_or_else(|| part.clone(), |scale| part.scale(&scale))
        };
        let above = whole(above, &numerator, factor.numerator().into());
        let below = whole(below, &denominator, factor.denominator().into());
        let (above, sign) = if is_negative { (above.scale(&Rational::from(-1)), "-") } else { (above, "") };
        let quotient = self.quotient(&self.polynomial(symbols, &above), &self.polynomial(symbols, &below));
        format!("{sign}{quotient}")
    }

    fn moved(
        &self,
        symbols: &Symbols,
        name: &str,
        increment: &Polynomial,
        denominator: &Polynomial,
    ) -> String {
        let state = self.name(name);
        if increment.is_one() && denominator.is_one() {
            return format!("{state} + 2\\varepsilon");
        }
        if denominator.is_one() {
            let increment = self.polynomial(symbols, increment);
            let is_plain = increment.starts_with(char::is_alphabetic) || increment.starts_with('\\');
            return if is_plain && !increment.contains(" + ") && !increment.contains(" - ") {
                format!("{state} + 2\\varepsilon\\,{increment}")
            } else {
                format!("{state} + 2\\varepsilon\\left({increment}\\right)")
            };
        }
        let quotient = self.fraction(symbols, increment, denominator);
        match quotient.strip_prefix('-') {
            Some(size) => format!("{state} - 2\\varepsilon\\,{size}"),
            None => format!("{state} + 2\\varepsilon\\,{quotient}"),
        }
    }

    fn written_product(&self, factors: &[Factor]) -> (String, Precedence) {
        expression::product(factors)
    }

    fn behind_sign(&self) -> Precedence {
        Precedence::Product
    }

    fn over_sites(&self, summand: &str) -> String {
        format!("\\sum_i ({summand})")
    }

    fn parenthesized(&self, text: &str) -> String {
        expression::parenthesized(text)
    }
}

/// Returns whether a factor is a name of several letters, possibly with a tilde or an exponent.
fn is_word(factor: &str) -> bool {
    factor.trim_start_matches("\\widetilde{").starts_with("\\mathit{")
}

#[cfg(test)]
mod tests {
    use kahan_algebra::render::{Notation, condition_statement};
    use kahan_algebra::{lexer, read};

    use super::Latex;

    #[test]
    fn relations_are_written_as_their_sides() {
        let block = "xdot = a1*a2*y; ydot = -a1*a2*x; udot = a5*a6*v; vdot = -a5*a6*u;
            integral G = x*u + y*v when a1*a2 = a5*a6, eps = 1/2;";
        let system = read(&lexer::lex(block).tokens).system().expect("a system");
        let written = condition_statement(&system, &system.claims[0], &Latex);
        assert_eq!(written, "a_{1} a_{2} = a_{5} a_{6}, \\varepsilon = \\frac{1}{2}");
    }

    #[test]
    fn words_stand_apart_from_other_factors() {
        for (factors, written) in [
            (&["xp", "xp", "y"][..], "\\mathit{xp}\\, \\mathit{xp}\\, y"),
            (&["eps", "xp2"], "\\varepsilon\\, \\mathit{xp}_{2}"),
            (&["x", "y"], "x y"),
        ] {
            let factors: Vec<String> = factors.iter().map(|name| Latex.name(name)).collect();
            assert_eq!(Latex.product(&factors), written);
        }
        let counted = ["16".to_owned(), Latex.image("xp"), "2".to_owned()];
        assert_eq!(Latex.product(&counted), "16\\, \\widetilde{\\mathit{xp}} \\cdot 2");
    }
}
