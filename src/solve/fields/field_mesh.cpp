#include "solve/fields/field_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include "base/try.hpp"

namespace sfumato::solve {
namespace {

bool bears_attribute(const curves::SegmentAttributes& attributes, std::size_t segment) {
  return attributes.left[segment].kind != ShaderKind::open ||
         attributes.right[segment].kind != ShaderKind::open;
}

/// Returns per constraint 1 where a curve on it has the attribute, on either side.
Result<std::vector<std::uint8_t>> bearing_constraints(const Context& context,
                                                      const mesh::TriangleMesh& mesh,
                                                      const curves::SegmentAttributes& attributes,
                                                      TableMemory& memory) {
  std::vector<std::uint8_t> bears;
  SFUMATO_TRY(memory.resize(context, bears, mesh.constraint.size()));
  for (std::size_t c = 0; c < bears.size(); ++c) {
    for (const mesh::SegmentPiece& piece : mesh.pieces(mesh.constraint[c])) {
      bears[c] |= bears_attribute(attributes, piece.segment);
    }
  }
  return bears;
}

/// Returns whether some constraint has a curve without the attribute. The frame is not a curve.
bool is_thin(const mesh::TriangleMesh& mesh, const std::vector<std::uint8_t>& bears) {
  for (std::size_t c = 0; c < bears.size(); ++c) {
    if (!bears[c] && !mesh.pieces(mesh.constraint[c]).empty()) return true;
  }
  return false;
}

/// Returns whether there is nothing to thin: there was nothing before, and the segments inserted
/// since have the attribute. They are marked with the last vertex of their polyline, where none
/// begins.
bool stays_whole(const curves::SegmentAttributes& attributes, const PreparedField* before,
                 const FieldEdits& edits) {
  if (!before || before->is_thinned || edits.whole) return false;
  const std::span<const std::uint8_t> inserted = edits.use.is_watched;
  for (std::size_t i = 0; i + 1 < inserted.size(); ++i)
    if (inserted[i] && inserted[i + 1] && !bears_attribute(attributes, i)) return false;
  return true;
}

}  // namespace

Result<FieldMesh> mesh_field(const Context& context, const mesh::Mesher& mesher,
                             const mesh::TriangleMesh& visibility,
                             const curves::SegmentAttributes& attributes,
                             const PreparedField* before, const FieldEdits& edits) {
  FieldMesh field;
  if (stays_whole(attributes, before, edits)) return field;
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& bears,
                     bearing_constraints(context, visibility, attributes, field.memory));
  field.is_thinned = is_thin(visibility, bears);
  if (!field.is_thinned) return field;
  SFUMATO_TRY_ASSIGN(field.thinned, mesher.thinned_mesh(context, visibility, bears, field.memory));
  return field;
}

}  // namespace sfumato::solve
