#pragma once

#include "base/table_memory.hpp"
#include "mesh/mesher.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {

/// The visibility mesh of one field: without the curves that do not have its attribute.
struct FieldMesh {
  TableMemory memory{"the visibility mesh"};
  mesh::TriangleMesh thinned;
  bool is_thinned = false;

  const mesh::TriangleMesh& of(const mesh::TriangleMesh& visibility) const {
    return is_thinned ? thinned : visibility;
  }
};

/// Makes the mesh.
///
/// visibility   mesher.visibility_mesh()
/// before       of the mesh before segments were inserted or removed; null: there was no change
/// Errors       limit (memory), cancelled
Result<FieldMesh> mesh_field(const Context& context, const mesh::Mesher& mesher,
                             const mesh::TriangleMesh& visibility,
                             const curves::SegmentAttributes& attributes,
                             const PreparedField* before = nullptr, const FieldEdits& edits = {});

}  // namespace sfumato::solve
