//! Linear colour with the primaries of sRGB (ITU-R BT.709, white D65).

use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Sub};

use serde::Serialize;

/// Three linear components; what they measure is said where they stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Rgb {
    /// Red.
    pub r: f32,
    /// Green.
    pub g: f32,
    /// Blue.
    pub b: f32,
}

impl Rgb {
    /// Nothing.
    pub const BLACK: Self = Self::new(0.0, 0.0, 0.0);
    /// One in every component.
    pub const ONE: Self = Self::new(1.0, 1.0, 1.0);

    /// From its components.
    #[inline]
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        Self { r, g, b }
    }

    /// The same in every component.
    #[inline]
    pub const fn grey(value: f32) -> Self {
        Self::new(value, value, value)
    }

    /// Whether every component is zero.
    #[inline]
    pub fn is_black(self) -> bool {
        // Without jumps.
        (self.r == 0.0) & (self.g == 0.0) & (self.b == 0.0)
    }

    /// Whether no component is infinite or not a number.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.r.is_finite() && self.g.is_finite() && self.b.is_finite()
    }

    /// Relative luminance: Y of ITU-R BT.709.
    #[inline]
    pub fn luminance(self) -> f32 {
        0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b
    }

    /// The mean of the three.
    #[inline]
    pub fn mean(self) -> f32 {
        (self.r + self.g + self.b) / 3.0
    }

    /// The largest of the three.
    #[inline]
    pub fn largest(self) -> f32 {
        self.r.max(self.g).max(self.b)
    }

    /// Red, green, blue.
    #[inline]
    pub fn to_array(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }
}

impl Add for Rgb {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.r + o.r, self.g + o.g, self.b + o.b)
    }
}

impl AddAssign for Rgb {
    #[inline]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl Sub for Rgb {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.r - o.r, self.g - o.g, self.b - o.b)
    }
}

impl Mul for Rgb {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self::new(self.r * o.r, self.g * o.g, self.b * o.b)
    }
}

impl Mul<f32> for Rgb {
    type Output = Self;
    #[inline]
    fn mul(self, k: f32) -> Self {
        Self::new(self.r * k, self.g * k, self.b * k)
    }
}

impl MulAssign for Rgb {
    #[inline]
    fn mul_assign(&mut self, o: Self) {
        *self = *self * o;
    }
}

impl Div<f32> for Rgb {
    type Output = Self;
    #[inline]
    fn div(self, k: f32) -> Self {
        Self::new(self.r / k, self.g / k, self.b / k)
    }
}
