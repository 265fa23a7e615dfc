#include "models/bunch/bunch_sky.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "light/plant_sky.hpp"
#include "models/bunch/stems.hpp"

namespace panicle::bunch {
namespace {

// Berries longer than these multiples of their width count as two balls, as three.
constexpr float two_from = 1.35f, three_from = 2.1f;
constexpr float row_width = 0.96f;  // width of the balls in a row, over the berry's own

// Numbers of owners: internodes, then berries, then parts of the foliage.
struct Owners {
  explicit Owners(const GrownBunch& grown)
      : berries(static_cast<std::int32_t>(grown.internodes.size())),
        foliage(berries + static_cast<std::int32_t>(grown.berries.size())) {}
  const std::int32_t berries, foliage;
};

// Adds the balls that hide sky in place of a berry: one, or for a long berry a row of two or three along its direction.
void add_balls(const Berry& berry, const Traits& traits, std::int32_t owner, std::vector<SkyBody>& balls) {
  const float ratio = traits.length / traits.width;
  if (!(ratio >= two_from)) {
    balls.push_back(sky_ball(berry.centre, berry.radius, owner));
    return;
  }
  const float reach = 0.5f * (traits.length - traits.width), radius = 0.5f * row_width * traits.width;
  const auto add = [&](float along) {
    balls.push_back(sky_ball(berry.centre + berry.direction * (along * reach), radius, owner));
  };
  const bool three = ratio >= three_from;
  add(three ? -1 : -0.9f);
  if (three) add(0);
  add(three ? 1 : 0.9f);
}

// The sky with all that hides it: berries as balls, the other stems and the foliage as specks. Pedicels are left out.
Sky make_sky(const GrownBunch& grown, std::span<const Segment> segments) {
  const Owners owners(grown);
  std::vector<SkyBody> balls;
  for (std::size_t i = 0; i < grown.berries.size(); ++i)
    add_balls(grown.berries[i], grown.traits[i], owners.berries + static_cast<std::int32_t>(i), balls);
  std::vector<SkyBody> specks;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (grown.internodes[i].kind != Kind::pedicel) add_specks(segments[i], static_cast<std::int32_t>(i), specks);
  if (grown.foliage) {
    std::int32_t owner = owners.foliage;
    for (const FoliagePart& part : grown.foliage->parts) add_specks(grown.foliage->mesh, part, owner++, specks);
  }
  return Sky(balls, specks);
}

// The frame of a berry drawn with the shared mesh. All renderers and exporters rotate it like this: half a turn about
// X, then the shortest way from −Y to the berry's direction (web/src/plant/orientation.ts).
SkyFrame frame_for(const Berry& berry) {
  const glm::vec3& to = berry.direction;
  SkyFrame frame{.centre = berry.centre, .scale = berry.radius};
  const float across = to.x * to.x + to.z * to.z;
  const float lift = to.y > 0 ? across / (1 + to.y) : 1 - to.y;
  const float length = std::sqrt(lift * lift + across);
  if (!(length > 0)) return frame;
  const float x = lift / length, y = to.x / length, w = to.z / length;
  frame.side = {1 - 2 * y * y, 2 * x * y, -2 * w * y};
  frame.up = {2 * x * y, 1 - 2 * x * x, 2 * w * x};
  frame.front = {2 * w * y, -2 * w * x, 1 - 2 * (x * x + y * y)};
  return frame;
}

// How much sky each vertex of each berry sees, 0 … 255; berries without surfaces of their own share one mesh.
std::vector<std::uint8_t> sky_of_berries(Sky& sky, const GrownBunch& grown) {
  const Owners owners(grown);
  const bool has_surfaces = grown.surfaces.has_value();
  const std::size_t per_berry = has_surfaces ? grown.surfaces->uvs.size() / 2 : grown.berry->uvs.size() / 2;
  std::vector<std::uint8_t> bytes(per_berry * grown.berries.size());
  for (std::size_t i = 0; i < grown.berries.size(); ++i) {
    const Berry& berry = grown.berries[i];
    sky.set_receiver({berry.centre, berry.radius, owners.berries + static_cast<std::int32_t>(i), berry.parent});
    const auto into = std::span(bytes).subspan(per_berry * i, per_berry);
    if (has_surfaces) {
      const auto slice = [&](const std::vector<float>& all) {
        return std::span(all).subspan(3 * per_berry * i, 3 * per_berry);
      };
      sky.sample(slice(grown.surfaces->positions), slice(grown.surfaces->normals), into);
    } else {
      sky.set_frame(frame_for(berry));
      sky.sample(grown.berry->positions, grown.berry->normals, into);
    }
  }
  return bytes;
}

// How much sky each vertex of the leaves and the cane sees, 0 … 255.
std::vector<std::uint8_t> sky_of_foliage(Sky& sky, const GrownBunch& grown) {
  const Mesh& mesh = grown.foliage->mesh;
  std::vector<std::uint8_t> bytes(mesh.positions.size() / 3);
  std::int32_t owner = Owners(grown).foliage;
  for (const FoliagePart& part : grown.foliage->parts)
    sample_part(sky, mesh, part, owner++, part.kind == FoliagePart::Kind::leaf, bytes);
  return bytes;
}

}  // namespace

// Computes how much sky all vertices of the bunch see past its other parts.
void add_sky(GrownBunch& grown) {
  const std::vector<Segment> segments = segments_of(grown.internodes);
  Sky sky = make_sky(grown, segments);
  SkyBytes& bytes = grown.sky.emplace();
  bytes.stems = sky_of_stems(sky, *grown.stem, segments);
  bytes.berries = sky_of_berries(sky, grown);
  if (grown.foliage) bytes.foliage = sky_of_foliage(sky, grown);
}

}  // namespace panicle::bunch
