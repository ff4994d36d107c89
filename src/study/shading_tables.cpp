// The tables: the papers' own beside what is counted here, then speeds, errors and approximations.
#include <algorithm>

#include "lighting/lobe_reference.h"
#include "study/cells.h"
#include "study/fit_errors.h"
#include "study/paper_tables.h"
#include "study/point_plot.h"
#include "study/shading_report.h"

namespace blysk::study {
namespace {

using Row = std::vector<StudyCell>;

Row operations_row(std::string_view name, const Operations& o, const StudyCell& clocks) {
  return {word(name), count(o.add), count(o.mul), count(o.div), count(o.sqrt), count(o.shift), clocks};
}

StudyTable table_2_1() {
  StudyTable t = {
      .title = "Table 2.1: the second-order surface along 16 pixels of a row, clocks of a Xeon Phi",
      .columns = {"formula", "multiplications, printed", "counted", "additions, printed", "counted",
                  "shifts, printed", "counted", "total, printed", "counted", "time saved over (2.9)"},
      .rows = {},
      .id = "2.1",
      .notes = {
          "Counted: the row form itself, run once; a multiplication is 8 clocks, everything else 1, a shift "
          "by two bits 2.",
          "(2.2) takes eight multiplications a pixel, not the printed ten."}};
  const auto counted = [](int form) { return count_row(static_cast<QuadraticForm>(form), 16); };
  const double horner =
      static_cast<double>(kXeonPhi.clocks(counted(static_cast<int>(QuadraticForm::horner))));
  for (int form = 0; form <= static_cast<int>(QuadraticForm::forward); ++form) {
    const auto printed = std::ranges::find(formula_table(), form, &FormulaRow::form);
    const bool known = printed != formula_table().end();
    const auto cell = [&](std::uint64_t FormulaRow::*field) {
      return known ? count((*printed).*field) : none();
    };
    const Operations o = counted(form);
    const std::uint64_t total = kXeonPhi.clocks(o);
    t.rows.push_back({word(reference::formula_of(static_cast<QuadraticForm>(form))),
                      cell(&FormulaRow::mul_clocks), count(8 * o.mul), cell(&FormulaRow::add), count(o.add),
                      cell(&FormulaRow::shift), count(o.shift_bits), cell(&FormulaRow::total), count(total),
                      percent(1 - static_cast<double>(total) / horner, 1)});
  }
  return t;
}

StudyTable table_4_2(const ShadingMeasurements& m) {
  StudyTable t = {
      .title = "Table 4.2: largest NMSE against Phong shading, the thesis' two spheres",
      .columns = {"method", "claimed", "class"},
      .rows = {},
      .id = "4.2",
      .notes = {
          "The thesis does not say which scene its figures are of; here they are its two spheres by slices "
          "and stacks, shininess 50, linear on the screen, with its camera (the viewer is not at "
          "infinity)."}};
  for (const ErrorColumn& column : m.errors) t.columns.push_back(column.scene);
  t.columns.insert(t.columns.end(), {"largest", "class here"});
  for (const ErrorRow& row : error_table()) {
    Row cells = {word(row.title), significant(row.nmse, 2), word(nmse_class(row.nmse))};
    const auto method = m.variant(row.method);
    for (const ErrorColumn& column : m.errors) {
      cells.push_back(method ? significant(column.errors.differences[*method].nmse, 2) : none());
    }
    cells.push_back(method ? significant(m.worst_nmse(*method), 2) : none());
    cells.push_back(method ? word(nmse_class(m.worst_nmse(*method))) : none());
    t.rows.push_back(std::move(cells));
  }
  return t;
}

StudyTable clocks_table(const PaperTable& paper, const ShadingMeasurements& m) {
  StudyTable t = {.title = "Table " + std::string(paper.id) + ": " + std::string(paper.title) +
                           ", operations for 100 points and clocks of a " + std::string(paper.model.name),
                  .columns = {"procedure", "+", "x", ":", "sqrt", "shift", "clocks"},
                  .rows = {},
                  .id = std::string(paper.id),
                  .notes = {std::string(paper.difference)}};
  for (const PaperRow& row : paper.rows) {
    t.rows.push_back(
        operations_row(row.procedure, row.operations, count(paper.model.clocks(row.operations))));
  }
  t.rows.push_back(operations_row("sum as printed", paper.printed_sum, none()));
  t.rows.push_back(
      operations_row("what the printed clocks are made of", paper.clocked, count(paper.printed_clocks)));
  t.rows.push_back(operations_row("true sum", paper.true_sum(), count(paper.true_clocks())));
  const StepCounts& here = m.counts.find(paper.walk)->second;
  t.rows.push_back(
      operations_row("counted here: triangle", here.triangle, count(paper.model.clocks(here.triangle))));
  t.rows.push_back(operations_row("counted here: rows", here.row, count(paper.model.clocks(here.row))));
  t.rows.push_back(operations_row("counted here: pixels", here.pixel, count(paper.model.clocks(here.pixel))));
  t.rows.push_back(operations_row("counted here", here.total(), count(paper.model.clocks(here.total()))));
  return t;
}

StudyTable programs_table(const ShadingMeasurements& m) {
  StudyTable t = {
      .title =
          "The papers' programs over the average triangle of 100 points, diffuse and specular term, "
          "shininess 256",
      .columns = {"program", "how", "+", "x", ":", "sqrt", "shift", "Pentium clocks", "gain", "set-up",
                  "cycles a pixel here", "gain here"},
      .rows = {},
      .id = "programs",
      .notes = {
          "Clocks: 3, 11, 41, 70 and 1 for +, x, :, sqrt and shift. Set-up: share of the clocks that "
          "are spent "
          "on triangle and rows.",
          "Cycles here: the same program in single precision, as the compiler translates it for any "
          "processor of this kind, without intrinsics.",
          "In the renderer lighting-texture leaves this triangle to phong, as so few points do not hold "
          "the highlight, and parallel leaves rows of under sixteen pixels; the programs show what the "
          "methods would take."}};
  const double phong = static_cast<double>(m.clocks("phong"));
  for (std::size_t i = 0; i < walks().size(); ++i) {
    const Walk& walk = walks()[i];
    const StepCounts& c = m.counts.find(walk.name)->second;
    const Operations o = c.total();
    const double clocks = static_cast<double>(kPentium32.clocks(o));
    const double set_up = static_cast<double>(kPentium32.clocks(c.triangle) + kPentium32.clocks(c.row));
    t.rows.push_back({word(walk.name), word(walk.title), count(o.add), count(o.mul), count(o.div),
                      count(o.sqrt), count(o.shift), count(kPentium32.clocks(o)), factor(phong / clocks),
                      percent(set_up / clocks, 0), fixed(m.walks.cycles[i], 1), factor(m.walks.gains[i])});
  }
  return t;
}

enum class Shown { cycles, gains };

StudyTable speed_table(const ShadingMeasurements& m, const ShadingCost SpeedColumn::*set, Shown shown,
                       StudyTable t) {
  t.columns = {"method"};
  for (const SpeedColumn& column : m.speeds) t.columns.push_back(column.scene);
  for (std::size_t i = 0; i < m.methods.size(); ++i) {
    Row row = {word(m.methods[i])};
    for (const SpeedColumn& column : m.speeds) {
      const ShadingCost& cost = column.*set;
      if (cost.cycles.empty()) {
        row.push_back(none());
      } else {
        row.push_back(shown == Shown::cycles ? fixed(cost.cycles[i], 1) : factor(cost.gains[i]));
      }
    }
    t.rows.push_back(std::move(row));
  }
  return t;
}

StudyTable errors_table(const ShadingMeasurements& m) {
  StudyTable t = {.title = "NMSE against Phong shading, and what it buys",
                  .columns = {"method"},
                  .rows = {},
                  .id = "errors",
                  .notes = {"Gains over phong: of the shading stage on spans of 64 pixels, and of whole "
                            "frames on one thread."}};
  for (const ErrorColumn& column : m.errors) t.columns.push_back(column.scene);
  t.columns.insert(t.columns.end(), {"largest difference", "class of the worst", "gain, span 64"});
  for (const ErrorColumn& column : m.errors) {
    if (!column.errors.gains.empty()) t.columns.push_back("frame gain, " + column.scene);
  }
  for (std::size_t i = 0; i < m.variants.size(); ++i) {
    Row row = {word(m.variants[i])};
    int largest = 0;
    for (const ErrorColumn& column : m.errors) {
      row.push_back(significant(column.errors.differences[i].nmse, 2));
      largest = std::max(largest, column.errors.differences[i].max_difference);
    }
    row.push_back(count(static_cast<std::uint64_t>(largest)));
    row.push_back(word(nmse_class(m.worst_nmse(i))));
    row.push_back(factor(m.variant_speeds.gains[i]));
    for (const ErrorColumn& column : m.errors) {
      if (!column.errors.gains.empty()) row.push_back(factor(column.errors.gains[i]));
    }
    t.rows.push_back(std::move(row));
  }
  return t;
}

StudyTable lobes_table(const ShadingMeasurements& m) {
  constexpr int kShininess[] = {10, 50, 100, 255, 1000};
  StudyTable t = {.title = "Lobes: largest difference from cos^n over all angles, and of the picture",
                  .columns = {"lobe"},
                  .rows = {},
                  .id = "lobes",
                  .notes = {"NMSE on the thesis' spheres, detail 50, shininess 50."}};
  for (const int n : kShininess) t.columns.push_back("n = " + std::to_string(n));
  t.columns.insert(t.columns.end(), {"NMSE", "class"});
  for (std::size_t i = 0; i < m.lobes.size(); ++i) {
    Row row = {word(m.lobes[i])};
    const auto lobe = static_cast<Lobe>(i);  // the registry has them in this order
    for (const int n : kShininess) {
      const auto shape = [&](double c) { return reference::specular_lobe(lobe, c, n); };
      row.push_back(fixed(lobe_errors(shape, n).largest, 4));
    }
    const double nmse = m.lobe_errors.errors.differences[i].nmse;
    row.push_back(significant(nmse, 2));
    row.push_back(word(nmse_class(nmse)));
    t.rows.push_back(std::move(row));
  }
  return t;
}

StudyTable lobe_speed_table(const ShadingMeasurements& m) {
  StudyTable t = {.title = "Lobes in Phong shading on large spans, " + m.best +
                           ": cycles per pixel, and gain over the exact power",
                  .columns = {"lobe"},
                  .rows = {},
                  .id = "lobe-speed",
                  .notes = {"The kernel has the square of N.H, whose power needs no root; every other lobe "
                            "takes the root first. A whole shininess is raised by products (six for 50, "
                            "twelve for 255), any other by two polynomials."}};
  for (const LobeColumn& column : m.lobe_speeds) {
    t.columns.push_back(lobe_place(column));
    t.columns.emplace_back("gain");
  }
  for (std::size_t i = 0; i < m.lobes.size(); ++i) {
    Row row = {word(m.lobes[i])};
    for (const LobeColumn& column : m.lobe_speeds) {
      row.push_back(fixed(column.cost.cycles[i], 1));
      row.push_back(factor(column.cost.gains[i]));
    }
    t.rows.push_back(std::move(row));
  }
  return t;
}

StudyTable speed_of(std::string id, std::string title, std::string note = "") {
  StudyTable t;
  t.id = std::move(id);
  t.title = std::move(title);
  if (!note.empty()) t.notes = {std::move(note)};
  return t;
}

std::vector<StudyPlot> shading_plots(const ShadingMeasurements& m) {
  std::vector<PlotPoint> stages, frames;
  const PictureErrors& pot = std::ranges::find(m.errors, "teapot", &ErrorColumn::scene)->errors;
  for (std::size_t i = 0; i < m.variants.size(); ++i) {
    const std::string& name = m.variants[i];
    if (!m.method(name)) continue;  // one point a method
    stages.push_back({name, m.variant_speeds.cycles[i], m.errors.front().errors.differences[i].nmse});
    frames.push_back({name, pot.frame_ms[i], pot.differences[i].nmse});
  }
  const std::string stage_title = "Error on coarse spheres (detail 10) against cost on spans of 64 pixels";
  const std::string frame_title = "Error against time: whole frames of the teapot, one thread";
  constexpr double kFloor = 1e-8;
  return {{"shading-error-cost.svg", stage_title,
           point_plot(stages, {stage_title, "cycles per pixel, " + m.best, "NMSE against phong", kFloor})},
          {"shading-error-frame.svg", frame_title,
           point_plot(frames, {frame_title, "ms a frame", "NMSE against phong", kFloor})}};
}

}  // namespace

std::vector<StudySection> shading_sections(const ShadingMeasurements& m) {
  StudySection how = {
      "How it was measured",
      {"Operations are counted by running the reference forms, which the tests hold to the papers' "
       "formulas, with a number type that counts. \"Modelled\" turns the counts into the clocks of the "
       "papers' processors. \"Plain program\" is the same code in single precision as the compiler "
       "translates it; \"" +
           m.best +
           "\" is the shading stage of the renderer with SIMD, \"scalar kernel\" the same without, "
           "little optimised, which is a witness and not judged by. Methods that are compared were timed in "
           "turn; the best of many rounds counts.",
       "A gain holds where every measurement reaches nine tenths of it, and in part where one does. A "
       "bound holds up to its last printed digit, and in part up to a tenth more, or in some of the "
       "scenes."},
      {},
      shading_plots(m)};
  StudySection papers = {"The papers' tables", {}, {table_2_1(), table_4_2(m)}, {}};
  for (const PaperTable& paper : paper_tables()) papers.tables.push_back(clocks_table(paper, m));
  papers.tables.push_back(programs_table(m));
  StudySection speed = {"Speed", {}, {}, {}};
  speed.tables.push_back(speed_table(
      m, &SpeedColumn::best, Shown::cycles,
      speed_of("speed", "Cycles per pixel of the shading stage, " + m.best + ", one thread",
               "Triangles of so many pixels, and triangles of 32 rows of so many pixels on average; what a "
               "triangle and a row need to be set up is part of it.")));
  speed.tables.push_back(speed_table(m, &SpeedColumn::best, Shown::gains,
                                     speed_of("gain", "The same as gain over phong in the same run")));
  speed.tables.push_back(speed_table(
      m, &SpeedColumn::scalar, Shown::cycles,
      speed_of("speed-scalar", "Cycles per pixel of the same kernels without SIMD",
               "The scalar build is the plain witness of the SIMD ones: it works on sixteen pixels at a "
               "time in loops, and no one tuned it.")));
  speed.tables.push_back(lobe_speed_table(m));
  StudySection errors = {"Errors", {}, {errors_table(m), lobes_table(m)}, {}};
  return {std::move(how), std::move(papers), std::move(speed), std::move(errors)};
}

}  // namespace blysk::study
