#include "io/gltf_accessor.h"

#include <gtest/gtest.h>

#include "io/gltf_testing.h"
#include "io/testing.h"

namespace blysk::io::gltf_testing {
namespace {

// Vertices as the reader gives them for a primitive of three vertices with that POSITION accessor.
Array<Vec3f> positions_of(Document d, int accessor) {
  d.primitive(R"("attributes":{"POSITION":)" + std::to_string(accessor) + "}");
  const auto scene = read(d.gltf());
  EXPECT_TRUE(scene) << scene.error().text();
  return scene && !scene->meshes.empty() ? scene->meshes[0].positions : Array<Vec3f>{};
}

template <class T>
Array<Vec3f> positions_of(std::initializer_list<T> values, const std::string& extra = "") {
  Document d;
  const int accessor = d.array<T>("VEC3", 3, values, extra);  // before d is copied
  return positions_of(d, accessor);
}

std::string error_of_positions(Document d, int accessor) {
  d.primitive(R"("attributes":{"POSITION":)" + std::to_string(accessor) + "}");
  return less_remedy(error_of(d.gltf()));
}

const std::string kNormalized = R"(,"normalized":true)";

}  // namespace

TEST(gltf_accessor, every_component_type) {
  const Array<Vec3f> expected{{0, 1, 2}, {100, 4, 5}, {6, 7, 120}};
  EXPECT_EQ(positions_of<std::int8_t>({0, 1, 2, 100, 4, 5, 6, 7, 120}), expected);
  EXPECT_EQ(positions_of<std::uint8_t>({0, 1, 2, 100, 4, 5, 6, 7, 120}), expected);
  EXPECT_EQ(positions_of<std::int16_t>({0, 1, 2, 100, 4, 5, 6, 7, 120}), expected);
  EXPECT_EQ(positions_of<std::uint16_t>({0, 1, 2, 100, 4, 5, 6, 7, 120}), expected);
  EXPECT_EQ(positions_of<std::uint32_t>({0, 1, 2, 100, 4, 5, 6, 7, 120}), expected);
  EXPECT_EQ(positions_of<float>({0, 1, 2, 100, 4, 5, 6, 7, 120}), expected);
}

TEST(gltf_accessor, normalized_integers) {
  const Array<Vec3f> bytes{{-1, -1, 0}, {1, 0, 0}, {0, 1, 64.0f / 127}};
  EXPECT_EQ(positions_of<std::int8_t>({-128, -127, 0, 127, 0, 0, 0, 127, 64}, kNormalized), bytes);
  const Array<Vec3f> unsigned_bytes{{0, 0, 0}, {1, 0, 0}, {0, 51.0f / 255, 1}};
  EXPECT_EQ(positions_of<std::uint8_t>({0, 0, 0, 255, 0, 0, 0, 51, 255}, kNormalized), unsigned_bytes);
  const Array<Vec3f> shorts{{-1, -1, 0}, {1, 0, 0}, {0, 1, 1.0f / 32767}};
  EXPECT_EQ(positions_of<std::int16_t>({-32768, -32767, 0, 32767, 0, 0, 0, 32767, 1}, kNormalized), shorts);
  const Array<Vec3f> unsigned_shorts{{0, 0, 0}, {1, 0, 0}, {0, 1.0f / 65535, 1}};
  EXPECT_EQ(positions_of<std::uint16_t>({0, 0, 0, 65535, 0, 0, 0, 1, 65535}, kNormalized), unsigned_shorts);
  const Array<Vec3f> floats{{3, 0, 0}, {0, 4, 0}, {0, 0, 5}};
  EXPECT_EQ(positions_of<float>({3, 0, 0, 0, 4, 0, 0, 0, 5}, kNormalized), floats);
}

TEST(gltf_accessor, interleaved_with_offset) {
  Document d;
  d.view<float>({9, 0, 0, 0, 9, 9, 1, 0, 0, 9, 9, 0, 1, 0}, R"(,"byteStride":20)");
  d.accessor(R"("bufferView":0,"byteOffset":4,"componentType":5126,"count":3,"type":"VEC3")");
  const Array<Vec3f> expected{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(positions_of(d, 0), expected);
}

TEST(gltf_accessor, sparse_with_base) {
  Document d;
  d.array<float>("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int indices = d.view<std::uint8_t>({2});
  const int values = d.view<float>({0, 7, 8});
  const int a =
      d.accessor(R"("bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,)"
                 R"("indices":{"bufferView":)" +
                 std::to_string(indices) + R"(,"componentType":5121},"values":{"bufferView":)" +
                 std::to_string(values) + "}}");
  const Array<Vec3f> expected{{0, 0, 0}, {1, 0, 0}, {0, 7, 8}};
  EXPECT_EQ(positions_of(d, a), expected);
}

TEST(gltf_accessor, sparse_without_base_is_zero_elsewhere) {
  for (const auto& [type, view] : {std::pair{5123, 0}, std::pair{5125, 1}}) {
    Document d;
    d.view<std::uint16_t>({1, 2});
    d.view<std::uint32_t>({1, 2});
    d.view<std::int16_t>({3, 0, 0, 0, 4, 0});
    d.accessor(
        R"("componentType":5122,"count":3,"type":"VEC3","sparse":{"count":2,"indices":{"bufferView":)" +
        std::to_string(view) + R"(,"componentType":)" + std::to_string(type) +
        R"(},"values":{"bufferView":2}})");
    const Array<Vec3f> expected{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
    EXPECT_EQ(positions_of(d, 0), expected);
  }
}

TEST(gltf_accessor, sparse_index_out_of_range) {
  Document d;
  d.view<std::uint8_t>({3});
  d.view<float>({1, 2, 3});
  d.accessor(R"("componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,)"
             R"("indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":1}})");
  EXPECT_EQ(error_of_positions(d, 0),
            "test.gltf: accessors[0].sparse.indices: index 3 is beyond the accessor's 3 elements");
}

TEST(gltf_accessor, what_does_not_fit) {
  struct Case {
    const char* members;
    const char* error;
  };
  const Case cases[] = {
      {R"("count":4,"type":"VEC3","componentType":5126)",
       "its 4 elements of 12 bytes do not fit into bufferViews[0]"},
      {R"("count":9007199254740992,"type":"VEC3","componentType":5126)", "do not fit"},
      {R"("count":3,"type":"VEC3","componentType":5126,"byteOffset":1)", "do not fit"},
      {R"("count":1,"type":"VEC3","componentType":5126,"byteOffset":9007199254740992)", "room for 0"},
      {R"("count":-3,"type":"VEC3","componentType":5126)",
       "accessors[0].count: is -3; it must be a whole number"},
      {R"("count":2.5,"type":"VEC3","componentType":5126)", "accessors[0].count: is 2.5"},
      {R"("count":1e300,"type":"VEC3","componentType":5126)", "accessors[0].count: is 1e+300"},
      {R"("count":"3","type":"VEC3","componentType":5126)",
       "accessors[0].count: is a string; it must be a number"},
      {R"("type":"VEC3","componentType":5126)", "accessors[0]: lacks \"count\""},
      {R"("count":3,"componentType":5126)", "accessors[0]: lacks \"type\""},
      {R"("count":3,"type":"VEC3")", "accessors[0]: lacks \"componentType\""},
      {R"("count":3,"type":"VEC5","componentType":5126)", "accessors[0].type: \"VEC5\" is none of SCALAR"},
      {R"("count":3,"type":"VEC3","componentType":5124)", "accessors[0].componentType: 5124 is none"},
      {R"("count":3,"type":"VEC2","componentType":5126)",
       "attributes.POSITION: accessor 0 is VEC2; it must be VEC3"},
      {R"("count":2,"type":"MAT4","componentType":5120)", "attributes.POSITION: accessor 0 is MAT4"},
      {R"("count":3,"type":"VEC3","componentType":5126,"sparse":{"count":4})", "sparse.count: is 4"},
      {R"("count":3,"type":"VEC3","componentType":5126,"sparse":{"count":1})", "sparse: lacks \"indices\""},
      {R"("count":3,"type":"VEC3","componentType":5126,"sparse":7)", "accessors[0].sparse: is a number"},
      {R"("count":3,"type":"VEC3","componentType":5126,"sparse":{"count":1,"indices":{"bufferView":0,)"
       R"("componentType":5126},"values":{"bufferView":0}})",
       "indices must be unsigned"},
      {R"("count":3,"type":"VEC3","componentType":5126,"sparse":{"count":3,"indices":{"bufferView":0,)"
       R"("componentType":5121,"byteOffset":34},"values":{"bufferView":0}})",
       "do not fit"},
  };
  for (const Case& c : cases) {
    Document d;
    d.view<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
    d.accessor(R"("bufferView":0,)" + std::string(c.members));
    EXPECT_NE(error_of_positions(d, 0).find(c.error), std::string::npos) << c.members << "\n"
                                                                         << error_of_positions(d, 0);
  }
}

TEST(gltf_accessor, stride_below_the_element) {
  Document d;
  d.view<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, R"(,"byteStride":8)");
  d.accessor(R"("bufferView":0,"componentType":5126,"count":3,"type":"VEC3")");
  EXPECT_EQ(
      error_of_positions(d, 0),
      "test.gltf: accessors[0]: its elements have 12 bytes, but the byteStride of bufferViews[0] is only 8");
}

TEST(gltf_accessor, zeros_need_not_be_paid_for_by_anyone) {
  Document d;
  d.accessor(R"("componentType":5126,"count":200000000,"type":"VEC3")");
  EXPECT_NE(error_of_positions(d, 0).find("unpacks to more than 256 times its size"), std::string::npos)
      << error_of_positions(d, 0);
}

TEST(gltf_accessor, views_outside_their_buffer) {
  const auto error = [](const std::string& view) {
    return less_remedy(
        error_of(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":8}],"bufferViews":[)" + view + "]}"));
  };
  EXPECT_EQ(error(R"({"buffer":0,"byteOffset":4,"byteLength":5})"),
            "test.gltf: bufferViews[0]: reaches to byte 9 of buffers[0], which has 8");
  EXPECT_EQ(error(R"({"buffer":1,"byteLength":1})"),
            "test.gltf: bufferViews[0].buffer: buffer 1 does not exist; the file has 1");
  EXPECT_NE(
      error(R"({"buffer":0,"byteOffset":9007199254740992,"byteLength":9007199254740992})").find("reaches"),
      std::string::npos);
  EXPECT_NE(error(R"({"buffer":-1,"byteLength":1})").find("buffer -1 does not exist"), std::string::npos);
  EXPECT_NE(error(R"({"buffer":0.5,"byteLength":1})").find("buffer 0.5 does not exist"), std::string::npos);
  EXPECT_NE(error(R"({"buffer":null,"byteLength":1})").find("is null; it must be the index of a buffer"),
            std::string::npos);
  EXPECT_NE(error(R"({"byteLength":1})").find("lacks \"buffer\""), std::string::npos);
  EXPECT_NE(error("3").find("bufferViews[0]: lacks"), std::string::npos);
}

}  // namespace blysk::io::gltf_testing
