#include "gpu/gather_device.hpp"

#include <system_error>
#include <utility>

#include "base/no_throw.hpp"
#include "base/try.hpp"
#include "gpu/walker.hpp"

namespace sfumato::gpu {
namespace {

/// A round trip to the device takes as long as the CPU's packets take for about this many points.
constexpr std::size_t kLeastPoints = 1000;

}  // namespace

Result<std::unique_ptr<GatherDevice>> GatherDevice::create(const WalkShape& shape,
                                                           const GatherFaults& faults) {
  std::unique_ptr<GatherDevice> device(new GatherDevice(faults));
  try {
    device->thread_ = std::thread([&it = *device] { it.serve(); });
  } catch (const std::system_error&) {
    return make_error(StatusCode::unavailable, "no GPU can be used: no thread can be started");
  }
  Status status = device->do_there([&]() -> Status {
    SFUMATO_TRY_ASSIGN(device->walker_, Walker::create(shape, faults.limits));
    device->name_ = device->walker_->device_name();
    return ok_status();
  });
  if (!status) return status;
  return device;
}

GatherDevice::GatherDevice(const GatherFaults& faults) : faults_(faults) {}

GatherDevice::~GatherDevice() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void GatherDevice::serve() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return job_ || ends_; });
    if (!job_) break;
    lock.unlock();
    Status status = no_throw(*job_);
    lock.lock();
    result_ = std::move(status);
    job_ = nullptr;
    changed_.notify_all();
  }
  walker_.reset();
}

Status GatherDevice::do_there(const std::function<Status()>& job) {
  const std::lock_guard turn(turn_);
  std::unique_lock lock(mutex_);
  job_ = &job;
  changed_.notify_all();
  changed_.wait(lock, [&] { return !job_; });
  return std::move(result_);
}

std::size_t GatherDevice::least_points() const {
  return is_lost_ ? std::numeric_limits<std::size_t>::max() : kLeastPoints;
}

Status GatherDevice::sum(Context& context, const gather::Scene& scene,
                         std::span<const gather::WalkPoint> point, std::span<float> sums) {
  Status status = do_there([&]() -> Status {
    if (is_lost_ || faults_.lost_after-- <= 0)
      return make_error(StatusCode::unavailable, name_ + " does not answer any more");
    return walker_->sum(context, scene, point, sums);
  });
  if (status.code == StatusCode::unavailable) is_lost_ = true;
  return status;
}

}  // namespace sfumato::gpu
