#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cli/commands/stats.hpp"
#include "cli/files/solved_input.hpp"
#include "cli/options/arguments.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/solve/solution.hpp"

namespace sfumato::cli {

/// Draws a document by the arguments and returns the bytes of the output file. Content that the
/// format cannot represent is reported as warnings. document: its background may be changed, and it
/// is freed as soon as the picture is solved. kept: unless null, a solution of an earlier state of
/// the drawing, or none. It follows the document, and layers that did not change are not solved
/// again. With Settings::coherent, changed layers continue from their meshes. Errors: as diffuse,
/// rasterize and the exporters.
Result<std::vector<std::uint8_t>> make_picture_file(Context& context, Document& document,
                                                    const RenderArguments& arguments,
                                                    RenderStats& stats,
                                                    std::optional<Solution>* kept = nullptr);

/// Does the same for a picture that is solved already. solved: freed as soon as it is drawn.
Result<std::vector<std::uint8_t>> make_picture_file(Context& context, SolvedInput solved,
                                                    const RenderArguments& arguments,
                                                    RenderStats& stats);

}  // namespace sfumato::cli
