// Options of `render` with invalid values.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string label_of(const std::string& option, const std::string& what) {
  std::string label = option.substr(2) + "_" + what;
  for (char& c : label) c = c == '-' ? '_' : c;
  return label;
}

void add_options_cases(Family& family) {
  const std::string good = svg(kLayer);
  const auto with = [&](const std::string& name, int code, const std::string& message,
                        const std::vector<std::string>& more) -> Case& {
    return family.add(name, code, message, good).also(more);
  };
  const char* kNumberOptions[] = {"--width",     "--height",    "--scale",      "--rays",
                                  "--seed",      "--tolerance", "--max-error",  "--max-area",
                                  "--min-angle", "--threads",   "--max-memory", "--quality",
                                  "--detail",    "--dpi",       "--viewport"};
  const std::pair<const char*, std::string> kBad[] = {{"empty", ""},
                                                      {"word", "many"},
                                                      {"nan", "nan"},
                                                      {"negative", "-1"},
                                                      {"infinite", "inf"},
                                                      {"overflow", "1e999"},
                                                      {"digits", repeated("9", 400)},
                                                      {"unicode", "１２"},
                                                      {"two_numbers", "1 2"},
                                                      {"hex", "0x10"},
                                                      {"bytes", "\xff\xfe"}};
  for (const char* option : kNumberOptions) {
    for (const auto& [what, value] : kBad) {
      with(label_of(option, what), kBadUsage, option, {std::string(option) + "=" + value});
    }
    with(label_of(option, "missing"), kBadUsage, option, {option});
    with(label_of(option, "long"), kBadUsage, option,
         {std::string(option) + "=" + repeated("x", 100'000)});
  }
  for (const char* option : {"--method", "--order", "--format", "--svg", "--device", "--gather",
                             "--depth", "--background"}) {
    with(label_of(option, "empty"), kBadUsage, option, {std::string(option) + "="});
    with(label_of(option, "unknown"), kBadUsage, option, {option, "nonsense"});
    with(label_of(option, "long"), kBadUsage, option, {option, repeated("x", 100'000)});
    with(label_of(option, "missing"), kBadUsage, option, {option});
  }
  for (const char* option :
       {"--width", "--scale", "--rays", "--threads", "--method", "--background"}) {
    const bool is_word = std::string(option) == "--method" || std::string(option) == "--background";
    const std::string value = is_word ? (std::string(option) == "--method" ? "exact" : "red") : "9";
    with(label_of(option, "twice"), kBadUsage, option, {option, value, option, value});
  }
  with("unknown_option", kBadUsage, "--fast", {"--fast"});
  with("unknown_option_long", kBadUsage, "--aaaa", {"--" + repeated("a", 100'000)});
  with("unknown_options_10000", kBadUsage, "-", std::vector<std::string>(10'000, "--fast"));
  with("operand_too_many", kBadUsage, "in.svg", {"in.svg"}).message = "sfumato";
  with("operands_10000", kBadUsage, "sfumato", std::vector<std::string>(10'000, "in.svg"));
  with("width_huge", kLimit, "the limit is 16384 pixels on a side", {"--width", "16385"});
  with("width_of_2_to_31", kBadUsage, "--width", {"--width", "2147483647"});
  with("width_of_2_to_32", kBadUsage, "--width", {"--width", "4294967296"});
  with("height_of_one", kDone, "", {"--height", "1"});
  with("scale_huge", kLimit, "the limit is 16384 pixels on a side", {"--scale", "1e300"});
  with("scale_tiny", kDone, "", {"--scale", "1e-9"});
  with("scale_vanishing", kDone, "", {"--scale", "1e-300"});
  with("width_and_scale", kBadUsage, "--scale", {"--width", "9", "--scale", "2"});
  with("threads_200", kDone, "", {"--threads", "200"});
  with("threads_1025", kBadUsage, "--threads", {"--threads", "1025"});
  with("tolerance_tiny", kDone, "", {"--tolerance", "1e-300"});
  with("tolerance_huge", kDone, "", {"--tolerance", "1e300"});
  with("max_error_tiny", kDone, "", {"--max-error", "1e-300"});
  with("max_error_huge", kBadUsage, "--max-error", {"--max-error", "1e300"});
  with("max_area_tiny", kLimit, "more than the limit of 8000000 triangles",
       {"--max-area", "1e-300"});
  with("min_angle_33", kDone, "", {"--min-angle", "33"});
  with("min_angle_tiny", kDone, "", {"--min-angle", "1e-300"});
  with("max_memory_1", kLimit, "memory limit of 1 MiB", {"--max-memory", "1", "--width", "2000"});
  with("rays_4096", kDone, "", {"--method", "rays", "--rays", "4096", "--width", "9"});
  with("seed_huge", kDone, "", {"--method", "rays", "--seed", "18446744073709551615"});
  with("seed_beyond", kBadUsage, "--seed", {"--seed", "18446744073709551616"});
  with("viewport_of_three", kBadUsage, "--viewport", {"--viewport", "0,0,1"});
  with("viewport_of_five", kBadUsage, "--viewport", {"--viewport", "0,0,1,1,1"});
  with("viewport_of_negative_size", kBadUsage, "--viewport", {"--viewport", "0,0,-1,-1"});
  with("viewport_far_away", kDone, "", {"--viewport", "9999900,9999900,50,50"});
  with("viewport_beyond", kBadUsage, "--viewport", {"--viewport", "9999999,0,50,50"});
  with("viewport_tiny", kBadUsage, "--viewport", {"--viewport", "50,25,1e-300,1e-300"});
  with("viewport_small", kDone, "", {"--viewport", "50,25,1e-6,1e-6", "--width", "20"});
  with("viewport_as_large_as_allowed", kDone, "",
       {"--viewport", "-1e7,-1e7,2e7,2e7", "--width", "50"});
  with("viewport_flat", kDone, "",
       {"--viewport", "0,25,100,1e-9", "--width", "50", "--height", "50"});
  with("title_with_png", kBadUsage, "--title", {"--title", "a"});
  with("title_long", kDone, "", {"--title", repeated("<script>&\"'", 10'000)})
      .run({"render", "in.svg", "-o", "out.html", "--title", repeated("<script>&\"'", 10'000)});
  with("title_of_bytes", kDone, "", {})
      .run({"render", "in.svg", "-o", "out.pdf", "--title", "\xff\xfe\x1b()\\\n"});
  with("background_translucent", kBadUsage, "--background", {"--background", "#12345678"});
  with("allow_files_missing", kBadUsage, "--allow-files", {"--allow-files", "nowhere"});
}

const Register kOptions("options", add_options_cases);

}  // namespace
}  // namespace sfumato::hostile
