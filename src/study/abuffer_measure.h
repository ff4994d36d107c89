// study/abuffer_measure.h - how far each variant of the A-buffer is from the one without limits, and what
// memory a common pool takes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/threads.h"
#include "study/flat_picture.h"

namespace blysk::study {

struct StudyScene {
  std::string name;
  int width = 128, height = 128;
  std::uint64_t triangles_in = 0;       ///< of the mesh
  std::vector<FlatTriangle> triangles;  ///< that reach the picture
  bool common_memory = true;            ///< measure the common pool too

  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Fragments a pixel.
struct Spread {
  double mean = 0;
  std::uint32_t most = 0, p99 = 0;  ///< p99: 99 % of the pixels have at most so many
};
[[nodiscard]] Spread spread_of(std::vector<std::uint32_t> counts);

struct Complexity {
  Spread generated, live;        ///< over all pixels, empty ones too
  std::uint64_t most_live = 0;   ///< of one pixel at one time
  double over_3 = 0;             ///< share of pixels with more than 3 live at the end
  double hidden_on_arrival = 0;  ///< share of the generated
  double removed_later = 0;      ///< likewise
};

struct Measured {
  Complexity complexity;
  std::vector<std::uint32_t> live;  ///< fragments of each pixel at the end
  std::vector<Quality> quality;     ///< of each variant, against unlimited lists
};

/// An order of the triangles, and what is drawn in it.
struct Submission {
  Order order = Order::given;
  std::uint64_t seed = 0;
  std::vector<Variant> variants = {};  ///< of fragment lists with a limit, the z-buffer, Carpenter's
};

/// Draws one scene in each order with every variant, in bands of rows side by side. Gives one result a run.
[[nodiscard]] std::vector<Measured> measure(const StudyScene& scene, std::span<const Submission> runs,
                                            ThreadPool& threads);

/// A way to split a pixel's memory, and what it costs.
struct MemoryRow {
  std::size_t main = 1, extra = 1;
  std::uint64_t peak = 0;        ///< pool slots in use at most
  std::uint64_t pooled = 0;      ///< bits, of a pool of `peak` slots
  std::uint64_t fixed = 0;       ///< bits, of lists with as many fragments each
  double ratio = 0;              ///< fixed / pooled
  double nmse = 0;               ///< of the fixed lists
  bool same_picture = false;     ///< the pool of `peak` slots gave the picture of the fixed lists
  double half = 0, quarter = 0;  ///< NMSE with a half and a quarter of `peak`
  std::uint64_t pooled_bytes = 0, fixed_bytes = 0;  ///< of this implementation
};

/// With one pool for the whole picture and the corrected merge of the two farthest.
[[nodiscard]] std::vector<MemoryRow> measure_memory(const StudyScene& scene, Order order, std::uint64_t seed,
                                                    ThreadPool& threads);

}  // namespace blysk::study
