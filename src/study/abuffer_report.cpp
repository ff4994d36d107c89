// The tables and plots of the A-buffer's study.
#include <algorithm>

#include "blysk/image.h"
#include "image/fragment_colors.h"
#include "study/abuffer_results.h"
#include "study/cells.h"
#include "study/log_plot.h"

namespace blysk::study {
namespace {

using antialias::Overflow;
using Scenes = std::vector<SceneResult>;

StudyCell policy_cell(Overflow policy) { return word(std::string(overflow_name(policy))); }

std::vector<std::string> with_counts(std::string first) {
  std::vector<std::string> columns = {std::move(first)};
  for (std::size_t n = 1; n <= kMostFragments; ++n) columns.push_back("N=" + std::to_string(n));
  return columns;
}

std::vector<std::string> with_policies(std::vector<std::string> columns, std::span<const Overflow> policies) {
  for (const Overflow policy : policies) columns.emplace_back(overflow_name(policy));
  return columns;
}

StudyPlot live_picture(const SceneResult& s) {
  Image image;
  image.resize(s.width, static_cast<int>(s.live.size()) / s.width);
  std::ranges::transform(s.live, image.pixels.begin(), fragment_color);
  const Array<std::uint8_t> png = encode_png(image, {.compression = 6, .alpha = false});
  return {"abuffer-live-" + s.name + ".png",
          s.name + ": fragments that live at the end; 0 black, 1 blue, 2 green, 3 yellow, 4 orange, more red",
          std::string(png.begin(), png.end())};
}

StudySection complexity_section(const Scenes& scenes) {
  StudyTable table = {
      "Fragments a pixel, and how far a z-buffer without antialiasing and the classic A-buffer "
      "are from unlimited lists (NMSE)",
      {"scene", "size", "triangles", "in the picture", "generated: mean", "99 %", "most", "live: mean",
       "99 %", "most", "most at any time", "pixels with more than 3 live", "hidden on arrival",
       "removed later", "z-buffer", "Carpenter"},
      {}};
  for (const SceneResult& s : scenes) {
    const Complexity& c = s.complexity;
    table.rows.push_back({word(s.name), word(std::to_string(s.width) + "x" + std::to_string(s.height)),
                          whole(s.triangles_in), whole(s.triangles), fixed(c.generated.mean, 1),
                          whole(c.generated.p99), whole(c.generated.most), fixed(c.live.mean, 2),
                          whole(c.live.p99), whole(c.live.most), whole(c.most_live), percent(c.over_3),
                          percent(c.hidden_on_arrival), percent(c.removed_later), scientific(s.zbuffer.nmse),
                          scientific(s.carpenter.nmse)});
  }
  StudySection section = {"Depth complexity",
                          {"Flat colours, 16 samples in a 4x4 grid, background (32, 32, 64), random order. "
                           "Lists without a limit are "
                           "the reference: opaque ones never hold more fragments than a pixel has samples. "
                           "The pictures show how many "
                           "fragments live in a pixel at the end: none black, 1 blue, 2 green, 3 yellow, 4 "
                           "orange, 5 and more red."},
                          {std::move(table)},
                          {}};
  for (const SceneResult& s : scenes) section.plots.push_back(live_picture(s));
  return section;
}

StudyTable scene_error_table(const SceneResult& s, bool decibels) {
  StudyTable table = {s.name + (decibels ? ": PSNR, dB" : ": NMSE"), with_counts("policy"), {}};
  for (const Overflow policy : kPolicies) {
    std::vector<StudyCell> row = {policy_cell(policy)};
    for (std::size_t n = 1; n <= kMostFragments; ++n) {
      const Quality& q = s.at(policy, n);
      row.push_back(decibels ? fixed(q.psnr_db, 1) : scientific(q.nmse));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

StudyPlot error_plot(const Scenes& scenes) {
  std::vector<Panel> panels;
  for (const SceneResult& s : scenes) {
    Panel panel = {s.name, {}};
    for (const Overflow policy : kExpectedPolicies) {
      Curve curve = {std::string(overflow_name(policy)), {}};
      for (std::size_t n = 1; n <= kMostFragments; ++n) {
        curve.points.emplace_back(static_cast<double>(n), s.at(policy, n).nmse);
      }
      panel.curves.push_back(std::move(curve));
    }
    panels.push_back(std::move(panel));
  }
  return {"abuffer-error.svg", "NMSE against the number of fragments a pixel",
          log_plot(panels, {.x_label = "fragments a pixel", .y_label = "NMSE"})};
}

StudySection error_section(const Scenes& scenes) {
  StudySection section = {
      "Error of every policy",
      {"d1 drops the farthest fragment, d2 the one with the fewest samples; d3 and d4 do the same but show "
       "the "
       "pixel as it was before its last drop; d5 drops as d1 and stretches what is left over the pixel. m0 "
       "merges the two farthest by the paper's formulas as printed, m1 by the corrected ones, m2 with a "
       "fitted "
       "plane; m3 merges neighbours in depth, m4 with a fitted plane; m5 merges the pair that loses least "
       "depth, "
       "with a fitted plane."},
      {},
      {error_plot(scenes)}};
  for (const SceneResult& s : scenes) {
    section.tables.push_back(scene_error_table(s, false));
    section.tables.push_back(scene_error_table(s, true));
  }
  return section;
}

StudySection shares_section(const Scenes& scenes) {
  StudyTable table = {
      "Pixels with a channel that is more than 8, and more than 32, off (N = 3)", {"scene"}, {}};
  for (const Overflow policy : kExpectedPolicies) {
    table.columns.push_back(std::string(overflow_name(policy)) + " > 8");
    table.columns.emplace_back("> 32");
  }
  for (const SceneResult& s : scenes) {
    std::vector<StudyCell> row = {word(s.name)};
    for (const Overflow policy : kExpectedPolicies) {
      row.push_back(percent(s.at(policy, 3).over_8));
      row.push_back(percent(s.at(policy, 3).over_32));
    }
    table.rows.push_back(std::move(row));
  }
  return {"Pixels that look wrong", {}, {std::move(table)}, {}};
}

StudySection order_section(const Scenes& scenes) {
  StudyTable table = {"NMSE for N = 3", with_policies({"scene", "order"}, kExpectedPolicies), {}};
  for (const SceneResult& s : scenes) {
    std::vector<StudyCell> row = {word(s.name), word("random, seed 1")};
    for (const Overflow policy : kExpectedPolicies) row.push_back(scientific(s.at(policy, 3).nmse));
    table.rows.push_back(std::move(row));
    for (const OrderResult& order : s.orders) {
      std::vector<StudyCell> other = {word(s.name), word(order.name)};
      for (const Quality& q : order.quality) other.push_back(scientific(q.nmse));
      table.rows.push_back(std::move(other));
    }
  }
  return {"Order of submission",
          {"Lists with a limit depend on the order in which triangles come; near ones first cost least."},
          {std::move(table)},
          {}};
}

StudySection least_section(const Scenes& scenes) {
  StudySection section = {"Fragments that an error takes", {}, {}, {}};
  for (const double nmse : {1e-3, 1e-4}) {
    StudyTable table = {
        "Least N with an NMSE up to " + scientific_text(nmse), with_policies({"scene"}, kPolicies), {}};
    for (const SceneResult& s : scenes) {
      std::vector<StudyCell> row = {word(s.name)};
      for (const Overflow policy : kPolicies) {
        const auto n = s.least(policy, nmse);
        row.push_back(n ? whole(*n) : word("> 8"));
      }
      table.rows.push_back(std::move(row));
    }
    section.tables.push_back(std::move(table));
  }
  return section;
}

StudyTable memory_table(const SceneResult& s) {
  StudyTable table = {s.name,
                      {"own + addresses", "peak of the pool", "bits with a pool", "bits without", "ratio",
                       "NMSE", "same picture", "NMSE, half the pool", "NMSE, a quarter",
                       "bytes here with a pool", "bytes here without"},
                      {}};
  for (const MemoryRow& row : s.memory) {
    table.rows.push_back({word(std::to_string(row.main) + "+" + std::to_string(row.extra)), whole(row.peak),
                          whole(row.pooled), whole(row.fixed), fixed(row.ratio, 2), scientific(row.nmse),
                          word(row.same_picture ? "yes" : "no"), scientific(row.half),
                          scientific(row.quarter)});
  }
  return table;
}

StudySection memory_section(const Scenes& scenes) {
  StudySection section = {"Memory that pixels share",
                          {"The paper's layout: a fragment of 112 bits (mask 16, colour 24, depth and slopes "
                           "72), addresses as wide as "
                           "the pool needs, one pool for the picture, merging by m1 when it is full or "
                           "addresses are. The ratio is that "
                           "of lists with as many fragments of their own to memory with a pool of the "
                           "measured peak. A smaller pool "
                           "saves more and shows it."},
                          {},
                          {}};
  StudyTable cheapest = {
      "Least memory with an NMSE up to 1e-3, a pool of the peak (multisampling: 768 bits a pixel)",
      {"scene", "own + addresses", "bits a pixel", "NMSE"},
      {}};
  for (const SceneResult& s : scenes) {
    if (s.memory.empty()) continue;
    section.tables.push_back(memory_table(s));
    const MemoryRow* best = nullptr;
    for (const MemoryRow& row : s.memory) {
      if (row.nmse <= 1e-3 && (best == nullptr || row.pooled < best->pooled)) best = &row;
    }
    if (best == nullptr) {
      cheapest.rows.push_back({word(s.name), word("none"), word(""), word("")});
      continue;
    }
    const double pixels = static_cast<double>(s.width) * s.height;
    cheapest.rows.push_back({word(s.name),
                             word(std::to_string(best->main) + "+" + std::to_string(best->extra)),
                             fixed(static_cast<double>(best->pooled) / pixels, 1), scientific(best->nmse)});
  }
  section.tables.insert(section.tables.begin(), std::move(cheapest));
  return section;
}

StudySection turning_section(const std::vector<TurningResult>& turning) {
  StudyTable table = {"N = 3", {"model", "policy", "NMSE: mean", "worst", "flicker", "movement"}, {}};
  for (const TurningResult& t : turning) {
    for (const TurningRow& row : t.rows) {
      table.rows.push_back({word(t.name), policy_cell(row.policy), scientific(row.mean),
                            scientific(row.worst), scientific(row.flicker), scientific(t.moving)});
    }
  }
  return {"Models that turn",
          {"Twelve frames of " + std::to_string(kTurningWidth) + "x" + std::to_string(kTurningHeight) +
           ", a degree each. Movement is the mean NMSE of a frame of unlimited lists against the one before; "
           "flicker is what a policy adds to it."},
          {std::move(table)},
          {}};
}

StudySection expected_section(const Scenes& scenes) {
  StudyTable table = {"NMSE for N = 3: measured here / expected",
                      with_policies({"scene", "generated", "live", "z-buffer"}, kExpectedPolicies),
                      {}};
  const auto both = [](std::string here, std::string there) { return word(std::move(here) + " / " + there); };
  for (const SceneResult& s : scenes) {
    if (s.expected == nullptr) continue;
    const Expected& e = *s.expected;
    std::vector<StudyCell> row = {
        word(s.name), both(fixed_text(s.complexity.generated.mean, 1), fixed_text(e.generated, 1)),
        both(fixed_text(s.complexity.live.mean, 2), fixed_text(e.live, 2)),
        both(scientific_text(s.zbuffer.nmse), scientific_text(e.zbuffer))};
    for (std::size_t i = 0; i < e.policies.size(); ++i) {
      row.push_back(
          both(scientific_text(s.at(kExpectedPolicies[i], 3).nmse), scientific_text(e.policies[i])));
    }
    table.rows.push_back(std::move(row));
  }
  return {"Against earlier figures",
          {"Scenes of the same rules from other random numbers, by another program. Soups, grass and micro "
           "scenes "
           "agree within a quarter; scenes of a few large objects differ from seed to seed by a factor of 2 "
           "to 4. "
           "Of fans the rules leave open how wide and deep a sheaf is."},
          {std::move(table)},
          {}};
}

}  // namespace

std::vector<StudySection> abuffer_sections(const Scenes& scenes, const std::vector<TurningResult>& turning) {
  std::vector<StudySection> sections = {
      complexity_section(scenes), error_section(scenes),  least_section(scenes),   shares_section(scenes),
      order_section(scenes),      memory_section(scenes), expected_section(scenes)};
  if (!turning.empty()) sections.insert(sections.end() - 1, turning_section(turning));
  return sections;
}

}  // namespace blysk::study
