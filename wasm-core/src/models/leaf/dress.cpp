#include "models/leaf/dress.hpp"

#include <algorithm>
#include <utility>

#include "light/plant_sky.hpp"
#include "mesh/uv_sphere.hpp"
#include "models/leaf/messages.generated.hpp"
#include "models/leaf/petiole.hpp"
#include "models/leaf/shape/blade.hpp"
#include "stems/tubes.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr float draft_detail = 0.25f;
constexpr std::uint32_t petiole_sides = 14, ball_segments = 8;

// The pieces of the veins in leaf lengths, each as wide as the energy that flows through it requires. `all` is the
// energy of the whole leaf by target; `scale` is a leaf length in metres.
std::vector<VeinPiece> pieces_of(std::span<const Trails> flat, std::span<const double> all, const Girth& girth,
                                 float scale) {
  std::vector<VeinPiece> pieces;
  for (std::size_t c = 0; c < flat.size(); ++c) {
    const Trails& trails = flat[c];
    for (std::size_t i = 0; i < trails.size(); ++i) {
      if (trails.next[i] < 0) continue;
      const glm::vec3 &from = trails.places[static_cast<std::size_t>(trails.next[i])], &to = trails.places[i];
      const float radius = radius_of(girth, trails.energy[i], all[c]) / scale;
      pieces.push_back({{from.x, from.y}, {to.x, to.y}, radius, radius});
    }
  }
  return pieces;
}

}  // namespace

// Adds the meshes of blade and petiole, of particles on their way as balls, and the visible share of the sky if
// requested.
void dress(Plant& plant, const LeafRequest& leaf_request, const Veins& veins, std::span<const Trails> flat,
           const Bending& bending, const Girth& girth) {
  using enum Parameter;
  const Values& values = leaf_request.values;
  const BladeForm form{
      .thickness = 0.001f * values[thickness],
      .relief = values[relief],
      .detail = leaf_request.draft ? std::min(leaf_request.detail, draft_detail) : leaf_request.detail};
  std::vector<PlantMesh> blade =
      make_blade(veins.margin, veins.outline, pieces_of(flat, veins.all, girth, bending.scale), bending, form);
  if (blade.empty()) plant.notes.push_back(message(messages::leaf::outline_too_narrow));
  const std::vector<Segment> stalk =
      make_petiole(bending, 0.01f * values[petiole] * bending.scale, 0.0005f * values[petiole_width]);
  StemMesh tube;
  if (!stalk.empty()) tube = sweep_stems({.segments = stalk, .jointed = false}, {.sides = petiole_sides}, 1.0f);
  if (leaf_request.sky) {
    // Owners are the petiole's segments, then the blade: a sheet that does not occlude itself.
    const auto owner = static_cast<std::int32_t>(stalk.size());
    std::vector<SkyBody> specks;
    for (std::size_t i = 0; i < stalk.size(); ++i) add_specks(stalk[i], static_cast<std::int32_t>(i), specks);
    if (!blade.empty()) add_specks(blade[0].mesh, whole_range(blade[0].mesh), owner, specks);
    Sky sky({}, specks);
    for (PlantMesh& face : blade) {
      std::vector<std::uint8_t> bytes(face.mesh.positions.size() / 3);
      sample_part(sky, face.mesh, whole_range(face.mesh), owner, true, bytes);
      face.columns.add("sky", std::move(bytes));
    }
    std::vector<std::uint8_t> bytes;
    if (!stalk.empty()) bytes = sky_of_stems(sky, tube, stalk);
    for (PlantMesh& face : blade) plant.meshes.push_back(std::move(face));
    if (!stalk.empty()) {
      plant.meshes.push_back({"petiole", "stem", std::move(tube.mesh), {}, {}});
      plant.meshes.back().columns.add("sky", std::move(bytes));
    }
  } else {
    for (PlantMesh& face : blade) plant.meshes.push_back(std::move(face));
    if (!stalk.empty()) plant.meshes.push_back({"petiole", "stem", std::move(tube.mesh), {}, {}});
  }
  if (plant.organs.empty()) return;
  const auto ball = static_cast<std::int32_t>(plant.meshes.size());
  plant.meshes.push_back({"particle", "skin", make_uv_sphere(ball_segments), {}, {}});
  for (Organ& organ : plant.organs) organ.mesh = ball;
}

}  // namespace panicle::particles::leaf
