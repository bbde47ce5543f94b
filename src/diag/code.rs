//! Every fault has a code, `family/what-it-is`, and a page under docs/errors that explains it.

/// The name of a kind of fault. Two codes are equal when their names are.
#[derive(Clone, Copy)]
pub struct Code {
    /// `family/what-it-is`.
    pub name: &'static str,
    /// The page, in Markdown: what it means, an example that is wrong, how it is mended.
    pub page: &'static str,
}

impl Code {
    /// The heading of its page: the fault in a few words.
    pub fn title(&self) -> &'static str {
        self.page.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or("")
    }
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
    FILE_BAD_DATA = "file/bad-data";
    FILE_OUTSIDE_FOLDER = "file/outside-folder";
    FILE_UNREADABLE = "file/unreadable";
    IMPORT_CIRCLE = "import/circle";
    IMPORT_UNREADABLE = "import/unreadable";
    LINT_ALBEDO_ABOVE_ONE = "lint/albedo-above-one";
    LINT_ALLOW_FORM = "lint/allow-form";
    LINT_ALLOW_UNKNOWN = "lint/allow-unknown";
    LINT_ALLOW_UNUSED = "lint/allow-unused";
    LINT_ALLOW_WITHOUT_REASON = "lint/allow-without-reason";
    LINT_CAMERA_INSIDE = "lint/camera-inside";
    LINT_CAMERA_ON_SURFACE = "lint/camera-on-surface";
    LINT_CAMERA_SEES_NOTHING = "lint/camera-sees-nothing";
    LINT_CLEAR_METAL = "lint/clear-metal";
    LINT_COINCIDENT_SURFACES = "lint/coincident-surfaces";
    LINT_COLOUR_CUT = "lint/colour-cut";
    LINT_DARK_LIGHT = "lint/dark-light";
    LINT_EMPTY_LAYER = "lint/empty-layer";
    LINT_EMPTY_PICTURE = "lint/empty-picture";
    LINT_ENCLOSED = "lint/enclosed";
    LINT_EXPOSURE = "lint/exposure";
    LINT_HIDDEN_BY_PLANE = "lint/hidden-by-plane";
    LINT_IGNORED_FIELD = "lint/ignored-field";
    LINT_IMPOSSIBLE_PATH = "lint/impossible-path";
    LINT_INDEX_BELOW_ONE = "lint/index-below-one";
    LINT_INWARD_LAMP = "lint/inward-lamp";
    LINT_LAMP_FACES_AWAY = "lint/lamp-faces-away";
    LINT_LARGE_ERROR = "lint/large-error";
    LINT_LIGHT_BEHIND_PLANE = "lint/light-behind-plane";
    LINT_LIGHT_INSIDE = "lint/light-inside";
    LINT_MANY_TURNS = "lint/many-turns";
    LINT_MISSING_CAPTION = "lint/missing-caption";
    LINT_MIXED_SCALE = "lint/mixed-scale";
    LINT_NAMES_BY_CASE = "lint/names-by-case";
    LINT_NEEDLESS_YIELD = "lint/needless-yield";
    LINT_NOISY_FILTER = "lint/noisy-filter";
    LINT_NON_MANIFOLD = "lint/non-manifold";
    LINT_OUTSIDE_CONTRADICTED = "lint/outside-contradicted";
    LINT_RARE_CAUSTICS = "lint/rare-caustics";
    LINT_SAME_AROUND = "lint/same-around";
    LINT_SAME_CAPTION = "lint/same-caption";
    LINT_SAME_MEDIUM = "lint/same-medium";
    LINT_SAME_PICTURE = "lint/same-picture";
    LINT_SCALE_AFTER_MOVE = "lint/scale-after-move";
    LINT_SHALLOW_DEPTH = "lint/shallow-depth";
    LINT_SKY_ON_ITS_SIDE = "lint/sky-on-its-side";
    LINT_SUSPICIOUS_UNIT = "lint/suspicious-unit";
    LINT_THIN_AIR = "lint/thin-air";
    LINT_TWIN_LIGHTS = "lint/twin-lights";
    LINT_UNFINISHED_ROUND = "lint/unfinished-round";
    LINT_UNREACHABLE_ERROR = "lint/unreachable-error";
    LINT_UNSEEN_LIGHT = "lint/unseen-light";
    LINT_UNUSED_LET = "lint/unused-let";
    LINT_UNUSED_MATERIAL = "lint/unused-material";
    LINT_UNUSED_PARAMETER = "lint/unused-parameter";
    LINT_UNUSED_SETUP = "lint/unused-setup";
    LINT_UNUSED_TEXTURE = "lint/unused-texture";
    LINT_UNUSED_VARIABLE = "lint/unused-variable";
    MATTER_ABSORBS_TWICE = "matter/absorbs-twice";
    MATTER_COINCIDE = "matter/coincide";
    MATTER_CROSS = "matter/cross";
    MATTER_GAP = "matter/gap";
    MATTER_INSIDE_OUT = "matter/inside-out";
    MATTER_NOT_FOLLOWED = "matter/not-followed";
    MATTER_OPEN = "matter/open";
    MATTER_TOO_MANY = "matter/too-many";
    MATTER_TOO_SMALL = "matter/too-small";
    MATTER_TURNED = "matter/turned";
    MATTER_WIDE_MEND = "matter/wide-mend";
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
    MESH_TOO_MUCH = "mesh/too-much";
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
    MTL_NO_INDEX = "mtl/no-index";
    MTL_NO_MIRROR_COLOUR = "mtl/no-mirror-colour";
    MTL_NO_SUCH_MEDIUM = "mtl/no-such-medium";
    MTL_NO_SUCH_METAL = "mtl/no-such-metal";
    MTL_NOT_RENDERED = "mtl/not-rendered";
    MTL_NOT_WAVEFRONT = "mtl/not-wavefront";
    MTL_OTHER_COLOUR = "mtl/other-colour";
    MTL_SAME_NAME = "mtl/same-name";
    MTL_UNKNOWN_STATEMENT = "mtl/unknown-statement";
    MTL_WRONG_COUNT = "mtl/wrong-count";
    NAME_DEFINED_TWICE = "name/defined-twice";
    NAME_DEPENDS_ON_ITSELF = "name/depends-on-itself";
    NAME_FIELD_TWICE = "name/field-twice";
    NAME_MISSING_NAME = "name/missing-name";
    NAME_TAKEN = "name/taken";
    NAME_UNKNOWN_DATUM = "name/unknown-datum";
    NAME_UNKNOWN_DECLARATION = "name/unknown-declaration";
    NAME_UNKNOWN_FIELD = "name/unknown-field";
    NAME_UNKNOWN_FUNCTION = "name/unknown-function";
    NAME_UNKNOWN_KIND = "name/unknown-kind";
    NAME_UNKNOWN_NAME = "name/unknown-name";
    NAME_UNKNOWN_SETUP = "name/unknown-setup";
    NAME_UNKNOWN_UNIT = "name/unknown-unit";
    NAME_UNKNOWN_VARIANT = "name/unknown-variant";
    NAME_UNKNOWN_WORD = "name/unknown-word";
    NAME_UNWANTED_NAME = "name/unwanted-name";
    NAME_WHICH_VARIANT = "name/which-variant";
    PATHS_DEAD_PART = "paths/dead-part";
    PATHS_LAYER_NAME = "paths/layer-name";
    PATHS_NO_PATH = "paths/no-path";
    PATHS_OTHERS_TWICE = "paths/others-twice";
    PATHS_TOO_LARGE = "paths/too-large";
    PATHS_UNREADABLE = "paths/unreadable";
    RENDER_CIRCLE = "render/circle";
    RENDER_CLASH = "render/clash";
    RENDER_DUPLICATE = "render/duplicate";
    RENDER_MISSING_KIND = "render/missing-kind";
    RENDER_NAME = "render/name";
    RENDER_NOTHING_TO_CHANGE = "render/nothing-to-change";
    RENDER_TOO_MUCH = "render/too-much";
    SCENE_BEYOND_NUMBERS = "scene/beyond-numbers";
    SCENE_BIASED = "scene/biased";
    SCENE_CAMERA_LOOKS_ALONG_UP = "scene/camera-looks-along-up";
    SCENE_CAMERA_LOOKS_NOWHERE = "scene/camera-looks-nowhere";
    SCENE_CAMERA_TOO_FAR = "scene/camera-too-far";
    SCENE_CLOSED_LAMP = "scene/closed-lamp";
    SCENE_ENDLESS_LAMP = "scene/endless-lamp";
    SCENE_ENDLESS_PATHS = "scene/endless-paths";
    SCENE_HALF_A_CLOCK = "scene/half-a-clock";
    SCENE_LOST_TRIANGLES = "scene/lost-triangles";
    SCENE_MIXED_INSIDES = "scene/mixed-insides";
    SCENE_MIXED_SIDES = "scene/mixed-sides";
    SCENE_NIGHT = "scene/night";
    SCENE_NO_AREA = "scene/no-area";
    SCENE_NORTH_IS_UP = "scene/north-is-up";
    SCENE_NOTHING_SHINES = "scene/nothing-shines";
    SCENE_NOTHING_TO_SEE = "scene/nothing-to-see";
    SCENE_TOO_BRIGHT = "scene/too-bright";
    SCENE_TOO_MUCH_MEMORY = "scene/too-much-memory";
    SCENE_TOO_SMALL = "scene/too-small";
    SCENE_UNEVEN_SCALE = "scene/uneven-scale";
    SCENE_WIDE_FALLOFF = "scene/wide-falloff";
    SPECTRUM_MIXED = "spectrum/mixed";
    SPECTRUM_NO_INDEX = "spectrum/no-index";
    SPECTRUM_NO_WAVELENGTH = "spectrum/no-wavelength";
    SPECTRUM_NOT_VISIBLE = "spectrum/not-visible";
    SYNTAX_BAD_ESCAPE = "syntax/bad-escape";
    SYNTAX_COLON_OR_EQUALS = "syntax/colon-or-equals";
    SYNTAX_COMMENT = "syntax/comment";
    SYNTAX_EDITION = "syntax/edition";
    SYNTAX_FILE_UNIT = "syntax/file-unit";
    SYNTAX_FIRST_LINE = "syntax/first-line";
    SYNTAX_INTERPOLATION = "syntax/interpolation";
    SYNTAX_KEYWORD_AS_NAME = "syntax/keyword-as-name";
    SYNTAX_MISPLACED = "syntax/misplaced";
    SYNTAX_MISSING_BODY = "syntax/missing-body";
    SYNTAX_MISSING_COLON = "syntax/missing-colon";
    SYNTAX_MISSING_SEPARATOR = "syntax/missing-separator";
    SYNTAX_MISSING_VALUE = "syntax/missing-value";
    SYNTAX_NUMBER_FORM = "syntax/number-form";
    SYNTAX_NUMBER_TOO_LARGE = "syntax/number-too-large";
    SYNTAX_OTHER_PROGRAM = "syntax/other-program";
    SYNTAX_STRAY_BRACKET = "syntax/stray-bracket";
    SYNTAX_TOO_DEEP = "syntax/too-deep";
    SYNTAX_UNCLOSED_BRACKET = "syntax/unclosed-bracket";
    SYNTAX_UNCLOSED_STRING = "syntax/unclosed-string";
    SYNTAX_UNEXPECTED = "syntax/unexpected";
    TEXTURE_FLOAT_ENCODING = "texture/float-encoding";
    TEXTURE_NO_COORDINATES = "texture/no-coordinates";
    TEXTURE_TRANSPARENCY = "texture/transparency";
    TEXTURE_UNREADABLE = "texture/unreadable";
    TYPE_ARGUMENTS = "type/arguments";
    TYPE_EMPTY_RANGE = "type/empty-range";
    TYPE_MISMATCH = "type/mismatch";
    TYPE_MISSING_FIELD = "type/missing-field";
    TYPE_MISSING_UNIT = "type/missing-unit";
    TYPE_NO_ARITHMETIC = "type/no-arithmetic";
    TYPE_NO_FILE_UNIT = "type/no-file-unit";
    TYPE_NO_PARTS = "type/no-parts";
    TYPE_NOT_FINITE = "type/not-finite";
    TYPE_NOT_WHOLE = "type/not-whole";
    TYPE_OUT_OF_RANGE = "type/out-of-range";
    TYPE_TOO_DEEP = "type/too-deep";
    TYPE_VECTOR_SIZE = "type/vector-size";
    TYPE_WRONG_DIMENSION = "type/wrong-dimension";
    TYPE_ZERO_DIRECTION = "type/zero-direction";
}
