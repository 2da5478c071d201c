//! The division of a chain into parts, which affects the bits of a step.
//!
//! A part is a separator of R sites followed by an interior, where R is the reach. Groups have one
//! part per lane of a 512-bit register, and all parts of a group have equal lengths. At least R
//! sites at the end belong to no part; the first R of them are the right separator of the last
//! part.

/// The intended length of a part, much longer than its separator and short enough for a cache.
const PART_LENGTH: usize = 256;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::lattice) struct Partition {
    sites: usize,
    reach: usize,
    lanes: usize,
    groups: usize,
    length: usize,
    /// The number of groups at the beginning whose parts have one site more than later parts.
    longer: usize,
}

impl Partition {
    pub(in crate::lattice) fn new(sites: usize, reach: usize, lanes: usize) -> Option<Self> {
        Self::with_length(sites, reach, lanes, PART_LENGTH, 4 * reach)
    }

    /// Divides a chain into parts of about `about` sites. Returns `None` if the parts would be
    /// shorter than `least` sites.
    pub(in crate::lattice) fn with_length(
        sites: usize,
        reach: usize,
        lanes: usize,
        about: usize,
        least: usize,
    ) -> Option<Self> {
        let least = least.max(3 * reach);
        let covered = sites.checked_sub(reach)?;
        let groups = (covered / (lanes * about)).max(1);
        let length = covered / (lanes * groups);
        let longer = covered / lanes - length * groups;
        (length >= least).then_some(Self { sites, reach, lanes, groups, length, longer })
    }

    pub(super) fn lanes(&self) -> usize {
        self.lanes
    }

    pub(super) fn groups(&self) -> usize {
        self.groups
    }

    pub(super) fn parts(&self) -> usize {
        self.groups * self.lanes
    }

    /// Returns the first site of a group. After the last group, this is the first remaining site.
    pub(super) fn start(&self, group: usize) -> usize {
        self.lanes * (group * self.length + group.min(self.longer))
    }

    /// Returns the number of sites of each part of a group, including its separator.
    pub(super) fn length(&self, group: usize) -> usize {
        self.length + usize::from(group < self.longer)
    }

    pub(super) fn longest(&self) -> usize {
        self.length(0)
    }

    pub(super) fn remaining_sites(&self) -> usize {
        self.sites - self.start(self.groups)
    }

    /// Returns the number of sites in all separators and at the end of the chain.
    pub(super) fn reduced_sites(&self) -> usize {
        self.parts() * self.reach + self.remaining_sites()
    }

    /// Iterates over the runs of consecutive sites in the reduced system. Yields the index of a
    /// run's first site in this system and in the chain, and the number of sites.
    pub(super) fn reduced_runs(&self) -> impl Iterator<Item = (usize, usize, usize)> {
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
            partition.remaining_sites(),
        )])
    }
}
