#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sfumato/base/vec2.hpp"

namespace sfumato::gather {

/// Points to gather at: all points of a table, or the points at some of its indices. Tables of
/// results have a slot for each point of the table; slots of unlisted points stay unchanged.
class PointList {
 public:
  PointList(std::span<const Vec2> all) : table_(all) {}                               // NOLINT
  PointList(const std::vector<Vec2>& all) : PointList(std::span<const Vec2>(all)) {}  // NOLINT
  PointList(std::span<const Vec2> table, std::span<const std::uint32_t> chosen)
      : table_(table), chosen_(chosen), is_chosen_(true) {}

  /// Returns the points of the same table at these indices.
  PointList among(std::span<const std::uint32_t> chosen) const { return {table_, chosen}; }

  /// Returns the same points, divided into groups of consecutive points. Group i ends before the
  /// listed point ends[i]. The value of a point depends only on the points of its own group.
  PointList in_groups(std::span<const std::uint32_t> ends) const {
    PointList list = *this;
    list.group_end_ = ends;
    return list;
  }
  /// Returns the ends of the groups; empty: all points are one group.
  std::span<const std::uint32_t> group_end() const { return group_end_; }

  std::size_t size() const { return is_chosen_ ? chosen_.size() : table_.size(); }
  /// Returns the index in the table of the i-th listed point.
  std::size_t slot(std::size_t i) const { return is_chosen_ ? chosen_[i] : i; }
  Vec2 operator[](std::size_t i) const { return table_[slot(i)]; }

 private:
  std::span<const Vec2> table_;
  std::span<const std::uint32_t> chosen_;
  std::span<const std::uint32_t> group_end_;
  bool is_chosen_ = false;
};

}  // namespace sfumato::gather
