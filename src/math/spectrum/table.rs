//! Values at wavelengths: straight lines between, constant beyond the first and the last.

use std::sync::Arc;

use serde::{Serialize, Serializer};

/// At least one pair of wavelength in nm and value; wavelengths rise.
#[derive(Clone, Debug, PartialEq)]
pub struct Table(Arc<[(f64, f64)]>);

impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.as_ref().serialize(serializer)
    }
}

impl Table {
    /// None if there is no pair, if wavelengths do not rise, or one is not finite.
    pub fn new(nodes: Vec<(f64, f64)>) -> Option<Self> {
        let rise = nodes.windows(2).all(|pair| pair[0].0 < pair[1].0);
        let finite = nodes.iter().all(|(nm, _)| nm.is_finite());
        (!nodes.is_empty() && rise && finite).then(|| Self(nodes.into()))
    }

    /// The pairs.
    pub fn nodes(&self) -> &[(f64, f64)] {
        &self.0
    }

    /// The value at a wavelength in nm.
    pub fn at(&self, nm: f64) -> f64 {
        let after = self.0.partition_point(|(x, _)| *x <= nm);
        match (after.checked_sub(1), self.0.get(after)) {
            (None, _) => self.0[0].1,
            (Some(last), None) => self.0[last].1,
            (Some(before), Some((x1, y1))) => {
                let (x0, y0) = self.0[before];
                let t = (nm - x0) / (x1 - x0);
                (1.0 - t) * y0 + t * y1
            }
        }
    }

    /// The table of `f` of each value.
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        Self(self.0.iter().map(|(nm, value)| (*nm, f(*value))).collect())
    }

    /// The table of `f` of both values, at the wavelengths of both: exact there, and everywhere
    /// where `f` is a sum. Between them, products are straight lines like everything else.
    pub fn with(&self, other: &Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let nm = union(&[self, other]);
        Self(nm.into_iter().map(|nm| (nm, f(self.at(nm), other.at(nm)))).collect())
    }

    /// The least and the greatest value.
    pub fn bounds(&self) -> (f64, f64) {
        let values = || self.0.iter().map(|(_, value)| *value);
        (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max))
    }
}

/// The wavelengths of several tables, rising, each once.
pub fn union(tables: &[&Table]) -> Vec<f64> {
    let all = tables.iter().flat_map(|table| table.nodes());
    let mut nm: Vec<f64> = all.map(|(nm, _)| *nm).collect();
    nm.sort_unstable_by(f64::total_cmp);
    nm.dedup();
    nm
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(nodes: &[(f64, f64)]) -> Table {
        Table::new(nodes.to_vec()).unwrap()
    }

    #[test]
    fn lines_between_and_constant_beyond() {
        let table = table(&[(400.0, 1.0), (500.0, 3.0), (600.0, 0.0)]);
        let values = [300.0, 400.0, 450.0, 500.0, 590.0, 600.0, 900.0].map(|nm| table.at(nm));
        assert!((values[4] - 0.3).abs() < 1e-15);
        assert_eq!([values[0], values[1], values[2], values[3]], [1.0, 1.0, 2.0, 3.0]);
        assert_eq!([values[5], values[6]], [0.0, 0.0]);
        assert_eq!(table.bounds(), (0.0, 3.0));
    }

    #[test]
    fn sums_are_exact_everywhere_and_products_at_the_nodes_of_both() {
        let a = table(&[(400.0, 1.0), (600.0, 3.0)]);
        let b = table(&[(450.0, 10.0), (500.0, 20.0), (700.0, 0.0)]);
        let sum = a.with(&b, |x, y| x + y);
        let product = a.with(&b, |x, y| x * y);
        assert_eq!(sum.nodes().len(), 5);
        for nm in (350..750).map(f64::from) {
            assert!((sum.at(nm) - a.at(nm) - b.at(nm)).abs() < 1e-12, "{nm}");
        }
        for (nm, value) in product.nodes() {
            assert_eq!(*value, a.at(*nm) * b.at(*nm));
        }
    }

    #[test]
    fn a_table_has_pairs_whose_wavelengths_rise() {
        assert!(Table::new(vec![]).is_none());
        assert!(Table::new(vec![(400.0, 1.0), (400.0, 2.0)]).is_none());
        assert!(Table::new(vec![(f64::NAN, 1.0)]).is_none());
        let text = serde_json::to_string(&table(&[(400.0, 1.0), (500.5, 2.0)])).unwrap();
        assert_eq!(text, "[[400.0,1.0],[500.5,2.0]]");
    }
}
