//! Computes derivatives, replaces variables, and groups terms by some of the variables.

use kahan_syntax::rational::Rational;
use kahan_syntax::table::{Table, sorted_by_key};

use super::{Budget, Monomial, Polynomial, Term, Variable, WithinBudget};

impl Polynomial {
    /// Returns the partial derivative with respect to a variable.
    pub fn derivative(&self, variable: Variable) -> Self {
        let mut terms = Vec::new();
        for (monomial, coefficient) in &self.terms {
            if let Some(lowered) = monomial.lowered(variable) {
                let exponent = Rational::from(i64::from(monomial.exponent(variable)));
                terms.push((lowered, coefficient * &exponent));
            }
        }
        Self::from_sorted(terms)
    }

    /// Returns the nonzero derivatives with respect to variables that satisfy `is_wanted`, in one
    /// pass.
    pub fn gradient(&self, is_wanted: impl Fn(Variable) -> bool) -> Table<Variable, Self> {
        let mut slopes: Table<Variable, Vec<Term>> = Table::new();
        for (monomial, coefficient) in &self.terms {
            for &(variable, exponent) in monomial.powers() {
                if let Some(lowered) = monomial.lowered(variable).filter(|_| is_wanted(variable)) {
                    let slope = coefficient * &Rational::from(i64::from(exponent));
                    slopes.or_insert_with(variable, |_| Vec::new()).push((lowered, slope));
                }
            }
        }
        slopes.into_iter().map(|(variable, terms)| (variable, Self::from_sorted(terms))).collect()
    }

    /// Replaces `variable` by a number.
    pub fn substitute(&self, variable: Variable, value: &Rational) -> Self {
        let mut powers: Table<u32, Rational> = Table::new();
        Self::from_terms(self.terms.iter().map(|(monomial, coefficient)| {
            let (power, rest) = monomial.split(|other| other == variable);
            let power = powers.or_insert_with(power.degree(), |exponent| power_of(value, *exponent));
            (rest, coefficient * power)
        }))
    }

    /// Replaces `variable` by another polynomial.
    ///
    /// # Panics
    /// If a total degree exceeds 2²⁴.
    pub fn composed(&self, variable: Variable, value: &Self) -> Self {
        let degree = self.degree_in(variable);
        self.homogenised_at(variable, (value, &Self::one()), degree, &mut Budget::unlimited())
            .expect("total degrees stay below 2^24")
    }

    /// Let v = `variable` and d = `degree`, which is at least the degree in v. Turns Σ cₖ vᵏ into
    /// bᵈ Σ cₖ (a/b)ᵏ = Σ cₖ aᵏ bᵈ⁻ᵏ.
    ///
    /// # Errors
    /// If the budget runs out.
    pub fn homogenised_at(
        &self,
        variable: Variable,
        (a, b): (&Self, &Self),
        degree: u32,
        budget: &mut Budget,
    ) -> WithinBudget<Self> {
        let mut sum = Self::zero();
        for (exponent, coefficient) in self.coefficients_in(variable) {
            let power = a.pow_within(exponent, budget)?;
            let rest = b.pow_within(degree - exponent, budget)?;
            let term = coefficient.mul_within(&power, budget)?.mul_within(&rest, budget)?;
            sum = sum.add_within(&term, budget)?;
        }
        Ok(sum)
    }

    /// Renames each variable. Variables with equal new names become one.
    pub fn map_variables(&self, mut rename: impl FnMut(Variable) -> Variable) -> Self {
        self.map_monomials(|monomial| {
            let powers = monomial.powers().iter().map(|&(variable, exponent)| (rename(variable), exponent));
            Some(powers.collect())
        })
    }

    /// Replaces each monomial by the result of `change`. Terms with the result `None` are dropped.
    pub fn map_monomials(&self, mut change: impl FnMut(&Monomial) -> Option<Monomial>) -> Self {
        let terms = self.terms.iter();
        Self::from_terms(terms.filter_map(|(monomial, value)| Some((change(monomial)?, value.clone()))))
    }

    /// Returns q and r with polynomial = v·q + r, where r does not contain v.
    pub fn split_at(self, variable: Variable) -> (Self, Self) {
        let (mut quotient, mut rest) = (Vec::new(), Vec::new());
        for (monomial, coefficient) in self.terms {
            match monomial.lowered(variable) {
                Some(lowered) => quotient.push((lowered, coefficient)),
                None => rest.push((monomial, coefficient)),
            }
        }
        (Self::from_sorted(quotient), Self::from_sorted(rest))
    }

    /// Returns q₁, …, qₙ and r with polynomial = v₁·q₁ + … + vₙ·qₙ + r, in one pass. The remainder
    /// r contains none of the variables vᵢ. Each term goes to its first vᵢ.
    pub fn split_among(&self, variables: &[Variable]) -> (Vec<Self>, Self) {
        let ranks =
            sorted_by_key(variables.iter().copied().zip(0..variables.len()), |(variable, _)| *variable);
        let rank = |variable: &Variable| {
            let place = ranks.binary_search_by_key(variable, |(known, _)| *known).ok()?;
            Some(ranks[place].1)
        };
        let (mut quotients, mut rest) = (vec![Vec::new(); variables.len()], Vec::new());
        for (monomial, coefficient) in &self.terms {
            let first = monomial.powers().iter().filter_map(|(variable, _)| rank(variable)).min();
            match first.and_then(|first| Some((first, monomial.lowered(variables[first])?))) {
                Some((first, lowered)) => quotients[first].push((lowered, coefficient.clone())),
                None => rest.push((monomial.clone(), coefficient.clone())),
            }
        }
        (quotients.into_iter().map(Self::from_sorted).collect(), Self::from_sorted(rest))
    }

    /// Returns the number of terms that contain each variable.
    pub fn frequencies(&self) -> Vec<(Variable, usize)> {
        let mut counts: Vec<(Variable, usize)> = Vec::new();
        for (monomial, _) in &self.terms {
            for (variable, _) in monomial.powers() {
                match counts.binary_search_by_key(variable, |(known, _)| *known) {
                    Ok(place) => counts[place].1 += 1,
                    Err(place) => counts.insert(place, (*variable, 1)),
                }
            }
        }
        counts
    }

    /// Returns the nonzero coefficients of the powers of `variable`, by exponent.
    pub fn coefficients_in(&self, variable: Variable) -> Table<u32, Self> {
        let groups = self.group(|other| other == variable).into_iter();
        groups.map(|(power, coefficient)| (power.degree(), coefficient)).collect()
    }

    /// Returns the coefficient of the highest power of `variable`. The polynomial 0 has the
    /// coefficient 0.
    pub fn leading_coefficient_in(&self, variable: Variable) -> Self {
        let degree = self.degree_in(variable);
        let power = Monomial::power(variable, degree);
        let highest = self.terms().filter(|(monomial, _)| monomial.exponent(variable) == degree);
        let divided = highest.filter_map(|(monomial, value)| Some((monomial.div(&power)?, value.clone())));
        Self::from_sorted(divided.collect())
    }

    /// Groups the polynomial by monomials in the variables that satisfy `belongs`. Returns the
    /// coefficient of each monomial.
    pub fn group(&self, mut belongs: impl FnMut(Variable) -> bool) -> Table<Monomial, Self> {
        self.grouped(&mut belongs)
    }

    fn grouped(&self, belongs: &mut dyn FnMut(Variable) -> bool) -> Table<Monomial, Self> {
        let split = self.terms.iter().map(|(monomial, _)| monomial.split(&mut *belongs));
        let split: Vec<(Monomial, Monomial)> = split.collect();
        let mut order: Vec<usize> = (0..split.len()).collect();
        order.sort_by(|&left, &right| split[left].0.cmp(&split[right].0));
        let mut groups: Vec<(Monomial, Self)> = Vec::new();
        for index in order {
            let (key, rest) = &split[index];
            let term: Term = (rest.clone(), self.terms[index].1.clone());
            match groups.last_mut() {
                Some((known, group)) if known == key => group.terms.push(term),
                _ => groups.push((key.clone(), Self::from_sorted(vec![term]))),
            }
        }
        Table::from_sorted(groups)
    }
}

fn power_of(value: &Rational, exponent: u32) -> Rational {
    let exponent = i32::try_from(exponent).expect("degrees stay below 2^31");
    value.pow(exponent).expect("the exponent is not negative")
}
