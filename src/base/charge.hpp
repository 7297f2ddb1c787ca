#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// A charge that is released at the end of its scope. It belongs to one Budget, that of the first
/// Context to which it is charged, which must outlive it. Movable.
///
/// Use a TableMemory for tables: it charges its allocations itself. Use this class for memory that
/// is allocated elsewhere: by other libraries, and by objects that bytes_of() measures once they
/// exist.
class ScopedCharge {
 public:
  ScopedCharge() = default;
  /// Belongs to this Budget from the start.
  explicit ScopedCharge(Budget& budget) : budget_(&budget) {}
  ScopedCharge(ScopedCharge&& other) noexcept
      : budget_(std::exchange(other.budget_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
  ScopedCharge& operator=(ScopedCharge&& other) noexcept;
  ~ScopedCharge();

  /// Charges `bytes` more; on failure nothing changes. A charge that has a Budget already stays
  /// with it, whatever the Context.
  Status add(const Context& context, std::size_t bytes, std::string_view purpose);

  /// Raises the charge to `bytes` in all, for memory that grows and is measured from time to time.
  Status raise_to(const Context& context, std::size_t bytes, std::string_view purpose) {
    return bytes > bytes_ ? add(context, bytes - bytes_, purpose) : ok_status();
  }

  /// Releases `bytes`, but at most what is charged.
  void release(std::size_t bytes);

  /// Releases everything and belongs to no Budget any more. Returns the released bytes.
  std::size_t leave();

  /// Takes over the charge of `other`, which belongs to the same Budget or to none.
  void take(ScopedCharge&& other);

 private:
  Budget* budget_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace sfumato
