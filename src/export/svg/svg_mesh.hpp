#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/output_buffer.hpp"
#include "export/facets/facets.hpp"
#include "export/facets/underlap.hpp"

namespace sfumato::outputs {

/// Numbers that ids are made from, over all of a file.
struct SvgIds {
  std::uint64_t next = 0;
};

/// A channel of paint: the id of the gradient that has its stops, from black on, and the last one.
struct Ink {
  const char* stops;
  std::array<int, 3> full;
};

inline constexpr Ink kRed{"R", {255, 0, 0}}, kGreen{"G", {0, 255, 0}}, kBlue{"B", {0, 0, 255}},
    kWhite{"W", {255, 255, 255}};

/// The gradient with the stops of an ink, which those of triangles refer to.
void append_stops(const Ink& ink, OutputBuffer& text);

/// Facets as they are painted.
struct SvgMesh {
  const FacetMesh* mesh = nullptr;
  FacetOutlines outlines;
  std::vector<SmallFacet> small;
  std::string small_clip;  ///< what clips these: an attribute, with a blank before it, or nothing
  Affine grid_from_layer;  ///< to coordinates that are written as whole numbers
  TableMemory memory{"the outlines of facets"};  ///< of `small`
};

/// One channel of all facets, in their order, each a path with a linear gradient of its own or,
/// where it hardly varies, a plain fill. Errors: limit (memory), cancelled.
Status append_channel(Context& context, const SvgMesh& mesh, int channel, const Ink& ink,
                      SvgIds& ids, OutputBuffer& text);

}  // namespace sfumato::outputs
