//! Wavefront materials as materials of the scene, as far as they can be rendered.
//!
//! Its model of illumination says what it is (illum.rs); Ke, and Ka where the scene says so, is what
//! an opaque surface emits, map_Kd the texture of a diffuse one. What asks for more is rendered without it, with a warning that says so.

use std::path::PathBuf;

use super::errors::mtl as errors;
use super::illum::{Context, Model};
use crate::diag::{Diagnostic, FileId, Span};
use crate::files::mtl::{self, Said};
use crate::math::Spectrum;
use crate::scene::{
    self, Angle, At, FileName, Image, KaMeans, Named, Pair, Radiance, Ref, Reflectance, Texture,
    TextureFilter, Wrap,
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
    ambient: Option<KaMeans>,
    texture: Option<At<Ref<Texture>>>,
    context: &mut Context,
) -> Result<Named<scene::Material>, Box<Diagnostic>> {
    let at = context.at;
    let whole = at.span(&said.name);
    let black = || At::new([0.0; 3], whole);
    let colour = |said: &Option<Said<[f64; 3]>>| {
        said.as_ref().map_or_else(black, |said| At::new(said.value, at.span(said)))
    };
    let mut emission = colour(&said.emissive);
    if ambient == Some(KaMeans::Emission) && shines_unclearly(said) {
        let ka = colour(&said.ambient);
        emission = if emission.value == [0.0; 3] {
            ka
        } else {
            emission.map(|ke| std::array::from_fn(|i| ke[i] + ka.value[i]))
        };
    }
    let emission = emission.map(|rgb| Radiance(Spectrum::Rgb(rgb)));
    Ok(Named {
        name: At::new(said.name.value.clone(), whole),
        value: At::new(context.material(said, emission, texture)?, whole),
    })
}

/// Tells what of a material in use is not rendered, or hardly meant.
pub(super) fn warn(said: &mtl::Material, at: Place, field: Span, found: &mut Vec<Diagnostic>) {
    let name = &said.name.value;
    let model = Model::of(said);
    let left_out = left_out(said, at, model);
    if !left_out.is_empty() {
        found.push(errors::not_rendered(name, model == Model::Diffuse, &left_out, field));
    }
    let (word, colour) = match model {
        Model::Diffuse => ("Kd", &said.diffuse),
        Model::Mirror => ("Ks", &said.specular),
        Model::Glass | Model::Medium | Model::Metal => return,
    };
    match colour {
        Some(colour) if colour.value.iter().any(|part| *part > 1.0) => {
            found.push(errors::above_one(name, word, at.span(colour)));
        }
        None if model == Model::Diffuse
            && said.emissive.is_none()
            && said.diffuse_map.is_none()
            && !shines_unclearly(said) =>
        {
            found.push(errors::no_colour(name, at.span(&said.name)));
        }
        _ => {}
    }
}

/// What is asked for and not rendered: in words, and where.
fn left_out(said: &mtl::Material, at: Place, model: Model) -> Vec<(&'static str, Span)> {
    let mut left_out = Vec::new();
    let illum = said.illum.as_ref();
    if let Some(illum) = illum.filter(|illum| illum.value == 10) {
        left_out.push(("a catcher of shadows", at.span(illum)));
    }
    let highlights = matches!(illum.map(|illum| illum.value), None | Some(2));
    if let Some(ks) = said.specular.as_ref().filter(|ks| highlights && ks.value != [0.0; 3]) {
        left_out.push(("highlights", at.span(ks)));
    }
    // Of clear matter light goes through all of the surface in any case.
    if let Some(d) = said.dissolve.as_ref().filter(|d| d.value < 1.0 && !model.is_clear()) {
        left_out.push(("transparency", at.span(d)));
    }
    if let Some(map) = &said.diffuse_map {
        match model {
            Model::Diffuse if map.value.options => {
                left_out.push(("the options of its texture", at.span(map)));
            }
            Model::Diffuse => {}
            _ => left_out.push(("a texture", at.span(map))),
        }
    }
    if let Some(ke) = said.emissive.as_ref().filter(|ke| ke.value != [0.0; 3] && model.is_clear()) {
        left_out.push(("light of its own", at.span(ke)));
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
