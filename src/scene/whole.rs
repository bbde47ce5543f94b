//! The whole scene: one field a kind.

use serde::Serialize;

use super::schema::{Checked, Kind, Vocabulary};
use super::{
    At, Camera, Film, Integrator, Layer, Light, Material, Medium, Object, Only, Ref, Sampler, Stop,
    Text, Texture,
};
use crate::math::paths::{Expression, Which};

/// A declaration with its name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Named<T> {
    /// Its name.
    pub name: At<String>,
    /// What was declared.
    pub value: At<T>,
}

/// The kind a type of the vocabulary belongs to.
pub trait KindOf {
    /// The word that begins such an item.
    const WORD: &'static str;
}

/// Checked items of a scene, for [`Scene::lower`]: kind, name (empty for unnamed kinds), value.
pub type Items = [(&'static str, At<String>, At<Checked>)];

macro_rules! kinds {
    (
        one {$(
            $(#[doc = $odoc:literal])+
            $(#[serde($serde:meta)])?
            $one:ident: $One:ty $(= $default:literal)?;
        )*}
        many {$($(#[doc = $mdoc:literal])+ $word:literal => $many:ident: $Many:ty;)*}
    ) => {
        /// What one render shows, complete. Declarations stand in the order of their names, so
        /// that their order in the text means nothing; layers alone in that of the text.
        #[derive(Clone, Debug, PartialEq, Serialize)]
        pub struct Scene {
            $($(#[doc = $odoc])+ $(#[serde($serde)])? pub $one: At<$One>,)*
            $($(#[doc = $mdoc])+ pub $many: Vec<Named<$Many>>,)*
        }

        /// Every kind of item.
        pub static KINDS: &[Kind] = &[
            $(Kind {
                word: stringify!($one),
                doc: super::vocabulary::joined(concat!($($odoc, "\n"),+)),
                ty: <$One as Vocabulary>::TYPE,
                named: false,
                default: super::vocabulary::described!(@default $($default)?),
                optional: <$One as Vocabulary>::OPTIONAL,
            },)*
            $(Kind {
                word: $word,
                doc: super::vocabulary::joined(concat!($($mdoc, "\n"),+)),
                ty: <$Many as Vocabulary>::TYPE,
                named: true,
                default: None,
                optional: true,
            },)*
        ];

        $(impl KindOf for $Many {
            const WORD: &'static str = $word;
        })*

        impl Scene {
            /// The scene of checked items: each unnamed kind once, named ones at will. Panics if
            /// an unnamed kind is missing.
            pub fn lower(items: &Items) -> Self {
                let of = |kind: &'static str| items.iter().filter(move |item| item.0 == kind);
                let mut scene = Self {
                    $($one: {
                        let (_, _, item) = of(stringify!($one)).next()
                            .expect("checked: every unnamed kind");
                        let value = Vocabulary::lower(&item.value);
                        At { value, span: item.span, usual: item.usual }
                    },)*
                    $($many: {
                        let mut all: Vec<_> = of($word).map(|(_, name, item)| Named {
                            name: name.clone(),
                            value: At::new(Vocabulary::lower(&item.value), item.span),
                        }).collect();
                        all.sort_by(|a, b| a.name.value.cmp(&b.name.value));
                        all
                    },)*
                };
                // The first that means a path takes it.
                scene.layers.sort_by_key(|layer| layer.name.span);
                scene
            }
        }
    };
}

/// The kinds whose declarations files may name: media, by materials of .mtl files.
pub const NAMED_BY_FILES: &[&str] = &["medium"];

/// The kinds whose declarations are there whether anything names them or not, though some do.
pub const SEEN: &[&str] = &["object"];

kinds! {
    one {
        /// Where the picture is taken from.
        camera: Camera = "overview {}";
        /// What the picture shows, in words; goes into the EXR file.
        caption: Text = "\"\"";
        /// The picture's size, and how samples become pixels.
        film: Film = "{}";
        /// How the light that reaches the camera is computed.
        integrator: Integrator;
        /// Where the random numbers come from.
        sampler: Sampler = "sobol {}";
        /// When the picture is done.
        stop: Stop = "{}";
        /// What fills the space around everything. Left out: a vacuum.
        #[serde(skip_serializing_if = "At::is_usual")]
        surroundings: Option<Ref<Medium>>;
    }
    many {
        /// Part of the light of the picture, in a picture of its own.
        "layer" => layers: Layer;
        /// Light that comes from no surface.
        "light" => lights: Light;
        /// What a surface does with light.
        "material" => materials: Material;
        /// What fills space.
        "medium" => media: Medium;
        /// A surface, or many.
        "object" => objects: Object;
        /// A colour that differs from place to place of a surface.
        "texture" => textures: Texture;
    }
}

impl Scene {
    /// Which paths the picture shows, if not all, and which each layer takes.
    pub fn which_paths(&self) -> (Option<&Expression>, Vec<Which<'_>>) {
        let layers = self.layers.iter().map(|layer| {
            let Layer::PathsLayer(layer) = &*layer.value;
            match &*layer.only {
                Only::Paths(paths) => Which::Only(&paths.expression),
                Only::Others => Which::Others,
            }
        });
        (self.integrator.paths().map(|shown| &shown.value.expression), layers.collect())
    }

    /// The material a reference names.
    pub fn material(&self, name: &super::Ref<Material>) -> &Named<Material> {
        let found = self.materials.binary_search_by(|m| m.name.value.as_str().cmp(&name.name));
        &self.materials[found.expect("checked: references name declarations")]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::schema::{Field, Type};

    fn fields(ty: Type, found: &mut Vec<Field>) {
        let records = match ty {
            Type::OneOf(variants) => variants.all,
            Type::Record(record) => std::slice::from_ref(record),
            Type::List(inner) | Type::Map(inner) => return fields(*inner, found),
            _ => return,
        };
        for field in records.iter().flat_map(|record| record.fields) {
            found.push(*field);
            fields(field.ty, found);
        }
    }

    #[test]
    fn no_field_is_called_like_a_unit_and_each_says_what_it_means() {
        let mut all = Vec::new();
        KINDS.iter().for_each(|kind| fields(kind.ty, &mut all));
        assert!(all.len() > 30);
        for field in all {
            assert!(crate::math::units::find(field.word).is_none(), "{} is a unit", field.word);
            assert!(field.doc.len() > 5, "{} has no doc", field.word);
        }
    }
}
