#include "image/sha256.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "blysk/image.h"

namespace blysk {
namespace {

std::string hash_of(const std::string& text) {
  return sha256(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

// Examples of FIPS 180-4 (NIST), and the empty message.
TEST(sha256, known_values) {
  EXPECT_EQ(hash_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hash_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hash_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hash_of(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// Around the places where the padding needs another block.
TEST(sha256, every_length_to_two_blocks) {
  std::string all;
  for (std::size_t length = 0; length <= 130; ++length)
    all += hash_of(std::string(length, static_cast<char>(length)));
  EXPECT_EQ(hash_of(all), "d0baea72526dad7349caefa1eb0367cdf14831720b58b6ab382f9386e8ad7be9");
}

TEST(sha256, of_an_image_names_its_size) {
  Image image;
  image.resize(2, 1);
  image.pixels = {0x04030201, 0xff00ff00};
  EXPECT_EQ(sha256(image), hash_of(std::string("2x1\n\x01\x02\x03\x04\x00\xff\x00\xff", 12)));
}

TEST(sha256, instructions_agree_with_the_portable_form) {
  if (!has_sha256_instructions()) GTEST_SKIP() << "this processor has no SHA instructions";
  std::vector<std::uint8_t> data(64 * 50);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<std::uint8_t>(i * i >> 3);
  Sha256State a{1, 2, 3, 4, 5, 6, 7, 8}, b = a;
  sha256_blocks_portable(a, data.data(), 50);
  sha256_blocks_native(b, data.data(), 50);
  EXPECT_EQ(a, b);
}

}  // namespace
}  // namespace blysk
