#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/output_buffer.hpp"
#include "export/pdf/pdf_file.hpp"

namespace sfumato::outputs {

/// A content stream under construction, with the resources that it names: object 12 is /R12.
class PdfContent {
 public:
  explicit PdfContent(const Context& context) : text_(context, "a page of a PDF") {}

  enum class Resource { graphics_state, shading, form };

  /// Adds operators as one line.
  void add(std::string_view operators);
  /// Begins a line, which add() ends.
  void begin(std::string_view operators) { text_ += operators; }
  /// Ok, or why nothing more is added; make_form passes it to the file.
  const Status& status() const { return text_.status(); }
  void fail(Status status) { text_.fail(std::move(status)); }
  /// "/R12" for an object, which becomes one of the stream's resources.
  std::string name(Resource kind, PdfRef ref);

  /// Returns whether nothing was added; false after a failure.
  bool empty() const { return text_.status().ok() && text_.size() == 0; }
  std::string_view text() const { return text_.text(); }
  /// "/Resources << ... >>".
  std::string resources() const;

  /// The stream as a form XObject; is_group: as an isolated transparency group.
  PdfRef make_form(PdfFile* file, const Box& bounds, bool is_group) const;
  /// The stream as a group in grey, whose luminosity can be a mask.
  PdfRef make_mask_form(PdfFile* file, const Box& bounds) const;

 private:
  PdfRef make_form_with(PdfFile* file, const Box& bounds, std::string_view group) const;

  OutputBuffer text_;
  std::array<std::vector<PdfRef>, 3> used_;  ///< by Resource
};

}  // namespace sfumato::outputs
