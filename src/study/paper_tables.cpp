#include "study/paper_tables.h"

#include <algorithm>

namespace blysk::study {
namespace {

constexpr PaperRow kAccelerated[] = {
    {"vectors N", {.add = 396, .div = 42}},
    {"b, c, s, g", {.add = 165, .mul = 396, .div = 33, .shift = 66}},
    {"p_x", {.add = 258}},
    {"sqrt(q_x)", {.add = 342, .mul = 489, .shift = 114}},
    {"diffuse intensities of the inner points", {.mul = 600}},
};

constexpr PaperRow kPhong[] = {
    {"vectors and their normalisation", {.add = 2684, .mul = 1200, .div = 1524, .sqrt = 400, .shift = 300}},
    {"ambient", {.mul = 300}},
    {"diffuse", {.add = 200, .mul = 900}},
    {"specular", {.add = 200, .mul = 1700}},
    {"sum of the components", {.add = 600}},
};

constexpr PaperRow kCubic[] = {
    {"I1 to I4", {.add = 96, .mul = 192}},
    {"A, B, C, D", {.add = 108, .mul = 36, .div = 48, .shift = 264}},
    {"diffuse intensities of the inner points", {.add = 300, .mul = 300}},
};

constexpr PaperTable kTables[] = {
    {"4.3",
     "accelerated diffuse component",
     "symmetric",
     "symmetric",
     kAccelerated,
     {.add = 1161, .mul = 1485, .div = 75, .shift = 180},
     {.add = 1161, .mul = 1485, .div = 33, .shift = 180},
     kPentium16,
     20823,
     "Ours finds both terms, raises one to the 256th power (16 multiplications a pair) and makes every row's "
     "end "
     "normals unit; the table has the diffuse term of eleven rows. Its 42 divisions of the vectors are "
     "missing "
     "from its clocks."},
    {"4.4",
     "Phong shading",
     "phong",
     "phong-full",
     kPhong,
     {.add = 3384, .mul = 4100, .div = 1524, .sqrt = 400, .shift = 300},
     {.add = 3384, .mul = 4100, .div = 1524, .sqrt = 400, .shift = 300},
     kPentium32,
     146036,
     "Both make four vectors a point unit (400 roots). Ours divides once a vector and multiplies three "
     "times, where "
     "the table divides three times; the printed additions are 300 short of their own rows."},
    {"4.5",
     "cubic polynomial on the span",
     "cubic",
     "cubic-horner",
     kCubic,
     {.add = 404, .mul = 528, .div = 48, .shift = 264},
     {.add = 404, .mul = 528, .div = 48, .shift = 264},
     kPentium16,
     8484,
     "Ours finds both terms and makes the four sample normals of every row unit (40 roots here); the table "
     "has one "
     "term and leaves the roots out, and its additions are 100 short of their own rows."},
};

// Order of QuadraticForm: direct 0, horner 1, step 2, pair 3, triple 4, values 5, values_shift 6.
constexpr FormulaRow kFormulas[] = {{0, 1280, 80, 0, 1360}, {1, 640, 80, 0, 720}, {2, 160, 65, 15, 240},
                                    {3, 48, 37, 29, 114},   {4, 48, 50, 29, 127}, {5, 256, 37, 3, 296},
                                    {6, 48, 63, 29, 140}};

constexpr ErrorRow kErrors[] = {{"accelerated diffuse and specular", "symmetric:root=chebyshev", 0.00011},
                                {"angular interpolation", "angular", 0.00018},
                                {"second-order surface", "quadratic", 0.00019},
                                {"cubic polynomial", "cubic", 0.00015}};

}  // namespace

Operations PaperTable::true_sum() const {
  Operations sum;
  for (const PaperRow& row : rows) sum += row.operations;
  return sum;
}

std::span<const PaperTable> paper_tables() { return kTables; }

const PaperTable& paper_table(std::string_view id) {
  return *std::ranges::find(kTables, id, &PaperTable::id);
}

std::span<const FormulaRow> formula_table() { return kFormulas; }

std::span<const ErrorRow> error_table() { return kErrors; }

}  // namespace blysk::study
