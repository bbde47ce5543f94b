//! Compiles embree.cpp, which calls Embree 3 as the system has it.

use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-changed=embree.cpp");
    let out = std::env::var("OUT_DIR").expect("cargo names a folder");
    let object = Path::new(&out).join("embree.o");
    let library = Path::new(&out).join("libpeer.a");
    let compile = ["-O3", "-march=native", "-c", "embree.cpp", "-o"];
    run(Command::new("g++").args(compile).arg(&object));
    run(Command::new("ar").arg("crs").arg(&library).arg(&object));
    println!("cargo:rustc-link-search={out}");
    println!("cargo:rustc-link-lib=static=peer");
    println!("cargo:rustc-link-lib=embree3");
    println!("cargo:rustc-link-lib=stdc++");
}

fn run(command: &mut Command) {
    let status = command.status().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(status.success(), "{command:?}: {status}");
}
