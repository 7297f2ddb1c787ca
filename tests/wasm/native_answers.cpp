// Prints the native library's answer, for tests/wasm/run.mjs to compare with the module's:
// native_answers QUESTION IN [OPTIONS] writes the answer's bytes to standard output.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "sfumato/sfumato.h"

namespace {

/// A document that was read, and solved if requested.
struct Work {
  sfumato_context* context = sfumato_context_new("");
  sfumato_document* document = nullptr;
  sfumato_picture* picture = nullptr;
  std::string options;
};

void put(const void* bytes, std::size_t count) {
  if (count > 0) std::fwrite(bytes, 1, count, stdout);
}

/// Returns false if there are no bytes.
bool put_and_free(sfumato_bytes* bytes) {
  put(sfumato_bytes_data(bytes), sfumato_bytes_size(bytes));
  sfumato_bytes_free(bytes);
  return bytes != nullptr;
}

bool solve(Work& work) {
  return !sfumato_solve(work.context, work.document, work.options.c_str(), &work.picture);
}

/// Writes every table of every layer, row after row.
bool put_tables(const sfumato_picture* picture) {
  for (std::uint32_t layer = 0; layer < sfumato_picture_layer_count(picture); ++layer) {
    for (std::uint32_t table = SFUMATO_VERTICES; table <= SFUMATO_OPACITY_VALUES; ++table) {
      sfumato_view view;
      if (sfumato_picture_table(picture, layer, table, &view)) return false;
      put(view.data, view.rows * view.row_bytes);
    }
  }
  return true;
}

/// Moves a curve of the first layer by 2 to the right and 1 down.
bool move_curve(Work& work, std::uint32_t curve) {
  sfumato_view view;
  if (sfumato_curve_points(work.document, 0, curve, &view)) return false;
  std::vector<double> xy(2 * view.rows);
  std::memcpy(xy.data(), view.data, view.rows * view.row_bytes);
  for (std::size_t i = 0; i < xy.size(); ++i) xy[i] += i % 2 == 0 ? 2 : 1;
  return !sfumato_set_curve_points(work.context, work.document, 0, curve, xy.data(), view.rows);
}

/// Writes the quick picture after the first curves have moved.
bool put_moved(Work& work, std::uint32_t curves) {
  if (!solve(work)) return false;
  for (std::uint32_t curve = 0; curve < curves; ++curve) {
    if (!move_curve(work, curve)) return false;
  }
  return !sfumato_solve_again(work.context, work.document, 1, work.picture) &&
         put_tables(work.picture);
}

/// Writes the first layer's colours at 16 by 16 points inside the artboard.
bool put_colors(Work& work) {
  constexpr int kSide = 16;
  double box[4];
  sfumato_field* field = nullptr;
  sfumato_document_artboard(work.document, box);
  if (sfumato_field_new(work.context, work.document, 0, work.options.c_str(), &field)) return false;
  std::vector<double> xy;
  for (int i = 0; i < kSide * kSide; ++i) {
    xy.push_back(box[0] + (i % kSide + 0.5) / kSide * box[2]);
    xy.push_back(box[1] + (i / kSide + 0.5) / kSide * box[3]);
  }
  std::vector<float> rgba(4 * kSide * kSide);
  const std::int32_t failed =
      sfumato_field_colors(work.context, field, xy.data(), kSide * kSide, rgba.data());
  put(rgba.data(), rgba.size() * sizeof(float));
  sfumato_field_free(field);
  return !failed;
}

/// Writes 64 by 64 pixels.
bool put_pixels(Work& work) {
  constexpr int kSide = 64;
  std::vector<std::uint8_t> pixels(4 * kSide * kSide);
  const sfumato_image image{pixels.data(), 4 * kSide, kSide, kSide, SFUMATO_RGBA8};
  if (!solve(work) || sfumato_raster(work.context, work.picture, &image, "")) return false;
  put(pixels.data(), pixels.size());
  return true;
}

/// Writes a trace of 64 by 64 pixels of the drawing, as SVG.
bool put_traced(Work& work) {
  constexpr int kSide = 64;
  std::vector<std::uint8_t> pixels(4 * kSide * kSide);
  const sfumato_image image{pixels.data(), 4 * kSide, kSide, kSide, SFUMATO_RGBA8};
  const std::string options = std::exchange(work.options, "");
  if (!solve(work) || sfumato_raster(work.context, work.picture, &image, "")) return false;
  sfumato_document* traced = nullptr;
  sfumato_bytes* bytes = nullptr;
  if (!sfumato_trace(work.context, &image, options.c_str(), nullptr, &traced)) {
    sfumato_document_write(work.context, traced, &bytes);
  }
  sfumato_document_free(traced);
  return put_and_free(bytes);
}

/// Writes the file that a picture is exported as.
bool put_exported(Work& work, const char* format, const char* options) {
  sfumato_bytes* bytes = nullptr;
  if (solve(work)) sfumato_export(work.context, work.picture, format, options, &bytes);
  return put_and_free(bytes);
}

bool answer(const std::string& question, Work& work) {
  sfumato_bytes* bytes = nullptr;  // stays null if a call fails
  if (question == "tables") return solve(work) && put_tables(work.picture);
  if (question == "dragged") return put_moved(work, 1);
  if (question == "rough") return put_moved(work, 2);
  if (question == "colors") return put_colors(work);
  if (question == "pixels") return put_pixels(work);
  if (question == "pdf") return put_exported(work, "pdf", "title=A");
  if (question == "image") return put_exported(work, "svg", "");
  if (question == "vector") return put_exported(work, "svg", "svg=vector");
  if (question == "traced") return put_traced(work);
  if (question == "lint") {
    sfumato_lint(work.context, work.document, work.options.c_str(), &bytes);
  }
  if (question == "svg") sfumato_document_write(work.context, work.document, &bytes);
  if (question == "payload" && solve(work)) {
    sfumato_viewer_payload(work.context, work.picture, "", &bytes);
  }
  if (question == "file" && solve(work)) {
    sfumato_picture_write(work.context, work.picture, &bytes);
  }
  if (question == "stack" && solve(work)) {
    sfumato_picture_stack(work.context, work.picture, "", &bytes);
  }
  if (question == "exact" && solve(work)) {
    sfumato_exact_layer(work.context, work.picture, 0, &bytes);
  }
  return put_and_free(bytes);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs(
        "usage: native_answers tables|dragged|colors|pixels|traced|svg|payload|stack|"
        "exact|file|lint|pdf|image|vector IN [OPTIONS]\n",
        stderr);
    return 2;
  }
  std::ifstream file(argv[2], std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  Work work;
  if (argc > 3) work.options = argv[3];
  // The pixels of given.svg.
  std::uint8_t pixels[] = {250, 200, 0, 255, 0, 90, 200, 255, 255, 255, 255, 0, 20, 20, 20, 128};
  const sfumato_image given{pixels, 8, 2, 2, SFUMATO_RGBA8};
  const bool is_answered =
      !sfumato_add_image(work.context, "image", 5, &given) &&
      !sfumato_read(work.context, text.data(), text.size(), argv[2], nullptr, &work.document) &&
      answer(argv[1], work);
  if (!is_answered) std::fprintf(stderr, "%s\n", sfumato_error_text(work.context));
  sfumato_picture_free(work.picture);
  sfumato_document_free(work.document);
  sfumato_context_free(work.context);
  return is_answered ? 0 : 1;
}
