#include "models/particles/space_request.hpp"

#include <cmath>
#include <glm/common.hpp>

#include "foundation/vectors.hpp"
#include "models/particles/messages.generated.hpp"

namespace panicle::particles {
namespace {

// Whether a block has whole rows of `width` finite numbers of a reasonable size; if not, sets `error`. `block` is its
// name in the messages.
bool sound(std::span<const float> values, std::size_t width, const char* block, Diagnostic& error) {
  if (values.size() % width != 0) {
    error = bad_input(message(messages::particles::row_width, block, width));
    return false;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_coordinate(values[i])) continue;
    error = bad_input(message(messages::particles::number_out_of_range, block, i / width + 1, i % width + 1));
    return false;
  }
  return true;
}

// Whether all corners are indices of the `points`; if not, sets `error`. `boundary`, "outer" or "inner", names the mesh
// in the messages.
bool sound_corners(std::span<const std::uint32_t> triangles, std::size_t points, const char* boundary,
                   Diagnostic& error) {
  if (triangles.size() % 3 != 0) error = bad_input(message(messages::particles::triangle_corners, boundary));
  for (const std::uint32_t corner : triangles)
    if (error.reason == Reason::none && corner >= points)
      error = bad_input(message(messages::particles::triangle_without_point, boundary, corner, points));
  return error.reason == Reason::none;
}

// Boxes from the coordinates of two opposite corners each.
std::vector<Box> boxes_of(std::span<const float> values) {
  const std::vector<glm::vec3> corners = vectors_of(values);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i + 1 < corners.size(); i += 2)
    boxes.push_back({glm::min(corners[i], corners[i + 1]), glm::max(corners[i], corners[i + 1])});
  return boxes;
}

}  // namespace

// Reads a request's boundary meshes, targets and obstacles. Returns an error for wrong sizes, and for more of them than
// the limits allow.
Result<SpaceRequest> read_space(Request& request, const Limits& limits) {
  SpaceRequest read(read_common(request));
  read.light = request.wants("light");
  const auto profile = request.floats("profile"), points = request.floats("volume.points");
  const auto triangles = request.words("volume.triangles");
  const auto hollow_points = request.floats("hollow.points");
  const auto hollow_triangles = request.words("hollow.triangles");
  const auto targets = request.floats("targets"), obstacles = request.floats("obstacles"),
             rounds = request.floats("obstacles.round");
  if (Diagnostic error = request.trouble(); error.reason != Reason::none) return error;

  // Checks sizes and limits before anything is copied.
  Diagnostic error;
  if (!sound(profile, 2, "profile", error) || !sound(points, 3, "mesh", error) ||
      !sound(hollow_points, 3, "inner", error) || !sound(targets, 3, "targets", error) ||
      !sound(obstacles, 6, "obstacles", error) || !sound(rounds, 6, "rounds", error))
    return error;
  if (const auto refusal = too_many_triangles((triangles.size() + hollow_triangles.size()) / 3, limits))
    return *refusal;
  if (!sound_corners(triangles, points.size() / 3, "outer", error) ||
      !sound_corners(hollow_triangles, hollow_points.size() / 3, "inner", error))
    return error;
  if (targets.size() / 3 > SpaceRequest::max_targets)
    return bad_input(message(messages::particles::too_many_targets, SpaceRequest::max_targets));
  if ((obstacles.size() + rounds.size()) / 6 > Obstacles::most)
    return bad_input(message(messages::particles::too_many_obstacles, Obstacles::most));

  for (std::size_t i = 0; i + 1 < profile.size(); i += 2)
    read.profile.emplace_back(std::fmax(profile[i], 0.0f), profile[i + 1]);
  read.volume = {vectors_of(points), {triangles.begin(), triangles.end()}};
  read.hollow = {vectors_of(hollow_points), {hollow_triangles.begin(), hollow_triangles.end()}};
  read.targets = vectors_of(targets);
  read.obstacles = boxes_of(obstacles);
  read.rounds = boxes_of(rounds);
  return read;
}

}  // namespace panicle::particles
