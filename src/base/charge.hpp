#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// A charge that gives itself back at the end of its scope. It belongs to one Budget, that of the
/// first Context that it is charged to, which must outlive it. Movable.
///
/// Tables take their room from a TableMemory, which charges what it allocates. This is for what
/// allocates by itself: other libraries, and objects that bytes_of() measures once they are there.
class ScopedCharge {
 public:
  ScopedCharge() = default;
  /// Of this Budget, before anything is charged.
  explicit ScopedCharge(Budget& budget) : budget_(&budget) {}
  ScopedCharge(ScopedCharge&& other) noexcept
      : budget_(std::exchange(other.budget_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
  ScopedCharge& operator=(ScopedCharge&& other) noexcept;
  ~ScopedCharge();

  /// Charges `bytes` more; on failure nothing changes. What has a Budget already stays with it,
  /// whichever Context does the work now.
  Status add(const Context& context, std::size_t bytes, std::string_view purpose);

  /// Charges what is lacking of `bytes` in all: for what grows and is measured now and then.
  Status raise_to(const Context& context, std::size_t bytes, std::string_view purpose) {
    return bytes > bytes_ ? add(context, bytes - bytes_, purpose) : ok_status();
  }

  /// Gives `bytes` back; more than is charged counts as all of it.
  void release(std::size_t bytes);

  /// Takes over the charge of `other`, which belongs to the same Budget or to none.
  void take(ScopedCharge&& other);

 private:
  Budget* budget_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace sfumato
