#include "hostile/pace.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>

#include "support/poll_recorder.hpp"

namespace sfumato::hostile {
namespace {

/// Of work() on the machine of kMostSeconds, quiet.
constexpr double kReferenceSeconds = 0.115;
constexpr double kMostSlowness = 3;

constexpr std::size_t kTouchedBytes = std::size_t{32} << 20;
constexpr std::size_t kPageBytes = 4096;
constexpr int kSteps = 30'000'000;

/// Steps of a generator, each of which needs the one before it.
std::uint64_t count_steps() {
  std::uint64_t state = 1;
  for (int i = 0; i < kSteps; ++i) state = state * 6364136223846793005u + 1442695040888963407u;
  return state;
}

void touch_memory() {
  void* memory =
      mmap(nullptr, kTouchedBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  auto* bytes = static_cast<volatile unsigned char*>(memory);
  for (std::size_t i = 0; i < kTouchedBytes; i += kPageBytes) bytes[i] = 1;
  munmap(memory, kTouchedBytes);
}

}  // namespace

double slowness() {
  const double begin = test::thread_seconds();
  const volatile std::uint64_t kept = count_steps();
  static_cast<void>(kept);
  touch_memory();
  return std::clamp((test::thread_seconds() - begin) / kReferenceSeconds, 1.0, kMostSlowness);
}

}  // namespace sfumato::hostile
