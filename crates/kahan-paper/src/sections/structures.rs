//! The rows of Tables 1 to 4: Lie-Poisson pairs of the flows, and integrals and Poisson pairs of
//! the maps. The rows of E7 to E9, from section 6, are about flows only.

/// A row of Tables 1 to 4.
#[derive(Clone, Copy, Debug)]
pub struct StructureRow {
    /// The name of the system in commands, for example `e1`.
    pub system: &'static str,
    /// The Lie algebras of the tensors P and Q.
    pub algebras: [Algebra; 2],
    /// The definitions of H, K, c, P and Q in Table 1. Names that end in `_eps` are those of the
    /// map, in Tables 2 to 4. `P12`, `P23` and `P31` are {x,y}, {y,z} and {z,x}.
    pub definitions: &'static str,
}

/// A Lie algebra, given by the brackets of a basis of three linear functions.
#[derive(Clone, Copy, Debug)]
pub struct Algebra {
    /// The name of the algebra.
    pub name: &'static str,
    pub(super) basis: (&'static str, &'static str, &'static str),
    pub(super) brackets: [&'static str; 3],
}

const A33: Algebra = Algebra { name: "A(3,3)", basis: ("x", "y", "z"), brackets: ["0", "y", "-x"] };
const E11: Algebra = Algebra { name: "e(1,1)", basis: ("x", "y", "z"), brackets: ["0", "-y", "-x"] };
const E2: Algebra = Algebra { name: "e(2)", basis: ("x", "y", "z"), brackets: ["0", "x", "y"] };
/// The algebra sl(2,ℝ) of e = x, f = z and h = −2y: {e,f} = h, {f,h} = 2f and {h,e} = 2e.
const SL2: Algebra = Algebra { name: "sl(2,R)", basis: ("x", "z", "-2*y"), brackets: ["-2*y", "2*z", "2*x"] };
const SO3: Algebra = Algebra { name: "so(3)", basis: ("x", "y", "z"), brackets: ["z", "x", "y"] };
const A32: Algebra = Algebra { name: "A(3,2)", basis: ("x", "y", "z"), brackets: ["0", "x + y", "-x"] };
const A3XI: Algebra =
    Algebra { name: "A(3,5) with parameter xi", basis: ("x", "y", "z"), brackets: ["0", "xi*y", "-x"] };

pub(super) const STRUCTURES: [StructureRow; 9] = [
    StructureRow {
        system: "e1",
        algebras: [A33, SL2],
        definitions: "
            H := y/x; K := x*z + y^2; c := 1/x^2;
            P12 := 0; P23 := y; P31 := -x; Q12 := x; Q23 := z; Q31 := 2*y;
            H_eps := y/x; K_eps := (x*z + y^2)/(1 - eps^2*x^2);
            P12_eps := 0; P23_eps := y*(1 - eps^2*x^2); P31_eps := -x*(1 - eps^2*x^2);
            Q12_eps := x; Q23_eps := (z + eps^2*x*(x*z + 2*y^2))/(1 - eps^2*x^2); Q31_eps := 2*y",
    },
    StructureRow {
        system: "e2",
        algebras: [E11, SL2],
        definitions: "
            H := x*y; K := x*z + y^2; c := 1;
            P12 := 0; P23 := -y; P31 := -x; Q12 := x; Q23 := z; Q31 := 2*y;
            H_eps := x*y/(1 - eps^2*x^2); K_eps := (x*z + y^2)/(1 - eps^2*x^2);
            P12_eps := 0; P23_eps := -y*(1 + eps^2*x^2); P31_eps := -x*(1 - eps^2*x^2);
            Q12_eps := x*(1 - eps^2*x^2); Q23_eps := z + eps^2*x*(x*z + 2*y^2);
            Q31_eps := 2*y*(1 - eps^2*x^2)",
    },
    StructureRow {
        system: "e3",
        algebras: [A33, SO3],
        definitions: "
            H := y/x; K := 1/2*(x^2 + y^2 + z^2); c := 1/x^2;
            P12 := 0; P23 := y; P31 := -x; Q12 := z; Q23 := x; Q31 := y;
            H_eps := y/x; K_eps := 1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2));
            P12_eps := 0; P23_eps := y*(1 + eps^2*(x^2 + y^2)); P31_eps := -x*(1 + eps^2*(x^2 + y^2));
            Q12_eps := z; Q23_eps := x*(1 - eps^2*z^2)/(1 + eps^2*(x^2 + y^2));
            Q31_eps := y*(1 - eps^2*z^2)/(1 + eps^2*(x^2 + y^2))",
    },
    StructureRow {
        system: "e4",
        algebras: [E11, SO3],
        definitions: "
            H := x*y; K := 1/2*(x^2 + y^2 + z^2); c := 1;
            P12 := 0; P23 := -y; P31 := -x; Q12 := z; Q23 := x; Q31 := y;
            H_eps := x*y/(1 + eps^2*(x^2 + y^2)); K_eps := 1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2));
            P12_eps := 0; P23_eps := -y*(1 - eps^2*(x^2 - y^2)); P31_eps := -x*(1 + eps^2*(x^2 - y^2));
            Q12_eps := z*(1 + eps^2*(x^2 + y^2)); Q23_eps := x*(1 - eps^2*z^2);
            Q31_eps := y*(1 - eps^2*z^2)",
    },
    StructureRow {
        system: "e5",
        algebras: [E2, SL2],
        definitions: "
            H := 1/2*(x^2 + y^2); K := x*z + y^2; c := -1;
            P12 := 0; P23 := x; P31 := y; Q12 := x; Q23 := z; Q31 := 2*y;
            H_eps := 1/2*(x^2 + y^2)/(1 + eps^2*x^2); K_eps := (x*z + y^2)/(1 + eps^2*x^2);
            P12_eps := 0; P23_eps := x*(1 - eps^2*y^2); P31_eps := y*(1 + eps^2*x^2);
            Q12_eps := x*(1 + eps^2*x^2); Q23_eps := z - eps^2*x*(x*z + 2*y^2);
            Q31_eps := 2*y*(1 + eps^2*x^2)",
    },
    StructureRow {
        system: "e6",
        algebras: [SL2, SO3],
        definitions: "
            H := x*z + y^2; K := 1/2*(x^2 + y^2 + z^2); c := -1;
            P12 := x; P23 := z; P31 := 2*y; Q12 := z; Q23 := x; Q31 := y;
            H_eps := (x*z + y^2)/(1 - 3*eps^2*x*z); K_eps := 1/2*(x^2 + y^2 + z^2)/(1 - 3*eps^2*x*z);
            P12_eps := x*(1 + 3*eps^2*y^2); P23_eps := z*(1 + 3*eps^2*y^2);
            P31_eps := 2*y*(1 - 3*eps^2*x*z);
            Q12_eps := z + 3/2*eps^2*x*(x^2 + y^2 - z^2); Q23_eps := x + 3/2*eps^2*z*(z^2 + y^2 - x^2);
            Q31_eps := y*(1 - 3*eps^2*x*z)",
    },
    StructureRow {
        system: "e7",
        algebras: [A3XI, SL2],
        definitions: "
            H := y*x^(-xi); K := x*z + y^2; c := x^(-xi - 1);
            P12 := 0; P23 := xi*y; P31 := -x; Q12 := x; Q23 := z; Q31 := 2*y",
    },
    StructureRow {
        system: "e8",
        algebras: [A32, SL2],
        definitions: "
            H := x*exp(-y/x); K := x*z + y^2; c := -exp(-y/x)/x;
            P12 := 0; P23 := x + y; P31 := -x; Q12 := x; Q23 := z; Q31 := 2*y",
    },
    StructureRow {
        system: "e9",
        algebras: [A3XI, SO3],
        definitions: "
            H := y*x^(-xi); K := 1/2*(x^2 + y^2 + z^2); c := x^(-xi - 1);
            P12 := 0; P23 := xi*y; P31 := -x; Q12 := z; Q23 := x; Q31 := y",
    },
];

/// Returns the Poisson structures and integrals of one of the systems E1 to E9 and of its map.
#[must_use]
pub fn structure(system: &str) -> Option<&'static StructureRow> {
    STRUCTURES.iter().find(|structure| structure.system == system)
}

impl StructureRow {
    /// Returns whether the map's integrals and Poisson pair are rational.
    #[must_use]
    pub fn has_map(&self) -> bool {
        self.value("H_eps").is_some()
    }

    /// Returns the formula that the row defines for a name.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<&'static str> {
        self.pairs().find(|(defined, _)| *defined == name).map(|(_, value)| value)
    }

    pub(super) fn pairs(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        let pairs = self.definitions.split(';').filter_map(|definition| definition.split_once(":="));
        pairs.map(|(name, value)| (name.trim(), value.trim()))
    }
}
