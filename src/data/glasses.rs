//! Glasses and clear crystals: coefficients of formulas for the index of refraction at about 20 °C,
//! wavelengths in micrometres.
//!
//! The catalogues give Sellmeier's formula today, and gave a series in powers of the wavelength
//! before; which it is, the coefficients say.

use super::shelves::{Datum, Figures, Glass};

const SCHOTT: &str = "Schott, Optical Glass, catalogue of 2017 [Schott17]";
const OLD: &str = "Schott's catalogue before 1992, in Tropf, Thomas and Harris, Handbook of Optics (1995) [Tropf95]";
const SILICA: &str = "Malitson, Journal of the Optical Society of America 55 (1965) [Malitson65]";
const SAPPHIRE: &str =
    "Malitson and Dodge, Journal of the Optical Society of America 62 (1972) [Malitson72]";
const DIAMOND: &str = "Peter, Zeitschrift für Physik 15 (1923) [Peter23]";

#[rustfmt::skip] // A table.
pub(super) static SHELF: &[Datum] = &[
    glass("basf10", "Dense barium flint BaSF10.", OLD, Glass::Series([2.653125, -0.0081388553, 0.022995643, 0.00073535957, -1.340739e-05, 3.6962325e-06])),
    glass("bk7", "Borosilicate crown N-BK7.", SCHOTT, Glass::Sellmeier(&[(1.03961212, 0.00600069867), (0.231792344, 0.0200179144), (1.01046945, 103.560653)])),
    glass("diamond", "Diamond.", DIAMOND, Glass::Sellmeier(&[(0.3306, 0.175 * 0.175), (4.3356, 0.106 * 0.106)])),
    glass("f2", "Flint F2.", SCHOTT, Glass::Sellmeier(&[(1.34533359, 0.00997743871), (0.209073176, 0.0470450767), (0.937357162, 111.886764)])),
    glass("fused_silica", "Fused silica, SiO2.", SILICA, Glass::Sellmeier(&[(0.6961663, 0.0684043 * 0.0684043), (0.4079426, 0.1162414 * 0.1162414), (0.8974794, 9.896161 * 9.896161)])),
    glass("k5", "Crown K5.", OLD, Glass::Series([2.2850299, -0.0086010725, 0.011806783, 0.00020765657, -2.1314913e-06, 3.2131234e-07])),
    glass("kf9", "Crown flint KF9.", OLD, Glass::Series([2.2824396, -0.0085960144, 0.013442645, 0.00027803535, -4.999896e-07, 7.7105911e-07])),
    glass("lf5", "Light flint LF5.", SCHOTT, Glass::Sellmeier(&[(1.28035628, 0.00929854416), (0.163505973, 0.0449135769), (0.893930112, 110.493685)])),
    glass("n_fk51a", "Fluor crown N-FK51A.", SCHOTT, Glass::Sellmeier(&[(0.971247817, 0.00472301995), (0.216901417, 0.0153575612), (0.904651666, 168.68133)])),
    glass("n_k5", "Crown N-K5, without lead.", SCHOTT, Glass::Sellmeier(&[(1.08511833, 0.00661099503), (0.199562005, 0.024110866), (0.930511663, 111.982777)])),
    glass("n_lasf9", "Lanthanum dense flint N-LASF9.", SCHOTT, Glass::Sellmeier(&[(2.00029547, 0.0121426017), (0.298926886, 0.0538736236), (1.80691843, 156.530829)])),
    glass("n_sf11", "Dense flint N-SF11, without lead.", SCHOTT, Glass::Sellmeier(&[(1.73759695, 0.013188707), (0.313747346, 0.0623068142), (1.89878101, 155.23629)])),
    glass("n_sf66", "Very dense flint N-SF66.", SCHOTT, Glass::Sellmeier(&[(2.0245976, 0.0147053225), (0.470187196, 0.0692998276), (2.59970433, 161.817601)])),
    glass("sapphire_e", "Sapphire, Al2O3, the extraordinary ray.", SAPPHIRE, Glass::Sellmeier(&[(1.5039759, 0.0740288 * 0.0740288), (0.55069141, 0.1216529 * 0.1216529), (6.5927379, 20.072248 * 20.072248)])),
    glass("sapphire_o", "Sapphire, Al2O3, the ordinary ray.", SAPPHIRE, Glass::Sellmeier(&[(1.4313493, 0.0726631 * 0.0726631), (0.65054713, 0.1193242 * 0.1193242), (5.3414021, 18.028251 * 18.028251)])),
    glass("sf10", "Dense flint SF10.", SCHOTT, Glass::Sellmeier(&[(1.61625977, 0.0127534559), (0.259229334, 0.0581983954), (1.07762317, 116.60768)])),
    glass("sf11", "Dense flint SF11.", SCHOTT, Glass::Sellmeier(&[(1.73848403, 0.0136068604), (0.311168974, 0.0615960463), (1.17490871, 121.922711)])),
    glass("sf6", "Dense flint SF6.", SCHOTT, Glass::Sellmeier(&[(1.72448482, 0.0134871947), (0.390104889, 0.0569318095), (1.04572858, 118.557185)])),
    glass("tik1", "Deep crown TiK1.", OLD, Glass::Series([2.1573978, -0.0084004189, 0.010457582, 0.00021822593, -5.506364e-06, 5.446906e-07])),
];

const fn glass(
    word: &'static str,
    doc: &'static str,
    source: &'static str,
    formula: Glass,
) -> Datum {
    Datum { word, doc, source, figures: Figures::Glass(formula) }
}
