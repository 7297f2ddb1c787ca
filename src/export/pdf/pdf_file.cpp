#include "export/pdf/pdf_file.hpp"

#include <algorithm>
#include <cmath>

#include "base/text/ascii.hpp"
#include "base/text/number_text.hpp"
#include "base/text/utf8.hpp"
#include "codecs/deflate.hpp"

namespace sfumato::outputs {
namespace {

constexpr double kLargestPdfNumber = 3e38;  ///< readers may hold numbers in single precision
constexpr int kDigits = 9;
constexpr int kMostDecimals = 18;

/// The four bytes show programs that guess the type that the file is not text.
constexpr std::string_view kHeader = "%PDF-1.7\n%\xE2\xE3\xCF\xD3\n";

void append_hex(unsigned unit, std::string* text) {
  for (int shift = 12; shift >= 0; shift -= 4) *text += kUpperHexDigits[unit >> shift & 15];
}

}  // namespace

std::string pdf_number(double value) {
  value = std::clamp(value, -kLargestPdfNumber, kLargestPdfNumber);
  int decimals = kDigits - 1;
  for (double size = std::fabs(value); size >= 10 && decimals > 0; size /= 10) --decimals;
  for (double size = std::fabs(value); size < 1 && decimals < kMostDecimals; size *= 10) ++decimals;
  std::string text = fixed_number_text(value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string pdf_rectangle(const Box& box) {
  return "[" + pdf_number(box.min.x) + " " + pdf_number(box.min.y) + " " + pdf_number(box.max.x) +
         " " + pdf_number(box.max.y) + "]";
}

std::string pdf_matrix(const Affine& map) {
  std::string text;
  for (double entry : {map.a, map.b, map.c, map.d, map.e, map.f}) text += pdf_number(entry) + " ";
  text.pop_back();
  return text;
}

std::string pdf_text(std::string_view utf8) {
  const bool is_plain = std::all_of(utf8.begin(), utf8.end(), [](char c) {
    return c >= ' ' && c <= '~' && c != '(' && c != ')' && c != '\\';
  });
  if (is_plain) return "(" + std::string(utf8) + ")";
  std::string text = "<FEFF";
  while (!utf8.empty()) {
    const auto point = static_cast<unsigned>(take_code_point(utf8));
    if (point >= 0x10000) {
      append_hex(0xD800 + ((point - 0x10000) >> 10), &text);
      append_hex(0xDC00 + ((point - 0x10000) & 0x3FF), &text);
    } else {
      append_hex(point, &text);
    }
  }
  return text + ">";
}

std::string pdf_reference(PdfRef ref) {
  return std::to_string(ref) + " 0 R";
}

PdfRef PdfFile::begin_object() {
  if (offset_.empty()) bytes_ += kHeader;
  fail(memory_.push_back(context_, offset_, bytes_.size()));
  const PdfRef ref = static_cast<PdfRef>(offset_.size());
  bytes_ += std::to_string(ref) + " 0 obj\n";
  return ref;
}

PdfRef PdfFile::add(std::string_view object) {
  if (!status()) return 0;
  const PdfRef ref = begin_object();
  (bytes_ += object) += "\nendobj\n";
  return ref;
}

PdfRef PdfFile::add_stream(std::string_view entries, std::span<const std::uint8_t> bytes) {
  if (!status()) return 0;
  TableMemory memory("packed bytes");
  const Result<std::vector<std::uint8_t>> packed = codecs::deflated(context_, bytes, memory);
  if (!packed) {
    fail(packed.status());
    return 0;
  }
  const PdfRef ref = begin_object();
  (bytes_ += "<< ") += entries;
  bytes_ += " /Filter /FlateDecode /Length " + std::to_string(packed->size()) + " >>\nstream\n";
  bytes_.append(*packed);
  bytes_ += "\nendstream\nendobj\n";
  return ref;
}

PdfRef PdfFile::add_stream(std::string_view entries, std::string_view text) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  return add_stream(entries, {bytes, text.size()});
}

Result<std::vector<std::uint8_t>> PdfFile::finish(PdfRef root, PdfRef info) {
  if (!status()) return status();
  const std::size_t table = bytes_.size();
  const std::string count = std::to_string(offset_.size() + 1);
  bytes_ += "xref\n0 " + count + "\n0000000000 65535 f \n";
  for (std::size_t offset : offset_) {
    if (std::uint64_t{offset} > 9'999'999'999)
      return make_error(StatusCode::limit, "a PDF of more than 10 GB, which its table cannot hold");
    std::string digits = std::to_string(offset);
    digits.insert(0, 10 - std::min<std::size_t>(10, digits.size()), '0');
    bytes_ += digits + " 00000 n \n";
  }
  bytes_ += "trailer\n<< /Size " + count + " /Root " + pdf_reference(root) + " /Info " +
            pdf_reference(info) + " >>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n";
  return bytes_.finish();
}

}  // namespace sfumato::outputs
