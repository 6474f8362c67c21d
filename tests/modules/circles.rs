//! Circles of a graph.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// For each edge the shortest circle that it is part of, except those of two nodes whose only way
/// back is the edge back: those are listed once as pairs.
pub(crate) fn circles(edges: &BTreeSet<(usize, usize)>) -> BTreeSet<Vec<usize>> {
    let mut circles = BTreeSet::new();
    for (a, b) in edges {
        if edges.contains(&(*b, *a)) {
            circles.insert(vec![*a.min(b), *a.max(b)]);
        }
        if let Some(way) = way_back(*b, *a, edges) {
            circles.insert(from_the_least(way));
        }
    }
    circles
}

/// The nodes of the shortest way from `start` to `end`, not by the edge between them.
fn way_back(start: usize, end: usize, edges: &BTreeSet<(usize, usize)>) -> Option<Vec<usize>> {
    let mut before = BTreeMap::new();
    let mut open = VecDeque::from([start]);
    while let Some(node) = open.pop_front() {
        for (_, to) in edges.range((node, 0)..(node + 1, 0)) {
            if (node, *to) == (start, end) || *to == start || before.contains_key(to) {
                continue;
            }
            before.insert(*to, node);
            open.push_back(*to);
        }
    }
    before.get(&end)?;
    let mut way = vec![end];
    while way[0] != start {
        way.insert(0, before[&way[0]]);
    }
    Some(way)
}

/// The circle from its least node on, so that equal ones are equal.
fn from_the_least(mut circle: Vec<usize>) -> Vec<usize> {
    let least = (0..circle.len()).min_by_key(|i| circle[*i]).unwrap_or(0);
    circle.rotate_left(least);
    circle
}

#[test]
fn circles_are_found_and_chains_are_none() {
    let edges = BTreeSet::from([(0, 1), (1, 2), (2, 3), (3, 1), (3, 4), (4, 3), (0, 3)]);
    let expected = [vec![1, 2, 3], vec![3, 4]];
    assert_eq!(circles(&edges), BTreeSet::from(expected));
    assert!(circles(&BTreeSet::from([(0, 1), (1, 2), (0, 2)])).is_empty());
    // Two pairs that share a node, and an edge that makes three of them.
    let pairs = BTreeSet::from([(0, 1), (1, 0), (0, 2), (2, 0)]);
    assert_eq!(circles(&pairs), BTreeSet::from([vec![0, 1], vec![0, 2]]));
    let third = pairs.iter().copied().chain([(1, 2)]).collect();
    assert!(circles(&third).contains(&vec![0, 1, 2]));
}
