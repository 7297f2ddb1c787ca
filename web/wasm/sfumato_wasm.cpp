#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "sfumato/formats/read_document.hpp"
#include "sfumato/solve/diffuse.hpp"

/// The library for JavaScript: plain functions over the module's memory. One picture at a time;
/// `sfumato_diffuse` replaces what the call before left. Pointers are valid until the next call;
/// memory may grow in any call, so views onto it are to be made anew.
///
///   const text = sfumato_allocate(byte_count);   // write the document there
///   const failed = sfumato_diffuse(text, byte_count, max_error);
///   failed ? sfumato_error() : sfumato_node_values() …; sfumato_free(text);
namespace {

struct State {
  std::vector<float> node_values;
  std::string error;
};

State& state() {
  static State instance;
  return instance;
}

sfumato::Status diffuse_document(std::string_view text, double max_error) {
  sfumato::Context context;
  auto read = sfumato::read_document(context, text, "document");
  if (!read) return read.status();
  sfumato::DiffuseOptions options;
  options.max_error = max_error;
  auto picture = sfumato::diffuse(context, read->document, options);
  if (!picture) return picture.status();
  for (const sfumato::PatchLayer& layer : picture->layers) {
    for (const sfumato::PatchField* field : {&layer.color, &layer.opacity}) {
      state().node_values.insert(state().node_values.end(), field->node_value.begin(),
                                 field->node_value.end());
    }
  }
  return sfumato::ok_status();
}

}  // namespace

#define SFUMATO_EXPORT(name) extern "C" __attribute__((export_name(#name)))

SFUMATO_EXPORT(sfumato_allocate) void* sfumato_allocate(std::size_t byte_count) {
  return std::malloc(byte_count);
}

SFUMATO_EXPORT(sfumato_free) void sfumato_free(void* memory) {
  std::free(memory);
}

/// Diffuses a document of any format, not packed: SVG or Orzan's XML. max_error in code values as
/// DiffuseOptions has it. Returns 0, or 1 where sfumato_error holds the reason.
SFUMATO_EXPORT(sfumato_diffuse)
int sfumato_diffuse(const char* text, std::size_t byte_count, double max_error) {
  state() = {};
  const sfumato::Status status = diffuse_document({text, byte_count}, max_error);
  if (!status) state().error = sfumato::to_string(status);
  return status ? 0 : 1;
}

/// The node values of all layers in order, of each those of colour, then those of opacity; channel
/// by channel within a node (PatchLayer).
SFUMATO_EXPORT(sfumato_node_values) const float* sfumato_node_values() {
  return state().node_values.data();
}

SFUMATO_EXPORT(sfumato_node_value_count) std::size_t sfumato_node_value_count() {
  return state().node_values.size();
}

/// Why the last sfumato_diffuse failed: UTF-8, ended by 0.
SFUMATO_EXPORT(sfumato_error) const char* sfumato_error() {
  return state().error.c_str();
}
