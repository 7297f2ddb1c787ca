#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sfumato/formats/svg/svg.hpp"

namespace sfumato::test {

/// Returns a document of 100 × 50 around the content.
inline std::string svg(const std::string& content, const std::string& attributes = "") {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 100 50' "
         "sf:version='1' " +
         attributes + ">\n" + content + "\n</svg>\n";
}

/// Returns a document with one layer around the content.
inline std::string svg_layer(const std::string& content) {
  return svg("<g sf:diffuse='true'>\n" + content + "\n</g>");
}

/// A local curve.
inline const std::string kStroke = "<path d='M0 0 h9' sf:left='red' sf:radius='2'/>";

/// Files in memory.
class MemoryLoader final : public ResourceLoader {
 public:
  std::map<std::string, std::vector<std::uint8_t>, std::less<>> files;
  mutable int load_count = 0;

  Result<std::vector<std::uint8_t>> load(std::string_view href) const override {
    ++load_count;
    const auto found = files.find(href);
    if (found == files.end()) return make_error(StatusCode::bad_input, "there is no such file");
    return found->second;
  }
};

inline ReadDocument read(const std::string& text, const ResourceLoader* loader = nullptr) {
  Context context;
  Result<ReadDocument> result = read_svg(context, text, "a.svg", loader);
  EXPECT_TRUE(result.ok()) << to_string(result.status()) << "\n" << text.substr(0, 2000);
  EXPECT_EQ(context.budget.used(), 0u);
  return result ? std::move(*result) : ReadDocument{};
}

inline Status status_of(const std::string& text, const ResourceLoader* loader = nullptr,
                        const Limits& limits = {}) {
  Context context{.limits = limits};
  const Status status = read_svg(context, text, "a.svg", loader).status();
  EXPECT_EQ(context.budget.used(), 0u);
  return status;
}

/// Returns the curves of the only layer.
inline std::vector<Curve> curves_of(const std::string& layer_content) {
  ReadDocument read_document = read(svg_layer(layer_content));
  if (read_document.document.layers.size() != 1) {
    ADD_FAILURE() << "not one layer";
    return {};
  }
  return std::move(read_document.document.layers[0].curves);
}

inline Curve curve_of(const std::string& layer_content) {
  std::vector<Curve> curves = curves_of(layer_content);
  EXPECT_EQ(curves.size(), 1u);
  return curves.size() == 1 ? std::move(curves[0]) : Curve{};
}

inline Curve curve_of_path(const std::string& data) {
  return curve_of("<path d='" + data + "'/>");
}

inline std::vector<std::string> warnings_of(const std::string& text) {
  std::vector<std::string> messages;
  for (const Diagnostic& warning : read(text).warnings) messages.push_back(to_string(warning));
  return messages;
}

inline void expect_points(const std::vector<Vec2>& actual, const std::vector<Vec2>& expected,
                          double tolerance = 1e-12) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_NEAR(actual[i].x, expected[i].x, tolerance) << "point " << i;
    EXPECT_NEAR(actual[i].y, expected[i].y, tolerance) << "point " << i;
  }
}

}  // namespace sfumato::test
