#include "light/sky.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>

namespace panicle {
namespace {

constexpr float ball_horizon = 6, speck_horizon = 5;  // in radii of the largest
constexpr float touching = 0.1f;                      // of a receiver's extent: nearer than that counts as touching it
constexpr float worth_a_look = 0.4f;                  // radius over distance, from the surface to the ball's
// Numbers for a body without an owner, one without a parent, and a receiver without either: no two are the same.
constexpr std::uint32_t no_owner = 0xffffffffu, no_parent = 0xfffffffeu, no_receiver = 0xfffffffdu;

// The number by which owners are compared; `none` for −1.
std::uint32_t number(std::int32_t owner, std::uint32_t none) {
  return owner < 0 ? none : static_cast<std::uint32_t>(owner);
}

// The result of a comparison as words of all ones (true) or none.
template <class Comparison>
FourWords mask(const Comparison& four) {
  FourWords words;
  static_assert(sizeof words == sizeof four);
  std::memcpy(&words, &four, sizeof words);
  return words;
}

// `v` in the lanes where the mask is set, 0 in the others.
Four select_lanes(const FourWords& holds, const Four& v) {
  FourWords bits;
  std::memcpy(&bits, &v, sizeof bits);
  bits &= holds;
  Four four;
  std::memcpy(&four, &bits, sizeof four);
  return four;
}

// Whether the mask is set in any lane.
bool any(const FourWords& holds) { return (holds[0] | holds[1] | holds[2] | holds[3]) != 0; }

// The greater value in each lane.
Four max_of(const Four& a, const Four& b) { return a > b ? a : b; }

float sum_of(const Four& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

// Whether a body is finite and has an area.
bool counts(const SkyBody& body) {
  const glm::vec3& p = body.centre;
  return std::isfinite(p.x + p.y + p.z) && std::isfinite(body.square) && body.square > 0;
}

}  // namespace

// Sorts the bodies into a grid and copies them to columns in the order of its slots. `horizon`: how far queries reach,
// in radii of the largest body. Bodies that do not count are put in no cell.
Sky::BodyTable::BodyTable(std::span<const SkyBody> bodies, float horizon) {
  constexpr float nowhere = std::numeric_limits<float>::infinity();  // in no cell
  std::vector<glm::vec3> centres;
  centres.reserve(bodies.size());
  for (const SkyBody& body : bodies) {
    centres.push_back(counts(body) ? body.centre : glm::vec3(nowhere));
    if (counts(body)) largest = std::max(largest, std::sqrt(body.square));
  }
  reach = horizon * largest;
  grid.build(centres, 0.5f * reach);
  stride = grid.ids().size() + 3;
  values.assign(columns * stride, 1);
  float* at = values.data();
  for (const std::uint32_t id : grid.ids()) {
    const SkyBody& body = bodies[id];
    const std::uint32_t owners[] = {number(body.owner, no_owner), number(body.parent, no_parent)};
    const float row[] = {body.centre.x, body.centre.y,          body.centre.z,
                         body.square,   std::sqrt(body.square), body.facing.x,
                         body.facing.y, body.facing.z,          body.facing == glm::vec3(0) ? 1.0f : 0.0f};
    for (std::size_t column = 0; column < owner; ++column) at[column * stride] = row[column];
    for (std::size_t k = 0; k < 2; ++k) std::memcpy(at + (owner + k) * stride, &owners[k], sizeof owners[k]);
    ++at;
  }
}

// Sorts the bodies that hide sky into grids; they count up to a few radii of the largest away.
Sky::Sky(std::span<const SkyBody> balls, std::span<const SkyBody> specks)
    : balls_(balls, ball_horizon), specks_(specks, speck_horizon) {}

// Prepares sampling at a receiver: sums up all bodies around it, but those of the receiver's own part, and lists the
// balls that look largest.
void Sky::set_receiver(const SkyReceiver& receiver) {
  count_ = 0;
  far_balls_ = sum(balls_, receiver, true);
  load_nearest(receiver.centre);
  far_specks_ = sum(specks_, receiver, false);
}

// Inserts a ball into the short list of those that look largest, greatest weight first; the last one drops out of a
// full list.
void Sky::insert_nearest(std::uint32_t slot, float weight) {
  if (count_ == nearest && !(weight > weights_[nearest - 1])) return;
  if (count_ < nearest) ++count_;
  std::size_t k = count_ - 1;
  for (; k > 0 && weights_[k - 1] < weight; --k) {
    weights_[k] = weights_[k - 1];
    slots_[k] = slots_[k - 1];
  }
  weights_[k] = weight;
  slots_[k] = slot;
}

// Sums up the light that bodies hide from a receiver, as a constant and a term that is proportional to the cosine
// between normal and direction; with `look`, also inserts the balls that look largest into the short list.
Sky::Bands Sky::sum(const BodyTable& bodies, const SkyReceiver& receiver, bool look) {
  const glm::vec3 c = receiver.centre;
  const float reach = bodies.reach;
  const std::uint32_t self = number(receiver.owner, no_receiver), parent = number(receiver.parent, no_receiver);
  Four constant{}, x{}, y{}, z{};
  const auto row = [&](std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t slot = first; slot < end; slot += 4) {
      const auto four = [&](BodyTable::Column column) { return load(bodies.of(column) + slot); };
      const Four dx = four(BodyTable::x) - c.x, dy = four(BodyTable::y) - c.y, dz = four(BodyTable::z) - c.z;
      const Four square = dx * dx + dy * dy + dz * dz, size = four(BodyTable::square);
      const auto bits = [&](BodyTable::Column column) { return mask(four(column)); };
      const FourWords owner = bits(BodyTable::owner), lane{slot, slot + 1, slot + 2, slot + 3};
      FourWords seen = mask(square < reach * reach) & mask(lane < FourWords{} + end) & mask(owner != self);
      if (!look) {
        const FourWords its_parent = bits(BodyTable::parent);
        seen &= mask(owner != parent) & mask(its_parent != self) & mask(its_parent != parent);
      }
      if (!any(seen)) continue;
      const Four away = square_root(max_of(square, size)), nearness = 1.0f / away;
      Four hidden = select_lanes(seen, size * nearness * nearness);
      if (!look) {
        const Four turned =
            (four(BodyTable::facing_x) * dx + four(BodyTable::facing_y) * dy + four(BodyTable::facing_z) * dz) *
            nearness;
        hidden *= max_of(turned, -turned) + four(BodyTable::round);
      }
      const Four unit = 0.5f * hidden * nearness;
      constant += 0.25f * hidden;
      x += unit * dx;
      y += unit * dy;
      z += unit * dz;
      if (!look) continue;
      // The weight of a ball is its apparent size seen from the receiver's surface.
      const Four gap = max_of(away - receiver.extent, Four{}) + touching * receiver.extent;
      const Four radius = four(BodyTable::radius), weight = select_lanes(seen, radius / gap);
      const float least = count_ < nearest ? worth_a_look : weights_[nearest - 1];
      if (!any(mask(weight > least))) continue;
      for (std::uint32_t k = 0; k < 4; ++k)
        if (weight[k] > least) insert_nearest(slot + k, weight[k]);
    }
  };
  bodies.grid.within(c - reach, c + reach, row);
  return {sum_of(constant), {sum_of(x), sum_of(y), sum_of(z)}};
}

// Loads the bodies of the short list, and subtracts them from the sums.
void Sky::load_nearest(const glm::vec3& centre) {
  for (std::size_t k = 0; k < count_; ++k) {
    const auto of = [&](BodyTable::Column column) { return balls_.of(column)[slots_[k]]; };
    near_[k] = {{of(BodyTable::x), of(BodyTable::y), of(BodyTable::z)}, of(BodyTable::radius)};
    const glm::vec3 d = near_[k].centre - centre;
    const float square = of(BodyTable::square), clear = std::max(glm::dot(d, d), square);
    const float hidden = square / clear;
    far_balls_.constant -= 0.25f * hidden;
    far_balls_.cosine -= d * (0.5f * hidden / std::sqrt(clear));
  }
}

// Converts the receiver's bodies to the coordinates of a frame.
void Sky::set_frame(const SkyFrame& frame) {
  const auto within = [&](const glm::vec3& v) {
    return glm::vec3(glm::dot(frame.side, v), glm::dot(frame.up, v), glm::dot(frame.front, v));
  };
  for (std::size_t k = 0; k < count_; ++k) {
    near_[k].centre = within(near_[k].centre - frame.centre) / frame.scale;
    near_[k].radius /= frame.scale;
  }
  far_balls_.cosine = within(far_balls_.cosine);
  far_specks_.cosine = within(far_specks_.cosine);
}

// The visible share of the sky, 0 … 1, at four points with unit normals: e to the power of minus the hidden light of
// all far bodies, times the share that each near ball leaves (its disc weighted by the cosine).
Four Sky::unoccluded(const Vec3x4& place, const Vec3x4& normal) const {
  const auto hidden_by = [&](const Bands& far) {
    const Four sum = far.cosine.x * normal.x + far.cosine.y * normal.y + far.cosine.z * normal.z + far.constant;
    return max_of(sum, Four{});  // bodies behind a point add no light
  };
  const Four sum = hidden_by(far_balls_) + hidden_by(far_specks_);
  // e^−sum to within a hundredth: sums are hardly ever above 2.
  Four left = 1.0f / (1.0f + sum * (1.0f + sum * (0.5f + sum * (1.0f / 6 + sum * (1.0f / 24)))));
  for (std::size_t k = 0; k < count_; ++k) {
    const Near& ball = near_[k];
    const Four dx = ball.centre.x - place.x, dy = ball.centre.y - place.y, dz = ball.centre.z - place.z;
    const Four ahead = dx * normal.x + dy * normal.y + dz * normal.z;

    // A point within the ball is taken to be at its surface.
    const Four inverse = 1.0f / max_of(square_root(dx * dx + dy * dy + dz * dz), Four{} + 1.001f * ball.radius);
    const Four sine = ball.radius * inverse, cosine = ahead * inverse;
    const Four low = max_of(cosine + sine, Four{});
    left *= 1.0f - sine * (cosine >= sine ? sine * cosine : 0.25f * low * low);
  }
  return left;
}

// Sets the visible share of the sky, 0 … 255, at all points; the receiver must be set.
void Sky::sample(std::span<const float> positions, std::span<const float> normals, std::span<std::uint8_t> sky) const {
  const auto sample_four = [&](std::size_t v0, std::size_t v1, std::size_t v2, std::size_t v3) {
    const auto four = [&](std::span<const float> values, std::size_t axis) {
      return Four{values[3 * v0 + axis], values[3 * v1 + axis], values[3 * v2 + axis], values[3 * v3 + axis]};
    };
    const Four left = unoccluded({four(positions, 0), four(positions, 1), four(positions, 2)},
                                 {four(normals, 0), four(normals, 1), four(normals, 2)});
    const Four bytes = 255.0f * max_of(left, Four{}) + 0.5f;
    sky[v0] = static_cast<std::uint8_t>(bytes[0]);
    sky[v1] = static_cast<std::uint8_t>(bytes[1]);
    sky[v2] = static_cast<std::uint8_t>(bytes[2]);
    sky[v3] = static_cast<std::uint8_t>(bytes[3]);
  };
  for (std::size_t v = 0; v < sky.size(); v += 4) {
    const std::size_t last = sky.size() - 1;
    sample_four(v, std::min(v + 1, last), std::min(v + 2, last), std::min(v + 3, last));
  }
}

}  // namespace panicle
