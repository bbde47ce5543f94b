//! Translucent matter: reduced scattering and absorption in three bands [Jensen01].
//!
//! The paper's table, as two renderers that agree have transcribed it; of the two absorptions in
//! which they differ, those of chicken in red, the ones that give the paper's measured reflectance.
//! Scattering is reduced, σs (1 − g): to be used with an even phase function. Coefficients in
//! 1/mm; bands red, green, blue.

use super::shelves::{Datum, Figures, Matter};

const SOURCE: &str =
    "Jensen, Marschner, Levoy and Hanrahan, SIGGRAPH 2001; reduced scattering [Jensen01]";

pub(super) static SHELF: &[Datum] = &[
    matter("apple", "Flesh of an apple.", 1.3, [2.29, 2.39, 1.97], [0.003, 0.0034, 0.046]),
    matter("chicken1", "Meat of a chicken.", 1.3, [0.15, 0.21, 0.38], [0.015, 0.077, 0.19]),
    matter("chicken2", "Meat of another chicken.", 1.3, [0.19, 0.25, 0.32], [0.018, 0.088, 0.2]),
    matter("cream", "Cream.", 1.3, [7.38, 5.47, 3.15], [0.0002, 0.0028, 0.0163]),
    matter("ketchup", "Ketchup.", 1.3, [0.18, 0.07, 0.03], [0.061, 0.97, 1.45]),
    matter("marble", "White marble.", 1.5, [2.19, 2.62, 3.0], [0.0021, 0.0041, 0.0071]),
    matter("potato", "Potato.", 1.3, [0.68, 0.7, 0.55], [0.0024, 0.009, 0.12]),
    matter("skim_milk", "Skim milk.", 1.3, [0.7, 1.22, 1.9], [0.0014, 0.0025, 0.0142]),
    matter("skin1", "Skin.", 1.3, [0.74, 0.88, 1.01], [0.032, 0.17, 0.48]),
    matter("skin2", "Skin of another person.", 1.3, [1.09, 1.59, 1.79], [0.013, 0.07, 0.145]),
    matter("spectralon", "A white for calibration.", 1.3, [11.6, 20.4, 14.9], [0.0, 0.0, 0.0]),
    matter("whole_milk", "Whole milk.", 1.3, [2.55, 3.21, 3.77], [0.0011, 0.0024, 0.014]),
];

const fn matter(
    word: &'static str,
    doc: &'static str,
    index: f64,
    scattering: [f64; 3],
    absorption: [f64; 3],
) -> Datum {
    let figures = Matter { index, scattering, absorption, asymmetry: [0.0; 3] };
    Datum { word, doc, source: SOURCE, figures: Figures::Matter(figures) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Diffuse reflectance of a thick slab by the dipole, as the paper computes it [Jensen01].
    fn reflectance(matter: &Matter, band: usize) -> f64 {
        let n = matter.index;
        let inside = -1.440 / (n * n) + 0.710 / n + 0.668 + 0.0636 * n;
        let mismatch = (1.0 + inside) / (1.0 - inside);
        let (s, a) = (matter.scattering[band], matter.absorption[band]);
        let albedo = s / (s + a);
        let decay = (3.0 * (1.0 - albedo)).sqrt();
        0.5 * albedo * (1.0 + (-4.0 / 3.0 * mismatch * decay).exp()) * (-decay).exp()
    }

    #[test]
    fn thick_slabs_reflect_what_the_paper_measured() {
        let known = [
            ("marble", [0.830, 0.791, 0.753]),
            ("skim_milk", [0.815, 0.813, 0.682]),
            ("skin1", [0.436, 0.227, 0.131]),
            ("chicken1", [0.314, 0.156, 0.126]),
        ];
        for (word, expected) in known {
            let datum = SHELF.iter().find(|datum| datum.word == word).unwrap();
            let Figures::Matter(matter) = &datum.figures else { panic!("{word}") };
            for (band, expected) in expected.into_iter().enumerate() {
                let found = reflectance(matter, band);
                assert!((found - expected).abs() < 6e-4, "{word}: {found}, not {expected}");
            }
        }
        assert_eq!(SHELF.len(), 12);
    }
}
