//! Converts formulas from LaTeX to MathML, which browsers render without a script.

use kahan_latex::breaking;
use maud::{Markup, PreEscaped, html};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Event, Parser, ParserError, Storage, push_mathml};

/// Renders a formula in running text.
pub fn inline(latex: &str) -> Markup {
    mathml(latex, DisplayMode::Inline)
}

/// The number of characters on a line of the page.
pub const LINE: usize = 84;
/// The number of characters on a line of a formula in a column of claims.
pub const COLUMN: usize = 56;
const CELL: usize = 44;

/// Renders a displayed formula with at most `width` characters on a line.
pub fn display(latex: &str, width: usize) -> Markup {
    let latex = breaking::display(latex, width);
    html! { div.formula tabindex="0" { (mathml(&latex, DisplayMode::Block)) } }
}

/// Renders a formula for a table cell in display style.
pub fn cell(latex: &str) -> Markup {
    inline(&format!("\\displaystyle {}", breaking::boxed(latex, CELL)))
}

/// Renders several displayed formulas, one below the other.
pub fn displays(formulas: &[String], width: usize) -> Markup {
    html! { @for formula in formulas { (display(formula, width)) } }
}

/// Converts LaTeX to MathML. If that fails, returns the LaTeX in an element of the class `unset`.
fn mathml(latex: &str, display_mode: DisplayMode) -> Markup {
    let storage = Storage::new();
    let events: Result<Vec<Event<'_>>, _> = Parser::new(latex, &storage).collect();
    let mut text = String::new();
    let set = events.map(|events| {
        let events = events.into_iter().map(Ok::<_, Box<ParserError>>);
        push_mathml(&mut text, events, RenderConfig { display_mode, ..RenderConfig::default() })
    });
    match set {
        // The library writes `\\mu` as the micro sign, which browsers set upright.
        Ok(Ok(())) => PreEscaped(text.replace('\u{b5}', "μ")),
        _ => html! { code.unset { (latex) } },
    }
}

#[cfg(test)]
mod tests {
    use super::{display, inline};

    #[test]
    fn formulas_of_every_kind_are_set() {
        for latex in [
            "\\widetilde{x} = \\frac{x}{1 + \\varepsilon^{2} y}",
            "\\left.\\widetilde{\\left(x + y\\right)}\\right|_{(a, b, c)} \\neq \\operatorname{sn}^{2}\\left(u\\right)",
            "\\begin{pmatrix} 1 & 0 \\\\ -\\varepsilon & \\vartheta_{4} \\end{pmatrix}",
            "\\sum_{j = 0}^{n - 1} \\Gamma\\left(\\frac{1}{2}\\right) \\mathit{slope} < 1",
        ] {
            let set = inline(latex).into_string();
            assert!(set.starts_with("<math") && !set.contains("unset") && !set.contains("merror"), "{set}");
        }
    }

    #[test]
    fn what_cannot_be_set_is_shown_and_marked() {
        let set = display("\\frac{<}{", super::LINE).into_string();
        assert!(set.contains("class=\"unset\"") && set.contains("&lt;"), "{set}");
    }
}
