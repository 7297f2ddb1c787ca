#include "equal/tool/trace.hpp"

#include <bit>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

#include "sfumato/base/native/file.hpp"

namespace sfumato::test {
namespace {

static_assert(std::endian::native == std::endian::little && sizeof(Vec2) == 16);

constexpr std::string_view kMagic = "sfumato trace 1\n";

class Reader {
 public:
  explicit Reader(std::string_view rest) : rest_(rest) {}

  bool at_end() const { return rest_.empty(); }

  bool take(void* to, std::size_t size) {
    if (size > rest_.size()) return false;
    if (size > 0) std::memcpy(to, rest_.data(), size);
    rest_.remove_prefix(size);
    return true;
  }

  /// Writes the number of items, and the items.
  template <class Items>
  bool take_items(Items& items) {
    std::uint64_t count = 0;
    const std::size_t item_size = sizeof(typename Items::value_type);
    if (!take(&count, sizeof count) || count > rest_.size() / item_size) return false;
    items.resize(static_cast<std::size_t>(count));
    return take(items.data(), items.size() * item_size);
  }

 private:
  std::string_view rest_;
};

template <class Items>
void append_items(std::string& bytes, const Items& items) {
  const std::uint64_t count = items.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(items.data()),
               items.size() * sizeof(typename Items::value_type));
}

bool take_array(Reader& reader, TraceArray& array) {
  return reader.take_items(array.stage) && reader.take(&array.type, sizeof array.type) &&
         array.type <= NumberType::f64 && reader.take(&array.width, sizeof array.width) &&
         array.width > 0 && reader.take_items(array.bytes) &&
         array.bytes.size() % size_of(array.type) == 0 && reader.take_items(array.position);
}

}  // namespace

std::size_t size_of(NumberType type) {
  constexpr std::size_t kSizes[] = {1, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

TraceArray points(std::string stage, const std::vector<Vec2>& values) {
  const auto* const first = reinterpret_cast<const std::uint8_t*>(values.data());
  return {
      std::move(stage), NumberType::f64, 2, {first, first + values.size() * sizeof(Vec2)}, values};
}

std::string trace_bytes(const Trace& trace) {
  std::string bytes(kMagic);
  for (const TraceArray& array : trace) {
    append_items(bytes, array.stage);
    bytes.append(reinterpret_cast<const char*>(&array.type), sizeof array.type);
    bytes.append(reinterpret_cast<const char*>(&array.width), sizeof array.width);
    append_items(bytes, array.bytes);
    append_items(bytes, array.position);
  }
  return bytes;
}

Result<Trace> parse_trace(std::string_view bytes) {
  const auto broken = [] { return make_error(StatusCode::bad_input, "not a whole trace"); };
  if (!bytes.starts_with(kMagic)) return broken();
  Reader reader(bytes.substr(kMagic.size()));
  Trace trace;
  while (!reader.at_end()) {
    if (!take_array(reader, trace.emplace_back())) return broken();
  }
  return trace;
}

Status save_trace(const std::string& path, const Trace& trace) {
  const std::string bytes = trace_bytes(trace);
  return write_file(path, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

Result<Trace> load_trace(const std::string& path) {
  const Result<std::string> bytes = read_file(path, std::numeric_limits<std::ptrdiff_t>::max());
  if (!bytes) return bytes.status();
  return parse_trace(*bytes);
}

}  // namespace sfumato::test
