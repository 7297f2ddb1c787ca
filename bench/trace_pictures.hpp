#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::bench {

/// Something to trace.
struct TracePicture {
  std::string name;               ///< the file's, behind that of its folder
  Image image;                    ///< with alpha only where it has some
  std::optional<Document> truth;  ///< the drawing that it shows
};

/// Reads a photo (.png, .jpg), or a drawing (.svg, .xml) as a picture whose longer side has 512
/// pixels. An ordinary SVG has its own size. Errors: those of the readers.
Result<TracePicture> read_trace_picture(Context& context, const std::string& path);

/// The files of a group: "photos", "drawings" or "flat". What belongs to it and is not at hand is
/// said on stderr. Empty for another name.
std::vector<std::string> trace_group(const std::string& name);

}  // namespace sfumato::bench
