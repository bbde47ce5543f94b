//! What can be asked of the command line, by clap.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

/// A scene language, its compiler, and the physically based renderer behind it.
#[derive(Parser, Debug)]
#[command(name = "scn", version, max_term_width = 100, subcommand_required = true)]
#[command(arg_required_else_help = true)]
#[command(after_help = "\
Examples:
  scn new my                                  a small scene to begin with, in my.scn
  scn render scenes/w01_first_pictures.scn    every render of the file, into out/
  scn plan my.scn                             what that takes, and how right it is
  scn paths my.scn --pixel 120,80             the paths of light through a pixel
  scn lint my.scn                             what is wrong with it
  scn fmt my.scn                              lay it out in the one style there is
  scn merge fig.*.part -o fig.exr             the picture of a render made in parts
  scn compare a.exr reference.exr             how far a picture is from another
  scn list material                           what the language has to offer
  scn explain type/mismatch                   what a fault means, and how it is mended

Exit status: 0 well; 1 the scene, or a file it names, has errors, or what compare or fmt was
asked to look for holds; 2 the tool could not do its work (options, the scene file itself, the
disk); 130 interrupted.")]
pub struct Options {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand, Debug)]
pub enum Command {
    Render(Render),
    Plan(super::plan::Plan),
    Paths(super::paths::Paths),
    Lint(super::lint::Lint),
    Fmt(Fmt),
    Merge(super::merge::Merge),
    Compare(super::compare::Compare),
    Explain(Explain),
    List(List),
    New(New),
    Completions(Completions),
    Man(Man),
}

/// Render the pictures a scene file asks for
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Examples:
  scn render my.scn                             every render, into out/my/
  scn render my.scn --only fig02 -o fig02.png   one of them, into one file
  scn render my.scn --samples 4 --scale 0.25    a quick look
  scn render my.scn --set 'film.exposure=1 ev' --set 'camera.look=x'

Without -o each render NAME becomes out/<scene file's name>/NAME.exr (linear light) and NAME.png
(as the film's exposure shows it). Ctrl-C writes what is done so far; a second one ends at once.")]
pub struct Render {
    /// The scene file
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Render this one alone; may be given more than once
    #[arg(long, value_name = "NAME")]
    pub only: Vec<String>,
    /// Where pictures go: a folder, or for a single render a file ending in .exr or .png
    #[arg(short, long, value_name = "DIR | FILE.exr | FILE.png")]
    pub output: Option<PathBuf>,
    /// Stop after so many samples of each pixel; in place of the scene's limits, as are --time and
    /// --error
    #[arg(long, value_name = "N", value_parser = samples, allow_negative_numbers = true)]
    pub samples: Option<u64>,
    /// Stop after so much time of rendering, such as `90s` or `5 min`
    #[arg(long, value_name = "TIME", value_parser = time, allow_negative_numbers = true)]
    pub time: Option<f64>,
    /// Stop when the relative error is, with 95 % confidence, at most so much, such as `1%`
    #[arg(long, value_name = "PART", value_parser = error, allow_negative_numbers = true)]
    pub error: Option<f64>,
    /// Chooses all random numbers; the same seed gives the same picture
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = seed, allow_negative_numbers = true)]
    pub seed: u64,
    /// Threads to compute with; one for each processor without it, eight for each at most. Changes no
    /// bit of the picture
    #[arg(long, value_name = "N", value_parser = threads, allow_negative_numbers = true)]
    pub threads: Option<u64>,
    /// Factor on the picture's width and height
    #[arg(long, value_name = "F", default_value_t = 1.0, value_parser = scale, allow_negative_numbers = true)]
    pub scale: f64,
    /// Render these pixels alone: columns x0 to x1, rows y0 to y1 from the top, ends not included;
    /// in pixels of the scaled picture
    #[arg(long, value_name = "x0,y0,x1,y1", value_parser = crop)]
    pub crop: Option<[u64; 4]>,
    /// Change the scene, as if written last in every render asked for; may be given more than once
    #[arg(long, value_name = "path=value")]
    pub set: Vec<String>,
    /// Refuse to render what is systematically wrong, whatever the number of samples
    #[arg(long)]
    pub unbiased: bool,
    /// Put in what the scene does not require, too; the picture does not change. To see what `scn
    /// plan` says is saved
    #[arg(long, value_name = "WHAT")]
    pub force: Option<Force>,
    /// Keep the render in NAME.checkpoint beside its pictures every so often, such as `10min`, and
    /// when it ends or is interrupted; every 60 s if no time is given
    #[arg(long, value_name = "TIME", value_parser = every, allow_negative_numbers = true)]
    pub checkpoint: Option<Option<f64>>,
    /// Go on from NAME.checkpoint, to the same picture as without a break, and keep it further
    #[arg(long)]
    pub resume: bool,
    /// Render the i-th of n slices of the samples into NAME.i-of-n.part, for `scn merge`
    #[arg(long, value_name = "i/n", value_parser = super::shard::parse, allow_hyphen_values = true)]
    pub shard: Option<super::shard::Shard>,
    /// Render what this picture shows once more, with the seed and samples it was made of: the same
    /// bits
    #[arg(long, value_name = "PICTURE", conflicts_with_all = [
        "only", "samples", "time", "error", "seed", "scale", "crop", "checkpoint", "resume", "shard",
    ])]
    pub replay: Option<PathBuf>,
    /// Say nothing but errors
    #[arg(long, short)]
    pub quiet: bool,
    /// How the log on stdout is written: for people, or one JSON object a line
    #[arg(long, value_name = "FORM", default_value = "human")]
    pub log: Form,
}

/// Lay out scene files in the one style there is
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  scn fmt my.scn lib/*.scn      rewrite those that are not in the style
  scn fmt --check scenes/*.scn  list them, and end with status 1 if there are any
  scn fmt --diff my.scn         show what would change
  scn fmt - < my.scn            from stdin to stdout

The style: four spaces a level, 100 columns, items on lines of their own. A record written on one
line stays on one if it fits; else it has a field a line, without commas. Comments stay where they
stand. A file with faults of syntax is left alone.")]
pub struct Fmt {
    /// The scene files; `-` for stdin to stdout
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// Write nothing; list the files which are not in the style, and end with status 1 if there are
    /// any
    #[arg(long)]
    pub check: bool,
    /// Write nothing; show what would change
    #[arg(long)]
    pub diff: bool,
}

/// What is put in, required or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Force {
    /// Everything there is
    All,
}

/// Who reads it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Form {
    Human,
    Json,
}

/// As many as the language allows.
pub const MAX_SAMPLES: u64 = 4_294_967_296;
/// More threads than any machine has processors are a mistake.
const MAX_THREADS: u64 = 4096;
/// The language allows no picture wider than this, so no larger factor is of use.
const MAX_SCALE: f64 = 65_536.0;

pub fn samples(text: &str) -> Result<u64, String> {
    whole(text, 1, MAX_SAMPLES)
}

pub fn threads(text: &str) -> Result<u64, String> {
    whole(text, 1, MAX_THREADS)
}

pub fn seed(text: &str) -> Result<u64, String> {
    whole(text, 0, u64::MAX)
}

pub fn whole(text: &str, least: u64, most: u64) -> Result<u64, String> {
    let number = text.parse().ok().filter(|number| (least..=most).contains(number));
    number.ok_or_else(|| format!("write a whole number from {least} to {most}"))
}

/// Units of time, in seconds.
const TIMES: [(&str, f64); 5] =
    [("us", 1e-6), ("ms", 1e-3), ("min", 60.0), ("s", 1.0), ("h", 3600.0)];

pub fn time(text: &str) -> Result<f64, String> {
    let unit = TIMES.iter().find_map(|(unit, seconds)| {
        Some((text.strip_suffix(unit)?.trim().parse::<f64>().ok()?, *seconds))
    });
    match unit {
        Some((number, seconds)) if number > 0.0 && (number * seconds).is_finite() => {
            Ok(number * seconds)
        }
        Some(_) => Err("the time must be above 0".to_string()),
        None => Err("write a time with its unit, ms, s, min or h, such as `90s`".to_string()),
    }
}

fn every(text: &str) -> Result<f64, String> {
    time(text).map_err(|why| format!("{why}; the scene file stands before --checkpoint"))
}

pub fn error(text: &str) -> Result<f64, String> {
    let number = match text.strip_suffix('%') {
        Some(percent) => percent.trim().parse::<f64>().map(|percent| percent / 100.0),
        None => text.parse(),
    };
    match number {
        Ok(part) if part > 0.0 && part < 1.0 => Ok(part),
        Ok(_) => Err("the error must be above 0 and below 1, which is 100%".to_string()),
        Err(_) => Err("write a part, such as `1%` or `0.01`".to_string()),
    }
}

pub fn scale(text: &str) -> Result<f64, String> {
    let factor: f64 = text.parse().map_err(|_| "write a number, such as 0.5".to_string())?;
    if factor > 0.0 && factor <= MAX_SCALE {
        Ok(factor)
    } else {
        Err(format!("the factor must be above 0, and {MAX_SCALE} at most"))
    }
}

pub fn crop(text: &str) -> Result<[u64; 4], String> {
    let parts: Vec<u64> = text
        .split(',')
        .map(|part| part.trim().parse())
        .collect::<Result<_, _>>()
        .map_err(|_| "write four whole numbers, such as 0,0,64,64".to_string())?;
    let [x0, y0, x1, y1] = parts[..] else {
        return Err(format!("write four numbers x0,y0,x1,y1; here are {}", parts.len()));
    };
    if x0 >= x1 {
        return Err(format!("x0 must be less than x1, but {x0} is not less than {x1}"));
    }
    if y0 >= y1 {
        return Err(format!("y0 must be less than y1, but {y0} is not less than {y1}"));
    }
    Ok([x0, y0, x1, y1])
}

/// Show what a fault means, with an example, and how it is mended
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  scn explain                      every code, with its title
  scn explain syntax/unexpected    one of them")]
pub struct Explain {
    /// The code of the fault, as a report shows it in brackets; all are listed without one
    pub code: Option<String>,
}

/// Show the words of the language: kinds, variants, fields, types, units, ranges and defaults
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  scn list             every kind of item, and its variants
  scn list light       all lights, with their fields
  scn list diffuse     one of them; any word of the language will do
  scn list functions   what can be called; `units` and `keywords` likewise
  scn list --format markdown > docs/reference.md   all of it, as a page")]
pub struct List {
    /// A word: a kind (camera …), a variant (diffuse …), a field (albedo …), a keyword (render …), a
    /// function or a unit; words before it say where it stands
    #[arg(value_name = "WORD")]
    pub words: Vec<String>,
    /// How it is written; `markdown` writes the whole language as one page, and takes no WORD
    #[arg(long, value_name = "FORM", default_value = "human", conflicts_with = "words")]
    pub format: Page,
}

/// What a list is written for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Page {
    Human,
    Markdown,
}

/// Write a small scene to begin with
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  scn new            into scene.scn
  scn new my/first   into my/first.scn; a file that is there is never written over")]
pub struct New {
    /// The file; the ending .scn is added
    #[arg(value_name = "NAME")]
    pub name: Option<PathBuf>,
}

/// Print a script by which a shell completes what is typed after `scn`
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  scn completions bash > ~/.local/share/bash-completion/completions/scn
  scn completions zsh > ~/.zfunc/_scn
  scn completions fish > ~/.config/fish/completions/scn.fish")]
pub struct Completions {
    /// The shell
    #[arg(value_name = "SHELL")]
    pub shell: clap_complete::Shell,
}

/// Print a page for `man`
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  scn man > ~/.local/share/man/man1/scn.1
  scn man render > ~/.local/share/man/man1/scn-render.1")]
pub struct Man {
    /// The command whose page it is; without one, that of all
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(arguments: &str) -> Result<Options, String> {
        Options::try_parse_from(arguments.split(' ')).map_err(|error| error.to_string())
    }

    #[test]
    fn clap_finds_nothing_wrong_with_the_options() {
        use clap::CommandFactory;
        Options::command().debug_assert();
    }

    #[test]
    fn numbers_out_of_range_are_refused_with_their_range() {
        for (arguments, words) in [
            ("--time 5", "write a time with its unit, ms, s, min or h"),
            ("--time 0s", "the time must be above 0"),
            ("--time nanmin", "the time must be above 0"),
            ("--time infh", "the time must be above 0"),
            ("--error 100%", "the error must be above 0 and below 1"),
            ("--error small", "write a part, such as `1%` or `0.01`"),
            ("--threads 0", "write a whole number from 1 to 4096"),
            ("--samples 0", "write a whole number from 1 to 4294967296"),
            ("--samples -3", "write a whole number from 1 to"),
            ("--samples 2.5", "write a whole number from 1 to"),
            ("--threads -1", "write a whole number from 1 to"),
            ("--seed -1", "write a whole number from 0 to"),
            ("--scale -1", "the factor must be above 0"),
            ("--scale 0", "the factor must be above 0"),
            ("--scale nan", "the factor must be above 0"),
            ("--scale big", "write a number, such as 0.5"),
            ("--crop 0,0,64", "here are 3"),
            ("--crop 64,0,64,64", "x0 must be less than x1"),
            ("--crop 0,9,64,8", "y0 must be less than y1"),
            ("--crop a,b,c,d", "write four whole numbers"),
            ("--seed 18446744073709551616", "from 0 to 18446744073709551615"),
            ("--log xml", "possible values: human, json"),
        ] {
            let told = parsed(&format!("scn render a.scn {arguments}")).unwrap_err();
            assert!(told.contains(words), "{arguments}:\n{told}");
        }
        let seed = "--seed 18446744073709551615 --crop 0,0,1,1 --scale 1e-3";
        assert!(parsed(&format!("scn render a.scn {seed}")).is_ok());
    }
}
