//! How a chain is cut into parts.
//!
//! In: the number of sites, the reach, the lanes. Out: separators of R sites, each followed by an
//! interior, in groups of as many parts as the widest register has lanes; in a group all parts have
//! one length. Nothing else decides it, so that the bits of a step depend on nothing else. The
//! sites that are left over, at least R of them, close the chain.

/// How long a part is meant to be, in sites: long beside its separator, short enough that a group
/// of parts stays in a cache near the processor.
const LENGTH: usize = 256;

/// A chain's parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::lattice) struct Partition {
    sites: usize,
    reach: usize,
    lanes: usize,
    groups: usize,
    /// The sites of the shorter parts.
    length: usize,
    /// The number of groups, from the first on, whose parts have a site more.
    longer: usize,
}

impl Partition {
    /// The parts of a chain, unless it is too short to be cut.
    pub(in crate::lattice) fn new(sites: usize, reach: usize, lanes: usize) -> Option<Self> {
        Self::with_length(sites, reach, lanes, LENGTH, 4 * reach)
    }

    /// The same, with parts of about this length, and never fewer sites than `least`.
    pub(in crate::lattice) fn with_length(
        sites: usize,
        reach: usize,
        lanes: usize,
        about: usize,
        least: usize,
    ) -> Option<Self> {
        // Fewer than three reaches would let the neighbourhood of a separator see past a part.
        let least = least.max(3 * reach);
        let covered = sites.checked_sub(reach)?;
        let groups = (covered / (lanes * about)).max(1);
        let length = covered / (lanes * groups);
        let longer = covered / lanes - length * groups;
        (length >= least).then_some(Self { sites, reach, lanes, groups, length, longer })
    }

    /// Parts a group.
    pub(super) fn lanes(&self) -> usize {
        self.lanes
    }

    pub(super) fn groups(&self) -> usize {
        self.groups
    }

    pub(super) fn parts(&self) -> usize {
        self.groups * self.lanes
    }

    /// The first site of a group, or past the last group the first that is left over.
    pub(super) fn start(&self, group: usize) -> usize {
        self.lanes * (group * self.length + group.min(self.longer))
    }

    /// The sites of each part of a group, its separator included.
    pub(super) fn length(&self, group: usize) -> usize {
        self.length + usize::from(group < self.longer)
    }

    /// The most sites of a part.
    pub(super) fn longest(&self) -> usize {
        self.length(0)
    }

    /// The sites that are left over at the end, at least R of them.
    pub(super) fn left_over(&self) -> usize {
        self.sites - self.start(self.groups)
    }

    /// The sites of the reduced system: all separators, and those that are left over.
    pub(super) fn kept(&self) -> usize {
        self.parts() * self.reach + self.left_over()
    }

    /// The site at each place of the reduced system, as runs: first place, first site, how many.
    pub(super) fn kept_runs(&self) -> impl Iterator<Item = (usize, usize, usize)> {
        let partition = *self;
        let separators = (0..partition.parts()).map(move |part| {
            let group = part / partition.lanes;
            (
                part * partition.reach,
                partition.start(group) + part % partition.lanes * partition.length(group),
                partition.reach,
            )
        });
        separators.chain([(
            partition.parts() * partition.reach,
            partition.start(partition.groups),
            partition.left_over(),
        )])
    }
}
