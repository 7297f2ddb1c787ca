#include <gtest/gtest.h>

#include <regex>

#include "cli/run_command.hpp"

namespace sfumato::test {
namespace {

std::string help_json() {
  const CommandResult result = run_sfumato({"help", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return result.out;
}

/// Returns the JSON of one command.
std::string json_of(const std::string& command) {
  const std::string all = help_json();
  const std::size_t begin = all.find("{\"name\":\"" + command + "\",\"summary\"");
  EXPECT_NE(begin, std::string::npos) << command;
  return all.substr(begin, all.find("{\"name\":", begin + 1) - begin);
}

TEST(Help, the_command_prints_what_the_option_prints) {
  EXPECT_EQ(run_sfumato({"help"}).out, run_sfumato({"--help"}).out);
  for (const std::string command : {"render", "trace", "help"}) {
    const CommandResult result = run_sfumato({"help", command});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out, run_sfumato({command, "--help"}).out);
  }
}

TEST(Help, usages_are_lines_of_the_help) {
  EXPECT_TRUE(contains(run_sfumato({"help", "solve"}).out,
                       "Usage: sfumato solve IN -o OUT.sfp [OPTIONS]\n"
                       "       sfumato solve IN... --out-dir DIR [OPTIONS]\n"));
}

TEST(Help, the_json_is_one_line) {
  const std::string json = help_json();
  EXPECT_EQ(json.find('\n'), json.size() - 1);
  EXPECT_TRUE(json.starts_with("{\"version\":\"0."));
  EXPECT_TRUE(contains(json, "\"exit_codes\":[{\"code\":0,\"meaning\":\"done\"},"));
}

TEST(Help, the_json_describes_operands_and_options) {
  const std::string render = json_of("render");
  for (const char* part :
       {"\"operands\":[{\"names\":[\"IN\"],",
        "\"kind\":\"file\",\"is_output\":false,\"extensions\":[\"svg\",\"svgz\",\"xml\",\"sfp\"],"
        "\"is_required\":true,\"is_repeatable\":true}]",
        "{\"names\":[\"--out-dir\"],", "\"excludes\":[\"--output\"]",
        "{\"names\":[\"--order\"],\"description\":\"Choose how to interpolate inside a triangle\","
        "\"default\":\"cubic\",\"kind\":\"choice\",\"choices\":[\"linear\",\"quadratic\",\"cubic\"]"
        ",",
        "\"default\":\"64\",\"kind\":\"whole\",\"lowest\":1,\"highest\":4096,"
        "\"expected\":\"a whole number from 1 to 4096\",\"value_name\":\"N\",",
        "\"default\":\"1; with 16 bits "
        "0.25\",\"kind\":\"number\",\"choices\":[\"off\"],\"above\":0,"
        "\"highest\":255,",
        "\"kind\":\"limit\",\"choices\":[\"input-bytes\",\"unpack-ratio\","}) {
    EXPECT_TRUE(contains(render, part)) << part;
  }
  EXPECT_TRUE(contains(json_of("trace"), "\"needs\":[\"--colors-only\"]"));
  EXPECT_TRUE(contains(json_of("solve"), "\"choices\":[\"exact\",\"rays\"],\"value_name\""));
}

TEST(Help, every_value_has_a_kind_and_no_default_stays_in_a_description) {
  const std::string json = help_json();
  const std::regex text(
      "\\{\"names\":\\[([^\\]]*)\\],\"description\":\"([^\"]*)\"[^{]*?\"kind\":\"(\\w+)\"");
  int count = 0;
  for (std::sregex_iterator i(json.begin(), json.end(), text), end; i != end; ++i, ++count) {
    EXPECT_EQ((*i)[2].str().find('['), std::string::npos) << (*i)[1];
    if ((*i)[3] != "text") continue;
    const std::string name = (*i)[1];
    EXPECT_TRUE(name == "\"--title\"" || name == "\"--only\"" || name == "\"--shard\"") << name;
  }
  EXPECT_GT(count, 150);
}

TEST(Help, bad_calls_say_what_to_do) {
  const auto message = [](std::vector<std::string> arguments) {
    const CommandResult result = run_sfumato(std::move(arguments));
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  EXPECT_TRUE(contains(message({"help", "nosuch"}),
                       "sfumato: error: unknown command \"nosuch\"; use render, solve, "));
  EXPECT_TRUE(contains(message({"help", "rendr"}), "or help; did you mean render?\n"));
  EXPECT_TRUE(contains(message({"help", "--jsn"}), "for help; did you mean --json?\n"));
  EXPECT_EQ(message({"help", "render", "--json"}),
            "sfumato: error: --json: describes all commands; leave out \"render\"\n"
            "Try 'sfumato help --help'.\n");
  EXPECT_EQ(
      message({"--json", "help"}),
      "sfumato: error: option \"--json\" before the command; use it after info, lint, compare "
      "or help\nTry 'sfumato help --help'.\n");
  EXPECT_TRUE(contains(message({"--width", "9"}),
                       "before the command; use it after render, solve, tiles or watch\n"));
}

}  // namespace
}  // namespace sfumato::test
