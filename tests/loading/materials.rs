//! Materials of .mtl files, and what the scene makes of them.

use scn::diag::Code;
use scn::scene::{KaMeans, Material, Ref};

use crate::{FACE, Folder, PAINTED, at, one, paints, said, stage, told};

#[test]
fn materials_come_from_the_mtl_file_with_their_places() {
    let mtl = "newmtl red\nKd 1 0 0\nnewmtl white\nKd 0.9 0.8 0.7\nKe 3 2 1\n";
    let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", mtl)]);
    let (stage, found, sources) = stage(folder.mesh("a.obj"));
    assert_eq!(found, []);
    let stage = stage.unwrap();
    assert_eq!(paints(&stage), [([0.9, 0.8, 0.7], [3.0, 2.0, 1.0])]);
    let white = &stage.meshes[0].as_ref().unwrap().materials[0];
    let Material::Diffuse(diffuse) = &white.value.value else { panic!("diffuse") };
    assert_eq!(sources.text(diffuse.albedo.span), "Kd 0.9 0.8 0.7");
    assert_eq!(sources.line_column(white.name.span), (3, 1));
    let names: Vec<_> = stage.files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["a.obj", "a.mtl"]);
    assert_eq!((stage.files[0].bytes, stage.files[0].triangles), (PAINTED.len() as u64, Some(1)));
}

#[test]
fn the_scene_replaces_materials_and_what_it_replaces_may_be_missing() {
    let folder = Folder::with(&[("a.obj", PAINTED), ("bare.obj", FACE)]);
    for file in ["a.obj", "bare.obj"] {
        let mut all = folder.mesh(file);
        all.material = at(Some(Ref::new("grey")));
        assert_eq!(paints(&stage(all).0.unwrap())[0].0, [0.5; 3]);
    }
    let mut named = folder.mesh("a.obj");
    named.materials = at(vec![(at("white".into()), at(Ref::new("pink")))]);
    assert_eq!(paints(&stage(named).0.unwrap())[0].0, [0.75; 3]);
}

#[test]
fn another_mtl_file_may_be_named() {
    let folder = Folder::with(&[("a.obj", PAINTED), ("other.mtl", "newmtl white\nKd 0.1\n")]);
    let mut mesh = folder.mesh("a.obj");
    mesh.mtl = at(Some(folder.name("other.mtl")));
    assert_eq!(paints(&stage(mesh).0.unwrap())[0].0, [0.1; 3]);
}

#[test]
fn materials_that_are_missing_are_told() {
    let folder = Folder::with(&[
        ("a.obj", PAINTED),
        ("a.mtl", "newmtl wite\nKd 1\n"),
        ("bare.obj", FACE),
        ("orphan.obj", &PAINTED.replace("mtllib a.mtl", "")),
    ]);
    let missing = said(Code::MESH_MISSING_MATERIAL, "a.obj", 5, "usemtl white");
    assert_eq!(one(folder.mesh("a.obj")), missing);
    let (_, found, _) = stage(folder.mesh("a.obj"));
    assert!(found[0].help.as_ref().unwrap().starts_with("write `usemtl wite`"));
    let none = said(Code::MESH_NO_MATERIAL, "bare.obj", 4, "f 1 2 3");
    assert_eq!(one(folder.mesh("bare.obj")), none);
    assert_eq!(one(folder.mesh("orphan.obj")).0, Code::MESH_MISSING_MATERIAL);

    let mut unknown = folder.mesh("a.obj");
    unknown.materials = at(vec![
        (at("white".into()), at(Ref::new("pink"))),
        (at("whit".into()), at(Ref::new("pink"))),
    ]);
    assert_eq!(one(unknown.clone()), said(Code::MESH_UNKNOWN_MATERIAL, "a.scn", 1, "mesh"));
    unknown.material = at(Some(Ref::new("grey")));
    assert_eq!(told(unknown)[0].0, Code::MESH_TWO_REPLACEMENTS);
}

#[test]
fn a_ka_must_be_explained() {
    let mtl = "newmtl white\nKa 4 5 6\nKd 0.5\nnewmtl unused\nKa 1 1 1\n";
    let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", mtl)]);
    let mut mesh = folder.mesh("a.obj");
    assert_eq!(one(mesh.clone()), said(Code::MTL_AMBIENT, "a.mtl", 2, "Ka 4 5 6"));
    let (_, found, _) = stage(mesh.clone());
    assert_eq!(
        found[0].headline,
        "the scene must say what Ka means in the material `white` of `a.obj`"
    );
    assert_eq!(found[0].mends.len(), 2);
    mesh.ambient = at(Some(KaMeans::Emission));
    assert_eq!(paints(&stage(mesh.clone()).0.unwrap()), [([0.5; 3], [4.0, 5.0, 6.0])]);
    mesh.ambient = at(Some(KaMeans::Ignored));
    assert_eq!(paints(&stage(mesh.clone()).0.unwrap()), [([0.5; 3], [0.0; 3])]);
    mesh.ambient = at(None);
    mesh.material = at(Some(Ref::new("grey")));
    assert!(stage(mesh).0.is_some());
}

#[test]
fn what_is_not_rendered_warns_and_what_has_no_effect_does_not() {
    let warned = |values: &str| {
        let mtl = format!("newmtl white\n{values}\n");
        let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", &mtl)]);
        let (stage, found, _) = stage(folder.mesh("a.obj"));
        assert!(stage.is_some(), "{found:?}");
        found.into_iter().map(|d| d.headline).collect::<Vec<_>>()
    };
    let none: [&str; 0] = [];
    assert_eq!(warned("Kd 1\nKs 1 1 1\nNs 90\nNi 1.5\nillum 0"), none);
    assert_eq!(warned("Kd 1\nKs 1 1 1\nillum 1\nd 1\nTf 1 1 1"), none);
    assert_eq!(warned("Kd 1\nKs 0 0 0\nillum 2"), none);
    let without =
        |what: &str| [format!("the material `white` is rendered as diffuse, without {what}")];
    assert_eq!(warned("Kd 1\nKs 1 1 1\nillum 2"), without("highlights"));
    assert_eq!(
        warned("Kd 1\nillum 10\nd 0.5\nmap_Ks a.png"),
        without("a catcher of shadows, transparency and a texture")
    );
    assert_eq!(
        warned("illum 4\nNi 1.5\nd 0.1\nTf 1 0 0\nKe 1 1 1"),
        ["the material `white` is rendered without light of its own and coloured glass"]
    );
    assert_eq!(
        warned("illum 3\nKs 1 1 2"),
        ["the material `white` gives back more light than it gets"]
    );
    assert_eq!(warned("Kd 1.5"), ["the material `white` gives back more light than it gets"]);
    assert_eq!(warned("illum 1"), ["the material `white` has no Kd and is rendered black"]);
    assert_eq!(warned("Ke 1 1 1"), none);
}

#[test]
fn faults_of_the_mtl_file_are_told_in_it() {
    let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", "newmtl white\nKd 1 -1 1\n")]);
    assert_eq!(one(folder.mesh("a.obj")), said(Code::MTL_NEGATIVE, "a.mtl", 2, "-1"));
    let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", "<?xml?>\n")]);
    assert_eq!(one(folder.mesh("a.obj")).0, Code::MTL_NOT_WAVEFRONT);
}
