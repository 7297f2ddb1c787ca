// The documents in docs/format.md match their descriptions.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "formats/image_files.hpp"
#include "formats/svg/svg_support.hpp"
#include "support/places.hpp"

namespace sfumato::test {
namespace {

/// Returns the blocks of XML in the manual.
std::vector<std::string> examples() {
  std::ifstream file(source_path("docs/format.md"));
  std::stringstream manual;
  manual << file.rdbuf();
  const std::string text = manual.str();
  std::vector<std::string> blocks;
  for (std::size_t at = text.find("```xml\n"); at != std::string::npos;) {
    const std::size_t begin = at + 7, end = text.find("```", begin);
    blocks.push_back(text.substr(begin, end - begin));
    at = text.find("```xml\n", end);
  }
  return blocks;
}

TEST(SvgManual, its_examples_are_read_without_a_warning) {
  MemoryLoader loader;
  loader.files["wood.jpg"] = jpeg_file(32, 32, 3, {90, 60, 30, 0});
  const std::vector<std::string> documents = examples();
  ASSERT_EQ(documents.size(), 2u);
  for (const std::string& document : documents) {
    const ReadDocument read_document = read(document, &loader);
    EXPECT_TRUE(read_document.warnings.empty()) << to_string(read_document.warnings[0]);
  }
  const Document apple = read(documents[0]).document;
  EXPECT_EQ(apple.layers.size(), 1u);
  EXPECT_EQ(apple.stack.size(), 2u);
  const Document fish = read(documents[1], &loader).document;
  EXPECT_EQ(fish.layers.size(), 2u);
  EXPECT_EQ(fish.stack.size(), 3u);
  EXPECT_EQ(fish.shaders.size(), 2u);
}

}  // namespace
}  // namespace sfumato::test
