#include "models/bunch/natural/settling/swelling.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "models/bunch/natural/settling/sagging.hpp"
#include "models/bunch/natural/settling/spreading.hpp"
#include "models/bunch/natural/settling/thinning.hpp"
#include "models/bunch/natural/swollen_size.hpp"
#include "spatial/closest_points.hpp"
#include "spatial/sphere_overlaps.hpp"

namespace panicle::bunch {

// A pedicel is the stalk of one flower or berry.

namespace {

// Tuned on the fifteen presets of the paper and 50 random profiles (docs/natural.md has the effect of each).
constexpr float margin = 0.35f;       // of the widest berry: distance up to which neighbours are searched for
constexpr int projections = 2;        // of all constraints in a step
constexpr int settling = 6;           // steps at the largest size before the last thinning, and after; then some dry
constexpr int refresh = 4;            // steps between two searches for neighbours
constexpr float contact_give = 4.0f;  // compliance of two berries' skins: how much they flatten
constexpr float bound_give = 4.0f;    // compliance of the outline: berries may be pushed out a little
constexpr float bound_inset = 0.55f;  // how far inside it centres stay, in half-widths
constexpr float core_inset = 0.8f;    // the same for the core of a long berry, in its half-lengths
constexpr float furthest_out = 1.0f;  // limit beyond that inset, in half-widths
constexpr float straighten = 0.5f;    // share of the way back to where its pedicel hangs, a step: pedicels are springs
constexpr float gravity = 0.012f;     // berry widths that an unsupported berry sinks in a step
constexpr float shortest = 0.6f;      // of a pedicel, from its foot to the seat: it bends
constexpr float max_bent = -0.35f;    // cosine of a pedicel's turn at its foot
constexpr int max_rounds = 64;        // of thinning, if far too many have set
constexpr float thinning_from = 0.72f;  // size from which berries crowd each other out
constexpr int joining = 8;              // steps in which those that join late catch up
constexpr int max_joinings = 5;         // number of batches of late berries
// number that joins over the number that is missing, for some of them will be lost too
constexpr float over_missing = 2.0f;
constexpr float near_enough = 0.98f;  // of the requested number
constexpr float youngest = 0.08f;     // size of a berry that joins
constexpr float rounding = 1.0001f;   // factor for a squared distance: berries farther apart than that cannot touch

// A berry and a stem that it may lean on.
struct BerryStemPair {
  std::uint32_t berry, stem;
};

// The sum of a unit vector and the lean; unit.
glm::vec3 leaning(const glm::vec3& heading, const glm::vec3& lean) {
  const glm::vec3 sum = heading + lean;
  const float length = glm::length(sum);
  return length > 1e-3f ? sum / length : heading;
}

// The place of a stem: its middle, and the vector from its start to its end.
struct StemPlace {
  glm::vec3 middle, axis_vector;
  float length;
};

// The middle, axis and length of a stem between two points.
StemPlace place_of_stem(const glm::vec3& start, const glm::vec3& end) {
  const glm::vec3 axis_vector = end - start;
  return {start + axis_vector * 0.5f, axis_vector, glm::length(axis_vector)};
}

// Moves berries and the ends of branches until all constraints agree, step by step as berries grow. Indices i and j are
// of berries, k of branches; lengths in millimetres.
class Solver {
 public:
  // Begins with very small berries near the feet of their pedicels.
  Solver(std::span<const Branch> branches, std::span<const Swelling> berries, std::span<const BunchEnvelope> bounds)
      : branches_(branches), berries_(berries), bounds_(bounds), sagging_(branches, berries) {
    for (const Branch& branch : branches) ends_.push_back(branch.end);
    for (const Swelling& berry : berries) {
      headings_.push_back(berry.heading);
      centres_.push_back(branches[berry.branch].end + berry.heading * (berry.stalk + berry.half_length * 0.1f));
    }
    for (const Swelling& berry : berries) lost_.push_back(berry.late ? RemovalReason::not_set : RemovalReason{});
    sizes_.resize(berries.size());
    rests_.resize(berries.size());
    for (const BunchEnvelope& bound : bounds) turns_.emplace_back(bound.stance);
    leans_ = spread(branches, berries, sagging_.turned(1));
  }

  // A step of swelling: sets the sizes for `scale`, then corrects the places several times until pedicels, neighbours,
  // stems and outline agree. `index` counts the steps: every `refresh`th one searches for neighbours.
  void step(float scale, int index) {
    ++work_.steps;
    for (std::size_t i = 0; i < sizes_.size(); ++i) sizes_[i] = swollen_size(berries_[i], scale);
    for (const std::uint32_t i : young_)
      sizes_[i] = swollen_size(berries_[i], youngest + (scale - youngest) * young_share_);
    if (index % refresh == 0) find_neighbours();
    std::fill(pushes_.begin(), pushes_.end(), 0.0f);
    std::fill(bound_pushes_.begin(), bound_pushes_.end(), 0.0f);
    turned_ = sagging_.turned(scale);
    move_towards_rest();
    for (int k = 0; k < projections; ++k) {
      hold_branches();
      hold_pedicels();
      part_berries(k % 2 == 1);
      part_stems();
      keep_within();
    }
    if (scale >= thinning_from && young_.empty() && !settled_ && index % refresh == refresh - 1) thin(1);
  }

  // Removes berries until none is pressed harder than berries can be.
  void thin_out() { thin(max_rounds); }

  // Adds late berries in their order while fewer than `wanted` have found room. `index`: of the next step; returns that
  // of the step after the last one here.
  int join(std::size_t wanted, float scale, int index) {
    std::uint32_t next = 0;
    for (int batch = 0; batch < max_joinings; ++batch) {
      const std::size_t remaining = present_count();
      if (static_cast<float>(remaining) >= near_enough * static_cast<float>(wanted)) return index;
      auto places = static_cast<std::size_t>(over_missing * static_cast<float>(wanted - remaining)) + 1;
      for (; next < berries_.size() && places > 0; ++next) {
        if (lost_[next] != RemovalReason::not_set) continue;
        start_late_berry(next);
        --places;
      }
      if (young_.empty()) return index;
      for (int k = 1; k <= joining; ++k) {
        young_share_ = static_cast<float>(k) / joining;
        // Young berries need their neighbours at once: skip to an index at which `step` finds neighbours.
        if (k == 1) index += (refresh - index % refresh) % refresh;
        step(scale, index++);
      }
      thin_out();
      for (; !young_.empty() && present_count() > wanted; young_.pop_back())
        if (!is_lost(young_.back())) lost_[young_.back()] = RemovalReason::not_set;
      remove_lost_pairs();
      young_.clear();
    }
    return index;
  }

  // Removes the berries listed in the request. No other berry is lost after this, so that the others do not depend on
  // the list.
  void take_by_hand() {
    settled_ = true;
    for (std::size_t i = 0; i < berries_.size(); ++i)
      if (berries_[i].taken && !is_lost(i)) lost_[i] = RemovalReason::by_hand;
    remove_lost_pairs();
  }

  // Moves the result out; the solver is of no use afterwards.
  Swollen take() {
    update_headings();
    return {std::move(ends_), std::move(centres_), std::move(headings_), std::move(lost_), work_};
  }

 private:
  // Lets a late berry join, very small, near the foot of its pedicel.
  void start_late_berry(std::uint32_t i) {
    const Swelling& berry = berries_[i];
    lost_[i] = RemovalReason{};
    headings_[i] = berry.heading;
    centres_[i] = ends_[berry.branch] + berry.heading * (berry.stalk * stalk_at(youngest));
    young_.push_back(i);
  }

  // The number of berries that are not lost.
  std::size_t present_count() const {
    return static_cast<std::size_t>(std::count(lost_.begin(), lost_.end(), RemovalReason{}));
  }

  // Whether a berry is lost, or late and has not joined yet.
  bool is_lost(std::size_t i) const { return lost_[i] != RemovalReason{}; }

  // Turns berries away from the feet of their pedicels.
  void update_headings() {
    for (std::size_t i = 0; i < berries_.size(); ++i) {
      const glm::vec3 from_foot = centres_[i] - ends_[berries_[i].branch];
      const float distance = glm::length(from_foot);
      headings_[i] = distance > 1e-4f ? from_foot / distance : berries_[i].heading;
    }
  }

  // The vector from the nearest point of one berry's core to that of another's.
  glm::vec3 between_cores(std::size_t i, std::size_t j) const {
    return between_segments(centres_[j] - centres_[i], {headings_[i], sizes_[i].core}, {headings_[j], sizes_[j].core});
  }

  // Finds the pairs that may meet before the next search: half a margin round every berry and stem. A stem is searched
  // for along all of its length, which beside young berries is many of theirs.
  void find_neighbours() {
    update_headings();
    float widest = 0;
    for (const SwollenSize& size : sizes_) widest = std::max(widest, size.ball + size.core);
    const float half_margin = 0.5f * margin * widest;
    std::vector<Sphere> spheres;
    std::size_t present = 0;
    for (std::size_t i = 0; i < berries_.size(); ++i) {
      spheres.push_back({centres_[i], is_lost(i) ? -1 : sizes_[i].ball + sizes_[i].core + half_margin});
      present += !is_lost(i);
    }
    nearby_.build(spheres);
    pairs_.clear();
    nearby_.pairs(pairs_, max_pairs * present);
    pushes_.resize(pairs_.size());
    bound_pushes_.resize(berries_.size());

    berry_stem_pairs_.clear();
    for (std::uint32_t k = 0; k < branches_.size(); ++k) {
      for (const std::uint32_t i : nearby_.along(start_of(k), ends_[k], branches_[k].radius + half_margin))
        if (berries_[i].branch != k) berry_stem_pairs_.push_back({i, k});
    }
  }

  // Where branch k starts now: at the moved end of its parent.
  glm::vec3 start_of(std::size_t k) const {
    const std::int32_t parent = branches_[k].parent;
    return parent < 0 ? branches_[k].start : ends_[static_cast<std::size_t>(parent)];
  }

  // Moves each berry part of the way to where it would hang at rest, at its drooping and leaning pedicel, and lets it
  // sink a little by its weight.
  void move_towards_rest() {
    for (std::size_t i = 0; i < berries_.size(); ++i) {
      const Swelling& berry = berries_[i];
      const SwollenSize& size = sizes_[i];
      const float heavy = berry.half_width > 0 ? size.half_width / berry.half_width : 0;
      rests_[i] = leaning(drooping(turned_[berry.branch] * berry.heading, heavy), leans_[i] * std::min(1.0f, heavy));
      const glm::vec3 straight = ends_[berry.branch] + rests_[i] * (size.stalk + size.half_length);
      centres_[i] += (straight - centres_[i]) * straighten;
      centres_[i].y -= gravity * 2 * size.half_width;
    }
  }

  // Moves each branch with its parent's end, and its own end back to where it grew.
  void hold_branches() {
    for (std::size_t k = 0; k < branches_.size(); ++k) {
      const Branch& branch = branches_[k];
      const glm::vec3 rest = start_of(k) + turned_[k] * (branch.end - branch.start);
      ends_[k] = rest + (ends_[k] - rest) * branch.give;
    }
  }

  // Moves berries and the ends of their branches so that pedicels keep their length and do not bend back.
  void hold_pedicels() {
    for (std::size_t i = 0; i < berries_.size(); ++i) {
      if (is_lost(i)) continue;
      const Swelling& berry = berries_[i];
      glm::vec3& foot = ends_[berry.branch];
      const glm::vec3 from_foot = centres_[i] - foot;
      const float distance = glm::length(from_foot);
      if (!(distance > 1e-4f)) continue;
      const glm::vec3 heading = from_foot / distance;
      headings_[i] = heading;
      const SwollenSize& size = sizes_[i];
      const float most = size.stalk + size.half_length, least = shortest * size.stalk + size.half_length;
      const float excess = distance > most ? distance - most : distance < least ? distance - least : 0;
      const float give = 0.3f * branches_[berry.branch].give;
      centres_[i] -= heading * (excess * (1 - give));
      foot += heading * (excess * give);
      const float turned = glm::dot(heading, rests_[i]);
      if (turned < max_bent) centres_[i] += rests_[i] * (0.5f * distance * (max_bent - turned));
    }
  }

  // Whether two berries are certainly farther from each other than `reach`, for any direction of their cores.
  bool certainly_apart(std::uint32_t i, std::uint32_t j, float reach) const {
    const glm::vec3 between = centres_[j] - centres_[i];
    const float most = reach + sizes_[i].core + sizes_[j].core;
    return glm::dot(between, between) > rounding * most * most;
  }

  // Pushes overlapping berries apart, each by half of the same distance; pairs in reverse order if `backwards`, so that
  // no berry is preferred.
  // The push of each pair is summed in `pushes_`: a compliant constraint (XPBD), which never pulls.
  void part_berries(bool backwards) {
    const std::size_t count = pairs_.size();
    work_.looks += count;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t at = backwards ? count - 1 - k : k;
      const auto [i, j] = pairs_[at];
      const float reach = sizes_[i].ball + sizes_[j].ball;
      if (pushes_[at] == 0 && certainly_apart(i, j, reach)) continue;
      const glm::vec3 between = between_cores(i, j);
      const float square = glm::dot(between, between);
      if (square >= reach * reach && pushes_[at] == 0) continue;
      ++work_.contacts;
      const float distance = std::sqrt(square);
      const float gap = distance - reach;
      const float push = std::max((-gap - contact_give * pushes_[at]) / (2 + contact_give), -pushes_[at]);
      pushes_[at] += push;
      const glm::vec3 direction = distance > 1e-4f ? between / distance : glm::vec3(0, i < j ? 1 : -1, 0);
      centres_[i] -= direction * push;
      centres_[j] += direction * push;
    }
  }

  // `berry_stem_pairs_` lists the berries of one stem after another: the values computed for a stem serve all its
  // berries, until one of them pushes its end.
  void part_stems() {
    work_.looks += berry_stem_pairs_.size();
    for (std::size_t at = 0; at < berry_stem_pairs_.size();) {
      const std::uint32_t k = berry_stem_pairs_[at].stem;
      const glm::vec3 start = start_of(k);
      StemPlace stem = place_of_stem(start, ends_[k]);
      for (; at < berry_stem_pairs_.size() && berry_stem_pairs_[at].stem == k; ++at)
        if (part_from_stem(berry_stem_pairs_[at].berry, k, stem)) stem = place_of_stem(start, ends_[k]);
    }
  }

  // Moves a berry and a stem apart; returns whether they touched.
  bool part_from_stem(std::uint32_t i, std::uint32_t k, const StemPlace& stem) {
    const SwollenSize& size = sizes_[i];
    const float reach = size.ball + branches_[k].radius, most = reach + size.core + stem.length / 2;
    const glm::vec3 between = stem.middle - centres_[i];
    if (glm::dot(between, between) > rounding * most * most || is_lost(i) || !(stem.length > 1e-4f)) return false;
    const auto [s, t] = closest_points(between, {headings_[i], size.core},
                                       {stem.axis_vector / stem.length, stem.length / 2}, parallel_cores);
    const glm::vec3 to_stem = between + stem.axis_vector * (t / stem.length) - headings_[i] * s;
    const float square = glm::dot(to_stem, to_stem);
    if (square >= reach * reach || !(square > 1e-8f)) return false;
    ++work_.contacts;
    const float distance = std::sqrt(square);
    const float give = 0.5f * branches_[k].give;
    const glm::vec3 push = to_stem * ((reach - distance) / distance);
    centres_[i] -= push * (1 - give);
    ends_[k] += push * give;
    return true;
  }

  // Pushes berries back into the outline of their bunch, with some give; the distance is added to `bound_pushes_`.
  void keep_within() {
    for (std::size_t i = 0; i < berries_.size(); ++i) {
      if (is_lost(i)) continue;
      const BunchEnvelope& bound = bounds_[berries_[i].bunch];
      const UprightTransform& turn = turns_[berries_[i].bunch];
      glm::vec3 c = turn.place(centres_[i]);
      const glm::vec3 before = c;
      // A long berry's extent depends on the direction of its core.
      const SwollenSize& size = sizes_[i];
      const float upright = headings_[i].y * headings_[i].y, inset = bound_inset * size.half_width;
      const float lying = inset + core_inset * size.core * (1 - upright);
      const float standing = inset + core_inset * size.core * upright, length = bound.envelope.length();
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
      glm::vec3 correction = c - before;
      const float distance = glm::length(correction);
      if (!(distance > 1e-5f)) continue;
      const float push = std::max({0.0f, (distance - bound_give * bound_pushes_[i]) / (1 + bound_give),
                                   distance - furthest_out * size.half_width});
      bound_pushes_[i] += push;
      correction *= push / distance;
      centres_[i] += turn.way_back(correction);
    }
  }

  // The pairs of berries that press on each other, with their depths: valid until a berry moves.
  std::vector<PressedPair> pressed_pairs() {
    std::vector<PressedPair> pressed_pairs;
    pressed_pairs.reserve(pairs_.size());
    work_.thinning_looks += pairs_.size();
    for (const auto [i, j] : pairs_) {
      if (is_lost(i) || is_lost(j)) continue;
      const float deep = (sizes_[i].ball + sizes_[j].ball - glm::length(between_cores(i, j))) / 2;
      pressed_pairs.push_back({i, j, deep});
    }
    return pressed_pairs;
  }

  // Removes the most pressed berries, up to so many rounds.
  void thin(int rounds) {
    std::vector<PressedPair> pressing = pressed_pairs();
    for (int round = 0; round < rounds; ++round) {
      const std::vector<std::uint32_t> lost = crowded_out(pressing, sizes_);
      if (lost.empty()) break;
      for (const std::uint32_t i : lost) lost_[i] = RemovalReason::no_room;
      std::erase_if(pressing, [&](const PressedPair& press) { return is_lost(press.a) || is_lost(press.b); });
    }
    remove_lost_pairs();
  }

  // Removes pairs of which one berry is lost.
  void remove_lost_pairs() {
    pairs_.erase(
        std::remove_if(pairs_.begin(), pairs_.end(), [&](const SpherePair& p) { return is_lost(p.a) || is_lost(p.b); }),
        pairs_.end());
    pushes_.resize(pairs_.size());
  }

  std::span<const Branch> branches_;
  std::span<const Swelling> berries_;
  std::span<const BunchEnvelope> bounds_;
  std::vector<glm::vec3> ends_, centres_, headings_, rests_, leans_;
  Sagging sagging_;
  std::span<const glm::quat> turned_;  // the branches, at this step
  std::vector<SwollenSize> sizes_;     // of the berries, at this step
  std::vector<std::uint32_t> young_;   // those that are catching up
  float young_share_ = 1;              // their age among the others, 0 … 1
  std::vector<RemovalReason> lost_;
  bool settled_ = false;
  std::vector<UprightTransform> turns_;
  SphereOverlapQuery nearby_;
  std::vector<SpherePair> pairs_;                // berries that may touch
  std::vector<BerryStemPair> berry_stem_pairs_;  // by stem
  std::vector<float> pushes_, bound_pushes_;
  SwellingWork work_;
};

}  // namespace

// A pedicel's length over its ripe one, while berries are `size` times as wide as ripe ones.
float stalk_at(float size) { return 0.55f + 0.45f * std::min(1.0f, size / 0.6f); }

// Swells the berries through all sizes in `scales` (over the ripe one). At the largest, crowded berries are removed,
// late ones join until `wanted` have room, and those removed by hand go; the last steps only settle.
Swollen swell(std::span<const Branch> branches, std::span<const Swelling> berries,
              std::span<const BunchEnvelope> bounds, std::span<const float> scales, std::size_t wanted) {
  Solver solver(branches, berries, bounds);
  // Berries that dry afterwards are largest before the last step.
  const auto largest = std::max_element(scales.begin(), scales.end());
  int index = 0;
  for (auto scale = scales.begin(); scale != scales.end(); ++scale) {
    solver.step(*scale, index++);
    if (scale != largest) continue;
    // After these steps no berry is lost or added any more.
    const bool crowded = *scale >= thinning_from;
    if (crowded) solver.thin_out();
    if (crowded && wanted > 0) index = solver.join(wanted, *scale, index);
    for (int k = 0; k < settling; ++k) solver.step(*scale, index++);
    if (crowded) solver.thin_out();
    solver.take_by_hand();
    for (int k = 0; k < settling; ++k) solver.step(*scale, index++);
  }
  return solver.take();
}

}  // namespace panicle::bunch
