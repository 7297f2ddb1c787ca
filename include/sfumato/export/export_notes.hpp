#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sfumato {

/// Remarks of an exporter beside the bytes of its file. Exporters add to them: use a new object for
/// each file.
struct ExportNotes {
  /// Differences between file and picture, and content that is slow to show: one sentence each
  /// without a full stop, such as "blend modes other than normal are shown as normal". Empty: none.
  std::vector<std::string> lost;
  /// Triangles that the file stores. A layer counts once, however often it is painted.
  std::uint64_t triangle_count = 0;
};

}  // namespace sfumato
