#include "models/bunch/measures/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "foundation/mathematics.hpp"
#include "models/bunch/measures/images/measures_compactness.hpp"
#include "models/bunch/measures/images/measures_visibility.hpp"
#include "models/bunch/measures/measures.generated.hpp"
#include "models/bunch/measures/measures_fit.hpp"
#include "models/bunch/measures/measures_form.hpp"
#include "plant/measures.hpp"

namespace panicle::bunch {

// A pedicel is the stalk of one flower or berry.

namespace {

constexpr float to_cubic_centimetres = 1e-3f;  // from mm³
constexpr float berry_density = 1.08f;         // g/cm³, ripe
constexpr float stem_density = 1.0f;

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

using Table = Measures<Measure>;

// A part over the whole; NaN, which means no measure, if the whole is 0.
float ratio(float part, float whole) { return whole > 0 ? part / whole : nothing; }

// Adds the measures of the fit to the outline: shares of both views together and of each. Without an outline the hull's
// volume alone.
void add_fit(Table& table, const Fitted& fitted) {
  const auto& [front, side, hull] = fitted;
  using enum Measure;
  if (front.outline + side.outline > 0) {
    table[coverage] = ratio(front.covered + side.covered, front.outline + side.outline);
    table[coverage_front] = ratio(front.covered, front.outline);
    table[coverage_side] = ratio(side.covered, side.outline);
    table[spill] = ratio(front.spilled + side.spilled, front.silhouette + side.silhouette);
    table[spill_front] = ratio(front.spilled, front.silhouette);
    table[spill_side] = ratio(side.spilled, side.silhouette);
  }
  table[hull_volume] = hull * to_cubic_centimetres;
}

// The volume of stems as frustums of cones.
float stem_volume(const std::vector<Segment>& stems) {
  float sum = 0;
  for (const Segment& stem : stems) {
    const glm::vec3 d = stem.end - stem.start;
    const float length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    const float a = stem.radius, b = stem.radius_end;
    sum += pi / 3 * length * (a * a + a * b + b * b);
  }
  return sum;
}

// Adds the measures of the bunch's and the berries' sizes and shapes.
void add_sizes(Table& table, const Subject& subject, const GrownBunch& grown) {
  using enum Measure;
  const BunchForm form = bunch_form(subject);
  table[bunch_length] = form.length;
  table[bunch_width] = form.width;
  table[bunch_shape] = form.shape;
  // Whether it is a natural bunch with a second one beside it.
  const bool second = grown.second_root >= 0 && std::count(subject.first.begin(), subject.first.end(), 0) > 0;
  table[wings] = form.wings + (second ? 1.0f : 0.0f);
  const BerryMeans means = berry_means(subject);
  table[diameter] = means.diameter;
  table[diameter_spread] = means.spread;
  table[berry_length] = means.length;
  table[berry_width] = means.width;
  table[uniformity] = uniformity_note(means.spread);
  table[berry_shape] = berry_shape_note(grown.form, means.length / means.width);
  table[pedicel_length] = means.pedicel;
}

// Adds volumes and weights, in cm³ and g. Reads `hull_volume` and `bunch_length`, which add_fit and add_sizes have set.
void add_weights(Table& table, const Subject& subject) {
  using enum Measure;
  float volume = 0;
  for (const float one : subject.volumes) volume += one;
  volume *= to_cubic_centimetres;
  const float weight = berry_density * volume;
  table[berry_volume] = volume;
  table[berry_weight] = weight / static_cast<float>(subject.berries.size());
  table[bunch_weight] = weight + stem_density * stem_volume(subject.stems) * to_cubic_centimetres;
  table[fill_ratio] = ratio(volume, table[hull_volume]);
  const float centimetres = table[bunch_length] / 10;
  table[compactness] = ratio(table[bunch_weight], centimetres * centimetres);
}

// Adds how visible and how close together the berries are.
void add_closeness(Table& table, const Subject& subject) {
  using enum Measure;
  const Visibility seen = visibility(subject);
  table[visible_front] = seen.front;
  table[visible_side] = seen.side;
  table[visible_mean] = seen.mean;
  const bool pedicels = !subject.pedicels.empty();
  if (pedicels) table[pedicels_seen] = seen.pedicels;
  const Compactness close = measure_compactness(subject);
  table[gap] = close.gap;
  table[contacts] = close.contacts;
  table[density] = density_note(subject, close, pedicels ? seen.pedicels : 0);
}

}  // namespace

// All measures of a bunch, in the order of the table; NaN for those that do not apply.
std::vector<float> measure(const GrownBunch& grown, std::span<const HungEnvelope> envelopes) {
  using enum Measure;
  Table table(measure_count);
  const Subject subject(grown);
  table[berry_count] = static_cast<float>(grown.berries.size());
  if (!grown.internodes.empty()) table[peduncle_length] = length_of_peduncle(grown);
  if (!envelopes.empty()) {
    table[outline_volume] = 0;
    for (const HungEnvelope& hung : envelopes) table[outline_volume] += hung.envelope.volume() * to_cubic_centimetres;
  }
  Fitted fitted;
  if (!fit(subject, envelopes, fitted)) return table.take();
  add_fit(table, fitted);
  add_sizes(table, subject, grown);
  add_weights(table, subject);
  add_closeness(table, subject);
  return table.take();
}

}  // namespace panicle::bunch
