#include <gtest/gtest.h>

#include "capi/handles.hpp"
#include "cli/run_command.hpp"

/// The hints equal the hints of the command.
namespace sfumato::test {
namespace {

/// Two curves in one place, a closed one, a layer without curves, and an id that needs escaping.
constexpr const char* kDoubtful = R"(<svg xmlns="http://www.w3.org/2000/svg"
    xmlns:sf="urn:sfumato:1" viewBox="0 0 64 48" sf:version="1">
  <g id="a &quot;b&quot;" sf:diffuse="true">
    <path id="first" d="M5 40 C20 44 40 36 60 40" sf:left="red" sf:right="blue"/>
    <path d="M5 40 C20 44 40 36 60 40" sf:left="red" sf:right="blue"/>
    <path d="M20 10 C30 10 30 20 20 20 C10 20 10 10 20 10 Z" sf:left="red" sf:right="gold"/>
  </g>
  <g sf:diffuse="true"/>
</svg>)";

std::string hints_of(const std::string& text, const char* options) {
  const ContextHandle context(sfumato_context_new("threads=2"));
  sfumato_document* document = nullptr;
  EXPECT_EQ(sfumato_read(context.get(), text.data(), text.size(), "<stdin>", nullptr, &document),
            SFUMATO_OK);
  const DocumentHandle freed(document);
  sfumato_document* copied = nullptr;
  EXPECT_EQ(sfumato_document_copy(context.get(), document, &copied), SFUMATO_OK);
  const DocumentHandle copy(copied);
  sfumato_bytes* bytes = nullptr;
  EXPECT_EQ(sfumato_lint(context.get(), copied, options, &bytes), SFUMATO_OK);
  return text_of(BytesHandle(bytes).get());
}

TEST(CLint, says_what_the_command_says) {
  for (const std::string& text :
       {std::string(kDoubtful), example("evening.xml"), example("fish.svg")}) {
    const std::string told = hints_of(text, "");
    EXPECT_EQ(told, run_sfumato({"lint", "--json", "--quiet", "-"}, text).out);
    EXPECT_EQ(hints_of(text, "verbose"),
              run_sfumato({"lint", "--json", "--verbose", "--quiet", "-"}, text).out);
  }
  EXPECT_NE(hints_of(kDoubtful, "").find(R"("kind":"duplicate")"), std::string::npos);
  EXPECT_NE(hints_of(kDoubtful, ""), hints_of(kDoubtful, "verbose"));
}

TEST(CLint, of_a_document_that_was_made_has_no_name) {
  const ContextHandle context(sfumato_context_new("threads=1"));
  sfumato_document* document = nullptr;
  ASSERT_EQ(sfumato_document_new(context.get(), "artboard=0,0,9,9", &document), SFUMATO_OK);
  const DocumentHandle freed(document);
  sfumato_bytes* bytes = nullptr;
  ASSERT_EQ(sfumato_lint(context.get(), document, nullptr, &bytes), SFUMATO_OK);
  EXPECT_EQ(text_of(BytesHandle(bytes).get()).substr(0, 30), R"({"file":"","hints":[{"kind":"e)");
}

}  // namespace
}  // namespace sfumato::test
