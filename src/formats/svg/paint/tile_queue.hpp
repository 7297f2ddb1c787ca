#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "formats/svg/read/input.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "sfumato/base/affine.hpp"

namespace sfumato::svg {

/// A pattern of vector content, a mask or a masked element that is to be read.
struct TileRequest {
  Element content;  ///< the pattern or the mask that has the content; the masked element
  Affine texture_from_content{};
  int width = 0;   ///< texels
  int height = 0;  ///< texels
  std::size_t owner = 0;
  std::uint32_t shader = 0;
  std::size_t depth = 0;  ///< patterns around it
  TileUse use = TileUse::paint;
  bool is_masked = false;         ///< the content is an element without its mask, not its children
  std::vector<Element> around{};  ///< a masked element, the outermost first
  Element instance{};             ///< the <use> that refers to the masked element directly
};

/// The tiles of an ordinary SVG, in the order of the document.
class TileQueue {
 public:
  /// Along a side of a tile: for a picture that is shown enlarged, as far as the limits allow.
  static constexpr double kTexelsPerPx = 2;

  /// Whose patterns are met from now on.
  void set_owner(std::size_t owner, std::size_t depth) {
    owner_ = owner;
    depth_ = depth;
  }
  /// Returns whether this content is being read.
  bool is_around(Element content) const {
    std::size_t at = owner_;
    while (at > 0 && requests_[at - 1].content != content) at = requests_[at - 1].owner;
    return at > 0;
  }
  /// Returns the number of tiles so far.
  std::size_t texels() const { return texels_; }
  /// Patterns around the next tiles.
  std::size_t depth() const { return depth_; }
  void add(TileRequest request) {
    request.owner = owner_;
    request.depth = depth_ + 1;
    texels_ += static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height);
    requests_.push_back(std::move(request));
  }
  const std::vector<TileRequest>& requests() const { return requests_; }

 private:
  std::vector<TileRequest> requests_;
  std::size_t texels_ = 0;
  std::size_t owner_ = 0;
  std::size_t depth_ = 0;
};

}  // namespace sfumato::svg
