#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sfumato/base/image.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/picture/picture.hpp"

/// Shared by the tests of exporters: documents, and programs that show files.
namespace sfumato::test {

using Bytes = std::vector<std::uint8_t>;

/// Returns one of examples/, or nothing with a failed test.
std::optional<Document> example(const std::string& name);

/// Returns the picture of a document at its nominal size; an empty one with a failed test on an
/// error.
Picture solved(const Document& document);

/// The place of the picture of one triangle.
inline constexpr Box kTriangleBox{{0, 0}, {64, 64}};

/// The places of larger pictures.
inline constexpr Box kSquareBox{{0, 0}, {64, 64}}, kPageBox{{0, 0}, {80, 60}},
    kWideBox{{0, 0}, {100, 60}};

/// Returns a colour that is linear in the place: red x / 64, green 1/2, blue y / 64.
Rgb sloped(int region, Vec2 p);

/// Returns a picture of one triangle with sloped colours.
Picture picture_of_one_triangle();

std::string text_of(const Bytes& bytes);

/// Returns how often `part` occurs.
std::size_t count(const std::string& text, const std::string& part);

/// Returns whether a program is on the PATH. If not, a test calls GTEST_SKIP() << "no pdftoppm
/// here".
bool has_program(const std::string& name);

/// The output of a command about a file, both streams, and how it ended. In the command, IN is the
/// file's path.
struct Said {
  int exit_code = -1;
  std::string text;
};
Said said_of(const Bytes& file, const std::string& name, const std::string& command);

/// Returns how a program shows a file on white, rgb8: the PNG that the command must write to OUT.
/// Nothing with a failed test if the program fails.
std::optional<Image> shown_by(const Bytes& file, const std::string& name,
                              const std::string& command);

/// Returns the picture from our rasterizer on white, rgb8.
Image reference(const Picture& picture, int width, int height);

/// Differences of channels in code values. Sizes must match.
struct ImageDifference {
  double mean = 0;
  int p99 = 255;
  double far_percent = 100;  ///< share of channels that differ by more than 64, half a sharp edge
};
ImageDifference difference(const Image& a, const Image& b);

}  // namespace sfumato::test
