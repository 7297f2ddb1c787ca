#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "gather/rows/row_blur.hpp"
#include "gather/rows/row_sources.hpp"
#include "gather/rows/rows.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::gather {

/// The terms of one point, in the order of discovery.
class PointTerms {
 public:
  explicit PointTerms(const RowSources& sources) : sources_(&sources) {}

  void begin(Vec2 p) {
    p_ = p;
    edge_.clear();
    end_.clear();
  }

  /// Adds the visible part of an edge with one radius. Parts of it that are seen beside a vertex in
  /// front of it, one after the other, are one term.
  void add(std::uint32_t source, const PartMoment& part) {
    if (!(part.weight > 0)) return;
    if (!edge_.empty() && edge_.back().source == source) {
      edge_.back().part.weight += part.weight;
      edge_.back().part.moment += part.moment;
    } else {
      edge_.push_back({source, part});
    }
  }

  /// Adds a part of an edge whose radius varies, given by the fractions of its ends. k is the
  /// weight of the curve, `part` as in add().
  void add_varied(std::uint32_t source, double k, double from, double to, const PartMoment& part);

  /// Adds the terms of the free ends that reach the point.
  void add_ends();

  /// Appends all terms except those below the share `negligible`, as shares of the remaining
  /// weight.
  void store(float negligible, std::vector<RowTerm>& out) const;

  /// Returns the bytes of its tables.
  std::size_t capacity_bytes() const { return sfumato::capacity_bytes(edge_, end_); }

 private:
  struct OfEdge {
    std::uint32_t source;
    PartMoment part;
  };
  struct OfEnd {
    std::uint32_t source;
    EndShare share;
  };

  const RowSources* sources_;
  Vec2 p_;
  std::vector<OfEdge> edge_;
  std::vector<OfEnd> end_;
};

}  // namespace sfumato::gather
