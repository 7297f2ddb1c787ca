#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "gpu/device.hpp"
#include "gpu/program.hpp"
#include "support.hpp"

namespace sfumato::gpu {
namespace {

void expect_program(std::string_view vertex, std::string_view fragment,
                    const std::vector<std::string_view>& defines) {
  const auto device = Device::create();
  ASSERT_TRUE(device.ok()) << to_string(device.status());
  const Result<Program> program = Program::create(vertex, fragment, defines);
  EXPECT_TRUE(program.ok()) << to_string(program.status());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(Shaders, every_program_and_variant_links) {
  SFUMATO_NEEDS_GPU();
  for (int variant = 0; variant < 12; ++variant) {
    std::vector<std::string_view> defines;
    if (variant & 1) defines.push_back("WITH_OPACITY");
    if (variant & 2) defines.push_back("WITH_PAINTS");
    if (variant & 4) defines.push_back("WITH_AREAS");
    if (variant & 8) defines.push_back("WITH_STRIPS");
    expect_program("patch.vert", "patch.frag", defines);
  }
  expect_program("patch.vert", "patch.frag", {"WITH_AREAS", "WITH_MARKS"});
  expect_program("patch.vert", "patch.frag", {"WITH_STRIPS", "WITH_MARKS"});
  expect_program("edges.vert", "edges.frag", {});
  expect_program("stroke.vert", "stroke.frag", {});
  expect_program("screen.vert", "stroke_resolve.frag", {});
  expect_program("screen.vert", "composite.frag", {});
  expect_program("screen.vert", "composite.frag", {"WITHOUT_BACKDROP"});
  expect_program("screen.vert", "composite.frag", {"WITH_EDGES"});
  expect_program("screen.vert", "composite.frag", {"WITHOUT_BACKDROP", "WITH_EDGES"});
  expect_program("overlay.vert", "overlay.frag", {});
  expect_program("screen.vert", "present.frag", {});
}

TEST(Shaders, a_shader_that_is_not_there_is_an_error_in_words) {
  SFUMATO_NEEDS_GPU();
  const auto device = Device::create();
  const Result<Program> program = Program::create("patch.vert", "no_such.frag", {});
  ASSERT_FALSE(program.ok());
  EXPECT_EQ(program.status().code, StatusCode::internal);
  EXPECT_NE(program.status().message.find("no_such.frag"), std::string::npos);
}

}  // namespace
}  // namespace sfumato::gpu
