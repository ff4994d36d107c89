// The one table of methods. What a row says appears in help, documentation and reports; nothing is written
// twice.
#include <algorithm>

#include "blysk/methods.h"

namespace blysk {
namespace {

// The kernels know choices by their index: enums of the same order stand where a method reads its settings.
constexpr std::string_view kFastNormalizeFits[] = {"paper", "minimax", "cubic"};
constexpr MethodSetting kFastNormalizeSettings[] = {
    {"fit", "polynomial: the paper's, the best parabola, a cubic that is exact on flat faces",
     kFastNormalizeFits}};

constexpr std::string_view kBarycentricFits[] = {"paper", "minimax"};
constexpr MethodSetting kBarycentricSettings[] = {
    {"fit", "parabola of the edges' vectors: the paper's, the best for corners up to 45 deg apart",
     kBarycentricFits}};

constexpr std::string_view kQuadraticForms[] = {"horner", "direct", "step",        "pair",
                                                "triple", "values", "values-shift"};
constexpr std::string_view kQuadraticSegments[] = {"1", "2", "4", "8", "16", "32", "64"};
constexpr MethodSetting kQuadraticSettings[] = {
    {"form", "formula of a row: (2.9), (2.2), (2.3), (2.5), (2.7), (2.8), (2.8) without multiplication",
     kQuadraticForms},
    {"segments", "pixels between which a row is a straight line", kQuadraticSegments}};

constexpr std::string_view kCubicThirds[] = {"exact", "shift", "printed"};
constexpr MethodSetting kCubicSettings[] = {
    {"third", "1/3: exact, 43/128 by shifts, the same in the printed formulas (wrong by up to 27 %)",
     kCubicThirds}};

constexpr Method kMethods[] = {
    {MethodKind::shading, "phong", "Normals interpolated, lit at every pixel", "Phong 1975; thesis 3.3", "",
     "", "everywhere; opposite normals face the viewer"},
    {MethodKind::shading, "gouraud", "Corners lit, intensities interpolated", "Gouraud 1971; thesis 3.2",
     "phong", "", "within 1/255 of phong while triangle side (rad) * sqrt(shininess) <= 0.154"},
    {MethodKind::shading, "flat", "One normal and colour a triangle", "Bouknight 1970; thesis 3.1", "phong",
     "", "everywhere"},
    {MethodKind::shading, "gouraud-constant",
     "Corners lit, colours interpolated with one increment a triangle", "Gouraud paper, B.1, B.2", "gouraud",
     "1.7 times as fast as an increment for each row",
     "as gouraud; linear on the screen, without perspective"},
    {MethodKind::shading, "quadratic", "Second-order surface through the light of six points",
     "thesis 2.1, (2.2) to (2.9)", "phong", "NMSE <= 0.00019; additions alone per pixel",
     "within 1/255 of phong while triangle side (rad) * sqrt(shininess) <= 0.66; triangles under six pixels "
     "are lit pixel by pixel",
     kQuadraticSettings},
    {MethodKind::shading, "cubic", "Cubic polynomial through the light of four points of a row",
     "thesis 2.2; 5.2 of the specification", "phong", "NMSE <= 0.00015; three additions per pixel",
     "within 1/255 of phong while row (rad) * sqrt(shininess) <= 1.05; rows under five pixels "
     "are lit pixel by pixel",
     kCubicSettings},
    {MethodKind::shading, "fast-normalize",
     "Phong without root or division: normals made unit by a polynomial in their squared length",
     "relief thesis, formula (1)", "phong", "length error 0.36 %; 8 times better than Lyon's (3 - K)/2",
     "corner normals up to 75.6 deg apart, beyond by the root; lengths at most 0.3509 % off (minimax 0.3215, "
     "cubic 0.0544), on flat faces 0.3 % (minimax 0.3, cubic 0): highlights gain 1.003^n; perspective "
     "interpolation costs a division a pixel",
     kFastNormalizeSettings},
    {MethodKind::shading, "barycentric", "Normals as a quadratic form of six vectors, nothing made unit",
     "relief thesis, vectors at any point of a triangle", "phong",
     "length error 0.36 % of the edges' vectors",
     "corner normals up to 90 deg apart (minimax 45), beyond by the root; edges' vectors 0.4 % off (minimax "
     "0.0039), lengths 10.7 % at 90 deg (minimax 0.44 % at 45); perspective interpolation costs a division a "
     "pixel",
     kBarycentricSettings},
    {MethodKind::shading, "auto",
     "For each triangle, colours interpolated where that is provably near Phong shading, else Phong shading",
     "docs/auto.md", "phong", "",
     "within --max-error of phong; Phong shading alone for point lights, colours of vertices, the lighting "
     "model phong and the lobes schlick, quadratic and logarithmic"},
    {MethodKind::lighting, "blinn", "Specular term by N.H", "Blinn 1977; thesis 2.1", "", "",
     "L + V not zero"},
    {MethodKind::lighting, "phong", "Specular term by R.V", "Phong 1975; thesis (2.1)", "", "", "everywhere"},
    {MethodKind::lighting, "lambert", "Diffuse term only", "Lambert 1760; thesis 2.1", "", "", "everywhere"},
    {MethodKind::lobe, "power", "cos^n", "Phong 1975; thesis (2.1)", "", "", "n 1 to 1000"},
    {MethodKind::lobe, "schlick", "c / (n - n c + c), c the cosine", "Schlick 1994; relief thesis 4.2",
     "power", "within 0.204; brighter everywhere between the highlight's middle and its edge", "n 1 to 1000"},
    {MethodKind::lobe, "w3", "W(n, gamma): (1 - (n + 1)/4 * (1 - cos gamma))^3", "relief thesis 4.2", "power",
     "within 0.066", "n above 3, else power; ends at an angle of its own"},
    {MethodKind::lobe, "w4", "W(n, gamma) with k = 4, (n + 1)/5 by shifts", "relief thesis 4.2", "power",
     "within 0.053", "n above 4, else power; ends at an angle of its own"},
    {MethodKind::lobe, "w7", "W(n, gamma): (1 - (n + 1)/8 * (1 - cos gamma))^7", "relief thesis 4.2", "power",
     "within 0.031", "n above 7, else power; ends at an angle of its own"},
    {MethodKind::lobe, "w8", "W(n, gamma) with k = 8, (n + 1)/9 by shifts", "relief thesis 4.2", "power",
     "within 0.027", "n above 8, else power; ends at an angle of its own"},
    {MethodKind::lobe, "w15", "W(n, gamma): (1 - (n + 1)/16 * (1 - cos gamma))^15", "relief thesis 4.2",
     "power", "within 0.015", "n above 15, else power; ends at an angle of its own"},
    {MethodKind::lobe, "w16", "W(n, gamma) with k = 16, (n + 1)/17 by shifts", "relief thesis 4.2", "power",
     "within 0.016; 1.6 times as fast as schlick, error 7 times smaller at the centre, 13 times in the bloom",
     "n above 16, else power; ends at an angle of its own"},
    {MethodKind::lobe, "logarithmic", "2^(n log2 c), straight lines between powers of two", "thesis 8.2",
     "power", "within 0.118", "n 1 to 1000; bends visibly where the lines meet"},
    {MethodKind::lobe, "quadratic", "(1 - 0.178 n gamma^2)^2", "thesis 8.2", "power",
     "within 0.077 from n = 10 on, 0.070 for large n",
     "n above 2.28, else power; ends at an angle of its own"},
    {MethodKind::lobe, "cosine-squared", "(1 - n (1 - cos gamma) / 2.81)^2", "thesis 8.2", "power",
     "within 0.081 from n = 10 on, 0.070 for large n",
     "n above 2.81, else power; ends at an angle of its own"},
    {MethodKind::antialias, "none", "z-buffer, one sample at the pixel centre", "A-buffer paper, A.1", "", "",
     "everywhere"},
};

}  // namespace

std::string_view kind_name(MethodKind kind) {
  switch (kind) {
    case MethodKind::shading:
      return "shading";
    case MethodKind::lighting:
      return "lighting";
    case MethodKind::lobe:
      return "lobe";
    case MethodKind::antialias:
      return "antialias";
  }
  return "";
}

std::span<const Method> methods() { return kMethods; }

const Method* find_method(MethodKind kind, std::string_view name) {
  const auto* found = std::find_if(std::begin(kMethods), std::end(kMethods),
                                   [&](const Method& m) { return m.kind == kind && m.name == name; });
  return found == std::end(kMethods) ? nullptr : found;
}

}  // namespace blysk
