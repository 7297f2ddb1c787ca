#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "cli/run_command.hpp"
#include "cli/served_command.hpp"
#include "support/places.hpp"

namespace sfumato::test {
namespace {

constexpr const char* kPage = "<!doctype html><html><head><title>t</title></head></html>";
constexpr const char* kBlankDrawing =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1 1\"/>";
const std::string kPng = "\x89PNG\r\n\x1a\n and so on";

/// A folder with the command, the editor's page beside it, and a drawing.
class Edit : public testing::Test {
 protected:
  Edit() {
    std::filesystem::create_directories(folder_.path("bin"));
    std::filesystem::create_directories(folder_.path("work"));
    program_ = folder_.path("bin/sfumato");
    std::filesystem::copy_file(sfumato_program(), program_);
    page_ = folder_.add("bin/editor.html", kPage);
    drawing_ = folder_.add("work/a.svg", kBlankDrawing);
  }

  /// Serves the drawing.
  void start(std::vector<std::string> more = {}) {
    std::vector<std::string> words{program_, "edit", drawing_, "--no-browser"};
    words.insert(words.end(), more.begin(), more.end());
    served_ = std::make_unique<ServedCommand>(words);
    const std::string& address = served_->address();
    secret_ = address.substr(address.find('/', 7));
    ASSERT_EQ(secret_.size(), 34u) << address;
  }

  std::string get(const std::string& name) const { return served_->get(secret_ + name); }

  std::string put(const std::string& path, const std::string& headers,
                  const std::string& body) const {
    return served_->ask("PUT " + path + " HTTP/1.1\r\nHost: " + served_->host() +
                        "\r\nConnection: close\r\nContent-Length: " + std::to_string(body.size()) +
                        "\r\n" + headers + "\r\n" + body);
  }

  std::string save(const std::string& match, const std::string& body) const {
    return put(secret_ + "drawing", "If-Match: " + match + "\r\n", body);
  }

  std::string tag() const {
    const std::string answer = get("drawing");
    const std::size_t begin = answer.find("ETag: ") + 6;
    return answer.substr(begin, answer.find('\r', begin) - begin);
  }

  TemporaryFolder folder_;
  std::string program_, page_, drawing_, secret_;
  std::unique_ptr<ServedCommand> served_;
};

TEST_F(Edit, gives_the_page_and_the_drawing_and_saves_it) {
  start();
  const std::string page = get("");
  EXPECT_TRUE(contains(page, " 200 ")) << page;
  EXPECT_TRUE(contains(page, "<head><meta name=\"sfumato-file\" content=\"a.svg\"><title>"));
  EXPECT_TRUE(contains(page, "frame-ancestors 'none'"));
  EXPECT_EQ(body_of(get("drawing")), kBlankDrawing);
  const std::string saved = save(tag(), "<svg/>");
  EXPECT_TRUE(contains(saved, " 204 ")) << saved;
  EXPECT_EQ(read_whole(drawing_), "<svg/>");
  EXPECT_TRUE(contains(saved, "ETag: " + tag()));
  EXPECT_TRUE(contains(save(tag(), "<svg />"), " 204 "));
  EXPECT_EQ(read_whole(drawing_), "<svg />");
  EXPECT_EQ(served_->stop(SIGTERM), 143);
}

TEST_F(Edit, the_name_of_the_drawing_is_no_markup) {
  drawing_ = folder_.add("work/\"><script>.svg", kBlankDrawing);
  start();
  EXPECT_TRUE(contains(get(""), "content=\"%22%3E%3Cscript%3E.svg\">"));
}

TEST_F(Edit, the_page_has_a_byte_for_a_character_whatever_the_drawing_is_called) {
  drawing_ = folder_.add("work/caf\xc3\xa9.svg", kBlankDrawing);
  start();
  const std::string page = get("");
  EXPECT_TRUE(contains(page, "Content-Type: text/html; charset=windows-1252"));
  EXPECT_TRUE(contains(page, "content=\"caf%C3%A9.svg\">"));
}

TEST_F(Edit, what_another_program_wrote_is_replaced_only_where_that_is_said) {
  start();
  const std::string before = tag();
  folder_.add("work/a.svg", "<svg>theirs</svg>");
  EXPECT_TRUE(contains(save(before, "<svg>ours</svg>"), " 412 "));
  EXPECT_EQ(read_whole(drawing_), "<svg>theirs</svg>");
  EXPECT_NE(tag(), before);
  EXPECT_TRUE(contains(save("*", "<svg>ours</svg>"), " 204 "));
  EXPECT_EQ(read_whole(drawing_), "<svg>ours</svg>");
  const std::string known = tag();
  std::filesystem::remove(drawing_);
  EXPECT_TRUE(contains(save(known, "<svg/>"), " 412 "));
  EXPECT_FALSE(std::filesystem::exists(drawing_));
  EXPECT_TRUE(contains(save("*", "<svg/>"), " 204 "));
}

TEST_F(Edit, of_two_pages_the_second_to_save_is_told) {
  start();
  const std::string first = tag(), second = tag();
  EXPECT_EQ(first, second);
  EXPECT_TRUE(contains(save(first, "<svg>1</svg>"), " 204 "));
  EXPECT_TRUE(contains(save(second, "<svg>2</svg>"), " 412 "));
  EXPECT_EQ(read_whole(drawing_), "<svg>1</svg>");
}

TEST_F(Edit, a_save_that_names_no_version_of_ours_changes_nothing) {
  start();
  const std::string known = tag();
  EXPECT_TRUE(contains(put(secret_ + "drawing", "", "<svg>x</svg>"), " 428 "));
  for (const char* match :
       {"1", "\"\"", "\"01x\"", "W/\"1\"", "\"-1\"", "\"99999999999999999999\""}) {
    EXPECT_TRUE(contains(save(match, "<svg>x</svg>"), " 412 ")) << match;
  }
  EXPECT_TRUE(contains(save(known, ""), " 400 "));
  EXPECT_EQ(read_whole(drawing_), kBlankDrawing);
}

TEST_F(Edit, nothing_is_there_without_the_secret) {
  start();
  std::string wrong = secret_;
  wrong[5] = wrong[5] == '0' ? '1' : '0';
  for (const std::string& path :
       {std::string("/"), wrong, wrong + "drawing", std::string("/drawing"), secret_.substr(0, 33),
        '/' + secret_, secret_ + "a.svg", secret_ + "../a.svg", secret_ + "drawing/",
        secret_ + "%64rawing", std::string("/../") + secret_}) {
    EXPECT_TRUE(contains(served_->get(path), " 404 ")) << path;
    EXPECT_TRUE(contains(put(path, "If-Match: *\r\n", "<svg>x</svg>"), " 404 ")) << path;
  }
  EXPECT_EQ(read_whole(drawing_), kBlankDrawing);
}

TEST_F(Edit, another_site_reaches_nothing_even_with_the_secret) {
  start();
  const std::string port = std::to_string(served_->port());
  for (const std::string& host : {std::string("evil.example:") + port, std::string("127.0.0.1"),
                                  "127.0.0.1.evil.example:" + port, "[::1]:" + port}) {
    EXPECT_TRUE(contains(served_->get(secret_, host), " 403 ")) << host;
  }
  for (const std::string& origin :
       {std::string("http://evil.example"), std::string("null"), "http://127.0.0.1:1" + port,
        "https://127.0.0.1:" + port, "http://localhost:" + port}) {
    const std::string headers = "If-Match: *\r\nOrigin: " + origin + "\r\n";
    EXPECT_TRUE(contains(put(secret_ + "drawing", headers, "<svg>x</svg>"), " 403 ")) << origin;
  }
  EXPECT_EQ(read_whole(drawing_), kBlankDrawing);
  const std::string own = "If-Match: *\r\nOrigin: http://" + served_->host() + "\r\n";
  EXPECT_TRUE(contains(put(secret_ + "drawing", own, "<svg>x</svg>"), " 204 "));
}

TEST_F(Edit, other_methods_do_nothing) {
  start();
  for (const char* method : {"POST", "DELETE", "OPTIONS", "PATCH", "TRACE", "HEAD"}) {
    const std::string answer = served_->ask(std::string(method) + ' ' + secret_ +
                                            "drawing HTTP/1.1\r\nHost: " + served_->host() +
                                            "\r\nConnection: close\r\nContent-Length: 0\r\n\r\n");
    EXPECT_FALSE(answer.starts_with("HTTP/1.1 20")) << answer;
  }
  EXPECT_EQ(read_whole(drawing_), kBlankDrawing);
}

TEST_F(Edit, a_drawing_that_is_too_long_is_refused) {
  start();
  const std::size_t most = std::size_t{64} << 20;
  EXPECT_TRUE(contains(save("*", std::string(most, ' ')), " 204 "));
  const std::string answer = served_->ask(
      "PUT " + secret_ + "drawing HTTP/1.1\r\nHost: " + served_->host() +
      "\r\nConnection: close\r\nIf-Match: *\r\nContent-Length: " + std::to_string(most + 1) +
      "\r\n\r\n<svg/>");
  EXPECT_TRUE(contains(answer, " 413 ")) << answer;
  EXPECT_EQ(std::filesystem::file_size(drawing_), most);
}

/// Heads of requests whose bodies never come: an answer shows that nobody waits for them.
TEST_F(Edit, refuses_a_body_before_it_comes) {
  start();
  const std::string old_tag = tag();
  ASSERT_TRUE(contains(save(old_tag, "<svg>x</svg>"), " 204 "));
  const std::string host = "Host: " + served_->host() + "\r\n", any = "If-Match: *\r\n";
  const struct {
    std::string path, headers;
    const char* code;
  } cases[] = {{"/0123/drawing", host + any, " 404 "},
               {secret_ + "other", host + any, " 404 "},
               {secret_ + "drawing", "Host: example.org\r\n" + any, " 403 "},
               {secret_ + "drawing", any, " 403 "},
               {secret_ + "drawing", host + "Origin: http://example.org\r\n" + any, " 403 "},
               {secret_ + "drawing", host, " 428 "},
               {secret_ + "drawing", host + "If-Match: " + old_tag + "\r\n", " 412 "},
               {secret_ + "drawing", host + "If-Match: \"7\"\r\n", " 412 "},
               {secret_ + "drawing", host + host + any, " 400 "}};
  for (const auto& one : cases) {
    for (const char* size : {"Content-Length: 1000", "Transfer-Encoding: chunked"}) {
      const std::string head = "PUT " + one.path + " HTTP/1.1\r\n" + one.headers + size;
      const std::string answer = served_->ask(head + "\r\n\r\n");
      EXPECT_TRUE(contains(answer, one.code)) << head << '\n' << answer;
    }
  }
  EXPECT_EQ(read_whole(drawing_), "<svg>x</svg>");
}

/// Its sender gets the answer although nobody reads what is still on its way.
TEST_F(Edit, a_long_body_that_is_refused_does_not_cost_its_answer) {
  start();
  const std::string old_tag = tag();
  ASSERT_TRUE(contains(save(old_tag, "<svg>x</svg>"), " 204 "));
  for (int i = 0; i < 8; ++i) {
    const std::string answer = save(old_tag, std::string(std::size_t{4} << 20, ' '));
    EXPECT_TRUE(contains(answer, " 412 ")) << answer;
  }
}

TEST_F(Edit, takes_a_head_in_pieces_and_by_chunks) {
  start();
  const std::string head =
      "PUT " + secret_ + "drawing HTTP/1.1\r\nHost: " + served_->host() + "\r\nIf-Match: *\r\n";
  const std::string sized = head + "Content-Length: 6\r\n\r\n<svg/>";
  EXPECT_TRUE(contains(served_->ask_in_pieces(sized, 7), " 204 "));
  EXPECT_EQ(read_whole(drawing_), "<svg/>");
  const std::string chunks = "Transfer-Encoding: chunked\r\n\r\n3\r\n<a \r\n3\r\nb/>\r\n0\r\n\r\n";
  EXPECT_TRUE(contains(served_->ask_in_pieces(head + chunks, 7), " 204 "));
  EXPECT_EQ(read_whole(drawing_), "<a b/>");
}

TEST_F(Edit, gives_the_textures_that_render_would_read) {
  folder_.add("work/t 1.png", kPng);
  folder_.add("work/t.jpg", "\xff\xd8\xff and so on");
  folder_.add("work/secret.txt", "secret");
  folder_.add("outside.png", kPng);
  std::filesystem::create_symlink(folder_.path("outside.png"), folder_.path("work/link.png"));
  start();
  EXPECT_EQ(body_of(get("file?t%201.png")), kPng);
  EXPECT_TRUE(contains(get("file?t.jpg"), "Content-Type: image/jpeg"));
  for (const char* href :
       {"secret.txt", "a.svg", "../outside.png", "%2e%2e%2foutside.png", "link.png", "nothing.png",
        "t%201.png%00", "", ".", "/etc/passwd", "/dev/zero"}) {
    EXPECT_TRUE(contains(get(std::string("file?") + href), " 404 ")) << href;
  }
  start({"--allow-files", folder_.path(".")});
  EXPECT_EQ(body_of(get("file?..%2foutside.png")), kPng);
}

TEST_F(Edit, a_new_name_becomes_a_drawing) {
  drawing_ = folder_.path("work/new.svg");
  start();
  EXPECT_EQ(run_sfumato({"info", drawing_}).exit_code, 0);
  EXPECT_EQ(body_of(get("drawing")), read_whole(drawing_));
}

TEST_F(Edit, what_cannot_be_edited_is_told) {
  const auto edit = [this](const std::string& name) {
    return run_command({program_, "edit", name, "--no-browser"});
  };
  EXPECT_EQ(edit("-").exit_code, 2);
  EXPECT_TRUE(contains(edit("a.xml").err, "`sfumato convert`"));
  EXPECT_TRUE(contains(edit(folder_.path("work/new.svgz")).err, "ends in .svg"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path("work/new.svgz")));
  std::filesystem::create_directory(folder_.path("work/folder.svg"));
  EXPECT_TRUE(contains(edit(folder_.path("work/folder.svg")).err, "this is a folder"));
  EXPECT_EQ(edit(folder_.path("nowhere/new.svg")).exit_code, 3);
  std::filesystem::remove(page_);
  const CommandResult result = edit(drawing_);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(contains(result.err, "`make editor`")) << result.err;
}

TEST_F(Edit, a_pipe_in_the_place_of_the_drawing_holds_nothing_up) {
  start();
  std::filesystem::remove(drawing_);
  ASSERT_EQ(mkfifo(drawing_.c_str(), 0600), 0);
  EXPECT_TRUE(contains(get("drawing"), "is no longer a file")) << get("drawing");
  EXPECT_TRUE(contains(save("\"1\"", kBlankDrawing), " 412 "));
  EXPECT_TRUE(contains(get(""), " 200 "));
  EXPECT_EQ(served_->stop(SIGTERM), 143);
}

TEST_F(Edit, an_installation_brings_its_page) {
  std::filesystem::create_directories(folder_.path("share/sfumato"));
  folder_.add("share/sfumato/editor.html", "<head></head>installed");
  start();
  EXPECT_TRUE(contains(get(""), "installed"));
}

/// The desktop's opener, first in PATH, writes its arguments.
TEST_F(Edit, the_browser_gets_an_address_that_leads_there_once) {
  const std::string opener = folder_.add("bin/xdg-open",
                                         "#!/bin/sh\necho \"$1\" > \"$0.new\"\n"
                                         "mv \"$0.new\" \"$0.said\"\n");
  chmod(opener.c_str(), 0755);
  const std::string path = folder_.path("bin") + ':' + std::getenv("PATH");
  const std::string script = "PATH='" + path + "' exec \"$0\" edit \"$1\"";
  const ServedCommand served({"/bin/sh", "-c", script, program_, drawing_});
  for (int i = 0; i < 5000 && !std::filesystem::exists(opener + ".said"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  std::string said = read_whole(opener + ".said");
  ASSERT_FALSE(said.empty());
  said.pop_back();
  EXPECT_NE(said, served.address());
  const std::string pass = said.substr(said.find('/', 7));
  EXPECT_TRUE(contains(served.get(pass + "drawing"), " 404 "));
  const std::string secret = served.address().substr(served.address().find('/', 7));
  EXPECT_TRUE(contains(served.get(pass), "Location: " + secret + "\r\n"));
  EXPECT_TRUE(contains(served.get(pass), " 404 "));
}

TEST_F(Edit, a_kill_in_the_middle_of_a_save_leaves_one_drawing_whole) {
  const std::string old(8 << 20, 'o'), next(8 << 20, 'n');
  for (int i = 0; i < 12; ++i) {
    folder_.add("work/a.svg", old);
    start();
    std::thread killer([this, i] {
      std::this_thread::sleep_for(std::chrono::milliseconds(3 * i));
      kill(served_->id(), SIGKILL);
    });
    save("*", next);
    killer.join();
    served_->stop(SIGKILL);
    const std::string content = read_whole(drawing_);
    EXPECT_TRUE(content == old || content == next) << content.size();
  }
}

}  // namespace
}  // namespace sfumato::test
