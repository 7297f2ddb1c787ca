#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/output_buffer.hpp"
#include "export/facets/facets.hpp"
#include "export/facets/underlap.hpp"

namespace sfumato::outputs {

/// Numbers for ids, unique in a file.
struct SvgIds {
  std::uint64_t next = 0;
};

/// A channel of paint: the id of the gradient with its stops (the first is black), and the last
/// stop.
struct Ink {
  const char* stops;
  std::array<int, 3> full;
};

inline constexpr Ink kRed{"R", {255, 0, 0}}, kGreen{"G", {0, 255, 0}}, kBlue{"B", {0, 0, 255}},
    kWhite{"W", {255, 255, 255}};

/// The gradient with the stops of an ink, to which the gradients of triangles refer.
void append_stops(const Ink& ink, OutputBuffer& text);

/// Facets ready for painting.
struct SvgMesh {
  const FacetMesh* mesh = nullptr;
  FacetOutlines outlines;
  std::vector<SmallFacet> small;
  std::string small_clip;  ///< the clip of these: an attribute preceded by a blank, or empty
  Affine grid_from_layer;  ///< to coordinates written as whole numbers
  TableMemory memory{"the outlines of facets"};  ///< for `small`
};

/// One channel of all facets, in their order, each a path with its own linear gradient or, if it
/// hardly varies, a plain fill. Errors: limit (memory), cancelled.
Status append_channel(Context& context, const SvgMesh& mesh, int channel, const Ink& ink,
                      SvgIds& ids, OutputBuffer& text);

}  // namespace sfumato::outputs
