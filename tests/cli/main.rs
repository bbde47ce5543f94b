//! The command line from outside: the built binary, run in folders of its own.

mod bench;
mod checkpoints;
mod faults;
mod fmt;
mod interrupt;
mod lint;
mod logs;
mod paths;
mod pictures;
mod plan;
mod replay;
mod shards;
mod start;
mod words;
