//! From a colour to a spectrum that has it: smooth, and within the bounds of reflectances
//! [Jakob19].
//!
//! A colour has many spectra; this takes S(c₀ t² + c₁ t + c₂) with S(x) = ½ + x / (2 √(1 + x²)) and
//! t rising with the wavelength, which lies between 0 and 1 and has one bump or one dip. The three
//! coefficients are found by the method of Levenberg and Marquardt, on a path from grey to the
//! colour. The result is a table every 5 nm, and it is the table whose colour is matched.

use std::sync::OnceLock;

use glam::{DMat3, DVec3};

use super::{VISIBLE, colour};
use crate::math::Table;

/// Distance of the nodes of the tables, in nm.
const STEP: u32 = 5;

/// Parts of the path from grey to a colour, each solved from where the one before ended.
const PATH: u32 = 16;

/// Steps of each part at most. What has not arrived by then is as near as it will come.
const STEPS: u32 = 60;

/// Colours nearer than this, in each channel, are the same.
const CLOSE: f64 = 1e-10;

/// A reflectance (or anything else that has no light of its own) with this colour in white light.
/// Channels are not negative. Where none is above 1, no value is above 1 either; above, values
/// reach twice the greatest channel.
pub fn upsampled_reflectance(rgb: [f64; 3]) -> Table {
    let most = rgb.into_iter().fold(0.0, f64::max);
    if most <= 1.0 {
        return fitted(rgb);
    }
    fitted(rgb.map(|channel| channel / most * 0.5)).map(|value| doubled(value * most))
}

/// A light of this colour: D65, as if filtered.
pub fn upsampled_light(rgb: [f64; 3]) -> Table {
    let most = rgb.into_iter().fold(0.0, f64::max);
    if most == 0.0 {
        return grey(0.0);
    }
    // Half of what the filter may let through: it stays smooth.
    let filter = fitted(rgb.map(|channel| channel / most * 0.5));
    filter.with(colour::white(), |value, white| doubled(value * most * white))
}

/// Twice a value; no more than the largest number.
fn doubled(value: f64) -> f64 {
    (2.0 * value).min(f64::MAX)
}

fn grey(value: f64) -> Table {
    Table::new(vec![(560.0, value)]).expect("one node")
}

/// The spectrum between 0 and 1 for channels between 0 and 1.
fn fitted(rgb: [f64; 3]) -> Table {
    let target = DVec3::from_array(rgb);
    let luminance = colour::luminance(rgb).clamp(0.0, 1.0);
    if target.max_element() - target.min_element() < CLOSE {
        return grey(target.x);
    }
    // Where the middle of the path begins: a grey that is neither black nor white.
    let start = luminance.clamp(0.05, 0.95);
    let mut c = DVec3::new(0.0, 0.0, (start - 0.5) / (start * (1.0 - start)).sqrt());
    for part in 1..=PATH {
        let t = f64::from(part) / f64::from(PATH);
        c = solved(c, DVec3::splat(start).lerp(target, t));
    }
    table(c)
}

/// A node of the tables.
struct Node {
    nm: f64,
    /// t², t, 1.
    powers: DVec3,
    /// What a value of 1 there, and 0 at all others, adds to each channel.
    weight: DVec3,
}

fn nodes() -> &'static [Node] {
    static NODES: OnceLock<Vec<Node>> = OnceLock::new();
    NODES.get_or_init(|| {
        let (low, high) = (f64::from(VISIBLE.0), f64::from(VISIBLE.1));
        let nm: Vec<f64> =
            (0..=(VISIBLE.1 - VISIBLE.0) / STEP).map(|i| f64::from(VISIBLE.0 + i * STEP)).collect();
        let node = |at: f64| {
            let t = 2.0 * (at - low) / (high - low) - 1.0;
            let peak = nm.iter().map(|nm| (*nm, f64::from(u8::from(*nm == at)))).collect();
            let peak = Table::new(peak).expect("nm rise");
            let weight = DVec3::from_array(colour::raw_reflected(&peak));
            Node { nm: at, powers: DVec3::new(t * t, t, 1.0), weight }
        };
        nm.iter().copied().map(node).collect()
    })
}

fn table(c: DVec3) -> Table {
    let value = |node: &Node| (node.nm, sigmoid(c.dot(node.powers)));
    Table::new(nodes().iter().map(value).collect()).expect("nm rise")
}

fn sigmoid(x: f64) -> f64 {
    0.5 + 0.5 * (x / x.hypot(1.0))
}

/// The derivative of [`sigmoid`].
fn slope(x: f64) -> f64 {
    0.5 * x.hypot(1.0).powi(-3)
}

/// Coefficients whose colour is nearest to the target, from `c` on.
fn solved(mut c: DVec3, target: DVec3) -> DVec3 {
    let mut residual = colour_of(c) - target;
    let mut damping = 1e-3;
    for _ in 0..STEPS {
        if residual.abs().max_element() < CLOSE {
            break;
        }
        let jacobian = jacobian(c);
        let normal = jacobian.transpose() * jacobian;
        let diagonal = DVec3::new(normal.x_axis.x, normal.y_axis.y, normal.z_axis.z);
        let damped = normal + DMat3::from_diagonal(diagonal * damping + 1e-15);
        let next = c - damped.inverse() * (jacobian.transpose() * residual);
        let found = if next.is_finite() { colour_of(next) - target } else { DVec3::INFINITY };
        if found.length_squared() < residual.length_squared() {
            (c, residual) = (next, found);
            damping = (damping * 0.2).max(1e-12);
        } else {
            damping *= 8.0;
        }
    }
    c
}

fn colour_of(c: DVec3) -> DVec3 {
    nodes().iter().map(|node| node.weight * sigmoid(c.dot(node.powers))).sum()
}

/// How the colour changes with each coefficient, column by column.
fn jacobian(c: DVec3) -> DMat3 {
    let mut sum = DMat3::ZERO;
    for node in nodes() {
        let change = node.weight * slope(c.dot(node.powers));
        let [x, y, z] = node.powers.to_array();
        sum += DMat3::from_cols(change * x, change * y, change * z);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Spectrum;

    fn off(found: [f64; 3], wanted: [f64; 3]) -> f64 {
        (DVec3::from_array(found) - DVec3::from_array(wanted)).abs().max_element()
    }

    /// Colours on a grid of the whole cube, its corners included.
    fn cube() -> impl Iterator<Item = [f64; 3]> {
        let steps = [0.0, 0.02, 0.25, 0.5, 0.8, 0.98, 1.0];
        let pairs = move |r| steps.into_iter().flat_map(move |g| steps.map(|b| [r, g, b]));
        steps.into_iter().flat_map(pairs)
    }

    #[test]
    fn reflectances_are_bounded_and_have_the_colour_asked_for() {
        let mut worst: f64 = 0.0;
        for rgb in cube() {
            let table = upsampled_reflectance(rgb);
            let (low, high) = table.bounds();
            assert!(low >= 0.0 && high <= 1.0, "{rgb:?}: {low} to {high}");
            worst = worst.max(off(colour::raw_reflected(&table), rgb));
        }
        assert!(worst < 1e-9, "{worst}");
    }

    #[test]
    fn spectra_of_huge_and_tiny_colours_are_numbers() {
        for size in [5e-324, 1e-300, 1e300, 1e307, 1e308, f64::MAX] {
            for rgb in [[size; 3], [size, size * 0.5, 0.0]] {
                for table in [upsampled_reflectance(rgb), upsampled_light(rgb)] {
                    let (low, high) = table.bounds();
                    assert!(low >= 0.0 && high.is_finite(), "{rgb:?}: {low} to {high}");
                }
            }
        }
    }

    #[test]
    fn lights_have_the_colour_asked_for() {
        for rgb in [[36.8, 31.2, 16.0], [1.0, 0.2, 0.05], [0.1, 0.1, 3.0]] {
            let table = upsampled_light(rgb);
            assert!(table.bounds().0 >= 0.0);
            let found = colour::emitted(&Spectrum::Table(table));
            assert!(off(found, rgb) < 1e-3 * rgb[0].max(rgb[2]), "{found:?}, not {rgb:?}");
        }
        assert!(upsampled_light([0.0; 3]).bounds() == (0.0, 0.0));
    }
}
