//! The scene: which meshes stand where (glTF 2.0, section 3.5).

use super::Fault;
use super::accessor::missing;
use super::document::{Document, Mesh, Node, shown};
use glam::{DAffine3, DMat4, DQuat, DVec3};

/// A mesh with the place of the node that holds it.
pub(super) struct PlacedMesh<'a> {
    pub(super) mesh: &'a Mesh,
    /// Its number, for messages.
    pub(super) number: u32,
    pub(super) place: DAffine3,
}

/// The meshes of the scene in the order of its nodes, each before those of its children. A file without a scene shows all
/// nodes that are in no other one; a file without nodes all its meshes.
pub(super) fn placed_meshes(document: &Document) -> Result<Vec<PlacedMesh<'_>>, Fault> {
    let mut placed = Vec::new();
    if document.nodes.is_empty() {
        let meshes = document.meshes.iter().zip(0..);
        placed.extend(meshes.map(|(mesh, number)| PlacedMesh { mesh, number, place: DAffine3::IDENTITY }));
        return Ok(placed);
    }
    let mut met = vec![false; document.nodes.len()];
    let mut open: Vec<(u32, DAffine3)> = Vec::new();
    open.extend(roots(document)?.into_iter().rev().map(|root| (root, DAffine3::IDENTITY)));
    while let Some((number, outer)) = open.pop() {
        let Some((node, met)) = document.nodes.get(number as usize).zip(met.get_mut(number as usize)) else {
            return Err(missing(format!("nodes[{number}]"), document.nodes.len()));
        };
        if std::mem::replace(met, true) {
            let what = "the node is reached twice: the nodes of a scene are a tree";
            return Err(Fault::malformed(format!("nodes[{number}]"), what));
        }
        let place = outer * own_place(node, number)?;
        if let Some(mesh) = node.mesh {
            placed.push(placed_mesh(document, node, number, mesh, place)?);
        }
        open.extend(node.children.iter().rev().map(|child| (*child, place)));
    }
    Ok(placed)
}

fn roots(document: &Document) -> Result<Vec<u32>, Fault> {
    let chosen = document.scene.or((!document.scenes.is_empty()).then_some(0));
    if let Some(chosen) = chosen {
        return match document.scenes.get(chosen as usize) {
            Some(scene) => Ok(scene.nodes.clone()),
            None => Err(missing(format!("scenes[{chosen}]"), document.scenes.len())),
        };
    }
    let mut inner = vec![false; document.nodes.len()];
    for child in document.nodes.iter().flat_map(|node| &node.children) {
        if let Some(inner) = inner.get_mut(*child as usize) {
            *inner = true;
        }
    }
    Ok((0..).zip(&inner).filter(|(_, inner)| !**inner).map(|(number, _)| number).collect())
}

fn placed_mesh<'a>(
    document: &'a Document,
    node: &Node,
    number: u32,
    mesh: u32,
    place: DAffine3,
) -> Result<PlacedMesh<'a>, Fault> {
    let at = || format!("nodes[{number}]");
    let Some(found) = document.meshes.get(mesh as usize) else {
        return Err(missing(format!("meshes[{mesh}]"), document.meshes.len()));
    };
    if node.skin.is_some() {
        let mend = "apply the pose before you export it";
        return Err(Fault::unsupported(at(), "the mesh is bent by a skeleton, which is not read", mend));
    }
    let bends = |weights: &[f64]| weights.iter().any(|weight| *weight != 0.0);
    let weights = if node.weights.is_empty() { &found.weights } else { &node.weights };
    if bends(weights) && found.primitives.iter().any(|primitive| !primitive.targets.is_empty()) {
        let mend = "apply the shape keys before you export it";
        return Err(Fault::unsupported(at(), "the mesh is bent by shape keys, which are not read", mend));
    }
    if let Some(name) = node.extensions.keys().find(|name| name.ends_with("_mesh_gpu_instancing")) {
        let what = format!("the node repeats its mesh by {}, which is not read", shown(name));
        return Err(Fault::unsupported(at(), what, "export the copies as nodes of their own"));
    }
    Ok(PlacedMesh { mesh: found, number: mesh, place })
}

/// The place of a node in the one around it: a matrix column by column, or moved, turned and scaled.
fn own_place(node: &Node, number: u32) -> Result<DAffine3, Fault> {
    if let Some(matrix) = &node.matrix {
        let matrix = DMat4::from_cols_array(matrix);
        if matrix.row(3) != DVec3::ZERO.extend(1.0) {
            let what = "its matrix is no affine map: the last row is not 0 0 0 1";
            return Err(Fault::malformed(format!("nodes[{number}]"), what));
        }
        return Ok(DAffine3::from_mat4(matrix));
    }
    let moved = DVec3::from_array(node.translation.unwrap_or_default());
    let scaled = DVec3::from_array(node.scale.unwrap_or([1.0; 3]));
    let [x, y, z, w] = node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]);
    let length = libm::sqrt(x * x + y * y + z * z + w * w);
    // Writers round a turn to single precision; what is no turn at all is another matter.
    if !((length - 1.0).abs() < 1e-2) {
        let what = format!("its rotation is no unit quaternion: the length is {length}");
        return Err(Fault::malformed(format!("nodes[{number}]"), what));
    }
    let turned = DQuat::from_xyzw(x / length, y / length, z / length, w / length);
    Ok(DAffine3::from_scale_rotation_translation(scaled, turned, moved))
}
