#pragma once

#include <cstdint>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/stats.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::cli {

/// Draws a document as the arguments ask and makes the bytes of the output of it. What the format
/// cannot hold is reported as warnings. document: its background may be changed, and it is let go
/// as soon as the picture is solved.
/// Errors: those of diffuse, rasterize and the exporters.
Result<std::vector<std::uint8_t>> make_picture_file(Context& context, Document& document,
                                                    const RenderArguments& arguments,
                                                    RenderStats& stats);

}  // namespace sfumato::cli
