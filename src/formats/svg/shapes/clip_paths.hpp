#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "formats/css/basic_shape.hpp"
#include "formats/svg/read/input.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "formats/svg/shapes/path.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// The clips of an ordinary SVG: clip-path (CSS Masking 1) and the viewports of nested <svg> and
/// <symbol>.
class ClipPaths {
 public:
  using Index = std::optional<std::uint32_t>;  ///< of a clip; none: nothing is clipped

  /// viewport   for percentages
  ClipPaths(Input& input, const Box& viewport, std::vector<PlainClip>& clips)
      : input_(input), viewport_(viewport), clips_(clips) {}

  /// Returns the clip of the element's clip-path within another clip. A value that cannot be read
  /// clips nothing, with a warning. Errors: bad_input, limit, cancelled, out_of_memory.
  Result<Index> read(Element element, const Affine& artboard_from_user, Index outer);
  /// Returns the clip of a box in user space within another clip. `inner`: an earlier clip of the
  /// box itself. Errors: as above.
  Result<Index> add_box(Element element, const Box& box, const Affine& artboard_from_user,
                        Index outer, Index inner = std::nullopt);

 private:
  using Key = std::tuple<const void*, double, double, double, double, double, double, Index>;

  /// A value of clip-path.
  struct Named {
    Element clip_path{};                     ///< of an url
    std::optional<css::BasicShape> shape{};  ///< else
    std::string_view text{};
    bool needs_unit = false;
  };

  std::optional<Named> named_by(Element element);
  std::optional<Element> clip_path_of(Element element, std::string_view url);
  Result<Index> read_shape_function(Element element, const Named& named,
                                    const Affine& artboard_from_user, Index outer);
  Status add_contours(Element element, const std::vector<Subpath>& subpaths, const Affine& map,
                      TableMemory& memory, PlainClip::Part& part);
  Result<Index> read_clip_path(Element element, Element clip_path, const Affine& artboard_from_user,
                               Index outer);
  Result<Affine> content_frame(Element element, Element clip_path,
                               const Affine& artboard_from_user);
  Status read_child(Element child, const Affine& artboard_from_user, PlainClip& clip);
  Result<Index> keep(Element element, PlainClip clip);

  Input& input_;
  const Box& viewport_;
  std::vector<PlainClip>& clips_;
  std::map<Key, Index> known_;   ///< clips in the user space of their elements
  std::vector<Element> active_;  ///< the clip paths that are being read, outermost first
};

}  // namespace sfumato::svg
