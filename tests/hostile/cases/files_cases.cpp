// References to files: elsewhere, to devices, to endless files.
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/images.hpp"

namespace sfumato::hostile {
namespace {

namespace fs = std::filesystem;

void write(const std::string& name, const std::string& bytes) {
  std::ofstream(name, std::ios::binary) << bytes;
}

void add_places_of_files(Family& family) {
  const char* outside = "outside of";
  for (const auto& [name, href] : {std::pair("parent", "../secret.png"),
                                   {"grandparent", "../../../../../../etc/passwd"},
                                   {"parent_within", "a/../../secret.png"},
                                   {"absolute", "/etc/passwd"},
                                   {"absolute_device", "/dev/zero"},
                                   {"absolute_random", "/dev/urandom"},
                                   {"absolute_process", "/proc/self/environ"},
                                   {"encoded_parent", "%2e%2e/secret.png"},
                                   {"encoded_slash", "..%2fsecret.png"},
                                   {"root", "/"},
                                   {"parent_alone", ".."},
                                   {"parent_of_a_folder", "a/../../x"}}) {
    family.add(name, kBadInput, outside, textured(href));
    family.add(std::string(name) + "_granted_another", kBadInput, outside, textured(href))
        .also({"--allow-files", "granted"})
        .in_folder([] { fs::create_directory("granted"); });
  }
  for (const char* scheme :
       {"http://127.0.0.1:1/a.png", "https://a/b", "ftp://a/b", "file:///etc/passwd", "FILE:t",
        "javascript:1", "c:/windows/a.png", "//host/share/a.png", "////etc/passwd", "jar:file:a!/b",
        "php://filter"}) {
    std::string name = std::string("scheme_") + scheme;
    for (char& c : name) c = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '_';
    family.add(name, kBadInput, "nothing is fetched", textured(scheme));
  }
  family.add("backslashes", kBadInput, "there is no such file", textured("..\\secret.png"));
  family.add("tilde", kBadInput, "there is no such file", textured("~/secret.png"));
  family.add("shell", kBadInput, "there is no such file", textured("$(touch x)|`touch y`"));
  family.add("glob", kBadInput, "there is no such file", textured("*"));
  family.add("dash", kBadInput, "there is no such file", textured("-"));
  family.add("dot", kBadInput, "in.svg:4", textured("."));
  family.add("itself", kBadInput, "neither a PNG nor a JPEG", textured("in.svg"));
  family.add("the_output", kBadInput, "there is no such file", textured("out.png"));
  family.add("nothing", kBadInput, "cannot be read", textured(""));
  family.add("fragment", kBadInput, "cannot be read", textured("#p"));
  family.add("zero_byte", kBadInput, "is not a file name", textured("t%00.png"));
  family.add("name_of_4096", kBadInput, "in.svg:4", textured(repeated("a", 4096)));
  family.add("name_of_a_megabyte", kBadInput, "in.svg:4",
             [] { return textured(repeated("a", kMillion)); });
  family.add("folders_500000_up", kBadInput, "in.svg:4",
             [] { return textured(repeated("../", 500'000)); });
  family.add("folders_500000_down_and_up", kBadInput, "in.svg:4",
             [] { return textured(repeated("a/../", 500'000) + "t"); });
}

void add_links(Family& family) {
  const auto linked = [&](const char* name, int code, const char* message,
                          std::function<void()> make) -> Case& {
    return family.add(name, code, message, textured("t")).in_folder(std::move(make));
  };
  linked("link_out", kBadInput, "outside of", [] { (void)symlink("/etc/passwd", "t"); });
  linked("link_to_a_device", kBadInput, "outside of", [] { (void)symlink("/dev/zero", "t"); });
  linked("link_to_itself", kBadInput, "in.svg:4", [] { (void)symlink("t", "t"); });
  linked("links_in_a_circle", kBadInput, "in.svg:4", [] {
    (void)symlink("u", "t");
    (void)symlink("t", "u");
  });
  linked("links_100", kBadInput, "in.svg:4", [] {
    for (int i = 0; i < 100; ++i) {
      const std::string name = i == 0 ? "t" : "t" + std::to_string(i);
      (void)symlink(("t" + std::to_string(i + 1)).c_str(), name.c_str());
    }
    write("t100", good_png());
  });
  linked("link_to_nothing", kBadInput, "in.svg:4", [] { (void)symlink("missing", "t"); });
  linked("link_to_the_parent", kBadInput, "outside of", [] { (void)symlink("..", "t"); });
  linked("link_within", kDone, "", [] {
    write("u", good_png());
    (void)symlink("u", "t");
  });
  linked("link_to_the_output", kBadInput, "in.svg:4", [] { (void)symlink("out.png", "t"); });
  linked("pipe", kBadInput, "is not a file", [] { (void)mkfifo("t", 0600); });
  linked("folder", kBadInput, "is not a file", [] { fs::create_directory("t"); });
  linked("file_of_80_mib", kLimit, "more than the limit of 67108864 bytes", [] {
    write("t", good_png());
    (void)truncate("t", 80 << 20);
  });
  linked("file_of_8_tib", kLimit, "more than the limit of 67108864 bytes", [] {
    write("t", good_png());
    (void)truncate("t", off_t{8} << 40);
  });
  linked("file_of_nothing", kBadInput, "neither a PNG nor a JPEG", [] { write("t", ""); });
  linked("file_of_text", kBadInput, "neither a PNG nor a JPEG", [] { write("t", "hello\n"); });
  linked("file_of_zeros", kBadInput, "neither a PNG nor a JPEG",
         [] { write("t", std::string(1 << 20, '\0')); });
}

/// Odd documents themselves.
void add_odd_documents(Family& family) {
  const auto reading = [&](const char* name, int code, const char* message, const char* file,
                           std::function<void()> make = {}) {
    family.add_call(name, code, message, {"render", file, "-o", "out.png"})
        .in_folder(std::move(make));
  };
  reading("document_is_zeros", kLimit, "more than the limit of 67108864 bytes", "/dev/zero");
  reading("document_is_random", kLimit, "more than the limit of 67108864 bytes", "/dev/urandom");
  reading("document_is_null", kBadInput, "the file is empty", "/dev/null");
  reading("document_is_a_folder", kBadInput, "cannot be read", ".");
  reading("document_is_missing", kBadInput, "No such file", "missing.svg");
  reading("document_is_nothing", kBadInput, "cannot be read", "");
  reading("document_is_a_link_to_itself", kBadInput, "cannot be read", "a.svg",
          [] { (void)symlink("a.svg", "a.svg"); });
  reading("document_is_huge", kLimit, "more than the limit of 67108864 bytes", "a.svg", [] {
    write("a.svg", svg(kLayer));
    (void)truncate("a.svg", off_t{8} << 40);
  });
  reading("document_is_a_png", kBadInput, "a.svg", "a.svg", [] { write("a.svg", good_png()); });
  reading("document_is_the_command", kBadInput, "/proc/self/exe", "/proc/self/exe");
  family.add_call("document_of_a_long_name", kBadInput, "cannot be read",
                  {"info", repeated("a", 100'000)});
  family.add_call("document_of_control_characters", kBadInput, "cannot be read",
                  {"info", "a\x1b[31m\n\xff"});
}

void add_files_cases(Family& family) {
  add_places_of_files(family);
  add_links(family);
  add_odd_documents(family);
}

const Register kFiles("files", add_files_cases);

}  // namespace
}  // namespace sfumato::hostile
