//! The texts of the standard library, which ship inside the program.

/// The modules of the library: name and text. `prelude` is known everywhere without `use`.
pub const LIBRARY: &[(&str, &str)] = &[
    ("prelude", include_str!("../../../stdlib/prelude.ifs")),
    ("curves", include_str!("../../../stdlib/curves.ifs")),
    ("plane", include_str!("../../../stdlib/plane.ifs")),
    ("space", include_str!("../../../stdlib/space.ifs")),
    ("surfaces", include_str!("../../../stdlib/surfaces.ifs")),
    ("roofs", include_str!("../../../stdlib/roofs.ifs")),
    ("materials", include_str!("../../../stdlib/materials.ifs")),
    ("machines", include_str!("../../../stdlib/machines.ifs")),
    ("boards", include_str!("../../../stdlib/boards.ifs")),
];

/// The text of a module.
pub fn library_text(module: &str) -> Option<&'static str> {
    LIBRARY.iter().find(|(name, _)| *name == module).map(|(_, text)| *text)
}
