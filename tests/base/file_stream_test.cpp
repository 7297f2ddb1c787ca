#include "base/native/file_stream.hpp"

#include <gtest/gtest.h>

#include <string_view>

#include "base/bytes_of.hpp"
#include "sfumato/base/native/file.hpp"
#include "support/temporary_folder.hpp"

namespace sfumato {
namespace {

using test::bytes_of;

class FileStreams : public testing::Test {
 protected:
  std::string content() const {
    const Result<std::string> content = read_file(path_, 1 << 20);
    EXPECT_TRUE(content.ok()) << to_string(content.status());
    return content ? *content : std::string();
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("parts");
  Context context_;
};

TEST_F(FileStreams, have_their_parts_one_behind_the_other) {
  FileStream stream(path_);
  for (const char* part : {"one ", "two ", "three"}) {
    ASSERT_TRUE(stream.write(bytes_of(part), context_).ok());
  }
  EXPECT_EQ(content(), "one two three") << "before it is closed";
  EXPECT_TRUE(stream.close().ok());
  EXPECT_EQ(content(), "one two three");
}

TEST_F(FileStreams, replace_a_file_with_their_first_part) {
  ASSERT_TRUE(write_file(path_, bytes_of("what was there")).ok());
  FileStream stream(path_);
  EXPECT_EQ(content(), "what was there");
  ASSERT_TRUE(stream.write(bytes_of("new"), context_).ok());
  EXPECT_EQ(content(), "new");
}

TEST_F(FileStreams, of_no_bytes_are_empty_files) {
  FileStream stream(path_);
  ASSERT_TRUE(stream.write({}, context_).ok());
  EXPECT_TRUE(stream.close().ok());
  EXPECT_EQ(content(), "");
}

TEST_F(FileStreams, say_where_they_cannot_be) {
  const std::string nowhere = folder_.file("none") + "/parts";
  FileStream stream(nowhere);
  const Status status = stream.write(bytes_of("x"), context_);
  EXPECT_EQ(status.code, StatusCode::io);
  EXPECT_EQ(status.where.file, nowhere);
  EXPECT_TRUE(stream.close().ok()) << "nothing is open";
}

}  // namespace
}  // namespace sfumato
