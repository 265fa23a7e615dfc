#include "models/bunch/paper/paper.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "foundation/mathematics.hpp"
#include "models/bunch/measures/measures.hpp"
#include "models/bunch/paper/growth.hpp"
#include "models/bunch/shape.hpp"
#include "models/bunch/stock.hpp"

namespace panicle::bunch {
namespace {

constexpr float metres_per_millimetre = 0.001f;
constexpr float units_per_pixel = 50.0f / 29.0f;

// Interprets a bunch into the growth, among what stands there already.
Diagnostic grow_stock(const Stock& stock, const Limits& limits, Growth& growth) {
  growth.begin(*stock.bound, stock.seed, stock.first_axis);
  const Diagnostic trouble = interpret(stock, limits, growth);
  return trouble.reason == Reason::none ? growth.trouble() : trouble;
}

// One bunch, or two on one peduncle. The second's rachis is laid first, for it would find no way through the first's
// berries; the berries of both come later, as in nature.
Diagnostic grow_all(const Stock& first, const Stock* second, const Limits& limits, Growth& growth) {
  Diagnostic trouble;
  if (second) {
    growth.begin_laying();
    trouble = grow_stock(*second, limits, growth);
    growth.end_laying();
  }
  if (trouble.reason == Reason::none) trouble = grow_stock(first, limits, growth);
  if (trouble.reason == Reason::none && second) trouble = grow_stock(*second, limits, growth);
  return trouble;
}

void to_metres(std::vector<Internode>& internodes, std::vector<Berry>& berries, float scale) {
  for (Internode& internode : internodes) {
    internode.start *= scale;
    internode.end *= scale;
    internode.radius *= scale;
    internode.radius_end *= scale;
  }
  for (Berry& berry : berries) {
    berry.centre *= scale;
    berry.radius *= scale;
  }
}

}  // namespace

Diagnostic grow_paper(const Request& request, const Values& values, const Limits& limits, Grown& grown) {
  using enum Parameter;
  const Profile profile = values.profile();
  auto shape = shape_for(request, profile, values[fit]);
  if (!shape) return shape.error();

  const auto program = program_for(request, 3, limits);
  if (!program) return program.error();
  const auto first = derive_stock(program.value(), request.seed, inputs_for(shape.value(), values), limits);
  if (!first) return first.error();
  grown.plan = std::move(shape->plan);

  std::optional<Stock> second;
  if (values[wing] > 0) {
    Shape smaller = shape_of(scaled(profile, values[wing]), values[fit]);
    auto stock = derive_stock(program.value(), second_seed(request.seed), inputs_for(smaller, values), limits);
    if (!stock) return stock.error();
    second = std::move(stock.value());
    second->first_axis = grown.plan.m - 1;
    second->lean = values[wing_angle];
    grown.second = std::move(smaller.plan);
  }

  const InteractionOptions interaction{values[delta], static_cast<std::uint32_t>(values[t]), values[sag]};
  Growth growth(interaction, limits, std::max(values[rmin], values[rmax]));
  const Diagnostic trouble = grow_all(first.value(), second ? &*second : nullptr, limits, growth);
  if (trouble.reason != Reason::none) return trouble;

  note_remarks(*program.value(), 3, values, limits, grown.notes);
  if (growth.internodes.empty()) grown.notes.push_back("The grammar drew nothing.");
  if (growth.rachis_cut)
    grown.notes.push_back(
        "The rachis found no room and ends early; smaller berries or thinner internodes leave it more.");
  to_metres(growth.internodes, growth.berries, values[unit] * metres_per_millimetre);
  grown.internodes = std::move(growth.internodes);
  grown.berries = std::move(growth.berries);
  grown.counts.cut = growth.cuts;
  for (const Berry& berry : grown.berries) grown.traits.push_back({2 * berry.radius, 2 * berry.radius});
  if (request.measures) {
    const float pixel = values[unit] * units_per_pixel;
    // An end structure's twig and pedicel, and its berry (L-system 3's rates).
    const float stalk = values[li] * values[rrf] * values[re] * (1 + values[rp]) * sincos_degrees(values[yaw]).sine;
    const float reach = (std::abs(stalk) + values[rmin] + values[rmax]) * values[unit];
    std::vector<HungEnvelope> envelopes{{Envelope(profile, pixel, reach), 0}};
    if (second) envelopes.push_back({Envelope(scaled(profile, values[wing]), pixel, reach), values[wing_angle]});
    grown.measures = measure(grown, envelopes);
  }
  return {};
}

}  // namespace panicle::bunch
