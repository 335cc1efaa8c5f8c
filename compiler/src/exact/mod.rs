//! Exact numbers: rationals of any size and what is built on them. No floating point decides anything here.
