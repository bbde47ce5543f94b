//! Every fault has a code, `family/what-it-is`, and a page under docs/errors that explains it.

/// The name of a kind of fault. Two codes are equal when their names are.
#[derive(Clone, Copy)]
pub struct Code {
    /// `family/what-it-is`.
    pub name: &'static str,
    /// The page, in Markdown: what it means, an example that is wrong, how it is mended.
    pub page: &'static str,
}

impl PartialEq for Code {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Code {}

impl std::hash::Hash for Code {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}

impl std::fmt::Debug for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

impl std::fmt::Display for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// Looks a code up by its name.
pub fn find(name: &str) -> Option<Code> {
    CODES.iter().copied().find(|code| code.name == name)
}

macro_rules! codes {
    ($($constant:ident = $name:literal;)*) => {
        impl Code {
            $(
                #[doc = concat!("See docs/errors/", $name, ".md.")]
                pub const $constant: Code = Code {
                    name: $name,
                    page: include_str!(concat!("../../docs/errors/", $name, ".md")),
                };
            )*
        }

        /// Every code, in the order of their names.
        pub static CODES: &[Code] = &[$(Code::$constant,)*];
    };
}

// One line a fault, alphabetical. A page that is missing does not compile.
codes! {
    FILE_OUTSIDE_FOLDER = "file/outside-folder";
    FILE_UNREADABLE = "file/unreadable";
    MESH_BAD_INDEX = "mesh/bad-index";
    MESH_BAD_NUMBER = "mesh/bad-number";
    MESH_CONCAVE_FACE = "mesh/concave-face";
    MESH_DEGENERATE_TRIANGLES = "mesh/degenerate-triangles";
    MESH_MISSING_MATERIAL = "mesh/missing-material";
    MESH_MISSING_NAME = "mesh/missing-name";
    MESH_MIXED_NORMALS = "mesh/mixed-normals";
    MESH_NO_FACES = "mesh/no-faces";
    MESH_NO_MATERIAL = "mesh/no-material";
    MESH_NOT_RENDERED = "mesh/not-rendered";
    MESH_NOT_WAVEFRONT = "mesh/not-wavefront";
    MESH_REPEATED_TRIANGLES = "mesh/repeated-triangles";
    MESH_SMOOTHING_GROUP = "mesh/smoothing-group";
    MESH_TOO_FEW_CORNERS = "mesh/too-few-corners";
    MESH_TOO_FEW_NUMBERS = "mesh/too-few-numbers";
    MESH_TOO_MANY_NAMES = "mesh/too-many-names";
    MESH_TWO_REPLACEMENTS = "mesh/two-replacements";
    MESH_UNKNOWN_MATERIAL = "mesh/unknown-material";
    MESH_UNKNOWN_STATEMENT = "mesh/unknown-statement";
    MESH_ZERO_NORMAL = "mesh/zero-normal";
    MTL_ABOVE_ONE = "mtl/above-one";
    MTL_AMBIENT = "mtl/ambient";
    MTL_BAD_ILLUM = "mtl/bad-illum";
    MTL_BAD_NUMBER = "mtl/bad-number";
    MTL_BEFORE_NEWMTL = "mtl/before-newmtl";
    MTL_MISSING_NAME = "mtl/missing-name";
    MTL_NEGATIVE = "mtl/negative";
    MTL_NO_COLOUR = "mtl/no-colour";
    MTL_NOT_RENDERED = "mtl/not-rendered";
    MTL_NOT_WAVEFRONT = "mtl/not-wavefront";
    MTL_OTHER_COLOUR = "mtl/other-colour";
    MTL_SAME_NAME = "mtl/same-name";
    MTL_UNKNOWN_STATEMENT = "mtl/unknown-statement";
    MTL_WRONG_COUNT = "mtl/wrong-count";
    SCENE_BEYOND_NUMBERS = "scene/beyond-numbers";
    SCENE_CAMERA_LOOKS_ALONG_UP = "scene/camera-looks-along-up";
    SCENE_CAMERA_LOOKS_NOWHERE = "scene/camera-looks-nowhere";
    SCENE_CAMERA_TOO_FAR = "scene/camera-too-far";
    SCENE_CLOSED_LAMP = "scene/closed-lamp";
    SCENE_ENDLESS_LAMP = "scene/endless-lamp";
    SCENE_FLAT_PLACE = "scene/flat-place";
    SCENE_LOST_TRIANGLES = "scene/lost-triangles";
    SCENE_NO_AREA = "scene/no-area";
    SCENE_NOTHING_SHINES = "scene/nothing-shines";
    SCENE_NOTHING_TO_SEE = "scene/nothing-to-see";
    SCENE_TOO_BRIGHT = "scene/too-bright";
    SCENE_TOO_MUCH_MEMORY = "scene/too-much-memory";
    SCENE_TOO_SMALL = "scene/too-small";
    SCENE_UNEVEN_SCALE = "scene/uneven-scale";
    SYNTAX_UNEXPECTED = "syntax/unexpected";
}
