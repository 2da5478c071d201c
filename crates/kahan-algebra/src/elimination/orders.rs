//! Orders in which a block may be eliminated, and the choice among them by what they fill in.

use kahan_syntax::table::sorted_by_key;

use super::graph::Graph;

/// The cheapest of the orders below; of equals, that whose pivots wait least for each other.
pub(super) fn cheapest(graph: &Graph, block: &[usize]) -> Vec<usize> {
    let neighbours = graph.neighbours(block);
    let proposals =
        [as_written(block.len()), folded(block.len()), in_bands(&neighbours), by_degree(&neighbours)];
    let named = proposals.map(|order| order.into_iter().map(|place| block[place]).collect::<Vec<usize>>());
    named.into_iter().min_by_key(|order| graph.price(order)).expect("four orders are proposed")
}

/// Best where a variable acts on the next few only.
fn as_written(count: usize) -> Vec<usize> {
    (0..count).collect()
}

/// 0, n−1, 1, n−2, …: a cyclic band becomes an open one of twice the reach.
fn folded(count: usize) -> Vec<usize> {
    (0..count).map(|k| if k % 2 == 0 { k / 2 } else { count - 1 - k / 2 }).collect()
}

/// Variables that act on each other close together: layer after layer from one with few
/// neighbours, backwards (E. Cuthill and J. McKee, Proc. 24th Nat. Conf. ACM (1969) 157–172; A.
/// George, Stanford report STAN-CS-71-208).
fn in_bands(neighbours: &[Vec<usize>]) -> Vec<usize> {
    let degree = |&place: &usize| neighbours[place].len();
    let mut is_placed = vec![false; neighbours.len()];
    let mut order: Vec<usize> = Vec::with_capacity(neighbours.len());
    while let Some(start) = (0..neighbours.len()).filter(|&place| !is_placed[place]).min_by_key(degree) {
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

/// Always one with the fewest neighbours, which become neighbours of each other; of several, one
/// that waits for the fewest pivots before it (H. M. Markowitz, Management Sci. 3 (1957) 255–269).
fn by_degree(neighbours: &[Vec<usize>]) -> Vec<usize> {
    let mut around = neighbours.to_vec();
    let mut waits = vec![0_usize; around.len()];
    let mut left: Vec<usize> = (0..around.len()).collect();
    let mut order = Vec::with_capacity(around.len());
    while let Some(chosen) = left.iter().copied().min_by_key(|&place| (around[place].len(), waits[place])) {
        left.retain(|&place| place != chosen);
        let tied = std::mem::take(&mut around[chosen]);
        for &place in &tied {
            waits[place] = waits[place].max(waits[chosen] + 1);
            let others = tied.iter().chain(&around[place]).copied();
            let others = others.filter(|&other| other != place && other != chosen);
            around[place] = kahan_syntax::table::distinct(others);
        }
        order.push(chosen);
    }
    order
}
