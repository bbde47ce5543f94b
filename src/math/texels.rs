//! The texels of a texture, as its file has them: encoded values, top row first.

/// Texels in rows from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Texels {
    /// Texels a row; not zero.
    pub width: u32,
    /// Rows; not zero.
    pub height: u32,
    /// `width * height` of them.
    pub values: Values,
}

/// Values of texels: grey, or red, green and blue.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Of eight bits.
    Grey8(Vec<u8>),
    /// Of eight bits.
    Rgb8(Vec<[u8; 3]>),
    /// Of sixteen bits.
    Grey16(Vec<u16>),
    /// Of sixteen bits.
    Rgb16(Vec<[u16; 3]>),
    /// Linear, finite and not negative.
    Float(Vec<[f32; 3]>),
}

impl Texels {
    /// The largest of each channel: of floats themselves, else as a part of the largest whole
    /// number that their bits can hold.
    pub fn largest(&self) -> [f64; 3] {
        fn most<T: Copy + PartialOrd + Into<f64>>(all: &[[T; 3]], one: f64) -> [f64; 3] {
            let of = |channel: usize| all.iter().map(move |texel| texel[channel].into());
            std::array::from_fn(|channel| of(channel).fold(0.0, f64::max) / one)
        }
        fn grey<T: Copy + Ord + Into<f64>>(all: &[T], one: f64) -> [f64; 3] {
            [all.iter().max().map_or(0.0, |most| (*most).into()) / one; 3]
        }
        match &self.values {
            Values::Grey8(all) => grey(all, 255.0),
            Values::Grey16(all) => grey(all, 65535.0),
            Values::Rgb8(all) => most(all, 255.0),
            Values::Rgb16(all) => most(all, 65535.0),
            Values::Float(all) => most(all, 1.0),
        }
    }

    /// Memory held, in bytes.
    pub fn bytes(&self) -> usize {
        match &self.values {
            Values::Grey8(all) => all.capacity(),
            Values::Rgb8(all) => all.capacity() * size_of::<[u8; 3]>(),
            Values::Grey16(all) => all.capacity() * size_of::<u16>(),
            Values::Rgb16(all) => all.capacity() * size_of::<[u16; 3]>(),
            Values::Float(all) => all.capacity() * size_of::<[f32; 3]>(),
        }
    }
}
