//! The ends of a chain, and the sizes of its equations, as values or as a type.

/// What lies beyond the two ends of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Boundary {
    /// The other end: site n is site 0.
    Periodic,
    /// Nothing: states and parameters there are 0.
    Open,
}

/// The sizes of a family's lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Arrays a site.
    pub block: usize,
    /// The largest offset, at least 1.
    pub reach: usize,
    /// Parameters a site.
    pub parameters: usize,
    /// The largest distance, in unknowns, of an entry of A to the left of the diagonal.
    pub lower: usize,
    /// The largest such distance to the right of the diagonal.
    pub upper: usize,
    /// The scalars that a line of one site computes in.
    pub registers: usize,
    /// The registers that lines of gathered sites compute in.
    pub registers_abreast: usize,
}

/// The sizes of a family's line, as one type, and its kernels.
///
/// | parameter | what it is |
/// |---|---|
/// | `B` | arrays a site |
/// | `R` | the largest offset, at least 1 |
/// | `P` | parameters a site |
/// | `C` | prepared constants |
/// | `LOWER` | the largest distance, in unknowns, of an entry of A to the left of the diagonal |
/// | `UPPER` | the same to the right |
/// | `SITES` | 2R + 1, the sites that a line sees |
/// | `WIDTH` | `LOWER` + 1 + `UPPER`, the entries of a row of the band |
///
/// The entry of row (i, b) at column (i + o, b′) lies o·B + b′ − b to the right of the diagonal.
/// The last two sizes follow from the others and are written out because array lengths are not
/// computed from parameters of a type; wrong ones do not compile.
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
