// Writes the node values of a document to standard output as raw floats, for tests/wasm/run.mjs:
// dump_nodes IN MAX_ERROR
#include <cstdio>
#include <cstdlib>
#include <sfumato/sfumato.hpp>

namespace {

sfumato::Status dump(const std::string& in, double max_error) {
  using namespace sfumato;
  Context context;
  auto text = read_file(in, limits::kInputBytes);
  if (!text) return text.status();
  auto read = read_document(context, *text, in);
  if (!read) return read.status();
  DiffuseOptions options;
  options.max_error = max_error;
  auto picture = diffuse(context, read->document, options);
  if (!picture) return picture.status();
  for (const PatchLayer& layer : picture->layers) {
    for (const PatchField* field : {&layer.color, &layer.opacity}) {
      std::fwrite(field->node_value.data(), sizeof(float), field->node_value.size(), stdout);
    }
  }
  return ok_status();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: dump_nodes IN MAX_ERROR\n", stderr);
    return 2;
  }
  const sfumato::Status status = dump(argv[1], std::atof(argv[2]));
  if (!status) std::fprintf(stderr, "%s\n", to_string(status).c_str());
  return status ? 0 : 1;
}
