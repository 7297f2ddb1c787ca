#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "gather/gather.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "solve/fields/nodes.hpp"
#include "solve/fields/probes.hpp"

namespace sfumato::solve {

/// Returns whether a field's values are code values from 0 to 1, the unit of misses.
bool has_code_values(const curves::SegmentAttributes& attributes);

/// The largest errors of patches.
struct MissLimit {
  float max_error;   ///< code values from 0 to 1, or the share of a shader
  PatchOrder order;  ///< of the patches
  /// Weight of colour errors in a triangle, at most 1.
  FunctionRef<float(std::uint32_t triangle)> color_weight;
  MissFactors factors{};
};

/// Finds the patches of a field that differ from the exact gather by more than a limit.
///
/// Few triangles are probed everywhere: triangles whose nodes predict a good patch are not probed;
/// others are probed at one or three places first, and elsewhere only if they miss there by a share
/// of the limit.
class MissSearch {
 public:
  /// The input of a search; all of it must outlive the search.
  struct Field {
    const mesh::TriangleMesh& mesh;
    const NodeLayout& layout;
    const curves::SegmentAttributes& attributes;
    const gather::Gatherer& gatherer;
    bool sees_everywhere;  ///< every node sees a curve
  };
  MissSearch(Context& context, const Field& field, const MissLimit& limit);

  /// Sets misses[t] for the triangles in `triangles` (ascending) whose patches miss, and for their
  /// neighbours where that happens on the common edge. Errors: limit (memory), cancelled.
  Status run(std::span<const std::uint32_t> triangles, std::span<std::uint8_t> misses);

 private:
  /// Lists in triangle_ and choice_ the probes that come first.
  Status choose(std::span<const std::uint32_t> triangles);
  ProbeChoice first_choice(std::uint32_t triangle, std::span<float> miss) const;
  /// Replaces these by the remaining probes of the triangles with is_unclear[t].
  void choose_rest(std::span<const std::uint8_t> is_unclear);
  void drop_unprobed();
  /// Gathers the probes and marks patches that miss, and patches that miss by a share of the limit
  /// in `is_unclear` unless that is empty.
  Status probe(std::span<std::uint8_t> misses, std::span<std::uint8_t> is_unclear);
  /// Measures the patch's error at probe i in each channel; also converts the exact value in place.
  void measure(const ProbeSet& probes, std::size_t i, float* exact, float* miss) const;
  /// Returns whether the error of any channel exceeds `most`. Errors of colours are multiplied by
  /// the weight, which is computed only if it affects the result.
  bool is_more(std::span<const float> miss, float most, std::uint32_t triangle) const;
  bool is_opacity(std::size_t channel) const;
  void show_as_code_values(float* value) const;
  std::size_t channel_count() const {
    return static_cast<std::size_t>(field_.layout.channel_count);
  }

  Context& context_;
  Field field_;
  MissLimit limit_;
  bool foretells_;
  TableMemory memory_{"probes of patches"};
  std::vector<std::uint32_t> triangle_;  ///< to be probed, ascending
  std::vector<ProbeChoice> choice_;      ///< and where
};

}  // namespace sfumato::solve
