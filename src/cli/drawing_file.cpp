#include "cli/drawing_file.hpp"

#include <span>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "cli/paths.hpp"
#include "codecs/deflate.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/formats/svg/svg_write.hpp"

namespace sfumato::cli {

Status write_drawing(Context& context, const Document& document, const std::string& output) {
  const Result<std::string> svg = write_svg(context, document);
  if (!svg) return svg.status();
  ScopedCharge charge;
  Status status = charge.add(context, capacity_bytes(*svg), "the drawing");
  if (!status) return status;
  const std::span text(reinterpret_cast<const std::uint8_t*>(svg->data()), svg->size());
  if (context.cancelled()) return context.cancel_status();
  if (!is_packed_name(output)) return write_file(output, text, &context);
  TableMemory memory("the drawing");
  const auto packed = codecs::gzipped(context, text, memory);
  return packed ? write_file(output, *packed, &context) : packed.status();
}

}  // namespace sfumato::cli
