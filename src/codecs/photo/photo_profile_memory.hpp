#pragma once

#include <lcms2.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

struct DeleteProfileContext {
  void operator()(cmsContext library) const { cmsDeleteContext(library); }
};
using ProfileContext = std::unique_ptr<std::remove_pointer_t<cmsContext>, DeleteProfileContext>;

/// Allocates and charges the memory of lcms2. The library checks its large allocations, whose size
/// depends on the profile, but not all of its small ones. Small blocks therefore come from a table
/// that is allocated beforehand.
class ProfileMemory {
 public:
  explicit ProfileMemory(const Context& context) : context_(context) {}
  ProfileMemory(const ProfileMemory&) = delete;
  ProfileMemory& operator=(const ProfileMemory&) = delete;

  /// Allocates the table, and a context of the library that allocates here and must not outlive
  /// this object. Errors: limit (memory), cancelled, out_of_memory.
  Result<ProfileContext> open();

  /// Returns null if the budget or the system has too little for a large block; status() then has
  /// the error. status() also reports a small block beyond the budget.
  void* allocate(std::size_t byte_count);
  static void free(void* block);
  static std::size_t size_of(const void* block);

  const Status& status() const { return status_; }

 private:
  void* from_table(std::size_t byte_count);

  const Context& context_;
  TableMemory memory_{"a colour profile"};
  std::vector<std::max_align_t> table_;
  std::size_t table_used_ = 0;
  ScopedCharge charge_;
  Status status_;
};

}  // namespace sfumato::codecs
