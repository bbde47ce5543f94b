//! The command line: the only room that prints, reads clocks, or chooses an exit code.
