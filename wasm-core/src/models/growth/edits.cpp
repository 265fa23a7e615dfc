#include "models/growth/edits.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "models/growth/messages.generated.hpp"

namespace panicle::growth {
namespace {

constexpr float thousandth = 0.001f, least_cut = 0.01f, greatest_cut = 0.99f;
constexpr int samples = 12;  // of the curve between two points

// The point at a share of the way from b to c on the cubic curve through a, b, c and d (Catmull and Rom 1974).
glm::vec3 spline(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d, float t) {
  return 0.5f * (2.0f * b + t * (c - a) + t * t * (2.0f * a - 5.0f * b + 4.0f * c - d) +
                 t * t * t * (3.0f * b - a - 3.0f * c + d));
}

// Samples the smooth curve from the origin through points.
void sample_curve(const std::vector<glm::vec3>& points, ShootEdit& edit) {
  std::vector<glm::vec3> through{glm::vec3(0)};
  for (const glm::vec3& point : points)
    if (glm::distance(point, through.back()) > 1e-3f) through.push_back(point);
  edit.curve.assign(1, glm::vec3(0));
  edit.distances.assign(1, 0.0f);
  const std::size_t last = through.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const glm::vec3 before = i > 0 ? through[i - 1] : 2.0f * through[0] - through[1];
    const glm::vec3 after = i + 2 <= last ? through[i + 2] : 2.0f * through[last] - through[last - 1];
    for (int k = 1; k <= samples; ++k) {
      const glm::vec3 next =
          spline(before, through[i], through[i + 1], after, static_cast<float>(k) / static_cast<float>(samples));
      edit.distances.push_back(edit.distances.back() + glm::distance(next, edit.curve.back()));
      edit.curve.push_back(next);
    }
  }
}

// Adds an edit to those of its shoot.
void add(const BranchEdit& each, ShootEdit& edit) {
  switch (each.kind) {
    case EditKind::prune:
    case EditKind::snap:
      edit.cut = std::clamp(each.at, least_cut, greatest_cut);
      edit.snapped = each.kind == EditKind::snap;
      break;
    case EditKind::dead:
      edit.dead = true;
      break;
    case EditKind::curve:
      sample_curve(each.curve, edit);
      if (!(edit.distances.back() > 0)) {
        edit.curve.clear();
        edit.distances.clear();
      }
      break;
  }
}

}  // namespace

Result<std::vector<BranchEdit>> read_edits(std::span<const std::uint32_t> records, std::span<const float> points) {
  if (records.size() % words_per_edit != 0 || points.size() % 3 != 0)
    return bad_request(message(messages::growth::edits_unreadable));
  if (records.size() / words_per_edit > max_edits)
    return Diagnostic{Reason::limit, message(messages::growth::too_many_edits, max_edits)};
  for (const float each : points)
    if (!(std::fabs(each) <= max_curve_reach)) return bad_request(message(messages::growth::edits_unreadable));
  std::vector<BranchEdit> edits;
  std::size_t used = 0;
  for (std::size_t i = 0; i < records.size(); i += words_per_edit) {
    const std::uint32_t kind = records[i + 2], share = records[i + 3], count = records[i + 4];
    const bool drawn = kind == static_cast<std::uint32_t>(EditKind::curve);
    if (kind > static_cast<std::uint32_t>(EditKind::curve) || share > 1000 || drawn != (count > 0))
      return bad_request(message(messages::growth::edits_unreadable));
    if (count > max_curve_points)
      return Diagnostic{Reason::limit, message(messages::growth::too_many_curve_points, max_curve_points)};
    if (points.size() < 3 * (used + count)) return bad_request(message(messages::growth::edits_unreadable));
    BranchEdit edit;
    edit.address = records[i] | std::uint64_t{records[i + 1]} << 32;
    edit.kind = static_cast<EditKind>(kind);
    edit.at = thousandth * static_cast<float>(share);
    for (std::size_t k = used; k < used + count; ++k)
      edit.curve.emplace_back(points[3 * k], points[3 * k + 1], points[3 * k + 2]);
    used += count;
    edits.push_back(std::move(edit));
  }
  if (points.size() != 3 * used) return bad_request(message(messages::growth::edits_unreadable));
  return edits;
}

// Finds the shoots of edits by their addresses, in one pass over the population.
ShootEdits::ShootEdits(const Population& population, std::span<const BranchEdit> edits) {
  if (edits.empty()) return;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> places;  // addresses, and the shoots that they belong to
  for (const BranchEdit& each : edits) places.emplace_back(each.address, none);
  std::sort(places.begin(), places.end());
  const auto find = [&](std::uint64_t address) {
    return std::lower_bound(places.begin(), places.end(), std::pair<std::uint64_t, std::uint32_t>{address, 0});
  };
  for (std::uint32_t q = 0; q < population.addresses.size(); ++q)
    for (auto place = find(population.addresses[q]); place != places.end() && place->first == population.addresses[q];
         ++place)
      place->second = q;
  for (const BranchEdit& each : edits) {
    const std::uint32_t shoot = find(each.address)->second;
    if (shoot == none) {
      ++unknown_;
      continue;
    }
    if (numbers_.empty()) numbers_.assign(population.shoots.size(), none);
    if (numbers_[shoot] == none) {
      numbers_[shoot] = static_cast<std::uint32_t>(edits_.size());
      edits_.emplace_back();
    }
    add(each, edits_[numbers_[shoot]]);
  }
}

glm::vec3 place_on_curve(const ShootEdit& edit, float share) {
  const float distance = std::clamp(share, 0.0f, 1.0f) * edit.distances.back();
  const auto after = std::lower_bound(edit.distances.begin() + 1, edit.distances.end() - 1, distance);
  const auto k = static_cast<std::size_t>(after - edit.distances.begin());
  const float length = edit.distances[k] - edit.distances[k - 1];
  return glm::mix(edit.curve[k - 1], edit.curve[k],
                  length > 0 ? std::clamp((distance - edit.distances[k - 1]) / length, 0.0f, 1.0f) : 1.0f);
}

}  // namespace panicle::growth
