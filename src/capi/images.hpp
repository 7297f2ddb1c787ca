#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "capi/call.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato::capi {

/// Images that the caller has decoded, by the bytes of their files.
class Images {
 public:
  /// Keeps a copy of both, in the place of what there was for these bytes. Errors: bad usage (no
  /// image), limit (of a texture, memory), cancelled; what there was is gone then.
  Outcome put(const Context& context, std::span<const std::uint8_t> file,
              const sfumato_image* image);
  /// Forgets the pixels for these bytes, if there are any.
  void forget(std::span<const std::uint8_t> file);
  /// Those for these bytes; empty where there are none.
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
