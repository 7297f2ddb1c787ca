#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::svg {

/// The largest number of pieces of a segment, reached by long arcs.
inline constexpr std::size_t kMaxPieces = 16;

/// One subpath as a chain of cubic Béziers, in the user space of its shape.
struct Subpath {
  std::vector<Vec2> control_points;  ///< 3 n + 1
  /// The first piece of each segment, then the number of pieces. A segment is drawn by one path
  /// command: one piece or, for an arc, a power of two.
  std::vector<std::uint32_t> segment_begin;
  bool is_closed = false;
  /// Closed where it ended: the closing segment has no length, and no piece.
  bool closes_on_itself = false;
  std::uint32_t index = 0;  ///< among the subpaths that have a segment, as they were drawn
};

/// Builds subpaths from the commands of a path. A closed subpath ends exactly where it began.
/// Subpaths are allocated from `memory`. After a failure nothing more is added.
class PathBuilder {
 public:
  PathBuilder(const Context& context, TableMemory& memory) : context_(context), memory_(memory) {}

  void move_to(Vec2 point);
  void line_to(Vec2 point);
  void quadratic_to(Vec2 control, Vec2 point);
  void cubic_to(Vec2 control1, Vec2 control2, Vec2 point);
  /// SVG 1.1, appendix F.6: from the current point to `point` on an ellipse.
  void arc_to(Vec2 radii, double rotation_degrees, bool large, bool sweep, Vec2 point);
  /// Right after move_to this makes a subpath of length 0, which caps turn into a dot (SVG 2, 9.5).
  void close();

  Vec2 current() const { return current_; }
  /// Returns the point to which close() draws.
  std::size_t control_point_count() const { return control_point_count_; }
  std::size_t subpath_count() const { return done_.size(); }

  /// Ok, or why nothing more is added: limit (memory), cancelled.
  const Status& status() const { return status_; }
  /// The subpaths that have a segment, or the failure. Call once, last.
  Result<std::vector<Subpath>> take();

 private:
  template <class Table>
  bool make_room(Table& table, std::size_t more);
  void begin_segment();
  void add_piece(Vec2 control1, Vec2 control2, Vec2 point);
  void finish_subpath();

  const Context& context_;
  TableMemory& memory_;
  Status status_;
  std::vector<Subpath> done_;
  Subpath open_;
  Vec2 current_;
  Vec2 begin_;
  bool is_moved_ = false;  ///< nothing has been drawn since move_to
  std::size_t control_point_count_ = 0;
};

/// Reads the d attribute of a path (SVG 1.1, section 8.3). "none" and blanks give no subpath.
/// mistake   if set, a mistake is the end of the path, as in browsers, and this receives the error
/// Errors: bad_input, limit, cancelled, without a place.
Result<std::vector<Subpath>> parse_path(const Context& context, std::string_view text,
                                        TableMemory& memory, Status* mistake = nullptr);

/// Returns the bounding box of the curves themselves, not of their control points. Error:
/// cancelled.
Result<Box> bounds(const Context& context, const std::vector<Subpath>& subpaths);

}  // namespace sfumato::svg
