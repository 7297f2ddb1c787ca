#include "base/output_buffer.hpp"

#include <utility>

namespace sfumato {

void OutputBuffer::append_large(std::span<const std::uint8_t> bytes) {
  if (status_) fail(memory_.append(context_, bytes, bytes_));
}

void OutputBuffer::reserve(std::size_t size) {
  if (status_) fail(memory_.make_room(context_, bytes_, size));
}

void OutputBuffer::fail(Status status) {
  if (!status_ || status) return;
  status_ = std::move(status);
  memory_.free(bytes_);  // without room, later pieces are refused
}

Result<std::vector<std::uint8_t>> OutputBuffer::finish() {
  if (!status_) return status_;
  return std::move(bytes_);
}

}  // namespace sfumato
