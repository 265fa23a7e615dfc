#include "models/bunch/natural/swelling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "environment/point_grid.hpp"
#include "foundation/mathematics.hpp"
#include "geometry/closest.hpp"

namespace panicle::bunch {
namespace {

// Tuned on the fifteen presets of the paper and 50 random profiles (docs/natural.md has what each does).
constexpr int projections = 2;        // of all constraints in a step
constexpr int settling = 12;          // steps at the last size
constexpr int refresh = 4;            // steps between two searches for neighbours
constexpr float contact_give = 3.0f;  // compliance of two berries' skins: how much they flatten
constexpr float bound_give = 4.0f;    // of the outline: berries may be pushed out a little
constexpr float bound_inset = 0.55f;  // how far inside it centres stay, in half-widths
constexpr float core_inset = 0.8f;    // the same for the core of a long berry, in half-lengths of it
constexpr float furthest_out = 1.0f;  // beyond that inset, in half-widths, and no further
constexpr float gravity = 0.012f;     // berry widths that an unsupported berry sinks in a step
constexpr float straighten = 0.4f;    // share of the way back to where its pedicel points, a step: pedicels are springs
constexpr float shortest = 0.6f;      // of a pedicel, from its foot to the seat: it bends
constexpr float most_bent = -0.35f;   // cosine of a pedicel's turn at its foot
constexpr float most_pressed = 0.3f;  // of a berry's volume, by caps beyond its contacts: more and it is lost
constexpr std::size_t most_pairs = 64;  // neighbours of a berry, on average, that are looked at
constexpr int most_rounds = 64;         // of thinning, where far too many have set
constexpr float parallel = 1e-5f;       // square of a sine: cores at less do not cross
constexpr float thinning_from = 0.72f;  // size at which berries first press each other off

struct Pair {
  std::uint32_t i, j;
};

class Solver {
 public:
  Solver(std::span<const Branch> branches, std::span<const Swelling> berries, std::span<const Bound> bounds)
      : branches_(branches), berries_(berries), bounds_(bounds) {
    for (const Branch& branch : branches) ends_.push_back(branch.end);
    for (const Swelling& berry : berries) {
      headings_.push_back(berry.heading);
      centres_.push_back(branches[berry.branch].end + berry.heading * (berry.stalk + berry.half_length * 0.1f));
    }
    lost_.resize(berries.size());
    for (const Bound& bound : bounds) {
      const SinCos lean = sincos_degrees(bound.lean);
      turns_.push_back(lean);
    }
  }

  void step(float scale, int index) {
    scale_ = scale;
    if (index % refresh == 0) find_neighbours();
    std::fill(pushes_.begin(), pushes_.end(), 0.0f);
    std::fill(bound_pushes_.begin(), bound_pushes_.end(), 0.0f);
    sink();
    for (int k = 0; k < projections; ++k) {
      hold_branches();
      hold_pedicels();
      part_berries(k % 2 == 1);
      part_stems();
      keep_within();
    }
    if (scale >= thinning_from && index % refresh == refresh - 1) thin();
  }

  // Until nobody is pressed harder than berries can be.
  void thin_out() {
    for (int round = 0; round < most_rounds && thin(); ++round) continue;
  }

  void take_by_hand() {
    for (std::size_t i = 0; i < berries_.size(); ++i)
      if (berries_[i].taken && !gone(i)) lost_[i] = Why::by_hand;
    drop_pairs();
  }

  Swollen take() {
    aim();
    return {std::move(ends_), std::move(centres_), std::move(headings_), std::move(lost_)};
  }

 private:
  bool gone(std::size_t i) const { return lost_[i] != Why{}; }
  float half_width(std::size_t i) const { return berries_[i].half_width * scale_; }
  float half_length(std::size_t i) const { return berries_[i].half_length * scale_; }
  // A berry longer than wide is a ball swept along its core, as far from the centre as this.
  float core(std::size_t i) const { return std::max(0.0f, half_length(i) - half_width(i)); }
  float ball(std::size_t i) const {
    const float a = half_width(i), b = half_length(i);
    return b >= a ? a : (2 * a + b) / 3;
  }

  float stalk(std::size_t i) const { return berries_[i].stalk * stalk_at(scale_); }

  // Berries point away from where their pedicels grow.
  void aim() {
    for (std::size_t i = 0; i < berries_.size(); ++i) {
      const glm::vec3 way = centres_[i] - ends_[berries_[i].branch];
      const float far = glm::length(way);
      headings_[i] = far > 1e-4f ? way / far : berries_[i].heading;
    }
  }

  // From the nearest point of one berry's core to that of another's.
  glm::vec3 between_cores(std::size_t i, std::size_t j) const {
    const glm::vec3 between = centres_[j] - centres_[i];
    const float p = core(i), q = core(j);
    if (!(p + q > 0)) return between;
    const auto [s, t] = closest_points(between, {headings_[i], p}, {headings_[j], q}, parallel);
    return between + headings_[j] * t - headings_[i] * s;
  }

  void find_neighbours() {
    aim();
    float widest = 0;
    for (std::size_t i = 0; i < berries_.size(); ++i) widest = std::max(widest, ball(i) + core(i));
    const float margin = 0.35f * widest;
    alive_.clear();
    points_.clear();
    for (std::uint32_t i = 0; i < berries_.size(); ++i) {
      if (gone(i)) continue;
      alive_.push_back(i);
      points_.push_back(centres_[i]);
    }
    const PointGrid grid(points_, 2 * widest + margin);
    pairs_.clear();
    for (std::uint32_t at = 0; at < alive_.size(); ++at) {
      const std::uint32_t i = alive_[at];
      grid.visit(points_[at], [&](std::uint32_t other) {
        const std::uint32_t j = alive_[other];
        if (j <= i || pairs_.size() >= most_pairs * alive_.size()) return;
        const float near = ball(i) + core(i) + ball(j) + core(j) + margin;
        const glm::vec3 between = points_[other] - points_[at];
        if (glm::dot(between, between) < near * near) pairs_.push_back({i, j});
      });
    }
    pushes_.resize(pairs_.size());
    bound_pushes_.resize(berries_.size());

    touching_.clear();
    for (std::uint32_t k = 0; k < branches_.size(); ++k) {
      const glm::vec3 start = start_of(k), along = ends_[k] - start;
      const float half = glm::length(along) / 2;
      grid.visit(start + along * 0.5f, [&](std::uint32_t other) {
        const std::uint32_t i = alive_[other];
        if (berries_[i].branch == k) return;
        const float near = ball(i) + core(i) + half + branches_[k].radius + margin;
        const glm::vec3 between = points_[other] - (start + along * 0.5f);
        if (glm::dot(between, between) < near * near) touching_.push_back({i, k});
      });
    }
  }

  glm::vec3 start_of(std::size_t k) const {
    const std::int32_t parent = branches_[k].parent;
    return parent < 0 ? branches_[k].start : ends_[static_cast<std::size_t>(parent)];
  }

  void sink() {
    for (std::size_t i = 0; i < berries_.size(); ++i) {
      const Swelling& berry = berries_[i];
      const glm::vec3 straight = ends_[berry.branch] + berry.heading * (stalk(i) + half_length(i));
      centres_[i] += (straight - centres_[i]) * straighten;
      centres_[i].y -= gravity * 2 * half_width(i);
    }
  }

  // A branch goes where its parent's end goes, and its own end comes back to where it grew.
  void hold_branches() {
    for (std::size_t k = 0; k < branches_.size(); ++k) {
      const Branch& branch = branches_[k];
      const glm::vec3 rest = start_of(k) + (branch.end - branch.start);
      ends_[k] = rest + (ends_[k] - rest) * branch.give;
    }
  }

  void hold_pedicels() {
    for (std::size_t i = 0; i < berries_.size(); ++i) {
      if (gone(i)) continue;
      const Swelling& berry = berries_[i];
      glm::vec3& foot = ends_[berry.branch];
      const glm::vec3 way = centres_[i] - foot;
      const float far = glm::length(way);
      if (!(far > 1e-4f)) continue;
      const glm::vec3 heading = way / far;
      headings_[i] = heading;
      const float most = stalk(i) + half_length(i), least = shortest * stalk(i) + half_length(i);
      const float off = far > most ? far - most : far < least ? far - least : 0;
      const float give = 0.3f * branches_[berry.branch].give;
      centres_[i] -= heading * (off * (1 - give));
      foot += heading * (off * give);
      const float turned = glm::dot(heading, berry.heading);
      if (turned < most_bent) centres_[i] += berry.heading * (0.5f * far * (most_bent - turned));
    }
  }

  void part_berries(bool backwards) {
    const std::size_t count = pairs_.size();
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t at = backwards ? count - 1 - k : k;
      const auto [i, j] = pairs_[at];
      const glm::vec3 between = between_cores(i, j);
      const float reach = ball(i) + ball(j);
      const float square = glm::dot(between, between);
      if (square >= reach * reach && pushes_[at] == 0) continue;
      const float far = std::sqrt(square);
      const float gap = far - reach;
      const float push = std::max((-gap - contact_give * pushes_[at]) / (2 + contact_give), -pushes_[at]);
      pushes_[at] += push;
      const glm::vec3 way = far > 1e-4f ? between / far : glm::vec3(0, i < j ? 1 : -1, 0);
      centres_[i] -= way * push;
      centres_[j] += way * push;
    }
  }

  void part_stems() {
    for (const auto [i, k] : touching_) {
      if (gone(i)) continue;
      const glm::vec3 start = start_of(k), along = ends_[k] - start;
      const float length = glm::length(along);
      if (!(length > 1e-4f)) continue;
      const glm::vec3 between = start + along * 0.5f - centres_[i];
      const auto [s, t] = closest_points(between, {headings_[i], core(i)}, {along / length, length / 2}, parallel);
      const glm::vec3 way = between + along * (t / length) - headings_[i] * s;
      const float reach = ball(i) + branches_[k].radius;
      const float square = glm::dot(way, way);
      if (square >= reach * reach || !(square > 1e-8f)) continue;
      const float far = std::sqrt(square);
      const float give = 0.5f * branches_[k].give;
      const glm::vec3 push = way * ((reach - far) / far);
      centres_[i] -= push * (1 - give);
      ends_[k] += push * give;
    }
  }

  void keep_within() {
    for (std::size_t i = 0; i < berries_.size(); ++i) {
      if (gone(i)) continue;
      const Bound& bound = bounds_[berries_[i].bunch];
      const SinCos lean = turns_[berries_[i].bunch];
      glm::vec3 c = centres_[i];
      c = {c.x * lean.cosine - c.y * lean.sine, c.x * lean.sine + c.y * lean.cosine, c.z};
      const glm::vec3 before = c;
      // A long berry reaches as far as its core leans.
      const float upright = headings_[i].y * headings_[i].y, inset = bound_inset * half_width(i);
      const float lying = inset + core_inset * core(i) * (1 - upright);
      const float standing = inset + core_inset * core(i) * upright, length = bound.envelope.length();
      const float depth = std::clamp(-c.y, standing, std::max(standing, length - standing));
      c.y = -depth;
      const float x = std::max(0.005f * length, bound.envelope.half_width(c.x >= 0 ? 0 : 1, depth) - lying);
      const float z = std::max(0.005f * length, bound.envelope.half_width(c.z >= 0 ? 2 : 3, depth) - lying);
      const float out = (c.x / x) * (c.x / x) + (c.z / z) * (c.z / z);
      if (out > 1) {
        const float back = 1 / std::sqrt(out);
        c.x *= back;
        c.z *= back;
      }
      glm::vec3 way = c - before;
      const float off = glm::length(way);
      if (!(off > 1e-5f)) continue;
      const float push = std::max(
          {0.0f, (off - bound_give * bound_pushes_[i]) / (1 + bound_give), off - furthest_out * half_width(i)});
      bound_pushes_[i] += push;
      way *= push / off;
      centres_[i] +=
          glm::vec3{way.x * lean.cosine + way.y * lean.sine, -way.x * lean.sine + way.y * lean.cosine, way.z};
    }
  }

  // Of what each berry would have to give up to its neighbours, as a share of its volume; the ball's cap is the
  // measure.
  bool thin() {
    pressed_.assign(berries_.size(), 0);
    for (const auto [i, j] : pairs_) {
      if (gone(i) || gone(j)) continue;
      const glm::vec3 between = between_cores(i, j);
      const float deep = (ball(i) + ball(j) - glm::length(between)) / 2;
      if (deep <= 0) continue;
      const auto cap = [deep](float r, float c) {
        const float h = std::min(deep, r);
        return h * h * (3 * r - h) / (4 * r * r * r + 6 * r * r * c);
      };
      pressed_[i] += cap(ball(i), core(i));
      pressed_[j] += cap(ball(j), core(j));
    }
    // The most pressed of a neighbourhood goes; its neighbours then have room.
    keeps_.assign(berries_.size(), 0);
    for (const auto [i, j] : pairs_) {
      if (gone(i) || gone(j)) continue;
      (pressed_[i] > pressed_[j] ? keeps_[j] : keeps_[i]) = 1;
    }
    bool any = false;
    for (std::size_t i = 0; i < berries_.size(); ++i)
      if (!gone(i) && pressed_[i] > most_pressed && !keeps_[i]) {
        lost_[i] = Why::no_room;
        any = true;
      }
    if (any) drop_pairs();
    return any;
  }

  void drop_pairs() {
    pairs_.erase(std::remove_if(pairs_.begin(), pairs_.end(), [&](const Pair& p) { return gone(p.i) || gone(p.j); }),
                 pairs_.end());
    pushes_.resize(pairs_.size());
  }

  std::span<const Branch> branches_;
  std::span<const Swelling> berries_;
  std::span<const Bound> bounds_;
  float scale_ = 0;
  std::vector<glm::vec3> ends_, centres_, headings_, points_;
  std::vector<Why> lost_;
  std::vector<SinCos> turns_;
  std::vector<std::uint32_t> alive_;
  std::vector<Pair> pairs_;     // berries that may touch
  std::vector<Pair> touching_;  // berry and branch that may
  std::vector<float> pushes_, bound_pushes_, pressed_;
  std::vector<std::uint8_t> keeps_;
};

}  // namespace

float stalk_at(float size) { return 0.55f + 0.45f * std::min(1.0f, size / 0.6f); }

Swollen swell(std::span<const Branch> branches, std::span<const Swelling> berries, std::span<const Bound> bounds,
              std::span<const float> scales) {
  Solver solver(branches, berries, bounds);
  int index = 0;
  for (const float scale : scales) solver.step(scale, index++);
  if (!scales.empty() && scales.back() >= thinning_from) solver.thin_out();
  solver.take_by_hand();
  for (int k = 0; k < settling && !scales.empty(); ++k) solver.step(scales.back(), index++);
  return solver.take();
}

}  // namespace panicle::bunch
