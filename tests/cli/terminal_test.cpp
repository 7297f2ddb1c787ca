// No text of a drawing or a name can control a terminal or break JSON.
#include <gtest/gtest.h>

#include <array>

#include "base/text/utf8.hpp"
#include "cli/run_command.hpp"
#include "cli/scenes.hpp"

namespace sfumato::test {
namespace {

/// CSI of C0 and of C1, an override of direction, DEL, a byte that is not UTF-8.
const std::string kHarmful =
    "e\x1b[31m\xc2\x9b"
    "1m\xe2\x80\xae\x7f\xff";

std::string svg_with(const std::string& name, const std::string& id) {
  return R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 9 9">)"
         R"(<g sf:diffuse="true"><path )" +
         name + R"(="red" id=")" + id + R"(" d="M0 0L9 9 9 0Z" sf:left="red"/></g></svg>)";
}

void expect_harmless(const CommandResult& result) {
  for (const std::string& text : {result.out, result.err}) {
    EXPECT_EQ(printable(text, "\n"), text);
  }
}

TEST(Terminal, sees_no_control_of_a_drawing_or_of_its_name) {
  const TemporaryFolder folder;
  const std::string id =
      "a\xc2\x9b"
      "2J\xe2\x80\xae\xe2\x81\xa6";
  for (const std::string& svg : {svg_with("sf:le\xc2\x9b"
                                          "ft",
                                          "a"),
                                 svg_with("stroke", id), svg_with("sf:blur", id), id}) {
    const std::string input = folder.add(kHarmful + ".svg", svg);
    for (const char* command : {"info", "lint"}) {
      expect_harmless(run_sfumato({command, input}));
      expect_harmless(run_sfumato({command, input, "--json"}));
    }
    expect_harmless(run_sfumato({"lint", input, "--verbose"}));
    expect_harmless(run_sfumato({"convert", input, "-o", "-"}));
    expect_harmless(run_sfumato({"render", input, "-o", folder.path("a.png"), "--stats", "-"}));
    expect_harmless(run_sfumato({"render", input, "--out-dir", folder.path("o"), "--stats", "-"}));
    expect_harmless(run_sfumato({"compare", input, input}));
  }
  expect_harmless(run_sfumato({kHarmful}));
  expect_harmless(run_sfumato({"render", kHarmful, "-o", kHarmful}));
  expect_harmless(run_sfumato({"render", "a\nb\x1b", "-o", "a.png", "--width", kHarmful}));
}

TEST(Names, that_are_no_utf8_become_utf8_in_every_output) {
  const TemporaryFolder folder;
  const std::string input = folder.add("n\xff\xc3.svg", svg_with("class", "a"));
  for (const char* output : {"a.html", "a.svg", "a.eps"}) {
    const std::string path = folder.path(output);
    ASSERT_EQ(run_sfumato({"render", input, "-o", path, "--quiet"}).exit_code, 0);
    const std::string text = read_whole(path);
    EXPECT_TRUE(valid_utf8(text) == text) << output;
  }
  ASSERT_EQ(
      run_sfumato({"render", input, "-o", folder.path("a.html"), "--title", "t\xff"}).exit_code, 0);
  const std::string titled = read_whole(folder.path("a.html"));
  EXPECT_TRUE(valid_utf8(titled) == titled);
  for (const std::string& json :
       {run_sfumato({"info", "--json", input}).out, run_sfumato({"lint", "--json", input}).out}) {
    EXPECT_EQ(valid_utf8(json), json);
  }
}

}  // namespace
}  // namespace sfumato::test
