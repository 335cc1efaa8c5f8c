//! Grids, meshes, planarity, dihedral angles, unrolling. Imports glam only.
