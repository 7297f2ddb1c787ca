#include <gtest/gtest.h>

#include <cstddef>
#include <type_traits>

#include "capi/handles.hpp"
#include "cli/run_command.hpp"
#include "support/places.hpp"

/// Facts that programs built against this header rely on.
namespace sfumato::test {
namespace {

// Final on 64-bit machines.
static_assert(sizeof(void*) != 8 || sizeof(sfumato_view) == 32);
static_assert(sizeof(void*) != 8 || offsetof(sfumato_view, rows) == 8);
static_assert(sizeof(void*) != 8 || offsetof(sfumato_view, row_bytes) == 16);
static_assert(sizeof(void*) != 8 || offsetof(sfumato_view, columns) == 24);
static_assert(sizeof(void*) != 8 || offsetof(sfumato_view, type) == 28);
static_assert(sizeof(void*) != 8 || sizeof(sfumato_image) == 32);
static_assert(sizeof(void*) != 8 || offsetof(sfumato_image, row_bytes) == 8);
static_assert(sizeof(void*) != 8 || offsetof(sfumato_image, width) == 16);
static_assert(sizeof(void*) != 8 || offsetof(sfumato_image, height) == 20);
static_assert(sizeof(void*) != 8 || offsetof(sfumato_image, format) == 24);
static_assert(sizeof(void*) != 8 || sizeof(sfumato_loader) == 16);
static_assert(sizeof(void*) != 8 || offsetof(sfumato_loader, user) == 8);
static_assert(SFUMATO_BAD_USAGE == 8 && SFUMATO_PAINT == 3 && SFUMATO_F64 == 4 &&
              SFUMATO_OPACITY_VALUES == 6 && SFUMATO_RGBA16 == 3 && SFUMATO_BLUR == 2);

TEST(CFace, exports_the_functions_of_the_header_and_no_others) {
  const CommandResult names =
      run_command({"/bin/bash", "-c",
                   "nm --dynamic --defined-only --extern-only " + c_library() +
                       " | sed -nE 's/.* T ([a-z_]+)@@SFUMATO_1$/\\1/p' | sort"});
  const CommandResult all = run_command(
      {"/bin/bash", "-c", "nm --dynamic --defined-only --extern-only " + c_library() + " | wc -l"});
  const CommandResult declared =
      run_command({"/bin/bash", "-c",
                   "sed -nE 's/^SFUMATO_API [^()]*(sfumato_[a-z_]+)[(].*/\\1/p' " +
                       source_path("include/sfumato/sfumato.h") + " | sort"});
  EXPECT_EQ(names.out, declared.out);
  // The only other name is the node of the version.
  EXPECT_EQ(std::stoul(all.out), std::count(names.out.begin(), names.out.end(), '\n') + 1u);
}

TEST(CFace, names_its_abi_in_the_library) {
  const CommandResult name = run_command(
      {"/bin/bash", "-c",
       "readelf --dynamic " + c_library() + " | grep SONAME | grep -o 'lib[a-z.0-9]*'"});
  EXPECT_EQ(name.out, "libsfumato.so." + std::to_string(SFUMATO_ABI) + "\n");
  EXPECT_EQ(sfumato_abi(), static_cast<std::uint32_t>(SFUMATO_ABI));
  EXPECT_EQ("sfumato " + std::string(sfumato_version()) + "\n", run_sfumato({"--version"}).out);
}

}  // namespace
}  // namespace sfumato::test
