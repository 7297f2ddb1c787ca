#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "capi/call.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato::capi {

/// Holds images that the caller has decoded, keyed by the bytes of their files.
class Images {
 public:
  /// Keeps a copy of both and replaces an earlier image for these bytes. Errors: bad usage (no
  /// image), limit (of a texture, memory), cancelled; the earlier image is then gone.
  Outcome put(const Context& context, std::span<const std::uint8_t> file,
              const sfumato_image* image);
  /// Forgets the pixels for these bytes, if there are any.
  void forget(std::span<const std::uint8_t> file);
  /// Returns the pixels for these bytes; empty if there are none.
  std::optional<ImagePixels> find(std::span<const std::uint8_t> file) const;
  bool empty() const { return images_.empty(); }

 private:
  struct Known {
    TableMemory memory{"decoded images"};
    std::vector<std::uint8_t> file{};
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba{};
  };

  std::vector<Known> images_;
};

}  // namespace sfumato::capi
