// frame_bench SCENE W H FRAMES [--threads N] [--isa NAME] [--shading NAME] [--antialias NAME] [--json]
//
// Renders SCENE (scenes.h) along one turn of the camera, after two frames to warm up, and prints the median
// frame on one line. Sums over frames are of no interest: the host disturbs some of them.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "blysk/image.h"
#include "scenes.h"

namespace blysk::bench {
namespace {

constexpr int kWarmUp = 2;

struct Job {
  std::string scene;
  int width = 0, height = 0, frames = 0;
  RendererOptions renderer;
  std::string shading = "phong", antialias = "none";
  bool json = false;
};

// Times in ascending order.
struct Times {
  std::vector<double> ms;

  void sort() { std::sort(ms.begin(), ms.end()); }
  double at(double part) const {
    return ms[static_cast<std::size_t>(part * static_cast<double>(ms.size() - 1) + 0.5)];
  }
  double median() const {
    const std::size_t half = ms.size() / 2;
    return ms.size() % 2 == 1 ? ms[half] : (ms[half - 1] + ms[half]) / 2;
  }
};

struct Outcome {
  Times frame, geometry, tiles;
  double covered = 0;  // share of the first picture
  FrameStatistics last;
  std::string hash;  // of the last picture
  std::string isa;
  int threads = 0;
};

bool read_whole(std::string_view text, int& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value > 0;
}

std::optional<Isa> find_isa(std::string_view name) {
  for (const Isa isa : available_isas()) {
    if (isa_name(isa) == name) return isa;
  }
  return std::nullopt;
}

std::optional<Job> read_arguments(const std::vector<std::string>& words) {
  Job job;
  if (words.size() < 4) return std::nullopt;
  job.scene = words[0];
  if (!read_whole(words[1], job.width) || !read_whole(words[2], job.height) ||
      !read_whole(words[3], job.frames)) {
    return std::nullopt;
  }
  for (std::size_t i = 4; i < words.size(); ++i) {
    if (words[i] == "--json") {
      job.json = true;
      continue;
    }
    if (i + 1 == words.size()) return std::nullopt;
    const std::string& option = words[i];
    const std::string& value = words[++i];
    if (option == "--threads") {
      if (!read_whole(value, job.renderer.threads)) return std::nullopt;
    } else if (option == "--isa") {
      const std::optional<Isa> isa = find_isa(value);
      if (!isa) return std::nullopt;
      job.renderer.isa = *isa;
    } else if (option == "--shading") {
      job.shading = value;
    } else if (option == "--antialias") {
      job.antialias = value;
    } else {
      return std::nullopt;
    }
  }
  return job;
}

Result<Outcome> run(const Job& job) {
  const Result<Stage> stage = make_stage(job.scene, job.width, job.height);
  if (!stage) return stage.error();
  Renderer renderer(job.renderer);
  RenderOptions options = frame_options(job.width, job.height);
  options.shading = job.shading;
  options.antialias = job.antialias;
  Frame frame;
  Outcome outcome;
  for (int i = -kWarmUp; i < job.frames; ++i) {
    aim(*stage, static_cast<double>(std::max(i, 0)) / job.frames, options);
    if (const Status status = renderer.render(stage->scene, options, frame); !status) return status.error();
    if (i < 0) continue;
    if (i == 0) outcome.covered = static_cast<double>(frame.statistics.pixels_covered);
    outcome.frame.ms.push_back(frame.statistics.frame_ms);
    outcome.geometry.ms.push_back(frame.statistics.geometry_ms);
    outcome.tiles.ms.push_back(frame.statistics.tiles_ms);
  }
  for (Times* times : {&outcome.frame, &outcome.geometry, &outcome.tiles}) times->sort();
  outcome.covered /= static_cast<double>(frame.image.pixels.size());
  outcome.last = frame.statistics;
  outcome.hash = sha256(frame.image);
  outcome.isa = isa_name(renderer.isa());
  outcome.threads = renderer.threads();
  return outcome;
}

double per_triangle(const Outcome& o) {
  return static_cast<double>(o.last.memory_bytes) / static_cast<double>(o.last.triangles_in);
}

double million_triangles_per_s(const Outcome& o) {
  return static_cast<double>(o.last.triangles_in) / o.frame.median() * 1e-3;
}

void print_line(const Job& job, const Outcome& o) {
  std::printf(
      "BLYSK %s %llu tri %dx%d %s %s threads=%d: median %.3f ms (p10 %.3f p90 %.3f, n=%d)  geometry %.3f "
      "tiles %.3f ms  covered %.2f%%  %.2f Mtri/s  %.1f B/tri  drawn %llu  sha256 %.16s\n",
      job.scene.c_str(), static_cast<unsigned long long>(o.last.triangles_in), job.width, job.height,
      job.shading.c_str(), o.isa.c_str(), o.threads, o.frame.median(), o.frame.at(0.1), o.frame.at(0.9),
      job.frames, o.geometry.median(), o.tiles.median(), 100 * o.covered, million_triangles_per_s(o),
      per_triangle(o), static_cast<unsigned long long>(o.last.triangles_drawn), o.hash.c_str());
}

void print_json(const Job& job, const Outcome& o) {
  const auto times = [](const char* name, const Times& t) {
    std::printf("\"%s\": {\"median\": %.4f, \"p10\": %.4f, \"p90\": %.4f}, ", name, t.median(), t.at(0.1),
                t.at(0.9));
  };
  std::string scene;
  for (const char c : job.scene) {
    if (c == '"' || c == '\\') scene += '\\';
    scene += c;
  }
  std::printf("{\"scene\": \"%s\", \"size\": [%d, %d], \"frames\": %d, \"threads\": %d, \"simd\": \"%s\", ",
              scene.c_str(), job.width, job.height, job.frames, o.threads, o.isa.c_str());
  std::printf("\"shading\": \"%s\", \"triangles\": %llu, \"drawn\": %llu, \"covered\": %.6f, ",
              job.shading.c_str(), static_cast<unsigned long long>(o.last.triangles_in),
              static_cast<unsigned long long>(o.last.triangles_drawn), o.covered);
  std::printf("\"ms\": {");
  times("geometry", o.geometry);
  times("tiles", o.tiles);
  std::printf("\"frame\": {\"median\": %.4f, \"p10\": %.4f, \"p90\": %.4f}}, ", o.frame.median(),
              o.frame.at(0.1), o.frame.at(0.9));
  std::printf("\"mtri_per_s\": %.4f, \"memory\": %llu, \"bytes_per_triangle\": %.2f, \"sha256\": \"%s\"}\n",
              million_triangles_per_s(o), static_cast<unsigned long long>(o.last.memory_bytes),
              per_triangle(o), o.hash.c_str());
}

}  // namespace
}  // namespace blysk::bench

int main(int count, char** words) {
  using namespace blysk::bench;
  const std::optional<Job> job = read_arguments({words + 1, words + count});
  if (!job) {
    std::fputs(
        "usage: frame_bench SCENE W H FRAMES [--threads N] [--isa NAME] [--shading NAME] [--antialias NAME] "
        "[--json]\n",
        stderr);
    return 2;
  }
  const blysk::Result<Outcome> outcome = run(*job);
  if (!outcome) {
    std::fprintf(stderr, "frame_bench: %s\n", outcome.error().text().c_str());
    return static_cast<int>(outcome.error().code);
  }
  if (job->json) {
    print_json(*job, *outcome);
  } else {
    print_line(*job, *outcome);
  }
  return 0;
}
