//! The `ifs` program: arguments, files, progress, exit codes. The truth about a design is in the compiler.

fn main() {}
