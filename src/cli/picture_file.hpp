#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/solved_input.hpp"
#include "cli/stats.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/solve/solution.hpp"

namespace sfumato::cli {

/// Draws a document as the arguments say and returns the bytes of the output file. Content that the
/// format cannot represent is reported as warnings. document: its background may be changed, and it
/// is freed as soon as the picture is solved. kept: unless null, a solution of an earlier state of
/// the drawing, or none; it follows the document, and layers that did not change are not solved.
/// With Settings::coherent others go on with their meshes. Errors: those of diffuse, rasterize and
/// the exporters.
Result<std::vector<std::uint8_t>> make_picture_file(Context& context, Document& document,
                                                    const RenderArguments& arguments,
                                                    RenderStats& stats,
                                                    std::optional<Solution>* kept = nullptr);

/// The same of a picture that is solved already. solved: let go of as soon as it is drawn.
Result<std::vector<std::uint8_t>> make_picture_file(Context& context, SolvedInput solved,
                                                    const RenderArguments& arguments,
                                                    RenderStats& stats);

}  // namespace sfumato::cli
