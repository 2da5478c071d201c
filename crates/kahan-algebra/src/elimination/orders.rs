//! Proposes elimination orders and chooses the cheapest.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use kahan_syntax::table::sorted_by_key;

use super::graph::{FilledPattern, Graph};

/// Returns the cheapest order and its fill-in. Among orders of equal cost, returns the one with the
/// shortest chain of pivots.
pub(super) fn cheapest(graph: &Graph) -> (Vec<usize>, FilledPattern) {
    let neighbours = graph.neighbours();
    let proposals = [
        natural_order(graph.len()),
        from_both_ends(graph.len()),
        reverse_cuthill_mckee(&neighbours),
        minimum_degree(&neighbours),
    ];
    let [.., of_degree] = &proposals;
    // The minimum degree order is nearly always cheap. Other orders are abandoned once they cost
    // more.
    let bound = graph.filled(of_degree, None).map(|filled| filled.price);
    let filled = |order: Vec<usize>| Some((graph.filled(&order, bound)?, order));
    let cheapest = proposals.into_iter().filter_map(filled).min_by_key(|(filled, _)| filled.price);
    let (filled, order) = cheapest.expect("four orders are proposed");
    (order, filled)
}

/// Returns the variables in the order of their equations, which suits band matrices.
fn natural_order(count: usize) -> Vec<usize> {
    (0..count).collect()
}

/// Returns the order 0, n−1, 1, n−2, …. A cyclic band matrix then becomes an open band matrix with
/// twice the bandwidth.
fn from_both_ends(count: usize) -> Vec<usize> {
    (0..count).map(|k| if k % 2 == 0 { k / 2 } else { count - 1 - k / 2 }).collect()
}

/// Returns the reverse Cuthill–McKee order, with variables in layers around a variable of low
/// degree (E. Cuthill and J. McKee, Proc. 24th Nat. Conf. ACM (1969) 157–172; A. George, Stanford
/// report STAN-CS-71-208).
fn reverse_cuthill_mckee(neighbours: &[Vec<usize>]) -> Vec<usize> {
    let degree = |&place: &usize| neighbours[place].len();
    let mut is_placed = vec![false; neighbours.len()];
    let mut order: Vec<usize> = Vec::with_capacity(neighbours.len());
    for start in sorted_by_key(0..neighbours.len(), degree) {
        if is_placed[start] {
            continue;
        }
        is_placed[start] = true;
        let mut next = order.len();
        order.push(start);
        while next < order.len() {
            let around = neighbours[order[next]].iter().copied().filter(|&place| !is_placed[place]);
            let layer = sorted_by_key(around, degree);
            layer.iter().for_each(|&place| is_placed[place] = true);
            order.extend(layer);
            next += 1;
        }
    }
    order.reverse();
    order
}

/// Returns the minimum degree order. The next variable is one with the fewest neighbours (H. M.
/// Markowitz, Management Sci. 3 (1957) 255–269). If several have equally few, the one with the
/// shortest chain of dependent pivots comes first.
fn minimum_degree(neighbours: &[Vec<usize>]) -> Vec<usize> {
    let mut around = neighbours.to_vec();
    let mut chain_lengths = vec![0_usize; around.len()];
    let mut is_left = vec![true; around.len()];
    let mut order = Vec::with_capacity(around.len());
    let all = (0..around.len()).map(|place| Reverse((around[place].len(), 0, place)));
    let mut queue: BinaryHeap<_> = all.collect();
    while let Some(Reverse((degree, turn, chosen))) = queue.pop() {
        if !is_left[chosen] || (degree, turn) != (around[chosen].len(), chain_lengths[chosen]) {
            continue;
        }
        is_left[chosen] = false;
        order.push(chosen);
        let tied = std::mem::take(&mut around[chosen]);
        for &place in &tied {
            chain_lengths[place] = chain_lengths[place].max(turn + 1);
        }
        if order.len() + tied.len() == around.len() {
            append_by_pivot_chain(tied, &mut chain_lengths, &mut order);
            return order;
        }
        for &place in &tied {
            around[place] = sorted_union(&around[place], &tied, |other| other != place && other != chosen);
            queue.push(Reverse((around[place].len(), chain_lengths[place], place)));
        }
    }
    order
}

fn append_by_pivot_chain(mut left: Vec<usize>, chain_lengths: &mut [usize], order: &mut Vec<usize>) {
    while let Some(chosen) = left.iter().copied().min_by_key(|&place| chain_lengths[place]) {
        left.retain(|&place| place != chosen);
        left.iter()
            .for_each(|&place| chain_lengths[place] = chain_lengths[place].max(chain_lengths[chosen] + 1));
        order.push(chosen);
    }
}

fn sorted_union(left: &[usize], right: &[usize], is_kept: impl Fn(usize) -> bool) -> Vec<usize> {
    let mut united = Vec::with_capacity(left.len() + right.len());
    let (mut a, mut b) = (0, 0);
    while a < left.len() || b < right.len() {
        let next = match (left.get(a), right.get(b)) {
            (Some(&own), Some(&other)) => own.min(other),
            (Some(&next), None) | (None, Some(&next)) => next,
            (None, None) => unreachable!("one list has a number left"),
        };
        a += usize::from(left.get(a) == Some(&next));
        b += usize::from(right.get(b) == Some(&next));
        if is_kept(next) {
            united.push(next);
        }
    }
    united
}

#[cfg(test)]
mod tests {
    use kahan_syntax::table::distinct;

    use super::*;
    use crate::elimination::tests::random_rows;
    use crate::prime_field::SplitMix64;

    fn by_definition(neighbours: &[Vec<usize>]) -> Vec<usize> {
        let mut around = neighbours.to_vec();
        let mut chain_lengths = vec![0_usize; around.len()];
        let mut left: Vec<usize> = (0..around.len()).collect();
        let mut order = Vec::new();
        while let Some(chosen) =
            left.iter().copied().min_by_key(|&place| (around[place].len(), chain_lengths[place]))
        {
            left.retain(|&place| place != chosen);
            let tied = std::mem::take(&mut around[chosen]);
            for &place in &tied {
                chain_lengths[place] = chain_lengths[place].max(chain_lengths[chosen] + 1);
                let others = tied.iter().chain(&around[place]).copied();
                around[place] = distinct(others.filter(|&other| other != place && other != chosen));
            }
            order.push(chosen);
        }
        order
    }

    #[test]
    fn the_order_by_degree_always_takes_one_with_the_fewest_neighbours() {
        let mut random = SplitMix64::new(11);
        for n in 1..60 {
            let rows = random_rows(&mut random, n, false);
            let neighbours = Graph::of_blocks(&rows, &[(0..n).collect()])[0].neighbours();
            assert_eq!(minimum_degree(&neighbours), by_definition(&neighbours), "{neighbours:?}");
        }
    }

    #[test]
    fn the_first_of_the_cheapest_orders_is_chosen() {
        let mut random = SplitMix64::new(13);
        for n in 1..40 {
            let rows = random_rows(&mut random, n, n % 2 == 0);
            let graph = Graph::of_blocks(&rows, &[(0..n).collect()]).remove(0);
            let neighbours = graph.neighbours();
            let orders = [
                natural_order(n),
                from_both_ends(n),
                reverse_cuthill_mckee(&neighbours),
                minimum_degree(&neighbours),
            ];
            let first = orders.into_iter().min_by_key(|order| graph.filled(order, None).unwrap().price);
            assert_eq!(Some(cheapest(&graph).0), first, "{rows:?}");
        }
    }
}
