#include "gather/rows.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/limit_error.hpp"
#include "base/parallel.hpp"
#include "gather/locate.hpp"
#include "gather/row_sources.hpp"
#include "gather/row_walk.hpp"
#include "gather/scene.hpp"

namespace sfumato::gather {
namespace {

constexpr std::size_t kPointsPerBlock = 256;
/// Blocks are gathered side by side, then their terms appended in order: so few wait at a time.
constexpr std::size_t kBlocksPerWave = 64;

class RowGather {
 public:
  RowGather(Context& context, const mesh::TriangleMesh& mesh, std::span<const Vec2> points,
            const RowOptions& options)
      : context_(context), mesh_(mesh), points_(points), options_(options) {}

  Result<Rows> run(const curves::SegmentAttributes& places) {
    Status status = prepare(places);
    for (std::size_t i = 0; status && i < points_.size(); i += kBlocksPerWave * kPointsPerBlock)
      status = add_wave(i, std::min(i + kBlocksPerWave * kPointsPerBlock, points_.size()));
    if (!status) return status;
    rows_.source = std::move(sources_.source);
    sources_.memory.free(sources_.weight);
    sources_.memory.free(sources_.at_half_edge);
    rows_.memory.take(std::move(sources_.memory));
    return std::move(rows_);
  }

 private:
  struct Block {
    std::vector<RowTerm> term;
    std::vector<std::uint32_t> end;  ///< per point: of its terms
    std::size_t known_bytes = 0;
    TableMemory memory{"rows of the gather"};
  };

  Status prepare(const curves::SegmentAttributes& places) {
    Result<RowSources> sources = find_row_sources(context_, mesh_, places);
    if (!sources) return sources.status();
    sources_ = std::move(*sources);
    Status status = locate(places);
    if (status) status = rows_.memory.reserve(context_, rows_.begin, points_.size() + 1);
    if (status) rows_.begin.push_back(0);
    return status;
  }

  /// In single precision, up to which a point is near the triangle that it gets.
  Status locate(const curves::SegmentAttributes& places) {
    if (mesh_.triangle_count() == 0) return ok_status();
    const Result<Scene> scene = build_scene(context_, mesh_, places, {.will_be_extended = true});
    if (!scene) return scene.status();
    const Result<Locator> locator = Locator::create(context_, *scene);
    if (!locator) return locator.status();
    Result<LocatedPoints> located = locator->locate(context_, points_);
    if (!located) return located.status();
    triangle_ = std::move(located->triangle);
    memory_.take(std::move(located->memory));
    for (std::uint32_t& t : triangle_) t = scene->source[t];
    return context_.check();
  }

  Status add_wave(std::size_t first, std::size_t last) {
    const Status status = try_parallel_for(
        context_, last - first, kPointsPerBlock, [&](std::size_t begin, std::size_t end) {
          return gather(first + begin, first + end, block_[begin / kPointsPerBlock]);
        });
    return status ? append(first, last) : status;
  }

  Status gather(std::size_t begin, std::size_t end, Block& block) const {
    RowWalk walk(context_, mesh_, sources_, options_);
    std::size_t known_walk_bytes = 0;
    TableMemory memory("the walk of rows");
    block.term.clear();
    block.end.clear();
    for (std::size_t i = begin; i < end; ++i) {
      if (!triangle_.empty()) walk.add(points_[i], triangle_[i], block.term);
      block.end.push_back(static_cast<std::uint32_t>(block.term.size()));
      if (walk.cancelled()) return context_.cancel_status();
      Status status = memory.settle(context_, walk.bytes(), known_walk_bytes);
      if (status) {
        const std::size_t bytes = capacity_bytes(block.term, block.end);
        status = block.memory.settle(context_, bytes, block.known_bytes);
      }
      if (!status) return status;
    }
    return ok_status();
  }

  /// The terms of a wave's blocks.
  Status append(std::size_t first, std::size_t last) {
    std::size_t count = rows_.term.size();
    const std::size_t blocks = (last - first + kPointsPerBlock - 1) / kPointsPerBlock;
    for (std::size_t b = 0; b < blocks; ++b) count += block_[b].term.size();
    if (count > std::numeric_limits<std::uint32_t>::max()) {
      return make_limit_error("memory", "rows have too many terms: 4 billion are the most");
    }
    Status status = make_room(count, last);
    for (std::size_t b = 0; status && b < blocks; ++b) {
      const auto base = static_cast<std::uint32_t>(rows_.term.size());
      for (const std::uint32_t end : block_[b].end) rows_.begin.push_back(base + end);
      status = rows_.memory.append(context_, block_[b].term, rows_.term);
    }
    return status;
  }

  /// For so many terms of the points before `last`, and for the others if these have as many each:
  /// a table that grows is twice in memory.
  Status make_room(std::size_t count, std::size_t last) {
    if (count <= rows_.term.capacity()) return ok_status();
    const double points = static_cast<double>(points_.size()) / static_cast<double>(last);
    const double expected = 1.05 * static_cast<double>(count) * points;
    if (rows_.memory.reserve(context_, rows_.term, static_cast<std::size_t>(expected)))
      return ok_status();
    return rows_.memory.reserve(context_, rows_.term, count);
  }

  Context& context_;
  const mesh::TriangleMesh& mesh_;
  std::span<const Vec2> points_;
  RowOptions options_;
  RowSources sources_;
  std::vector<std::uint32_t> triangle_;  ///< of the mesh, per point; empty where it has none
  std::array<Block, kBlocksPerWave> block_;
  Rows rows_;
  TableMemory memory_{"the points to gather at"};
};

}  // namespace

Result<Rows> gather_rows(Context& context, const mesh::TriangleMesh& mesh,
                         const curves::SegmentAttributes& places, std::span<const Vec2> points,
                         const RowOptions& options) {
  if (points.size() > context.limits.nodes) {
    return limit_error(context.limits, &Limits::nodes, "points to gather at");
  }
  return RowGather(context, mesh, points, options).run(places);
}

}  // namespace sfumato::gather
