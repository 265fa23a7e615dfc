#include "models/particles/space_request.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <string>

namespace panicle::particles {
namespace {

constexpr float farthest = 1e4f;

Diagnostic refused(std::string why) { return {Reason::bad_input, std::move(why), 0, 0}; }

// Whether a block holds whole rows of finite numbers of a sound size; if not, sets `trouble`.
bool sound(std::span<const float> values, std::size_t width, const char* name, Diagnostic& trouble) {
  if (values.size() % width != 0) {
    trouble = refused(std::string(name) + " must have " + std::to_string(width) + " numbers each.");
    return false;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::fabs(values[i]) <= farthest) continue;
    trouble = refused(std::string(name) + ": number " + std::to_string(i % width + 1) + " of row " +
                      std::to_string(i / width + 1) + " is not finite or beyond 10 km.");
    return false;
  }
  return true;
}

// Whether all corners are some of the points; if not, sets `trouble`. `owner`: the owner of the points, "the mesh".
bool sound_corners(std::span<const std::uint32_t> triangles, std::size_t points, const std::string& owner,
                   Diagnostic& trouble) {
  if (triangles.size() % 3 != 0) trouble = refused("Triangles of " + owner + " must have 3 corners each.");
  for (const std::uint32_t corner : triangles)
    if (trouble.reason == Reason::none && corner >= points)
      trouble = refused("A triangle of " + owner + " has the corner " + std::to_string(corner) +
                        ", but there are only " + std::to_string(points) + " points.");
  return trouble.reason == Reason::none;
}

std::vector<glm::vec3> triples(std::span<const float> values) {
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) points.emplace_back(values[i], values[i + 1], values[i + 2]);
  return points;
}

// Boxes from two opposite corners each.
std::vector<Box> boxes_of(std::span<const float> values) {
  const std::vector<glm::vec3> corners = triples(values);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i + 1 < corners.size(); i += 2)
    boxes.push_back({glm::min(corners[i], corners[i + 1]), glm::max(corners[i], corners[i + 1])});
  return boxes;
}

}  // namespace

Result<SpaceRequest> read_space(Request& request, const Limits& limits) {
  SpaceRequest read;
  request.text("model");
  read.seed = request.word("seed", 1);
  read.meshes = request.wants("meshes");
  read.measures = request.wants("measures");
  read.sky = request.wants("sky");
  read.light = request.wants("light");
  read.mesh_fingerprint = request.wants("mesh_fingerprint");
  read.parameters = request.floats("parameters");
  const auto profile = request.floats("profile"), points = request.floats("volume.points");
  const auto triangles = request.words("volume.triangles");
  const auto hollow_points = request.floats("hollow.points");
  const auto hollow_triangles = request.words("hollow.triangles");
  const auto targets = request.floats("targets"), obstacles = request.floats("obstacles"),
             rounds = request.floats("obstacles.round");
  if (Diagnostic trouble = request.trouble(); trouble.reason != Reason::none) return trouble;

  Diagnostic trouble;
  if (!sound(profile, 2, "Points of the profile", trouble) || !sound(points, 3, "Points of the mesh", trouble) ||
      !sound(hollow_points, 3, "Points of the inner boundary's mesh", trouble) ||
      !sound(targets, 3, "Targets", trouble) || !sound(obstacles, 6, "Obstacles", trouble) ||
      !sound(rounds, 6, "Round obstacles", trouble))
    return trouble;
  if (const auto refusal = too_many_triangles((triangles.size() + hollow_triangles.size()) / 3, limits))
    return *refusal;
  if (!sound_corners(triangles, points.size() / 3, "the mesh", trouble) ||
      !sound_corners(hollow_triangles, hollow_points.size() / 3, "the inner boundary's mesh", trouble))
    return trouble;
  if (targets.size() / 3 > SpaceRequest::most_targets)
    return refused("There may be no more than " + std::to_string(SpaceRequest::most_targets) + " targets.");
  if ((obstacles.size() + rounds.size()) / 6 > Obstacles::most)
    return refused("There may be no more than " + std::to_string(Obstacles::most) + " obstacles.");

  for (std::size_t i = 0; i + 1 < profile.size(); i += 2)
    read.profile.emplace_back(std::fmax(profile[i], 0.0f), profile[i + 1]);
  read.volume = {triples(points), {triangles.begin(), triangles.end()}};
  read.hollow = {triples(hollow_points), {hollow_triangles.begin(), hollow_triangles.end()}};
  read.targets = triples(targets);
  read.obstacles = boxes_of(obstacles);
  read.rounds = boxes_of(rounds);
  return read;
}

}  // namespace panicle::particles
