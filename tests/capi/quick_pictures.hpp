#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "capi/handles.hpp"

namespace sfumato::test {

inline constexpr const char* kOptions = "max-error=4";
inline constexpr std::uint32_t kWidth = 96, kHeight = 96;

/// Three curves in a layer, one in another.
inline constexpr const char* kDrawing =
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 96 96'>"
    "<g sf:diffuse='true'>"
    "<path d='M10 20C40 10 60 30 86 18' sf:left='#fff' sf:right='#036'/>"
    "<path d='M12 50C30 70 60 30 84 52' sf:left='red,blue' sf:right='gold'/>"
    "<path d='M30 80L70 84' sf:left='green' sf:right='black'/></g>"
    "<g sf:diffuse='true'><path d='M40 40C60 40 60 60 40 60' sf:left='#fff' sf:right='#333'"
    " sf:opacity='0.5'/></g></svg>";

inline std::int32_t expect_drag(sfumato_context* context, sfumato_picture* picture,
                                std::uint32_t layer, const std::vector<std::uint32_t>& curves) {
  return sfumato_expect_drag(context, picture, layer, curves.data(), curves.size());
}

/// A picture of a document that changes.
class CQuick : public testing::Test {
 protected:
  void move(double by, std::uint32_t curve = 0, std::uint32_t layer = 0) {
    sfumato_view view{};
    ASSERT_EQ(sfumato_curve_points(document.get(), layer, curve, &view), SFUMATO_OK);
    std::vector<double> xy(static_cast<const double*>(view.data),
                           static_cast<const double*>(view.data) + 2 * view.rows);
    for (double& number : xy) number += by;
    ASSERT_EQ(sfumato_set_curve_points(c, document.get(), layer, curve, xy.data(), view.rows),
              SFUMATO_OK);
  }

  std::int32_t again(std::int32_t quick) {
    return sfumato_solve_again(c, document.get(), quick, picture.get());
  }

  bool is_exact() const {
    return tables_of(picture.get()) == tables_of(solve(c, document.get(), kOptions).get());
  }

  std::vector<std::uint8_t> pixels_of(const sfumato_picture* of) const {
    std::vector<std::uint8_t> pixels(3 * kWidth * kHeight);
    const sfumato_image image{pixels.data(), 3 * kWidth, kWidth, kHeight, SFUMATO_RGB8};
    EXPECT_EQ(sfumato_raster(c, of, &image, "background=white"), SFUMATO_OK);
    return pixels;
  }

  /// Returns the mean difference of all pixels from the exact picture, in code values.
  double mean_miss() const {
    const std::vector<std::uint8_t> shown = pixels_of(picture.get());
    const std::vector<std::uint8_t> exact = pixels_of(solve(c, document.get(), kOptions).get());
    double sum = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) sum += std::abs(shown[i] - exact[i]);
    return sum / static_cast<double>(shown.size());
  }

  /// Returns the number of new rows in all tables of a layer.
  std::uint32_t new_rows(std::uint32_t layer) const {
    std::uint32_t rows = 0;
    for (std::uint32_t table = SFUMATO_VERTICES; table <= SFUMATO_OPACITY_VALUES; ++table) {
      sfumato_view view{};
      EXPECT_EQ(sfumato_picture_changes(picture.get(), layer, table, &view), SFUMATO_OK);
      const auto* const range = static_cast<const std::uint32_t*>(view.data);
      for (std::size_t i = 0; i < view.rows; ++i) rows += range[2 * i + 1] - range[2 * i];
    }
    return rows;
  }

  using Bytes = std::vector<std::uint8_t>;

  /// Returns a table of the first layer.
  Bytes table_of(std::uint32_t table) const {
    sfumato_view view{};
    EXPECT_EQ(sfumato_picture_table(picture.get(), 0, table, &view), SFUMATO_OK);
    const auto* const data = static_cast<const std::uint8_t*>(view.data);
    return data ? Bytes(data, data + view.rows * view.row_bytes) : Bytes();
  }

  /// Updates a copy of a table from its new rows only. Returns their number.
  std::size_t renew(std::uint32_t table, Bytes& copy) const {
    sfumato_view rows{}, now{};
    EXPECT_EQ(sfumato_picture_changes(picture.get(), 0, table, &rows), SFUMATO_OK);
    EXPECT_EQ(sfumato_picture_table(picture.get(), 0, table, &now), SFUMATO_OK);
    copy.resize(now.rows * now.row_bytes);
    std::size_t count = 0;
    const auto* const range = static_cast<const std::uint32_t*>(rows.data);
    for (std::size_t i = 0; i < rows.rows; ++i) {
      const std::size_t from = range[2 * i], to = range[2 * i + 1];
      EXPECT_LT(from, to);
      EXPECT_LE(to, now.rows);
      std::memcpy(copy.data() + from * now.row_bytes,
                  static_cast<const std::uint8_t*>(now.data) + from * now.row_bytes,
                  (to - from) * now.row_bytes);
      count += to - from;
    }
    return count;
  }

  ContextHandle context{sfumato_context_new("threads=1")};
  sfumato_context* c = context.get();
  DocumentHandle document = read_text(c, kDrawing);
  PictureHandle picture = solve(c, document.get(), kOptions);
};

}  // namespace sfumato::test
