//! The order of a Runge-Kutta method from its coefficients: one condition for each rooted tree.
//!
//! J. C. Butcher, *Coefficients for the study of Runge-Kutta integration processes*, J. Austral.
//! Math. Soc. 3 (1963); Hairer, Nørsett, Wanner I, theorem II.2.13.

/// A rooted tree: the trees at its root, by their places in the list of all trees, none before the
/// one before it.
struct Tree {
    branches: Vec<usize>,
    order: usize,
}

/// All trees up to an order, smaller ones first.
fn trees(order: usize) -> Vec<Tree> {
    let mut trees = Vec::new();
    for order in 1..=order {
        let mut next = Vec::new();
        grow(&trees, &mut Vec::new(), order - 1, &mut |branches| {
            next.push(Tree { branches, order });
        });
        trees.extend(next);
    }
    trees
}

/// Calls `found` with all ways of completing the branches by trees of so many nodes in total.
fn grow(
    trees: &[Tree],
    branches: &mut Vec<usize>,
    nodes: usize,
    found: &mut dyn FnMut(Vec<usize>),
) {
    if nodes == 0 {
        return found(branches.clone());
    }
    let first = branches.last().copied().unwrap_or(0);
    for next in first..trees.len() {
        if trees[next].order <= nodes {
            branches.push(next);
            grow(trees, branches, nodes - trees[next].order, found);
            branches.pop();
        }
    }
}

/// The largest error of the conditions `sum_i b_i w_i = 1 / gamma` of each order up to `order`,
/// where w are the elementary weights of a tree and gamma is its density.
fn defects(a: &[Vec<f64>], b: &[f64], order: usize) -> Vec<f64> {
    let mut known: Vec<(Vec<f64>, f64)> = Vec::new();
    let mut defects = vec![0.0_f64; order];
    for tree in trees(order) {
        let mut weights = vec![1.0; a.len()];
        let mut density = tree.order as f64;
        for branch in tree.branches {
            let (inner, inner_density) = &known[branch];
            density *= inner_density;
            for (weight, row) in weights.iter_mut().zip(a) {
                *weight *= row.iter().zip(inner).map(|(a, w)| a * w).sum::<f64>();
            }
        }
        let sum: f64 = weights.iter().zip(b).map(|(w, b)| w * b).sum();
        let defect = &mut defects[tree.order - 1];
        *defect = defect.max((sum - 1.0 / density).abs());
        known.push((weights, density));
    }
    defects
}

/// The order up to which all conditions hold except for rounding.
pub(super) fn order(a: &[Vec<f64>], b: &[f64]) -> usize {
    let defects = defects(a, b, 9);
    defects.iter().take_while(|defect| **defect < 1e-13).count()
}

/// The rows of an array of coefficients, each filled up with zeros to the number of stages.
pub(super) fn square(rows: &[impl AsRef<[f64]>], stages: usize) -> Vec<Vec<f64>> {
    let row = |row: &_| {
        let mut row = AsRef::<[f64]>::as_ref(row).to_vec();
        row.resize(stages, 0.0);
        row
    };
    rows[..stages].iter().map(row).collect()
}

#[test]
fn trees_are_counted() {
    let trees = trees(9);
    let count = |order| trees.iter().filter(|tree| tree.order == order).count();
    let counts: Vec<usize> = (1..=9).map(count).collect();
    assert_eq!(counts, [1, 1, 2, 4, 9, 20, 48, 115, 286]);
}

#[test]
fn the_classical_method_is_of_fourth_order() {
    let a = [[0.0; 3], [0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 1.0]];
    let b = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0];
    assert_eq!(order(&square(&a, 4), &b), 4);
}
