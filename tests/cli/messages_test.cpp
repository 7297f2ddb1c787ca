#include "cli/messages.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "base/limit_error.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::cli {
namespace {

Status error(SourcePlace where) {
  return make_error(StatusCode::bad_input, "all is lost", std::move(where));
}

TEST(FormatMessage, puts_the_place_where_editors_look_for_it) {
  EXPECT_EQ(format_message(error({"a.xml", 3, 7}), "error"), "a.xml:3:7: error: all is lost\n");
  EXPECT_EQ(format_message(error({"a.xml", 3, 0}), "warning"), "a.xml:3: warning: all is lost\n");
  EXPECT_EQ(format_message(error({"a.xml", 0, 0}), "error"), "a.xml: error: all is lost\n");
  EXPECT_EQ(format_message(error({}), "error"), "sfumato: error: all is lost\n");
}

TEST(FormatMessage, keeps_control_characters_away) {
  EXPECT_EQ(format_message(make_error(StatusCode::io, "a\nb\x1b[0m\x7f"), "error"),
            "sfumato: error: a?b?[0m?\n");
}

TEST(FormatMessage, names_the_option_that_sets_another_limit) {
  Status status = limit_error(Limits{}, &Limits::curves, "curves", {"a.svg"});
  EXPECT_EQ(format_message(status, "error"),
            "a.svg: error: more than the limit of 200000 curves; raise the limit with --limit "
            "curves=N\n");
  for (const auto& [limit, option] :
       {std::pair{"memory", "; raise the limit with --max-memory MIB"},
        std::pair{"time", "; raise the limit with --max-time SECONDS"},
        std::pair{"viewer-triangles", ", or make fewer with a larger --max-error"}}) {
    status.limit = limit;
    EXPECT_NE(format_message(status, "error").find(option), std::string::npos) << limit;
  }
  status.limit = "image-side";  // the default is the highest
  EXPECT_NE(format_message(status, "error")
                .find("--limit image-side=N goes up to 16384; use a smaller image\n"),
            std::string::npos);
  EXPECT_EQ(format_message(make_error(StatusCode::limit, "too much"), "error"),
            "sfumato: error: too much\n");
}

TEST(ExitCodes, stand_for_their_status) {
  EXPECT_EQ(exit_code(ok_status()), 0);
  EXPECT_EQ(exit_code(make_error(StatusCode::bad_input, "")), 1);
  EXPECT_EQ(exit_code(make_error(StatusCode::limit, "")), 3);
  EXPECT_EQ(exit_code(make_error(StatusCode::io, "")), 3);
  EXPECT_EQ(exit_code(make_error(StatusCode::out_of_memory, "")), 3);
  EXPECT_EQ(exit_code(make_error(StatusCode::internal, "")), 4);
}

}  // namespace
}  // namespace sfumato::cli
