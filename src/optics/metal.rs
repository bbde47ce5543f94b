//! Metals: what they give back of white light at each angle, as three channels.
//!
//! The reflectance by Fresnel's formulas at every wavelength has a colour, at each angle another
//! one: [`colour::reflected`] of that spectrum. It is tabulated over the square root of the cosine,
//! which puts more angles where metals change, near the grazing ones, and is straight between.

use super::fresnel;
use super::{colour, tabulated};
use crate::math::Spectrum;
use crate::math::spectrum::union;

/// What the middles between angles may be off straight lines.
const CLOSE: f64 = 5e-5;

/// Steps of the coarsest table, and of the finest.
const STEPS: (usize, usize) = (32, 4096);

/// So many nanometres are between wavelengths at most.
const FINEST: f64 = 5.0;

/// The colour of a metal of index n + ik in white light: of the i-th of m, the cosine is
/// (i / (m - 1))². None if it is given for three channels.
pub fn by_angle(n: &Spectrum, k: &Spectrum) -> Option<Vec<[f64; 3]>> {
    if matches!((n, k), (Spectrum::Constant(_), Spectrum::Constant(_))) {
        return None;
    }
    let (n, k) = (tabulated(n)?, tabulated(k)?);
    let mut nm = union(&[&n, &k]);
    let between = (0..=80).map(|i| 380.0 + FINEST * f64::from(i));
    nm.extend(between);
    nm.sort_by(f64::total_cmp);
    nm.dedup();
    let weighed: Vec<_> = nm.iter().zip(colour::weights(&nm)).collect();
    let index: Vec<_> = nm.iter().map(|nm| (n.at(*nm), k.at(*nm))).collect();
    let colour = |root: f64| {
        let mut rgb = [0.0; 3];
        for ((n, k), (_, weight)) in index.iter().zip(&weighed) {
            let reflected = fresnel::conductor(*n, *k, root * root);
            rgb = std::array::from_fn(|i| rgb[i] + reflected * weight[i]);
        }
        rgb.map(|channel| channel.clamp(0.0, 1.0))
    };
    let mut steps = STEPS.0;
    let mut table: Vec<[f64; 3]> = (0..=steps).map(|i| colour(i as f64 / steps as f64)).collect();
    loop {
        let middle = |i: usize| colour((i as f64 + 0.5) / steps as f64);
        let middles: Vec<_> = (0..steps).map(middle).collect();
        let off = |i: usize, c: usize| 0.5 * (table[i][c] + table[i + 1][c]) - middles[i][c];
        let close = (0..steps).all(|i| (0..3).all(|c| off(i, c).abs() < CLOSE));
        if close || steps == STEPS.1 {
            return Some(table);
        }
        let pairs = table.iter().zip(&middles).flat_map(|(a, b)| [*a, *b]);
        let last = table[steps];
        table = pairs.chain([last]).collect();
        steps *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::{Figures, shelf};
    use crate::math::Table;

    fn metal(word: &str) -> (Spectrum, Spectrum) {
        let Figures::Metal(rows) = shelf("metal").unwrap().find(word).unwrap().figures else {
            panic!("{word}")
        };
        let column = |i: usize| {
            let nodes = rows().iter().map(|row| (row[0], row[i])).collect();
            Spectrum::Table(Table::new(nodes).unwrap())
        };
        (column(1), column(2))
    }

    fn interpolated(table: &[[f64; 3]], cos: f64) -> [f64; 3] {
        let place = cos.sqrt() * (table.len() - 1) as f64;
        let before = (place as usize).min(table.len() - 2);
        let t = place - before as f64;
        std::array::from_fn(|c| (1.0 - t) * table[before][c] + t * table[before + 1][c])
    }

    /// The colour by wavelengths every half nanometre.
    fn integrated(n: &Spectrum, k: &Spectrum, cos: f64) -> [f64; 3] {
        let at = |nm: f64| {
            let (n, k) = (super::super::at(n, nm), super::super::at(k, nm));
            (nm, fresnel::conductor(n, k, cos))
        };
        let nodes = (720..=1600).map(|i| at(f64::from(i) / 2.0)).collect();
        colour::reflected(&Spectrum::Table(Table::new(nodes).unwrap()))
    }

    #[test]
    fn tables_are_as_close_as_they_are_said_to_be() {
        for datum in shelf("metal").unwrap().data() {
            let (n, k) = metal(datum.word);
            let table = by_angle(&n, &k).unwrap();
            assert!(table.len() <= 513, "{}: {}", datum.word, table.len());
            for i in 0..=200 {
                let cos = (f64::from(i) / 200.0).powi(2);
                let (found, truth) = (interpolated(&table, cos), integrated(&n, &k, cos));
                for (a, b) in found.into_iter().zip(truth) {
                    assert!((a - b).abs() < 2e-4, "{} at {cos}: {a}, not {b}", datum.word);
                }
            }
        }
    }

    #[test]
    fn an_extreme_index_has_a_fine_table_and_channels_have_none() {
        let table = |rows: &[(f64, f64)]| Spectrum::Table(Table::new(rows.to_vec()).unwrap());
        let (n, k) =
            (table(&[(400.0, 100.0), (700.0, 1e-3)]), table(&[(400.0, 0.0), (700.0, 1e6)]));
        let found = by_angle(&n, &k).unwrap();
        assert!(found.len() > 33);
        assert!(found.iter().flatten().all(|part| (0.0..=1.0).contains(part)));
        let one = Spectrum::Constant(1.0);
        assert_eq!(by_angle(&one, &one), None);
        assert_eq!(by_angle(&Spectrum::Rgb([1.0; 3]), &one), None);
    }

    #[test]
    fn gold_is_golden_and_silver_is_nearly_white() {
        let straight = |word: &str| {
            let (n, k) = metal(word);
            *by_angle(&n, &k).unwrap().last().unwrap()
        };
        let [r, g, b] = straight("gold");
        assert!(r > 0.97 && (0.7..0.82).contains(&g) && (0.25..0.42).contains(&b), "{r} {g} {b}");
        assert!(straight("silver").into_iter().all(|part| (0.96..1.0).contains(&part)));
    }
}
