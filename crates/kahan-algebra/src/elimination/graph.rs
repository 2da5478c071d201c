//! Which variables act on each other, and what elimination in some order fills in.

use kahan_syntax::table::distinct;

/// The entries of f′ beside the diagonal that are not identically zero, by rows.
pub(super) struct Graph {
    rows: Vec<Vec<usize>>,
}

/// What elimination in an order takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Price {
    /// Products of two entries.
    products: usize,
    /// The pivots that wait for each other.
    critical_path: usize,
}

impl Graph {
    /// Of the matrix that says whether fᵢ depends on xⱼ.
    pub(super) fn of(depends: &[Vec<bool>]) -> Self {
        let row = |(i, row): (usize, &Vec<bool>)| (0..row.len()).filter(|&j| j != i && row[j]).collect();
        Graph { rows: depends.iter().enumerate().map(row).collect() }
    }

    /// The columns of a row's entries beside the diagonal.
    pub(super) fn row(&self, i: usize) -> &[usize] {
        &self.rows[i]
    }

    /// For each variable of a block, by its place in it, which others act on it or are acted on.
    pub(super) fn neighbours(&self, block: &[usize]) -> Vec<Vec<usize>> {
        let places = self.places(block);
        let mut neighbours = vec![Vec::new(); block.len()];
        for (a, &i) in block.iter().enumerate() {
            for b in self.rows[i].iter().filter_map(|&j| places[j]) {
                neighbours[a].push(b);
                neighbours[b].push(a);
            }
        }
        neighbours.into_iter().map(distinct).collect()
    }

    /// For each row of a block in this order the columns of its entries, filled ones and the
    /// diagonal included.
    pub(super) fn filled(&self, block: &[usize]) -> Vec<Vec<usize>> {
        let places = self.places(block);
        let mut rows: Vec<Vec<usize>> = Vec::with_capacity(block.len());
        for (k, &i) in block.iter().enumerate() {
            let mut is_there = vec![false; block.len()];
            is_there[k] = true;
            self.rows[i].iter().filter_map(|&j| places[j]).for_each(|j| is_there[j] = true);
            for pivot in 0..k {
                if is_there[pivot] {
                    right_of(&rows[pivot], pivot).for_each(|j| is_there[j] = true);
                }
            }
            rows.push((0..block.len()).filter(|&j| is_there[j]).collect());
        }
        rows
    }

    /// The price of eliminating a block in this order.
    pub(super) fn price(&self, block: &[usize]) -> Price {
        let filled = self.filled(block);
        let lengths: Vec<usize> =
            filled.iter().enumerate().map(|(k, row)| right_of(row, k).count()).collect();
        let mut chains: Vec<usize> = Vec::with_capacity(block.len());
        let mut products = 0;
        for (k, row) in filled.iter().enumerate() {
            let left = || row.iter().copied().take_while(|&j| j < k);
            products += left().map(|pivot| 1 + lengths[pivot]).sum::<usize>();
            chains.push(left().map(|pivot| 1 + chains[pivot]).max().unwrap_or(0));
        }
        Price { products, critical_path: chains.into_iter().max().unwrap_or(0) }
    }

    /// The place of each variable in a block.
    fn places(&self, block: &[usize]) -> Vec<Option<usize>> {
        let mut places = vec![None; self.rows.len()];
        block.iter().enumerate().for_each(|(place, &i)| places[i] = Some(place));
        places
    }
}

/// The columns right of the diagonal.
fn right_of(row: &[usize], diagonal: usize) -> impl Iterator<Item = usize> {
    row.iter().copied().filter(move |&j| j > diagonal)
}
