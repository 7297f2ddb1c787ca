#pragma once

#include <cstdint>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/stats.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::cli {

/// Draws a document as the arguments say and returns the bytes of the output file. Content that the
/// format cannot represent is reported as warnings. document: its background may be changed, and it
/// is freed as soon as the picture is solved.
/// Errors: those of diffuse, rasterize and the exporters.
Result<std::vector<std::uint8_t>> make_picture_file(Context& context, Document& document,
                                                    const RenderArguments& arguments,
                                                    RenderStats& stats);

}  // namespace sfumato::cli
