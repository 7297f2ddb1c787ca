#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "solve/layers/layer_solver.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {

/// The progress of several layers that are solved at the same time: the completed share of the
/// whole, which never falls.
class SharedProgress {
 public:
  /// total   the sum of all calls of add()
  SharedProgress(Progress* progress, double total) : progress_(progress), total_(total) {}

  /// Reports progress, from any thread. If two calls overlap, one of them reports.
  void add(double done);

 private:
  Progress* progress_;
  double total_;
  std::atomic<double> done_{0};
  std::atomic_flag is_telling_;
};

/// A layer to be solved.
struct LayerTask {
  std::uint32_t layer = 0;      ///< index into Document::layers
  LayerSight sight{};           ///< sight_of_layer()
  std::uint64_t last_drag = 0;  ///< KeptLayer::last_drag
};

/// Solves layers of a document that validate() accepts.
///
/// With threads all layers are solved in parallel, the largest first, and so are their fields. That
/// takes more memory than one after another. Where it is not enough, layers from the first failed
/// one on are solved again as on one thread, one after another. Memory that is enough for one
/// thread is therefore enough for many. Any other failure is that of the first layer that fails.
class LayerRuns {
 public:
  /// Keeps references: all arguments must outlive this.
  ///
  /// tasks      in the order of their layers
  /// most_kept  keeps the tables for take_refined(), which takes more memory, of layers with at
  /// most
  ///            this many triangles: layers_beyond(); on several threads of all until the end of
  ///            run()
  LayerRuns(Context& context, const Document& document, std::span<const LayerTask> tasks,
            const DiffuseOptions& options, std::optional<std::size_t> most_kept = {});

  /// Solves all tasks. Errors: limit, cancelled, out_of_memory.
  Status run();

  /// Adds the statistics of all layers.
  void add_to(DiffuseStats& stats) const;

  /// Returns the layers, in the order of the tasks. Their charges end.
  std::vector<PatchLayer> take();

  /// Returns the layer of a task that was finished, whether or not all were, unless it was taken.
  /// Its charge ends.
  std::optional<PatchLayer> take_finished(std::uint32_t task);

  /// Returns the kept tables of a task's layer, unless they were taken.
  std::optional<RefinedLayer> take_refined(std::uint32_t task);

 private:
  struct Run {
    PatchLayer layer;
    DiffuseStats stats;
    ScopedCharge charge;  ///< for the layer
    Status status;
    double told = 0;           ///< reported progress
    bool is_prepared = false;  ///< after the part that both ways share
    bool is_finished = false;
    std::optional<RefinedLayer> refined{};
  };

  Status make_tables();
  Status run_side_by_side();
  void run_beside(std::uint32_t index);
  bool may_succeed_by_itself(const Run& failed) const;
  Status run_one_by_one();
  Status solve(std::uint32_t index, bool side_by_side);
  Result<PatchLayer> solve_layer(std::uint32_t index, DiffuseStats& stats, SolveWay way);
  /// Solves the layer with these options. Unless null, `has_border` gets LayerSolver::has_border().
  Result<PatchLayer> solve_layer_by(const DiffuseOptions& options, std::uint32_t index,
                                    DiffuseStats& stats, SolveWay way, bool* has_border = nullptr);
  void give_up_beyond();
  double work_of(std::uint32_t index) const;
  double total_work() const;
  std::uint32_t task_count() const { return static_cast<std::uint32_t>(tasks_.size()); }

  Context& context_;
  const Document& document_;
  std::span<const LayerTask> tasks_;
  const DiffuseOptions& options_;
  std::optional<std::size_t> most_kept_;
  SharedProgress progress_;
  std::vector<Run> runs_;             ///< per task
  std::vector<std::uint32_t> order_;  ///< of tasks, the largest layer first
  std::atomic<std::uint32_t> first_failed_;
  TableMemory memory_{"layers"};
};

}  // namespace sfumato::solve
