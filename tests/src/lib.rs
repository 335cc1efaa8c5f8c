//! Shared pieces of the test suites: where the tree lies and how the `ifs` program is run.
