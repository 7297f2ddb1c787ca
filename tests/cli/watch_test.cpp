#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "cli/run_command.hpp"
#include "cli/served_command.hpp"
#include "support/places.hpp"

namespace sfumato::test {
namespace {

std::string drawing_in(const std::string& color) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:sf=\"urn:sfumato:1\" "
         "viewBox=\"0 0 16 16\" sf:version=\"1\"><g sf:diffuse=\"true\"><circle cx=\"8\" cy=\"8\" "
         "r=\"5\" sf:left=\"white\" sf:right=\"" +
         color + "\"/></g></svg>";
}

void write(const std::string& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

class Watch : public ServedCommand {
 public:
  explicit Watch(std::vector<std::string> arguments) : ServedCommand(words(std::move(arguments))) {}

  /// Returns the state once it contains `text`; asks for each newer one as the page does.
  std::string wait_for(const std::string& text) const {
    std::string version = "0", state;
    for (int i = 0; i < 50; ++i) {
      state = get("/state?after=" + version);
      if (state.find(text) != std::string::npos) return state;
      const std::size_t at = state.find("\"version\":");
      if (at == std::string::npos) break;
      version = state.substr(at + 10, state.find(',', at) - at - 10);
    }
    ADD_FAILURE() << "no " << text << " in " << state;
    return state;
  }

  std::string picture() const { return body_of(get("/picture.png")); }

 private:
  static std::vector<std::string> words(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {sfumato_program(), "watch"});
    return arguments;
  }
};

TEST(Watch, serves_a_page_and_the_newest_picture_to_many) {
  const TemporaryFolder folder;
  const std::string file = folder.add("a.svg", drawing_in("red"));
  Watch watch({file});
  EXPECT_NE(watch.get("/").find("sfumato watch"), std::string::npos);
  EXPECT_NE(watch.get("/").find("default-src 'none'"), std::string::npos);
  watch.wait_for("\"picture\":1");
  const std::string before = watch.picture();
  EXPECT_EQ(before.substr(1, 3), "PNG");
  std::string second_client;
  std::thread other([&] { second_client = watch.wait_for("\"picture\":2"); });
  write(file, drawing_in("blue"));
  watch.wait_for("\"picture\":2");
  other.join();
  EXPECT_NE(second_client.find("\"picture\":2"), std::string::npos);
  EXPECT_NE(watch.picture(), before);
  EXPECT_EQ(watch.stop(SIGTERM), 143);
}

TEST(Watch, follows_files_that_are_replaced_by_renaming) {
  const TemporaryFolder folder;
  const std::string file = folder.add("a.svg", drawing_in("red"));
  const std::string picture = folder.path("a.png");
  Watch watch({file, "-o", picture});
  watch.wait_for("\"picture\":1");
  const std::string before = read_whole(picture);
  for (int i = 2; i < 5; ++i) {
    const std::string next = folder.add("next.svg", drawing_in("#00000" + std::to_string(i)));
    std::filesystem::rename(next, file);
    watch.wait_for("\"picture\":" + std::to_string(i));
  }
  EXPECT_NE(read_whole(picture), before);
  EXPECT_EQ(watch.stop(SIGINT), 130);
}

TEST(Watch, keeps_the_last_good_picture_and_shows_what_is_wrong) {
  const TemporaryFolder folder;
  const std::string file = folder.add("a.svg", drawing_in("red"));
  Watch watch({file});
  watch.wait_for("\"picture\":1");
  const std::string before = watch.picture();
  write(file, drawing_in("nonsense"));
  // A slow machine may show the file after it is emptied and before it is written.
  const std::string state = watch.wait_for("nonsense");
  EXPECT_NE(state.find("\"failed\":true"), std::string::npos) << state;
  EXPECT_EQ(watch.picture(), before);
  std::filesystem::remove(file);
  write(file, drawing_in("blue"));
  watch.wait_for("\"picture\":2");
}

TEST(Watch, draws_anew_when_a_texture_changes) {
  const TemporaryFolder folder;
  const std::string texture =
      "<pattern id=\"t\" patternUnits=\"userSpaceOnUse\" width=\"4\" "
      "height=\"4\"><image href=\"t.png\" width=\"4\" height=\"4\"/></pattern>";
  std::string text = drawing_in("url(#t)");
  text.insert(text.find("<g "), texture);
  const std::string file = folder.add("a.svg", text);
  Watch watch({file});
  watch.wait_for("\"failed\":true");  // the file does not exist yet
  const CommandResult made =
      run_sfumato({"render", "-", "-o", folder.path("t.png"), "--width", "4"}, drawing_in("red"));
  EXPECT_EQ(made.exit_code, 0) << made.err;
  watch.wait_for("\"picture\":1");
}

TEST(Watch, answers_this_machine_by_name_alone_and_has_no_files) {
  const TemporaryFolder folder;
  Watch watch({folder.add("a.svg", drawing_in("red"))});
  EXPECT_NE(watch.get("/", "evil.example").find(" 403 "), std::string::npos);
  EXPECT_NE(watch.get("/", "127.0.0.1").find(" 403 "), std::string::npos);
  EXPECT_NE(watch.get("/", "localhost:" + std::to_string(watch.port())).find(" 200 "),
            std::string::npos);
  for (const char* path : {"/a.svg", "/../a.svg", "/%2e%2e/a.svg", "//etc/passwd", "/watch.css/"}) {
    EXPECT_NE(watch.get(path).find(" 404 "), std::string::npos) << path;
  }
  const std::string port = std::to_string(watch.port());
  EXPECT_EQ(watch
                .ask("POST / HTTP/1.1\r\nHost: 127.0.0.1:" + port +
                     "\r\nConnection: close\r\nContent-Length: 0\r\n\r\n")
                .find(" 200 "),
            std::string::npos);
  EXPECT_EQ(watch.stop(SIGTERM), 143);
}

TEST(Watch, answers_no_page_of_another_origin) {
  const TemporaryFolder folder;
  Watch watch({folder.add("a.svg", drawing_in("red"))});
  const auto from = [&watch](const std::string& origin) {
    return watch.ask("GET / HTTP/1.1\r\nHost: " + watch.host() + "\r\nOrigin: " + origin +
                     "\r\nConnection: close\r\n\r\n");
  };
  EXPECT_NE(from("http://" + watch.host()).find(" 200 "), std::string::npos);
  EXPECT_NE(from("http://evil.example").find(" 403 "), std::string::npos);
  EXPECT_NE(from("null").find(" 403 "), std::string::npos);
}

/// When connections use up the descriptors, they wait without a message, and the command can end.
TEST(Watch, more_connections_than_descriptors_are_no_flood_of_messages) {
  const TemporaryFolder folder;
  const std::string messages = folder.path("err");
  ServedCommand watch({"/bin/sh", "-c", "ulimit -n 24; exec \"$@\" 2>'" + messages + "'", "sh",
                       sfumato_program(), "watch", "--quiet",
                       folder.add("a.svg", drawing_in("red"))});
  std::vector<int> held;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(watch.port()));
  inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
  for (int i = 0; i < 40; ++i) {
    held.push_back(socket(AF_INET, SOCK_STREAM, 0));
    // The system queues connections that nobody accepts.
    EXPECT_EQ(connect(held.back(), reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  for (const int one : held) close(one);
  EXPECT_NE(watch.get("/").find(" 200 "), std::string::npos);
  EXPECT_EQ(watch.stop(SIGTERM), 143);
  EXPECT_EQ(read_whole(messages), "sfumato: interrupted\n");
}

/// Needs a right that few users have.
TEST(Watch, answers_at_the_port_that_addresses_leave_out) {
  const TemporaryFolder folder;
  const std::string file = folder.add("a.svg", drawing_in("red"));
  const Watch watch({file, "--port", "80"});
  if (watch.port() != 80) GTEST_SKIP() << "port 80 cannot be had";
  for (const char* host : {"127.0.0.1", "localhost", "127.0.0.1:80"}) {
    EXPECT_NE(watch.get("/", host).find(" 200 "), std::string::npos) << host;
  }
  EXPECT_NE(watch.get("/", "evil.example").find(" 403 "), std::string::npos);
}

TEST(Watch, a_port_that_is_taken_is_told) {
  const TemporaryFolder folder;
  const std::string file = folder.add("a.svg", drawing_in("red"));
  Watch watch({file});
  const CommandResult second = run_sfumato({"watch", file, "--port", std::to_string(watch.port())});
  EXPECT_EQ(second.exit_code, 3);
  EXPECT_NE(second.err.find("--port"), std::string::npos) << second.err;
}

TEST(Watch, bad_usage_is_told) {
  EXPECT_EQ(run_sfumato({"watch", "-"}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"watch", "a.svg", "--port", "70000"}).exit_code, 2);
}

}  // namespace
}  // namespace sfumato::test
