#include <bit>
#include <span>
#include <string>

#include "base/output_buffer.hpp"
#include "base/public_verb.hpp"
#include "base/try.hpp"
#include "codecs/zip_writer.hpp"
#include "document/names.hpp"
#include "export/page.hpp"
#include "export/tables/table_list.hpp"
#include "picture/check_picture.hpp"
#include "sfumato/export/tables/tables.hpp"

namespace sfumato {
namespace outputs {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr char kByteOrder = std::endian::native == std::endian::little ? '<' : '>';
/// The data of an array begin at a multiple of this in their file.
constexpr std::size_t kAlignment = 64;
/// Letters of the longest blend mode, "color-dodge".
constexpr std::size_t kBlendLetters = 11;

Bytes bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string type_text(NumberType type) {
  if (type == NumberType::u8) return "|u1";
  constexpr const char* kTypes[] = {"", "u4", "f4", "f8"};
  return std::string(1, kByteOrder) + kTypes[static_cast<std::size_t>(type)];
}

/// Returns the header of NumPy's format 1.0 (numpy.lib.format).
std::string array_header(const std::string& type, const std::string& shape) {
  std::string text = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
  constexpr std::size_t kPrefix = 10;
  const std::size_t whole = (kPrefix + text.size() + 1 + kAlignment - 1) / kAlignment * kAlignment;
  text.resize(whole - kPrefix - 1, ' ');
  text += '\n';
  const auto size = static_cast<unsigned>(text.size());
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(size & 0xff);
  header += static_cast<char>(size >> 8);
  return header + text;
}

class NpzWriter {
 public:
  NpzWriter(const Context& context, OutputBuffer& file)
      : context_(context), file_(file), zip_(context, file) {}

  void add(const std::string& name, const Table& table) {
    std::string shape = "(" + std::to_string(table.rows()) + ",";
    if (table.columns > 1) shape += " " + std::to_string(table.columns);
    add(name, array_header(type_text(table.type), shape + ")"), table.bytes);
  }

  /// Writes an array of words in UTF-32, as NumPy has them; without `is_list` a single word.
  void add_words(const std::string& name, std::span<const std::string_view> words,
                 std::size_t letters, bool is_list = true) {
    TableMemory memory("words of an NPZ");
    std::vector<char32_t> text;
    file_.fail(memory.resize(context_, text, words.size() * letters));
    if (!file_.status()) return;
    for (std::size_t i = 0; i < words.size(); ++i) {
      for (std::size_t k = 0; k < words[i].size(); ++k) {
        text[i * letters + k] = static_cast<unsigned char>(words[i][k]);
      }
    }
    const std::string type = std::string(1, kByteOrder) + "U" + std::to_string(letters);
    const std::string shape = is_list ? "(" + std::to_string(words.size()) + ",)" : "()";
    add(name, array_header(type, shape),
        {reinterpret_cast<const std::uint8_t*>(text.data()), text.size() * sizeof(char32_t)});
  }

  void finish() { zip_.finish(); }

 private:
  void add(const std::string& name, const std::string& header, Bytes data) {
    const Bytes parts[] = {bytes_of(header), data};
    zip_.add(name + ".npy", parts);
  }

  const Context& context_;
  OutputBuffer& file_;
  codecs::ZipWriter zip_;
};

std::vector<double> corners(const Box& box) {
  return {box.min.x, box.min.y, box.width(), box.height()};
}

void add_picture(const Picture& picture, NpzWriter& npz) {
  npz.add("artboard", table_of("", 1, corners(picture.artboard)));
  npz.add("viewport", table_of("", 1, corners(picture.viewport)));
  std::vector<float> background;
  if (const auto& color = picture.background) background = {color->r, color->g, color->b};
  npz.add("background", table_of("", 1, background));
  const std::string_view space = space_name(picture.interpolation);
  npz.add_words("interpolation", {&space, 1}, space.size(), false);
}

Result<std::vector<std::uint8_t>> write_npz(const Context& context, const Picture& picture,
                                            ExportNotes* notes) {
  SFUMATO_TRY(check_viewport(picture.viewport));
  SFUMATO_TRY(picture::check_picture(context, picture));
  OutputBuffer file(context, "the NPZ");
  NpzWriter npz(context, file);
  add_picture(picture, npz);
  SFUMATO_TRY_ASSIGN(const InstanceTables& instances, list_instances(context, picture));
  npz.add("instances", table_of("", kInstanceColumns, instances.row));
  npz.add_words("blends", instances.blend, kBlendLetters);
  for (std::size_t i = 0; i < picture.layers.size(); ++i) {
    SFUMATO_TRY_ASSIGN(const LayerTables& layer, list_tables(context, picture.layers[i]));
    const std::string prefix = "layer" + std::to_string(i) + "/";
    for (const Table& table : layer.tables) npz.add(prefix + std::string(table.name), table);
    if (!file.status()) return file.status();
  }
  npz.finish();
  note_omissions(picture, notes);
  return file.finish();
}

}  // namespace
}  // namespace outputs

Result<std::vector<std::uint8_t>> export_npz(Context& context, const Picture& picture,
                                             ExportNotes* notes) {
  return public_verb(context, [&] { return outputs::write_npz(context, picture, notes); });
}

}  // namespace sfumato
