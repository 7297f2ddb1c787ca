// CSS Syntax 3, sections 4 and 5: tokens and declarations.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/poll.hpp"
#include "formats/css/declarations.hpp"
#include "formats/css/media.hpp"
#include "formats/css/selector.hpp"
#include "formats/css/tokenizer.hpp"
#include "formats/each_text.hpp"

namespace sfumato {
namespace {

using enum css::TokenType;

/// Returns letters for types: i(dent) f(unction) @ #(id) h(ash) s(tring) S(bad) u(rl) U(bad)
/// d(elim) n(umber) % D(imension) _(whitespace) <(CDO) >(CDC); brackets and signs stand for
/// themselves.
std::string types_of(std::string_view text) {
  constexpr std::string_view kLetters = ".if@hsSuUdn%D_<>:;,[](){}";
  css::TextPoll poll;
  css::Tokenizer tokens(text, poll);
  std::string types;
  for (css::Token token = tokens.next(); !token.is(end); token = tokens.next()) {
    types += token.is(hash) && token.is_id ? '#' : kLetters[static_cast<std::size_t>(token.type)];
  }
  return types;
}

css::Token first_of(std::string_view text) {
  static css::TextPoll poll;
  return css::Tokenizer(text, poll).next();
}

TEST(CssTokenizer, cuts_as_the_standard_says) {
  EXPECT_EQ(types_of(""), "");
  EXPECT_EQ(types_of("a"), "i");
  EXPECT_EQ(types_of("-a --a -1a -"), "i_i_D_d");
  EXPECT_EQ(types_of("a(b c)"), "fi_i)");
  EXPECT_EQ(types_of("@a @-a @1 @"), "@_@_dn_d");
  EXPECT_EQ(types_of("#a #1 #-1 #"), "#_h_h_d");
  EXPECT_EQ(types_of("1 +1 -.5 1e3 1e 1.x .x"), "n_n_n_n_D_ndi_di");
  EXPECT_EQ(types_of("1% 1%a 1em"), "%_%i_D");
  EXPECT_EQ(types_of("<!-- --> <-- -->"), "<_>_di_>");
  EXPECT_EQ(types_of("a:b;c,[d](e){f}"), "i:i;i,[i](i){i}");
  EXPECT_EQ(types_of("a!b > c ~ *|d"), "idi_d_i_d_ddi");
  EXPECT_EQ(types_of("\xC3\xA9\xFF"), "i") << "what is not ASCII makes names";
}

TEST(CssTokenizer, comments_part_tokens_and_are_none) {
  EXPECT_EQ(types_of("/* a */"), "");
  EXPECT_EQ(types_of("a/* b */c"), "ii");
  EXPECT_EQ(types_of("a /**/ /* * / */ b"), "i___i");
  EXPECT_EQ(types_of("a/* no end"), "i");
  EXPECT_EQ(types_of("/*/a*/b"), "i");
  EXPECT_EQ(types_of("'/* no comment */'"), "s");
  EXPECT_EQ(types_of("url(/*b*/)"), "u");
}

TEST(CssTokenizer, strings_end_at_their_quote_or_the_text_or_break_at_a_line) {
  EXPECT_EQ(first_of("'a\"b'").value, "a\"b");
  EXPECT_EQ(first_of("\"a\\\"b\" c").value, "a\\\"b");
  EXPECT_EQ(first_of("'a").value, "a");
  EXPECT_EQ(types_of("'a\nb'"), "S_is");
  EXPECT_EQ(types_of("'a\\\nb'"), "s") << "an escaped newline is left out";
  EXPECT_EQ(css::unescaped(first_of("'a\\\r\nb'").value), "ab");
  EXPECT_EQ(types_of("'a\\"), "s");
  EXPECT_EQ(types_of("'}'\";\""), "ss");
}

TEST(CssTokenizer, urls_have_no_quotes_blanks_or_parentheses_within) {
  EXPECT_EQ(first_of("url(a.png)").value, "a.png");
  EXPECT_EQ(first_of("url(  a  )").value, "a");
  EXPECT_EQ(first_of("URL(a").value, "a");
  EXPECT_EQ(first_of("\\75rl(a)").value, "a");
  EXPECT_EQ(first_of("url(a\\)b)").value, "a\\)b");
  EXPECT_EQ(types_of("url(a b)c"), "Ui");
  EXPECT_EQ(types_of("url(a(b)c"), "Ui");
  EXPECT_EQ(types_of("url(a'b)c"), "Ui");
  EXPECT_EQ(types_of("url(a b\\)c)d"), "Ui");
  EXPECT_EQ(types_of("url( 'a')"), "f_s)");
  EXPECT_EQ(types_of("url('a' b)"), "fs_i)");
}

TEST(CssTokenizer, escapes_name_characters) {
  EXPECT_EQ(css::unescaped("r\\65 d"), "red");
  EXPECT_EQ(css::unescaped("r\\000065d"), "red");
  EXPECT_EQ(css::unescaped("\\72\\65\\64"), "red");
  EXPECT_EQ(css::unescaped("\\72\r\n\\65\t\\64\f"), "red") << "one blank ends each";
  EXPECT_EQ(css::unescaped("\\g\\-\\@"), "g-@");
  EXPECT_EQ(css::unescaped("\\e9 \\20ac\\1f600"), "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
  test::expect_of_each({"\\0", "\\d800", "\\110000", "\\ffffff"}, css::unescaped, "\xEF\xBF\xBD");
  EXPECT_EQ(types_of("\\\na"), "d_i") << "a newline is not escaped outside of strings";
  EXPECT_TRUE(css::is_named("IMP\\6fRTANT", "important"));
  EXPECT_FALSE(css::is_named("importan", "important"));
  EXPECT_TRUE(css::is_named("\\important", "important"));
  EXPECT_FALSE(css::is_named("\\abort", "abort")) << "a and b are digits";
}

/// Returns "name=value" or "name=value!" for each declaration, and "~" for skipped text.
std::string declarations_in(std::string_view text, bool in_block = false) {
  css::TextPoll poll;
  css::Tokenizer tokens(text, poll);
  std::string list;
  const bool passed_over = css::read_declarations(tokens, in_block, [&](const css::Declaration& d) {
    list += css::unescaped(d.name) + "=" + std::string(d.value) + (d.is_important ? "! " : " ");
  });
  list += passed_over ? "~" : "";
  if (in_block) list += std::string(text.substr(tokens.position()));
  return list;
}

TEST(CssDeclarations, are_cut_at_semicolons_outside_of_strings_and_brackets) {
  EXPECT_EQ(declarations_in("a:b;c : d ;;; e:f"), "a=b c=d e=f ");
  EXPECT_EQ(declarations_in("a:';';b:(;);c:[;];d:url(;);e:{;}"),
            "a=';' b=(;) c=[;] d=url(;) e={;} ");
  EXPECT_EQ(declarations_in("/* a */ b /**/:/**/ c /* d:e; */;f:g"), "b=/**/ c f=g ");
  EXPECT_EQ(declarations_in("a:;b:c"), "a= b=c ");
}

TEST(CssDeclarations, know_importance_in_any_case_with_blanks_and_comments) {
  EXPECT_EQ(declarations_in("a:b!important;c:d ! /**/ IMPORTANT ;e:f !\\69mportant"),
            "a=b! c=d! e=f! ");
  EXPECT_EQ(declarations_in("a:b !important c;d:e"), "d=e ~");
  EXPECT_EQ(declarations_in("a:b !important !important;d:e"), "d=e ~");
  EXPECT_EQ(declarations_in("a:b !importan;c:!d;e:f!"), "~");
  EXPECT_EQ(declarations_in("a:(b !important);c:'!important'"), "a=(b !important) c='!important' ");
}

TEST(CssDeclarations, that_are_wrong_end_at_their_semicolon) {
  EXPECT_EQ(declarations_in("a;b:c"), "b=c ~");
  EXPECT_EQ(declarations_in("a b:c;d:e"), "d=e ~");
  EXPECT_EQ(declarations_in("1a:b;.c:d;#e:f;g:h"), "g=h ~");
  EXPECT_EQ(declarations_in("a:b);c:d"), "c=d ~");
  EXPECT_EQ(declarations_in("a:'b\n;c:d"), "c=d ~");
  EXPECT_EQ(declarations_in("@a b;c:d"), "c=d ~");
  EXPECT_EQ(declarations_in("@a {b:c} d:e"), "d=e ~");
  EXPECT_EQ(declarations_in("a:b}c:d;e:f"), "e=f ~");
}

TEST(CssDeclarations, pass_over_rules_within) {
  EXPECT_EQ(declarations_in("a{b:c}d:e"), "d=e ~");
  EXPECT_EQ(declarations_in("a:b{c:d}e:f"), "e=f ~");
  EXPECT_EQ(declarations_in("& .x > y{b:c;d:{e}}f:g"), "f=g ~");
  EXPECT_EQ(declarations_in("--a:b{c:d}e;f:g"), "--a=b{c:d}e f=g ");
}

TEST(CssDeclarations, of_a_block_end_with_its_brace) {
  EXPECT_EQ(declarations_in("a:b}c", true), "a=b c");
  EXPECT_EQ(declarations_in("a:'}';b:url(});c:({})}d", true), "a='}' b=url(}) c=({}) d");
  EXPECT_EQ(declarations_in("a{b}}c", true), "~c");
  EXPECT_EQ(declarations_in("a:b!}c", true), "~c");
  EXPECT_EQ(declarations_in("a:(b}c", true), "a=(b}c ");
  EXPECT_EQ(declarations_in("}", true), "");
}

char media_of(std::string_view text) {
  css::TextPoll poll;
  return "+-?"[static_cast<std::size_t>(css::media_of(text, poll))];
}

TEST(CssMedia, screen_and_all_match_and_other_media_do_not) {
  test::expect_of_each(
      {"", " ", "/**/", "all", "SCREEN", "only screen", "print, screen", "not print",
       "not all, all", "scr\\65 en", "(a), all", "1, screen", "screen,print)"},
      media_of, '+');
  test::expect_of_each(
      {"print", "tty", "not screen", "not all", "only", "not", "and", "or", "screen print",
       "\"screen\"", "print and (a)", ",", "all or (a)", "[screen]", "not not print"},
      media_of, '-');
  test::expect_of_each(
      {"(min-width: 1px)", "screen and (color)", "not (a)", "print, (a)", "not screen and (color)"},
      media_of, '?');
}

TEST(CssSelector, tells_simple_ones_from_others_and_from_wrong_ones) {
  const auto kinds_of = [](std::string_view text) {
    css::TextPoll poll;
    css::Tokenizer tokens(text, poll);
    std::string kinds;
    std::vector<css::SelectorPart> parts;
    for (;;) {
      const css::Selector selector = css::take_selector(tokens, parts);
      kinds += "*e.#cu!"[static_cast<std::size_t>(selector.kind)];
      if (selector.is_last) return kinds;
    }
  };
  EXPECT_EQ(kinds_of("*, a, .b, #c, -d, .\\31 e,/**/f"), "*e.#e.e");
  EXPECT_EQ(kinds_of("a.b, a b, a>b, a + b~c, [a], [a=','], [a~=b i], *.a, a:first-child, "
                     ":root, a:not(.b), a:HOVER"),
            "cccccccccccc");
  EXPECT_EQ(
      kinds_of("a:b, a::b(c,d), &, a|b, *|*, [a|b], [=a], :not(a,b), :not(a b), a:nth-child(2)"),
      "uuuuuuuuuu");
  EXPECT_EQ(kinds_of(""), "!");
  EXPECT_EQ(kinds_of("a,,b,"), "e!e!");
  EXPECT_EQ(kinds_of("1a,#1,. a,>a,a>,a>>b,a!,.a*,.,(a),:,{},'a'"), "!!!!!!!!!!!!!");
}

TEST(CssTokenizer, deep_brackets_end_somewhere) {
  const std::string text = "a:" + std::string(5000, '(') + ";b:c";
  EXPECT_EQ(declarations_in(text).substr(0, 4), "a=((");
}

/// Counts the polls, and stops at the last one.
struct Stopping : PollWatch {
  int looks = 0;
  void polled() override { ++looks; }
};

TEST(CssTokenizer, looks_at_the_flag_in_long_texts_and_ends_when_told) {
  const std::size_t size = std::size_t{2} << 20;
  for (const std::string& text :
       {std::string(size, ' '), std::string(size, 'a'), std::string(size, '1'),
        "/*" + std::string(size, '*'), "'" + std::string(size, 'a'),
        "url(" + std::string(size, 'a'), std::string(size, ';'), "#" + std::string(size, '\\'),
        "." + std::string(size, '1')}) {
    Context context;
    Stopping watch;
    context.poll_watch = &watch;
    css::TextPoll poll(context);
    css::Tokenizer tokens(text, poll);
    while (!tokens.next().is(end)) {
    }
    EXPECT_GE(watch.looks, 16) << text.substr(0, 5);
    context.cancel = true;
    css::TextPoll stopped(context);
    css::Tokenizer rest(text, stopped);
    while (!rest.next().is(end)) {
    }
    EXPECT_EQ(stopped.status().code, StatusCode::cancelled) << text.substr(0, 5);
  }
}

}  // namespace
}  // namespace sfumato
