//! An even function of one variable, sampled by the inverse of its cumulative table, in f64.

/// A tabulated even function f over ±its reach, straight between its nodes, of either sign.
#[derive(Clone, Debug)]
pub struct Table {
    /// Nodes from 0 to the reach, ascending; signs change only at nodes.
    nodes: Vec<Node>,
    /// ∫|f| / ∫f.
    weight: f64,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    x: f64,
    /// |f| here.
    height: f64,
    /// ∫|f| from 0 to here.
    mass: f64,
    /// Whether f is negative between here and the next node.
    negative: bool,
}

impl Table {
    /// Tabulates `f` from 0 on over pieces (from, to, cells) that follow one another; f may change
    /// its sign only where two of them meet.
    pub(super) fn new(pieces: &[(f64, f64, usize)], f: impl Fn(f64) -> f64) -> Self {
        let mut nodes: Vec<Node> = Vec::new();
        let (mut mass, mut signed) = (0.0, 0.0);
        for (from, to, cells) in pieces.iter().filter(|(from, to, _)| to > from) {
            let negative = f(0.5 * (from + to)) < 0.0;
            for i in 0..=*cells {
                let x = from + (to - from) * (i as f64 / *cells as f64);
                // At the end of a piece rounding may leave a remnant of the other sign.
                let height = if negative { -f(x) } else { f(x) }.max(0.0);
                if let Some(last) = nodes.last() {
                    let area = 0.5 * (x - last.x) * (height + last.height);
                    mass += area;
                    signed += if last.negative { -area } else { area };
                }
                nodes.push(Node { x, height, mass, negative });
            }
        }
        Self { nodes, weight: mass / signed }
    }

    /// The offset for `u` in [0, 1), growing with it, with density |f|; and its weight, ±∫|f|/∫f.
    pub(super) fn sample(&self, u: f64) -> (f64, f64) {
        let centred = 2.0 * u - 1.0;
        let last = self.nodes.len() - 1;
        let mass = centred.abs() * self.nodes[last].mass;
        let above = self.nodes.partition_point(|node| node.mass <= mass).clamp(1, last);
        let (a, b) = (self.nodes[above - 1], self.nodes[above]);
        // Within the cell f is straight: solve height·s + slope·s²/2 = rest, without cancellation.
        let rest = mass - a.mass;
        let slope = if b.x > a.x { (b.height - a.height) / (b.x - a.x) } else { 0.0 };
        let root = (a.height * a.height + 2.0 * slope * rest).max(0.0).sqrt();
        let step = if a.height + root > 0.0 { 2.0 * rest / (a.height + root) } else { 0.0 };
        let x = (a.x + step).clamp(a.x, b.x);
        (x.copysign(centred), if a.negative { -self.weight } else { self.weight })
    }
}
