//! The simple types of the vocabulary: numbers with dimensions, places, names.

use std::marker::PhantomData;
use std::path::PathBuf;

use glam::{DAffine3, DMat3, DVec3};
use serde::{Serialize, Serializer};

use super::schema::{Checked, Type, Vocabulary, Words, unchecked};
use super::spectral::Spectral;
use super::vocabulary::joined;
use crate::math::units::Dimension;
use crate::math::{Spectrum, Transform};

/// Declares newtypes over f64 or [`Spectrum`]: name, dimension or quantity, doc.
macro_rules! quantities {
    ($($(#[$doc:meta])* $name:ident: $variant:ident($inner:ty), $of:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Serialize)]
        pub struct $name(pub $inner);

        impl Vocabulary for $name {
            const TYPE: Type = Type::$variant($of);

            fn lower(checked: &Checked) -> Self {
                match checked {
                    Checked::$variant(value) => Self(value.clone()),
                    other => unchecked(stringify!($name), other),
                }
            }
        }
    )*};
}

quantities! {
    /// A plain number.
    Number: Number(f64), Dimension::NONE;
    /// A length in metres.
    Length: Number(f64), Dimension::LENGTH;
    /// A time in seconds.
    Time: Number(f64), Dimension::TIME;
    /// An angle in radians.
    Angle: Number(f64), Dimension::ANGLE;
    /// An exposure in stops: +1 doubles.
    Exposure: Number(f64), Dimension::EXPOSURE;
    /// The part of light a surface gives back.
    Reflectance: Spectrum(Spectrum), Spectral::Reflectance;
    /// What happens to light along a way, in 1/m.
    Coefficient: Spectrum(Spectrum), Spectral::Coefficient;
    /// Radiance in W/m²/sr.
    Radiance: Spectrum(Spectrum), Spectral::Radiance;
    /// Irradiance in W/m².
    Irradiance: Spectrum(Spectrum), Spectral::Irradiance;
    /// Intensity in W/sr.
    Intensity: Spectrum(Spectrum), Spectral::Intensity;
    /// Flux in W.
    Flux: Spectrum(Spectrum), Spectral::Flux;
}

/// An index of refraction n + ik.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Index {
    /// How much slower light is than in a vacuum; above 0.
    pub n: Spectrum,
    /// How fast it fades; 0 or more, and 0 where all of it passes.
    pub k: Spectrum,
}

impl Index {
    /// Whether light fades in it, at any wavelength.
    pub fn absorbs(&self) -> bool {
        match &self.k {
            Spectrum::Table(table) => table.bounds().1 > 0.0,
            other => !other.is_zero(),
        }
    }
}

impl Vocabulary for Index {
    const TYPE: Type = Type::Index;

    fn lower(checked: &Checked) -> Self {
        match checked {
            Checked::Index(n, k) => Self { n: n.clone(), k: k.clone() },
            other => unchecked("an index", other),
        }
    }
}

/// Declares newtypes read from one variant of [`Checked`]: name, type, how.
macro_rules! plain {
    ($($(#[$doc:meta])* $name:ident($inner:ty): $ty:ident from $variant:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Serialize)]
        pub struct $name(pub $inner);

        impl Vocabulary for $name {
            const TYPE: Type = Type::$ty;

            fn lower(checked: &Checked) -> Self {
                match checked {
                    Checked::$variant(value) => Self(value.clone()),
                    other => unchecked(stringify!($name), other),
                }
            }
        }
    )*};
}

plain! {
    /// A whole number.
    Count(u64): Count from Count;
    /// `on` or `off`.
    Switch(bool): Switch from Switch;
    /// Words.
    Text(String): Text from Text;
    /// Coordinates in metres.
    Point(DVec3): Point from Vector;
    /// A direction of unit length.
    Direction(DVec3): Direction from Vector;
    /// Columns and rows.
    Size([u64; 2]): Size from Size;
    /// Two plain numbers: for u and for v.
    Pair([f64; 2]): Pair from Pair;
}

/// Declares whole numbers that may also be a word.
macro_rules! count_or {
    ($(#[doc = $doc:literal])+ $Name:ident: $name:literal {
        $(#[doc = $cdoc:literal])+ $Count:ident,
        $(#[doc = $wdoc:literal])+ $word:literal => $Word:ident $(,)?
    }) => {
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
        #[serde(rename_all = "snake_case")]
        pub enum $Name {
            $(#[doc = $cdoc])+
            $Count(u64),
            $(#[doc = $wdoc])+
            $Word,
        }

        impl Vocabulary for $Name {
            const TYPE: Type = Type::CountOr(&Words {
                name: $name,
                doc: joined(concat!($($doc, "\n"),+)),
                all: &[($word, joined(concat!($($wdoc, "\n"),+)))],
            });

            fn lower(checked: &Checked) -> Self {
                match checked {
                    Checked::Count(count) => Self::$Count(*count),
                    Checked::Word(0) => Self::$Word,
                    other => unchecked($name, other),
                }
            }
        }
    };
}

count_or! {
    /// How often something may happen to light on its way.
    Depth: "depth" {
        /// So often at most.
        Most,
        /// As often as it does.
        "unlimited" => Unlimited,
    }
}

impl Depth {
    /// So often at most; None: as often as it does.
    pub fn most(self) -> Option<u64> {
        match self {
            Self::Most(most) => Some(most),
            Self::Unlimited => None,
        }
    }
}

count_or! {
    /// How many lights are asked.
    LightCount: "number of lights" {
        /// So many, chosen by importance.
        Chosen,
        /// Each of them.
        "all" => All,
    }
}

/// A file as the author named it, and where that is.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct FileName {
    /// As written.
    pub text: String,
    /// Joined to the folder of the file whose text names it.
    pub path: PathBuf,
}

impl Serialize for FileName {
    /// As written: a scene stays the same scene in another folder.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.text.serialize(serializer)
    }
}

impl Vocabulary for FileName {
    const TYPE: Type = Type::File;

    fn lower(checked: &Checked) -> Self {
        match checked {
            Checked::File(name) => name.clone(),
            other => unchecked("a file name", other),
        }
    }
}

/// A step of placing something.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Step {
    /// Times these factors along x, y, z.
    Scale(DVec3),
    /// About an axis of unit length through the origin, right-handed, by an angle in radians.
    Rotate(DVec3, f64),
    /// By so many metres.
    Move(DVec3),
}

impl Step {
    /// The step as a map.
    pub fn transform(self) -> Transform {
        Transform(match self {
            Self::Scale(factors) => DAffine3::from_scale(factors),
            Self::Rotate(axis, angle) => DAffine3::from_mat3(quarter_exact(axis, angle)),
            Self::Move(offset) => DAffine3::from_translation(offset),
        })
    }
}

/// A rotation matrix, exact for multiples of a quarter turn, whose sine and cosine are not.
fn quarter_exact(axis: DVec3, angle: f64) -> DMat3 {
    let (mut sin, mut cos) = angle.sin_cos();
    let quarters = angle / std::f64::consts::FRAC_PI_2;
    if (quarters - quarters.round()).abs() < 1e-12 {
        (sin, cos) = (sin.round(), cos.round());
    }
    let (x, y, z, t) = (axis.x, axis.y, axis.z, 1.0 - cos);
    DMat3::from_cols(
        DVec3::new(t * x * x + cos, t * x * y + sin * z, t * x * z - sin * y),
        DVec3::new(t * x * y - sin * z, t * y * y + cos, t * y * z + sin * x),
        DVec3::new(t * x * z + sin * y, t * y * z - sin * x, t * z * z + cos),
    )
}

impl Vocabulary for Step {
    const TYPE: Type = Type::Step;

    fn lower(checked: &Checked) -> Self {
        match checked {
            Checked::Step(step) => *step,
            other => unchecked("a step of a place", other),
        }
    }
}

/// Steps, first to last.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Place(pub Vec<Step>);

impl Place {
    /// All steps as one map.
    pub fn transform(&self) -> Transform {
        self.0.iter().fold(Transform::IDENTITY, |so_far, step| so_far.then(step.transform()))
    }
}

impl Vocabulary for Place {
    const TYPE: Type = Type::List(&Step::TYPE);

    fn lower(checked: &Checked) -> Self {
        match checked {
            Checked::List(all) => Self(all.iter().map(|step| Step::lower(&step.value)).collect()),
            other => unchecked("a place", other),
        }
    }
}

/// The name of a declaration of a kind; it exists.
pub struct Ref<T> {
    /// The name.
    pub name: String,
    of: PhantomData<fn() -> T>,
}

impl<T> Ref<T> {
    /// A reference to the declaration called `name`.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), of: PhantomData }
    }
}

impl<T> Clone for Ref<T> {
    fn clone(&self) -> Self {
        Self::new(self.name.clone())
    }
}

impl<T> std::fmt::Debug for Ref<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Ref({:?})", self.name)
    }
}

impl<T> PartialEq for Ref<T> {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl<T> Serialize for Ref<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.name.serialize(serializer)
    }
}

impl<T: super::whole::KindOf + Vocabulary> Vocabulary for Ref<T> {
    const TYPE: Type = Type::Reference { kind: T::WORD, target: Some(|| T::TYPE) };

    fn lower(checked: &Checked) -> Self {
        match checked {
            Checked::Reference(name) => Self::new(name.clone()),
            other => unchecked("a reference", other),
        }
    }
}

/// The name of a declaration; nothing else stands for it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(transparent)]
pub struct NameOf<T>(pub Ref<T>);

impl<T: super::whole::KindOf> Vocabulary for NameOf<T> {
    const TYPE: Type = Type::Reference { kind: T::WORD, target: None };

    fn lower(checked: &Checked) -> Self {
        match checked {
            Checked::Reference(name) => Self(Ref::new(name.clone())),
            other => unchecked("a name", other),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        let turn = Step::Rotate(DVec3::Y, std::f64::consts::FRAC_PI_2).transform();
        assert_eq!(turn.point(DVec3::X), DVec3::NEG_Z);
        let half = Step::Rotate(DVec3::Z, std::f64::consts::PI).transform();
        assert_eq!(half.point(DVec3::new(1.0, 2.0, 3.0)), DVec3::new(-1.0, -2.0, 3.0));
    }

    #[test]
    fn steps_go_first_to_last() {
        let steps = [Step::Scale(DVec3::splat(2.0)), Step::Move(DVec3::X)];
        assert_eq!(Place(steps.to_vec()).transform().point(DVec3::X), DVec3::new(3.0, 0.0, 0.0));
    }
}
