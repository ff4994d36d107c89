// The paper's claims, held against what was measured.
#include <algorithm>

#include "study/abuffer_results.h"
#include "study/cells.h"

namespace blysk::study {
namespace {

using antialias::Overflow;

constexpr std::size_t kN = 3;  // fragments that the paper says suffice
constexpr Overflow kDiscards[] = {Overflow::d1, Overflow::d2, Overflow::d3, Overflow::d4, Overflow::d5};

StudyClaim merging_beats_discarding(const SceneResult& s, Overflow merge, std::string claim) {
  const double merged = s.at(merge, kN).nmse;
  std::string measured = scientific_text(merged) + " by merging;", better;
  std::size_t beaten = 0;
  for (const Overflow discard : kDiscards) {
    const double nmse = s.at(discard, kN).nmse;
    const bool beats = merged < nmse;
    beaten += beats ? 1u : 0u;
    if (!beats) better.append(" ").append(overflow_name(discard));
    measured.append(" ").append(overflow_name(discard)).append(" ").append(scientific_text(nmse));
  }
  if (!better.empty()) measured.append("; not better than").append(better);
  return {.claim = std::move(claim),
          .scene = s.name,
          .claimed = word("merging has the lower NMSE (N = 3)"),
          .measured = {{"", word(std::move(measured))}},
          .verdict = beaten == std::size(kDiscards) ? Verdict::holds
                     : beaten > 0                   ? Verdict::in_part
                                                    : Verdict::fails};
}

// 36 dB: an error that shows only to who looks for it. 30 dB: one that shows.
StudyClaim three_suffice(const SceneResult& s) {
  const double psnr = s.at(Overflow::m1, kN).psnr_db;
  const auto decibels = [&](Overflow o) {
    const double db = s.at(o, kN).psnr_db;
    return std::string(overflow_name(o)) + " " + fixed_text(db, 1) + (db < 1e9 ? " dB" : "");
  };
  return {.claim = "three fragments suffice",
          .scene = s.name,
          .claimed = word("N = 3 is enough, in complex scenes too"),
          .measured = {{"", word(decibels(Overflow::m0) + ", " + decibels(Overflow::m1) + ", " +
                                 decibels(Overflow::m5))}},
          .verdict = psnr >= 36   ? Verdict::holds
                     : psnr >= 30 ? Verdict::in_part
                                  : Verdict::fails};
}

StudyClaim memory_saved(const SceneResult& s, double high, std::string claimed) {
  constexpr double kLow = 1.3;
  double least = 1e9, most = 0;
  std::size_t inside = 0;
  for (const MemoryRow& row : s.memory) {
    least = std::min(least, row.ratio);
    most = std::max(most, row.ratio);
    inside += row.ratio >= kLow && row.ratio <= high ? 1u : 0u;
  }
  return {.claim = "a common pool saves memory",
          .scene = s.name,
          .claimed = word(std::move(claimed)),
          .measured = {{"", word(fixed_text(least, 2) + " to " + fixed_text(most, 2) + " times less, " +
                                 std::to_string(inside) + " of " + std::to_string(s.memory.size()) +
                                 " splits inside")}},
          .verdict = inside == s.memory.size() ? Verdict::holds
                     : inside > 0              ? Verdict::in_part
                                               : Verdict::fails};
}

}  // namespace

std::vector<StudyClaim> abuffer_claims(const SceneResult& s) {
  std::vector<StudyClaim> claims = {
      merging_beats_discarding(s, Overflow::m0, "merging beats discarding, formulas as printed"),
      merging_beats_discarding(s, Overflow::m1, "merging beats discarding, formulas corrected"),
      merging_beats_discarding(s, Overflow::m5, "merging beats discarding, Ward's pair and fitted plane"),
      three_suffice(s)};
  if (!s.memory.empty()) {
    claims.push_back(memory_saved(s, 3.1, "1.3 to 3.1 times less (abstract)"));
    claims.push_back(memory_saved(s, 2.6, "1.3 to 2.6 times less (conclusions)"));
  }
  return claims;
}

}  // namespace blysk::study
