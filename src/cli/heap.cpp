#include "cli/heap.hpp"

#include <cstdint>
#include <cstdlib>

#if defined(__GLIBC__)  // which <cstdlib> defines
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace sfumato::cli {

#if defined(__GLIBC__)
namespace {

constexpr int kMiB = 1 << 20;
constexpr int kLargePageBytes = 2 * kMiB;
constexpr int kLargePagedBytes = 128 * kMiB;
constexpr int kUsualPad = 128 << 10;  ///< glibc's default of M_TOP_PAD

std::uintptr_t heap_end() {
  return reinterpret_cast<std::uintptr_t>(sbrk(0));
}

bool has_bounded_addresses() {
  rlimit limit{};
  return getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

/// Makes the heap grow by kLargePagedBytes at once, and asks for large pages there. malloc's own
/// setting, glibc.malloc.hugetlb, is read from the environment only, when the program starts. If
/// the system refuses, the heap grows in small steps as usual.
void ask_for_large_pages() {
  const std::uintptr_t begin = heap_end();
  mallopt(M_TOP_PAD, kLargePagedBytes);
  void* volatile block = std::malloc(kMiB);  // volatile: compilers leave unused blocks out
  std::free(block);
  mallopt(M_TOP_PAD, kUsualPad);
  const std::uintptr_t first = (begin + kLargePageBytes - 1) / kLargePageBytes * kLargePageBytes;
  const std::uintptr_t end = heap_end() / kLargePageBytes * kLargePageBytes;
  if (first < end) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

}  // namespace

void prepare_heap() {
  mallopt(M_MMAP_THRESHOLD, 32 * kMiB);
  mallopt(M_TRIM_THRESHOLD, 1024 * kMiB);
  if (!has_bounded_addresses()) ask_for_large_pages();
}

void return_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, kMiB);
  mallopt(M_TRIM_THRESHOLD, kMiB / 8);
}
#else
void prepare_heap() {}
void return_freed_memory() {}
#endif

}  // namespace sfumato::cli
