//! Random fields with extreme coefficients, which test error bounds far from ordinary numbers.
//!
//! Literals lie between 2^-1070 and 2^1020. Some fields have coefficients that nearly cancel. Some
//! have parameters, or polynomials in them, as divisors.

use kahan_algebra::prime_field::SplitMix64;

use super::header;

#[derive(Clone, Debug)]
pub(crate) struct OddField {
    pub(crate) name: String,
    pub(crate) equations: String,
    pub(crate) parameters: Vec<String>,
}

impl OddField {
    pub(crate) fn block(&self) -> String {
        let parameters: Vec<&str> = self.parameters.iter().map(String::as_str).collect();
        format!("{} {}", header(&self.name, &parameters), self.equations)
    }
}

/// Draws the field with this number. Successive numbers cycle through 1 to 8 variables.
pub(crate) fn odd(seed: u64, number: usize) -> OddField {
    plain(seed, number, "Odd", 1 + number % 8)
}

pub(crate) fn plain(seed: u64, number: usize, title: &str, variables: usize) -> OddField {
    let mut draw = Draw::new(seed, title, number);
    draw.states = (1..=variables).map(|k| format!("x{k}")).collect();
    draw.take_parameters();
    // Every 35th field is dense. As 35 is coprime to 8, all eight numbers of variables occur.
    let is_dense = title == "Odd" && number % 35 == 34;
    let equations: Vec<String> = (0..variables)
        .map(|k| format!("x{}dot = {};", k + 1, if is_dense { draw.dense() } else { draw.sum() }))
        .collect();
    draw.finish(format!("{title}{number}"), equations.join(" "))
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Literals,
    Cancelling,
    Divisors,
    All,
}

pub(crate) struct Draw {
    random: SplitMix64,
    kind: Kind,
    pub(crate) states: Vec<String>,
    pub(crate) parameters: Vec<String>,
    divisors: Vec<String>,
    /// The largest j in names such as `x[i+j]` in the equations of a chain. For other fields 0.
    pub(crate) offsets: i64,
    /// The coefficient n·2^k that was written last, as the pair (n, k).
    last: (u64, i64),
}

impl Draw {
    pub(crate) fn new(seed: u64, title: &str, number: usize) -> Self {
        let random = SplitMix64::from_bytes(format!("{title} {seed} {number}").as_bytes());
        // Division by 8 lets every kind occur with each of the eight numbers of variables.
        let kind = [Kind::Literals, Kind::Cancelling, Kind::Divisors, Kind::All][number / 8 % 4];
        let (states, parameters, divisors) = (Vec::new(), Vec::new(), Vec::new());
        Self { random, kind, states, parameters, divisors, offsets: 0, last: (3, 0) }
    }

    pub(crate) fn below(&mut self, bound: usize) -> usize {
        self.random.below(bound as u64) as usize
    }

    fn between(&mut self, low: i64, high: i64) -> i64 {
        low + self.random.below((high - low + 1) as u64) as i64
    }

    pub(crate) fn take_parameters(&mut self) {
        let names: &[&str] = match self.kind {
            Kind::Literals | Kind::Cancelling => &[],
            Kind::Divisors => &["p", "q", "r"],
            Kind::All => &["p", "q"],
        };
        self.parameters = names.iter().map(|name| (*name).to_owned()).collect();
    }

    fn written((integer, exponent): (u64, i64)) -> String {
        match exponent {
            0 => integer.to_string(),
            1.. if integer == 1 => format!("2^{exponent}"),
            1.. => format!("{integer}*2^{exponent}"),
            _ => format!("{integer}/2^{}", -exponent),
        }
    }

    /// Writes a literal between 2^-1070 and 2^1020, often of ordinary size.
    fn literal(&mut self) -> String {
        let is_ordinary = self.kind == Kind::Cancelling && self.below(3) > 0 || self.below(3) == 0;
        let binade = if is_ordinary { self.between(-4, 4) } else { self.between(-1070, 1019) };
        match self.below(8) {
            0 => {
                let power = binade * 301 / 1000;
                let digits = self.random.next_u64() >> self.below(60);
                format!("{}.{}e{power}", 1 + self.below(9), digits)
            }
            1..=3 => {
                let integer = 1 + 2 * self.below(8) as u64;
                self.noted(integer, binade - i64::from(integer.ilog2()))
            }
            _ => {
                let integer = self.random.next_u64() >> 11 | 1 << 52;
                self.noted(integer, binade - 52)
            }
        }
    }

    fn noted(&mut self, integer: u64, exponent: i64) -> String {
        self.last = (integer, exponent);
        Self::written(self.last)
    }

    /// Writes the previous coefficient again, or one that differs by some units in the last place.
    fn near_last(&mut self) -> String {
        let (integer, exponent) = self.last;
        let room = 10;
        let units = self.between(-40, 40);
        let moved = (i128::from(integer) << room) + i128::from(units << self.below(10));
        if moved <= 0 || self.below(3) == 0 {
            return Self::written(self.last);
        }
        match exponent - room {
            0 => moved.to_string(),
            e if e > 0 => format!("{moved}*2^{e}"),
            e => format!("{moved}/2^{}", -e),
        }
    }

    /// Returns one of at most three divisors, which contain no states. With more divisors,
    /// expansions become long.
    fn divisor(&mut self) -> String {
        const MOST: usize = 3;
        if self.divisors.len() < MOST {
            let divisor = self.new_divisor();
            self.divisors.push(divisor);
        }
        let chosen = self.below(self.divisors.len());
        self.divisors[chosen].clone()
    }

    fn new_divisor(&mut self) -> String {
        let (p, q) = (self.parameter(), self.parameter());
        match self.below(6) {
            0 => p,
            1 | 2 if p != q => format!("({p} - {q})"),
            3 => format!("({p} + {})", self.literal()),
            4 if p != q => format!("({p}*{q} - {})", self.literal()),
            5 => format!("({p} - {q} + {p}*{q})"),
            _ => format!("(1 + {p}^2)"),
        }
    }

    fn parameter(&mut self) -> String {
        self.parameters[self.random.below(self.parameters.len() as u64) as usize].clone()
    }

    fn coefficient(&mut self) -> String {
        let has_parameters = !self.parameters.is_empty();
        match self.below(6) {
            0 | 1 if has_parameters => format!("1/{}", self.divisor()),
            2 if has_parameters => format!("{}/{}", self.parameter(), self.divisor()),
            3 if has_parameters => {
                let (p, q) = (self.parameter(), self.parameter());
                if p == q { format!("{p}*{}", self.literal()) } else { format!("({p} - {q})") }
            }
            0..=2 if self.kind != Kind::Literals => self.near_last(),
            _ => self.literal(),
        }
    }

    fn state(&mut self) -> String {
        let name = self.states[self.random.below(self.states.len() as u64) as usize].clone();
        match (self.offsets, self.between(-self.offsets, self.offsets)) {
            (0, _) => name,
            (_, 0) => format!("{name}[i]"),
            (_, offset) => format!("{name}[i{offset:+}]"),
        }
    }

    fn term(&mut self) -> String {
        let (coefficient, x, y) = (self.coefficient(), self.state(), self.state());
        match self.below(9) {
            0 => coefficient,
            1 | 2 => format!("{coefficient}*{x}"),
            3 if self.kind != Kind::Literals && x != y => {
                let near = self.near_last();
                format!("({coefficient}*{x} - {near}*{y})*({x} - {y})")
            }
            4 if self.kind != Kind::Literals && x != y => {
                let near = self.near_last();
                format!("{coefficient}*{x}*{y} - {near}*{x}^2")
            }
            _ => format!("{coefficient}*{x}*{y}"),
        }
    }

    pub(crate) fn sum(&mut self) -> String {
        let terms: Vec<String> = (0..=self.below(3)).map(|_| self.term()).collect();
        self.joined(&terms)
    }

    fn dense(&mut self) -> String {
        let states = self.states.clone();
        let mut terms = vec![self.coefficient()];
        for (k, x) in states.iter().enumerate() {
            terms.push(format!("{}*{x}", self.coefficient()));
            terms.extend(states[k..].iter().map(|y| format!("{}*{x}*{y}", self.coefficient())));
        }
        self.joined(&terms)
    }

    fn joined(&mut self, terms: &[String]) -> String {
        let mut text = String::new();
        for (k, term) in terms.iter().enumerate() {
            let is_negative = self.below(2) == 0;
            text += match (k, is_negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            };
            text += term;
        }
        text
    }

    /// Completes the field, and keeps only the parameters that its equations use.
    fn finish(mut self, name: String, equations: String) -> OddField {
        let words: Vec<&str> = equations.split(|c: char| !c.is_ascii_alphanumeric()).collect();
        self.parameters.retain(|name| words.contains(&&**name));
        OddField { name, parameters: self.parameters, equations }
    }
}
