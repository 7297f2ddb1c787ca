#pragma once

#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::test {

/// Returns the names of the drawings in tests/trace/flat, sorted: flat colours, as in logos and
/// cartoons (tests/trace/flat/README.md).
std::vector<std::string> flat_art_names();

/// Returns one of them as curves, with or without its background. Errors: those from reading and
/// from import_svg(), and bad_input if import_svg() leaves anything out.
Result<Document> flat_art(Context& context, const std::string& name, bool has_background = true);

/// Returns one of them in pixels, `scale` per user unit; with alpha where nothing is behind it.
Result<Image> flat_picture(Context& context, const std::string& name, bool has_background = true,
                           double scale = 1);

}  // namespace sfumato::test
