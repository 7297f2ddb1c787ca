#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "sfumato/base/image.hpp"
#include "sfumato/base/vec2.hpp"

/// A reader of GLB that knows nothing of Sfumato, only for tests.
namespace sfumato::test {

/// A JSON value; for an object or array, its parts. An unknown name has no value.
struct Json {
  std::variant<std::monostate, bool, double, std::string, std::vector<Json>,
               std::map<std::string, Json>>
      value;

  const Json& operator[](const std::string& name) const;
  const Json& operator[](std::size_t index) const;
  bool is_there() const { return value.index() != 0; }
  std::size_t size() const;
  double number(double otherwise = 0) const;
  std::size_t index() const { return static_cast<std::size_t>(number()); }
  std::string text() const;
};

/// A file with checked chunks: magic, version, lengths. Throws std::runtime_error if one is wrong
/// or the JSON is invalid.
struct Glb {
  Json json;
  std::vector<std::uint8_t> binary;
};
Glb read_glb(const std::vector<std::uint8_t>& bytes);

/// Returns the scene as an engine shows it that looks along −z: in the depth order of the nodes,
/// with colours interpolated in linear light and blended in code values, on white, without
/// antialiasing; rgb8. The picture of width × height pixels shows the area within `half_size`
/// around the origin.
Image show(const Glb& glb, int width, int height, Vec2 half_size);

}  // namespace sfumato::test
