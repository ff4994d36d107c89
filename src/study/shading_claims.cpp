// The claims, one by one: gains of speed, bounds of error, sums of tables.
#include <algorithm>
#include <cmath>

#include "lighting/lobe_reference.h"
#include "study/cells.h"
#include "study/fit_errors.h"
#include "study/paper_tables.h"
#include "study/shading_report.h"
#include "study/verdict.h"

namespace blysk::study {
namespace {

// "So many times as fast", said of a method against another one.
struct SpeedClaim {
  std::string_view id, text, source;
  double claimed;
  std::string_view from_walk, to_walk;      // programs
  std::string_view from_method, to_method;  // kernels; empty: none
  std::string_view remark;
};

constexpr SpeedClaim kSpeedClaims[] = {
    {"gouraud-constant",
     "one increment of intensity for the whole triangle makes Gouraud shading 1.7 times as fast",
     "Gouraud paper", 1.7, "gouraud", "gouraud-constant", "gouraud", "gouraud-constant",
     "What is saved is a division for every row and term; where a division costs no more than a few "
     "additions, or "
     "sixteen rows divide at once, little is left to save."},
    {"quadratic-phong", "the second-order surface is 67 % more productive than Phong shading",
     "thesis, novelty list", 1.67, "phong", "quadratic", "phong", "quadratic",
     "The figure is that of (2.3) against (2.9) in table 2.1; against Phong shading the gain is another "
     "one."},
    {"accelerated-diffuse",
     "the accelerated diffuse component is 1.8 (elsewhere 1.83) times as fast as Phong shading",
     "thesis, 3.1 and 4.3", 1.8, "phong-diffuse", "symmetric-diffuse", "phong", "symmetric:root=shift",
     "Every row starts with two roots, which short rows hardly pay back."},
    {"accelerated-specular",
     "the accelerated specular component is 1.7 (elsewhere 1.5 and 1.71) times as fast as Phong shading",
     "thesis, 3.1, 4.3 and slide 9", 1.7, "phong", "symmetric", "phong", "symmetric:root=shift",
     "The power, which both have to raise, takes most of the pixel's multiplications."},
    {"angular", "angular interpolation takes 25 % less time than Phong shading (elsewhere 1.2 times as fast)",
     "thesis, 3.2", 1 / 0.75, "phong", "angular", "phong", "angular",
     "25 % less time is 1.33 times as fast; the row's angle, sine and cosines are its set-up."},
    {"cubic", "the cubic polynomial takes 8484 clocks where Phong shading takes 146036: 17.2 times as fast",
     "thesis, 4.3", 146036.0 / 8484, "phong-full", "cubic", "phong", "cubic",
     "The tables set one term with constant light against three colours with four vectors made unit at every "
     "point, "
     "and leave the cubic's own roots out."},
    {"barycentric", "vectors by the quadratic form of barycentric coordinates are found 1.5 times as fast",
     "relief thesis, 6.2", 1.5, "phong", "barycentric", "phong", "barycentric",
     "The set-up of a row takes three evaluations of the form."},
    {"unit-vectors", "the combined methods of unit vectors are 2.4 times as fast on average",
     "relief thesis, 6.2", 2.4, "phong", "dichotomy-half-sum", "phong", "dichotomy:form=half-sum",
     "Modelled are the vectors alone, as the claim has it; measured are whole pixels, lighting "
     "included, of which the vectors are only a part."},
};

std::vector<StudyMeasurement> kernel_gains(const ShadingMeasurements& m, std::string_view from,
                                           std::string_view to) {
  std::vector<StudyMeasurement> measured;
  const auto a = m.variant(from), b = m.variant(to);
  if (!a || !b) return measured;
  const auto add = [&](const std::string& where, double reference, double candidate) {
    measured.push_back({where, factor(candidate / reference)});
  };
  const ShadingCost& scalar = m.speed("100 pixels").scalar;
  const auto of = m.method(from), to_method = m.method(to);
  if (of && to_method && !scalar.gains.empty()) {
    add("scalar kernel, 100 pixels", scalar.gains[*of], scalar.gains[*to_method]);
    measured.back().witness = true;
  }
  add(m.best + ", 100 pixels", m.small_speeds.gains[*a], m.small_speeds.gains[*b]);
  add(m.best + ", span 64", m.variant_speeds.gains[*a], m.variant_speeds.gains[*b]);
  return measured;
}

StudyClaim judged_gain(StudyClaim claim, std::string_view remark) {
  const double claimed = *claim.claimed.value, modelled = claim.modelled.value.value_or(0);
  claim.verdict = judge_gain(claimed, modelled, claim.measured);
  claim.why = tell_gain(claimed, modelled, claim.measured);
  if (!remark.empty()) claim.why += " " + std::string(remark);
  return claim;
}

StudyClaim speed_claim(const SpeedClaim& row, const ShadingMeasurements& m) {
  StudyClaim claim;
  claim.id = row.id;
  claim.claim = row.text;
  claim.source = row.source;
  claim.claimed = factor(row.claimed);
  claim.modelled =
      factor(static_cast<double>(m.clocks(row.from_walk)) / static_cast<double>(m.clocks(row.to_walk)));
  if (row.id == "unit-vectors") {
    claim.modelled =
        factor(static_cast<double>(kPentium32.clocks(count_unit_vectors(UnitVectors::classical))) /
               static_cast<double>(kPentium32.clocks(count_unit_vectors(UnitVectors::combined))));
  }
  claim.measured = {{"plain program", factor(m.walk_gain(row.from_walk, row.to_walk))}};
  if (row.id == "accelerated-diffuse") {
    const auto a = m.variant(row.from_method), b = m.variant(row.to_method);
    if (a && b) {
      claim.measured.push_back({m.best + ", 100 pixels, Lambert's light",
                                factor(m.diffuse_speeds.gains[*b] / m.diffuse_speeds.gains[*a])});
    }
  } else {
    for (StudyMeasurement& gain : kernel_gains(m, row.from_method, row.to_method)) {
      claim.measured.push_back(std::move(gain));
    }
  }
  return judged_gain(std::move(claim), row.remark);
}

// Table 2.1's gains against (2.9).
StudyClaim formula_claim(const ShadingMeasurements& m, QuadraticForm form, double saved,
                         std::string_view variant) {
  const auto clocks = [](QuadraticForm f) { return static_cast<double>(kXeonPhi.clocks(count_row(f, 16))); };
  const auto cycles = [&](QuadraticForm f) { return m.rows[static_cast<std::size_t>(f)]; };
  StudyClaim claim;
  const std::string formula(reference::formula_of(form));
  claim.id = form == QuadraticForm::step ? "formula-2.3" : "formula-2.5";
  claim.claim = "formula " + formula + " is " + percent(saved, 0).text + " more productive than (2.9)";
  claim.source = "thesis, 2.1 and novelty list";
  claim.claimed = factor(1 / (1 - saved));
  claim.modelled = factor(clocks(QuadraticForm::horner) / clocks(form));
  claim.measured = {{"plain program, 16 pixels", factor(cycles(QuadraticForm::horner) / cycles(form))}};
  const auto direct = m.variant("quadratic"), kernel = m.variant(variant);  // (2.9) is its first form
  if (direct && kernel) {
    claim.measured.push_back(
        {m.best + ", span 64", factor(m.variant_speeds.gains[*kernel] / m.variant_speeds.gains[*direct])});
  }
  return judged_gain(std::move(claim),
                     "It is time that is saved, so the claimed gain is " + claim.claimed.text +
                         "; a recurrence makes every pixel wait for the one before it, where (2.9) "
                         "needs no other pixel and sixteen are found at once. In the renderer these forms "
                         "share one copy of the kernel, which calls the form that was chosen: that costs "
                         "them time besides.");
}

StudyClaim normalisation_claim(const ShadingMeasurements& m) {
  const auto clocks = [](Normalisation way) {
    return static_cast<double>(kPentium32.clocks(count_normalisation(way)));
  };
  const auto cycles = [&](Normalisation way) { return m.normalisations[static_cast<std::size_t>(way)]; };
  StudyClaim claim;
  claim.id = "normalisation";
  claim.claim = "normalisation by formula (1) is 3.2 times as fast as by root and division";
  claim.source = "relief thesis, 6.2";
  claim.claimed = factor(3.2);
  claim.modelled = factor(clocks(Normalisation::three_divisions) / clocks(Normalisation::recurrence));
  const double fast = cycles(Normalisation::polynomial);
  claim.measured = {{"plain program, three divisions", factor(cycles(Normalisation::three_divisions) / fast)},
                    {"plain program, one division", factor(cycles(Normalisation::root) / fast)}};
  for (StudyMeasurement& gain : kernel_gains(m, "phong", "fast-normalize")) {
    gain.where += ", whole pixel";
    claim.measured.push_back(std::move(gain));
  }
  return judged_gain(std::move(claim),
                     "The model divides three times and has the squared length from the pixel before.");
}

StudyClaim w_speed_claim(const ShadingMeasurements& m) {
  const auto clocks = [](CountedLobe lobe) {
    return static_cast<double>(kPentium32.clocks(count_lobe(lobe)));
  };
  StudyClaim claim;
  claim.id = "w16-speed";
  claim.claim = "W(n, gamma) with k = 16 is 1.6 times as fast as Schlick's lobe";
  claim.source = "relief thesis, 6.2";
  claim.claimed = factor(1.6);
  claim.modelled = factor(clocks(CountedLobe::schlick) / clocks(CountedLobe::w16));
  const auto gain = [&](std::string_view name) { return m.lobe_gain(m.lobe_speeds.front(), name); };
  const auto cycles = [&](CountedLobe lobe) { return m.plain_lobes[static_cast<std::size_t>(lobe)]; };
  claim.measured = {{"plain program", factor(cycles(CountedLobe::schlick) / cycles(CountedLobe::w16))},
                    {m.best + ", span 64, whole pixel", factor(gain("w16") / gain("schlick"))}};
  return judged_gain(std::move(claim),
                     "Four squarings and a product stand against a product and a division.");
}

// What Blysk set out for: lobe and methods of the papers that pay against exact Phong shading.
StudyClaim lobes_pay_claim(const ShadingMeasurements& m) {
  StudyClaim claim;
  claim.id = "w-pays";
  claim.claim = "W(n, gamma) with k = 16 is faster than the exact power on large spans";
  claim.source = "relief thesis, 4.2; an aim of ours";
  claim.claimed = {"over 1.00x", 1.0};
  std::size_t faster = 0;
  for (const LobeColumn& column : m.lobe_speeds) {
    const double gain = m.lobe_gain(column, "w16");
    faster += gain > 1 ? 1 : 0;
    claim.measured.push_back({m.best + ", " + lobe_place(column), factor(gain)});
  }
  claim.verdict = faster == m.lobe_speeds.size() ? Verdict::holds
                  : faster > 0                   ? Verdict::in_part
                                                 : Verdict::fails;
  claim.why =
      "The power of a whole n is six products for 50 and twelve for 255, out of the square of N.H, which a "
      "division beside other work gives; W takes N.H itself, and with it the reciprocal root of |L + V|, as "
      "much work as its four squarings save. It pays where the power is found by polynomials, for any other "
      "n.";
  return claim;
}

StudyClaim methods_pay_claim(const ShadingMeasurements& m) {
  constexpr std::string_view kColumns[] = {"span 64", "span 128", "span 256"};
  StudyClaim claim;
  claim.id = "methods-pay";
  claim.claim = "three of the papers' methods are faster than Phong shading on large spans";
  claim.source = "an aim of ours";
  claim.claimed = {"3", 3.0};
  std::vector<std::string> all;
  for (std::size_t i = 0; i < m.methods.size(); ++i) {
    const std::string& name = m.methods[i];
    if (name == "gouraud" || name == "flat" || name == "auto") continue;  // not theirs
    const bool faster = std::ranges::all_of(m.speeds, [&](const SpeedColumn& column) {
      return std::ranges::find(kColumns, column.scene) == std::end(kColumns) || column.best.gains[i] > 1.02;
    });
    if (faster) all.push_back(name);
  }
  const auto found = static_cast<double>(all.size());
  claim.measured = {{"on " + m.best + " by over 2 %, of 64 pixels and more", count(all.size())}};
  claim.verdict = found >= 3 ? Verdict::holds : found > 0 ? Verdict::in_part : Verdict::fails;
  std::string names;
  for (const std::string& name : all) names += (names.empty() ? "" : ", ") + name;
  claim.why = names.empty() ? "None is." : "These are: " + names + ". Their errors are in the table below.";
  return claim;
}

// "The error is at most so much."
struct BoundClaim {
  std::string_view id, text, source;
  double bound;
  double digit;  // last printed one
  double measured;
  int digits;  // of per cent to show
  std::string_view remark;
};

StudyClaim bound_claim(const BoundClaim& row) {
  StudyClaim claim;
  claim.id = row.id;
  claim.claim = row.text;
  claim.source = row.source;
  claim.claimed = percent(row.bound, row.digits);
  claim.measured = {{"largest over the range", percent(row.measured, row.digits + 2)}};
  claim.verdict = judge_bound(row.bound, row.measured, row.digit);
  claim.why = claim.verdict == Verdict::holds ? "Within the bound."
                                              : "The error reaches " + claim.measured[0].figure.text + ".";
  if (!row.remark.empty()) claim.why += " " + std::string(row.remark);
  return claim;
}

std::vector<StudyClaim> bound_claims() {
  const BoundClaim rows[] = {
      {"taylor-root", "three terms of Taylor's series for 1/sqrt(1 + M) are off by at most 4.98 %",
       "thesis, 3.1", 0.0498, 0.0001, root_error(Root::taylor), 2, ""},
      {"chebyshev-root", "the Chebyshev parabola for 1/sqrt(1 + M) is off by at most 0.357 %", "thesis, 3.1",
       0.00357, 0.00001, root_error(Root::chebyshev), 3,
       "Its coefficients are rounded to three digits; the best parabola has 0.319 %."},
      {"shift-root", "the parabola by shifts alone is off by at most 0.51 %", "thesis, 3.1", 0.0051, 0.0001,
       root_error(Root::shift), 2, "The largest error is at the end of the range, M = -0.5."},
      {"third", "1/3 by shifts (43/128) is off by at most 0.79 %, which is harmless", "thesis, 2.2", 0.0079,
       0.0001, third_error(), 2, ""},
      {"third-intensity", "1/3 by shifts may stand in the printed formulas of the cubic", "thesis, 2.2",
       0.0079, 0.0001, printed_cubic_error(), 2,
       "The printed coefficients cancel: even a constant intensity is that far off at a row's end. The "
       "robust form "
       "keeps it exact."},
      {"normalisation-error", "the length after formula (1) is off by at most 0.36 %", "relief thesis, 6.1",
       0.0036, 0.0001, normalisation_error(), 2, ""},
      {"mid-vector-error", "the length of the vector between two is off by at most 0.36 %",
       "relief thesis, 6.1", 0.0036, 0.0001, mid_vector_error(), 2,
       "Its coefficients are those of formula (1), halved and rounded to three digits, which costs the bound "
       "where the "
       "vectors are parallel."},
      {"step-cosine", "the parabola (14) for the cosine of a row's step is off by at most 0.005 %",
       "per-fragment paper", 0.00005, 0.00001, step_cosine_error(), 3,
       "Its coefficients are the Chebyshev series', rounded too far; unrounded they keep the claim but for "
       "0.0054 %."},
      {"step-weight", "the parabola (11) for the weight of a row's step is off by at most 0.17 %",
       "per-fragment paper", 0.0017, 0.0001, step_weight_error(), 2,
       "Coefficients of 62 and 127 that cancel were rounded to two decimals."},
      {"row-length", "rows by Chebyshev polynomials need not be made unit", "per-fragment paper", 0.0017,
       0.0001, chebyshev_row_error(), 2,
       "They are unit only if cosine and weight are exact: both roundings add up along the row."},
      {"half-sum-error", "half the sum of two vectors up to 23 degrees apart is off by at most 2 %",
       "relief thesis, 6.1", 0.02, 0.01, half_sum_error(23), 0, ""},
  };
  std::vector<StudyClaim> claims;
  for (const BoundClaim& row : rows) claims.push_back(bound_claim(row));
  return claims;
}

// "So many times more accurate": a ratio of errors, for which more is better.
StudyClaim ratio_claim(std::string_view id, std::string_view text, std::string_view source, double claimed,
                       double measured, std::string_view remark) {
  StudyClaim claim;
  claim.id = id;
  claim.claim = text;
  claim.source = source;
  claim.claimed = factor(claimed);
  claim.measured = {{"ratio of the largest errors", factor(measured)}};
  return judged_gain(std::move(claim), remark);
}

std::vector<StudyClaim> ratio_claims() {
  constexpr double n = 256;
  const LobeErrors w =
      lobe_errors([](double c) { return reference::w_lobe(c, reference::w_scale(n, 16), 16); }, n);
  const LobeErrors schlick = lobe_errors([](double c) { return reference::schlick_lobe(c, n); }, n);
  return {
      ratio_claim("taylor-chebyshev", "the Chebyshev parabola is almost 14 times as accurate as Taylor's",
                  "thesis, 3.1", 14, root_error(Root::taylor) / root_error(Root::chebyshev), ""),
      ratio_claim(
          "lyon", "formula (1) is almost 8 times as accurate as Lyon's (3 - K) / 2", "relief thesis, 6.1", 8,
          lyon_error() / normalisation_error(),
          "For rows of less than 34 degrees Lyon's form is the better one: (1) is off by 0.3 % where nothing "
          "needs to be done."),
      ratio_claim("w16-centre",
                  "W (k = 16) is 7 times as accurate as Schlick's lobe in the highlight's centre",
                  "relief thesis, 6.1", 7, schlick.centre / w.centre,
                  "At n = 256, centre being where the power is at least 0.5; the thesis does not say."),
      ratio_claim("w16-bloom", "W (k = 16) is 13 times as accurate as Schlick's lobe in the bloom",
                  "relief thesis, 6.1", 13, schlick.bloom / w.bloom,
                  "At n = 256, bloom being where the power is 0.25 to 0.5."),
  };
}

// Pictures: the largest NMSE over all scenes against the bound.
struct PictureClaim {
  std::string_view id, text, source, method;
  double bound, digit;
  std::string_view remark;
};

constexpr PictureClaim kPictureClaims[] = {
    {"nmse-symmetric", "accelerated diffuse and specular: NMSE at most 0.00011", "thesis, table 4.2",
     "symmetric:root=chebyshev", 0.00011, 0.00001,
     "The printed parabola makes every vector 0.3 % too long, on the finest mesh too."},
    {"nmse-symmetric-minimax", "the same with a root fitted to each row, which is ours", "thesis, table 4.2",
     "symmetric", 0.00011, 0.00001, ""},
    {"nmse-angular", "angular interpolation: NMSE at most 0.00018", "thesis, table 4.2", "angular", 0.00018,
     0.00001, ""},
    {"nmse-quadratic", "second-order surface: NMSE at most 0.00019", "thesis, table 4.2", "quadratic",
     0.00019, 0.00001,
     "On coarse spheres a highlight is narrower than half an edge, and six points miss it."},
    {"nmse-cubic", "cubic polynomial: NMSE at most 0.00015", "thesis, table 4.2", "cubic", 0.00015, 0.00001,
     ""},
    {"nmse-fast-normalize", "formula (1) gives pictures that look the same: NMSE at most 0.0001",
     "relief thesis, 6.1", "fast-normalize", 0.0001, 0.0001,
     "Unit vectors that are 0.3 % too long brighten a highlight by 1.003^n, on the finest mesh too."},
    {"nmse-barycentric",
     "the quadratic form of vectors gives pictures that look the same: NMSE at most 0.0001",
     "relief thesis, 6.1", "barycentric", 0.0001, 0.0001,
     "The printed coefficients are 0.4 % off where vectors are parallel."},
    {"nmse-parallel", "normals of a row from its ends give pictures that look the same: NMSE at most 0.0001",
     "per-fragment paper", "parallel", 0.0001, 0.0001, ""},
    {"nmse-dichotomy", "halved rows give pictures that look the same: NMSE at most 0.0001",
     "relief thesis, 6.1", "dichotomy", 0.0001, 0.0001, ""},
};

std::vector<StudyClaim> picture_claims(const ShadingMeasurements& m) {
  std::vector<StudyClaim> claims;
  for (const PictureClaim& row : kPictureClaims) {
    const auto variant = m.variant(row.method);
    if (!variant) continue;
    StudyClaim claim;
    claim.id = row.id;
    claim.claim = row.text;
    claim.source = row.source;
    claim.claimed = significant(row.bound, 2);
    bool some = false;
    for (const ErrorColumn& column : m.errors) {
      const double nmse = column.errors.differences[*variant].nmse;
      claim.measured.push_back({column.scene, significant(nmse, 2)});
      some = some || judge_bound(row.bound, nmse, row.digit) == Verdict::holds;
    }
    const double worst = m.worst_nmse(*variant);
    claim.verdict = judge_bound(row.bound, worst, row.digit);
    if (claim.verdict != Verdict::holds) claim.verdict = some ? Verdict::in_part : Verdict::fails;
    claim.why = claim.verdict == Verdict::holds ? "Within it in every scene."
                                                : "The largest is " + significant(worst, 2).text + ".";
    if (claim.verdict != Verdict::holds && !row.remark.empty()) claim.why += " " + std::string(row.remark);
    claims.push_back(std::move(claim));
  }
  return claims;
}

// The tables' printed clocks against their own rows.
std::vector<StudyClaim> sum_claims(const ShadingMeasurements& m) {
  std::vector<StudyClaim> claims;
  for (const PaperTable& paper : paper_tables()) {
    StudyClaim claim;
    claim.id = "clocks-" + std::string(paper.id);
    claim.claim =
        std::string(paper.title) + ": " + count(paper.printed_clocks).text + " clocks for 100 points";
    claim.source = "thesis, 4.3 and table " + std::string(paper.id);
    claim.claimed = count(paper.printed_clocks);
    claim.modelled = count(paper.true_clocks());
    claim.measured = {{"counted here", count(paper.model.clocks(m.counts.find(paper.walk)->second.total()))}};
    claim.verdict = paper.true_clocks() == paper.printed_clocks ? Verdict::holds : Verdict::in_part;
    claim.why = "The table's own rows give " + claim.modelled.text + ". " + std::string(paper.difference);
    claims.push_back(std::move(claim));
  }
  return claims;
}

}  // namespace

std::vector<StudyClaim> shading_claims(const ShadingMeasurements& m) {
  std::vector<StudyClaim> claims = {formula_claim(m, QuadraticForm::step, 0.67, "quadratic:form=step"),
                                    formula_claim(m, QuadraticForm::pair, 0.84, "quadratic:form=pair")};
  for (const SpeedClaim& row : kSpeedClaims) claims.push_back(speed_claim(row, m));
  claims.push_back(normalisation_claim(m));
  claims.push_back(w_speed_claim(m));
  claims.push_back(lobes_pay_claim(m));
  claims.push_back(methods_pay_claim(m));
  for (auto& some : {picture_claims(m), bound_claims(), ratio_claims(), sum_claims(m)}) {
    claims.insert(claims.end(), some.begin(), some.end());
  }
  return claims;
}

}  // namespace blysk::study
