//! Wavefront materials as materials of the scene, as far as they can be rendered.
//!
//! Kd is the albedo, times the picture of map_Kd; Ke, and Ka where the scene says so, is what the surface emits. What asks for
//! more is rendered as diffuse, with a warning that says so.

use std::path::PathBuf;

use super::errors::mtl as errors;
use crate::diag::{Diagnostic, FileId, Span};
use crate::files::mtl::{self, Said};
use crate::math::Spectrum;
use crate::scene::{
    self, Angle, At, Diffuse, FileName, Image, KaMeans, Named, Pair, Radiance, Ref, Reflectance,
    Sides, Texture, TextureFilter, Textured, Wrap,
};

/// The source a material's places are in.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub library: FileId,
}

/// Whether it has a Ka whose meaning the scene must tell.
pub(super) fn shines_unclearly(said: &mtl::Material) -> bool {
    said.ambient.as_ref().is_some_and(|ka| ka.value != [0.0; 3])
}

/// The texture of a map_Kd: the picture times Kd, or as it is where there is no Kd.
pub(super) fn texture(
    name: String,
    said: &mtl::Material,
    map: &Said<mtl::Map>,
    at: Place,
    path: PathBuf,
) -> Named<Texture> {
    let span = at.span(map);
    let tint = said.diffuse.as_ref().map_or([1.0; 3], |kd| kd.value);
    let wrap = if map.value.clamp { Wrap::Clamp } else { Wrap::Repeat };
    let image = Image {
        file: At::new(FileName { text: map.value.file.clone(), path }, span),
        encoding: At::new(None, span),
        wrap: At::new(wrap, span),
        filter: At::new(TextureFilter::Linear, span),
        tint: At::new(Reflectance(Spectrum::Rgb(tint)), span),
        repeats: At::new(Pair([1.0; 2]), span),
        offset: At::new(Pair([0.0; 2]), span),
        turn: At::new(Angle(0.0), span),
    };
    Named { name: At::new(name, span), value: At::new(Texture::Image(image), span) }
}

/// As the scene would have declared it. `ambient` is given wherever Ka is not zero.
pub(super) fn scene_material(
    said: &mtl::Material,
    at: Place,
    ambient: Option<KaMeans>,
    texture: Option<At<Ref<Texture>>>,
) -> Named<scene::Material> {
    let whole = at.span(&said.name);
    let black = || At::new([0.0; 3], whole);
    let colour = |said: &Option<Said<[f64; 3]>>| {
        said.as_ref().map_or_else(black, |said| At::new(said.value, at.span(said)))
    };
    let albedo = colour(&said.diffuse);
    let mut emission = colour(&said.emissive);
    if ambient == Some(KaMeans::Emission) && shines_unclearly(said) {
        let ka = colour(&said.ambient);
        emission = if emission.value == [0.0; 3] {
            ka
        } else {
            emission.map(|ke| std::array::from_fn(|i| ke[i] + ka.value[i]))
        };
    }
    let diffuse = Diffuse {
        albedo: match texture {
            Some(texture) => texture.map(Textured::Texture),
            None => albedo.map(|rgb| Textured::Plain(Reflectance(Spectrum::Rgb(rgb)))),
        },
        emission: emission.map(|rgb| Radiance(Spectrum::Rgb(rgb))),
        emits: At::new(Sides::Front, whole),
    };
    Named {
        name: At::new(said.name.value.clone(), whole),
        value: At::new(scene::Material::Diffuse(diffuse), whole),
    }
}

/// Tells what of a material in use is not rendered, or hardly meant.
pub(super) fn warn(said: &mtl::Material, at: Place, field: Span, found: &mut Vec<Diagnostic>) {
    let name = &said.name.value;
    let left_out = left_out(said, at);
    if !left_out.is_empty() {
        found.push(errors::not_rendered(name, &left_out, field));
    }
    match &said.diffuse {
        Some(kd) if kd.value.iter().any(|part| *part > 1.0) => {
            found.push(errors::above_one(name, at.span(kd)));
        }
        None if said.emissive.is_none()
            && said.diffuse_map.is_none()
            && !shines_unclearly(said) =>
        {
            found.push(errors::no_colour(name, at.span(&said.name)));
        }
        _ => {}
    }
}

/// What is asked for and not rendered: in words, and where.
fn left_out(said: &mtl::Material, at: Place) -> Vec<(&'static str, Span)> {
    let mut left_out = Vec::new();
    let illum = said.illum.as_ref();
    let model = match illum.map(|illum| illum.value) {
        Some(2) | None => None,
        Some(0 | 1) => None,
        Some(3 | 8) => Some("a mirror"),
        Some(4 | 6 | 9) => Some("glass"),
        Some(5 | 7) => Some("reflection by Fresnel's formulas"),
        Some(10) => Some("a catcher of shadows"),
        Some(11) => Some("a metal"),
        Some(_) => Some("a translucent body"),
    };
    if let (Some(model), Some(illum)) = (model, illum) {
        left_out.push((model, at.span(illum)));
    }
    let highlights = !matches!(illum.map(|illum| illum.value), Some(0 | 1)) && model.is_none();
    if let Some(ks) = said.specular.as_ref().filter(|ks| highlights && ks.value != [0.0; 3]) {
        left_out.push(("highlights", at.span(ks)));
    }
    if let Some(d) = said.dissolve.as_ref().filter(|d| d.value < 1.0) {
        left_out.push(("transparency", at.span(d)));
    }
    if let Some(map) = said.diffuse_map.as_ref().filter(|map| map.value.options) {
        left_out.push(("the options of its texture", at.span(map)));
    }
    for other in &said.others {
        let words = match other.value.as_str() {
            "map_Ka" | "map_Ks" | "map_Ke" | "map_Ns" | "map_d" | "map_Pr" | "map_Pm"
            | "map_Ps" | "decal" => "a texture",
            "bump" | "map_bump" | "map_Bump" | "norm" | "disp" => "a bumpy surface",
            "refl" | "map_refl" => "a reflected picture",
            "Tf" => "coloured glass",
            "d -halo" => "transparency",
            _ => "physically based values",
        };
        left_out.push((words, at.span(other)));
    }
    left_out
}
