#include "base/text/json.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace sfumato {
namespace {

TEST(JsonWriter, separates_members_and_nested_values) {
  JsonWriter json;
  json.begin_object().member("a", 1).key("b").begin_object().member("c", 0.5).end_object();
  json.key("d").begin_array().value(1).value(2).end_array().member("e", "f").end_object();
  EXPECT_EQ(json.text(), R"({"a":1,"b":{"c":0.5},"d":[1,2],"e":"f"})");
}

TEST(JsonWriter, knows_true_and_false) {
  JsonWriter json;
  json.begin_array().truth(true).truth(false).end_array();
  EXPECT_EQ(json.text(), "[true,false]");
}

TEST(JsonWriter, escapes_what_strings_may_not_hold) {
  EXPECT_EQ(JsonWriter().value("a\"b\\c\nd").text(), R"("a\"b\\c\u000ad")");
}

TEST(JsonWriter, writes_null_for_numbers_that_json_has_not) {
  EXPECT_EQ(JsonWriter().value(std::numeric_limits<double>::infinity()).text(), "null");
  EXPECT_EQ(JsonWriter().value(std::numeric_limits<double>::quiet_NaN()).text(), "null");
}

}  // namespace
}  // namespace sfumato
