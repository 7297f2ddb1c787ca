#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sfumato {

/// What an exporter has to say besides the bytes of its file.
struct ExportNotes {
  /// What of the picture the format cannot hold, or holds as pixels: one sentence each, no full
  /// stop, as "blend modes other than normal are left out". No duplicates.
  std::vector<std::string> lost;
  std::uint64_t triangle_count = 0;  ///< triangles in the file
};

}  // namespace sfumato
