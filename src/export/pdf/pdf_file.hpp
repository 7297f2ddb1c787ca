#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/output_buffer.hpp"
#include "base/table_memory.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::outputs {

/// The number of an object of a PDF file, from 1.
using PdfRef = int;

/// Returns a number in PDF's syntax: nine significant digits, no exponent. Precondition: finite.
std::string pdf_number(double value);
/// "[x0 y0 x1 y1]".
std::string pdf_rectangle(const Box& box);
/// "a b c d e f", the operands of the operator cm.
std::string pdf_matrix(const Affine& map);
/// UTF-8 text as a string object: UTF-16 in hexadecimal if it is not plain ASCII.
std::string pdf_text(std::string_view utf8);
/// "12 0 R".
std::string pdf_reference(PdfRef ref);

/// The objects of a PDF 1.7 file (ISO 32000-1), in memory. The same calls give the same bytes.
class PdfFile {
 public:
  explicit PdfFile(const Context& context) : context_(context), bytes_(context, "the PDF") {}

  /// Adds an object without a stream: "<< /Type /Page >>".
  PdfRef add(std::string_view object);

  /// Adds a deflated stream; `entries` are the entries of its dictionary except Length and Filter.
  /// Errors, in status(): limit (memory), cancelled, out_of_memory; the result is then not a valid
  /// object.
  PdfRef add_stream(std::string_view entries, std::span<const std::uint8_t> bytes);
  PdfRef add_stream(std::string_view entries, std::string_view text);

  /// Returns the first error; everything added after it is dropped.
  const Status& status() const { return bytes_.status(); }
  void fail(Status status) { bytes_.fail(std::move(status)); }

  /// Returns the whole file. Nothing may be added afterwards.
  Result<std::vector<std::uint8_t>> finish(PdfRef root, PdfRef info);

 private:
  PdfRef begin_object();

  const Context& context_;
  OutputBuffer bytes_;
  TableMemory memory_{"the PDF"};
  std::vector<std::size_t> offset_;  ///< of object i + 1
};

}  // namespace sfumato::outputs
