// The root (Rodkaew et al. 2003, section 4; docs/models/root/root.md): particles in a volume below ground, whose trails
// up to the collar are its roots. Blocks: those of space_request.hpp. Columns: those of trail_plant.hpp, and
// `organs.sky`. Organs: `particle`. Meshes: `stems`, `balls`.
#include "protocol/model.hpp"

#include <array>
#include <glm/common.hpp>
#include <limits>
#include <string>

#include "foundation/mathematics.hpp"
#include "mesh/uv_sphere.hpp"
#include "models/particles/boundary.hpp"
#include "models/particles/dressing.hpp"
#include "models/particles/grown.hpp"
#include "models/particles/hormone.hpp"
#include "models/particles/refusals.hpp"
#include "models/particles/space_request.hpp"
#include "models/root/measures/measures.generated.hpp"
#include "models/root/parameters.generated.hpp"
#include "models/root/storage.hpp"
#include "plant/fingerprint.hpp"
#include "plant/wood_measures.hpp"
#include "protocol/parameter_values.hpp"

namespace panicle::particles::root {
namespace {

using RootValues = Values<Parameter, parameter_table>;
using enum Parameter;

constexpr std::uint32_t no_leaf = 1, particle_tag = 0;
constexpr std::uint32_t ball_segments = 12;
constexpr float deepest = -1e6f;  // lowest height of a way past an obstacle
// Reach of the hormone, in depths of the volume; radius of the main root, in widths.
constexpr float hormone_reach = 0.5f, leader = 0.06f;
constexpr std::array<glm::vec2, 5> carrot{{{0.04f, 0}, {0.16f, 0.3f}, {0.34f, 0.6f}, {0.7f, 0.85f}, {1, 1}}};

// The region between the boundaries, with the density of soil and hormone.
class Soil final : public Region {
 public:
  // All must outlive it. `topsoil`: the depth at which density has fallen to 1/e; 0: it does not.
  Soil(const Solid& outer, const Solid& inner, float topsoil, const Hormone& hormone)
      : outer_(&outer), inner_(&inner), hormone_(&hormone), topsoil_(topsoil) {}
  // The box round the soil.
  glm::vec3 low() const override { return outer_->low(); }
  glm::vec3 high() const override { return outer_->high(); }
  // Whether a point is in the soil, between the outer and the inner boundary.
  bool contains(const glm::vec3& p) const override { return outer_->contains(p) && !inner_->contains(p); }
  // Whether none, some or all of a box is in the soil.
  Share share_of(const glm::vec3& from, const glm::vec3& to) const override {
    return share_between(outer_->share_of(from, to), inner_->share_of(from, to));
  }
  // Whether the queries have used up their budget.
  bool is_exhausted() const override { return outer_->is_exhausted(); }
  // The density of starting places at a point: it falls with depth below the surface, and where the hormone holds roots
  // back.
  float density(const glm::vec3& p) const override {
    return (topsoil_ > 0 ? exponential((p.y - high().y) / topsoil_) : 1) * hormone_->left(p);
  }

 private:
  const Solid* outer_;
  const Solid* inner_;
  const Hormone* hormone_;
  float topsoil_;
};

// Measures the roots; `room` is the volume that they may fill, m³. The density is in kilometres of roots a cubic metre.
std::vector<float> measures_of(const Plant& plant, float room) {
  const Branching branching = branching_of(plant.segments);
  auto measures = wood_measures<Measure>(branching, measure_count);
  const double rooted = static_cast<double>(room);
  measures.set(Measure::deepest, std::max(-branching.low, 0.0f));
  measures.set(Measure::root_volume, rooted);
  measures.set(Measure::collar_width, 100 * branching.thickest);
  measures.set(Measure::surface, branching.surface);
  measures.set(Measure::density,
               rooted > 0 ? 0.001 * branching.length / rooted : std::numeric_limits<double>::quiet_NaN());
  return measures.take();
}

// Grows roots: a boundary in the ground, wood from particles that walk up to the collar, then meshes and measures as
// requested.
Result<Plant> grow(Request& request, const Limits& limits) {
  const Result<SpaceRequest> read = read_space(request, limits);
  if (!read) return read.error();
  Plant plant;
  const RootValues values(read->parameters, plant.notes);
  constexpr std::array forms{Form::ellipsoid, Form::bowl, Form::cone_down, Form::box, Form::spline, Form::mesh};
  Form form = forms[values.whole(shape)];
  if (form == Form::mesh) note_on(read->volume, form, plant.notes);
  SpaceHabit space = space_habit<Parameter>(values);
  const float size = space.growth, ground = -size * values[top];
  const glm::vec3 extent = size * glm::vec3(values[width], values[reach], values[depth]);
  const glm::vec3 high(0.5f * extent.x, ground, 0.5f * extent.z), low(-high.x, ground - extent.y, -high.z);
  const Surface whole = form_between(form, profile_of(read->profile, carrot), read->volume, low, high);
  const auto budget = std::make_shared<QueryBudget>(limits.looks);
  const Solid outer(whole, budget);
  // The bare region is around the collar.
  if (!read->hollow.triangles.empty()) note_seams(read->hollow, "inner", plant.notes);
  const Solid inner(inner_boundary(whole, read->hollow, low, high, {0, ground, 0}, values[Parameter::inner]), budget);
  std::vector<glm::vec3> targets = read->targets;
  const float plants = values[stems];
  for (float k = 0; read->targets.empty() && k < plants; ++k)
    targets.emplace_back(extent.x * ((k + 0.5f) / plants - 0.5f), 0, 0);

  const Hormone held{values[hormone], low.y, hormone_reach * extent.y, 0.5f * leader * (extent.x + extent.z), targets};
  const Soil soil(outer, inner, values.whole(pattern) == 3 ? values[topsoil] : 0, held);
  space.trunk.way = 1;
  space.trunk.height = -low.y;
  space.trunk.reach = 0.25f * (extent.x + extent.z);
  plant.tags = {"root"};
  plant.organ_tags = {"particle"};
  const Result<GrownWood> ran =
      grow_wood(plant, soil, outer, targets, space, read.value(), deepest, 0, particle_tag, limits);
  if (!ran) return ran.error();
  const GrownWood& grown = ran.value();
  if (Diagnostic error = too_many_parts(limits, plant.segments.size(), 0); error.reason != Reason::none) return error;
  if (values[storage] > 0) {
    const StorageHabit store{0.005f * size * values[storage], values[storage_reach] * extent.y};
    for (std::size_t c = 0; c < grown.trails.size(); ++c) swell(plant.segments, grown, c, store);
  }
  if (read->measures) plant.measures = measures_of(plant, grown.room);
  if (read->meshes) {
    dress(plant, grown,
          {.material = "root",
           .leaf = no_leaf,
           .sky = read->sky,
           .foot = {.stump = 0.01f * size * values[stump], .standing = false}});
    for (Organ& organ : plant.organs) organ.mesh = 1;
    if (!plant.organs.empty()) plant.meshes.push_back({"balls", "skin", make_uv_sphere(ball_segments), {}, {}});
  }
  set_fingerprints(plant, read->mesh_fingerprint);
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"root", grow};

}  // namespace panicle::particles::root
