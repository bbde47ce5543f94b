//! Liquids, and powders dissolved in water: scattering, absorption and asymmetry in three bands,
//! measured by dilution [Narasimhan06].
//!
//! The paper's table, scaled from each dilution to full concentration, as two renderers have
//! transcribed it; neither is a copy of the paper itself. How far powders, lemonade and the sea
//! were diluted could not be confirmed. Where scattering is zero, and the asymmetry with it, it
//! was too weak to be measured. Coefficients in 1/mm; bands red, green, blue. The index is that of
//! water, 1.33.

use super::shelves::{Datum, Figures, Matter};

const SOURCE: &str =
    "Narasimhan, Gupta, Donner, Ramamoorthi, Nayar and Jensen, SIGGRAPH 2006 [Narasimhan06]";

#[rustfmt::skip] // A table.
pub(super) static SHELF: &[Datum] = &[
    liquid("apple_juice", "Apple juice.", [0.0025683, 0.0031051, 0.0041273], [0.012957, 0.023741, 0.052184], [0.947, 0.949, 0.945]),
    liquid("budweiser_beer", "Beer.", [0.00029345, 0.00054725, 0.00058689], [0.011492, 0.024911, 0.057786], [0.917, 0.956, 0.982]),
    liquid("cappuccino_powder", "Cappuccino powder, dissolved.", [12.209, 16.466, 29.273], [35.844, 49.547, 61.084], [0.849, 0.843, 0.926]),
    liquid("chardonnay", "White wine.", [0.00020909, 0.00032757, 0.00048092], [0.010782, 0.011855, 0.023997], [0.914, 0.958, 0.975]),
    liquid("clorox", "Bleach.", [0.027313, 0.033024, 0.036954], [0.0033542, 0.014892, 0.026297], [0.912, 0.905, 0.892]),
    liquid("coke", "Cola.", [0.0025444, 0.00299, 0.0], [0.10014, 0.16503, 0.2468], [0.965, 0.972, 0.0]),
    liquid("coors_light_beer", "Light beer.", [0.000621, 0.001265, 0.0], [0.006164, 0.013984, 0.034983], [0.918, 0.966, 0.0]),
    liquid("cranberry_juice", "Cranberry juice.", [0.0019626, 0.0023767, 0.0030053], [0.039437, 0.094223, 0.12426], [0.947, 0.951, 0.974]),
    liquid("espresso", "Espresso.", [7.7826, 8.1305, 8.5392], [4.7984, 6.5751, 8.8493], [0.907, 0.896, 0.88]),
    liquid("gatorade", "A drink for athletes.", [0.036678, 0.044881, 0.057423], [0.024794, 0.019289, 0.008878], [0.933, 0.933, 0.935]),
    liquid("grape_juice", "Grape juice.", [0.00138, 0.0, 0.0], [0.10404, 0.23958, 0.29325], [0.961, 0.0, 0.0]),
    liquid("head_and_shoulders_shampoo", "Another shampoo.", [0.26747, 0.27696, 0.29574], [0.084621, 0.15688, 0.20365], [0.911, 0.896, 0.884]),
    liquid("lemon_tea_powder", "Lemon tea powder, dissolved.", [0.74489, 0.83822, 1.0016], [2.4288, 4.5757, 7.2127], [0.946, 0.946, 0.949]),
    liquid("lowfat_chocolate_milk", "Low-fat chocolate milk.", [9.8371, 11.495, 13.163], [0.0115, 0.0368, 0.1564], [0.934, 0.927, 0.916]),
    liquid("lowfat_milk", "Low-fat milk.", [13.116, 15.445, 17.957], [0.002875, 0.00575, 0.0115], [0.932, 0.902, 0.859]),
    liquid("lowfat_soy_milk", "Low-fat soy milk.", [2.0384, 2.3288, 3.9028], [0.0014375, 0.0071875, 0.035937], [0.85, 0.853, 0.842]),
    liquid("merlot", "Red wine.", [0.00081265, 0.0, 0.0], [0.11632, 0.25191, 0.29434], [0.974, 0.0, 0.0]),
    liquid("mint_mocha_coffee", "Coffee with mint and chocolate.", [3.5113, 4.1439, 5.5966], [3.772, 5.8228, 7.82], [0.91, 0.907, 0.914]),
    liquid("orange_powder", "Orange powder, dissolved.", [0.001928, 0.002132, 0.002259], [0.001449, 0.003441, 0.007863], [0.919, 0.918, 0.922]),
    liquid("pacific_ocean_surface_water", "Surface water of the Pacific.", [0.0018, 0.001834, 0.002281], [0.031845, 0.031324, 0.030147], [0.902, 0.825, 0.914]),
    liquid("pepsi", "Another cola.", [0.00083374, 0.0020269, 0.0], [0.091641, 0.14158, 0.20729], [0.926, 0.979, 0.0]),
    liquid("pink_lemonade_powder", "Pink lemonade powder, dissolved.", [0.001235, 0.001334, 0.001305], [0.001165, 0.002366, 0.003195], [0.902, 0.902, 0.904]),
    liquid("reduced_milk", "Milk of reduced fat.", [13.734, 15.6, 17.801], [0.0025556, 0.0051111, 0.012778], [0.819, 0.797, 0.746]),
    liquid("regular_chocolate_milk", "Chocolate milk.", [10.569, 13.141, 15.22], [0.010063, 0.043125, 0.14375], [0.862, 0.838, 0.806]),
    liquid("regular_milk", "Regular milk.", [18.205, 20.383, 22.37], [0.0015333, 0.0046, 0.019933], [0.75, 0.714, 0.681]),
    liquid("regular_soy_milk", "Soy milk.", [4.6632, 5.2018, 8.7458], [0.0019167, 0.0095833, 0.065167], [0.873, 0.858, 0.832]),
    liquid("ruby_grapefruit_juice", "Ruby grapefruit juice.", [0.15496, 0.1539, 0.15994], [0.085867, 0.18314, 0.25262], [0.929, 0.929, 0.931]),
    liquid("salt_powder", "Salt, dissolved.", [0.13805, 0.15677, 0.17865], [0.28415, 0.3257, 0.34148], [0.802, 0.793, 0.821]),
    liquid("shampoo", "Shampoo.", [0.0079733, 0.00874, 0.01127], [0.014107, 0.045693, 0.061717], [0.91, 0.905, 0.92]),
    liquid("sprite", "Lemonade.", [0.0001058, 0.00013647, 0.00013647], [0.001886, 0.0018308, 0.0020025], [0.943, 0.953, 0.952]),
    liquid("strawberry_shampoo", "Strawberry shampoo.", [0.0021467, 0.0024534, 0.00253], [0.01449, 0.05796, 0.075823], [0.927, 0.935, 0.994]),
    liquid("sugar_powder", "Sugar, dissolved.", [0.0028192, 0.0031498, 0.0039275], [0.012638, 0.031051, 0.050124], [0.921, 0.919, 0.931]),
    liquid("suisse_mocha_powder", "Mocha powder, dissolved.", [30.085, 33.445, 38.719], [17.502, 27.004, 35.433], [0.907, 0.894, 0.888]),
    liquid("white_grapefruit_juice", "White grapefruit juice.", [0.505, 0.52743, 0.75283], [0.0138, 0.018831, 0.056781], [0.548, 0.545, 0.565]),
    liquid("white_zinfandel", "Rosé wine.", [0.00021606, 0.00033454, 0.00046], [0.012072, 0.016184, 0.019843], [0.919, 0.943, 0.972]),
];

const fn liquid(
    word: &'static str,
    doc: &'static str,
    scattering: [f64; 3],
    absorption: [f64; 3],
    asymmetry: [f64; 3],
) -> Datum {
    let figures = Matter { index: 1.33, scattering, absorption, asymmetry };
    Datum { word, doc, source: SOURCE, figures: Figures::Matter(figures) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Millilitres in a tank of 23 litres, where they could be confirmed.
    const DILUTIONS: &[(&str, f64)] = &[
        ("apple_juice", 1800.0),
        ("budweiser_beer", 2900.0),
        ("chardonnay", 3300.0),
        ("clorox", 1200.0),
        ("coke", 1600.0),
        ("coors_light_beer", 1000.0),
        ("cranberry_juice", 1500.0),
        ("espresso", 8.0),
        ("gatorade", 1500.0),
        ("grape_juice", 1200.0),
        ("head_and_shoulders_shampoo", 240.0),
        ("lowfat_chocolate_milk", 10.0),
        ("lowfat_milk", 16.0),
        ("lowfat_soy_milk", 16.0),
        ("merlot", 1500.0),
        ("mint_mocha_coffee", 6.0),
        ("pepsi", 1600.0),
        ("reduced_milk", 18.0),
        ("regular_chocolate_milk", 16.0),
        ("regular_milk", 15.0),
        ("regular_soy_milk", 12.0),
        ("ruby_grapefruit_juice", 240.0),
        ("shampoo", 300.0),
        ("strawberry_shampoo", 300.0),
        ("white_grapefruit_juice", 160.0),
        ("white_zinfandel", 3300.0),
    ];

    /// The paper states coefficients at the dilution, with six decimals.
    #[test]
    fn diluted_absorptions_have_six_decimals() {
        for (word, millilitres) in DILUTIONS {
            let datum = SHELF.iter().find(|datum| datum.word == *word).unwrap();
            let Figures::Matter(matter) = &datum.figures else { panic!("{word}") };
            for absorption in matter.absorption {
                let printed = absorption * millilitres / 23_000.0 / 1e-6;
                // The figures here have five digits.
                let slack = 0.02 + 1e-4 * printed;
                assert!((printed - printed.round()).abs() < slack, "{word}: {printed}");
            }
        }
    }

    #[test]
    fn every_liquid_is_whole() {
        assert_eq!(SHELF.len(), 35);
        for datum in SHELF {
            let Figures::Matter(matter) = &datum.figures else { panic!("{}", datum.word) };
            for band in 0..3 {
                assert!((0.0..40.0).contains(&matter.scattering[band]), "{}", datum.word);
                assert!((0.0..62.0).contains(&matter.absorption[band]), "{}", datum.word);
                assert!((0.0..1.0).contains(&matter.asymmetry[band]), "{}", datum.word);
                let scatters = matter.scattering[band] > 0.0;
                assert_eq!(scatters, matter.asymmetry[band] > 0.0, "{}", datum.word);
            }
        }
    }
}
