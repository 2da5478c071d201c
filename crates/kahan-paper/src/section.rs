//! Sections of the paper.

/// A section of the paper. Claims are grouped by section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Section {
    /// Section 1, on Kahan's method and the Lotka-Volterra map.
    Method,
    /// Section 2, on brackets in three dimensions and the Euler top.
    Brackets,
    /// Section 3 with Table 1, on the Lie-Poisson pairs of the flows.
    FlowPairs,
    /// Section 4, on a bracket that an integral and a volume form define.
    Construction,
    /// Section 5 with Table 2 and Theorem 1, on the maps and their integrals.
    Maps,
    /// Tables 3 and 4 with Theorem 2, on the Poisson pairs of the maps.
    MapPairs,
    /// Table 5, with the solutions of the flows.
    FlowSolutions,
    /// Theorem 3, with the solutions of the maps.
    MapSolutions,
    /// Section 6, on dE7, dE8 and dE9.
    Transcendental,
    /// Section 7 with Theorem 4, on the Diophantine test.
    Diophantine,
    /// The appendix, on elliptic curves and theta functions.
    Appendix,
    /// Claims about catalog systems that are not in the paper.
    Beyond,
}

impl Section {
    /// All sections, in the order of the paper.
    pub const ALL: [Section; 12] = [
        Section::Method,
        Section::Brackets,
        Section::FlowPairs,
        Section::Construction,
        Section::Maps,
        Section::MapPairs,
        Section::FlowSolutions,
        Section::MapSolutions,
        Section::Transcendental,
        Section::Diophantine,
        Section::Appendix,
        Section::Beyond,
    ];

    /// Returns the place of the section in the paper, in one or two words.
    #[must_use]
    pub fn place(self) -> &'static str {
        self.words().0
    }

    /// Returns the subject of the section in a few words.
    #[must_use]
    pub fn subject(self) -> &'static str {
        self.words().1
    }

    fn words(self) -> (&'static str, &'static str) {
        match self {
            Section::Method => ("Section 1", "Kahan’s method"),
            Section::Brackets => ("Section 2", "brackets, the Euler top"),
            Section::FlowPairs => ("Section 3", "Lie–Poisson pairs"),
            Section::Construction => ("Section 4", "brackets from integrals"),
            Section::Maps => ("Section 5", "maps and their integrals"),
            Section::MapPairs => ("Tables 3–4", "Poisson pairs of maps"),
            Section::FlowSolutions => ("Table 5", "solutions of the flows"),
            Section::MapSolutions => ("Theorem 3", "solutions of the maps"),
            Section::Transcendental => ("Section 6", "dE7, dE8 and dE9"),
            Section::Diophantine => ("Section 7", "the Diophantine test"),
            Section::Appendix => ("Appendix", "theta functions of dE4"),
            Section::Beyond => ("Beyond", "further systems"),
        }
    }
}
