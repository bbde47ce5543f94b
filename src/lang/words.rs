//! The words of the language itself, beside those of its vocabulary: what it is made of, and from
//! which its lists are printed.

/// A word of the grammar.
#[derive(Clone, Copy, Debug)]
pub struct Keyword {
    /// As written.
    pub word: &'static str,
    /// How it stands in a file.
    pub form: &'static str,
    /// What it does, in one sentence.
    pub doc: &'static str,
}

/// A function that needs no definition.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// As called.
    pub word: &'static str,
    /// The names of its arguments, for each number of them it takes; the most usual first.
    pub params: &'static [&'static [&'static str]],
    /// What it gives, in one sentence.
    pub doc: &'static str,
}

/// The words of the grammar; none can be a name.
pub const KEYWORDS: &[Keyword] = &[
    keyword(
        "render",
        "render NAME: BASE + BASE { … }",
        "Asks for a picture: the file's scene, what its bases (setups or renders) state, and its own differences.",
    ),
    keyword(
        "setup",
        "setup NAME: BASE + BASE { … }",
        "A named difference that renders and setups build on; no picture by itself.",
    ),
    keyword(
        "use",
        "use \"lib/box.scn\"",
        "Brings the definitions, declarations and setups of another file.",
    ),
    keyword(
        "let",
        "let NAME = VALUE, or let NAME(ARGUMENT, …) = VALUE",
        "Names a value, or a function.",
    ),
    keyword("for", "for NAME in VALUES { … }", "Repeats items for each value of a list or range."),
    keyword(
        "in",
        "for NAME in VALUES { … }",
        "Stands before the values of a loop; in a file's first line, before the unit of its bare coordinates.",
    ),
    keyword("to", "FIRST to LAST", "A range of numbers, which includes its end."),
    keyword(
        "step",
        "FIRST to LAST step DISTANCE",
        "The distance of a range's numbers, 1 without it.",
    ),
    keyword("without", "without KIND NAME", "Takes a declaration out of a setup or render."),
    keyword("with", "VALUE with { FIELD: VALUE, … }", "A copy of a value with other fields."),
];

/// The functions of the language.
pub const FUNCTIONS: &[Function] = &[
    Function {
        word: "blackbody",
        params: &[&["temperature"]],
        doc: "The light of a black body: its spectral radiance, in W/m^2/sr for each length of wavelength.",
    },
    Function {
        word: "complex",
        params: &[&["n", "k"]],
        doc: "A complex index of refraction n + ik, of numbers, colours or spectra.",
    },
    Function {
        word: "data",
        params: &[&["file"], &["file", "unit"]],
        doc: "A spectrum from a text file: rows of a wavelength and a value, or of a wavelength, n and k. Wavelengths are in nm, or in the unit.",
    },
    Function {
        word: "move",
        params: &[&["x", "y", "z"], &["vector"]],
        doc: "A step of `place` that moves by lengths along the axes.",
    },
    Function { word: "rgb", params: COLOUR, doc: "A colour, linear, with the primaries of sRGB." },
    Function {
        word: "rotate",
        params: &[&["axis", "angle"]],
        doc: "A step of `place` that turns about an axis through the origin, counter-clockwise for one whom the axis points at.",
    },
    Function {
        word: "scale",
        params: &[&["factor"], &["x", "y", "z"]],
        doc: "A step of `place` that stretches from the origin, alike or by a factor for each axis.",
    },
    Function {
        word: "srgb",
        params: COLOUR,
        doc: "A colour as pictures on screens encode it, each component from 0 to 1, decoded to a linear one.",
    },
    Function {
        word: "upsample",
        params: &[&["colour"]],
        doc: "A smooth spectrum of a colour: of a light one of filtered daylight, of anything else one that is no greater than 1 if the colour is not [Jakob19].",
    },
];

const COLOUR: &[&[&str]] = &[&["red", "green", "blue"]];

/// The number that has a name.
pub const PI: &str = "pi";

const fn keyword(word: &'static str, form: &'static str, doc: &'static str) -> Keyword {
    Keyword { word, form, doc }
}

/// Whether a word is one of the grammar's.
pub fn is_keyword(word: &str) -> bool {
    KEYWORDS.iter().any(|keyword| keyword.word == word)
}
