#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gather/point_source.hpp"
#include "gpu/device.hpp"
#include "gpu/walk_program.hpp"
#include "gpu/walk_tables.hpp"

namespace sfumato::gpu {

/// Gathers lists of points on a device, in batches that take a fraction of a second each, so that
/// no watchdog of a driver ends them and work can be cancelled. Stays on one thread.
class Walker {
 public:
  /// Opens the device. Errors: unavailable, in words.
  static Result<std::unique_ptr<Walker>> create(const WalkShape& shape,
                                                const WalkLimits& limits = {});

  const std::string& device_name() const { return device_->name(); }

  /// Does PointSource::sum(). After the error `unavailable` the device is unusable.
  Status sum(Context& context, const gather::Scene& scene, std::span<const gather::WalkPoint> point,
             std::span<float> sums);

 private:
  Walker(std::unique_ptr<Device> device, const WalkShape& shape);
  Status read_limits(const WalkLimits& limits);
  Result<const Program*> program_of(const WalkTables& tables);
  const WalkTables& tables_of(const gather::Scene& scene);
  Status run(const Program& program, std::span<const gather::WalkPoint> point,
             std::span<float> sums);
  void learn_from(double seconds, std::size_t points);

  std::unique_ptr<Device> device_;
  WalkShape shape_;
  std::size_t largest_block_ = 0;  ///< bytes of a storage block
  std::size_t batch_;              ///< points at once
  std::optional<Program> sharp_, blended_;
  std::vector<WalkTables> tables_;  ///< the last used is the last
  GlObject point_buffer_, result_buffer_;
};

}  // namespace sfumato::gpu
