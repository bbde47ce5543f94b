//! A crowd of emitters, from which one is chosen by how much it may give to a site: a tree over
//! them, walked down by chance [ContyEstevez18].
//!
//! Each node bounds its emitters by a ball, by a cone about their normals, and by what they would
//! shine together; from these follows an importance for a site, zero only where none of them can
//! give any light. A child is chosen in proportion to it. So ten thousand emitters cost some
//! fourteen steps, and the nearest and brightest are chosen most often.

mod bounds;
mod split;

use glam::Vec3;

use super::Site;
pub(super) use bounds::Emitter;

/// Emitters, numbered from 0 as they were given.
#[derive(Clone, Debug)]
pub(super) struct Crowd {
    /// The root first; a parent before its children.
    nodes: Vec<Node>,
    /// By number of the emitter: its node.
    leaves: Vec<u32>,
    /// What bounds all of them.
    all: Emitter,
}

/// A part of the emitters. Bounds are rounded outwards.
#[derive(Clone, Copy, Debug)]
struct Node {
    centre: Vec3,
    radius: f32,
    axis: Vec3,
    /// Cosine and sine of the angle from the axis to the farthest normal.
    spread: [f32; 2],
    /// Cosine of the angle from a normal to the farthest direction in which it shines.
    reach: f32,
    /// Whether the emitters shine from their backs as well.
    both: bool,
    /// Greatest intensity of all together, towards any direction: light units times square world
    /// units.
    intensity: f64,
    parent: u32,
    next: Next,
}

/// What is below a node.
#[derive(Clone, Copy, Debug)]
enum Next {
    /// The number of an emitter.
    Leaf(u32),
    /// Two nodes: this one, and the one after it.
    Pair(u32),
}

/// An emitter that was chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Chosen {
    pub number: usize,
    /// With this probability.
    pub pmf: f64,
    /// What is left of the random number, again in [0, 1).
    pub u: f64,
}

/// Cosines are known to this much. What could be seen if they were off by it counts as seen: the
/// importance then is small, and not zero.
const SLACK: f64 = 1e-4;

impl Crowd {
    /// None: there are no emitters.
    pub fn new(emitters: &[Emitter]) -> Option<Self> {
        split::build(emitters)
    }

    /// What bounds all of them.
    pub fn emitter(&self) -> &Emitter {
        &self.all
    }

    /// About the irradiance that all of them may give to a site, in light units; 0 if they
    /// certainly give none.
    pub fn importance(&self, site: &Site) -> f64 {
        self.nodes[0].importance(site)
    }

    /// An emitter for a site, by `u` in [0, 1). None: nothing shines there, or not along the way
    /// that was taken.
    pub fn choose(&self, site: &Site, mut u: f64) -> Option<Chosen> {
        let mut at = 0;
        let mut pmf = 1.0;
        loop {
            let first = match self.nodes[at].next {
                Next::Leaf(number) => return Some(Chosen { number: number as usize, pmf, u }),
                Next::Pair(first) => first as usize,
            };
            let part = self.part(site, first)?;
            if u < part {
                (at, pmf, u) = (first, pmf * part, u / part);
            } else {
                (at, pmf, u) = (first + 1, pmf * (1.0 - part), (u - part) / (1.0 - part));
            }
            u = u.clamp(0.0, 1.0 - f64::EPSILON);
        }
    }

    /// The probability with which `choose` gives an emitter to a site.
    pub fn pmf(&self, site: &Site, number: usize) -> f64 {
        let mut at = self.leaves[number] as usize;
        let mut pmf = 1.0;
        while at != 0 {
            let parent = self.nodes[at].parent as usize;
            let Next::Pair(first) = self.nodes[parent].next else { return 0.0 };
            let Some(part) = self.part(site, first as usize) else { return 0.0 };
            pmf *= if at == first as usize { part } else { 1.0 - part };
            at = parent;
        }
        pmf
    }

    /// The probability of the first of two nodes; None if neither gives any light.
    fn part(&self, site: &Site, first: usize) -> Option<f64> {
        let (a, b) = (self.nodes[first].importance(site), self.nodes[first + 1].importance(site));
        (a + b > 0.0).then(|| a / (a + b))
    }
}

impl Node {
    /// Intensity over squared distance, times bounds of the cosines at both ends.
    fn importance(&self, site: &Site) -> f64 {
        let way = self.centre.as_dvec3() - site.point.position.as_dvec3();
        let radius_2 = f64::from(self.radius).powi(2);
        let distance_2 = way.length_squared();
        // From within the ball, or close to it, no distance tells how near the nearest is.
        let estimate = self.intensity / distance_2.max(radius_2).max(f64::from(f32::MIN_POSITIVE));
        if distance_2 <= radius_2 {
            return estimate;
        }
        let wi = way / distance_2.sqrt();
        let sin_2 = radius_2 / distance_2;
        let ball = Angle { cos: (1.0 - sin_2).max(0.0).sqrt(), sin: sin_2.sqrt() };

        let received = match site.normal {
            Vec3::ZERO => 1.0,
            normal => Angle::of_cos(normal.as_dvec3().dot(wi)).minus(ball).cos,
        };
        let cos = -self.axis.as_dvec3().dot(wi);
        let cos = if self.both { cos.abs() } else { cos };
        let [cos_spread, sin_spread] = self.spread.map(f64::from);
        let spread = Angle { cos: cos_spread, sin: sin_spread };
        let sent = Angle::of_cos(cos).minus(spread).minus(ball).cos;
        if received + SLACK <= 0.0 || sent + SLACK <= f64::from(self.reach) {
            return 0.0;
        }
        estimate * received.max(SLACK) * sent.max(SLACK)
    }
}

/// An angle between 0 and π.
#[derive(Clone, Copy, Debug)]
struct Angle {
    cos: f64,
    sin: f64,
}

impl Angle {
    fn of_cos(cos: f64) -> Self {
        let cos = cos.clamp(-1.0, 1.0);
        Self { cos, sin: (1.0 - cos * cos).sqrt() }
    }

    /// The difference, or zero if the other one is larger.
    fn minus(self, other: Self) -> Self {
        if self.cos >= other.cos {
            return Self { cos: 1.0, sin: 0.0 };
        }
        Self {
            cos: self.cos * other.cos + self.sin * other.sin,
            sin: self.sin * other.cos - self.cos * other.sin,
        }
    }
}
