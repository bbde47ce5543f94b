//! What makes a picture systematically wrong: told beside it with an estimate, or refused.

use serde::{Deserialize, Serialize};

use super::options::Force;
use crate::diag::words::counted;
use crate::diag::{Diagnostic, Sources, Span};
use crate::load::Stage;
use crate::plan::{self, Bias, Plan};
use crate::prepare::{self, ObjectNote, Prepared};
use crate::run::{self, Outcome, Watch};

/// What a stage requires, or everything there is.
pub fn plan(stage: &Stage, force: Option<Force>) -> Plan {
    let plan = Plan::of(stage);
    match force {
        Some(Force::All) => plan.forced(),
        None => plan,
    }
}

/// What `--unbiased` refuses.
pub fn refused(stage: &Stage) -> Vec<Diagnostic> {
    let all = plan::biases(stage);
    all.iter().filter(|bias| !bias.kind.is_noise()).map(plan::errors::biased).collect()
}

/// Something that makes a picture systematically wrong, for people and machines. What is not known
/// is None.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Told {
    /// What it is, in a word.
    pub bias: String,
    /// The setting, as in a text.
    pub setting: String,
    /// What it does.
    pub effect: String,
    /// The same in a few words.
    pub brief: String,
    /// The text in which the setting stands.
    pub file: Option<String>,
    /// Its line there, from 1.
    pub line: Option<usize>,
    /// The largest part that can be missing of the light that all surfaces scatter together.
    pub bound: Option<f64>,
    /// How much brighter the mean of the picture is for it, in parts of what it would be.
    pub difference: Option<f64>,
    /// Its standard error.
    pub standard_error: Option<f64>,
    /// Samples of each of the two pictures that were compared.
    pub samples: Option<u64>,
}

/// The biases of a stage.
pub fn told(stage: &Stage) -> Vec<Told> {
    plan::biases(stage).iter().map(Told::new).collect()
}

/// The same with their places, and what they cost where it can be measured: by short renders with
/// the setting and without it, of about so many samples each.
pub fn measured(
    stage: &Stage,
    prepared: &mut Prepared,
    samples: u64,
    sources: &Sources,
    watch: &dyn Watch,
) -> Vec<Told> {
    let one = |bias: &Bias| {
        let mut told = Told::new(bias);
        let (name, line) = place(sources, bias.at);
        (told.file, told.line) = (Some(name), Some(line));
        if let Some(instead) = &bias.instead {
            let instead = prepare::other_integrator(stage, prepared, instead);
            let Prepared { world, integrator, .. } = &mut *prepared;
            let found = run::difference(world, integrator, &instead, samples, watch);
            told.difference = found.map(|found| found.relative);
            told.standard_error = found.map(|found| found.standard_error);
            told.samples = found.map(|found| found.samples);
        }
        told
    };
    plan::biases(stage).iter().map(one).collect()
}

/// The name and line of a place.
pub fn place(sources: &Sources, span: Span) -> (String, usize) {
    (sources.get(span.file).name.to_string(), sources.line_column(span).0)
}

/// An object with its place, in words.
pub fn object(sources: &Sources, object: &ObjectNote) -> String {
    let (file, line) = place(sources, object.span);
    format!("object `{}` ({file}:{line})", object.name)
}

/// What only the samples told: what they could not hold.
pub fn of_outcome(outcome: &Outcome) -> Vec<Told> {
    let pixels = |n: u64| counted(n, "pixel");
    let clipped = (outcome.clipped > 0).then(|| {
        let brief = "clipped at the largest number, and too dark";
        Told::plain("clipped", pixels(outcome.clipped), brief)
    });
    let invalid = outcome.invalid.map(|invalid| {
        let brief = "not finite, and counted as black";
        Told::plain("not_finite", counted(invalid.count, "sample"), brief)
    });
    clipped.into_iter().chain(invalid).collect()
}

impl Told {
    fn new(bias: &Bias) -> Self {
        let plain = Self::plain(bias.kind.word(), bias.setting.clone(), &bias.brief);
        Self { effect: bias.effect.clone(), bound: bias.bound, ..plain }
    }

    fn plain(bias: &str, setting: String, brief: &str) -> Self {
        Self {
            bias: bias.to_string(),
            setting,
            effect: brief.to_string(),
            brief: brief.to_string(),
            file: None,
            line: None,
            bound: None,
            difference: None,
            standard_error: None,
            samples: None,
        }
    }

    /// In one line: the setting, its place, and what it costs.
    pub fn line(&self) -> String {
        let at = match (&self.file, self.line) {
            (Some(file), Some(line)) => format!(" ({file}:{line})"),
            _ => String::new(),
        };
        format!("{}{at}: {}", self.setting, self.cost())
    }

    /// What it costs: measured, or what it does.
    fn cost(&self) -> String {
        let (Some(difference), Some(error)) = (self.difference, self.standard_error) else {
            return self.brief.clone();
        };
        if difference == 0.0 && error == 0.0 {
            return format!("{}; here that changes nothing", self.brief);
        }
        let way = if difference < 0.0 { "dark" } else { "bright" };
        let (much, error) = (100.0 * difference.abs(), 100.0 * error);
        // To the first digit that is in doubt, or two if it is a small one.
        let digits = (1.5 - error.max(1e-9).log10()).floor().clamp(0.0, 9.0) as usize;
        format!("on average {much:.digits$} % ± {error:.digits$} % too {way}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_is_told_with_its_place() {
        let mut sources = Sources::new();
        let file = sources.add("a.scn", "scn 1\n\nobject ball: sphere {}\n");
        let span = Span::new(file, 14, 18);
        let note = ObjectNote { name: "ball".into(), span, triangles: 0, bytes: 0 };
        assert_eq!(object(&sources, &note), "object `ball` (a.scn:3)");
    }

    #[test]
    fn costs_are_told_in_a_line() {
        let mut told = Told::plain("no_shadows", "`shadows: off`".into(), "nothing is hidden");
        assert_eq!(told.line(), "`shadows: off`: nothing is hidden");
        (told.file, told.line) = (Some("a.scn".into()), Some(7));
        (told.difference, told.standard_error) = (Some(0.1234), Some(0.002));
        assert_eq!(told.line(), "`shadows: off` (a.scn:7): on average 12.34 % ± 0.20 % too bright");
        told.difference = Some(-0.5);
        assert!(told.line().ends_with("on average 50.00 % ± 0.20 % too dark"));
        (told.difference, told.standard_error) = (Some(0.0), Some(0.0));
        assert!(told.line().ends_with("nothing is hidden; here that changes nothing"));
    }
}
