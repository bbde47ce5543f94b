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
    SYNTAX_UNEXPECTED = "syntax/unexpected";
}
