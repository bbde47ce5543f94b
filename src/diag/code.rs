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
    SCENE_BEYOND_NUMBERS = "scene/beyond-numbers";
    SCENE_CAMERA_LOOKS_ALONG_UP = "scene/camera-looks-along-up";
    SCENE_CAMERA_LOOKS_NOWHERE = "scene/camera-looks-nowhere";
    SCENE_CAMERA_TOO_FAR = "scene/camera-too-far";
    SCENE_CLOSED_LAMP = "scene/closed-lamp";
    SCENE_ENDLESS_LAMP = "scene/endless-lamp";
    SCENE_FILM_TOO_LARGE = "scene/film-too-large";
    SCENE_FLAT_PLACE = "scene/flat-place";
    SCENE_LOST_TRIANGLES = "scene/lost-triangles";
    SCENE_NO_AREA = "scene/no-area";
    SCENE_NOTHING_SHINES = "scene/nothing-shines";
    SCENE_NOTHING_TO_SEE = "scene/nothing-to-see";
    SCENE_PLANE_TOO_FAR = "scene/plane-too-far";
    SCENE_TOO_BRIGHT = "scene/too-bright";
    SCENE_TOO_MANY_TRIANGLES = "scene/too-many-triangles";
    SCENE_TOO_SMALL = "scene/too-small";
    SCENE_UNEVEN_SCALE = "scene/uneven-scale";
    SYNTAX_UNEXPECTED = "syntax/unexpected";
}
