//! A condition such as `relmse > 0.01`.

use std::fmt;

use crate::diag::near;
use crate::diag::words::did_you_mean;
use crate::measure::{METRICS, Metric};

/// A metric held against a number.
#[derive(Clone, Copy, Debug)]
pub struct Condition {
    pub metric: &'static Metric,
    relation: Relation,
    limit: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Relation {
    Above,
    AtLeast,
    Below,
    AtMost,
}

/// As they are written; the longer ones first, so that each is found whole.
const RELATIONS: [(&str, Relation); 4] = [
    (">=", Relation::AtLeast),
    ("<=", Relation::AtMost),
    (">", Relation::Above),
    ("<", Relation::Below),
];

impl Condition {
    /// From its text; else what is wrong with it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let split = |(sign, relation): &(&str, Relation)| {
            text.split_once(sign).map(|(name, number)| (name.trim(), *relation, number.trim()))
        };
        let Some((name, relation, number)) = RELATIONS.iter().find_map(split) else {
            return Err(
                "write a metric, one of > >= < <=, and a number, such as relmse > 0.01".to_string()
            );
        };
        let metric = METRICS.iter().find(|metric| metric.name == name);
        let metric = metric.ok_or_else(|| unknown(name))?;
        let limit: Option<f64> = number.parse().ok().filter(|limit: &f64| limit.is_finite());
        let limit = limit.ok_or_else(|| format!("`{number}` is no number, such as 0.01"))?;
        Ok(Self { metric, relation, limit })
    }

    /// Whether it holds for a value of its metric.
    pub fn holds(&self, value: f64) -> bool {
        match self.relation {
            Relation::Above => value > self.limit,
            Relation::AtLeast => value >= self.limit,
            Relation::Below => value < self.limit,
            Relation::AtMost => value <= self.limit,
        }
    }
}

fn unknown(name: &str) -> String {
    let all: Vec<_> = METRICS.iter().map(|metric| metric.name).collect();
    let hint = match near(name, all.iter().copied()).as_slice() {
        [] => String::new(),
        names => format!("; {}", did_you_mean(names.iter().copied())),
    };
    format!("there is no metric `{name}`{hint}\nThe metrics are {}.", all.join(", "))
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = RELATIONS.iter().find(|(_, relation)| *relation == self.relation);
        let sign = sign.map_or("", |(sign, _)| sign);
        write!(f, "{} {sign} {}", self.metric.name, self.limit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_relation_has_its_edge() {
        for (text, below, at, above) in [
            ("relmse > 0.5", false, false, true),
            ("relmse>=0.5", false, true, true),
            (" relmse < 5e-1 ", true, false, false),
            ("relmse <= 0.5", true, true, false),
        ] {
            let condition = Condition::parse(text).unwrap();
            assert_eq!(condition.metric.name, "relmse");
            let found = [0.4, 0.5, 0.6].map(|value| condition.holds(value));
            assert_eq!(found, [below, at, above], "{text}");
        }
        assert_eq!(Condition::parse("bias<=-1e-3").unwrap().to_string(), "bias <= -0.001");
    }

    #[test]
    fn what_is_no_condition_is_told() {
        let told = |text| Condition::parse(text).unwrap_err();
        assert!(told("relmse 0.01").starts_with("write a metric, one of > >= < <="));
        assert!(told("").starts_with("write a metric"));
        let unknown = told("rel_mse > 1");
        assert!(unknown.contains("did you mean `relmse`"), "{unknown}");
        assert!(unknown.contains("flip_hdr, ssim."), "{unknown}");
        assert!(told("zebra > 1").starts_with("there is no metric `zebra`\nThe metrics are mse,"));
        assert_eq!(told("mse > much"), "`much` is no number, such as 0.01");
        assert_eq!(told("mse > nan"), "`nan` is no number, such as 0.01");
        assert_eq!(told("mse >"), "`` is no number, such as 0.01");
        assert_eq!(told("mse >> 1"), "`> 1` is no number, such as 0.01");
    }
}
