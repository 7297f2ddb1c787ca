#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sfumato/base/image.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/picture/picture.hpp"

/// What the tests of exporters share: documents, and the programs that show files.
namespace sfumato::test {

using Bytes = std::vector<std::uint8_t>;

/// One of examples/, or nothing and a failed test.
std::optional<Document> example(const std::string& name);

/// The picture of a document at its nominal size; an empty one and a failed test where it has none.
Picture solved(const Document& document);

/// Where the picture of one triangle lies.
inline constexpr Box kTriangleBox{{0, 0}, {64, 64}};

/// Where larger pictures lie.
inline constexpr Box kSquareBox{{0, 0}, {64, 64}}, kPageBox{{0, 0}, {80, 60}},
    kWideBox{{0, 0}, {100, 60}};

/// A colour that is linear in the place: red x / 64, green 1/2, blue y / 64.
Rgb sloped(int region, Vec2 p);

/// A picture of one triangle, sloped.
Picture picture_of_one_triangle();

std::string text_of(const Bytes& bytes);

/// How often `part` occurs.
std::size_t count(const std::string& text, const std::string& part);

/// Whether a program is on the PATH. A test then says GTEST_SKIP() << "no pdftoppm here".
bool has_program(const std::string& name);

/// What a command line says of a file, both streams, and how it ended. In the command, IN is the
/// file's path.
struct Said {
  int exit_code = -1;
  std::string text;
};
Said said_of(const Bytes& file, const std::string& name, const std::string& command);

/// What a program shows of a file on white, rgb8: its PNG, which the command must write to OUT.
/// Nothing and a failed test where it fails.
std::optional<Image> shown_by(const Bytes& file, const std::string& name,
                              const std::string& command);

/// The picture as our own rasterizer shows it on white, rgb8.
Image reference(const Picture& picture, int width, int height);

/// Differences of channels in code values. Sizes must match.
struct ImageDifference {
  double mean = 0;
  int p99 = 255;
  double far_percent = 100;  ///< of the channels, that differ by more than 64: half a sharp edge
};
ImageDifference difference(const Image& a, const Image& b);

}  // namespace sfumato::test
