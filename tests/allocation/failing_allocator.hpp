#pragma once

#include <cstddef>

/// This program's allocator: that of C and C++ both, which can be told to refuse. Libraries in C
/// (zlib, libspng, libjpeg, libwebp) and pugixml ask it too. In a build with sanitizers, whose own
/// allocator cannot be replaced, it is C++'s operator new alone.
namespace sfumato::test {

enum class Refusal {
  one,      ///< the k-th request
  all_from  ///< the k-th and every one after it
};

/// While it lives the k-th request of memory (from 0) is refused, on any thread. One at a time.
class RefusedAllocations {
 public:
  RefusedAllocations(std::size_t k, Refusal refusal);
  ~RefusedAllocations();
  RefusedAllocations(const RefusedAllocations&) = delete;
  RefusedAllocations& operator=(const RefusedAllocations&) = delete;

  /// How many requests were made since the start.
  static std::size_t requests();
};

/// Blocks that were handed out and not given back, of the whole program.
std::ptrdiff_t live_allocations();

}  // namespace sfumato::test
