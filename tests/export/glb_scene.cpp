#include "export/glb_scene.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "sfumato/base/color_space.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/codecs/png.hpp"

namespace sfumato::test {
namespace {

using Matrix = std::array<double, 16>;  ///< column by column
using Bytes = std::vector<std::uint8_t>;

class JsonReader {
 public:
  explicit JsonReader(const std::string& text) : at_(text.c_str()) {}

  Json value() {
    skip();
    if (*at_ == '{') return object();
    if (*at_ == '[') return array();
    if (*at_ == '"') return {string()};
    if (take("true")) return {true};
    if (take("false")) return {false};
    if (take("null")) return {};
    char* end = nullptr;
    const double number = std::strtod(at_, &end);
    if (end == at_) throw std::runtime_error("no JSON: " + std::string(at_).substr(0, 20));
    at_ = end;
    return {number};
  }

 private:
  void skip() {
    while (std::isspace(static_cast<unsigned char>(*at_))) ++at_;
  }
  bool take(const char* word) {
    skip();
    if (std::strncmp(at_, word, std::strlen(word)) != 0) return false;
    at_ += std::strlen(word);
    return true;
  }
  std::string string() {
    std::string text;
    for (++at_; *at_ != '"'; ++at_) {
      if (*at_ == '\0' || *at_ == '\\') throw std::runtime_error("a string that is not plain");
      text += *at_;
    }
    ++at_;
    return text;
  }
  Json array() {
    std::vector<Json> list;
    for (bool is_open = take("["); is_open && !take("]"); take(",")) list.push_back(value());
    return {list};
  }
  Json object() {
    std::map<std::string, Json> members;
    for (bool is_open = take("{"); is_open && !take("}"); take(",")) {
      skip();
      const std::string name = string();
      if (!take(":")) throw std::runtime_error("no colon after " + name);
      members[name] = value();
    }
    return {members};
  }

  const char* at_;
};

std::uint32_t word(const Bytes& bytes, std::size_t at) {
  if (at + 4 > bytes.size()) throw std::runtime_error("the file ends early");
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

void expect(bool is_right, const char* what) {
  if (!is_right) throw std::runtime_error(what);
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t column = 0; column < 4; ++column)
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t k = 0; k < 4; ++k) c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return c;
}

Matrix matrix_of(const Json& node) {
  Matrix m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  for (std::size_t i = 0; i < node["matrix"].size(); ++i) m[i] = node["matrix"][i].number();
  for (std::size_t k = 0; k < node["scale"].size(); ++k) m[5 * k] = node["scale"][k].number();
  return m;
}

/// Returns all components of an accessor, normalized if it asks for that.
std::vector<double> read_accessor(const Glb& glb, std::size_t index) {
  const Json& accessor = glb.json["accessors"][index];
  const Json& view = glb.json["bufferViews"][accessor["bufferView"].index()];
  const std::map<std::string, std::size_t> components{
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  const std::size_t count = accessor["count"].index() * components.at(accessor["type"].text());
  const std::size_t offset = view["byteOffset"].index();
  expect(offset + view["byteLength"].index() <= glb.binary.size(), "a view beyond the buffer");
  std::vector<double> values;
  const auto read = [&](auto sample, double divisor) {
    expect(count * sizeof sample <= view["byteLength"].index(), "an accessor beyond its view");
    for (std::size_t i = 0; i < count; ++i) {
      std::memcpy(&sample, glb.binary.data() + offset + i * sizeof sample, sizeof sample);
      values.push_back(static_cast<double>(sample) / divisor);
    }
  };
  switch (accessor["componentType"].index()) {
    case 5123:
      read(std::uint16_t{}, 65535);
      break;
    case 5125:
      read(std::uint32_t{}, 1);
      break;
    case 5126:
      read(float{}, 1);
      break;
    default:
      throw std::runtime_error("a component type that is not used");
  }
  return values;
}

struct Placed {
  std::size_t mesh;
  Matrix matrix;
};

void collect(const Glb& glb, std::size_t index, const Matrix& parent, std::vector<Placed>& out) {
  const Json& node = glb.json["nodes"][index];
  const Matrix matrix = product(parent, matrix_of(node));
  if (node["mesh"].is_there()) out.push_back({node["mesh"].index(), matrix});
  for (std::size_t i = 0; i < node["children"].size(); ++i)
    collect(glb, node["children"][i].index(), matrix, out);
}

struct Pixel {
  double r = 1, g = 1, b = 1;  ///< code values
};

class Screen {
 public:
  Screen(const Glb& glb, int width, int height, Vec2 half_size)
      : glb_(glb), width_(width), height_(height), half_(half_size) {
    pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }

  void draw(const Placed& placed);
  Image image() const;

 private:
  struct Primitive {
    std::vector<double> index, position, color, texture;
    std::optional<Image> image;
    double opacity = 1;
    bool is_blended = false;
  };
  Primitive read(std::size_t mesh) const;
  void paint(const Primitive& primitive, const std::array<std::size_t, 3>& vertex,
             const std::array<double, 3>& weight, Pixel& pixel) const;

  const Glb& glb_;
  int width_, height_;
  Vec2 half_;
  std::vector<Pixel> pixels_;
};

Screen::Primitive Screen::read(std::size_t mesh) const {
  const Json& source = glb_.json["meshes"][mesh]["primitives"][0];
  const Json& material = glb_.json["materials"][source["material"].index()];
  expect(material["extensions"]["KHR_materials_unlit"].is_there(), "a material that is lit");
  const Json& attributes = source["attributes"];
  Primitive primitive;
  primitive.index = read_accessor(glb_, source["indices"].index());
  primitive.position = read_accessor(glb_, attributes["POSITION"].index());
  if (attributes["COLOR_0"].is_there())
    primitive.color = read_accessor(glb_, attributes["COLOR_0"].index());
  if (attributes["TEXCOORD_0"].is_there())
    primitive.texture = read_accessor(glb_, attributes["TEXCOORD_0"].index());
  const Json& base = material["pbrMetallicRoughness"];
  primitive.opacity = base["baseColorFactor"][3].number(1);
  primitive.is_blended = material["alphaMode"].text() == "BLEND";
  if (!base["baseColorTexture"].is_there()) return primitive;
  const Json& texture = glb_.json["textures"][base["baseColorTexture"]["index"].index()];
  const Json& image = glb_.json["images"][texture["source"].index()];
  const Json& view = glb_.json["bufferViews"][image["bufferView"].index()];
  const auto begin = glb_.binary.begin() + static_cast<std::ptrdiff_t>(view["byteOffset"].index());
  const Bytes png(begin, begin + static_cast<std::ptrdiff_t>(view["byteLength"].index()));
  Context context;
  Result<Image> decoded = decode_png(context, png, "texture");
  expect(decoded.ok() && decoded->format == PixelFormat::rgba8, "a texture that is no RGBA");
  primitive.image = std::move(*decoded);
  return primitive;
}

void Screen::paint(const Primitive& primitive, const std::array<std::size_t, 3>& vertex,
                   const std::array<double, 3>& weight, Pixel& pixel) const {
  const auto mean = [&](const std::vector<double>& values, std::size_t stride, std::size_t c) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += weight[k] * values[stride * vertex[k] + c];
    return sum;
  };
  std::array<double, 4> source{1, 1, 1, 1};
  for (std::size_t c = 0; c < 4 && !primitive.color.empty(); ++c)
    source[c] = mean(primitive.color, 4, c);
  for (std::size_t c = 0; c < 3; ++c) source[c] = code_from_linear(source[c]);
  if (primitive.image) {
    const Image& image = *primitive.image;
    const auto texel = [](double share, int size) {
      return static_cast<std::size_t>(std::clamp(std::floor(share * size), 0.0, size - 1.0));
    };
    const std::size_t x = texel(mean(primitive.texture, 2, 0), image.width);
    const std::size_t y = texel(mean(primitive.texture, 2, 1), image.height);
    for (std::size_t c = 0; c < 4; ++c)
      source[c] = image.bytes[4 * (y * static_cast<std::size_t>(image.width) + x) + c] / 255.0;
  }
  const double alpha = primitive.is_blended ? source[3] * primitive.opacity : 1;
  pixel = {std::lerp(pixel.r, source[0], alpha), std::lerp(pixel.g, source[1], alpha),
           std::lerp(pixel.b, source[2], alpha)};
}

void Screen::draw(const Placed& placed) {
  const Primitive primitive = read(placed.mesh);
  std::vector<Vec2> point;
  for (std::size_t i = 0; i < primitive.position.size(); i += 3) {
    const Matrix& m = placed.matrix;
    const double x = primitive.position[i], y = primitive.position[i + 1];
    const Vec2 p{m[0] * x + m[4] * y + m[12], m[1] * x + m[5] * y + m[13]};
    point.push_back({(p.x / half_.x + 1) / 2 * width_, (1 - p.y / half_.y) / 2 * height_});
  }
  // A centre belongs to the first triangle that contains it.
  std::vector<bool> is_done(pixels_.size());
  for (std::size_t i = 0; i < primitive.index.size(); i += 3) {
    std::array<std::size_t, 3> vertex;
    for (std::size_t k = 0; k < 3; ++k)
      vertex[k] = static_cast<std::size_t>(primitive.index[i + k]);
    const Vec2 a = point[vertex[0]], b = point[vertex[1]], c = point[vertex[2]];
    const double area = cross(b - a, c - a);
    if (area == 0) continue;
    const auto first = [](double low) { return std::max(0, static_cast<int>(low)); };
    for (int y = first(std::min({a.y, b.y, c.y}));
         y < std::min<double>(height_, std::max({a.y, b.y, c.y})); ++y) {
      for (int x = first(std::min({a.x, b.x, c.x}));
           x < std::min<double>(width_, std::max({a.x, b.x, c.x})); ++x) {
        const Vec2 p{x + 0.5, y + 0.5};
        const std::array<double, 3> weight{cross(b - p, c - p) / area, cross(c - p, a - p) / area,
                                           cross(a - p, b - p) / area};
        if (*std::ranges::min_element(weight) < -1e-9) continue;
        const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                  static_cast<std::size_t>(x);
        if (!is_done[pixel]) paint(primitive, vertex, weight, pixels_[pixel]);
        is_done[pixel] = true;
      }
    }
  }
}

Image Screen::image() const {
  Image image{width_, height_, PixelFormat::rgb8, {}};
  for (const Pixel& pixel : pixels_)
    for (const double channel : {pixel.r, pixel.g, pixel.b})
      image.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * channel)));
  return image;
}

const Json kNothing;

}  // namespace

const Json& Json::operator[](const std::string& name) const {
  const auto* members = std::get_if<std::map<std::string, Json>>(&value);
  if (!members) return kNothing;
  const auto found = members->find(name);
  return found == members->end() ? kNothing : found->second;
}

const Json& Json::operator[](std::size_t index) const {
  const auto* list = std::get_if<std::vector<Json>>(&value);
  return list && index < list->size() ? (*list)[index] : kNothing;
}

std::size_t Json::size() const {
  const auto* list = std::get_if<std::vector<Json>>(&value);
  return list ? list->size() : 0;
}

double Json::number(double otherwise) const {
  const double* number = std::get_if<double>(&value);
  return number ? *number : otherwise;
}

std::string Json::text() const {
  const std::string* text = std::get_if<std::string>(&value);
  return text ? *text : std::string();
}

Glb read_glb(const std::vector<std::uint8_t>& bytes) {
  expect(word(bytes, 0) == 0x46546C67 && word(bytes, 4) == 2, "no GLB of version 2");
  expect(word(bytes, 8) == bytes.size(), "another length than the file has");
  expect(word(bytes, 16) == 0x4E4F534A, "no JSON first");
  const std::size_t json_bytes = word(bytes, 12);
  expect(json_bytes % 4 == 0 && 20 + json_bytes <= bytes.size(), "JSON of a wrong length");
  const auto at = [&](std::size_t offset) {
    return bytes.begin() + static_cast<std::ptrdiff_t>(offset);
  };
  Glb glb;
  glb.json = JsonReader(std::string(at(20), at(20 + json_bytes))).value();
  if (20 + json_bytes == bytes.size()) return glb;
  const std::size_t chunk = 20 + json_bytes;
  expect(word(bytes, chunk + 4) == 0x004E4942, "no binary chunk second");
  expect(chunk + 8 + word(bytes, chunk) == bytes.size(), "a binary chunk of a wrong length");
  glb.binary.assign(at(chunk + 8), bytes.end());
  return glb;
}

Image show(const Glb& glb, int width, int height, Vec2 half_size) {
  std::vector<Placed> placed;
  const Json& roots = glb.json["scenes"][glb.json["scene"].index()]["nodes"];
  for (std::size_t i = 0; i < roots.size(); ++i)
    collect(glb, roots[i].index(), matrix_of({}), placed);
  std::ranges::stable_sort(placed, {}, [](const Placed& p) { return p.matrix[14]; });
  Screen screen(glb, width, height, half_size);
  for (const Placed& p : placed) screen.draw(p);
  return screen.image();
}

}  // namespace sfumato::test
