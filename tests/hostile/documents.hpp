#pragma once

#include <cstddef>
#include <string>

/// Texts that cases are made of.
namespace sfumato::hostile {

inline constexpr std::size_t kMillion = 1'000'000;

std::string repeated(const std::string& text, std::size_t count);

/// "prefix0suffix", "prefix1suffix", … one behind the other.
std::string numbered(const std::string& prefix, std::size_t count, const std::string& suffix);

/// Line 1 is the <svg> (viewBox 0 0 100 50), the content begins on line 2.
std::string svg(const std::string& content, const std::string& attributes = "");

/// A layer around the curves, on line 2.
std::string layer(const std::string& curves);

/// A layer whose only curve has these attributes; then more content on line 3.
std::string curve(const std::string& attributes, const std::string& more = "");

/// A layer whose only curve is this path.
std::string path(const std::string& data);

/// A curve painted by this element, on line 3, whose id is p.
std::string painted(const std::string& paint);

/// A curve with a texture on line 4: <image href>.
std::string textured(const std::string& href);
/// One whose image, the file t, fills its tile whatever its shape.
inline const std::string kTextured = textured("t' preserveAspectRatio='none");

/// A layer that is easy to draw.
inline const std::string kLayer = "<g sf:diffuse='true'><path d='M9 9h80' sf:left='red'/></g>";
/// A local curve that is easy to draw.
inline const std::string kStroke = "<path d='M9 9h9' sf:left='red' sf:radius='2'/>";

/// `first` in a group, then so many groups of ten <use> of the one before, in <defs>: g0, g1, …
std::string laughs(int levels, const std::string& first);

/// Orzan's XML: a canvas of 64 × 48 with these curves from line 2 on.
std::string orzan(const std::string& curves, const std::string& attributes = "");
/// One curve of four points, with these parts more.
std::string orzan_curve(const std::string& parts = "");

/// gzip of a text.
std::string gzip(const std::string& text);
/// gzip of `count` times one byte, made in pieces.
std::string gzip_of_byte(char byte, std::size_t count);

/// UTF-16 of ASCII text, with its byte order mark.
std::string utf16(const std::string& ascii, bool big_end_first);

}  // namespace sfumato::hostile
