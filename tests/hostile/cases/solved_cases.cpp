// Solved pictures with false data under a correct checksum.
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "hostile/case.hpp"
#include "picture/checksum.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::hostile {
namespace {

/// A picture file, written part after part (docs/picture-file.md).
class Solved {
 public:
  Solved() { bytes_.assign("SFPICT\x1a\x02\x04\x03\x02\x01", 12).append(16, '\0'); }

  template <class... Number>
  Solved& put(Number... numbers) {
    static_assert((std::is_arithmetic_v<Number> && ...));
    (bytes_.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
    return *this;
  }
  template <class Number>
  Solved& table(const std::vector<Number>& numbers, std::size_t columns = 1) {
    put(std::uint64_t{numbers.size() / columns}).pad();
    bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
    return *this;
  }
  Solved& pad(char with = '\0') {
    bytes_.append((16 - bytes_.size() % 16) % 16, with);
    return *this;
  }
  Solved& count(std::uint64_t items) { return put(items); }

  /// Writes origin, boxes, and no background.
  Solved& begin(double scale = 1, double side = 8) {
    put(1.0, 1.0, scale, 1.0);
    return put(0.0, 0.0, side, 6.0, 0.0, 0.0, side, 6.0, std::uint8_t{0}, std::uint8_t{0});
  }
  /// Writes no paints, and one layer of a triangle.
  Solved& layer(std::uint32_t corner = 2, float value = 0.5f, std::uint8_t edge = 1,
                std::uint32_t node = 9, std::int32_t channels = 3) {
    begin().count(0).count(1).put(0.0, 0.0, 8.0, 6.0, std::uint8_t{2});
    table<double>({0, 0, 8, 0, 8, 6}, 2).table<std::uint32_t>({0, 1, corner});
    table<std::uint8_t>({0, 1, edge}).count(0);
    put(channels).table<std::uint32_t>({0, 1, 2, 3, 4, 5, 6, 7, 8, node});
    table(std::vector<float>(30, value)).table<std::uint32_t>({});
    put(std::int32_t{0});
    return table<std::uint32_t>({}).table<float>({}).table<std::uint32_t>({});
  }
  Solved& instance(std::uint32_t of = 0, double a = 1, float opacity = 1, int blend = 0) {
    put(std::uint8_t{0}, of, a, 0.0, 0.0, 1.0, 0.0, 0.0, opacity);
    return put(static_cast<std::uint8_t>(blend));
  }
  Solved& group() { return put(std::uint8_t{2}, 1.0f, std::uint8_t{0}); }
  Solved& end_of_group() { return put(std::uint8_t{3}); }

  /// Returns the file with its size and checksum.
  std::string file() const {
    std::string file = bytes_;
    const std::uint64_t size = file.size();
    std::memcpy(&file[12], &size, sizeof size);
    const auto* data = reinterpret_cast<const std::uint8_t*>(file.data());
    const Context context;
    const auto sum = picture::checksum(context, std::span(data, file.size()).subspan(28));
    std::memcpy(&file[20], &*sum, sizeof *sum);
    return file;
  }

 private:
  std::string bytes_;
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t kMost = ~std::uint64_t{0};

std::string good() {
  return Solved().layer().count(1).instance().file();
}

std::string with_byte(std::size_t at, char byte) {
  std::string file = good();
  file[at] = byte;
  return file;
}

void add_solved_headers(Family& family) {
  family.add("as_it_is", kDone, "", good());
  family.add("magic_alone", kBadInput, "cut off", std::string("SFPICT\x1a"));
  family.add("header_alone", kBadInput, "it ends within a part", Solved().file());
  family.add("version_0", kBadInput, "only version 2", with_byte(7, '\0'));
  family.add("version_255", kBadInput, "only version 2", with_byte(7, '\xff'));
  family.add("order_of_none", kBadInput, "byte order is none", with_byte(8, '\0'));
  family.add("size_of_another", kBadInput, "are here", with_byte(19, '\x7f'));
  family.add("checksum_of_another", kBadInput, "checksum", with_byte(20, '\0'));
  family.add("twice", kBadInput, "are here", good() + good());
  family.add("and_more", kBadInput, "behind its end",
             Solved().layer().count(1).instance().put(std::uint8_t{0}).file());
  family.add("info", kBadInput, "checksum", "")
      .with("a.sfp", with_byte(99, '\x01'))
      .run({"info", "a.sfp"});
}

void add_lengths(Family& family) {
  const auto lying = [&](const char* name, const Solved& solved) {
    family.add(name, kBadInput, "damaged", solved.file());
  };
  for (const std::uint64_t length : {kMost, kMost / 2 + 1, std::uint64_t{1} << 40}) {
    const std::string ending = "_" + std::to_string(length);
    lying(("paints" + ending).c_str(), Solved().begin().count(length));
    lying(("layers" + ending).c_str(), Solved().begin().count(0).count(length));
    lying(("items" + ending).c_str(), Solved().begin().count(0).count(0).count(length));
    lying(("id" + ending).c_str(), Solved().begin().count(1).count(length).put(kMost, kMost));
    lying(("texels" + ending).c_str(),
          Solved().begin().count(1).count(0).put(std::uint8_t{1}, 1 << 30, 1 << 30, length, kMost));
    lying(("vertices" + ending).c_str(),
          Solved().begin().count(0).count(1).put(0.0, 0.0, 8.0, 6.0, std::uint8_t{2}, length, kMost,
                                                 kMost, kMost, kMost, kMost, kMost, kMost));
  }
  lying("padding", Solved()
                       .begin()
                       .count(0)
                       .count(1)
                       .put(0.0, 0.0, 8.0, 6.0, std::uint8_t{2})
                       .put(std::uint64_t{3})
                       .pad('x')
                       .put(kMost, kMost, kMost, kMost, kMost, kMost));
  lying("background_of_two", Solved().put(1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 8.0, 6.0, 0.0, 0.0, 8.0,
                                          6.0, std::uint8_t{0}, std::uint8_t{2}));
  lying("item_of_no_kind", Solved().layer().count(1).put(std::uint8_t{4}));
  lying("paint_of_no_kind", Solved().begin().count(1).count(0).put(std::uint8_t{2}));
}

void add_solved_values(Family& family) {
  const auto wrong = [&](const char* name, const char* message, const Solved& solved) {
    family.add(name, kBadInput, message, solved.file());
  };
  const auto shown = [](Solved& solved) { return solved.count(1).instance(); };
  const char* tables = "tables do not fit";
  Solved made[17];
  wrong("corner_of_none", tables, shown(made[0].layer(3)));
  wrong("node_of_none", tables, shown(made[1].layer(2, 0.5f, 1, 10)));
  wrong("channels_below_0", tables, shown(made[2].layer(2, 0.5f, 1, 9, -1)));
  wrong("channels_2_to_31", tables, shown(made[3].layer(2, 0.5f, 1, 9, 0x7fffffff)));
  wrong("value_infinite", "no finite values", shown(made[4].layer(2, float(kInfinity))));
  wrong("value_no_number", "no finite values",
        shown(made[5].layer(2, std::numeric_limits<float>::quiet_NaN())));
  wrong("edge_of_2", "wrong frame or edges", shown(made[6].layer(2, 0.5f, 2)));
  wrong("scale_0", "a scale or an error", made[7].begin(0).count(0).count(0).count(0));
  wrong("scale_infinite", "a scale or an error",
        made[8].begin(kInfinity).count(0).count(0).count(0));
  wrong("no_area", "without an area", made[9].begin(1, 0).count(0).count(0).count(0));
  wrong("area_infinite", "without an area",
        made[10].begin(1, kInfinity).count(0).count(0).count(0));
  wrong("layer_of_none", "stack item 0", made[11].layer().count(1).instance(1));
  wrong("map_without_inverse", "stack item 0", made[12].layer().count(1).instance(0, 0));
  wrong("opacity_of_2", "stack item 0", made[13].layer().count(1).instance(0, 1, 2));
  wrong("blend_of_none", "stack item 0", made[14].layer().count(1).instance(0, 1, 1, 16));
  wrong("group_without_end", "group", made[15].layer().count(1).group());
  wrong("area_of_nothing", "too small or too far",
        made[16].begin(1, 1e-150).count(0).count(0).count(0));
}

void add_masses(Family& family) {
  family.add("items_200001", kLimit, "the limit of 200000", [] {
    Solved solved;
    solved.layer().count(200'001);
    for (int i = 0; i < 200'001; ++i) solved.end_of_group();
    return solved.file();
  });
  family.add("instances_50000_of_few_pixels", kDone, "", [] {
    Solved solved;
    solved.layer().count(50'000);
    for (int i = 0; i < 50'000; ++i) solved.instance(0, 0.001);
    return solved.file();
  });
  family.add("groups_within_each_other", kLimit, "group", [] {
    Solved solved;
    solved.layer().count(2000);
    for (int i = 0; i < 1000; ++i) solved.group();
    for (int i = 0; i < 1000; ++i) solved.end_of_group();
    return solved.file();
  });
  family.add("layers_4097", kLimit, "the limit of 4096 layers", [] {
    Solved solved;
    solved.begin().count(0).count(4097);
    for (int i = 0; i < 4097; ++i) {
      solved.put(0.0, 0.0, 8.0, 6.0, std::uint8_t{2});
      solved.table<double>({}).table<std::uint32_t>({}).table<std::uint8_t>({}).count(0);
      for (const std::int32_t channels : {3, 0}) {
        solved.put(channels);
        solved.table<std::uint32_t>({}).table<float>({}).table<std::uint32_t>({});
      }
    }
    return solved.count(0).file();
  });
  family
      .add("memory_of_items", kLimit, "memory",
           [] {
             Solved solved;
             solved.layer().count(190'000);
             for (int i = 0; i < 190'000; ++i) solved.end_of_group();
             return solved.file();
           })
      .also({"--max-memory", "16"});
  family.add("bytes_beyond_the_limit", kLimit, "bytes", [] { return good(); })
      .also({"--limit", "input-bytes=30"});
  family.add("bytes_beyond_a_drawings_limit", kBadInput, "are here",
             [] { return good() + std::string(std::size_t{64} << 20, 'x'); });
}

void add_solved_cases(Family& family) {
  add_solved_headers(family);
  add_lengths(family);
  add_solved_values(family);
  add_masses(family);
}

const Register kSolved("solved", add_solved_cases);

}  // namespace
}  // namespace sfumato::hostile
