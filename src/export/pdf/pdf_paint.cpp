#include "export/pdf/pdf_paint.hpp"

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "export/facets/mesh_bytes.hpp"
#include "export/poll_interval.hpp"

namespace sfumato::outputs {
namespace {

using Resource = PdfContent::Resource;

/// PDF's names of blend modes, in the order of BlendMode.
constexpr std::string_view kBlendName[] = {"Normal",    "Multiply",   "Screen",     "Overlay",
                                           "Darken",    "Lighten",    "ColorDodge", "ColorBurn",
                                           "HardLight", "SoftLight",  "Difference", "Exclusion",
                                           "Hue",       "Saturation", "Color",      "Luminosity"};

std::string image_entries(const Image& image, std::string_view color_space) {
  return "/Type /XObject /Subtype /Image /Width " + std::to_string(image.width) + " /Height " +
         std::to_string(image.height) + " /ColorSpace /" + std::string(color_space) +
         " /BitsPerComponent 8 /Interpolate true";
}

/// Channels [first, first + count) of 8-bit pixels. Errors: limit, cancelled.
Result<std::vector<std::uint8_t>> planes(Context& context, const Image& image, int first, int count,
                                         TableMemory& memory) {
  const auto stride = static_cast<std::size_t>(channel_count(image.format));
  const std::size_t pixels = image.bytes.size() / stride;
  std::vector<std::uint8_t> bytes;
  SFUMATO_TRY(memory.reserve(context, bytes, pixels * static_cast<std::size_t>(count)));
  RarePoll<kTurnsPerPoll> poll(context);
  for (std::size_t i = 0; i < pixels; ++i) {
    if (poll.cancelled()) return context.cancel_status();
    for (int c = first; c < first + count; ++c)
      bytes.push_back(image.bytes[stride * i + static_cast<std::size_t>(c)]);
  }
  return bytes;
}

PdfRef add_planes(Context& context, PdfFile* file, const Image& image, int first, int count,
                  const std::string& entries) {
  if (first == 0 && count == channel_count(image.format)) {
    return file->add_stream(entries, image.bytes);
  }
  TableMemory memory("an image");
  const auto bytes = planes(context, image, first, count, memory);
  if (bytes) return file->add_stream(entries, *bytes);
  file->fail(bytes.status());
  return 0;
}

}  // namespace

PdfRef add_mesh(Context& context, PdfFile* file, const FacetMesh& mesh, const Box& box) {
  if (mesh.facet_vertex.empty()) return 0;
  TableMemory memory("a mesh's bytes");
  const auto bytes = mesh_bytes(context, mesh, box, memory);
  if (!bytes) {
    file->fail(bytes.status());
    return 0;
  }
  std::string decode = pdf_number(box.min.x) + " " + pdf_number(box.max.x) + " " +
                       pdf_number(box.min.y) + " " + pdf_number(box.max.y);
  for (int c = 0; c < mesh.channel_count; ++c) decode += " 0 1";
  const char* color_space = mesh.channel_count == 3 ? "DeviceRGB" : "DeviceGray";
  return file->add_stream(
      "/ShadingType 4 /ColorSpace /" + std::string(color_space) +
          " /BitsPerCoordinate 24 /BitsPerComponent 8 /BitsPerFlag 8 /Decode [" + decode + "]",
      *bytes);
}

void paint_mesh(PdfRef mesh, double shift, PdfContent* content) {
  if (mesh == 0) return;
  const std::string paint = content->name(Resource::shading, mesh) + " sh";
  // Not by the same both ways: vertices may lie on diagonals.
  content->add("q 1 0 0 1 " + pdf_number(shift) + " " + pdf_number(0.78 * shift) + " cm " + paint +
               " Q");
  content->add(paint);
}

PdfRef add_image(Context& context, PdfFile* file, const Image& image) {
  std::string entries = image_entries(image, "DeviceRGB");
  if (channel_count(image.format) == 4)
    entries += " /SMask " + pdf_reference(add_alpha_image(context, file, image));
  return add_planes(context, file, image, 0, 3, entries);
}

PdfRef add_alpha_image(Context& context, PdfFile* file, const Image& image) {
  return add_planes(context, file, image, 3, 1, image_entries(image, "DeviceGray"));
}

void paint_image(PdfRef image, const Box& box, PdfContent* content) {
  // Images stand on their lower edge, y up.
  const Affine place{box.width(), 0, 0, -box.height(), box.min.x, box.max.y};
  content->add("q " + pdf_matrix(place) + " cm " + content->name(Resource::form, image) + " Do Q");
}

PdfRef add_mask(PdfFile* file, PdfRef mask_form) {
  return file->add("<< /SMask << /S /Luminosity /BC [0] /G " + pdf_reference(mask_form) + " >> >>");
}

PdfRef add_compositing(PdfFile* file, float opacity, BlendMode blend) {
  return file->add("<< /ca " + pdf_number(opacity) + " /BM /" +
                   std::string(kBlendName[static_cast<std::size_t>(blend)]) + " >>");
}

}  // namespace sfumato::outputs
