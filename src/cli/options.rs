//! What can be asked of the command line, by clap.

use clap::{Args, Parser, Subcommand};

/// A scene language, its compiler, and the physically based renderer behind it.
#[derive(Parser, Debug)]
#[command(name = "scn", version, max_term_width = 100, subcommand_required = true)]
#[command(arg_required_else_help = true)]
#[command(after_help = "\
Examples:
  scn render scenes/w01_first_pictures.scn    every render of the file, into out/
  scn lint my.scn                             what is wrong with it
  scn list material                           what the language has to offer
  scn explain type/dimension                  what a fault means, and how it is mended

Exit status: 0 well; 1 the scene, or a file it names, has errors; 2 the tool could not do its
work (options, the scene file itself, the disk); 130 interrupted.")]
pub struct Options {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand, Debug)]
pub enum Command {
    Explain(Explain),
    List(List),
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
  scn list diffuse     one of them; any word of the language will do")]
pub struct List {
    /// A word: a kind (camera, material …), a variant (diffuse …) or a field (albedo …)
    #[arg(value_name = "KIND")]
    pub word: Option<String>,
}
