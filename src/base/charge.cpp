#include "base/charge.hpp"

#include <algorithm>

#include "base/try.hpp"

namespace sfumato {

ScopedCharge& ScopedCharge::operator=(ScopedCharge&& other) noexcept {
  std::swap(budget_, other.budget_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

ScopedCharge::~ScopedCharge() {
  leave();
}

Status ScopedCharge::add(const Context& context, std::size_t bytes, std::string_view purpose) {
  Budget& budget = budget_ ? *budget_ : context.budget;
  SFUMATO_TRY(budget.charge(bytes, purpose));
  budget_ = &budget;
  bytes_ += bytes;
  return ok_status();
}

void ScopedCharge::release(std::size_t bytes) {
  const std::size_t given = std::min(bytes, bytes_);
  if (budget_) budget_->release(given);
  bytes_ -= given;
}

std::size_t ScopedCharge::leave() {
  if (budget_) budget_->release(bytes_);
  budget_ = nullptr;
  return std::exchange(bytes_, 0);
}

void ScopedCharge::take(ScopedCharge&& other) {
  if (!budget_) budget_ = other.budget_;
  bytes_ += std::exchange(other.bytes_, 0);
}

}  // namespace sfumato
