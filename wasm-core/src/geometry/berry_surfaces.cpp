#include "geometry/berry_surfaces.hpp"

#include <algorithm>
#include <optional>

#include "foundation/random.hpp"
#include "geometry/berry_contacts.hpp"
#include "geometry/berry_gauge.hpp"
#include "geometry/berry_press.hpp"

namespace panicle {
namespace {

constexpr float hardly_shrivelled = 0.02f;

std::vector<BerryFrame> frames_of(std::span<const BerryBody> bodies) {
  std::vector<BerryFrame> frames;
  frames.reserve(bodies.size());
  for (const BerryBody& body : bodies) frames.push_back(frame_of(body, 360 * random_unit(body.id, 0, 0)));
  return frames;
}

}  // namespace

BerrySurfaces press_berries(std::span<const BerryBody> bodies, const BerryForm& form, const BerryOptions& options) {
  const auto shrivelled = [](const BerryBody& body) { return body.shrivel > hardly_shrivelled; };
  const bool furrowed = std::any_of(bodies.begin(), bodies.end(), shrivelled);
  const std::uint32_t segments = std::clamp(options.segments, 6u, 128u);
  const BerryMeridian meridian(form);
  const FruitSkin skin(form.fruit);
  const BerryPattern pattern = make_berry_pattern(std::max(skin.meridians(segments), furrowed ? segments * 9 / 4 : 0));
  const GaugeTable free = free_gauge(pattern, meridian, skin);
  const std::optional<Furrows> furrows = furrowed ? std::optional<Furrows>(pattern) : std::nullopt;
  const std::vector<BerryFrame> frames = frames_of(bodies);
  const BerryContacts contacts = find_contacts(frames, meridian, BerryPress::most_bulge * skin.highest());

  const std::size_t each = pattern.vertices;
  const std::size_t room = each * bodies.size() + 3;  // the press writes four at once
  BerrySurfaces surfaces{pattern.uvs, pattern.indices, std::vector<float>(3 * room), std::vector<float>(3 * room),
                         std::vector<std::uint8_t>(room)};
  BerryPress press(pattern);
  GaugeTable dried(furrowed ? pattern.padded() : 0);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto planes =
        std::span(contacts.planes).subspan(contacts.first[i], contacts.first[i + 1] - contacts.first[i]);
    if (shrivelled(bodies[i])) {
      const float shrivel = std::min(bodies[i].shrivel, 1.0f);
      furrows->carve(free, bodies[i].id, shrivel, dried);
      press.fit(dried, planes, meridian.volume() * (1 - furrowed_volume * shrivel));
    } else {
      press.fit(free, planes, meridian.volume());
    }
    press.write(frames[i], &surfaces.positions[3 * each * i], &surfaces.normals[3 * each * i],
                &surfaces.pressed[each * i]);
  }
  surfaces.positions.resize(3 * each * bodies.size());
  surfaces.normals.resize(3 * each * bodies.size());
  surfaces.pressed.resize(each * bodies.size());
  return surfaces;
}

}  // namespace panicle
