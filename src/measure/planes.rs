//! One channel of a picture in f32, and separable filters over it. Beyond the border stands the
//! nearest pixel.

/// `width` × `height` numbers, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// Numbers a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// `width * height` numbers.
    pub values: Vec<f32>,
}

impl Plane {
    /// Zero everywhere.
    pub(super) fn zero(width: usize, height: usize) -> Self {
        Self { width, height, values: vec![0.0; width * height] }
    }

    /// The mean, summed in f64; NaN of no numbers.
    pub fn mean(&self) -> f64 {
        self.values.iter().map(|&v| f64::from(v)).sum::<f64>() / self.values.len() as f64
    }

    /// Correlates with `along` in x and then with `down` in y; both odd in length, centre in the
    /// middle.
    pub(super) fn filtered(&self, along: &[f32], down: &[f32]) -> Self {
        self.filtered_along(along).filtered_down(down)
    }

    /// Correlates every row with `weights`.
    pub(super) fn filtered_along(&self, weights: &[f32]) -> Self {
        let mut out = Self::zero(self.width, self.height);
        if self.values.is_empty() {
            return out;
        }
        let reach = weights.len() / 2;
        let mut padded = vec![0.0; self.width + 2 * reach];
        let rows = self.values.chunks_exact(self.width);
        for (row, sums) in rows.zip(out.values.chunks_exact_mut(self.width)) {
            padded[..reach].fill(row[0]);
            padded[reach..reach + self.width].copy_from_slice(row);
            padded[reach + self.width..].fill(row[self.width - 1]);
            for (i, &weight) in weights.iter().enumerate() {
                add_scaled(sums, &padded[i..i + self.width], weight);
            }
        }
        out
    }

    /// Correlates every column with `weights`.
    pub(super) fn filtered_down(&self, weights: &[f32]) -> Self {
        let mut out = Self::zero(self.width, self.height);
        if self.values.is_empty() {
            return out;
        }
        let reach = weights.len() / 2;
        for (y, sums) in out.values.chunks_exact_mut(self.width).enumerate() {
            for (i, &weight) in weights.iter().enumerate() {
                let from = (y + i).saturating_sub(reach).min(self.height - 1);
                add_scaled(sums, &self.values[from * self.width..][..self.width], weight);
            }
        }
        out
    }
}

/// `sums` + `weight` · `values`, element by element.
fn add_scaled(sums: &mut [f32], values: &[f32], weight: f32) {
    for (sum, value) in sums.iter_mut().zip(values) {
        *sum += weight * value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn filters_are_correlations_with_repeated_borders() {
        let plane = Plane { width: 3, height: 2, values: vec![1.0, 2.0, 4.0, 10.0, 20.0, 40.0] };
        let along = plane.filtered_along(&[-1.0, 0.0, 1.0]);
        assert_eq!(along.values, [1.0, 3.0, 2.0, 10.0, 30.0, 20.0]);
        let down = plane.filtered_down(&[0.25, 0.5, 0.25]);
        assert_eq!(down.values, [3.25, 6.5, 13.0, 7.75, 15.5, 31.0]);
        let both = plane.filtered(&[0.0, 0.0, 1.0], &[1.0, 0.0, 0.0]);
        assert_eq!(both.values, [2.0, 4.0, 4.0, 2.0, 4.0, 4.0]);
    }

    #[test]
    fn a_filter_may_be_wider_than_the_plane() {
        let plane = Plane { width: 1, height: 1, values: vec![3.0] };
        assert_eq!(plane.filtered(&[0.2; 5], &[0.2; 5]).values.len(), 1);
        assert!((plane.filtered(&[0.2; 5], &[0.2; 5]).values[0] - 3.0).abs() < 1e-6);
        assert!(Plane::zero(0, 4).filtered(&[1.0], &[1.0]).values.is_empty());
    }

    #[test]
    fn the_mean_is_summed_in_f64() {
        let plane = Plane { width: 5000, height: 4000, values: vec![0.5; 20_000_000] };
        assert_eq!(plane.mean(), 0.5);
    }
}
