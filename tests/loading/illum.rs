//! What the `illum` of a material in a .mtl file makes of it.

use std::sync::Arc;

use scn::load::{Loader, Stage};
use scn::math::{NoProgress, Spectrum};
use scn::scene::{
    Homogeneous, Index, Material, Medium, Named, Radiance, Ref, Reflectance, Textured,
};

use crate::{FACE, Folder, at, scene, sources};

/// The one material of a mesh whose file says this of the material `name`.
fn made_of(name: &str, values: &str) -> Result<(Material, Stage), String> {
    let obj = FACE.replace("f 1", &format!("usemtl {name}\nf 1"));
    let mtl = format!("newmtl {name}\n{values}\n");
    let folder = Folder::with(&[("a.obj", &format!("mtllib a.mtl\n{obj}")), ("a.mtl", &mtl)]);
    let mut scene = scene(vec![("a", folder.mesh("a.obj"))]);
    let medium = |name: &str, n| Named {
        name: at(name.to_string()),
        value: at(Medium::Homogeneous(Homogeneous::clear(at(Index {
            n: Spectrum::Constant(n),
            k: Spectrum::Constant(0.0),
        })))),
    };
    Arc::make_mut(&mut scene).media = vec![medium("glass", 1.5), medium("wine", 1.34)];
    let (stage, found) = Loader::new(&NoProgress).stage(&scene, &mut sources());
    let Some(stage) = stage else {
        assert_eq!(found.len(), 1, "{found:?}");
        return Err(format!("{}; {}", found[0].headline, found[0].help.as_deref().unwrap_or("")));
    };
    let material = stage.meshes[0].as_ref().unwrap().materials[0].value.value.clone();
    Ok((material, stage))
}

#[test]
fn illum_says_what_a_material_is() {
    let sides = |name: &str, values: &str| {
        let (material, stage) = made_of(name, values).unwrap();
        let Material::Dielectric(dielectric) = material else { panic!("{material:?}") };
        let index = |name: &Ref<Medium>| {
            let Medium::Homogeneous(medium) = &stage.medium(name).value.value;
            medium.ior.n.clone()
        };
        (index(&dielectric.inside), dielectric.outside.as_ref().map(index))
    };
    for illum in [4, 5, 6, 7, 9] {
        let found = sides("any", &format!("illum {illum}\nNi 1.7"));
        assert_eq!(found, (Spectrum::Constant(1.7), None));
    }
    for illum in [12, 13, 14] {
        let found = sides("wine", &format!("illum {illum}\nNi 1.7"));
        assert_eq!(found, (Spectrum::Constant(1.34), None));
        let found = sides("glass_to_wine", &format!("illum {illum}"));
        assert_eq!(found, (Spectrum::Constant(1.34), Some(Spectrum::Constant(1.5))));
    }
    let (mirror, _) = made_of("any", "illum 3\nKs 0.5 0.6 0.7\nKd 1\nKe 2 2 2").unwrap();
    let Material::Mirror(mirror) = mirror else { panic!("{mirror:?}") };
    let Textured::Plain(Reflectance(Spectrum::Rgb(ks))) = mirror.reflectance.value else {
        panic!("plain")
    };
    // tobj reads single precision.
    assert!(ks.iter().zip([0.5, 0.6, 0.7]).all(|(found, said)| (found - said).abs() < 1e-6));
    assert_eq!(mirror.emission.value, Radiance(Spectrum::Rgb([2.0; 3])));
    let (gold, _) = made_of("gold", "illum 11").unwrap();
    let Material::Conductor(gold) = gold else { panic!("{gold:?}") };
    assert!(gold.ior.absorbs() && matches!(gold.ior.n, Spectrum::Table(_)));
}

#[test]
fn what_illum_needs_and_is_missing_is_told_with_the_line_to_write() {
    for (name, values, told, line) in [
        ("a", "illum 4", "the material `a` is glass, and has no index of refraction", "`Ni 1.5`"),
        ("a", "illum 5\nNi 0", "the material `a` is glass, and has no index", "`Ni 1.5`"),
        ("a", "illum 3", "the material `a` is a mirror, and has no Ks", "`Ks 1 1 1`"),
        ("golden", "illum 11", "there is no metal `golden`", "call it `gold`"),
        ("milk", "illum 13", "the scene declares no medium `milk`", "`medium milk: homogeneous {"),
        ("wine_to_x.1", "illum 12", "the scene declares no medium `x.1`", "`medium \"x.1\": homo"),
    ] {
        let found = made_of(name, values).map(|_| ()).unwrap_err();
        assert!(found.starts_with(told) && found.contains(line), "{found}");
    }
}
