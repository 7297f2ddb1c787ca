#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::bench {

/// A picture to trace.
struct TracePicture {
  std::string name;               ///< the file's name, after its folder's name
  Image image;                    ///< with alpha only if some pixel is transparent
  std::optional<Document> truth;  ///< the drawing that the picture shows
};

/// Reads a photo (.png, .jpg), or a drawing (.svg, .xml) as a picture whose longer side has 512
/// pixels. An ordinary SVG keeps its own size. Returns the errors of the readers.
Result<TracePicture> read_trace_picture(Context& context, const std::string& path);

/// Returns the files of a group: "photos", "drawings" or "flat". Reports missing files on stderr.
/// Empty for another name.
std::vector<std::string> trace_group(const std::string& name);

}  // namespace sfumato::bench
