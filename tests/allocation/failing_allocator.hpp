#pragma once

#include <cstddef>

/// This program's allocator for C and C++, which can refuse requests. C libraries (zlib, libspng,
/// libjpeg, libwebp) and pugixml use it too. With sanitizers, whose allocator cannot be replaced,
/// it only covers C++'s operator new.
namespace sfumato::test {

enum class Refusal {
  one,      ///< the k-th request
  all_from  ///< the k-th and every one after it
};

/// Refuses the k-th request of memory (from 0) on any thread during its lifetime. Only one may
/// exist at a time.
class RefusedAllocations {
 public:
  RefusedAllocations(std::size_t k, Refusal refusal);
  ~RefusedAllocations();
  RefusedAllocations(const RefusedAllocations&) = delete;
  RefusedAllocations& operator=(const RefusedAllocations&) = delete;

  /// Returns the number of requests since the start.
  static std::size_t requests();
};

/// Returns the number of blocks of the whole program that are allocated and not freed.
std::ptrdiff_t live_allocations();

}  // namespace sfumato::test
