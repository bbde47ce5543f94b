//! The command line from outside: the built binary, run in folders of its own.

mod bench;
mod faults;
mod fmt;
mod interrupt;
mod lint;
mod logs;
mod pictures;
mod start;
mod words;
