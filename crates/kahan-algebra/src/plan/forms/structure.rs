//! The blocks for which A is block triangular, and independent states.

use kahan_syntax::table::{distinct, sorted_by_key};

use crate::field::Field;
use crate::kahan::{field_jacobian, pattern};
use crate::poly::Polynomial;

/// The pattern of nonzero entries in f′, and the components without denominator.
pub(in crate::plan) struct Structure {
    depends: Vec<Vec<bool>>,
    is_whole: Vec<bool>,
}

impl Structure {
    pub(in crate::plan) fn of(field: &Field) -> Self {
        let depends = pattern(&field_jacobian(field));
        let is_whole = field.denominators().map(Polynomial::is_one).collect();
        Structure { depends, is_whole }
    }

    pub(in crate::plan) fn depends(&self, i: usize, j: usize) -> bool {
        self.depends[i][j]
    }

    pub(in crate::plan) fn blocks(&self) -> Vec<Vec<usize>> {
        let row = |row: &Vec<bool>| (0..row.len()).filter(|&j| row[j]).collect();
        blocks(&self.depends.iter().map(row).collect::<Vec<_>>())
    }

    /// Returns states of a block that depend neither on each other nor on themselves. The entries
    /// of A in their rows and columns form an identity matrix.
    pub(in crate::plan) fn independent(&self, block: &[usize]) -> Vec<usize> {
        let ties = |i: usize| block.iter().filter(|&&j| self.depends(i, j) || self.depends(j, i)).count();
        let free = block.iter().copied().filter(|&i| !self.depends(i, i) && self.is_whole[i]);
        let order = sorted_by_key(free, |&i| (ties(i), i));
        let mut chosen: Vec<usize> = Vec::new();
        for i in order {
            if chosen.iter().all(|&j| !self.depends(i, j) && !self.depends(j, i)) {
                chosen.push(i);
            }
        }
        distinct(chosen)
    }
}

/// Returns the strongly connected components of the dependency graph, where `depends[i]` has the
/// states in fᵢ. Each component comes after those on which it depends, so A is block triangular.
/// Components that depend on fewer other states come first.
pub(crate) fn blocks(depends: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut blocks = components(depends);
    let mut block_of = vec![0; depends.len()];
    for (number, block) in blocks.iter().enumerate() {
        block.iter().for_each(|&i| block_of[i] = number);
    }
    // `weights` counts the states on which each block depends, 64 states in each pass.
    let mut weights = vec![0; blocks.len()];
    let groups = if blocks.len() > 1 { depends.len().div_ceil(64) } else { 0 };
    for group in 0..groups {
        let mut reached: Vec<u64> = Vec::with_capacity(blocks.len());
        for (number, block) in blocks.iter().enumerate() {
            let inside = block.iter().filter(|&&i| i / 64 == group);
            let own = inside.fold(0, |own, &i| own | 1 << (i % 64));
            let acting = block.iter().flat_map(|&i| &depends[i]).map(|&j| block_of[j]);
            let acting = acting.filter(|&other| other != number);
            let others = acting.fold(0, |others, other| others | reached[other]);
            weights[number] += others.count_ones();
            reached.push(own | others);
        }
    }
    blocks.iter_mut().for_each(|block| block.sort_unstable());
    let by_weight = sorted_by_key(blocks.into_iter().zip(weights), |(block, weight)| (*weight, block[0]));
    by_weight.into_iter().map(|(block, _)| block).collect()
}

/// Returns the strongly connected components of a graph (R. E. Tarjan, SIAM J. Comput. 1 (1972)
/// 146–160).
fn components(depends: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut components: Vec<Vec<usize>> = Vec::new();
    let mut numbers: Vec<Option<usize>> = vec![None; depends.len()];
    // For each vertex, the least vertex number known to be reachable from it (Tarjan's low-link).
    let mut lowest = vec![0; depends.len()];
    let mut is_open = vec![false; depends.len()];
    let (mut open, mut path, mut count) = (Vec::new(), Vec::new(), 0);
    for start in 0..depends.len() {
        if numbers[start].is_none() {
            path.push((start, 0));
        }
        while let Some((i, looked_at)) = path.pop() {
            let number = *numbers[i].get_or_insert(count);
            if number == count {
                count += 1;
                lowest[i] = number;
                is_open[i] = true;
                open.push(i);
            }
            if let Some(&j) = depends[i].get(looked_at) {
                path.push((i, looked_at + 1));
                match numbers[j] {
                    None => path.push((j, 0)),
                    Some(other) if is_open[j] => lowest[i] = lowest[i].min(other),
                    Some(_) => {}
                }
                continue;
            }
            if let Some(&(before, _)) = path.last() {
                lowest[before] = lowest[before].min(lowest[i]);
            }
            if lowest[i] == number {
                let first = open.iter().rposition(|&other| other == i).expect("it is open");
                let component = open.split_off(first);
                component.iter().for_each(|&other| is_open[other] = false);
                components.push(component);
            }
        }
    }
    components
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elimination::tests::random_rows;
    use crate::prime_field::SplitMix64;

    fn reaches(depends: &[Vec<usize>]) -> Vec<Vec<bool>> {
        let n = depends.len();
        let mut reaches: Vec<Vec<bool>> =
            depends.iter().map(|row| (0..n).map(|j| row.contains(&j)).collect()).collect();
        for via in 0..n {
            for i in 0..n {
                if reaches[i][via] {
                    (0..n).for_each(|j| reaches[i][j] |= reaches[via][j]);
                }
            }
        }
        reaches
    }

    #[test]
    fn states_that_reach_each_other_make_a_block_behind_what_they_reach() {
        let mut random = SplitMix64::new(5);
        for n in (1..30).chain([63, 64, 65, 130]) {
            for _ in 0..8 {
                let depends = random_rows(&mut random, n, false);
                let reaches = reaches(&depends);
                let mut expected: Vec<Vec<usize>> = Vec::new();
                for (i, reached) in reaches.iter().enumerate() {
                    match expected.iter_mut().find(|block| reached[block[0]] && reaches[block[0]][i]) {
                        Some(block) => block.push(i),
                        None => expected.push(vec![i]),
                    }
                }
                let others =
                    |block: &[usize]| (0..n).filter(|j| reaches[block[0]][*j] && !block.contains(j)).count();
                expected.sort_by_key(|block| (others(block), block[0]));
                assert_eq!(blocks(&depends), expected, "{depends:?}");
            }
        }
    }
}
