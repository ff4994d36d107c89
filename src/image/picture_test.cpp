#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <thread>

#include "blysk/image.h"

namespace blysk {
namespace {

namespace fs = std::filesystem;

std::string bytes_in(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

// A folder of its own for each test, gone afterwards.
class WritePicture : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "blysk-picture-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }
  [[nodiscard]] std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

Image two_by_two() {
  Image image;
  image.resize(2, 2);
  image.pixels = {0xff030201, 0x80060504, 0x00090807, 0xffffff00};
  return image;
}

void expect_failure(const Status& status, ErrorCode code, const std::string& path,
                    const std::string& reason) {
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, code);
  EXPECT_NE(status.error().text().find(path), std::string::npos) << status.error().text();
  EXPECT_NE(status.error().text().find(reason), std::string::npos) << status.error().text();
  EXPECT_EQ(status.error().text().find('\n'), std::string::npos);
}

TEST_F(WritePicture, ppm_bytes) {
  ASSERT_TRUE(write_picture(two_by_two(), in_folder("a.ppm"), PictureFormat::ppm));
  EXPECT_EQ(bytes_in(in_folder("a.ppm")), std::string("P6\n2 2\n255\n\1\2\3\4\5\6\7\10\11\0\377\377", 23));
}

TEST_F(WritePicture, pfm_is_little_endian_and_bottom_up) {
  FloatImage image{.width = 1, .height = 2, .channels = 1, .values = {}};
  image.values = {1.5f, -2.0f};
  ASSERT_TRUE(write_picture(image, in_folder("a.pfm"), PictureFormat::pfm));
  EXPECT_EQ(bytes_in(in_folder("a.pfm")), std::string("Pf\n1 2\n-1.0\n\0\0\0\300\0\0\300\77", 20));

  ASSERT_TRUE(write_picture(two_by_two(), in_folder("b.pfm"), PictureFormat::pfm));
  const std::string bytes = bytes_in(in_folder("b.pfm"));
  ASSERT_EQ(bytes.size(), 12 + 4 * 3 * sizeof(float));
  EXPECT_EQ(bytes.substr(0, 12), "PF\n2 2\n-1.0\n");
  float values[12];
  std::memcpy(values, bytes.data() + 12, sizeof values);
  EXPECT_EQ(values[0], 7 / 255.0f);  // row 1 first
  EXPECT_EQ(values[4], 1.0f);
  EXPECT_EQ(values[6], 1 / 255.0f);
}

TEST_F(WritePicture, depth_becomes_gray) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                  kInfiniteDepth = std::numeric_limits<float>::infinity();
  FloatImage depth{.width = 7, .height = 1, .channels = 1, .values = {}};
  depth.values = {0.25f, 0.75f, 0.5f, 1, kNan, kInfiniteDepth, -kInfiniteDepth};
  ASSERT_TRUE(write_picture(depth, in_folder("d.ppm"), PictureFormat::ppm));
  std::string expected = "P6\n7 1\n255\n";
  for (const char gray : {'\377', '\0', '\200', '\0', '\0', '\0', '\0'}) expected += std::string(3, gray);
  EXPECT_EQ(bytes_in(in_folder("d.ppm")), expected);

  depth.values.assign(7, 0.5f);  // no range: all are nearest
  ASSERT_TRUE(write_picture(depth, in_folder("d.ppm"), PictureFormat::ppm));
  EXPECT_EQ(bytes_in(in_folder("d.ppm")), "P6\n7 1\n255\n" + std::string(21, '\377'));
}

TEST_F(WritePicture, normals_become_colors) {
  FloatImage normals{.width = 2, .height = 1, .channels = 3, .values = {}};
  normals.values = {-1, 0, 1, -2, 2, std::numeric_limits<float>::quiet_NaN()};
  ASSERT_TRUE(write_picture(normals, in_folder("n.ppm"), PictureFormat::ppm));
  EXPECT_EQ(bytes_in(in_folder("n.ppm")), std::string("P6\n2 1\n255\n\0\200\377\0\377\0", 17));
  ASSERT_TRUE(write_picture(normals, in_folder("n.png"), PictureFormat::png));
  EXPECT_EQ(bytes_in(in_folder("n.png"))[25], 2) << "colour type without alpha";
}

TEST_F(WritePicture, png_is_what_encode_png_gives) {
  for (const int compression : {1, 6}) {
    const PictureOptions options{.compression = compression};
    ASSERT_TRUE(write_picture(two_by_two(), in_folder("a.png"), PictureFormat::png, options));
    const Array<std::uint8_t> bytes = encode_png(two_by_two(), options);
    EXPECT_EQ(bytes_in(in_folder("a.png")), std::string(bytes.begin(), bytes.end()));
  }
}

TEST_F(WritePicture, replaces_and_leaves_nothing_else) {
  write(in_folder("a.ppm"), "old");
  ASSERT_TRUE(write_picture(two_by_two(), in_folder("a.ppm"), PictureFormat::ppm));
  EXPECT_EQ(bytes_in(in_folder("a.ppm")).substr(0, 2), "P6");
  EXPECT_EQ(files(), 1u);
}

TEST_F(WritePicture, permissions_follow_the_umask) {
  const mode_t old = umask(0027);
  const Status status = write_picture(two_by_two(), in_folder("a.ppm"), PictureFormat::ppm);
  umask(old);
  ASSERT_TRUE(status);
  EXPECT_EQ(static_cast<unsigned>(fs::status(in_folder("a.ppm")).permissions()), 0640u);
}

TEST_F(WritePicture, follows_a_symbolic_link) {
  write(in_folder("real.ppm"), "old");
  fs::create_symlink("real.ppm", in_folder("link.ppm"));
  ASSERT_TRUE(write_picture(two_by_two(), in_folder("link.ppm"), PictureFormat::ppm));
  EXPECT_TRUE(fs::is_symlink(in_folder("link.ppm")));
  EXPECT_EQ(bytes_in(in_folder("real.ppm")).substr(0, 2), "P6");
}

TEST_F(WritePicture, bad_places_are_told) {
  const Image image = two_by_two();
  const std::string absent = in_folder("no/such/a.png");
  expect_failure(write_picture(image, absent, PictureFormat::png), ErrorCode::output, absent,
                 "does not exist");
  expect_failure(write_picture(image, folder_.string(), PictureFormat::png), ErrorCode::output,
                 folder_.string(), "is a folder");
  expect_failure(write_picture(image, folder_.string() + "/", PictureFormat::png), ErrorCode::output,
                 folder_.string(), "is a folder");
  write(in_folder("file"), "x");
  expect_failure(write_picture(image, in_folder("file/a.png"), PictureFormat::png), ErrorCode::output,
                 "file/a.png", "is not a folder");
  const std::string long_name = in_folder(std::string(300, 'x'));
  expect_failure(write_picture(image, long_name, PictureFormat::png), ErrorCode::output, long_name,
                 "too long");
  expect_failure(write_picture(image, "", PictureFormat::png), ErrorCode::output, "", "name");
  EXPECT_EQ(files(), 1u);
}

TEST_F(WritePicture, a_full_disk_is_told) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  expect_failure(write_picture(two_by_two(), "/dev/full", PictureFormat::png), ErrorCode::output, "/dev/full",
                 "no space left");
}

// A write that ends halfway: the old file must stay, and no new one.
TEST_F(WritePicture, failure_keeps_the_old_file) {
  write(in_folder("a.ppm"), "old");
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{.rlim_cur = 10, .rlim_max = limit.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const Status status = write_picture(two_by_two(), in_folder("a.ppm"), PictureFormat::ppm);
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, old_handler);
  expect_failure(status, ErrorCode::output, in_folder("a.ppm"), "too large");
  EXPECT_EQ(bytes_in(in_folder("a.ppm")), "old");
  EXPECT_EQ(files(), 1u);
}

// Root may write anywhere: for as long as it lives, this is somebody else.
class NotRoot {
 public:
  NotRoot() { is_ = geteuid() != 0 || seteuid(65534) == 0; }
  ~NotRoot() {
    if (getuid() == 0 && seteuid(0) != 0) std::abort();
  }
  [[nodiscard]] bool is() const { return is_; }

 private:
  bool is_;
};

TEST_F(WritePicture, missing_permissions_are_told) {
  write(in_folder("read-only.png"), "old");
  fs::permissions(in_folder("read-only.png"), fs::perms::owner_read);
  fs::create_directory(in_folder("closed"));
  fs::permissions(in_folder("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  fs::permissions(folder_, fs::perms::all);
  Status over_file = Done{}, into_folder = Done{};
  {
    const NotRoot user;
    if (!user.is()) GTEST_SKIP() << "root may write anywhere";
    over_file = write_picture(two_by_two(), in_folder("read-only.png"), PictureFormat::png);
    into_folder = write_picture(two_by_two(), in_folder("closed/a.png"), PictureFormat::png);
  }
  expect_failure(over_file, ErrorCode::output, "read-only.png", "no permission");
  expect_failure(into_folder, ErrorCode::output, "closed/a.png", "no permission");
  EXPECT_EQ(bytes_in(in_folder("read-only.png")), "old");
  EXPECT_EQ(files(), 2u);
}

TEST_F(WritePicture, pipes_are_written_directly) {
  const std::string path = in_folder("pipe");
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = bytes_in(path); });
  const Status status = write_picture(two_by_two(), path, PictureFormat::ppm);
  reader.join();
  ASSERT_TRUE(status);
  EXPECT_EQ(got.size(), 23u);
}

TEST_F(WritePicture, bad_pictures_and_options_are_usage_errors) {
  const std::string path = in_folder("a.png");
  expect_failure(write_picture(Image{}, path, PictureFormat::png), ErrorCode::usage, path, "0 x 0");
  expect_failure(write_picture(two_by_two(), path, PictureFormat::png, {.compression = 0}), ErrorCode::usage,
                 path, "compression 0");
  FloatImage two_channels{.width = 1, .height = 1, .channels = 2, .values = {}};
  two_channels.values = {1, 2};
  expect_failure(write_picture(two_channels, path, PictureFormat::pfm), ErrorCode::usage, path, "1 x 1");
  EXPECT_EQ(files(), 0u);
}

// What a signal handler does while pictures are written elsewhere: each is whole or absent, and no other file
// is left.
TEST_F(WritePicture, discarding_leaves_no_temporary_file) {
  Image image;
  image.resize(300, 300);
  std::fill(image.pixels.begin(), image.pixels.end(), 0xff123456);
  std::atomic<bool> stop{false};
  std::thread interrupter([&] {
    while (!stop) discard_unfinished_pictures();
  });
  int written = 0;
  for (int i = 0; i < 12; ++i)
    written += static_cast<bool>(write_picture(image, in_folder("a.ppm"), PictureFormat::ppm));
  stop = true;
  interrupter.join();
  EXPECT_EQ(files(), written > 0 ? 1u : 0u);
  if (written > 0) {
    EXPECT_EQ(fs::file_size(in_folder("a.ppm")), 15u + 300 * 300 * 3);
  }
}

TEST(picture_format, by_extension) {
  EXPECT_EQ(*picture_format("a.png"), PictureFormat::png);
  EXPECT_EQ(*picture_format("dir.png/b.PPM"), PictureFormat::ppm);
  EXPECT_EQ(*picture_format("x.Pfm"), PictureFormat::pfm);
  EXPECT_EQ(*picture_format("-"), PictureFormat::png);
  for (const char* name : {"", "png", "a.jpg", "a.png/b", "a"}) {
    const Result<PictureFormat> format = picture_format(name);
    ASSERT_FALSE(format) << name;
    EXPECT_EQ(format.error().code, ErrorCode::usage);
    EXPECT_NE(format.error().message.find(".pfm"), std::string::npos);
  }
}

}  // namespace
}  // namespace blysk
