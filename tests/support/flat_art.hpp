#pragma once

#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::test {

/// The names of the drawings of tests/trace/flat, sorted: flat colours, as logos and cartoons have
/// them (tests/trace/flat/README.md).
std::vector<std::string> flat_art_names();

/// One of them as curves, with its background or without. Errors: those of reading and
/// import_svg(), and bad_input where import_svg() leaves anything out.
Result<Document> flat_art(Context& context, const std::string& name, bool has_background = true);

/// One of them in pixels, `scale` of them to a user unit; with alpha where nothing is behind it.
Result<Image> flat_picture(Context& context, const std::string& name, bool has_background = true,
                           double scale = 1);

}  // namespace sfumato::test
