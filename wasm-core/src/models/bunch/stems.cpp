#include "models/bunch/stems.hpp"

#include <glm/geometric.hpp>

namespace panicle::bunch {
namespace {

constexpr StemEnd receptacle{.flare = 0.35f, .height = 0.35f};
constexpr StemEnd shrivelled{.body = 0.75f, .tip = 0.5f, .height = 0.7f};

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

std::vector<Segment> segments_of(std::span<const Internode> skeleton) {
  std::vector<Segment> segments;
  segments.reserve(skeleton.size());
  for (const Internode& one : skeleton)
    segments.push_back(
        {one.parent, static_cast<std::uint32_t>(one.kind), one.start, one.end, one.radius, one.radius_end});
  return segments;
}

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
