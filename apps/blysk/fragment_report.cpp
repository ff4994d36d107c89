#include "fragment_report.h"

#include <string>
#include <vector>

#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

struct Distribution {
  const char* name;
  const char* title;
  const FragmentHistogram& histogram;
};

std::vector<Distribution> distributions(const DepthComplexity& c) {
  std::vector<Distribution> all;
  for (const Distribution& d :
       {Distribution{"generated", "generated", c.generated}, Distribution{"live", "live at the end", c.live},
        Distribution{"most_live", "live at most", c.most_live}}) {
    if (!d.histogram.bins.empty()) all.push_back(d);
  }
  return all;
}

bool has_lists(const FrameStatistics& s) { return s.fragment_memory.main_bytes > 0; }

Json to_json(const FragmentHistogram& h) {
  Json bins = Json::array();
  for (const FragmentHistogram::Bin& bin : h.bins) bins.push_back({bin.fragments, bin.pixels});
  return {
      {"total", h.total()}, {"mean", h.mean()}, {"p99", h.p99()}, {"most", h.most()}, {"histogram", bins}};
}

std::string share_text(std::uint64_t part, std::uint64_t whole) {
  const double share = whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
  return fixed_text(100 * share, 1) + " %";
}

void say_complexity(const FrameStatistics& s) {
  std::vector<std::vector<std::string>> rows = {{"fragments a pixel", "mean", "99 %", "most", "all"}};
  for (const Distribution& d : distributions(s.complexity)) {
    const FragmentHistogram& h = d.histogram;
    rows.push_back(
        {d.title, fixed_text(h.mean(), 2), count_text(h.p99()), count_text(h.most()), count_text(h.total())});
  }
  for (const std::string& line : split(table(rows), '\n')) {
    if (!line.empty()) say(line);
  }
  const std::uint64_t generated = s.complexity.generated.total();
  say(share_text(s.complexity.hidden, generated) + " hidden" +
      (has_lists(s) ? ": " + share_text(s.fragments_hidden_on_arrival, generated) + " on arrival, " +
                          share_text(s.fragments_removed_later, generated) + " later"
                    : ""));
}

void say_buffers(const FragmentMemory& m) {
  const auto kib = [](std::uint64_t bits) { return count_text((bits / 8) >> 10) + " KiB"; };
  const auto both = [&](std::uint64_t main, std::uint64_t common) {
    return "main " + kib(main) + (common > 0 ? ", common " + kib(common) : "");
  };
  std::string text = "buffers for all pixels: " + both(8 * m.main_bytes, 8 * m.common_bytes);
  if (m.paper_main_bits > 0) {
    text += "; as the paper packs them " + both(m.paper_main_bits, m.paper_common_bits);
  }
  say(text);
  if (m.pools == 0) return;
  say(counted(m.pools, "pool") + " of " + counted(m.pool_slots, "slot") + ", the fullest with " +
      count_text(m.fullest_pool_peak));
}

}  // namespace

Json fragments_json(const FrameStatistics& s) {
  Json json = {{"shaded", s.fragments_shaded},      {"pixels", s.pixels_shared},
               {"transparent", s.layers_generated}, {"merged", s.layers_merged},
               {"merged_pixels", s.pixels_merged},  {"lost", s.fragments_lost}};
  if (has_lists(s)) {
    json["hidden_on_arrival"] = s.fragments_hidden_on_arrival;
    json["removed_later"] = s.fragments_removed_later;
    json["most_at_once"] = s.fragments_most_live;
  }
  if (s.complexity.generated.bins.empty()) return json;
  json["hidden"] = s.complexity.hidden;
  for (const Distribution& d : distributions(s.complexity)) json[d.name] = to_json(d.histogram);
  return json;
}

Json buffers_json(const FrameStatistics& s) {
  const FragmentMemory& m = s.fragment_memory;
  Json json = {{"bytes", {{"main", m.main_bytes}, {"common", m.common_bytes}}}};
  if (m.paper_main_bits > 0) {
    json["paper_bits"] = {{"main", m.paper_main_bits}, {"common", m.paper_common_bits}};
  }
  if (m.pools > 0) {
    json["pool"] = {
        {"tiles", m.pools}, {"slots", m.pool_slots}, {"peak", m.pool_peak}, {"fullest", m.fullest_pool_peak}};
  }
  return json;
}

void say_fragments(const FrameStatistics& s) {
  if (!s.complexity.generated.bins.empty()) say_complexity(s);
  if (has_lists(s)) say_buffers(s.fragment_memory);
}

}  // namespace blysk::command
