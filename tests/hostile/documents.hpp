#pragma once

#include <cstddef>
#include <string>

/// Texts for cases.
namespace sfumato::hostile {

inline constexpr std::size_t kMillion = 1'000'000;

std::string repeated(const std::string& text, std::size_t count);

/// Returns "prefix0suffix", "prefix1suffix", … one after the other.
std::string numbered(const std::string& prefix, std::size_t count, const std::string& suffix);

/// Returns a text whose line 1 is the <svg> (viewBox 0 0 100 50); the content begins on line 2.
std::string svg(const std::string& content, const std::string& attributes = "");

/// Returns a layer around the curves, on line 2.
std::string layer(const std::string& curves);

/// Returns a layer whose only curve has these attributes; then more content on line 3.
std::string curve(const std::string& attributes, const std::string& more = "");

/// Returns a layer whose only curve is this path.
std::string path(const std::string& data);

/// Returns a curve painted by this element, on line 3, whose id is p.
std::string painted(const std::string& paint);

/// Returns a curve with a texture on line 4: <image href>.
std::string textured(const std::string& href);
/// One whose image, the file t, fills its tile at any aspect ratio.
inline const std::string kTextured = textured("t' preserveAspectRatio='none");

/// A layer that is easy to draw.
inline const std::string kLayer = "<g sf:diffuse='true'><path d='M9 9h80' sf:left='red'/></g>";
/// A local curve that is easy to draw.
inline const std::string kStroke = "<path d='M9 9h9' sf:left='red' sf:radius='2'/>";

/// Returns `first` in a group, then so many groups of ten <use> of the previous one, in <defs>: g0,
/// g1, …
std::string laughs(int levels, const std::string& first);

/// Returns Orzan's XML: a canvas of 64 × 48 with these curves from line 2 on.
std::string orzan(const std::string& curves, const std::string& attributes = "");
/// Returns one curve of four points, with these extra parts.
std::string orzan_curve(const std::string& parts = "");

/// Returns the gzipped text.
std::string gzip(const std::string& text);
/// Returns gzip of one byte repeated `count` times, made in pieces.
std::string gzip_of_byte(char byte, std::size_t count);

/// Returns ASCII text as UTF-16, with its byte order mark.
std::string utf16(const std::string& ascii, bool big_end_first);

}  // namespace sfumato::hostile
