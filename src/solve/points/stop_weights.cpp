#include "solve/points/stop_weights.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "gather/rows/rows.hpp"
#include "mesh/mesher.hpp"
#include "solve/fields/field_mesh.hpp"
#include "solve/layers/layer_units.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {
namespace {

/// The fewest rows that one task makes, and the most columns for which it may keep a number each.
constexpr std::size_t kRows = 256;
constexpr std::size_t kColumnsPerRow = 16;

/// The rows of one task.
struct RowBlock {
  std::vector<std::uint32_t> count;  ///< per row
  std::vector<std::uint32_t> column;
  std::vector<float> weight;
  std::size_t known_bytes = 0;  ///< of the entries
  TableMemory memory{"weights of stops"};
};

/// Makes rows from the terms of points.
class RowMaker {
 public:
  RowMaker(const gather::Rows& rows, std::size_t shader_count)
      : rows_(rows), shader_count_(shader_count) {}

  /// Prepares the maker. Errors: limit (memory), cancelled.
  Status prepare(const Context& context, std::size_t column_count) {
    return memory_.resize(context, sum_, column_count, kNotMet);
  }

  /// paint   of the point
  void add(std::size_t point, std::span<float> paint, RowBlock& block) {
    for (std::uint32_t k = rows_.begin[point]; k < rows_.begin[point + 1]; ++k) {
      const gather::RowTerm& term = rows_.term[k];
      const gather::RowSource& source = rows_.source[term.source];
      const double radius = gather::radius_at(source, term.moment);
      gather::for_each_entry(source, term, radius, [&](std::uint32_t column, double weight) {
        if (sum_[column] < 0) {
          met_.push_back(column);
          sum_[column] = 0;
        }
        sum_[column] += weight;
      });
      if (shader_count_ == 0) continue;
      gather::for_each_side(source, term, radius, [&](const gather::RowSide& side, double weight) {
        if (side.shader >= 0) {
          paint[static_cast<std::size_t>(side.shader)] += static_cast<float>(weight);
        }
      });
    }
    store(block);
  }

 private:
  static constexpr double kNotMet = -1;

  void store(RowBlock& block) {
    std::ranges::sort(met_);
    for (const std::uint32_t column : met_) {
      block.column.push_back(column);
      block.weight.push_back(static_cast<float>(std::exchange(sum_[column], kNotMet)));
    }
    block.count.push_back(static_cast<std::uint32_t>(met_.size()));
    met_.clear();
  }

  const gather::Rows& rows_;
  std::size_t shader_count_;
  std::vector<double> sum_;         ///< per column; kNotMet: not in this row
  std::vector<std::uint32_t> met_;  ///< columns of this row
  TableMemory memory_{"weights of stops"};
};

/// grain   rows of a block
Status join(Context& context, const std::vector<RowBlock>& blocks, std::size_t grain,
            WeightRows& out) {
  std::size_t rows = 0, entries = 0;
  for (const RowBlock& block : blocks) {
    rows += block.count.size();
    entries += block.column.size();
  }
  if (entries > std::numeric_limits<std::uint32_t>::max()) {
    return make_limit_error("memory", "too many weights of stops: 4 billion are the most");
  }
  SFUMATO_TRY(out.memory.reserve(context, out.begin, rows + 1));
  SFUMATO_TRY(out.memory.resize(context, out.column, entries));
  SFUMATO_TRY(out.memory.resize(context, out.weight, entries));
  out.begin.push_back(0);
  for (const RowBlock& block : blocks) {
    for (const std::uint32_t count : block.count) out.begin.push_back(out.begin.back() + count);
  }
  return parallel_for(context, blocks.size(), 1, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) {
      const auto at = static_cast<std::ptrdiff_t>(out.begin[i * grain]);
      std::ranges::copy(blocks[i].column, out.column.begin() + at);
      std::ranges::copy(blocks[i].weight, out.weight.begin() + at);
    }
  });
}

Result<curves::SegmentAttributes> sample_values(const Context& context,
                                                const curves::FlatCurves& flat,
                                                const Document& document, std::uint32_t layer,
                                                StopAttribute attribute, TableMemory& memory) {
  const std::vector<Curve>& curves = document.layers[layer].curves;
  return attribute == StopAttribute::color
             ? curves::sample_colors(context, flat, curves, document.interpolation, memory)
             : curves::sample_opacities(context, flat, curves, memory);
}

}  // namespace

Result<StopWeights> StopWeights::create(Context& context, const Document& document,
                                        std::uint32_t layer, StopAttribute attribute,
                                        const DiffuseOptions& options) {
  SFUMATO_TRY(validate(options));
  const std::vector<Curve>& curves = document.layers[layer].curves;
  StopWeights out;
  out.column_count_ = static_cast<std::uint32_t>(curves::stop_count(curves, attribute));
  const LayerSight sight =
      sight_of_layer(document, layer, options.viewport.value_or(document.artboard));
  if (sight.viewport.empty() || curves.empty()) return out;
  const LayerUnits units(document.artboard, sight, options);
  SFUMATO_TRY_ASSIGN(auto&& flat, flatten_layer(context, document.layers[layer], sight, units));
  ScopedCharge flat_charge;
  SFUMATO_TRY(flat_charge.add(context, curves::bytes_of(flat), "flattening"));
  SFUMATO_TRY_ASSIGN(auto&& values,
                     sample_values(context, flat, document, layer, attribute, out.memory_));
  SFUMATO_TRY_ASSIGN(auto&& places,
                     curves::sample_stop_places(context, flat, curves, attribute, out.memory_));
  SFUMATO_TRY_ASSIGN(auto&& mesher, mesh::Mesher::build(context, flat, units.mesh_options()));
  SFUMATO_TRY_ASSIGN(auto&& mesh, mesher.visibility_mesh(context));
  SFUMATO_TRY_ASSIGN(auto&& field, mesh_field(context, mesher, mesh, values));
  out.mesh_ = field.is_thinned ? std::move(field.thinned) : std::move(mesh);
  out.memory_.take(field.is_thinned ? std::move(field.memory) : mesher.release_extracted());
  out.values_ = std::move(values);
  out.places_ = std::move(places);
  if (options.ignore_blur) {
    curves::remove_blur(out.values_);
    curves::remove_blur(out.places_);
  }
  out.frame_ = sight.viewport;
  return out;
}

Result<WeightRows> StopWeights::at(Context& context, std::span<const Vec2> points,
                                   float negligible) const {
  WeightRows out;
  if (frame_.empty()) {
    SFUMATO_TRY(out.memory.resize(context, out.begin, points.size() + 1));
    return out;
  }
  RarePoll<4096> poll(context);
  for (const Vec2 point : points) {
    if (poll.cancelled()) return context.cancel_status();
    if (!frame_.contains(point)) {
      return make_error(StatusCode::bad_input, "a point outside what was prepared");
    }
  }
  SFUMATO_TRY_ASSIGN(const gather::Rows& rows,
                     gather::gather_rows(context, mesh_, places_, points,
                                         {.negligible = negligible, .values = &values_}));
  const std::size_t shader_count = shaders().size();
  SFUMATO_TRY(out.memory.resize(context, out.paint, shader_count * points.size()));
  const std::size_t grain = std::max(kRows, column_count_ / kColumnsPerRow);
  std::vector<RowBlock> blocks((points.size() + grain - 1) / grain);
  Status status =
      try_parallel_for(context, points.size(), grain, [&](std::size_t i, std::size_t end) {
        RowMaker maker(rows, shader_count);
        RowBlock& block = blocks[i / grain];
        SFUMATO_TRY(maker.prepare(context, column_count_));
        for (; i < end; ++i) {
          if (context.cancelled()) return context.cancel_status();
          maker.add(i, std::span(out.paint).subspan(shader_count * i, shader_count), block);
          SFUMATO_TRY(block.memory.settle(context, capacity_bytes(block.column, block.weight),
                                          block.known_bytes));
        }
        return ok_status();
      });
  if (status) status = join(context, blocks, grain, out);
  if (!status) return status;
  return out;
}

}  // namespace sfumato::solve
