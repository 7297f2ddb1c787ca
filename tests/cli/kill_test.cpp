// The command under kill -9: its output is the complete old one or the complete new one, and the
// next run leaves no other files. SFUMATO_KILLS is the number of kills; `make kills` uses 1,000.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "support/places.hpp"

namespace sfumato::test {
namespace {

using Clock = std::chrono::steady_clock;
using Names = std::vector<std::string>;

struct Killed {
  const char* name;
  const char* output;
  Names command;  ///< before the input and the output
  bool has_old;   ///< whether the output exists before
};

const Killed kKilled[] = {
    {"png_of_a_new_name", "out.png", {"render"}, false},
    {"png_of_an_existing_name", "out.png", {"render"}, true},
    {"vector_of_a_new_name", "out.svg", {"render", "--svg", "vector", "--force"}, false},
    {"vector_of_an_existing_name", "out.svg", {"render", "--svg", "vector", "--force"}, true},
    {"convert_to_a_new_name", "out.svg", {"convert"}, false},
    {"convert_to_an_existing_name", "out.svg", {"convert"}, true},
};

int kill_count() {
  const char* asked = std::getenv("SFUMATO_KILLS");
  return std::max(1, (asked ? std::atoi(asked) : 102) / static_cast<int>(std::size(kKilled)));
}

class Kill : public testing::TestWithParam<Killed> {
 protected:
  void SetUp() override {
    const auto begin = Clock::now();
    const CommandResult whole = start().wait();
    duration_ = Clock::now() - begin;
    ASSERT_EQ(whole.exit_code, 0) << whole.err;
    new_ = read_whole(path_);
    ASSERT_GT(new_.size(), 1000u);
  }

  RunningCommand start() const {
    Names command = GetParam().command;
    command.insert(command.begin(), sfumato_program());
    command.insert(command.end(), {input_, "-o", path_, "--quiet"});
    return RunningCommand(command, {});
  }

  void lay_out() const {
    std::filesystem::remove(path_);
    if (GetParam().has_old) folder_.add(GetParam().output, old_);
  }

  /// Every other kill comes as soon as a file appears in the folder.
  void wait_for_the_moment(bool while_it_writes) {
    const auto begin = Clock::now();
    if (!while_it_writes) {
      const double share = std::uniform_real_distribution<double>(0, 1.1)(random_);
      while (Clock::now() - begin < share * duration_) ::usleep(200);
      return;
    }
    const std::size_t before = GetParam().has_old ? 2 : 1;
    while (folder_.names().size() == before && Clock::now() - begin < 2 * duration_) continue;
    ::usleep(std::uniform_int_distribution<useconds_t>(0, 1000)(random_));
  }

  bool is_whole() const {
    const std::string content = read_whole(path_);
    return content == new_ ||
           (GetParam().has_old ? content == old_ : !std::filesystem::exists(path_));
  }

  const TemporaryFolder folder_;
  const std::string input_ = folder_.add("in.xml", busy_scene(12));
  const std::string path_ = folder_.path(GetParam().output);
  const std::string old_ = std::string(50'000, 'o');
  std::string new_;
  Clock::duration duration_{};
  std::mt19937 random_{1};
};

TEST_P(Kill, leaves_a_whole_output_or_none) {
  std::size_t killed = 0, left_behind = 0;
  // Runs that are shorter than the first one may all end before their kill.
  const auto goes_on = [&](int i) {
    return i < kill_count() || (killed == 0 && i < 20 * kill_count());
  };
  for (int i = 0; goes_on(i); ++i) {
    lay_out();
    RunningCommand command = start();
    wait_for_the_moment(i % 2 == 1);
    ::kill(command.id(), SIGKILL);
    killed += command.wait().exit_code == 128 + SIGKILL;
    ASSERT_TRUE(is_whole()) << "kill " << i;
    left_behind += folder_.names().size() > (std::filesystem::exists(path_) ? 2u : 1u);
    if (folder_.names().size() == (std::filesystem::exists(path_) ? 2u : 1u)) continue;
    ASSERT_EQ(start().wait().exit_code, 0);
    ASSERT_EQ(folder_.names(), (Names{"in.xml", GetParam().output})) << "kill " << i;
    ASSERT_EQ(read_whole(path_), new_);
  }
  EXPECT_GT(killed, 0u);
  RecordProperty("killed", static_cast<int>(killed));
  RecordProperty("temporary_files_until_the_next_run", static_cast<int>(left_behind));
}

INSTANTIATE_TEST_SUITE_P(Of, Kill, testing::ValuesIn(kKilled),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(TwoRuns, to_one_output_at_the_same_time_leave_one_of_the_two_whole) {
  const TemporaryFolder folder;
  const std::string input = folder.add("in.xml", busy_scene(6));
  const std::string path = folder.path("out.png");
  const auto arguments = [&](const char* width) {
    return Names{sfumato_program(), "render", input, "-o", path, "--width", width};
  };
  Names wholes;
  for (const char* width : {"200", "300"}) {
    ASSERT_EQ(RunningCommand(arguments(width), {}).wait().exit_code, 0);
    wholes.push_back(read_whole(path));
  }
  for (int i = 0; i < 10; ++i) {
    RunningCommand first(arguments("200"), {}), second(arguments("300"), {});
    EXPECT_EQ(first.wait().exit_code, 0);
    EXPECT_EQ(second.wait().exit_code, 0);
    EXPECT_NE(std::find(wholes.begin(), wholes.end(), read_whole(path)), wholes.end());
    EXPECT_EQ(folder.names(), (Names{"in.xml", "out.png"}));
  }
}

}  // namespace
}  // namespace sfumato::test
