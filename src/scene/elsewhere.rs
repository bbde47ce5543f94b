//! What is offered to one who does not know the words: what kinds, variants and fields are called in
//! other programs and in everyday speech, and which variant is the most usual. None of it means
//! anything in a scene.

/// Of a kind that each render must state, what to begin with.
const USUAL: &[(&str, &str)] = &[("camera", "overview"), ("integrator", "path")];

/// A word that is no kind, and the one it most likely stands for.
const KINDS_ELSEWHERE: &[(&str, &str)] = &[
    ("body", "object"),
    ("brdf", "material"),
    ("bsdf", "material"),
    ("emitter", "light"),
    ("geometry", "object"),
    ("lamp", "light"),
    ("method", "integrator"),
    ("output", "film"),
    ("picture", "film"),
    ("primitive", "object"),
    ("renderer", "integrator"),
    ("sensor", "camera"),
    ("shader", "material"),
    ("shape", "object"),
    ("surface", "material"),
    ("view", "camera"),
    ("volume", "medium"),
];

/// A kind of choice, a word that is none of it, and the one it most likely stands for.
const ELSEWHERE: &[(&str, &str, &str)] = &[
    ("camera", "orthogonal", "overview"),
    ("camera", "orthographic", "overview"),
    ("camera", "persp", "perspective"),
    ("camera", "pinhole", "perspective"),
    ("camera", "realistic", "perspective"),
    ("camera", "thin_lens", "perspective"),
    ("camera", "thinlens", "perspective"),
    ("filter", "bicubic", "mitchell"),
    ("filter", "boxcar", "box"),
    ("filter", "cubic", "mitchell"),
    ("filter", "gauss", "gaussian"),
    ("filter", "triangle", "tent"),
    ("integrator", "ambient_occlusion", "ambient"),
    ("integrator", "ambientocclusion", "ambient"),
    ("integrator", "ao", "ambient"),
    ("integrator", "cycles", "path"),
    ("integrator", "directlighting", "direct"),
    ("integrator", "gi", "path"),
    ("integrator", "global_illumination", "path"),
    ("integrator", "montecarlo", "path"),
    ("integrator", "occlusion", "ambient"),
    ("integrator", "path_tracer", "path"),
    ("integrator", "pathtracer", "path"),
    ("integrator", "pt", "path"),
    ("integrator", "randomwalk", "path"),
    ("integrator", "raytracer", "direct"),
    ("integrator", "simpledirect", "direct"),
    ("integrator", "simplepath", "path"),
    ("integrator", "simplevolpath", "path"),
    ("integrator", "volpath", "path"),
    ("integrator", "whitted", "direct"),
    ("light", "ambient", "constant"),
    ("light", "background", "constant"),
    ("light", "bulb", "point"),
    ("light", "cone", "spot"),
    ("light", "daylight", "preetham"),
    ("light", "distant", "directional"),
    ("light", "dome", "constant"),
    ("light", "environment", "constant"),
    ("light", "envmap", "constant"),
    ("light", "hosek", "preetham"),
    ("light", "infinite", "constant"),
    ("light", "nishita", "preetham"),
    ("light", "omni", "point"),
    ("light", "parallel", "directional"),
    ("light", "projector", "spot"),
    ("light", "sky", "preetham"),
    ("light", "skylight", "preetham"),
    ("light", "sun", "directional"),
    ("light", "sunsky", "preetham"),
    ("light", "uniform", "constant"),
    ("light", "world", "constant"),
    ("material", "blend", "mix"),
    ("material", "blendbsdf", "mix"),
    ("material", "chrome", "mirror"),
    ("material", "clear", "dielectric"),
    ("material", "copper", "conductor"),
    ("material", "glass", "dielectric"),
    ("material", "gold", "conductor"),
    ("material", "lambert", "diffuse"),
    ("material", "lambertian", "diffuse"),
    ("material", "matte", "diffuse"),
    ("material", "metal", "conductor"),
    ("material", "metallic", "conductor"),
    ("material", "mixture", "mix"),
    ("material", "reflective", "mirror"),
    ("material", "refractive", "dielectric"),
    ("material", "silver", "conductor"),
    ("material", "specular", "mirror"),
    ("material", "transparent", "dielectric"),
    ("object", "ball", "sphere"),
    ("object", "circle", "disk"),
    ("object", "disc", "disk"),
    ("object", "floor", "plane"),
    ("object", "ground", "plane"),
    ("object", "halfspace", "plane"),
    ("object", "icosphere", "sphere"),
    ("object", "model", "mesh"),
    ("object", "obj", "mesh"),
    ("object", "parallelogram", "quad"),
    ("object", "ply", "mesh"),
    ("object", "polygons", "mesh"),
    ("object", "rect", "quad"),
    ("object", "rectangle", "quad"),
    ("object", "square", "quad"),
    ("object", "tri", "triangle"),
    ("object", "trianglemesh", "mesh"),
    ("object", "wavefront", "mesh"),
    ("phase function", "hg", "henyey_greenstein"),
    ("phase function", "uniform", "isotropic"),
    ("sampler", "halton", "sobol"),
    ("sampler", "jitter", "stratified"),
    ("sampler", "jittered", "stratified"),
    ("sampler", "lds", "sobol"),
    ("sampler", "ldsampler", "sobol"),
    ("sampler", "lowdiscrepancy", "sobol"),
    ("sampler", "multijitter", "stratified"),
    ("sampler", "prng", "independent"),
    ("sampler", "pseudorandom", "independent"),
    ("sampler", "random", "independent"),
    ("texture", "bitmap", "image"),
    ("texture", "checkerboard", "checker"),
    ("texture", "imagemap", "image"),
    ("texture", "photo", "image"),
    ("texture", "picture", "image"),
];

/// What a field may be called elsewhere, and here.
const FIELDS: &[(&str, &str)] = &[
    ("base_color", "albedo"),
    ("basecolor", "albedo"),
    ("bounces", "depth"),
    ("brdf", "material"),
    ("brightness", "intensity"),
    ("brightness", "irradiance"),
    ("brightness", "radiance"),
    ("bsdf", "material"),
    ("centre", "center"),
    ("color", "albedo"),
    ("color", "intensity"),
    ("color", "irradiance"),
    ("color", "radiance"),
    ("color", "reflectance"),
    ("colour", "albedo"),
    ("colour", "intensity"),
    ("colour", "irradiance"),
    ("colour", "radiance"),
    ("colour", "reflectance"),
    ("diffuse", "albedo"),
    ("dir", "direction"),
    ("emit", "emission"),
    ("emittance", "emission"),
    ("eta", "ior"),
    ("exterior", "outside"),
    ("factor", "amount"),
    ("filename", "file"),
    ("fov", "fov_y"),
    ("from", "eye"),
    ("from", "position"),
    ("index", "ior"),
    ("int_ior", "ior"),
    ("intensity", "irradiance"),
    ("intensity", "radiance"),
    ("interior", "inside"),
    ("kd", "albedo"),
    ("ke", "emission"),
    ("ks", "reflectance"),
    ("location", "eye"),
    ("location", "position"),
    ("lookat", "look_at"),
    ("matrix", "place"),
    ("max_bounces", "depth"),
    ("max_depth", "depth"),
    ("maxdepth", "depth"),
    ("n", "ior"),
    ("nee", "next_event"),
    ("ni", "ior"),
    ("origin", "center"),
    ("origin", "eye"),
    ("origin", "position"),
    ("part", "amount"),
    ("path", "file"),
    ("pixelsamples", "samples"),
    ("pos", "center"),
    ("pos", "eye"),
    ("pos", "position"),
    ("position", "center"),
    ("position", "eye"),
    ("radiance", "emission"),
    ("ratio", "amount"),
    ("rays", "samples"),
    ("reflectance", "albedo"),
    ("refractive_index", "ior"),
    ("res", "size"),
    ("resolution", "size"),
    ("rr_depth", "roulette_after"),
    ("sample_count", "samples"),
    ("shader", "material"),
    ("sigma_a", "absorption"),
    ("sigma_s", "scattering"),
    ("spp", "samples"),
    ("src", "file"),
    ("strength", "intensity"),
    ("strength", "irradiance"),
    ("strength", "radiance"),
    ("surface", "material"),
    ("target", "look_at"),
    ("to", "look_at"),
    ("to_world", "place"),
    ("transform", "place"),
    ("vfov", "fov_y"),
    ("weight", "amount"),
    ("yfov", "fov_y"),
];

/// A kind of choice, words that are none of it, and what to do instead.
const OTHERWISE: &[(&str, &[&str], &str)] = &[
    (
        "light",
        &["area", "arealight", "diffuse", "mesh", "quad", "rect", "rectangle", "sphere"],
        "what shines with a surface is an object: give its material an `emission`",
    ),
    (
        "material",
        &["area", "emissive", "emission", "emitter", "lamp", "light"],
        "each opaque material may shine: `diffuse { albedo: 0, emission: 10 W/m^2/sr }`",
    ),
    (
        "material",
        &["disney", "glossy", "phong", "plastic", "principled", "substrate", "uber"],
        "make it of the materials there are: `mix { … }` joins two of them",
    ),
    (
        "material",
        &["ggx", "microfacet", "rough", "roughconductor", "roughdielectric", "roughness"],
        "all that reflects like a mirror is smooth as yet: `mix { … }` of it and `diffuse` comes \
         nearest",
    ),
    (
        "object",
        &["box", "cone", "cube", "cylinder", "torus"],
        "use a `mesh`, or a `quad` for each flat side",
    ),
];

/// A variant, a word that is no field of it, though one of others, and the field it stands for there.
const FIELDS_OF: &[(&str, &str, &str)] = &[("mix", "a", "first"), ("mix", "b", "second")];

/// What a field may be called elsewhere whose value is twice that of one here.
const HALVES: &[(&str, &str)] = &[("diameter", "radius")];

/// What looks like a field and measures something else, and how the two belong together.
const UNLIKE: &[(&str, &str, &str)] = {
    const WIDTH: &str = "for a picture of w by h pixels, tan(fov_y / 2) = h / w * tan(fov_x / 2)";
    &[
        ("fov_x", "fov_y", WIDTH),
        ("hfov", "fov_y", WIDTH),
        ("horizontal_fov", "fov_y", WIDTH),
        ("xfov", "fov_y", WIDTH),
    ]
};

/// The field here whose value is half of that of a field elsewhere.
pub fn half(word: &str) -> Option<&'static str> {
    HALVES.iter().find(|(known, _)| *known == word).map(|(_, meant)| *meant)
}

/// The field here that measures something else than one elsewhere which it looks like, and how one
/// follows from the other.
pub fn unlike(word: &str) -> Option<(&'static str, &'static str)> {
    UNLIKE.iter().find(|(known, ..)| *known == word).map(|(_, meant, how)| (*meant, *how))
}

/// The variant that a word of elsewhere most likely stands for.
pub fn meant(choice: &str, word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    let known = ELSEWHERE.iter().find(|(of, known, _)| *of == choice && *known == word);
    known.map(|(_, _, meant)| *meant)
}

/// What to do where a kind of choice has nothing that a word of elsewhere stands for.
pub fn otherwise(choice: &str, word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    let known = |words: &[&str]| words.contains(&word.as_str());
    OTHERWISE.iter().find(|(of, words, _)| *of == choice && known(words)).map(|it| it.2)
}

/// What is to be done with a word of elsewhere, wherever it may stand; by the kinds of choice it is
/// known of.
pub fn anywhere(word: &str) -> (Vec<(&'static str, &'static str)>, Vec<&'static str>) {
    let word = word.to_lowercase();
    let known = ELSEWHERE.iter().filter(|(_, known, _)| *known == word);
    let advice = OTHERWISE.iter().filter(|(_, words, _)| words.contains(&word.as_str()));
    (known.map(|(choice, _, meant)| (*choice, *meant)).collect(), advice.map(|it| it.2).collect())
}

/// The kind that a word of elsewhere most likely stands for.
pub fn kind(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    KINDS_ELSEWHERE.iter().find(|(known, _)| *known == word).map(|(_, meant)| *meant)
}

/// The fields that a word of elsewhere may stand for.
pub fn fields(word: &str) -> impl Iterator<Item = &'static str> + use<> {
    let word = word.to_lowercase();
    FIELDS.iter().filter(move |(known, _)| *known == word).map(|(_, meant)| *meant)
}

/// The field of a variant that a word stands for there alone.
pub fn field_of(variant: &str, word: &str) -> Option<&'static str> {
    let known = FIELDS_OF.iter().find(|(of, known, _)| *of == variant && *known == word);
    known.map(|(.., meant)| *meant)
}

/// Whether it is known what a word stands for that is no field of a variant.
pub fn is_known(variant: &str, word: &str) -> bool {
    fields(word).next().is_some() || half(word).or(field_of(variant, word)).is_some()
}

/// What to begin with of a kind that each render must state.
pub fn usual(kind: &str) -> Option<&'static str> {
    USUAL.iter().find(|(of, _)| *of == kind).map(|(_, usual)| *usual)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::KINDS;
    use crate::scene::schema::{Record, Type, Variants};

    fn inside(ty: &Type, choices: &mut Vec<&'static Variants>, words: &mut Vec<&'static str>) {
        let records: &[Record] = match ty {
            Type::OneOf(variants) => {
                choices.push(variants);
                variants.all
            }
            Type::Record(record) => std::slice::from_ref(*record),
            Type::List(inner) | Type::Map(inner) => return inside(inner, choices, words),
            _ => return,
        };
        for field in records.iter().flat_map(|record| record.fields) {
            words.push(field.word);
            inside(&field.ty, choices, words);
        }
    }

    #[test]
    fn what_is_meant_is_a_word_and_what_is_said_is_none() {
        let (mut choices, mut fields) = (Vec::new(), Vec::new());
        KINDS.iter().for_each(|kind| inside(&kind.ty, &mut choices, &mut fields));
        let known = |choice: &str, word: &str| {
            let variants = choices.iter().find(|variants| variants.name == choice).expect(choice);
            variants.all.iter().any(|record| record.word == word)
        };
        for (choice, word, meant) in ELSEWHERE {
            assert!(known(choice, meant) && !known(choice, word), "{choice}: {word} → {meant}");
        }
        for (choice, words, _) in OTHERWISE {
            let none = |word: &&str| !known(choice, word) && super::meant(choice, word).is_none();
            assert!(words.iter().all(none), "{choice}: {words:?}");
        }
        for (word, meant) in KINDS_ELSEWHERE {
            let is = |word: &str| KINDS.iter().any(|kind| kind.word == word);
            assert!(is(meant) && !is(word), "{word} → {meant}");
        }
        for (word, meant) in FIELDS {
            assert!(fields.contains(meant) && word != meant, "{word} → {meant}");
        }
        let records = choices.iter().flat_map(|variants| variants.all);
        for (variant, word, meant) in FIELDS_OF {
            let has = |record: &&Record, word| record.fields.iter().any(|it| it.word == word);
            let of = records.clone().find(|record| record.word == *variant).expect(variant);
            assert!(has(&of, *meant) && !has(&of, *word), "{variant}: {word} → {meant}");
        }
        for (word, meant) in HALVES.iter().copied().chain(UNLIKE.iter().map(|it| (it.0, it.1))) {
            assert!(fields.contains(&meant) && !fields.contains(&word), "{word} → {meant}");
        }
        assert!(ELSEWHERE.is_sorted() && FIELDS.is_sorted() && KINDS_ELSEWHERE.is_sorted());
    }

    #[test]
    fn what_must_be_stated_has_something_to_begin_with() {
        for kind in KINDS.iter().filter(|kind| !kind.optional && kind.default.is_none()) {
            let usual = usual(kind.word).expect(kind.word);
            let Type::OneOf(variants) = kind.ty else { panic!("{}", kind.word) };
            assert!(variants.all.iter().any(|record| record.word == usual));
        }
    }

    #[test]
    fn a_word_stands_for_what_its_choice_has() {
        assert_eq!(meant("material", "Glass"), Some("dielectric"));
        assert_eq!(meant("light", "glass"), None);
        assert_eq!(kind("BSDF"), Some("material"));
    }
}
