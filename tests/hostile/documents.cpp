#include "hostile/documents.hpp"

#include <algorithm>

#include "hostile/packer.hpp"

namespace sfumato::hostile {

std::string repeated(const std::string& text, std::size_t count) {
  std::string result;
  result.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

std::string numbered(const std::string& prefix, std::size_t count, const std::string& suffix) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += prefix + std::to_string(i) + suffix;
  return result;
}

std::string svg(const std::string& content, const std::string& attributes) {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 100 50' "
         "sf:version='1' " +
         attributes + ">\n" + content + "\n</svg>\n";
}

std::string layer(const std::string& curves) {
  return svg("<g sf:diffuse='true'>" + curves + "</g>");
}

std::string curve(const std::string& attributes, const std::string& more) {
  return svg("<g sf:diffuse='true'><path d='M9 9h80' " + attributes + "/></g>\n" + more);
}

std::string path(const std::string& data) {
  return layer("<path d='" + data + "' sf:left='red' sf:right='blue'/>");
}

std::string painted(const std::string& paint) {
  return svg("<g sf:diffuse='true'><path d='M9 9h80v30z' sf:left='url(#p)' sf:right='red'/></g>\n" +
             paint);
}

std::string textured(const std::string& href) {
  return painted(
      "<pattern id='p' patternUnits='userSpaceOnUse' width='4' height='4'>\n<image href='" + href +
      "' width='4' height='4'/></pattern>");
}

std::string laughs(int levels, const std::string& first) {
  std::string groups = "<g id='g0'>" + first + "</g>";
  for (int i = 1; i <= levels; ++i) {
    groups += "<g id='g" + std::to_string(i) + "'>" +
              repeated("<use href='#g" + std::to_string(i - 1) + "'/>", 10) + "</g>";
  }
  return "<defs>" + groups + "</defs>";
}

std::string orzan(const std::string& curves, const std::string& attributes) {
  return "<!DOCTYPE CurveSetXML><curve_set image_width='64' image_height='48' " + attributes +
         ">\n" + curves + "\n</curve_set>\n";
}

std::string orzan_curve(const std::string& parts) {
  return "<curve><control_points_set><control_point x='9' y='9'/><control_point x='9' y='30'/>"
         "<control_point x='30' y='30'/><control_point x='30' y='9'/></control_points_set>" +
         parts + "</curve>";
}

std::string gzip(const std::string& text) {
  Packer packer(Wrapper::gzip);
  packer.add(text, Z_FINISH);
  return packer.packed();
}

std::string gzip_of_byte(char byte, std::size_t count) {
  return packed_run(Wrapper::gzip, byte, count);
}

std::string utf16(const std::string& ascii, bool big_end_first) {
  std::string text;
  const auto add = [&](char high, char low) {
    text += big_end_first ? high : low;
    text += big_end_first ? low : high;
  };
  add('\xFE', '\xFF');
  for (const char c : ascii) add('\0', c);
  return text;
}

}  // namespace sfumato::hostile
