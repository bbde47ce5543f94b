//! Colour matching: from spectra to the three channels of a picture, linear sRGB.
//!
//! The eye is the standard observer of 1931 [CIE06], white is illuminant D65. All of them, and
//! the spectra they meet, are straight lines between their nodes; the integrals of their products
//! are exact (Simpson's rule between the nodes of all, whose products are cubic at most). The
//! tables end at 380 and 780 nm, and so does the eye here. The sums over 5 nm that CIE prescribes
//! for tables of 5 nm differ from this by less than 1e-4 in x and y for its illuminants.
//!
//! Three channels keep only the colour under one light. What they cannot show, because a channel
//! would be negative, is brought to the nearest they can: see [`reflected`] and [`emitted`].

use std::sync::OnceLock;

use glam::{DMat3, DVec3};

use super::tabulated;
use crate::data::cie;
use crate::math::spectrum::{Spectrum, Table, union};

/// Lumens of light of a watt, as scenes count watts: by what is seen of them.
pub const LUMENS_A_WATT: f64 = 683.0;

/// The observer and the white of a picture.
struct Eye {
    /// x̄, ȳ, z̄.
    observer: [Table; 3],
    /// Illuminant D65, of luminance 1.
    white: Table,
    /// ∫ ȳ dλ in nm.
    width: f64,
    /// From XYZ to linear sRGB; XYZ of `white` goes to one in each channel.
    to_rgb: DMat3,
}

fn eye() -> &'static Eye {
    static EYE: OnceLock<Eye> = OnceLock::new();
    EYE.get_or_init(|| {
        let column = |i: usize| cie::observer().iter().map(|row| (row[0], row[i])).collect();
        let observer = [1, 2, 3].map(|i| Table::new(column(i)).expect("wavelengths rise"));
        let width = integral(&[&observer[1]]);
        let power = cie::illuminant_d65().iter().map(|row| (row[0], row[1])).collect();
        let power = Table::new(power).expect("wavelengths rise");
        let luminance = integral(&[&power, &observer[1]]) / width;
        let white = power.map(|power| power / luminance);
        let white_xyz = std::array::from_fn(|i| integral(&[&white, &observer[i]]) / width);
        let to_rgb = from_primaries(cie::SRGB_PRIMARIES, DVec3::from_array(white_xyz));
        Eye { observer, white, width, to_rgb }
    })
}

/// The matrix from XYZ to the channels whose chromaticities these are, and whose sum is `white`.
fn from_primaries(primaries: [[f64; 2]; 3], white: DVec3) -> DMat3 {
    let columns = primaries.map(|[x, y]| DVec3::new(x / y, 1.0, (1.0 - x - y) / y));
    let to_xyz = DMat3::from_cols(columns[0], columns[1], columns[2]);
    let luminances = to_xyz.inverse() * white;
    (to_xyz * DMat3::from_diagonal(luminances)).inverse()
}

/// The integral over nm of the product of at most three tables, from 380 to 780 nm.
fn integral(tables: &[&Table]) -> f64 {
    debug_assert!(tables.len() <= 3, "Simpson's rule is exact for cubics");
    let observed = cie::observer();
    let (first, last) = (observed[0][0], observed[observed.len() - 1][0]);
    let mut nm = union(tables);
    nm.retain(|nm| (first..=last).contains(nm));
    nm.insert(0, first);
    nm.push(last);
    let at = |nm: f64| tables.iter().map(|table| table.at(nm)).product::<f64>();
    let part = |ends: &[f64]| {
        let (a, b) = (ends[0], ends[1]);
        (b - a) / 6.0 * (at(a) + 4.0 * at(0.5 * (a + b)) + at(b))
    };
    nm.windows(2).map(part).sum()
}

/// How wide the eye is: ∫ ȳ dλ in nm, 106.857. A light of the same power in each nanometre is as
/// bright as white of that power times this width.
pub fn eye_width() -> f64 {
    eye().width
}

/// A table whose greatest magnitude is near one, and the power of two that makes it the table it
/// was: products and sums of huge values stay numbers, and those of tiny ones do not vanish. What is
/// infinite counts as the largest number.
fn of_size_one(table: &Table) -> (Table, f64) {
    let most = table.nodes().iter().map(|(_, value)| value.abs()).fold(0.0, f64::max);
    if most == 0.0 {
        return (table.clone(), 1.0);
    }
    // So far only, that the power and one over it are normal numbers.
    let exponent = most.min(f64::MAX).log2().floor().clamp(-1000.0, 1000.0);
    let size = exponent.exp2();
    (table.map(|value| value.clamp(-f64::MAX, f64::MAX) / size), size)
}

/// CIE XYZ of a light; Y is the mean of its values, weighed by ȳ: its luminance, where a light of
/// 1 at every wavelength has 1.
pub fn xyz(light: &Table) -> [f64; 3] {
    let eye = eye();
    let (light, size) = of_size_one(light);
    std::array::from_fn(|i| integral(&[&light, &eye.observer[i]]) / eye.width * size)
}

/// Illuminant D65, of luminance 1: the light that is one in each channel.
pub fn white() -> &'static Table {
    &eye().white
}

/// Luminance of linear sRGB, as [`xyz`] has it.
pub fn luminance(rgb: [f64; 3]) -> f64 {
    (eye().to_rgb.inverse() * DVec3::from_array(rgb)).y
}

/// Linear sRGB of a surface of this reflectance (a coefficient, an index likewise) seen in white
/// light. A number is the same in each channel. No channel is below 0; where no value of a table
/// is above 1, no channel is either: colours that sRGB lacks are cut off there.
pub fn reflected(reflectance: &Spectrum) -> [f64; 3] {
    let table = match reflectance {
        Spectrum::Constant(value) => return [*value; 3],
        Spectrum::Rgb(components) => return *components,
        other => tabulated(other).expect("no colour"),
    };
    let most = table.bounds().1.max(1.0);
    raw_reflected(&table).map(|channel| channel.clamp(0.0, most))
}

/// By how much [`reflected`] moves the channel that it moves most; 0 for colours that sRGB has.
pub fn cut(reflectance: &Spectrum) -> f64 {
    let table = match reflectance {
        Spectrum::Constant(_) | Spectrum::Rgb(_) => return 0.0,
        other => tabulated(other).expect("no colour"),
    };
    let moved = reflected(reflectance).into_iter().zip(raw_reflected(&table));
    moved.map(|(shown, channel)| (shown - channel).abs()).fold(0.0, f64::max)
}

/// The same as [`reflected`], channels as they come: negative ones, and ones above all values,
/// included.
pub(super) fn raw_reflected(table: &Table) -> [f64; 3] {
    let eye = eye();
    let (table, size) = of_size_one(table);
    let xyz = std::array::from_fn(|i| integral(&[&table, &eye.white, &eye.observer[i]]));
    (eye.to_rgb * (DVec3::from_array(xyz) / eye.width)).to_array().map(|channel| channel * size)
}

/// What the values of a table of reflectances are worth at these wavelengths, at least one and
/// ascending: the sum of values times weights is the colour of the table as [`reflected`] has it
/// before channels are cut off.
pub fn weights(nm: &[f64]) -> Vec<[f64; 3]> {
    let eye = eye();
    let mut found = vec![DVec3::ZERO; nm.len()];
    let ends = Table::new(nm.iter().map(|nm| (*nm, 0.0)).collect()).expect("wavelengths rise");
    let observed = cie::observer();
    let (first, last) = (observed[0][0], observed[observed.len() - 1][0]);
    let mut all = union(&[&ends, &eye.white, &eye.observer[1]]);
    all.retain(|nm| (first..=last).contains(nm));
    all.insert(0, first);
    all.push(last);
    let seen = |nm: f64| {
        let xyz = DVec3::from_array(std::array::from_fn(|i| eye.observer[i].at(nm)));
        xyz * (eye.white.at(nm) / eye.width)
    };
    for ends in all.windows(2) {
        let (a, b) = (ends[0], ends[1]);
        let middle = 0.5 * (a + b);
        // Simpson's rule, whose factors are straight lines between a and b.
        for (at, part) in [(a, 1.0), (middle, 4.0), (b, 1.0)] {
            let after = nm.partition_point(|nm| *nm <= middle);
            let share = (b - a) / 6.0 * part * seen(at);
            match (after.checked_sub(1), nm.get(after)) {
                (Some(before), Some(end)) => {
                    let t = (at - nm[before]) / (end - nm[before]);
                    found[before] += (1.0 - t) * share;
                    found[after] += t * share;
                }
                (Some(before), None) => found[before] += share,
                (None, _) => found[0] += share,
            }
        }
    }
    found.into_iter().map(|xyz| (eye.to_rgb * xyz).to_array()).collect()
}

/// Linear sRGB of a light, in its own unit. A number is white. A light that is more saturated than
/// sRGB can show keeps its luminance: negative channels become zero, the others less.
pub fn emitted(light: &Spectrum) -> [f64; 3] {
    let table = match light {
        Spectrum::Constant(value) => return [*value; 3],
        Spectrum::Rgb(components) => return *components,
        other => tabulated(other).expect("no colour"),
    };
    let (table, size) = of_size_one(&table);
    within(DVec3::from_array(raw_emitted(&table))).map(|channel| channel * size)
}

/// Linear sRGB of a light of a luminance and of chromaticities x and y > 0, in the luminance's unit.
/// A light more saturated than sRGB keeps its luminance, as [`emitted`] has it.
pub fn of_chromaticity(luminance: f64, x: f64, y: f64) -> [f64; 3] {
    let xyz = DVec3::new(x / y, 1.0, (1.0 - x - y) / y) * luminance;
    within(eye().to_rgb * xyz)
}

/// Negative channels become zero, and the others less, so that the luminance stays.
fn within(rgb: DVec3) -> [f64; 3] {
    let rgb = rgb.to_array();
    if rgb.iter().all(|channel| *channel >= 0.0) {
        return rgb;
    }
    let cut = rgb.map(|channel| channel.max(0.0));
    let (before, after) = (luminance(rgb), luminance(cut));
    if before > 0.0 && after > 0.0 { cut.map(|channel| channel * before / after) } else { [0.0; 3] }
}

/// The same as [`emitted`], negative channels included.
pub(super) fn raw_emitted(table: &Table) -> [f64; 3] {
    (eye().to_rgb * DVec3::from_array(xyz(table))).to_array()
}

/// Linear sRGB of what a surface of this reflectance scatters of a light, by wavelengths, in the
/// light's unit: what the product of [`emitted`] and [`reflected`] comes near to. Saturated ones are
/// brought within sRGB as lights are. None for colours, which say nothing of wavelengths; a light of
/// one number is white.
pub fn lit(light: &Spectrum, reflectance: &Spectrum) -> Option<[f64; 3]> {
    let light = match light {
        Spectrum::Constant(value) => white().map(|power| power * value),
        other => tabulated(other)?,
    };
    let reflectance = tabulated(reflectance)?;
    let eye = eye();
    let ((light, power), (reflectance, size)) = (of_size_one(&light), of_size_one(&reflectance));
    let part = |i: usize| integral(&[&light, &reflectance, &eye.observer[i]]) / eye.width;
    let lit = within(eye.to_rgb * DVec3::from_array(std::array::from_fn(part)));
    Some(lit.map(|channel| channel * power * size))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::{Figures, shelf};
    use crate::math::Formula;

    fn near(found: &[f64], expected: &[f64], most: f64) {
        let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < most, "{found:?}, not {expected:?}");
    }

    fn chromaticity(light: &Table) -> [f64; 2] {
        let [x, y, z] = xyz(light);
        [x / (x + y + z), y / (x + y + z)]
    }

    fn light(word: &str) -> Table {
        let Figures::Light(rows) = shelf("illuminant").unwrap().find(word).unwrap().figures else {
            panic!("{word}")
        };
        Table::new(rows().iter().map(|row| (row[0], row[1])).collect()).unwrap()
    }

    /// A line so narrow that it has one wavelength.
    fn line(nm: f64) -> Table {
        Table::new(vec![(nm - 1e-3, 0.0), (nm, 1.0), (nm + 1e-3, 0.0)]).unwrap()
    }

    #[test]
    fn lights_have_the_chromaticities_they_are_known_for() {
        near(&chromaticity(&light("e")), &[0.333314, 0.333288], 1e-4);
        near(&chromaticity(&light("d65")), &[0.312721, 0.329031], 1e-4);
        near(&chromaticity(&light("a")), &[0.447575, 0.407446], 1e-4);
        let body = |kelvin| tabulated(&Spectrum::of(Formula::Blackbody(kelvin))).unwrap();
        near(&chromaticity(&body(6500.0)), &[0.313526, 0.323628], 1e-4);
        near(&chromaticity(&body(2856.0)), &[0.447535, 0.407428], 1e-4);
        for (nm, expected) in [
            (450.0, [0.15664, 0.01770]),
            (500.0, [0.00817, 0.53842]),
            (550.0, [0.30160, 0.69231]),
            (600.0, [0.62704, 0.37249]),
            (700.0, [0.73469, 0.26531]),
        ] {
            near(&chromaticity(&line(nm)), &expected, 1e-4);
        }
    }

    #[test]
    fn channels_are_those_of_srgb() {
        // [IEC99] has white at 0.3127, 0.3290, rounded from D65.
        let published = DMat3::from_cols_array(&[
            3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570,
        ])
        .transpose();
        let off = (eye().to_rgb - published).to_cols_array().map(f64::abs);
        assert!(off.iter().all(|off| *off < 1e-3), "{off:?}");
        near(
            &emitted(&Spectrum::Table(light("e").map(|x| x / 100.0))),
            &[1.2049, 0.9482, 0.9092],
            5e-4,
        );
        assert!((eye_width() - 106.8566).abs() < 1e-4, "{}", eye_width());
    }

    #[test]
    fn chromaticities_come_back_as_the_colour_they_were_of() {
        let d65 = light("d65").map(|power| power / 99.0);
        let [x, y] = chromaticity(&d65);
        let [_, luminance, _] = xyz(&d65);
        near(&of_chromaticity(luminance, x, y), &emitted(&Spectrum::Table(d65)), 1e-12);
        // Beyond sRGB: of its luminance all the same.
        let blue = of_chromaticity(5.0, 0.1, 0.1);
        assert!(blue[0] == 0.0 && (super::luminance(blue) - 5.0).abs() < 1e-12, "{blue:?}");
    }

    #[test]
    fn weighed_values_are_the_colour_of_their_table() {
        let tables: [&[(f64, f64)]; 4] = [
            &[(450.0, 0.3), (555.5, 0.9), (700.0, 0.1)],
            &[(300.0, 0.2), (381.0, 0.7), (500.0, 0.0), (501.0, 1.0), (900.0, 0.4)],
            &[(600.0, 0.5)],
            &[(800.0, 0.25), (900.0, 1.0)],
        ];
        for rows in tables {
            let nm: Vec<f64> = rows.iter().map(|row| row.0).collect();
            let mut sum = DVec3::ZERO;
            for (row, weight) in rows.iter().zip(weights(&nm)) {
                sum += row.1 * DVec3::from_array(weight);
            }
            let expected = raw_reflected(&Table::new(rows.to_vec()).unwrap());
            near(&sum.to_array(), &expected, 1e-12);
        }
    }

    #[test]
    fn white_is_one_and_grey_stays_grey() {
        near(&emitted(&Spectrum::Table(white().clone())), &[1.0; 3], 1e-12);
        let grey = Table::new(vec![(400.0, 0.3), (777.7, 0.3)]).unwrap();
        near(&reflected(&Spectrum::Table(grey)), &[0.3; 3], 1e-12);
        assert_eq!(reflected(&Spectrum::Constant(0.3)), [0.3; 3]);
        assert_eq!(emitted(&Spectrum::Rgb([1.0, 2.0, 3.0])), [1.0, 2.0, 3.0]);
    }

    #[test]
    fn the_cornell_box_has_its_colours() {
        let paint = |word: &str| {
            let datum = shelf("paint").unwrap().find(word).unwrap();
            let Figures::Reflectance(rows, column) = datum.figures else { panic!("{word}") };
            let nodes = rows().iter().map(|row| (row[0], row[column])).collect();
            reflected(&Spectrum::Table(Table::new(nodes).unwrap()))
        };
        near(&paint("cornell_white"), &[0.7386, 0.7363, 0.7388], 2e-3);
        near(&paint("cornell_green"), &[0.0686, 0.3986, 0.0865], 2e-3);
        near(&paint("cornell_red"), &[0.4933, 0.0489, 0.0512], 2e-3);
    }

    #[test]
    fn metals_have_their_colours() {
        let expected = [
            ("gold", [1.0376, 0.7284, 0.3645]),
            ("silver", [0.9894, 0.9840, 0.9776]),
            ("copper", [0.9318, 0.6227, 0.5222]),
            ("aluminium", [0.9074, 0.9159, 0.9221]),
        ];
        for (word, expected) in expected {
            let Figures::Metal(rows) = shelf("metal").unwrap().find(word).unwrap().figures else {
                panic!("{word}")
            };
            let column = |i: usize| Table::new(rows().iter().map(|r| (r[0], r[i])).collect());
            let (n, k) = (column(1).unwrap(), column(2).unwrap());
            let normal = |nm| {
                let (n, k) = (n.at(nm), k.at(nm));
                ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k)
            };
            let nodes = (380..=780).map(f64::from).map(|nm| (nm, normal(nm))).collect();
            let table = Table::new(nodes).unwrap();
            near(&raw_reflected(&table), &expected, 1e-3);
            // Gold is redder than sRGB; but it reflects no more than there is.
            assert!(reflected(&Spectrum::Table(table)).iter().all(|c| *c <= 1.0));
        }
    }

    #[test]
    fn colours_of_any_size_are_those_of_size_one() {
        let of = |size: f64| {
            let nodes = vec![(440.0, 0.2 * size), (520.0, size), (650.0, 0.1 * size)];
            Spectrum::Table(Table::new(nodes).unwrap())
        };
        let plain = [emitted(&of(1.0)), reflected(&of(1.0))];
        let both = lit(&of(1.0), &of(0.5)).unwrap();
        for exponent in [-300, -200, -20, 20, 200, 300, 306, 307] {
            let size = 10.0_f64.powi(exponent);
            let found = [emitted(&of(size)), reflected(&of(size))];
            for (found, plain) in found.into_iter().zip(plain) {
                near(&found.map(|channel| channel / size), &plain, 1e-12);
            }
            let found = lit(&of(size), &of(0.5)).unwrap();
            near(&found.map(|channel| channel / size), &both, 1e-12);
        }
        for size in [f64::MIN_POSITIVE, 5e-324, 1e308, f64::MAX, f64::INFINITY] {
            let all =
                [emitted(&of(size)), reflected(&of(size)), lit(&of(size), &of(size)).unwrap()];
            assert!(all.as_flattened().iter().all(|channel| *channel >= 0.0), "{size}: {all:?}");
            let most = all[0].into_iter().fold(0.0, f64::max);
            assert!(size < 1.0 || most > 1e307, "{size}: {all:?}");
        }
    }

    #[test]
    fn what_srgb_lacks_stays_within_it() {
        let laser = emitted(&Spectrum::Table(line(520.0)));
        let exact = xyz(&line(520.0))[1];
        assert!(laser.iter().all(|channel| *channel >= 0.0));
        assert!((luminance(laser) / exact - 1.0).abs() < 1e-9);
        assert_eq!(emitted(&Spectrum::Constant(0.0)), [0.0; 3]);
        let filter = Table::new(vec![(510.0, 0.02), (520.0, 0.9), (530.0, 0.02)]).unwrap();
        assert!(raw_reflected(&filter)[0] < 0.0);
        assert!(reflected(&Spectrum::Table(filter)).iter().all(|c| (0.0..=1.0).contains(c)));
    }
}
