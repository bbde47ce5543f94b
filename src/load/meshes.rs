//! A mesh object: its triangles, and for each of its material slots the material.

use std::path::{Component, Path, PathBuf};
use std::rc::Rc;

use super::errors::{file, mesh as errors, mtl};
use super::files::{self, Asked, MtlFile, ObjFile, Shelf};
use super::illum::{Context, Model};
use super::loader::Used;
use super::{StagedFile, StagedMesh, StagedTexture, materials, textures};
use crate::diag::{Diagnostic, Sources, Span};
use crate::files::mtl::Material as Said;
use crate::scene::{self, At, Material, Medium, Named, Ref, Scene, Texture};

/// What staging a mesh works with.
pub(super) struct Desk<'a, 'p> {
    pub shelf: &'a mut Shelf<'p>,
    pub sources: &'a mut Sources,
    pub scene: &'a Scene,
    pub found: &'a mut Vec<Diagnostic>,
    pub used: &'a mut Vec<Used>,
    /// Textures, those of .mtl files added.
    pub textures: &'a mut Vec<StagedTexture>,
    /// Media of materials in files.
    pub media: &'a mut Vec<Named<Medium>>,
}

/// There is an error, which was told.
struct Told;

/// Where a material slot gets its material from.
enum Origin<'s> {
    /// The scene.
    Scene(&'s Named<Material>),
    /// The .mtl file.
    Library,
}

impl Desk<'_, '_> {
    /// Reads an object's files. None: there is an error, which was told.
    pub fn stage(&mut self, object: &str, mesh: &scene::Mesh) -> Option<StagedMesh> {
        let span = mesh.file.span;
        let asked = Asked { name: &mesh.file.text, path: &mesh.file.path, span };
        let obj = self.shelf.obj(asked, self.sources, self.found);
        let Some(obj) = obj else {
            self.check_fields(object, mesh);
            return None;
        };
        let file = StagedFile {
            name: asked.name.to_string(),
            path: asked.path.to_path_buf(),
            span,
            bytes: obj.bytes,
            triangles: Some(obj.mesh.triangles.len() as u64),
        };
        Used::note(self.used, file, obj.digest);
        let fields = self.check_fields(object, mesh);
        let replaced = fields && self.check_replacements(mesh, &obj);

        let scene = self.scene;
        let origins: Vec<Origin> =
            obj.mesh.material_names.iter().map(|name| origin(scene, mesh, name)).collect();
        let needs_library = |(origin, name): (&Origin, &String)| {
            matches!(origin, Origin::Library) && !name.is_empty()
        };
        // A .mtl file that nothing needs may be missing or wrong.
        let needed = origins.iter().zip(&obj.mesh.material_names).any(needs_library);
        let libraries = if needed { self.libraries(mesh, &obj) } else { Some(Vec::new()) };

        let mut staged = Vec::new();
        let mut whole = replaced && libraries.is_some();
        let mut shining = Vec::new();
        let mut missing = Vec::new();
        for (slot, origin) in origins.iter().enumerate() {
            let name = &obj.mesh.material_names[slot];
            match (origin, &libraries) {
                (Origin::Scene(material), _) => staged.push((*material).clone()),
                (Origin::Library, _) if name.is_empty() => missing.push(slot),
                (Origin::Library, None) => {}
                (Origin::Library, Some(libraries)) => match find(libraries, name) {
                    Some((library, said)) => {
                        let at = materials::Place { library: library.source };
                        let ambient = mesh.ambient.value;
                        materials::warn(said, at, span, self.found);
                        if ambient.is_none() && materials::shines_unclearly(said) {
                            shining.push((name.as_str(), at, said));
                        }
                        let texture = match Model::of(said) {
                            Model::Diffuse => self.map(library, said, span),
                            _ => Ok(None),
                        };
                        let texture = texture.unwrap_or_else(|Told| {
                            whole = false;
                            None
                        });
                        let mut context = Context {
                            scene,
                            file: &self.sources.get(library.source).name,
                            field: span,
                            at,
                            media: self.media,
                        };
                        match materials::scene_material(said, ambient, texture, &mut context) {
                            Ok(material) => staged.push(material),
                            Err(fault) => {
                                self.found.push(*fault);
                                whole = false;
                            }
                        }
                    }
                    None => missing.push(slot),
                },
            }
        }
        if !shining.is_empty() {
            self.found.push(mtl::ambient(asked.name, &shining, span));
            whole = false;
        }
        for slot in missing {
            self.missing_material(object, mesh, &obj, slot, libraries.as_deref().unwrap_or(&[]));
            whole = false;
        }
        let (mesh, reach) = (obj.mesh.clone(), obj.reach.clone());
        whole.then_some(StagedMesh { mesh, reach, materials: staged })
    }

    /// Both ways to replace materials cannot hold at once.
    fn check_fields(&mut self, object: &str, mesh: &scene::Mesh) -> bool {
        let both = mesh.material.value.is_some() && !mesh.materials.value.is_empty();
        if both {
            let places = (mesh.material.span, mesh.materials.span);
            self.found.push(errors::two_replacements(object, places.0, places.1));
        }
        !both
    }

    /// Every name in `materials` must be one of the mesh.
    fn check_replacements(&mut self, mesh: &scene::Mesh, obj: &ObjFile) -> bool {
        let names = &obj.mesh.material_names;
        let before = self.found.len();
        for (name, _) in &mesh.materials.value {
            if name.value.is_empty() || !names.contains(&name.value) {
                self.found.push(errors::unknown_material(
                    &mesh.file.text,
                    &name.value,
                    name.span,
                    names,
                ));
            }
        }
        self.found.len() == before
    }

    /// The .mtl files of a mesh. None: one of them could not be read.
    fn libraries(&mut self, mesh: &scene::Mesh, obj: &ObjFile) -> Option<Vec<Rc<MtlFile>>> {
        let mut libraries = Vec::new();
        let mut whole = true;
        if let Some(name) = &mesh.mtl.value {
            let asked = Asked { name: &name.text, path: &name.path, span: mesh.mtl.span };
            return self.library(asked).map(|library| vec![library]);
        }
        for (name, excerpt) in &obj.libraries {
            let shown = files::shown(&mesh.file.path);
            let span = files::place(self.sources, &shown, excerpt);
            let Some(path) = beside(&mesh.file.path, name) else {
                self.found.push(file::outside(&mesh.file.text, name, span, mesh.file.span));
                whole = false;
                continue;
            };
            match self.library(Asked { name, path: &path, span }) {
                Some(library) => libraries.push(library),
                None => whole = false,
            }
        }
        whole.then_some(libraries)
    }

    fn library(&mut self, asked: Asked) -> Option<Rc<MtlFile>> {
        let library = self.shelf.mtl(asked, self.sources, self.found)?;
        let file = StagedFile {
            name: asked.name.to_string(),
            path: asked.path.to_path_buf(),
            span: asked.span,
            bytes: library.bytes,
            triangles: None,
        };
        Used::note(self.used, file, library.digest);
        Some(library)
    }

    /// The texture of a material's map_Kd, if it has one.
    fn map(
        &mut self,
        library: &MtlFile,
        said: &Said,
        field: Span,
    ) -> Result<Option<At<Ref<Texture>>>, Told> {
        let Some(map) = &said.diffuse_map else { return Ok(None) };
        let at = materials::Place { library: library.source };
        let span = at.span(map);
        let Some(path) = beside(&library.path, &map.value.file) else {
            self.found.push(file::outside_picture(&library.name, &map.value.file, span, field));
            return Err(Told);
        };
        let mut name = format!("{} of {}", map.value.file, said.name.value);
        while let Some(known) = self.textures.iter().find(|t| t.texture.name.value == name) {
            if known.texture.value.span == span {
                return Ok(Some(At::new(Ref::new(name), span)));
            }
            name.push('\'');
        }
        let texture = materials::texture(name.clone(), said, map, at, path);
        let mut desk = textures::Desk { shelf: self.shelf, found: self.found, used: self.used };
        self.textures.push(desk.stage(&texture).ok_or(Told)?);
        Ok(Some(At::new(Ref::new(name), span)))
    }

    fn missing_material(
        &mut self,
        object: &str,
        mesh: &scene::Mesh,
        obj: &ObjFile,
        slot: usize,
        libraries: &[Rc<MtlFile>],
    ) {
        let name = &obj.mesh.material_names[slot];
        let excerpt = &obj.slots[slot];
        let at = files::place(self.sources, &files::shown(&mesh.file.path), excerpt);
        let (file, field) = (&mesh.file.text, mesh.file.span);
        self.found.push(if name.is_empty() {
            errors::no_material(object, file, at, field)
        } else {
            let all = libraries.iter().flat_map(|library| &library.library.materials);
            let names: Vec<_> = all.map(|material| material.name.value.as_str()).collect();
            let has_file = mesh.mtl.value.is_some() || !obj.libraries.is_empty();
            errors::missing_material(file, name, has_file.then_some(&names), at, field)
        });
    }
}

fn origin<'s>(scene: &'s Scene, mesh: &scene::Mesh, name: &str) -> Origin<'s> {
    let by_name = || mesh.materials.value.iter().find(|(n, _)| n.value == name && !name.is_empty());
    match (&mesh.material.value, by_name()) {
        (Some(all), _) => Origin::Scene(scene.material(all)),
        (None, Some((_, one))) => Origin::Scene(scene.material(&one.value)),
        (None, None) => Origin::Library,
    }
}

/// The material of that name in the first file that has it.
fn find<'l>(
    libraries: &'l [Rc<MtlFile>],
    name: &str,
) -> Option<(&'l MtlFile, &'l crate::files::mtl::Material)> {
    libraries.iter().find_map(|library| {
        let found = library.library.materials.iter().find(|m| m.name.value == name)?;
        Some((library.as_ref(), found))
    })
}

/// The path of a file that another one names, an .obj or .mtl file; None if it leads out of the folder of the latter.
fn beside(file: &Path, name: &str) -> Option<PathBuf> {
    let name = name.replace('\\', "/");
    let drive = name.as_bytes().get(1) == Some(&b':');
    let inside = |part| matches!(part, Component::Normal(_) | Component::CurDir);
    let path = Path::new(&name);
    let inside = !drive && path.components().all(inside);
    inside.then(|| file.parent().unwrap_or(Path::new("")).join(path))
}

/// Where something of a .mtl file stands, among the sources.
impl materials::Place {
    /// The place of a value.
    pub fn span<T>(self, said: &crate::files::mtl::Said<T>) -> Span {
        Span::new(self.library, said.at.start, said.at.end)
    }
}
