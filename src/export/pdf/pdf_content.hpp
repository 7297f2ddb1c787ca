#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/output_buffer.hpp"
#include "export/pdf/pdf_file.hpp"

namespace sfumato::outputs {

/// A content stream while it is written, with the resources that it names: object 12 is /R12.
class PdfContent {
 public:
  explicit PdfContent(const Context& context) : text_(context, "a page of a PDF") {}

  enum class Resource { graphics_state, shading, form };

  /// Operators, one line.
  void add(std::string_view operators);
  /// A part of a line, which add() ends.
  void begin(std::string_view operators) { text_ += operators; }
  /// Why nothing is added any more, or ok; make_form hands it to the file.
  const Status& status() const { return text_.status(); }
  void fail(Status status) { text_.fail(std::move(status)); }
  /// "/R12" for an object, which becomes one of the stream's resources.
  std::string name(Resource kind, PdfRef ref);

  /// Whether nothing was to be added; what failed is not empty.
  bool empty() const { return text_.status().ok() && text_.size() == 0; }
  std::string_view text() const { return text_.text(); }
  /// "/Resources << ... >>".
  std::string resources() const;

  /// The same as a form XObject; is_group: a transparency group by itself.
  PdfRef make_form(PdfFile* file, const Box& bounds, bool is_group) const;
  /// As a group in grey: its luminosity may be a mask.
  PdfRef make_mask_form(PdfFile* file, const Box& bounds) const;

 private:
  PdfRef make_form_with(PdfFile* file, const Box& bounds, std::string_view group) const;

  OutputBuffer text_;
  std::array<std::vector<PdfRef>, 3> used_;  ///< by Resource
};

}  // namespace sfumato::outputs
