#include "sfumato/gpu/gather.hpp"

#include <utility>

#include "base/no_throw.hpp"
#include "base/try.hpp"
#include "gpu/gather_device.hpp"

namespace sfumato {

Result<GpuGather> GpuGather::create() {
  return no_throw([]() -> Result<GpuGather> {
    SFUMATO_TRY_ASSIGN(auto&& device, gpu::GatherDevice::create());
    return GpuGather(device.release());
  });
}

GpuGather::GpuGather(GpuGather&& other) noexcept : device_(std::exchange(other.device_, nullptr)) {}

GpuGather& GpuGather::operator=(GpuGather&& other) noexcept {
  std::swap(device_, other.device_);
  return *this;
}

GpuGather::~GpuGather() {
  delete device_;
}

PointSource* GpuGather::source() const {
  return device_;
}

std::string GpuGather::device_name() const {
  return device_ ? device_->name() : std::string();
}

bool GpuGather::is_lost() const {
  return device_ && device_->is_lost();
}

}  // namespace sfumato
