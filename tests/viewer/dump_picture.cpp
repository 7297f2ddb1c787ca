// Writes the data that the viewer must decode, for tests/viewer/run.mjs: dump_picture IN
// OUT.payload OUT.values OUT.stack. The payload is not deflated, and the stack is the payload
// without tables. The values are raw doubles: for each layer the triangles, channels of colour and
// of opacity, then for each triangle, in the viewer's order, its corners x, y and the ten nodes'
// values of each field.
#include <cstdio>
#include <sfumato/sfumato.hpp>
#include <vector>

#include "export/html/viewer_mesh.hpp"
#include "export/html/viewer_payload.hpp"

namespace {

using namespace sfumato;

void add_field(const PatchField& field, const outputs::ViewerMesh& mesh, std::uint32_t t,
               std::vector<double>& values) {
  const std::size_t channels = static_cast<std::size_t>(field.channel_count);
  if (channels == 0) return;
  const std::uint32_t turn = mesh.first_corner[t];
  for (std::uint32_t slot = 0; slot < 10; ++slot) {
    std::uint32_t from = slot;
    if (slot < 3) from = (slot + turn) % 3;
    if (slot >= 3 && slot < 9) from = 3 + (slot - 3 + 2 * turn) % 6;
    const std::uint32_t node = field.triangle_node[10 * std::size_t{mesh.triangle[t]} + from];
    for (std::size_t c = 0; c < channels; ++c)
      values.push_back(static_cast<double>(field.node_value[channels * node + c]));
  }
}

Status add_layer(Context& context, const PatchLayer& layer, std::vector<double>& values) {
  const Result<outputs::ViewerMesh> mesh = outputs::order_for_viewer(context, layer);
  if (!mesh) return mesh.status();
  values.push_back(mesh->triangle_count());
  values.push_back(layer.color.channel_count);
  values.push_back(layer.opacity.channel_count);
  for (std::uint32_t t = 0; t < mesh->triangle_count(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh->vertex[mesh->corner_vertex[3 * std::size_t{t} + k]];
      values.push_back(layer.vertex_position[vertex].x);
      values.push_back(layer.vertex_position[vertex].y);
    }
    add_field(layer.color, *mesh, t, values);
    add_field(layer.opacity, *mesh, t, values);
  }
  return ok_status();
}

Status dump(const std::string& in, const std::string& payload_path, const std::string& values_path,
            const std::string& stack_path) {
  Context context;
  auto text = read_file(in, limits::kInputBytes);
  if (!text) return text.status();
  auto read = read_document(context, *text, in);
  if (!read) return read.status();
  DiffuseOptions options;
  options.exact_fields = true;
  auto picture = diffuse(context, read->document, options);
  if (!picture) return picture.status();
  auto payload = outputs::viewer_payload(context, *picture, {1, 1, 1});
  if (!payload) return payload.status();
  if (Status status = write_file(payload_path, *payload); !status) return status;
  auto stack = outputs::viewer_stack(context, *picture, {1, 1, 1});
  if (!stack) return stack.status();
  if (Status status = write_file(stack_path, *stack); !status) return status;
  std::vector<double> values;
  for (const PatchLayer& layer : picture->layers)
    if (Status status = add_layer(context, layer, values); !status) return status;
  return write_file(values_path, {reinterpret_cast<const std::uint8_t*>(values.data()),
                                  values.size() * sizeof(double)});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("usage: dump_picture IN OUT.payload OUT.values OUT.stack\n", stderr);
    return 2;
  }
  const Status status = dump(argv[1], argv[2], argv[3], argv[4]);
  if (!status) std::fprintf(stderr, "%s\n", to_string(status).c_str());
  return status ? 0 : 1;
}
