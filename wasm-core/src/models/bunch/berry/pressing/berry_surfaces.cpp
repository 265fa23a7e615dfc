#include "models/bunch/berry/pressing/berry_surfaces.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "foundation/random.hpp"
#include "models/bunch/berry/berry_gauge.hpp"
#include "models/bunch/berry/pressing/berry_contacts.hpp"
#include "models/bunch/berry/pressing/berry_press.hpp"

namespace panicle::bunch {
namespace {

constexpr float hardly_shrivelled = 0.02f;
constexpr float tolerated = 0.01f;  // of a berry's volume, before its neighbours have to make room

// The frames of all berries, each turned about its own axis at random.
std::vector<BerryFrame> frames_of(std::span<const BerryBody> bodies) {
  std::vector<BerryFrame> frames;
  frames.reserve(bodies.size());
  for (const BerryBody& body : bodies) frames.push_back(frame_of(body, 360 * random_unit(body.id, 0, 0)));
  return frames;
}

// Presses all berries of one bunch.
class Pressing {
 public:
  Pressing(std::span<const BerryBody> bodies, const BerryForm& form, std::uint32_t segments)
      : bodies_(bodies),
        furrowed_(std::any_of(bodies.begin(), bodies.end(), shrivelled)),
        meridian_(form),
        skin_(form.fruit, form.relief),
        pattern_(make_berry_pattern(std::max(skin_.meridians(segments), furrowed_ ? segments * 9 / 4 : 0))),
        free_(free_gauge(pattern_, {meridian_, form.curve}, skin_)),
        dried_(furrowed_ ? pattern_.padded() : 0),
        frames_(frames_of(bodies)),
        contacts_(find_contacts(frames_, meridian_, BerryPress::max_bulge * skin_.highest() * bow_reach(form.curve))),
        press_(pattern_) {
    if (furrowed_) furrows_.emplace(pattern_);
  }

  // Presses each berry against its neighbours, then lets those without enough room push their planes outward, in a few
  // rounds.
  BerrySurfaces press() {
    const std::size_t berries = bodies_.size(), each = pattern_.vertices;
    surfaces_ = {pattern_.uvs, pattern_.indices, std::vector<float>(3 * each * berries),
                 std::vector<float>(3 * each * berries), std::vector<std::uint8_t>(each * berries)};
    lacking_.assign(berries, 0);
    for (std::size_t i = 0; i < berries; ++i) press_one(i);
    bool short_of_room = true;
    for (int round = 0; round < max_rounds && short_of_room; ++round) short_of_room = share_room();
    return std::move(surfaces_);
  }

 private:
  static constexpr int max_rounds = 3;

  // Whether a berry has dried enough for its folds to show.
  static bool shrivelled(const BerryBody& body) { return body.shrivel > hardly_shrivelled; }

  // Computes the surface of berry `i` between its planes, and how much of its volume finds no room.
  void press_one(std::size_t i) {
    const BerryBody& body = bodies_[i];
    const float shrivel = shrivelled(body) ? std::min(body.shrivel, 1.0f) * skin_.folds() : 0;
    if (shrivel > 0) furrows_->carve(free_, body.id, shrivel, dried_);
    lacking_[i] =
        press_.fit(shrivel > 0 ? dried_ : free_, contacts_.of(i), meridian_.volume() * (1 - furrowed_volume * shrivel));
    const std::size_t at = i * pattern_.vertices;
    press_.write(frames_[i], &surfaces_.positions[3 * at], &surfaces_.normals[3 * at], &surfaces_.pressed[at]);
  }

  // Moves the planes of berries without the room for their volume towards neighbours that lack less. False if none
  // lacks any.
  bool share_room() {
    std::vector<bool> touched(bodies_.size(), false);
    bool any = false;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      for (std::size_t at = contacts_.first[i]; lacking_[i] > tolerated && at < contacts_.first[i + 1]; ++at) {
        const BerryPlane& plane = contacts_.planes[at];
        const float more = lacking_[i] - lacking_[plane.neighbour];
        if (more <= 0 || plane.depth < -0.1f) continue;
        // Moving all planes by a third of the missing length would about make up for it, but other planes give way too.
        const float room = contacts_.planes[plane.twin].from;
        contacts_.move(at, std::min(0.5f * more * plane.from, 0.08f * room));
        touched[i] = touched[plane.neighbour] = any = true;
      }
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (touched[i]) press_one(i);
    }
    return any;
  }

  std::span<const BerryBody> bodies_;
  bool furrowed_;
  BerryMeridian meridian_;
  FruitSkin skin_;
  BerryPattern pattern_;
  GaugeTable free_, dried_;
  std::optional<Furrows> furrows_;
  std::vector<BerryFrame> frames_;
  BerryContacts contacts_;
  BerryPress press_;
  std::vector<float> lacking_;
  BerrySurfaces surfaces_;
};

}  // namespace

// The surfaces of all berries, pressed flat where they touch.
BerrySurfaces press_berries(std::span<const BerryBody> bodies, const BerryForm& form, const BerryOptions& options) {
  return Pressing(bodies, form, std::clamp(options.segments, 6u, 128u)).press();
}

}  // namespace panicle::bunch
