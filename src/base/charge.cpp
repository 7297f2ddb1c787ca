#include "base/charge.hpp"

#include <utility>

namespace sfumato {

ScopedCharge& ScopedCharge::operator=(ScopedCharge&& other) noexcept {
  std::swap(budget_, other.budget_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

ScopedCharge::~ScopedCharge() {
  if (budget_) budget_->release(bytes_);
}

Status ScopedCharge::add(Context& context, std::size_t bytes, std::string_view purpose) {
  Budget& budget = budget_ ? *budget_ : context.budget;
  Status status = budget.charge(bytes, purpose);
  if (!status) return status;
  budget_ = &budget;
  bytes_ += bytes;
  return status;
}

}  // namespace sfumato
