#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sfumato {

/// What an exporter reports besides the bytes of its file. Exporters add to what is there: use a
/// new object for each file.
struct ExportNotes {
  /// What the file does not show as the picture does, or is slow to show: one sentence each without
  /// a full stop, such as "blend modes other than normal are shown as normal". Empty: nothing.
  std::vector<std::string> lost;
  /// Triangles that the file stores. A layer counts once, however often it is painted.
  std::uint64_t triangle_count = 0;
};

}  // namespace sfumato
