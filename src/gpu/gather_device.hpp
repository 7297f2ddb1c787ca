#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "gather/point_source.hpp"
#include "gpu/walk_program.hpp"

namespace sfumato::gpu {

class Walker;

/// Faults that tests inject.
struct GatherFaults {
  int lost_after = std::numeric_limits<int>::max();  ///< calls of sum() that succeed
  WalkLimits limits{};
};

/// Gathers by compute shaders. A separate thread owns the context, since a context belongs to one
/// thread and several threads request points. They take turns.
class GatherDevice final : public PointSource {
 public:
  /// Opens the device. Errors: unavailable, in words; out_of_memory.
  static Result<std::unique_ptr<GatherDevice>> create(const WalkShape& shape = {},
                                                      const GatherFaults& faults = {});
  ~GatherDevice() override;
  GatherDevice(const GatherDevice&) = delete;
  GatherDevice& operator=(const GatherDevice&) = delete;

  const std::string& name() const { return name_; }
  /// Returns whether the device no longer responds.
  bool is_lost() const { return is_lost_; }

  std::size_t least_points() const override;
  Status sum(Context& context, const gather::Scene& scene, std::span<const gather::WalkPoint> point,
             std::span<float> sums) override;

 private:
  explicit GatherDevice(const GatherFaults& faults);
  void serve();
  /// Makes the thread call `job`, and waits for it.
  Status do_there(const std::function<Status()>& job);

  GatherFaults faults_;
  std::string name_;
  std::unique_ptr<Walker> walker_;  ///< owned by the thread
  std::atomic<bool> is_lost_ = false;

  std::mutex turn_;  ///< held by the caller that waits for a job
  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<Status()>* job_ = nullptr;  ///< null: there is none
  Status result_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace sfumato::gpu
