#pragma once

#include <cstdint>
#include <optional>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/gather/options.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// How a document becomes a picture. Lengths in user units of the artboard.
struct DiffuseOptions {
  std::optional<Box> viewport{};      ///< default: the artboard
  double pixels_per_unit = 1;         ///< of the nominal output: how fine refinement may go
  std::optional<double> tolerance{};  ///< flattening; default 0.04 pixels, at most 0.05 / 512 of
                                      ///< the artboard's longer side
  double min_angle_deg = 22;
  double max_area_fraction = 0.04;  ///< of the artboard's area
  /// Largest tolerated miss of a patch in code values of 255; 0: the paper's mesh, made finer at
  /// blurred curves alone.
  double max_error = 1;
  PatchOrder order = PatchOrder::cubic;
  gather::GatherOptions gather{};
  gather::Ends ends = gather::Ends::soft;  ///< of open curves
  bool ignore_blur = false;
};

/// Sizes and times of one `diffuse`, for --stats and benchmarks.
struct DiffuseStats {
  std::uint64_t curves = 0;
  std::uint64_t segments = 0;
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;
  std::uint64_t nodes = 0;
  double geometry_seconds = 0;
  double triangulation_seconds = 0;
  double gather_seconds = 0;
};

/// What of a document stands in its picture as it is: everything but the layers. Error: limit.
Result<Picture> picture_frame(Context& context, const Document& document, const Box& viewport);

/// Document → Picture (paper sections 3–5): flatten, mesh, gather, patches.
/// Errors: bad_input (an invalid document), limit, cancelled.
Result<Picture> diffuse(Context& context, const Document& document, const DiffuseOptions& options,
                        DiffuseStats* stats = nullptr);

}  // namespace sfumato
