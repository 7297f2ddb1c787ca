// The command with little memory, stack, few threads, or no output to write to.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "support/places.hpp"
#include "support/sanitizers.hpp"

namespace sfumato::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

constexpr const char* kStack = "ulimit -s 256; exec \"$@\"";  // KiB

/// Runs the command from a shell script; "$@" is the command and its arguments.
CommandResult run_in_shell(const std::string& script, Names arguments) {
  arguments.insert(arguments.begin(), {"/bin/sh", "-c", script, "sh", sfumato_program()});
  return run_command(std::move(arguments));
}

std::string example(const char* name) {
  return source_path("examples/") + name;
}

TEST(ScarceMemory, is_its_exit_code_and_its_message_and_no_output) {
#if SFUMATO_HAS_SANITIZER
  GTEST_SKIP() << "sanitizers take more address space than these limits leave";
#endif
  const TemporaryFolder folder;
  const std::string output = folder.path("out.png");
  std::size_t refused = 0, drawn = 0;
  const auto run = [&](int mebibytes, const char* threads, const char* width) {
    fs::remove(output);
    const std::string limit = "ulimit -v " + std::to_string(1024 * mebibytes);
    const CommandResult result =
        run_in_shell(limit + "; exec \"$@\"", {"render", example("textures.svg"), "-o", output,
                                               "--quiet", "--threads", threads, "--width", width});
    const std::string what = std::to_string(mebibytes) + " MiB, " + threads + " threads: ";
    ASSERT_TRUE(result.exit_code == 0 || result.exit_code == 3)
        << what << result.exit_code << ' ' << result.err;
    (result.exit_code == 0 ? drawn : refused) += 1;
    ASSERT_EQ(fs::exists(output), result.exit_code == 0) << what;
    if (result.exit_code == 3) {
      ASSERT_NE(result.err.find("memory"), std::string::npos) << what << result.err;
    }
  };
  for (int mebibytes = 24; mebibytes <= 120; mebibytes += 8) {
    for (const char* threads : {"1", "4"}) run(mebibytes, threads, "2500");
  }
  // With room for two threads.
  for (const int mebibytes : {300, 420}) run(mebibytes, "2", "10000");
  EXPECT_GT(refused, 0u);
  EXPECT_GT(drawn, 0u);
  EXPECT_LE(folder.names().size(), 1u);
}

TEST(ScarceMemory, gives_fewer_threads_and_ends_no_process) {
#if SFUMATO_HAS_SANITIZER
  GTEST_SKIP() << "sanitizers take more address space than these limits leave";
#endif
  const TemporaryFolder folder;
  const std::string input = folder.add("in.xml", two_curve_scene());
  // Several times each, because a thread's address space depends on random addresses.
  const auto run = [&](int mebibytes, const char* threads) {
    const std::string limit = "ulimit -v " + std::to_string(1024 * mebibytes);
    const CommandResult result = run_in_shell(
        limit + "; exec \"$@\"",
        {"render", input, "-o", folder.path("out.png"), "--quiet", "--threads", threads});
    EXPECT_EQ(result.exit_code, 0) << mebibytes << " MiB, " << threads << ": " << result.err;
  };
  for (const int mebibytes : {110, 120, 140, 200, 300, 420, 600, 1000, 2000}) {
    for (const char* threads : {"3", "16", "64", "256", "1024"}) {
      for (int i = 0; i < 4; ++i) run(mebibytes, threads);
    }
  }
}

/// With slightly more memory than the loader needs, memory runs out in the initialisers of global
/// objects, and then in noexcept functions of the option parser.
TEST(ScarceMemory, ends_no_process_by_a_signal_while_it_starts) {
#if SFUMATO_HAS_SANITIZER
  GTEST_SKIP() << "sanitizers take more address space than these limits leave";
#endif
  constexpr int kFirst = 12'000, kLast = 22'000, kStep = 48;  // KiB
  std::size_t refused = 0, done = 0;
  for (int kibibytes = kFirst; kibibytes < kLast; kibibytes += kStep) {
    const CommandResult result =
        run_in_shell("ulimit -v " + std::to_string(kibibytes) + "; exec \"$@\"",
                     {"info", example("sunset.svg")});
    // With less memory than the command needs to answer, the system's loader fails in its own ways.
    const bool is_answer = result.exit_code == 0 || result.exit_code == 3;
    if (!is_answer && result.exit_code != 128 + SIGABRT && refused + done == 0) continue;
    ASSERT_TRUE(is_answer) << kibibytes << " KiB: " << result.exit_code << ' ' << result.err;
    (result.exit_code == 0 ? done : refused) += 1;
  }
  EXPECT_GT(refused, 0u);
  EXPECT_GT(done, 0u);
}

TEST(ProcessorTime, that_is_over_is_told) {
#if SFUMATO_HAS_SANITIZER
  GTEST_SKIP() << "sanitizers work too slowly to stop within a second";
#endif
  const TemporaryFolder folder;
  const CommandResult result = run_in_shell(
      "ulimit -S -t 1; exec \"$@\"", {"render", example("apple.svg"), "-o", folder.path("a.png"),
                                      "--width", "16000", "--method", "pixels", "--quiet"});
  EXPECT_EQ(result.exit_code, 128 + SIGXCPU) << result.err;
  EXPECT_EQ(result.err, "sfumato: error: the processor time is used up; raise it with ulimit -t\n");
}

TEST(IgnoredSignals, stay_ignored) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  // Reads the pipe until somebody writes; the signals arrive meanwhile.
  const std::string script =
      "trap '' HUP INT TERM; \"$@\" & id=$!; sleep .3; kill -HUP $id; kill -INT $id; "
      "kill -TERM $id; sleep .1; cat '" +
      folder.add("in.xml", two_curve_scene()) + "' >'" + pipe + "'; wait $id";
  const CommandResult result = run_in_shell(script, {"info", pipe});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "layers")) << result.out;
}

class SmallStack : public testing::TestWithParam<std::string> {};

TEST_P(SmallStack, is_enough) {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "3"}) {
    const CommandResult result = run_in_shell(
        kStack,
        {"render", GetParam(), "-o", folder.path("out.png"), "--quiet", "--threads", threads});
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  EXPECT_EQ(run_in_shell(kStack, {"lint", GetParam()}).exit_code, 0);
  EXPECT_EQ(run_in_shell(kStack, {"info", GetParam()}).exit_code, 0);
  EXPECT_EQ(run_in_shell(kStack, {"convert", GetParam(), "-o", folder.path("a.svg")}).exit_code, 0);
}

TEST(SmallStackOf, every_output_is_enough) {
  const TemporaryFolder folder;
  for (const char* extension :
       {"html", "pdf", "eps", "svg", "glb", "sfv", "npz", "ply", "json", "jpg", "webp"}) {
    const std::string output = folder.path(std::string("out.") + extension);
    for (const char* name : {"textures.svg", "strokes.svg", "apple.svg"}) {
      const CommandResult result = run_in_shell(
          kStack, {"render", example(name), "-o", output, "--quiet", "--max-error", "16"});
      EXPECT_EQ(result.exit_code, 0) << extension << result.err;
    }
  }
}

/// Returns the examples, and the public scenes if present.
Names drawings() {
  Names found;
  for (const std::string& folder : {source_path("examples"), shared_path("scenes")}) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      const std::string extension = entry.path().extension();
      if (extension == ".svg" || extension == ".xml") found.push_back(entry.path().string());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

INSTANTIATE_TEST_SUITE_P(For, SmallStack, testing::ValuesIn(drawings()), [](const auto& instance) {
  return fs::path(instance.param).stem().string();
});

std::string small_svg(const std::string& content) {
  return R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" )"
         R"(viewBox="0 0 64 48" sf:version="1">)" +
         content + "</svg>";
}

struct DeepInput {
  const char* name;
  std::string text;
};

std::vector<DeepInput> deep_inputs() {
  const std::string layer = R"(<g sf:diffuse="true"><path d="M0 9L64 20" sf:left="red"/></g>)";
  std::string uses = "<g id='u0'>" + layer + "</g>";
  for (int i = 1; i < 1000; ++i) {
    uses += "<g id='u" + std::to_string(i) + "'><use href='#u" + std::to_string(i - 1) + "'/></g>";
  }
  const auto nested = [&](const std::string& open, std::size_t count) {
    return small_svg(repeated(open, count) + layer + repeated("</g>", count));
  };
  return {
      {"as_deep_as_allowed", nested("<g>", 250)},
      {"deeper_than_allowed", nested("<g>", 300)},
      {"a_million_groups", nested("<g>", 1'000'000)},
      {"groups_never_closed", small_svg(repeated("<g>", 100'000))},
      {"deep_compositing", nested("<g opacity='.9'>", 16)},
      {"too_deep_compositing", nested("<g opacity='.9'>", 200)},
      {"deep_switches", nested("<a><g>", 120) + "</a>"},
      {"a_chain_of_uses", small_svg("<defs>" + uses + "</defs><use href='#u999'/>")},
      {"a_circle_of_uses", small_svg("<g id='a'><use href='#a'/></g>")},
      {"transforms",
       small_svg("<g transform='" + repeated("rotate(1) ", 100'000) + "'>" + layer + "</g>")},
      {"brackets", small_svg(repeated("<![CDATA[", 50'000))},
      {"a_deep_doctype", "<!DOCTYPE svg [" + repeated("<![", 100'000) + "]>" + small_svg(layer)},
      {"orzan", repeated("<curve_set>", 100'000)}};
}

TEST(SmallStackOf, deep_inputs_is_enough) {
  const TemporaryFolder folder;
  for (const DeepInput& input : deep_inputs()) {
    const std::string path = folder.add("in.svg", input.text);
    const CommandResult result = run_in_shell(
        kStack, {"render", path, "-o", folder.path("out.png"), "--quiet", "--threads", "2"});
    EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1 || result.exit_code == 3)
        << input.name << ": " << result.exit_code << result.err;
  }
}

/// Scripts that start the command, "$@", with an output that accepts nothing, and print its exit
/// code.
TEST(NoOutput, is_an_io_error_and_no_signal) {
  const TemporaryFolder folder;
  const std::string input = folder.add("in.xml", two_curve_scene());
  for (const char* script : {"\"$@\" >&-; echo $? >&2", "{ \"$@\"; echo $? >&2; } | true",
                             "{ sleep .1; \"$@\"; echo $? >&2; } | head -c 100 >/dev/null; true"}) {
    for (const Names& arguments :
         {Names{"render", input, "-o", "-", "--width", "800", "--format", "png"},
          Names{"convert", input, "-o", "-"}}) {
      const CommandResult result = run_in_shell(script, arguments);
      const bool is_short = arguments[0] == "convert" && result.err == "0\n";  // fits a pipe
      EXPECT_TRUE(is_short || result.err.ends_with("\n3\n")) << script << ": " << result.err;
    }
  }
}

TEST(NoOutput, closed_streams_are_no_reason_to_write_into_the_picture) {
  const TemporaryFolder folder;
  const std::string input = folder.add("in.xml", two_curve_scene());
  const std::string open = folder.path("open.png"), closed = folder.path("closed.png");
  ASSERT_EQ(run_sfumato({"render", input, "-o", open}).exit_code, 0);
  const CommandResult result = run_in_shell("\"$@\" <&- >&- 2>&-", {"render", input, "-o", closed});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(read_whole(open) == read_whole(closed));
}

TEST(NoStandardError, gives_the_exit_code_all_the_same) {
  const TemporaryFolder folder;
  const std::string input = folder.add("in.xml", two_curve_scene());
  const std::string code = folder.path("code");
  const std::string to_nobody =
      "{ sleep .1; \"$@\" 2>&1 >/dev/null; echo $? >'" + code + "'; } | true";
  const std::string to_a_full_file =
      "(ulimit -f 0; exec \"$@\" 2>'" + folder.path("err") + "'); echo $? >'" + code + "'";
  const std::string to_nothing = "\"$@\" 2>&-; echo $? >'" + code + "'";
  for (const std::string& script : {to_nobody, to_a_full_file, to_nothing}) {
    run_in_shell(script, {"info", folder.path("none")});
    EXPECT_EQ(read_whole(code), "1\n") << script;
    run_in_shell(script, {"info", "--nonsense", input});
    EXPECT_EQ(read_whole(code), "2\n") << script;
    run_in_shell(script, {"render", input, "-o", folder.path("none/a.png")});
    EXPECT_EQ(read_whole(code), "3\n") << script;
  }
}

TEST(ReadOnlyFileSystem, is_an_io_error) {
  const TemporaryFolder folder;
  const std::string input = folder.add("in.xml", two_curve_scene());
  const CommandResult result = run_sfumato({"render", input, "-o", "/proc/sfumato.png"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("cannot be written"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace sfumato::test
