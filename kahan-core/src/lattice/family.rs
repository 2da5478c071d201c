//! The boundary condition of a chain, and the sizes of its equations, as values or as a type.

/// The boundary condition of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Boundary {
    /// Site n is site 0.
    Periodic,
    /// States and parameters beyond the ends are 0.
    Open,
}

/// The sizes of a family's equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// The number of arrays per site.
    pub block: usize,
    /// The largest offset of a neighbour, at least 1.
    pub reach: usize,
    /// The number of parameters per site.
    pub parameters: usize,
    /// The lower bandwidth of A, in unknowns.
    pub lower: usize,
    /// The upper bandwidth of A, in unknowns.
    pub upper: usize,
    /// The number of scalar registers for the equations of one site.
    pub registers: usize,
    /// The number of registers for the equations of one site per SIMD lane.
    pub registers_abreast: usize,
}

/// The sizes of a family's equations as a type, which selects its kernels.
///
/// | parameter | meaning |
/// |---|---|
/// | `B` | arrays |
/// | `R` | the largest offset of a neighbour, at least 1 |
/// | `P` | parameters per site |
/// | `C` | prepared constants |
/// | `LOWER` | the lower bandwidth of A, in unknowns |
/// | `UPPER` | the upper bandwidth |
/// | `SITES` | 2R + 1, the sites in the equations of one site |
/// | `WIDTH` | `LOWER` + 1 + `UPPER`, the entries of a row of the band |
///
/// The entry of row (i, b) in column (i + o, b′) lies o·B + b′ − b to the right of the diagonal.
/// The last two sizes follow from the others, because array lengths cannot be computed from type
/// parameters. Wrong values do not compile.
#[derive(Clone, Copy, Debug)]
pub struct Stencil<
    const B: usize,
    const R: usize,
    const P: usize,
    const C: usize,
    const LOWER: usize,
    const UPPER: usize,
    const SITES: usize,
    const WIDTH: usize,
>;

impl<
    const B: usize,
    const R: usize,
    const P: usize,
    const C: usize,
    const LOWER: usize,
    const UPPER: usize,
    const SITES: usize,
    const WIDTH: usize,
> Stencil<B, R, P, C, LOWER, UPPER, SITES, WIDTH>
{
    /// The sizes as values.
    pub const SIZES: Sizes = {
        assert!(B > 0 && R > 0 && SITES == 2 * R + 1 && WIDTH == LOWER + 1 + UPPER);
        assert!(LOWER < (R + 1) * B && UPPER < (R + 1) * B);
        Sizes {
            block: B,
            reach: R,
            parameters: P,
            lower: LOWER,
            upper: UPPER,
            registers: 0,
            registers_abreast: 0,
        }
    };
}
