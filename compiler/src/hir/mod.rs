//! From the tree as written to the typed tree, and from that to values: names, modules, the standard library, types,
//! dimensions, affine weights and evaluation. Matrices, counts and meshes are elsewhere.

mod check;
pub mod dimension;
pub mod evaluate;
pub mod index;
mod library;
mod library_docs;
pub mod map;
pub mod native;
mod native_docs;
pub mod placed;
pub mod scalar;
pub mod schema;
pub mod size;
pub mod tree;
pub mod type_names;
pub mod types;
pub mod value;

pub use check::{
    Checked, ImportedMesh, ModuleSource, check, check_in_place, check_indexed, value_to_begin_with,
};
pub use library::{LIBRARY, library_text};
pub use library_docs::{
    ItemDocs, ModuleDocs, item_docs, library_docs, library_page, native_item_docs, native_parameter,
    native_result,
};
