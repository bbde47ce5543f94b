//! The `scn` binary: a thin door to the command line.

fn main() {}
