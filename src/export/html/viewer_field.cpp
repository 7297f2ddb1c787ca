#include "export/html/viewer_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "picture/patch.hpp"

namespace sfumato::outputs {
namespace {

constexpr std::uint32_t kNoNode = std::numeric_limits<std::uint32_t>::max();
constexpr double kLargestValue = 64;

/// The most nodes of a vertex that are examined to find one again.
constexpr int kNodesLookedAt = 200;

constexpr int kResidualBytes = 3;

std::int32_t floor_divided(std::int32_t value, std::int32_t by) {
  const std::int32_t quotient = value / by;
  return quotient * by > value ? quotient - 1 : quotient;
}

class FieldWriter {
 public:
  FieldWriter(Context& context, const PatchField& field, const ViewerMesh& mesh, double step,
              ByteWriter& out)
      : context_(context),
        field_(field),
        mesh_(mesh),
        channels_(static_cast<std::size_t>(field.channel_count)),
        step_(channels_, viewer_step(InterpolationSpace::srgb)),
        misses_(channels_),
        out_(out) {
    std::fill(step_.begin(), step_.end() - static_cast<std::ptrdiff_t>(field.shader.size()), step);
  }

  Status run() {
    SFUMATO_TRY(memory_.resize(context_, node_, mesh_.triangle_count() * kNodesPerTriangle));
    SFUMATO_TRY(memory_.resize(context_, first_at_vertex_, mesh_.vertex.size(), kNoNode));
    for (double step : step_) out_.f32(static_cast<float>(step));
    for (const auto part :
         {&FieldWriter::add_corners, &FieldWriter::add_edges, &FieldWriter::add_center}) {
      SFUMATO_TRY(for_each_triangle(part));
      flush();
    }
    return out_.status();
  }

 private:
  Status for_each_triangle(void (FieldWriter::*body)(std::uint32_t)) {
    RarePoll<4096> poll(context_);
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      if (poll.cancelled()) return context_.cancel_status();
      SFUMATO_TRY(make_room());
      (this->*body)(t);
    }
    return ok_status();
  }

  /// Reserves memory for the data of one triangle.
  Status make_room() {
    SFUMATO_TRY(memory_.make_room(context_, source_, kNodesPerTriangle));
    SFUMATO_TRY(memory_.make_room(context_, next_at_vertex_, kNodesPerTriangle));
    SFUMATO_TRY(memory_.make_room(context_, value_, kNodesPerTriangle * channels_));
    SFUMATO_TRY(memory_.make_room(context_, codes_, kNodesPerTriangle));
    for (std::size_t c = 0; c < channels_; ++c) {
      SFUMATO_TRY(memory_.make_room(context_, misses_[c], kNodesPerTriangle));
    }
    return ok_status();
  }

  /// Returns the layer's node of a slot (PatchField's order) of triangle t in the viewer's order.
  std::uint32_t source(std::uint32_t t, std::uint32_t slot) const {
    const std::uint32_t turn = mesh_.first_corner[t];
    std::uint32_t from = slot;
    if (slot < 3) from = (slot + turn) % 3;
    if (slot >= 3 && slot < kCenterNode) from = 3 + (slot - 3 + 2 * turn) % 6;
    return field_.triangle_node[node_slot(std::size_t{mesh_.triangle[t]}, from)];
  }

  std::uint32_t& node(std::uint32_t t, std::uint32_t slot) {
    return node_[node_slot(std::size_t{t}, slot)];
  }

  std::int32_t value(std::uint32_t node, std::size_t channel) const {
    return value_[channels_ * node + channel];
  }

  /// Adds a new node for a slot; guess(channel) predicts its value.
  template <class Guess>
  void add_node(std::uint32_t t, std::uint32_t slot, const Guess& guess) {
    const std::uint32_t from = source(t, slot);
    node(t, slot) = static_cast<std::uint32_t>(source_.size());
    for (std::size_t c = 0; c < channels_; ++c) {
      const double exact = static_cast<double>(field_.node_value[channels_ * from + c]);
      const double cut = std::clamp(exact, -kLargestValue, kLargestValue);
      const auto quantized =
          std::isfinite(cut) ? static_cast<std::int32_t>(std::lround(cut / step_[c])) : 0;
      misses_[c].push_back(zigzag(quantized - guess(c)));
      value_.push_back(quantized);
    }
    source_.push_back(from);
    next_at_vertex_.push_back(kNoNode);
  }

  /// Puts the vertex's node that shows the layer's node `from` first in its list. Returns its place
  /// there, from 1, or 0 where it is not found.
  std::uint8_t recall(std::uint32_t vertex, std::uint32_t from) {
    std::uint32_t before = kNoNode;
    std::uint32_t found = first_at_vertex_[vertex];
    int place = 1;
    for (; found != kNoNode && source_[found] != from; ++place) {
      if (place == kNodesLookedAt) return 0;
      before = found;
      found = next_at_vertex_[found];
    }
    if (found == kNoNode) return 0;
    if (before != kNoNode) {
      next_at_vertex_[before] = next_at_vertex_[found];
      next_at_vertex_[found] = first_at_vertex_[vertex];
      first_at_vertex_[vertex] = found;
    }
    return static_cast<std::uint8_t>(place);
  }

  void add_corners(std::uint32_t t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh_.corner_vertex[3 * std::size_t{t} + k];
      const std::uint32_t first = first_at_vertex_[vertex];
      if (first != kNoNode) {
        const std::uint8_t place = recall(vertex, source(t, k));
        codes_.push_back(place);
        if (place > 0) {
          node(t, k) = first_at_vertex_[vertex];
          continue;
        }
      }
      add_node(t, k, [&](std::size_t c) { return corner_guess(t, k, first, c); });
      next_at_vertex_.back() = first;
      first_at_vertex_[vertex] = node(t, k);
    }
  }

  /// A corner is like the one before it in the triangle, else like the vertex's other side, else
  /// like the last.
  std::int32_t corner_guess(std::uint32_t t, std::uint32_t k, std::uint32_t other, std::size_t c) {
    if (k == 2) return floor_divided(value(node(t, 0), c) + value(node(t, 1), c), 2);
    if (k == 1) return value(node(t, 0), c);
    if (other != kNoNode) return value(other, c);
    return source_.empty() ? 0 : value(static_cast<std::uint32_t>(source_.size() - 1), c);
  }

  void add_edges(std::uint32_t t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t mate = mesh_.mate[3 * std::size_t{t} + k];
      if (mate != kNoHalfEdge) {
        const bool shared = share_edge(t, k, mate);
        codes_.push_back(shared ? 1 : 0);
        if (shared) continue;
      }
      const std::uint32_t a = node(t, k), b = node(t, (k + 1) % 3);
      const auto third = [&](std::uint32_t near, std::uint32_t far) {
        return [this, near, far](std::size_t c) {
          return floor_divided(2 * value(near, c) + value(far, c) + 1, 3);
        };
      };
      add_node(t, near_node(k), third(a, b));
      add_node(t, far_node(k), third(b, a));
    }
  }

  bool share_edge(std::uint32_t t, std::uint32_t k, std::uint32_t mate) {
    const bool same_way = mesh_.corner_vertex[mate] == mesh_.corner_vertex[3 * std::size_t{t} + k];
    const std::uint32_t other = mate / 3, slot = near_node(mate % 3);
    const std::uint32_t first = node(other, slot + (same_way ? 0 : 1));
    const std::uint32_t second = node(other, slot + (same_way ? 1 : 0));
    if (source_[first] != source(t, near_node(k)) || source_[second] != source(t, far_node(k)))
      return false;
    node(t, near_node(k)) = first;
    node(t, far_node(k)) = second;
    return true;
  }

  /// Adds the node of the centre, predicted as the value of a quadratic polynomial there.
  void add_center(std::uint32_t t) {
    add_node(t, kCenterNode, [&](std::size_t c) {
      std::int32_t corners = 0, edges = 0;
      for (std::uint32_t slot = 0; slot < 3; ++slot) corners += value(node(t, slot), c);
      for (std::uint32_t slot = 3; slot < kCenterNode; ++slot) edges += value(node(t, slot), c);
      return floor_divided(3 * edges - 2 * corners + 6, 12);
    });
  }

  void flush() {
    out_.counted(codes_);
    out_.varint(misses_.empty() ? 0 : misses_[0].size());
    for (std::vector<std::uint32_t>& miss : misses_) {
      out_.planes(miss, kResidualBytes);
      miss.clear();
    }
    codes_.clear();
  }

  Context& context_;
  const PatchField& field_;
  const ViewerMesh& mesh_;
  std::size_t channels_;
  TableMemory memory_{"the viewer's nodes"};
  std::vector<double> step_;                        ///< per channel
  std::vector<std::uint32_t> node_;                 ///< kNodesPerTriangle per triangle
  std::vector<std::uint32_t> source_;               ///< per node: the layer's
  std::vector<std::int32_t> value_;                 ///< channels_ per node, steps
  std::vector<std::uint32_t> first_at_vertex_;      ///< its nodes, the last used first
  std::vector<std::uint32_t> next_at_vertex_;       ///< per node
  std::vector<std::vector<std::uint32_t>> misses_;  ///< per channel
  std::vector<std::uint8_t> codes_;
  ByteWriter& out_;
};

}  // namespace

double viewer_step(InterpolationSpace space) {
  switch (space) {
    case InterpolationSpace::srgb:
      break;
    case InterpolationSpace::linear:
      return 1.0 / 8192;
    case InterpolationSpace::oklab:
      return 1.0 / 4096;
  }
  return 0.5 / 255;
}

Status write_field(Context& context, const PatchField& field, const ViewerMesh& mesh, double step,
                   ByteWriter& out) {
  return FieldWriter(context, field, mesh, step, out).run();
}

}  // namespace sfumato::outputs
