//! The weakenings: where, what stands there, what is put in its place, and the tests that must
//! notice.

/// One of them.
pub(crate) struct Weakening {
    pub(crate) name: &'static str,
    /// From the root of the workspace.
    pub(crate) file: &'static str,
    /// What stands there, once.
    pub(crate) text: &'static str,
    pub(crate) weaker: &'static str,
    /// What follows `cargo test`.
    pub(crate) tests: &'static str,
}

const RULES: &str = "-p kahan-core --features exact --lib -- stable::tests";
const DIGITS: &str = "-p kahan-core --features exact --lib -- wide::tests";
const BOUNDED: &str = "kahan-core/src/scalar/bounded/mod.rs";
const OPERATIONS: &str = "kahan-core/src/scalar/bounded/rules.rs";
const FORMATS: &str = "kahan-core/src/scalar/bounded/formats.rs";
const ATTEMPT: &str = "kahan-core/src/map/stable/attempt.rs";
const RUNGS: &str = "kahan-core/src/map/stable/rungs.rs";
const WIDE: &str = "kahan-core/src/scalar/wide/arithmetic.rs";

const PAIRS: &str = "-p kahan-core --features exact --lib -- dd::bounds";
const MODERATE: &str = "kahan-core/src/scalar/dd/moderate.rs";
const DEGREES: &str = "-p kahan-discover --lib -- thiele";
const RELATIONS: &str = "-p kahan-algebra --test conditional_claims";
const KEPT: &str = "-p kahan-algebra --test kept";
const TEXTS: &str = "-p kahan-algebra --test object_plans";
const SCANS: &str = "-p kahan-discover --test scans";
const ECHELONS: &str = "-p kahan-discover --lib -- matrix modulus";
const REFERENCES: &str = "-p kahan-measure --lib -- reference";
const CERTIFICATE: &str = "kahan-measure/src/reference/certificate.rs";

const fn rule(name: &'static str, file: &'static str, text: &'static str, weaker: &'static str) -> Weakening {
    Weakening { name, file, text, weaker, tests: RULES }
}

const fn known(name: &'static str, text: &'static str, weaker: &'static str) -> Weakening {
    Weakening {
        name,
        file: "kahan-core/src/scalar/bounded/known.rs",
        text,
        weaker,
        tests: "-p kahan-core --features exact --lib -- bounded::known",
    }
}

const fn digit(
    name: &'static str,
    file: &'static str,
    text: &'static str,
    weaker: &'static str,
) -> Weakening {
    Weakening { name, file, text, weaker, tests: DIGITS }
}

#[rustfmt::skip]
pub(crate) const WEAKENINGS: &[Weakening] = &[
    // The count of roundings.
    rule("a sum without its rounding", OPERATIONS,
        "roundings: self.roundings.max(other.roundings).saturating_add(1),",
        "roundings: self.roundings.max(other.roundings),"),
    rule("a sum with the roundings of its first term", OPERATIONS,
        "roundings: self.roundings.max(other.roundings).saturating_add(1),",
        "roundings: self.roundings.saturating_add(1),"),
    rule("a product without its rounding", OPERATIONS,
        "roundings: self.roundings.saturating_add(other.roundings).saturating_add(1),",
        "roundings: self.roundings.saturating_add(other.roundings),"),
    rule("a product with the roundings of its worse factor", OPERATIONS,
        "roundings: self.roundings.saturating_add(other.roundings).saturating_add(1),",
        "roundings: self.roundings.max(other.roundings).saturating_add(1),"),
    rule("a quotient without its rounding", OPERATIONS,
        "roundings: self.roundings.max(divisor.roundings).saturating_add(1),",
        "roundings: self.roundings.max(divisor.roundings),"),
    rule("a quotient with the roundings of its dividend", OPERATIONS,
        "roundings: self.roundings.max(divisor.roundings).saturating_add(1),",
        "roundings: self.roundings.saturating_add(1),"),
    rule("a constant over eps without its rounding", OPERATIONS,
        "roundings: self.roundings.saturating_add(eps.roundings).saturating_add(1),",
        "roundings: self.roundings.saturating_add(eps.roundings),"),
    rule("literals that are not rounded", "kahan-core/src/scalar/bounded/operators.rs",
        "Self::literal(value, u32::from(!is_exact))", "Self::literal(value, u32::from(!is_exact && false))"),
    rule("a weight without the rounding of the product", BOUNDED,
        "roundings: roundings.saturating_add(1), ..*self", "roundings, ..*self"),
    // Magnitudes.
    rule("a difference that cancels its magnitude", "kahan-core/src/scalar/bounded/pair.rs",
        "Self { value: self.value - other.value, magnitude: self.magnitude + other.magnitude }",
        "Self { value: self.value - other.value, magnitude: (self.value - other.value).size() }"),
    rule("a product with the magnitude of its value", "kahan-core/src/scalar/bounded/pair.rs",
        "Self { value: self.value * other.value, magnitude: self.magnitude * other.magnitude }",
        "Self { value: self.value * other.value, magnitude: (self.value * other.value).size() }"),
    rule("a quotient without the magnitude of its divisor", OPERATIONS,
        "let numerator = self.magnitude() + value.size() * divisor.magnitude();",
        "let numerator = self.magnitude();"),
    rule("a chain of quotients without the magnitude of a divisor", OPERATIONS,
        "let ratio = ratio + divisor.magnitude() * (value.size() * inverse);",
        "let ratio = ratio + V::Magnitude::of(0.0) * (value.size() * inverse);"),
    rule("packed magnitudes with the sign of their values", "kahan-core/src/scalar/bounded/packed.rs",
        "sign: _mm_set_pd(0.0, -0.0),", "sign: _mm_set_pd(-0.0, -0.0),"),
    rule("half of the slack", BOUNDED, "const SLACK: f64 = 1.0625;", "const SLACK: f64 = 1.03125;"),
    rule("divisors that may be zero", OPERATIONS,
        "V::Magnitude::of(64.0) * divisor.gamma()", "V::Magnitude::of(1.0) * divisor.gamma()"),
    rule("a weight without the error of the reciprocal", BOUNDED,
        "None => self.value().size() * gamma + self.magnitude() * own + allowance,", "None => self.value().size() * gamma + allowance,"),
    rule("a weight without the error of a chain", BOUNDED,
        "(gamma + ratio * (V::Magnitude::of(SLACK) * own))", "(gamma + ratio * (V::Magnitude::of(0.0) * own))"),
    rule("a known radius that is forgotten", OPERATIONS,
        "let magnitude = value.size() + radius / V::Magnitude::of(V::UNIT);", "let magnitude = value.size();"),
    // Underflow.
    rule("no allowance for underflow", BOUNDED,
        "self.magnitude() * self.gamma() + V::Magnitude::of(V::RANGE.allowance)", "self.magnitude() * self.gamma()"),
    rule("no allowance in the weight of a chain", BOUNDED,
        "(V::Magnitude::of(SLACK) * own)) + allowance", "(V::Magnitude::of(SLACK) * own))"),
    rule("no allowance for numerators", BOUNDED,
        "V::RANGE.allowance / (V::UNIT * f64::from(roundings.saturating_add(1)))", "0.0 * f64::from(roundings)"),
    rule("a least divisor that is not looked at", OPERATIONS,
        "let is_certain = size > doubt + least;", "let is_certain = size > doubt + least * V::Magnitude::of(0.0);"),
    rule("a sum without its bit", OPERATIONS,
        "bits: self.bits.max(other.bits).saturating_add(1),", "bits: self.bits.max(other.bits),"),
    rule("a product with the inputs of one factor", OPERATIONS,
        "inputs: self.inputs.saturating_add(other.inputs),", "inputs: self.inputs.max(other.inputs),"),
    rule("a product with the bits of one factor", OPERATIONS,
        "bits: self.bits.saturating_add(other.bits),", "bits: self.bits.max(other.bits),"),
    rule("a quotient with the bits of its divisor once", OPERATIONS,
        "saturating_add(2 * V::RANGE.bits_of_divisors)", "saturating_add(0 * V::RANGE.bits_of_divisors)"),
    rule("a constant over eps without bits", OPERATIONS,
        "bits: self.bits.saturating_add(V::RANGE.bits_of_steps),", "bits: self.bits,"),
    rule("an allowance for singles that is none", FORMATS,
        "Range::of(LOST_OF_SINGLES, -40,", "Range::of(LOST_OF_SINGLES - 40, -80,"),
    rule("an allowance for doubles that is none", FORMATS,
        "const LOST_OF_DOUBLES: i32 = -1074;", "const LOST_OF_DOUBLES: i32 = -1174;"),
    // The premises of the bounds.
    rule("constants of more bits than there are", BOUNDED,
        "|| self.bits > bits_of_products;", "|| self.bits > bits_of_products + 900;"),
    rule("more underflows than the allowance is made for", BOUNDED,
        "|| self.underflows > MOST_UNDERFLOWS", "|| self.underflows > 2 * MOST_UNDERFLOWS"),
    rule("more roundings than the slack pays for", BOUNDED,
        "(0.1 / V::UNIT) as u32", "(0.2 / V::UNIT) as u32"),
    rule("an unknown value that allows any input", BOUNDED,
        "let bits = u32::MAX;", "let bits = 0;"),
    rule("literals that never underflow", BOUNDED,
        "underflows: roundings,", "underflows: 0,"),
    rule("an eps beyond its bits", BOUNDED,
        "(1.0 / most..=most).contains(&size)", "(0.0 / most..=f64::INFINITY).contains(&size)"),
    rule("a quotient with the inputs of its dividend", OPERATIONS,
        "inputs: self.inputs.saturating_add(divisor.inputs),", "inputs: self.inputs,"),
    rule("a quotient with the underflows of its dividend", OPERATIONS,
        "underflows: self.underflows.saturating_add(divisor.underflows).saturating_add(1),",
        "underflows: self.underflows.saturating_add(1),"),
    rule("a product that does not underflow", OPERATIONS,
        "underflows: self.underflows.saturating_add(other.underflows).saturating_add(1),",
        "underflows: self.underflows.saturating_add(other.underflows),"),
    rule("singles that lose less than they do", FORMATS,
        "const LOST_OF_SINGLES: i32 = -149;", "const LOST_OF_SINGLES: i32 = -150;"),
    rule("pairs of doubles that lose less than is stated of them", FORMATS,
        "const LOST_OF_PAIRS: i32 = -1070;", "const LOST_OF_PAIRS: i32 = -1072;"),
    rule("what one of two values allows", "kahan-core/src/scalar/bounded/limit.rs",
        "Self(self.0.min(other.0))", "Self(other.0)"),
    rule("a limit that is twice as large", "kahan-core/src/scalar/bounded/limit.rs",
        "Self(n) => power_of_two(n as i32 - 1),", "Self(n) => power_of_two(n as i32),"),
    known("a backward error with inputs of any size",
        "if limit.allows(largest) && error >= 0.0", "if error >= 0.0"),
    known("a residual without its own error",
        "(residual.size + residual.error, products", "(residual.size, products"),
    known("a right-hand side that may be zero",
        "if G::of(64.0) * self.error <= self.size", "if self.error <= self.size"),
    // Steps.
    rule("an attempt without the weights of reciprocals", ATTEMPT,
        "Some(reciprocal) => reciprocal.weight(roundings),", "Some(reciprocal) => reciprocal.weight(0),"),
    rule("an attempt as N/D without an error", ATTEMPT,
        "error: largest::<V, N>(quotients.map(|quotient| quotient.error())) / V::Magnitude::of(V::UNIT),",
        "error: largest::<V, N>(quotients.map(|quotient| quotient.error())) * V::Magnitude::of(0.0),"),
    rule("a narrower scalar that does not round", ATTEMPT,
        "(exactly(&rounded[i]) - self.next[i]).size()", "(exactly(&rounded[i]) - self.next[i]).size() * V::Magnitude::of(0.0)"),
    rule("inputs of any size", ATTEMPT,
        "attempt.largest_input.allows(sum.get()).then_some(attempt)", "attempt.largest_input.allows(V::Magnitude::zero()).then_some(attempt)"),
    rule("a promise of ten times as much", RUNGS,
        "const PROMISE: f64 = 63.0;", "const PROMISE: f64 = 630.0;"),
    rule("a pair of floats that is better than it is", FORMATS,
        "f64::EPSILON * f64::EPSILON * 4.0", "f64::EPSILON * f64::EPSILON * 3.0"),
    // The last rungs' numbers.
    digit("a product without the radius of a factor", WIDE,
        "self.size() * other.radius + (other.size() + other.radius) * self.radius", "(other.size() + other.radius) * self.radius"),
    digit("a sum without the radius of a term", WIDE,
        "self.radius + other.radius)", "self.radius)"),
    digit("a quotient without the radius of its divisor", WIDE,
        "(self.radius + quotient.size() * other.radius)", "self.radius"),
    digit("a divisor that may be zero", WIDE,
        "other.radius * Size::from(64.0) <= other.size()", "other.radius <= other.size() * Size::from(64.0)"),
    digit("digits that are cut off and forgotten", "kahan-core/src/scalar/wide/rows.rs",
        "map_or(self.cut, |&digit| self.cut + from_here_on(digit))", "map_or(self.cut, |_| self.cut)"),
    digit("a division that ends early", "kahan-core/src/scalar/wide/rows.rs",
        "64 * (M / 2 - 2) / Self::GUESSED + 1", "64 * (M / 2 - 2) / Self::GUESSED / 2 + 1"),
    digit("a guess that is believed for twice its digits", "kahan-core/src/scalar/wide/rows.rs",
        "64 * (LEADING - 2) } else { 48 }", "128 * LEADING } else { 48 }"),
    digit("a rounding that is within any distance", "kahan-core/src/scalar/wide/long.rs",
        "off.size() + off.radius() <= rounded.size()", "off.radius() <= rounded.size()"),
    digit("a rounding of what is not known", "kahan-core/src/scalar/wide/long.rs",
        "off.size() + off.radius() <= rounded.size()", "off.size() <= rounded.size()"),
    // Pairs of floats: what their operations do, and what is stated of them.
    Weakening { name: "a sum of pairs without its last rest", file: MODERATE, tests: PAIRS,
        text: "fast_two_sum(sum, rest + error)", weaker: "fast_two_sum(sum, error)" },
    Weakening { name: "a product of pairs without a lower part", file: MODERATE, tests: PAIRS,
        text: "let lower = multiply_add(x.low, y.high, x.high * y.low);", weaker: "let lower = x.high * y.low;" },
    Weakening { name: "a quotient of pairs without the lower part of its divisor", file: MODERATE, tests: PAIRS,
        text: "multiply_add(-leading, y.low, x.low)", weaker: "x.low" },
    Weakening { name: "a multiply-add of pairs without a lower part", file: "kahan-core/src/scalar/dd/arithmetic.rs", tests: PAIRS,
        text: "multiply_add(x.low, y.high, multiply_add(x.high, y.low, z.low))", weaker: "multiply_add(x.high, y.low, z.low)" },
    Weakening { name: "sums of pairs said to err by 2u²", file: "kahan-core/src/tests/dd/bounds.rs", tests: PAIRS,
        text: "const SUM: i64 = 3;", weaker: "const SUM: i64 = 2;" },
    Weakening { name: "products of pairs said to err by 4u²", file: "kahan-core/src/tests/dd/bounds.rs", tests: PAIRS,
        text: "const PRODUCT: i64 = 5;", weaker: "const PRODUCT: i64 = 4;" },
    Weakening { name: "quotients of pairs said to err by 9u²", file: "kahan-core/src/tests/dd/bounds.rs", tests: PAIRS,
        text: "const QUOTIENT: i64 = 14;", weaker: "const QUOTIENT: i64 = 9;" },
    // Degrees and references.
    Weakening { name: "a degree with one spare point less", file: "kahan-discover/src/thiele.rs", tests: DEGREES,
        text: "const SPARE: usize = 4;", weaker: "const SPARE: usize = 3;" },
    Weakening { name: "a degree told when one spare point agrees", file: "kahan-discover/src/thiele.rs", tests: DEGREES,
        text: "if differences.iter().all(|&difference| difference == 0) {", weaker: "if differences.first() == Some(&0) {" },
    Weakening { name: "a certificate of the last difference", file: CERTIFICATE, tests: REFERENCES,
        text: "self.difference = self.difference.max(difference);", weaker: "self.difference = difference;" },
    Weakening { name: "a certificate of the least difference", file: CERTIFICATE, tests: REFERENCES,
        text: "if self.difference <= self.allowed {\n            self.agreed_until = t;", weaker: "if difference <= self.allowed {\n            self.agreed_until = t;" },
    // Claims on relations.
    Weakening { name: "a relation that random points do not satisfy", file: "kahan-algebra/src/prove/sample.rs", tests: RELATIONS,
        text: "impose(conditions, &arithmetic, &mut here)?;",
        weaker: "" },
    Weakening { name: "a relation whose degree does not enter the bound", file: "kahan-algebra/src/prove/sizes.rs", tests: RELATIONS,
        text: "impose(&claim.conditions, &Sizes, &mut here)?;",
        weaker: "" },
    Weakening { name: "a relation that forgets what it was divided by", file: "kahan-algebra/src/relations.rs", tests: RELATIONS,
        text: "relation = without(relation, nonzero.numerator(), &mut self.budget)?;",
        weaker: "let _ = nonzero;" },
    Weakening { name: "a relation solved for the worst name", file: "kahan-algebra/src/relations.rs", tests: RELATIONS,
        text: "if best.is_none_or(|(known, _)| rank < known) {",
        weaker: "if best.is_none_or(|(known, _)| rank >= known) {" },
    Weakening { name: "a relation that is put in where its divisor is 0", file: "kahan-algebra/src/specialise.rs", tests: RELATIONS,
        text: "if !relations.require(nonzero).ok()? {",
        weaker: "if !relations.require(nonzero).ok()? && false {" },
    Weakening { name: "a claim without the values that its relations give", file: "kahan-algebra/src/system.rs", tests: RELATIONS,
        text: "self.conditions.iter().find(|condition| condition.variable == variable)",
        weaker: "self.conditions.iter().find(|condition| condition.variable == variable && false)" },
    Weakening { name: "a sum of one product more than fit", file: "kahan-discover/src/modulus.rs", tests: ECHELONS,
        text: "PRODUCTS: usize = 8",
        weaker: "PRODUCTS: usize = 9" },
    Weakening { name: "a sum that is reduced by half", file: "kahan-discover/src/modulus.rs", tests: ECHELONS,
        text: "let quotient = if quotient >= 2 * self.prime { quotient - 2 * self.prime } else { quotient };",
        weaker: "" },
    Weakening { name: "rows that are not cleared", file: "kahan-discover/src/matrix.rs", tests: ECHELONS,
        text: "cleared(modulus, &pivots, &mut echelon, columns, deadline)?;",
        weaker: "" },
    Weakening { name: "a relation through ordinary points", file: "kahan-discover/src/scan/shapes.rs", tests: SCANS,
        text: "if is_chance || points.iter().any(|&at| !self.grid.special[at]) {",
        weaker: "if is_chance {" },
    Weakening { name: "a relation that chance may have made", file: "kahan-discover/src/scan/shapes.rs", tests: SCANS,
        text: "if is_chance || points.iter().any(|&at| !self.grid.special[at]) {",
        weaker: "if points.iter().any(|&at| !self.grid.special[at]) {" },
    Weakening { name: "a claim on a relation that holds without it", file: "kahan-discover/src/scan/proposals.rs", tests: SCANS,
        text: "if self.claims.is_proved(&claim(&fixed)) || !self.claims.is_proved(&on_relation) {",
        weaker: "if !self.claims.is_proved(&on_relation) {" },
    // What is kept of a text.
    Weakening { name: "a sum in which a name cancels and that stands", file: "kahan-algebra/src/check/expand.rs", tests: KEPT,
        text: "if extents.into_iter().all(still_has) { sum } else { self.without_kept(sum) }",
        weaker: "{ let _ = extents.into_iter().all(still_has); sum }" },
    Weakening { name: "a divisor that is none of the field's", file: "kahan-algebra/src/check/expand.rs", tests: KEPT,
        text: "kept.filter(|kept| self.values.divide_only_by(kept, &denominator))",
        weaker: "kept" },
    Weakening { name: "a map over values that is less reduced", file: "kahan-algebra/src/kahan/rational_map.rs", tests: KEPT,
        text: "degrees(self, symbols) == degrees(other, others)",
        weaker: "degrees(self, symbols).len() == degrees(other, others).len()" },
    Weakening { name: "products that are expanded", file: "kahan-algebra/src/check/expand.rs", tests: TEXTS,
        text: "Some(&self.factor(a) * &self.factor(b))",
        weaker: "Some(a.kept() * b.kept())" },
    Weakening { name: "a factor whose terms are added in any order", file: "kahan-algebra/src/check/expand.rs", tests: KEPT,
        text: "of.order.split_first()",
        weaker: "of.order.split_first().filter(|_| false)" },
    Weakening { name: "steps from sums that are expanded", file: "kahan-algebra/src/plan/step/mod.rs", tests: TEXTS,
        text: "kept.needs_sums(&field.symbols) && ",
        weaker: "kept.needs_sums(&field.symbols) && false && " },
    Weakening { name: "a chain that keeps nothing of its family", file: "kahan-algebra/src/family/expand.rs", tests: TEXTS,
        text: "Kept::new(values, kept)",
        weaker: "Kept::of(&field)" },
    Weakening { name: "a system with values that keeps nothing", file: "kahan-algebra/src/specialise.rs", tests: TEXTS,
        text: "kept.unwrap_or_else(|| Kept::of(&field))",
        weaker: "kept.filter(|_| false).unwrap_or_else(|| Kept::of(&field))" },
];
