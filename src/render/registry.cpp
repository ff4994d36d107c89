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

constexpr std::string_view kParallelFits[] = {"row", "paper", "quadratic", "cubic", "weights"};
constexpr MethodSetting kParallelSettings[] = {
    {"fit",
     "row: one polynomial for rows of any length; else rows of nine pixels: the paper's, its polynomials "
     "refitted with degree 2 or 3, direct cubic weights",
     kParallelFits}};

constexpr std::string_view kDichotomyForms[] = {"exact", "paper", "minimax", "half-sum"};
constexpr MethodSetting kDichotomySettings[] = {
    {"form",
     "normals between: by the reciprocal root, by the paper's polynomial, by the best one for up to 45 deg, "
     "as half the sum",
     kDichotomyForms}};

constexpr std::string_view kTextureNodes[] = {"17", "9"}, kTextureTexels[] = {"4", "2", "1"};
constexpr MethodSetting kLightingTextureSettings[] = {
    {"nodes", "points of an edge on the finest level", kTextureNodes},
    {"texel", "least pixels from point to point, which choose the level; the paper's is 1", kTextureTexels}};

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

constexpr MethodSetting kRowPixels = {
    "row", "rows of fewer pixels are lit pixel by pixel, as phong; from about 32 on the set-up pays",
    {},    3,
    3,     64};

constexpr std::string_view kSymmetricRoots[] = {"exact", "taylor", "chebyshev", "shift", "minimax"};
constexpr MethodSetting kSymmetricSettings[] = {
    {"root", "1 / sqrt: exact, the paper's three polynomials, one fitted to each row", kSymmetricRoots, 4},
    kRowPixels};

constexpr std::string_view kAngularWalks[] = {"middle", "foot"}, kAngularEnds[] = {"linear", "spherical"};
constexpr MethodSetting kAngularSettings[] = {
    {"walk",
     "where a row's cosines start: from its middle, or as printed from the foot of L and H, which moves to a "
     "pixel",
     kAngularWalks},
    {"ends",
     "normals of a row's ends: linear along the edges and made unit, or turned evenly along them by "
     "spherical "
     "triangles",
     kAngularEnds},
    kRowPixels};

constexpr std::string_view kDiscards[] = {"d1", "d2", "d3", "d4", "d5"};
constexpr std::string_view kMerges[] = {"m0", "m1", "m2", "m3", "m4", "m5"};
constexpr MethodSetting kFragments = {"n", "fragments that a pixel holds", {}, 3, 1, 16};
constexpr MethodSetting kMergePolicy = {
    "policy",
    "which two become one: the farthest by the formulas as printed, as corrected, with a fitted plane; "
    "neighbours in depth, with a fitted plane; the pair that loses least depth",
    kMerges, 5};
constexpr std::string_view kSampleCounts[] = {"16", "32"};
constexpr MethodSetting kSamplesSetting = {
    "samples", "of a pixel: 4 columns and 4 rows, or 8 columns and 4 rows", kSampleCounts};
constexpr MethodSetting kSamplesAlone[] = {kSamplesSetting};
constexpr std::string_view kSubpixelSides[] = {"2", "4", "8", "16"};
constexpr MethodSetting kSupersampleSettings[] = {
    {"n", "a pixel is n x n sub-pixels of 16 samples each: n=4 has 256 samples", kSubpixelSides, 1}};
constexpr MethodSetting kDiscardSettings[] = {
    kFragments,
    {"policy",
     "what goes: the farthest, the smallest; the same with the pixel shown as before the last drop; the "
     "farthest, and the rest fills the pixel",
     kDiscards, 3},
    kSamplesSetting};
constexpr MethodSetting kMergeSettings[] = {kFragments, kMergePolicy, kSamplesSetting};
constexpr MethodSetting kPoolSettings[] = {
    {"main", "fragments that a pixel has room for", {}, 1, 1, 8},
    {"extra", "addresses of more in the pool", {}, 2, 0, 15},
    {"pool", "slots that a tile of 64x64 pixels shares, 32x64 with 32 samples", {}, 4096, 0, 65536},
    kMergePolicy,
    kSamplesSetting};

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
    {MethodKind::shading, "symmetric",
     "Accelerated cosines: normals linear along a row, one root for both of its halves",
     "thesis 3.1, (3.1), (3.3); 6 of the specification", "phong",
     "NMSE <= 0.00011; diffuse 1.8, specular 1.7 times as fast; root off by 4.98 % (taylor), 0.357 % "
     "(chebyshev), 0.51 % (shift)",
     "rows that turn by up to 90 deg, show one side, and are seen from near lamps and the viewer under up to "
     "53 deg / shininess^(1/6), else as phong; minimax: as phong too where its error, 4e-6 at 30 deg, 5e-5 "
     "at 45 deg, is more than 1/(510 shininess); chebyshev makes highlights 1.003^n as bright; with "
     "perspective normals are linear in the world along each row",
     kSymmetricSettings},
    {MethodKind::shading, "angular", "Normals turn by equal angles along a row, without root",
     "thesis 3.2, (3.4); 7 of the specification", "phong", "NMSE <= 0.00018; 25 % less time",
     "rows that turn by up to 90 deg, show one side, and are seen from near lamps and the viewer under up to "
     "53 deg / shininess^(1/6), else as phong; normals off by 0.005 deg on rows of 10 deg, 0.134 on 30, 4.1 "
     "on 90",
     kAngularSettings},
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
    {MethodKind::shading, "parallel",
     "Normals of a row from its ends, at equal angles, all at once, nothing made unit",
     "per-fragment paper, (1) - (14); A-buffer specification, C.1 - C.4", "phong",
     "unit without being made unit; steps 0.17 % and 0.005 % off",
     "row ends up to 90 deg apart, beyond halved, past 162 deg linear; lengths at most 0.016 % off (paper "
     "2.56 "
     "%, quadratic 0.18, cubic 0.024, weights 0.063), on flat faces 0 (paper 0.98); between row ends without "
     "perspective",
     kParallelSettings},
    {MethodKind::shading, "dichotomy",
     "Every other normal of a row made unit, those between from their neighbours",
     "relief thesis, dichotomy; its specification, 2.6", "phong",
     "length error 0.36 %, half-sum 2 % to 23 deg; half the normalisations: up to 2 times as fast",
     "neighbours but one up to 162 deg apart, beyond each its own; lengths 0.4 % off (paper, on flat faces "
     "too), 0.0039 (minimax, to 45 deg), 0.31 (half-sum, to 9 deg), beyond exact",
     kDichotomySettings},
    {MethodKind::shading, "lighting-texture",
     "A small texture of light for each triangle, fetched bilinearly",
     "per-fragment paper, polygon-shading processor; A-buffer specification, C.6 - C.8", "phong",
     "every pixel independent; 17 x 17 points from three blocks of 9 x 9",
     "up to 4 lights and shininess * (angle from point to point)^2 <= 0.06; triangles under two pixels a "
     "point "
     "and those that do not hold the highlight are lit pixel by pixel",
     kLightingTextureSettings},
    {MethodKind::shading, "auto",
     "For each triangle, colours interpolated by planes or by a second-order surface where that is provably "
     "near Phong shading, else Phong shading",
     "docs/auto.md", "phong", "",
     "within --max-error of phong; Phong shading alone for point lights, colours of vertices, the lighting "
     "model phong, the lobes schlick, quadratic and logarithmic, and draws of which little fits"},
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
    {MethodKind::antialias, "abuffer", "16 samples a pixel, exact edges and transparency",
     "A-buffer paper, A.3 to A.5; own form: samples with their surfaces", "", "",
     "everywhere; up to 64 transparent layers a pixel, beyond them the farthest merge", kSamplesAlone},
    {MethodKind::antialias, "none", "z-buffer, one sample at the pixel centre", "A-buffer paper, A.1",
     "abuffer", "", "transparent surfaces are shown as opaque ones"},
    {MethodKind::antialias, "abuffer-unlimited", "Lists of fragments without a limit",
     "A-buffer paper, A.3 to A.5", "abuffer", "",
     "everywhere; memory grows with transparent layers; slow, for study", kSamplesAlone},
    {MethodKind::antialias, "abuffer-discard", "N fragments a pixel, one dropped where there are more",
     "A-buffer paper, A.6", "abuffer-unlimited", "", "shows the order of triangles; slow, for study",
     kDiscardSettings},
    {MethodKind::antialias, "abuffer-merge", "N fragments a pixel, two merged where there are more",
     "A-buffer paper, A.7", "abuffer-unlimited", "lower NMSE than discarding; 3 fragments suffice",
     "shows the order of triangles; slow, for study", kMergeSettings},
    {MethodKind::antialias, "abuffer-pool", "Few fragments a pixel, and a pool that a tile's pixels share",
     "A-buffer paper, A.8", "abuffer-unlimited", "1.3 to 3.1 times less memory",
     "shows the order of triangles; slow, for study", kPoolSettings},
    {MethodKind::antialias, "abuffer-carpenter",
     "The classic A-buffer: of each fragment only its extent of depth", "A-buffer paper, A.2; Carpenter 1984",
     "abuffer-unlimited", "", "wrong where surfaces meet or cross; slow, for study", kSamplesAlone},
    {MethodKind::antialias, "supersample", "Ground truth: n x n sub-pixels, each drawn as abuffer's pixel",
     "own; averages in linear light", "", "",
     "picture's sides times n up to 16384 pixels; n x n times abuffer's work", kSupersampleSettings},
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
