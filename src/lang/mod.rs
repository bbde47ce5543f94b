//! text → Scene: parse, import, resolve, evaluate, check, lower. Knows words, not light.
