#include "allocation/failing_allocator.hpp"

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>

#include "support/sanitizers.hpp"

namespace sfumato::test {
namespace {

// A replacement of malloc cannot receive parameters, so this program's allocator has globals.
constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();
std::atomic<std::size_t> request_count{0};
std::atomic<std::size_t> first_refused{kNever};
std::atomic<std::size_t> last_refused{kNever};
std::atomic<std::ptrdiff_t> live_count{0};

bool is_refused() {
  const std::size_t first = first_refused.load(std::memory_order_relaxed);
  if (first == kNever) return false;
  const std::size_t request = request_count.fetch_add(1, std::memory_order_relaxed);
  return request >= first && request <= last_refused.load(std::memory_order_relaxed);
}

/// Counts an allocated block.
void* counted(void* block) {
  if (block != nullptr) live_count.fetch_add(1, std::memory_order_relaxed);
  return block;
}

void count_freed(const void* block) {
  if (block != nullptr) live_count.fetch_sub(1, std::memory_order_relaxed);
}

}  // namespace

RefusedAllocations::RefusedAllocations(std::size_t k, Refusal refusal) {
  request_count = 0;
  last_refused = refusal == Refusal::one ? k : kNever - 1;
  first_refused = k;
}

RefusedAllocations::~RefusedAllocations() {
  first_refused = kNever;
}

std::size_t RefusedAllocations::requests() {
  return request_count;
}

std::ptrdiff_t live_allocations() {
  return live_count;
}

}  // namespace sfumato::test

using sfumato::test::count_freed;
using sfumato::test::counted;
using sfumato::test::is_refused;

#if !SFUMATO_HAS_SANITIZER && defined(__GLIBC__)

// glibc's own functions, under the names that it provides for replacements of malloc.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) {
  if (!is_refused()) return counted(__libc_malloc(size));
  errno = ENOMEM;
  return nullptr;
}

void* calloc(std::size_t count, std::size_t size) {
  if (!is_refused()) return counted(__libc_calloc(count, size));
  errno = ENOMEM;
  return nullptr;
}

void* realloc(void* block, std::size_t size) {
  if (block == nullptr) return malloc(size);
  if (!is_refused()) {
    if (size == 0) count_freed(block);
    return __libc_realloc(block, size);
  }
  errno = ENOMEM;
  return nullptr;
}

void* memalign(std::size_t alignment, std::size_t size) {
  if (!is_refused()) return counted(__libc_memalign(alignment, size));
  errno = ENOMEM;
  return nullptr;
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  *block = memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}

void free(void* block) {
  count_freed(block);
  __libc_free(block);
}
}

#else

// Blocks come from the sanitizer, so that it still detects leaks.
void* operator new(std::size_t size) {
  void* block = is_refused() ? nullptr : counted(std::malloc(size == 0 ? 1 : size));
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void* operator new[](std::size_t size) {
  return operator new(size);
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return is_refused() ? nullptr : counted(std::malloc(size == 0 ? 1 : size));
}

void* operator new[](std::size_t size, const std::nothrow_t& nothrow) noexcept {
  return operator new(size, nothrow);
}

void operator delete(void* block) noexcept {
  count_freed(block);
  std::free(block);
}

void operator delete[](void* block) noexcept {
  operator delete(block);
}

void operator delete(void* block, std::size_t) noexcept {
  operator delete(block);
}

void operator delete[](void* block, std::size_t) noexcept {
  operator delete(block);
}

#endif
