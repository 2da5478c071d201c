//! The rows of Tables 1 to 4: the Lie-Poisson pairs of the flows, the integrals and the Poisson
//! pairs of the maps.

/// One row of Tables 1 to 4. Tensors are triples ({x,y}, {y,z}, {z,x}).
#[derive(Clone, Copy, Debug)]
pub struct Structure {
    /// The system: `e1`.
    pub system: &'static str,
    /// P of Table 1.
    pub p: [&'static str; 3],
    /// Q of Table 1.
    pub q: [&'static str; 3],
    /// H of Table 1.
    pub h: &'static str,
    /// K of Table 1.
    pub k: &'static str,
    /// c of Table 1.
    pub c: &'static str,
    /// The Lie algebras of P and Q.
    pub algebras: [Algebra; 2],
    /// H(ε), K(ε), P(ε) and Q(ε) of Tables 2, 3 and 4, where they are rational.
    pub discrete: Option<Discrete>,
}

/// The part of a row that belongs to the map.
#[derive(Clone, Copy, Debug)]
pub struct Discrete {
    /// H(ε) of Table 2.
    pub h: &'static str,
    /// K(ε) of Table 2.
    pub k: &'static str,
    /// P(ε) of Table 3.
    pub p: [&'static str; 3],
    /// Q(ε) of Table 4, row 3 corrected.
    pub q: [&'static str; 3],
}

const SL: [&str; 3] = ["x", "z", "2*y"];
const SO: [&str; 3] = ["z", "x", "y"];
const SL_CASIMIR: &str = "x*z + y^2";
const SO_CASIMIR: &str = "1/2*(x^2 + y^2 + z^2)";

/// A Lie algebra by the brackets {e,f}, {f,g}, {g,e} of a basis e, f, g of linear functions.
#[derive(Clone, Copy, Debug)]
pub struct Algebra {
    /// Its name.
    pub name: &'static str,
    pub(super) basis: (&'static str, &'static str, &'static str),
    pub(super) brackets: [&'static str; 3],
}

const A33: Algebra = Algebra { name: "A(3,3)", basis: ("x", "y", "z"), brackets: ["0", "y", "-x"] };
const E11: Algebra = Algebra { name: "e(1,1)", basis: ("x", "y", "z"), brackets: ["0", "-y", "-x"] };
const E2: Algebra = Algebra { name: "e(2)", basis: ("x", "y", "z"), brackets: ["0", "x", "y"] };
/// {e,f} = h, {f,h} = 2f, {h,e} = 2e.
const SL2: Algebra = Algebra { name: "sl(2,R)", basis: ("x", "z", "-2*y"), brackets: ["-2*y", "2*z", "2*x"] };
const SO3: Algebra = Algebra { name: "so(3)", basis: ("x", "y", "z"), brackets: ["z", "x", "y"] };
const A32: Algebra = Algebra { name: "A(3,2)", basis: ("x", "y", "z"), brackets: ["0", "x + y", "-x"] };
const A3XI: Algebra =
    Algebra { name: "A(3,5) with parameter xi", basis: ("x", "y", "z"), brackets: ["0", "xi*y", "-x"] };

/// The rows.
pub(super) const STRUCTURES: [Structure; 9] = [
    Structure {
        system: "e1",
        p: ["0", "y", "-x"],
        q: SL,
        h: "y/x",
        k: SL_CASIMIR,
        c: "1/x^2",
        algebras: [A33, SL2],
        discrete: Some(Discrete {
            h: "y/x",
            k: "(x*z + y^2)/(1 - eps^2*x^2)",
            p: ["0", "y*(1 - eps^2*x^2)", "-x*(1 - eps^2*x^2)"],
            q: ["x", "(z + eps^2*x*(x*z + 2*y^2))/(1 - eps^2*x^2)", "2*y"],
        }),
    },
    Structure {
        system: "e2",
        p: ["0", "-y", "-x"],
        q: SL,
        h: "x*y",
        k: SL_CASIMIR,
        c: "1",
        algebras: [E11, SL2],
        discrete: Some(Discrete {
            h: "x*y/(1 - eps^2*x^2)",
            k: "(x*z + y^2)/(1 - eps^2*x^2)",
            p: ["0", "-y*(1 + eps^2*x^2)", "-x*(1 - eps^2*x^2)"],
            q: ["x*(1 - eps^2*x^2)", "z + eps^2*x*(x*z + 2*y^2)", "2*y*(1 - eps^2*x^2)"],
        }),
    },
    Structure {
        system: "e3",
        p: ["0", "y", "-x"],
        q: SO,
        h: "y/x",
        k: SO_CASIMIR,
        c: "1/x^2",
        algebras: [A33, SO3],
        discrete: Some(Discrete {
            h: "y/x",
            k: "1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2))",
            p: ["0", "y*(1 + eps^2*(x^2 + y^2))", "-x*(1 + eps^2*(x^2 + y^2))"],
            q: [
                "z",
                "x*(1 - eps^2*z^2)/(1 + eps^2*(x^2 + y^2))",
                "y*(1 - eps^2*z^2)/(1 + eps^2*(x^2 + y^2))",
            ],
        }),
    },
    Structure {
        system: "e4",
        p: ["0", "-y", "-x"],
        q: SO,
        h: "x*y",
        k: SO_CASIMIR,
        c: "1",
        algebras: [E11, SO3],
        discrete: Some(Discrete {
            h: "x*y/(1 + eps^2*(x^2 + y^2))",
            k: "1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2))",
            p: ["0", "-y*(1 - eps^2*(x^2 - y^2))", "-x*(1 + eps^2*(x^2 - y^2))"],
            q: ["z*(1 + eps^2*(x^2 + y^2))", "x*(1 - eps^2*z^2)", "y*(1 - eps^2*z^2)"],
        }),
    },
    Structure {
        system: "e5",
        p: ["0", "x", "y"],
        q: SL,
        h: "1/2*(x^2 + y^2)",
        k: SL_CASIMIR,
        c: "-1",
        algebras: [E2, SL2],
        discrete: Some(Discrete {
            h: "1/2*(x^2 + y^2)/(1 + eps^2*x^2)",
            k: "(x*z + y^2)/(1 + eps^2*x^2)",
            p: ["0", "x*(1 - eps^2*y^2)", "y*(1 + eps^2*x^2)"],
            q: ["x*(1 + eps^2*x^2)", "z - eps^2*x*(x*z + 2*y^2)", "2*y*(1 + eps^2*x^2)"],
        }),
    },
    Structure {
        system: "e6",
        p: SL,
        q: SO,
        h: SL_CASIMIR,
        k: SO_CASIMIR,
        c: "-1",
        algebras: [SL2, SO3],
        discrete: Some(Discrete {
            h: "(x*z + y^2)/(1 - 3*eps^2*x*z)",
            k: "1/2*(x^2 + y^2 + z^2)/(1 - 3*eps^2*x*z)",
            p: ["x*(1 + 3*eps^2*y^2)", "z*(1 + 3*eps^2*y^2)", "2*y*(1 - 3*eps^2*x*z)"],
            q: [
                "z + 3/2*eps^2*x*(x^2 + y^2 - z^2)",
                "x + 3/2*eps^2*z*(z^2 + y^2 - x^2)",
                "y*(1 - 3*eps^2*x*z)",
            ],
        }),
    },
    Structure {
        system: "e7",
        p: ["0", "xi*y", "-x"],
        q: SL,
        h: "y*x^(-xi)",
        k: SL_CASIMIR,
        c: "x^(-xi - 1)",
        algebras: [A3XI, SL2],
        discrete: None,
    },
    Structure {
        system: "e8",
        p: ["0", "x + y", "-x"],
        q: SL,
        h: "x*exp(-y/x)",
        k: SL_CASIMIR,
        c: "-exp(-y/x)/x",
        algebras: [A32, SL2],
        discrete: None,
    },
    Structure {
        system: "e9",
        p: ["0", "xi*y", "-x"],
        q: SO,
        h: "y*x^(-xi)",
        k: SO_CASIMIR,
        c: "x^(-xi - 1)",
        algebras: [A3XI, SO3],
        discrete: None,
    },
];

/// The Lie-Poisson pair of a system E1 to E9, and what is known of its map.
#[must_use]
pub fn structure(system: &str) -> Option<&'static Structure> {
    STRUCTURES.iter().find(|structure| structure.system == system)
}

/// The names of the entries of a tensor.
pub(super) const ENTRIES: [&str; 3] = ["12", "23", "31"];

impl Structure {
    /// P, Q, H, K and c as definitions.
    #[must_use]
    pub fn definitions(&self) -> String {
        let mut text = format!("H := {}; K := {}; c := {}; ", self.h, self.k, self.c);
        text += &triple("P", "", &self.p);
        text += &triple("Q", "", &self.q);
        if let Some(map) = &self.discrete {
            text += &format!("H_eps := {}; K_eps := {}; ", map.h, map.k);
            text += &triple("P", "_eps", &map.p);
            text += &triple("Q", "_eps", &map.q);
        }
        text
    }
}

/// The entries of a tensor as definitions: `P12 := …; P23 := …; P31 := …; `.
pub(super) fn triple(name: &str, suffix: &str, entries: &[&str; 3]) -> String {
    ENTRIES.iter().zip(entries).map(|(index, value)| format!("{name}{index}{suffix} := {value}; ")).collect()
}
