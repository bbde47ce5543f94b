//! RGB for spectra: what three channels make of the light of a spectrum on a surface of another,
//! against the colour of the product.
//!
//! The product of the channels is exact where the surface is grey, and where the light is white and
//! sRGB has the surface's colour. A colour says nothing of wavelengths, so that no product with one
//! is wrong. Told is the light that meets one surface, which is all that `direct` follows; after
//! several surfaces the error is another, and will be asked with what follows light there.

use super::bias::{Bias, Kind};
use super::survey::Survey;
use crate::diag::Span;
use crate::math::Spectrum;
use crate::optics::colour;
use crate::scene::{Material, Named, Object, Textured};

/// A part below which errors are not told: so much lies between the ways to integrate spectra.
const NEGLIGIBLE: f64 = 1e-4;

/// So many pairs of a light and a material are looked at, the first ones of the scene.
const MOST_PAIRS: usize = 4096;

/// One for each light whose spectrum comes out wrong on a surface that it may meet; told is the
/// surface on which it is most wrong.
pub(super) fn biases(survey: &Survey) -> Vec<Bias> {
    let mut pairs_left = MOST_PAIRS;
    let surfaces = scattering(survey);
    let mut found = Vec::new();
    for light in shining(survey) {
        let meets = surfaces.iter().filter(|surface| meet(survey, &light, surface));
        let mut wrong: Vec<(Error, &Side)> = meets
            .take(pairs_left)
            .inspect(|_| pairs_left -= 1)
            .filter_map(|surface| Some((error(light.spectrum, surface.spectrum)?, surface)))
            .collect();
        wrong.sort_by(|(a, _), (b, _)| b.luminance.abs().total_cmp(&a.luminance.abs()));
        if let Some(((error, surface), others)) = wrong.split_first() {
            found.push(bias(&light, surface, error, others));
        }
    }
    found
}

/// A light, or the surfaces of one material.
struct Side<'a> {
    /// As it is told: `light sun`; a material by its name alone.
    name: String,
    spectrum: &'a Spectrum,
    at: Span,
    /// The first object that has it; None of what is no surface.
    object: Option<&'a Named<Object>>,
    /// Whether others have it as well.
    several: bool,
}

/// Whether light of one may fall on the other.
fn meet(survey: &Survey, light: &Side, surface: &Side) -> bool {
    let (Some(lamp), Some(object)) = (light.object, surface.object) else { return true };
    light.several || surface.several || !std::ptr::eq(lamp, object) || survey.lights_itself(object)
}

/// What `direct` follows light from, if its spectrum is known: a plain number is white.
fn shining<'a>(survey: &Survey<'a>) -> Vec<Side<'a>> {
    let mut found = Vec::new();
    for light in &survey.sharp {
        let Some(shine) = light.value.shine() else { continue };
        found.push(Side {
            name: format!("`light {}`", *light.name),
            spectrum: shine.spectrum,
            at: shine.at,
            object: None,
            several: false,
        });
    }
    found.extend(materials(survey, |material| {
        let emission = material.emission()?;
        Some((&emission.value.0, emission.span))
    }));
    found.retain(|side| !side.spectrum.is_zero() && !matches!(side.spectrum, Spectrum::Rgb(_)));
    found
}

/// Surfaces on which some light may come out wrong: those of a spectrum that is no plain number.
fn scattering<'a>(survey: &Survey<'a>) -> Vec<Side<'a>> {
    let varies = |of: &Spectrum| matches!(of, Spectrum::Table(_) | Spectrum::Formula { .. });
    let mut found = materials(survey, |material| {
        let colours = match &material.reflectance()?.value {
            Textured::Plain(plain) => vec![(plain, material.reflectance()?.span)],
            Textured::Texture(name) => {
                let texture = &survey.stage.texture(name).texture.value;
                texture.colours().into_iter().map(|colour| (&colour.value, colour.span)).collect()
            }
        };
        // Of a texture, the first of its colours.
        colours.into_iter().map(|(colour, at)| (&colour.0, at)).find(|(colour, _)| varies(colour))
    });
    found.retain(|side| !side.spectrum.is_zero());
    found
}

/// The materials in use, each once, with a spectrum of theirs.
fn materials<'a>(
    survey: &Survey<'a>,
    spectrum: impl Fn(&'a Material) -> Option<(&'a Spectrum, Span)>,
) -> Vec<Side<'a>> {
    let mut found: Vec<Side> = Vec::new();
    let mut known = std::collections::HashMap::new();
    for surface in &survey.surfaces {
        let material = surface.material;
        let Some((spectrum, at)) = spectrum(&material.value.value) else { continue };
        // Another file of materials may use the name again.
        let index =
            *known.entry((&*material.name.value, material.value.span)).or_insert_with(|| {
                let name = format!("`{}`", *material.name);
                found.push(Side {
                    name,
                    spectrum,
                    at,
                    object: Some(surface.object),
                    several: false,
                });
                found.len() - 1
            });
        let side = &mut found[index];
        side.several |= side.object.is_some_and(|first| !std::ptr::eq(first, surface.object));
    }
    found
}

/// How far the product of channels is from the colour of the product.
#[derive(Debug)]
struct Error {
    /// Of the luminance, as a part of the true one; infinite where there is no light in truth.
    luminance: f64,
    /// Of the channel that is most wrong, as a part of the largest true one.
    channel: (&'static str, f64),
}

impl Error {
    fn size(&self) -> f64 {
        self.luminance.abs().max(self.channel.1.abs())
    }
}

/// None if there is none, or none can be known.
fn error(light: &Spectrum, albedo: &Spectrum) -> Option<Error> {
    let truth = colour::lit(light, albedo)?;
    let (emitted, reflected) = (colour::emitted(light), colour::reflected(albedo));
    let product: [f64; 3] = std::array::from_fn(|i| emitted[i] * reflected[i]);
    let part = |off: f64, of: f64| if off == 0.0 { 0.0 } else { off / of };
    let (shown, true_one) = (colour::luminance(product), colour::luminance(truth));
    let largest = truth.into_iter().fold(0.0, f64::max);
    let channels = ["red", "green", "blue"].into_iter().zip(product).zip(truth);
    let channels = channels.map(|((name, shown), truth)| (name, part(shown - truth, largest)));
    let error = Error {
        luminance: part(shown - true_one, true_one),
        channel: channels.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?,
    };
    (error.size() > NEGLIGIBLE).then_some(error)
}

fn bias(light: &Side, surface: &Side, error: &Error, others: &[(Error, &Side)]) -> Bias {
    let way = |part: f64, more, less| if part > 0.0 { more } else { less };
    let brief = if error.luminance.is_finite() {
        let (luminance, (channel, part)) = (error.luminance, error.channel);
        format!(
            "{} too {} where they meet, {channel} by {} too {}",
            percent(luminance),
            way(luminance, "bright", "dark"),
            percent(part),
            way(part, "much", "little"),
        )
    } else {
        "bright where they meet, and should be black".to_string()
    };
    let brief = brief + &beside(others);
    // A light of one number is white, and only the surface's colour can be one that sRGB lacks.
    let white = matches!(light.spectrum, Spectrum::Constant(_));
    Bias {
        kind: Kind::RgbForSpectra,
        setting: format!("RGB for the spectra of {} and {}", light.name, surface.name),
        at: if white { surface.at } else { light.at },
        effect: format!("three products are not the colour of a product: {brief}"),
        brief,
        bound: None,
        instead_write: "rendering by wavelengths is yet to come. A light of a plain number, or \
                        `illuminant.d65` times one, is exact on colours that sRGB has; \
                        `rgb(…)` for one of the two says that three channels are meant",
        instead: None,
    }
}

/// What is told of other materials in the same light.
fn beside(others: &[(Error, &Side)]) -> String {
    let most = |part: fn(&Error) -> f64| {
        percent(others.iter().map(|(error, _)| part(error).abs()).fold(0.0, f64::max))
    };
    let (luminance, channel) = (most(|error| error.luminance), most(|error| error.channel.1));
    match others {
        [] => String::new(),
        [(one, _)] if one.luminance.is_finite() => {
            format!("; on one more material off by {luminance}, a channel by {channel}")
        }
        [(first, _), ..] if first.luminance.is_finite() => format!(
            "; on {} more materials off by {luminance} at most, a channel by {channel} at most",
            others.len()
        ),
        all => format!("; wrong on other materials too ({})", all.len()),
    }
}

/// To three digits.
fn percent(part: f64) -> String {
    let percent = 100.0 * part.abs();
    let digits = (2.0 - percent.max(1e-3).log10().floor()).clamp(0.0, 4.0) as usize;
    format!("{percent:.digits$} %")
}
