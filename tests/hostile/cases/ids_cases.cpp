// Ids: missing, duplicate, endless, or with colliding hashes.
#include <cstdint>
#include <cstring>

#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

// MurmurHash64A as in libstdc++, for one block of 8 bytes: std::hash of a string uses it.
constexpr std::uint64_t kMultiplier = 0xc6a4a7935bd1e995u;

std::uint64_t mixed(std::uint64_t block) {
  block *= kMultiplier;
  block ^= block >> 47;
  return block * kMultiplier;
}

std::uint64_t unmixed(std::uint64_t value) {
  std::uint64_t inverse = 1;
  for (int i = 0; i < 6; ++i) inverse *= 2 - kMultiplier * inverse;  // Newton, modulo 2^64
  value *= inverse;
  value ^= value >> 47;
  return value * inverse;
}

bool may_stand_in_an_attribute(std::uint64_t block) {
  for (int i = 0; i < 8; ++i) {
    const auto byte = static_cast<unsigned char>(block >> (8 * i));
    if (byte <= 0x20 || byte == '\'' || byte == '&' || byte == '<' || byte == '"') return false;
  }
  return true;
}

/// Two texts of 16 bytes that take the hash from `state` to the same state.
struct Pair {
  std::string text[2];
};

Pair colliding(std::uint64_t& state) {
  Pair pair;
  std::uint64_t target = 0;
  int found = 0;
  for (std::uint64_t number = 0; found < 2; ++number) {
    std::uint64_t first = 0x6161616161616161u;
    for (int i = 0; i < 8; ++i) first += ((number >> (4 * i)) & 15) << (8 * i);
    const std::uint64_t middle = (state ^ mixed(first)) * kMultiplier;
    std::uint64_t second = 0x6262626262626262u;
    if (found == 0) {
      target = (middle ^ mixed(second)) * kMultiplier;
    } else {
      std::uint64_t inverse = 1;
      for (int i = 0; i < 6; ++i) inverse *= 2 - kMultiplier * inverse;
      second = unmixed(middle ^ (target * inverse));
    }
    if (!may_stand_in_an_attribute(second)) continue;
    std::string& text = pair.text[found++];
    text.resize(16);
    std::memcpy(text.data(), &first, 8);
    std::memcpy(text.data() + 8, &second, 8);
  }
  state = target;
  return pair;
}

/// Returns 2^bits texts of one length with the same std::hash.
std::vector<std::string> of_one_hash(int bits) {
  std::uint64_t state = 0xc70f6907u ^ (static_cast<std::uint64_t>(16 * bits) * kMultiplier);
  std::vector<std::string> texts{""};
  for (int i = 0; i < bits; ++i) {
    const Pair pair = colliding(state);
    std::vector<std::string> longer;
    for (const std::string& text : texts) {
      longer.push_back(text + pair.text[0]);
      longer.push_back(text + pair.text[1]);
    }
    texts = std::move(longer);
  }
  return texts;
}

std::string joined(const std::string& prefix, const std::vector<std::string>& texts,
                   const std::string& suffix) {
  std::string all;
  for (const std::string& text : texts) all += prefix + text + suffix;
  return all;
}

void add_collisions(Family& family) {
  family.add("of_one_hash", kDone, "",
             [] { return svg(joined("<g id='", of_one_hash(16), "'/>") + kLayer); });
  family
      .add("of_one_hash_written_back", kDone, "",
           [] {
             return layer(joined("<path d='M9 9h9' sf:left='red' id='", of_one_hash(14), "'/>"));
           })
      .run({"convert", "in.svg", "-o", "out.svg"});
  family
      .add("classes_of_one_hash", kDone, "",
           [] {
             return svg("<style>" + joined(".", of_one_hash(13), "{fill:red}") + "</style>" +
                        kLayer);
           })
      .message = "is not read; use selectors";
  family.add("textures_of_one_hash", kBadInput, "in.svg:3", [] {
    return svg("<g sf:diffuse='true'><path d='M9 9h9v9' sf:left='url(#p0)'/></g>\n" +
               joined("<pattern id='p0'><image href='", of_one_hash(4), "'/></pattern>"));
  });
}

void add_endless(Family& family) {
  const char* limit = "more than the limit of 1024 bytes of an id";
  family.add("id_of_a_megabyte", kLimit, limit, [] {
    return layer("<path id='" + repeated("x", kMillion) + "' d='M9 9h9' sf:left='red'/>");
  });
  family.add("id_of_a_megabyte_of_100000_curves", kLimit, limit, [] {
    return layer("<path id='" + repeated("x", kMillion) + "' d='" + repeated("M9 9h9", 100'000) +
                 "' sf:left='red'/>");
  });
  family.add("id_of_a_megabyte_of_100000_local_curves", kLimit, limit, [] {
    return svg("<path id='" + repeated("x", kMillion) + "' d='" + repeated("M9 9h9", 100'000) +
               "' sf:left='red' sf:radius='1'/>");
  });
  family
      .add(
          "id_of_a_kilobyte_copied_100000_times", kDone, "",
          [] {
            return svg(laughs(4, repeated("<use id='" + repeated("x", 1024) + "' href='#c'/>", 2)) +
                       "<defs><path id='c' d='M9 9h9' sf:left='red'/></defs>"
                       "<g sf:diffuse='true'><use href='#g4'/></g>");
          })
      .run({"info", "in.svg"})
      .message = "was given before";
  family
      .add("id_of_a_kilobyte_of_50000_curves", kDone, "",
           [] {
             return layer("<path id='" + repeated("x", 1024) + "' d='" +
                          repeated("M9 9h9", 50'000) + "' sf:left='red'/>");
           })
      .run({"info", "in.svg"});
  family.add("ids_a_million", kDone, "",
             [] { return svg(numbered("<g id='a", kMillion, "'/>") + kLayer); });
  family.add("ids_a_million_equal", kDone, "the id \"a\" was given before",
             [] { return svg(repeated("<g id='a'/>", kMillion) + kLayer); });
  family.add("references_to_an_id_of_a_kilobyte", kDone, "", [] {
    const std::string id = repeated("x", 1024);
    return svg("<defs><g id='" + id +
               "' sf:diffuse='true'><path d='M9 9h9' sf:left='red'/></g>"
               "</defs>" +
               repeated("<use href='#" + id + "'/>", 20));
  });
}

void add_odd_ids(Family& family) {
  family.add("empty", kDone, "", svg("<g id=''/><g id=''/>" + kLayer));
  family.add("reference_to_the_empty_one", kBadInput, "href of <use> is \"#\"",
             svg("<g id=''/><use href='#'/>"));
  family.add("reference_to_nothing", kBadInput, "refers to #a, but no element has that id",
             svg("<use href='#a'/>"));
  family.add("reference_long_to_nothing", kBadInput, "refers to #xxxx",
             [] { return svg("<use href='#" + repeated("x", kMillion) + "'/>"); });
  family.add("reference_to_a_file", kBadInput, "use # and the id of an element",
             svg("<use href='other.svg#a'/>"));
  family.add("reference_of_control_characters", kBadInput, "but no element has that id",
             svg("<use href='#&#27;[2J&#7;'/>"));
  family.add("given_twice", kDone, "the id \"a\" was given before; the first one counts",
             svg("<g id='a'/><g id='a'/>" + kLayer));
  family
      .add("written_back_as_names", kDone, "",
           layer("<path id='1 &lt;&gt;&quot;&amp;&#39;' d='M9 9h9' sf:left='red'/><path id='&#9;' "
                 "d='M9 19h9' sf:left='red'/>"))
      .run({"convert", "in.svg", "-o", "out.svg"});
  family
      .add("written_back_numbered", kDone, "",
           [] {
             return layer("<path id='a' d='" + repeated("M9 9h9", 20'000) + "' sf:left='red'/>" +
                          numbered("<path id='a-", 20'000, "' d='M9 9h9' sf:left='red'/>"));
           })
      .run({"convert", "in.svg", "-o", "out.svg"});
}

void add_ids_cases(Family& family) {
  add_collisions(family);
  add_endless(family);
  add_odd_ids(family);
}

const Register kIds("ids", add_ids_cases);

}  // namespace
}  // namespace sfumato::hostile
