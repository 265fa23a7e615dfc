#include "models/bunch/bunch.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "foundation/fingerprint.hpp"
#include "foundation/random.hpp"
#include "lsystem/lsystem.hpp"
#include "models/bunch/berry/berry.hpp"
#include "models/bunch/bunch_sky.hpp"
#include "models/bunch/natural/natural.hpp"
#include "models/bunch/paper/paper.hpp"
#include "models/bunch/stems.hpp"
#include "models/bunch/values.hpp"

namespace panicle::bunch {

// A pedicel is the stalk of one flower or berry.

namespace {

// Counts internodes, berries and kinds of stems. Joints, further pieces of one organ, count as internodes only.
void count(GrownBunch& grown) {
  Counts& counts = grown.counts;
  counts.internodes = static_cast<std::uint32_t>(grown.internodes.size());
  counts.berries = static_cast<std::uint32_t>(grown.berries.size());
  for (const Internode& internode : grown.internodes) {
    if (internode.joint) continue;
    counts.end_structures += internode.kind == Kind::end;
    counts.pedicels += internode.kind == Kind::pedicel;
    counts.withered += internode.state == State::withered;
  }
}

// The fingerprint of skeleton and organs, in the order of docs/fingerprint.md.
std::uint64_t fingerprint(const GrownBunch& grown) {
  Fingerprint print;
  const auto point = [&print](const glm::vec3& p) {
    print.add(p.x);
    print.add(p.y);
    print.add(p.z);
  };
  for (const Internode& internode : grown.internodes) {
    print.add(static_cast<float>(internode.parent));
    print.add(static_cast<float>(internode.kind));
    print.add(static_cast<float>(internode.axis));
    print.add(static_cast<float>(internode.state));
    point(internode.start);
    point(internode.end);
    print.add(internode.radius);
    print.add(internode.radius_end);
  }
  for (std::size_t i = 0; i < grown.berries.size(); ++i) {
    const Berry& berry = grown.berries[i];
    point(berry.centre);
    print.add(berry.radius);
    print.add(static_cast<float>(berry.parent));
    if (!grown.natural) continue;
    print.add(static_cast<float>(berry.id));
    print.add(grown.traits[i].width);
    print.add(grown.traits[i].length);
    point(berry.direction);
  }
  return print.value();
}

// Adds all numbers of a mesh to the fingerprint.
void add_mesh(Fingerprint& print, const Mesh& mesh) {
  print.add(std::span<const float>(mesh.positions));
  print.add(std::span<const float>(mesh.normals));
  print.add(std::span<const float>(mesh.uvs));
  print.add(std::span<const std::uint32_t>(mesh.indices));
}

constexpr float thin_stem = 0.00125f;  // metres; radius

// Adds the stems and the paper's one berry; the natural procedure makes its other meshes itself.
void add_meshes(GrownBunch& grown, const BunchRequest& request) {
  TubeOptions tubes;
  if (grown.natural) {  // hundreds of pedicels, most of them hidden
    tubes.sides = 8;
    tubes.thin = thin_stem;
  }
  if (request.stem_sides) tubes.sides = std::clamp(request.stem_sides, 3u, 64u);
  grown.stem = sweep_internodes(grown.internodes, tubes, 1.0f, grown.natural);
  if (grown.natural) return;
  BerryOptions berry;
  if (request.berry_segments) berry.segments = std::clamp(request.berry_segments, 6u, 128u);
  grown.berry = make_berry(berry);
}

// The fingerprint of all meshes.
std::uint64_t mesh_fingerprint(const GrownBunch& grown) {
  Fingerprint print;
  add_mesh(print, grown.stem->mesh);
  if (grown.surfaces) {
    print.add(std::span<const float>(grown.surfaces->positions));
    print.add(std::span<const float>(grown.surfaces->normals));
    print.add(std::span<const std::uint32_t>(grown.surfaces->indices));
  } else {
    add_mesh(print, *grown.berry);
  }
  if (grown.flower) add_mesh(print, grown.flower->mesh);
  if (grown.foliage) add_mesh(print, grown.foliage->mesh);
  return print.value();
}

}  // namespace

// Grows a bunch by the requested procedure, natural or the paper's, then adds counts, fingerprints, meshes and light.
Result<GrownBunch> grow(const BunchRequest& request, const Limits& limits) {
  GrownBunch grown;
  const Values values(request.parameters, grown.notes);
  grown.natural = values[Parameter::procedure] == 1;
  const Diagnostic error =
      grown.natural ? grow_natural(request, values, limits, grown) : grow_paper(request, values, limits, grown);
  if (error.reason != Reason::none) return error;
  count(grown);
  grown.fingerprint = fingerprint(grown);
  if (!request.meshes) return grown;
  add_meshes(grown, request);
  if (request.sky) add_sky(grown);
  if (request.mesh_fingerprint) grown.mesh_fingerprint = mesh_fingerprint(grown);
  return grown;
}

}  // namespace panicle::bunch
