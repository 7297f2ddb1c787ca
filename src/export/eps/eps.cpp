#include "sfumato/export/eps/eps.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <variant>

#include "base/output_buffer.hpp"
#include "base/poll.hpp"
#include "base/public_verb.hpp"
#include "base/try.hpp"
#include "codecs/deflate.hpp"
#include "export/facets/facets.hpp"
#include "export/facets/mesh_bytes.hpp"
#include "export/page.hpp"
#include "export/pdf/pdf_file.hpp"
#include "export/pixel_part.hpp"
#include "picture/check_picture.hpp"

namespace sfumato {
namespace outputs {
namespace {

constexpr std::size_t kLineLength = 76;

/// Bytes as ASCII base 85, with its end mark.
void append_ascii85(const Context& context, std::span<const std::uint8_t> bytes,
                    OutputBuffer& text) {
  RarePoll<65536> poll(context);
  std::size_t line_begin = text.size();
  for (std::size_t i = 0; i < bytes.size(); i += 4) {
    if (poll.cancelled()) return text.fail(context.cancel_status());
    const std::size_t count = std::min<std::size_t>(4, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k) word = word << 8 | (k < count ? bytes[i + k] : 0u);
    char digit[5];
    for (int k = 4; k >= 0; --k, word /= 85) digit[k] = static_cast<char>('!' + word % 85);
    if (count == 4 && std::string_view(digit, 5) == "!!!!!")
      text += 'z';
    else
      text += std::string_view(digit, count + 1);
    if (text.size() - line_begin < kLineLength) continue;
    text += '\n';
    line_begin = text.size();
    // A line that begins with %% would be a comment of the document's structure.
    if (i + 4 < bytes.size()) text += ' ';
  }
  text += "~>\n";
}

/// Writes a picture.
class EpsWriter {
 public:
  EpsWriter(Context& context, const Picture& picture, const EpsOptions& options,
            double points_per_unit, ExportNotes* notes)
      : context_(context),
        picture_(picture),
        options_(options),
        points_per_unit_(points_per_unit),
        notes_(notes),
        text_(context, "the EPS") {}

  Result<std::vector<std::uint8_t>> write();

 private:
  void begin();
  bool is_opaque() const;
  double pixels_per_unit() const { return points_per_unit_ * options_.dpi / 72; }
  Status add_data(const std::string& name, std::span<const std::uint8_t> bytes);
  Status add_layer(std::uint32_t index, double scale);
  Status paint_layers();
  Status paint_pixels();

  Context& context_;
  const Picture& picture_;
  const EpsOptions& options_;
  double points_per_unit_;
  ExportNotes* notes_;
  OutputBuffer text_;
};

/// Returns whether everything just replaces what lies below.
bool EpsWriter::is_opaque() const {
  const auto is_plain = [&](const PictureItem& item) {
    if (std::holds_alternative<LocalStroke>(item)) return false;
    if (const auto* group = std::get_if<GroupBegin>(&item))
      return group->opacity == 1 && group->blend == BlendMode::normal;
    const auto* instance = std::get_if<PatchInstance>(&item);
    if (!instance) return true;
    const PatchLayer& layer = picture_.layers[instance->layer];
    return instance->opacity == 1 && instance->blend == BlendMode::normal &&
           layer.opacity.channel_count == 0 && layer.color.shader.empty();
  };
  return std::all_of(picture_.stack.begin(), picture_.stack.end(), is_plain);
}

void EpsWriter::begin() {
  const Page page = make_page(picture_.viewport, points_per_unit_);
  const Affine up = Affine{1, 0, 0, -1, 0, page.height} * page.page_from_artboard;
  std::string title;
  std::copy_if(options_.title.begin(), options_.title.end(), std::back_inserter(title),
               [](char c) { return c >= ' ' && c <= '~'; });
  const std::string size = pdf_number(page.width) + " " + pdf_number(page.height);
  text_ += "%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 " + pdf_number(std::ceil(page.width)) +
           " " + pdf_number(std::ceil(page.height)) + "\n%%HiResBoundingBox: 0 0 " + size +
           "\n%%Creator: Sfumato\n";
  if (!title.empty()) text_ += "%%Title: " + title.substr(0, 200) + "\n";
  text_ += "%%LanguageLevel: 3\n%%EndComments\n";
  text_ += "10 dict begin gsave 0 0 " + size + " rectclip [" + pdf_matrix(up) + "] concat\n";
}

/// Defines `name` as a stream that can be read again and again: "name 0 setfileposition".
Status EpsWriter::add_data(const std::string& name, std::span<const std::uint8_t> bytes) {
  TableMemory memory("packed bytes");
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& packed,
                     codecs::deflated(context_, bytes, memory));
  text_ += "/" + name + " currentfile /ASCII85Decode filter /ReusableStreamDecode filter\n";
  append_ascii85(context_, packed, text_);
  text_ += "def\n";
  return text_.status();
}

/// Defines /Pi, which paints layer i: twice, as in PDF.
Status EpsWriter::add_layer(std::uint32_t index, double scale) {
  const PatchLayer& layer = picture_.layers[index];
  const std::string number = std::to_string(index);
  if (layer.triangle_count() == 0) {
    text_ += "/P" + number + " {} def\n";
    return ok_status();
  }
  SFUMATO_TRY_ASSIGN(const FacetMesh& mesh,
                     make_facets(context_, layer, picture_.interpolation, {},
                                 options_.max_error / 255, 1 / (scale * pixels_per_unit())));
  notes_->triangle_count += mesh.facet_vertex.size() / 3;
  TableMemory memory("a mesh's bytes");
  const Box box = decode_box(triangles_box(layer));
  SFUMATO_TRY_ASSIGN(const auto& bytes, mesh_bytes(context_, mesh, box, memory));
  SFUMATO_TRY(add_data("D" + number, bytes));
  text_ += "/S" + number + " { D" + number + " 0 setfileposition << /ShadingType 4 /ColorSpace " +
           "/DeviceRGB /BitsPerCoordinate 24 /BitsPerComponent 8 /BitsPerFlag 8 /Decode [" +
           pdf_number(box.min.x) + " " + pdf_number(box.max.x) + " " + pdf_number(box.min.y) + " " +
           pdf_number(box.max.y) + " 0 1 0 1 0 1]\n/DataSource D" + number +
           " /FlateDecode filter >> shfill } bind def\n";
  const double shift = 0.09 / (scale * points_per_unit_);
  text_ += "/P" + number + " { gsave " + pdf_number(shift) + " " + pdf_number(0.78 * shift) +
           " translate S" + number + " grestore S" + number + " } def\n";
  return ok_status();
}

Status EpsWriter::paint_layers() {
  if (picture_.background) {
    const Rgb& color = *picture_.background;
    const Box& box = picture_.viewport;
    text_ += pdf_number(color.r) + " " + pdf_number(color.g) + " " + pdf_number(color.b) +
             " setrgbcolor " + pdf_number(box.min.x) + " " + pdf_number(box.min.y) + " " +
             pdf_number(box.width()) + " " + pdf_number(box.height()) + " rectfill\n";
  }
  std::vector<double> scale(picture_.layers.size());
  for (const PictureItem& item : picture_.stack) {
    const auto* instance = std::get_if<PatchInstance>(&item);
    if (!instance) continue;
    double& largest = scale[instance->layer];
    largest = std::max(largest, instance_scale(instance->artboard_from_layer));
  }
  text_ += std::to_string(3 * scale.size() + 1) + " dict begin\n";
  for (std::uint32_t i = 0; i < scale.size(); ++i)
    if (scale[i] > 0) SFUMATO_TRY(add_layer(i, scale[i]));
  for (const PictureItem& item : picture_.stack) {
    const auto* instance = std::get_if<PatchInstance>(&item);
    if (!instance || !(scale[instance->layer] > 0)) continue;
    text_ += "gsave [" + pdf_matrix(instance->artboard_from_layer) + "] concat P" +
             std::to_string(instance->layer) + " grestore\n";
  }
  text_ += "end\n";
  return ok_status();
}

Status EpsWriter::paint_pixels() {
  notes_->lost.push_back(
      "EPS cannot composite: the picture is one image; PDF keeps its layers as they are");
  SFUMATO_TRY_ASSIGN(const PixelPart& part, picture_pixels(context_, picture_, pixels_per_unit()));
  SFUMATO_TRY(add_data("D", part.image.bytes));
  const std::string width = std::to_string(part.image.width);
  const std::string height = std::to_string(part.image.height);
  const Box& box = part.box;
  text_ += "gsave [" + pdf_matrix({box.width(), 0, 0, box.height(), box.min.x, box.min.y}) +
           "] concat /DeviceRGB setcolorspace D 0 setfileposition\n<< /ImageType 1 /Width " +
           width + " /Height " + height + " /BitsPerComponent 8 /Decode [0 1 0 1 0 1] " +
           "/Interpolate true\n/ImageMatrix [" + width + " 0 0 " + height +
           " 0 0] /DataSource D /FlateDecode filter >> image grestore\n";
  return ok_status();
}

Result<std::vector<std::uint8_t>> EpsWriter::write() {
  begin();
  SFUMATO_TRY(is_opaque() ? paint_layers() : paint_pixels());
  text_ += "grestore end\n%%EOF\n";
  return text_.finish();
}

Status check(const Context& context, const Picture& picture, const EpsOptions& options) {
  SFUMATO_TRY(check_viewport(picture.viewport));
  if (!(options.page_width_pt.value_or(1) > 0) || !is_positive(options.dpi) ||
      !is_positive(options.max_error))
    return make_error(StatusCode::bad_input, "the options of an EPS must be positive numbers");
  SFUMATO_TRY(
      check_page(picture.viewport, points_per_unit(options.page_width_pt, picture.viewport)));
  return picture::check_picture(context, picture);
}

Result<std::vector<std::uint8_t>> write(Context& context, const Picture& picture,
                                        const EpsOptions& options, ExportNotes* notes) {
  SFUMATO_TRY(check(context, picture, options));
  ExportNotes unread;
  return EpsWriter(context, picture, options,
                   points_per_unit(options.page_width_pt, picture.viewport),
                   notes ? notes : &unread)
      .write();
}

}  // namespace
}  // namespace outputs

Result<std::vector<std::uint8_t>> export_eps(Context& context, const Picture& picture,
                                             const EpsOptions& options, ExportNotes* notes) {
  return public_verb(context, [&] { return outputs::write(context, picture, options, notes); });
}

}  // namespace sfumato
