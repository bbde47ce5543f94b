//! Whether an estimate agrees with a truth: close enough, and sharp enough to have noticed.

use std::fmt;

/// A standard error may be at most this part of the tolerance: a difference of the whole
/// tolerance is then at least four standard errors, so no test passes by its own noise.
const SHARPNESS: f64 = 0.25;

/// What was compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures {
    /// The estimate.
    pub mean: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// What it should be.
    pub truth: f64,
    /// How far off it may be, in the unit of the mean.
    pub tolerance: f64,
}

/// Whether an estimate agrees with a truth; printed, it tells its figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// Within the tolerance, and sharp enough to be believed.
    Agrees(Figures),
    /// Further from the truth than the tolerance, or not a number.
    Differs(Figures),
    /// The standard error exceeds a quarter of the tolerance: nothing is shown either way.
    TooNoisy(Figures),
}

impl Verdict {
    /// Whether the estimate agrees: `assert!(verdict.holds(), "{verdict}")`.
    pub fn holds(&self) -> bool {
        matches!(self, Self::Agrees(_))
    }
}

/// Judges `mean` ± `standard_error` against `truth`, all in one unit. `tolerance` is absolute:
/// for 0.3 % write `0.003 * truth`. The standard error should come from at least 16 independent
/// batches. A verdict of too much noise comes before one of difference.
pub fn agrees(mean: f64, standard_error: f64, truth: f64, tolerance: f64) -> Verdict {
    let figures = Figures { mean, standard_error, truth, tolerance };
    let sharp = (0.0..=SHARPNESS * tolerance).contains(&standard_error);
    if !mean.is_finite() {
        Verdict::Differs(figures)
    } else if !sharp {
        Verdict::TooNoisy(figures)
    } else if (mean - truth).abs() <= tolerance {
        Verdict::Agrees(figures)
    } else {
        Verdict::Differs(figures)
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (Self::Agrees(it) | Self::Differs(it) | Self::TooNoisy(it)) = self;
        let Figures { mean, standard_error, truth, tolerance } = it;
        match self {
            Self::Agrees(_) => {
                write!(f, "{mean} agrees with {truth}")?;
            }
            Self::Differs(_) if mean.is_finite() => {
                write!(f, "{mean} differs from {truth}")?;
            }
            Self::Differs(_) => return write!(f, "{mean} is no estimate of {truth}"),
            Self::TooNoisy(_) => {
                return write!(
                    f,
                    "{mean} cannot be told from {truth}: its standard error {standard_error:.3e} \
                     exceeds a quarter of the tolerance {tolerance:.3e}; take more samples"
                );
            }
        }
        let off = mean - truth;
        write!(f, ": off by {off:+.3e}")?;
        if *truth != 0.0 {
            write!(f, " ({:+.4} %)", 100.0 * off / truth)?;
        }
        if *standard_error > 0.0 {
            write!(
                f,
                ", {:.1} standard errors of {standard_error:.3e}",
                off.abs() / standard_error
            )?;
        } else {
            write!(f, ", standard error 0")?;
        }
        write!(f, "; allowed {tolerance:.3e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn close_and_sharp_agrees() {
        assert!(agrees(1.002, 0.0005, 1.0, 0.003).holds());
        assert!(agrees(0.998, 0.0, 1.0, 0.003).holds());
        assert!(agrees(-2.0, 0.0, -2.0, 0.001).holds());
    }

    #[test]
    fn close_but_noisy_does_not() {
        let verdict = agrees(1.0, 0.001, 1.0, 0.003);
        assert!(matches!(verdict, Verdict::TooNoisy(_)), "{verdict}");
        assert_eq!(
            verdict.to_string(),
            "1 cannot be told from 1: its standard error 1.000e-3 exceeds a quarter of the \
             tolerance 3.000e-3; take more samples"
        );
        for unusable in [f64::NAN, f64::INFINITY, -1.0] {
            assert!(matches!(agrees(1.0, unusable, 1.0, 0.003), Verdict::TooNoisy(_)));
        }
        assert!(!agrees(1.0, 0.0, 1.0, f64::NAN).holds());
    }

    #[test]
    fn sharp_but_off_differs_and_tells_its_figures() {
        let verdict = agrees(1.006, 0.0005, 1.0, 0.003);
        assert!(matches!(verdict, Verdict::Differs(_)));
        assert_eq!(
            verdict.to_string(),
            "1.006 differs from 1: off by +6.000e-3 (+0.6000 %), 12.0 standard errors of \
             5.000e-4; allowed 3.000e-3"
        );
    }

    #[test]
    fn what_is_not_a_number_never_agrees() {
        for bad in [f64::NAN, f64::INFINITY] {
            let verdict = agrees(bad, 0.0, 1.0, 0.003);
            assert!(matches!(verdict, Verdict::Differs(_)), "{verdict}");
        }
    }
}
