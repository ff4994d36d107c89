#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <thread>

#include "io/reader.h"
#include "io/testing.h"

namespace blysk::io {
namespace {

std::string_view text_of(const FileBytes& file) {
  return {reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()};
}

class FileBytesTest : public testing::Test {
 protected:
  std::string write(std::string_view text) {
    std::ofstream(path_, std::ios::binary) << text;
    return path_;
  }
  void TearDown() override { std::remove(path_.c_str()); }

 private:
  std::string path_ = testing::TempDir() + "blysk_file_bytes_" + std::to_string(getpid());
};

TEST_F(FileBytesTest, regular_files) {
  Result<FileBytes> file = FileBytes::open(write("abc"), 3);
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_EQ(text_of(*file), "abc");
  const FileBytes moved = std::move(*file);
  EXPECT_EQ(text_of(moved), "abc");
  EXPECT_EQ(file->bytes().size(), 0u);
}

TEST_F(FileBytesTest, empty_files) {
  const Result<FileBytes> file = FileBytes::open(write(""), 100);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->bytes().size(), 0u);
}

TEST_F(FileBytesTest, limit) {
  const Result<FileBytes> file = FileBytes::open(write("abcd"), 3);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::limit);
}

TEST_F(FileBytesTest, what_is_no_file) {
  for (const char* path : {"/nowhere/at/all.ply", "/"}) {
    const Result<FileBytes> file = FileBytes::open(path, 100);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, ErrorCode::input);
    EXPECT_EQ(file.error().source, path);
  }
}

// Pipes are read to their end, however often the buffer has to grow.
TEST_F(FileBytesTest, pipes) {
  const std::string sent(3'000'000, 'x');
  for (const std::uint64_t limit : {4'000'000u, 2'000'000u}) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    std::thread writer([&] {
      for (std::size_t at = 0; at < sent.size();) {
        const ssize_t n = ::write(ends[1], sent.data() + at, sent.size() - at);
        if (n <= 0) break;
        at += static_cast<std::size_t>(n);
      }
      close(ends[1]);
    });
    const Result<FileBytes> file = FileBytes::open("/proc/self/fd/" + std::to_string(ends[0]), limit);
    // What the reader left must be drained, or the writer waits for ever.
    std::string rest(65536, '\0');
    while (::read(ends[0], rest.data(), rest.size()) > 0) {
    }
    writer.join();
    close(ends[0]);
    ASSERT_EQ(static_cast<bool>(file), limit > sent.size());
    if (file) {
      EXPECT_EQ(text_of(*file), sent);
    } else {
      EXPECT_EQ(file.error().code, ErrorCode::limit);
    }
  }
}

}  // namespace
}  // namespace blysk::io
