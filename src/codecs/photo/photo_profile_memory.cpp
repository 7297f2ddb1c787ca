#include "codecs/photo/photo_profile_memory.hpp"

#include <lcms2_plugin.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "base/no_throw.hpp"
#include "base/try.hpp"

namespace sfumato::codecs {
namespace {

/// The size of the table for small blocks. A profile of a camera, a screen or a press needs a
/// quarter of it.
constexpr std::size_t kTableBytes = std::size_t{2} << 20;
constexpr std::size_t kSmallBytes = std::size_t{64} << 10;

/// Before each block of the library.
struct alignas(std::max_align_t) BlockHeader {
  BlockHeader(std::size_t bytes, ScopedCharge* of) : byte_count(bytes), charge(of) {}
  std::size_t byte_count;
  ScopedCharge* charge;  ///< null: the library's frame, of a fixed size, is not charged
  bool is_of_table = false;
};

BlockHeader* header_of(void* block) {
  return static_cast<BlockHeader*>(block) - 1;
}

void* block_of(std::size_t byte_count, ScopedCharge* charge) {
  void* const memory = std::malloc(sizeof(BlockHeader) + byte_count);
  if (!memory) return nullptr;
  return std::construct_at(static_cast<BlockHeader*>(memory), byte_count, charge) + 1;
}

void* allocate(cmsContext library, cmsUInt32Number byte_count) {
  auto* const memory = static_cast<ProfileMemory*>(cmsGetContextUserData(library));
  return memory ? memory->allocate(byte_count) : block_of(byte_count, nullptr);
}

void release(cmsContext, void* block) {
  ProfileMemory::free(block);
}

void* reallocate(cmsContext library, void* block, cmsUInt32Number byte_count) {
  void* const moved = allocate(library, byte_count);
  if (!moved || !block) return moved;
  std::memcpy(moved, block, std::min<std::size_t>(byte_count, ProfileMemory::size_of(block)));
  ProfileMemory::free(block);
  return moved;
}

const cmsPluginMemHandler kMemoryPlugin{
    {cmsPluginMagicNumber, 2000, cmsPluginMemHandlerSig, nullptr},
    allocate,
    release,
    reallocate,
    nullptr,
    nullptr,
    nullptr};

}  // namespace

Result<ProfileContext> ProfileMemory::open() {
  SFUMATO_TRY(memory_.resize(context_, table_, kTableBytes / sizeof(std::max_align_t)));
  ProfileContext opened(cmsCreateContext(const_cast<cmsPluginMemHandler*>(&kMemoryPlugin), this));
  if (!opened) return out_of_memory();
  return opened;
}

void* ProfileMemory::from_table(std::size_t byte_count) {
  constexpr std::size_t kUnit = sizeof(std::max_align_t);
  const std::size_t units = (sizeof(BlockHeader) + byte_count + kUnit - 1) / kUnit;
  if (units > table_.size() - table_used_) return nullptr;
  auto* const header = reinterpret_cast<BlockHeader*>(&table_[table_used_]);
  table_used_ += units;
  std::construct_at(header, byte_count, nullptr)->is_of_table = true;
  return header + 1;
}

void* ProfileMemory::allocate(std::size_t byte_count) {
  const bool is_small = byte_count < kSmallBytes;
  if (is_small) {
    if (void* const block = from_table(byte_count)) return block;
  }
  Status status = no_throw([&] { return charge_.add(context_, byte_count, "a colour profile"); });
  const bool is_charged = status.ok();
  if (!is_charged && status_) status_ = std::move(status);
  if (!is_charged && !is_small) return nullptr;
  void* const block = block_of(byte_count, is_charged ? &charge_ : nullptr);
  if (block) return block;
  if (is_charged) charge_.release(byte_count);
  status_ = out_of_memory();
  return nullptr;
}

void ProfileMemory::free(void* block) {
  if (!block) return;
  BlockHeader* const header = header_of(block);
  if (header->charge) header->charge->release(header->byte_count);
  if (!header->is_of_table) std::free(header);
}

std::size_t ProfileMemory::size_of(const void* block) {
  return header_of(const_cast<void*>(block))->byte_count;
}

}  // namespace sfumato::codecs
