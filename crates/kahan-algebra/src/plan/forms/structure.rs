//! The structure of a field that its step can use: which states move without others, and which do
//! not act on each other.

use kahan_syntax::table::{distinct, sorted_by_key};

use crate::field::Field;
use crate::kahan::{field_jacobian, pattern};

/// Which entries of f′ are not identically zero.
pub(in crate::plan) struct Structure {
    depends: Vec<Vec<bool>>,
    /// Whether the component is free of a denominator.
    is_whole: Vec<bool>,
}

impl Structure {
    pub(in crate::plan) fn of(field: &Field) -> Self {
        let depends = pattern(&field_jacobian(field));
        let is_whole = field.components.iter().map(|component| component.denominator.is_one()).collect();
        Structure { depends, is_whole }
    }

    /// Whether ∂fᵢ/∂xⱼ is not identically zero.
    pub(in crate::plan) fn depends(&self, i: usize, j: usize) -> bool {
        self.depends[i][j]
    }

    /// The blocks in whose order A is block triangular.
    pub(in crate::plan) fn blocks(&self) -> Vec<Vec<usize>> {
        blocks(&self.depends)
    }

    /// States of a block that do not act on each other or themselves: their rows and columns of A
    /// are those of the identity. Chosen greedily, those with the fewest ties first.
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

/// The strongly connected components of the graph in which i points to the states that fᵢ depends
/// on, each after those that it depends on: A is block triangular in this order.
pub(crate) fn blocks(depends: &[Vec<bool>]) -> Vec<Vec<usize>> {
    let reaches = reaches(depends);
    let mut blocks: Vec<Vec<usize>> = Vec::new();
    for (i, reached) in reaches.iter().enumerate() {
        match blocks.iter_mut().find(|block| reached[block[0]] && reaches[block[0]][i]) {
            Some(block) => block.push(i),
            None => blocks.push(vec![i]),
        }
    }
    // A block reaches all that the blocks it depends on reach, and those blocks besides.
    let weight = |block: &Vec<usize>| {
        let others = |&(j, reached): &(usize, &bool)| *reached && !block.contains(&j);
        reaches[block[0]].iter().enumerate().filter(others).count()
    };
    sorted_by_key(blocks, |block| (weight(block), block[0]))
}

/// Which states each state depends on, directly or through others.
fn reaches(depends: &[Vec<bool>]) -> Vec<Vec<bool>> {
    let mut reaches = depends.to_vec();
    for via in 0..reaches.len() {
        let through = reaches[via].clone();
        for row in reaches.iter_mut().filter(|row| row[via]) {
            for (entry, through) in row.iter_mut().zip(&through) {
                *entry |= through;
            }
        }
    }
    reaches
}
