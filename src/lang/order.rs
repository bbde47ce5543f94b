//! Who needs whom: circles, and an order in which everything comes after what it needs.

/// Circles in a graph: `wants[i]` are the nodes that node `i` needs. Each circle is told once, by
/// its nodes, each needing the next.
pub fn circles(wants: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut found: Vec<Vec<usize>> = Vec::new();
    let mut cut = vec![false; wants.len()];
    loop {
        let done = settled(wants, &cut);
        let Some(start) = done.iter().position(|done| !done) else { return found };
        // Everything that is left needs something that is left: a walk comes back to itself.
        let mut walk = vec![start];
        let circle = loop {
            let here = *walk.last().expect("not empty");
            let next = *wants[here].iter().find(|next| !done[**next]).expect("not settled");
            if let Some(begin) = walk.iter().position(|node| *node == next) {
                break walk.split_off(begin);
            }
            walk.push(next);
        };
        circle.iter().for_each(|node| cut[*node] = true);
        found.push(circle);
    }
}

/// Nodes that need, in the end, only settled ones; `cut` nodes count as settled.
fn settled(wants: &[Vec<usize>], cut: &[bool]) -> Vec<bool> {
    let mut done = vec![false; wants.len()];
    sorted(wants, cut).into_iter().for_each(|node| done[node] = true);
    done
}

/// The nodes that are in no circle and need none, each after those it needs; `cut` nodes need
/// nothing.
pub fn sorted(wants: &[Vec<usize>], cut: &[bool]) -> Vec<usize> {
    let mut wanted_by = vec![Vec::new(); wants.len()];
    let mut open: Vec<usize> = wants.iter().map(Vec::len).collect();
    for (node, needs) in wants.iter().enumerate() {
        if cut[node] {
            open[node] = 0;
            continue;
        }
        needs.iter().for_each(|need| wanted_by[*need].push(node));
    }
    let mut order: Vec<usize> = (0..wants.len()).filter(|node| open[*node] == 0).collect();
    let mut at = 0;
    while at < order.len() {
        for &node in &wanted_by[order[at]] {
            open[node] -= 1;
            if open[node] == 0 {
                order.push(node);
            }
        }
        at += 1;
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circles_are_found_each_once() {
        assert!(circles(&[vec![1], vec![2], vec![]]).is_empty());
        assert_eq!(circles(&[vec![0]]), [[0]]);
        assert_eq!(circles(&[vec![1], vec![0], vec![0]]), [[0, 1]]);
        assert_eq!(circles(&[vec![1], vec![0], vec![3], vec![2]]).len(), 2);
    }

    #[test]
    fn needs_come_first() {
        assert_eq!(sorted(&[vec![1, 2], vec![2], vec![]], &[false; 3]), [2, 1, 0]);
    }
}
