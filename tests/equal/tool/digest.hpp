#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "equal/tool/scene.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::test {

/// 64-bit FNV-1a over bytes.
class Hasher {
 public:
  void add_bytes(const void* bytes, std::size_t size);

  /// Adds the numbers and their count.
  template <class Items>
  void add(const Items& items) {
    const std::uint64_t count = items.size();
    add_bytes(&count, sizeof count);
    add_bytes(items.data(), items.size() * sizeof(typename Items::value_type));
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// The result of a stage of a scene, as a hash of its bits.
struct StageHash {
  std::string stage;
  std::uint64_t hash = 0;

  friend bool operator==(const StageHash&, const StageHash&) = default;
};

/// Hashes a scene through diffuse() and rasterize(): its document, mesh, nodes, pixels and png;
/// then the scene's other outputs, and the pixels of a picture for a pixel grid. A stage that fails
/// has the hash of its error, and ends the list.
std::vector<StageHash> digest_scene(Context& context, const Scene& scene);

/// "17 document:0123456789abcdef mesh:…".
std::string digest_line(const Scene& scene, const std::vector<StageHash>& digest);

}  // namespace sfumato::test
