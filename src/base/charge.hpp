#pragma once

#include <cstddef>
#include <string_view>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// A charge that gives itself back at the end of its scope. It belongs to one Budget, that of the
/// first Context that it is charged to, which must outlive it. Movable.
class ScopedCharge {
 public:
  ScopedCharge() = default;
  ScopedCharge(ScopedCharge&& other) noexcept : budget_(other.budget_), bytes_(other.bytes_) {
    other.budget_ = nullptr;
  }
  ScopedCharge& operator=(ScopedCharge&& other) noexcept;
  ~ScopedCharge();

  /// Charges `bytes` more; on failure nothing changes. What has a Budget already stays with it,
  /// whichever Context does the work now.
  Status add(Context& context, std::size_t bytes, std::string_view purpose);

 private:
  Budget* budget_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace sfumato
