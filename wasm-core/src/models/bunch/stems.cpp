#include "models/bunch/stems.hpp"

#include <glm/geometric.hpp>

namespace panicle::bunch {
namespace {

constexpr StemEnd receptacle{.flare = 0.35f, .height = 0.35f};
constexpr StemEnd shrivelled{.body = 0.75f, .tip = 0.5f, .height = 0.7f};

// The form of an internode's upper end: a receptacle for pedicels with a berry, a shrivelled tip for withered ones.
StemEnd end_of(const Internode& internode) {
  if (internode.kind != Kind::pedicel) return {};
  return internode.state == State::withered ? shrivelled : receptacle;
}

// Whether nodes of the rachis are nearer to each other than it is wide: swellings would look like turned rings.
bool crowded(std::span<const Internode> skeleton) {
  float length = 0, width = 0;
  for (const Internode& one : skeleton) {
    if (one.kind != Kind::rachis) continue;
    length += glm::length(one.end - one.start);
    width += one.radius + one.radius_end;
  }
  return length < width;
}

}  // namespace

// The internodes as segments, tagged by kind.
std::vector<Segment> segments_of(std::span<const Internode> skeleton) {
  std::vector<Segment> segments;
  segments.reserve(skeleton.size());
  for (const Internode& one : skeleton) {
    segments.push_back(one);
    segments.back().tag = static_cast<std::uint32_t>(one.kind);
  }
  return segments;
}

// Builds the tubes of all stems. `scale`: length of the unit in the mesh's; `natural`: tapering, with swollen nodes
// only where they are not crowded.
StemMesh sweep_internodes(std::span<const Internode> skeleton, const TubeOptions& options, float scale, bool natural) {
  const std::vector<Segment> segments = segments_of(skeleton);
  std::vector<std::int32_t> groups;
  std::vector<StemEnd> ends;
  groups.reserve(skeleton.size());
  ends.reserve(skeleton.size());
  for (const Internode& one : skeleton) {
    groups.push_back(one.axis);
    ends.push_back(end_of(one));
  }
  Stems stems{segments, groups, ends};
  stems.tapering = natural;
  stems.jointed = !natural || !crowded(skeleton);
  return sweep_stems(stems, options, scale);
}

}  // namespace panicle::bunch
