#include "models/growth/sheets.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace panicle::growth {
namespace {

constexpr float least_breadth = 0.5f;  // several needles form a tuft

// The image of +X under the rotation by a unit quaternion.
glm::vec3 right_of(const glm::vec4& q) {
  return {1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)};
}
// The image of +Y under the rotation by a unit quaternion.
glm::vec3 up_of(const glm::vec4& q) {
  return {2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)};
}

constexpr std::uint32_t cells = 16;  // cells along a side of the box that sheets are sorted by

// The Morton code of a point's cell in a box: the bits of its three cell numbers interleaved, so that points near each
// other mostly have codes near each other. `scale` is cells per metre.
std::uint32_t code_of(const glm::vec3& p, const Box& box, float scale) {
  std::uint32_t code = 0;
  for (int k = 0; k < 3; ++k) {
    auto cell = static_cast<std::uint32_t>(std::clamp((p[k] - box.low[k]) * scale, 0.0f, cells - 1.0f));
    cell = (cell | cell << 4) & 0xc3u;
    cell = (cell | cell << 2) & 0x249u;
    code |= cell << k;
  }
  return code;
}

// Scales the sheets' middles about their box until their corners reach from end to end of the target along each axis.
void stretch_to(std::vector<Sheet>& sheets, const Box& target) {
  Box middles, corners;
  for (const Sheet& sheet : sheets) {
    middles.include(sheet.middle);
    for (const glm::vec3& corner : sheet.corners()) corners.include(sheet.middle + corner);
  }
  const glm::vec3 wide = middles.size(), over = corners.size() - wide, wanted = target.size();
  for (int k = 0; k < 3; ++k) {
    if (!(wide[k] > 1e-4f)) continue;
    const float factor = std::max(wanted[k] - over[k], 0.0f) / wide[k];
    const float low = target.low[k] + (middles.low[k] - corners.low[k]);
    for (Sheet& sheet : sheets) sheet.middle[k] = low + factor * (sheet.middle[k] - middles.low[k]);
  }
}

}  // namespace

// Collects the organs with tags from `first` to `last` as sheets; `area` is that of one of scale 1.
Sheets::Sheets(std::span<const Organ> organs, std::uint32_t first, std::uint32_t last, SheetKind kind, float area)
    : breadth_(std::max(2 * area, least_breadth)) {
  if (!(area > 0)) return;
  sheets_.reserve(static_cast<std::size_t>(std::count_if(
      organs.begin(), organs.end(), [&](const Organ& organ) { return organ.tag >= first && organ.tag <= last; })));
  for (const Organ& organ : organs) {
    if (organ.tag < first || organ.tag > last) continue;
    const glm::vec3 x = right_of(organ.rotation), y = up_of(organ.rotation);
    Sheet sheet;
    // A leaf's tip is at +Y and its face looks to +Z; a blossom looks to +Y.
    sheet.along = kind == SheetKind::leaf ? y : x;
    sheet.across = kind == SheetKind::leaf ? x : glm::cross(x, y);
    sheet.length = organ.scale;
    sheet.area = area * organ.scale * organ.scale;
    sheet.middle = organ.position + 0.5f * organ.scale * y;
    middles_.include(sheet.middle);
    sheets_.push_back(sheet);
  }
}

// Sorts the sheets by their Morton codes, by counting, so that neighbours can be merged.
void Sheets::sort() {
  if (sheets_.empty()) return;
  const glm::vec3 size = middles_.size();
  const float scale = cells / std::max({size.x, size.y, size.z, 1e-6f});
  std::vector<std::uint32_t> next(cells * cells * cells + 1, 0), codes;
  codes.reserve(sheets_.size());
  for (const Sheet& sheet : sheets_) {
    codes.push_back(code_of(sheet.middle, middles_, scale));
    ++next[codes.back() + 1];
  }
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<Sheet> sorted(sheets_.size());
  for (std::size_t i = 0; i < sheets_.size(); ++i) sorted[next[codes[i]]++] = sheets_[i];
  sheets_ = std::move(sorted);
}

// Merges runs of neighbouring sheets into `count` larger ones with the same total area, which together fill the box
// `target`.
std::vector<Sheet> Sheets::merged(std::size_t count, const Box& target) const {
  const std::size_t all = sheets_.size();
  count = std::min(count, all);
  std::vector<Sheet> merged;
  merged.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = i * all / count, to = (i + 1) * all / count;
    merged.push_back(sheets_[from]);
    if (to - from == 1) continue;
    Sheet& sheet = merged.back();
    glm::vec3 sum(0);
    sheet.area = 0;
    for (std::size_t k = from; k < to; ++k) {
      sheet.area += sheets_[k].area;
      sum += sheets_[k].area * sheets_[k].middle;
    }
    sheet.middle = sum / sheet.area;
    sheet.length = std::sqrt(2 * sheet.area / breadth_);
    sheet.one = false;
  }
  stretch_to(merged, target);
  return merged;
}

}  // namespace panicle::growth
