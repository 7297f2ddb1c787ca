#include <gtest/gtest.h>

#include "cli/commands/templates.hpp"
#include "cli/embedded.hpp"
#include "cli/run_command.hpp"

namespace sfumato::test {
namespace {

TEST(Init, every_template_is_valid_and_lint_is_content) {
  const TemporaryFolder folder;
  for (std::string_view known : cli::kTemplates) {
    const std::string file = folder.path(std::string(known) + ".svg");
    const CommandResult made = run_sfumato({"init", file, "--template", std::string(known)});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    const CommandResult lint = run_sfumato({"lint", "--strict", file});
    EXPECT_EQ(lint.exit_code, 0) << lint.out << lint.err;
    EXPECT_EQ(lint.err, "");
  }
}

TEST(Init, replaces_a_file_only_when_asked) {
  const TemporaryFolder folder;
  const std::string file = folder.add("mine.svg", "precious");
  const CommandResult refused = run_sfumato({"init", file});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_NE(refused.err.find("--force"), std::string::npos) << refused.err;
  EXPECT_EQ(read_whole(file), "precious");
  EXPECT_EQ(run_sfumato({"init", file, "--force"}).exit_code, 0);
  EXPECT_NE(read_whole(file), "precious");
}

TEST(Init, writes_to_stdout) {
  const CommandResult result = run_sfumato({"init", "-"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, cli::embedded_file("shape.svg"));
}

TEST(Init, never_replaces_what_it_reads) {
  const TemporaryFolder folder;
  const std::string icon =
      folder.add("icon.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 9 9\"/>");
  EXPECT_EQ(run_sfumato({"init", icon, "--from", icon, "--force"}).exit_code, 3);
}

TEST(Init, brings_over_an_icon_with_its_title) {
  const TemporaryFolder folder;
  const std::string icon = folder.add(
      "icon.svg",
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 64 64\"><title>A &amp; B</title>"
      "<rect x=\"8\" y=\"8\" width=\"48\" height=\"48\" rx=\"9\" fill=\"#246\"/>"
      "<path id=\"tick\" d=\"M20 32 L30 42 L46 22\" fill=\"none\" stroke=\"#fff\" "
      "stroke-width=\"5\" stroke-linecap=\"round\" stroke-linejoin=\"round\"/></svg>");
  const std::string drawing = folder.path("drawing.svg");
  const CommandResult made = run_sfumato({"init", drawing, "--from", icon});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.err, "");
  const std::string text = read_whole(drawing);
  EXPECT_NE(text.find("<title>A &amp; B</title>"), std::string::npos);
  EXPECT_NE(text.find("id=\"tick\""), std::string::npos);
  const CommandResult lint = run_sfumato({"lint", "--strict", drawing});
  EXPECT_EQ(lint.exit_code, 0) << lint.out << lint.err;
}

TEST(Init, unknown_templates_and_names_are_bad_usage) {
  EXPECT_EQ(run_sfumato({"init", "-", "--template", "cat"}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"init", "drawing.png"}).exit_code, 2);
}

}  // namespace
}  // namespace sfumato::test
