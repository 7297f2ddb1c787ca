#include "export/pdf/pdf_content.hpp"

#include <algorithm>

namespace sfumato::outputs {

void PdfContent::add(std::string_view operators) {
  text_ += operators;
  text_ += '\n';
}

std::string PdfContent::name(Resource kind, PdfRef ref) {
  std::vector<PdfRef>& used = used_[static_cast<std::size_t>(kind)];
  // Nearly always it is new or the last one; a stack of 200,000 items has few layers.
  if (std::find(used.rbegin(), used.rend(), ref) == used.rend()) used.push_back(ref);
  return "/R" + std::to_string(ref);
}

std::string PdfContent::resources() const {
  constexpr std::string_view kCategory[] = {"ExtGState", "Shading", "XObject"};
  std::string text = "/Resources <<";
  for (std::size_t kind = 0; kind < used_.size(); ++kind) {
    if (used_[kind].empty()) continue;
    text += " /" + std::string(kCategory[kind]) + " <<";
    for (PdfRef ref : used_[kind]) text += " /R" + std::to_string(ref) + " " + pdf_reference(ref);
    text += " >>";
  }
  return text + " >>";
}

PdfRef PdfContent::make_form_with(PdfFile* file, const Box& bounds, std::string_view group) const {
  if (!status()) file->fail(status());
  return file->add_stream("/Type /XObject /Subtype /Form /BBox " + pdf_rectangle(bounds) + " " +
                              std::string(group) + resources(),
                          text());
}

PdfRef PdfContent::make_form(PdfFile* file, const Box& bounds, bool is_group) const {
  return make_form_with(file, bounds,
                        is_group ? "/Group << /S /Transparency /I true /CS /DeviceRGB >> " : "");
}

PdfRef PdfContent::make_mask_form(PdfFile* file, const Box& bounds) const {
  return make_form_with(file, bounds, "/Group << /S /Transparency /I true /CS /DeviceGray >> ");
}

}  // namespace sfumato::outputs
