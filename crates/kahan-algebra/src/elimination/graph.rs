//! The graph of dependences between variables of a block, and the fill-in of an elimination order.

/// The off-diagonal entries of f′ in a block, by rows. Variables are numbered within the block.
pub(super) struct Graph {
    rows: Vec<Vec<usize>>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct EliminationCost {
    products: usize,
    /// The number of dependences in the longest chain of pivots that each depend on the previous
    /// one.
    critical_path: usize,
}

pub(super) struct FilledPattern {
    pub(super) rows: Vec<FilledRow>,
    pub(super) price: EliminationCost,
}

pub(super) struct FilledRow {
    pub(super) columns: Vec<usize>,
    pub(super) diagonal: usize,
    looked_at: Option<usize>,
}

impl FilledRow {
    fn right(&self) -> usize {
        self.columns.len() - self.diagonal - 1
    }
}

impl Graph {
    /// Returns the graph of each block. The list `depends[i]` contains the variables in fᵢ.
    pub(super) fn of_blocks(depends: &[Vec<usize>], blocks: &[Vec<usize>]) -> Vec<Self> {
        let mut places = vec![(0, 0); depends.len()];
        for (number, block) in blocks.iter().enumerate() {
            block.iter().enumerate().for_each(|(place, &i)| places[i] = (number, place));
        }
        let inside = |number: usize, i: usize| {
            let others = depends[i].iter().filter(|&&j| j != i && places[j].0 == number);
            others.map(|&j| places[j].1).collect()
        };
        let graph = |(number, block): (usize, &Vec<usize>)| Graph {
            rows: block.iter().map(|&i| inside(number, i)).collect(),
        };
        blocks.iter().enumerate().map(graph).collect()
    }

    pub(super) fn len(&self) -> usize {
        self.rows.len()
    }

    /// Returns for each variable the variables that depend on it or on which it depends.
    pub(super) fn neighbours(&self) -> Vec<Vec<usize>> {
        let mut neighbours = vec![Vec::new(); self.len()];
        for (a, row) in self.rows.iter().enumerate() {
            for &b in row {
                neighbours[a].push(b);
                neighbours[b].push(a);
            }
        }
        for list in &mut neighbours {
            list.sort_unstable();
            list.dedup();
        }
        neighbours
    }

    /// Returns all entries, including fill-in, of an elimination in the given order. Returns `None`
    /// if elimination needs more multiplications than `bound`.
    ///
    /// A row inherits the columns right of the diagonal from the rows of its pivots. Let p < q, and
    /// let the entries (p, q) and (q, p) exist. Then row q inherits the columns of row p right of
    /// q. Rows below q get them from row q, and read row p only up to column q (S. C. Eisenstat and
    /// J. W. H. Liu, SIAM J. Matrix Anal. Appl. 13 (1992) 202–211). If the pattern is symmetric,
    /// the cost is proportional to the number of entries.
    pub(super) fn filled(&self, order: &[usize], bound: Option<EliminationCost>) -> Option<FilledPattern> {
        let most_products = bound.map_or(usize::MAX, |bound| bound.products);
        let turns = positions(order);
        let mut rows: Vec<FilledRow> = Vec::with_capacity(order.len());
        let mut seen_in = vec![usize::MAX; order.len()];
        let mut chains: Vec<usize> = Vec::with_capacity(order.len());
        let mut products = 0;
        for (k, &i) in order.iter().enumerate() {
            let mut columns = vec![k];
            columns.extend(self.rows[i].iter().map(|&j| turns[j]));
            columns.iter().for_each(|&j| seen_in[j] = k);
            let mut next = 0;
            while next < columns.len() {
                if let Some(FilledRow { columns: above, diagonal, looked_at }) =
                    rows.get(columns[next]).filter(|_| columns[next] < k)
                {
                    for &j in &above[diagonal + 1..looked_at.unwrap_or(above.len())] {
                        if seen_in[j] != k {
                            seen_in[j] = k;
                            columns.push(j);
                        }
                    }
                }
                next += 1;
            }
            columns.sort_unstable();
            let diagonal = columns.partition_point(|&j| j < k);
            let mut chain = 0;
            for &pivot in &columns[..diagonal] {
                let above = &mut rows[pivot];
                products += 1 + above.right();
                chain = chain.max(1 + chains[pivot]);
                if above.looked_at.is_none() {
                    above.looked_at = above.columns.binary_search(&k).ok().map(|place| place + 1);
                }
            }
            if products > most_products {
                return None;
            }
            chains.push(chain);
            rows.push(FilledRow { columns, diagonal, looked_at: None });
        }
        let critical_path = chains.into_iter().max().unwrap_or(0);
        Some(FilledPattern { rows, price: EliminationCost { products, critical_path } })
    }
}

pub(super) fn positions(order: &[usize]) -> Vec<usize> {
    let mut turns = vec![0; order.len()];
    order.iter().enumerate().for_each(|(turn, &i)| turns[i] = turn);
    turns
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elimination::tests::{permutation, random_rows};
    use crate::prime_field::SplitMix64;

    fn by_definition(graph: &Graph, order: &[usize]) -> Vec<Vec<usize>> {
        let (n, turns) = (order.len(), positions(order));
        let mut is_there = vec![vec![false; n]; n];
        for (k, &i) in order.iter().enumerate() {
            is_there[k][k] = true;
            graph.rows[i].iter().for_each(|&j| is_there[k][turns[j]] = true);
            for pivot in 0..k {
                if is_there[k][pivot] {
                    (pivot..n).for_each(|j| is_there[k][j] |= is_there[pivot][j]);
                }
            }
        }
        is_there.iter().map(|row| (0..n).filter(|&j| row[j]).collect()).collect()
    }

    #[test]
    fn rows_are_filled_as_elimination_fills_them() {
        let mut random = SplitMix64::new(7);
        for n in 1..40 {
            for mutual in [false, true] {
                let rows = random_rows(&mut random, n, mutual);
                let graph = Graph::of_blocks(&rows, &[(0..n).collect()]).remove(0);
                let order = permutation(&mut random, n);
                let filled = graph.filled(&order, None).unwrap();
                let expected = by_definition(&graph, &order);
                let found: Vec<_> = filled.rows.iter().map(|row| row.columns.clone()).collect();
                assert_eq!(found, expected, "{rows:?} in the order {order:?}");

                let left = |k: usize| expected[k].iter().copied().take_while(move |&j| j < k);
                let right = |k: usize| expected[k].iter().filter(|&&j| j > k).count();
                let products = (0..n).flat_map(left).map(|pivot| 1 + right(pivot)).sum();
                let mut chains: Vec<usize> = Vec::new();
                (0..n).for_each(|k| chains.push(left(k).map(|pivot| 1 + chains[pivot]).max().unwrap_or(0)));
                let critical_path = chains.into_iter().max().unwrap();
                assert_eq!(filled.price, EliminationCost { products, critical_path });

                assert!(graph.filled(&order, Some(filled.price)).is_some());
                let less =
                    products.checked_sub(1).map(|products| EliminationCost { products, critical_path });
                assert!(less.is_none_or(|less| graph.filled(&order, Some(less)).is_none()));
            }
        }
    }

    #[test]
    fn the_graph_of_a_block_has_its_couplings_alone() {
        let depends = [vec![0, 2, 3], vec![1], vec![0, 1], vec![1, 3]];
        let graphs = Graph::of_blocks(&depends, &[vec![1], vec![3], vec![0, 2]]);
        let rows: Vec<_> = graphs.iter().map(|graph| graph.rows.clone()).collect();
        assert_eq!(rows, [vec![vec![]], vec![vec![]], vec![vec![1], vec![0]]]);
        assert_eq!(graphs[2].neighbours(), [[1], [0]]);
    }
}
