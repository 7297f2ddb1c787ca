#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "sfumato/base/image.hpp"
#include "sfumato/base/vec2.hpp"

/// A reader of GLB as a program has one that knows nothing of Sfumato: for tests alone.
namespace sfumato::test {

/// A value of JSON; of an object or array, its parts. Nothing is there where a name is not known.
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

/// A file with its chunks checked: magic, version, lengths. Throws std::runtime_error where one is
/// wrong or the JSON is none.
struct Glb {
  Json json;
  std::vector<std::uint8_t> binary;
};
Glb read_glb(const std::vector<std::uint8_t>& bytes);

/// The scene as an engine shows it that looks along −z: from the nodes' order in depth, colours
/// interpolated in linear light, blended in code values, on white; no antialiasing. rgb8. The
/// picture of width × height pixels shows what lies within `half_size` around the origin.
Image show(const Glb& glb, int width, int height, Vec2 half_size);

}  // namespace sfumato::test
