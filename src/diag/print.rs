//! Diagnostics on a terminal, by miette. The only file that knows miette.
