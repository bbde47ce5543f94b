//! What is offered to one who does not know the words: what variants are called in other programs
//! and in everyday speech, and which one is the most usual. None of it means anything in a scene.

/// Of a kind that each render must state, what to begin with.
const USUAL: &[(&str, &str)] = &[("camera", "overview"), ("integrator", "path")];

/// A kind of choice, a word that is none of it, and the one it most likely stands for.
const ELSEWHERE: &[(&str, &str, &str)] = &[
    ("camera", "orthographic", "overview"),
    ("camera", "pinhole", "perspective"),
    ("filter", "triangle", "tent"),
    ("integrator", "ao", "ambient"),
    ("integrator", "pathtracer", "path"),
    ("integrator", "pt", "path"),
    ("light", "ambient", "constant"),
    ("light", "distant", "directional"),
    ("light", "environment", "constant"),
    ("light", "infinite", "constant"),
    ("light", "omni", "point"),
    ("light", "sky", "preetham"),
    ("light", "skylight", "preetham"),
    ("light", "sun", "directional"),
    ("material", "blend", "mix"),
    ("material", "clear", "dielectric"),
    ("material", "glass", "dielectric"),
    ("material", "lambert", "diffuse"),
    ("material", "lambertian", "diffuse"),
    ("material", "matte", "diffuse"),
    ("material", "metal", "conductor"),
    ("material", "metallic", "conductor"),
    ("material", "reflective", "mirror"),
    ("material", "refractive", "dielectric"),
    ("material", "specular", "mirror"),
    ("material", "transparent", "dielectric"),
    ("object", "ball", "sphere"),
    ("object", "disc", "disk"),
    ("object", "obj", "mesh"),
    ("object", "rect", "quad"),
    ("object", "rectangle", "quad"),
    ("object", "trianglemesh", "mesh"),
    ("sampler", "random", "independent"),
    ("texture", "bitmap", "image"),
    ("texture", "checkerboard", "checker"),
];

/// The variant that a word of elsewhere most likely stands for.
pub fn meant(choice: &str, word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    let known = ELSEWHERE.iter().find(|(of, known, _)| *of == choice && *known == word);
    known.map(|(_, _, meant)| *meant)
}

/// What to begin with of a kind that each render must state.
pub fn usual(kind: &str) -> Option<&'static str> {
    USUAL.iter().find(|(of, _)| *of == kind).map(|(_, usual)| *usual)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::schema::{Record, Type, Variants};
    use crate::scene::{Film, KINDS, schema::Vocabulary};

    fn of(ty: &Type) -> Option<&'static Variants> {
        match ty {
            Type::OneOf(variants) => Some(variants),
            _ => None,
        }
    }

    #[test]
    fn what_is_meant_is_a_variant_and_the_word_is_none() {
        let Type::Record(Record { fields, .. }) = Film::TYPE else { panic!() };
        let types = KINDS.iter().map(|kind| kind.ty).chain(fields.iter().map(|field| field.ty));
        let all: Vec<_> = types.filter_map(|ty| of(&ty)).collect();
        for (choice, word, meant) in ELSEWHERE {
            let variants = all.iter().find(|variants| variants.name == *choice).expect(choice);
            let known = |word: &str| variants.all.iter().any(|record| record.word == word);
            assert!(known(meant) && !known(word), "{choice}: {word} → {meant}");
        }
        assert!(ELSEWHERE.is_sorted());
        for kind in KINDS.iter().filter(|kind| !kind.optional && kind.default.is_none()) {
            let usual = usual(kind.word).expect(kind.word);
            assert!(of(&kind.ty).unwrap().all.iter().any(|record| record.word == usual));
        }
        assert_eq!(meant("material", "Glass"), Some("dielectric"));
        assert_eq!(meant("light", "glass"), None);
    }
}
