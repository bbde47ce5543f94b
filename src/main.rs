//! The `scn` binary: a thin door to the command line.

fn main() -> std::process::ExitCode {
    scn::cli::main()
}
